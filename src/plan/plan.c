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
    const float lacunarity = noise->lacunarity == 0.0f || octaves == 1 ? 2.0f : noise->lacunarity;
    int powers = is_power_of_two((uint32_t)lacunarity);
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
    plan->erosion = noise->erosion == 0.0f ? 1.0f : noise->erosion;
    plan->sharpness = noise->fractal > SCARP_EROSION ? sharpness_of(noise) : 0.0f;
    plan->octaves = octaves_in(noise);
    plan->rotate = is_rotated(noise, plan->octaves);
    plan->repeat = repeat_of(noise, plan->octaves, dimensions);
    plan->flows = noise->phase != 0.0f;
    plan->plain = plan->repeat == SCARP_REPEAT_NEVER && !plan->flows &&
                  blends_corners(noise->basis) && !fractal_bends(noise->fractal);
}

/* Checks the noise and computes its octaves, but for the phase. It is out of line for the sake of
   calls that keep theirs. */
static __attribute__((noinline)) enum scarp_status
octaves_of(struct scarp_octave *octave, const struct scarp_noise *noise, int dimensions)
{
    const char *member;
    const enum scarp_status status = scarp_plan_check(noise, dimensions, &member);
    if (status == SCARP_OK && noise->warp == NULL) {
        scarp_octaves_make(octave, noise, dimensions);
    }
    return status;
}

enum scarp_status scarp_plan_keep(struct scarp_plan *plan, const struct scarp_noise *noise,
                                  int dimensions)
{
    struct kept *const kept = (struct kept *)plan;
    const enum scarp_status status = octaves_of(kept->octave, noise, dimensions);
    if (status == SCARP_OK) {
        if (noise->warp == NULL && blends_corners(noise->basis)) {
            scarp_phase_set(kept->octave, octaves_in(noise), noise->phase);
        }
        plan_describe(&kept->values, noise, dimensions);
        kept->mark = noise->warp == NULL ? mark_of(dimensions) : 0;
        memcpy(&kept->noise, noise, sizeof *noise);
    }
    return status;
}

/* How many components a level has, and whether they have seeds of their own. */
static int components_of(const struct scarp_warps *warps, int level, int dimensions)
{
    return level > 0 || warps->vector ? dimensions : 1;
}

/* Computes the octaves of a component of a level, which the noise describes; of level 0 without
   components, if there are none. */
static void make_level(struct scarp_octave *octave, const struct scarp_noise *described,
                       int dimensions, int components, int component)
{
    struct scarp_noise noise = *described;
    if (components > 1) {
        noise.seed = scarp_component_seed(noise.seed, component);
    }
    scarp_octaves_make(octave, &noise, dimensions);
    if (noise.basis == SCARP_GRADIENT) {
        scarp_phase_set(octave, octaves_in(&noise), noise.phase);
    }
}

/* Makes the octaves of all levels and components, if there is room for them: one component after
   the other. */
static void make_levels(struct scarp_warps *warps, int dimensions)
{
    const struct scarp_noise *noise = warps->noise;
    int count = 0;
    for (int level = 0; level <= warps->depth; level++, noise = noise->warp) {
        count += octaves_in(noise) * components_of(warps, level, dimensions);
    }
    warps->has_all = count <= SCARP_MAX_OCTAVES;
    struct scarp_octave *octave = warps->space;
    noise = warps->noise;
    for (int level = 0; warps->has_all && level <= warps->depth; level++, noise = noise->warp) {
        const int components = components_of(warps, level, dimensions);
        for (int i = 0; i < components; i++) {
            make_level(octave, noise, dimensions, components, i);
            octave += octaves_in(noise);
        }
    }
}

void scarp_plan_level(struct scarp_call_plan *plan, const struct scarp_warps *warps,
                      struct scarp_kind kind, int level, int component)
{
    const struct scarp_noise *noise = warps->noise;
    struct scarp_octave *octave = warps->space;
    for (int i = 0; i < level; i++, noise = noise->warp) {
        octave += octaves_in(noise) * components_of(warps, i, kind.dimensions);
    }
    octave += octaves_in(noise) * component;
    if (!warps->has_all) {
        octave = warps->space;
        make_level(octave, noise, kind.dimensions, components_of(warps, level, kind.dimensions),
                   component);
    }
    kind.dphase = level == 0 ? kind.dphase : 0;
    plan_describe(plan, noise, kind.dimensions);
    plan_ask(plan, kind);
    plan->octave = octave;
}

/* Makes the plan of a noise with warps, if these have what is asked for, too; or of potentials,
   with or without. */
static enum scarp_status plan_levels(struct scarp_call_plan *plan, struct scarp_octave *space,
                                     const struct scarp_noise *noise, struct scarp_kind kind,
                                     int vector)
{
    const struct scarp_kind of_warp = {.dimensions = kind.dimensions, .order = kind.order};
    int depth = 0;
    for (const struct scarp_noise *w = noise->warp; w != NULL; w = w->warp) {
        if (!has_outputs(w, of_warp)) {
            return SCARP_ERROR_UNSUPPORTED;
        }
        depth++;
    }
    plan_describe(plan, noise, kind.dimensions);
    plan_ask(plan, kind);
    plan->plain = 0;
    plan->octave = NULL;
    plan->warps =
        (struct scarp_warps){.depth = depth, .vector = vector, .space = space, .noise = noise};
    make_levels(&plan->warps, kind.dimensions);
    return SCARP_OK;
}

enum scarp_status scarp_plan_call(struct scarp_call_plan *plan, struct scarp_octave *space,
                                  const struct scarp_noise *noise, struct scarp_kind kind)
{
    if (plan_kept(plan, noise, kind)) {
        return SCARP_OK;
    }
    const enum scarp_status status = octaves_of(space, noise, kind.dimensions);
    if (status != SCARP_OK) {
        return status;
    }
    if (!has_outputs(noise, kind)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (noise->warp != NULL) {
        return plan_levels(plan, space, noise, kind, 0);
    }
    plan_describe(plan, noise, kind.dimensions);
    plan_ask(plan, kind);
    if (plan->flows) {
        scarp_phase_set(space, plan->octaves, noise->phase);
    }
    plan->octave = space;
    return SCARP_OK;
}

enum scarp_status scarp_plan_potentials(struct scarp_call_plan *plan, struct scarp_octave *space,
                                        const struct scarp_noise *noise, struct scarp_kind kind)
{
    if (kind.dimensions == 2) {
        return scarp_plan_call(plan, space, noise, kind);
    }
    const char *member;
    const enum scarp_status status = scarp_plan_check(noise, kind.dimensions, &member);
    return status != SCARP_OK          ? status
           : !has_outputs(noise, kind) ? SCARP_ERROR_UNSUPPORTED
                                       : plan_levels(plan, space, noise, kind, 1);
}
