/* SPDX-License-Identifier: MIT
 *
 * What a peer, another library measured next to scarp, has to offer. One file peer_<library>.c or
 * .cpp each; peers.c lists those that were found when this was built.
 */
#ifndef SCARP_BENCH_PEER_H
#define SCARP_BENCH_PEER_H

#include "work.h"

#ifdef __cplusplus
extern "C" {
#endif

struct bench_peer {
    const char *library;

    /* Makes ready for the values of `work` (its basis, dimensions, fractal, octaves and layout
       count) with the instruction set `isa`. NULL if the peer has nothing comparable, or cannot run
       it. A peer that does not choose among instruction sets offers SCARP_ISA_SCALAR. */
    void *(*open)(const struct bench_work *work, enum scarp_isa isa);
    void (*close)(void *state);

    /* Writes the noise at (x[0][i], x[1][i], x[2][i]) to value[i], for each i < count. */
    void (*points)(const void *state, size_t count, const float *const x[3], float *value);

    /* Writes the noise on the grid of the workload that the state was opened for. NULL if the peer
       has no grids. */
    void (*grid)(const void *state, const struct bench_work *work, float *value);

    /* Draws gullies at (x[0][i], x[1][i]) into a base, with derivatives where `out` has arrays for
       them. NULL if the peer has none. */
    void (*gullies)(const void *state, size_t count, const float *const x[2],
                    const struct scarp_samples *base, const struct scarp_eroded *out);

    /* Evaluates the recipe of the workload: on its grid, or at points, which are floats or doubles
       as the workload says. NULL if the peer has none. */
    void (*recipe)(void *state, const struct bench_work *work, const void *const x[3],
                   const struct scarp_samples *out);

    /* Tries the ways in which it can evaluate the recipe, as `recipe` has it, and takes the fastest
       from then on. Returns the name of that, or NULL without memory. NULL if there is one way. */
    const char *(*choose)(void *state, const struct bench_work *work, const void *const x[3],
                          const struct scarp_samples *out);
};

/* The peer number `index`, counted from 0; NULL when there are no more */
const struct bench_peer *bench_peer_get(size_t index);

extern const struct bench_peer bench_peer_stb_perlin;
extern const struct bench_peer bench_peer_libnoise;
extern const struct bench_peer bench_peer_fastnoiselite;
extern const struct bench_peer bench_peer_fastnoise2;
extern const struct bench_peer bench_peer_plain;
extern const struct bench_peer bench_peer_hand;

#ifdef __cplusplus
}
#endif

#endif
