/* SPDX-License-Identifier: MIT
 *
 * Gullies at points and on grids, in any base.
 */
#include "../gullies.h"

#include "arguments.h"

struct arguments {
    struct scarp_gullies gullies;
    const struct scarp_grid *grid; /* NULL: points */
    int doubles;
    const float *f[2];
    const double *d[2];
    float *base[INS];
};

static float *behind(float *array, size_t first)
{
    return array != NULL ? array + first : NULL;
}

static enum scarp_status make(const struct fuzz_call *call, size_t first, size_t count,
                              float *const pointers[FUZZ_OUTPUTS])
{
    const struct arguments *const a = call->arguments;
    const struct scarp_eroded *const out = FUZZ_AS(scarp_eroded, pointers);
    float *in[INS];
    for (int i = 0; i < INS; i++) {
        in[i] = behind(a->base[i], first);
    }
    const struct scarp_samples base = base_of(in);
    return a->grid != NULL ? scarp_gullies_grid2(&a->gullies, a->grid, &base, out)
           : a->doubles
               ? scarp_gullies2_f64(&a->gullies, count, a->d[0] + first, a->d[1] + first, &base,
                                    out)
               : scarp_gullies2(&a->gullies, count, a->f[0] + first, a->f[1] + first, &base, out);
}

static double member(struct draw *d, int wild, double lowest, double highest)
{
    return draw_below(d, 2) != 0       ? 0.0
           : wild && draw_rarely(d, 4) ? draw_wild(d)
                                       : draw_scale(d, lowest, highest);
}

static void draw_gullies(struct draw *d, int wild, struct scarp_gullies *g)
{
    memset(g, 0, sizeof *g);
    g->seed = draw_bits(d, 2);
    g->frequency = member(d, wild, 0x1p-6, 0x1p6);
    g->amplitude = (float)member(d, wild, 0x1p-12, 0x1p12);
    g->octaves = (float)member(d, wild, 0.25, 6.0);
    g->of_octaves = draw_rarely(d, 8) ? 32.0f : 0.0f;
    g->lacunarity = (float)member(d, wild, 0.5, 4.0);
    g->gain = (float)member(d, wild, 0x1p-4, 2.0);
    g->depth = (float)member(d, wild, 0x1p-24, 0x1p10);
    g->cells = (float)member(d, wild, 0x1p-6, 0x1p6);
    g->slope = (float)member(d, wild, 0x1p-5, 0x1p5);
    g->slope_low = (float)member(d, wild, 0x1p-5, 0x1p5);
    g->low = -(float)member(d, wild, 0x1p-3, 0x1p10);
    g->high = (float)member(d, wild, 0x1p-3, 0x1p10);
    g->floor = (float)(draw_below(d, 2) ? draw_between(d, -1.0, 1.0) : 0.0);
    g->stripes = (float)member(d, wild, 0x1p-10, 8.0);
    g->branch = (float)member(d, wild, 0x1p-24, 8.0);
    g->round = (float)member(d, wild, 0x1p-8, 0x1p8);
    g->keep = (float)member(d, wild, 0x1p-24, 1.0);
    const uint32_t switches = draw_below(d, 4);
    g->rotate = switches % 2;
    g->offset_first = switches / 2;
    if (draw_rarely(d, 4)) {
        g->period[0] = draw_byte(d);
        g->period[1] = (uint32_t)draw_bits(d, draw_rarely(d, 4) ? 4 : 1);
        if (!wild) {
            g->rotate = 0;
            g->cells = (float)draw_below(d, 4);
            g->lacunarity = (float)draw_below(d, 4);
        }
    }
    g->spare[0] = wild && draw_rarely(d, 8);
}

/* A smooth hill, or any numbers */
static void draw_base(struct draw *d, struct arguments *a)
{
    static float memory[INS][FUZZ_ROOM];
    uint64_t state = draw_bits(d, 4);
    const int wild = draw_rarely(d, 4);
    const float steep = (float)draw_scale(d, 0x1p-12, 0x1p12);
    for (int i = 0; i < INS; i++) {
        for (size_t n = 0; n < FUZZ_ROOM; n++) {
            state = state * UINT64_C(6364136223846793005) + 1442695040888963407;
            memory[i][n] = steep * (float)((double)(state >> 34) * 0x1p-29 - 1.0);
            if (wild && state >> 58 == 0) {
                memory[i][n] = (float)draw_wild(d);
            }
        }
        a->base[i] = wild && draw_rarely(d, 16) ? NULL : memory[i];
    }
}

/* What the calls that take only gullies say; returns what other calls must return. */
static enum scarp_status check_words(const struct scarp_gullies *gullies, float range[2])
{
    const char *member = "", *again = "";
    const enum scarp_status status = scarp_gullies_check(gullies, &member);
    const char *const fault = scarp_gullies_fault(gullies, &again);
    fuzz_must((status == SCARP_OK) == (fault == NULL) && (status == SCARP_OK) == (member == NULL));
    fuzz_must(member == again || strcmp(member, again) == 0);
    fuzz_must(scarp_gullies_range(gullies, -4096.0f, 4096.0f, &range[0], &range[1]) == status);
    fuzz_must(status != SCARP_OK || (range[0] <= -4096.0f && range[1] >= 4096.0f));
    return status;
}

static void check_values(const struct arguments *a, const struct fuzz_call *call,
                         const float range[2])
{
    for (size_t i = 0; i < call->count; i++) {
        const float value = fuzz_result[OUT_VALUE][i], base = a->base[IN_VALUE][i];
        if ((call->mask >> OUT_VALUE & 1) != 0 && base >= -4096.0f && base <= 4096.0f) {
            fuzz_must(fuzz_is_nan(value) || (value >= range[0] && value <= range[1]));
        }
        const float slope[2] = {a->base[IN_DX][i], a->base[IN_DY][i]};
        const int is_nan =
            fuzz_is_nan(base) || !fuzz_is_finite(slope[0]) || !fuzz_is_finite(slope[1]);
        for (int m = 0; m < OUTS && is_nan; m++) {
            fuzz_must((call->mask >> m & 1) == 0 || fuzz_is_nan(fuzz_result[m][i]));
        }
    }
}

static void check_grid(struct arguments *a, struct fuzz_call *call, const struct scarp_grid *grid)
{
    static struct fuzz_places places;
    static float gathered[INS][FUZZ_ROOM];
    fuzz_find_places(grid, &places);
    for (int m = 0; m < INS; m++) {
        for (size_t i = 0; i < places.count && a->base[m] != NULL; i++) {
            gathered[m][i] = a->base[m][places.element[i]];
        }
        a->base[m] = a->base[m] != NULL ? gathered[m] : NULL;
    }
    a->grid = NULL;
    a->doubles = 1;
    a->d[0] = places.position[0];
    a->d[1] = places.position[1];
    fuzz_check_places(call, &places);
}

void fuzz_gullies(const uint8_t *bytes, size_t size)
{
    static struct arguments a;
    static struct fuzz_points points;
    static struct scarp_grid grid;
    struct draw d = {bytes, size};
    float range[2];
    const int on_grid = draw_below(&d, 3) == 2, wild = draw_rarely(&d, 8);
    draw_gullies(&d, wild, &a.gullies);
    draw_base(&d, &a);
    fuzz_draw_points(&d, &points);
    fuzz_draw_grid(&d, 2, &grid);
    a.doubles = (int)draw_below(&d, 2);
    a.grid = on_grid ? &grid : NULL;
    for (int axis = 0; axis < 2; axis++) {
        a.f[axis] = points.f[axis];
        a.d[axis] = points.d[axis];
    }
    struct fuzz_call call = {.make = make,
                             .arguments = &a,
                             .count = on_grid ? FUZZ_ROOM : points.count,
                             .mask = draw_byte(&d) & OUT_ALL,
                             .is_grid = on_grid};
    size_t inputs = 0;
    for (int i = 0; i < INS; i++) {
        call.inputs[inputs++] = &a.base[i];
    }
    if (!a.doubles && !on_grid) {
        call.inputs[inputs++] = (float **)&a.f[0];
        call.inputs[inputs++] = (float **)&a.f[1];
    }
    const enum scarp_status status = fuzz_check(&d, &call);
    const enum scarp_status expected = check_words(&a.gullies, range);
    const int is_empty = on_grid ? grid.count[0] * grid.count[1] == 0 : points.count == 0;
    fuzz_must(!is_empty || status == SCARP_OK);
    fuzz_must(is_empty || expected == SCARP_OK || status != SCARP_OK);
    if (is_empty || status != SCARP_OK) {
        return;
    }
    if (on_grid) {
        check_grid(&a, &call, &grid);
    } else {
        check_values(&a, &call, range);
    }
}
