/* SPDX-License-Identifier: MIT
 *
 * Checks the description of gullies, and computes their constants: in double and in one fixed
 * order, so that every platform computes the same.
 */
#include "gully.h"

#include <math.h>

#include "parameters.h"
#include "refusals.h"

_Static_assert(offsetof(struct scarp_gullies, amplitude) == 16 &&
                   offsetof(struct scarp_gullies, period) == 80 &&
                   offsetof(struct scarp_gullies, offset_first) == 92 &&
                   offsetof(struct scarp_gullies, spare) == 96 &&
                   sizeof(struct scarp_gullies) == 128,
               "struct scarp_gullies has 128 bytes without padding");

#define TWO_PI 6.283185307179586

/* Numbers of gullies, with their defaults filled in. */
#define DECLARE(X, member, ...) double member;
struct filled {
    SCARP_GULLIES_MEMBERS(DECLARE, DECLARE, )
};
#undef DECLARE

static struct filled filled_of(const struct scarp_gullies *g)
{
#define FILL(X, member, refusal, standard, ...) FILL_OTHER(X, member, standard, )
#define FILL_OTHER(X, member, standard, ...) .member = value_or((double)g->member, standard),
    const struct filled p = {SCARP_GULLIES_MEMBERS(FILL, FILL_OTHER, )};
#undef FILL_OTHER
#undef FILL
    return p;
}

static enum scarp_refusal refused_number(const struct filled *p)
{
    return !within(p->frequency, noise_bounds.frequency)     ? REFUSED_FREQUENCY
           : !within(p->amplitude, gullies_bounds.amplitude) ? REFUSED_GULLIES_AMPLITUDE
           : !within(p->depth, gullies_bounds.depth)         ? REFUSED_DEPTH
           : !within(p->cells, gullies_bounds.cells)         ? REFUSED_CELLS
           : !within(p->slope, gullies_bounds.slope)         ? REFUSED_SLOPE
           : !within(p->slope_low, gullies_bounds.slope_low) ? REFUSED_SLOPE_LOW
           : !within(p->low, gullies_bounds.low)             ? REFUSED_LOW
           : !within(p->high, gullies_bounds.high)           ? REFUSED_HIGH
           : !(p->high - p->low >= 0x1p-10)                  ? REFUSED_HIGH_LOW
           : !within(p->floor, gullies_bounds.floor)         ? REFUSED_FLOOR
           : !within(p->stripes, gullies_bounds.stripes)     ? REFUSED_STRIPES
           : !within(p->branch, gullies_bounds.branch)       ? REFUSED_BRANCH
           : !within(p->round, gullies_bounds.round)         ? REFUSED_ROUND
           : !within(p->keep, gullies_bounds.keep)           ? REFUSED_KEEP
                                                             : REFUSED_NOT;
}

static int reserved_in_use(const struct scarp_gullies *g)
{
    uint32_t bits = 0;
    for (size_t i = 0; i < sizeof g->spare / sizeof g->spare[0]; i++) {
        bits |= g->spare[i];
    }
    return bits != 0;
}

/* A period of the base in cells of the gullies; 0 if that is not a whole number. */
static uint32_t period_of(uint32_t cells_of_base, double cells)
{
    const double period = (double)cells_of_base * cells;
    return period <= PERIOD_MAX && period == (double)(uint32_t)period ? (uint32_t)period : 0;
}

struct scarp_noise scarpi_gullies_lattice(const struct scarp_gullies *gullies)
{
    const struct filled p = filled_of(gullies);
    const struct scarp_noise lattice = {
        .rotate = gullies->rotate,
        .seed = gullies->seed,
        .frequency = p.frequency * p.cells,
        .octaves = (float)p.octaves,
        .lacunarity = gullies->lacunarity,
        .gain = (float)p.gain,
        .amplitude = (float)p.depth,
        .period = {period_of(gullies->period[0], p.cells), period_of(gullies->period[1], p.cells)},
        .of_octaves = gullies->of_octaves,
        .offset_first = gullies->offset_first,
    };
    return lattice;
}

struct scarp_fault scarpi_gullies_verify(const struct scarp_gullies *gullies)
{
    const struct filled p = filled_of(gullies);
    struct scarp_fault fault = {refused_number(&p), 0};
    if (fault.why == REFUSED_NOT && reserved_in_use(gullies)) {
        fault.why = REFUSED_SPARE;
    }
    for (int i = 0; i < 2 && fault.why == REFUSED_NOT; i++) {
        if (gullies->period[i] != 0 && period_of(gullies->period[i], p.cells) == 0) {
            fault.why = i == 0 ? REFUSED_CELLS_X : REFUSED_CELLS_Y;
        }
    }
    if (fault.why != REFUSED_NOT) {
        return fault;
    }
    const struct scarp_noise lattice = scarpi_gullies_lattice(gullies);
    fault = scarpi_plan_check(&lattice, 2);
    /* The frequency of the lattice is not the one that was given. */
    fault.why = fault.why == REFUSED_FREQUENCY ? REFUSED_FREQUENCY_CELLS : fault.why;
    return fault;
}

/* The turn R of octave k in 2D. */
static void turn_of(double turn[2], const struct scarp_call_plan *plan, int k)
{
    const struct scarp_octave *const o = &plan->octave[k];
    turn[0] = plan->rotate ? o->jacobian64[0][0] / o->frequency64 : 1.0;
    turn[1] = plan->rotate ? o->jacobian64[1][0] / o->frequency64 : 0.0;
}

static void set_octave(struct scarp_gully_octave *to, const struct scarp_call_plan *plan, int k,
                       const struct filled *p)
{
    const double cells = plan->octave[k].frequency64 / p->frequency;
    double turn[2];
    turn_of(turn, plan, k);
    to->weight = plan->octave[k].weight;
    to->keep = k == 0 ? 0.0f : (float)p->keep;
    for (int i = 0; i < 2; i++) {
        to->waves[i] = (float)(p->stripes * turn[i]);
        to->angles[i] = (float)(TWO_PI * p->stripes * turn[i]);
        to->cells[i] = (float)(cells * turn[i]);
    }
    to->stretch = (float)(TWO_PI * p->stripes * cells);
}

void scarpi_gullies_plan(struct scarp_gully_plan *g, const struct scarp_gullies *gullies,
                         const struct scarp_call_plan *plan)
{
    const struct filled p = filled_of(gullies);
    g->of_base[0] = (float)(1.0 / p.amplitude);
    g->of_base[1] = (float)(1.0 / (p.amplitude * p.frequency));
    g->of_base[2] = (float)(1.0 / (p.amplitude * p.frequency * p.frequency));
    g->of_sum[0] = (float)p.amplitude;
    g->of_sum[1] = (float)(p.amplitude * p.frequency);
    g->low = (float)p.low;
    g->steepness = (float)(1.0 / (p.high - p.low));
    g->slope2 = (float)(p.slope * p.slope);
    g->slope2_low = (float)(p.slope_low * p.slope_low);
    g->lowered = (float)(1.0 + p.floor);
    g->round = (float)p.round;
    g->round2 = (float)(p.round * p.round);
    g->fall = (float)(2.0 / (sqrt(1.0 + p.round * p.round) - p.round));
    g->branch = (float)p.branch;
    for (int k = 0; k < plan->octaves; k++) {
        set_octave(&g->octave[k], plan, k, &p);
    }
}

double scarpi_gullies_depth(const struct scarp_gullies *gullies)
{
    const struct filled p = filled_of(gullies);
    return p.amplitude * p.depth;
}
