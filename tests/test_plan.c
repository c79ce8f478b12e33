/* SPDX-License-Identifier: MIT
 *
 * Plans that callers keep: a plan that fits is used, any other changes nothing, and
 * scarp_plan_make refuses what scarp_noise_check refuses. (test_bits.c, test_threads.c and
 * test_fpmode.c use plans, too.)
 *
 *     test_plan ISA
 *     test_plan --must-differ ISA    some result must be wrong: for mutants
 */
#include "../src/plan/kept.h"
#include "api_reserved.h"

#define POINTS 21 /* a block of 16 and a part */

/* Makes a call of each kind; reserved_arguments() says with what. */
static void plan_calls(const struct reserved_test *t, const struct scarp_noise *noise, int call,
                       const struct outputs *o)
{
    const struct reserved_test to = {t->in, t->points, o, NULL};
    struct reserved_arguments a = reserved_arguments(&to, call);
    if (call >= FUNCTIONS) {
        a.grid.origin[0] = 0.37;
        a.grid.step[0] = a.grid.step[1] = a.grid.step[2] = 0.11;
    }
    a.noise = *noise;
    if (noise_order(noise) < 2) {
        a.out.dxx = a.out.dxy = a.out.dxz = a.out.dyy = a.out.dyz = a.out.dzz = NULL;
    }
    if ((outputs_of(noise, SAMPLE2) & OUTPUTS_PHASE) != 0) {
        a.out.dphase = o->array[OUTPUT_dphase];
    }
    outputs_poison(o);
    CHECK(reserved_call(t, call, &a) == SCARP_OK, "call %d", call);
}

static int plan_dimensions(int call)
{
    return call < FUNCTIONS ? function_dimensions((enum function)call) : 2 + call - FUNCTIONS;
}

/* Whether calls with the plan give the bits of calls without. */
static int plan_is_harmless(const struct reserved_test *t, const struct scarp_noise *noise,
                            const struct scarp_plan *plan, int call)
{
    int member = 0;
    size_t index = 0;
    struct scarp_noise with = *noise;
    with.plan = plan;
    plan_calls(t, noise, call, t->one);
    plan_calls(t, &with, call, t->two);
    return outputs_equal(t->one, t->two, ~0u, t->points, &member, &index);
}

static struct scarp_plan plan_of(const struct scarp_noise *noise, int dimensions)
{
    struct scarp_plan plan;
    memset(&plan, POISON, sizeof plan);
    CHECK(scarp_plan_make(noise, dimensions, &plan) == SCARP_OK, "no plan");
    return plan;
}

/* Changes constants of octave 0 and 1. */
static void plan_spoil(struct scarp_plan *plan)
{
    unsigned char *const bytes = (unsigned char *)plan;
    const size_t first = offsetof(struct kept, octave);
    for (size_t i = first; i < first + 400; i++) {
        bytes[i] ^= 0x10;
    }
}

/* A plan, and a copy of it elsewhere, give the same bits, and are what the calls use: if they are
   spoilt, results differ. */
static void test_plan_used(const struct reserved_test *t)
{
    for (int i = 0; i < 8 + count_names(basis_name) - SCARP_SIMPLEX; i++) {
        const struct scarp_noise noise = {
            .fractal = (enum scarp_fractal)(i < 8 ? i / 2 % 4 : i % count_names(fractal_name)),
            .octaves = 3.5f,
            .rotate = (uint32_t)i % 2,
            .seed = (uint64_t)i,
            .period = {i == 2, i == 4 ? 3 : 0, 0},
            .phase = i > 3 && i < 8 && i % 3 != 0 ? 0.4f : 0.0f,
            .jitter = i > 8 ? 0.7f : 0.0f,
            .offset_first = i % 3 == 1,
            .basis = (enum scarp_basis)(i < 8 ? i % 3 == 0 : SCARP_SIMPLEX + i - 8)};
        for (int call = 0; call < RESERVED_CALLS; call++) {
            const struct scarp_plan plan = plan_of(&noise, plan_dimensions(call));
            struct scarp_plan copy = plan;
            CHECK_BITS(plan_is_harmless(t, &noise, &plan, call), "noise %d, call %d", i, call);
            CHECK_BITS(plan_is_harmless(t, &noise, &copy, call), "noise %d, call %d, copy", i,
                       call);
            plan_spoil(&copy);
            CHECK_BITS(!plan_is_harmless(t, &noise, &copy, call),
                       "noise %d, call %d: the plan is unused", i, call);
        }
    }
}

/* Plans of other noises, which differ in one member, or in one bit. */
static void test_plan_stale(const struct reserved_test *t)
{
    static const struct scarp_noise noise = {
        .octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f};
    const struct scarp_noise others[] = {
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .basis = SCARP_VALUE},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .fade = SCARP_CUBIC},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .fractal = SCARP_RIDGED},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .rotate = 1},
        {.octaves = 3.0f, .seed = 2, .frequency = 0.7, .lacunarity = 1.9f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.8, .lacunarity = 1.9f},
        {.octaves = 2.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.8f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .gain = 0.6f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .amplitude = 2.0f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .phase = 0.25f},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 2.0f, .period = {0, 3}},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .offset_first = 1},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .basis = SCARP_SIMPLEX},
        {.octaves = 3.0f, .seed = 1, .frequency = 0.7, .lacunarity = 1.9f, .basis = SCARP_CELL_F1}};
    for (int call = 0; call < RESERVED_CALLS; call++) {
        const int dimensions = plan_dimensions(call);
        for (size_t i = 0; i < sizeof others / sizeof others[0]; i++) {
            const struct scarp_plan plan = plan_of(&others[i], dimensions);
            CHECK_BITS(plan_is_harmless(t, &noise, &plan, call), "call %d, plan of noise %zu", call,
                       i);
        }
        const struct scarp_plan other = plan_of(&noise, 5 - dimensions);
        CHECK_BITS(plan_is_harmless(t, &noise, &other, call), "call %d, plan of the other space",
                   call);
    }
}

/* Plans that no call has made: of one byte all over, random, and good ones of which one bit of the
   version, the dimensions or the noise is another one while all constants are spoilt. */
static void test_plan_garbage(const struct reserved_test *t)
{
    const struct scarp_noise noise = {.octaves = 2.0f};
    static const int fills[] = {0, 0xff, 0x77, 1};
    struct scarp_plan plan;
    unsigned char *const bytes = (unsigned char *)&plan;
    uint64_t state = 1;
    for (int call = 0; call < RESERVED_CALLS; call++) {
        for (size_t i = 0; i < sizeof fills / sizeof fills[0]; i++) {
            memset(&plan, fills[i], sizeof plan);
            CHECK_BITS(plan_is_harmless(t, &noise, &plan, call), "call %d, all %d", call, fills[i]);
        }
        for (size_t i = 0; i < sizeof plan; i++) {
            bytes[i] = (unsigned char)check_random(&state);
        }
        CHECK_BITS(plan_is_harmless(t, &noise, &plan, call), "call %d, random bytes", call);
    }
    plan = plan_of(&noise, 2);
    plan_spoil(&plan);
    const size_t pointers = 8 + offsetof(struct scarp_noise, warp);
    for (size_t bit = 0; bit < 8 * (8 + sizeof noise); bit++) {
        if (bit / 8 >= pointers && bit / 8 < pointers + 2 * sizeof(void *)) {
            continue; /* what is there is not compared */
        }
        bytes[bit / 8] ^= (unsigned char)(1u << bit % 8);
        CHECK_BITS(plan_is_harmless(t, &noise, &plan, SAMPLE2), "bit %zu is not looked at", bit);
        bytes[bit / 8] ^= (unsigned char)(1u << bit % 8);
    }
    CHECK_BITS(!plan_is_harmless(t, &noise, &plan, SAMPLE2), "the spoilt plan does not fit");
}

/* What scarp_plan_make refuses, and that it writes nothing then. A good plan does not make calls
   take a noise that they must refuse. */
static void test_plan_refused(const struct reserved_test *t)
{
    const struct scarp_noise good = {.octaves = 2.0f};
    const struct scarp_noise loop = {.warp = &loop};
    const struct scarp_noise bad[] = {{.basis = (enum scarp_basis)77},
                                      {.fade = (enum scarp_fade)9},
                                      {.fractal = (enum scarp_fractal)99},
                                      {.octaves = 33.0f},
                                      {.octaves = NAN},
                                      {.frequency = -1.0},
                                      {.phase = NAN},
                                      {.phase = 1.0f, .basis = SCARP_VALUE},
                                      {.phase = 1.0f, .basis = SCARP_CELL_SOFT},
                                      {.jitter = 1.5f},
                                      {.period = {0, 0x40000001, 0}},
                                      {.sharpness = 0x1p25f},
                                      {.octaves = 3.0f, .of_octaves = 2.9f},
                                      {.warp = &loop},
                                      {.spare_word = 1},
                                      {.spare = {1}}};
    struct scarp_plan plan = plan_of(&good, 2);
    const struct scarp_plan before = plan;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        for (int dimensions = 1; dimensions <= 4; dimensions++) {
            CHECK(scarp_plan_make(&bad[i], dimensions, &plan) ==
                      scarp_noise_check(&bad[i], dimensions, NULL),
                  "noise %zu, %d dimensions", i, dimensions);
        }
        struct scarp_noise noise = bad[i];
        noise.plan = &plan;
        const struct scarp_samples out = outputs_subset(t->one, OUTPUTS_ALL2);
        outputs_poison(t->one);
        CHECK(function_call(SAMPLE2, &noise, t->points, t->in, &out) ==
                  scarp_noise_check(&bad[i], 2, NULL),
              "noise %zu with the plan of another", i);
        CHECK(outputs_untouched(t->one, ~0u), "noise %zu: outputs were written", i);
    }
    CHECK(scarp_plan_make(NULL, 2, &plan) == SCARP_ERROR_NULL, "no noise");
    CHECK(scarp_plan_make(&good, 2, NULL) == SCARP_ERROR_NULL, "no plan");
    CHECK(scarp_plan_make(&good, 4, &plan) == SCARP_ERROR_PARAMETER, "4 dimensions");
    CHECK(memcmp(&plan, &before, sizeof plan) == 0, "a plan was written");
    struct scarp_noise erosion = {.fractal = SCARP_EROSION};
    plan = plan_of(&erosion, 2);
    erosion.plan = &plan;
    const struct scarp_samples hessian = {.dxx = t->one->array[0]};
    CHECK(function_call(SAMPLE2, &erosion, 1, t->in, &hessian) == SCARP_ERROR_UNSUPPORTED,
          "the plan of an erosion gives it a Hessian");
    struct scarp_noise value = {.basis = SCARP_VALUE};
    plan = plan_of(&value, 2);
    value.plan = &plan;
    const struct scarp_samples turning = {.dphase = t->one->array[0]};
    CHECK(function_call(SAMPLE2, &value, 1, t->in, &turning) == SCARP_ERROR_UNSUPPORTED,
          "the plan of value noise gives it a phase");
}

int main(int argc, char **argv)
{
    static float f[3][POINTS];
    static double d[3][POINTS];
    static const struct inputs in = {{f[0], f[1], f[2]}, {d[0], d[1], d[2]}};
    struct outputs one = outputs_make(POINTS), two = outputs_make(POINTS);
    const struct reserved_test t = {&in, POINTS, &one, &two};
    uint64_t state = 1;
    argc = check_take_aim(argc, &argv);
    check_select_isa(argc > 1 ? argv[1] : "scalar");
    for (int i = 0; i < 3 * POINTS; i++) {
        f[i % 3][i / 3] = check_random_float(&state, 64.0f);
        d[i % 3][i / 3] = check_random_double(&state, 0x1p20);
    }
    test_plan_used(&t);
    test_plan_stale(&t);
    test_plan_garbage(&t);
    if (check_aim == CHECK_SAME) { /* a mutant may crash on a noise that it has to refuse */
        test_plan_refused(&t);
    }
    outputs_free(&one);
    outputs_free(&two);
    return check_done();
}
