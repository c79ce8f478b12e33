/* SPDX-License-Identifier: MIT
 *
 * The fractals of scarp.h in double precision. Functions of the input are carried with their
 * derivatives, as (value, gradient, Hessian) and the derivative with respect to the phase, and the
 * formulas are then those of the values: the rules for products and quotients of such bundles do
 * the rest. No derivative of a fractal is written down here.
 */
#include "oracle.h"

#include <math.h>
#include <string.h>

/* Gives n of an octave as a function of the input: its derivatives become J^T g and J^T H J. */
static struct oracle_sample pulled_back(const struct oracle *oracle, int k,
                                        const struct oracle_sample *n)
{
    const int d = oracle->dimensions;
    const double(*const axes)[3] = oracle->octave[k].of.axes;
    struct oracle_sample f = {.value = n->value, .phase = n->phase};
    for (int i = 0; i < d; i++) {
        for (int a = 0; a < d; a++) {
            f.gradient[i] += axes[a][i] * n->gradient[a];
            double row = 0.0; /* (H J)[a][i] */
            for (int b = 0; b < d; b++) {
                row += n->hessian[a][b] * axes[b][i];
            }
            for (int j = 0; j < d; j++) {
                f.hessian[i][j] += axes[a][j] * row;
            }
        }
    }
    return f;
}

/* sum += a f */
static void add(struct oracle_sample *sum, double a, const struct oracle_sample *f)
{
    sum->value += a * f->value;
    sum->phase += a * f->phase;
    for (int i = 0; i < 3; i++) {
        sum->gradient[i] += a * f->gradient[i];
        for (int j = 0; j < 3; j++) {
            sum->hessian[i][j] += a * f->hessian[i][j];
        }
    }
}

static struct oracle_sample times(const struct oracle_sample *f, const struct oracle_sample *g)
{
    struct oracle_sample product = {.value = f->value * g->value,
                                    .phase = f->phase * g->value + f->value * g->phase};
    for (int i = 0; i < 3; i++) {
        product.gradient[i] = f->gradient[i] * g->value + f->value * g->gradient[i];
        for (int j = 0; j < 3; j++) {
            product.hessian[i][j] = f->hessian[i][j] * g->value + f->gradient[i] * g->gradient[j] +
                                    f->gradient[j] * g->gradient[i] + f->value * g->hessian[i][j];
        }
    }
    return product;
}

static struct oracle_sample magnitude(const struct oracle_sample *f)
{
    struct oracle_sample m = {.value = 0.0};
    add(&m, f->value > 0.0 ? 1.0 : f->value < 0.0 ? -1.0 : 0.0, f);
    return m;
}

/* Turbulence: sum a |n|. Returns |n|, and notes the crease. */
static struct oracle_sample folded(const struct oracle *oracle, int k,
                                   const struct oracle_sample *n, struct oracle_creases *creases)
{
    const struct oracle_sample f = pulled_back(oracle, k, n);
    creases->clearance = fmin(creases->clearance, fabs(f.value));
    creases->side |= (uint64_t)(f.value < 0.0) << k;
    return magnitude(&f);
}

/* Ridged: s = v (1 - |n|)^2; then v = min(2 s, 1). */
static struct oracle_sample ridge(const struct oracle *oracle, int k, const struct oracle_sample *n,
                                  struct oracle_sample *weight, struct oracle_creases *creases)
{
    const struct oracle_sample m = folded(oracle, k, n, creases), one = {.value = 1.0};
    struct oracle_sample r = one, twice = {.value = 0.0};
    add(&r, -1.0, &m);
    const struct oracle_sample squared = times(&r, &r), s = times(weight, &squared);
    add(&twice, 2.0, &s);
    const int full = twice.value >= 1.0;
    if (k < oracle->octaves - 1) { /* nothing follows the last one */
        creases->clearance = fmin(creases->clearance, fabs(twice.value - 1.0));
        creases->side |= (uint64_t)full << (32 + k);
    }
    *weight = full ? one : twice;
    return s;
}

/* Ping-pong: t = (n + 1) sharpness, folded to [-1, 1] with period 2. */
static struct oracle_sample pingpong(const struct oracle *oracle, int k,
                                     const struct oracle_sample *n, struct oracle_creases *creases)
{
    const struct oracle_sample f = pulled_back(oracle, k, n);
    const double t = (f.value + 1.0) * oracle->sharpness;
    const int falls = fmod(floor(t), 2.0) != 0.0;
    struct oracle_sample s = {.value = 0.0};
    creases->clearance = fmin(creases->clearance, fabs(t - floor(t + 0.5)) / oracle->sharpness);
    creases->side |= (uint64_t)falls << k;
    add(&s, falls ? -2.0 * oracle->sharpness : 2.0 * oracle->sharpness, &f);
    const double folded = t - 2.0 * floor(t / 2.0);
    s.value = 2.0 * (falls ? 2.0 - folded : folded) - 1.0;
    return s;
}

/* Hybrid: u = v ((1 - 2^-17) n + sharpness); then v = gain^k u, clamped to [-1, 1]. */
static struct oracle_sample hybrid(const struct oracle *oracle, int k,
                                   const struct oracle_sample *n, struct oracle_sample *weight,
                                   struct oracle_creases *creases)
{
    const struct oracle_sample f = pulled_back(oracle, k, n);
    struct oracle_sample r = {.value = oracle->sharpness}, next = {.value = 0.0};
    add(&r, 1.0 - 0x1p-17, &f);
    const struct oracle_sample u = times(weight, &r);
    add(&next, oracle->octave[k].of.share, &u);
    const struct oracle_sample end = {.value = next.value < 0.0 ? -1.0 : 1.0};
    const int full = fabs(next.value) >= 1.0;
    if (k < oracle->octaves - 1) { /* nothing follows the last one */
        creases->clearance = fmin(creases->clearance, fabs(fabs(next.value) - 1.0));
        creases->side |= (uint64_t)full << (32 + k);
    }
    *weight = full ? end : next;
    return u;
}

/* Erosion: q n with q = 1 / (1 + erosion d.d). `slope` holds the components of d as functions of
   the input: the gradient of g_i is row i of H J. Hessians would need third derivatives; what is
   left in them here is not used. */
static struct oracle_sample eroded(const struct oracle *oracle, int k,
                                   const struct oracle_sample *n, struct oracle_sample slope[3],
                                   int frozen)
{
    struct oracle_sample denominator = {.value = 1.0};
    for (int i = 0; i < oracle->dimensions; i++) {
        slope[i].value += n->gradient[i];
        slope[i].phase += n->gradient_phase[i];
        for (int j = 0; j < oracle->dimensions; j++) {
            for (int b = 0; b < oracle->dimensions; b++) {
                slope[i].gradient[j] += n->hessian[i][b] * oracle->octave[k].of.axes[b][j];
            }
        }
        const struct oracle_sample square = times(&slope[i], &slope[i]);
        add(&denominator, oracle->erosion, &square);
    }
    const struct oracle_sample f = pulled_back(oracle, k, n);
    struct oracle_sample s = {.value = f.value / denominator.value};
    s.phase = (f.phase - s.value * denominator.phase) / denominator.value;
    for (int i = 0; i < 3; i++) { /* the quotient's rule */
        const double change = frozen ? 0.0 : denominator.gradient[i];
        s.gradient[i] = (f.gradient[i] - s.value * change) / denominator.value;
    }
    return s;
}

/* Octave k where it looks at y = x + c S, as a function of x, and the components of its slope. */
static struct oracle_sample bent(const struct oracle *oracle, enum oracle_rounding rounding, int k,
                                 const double x[3], const struct oracle_sample s[3],
                                 struct oracle_sample slope[3])
{
    const double f = oracle->octave[k].of.frequency;
    const double c =
        oracle->sharpness / (oracle->fractal == SCARP_SWISS ? oracle->octave[0].of.frequency : f);
    const double y[3] = {x[0] + c * s[0].value, x[1] + c * s[1].value, x[2] + c * s[2].value};
    struct oracle_sample at, n;
    oracle_octave_at(oracle, rounding, k, y, &at);
    const struct oracle_sample by_y = pulled_back(oracle, k, &at);
    n = (struct oracle_sample){.value = by_y.value};
    for (int m = 0; m < 3; m++) {
        slope[m] = (struct oracle_sample){.value = by_y.gradient[m] / f};
        for (int j = 0; j < 3; j++) {
            const double yj = (m == j ? 1.0 : 0.0) + c * s[m].gradient[j]; /* of y_m */
            n.gradient[j] += by_y.gradient[m] * yj;
            for (int i = 0; i < 3; i++) {
                slope[m].gradient[j] +=
                    by_y.hessian[m][i] * ((i == j ? 1.0 : 0.0) + c * s[i].gradient[j]) / f;
            }
        }
    }
    return n;
}

/* Swiss: u max(0, 1 - |n|), and the factor of its slope is -(a / a_0) u n. */
static struct oracle_sample swiss(const struct oracle *oracle, int k, const struct oracle_sample *n,
                                  const struct oracle_sample *left, struct oracle_sample *factor,
                                  struct oracle_creases *creases)
{
    const struct oracle_sample m = magnitude(n), un = times(left, n);
    struct oracle_sample r = {.value = 1.0};
    add(&r, -1.0, &m);
    creases->clearance = fmin(creases->clearance, fmin(m.value, fabs(r.value)));
    creases->side |= (uint64_t)(n->value < 0.0) << k;
    if (r.value < 0.0) {
        r = (struct oracle_sample){.value = 0.0};
    }
    *factor = (struct oracle_sample){.value = 0.0};
    add(factor, -oracle->octave[k].of.weight / oracle->octave[0].of.weight, &un);
    return times(left, &r);
}

/* Jordan: q n^2 with q = 1 - erosion / (1 + S.S). */
static struct oracle_sample jordan(const struct oracle *oracle, int k,
                                   const struct oracle_sample *n, const struct oracle_sample s[3])
{
    const struct oracle_sample square = times(n, n);
    struct oracle_sample steep = {.value = 1.0}, q = {.value = 1.0};
    for (int m = 0; m < oracle->dimensions; m++) {
        const struct oracle_sample of = times(&s[m], &s[m]);
        add(&steep, 1.0, &of);
    }
    if (k > 0) {
        add(&q, oracle->erosion / (steep.value * steep.value), &steep);
        q.value = 1.0 - oracle->erosion / steep.value;
    }
    return times(&q, &square);
}

/* The fractals that bend. Hessians would need third derivatives. */
static void sum_bent(const struct oracle *oracle, enum oracle_rounding rounding, const double x[3],
                     int frozen, struct oracle_sample *sum, struct oracle_creases *creases)
{
    struct oracle_sample left = {.value = 1.0}, s[3] = {{.value = 0.0}};
    *sum = (struct oracle_sample){.value = 0.0};
    *creases = (struct oracle_creases){.clearance = HUGE_VAL, .border = 1.0, .nearest = 1.0};
    for (int k = 0; k < oracle->octaves; k++) {
        struct oracle_sample slope[3], ratio = {.value = 0.0};
        const struct oracle_sample n = bent(oracle, rounding, k, x, s, slope);
        const int is_swiss = oracle->fractal == SCARP_SWISS;
        struct oracle_sample factor = n;
        const struct oracle_sample part =
            is_swiss ? swiss(oracle, k, &n, &left, &factor, creases) : jordan(oracle, k, &n, s);
        add(sum, oracle->octave[k].of.weight, &part);
        for (int m = 0; m < oracle->dimensions; m++) {
            const struct oracle_sample of = times(&factor, &slope[m]);
            add(&s[m], 1.0, &of);
            if (frozen) {
                s[m] = (struct oracle_sample){.value = s[m].value};
            }
        }
        add(&ratio, 1.0 / oracle->octave[0].of.weight, sum);
        if (is_swiss && k < oracle->octaves - 1) {
            creases->clearance = fmin(creases->clearance, fabs(ratio.value - 1.0));
            creases->side |= (uint64_t)(ratio.value < 1.0) << (32 + k);
            left = ratio.value < 1.0 ? times(&left, &ratio) : left;
        }
    }
    memset(sum->hessian, 0, sizeof sum->hessian);
}

static void sum_octaves(const struct oracle *oracle, enum oracle_rounding rounding,
                        const double x[3], int frozen, struct oracle_sample *sum,
                        struct oracle_creases *creases)
{
    struct oracle_sample weight = {.value = 1.0}, slope[3] = {{.value = 0.0}};
    if (fractal_bends(oracle->fractal)) {
        sum_bent(oracle, rounding, x, frozen, sum, creases);
        return;
    }
    *sum = (struct oracle_sample){.value = 0.0};
    *creases = (struct oracle_creases){.clearance = HUGE_VAL, .border = 1.0, .nearest = 1.0};
    for (int k = 0; k < oracle->octaves; k++) {
        struct oracle_sample n, s;
        oracle_octave_at(oracle, rounding, k, x, &n);
        creases->border = fmin(creases->border, n.clearance);
        creases->nearest = fmin(creases->nearest, n.nearest);
        switch (oracle->fractal) {
        case SCARP_TURBULENCE: s = folded(oracle, k, &n, creases); break;
        case SCARP_RIDGED: s = ridge(oracle, k, &n, &weight, creases); break;
        case SCARP_PINGPONG: s = pingpong(oracle, k, &n, creases); break;
        case SCARP_HYBRID: s = hybrid(oracle, k, &n, &weight, creases); break;
        case SCARP_EROSION: s = eroded(oracle, k, &n, slope, frozen); break;
        default: s = pulled_back(oracle, k, &n); break;
        }
        add(sum, oracle->octave[k].of.weight, &s);
    }
}

void oracle_evaluate_creased(const struct oracle *oracle, enum oracle_rounding rounding,
                             const double x[3], struct oracle_sample *sum,
                             struct oracle_creases *creases)
{
    sum_octaves(oracle, rounding, x, 0, sum, creases);
}

void oracle_frozen_gradient(const struct oracle *oracle, enum oracle_rounding rounding,
                            const double x[3], double gradient[3])
{
    struct oracle_sample sum;
    struct oracle_creases creases;
    sum_octaves(oracle, rounding, x, 1, &sum, &creases);
    for (int i = 0; i < 3; i++) {
        gradient[i] = sum.gradient[i];
    }
}
