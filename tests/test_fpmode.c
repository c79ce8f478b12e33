/* SPDX-License-Identifier: MIT
 *
 * The caller's floating-point mode neither changes results nor is changed: flush to zero, denormals
 * are zero, every rounding direction, unmasked exceptions. Built a second time with -ffast-math,
 * which makes a program start with denormals flushed.
 *
 *     test_fpmode ISA             every mode that can be set here
 *     test_fpmode --started ISA   only the mode that the program started with, which must flush
 *                                 denormals
 *
 * Numbers are compared by their bits: the second build believes that NaN does not exist.
 */
#include "chain.h"
#include "fpmode_set.h"
#include "gullies.h"

#define POINTS 203

static float x32[3][POINTS];
static double x64[3][POINTS];
static const struct inputs in = {{x32[0], x32[1], x32[2]}, {x64[0], x64[1], x64[2]}};
static struct outputs expected, got;

/* Makes small powers of two and denormals, where flushing shows, ordinary numbers, where rounding
   shows, and numbers that raise every exception. All come from their bits, whatever the mode is. */
static void make_points(void)
{
    static const uint32_t odd[] = {0x7fc00000u, 0x7f800000u, 0xff800000u, 0x7f800001u,
                                   0x7f7fffffu, 0xff7fffffu, 0x4f000000u, 0x00000001u};
    uint64_t state = 1;
    for (int i = 0; i < 3 * POINTS; i++) {
        const uint64_t r = check_random(&state);
        const uint32_t sign = (uint32_t)(r >> 63) << 31, fraction = (uint32_t)r & 0x7fffff;
        const uint64_t fraction64 = r & UINT64_C(0xfffffffffffff);
        /* exponents: 0 and 1 (denormal and next to it), up to 2^-20; then 2^-3 to 2^9 */
        const uint32_t exponent = (uint32_t)(r >> 32) % 8 < 3 ? (uint32_t)(r >> 40) % 3
                                  : (r >> 36 & 1) != 0        ? (uint32_t)(r >> 40) % 108
                                                              : 124 + (uint32_t)(r >> 40) % 13;
        uint32_t bits = sign | exponent << 23 | fraction;
        const uint64_t wide = exponent < 3 ? exponent : exponent + 896;
        uint64_t bits64 = (uint64_t)sign << 32 | wide << 52 | fraction64;
        if (r >> 50 & 1 && i % 16 == 0) {
            bits = odd[i / 16 % 8];
            bits64 = (uint64_t)bits << 32;
        }
        memcpy(&x32[i % 3][i / 3], &bits, sizeof bits);
        memcpy(&x64[i % 3][i / 3], &bits64, sizeof bits64);
    }
}

#define NOISES 11

/* One of them has denormal constants, in its last octaves: value noise with a small gain; one has a
   denormal phase. */
static const struct scarp_noise noises[NOISES] = {
    {.seed = 1},
    {.seed = 2, .basis = SCARP_VALUE, .octaves = 32.0f, .lacunarity = 1.25f, .gain = 0.0625f},
    {.seed = 3, .octaves = 4.5f, .rotate = 1, .frequency = 1.3},
    {.seed = 4, .frequency = 0x1p-32, .amplitude = 0x1p-24f, .fade = SCARP_CUBIC},
    {.seed = 5, .octaves = 3.0f, .frequency = 0x1p40, .basis = SCARP_VALUE, .rotate = 1},
    {.seed = 6, .octaves = 2.0f, .phase = 0.3f, .fractal = SCARP_RIDGED},
    {.seed = 7, .octaves = 9.0f, .phase = -0x1p-140f},
    {.seed = 8, .octaves = 3.0f, .basis = SCARP_SIMPLEX, .frequency = 0.75},
    {.seed = 9, .octaves = 2.0f, .basis = SCARP_CELL_EDGE, .rotate = 1},
    {.seed = 10, .basis = SCARP_CELL_F1, .jitter = 0x1p-140f}, /* which vanishes beside 1/2 */
    {.seed = 11, .octaves = 2.0f, .basis = SCARP_CELL_SOFT, .jitter = 0.3f},
};

/* Makes all sample calls in `mode`. Nothing here computes with floating-point numbers, which could
   trap; the caller looks at the outputs. */
static __attribute__((noinline)) enum scarp_status
call_in_mode(const struct mode *mode, const struct scarp_noise *noise, enum function f,
             const struct outputs *o, struct mode_control *after)
{
    const struct scarp_samples out = outputs_subset(o, outputs_of(noise, f));
    const struct mode_control before = mode_enter(mode);
    const enum scarp_status status = function_call(f, noise, POINTS, &in, &out);
    *after = mode_leave(before);
    return status;
}

static __attribute__((noinline)) enum scarp_status normals_in_mode(const struct mode *mode,
                                                                   const float *height_scale,
                                                                   const struct outputs *o,
                                                                   struct mode_control *after)
{
    const float scale = *height_scale;
    const struct mode_control before = mode_enter(mode);
    const enum scarp_status status =
        scarp_normals(POINTS, x32[0], x32[1], scale, o->array[0], o->array[1], o->array[2]);
    *after = mode_leave(before);
    return status;
}

static __attribute__((noinline)) enum scarp_status chain_in_mode(const struct mode *mode,
                                                                 enum chain f,
                                                                 const struct outputs *o,
                                                                 struct mode_control *after)
{
    const struct scarp_samples out = outputs_subset(o, (1u << OUTPUTS) - 1);
    float *const x[3] = {x32[0], x32[1], x32[2]};
    const struct mode_control before = mode_enter(mode);
    const enum scarp_status status = chain_call_arrays(f, POINTS, x, &out);
    *after = mode_leave(before);
    return status;
}

/* Whether functions of samples refuse a number, in `mode`. */
static __attribute__((noinline)) int refused_in_mode(const struct mode *mode, const float *number,
                                                     struct mode_control *after)
{
    const struct scarp_samples a = chain_samples(x32[0], 0), out = {.value = got.array[0]};
    const float *const n = number;
    const struct mode_control before = mode_enter(mode);
    const int refused = scarp_smooth_min(POINTS, &a, &a, *n, &out) == SCARP_ERROR_PARAMETER &&
                        scarp_smoothstep(POINTS, &a, *n, *n, &out) == SCARP_ERROR_PARAMETER &&
                        scarp_terrace(POINTS, &a, *n, *n, *n, &out) == SCARP_ERROR_PARAMETER;
    *after = mode_leave(before);
    return refused;
}

/* The velocity, and some of the Jacobian. */
static __attribute__((noinline)) enum scarp_status flow_in_mode(const struct mode *mode,
                                                                const struct scarp_noise *noise,
                                                                const struct outputs *o,
                                                                struct mode_control *after)
{
    const struct scarp_flow out = {.vx = o->array[0], .vy = o->array[1], .vz = o->array[2]};
    const struct mode_control before = mode_enter(mode);
    const enum scarp_status status =
        scarp_curl3(noise, POINTS, x32[0], x32[1], x32[2], &out) == SCARP_OK
            ? scarp_curl3_f64(noise, POINTS, x64[0], x64[1], x64[2],
                              &(struct scarp_flow){.vx = o->array[3], .vyz = o->array[4]})
            : SCARP_ERROR_NULL;
    *after = mode_leave(before);
    return status;
}

/* Makes the calls that do not sample, in `mode`. */
static __attribute__((noinline)) enum scarp_status range_in_mode(const struct mode *mode,
                                                                 const struct scarp_noise *noise,
                                                                 float *lowest, float *highest,
                                                                 struct mode_control *after)
{
    const struct mode_control before = mode_enter(mode);
    enum scarp_status status = scarp_range(noise, 3, lowest, highest);
    if (scarp_noise_check(noise, 3, NULL) != status) {
        status = SCARP_ERROR_NULL;
    }
    if (!scarp_isa_supported(scarp_isa_active()) || scarp_isa_select(scarp_isa_active())) {
        status = SCARP_ERROR_UNSUPPORTED;
    }
    *after = mode_leave(before);
    return status;
}

/* What the library gives to shaders. */
struct for_shaders {
    struct scarp_gpu_plan plan;
    uint32_t answer[SCARP_GPU_ANSWERS];
};

static __attribute__((noinline)) enum scarp_status gpu_in_mode(const struct mode *mode,
                                                               const struct scarp_noise *noise,
                                                               struct for_shaders *to,
                                                               struct mode_control *after)
{
    const struct mode_control before = mode_enter(mode);
    const enum scarp_status a = scarp_gpu_plan_make(noise, 3, &to->plan, NULL);
    const enum scarp_status b = scarp_gpu_answers(noise, 3, 2, to->answer);
    *after = mode_leave(before);
    return a != SCARP_OK ? a : b;
}

static void expect_control(const struct mode *mode, const struct mode_control *after,
                           const char *what)
{
    CHECK(mode_is(mode, after), "%s, %s: the mode was changed to %#llx", mode->name, what,
          (unsigned long long)after->word);
}

static void compare_outputs(const struct mode *mode, const char *what, unsigned mask)
{
    int member = 0;
    size_t at = 0;
    CHECK(outputs_equal(&expected, &got, mask, POINTS, &member, &at),
          "%s, %s: %s[%zu] is %#x, in the default mode %#x", mode->name, what, output_names[member],
          at, float_bits(got.array[member] + at), float_bits(expected.array[member] + at));
}

/* Compares results with a plan that was made in `mode` with results without one, `expected`. */
static void test_plan(const struct mode *mode, const struct scarp_noise *noise, enum function f)
{
    static struct scarp_plan plan;
    struct scarp_noise with = *noise;
    struct mode_control after;
    const struct mode_control before = mode_enter(mode);
    const enum scarp_status made = scarp_plan_make(noise, function_dimensions(f), &plan);
    after = mode_leave(before);
    with.plan = &plan;
    outputs_poison(&got);
    const enum scarp_status called = call_in_mode(&mode_default, &with, f, &got, &after);
    CHECK(made == SCARP_OK && called == SCARP_OK, "%s, plan, %s", mode->name, function_names[f]);
    compare_outputs(mode, "scarp_plan_make", outputs_of(noise, f));
}

/* Compares results in `mode` with results in the default mode. */
static void test_results(const struct mode *mode)
{
    struct mode_control after;
    for (int n = 0; n < NOISES; n++) {
        for (int i = 0; i < FUNCTIONS; i++) {
            const enum function f = (enum function)i;
            outputs_poison(&got);
            const enum scarp_status a =
                call_in_mode(&mode_default, &noises[n], f, &expected, &after);
            const enum scarp_status b = call_in_mode(mode, &noises[n], f, &got, &after);
            CHECK(a == SCARP_OK && b == SCARP_OK, "%s, %s", mode->name, function_names[f]);
            expect_control(mode, &after, function_names[f]);
            compare_outputs(mode, function_names[f], outputs_of(&noises[n], f));
            test_plan(mode, &noises[n], f);
        }
    }
    static const uint32_t scales[] = {0x3f99999au, 0xff7fffffu, 0x00000001u, 0x0da24260u};
    for (int i = 0; i < 4; i++) {
        const float scale = float_of_bits(scales[i]);
        const enum scarp_status a = normals_in_mode(&mode_default, &scale, &expected, &after);
        const enum scarp_status b = normals_in_mode(mode, &scale, &got, &after);
        CHECK(a == SCARP_OK && b == SCARP_OK, "%s, scarp_normals", mode->name);
        expect_control(mode, &after, "scarp_normals");
        compare_outputs(mode, "scarp_normals", 7);
    }
    for (int i = 0; i < CHAINS; i++) {
        const enum chain f = (enum chain)i;
        const enum scarp_status a = chain_in_mode(&mode_default, f, &expected, &after);
        const enum scarp_status b = chain_in_mode(mode, f, &got, &after);
        CHECK(a == SCARP_OK && b == SCARP_OK, "%s, %s", mode->name, chain_kinds[f].name);
        expect_control(mode, &after, chain_kinds[f].name);
        compare_outputs(mode, chain_kinds[f].name, (1u << OUTPUTS) - 1);
    }
}

/* Compares velocities in `mode` with those in the default mode. */
static void test_flows(const struct mode *mode)
{
    struct mode_control after;
    for (int n = 0; n < NOISES; n++) {
        const enum scarp_status a = flow_in_mode(&mode_default, &noises[n], &expected, &after);
        const enum scarp_status b = flow_in_mode(mode, &noises[n], &got, &after);
        CHECK(a == SCARP_OK && b == SCARP_OK, "%s, scarp_curl3", mode->name);
        expect_control(mode, &after, "scarp_curl3");
        compare_outputs(mode, "scarp_curl3", 0x1f);
    }
}

static __attribute__((noinline)) enum scarp_status
gullies_in_mode(const struct mode *mode, const struct scarp_gullies *gullies,
                const struct outputs *o, struct mode_control *after)
{
    const struct scarp_samples base = base_of_two(x32[0], x32[1]);
    const struct scarp_eroded out = eroded_of(o->array, OUT_ALL);
    const struct mode_control before = mode_enter(mode);
    const enum scarp_status status = scarp_gullies2(gullies, POINTS, x32[0], x32[1], &base, &out);
    *after = mode_leave(before);
    return status;
}

static __attribute__((noinline)) enum scarp_status
gullies_checked_in_mode(const struct mode *mode, const struct scarp_gullies *gullies,
                        struct mode_control *after)
{
    const struct mode_control before = mode_enter(mode);
    const enum scarp_status status = scarp_gullies_check(gullies, NULL);
    *after = mode_leave(before);
    return status;
}

/* Compares gullies in `mode` with those in the default mode. A depth that is no number, or
   denormal, is refused without a trap. */
static void test_gullies(const struct mode *mode)
{
    struct mode_control after;
    for (size_t n = 0; n < DESCRIPTIONS; n++) {
        const enum scarp_status a =
            gullies_in_mode(&mode_default, &descriptions[n], &expected, &after);
        const enum scarp_status b = gullies_in_mode(mode, &descriptions[n], &got, &after);
        CHECK(a == SCARP_OK && b == SCARP_OK, "%s, scarp_gullies2", mode->name);
        expect_control(mode, &after, "scarp_gullies2");
        compare_outputs(mode, "scarp_gullies2", OUT_ALL);
    }
    for (uint32_t bits = 1; bits != 0x7f800003u; bits = bits == 1 ? 0x7f800001u : bits + 1) {
        struct scarp_gullies bad = {0};
        const float number = float_of_bits(bits);
        memcpy(&bad.depth, &number, sizeof number);
        CHECK(gullies_checked_in_mode(mode, &bad, &after) == SCARP_ERROR_PARAMETER, "%s: %#x",
              mode->name, bits);
        expect_control(mode, &after, "scarp_gullies_check");
    }
}

/* Compares plans and answers for shaders in `mode` with those in the default mode. */
static void test_shaders(const struct mode *mode)
{
    static struct for_shaders in_default, in_mode;
    struct mode_control after;
    for (int n = 0; n < NOISES; n += 3) {
        const enum scarp_status a = gpu_in_mode(&mode_default, &noises[n], &in_default, &after);
        const enum scarp_status b = gpu_in_mode(mode, &noises[n], &in_mode, &after);
        CHECK(a == SCARP_OK && b == SCARP_OK, "%s, scarp_gpu_plan_make", mode->name);
        expect_control(mode, &after, "scarp_gpu_plan_make");
        CHECK(memcmp(&in_default, &in_mode, sizeof in_mode) == 0, "%s, scarp_gpu_plan_make",
              mode->name);
    }
}

/* Bad parameters are refused without a trap. Denormal ones, which are too small, are refused too:
   they are not taken for 0, which means the default. */
static void test_errors(const struct mode *mode)
{
    struct mode_control after;
    static const uint32_t bad[] = {0x7fc00000u, 0x7f800000u, 0xff800000u,
                                   0x7f800001u, 0x7f7fffffu, 0x80000001u};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const float number = float_of_bits(bad[i]);
        for (int field = 0; field < 8; field++) {
            struct scarp_noise noise = {0};
            float *const fields[] = {&noise.octaves,   &noise.lacunarity, &noise.gain,
                                     &noise.amplitude, &noise.phase,      &noise.jitter,
                                     &noise.sharpness, &noise.of_octaves};
            const enum scarp_status expected_status =
                field == 4 && i > 3 ? SCARP_OK /* a phase */ : SCARP_ERROR_PARAMETER;
            memcpy(fields[field], &number, sizeof number);
            float bounds[2];
            const enum scarp_status sampled = call_in_mode(mode, &noise, SAMPLE3, &got, &after);
            expect_control(mode, &after, "bad parameter");
            const enum scarp_status ranged =
                range_in_mode(mode, &noise, &bounds[0], &bounds[1], &after);
            expect_control(mode, &after, "scarp_range");
            CHECK(sampled == expected_status && ranged == sampled, "%s: field %d = %#x: %s, %s",
                  mode->name, field, bad[i], scarp_status_text(sampled), scarp_status_text(ranged));
        }
        CHECK(refused_in_mode(mode, &number, &after), "%s: %#x is not refused", mode->name, bad[i]);
        expect_control(mode, &after, "a number of the chain rule");
        if (i < 4) {
            const enum scarp_status status = normals_in_mode(mode, &number, &got, &after);
            CHECK(status == SCARP_ERROR_PARAMETER, "%s: height_scale %#x", mode->name, bad[i]);
            expect_control(mode, &after, "height_scale");
        }
    }
    const uint64_t signalling = UINT64_C(0x7ff0000000000001), denormal = 1;
    struct scarp_noise noise = {0};
    memcpy(&noise.frequency, &signalling, sizeof signalling);
    CHECK(call_in_mode(mode, &noise, SAMPLE2, &got, &after) == SCARP_ERROR_PARAMETER, "%s",
          mode->name);
    memcpy(&noise.frequency, &denormal, sizeof denormal);
    CHECK(call_in_mode(mode, &noise, SAMPLE2, &got, &after) == SCARP_ERROR_PARAMETER,
          "%s: a denormal frequency passed for 0", mode->name);
}

/* Hashes everything sampled in `mode`; both builds of this program print the same number. */
static uint64_t hash_in_mode(const struct mode *mode)
{
    struct mode_control after;
    uint64_t hash = FNV_BASIS;
    for (int n = 0; n < NOISES; n++) {
        for (int f = 0; f < FUNCTIONS; f++) {
            call_in_mode(mode, &noises[n], (enum function)f, &got, &after);
            hash = outputs_hash(hash, &got, outputs_of(&noises[n], (enum function)f), POINTS);
        }
    }
    return hash;
}

int main(int argc, char **argv)
{
    const int started = argc > 1 && strcmp(argv[1], "--started") == 0;
    const struct mode start = mode_started();
    check_select_isa(argc > 1 + started ? argv[1 + started] : "scalar");
    expected = outputs_make(POINTS);
    got = outputs_make(POINTS);
    make_points();
    if (started) {
        if (!mode_flushes(&start)) {
            printf("the program did not start with denormals flushed: skipped\n");
            return CHECK_SKIPPED;
        }
        test_results(&start);
        test_flows(&start);
        test_gullies(&start);
        test_shaders(&start);
        test_errors(&start);
    }
    int modes = 0;
    for (int i = 0; !started && i < MODES; i++) {
        if (mode_works(&modes_all[i])) {
            test_results(&modes_all[i]);
            test_flows(&modes_all[i]);
            test_gullies(&modes_all[i]);
            test_shaders(&modes_all[i]);
            test_errors(&modes_all[i]);
            modes++;
        } else {
            printf("%s cannot be set here: left out\n", modes_all[i].name);
        }
    }
    const uint64_t hash = hash_in_mode(&start);
    printf("hash %016llx\n", (unsigned long long)hash);
    CHECK(hash == hash_in_mode(&mode_default), "the starting mode changed results");
    if (!started && modes == 0) {
        printf("no mode can be set here: skipped\n");
        return CHECK_SKIPPED;
    }
    return check_done();
}
