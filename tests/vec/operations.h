/* SPDX-License-Identifier: MIT
 *
 * Makes the table of table.h for one instruction set. Included by each src/simd/kernels_<isa>.c in
 * place of the kernels (src/simd/body.h), after its operations and inside its target region.
 */
#include "table.h"

VEC_INLINE void store_halves(double *out, vd low, vd high)
{
    memcpy(out, &low, sizeof low);
    memcpy(out + VEC_LANES / 2, &high, sizeof high);
}

static void copy_f(float *out, const float *in)
{
    vf_store(out, vf_load(in));
}

static void copy_u(uint32_t *out, const uint32_t *in)
{
    vu_store(out, vu_load(in));
}

static void copy_d(double *out, const double *in)
{
    store_halves(out, vd_load(in), vd_load(in + VEC_LANES / 2));
}

static void partial_f(float *out, float *loaded, const float *in, size_t n)
{
    const vf v = vf_load_partial(in, n);
    vf_store(loaded, v);
    vf_store_partial(out, v, n);
}

static void partial_d(double *loaded, const double *in, size_t n)
{
    const vd v = vd_load_partial(in, n);
    memcpy(loaded, &v, sizeof v);
}

static void stream(float *out, const float *in)
{
    vf_stream(out, vf_load(in));
    vf_stream_end();
}

static void set_f(float *out, float a)
{
    vf_store(out, vf_set(a));
}

static void set_u(uint32_t *out, uint32_t a)
{
    vu_store(out, vu_set(a));
}

static void set_d(double *out, double a)
{
    store_halves(out, vd_set(a), vd_set(a));
}

static void numbers(uint32_t *out)
{
    vu_store(out, vu_lanes());
}

static void floor_f(float *out, const float *in)
{
    vf_store(out, vf_floor(vf_load(in)));
}

static void floor_d(double *out, const double *in)
{
    store_halves(out, vd_floor(vd_load(in)), vd_floor(vd_load(in + VEC_LANES / 2)));
}

static void u_from_f(uint32_t *out, const float *in)
{
    vu_store(out, vu_from_vf(vf_load(in)));
}

static void f_from_i(float *out, const uint32_t *in)
{
    vf_store(out, vf_from_vi((vi)vu_load(in)));
}

static void f_from_d(float *out, const double *in)
{
    vf_store(out, vf_from_vd(vd_load(in), vd_load(in + VEC_LANES / 2)));
}

static void f_stored_d(float *out, const double *in)
{
    vf_store_vd(out, vd_load(in), vd_load(in + VEC_LANES / 2));
}

static void d_from_f(double *out, const float *in)
{
    const vf v = vf_load(in);
    store_halves(out, vd_from_low(v), vd_from_high(v));
}

static void low_bits(uint32_t *out, const double *in)
{
    vu_store(out, vu_low_bits(vd_load(in), vd_load(in + VEC_LANES / 2)));
}

static void sqrt_d(double *out, const double *in)
{
    store_halves(out, vd_sqrt(vd_load(in)), vd_sqrt(vd_load(in + VEC_LANES / 2)));
}

static void sqrt_f(float *out, const float *in)
{
    vf_store(out, vf_sqrt(vf_load(in)));
}

static void positive(float *out, const float *in)
{
    vf_store(out, vf_positive(vf_load(in)));
}

static void lesser(float *out, const float *a, const float *b)
{
    vf_store(out, vf_lesser(vf_load(a), vf_load(b)));
}

static void greater(float *out, const float *a, const float *b)
{
    vf_store(out, vf_greater(vf_load(a), vf_load(b)));
}

static void term(float *out, const float *a, const float *b)
{
    vf_store(out, vf_term(vf_load(a), vf_load(b)));
}

/* A number for each lane: 1 where a < b, 2 where a and b have the same bits, 4 where both or
   either, 8 where the first and not the second, and whether any lane is less. */
static int masks(float *chosen, uint32_t *kept, const float *a, const float *b)
{
    const vf va = vf_load(a), vb = vf_load(b);
    const vm less = vm_less(va, vb), equal = vm_equal((vu)va, (vu)vb);
    vf_store(chosen, vm_choose(less, va, vb));
    vu_store(kept, vm_keep(less, vu_set(1)) | vm_keep(equal, vu_set(2)) |
                       vm_keep(vm_or(less, equal), vu_set(4)) |
                       vm_keep(vm_without(less, equal), vu_set(8)) |
                       vm_keep(vm_and(less, equal), vu_set(16)) |
                       vm_keep(vm_and(less, vm_less(va, vf_set(1.0f))), vu_set(32)));
    return vm_any(less);
}

/* The same of a and b where bit 3 of `bits` is set, and a where it is not. */
static void where(float *added, float *subtracted, uint32_t *sum, const float *a, const float *b,
                  const uint32_t *bits)
{
    const vm mask = vm_bit(vu_load(bits), 3);
    vf_store(added, vf_add_where(mask, vf_load(a), vf_load(b)));
    vf_store(subtracted, vf_subtract_where(mask, vf_load(a), vf_load(b)));
    vu_store(sum, vu_add_where(mask, (vu)vf_load(a), (vu)vf_load(b)));
}

static void exact_fma(float *out, const float *a, const float *b, const float *c)
{
    vf_store(out, vf_exact_fma(vf_load(a), vf_load(b), vf_load(c)));
}

static int any(const uint32_t *in)
{
    return vu_any(vu_load(in));
}

static void turn8(uint32_t *out, const uint32_t *in)
{
    vu_store(out, vu_turn8(vu_load(in)));
}

static void turn16(uint32_t *out, const uint32_t *in)
{
    vu_store(out, vu_turn16(vu_load(in)));
}

static void upper_times12(uint32_t *out, const uint32_t *in)
{
    vu_store(out, vu_upper_times(vu_load(in), 12));
}

static void upper_times144(uint32_t *out, const uint32_t *in)
{
    vu_store(out, vu_upper_times(vu_load(in), 144));
}

static void xor3(uint32_t *out, const uint32_t *a, const uint32_t *b, const uint32_t *c)
{
    vu_store(out, vu_xor3(vu_load(a), vu_load(b), vu_load(c)));
}

static void multiply(uint32_t *out, const uint32_t *a, const uint32_t *b)
{
    vu_store(out, vu_load(a) * vu_load(b));
}

static void shift(uint32_t *out, const uint32_t *in, int bits)
{
    vu_store(out, vu_load(in) >> bits);
}

static void less(uint32_t *out, const float *a, const float *b)
{
    vu_store(out, (vu)(vf_load(a) < vf_load(b)));
}

static void not_equal(uint32_t *out, const float *a, const float *b)
{
    vu_store(out, (vu)(vf_load(a) != vf_load(b)));
}

static void lookup(float *out, const struct lookup *table, const uint32_t *hash)
{
    vf_store(out, vf_lookup(table, vu_load(hash)));
}

static void lookup_four(float *out, const struct lookup *table, const uint32_t *hash)
{
    const vu four[4] = {vu_load(hash), vu_load(hash + VEC_LANES), vu_load(hash + 2 * VEC_LANES),
                        vu_load(hash + 3 * VEC_LANES)};
    const struct vf_four found = vf_lookup_four(table, four);
    for (int i = 0; i < 4; i++) {
        vf_store(out + i * VEC_LANES, found.v[i]);
    }
}

/* Entries in memory, by number: `four` of one vector each, and all four at once. */
static void sixteen(float *out, float *four, const float *entry, const uint32_t *index)
{
    const vf_sixteen table = vf_sixteen_load(entry);
    const vu all[4] = {vu_load(index) & 15u, vu_load(index + VEC_LANES) & 15u,
                       vu_load(index + 2 * VEC_LANES) & 15u, vu_load(index + 3 * VEC_LANES) & 15u};
    const struct vf_four found = vf_sixteen_four(&table, all);
    for (int i = 0; i < 4; i++) {
        vf_store(out + i * VEC_LANES, vf_sixteen_of(&table, vu_load(index + i * VEC_LANES)));
        vf_store(four + i * VEC_LANES, found.v[i]);
    }
}

/* Entries whose number i ^ 9 is the negative of number i. */
static void sixteen_odd(float *out, float *four, const float *entry, const uint32_t *hash)
{
    const vf_sixteen table = vf_sixteen_load(entry);
    const vu all[4] = {vu_load(hash), vu_load(hash + VEC_LANES), vu_load(hash + 2 * VEC_LANES),
                       vu_load(hash + 3 * VEC_LANES)};
    const struct vf_four found = vf_sixteen_odd_four(&table, all);
    for (int i = 0; i < 4; i++) {
        vf_store(out + i * VEC_LANES, vf_sixteen_odd(&table, all[i]));
        vf_store(four + i * VEC_LANES, found.v[i]);
    }
}

static void among(float *out, const float *entry, const uint32_t *index)
{
    vf_store(out, vf_among(vf_load(entry), vu_load(index)));
}

static void twelfth(uint32_t *out, const uint32_t *hash)
{
    vu_store(out, vu_twelfth(vu_load(hash)));
}

static void lookup_top(float *out, const struct lookup_top *table, const uint32_t *hash)
{
    vf_store(out, vf_lookup_top(table, vu_top_index(vu_load(hash))));
}

static void permute(float *out, const float *entries, const uint32_t *index, int next)
{
    const vu i = vf_index(vu_load(index));
    vf_store(out, vf_permute(vf_table_load(entries), next ? i + VF_INDEX_NEXT : i));
}

static void slide(float *out, const float *entries, const float *after, const uint32_t *index)
{
    const vf_table table = vf_table_slide(vf_table_load(entries), vf_load(after));
    vf_store(out, vf_permute(table, vf_index(vu_load(index))));
}

const struct vec_operations VEC_OPERATIONS(KERNELS) = {
    .isa = KERNELS_ISA,
    .lanes = VEC_LANES,
    .table = VF_TABLE,
    .copy_f = copy_f,
    .copy_u = copy_u,
    .copy_d = copy_d,
    .partial_f = partial_f,
    .partial_d = partial_d,
    .stream = stream,
    .set_f = set_f,
    .set_u = set_u,
    .set_d = set_d,
    .numbers = numbers,
    .floor_f = floor_f,
    .floor_d = floor_d,
    .u_from_f = u_from_f,
    .f_from_i = f_from_i,
    .f_from_d = f_from_d,
    .f_stored_d = f_stored_d,
    .d_from_f = d_from_f,
    .low_bits = low_bits,
    .sqrt_d = sqrt_d,
    .sqrt_f = sqrt_f,
    .positive = positive,
    .lesser = lesser,
    .greater = greater,
    .term = term,
    .masks = masks,
    .where = where,
    .exact_fma = exact_fma,
    .turn8 = turn8,
    .turn16 = turn16,
    .upper_times12 = upper_times12,
    .upper_times144 = upper_times144,
    .xor3 = xor3,
    .any = any,
    .multiply = multiply,
    .shift = shift,
    .less = less,
    .not_equal = not_equal,
    .lookup = lookup,
    .lookup_four = lookup_four,
    .lookup_top = lookup_top,
    .sixteen = sixteen,
    .sixteen_odd = sixteen_odd,
    .among = among,
    .twelfth = twelfth,
    .permute = permute,
    .slide = slide,
};
