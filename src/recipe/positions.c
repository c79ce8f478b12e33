/* SPDX-License-Identifier: MIT
 *
 * Nodes that have a place: noise, cells, gullies, coordinates. Derivatives by the coordinates of the
 * place, u, become derivatives by those of the frame, x, with the Jacobian J = m + grad rest:
 *
 *     gradient J^T g,   Hessian J^T H J + sum_k g_k (Hessian of rest_k)
 */
#include <string.h>

#include "graph.h"
#include "machine.h"
#include "plans.h"

#define BLOCK 64 /* points */

/* The second derivative with respect to axes i <= j, as members of struct scarp_samples are in
   order. */
static float *second(const struct scarp_samples *s, int i, int j)
{
    float *const all[3][3] = {
        {s->dxx, s->dxy, s->dxz}, {s->dxy, s->dyy, s->dyz}, {s->dxz, s->dyz, s->dzz}};
    return all[i][j];
}

static float *first(const struct scarp_samples *s, int i)
{
    return i == 0 ? s->dx : i == 1 ? s->dy : s->dz;
}

/* Whether the coordinates of a place are those of the points, in every bit. */
static bool is_points(int place)
{
    return place == 0;
}

/* What is known of a place for the chain rule. */
struct jacobian {
    const struct recipe_place *place;
    int from, to; /* dimensions of u and of x */
    int order;
    struct scarp_samples rest[3];
};

static void pull_block(const struct jacobian *by, size_t at, size_t count,
                       const struct scarp_samples *in, const struct scarp_samples *out)
{
    float j[3][3][BLOCK], g[3][BLOCK], r[9][BLOCK];
    for (int k = 0; k < by->from; k++) {
        for (int i = 0; i < by->to; i++) {
            const float m = (float)by->place->m[k][i];
            const float *const rest = by->place->rest[k] >= 0 ? first(&by->rest[k], i) : NULL;
            for (size_t n = 0; n < count; n++) {
                j[k][i][n] = rest != NULL ? m + rest[at + n] : m;
            }
        }
        memcpy(g[k], first(in, k) + at, count * sizeof(float));
    }
    for (int i = 0; i < by->to; i++) {
        for (size_t n = 0; n < count; n++) {
            r[i][n] = by->from == 3
                          ? j[0][i][n] * g[0][n] + j[1][i][n] * g[1][n] + j[2][i][n] * g[2][n]
                          : j[0][i][n] * g[0][n] + j[1][i][n] * g[1][n];
        }
    }
    int seconds = 3;
    for (int a = 0; a < by->to && by->order == 2; a++) {
        for (int b = a; b < by->to; b++, seconds++) {
            float *const sum = r[seconds];
            memset(sum, 0, count * sizeof *sum);
            for (int k = 0; k < by->from; k++) {
                for (int l = 0; l < by->from; l++) {
                    const float *const h = second(in, k, l) + at;
                    for (size_t n = 0; n < count; n++) {
                        sum[n] += j[k][a][n] * (h[n] * j[l][b][n]);
                    }
                }
                const float *const rest =
                    by->place->rest[k] >= 0 ? second(&by->rest[k], a, b) : NULL;
                for (size_t n = 0; rest != NULL && n < count; n++) {
                    sum[n] += g[k][n] * rest[at + n];
                }
            }
        }
    }
    seconds = 3;
    for (int a = 0; a < by->to; a++) {
        memcpy(first(out, a) + at, r[a], count * sizeof(float));
        for (int b = a; b < by->to && by->order == 2; b++, seconds++) {
            memcpy(second(out, a, b) + at, r[seconds], count * sizeof(float));
        }
    }
}

/* Brings derivatives from the coordinates of a place to those of its frame. `in` and `out` may be
   the same. */
static void pull(const struct recipe_machine *m, int place, int order,
                 const struct scarp_samples *in, const struct scarp_samples *out)
{
    struct jacobian by = {.place = &m->recipe->place[place], .order = order};
    by.from = by.place->dimensions;
    by.to = scarpi_recipe_frame_dimensions(m->recipe, by.place->frame);
    for (int k = 0; k < by.from; k++) {
        if (by.place->rest[k] >= 0) {
            by.rest[k] = scarpi_recipe_samples(m, by.place->rest[k]);
        }
    }
    for (size_t at = 0; order > 0 && at < m->chunk->count; at += BLOCK) {
        const size_t left = m->chunk->count - at;
        pull_block(&by, at, left < BLOCK ? left : BLOCK, in, out);
    }
}

/* Leaves the arrays of a node that a call in so many dimensions may write. */
static void keep_dimensions(struct scarp_samples *s, int dimensions)
{
    if (dimensions == 2) {
        s->dz = s->dxz = s->dyz = s->dzz = NULL;
    }
}

/* Where the points of a call are: of a place. */
struct points {
    size_t count;
    const void *at[3];
};

static void find_points(const struct recipe_machine *m, int place, struct points *p)
{
    const bool is_given = is_points(place) && m->chunk->grid == NULL;
    p->count = m->chunk->count;
    if (!is_given) {
        scarpi_recipe_find_positions(m, place);
    }
    for (int i = 0; i < 3; i++) {
        p->at[i] = is_given ? m->chunk->at[i] : m->position[i];
    }
}

/* The noise that a node samples, with its warps, and the plans that there are. */
static const struct scarp_noise *noise_of(struct recipe_machine *m, const struct recipe_node *n)
{
    scarpi_recipe_spell_noise(m->recipe, n->index, m->noise);
    scarpi_recipe_bring_plans(m->plan, m->recipe, n->index, m->recipe->place[n->place].dimensions,
                              n->operation == OP_VECTOR, m->noise);
    return m->noise;
}

/* The axes of the grid that are the coordinates of a place of the plane in space, as bits; 0: they
   are something else. */
static int axes_of_plane(const struct recipe *recipe, int place)
{
    const struct recipe_place *const p = &recipe->place[place];
    int axes = 0;
    if (recipe->dimensions != 3 || p->dimensions != 2 || p->frame >= 0) {
        return 0;
    }
    for (int i = 0; i < 2; i++) {
        int axis = 0, others = 0;
        for (int j = 0; j < 3; j++) {
            axis = p->m[i][j] == 1.0 ? j : axis;
            others += p->m[i][j] != 0.0;
        }
        if (others != 1 || p->m[i][axis] != 1.0 || p->t[i] != 0.0 || p->rest[i] >= 0 ||
            axes >> axis != 0) {
            return 0;
        }
        axes |= 1 << axis;
    }
    return axes;
}

/* The grid of a plane in a grid of space that is one sample thick. */
static struct scarp_grid plane_of(const struct scarp_grid *grid, int axes)
{
    struct scarp_grid plane = {.row_stride = 0};
    for (int i = 0, to = 0; i < 3; i++) {
        if ((axes >> i & 1) != 0) {
            plane.origin[to] = grid->origin[i];
            plane.step[to] = grid->step[i];
            plane.first[to] = grid->first[i];
            plane.count[to++] = grid->count[i];
        }
    }
    return plane;
}

bool scarpi_recipe_needs_positions(const struct recipe_machine *m, int node, bool is_grid)
{
    const struct recipe_node *const n = &m->recipe->node[node];
    switch (n->operation) {
    case OP_NOISE:
        return !is_points(n->place) && !(m->has_parts && axes_of_plane(m->recipe, n->place) != 0);
    case OP_GULLIES: return !is_points(n->place);
    case OP_VECTOR:
    case OP_CELL: return !is_points(n->place) || is_grid;
    case OP_COORDINATE: {
        const struct recipe_place *const p = &m->recipe->place[n->place];
        const bool is_plain = is_points(n->place) && !is_grid;
        return !is_plain && !(m->has_doubles && p->frame < 0 && p->rest[n->detail] < 0);
    }
    default: return false;
    }
}

static enum scarp_status run_noise(struct recipe_machine *m, const struct recipe_node *n,
                                   const struct scarp_samples *out)
{
    const struct scarp_noise *const noise = noise_of(m, n);
    const int dimensions = m->recipe->place[n->place].dimensions;
    if (is_points(n->place) && m->chunk->grid != NULL) {
        return dimensions == 2 ? scarp_grid2(noise, m->chunk->grid, out)
                               : scarp_grid3(noise, m->chunk->grid, out);
    }
    const int axes = m->has_parts ? axes_of_plane(m->recipe, n->place) : 0;
    if (axes != 0) {
        const struct scarp_grid plane = plane_of(m->chunk->grid, axes);
        return scarp_grid2(noise, &plane, out);
    }
    struct points p;
    find_points(m, n->place, &p);
    if (m->has_doubles) {
        return dimensions == 2 ? scarp_sample2_f64(noise, p.count, p.at[0], p.at[1], out)
                               : scarp_sample3_f64(noise, p.count, p.at[0], p.at[1], p.at[2], out);
    }
    return dimensions == 2 ? scarp_sample2(noise, p.count, p.at[0], p.at[1], out)
                           : scarp_sample3(noise, p.count, p.at[0], p.at[1], p.at[2], out);
}

enum scarp_status scarpi_recipe_run_noise(struct recipe_machine *m, int node,
                                          const struct scarp_samples *out)
{
    return run_noise(m, &m->recipe->node[node], out);
}

/* The nodes of the components that are computed; -1: not. */
static void find_components(const struct recipe_machine *m, int node, int component[3])
{
    component[0] = node;
    component[1] = component[2] = -1;
    for (int k = 0; k < m->schedule->steps; k++) {
        const int other = m->schedule->step[k];
        const struct recipe_node *const o = &m->recipe->node[other];
        if (o->operation == OP_COMPONENT && o->in[0] == node) {
            component[o->detail] = other;
        }
    }
}

static enum scarp_status run_vector(struct recipe_machine *m, int node)
{
    const struct recipe_node *const n = &m->recipe->node[node];
    const struct scarp_noise *const noise = noise_of(m, n);
    struct scarp_samples out[3] = {{0}}, all[3] = {{0}};
    int component[3];
    const int dimensions = m->recipe->place[n->place].dimensions;
    enum scarp_status status;
    find_components(m, node, component);
    for (int i = 0; i < dimensions; i++) {
        if (component[i] >= 0) {
            all[i] = scarpi_recipe_samples(m, component[i]);
            out[i] = all[i];
            keep_dimensions(&out[i], dimensions);
        }
    }
    struct points p;
    find_points(m, n->place, &p);
    if (m->has_doubles) {
        status = dimensions == 2
                     ? scarp_vector2_f64(noise, p.count, p.at[0], p.at[1], out)
                     : scarp_vector3_f64(noise, p.count, p.at[0], p.at[1], p.at[2], out);
    } else {
        status = dimensions == 2 ? scarp_vector2(noise, p.count, p.at[0], p.at[1], out)
                                 : scarp_vector3(noise, p.count, p.at[0], p.at[1], p.at[2], out);
    }
    const int is_pulled = status == SCARP_OK && !scarpi_recipe_is_frame(m->recipe, n->place);
    for (int i = 0; i < dimensions && is_pulled; i++) {
        if (component[i] >= 0) {
            pull(m, n->place, m->order_of[component[i]], &out[i], &all[i]);
        }
    }
    return status;
}

static void set_numbers(size_t count, float *array)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t id;
        memcpy(&id, &array[i], sizeof id);
        array[i] = (float)((double)(int32_t)id * 0x1p-31);
    }
}

static enum scarp_status run_cell(struct recipe_machine *m, const struct recipe_node *n,
                                  const struct scarp_samples *out)
{
    const struct scarp_noise *const noise = noise_of(m, n);
    const int dimensions = m->recipe->place[n->place].dimensions;
    struct scarp_cells to = {0};
    enum scarp_status status;
    if (n->detail == 0) {
        to.id = (uint32_t *)(void *)out->value;
    } else if (n->detail == 1) {
        to = (struct scarp_cells){.f1 = out->value, .dx1 = out->dx, .dy1 = out->dy, .dz1 = out->dz};
    } else {
        to = (struct scarp_cells){.f2 = out->value, .dx2 = out->dx, .dy2 = out->dy, .dz2 = out->dz};
    }
    struct points p;
    find_points(m, n->place, &p);
    if (m->has_doubles) {
        status = dimensions == 2 ? scarp_cells2_f64(noise, p.count, p.at[0], p.at[1], &to)
                                 : scarp_cells3_f64(noise, p.count, p.at[0], p.at[1], p.at[2], &to);
    } else {
        status = dimensions == 2 ? scarp_cells2(noise, p.count, p.at[0], p.at[1], &to)
                                 : scarp_cells3(noise, p.count, p.at[0], p.at[1], p.at[2], &to);
    }
    if (status == SCARP_OK && n->detail == 0) {
        set_numbers(p.count, out->value);
        for (int i = 0; i < 3; i++) {
            if (first(out, i) != NULL) {
                memset(first(out, i), 0, p.count * sizeof(float));
            }
            for (int j = i; j < 3; j++) {
                if (second(out, i, j) != NULL) {
                    memset(second(out, i, j), 0, p.count * sizeof(float));
                }
            }
        }
    }
    return status;
}

static enum scarp_status run_gullies(const struct recipe_machine *m, const struct recipe_node *n,
                                     const struct scarp_samples *out)
{
    const struct scarp_gullies *const g = &m->recipe->gully[n->index];
    const struct scarp_samples base = scarpi_recipe_samples(m, n->in[0]);
    const struct scarp_eroded to = {
        .displacement = out->value, .displacement_dx = out->dx, .displacement_dy = out->dy};
    if (is_points(n->place) && m->chunk->grid != NULL) {
        return scarp_gullies_grid2(g, m->chunk->grid, &base, &to);
    }
    struct points p;
    find_points(m, n->place, &p);
    return m->has_doubles ? scarp_gullies2_f64(g, p.count, p.at[0], p.at[1], &base, &to)
                          : scarp_gullies2(g, p.count, p.at[0], p.at[1], &base, &to);
}

static void run_coordinate(const struct recipe_machine *m, const struct recipe_node *n, int order,
                           const struct scarp_samples *out)
{
    const struct recipe_place *const place = &m->recipe->place[n->place];
    const int axis = n->detail, to = scarpi_recipe_frame_dimensions(m->recipe, place->frame);
    const size_t count = m->chunk->count;
    struct scarp_samples rest = {0};
    if (place->rest[axis] >= 0) {
        rest = scarpi_recipe_samples(m, place->rest[axis]);
    }
    if (m->has_doubles && place->frame < 0 && place->rest[axis] < 0) {
        scarpi_recipe_set_coordinate(m, n->place, axis, out->value);
    } else {
        struct points p;
        find_points(m, n->place, &p);
        for (size_t i = 0; i < count; i++) {
            out->value[i] = m->has_doubles ? (float)((const double *)p.at[axis])[i]
                                           : ((const float *)p.at[axis])[i];
        }
    }
    for (int a = 0; a < to && order > 0; a++) {
        const float slope = (float)place->m[axis][a];
        const float *const by = first(&rest, a);
        for (size_t i = 0; i < count; i++) {
            first(out, a)[i] = by != NULL ? slope + by[i] : slope;
        }
        for (int b = a; b < to && order > 1; b++) {
            const float *const of = second(&rest, a, b);
            for (size_t i = 0; i < count; i++) {
                second(out, a, b)[i] = of != NULL ? of[i] : 0.0f;
            }
        }
    }
}

enum scarp_status scarpi_recipe_run_placed(struct recipe_machine *m, int node)
{
    const struct recipe_node *const n = &m->recipe->node[node];
    struct scarp_samples all;
    const int order = m->order_of[node];
    const struct scarp_samples *out = &all;
    struct scarp_samples of_plane;
    scarpi_recipe_find_samples(m, node, &all);
    if (all.dz != NULL && m->recipe->place[n->place].dimensions == 2) {
        of_plane = all;
        keep_dimensions(&of_plane, 2);
        out = &of_plane;
    }
    enum scarp_status status;
    switch (n->operation) {
    case OP_COORDINATE: run_coordinate(m, n, order, &all); return SCARP_OK;
    case OP_VECTOR: return run_vector(m, node);
    case OP_GULLIES: return run_gullies(m, n, &all); /* which stand in a frame */
    case OP_PULL: {
        const struct scarp_samples in = scarpi_recipe_samples(m, n->in[0]);
        memcpy(all.value, in.value, m->chunk->count * sizeof(float));
        pull(m, n->place, order, &in, &all);
        return SCARP_OK;
    }
    case OP_CELL: status = run_cell(m, n, n->detail == 0 ? &all : out); break;
    default: status = run_noise(m, n, out); break;
    }
    if (status == SCARP_OK && order > 0 && !scarpi_recipe_is_frame(m->recipe, n->place) &&
        !(n->operation == OP_CELL && n->detail == 0)) {
        pull(m, n->place, order, out, &all);
    }
    return status;
}
