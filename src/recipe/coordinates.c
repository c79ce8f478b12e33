/* SPDX-License-Identifier: MIT
 *
 * Coordinates of places. Along a row of a grid, x is a ramp, which is computed once for all rows, and
 * y and z are numbers. All have the bits that points have.
 */
#include <string.h>

#include "graph.h"
#include "machine.h"

#define BLOCK 16 /* points */
#define RAMP 64

static double coordinate(const struct scarp_grid *grid, int axis, size_t index)
{
    return grid->origin[axis] + (double)(grid->first[axis] + (int64_t)index) * grid->step[axis];
}

/* The coordinates x of a part of a row. Numbers of samples are exact, so they may be added in
   parts. */
static void find_ramp(const struct scarp_grid *grid, size_t first, double x[RAMP])
{
    const double origin = grid->origin[0], step = grid->step[0];
    const double number = (double)(grid->first[0] + (int64_t)first);
    for (int i = 0; i < RAMP; i++) {
        x[i] = origin + (number + (double)i) * step;
    }
}

/* A coordinate of a place that is m x + t; `k` NULL: one of the points themselves. */
struct map {
    const double *k;
    double t;
    int axis, is_space;
};

/* A block of a row, whose y and z are given. */
static void find_block(const struct map *map, const double x[BLOCK], double y, double z,
                       double u[BLOCK])
{
    if (map->k == NULL) {
        for (int i = 0; i < BLOCK; i++) {
            u[i] = map->axis == 0 ? x[i] : map->axis == 1 ? y : z;
        }
        return;
    }
    const double k = map->k[0], ky = map->k[1] * y, kz = map->k[2] * z, t = map->t;
    if (map->is_space) {
        for (int i = 0; i < BLOCK; i++) {
            u[i] = k * x[i] + ky + kz + t;
        }
    } else {
        for (int i = 0; i < BLOCK; i++) {
            u[i] = k * x[i] + ky + t;
        }
    }
}

/* Computes a coordinate of the samples of a grid, as floats or, if `floats` is NULL, as doubles. */
static void along_rows(const struct scarp_grid *g, const struct map *map, float *floats,
                       double *doubles)
{
    const size_t rows = g->count[1] * (map->is_space ? g->count[2] : 1);
    double x[RAMP], u[BLOCK];
    float v[BLOCK];
    for (size_t at = 0; at < g->count[0]; at += RAMP) {
        const size_t count = g->count[0] - at < RAMP ? g->count[0] - at : RAMP;
        find_ramp(g, at, x);
        for (size_t i = 0; i < rows * ((count + BLOCK - 1) / BLOCK); i++) {
            const size_t row = i % rows, from = i / rows * BLOCK;
            const size_t left = count - from < BLOCK ? count - from : BLOCK;
            const size_t to = row * g->count[0] + at + from;
            const double y = coordinate(g, 1, row % g->count[1]);
            const double z = map->is_space ? coordinate(g, 2, row / g->count[1]) : 0.0;
            find_block(map, x + from, y, z, u);
            if (floats == NULL) {
                memcpy(doubles + to, u, left * sizeof *u);
                continue;
            }
            for (int k = 0; k < BLOCK; k++) {
                v[k] = (float)u[k];
            }
            memcpy(floats + to, v, left * sizeof *v);
        }
    }
}

static struct map map_of(const struct recipe_machine *m, int place, int axis)
{
    const struct recipe_place *const p = &m->recipe->place[place];
    return (struct map){.k = place == 0 ? NULL : p->m[axis],
                        .t = p->t[axis],
                        .axis = axis,
                        .is_space = m->recipe->dimensions == 3};
}

void scarpi_recipe_set_coordinate(const struct recipe_machine *m, int place, int axis, float *to)
{
    const struct map map = map_of(m, place, axis);
    if (m->chunk->grid != NULL) {
        along_rows(m->chunk->grid, &map, to, NULL);
        return;
    }
    const double *const x = m->chunk->at[0], *const y = m->chunk->at[1], *const z = m->chunk->at[2];
    const double *const own = m->chunk->at[axis];
    for (size_t i = 0; i < m->chunk->count; i++) {
        const double sum = map.k != NULL ? map.k[0] * x[i] + map.k[1] * y[i] : 0.0;
        to[i] =
            (float)(map.k == NULL ? own[i] : (map.is_space ? sum + map.k[2] * z[i] : sum) + map.t);
    }
}

/* Coordinates of the points, in arrays of the machine. */
static void spread(const struct recipe_machine *m)
{
    const size_t bytes = m->chunk->count * (m->has_doubles ? sizeof(double) : sizeof(float));
    for (int i = 0; i < m->recipe->dimensions; i++) {
        memcpy(m->position[i], m->chunk->at[i], bytes);
    }
}

/* Both loops are the same, in double and in float. */
#define TRANSFORM(type)                                                                            \
    static void transform_##type(const struct recipe_machine *m, const struct recipe_place *p,     \
                                 int from)                                                         \
    {                                                                                              \
        type *const x = m->position[0], *const y = m->position[1], *const z = m->position[2];      \
        type k[3][3], t[3];                                                                        \
        for (int i = 0; i < 3; i++) {                                                              \
            for (int j = 0; j < 3; j++) {                                                          \
                k[i][j] = (type)p->m[i][j];                                                        \
            }                                                                                      \
            t[i] = (type)p->t[i];                                                                  \
        }                                                                                          \
        for (size_t i = 0; i < m->chunk->count; i++) {                                             \
            const type a = x[i], b = y[i];                                                         \
            if (from == 3) {                                                                       \
                const type c = z[i];                                                               \
                x[i] = k[0][0] * a + k[0][1] * b + k[0][2] * c + t[0];                             \
                y[i] = k[1][0] * a + k[1][1] * b + k[1][2] * c + t[1];                             \
                z[i] = k[2][0] * a + k[2][1] * b + k[2][2] * c + t[2];                             \
            } else {                                                                               \
                x[i] = k[0][0] * a + k[0][1] * b + t[0];                                           \
                y[i] = k[1][0] * a + k[1][1] * b + t[1];                                           \
            }                                                                                      \
        }                                                                                          \
    }                                                                                              \
    static void displace_##type(type *u, const float *rest, size_t count)                          \
    {                                                                                              \
        for (size_t i = 0; i < count; i++) {                                                       \
            u[i] += (type)rest[i];                                                                 \
        }                                                                                          \
    }

TRANSFORM(double)
TRANSFORM(float)

/* The coordinates of a place without its rests: m x + t. */
static void find_mapped(const struct recipe_machine *m, int place)
{
    const struct recipe_place *const p = &m->recipe->place[place];
    if (p->frame < 0 && m->chunk->grid != NULL) {
        for (int i = 0; i < p->dimensions; i++) {
            const struct map map = map_of(m, place, i);
            along_rows(m->chunk->grid, &map, NULL, m->position[i]);
        }
        return;
    }
    if (p->frame < 0) {
        spread(m);
    } else {
        scarpi_recipe_find_positions(m, p->frame);
    }
    const int from = scarpi_recipe_frame_dimensions(m->recipe, p->frame);
    if (place != 0 && m->has_doubles) {
        transform_double(m, p, from);
    } else if (place != 0) {
        transform_float(m, p, from);
    }
}

void scarpi_recipe_find_positions(const struct recipe_machine *m, int place)
{
    const struct recipe_place *const p = &m->recipe->place[place];
    find_mapped(m, place);
    for (int i = 0; i < p->dimensions; i++) {
        if (p->rest[i] >= 0) {
            const float *const rest = scarpi_recipe_samples(m, p->rest[i]).value;
            if (m->has_doubles) {
                displace_double(m->position[i], rest, m->chunk->count);
            } else {
                displace_float(m->position[i], rest, m->chunk->count);
            }
        }
    }
}
