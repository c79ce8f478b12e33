/* SPDX-License-Identifier: MIT
 *
 * scarp_normals: errors, subsets, accuracy, the same bits everywhere, and numbers that are not
 * finite. Part of tests/test_api.c.
 */
#ifndef SCARP_TESTS_API_NORMALS_H
#define SCARP_TESTS_API_NORMALS_H

#include "outputs.h"

#define NORMALS 4099

struct normals {
    float dx[NORMALS], dy[NORMALS];
    float n[3][NORMALS], alone[3][NORMALS];
};

static inline void test_normals_errors(struct normals *a)
{
    static const float wrong[] = {NAN, INFINITY, -INFINITY};
    memset(a->n, POISON, sizeof a->n);
    float *const x = a->n[0], *const y = a->n[1], *const z = a->n[2];
    CHECK(scarp_normals(NORMALS, NULL, a->dy, 1.0f, x, y, z) == SCARP_ERROR_NULL, "dx");
    CHECK(scarp_normals(NORMALS, a->dx, NULL, 1.0f, x, y, z) == SCARP_ERROR_NULL, "dy");
    for (int i = 0; i < 3; i++) {
        CHECK(scarp_normals(NORMALS, a->dx, a->dy, wrong[i], x, y, z) == SCARP_ERROR_PARAMETER,
              "height_scale %g", (double)wrong[i]);
    }
    const size_t huge[] = {(size_t)PTRDIFF_MAX / sizeof(float) + 1, SIZE_MAX / 2, SIZE_MAX};
    for (int i = 0; i < 3; i++) {
        CHECK(scarp_normals(huge[i], a->dx, a->dy, 1.0f, x, y, z) == SCARP_ERROR_SIZE, "%zu",
              huge[i]);
    }
    CHECK(scarp_normals(0, NULL, NULL, NAN, NULL, NULL, NULL) == SCARP_OK, "count 0");
    CHECK(scarp_normals(0, a->dx, a->dy, 1.0f, x, y, z) == SCARP_OK, "count 0");
    CHECK(scarp_normals(NORMALS, a->dx, a->dy, 1.0f, NULL, NULL, NULL) == SCARP_OK, "no output");
    CHECK(all_poison(a->n, sizeof a->n), "outputs were written");
}

/* Any subset of the outputs has the bits that all together have. */
static inline void test_normals_subsets(struct normals *a)
{
    CHECK(scarp_normals(NORMALS, a->dx, a->dy, 2.5f, a->n[0], a->n[1], a->n[2]) == SCARP_OK, "all");
    for (unsigned mask = 0; mask < 8; mask++) {
        float *p[3];
        memset(a->alone, POISON, sizeof a->alone);
        for (int i = 0; i < 3; i++) {
            p[i] = (mask >> i & 1) != 0 ? a->alone[i] : NULL;
        }
        CHECK(scarp_normals(NORMALS, a->dx, a->dy, 2.5f, p[0], p[1], p[2]) == SCARP_OK, "%#x",
              mask);
        for (int i = 0; i < 3; i++) {
            CHECK(p[i] != NULL ? first_difference(p[i], a->n[i], NORMALS) == NORMALS
                               : all_poison(a->alone[i], sizeof a->alone[i]),
                  "subset %#x, component %d", mask, i);
        }
    }
}

/* Checks that `got` is within one unit in the last place of `exact`, which is double. */
static inline void expect_within_ulp(float got, double exact, const char *name, float dx, float dy,
                                     float scale)
{
    const float magnitude = fabsf((float)exact);
    const double ulp = (double)nextafterf(magnitude, HUGE_VALF) - (double)magnitude;
    CHECK(fabs((double)got - exact) <= ulp, "%s of (%a, %a), height_scale %a: %a, exactly %a", name,
          (double)dx, (double)dy, (double)scale, (double)got, exact);
}

static inline void test_normals_accuracy(struct normals *a, float scale)
{
    CHECK(scarp_normals(NORMALS, a->dx, a->dy, scale, a->n[0], a->n[1], a->n[2]) == SCARP_OK, "%a",
          (double)scale);
    for (int i = 0; i < NORMALS; i++) {
        const double x = -(double)scale * (double)a->dx[i];
        const double y = -(double)scale * (double)a->dy[i];
        const double length = sqrt(x * x + y * y + 1.0);
        expect_within_ulp(a->n[0][i], x / length, "nx", a->dx[i], a->dy[i], scale);
        expect_within_ulp(a->n[1][i], y / length, "ny", a->dx[i], a->dy[i], scale);
        expect_within_ulp(a->n[2][i], 1.0 / length, "nz", a->dx[i], a->dy[i], scale);
        const double nx = (double)a->n[0][i], ny = (double)a->n[1][i], nz = (double)a->n[2][i];
        CHECK(fabs(nx * nx + ny * ny + nz * nz - 1.0) < 0x1p-22, "length of (%a, %a, %a)", nx, ny,
              nz);
    }
}

/* A gradient that is not finite makes its own normal NaN, and no other. */
static inline void test_normals_special(void)
{
    static const float special[] = {NAN, -NAN, INFINITY, -INFINITY};
    static const float scales[] = {1.0f, 0.0f, -3e38f, 0x1p-149f};
    for (int i = 0; i < 64; i++) {
        float dx[33] = {0}, dy[33] = {0}, n[3][33];
        const int where = i * 7 % 33;
        const float scale = scales[i / 4 % 4];
        (i < 32 ? dx : dy)[where] = special[i % 4];
        (i < 32 ? dy : dx)[where] = i % 3 == 0 ? special[i / 3 % 4] : 1.5f;
        CHECK(scarp_normals(33, dx, dy, scale, n[0], n[1], n[2]) == SCARP_OK, "special");
        for (int p = 0; p < 33; p++) {
            for (int c = 0; c < 3; c++) {
                CHECK(p == where ? is_nan_bits(&n[c][p]) : n[c][p] == (c == 2 ? 1.0f : 0.0f),
                      "(%g, %g) at %d, height_scale %g: component %d of %d is %g",
                      (double)dx[where], (double)dy[where], where, (double)scale, c, p,
                      (double)n[c][p]);
            }
        }
    }
}

/* The instruction set under test gives the bits of the scalar reference. */
static inline void test_normals_bits(struct normals *a, float scale)
{
    const enum scarp_isa isa = scarp_isa_active();
    CHECK(scarp_normals(NORMALS, a->dx, a->dy, scale, a->n[0], a->n[1], a->n[2]) == SCARP_OK, "%a",
          (double)scale);
    CHECK(scarp_isa_select(SCARP_ISA_SCALAR) == SCARP_OK, "scalar cannot be selected");
    CHECK(scarp_normals(NORMALS, a->dx, a->dy, scale, a->alone[0], a->alone[1], a->alone[2]) ==
              SCARP_OK,
          "%a, scalar", (double)scale);
    CHECK(scarp_isa_select(isa) == SCARP_OK, "%s cannot be selected again", scarp_isa_name(isa));
    for (int i = 0; i < 3; i++) {
        const size_t where = first_difference(a->n[i], a->alone[i], NORMALS);
        CHECK(where == NORMALS, "height_scale %a: component %d of normal %zu is not scalar's",
              (double)scale, i, where);
    }
}

static inline void test_normals(void)
{
    static const float scales[] = {1.0f, -1.0f, 0.3f,     1000.0f,   0x1p-20f,
                                   0.0f, 1e38f, -3.4e38f, 0x1p-126f, 0x1p-149f};
    static const float huge[] = {1e38f, -3.4028235e38f, 0x1p-149f, -0.0f, 1.0f, 0x1p-126f, -1e38f};
    struct normals *const a = check_allocate(sizeof *a);
    uint64_t state = 3;
    for (int i = 0; i < NORMALS; i++) {
        const float span = ldexpf(1.0f, (int)(check_random(&state) % 32) - 16);
        a->dx[i] = check_random_float(&state, span);
        a->dy[i] = check_random_float(&state, i % 2 == 0 ? span : 1.0f);
        if (i < 49) {
            a->dx[i] = huge[i % 7];
            a->dy[i] = huge[i / 7];
        }
    }
    test_normals_errors(a);
    test_normals_subsets(a);
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        test_normals_accuracy(a, scales[i]);
        test_normals_bits(a, scales[i]);
    }
    test_normals_special();
    free(a);
}

#endif
