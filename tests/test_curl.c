/* SPDX-License-Identifier: MIT
 *
 * scarp_curl2 and its like: velocities are made of the potentials that scarp.h describes, have no
 * divergence and the Jacobian that differences show; all sets have the same bits, what is not asked
 * for changes nothing, and what is refused.
 *
 *     test_curl ISA
 *     test_curl --must-differ ISA   the same, but potentials or sets must differ: for mutants
 */
#include "curl.h"

#define OUTPUTS 10

/* The outputs of samples, with derivatives with respect to axis: first, then second. */
static const int first_of[3] = {1, 2, 3};
static const int second_of[3][3] = {{4, 5, 6}, {5, 7, 8}, {6, 8, 9}};

/* Samples the noise in the plane, the components of vector noise in space. */
static void sample_potentials(struct call c, const struct scarp_noise *noise, int has_jacobian,
                              float psi[3][OUTPUTS][POINTS])
{
    const int in_space = c.dimensions == 3;
    struct scarp_samples out[3];
    for (int i = 0; i < 3; i++) {
        out[i] = (struct scarp_samples){.dx = psi[i][1],
                                        .dy = psi[i][2],
                                        .dz = in_space ? psi[i][3] : NULL,
                                        .dxx = has_jacobian ? psi[i][4] : NULL,
                                        .dxy = has_jacobian ? psi[i][5] : NULL,
                                        .dxz = in_space && has_jacobian ? psi[i][6] : NULL,
                                        .dyy = has_jacobian ? psi[i][7] : NULL,
                                        .dyz = in_space && has_jacobian ? psi[i][8] : NULL,
                                        .dzz = in_space && has_jacobian ? psi[i][9] : NULL};
    }
    const enum scarp_status status =
        c.dimensions == 2 ? c.doubles ? scarp_sample2_f64(noise, POINTS, f64[0], f64[1], out)
                                      : scarp_sample2(noise, POINTS, f32[0], f32[1], out)
        : c.doubles ? scarp_vector3_f64(noise, POINTS, f64[0], f64[1], f64[2], out)
                          : scarp_vector3(noise, POINTS, f32[0], f32[1], f32[2], out);
    CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
}

/* Velocities are differences of what samples of the potentials give, to the bit. */
static void test_potentials(struct call c, int n)
{
    static float psi[3][OUTPUTS][POINTS];
    const struct scarp_noise noise = noises[n];
    const unsigned wanted = members_of(&noise, c.dimensions);
    const int has_jacobian = wanted == all_of(c.dimensions);
    find_all(c, &noise, &here);
    poison(&there);
    sample_potentials(c, &noise, has_jacobian, psi);
    for (int i = 0; i < c.dimensions; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        for (int m = -1; m < (has_jacobian ? c.dimensions : 0); m++) {
            float *const to = there.of[m < 0 ? VX + i : VXX + 3 * i + m].f + 1;
            const int dj = m < 0 ? first_of[j] : second_of[j][m];
            const int dk = m < 0 ? first_of[k] : second_of[k][m];
            const int dx = m < 0 ? first_of[0] : second_of[0][m];
            const int dy = m < 0 ? first_of[1] : second_of[1][m];
            for (size_t at = 0; at < POINTS; at++) {
                to[at] = c.dimensions == 3 ? psi[k][dj][at] - psi[j][dk][at]
                         : i == 0          ? psi[0][dy][at]
                                           : -psi[0][dx][at];
            }
        }
    }
    compare("potentials", n, wanted, 0, POINTS);
}

/* The set under test has the bits of the scalar one. */
static void test_bits(struct call c, int n, enum scarp_isa isa)
{
    const struct scarp_noise noise = noises[n];
    const unsigned wanted = members_of(&noise, c.dimensions);
    find_all(c, &noise, &here);
    CHECK(scarp_isa_select(SCARP_ISA_SCALAR) == SCARP_OK, "scalar");
    find_all(c, &noise, &there);
    CHECK(scarp_isa_select(isa) == SCARP_OK, "back");
    compare("scalar", n, wanted, 0, POINTS);
}

static double worst_divergence;

/* In the plane the trace is 0 in every bit; in space exactly computed at most 2^-24 of the
   magnitudes. The sum of floats is exact in double but for a rounding. */
static void test_divergence(struct call c, int n)
{
    const struct scarp_noise noise = noises[n];
    if (members_of(&noise, c.dimensions) != all_of(c.dimensions)) {
        return;
    }
    find_all(c, &noise, &here);
    for (size_t i = 0; i < POINTS; i++) {
        const double xx = (double)of(&here, VXX, i), yy = (double)of(&here, VYY, i);
        const double zz = c.dimensions == 3 ? (double)of(&here, VZZ, i) : 0.0;
        const double sum = fabs(xx + yy + zz), magnitudes = fabs(xx) + fabs(yy) + fabs(zz);
        CHECK(sum <= (c.dimensions == 3 ? 0x1.000001p-24 * magnitudes : 0.0),
              "noise %d: divergence %g of %g", n, sum, magnitudes);
        if (magnitudes > 0.0 && sum / magnitudes > worst_divergence) {
            worst_divergence = sum / magnitudes;
        }
    }
}

/* The Jacobian is what differences of velocities show. The points are multiples of the step. */
static void test_jacobian(struct call c, int n)
{
    static struct near before, after;
    struct scarp_noise coarse = noises[n];
    const struct scarp_noise *const noise = &coarse;
    const double step = 0x1p-9;
    double worst = 0.0, largest = 0.0;
    if (!c.doubles) {
        return;
    }
    coarse.frequency = 0.25;
    find_all(c, noise, &here);
    for (int m = 0; m < c.dimensions; m++) {
        for (size_t i = 0; i < POINTS; i++) {
            f64[m][i] -= step;
        }
        find_all(c, noise, &before);
        for (size_t i = 0; i < POINTS; i++) {
            f64[m][i] += 2.0 * step;
        }
        find_all(c, noise, &after);
        for (size_t i = 0; i < POINTS; i++) {
            f64[m][i] -= step;
        }
        for (int k = 0; k < c.dimensions * POINTS; k++) {
            const int row = k / POINTS;
            const size_t i = (size_t)k % POINTS;
            const double rise = (double)of(&after, row, i) - (double)of(&before, row, i);
            const double found = (double)of(&here, VXX + 3 * row + m, i);
            worst = larger(worst, fabs(rise / (2.0 * step) - found));
            largest = larger(largest, fabs(found));
        }
    }
    CHECK(worst < 0.01 * largest, "noise %d: Jacobian off by %g of %g", n, worst, largest);
}

/* Every choice of outputs, any number of points from any element on: the same bits, and nothing
   else is written. */
static void test_choices(struct call c, int n)
{
    const struct scarp_noise noise = noises[n];
    const unsigned all = members_of(&noise, c.dimensions);
    uint64_t state = 1;
    find_all(c, &noise, &here);
    for (size_t round = 0; round < 110; round++) {
        const unsigned random = (unsigned)check_random(&state);
        const unsigned wanted = round % 3 == 0   ? all
                                : round % 3 == 1 ? velocity_of(c.dimensions)
                                                 : all & random;
        const size_t first = (size_t)(check_random(&state) % 5);
        const size_t count =
            round <= 70 ? round : (size_t)(check_random(&state) % (POINTS - first + 1));
        const struct scarp_flow out = arrays(&there, wanted, first);
        size_t written = 0, expected = 0;
        poison(&there);
        CHECK(find(c, &noise, first, count, &out) == SCARP_OK, "%zu points", count);
        compare("choice", n, wanted, first, count);
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

/* Floats in place, whatever replaces the coordinates. */
static void test_in_place(struct call c, int n)
{
    static const int over[][3] = {{VX, VY, VZ}, {VY, VX, VXX}, {VYY, VXY, VX}, {VYX, VYY, VZY}};
    const struct scarp_noise noise = noises[n];
    const unsigned all = members_of(&noise, c.dimensions);
    find_all(c, &noise, &here);
    for (size_t way = 0; way < (all == all_of(c.dimensions) ? 4 : 1); way++) {
        const float *x[3] = {NULL, NULL, NULL};
        const struct scarp_flow out = arrays(&there, all, 0);
        poison(&there);
        for (int axis = 0; axis < c.dimensions; axis++) {
            x[axis] = memcpy(there.of[over[way][axis]].f + 1, f32[axis], sizeof f32[axis]);
        }
        CHECK((c.dimensions == 2 ? scarp_curl2(&noise, POINTS, x[0], x[1], &out)
                                 : scarp_curl3(&noise, POINTS, x[0], x[1], x[2], &out)) == SCARP_OK,
              "in place");
        compare("in place", n, all, 0, POINTS);
    }
}

/* A plan that the noise brings changes nothing. */
static void test_plan(struct call c, int n)
{
    static struct scarp_plan plan;
    struct scarp_noise noise = noises[n];
    find_all(c, &noise, &here);
    CHECK(scarp_plan_make(&noise, c.dimensions, &plan) == SCARP_OK, "plan");
    noise.plan = &plan;
    find_all(c, &noise, &there);
    compare("plan", n, members_of(&noise, c.dimensions), 0, POINTS);
}

/* Points that are nowhere, and far ones. */
static void test_special(struct call c, int n)
{
    const struct scarp_noise noise = noises[n];
    const unsigned all = members_of(&noise, c.dimensions);
    draw_special_points(c.dimensions);
    find_all(c, &noise, &here);
    for (size_t i = 0; i < POINTS; i++) {
        for (int m = 0; m < MEMBERS; m++) {
            const float found = of(&here, m, i);
            CHECK((all >> m & 1) == 0 || (i % 4 == 0 ? isnan(found) : isfinite(found)),
                  "noise %d: %s[%zu] is %g", n, names[m], i, (double)found);
        }
    }
}

/* The speed that scarp.h promises, in the mean of squares, to a percent. */
static void test_speed(struct call c)
{
    static const double speeds[2][2] = {{1.27, 2.98}, {1.66, 4.30}};
    for (int i = 0; i < 2; i++) {
        double squares = 0.0;
        for (int k = 0; k < 200; k++) {
            const struct scarp_noise noise = {.basis = i == 0 ? SCARP_GRADIENT : SCARP_SIMPLEX,
                                              .seed = (uint64_t)k};
            find_all(c, &noise, &here);
            for (size_t m = 0; m < (size_t)c.dimensions * POINTS; m++) {
                const double v = (double)of(&here, (int)(m / POINTS), m % POINTS);
                squares += v * v;
            }
        }
        const double speed = sqrt(squares / (200.0 * POINTS));
        CHECK(fabs(speed / speeds[c.dimensions - 2][i] - 1.0) < 0.01, "%dD: speed %g", c.dimensions,
              speed);
    }
}

static int is_untouched(const struct near *n)
{
    static struct near clean;
    poison(&clean);
    return memcmp(n, &clean, sizeof clean) == 0;
}

static void expect(struct call c, const struct scarp_noise *noise, const struct scarp_flow *out,
                   enum scarp_status wanted, const char *what)
{
    const enum scarp_status status = find(c, noise, 0, POINTS, out);
    CHECK(status == wanted, "%dD, %s: %s", c.dimensions, what, scarp_status_text(status));
}

/* Noise that has no Hessian, or whose warp has none. */
static void test_no_hessian(struct call c)
{
    const struct scarp_noise swiss = {.fractal = SCARP_SWISS};
    const struct scarp_noise without[] = {{.fractal = SCARP_EROSION},
                                          {.fractal = SCARP_SWISS},
                                          {.fractal = SCARP_JORDAN},
                                          {.warp = &swiss}};
    for (int i = 0; i < 4; i++) {
        for (int m = VXX; m < MEMBERS; m++) {
            const struct scarp_flow out = arrays(&there, 1u << VX | 1u << m, 0);
            expect(c, &without[i], &out, SCARP_ERROR_UNSUPPORTED, names[m]);
        }
    }
}

static void test_refused(struct call c)
{
    const struct scarp_noise good = {.seed = 1}, bad_warp = {.octaves = 99.0f};
    const struct scarp_noise bad[] = {{.basis = (enum scarp_basis)77},
                                      {.fractal = (enum scarp_fractal)77},
                                      {.octaves = 99.0f},
                                      {.frequency = -1.0},
                                      {.warp = &bad_warp},
                                      {.phase = 1.0f, .basis = SCARP_CELL_F1},
                                      {.gain = NAN},
                                      {.period = {3, 3, 3}, .rotate = 1, .octaves = 2.0f}};
    const size_t huge = (size_t)PTRDIFF_MAX / (c.doubles ? sizeof(double) : sizeof(float)) + 1;
    const struct scarp_flow all = arrays(&there, all_of(c.dimensions), 0);
    poison(&there);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const enum scarp_status wanted = scarp_noise_check(&bad[i], c.dimensions, NULL);
        CHECK(wanted != SCARP_OK, "noise %zu", i);
        expect(c, &bad[i], &all, wanted, "bad noise");
    }
    expect(c, NULL, &all, SCARP_ERROR_NULL, "no noise");
    expect(c, &good, NULL, SCARP_ERROR_NULL, "no outputs");
    CHECK(find(c, &good, 0, huge, &all) == SCARP_ERROR_SIZE, "%zu points", huge);
    CHECK(find(c, NULL, 0, 0, NULL) == SCARP_OK, "no points");
    CHECK(scarp_curl2(&good, 3, NULL, f32[1], &all) == SCARP_ERROR_NULL, "no x");
    CHECK(scarp_curl3(&good, 3, f32[0], f32[1], NULL, &all) == SCARP_ERROR_NULL, "no z");
    CHECK(scarp_curl3_f64(&good, 3, f64[0], NULL, f64[2], &all) == SCARP_ERROR_NULL, "no y");
    for (int i = 0; i < 4; i++) {
        struct scarp_flow out = arrays(&there, 1, 0);
        out.spare[i] = there.of[0].f;
        expect(c, &good, &out, SCARP_ERROR_UNSUPPORTED, "spare");
    }
    for (int m = 0; m < MEMBERS && c.dimensions == 2; m++) {
        const struct scarp_flow out = arrays(&there, 1u << VX | 1u << m, 0);
        if ((ALL2 >> m & 1) == 0) {
            expect(c, &good, &out, SCARP_ERROR_UNSUPPORTED, names[m]);
        }
    }
    test_no_hessian(c);
    CHECK(is_untouched(&there), "an error has written something");
    const struct scarp_flow nothing = {.vx = NULL};
    expect(c, &good, &nothing, SCARP_OK, "nothing asked for");
}

/* Compilers change no bit: a hash of the velocities and Jacobians of all noises, by call. */
static void test_golden(int call)
{
    static const uint64_t golden[CALLS] = {
        UINT64_C(0x4133d9fce0a9fee7), UINT64_C(0x7a8452086a1e8ae9), UINT64_C(0xbec2dc91e70c41d6),
        UINT64_C(0xc956b70f2bbb4e4e)};
    uint64_t hash = FNV_BASIS;
    for (int n = 0; n < NOISES; n++) {
        const struct scarp_noise noise = noises[n];
        const unsigned all = members_of(&noise, calls[call].dimensions);
        find_all(calls[call], &noise, &here);
        for (int k = 0; k < MEMBERS * POINTS; k++) {
            const uint32_t bits = bits_of(&here, k / POINTS, (size_t)k % POINTS);
            for (int byte = 0; (all >> k / POINTS & 1) != 0 && byte < 4; byte++) {
                hash = fnv_byte(hash, bits >> 8 * byte & 0xff);
            }
        }
    }
    CHECK_BITS(hash == golden[call], "call %d: %#llx", call, (unsigned long long)hash);
}

/* What a mistake in a kernel changes. */
static void test_results(int call, enum scarp_isa isa)
{
    for (int n = 0; n < NOISES && !check_enough(); n++) {
        test_potentials(calls[call], n);
        test_bits(calls[call], n, isa);
        test_choices(calls[call], n);
        if (!calls[call].doubles) {
            test_in_place(calls[call], n);
        }
    }
    if (!check_enough()) {
        test_golden(call);
    }
}

static void test_promises(struct call c)
{
    for (int n = 0; n < NOISES; n++) {
        draw_points(16.0f);
        test_divergence(c, n);
        test_plan(c, n);
        test_special(c, n);
    }
    draw_points(16.0f);
    test_jacobian(c, 0);
    test_jacobian(c, 6);
    test_jacobian(c, 15);
    draw_points(256.0f);
    test_speed(c);
    test_refused(c);
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    const enum scarp_isa isa = check_select_isa(argc > 1 ? argv[1] : "scalar");
    for (int i = 0; i < CALLS && !check_enough(); i++) {
        draw_points(16.0f);
        test_results(i, isa);
        if (check_aim == CHECK_SAME) {
            test_promises(calls[i]);
        }
    }
    printf("divergence at most %g of the magnitudes\n", worst_divergence);
    return check_done();
}
