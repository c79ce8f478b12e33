/* SPDX-License-Identifier: MIT
 *
 * scarp_vector2 and its like: all sets have the bits of the scalar one, whatever is asked for of
 * which component, at any number of points from any element on, in place too; components are those
 * that scarp.h describes, which the oracle makes in double; the first, and those of noise whose
 * components share no lattice, have the bits of samples; warps move points by them; what is
 * refused.
 *
 *     test_vector ISA
 *     test_vector --must-differ ISA   the same, but sets, or warps, must differ: for mutants
 */
#include "fractal.h"
#include "vectors.h"

static struct outputs here[3], there[3];
static struct block *points;

static struct inputs inputs_at(size_t first)
{
    const struct inputs in = {{points->f[0] + first, points->f[1] + first, points->f[2] + first},
                              {points->d[0] + first, points->d[1] + first, points->d[2] + first}};
    return in;
}

/* Asks for outputs of each component, at `count` points from `first` on. */
static void find(struct outputs to[3], const struct scarp_noise *noise, enum function f,
                 const unsigned wanted[3], size_t first, size_t count)
{
    struct scarp_samples out[3];
    const struct inputs in = inputs_at(first);
    for (int i = 0; i < 3; i++) {
        outputs_poison(&to[i]);
        out[i] = outputs_subset(&to[i], wanted[i]);
    }
    const enum scarp_status status = vector_call(f, noise, count, &in, out);
    CHECK(status == SCARP_OK, "%s: %s", function_names[f], scarp_status_text(status));
}

static void find_all(struct outputs to[3], const struct scarp_noise *noise, enum function f)
{
    const unsigned all = outputs_of(noise, f), wanted[3] = {all, all, all};
    find(to, noise, f, wanted, 0, BLOCK);
}

/* Compares outputs of a component with samples from `first` on. */
static void compare(const struct outputs *a, const struct outputs *b, unsigned wanted, size_t first,
                    size_t count, const char *what)
{
    for (int m = 0; m < OUTPUTS; m++) {
        if ((wanted >> m & 1) != 0) {
            const size_t i = first_difference(a->array[m] + first, b->array[m], count);
            CHECK_BITS(i == count, "%s: %s[%zu] of %zu", what, output_names[m], i, count);
        }
    }
}

static void test_bits(const struct scarp_noise *noise, enum function f, enum scarp_isa isa)
{
    find_all(here, noise, f);
    CHECK(scarp_isa_select(SCARP_ISA_SCALAR) == SCARP_OK, "scalar");
    find_all(there, noise, f);
    CHECK(scarp_isa_select(isa) == SCARP_OK, "back");
    for (int i = 0; i < function_dimensions(f); i++) {
        compare(&there[i], &here[i], outputs_of(noise, f), 0, BLOCK, "scalar");
    }
}

/* Any outputs of any components change nothing, and nothing else is written. */
static void test_choices(const struct scarp_noise *noise, enum function f)
{
    uint64_t state = noise->seed;
    const unsigned all = outputs_of(noise, f);
    find_all(here, noise, f);
    for (size_t round = 1; round < 80; round++) {
        unsigned wanted[3];
        for (int i = 0; i < 3; i++) {
            wanted[i] = round % 3 == 0 ? 1u : all & (unsigned)check_random(&state);
        }
        const size_t count = round % 4 == 0 ? (size_t)(check_random(&state) % BLOCK) : round;
        const size_t first = (size_t)(check_random(&state) % (BLOCK - count));
        find(there, noise, f, wanted, first, count);
        for (int i = 0; i < function_dimensions(f); i++) {
            compare(&here[i], &there[i], wanted[i], first, count, "choice");
            CHECK(outputs_untouched(&there[i], ~wanted[i]), "choice: written");
        }
    }
}

/* The noise that a component is, if it is noise of its own. */
static int component_is_noise(struct scarp_noise *component, const struct scarp_noise *noise, int i)
{
    const uint64_t number = 33u + (blends_corners(noise->basis) ? 0u : (unsigned)i);
    *component = *noise;
    component->seed = check_random_number(check_random_number(noise->seed, 1), number);
    return i == 0 || !blends_corners(noise->basis);
}

static void test_samples(const struct scarp_noise *noise, enum function f)
{
    find_all(here, noise, f);
    for (int i = 0; i < function_dimensions(f); i++) {
        struct scarp_noise component;
        if (component_is_noise(&component, noise, i)) {
            block_sample(points, &component, f, BLOCK);
            compare(&points->out, &here[i], outputs_of(noise, f), 0, BLOCK, "samples");
        }
    }
}

/* The largest difference of values */
static double farthest(const float *a, const float *b)
{
    double most = 0.0;
    for (size_t i = 0; i < BLOCK; i++) {
        most = larger(most, fabs((double)a[i] - (double)b[i]));
    }
    return most;
}

/* Warped noise is noise at the points that its warp moves: floats to the bit. Doubles are displaced
   within their cells, which rounds in other places: by 2^-23 cells at most, with slopes below 4. */
static void test_warps(const struct scarp_noise *noise, enum function f)
{
    const struct scarp_noise plain = {.seed = 77, .octaves = 2.0f};
    struct scarp_noise warped = plain;
    struct block *const moved = block_make();
    warped.warp = noise;
    find_all(here, noise, f);
    for (int axis = 0; axis < function_dimensions(f); axis++) {
        for (size_t i = 0; i < BLOCK; i++) {
            moved->f[axis][i] = points->f[axis][i] + here[axis].array[OUTPUT_value][i];
            moved->d[axis][i] = points->d[axis][i] + (double)here[axis].array[OUTPUT_value][i];
        }
    }
    block_sample(moved, &plain, f, BLOCK);
    block_sample(points, &warped, f, BLOCK);
    if (function_doubles(f)) {
        const double off =
            farthest(points->out.array[OUTPUT_value], moved->out.array[OUTPUT_value]);
        CHECK_BITS(off < 1e-6, "warps of doubles: off by %g", off);
    } else {
        compare(&points->out, &moved->out, 1, 0, BLOCK, "warps");
    }
    block_free(moved);
}

/* Outputs may be where coordinates are. */
static void test_in_place(const struct scarp_noise *noise, enum function f)
{
    static float x[3][BLOCK];
    const struct inputs in = {.f = {x[0], x[1], x[2]}};
    const unsigned all = outputs_of(noise, f);
    find_all(here, noise, f);
    memcpy(x, points->f, sizeof x);
    struct scarp_samples out[3];
    for (int i = 0; i < 3; i++) {
        out[i] = outputs_subset(&there[i], all & ~1u);
        out[i].value = x[(i + 1) % 3];
    }
    if (function_dimensions(f) == 2) {
        out[1].value = x[0];
    }
    CHECK(vector_call(f, noise, BLOCK, &in, out) == SCARP_OK, "in place");
    for (int i = 0; i < function_dimensions(f); i++) {
        const size_t at = first_difference(out[i].value, here[i].array[OUTPUT_value], BLOCK);
        CHECK(at == BLOCK, "%s, component %d in place: value[%zu]", function_names[f], i, at);
        compare(&here[i], &there[i], all & ~1u, 0, BLOCK, "in place");
    }
}

/* Components are those of the oracle, in value and derivatives, but for rounding: creases apart,
   where few points have other derivatives. */
static void test_oracle(const struct scarp_noise *noise, enum function f)
{
    const int n = function_dimensions(f);
    static struct oracle oracle;
    if (noise->warp != NULL || noise->fractal != SCARP_FBM || noise->octaves > 4.0f) {
        return;
    }
    find_all(here, noise, f);
    for (int i = 0; i < n; i++) {
        double worst[3] = {0.0, 0.0, 0.0};
        oracle_make_component(&oracle, noise, n, i);
        for (size_t at = 0; at < BLOCK; at++) {
            double x[3] = {0.0, 0.0, 0.0}, off[3];
            struct oracle_sample expected;
            for (int axis = 0; axis < n; axis++) {
                x[axis] = points->d[axis][at];
            }
            oracle_evaluate(&oracle, ORACLE_F64, x, &expected);
            const struct oracle_sample got = outputs_sample(&here[i], noise, f, at);
            difference(&got, &expected, off);
            for (int k = 0; k < 3; k++) {
                worst[k] = larger(worst[k], off[k]);
            }
        }
        CHECK(worst[0] < 3e-6 && worst[1] < 1e-4 && worst[2] < 2e-3,
              "noise %d, component %d: off by %g, %g, %g", (int)noise->seed, i, worst[0], worst[1],
              worst[2]);
    }
}

/* Points that are nowhere have NaN in all outputs. */
static void test_special(const struct scarp_noise *noise, enum function f)
{
    struct block *const block = block_make();
    struct block *const usual = points;
    memcpy(block->f, points->f, sizeof block->f);
    memcpy(block->d, points->d, sizeof block->d);
    for (size_t i = 0; i < BLOCK; i += 3) {
        const int axis = (int)(i / 3) % function_dimensions(f);
        block->f[axis][i] = i % 2 == 0 ? NAN : INFINITY;
        block->d[axis][i] = (double)block->f[axis][i];
    }
    find_all(here, noise, f);
    points = block;
    find_all(there, noise, f);
    points = usual;
    for (int i = 0; i < function_dimensions(f); i++) {
        for (int m = 0; m < OUTPUTS; m++) {
            for (size_t at = 0; (outputs_of(noise, f) >> m & 1) != 0 && at < BLOCK; at++) {
                const float *const got = &there[i].array[m][at];
                CHECK(at % 3 == 0 ? is_nan_bits(got)
                                  : float_bits(got) == float_bits(&here[i].array[m][at]),
                      "%s, component %d: %s[%zu] is %g", function_names[f], i, output_names[m], at,
                      (double)*got);
            }
        }
    }
    block_free(block);
}

static void expect(enum function f, const struct scarp_noise *noise,
                   const struct scarp_samples *out, enum scarp_status wanted, const char *what)
{
    const struct inputs in = inputs_at(0);
    const enum scarp_status status = vector_call(f, noise, BLOCK, &in, out);
    CHECK(status == wanted, "%s, %s: %s", function_names[f], what, scarp_status_text(status));
}

/* What each component may not ask for. */
static void test_asked(enum function f, struct scarp_samples *out, int component)
{
    const struct scarp_noise good = {.seed = 1}, value = {.basis = SCARP_VALUE};
    const struct scarp_noise swiss = {.fractal = SCARP_SWISS}, bent = {.warp = &swiss};
    struct scarp_samples *const of = &out[component];
    const struct scarp_samples usual = *of;
    float *const to = there[0].array[OUTPUT_dx];
    of->spare[4] = to;
    expect(f, &good, out, SCARP_ERROR_UNSUPPORTED, "spare");
    *of = usual;
    of->dphase = to;
    expect(f, &value, out, SCARP_ERROR_UNSUPPORTED, "no phase");
    *of = usual;
    of->dxy = to;
    expect(f, &swiss, out, SCARP_ERROR_UNSUPPORTED, "no Hessian");
    expect(f, &bent, out, SCARP_ERROR_UNSUPPORTED, "no Hessian of the warp");
    *of = usual;
    of->dz = to;
    if (function_dimensions(f) == 2) {
        expect(f, &good, out, SCARP_ERROR_UNSUPPORTED, "z in the plane");
    }
    *of = usual;
}

static void test_refused(enum function f)
{
    const struct scarp_noise good = {.seed = 1}, bad_warp = {.octaves = 99.0f};
    const struct scarp_noise bad[] = {{.basis = (enum scarp_basis)77},
                                      {.octaves = 99.0f},
                                      {.warp = &bad_warp},
                                      {.spare = {1}},
                                      {.phase = 1.0f, .basis = SCARP_VALUE}};
    const size_t huge =
        (size_t)PTRDIFF_MAX / (function_doubles(f) ? sizeof(double) : sizeof(float)) + 1;
    struct scarp_samples out[3];
    struct inputs in = inputs_at(0);
    for (int i = 0; i < 3; i++) {
        outputs_poison(&there[i]);
        out[i] = outputs_subset(&there[i], 1);
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        expect(f, &bad[i], out, scarp_noise_check(&bad[i], function_dimensions(f), NULL), "bad");
    }
    expect(f, NULL, out, SCARP_ERROR_NULL, "no noise");
    expect(f, &good, NULL, SCARP_ERROR_NULL, "no outputs");
    for (int i = 0; i < function_dimensions(f); i++) {
        test_asked(f, out, i);
    }
    CHECK(vector_call(f, &good, huge, &in, out) == SCARP_ERROR_SIZE, "huge");
    CHECK(vector_call(f, NULL, 0, &in, NULL) == SCARP_OK, "no points");
    in.f[1] = NULL;
    in.d[1] = NULL;
    CHECK(vector_call(f, &good, 3, &in, out) == SCARP_ERROR_NULL, "no y");
    for (int i = 0; i < 3; i++) {
        CHECK(outputs_untouched(&there[i], ~0u), "an error has written something");
    }
    const struct scarp_samples nothing[3] = {{.value = NULL}};
    expect(f, &good, nothing, SCARP_OK, "nothing asked for");
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    const enum scarp_isa isa = check_select_isa(argc > 1 ? argv[1] : "scalar");
    uint64_t random = 1;
    points = block_make();
    for (int i = 0; i < 3; i++) {
        here[i] = outputs_make(BLOCK);
        there[i] = outputs_make(BLOCK);
    }
    for (int i = 0; i < VECTORS * FUNCTIONS && !check_enough(); i++) {
        const struct scarp_noise *const noise = &vector_noises[i / FUNCTIONS];
        const enum function f = (enum function)(i % FUNCTIONS);
        block_random(points, &random, 64.0f);
        test_bits(noise, f, isa);
        test_samples(noise, f);
        test_warps(noise, f);
        test_choices(noise, f);
        if (check_aim == CHECK_SAME) {
            test_special(noise, f);
        }
        if (check_aim == CHECK_SAME && !function_doubles(f)) {
            test_in_place(noise, f);
        } else if (check_aim == CHECK_SAME) {
            test_oracle(noise, f);
        }
    }
    for (int f = 0; f < FUNCTIONS && check_aim == CHECK_SAME; f++) {
        test_refused((enum function)f);
    }
    for (int i = 0; i < 3; i++) {
        outputs_free(&here[i]);
        outputs_free(&there[i]);
    }
    block_free(points);
    return check_done();
}
