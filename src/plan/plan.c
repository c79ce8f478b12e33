/* SPDX-License-Identifier: MIT
 *
 * Makes plans: the octaves of a noise, or of all levels and components of a noise with warps.
 */
#include "plan.h"

#include <stddef.h>
#include <string.h>

#include "check.h"
#include "kept.h"
#include "octaves.h"
#include "phase.h"

static int is_power_of_two(uint32_t a)
{
    return (a & (a - 1)) == 0;
}

/* A lacunarity that goes with periods is an integer. */
static enum scarp_repeat repeat_of(const struct scarp_noise *noise, int octaves, int dimensions)
{
    if (!repeats(noise, dimensions)) {
        return SCARP_REPEAT_NEVER;
    }
    const double lacunarity = value_or((double)noise->lacunarity, noise_bounds.lacunarity.standard);
    int powers = octaves == 1 || is_power_of_two((uint32_t)lacunarity);
    for (int i = 0; i < dimensions; i++) {
        powers = powers && is_power_of_two(noise->period[i]);
    }
    return powers ? SCARP_REPEAT_POWERS : SCARP_REPEAT_ANY;
}

/* Fills in what the noise says without its octaves, for a call that asks for values. */
static void plan_describe(struct scarp_call_plan *plan, const struct scarp_noise *noise,
                          int dimensions)
{
    memset(plan, 0, sizeof *plan);
    plan->basis = noise->basis;
    plan->fade = noise->fade;
    plan->fractal = noise->fractal;
    plan->erosion = (float)value_or((double)noise->erosion, noise_bounds.erosion.standard);
    plan->sharpness = fractal_row(noise->fractal)->sharpness != 0.0f ? sharpness_of(noise) : 0.0f;
    plan->octaves = octaves_in(noise);
    plan->rotate = is_rotated(noise, plan->octaves);
    plan->repeat = repeat_of(noise, plan->octaves, dimensions);
    plan->flows = noise->phase != 0.0f;
    plan->plain = plan->repeat == SCARP_REPEAT_NEVER && !plan->flows &&
                  blends_corners(noise->basis) && !fractal_bends(noise->fractal);
}

enum scarp_status scarpi_plan_keep(struct scarp_plan *plan, const struct scarp_noise *noise,
                                   int dimensions)
{
    struct kept *const kept = (struct kept *)plan;
    const struct scarp_fault fault = scarpi_plan_check(noise, dimensions);
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    if (noise->warp == NULL) {
        scarpi_octaves_make(kept->octave, noise, dimensions);
        if (blends_corners(noise->basis)) {
            scarpi_phase_set(kept->octave, octaves_in(noise), noise->phase);
        }
    }
    plan_describe(&kept->values, noise, dimensions);
    kept->mark = noise->warp == NULL ? mark_of(dimensions) : 0;
    memcpy(&kept->noise, noise, sizeof *noise);
    return SCARP_OK;
}

/* Whether a level has a component for each axis. */
static int has_components(const struct scarp_warps *warps, int level)
{
    return level > 0 || warps->vector;
}

/* How many sets of octaves a level has. */
static int octave_sets(const struct scarp_warps *warps, int level, enum scarp_basis basis,
                       int dimensions)
{
    return has_components(warps, level) && !components_share_lattice(basis) ? dimensions : 1;
}

/* Computes the octaves of a component, or of a noise that has none. */
static void make_component(struct scarp_octave *octave, const struct scarp_noise *described,
                           int dimensions, int is_component, int component)
{
    struct scarp_noise noise = *described;
    if (is_component) {
        const int own = components_share_lattice(noise.basis) ? 0 : component;
        noise.seed = scarpi_component_seed(noise.seed, own);
    }
    scarpi_octaves_make(octave, &noise, dimensions);
    if (basis_has(noise.basis, BASIS_FLOWS)) {
        scarpi_phase_set(octave, octaves_in(&noise), noise.phase);
    }
}

/* The function `fetch` of struct scarp_levels. */
static void fetch_component(const struct scarp_warps *warps, int level, int component)
{
    const struct scarp_levels *const levels = warps->levels;
    const struct scarp_noise *noise = levels->noise;
    for (int i = 0; i < level; i++) {
        noise = noise->warp;
    }
    make_component(levels->octave, noise, levels->dimensions, has_components(warps, level),
                   component);
}

/* Makes the plans of all levels, and the octaves of their components if there is room for them. */
static void make_levels(struct scarp_levels *levels, const struct scarp_warps *warps,
                        struct scarp_request request)
{
    const struct scarp_request of_warp = {.dimensions = request.dimensions, .order = request.order};
    const struct scarp_noise *noise = levels->noise;
    struct scarp_octave *octave = levels->octave;
    int count = 0;
    for (int level = 0; level <= warps->depth; level++, noise = noise->warp) {
        struct scarp_call_plan *const plan = &levels->plan[level];
        plan_describe(plan, noise, request.dimensions);
        plan_ask(plan, level == 0 ? request : of_warp);
        count += plan->octaves * octave_sets(warps, level, plan->basis, request.dimensions);
    }
    levels->fetch = count > SCARP_MAX_OCTAVES ? fetch_component : NULL;
    noise = levels->noise;
    for (int level = 0; level <= warps->depth; level++, noise = noise->warp) {
        const int has = has_components(warps, level);
        const int sets = octave_sets(warps, level, noise->basis, request.dimensions);
        levels->plan[level].octave = octave;
        for (int i = 0; levels->fetch == NULL && i < sets; i++) {
            make_component(octave, noise, request.dimensions, has, i);
            octave += levels->plan[level].octaves;
        }
    }
}

/* Makes the plan of a checked noise with warps, or of potentials. */
static void plan_levels(struct scarp_call_plan *plan, struct scarp_octave *octave,
                        struct scarp_levels *levels, const struct scarp_noise *noise,
                        struct scarp_request request)
{
    struct scarp_warps warps = {.vector = request.vector, .levels = levels};
    for (const struct scarp_noise *w = noise->warp; w != NULL; w = w->warp) {
        warps.depth++;
    }
    levels->noise = noise;
    levels->octave = octave;
    levels->dimensions = request.dimensions;
    make_levels(levels, &warps, request);
    *plan = levels->plan[0];
    plan->plain = 0;
    plan->octave = NULL;
    plan->warps = warps;
}

enum scarp_status scarpi_plan_call(struct scarp_call_plan *plan, struct scarp_octave *octave,
                                   struct scarp_levels *levels, const struct scarp_noise *noise,
                                   struct scarp_request request)
{
    if (!request.vector && plan_kept(plan, noise, request)) {
        return SCARP_OK;
    }
    struct scarp_fault fault = scarpi_plan_check(noise, request.dimensions);
    if (fault.why == REFUSED_NOT) {
        fault = outputs_fault(noise, request);
    }
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    if (scarpi_has_levels(noise, request)) {
        plan_levels(plan, octave, levels, noise, request);
        return SCARP_OK;
    }
    scarpi_octaves_make(octave, noise, request.dimensions);
    plan_describe(plan, noise, request.dimensions);
    plan_ask(plan, request);
    if (plan->flows) {
        scarpi_phase_set(octave, plan->octaves, noise->phase);
    }
    plan->octave = octave;
    return SCARP_OK;
}
