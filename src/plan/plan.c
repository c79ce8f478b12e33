/* SPDX-License-Identifier: MIT
 *
 * Makes plans: the octaves of a noise, or of all levels and components of a noise with warps.
 */
#include "plan.h"

#include <stddef.h>
#include <string.h>

#include "kept.h"
#include "octaves.h"
#include "phase.h"
#include "refusals.h"

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

/* How many sets of octaves a noise has, or, with components, vector noise. */
static int octave_sets(enum scarp_basis basis, int dimensions, int has_components)
{
    return has_components && !components_share_lattice(basis) ? dimensions : 1;
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
    if (blends_corners(noise.basis)) {
        scarpi_phase_set(octave, octaves_in(&noise), noise.phase);
    }
}

size_t scarpi_plan_bytes(const struct scarp_noise *noise, int dimensions, int is_vector)
{
    const int sets = octave_sets(noise->basis, dimensions, is_vector);
    return sizeof(struct kept) + (size_t)(octaves_in(noise) * sets) * sizeof(struct scarp_octave);
}

enum scarp_status scarpi_plan_keep(void *memory, size_t size, const struct scarp_noise *noise,
                                   int dimensions, int is_vector)
{
    struct kept *const kept = memory;
    const struct scarp_fault fault = scarpi_plan_check(noise, dimensions);
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    const int is_kept = scarpi_plan_bytes(noise, dimensions, is_vector) <= size;
    const int sets = is_kept ? octave_sets(noise->basis, dimensions, is_vector) : 0;
    for (int i = 0; i < sets; i++) {
        make_component(kept->octave + i * octaves_in(noise), noise, dimensions, is_vector, i);
    }
    plan_describe(&kept->values, noise, dimensions);
    kept->mark = is_kept ? mark_of(dimensions, is_vector) : 0;
    memcpy(&kept->noise, noise, sizeof *noise);
    kept->noise.warp = NULL;
    kept->noise.plan = NULL;
    return SCARP_OK;
}

/* Whether a level has a component for each axis. */
static int has_components(const struct scarp_warps *warps, int level)
{
    return level > 0 || warps->vector;
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

/* Takes the plans that the levels bring, if they fit; the plans of other levels have no octaves.
   Returns whether all levels have one, and so need no check. */
static int keep_levels(struct scarp_levels *levels, const struct scarp_noise *noise,
                       struct scarp_request request)
{
    int all = 1;
    for (int level = 0; noise != NULL; level++, noise = noise->warp) {
        if (level > SCARP_MAX_WARPS) {
            return 0;
        }
        const struct kept *const kept =
            kept_of(noise, request.dimensions, level > 0 || request.vector);
        if (kept != NULL) {
            plan_of_kept(&levels->plan[level], kept);
        } else {
            levels->plan[level].octave = NULL;
            all = 0;
        }
    }
    return all;
}

/* Makes the plans of all levels, and the octaves of their components if there is room for them. */
static void make_levels(struct scarp_levels *levels, const struct scarp_warps *warps,
                        struct scarp_request request)
{
    const struct scarp_request of_warp = {.dimensions = request.dimensions, .order = request.order};
    const struct scarp_noise *noise = levels->noise;
    struct scarp_octave *octave = levels->octave;
    int made = 0;
    levels->octaves = 0;
    for (int level = 0; level <= warps->depth; level++, noise = noise->warp) {
        struct scarp_call_plan *const plan = &levels->plan[level];
        const int is_made = plan->octave == NULL;
        if (is_made) {
            plan_describe(plan, noise, request.dimensions);
        }
        plan_ask(plan, level == 0 ? request : of_warp);
        const int count = plan->octaves * octave_sets(plan->basis, request.dimensions,
                                                      has_components(warps, level));
        levels->octaves += count;
        made += is_made ? count : 0;
    }
    levels->fetch = made > SCARP_MAX_OCTAVES ? fetch_component : NULL;
    noise = levels->noise;
    for (int level = 0; level <= warps->depth; level++, noise = noise->warp) {
        struct scarp_call_plan *const plan = &levels->plan[level];
        const int has = has_components(warps, level);
        const int sets = octave_sets(plan->basis, request.dimensions, has);
        if (plan->octave != NULL) {
            continue;
        }
        plan->octave = octave;
        for (int i = 0; levels->fetch == NULL && i < sets; i++) {
            make_component(octave, noise, request.dimensions, has, i);
            octave += plan->octaves;
        }
    }
}

/* Makes the plan of a checked noise with warps, or of potentials, of the levels that
   keep_levels() has begun. */
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
    const int has_levels = scarpi_has_levels(noise, request);
    if (!has_levels && plan_kept(plan, noise, request)) {
        return SCARP_OK;
    }
    struct scarp_fault fault = {REFUSED_NOT, 0};
    if (!has_levels || !keep_levels(levels, noise, request)) {
        fault = scarpi_plan_check(noise, request.dimensions);
    }
    if (fault.why == REFUSED_NOT) {
        fault = outputs_fault(noise, request);
    }
    if (fault.why != REFUSED_NOT) {
        return scarpi_fault_status(fault, NULL);
    }
    if (has_levels) {
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
