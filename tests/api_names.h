/* SPDX-License-Identifier: MIT
 *
 * The words of the library: statuses, version, names of enumerators and how clients iterate over
 * them, names of members at fault. Part of tests/test_api.c.
 */
#ifndef SCARP_TESTS_API_NAMES_H
#define SCARP_TESTS_API_NAMES_H

#include <float.h>
#include <limits.h>

#include "outputs.h"

static inline void test_texts(void)
{
    const char *texts[SCARP_ERROR_UNSUPPORTED + 2];
    for (int i = 0; i <= SCARP_ERROR_UNSUPPORTED + 1; i++) { /* the last one is unknown */
        texts[i] = scarp_status_text((enum scarp_status)i);
        CHECK(texts[i] != NULL && strlen(texts[i]) > 3, "status %d", i);
        CHECK(texts[i][strlen(texts[i]) - 1] != '.', "status %d ends with a full stop", i);
        for (int j = 0; j < i; j++) {
            CHECK(strcmp(texts[i], texts[j]) != 0, "statuses %d and %d: %s", i, j, texts[i]);
        }
    }
    CHECK(scarp_status_text((enum scarp_status) - 1) != NULL, "status -1");
    char version[32];
    snprintf(version, sizeof version, "%d.%d.%d", SCARP_VERSION_MAJOR, SCARP_VERSION_MINOR,
             SCARP_VERSION_PATCH);
    CHECK(strcmp(scarp_version(), version) == 0, "%s, header %s", scarp_version(), version);
}

/* Checks that `call` gives the names, a list that ends in NULL, for 0, 1, ..., and NULL for all
   other numbers. */
static inline void expect_names(const char *what, const char *(*call)(int),
                                const char *const *names)
{
    int count = 0;
    for (; names[count] != NULL; count++) {
        const char *const name = call(count);
        CHECK(name != NULL && strcmp(name, names[count]) == 0, "%s %d: %s, not %s", what, count,
              name != NULL ? name : "NULL", names[count]);
    }
    const int unknown[] = {count, count + 1, 64, 256, 65536, INT_MAX, -1, -2, INT_MIN};
    for (size_t i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
        CHECK(call(unknown[i]) == NULL, "%s %d has a name", what, unknown[i]);
    }
}

/* The calls take the enumerators that have names, and no others. */
static inline void test_names_known(void)
{
    for (int i = -2; i < 70; i++) {
        const struct scarp_noise basis = {.basis = (enum scarp_basis)i};
        const struct scarp_noise fade = {.fade = (enum scarp_fade)i};
        const struct scarp_noise fractal = {.fractal = (enum scarp_fractal)i};
        CHECK((scarp_noise_check(&basis, 2, NULL) == SCARP_OK) == (basis_name(i) != NULL),
              "basis %d", i);
        CHECK((scarp_noise_check(&fade, 2, NULL) == SCARP_OK) == (fade_name(i) != NULL), "fade %d",
              i);
        CHECK((scarp_noise_check(&fractal, 2, NULL) == SCARP_OK) == (fractal_name(i) != NULL),
              "fractal %d", i);
    }
}

static inline void test_names(void)
{
#define NAME(enumerator, name, ...) [SCARP_##enumerator] = name,
    static const char *const bases[SCARP_BASES + 1] = {SCARP_BASIS_LIST(NAME)};
    static const char *const fractals[SCARP_FRACTALS + 1] = {SCARP_FRACTAL_LIST(NAME)};
#undef NAME
    static const char *const fades[] = {
        [SCARP_QUINTIC] = "quintic", [SCARP_CUBIC] = "cubic", [SCARP_CUBIC + 1] = NULL};
    static const char *const isas[] = {"none", "scalar",  "sse4.1",  "avx2", "avx512",
                                       "neon", "generic", "wasm128", NULL};
    expect_names("basis", basis_name, bases);
    expect_names("fade", fade_name, fades);
    expect_names("fractal", fractal_name, fractals);
    expect_names("instruction set", isa_name, isas);
    test_names_known();
}

static inline void expect_member(const struct scarp_noise *noise, int dimensions,
                                 enum scarp_status expected, const char *member)
{
    const char *found = "not written";
    const enum scarp_status status = scarp_noise_check(noise, dimensions, &found);
    CHECK(status == expected, "%s: %s", member != NULL ? member : "no member",
          scarp_status_text(status));
    CHECK(found == member || (found != NULL && member != NULL && strcmp(found, member) == 0),
          "%s is at fault, not %s", found != NULL ? found : "no member",
          member != NULL ? member : "none");
    CHECK(scarp_noise_check(noise, dimensions, NULL) == expected, "%s without a name",
          member != NULL ? member : "no member");
}

/* Where there are many faults, the first one is named. This mends them one by one. */
static inline void test_check_order(void)
{
    struct scarp_noise noise;
    const struct scarp_noise bad = {.octaves = -1.0f};
    const enum scarp_status outside = SCARP_ERROR_PARAMETER, reserved = SCARP_ERROR_UNSUPPORTED;
    memset(&noise, 0xff, sizeof noise);
    expect_member(&noise, 4, SCARP_ERROR_ENUM, "basis");
    noise.basis = SCARP_VALUE;
    expect_member(&noise, 4, SCARP_ERROR_ENUM, "fade");
    noise.fade = SCARP_CUBIC;
    expect_member(&noise, 4, SCARP_ERROR_ENUM, "fractal");
    noise.fractal = SCARP_EROSION;
    expect_member(&noise, 4, outside, "frequency");
    noise.frequency = 0x1p40;
    expect_member(&noise, 4, outside, "octaves");
    noise.octaves = 10.0f;
    expect_member(&noise, 4, outside, "lacunarity");
    noise.lacunarity = 2.0f;
    expect_member(&noise, 4, outside, "gain");
    noise.gain = 0.5f;
    expect_member(&noise, 4, outside, "amplitude");
    noise.amplitude = -2.0f;
    expect_member(&noise, 4, outside, "erosion");
    noise.erosion = 3.0f;
    expect_member(&noise, 4, outside, "phase");
    noise.phase = -INFINITY;
    expect_member(&noise, 4, outside, "phase");
    noise.phase = -FLT_MAX;
    expect_member(&noise, 4, outside, "jitter");
    noise.jitter = 1.0f;
    expect_member(&noise, 4, outside, "sharpness");
    noise.sharpness = 1.0f;
    expect_member(&noise, 4, outside, "of_octaves");
    noise.of_octaves = 10.0f;
    expect_member(&noise, 4, outside, "octaves"); /* the last one has the frequency 2^49 */
    noise.octaves = 9.0f;
    noise.warp = &bad;
    expect_member(&noise, 4, reserved, "spare");
    memset(noise.spare, 0, sizeof noise.spare);
    expect_member(&noise, 4, reserved, "spare");
    noise.spare_word = 0;                        /* offset_first may be any number */
    expect_member(&noise, 4, reserved, "phase"); /* of value noise */
    noise.phase = -0.0f;
    expect_member(&noise, 4, outside, NULL);
    expect_member(&noise, 1, outside, NULL);
    expect_member(&noise, 258, outside, NULL);
    expect_member(&noise, INT_MIN, outside, NULL);
    expect_member(&noise, 3, outside, "period[0]");
    noise.period[0] = 1;
    expect_member(&noise, 3, outside, "period[1]");
    noise.period[1] = 0;
    expect_member(&noise, 3, outside, "period[2]");
    noise.period[2] = 0;
    expect_member(&noise, 3, reserved, "rotate");
    noise.rotate = 0;
    expect_member(&noise, 3, outside, "warp.octaves");
    noise.warp = &noise; /* without end */
    expect_member(&noise, 3, reserved, "warp.warp.warp.warp.warp");
    noise.warp = NULL;
    expect_member(&noise, 2, SCARP_OK, NULL);
    expect_member(&noise, 3, SCARP_OK, NULL);
    expect_member(NULL, 2, SCARP_ERROR_NULL, NULL);
    expect_member(NULL, 4, SCARP_ERROR_NULL, NULL);
}

#endif
