/* SPDX-License-Identifier: MIT
 *
 * The chain rule over samples: every kernel set has the bits of the scalar reference, for any
 * number of points, any choice of outputs, and in place; what is refused. What the functions
 * compute is tested by test_chain_rule.c.
 *
 *     test_chain [--must-differ] ISA
 */
#include "chain.h"

#define POINTS 1061 /* four blocks and a tail */
#define SHORT 70
#define ARRAYS (CHAIN_INPUTS * OUTPUTS + CHAIN_PARTIALS)

static float source[ARRAYS][POINTS];  /* never written after the start */
static float scratch[ARRAYS][POINTS]; /* copies of these, for calls in place */
static struct outputs reference, tested;

/* The arrays of the inputs, from element `first` on. */
struct arguments {
    struct scarp_samples in[CHAIN_INPUTS];
    struct scarp_partials partials;
};

static struct scarp_samples samples_at(float (*arrays)[POINTS], size_t first)
{
    const struct scarp_samples s = {arrays[0] + first, arrays[1] + first,  arrays[2] + first,
                                    arrays[3] + first, arrays[4] + first,  arrays[5] + first,
                                    arrays[6] + first, arrays[7] + first,  arrays[8] + first,
                                    arrays[9] + first, arrays[10] + first, {NULL}};
    return s;
}

static struct arguments arguments_at(float (*arrays)[POINTS], size_t first)
{
    float(*const p)[POINTS] = arrays + CHAIN_INPUTS * OUTPUTS;
    const struct arguments a = {{samples_at(arrays, first), samples_at(arrays + OUTPUTS, first),
                                 samples_at(arrays + 2 * OUTPUTS, first)},
                                {p[0] + first,
                                 p[1] + first,
                                 p[2] + first,
                                 p[3] + first,
                                 p[4] + first,
                                 p[5] + first,
                                 {NULL}}};
    return a;
}

static enum scarp_status call_at(enum chain f, const struct arguments *a, size_t count,
                                 const struct scarp_samples *out)
{
    return chain_call(f, count, a->in, &a->partials, out);
}

/* Random numbers, and now and then one where functions have seams or numbers end. */
static void make_sources(void)
{
    static const float special[] = {NAN,       -NAN,    INFINITY, -INFINITY, 0.0f,     -0.0f,
                                    0x1p-149f, -1e-40f, 3e38f,    -3e38f,    1e20f,    -0x1p23f,
                                    -0.4f,     0.3f,    0.5f,     -0.25f,    0x1p-24f, 1.0f};
    uint64_t state = 1;
    for (int i = 0; i < ARRAYS; i++) {
        for (int p = 0; p < POINTS; p++) {
            const uint64_t draw = check_random(&state);
            source[i][p] = check_random_float(&state, draw % 8 == 0 ? 4.0f : 1.0f);
            if (draw % 29 == 1) {
                source[i][p] = special[draw / 29 % (sizeof special / sizeof special[0])];
            }
        }
    }
    for (int p = 0; p < POINTS; p += 11) { /* equal values */
        source[OUTPUTS][p] = source[0][p];
    }
}

/* Compares elements [first, first + count) of the outputs in `mask`; nothing else is written. */
static void compare(enum chain f, unsigned mask, size_t first, size_t count)
{
    for (int m = 0; m < OUTPUTS; m++) {
        const float *const expected = reference.array[m] + first;
        const float *const got = tested.array[m] + first;
        const size_t written = (mask >> m & 1) != 0 ? count : 0;
        const size_t at = first_difference(expected, got, written);
        CHECK_BITS(at == written, "%s, %zu points: %s[%zu] is %a, not %a", chain_kinds[f].name,
                   count, output_names[m], at, (double)got[at], (double)expected[at]);
        CHECK(all_poison(tested.array[m], first * sizeof(float)) &&
                  all_poison(got + written, (POINTS - first - written) * sizeof(float)),
              "%s, %zu points: wrote beyond %s", chain_kinds[f].name, count, output_names[m]);
    }
}

static unsigned random_mask(uint64_t *state)
{
    return (unsigned)(check_random(state) >> 20) & ((1u << OUTPUTS) - 1);
}

/* All points, then any number of all outputs, of only the value or of any, from anywhere on. */
static void test_bits(enum chain f, enum scarp_isa isa)
{
    const struct arguments a = arguments_at(source, 0);
    const unsigned all = (1u << OUTPUTS) - 1;
    struct scarp_samples out = outputs_subset(&reference, all);
    uint64_t state = (uint64_t)f;
    scarp_isa_select(SCARP_ISA_SCALAR);
    CHECK(call_at(f, &a, POINTS, &out) == SCARP_OK, "%s", chain_kinds[f].name);
    scarp_isa_select(isa);
    for (size_t round = 0; round < 300; round++) {
        const size_t count = round == 0       ? POINTS
                             : round <= SHORT ? round
                                              : check_random(&state) % POINTS;
        const size_t first = check_random(&state) % (POINTS - count + 1);
        const unsigned mask = round % 3 == 0 ? all : round % 3 == 1 ? 1 : random_mask(&state);
        const struct arguments from = arguments_at(source, first);
        out = outputs_at(&tested, mask, first);
        outputs_poison(&tested);
        CHECK(call_at(f, &from, count, &out) == SCARP_OK, "%s", chain_kinds[f].name);
        compare(f, mask, first, count);
    }
}

/* Each output goes to an array that was drawn among all that are read. */
static void test_in_place(enum chain f)
{
    uint64_t state = 7 + (uint64_t)f;
    for (int round = 0; round < 60; round++) {
        const size_t count = round % 2 == 0 ? check_random(&state) % SHORT : POINTS;
        const struct arguments a = arguments_at(scratch, 0);
        int drawn[ARRAYS];
        memcpy(scratch, source, sizeof source);
        outputs_poison(&tested);
        for (int i = 0; i < ARRAYS; i++) {
            const int j = (int)(check_random(&state) % (uint64_t)(i + 1));
            drawn[i] = drawn[j];
            drawn[j] = i;
        }
        struct outputs shared = {.capacity = POINTS};
        for (int m = 0; m < OUTPUTS; m++) {
            shared.array[m] = scratch[round % 4 == 0 ? m : drawn[m]];
        }
        const struct scarp_samples out = outputs_subset(&shared, (1u << OUTPUTS) - 1);
        CHECK(call_at(f, &a, count, &out) == SCARP_OK, "%s", chain_kinds[f].name);
        for (int m = 0; m < OUTPUTS; m++) {
            const size_t at = first_difference(shared.array[m], reference.array[m], count);
            CHECK_BITS(at == count, "%s in place: %s[%zu]", chain_kinds[f].name, output_names[m],
                       at);
        }
    }
}

/* Whether output m needs member n of the inputs, as scarp.h says. */
static int needs(enum chain f, int m, int n)
{
    const int linear = f == CHAIN_affine || f == CHAIN_add;
    if (n == OUTPUT_value && chain_kinds[f].partials) {
        return 0;
    }
    if (n == m || linear) {
        return n == m;
    }
    for (int axis = 0; output_kinds[m].order == 2 && axis < 2; axis++) {
        if (n == OUTPUT_dx + output_kinds[m].axes[axis]) {
            return 1;
        }
    }
    return n == OUTPUT_value;
}

static int needs_partial(enum chain f, int m, int n)
{
    static const int order_of[CHAIN_PARTIALS] = {0, 1, 1, 2, 2, 2};
    const int by_b = n == 2 || n == 4 || n == 5;
    const int order = output_kinds[m].order;
    return chain_kinds[f].partials && !(by_b && f == CHAIN_apply1) &&
           (order == 0 ? n == 0 : n > 0 && order_of[n] <= order);
}

/* Each output is computed from the arrays that it needs, and no call does without one of these. */
static void test_needed(enum chain f)
{
    for (int m = 0; m < OUTPUTS; m++) {
        for (int without = -1; without < ARRAYS; without++) {
            struct arguments a = arguments_at(source, 0);
            int missing = 0;
            for (int i = 0; i < ARRAYS; i++) {
                const int input = i / OUTPUTS;
                const int needed = input == CHAIN_INPUTS
                                       ? needs_partial(f, m, i % OUTPUTS)
                                       : input < chain_kinds[f].inputs && needs(f, m, i % OUTPUTS);
                if (!needed || i == without) {
                    const float **const array =
                        input == CHAIN_INPUTS ? &(&a.partials.f)[i % OUTPUTS] : NULL;
                    if (array != NULL) {
                        *array = NULL;
                    } else {
                        (&a.in[input].value)[i % OUTPUTS] = NULL;
                    }
                    missing |= needed;
                }
            }
            const struct scarp_samples out = outputs_subset(&tested, 1u << m);
            outputs_poison(&tested);
            const enum scarp_status status = call_at(f, &a, POINTS, &out);
            CHECK(status == (missing ? SCARP_ERROR_NULL : SCARP_OK), "%s: %s without %d: %s",
                  chain_kinds[f].name, output_names[m], without, scarp_status_text(status));
            compare(f, missing ? 0 : 1u << m, 0, POINTS);
        }
    }
}

static void expect(enum scarp_status got, enum scarp_status wanted, const char *what)
{
    CHECK(got == wanted, "%s: %s", what, scarp_status_text(got));
}

/* What every function refuses. */
static void test_refused(enum chain f)
{
    const size_t huge[] = {(size_t)PTRDIFF_MAX / sizeof(float) + 1, SIZE_MAX / 2, SIZE_MAX};
    const struct arguments good = arguments_at(source, 0);
    struct scarp_samples out = outputs_subset(&tested, (1u << OUTPUTS) - 1);
    const struct scarp_samples nothing = {0};
    struct arguments a = good;
    outputs_poison(&tested);
    for (int i = 0; i < 3; i++) {
        expect(call_at(f, &good, huge[i], &out), SCARP_ERROR_SIZE, chain_kinds[f].name);
    }
    expect(call_at(f, &good, POINTS, NULL), SCARP_ERROR_NULL, chain_kinds[f].name);
    expect(call_at(f, &good, 0, NULL), SCARP_OK, chain_kinds[f].name);
    expect(call_at(f, &good, POINTS, &nothing), SCARP_OK, chain_kinds[f].name);
    for (int i = 0; i < 5; i++) {
        out.spare[i] = source[0];
        expect(call_at(f, &good, POINTS, &out), SCARP_ERROR_UNSUPPORTED, "spare of out");
        out.spare[i] = NULL;
        for (int k = 0; k < chain_kinds[f].inputs; k++) {
            a = good;
            a.in[k].spare[i] = source[0];
            expect(call_at(f, &a, POINTS, &out), SCARP_ERROR_UNSUPPORTED, "spare of an input");
        }
    }
    for (int i = 0; chain_kinds[f].partials && i < 2; i++) {
        a = good;
        a.partials.spare[i] = source[0];
        expect(call_at(f, &a, POINTS, &out), SCARP_ERROR_UNSUPPORTED, "spare of partials");
    }
    CHECK(outputs_untouched(&tested, (1u << OUTPUTS) - 1), "%s wrote", chain_kinds[f].name);
}

/* An input, or the partial derivatives, that is NULL */
static void test_null(enum chain f)
{
    const struct arguments good = arguments_at(source, 0);
    const struct scarp_samples out = outputs_subset(&tested, 1);
    outputs_poison(&tested);
    for (size_t n = 0; n <= 9; n += 9) {
        const enum scarp_status wanted = n == 0 ? SCARP_OK : SCARP_ERROR_NULL;
        for (int without = 0; without < chain_kinds[f].inputs + chain_kinds[f].partials;
             without++) {
            const struct scarp_samples *in[CHAIN_INPUTS] = {&good.in[0], &good.in[1], &good.in[2]};
            const int is_input = without < chain_kinds[f].inputs;
            if (is_input) {
                in[without] = NULL;
            }
            expect(chain_call_with(f, chain_kinds[f].number, n, in,
                                   is_input ? &good.partials : NULL, &out),
                   wanted, chain_kinds[f].name);
        }
    }
    CHECK(outputs_untouched(&tested, 1), "%s wrote", chain_kinds[f].name);
}

/* What each kind of numbers takes and refuses; `other` is for numbers of a kind that goes with it. */
static const struct {
    char kind;
    float other, good[3], bad[4];
} number_kinds[] = {
    {'f', 0.0f, {0.0f, -3e38f, 1e-45f}, {NAN, NAN, NAN, NAN}},
    {'l', -3.4e38f, {0.0f, -3e38f, 1e-45f}, {NAN, NAN, NAN, NAN}},
    {'h', 3.4e38f, {0.0f, 3e38f, 1e-45f}, {NAN, NAN, NAN, NAN}},
    {'w', 0.0f, {0x1p-60f, -0x1p60f, -0x1p-60f}, {0.0f, -0.0f, 0x1.fffffep-61f, -0x1.000002p60f}},
    {'s', 1.0f, {0x1p-60f, 0x1p60f, 1.0f}, {0.0f, -1.0f, 0x1.fffffep-61f, 0x1.000002p60f}},
    {'r', 1.0f, {0x1p-20f, 1.0f, 0.5f}, {0.0f, -1.0f, 0x1.fffffep-21f, 0x1.000002p0f}},
    {'u', 1.0f, {0.0f, 1.0f, 1e-45f}, {-1e-45f, -1.0f, 2.0f, 0x1.000002p0f}},
};

static int number_kind(char kind)
{
    int i = 0;
    while (number_kinds[i].kind != kind) {
        i++;
    }
    return i;
}

/* A call with a number that is to be tried in each place; the others are valid. */
static void test_numbers(enum chain f)
{
    static const float never[] = {NAN, -NAN, INFINITY, -INFINITY};
    const struct arguments good = arguments_at(source, 0);
    const struct scarp_samples *const in[CHAIN_INPUTS] = {&good.in[0], &good.in[1], &good.in[2]};
    const struct scarp_samples out = outputs_subset(&tested, (1u << OUTPUTS) - 1);
    const char *const kinds = chain_kinds[f].kinds;
    for (int place = 0; kinds[place] != '\0'; place++) {
        const int kind = number_kind(kinds[place]);
        float k[3] = {0.0f, 0.0f, 0.0f};
        for (int i = 0; kinds[i] != '\0'; i++) {
            k[i] = number_kinds[number_kind(kinds[i])].other;
        }
        for (int n = 0; n < 3; n++) {
            k[place] = number_kinds[kind].good[n];
            expect(chain_call_with(f, k, 9, in, NULL, &out), SCARP_OK, "good number");
        }
        outputs_poison(&tested);
        for (int n = 0; n < 4; n++) {
            k[place] = never[n];
            expect(chain_call_with(f, k, 9, in, NULL, &out), SCARP_ERROR_PARAMETER, "not finite");
            k[place] = number_kinds[kind].bad[n];
            expect(chain_call_with(f, k, 9, in, NULL, &out), SCARP_ERROR_PARAMETER, "bad");
        }
        CHECK(outputs_untouched(&tested, (1u << OUTPUTS) - 1), "%s wrote", chain_kinds[f].name);
    }
}

static void test_intervals(void)
{
    const struct arguments good = arguments_at(source, 0);
    const struct scarp_samples out = outputs_subset(&tested, (1u << OUTPUTS) - 1);
    expect(scarp_clamp(9, &good.in[0], 1.0f, 0.5f, &out), SCARP_ERROR_PARAMETER, "lo > hi");
    expect(scarp_clamp(9, &good.in[0], 1.0f, 1.0f, &out), SCARP_OK, "lo == hi");
    expect(scarp_smoothstep(9, &good.in[0], 3e38f, -3e38f, &out), SCARP_ERROR_PARAMETER, "wide");
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    const enum scarp_isa isa = check_isa_argument(argc, argv);
    reference = outputs_make(POINTS);
    tested = outputs_make(POINTS);
    make_sources();
    for (int f = 0; f < CHAINS && !check_enough(); f++) {
        test_bits((enum chain)f, isa);
        test_in_place((enum chain)f);
        if (check_aim == CHECK_SAME) {
            test_needed((enum chain)f);
            test_refused((enum chain)f);
            test_null((enum chain)f);
            test_numbers((enum chain)f);
        }
    }
    test_intervals();
    outputs_free(&reference);
    outputs_free(&tested);
    return check_done();
}
