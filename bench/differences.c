/* SPDX-License-Identifier: MIT
 *
 * Gradients from differences of values, as well as a careful user would write it: in chunks that
 * stay in the first-level cache, with as few calls per chunk as there are positions to look at.
 */
#include "differences.h"

#define CHUNK 512

/* A power of two, so that x + STEP is exact for coordinates below 2^15: only the method itself
   makes errors, by truncation and cancellation. */
#define STEP 0x1p-8f

static void shift(size_t count, const float *x, float step, float *shifted)
{
    for (size_t i = 0; i < count; i++) {
        shifted[i] = x[i] + step;
    }
}

static void subtract(size_t count, const float *high, const float *low, float scale, float *slope)
{
    for (size_t i = 0; i < count; i++) {
        slope[i] = (high[i] - low[i]) * scale;
    }
}

static void difference_chunk(const struct bench_field *field, int central, size_t count,
                             const float *const x[3], float *value, float *const gradient[3])
{
    float shifted[CHUNK], high[CHUNK], low[CHUNK];
    field->values(field->state, count, x, value);
    for (int d = 0; d < field->dimensions; d++) {
        const float *near[3] = {x[0], x[1], x[2]};
        near[d] = shifted;
        shift(count, x[d], STEP, shifted);
        field->values(field->state, count, near, high);
        if (central) {
            shift(count, x[d], -STEP, shifted);
            field->values(field->state, count, near, low);
        }
        subtract(count, high, central ? low : value, central ? 0.5f / STEP : 1.0f / STEP,
                 gradient[d]);
    }
}

void bench_differences(const struct bench_field *field, int central, size_t count,
                       const float *const x[3], float *value, float *const gradient[3])
{
    for (size_t first = 0; first < count; first += CHUNK) {
        const size_t n = count - first < CHUNK ? count - first : CHUNK;
        const float *from[3] = {NULL, NULL, NULL};
        float *to[3] = {NULL, NULL, NULL};
        for (int d = 0; d < field->dimensions; d++) {
            from[d] = x[d] + first;
            to[d] = gradient[d] + first;
        }
        difference_chunk(field, central, n, from, value + first, to);
    }
}
