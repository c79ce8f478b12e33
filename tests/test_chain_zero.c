/* SPDX-License-Identifier: MIT
 *
 * Products by 0: scarp_multiply and scarp_mix leave out a term with a factor 0, whatever the other
 * factor is, and a mask of 0 or 1 without slopes gives its input to the bit. The outputs are
 * compared with the header's terms, which this file adds up once more. Blends by masks in [0, 1]
 * stay between their inputs.
 *
 *     test_chain_zero ISA
 */
#include "chain.h"

#define POINTS 4099

static float in[CHAIN_INPUTS][OUTPUTS][POINTS];
static struct outputs out;

static void call_all(enum chain f)
{
    const struct scarp_samples inputs[CHAIN_INPUTS] = {chain_samples(in[0][0], POINTS),
                                                       chain_samples(in[1][0], POINTS),
                                                       chain_samples(in[2][0], POINTS)};
    const struct scarp_samples all = outputs_subset(&out, (1u << OUTPUTS) - 1);
    CHECK(chain_call(f, POINTS, inputs, NULL, &all) == SCARP_OK, "%s", chain_kinds[f].name);
}

/* Numbers that matter to products: zeros, what makes NaN of them, and the halves of masks. */
static float draw(uint64_t *random)
{
    static const float special[] = {0.0f,     -0.0f,     0.0f, 1.0f, 1.0f,      NAN,   -NAN,
                                    INFINITY, -INFINITY, 0.5f, 2.0f, 0x1p-149f, -3e38f};
    const uint64_t drawn = check_random(random) >> 8;
    return drawn % 4 == 0 ? check_random_float(random, 2.0f)
                          : special[drawn / 4 % (sizeof special / sizeof special[0])];
}

static void make_special(uint64_t seed)
{
    uint64_t random = seed;
    for (int i = 0; i < CHAIN_INPUTS * OUTPUTS * POINTS; i++) {
        (&in[0][0][0])[i] = draw(&random);
    }
}

/* A term of the header: 0 if a factor is. */
static float term(float a, float b)
{
    return a == 0.0f || b == 0.0f ? 0.0f : a * b;
}

/* Output m of a b, by the header. */
static float product(const float a[OUTPUTS], const float b[OUTPUTS], int m)
{
    if (m == OUTPUT_value) {
        return term(a[0], b[0]);
    }
    const float linear = term(b[0], a[m]) + term(a[0], b[m]);
    if (output_kinds[m].order == 1) {
        return linear;
    }
    const int i = OUTPUT_dx + output_kinds[m].axes[0], j = OUTPUT_dx + output_kinds[m].axes[1];
    return linear + (term(a[i], b[j]) + term(a[j], b[i]));
}

/* Output m of a blend, by the header. */
static float blend(const float a[OUTPUTS], const float b[OUTPUTS], const float mask[OUTPUTS], int m)
{
    float d[OUTPUTS], w[OUTPUTS];
    const int second = mask[0] > 0.5f;
    for (int k = 0; k < OUTPUTS; k++) {
        d[k] = a[k] - b[k];
        w[k] = k == 0 && second ? mask[k] - 1.0f : mask[k];
    }
    return (second ? b : a)[m] - product(d, w, m);
}

static int same_bits(float a, float b)
{
    return (isnan(a) && isnan(b)) || float_bits(&a) == float_bits(&b);
}

/* Every term, with zeros, NaN and infinities in all members. */
static void test_terms(enum chain f)
{
    long zeros = 0;
    for (uint64_t seed = 1; seed <= 30; seed++) {
        make_special(seed);
        call_all(f);
        for (int p = 0; p < POINTS; p++) {
            float x[CHAIN_INPUTS][OUTPUTS];
            for (int i = 0; i < CHAIN_INPUTS * OUTPUTS; i++) {
                x[i / OUTPUTS][i % OUTPUTS] = in[i / OUTPUTS][i % OUTPUTS][p];
            }
            for (int m = 0; m < OUTPUTS; m++) {
                const float got = out.array[m][p];
                const float wanted =
                    f == CHAIN_multiply ? product(x[0], x[1], m) : blend(x[0], x[1], x[2], m);
                CHECK(same_bits(got, wanted), "%s: %s of %a, %a, %a is %a, not %a",
                      chain_kinds[f].name, output_names[m], (double)x[0][0], (double)x[1][0],
                      (double)x[2][0], (double)got, (double)wanted);
                zeros += got == 0.0f;
            }
        }
    }
    CHECK(zeros > 1000, "%s: only %ld results are 0", chain_kinds[f].name, zeros);
}

/* A mask of 0 or 1 whose derivatives are 0: all members are those of a or b, to the bit. With
   slopes, the value still is. */
static void test_ends(int slopes)
{
    make_special(7);
    for (int m = 0; m < OUTPUTS; m++) {
        for (int p = 0; p < POINTS; p++) {
            const float zero = p % 4 < 2 ? 0.0f : -0.0f;
            in[2][m][p] = m > 0 ? (slopes ? in[2][m][p] : zero) : p % 2 == 1 ? 1.0f : zero;
        }
    }
    call_all(CHAIN_mix);
    for (int m = 0; m < (slopes ? 1 : OUTPUTS); m++) {
        for (int p = 0; p < POINTS; p++) {
            const float got = out.array[m][p], wanted = in[p % 2][m][p];
            CHECK(same_bits(got, wanted), "a mask of %d: %s is %a, not %a", p % 2, output_names[m],
                  (double)got, (double)wanted);
        }
    }
}

/* A product by 0 without slopes is 0 in all members. */
static void test_nothing(void)
{
    make_special(9);
    for (int m = 0; m < OUTPUTS; m++) {
        for (int p = 0; p < POINTS; p++) {
            in[p % 2][m][p] = p % 4 < 2 ? 0.0f : -0.0f;
        }
    }
    call_all(CHAIN_multiply);
    for (int m = 0; m < OUTPUTS; m++) {
        for (int p = 0; p < POINTS; p++) {
            CHECK(same_bits(out.array[m][p], 0.0f), "%s of 0 is %a", output_names[m],
                  (double)out.array[m][p]);
        }
    }
}

/* Blends by masks in [0, 1] stay between a and b, however large these are. */
static void test_between(void)
{
    uint64_t random = 11;
    for (int round = 0; round < 100; round++) {
        for (int p = 0; p < POINTS; p++) {
            in[0][0][p] = check_random_float(&random, round % 2 == 0 ? 1.0f : 1e10f);
            in[1][0][p] =
                round % 3 == 0 ? nextafterf(in[0][0][p], 2.0f) : check_random_float(&random, 1.0f);
            in[2][0][p] = fabsf(check_random_float(&random, 1.0f));
        }
        call_all(CHAIN_mix);
        for (int p = 0; p < POINTS; p++) {
            const float a = in[0][0][p], b = in[1][0][p], got = out.array[0][p];
            CHECK(got >= fminf(a, b) && got <= fmaxf(a, b), "%a of %a, %a is outside", (double)got,
                  (double)a, (double)b);
        }
    }
}

int main(int argc, char **argv)
{
    check_isa_argument(argc, argv);
    out = outputs_make(POINTS);
    test_terms(CHAIN_multiply);
    test_terms(CHAIN_mix);
    test_ends(0);
    test_ends(1);
    test_nothing();
    test_between();
    outputs_free(&out);
    return check_done();
}
