/* SPDX-License-Identifier: MIT
 *
 * The plan of a call is a struct scarp_noise turned into constants of its octaves, ready for
 * kernels of either kind (scalar/, kernel/). This file has the types and what is computed of them
 * alone. It is all of planning that kernels know; plan.h makes plans.
 */
#ifndef SCARP_CALL_H
#define SCARP_CALL_H

#include <float.h>
#include <math.h>
#include <stddef.h>

#include "scarp.h"
#include "traits.h"

/* The checks are here because every file that computes includes this one. (clang defines none of
   the narrower macros for the options that -ffast-math is made of, so not every mistake can be
   caught.) */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||     \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "scarp promises the same bits everywhere: build it without -ffast-math and its parts"
#endif
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16 /* 16: only _Float16 is evaluated as such */
#error "scarp needs FLT_EVAL_METHOD 0: x86 -msse2 -mfpmath=sse, s390x -fexcess-precision=fast"
#endif

#define SCARP_MAX_OCTAVES 32

/* Octaves of a call take up to 8 KiB of stack. Noise without warps that has no more than these
   takes less of it, and grids of such have more scratch space. */
#define SCARP_FEW_OCTAVES 12

struct scarp_octave {
    uint32_t key[3];      /* keys of the lattice hash, by axis */
    float weight;         /* a_k */
    float amplitude;      /* what multiplies the basis: 1 / supremum, in fBm times a_k, in hybrid
                             noise times 1 - 2^-17 */
    float slope;          /* amplitude f_k, for gradients where axes are not turned */
    float curvature;      /* amplitude f_k^2, for Hessians where axes are not turned */
    float frequency;      /* f_k */
    float share;          /* gain^k, which makes weights of hybrid noise */
    float jacobian[3][3]; /* J_k where axes are turned: J_k[i][j] = d p_i / d x_j. In 2D, row 2
                             of the matrices is unset. */
    float gradient[3][3]; /* amplitude J_k */
    uint32_t last[3];     /* the last cell of a period along each axis; 2^32 - 1 without period */
    union {
        float turn[4]; /* of noise that flows: cosine and sine of the phase's angle, then of twice
                          that. In other noise that blends corners it is set in kept plans only. */
        struct {       /* of simplex and cellular noise */
            float jitter;   /* how far features stray, in units of 2^-32 cells */
            float middle;   /* what is subtracted from distances */
            double stretch; /* what p_y is multiplied by to count rows of the lattice */
        };
    };
    double frequency64; /* f_k and J_k again for double coordinates */
    double jacobian64[3][3];
    double offset[3]; /* o_k: multiples of 2^-24 in [0, 1), so exact as floats, too */
};

/* How often the lattice repeats: after 2^32 cells, after powers of two, or after any numbers. */
enum scarp_repeat { SCARP_REPEAT_NEVER, SCARP_REPEAT_POWERS, SCARP_REPEAT_ANY };

/* The period of an octave along an axis, in cells: 2^32 if there is none. */
static inline double scarpi_period(const struct scarp_octave *octave, int axis)
{
    return (double)octave->last[axis] + 1.0;
}

/* amplitude d angle / d phase of octave k: 2 pi 2^k times the amplitude */
static inline float scarpi_phase_slope(const struct scarp_octave *octave, int k)
{
    return octave->amplitude * (6.28318531f * (float)(1u << k));
}

/* d turn / d angle: of an angle x, then of 2 x. The products with 2 are exact. */
static inline void scarpi_phase_derivative(float derivative[4], const float turn[4])
{
    derivative[0] = -turn[1];
    derivative[1] = turn[0];
    derivative[2] = -2.0f * turn[3];
    derivative[3] = 2.0f * turn[2];
}

/* Whether the components of vector noise draw from one lattice; else each has a seed of its own. */
static inline int components_share_lattice(enum scarp_basis basis)
{
    return blends_corners(basis);
}

/* What a call asks for. */
struct scarp_request {
    int dimensions;
    short order;          /* highest derivative: 0, 1, 2 */
    unsigned char dphase; /* whether the derivative with respect to the phase */
    unsigned char vector; /* whether a component for each axis: the potentials of a flow */
};

#define SCARP_MAX_WARPS 4

struct scarp_levels;

/* The warps of a noise (scarp.h, "Warps"). Level 0 is the noise, level 1 its warp, and so on. A
   level above 0 has a component for each axis. */
struct scarp_warps {
    int depth;  /* the number of the last level; 0: there are none */
    int vector; /* whether level 0 has a component for each axis, too */
    const struct scarp_levels *levels;
};

/* What a kernel is to compute. */
struct scarp_call_plan {
    enum scarp_basis basis;
    enum scarp_fade fade;
    enum scarp_fractal fractal;
    float erosion, sharpness;
    int order;   /* highest derivative asked for: 0, 1, 2 */
    int rotate;  /* octaves 1 and up use jacobian and gradient, not frequency, slope, curvature */
    int octaves; /* how many `octave` has */
    int first;   /* the number of octave[0] in the noise: 0, but where octaves are taken one by one
                  */
    enum scarp_repeat repeat;
    int flows;     /* whether gradients are turned by the phase, or DPHASE is asked for */
    int dphase;    /* whether DPHASE is */
    int component; /* which component of vector noise, if these share a lattice; else 0 */
    int plain; /* whether it is gradient or value noise that neither repeats nor flows nor bends,
                  and component 0 */
    const struct scarp_octave *octave;
    struct scarp_warps warps;
};

/* The plans of all levels, which have no warps themselves. */
struct scarp_levels {
    struct scarp_call_plan plan[1 + SCARP_MAX_WARPS]; /* of the first component of each level */
    int octaves;                                      /* of all levels and components */
    /* NULL: all octaves are there. Those of components that share no lattice are behind those of
       the component before. A noise may have more octaves in all than the stack has room for: then
       this puts those of a component to `octave`, where the plans of the levels have them that
       bring none. */
    void (*fetch)(const struct scarp_warps *warps, int level, int component);
    struct scarp_octave *octave;
    /* only for `fetch` */
    const struct scarp_noise *noise;
    int dimensions;
};

/* The plan of a component of a level. It may be used until the next one is asked for. */
static inline struct scarp_call_plan scarpi_component_plan(const struct scarp_call_plan *plan,
                                                           int level, int component)
{
    const struct scarp_levels *const levels = plan->warps.levels;
    struct scarp_call_plan found = levels->plan[level];
    if (levels->fetch != NULL && found.octave == levels->octave) {
        levels->fetch(&plan->warps, level, component);
    } else if (!components_share_lattice(found.basis)) {
        found.octave += found.octaves * component;
    }
    if (components_share_lattice(found.basis)) {
        found.component = component;
        found.plain &= component == 0;
    }
    return found;
}

/* Makes the plan of a call that asks for values into one for what is asked for. */
static inline void plan_ask(struct scarp_call_plan *plan, struct scarp_request request)
{
    plan->order = request.order;
    plan->dphase = request.dphase;
    plan->flows |= request.dphase;
    plan->plain &= !request.dphase;
}

/* What an octave of a fractal that bends needs: 1 / f_k, its weight, the inverse of octave 0's, and
   c_k (scarp.h, "Fractals that bend"). */
struct bend_octave {
    float inverse, weight, inverse_weight, reach;
};

/* 1 / a_0, but finite where a_0 is so small that it is not, or 0. */
static inline float inverse_of(float weight)
{
    const int is_tiny = weight >= -0x1p-128f && weight <= 0x1p-128f;
    const float finite = signbit(weight) ? -FLT_MAX : FLT_MAX;
    return is_tiny ? finite : (float)(1.0 / (double)weight);
}

static inline struct bend_octave bend_octave_of(const struct scarp_call_plan *plan, int k)
{
    const struct scarp_octave *const o = &plan->octave[k];
    const double f = plan->fractal == SCARP_SWISS ? plan->octave[0].frequency64 : o->frequency64;
    const struct bend_octave b = {
        .inverse = (float)(1.0 / o->frequency64),
        .weight = o->weight,
        .inverse_weight = inverse_of(plan->octave[0].weight),
        .reach = (float)((double)plan->sharpness / f),
    };
    return b;
}

#endif
