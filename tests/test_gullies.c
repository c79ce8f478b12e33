/* SPDX-License-Identifier: MIT
 *
 * Gullies: a set has the bits of the reference, at points and on grids, whatever is asked for and
 * however many points there are; outputs may be where the base is; what NaNs and steep slopes do;
 * what is refused.
 *
 *     test_gullies ISA
 *     test_gullies --must-differ ISA   the same, but results must differ: for mutants
 */
#include "gullies.h"

#define POINTS 709
#define MEMBERS OUTS
#include "near.h"
#define COLUMNS 37
#define ROWS 19 /* of grids: 703 samples */
#define STRIDE 41

static float base[INS][POINTS];

enum kind { FLOATS, DOUBLES, GRID, KINDS };
static const char *const kind_names[KINDS] = {"floats", "doubles", "grid"};

static const struct scarp_grid grid = {
    .origin = {-1.7, 2.3}, .step = {0.071, 0.113}, .first = {-3, 5}, .count = {COLUMNS, ROWS}};

/* Places the points where those of the grid are, and a base of octaves of noise there. */
static void make_points(const struct scarp_gullies *g)
{
    const double frequency = g->frequency != 0.0 ? g->frequency : 1.0;
    const float amplitude = g->amplitude != 0.0f ? g->amplitude : 1.0f;
    const struct scarp_noise noise = {
        .seed = 3, .octaves = 2.0f, .frequency = frequency, .amplitude = amplitude};
    for (size_t i = 0; i < POINTS; i++) {
        const size_t index[2] = {i % COLUMNS, i / COLUMNS};
        for (int d = 0; d < 2; d++) {
            f64[d][i] = grid.origin[d] +
                        (double)(grid.first[d] + (int64_t)index[d]) * (grid.step[d] / frequency);
            f32[d][i] = (float)f64[d][i];
        }
    }
    const struct scarp_samples out = {.value = base[IN_VALUE],
                                      .dx = base[IN_DX],
                                      .dy = base[IN_DY],
                                      .dxx = base[IN_DXX],
                                      .dxy = base[IN_DXY],
                                      .dyy = base[IN_DYY]};
    CHECK(scarp_sample2_f64(&noise, POINTS, f64[0], f64[1], &out) == SCARP_OK, "the base");
}

static struct scarp_samples base_from(size_t first)
{
    float *in[INS];
    for (int i = 0; i < INS; i++) {
        in[i] = base[i] + first;
    }
    return base_of(in);
}

/* Erodes `count` points from `first` on. */
static enum scarp_status erode(const struct scarp_gullies *g, enum kind kind, size_t first,
                               size_t count, unsigned wanted, struct near *to)
{
    float *out[OUTS];
    for (int i = 0; i < OUTS; i++) {
        out[i] = to->of[i].f + 1 + first;
    }
    const struct scarp_samples in = base_from(first);
    const struct scarp_eroded eroded = eroded_of(out, wanted);
    if (kind == FLOATS) {
        return scarp_gullies2(g, count, f32[0] + first, f32[1] + first, &in, &eroded);
    }
    if (kind == DOUBLES) {
        return scarp_gullies2_f64(g, count, f64[0] + first, f64[1] + first, &in, &eroded);
    }
    struct scarp_grid scaled = grid;
    for (int d = 0; d < 2; d++) {
        scaled.step[d] = grid.step[d] / (g->frequency != 0.0 ? g->frequency : 1.0);
    }
    return scarp_gullies_grid2(g, &scaled, &in, &eroded);
}

/* Whether outputs from first to end are the same, and those not wanted, and all others, untouched.
 */
static void compare(const char *what, int description, enum kind kind, unsigned wanted,
                    size_t first, size_t end)
{
    for (int m = 0; m < OUTS; m++) {
        const int asked = (wanted >> m & 1) != 0;
        CHECK(here.of[m].u[0] == POISON && here.of[m].u[POINTS + 1] == POISON, "%s: %s", what,
              out_names[m]);
        for (size_t i = 0; i < POINTS && !check_enough(); i++) {
            const int inside = asked && i >= first && i < end;
            const uint32_t is = bits_of(&here, m, i);
            CHECK_BITS(is == (inside ? bits_of(&there, m, i) : POISON),
                       "%s, description %d, %s, %s of %zu: %08x", what, description,
                       kind_names[kind], out_names[m], i, (unsigned)is);
        }
    }
}

/* The same call, and calls of fewer points and outputs, by the set and by the reference. */
static void test_bits(int n, enum kind kind, enum scarp_isa isa)
{
    static const unsigned wanted[] = {OUT_ALL, OUT_VALUES, 1u << OUT_DISPLACEMENT, 1u << OUT_DX,
                                      1u << OUT_VALUE | 1u << OUT_DISPLACEMENT_DY};
    const struct scarp_gullies *const g = &descriptions[n];
    const size_t all = kind == GRID ? COLUMNS * ROWS : POINTS;
    poison(&there);
    scarp_isa_select(SCARP_ISA_SCALAR);
    CHECK(erode(g, kind, 0, all, OUT_ALL, &there) == SCARP_OK, "reference %d", n);
    scarp_isa_select(isa);
    for (size_t w = 0; w < sizeof wanted / sizeof *wanted; w++) {
        poison(&here);
        CHECK(erode(g, kind, 0, all, wanted[w], &here) == SCARP_OK, "description %d", n);
        compare("all", n, kind, wanted[w], 0, all);
    }
    for (size_t count = 0; kind != GRID && n < 2 && count < 70; count++) {
        poison(&here);
        CHECK(erode(g, kind, count, count, OUT_ALL, &here) == SCARP_OK, "%zu points", count);
        compare("lengths", n, kind, OUT_ALL, count, 2 * count);
    }
}

/* Likewise points of which some are far from the origin, or overflow. */
static void test_far(int n, enum scarp_isa isa)
{
    for (size_t i = 100; i < 130; i++) {
        f64[i % 2][i] *= 1e3 * pow(10.0, (double)i - 100.0);
    }
    test_bits(n, DOUBLES, isa);
    make_points(&descriptions[n]);
}

/* Every output may be where any array of the base is. */
static void test_in_place(int n, enum kind kind)
{
    const size_t all = kind == GRID ? COLUMNS * ROWS : POINTS;
    static float kept[INS][POINTS];
    poison(&there);
    CHECK(erode(&descriptions[n], kind, 0, all, OUT_ALL, &there) == SCARP_OK, "apart");
    memcpy(kept, base, sizeof kept);
    for (int shift = 0; shift < INS; shift++) {
        float *out[OUTS];
        for (int i = 0; i < OUTS; i++) {
            out[i] = base[(i + shift) % INS];
        }
        const struct scarp_samples in = base_from(0);
        const struct scarp_eroded eroded = eroded_of(out, OUT_ALL);
        struct scarp_grid scaled = grid;
        const enum scarp_status status =
            kind == FLOATS ? scarp_gullies2(&descriptions[n], all, f32[0], f32[1], &in, &eroded)
            : kind == DOUBLES
                ? scarp_gullies2_f64(&descriptions[n], all, f64[0], f64[1], &in, &eroded)
                : scarp_gullies_grid2(&descriptions[n], &scaled, &in, &eroded);
        CHECK(status == SCARP_OK, "in place");
        poison(&here);
        for (int i = 0; i < OUTS; i++) {
            memcpy(here.of[i].f + 1, out[i], all * sizeof(float));
        }
        memcpy(base, kept, sizeof kept);
        compare("in place", n, kind, OUT_ALL, 0, all);
    }
}

/* A grid has the bits of points of doubles, and leaves the gaps between its rows alone. */
static void test_grid(int n)
{
    static float in[INS][STRIDE * ROWS], out[OUTS][STRIDE * ROWS];
    float *ins[INS], *outs[OUTS];
    struct scarp_grid wide = grid;
    wide.row_stride = STRIDE;
    poison(&there);
    CHECK(erode(&descriptions[n], DOUBLES, 0, COLUMNS * ROWS, OUT_ALL, &there) == SCARP_OK,
          "points");
    for (int i = 0; i < INS; i++) {
        ins[i] = in[i];
        outs[i] = out[i];
        for (size_t k = 0; k < STRIDE * ROWS; k++) {
            const size_t column = k % STRIDE;
            in[i][k] = column < COLUMNS ? base[i][k / STRIDE * COLUMNS + column] : 9.0f;
            out[i][k] = 7.0f;
        }
    }
    const struct scarp_samples samples = base_of(ins);
    const struct scarp_eroded eroded = eroded_of(outs, OUT_ALL);
    for (int d = 0; d < 2; d++) {
        wide.step[d] =
            grid.step[d] / (descriptions[n].frequency != 0.0 ? descriptions[n].frequency : 1.0);
    }
    CHECK(scarp_gullies_grid2(&descriptions[n], &wide, &samples, &eroded) == SCARP_OK, "grid");
    poison(&here);
    for (int i = 0; i < OUTS; i++) {
        for (size_t k = 0; k < STRIDE * ROWS; k++) {
            const size_t column = k % STRIDE;
            if (column < COLUMNS) {
                here.of[i].f[1 + k / STRIDE * COLUMNS + column] = out[i][k];
            } else {
                CHECK(out[i][k] == 7.0f, "%s, gap %zu", out_names[i], k);
            }
        }
    }
    compare("grid", n, GRID, OUT_ALL, 0, COLUMNS * ROWS);
}

/* Displacements keep to their range; of flat ground they are the exposure, which reaches both ends.
 */
static void test_range(int n)
{
    const struct scarp_gullies *const g = &descriptions[n];
    float lowest = 0.0f, highest = 0.0f;
    CHECK(scarp_gullies_range(g, 0.0f, 0.0f, &lowest, &highest) == SCARP_OK, "range");
    poison(&here);
    CHECK(erode(g, DOUBLES, 0, POINTS, 1u << OUT_DISPLACEMENT, &here) == SCARP_OK, "%d", n);
    for (size_t i = 0; i < POINTS; i++) {
        const float d = here.of[OUT_DISPLACEMENT].f[i + 1];
        CHECK(d >= lowest && d <= highest, "description %d: %g", n, (double)d);
    }
}

static void test_flat(void)
{
    static const struct scarp_gullies g = {.amplitude = 3.0f, .depth = 0.5f, .floor = 1.0f};
    static const float heights[2] = {-3.0f, 3.0f}, zero = 0.0f;
    for (int i = 0; i < 2; i++) {
        float at = 0.3f, height = heights[i], none = zero, displaced, slope;
        float *const in[INS] = {&height, &none, &none, &none, &none, &none};
        const struct scarp_samples flat = base_of(in);
        const struct scarp_eroded out = {.displacement = &displaced, .displacement_dx = &slope};
        CHECK(scarp_gullies2(&g, 1, &at, &at, &flat, &out) == SCARP_OK, "flat");
        CHECK(fabsf(displaced) <= 1.5f && fabsf(displaced) > 1.49998f &&
                  (displaced > 0.0f) == (height > 0.0f) && slope == 0.0f,
              "%g displaced by %g, %g", (double)height, (double)displaced, (double)slope);
    }
}

/* A base with a period, and gullies with the same one, go on from tile to tile in all octaves. */
static void test_tiles(void)
{
    static const struct scarp_noise noise = {.seed = 2, .octaves = 2.0f, .period = {3, 2}};
    static const struct scarp_gullies g = {.octaves = 6.0f, .period = {3, 2}};
    static float in[2][INS][POINTS];
    static const double tile[2] = {3.0, -4.0};
    uint64_t random = 5;
    for (int i = 0; i < POINTS; i++) {
        for (int d = 0; d < 2; d++) {
            f64[d][i] = (double)check_random_float(&random, 4.0f);
        }
    }
    for (int t = 0; t < 2; t++) {
        float *ins[INS], *out[OUTS];
        for (int i = 0; i < INS; i++) {
            ins[i] = in[t][i];
            out[i] = (t == 0 ? &here : &there)->of[i].f + 1;
        }
        const struct scarp_samples samples = base_of(ins);
        const struct scarp_eroded eroded = eroded_of(out, OUT_ALL);
        poison(t == 0 ? &here : &there);
        CHECK(scarp_sample2_f64(&noise, POINTS, f64[0], f64[1], &samples) == SCARP_OK, "base");
        CHECK(scarp_gullies2_f64(&g, POINTS, f64[0], f64[1], &samples, &eroded) == SCARP_OK,
              "gullies");
        for (int i = 0; i < 2 * POINTS; i++) {
            f64[i % 2][i / 2] += tile[i % 2];
        }
    }
    compare("tiles", 0, DOUBLES, OUT_ALL, 0, POINTS);
}

/* A NaN in the base or in a coordinate is a NaN in every output that depends on it, of that point
   alone; outputs are finite where the square of the base's slope is not. An infinite value stays.
 */
static void test_special(enum scarp_isa isa)
{
    const struct scarp_gullies g = {.seed = 5};
    make_points(&g);
    f32[0][3] = NAN;
    f32[1][20] = INFINITY;
    base[IN_VALUE][40] = NAN;
    base[IN_DX][60] = NAN;
    base[IN_DXY][80] = NAN;
    base[IN_DX][100] = 1e25f;
    base[IN_DX][120] = INFINITY;
    base[IN_VALUE][140] = -INFINITY;
    poison(&there);
    scarp_isa_select(SCARP_ISA_SCALAR);
    CHECK(erode(&g, FLOATS, 0, POINTS, OUT_ALL, &there) == SCARP_OK, "reference");
    scarp_isa_select(isa);
    poison(&here);
    CHECK(erode(&g, FLOATS, 0, POINTS, OUT_ALL, &here) == SCARP_OK, "set");
    compare("special", 0, FLOATS, OUT_ALL, 0, POINTS);
    for (size_t i = 0; i < POINTS; i++) {
        const int bad = i == 3 || i == 20 || i == 40 || i == 60 || i == 120;
        for (int m = 0; m < OUTS; m++) {
            const int is_slope = m != OUT_VALUE && m != OUT_DISPLACEMENT;
            const float of = here.of[m].f[i + 1];
            CHECK((isnan(of) != 0) == (bad || (i == 80 && is_slope)), "%s of %zu: %g", out_names[m],
                  i, (double)of);
        }
    }
    for (int m = 0; m < OUTS; m++) {
        CHECK(isfinite(here.of[m].f[101]), "%s", out_names[m]);
        CHECK(m == OUT_VALUE ? here.of[m].f[141] == -INFINITY : isfinite(here.of[m].f[141]),
              "%s below all floors: %g", out_names[m], (double)here.of[m].f[141]);
    }
}

static void test_refused(void)
{
    static const struct {
        struct scarp_gullies g;
        const char *member;
        enum scarp_status status;
    } wrong[] = {
        {{.frequency = -1.0}, "frequency", SCARP_ERROR_PARAMETER},
        {{.frequency = 0x1p48, .cells = 2.0f}, "frequency", SCARP_ERROR_PARAMETER},
        {{.amplitude = -1.0f}, "amplitude", SCARP_ERROR_PARAMETER},
        {{.octaves = 33.0f}, "octaves", SCARP_ERROR_PARAMETER},
        {{.octaves = 3.0f, .of_octaves = 2.0f}, "of_octaves", SCARP_ERROR_PARAMETER},
        {{.lacunarity = 17.0f}, "lacunarity", SCARP_ERROR_PARAMETER},
        {{.gain = -1.0f}, "gain", SCARP_ERROR_PARAMETER},
        {{.depth = NAN}, "depth", SCARP_ERROR_PARAMETER},
        {{.cells = 65.0f}, "cells", SCARP_ERROR_PARAMETER},
        {{.slope = 33.0f}, "slope", SCARP_ERROR_PARAMETER},
        {{.slope_low = 0.03f}, "slope_low", SCARP_ERROR_PARAMETER},
        {{.low = -1025.0f}, "low", SCARP_ERROR_PARAMETER},
        {{.low = 1.0f}, "high", SCARP_ERROR_PARAMETER},
        {{.high = INFINITY}, "high", SCARP_ERROR_PARAMETER},
        {{.floor = 1.1f}, "floor", SCARP_ERROR_PARAMETER},
        {{.stripes = 8.5f}, "stripes", SCARP_ERROR_PARAMETER},
        {{.branch = -0.5f}, "branch", SCARP_ERROR_PARAMETER},
        {{.round = 0.003f}, "round", SCARP_ERROR_PARAMETER},
        {{.keep = 1.5f}, "keep", SCARP_ERROR_PARAMETER},
        {{.period = {3, 0}, .cells = 1.5f}, "period[0]", SCARP_ERROR_PARAMETER},
        {{.period = {0, 0x80000000u}}, "period[1]", SCARP_ERROR_PARAMETER},
        {{.period = {4, 0}, .rotate = 1}, "rotate", SCARP_ERROR_UNSUPPORTED},
        {{.period = {4, 0}, .lacunarity = 2.5f}, "lacunarity", SCARP_ERROR_PARAMETER},
        {{.spare = {[7] = 1}}, "spare", SCARP_ERROR_UNSUPPORTED},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const char *member = "";
        CHECK(scarp_gullies_check(&wrong[i].g, &member) == wrong[i].status && member != NULL &&
                  strcmp(member, wrong[i].member) == 0,
              "%s, not %s", wrong[i].member, member != NULL ? member : "nothing");
        poison(&here);
        CHECK(erode(&wrong[i].g, FLOATS, 0, 9, OUT_ALL, &here) == wrong[i].status, "%s",
              wrong[i].member);
        compare("refused", (int)i, FLOATS, 0, 0, 0);
    }
}

static void test_arguments(void)
{
    const struct scarp_gullies g = {.seed = 1};
    const struct scarp_samples in = base_from(0);
    struct scarp_samples less = in;
    float *out[OUTS];
    for (int i = 0; i < OUTS; i++) {
        out[i] = here.of[i].f + 1;
    }
    struct scarp_eroded all = eroded_of(out, OUT_ALL);
    const struct scarp_eroded values = eroded_of(out, OUT_VALUES);
    const struct scarp_eroded nothing = {.value = NULL};
    struct scarp_grid empty = grid;
    const float *const x = f32[0], *const y = f32[1];
    float lowest = 5.0f, highest = 5.0f;
    CHECK(scarp_gullies2(NULL, 0, NULL, NULL, NULL, NULL) == SCARP_OK, "no points");
    CHECK(scarp_gullies2(NULL, 1, x, y, &in, &all) == SCARP_ERROR_NULL, "no gullies");
    CHECK(scarp_gullies2(&g, 1, NULL, y, &in, &all) == SCARP_ERROR_NULL, "no x");
    CHECK(scarp_gullies2(&g, 1, x, NULL, &in, &all) == SCARP_ERROR_NULL, "no y");
    CHECK(scarp_gullies2(&g, 1, x, y, NULL, &all) == SCARP_ERROR_NULL, "no base");
    CHECK(scarp_gullies2(&g, 1, x, y, &in, NULL) == SCARP_ERROR_NULL, "no outputs");
    CHECK(scarp_gullies2(&g, 1, x, y, &in, &nothing) == SCARP_OK, "nothing asked for");
    CHECK(scarp_gullies2(&g, SIZE_MAX / 2, x, y, &in, &all) == SCARP_ERROR_SIZE, "size");
    less.dxy = NULL;
    CHECK(scarp_gullies2(&g, 1, x, y, &less, &all) == SCARP_ERROR_NULL, "no Hessian");
    CHECK(scarp_gullies2(&g, 1, x, y, &less, &values) == SCARP_OK, "values need none");
    less.dx = NULL;
    CHECK(scarp_gullies2(&g, 1, x, y, &less, &values) == SCARP_ERROR_NULL, "no gradient");
    less = in;
    less.spare[4] = base[0];
    CHECK(scarp_gullies2(&g, 1, x, y, &less, &all) == SCARP_ERROR_UNSUPPORTED, "spare");
    all.spare[9] = base[0];
    CHECK(scarp_gullies2(&g, 1, x, y, &in, &all) == SCARP_ERROR_UNSUPPORTED, "spare");
    empty.count[1] = 0;
    CHECK(scarp_gullies_grid2(&g, &empty, &in, &values) == SCARP_OK, "an empty grid");
    CHECK(scarp_gullies_grid2(&g, NULL, &in, &values) == SCARP_ERROR_NULL, "no grid");
    empty = grid;
    empty.row_stride = 3;
    CHECK(scarp_gullies_grid2(&g, &empty, &in, &values) == SCARP_ERROR_PARAMETER, "stride");
    empty = grid;
    empty.spare[0] = 1;
    CHECK(scarp_gullies_grid2(&g, &empty, &in, &values) == SCARP_ERROR_UNSUPPORTED, "spare");
    CHECK(scarp_gullies_check(NULL, NULL) == SCARP_ERROR_NULL, "no gullies");
    CHECK(scarp_gullies_check(&g, NULL) == SCARP_OK, "check");
    CHECK(scarp_gullies_range(&g, -1.0f, 0.5f, &lowest, &highest) == SCARP_OK && lowest == -1.25f &&
              highest == 0.75f,
          "%g to %g", (double)lowest, (double)highest);
    CHECK(scarp_gullies_range(NULL, 0.0f, 1.0f, &lowest, &highest) == SCARP_ERROR_NULL, "range");
    const float wrong[][2] = {{1.0f, 0.0f}, {NAN, 0.0f}, {0.0f, NAN}, {NAN, NAN}, {INFINITY, 1.0f}};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        lowest = 7.0f;
        highest = 8.0f;
        CHECK(scarp_gullies_range(&g, wrong[i][0], wrong[i][1], &lowest, &highest) ==
                      SCARP_ERROR_PARAMETER &&
                  lowest == 7.0f && highest == 8.0f,
              "a base in [%g, %g]", (double)wrong[i][0], (double)wrong[i][1]);
    }
    CHECK(scarp_gullies_range(&g, -INFINITY, 0.5f, &lowest, &highest) == SCARP_OK &&
              lowest == -INFINITY && highest == 0.75f,
          "a base without a lower end");
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    const enum scarp_isa isa = check_isa_argument(argc, argv);
    for (int n = 0; n < (int)DESCRIPTIONS && !check_enough(); n++) {
        make_points(&descriptions[n]);
        for (int kind = 0; kind < KINDS && !check_enough(); kind++) {
            test_bits(n, (enum kind)kind, isa);
        }
        test_grid(n);
        test_range(n);
        test_far(n, isa);
    }
    make_points(&descriptions[0]);
    for (int kind = 0; kind < KINDS && !check_enough(); kind++) {
        test_in_place(0, (enum kind)kind);
    }
    if (check_aim == CHECK_SAME) {
        test_flat();
        test_tiles();
        test_special(isa);
        test_arguments();
        test_refused();
    }
    return check_done();
}
