/* SPDX-License-Identifier: MIT
 *
 * scarp: noise and its exact derivatives for arrays of points.
 * This file is the whole public interface, its contracts, and the only source of the version.
 */
#ifndef SCARP_H
#define SCARP_H

#include <stddef.h>
#include <stdint.h>

#define SCARP_VERSION_MAJOR 0
#define SCARP_VERSION_MINOR 2
#define SCARP_VERSION_PATCH 0

#if defined(_WIN32) && defined(SCARP_BUILDING_SHARED)
#define SCARP_API __declspec(dllexport)
#elif defined(_WIN32) && defined(SCARP_SHARED)
#define SCARP_API __declspec(dllimport)
#elif defined(__GNUC__)
#define SCARP_API __attribute__((visibility("default")))
#else
#define SCARP_API
#endif

/* From C++14 on, members of structures are 0 unless they are given. Elsewhere this is nothing.
   Plans, recipes and constants of shaders, which calls write as a whole, go without: so declaring
   one takes no time. */
#if defined(__cplusplus) &&                                                                        \
    (__cplusplus >= 201402L || (defined(_MSVC_LANG) && _MSVC_LANG >= 201402L))
#define SCARP_ZERO = {}
#else
#define SCARP_ZERO
#endif

#ifdef __cplusplus
extern "C" {
#endif

/*
 * What holds for every function here
 *
 * - Arguments are checked before anything is written. On an error the outputs are untouched.
 * - The same call gives the same bits on every processor, instruction set, compiler and
 *   optimisation level. The payload of a NaN is not promised.
 * - A point has one value: its position in the array, the length of the array, the other points
 *   and the set of outputs asked for change nothing.
 * - The caller's floating-point mode (flush to zero, denormals are zero, rounding direction,
 *   unmasked exceptions) neither changes a result nor is changed. On processors other than x86 and
 *   AArch64 that holds for the rounding direction; the rest must be at its default there.
 * - Any thread may call any function at any time. Nothing is allocated, printed or read from the
 *   environment, and errno is left alone. A call takes less than 48 KiB of stack, with every kernel
 *   set, so a thread or a fiber with 64 KiB will do. That holds from -O1 on, and for hardened
 *   builds (-fstack-protector-strong, -fstack-clash-protection, -fcf-protection); measured with
 *   gcc 12 and clang 14 and 19. Kernels that are compiled without optimisation take more.
 *
 * Zero a structure before you fill it in: `struct scarp_noise noise = {0};`, a designated
 * initialiser, or memset. In C++ write `scarp_noise noise{};`, or in C++20 a designated
 * initialiser; compilers warn of memset there. scarp.hpp has the calls with spans, for C++20.
 * Reserved members have no meaning yet. A call that finds one in use (a number that is not 0, a
 * pointer that is not NULL) returns SCARP_ERROR_UNSUPPORTED: so a program that was built for a
 * later version is refused by this one, and never misunderstood. Later versions give meanings to
 * reserved members; sizes, and the places of members, stay.
 *
 * What versions promise, once the major version is 1:
 *
 * - Source: a program that compiles with a version compiles with later ones of the same major
 *   version. Names that start with scarp_ and SCARP_ may be added.
 * - Binary interface: a program runs, without being built again, with a shared library of the same
 *   major version that is not older than the one it was built for. The SONAME tells that version.
 * - Bits: a noise has the same values and derivatives, to the bit, in all versions of the same
 *   major version, so a world can be continued. Another order of operations, another hash, or the
 *   correction of a wrong value is a new major version.
 *
 * While the major version is 0, a minor version counts as a major one: 0.2.1 keeps all of that,
 * 0.3.0 may not. The changelog says what changed.
 */

enum scarp_status {
    SCARP_OK = 0,
    SCARP_ERROR_NULL,       /* a pointer that the call needs is NULL */
    SCARP_ERROR_ENUM,       /* an enumerator that does not exist */
    SCARP_ERROR_PARAMETER,  /* a number that is not finite, or outside its documented interval */
    SCARP_ERROR_SIZE,       /* a count so large that its arrays cannot exist in memory */
    SCARP_ERROR_UNSUPPORTED /* a request that this version, call or processor cannot serve */
};

/* The noise of one octave. All are defined on a lattice, which repeats after 2^32 cells along each
   axis. */
enum scarp_basis {
    SCARP_GRADIENT,  /* Perlin's gradient noise: 0 on every lattice point, a gradient drawn there.
                        2D: 16 directions, 11.25 degrees + k * 22.5; 3D: the 12 edge directions
                        of improved noise (Perlin 2002), each as often as any other. */
    SCARP_VALUE,     /* value noise: a value drawn on every lattice point, uniform in [-1, 1] */
    SCARP_SIMPLEX,   /* simplex noise (Perlin 2001): gradients on triangles and tetrahedra. See
                        "Simplex". */
    SCARP_CELL_F1,   /* cellular noise (Worley 1996): the distance to the nearest feature. For these
                        five see "Cells". */
    SCARP_CELL_F2,   /* the distance to the second nearest */
    SCARP_CELL_EDGE, /* the second distance less the first: 0 on the borders between cells */
    SCARP_CELL_SOFT, /* a smooth F1, whose Hessian is continuous */
    SCARP_CELL_VALUE /* a value for each cell, uniform in [-1, 1] */
};

/* The blend between lattice points, for t in [0, 1] across a cell: of gradient and value noise. */
enum scarp_fade {
    SCARP_QUINTIC, /* 6t^5 - 15t^4 + 10t^3: the Hessian is continuous */
    SCARP_CUBIC    /* 3t^2 - 2t^3: the gradient is continuous, the Hessian jumps between cells */
};

/* How octaves are summed. */
enum scarp_fractal {
    SCARP_FBM,        /* fractional Brownian motion: the weighted sum of octaves */
    SCARP_TURBULENCE, /* the weighted sum of their magnitudes: billows with creases (Perlin 1985) */
    SCARP_RIDGED,     /* ridged multifractal (Musgrave 1994): creases become ridges, and octaves
                         are weighted by those before, so valleys are smooth */
    SCARP_EROSION,    /* fBm whose octaves are damped where the sum of slopes is steep (Quilez
                         2008): ridges and eroded flanks. No Hessian. */
    SCARP_PINGPONG,   /* the weighted sum of octaves that are folded to and fro, which draws contour
                         lines (FastNoise Lite) */
    SCARP_HYBRID,     /* hybrid multifractal (Musgrave 1994): octaves are weighted by the product of
                         those before, so valleys are smooth and heights rough */
    SCARP_SWISS,      /* ridges whose octaves are bent by the slopes of those before, downhill
                         (de Carpentier 2012). No Hessian, no dphase. */
    SCARP_JORDAN      /* squared octaves that are bent, and damped where it is flat (de Carpentier
                         2012). No Hessian, no dphase. */
};

/* Kernel sets, one of which serves all calls. Their order says nothing about speed. */
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

/*
 * What to sample. All zero is valid: one octave of quintic gradient noise with seed 0, one lattice
 * cell per unit of input. A zero in a numeric field means its default.
 *
 * With f_k = frequency * lacunarity^k and K = ceil(octaves) octaves, octave k looks at
 *
 *     p_k = J_k x + o_k,      J_k = f_k R^k,
 *
 * where x is the input, R the turn between octaves (the identity unless `rotate`), and o_k an
 * offset in [0, 1)^n, so that octaves do not line up at the origin; o_0 is 0. n_k, the octave's
 * noise, is the basis at p_k, scaled so that |n_k| reaches 1 (raw gradient noise of unit vectors in
 * 2D and of edges (1, 1, 0) in 3D is divided by its suprema: 0.6953527 and 1.0363538 with the
 * quintic fade, 0.6958100 and 1.0449052 with the cubic one). g_k = grad n_k and H_k are its
 * derivatives with respect to p_k; with respect to x they are G_k = J_k^T g_k and J_k^T H_k J_k.
 *
 *     a_k = amplitude (1 - 2^-17) w_k / (w_0 + ... + w_(K-1)),   w_k = gain^k,
 *
 * but w_(K-1) is also multiplied by the fraction of `octaves` when it has one: octaves can be faded
 * in without a pop. (If `octaves` is below 1 the fraction cancels: a single octave is always
 * whole.) With `of_octaves`, amplitudes are those of a sum of that many octaves: K and the fraction
 * in the divisor are those of `of_octaves`, while the octaves summed, and the fraction of the last
 * of them, are those of `octaves`. So 3 octaves of 8 are the first three of the eight, with the
 * same bits for each: a level of detail changes no coarse shape. The 2^-17 is the head-room for
 * rounding that lets the range be promised. R is (0.8 -0.6; 0.6 0.8) in 2D and (0 0.8 0.6; -0.8
 * 0.36 -0.48; -0.6 -0.48 0.64) in 3D.
 *
 *     fBm         value = sum_k a_k n_k
 *                 gradient = sum_k a_k G_k           Hessian = sum_k a_k J_k^T H_k J_k
 *     turbulence  value = sum_k a_k |n_k|
 *                 gradient = sum_k a_k sign(n_k) G_k, and likewise the Hessian; sign(0) = 0
 *     ridged      value = sum_k a_k s_k,   s_k = v_k (1 - |n_k|)^2,   v_0 = 1,
 *                 v_(k+1) = 2 s_k, but 1 where that is more.
 *                 The derivatives are those of this expression, with sign(0) = 0, and those of
 *                 v_(k+1) 0 where it is 1. (libnoise's RidgedMulti with the exponent 1 is this
 *                 with gain = 1 / lacunarity, times 1.25, less 1, not normalised.)
 *     erosion     value = sum_k a_k q_k n_k,   q_k = 1 / (1 + erosion d_k . d_k),
 *                 d_k = g_0 + ... + g_k, each g in the axes and units of its own octave.
 *                 gradient = sum_k a_k (q_k G_k - 2 erosion n_k q_k^2 D_k^T d_k),
 *                 D_k = H_0 J_0 + ... + H_k J_k, which is the Jacobian of d_k
 *     ping-pong   value = sum_k a_k (1 - 2 |e_k|),   e_k = 1 - (t_k - 2 floor(t_k / 2)),
 *                 t_k = (n_k + 1) sharpness, which is folded to [-1, 1] with the period 2.
 *                 gradient = sum_k a_k 2 sharpness sign(e_k) G_k, and likewise the Hessian, but 0
 *                 where 1 - 2 |e_k| is 1 or -1. (FastNoise Lite's PingPong, whose strength is the
 *                 sharpness, with a weighted strength of 0.)
 *     hybrid      value = sum_k a_k u_k,   u_k = v_k ((1 - 2^-17) n_k + sharpness),   v_0 = 1,
 *                 v_(k+1) = gain^k u_k, but 1 where that is more and -1 where it is less.
 *                 The derivatives are those of this expression, those of v_(k+1) 0 where it is 1
 *                 or -1. Amplitudes have another divisor and head-room:
 *                 a_k = amplitude (1 - 2^-16) w_k / U, where U is what w_0 u_0 + ... +
 *                 w_(K-1) u_(K-1) is if every (1 - 2^-17) n_k is 1. (Musgrave's hybrid
 *                 multifractal, whose offset is the sharpness, 0.7 as he has it, with gain =
 *                 lacunarity^-H; his H of 0.25 is a gain of 0.84. He lets weights fall below -1,
 *                 which they do with gains near 1 and above; his values have no bound then.)
 *
 * Octaves of two fractals (de Carpentier 2012) are bent: octave k looks at p_k = J_k y_k + o_k with
 * y_k = x + c_k S_k. S_k adds up slopes of the octaves before: with m_i = (gradient of n_i by y_i)
 * / f_i, the slope per cell in the axes of the input,
 *
 *     Swiss       value = sum_k a_k u_k max(0, 1 - |n_k|),   u_0 = 1,
 *                 u_(k+1) = u_k min(1, (this sum up to k) / a_0),
 *                 c_k = sharpness / f_0,   S_k = - sum_(i < k) (a_i / a_0) u_i n_i m_i
 *     Jordan      value = sum_k a_k q_k n_k^2,   q_0 = 1, q_k = 1 - erosion / (1 + S_k . S_k),
 *                 c_k = sharpness / f_k,   S_k = sum_(i < k) n_i m_i
 *
 * with a_k of Jordan noise once more times 1 - 2^-17. sharpness says how far octaves are bent: by
 * default 0.15 for Swiss noise, whose crests become sharp and whose flanks fall to smooth valleys;
 * 0.35 for Jordan noise, whose erosion, at most 1, keeps small octaves out of flat ground. Their
 * gradients go through the Jacobians of y_k; that of |n_k| takes sign(0) as 0, and is 0 where |n_k|
 * is more than 1.
 *
 * Every gradient is that of the value returned. Those of all but fBm, erosion and Jordan noise, and
 * their Hessians, hold almost everywhere: where some n_k is 0, 2 s_k is 1, t_k is an integer,
 * |gain^k u_k| is 1, or a sum of Swiss noise is a_0, the surface has a crease. (Hessians of ridged
 * noise overflow where amplitude f_k^2 comes near 2^120, those of ping-pong where that times 2
 * sharpness does. So do those of hybrid noise, and with gains above 1 its gradients where amplitude
 * f_k times the product of all gain^j does. Gradients of octaves that bend grow with each of them,
 * and may overflow. So may the positions of Swiss noise where gain^K comes near 2^120; where |a_0|
 * is below 2^-128, all its octaves but the first may vanish.)
 *
 * The cubic fade has a Hessian that jumps between cells. So gradients of erosion jump there, and
 * with more than one octave those of Swiss and Jordan noise: the surface has creases.
 *
 * Jumps. But for rounding, the value jumps in these cases, and in no others:
 *
 *     basis                          fractal                 K    where
 *     cell-value                     any                     any  on borders between cells
 *     cell-f1, cell-f2, cell-edge    erosion, Swiss, Jordan  > 1  where a gradient of the basis
 *                                                                 jumps: see "Cells"
 *     cell-edge                      erosion                 1    where F2 is the distance from two
 *                                                                 features, and at features
 *     cell-f1                        erosion                 1    at features, which are points
 *
 * Erosion, Swiss and Jordan noise have gradients of the basis in their values: a crease of the
 * basis becomes a jump. A noise jumps also where its warp does; creases of a warp become creases.
 * Gradients and Hessians know nothing of a jump: they are those of one side.
 *
 * An octave is noise of its own: n_k at x is, but for rounding, single-octave noise of the seed
 * s_k, frequency 1, the same basis and fade, and 2^k times the phase, at p_k, divided by 1 - 2^-17.
 * With splitmix64(z) the generator of Steele, Lea and Flood (2014) started at z, s_0 is `seed`, and
 * s_k number k of splitmix64(first number of splitmix64(seed)). o_k comes from the second and third
 * number, b and c, of splitmix64(first number of splitmix64(s_k)): 2^-24 times the top 24 bits of
 * b, the low 24 bits of c, the top 24 bits of c.
 *
 * Gradients and Hessians are per unit of *input*, not per lattice cell.
 *
 * Periods. Along an axis with a period P, the lattice of octave k draws for cell i what it draws
 * for i mod P lacunarity^k, in [0, P lacunarity^k): the noise, with all its derivatives, repeats
 * every P / frequency units of input, and a tile of that length has no seam. With several octaves,
 * lacunarity must be an integer, and P lacunarity^(K-1) at most 2^30, else calls return
 * SCARP_ERROR_PARAMETER. Axes that are turned cannot repeat: that is SCARP_ERROR_UNSUPPORTED. What
 * lies a period further has the same bits where its p_k have the same fractions, as with
 * coordinates and frequencies that are multiples of powers of two; elsewhere it differs by
 * rounding. Floats repeat wherever they have cells, doubles up to |p_k| = 2^50. Ranges stay.
 *
 * Flow (Perlin and Neyret 2001). With a phase a, in turns, the gradients of gradient noise turn
 * where they stand: those of octave k by s 2^k a, where s is the speed of each. In 2D, gradients at
 * 11.25 degrees + k * 45 have s = 1 and turn left, those at 33.75 + k * 45 have s = -2. In 3D, the
 * 12 edges are four triangles around the diagonals d of a cube. Each turns in its plane, g towards
 * d x g:
 *
 *     d            edges                                s
 *     ( 1, 1, 1)   (1,-1,0)  (-1,0,1)   (0,1,-1)        1
 *     ( 1,-1,-1)   (1,1,0)   (-1,0,-1)  (0,-1,1)        1
 *     (-1, 1,-1)   (-1,-1,0) (1,0,-1)   (0,1,1)         2
 *     (-1,-1, 1)   (-1,1,0)  (1,0,1)    (0,-1,-1)       2
 *
 * So the noise neither moves nor changes in kind: at every phase E[g g^T] is the same, and the same
 * along all axes, as are moments of the fourth order. A whole turn is a loop: phases a and a + 1
 * have the same bits if both are exact as floats, and phase 0 has those of calls without one. Small
 * octaves move faster: octave k makes 2^k loops a turn, its fastest gradients 2^(k+1). What flows
 * reaches further than what stands still: |n_k| is at most 1.0169038 and 1.0162356 in 2D (quintic,
 * cubic), 1.1100620 and 1.1037150 in 3D, and scarp_range tells it. dphase is the derivative of the
 * value by the phase, and may be asked for beside any other output. For fBm and turbulence,
 * |dphase| is at most 4 pi sum_k 2^k |a_k| times those numbers, for ping-pong that times 2
 * sharpness. Value noise has no gradients to turn, and the gradients of simplex noise do not: a
 * phase, and dphase, is SCARP_ERROR_UNSUPPORTED with all but gradient noise.
 *
 * Vector noise. What displaces the positions of a warp, what scarp_curl3 takes as potentials, and
 * what scarp_vector2 and its like give, has a component for each axis, 0, 1 and 2. Components of a
 * noise w have all that w has but its seed. With t_j number j of splitmix64(first number of
 * splitmix64(w.seed)), a number that no octave has from j = 33 on:
 *
 *     gradient, value  All components are made on the lattice of the seed t_33. Component 0 is the
 *                      noise w with that seed. Components 1 and 2 draw other gradients, or values,
 *                      at the same lattice points, from the same hashes: as uniform as those of
 *                      component 0, and independent of them. No seed has them as its noise.
 *     other bases      Component i is the noise w with the seed t_(33 + i).
 *
 * Each component is in the range of w. One call for all components takes less time than a call for
 * each: they have cells, fractions and hashes in common where they share a lattice, unless octaves
 * bend, since each component bends its own.
 *
 * Warps. With noise.warp = &w, the noise is n(y), y = x + d(x), where d is the vector noise w, in
 * every bit what scarp_vector2 and its like give of w. It is in units of input: scarp_range of w
 * says how far x may be displaced along each axis, with turbulence and its like to one side.
 * Derivatives go through the Jacobian J = I + D: the gradient is J^T g, the Hessian J^T H J + sum_i
 * g_i H_i, where g and H are those of n at y, D and H_i those of d at x. w may have a warp, too, up
 * to four in all: with e the warp of w, d is w at x + e(x). A warp changes no range. Derivatives
 * are products, which overflow where those of the warps and of the noise are too large together. If
 * warp and noise repeat after the same lengths of input, the whole does. dphase is the derivative
 * by the noise's own phase. A warp must have derivatives of the order that is asked for, else calls
 * return SCARP_ERROR_UNSUPPORTED. On grids the deepest warp is as fast as grids are, the rest as
 * fast as points.
 *
 * Points of floats are displaced in float: y is a float. Points of doubles, and of grids, are
 * displaced within the cells of each octave: J_k x + o_k is computed in double and split into cell
 * and fraction, J_k d in float and split likewise, and the fractions are added in float; where
 * their sum is 1 or more, the cell goes up by 1. So a displacement is as exact far from the origin
 * as near. Octaves of Swiss and Jordan noise are bent in the same way: c_k S_k is added to d.
 *
 * Simplex (Perlin 2001, Gustavson 2005). Vertices v draw gradients g_v, of the same kind as those
 * of gradient noise. With d = p - v and w = max(0, r^2 - d.d), all vertices together make the raw
 * noise
 *
 *     sum_v w^4 g_v . d,      gradient sum_v w^4 g_v - 8 w^3 (g_v . d) d,
 *     Hessian sum_v 48 w^2 (g_v . d) d d^T - 8 w^3 (g_v d^T + d g_v^T + (g_v . d) I).
 *
 * All three are continuous. In 2D, vertices are the corners of triangles of edge 1 whose sides lie
 * along x: (i, j sqrt(3) / 2), and (i + 1/2, j sqrt(3) / 2) for odd j, with r^2 = 3/4. In 3D they
 * are the corners (i, j, k) and the centres (i + 1/2, j + 1/2, k + 1/2) of cubes, which make
 * tetrahedra, with r^2 = 1/2 - 2^-21. r is what lets a vertex end where it is no corner of the
 * triangle or tetrahedron around p any more, so three or four vertices count. The suprema of the
 * raw noise are 0.0623669522 and (edges (1, 1, 0)) 0.0130071013. Periods: in 3D any; in 2D along x,
 * since rows are sqrt(3) / 2 apart: period[1] is SCARP_ERROR_UNSUPPORTED there.
 *
 * Cells (Worley 1996, with one feature per cell). Each cell c of the integer lattice has a feature
 * at c_i + 1/2 + jitter v_i along each axis, v_i drawn uniformly from [-1/2, 1/2]. F1 and F2 are
 * the distances from p to the nearest feature and to the second, V = sqrt(sum of a^8) over all
 * features with a = max(0, 1 - distance^2). With j = jitter:
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
 * n_k maps the interval from the least raw value (0 of the first three) to the largest to [-1, 1],
 * so that -1 is at features (edge: on borders; soft: where features crowd; there 1 is where none is
 * within 1). The distance from a feature is F = |d|, d = p - feature: its gradient is d / F, its
 * Hessian (I - (d / F) (d / F)^T) / F, both taken as 0 where F < 2^-40, where the surface has the
 * tip of a cone. Gradients and Hessians of the first three hold almost everywhere: where features
 * are equally near there is a crease, and the gradient is that of one of them. Those of soft noise
 * are continuous, those of cell-value 0. Hessians grow like 1 / F towards a feature, and overflow
 * there where amplitude f_k^2 comes near 2^86.
 *
 * The search is exact: every feature that can be among the two nearest is compared, including those
 * two cells off. Features of a period repeat with it, whatever its length. `fade` changes nothing
 * here; a phase is SCARP_ERROR_UNSUPPORTED.
 */
struct scarp_noise {
    enum scarp_basis basis SCARP_ZERO;
    enum scarp_fade fade SCARP_ZERO;
    enum scarp_fractal fractal SCARP_ZERO;

    /* nonzero: turn the axes between octaves; hides the lattice's directions */
    uint32_t rotate SCARP_ZERO;

    uint64_t seed SCARP_ZERO; /* all 64 bits count */

    /* lattice cells per unit of input. Default 1. Every f_k lies in [2^-32, 2^48]. */
    double frequency SCARP_ZERO;

    float octaves SCARP_ZERO; /* in (0, 32]. Default 1. */

    /* frequency ratio between octaves, in [1/16, 16]. Default 2. */
    float lacunarity SCARP_ZERO;

    /* amplitude ratio between octaves, in [1/16, 16]. Default 0.5. */
    float gain SCARP_ZERO;

    /* scales every output; its magnitude in [2^-24, 2^24]. Default 1. */
    float amplitude SCARP_ZERO;

    /* SCARP_EROSION: how strongly slopes damp octaves; SCARP_JORDAN: how much of them flat ground
       lacks, at most 1. In [2^-24, 2^24]. Default 1. */
    float erosion SCARP_ZERO;

    /* turns of the lattice's gradients, any finite number. Default 0. See "Flow". */
    float phase SCARP_ZERO;

    /* cellular noise: how far features stray from the middles of their cells, in (0, 1]. Default
       1. */
    float jitter SCARP_ZERO;

    /* SCARP_PINGPONG: how often octaves are folded, 2 by default; SCARP_HYBRID: how high they lie,
       0.7 by default; SCARP_SWISS and SCARP_JORDAN: how far they are bent, 0.15 and 0.35 by
       default; for these four in [2^-8, 2^8]. Others ignore it, in [2^-24, 2^24]. */
    float sharpness SCARP_ZERO;

    /* cells of octave 0, in [1, 2^30], after which the noise repeats along each axis; 0: never. 2D
       calls ignore period[2]. See "Periods". */
    uint32_t period[3] SCARP_ZERO;

    /* amplitudes are those of a sum of this many octaves, in [octaves, 32]. 0: octaves. */
    float of_octaves SCARP_ZERO;

    /* displaces positions; NULL: none. It must be there as long as calls use this noise. See
       "Warps". */
    const struct scarp_noise *warp SCARP_ZERO;

    /* what scarp_plan_make made of this noise. NULL: none; results do not depend on it. A noise
       with a warp does without. */
    const struct scarp_plan *plan SCARP_ZERO;

    /* reserved: 0. 192 bytes in all. */
    uint32_t spare[(192 - 80 - 2 * sizeof(void *)) / 4] SCARP_ZERO;
};

/* The constants of a noise, which every call without a plan computes anew. Its bytes have no
   meaning to others; it belongs to the caller, who may copy it, as a whole, to wherever a uint64_t
   may stand. */
struct scarp_plan {
    uint64_t first;
    unsigned char rest[12288 - 8];
};

/* Where results go: arrays of `count` floats. A NULL member is skipped. A call that asks for
   no derivative does not pay for derivatives; one that asks for no second derivative does not pay
   for second derivatives. */
struct scarp_samples {
    float *value SCARP_ZERO;

    /* gradient, per unit of input */
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

    float *dphase SCARP_ZERO;   /* derivative by the phase, per turn */
    float *spare[5] SCARP_ZERO; /* reserved: NULL. 16 pointers in all. */
};

/*
 * scarp_sample2 - sample noise at points of the plane
 *
 * For each i < count, out->value[i] is the noise at (x[i], y[i]), and out->dx[i], dy[i], dxx[i],
 * dxy[i], dyy[i] are the exact partial derivatives of that value in closed form; dphase[i] is that
 * by the phase.
 *
 * Arrays: every array holds at least `count` elements; no alignment beyond that of the type is
 * needed. An output may be the very same array as an input (in place); outputs must not overlap
 * anything else.
 *
 * Coordinates: positions are computed in float, so detail fades as |p_k| approaches 2^23 cells; use
 * scarp_sample2_f64 for large worlds. Beyond that the noise remains defined: for |p_k| >= 2^31 the
 * cell is -2^31 along that axis and the fraction 0. Where a coordinate is NaN or infinite, or a
 * position overflows to infinity, every output of that point is NaN; other points are not affected.
 *
 * Range: see scarp_range. With the defaults, [-1, 1].
 *
 * Returns SCARP_ERROR_NULL if count > 0 and `noise`, `out`, `x` or `y` is NULL; SCARP_ERROR_ENUM
 * for an unknown basis, fade or fractal; SCARP_ERROR_PARAMETER for a number of `noise` outside its
 * interval; SCARP_ERROR_SIZE if the arrays would exceed the address space; SCARP_ERROR_UNSUPPORTED
 * if a derivative along z is asked for, a second derivative of SCARP_EROSION, SCARP_SWISS or
 * SCARP_JORDAN, also where one of these is a warp, or dphase of the latter two or of other than
 * gradient noise, if there are more than four warps, if other noise has a phase, if turned axes
 * have a period, or if a reserved member of `noise` or `out` is in use. A count of 0 succeeds,
 * whatever the other arguments are.
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
 * Positions are computed in double and reduced to cell and fraction before anything is rounded to
 * float, so detail does not fade far from the origin: at |p_k| = 2^40 cells the fraction still has
 * 12 bits. Cells wrap modulo 2^32 up to |p_k| = 2^51; beyond, the low bits of the cell are lost
 * but the result remains defined and the same everywhere. Outputs are floats and cannot be in
 * place.
 *
 * Where axes are turned, p_k is the sum of two parts: what depends on the first coordinate, and
 * what depends on the others, with o_k. What is said of p_k above, and of positions that overflow,
 * holds for both parts. Each is rounded to a multiple of 2^-24 cells (in 2D simplex noise, along y,
 * of rows of its lattice), so p_k is off by at most 2^-24 cells, and samples of a grid share what
 * is computed of their column and their row. Points take down to half the speed where they are 2^26
 * cells of an octave from the origin, or in a call with a few such points.
 */
SCARP_API enum scarp_status scarp_sample2_f64(const struct scarp_noise *noise, size_t count,
                                              const double *x, const double *y,
                                              const struct scarp_samples *out);

/* scarp_sample3_f64 - like scarp_sample2_f64, but in space, with all outputs */
SCARP_API enum scarp_status scarp_sample3_f64(const struct scarp_noise *noise, size_t count,
                                              const double *x, const double *y, const double *z,
                                              const struct scarp_samples *out);

/*
 * scarp_vector2 - sample all components of vector noise at points of the plane
 *
 * For each i < count, out[c].value[i] is component c (0, 1) of the vector noise that `noise` makes,
 * with its warp, at (x[i], y[i]), and out[c].dx[i] and so on are the exact derivatives of that
 * value. See "Vector noise". A warp moves points by it: noise that has the warp w has the value, in
 * every bit, that it has without the warp at x[i] + out[0].value[i], y[i] + out[1].value[i], with
 * out of a call for w. So any expression of several noises can be bent at once, and its gradient
 * follows by the Jacobian of these sums.
 *
 * `out` has two elements. What is asked for may differ between components; each pays for the
 * highest derivative of all. Where only some components are wanted, the others' arrays are NULL,
 * but are computed. An output may be the very same array as an input (in place); outputs must not
 * overlap anything else.
 *
 * Arrays, coordinates, range and errors are as for scarp_sample2, the errors of an element of `out`
 * being those of any. The call does without noise.plan.
 */
SCARP_API enum scarp_status scarp_vector2(const struct scarp_noise *noise, size_t count,
                                          const float *x, const float *y,
                                          const struct scarp_samples out[2]);

/* scarp_vector3 - like scarp_vector2, but in space: three components, with all outputs */
SCARP_API enum scarp_status scarp_vector3(const struct scarp_noise *noise, size_t count,
                                          const float *x, const float *y, const float *z,
                                          const struct scarp_samples out[3]);

/* scarp_vector2_f64 - like scarp_vector2, but with double coordinates, as scarp_sample2_f64.
   Outputs cannot be in place. */
SCARP_API enum scarp_status scarp_vector2_f64(const struct scarp_noise *noise, size_t count,
                                              const double *x, const double *y,
                                              const struct scarp_samples out[2]);

/* scarp_vector3_f64 - like scarp_vector3, but with double coordinates, as scarp_sample3_f64.
   Outputs cannot be in place. */
SCARP_API enum scarp_status scarp_vector3_f64(const struct scarp_noise *noise, size_t count,
                                              const double *x, const double *y, const double *z,
                                              const struct scarp_samples out[3]);

/* What is near a point: arrays of `count` elements. A NULL member is skipped; calls that ask for f1
   alone, or for nothing of the second feature, take less time. */
struct scarp_cells {
    /* the distances to the nearest feature and to the second */
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
 * and its like are made of; see "Cells". They are those of the noise's first octave, given by
 * frequency, seed, jitter and period. Its other members must be valid, and change nothing, the
 * basis and the warp included.
 *
 * f1 and f2 are distances in units of input, so their gradients are unit vectors; at the feature
 * itself they are 0. id is an even number, uniform below 2^32, the same all over the cell, and what
 * SCARP_CELL_VALUE is made of: that is (int32_t)id / 2^31. Different cells have the same id once in
 * 2^31 pairs, and cells that are periods apart always. (x[i], y[i]) of `out` is computed in the
 * precision of the coordinates as the point less the way from the feature, then rounded to float:
 * points of one cell agree on it but for rounding, and it is not reduced by periods.
 *
 * Arrays, and coordinates, are as for scarp_sample2: an output of floats may be the very same array
 * as a coordinate. Where a coordinate is NaN or infinite, or a position overflows to infinity, the
 * id of that point is 0 and every other output NaN.
 *
 * Returns SCARP_ERROR_NULL if count > 0 and `noise`, `out`, `x` or `y` is NULL; SCARP_ERROR_SIZE if
 * the arrays would exceed the address space; SCARP_ERROR_UNSUPPORTED if z, dz1 or dz2 is asked for,
 * or a reserved member of `out` is in use; otherwise as scarp_noise_check. A count of 0 succeeds,
 * whatever the other arguments are.
 */
SCARP_API enum scarp_status scarp_cells2(const struct scarp_noise *noise, size_t count,
                                         const float *x, const float *y,
                                         const struct scarp_cells *out);

/* scarp_cells3 - like scarp_cells2, but in space, with all outputs */
SCARP_API enum scarp_status scarp_cells3(const struct scarp_noise *noise, size_t count,
                                         const float *x, const float *y, const float *z,
                                         const struct scarp_cells *out);

/* scarp_cells2_f64 - like scarp_cells2, but with double coordinates, as scarp_sample2_f64. Outputs
   cannot be in place. */
SCARP_API enum scarp_status scarp_cells2_f64(const struct scarp_noise *noise, size_t count,
                                             const double *x, const double *y,
                                             const struct scarp_cells *out);

/* scarp_cells3_f64 - like scarp_cells2_f64, but in space, with all outputs */
SCARP_API enum scarp_status scarp_cells3_f64(const struct scarp_noise *noise, size_t count,
                                             const double *x, const double *y, const double *z,
                                             const struct scarp_cells *out);

/* A velocity and its Jacobian at a point: arrays of `count` floats. vxy is the derivative of vx by
   y, and so on. A NULL member is skipped; a call that asks for nothing of the Jacobian does not pay
   for second derivatives. */
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
 * For each i < count, (vx[i], vy[i]) of `out` is the curl of the noise at (x[i], y[i]), which is
 * its gradient turned by a quarter (Bridson, Hourihan and Nordenstam 2007):
 *
 *     v = (dy, -dx),   Jacobian (vxx, vxy; vyx, vyy) = (dxy, dyy; -dxx, -dxy)
 *
 * with the bits of scarp_sample2. So particles swirl along the contours of the noise, and neither
 * gather nor thin out: vyy is -vxx in every bit.
 *
 * The noise is a stream function, or potential: velocities are its amplitude per unit of input, and
 * `amplitude` and `frequency` both multiply them. Octave k of fBm has a_k f_k of the speed: with
 * the defaults, gain 1/2 and lacunarity 2, all octaves are equally fast, and the smallest eddies
 * have most of the Jacobian. Take a gain below 1 / lacunarity, so that large eddies carry the small
 * ones; lacunarity^(-4/3), which is 0.4 for 2, is that of turbulent flow (Kolmogorov 1941). One
 * octave of gradient noise with amplitude and frequency 1 has a speed of 1.27 (the root of the mean
 * of squares), simplex noise 2.98. No interval is promised that velocities never leave: scarp_range
 * is that of the potential.
 *
 * All bases and fractals serve, with periods, phases and warps. Where the gradient jumps (creases
 * of fractals, and of cellular noise) so does the velocity, and its Jacobian is that on one
 * side; where a fractal has no Hessian, there is no Jacobian. A phase lets the flow change in
 * time. Another flow without divergence comes of any other potential: with a ramp r that is 0 on
 * walls and 1 away from them, r psi has the velocity (r psi_y + r_y psi, -r psi_x - r_x psi), which
 * is along the walls there.
 *
 * Arrays, and coordinates, are as for scarp_sample2: an output may be the very same array as a
 * coordinate. Where a coordinate is NaN or infinite, or a position overflows to infinity, every
 * output of that point is NaN.
 *
 * Returns SCARP_ERROR_NULL if count > 0 and `noise`, `out`, `x` or `y` is NULL; SCARP_ERROR_SIZE if
 * the arrays would exceed the address space; SCARP_ERROR_UNSUPPORTED if a member along z is asked
 * for, something of the Jacobian where the noise or a warp has no Hessian, or if a reserved member
 * of `out` is in use; otherwise as scarp_noise_check. A count of 0 succeeds, whatever the other
 * arguments are.
 */
SCARP_API enum scarp_status scarp_curl2(const struct scarp_noise *noise, size_t count,
                                        const float *x, const float *y,
                                        const struct scarp_flow *out);

/*
 * scarp_curl3 - like scarp_curl2, but in space, with all outputs
 *
 * There are three potentials psi_0, psi_1, psi_2: the components of the vector noise that the noise
 * makes, each with the warp of the noise. With i, j, k = 0, 1, 2 in turn,
 *
 *     v_i = d_j psi_k - d_k psi_j,   Jacobian d_m v_i = d_j d_m psi_k - d_k d_m psi_j,
 *
 * each of which is one subtraction of floats that have the bits of scarp_vector3. So the trace
 * vxx + vyy + vzz is 0 but for the rounding of these three: exactly computed it is at most
 * 2^-24 (|vxx| + |vyy| + |vzz|). One octave of gradient noise with amplitude and frequency 1 has a
 * speed of 1.66, simplex noise 4.30. A call takes as long as one of scarp_vector3, and does without
 * noise.plan.
 */
SCARP_API enum scarp_status scarp_curl3(const struct scarp_noise *noise, size_t count,
                                        const float *x, const float *y, const float *z,
                                        const struct scarp_flow *out);

/* scarp_curl2_f64 - like scarp_curl2, but with double coordinates, as scarp_sample2_f64. Outputs
   cannot be in place. */
SCARP_API enum scarp_status scarp_curl2_f64(const struct scarp_noise *noise, size_t count,
                                            const double *x, const double *y,
                                            const struct scarp_flow *out);

/* scarp_curl3_f64 - like scarp_curl3, but with double coordinates, as scarp_sample3_f64. Outputs
   cannot be in place. */
SCARP_API enum scarp_status scarp_curl3_f64(const struct scarp_noise *noise, size_t count,
                                            const double *x, const double *y, const double *z,
                                            const struct scarp_flow *out);

/*
 * A uniform grid: sample (i, j, k) lies at origin[d] + (double)(first[d] + index) * step[d] along
 * each axis d, index being i, j or k, computed in double in this order. The 2D calls ignore the
 * elements 2 and slice_stride.
 */
struct scarp_grid {
    /* finite; a step may be 0 or negative */
    double origin[3] SCARP_ZERO;
    double step[3] SCARP_ZERO;

    int64_t first[3] SCARP_ZERO; /* every first + index lies in [-2^53, 2^53] */
    size_t count[3] SCARP_ZERO;

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
 * For each i < count[0] and j < count[1], element j * row_stride + i of each array in `out` is, to
 * the bit, what scarp_sample2_f64 gives at the coordinates of sample (i, j). So a world is the same
 * whatever tiles it is computed in: give tiles their `first`, and the same origin and step. Nothing
 * between the rows is touched.
 *
 * Grids are much faster than arrays of points where neighbouring samples share lattice cells, axes
 * are not turned, and rows are longer than a few dozen samples. So let x be the long axis: a chunk
 * of 256 x 16 x 16 samples takes down to a quarter of the time of one of 16 x 256 x 16. Single
 * octaves of fBm of 24 MiB and more are written fastest where arrays, and their rows, begin at
 * multiples of 64 bytes.
 *
 * Returns SCARP_ERROR_NULL if `noise`, `grid` or `out` is NULL; SCARP_OK if a count is 0, whatever
 * the other members are; SCARP_ERROR_PARAMETER for an origin or step that is not finite, an index
 * outside its interval, and strides shorter than a row or a slice; SCARP_ERROR_SIZE if the arrays
 * would exceed the address space; SCARP_ERROR_UNSUPPORTED also if a reserved member of `grid` is in
 * use; otherwise as scarp_sample2.
 */
SCARP_API enum scarp_status scarp_grid2(const struct scarp_noise *noise,
                                        const struct scarp_grid *grid,
                                        const struct scarp_samples *out);

/* scarp_grid3 - like scarp_grid2, but in space: element k * slice_stride + j * row_stride + i, as
   scarp_sample3_f64, with all outputs */
SCARP_API enum scarp_status scarp_grid3(const struct scarp_noise *noise,
                                        const struct scarp_grid *grid,
                                        const struct scarp_samples *out);

/*
 * scarp_normals - unit normals of the surface z = height_scale * value, from the gradient
 *
 * For each i < count, (nx[i], ny[i], nz[i]) is (-s dx[i], -s dy[i], 1) divided by its length, with
 * s = height_scale: x and y are the axes of the noise's input, z points up. dx and dy are outputs
 * of a sample call; s is in units of input per unit of value. Normals are computed in double and
 * rounded once: each component is within 1 unit in the last place of the exact one. Where an input
 * is NaN or infinite, the normal is NaN in all components.
 *
 * Every array holds `count` floats. nx, ny and nz may each be NULL and are then skipped; an output
 * may be the very same array as an input.
 *
 * Returns SCARP_ERROR_NULL if dx or dy is NULL; SCARP_ERROR_PARAMETER if height_scale is not
 * finite; SCARP_ERROR_SIZE as scarp_sample2. A count of 0 succeeds, whatever the other arguments
 * are.
 */
SCARP_API enum scarp_status scarp_normals(size_t count, const float *dx, const float *dy,
                                          float height_scale, float *nx, float *ny, float *nz);

/*
 * The chain rule: functions of samples, with exact derivatives
 *
 * These functions combine samples as arrays: `a` and `b` hold the inputs, `out` the results. The
 * members of all three are arrays of `count` floats. Whatever member of `out` is there is computed:
 * the value f(a) or f(a, b) at each point, and its derivatives by the chain rule. Where i and j are
 * axes, f_a, f_aa, ... the partial derivatives of f, and a_i, a_ij the derivatives of a:
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
 * Work in chunks of about 4,096 points, sampling included: then the arrays stay in the caches, and
 * the functions cost little beside the noise.
 *
 * Members: an output needs the same member of every input, and but for scarp_affine and scarp_add a
 * derivative also needs the values, a second derivative the first ones along its axes. (What
 * scarp_apply1 and scarp_apply2 need is told there.) Members that no output needs are not read.
 *
 * Arrays: an output may be the very same array as any one that is read, of the same member or of
 * another; outputs must not overlap anything else.
 *
 * NaN: where a number is NaN, every output that is computed from it is NaN, and other points are
 * not affected. scarp_min and scarp_max take a value that is NaN before any number, with its
 * derivatives. Infinities make NaN where they cancel, or are multiplied by 0.
 *
 * Products by 0: in scarp_multiply and scarp_mix, a term that is a product is 0 (+0) where one of
 * its two factors is 0, whatever the other one is, NaN and infinities too. So a mask hides what is
 * behind it, where it is 0 and level.
 *
 * Smoothness: a function is called C2 where the Hessian of the result is continuous if those of the
 * inputs are, and C0 where the result is continuous and has creases. Those that are called neither
 * have as many derivatives as their inputs.
 *
 * Return values, of all functions here: SCARP_ERROR_NULL if `a`, `b`, `m`, `function` or `out` is
 * NULL, or an array that an output needs; SCARP_ERROR_PARAMETER for a number that is not finite or
 * outside its interval; SCARP_ERROR_SIZE if the arrays would exceed the address space;
 * SCARP_ERROR_UNSUPPORTED if a reserved member is in use. A count of 0 succeeds, whatever the other
 * arguments are.
 */

/* scarp_affine - scale a + offset. Derivatives are scale times those of a. */
SCARP_API enum scarp_status scarp_affine(size_t count, const struct scarp_samples *a, float scale,
                                         float offset, const struct scarp_samples *out);

/* scarp_add - a + b, in all members */
SCARP_API enum scarp_status scarp_add(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *b,
                                      const struct scarp_samples *out);

/*
 * scarp_multiply - a b
 *
 * Derivatives are b a_i + a b_i and (b a_ij + a b_ij) + (a_i b_j + a_j b_i). The value and each of
 * these products are 0 where a factor is 0: b a_i where b is 0 or a_i is. Where b is 0 with all its
 * derivatives, all outputs are 0.
 */
SCARP_API enum scarp_status scarp_multiply(size_t count, const struct scarp_samples *a,
                                           const struct scarp_samples *b,
                                           const struct scarp_samples *out);

/*
 * scarp_mix - a + m (b - a), computed from the nearer end
 *
 * m is samples, too: its slopes are part of those of the result. It may leave [0, 1]. Let d = a - b
 * in all members; e = b and w = m - 1 where m > 1/2, else e = a and w = m. Then
 *
 *     value   e - w d
 *     first   e_i - (w d_i + d m_i)
 *     second  e_ij - ((w d_ij + d m_ij) + (d_i m_j + d_j m_i))
 *
 * and each product is 0 where a factor is 0: w d_i where w is 0 or d_i is, d m_i where d is 0 or
 * m_i is. So where m is 0, the value is that of a, to the bit; the derivative by i is that of a
 * where m_i is 0, too, and the second one by i and j where m_i, m_j and m_ij are 0. Where m is 1,
 * the same holds for b. What the other input is, even NaN, is not seen there.
 *
 * With m in [0, 1] the value never leaves the interval between a and b, rounding included, if a - b
 * is finite.
 */
SCARP_API enum scarp_status scarp_mix(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *b, const struct scarp_samples *m,
                                      const struct scarp_samples *out);

/*
 * scarp_min - the lesser of a and b
 *
 * All outputs are those of the input chosen, to the bit: b where b < a or b is NaN, otherwise a, so
 * also where both are equal. C0: the result is continuous, with a crease where a = b.
 */
SCARP_API enum scarp_status scarp_min(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *b,
                                      const struct scarp_samples *out);

/* scarp_max - the greater: like scarp_min, but b where b > a or b is NaN */
SCARP_API enum scarp_status scarp_max(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *b,
                                      const struct scarp_samples *out);

/*
 * scarp_smooth_min - the lesser of a and b, without a crease
 *
 * min(a, b) - h^3 k / 6 with h = max(0, 1 - |a - b| / k): but for rounding min(a, b) itself where
 * the two differ by k or more, and less where they are nearer, by k / 6 at most. C2. With f_a = 1 -
 * h^2 / 2 where a < b, else h^2 / 2, f_b the other of the two, and q = -h / k, derivatives are f_a
 * a_i + f_b b_i and (f_a a_ij + f_b b_ij) + (q (a_i - b_i)) (a_j - b_j).
 *
 * k is in units of value, in [2^-60, 2^60].
 */
SCARP_API enum scarp_status scarp_smooth_min(size_t count, const struct scarp_samples *a,
                                             const struct scarp_samples *b, float k,
                                             const struct scarp_samples *out);

/* scarp_smooth_max - max(a, b) + h^3 k / 6: like scarp_smooth_min of -a and -b, with the sign
   turned back */
SCARP_API enum scarp_status scarp_smooth_max(size_t count, const struct scarp_samples *a,
                                             const struct scarp_samples *b, float k,
                                             const struct scarp_samples *out);

/*
 * scarp_clamp - a, but lo where it is less and hi where it is more
 *
 * lo <= hi, both finite. Derivatives are those of a for values in [lo, hi], bounds included, and 0
 * outside. C0: creases at the bounds; scarp_smooth_min and scarp_smooth_max have none.
 */
SCARP_API enum scarp_status scarp_clamp(size_t count, const struct scarp_samples *a, float lo,
                                        float hi, const struct scarp_samples *out);

/* scarp_abs - |a|. Derivatives are sign(a) times those of a, with sign(0) = 0. C0: a crease at 0.
 */
SCARP_API enum scarp_status scarp_abs(size_t count, const struct scarp_samples *a,
                                      const struct scarp_samples *out);

/*
 * scarp_smooth_abs - sqrt(a^2 + round^2), |a| with a round floor
 *
 * `round` is the value where a is 0, in [2^-60, 2^60]; far from there the result is above |a| by
 * round^2 / (2 |a|). Infinitely smooth. It makes valleys of smooth noise, and ridges with the sign
 * changed (scarp_affine): where a is 0 lies a line without ends, so that valleys hang together. A
 * magnitude of a above 2^63 is squared to infinity.
 */
SCARP_API enum scarp_status scarp_smooth_abs(size_t count, const struct scarp_samples *a,
                                             float round, const struct scarp_samples *out);

/*
 * scarp_smoothstep - from 0 where a is `lo` or beyond, to 1 where it is `hi` or beyond
 *
 * S(t) = 6t^5 - 15t^4 + 10t^3 with t = (a - lo) / (hi - lo), held within [0, 1]. C2, and values are
 * in [0, 1], rounding included. lo > hi makes it fall. |hi - lo| is in [2^-60, 2^60]. It makes
 * masks for scarp_mix: where heights are between lo and hi, say, or slopes.
 */
SCARP_API enum scarp_status scarp_smoothstep(size_t count, const struct scarp_samples *a, float lo,
                                             float hi, const struct scarp_samples *out);

/*
 * scarp_terrace - steps in a slope
 *
 * With t = steps a, u = t - floor(t), S as above and w = (u - 1/2) / riser + 1/2, held within [0,
 * 1]:
 *
 *     value = (floor(t) + u + strength (S(w) - u)) / steps
 *
 * `steps` is how many there are per unit of value, in [2^-60, 2^60]. `riser` is the part of a step
 * that rises, in [2^-20, 1]; the rest, half below and half above, is a tread. Treads are level at
 * multiples of 1 / steps, where they keep the value. Risers are up to 15/8 / riser times as steep
 * as a was. `strength`, in [0, 1], is how much of that there is: 0 leaves a as it is, but for
 * rounding; 1 makes treads level. Values move by 1 / (2 steps) at most.
 *
 * C2 for every riser and strength. The first derivative by a is at least 1 - strength, so terraces
 * never turn a slope around. Steps fade out where |t| comes near 2^23. Where t overflows, all
 * outputs are NaN; values near the largest float may become infinite.
 */
SCARP_API enum scarp_status scarp_terrace(size_t count, const struct scarp_samples *a, float steps,
                                          float riser, float strength,
                                          const struct scarp_samples *out);

/*
 * scarp_divide - a / b
 *
 * The value is one division. Derivatives are those of scarp_apply2, with f = a / b and r = 1 / b:
 * fa = r, fb = -(f r), faa = 0, fab = -(r r), fbb = 2 (f r) r. Where b is 0, values are infinite or
 * NaN.
 */
SCARP_API enum scarp_status scarp_divide(size_t count, const struct scarp_samples *a,
                                         const struct scarp_samples *b,
                                         const struct scarp_samples *out);

/*
 * scarp_sqrt - the square root of a, and 0 where a is less than 0
 *
 * The value is rounded once; f_a = 1 / (2 value), f_aa = -f_a / (2 a), both 0 where a is 0 or less.
 * Slopes have no bound above 0.
 */
SCARP_API enum scarp_status scarp_sqrt(size_t count, const struct scarp_samples *a,
                                       const struct scarp_samples *out);

/*
 * scarp_sine - sin(2 pi a): a counts turns
 *
 * Computed in double and rounded once: within 1 unit in the last place, and exactly 0, 1 or -1 at
 * multiples of a quarter. An infinite a gives NaN.
 */
SCARP_API enum scarp_status scarp_sine(size_t count, const struct scarp_samples *a,
                                       const struct scarp_samples *out);

/*
 * scarp_pulse - a folded to and fro between -1 and 1, with the period 2
 *
 * 1 - 2 |e| with e = 1 - (a - 2 floor(a / 2)): -1 at even numbers, 1 at odd ones, straight between.
 * f_a is 2 or -2, and 0 at whole numbers. C0: creases there. An infinite a gives NaN.
 */
SCARP_API enum scarp_status scarp_pulse(size_t count, const struct scarp_samples *a,
                                        const struct scarp_samples *out);

#define SCARP_CURVE_KNOTS 64

/*
 * scarp_curve - a smooth curve through knots
 *
 * The curve has value[k] where a is x[k]. It is level before the first knot and behind the last
 * one, and a cubic between two: the monotone one (Fritsch and Butland 1984), whose slope at a knot
 * is the harmonic mean of the slopes of the chords at both sides, or 0 where these have different
 * signs and at both ends. So it never overshoots: between two knots values lie between theirs. The
 * gradient is continuous, the Hessian jumps at knots.
 *
 * There are from 2 to SCARP_CURVE_KNOTS `knots`. All numbers are in [-2^60, 2^60], and x[k + 1] -
 * x[k] is 2^-60 at least; SCARP_ERROR_NULL if `x` or `value` is NULL.
 */
SCARP_API enum scarp_status scarp_curve(size_t count, const struct scarp_samples *a, size_t knots,
                                        const float *x, const float *value,
                                        const struct scarp_samples *out);

/*
 * scarp_slope - the length of the gradient of a
 *
 * value = sqrt(dx^2 + dy^2), with dz^2 if a->dz is there. Derivatives are (a_x a_xi + a_y a_yi +
 * a_z a_zi) / value, and 0 where that is 0, where slopes have the tip of a cone. The value needs dx
 * and dy, not the value of a; a derivative needs the second ones of a along its axis, too. Second
 * derivatives, and dphase, are SCARP_ERROR_UNSUPPORTED.
 */
SCARP_API enum scarp_status scarp_slope(size_t count, const struct scarp_samples *a,
                                        const struct scarp_samples *out);

/* A function at `count` points: its value, and its partial derivatives by one or two arguments. */
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
 * The caller computes f, its derivative fa and second derivative faa from the values of a, point by
 * point, and scarp does the rest: value = f, and the derivatives above. The value needs f; first
 * derivatives need fa, second ones faa, too, and both need the same derivatives of a as other
 * functions, but not its value. The other members of `function`, but for reserved ones, are not
 * looked at.
 */
SCARP_API enum scarp_status scarp_apply1(size_t count, const struct scarp_samples *a,
                                         const struct scarp_partials *function,
                                         const struct scarp_samples *out);

/*
 * scarp_apply2 - any function of a and b, given at each point
 *
 * Like scarp_apply1. First derivatives need fa and fb, second ones faa, fab and fbb, too.
 * Derivatives are fa a_i + fb b_i and
 * ((fa a_ij + fb b_ij) + ((faa a_i) a_j + (fbb b_i) b_j)) + fab (a_i b_j + a_j b_i).
 */
SCARP_API enum scarp_status scarp_apply2(size_t count, const struct scarp_samples *a,
                                         const struct scarp_samples *b,
                                         const struct scarp_partials *function,
                                         const struct scarp_samples *out);

/*
 * Gullies
 *
 * Gullies and spurs that run down the slope of a base, branch, and leave its large forms: erosion
 * as a function of the place. They read the base's value and gradient, and its Hessian where
 * derivatives are asked for, so that these are exact. The base is any samples: of noise, or
 * combined by the chain rule. The result is the base plus a displacement.
 *
 * With h = base / amplitude, g = its gradient and lengths in cells of the base, S(z) = z^2 (3 - 2
 * z) of z = (h - low) / (high - low), held within [0, 1], the slope is
 *
 *     s = g / sqrt(g.g + slope_low^2 (1 - S) + slope^2 S),   M = s.s in [0, 1),
 *
 * so M is 1/2 where |g| is `slope` on crests, or `slope_low` on floors. Exposure begins with v = 1
 * - (1 - S) (1 + floor). Octave k of gullies has f_k = cells lacunarity^k cells per cell of the
 * base, R^k, p_k and o_k as a noise of this seed has them (see struct scarp_noise), and the weight
 * w_k = depth gain^k / (sum of gain^k). It draws waves with stripes along the slope. Across it is
 * t; at each corner c of the cell of p_k the lattice draws the phase psi_c, the hash of value noise
 * as a signed number over 2^32; W_c are the weights of value noise with the quintic fade; and
 *
 *     t = (-s_y, s_x) / sqrt(s.s + 0.05^2)
 *     Z = sum of W_c e^(2 pi i (psi_c + stripes (R^k t).(p_k - c)))
 *     C + i S' = Z / sqrt(|Z|^2 + 0.5^2)
 *     P = 1 - 2 (sqrt((1 - C) / 2 + round^2) - round) / (sqrt(1 + round^2) - round)
 *     m = M (1 - keep v^2), without `keep` where k = 0
 *     v := v + m (P - v),   s := s - branch m S' t
 *
 * The displacement is amplitude times the sum of the w_k v_k. P is 1 on sharp crests and -1 on
 * round floors. Of flat ground, the displacement is depth v: crests rise, floors sink by `floor` of
 * it. The steering s is as defined, and is not the slope of the result, so that the base's Hessian
 * is all that derivatives need.
 *
 * Bases. Gradients of the result are continuous where the Hessian of the base is: gradient and
 * value noise with the quintic fade, simplex noise, cell-soft, sums of these, and what
 * scarp_smooth_abs, scarp_smooth_min and scarp_smooth_max make of them. A base with creases
 * (ridged, turbulence, cellular noise, scarp_abs) makes the height itself tear there: gullies on
 * both sides run in other directions. Detail as fine as gullies turns their directions within a
 * cell: a base of three octaves is good, one of five crumples. Add finer detail to the result, with
 * scarp_add. Gullies end where the base has a dip: valleys that hang together, as those of
 * scarp_smooth_abs do, drain.
 *
 * All members are multiples of what the base is, so that a terrain scales as a whole. 0 is the
 * default everywhere; for an effect that is not wanted give 2^-24.
 */
struct scarp_gullies {
    uint64_t seed SCARP_ZERO; /* all 64 bits count */

    /* of the base: cells per unit of input, in [2^-32, 2^48]. Default 1. */
    double frequency SCARP_ZERO;

    /* of the base: half the height from its floors to its crests, in [2^-24, 2^24]. Default 1. */
    float amplitude SCARP_ZERO;

    float octaves SCARP_ZERO; /* in (0, 32]. Default 5. A fraction fades in. */

    /* weights are those of a sum of this many octaves, in [octaves, 32]. 0: octaves. */
    float of_octaves SCARP_ZERO;

    /* frequency ratio between octaves, in [1/16, 16]. Default 2. */
    float lacunarity SCARP_ZERO;

    /* weight ratio between octaves, in [1/16, 16]. Default 0.45: 0.6 is rough. */
    float gain SCARP_ZERO;

    /* how far the base is displaced at most, in amplitudes, in [2^-24, 2^10]. Default 0.25. */
    float depth SCARP_ZERO;

    /* cells of the first gullies per cell of the base, in [2^-6, 2^6]. Default 3. */
    float cells SCARP_ZERO;

    /* where gullies of crests have half their depth: in amplitudes per cell of the base, in [2^-5,
       2^5]. Default 1.125: less makes peaks sharper. */
    float slope SCARP_ZERO;

    /* the same of floors. Default 1.75: more makes floors wider. */
    float slope_low SCARP_ZERO;

    /* the heights of floors and of crests, in amplitudes, in [-2^10, 2^10], at least 2^-10 apart.
       Defaults -1 and 1. */
    float low SCARP_ZERO;
    float high SCARP_ZERO;

    /* how far floors sink, in [-1, 1]: 1 as deep as gullies, -1 filled up. Default 0.5. */
    float floor SCARP_ZERO;

    float stripes SCARP_ZERO; /* gullies per cell, in [2^-10, 8]. Default 1.5. */

    /* how far octaves turn those after them, in [2^-24, 8]. Default 0.8: 0.3 runs parallel. */
    float branch SCARP_ZERO;

    /* of crests, in [2^-8, 2^8]: 0.05 is an arete, 1 rolling. Default 0.15. */
    float round SCARP_ZERO;

    /* how much crests and floors of an octave are spared by the next one, in [2^-24, 1]. Default
       1. */
    float keep SCARP_ZERO;

    /* cells of the base after which gullies repeat along each axis; 0: never. `cells` times a
       period is whole, and at most 2^30. See "Periods". */
    uint32_t period[2] SCARP_ZERO;

    uint32_t rotate SCARP_ZERO; /* nonzero: turn the axes between octaves */

    uint32_t spare[9] SCARP_ZERO; /* reserved: 0. 128 bytes in all. */
};

/* Where results go: arrays of `count` floats. A NULL member is skipped; a call that asks for no
   derivative does not pay for derivatives. */
struct scarp_eroded {
    /* the base plus the displacement */
    float *value SCARP_ZERO;
    float *dx SCARP_ZERO;
    float *dy SCARP_ZERO;

    /* in [-1, 1] times depth amplitude: a map of ridges and gullies */
    float *displacement SCARP_ZERO;
    float *displacement_dx SCARP_ZERO;
    float *displacement_dy SCARP_ZERO;

    float *spare[10] SCARP_ZERO; /* reserved: NULL. 16 pointers in all. */
};

/*
 * scarp_gullies2 - draw gullies into a base at points of the plane
 *
 * `base` holds value, dx and dy of the base at the points, and dxx, dxy, dyy where a derivative is
 * asked for; its other members are not read.
 *
 * Arrays: every array holds at least `count` elements. An output may be the very same array as any
 * array of the base or a coordinate; outputs must not overlap anything else.
 *
 * Derivatives are within 2e-4 of the exact ones, in amplitudes per cell of the base, with a root
 * mean square of 2e-6 (defaults, double coordinates); with float coordinates of some cells, within
 * 2e-3, and 5e-5. Sharp crests have more: 0.03 and 2e-4 with `round` 0.02.
 *
 * Where a coordinate is NaN or infinite, or the base's value or gradient, every output of that
 * point is NaN; so are derivatives where something of its Hessian is. Where |g| passes 2^63, the
 * ground counts as flat. Other points are not affected.
 *
 * Range: see scarp_gullies_range.
 *
 * Returns SCARP_ERROR_NULL if count > 0 and an argument, or an array of the base that is needed, is
 * NULL; SCARP_ERROR_SIZE if the arrays would exceed the address space; SCARP_ERROR_UNSUPPORTED if a
 * reserved member of `base` or `out` is in use; otherwise as scarp_gullies_check. A count of 0
 * succeeds, whatever the other arguments are.
 */
SCARP_API enum scarp_status scarp_gullies2(const struct scarp_gullies *gullies, size_t count,
                                           const float *x, const float *y,
                                           const struct scarp_samples *base,
                                           const struct scarp_eroded *out);

/* scarp_gullies2_f64 - like scarp_gullies2, but with double coordinates, as scarp_sample2_f64.
   Outputs may be arrays of the base, and not coordinates. */
SCARP_API enum scarp_status scarp_gullies2_f64(const struct scarp_gullies *gullies, size_t count,
                                               const double *x, const double *y,
                                               const struct scarp_samples *base,
                                               const struct scarp_eroded *out);

/*
 * scarp_gullies_grid2 - draw gullies into a base on a uniform grid of the plane
 *
 * Arrays of the base, and outputs, are as scarp_grid2 has them: element j * row_stride + i of each
 * becomes, to the bit, what scarp_gullies2_f64 gives at the coordinates of sample (i, j). Nothing
 * between the rows is touched. Returns what scarp_grid2 says of grids; otherwise as scarp_gullies2.
 */
SCARP_API enum scarp_status scarp_gullies_grid2(const struct scarp_gullies *gullies,
                                                const struct scarp_grid *grid,
                                                const struct scarp_samples *base,
                                                const struct scarp_eroded *out);

/*
 * scarp_gullies_range - the interval that values never leave
 *
 * *lowest <= value <= *highest, rounding included, for a base in [base_lowest, base_highest]: these
 * less and plus depth amplitude, since every v is between -1 and 1.
 *
 * Returns SCARP_ERROR_NULL if a pointer is NULL; otherwise as scarp_gullies_check.
 */
SCARP_API enum scarp_status scarp_gullies_range(const struct scarp_gullies *gullies,
                                                float base_lowest, float base_highest,
                                                float *lowest, float *highest);

/*
 * scarp_gullies_check - whether calls take gullies, and if not, which member is at fault
 *
 * *member becomes the name of a member at fault, as this header spells it, or NULL. It is always
 * written, also on an error; the text is static. `member` may be NULL.
 *
 * Returns SCARP_ERROR_NULL if `gullies` is NULL; SCARP_ERROR_PARAMETER for a number outside its
 * interval, a frequency of gullies outside those of a noise, and a period that is not whole in
 * octave 0 or all later ones; SCARP_ERROR_UNSUPPORTED for a reserved member in use, and for turned
 * axes with a period.
 */
SCARP_API enum scarp_status scarp_gullies_check(const struct scarp_gullies *gullies,
                                                const char **member);

/*
 * scarp_range - the interval that values never leave
 *
 * *lowest <= value <= *highest for every point, rounding included. `dimensions` is 2 or 3. fBm,
 * erosion and ping-pong have the interval from -|amplitude| to |amplitude|, turbulence, ridged,
 * Swiss and Jordan noise the one between 0 and amplitude. That of hybrid noise goes from amplitude
 * across 0, to -0.23 amplitude at most with the default sharpness and gains up to 0.5; with a
 * sharpness of 1 it ends at 0, with more before that. With a phase that is not 0, all but ridged,
 * Swiss and ping-pong noise reach further: see "Flow". With `of_octaves` it is that of the longer
 * sum, of which fewer octaves reach less; but the lower end of hybrid noise with a sharpness above
 * 1 is that of the octaves summed. Use it to map heights to integers: all tiles then agree, and so
 * do levels of detail, and the frames of a loop from phase 1 to 2.
 *
 * Returns SCARP_ERROR_NULL if a pointer is NULL; otherwise as scarp_noise_check.
 */
SCARP_API enum scarp_status scarp_range(const struct scarp_noise *noise, int dimensions,
                                        float *lowest, float *highest);

/*
 * scarp_noise_check - whether calls take a noise, and if not, which member is at fault
 *
 * Returns what every call in 2 or 3 `dimensions` returns for this noise, as far as the noise alone
 * decides: a call may still refuse its other arguments, or outputs that this noise does not have.
 *
 * *member becomes the name of the first member at fault, as this header spells it: "octaves",
 * "period[1]" ("spare" has no index). Where the frequency of the last octave leaves its interval,
 * that is "octaves", since fewer octaves always help. *member becomes NULL where no member is at
 * fault: on success, and if `noise` or `dimensions` is. It is always written, also on an error; the
 * text is static. `member` may be NULL.
 *
 * Returns, of these the first that applies: SCARP_ERROR_NULL if `noise` is NULL; SCARP_ERROR_ENUM
 * for an unknown basis, fade or fractal; SCARP_ERROR_PARAMETER for a number outside its interval,
 * in the order of the members, the last octave's frequency after them; SCARP_ERROR_UNSUPPORTED for
 * a reserved member in use, then for a phase of other than gradient noise; SCARP_ERROR_PARAMETER if
 * `dimensions` is neither 2 nor 3; SCARP_ERROR_PARAMETER for a period, SCARP_ERROR_UNSUPPORTED for
 * turned axes with one, then for one of 2D simplex noise along y. Last come the warps: "warp" is at
 * fault if one of them is, with the status that it has by itself, or, with
 * SCARP_ERROR_UNSUPPORTED, if there are more than four.
 */
SCARP_API enum scarp_status scarp_noise_check(const struct scarp_noise *noise, int dimensions,
                                              const char **member);

/*
 * scarp_plan_make - makes the plan of a noise, for many calls with few points
 *
 * The constants of a noise take about as long to compute as 15 points (one octave) or 10 (eight),
 * with a phase up to three times as long.
 * With noise->plan = plan, sample and grid calls of 2 or 3 `dimensions`, as the plan was made for,
 * and scarp_curl2, take them from *plan, and give the same bits. One plan serves all outputs,
 * floats and doubles, every kernel set, and any number of threads at a time. Calls only read it.
 *
 *     struct scarp_plan plan;
 *     struct scarp_noise noise = {.octaves = 8.0f};
 *     if (scarp_plan_make(&noise, 2, &plan) == SCARP_OK) {
 *         noise.plan = &plan;
 *     }
 *
 * A plan that does not fit does no harm: a call compares the noise that the plan was made of with
 * its own, byte for byte but for `plan`. Where that, the dimensions or the version of the library
 * differ, the call does without it. So a plan may stay where it is while the noise is changed, and
 * the bytes of *plan may be any before they are first made (zeros, or what was in memory): any, but
 * those of a good plan that was changed in part, with which the behaviour is undefined.
 *
 * No other thread may use *plan while it is made. On an error it is left as it was. Returns
 * SCARP_ERROR_NULL if `noise` or `plan` is NULL; otherwise as scarp_noise_check.
 */
SCARP_API enum scarp_status scarp_plan_make(const struct scarp_noise *noise, int dimensions,
                                            struct scarp_plan *plan);

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
 * of each function. What is said at the top of this file holds for recipes, too: exact derivatives
 * through the whole expression, the same bits everywhere, a promised range, no allocation. A text
 * gives the same bits in all versions of the library of the same major version.
 *
 *     static struct scarp_recipe recipe;
 *     struct scarp_recipe_error error;
 *     if (scarp_recipe_parse(text, strlen(text), &recipe, &error, 1, NULL) != SCARP_OK) {
 *         fprintf(stderr, "%d:%d: %s\n", (int)error.line, (int)error.column, error.text);
 *     }
 *     struct scarp_samples out = {.value = height, .dx = dx, .dy = dy};
 *     struct scarp_recipe_outputs outputs = {.count = 1, .out = &out};
 *     static uint64_t memory[65536 / 8];
 *     struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
 *     scarp_recipe_grid(&recipe, &grid, &outputs, &scratch);
 *
 * Calls that read a recipe may run in any number of threads at a time, each with scratch memory of
 * its own. They take up to 2 KiB more of the stack than other calls, and 8 KiB more than that
 * without scratch memory, so threads with 64 KiB will do.
 */

/* A text and what it was compiled to: 64 KiB. Its bytes have no meaning to others; it belongs to
   the caller, who may copy it, as a whole, to wherever a uint64_t may stand. It does not belong on
   a small stack. */
struct scarp_recipe {
    uint64_t first;
    unsigned char rest[65536 - 8];
};

/* What is wrong with a text, and where. */
struct scarp_recipe_error {
    /* bytes of the text, `to` excluded */
    size_t from SCARP_ZERO;
    size_t to SCARP_ZERO;

    /* of `from`, counted from 1; columns are bytes */
    int32_t line SCARP_ZERO;
    int32_t column SCARP_ZERO;

    const char *text SCARP_ZERO; /* static: a clause without a full stop */

    /* static: the member of a noise, or the argument, that is at fault; or NULL */
    const char *member SCARP_ZERO;

    double nearest SCARP_ZERO; /* a number that would do there; 0: none is told */
    uint32_t spare[6] SCARP_ZERO;
};

/*
 * scarp_recipe_parse - read a text
 *
 * `text` has `length` bytes, at most 16,384, and may go away afterwards. Parameters have the values
 * that the text gives them, the seed of the world is 0.
 *
 * *found becomes the number of errors in the text, which may be more than one: reading goes on
 * behind each. The first `capacity` of them, in the order of the text, are written to `errors`.
 * `errors` and `found` may be NULL.
 *
 * Returns SCARP_ERROR_NULL if `text` or `recipe` is NULL; SCARP_ERROR_SIZE for a text that is too
 * long; else, if there is an error, SCARP_ERROR_SIZE if a limit of recipes is passed (512
 * expressions, 96 names, 256 fields, 48 noises, 16 outputs, 32 places), SCARP_ERROR_PARAMETER if
 * not. In these two last cases *recipe has what could be read, for editors: it may be described,
 * and statements without an error may be sampled by number. Otherwise *recipe is untouched.
 */
SCARP_API enum scarp_status scarp_recipe_parse(const char *text, size_t length,
                                               struct scarp_recipe *recipe,
                                               struct scarp_recipe_error *errors, size_t capacity,
                                               size_t *found);

/*
 * scarp_recipe_seed - set the seed of the world
 *
 * All noises follow: those without a seed, or with seed=0, take it, others a number that is made of
 * it and theirs. Returns SCARP_ERROR_NULL, or SCARP_ERROR_PARAMETER if *recipe is none, or has
 * errors.
 */
SCARP_API enum scarp_status scarp_recipe_seed(struct scarp_recipe *recipe, uint64_t seed);

/*
 * scarp_recipe_set - set a parameter
 *
 * `name` is that of a `param`, or "finest": then octaves whose cells are smaller than so many units
 * are left out, 0 for none, and large forms stay to the bit. Octaves of gullies count by cells of
 * the base, divided by the lacunarity from octave to octave. The recipe is compiled again, which
 * takes some microseconds.
 *
 * Returns SCARP_ERROR_NULL if `recipe` or `name` is NULL; SCARP_ERROR_PARAMETER if *recipe is none,
 * or has errors, for a name that does not exist, a value outside its interval, and one with which
 * the text has an error, which is written to *error (may be NULL); SCARP_ERROR_SIZE as
 * scarp_recipe_parse. On an error the old value stays.
 */
SCARP_API enum scarp_status scarp_recipe_set(struct scarp_recipe *recipe, const char *name,
                                             double value, struct scarp_recipe_error *error);

/* Memory that a call uses while it runs, of any alignment. Its size changes speed, never a bit. */
struct scarp_scratch {
    void *memory SCARP_ZERO;
    size_t size SCARP_ZERO;
    uint32_t spare[12] SCARP_ZERO; /* reserved: 0 */
};

/* Results of a call: of each of `count` outputs, an element of `out`. */
struct scarp_recipe_outputs {
    const struct scarp_samples *out SCARP_ZERO;

    /* NULL: the outputs of the text, in its order, from the first one on. Else numbers of
       statements, as scarp_recipe_entry_at counts them, or SCARP_RECIPE_PARTS plus the number of a
       part: any field, as it is where nothing is transformed. */
    const int32_t *which SCARP_ZERO;

    int32_t count SCARP_ZERO;     /* from 1 to 16 */
    uint32_t spare[9] SCARP_ZERO; /* reserved: 0 */
};

#define SCARP_RECIPE_PARTS 65536
#define SCARP_RECIPE_OUTPUT (-1)

/*
 * scarp_recipe_sample - sample a recipe at points
 *
 * For each i < count, element i of each array is the output at (x[i], y[i]), in space at (x[i],
 * y[i], z[i]), with its exact derivatives. z is not read in the plane. Arrays have at least `count`
 * elements, and none that is written may overlap another one.
 *
 * Positions are computed in float, as scarp_sample2 has them: these are the bits of shaders. Where
 * a coordinate is NaN or infinite, outputs are NaN, but for what a mask that is 0 hides.
 *
 * `scratch` may be NULL, or have NULL for memory: then the call takes 8 KiB more of the stack, and
 * small chunks. scarp_recipe_scratch_size has the size for chunks of so many points; about 1,000
 * are best.
 *
 * Returns SCARP_ERROR_NULL if count > 0 and `recipe`, `outputs`, outputs->out or a coordinate is
 * NULL; SCARP_ERROR_PARAMETER if *recipe is none, or has errors that this call meets, for a number
 * of outputs, or one in `which`, that does not exist; SCARP_ERROR_UNSUPPORTED for a derivative that
 * an output does not have (along z in the plane; by the phase; a second one of erosion, Swiss and
 * Jordan noise, of gullies, slopes and distances in cells), or a reserved member in use;
 * SCARP_ERROR_SIZE if arrays would exceed the address space, or no chunk fits into the scratch
 * memory. A count of 0 succeeds, whatever the other arguments are.
 */
SCARP_API enum scarp_status scarp_recipe_sample(const struct scarp_recipe *recipe, size_t count,
                                                const float *x, const float *y, const float *z,
                                                const struct scarp_recipe_outputs *outputs,
                                                const struct scarp_scratch *scratch);

/* scarp_recipe_sample_f64 - like scarp_recipe_sample, but with double coordinates, as
   scarp_sample2_f64: transforms are computed in double, too, so worlds may be large */
SCARP_API enum scarp_status scarp_recipe_sample_f64(const struct scarp_recipe *recipe, size_t count,
                                                    const double *x, const double *y,
                                                    const double *z,
                                                    const struct scarp_recipe_outputs *outputs,
                                                    const struct scarp_scratch *scratch);

/*
 * scarp_recipe_grid - sample a recipe on a uniform grid, in the plane or in space
 *
 * Arrays are as scarp_grid2, or scarp_grid3, has them, and have, to the bit, what
 * scarp_recipe_sample_f64 gives at the coordinates of each sample. Noise that no function
 * transforms is as fast as on grids, and what does not depend on z is computed once per column.
 * Returns what scarp_grid2 says of grids; otherwise as scarp_recipe_sample.
 */
SCARP_API enum scarp_status scarp_recipe_grid(const struct scarp_recipe *recipe,
                                              const struct scarp_grid *grid,
                                              const struct scarp_recipe_outputs *outputs,
                                              const struct scarp_scratch *scratch);

/* scarp_recipe_scratch_size - bytes of scratch memory for chunks of so many points, with
   derivatives up to an order from 0 to 2, of the outputs of the text. 0 for what does not exist. */
SCARP_API size_t scarp_recipe_scratch_size(const struct scarp_recipe *recipe, int order,
                                           size_t points);

/* A box of points; the plane ignores the elements 2. */
struct scarp_box {
    double lowest[3] SCARP_ZERO;
    double highest[3] SCARP_ZERO;
};

/*
 * scarp_recipe_range - the interval that values never leave
 *
 * `which` is as in struct scarp_recipe_outputs, or SCARP_RECIPE_OUTPUT for the first output.
 * *lowest
 * <= value <= *highest, rounding included, at all points, or those in the box if there is one. The
 * interval follows from those of all parts, so it may be wider than need be; it is infinite where
 * coordinates count and there is no box.
 *
 * Returns SCARP_ERROR_NULL if `recipe`, `lowest` or `highest` is NULL; SCARP_ERROR_PARAMETER as
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

/* A statement: param, out or name = expression. Spans are bytes of the text, the second excluded.
 */
struct scarp_recipe_entry {
    uint32_t span[2] SCARP_ZERO;
    uint32_t name[2] SCARP_ZERO;
    int32_t kind SCARP_ZERO;     /* enum scarp_recipe_kind */
    int32_t is_param SCARP_ZERO; /* 1 for param, else 0 */
    int32_t output SCARP_ZERO;   /* the number of the output that it is, or -1 */
    int32_t part SCARP_ZERO;     /* the number of its expression; -1 for param */
    double value SCARP_ZERO;     /* of numbers */

    /* of param: the interval that the text gives, else that of all numbers */
    double slider[2] SCARP_ZERO;

    float range[2] SCARP_ZERO; /* of fields: the interval that values never leave */
    uint32_t axes SCARP_ZERO;  /* of fields: on which they depend: 1 x, 2 y, 4 z */
    uint32_t order SCARP_ZERO; /* of fields: the highest order of their derivatives */

    /* the same as before an edit if nothing has to be drawn anew */
    uint64_t hash SCARP_ZERO;

    uint32_t spare[8] SCARP_ZERO;
};

/* A part of an expression. Parts are counted from 0; a call, and a sign, stands in front of the
   parts that it has, other operators stand behind theirs. */
struct scarp_recipe_part {
    uint32_t span[2] SCARP_ZERO;

    /* of a name, or of the function that is called; else empty */
    uint32_t name[2] SCARP_ZERO;

    uint32_t argument[2] SCARP_ZERO; /* the name that it has as an argument; else empty */
    int32_t kind SCARP_ZERO;         /* enum scarp_recipe_kind */

    /* of a call: its number, as scarp_recipe_function_at counts; else -1 */
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
    /* text: what it does, without a full stop */
    const char *name SCARP_ZERO;
    const char *text SCARP_ZERO;

    int32_t kind SCARP_ZERO; /* enum scarp_recipe_kind: what is expected */
    int32_t is_needed SCARP_ZERO;
    double otherwise SCARP_ZERO; /* of numbers: the value without the argument */

    /* of numbers: the interval for a slider; more may be valid */
    double lowest SCARP_ZERO;
    double highest SCARP_ZERO;

    /* of words: those that it may be, and NULL; else NULL */
    const char *const *words SCARP_ZERO;

    uint32_t spare[4] SCARP_ZERO;
};

struct scarp_recipe_function {
    /* text: a sentence */
    const char *name SCARP_ZERO;
    const char *text SCARP_ZERO;

    const struct scarp_recipe_argument *argument SCARP_ZERO;

    /* the last one may be given again and again if its kind is SCARP_RECIPE_KNOT */
    int32_t arguments SCARP_ZERO;

    uint32_t spare[5] SCARP_ZERO;
};

/*
 * scarp_recipe_entry_at, scarp_recipe_part_at, scarp_recipe_function_at - what editors show
 *
 * They fill in what is number `index`, of statements, of parts, and of the functions of the
 * language. Recipes with errors may be described, too. Spare members become 0.
 *
 * Return SCARP_ERROR_NULL if a pointer is NULL; SCARP_ERROR_PARAMETER if *recipe is none, and for
 * the first index that does not exist, and all behind it.
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
 * noise from a uniform buffer, a struct scarp_gpu_plan, or those of a recipe. File and constants
 * must be of the same version of the library.
 *
 * Equal bits. A shader gives the bits of scarp_sample2 and scarp_sample3, with float coordinates,
 * on drivers that round sums, differences and products to the nearest float, and fuse none of them.
 * Vulkan promises that with NoContraction, which scarp.glsl asks for, and with the execution mode
 * RoundingModeRTE of 32 bits, for which SCARP_ROUND asks. What must hold: all p_k are
 * finite; the coordinates of first octaves, f_0 times x, or in noise with warps times y, are 0 or
 * at least 2^-24 in magnitude. Results below 2^-120 in magnitude may be 0, also those on the
 * way: squares under a root, as in the slope of a gradient below 2^-60. The sign of 0 is not
 * promised, and nor are results that overflow.
 *
 * WGSL and D3D promise less on paper: compilers may fuse or reorder there, and flush or round
 * otherwise. So a program asks each driver at its start: it has a shader compute scarp_answer2 or
 * scarp_answer3 for i < SCARP_GPU_ANSWERS, and compares with what scarp_gpu_answers gives. If all
 * are equal, the driver keeps the promise for this noise, as far as 4,096 points can tell. If not,
 * the program uploads what has to be equal as tiles that it computes here. The shader still draws
 * the noise, but for rounding, where nothing depends on its bits.
 */

/* An octave, in the layout std140 of uniform buffers: 160 bytes. See struct scarp_noise. */
struct scarp_gpu_octave {
    uint32_t key[3];      /* keys of the lattice hash, by axis */
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
 * scarp_gpu_plan_make - the constants of a noise, for shaders
 *
 * *plan is for shaders that sample the noise in 2 or 3 `dimensions`. The same noise gives the same
 * bytes on every machine, but for their order in a word.
 *
 * A plan has 32 octaves in all: those of the noise and of each warp, and of a warp by other than
 * gradient and value noise `dimensions` times as many as it says. Noise with warps that need more
 * is SCARP_ERROR_UNSUPPORTED, with "warp" as *member.
 *
 * Returns SCARP_ERROR_NULL if `noise` or `plan` is NULL; otherwise as scarp_noise_check, of which
 * `member` is, too: it may be NULL. On an error *plan is left as it was.
 */
SCARP_API enum scarp_status scarp_gpu_plan_make(const struct scarp_noise *noise, int dimensions,
                                                struct scarp_gpu_plan *plan, const char **member);

/* scarp_gpu_vector_plan_make - likewise for the components of vector noise, as scarp_vector2 and
   scarp_vector3 give them: for scarp_vector2, scarp_vector3 and scarp_curl3 of shaders. Level 0 has
   octaves as those of a warp; if these are too many for a noise without a warp, *member is
   "octaves". */
SCARP_API enum scarp_status scarp_gpu_vector_plan_make(const struct scarp_noise *noise,
                                                       int dimensions, struct scarp_gpu_plan *plan,
                                                       const char **member);

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
 * Returns SCARP_ERROR_NULL if `noise` or `answer` is NULL; otherwise what scarp_gpu_plan_make
 * returns; then SCARP_ERROR_PARAMETER for an `order` that does not exist, SCARP_ERROR_UNSUPPORTED
 * for one that the noise, or a warp, does not have.
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
    size_t length SCARP_ZERO;      /* of it, in bytes */
    uint32_t spare[12] SCARP_ZERO; /* reserved: 0 */
};

/*
 * scarp_recipe_shader - a recipe as functions of a shading language
 *
 * The text declares a uniform buffer, which scarp_recipe_uniforms fills, and has
 *
 *     ScarpRecipe scarp_recipe(x, y)         all outputs: a structure with members out0, out1, ...
 *     ScarpSample scarp_recipe_NAME(x, y)    one of them: value, gradient, diagonal, mixed
 *     uint scarp_answer_recipe(i)            the self-test: answer i of scarp_recipe_answers
 *
 * with float coordinates, in space x, y and z. Runs of underscores in a name become one. Behind
 * them is what they use of the file, and no more. What masks hide is left out by `if`. Derivatives
 * above `order`, or above those that an output has, mean nothing. In GLSL and HLSL the macros of
 * the file say where the buffer is (SCARP_BINDING, SCARP_REGISTER); in WGSL the shader declares
 *
 *     @group(0) @binding(0) var<uniform> scarp_plan: ScarpRecipePlan;
 *
 * Equal bits, under the conditions above: outputs are those of scarp_recipe_sample. Where sine() is
 * used, one result of some 10^8 may be off in the last place.
 *
 * scarp_recipe_seed never changes the text. scarp_recipe_set does if a number becomes, or was, one
 * that makes a function simpler, as a factor of 1, or if there are more octaves: then the text that
 * this call gives differs from the one before, and the shader is compiled again.
 *
 * *length becomes the length of the text without the 0 behind it. If there is no room for both,
 * nothing useful is written, the call returns SCARP_ERROR_SIZE, and *length, which may be more
 * then, plus 1 is a capacity that suffices. Otherwise returns SCARP_ERROR_NULL if `recipe`, `how`,
 * its file, or `length` is NULL, or `text` with a capacity above 0; SCARP_ERROR_PARAMETER if
 * *recipe is none, or has errors, for an order that does not exist, or a file that is not that of
 * the language; SCARP_ERROR_ENUM for an unknown language; SCARP_ERROR_UNSUPPORTED for a reserved
 * member in use.
 */
SCARP_API enum scarp_status scarp_recipe_shader(const struct scarp_recipe *recipe,
                                                const struct scarp_shader *how, char *text,
                                                size_t capacity, size_t *length);

/*
 * scarp_recipe_uniforms - the uniform buffer of that shader
 *
 * Seed and parameters are in here. The layout is that of std140: 16 bytes, vectors of 16, levels of
 * 48 and octaves of 160 bytes (struct scarp_gpu_level, struct scarp_gpu_octave). `bytes` may stand
 * wherever a float may. *size becomes the size; if the capacity is less, the call returns
 * SCARP_ERROR_SIZE. Otherwise errors are as of scarp_recipe_shader. A recipe with 30 octaves takes
 * about 6 KiB; devices have 16 KiB at least, most of them 64.
 */
SCARP_API enum scarp_status scarp_recipe_uniforms(const struct scarp_recipe *recipe, void *bytes,
                                                  size_t capacity, size_t *size);

/*
 * scarp_recipe_answers - what a shader of a recipe must answer: a test for the start of a program
 *
 * answer[i], for i < SCARP_GPU_ANSWERS, is a hash of all outputs at test point i, up to an order
 * from 0 to 2, or that of the output; scarp_answer_recipe(i) of a shader with this order gives the
 * same number. Points lie around the origin, some thousand cells of the first noise away.
 *
 * Returns SCARP_ERROR_NULL if a pointer is NULL; SCARP_ERROR_PARAMETER as scarp_recipe_shader.
 */
SCARP_API enum scarp_status scarp_recipe_answers(const struct scarp_recipe *recipe, int order,
                                                 uint32_t *answer);

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

/*
 * Instruction sets. The best kernel set that processor and operating system can run is chosen at
 * the first call. Results do not depend on it; these calls exist for tests, comparisons and info.
 */

/* scarp_isa_active - the kernel set in use */
SCARP_API enum scarp_isa scarp_isa_active(void);

/* scarp_isa_supported - whether this build has the kernel set and this processor can run it. The
   answer is 0 for SCARP_ISA_NONE and for numbers that are no enumerator. */
SCARP_API int scarp_isa_supported(enum scarp_isa isa);

/*
 * scarp_isa_select - use a kernel set from now on, in all threads
 *
 * SCARP_ISA_NONE returns to the best one. Calls under way finish with the set they began with.
 * Returns SCARP_ERROR_ENUM for an unknown `isa`, SCARP_ERROR_UNSUPPORTED if it cannot run here; the
 * choice is then unchanged.
 */
SCARP_API enum scarp_status scarp_isa_select(enum scarp_isa isa);

/*
 * scarp_isa_name - "none", "scalar", "sse4.1", "avx2", "avx512", "neon", "generic",
 * "wasm128"
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

#endif
