/* SPDX-License-Identifier: MIT
 *
 * How exact gradients are, and how much of the promised ranges is met, for every basis with every
 * fractal, for warps, recipes and gullies. Prints the tables of bench/results.md.
 *
 *     honesty POINTS [SAMPLES]    points for gradients; samples for ranges, 256 times as many
 *
 * The reference is the derivative of the *value*: central differences of fourth order of the
 * oracle's values in double precision, which know nothing of any gradient. With the differences of
 * second order of steps h and 2h, a and b, it is (4 a - b) / 3. Where a and b differ by more than
 * 2^-20 of the slope there and the median slope, a crease or a jump is within 2h, or the
 * differences are not exact enough to judge. Such points are left out, and counted. The library has
 * no say in that.
 *
 * Next to the gradient of the library are central differences of its values, floats, at
 * coordinates in double precision, at the same points. The step is that of 2^-1 to 2^-16 cells of
 * the finest octave which has the least rms error. A crease may be within that step.
 *
 * Errors are those of a component, over the rms of a component of the gradient. The program fails
 * where an error passes the bound of its class, and where a value leaves the promised range.
 */
#include "honesty.h"
#include "check.h"
#include "outputs.h"

#define STEPS 16
#define CLEAR 0x1p-20
#define MOST_POINTS 65536
#define MOST_SUBJECTS 256

/* Largest and rms error. */
struct error {
    double max, rms;
};

struct result {
    double slope; /* rms of the gradient's components; 0 where nothing has a slope */
    struct error own, differences;
    int step; /* of the differences: 2^-step cells */
    double skipped;
    double met[2]; /* lowest and highest value */
};

/* About three times the largest error of a class on 2048 points a row. Few points decide the
   largest error: those where a slope turns within a small part of a cell. */
static const struct {
    const char *name;
    struct error bound;
} classes[HONESTY_CLASSES] = {
    [HONESTY_NOISE] = {"fBm, turbulence, ridged, ping-pong, hybrid", {4e-5, 1.1e-6}},
    [HONESTY_EROSION] = {"erosion", {1e-3, 1.5e-5}},
    [HONESTY_BENT] = {"bent", {3e-3, 1.2e-4}},
    [HONESTY_WARP] = {"warps", {6e-5, 4e-6}},
    [HONESTY_RECIPE] = {"recipes", {6e-3, 1e-4}},
    [HONESTY_GULLIES] = {"gullies", {1.3e-4, 4.5e-6}},
    [HONESTY_SHARP] = {"gullies with sharp crests", {1.7e-3, 6e-5}},
};

static double (*points)[3], (*slopes)[3]; /* the points, and the reference */
static char *is_clear;

/* The reference along an axis. Returns how far the two differences are apart. */
static double slope_along(const struct subject *subject, const double x[3], int axis, double *slope)
{
    double side[2][2];
    for (int i = 0; i < 4; i++) {
        double at[3] = {x[0], x[1], x[2]};
        at[axis] += (i < 2 ? 1.0 : 2.0) * (i % 2 == 0 ? -subject->step : subject->step);
        side[i / 2][i % 2] = subject->value(subject, at);
    }
    const double a = (side[0][1] - side[0][0]) / (2.0 * subject->step);
    const double b = (side[1][1] - side[1][0]) / (4.0 * subject->step);
    *slope = (4.0 * a - b) / 3.0;
    return fabs(a - b);
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median_of(const double *numbers, int count)
{
    double *const sorted = check_allocate((size_t)count * sizeof *sorted);
    memcpy(sorted, numbers, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, compare_doubles);
    const double median = sorted[count / 2];
    free(sorted);
    return median;
}

/* Draws the points, and computes the reference and which points are clear. */
static void draw(const struct subject *subject, int count, struct result *result)
{
    uint64_t random = 1;
    const int d = subject->dimensions;
    double *const apart = check_allocate((size_t)count * sizeof *apart);
    double *const size = check_allocate((size_t)count * sizeof *size);
    for (int i = 0; i < count; i++) {
        apart[i] = size[i] = 0.0;
        for (int axis = 0; axis < 3; axis++) {
            const double number = (double)(check_random(&random) >> 32) - 0x1p31;
            points[i][axis] = axis < d ? number * subject->span * 0x1p-31 : 0.0;
        }
        for (int axis = 0; axis < d; axis++) {
            apart[i] = larger(apart[i], slope_along(subject, points[i], axis, &slopes[i][axis]));
            size[i] = larger(size[i], fabs(slopes[i][axis]));
        }
    }
    const double median = median_of(size, count);
    double squares = 0.0;
    int clear = 0;
    for (int i = 0; i < count; i++) {
        is_clear[i] = apart[i] <= CLEAR * (median + size[i]);
        clear += is_clear[i];
        for (int axis = 0; axis < d && is_clear[i]; axis++) {
            squares += slopes[i][axis] * slopes[i][axis];
        }
    }
    result->slope = median > 0.0 ? sqrt(squares / (clear * d)) : 0.0;
    result->skipped = (double)(count - clear) / count;
    free(apart);
    free(size);
}

/* What the library computes at points `first` to `first + count`, moved along an axis. */
static void sample_at(const struct subject *subject, int first, int count, const double by[3],
                      float *const out[4])
{
    static double x[3][HONESTY_BLOCK];
    const double *const coordinates[3] = {x[0], x[1], x[2]};
    for (int i = 0; i < count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            x[axis][i] = points[first + i][axis] + by[axis];
        }
    }
    subject->sample(subject, (size_t)count, coordinates, out);
}

/* The gradients of the library for step 0, else central differences of its values in steps of
   2^-step cells. */
static struct error error_of(const struct subject *subject, int count, int step,
                             const struct result *result)
{
    static float of[4][HONESTY_BLOCK], before[HONESTY_BLOCK];
    const int d = subject->dimensions;
    const double h = ldexp(subject->cell, -step);
    struct error e = {0.0, 0.0};
    int compared = 0;
    for (int first = 0; first < count; first += HONESTY_BLOCK) {
        const int left = count - first < HONESTY_BLOCK ? count - first : HONESTY_BLOCK;
        for (int axis = 0; axis < d; axis++) {
            if (step == 0) {
                float *const out[4] = {of[0], of[1], of[2], d == 3 ? of[3] : NULL};
                sample_at(subject, first, left, (const double[3]){0.0, 0.0, 0.0}, out);
            } else {
                double by[3] = {0.0, 0.0, 0.0};
                by[axis] = -h;
                sample_at(subject, first, left, by, (float *const[4]){before, NULL, NULL, NULL});
                by[axis] = h;
                sample_at(subject, first, left, by, (float *const[4]){of[0], NULL, NULL, NULL});
            }
            for (int i = 0; i < left; i++) {
                if (!is_clear[first + i]) {
                    continue;
                }
                const double slope = step == 0 ? (double)of[1 + axis][i]
                                               : ((double)of[0][i] - (double)before[i]) / (2.0 * h);
                const double off = fabs(slope - slopes[first + i][axis]) / result->slope;
                e.max = larger(e.max, off);
                e.rms += off * off;
                compared++;
            }
        }
    }
    e.rms = sqrt(e.rms / compared);
    return e;
}

static void measure_gradient(const struct subject *subject, int count, struct result *result)
{
    draw(subject, count, result);
    if (result->slope == 0.0) {
        return;
    }
    result->own = error_of(subject, count, 0, result);
    result->differences.rms = HUGE_VAL;
    for (int step = 1; step <= STEPS; step++) {
        const struct error e = error_of(subject, count, step, result);
        if (e.rms < result->differences.rms) {
            result->differences = e;
            result->step = step;
        }
    }
    const struct error bound = classes[subject->kind].bound;
    CHECK(result->own.max <= bound.max && result->own.rms <= bound.rms,
          "%s %s %dD: the gradient is off by %.2g, rms %.2g", subject->name[0], subject->name[1],
          subject->dimensions, result->own.max, result->own.rms);
    CHECK(result->own.rms < result->differences.rms, "%s %s %dD: differences are better",
          subject->name[0], subject->name[1], subject->dimensions);
    CHECK(result->skipped <= 0.02, "%s %s %dD: %g of the points are left out", subject->name[0],
          subject->name[1], subject->dimensions, result->skipped);
}

static void measure_range(const struct subject *subject, long samples, struct result *result)
{
    static double x[3][HONESTY_BLOCK];
    static float value[HONESTY_BLOCK];
    uint64_t random = 2;
    long outside = 0;
    result->met[0] = HUGE_VAL;
    result->met[1] = -HUGE_VAL;
    for (long first = 0; first < samples; first += HONESTY_BLOCK) {
        const size_t left =
            (size_t)(samples - first < HONESTY_BLOCK ? samples - first : HONESTY_BLOCK);
        for (size_t i = 0; i < left; i++) {
            for (int axis = 0; axis < 3; axis++) {
                x[axis][i] = check_random_double(&random, 64.0 * subject->span);
            }
        }
        subject->sample(subject, left, (const double *const[3]){x[0], x[1], x[2]},
                        (float *const[4]){value, NULL, NULL, NULL});
        for (size_t i = 0; i < left; i++) {
            const double v = (double)value[i];
            outside += !(v >= subject->lowest && v <= subject->highest);
            result->met[0] = v < result->met[0] ? v : result->met[0];
            result->met[1] = v > result->met[1] ? v : result->met[1];
        }
    }
    CHECK(outside == 0, "%s %s %dD: %ld values are outside [%g, %g]: [%g, %g]", subject->name[0],
          subject->name[1], subject->dimensions, outside, subject->lowest, subject->highest,
          result->met[0], result->met[1]);
}

/*
 * The tables
 */

static struct subject subjects[MOST_SUBJECTS];
static struct result results[MOST_SUBJECTS];
static int subject_count;

static void print_errors(const struct result *r)
{
    printf(" %.2f | %.1e | %.1e | %.1e | %.1e |", r->slope, r->own.max, r->own.rms,
           r->differences.max, r->differences.rms);
}

/* Every fractal with every basis that has slopes: 2D and 3D in a row. */
static void print_gradients(int plain)
{
    printf(
        "| | | 2D slope | max | rms | differences max | rms | 3D slope | max | rms | differences "
        "max | rms |\n|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (int i = 0; i < plain; i += 2) {
        if (results[i].slope == 0.0) {
            continue;
        }
        printf("| %s | %s |", subjects[i].name[0], subjects[i].name[1]);
        print_errors(&results[i]);
        print_errors(&results[i + 1]);
        printf("\n");
    }
}

/* The rest, with ranges. */
static void print_rest(int plain)
{
    printf("\n| | | slope | max | rms | differences max | rms | promised | met |\n"
           "|---|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for (int i = plain; i < subject_count; i++) {
        const struct subject *const s = &subjects[i];
        printf("| %s | %s, %dD |", s->name[0], s->name[1], s->dimensions);
        print_errors(&results[i]);
        printf(" %.4g to %.4g | %.4g to %.4g |\n", s->lowest, s->highest, results[i].met[0],
               results[i].met[1]);
    }
}

/* How much of the range is met, in percent, in 2D and 3D: a row for each fractal. */
static void print_ranges(int plain)
{
    const int bases = honesty_bases();
    printf("\n| | promised |");
    for (int basis = 0; basis < bases; basis++) {
        printf(" %s |", subjects[2 * basis].name[1]);
    }
    printf("\n|---|---:|");
    for (int basis = 0; basis < bases; basis++) {
        printf("---:|");
    }
    for (int i = 0; i < plain; i++) {
        const struct subject *const s = &subjects[i];
        const double met = results[i].met[1] - results[i].met[0];
        if (i % (2 * bases) == 0) {
            printf("\n| %s | %.3g to %.3g |", s->name[0], s->lowest, s->highest);
        }
        printf(i % 2 == 0 ? " %.0f, " : "%.0f |", 100.0 * met / (s->highest - s->lowest));
    }
    printf("\n");
}

/* What the text next to the tables says. */
static void print_summary(void)
{
    double skipped = 0.0, least = HUGE_VAL;
    int steps[2] = {STEPS, 1};
    struct error most[HONESTY_CLASSES] = {{0.0, 0.0}};
    for (int i = 0; i < subject_count; i++) {
        const struct result *const r = &results[i];
        struct error *const m = &most[subjects[i].kind];
        if (r->slope == 0.0) {
            continue;
        }
        skipped = larger(skipped, r->skipped);
        steps[0] = r->step < steps[0] ? r->step : steps[0];
        steps[1] = r->step > steps[1] ? r->step : steps[1];
        m->max = larger(m->max, r->own.max);
        m->rms = larger(m->rms, r->own.rms);
        least = fmin(least, r->differences.rms / r->own.rms);
    }
    for (int c = 0; c < HONESTY_CLASSES; c++) {
        printf("%s: max %.2g, rms %.2g at most\n", classes[c].name, most[c].max, most[c].rms);
    }
    printf(
        "up to %.2f %% of the points of a row are left out; differences have at least %.0f times "
        "the rms error\n",
        100.0 * skipped, least);
}

int main(int argc, char **argv)
{
    const int count = argc == 2 || argc == 3 ? atoi(argv[1]) : 0;
    const long samples = argc == 3 ? strtol(argv[2], NULL, 10) : 256L * count;
    if (count < 1 || count > MOST_POINTS || samples < 1) {
        printf("usage: %s POINTS [SAMPLES] (up to %d points)\n", argv[0], MOST_POINTS);
        return EXIT_FAILURE;
    }
    points = check_allocate((size_t)count * sizeof *points);
    slopes = check_allocate((size_t)count * sizeof *slopes);
    is_clear = check_allocate((size_t)count);
    while (subject_count < MOST_SUBJECTS &&
           honesty_subject(subject_count, &subjects[subject_count])) {
        measure_gradient(&subjects[subject_count], count, &results[subject_count]);
        measure_range(&subjects[subject_count], samples, &results[subject_count]);
        honesty_forget();
        subject_count++;
    }
    CHECK(subject_count < MOST_SUBJECTS, "there are more subjects");
    const int plain = 2 * honesty_bases() * honesty_fractals();
    print_gradients(plain);
    print_rest(plain);
    print_ranges(plain);
    print_summary();
    free(points);
    free(slopes);
    free(is_clear);
    return check_done();
}
