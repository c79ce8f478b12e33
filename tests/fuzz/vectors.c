/* SPDX-License-Identifier: MIT
 *
 * Vector noise, velocities and cells at points.
 */
#include "../outputs.h"

#include "arguments.h"

enum kind { VECTOR, CURL, CELLS, KINDS };
enum { F1, F2, ID, CELLS_X, CELLS_USED = 12 };
enum { FLOW_USED = 12 };

struct arguments {
    enum kind kind;
    const struct scarp_noise *noise;
    int dimensions, doubles;
    const float *f[3];
    const double *d[3];
};

/* Calls the function of this kind: NAME2, NAME3 or their like with doubles. */
#define CALL(NAME)                                                                                 \
    (a->dimensions == 2 ? a->doubles ? NAME##2_f64(a->noise, count, d[0], d[1], out)               \
                                     : NAME##2(a->noise, count, f[0], f[1], out)                   \
     : a->doubles ? NAME##3_f64(a->noise, count, d[0], d[1], d[2], out)                            \
                        : NAME##3(a->noise, count, f[0], f[1], f[2], out))

static enum scarp_status make(const struct fuzz_call *call, size_t first, size_t count,
                              float *const pointers[FUZZ_OUTPUTS])
{
    const struct arguments *const a = call->arguments;
    const float *f[3];
    const double *d[3];
    for (int axis = 0; axis < 3; axis++) {
        f[axis] = a->f[axis] + first;
        d[axis] = a->d[axis] + first;
    }
    if (a->kind == CURL) {
        const struct scarp_flow *const out = FUZZ_AS(scarp_flow, pointers);
        return CALL(scarp_curl);
    }
    if (a->kind == CELLS) {
        const struct scarp_cells *const out = FUZZ_AS(scarp_cells, pointers);
        return CALL(scarp_cells);
    }
    const struct scarp_samples out[3] = {*FUZZ_AS(scarp_samples, pointers),
                                         *FUZZ_AS(scarp_samples, pointers + FUZZ_MEMBERS),
                                         *FUZZ_AS(scarp_samples, pointers + 2 * FUZZ_MEMBERS)};
    return CALL(scarp_vector);
}

/* Noise with a warp is noise without it, at points that are moved by the vector noise of it. */
static void check_warp(const struct arguments *a, size_t count)
{
    static float moved[3][FUZZ_POINTS], way[3][FUZZ_POINTS], value[2][FUZZ_POINTS];
    if (a->noise->warp == NULL || a->doubles) {
        return;
    }
    struct scarp_noise bare = *a->noise;
    bare.warp = NULL;
    const struct scarp_samples out[3] = {{.value = way[0]}, {.value = way[1]}, {.value = way[2]}};
    const struct arguments warp = {.noise = a->noise->warp, .dimensions = a->dimensions};
    const enum function f = a->dimensions == 2 ? SAMPLE2 : SAMPLE3;
    struct inputs in = {{a->f[0], a->f[1], a->f[2]}, {NULL}};
    fuzz_must((a->dimensions == 2
                   ? scarp_vector2(warp.noise, count, in.f[0], in.f[1], out)
                   : scarp_vector3(warp.noise, count, in.f[0], in.f[1], in.f[2], out)) == SCARP_OK);
    const struct scarp_samples with = {.value = value[0]}, without = {.value = value[1]};
    fuzz_must(function_call(f, a->noise, count, &in, &with) == SCARP_OK);
    for (int axis = 0; axis < a->dimensions; axis++) {
        for (size_t i = 0; i < count; i++) {
            moved[axis][i] = a->f[axis][i] + way[axis][i];
        }
        in.f[axis] = moved[axis];
    }
    fuzz_must(function_call(f, &bare, count, &in, &without) == SCARP_OK);
    fuzz_must(first_difference(value[0], value[1], count) == count);
}

/* Each component keeps to the range of the noise. */
static void check_vector(const struct arguments *a, const struct fuzz_call *call)
{
    float range[2];
    fuzz_must(scarp_range(a->noise, a->dimensions, &range[0], &range[1]) == SCARP_OK);
    for (int c = 0; c < a->dimensions; c++) {
        const int m = c * FUZZ_MEMBERS;
        for (size_t i = 0; (call->mask >> m & 1) != 0 && i < call->count; i++) {
            const float value = fuzz_result[m][i];
            fuzz_must(fuzz_is_nan(value) || (value >= range[0] && value <= range[1]));
        }
    }
    check_warp(a, call->count);
}

/* The velocity is made of derivatives, with their bits: which, by the member of struct scarp_flow;
   `less` is subtracted, or -1. */
static const struct {
    int axis, less, component, less_component;
} flow3[FLOW_USED] = {
    {OUTPUT_dy, OUTPUT_dz, 2, 1},   {OUTPUT_dz, OUTPUT_dx, 0, 2},   {OUTPUT_dx, OUTPUT_dy, 1, 0},
    {OUTPUT_dxy, OUTPUT_dxz, 2, 1}, {OUTPUT_dyy, OUTPUT_dyz, 2, 1}, {OUTPUT_dyz, OUTPUT_dzz, 2, 1},
    {OUTPUT_dxz, OUTPUT_dxx, 0, 2}, {OUTPUT_dyz, OUTPUT_dxy, 0, 2}, {OUTPUT_dzz, OUTPUT_dxz, 0, 2},
    {OUTPUT_dxx, OUTPUT_dxy, 1, 0}, {OUTPUT_dxy, OUTPUT_dyy, 1, 0}, {OUTPUT_dxz, OUTPUT_dyz, 1, 0},
};
static const int flow2[FLOW_USED] = {OUTPUT_dy,  OUTPUT_dx,  -1, OUTPUT_dxy, OUTPUT_dyy, -1,
                                     OUTPUT_dxx, OUTPUT_dxy, -1, -1,         -1,         -1};

static float derivative[3][OUTPUTS][FUZZ_POINTS];

static float expected_flow(int dimensions, int m, size_t i)
{
    if (dimensions == 3) {
        return derivative[flow3[m].component][flow3[m].axis][i] -
               derivative[flow3[m].less_component][flow3[m].less][i];
    }
    const float of_plane = derivative[0][flow2[m]][i];
    return m == 0 || m == 3 || m == 4 ? of_plane : -of_plane;
}

static void check_curl(const struct arguments *a, const struct fuzz_call *call)
{
    const unsigned mask = outputs_up_to((call->mask & 0xff8) != 0 ? 2 : 1, a->dimensions) & ~1u;
    float *out[3][FUZZ_MEMBERS] = {{NULL}};
    for (int c = 0; c < 3; c++) {
        for (int m = 0; m < OUTPUTS; m++) {
            out[c][m] = (mask >> m & 1) != 0 ? derivative[c][m] : NULL;
        }
    }
    const struct inputs in = {{a->f[0], a->f[1], a->f[2]}, {a->d[0], a->d[1], a->d[2]}};
    const struct scarp_samples s[3] = {*FUZZ_AS(scarp_samples, out[0]),
                                       *FUZZ_AS(scarp_samples, out[1]),
                                       *FUZZ_AS(scarp_samples, out[2])};
    const enum function f =
        (enum function)((a->doubles ? SAMPLE2_F64 : SAMPLE2) + (a->dimensions == 3));
    fuzz_must((a->dimensions == 2 ? function_call(f, a->noise, call->count, &in, s)
                                  : vector_call(f, a->noise, call->count, &in, s)) == SCARP_OK);
    for (int m = 0; m < FLOW_USED; m++) {
        for (size_t i = 0; (call->mask >> m & 1) != 0 && i < call->count; i++) {
            fuzz_must(fuzz_equal(fuzz_result[m][i], expected_flow(a->dimensions, m, i)));
        }
    }
}

/* Distances in their order, unit vectors, ids that are even; members that cells ignore */
static void check_cells(struct arguments *a, struct fuzz_call *call)
{
    for (size_t i = 0; i < call->count; i++) {
        const float f1 = fuzz_result[F1][i], f2 = fuzz_result[F2][i];
        uint32_t id;
        memcpy(&id, &fuzz_result[ID][i], sizeof id);
        fuzz_must((call->mask >> F1 & 1) == 0 || fuzz_is_nan(f1) || f1 >= 0.0f);
        fuzz_must((call->mask & 3) != 3 || fuzz_is_nan(f1) || f1 <= f2);
        fuzz_must((call->mask & 3) != 3 || fuzz_is_nan(f1) == fuzz_is_nan(f2));
        fuzz_must((call->mask >> ID & 1) == 0 || (id & 1) == 0);
        fuzz_must((call->mask & 5) != 5 || !fuzz_is_nan(f1) || id == 0);
    }
    struct scarp_noise changed = *a->noise;
    const struct scarp_noise *const kept = a->noise;
    changed.amplitude = 3.0f;
    changed.fractal = SCARP_RIDGED;
    changed.fade = SCARP_CUBIC;
    a->noise = &changed;
    if (scarp_noise_check(&changed, a->dimensions, NULL) == SCARP_OK) {
        fuzz_must(fuzz_same(call));
    }
    a->noise = kept;
}

static uint64_t draw_mask(struct draw *d, const struct arguments *a)
{
    const uint64_t any = draw_bits(d, 6);
    const int wild = draw_rarely(d, 8);
    if (a->kind == VECTOR) {
        const enum function f = a->dimensions == 2 ? SAMPLE2 : SAMPLE3;
        const uint64_t has = wild ? (1u << OUTPUTS) - 1 : outputs_of(a->noise, f);
        const uint64_t all = has | has << FUZZ_MEMBERS;
        return any & (a->dimensions == 2 ? all : all | has << (2 * FUZZ_MEMBERS));
    }
    const uint64_t used = wild || a->dimensions == 3 ? 0xfff : a->kind == CURL ? 0xdb : 0x6df;
    return any & used & (a->kind == CURL && noise_order(a->noise) < 2 && !wild ? 7 : 0xfff);
}

void fuzz_vectors(const uint8_t *bytes, size_t size)
{
    static struct fuzz_noise noise;
    static struct fuzz_points points;
    struct draw d = {bytes, size};
    struct arguments a = {.kind = (enum kind)draw_below(&d, KINDS), .noise = &noise.level[0]};
    a.dimensions = 2 + (int)draw_below(&d, 2);
    a.doubles = (int)draw_below(&d, 2);
    fuzz_draw_noise(&d, a.dimensions, &noise);
    fuzz_draw_points(&d, &points);
    struct fuzz_call call = {.make = make,
                             .arguments = &a,
                             .count = points.count,
                             .mask = draw_mask(&d, &a),
                             .integers = a.kind == CELLS ? 1u << ID : 0};
    for (int axis = 0; axis < 3; axis++) {
        a.f[axis] = points.f[axis];
        a.d[axis] = points.d[axis];
        call.inputs[axis] = a.doubles || axis >= a.dimensions ? NULL : (float **)&a.f[axis];
    }
    const enum scarp_status status = fuzz_check(&d, &call);
    const enum scarp_status expected = scarp_noise_check(a.noise, a.dimensions, NULL);
    /* Outputs along z in the plane are refused before the noise is looked at. */
    fuzz_must(call.count == 0        ? status == SCARP_OK
              : expected != SCARP_OK ? status == expected || status == SCARP_ERROR_UNSUPPORTED
                                     : 1);
    if (call.count == 0 || status != SCARP_OK) {
        return;
    }
    switch (a.kind) {
    case VECTOR: check_vector(&a, &call); break;
    case CURL: check_curl(&a, &call); break;
    default: check_cells(&a, &call); break;
    }
}
