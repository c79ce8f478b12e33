/* SPDX-License-Identifier: MIT
 *
 * What the tests of the fractals share: blocks of points, the library's results in the oracle's
 * form, how results differ. Header only; included by each tests/test_fractal*.c.
 */
#ifndef SCARP_TESTS_FRACTAL_H
#define SCARP_TESTS_FRACTAL_H

#include "oracle.h"
#include "outputs.h"

#define BLOCK 1000

static const char *const fractal_fades[] = {"quintic", "cubic"};

/* Points in both precisions, equal where they are drawn as floats, and arrays for the outputs. */
struct block {
    double d[3][BLOCK];
    float f[3][BLOCK];
    struct outputs out;
};

static inline struct block *block_make(void)
{
    struct block *const block = check_allocate(sizeof *block);
    memset(block, 0, sizeof *block);
    block->out = outputs_make(BLOCK);
    return block;
}

static inline void block_free(struct block *block)
{
    outputs_free(&block->out);
    free(block);
}

static inline void block_random(struct block *block, uint64_t *random, float span)
{
    for (size_t i = 0; i < BLOCK; i++) {
        for (int axis = 0; axis < 3; axis++) {
            block->f[axis][i] = check_random_float(random, span);
            block->d[axis][i] = (double)block->f[axis][i];
        }
    }
}

static inline void block_sample(struct block *block, const struct scarp_noise *noise,
                                enum function f, size_t count)
{
    const struct inputs in = {{block->f[0], block->f[1], block->f[2]},
                              {block->d[0], block->d[1], block->d[2]}};
    const struct scarp_samples out = outputs_subset(&block->out, outputs_of(noise, f));
    outputs_poison(&block->out);
    const enum scarp_status status = function_call(f, noise, count, &in, &out);
    CHECK(status == SCARP_OK, "%s: %s", function_names[f], scarp_status_text(status));
}

static inline void block_point(const struct block *block, size_t i, double x[3])
{
    for (int axis = 0; axis < 3; axis++) {
        x[axis] = block->d[axis][i];
    }
}

/* Gives what a call of `f` wrote for point i, in the oracle's form. */
static inline struct oracle_sample
outputs_sample(const struct outputs *o, const struct scarp_noise *noise, enum function f, size_t i)
{
    const unsigned mask = outputs_of(noise, f);
    struct oracle_sample n = {.value = (double)o->array[OUTPUT_value][i]};
    for (int m = OUTPUT_value + 1; m < OUTPUTS; m++) {
        const double v = (mask >> m & 1) != 0 ? (double)o->array[m][i] : 0.0;
        const int a = output_kinds[m].axes[0], b = output_kinds[m].axes[1];
        if (m == OUTPUT_dphase) {
            n.phase = v;
        } else if (output_kinds[m].order == 1) {
            n.gradient[a] = v;
        } else {
            n.hessian[a][b] = n.hessian[b][a] = v;
        }
    }
    return n;
}

static inline struct oracle_sample
block_result(const struct block *block, const struct scarp_noise *noise, enum function f, size_t i)
{
    return outputs_sample(&block->out, noise, f, i);
}

/* The largest difference of any value [0], gradient [1] and Hessian [2] component. */
static inline void difference(const struct oracle_sample *p, const struct oracle_sample *q,
                              double largest[3])
{
    largest[0] = fabs(p->value - q->value);
    largest[1] = largest[2] = 0.0;
    for (int i = 0; i < 3; i++) {
        largest[1] = larger(largest[1], fabs(p->gradient[i] - q->gradient[i]));
        for (int j = 0; j < 3; j++) {
            largest[2] = larger(largest[2], fabs(p->hessian[i][j] - q->hessian[i][j]));
        }
    }
}

/* sum |a_k| f_k^order: the unit for differences of that order. */
static inline double fractal_unit(const struct oracle *oracle, int order)
{
    double sum = 0.0;
    for (int k = 0; k < oracle->octaves; k++) {
        sum += fabs(oracle->octave[k].of.weight) * pow(oracle->octave[k].of.frequency, order);
    }
    return sum;
}

/* The unit for differences of derivatives with respect to the phase */
static inline double phase_unit(const struct oracle *oracle)
{
    double sum = 0.0;
    for (int k = 0; k < oracle->octaves; k++) {
        sum += fabs(oracle->octave[k].of.weight) * ldexp(6.283185307, k);
    }
    return sum;
}

#endif
