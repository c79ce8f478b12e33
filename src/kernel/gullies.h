/* SPDX-License-Identifier: MIT
 *
 * Gullies, chunk by chunk: the base becomes a state, which each octave changes.
 *
 *     base --> begin --> state --> across --> corners --> blend --> add --> state --> ... --> end
 *     positions --> lattice.h --> cells, hashes --^----------^
 *
 * Each octave goes through four passes. One pass that did all would be a chain of 80 dependent
 * operations with three roots and three divisions: schedulers of processors hold less than a block
 * of it, and it takes a fifth more time (Zen 4, gcc 12, AVX2).
 *
 * Chunks of grids go on across the ends of rows (flat.h), so their bases and outputs are copied.
 */
#ifndef SCARP_KERNEL_GULLIES_H
#define SCARP_KERNEL_GULLIES_H

#include "flat.h"
#include "gullies/gully.h"

/* Samples of a chunk: their number, and where their bases are, one after the other. */
struct gully_chunk {
    const struct scarp_gully_plan *gullies;
    size_t count;
    const float *base[BASE_INPUTS];
    float *out[ERODED_OUTPUTS];
};

/* Loads up to a block; what lies beyond is 0. */
VEC_INLINE vf load_up_to(const float *from, size_t count)
{
    return count < VEC_LANES ? vf_load_partial(from, count) : vf_load(from);
}

VEC_INLINE void store_up_to(float *to, vf v, size_t count)
{
    if (count < VEC_LANES) {
        vf_store_partial(to, v, count);
    } else {
        vf_store(to, v);
    }
}

VEC_INLINE void gully_begin_run(struct gully *state, const struct gully_chunk *chunk, int order)
{
    static const unsigned char orders[BASE_INPUTS] = {0, 1, 1, 2, 2, 2};
    const struct gully_chunk c = *chunk;
    const struct scarp_gully_plan *const g = c.gullies;
    const int inputs = order > 0 ? BASE_INPUTS : BASE_DXX;
    for (size_t at = 0; at < c.count; at += VEC_LANES, state++) {
        vf base[BASE_INPUTS];
        for (int k = 0; k < BASE_INPUTS; k++) {
            base[k] = k < inputs ? load_up_to(c.base[k] + at, c.count - at) * g->of_base[orders[k]]
                                 : vf_set(0.0f);
        }
        gully_begin(state, g, base, order);
    }
}

/* Computes the direction across the slope. */
VEC_INLINE void gully_across_run(struct gully_wave *wave, const struct gully *state, size_t blocks,
                                 int order)
{
    for (size_t b = 0; b < blocks; b++) {
        wave[b].t = across_slope(&state[b].slope, order);
    }
}

static __attribute__((noinline)) void gully_corners_pass(struct gully_wave *wave, const vf *lattice,
                                                         size_t blocks,
                                                         const struct scarp_gully_octave *octave)
{
    const struct scarp_gully_octave o = *octave;
    for (size_t b = 0; b < blocks; b++, lattice += LATTICE_SIZE2) {
        gully_corners(&wave[b], lattice, &o);
    }
}

VEC_INLINE void gully_blend_run(struct gully_wave *wave, const vf *lattice, size_t blocks,
                                const struct scarp_gully_octave *octave, int order)
{
    const struct scarp_gully_octave o = *octave;
    for (size_t b = 0; b < blocks; b++, lattice += LATTICE_SIZE2) {
        const struct pair_jet z = blend_of(&wave[b], lattice, &o, order);
        wave[b].blend = normalised(&z, order);
    }
}

VEC_INLINE void gully_add_run(struct gully *state, const struct gully_wave *wave, size_t blocks,
                              const struct scarp_gully_plan *g, int k, int order)
{
    const struct scarp_gully_octave o = g->octave[k];
    for (size_t b = 0; b < blocks; b++) {
        gully_add(&state[b], &wave[b], g, &o, order);
    }
}

/* Puts the sums of a chunk. Outputs may be where its bases are. */
VEC_INLINE void gully_end_run(const struct gully *state, const struct gully_chunk *chunk, int order)
{
    const struct gully_chunk c = *chunk;
    for (size_t at = 0; at < c.count; at += VEC_LANES, state++) {
        const size_t here = c.count - at;
        vf of[ERODED_OUTPUTS];
        of[ERODED_DISPLACEMENT] = c.gullies->of_sum[0] * state->sum.value;
        if (order > 0) {
            of[ERODED_DISPLACEMENT_DX] = c.gullies->of_sum[1] * state->sum.d.x;
            of[ERODED_DISPLACEMENT_DY] = c.gullies->of_sum[1] * state->sum.d.y;
        }
        for (int i = 0; i < (order > 0 ? 3 : 1); i++) {
            of[ERODED_VALUE + i] = load_up_to(c.base[i] + at, here) + of[ERODED_DISPLACEMENT + i];
        }
        for (int i = 0; i < ERODED_OUTPUTS; i++) {
            if ((order > 0 || i % 3 == 0) && c.out[i] != NULL) {
                store_up_to(c.out[i] + at, of[i], here);
            }
        }
    }
}

/* The passes over a chunk with and without derivatives. */
struct gully_passes {
    void (*begin)(struct gully *state, const struct gully_chunk *chunk);
    void (*across)(struct gully_wave *wave, const struct gully *state, size_t blocks);
    void (*blend)(struct gully_wave *wave, const vf *lattice, size_t blocks,
                  const struct scarp_gully_octave *octave);
    void (*add)(struct gully *state, const struct gully_wave *wave, size_t blocks,
                const struct scarp_gully_plan *g, int k);
    void (*end)(const struct gully *state, const struct gully_chunk *chunk);
};

#define GULLY_PASSES(order)                                                                        \
    static void gully_begin##order(struct gully *state, const struct gully_chunk *chunk)           \
    {                                                                                              \
        gully_begin_run(state, chunk, order);                                                      \
    }                                                                                              \
    static void gully_across##order(struct gully_wave *wave, const struct gully *state,            \
                                    size_t blocks)                                                 \
    {                                                                                              \
        gully_across_run(wave, state, blocks, order);                                              \
    }                                                                                              \
    static void gully_blend##order(struct gully_wave *wave, const vf *lattice, size_t blocks,      \
                                   const struct scarp_gully_octave *octave)                        \
    {                                                                                              \
        gully_blend_run(wave, lattice, blocks, octave, order);                                     \
    }                                                                                              \
    static void gully_add##order(struct gully *state, const struct gully_wave *wave,               \
                                 size_t blocks, const struct scarp_gully_plan *g, int k)           \
    {                                                                                              \
        gully_add_run(state, wave, blocks, g, k, order);                                           \
    }                                                                                              \
    static void gully_end##order(const struct gully *state, const struct gully_chunk *chunk)       \
    {                                                                                              \
        gully_end_run(state, chunk, order);                                                        \
    }

GULLY_PASSES(0)
GULLY_PASSES(1)

static const struct gully_passes gully_passes[2] = {
    {gully_begin0, gully_across0, gully_blend0, gully_add0, gully_end0},
    {gully_begin1, gully_across1, gully_blend1, gully_add1, gully_end1},
};

#undef GULLY_PASSES

/* What all chunks of a call share. */
struct gully_work {
    const struct scarp_gully_call *call;
    const struct scarp_call_plan *plan;
    const struct gully_passes *passes;
    enum layout layout;
    size_t most;       /* samples of a chunk: whole blocks */
    void *position[2]; /* for those of grids, and of a last block that is not full */
    float *copy;       /* of grids: for bases, then for outputs */
    struct gully *state;
    struct gully_wave *wave;
    vf *lattice;
};

static void gully_divide(struct gully_work *w, struct workspace work)
{
    enum {
        STATE = sizeof(struct gully) / sizeof(vf),
        WAVE = sizeof(struct gully_wave) / sizeof(vf)
    };
    const size_t copies = w->call->grid != NULL ? BASE_INPUTS : 0;
    const size_t doubles = w->layout == DOUBLES ? 2 : 1;
    const size_t each = STATE + WAVE + LATTICE_SIZE2 + copies + 2 * doubles;
    const size_t blocks = (work.vectors - 4) / each;
    w->most = blocks * VEC_LANES;
    w->state = (struct gully *)work.space;
    w->wave = (struct gully_wave *)(work.space + blocks * STATE);
    w->lattice = work.space + blocks * (STATE + WAVE);
    w->copy = (float *)(w->lattice + blocks * LATTICE_SIZE2);
    for (size_t i = 0; i < 2; i++) { /* coordinates of grids may be a vector more */
        w->position[i] = (vf *)w->copy + blocks * copies + i * (blocks * doubles + 2);
    }
}

/* Locates the points of a chunk in the cells of octave k; `may_be_far` where some octave is far. */
static void gully_locate(const struct gully_work *w, const struct positions *at, size_t count,
                         int k, int may_be_far)
{
    const struct scarp_octave *const o = &w->plan->octave[k];
    const enum axes axes = axes_of(w->plan, k);
    const size_t blocks = whole_blocks(count) / VEC_LANES;
    if (may_be_far && axes == AXES_TURNED && is_far(o->frequency64, count, at->array, 2)) {
        far_row(w->lattice, o, blocks, at, 2, TURNED_HASHED);
    } else {
        lattice_passes[CORNERS_HASHED][0][w->layout][axes](w->lattice, o, blocks, at);
    }
}

/* Takes a chunk, whose bases and outputs are in `chunk`, through the passes. */
static void gully_run(const struct gully_work *w, const void *const position[2],
                      const struct gully_chunk *chunk)
{
    const struct scarp_gully_plan *const g = chunk->gullies;
    const size_t blocks = whole_blocks(chunk->count) / VEC_LANES;
    const struct positions at = {.array = {position[0], position[1], NULL}};
    const int may_be_far = w->layout == DOUBLES && turns_axes(w->plan) &&
                           is_far(highest_frequency(w->plan), chunk->count, at.array, 2);
    w->passes->begin(w->state, chunk);
    for (int k = 0; k < w->plan->octaves; k++) {
        gully_locate(w, &at, chunk->count, k, may_be_far);
        w->passes->across(w->wave, w->state, blocks);
        gully_corners_pass(w->wave, w->lattice, blocks, &g->octave[k]);
        w->passes->blend(w->wave, w->lattice, blocks, &g->octave[k]);
        w->passes->add(w->state, w->wave, blocks, g, k);
    }
    w->passes->end(w->state, chunk);
}

/* The arrays of a call from a sample on. */
static void gully_arrays(struct gully_chunk *chunk, const struct gully_work *w, size_t first)
{
    for (int i = 0; i < BASE_INPUTS; i++) {
        chunk->base[i] = w->call->base[i] != NULL ? w->call->base[i] + first : NULL;
    }
    for (int i = 0; i < ERODED_OUTPUTS; i++) {
        chunk->out[i] = w->call->out[i] != NULL ? w->call->out[i] + first : NULL;
    }
}

/* Positions are read by the block: those that do not fill one are copied, with zeros behind them.
 */
static void gully_points(const struct gully_work *w)
{
    const size_t bytes = w->layout == DOUBLES ? sizeof(double) : sizeof(float);
    struct gully_chunk chunk = {.gullies = w->call->gullies};
    for (size_t first = 0; first < w->call->count; first += chunk.count) {
        const void *position[2];
        const size_t left = w->call->count - first;
        chunk.count = left < VEC_LANES ? left : least(left - left % VEC_LANES, w->most);
        for (int i = 0; i < 2; i++) {
            position[i] = (const char *)w->call->position[i] + first * bytes;
            if (chunk.count < VEC_LANES) {
                memset(w->position[i], 0, VEC_LANES * bytes);
                memcpy(w->position[i], position[i], chunk.count * bytes);
                position[i] = w->position[i];
            }
        }
        gully_arrays(&chunk, w, first);
        gully_run(w, position, &chunk);
    }
}

/* Copies the samples of the chunk of a grid that begins with sample `first`: bases from the
   caller's arrays, or outputs to them. */
static void gully_copy(const struct gully_work *w, size_t first, size_t count, int outputs)
{
    const size_t row = w->call->grid->count[0];
    struct gully_chunk rows;
    size_t run = least(row - first % row, count);
    for (size_t done = 0; done < count; done += run, run = least(row, count - done)) {
        const size_t at = first + done;
        gully_arrays(&rows, w, at / row * w->call->grid->row_stride + at % row);
        for (int i = 0; i < BASE_INPUTS; i++) {
            float *const copy = w->copy + (size_t)i * w->most + done;
            if (outputs && rows.out[i] != NULL) {
                memcpy(rows.out[i], copy, run * sizeof *copy);
            } else if (!outputs && rows.base[i] != NULL) {
                memcpy(copy, rows.base[i], run * sizeof *copy);
            }
        }
    }
}

_Static_assert((int)BASE_INPUTS == (int)ERODED_OUTPUTS, "the copies of outputs are those of bases");

static void gully_grid(const struct gully_work *w)
{
    const struct scarp_grid *const grid = w->call->grid;
    const size_t count = grid->count[0] * grid->count[1];
    double *const x = w->position[0], *const y = w->position[1];
    const void *const position[2] = {x, y};
    struct gully_chunk chunk = {.gullies = w->call->gullies};
    for (int i = 0; i < BASE_INPUTS; i++) {
        chunk.base[i] = w->copy + (size_t)i * w->most;
        chunk.out[i] = w->call->out[i] != NULL ? w->copy + (size_t)i * w->most : NULL;
    }
    for (size_t first = 0; first < count; first += chunk.count) {
        chunk.count = least(count - first, w->most);
        flat_fill_x(x, grid, first % grid->count[0], whole_blocks(chunk.count));
        flat_fill_runs(y, grid, 1, first, whole_blocks(chunk.count));
        gully_copy(w, first, chunk.count, 0);
        gully_run(w, position, &chunk);
        gully_copy(w, first, chunk.count, 1);
    }
}

static void gullies(const struct scarp_gully_call *call, const struct scarp_call_plan *plan)
{
    vf space[CHUNK_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    struct gully_work w = {.plan = plan,
                           .passes = &gully_passes[call->base[BASE_DXX] != NULL],
                           .layout = call->doubles ? DOUBLES : FLOATS};
    w.call = call;
    gully_divide(&w, work);
    if (call->grid != NULL) {
        gully_grid(&w);
    } else {
        gully_points(&w);
    }
}

#endif
