/* SPDX-License-Identifier: MIT */
#include "../outputs.h"

#include "arguments.h"

uint64_t fuzz_digest = UINT64_C(0xcbf29ce484222325);
long fuzz_calls, fuzz_served, fuzz_case = -1;
const struct scarp_noise *fuzz_case_noise;
const char *fuzz_case_text;
float fuzz_result[FUZZ_OUTPUTS][FUZZ_ROOM];
static float other[FUZZ_OUTPUTS][FUZZ_ROOM];

void fuzz_note(uint64_t number)
{
    fuzz_digest = (fuzz_digest ^ number) * UINT64_C(0x9e3779b97f4a7c15);
    fuzz_digest ^= fuzz_digest >> 32;
}

static void print_noise(const struct scarp_noise *noise)
{
    for (; noise != NULL; noise = noise->warp) {
        fprintf(stderr,
                "{.basis = %d, .fade = %d, .fractal = %d, .rotate = %u, .seed = %llu, "
                ".frequency = %.17g, .octaves = %.9g, .lacunarity = %.9g, .gain = %.9g, "
                ".amplitude = %.9g, .erosion = %.9g, .phase = %.9g, .jitter = %.9g, "
                ".sharpness = %.9g, .period = {%u, %u, %u}, .of_octaves = %.9g, "
                ".offset_first = %u}\n",
                (int)noise->basis, (int)noise->fade, (int)noise->fractal, (unsigned)noise->rotate,
                (unsigned long long)noise->seed, noise->frequency, (double)noise->octaves,
                (double)noise->lacunarity, (double)noise->gain, (double)noise->amplitude,
                (double)noise->erosion, (double)noise->phase, (double)noise->jitter,
                (double)noise->sharpness, (unsigned)noise->period[0], (unsigned)noise->period[1],
                (unsigned)noise->period[2], (double)noise->of_octaves,
                (unsigned)noise->offset_first);
    }
}

void fuzz_broken(const char *file, int line, const char *condition)
{
    if (fuzz_case >= 0) {
        fprintf(stderr, "case %ld: ", fuzz_case);
    }
    fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, condition);
    print_noise(fuzz_case_noise);
    fprintf(stderr, "%s", fuzz_case_text != NULL ? fuzz_case_text : "");
    abort();
}

int fuzz_is_nan(float number)
{
    return is_nan_bits(&number);
}

int fuzz_is_finite(float number)
{
    return is_finite_bits(&number);
}

int fuzz_equal(float a, float b)
{
    return float_bits(&a) == float_bits(&b);
}

/* A number of a noise: its default, one that is valid, or with `wild` now and then any. */
static double member(struct draw *d, int wild, double lowest, double highest)
{
    const uint32_t kind = draw_byte(d);
    return wild && kind >= 0xe0 ? draw_wild(d)
           : kind < 0x60        ? 0.0
           : kind < 0x70        ? lowest
           : kind < 0x80        ? highest
                                : draw_scale(d, lowest, highest);
}

static void draw_level(struct draw *d, int dimensions, int is_warp, struct scarp_noise *noise)
{
    const int wild = draw_rarely(d, 8);
    memset(noise, 0, sizeof *noise);
    noise->basis = (enum scarp_basis)draw_below(d, (uint32_t)(SCARP_BASES + 2 * wild));
    noise->fractal = (enum scarp_fractal)draw_below(d, (uint32_t)(SCARP_FRACTALS + 2 * wild));
    noise->fade = (enum scarp_fade)draw_below(d, wild ? 4 : 2);
    const uint32_t switches = draw_below(d, 4);
    noise->rotate = switches % 2;
    noise->offset_first = switches / 2;
    noise->seed = draw_bits(d, draw_rarely(d, 4) ? 8 : 1);
    const int is_share = (int)noise->fractal < (int)SCARP_FRACTALS &&
                         fractal_row(noise->fractal)->most_erosion == 1.0f;
    noise->frequency = member(d, wild, 0x1p-8, 0x1p8);
    noise->octaves = (float)member(d, wild, 0.25, draw_rarely(d, 16) ? 32.0 : 5.0);
    noise->lacunarity = (float)member(d, wild, 0x1p-4, 16.0);
    noise->gain = (float)member(d, wild, 0x1p-4, draw_rarely(d, 8) ? 16.0 : 1.0);
    noise->amplitude = (float)member(d, wild, is_warp ? 0x1p-4 : 0x1p-24, is_warp ? 4.0 : 0x1p24);
    noise->amplitude *= draw_rarely(d, 4) ? -1.0f : 1.0f;
    noise->erosion = (float)member(d, wild, 0x1p-24, is_share ? 1.0 : 0x1p24);
    noise->jitter = (float)member(d, wild, 0x1p-20, 1.0);
    noise->sharpness = (float)member(d, wild, 0x1p-8, 0x1p8);
    if (draw_rarely(d, 8)) {
        noise->of_octaves = 32.0f;
    }
    if (wild || (noise->basis == SCARP_GRADIENT && draw_rarely(d, 4))) {
        noise->phase = (float)(wild ? draw_wild(d) : draw_between(d, -4.0, 4.0));
    }
    if (draw_rarely(d, 4)) {
        const int axes = wild || dimensions == 3                        ? 3
                         : basis_axes_with_period(noise->basis, 2) == 1 ? 1
                                                                        : 3;
        for (int i = 0; i < axes; i++) {
            noise->period[i] = (uint32_t)draw_bits(d, draw_rarely(d, 4) ? 4 : 1);
            noise->period[i] &= wild ? 0xffffffff : 0x3fffffff;
        }
        if (!wild) {
            noise->rotate = 0;
            noise->lacunarity = (float)draw_below(d, 4);
        }
    }
    if (wild && draw_rarely(d, 8)) {
        noise->spare[0] = 1;
    }
}

void fuzz_draw_noise(struct draw *d, int dimensions, struct fuzz_noise *noise)
{
    fuzz_case_noise = &noise->level[0];
    draw_level(d, dimensions, 0, &noise->level[0]);
    for (int i = 0; i < 5 && draw_rarely(d, 4); i++) {
        draw_level(d, dimensions, 1, &noise->level[i + 1]);
        noise->level[i].warp = &noise->level[i + 1];
    }
}

void fuzz_draw_points(struct draw *d, struct fuzz_points *points)
{
    const double span = draw_rarely(d, 4) ? draw_scale(d, 0x1p-30, 0x1p52) : 16.0;
    const double step = draw_rarely(d, 4) ? 1.0 : span / 64.0; /* 1: on the lattice, and near it */
    const int are_near = draw_below(d, 2) != 0;                /* as points of a small grid are */
    const int wild = draw_rarely(d, 8);
    points->count = draw_byte(d) % FUZZ_POINTS;
    double origin[3];
    for (int axis = 0; axis < 3; axis++) {
        origin[axis] = draw_between(d, -span, span);
    }
    uint64_t state = draw_bits(d, 2);
    for (size_t i = 0; i < FUZZ_POINTS; i++) {
        for (int axis = 0; axis < 3; axis++) {
            state = state * UINT64_C(6364136223846793005) + 1442695040888963407;
            const int64_t r = (int64_t)(state >> 33) - (INT64_C(1) << 30);
            double x =
                are_near ? origin[axis] + step * (double)(r % 64) : span * ((double)r * 0x1p-30);
            if (wild && i < points->count && draw_rarely(d, 16)) {
                x = draw_wild(d);
            }
            points->d[axis][i] = x;
            points->f[axis][i] = (float)x;
        }
    }
}

int fuzz_point_is_near(const struct fuzz_points *points, size_t i, int dimensions, int doubles)
{
    int is_near = 1;
    for (int axis = 0; axis < dimensions; axis++) {
        const double x = doubles ? points->d[axis][i] : (double)points->f[axis][i];
        is_near &= x > -0x1p40 && x < 0x1p40;
    }
    return is_near;
}

void fuzz_draw_grid(struct draw *d, int dimensions, struct scarp_grid *grid)
{
    const int wild = draw_rarely(d, 8);
    memset(grid, 0, sizeof *grid);
    const int is_long = draw_below(d, 2) == 0; /* rows of many blocks, else a few samples */
    if (is_long) {
        grid->count[0] = draw_byte(d) % (dimensions == 2 ? 240 : 120);
        grid->count[1] = draw_byte(d) % (dimensions == 2 ? 4 : 3);
        grid->count[2] = draw_byte(d) % 3;
    } else {
        grid->count[0] = draw_byte(d) % 10;
        grid->count[1] = draw_byte(d) % 8;
        grid->count[2] = draw_byte(d) % 6;
    }
    const double step = draw_scale(d, 0x1p-12, draw_rarely(d, 4) ? 0x1p20 : 2.0);
    for (int axis = 0; axis < 3; axis++) {
        grid->origin[axis] =
            draw_rarely(d, 8) ? draw_between(d, -0x1p40, 0x1p40) : draw_between(d, -16.0, 16.0);
        grid->step[axis] = draw_rarely(d, 8) ? draw_between(d, -2.0, 2.0) : step;
        grid->first[axis] = draw_rarely(d, 4) ? (int64_t)draw_bits(d, 3) - (1 << 23) : 0;
        if (wild && draw_rarely(d, 8)) {
            grid->origin[axis] = draw_wild(d);
        }
        if (wild && draw_rarely(d, 8)) {
            grid->step[axis] = draw_wild(d);
        }
        if (wild && draw_rarely(d, 8)) {
            const uint64_t bits = draw_bits(d, 8);
            grid->first[axis] = (int64_t)(bits >> draw_below(d, 64));
        }
    }
    if (draw_rarely(d, 4)) {
        grid->row_stride = grid->count[0] + draw_below(d, 3);
        if (wild) {
            grid->row_stride -= grid->row_stride > 0 && draw_rarely(d, 4);
        }
    }
    const size_t row = grid->row_stride != 0 ? grid->row_stride : grid->count[0];
    if (dimensions == 3 && draw_rarely(d, 4)) {
        grid->slice_stride = row * grid->count[1] + draw_below(d, 4);
        if (wild) {
            grid->slice_stride /= draw_below(d, 3) + 1;
        }
    }
    if (wild && draw_rarely(d, 8)) {
        grid->spare[0] = 1;
    }
    if (dimensions == 2) {
        grid->count[2] = 1;
    }
}

void fuzz_find_places(const struct scarp_grid *grid, struct fuzz_places *places)
{
    const size_t row = grid->row_stride != 0 ? grid->row_stride : grid->count[0];
    const size_t slice = grid->slice_stride != 0 ? grid->slice_stride : row * grid->count[1];
    places->count = grid->count[0] * grid->count[1] * grid->count[2];
    for (size_t i = 0; i < places->count; i++) {
        const size_t index[3] = {i % grid->count[0], i / grid->count[0] % grid->count[1],
                                 i / grid->count[0] / grid->count[1]};
        for (int axis = 0; axis < 3; axis++) {
            const double steps = (double)(grid->first[axis] + (int64_t)index[axis]);
            places->position[axis][i] = grid->origin[axis] + steps * grid->step[axis];
        }
        places->element[i] = index[2] * slice + index[1] * row + index[0];
    }
}

const void *fuzz_as(void *structure, float *const *pointers)
{
    memcpy(structure, pointers, FUZZ_MEMBERS * sizeof *pointers);
    return structure;
}

static void poison(float memory[FUZZ_OUTPUTS][FUZZ_ROOM], uint64_t mask)
{
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        if ((mask >> m & 1) != 0) {
            memset(memory[m], POISON, sizeof memory[m]);
        }
    }
}

static void must_be_untouched(float memory[FUZZ_OUTPUTS][FUZZ_ROOM], uint64_t mask)
{
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        fuzz_must((mask >> m & 1) == 0 || all_poison(memory[m], sizeof memory[m]));
    }
}

static enum scarp_status call_for(const struct fuzz_call *call, size_t first, size_t count,
                                  uint64_t mask, float memory[FUZZ_OUTPUTS][FUZZ_ROOM])
{
    float *out[FUZZ_OUTPUTS];
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        out[m] = (mask >> m & 1) != 0 ? memory[m] + first : NULL;
    }
    return call->make(call, first, count, out);
}

/* What is in `other`, of the outputs of a mask, is in fuzz_result. */
static int same_results(const struct fuzz_call *call, uint64_t mask)
{
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        if ((mask >> m & 1) == 0 || memcmp(other[m], fuzz_result[m], sizeof other[m]) == 0) {
            continue;
        }
        const size_t i = first_difference(other[m], fuzz_result[m], FUZZ_ROOM);
        if (i < FUZZ_ROOM || (call->integers >> m & 1) != 0) {
            fprintf(stderr, "output %d, element %zu: %.9g, the reference has %.9g\n", m, i,
                    (double)other[m][i % FUZZ_ROOM], (double)fuzz_result[m][i % FUZZ_ROOM]);
            return 0;
        }
    }
    return 1;
}

/* The same in two parts, and with fewer outputs */
static void check_parts(struct draw *d, const struct fuzz_call *call)
{
    if (!call->is_grid && call->count > 1) {
        const size_t cut = draw_byte(d) % call->count;
        poison(other, call->mask);
        fuzz_must(call_for(call, 0, cut, call->mask, other) == SCARP_OK);
        fuzz_must(call_for(call, cut, call->count - cut, call->mask, other) == SCARP_OK);
        fuzz_must(same_results(call, call->mask));
    }
    const uint64_t fewer = call->mask & (draw_bits(d, 6) | (call->mask & (0 - call->mask)));
    poison(other, call->mask);
    fuzz_must(call_for(call, 0, call->count, fewer, other) == SCARP_OK);
    fuzz_must(same_results(call, fewer));
    must_be_untouched(other, call->mask & ~fewer);
}

/* The same where an output is an input: another one each time */
static void check_in_place(struct draw *d, const struct fuzz_call *call)
{
    static float memory[FUZZ_ROOM];
    int inputs = 0, outputs = 0, chosen = -1;
    while (call->inputs[inputs] != NULL) {
        inputs++;
    }
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        outputs += (call->mask >> m & 1) != 0 && (call->integers >> m & 1) == 0;
    }
    if (inputs == 0 || outputs == 0) {
        return;
    }
    int left = (int)draw_below(d, (uint32_t)outputs);
    while (left >= 0) {
        chosen++;
        left -= (call->mask >> chosen & 1) != 0 && (call->integers >> chosen & 1) == 0;
    }
    float **const input = call->inputs[draw_below(d, (uint32_t)inputs)], *const kept = *input;
    if (kept == NULL) {
        return;
    }
    memcpy(memory, kept, call->count * sizeof *memory);
    *input = memory;
    float *out[FUZZ_OUTPUTS];
    poison(other, call->mask);
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        out[m] = (call->mask >> m & 1) == 0 ? NULL : m == chosen ? memory : other[m];
    }
    fuzz_must(call->make(call, 0, call->count, out) == SCARP_OK);
    *input = kept;
    for (size_t i = 0; i < call->count; i++) {
        if (all_poison(&fuzz_result[chosen][i], sizeof(float))) { /* between the rows of a grid */
            fuzz_must(fuzz_equal(memory[i], kept[i]));
        } else {
            other[chosen][i] = memory[i];
        }
    }
    fuzz_must(same_results(call, call->mask));
}

int fuzz_same(const struct fuzz_call *call)
{
    poison(other, call->mask);
    return call_for(call, 0, call->count, call->mask, other) == SCARP_OK &&
           same_results(call, call->mask);
}

void fuzz_check_places(const struct fuzz_call *of_points, const struct fuzz_places *places)
{
    fuzz_must(call_for(of_points, 0, places->count, of_points->mask, other) == SCARP_OK);
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        if ((of_points->mask >> m & 1) == 0) {
            continue;
        }
        for (size_t i = 0; i < places->count; i++) {
            float *const element = &fuzz_result[m][places->element[i]];
            fuzz_must(fuzz_equal(*element, other[m][i]));
            memset(element, POISON, sizeof *element);
        }
        fuzz_must(all_poison(fuzz_result[m], sizeof fuzz_result[m]));
    }
}

/* Bytes for checks of one set: what is drawn of the input does not depend on the sets there are. */
static void choose(uint64_t *state, uint8_t bytes[16])
{
    for (int i = 0; i < 16; i++) {
        *state = *state * UINT64_C(6364136223846793005) + 1442695040888963407;
        bytes[i] = (uint8_t)(*state >> 56);
    }
}

enum scarp_status fuzz_check(struct draw *d, const struct fuzz_call *call)
{
    uint64_t state = draw_bits(d, 4);
    uint8_t bytes[16];
    fuzz_must(scarp_isa_select(SCARP_ISA_SCALAR) == SCARP_OK);
    poison(fuzz_result, call->mask);
    const enum scarp_status status = call_for(call, 0, call->count, call->mask, fuzz_result);
    fuzz_note((uint64_t)status);
    fuzz_calls++;
    fuzz_served += status == SCARP_OK && call->count > 0 && call->mask != 0;
    if (status != SCARP_OK) {
        must_be_untouched(fuzz_result, call->mask);
    }
    for (int m = 0; m < FUZZ_OUTPUTS; m++) {
        if ((call->mask >> m & 1) != 0 && status == SCARP_OK) {
            fuzz_must(call->is_grid || all_poison(fuzz_result[m] + call->count,
                                                  (FUZZ_ROOM - call->count) * sizeof(float)));
            for (size_t i = 0; i < call->count; i++) {
                fuzz_note(float_bits(&fuzz_result[m][i]));
            }
        }
    }
    for (enum scarp_isa isa = SCARP_ISA_SCALAR; scarp_isa_name(isa) != NULL; isa++) {
        if (!scarp_isa_supported(isa)) {
            continue;
        }
        fuzz_must(scarp_isa_select(isa) == SCARP_OK);
        if (isa != SCARP_ISA_SCALAR) {
            poison(other, call->mask);
            fuzz_must(call_for(call, 0, call->count, call->mask, other) == status);
            fuzz_must(same_results(call, call->mask));
        }
        if (status == SCARP_OK && call->count > 0) {
            struct draw choices = {bytes, sizeof bytes};
            choose(&state, bytes);
            check_parts(&choices, call);
            check_in_place(&choices, call);
        }
    }
    fuzz_must(scarp_isa_select(SCARP_ISA_NONE) == SCARP_OK);
    return status;
}
