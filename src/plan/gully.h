/* SPDX-License-Identifier: MIT
 *
 * Describes a call of gullies: the constants of its octaves, for kernels, and how they are made.
 */
#ifndef SCARP_GULLIES_H
#define SCARP_GULLIES_H

#include "call.h"
#include "refusals.h"

/* The members of struct scarp_eroded, in their order, and of the base that they are made of. */
enum {
    ERODED_VALUE,
    ERODED_DX,
    ERODED_DY,
    ERODED_DISPLACEMENT,
    ERODED_DISPLACEMENT_DX,
    ERODED_DISPLACEMENT_DY,
    ERODED_OUTPUTS
};
enum { BASE_VALUE, BASE_DX, BASE_DY, BASE_DXX, BASE_DXY, BASE_DYY, BASE_INPUTS };

/* Of octave k, whose axes are turned by R; formulas/gullies.h has its meaning. */
struct scarp_gully_octave {
    float weight, keep;
    float waves[2], angles[2], cells[2]; /* each times the cosine and the sine of R */
    float stretch;
};

struct scarp_gully_plan {
    /* What brings the base, its gradient and its Hessian to units of the call, and sums back. */
    float of_base[3], of_sum[2];
    float low, steepness, slope2, slope2_low, lowered, round, round2, fall, branch;
    struct scarp_gully_octave octave[SCARP_MAX_OCTAVES];
};

/* What a kernel is to compute. Arrays are those of the caller, which may be the same; where no
   derivative is asked for, those of the Hessian are NULL. */
struct scarp_gully_call {
    const struct scarp_gully_plan *gullies;
    size_t count;
    const void *position[2]; /* of points: floats, or doubles */
    int doubles;
    const struct scarp_grid *grid; /* with its strides filled in; NULL: points */
    const float *base[BASE_INPUTS];
    float *out[ERODED_OUTPUTS];
};

/* The lattice that gullies are drawn on, as a noise whose weights sum up to the depth. */
struct scarp_noise scarpi_gullies_lattice(const struct scarp_gullies *gullies);

/* Makes the checks of scarp_gullies_check. */
struct scarp_fault scarpi_gullies_verify(const struct scarp_gullies *gullies);

/* Makes the constants of gullies that passed the checks; `plan` is that of their lattice. */
void scarpi_gullies_plan(struct scarp_gully_plan *g, const struct scarp_gullies *gullies,
                         const struct scarp_call_plan *plan);

/* How far gullies displace the base at most. */
double scarpi_gullies_depth(const struct scarp_gullies *gullies);

#endif
