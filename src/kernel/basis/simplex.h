/* SPDX-License-Identifier: MIT
 *
 * Simplex noise (Perlin 2001, Gustavson 2005) with gradient and Hessian. The reference is
 * formulas/simplex.h, which has the formulas and describes the lattice.
 *
 *     n(p) = sum over vertices v of w^4 q,   w = max(0, r^2 - d.d),   q = g_v . d,   d = p - v
 *
 * In 2D, rows of vertices are sqrt(3) / 2 apart, and odd rows are shifted by half an edge. A point
 * lies in a rhombus that begins at vertex k of the row below, and there in the lower triangle or in
 * the upper one. Vertex 0 is that of the point's cell; k is -1 where the point lies before the edge
 * that goes up from vertex 0.
 *
 *     row y + 1          o-----------o
 *                       / \  upper  /
 *                      /   \       /
 *                     /     \     /
 *                    / lower \   /
 *     row y         o-----------o
 *                   k         k + 1
 */
#ifndef SCARP_KERNEL_BASIS_SIMPLEX_H
#define SCARP_KERNEL_BASIS_SIMPLEX_H

#include "../unhashed.h"
#include "gradient.h"

#define ROW_HEIGHT 0.866025404f /* of triangles of edge 1: sqrt(3) / 2 */
#define TRIANGLE_R2 0.75f
#define TETRAHEDRON_R2 (0.5f - 0x1p-21f)

/* Centres of cubes draw with another number than corners. */
#define HASH_CENTRE 0xbcfa3e4du

/* Where a point lies from a vertex, and the vertex's gradient. */
struct vertex {
    vf d[3], g[3];
};

/* What is left of r^2 across the x axis. */
VEC_INLINE vf vertex_left2(vf dy)
{
    return TRIANGLE_R2 - dy * dy;
}

VEC_INLINE vf vertex_left3(vf dy, vf dz)
{
    return TETRAHEDRON_R2 - (dy * dy + dz * dz);
}

/* g.d across the x axis. */
VEC_INLINE vf vertex_across(const struct vertex *at, struct variant v)
{
    return v.dimensions == 2 ? at->g[1] * at->d[1]
                             : vf_exact_fma(at->g[1], at->d[1], at->g[2] * at->d[2]);
}

/* g a + b. In 3D, components of gradients are 0 and +-2, and products with them exact. */
VEC_INLINE vf times_gradient(vf g, vf a, vf b, struct variant v)
{
    return v.dimensions == 2 ? g * a + b : vf_exact_fma(g, a, b);
}

/* What a vertex adds; `left` and `across` are as above. */
VEC_INLINE struct sample vertex_sample(const struct vertex *at, vf left, vf across,
                                       struct variant v)
{
    const vf x = at->d[0], y = at->d[1], gx = at->g[0], gy = at->g[1];
    const vf w = vf_positive(left - x * x);
    const vf q = times_gradient(gx, x, across, v);
    const vf w2 = w * w, w4 = w2 * w2;
    struct sample s;
    s.value = w4 * q;
    if (v.order >= 1) {
        const vf w3 = 8.0f * (w2 * w), wq = w3 * q;
        s.dx = times_gradient(gx, w4, -(wq * x), v);
        s.dy = times_gradient(gy, w4, -(wq * y), v);
        if (v.dimensions == 3) {
            s.dz = times_gradient(at->g[2], w4, -(wq * at->d[2]), v);
        }
        if (v.order >= 2) {
            const vf bend = 48.0f * w2 * q;
            s.dxx = bend * x * x - w3 * times_gradient(2.0f * gx, x, q, v);
            s.dyy = bend * y * y - w3 * times_gradient(2.0f * gy, y, q, v);
            s.dxy = bend * x * y - w3 * times_gradient(gx, y, gy * x, v);
            if (v.dimensions == 3) {
                const vf z = at->d[2], gz = at->g[2];
                s.dzz = bend * z * z - w3 * times_gradient(2.0f * gz, z, q, v);
                s.dxz = bend * x * z - w3 * times_gradient(gx, z, gz * x, v);
                s.dyz = bend * y * z - w3 * times_gradient(gy, z, gz * y, v);
            }
        }
    }
    return s;
}

VEC_INLINE struct sample sum_of(const struct sample *a, const struct sample *b, struct variant v)
{
    struct sample s;
#define ADD(i, member, rank) s.member = a->member + b->member
    EACH_OUTPUT(v, ADD);
#undef ADD
    return s;
}

/* Where a point lies in the triangles: whether it lies before the edge that goes up from vertex 0
   of its cell, the vector from vertex k of the row below, and whether its triangle is the lower
   one. */
struct triangle {
    vf x;
    vm before, lower;
};

/* `from` is where the point is from vertex 0. */
VEC_INLINE struct triangle triangle_at(vf from, vf shift)
{
    struct triangle at;
    at.before = vm_less(from, shift);
    at.x = vf_add_where(at.before, from, vf_set(1.0f));
    at.lower = vm_less(at.x + shift, vf_set(1.0f));
    return at;
}

/* The hashes of the corners of a triangle: the right one below, the left one above, the third. */
struct triangle_hashes {
    vu h[3];
};

/* The next cell; after the last one of a period comes the first. The steps are those
   of the reference also from cells that are not within the period, beyond 2^50. */
VEC_INLINE vu cell_after(vu cell, const struct scarp_octave *o, int axis)
{
    const vu last = vu_set(o->last[axis]);
    return cell + 1 - ((vu)(cell == last) & (last + 1));
}

VEC_INLINE vu cell_before(vu cell, const struct scarp_octave *o, int axis)
{
    return cell - 1 + ((vu)(cell == 0) & vu_set(o->last[axis] + 1));
}

VEC_INLINE vu cell_where(vm mask, vu a, vu b)
{
    return (vu)vm_choose(mask, (vf)a, (vf)b);
}

VEC_INLINE struct triangle_hashes
triangle_hashes(const struct triangle *at, const struct scarp_octave *o, vm odd, vu cell, vu row)
{
    const vu mx = vu_set(HASH_X), kx = vu_set(o->key[0]);
    const vu a = vu_add_where(at->before, cell * mx + kx, vu_set(0u - HASH_X)); /* vertex k */
    vu right = a + mx, left = vu_add_where(odd, a, mx);
    vu third = (vu)vm_choose(at->lower, (vf)a, (vf)(left + mx));
    if (o->last[0] != UINT32_MAX) {
        const vu next = cell_after(cell, o, 0);
        const vu k = cell_where(at->before, cell_before(cell, o, 0), cell);
        const vu k1 = cell_where(at->before, cell, next);
        const vu k2 = cell_where(at->before, next, cell_after(next, o, 0));
        right = k1 * mx + kx;
        left = cell_where(odd, k1, k) * mx + kx;
        third = cell_where(at->lower, k, cell_where(odd, k2, k1)) * mx + kx;
    }
    const vu my = vu_set(HASH_Y), y = row * my + vu_set(o->key[1]);
    const vu below = vu_turn8(y), above = vu_turn8(y + my);
    const struct triangle_hashes h = {
        {hash_corner(vu_turn8(right), below), hash_corner(vu_turn8(left), above),
         hash_corner(vu_turn8(third), (vu)vm_choose(at->lower, (vf)below, (vf)above))}};
    return h;
}

/* Replaces the cell by the hashes of the triangle, and the fraction along x by the triangle's x. */
VEC_INLINE void simplex_hash2(vf *location, const struct scarp_octave *o)
{
    const vu row = (vu)location[3];
    const vm odd = vm_bit(row, 0);
    const struct triangle at =
        triangle_at(vf_subtract_where(odd, location[0], vf_set(0.5f)), 0.5f * location[1]);
    const struct triangle_hashes h = triangle_hashes(&at, o, odd, (vu)location[2], row);
    location[0] = at.x;
    for (int i = 0; i < 3; i++) {
        location[2 + i] = (vf)h.h[i];
    }
}

VEC_INLINE struct sample simplex_sample2(const vf *location, struct variant v)
{
    const vf at = location[0], b = location[1];
    const vm lower = vm_less(at + 0.5f * b, vf_set(1.0f));
    const vf y0 = ROW_HEIGHT * b, y1 = y0 - ROW_HEIGHT;
    const vf left0 = vertex_left2(y0), left1 = vertex_left2(y1);
    const vf x[3] = {at - 1.0f, at - 0.5f, vm_choose(lower, at, at - 1.5f)};
    const vf y[3] = {y0, y1, vm_choose(lower, y0, y1)};
    const vf left[3] = {left0, left1, vm_choose(lower, left0, left1)};
    struct sample of[3];
    for (int i = 0; i < 3; i++) {
        const vu h = (vu)location[2 + i];
        const struct vertex vertex = {{x[i], y[i]},
                                      {vf_lookup(&gradient2_x, h), vf_lookup(&gradient2_y, h)}};
        of[i] = vertex_sample(&vertex, left[i], vertex_across(&vertex, v), v);
    }
    const struct sample both = sum_of(&of[0], &of[1], v);
    return sum_of(&both, &of[2], v);
}

/* Which axis a point is furthest from the centre of its cube along, and which nearest; x or z where
   neither of the two masks of each is set. */
struct ranks {
    vm not_far_x, far_z, not_near_z, near_x;
};

VEC_INLINE struct ranks ranks_of(const vf m[3])
{
    const vm xy = vm_less(m[0], m[1]), xz = vm_less(m[0], m[2]), yz = vm_less(m[1], m[2]);
    struct ranks r;
    r.not_far_x = vm_or(xy, xz);
    r.far_z = vm_and(r.not_far_x, yz);
    r.not_near_z = vm_or(xz, yz);
    r.near_x = vm_and(r.not_near_z, xy);
    return r;
}

/* a along the axis that is furthest (nearest), else b. */
VEC_INLINE vf if_furthest(const struct ranks *r, int axis, vf a, vf b)
{
    return axis == 0   ? vm_choose(r->not_far_x, b, a)
           : axis == 1 ? vm_choose(vm_without(r->not_far_x, r->far_z), a, b)
                       : vm_choose(r->far_z, a, b);
}

VEC_INLINE vf if_nearest(const struct ranks *r, int axis, vf a, vf b)
{
    return axis == 2   ? vm_choose(r->not_near_z, b, a)
           : axis == 1 ? vm_choose(vm_without(r->not_near_z, r->near_x), a, b)
                       : vm_choose(r->near_x, a, b);
}

/* The bits of the sign of t; ones where it is set. */
VEC_INLINE vu sign_bit(vf t)
{
    return (vu)t & 0x80000000u;
}

VEC_INLINE struct ranks ranks_at(const vf t[3])
{
    const vu magnitude = vu_set(0x7fffffffu);
    const vf m[3] = {(vf)((vu)t[0] & magnitude), (vf)((vu)t[1] & magnitude),
                     (vf)((vu)t[2] & magnitude)};
    return ranks_of(m);
}

/* What an axis gives to the hashes of the corners of a tetrahedron: two centres of cubes, then two
   corners of them. */
VEC_INLINE void tetrahedron_mix(vu of[4], const struct ranks *r, vf t, vu cell,
                                const struct scarp_octave *o, int axis)
{
    const vu down = (vu)((vi)t >> 31);
    vu mixed[3];
    mixed_beside(mixed, cell, o, axis);
    const vf h = (vf)mixed[1], up = (vf)mixed[2];
    const vf outer = (vf)vu_choose(down, mixed[0], (vu)up);
    const vf near = (vf)vu_choose(down, (vu)h, (vu)up), far = (vf)vu_choose(down, (vu)up, (vu)h);
    of[0] = (vu)h;
    of[1] = (vu)if_furthest(r, axis, outer, h);
    of[2] = (vu)near;
    of[3] = (vu)if_nearest(r, axis, far, near);
}

/* Replaces the cell by the hashes of the tetrahedron, and fractions by distances from the middle of
   that inside. */
VEC_INLINE void simplex_hash3(vf *location, const struct scarp_octave *o)
{
    const vf t[3] = {location[0] - 0.5f, location[1] - 0.5f, location[2] - 0.5f};
    const struct ranks r = ranks_at(t);
    vu x[4], y[4], z[4];
    tetrahedron_mix(x, &r, t[0], (vu)location[3], o, 0);
    tetrahedron_mix(y, &r, t[1], (vu)location[4], o, 1);
    tetrahedron_mix(z, &r, t[2], (vu)location[5], o, 2);
    for (int i = 0; i < 3; i++) {
        location[i] = t[i];
    }
    for (int i = 0; i < 4; i++) {
        const vu h = x[i] ^ y[i] ^ z[i];
        location[3 + i] = (vf)(h * (h + vu_set(i < 2 ? HASH_CENTRE : HASH_K)));
    }
}

/* Where a point is from the corners of its tetrahedron along an axis. */
VEC_INLINE void tetrahedron_axis(vf d[4][3], const struct ranks *r, vf t, int axis)
{
    const vf one = (vf)(sign_bit(t) | (vu)vf_set(1.0f)),
             half = (vf)(sign_bit(t) | (vu)vf_set(0.5f));
    d[0][axis] = t;
    d[1][axis] = if_furthest(r, axis, t - one, t);
    d[2][axis] = t - half;
    d[3][axis] = if_nearest(r, axis, t + half, t - half);
}

/* The gradient that a hash draws. */
VEC_INLINE void vertex_gradient3(struct vertex *vertex, vu hash)
{
    const vu index = vu_top_index(hash);
    vertex->g[0] = vf_lookup_top(&gradient3_x, index);
    vertex->g[1] = vf_lookup_top(&gradient3_y, index);
    vertex->g[2] = vf_lookup_top(&gradient3_z, index);
}

/* What corner i of the tetrahedron adds. */
VEC_INLINE struct sample corner_sample3(const vf *location, vf d[4][3], int i, struct variant v)
{
    struct vertex vertex = {.d = {d[i][0], d[i][1], d[i][2]}};
    vertex_gradient3(&vertex, (vu)location[3 + i]);
    return vertex_sample(&vertex, vertex_left3(vertex.d[1], vertex.d[2]), vertex_across(&vertex, v),
                         v);
}

VEC_INLINE struct sample simplex_sample3(const vf *location, struct variant v)
{
    const struct ranks r = ranks_at(location);
    vf d[4][3];
    for (int axis = 0; axis < 3; axis++) {
        tetrahedron_axis(d, &r, location[axis], axis);
    }
    struct sample pair[2];
    for (int i = 0; i < 2; i++) {
        const struct sample one = corner_sample3(location, d, 2 * i, v);
        const struct sample other = corner_sample3(location, d, 2 * i + 1, v);
        pair[i] = sum_of(&one, &other, v);
    }
    struct sample sum = sum_of(&pair[1], &pair[0], v);
#define ZERO(i, member, rank) sum.member += vf_set(0.0f)
    EACH_OUTPUT(v, ZERO);
#undef ZERO
    return sum;
}

/* Draws the hashes of a row of located blocks: a separate pass, since shorter chains of operations
   overlap better (see ../driver.h). It is out of line, since all orders share it. */
static __attribute__((noinline)) void
simplex_hash_row(vf *location, const struct scarp_octave *octave, size_t blocks, int dimensions)
{
    const struct scarp_octave o = *octave; /* a copy: nothing that is stored can alias it */
    vf *const end = location + blocks * unhashed_size(dimensions);
    if (dimensions == 2) {
        for (; location < end; location += unhashed_size(2)) {
            simplex_hash2(location, &o);
        }
    } else {
        for (; location < end; location += unhashed_size(3)) {
            simplex_hash3(location, &o);
        }
    }
}

#endif
