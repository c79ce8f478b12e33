/* SPDX-License-Identifier: MIT
 *
 * Compares every vector operation of an instruction set with plain C.
 *
 *     test_vec ISA
 *
 * Elements are compared by their bits, NaN being one number. Every number is in every lane
 * once.
 */
#include "vec/numbers.h"
#include "vec/table.h"

static const struct vec_operations *ops;
static int lanes;

#define DIFFERENT32(a, b) (bits_of_float(a) != bits_of_float(b) && !(isnan(a) && isnan(b)))
#define DIFFERENT64(a, b) (bits_of_double(a) != bits_of_double(b) && !(isnan(a) && isnan(b)))
#define DIFFERENT(a, b) ((a) != (b))

#include "vec/lookups.h"

/*
 * RUN(name, in, out, different, format) defines a function that gives an operation all `count`
 * values, in each lane, and compares each result with that of `wanted`.
 */
#define RUN(name, in_type, out_type, different, format)                                            \
    static void name(const char *what, void (*operation)(out_type *, const in_type *),             \
                     out_type (*wanted)(in_type), const in_type *values, size_t count)             \
    {                                                                                              \
        for (size_t start = 0; start < count; start++) {                                           \
            in_type in[LANES_MAX];                                                                 \
            out_type out[LANES_MAX];                                                               \
            for (int i = 0; i < lanes; i++) {                                                      \
                in[i] = values[(start + (size_t)i * 61) % count];                                  \
            }                                                                                      \
            operation(out, in);                                                                    \
            for (int i = 0; i < lanes; i++) {                                                      \
                const out_type w = wanted(in[i]);                                                  \
                CHECK(!different(out[i], w), "%s, lane %d: " format, what, i, in[i], out[i], w);   \
            }                                                                                      \
        }                                                                                          \
    }

RUN(run_ff, float, float, DIFFERENT32, "of %a: %a, not %a")
RUN(run_dd, double, double, DIFFERENT64, "of %a: %a, not %a")
RUN(run_uu, uint32_t, uint32_t, DIFFERENT, "of %#x: %#x, not %#x")
RUN(run_fu, float, uint32_t, DIFFERENT, "of %a: %#x, not %#x")
RUN(run_uf, uint32_t, float, DIFFERENT32, "of %#x: %a, not %a")
RUN(run_df, double, float, DIFFERENT32, "of %a: %a, not %a")
RUN(run_fd, float, double, DIFFERENT64, "of %a: %a, not %a")
RUN(run_du, double, uint32_t, DIFFERENT, "of %a: %#x, not %#x")

/* It is given integral floats only: vec.h promises nothing of others. */
static uint32_t u_from_f(float a)
{
    return a >= -0x1p31f && a < 0x1p31f ? (uint32_t)(int32_t)a : 0x80000000u;
}

static float f_from_i(uint32_t a)
{
    return a < 0x80000000u ? (float)a : -(float)(0u - a);
}

static float f_from_d(double a)
{
    return (float)a;
}

static double d_from_f(float a)
{
    return (double)a;
}

static uint32_t low_bits(double a)
{
    return (uint32_t)bits_of_double(a);
}

static uint32_t turn8(uint32_t a)
{
    return a >> 8 | (a & 0xffu) << 24;
}

static uint32_t turn16(uint32_t a)
{
    return a >> 16 | (a & 0xffffu) << 16;
}

static uint32_t upper_times12(uint32_t a)
{
    return ((a >> 16) * 12u & 0xffffu) << 16;
}

static uint32_t upper_times144(uint32_t a)
{
    return ((a >> 16) * 144u & 0xffffu) << 16;
}

static float positive(float a)
{
    return a > 0.0f ? a : 0.0f;
}

static size_t integral_floats(float *list)
{
    size_t count = 0;
    for (size_t i = 0; i < numbers_f; i++) {
        if (!isnan(number_f[i]) && floorf(number_f[i]) == number_f[i]) {
            list[count++] = number_f[i];
        }
    }
    return count;
}

static void test_rounding(void)
{
    static float integral[NUMBERS_MAX];
    run_ff("floor of floats", ops->floor_f, floorf, number_f, numbers_f);
    run_dd("floor of doubles", ops->floor_d, floor, number_d, numbers_d);
    run_fu("u from f", ops->u_from_f, u_from_f, integral, integral_floats(integral));
    run_uf("f from i", ops->f_from_i, f_from_i, number_bits32, numbers32);
    run_df("f from d", ops->f_from_d, f_from_d, number_d, numbers_d);
    run_df("f stored from d", ops->f_stored_d, f_from_d, number_d, numbers_d);
    run_fd("d from f", ops->d_from_f, d_from_f, number_f, numbers_f);
}

/* Each bit of the result is odd where an odd number of the three is set: all eight combinations
   stand in the eight lowest bits of each lane. */
static void test_xor3(void)
{
    uint32_t a[LANES_MAX], b[LANES_MAX], c[LANES_MAX], result[LANES_MAX];
    for (int i = 0; i < LANES_MAX; i++) {
        const uint32_t high = (uint32_t)(i + 1) * 0x9e377900u;
        a[i] = 0xf0u | (high & 0xffffff00u);
        b[i] = 0xccu | ((high >> 3) & 0xffffff00u);
        c[i] = 0xaau | ((high << 5) & 0xffffff00u);
    }
    ops->xor3(result, a, b, c);
    for (int i = 0; i < lanes; i++) {
        CHECK_BITS(result[i] == (a[i] ^ b[i] ^ c[i]), "xor3, lane %d: %08x", i, result[i]);
    }
}

static void test_bits_of_lanes(void)
{
    uint32_t numbers[LANES_MAX];
    run_du("low bits", ops->low_bits, low_bits, number_d, numbers_d);
    run_uu("turn by 8", ops->turn8, turn8, number_bits32, numbers32);
    run_uu("turn by 16", ops->turn16, turn16, number_bits32, numbers32);
    run_uu("upper half times 12", ops->upper_times12, upper_times12, number_bits32, numbers32);
    run_uu("upper half times 144", ops->upper_times144, upper_times144, number_bits32, numbers32);
    run_dd("square root", ops->sqrt_d, sqrt, number_d, numbers_d);
    run_ff("square root of floats", ops->sqrt_f, sqrtf, number_f, numbers_f);
    run_ff("positive", ops->positive, positive, number_f, numbers_f);
    ops->numbers(numbers);
    const uint32_t none[LANES_MAX] = {0};
    CHECK(!ops->any(none), "no bit is set");
    for (int i = 0; i < lanes * 32; i++) {
        uint32_t one[LANES_MAX] = {0};
        one[i / 32] = (uint32_t)1 << i % 32;
        CHECK(ops->any(one), "bit %d of lane %d is set", i % 32, i / 32);
    }
    for (int i = 0; i < lanes; i++) {
        CHECK(numbers[i] == (uint32_t)i, "lane %d has the number %u", i, numbers[i]);
    }
}

/* The bits are those of `masks` in vec/operations.h. */
static void check_masks(const float *a, const float *b)
{
    float chosen[LANES_MAX], lesser[LANES_MAX], greater[LANES_MAX];
    uint32_t kept[LANES_MAX];
    int any = 0;
    const int found = ops->masks(chosen, kept, a, b);
    ops->lesser(lesser, a, b);
    ops->greater(greater, a, b);
    for (int i = 0; i < lanes; i++) {
        const int less = a[i] < b[i], equal = bits_of_float(a[i]) == bits_of_float(b[i]);
        const float wanted = less ? a[i] : b[i];
        const uint32_t bits =
            (less ? 1u | 4u | 8u : 0u) | (equal ? 2u | 4u : 0u) | (less && a[i] < 1.0f ? 32u : 0u);
        any |= less;
        CHECK(!DIFFERENT32(chosen[i], wanted), "%a < %a: %a", (double)a[i], (double)b[i],
              (double)chosen[i]);
        CHECK(!DIFFERENT32(lesser[i], wanted), "lesser of %a, %a: %a", (double)a[i], (double)b[i],
              (double)lesser[i]);
        CHECK(!DIFFERENT32(greater[i], a[i] > b[i] ? a[i] : b[i]), "greater of %a, %a: %a",
              (double)a[i], (double)b[i], (double)greater[i]);
        CHECK(kept[i] == bits, "%a < %a: bits %u, not %u", (double)a[i], (double)b[i], kept[i],
              bits);
    }
    CHECK(found == any, "any: %d, not %d", found, any);
}

/* Products, which are 0 where a factor is. */
static void check_term(const float *a, const float *b)
{
    float zeros[LANES_MAX], got[LANES_MAX];
    for (int i = 0; i < lanes; i++) {
        zeros[i] = i % 2 == 0 ? 0.0f : -0.0f;
    }
    const float *const factors[3][2] = {{a, b}, {a, zeros}, {zeros, b}};
    for (int n = 0; n < 3; n++) {
        const float *const x = factors[n][0], *const y = factors[n][1];
        ops->term(got, x, y);
        for (int i = 0; i < lanes; i++) {
            const float wanted = x[i] == 0.0f || y[i] == 0.0f ? 0.0f : x[i] * y[i];
            CHECK(!DIFFERENT32(got[i], wanted), "%a times %a: %a", (double)x[i], (double)y[i],
                  (double)got[i]);
        }
    }
}

/* Sums where bit 3 is set. */
static void check_where(const float *a, const float *b, const uint32_t *bits)
{
    float added[LANES_MAX], subtracted[LANES_MAX];
    uint32_t sum[LANES_MAX];
    ops->where(added, subtracted, sum, a, b, bits);
    for (int i = 0; i < lanes; i++) {
        const int is_set = (bits[i] & 8u) != 0;
        const uint32_t wanted = bits_of_float(a[i]) + (is_set ? bits_of_float(b[i]) : 0);
        const int is_minus_0 = bits_of_float(a[i]) == 0x80000000u;
        const float plus = is_set ? a[i] + b[i] : a[i], minus = is_set ? a[i] - b[i] : a[i];
        CHECK(is_minus_0 || !DIFFERENT32(added[i], plus), "%a + %a: %a", (double)a[i], (double)b[i],
              (double)added[i]);
        CHECK(is_minus_0 || !DIFFERENT32(subtracted[i], minus), "%a - %a: %a", (double)a[i],
              (double)b[i], (double)subtracted[i]);
        CHECK(sum[i] == wanted, "%#x and %#x: %#x", bits_of_float(a[i]), bits_of_float(b[i]),
              sum[i]);
    }
}

static void test_operators(void)
{
    uint64_t state = 4;
    for (size_t start = 0; start < numbers_f; start++) {
        float a[LANES_MAX], b[LANES_MAX];
        uint32_t m[LANES_MAX], n[LANES_MAX], less[LANES_MAX], not_equal[LANES_MAX];
        uint32_t product[LANES_MAX], shifted[LANES_MAX];
        const int bits = (int)(check_random(&state) % 32);
        for (int i = 0; i < lanes; i++) {
            a[i] = number_f[(start + (size_t)i * 61) % numbers_f];
            b[i] = (start + (size_t)i) % 3 != 0 ? number_f[check_random(&state) % numbers_f] : a[i];
            m[i] = number_bits32[check_random(&state) % numbers32];
            n[i] = number_bits32[check_random(&state) % numbers32];
        }
        check_masks(a, b);
        check_where(a, b, m);
        check_term(a, b);
        ops->less(less, a, b);
        ops->not_equal(not_equal, a, b);
        ops->multiply(product, m, n);
        ops->shift(shifted, m, bits);
        for (int i = 0; i < lanes; i++) {
            CHECK(less[i] == (a[i] < b[i] ? UINT32_MAX : 0), "%a < %a: %#x", (double)a[i],
                  (double)b[i], less[i]);
            CHECK(not_equal[i] == (a[i] != b[i] ? UINT32_MAX : 0), "%a != %a: %#x", (double)a[i],
                  (double)b[i], not_equal[i]);
            CHECK(product[i] == m[i] * n[i], "%#x * %#x: %#x", m[i], n[i], product[i]);
            CHECK(shifted[i] == m[i] >> bits, "%#x >> %d: %#x", m[i], bits, shifted[i]);
        }
    }
}

/* Gives exact_fma the factors a[] and b[], in either order, and compares with C, which rounds the
   product: tests are compiled without contraction. */
static void check_exact_fma(const float *a, const float *b, const float *c)
{
    float found[2][LANES_MAX];
    ops->exact_fma(found[0], a, b, c);
    ops->exact_fma(found[1], b, a, c);
    for (int i = 0; i < lanes; i++) {
        const float product = a[i] * b[i];
        const float wanted = product + c[i];
        for (int order = 0; order < 2; order++) {
            CHECK(!DIFFERENT32(found[order][i], wanted),
                  "%a * %a + %a, order %d, lane %d: %a, not %a", (double)a[i], (double)b[i],
                  (double)c[i], order, i, (double)found[order][i], (double)wanted);
        }
    }
}

/* Every number as the factor that may be anything. The other one is 0 or a power of two from 1 on,
   and the product does not overflow. What is added is any number, or cancels all or nearly all, or
   is so much larger or smaller that only rounding shows it. */
static void test_exact_fma(void)
{
    static const float powers[] = {0.0f, -0.0f, 1.0f, -1.0f, 2.0f, -2.0f, 4.0f, -4.0f, 0x1p60f};
    const int kinds = 8;
    uint64_t state = 7;
    for (size_t p = 0; p < sizeof powers / sizeof powers[0]; p++) {
        for (size_t n = 0; n < numbers_f * (size_t)kinds; n += (size_t)lanes) {
            float a[LANES_MAX], b[LANES_MAX], c[LANES_MAX];
            for (int i = 0; i < lanes; i++) {
                const size_t number = (n + (size_t)i) % (numbers_f * (size_t)kinds);
                const float any = number_f[check_random(&state) % numbers_f];
                a[i] = powers[p];
                b[i] = number_f[number / (size_t)kinds];
                b[i] = isinf(a[i] * b[i]) && !isinf(b[i]) ? 1.0f : b[i];
                const float product = a[i] * b[i];
                const float chosen[] = {any,
                                        0.0f,
                                        -0.0f,
                                        -product,
                                        nextafterf(-product, any),
                                        product * 0x1.8p24f,
                                        product * -0x1.000002p-24f,
                                        b[i]};
                c[i] = chosen[number % (size_t)kinds];
            }
            check_exact_fma(a, b, c);
        }
    }
}

/* What 3D gradient noise asks of it: components of gradients, which are 0 and +-2, times places,
   and their differences times fades, added to the other such product or to a component. Places are
   those in [0, 1] and what is left of them to 1. Fades exceed 1 by an ulp at most. */
static void test_exact_components(void)
{
    static const float components[] = {0.0f, 2.0f, -2.0f};
    uint64_t state = 8;
    for (size_t n = 0; n < numbers_f; n += (size_t)lanes) {
        for (int pair = 0; pair < 9; pair++) {
            float g[LANES_MAX], difference[LANES_MAX], t[LANES_MAX], s[LANES_MAX], u[LANES_MAX];
            float other[LANES_MAX], component[LANES_MAX];
            for (int i = 0; i < lanes; i++) {
                const float number = fabsf(number_f[(n + (size_t)i) % numbers_f]);
                const float random = (float)(check_random(&state) >> 40) * 0x1p-24f;
                t[i] = !(number > 1.0f) ? number : check_random(&state) % 8 == 0 ? 1.0f : random;
                s[i] = t[i] - 1.0f;
                u[i] = check_random(&state) % 8 == 0 ? 1.0f + 0x1p-23f : t[i];
                g[i] = components[pair % 3];
                component[i] = components[pair / 3];
                difference[i] = g[i] - component[i];
                other[i] = component[i] * (i % 2 == 0 ? random : s[i]);
            }
            check_exact_fma(g, t, other);
            check_exact_fma(g, s, other);
            check_exact_fma(u, difference, component);
        }
    }
}

static void test_sets(void)
{
    float f[LANES_MAX];
    double d[LANES_MAX];
    uint32_t u[LANES_MAX];
    for (size_t n = 0; n < numbers32; n++) {
        const float a = number_f[n % numbers_f];
        const double b = number_d[n % numbers_d];
        ops->set_f(f, a);
        ops->set_d(d, b);
        ops->set_u(u, number_bits32[n]);
        for (int i = 0; i < lanes; i++) {
            CHECK(!DIFFERENT32(f[i], a), "lane %d: %a, not %a", i, (double)f[i], (double)a);
            CHECK(!DIFFERENT64(d[i], b), "lane %d: %a, not %a", i, d[i], b);
            CHECK(u[i] == number_bits32[n], "lane %d: %#x, not %#x", i, u[i], number_bits32[n]);
        }
    }
}

/* COPY(name, type) defines a function that loads and stores at every distance from an aligned
   address, and checks that nothing before or behind is written. */
#define SPACE (4 * LANES_MAX)
#define COPY(name, type)                                                                           \
    static void name(const char *what, void (*copy)(type *, const type *), int step)               \
    {                                                                                              \
        static _Alignas(64) type from[SPACE], to[SPACE], wanted[SPACE];                            \
        for (int i = 0; i < SPACE; i++) {                                                          \
            from[i] = (type)(i + 1);                                                               \
        }                                                                                          \
        for (int in = 0; in <= LANES_MAX; in++) {                                                  \
            for (int out = 0; out <= 2 * LANES_MAX; out += step) {                                 \
                memset(to, 0x77, sizeof to);                                                       \
                memset(wanted, 0x77, sizeof wanted);                                               \
                memcpy(wanted + out, from + in, (size_t)lanes * sizeof *from);                     \
                copy(to + out, from + in);                                                         \
                CHECK(memcmp(to, wanted, sizeof to) == 0, "%s from %d to %d", what, in, out);      \
            }                                                                                      \
        }                                                                                          \
    }

COPY(test_copy_f, float)
COPY(test_copy_u, uint32_t)
COPY(test_copy_d, double)

/* Checks a vector of which `n` elements were loaded from `from`: the others repeat some of them. */
#define PART(name, type)                                                                           \
    static void name(const type *loaded, const type *from, int n, int length)                      \
    {                                                                                              \
        for (int i = 0; i < length; i++) {                                                         \
            int found = i < n ? loaded[i] == from[i] : 0;                                          \
            for (int j = 0; i >= n && j < n; j++) {                                                \
                found |= loaded[i] == from[j];                                                     \
            }                                                                                      \
            CHECK(found, "%d of %d: lane %d has %a", n, length, i, (double)loaded[i]);             \
        }                                                                                          \
    }

PART(check_part_f, float)
PART(check_part_d, double)

/* test_memory.c checks that nothing beyond a part is read. */
static void test_parts(void)
{
    float in[LANES_MAX];
    double in_d[LANES_MAX];
    for (int i = 0; i < LANES_MAX; i++) {
        in[i] = (float)(i + 1);
        in_d[i] = (double)(i + 1);
    }
    for (int n = 1; n < lanes; n++) {
        float loaded[LANES_MAX], out[LANES_MAX], wanted[LANES_MAX];
        memset(out, 0x77, sizeof out);
        memset(wanted, 0x77, sizeof wanted);
        memcpy(wanted, in, (size_t)n * sizeof *in);
        ops->partial_f(out, loaded, in, (size_t)n);
        check_part_f(loaded, in, n, lanes);
        CHECK(memcmp(out, wanted, sizeof out) == 0, "a part of %d stored", n);
    }
    for (int n = 1; n <= lanes / 2; n++) {
        double loaded[LANES_MAX];
        ops->partial_d(loaded, in_d, (size_t)n);
        check_part_d(loaded, in_d, n, lanes / 2);
    }
}

static void test_memory(void)
{
    test_copy_f("floats", ops->copy_f, 1);
    test_copy_u("integers", ops->copy_u, 1);
    test_copy_d("doubles", ops->copy_d, 1);
    test_copy_f("stream", ops->stream, lanes);
    test_parts();
}

static const struct vec_operations *operations_of(enum scarp_isa isa)
{
#define TABLE(ISA, table, name, here) SCARP_WHERE(here, &scarpi_kernels_##table##_operations, )
    static const struct vec_operations *const tables[] = {SCARP_ISA_VECTORS(TABLE) NULL};
#undef TABLE
    for (size_t i = 0; tables[i] != NULL; i++) {
        if (tables[i]->isa == isa) {
            return tables[i];
        }
    }
    printf("%s has no vector operations\n", scarp_isa_name(isa));
    exit(EXIT_FAILURE);
}

int main(int argc, char **argv)
{
    ops = operations_of(check_isa_argument(argc, argv));
    lanes = ops->lanes;
    CHECK(lanes <= LANES_MAX && (ops->table == lanes || ops->table == 2 * lanes), "%d lanes, %d",
          lanes, ops->table);
    make_numbers();
    test_rounding();
    test_bits_of_lanes();
    test_xor3();
    test_operators();
    test_exact_fma();
    test_exact_components();
    test_sets();
    test_memory();
    test_lookup();
    test_lookup_four();
    test_sixteen();
    test_among();
    test_twelfth();
    test_permute();
    return check_done();
}
