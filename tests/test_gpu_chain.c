/* SPDX-License-Identifier: MIT
 *
 *     test_gpu_chain [few]
 *
 * What shaders have beside noise, as C: the chain rule, the sine, quotients, vector noise, cells
 * and velocities have the bits of the library. gpu.recipes has places, masks and gullies.
 */
#include "check.h"

#include "../src/gpu/flow.h"
#include "../src/gpu/sine.h"

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

static vec3 smooth_numbers(float k, float sign)
{
    return vec3_of(1.0f / k, sign * (k / 6.0f), -sign * (1.0f / k));
}

static void compare_two(uint64_t *random)
{
    struct arrays a, b, m, to;
    fill(&a, random);
    fill(&b, random);
    fill(&m, random);
    for (int i = 0; i < POINTS; i++) {
        m.of[0][i] = m.of[0][i] < 0.0f ? 0.0f : m.of[0][i] > 1.0f ? 1.0f : m.of[0][i];
        b.of[0][i] = b.of[0][i] == 0.0f ? 0.5f : b.of[0][i];
    }
    const struct scarp_samples sa = samples_of(&a), sb = samples_of(&b), sm = samples_of(&m),
                               out = samples_of(&to);
    const float k = 0.7f;
#define TWO(call, shader)                                                                          \
    CHECK(call == SCARP_OK, #call);                                                                \
    for (int i = 0; i < POINTS; i++) {                                                             \
        const struct sample x = sample_at(&a, i), y = sample_at(&b, i), z = sample_at(&m, i);      \
        (void)z;                                                                                   \
        compare(#shader, &to, i, shader);                                                          \
    }
    TWO(scarp_multiply(POINTS, &sa, &sb, &out), chain_multiply(x, y))
    TWO(scarp_mix(POINTS, &sa, &sb, &sm, &out), chain_mix(x, y, z))
    TWO(scarp_add(POINTS, &sa, &sb, &out), sum_of(x, y))
    TWO(scarp_min(POINTS, &sa, &sb, &out), chain_min(x, y))
    TWO(scarp_max(POINTS, &sa, &sb, &out), chain_max(x, y))
    TWO(scarp_divide(POINTS, &sa, &sb, &out), chain_divide(x, y))
    TWO(scarp_smooth_min(POINTS, &sa, &sb, k, &out),
        chain_smooth_min(x, y, smooth_numbers(k, 1.0f)))
    TWO(scarp_smooth_max(POINTS, &sa, &sb, k, &out),
        chain_smooth_max(x, y, smooth_numbers(k, -1.0f)))
#undef TWO
}

static void compare_one(uint64_t *random)
{
    struct arrays a, to;
    const float x[3] = {-0.5f, 0.0f, 0.6f}, y[3] = {0.25f, 1.0f, -0.5f};
    fill(&a, random);
    const struct scarp_samples sa = samples_of(&a), out = samples_of(&to);
#define ONE(call, shader)                                                                          \
    CHECK(call == SCARP_OK, #call);                                                                \
    for (int i = 0; i < POINTS; i++) {                                                             \
        const struct sample s = sample_at(&a, i);                                                  \
        compare(#shader, &to, i, shader);                                                          \
    }
    ONE(scarp_affine(POINTS, &sa, 1.7f, -0.3f, &out), chain_affine(s, 1.7f, -0.3f))
    ONE(scarp_clamp(POINTS, &sa, -0.25f, 0.75f, &out), chain_clamp(s, -0.25f, 0.75f))
    ONE(scarp_abs(POINTS, &sa, &out), chain_abs(s))
    ONE(scarp_smooth_abs(POINTS, &sa, 0.3f, &out), chain_smooth_abs(s, 0.3f, 0.3f * 0.3f))
    ONE(scarp_smoothstep(POINTS, &sa, 0.75f, -0.5f, &out),
        chain_smoothstep(s, 0.75f, 1.0f / (-0.5f - 0.75f)))
    ONE(scarp_terrace(POINTS, &sa, 3.0f, 0.7f, 0.6f, &out),
        chain_terrace(s, ((vec4){3.0f, 1.0f / 3.0f, 1.0f / 0.7f, 0.6f})))
    ONE(scarp_sqrt(POINTS, &sa, &out), chain_sqrt(s))
    ONE(scarp_sine(POINTS, &sa, &out), chain_sine(s))
    ONE(scarp_pulse(POINTS, &sa, &out), chain_pulse(s))
    ONE(scarp_curve(POINTS, &sa, 3, x, y, &out),
        chain_curve(s,
                    s.value >= x[1] ? ((vec4){x[1], y[1], 0.0f, 1.0f / (x[2] - x[1])})
                                    : ((vec4){x[0], y[0], 0.0f, 1.0f / (x[1] - x[0])}),
                    s.value >= x[1] ? ((vec4){x[2], y[2], 0.0f, 0.0f})
                                    : ((vec4){x[1], y[1], 0.0f, 1.0f / (x[2] - x[1])}),
                    ((vec4){x[0], y[0], 0.0f, 0.0f}), ((vec4){x[2], y[2], 0.0f, 0.0f})))
#undef ONE
    const struct scarp_samples value = {
        .value = to.of[0], .dx = to.of[1], .dy = to.of[2], .dz = to.of[3]};
    CHECK(scarp_slope(POINTS, &sa, &value) == SCARP_OK, "slope");
    for (int m = 4; m < MEMBERS; m++) {
        memset(to.of[m], 0, sizeof to.of[m]);
    }
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
        compare_two(&random);
        compare_one(&random);
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
