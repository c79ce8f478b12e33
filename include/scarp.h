/* SPDX-License-Identifier: MIT
 *
 * scarp: noise and its exact derivatives for arrays of points.
 *
 *     struct scarp_noise noise = {.seed = 42, .frequency = 0.01, .octaves = 6};
 *     struct scarp_samples out = {.value = height, .dx = dx, .dy = dy};
 *     enum scarp_status status = scarp_sample2(&noise, count, x, y, &out);
 *
 * This file is the whole public interface, its contracts, and the only source of the version. It
 * has, in this order:
 *
 *     What holds everywhere    arrays, errors, numbers, bits, threads, structures, versions
 *     Noise                    struct scarp_noise: what to sample
 *     Samples                  scarp_sample2 and its like: values and derivatives at points
 *     Grids                    scarp_grid2, scarp_grid3; scarp_normals
 *     Range, check, plan       scarp_range, scarp_noise_check, scarp_noise_fault, scarp_plan_make,
 *                              scarp_vector_plan_make
 *     More of a noise          scarp_vector2, scarp_curl2, scarp_cells2 and their like
 *     The chain rule           functions of samples: scarp_add, scarp_mix, scarp_smooth_max, ...
 *     Gullies                  erosion as a function of the place
 *     Recipes                  noises composed in a text
 *     Shaders                  the constants for scarp.glsl, scarp.hlsl and scarp.wgsl
 *     Words, instruction sets  names of enumerators, the version, kernel sets
 *     Formulas                 the definition of every number, at the end
 *
 * A title in quotes, as in "Warps", is a section of the formulas.
 */
#ifndef SCARP_H
#define SCARP_H

/*
 * What holds everywhere
 *
 * Names. A call with a 2 in its name works in the plane, one with a 3 in space (but scarp_apply1
 * and scarp_apply2 take functions of 1 and 2 arguments). Calls that end in _f64 take double
 * coordinates, for large worlds. The others take floats.
 *
 * Arrays. A call for `count` points reads and writes arrays of at least `count` elements. An array
 * needs no alignment beyond that of its type. An output that is NULL is skipped. An output of
 * floats may be the very same array as an input of floats (in place), except in calls for recipes.
 * Outputs must not overlap anything else, double coordinates included.
 *
 * Errors. Calls that can fail return an enum scarp_status. A call checks its arguments before it
 * writes anything: on an error the outputs are untouched. Some calls write something on an error,
 * for example the name of the member at fault. Their comments say so. A call for 0 points succeeds,
 * whatever its other arguments are. Four rules are not repeated below:
 *
 *     SCARP_ERROR_SIZE         the arrays would not fit into the address space
 *     SCARP_ERROR_UNSUPPORTED  a reserved member is in use: a number that is not 0, or a pointer
 *                              that is not NULL
 *     SCARP_ERROR_UNSUPPORTED  a call in the plane is asked for an output along z
 *     SCARP_ERROR_UNSUPPORTED  the library was compiled to other operations than its source has
 *                              (see "Bits"), and the call computes something
 *
 * Numbers. Where a coordinate is NaN or infinite, or a position overflows to infinity, every output
 * of that point is NaN. Other points are not affected.
 *
 * Bits. The same call gives the same bits on every processor, instruction set, compiler and
 * optimisation level. Only the payload of a NaN may differ. A compiler has to keep to the
 * operations of the source for that. Options of clang let it do otherwise without a macro that
 * tells, such as fusing of operations by -ffp-contract=fast, which CMake and the command in
 * scarp_single.c keep off, or -fassociative-math, -freciprocal-math and -fno-signed-zeros. The
 * first call finds out by a few sums. Where the kernel set that it would take fails, or the code
 * around it, all calls that compute return SCARP_ERROR_UNSUPPORTED.
 *
 * One value. A noise has one value at a point. It does not depend on the place of the point in the
 * array, the length of the array, the other points, or which outputs are asked for.
 *
 * Floating-point mode. The caller's mode (flush to zero, denormals are zero, rounding direction,
 * unmasked exceptions) does not change a result, and a call does not change the mode. On processors
 * other than x86 and AArch64 that holds for the rounding direction. There, the rest of the mode
 * must be at its default.
 *
 * Threads. Any thread may call any function at any time. No call allocates memory, prints, reads
 * the environment, or changes errno.
 *
 * Stack. A call takes less than 48 KiB of stack, with every kernel set, so a thread or a fiber with
 * 64 KiB will do. That holds for code compiled with -O1 and above, and for hardened code
 * (-fstack-protector-strong, -fstack-clash-protection, -fcf-protection); it was measured with gcc
 * 12 and with clang 14 and 19. Kernels that are compiled without optimisation take more.
 *
 * Structures. Zero a structure before you fill it in: `struct scarp_noise noise = {0};`, a
 * designated initialiser, or memset. In C++ write `scarp_noise noise{};`, or in C++20 a designated
 * initialiser; C++ compilers warn of memset. Reserved members, named spare, have no meaning yet.
 * Later versions give them meanings, and keep the sizes of structures and the places of members.
 * Because this version refuses reserved members in use, it never misunderstands a program that was
 * built for a later one. scarp.hpp has the calls with spans, for C++20.
 *
 * Versions. Once the major version is 1, versions promise three things:
 *
 * - Source: a program that compiles with a version compiles with later ones of the same major
 *   version. Names that start with scarp_ and SCARP_ may be added.
 * - Binary interface: a program runs, without being built again, with a shared library of the same
 *   major version that is not older than the one it was built for. The SONAME tells that version.
 * - Bits: a noise has the same values and derivatives, to the bit, in all versions of the same
 *   major version, so a world can be continued. Another order of operations, another hash, or the
 *   correction of a wrong value is a new major version.
 *
 * While the major version is 0, a minor version counts as a major one: 0.2.1 keeps all that 0.2.0
 * promises, 0.3.0 may not. The changelog says what changed.
 */

#include <stddef.h>
#include <stdint.h>

#define SCARP_VERSION_MAJOR 0
#define SCARP_VERSION_MINOR 2
#define SCARP_VERSION_PATCH 0

/* A shared library exports the calls: it is compiled with SCARP_BUILDING_SHARED, and a program that
   uses it may define SCARP_SHARED. A static copy exports nothing if it is compiled with
   -fvisibility=hidden, so every module of a process can have a copy of its own. */
#if defined(_WIN32) && defined(SCARP_BUILDING_SHARED)
#define SCARP_API __declspec(dllexport)
#elif defined(_WIN32) && defined(SCARP_SHARED)
#define SCARP_API __declspec(dllimport)
#elif defined(__GNUC__) && (defined(SCARP_BUILDING_SHARED) || defined(SCARP_SHARED))
#define SCARP_API __attribute__((visibility("default")))
#else
#define SCARP_API
#endif

/* From C++14 on, this makes 0 the default of a member. Elsewhere it is nothing. Structures that
   calls write as a whole (plans, recipes, constants of shaders) go without, so declaring one takes
   no time. */
#if defined(__cplusplus) &&                                                                        \
    (__cplusplus >= 201402L || (defined(_MSVC_LANG) && _MSVC_LANG >= 201402L))
#define SCARP_ZERO = {}
#else
#define SCARP_ZERO
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum scarp_status {
    SCARP_OK = 0,
    SCARP_ERROR_NULL,       /* a pointer that the call needs is NULL */
    SCARP_ERROR_ENUM,       /* an enumerator that does not exist */
    SCARP_ERROR_PARAMETER,  /* a number that is not finite, or outside its documented interval */
    SCARP_ERROR_SIZE,       /* a count so large that its arrays cannot exist in memory */
    SCARP_ERROR_UNSUPPORTED /* a request that this version, build, call or processor cannot serve */
};

/*
 * Noise
 *
 * A basis is noise on a lattice, whose cells have the edge 1. An octave is the basis at `frequency`
 * cells per unit of input, turned and moved. Octave 0 has the largest cells and comes first. A
 * fractal makes one value of the octaves. A warp is another noise, which displaces the point first.
 * Input means the coordinates of the points. You choose their unit.
 */

/* The noise of one octave. Each is defined on a lattice, which repeats after 2^32 cells along each
   axis. */
enum scarp_basis {
    SCARP_GRADIENT,  /* Perlin's gradient noise: 0 on every lattice point, so with frequency 1 at
                        all whole coordinates. See "Gradient and value noise". */
    SCARP_VALUE,     /* value noise: a value on every lattice point, uniform in [-1, 1] */
    SCARP_SIMPLEX,   /* simplex noise (Perlin 2001): gradients on triangles and tetrahedra. See
                        "Simplex". */
    SCARP_CELL_F1,   /* cellular noise (Worley 1996): the distance to the nearest feature. See
                        "Cells" for this and the next four. */
    SCARP_CELL_F2,   /* the distance to the second nearest feature */
    SCARP_CELL_EDGE, /* F2 less F1: 0 on the borders between cells */
    SCARP_CELL_SOFT, /* a smooth F1, whose Hessian is continuous */
    SCARP_CELL_VALUE /* a value for each cell, uniform in [-1, 1] */
};

/* How gradient and value noise blend between lattice points, for t in [0, 1] across a cell. Other
   bases ignore it. */
enum scarp_fade {
    SCARP_QUINTIC, /* 6t^5 - 15t^4 + 10t^3: the Hessian is continuous */
    SCARP_CUBIC    /* 3t^2 - 2t^3: the gradient is continuous, the Hessian jumps between cells */
};

/* How octaves are summed. See "Fractals" and, for the last two, "Fractals that bend". */
enum scarp_fractal {
    SCARP_FBM,        /* fractional Brownian motion: the weighted sum of octaves */
    SCARP_TURBULENCE, /* the weighted sum of their magnitudes: billows with creases (Perlin 1985) */
    SCARP_RIDGED,     /* ridged multifractal (Musgrave 1994): creases become ridges. Each octave is
                         weighted by the ones before, so valleys are smooth. */
    SCARP_EROSION,    /* fBm whose octaves are damped where the sum of slopes is steep (Quilez
                         2008): ridges and eroded flanks. No Hessian. */
    SCARP_PINGPONG,   /* the weighted sum of octaves that are folded to and fro, which draws contour
                         lines (FastNoise Lite) */
    SCARP_HYBRID,     /* hybrid multifractal (Musgrave 1994): each octave is weighted by the product
                         of the ones before, so valleys are smooth and heights rough */
    SCARP_SWISS,      /* ridges whose octaves are bent downhill, by the slopes of the octaves before
                         (de Carpentier 2012). No Hessian, no dphase. */
    SCARP_JORDAN      /* squared octaves that are bent, and damped where the ground is flat (de
                         Carpentier 2012). No Hessian, no dphase. */
};

/* What to sample. All zero is valid: one octave of quintic gradient noise with seed 0, one lattice
   cell per unit of input. A number that is 0 stands for its default. */
struct scarp_noise {
    enum scarp_basis basis SCARP_ZERO;
    enum scarp_fade fade SCARP_ZERO;
    enum scarp_fractal fractal SCARP_ZERO;

    /* nonzero turns the axes between octaves, which hides the directions of the lattice */
    uint32_t rotate SCARP_ZERO;

    uint64_t seed SCARP_ZERO; /* all 64 bits count. See "Seeds". */

    /* lattice cells per unit of input. Default 1. That of every octave lies in [2^-32, 2^48]. */
    double frequency SCARP_ZERO;

    /* how many octaves, in (0, 32]. Default 1. A fraction fades the last one in. See "Octaves". */
    float octaves SCARP_ZERO;

    /* frequency ratio between octaves, in [1/16, 16]. Default 2. */
    float lacunarity SCARP_ZERO;

    /* amplitude ratio between octaves, in [1/16, 16]. Default 0.5. */
    float gain SCARP_ZERO;

    /* scales every output; its magnitude is in [2^-24, 2^24]. Default 1. */
    float amplitude SCARP_ZERO;

    /* SCARP_EROSION: how strongly slopes damp octaves; SCARP_JORDAN: how much flat ground damps
       them, at most 1. In [2^-24, 2^24]. Default 1. */
    float erosion SCARP_ZERO;

    /* SCARP_GRADIENT: how far gradients turn, in turns, any finite number. Default 0. Other bases
       must have 0. See "Flow". */
    float phase SCARP_ZERO;

    /* cellular noise: how far features stray from the middles of their cells, in (0, 1]. Default
       1. */
    float jitter SCARP_ZERO;

    /* SCARP_PINGPONG: how often octaves are folded, 2 by default; SCARP_HYBRID: how high they lie,
       0.7 by default; SCARP_SWISS and SCARP_JORDAN: how far they are bent, 0.15 and 0.35 by
       default. For these four in [2^-8, 2^8]. Other fractals ignore it, and take numbers in
       [2^-24, 2^24]. */
    float sharpness SCARP_ZERO;

    /* cells of octave 0, in [1, 2^30], after which the noise repeats along each axis; 0: never.
       Calls in the plane ignore period[2]. See "Periods". */
    uint32_t period[3] SCARP_ZERO;

    /* a level of detail: amplitudes are those of a sum of this many octaves, in [octaves, 32]. 0:
       octaves. See "Octaves". */
    float of_octaves SCARP_ZERO;

    /* displaces positions; NULL: nothing does. It must exist as long as calls use this noise. See
       "Warps". */
    const struct scarp_noise *warp SCARP_ZERO;

    /* what scarp_plan_make made of this noise, or scarp_vector_plan_make of a warp; NULL: none.
       Results do not depend on it. Each noise brings its own, and so does its warp. */
    const struct scarp_plan *plan SCARP_ZERO;

    /* nonzero gives octave 0 an offset that the seed draws, as other octaves have it. Without one,
       every seed has a lattice point at (0, 0), where gradient noise is 0 and ridges are high. See
       "Octaves". */
    uint32_t offset_first SCARP_ZERO;

    /* reserved: 0. 192 bytes in all. */
    uint32_t spare_word SCARP_ZERO;
    uint32_t spare[(192 - 88 - 2 * sizeof(void *)) / 4] SCARP_ZERO;
};

/*
 * Samples
 */

/* Where results go: arrays of `count` floats. A NULL member is skipped. A call that asks for no
   derivative does not pay for derivatives. A call that asks for no second derivative does not pay
   for second derivatives. */
struct scarp_samples {
    float *value SCARP_ZERO;

    /* gradient, per unit of input (not per lattice cell) */
    float *dx SCARP_ZERO;
    float *dy SCARP_ZERO;
    float *dz SCARP_ZERO;

    /* Hessian, per unit of input squared */
    float *dxx SCARP_ZERO;
    float *dxy SCARP_ZERO;
    float *dxz SCARP_ZERO;
    float *dyy SCARP_ZERO;
    float *dyz SCARP_ZERO;
    float *dzz SCARP_ZERO;

    float *dphase SCARP_ZERO;   /* derivative with respect to the phase, per turn */
    float *spare[5] SCARP_ZERO; /* reserved: NULL. 16 pointers in all. */
};

/*
 * scarp_sample2 - sample noise at points of the plane
 *
 * For each i < count, out->value[i] is the noise at (x[i], y[i]). out->dx[i], dy[i], dxx[i], dxy[i]
 * and dyy[i] are the exact partial derivatives of that value, in closed form. dphase[i] is its
 * derivative with respect to the phase.
 *
 * Which derivatives a noise has:
 *
 *     gradient  every noise
 *     Hessian   noise whose fractal, and the fractals of all its warps, are other than
 *               SCARP_EROSION, SCARP_SWISS and SCARP_JORDAN
 *     dphase    noise of SCARP_GRADIENT whose fractal is other than SCARP_SWISS and SCARP_JORDAN
 *
 * Coordinates: positions are computed in float, so detail fades as a position nears 2^23 cells of
 * an octave. Use scarp_sample2_f64 for large worlds. Further out the noise is still defined: see
 * "Rounding".
 *
 * Range: [-1, 1] with the defaults. scarp_range tells that of any noise.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `noise`, `out`, `x` or `y` is NULL
 *     SCARP_ERROR_UNSUPPORTED  the noise does not have a derivative that is asked for
 *     others                   as scarp_noise_check
 */
SCARP_API enum scarp_status scarp_sample2(const struct scarp_noise *noise, size_t count,
                                          const float *x, const float *y,
                                          const struct scarp_samples *out);

/* scarp_sample3 - like scarp_sample2, but in space, with all outputs */
SCARP_API enum scarp_status scarp_sample3(const struct scarp_noise *noise, size_t count,
                                          const float *x, const float *y, const float *z,
                                          const struct scarp_samples *out);

/*
 * scarp_sample2_f64 - like scarp_sample2, but with double coordinates
 *
 * Positions are computed in double and split into cell and fraction before anything is rounded to
 * float, so detail does not fade far from the origin: 2^40 cells away the fraction still has 12
 * bits. See "Rounding". Grids have these bits, and shaders have those of scarp_sample2. The two
 * differ, also where coordinates are exact in float: by up to 2e-4 at 1024 cells from the origin.
 * So take float calls for what must agree with a shader, and doubles or grids for the rest. Where
 * axes are turned (`rotate`), points take up to twice the time if they are 2^26 cells of an octave
 * from the origin, or in a call with a few such points.
 */
SCARP_API enum scarp_status scarp_sample2_f64(const struct scarp_noise *noise, size_t count,
                                              const double *x, const double *y,
                                              const struct scarp_samples *out);

/* scarp_sample3_f64 - like scarp_sample2_f64, but in space, with all outputs */
SCARP_API enum scarp_status scarp_sample3_f64(const struct scarp_noise *noise, size_t count,
                                              const double *x, const double *y, const double *z,
                                              const struct scarp_samples *out);

/*
 * Grids
 */

/* A uniform grid. Along axis d, sample (i, j, k) lies at
   origin[d] + (double)(first[d] + index) * step[d], where index is i, j or k, computed in double in
   this order. Calls in the plane ignore the elements 2 and slice_stride. */
struct scarp_grid {
    /* finite; a step may be 0 or negative */
    double origin[3] SCARP_ZERO;
    double step[3] SCARP_ZERO;

    int64_t first[3] SCARP_ZERO; /* every first + index lies in [-2^53, 2^53] */
    size_t count[3] SCARP_ZERO;  /* samples along each axis */

    /* floats from one row to the next, at least count[0]; 0: count[0] */
    size_t row_stride SCARP_ZERO;

    /* floats from one slice to the next, at least those from the first of a slice to its last; 0:
       count[1] rows */
    size_t slice_stride SCARP_ZERO;

    /* reserved: 0. 192 bytes in all. */
    uint32_t spare[(192 - 72 - 5 * sizeof(size_t)) / 4] SCARP_ZERO;
};

/*
 * scarp_grid2 - sample noise on a uniform grid of the plane
 *
 * For each i < count[0] and j < count[1], element j * row_stride + i of each array in `out` has, to
 * the bit, what scarp_sample2_f64 gives at the coordinates of sample (i, j). So a world is the same
 * whatever tiles it is computed in: give each tile its `first`, and all of them the same origin and
 * step. The call writes nothing between the rows.
 *
 * Speed: grids are much faster than arrays of points where neighbouring samples share lattice
 * cells, axes are not turned, and rows are longer than a few dozen samples. So let x be the long
 * axis: a chunk of 256 x 16 x 16 samples of gradient noise takes down to a quarter of the time of
 * one of 16 x 256 x 16; simplex noise takes half, noise with a warp 0.5 to 0.7 of it. A single
 * octave of fBm with 24 MiB of results or more is written fastest if the arrays, and their rows,
 * begin at multiples of 64 bytes. A call without outputs only makes its checks.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `noise`, `grid` or `out` is NULL. After that, the call succeeds if a
 *                              count of the grid is 0, whatever the other members are.
 *     SCARP_ERROR_PARAMETER    an origin or step is not finite, an index is outside its interval,
 *                              or a stride is shorter than a row or a slice
 *     others                   as scarp_sample2
 */
SCARP_API enum scarp_status scarp_grid2(const struct scarp_noise *noise,
                                        const struct scarp_grid *grid,
                                        const struct scarp_samples *out);

/* scarp_grid3 - like scarp_grid2, but in space, as scarp_sample3_f64, with all outputs. Sample (i,
   j, k) is element k * slice_stride + j * row_stride + i. */
SCARP_API enum scarp_status scarp_grid3(const struct scarp_noise *noise,
                                        const struct scarp_grid *grid,
                                        const struct scarp_samples *out);

/*
 * scarp_normals - unit normals of the surface z = height_scale * value, from the gradient
 *
 * For each i < count, (nx[i], ny[i], nz[i]) is (-s dx[i], -s dy[i], 1) divided by its length, with
 * s = height_scale. x and y are the axes of the noise's input, z points up. dx and dy are outputs
 * of a sample call. s is in units of input per unit of value. Normals are computed in double and
 * rounded once: each component is within 1 unit in the last place of the exact one. Where an input
 * is NaN or infinite, all components of the normal are NaN.
 *
 * Every array holds `count` floats. Each of nx, ny and nz may be NULL and is then skipped.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         dx or dy is NULL
 *     SCARP_ERROR_PARAMETER    height_scale is not finite
 */
SCARP_API enum scarp_status scarp_normals(size_t count, const float *dx, const float *dy,
                                          float height_scale, float *nx, float *ny, float *nz);

/*
 * Range, check, plan
 */

/*
 * scarp_range - the interval that values never leave
 *
 * *lowest <= value <= *highest for every point, rounding included. `dimensions` is 2 or 3. Use it
 * to map heights to integers: all tiles then agree, and so do levels of detail (with `of_octaves`)
 * and the frames of a loop (phases from 1 to 2).
 *
 *     fBm, erosion, ping-pong           from -|amplitude| to |amplitude|
 *     turbulence, ridged, Swiss, Jordan between 0 and amplitude
 *     hybrid                            from amplitude across 0. With the default sharpness and
 *                                       gains up to 0.5 it ends at -0.23 amplitude at most. With a
 *                                       sharpness of 1 it ends at 0, with a larger one before 0.
 *
 * With a phase that is not 0, noise reaches further, except ridged, Swiss and ping-pong noise: see
 * "Flow". With `of_octaves` the interval is that of the longer sum. Fewer octaves stay within it
 * and reach less of it. Only the lower end of hybrid noise with a sharpness above 1 depends on
 * `octaves`: there it is that of the octaves summed.
 *
 * Errors: SCARP_ERROR_NULL if a pointer is NULL; others as scarp_noise_check.
 */
SCARP_API enum scarp_status scarp_range(const struct scarp_noise *noise, int dimensions,
                                        float *lowest, float *highest);

/*
 * scarp_noise_check - whether calls take a noise, and if not, which member is at fault
 *
 * Returns what every call in 2 or 3 `dimensions` returns for this noise, as far as the noise alone
 * decides. A call may still refuse its other arguments, or outputs that this noise does not have.
 *
 * *member becomes the name of the first member at fault, as this header spells it: "octaves",
 * "period[1]" ("spare" has no index, and stands for spare_word, too). A member of a warp has its
 * path: "warp.octaves", "warp.warp.period[1]". *member becomes NULL if no member is at fault: on
 * success, and if `noise` is NULL or `dimensions` is wrong. The call always writes it, also on an
 * error. The text is static. `member` may be NULL. scarp_noise_fault says why.
 *
 * Errors. The first that applies is returned:
 *
 *     SCARP_ERROR_NULL         `noise` is NULL
 *     SCARP_ERROR_ENUM         basis, fade or fractal is unknown
 *     SCARP_ERROR_PARAMETER    a number is outside its interval, in the order of the members
 *     SCARP_ERROR_PARAMETER    the frequency of the last octave is outside [2^-32, 2^48]. *member
 *                              is "octaves", since fewer octaves always help.
 *     SCARP_ERROR_UNSUPPORTED  a reserved member is in use
 *     SCARP_ERROR_UNSUPPORTED  a phase with a basis other than SCARP_GRADIENT
 *     SCARP_ERROR_PARAMETER    `dimensions` is neither 2 nor 3
 *     SCARP_ERROR_PARAMETER    a period: see "Periods"
 *     SCARP_ERROR_UNSUPPORTED  a period where axes are turned (`rotate`, with more than one octave)
 *     SCARP_ERROR_UNSUPPORTED  a period along y of SCARP_SIMPLEX in the plane
 *     its own status           a warp is at fault; the warp of the noise comes before its own warp
 *     SCARP_ERROR_UNSUPPORTED  there are more than four warps. *member is that of the fifth one,
 *                              "warp.warp.warp.warp.warp".
 */
SCARP_API enum scarp_status scarp_noise_check(const struct scarp_noise *noise, int dimensions,
                                              const char **member);

/*
 * scarp_noise_fault - why calls refuse a noise, in words
 *
 * Returns the reason why calls in 2 or 3 `dimensions` refuse this noise: "turned axes cannot
 * repeat", "outside (0, 32]". Returns NULL if they do not. The text is static. It is a clause about
 * the member, without a full stop, so that "member: text" can be shown. *member becomes what
 * scarp_noise_check says. `member` may be NULL.
 *
 * A noise that is not at fault may still lack what a call asks for: derivatives up to `order`,
 * which is 0, 1 or 2, and the derivative with respect to the phase if `dphase` is not 0. (The
 * Jacobian of a velocity needs derivatives of order 2.) Calls return SCARP_ERROR_UNSUPPORTED then.
 * The text says so, and *member becomes "fractal" or "basis", in a warp with its path.
 *
 * The text also says if `noise` is NULL, or if `dimensions` or `order` is none of these numbers.
 */
SCARP_API const char *scarp_noise_fault(const struct scarp_noise *noise, int dimensions, int order,
                                        int dphase, const char **member);

/*
 * scarp_grid_fault - why calls refuse a grid, in words
 *
 * As scarp_noise_fault, but of the grid of a call in 2 or 3 `dimensions`. *member becomes the name
 * of the member at fault: "step[1]", "row_stride". A grid with a count of 0 is not at fault.
 */
SCARP_API const char *scarp_grid_fault(const struct scarp_grid *grid, int dimensions,
                                       const char **member);

/* The constants of a noise, which every call without a plan computes anew. Its bytes are the
   library's business. The caller owns it, and may copy it, as a whole, to wherever a uint64_t may
   stand. */
struct scarp_plan {
    uint64_t first;
    unsigned char rest[12288 - 8];
};

/*
 * scarp_plan_make - make the plan of a noise, for many calls with few points
 *
 * To compute the constants of a noise takes about as long as 15 points (one octave) or 10 (eight
 * octaves), and with a phase up to three times as long. With noise->plan = plan, calls take them
 * from *plan, and give the same bits. So do all calls in as many `dimensions`, 2 or 3, as the plan
 * was made for, except those of vector noise (scarp_vector_plan_make). One plan serves all outputs,
 * floats and doubles, every kernel set, and any number of threads at a time. Calls only read it.
 *
 *     struct scarp_plan plan;
 *     struct scarp_noise noise = {.octaves = 8.0f};
 *     if (scarp_plan_make(&noise, 2, &plan) == SCARP_OK) {
 *         noise.plan = &plan;
 *     }
 *
 * A plan that does not fit does no harm. A call compares the noise that the plan was made of with
 * its own, byte for byte except `warp` and `plan`. If they differ, or the dimensions or the version
 * of the library do, the call does without the plan. So a plan may stay where it is while the noise
 * is changed.
 *
 * A plan has nothing of the warp of its noise, so it stays good when the warp changes. A warp
 * brings a plan of its own, of vector noise. Where a noise of the chain brings none that fits, the
 * call computes the constants of that noise only.
 *
 * Before the plan is first made, *plan may have any bytes: zeros, or what was in memory. But the
 * behaviour is undefined if a good plan was changed in part.
 *
 * No other thread may use *plan while it is made. On an error *plan is left as it was.
 *
 * Errors: SCARP_ERROR_NULL if `noise` or `plan` is NULL; others as scarp_noise_check.
 */
SCARP_API enum scarp_status scarp_plan_make(const struct scarp_noise *noise, int dimensions,
                                            struct scarp_plan *plan);

/*
 * scarp_vector_plan_make - make the plan of vector noise: of a warp, or for scarp_vector2 and its
 * like
 *
 * As scarp_plan_make, but *plan has the constants of the components that `noise` has as vector
 * noise, in 2 or 3 `dimensions`. With noise->plan = plan, they serve calls for noises whose warp
 * this noise is, at any depth, and scarp_vector2, scarp_vector3 and scarp_curl3 of this noise. No
 * other call uses such a plan, and these use no other.
 *
 *     struct scarp_plan plans[2];
 *     struct scarp_noise bend = {.frequency = 0.01, .amplitude = 20.0f};
 *     struct scarp_noise noise = {.frequency = 0.02, .octaves = 8.0f, .warp = &bend};
 *     if (scarp_vector_plan_make(&bend, 2, &plans[0]) == SCARP_OK &&
 *         scarp_plan_make(&noise, 2, &plans[1]) == SCARP_OK) {
 *         bend.plan = &plans[0];
 *         noise.plan = &plans[1];
 *     }
 *
 * A plan has room for 50 octaves. Gradient and value noise have at most 32, which all components
 * share. With other bases, each component has its own. If these are more than 50 in all, the result
 * is SCARP_OK, but no call uses the plan.
 *
 * Errors: as scarp_plan_make.
 */
SCARP_API enum scarp_status scarp_vector_plan_make(const struct scarp_noise *noise, int dimensions,
                                                   struct scarp_plan *plan);

/*
 * More of a noise: vectors, velocities, cells
 */

/*
 * scarp_vector2 - sample all components of vector noise at points of the plane
 *
 * For each i < count, out[c].value[i] is component c (0 or 1) of the vector noise that `noise`
 * makes, with its warp, at (x[i], y[i]). out[c].dx[i] and so on are the exact derivatives of that
 * value. See "Vector noise".
 *
 * A warp moves points by vector noise. Noise with the warp w has the value, in every bit, that it
 * has without the warp at x[i] + out[0].value[i], y[i] + out[1].value[i], with `out` of a call for
 * w. So you can bend any expression of several noises at once. Its gradient follows by the Jacobian
 * of these sums.
 *
 * `out` has two elements. Components may be asked for different outputs. Each component pays for
 * the highest derivative that any is asked for, and is computed even if its arrays are all NULL.
 * The call ignores noise.plan.
 *
 * Coordinates, range and errors are as for scarp_sample2. An element of `out` that is in error
 * makes the call fail.
 */
SCARP_API enum scarp_status scarp_vector2(const struct scarp_noise *noise, size_t count,
                                          const float *x, const float *y,
                                          const struct scarp_samples out[2]);

/* scarp_vector3 - like scarp_vector2, but in space: three components, with all outputs */
SCARP_API enum scarp_status scarp_vector3(const struct scarp_noise *noise, size_t count,
                                          const float *x, const float *y, const float *z,
                                          const struct scarp_samples out[3]);

/* scarp_vector2_f64 - like scarp_vector2, but with double coordinates, as scarp_sample2_f64 */
SCARP_API enum scarp_status scarp_vector2_f64(const struct scarp_noise *noise, size_t count,
                                              const double *x, const double *y,
                                              const struct scarp_samples out[2]);

/* scarp_vector3_f64 - like scarp_vector3, but with double coordinates, as scarp_sample3_f64 */
SCARP_API enum scarp_status scarp_vector3_f64(const struct scarp_noise *noise, size_t count,
                                              const double *x, const double *y, const double *z,
                                              const struct scarp_samples out[3]);

/* A velocity and its Jacobian at a point: arrays of `count` floats. vxy is the derivative of vx
   with respect to y, and so on. A NULL member is skipped. A call that asks for nothing of the
   Jacobian does not pay for second derivatives. */
struct scarp_flow {
    float *vx SCARP_ZERO;
    float *vy SCARP_ZERO;
    float *vz SCARP_ZERO;
    float *vxx SCARP_ZERO;
    float *vxy SCARP_ZERO;
    float *vxz SCARP_ZERO;
    float *vyx SCARP_ZERO;
    float *vyy SCARP_ZERO;
    float *vyz SCARP_ZERO;
    float *vzx SCARP_ZERO;
    float *vzy SCARP_ZERO;
    float *vzz SCARP_ZERO;
    float *spare[4] SCARP_ZERO; /* reserved: NULL. 16 pointers in all. */
};

/*
 * scarp_curl2 - a velocity without divergence at points of the plane
 *
 * For each i < count, (vx[i], vy[i]) of `out` is the curl of the noise at (x[i], y[i]): its
 * gradient turned by a quarter (Bridson, Hourihan and Nordenstam 2007),
 *
 *     v = (dy, -dx),   Jacobian (vxx, vxy; vyx, vyy) = (dxy, dyy; -dxx, -dxy),
 *
 * with the bits of scarp_sample2. Particles swirl along the contours of the noise, and neither
 * gather nor thin out: vyy is -vxx in every bit.
 *
 * The noise is the stream function, or potential. A velocity is in amplitudes per unit of input, so
 * `amplitude` and `frequency` both multiply it. Octave k of fBm has a_k f_k of the speed
 * ("Octaves"). With the defaults, gain 1/2 and lacunarity 2, all octaves are equally fast, and the
 * smallest eddies have most of the Jacobian. Take a gain below 1 / lacunarity, so that large eddies
 * carry the small ones. lacunarity^(-4/3), which is 0.4 for 2, is the gain of turbulent flow
 * (Kolmogorov 1941). One octave of gradient noise with amplitude and frequency 1 has a speed of
 * 1.27 (the root of the mean of squares), simplex noise 2.98. No interval is promised for
 * velocities: scarp_range tells that of the potential.
 *
 * The potential may have any basis and fractal, periods, a phase and warps. A phase lets the flow
 * change in time. Where the gradient jumps (at creases of fractals and of cellular noise), so does
 * the velocity. Its Jacobian is that of one side there. A noise without a Hessian has no Jacobian.
 *
 * Walls: another potential makes another flow without divergence. Let psi be the noise, and r a
 * ramp that is 0 on walls and 1 away from them. Then r psi has the velocity (r psi_y + r_y psi, -r
 * psi_x - r_x psi), which runs along the walls.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `noise`, `out`, `x` or `y` is NULL
 *     SCARP_ERROR_UNSUPPORTED  something of the Jacobian is asked for, and the noise or a warp has
 *                              no Hessian
 *     others                   as scarp_noise_check
 */
SCARP_API enum scarp_status scarp_curl2(const struct scarp_noise *noise, size_t count,
                                        const float *x, const float *y,
                                        const struct scarp_flow *out);

/*
 * scarp_curl3 - like scarp_curl2, but in space, with all outputs
 *
 * There are three potentials psi_0, psi_1, psi_2: the components of the vector noise that the noise
 * makes, each with the warp of the noise. With (i, j, k) = (0, 1, 2), (1, 2, 0) and (2, 0, 1),
 *
 *     v_i = d_j psi_k - d_k psi_j,   Jacobian d_m v_i = d_j d_m psi_k - d_k d_m psi_j.
 *
 * Each is one subtraction of floats that have the bits of scarp_vector3. So the trace vxx + vyy +
 * vzz is 0 but for the rounding of these three: computed exactly it is at most 2^-24 (|vxx| + |vyy|
 * + |vzz|). One octave of gradient noise with amplitude and frequency 1 has a speed of 1.66,
 * simplex noise 4.30. A call takes as long as one of scarp_vector3, and ignores noise.plan.
 */
SCARP_API enum scarp_status scarp_curl3(const struct scarp_noise *noise, size_t count,
                                        const float *x, const float *y, const float *z,
                                        const struct scarp_flow *out);

/* scarp_curl2_f64 - like scarp_curl2, but with double coordinates, as scarp_sample2_f64 */
SCARP_API enum scarp_status scarp_curl2_f64(const struct scarp_noise *noise, size_t count,
                                            const double *x, const double *y,
                                            const struct scarp_flow *out);

/* scarp_curl3_f64 - like scarp_curl3, but with double coordinates, as scarp_sample3_f64 */
SCARP_API enum scarp_status scarp_curl3_f64(const struct scarp_noise *noise, size_t count,
                                            const double *x, const double *y, const double *z,
                                            const struct scarp_flow *out);

/* What is near a point: arrays of `count` elements. A NULL member is skipped. Calls that ask for f1
   alone, or for nothing of the second feature, take less time. */
struct scarp_cells {
    /* the distances to the nearest feature and to the second nearest, in units of input */
    float *f1 SCARP_ZERO;
    float *f2 SCARP_ZERO;

    uint32_t *id SCARP_ZERO; /* a number drawn for the cell of the nearest feature */

    /* where the nearest feature is */
    float *x SCARP_ZERO;
    float *y SCARP_ZERO;
    float *z SCARP_ZERO;

    /* the gradient of f1 */
    float *dx1 SCARP_ZERO;
    float *dy1 SCARP_ZERO;
    float *dz1 SCARP_ZERO;

    /* the gradient of f2 */
    float *dx2 SCARP_ZERO;
    float *dy2 SCARP_ZERO;
    float *dz2 SCARP_ZERO;

    float *spare[4] SCARP_ZERO; /* reserved: NULL. 16 pointers in all. */
};

/*
 * scarp_cells2 - the cells of cellular noise around points of the plane
 *
 * For each i < count, the arrays of `out` tell of the features near (x[i], y[i]) that SCARP_CELL_F1
 * and its like are made of; see "Cells". They are the features of the noise's first octave: its
 * frequency, seed, jitter and period decide. The other members, the basis and the warp included,
 * must be valid and change nothing.
 *
 * - f1 and f2 are in units of input, so their gradients are unit vectors. At the feature itself
 *   gradients are 0.
 * - id is an even number, uniform below 2^32, the same all over the cell. SCARP_CELL_VALUE is made
 *   of it: its value is (int32_t)id / 2^31. Of all pairs of cells, one in 2^31 has equal ids. Cells
 *   that are periods apart always have equal ids.
 * - (x[i], y[i]) of `out` is the point less the way from the feature to it, computed in the
 *   precision of the coordinates and then rounded to float. The points of one cell agree on it but
 *   for rounding. Periods do not reduce it.
 *
 * Coordinates are as for scarp_sample2. Where other outputs are NaN, id is 0.
 *
 * Errors: SCARP_ERROR_NULL if `noise`, `out`, `x` or `y` is NULL; others as scarp_noise_check.
 */
SCARP_API enum scarp_status scarp_cells2(const struct scarp_noise *noise, size_t count,
                                         const float *x, const float *y,
                                         const struct scarp_cells *out);

/* scarp_cells3 - like scarp_cells2, but in space, with all outputs */
SCARP_API enum scarp_status scarp_cells3(const struct scarp_noise *noise, size_t count,
                                         const float *x, const float *y, const float *z,
                                         const struct scarp_cells *out);

/* scarp_cells2_f64 - like scarp_cells2, but with double coordinates, as scarp_sample2_f64 */
SCARP_API enum scarp_status scarp_cells2_f64(const struct scarp_noise *noise, size_t count,
                                             const double *x, const double *y,
                                             const struct scarp_cells *out);

/* scarp_cells3_f64 - like scarp_cells2_f64, but in space, with all outputs */
SCARP_API enum scarp_status scarp_cells3_f64(const struct scarp_noise *noise, size_t count,
                                             const double *x, const double *y, const double *z,
                                             const struct scarp_cells *out);

/*
 * The chain rule: functions of samples, with exact derivatives
 *
 * These functions combine samples as arrays: `a` and `b` hold the inputs, `out` the results. The
 * members of all three are arrays of `count` floats. A function computes every member that `out`
 * has: the value f(a) or f(a, b) at each point, and its derivatives by the chain rule. Where i and
 * j are axes, f_a, f_aa, ... the partial derivatives of f, and a_i, a_ij the derivatives of a:
 *
 *     f(a)      first: f_a a_i             second: f_a a_ij + (f_aa a_i) a_j
 *     f(a, b)   first: f_a a_i + f_b b_i   second: f_a a_ij + f_b b_ij + f_aa a_i a_j
 *                                                  + f_ab (a_i b_j + a_j b_i) + f_bb b_i b_j
 *
 * dphase is one more first derivative. The inputs may come from different calls, as long as all
 * derivatives are by the same coordinates. Everything is computed in float.
 *
 *     struct scarp_samples a = {.value = av, .dx = ax, .dy = ay};
 *     struct scarp_samples b = {.value = bv, .dx = bx, .dy = by};
 *     scarp_sample2(&hills, count, x, y, &a);
 *     scarp_sample2(&mountains, count, x, y, &b);
 *     scarp_smooth_max(count, &a, &b, 0.1f, &a);
 *
 * leaves the smooth union of both in the arrays of `a`, with its exact gradient.
 *
 * Speed: each function reads and writes every array once, so memory sets the pace of long arrays.
 * Work in chunks of about 4,096 points, sampling included. Then the arrays stay in the caches, and
 * the functions cost little beside the noise.
 *
 * Members: an output needs the same member of every input. A derivative also needs the values, and
 * a second derivative the first ones along its axes; scarp_affine and scarp_add need neither. (The
 * comments of scarp_apply1, scarp_apply2 and scarp_slope say what these need.) A function does not
 * read members that no output needs.
 *
 * Arrays: an output may be the very same array as any array that is read, of the same member or of
 * another. Outputs must not overlap anything else.
 *
 * NaN: where a number is NaN, every output that is computed from it is NaN. Other points are not
 * affected. scarp_min and scarp_max choose a value that is NaN, with its derivatives, over any
 * number. Infinities make NaN where they cancel, or are multiplied by 0.
 *
 * Products by 0: in scarp_multiply and scarp_mix, a product of two factors is 0 (+0) where one of
 * them is 0, even if the other one is NaN or infinite. So a mask hides what is behind it, where the
 * mask is 0 and level.
 *
 * Smoothness: C2 means that the Hessian of the result is continuous if the Hessians of the inputs
 * are. C0 means that the result is continuous and has creases. A result that is called neither has
 * as many derivatives as the inputs.
 *
 * Errors, of all functions here:
 *
 *     SCARP_ERROR_NULL         `a`, `b`, `m`, `function` or `out` is NULL, or an array that an
 *                              output needs
 *     SCARP_ERROR_PARAMETER    a number is not finite, or outside its interval
 */

/*
 * scarp_affine - `scale * a + offset`
 *
 * Derivatives are scale times those of a.
 */
SCARP_API enum scarp_status scarp_affine(size_t count, const struct scarp_samples *a, float scale,
                                         float offset, const struct scarp_samples *out);

/* scarp_add - `a + b`, in all members */
SCARP_API enum scarp_status scarp_add(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *b,
                                      const struct scarp_samples *out);

/*
 * scarp_multiply - `a * b`: a product is 0 where a factor is 0, even if the other one is NaN
 *
 * Derivatives are b a_i + a b_i and (b a_ij + a b_ij) + (a_i b_j + a_j b_i). The value and each of
 * these products are 0 where one of their factors is 0: b a_i is 0 where b or a_i is. Where b is 0
 * with all its derivatives, all outputs are 0.
 */
SCARP_API enum scarp_status scarp_multiply(size_t count, const struct scarp_samples *a,
                                           const struct scarp_samples *b,
                                           const struct scarp_samples *out);

/*
 * scarp_mix - `a` where `m` is 0, `b` where `m` is 1, and `a + m * (b - a)` between: slopes of `m`
 * count, too
 *
 * It is computed from the nearer end. m may leave [0, 1]. Let d = a - b in all members.
 * Where m > 1/2, let e = b and w = m - 1, elsewhere e = a and w = m. Then
 *
 *     value   e - w d
 *     first   e_i - (w d_i + d m_i)
 *     second  e_ij - ((w d_ij + d m_ij) + (d_i m_j + d_j m_i))
 *
 * and each product is 0 where one of its factors is 0: w d_i where w or d_i is, d m_i where d or
 * m_i is. So where m is 0, the value is that of a, to the bit. The derivative with respect to i is
 * that of a where m_i is 0, too, and the second one by i and j where m_i, m_j and m_ij are 0. Where
 * m is 1, the same holds for b. The other input does not show there, even if it is NaN.
 *
 * With m in [0, 1] and a - b finite, the value never leaves the interval between a and b, rounding
 * included.
 */
SCARP_API enum scarp_status scarp_mix(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *b, const struct scarp_samples *m,
                                      const struct scarp_samples *out);

/*
 * scarp_min - the lesser of `a` and `b`, with a crease where both are equal; NaN before any number
 *
 * All outputs are those of the input chosen, to the bit: b where b < a or b is NaN, otherwise a.
 * Where both are equal that is a. C0: the result is continuous, with a crease where a = b.
 */
SCARP_API enum scarp_status scarp_min(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *b,
                                      const struct scarp_samples *out);

/*
 * scarp_max - the greater of `a` and `b`, with a crease where both are equal; NaN before any number
 *
 * Like scarp_min, but b where b > a or b is NaN.
 */
SCARP_API enum scarp_status scarp_max(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *b,
                                      const struct scarp_samples *out);

/*
 * scarp_smooth_min - the lesser of `a` and `b`, without a crease: less by `k / 6` at most, where they
 * differ by less than `k`
 *
 * min(a, b) - h^3 k / 6 with h = max(0, 1 - |a - b| / k). Where a and b differ by k or more, that
 * is min(a, b) but for rounding. Where they are nearer, it is less, by k / 6 at most. C2. With f_a
 * = 1 - h^2 / 2 where a < b and h^2 / 2 elsewhere, f_b the other of these two, and q = -h / k,
 * derivatives are f_a a_i + f_b b_i and (f_a a_ij + f_b b_ij) + (q (a_i - b_i)) (a_j - b_j).
 *
 * k is in units of value, in [2^-60, 2^60].
 */
SCARP_API enum scarp_status scarp_smooth_min(size_t count, const struct scarp_samples *a,
                                             const struct scarp_samples *b, float k,
                                             const struct scarp_samples *out);

/*
 * scarp_smooth_max - the greater of `a` and `b`, without a crease: more by `k / 6` at most, where they
 * differ by less than `k`
 *
 * max(a, b) + h^3 k / 6: minus scarp_smooth_min of -a and -b.
 */
SCARP_API enum scarp_status scarp_smooth_max(size_t count, const struct scarp_samples *a,
                                             const struct scarp_samples *b, float k,
                                             const struct scarp_samples *out);

/*
 * scarp_clamp - `a`, but `lo` where it is less and `hi` where it is more, with creases there
 *
 * lo <= hi, both finite. Derivatives are those of a for values in [lo, hi], bounds included, and 0
 * outside. C0: creases at the bounds. scarp_smooth_min and scarp_smooth_max have none.
 */
SCARP_API enum scarp_status scarp_clamp(size_t count, const struct scarp_samples *a, float lo,
                                        float hi, const struct scarp_samples *out);

/*
 * scarp_abs - `|a|`, with a crease at 0
 *
 * Derivatives are sign(a) times those of a, with sign(0) = 0. C0.
 */
SCARP_API enum scarp_status scarp_abs(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *out);

/*
 * scarp_smooth_abs - `sqrt(a^2 + round^2)`: the magnitude of `a`, with a round floor
 *
 * `round` is the value where a is 0, in [2^-60, 2^60]. Far from there the result is above |a| by
 * round^2 / (2 |a|). Infinitely smooth. It makes valleys of smooth noise, and ridges if
 * scarp_affine then changes the sign. The valley floors lie on lines where a is 0. Such lines have
 * no ends, so the valleys connect. Where |a| is above 2^63, the square of a is infinite.
 */
SCARP_API enum scarp_status scarp_smooth_abs(size_t count, const struct scarp_samples *a,
                                             float round, const struct scarp_samples *out);

/*
 * scarp_smoothstep - from 0 where `a` is `lo` or beyond, to 1 where it is `hi` or beyond: masks for
 * mixes
 *
 * S(t) = 6t^5 - 15t^4 + 10t^3 with t = (a - lo) / (hi - lo), held within [0, 1]. C2, and values are
 * in [0, 1], rounding included. If lo > hi, the step falls. |hi - lo| is in [2^-60, 2^60]. It makes
 * masks for scarp_mix, as where heights, or slopes, are between lo and hi.
 */
SCARP_API enum scarp_status scarp_smoothstep(size_t count, const struct scarp_samples *a, float lo,
                                             float hi, const struct scarp_samples *out);

/*
 * scarp_terrace - steps in a slope: `steps` per unit of value, of which the part `riser`, in
 * [2^-20, 1], rises. `strength`, in [0, 1], says how level treads are.
 *
 * With t = steps a, u = t - floor(t), S as in scarp_smoothstep, and w = (u - 1/2) / riser + 1/2,
 * held within [0, 1]:
 *
 *     value = (floor(t) + u + strength (S(w) - u)) / steps
 *
 * - `steps` is the number of steps per unit of value, in [2^-60, 2^60].
 * - `riser` is the part of a step that rises, in [2^-20, 1]. The rest, half below and half above,
 *   is a tread. Treads are level at multiples of 1 / steps, where they keep the value. Risers are
 *   up to 15/8 / riser times as steep as a was.
 * - `strength`, in [0, 1], is how far a becomes steps: 0 leaves a as it is, but for rounding, 1
 *   makes treads level. Values move by 1 / (2 steps) at most.
 *
 * C2 for every riser and strength. The first derivative with respect to a is at least 1 - strength,
 * so a terrace never turns a slope around. Steps fade out as |t| nears 2^23. Where t overflows, all
 * outputs are NaN. Values near the largest float may become infinite.
 */
SCARP_API enum scarp_status scarp_terrace(size_t count, const struct scarp_samples *a, float steps,
                                          float riser, float strength,
                                          const struct scarp_samples *out);

/*
 * scarp_divide - `a / b`: infinite or NaN where `b` is 0
 *
 * The value is one division. Derivatives are those of scarp_apply2, with f = a / b and r = 1 / b:
 * fa = r, fb = -(f r), faa = 0, fab = -(r r), fbb = 2 (f r) r.
 */
SCARP_API enum scarp_status scarp_divide(size_t count, const struct scarp_samples *a,
                                         const struct scarp_samples *b,
                                         const struct scarp_samples *out);

/*
 * scarp_sqrt - the square root of `a`, and 0 where `a` is less than 0
 *
 * The value is rounded once. f_a = 1 / (2 value) and f_aa = -f_a / (2 a). Both are 0 where a is 0
 * or less. As a falls to 0, slopes grow without bound.
 */
SCARP_API enum scarp_status scarp_sqrt(size_t count, const struct scarp_samples *a,
                                       const struct scarp_samples *out);

/*
 * scarp_sine - `sin(2 pi a)`: `a` counts turns
 *
 * Computed in double and rounded once: within 1 unit in the last place, and exactly 0, 1 or -1 at
 * multiples of a quarter. An infinite a gives NaN.
 */
SCARP_API enum scarp_status scarp_sine(size_t count, const struct scarp_samples *a,
                                       const struct scarp_samples *out);

/*
 * scarp_pulse - `a` folded to and fro between -1 and 1, with the period 2
 *
 * 1 - 2 |e| with e = 1 - (a - 2 floor(a / 2)): -1 at even numbers, 1 at odd ones, straight between
 * them. f_a is 2 or -2, and 0 at whole numbers. C0: creases at whole numbers. An infinite a gives
 * NaN.
 */
SCARP_API enum scarp_status scarp_pulse(size_t count, const struct scarp_samples *a,
                                        const struct scarp_samples *out);

#define SCARP_CURVE_KNOTS 64

/*
 * scarp_curve - a smooth curve through knots
 *
 * The curve has value[k] where a is x[k]. It is level before the first knot and behind the last
 * one. Between two knots it is the monotone cubic (Fritsch and Butland 1984): its slope at a knot
 * is the harmonic mean of the slopes of the chords at both sides, or 0 where these have different
 * signs and at both ends. So it never overshoots: between two knots, values lie between theirs. The
 * gradient is continuous, the Hessian jumps at knots.
 *
 * There are from 2 to SCARP_CURVE_KNOTS `knots`. All numbers are in [-2^60, 2^60], and x[k + 1] -
 * x[k] is at least 2^-60. Returns SCARP_ERROR_NULL if `x` or `value` is NULL.
 */
SCARP_API enum scarp_status scarp_curve(size_t count, const struct scarp_samples *a, size_t knots,
                                        const float *x, const float *value,
                                        const struct scarp_samples *out);

/*
 * scarp_slope - the length of the gradient of `a`. It has first derivatives where `a` has second ones.
 *
 * value = sqrt(dx^2 + dy^2), with dz^2 if a->dz is there. Derivatives are (a_x a_xi + a_y a_yi +
 * a_z a_zi) / value. Where the value is 0, slopes have the tip of a cone, and derivatives are 0.
 * The value needs dx and dy, not the value of a. A derivative needs, besides, the second
 * derivatives of a along its axis. If `out` asks for second derivatives or dphase, the call returns
 * SCARP_ERROR_UNSUPPORTED.
 */
SCARP_API enum scarp_status scarp_slope(size_t count, const struct scarp_samples *a,
                                        const struct scarp_samples *out);

/* A function at `count` points: its value, and its partial derivatives with respect to one or two
   arguments. */
struct scarp_partials {
    const float *f SCARP_ZERO;
    const float *fa SCARP_ZERO;
    const float *fb SCARP_ZERO;
    const float *faa SCARP_ZERO;
    const float *fab SCARP_ZERO;
    const float *fbb SCARP_ZERO;
    const float *spare[2] SCARP_ZERO; /* reserved: NULL. 8 pointers in all. */
};

/*
 * scarp_apply1 - any function of a, given at each point
 *
 * The caller computes f, its derivative fa and its second derivative faa from the values of a,
 * point by point. scarp does the rest: value = f, and the derivatives by the chain rule. The value
 * needs f. First derivatives need fa, second ones fa and faa, and both need the same derivatives of
 * a as other functions. None needs the value of a. The call does not read the other members of
 * `function`, but reserved ones must be NULL.
 */
SCARP_API enum scarp_status scarp_apply1(size_t count, const struct scarp_samples *a,
                                         const struct scarp_partials *function,
                                         const struct scarp_samples *out);

/*
 * scarp_apply2 - any function of a and b, given at each point
 *
 * Like scarp_apply1. First derivatives need fa and fb. Second ones need faa, fab and fbb, too.
 * Derivatives are fa a_i + fb b_i and
 * ((fa a_ij + fb b_ij) + ((faa a_i) a_j + (fbb b_i) b_j)) + fab (a_i b_j + a_j b_i).
 */
SCARP_API enum scarp_status scarp_apply2(size_t count, const struct scarp_samples *a,
                                         const struct scarp_samples *b,
                                         const struct scarp_partials *function,
                                         const struct scarp_samples *out);

/*
 * Gullies: erosion as a function of the place
 *
 * Gullies and spurs run down the slope of a base, branch, and leave its large forms. The base is
 * any samples: of noise, or combined by the chain rule. The result is the base plus a displacement.
 * Calls read the value and the gradient of the base, and its Hessian where derivatives are asked
 * for, so that these are exact. The formulas are at the end, under "Gullies".
 *
 * Which bases serve: gradients of the result are continuous where the Hessian of the base is. That
 * is gradient and value noise with the quintic fade, simplex noise, cell-soft, sums of these, and
 * what scarp_smooth_abs, scarp_smooth_min and scarp_smooth_max make of them. At the creases of a
 * base (ridged, turbulence, cellular noise, scarp_abs) the height itself tears, because gullies on
 * both sides run in other directions.
 *
 * Detail as fine as gullies turns them within a cell: a base of three octaves is good, one of five
 * crumples. Add finer detail to the result, with scarp_add. Gullies end where the base has a dip.
 * Valleys that connect, as those of scarp_smooth_abs do, drain.
 */

/* Gullies. Lengths and heights are multiples of those of the base, so a terrain scales as a whole.
   A number that is 0 stands for its default. For an effect that is not wanted give 2^-24. */
struct scarp_gullies {
    uint64_t seed SCARP_ZERO; /* all 64 bits count */

    /* of the base: cells per unit of input, in [2^-32, 2^48]. Default 1. */
    double frequency SCARP_ZERO;

    /* of the base: half the height from its floors to its crests, in [2^-24, 2^24]. Default 1. */
    float amplitude SCARP_ZERO;

    float octaves SCARP_ZERO; /* in (0, 32]. Default 5. A fraction fades the last one in. */

    /* weights are those of a sum of this many octaves, in [octaves, 32]. 0: octaves. */
    float of_octaves SCARP_ZERO;

    /* frequency ratio between octaves, in [1/16, 16]. Default 2. */
    float lacunarity SCARP_ZERO;

    /* weight ratio between octaves, in [1/16, 16]. Default 0.45. 0.6 is rough. */
    float gain SCARP_ZERO;

    /* how far the base is displaced at most, in amplitudes, in [2^-24, 2^10]. Default 0.25. */
    float depth SCARP_ZERO;

    /* cells of the first gullies per cell of the base, in [2^-6, 2^6]. Default 3. */
    float cells SCARP_ZERO;

    /* the slope at which gullies of crests have half their depth, in amplitudes per cell of the
       base, in [2^-5, 2^5]. Default 1.125. Less makes peaks sharper. */
    float slope SCARP_ZERO;

    /* the same slope for floors, in [2^-5, 2^5]. Default 1.75. More makes floors wider. */
    float slope_low SCARP_ZERO;

    /* the height of floors, in amplitudes, in [-2^10, 2^10]. Default -1. */
    float low SCARP_ZERO;

    /* the height of crests, in amplitudes, in [-2^10, 2^10], at least 2^-10 above `low`. Default 1.
     */
    float high SCARP_ZERO;

    /* how far floors sink, in [-1, 1]: 1 as deep as gullies, -1 filled up. Default 0.5. */
    float floor SCARP_ZERO;

    float stripes SCARP_ZERO; /* gullies per cell, in [2^-10, 8]. Default 1.5. */

    /* how far an octave turns those after it, in [2^-24, 8]. Default 0.8. With 0.3 gullies run
       parallel. */
    float branch SCARP_ZERO;

    /* how round crests are, in [2^-8, 2^8]: 0.05 is an arete, 1 rolling. Default 0.15. */
    float round SCARP_ZERO;

    /* how far an octave spares the crests and floors of the one before, in [2^-24, 1]. Default 1.
     */
    float keep SCARP_ZERO;

    /* cells of the base after which gullies repeat along each axis; 0: never. `cells` times a
       period is whole, and at most 2^30. See "Periods". */
    uint32_t period[2] SCARP_ZERO;

    uint32_t rotate SCARP_ZERO; /* nonzero turns the axes between octaves */

    uint32_t offset_first SCARP_ZERO; /* nonzero: octave 0 has an offset, as that of a noise */

    uint32_t spare[8] SCARP_ZERO; /* reserved: 0. 128 bytes in all. */
};

/* Where results of gullies go: arrays of `count` floats. A NULL member is skipped. A call that asks
   for no derivative does not pay for derivatives. */
struct scarp_eroded {
    /* the base plus the displacement, and its gradient */
    float *value SCARP_ZERO;
    float *dx SCARP_ZERO;
    float *dy SCARP_ZERO;

    /* a map of ridges and gullies, in [-1, 1] times depth times amplitude; and its gradient */
    float *displacement SCARP_ZERO;
    float *displacement_dx SCARP_ZERO;
    float *displacement_dy SCARP_ZERO;

    float *spare[10] SCARP_ZERO; /* reserved: NULL. 16 pointers in all. */
};

/*
 * scarp_gullies2 - draw gullies into a base at points of the plane
 *
 * `base` holds value, dx and dy of the base at the points, and dxx, dxy and dyy if a derivative is
 * asked for. The call does not read its other members.
 *
 * Arrays: every array holds at least `count` elements. An output may be the very same array as any
 * array of the base or a coordinate. Outputs must not overlap anything else.
 *
 * Accuracy: derivatives are within 2e-4 of the exact ones, in amplitudes per cell of the base, with
 * a root mean square of 2e-6 (defaults, double coordinates). With float coordinates of some cells
 * they are within 2e-3, and 5e-5. Sharp crests have larger errors: 0.03 and 2e-4 with `round` 0.02.
 *
 * Numbers: where the value of the base is NaN, or its gradient is NaN or infinite, every output of
 * that point is NaN. An infinite value counts as far above all crests, or below all floors, and
 * stays as it is. Where a second derivative of the base is NaN or infinite, those derivatives are
 * NaN that it is part of: dx of dxx and dxy, dy of dxy and dyy. Where the length of the base's
 * gradient, in amplitudes per cell, passes 2^63, the ground counts as flat.
 *
 * Range: see scarp_gullies_range.
 *
 * Errors: SCARP_ERROR_NULL if an argument, or an array of the base that is needed, is NULL; others
 * as scarp_gullies_check.
 */
SCARP_API enum scarp_status scarp_gullies2(const struct scarp_gullies *gullies, size_t count,
                                           const float *x, const float *y,
                                           const struct scarp_samples *base,
                                           const struct scarp_eroded *out);

/* scarp_gullies2_f64 - like scarp_gullies2, but with double coordinates, as scarp_sample2_f64.
   Outputs may be arrays of the base. */
SCARP_API enum scarp_status scarp_gullies2_f64(const struct scarp_gullies *gullies, size_t count,
                                               const double *x, const double *y,
                                               const struct scarp_samples *base,
                                               const struct scarp_eroded *out);

/*
 * scarp_gullies_grid2 - draw gullies into a base on a uniform grid of the plane
 *
 * Arrays of the base, and outputs, are as scarp_grid2 has them: element j * row_stride + i of each
 * output has, to the bit, what scarp_gullies2_f64 gives at the coordinates of sample (i, j). The
 * call writes nothing between the rows.
 *
 * Errors: what scarp_grid2 says of grids; others as scarp_gullies2.
 */
SCARP_API enum scarp_status scarp_gullies_grid2(const struct scarp_gullies *gullies,
                                                const struct scarp_grid *grid,
                                                const struct scarp_samples *base,
                                                const struct scarp_eroded *out);

/*
 * scarp_gullies_range - the interval that values never leave
 *
 * *lowest <= value <= *highest, rounding included, for a base in [base_lowest, base_highest]. That
 * is base_lowest less depth times amplitude, and base_highest plus depth times amplitude.
 *
 * Errors, with which nothing is written: SCARP_ERROR_NULL if a pointer is NULL;
 * SCARP_ERROR_PARAMETER if the ends of the base are NaN or out of order; others as
 * scarp_gullies_check.
 */
SCARP_API enum scarp_status scarp_gullies_range(const struct scarp_gullies *gullies,
                                                float base_lowest, float base_highest,
                                                float *lowest, float *highest);

/*
 * scarp_gullies_check - whether calls take gullies, and if not, which member is at fault
 *
 * *member becomes the name of a member at fault, as this header spells it, or NULL. The call always
 * writes it, also on an error. The text is static. `member` may be NULL. scarp_gullies_fault says
 * why.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `gullies` is NULL
 *     SCARP_ERROR_PARAMETER    a number is outside its interval; the frequency of gullies, which is
 *                              frequency * cells * lacunarity^k, is outside [2^-32, 2^48] in an
 *                              octave; or a period is not whole in octave 0 or in all later ones
 *     SCARP_ERROR_UNSUPPORTED  a reserved member is in use
 *     SCARP_ERROR_UNSUPPORTED  a period where axes are turned (`rotate`, with more than one octave)
 */
SCARP_API enum scarp_status scarp_gullies_check(const struct scarp_gullies *gullies,
                                                const char **member);

/* scarp_gullies_fault - why calls refuse gullies, in words, as scarp_noise_fault. *member becomes
   what scarp_gullies_check says. */
SCARP_API const char *scarp_gullies_fault(const struct scarp_gullies *gullies, const char **member);

/*
 * Recipes
 *
 * A recipe is a composition of noises as a text, which a program can load and an editor can change:
 *
 *     recipe 1
 *     param height = 110 [0, 10000]
 *     bend   = noise(size=286, octaves=5, amplitude=75)
 *     ridges = warp(noise(swiss, rotate, size=200, octaves=9, gain=0.45), bend)
 *     ground = noise(hybrid, rotate, size=625, octaves=8, gain=0.42, amplitude=1.4)
 *     high   = smoothstep(noise(rotate, size=625, octaves=3), -0.5, 0.25)
 *     out alps = height * (ridges * high + ground)
 *
 * src/recipe/README.md teaches the language, and has the formula, the derivatives and the interval
 * of each function. Derivatives are exact through the whole expression, and values keep to a
 * promised range. A text gives the same bits in all versions of the library of the same major
 * version.
 *
 *     static struct scarp_recipe recipe;
 *     struct scarp_recipe_error error;
 *     if (scarp_recipe_parse(text, strlen(text), &recipe, &error, 1, NULL) != SCARP_OK) {
 *         fprintf(stderr, "%d:%d: %s\n", (int)error.line, (int)error.column, error.text);
 *     }
 *     struct scarp_samples out = {.value = height, .dx = dx, .dy = dy};
 *     struct scarp_recipe_outputs outputs = {.count = 1, .out = &out};
 *     struct scarp_scratch scratch = {.size = scarp_recipe_scratch_size(&recipe, 1, 0)};
 *     scratch.memory = malloc(scratch.size);
 *     scarp_recipe_grid(&recipe, &grid, &outputs, &scratch);
 *
 * Threads: any number of threads may read one recipe at a time, each with scratch memory of its
 * own.
 *
 * Stack: calls for recipes take up to 2 KiB more than other calls, and without scratch memory
 * another 8 KiB. Threads with 64 KiB will do.
 */

/* A text and what it was compiled to: 64 KiB. Its bytes are the library's business. The caller owns
   it, and may copy it, as a whole, to wherever a uint64_t may stand. It does not belong on a small
   stack. */
struct scarp_recipe {
    uint64_t first;
    unsigned char rest[65536 - 8];
};

/* What is wrong with a text, and where. */
struct scarp_recipe_error {
    /* bytes of the text, from `from` to before `to` */
    size_t from SCARP_ZERO;
    size_t to SCARP_ZERO;

    /* where `from` is, counted from 1; columns are bytes */
    int32_t line SCARP_ZERO;
    int32_t column SCARP_ZERO;

    /* static: a clause without a full stop, about the member if there is one */
    const char *text SCARP_ZERO;

    /* static: the member of a noise, or the argument, that is at fault; or NULL */
    const char *member SCARP_ZERO;

    double nearest SCARP_ZERO; /* a number that would do there; 0: none is told */
    uint32_t spare[6] SCARP_ZERO;
};

/*
 * scarp_recipe_parse - read a text
 *
 * `text` has `length` bytes, at most 16,384. The recipe keeps a copy, so the text may go away
 * afterwards. Parameters get the values that the text gives them. The seed of the world is 0.
 *
 * *found becomes the number of errors in the text, which may be more than one: reading goes on
 * behind each. The first `capacity` of them, in the order of the text, are written to `errors`.
 * `errors` and `found` may be NULL.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `recipe` is NULL, or `text` is with a length above 0
 *     SCARP_ERROR_SIZE         the text is too long
 *     SCARP_ERROR_SIZE         the text passes a limit of recipes: 512 expressions, 96 names, 256
 *                              fields, 48 noises, 16 outputs, 32 places
 *     SCARP_ERROR_PARAMETER    the text has another error
 *
 * With the last two, *recipe has what could be read, for editors: scarp_recipe_entry_at and its
 * like describe it, and statements without an error may be sampled by number. With the first two,
 * *recipe is untouched, and *found is 0.
 */
SCARP_API enum scarp_status scarp_recipe_parse(const char *text, size_t length,
                                               struct scarp_recipe *recipe,
                                               struct scarp_recipe_error *errors, size_t capacity,
                                               size_t *found);

/*
 * scarp_recipe_seed - set the seed of the world
 *
 * All noises follow it. A noise without a seed, or with seed=0, takes the seed of the world.
 * Another noise, with seed=n, takes number 64 + n, or 2^64 + n if n is negative, of
 * splitmix64(first number of splitmix64(seed of the world)): see "Seeds". All noises, warps, cells
 * and gullies of recipes have offset_first 1, so no seed has special places at the origin.
 *
 * Errors: SCARP_ERROR_NULL if `recipe` is NULL; SCARP_ERROR_PARAMETER if *recipe is no recipe, or
 * has errors.
 */
SCARP_API enum scarp_status scarp_recipe_seed(struct scarp_recipe *recipe, uint64_t seed);

/*
 * scarp_recipe_set - set a parameter
 *
 * `name` is that of a `param`, or "finest". "finest" is a level of detail: octaves whose cells are
 * smaller than `value` units are left out, and with 0 none are. Large forms stay to the bit. The
 * octaves of gullies count by the cells of the base, divided by the lacunarity from octave to
 * octave. The call compiles the recipe again, which takes some microseconds.
 *
 * Errors. On an error the old value stays.
 *
 *     SCARP_ERROR_NULL         `recipe` or `name` is NULL
 *     SCARP_ERROR_PARAMETER    *recipe is no recipe, or has errors; no parameter has that name; the
 *                              value is outside its interval; or the text has an error with that
 *                              value, which is written to *error. `error` may be NULL.
 *     SCARP_ERROR_SIZE         the text passes a limit of recipes with that value
 */
SCARP_API enum scarp_status scarp_recipe_set(struct scarp_recipe *recipe, const char *name,
                                             double value, struct scarp_recipe_error *error);

/*
 * scarp_recipe_tile - make a recipe repeat
 *
 * The recipe becomes what it is with the line `tile x, y` or, in space, `tile x, y, z` in its text:
 * it repeats after so many units along each axis, from 1e-60 to 1e60. A line of the text, and an
 * earlier call, no longer count. With 0 for all sides, the recipe does not repeat. The plane
 * ignores z. Seeds and parameters that are set later keep the tile.
 *
 * Errors. On an error the old tile stays.
 *
 *     SCARP_ERROR_NULL         `recipe` is NULL
 *     SCARP_ERROR_PARAMETER    *recipe is no recipe, or has errors; a side is outside its interval;
 *                              or the text cannot repeat so. Then *error has the first error that
 *                              no other size mends, or else the first. `error` may be NULL.
 *     SCARP_ERROR_SIZE         the text passes a limit of recipes with that tile
 */
SCARP_API enum scarp_status scarp_recipe_tile(struct scarp_recipe *recipe, double x, double y,
                                              double z, struct scarp_recipe_error *error);

/*
 * scarp_recipe_scale - make a recipe larger
 *
 * Each statement becomes what it is inside scale(..., by), and the first output is multiplied by
 * `heights`, wherever it is not used by another statement. A terrain becomes twice as large with 2
 * for both, and its slopes stay. Factors are from 2^-40 to 2^40; 1 changes nothing. They take the
 * place of those of an earlier call. The tile, and "finest", are in units of the scaled recipe.
 * Seeds and parameters that are set later keep the scale.
 *
 * Errors. On an error the old scale stays.
 *
 *     SCARP_ERROR_NULL         `recipe` is NULL
 *     SCARP_ERROR_PARAMETER    *recipe is no recipe, or has errors; a factor is outside its
 *                              interval; or the text has an error with that scale, which is written
 *                              to *error. `error` may be NULL.
 *     SCARP_ERROR_SIZE         the text passes a limit of recipes with that scale
 */
SCARP_API enum scarp_status scarp_recipe_scale(struct scarp_recipe *recipe, double by,
                                               double heights, struct scarp_recipe_error *error);

/* Memory that a call uses while it runs, of any alignment. Its size changes speed, never a bit. */
struct scarp_scratch {
    void *memory SCARP_ZERO;
    size_t size SCARP_ZERO; /* in bytes */

    /* what scarp_recipe_plan_make made of the recipe; NULL: none. Results do not depend on it. It
       serves without `memory`, too. */
    const void *plan SCARP_ZERO;
    uint32_t spare[(64 - 3 * sizeof(void *)) / 4] SCARP_ZERO; /* reserved: 0. 64 bytes in all. */
};

/* Which outputs a call computes, and where their samples go. */
struct scarp_recipe_outputs {
    const struct scarp_samples *out SCARP_ZERO; /* `count` elements, one for each output */

    /* NULL: the outputs of the text, in its order, from the first one on. Else `count` numbers: of
       statements, as scarp_recipe_entry_at counts them, or SCARP_RECIPE_PARTS plus the number of a
       part. A part may be any field. It is sampled without the transforms around it. */
    const int32_t *which SCARP_ZERO;

    int32_t count SCARP_ZERO;     /* from 1 to 16 */
    uint32_t spare[9] SCARP_ZERO; /* reserved: 0 */
};

#define SCARP_RECIPE_PARTS 65536
#define SCARP_RECIPE_OUTPUT (-1)

/*
 * scarp_recipe_sample - sample a recipe at points
 *
 * For each i < count, element i of each array is the output at (x[i], y[i]), or in space at (x[i],
 * y[i], z[i]), with its exact derivatives. A recipe of the plane does not read z. Arrays have at
 * least `count` elements. No array that is written may overlap another array.
 *
 * Positions are computed in float, as scarp_sample2 has them: these are the bits of shaders. Where
 * a coordinate is NaN or infinite, outputs are NaN, except behind a mask that is 0, which hides it.
 *
 * Scratch memory: `scratch` may be NULL, or have NULL for memory. Then the call takes 8 KiB more of
 * the stack, and works in small chunks. scarp_recipe_scratch_size gives the size that is best for
 * large calls, and the size for chunks of so many points.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `recipe`, `outputs`, outputs->out or a coordinate is NULL
 *     SCARP_ERROR_PARAMETER    *recipe is no recipe, or has errors that this call meets; or
 *                              outputs->count, or a number in `which`, does not exist
 *     SCARP_ERROR_UNSUPPORTED  an output does not have a derivative that is asked for. None has
 *                              dphase. Erosion, Swiss and Jordan noise, gullies, slopes and
 *                              distances in cells have no second derivatives.
 *     SCARP_ERROR_SIZE         no chunk fits into the scratch memory. Without any, what is asked
 *                              for needs more than 7 KiB for a chunk of 16
 *                              points.
 */
SCARP_API enum scarp_status scarp_recipe_sample(const struct scarp_recipe *recipe, size_t count,
                                                const float *x, const float *y, const float *z,
                                                const struct scarp_recipe_outputs *outputs,
                                                const struct scarp_scratch *scratch);

/* scarp_recipe_sample_f64 - like scarp_recipe_sample, but with double coordinates, as
   scarp_sample2_f64. Transforms are computed in double, too, so worlds may be large. */
SCARP_API enum scarp_status scarp_recipe_sample_f64(const struct scarp_recipe *recipe, size_t count,
                                                    const double *x, const double *y,
                                                    const double *z,
                                                    const struct scarp_recipe_outputs *outputs,
                                                    const struct scarp_scratch *scratch);

/*
 * scarp_recipe_grid - sample a recipe on a uniform grid, in the plane or in space
 *
 * Arrays are as scarp_grid2, or scarp_grid3, has them. They get, to the bit, what
 * scarp_recipe_sample_f64 gives at the coordinates of each sample. Noise that no function
 * transforms takes 2 to 5 times as long as scarp_grid2 and scarp_grid3 take for one octave, and 1.4
 * to 2.2 times as long for more. What does not depend on z is computed once per column.
 *
 * Errors: what scarp_grid2 says of grids; others as scarp_recipe_sample.
 */
SCARP_API enum scarp_status scarp_recipe_grid(const struct scarp_recipe *recipe,
                                              const struct scarp_grid *grid,
                                              const struct scarp_recipe_outputs *outputs,
                                              const struct scarp_scratch *scratch);

/* scarp_recipe_scratch_size - bytes of scratch memory for chunks of `points` points of the outputs
   of the text, with derivatives up to `order`, from 0 to 2. With 0 points, the bytes that are best
   for large calls; smaller calls need only what their points take. 0 if *recipe is no recipe, or
   has errors, if the order does not exist, or if so many points do not fit into memory. */
SCARP_API size_t scarp_recipe_scratch_size(const struct scarp_recipe *recipe, int order,
                                           size_t points);

/*
 * scarp_recipe_plan_size, scarp_recipe_plan_make - make the plan of a recipe, for many calls with
 * few points
 *
 * A call without a plan computes the constants of each noise anew: that takes most of its time if
 * it is for a few points. With scratch.plan = memory, calls take them from there, and give the same
 * bits. A plan has what the outputs of the text need, and serves all calls for the recipe, with
 * floats and doubles, every kernel set, and any number of threads at a time. Calls only read it.
 *
 *     const size_t size = scarp_recipe_plan_size(&recipe);
 *     void *const plan = malloc(size);
 *     if (plan != NULL && scarp_recipe_plan_make(&recipe, plan, size) == SCARP_OK) {
 *         scratch.plan = plan;
 *     }
 *
 * scarp_recipe_plan_size returns the bytes of a plan: about 300 for each noise, and 240 for each of
 * its octaves. 0 if *recipe is no recipe, or has errors. Seeds do not change the size; parameters,
 * the tile and the scale may.
 *
 * `memory` has `size` bytes, and the alignment of a uint64_t. What it has before does not matter.
 * The plan may be copied to wherever a uint64_t may stand. It does not refer to the recipe, which
 * may be copied, too.
 *
 * A plan that does not fit does no harm. Calls compare each noise that the plan was made of with
 * the one of the recipe. Where they differ, or the version of the library does, calls compute the
 * constants. So a plan may stay where it is while the recipe is changed, and calls for another
 * recipe may be given it. But the behaviour is undefined if a good plan was changed in part.
 *
 * No other thread may use the memory while a plan is made there. On these errors it is left as it
 * was.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `recipe` or `memory` is NULL
 *     SCARP_ERROR_PARAMETER    *recipe is no recipe, or has errors; `memory` is not aligned
 *     SCARP_ERROR_SIZE         `size` is less than scarp_recipe_plan_size says
 */
SCARP_API size_t scarp_recipe_plan_size(const struct scarp_recipe *recipe);
SCARP_API enum scarp_status scarp_recipe_plan_make(const struct scarp_recipe *recipe, void *memory,
                                                   size_t size);

/* A box of points. The plane ignores the elements 2. */
struct scarp_box {
    double lowest[3] SCARP_ZERO;
    double highest[3] SCARP_ZERO;
};

/*
 * scarp_recipe_range - the interval that values never leave
 *
 * *lowest <= value <= *highest, rounding included, at all points, or with a box at those in it.
 * `box` may be NULL. `which` is a number as in struct scarp_recipe_outputs, or SCARP_RECIPE_OUTPUT
 * for the first output. The interval is made of the intervals of all parts, so it may be wider than
 * the values are. Where coordinates count, it is infinite without a box.
 *
 * Errors: SCARP_ERROR_NULL if `recipe`, `lowest` or `highest` is NULL; SCARP_ERROR_PARAMETER as
 * scarp_recipe_sample, and for a box whose ends are NaN or out of order.
 */
SCARP_API enum scarp_status scarp_recipe_range(const struct scarp_recipe *recipe, int32_t which,
                                               const struct scarp_box *box, float *lowest,
                                               float *highest);

/* What a statement, or a part of one, is. */
enum scarp_recipe_kind {
    SCARP_RECIPE_BAD,    /* it has an error, or something that it uses has one */
    SCARP_RECIPE_NUMBER, /* the same everywhere: numbers, parameters, and what is made of them */
    SCARP_RECIPE_FIELD,  /* has a value at each point */
    SCARP_RECIPE_NOISE,  /* a field that warp() may displace by */
    SCARP_RECIPE_WORD,   /* a bare word among arguments */
    SCARP_RECIPE_KNOT    /* x: value */
};

/* A statement: param, out or name = expression. A span is two numbers of bytes of the text: the
   first byte, and the one behind the last. */
struct scarp_recipe_entry {
    uint32_t span[2] SCARP_ZERO;
    uint32_t name[2] SCARP_ZERO; /* the span of its name */
    int32_t kind SCARP_ZERO;     /* enum scarp_recipe_kind */
    int32_t is_param SCARP_ZERO; /* 1 for param, else 0 */
    int32_t output SCARP_ZERO;   /* the number of the output that it is, or -1 */
    int32_t part SCARP_ZERO;     /* the number of its expression; -1 for param */
    double value SCARP_ZERO;     /* of numbers */

    /* of param: the interval that the text gives, else that of all numbers */
    double slider[2] SCARP_ZERO;

    float range[2] SCARP_ZERO; /* of fields: the interval that values never leave */
    uint32_t axes SCARP_ZERO;  /* of fields: the axes that they depend on: 1 x, 2 y, 4 z, added */
    uint32_t order SCARP_ZERO; /* of fields: the highest order of their derivatives */

    /* the same as before an edit if nothing has to be drawn anew */
    uint64_t hash SCARP_ZERO;

    /* of fields: the length of the largest and of the smallest cell, in units of x, y and z, among
       the first and the last octaves of all noises, cells and gullies that the field depends on,
       warps included. Transforms count, displacements do not. 0: it has none. */
    double cell[2] SCARP_ZERO;

    uint32_t jumps SCARP_ZERO;      /* of fields: 1 if values may jump, single points aside */
    uint32_t dimensions SCARP_ZERO; /* of the recipe: 2, or 3 if it is one of space */

    uint32_t spare[2] SCARP_ZERO;
};

/* A part of an expression. Parts are counted from 0, in an order: a call, and a sign, stands before
   the parts that it has; any other operator stands behind its parts. Members that struct
   scarp_recipe_entry has, too, mean the same. */
struct scarp_recipe_part {
    uint32_t span[2] SCARP_ZERO;

    /* the span of a name, or of the name of a function that is called; else empty */
    uint32_t name[2] SCARP_ZERO;

    uint32_t argument[2] SCARP_ZERO; /* the span of the name of an argument; else empty */
    int32_t kind SCARP_ZERO;         /* enum scarp_recipe_kind */

    /* of a call: the number of its function, as scarp_recipe_function_at counts; else -1 */
    int32_t function SCARP_ZERO;

    int32_t entry SCARP_ZERO;     /* of a name: the statement that it stands for; else -1 */
    int32_t parent SCARP_ZERO;    /* the part around it; -1: it is a whole expression */
    int32_t operation SCARP_ZERO; /* one of '+', '-', '*', '/', '^'; 0 for all else */
    uint32_t axes SCARP_ZERO;
    uint32_t order SCARP_ZERO;
    float range[2] SCARP_ZERO;
    double value SCARP_ZERO;
    uint64_t hash SCARP_ZERO;
    uint32_t spare[8] SCARP_ZERO;
};

/* An argument of a function. */
struct scarp_recipe_argument {
    const char *name SCARP_ZERO;
    const char *text SCARP_ZERO; /* what it does, without a full stop */

    int32_t kind SCARP_ZERO;      /* enum scarp_recipe_kind: what is expected */
    int32_t is_needed SCARP_ZERO; /* 1 if it cannot be left out, else 0 */
    double otherwise SCARP_ZERO;  /* of numbers: the value without the argument */

    /* of numbers: the interval for a slider; numbers outside may be valid, too */
    double lowest SCARP_ZERO;
    double highest SCARP_ZERO;

    /* of words: those that it may be, and NULL behind them; else NULL */
    const char *const *words SCARP_ZERO;

    uint32_t spare[4] SCARP_ZERO;
};

/* A function of the language. */
struct scarp_recipe_function {
    const char *name SCARP_ZERO;
    const char *text SCARP_ZERO; /* a sentence: what it does */

    /* `arguments` of them. The last one may be given again and again if its kind is
       SCARP_RECIPE_KNOT. */
    const struct scarp_recipe_argument *argument SCARP_ZERO;
    int32_t arguments SCARP_ZERO;

    uint32_t spare[5] SCARP_ZERO;
};

/*
 * scarp_recipe_entry_at, scarp_recipe_part_at, scarp_recipe_function_at - what editors show
 *
 * Each fills in the structure for number `index`: of the statements, of the parts, of the functions
 * of the language. A recipe with errors may be described, too. Spare members become 0.
 *
 * Errors: SCARP_ERROR_NULL if a pointer is NULL; SCARP_ERROR_PARAMETER if *recipe is no recipe, and
 * for every index from the first that does not exist. So a loop ends there.
 */
SCARP_API enum scarp_status scarp_recipe_entry_at(const struct scarp_recipe *recipe, size_t index,
                                                  struct scarp_recipe_entry *entry);
SCARP_API enum scarp_status scarp_recipe_part_at(const struct scarp_recipe *recipe, size_t index,
                                                 struct scarp_recipe_part *part);
SCARP_API enum scarp_status scarp_recipe_function_at(size_t index,
                                                     struct scarp_recipe_function *function);

/*
 * Shaders
 *
 * scarp.glsl, scarp.hlsl and scarp.wgsl lie beside this header, and compute noise on the GPU: all
 * bases and fractals, with periods, phases and warps; values, gradients and Hessians, but not
 * dphase; vector noise, cells and curl; the chain rule and gullies. They read the constants of the
 * noise from a uniform buffer, which is a struct scarp_gpu_plan, or those of a recipe. The shader
 * file and the constants must be of the same version of the library.
 *
 * Equal bits. A shader gives the bits of scarp_sample2 and scarp_sample3, with float coordinates,
 * on drivers that round sums, differences and products to the nearest float, and fuse none of them.
 * Vulkan promises that with NoContraction, which scarp.glsl asks for, and with the execution mode
 * RoundingModeRTE of 32 bits, which SCARP_ROUND asks for. Besides,
 *
 * - all positions p_k must be finite;
 * - the coordinates of first octaves must be 0, or at least 2^-24 in magnitude. These are f_0 times
 *   x, or in noise with warps f_0 times y ("Octaves", "Warps").
 *
 * Results below 2^-120 in magnitude may be 0. So may results on the way, as the square under a
 * root: the slope of a gradient below 2^-60 may be 0. The sign of 0 and results that overflow are
 * not promised.
 *
 * WGSL and D3D promise less on paper: there, compilers may fuse or reorder, and flush or round
 * otherwise. So a program asks each driver at its start. It has a shader compute scarp_answer2 or
 * scarp_answer3 for i < SCARP_GPU_ANSWERS, and compares the answers with those of
 * scarp_gpu_answers. If all are equal, the driver keeps the promise for this noise, as far as 4,096
 * points can tell. If not, the program computes here what has to be equal, and uploads it as tiles.
 * The shader still draws the noise, but for rounding, where nothing depends on its bits.
 */

/* An octave, in the layout std140 of uniform buffers: 160 bytes. See "Octaves". */
struct scarp_gpu_octave {
    uint32_t key[3];      /* keys of the lattice hash, by axis ("Lattice") */
    float frequency;      /* f_k */
    float weight;         /* a_k */
    float amplitude;      /* what multiplies the basis: 1 / supremum, in fBm times a_k, in hybrid
                             noise times 1 - 2^-17 */
    float slope;          /* amplitude f_k */
    float curvature;      /* amplitude f_k^2 */
    uint32_t last[3];     /* the last cell of a period along each axis; 2^32 - 1 without period */
    float share;          /* gain^k */
    float turn[4];        /* with a phase: cosine and sine of the angle, then of twice that. Simplex
                             and cellular noise: how far features stray, in units of 2^-32 cells;
                             what is subtracted from distances; rows of the lattice per unit of p_y;
                             0. Other noise: 0. */
    float jacobian[3][4]; /* [i][0] to [i][2]: row i of J_k where axes are turned (not in octave 0),
                             else 0. [i][3]: component i of o_k. */
    float gradient[3][4]; /* [i][0] to [i][2]: amplitude times that row. [0][3]: 1 / f_k of
                             cellular noise and of fractals that bend, [1][3]: c_k of the latter,
                             else 0. [2][3]: 0. */
};

/* What the octaves of a noise share: 48 bytes. */
struct scarp_gpu_level {
    uint32_t basis, fade, fractal; /* the enumerators */
    uint32_t octaves;              /* K */
    uint32_t rotate;               /* 1: axes of all octaves but octave 0 are turned; else 0 */
    uint32_t flows;                /* 1: there is a phase other than 0; else 0 */
    uint32_t first; /* where its octaves begin. Components of a warp by gradient or value noise
                       share K octaves; of other warps, component i has K from first + i K on. */
    uint32_t spare0;
    float erosion, sharpness; /* defaults filled in; sharpness: 0 for fractals that have none */
    float inverse_weight;     /* 1 / a_0, within floats, of fractals that bend, else 0 */
    float spare1;
};

/* The constants of a noise: 5376 bytes, so that three fit into the 16 KiB which every uniform
   buffer may have. What is not used is 0. */
struct scarp_gpu_plan {
    uint32_t depth; /* how many warps: level[0] is the noise, level[1] its warp, level[2] that of
                       the warp */
    uint32_t dimensions;
    uint32_t zero; /* 0, which compilers do not know: it keeps them from fusing */
    float unit;    /* the power of two nearest 1 / (256 frequency), for scarp_gpu_answers */
    struct scarp_gpu_level level[5];
    struct scarp_gpu_octave octave[32];
};

#define SCARP_GPU_ANSWERS 4096

/*
 * scarp_gpu_plan_make - make the constants of a noise, for shaders
 *
 * *plan is for shaders that sample the noise in 2 or 3 `dimensions`. The same noise gives the same
 * bytes on every machine, but for their order in a word. On an error *plan is left as it was.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `noise` or `plan` is NULL
 *     SCARP_ERROR_UNSUPPORTED  the noise and its warps need more than the 32 octaves that a plan
 *                              has. A warp by gradient or value noise needs as many as it says, any
 *                              other warp `dimensions` times as many. *member is "warp".
 *     others                   as scarp_noise_check, which says what *member becomes. `member` may
 *                              be NULL. scarp_gpu_plan_fault says why.
 */
SCARP_API enum scarp_status scarp_gpu_plan_make(const struct scarp_noise *noise, int dimensions,
                                                struct scarp_gpu_plan *plan, const char **member);

/* scarp_gpu_vector_plan_make - likewise for the components of vector noise: for scarp_vector2,
   scarp_vector3 and scarp_curl3 of shaders. The noise needs as many octaves as a warp by it would
   need. If a noise without a warp needs too many, *member is "octaves". */
SCARP_API enum scarp_status scarp_gpu_vector_plan_make(const struct scarp_noise *noise,
                                                       int dimensions, struct scarp_gpu_plan *plan,
                                                       const char **member);

/* scarp_gpu_plan_fault - why scarp_gpu_plan_make refuses a noise, or if `vector` is not 0
   scarp_gpu_vector_plan_make, in words, as scarp_noise_fault. *member becomes what that call
   says. */
SCARP_API const char *scarp_gpu_plan_fault(const struct scarp_noise *noise, int dimensions,
                                           int vector, const char **member);

/*
 * scarp_gpu_answers - what a shader must answer, computed here: a test for the start of a program
 *
 * answer[i], for i < SCARP_GPU_ANSWERS, is a hash of the results at test point i: the value, and
 * the derivatives up to `order`, which is 0, 1 or 2. It depends on all of their bits, but takes 0
 * for results below 2^-120 in magnitude. scarp_answer2(plan, order, i), or scarp_answer3, in a
 * shader gives the same number.
 *
 * Coordinates are multiples of plan.unit, from -2^19 of them to 2^19 - 1, so points lie some
 * thousand cells around the origin. The call takes as long as sampling 4,096 points.
 *
 * Errors: SCARP_ERROR_NULL if `noise` or `answer` is NULL; then as scarp_gpu_plan_make; then
 * SCARP_ERROR_PARAMETER for an `order` that does not exist, and SCARP_ERROR_UNSUPPORTED for one
 * that the noise, or a warp, does not have.
 */
SCARP_API enum scarp_status scarp_gpu_answers(const struct scarp_noise *noise, int dimensions,
                                              int order, uint32_t *answer);

/* The languages of shaders: of scarp.glsl, scarp.hlsl and scarp.wgsl. */
enum scarp_language { SCARP_GLSL, SCARP_HLSL, SCARP_WGSL };

/* What a shader of a recipe is made of. */
struct scarp_shader {
    int32_t language SCARP_ZERO;   /* enum scarp_language */
    int32_t order SCARP_ZERO;      /* of the derivatives that outputs have: 0, 1 or 2 */
    const char *file SCARP_ZERO;   /* the text of scarp.glsl, or scarp.hlsl, or scarp.wgsl */
    size_t length SCARP_ZERO;      /* of the file, in bytes */
    uint32_t spare[12] SCARP_ZERO; /* reserved: 0 */
};

/*
 * scarp_recipe_shader - write a recipe as functions of a shading language
 *
 * The text declares a uniform buffer, which scarp_recipe_uniforms fills, and has
 *
 *     ScarpRecipe scarp_recipe(x, y)         all outputs: a structure with members out0, out1, ...
 *     ScarpSample scarp_recipe_NAME(x, y)    one of them: value, gradient, diagonal, mixed
 *     uint scarp_answer_recipe(i)            the self-test: answer i of scarp_recipe_answers
 *
 * with float coordinates, in space x, y and z. Several underscores in a row in a NAME become one.
 * After them come those functions of the file that they use, and no others. `if` leaves out what
 * masks hide. Derivatives above `order`, or above those that an output has, mean nothing. In GLSL
 * and HLSL the macros of the file say where the buffer is (SCARP_BINDING, SCARP_REGISTER). In WGSL
 * the shader declares
 *
 *     @group(0) @binding(0) var<uniform> scarp_plan: ScarpRecipePlan;
 *
 * Equal bits: under the conditions above, outputs are those of scarp_recipe_sample. Where a recipe
 * uses sine(), one result in some 10^8 may be off in the last place.
 *
 * When the text changes: scarp_recipe_seed never changes it. scarp_recipe_set changes it if a
 * number becomes one that makes a function simpler, as a factor of 1, or stops being one, or if
 * there are more octaves; scarp_recipe_tile and scarp_recipe_scale may change it, too. Then call
 * scarp_recipe_shader again, and if its text differs, compile the shader again.
 *
 * Room: *length becomes the length of the text without the 0 behind it. If there is no room for
 * both, the call writes nothing useful to `text`, and returns SCARP_ERROR_SIZE. A capacity of
 * *length + 1 then suffices, and may be more than is needed.
 *
 * Errors:
 *
 *     SCARP_ERROR_NULL         `recipe`, `how`, how->file or `length` is NULL, or `text` is with a
 *                              capacity above 0
 *     SCARP_ERROR_PARAMETER    *recipe is no recipe, or has errors; the order does not exist; or
 *                              the file is not that of the language
 *     SCARP_ERROR_ENUM         the language is unknown
 */
SCARP_API enum scarp_status scarp_recipe_shader(const struct scarp_recipe *recipe,
                                                const struct scarp_shader *how, char *text,
                                                size_t capacity, size_t *length);

/*
 * scarp_recipe_uniforms - write the uniform buffer of that shader
 *
 * Seed and parameters are in here. The layout is that of std140: 16 bytes, then vectors of 16,
 * levels of 48 and octaves of 160 bytes (struct scarp_gpu_level, struct scarp_gpu_octave). `bytes`
 * may stand wherever a float may. *size becomes the size. A recipe with 30 octaves takes about 6
 * KiB. Devices have at least 16 KiB, most of them 64.
 *
 * Errors: SCARP_ERROR_SIZE if the capacity is less than *size; others as scarp_recipe_shader.
 */
SCARP_API enum scarp_status scarp_recipe_uniforms(const struct scarp_recipe *recipe, void *bytes,
                                                  size_t capacity, size_t *size);

/*
 * scarp_recipe_answers - what a shader of a recipe must answer: a test for the start of a program
 *
 * answer[i], for i < SCARP_GPU_ANSWERS, is a hash of all outputs at test point i. Each output
 * counts with its derivatives up to `order`, from 0 to 2, as far as it has them.
 * scarp_answer_recipe(i) of a shader with this order gives the same number. Points lie around the
 * origin, some thousand cells of the first noise away.
 *
 * Errors: SCARP_ERROR_NULL if a pointer is NULL; SCARP_ERROR_PARAMETER as scarp_recipe_shader.
 */
SCARP_API enum scarp_status scarp_recipe_answers(const struct scarp_recipe *recipe, int order,
                                                 uint32_t *answer);

/*
 * Words, instruction sets
 */

/*
 * scarp_basis_name, scarp_fade_name, scarp_fractal_name - the enumerators as words
 *
 * "gradient", "value", "simplex", "cell-f1", "cell-f2", "cell-edge", "cell-soft", "cell-value";
 * "quintic", "cubic"; "fbm", "turbulence", "ridged", "erosion", "pingpong", "hybrid", "swiss",
 * "jordan". The words are static and never change. Numbers that are no enumerator give NULL.
 * Enumerators count up from 0 without gaps, so a list of them ends where the name is NULL:
 *
 *     for (enum scarp_basis basis = 0; scarp_basis_name(basis) != NULL; basis++)
 */
SCARP_API const char *scarp_basis_name(enum scarp_basis basis);
SCARP_API const char *scarp_fade_name(enum scarp_fade fade);
SCARP_API const char *scarp_fractal_name(enum scarp_fractal fractal);

/* scarp_status_text - what a status means: a sentence without a full stop, never NULL */
SCARP_API const char *scarp_status_text(enum scarp_status status);

/* scarp_version - the version of the library that runs, as "major.minor.patch" */
SCARP_API const char *scarp_version(void);

/* Kernel sets, each for an instruction set. One of them serves all calls: at the first call the
   library chooses the best one that processor and operating system can run. Results do not depend
   on it. The calls below exist for tests, comparisons and information. The order of the enumerators
   says nothing about speed. */
enum scarp_isa {
    SCARP_ISA_NONE, /* in scarp_isa_select: the best one */
    SCARP_ISA_SCALAR,
    SCARP_ISA_SSE41,
    SCARP_ISA_AVX2,
    SCARP_ISA_AVX512,
    SCARP_ISA_NEON,
    SCARP_ISA_GENERIC, /* portable vector code; the best wherever no other set runs */
    SCARP_ISA_WASM128  /* the vectors of WebAssembly */
};

/* scarp_isa_active - the kernel set in use; SCARP_ISA_NONE if calls refuse to compute ("Bits") */
SCARP_API enum scarp_isa scarp_isa_active(void);

/* scarp_isa_supported - nonzero if this build has the kernel set, with the bits that it should give
   ("Bits"), and this processor can run it, else 0. SCARP_ISA_NONE and numbers that are no
   enumerator give 0. */
SCARP_API int scarp_isa_supported(enum scarp_isa isa);

/*
 * scarp_isa_select - use a kernel set from now on, in all threads
 *
 * SCARP_ISA_NONE returns to the best one. Calls under way finish with the set they began with.
 *
 * Errors: SCARP_ERROR_ENUM for an unknown `isa`, SCARP_ERROR_UNSUPPORTED if it cannot run here, or
 * would not give its bits. The choice is then unchanged.
 */
SCARP_API enum scarp_status scarp_isa_select(enum scarp_isa isa);

/*
 * scarp_isa_name - "none", "scalar", "sse4.1", "avx2", "avx512", "neon", "generic", "wasm128"
 *
 * Numbers that are no enumerator give NULL, so this loop visits all kernel sets, whether this build
 * has them or not:
 *
 *     for (enum scarp_isa isa = SCARP_ISA_NONE + 1; scarp_isa_name(isa) != NULL; isa++)
 */
SCARP_API const char *scarp_isa_name(enum scarp_isa isa);

#ifdef __cplusplus
}
#endif

#undef SCARP_ZERO

/*
 * Formulas
 *
 * These sections define what the library computes, so that you can compute it again. They give
 * every number but for rounding. Bits also depend on the order of operations, which is that of
 * src/formulas and src/scalar in the source.
 *
 * Letters: n is the number of dimensions, 2 or 3. x is the input, a vector. k counts octaves from
 * 0, and K is their number. A vector is a column, J^T the transpose of J, I the identity, and a . b
 * the scalar product. Names such as frequency are members of struct scarp_noise, with their
 * defaults filled in.
 *
 * Sections: Octaves, Fractals, Fractals that bend, Creases and overflow, Jumps, Seeds, Lattice,
 * Gradient and value noise, Simplex, Cells, Periods, Flow, Vector noise, Warps, Rounding, Gullies.
 */

/*
 * Octaves
 *
 * There are K = ceil(octaves) octaves, with the frequencies f_k = frequency * lacunarity^k. Octave
 * k looks at the position
 *
 *     p_k = J_k x + o_k,      J_k = f_k R^k.
 *
 * - R is the turn between octaves: (0.8 -0.6; 0.6 0.8) in 2D and (0 0.8 0.6; -0.8 0.36 -0.48; -0.6
 *   -0.48 0.64) in 3D. Without `rotate`, R is the identity.
 * - o_k is an offset in [0, 1)^n, so that octaves do not line up at the origin. "Seeds" tells it.
 *   Without `offset_first`, o_0 is 0. Then all seeds are alike near the origin, which is a lattice
 *   point of octave 0: gradient noise is 0 there, and ridged noise of 6 octaves has a mean of 0.77,
 *   elsewhere 0.54. With `offset_first` no place is special: octave 0 is moved by less than a cell
 *   along each axis, and nothing else changes, such as ranges, periods and ids of cells.
 * - n_k is the noise of the octave: the basis at p_k, scaled so that |n_k| reaches 1.
 * - g_k = grad n_k and H_k are the derivatives of n_k by p_k. By x they are G_k = J_k^T g_k and
 *   J_k^T H_k J_k. So gradients and Hessians are per unit of input.
 * - a_k is the amplitude of the octave:
 *
 *     a_k = amplitude (1 - 2^-17) w_k / (w_0 + ... + w_(K-1)),   w_k = gain^k
 *
 * The factor 1 - 2^-17 is head-room for rounding: it lets scarp_range promise an interval.
 *
 * Fractions: if `octaves` has a fraction, w_(K-1) is multiplied by it. So octaves can be faded in
 * without a pop. If `octaves` is below 1 (and `of_octaves` is 0), that changes nothing, since w_0 /
 * w_0 is 1 with any factor: a single octave always has its full amplitude.
 *
 * Levels of detail: with `of_octaves`, amplitudes are those of a sum of that many octaves. The
 * divisor has the K and the fraction of `of_octaves`. The octaves that are summed, and the fraction
 * of the last one, are those of `octaves`. So 3 octaves of 8 are the first three of the eight, with
 * the same bits for each, and a level of detail changes no coarse shape.
 */

/*
 * Fractals
 *
 *     fBm         value = sum_k a_k n_k
 *                 gradient = sum_k a_k G_k           Hessian = sum_k a_k J_k^T H_k J_k
 *     turbulence  value = sum_k a_k |n_k|
 *                 gradient = sum_k a_k sign(n_k) G_k, and likewise the Hessian; sign(0) = 0
 *     ridged      value = sum_k a_k s_k,   s_k = v_k (1 - |n_k|)^2,   v_0 = 1,
 *                 v_(k+1) = 2 s_k, but 1 where that is more.
 *                 The derivatives are those of this expression, with sign(0) = 0. Those of v_(k+1)
 *                 are 0 where it is 1.
 *     erosion     value = sum_k a_k q_k n_k,   q_k = 1 / (1 + erosion d_k . d_k),
 *                 d_k = g_0 + ... + g_k, each g in the axes and units of its own octave.
 *                 gradient = sum_k a_k (q_k G_k - 2 erosion n_k q_k^2 D_k^T d_k),
 *                 D_k = H_0 J_0 + ... + H_k J_k, which is the Jacobian of d_k
 *     ping-pong   value = sum_k a_k (1 - 2 |e_k|),   e_k = 1 - (t_k - 2 floor(t_k / 2)),
 *                 t_k = (n_k + 1) sharpness, which is folded to [-1, 1] with the period 2.
 *                 gradient = sum_k a_k 2 sharpness sign(e_k) G_k, and likewise the Hessian, but 0
 *                 where 1 - 2 |e_k| is 1 or -1
 *     hybrid      value = sum_k a_k u_k,   u_k = v_k ((1 - 2^-17) n_k + sharpness),   v_0 = 1,
 *                 v_(k+1) = gain^k u_k, but 1 where that is more and -1 where it is less.
 *                 The derivatives are those of this expression. Those of v_(k+1) are 0 where it is
 *                 1 or -1. Amplitudes have another divisor and head-room:
 *                 a_k = amplitude (1 - 2^-16) w_k / U, where U is what w_0 u_0 + ... +
 *                 w_(K-1) u_(K-1) is if every (1 - 2^-17) n_k is 1
 *
 * Every gradient is the gradient of the value that is returned.
 *
 * Relations to other libraries:
 *
 * - libnoise's RidgedMulti with the exponent 1 is ridged noise with gain = 1 / lacunarity, times
 *   1.25, less 1, not normalised.
 * - FastNoise Lite's PingPong with a weighted strength of 0 is ping-pong noise. Its strength is the
 *   sharpness.
 * - Musgrave's hybrid multifractal is hybrid noise with gain = lacunarity^-H. His offset, 0.7, is
 *   the sharpness. His H of 0.25 is a gain of 0.84. He lets weights fall below -1, which they do
 *   with gains near 1 and above. His values have no bound then.
 */

/*
 * Fractals that bend
 *
 * Swiss and Jordan noise (de Carpentier 2012) bend octaves: octave k looks at p_k = J_k y_k + o_k
 * with y_k = x + c_k S_k. S_k adds up slopes of the octaves before. With m_i = (gradient of n_i by
 * y_i) / f_i, the slope of octave i per cell in the axes of the input,
 *
 *     Swiss       value = sum_k a_k u_k max(0, 1 - |n_k|),   u_0 = 1,
 *                 u_(k+1) = u_k min(1, (this sum up to k) / a_0),
 *                 c_k = sharpness / f_0,   S_k = - sum_(i < k) (a_i / a_0) u_i n_i m_i
 *     Jordan      value = sum_k a_k q_k n_k^2,   q_0 = 1, q_k = 1 - erosion / (1 + S_k . S_k),
 *                 c_k = sharpness / f_k,   S_k = sum_(i < k) n_i m_i
 *
 * The a_k of Jordan noise have the factor 1 - 2^-17 twice. sharpness says how far octaves are bent:
 * by default 0.15 for Swiss noise, whose crests become sharp and whose flanks fall to smooth
 * valleys, and 0.35 for Jordan noise. The erosion of Jordan noise, at most 1, keeps small octaves
 * out of flat ground. Gradients go through the Jacobians of y_k. The gradient of |n_k| takes
 * sign(0) as 0. That of max(0, 1 - |n_k|) is 0 where |n_k| is more than 1.
 */

/*
 * Creases and overflow
 *
 * Gradients and Hessians hold almost everywhere. The exceptions are creases of the surface:
 *
 *     turbulence      where an n_k is 0
 *     ridged          where an n_k is 0, or a 2 s_k is 1
 *     ping-pong       where a t_k is an integer
 *     hybrid          where a |gain^k u_k| is 1
 *     Swiss           where an n_k is 0, or a sum up to k is a_0
 *     cubic fade      between cells, in erosion, and with more than one octave in Swiss and Jordan
 *                     noise: these have gradients of n_k in their values, and the Hessian of the
 *                     cubic fade jumps
 *     cellular noise  where features are equally near, except cell-soft: see "Cells"
 *
 * Derivatives may overflow here:
 *
 *     ridged          Hessians, where amplitude f_k^2 comes near 2^120
 *     ping-pong       Hessians, where amplitude f_k^2 2 sharpness comes near 2^120
 *     hybrid          Hessians, where amplitude f_k^2 comes near 2^120; with gains above 1 Hessians
 *                     and gradients, where amplitude f_k^2, or amplitude f_k, times the product of
 *                     all gain^j comes near it
 *     Swiss, Jordan   gradients, which grow with each octave. Positions of Swiss noise may
 *                     overflow, too, where gain^K comes near 2^120.
 *     cellular noise  Hessians at features, where amplitude f_k^2 comes near 2^86
 *     warps           products of derivatives, where those of the warps and of the noise are too
 *                     large together
 *
 * Where |a_0| is below 2^-128, all octaves of Swiss noise but the first may vanish.
 */

/*
 * Jumps
 *
 * But for rounding, the value jumps in these cases, and in no others:
 *
 *     basis                          fractal                 K    where
 *     cell-value                     any                     any  on borders between cells
 *     cell-f1, cell-f2, cell-edge    erosion, Swiss, Jordan  > 1  where a gradient of the basis
 *                                                                 jumps: see "Cells"
 *     cell-edge                      erosion                 1    where F2 is the distance from two
 *                                                                 features, and at features
 *     cell-f1                        erosion                 1    at features, which are points
 *
 * Erosion, Swiss and Jordan noise have gradients of the basis in their values, so a crease of the
 * basis becomes a jump. A noise also jumps where its warp does. Creases of a warp become creases.
 * Gradients and Hessians do not show a jump: they are those of one side.
 */

/*
 * Seeds
 *
 * splitmix64(z) is the generator of Steele, Lea and Flood (2014) started at z. Its numbers are
 * counted from 1. All arithmetic is modulo 2^64, so a negative seed, such as -1, is 2^64 more.
 * Number j is
 *
 *     mix(z + j 0x9e3779b97f4a7c15),   mix(z) = z'' ^ (z'' >> 31),
 *     z'' = (z' ^ (z' >> 27)) 0x94d049bb133111eb,   z' = (z ^ (z >> 30)) 0xbf58476d1ce4e5b9.
 *
 * Octave k has the seed s_k: s_0 is `seed`, and s_k is number k of splitmix64(first number of
 * splitmix64(seed)). From its seed an octave draws a, b and c, the first three numbers of
 * splitmix64(first number of splitmix64(s_k)):
 *
 *     keys      for x the low 32 bits of a, for y the top 32 bits of a, for z the low 32 bits of b
 *     offsets   o_k = 2^-24 times (the top 24 bits of b, the low 24 bits of c, the top 24 bits
 *               of c)
 *
 * o_0 is 0 all the same, unless `offset_first` is set. So an octave is noise of its own: n_k at x
 * is, but for rounding, the value of single-octave noise at p_k, divided by 1 - 2^-17. That noise
 * has the seed s_k, frequency 1, no offset, 2^k times the phase, and the same basis, fade and
 * jitter.
 */

/*
 * Lattice
 *
 * A lattice point (i, j) or (i, j, k) of whole numbers has a hash. All arithmetic is modulo 2^32.
 * u >>> 8 is u whose 32 bits are rotated to the right by 8:
 *
 *     2D    h = ((i 0x1a2012f5 + key_x) >>> 8) ^ ((j 0x14e84743 + key_y) >>> 8)
 *     3D    h = that ^ ((k 0xec1d7da1 + key_z) >>> 8)
 *     hash = h (h + 0x9e3779b9)
 *
 * The position p lies in the cell of the lattice point floor(p).
 */

/*
 * Gradient and value noise
 *
 * With t = p - floor(p), a corner c of the cell, whose elements are 0 and 1, has the weight W_c,
 * the product over the axes of fade(t_i) where c_i is 1 and of 1 - fade(t_i) where c_i is 0.
 * Corners draw gradients g_c, or values, from the hashes of their lattice points:
 *
 *     gradient noise  raw noise sum_c W_c g_c . (t - c)
 *     value noise     n_k = sum_c W_c value_c,   value_c = hash as a signed number, over 2^31
 *
 * 2D gradients have 16 directions, 11.25 degrees + q * 22.5. With j the number that bits 30 and 29
 * of the hash make,
 *
 *     g = (+-cos(11.25 + 22.5 j), +-sin(11.25 + 22.5 j)),
 *
 * where x is negative if bit 31 is 1 and y is negative if bit 28 is 1. 3D gradients are the 12 edge
 * directions of improved noise (Perlin 2002), each as often as any other. Number floor(12 h /
 * 2^16), h being the upper 16 bits of the hash, is drawn, counted from 0, from (1,1,0) (1,-1,0)
 * (-1,1,0) (-1,-1,0) (1,0,1) (1,0,-1) (-1,0,1) (-1,0,-1) (0,1,1) (0,1,-1) (0,-1,1) (0,-1,-1).
 *
 * n_k of gradient noise is the raw noise divided by its supremum:
 *
 *     quintic fade   2D 0.6953527, 3D 1.0363538
 *     cubic fade     2D 0.6958100, 3D 1.0449052
 */

/*
 * Simplex (Perlin 2001, Gustavson 2005)
 *
 * Vertices v draw gradients g_v, of the same kind as those of gradient noise. With d = p - v and w
 * = max(0, r^2 - d.d), all vertices together make the raw noise
 *
 *     sum_v w^4 g_v . d,      gradient sum_v w^4 g_v - 8 w^3 (g_v . d) d,
 *     Hessian sum_v 48 w^2 (g_v . d) d d^T - 8 w^3 (g_v d^T + d g_v^T + (g_v . d) I).
 *
 * All three are continuous.
 *
 * - 2D: vertices are the corners of triangles of edge 1 whose sides lie along x: (i, j sqrt(3) / 2)
 *   for even j, and (i + 1/2, j sqrt(3) / 2) for odd j. Each draws from the hash of (i, j). r^2 =
 *   3/4.
 * - 3D: vertices are the corners (i, j, k) of cubes, and their centres (i + 1/2, j + 1/2, k + 1/2),
 *   which make tetrahedra. Each draws from the hash of (i, j, k), centres with 0xbcfa3e4d in the
 *   place of 0x9e3779b9. r^2 = 1/2 - 2^-21.
 *
 * r is so small that w is 0 at every vertex but the corners of the triangle or tetrahedron around
 * p. So three or four vertices count. n_k is the raw noise divided by its supremum: 0.0623669522 in
 * 2D, and 0.0130071013 in 3D.
 *
 * Periods: in 3D any; in 2D along x alone, since rows are sqrt(3) / 2 apart. There, period[1] is
 * SCARP_ERROR_UNSUPPORTED. A slice of 3D, such as z = 0, repeats along both of its axes.
 */

/*
 * Cells (Worley 1996, with one feature per cell)
 *
 * Each cell c of the integer lattice has a feature at c_i + 1/2 + jitter v_i along each axis. The
 * v_i are uniform in [-1/2, 1/2]. v_x is the hash of c as a signed number, over 2^32; v_y is that
 * of the hash times 0xe41130e9, v_z that of the hash times 0x6ecea30d. The id of the cell is the
 * hash times 0xc603dc87 (modulo 2^32), and the value of cell-value the id as a signed number, over
 * 2^31.
 *
 * F1 and F2 are the distances from p to the nearest feature and to the second nearest, V = sqrt(sum
 * of a^8) over all features with a = max(0, 1 - distance^2). With j = jitter:
 *
 *     basis        raw value       largest raw value
 *     cell-f1      F1              sqrt(n) (1 + j) / 2
 *     cell-f2      F2              2D: sqrt(1 + j + j^2 / 2); 3D: sqrt(1 + j + 3 j^2 / 4), but
 *                                  sqrt(3) (1 + j) / 2 where that is more, from j = 1/2 on
 *     cell-edge    F2 - F1         as cell-f2 (3D, 1/2 < j < 1: up to 3.2 % less is reached)
 *     cell-soft    -V              0; the least is -2^(n/2) (1 - n ((1 - j) / 2)^2)^4, which is
 *                                  reached; with j < 9/16 it stays what it is for 9/16
 *     cell-value   drawn           1; the least is -1
 *
 * n_k maps the interval from the least raw value (0 of the first three) to the largest onto [-1,
 * 1]. So -1 is at features for cell-f1, on borders for cell-edge, and where features crowd for
 * cell-soft. cell-soft is 1 where no feature is within 1.
 *
 * Derivatives: the distance from a feature is F = |d|, d = p - feature. Its gradient is d / F, its
 * Hessian (I - (d / F) (d / F)^T) / F. Both are taken as 0 where F < 2^-40: there the surface has
 * the tip of a cone. Where features are equally near, cell-f1, cell-f2 and cell-edge have a crease,
 * and their gradient is that of one of the features. Elsewhere their gradients and Hessians hold.
 * Towards a feature, their Hessians grow like 1 / F. Derivatives of cell-soft are continuous, those
 * of cell-value are 0.
 *
 * The search is exact: it compares every feature that can be among the two nearest, including those
 * two cells off. Features of a period repeat with it, whatever its length.
 */

/*
 * Periods
 *
 * Along an axis with a period P, the lattice of octave k draws for cell i what it draws for i mod P
 * lacunarity^k, in [0, P lacunarity^k). So the noise, with all its derivatives, repeats every P /
 * frequency units of input, and a tile of that length has no seam. Ranges stay.
 *
 * Errors: with several octaves, SCARP_ERROR_PARAMETER if lacunarity is not an integer, or P
 * lacunarity^(K-1) is above 2^30. Axes that are turned cannot repeat: that is
 * SCARP_ERROR_UNSUPPORTED.
 *
 * Points that lie a period apart have the same bits if their p_k have the same fractions, as with
 * coordinates and frequencies that are multiples of powers of two: o_k has 24 bits behind the
 * point, so doubles have room for sums with it, and floats have not. Elsewhere they differ by
 * rounding. Floats repeat wherever they have cells, doubles up to |p_k| = 2^50.
 */

/*
 * Flow (Perlin and Neyret 2001)
 *
 * With a phase a, in turns, the gradients of gradient noise turn where they stand: a gradient of
 * octave k by s 2^k a turns, where s is its speed. In 2D, gradients at 11.25 degrees + q * 45 have
 * s = 1 and turn left, those at 33.75 + q * 45 have s = -2. In 3D, the 12 edges are four triangles
 * around the diagonals d of a cube. Each triangle turns in its plane, g towards d x g:
 *
 *     d            edges                                s
 *     ( 1, 1, 1)   (1,-1,0)  (-1,0,1)   (0,1,-1)        1
 *     ( 1,-1,-1)   (1,1,0)   (-1,0,-1)  (0,-1,1)        1
 *     (-1, 1,-1)   (-1,-1,0) (1,0,-1)   (0,1,1)         2
 *     (-1,-1, 1)   (-1,1,0)  (1,0,1)    (0,-1,-1)       2
 *
 * So the noise does not drift, and its statistics stay: at every phase the mean of g g^T is the
 * same, and the same along all axes, and so are the moments of the fourth order.
 *
 * Loops: a whole turn is a loop. Phases a and a + 1 have the same bits if both are exact as floats.
 * Phase 0 has the bits of calls without a phase. Small octaves move faster: octave k makes 2^k
 * loops a turn, and its fastest gradients 2^(k+1).
 *
 * Range: with a phase, |n_k| may be more than 1. It is at most 1.0169038 (quintic) and 1.0162356
 * (cubic) in 2D, 1.1100620 and 1.1037150 in 3D. scarp_range counts that in.
 *
 * dphase is the derivative of the value with respect to the phase. It may be asked for with any
 * other output. For fBm and turbulence, |dphase| is at most 4 pi sum_k 2^k |a_k| times those
 * numbers, for ping-pong that times 2 sharpness.
 *
 * Value noise has no gradients to turn, and the gradients of simplex noise do not turn: with any
 * basis but SCARP_GRADIENT, a phase, and dphase, is SCARP_ERROR_UNSUPPORTED.
 */

/*
 * Vector noise
 *
 * Vector noise has a component for each axis: 0, 1 and in space 2. It displaces the positions of a
 * warp, makes the potentials of scarp_curl3, and is what scarp_vector2 and its like give. The
 * components of a noise w have all that w has except its seed. t_j is number j of splitmix64(first
 * number of splitmix64(w.seed)). From j = 33 on, no octave has that number as its seed.
 *
 *     gradient, value  All components use the lattice of the seed t_33. Component 0 is the noise w
 *                      with that seed. Components 1 and 2 draw other gradients, or values, at the
 *                      same lattice points, from the same hashes. They are as uniform as those of
 *                      component 0, and independent of them. No seed has them as its noise.
 *     other bases      Component i is the noise w with the seed t_(33 + i).
 *
 * What component c puts in the place of a hash, with arithmetic modulo 2^32:
 *
 *     2D gradients     hash 2^(4 c)
 *     3D gradients     (hash >> 16) 12^c 2^16
 *     values           component 1: (hash >>> 16) 0x9e3779b1, component 2: (hash >>> 16) 0x85ebca6b
 *
 * Each component is in the range of w. One call for all components takes less time than a call for
 * each: where they share a lattice, they have cells, fractions and hashes in common. If octaves
 * bend they do not, since each component bends its own.
 */

/*
 * Warps
 *
 * With noise.warp = &w, the noise is n(y), y = x + d(x), where d is the vector noise w, in every
 * bit what scarp_vector2 and its like give of w. d is in units of input. scarp_range of w tells how
 * far x may be displaced along each axis; turbulence and its like displace it to one side. A warp
 * changes no range.
 *
 * Derivatives go through the Jacobian J = I + D: the gradient is J^T g, the Hessian J^T H J + sum_i
 * g_i H_i, where g and H are those of n at y, D and H_i those of d at x. A warp must have
 * derivatives of the order that is asked for, else calls return SCARP_ERROR_UNSUPPORTED. dphase is
 * the derivative with respect to the noise's own phase.
 *
 * w may have a warp, too, up to four in all: with e the warp of w, d is w at x + e(x). If warp and
 * noise repeat after the same lengths of input, the whole does. On grids the deepest warp is as
 * fast as grids are, the other warps and the noise as fast as points.
 *
 * Float coordinates are displaced in float: y is a float. Double coordinates, and those of grids,
 * are displaced within the cells of each octave: J_k x + o_k is computed in double and split into
 * cell and fraction, J_k d in float and split likewise, and the fractions are added in float. Where
 * their sum is 1 or more, the cell goes up by 1. So a displacement is as exact far from the origin
 * as near. Octaves of Swiss and Jordan noise are bent in the same way: c_k S_k is added to d.
 */

/*
 * Rounding
 *
 * Floats: positions are computed in float, so detail fades as |p_k| nears 2^23 cells. For |p_k| >=
 * 2^31 the cell is -2^31 along that axis, and the fraction 0.
 *
 * Doubles: positions are computed in double, and reduced to cell and fraction before anything is
 * rounded to float. At |p_k| = 2^40 cells the fraction still has 12 bits. Cells wrap modulo 2^32 up
 * to |p_k| = 2^51. Beyond, the low bits of the cell are lost, but the result is defined and the
 * same everywhere.
 *
 * Doubles with turned axes: p_k is the sum of two parts, of which one depends on the first
 * coordinate, and the other on the other coordinates, with o_k. The limits above, and the rule for
 * positions that overflow, hold for each part. Each part is rounded to a multiple of 2^-24 cells
 * (in 2D simplex noise, along y, to a multiple of 2^-24 rows of its lattice). So p_k is off by at
 * most 2^-24 cells, and the samples of a grid share what is computed for their column and their
 * row.
 */

/*
 * Gullies
 *
 * The members here are those of struct scarp_gullies. With h = base / amplitude, g = its gradient
 * and lengths in cells of the base, S(z) = z^2 (3 - 2 z) of z = (h - low) / (high - low), held
 * within [0, 1], the slope is
 *
 *     s = g / sqrt(g.g + slope_low^2 (1 - S) + slope^2 S),   M = s.s in [0, 1).
 *
 * So M is 1/2 where |g| is `slope` on crests, or `slope_low` on floors. The exposure v is in [-1,
 * 1], and begins with v = 1 - (1 - S) (1 + floor). Octave k of gullies has f_k = cells lacunarity^k
 * cells per cell of the base, R^k, p_k and o_k as a noise of this seed and `offset_first` has them
 * ("Octaves"), and the weight w_k = depth gain^k / (sum of gain^k). It draws waves with stripes
 * along the slope. t is the direction across the slope. At each corner c of the cell of p_k the
 * lattice draws the phase psi_c, the hash of value noise as a signed number over 2^32. W_c are the
 * weights of value noise with the quintic fade. Then
 *
 *     t = (-s_y, s_x) / sqrt(s.s + 0.05^2)
 *     Z = sum of W_c e^(2 pi i (psi_c + stripes (R^k t).(p_k - c)))
 *     C + i S' = Z / sqrt(|Z|^2 + 0.5^2)
 *     P = 1 - 2 (sqrt((1 - C) / 2 + round^2) - round) / (sqrt(1 + round^2) - round)
 *     m = M (1 - keep v^2), but M where k = 0
 *     v_k = v + m (P - v), which is the v of the next octave
 *     s := s - branch m S' t
 *
 * The displacement is amplitude times the sum of the w_k v_k. P is 1 on sharp crests and -1 on
 * round floors. On flat ground, the displacement is depth times v: crests rise, and floors sink by
 * `floor` of it. The steering s is as defined here, and is not the slope of the result. So
 * derivatives need nothing but the base's Hessian.
 */

#endif
