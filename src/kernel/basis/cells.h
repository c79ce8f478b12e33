/* SPDX-License-Identifier: MIT
 *
 * Cellular noise (Worley 1996) with gradient and Hessian: features of cells, the search for the
 * nearest two, and what the noise makes of them. The reference is formulas/cells.h, which has the
 * formulas.
 *
 *     feature_i = c_i + 1/2 + jitter v_i / 2^32,   d = p - feature,   s = d.d
 */
#ifndef SCARP_KERNEL_BASIS_CELLS_H
#define SCARP_KERNEL_BASIS_CELLS_H

#include "../sample.h"
#include "../unhashed.h"

/* What a cell draws besides v_0, which is its hash. */
#define FEATURE_Y 0xe41130e9u
#define FEATURE_Z 0x6ecea30du
#define FEATURE_ID 0xc603dc87u

/* Further than any search ends. */
#define FAR_AWAY 64.0f

/* Below these, a point lies on the feature; V^2 counts as 0. */
#define NO_DISTANCE 0x1p-80f
#define NO_SUM 0x1p-120f

/* What is searched for; a constant wherever it is passed on. */
struct search {
    int dimensions;
    int second; /* the second nearest, too */
    int steps;  /* the way from the features */
    int cells;  /* the hash of the nearest one's cell */
};

/* The features that are nearest: squares of distances, the ways from them, the hash. What a search
   is not for is unset. */
struct found {
    vf s[2], d[2][3];
    vf hash;
};

/* A feature, d from there. */
struct feature {
    vf d[3], s;
    vu hash;
};

/* Where a point lies from the feature of a cell; `middle` is that of the cell. */
VEC_INLINE vf feature_step(vf t, vf middle, vf jitter, vu drawn)
{
    return t - (middle + jitter * vf_from_vi((vi)drawn));
}

VEC_INLINE struct feature feature_at(const vf t[3], const vf middle[3], vf jitter, vu hash,
                                     int dimensions)
{
    struct feature f;
    f.hash = hash;
    f.d[0] = feature_step(t[0], middle[0], jitter, hash);
    f.d[1] = feature_step(t[1], middle[1], jitter, hash * FEATURE_Y);
    vf across = f.d[1] * f.d[1];
    if (dimensions == 3) {
        f.d[2] = feature_step(t[2], middle[2], jitter, hash * FEATURE_Z);
        across += f.d[2] * f.d[2];
    }
    f.s = f.d[0] * f.d[0] + across;
    return f;
}

/* 0, or NaN where a fraction is NaN, which comparisons would pass over. */
VEC_INLINE vf zero_at(const vf t[3], int dimensions)
{
    return 0.0f * (dimensions == 3 ? t[0] + (t[1] + t[2]) : t[0] + t[1]);
}

VEC_INLINE void found_begin(struct found *f, vf zero)
{
    const vf far = FAR_AWAY + zero;
    for (int i = 0; i < 2; i++) {
        f->s[i] = far;
        for (int axis = 0; axis < 3; axis++) {
            f->d[i][axis] = far;
        }
    }
    f->hash = vf_set(0.0f);
}

/* Takes a feature that is strictly nearer than what is there. */
VEC_INLINE void found_add(struct found *to, const struct feature *f, struct search search)
{
    const vm first = vm_less(f->s, to->s[0]);
    if (search.second) {
        const vm second = vm_less(f->s, to->s[1]);
        for (int i = 0; i < (search.steps ? search.dimensions : 0); i++) {
            to->d[1][i] = vm_choose(first, to->d[0][i], vm_choose(second, f->d[i], to->d[1][i]));
        }
        to->s[1] = vf_lesser(vf_greater(f->s, to->s[0]), to->s[1]);
    }
    for (int i = 0; i < (search.steps ? search.dimensions : 0); i++) {
        to->d[0][i] = vm_choose(first, f->d[i], to->d[0][i]);
    }
    if (search.cells) {
        to->hash = vm_choose(first, (vf)f->hash, to->hash);
    }
    to->s[0] = vf_lesser(f->s, to->s[0]);
}

/* What soft noise adds up before the root; the gradient without the factor 8, the Hessian too. */
VEC_INLINE void soft_add(struct sample *sum, const struct feature *f, struct variant v)
{
    const vf a = vf_positive(1.0f - f->s);
    const vf a2 = a * a, a4 = a2 * a2;
    const vf x = f->d[0], y = f->d[1], z = v.dimensions == 3 ? f->d[2] : f->d[1];
    sum->value += a4 * a4;
    if (v.order >= 1) {
        const vf a6 = a4 * a2, a7 = a6 * a;
        sum->dx += a7 * x;
        sum->dy += a7 * y;
        if (v.dimensions == 3) {
            sum->dz += a7 * z;
        }
        if (v.order >= 2) {
            const vf bend = 14.0f * a6;
            sum->dxx += bend * x * x - a7;
            sum->dxy += bend * x * y;
            sum->dyy += bend * y * y - a7;
            if (v.dimensions == 3) {
                sum->dxz += bend * x * z;
                sum->dyz += bend * y * z;
                sum->dzz += bend * z * z - a7;
            }
        }
    }
}

/* What is done with features: they are searched, or added up where `sum` is not NULL. */
struct cells_task {
    struct search search;
    struct variant soft;
};

/* The three cells of a line along x. */
VEC_INLINE void cells_line(struct found *found, struct sample *sum, const vf t[3], vf middle[3],
                           const vu x[3], vu yz, vf jitter, const struct cells_task *task)
{
    for (int i = 0; i < 3; i++) {
        middle[0] = vf_set((float)i - 0.5f);
        const struct feature f =
            feature_at(t, middle, jitter, hash_corner(x[i], yz), task->search.dimensions);
        if (sum == NULL) {
            found_add(found, &f, task->search);
        } else {
            soft_add(sum, &f, task->soft);
        }
    }
}

/* Visits the 3^n cells around that of a point. Loops across x stay loops: unrolled, their code
   would fill the first-level cache. */
VEC_INLINE void cells_around(struct found *found, struct sample *sum, const vf *location,
                             const struct scarp_octave *o, const struct cells_task *task)
{
    const int dimensions = task->search.dimensions;
    const vf jitter = vf_set(o->jitter);
    vf t[3], middle[3];
    vu mixed[3][3];
    for (int i = 0; i < dimensions; i++) {
        t[i] = location[i];
        mixed_beside(mixed[i], (vu)location[dimensions + i], o, i);
    }
    if (dimensions == 2) {
        middle[1] = vf_set(-0.5f);
        VEC_ROLLED_LOOP
        for (int y = 0; y < 3; y++) {
            cells_line(found, sum, t, middle, mixed[0], mixed[1][y], jitter, task);
            middle[1] += 1.0f;
        }
        return;
    }
    middle[2] = vf_set(-0.5f);
    VEC_ROLLED_LOOP
    for (int z = 0; z < 3; z++) {
        middle[1] = vf_set(-0.5f);
        VEC_ROLLED_LOOP
        for (int y = 0; y < 3; y++) {
            cells_line(found, sum, t, middle, mixed[0], mixed[1][y] ^ mixed[2][z], jitter, task);
            middle[1] += 1.0f;
        }
        middle[2] += 1.0f;
    }
}

/* How much nearer a feature must be for certain before it is left out. */
#define RING_MARGIN (1.0f + 0x1p-18f)

/* How far a feature strays at most, and what is left between its box and the wall of its cell. */
VEC_INLINE float feature_margin(const struct scarp_octave *o)
{
    return 0.5f - o->jitter * 0x1p31f;
}

/* How far the boxes of features two cells off are at least, from a wall of the cell between. */
VEC_INLINE vf ring_distance(const struct scarp_octave *o)
{
    return vf_set(1.0f + feature_margin(o));
}

/* The distance of a fraction from the nearer wall of the cell. */
VEC_INLINE vf to_wall(vf t)
{
    return vf_lesser(t, 1.0f - t);
}

/* Whether some feature two cells off may be nearer than s; `wall` is the nearest of all axes. */
VEC_INLINE int needs_ring(vf s, vf wall, vf distance)
{
    const vf bound = wall + distance;
    return vm_any(vm_less(bound * bound, s * RING_MARGIN));
}

/* What the ring of cells two steps away, and those inside, have along an axis. */
struct ring_axis {
    vu mixed[5];
    vf nearest[4]; /* squares: features cannot be nearer along the axis; without the own cell */
};

static void ring_axis_of(struct ring_axis *ring, vf t, vu cell, const struct scarp_octave *o,
                         int axis)
{
    const vf margin = vf_set(feature_margin(o));
    const vu last = vu_set(o->last[axis]), period = last + 1;
    vu number = cell;
    for (int i = 0; i < 2; i++) {
        number += ((vu)(number == 0) & period) - 1;
    }
    for (int i = 0; i < 5; i++) {
        const vu mixed = number * vu_set(hash_multiplier[axis]) + vu_set(o->key[axis]);
        const float from = (float)(i - 2);
        ring->mixed[i] = vu_turn8(mixed);
        const vf left = from - t, right = t - (from + 1.0f); /* of the cell; one is above 0 */
        const vf gap = vf_positive(vf_greater(left, right) + margin);
        if (i != 2) {
            ring->nearest[i > 2 ? i - 1 : i] = gap * gap;
        }
        number += 1 - ((vu)(number == last) & period);
    }
}

/* What a ring has along all axes, and which of its walls a feature can be behind, as bits: the
   first and the last number along an axis. */
struct ring {
    struct ring_axis axis[3];
    vf t[3], limit;
    float jitter[3];
    unsigned open[3];
    int has[3]; /* whether there is that axis */
};

static void ring_begin(struct ring *ring, const vf *t, const vf *cell, const struct scarp_octave *o,
                       int dimensions, vf farthest)
{
    static const struct ring_axis none; /* in 2D, all features are in the plane */
    ring->limit = farthest * RING_MARGIN;
    for (int i = 0; i < 3; i++) {
        struct ring_axis *const axis = &ring->axis[i];
        ring->has[i] = i < dimensions;
        ring->open[i] = 0;
        if (i < dimensions) {
            ring->t[i] = t[i];
            ring->jitter[i] = o->jitter;
            ring_axis_of(axis, t[i], (vu)cell[i], o, i);
            ring->open[i] = (vm_any(vm_less(axis->nearest[0], ring->limit)) ? 1u : 0u) |
                            (vm_any(vm_less(axis->nearest[3], ring->limit)) ? 1u << 4 : 0u);
        } else {
            ring->t[i] = vf_set(0.0f);
            ring->jitter[i] = 0.0f;
            *axis = none;
        }
    }
}

/* Takes the feature of a cell, unless no lane needs it. */
VEC_INLINE vf ring_nearest(const struct ring_axis *axis, int at)
{
    return at == 2 ? vf_set(0.0f) : axis->nearest[at > 2 ? at - 1 : at];
}

VEC_INLINE void ring_add(struct found *found, const struct ring *ring, const int at[3])
{
    const struct search all = {.dimensions = 3, .second = 1, .steps = 1, .cells = 1};
    struct feature f;
    const struct ring_axis *const axis = ring->axis;
    const vf nearest = ring_nearest(&axis[0], at[0]) +
                       (ring_nearest(&axis[1], at[1]) + ring_nearest(&axis[2], at[2]));
    if (!vm_any(vm_less(nearest, ring->limit))) {
        return;
    }
    f.hash = hash_corner(axis[0].mixed[at[0]], axis[1].mixed[at[1]] ^ axis[2].mixed[at[2]]);
    const vu drawn[3] = {f.hash, f.hash * FEATURE_Y, f.hash * FEATURE_Z};
    for (int i = 0; i < 3; i++) {
        const vf middle = vf_set(ring->has[i] ? (float)at[i] - 1.5f : 0.0f);
        f.d[i] = feature_step(ring->t[i], middle, vf_set(ring->jitter[i]), drawn[i]);
    }
    f.s = f.d[0] * f.d[0] + (f.d[1] * f.d[1] + f.d[2] * f.d[2]);
    found_add(found, &f, all);
}

/* Searches the cells two steps away, but for those that no lane needs. Few blocks come here. `t`
   are the fractions and `cell` the cells along all axes. */
static __attribute__((noinline)) void cells_ring(struct found *found, const vf *t, const vf *cell,
                                                 const struct scarp_octave *o, int dimensions,
                                                 int second)
{
    const unsigned inside = 0xe;
    struct ring ring;
    ring_begin(&ring, t, cell, o, dimensions, found->s[second]);
    const unsigned xs = ring.open[0] | inside, ys = ring.open[1] | inside;
    const unsigned zs = dimensions == 3 ? ring.open[2] | inside : 1;
    const int lines = dimensions == 3 ? 25 : 5; /* of cells along x */
    for (int line = 0; line < lines; line++) {
        const int y = line % 5, z = line / 5;
        if ((ys >> y & zs >> z & 1) == 0) {
            continue;
        }
        const int is_beyond = (inside >> y & 1) == 0 || (dimensions == 3 && (inside >> z & 1) == 0);
        const unsigned along = is_beyond ? xs : ring.open[0];
        VEC_ROLLED_LOOP
        for (int x = 0; x < 5; x++) {
            if ((along >> x & 1) != 0) {
                const int at[3] = {x, y, z};
                ring_add(found, &ring, at);
            }
        }
    }
}

/* Searches the ring if a lane needs it. */
VEC_INLINE void cells_beyond(struct found *found, const vf *t, const vf *cell,
                             const struct scarp_octave *o, struct search search)
{
    vf wall = to_wall(t[0]);
    for (int i = 1; i < search.dimensions; i++) {
        wall = vf_lesser(wall, to_wall(t[i]));
    }
    if (__builtin_expect(needs_ring(found->s[search.second], wall, ring_distance(o)), 0)) {
        struct found copy = *found; /* so that the original stays in registers */
        cells_ring(&copy, t, cell, o, search.dimensions, search.second);
        *found = copy;
    }
}

/* Searches for the nearest of all features. */
VEC_INLINE struct found cells_search(const vf *location, const struct scarp_octave *o,
                                     struct search search)
{
    const struct cells_task task = {.search = search};
    struct found found;
    found_begin(&found, zero_at(location, search.dimensions));
    cells_around(&found, NULL, location, o, &task);
    cells_beyond(&found, location, location + search.dimensions, o, search);
    return found;
}

/* The distance from a feature. */
VEC_INLINE struct sample distance_to(vf square, const vf d[3], struct variant v)
{
    const vf distance = vf_sqrt(square);
    struct sample s;
    s.value = distance;
    if (v.order >= 1) {
        const vm none = vm_less(square, vf_set(NO_DISTANCE * (1.0f + FLT_EPSILON)));
        const vf r = vm_choose(none, vf_set(0.0f), 1.0f / distance);
        const vf x = d[0] * r, y = d[1] * r, z = v.dimensions == 3 ? d[2] * r : y;
        s.dx = x;
        s.dy = y;
        s.dz = z;
        if (v.order >= 2) {
            s.dxx = r * (1.0f - x * x);
            s.dxy = -(r * (x * y));
            s.dyy = r * (1.0f - y * y);
            if (v.dimensions == 3) {
                s.dxz = -(r * (x * z));
                s.dyz = -(r * (y * z));
                s.dzz = r * (1.0f - z * z);
            }
        }
    }
    return s;
}

/* The distance from the nearest feature or the second, or the second less the first. */
VEC_INLINE struct sample distance_of(const struct found *f, enum scarp_basis basis, vf middle,
                                     struct variant v)
{
    if (basis == SCARP_CELL_F1) {
        struct sample s = distance_to(f->s[0], f->d[0], v);
        s.value -= middle;
        return s;
    }
    struct sample s = distance_to(f->s[1], f->d[1], v);
    if (basis == SCARP_CELL_EDGE) {
        const struct sample first = distance_to(f->s[0], f->d[0], v);
#define LESS(i, member, rank) s.member -= first.member
        EACH_OUTPUT(v, LESS);
#undef LESS
    }
    s.value -= middle;
    return s;
}

/* Each cell's own value, in units of 2^-31; all derivatives are 0. */
VEC_INLINE struct sample cell_value(const struct found *f, struct variant v)
{
    const vf zero = 0.0f * f->s[0]; /* or NaN */
    struct sample s;
#define ZERO(i, member, rank) s.member = zero
    EACH_OUTPUT(v, ZERO);
#undef ZERO
    s.value = vf_from_vi((vi)((vu)f->hash * FEATURE_ID)) + zero;
    return s;
}

/* -V, from its sums. */
VEC_INLINE struct sample soft_root(const struct sample *sum, vf middle, struct variant v)
{
    const vf root = vf_sqrt(sum->value);
    struct sample s;
    s.value = middle - root;
    if (v.order >= 1) {
        const vm none = vm_less(sum->value, vf_set(NO_SUM * (1.0f + FLT_EPSILON)));
        const vf r = vm_choose(none, vf_set(0.0f), 8.0f / root);
        const vf x = r * sum->dx, y = r * sum->dy, z = v.dimensions == 3 ? r * sum->dz : y;
        s.dx = x;
        s.dy = y;
        s.dz = z;
        if (v.order >= 2) {
            const vf q = 0.125f * r;
            s.dxx = q * (x * x) - r * sum->dxx;
            s.dxy = q * (x * y) - r * sum->dxy;
            s.dyy = q * (y * y) - r * sum->dyy;
            if (v.dimensions == 3) {
                s.dxz = q * (x * z) - r * sum->dxz;
                s.dyz = q * (y * z) - r * sum->dyz;
                s.dzz = q * (z * z) - r * sum->dzz;
            }
        }
    }
    return s;
}

VEC_INLINE struct sample soft_sample(const vf *location, const struct scarp_octave *o,
                                     struct variant v)
{
    const struct cells_task task = {.search = {.dimensions = v.dimensions}, .soft = v};
    const vf zero = zero_at(location, v.dimensions);
    struct found unused;
    struct sample sum;
#define BEGIN(i, member, rank) sum.member = zero
    EACH_OUTPUT(v, BEGIN);
#undef BEGIN
    cells_around(&unused, &sum, location, o, &task);
    return soft_root(&sum, vf_set(o->middle), v);
}

#endif
