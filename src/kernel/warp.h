/* SPDX-License-Identifier: MIT
 *
 * Noise at displaced positions, chunk by chunk: the warps of a noise, from the deepest one, which
 * looks at the input, to the noise itself, which looks at y(x). The coordinates of y are kept as
 * samples: their values are how far they are displaced, their derivatives those of y with respect
 * to x. Points and grids go the same way, but that the deepest warp of a grid takes the passes of
 * grids. The reference is scalar/warp.h, with formulas/warp.h.
 */
#ifndef SCARP_KERNEL_WARP_H
#define SCARP_KERNEL_WARP_H

#include "flat.h"
#include "vector_points.h"

/* A chunk of noise with warps. */
struct warped {
    struct chunked chunked;
    const struct scarp_call_plan *plan;
    struct scarp_outputs y[3];     /* the coordinates, with derivatives with respect to x */
    struct scarp_outputs moved[3]; /* those of the level at work, by its positions; at level 0 the
                                      noise, or its components */
    float *dphase;                 /* of the noise, if it is asked for, component by component */
};

/* How many components level 0 has. */
static int noise_components(const struct scarp_call_plan *plan, int dimensions)
{
    return plan->warps.vector ? dimensions : 1;
}

/* Shares the scratch space out. */
static void warped_begin(struct warped *w, const struct scarp_call_plan *plan,
                         struct workspace work)
{
    struct chunked *const c = &w->chunked;
    const int n = c->f.dimensions, y = plan->warps.depth > 0 ? n : 0;
    const int components = noise_components(plan, n);
    const int in_place = plan->warps.depth == 1 && plan->order == 0 && !plan->warps.vector;
    const int moved = in_place ? 0 : plan->warps.depth > 1 ? n : components;
    const size_t size = sample_size(n, plan->order);
    const size_t dphases = plan->dphase ? (size_t)components : 0;
    float *from = chunked_begin(c, work, (size_t)(y + moved) * size + dphases);
    w->plan = plan;
    for (int i = 0; i < y; i++) {
        take_arrays(&w->y[i], &from, c->most, n, plan->order);
    }
    for (int i = 0; i < moved; i++) {
        take_arrays(&w->moved[i], &from, c->most, n, plan->order);
    }
    if (in_place) { /* values replace the displacements that they are computed with, tile by tile */
        memcpy(&w->moved[0], &w->y[0], sizeof w->y[0]);
    }
    w->dphase = plan->dphase ? from : NULL;
    chunked_end(c, work, from + dphases * c->most);
}

/* The three coordinates at a block. */
struct coordinates {
    struct sample x, y, z;
};

VEC_INLINE struct coordinates coordinates_at(const struct scarp_outputs y[3], size_t at,
                                             struct variant v)
{
    struct coordinates c;
    c.x = sample_at(&y[0], at, v);
    c.y = sample_at(&y[1], at, v);
    if (v.dimensions == 3) {
        c.z = sample_at(&y[2], at, v);
    }
    return c;
}

VEC_INLINE vf sum_along(vf x, vf y, vf z, struct vector v, int dimensions)
{
    const vf sum = x * v.x + y * v.y;
    return dimensions == 3 ? sum + z * v.z : sum;
}

/* The sum over the coordinates of a component of v times an output of the coordinate. */
#define ALONG(member, v) sum_along(y->x.member, y->y.member, y->z.member, v, variant.dimensions)

/* Turns a sample at y with derivatives with respect to y into one with derivatives with respect to
   x. */
VEC_INLINE struct sample composed(const struct sample *s, const struct coordinates *y,
                                  struct variant variant)
{
    struct vector g = {.x = s->dx, .y = s->dy};
    struct sample r;
    r.value = s->value;
    if (variant.dimensions == 3) {
        g.z = s->dz;
        r.dz = ALONG(dz, g);
    }
    r.dx = ALONG(dx, g);
    r.dy = ALONG(dy, g);
    if (variant.order == 2) {
        struct vector rx = {.x = s->dxx, .y = s->dxy}, ry = {.x = s->dxy, .y = s->dyy}, rz;
        if (variant.dimensions == 3) {
            rx.z = s->dxz;
            ry.z = s->dyz;
            rz = (struct vector){s->dxz, s->dyz, s->dzz};
        }
#define COLUMN(h, member)                                                                          \
    struct vector h = {.x = ALONG(member, rx), .y = ALONG(member, ry)};                            \
    if (variant.dimensions == 3) {                                                                 \
        h.z = ALONG(member, rz);                                                                   \
    }
        COLUMN(hx, dx)
        COLUMN(hy, dy)
        r.dxx = ALONG(dx, hx) + ALONG(dxx, g);
        r.dxy = ALONG(dx, hy) + ALONG(dxy, g);
        r.dyy = ALONG(dy, hy) + ALONG(dyy, g);
        if (variant.dimensions == 3) {
            COLUMN(hz, dz)
            r.dxz = ALONG(dx, hz) + ALONG(dxz, g);
            r.dyz = ALONG(dy, hz) + ALONG(dyz, g);
            r.dzz = ALONG(dz, hz) + ALONG(dzz, g);
        }
#undef COLUMN
    }
    return r;
}

#undef ALONG

VEC_INLINE void sample_put(const struct scarp_outputs *arrays, size_t at, const struct sample *s,
                           struct variant v)
{
#define DO(i, member, rank) vf_store(arrays->array[i] + at, s->member)
    EACH_OUTPUT(v, DO);
#undef DO
}

/* Turns some samples of `moved`, with derivatives with respect to y, into samples with derivatives
   with respect to x. */
VEC_INLINE void compose(const struct warped *w, int samples, size_t count, struct variant v)
{
    for (int i = 0; i < samples; i++) {
        for (size_t at = 0; at < count; at += VEC_LANES) {
            const struct coordinates y = coordinates_at(w->y, at, v);
            const struct sample moved = sample_at(&w->moved[i], at, v);
            const struct sample s = composed(&moved, &y, v);
            sample_put(&w->moved[i], at, &s, v);
        }
    }
}

#define COMPOSE(name, dimensions, order)                                                           \
    static __attribute__((noinline)) void name(const struct warped *w, int samples, size_t count)  \
    {                                                                                              \
        const struct variant v = {SCARP_GRADIENT, dimensions, order, 0};                           \
        compose(w, samples, count, v);                                                             \
    }
COMPOSE(compose2_order1, 2, 1)
COMPOSE(compose2_order2, 2, 2)
COMPOSE(compose3_order1, 3, 1)
COMPOSE(compose3_order2, 3, 2)
#undef COMPOSE

/* By [dimensions - 2][order - 1]. */
static void (*const compose_passes[2][2])(const struct warped *, int, size_t) = {
    {compose2_order1, compose2_order2},
    {compose3_order1, compose3_order2},
};

static void compose_any(const struct warped *w, int samples, size_t count)
{
    if (w->plan->order > 0) {
        compose_passes[w->chunked.f.dimensions - 2][w->plan->order - 1](w, samples, count);
    }
}

/* Fills the padding of each row of a chunk with 0, and what is left of the last block. */
static void pad_outputs(const struct scarp_outputs *to, const struct chunk *chunk)
{
    const size_t count = chunk_count(chunk), end = whole_blocks(count);
    for (int i = 0; i < OUTPUTS; i++) {
        float *const array = to->array[i];
        if (array == NULL) {
            continue;
        }
        for (size_t at = count; at < end; at++) {
            array[at] = 0.0f;
        }
        for (size_t r = 0; chunk->columns < chunk->pitch && r < chunk->rows; r++) {
            for (size_t at = chunk->columns; at < chunk->pitch; at++) {
                array[r * chunk->pitch + at] = 0.0f;
            }
        }
    }
}

/* The grid that the samples of a chunk of a grid make, one after the other. */
static void chunk_grid(struct scarp_grid *grid, const struct warped *w, const struct chunk *chunk)
{
    *grid = *w->chunked.source.grid;
    for (int axis = 0; axis < 3; axis++) {
        grid->first[axis] += (int64_t)chunk->at[axis];
    }
    grid->count[0] = chunk->columns;
    grid->row_stride = chunk->pitch;
    grid->count[1] = chunk->rows;
    grid->count[2] = 1;
    grid->slice_stride = chunk_count(chunk);
}

/* The plan of a component of a level. This is out of line for the sake of size. */
static __attribute__((noinline)) void
plan_component(struct scarp_call_plan *plan, const struct warped *w, int level, int component)
{
    const struct scarp_warps *const warps = &w->plan->warps;
    const int is_alone = warps->depth == 0 && !warps->vector;
    *plan = is_alone ? *w->plan : scarpi_component_plan(w->plan, level, component);
}

/* Describes the positions of a level that is displaced by y: doubles by arrays of their own. */
static struct frame displaced_input(const void *position[3], struct moved_axis axis[3],
                                    const struct warped *w, const struct chunk *chunk)
{
    const struct chunked *const c = &w->chunked;
    const float *by[3] = {NULL, NULL, NULL};
    struct frame f = c->f;
    for (int i = 0; i < f.dimensions; i++) {
        by[i] = w->y[i].array[VALUE];
        position[i] = f.layout == DOUBLES ? (const void *)&axis[i] : c->position[i];
    }
    if (f.layout == DOUBLES) {
        f.layout = MOVED;
        moved_input(axis, c, chunk, by);
    }
    return f;
}

/* Computes `count` components of a level, which are all that it has, without its warps, to `to`: at
   the input of the chunk if the level is the deepest, on a grid as a grid if that is faster, and
   then padded as rows of the chunk are; else at the displaced positions. */
static void evaluate(const struct warped *w, const struct chunk *chunk, int level, int count,
                     const struct scarp_outputs *to)
{
    const struct chunked *const c = &w->chunked;
    const int is_deepest = level == w->plan->warps.depth;
    const size_t end = whole_blocks(chunk_count(chunk));
    const void *position[3] = {c->input[0], c->input[1], c->input[2]};
    struct moved_axis axis[3];
    struct frame f = c->f;
    struct scarp_call_plan plan;
    struct scarp_grid grid;
    plan_component(&plan, w, level, 0);
    int has_rows = is_deepest && c->source.grid != NULL;
    if (has_rows) {
        chunk_grid(&grid, w, chunk);
        has_rows = c->keep == KEEP_ROWS || !is_flat(&plan, &grid, f.dimensions);
    }
    if (!is_deepest) {
        f = displaced_input(position, axis, w, chunk);
    }
    if (!has_rows && count > 1 && shares_lattice_pass(&plan)) {
        vector_points(&plan, end, position, to, f, c->passes);
        return;
    }
    for (int i = 0; i < count; i++) {
        if (i > 0) {
            plan_component(&plan, w, level, i);
        }
        if (has_rows) {
            grid_within(&plan, &grid, &to[i], f.dimensions, c->passes);
            pad_outputs(&to[i], chunk);
        } else {
            points_unwarped(&plan, end, position, &to[i], f, c->passes);
        }
    }
}

/* Computes the coordinates y(x) of a level, and displaces positions that are floats. */
static void warp_level(struct warped *w, const struct chunk *chunk, int level)
{
    const int n = w->chunked.f.dimensions, order = w->plan->order, depth = w->plan->warps.depth;
    const int floats = w->chunked.f.layout == FLOATS;
    const size_t end = whole_blocks(chunk_count(chunk));
    evaluate(w, chunk, level, n, level == depth ? w->y : w->moved);
    if (level < depth) {
        struct scarp_outputs y[3];
        compose_any(w, n, end);
        memcpy(y, w->moved, sizeof y);
        memcpy(w->moved, w->y, sizeof y);
        memcpy(w->y, y, sizeof y);
        if (floats) {
            find_input(&w->chunked, chunk);
        }
    }
    for (int i = 0; i < n; i++) {
        float *const slope = w->y[i].array[DX + i];
        for (size_t at = 0; order > 0 && at < end; at += VEC_LANES) {
            vf_store(slope + at, vf_load(slope + at) + 1.0f);
        }
        for (size_t at = 0; floats && at < end; at += VEC_LANES) {
            displace(&w->chunked, i, at, vf_load(w->y[i].array[VALUE] + at));
        }
    }
}

/* Copies what the caller asked for of a component, from `first` on. */
static void give(const struct scarp_outputs *component, const struct scarp_outputs *out,
                 const struct chunk *chunk, size_t first, size_t row_stride)
{
    for (int i = 0; i < OUTPUTS; i++) {
        for (size_t r = 0; out->array[i] != NULL && r < chunk->rows; r++) {
            memcpy(out->array[i] + first + r * row_stride, component->array[i] + r * chunk->pitch,
                   chunk->columns * sizeof(float));
        }
    }
}

/* Moves the positions of a chunk to y. */
static void warp_positions(struct warped *w, const struct chunk *chunk)
{
    find_input(&w->chunked, chunk);
    for (int level = w->plan->warps.depth; level > 0; level--) {
        warp_level(w, chunk, level);
    }
}

/* Computes the noise there, or its components. Values go to `to`, derivatives with respect to x to
   `moved`, which `to` is then. */
static void warp_noise(const struct warped *w, const struct chunk *chunk,
                       const struct scarp_outputs *to)
{
    const int components = noise_components(w->plan, w->chunked.f.dimensions);
    evaluate(w, chunk, 0, components, to);
    if (w->plan->warps.depth > 0) {
        compose_any(w, components, whole_blocks(chunk_count(chunk)));
    }
}

/* Values of whole blocks of points go to the caller's array at once. */
static int gives_values(const struct warped *w, const struct scarp_outputs *out,
                        const struct chunk *chunk)
{
    return w->plan->order == 0 && !w->plan->dphase && out->array[VALUE] != NULL &&
           w->chunked.source.grid == NULL && chunk->columns % VEC_LANES == 0;
}

static void warp_chunk(struct warped *w, const struct scarp_outputs *out, const struct chunk *chunk,
                       size_t first, size_t row_stride)
{
    warp_positions(w, chunk);
    if (gives_values(w, out, chunk)) {
        const struct scarp_outputs values = {.array = {out->array[VALUE] + first}};
        warp_noise(w, chunk, &values);
        return;
    }
    w->moved[0].array[DPHASE] = w->dphase;
    warp_noise(w, chunk, w->moved);
    give(&w->moved[0], out, chunk, first, row_stride);
    w->moved[0].array[DPHASE] = NULL;
}

/* Computes points of a noise with warps. */
static __attribute__((noinline)) void warp_points(const struct scarp_call_plan *plan, size_t count,
                                                  const void *const position[3],
                                                  const struct scarp_outputs *out, struct frame f)
{
    vf space[CHUNK_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    struct warped w = {
        .chunked = {.source = {position, NULL}, .f = f, .keep = keep_of(f.layout, count)}};
    warped_begin(&w, plan, work);
    for (size_t first = 0; first < count; first += w.chunked.most) {
        const size_t here = least(count - first, w.chunked.most);
        const struct chunk chunk = {{first, 0, 0}, here, 1, here};
        warp_chunk(&w, out, &chunk, first, 0);
    }
}

/* Takes the components of a chunk of points, which are in w->moved. */
typedef void take_components(const struct warped *w, const void *out, const struct chunk *chunk);

/* Computes the components of vector noise at points, chunk by chunk. Outputs may be where
   coordinates are: those of a chunk are copied before. */
static __attribute__((noinline)) void warp_components(const struct scarp_call_plan *plan,
                                                      size_t count, const void *const position[3],
                                                      struct frame f, take_components *take,
                                                      const void *out)
{
    vf space[CHUNK_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    struct warped w = {.chunked = {.source = {position, NULL},
                                   .f = f,
                                   .keep = keep_of(f.layout, count),
                                   .copies = f.layout == FLOATS}};
    warped_begin(&w, plan, work);
    for (size_t first = 0; first < count; first += w.chunked.most) {
        const size_t here = least(count - first, w.chunked.most);
        const struct chunk chunk = {{first, 0, 0}, here, 1, here};
        warp_positions(&w, &chunk);
        for (int i = 0; i < f.dimensions; i++) {
            w.moved[i].array[DPHASE] = plan->dphase ? w.dphase + (size_t)i * w.chunked.most : NULL;
        }
        warp_noise(&w, &chunk, w.moved);
        take(&w, out, &chunk);
        for (int i = 0; i < f.dimensions; i++) {
            w.moved[i].array[DPHASE] = NULL;
        }
    }
}

/* What is kept of a grid. Its rows are padded to whole blocks unless that adds more than a third,
   which takes as much time as is won (Zen 4). Octaves that bend take points, and so does the
   deepest warp if it has no passes along rows. */
static enum keep keep_of_grid(const struct scarp_call_plan *plan, const struct scarp_grid *grid)
{
    const struct scarp_call_plan *const of_level = plan->warps.levels->plan;
    int rows = 3 * whole_blocks(grid->count[0]) <= 4 * grid->count[0] &&
               !has_no_rows(&of_level[plan->warps.depth]);
    for (int level = 0; level < plan->warps.depth; level++) {
        rows &= !fractal_bends(of_level[level].fractal);
    }
    return rows ? KEEP_ROWS : KEEP_SAMPLES;
}

/* Computes a grid of a noise with warps, slice by slice in chunks of some rows. */
static __attribute__((noinline)) void warp_grid(const struct scarp_call_plan *plan,
                                                const struct scarp_grid *grid,
                                                const struct scarp_outputs *out, int dimensions)
{
    vf space[CHUNK_BYTES / sizeof(vf)];
    const struct workspace work = {space, sizeof space / sizeof(vf)};
    const struct frame f = {.layout = DOUBLES, .dimensions = dimensions};
    const enum keep keep = keep_of_grid(plan, grid);
    struct warped w = {.chunked = {.source = {NULL, grid}, .f = f, .keep = keep}};
    struct chunk c = {{0, 0, 0}, 0, 0, 0};
    warped_begin(&w, plan, work);
    const size_t most = least(w.chunked.most, CHUNK_COLUMNS);
    const size_t columns =
        keep == KEEP_ROWS ? whole_blocks(piece(grid->count[0], most)) : least(grid->count[0], most);
    const size_t rows = least(w.chunked.most / columns, CHUNK_ROWS);
    for (c.at[2] = 0; c.at[2] < (dimensions == 3 ? grid->count[2] : 1); c.at[2]++) {
        for (c.at[1] = 0; c.at[1] < grid->count[1]; c.at[1] += c.rows) {
            c.rows = least(grid->count[1] - c.at[1], rows);
            for (c.at[0] = 0; c.at[0] < grid->count[0]; c.at[0] += c.columns) {
                c.columns = least(grid->count[0] - c.at[0], columns);
                c.pitch = keep == KEEP_ROWS ? whole_blocks(c.columns) : c.columns;
                warp_chunk(&w, out, &c,
                           c.at[2] * grid->slice_stride + c.at[1] * grid->row_stride + c.at[0],
                           grid->row_stride);
            }
        }
    }
}

#endif
