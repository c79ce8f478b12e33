/* SPDX-License-Identifier: MIT
 *
 * The interval of hybrid noise, which its amplitudes and its range are made of.
 */
#include "hybrid.h"

static double least(double a, double b)
{
    return a < b ? a : b;
}

static double most(double a, double b)
{
    return a > b ? a : b;
}

static struct scarp_interval product(struct scarp_interval a, struct scarp_interval b)
{
    const double ll = a.lowest * b.lowest, lh = a.lowest * b.highest;
    const double hl = a.highest * b.lowest, hh = a.highest * b.highest;
    const struct scarp_interval p = {least(least(ll, lh), least(hl, hh)),
                                     most(most(ll, lh), most(hl, hh))};
    return p;
}

struct scarp_interval scarpi_hybrid_interval(double sharpness, double gain, double octaves,
                                             double reach)
{
    struct scarp_interval weight = {1.0, 1.0}, sum = {0.0, 0.0};
    double share = 1.0;
    for (int k = 0; (double)k < octaves; k++) {
        const double part = least(octaves - (double)k, 1.0);
        const struct scarp_interval n = {share * (sharpness - reach), share * (sharpness + reach)};
        const struct scarp_interval t = product(weight, n);
        const double room = SCARP_HYBRID_ROUNDING * most(t.lowest, 0.0 - t.lowest);
        sum.lowest += part * (t.lowest - room);
        sum.highest += part * t.highest;
        weight.lowest = most(least(t.lowest, 1.0), -1.0);
        weight.highest = least(t.highest, 1.0);
        share *= gain;
    }
    return sum;
}

struct scarp_interval scarpi_hybrid_range(double sharpness, double gain, const double octaves[2],
                                          double reach)
{
    const double unit = scarpi_hybrid_interval(sharpness, gain, octaves[1], 1.0).highest;
    const double some = scarpi_hybrid_interval(sharpness, gain, octaves[0], reach).lowest;
    const double all = scarpi_hybrid_interval(sharpness, gain, octaves[1], reach).lowest;
    const double highest = scarpi_hybrid_interval(sharpness, gain, octaves[1], reach).highest;
    const struct scarp_interval range = {least(some, all) * SCARP_HYBRID_HEADROOM / unit,
                                         highest / unit};
    return range;
}
