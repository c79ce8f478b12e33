/* SPDX-License-Identifier: MIT
 *
 * Says what the values of a noise can be, and why.
 */
#include "range.h"

#include "parameters.h"
#include "phase.h"
#include "suprema.h"

/* What |n_k| can be: with a phase, more than 1. */
static double reach_of(const struct scarp_noise *noise, int dimensions)
{
    return noise->phase == 0.0f ? 1.0
                                : scarpi_phase_supremum(noise->fade, dimensions) /
                                      scarpi_supremum(noise, dimensions);
}

/*
 * Why values stay within: |n_k| <= 1 but for the rounding that HEADROOM covers, and the factors
 * that fractals multiply a_k n_k by lie in [0, 1] in float arithmetic too, since rounding is
 * monotone and 1 is a float: |n_k| <= 1 (turbulence); (1 - |n_k|)^2 <= 1 and the weights, which end
 * at 1 (ridged: |n_k| may exceed 1 by rounding or with a phase, which does no harm below 2);
 * 1 / (1 + erosion d.d) (erosion). What ping-pong folds, 1 - 2 |e| with |e| <= 1, is in [-1, 1].
 * max(0, 1 - |n_k|) and the products u_k are (Swiss), and 1 - erosion / (1 + s.s) (Jordan, where
 * n_k is squared, and has the head-room twice). These and turbulence sum numbers of one sign. So
 * every sum is at most the sum of the a_k, which is amplitude * HEADROOM. Single octaves show that
 * the bounds are reached. With a phase, |n_k| is at most the `reach`.
 */
struct scarp_interval scarpi_plan_range(const struct scarp_noise *noise, int dimensions)
{
    const struct parameters p = parameters_of(noise);
    const double reach = reach_of(noise, dimensions);
    struct scarp_interval range = {-reach, reach};
    switch (fractal_row(noise->fractal)->range) {
    case RANGE_SUM: break;
    case RANGE_MAGNITUDE: range.lowest = 0.0; break;
    case RANGE_SQUARE: range = (struct scarp_interval){0.0, reach * reach}; break;
    case RANGE_UNIT: range = (struct scarp_interval){0.0, 1.0}; break;
    case RANGE_FOLDED: range = (struct scarp_interval){-1.0, 1.0}; break;
    case RANGE_RAISED:
        range = scarpi_hybrid_range(p.sharpness, p.gain, (const double[2]){p.octaves, p.of_octaves},
                                    reach);
        break;
    }
    const double magnitude = p.amplitude < 0.0 ? -p.amplitude : p.amplitude;
    range.lowest *= magnitude;
    range.highest *= magnitude;
    const struct scarp_interval turned = {0.0 - range.highest, 0.0 - range.lowest}; /* no -0 */
    return p.amplitude < 0.0 ? turned : range;
}
