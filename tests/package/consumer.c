/* SPDX-License-Identifier: MIT
 *
 * What a user of the library writes; built by every test of a way to get at it. Valid as C11 and as
 * C++11, and free of libm, so that what the library itself needs must come from the package.
 */
#include <stdio.h>
#include <string.h>

#include <scarp.h>

#define COUNT 37
#define STEP 0.015625f /* of the central differences: exact in binary */

static int failures;

static void expect(int condition, const char *what)
{
    if (!condition) {
        printf("FAILED: %s\n", what);
        failures++;
    }
}

static int near(float a, float b)
{
    const float difference = a - b;
    return difference < 0.01f && difference > -0.01f;
}

static void sample(void)
{
    struct scarp_noise noise;
    struct scarp_samples out, left, right;
    float x[COUNT], y[COUNT], x_left[COUNT], x_right[COUNT];
    float value[COUNT], dx[COUNT], dy[COUNT], value_left[COUNT], value_right[COUNT];
    int zeros = 0, wrong = 0;
    memset(&noise, 0, sizeof noise);
    memset(&out, 0, sizeof out);
    memset(&left, 0, sizeof left);
    memset(&right, 0, sizeof right);
    noise.seed = 42;
    for (int i = 0; i < COUNT; i++) {
        x[i] = 0.3125f + 0.171875f * (float)i;
        y[i] = 0.4375f;
        x_left[i] = x[i] - STEP;
        x_right[i] = x[i] + STEP;
        value[i] = dx[i] = dy[i] = value_left[i] = value_right[i] = 0.0f;
    }
    out.value = value;
    out.dx = dx;
    out.dy = dy;
    left.value = value_left;
    right.value = value_right;
    expect(scarp_sample2(&noise, COUNT, x, y, &out) == SCARP_OK, "sample");
    expect(scarp_sample2(&noise, COUNT, x_left, y, &left) == SCARP_OK, "sample on the left");
    expect(scarp_sample2(&noise, COUNT, x_right, y, &right) == SCARP_OK, "sample on the right");
    for (int i = 0; i < COUNT; i++) {
        zeros += value[i] == 0.0f || dx[i] == 0.0f || dy[i] == 0.0f;
        wrong += !near(dx[i], (value_right[i] - value_left[i]) / (2.0f * STEP));
    }
    expect(zeros == 0, "values and gradients are not zero");
    expect(wrong == 0, "the gradient is that of the value");
    expect(scarp_sample2(NULL, COUNT, x, y, &out) == SCARP_ERROR_NULL, "no noise: an error");
    noise.octaves = 1000.0f;
    expect(scarp_sample2(&noise, COUNT, x, y, &out) == SCARP_ERROR_PARAMETER,
           "1000 octaves: an error");
}

int main(void)
{
    char version[64];
    snprintf(version, sizeof version, "%d.%d.%d", SCARP_VERSION_MAJOR, SCARP_VERSION_MINOR,
             SCARP_VERSION_PATCH);
    expect(strcmp(scarp_version(), version) == 0, "library and header have one version");
    expect(strlen(scarp_status_text(SCARP_OK)) > 0, "a status has a text");
    sample();
    printf("scarp %s, %s: %s\n", scarp_version(), scarp_isa_name(scarp_isa_active()),
           failures == 0 ? "ok" : "FAILED");
    return failures != 0;
}
