/* SPDX-License-Identifier: MIT
 *
 * A plan is a struct scarp_noise turned into per-octave constants, ready for a kernel of either
 * kind (src/scalar, src/kernel). check.c checks the noise, octaves.c computes the constants, plan.c
 * makes the plan: on the stack of a call, or in a struct scarp_plan, which the caller keeps.
 */
#ifndef SCARP_PLAN_H
#define SCARP_PLAN_H

#include <float.h>

#include "hybrid.h"
#include "scarp.h"

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

/* How many enumerators scarp.h has of each kind. Numbers below have names and pass the checks. New
   enumerators are appended, so the last one stands here. */
#define SCARP_BASES (SCARP_CELL_VALUE + 1)
#define SCARP_FADES (SCARP_CUBIC + 1)
#define SCARP_FRACTALS (SCARP_JORDAN + 1)

#define SCARP_MAX_OCTAVES 32

struct scarp_octave {
    uint32_t key[3];      /* keys of the lattice hash, by axis */
    float weight;         /* a_k */
    float amplitude;      /* what multiplies the basis: 1 / supremum, in fBm times a_k */
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
        struct {       /* of bases that take places */
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
static inline double scarp_period(const struct scarp_octave *octave, int axis)
{
    return (double)octave->last[axis] + 1.0;
}

/* Whether octaves of the fractal look at positions that those before have bent. */
static inline int fractal_bends(enum scarp_fractal fractal)
{
    return fractal == SCARP_SWISS || fractal == SCARP_JORDAN;
}

/* What a call asks for. */
struct scarp_kind {
    int dimensions;
    short order;  /* highest derivative: 0, 1, 2 */
    short dphase; /* whether the derivative by the phase */
};

#define SCARP_MAX_WARPS 4

/* The warps of a noise (scarp.h, "Warps"). Level 0 is the noise, level 1 its warp, and so on. A
   level above 0 has a component for each axis, which is noise of its own. */
struct scarp_warps {
    int depth;   /* the number of the last level; 0: there are none */
    int vector;  /* whether level 0 has a component for each axis, too: the potentials of a flow */
    int has_all; /* whether `space` has the octaves of all levels and components */
    struct scarp_octave *space;
    const struct scarp_noise *noise;
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
    int flows;  /* whether gradients are turned by the phase, or DPHASE is asked for */
    int dphase; /* whether DPHASE is */
    int plain;  /* whether it blends what is drawn at the corners of cells, and the lattice neither
                   repeats nor flows nor bends */
    const struct scarp_octave *octave;
    struct scarp_warps warps;
};

/* What an octave of a fractal that bends needs: 1 / f_k, its weight, the inverse of octave 0's, and
   c_k (scarp.h, struct scarp_noise). */
struct bend_octave {
    float inverse, weight, inverse_weight, reach;
};

/* 1 / a_0, but finite where a_0 is so small that it is not. */
static inline float inverse_of(float weight)
{
    const double inverse = 1.0 / (double)weight;
    return (float)(inverse > FLT_MAX ? FLT_MAX : inverse < -FLT_MAX ? -FLT_MAX : inverse);
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

/* Makes the checks of scarp_noise_check, for all calls. Always writes *member. */
enum scarp_status scarp_plan_check(const struct scarp_noise *noise, int dimensions,
                                   const char **member);

/* The interval of scarp_range of a valid noise. */
struct scarp_interval scarp_plan_range(const struct scarp_noise *noise, int dimensions);

/* Does what scarp_plan_make says. */
enum scarp_status scarp_plan_keep(struct scarp_plan *plan, const struct scarp_noise *noise,
                                  int dimensions);

/* Checks the noise and makes the plan of a call. `space` has room for SCARP_MAX_OCTAVES octaves,
   and belongs to the plan; it is not used where the noise brings a plan that fits. If the noise has
   a warp, the plan has no octaves, but scarp_plan_level finds them. */
enum scarp_status scarp_plan_call(struct scarp_call_plan *plan, struct scarp_octave *space,
                                  const struct scarp_noise *noise, struct scarp_kind kind);

/* The same for the potentials of a flow (scarp.h, scarp_curl2). In space the plan has no octaves;
   they are components of level 0. */
enum scarp_status scarp_plan_potentials(struct scarp_call_plan *plan, struct scarp_octave *space,
                                        const struct scarp_noise *noise, struct scarp_kind kind);

/* Makes the plan of a component of a level. Until the next call of this function the plan may be
   used; where `has_all`, as long as the space is there. */
void scarp_plan_level(struct scarp_call_plan *plan, const struct scarp_warps *warps,
                      struct scarp_kind kind, int level, int component);

#endif
