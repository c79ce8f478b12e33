/* SPDX-License-Identifier: MIT
 *
 * Tests how gradients turn with a phase (scarp.h, "Flow"): the cosines and sines of all octaves
 * against libm's, the directions against the header's words, and that noise is the same along all
 * axes at every phase, as far as moments of the directions show. Argument: the number of random
 * phases.
 */
#include "../src/plan/phase.h"
#include "../src/scalar/sample.h"

#include "../src/formulas/basis.h"
#include "check.h"

#define TAU 6.283185307179586476925286766559005768L
#define TURN_MIN 0x1p-60 /* of src/plan/phase.c: what is smaller becomes 0 */

static struct scarp_octave octaves[SCARP_MAX_OCTAVES];

static void set_phase(float phase, struct scarp_octave octave[SCARP_MAX_OCTAVES])
{
    for (int k = 0; k < SCARP_MAX_OCTAVES; k++) {
        octave[k].amplitude = 1.0f + 0.125f * (float)k;
    }
    scarpi_phase_set(octave, SCARP_MAX_OCTAVES, phase);
}

/* The cosine and the sine of t turns, t in [0, 1), with both small where they are small. */
static void reference(double t, long double of[2])
{
    const int quarter = (int)(4.0 * t + 0.5);
    const long double angle = TAU * (long double)(t - 0.25 * (double)quarter); /* t - is exact */
    const long double c = cosl(angle), s = sinl(angle);
    const long double turned[4][2] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};
    of[0] = turned[quarter % 4][0];
    of[1] = turned[quarter % 4][1];
}

/* A float is right if it is the nearest or nearly so. The sum of a rounding, 2^-25 below 1 and
   2^-24 of itself, and of the error of double arithmetic is allowed. */
static void check_entry(float entry, long double exact, float phase, int octave, int i)
{
    const long double magnitude = fabsl(exact), error = fabsl((long double)entry - exact);
    if (magnitude < TURN_MIN * 0.9999999L) {
        CHECK(entry == 0.0f && !signbit(entry), "phase %a, octave %d, entry %d: %a, not 0",
              (double)phase, octave, i, (double)entry);
    } else if (magnitude > TURN_MIN * 1.0000001L) {
        CHECK(error <= 0x1.00001p-25L && error <= magnitude * 0x1.00001p-24L,
              "phase %a, octave %d, entry %d: %a is %La off", (double)phase, octave, i,
              (double)entry, error);
    }
    CHECK(entry == 0.0f || fabsf(entry) >= (float)TURN_MIN, "phase %a, octave %d, entry %d: %a",
          (double)phase, octave, i, (double)entry);
}

/* Whether the octaves have the same turns, to the bit; those of `b` with sines times `sign`. */
static int same_turns(const struct scarp_octave *a, const struct scarp_octave *b, float sign)
{
    int same = 1;
    for (int k = 0; k < SCARP_MAX_OCTAVES; k++) {
        float turn[4];
        for (int i = 0; i < 4; i++) {
            const float entry = b[k].turn[i];
            turn[i] = i % 2 == 1 && entry != 0.0f ? sign * entry : entry;
        }
        same = same && memcmp(turn, a[k].turn, sizeof turn) == 0;
    }
    return same;
}

/* Checks all octaves of a phase, and that a phase a turn later, and with the other sign, is what it
   should be. */
static void check_phase(float phase)
{
    static struct scarp_octave others[SCARP_MAX_OCTAVES];
    const double magnitude = fabs((double)phase);
    set_phase(phase, octaves);
    for (int k = 0; k < SCARP_MAX_OCTAVES; k++) {
        for (int i = 0; i < 2; i++) {
            long double of[2];
            reference(fmod(ldexp(magnitude, k + i), 1.0), of); /* no operation rounds */
            check_entry(octaves[k].turn[2 * i], of[0], phase, k, 2 * i);
            check_entry(octaves[k].turn[2 * i + 1], phase < 0.0f ? -of[1] : of[1], phase, k,
                        2 * i + 1);
        }
        const double slope = ldexp((double)TAU, k) * (1.0 + 0.125 * (double)k);
        const double found = (double)scarpi_phase_slope(&octaves[k], k);
        CHECK(fabs(found - slope) <= slope * 0x1.00001p-23, "octave %d: slope %.9g, not %.17g", k,
              found, slope); /* 2 pi and the product are rounded */
    }
    set_phase(-phase, others);
    CHECK(same_turns(octaves, others, -1.0f), "phases %a and %a differ in more than the sense",
          (double)phase, (double)-phase);
    const double later = (double)phase + 1.0;
    if ((double)(float)later == later && later - 1.0 == (double)phase) {
        set_phase((float)later, others);
        CHECK(same_turns(octaves, others, 1.0f), "phases %a and %a differ", (double)phase, later);
    }
}

/* Multiples of 1/4 in some octave: what is left is one of four turns, exactly. */
static void check_quarters(void)
{
    static const float turns[4][2] = {{1.0f, 0.0f}, {0.0f, 1.0f}, {-1.0f, 0.0f}, {0.0f, -1.0f}};
    for (int k = 0; k < SCARP_MAX_OCTAVES; k++) {
        for (int quarter = -40; quarter <= 40; quarter++) {
            const float phase = ldexpf((float)quarter, -2 - k);
            set_phase(phase, octaves);
            const int once = (quarter + 40) % 4, twice = (2 * quarter + 80) % 4;
            CHECK(memcmp(&octaves[k].turn[0], turns[once], sizeof turns[0]) == 0 &&
                      memcmp(&octaves[k].turn[2], turns[twice], sizeof turns[0]) == 0,
                  "octave %d, phase %d / 2^%d: (%g, %g), (%g, %g)", k, quarter, k + 2,
                  (double)octaves[k].turn[0], (double)octaves[k].turn[1],
                  (double)octaves[k].turn[2], (double)octaves[k].turn[3]);
            check_phase(phase);
        }
    }
}

static void check_phases(long count)
{
    static const float special[] = {
        0.0f,          -0.0f,    FLT_MIN,        FLT_TRUE_MIN,  FLT_MAX,         0x1.fffffep-1f,
        0x1p23f,       0x1p24f,  8388607.5f,     8388606.5f,    4194303.75f,     0x1p-24f,
        0x1p-60f,      0x1p-61f, 0x1p-62f,       0x1p-63f,      0x1p-64f,        0x1.8p-63f,
        0x1p-100f,     0.125f,   0.375f,         0.625f,        0.875f,          0.1f,
        15.0f / 64.0f, 0x1p-1f,  0x1.fffffep-2f, 0x1p31f,       0x1.fffffep+22f, 0x1.fffffcp-127f,
        0x1.000002p0f, 1e-7f,    2147483520.0f,  4294967040.0f, 0x1.fffffep-3f,  0x1.000002p-3f,
    };
    for (size_t i = 0; i < sizeof special / sizeof special[0]; i++) {
        check_phase(special[i]);
        check_phase(-special[i]);
    }
    uint64_t random = 1;
    for (long i = 0; i < count; i++) {
        const uint32_t bits = (uint32_t)(check_random(&random) >> 32);
        float any;
        memcpy(&any, &bits, sizeof any);
        check_phase(isfinite(any) ? any : 0.3f);
        check_phase(check_random_float(&random, 1.0f));
        check_phase(check_random_float(&random, 64.0f));
    }
}

static int direction_count(int dimensions)
{
    return dimensions == 2 ? 16 : 12;
}

/* Direction i of the lattice. */
static void direction_of(int dimensions, const float turn[4], int i, double g[3])
{
    const uint32_t index = (uint32_t)i;
    const uint32_t half = (index * 65536u + 11u) / 12u; /* the first that draws this edge */
    const vec4 t = {turn[0], turn[1], turn[2], turn[3]};
    const vec3 d = dimensions == 2 ? turned2(direction_index2(index << 28), t)
                                   : turned3(direction_index3(half << 16), t);
    g[0] = (double)d.x;
    g[1] = (double)d.y;
    g[2] = (double)d.z;
}

/* What the header says of direction g without a phase: its speed, and itself a quarter of a turn
   later. */
static double header_speed(int dimensions, const double g[3], double quarter[3])
{
    static const double diagonals[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    static const double edges[4][3][3] = {{{1, -1, 0}, {-1, 0, 1}, {0, 1, -1}},
                                          {{1, 1, 0}, {-1, 0, -1}, {0, -1, 1}},
                                          {{-1, -1, 0}, {1, 0, -1}, {0, 1, 1}},
                                          {{-1, 1, 0}, {1, 0, 1}, {0, -1, -1}}};
    quarter[2] = 0.0;
    if (dimensions == 2) {
        const double degrees = atan2(g[1], g[0]) * (360.0 / (double)TAU);
        const long number = lround((degrees - 11.25) / 22.5);
        CHECK(fabs(degrees - 11.25 - 22.5 * (double)number) <= 1e-5, "a direction at %.9g degrees",
              degrees);
        quarter[0] = -g[1];
        quarter[1] = g[0];
        return number % 2 == 0 ? 1.0 : -2.0;
    }
    for (int i = 0; i < 12; i++) {
        const double *const d = diagonals[i / 3], *const e = edges[i / 3][i % 3];
        if (g[0] == 2.0 * e[0] && g[1] == 2.0 * e[1] && g[2] == 2.0 * e[2]) {
            for (int axis = 0; axis < 3; axis++) {
                const int next = (axis + 1) % 3, last = (axis + 2) % 3;
                quarter[axis] = (d[next] * g[last] - d[last] * g[next]) / sqrt(3.0);
            }
            return i < 6 ? 1.0 : 2.0;
        }
    }
    CHECK(0, "(%g, %g, %g) is no edge of scarp.h", g[0], g[1], g[2]);
    return 0.0;
}

/* Directions turn with the phase as the header says, and so do their derivatives. */
static void check_directions(int dimensions, float phase)
{
    static const float still[4] = {1.0f, 0.0f, 1.0f, 0.0f};
    float derivative[4];
    set_phase(phase, octaves);
    scarpi_phase_derivative(derivative, octaves[0].turn);
    for (int i = 0; i < direction_count(dimensions); i++) {
        double g[3], quarter[3], turned[3], slope[3];
        direction_of(dimensions, still, i, g);
        direction_of(dimensions, octaves[0].turn, i, turned);
        direction_of(dimensions, derivative, i, slope);
        const double speed = header_speed(dimensions, g, quarter);
        const double angle = (double)TAU * speed * (double)phase;
        for (int axis = 0; axis < 3; axis++) {
            const double expected = cos(angle) * g[axis] + sin(angle) * quarter[axis];
            const double change = speed * (cos(angle) * quarter[axis] - sin(angle) * g[axis]);
            CHECK(fabs(turned[axis] - expected) <= 1e-6, "%dD phase %g, direction %d: %g, not %g",
                  dimensions, (double)phase, i, turned[axis], expected);
            CHECK(fabs(slope[axis] - change) <= 2e-6, "%dD phase %g, derivative %d: %g, not %g",
                  dimensions, (double)phase, i, slope[axis], change);
        }
    }
}

/* Without a phase, and after whole turns, directions are those of noise that stands still. */
static void check_still(int dimensions, float phase)
{
    set_phase(phase, octaves);
    for (int k = 0; k < SCARP_MAX_OCTAVES; k++) {
        for (int i = 0; i < direction_count(dimensions); i++) {
            double g[3];
            direction_of(dimensions, octaves[k].turn, i, g);
            for (int axis = 0; axis < dimensions; axis++) {
                const float of = (float)g[axis];
                const float *const still = dimensions == 2 ? directions2[i] : directions3[i];
                CHECK(memcmp(&of, &still[axis], sizeof of) == 0,
                      "%dD phase %g, octave %d, direction %d: %.9g along axis %d, not %.9g",
                      dimensions, (double)phase, k, i, (double)of, axis, (double)still[axis]);
            }
        }
    }
}

/* E[x^a y^b z^c] of vectors that point in all directions alike, of length 1. */
static double isotropic(int dimensions, const int powers[3])
{
    static const double odd_products[4] = {1.0, 1.0, 3.0, 15.0}; /* 1 * 3 * 5 ... */
    double moment = 1.0;
    int degree = 0;
    for (int axis = 0; axis < 3; axis++) {
        moment *= powers[axis] % 2 == 0 ? odd_products[powers[axis] / 2] : 0.0;
        degree += powers[axis];
    }
    for (int k = 0; k < degree; k += 2) {
        moment /= (double)(dimensions + k);
    }
    return moment;
}

/* E[x^a y^b z^c] of the directions, made as long as 1. */
static double moment_of(int dimensions, const float turn[4], const int powers[3])
{
    const double length = dimensions == 2 ? 1.0 : sqrt(8.0);
    double sum = 0.0;
    for (int i = 0; i < direction_count(dimensions); i++) {
        double g[3], term = 1.0;
        direction_of(dimensions, turn, i, g);
        for (int axis = 0; axis < 3; axis++) {
            for (int k = 0; k < powers[axis]; k++) {
                term *= g[axis] / length;
            }
        }
        sum += term;
    }
    return sum / (double)direction_count(dimensions);
}

/*
 * The moments that do not depend on the phase. In 2D they are those of a circle up to the sixth
 * degree. In 3D, where edges of a cube are not as even as a sphere, they are up to the second
 * degree; those of the fourth are, for every phase, those of the edges: E[x^4] = 1/6 along each
 * axis, E[x^2 y^2] = 1/12, and 0 if any power is odd.
 */
static void check_moments(int dimensions, float phase)
{
    set_phase(phase, octaves);
    for (int number = 0; number < 7 * 7 * 7; number++) {
        const int powers[3] = {number % 7, number / 7 % 7, number / 49};
        const int degree = powers[0] + powers[1] + powers[2];
        const int has_odd = powers[0] % 2 != 0 || powers[1] % 2 != 0 || powers[2] % 2 != 0;
        if (dimensions == 2 ? powers[2] != 0 || degree > 7
                            : degree == 0 || degree == 3 || degree > 4) {
            continue;
        }
        double expected = isotropic(dimensions, powers);
        if (dimensions == 3 && degree == 4 && !has_odd) {
            const int pure = powers[0] == 4 || powers[1] == 4 || powers[2] == 4;
            expected = pure ? 1.0 / 6.0 : 1.0 / 12.0;
        }
        const double moment = moment_of(dimensions, octaves[0].turn, powers);
        CHECK(fabs(moment - expected) <= 1e-6, "%dD phase %g: E[x^%d y^%d z^%d] is %.9g, not %.9g",
              dimensions, (double)phase, powers[0], powers[1], powers[2], moment, expected);
    }
}

int main(int argc, char **argv)
{
    const long count = check_argument(argc, argv, 1, 1, "PHASES");
    check_quarters();
    check_phases(count);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        static const float whole[] = {0.0f, -0.0f, 1.0f, -3.0f, 0x1p23f, -FLT_MAX};
        for (size_t i = 0; i < sizeof whole / sizeof whole[0]; i++) {
            check_still(dimensions, whole[i]);
        }
        for (int i = -500; i < 500; i++) {
            check_directions(dimensions, (float)i * 0.00618034f);
            check_moments(dimensions, (float)i * 0.00618034f);
            check_moments(dimensions, (float)i / 64.0f);
        }
    }
    return check_done();
}
