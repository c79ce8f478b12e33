/* SPDX-License-Identifier: MIT
 *
 * Samples of a noise at points and on grids, its range, its plans, and what calls say of it.
 */
#include "../outputs.h"

#include "arguments.h"

struct arguments {
    const struct scarp_noise *noise;
    const struct scarp_grid *grid; /* NULL: points */
    enum function function;
    const float *f[3];
    const double *d[3];
};

static enum scarp_status make(const struct fuzz_call *call, size_t first, size_t count,
                              float *const out[FUZZ_OUTPUTS])
{
    const struct arguments *const a = call->arguments;
    const struct scarp_samples *const samples = FUZZ_AS(scarp_samples, out);
    if (a->grid != NULL) {
        return function_dimensions(a->function) == 2 ? scarp_grid2(a->noise, a->grid, samples)
                                                     : scarp_grid3(a->noise, a->grid, samples);
    }
    struct inputs in = {{NULL}, {NULL}};
    for (int axis = 0; axis < 3; axis++) {
        in.f[axis] = a->f[axis] != NULL ? a->f[axis] + first : NULL;
        in.d[axis] = a->d[axis] != NULL ? a->d[axis] + first : NULL;
    }
    return function_call(a->function, a->noise, count, &in, samples);
}

static int order_of(unsigned mask)
{
    int order = 0;
    for (int m = 0; m < OUTPUTS; m++) {
        const int this_order = m == OUTPUT_dphase ? 0 : output_kinds[m].order;
        order = (mask >> m & 1) != 0 && this_order > order ? this_order : order;
    }
    return order;
}

/* Whether outputs along z are asked for in the plane. */
static int beyond(int dimensions, unsigned mask)
{
    return dimensions == 2 && (mask & ~(OUTPUTS_ALL2 | OUTPUTS_PHASE)) != 0;
}

/* Whether calls must serve these outputs of a noise. */
static int is_served(const struct scarp_noise *noise, int dimensions, unsigned mask)
{
    const int dphase = (mask >> OUTPUT_dphase & 1) != 0;
    return !beyond(dimensions, mask) &&
           scarp_noise_fault(noise, dimensions, order_of(mask), dphase, NULL) == NULL;
}

/* Check, fault and range say the same of a noise. Returns what calls must return for it. */
static enum scarp_status check_words(const struct scarp_noise *noise, int dimensions,
                                     float range[2])
{
    const char *member = "", *again = "";
    const enum scarp_status status = scarp_noise_check(noise, dimensions, &member);
    const char *const fault = scarp_noise_fault(noise, dimensions, 0, 0, &again);
    fuzz_must((status == SCARP_OK) == (fault == NULL));
    fuzz_must((status == SCARP_OK) == (member == NULL));
    fuzz_must(member == again || strcmp(member, again) == 0);
    range[0] = range[1] = 77.0f;
    fuzz_must(scarp_range(noise, dimensions, &range[0], &range[1]) == status);
    fuzz_must(status == SCARP_OK ? range[0] <= range[1] : range[0] == 77.0f && range[1] == 77.0f);
    fuzz_must(scarp_noise_check(noise, 1 + 3 * (dimensions & 1), NULL) != SCARP_OK);
    return status;
}

/* What kinds of noise promise finite values, and gradients, wherever coordinates are below 2^40 */
static int has_finite_values(const struct scarp_noise *noise)
{
    int promised = 1;
    for (; noise != NULL; noise = noise->warp) {
        promised &= !noise_is_known(noise) || !fractal_bends(noise->fractal);
    }
    return promised;
}

static int has_finite_gradients(const struct scarp_noise *noise)
{
    return noise->warp == NULL && has_finite_values(noise) &&
           (noise->fractal != SCARP_HYBRID || (noise->gain <= 1.0f && noise->gain >= 0.0f));
}

static void check_values(const struct fuzz_call *call, const struct fuzz_points *points,
                         const float range[2])
{
    const struct arguments *const a = call->arguments;
    const int dimensions = function_dimensions(a->function);
    for (size_t i = 0; i < call->count; i++) {
        const float value = fuzz_result[OUTPUT_value][i];
        const int is_near =
            fuzz_point_is_near(points, i, dimensions, function_doubles(a->function));
        if ((call->mask & 1) != 0) {
            fuzz_must(fuzz_is_nan(value) || (value >= range[0] && value <= range[1]));
            fuzz_must(!is_near || !has_finite_values(a->noise) || !fuzz_is_nan(value));
        }
        for (int m = OUTPUT_dx; m <= OUTPUT_dz; m++) {
            fuzz_must((call->mask >> m & 1) == 0 || !is_near || !has_finite_gradients(a->noise) ||
                      fuzz_is_finite(fuzz_result[m][i]));
        }
        for (int axis = 0; axis < dimensions; axis++) { /* NaN and infinity make NaN of all */
            const double x = function_doubles(a->function) ? a->d[axis][i] : (double)a->f[axis][i];
            for (int m = 0; m < OUTPUTS && !(x - x == 0.0); m++) {
                fuzz_must((call->mask >> m & 1) == 0 || fuzz_is_nan(fuzz_result[m][i]));
            }
        }
    }
}

/* The same bits with a plan: its own, and one that does not fit. */
static void check_plans(struct draw *d, struct fuzz_call *call, struct fuzz_noise *noise,
                        int dimensions, enum scarp_status status)
{
    static struct scarp_plan plan, of_warp[FUZZ_LEVELS];
    struct scarp_noise *const top = &noise->level[0];
    top->plan = NULL;
    memset(&plan, POISON, sizeof plan);
    fuzz_must(scarp_plan_make(top, dimensions, &plan) == status);
    if (status != SCARP_OK) {
        fuzz_must(all_poison(&plan, sizeof plan));
        return;
    }
    const enum scarp_isa isa = (enum scarp_isa)(draw_below(d, 8));
    if (scarp_isa_supported(isa)) {
        fuzz_must(scarp_isa_select(isa) == SCARP_OK);
    }
    top->plan = &plan;
    for (int i = 1; i < FUZZ_LEVELS && noise->level[i - 1].warp != NULL; i++) {
        if (draw_below(d, 2) != 0) {
            fuzz_must(scarp_vector_plan_make(&noise->level[i], dimensions, &of_warp[i]) ==
                      SCARP_OK);
            noise->level[i].plan = &of_warp[i];
        }
    }
    fuzz_must(fuzz_same(call));
    struct scarp_noise changed = *top;
    changed.seed ^= 1;
    changed.plan = NULL;
    if (scarp_plan_make(&changed, dimensions, &plan) == SCARP_OK) {
        fuzz_must(fuzz_same(call));
    }
    for (int i = 0; i < FUZZ_LEVELS; i++) {
        noise->level[i].plan = NULL;
    }
    fuzz_must(scarp_isa_select(SCARP_ISA_NONE) == SCARP_OK);
}

/* What outputs a call is asked for: mostly those that this noise has. */
static unsigned draw_mask(struct draw *d, const struct scarp_noise *noise, enum function f)
{
    const unsigned any = (unsigned)draw_bits(d, 2);
    return draw_rarely(d, 8) ? any & ((1u << OUTPUTS) - 1) : any & outputs_of(noise, f);
}

static void try_points(struct draw *d, struct fuzz_noise *noise, enum function f, unsigned mask,
                       enum scarp_status expected, const float range[2])
{
    static struct fuzz_points points;
    fuzz_draw_points(d, &points);
    struct arguments a = {.noise = &noise->level[0], .function = f};
    const int dimensions = function_dimensions(f);
    const int is_null = draw_rarely(d, 32), huge = draw_rarely(d, 32);
    for (int axis = 0; axis < dimensions - is_null; axis++) {
        a.f[axis] = points.f[axis];
        a.d[axis] = points.d[axis];
    }
    struct fuzz_call call = {.make = make,
                             .arguments = &a,
                             .count = points.count,
                             .mask = mask,
                             .inputs = {(float **)&a.f[0], (float **)&a.f[1]}};
    if (function_doubles(f)) {
        call.inputs[0] = NULL;
    }
    if (huge && mask != 0) {
        call.count = SIZE_MAX / 2 + draw_byte(d);
        float *out[FUZZ_OUTPUTS] = {NULL};
        for (int m = 0; m < OUTPUTS; m++) {
            out[m] = (mask >> m & 1) != 0 ? fuzz_result[m] : NULL;
        }
        fuzz_must(make(&call, 0, call.count, out) != SCARP_OK);
        return;
    }
    const enum scarp_status status = fuzz_check(d, &call);
    if (call.count == 0) {
        fuzz_must(status == SCARP_OK);
        return;
    }
    fuzz_must((status == SCARP_OK) == (!is_null && is_served(a.noise, dimensions, mask)));
    fuzz_must(expected == SCARP_OK || is_null || beyond(dimensions, mask) || status == expected);
    if (status == SCARP_OK) {
        check_values(&call, &points, range);
        check_plans(d, &call, noise, dimensions, expected);
    }
}

static void try_grid(struct draw *d, struct fuzz_noise *noise, enum function f, unsigned mask)
{
    static struct fuzz_places places;
    struct scarp_grid grid;
    const int dimensions = function_dimensions(f);
    fuzz_draw_grid(d, dimensions, &grid);
    struct arguments a = {.noise = &noise->level[0], .grid = &grid, .function = f};
    struct fuzz_call call = {
        .make = make, .arguments = &a, .count = FUZZ_ROOM, .mask = mask, .is_grid = 1};
    const enum scarp_status status = fuzz_check(d, &call);
    if (grid.count[0] * grid.count[1] * grid.count[2] == 0) {
        fuzz_must(status == SCARP_OK);
        return;
    }
    const int is_wrong = scarp_grid_fault(&grid, dimensions, NULL) != NULL;
    fuzz_must((status == SCARP_OK) == (!is_wrong && is_served(a.noise, dimensions, mask)));
    if (status != SCARP_OK) {
        return;
    }
    check_plans(d, &call, noise, dimensions, SCARP_OK);
    fuzz_find_places(&grid, &places);
    a.grid = NULL;
    a.function = dimensions == 2 ? SAMPLE2_F64 : SAMPLE3_F64;
    for (int axis = 0; axis < 3; axis++) {
        a.d[axis] = places.position[axis];
    }
    fuzz_check_places(&call, &places);
}

/* Words for any number */
static void try_names(struct draw *d)
{
    const uint32_t bits = (uint32_t)draw_bits(d, 4);
    const int number = (int)bits >> draw_below(d, 32);
    const char *const names[] = {
        scarp_basis_name((enum scarp_basis)number), scarp_fade_name((enum scarp_fade)number),
        scarp_fractal_name((enum scarp_fractal)number), scarp_isa_name((enum scarp_isa)number)};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        fuzz_must(names[i] == NULL || (names[i][0] != '\0' && number >= 0 && number < 16));
    }
    const enum scarp_isa before = scarp_isa_active();
    const enum scarp_status status = scarp_isa_select((enum scarp_isa)number);
    fuzz_must((status == SCARP_OK) ==
              (number == 0 || scarp_isa_supported((enum scarp_isa)number) != 0));
    fuzz_must(status == SCARP_OK || scarp_isa_active() == before);
    fuzz_must(scarp_status_text((enum scarp_status)number) != NULL);
    fuzz_must(scarp_isa_select(SCARP_ISA_NONE) == SCARP_OK);
}

void fuzz_samples(const uint8_t *bytes, size_t size)
{
    static struct fuzz_noise noise;
    struct draw d = {bytes, size};
    const enum function f = (enum function)draw_below(&d, FUNCTIONS);
    const int dimensions = function_dimensions(f), on_grid = draw_below(&d, 3) == 2;
    float range[2];
    if (draw_rarely(&d, 64)) {
        try_names(&d);
    }
    fuzz_draw_noise(&d, dimensions, &noise);
    const unsigned mask = draw_mask(&d, &noise.level[0], f);
    const enum scarp_status expected = check_words(&noise.level[0], dimensions, range);
    if (on_grid) {
        try_grid(&d, &noise, f, mask);
    } else {
        try_points(&d, &noise, f, mask, expected, range);
    }
}
