/* SPDX-License-Identifier: MIT
 *
 * Computes cosines and sines of the phase in double arithmetic, in one fixed order and without
 * libm, so that every platform has the same. tests/test_phase_turn.c compares them with libm's.
 */
#include "phase.h"

/*
 * The suprema of gradient noise over all phases, by [dimensions - 2][fade]. In 2D every corner may
 * have any unit vector: the maximum over t of sum_c W_c(t) |t - c| is sqrt(1/2), in the middle of a
 * cell, and some phases reach it. In 3D it is the maximum over t and the phase of sum_c W_c(t)
 * max_g g . (t - c), g being the twelve gradients at that phase, twice as long as improved noise's:
 * at (.564166, .5, .5) and -.217737 turns (quintic), (.579958, .5, .5) and -.218007 turns (cubic),
 * and what is symmetric to these. tests/test_phase_range.c proves the numbers by branch and bound.
 */
static const double suprema[2][2] = {
    {[SCARP_QUINTIC] = 0.70710678118654757, [SCARP_CUBIC] = 0.70710678118654757},
    {[SCARP_QUINTIC] = 2.0 * 1.1504169386, [SCARP_CUBIC] = 2.0 * 1.1532774969},
};

double scarpi_phase_supremum(enum scarp_fade fade, int dimensions)
{
    return suprema[dimensions - 2][fade];
}

/* What is smaller becomes 0, so that no product is a subnormal number. */
#define TURN_MIN 0x1p-60

/* The fraction of |a|; floats of 2^23 and more have none. The magnitude is taken first, since the
   fraction of a small negative number, 1 less a little, has no exact double. */
static double fraction(double a)
{
    const double magnitude = a < 0.0 ? -a : a;
    return magnitude >= 0x1p23 ? 0.0 : magnitude - (double)(int32_t)magnitude;
}

/* The fraction of 2 t, for t in [0, 1). */
static double doubled(double t)
{
    return t + t >= 1.0 ? t + t - 1.0 : t + t;
}

/*
 * The cosine and the sine of t turns, t in [0, 1), within 2^-52. They are exact at quarters and
 * have one magnitude at odd eighths. What is left of t when the nearest quarter is taken away is
 * exact; of its angle r, |r| <= pi / 4, the series of Taylor are evaluated up to r^15 and r^16.
 */
static void turn_of(double t, double *cosine, double *sine)
{
    const double tau_high = 0x1.921fb54442d18p+2, tau_low = 0x1.1a62633145c07p-52;
    const int quarter = (t >= 0.125) + (t >= 0.375) + (t >= 0.625) + (t >= 0.875);
    const double x = t - 0.25 * (double)quarter;
    const double r = tau_high * x + tau_low * x;
    const double z = r * r;
    static const double sines[7] = {
        -1.0 / 1307674368000.0, 1.0 / 6227020800.0, -1.0 / 39916800.0, 1.0 / 362880.0,
        -1.0 / 5040.0,          1.0 / 120.0,        -1.0 / 6.0};
    static const double cosines[7] = {
        1.0 / 20922789888000.0, -1.0 / 87178291200.0, 1.0 / 479001600.0, -1.0 / 3628800.0,
        1.0 / 40320.0,          -1.0 / 720.0,         1.0 / 24.0};
    double s = sines[0], c = cosines[0];
    for (int i = 1; i < 7; i++) {
        s = sines[i] + z * s;
        c = cosines[i] + z * c;
    }
    const double cos_r = 1.0 - 0.5 * z + z * z * c;
    const double sin_r = x == -0.125 ? -cos_r : r + r * z * s;
    const int quadrant = quarter % 4;
    const double a = quadrant % 2 ? sin_r : cos_r, b = quadrant % 2 ? cos_r : sin_r;
    *cosine = quadrant == 1 || quadrant == 2 ? 0.0 - a : a; /* 0 - 0 is +0 */
    *sine = quadrant >= 2 ? 0.0 - b : b;
}

static float turn_rounded(double a)
{
    return a > -TURN_MIN && a < TURN_MIN ? 0.0f : (float)a;
}

void scarpi_phase_set(struct scarp_octave *octave, int octaves, float phase)
{
    const double sign = phase < 0.0f ? -1.0 : 1.0;
    double t = fraction((double)phase);
    for (int k = 0; k < octaves; k++) {
        const double speeds[2] = {t, doubled(t)};
        for (int i = 0; i < 2; i++) {
            double cosine = 1.0, sine = 0.0;
            if (speeds[i] > 0.0) {
                turn_of(speeds[i], &cosine, &sine);
            }
            octave[k].turn[2 * i] = turn_rounded(cosine);
            octave[k].turn[2 * i + 1] = turn_rounded(sign * sine);
        }
        t = speeds[1];
    }
}
