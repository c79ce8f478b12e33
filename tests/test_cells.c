/* SPDX-License-Identifier: MIT
 *
 * scarp_cells2 and its like: what they give fits together and with the noise, all sets have the
 * same bits, what is not asked for changes nothing, and what is refused.
 *
 *     test_cells ISA
 */
#define POINTS 257
#define MEMBERS 12
#include "near.h"

static const char *const names[MEMBERS] = {"f1",  "f2",  "id",  "x",   "y",   "z",
                                           "dx1", "dy1", "dz1", "dx2", "dy2", "dz2"};
enum { F1, F2, ID, X, Y, Z, DX1, DY1, DZ1, DX2, DY2, DZ2 };

static unsigned all_of(int dimensions)
{
    return dimensions == 3 ? 0xfffu : 0xfffu & ~(1u << Z | 1u << DZ1 | 1u << DZ2);
}

/* The arrays of the members in `wanted`, from element `first` on. */
static struct scarp_cells arrays(struct near *n, unsigned wanted, size_t first)
{
    float *at[MEMBERS];
    arrays_at(n, wanted, first, at);
    const struct scarp_cells out = {.f1 = at[F1],
                                    .f2 = at[F2],
                                    .id = at[ID] != NULL ? n->of[ID].u + 1 + first : NULL,
                                    .x = at[X],
                                    .y = at[Y],
                                    .z = at[Z],
                                    .dx1 = at[DX1],
                                    .dy1 = at[DY1],
                                    .dz1 = at[DZ1],
                                    .dx2 = at[DX2],
                                    .dy2 = at[DY2],
                                    .dz2 = at[DZ2]};
    return out;
}

static enum scarp_status find(struct call c, const struct scarp_noise *noise, size_t first,
                              size_t count, const struct scarp_cells *out)
{
    return FIND(c, noise, first, count, out, scarp_cells);
}

static void find_all(struct call c, const struct scarp_noise *noise, struct near *to)
{
    const struct scarp_cells out = arrays(to, all_of(c.dimensions), 0);
    poison(to);
    CHECK(find(c, noise, 0, POINTS, &out) == SCARP_OK, "%dD", c.dimensions);
}

static double coordinate(struct call c, int axis, size_t i)
{
    return c.doubles ? f64[axis][i] : (double)f32[axis][i];
}

/* How far point i is from the feature that point j found. */
static double distance(struct call c, size_t i, size_t j)
{
    double squares = 0.0;
    for (int axis = 0; axis < c.dimensions; axis++) {
        const double d = coordinate(c, axis, i) - (double)of(&here, X + axis, j);
        squares += d * d;
    }
    return sqrt(squares);
}

/* Points that are close together find each feature many times. Each is where F1 says, in the
   direction of the gradient; no feature that another point found is nearer, none but the first is
   nearer than F2; and some point has the second. Features have an id each. */
static void test_consistent(struct call c, const struct scarp_noise *noise)
{
    const double cell = 1.0 / (noise->frequency == 0.0 ? 1.0 : noise->frequency);
    const double slack = 4e-6 * cell;
    int seconds = 0;
    find_all(c, noise, &here);
    for (size_t i = 0; i < POINTS; i++) {
        const double first = (double)of(&here, F1, i), second = (double)of(&here, F2, i);
        double nearest = HUGE_VAL;
        CHECK(first >= 0.0 && first <= second, "F1 %g, F2 %g", first, second);
        CHECK(fabs(distance(c, i, i) - first) <= slack, "F1 %g, not %g", first, distance(c, i, i));
        for (int axis = 0; axis < c.dimensions; axis++) {
            const double along = coordinate(c, axis, i) - (double)of(&here, X + axis, i);
            CHECK(fabs(along - first * (double)of(&here, DX1 + axis, i)) <= slack, "gradient");
        }
        for (size_t j = 0; j < POINTS; j++) {
            const int same = word_of(&here, ID, i) == word_of(&here, ID, j);
            const double d = distance(c, i, j);
            if (same) {
                CHECK(fabs(d - first) <= slack, "id %08x is in two places", word_of(&here, ID, i));
            } else if (d < nearest) {
                nearest = d;
            }
        }
        CHECK(nearest >= second - slack, "a feature %g off, and F2 is %g", nearest, second);
        seconds += nearest <= second + slack;
    }
    CHECK(seconds > POINTS / 2, "F2 was seen %d times", seconds);
}

/* Second gradients are unit vectors, along which F2 grows. */
static void test_second_gradient(struct call c, const struct scarp_noise *noise)
{
    const double step = 0x1p-8;
    int good = 0;
    find_all(c, noise, &here);
    for (size_t i = 0; i < POINTS; i++) {
        double squares = 0.0;
        for (int axis = 0; axis < c.dimensions; axis++) {
            const float g = of(&here, DX2 + axis, i);
            squares += (double)g * (double)g;
            f64[axis][i] += step * (double)g;
            f32[axis][i] = (float)f64[axis][i];
        }
        CHECK(fabs(squares - 1.0) < 1e-5, "|grad F2|^2 is %g", squares);
    }
    find_all(c, noise, &there);
    for (size_t i = 0; i < POINTS; i++) {
        const double grown = (double)of(&there, F2, i) - (double)of(&here, F2, i);
        CHECK(grown <= step * 1.001, "F2 grows by %g", grown);
        good += grown >= step * 0.999;
    }
    CHECK(good > POINTS * 9 / 10, "F2 grows along %d gradients", good);
}

/* The raw value of a basis, from n_k and the supremum of scarp.h. */
static double raw_value(enum scarp_basis basis, double n, int dimensions)
{
    const double corner = sqrt((double)dimensions);
    const double supremum = basis == SCARP_CELL_F1 || dimensions == 3 ? corner : sqrt(2.5);
    return (n / (1.0 - 0x1p-17) + 1.0) * supremum / 2.0;
}

/* The bases are made of the same features. */
static void test_bases(struct call c)
{
    static float value[POINTS], slope[3][POINTS];
    struct scarp_noise noise = {.seed = 9, .frequency = 1.5};
    find_all(c, &noise, &here);
    for (int basis = SCARP_CELL_F1; basis <= SCARP_CELL_VALUE; basis++) {
        const struct scarp_samples out = {.value = value,
                                          .dx = slope[0],
                                          .dy = slope[1],
                                          .dz = c.dimensions == 3 ? slope[2] : NULL};
        noise.basis = (enum scarp_basis)basis;
        const enum scarp_status status =
            c.dimensions == 2 ? c.doubles ? scarp_sample2_f64(&noise, POINTS, f64[0], f64[1], &out)
                                          : scarp_sample2(&noise, POINTS, f32[0], f32[1], &out)
            : c.doubles ? scarp_sample3_f64(&noise, POINTS, f64[0], f64[1], f64[2], &out)
                              : scarp_sample3(&noise, POINTS, f32[0], f32[1], f32[2], &out);
        CHECK(status == SCARP_OK, "basis %d", basis);
        for (size_t i = 0; i < POINTS; i++) {
            const double first = (double)of(&here, F1, i), second = (double)of(&here, F2, i);
            const double raw = raw_value(noise.basis, (double)value[i], c.dimensions) / 1.5;
            const double wanted = basis == SCARP_CELL_F1     ? first
                                  : basis == SCARP_CELL_F2   ? second
                                  : basis == SCARP_CELL_EDGE ? second - first
                                                             : raw;
            const double drawn = (double)(int32_t)word_of(&here, ID, i) * 0x1p-31;
            CHECK(fabs(raw - wanted) < 1e-6, "basis %d: %g, not %g", basis, raw, wanted);
            if (basis == SCARP_CELL_VALUE) {
                CHECK(fabs((double)value[i] - drawn) < 1e-5, "%g, not %g", (double)value[i], drawn);
                CHECK(slope[0][i] == 0.0f && slope[1][i] == 0.0f, "a slope");
            }
            if (basis == SCARP_CELL_F1) {
                const double scale = 2.0 * (1.0 - 0x1p-17) * 1.5 / sqrt((double)c.dimensions);
                const double wrong = (double)slope[0][i] - scale * (double)of(&here, DX1, i);
                CHECK(fabs(wrong) < 1e-5, "gradient of F1 off by %g", wrong);
            }
        }
    }
}

static int same_bits(const struct near *a, const struct near *b, unsigned wanted, size_t first,
                     size_t count)
{
    for (int m = 0; m < MEMBERS; m++) {
        for (size_t i = first; (wanted >> m & 1) != 0 && i < first + count; i++) {
            if (word_of(a, m, i) != word_of(b, m, i)) {
                printf("%s[%zu]: %08x, not %08x\n", names[m], i, word_of(a, m, i),
                       word_of(b, m, i));
                return 0;
            }
        }
    }
    return 1;
}

/* Every choice of outputs, any number of points from any element on: the same bits, and nothing
   else is written. */
static void test_choices(struct call c)
{
    const struct scarp_noise noise = {.seed = 4};
    uint64_t state = 1;
    find_all(c, &noise, &here);
    for (int round = 0; round < 400; round++) {
        const unsigned wanted = all_of(c.dimensions) & (unsigned)check_random(&state);
        const size_t first = (size_t)(check_random(&state) % 5);
        const size_t count = (size_t)(check_random(&state) % (round % 2 ? 40 : POINTS - first));
        const struct scarp_cells out = arrays(&there, wanted, first);
        size_t written = 0, expected = 0;
        poison(&there);
        CHECK(find(c, &noise, first, count, &out) == SCARP_OK, "%zu points", count);
        CHECK(same_bits(&there, &here, wanted, first, count), "members %x, %zu points", wanted,
              count);
        for (int m = 0; m < MEMBERS; m++) {
            expected += (wanted >> m & 1) != 0 ? count : 0;
            for (int i = 0; i < POINTS + 2; i++) {
                written += there.of[m].u[i] != POISON;
            }
        }
        CHECK(written == expected, "members %x: %zu words written, not %zu", wanted, written,
              expected);
    }
}

/* Floats in place. */
static void test_in_place(struct call c)
{
    static float x[3][POINTS];
    const struct scarp_noise noise = {.seed = 4};
    struct scarp_cells out = {.x = x[0], .y = x[1], .f2 = c.dimensions == 3 ? x[2] : NULL};
    find_all(c, &noise, &here);
    memcpy(x, f32, sizeof x);
    CHECK((c.dimensions == 2 ? scarp_cells2(&noise, POINTS, x[0], x[1], &out)
                             : scarp_cells3(&noise, POINTS, x[0], x[1], x[2], &out)) == SCARP_OK,
          "in place");
    CHECK(memcmp(x[0], here.of[X].f + 1, sizeof x[0]) == 0, "x in place");
    CHECK(memcmp(x[1], here.of[Y].f + 1, sizeof x[1]) == 0, "y in place");
    CHECK(c.dimensions == 2 || memcmp(x[2], here.of[F2].f + 1, sizeof x[2]) == 0, "z in place");
}

/* Members that the first octave does not depend on. */
static void test_other_members(struct call c)
{
    const struct scarp_noise noise = {.seed = 11, .frequency = 0.7, .jitter = 0.6f};
    find_all(c, &noise, &here);
    for (int basis = 0; scarp_basis_name((enum scarp_basis)basis) != NULL; basis++) {
        struct scarp_plan plan;
        struct scarp_noise other = {.seed = 11,
                                    .frequency = 0.7,
                                    .jitter = 0.6f,
                                    .basis = (enum scarp_basis)basis,
                                    .fade = SCARP_CUBIC,
                                    .fractal = (enum scarp_fractal)(basis % 4),
                                    .rotate = 1,
                                    .octaves = 3.5f,
                                    .lacunarity = 3.0f,
                                    .amplitude = 7.0f,
                                    .phase = basis == SCARP_GRADIENT ? 0.3f : 0.0f};
        find_all(c, &other, &there);
        CHECK(same_bits(&there, &here, all_of(c.dimensions), 0, POINTS), "basis %d", basis);
        CHECK(scarp_plan_make(&other, c.dimensions, &plan) == SCARP_OK, "no plan");
        other.plan = &plan;
        find_all(c, &other, &there);
        CHECK(same_bits(&there, &here, all_of(c.dimensions), 0, POINTS), "plan of %d", basis);
    }
    for (int i = 0; i < 3; i++) {
        struct scarp_noise other = noise;
        other.seed += i == 0;
        other.frequency += i == 1 ? 0.01 : 0.0;
        other.jitter += i == 2 ? 0.01f : 0.0f;
        find_all(c, &other, &there);
        CHECK(memcmp(&here.of[F1], &there.of[F1], sizeof here.of[F1]) != 0, "member %d", i);
    }
}

/* Points whose fractions stay when whole cells are added. */
static void make_coarse_points(void)
{
    draw_points(4.0f);
    for (int i = 0; i < 3 * POINTS; i++) {
        f64[i % 3][i / 3] = floor(f64[i % 3][i / 3] * 0x1p12) * 0x1p-12;
        f32[i % 3][i / 3] = (float)f64[i % 3][i / 3];
    }
}

/* All that is not a position repeats; periods of 1 and 2 are shorter than a search. */
static void test_periods(struct call c)
{
    static const uint32_t periods[] = {1, 2, 3, 5, 8, 37};
    const unsigned wanted = all_of(c.dimensions) & ~(1u << X | 1u << Y | 1u << Z);
    for (int i = 0; i < 6 * 3; i++) {
        struct scarp_noise noise = {.seed = 3};
        const int axis = i % 3;
        noise.period[axis] = periods[i / 3];
        noise.period[(axis + 1) % 3] = i % 2 ? 4 : 0;
        if (axis >= c.dimensions) {
            continue;
        }
        make_coarse_points();
        find_all(c, &noise, &here);
        for (int k = 0; k < POINTS; k++) {
            f64[axis][k] += (double)periods[i / 3] * (double)(k % 5 - 2);
            f32[axis][k] = (float)f64[axis][k];
        }
        find_all(c, &noise, &there);
        CHECK(same_bits(&here, &there, wanted, 0, POINTS), "period %u along axis %d",
              periods[i / 3], axis);
    }
    draw_points(4.0f);
}

/* Points that are nowhere, and far ones. */
static void test_special(struct call c)
{
    const struct scarp_noise noise = {.seed = 3};
    draw_special_points(c.dimensions);
    find_all(c, &noise, &here);
    for (size_t i = 0; i < POINTS; i++) {
        for (int m = 0; m < MEMBERS; m++) {
            const float found = of(&here, m, i);
            if ((all_of(c.dimensions) >> m & 1) == 0) {
                continue;
            }
            if (i % 4 == 0) {
                CHECK(m == ID ? word_of(&here, ID, i) == 0 : isnan(found), "%s[%zu] is %g",
                      names[m], i, (double)found);
            } else if (m != ID) {
                CHECK(isfinite(found), "%s[%zu] is %g", names[m], i, (double)found);
            }
        }
    }
    draw_points(4.0f);
}

static int is_untouched(const struct near *n)
{
    struct near clean;
    poison(&clean);
    return memcmp(n, &clean, sizeof clean) == 0;
}

static void test_refused(struct call c)
{
    const struct scarp_noise good = {.seed = 1};
    const struct scarp_noise loop = {.warp = &loop};
    const struct scarp_noise bad[] = {{.basis = (enum scarp_basis)77},
                                      {.fractal = (enum scarp_fractal)99},
                                      {.jitter = 1.5f},
                                      {.jitter = -0.5f},
                                      {.jitter = NAN},
                                      {.octaves = 99.f},
                                      {.frequency = -1},
                                      {.warp = &loop},
                                      {.of_octaves = 0.5f},
                                      {.phase = NAN},
                                      {.phase = 1.0f, .basis = SCARP_CELL_F1}};
    const size_t huge = (size_t)PTRDIFF_MAX / (c.doubles ? sizeof(double) : sizeof(float)) + 1;
    struct scarp_cells out = arrays(&there, all_of(c.dimensions), 0);
    poison(&there);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const enum scarp_status wanted = scarp_noise_check(&bad[i], c.dimensions, NULL);
        CHECK(wanted != SCARP_OK && find(c, &bad[i], 0, POINTS, &out) == wanted, "noise %zu", i);
    }
    CHECK(find(c, NULL, 0, POINTS, &out) == SCARP_ERROR_NULL, "no noise");
    CHECK(find(c, &good, 0, POINTS, NULL) == SCARP_ERROR_NULL, "no outputs");
    CHECK(find(c, &good, 0, huge, &out) == SCARP_ERROR_SIZE, "%zu points", huge);
    CHECK(find(c, NULL, 0, 0, NULL) == SCARP_OK, "no points");
    CHECK(scarp_cells2(&good, 3, NULL, f32[1], &out) == SCARP_ERROR_NULL, "no x");
    CHECK(scarp_cells3(&good, 3, f32[0], f32[1], NULL, &out) == SCARP_ERROR_NULL, "no z");
    CHECK(scarp_cells3_f64(&good, 3, f64[0], NULL, f64[2], &out) == SCARP_ERROR_NULL, "no y");
    for (int i = 0; i < 4; i++) {
        out = arrays(&there, 1, 0);
        out.spare[i] = there.of[0].f;
        CHECK(find(c, &good, 0, POINTS, &out) == SCARP_ERROR_UNSUPPORTED, "spare[%d]", i);
    }
    static const int along_z[] = {Z, DZ1, DZ2};
    for (int i = 0; i < 3 && c.dimensions == 2; i++) {
        out = arrays(&there, 1u | 1u << along_z[i], 0);
        CHECK(find(c, &good, 0, POINTS, &out) == SCARP_ERROR_UNSUPPORTED, "%s", names[along_z[i]]);
    }
    CHECK(is_untouched(&there), "an error has written something");
}

/* The set under test has the bits of the scalar one. */
static void test_bits(struct call c, enum scarp_isa isa)
{
    for (int i = 0; i < 60; i++) {
        struct scarp_noise noise = {.seed = (uint64_t)i,
                                    .frequency = i % 2 ? 0.37 : 5.0,
                                    .jitter = i % 3 ? 0.0f : 0.3f,
                                    .offset_first = (uint32_t)i / 2 % 2};
        noise.period[i % 3] = i % 4 == 0 ? 1 + (uint32_t)i / 4 : 0;
        draw_points((float)(1 << (i % 20)));
        find_all(c, &noise, &here);
        CHECK(scarp_isa_select(SCARP_ISA_SCALAR) == SCARP_OK, "scalar");
        find_all(c, &noise, &there);
        CHECK(scarp_isa_select(isa) == SCARP_OK, "back");
        CHECK(same_bits(&here, &there, all_of(c.dimensions), 0, POINTS), "%dD, noise %d",
              c.dimensions, i);
    }
    draw_points(4.0f);
}

int main(int argc, char **argv)
{
    const enum scarp_isa isa = check_select_isa(argc > 1 ? argv[1] : "scalar");
    for (int i = 0; i < CALLS; i++) {
        const struct scarp_noise unit = {.seed = 2}, fine = {.seed = 7, .frequency = 16.0},
                                 tame = {.seed = 3, .jitter = 0.25f};
        draw_points(1.0f);
        test_consistent(calls[i], &unit);
        test_consistent(calls[i], &tame);
        draw_points(0.0625f);
        test_consistent(calls[i], &fine);
        draw_points(4.0f);
        test_second_gradient(calls[i], &unit);
        draw_points(4.0f);
        test_bases(calls[i]);
        test_choices(calls[i]);
        test_other_members(calls[i]);
        test_periods(calls[i]);
        test_special(calls[i]);
        test_refused(calls[i]);
        test_bits(calls[i], isa);
        if (!calls[i].doubles) {
            test_in_place(calls[i]);
        }
    }
    return check_done();
}
