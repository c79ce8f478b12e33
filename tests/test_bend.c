/* SPDX-License-Identifier: MIT
 *
 * Rebuilds Swiss and Jordan noise from single-octave calls as the text of scarp.h says, in double:
 * where octaves look, and the formulas for value and gradient. Checks their ranges, what they
 * repeat, what they do not support, and their plans. (test_fractal.c compares them with the oracle.)
 * Argument: the instruction set.
 */
#include "fractal.h"
#include "octaves.h"

#define OCTAVES 5 /* at most */

/* Points may lie on the other side of a crease where |n_k|, or its distance from 1, is below this,
   or that of the sum over a_0 from 1. */
#define CREASE 1e-4

static int dimensions;

/* What goes from octave to octave at a point: S and its Jacobian, u, the sum. */
struct state {
    double s[3], by[3][3], u, du[3], sum, gradient[3];
    int crease;
};

static double reach_of(const struct scarp_noise *noise, const struct octave *octave, int k)
{
    return (double)noise->sharpness / octave[noise->fractal == SCARP_SWISS ? 0 : k].frequency;
}

/* p_k = J_k y_k + o_k with y_k = x + c_k S_k: of floats in float, of doubles in double. */
static void place(struct block *to, const struct block *x, size_t i, const struct octave *octave,
                  const struct state *state, double reach)
{
    double y[3];
    float y32[3];
    for (int axis = 0; axis < dimensions; axis++) {
        y[axis] = x->d[axis][i] + reach * state->s[axis];
        y32[axis] = x->f[axis][i] + (float)(reach * state->s[axis]);
    }
    for (int row = 0; row < dimensions; row++) {
        double p = octave->axes[row][0] * y[0];
        float p32 = (float)octave->axes[row][0] * y32[0];
        for (int l = 1; l < dimensions; l++) {
            p += octave->axes[row][l] * y[l];
            p32 += (float)octave->axes[row][l] * y32[l];
        }
        to->d[row][i] = p + octave->offset[row];
        to->f[row][i] = p32 + (float)octave->offset[row];
    }
}

/* Octave k as single-octave noise. */
static struct scarp_noise single_of(const struct scarp_noise *noise, const struct octave *octave,
                                    int k)
{
    struct scarp_noise single = {.basis = noise->basis,
                                 .fade = noise->fade,
                                 .jitter = noise->jitter,
                                 .seed = octave->seed,
                                 .phase = ldexpf(noise->phase, k)};
    for (int axis = 0; axis < 3; axis++) {
        single.period[axis] =
            (uint32_t)((double)noise->period[axis] * pow((double)noise->lacunarity, k));
    }
    return single;
}

/* The octave's n by x, and its slope m with the derivatives by x. */
struct seen {
    double n, nx[3], m[3], mx[3][3];
};

static void see(struct seen *seen, const struct oracle_sample *n, const struct octave *octave,
                const struct state *state, double reach)
{
    const double head = 1.0 - 0x1p-17;
    double hessian[3][3] = {{0.0}}, gradient[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < 81; i++) { /* by y: J^T g, J^T H J */
        const int a = i / 27, b = i / 9 % 3, l = i / 3 % 3, m = i % 3;
        hessian[a][b] += octave->axes[l][a] * n->hessian[l][m] * octave->axes[m][b] / head;
        gradient[a] += b == 0 && m == 0 ? octave->axes[l][a] * n->gradient[l] / head : 0.0;
    }
    memset(seen, 0, sizeof *seen);
    seen->n = n->value / head;
    for (int i = 0; i < 9; i++) {
        const double a = (i / 3 == i % 3 ? 1.0 : 0.0) + reach * state->by[i / 3][i % 3];
        seen->nx[i % 3] += gradient[i / 3] * a;
        for (int m = 0; m < 3; m++) {
            seen->mx[m][i % 3] += hessian[m][i / 3] * a / octave->frequency;
        }
    }
    for (int m = 0; m < 3; m++) {
        seen->m[m] = gradient[m] / octave->frequency;
    }
}

/* S += factor m */
static void add_slope(struct state *state, const struct seen *seen, double factor,
                      const double by[3])
{
    for (int i = 0; i < 3; i++) {
        state->s[i] += factor * seen->m[i];
        for (int j = 0; j < 3; j++) {
            state->by[i][j] += by[j] * seen->m[i] + factor * seen->mx[i][j];
        }
    }
}

static void add_swiss(struct state *state, const struct seen *seen, double a, double a0)
{
    const double n = seen->n, w = fmax(0.0, 1.0 - fabs(n)), u = state->u;
    double by[3];
    for (int j = 0; j < 3; j++) {
        const double wj = fabs(n) > 1.0 || n == 0.0 ? 0.0 : n > 0.0 ? -seen->nx[j] : seen->nx[j];
        by[j] = -a / a0 * (state->du[j] * n + u * seen->nx[j]);
        state->gradient[j] += a * (state->du[j] * w + u * wj);
    }
    state->sum += a * u * w;
    add_slope(state, seen, -a / a0 * u * n, by);
    const double share = state->sum / a0;
    state->crease |= fabs(n) < CREASE || fabs(fabs(n) - 1.0) < CREASE || fabs(share - 1.0) < CREASE;
    for (int j = 0; j < 3 && share < 1.0; j++) {
        state->du[j] = state->du[j] * share + u * state->gradient[j] / a0;
    }
    state->u *= fmin(1.0, share);
}

static void add_jordan(struct state *state, const struct seen *seen, double a, double erosion)
{
    const double *const s = state->s;
    const double p = 1.0 / (1.0 + s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    const double q = 1.0 - erosion * p, n = seen->n;
    for (int j = 0; j < 3; j++) {
        const double ss = s[0] * state->by[0][j] + s[1] * state->by[1][j] + s[2] * state->by[2][j];
        state->gradient[j] += a * (2.0 * erosion * p * p * ss * n * n + q * 2.0 * n * seen->nx[j]);
    }
    state->sum += a * q * n * n;
    add_slope(state, seen, n, seen->nx);
}

/* The sum at all points of a block. */
static void rebuild(const struct scarp_noise *noise, enum function f, const struct block *x,
                    struct block *scratch, struct state state[BLOCK])
{
    struct octave octave[OCTAVES];
    const int count = octaves_make(noise, dimensions, octave);
    for (size_t i = 0; i < BLOCK; i++) {
        state[i] = (struct state){.u = 1.0};
    }
    for (int k = 0; k < count; k++) {
        const struct scarp_noise single = single_of(noise, &octave[k], k);
        const double reach = reach_of(noise, octave, k);
        for (size_t i = 0; i < BLOCK; i++) {
            place(scratch, x, i, &octave[k], &state[i], reach);
        }
        block_sample(scratch, &single, f, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            const struct oracle_sample n = block_result(scratch, &single, f, i);
            struct seen seen;
            see(&seen, &n, &octave[k], &state[i], reach);
            if (noise->fractal == SCARP_SWISS) {
                add_swiss(&state[i], &seen, octave[k].weight, octave[0].weight);
            } else {
                add_jordan(&state[i], &seen, octave[k].weight,
                           k == 0 ? 0.0 : (double)noise->erosion);
            }
        }
    }
}

struct errors {
    double max[2], squares[2];
    long points, excluded;
};

static void compare(struct block *x, struct block *scratch, const struct scarp_noise *noise,
                    enum function f, struct errors *errors)
{
    static struct state state[BLOCK];
    double unit[2] = {0.0, 0.0};
    struct octave octave[OCTAVES];
    uint64_t random = noise->seed;
    for (int k = 0; k < octaves_make(noise, dimensions, octave); k++) {
        unit[0] += fabs(octave[k].weight);
        unit[1] += fabs(octave[k].weight) * octave[k].frequency;
    }
    block_random(x, &random, function_doubles(f) ? 64.0f : 1.0f);
    block_sample(x, noise, f, BLOCK);
    rebuild(noise, f, x, scratch, state);
    for (size_t i = 0; i < BLOCK; i++) {
        const struct oracle_sample n = block_result(x, noise, f, i);
        if (state[i].crease) {
            errors->excluded++;
            continue;
        }
        double off = fabs(n.value - state[i].sum);
        for (int order = 0; order < 2; order++) {
            for (int j = 0; j < 3 && order == 1; j++) {
                off = larger(j == 0 ? 0.0 : off, fabs(n.gradient[j] - state[i].gradient[j]));
            }
            errors->max[order] = larger(errors->max[order], off / unit[order]);
            errors->squares[order] += pow(off / unit[order], 2.0);
        }
        errors->points++;
    }
}

/* Every number of the noise is other than its default in some case. */
static struct scarp_noise case_of(enum scarp_fractal fractal, int i)
{
    static const enum scarp_basis bases[] = {SCARP_GRADIENT, SCARP_VALUE, SCARP_SIMPLEX,
                                             SCARP_CELL_SOFT};
    struct scarp_noise noise = {.basis = bases[i % 4],
                                .fade = (enum scarp_fade)(i / 4 % 2),
                                .fractal = fractal,
                                .seed = 1000 + (uint64_t)i,
                                .frequency = 0.75,
                                .octaves = i % 3 == 0 ? 4.4f : 4.0f,
                                .of_octaves = i % 5 == 3 ? 6.75f : 0.0f,
                                .lacunarity = 1.9f,
                                .gain = 0.6f,
                                .amplitude = i % 2 != 0 ? -3.0f : 2.0f,
                                .erosion = i % 5 == 1 ? 0.4f : 0.9f,
                                .sharpness = i % 3 == 1 ? 0.05f : 0.2f,
                                .phase = i / 2 % 2 != 0 ? 0.4f : 0.0f,
                                .jitter = 0.75f};
    if (noise.basis == SCARP_SIMPLEX) { /* whose slopes are steep: small octaves crumple */
        noise.sharpness *= 0.25f;
    }
    noise.rotate = (uint32_t)(i / 8 % 2);
    if (i / 16 == 1) {
        noise.rotate = 0;
        noise.lacunarity = 2.0f;
        noise.period[0] = 3;
        noise.period[1] = 16;
    }
    noise.phase = noise.basis == SCARP_GRADIENT && i / 4 % 2 != 0 ? -1.3f : 0.0f;
    return noise;
}

/*
 * Bounds by [fractal is Jordan noise][order], in units of sum |a_k| f_k^order: about three times
 * what was measured. Where an octave looks is off by the errors of all octaves before, times
 * c_k f_k, which is sharpness f_k / f_0 with Swiss noise.
 */
static const double bounds[2][2] = {{3.5e-6, 2e-4}, {9e-7, 4.5e-5}};
static const double rms_bounds[2][2] = {{1.5e-7, 2.2e-6}, {8e-8, 9e-7}};

static void check_rebuilt(struct block *x, struct block *scratch, enum scarp_fractal fractal)
{
    const int jordan = fractal == SCARP_JORDAN;
    for (int doubles = 0; doubles < 2; doubles++) {
        struct errors errors = {.points = 0};
        const enum function f =
            dimensions == 2 ? (doubles ? SAMPLE2_F64 : SAMPLE2) : (doubles ? SAMPLE3_F64 : SAMPLE3);
        for (int i = 0; i < 24; i++) {
            struct scarp_noise noise = case_of(fractal, i);
            fit_noise(&noise, dimensions);
            compare(x, scratch, &noise, f, &errors);
        }
        printf("%-7s %dD %s rebuilt: max, RMS of value", fractal_names[fractal], dimensions,
               doubles ? "f64" : "f32");
        for (int order = 0; order < 2; order++) {
            const double rms = sqrt(errors.squares[order] / (double)errors.points);
            printf(" %.1e %.1e%s", errors.max[order], rms, order == 0 ? ", gradient" : "");
            CHECK(errors.max[order] <= bounds[jordan][order] && rms <= rms_bounds[jordan][order],
                  "derivative %d: off by %g, RMS %g", order, errors.max[order], rms);
        }
        printf("; %ld of %ld points excluded\n", errors.excluded, errors.points + errors.excluded);
        CHECK(errors.excluded <= errors.points / 100, "%ld points are excluded", errors.excluded);
    }
}

/* 0 in sharpness and erosion means the defaults of the fractal. */
static void check_defaults(struct block *x, struct block *y, enum scarp_fractal fractal)
{
    const enum function f = dimensions == 2 ? SAMPLE2 : SAMPLE3;
    const float sharpness = fractal == SCARP_SWISS ? 0.15f : 0.35f;
    struct scarp_noise noise = {.fractal = fractal, .octaves = 3.0f}, given = noise;
    int member = 0;
    size_t index = 0;
    given.sharpness = sharpness;
    given.erosion = 1.0f;
    block_sample(x, &noise, f, BLOCK);
    memcpy(y->f, x->f, sizeof y->f);
    block_sample(y, &given, f, BLOCK);
    CHECK(outputs_equal(&x->out, &y->out, outputs_of(&noise, f), BLOCK, &member, &index),
          "%s: other defaults", fractal_names[fractal]);
    given.sharpness = 2.0f * sharpness;
    block_sample(y, &given, f, BLOCK);
    CHECK(!outputs_equal(&x->out, &y->out, 1, BLOCK, &member, &index), "sharpness is ignored");
    given.sharpness = sharpness;
    given.erosion = 0.5f;
    block_sample(y, &given, f, BLOCK);
    CHECK(outputs_equal(&x->out, &y->out, 1, BLOCK, &member, &index) == (fractal == SCARP_SWISS),
          "%s: erosion", fractal_names[fractal]);
}

/* Values lie between 0 and the amplitude, and scarp_range says so; with a phase, those of Jordan
   noise reach as far as the square of an octave does. */
static void check_range(struct block *block, enum scarp_fractal fractal, int i)
{
    static const double reach[2][2] = {{1.0169038, 1.0162356}, {1.1100620, 1.1037150}};
    const float a = i % 2 == 0 ? 2.5f : -0.7f;
    const struct scarp_noise noise = {.fractal = fractal,
                                      .basis = (enum scarp_basis)(i / 2 % count_names(basis_name)),
                                      .fade = (enum scarp_fade)(i / 32 % 2),
                                      .amplitude = a,
                                      .octaves = i % 3 == 0 ? 1.0f : 4.5f,
                                      .erosion = i % 5 == 0 ? 0x1p-24f : 0.0f,
                                      .sharpness = i % 7 == 0 ? 64.0f : 0.0f,
                                      .phase = i / 2 % 8 == 0 ? 0.37f : 0.0f};
    const double far = reach[dimensions - 2][noise.fade];
    const double square = noise.phase != 0.0f && fractal == SCARP_JORDAN ? far * far : 1.0;
    float range[2] = {7.0f, -7.0f};
    uint64_t random = 1;
    CHECK(scarp_range(&noise, dimensions, &range[0], &range[1]) == SCARP_OK, "refused");
    const double end = (double)(a < 0.0f ? range[0] : range[1]) / (double)a;
    CHECK((a < 0.0f ? range[1] : range[0]) == 0.0f && fabs(end - square) <= 1e-6,
          "%s, phase %g: the range is %g to %g", fractal_names[fractal], (double)noise.phase,
          (double)range[0], (double)range[1]);
    block_random(block, &random, 64.0f);
    for (size_t k = 0; k < BLOCK; k += 3) { /* on the lattice */
        for (int axis = 0; axis < 3; axis++) {
            block->d[axis][k] = floor(block->d[axis][k]);
        }
    }
    block_sample(block, &noise, dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64, BLOCK);
    for (size_t k = 0; k < BLOCK; k++) {
        const double v = (double)block->out.array[0][k] / (double)a;
        CHECK(v >= 0.0 && v <= square, "%s, %s: %.9g of the amplitude", fractal_names[fractal],
              basis_name((int)noise.basis), v);
    }
}

/* Values are numbers within the range even where a_0 is too small for floats, or 0. */
static void check_tiny_weight(struct block *block, enum scarp_fractal fractal)
{
    const float amplitude = fractal == SCARP_SWISS ? -0x1p-24f : 0x1p-24f;
    const struct scarp_noise noises[] = {
        {.octaves = 30.0f, .lacunarity = 1.0f, .gain = 16.0f},
        {.octaves = 1e-40f, .of_octaves = 1.0f},
        {.octaves = 1e-40f, .of_octaves = 2.0f, .gain = 16.0f},
    };
    uint64_t random = 1;
    block_random(block, &random, 64.0f);
    for (size_t i = 0; i < sizeof noises / sizeof noises[0]; i++) {
        struct scarp_noise noise = noises[i];
        noise.fractal = fractal;
        noise.amplitude = amplitude;
        block_sample(block, &noise, dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64, BLOCK);
        for (size_t k = 0; k < BLOCK; k++) {
            const float v = block->out.array[0][k] / amplitude;
            CHECK(v >= 0.0f && v <= 1.0f, "%s, noise %zu: %.9g of the amplitude",
                  fractal_names[fractal], i, (double)v);
        }
    }
}

/* What lies a period further differs by roundings at most. */
static void check_periods(struct block *x, struct block *y, enum scarp_fractal fractal)
{
    const struct scarp_noise noise = {.fractal = fractal,
                                      .octaves = 3.5f,
                                      .lacunarity = 3.0f,
                                      .frequency = 0.5,
                                      .period = {6, 16, 289}};
    const enum function f = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    uint64_t random = 1;
    block_random(x, &random, 64.0f);
    for (int axis = 0; axis < dimensions; axis++) {
        memcpy(y->d, x->d, sizeof y->d);
        for (size_t i = 0; i < BLOCK; i++) {
            y->d[axis][i] += (double)noise.period[axis] * -6.0;
        }
        block_sample(x, &noise, f, BLOCK);
        block_sample(y, &noise, f, BLOCK);
        for (int m = 0; m <= dimensions; m++) {
            for (size_t i = 0; i < BLOCK; i++) {
                const double off = fabs((double)x->out.array[m][i] - (double)y->out.array[m][i]);
                CHECK(off <= 1e-4, "%s[%zu] is off by %g", output_names[m], i, off);
            }
        }
    }
}

/* Second derivatives and dphase are not supported, erosion above 1 of Jordan noise is an error. */
static void check_refused(struct block *block, enum scarp_fractal fractal)
{
    const enum function f = dimensions == 2 ? SAMPLE2 : SAMPLE3;
    struct scarp_noise noise = {.fractal = fractal, .octaves = 2.0f, .phase = 0.3f};
    const struct inputs in = {.f = {block->f[0], block->f[1], block->f[2]}};
    const char *member = NULL;
    for (int m = 0; m < OUTPUTS; m++) {
        const struct scarp_samples out = outputs_subset(&block->out, 1u << m);
        const int has = (outputs_of(&noise, f) >> m & 1) != 0;
        outputs_poison(&block->out);
        CHECK(function_call(f, &noise, BLOCK, &in, &out) ==
                  (has ? SCARP_OK : SCARP_ERROR_UNSUPPORTED),
              "%s: %s", fractal_names[fractal], output_names[m]);
        CHECK(outputs_untouched(&block->out, has ? ~(1u << m) : ~0u), "%s: written",
              output_names[m]);
    }
    noise.erosion = nextafterf(1.0f, 2.0f);
    const enum scarp_status wanted = fractal == SCARP_JORDAN ? SCARP_ERROR_PARAMETER : SCARP_OK;
    CHECK(scarp_noise_check(&noise, dimensions, &member) == wanted &&
              (wanted == SCARP_OK || (member != NULL && strcmp(member, "erosion") == 0)),
          "%s: erosion above 1", fractal_names[fractal]);
    noise.erosion = 1.0f;
    CHECK(scarp_noise_check(&noise, dimensions, NULL) == SCARP_OK, "erosion 1");
}

/* Calls with a plan give the same bits, and use it. */
static void check_plan(struct block *x, struct block *y, enum scarp_fractal fractal)
{
    static struct scarp_plan plan;
    struct scarp_noise noise = {.fractal = fractal, .octaves = 3.0f, .phase = 0.3f, .rotate = 1};
    int member = 0;
    size_t index = 0;
    memcpy(y->f, x->f, sizeof y->f);
    memcpy(y->d, x->d, sizeof y->d);
    for (int i = 0; i < 2; i++) {
        const enum function f = (enum function)(dimensions == 2 ? 2 * i : 2 * i + 1);
        struct scarp_noise with = noise;
        CHECK(scarp_plan_make(&noise, dimensions, &plan) == SCARP_OK, "no plan");
        with.plan = &plan;
        block_sample(x, &noise, f, BLOCK);
        block_sample(y, &with, f, BLOCK);
        CHECK(outputs_equal(&x->out, &y->out, outputs_of(&noise, f), BLOCK, &member, &index),
              "%s: the plan changes %s", fractal_names[fractal], output_names[member]);
        /* the constants of octave 0 and 1 */
        for (size_t b = sizeof(struct scarp_noise); b < sizeof(struct scarp_noise) + 400; b++) {
            plan.rest[b] ^= 0x10;
        }
        block_sample(y, &with, f, BLOCK);
        CHECK(!outputs_equal(&x->out, &y->out, 1, BLOCK, &member, &index), "the plan is unused");
    }
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        printf("usage: %s ISA\n", argv[0]);
        return EXIT_FAILURE;
    }
    check_select_isa(argv[1]);
    struct block *const x = block_make(), *const y = block_make();
    for (int i = 0; i < 4; i++) {
        const enum scarp_fractal fractal = i / 2 == 0 ? SCARP_SWISS : SCARP_JORDAN;
        dimensions = 2 + i % 2;
        check_rebuilt(x, y, fractal);
        check_defaults(x, y, fractal);
        check_tiny_weight(x, fractal);
        check_periods(x, y, fractal);
        check_refused(x, fractal);
        check_plan(x, y, fractal);
        for (int k = 0; k < 64; k++) {
            check_range(x, fractal, k);
        }
    }
    block_free(x);
    block_free(y);
    return check_done();
}
