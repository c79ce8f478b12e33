/* SPDX-License-Identifier: MIT
 *
 * What bases and fractals are: the only table of them, with a row for each. Planning, kernels,
 * recipes, shaders and tests ask it, and have no lists of their own.
 */
#ifndef SCARP_TRAITS_H
#define SCARP_TRAITS_H

#include "scarp.h"

/* Of a basis */
enum {
    BASIS_BLENDS = 1,        /* blends what is drawn at the corners of cells, as the fade says */
    BASIS_FLOWS = 2,         /* draws gradients, which a phase turns */
    BASIS_TRIANGLES = 4,     /* its lattice in the plane has rows of triangles along x */
    BASIS_CELLS = 8,         /* draws features of cells */
    BASIS_DISTANCE = 16,     /* is a distance, from which its middle is subtracted */
    BASIS_CREASES = 32,      /* its gradients jump */
    BASIS_LENGTHS_JUMP = 64, /* and so do the lengths of these */
    BASIS_JUMPS = 128        /* its values jump */
};

/* X(enumerator, name, word of recipes, traits). In recipes, words are without `-`. */
#define SCARP_BASIS_LIST(X)                                                                        \
    X(GRADIENT, "gradient", "gradient", BASIS_BLENDS | BASIS_FLOWS)                                \
    X(VALUE, "value", "value", BASIS_BLENDS)                                                       \
    X(SIMPLEX, "simplex", "simplex", BASIS_TRIANGLES)                                              \
    X(CELL_F1, "cell-f1", "cell_f1", BASIS_CELLS | BASIS_DISTANCE | BASIS_CREASES)                 \
    X(CELL_F2, "cell-f2", "cell_f2", BASIS_CELLS | BASIS_DISTANCE | BASIS_CREASES)                 \
    X(CELL_EDGE, "cell-edge", "cell_edge",                                                         \
      BASIS_CELLS | BASIS_DISTANCE | BASIS_CREASES | BASIS_LENGTHS_JUMP)                           \
    X(CELL_SOFT, "cell-soft", "cell_soft", BASIS_CELLS | BASIS_DISTANCE)                           \
    X(CELL_VALUE, "cell-value", "cell_value", BASIS_CELLS | BASIS_JUMPS)

/* Of a fractal */
enum {
    FRACTAL_SLOPES = 1,     /* gradients of the basis are in its values: it has no Hessian */
    FRACTAL_OWN_SLOPES = 2, /* also those of the octave itself */
    FRACTAL_BENDS = 4,      /* octaves look at positions that those before have bent: no dphase */
    FRACTAL_CREASES = 8     /* it folds or cuts values, so its gradients jump */
};

/* What the values of a fractal are, with an amplitude of 1, where those of octaves are in [-r, r]
   (plan/range.c says why) */
enum fractal_range {
    RANGE_SUM,       /* in [-r, r] */
    RANGE_MAGNITUDE, /* in [0, r] */
    RANGE_SQUARE,    /* in [0, r^2] */
    RANGE_UNIT,      /* in [0, 1] whatever r is */
    RANGE_FOLDED,    /* in [-1, 1] whatever r is */
    RANGE_RAISED     /* plan/hybrid.h tells */
};

/* X(enumerator, name, default of sharpness, erosion at most, range, traits, call in shaders). A 0
   as sharpness or erosion: the fractal does not read that member. The call is without its last
   arguments, which recipe/shader_text.c adds. */
#define SCARP_FRACTAL_LIST(X)                                                                      \
    X(FBM, "fbm", 0.0f, 0.0f, RANGE_SUM, 0, "with_fbm(s, n")                                       \
    X(TURBULENCE, "turbulence", 0.0f, 0.0f, RANGE_MAGNITUDE, FRACTAL_CREASES,                      \
      "with_turbulence(s, o, n")                                                                   \
    X(RIDGED, "ridged", 0.0f, 0.0f, RANGE_UNIT, FRACTAL_CREASES, "with_ridged(s, o, n")            \
    X(EROSION, "erosion", 0.0f, 0x1p24f, RANGE_SUM, FRACTAL_SLOPES | FRACTAL_OWN_SLOPES,           \
      "with_erosion(s, o, l, n")                                                                   \
    X(PINGPONG, "pingpong", 2.0f, 0.0f, RANGE_FOLDED, FRACTAL_CREASES, "with_pingpong(s, o, l, n") \
    X(HYBRID, "hybrid", 0.7f, 0.0f, RANGE_RAISED, FRACTAL_CREASES, "with_hybrid(s, o, l, n")       \
    X(SWISS, "swiss", 0.15f, 0.0f, RANGE_UNIT, FRACTAL_SLOPES | FRACTAL_BENDS | FRACTAL_CREASES,   \
      "swiss(s, o, l.inverse_weight, n")                                                           \
    X(JORDAN, "jordan", 0.35f, 1.0f, RANGE_SQUARE, FRACTAL_SLOPES | FRACTAL_BENDS,                 \
      "jordan(s, o, l.erosion, k == 0u, n")

/* How many enumerators scarp.h has of each kind. Numbers below have names and pass the checks. */
#define SCARP_ONE_MORE(...) +1
enum {
    SCARP_BASES = SCARP_BASIS_LIST(SCARP_ONE_MORE),
    SCARP_FRACTALS = SCARP_FRACTAL_LIST(SCARP_ONE_MORE),
    SCARP_FADES = SCARP_CUBIC + 1
};
#undef SCARP_ONE_MORE

struct fractal_traits {
    float sharpness; /* its default */
    float most_erosion;
    enum fractal_range range;
    unsigned traits;
};

/* The functions below take enumerators that exist. With one that a compiler knows, they cost
   nothing. */

static inline int basis_has(enum scarp_basis basis, unsigned trait)
{
#define TRAITS(enumerator, name, word, traits) [SCARP_##enumerator] = traits,
    static const unsigned char of[] = {SCARP_BASIS_LIST(TRAITS)};
#undef TRAITS
    return (of[basis] & trait) != 0;
}

static inline const struct fractal_traits *fractal_row(enum scarp_fractal fractal)
{
#define TRAITS(enumerator, name, sharpness, most_erosion, range, traits, call)                     \
    [SCARP_##enumerator] = {sharpness, most_erosion, range, traits},
    static const struct fractal_traits rows[] = {SCARP_FRACTAL_LIST(TRAITS)};
#undef TRAITS
    return &rows[fractal];
}

static inline int fractal_has(enum scarp_fractal fractal, unsigned trait)
{
    return (fractal_row(fractal)->traits & trait) != 0;
}

/* Whether a basis blends what is drawn at the corners of cells. */
static inline int blends_corners(enum scarp_basis basis)
{
    return basis_has(basis, BASIS_BLENDS);
}

/* Whether octaves of the fractal look at positions that those before have bent. */
static inline int fractal_bends(enum scarp_fractal fractal)
{
    return fractal_has(fractal, FRACTAL_BENDS);
}

/* How many axes the noise can repeat along: from x on. */
static inline int basis_axes_with_period(enum scarp_basis basis, int dimensions)
{
    return dimensions == 2 && basis_has(basis, BASIS_TRIANGLES) ? 1 : dimensions;
}

/* Whether values jump anywhere, as the header says under "Jumps". */
static inline int noise_jumps(const struct scarp_noise *noise)
{
    for (; noise != NULL; noise = noise->warp) {
        const unsigned by_slopes =
            (noise->octaves > 1.0f && fractal_has(noise->fractal, FRACTAL_SLOPES) ? BASIS_CREASES
                                                                                  : 0) |
            (fractal_has(noise->fractal, FRACTAL_OWN_SLOPES) ? BASIS_LENGTHS_JUMP : 0);
        if (basis_has(noise->basis, BASIS_JUMPS | by_slopes)) {
            return 1;
        }
    }
    return 0;
}

#endif
