/* SPDX-License-Identifier: MIT
 *
 *     test_gpu_chain [few]
 *
 * What shaders have besides noise, as C: the chain rule, the sine, quotients, vector noise, cells
 * and velocities have the bits of the library. gpu.recipes has places, masks and gullies.
 */
#include "check.h"

#include "../src/calls/chain.h"
#include "../src/gpu/flow.h"
#include "../src/gpu/sine.h"
#include "../src/plan/functions.h"

enum { POINTS = 64, MEMBERS = 10 };

struct arrays {
    float of[MEMBERS][POINTS];
};

static struct scarp_samples samples_of(struct arrays *a)
{
    const struct scarp_samples s = {.value = a->of[0],
                                    .dx = a->of[1],
                                    .dy = a->of[2],
                                    .dz = a->of[3],
                                    .dxx = a->of[4],
                                    .dxy = a->of[5],
                                    .dxz = a->of[6],
                                    .dyy = a->of[7],
                                    .dyz = a->of[8],
                                    .dzz = a->of[9]};
    return s;
}

/* The members of struct sample at point i, in the order of struct scarp_samples. */
static struct sample sample_at(const struct arrays *a, int i)
{
    return sample_of(a->of[0][i], vec3_of(a->of[1][i], a->of[2][i], a->of[3][i]),
                     vec3_of(a->of[4][i], a->of[7][i], a->of[9][i]),
                     vec3_of(a->of[5][i], a->of[6][i], a->of[8][i]));
}

static void compare(const char *name, const struct arrays *library, int i, struct sample s)
{
    const float shader[MEMBERS] = {s.value,      s.gradient.x, s.gradient.y, s.gradient.z,
                                   s.diagonal.x, s.mixed.x,    s.mixed.y,    s.diagonal.y,
                                   s.mixed.z,    s.diagonal.z};
    for (int m = 0; m < MEMBERS; m++) {
        const float a = shader[m], b = library->of[m][i];
        CHECK(memcmp(&a, &b, sizeof a) == 0 || (a == 0.0f && b == 0.0f),
              "%s, output %d: shader %a, library %a", name, m, (double)a, (double)b);
    }
}

/* Values around those where functions change; some members are 0. */
static void fill(struct arrays *a, uint64_t *random)
{
    for (int m = 0; m < MEMBERS; m++) {
        for (int i = 0; i < POINTS; i++) {
            const uint64_t r = check_random(random);
            a->of[m][i] = r % 8 == 0   ? 0.0f
                          : r % 8 == 1 ? (float)((int)(r >> 32 & 7) - 4) * 0.25f
                                       : check_random_float(random, r % 8 == 2 ? 40.0f : 1.5f);
        }
    }
}

/* The numbers of a shader's call, as vectors of three and of four. */
union shader_numbers {
    struct {
        float x, y, z, w;
    };
    vec3 xyz;
    vec4 xyzw;
};

/* Those of the first case of a function. */
static union shader_numbers numbers_of(enum scarp_chain_function function, const float given[3],
                                       unsigned which)
{
    float all[CHAIN_NUMBERS] = {0}, chosen[4] = {0};
    int count = 0;
    CHECK(scarpi_chain_numbers(function, given, all), "numbers");
    for (int i = 0; i < CHAIN_NUMBERS; i++) {
        if ((which >> i & 1u) != 0) {
            chosen[count++] = all[i];
        }
    }
    return (union shader_numbers){{chosen[0], chosen[1], chosen[2], chosen[3]}};
}

#define NUMBERS_OF(...) __VA_ARGS__
#define CASE(name, function, COMPUTED, FORM, kinds, numbers, ...) {#function, {NUMBERS_OF numbers}},
static const struct {
    const char *function;
    float number[3];
} cases[] = {
#include "functions.def"
};

static const float *given_to(const char *function)
{
    static const float none[3];
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        if (strcmp(cases[i].function, function) == 0) {
            return cases[i].number;
        }
    }
    return none;
}

/* Each function of plan/functions.def, as its row says that shaders call it */
static void compare_functions(uint64_t *random)
{
    struct arrays inputs[3], to;
    for (int i = 0; i < 3; i++) {
        fill(&inputs[i], random);
    }
    for (int i = 0; i < POINTS; i++) {
        float *const mask = &inputs[2].of[0][i], *const divisor = &inputs[1].of[0][i];
        *mask = *mask < 0.0f ? 0.0f : *mask > 1.0f ? 1.0f : *mask;
        *divisor = *divisor == 0.0f ? 0.5f : *divisor;
    }
    const struct scarp_samples sa = samples_of(&inputs[0]), sb = samples_of(&inputs[1]),
                               sm = samples_of(&inputs[2]), out = samples_of(&to);
    const struct scarp_samples *const in[3] = {&sa, &sb, &sm};
    const union shader_numbers none = {{0.0f, 0.0f, 0.0f, 0.0f}};
    const int d = 3;
#define N(number) 1u << CHAIN_##number
#define NUMBERS_IF(FORM, NAME, name, numbers)                                                      \
    const union shader_numbers k =                                                                 \
        IF_NUMBERS_##FORM(1 ? numbers_of(CHAIN_##NAME, given, numbers) :) none;
#define COMPARE(NAME, name, FORM, shader, numbers)                                                 \
    {                                                                                              \
        const float *const given = given_to(#name);                                                \
        NUMBERS_IF(FORM, NAME, name, numbers)                                                      \
        CHECK(FORM_##FORM(scarp_##name, POINTS, in, given, &out) == SCARP_OK, #name);              \
        for (int i = 0; i < POINTS; i++) {                                                         \
            const struct sample a = sample_at(&inputs[0], i), b = sample_at(&inputs[1], i),        \
                                m = sample_at(&inputs[2], i);                                      \
            compare(#name, &to, i, shader);                                                        \
            (void)given, (void)k, (void)a, (void)b, (void)m, (void)d;                              \
        }                                                                                          \
    }
#define COMPARE_LOOPS(...) COMPARE(__VA_ARGS__)
#define COMPARE_BENT(...) COMPARE(__VA_ARGS__)
#define COMPARE_STRAIGHT(...) COMPARE(__VA_ARGS__)
#define COMPARE_SMOOTH(...) COMPARE(__VA_ARGS__)
#define COMPARE_PLAIN(...) COMPARE(__VA_ARGS__)
#define COMPARE_OWN(...) /* below */
#define OPERATOR(NAME, name, FORM, COMPUTED, take, traits, range, shader, numbers)                 \
    COMPARE_##COMPUTED(NAME, name, FORM, shader, numbers)
#define FUNCTION(NAME, name, FORM, COMPUTED, take, traits, range, shader, numbers, ...)            \
    OPERATOR(NAME, name, FORM, COMPUTED, take, traits, range, shader, numbers)
#include "../src/plan/functions.def"
}

static void compare_curve(uint64_t *random)
{
    struct arrays a, to;
    fill(&a, random);
    const float x[3] = {-0.5f, 0.0f, 0.6f}, y[3] = {0.25f, 1.0f, -0.5f};
    const struct scarp_samples in = samples_of(&a), out = samples_of(&to);
    CHECK(scarp_curve(POINTS, &in, 3, x, y, &out) == SCARP_OK, "curve");
    for (int i = 0; i < POINTS; i++) {
        const struct sample s = sample_at(&a, i);
        const vec4 knot[3] = {{x[0], y[0], 0.0f, 1.0f / (x[1] - x[0])},
                              {x[1], y[1], 0.0f, 1.0f / (x[2] - x[1])},
                              {x[2], y[2], 0.0f, 0.0f}};
        const int k = s.value >= x[1];
        compare("curve", &to, i, chain_curve(s, knot[k], knot[k + 1], knot[0], knot[2]));
    }
}

static void compare_slope(uint64_t *random)
{
    struct arrays a, to = {{{0.0f}}};
    fill(&a, random);
    const struct scarp_samples in = samples_of(&a);
    const struct scarp_samples value = {
        .value = to.of[0], .dx = to.of[1], .dy = to.of[2], .dz = to.of[3]};
    CHECK(scarp_slope(POINTS, &in, &value) == SCARP_OK, "slope");
    for (int i = 0; i < POINTS; i++) {
        compare("slope", &to, i, chain_slope(sample_at(&a, i), 3));
    }
}

/* Sines round apart only where the library's double lies next to the middle between two floats. */
static void compare_sines(uint32_t step)
{
    unsigned long differing = 0, compared = 0;
    for (uint32_t bits = 0x2f000000u; bits < 0x3f800000u; bits += step) {
        float a[2] = {float_of_bits(bits), -float_of_bits(bits) * 3.0f};
        float f[2], fa[2], faa[2];
        const float one[2] = {1.0f, 1.0f}, zero[2] = {0.0f, 0.0f};
        const struct scarp_samples in = {
            .value = a, .dx = (float *)(uintptr_t)one, .dxx = (float *)(uintptr_t)zero};
        const struct scarp_samples out = {.value = f, .dx = fa, .dxx = faa};
        (void)scarp_sine(2, &in, &out);
        for (int i = 0; i < 2; i++) {
            struct sample s = constant(a[i]);
            s.gradient.x = 1.0f;
            s = chain_sine(s);
            const float shader[3] = {s.value, s.gradient.x, s.diagonal.x},
                        library[3] = {f[i], fa[i], faa[i]};
            for (int k = 0; k < 3; k++) {
                const float off = shader[k] - library[k];
                compared++;
                differing += off != 0.0f;
                CHECK(off == 0.0f || magnitude(off) <= magnitude(library[k]) * 0x1p-22f,
                      "sine of %a: %a, not %a", (double)a[i], (double)shader[k],
                      (double)library[k]);
            }
        }
    }
    printf("%lu of %lu sines and slopes differ\n", differing, compared);
    CHECK(differing * 10000000 <= compared * 3 + 10000000, "%lu sines differ", differing);
}

static void compare_quotients(uint64_t *random, int count)
{
    for (int i = 0; i < count; i++) {
        const float a = float_of_bits((uint)(check_random(random) >> 32 & 0xffffffu) + 0x3f000000u);
        const float b = float_of_bits((uint)(check_random(random) >> 32 & 0x80ffffffu) |
                                      (0x3e000000u + (uint)(i % 5) * 0x1000000u));
        CHECK(quotient(a, b) == a / b, "%a / %a: %a", (double)a, (double)b, (double)quotient(a, b));
    }
    CHECK(quotient(0.0f, 3.0f) == 0.0f && quotient(-1.0f, 3.0f) == -1.0f / 3.0f, "signs");
}

static struct scarp_noise noise_of(uint64_t *random, unsigned basis, struct scarp_noise *warp)
{
    struct scarp_noise noise = {.basis = (enum scarp_basis)basis,
                                .seed = check_random(random),
                                .octaves = 2.0f,
                                .rotate = (uint32_t)(check_random(random) % 2),
                                .frequency = 0.37,
                                .jitter = 0.75f};
    *warp = (struct scarp_noise){.seed = check_random(random), .octaves = 1.0f, .amplitude = 0.5f};
    noise.warp = check_random(random) % 2 != 0 ? warp : NULL;
    return noise;
}

static void make_plan(struct plan *plan, const struct scarp_noise *noise, int dimensions)
{
    struct scarp_gpu_plan gpu;
    const char *member = NULL;
    CHECK(scarp_gpu_vector_plan_make(noise, dimensions, &gpu, &member) == SCARP_OK, "%s",
          member != NULL ? member : "");
    memcpy(plan, &gpu, sizeof *plan);
    scarp_plan = plan;
}

static void compare_flow(const struct scarp_noise *noise, const float x[3])
{
    float v[3], j[9];
    const struct scarp_flow out = {.vx = &v[0],
                                   .vy = &v[1],
                                   .vz = &v[2],
                                   .vxx = &j[0],
                                   .vxy = &j[1],
                                   .vxz = &j[2],
                                   .vyx = &j[3],
                                   .vyy = &j[4],
                                   .vyz = &j[5],
                                   .vzx = &j[6],
                                   .vzy = &j[7],
                                   .vzz = &j[8]};
    struct arrays of[3];
    struct scarp_samples samples[3];
    static struct plan plan; /* scarp_plan keeps pointing to it */
    make_plan(&plan, noise, 3);
    CHECK(scarp_curl3(noise, 1, &x[0], &x[1], &x[2], &out) == SCARP_OK, "curl");
    const struct flow f = curl3(0, x[0], x[1], x[2]);
    const float shader[12] = {f.velocity.x, f.velocity.y, f.velocity.z, f.x.x, f.x.y, f.x.z,
                              f.y.x,        f.y.y,        f.y.z,        f.z.x, f.z.y, f.z.z};
    for (int i = 0; i < 12; i++) {
        CHECK(shader[i] == (i < 3 ? v[i] : j[i - 3]), "curl3, %s, output %d: %a, not %a",
              scarp_basis_name(noise->basis), i, (double)shader[i],
              (double)(i < 3 ? v[i] : j[i - 3]));
    }
    for (int c = 0; c < 3; c++) {
        samples[c] = samples_of(&of[c]);
    }
    CHECK(scarp_vector3(noise, 1, &x[0], &x[1], &x[2], samples) == SCARP_OK, "vector");
    const struct displaced d = vector3(0, x[0], x[1], x[2]);
    compare("vector x", &of[0], 0, d.x);
    compare("vector y", &of[1], 0, d.y);
    compare("vector z", &of[2], 0, d.z);
}

static void compare_flow2(const struct scarp_noise *noise, const float x[3])
{
    float v[2], j[4];
    const struct scarp_flow out = {
        .vx = &v[0], .vy = &v[1], .vxx = &j[0], .vxy = &j[1], .vyx = &j[2], .vyy = &j[3]};
    struct scarp_gpu_plan gpu;
    static struct plan plan; /* scarp_plan keeps pointing to it */
    CHECK(scarp_gpu_plan_make(noise, 2, &gpu, NULL) == SCARP_OK &&
              scarp_curl2(noise, 1, &x[0], &x[1], &out) == SCARP_OK,
          "curl2");
    memcpy(&plan, &gpu, sizeof plan);
    scarp_plan = &plan;
    const struct flow f = curl2(0, x[0], x[1]);
    CHECK(f.velocity.x == v[0] && f.velocity.y == v[1] && f.x.x == j[0] && f.x.y == j[1] &&
              f.y.x == j[2] && f.y.y == j[3],
          "curl2, %s", scarp_basis_name(noise->basis));
}

static void compare_cells(const struct scarp_noise *noise, const float x[3], int dimensions)
{
    uint32_t id;
    float f[2], d[6], place[3] = {0.0f, 0.0f, 0.0f};
    const int is_space = dimensions == 3;
    const struct scarp_cells out = {.id = &id,
                                    .f1 = &f[0],
                                    .f2 = &f[1],
                                    .x = &place[0],
                                    .y = &place[1],
                                    .z = is_space ? &place[2] : NULL,
                                    .dx1 = &d[0],
                                    .dy1 = &d[1],
                                    .dz1 = is_space ? &d[2] : NULL,
                                    .dx2 = &d[3],
                                    .dy2 = &d[4],
                                    .dz2 = is_space ? &d[5] : NULL};
    struct scarp_gpu_plan gpu;
    static struct plan plan; /* scarp_plan keeps pointing to it */
    struct scarp_noise cellular = *noise;
    cellular.basis = SCARP_CELL_F1;
    cellular.warp = NULL;
    CHECK(scarp_gpu_plan_make(&cellular, dimensions, &gpu, NULL) == SCARP_OK, "cells");
    memcpy(&plan, &gpu, sizeof plan);
    scarp_plan = &plan;
    CHECK((is_space ? scarp_cells3(&cellular, 1, &x[0], &x[1], &x[2], &out)
                    : scarp_cells2(&cellular, 1, &x[0], &x[1], &out)) == SCARP_OK,
          "cells");
    const struct cells c = is_space ? cells3(0, x[0], x[1], x[2]) : cells2(0, x[0], x[1]);
    CHECK(c.id == id && c.f1 == f[0] && c.f2 == f[1] && c.d1.x == d[0] && c.d1.y == d[1] &&
              c.d2.x == d[3] && c.d2.y == d[4] && c.place.x == place[0] && c.place.y == place[1] &&
              (!is_space || (c.d1.z == d[2] && c.d2.z == d[5] && c.place.z == place[2])),
          "cells in %dD", dimensions);
}

/* Plans of vector noise: octaves of components that share no lattice need room. */
static void check_plans(void)
{
    struct scarp_gpu_plan plan, before;
    const char *member = "";
    struct scarp_noise noise = {.basis = SCARP_SIMPLEX, .octaves = 10.0f};
    memset(&plan, 0x5a, sizeof plan);
    memcpy(&before, &plan, sizeof plan);
    CHECK(scarp_gpu_vector_plan_make(&noise, 3, &plan, &member) == SCARP_OK && member == NULL,
          "30 octaves");
    memcpy(&plan, &before, sizeof plan);
    noise.octaves = 11.0f;
    CHECK(scarp_gpu_vector_plan_make(&noise, 3, &plan, &member) == SCARP_ERROR_UNSUPPORTED &&
              strcmp(member, "octaves") == 0 && memcmp(&plan, &before, sizeof plan) == 0,
          "33 octaves");
    CHECK(scarp_gpu_vector_plan_make(&noise, 2, &plan, NULL) == SCARP_OK, "22 octaves");
    CHECK(scarp_gpu_vector_plan_make(NULL, 2, &plan, &member) == SCARP_ERROR_NULL &&
              scarp_gpu_vector_plan_make(&noise, 4, &plan, &member) == SCARP_ERROR_PARAMETER,
          "errors");
}

int main(int argc, char **argv)
{
    const int few = argc > 1; /* what runs slowly looks at fewer */
    uint64_t random = 29;
    (void)argv;
    for (int round = 0; round < (few ? 4 : 40); round++) {
        compare_functions(&random);
        compare_curve(&random);
        compare_slope(&random);
    }
    for (int round = 0; round < (few ? 40 : 400); round++) {
        struct scarp_noise warp;
        const struct scarp_noise noise = noise_of(&random, (unsigned)round % 8, &warp);
        float x[3];
        for (int i = 0; i < 3; i++) {
            x[i] = check_random_float(&random, 50.0f);
        }
        compare_flow(&noise, x);
        compare_flow2(&noise, x);
        compare_cells(&noise, x, 2);
        compare_cells(&noise, x, 3);
    }
    compare_sines(few ? 40009 : 1009);
    compare_quotients(&random, few ? 10000 : 1000000);
    check_plans();
    return check_done();
}
