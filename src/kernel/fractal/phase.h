/* SPDX-License-Identifier: MIT
 *
 * The derivative of shaped octaves with respect to the phase, from that of the noise, which is
 * noise with other gradients. These passes come before those of the octave itself, so they
 * find the state without it, and work for every order. The reference is with_turning() of
 * scalar/driver.h.
 */
#ifndef SCARP_KERNEL_FRACTAL_PHASE_H
#define SCARP_KERNEL_FRACTAL_PHASE_H

#include "erosion.h"

/* An octave to be shaped, whose noise is in shaping.noise, and in `turning` the derivative of that
   with respect to the phase; for erosion with its gradient in the octave's own axes. `moving` is
   the derivative of the state: of the weight of ridged and hybrid noise, of the slopes d of
   erosion. */
struct phase_shaping {
    struct shaping shaping;
    size_t noise_size, state_size; /* vectors for each block */
    const vf *turning;
    vf *moving;
};

/* Adds the derivative to to->array[VALUE], or puts it there. */
typedef void phase_pass(const struct phase_shaping *at, const struct outputs *to, enum put put);

VEC_INLINE vf fold_phase_at(const struct scarp_call_plan *plan, const vf *noise, const vf *turning)
{
    const struct fold fold = fold_of(plan, noise[0]);
    return with_sign(turning[0], fold.sign);
}

/* `weight` is v_k, `moving` its derivative, which becomes that of the next weight. */
VEC_INLINE vf weighted_phase_at(const struct phase_shaping *at, const vf *noise, const vf *turning,
                                vf weight, vf *moving)
{
    const struct scarp_call_plan *const plan = at->shaping.plan;
    vf s, ds;
    if (plan->fractal == SCARP_HYBRID) {
        const vf r = noise[0] + vf_set(plan->sharpness);
        s = weight * r;
        ds = hybrid_first(weight, r, moving[0], turning[0]);
    } else {
        const struct sign sign = sign_of(noise[0]);
        const vf r = 1.0f - with_sign(noise[0], sign);
        s = weight * (r * r);
        ds = ridge_first(weight, r, moving[0], with_sign(turning[0], sign));
    }
    const vf factor = vf_set(plan->fractal == SCARP_HYBRID ? at->shaping.octave->share : 2.0f);
    moving[0] = (vf)((vu)(factor * ds) & (vu)(absolute(factor * s) < vf_set(1.0f)));
    return ds;
}

/* `d` are the slopes without this octave, `moving` their derivative, which becomes that with it. */
VEC_INLINE vf erosion_phase_at(const vf *noise, const vf *turning, const vf *d, vf *moving,
                               float erosion, int dimensions)
{
    struct vector slopes, by_phase;
    slopes.x = d[0] + noise[1];
    slopes.y = d[1] + noise[2];
    moving[0] += turning[1];
    moving[1] += turning[2];
    if (dimensions == 3) {
        slopes.z = d[2] + noise[3];
        moving[2] += turning[3];
    }
    by_phase = vector_at(moving, dimensions);
    const vf q = 1.0f / (1.0f + vf_set(erosion) * dot(slopes, slopes, dimensions));
    const vf damping = vf_set(2.0f * erosion) * noise[0] * (q * q);
    return q * turning[0] - damping * dot(by_phase, slopes, dimensions);
}

/* Vectors at a block of the derivative of the noise, and of that of the state. */
static size_t turning_size(enum scarp_fractal fractal, int dimensions)
{
    return fractal == SCARP_EROSION ? sample_size(dimensions, 1) : 1;
}

static size_t moving_size(enum scarp_fractal fractal, int dimensions)
{
    return fractal == SCARP_EROSION                             ? (size_t)dimensions
           : fractal == SCARP_RIDGED || fractal == SCARP_HYBRID ? 1
                                                                : 0;
}

/* `fractal` may be another one that has the same pass. */
VEC_INLINE void phase_run(const struct phase_shaping *at, const struct outputs *outputs,
                          enum put put, enum scarp_fractal fractal, int dimensions)
{
    const struct extent extent = at->shaping.extent;
    const vf weight = vf_set(fold_weight(at->shaping.plan, at->shaping.octave->weight));
    const float erosion = at->shaping.plan->erosion;
    const vf *noise = at->shaping.noise, *state = at->shaping.state, *turning = at->turning;
    vf *moving = at->moving;
    for (size_t r = 0; r < extent.rows; r++) {
        float *to = outputs->array[VALUE] + r * outputs->row[VALUE];
        for (size_t b = 0; b < extent.blocks; b++) {
            const vf s = fractal == SCARP_TURBULENCE
                             ? fold_phase_at(at->shaping.plan, noise, turning)
                         : fractal == SCARP_RIDGED
                             ? weighted_phase_at(at, noise, turning, state[0], moving)
                             : erosion_phase_at(noise, turning, state, moving, erosion, dimensions);
            put_block(to, weight * s, put == PUT_ADD ? PUT_ADD : PUT_FIRST);
            to += outputs->block;
            noise += at->noise_size;
            state += at->state_size;
            turning += turning_size(fractal, dimensions);
            moving += moving_size(fractal, dimensions);
        }
    }
}

#define PHASE_PASS(name, fractal, dimensions)                                                      \
    static void name(const struct phase_shaping *at, const struct outputs *to, enum put put)       \
    {                                                                                              \
        phase_run(at, to, put, fractal, dimensions);                                               \
    }

PHASE_PASS(fold_phase, SCARP_TURBULENCE, 2)
PHASE_PASS(weighted_phase, SCARP_RIDGED, 2)
PHASE_PASS(erosion2_phase, SCARP_EROSION, 2)
PHASE_PASS(erosion3_phase, SCARP_EROSION, 3)

#undef PHASE_PASS

#endif
