/* SPDX-License-Identifier: MIT
 *
 * Calls read and write nothing beyond the arrays, whatever their length and alignment, and outputs
 * may lie where inputs are. Neither the place of a point nor the length of the array matters: every
 * result has the bits that one call for all points gives.
 *
 *     test_memory ISA
 */
#include "guarded.h"

#include "chain.h"
#include "gullies.h"

#if GUARDED_EXISTS

#define SHORT (4 * 16 + 3) /* every count up to four of the widest blocks and a tail */
#define LONGEST 1031
#define POINTS (LONGEST + 29)

/* Then counts near those of whole parts, which have 32 blocks or fewer (src/kernel/driver.h). */
static const size_t long_counts[] = {127, 128, 129, 255, 257, 513, LONGEST};
#define COUNTS (SHORT + 1 + sizeof long_counts / sizeof long_counts[0])

static float x32[3][POINTS];
static double x64[3][POINTS];
static const struct inputs in = {{x32[0], x32[1], x32[2]}, {x64[0], x64[1], x64[2]}};

/* Arrays of a call, each between guard pages; calls can only read inputs. */
static struct guarded inputs[3], results[OUTPUTS];
static struct outputs whole; /* results of one call for all points */

enum place {
    AT_START,  /* right behind the guard page */
    AT_END,    /* right before the guard page */
    UNALIGNED, /* in between, each array at another offset */
    PLACES
};

static size_t count_at(size_t i)
{
    return i <= SHORT ? i : long_counts[i - SHORT - 1];
}

static const char *const place_names[PLACES] = {"at the start", "at the end", "unaligned"};

/* Where an array of `bytes` bytes of elements of `size` bytes begins. */
static unsigned char *placed(const struct guarded *g, enum place place, size_t bytes, size_t size,
                             size_t which)
{
    switch (place) {
    case AT_START: return g->start;
    case AT_END: return g->start + g->size - bytes;
    default: return g->start + 1024 + which % 16 * size;
    }
}

static int is_unchanged(const unsigned char *p, const unsigned char *end)
{
    return all_poison(p, (size_t)(end - p));
}

/* Whether nothing but [array, array + bytes) was written. */
static int only_array_written(const struct guarded *g, const unsigned char *array, size_t bytes)
{
    return is_unchanged(g->start, array) && is_unchanged(array + bytes, g->start + g->size);
}

/* Copies `count` points from `first` on into the input pages. */
static struct inputs place_inputs(enum function f, enum place place, size_t first, size_t count)
{
    struct inputs placed_inputs = {{NULL, NULL, NULL}, {NULL, NULL, NULL}};
    const size_t size = function_doubles(f) ? sizeof(double) : sizeof(float);
    for (int d = 0; d < function_dimensions(f); d++) {
        unsigned char *const array =
            placed(&inputs[d], place, count * size, size, 3 * (size_t)d + count);
        if (function_doubles(f)) {
            guarded_write(&inputs[d], array, x64[d] + first, count * size);
            placed_inputs.d[d] = (const double *)(void *)array;
        } else {
            guarded_write(&inputs[d], array, x32[d] + first, count * size);
            placed_inputs.f[d] = (const float *)(void *)array;
        }
    }
    return placed_inputs;
}

/* Gives each output of `mask` an array, filled with poison, and the others NULL. */
static struct outputs place_outputs(enum place place, unsigned mask, size_t count)
{
    struct outputs o = {.capacity = count};
    for (size_t m = 0; m < OUTPUTS; m++) {
        if ((mask >> m & 1) != 0) {
            memset(results[m].start, POISON, results[m].size);
            o.array[m] = (float *)(void *)placed(&results[m], place, count * sizeof(float),
                                                 sizeof(float), 5 * m + count);
        }
    }
    return o;
}

static void check_outputs(const struct outputs *o, unsigned mask, const struct outputs *reference,
                          size_t first, size_t count, enum place place, const char *what)
{
    for (int m = 0; m < OUTPUTS; m++) {
        if ((mask >> m & 1) != 0) {
            CHECK(only_array_written(&results[m], (const unsigned char *)o->array[m],
                                     count * sizeof(float)),
                  "%s, %zu points %s: wrote beyond %s", what, count, place_names[place],
                  output_names[m]);
            const size_t at = first_difference(o->array[m], reference->array[m] + first, count);
            CHECK(at == count, "%s, %zu points %s from %zu on: %s[%zu] differs from one call's",
                  what, count, place_names[place], first, output_names[m], at);
        }
    }
}

/* A call with the outputs that have arrays; these in the plane and in space, by bits */
struct caller {
    enum scarp_status (*find)(enum function f, const struct scarp_noise *noise, size_t count,
                              const struct inputs *points, const struct outputs *o);
    unsigned masks[2];
    const char *name;
};

/* Tries all counts in all places, for one kind of call. */
static void test_callers(enum function f, const struct scarp_noise *noise,
                         const struct caller *caller)
{
    const unsigned mask = caller->masks[function_dimensions(f) - 2];
    struct outputs all = whole;
    for (int m = 0; m < OUTPUTS; m++) {
        all.array[m] = (mask >> m & 1) != 0 ? all.array[m] : NULL;
    }
    CHECK(caller->find(f, noise, POINTS, &in, &all) == SCARP_OK, "%s: all", caller->name);
    for (size_t c = 0; c < COUNTS; c++) {
        const size_t count = count_at(c);
        for (int p = 0; p < PLACES; p++) {
            const enum place place = (enum place)p;
            const size_t first = count * 7 % (POINTS - LONGEST);
            const struct inputs points = place_inputs(f, place, first, count);
            const struct outputs o = place_outputs(place, mask, count);
            CHECK(caller->find(f, noise, count, &points, &o) == SCARP_OK, "%s: %zu points",
                  caller->name, count);
            check_outputs(&o, mask, &whole, first, count, place, caller->name);
        }
    }
}

static enum scarp_status find_samples(enum function f, const struct scarp_noise *noise,
                                      size_t count, const struct inputs *points,
                                      const struct outputs *o)
{
    const struct scarp_samples out = outputs_subset(o, (1u << OUTPUTS) - 1);
    return function_call(f, noise, count, points, &out);
}

/* Puts inputs and outputs into the same arrays: by turns, some outputs replace x, y and z. */
static void test_in_place(enum function f, const struct scarp_noise *noise)
{
    static const int over[][3] = {{0, 1, 2}, {1, 0, 4}, {4, 5, 7}, {7, 2, 0}, {2, 4, 1}};
    static const int over_phase[][3] = {{OUTPUT_dphase, 1, 2},
                                        {1, OUTPUT_dphase, 4},
                                        {4, 5, OUTPUT_dphase},
                                        {OUTPUT_dphase, 2, 0},
                                        {2, OUTPUT_dphase, 1}};
    const int flows = noise->phase != 0.0f;
    const unsigned mask = function_outputs(f) | (flows ? OUTPUTS_PHASE : 0);
    const struct scarp_samples all = outputs_subset(&whole, mask);
    CHECK(function_call(f, noise, POINTS, &in, &all) == SCARP_OK, "%s", function_names[f]);
    for (size_t c = 0; c < COUNTS; c++) {
        const size_t count = count_at(c);
        for (size_t way = 0; way < sizeof over / sizeof over[0]; way++) {
            const enum place place = (enum place)(count % PLACES);
            struct outputs o = place_outputs(place, mask, count);
            struct inputs points = {{NULL, NULL, NULL}, {NULL, NULL, NULL}};
            for (int d = 0; d < function_dimensions(f); d++) {
                float *const shared = o.array[(flows ? over_phase : over)[way][d]];
                memcpy(shared, x32[d], count * sizeof(float));
                points.f[d] = shared;
            }
            const struct scarp_samples out = outputs_subset(&o, mask);
            CHECK(function_call(f, noise, count, &points, &out) == SCARP_OK, "%s",
                  function_names[f]);
            check_outputs(&o, mask, &whole, 0, count, place, "in place");
        }
    }
}

/* Does the same with only the value, which replaces one coordinate. */
static void test_value_in_place(enum function f, const struct scarp_noise *noise)
{
    const struct scarp_samples all = outputs_subset(&whole, 1);
    CHECK(function_call(f, noise, POINTS, &in, &all) == SCARP_OK, "%s", function_names[f]);
    for (size_t c = 0; c < COUNTS; c++) {
        const size_t count = count_at(c);
        for (int axis = 0; axis < function_dimensions(f); axis++) {
            const enum place place = (enum place)(count % PLACES);
            struct inputs points = place_inputs(f, place, 0, count);
            const struct outputs o = place_outputs(place, 1, count);
            memcpy(o.array[0], x32[axis], count * sizeof(float));
            points.f[axis] = o.array[0];
            const struct scarp_samples out = outputs_subset(&o, 1);
            CHECK(function_call(f, noise, count, &points, &out) == SCARP_OK, "%s",
                  function_names[f]);
            check_outputs(&o, 1, &whole, 0, count, place, "value in place");
        }
    }
}

static void test_samples(void)
{
    static const enum scarp_basis bases[6] = {SCARP_GRADIENT, SCARP_VALUE,     SCARP_GRADIENT,
                                              SCARP_SIMPLEX,  SCARP_CELL_EDGE, SCARP_CELL_SOFT};
    for (int i = 0; i < FUNCTIONS * 6 * 3; i++) {
        const enum function f = (enum function)(i % FUNCTIONS);
        const int kind = i / FUNCTIONS / 6; /* one octave, several, several turned */
        const int flows = i / FUNCTIONS % 6 == 2;
        if (i / FUNCTIONS % 6 > 3 && kind == 1) {
            continue; /* cells take their time, and octaves go the same way with turned axes */
        }
        const struct scarp_noise noise = {.basis = bases[i / FUNCTIONS % 6],
                                          .phase = flows ? 0.6f : 0.0f,
                                          .octaves = kind > 0 ? 2.5f : 1.0f,
                                          .rotate = kind == 2,
                                          .frequency = 0.37,
                                          .seed = (uint64_t)i};
        for (int order = 0; order <= 2; order++) {
            const unsigned flow = noise.phase != 0.0f ? OUTPUTS_PHASE : 0;
            const struct caller samples = {
                find_samples,
                {outputs_up_to(order, 2) | flow, outputs_up_to(order, 3) | flow},
                function_names[f]};
            test_callers(f, &noise, &samples);
        }
        if (!function_doubles(f)) {
            test_in_place(f, &noise);
            test_value_in_place(f, &noise);
        }
    }
}

/* Computes the normals of `count` points, into arrays of their own or over dx and dy. */
static void try_normals(size_t count, enum place place, int way)
{
    const size_t first = count * 7 % (POINTS - LONGEST);
    const struct inputs points = place_inputs(SAMPLE2, place, first, count);
    const struct outputs o = place_outputs(place, 7, count);
    const float *dx = points.f[0], *dy = points.f[1];
    if (way > 0) {
        memcpy(o.array[way % 3], dx, count * sizeof(float));
        memcpy(o.array[(way + 1) % 3], dy, count * sizeof(float));
        dx = o.array[way % 3];
        dy = o.array[(way + 1) % 3];
    }
    CHECK(scarp_normals(count, dx, dy, 0.7f, o.array[0], o.array[1], o.array[2]) == SCARP_OK, "%zu",
          count);
    check_outputs(&o, 7, &whole, first, count, place, "scarp_normals");
}

static void test_normals(void)
{
    CHECK(scarp_normals(POINTS, x32[0], x32[1], 0.7f, whole.array[0], whole.array[1],
                        whole.array[2]) == SCARP_OK,
          "all");
    for (size_t c = 0; c < COUNTS; c++) {
        const size_t count = count_at(c);
        for (int p = 0; p < PLACES; p++) {
            for (int way = 0; way <= 3; way++) {
                try_normals(count, (enum place)p, way);
            }
        }
    }
}

static enum chain chain; /* which find_chain calls */

/* Functions of samples, whose inputs are three arrays */
static enum scarp_status find_chain(enum function f, const struct scarp_noise *noise, size_t count,
                                    const struct inputs *points, const struct outputs *o)
{
    const struct scarp_samples out = outputs_subset(o, (1u << OUTPUTS) - 1);
    float *const x[3] = {(float *)(uintptr_t)points->f[0], (float *)(uintptr_t)points->f[1],
                         (float *)(uintptr_t)points->f[2]};
    (void)f;
    (void)noise;
    return chain_call_arrays(chain, count, x, &out);
}

/* The velocity, and as much of the Jacobian as there are outputs. */
static enum scarp_status find_flow(enum function f, const struct scarp_noise *noise, size_t count,
                                   const struct inputs *points, const struct outputs *o)
{
    float *const *const a = o->array;
    const struct scarp_flow in_plane = {.vx = a[0], .vy = a[1], .vxx = a[2], .vyx = a[3]};
    const struct scarp_flow in_space = {.vx = a[0],
                                        .vy = a[1],
                                        .vz = a[2],
                                        .vxx = a[3],
                                        .vxy = a[4],
                                        .vyz = a[5],
                                        .vzx = a[6],
                                        .vzy = a[7],
                                        .vzz = a[8]};
    const float *const *const x = points->f;
    const double *const *const d = points->d;
    switch (f) {
    case SAMPLE2: return scarp_curl2(noise, count, x[0], x[1], &in_plane);
    case SAMPLE3: return scarp_curl3(noise, count, x[0], x[1], x[2], &in_space);
    case SAMPLE2_F64: return scarp_curl2_f64(noise, count, d[0], d[1], &in_plane);
    default: return scarp_curl3_f64(noise, count, d[0], d[1], d[2], &in_space);
    }
}

/* Some outputs of each component of vector noise, the last of which the plane does not have. */
static enum scarp_status find_vector(enum function f, const struct scarp_noise *noise, size_t count,
                                     const struct inputs *points, const struct outputs *o)
{
    float *const *const a = o->array;
    const struct scarp_samples out[3] = {
        {.value = a[0], .dx = a[1]}, {.value = a[2], .dxy = a[3]}, {.dx = a[4], .dz = a[5]}};
    return vector_call(f, noise, count, points, out);
}

/* Gullies of floats, in a base whose arrays are the coordinates. */
static enum scarp_status find_gullies(enum function f, const struct scarp_noise *noise,
                                      size_t count, const struct inputs *points,
                                      const struct outputs *o)
{
    static const struct scarp_gullies gullies = {.octaves = 2.0f, .rotate = 1};
    float *const x = (float *)(uintptr_t)points->f[0], *const y = (float *)(uintptr_t)points->f[1];
    const struct scarp_samples base = base_of_two(x, y);
    const struct scarp_eroded out = eroded_of(o->array, OUT_ALL);
    (void)f;
    (void)noise;
    return scarp_gullies2(&gullies, count, x, y, &base, &out);
}

static void test_flows(enum function f, const struct scarp_noise *noise)
{
    const struct caller flow = {find_flow, {0xf, 0x1ff}, "scarp_curl2 and its like"};
    const struct caller vector = {find_vector, {0xf, 0x3f}, "scarp_vector2 and its like"};
    test_callers(f, noise, &flow);
    test_callers(f, noise, &vector);
}

int main(int argc, char **argv)
{
    const struct caller gullies = {find_gullies, {OUT_ALL}, "scarp_gullies2"},
                        gully_values = {find_gullies, {OUT_VALUES}, "scarp_gullies2"};
    const struct scarp_noise warp = {.seed = 1}, plain = {.octaves = 2.0f},
                             warped = {.warp = &warp};
    check_select_isa(argc > 1 ? argv[1] : "scalar");
    uint64_t state = 1;
    for (int i = 0; i < 3 * POINTS; i++) {
        x32[i % 3][i / 3] = check_random_float(&state, 256.0f);
        x64[i % 3][i / 3] = check_random_double(&state, 0x1p30);
    }
    for (int d = 0; d < 3; d++) {
        inputs[d] = guarded_make_readonly(POINTS * sizeof(double) + 2048);
    }
    for (int m = 0; m < OUTPUTS; m++) {
        results[m] = guarded_make(POINTS * sizeof(float) + 2048);
    }
    whole = outputs_make(POINTS);
    test_samples();
    test_normals();
    for (int f = 0; f < CHAINS; f++) {
        const struct caller samples = {find_chain, {0, (1u << OUTPUTS) - 1}, chain_kinds[f].name};
        chain = (enum chain)f;
        test_callers(SAMPLE3, &plain, &samples);
    }
    test_callers(SAMPLE2, &plain, &gullies);
    test_callers(SAMPLE2, &plain, &gully_values);
    for (int f = 0; f < FUNCTIONS; f++) {
        test_flows((enum function)f, &plain);
        test_flows((enum function)f, &warped);
    }
    return check_done();
}

#else

int main(void)
{
    printf("no pages can be protected here: skipped\n");
    return CHECK_SKIPPED;
}

#endif
