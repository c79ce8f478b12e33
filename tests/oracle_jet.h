/* SPDX-License-Identifier: MIT
 *
 * Dual numbers of the oracle of recipes: a value with its derivatives, and what functions of
 * recipes make of them. Header only.
 */
#ifndef SCARP_TESTS_ORACLE_JET_H
#define SCARP_TESTS_ORACLE_JET_H

#include "oracle_recipe.h"

typedef struct oracle_jet jet;

/* Where an expression looks: jets of coordinates by the points'. */
struct place {
    jet u[3];
    int dimensions;
};

static inline jet constant(double value)
{
    const jet j = {.value = value};
    return j;
}

/* f(a), given f and its derivatives */
static inline jet apply(jet a, double f, double fa, double faa)
{
    jet r = {.value = f};
    for (int i = 0; i < 3; i++) {
        r.first[i] = fa * a.first[i];
        for (int j = 0; j < 3; j++) {
            r.second[i][j] = fa * a.second[i][j] + faa * a.first[i] * a.first[j];
        }
    }
    return r;
}

static inline jet add(jet a, jet b, double scale)
{
    a.value += scale * b.value;
    for (int i = 0; i < 3; i++) {
        a.first[i] += scale * b.first[i];
        for (int j = 0; j < 3; j++) {
            a.second[i][j] += scale * b.second[i][j];
        }
    }
    return a;
}

static inline jet multiply(jet a, jet b)
{
    jet r = {.value = a.value * b.value};
    for (int i = 0; i < 3; i++) {
        r.first[i] = a.value * b.first[i] + b.value * a.first[i];
        for (int j = 0; j < 3; j++) {
            r.second[i][j] = a.value * b.second[i][j] + b.value * a.second[i][j] +
                             a.first[i] * b.first[j] + a.first[j] * b.first[i];
        }
    }
    return r;
}

static inline jet scaled(jet a, double scale)
{
    return multiply(a, constant(scale));
}

static inline jet smooth_step(jet a, double lo, double hi)
{
    const double width = hi - lo, t = (a.value - lo) / width;
    if (t <= 0.0 || t >= 1.0) {
        return constant(t <= 0.0 ? 0.0 : 1.0);
    }
    return apply(a, t * t * t * (t * (6.0 * t - 15.0) + 10.0),
                 30.0 * t * t * (1.0 - t) * (1.0 - t) / width,
                 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t) / (width * width));
}

static inline jet mix(jet a, jet b, jet m)
{
    return add(a, multiply(m, add(b, a, -1.0)), 1.0);
}

static inline jet least(jet a, jet b, double k, double sign)
{
    const int second = sign * b.value < sign * a.value;
    const jet chosen = second ? b : a;
    const double h = k > 0.0 ? 1.0 - fabs(a.value - b.value) / k : 0.0;
    if (h <= 0.0) {
        return chosen;
    }
    /* h^3 k / 6 of the difference d, with dh = -1/k d|d| */
    const jet d = add(a, b, -1.0);
    const double side = d.value < 0.0 ? -1.0 : 1.0;
    const jet bulge = apply(d, h * h * h * k / 6.0, -side * h * h / 2.0, h / k);
    return add(chosen, bulge, -sign);
}

static inline jet terraced(jet a, double steps, double riser, double strength)
{
    const double t = steps * a.value, whole = floor(t), u = t - whole;
    const double w = (u - 0.5) / riser + 0.5;
    jet inner = {.value = w, .first = {1.0, 0.0, 0.0}}; /* by u, scaled */
    inner.first[0] = 1.0 / riser;
    const jet s = smooth_step(inner, 0.0, 1.0);
    const double f = (whole + u + strength * (s.value - u)) / steps;
    const double fa = 1.0 + strength * (s.first[0] - 1.0);
    return apply(a, f, fa, strength * s.second[0][0] * steps);
}

/* f with respect to coordinates u, and these to x */
static inline jet composed(jet f, const struct place *at)
{
    jet r = {.value = f.value};
    for (int k = 0; k < at->dimensions; k++) {
        const jet *const u = &at->u[k];
        for (int i = 0; i < 3; i++) {
            r.first[i] += f.first[k] * u->first[i];
            for (int j = 0; j < 3; j++) {
                r.second[i][j] += f.first[k] * u->second[i][j];
                for (int l = 0; l < at->dimensions; l++) {
                    r.second[i][j] += f.second[k][l] * u->first[i] * at->u[l].first[j];
                }
            }
        }
    }
    return r;
}

/* Coordinates that are their own: derivatives are by u. */
static inline struct place own(const struct place *at)
{
    struct place p = {.dimensions = at->dimensions};
    for (int i = 0; i < p.dimensions; i++) {
        p.u[i].value = at->u[i].value;
        p.u[i].first[i] = 1.0;
    }
    return p;
}

#endif
