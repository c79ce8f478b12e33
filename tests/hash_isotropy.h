/* SPDX-License-Identifier: MIT
 *
 * Whether 3D gradient noise treats the axes alike, for tests/test_hash.c: the moments of the
 * directions that it draws, the variances of its derivatives, and those of its values on lattice
 * planes, where it is most uneven. A set of directions that is known to be bad goes through the
 * same noise.
 */
#ifndef SCARP_TESTS_HASH_ISOTROPY_H
#define SCARP_TESTS_HASH_ISOTROPY_H

#include "../src/scalar/sample.h"

#include "../src/formulas/basis.h"
#include "hash_fields.h"

#define UNEVEN 0.01 /* what two variances of 2^20 samples may differ by, relatively; 5 sigma */

typedef const float *direction_fn(uint32_t hash);

/* Draws one of 12 edges by four bits, as many implementations of improved noise do: the edges in
   the x-y plane are drawn twice as often. */
static const float *known_bad_direction(uint32_t hash)
{
    static const float edges[16][3] = {
        {1, 0, 1},  {1, 0, -1}, {0, 1, 1},   {0, 1, -1},  {1, 1, 0},  {1, 1, 0},
        {1, -1, 0}, {1, -1, 0}, {-1, 0, 1},  {-1, 0, -1}, {0, -1, 1}, {0, -1, -1},
        {-1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {-1, -1, 0},
    };
    return edges[hash >> 28];
}

static const float *scarp_direction(uint32_t hash)
{
    return directions3[direction_index3(hash)];
}

/* The directions' moments, by the upper halves of hashes: the largest of the first and third ones,
   which a set without a preference does not have, and the ratios of the second ones. */
struct moments {
    double odd, second, fourth;
};

static inline struct moments moments_of(direction_fn *direction)
{
    double first[3] = {0.0}, second[3][3] = {{0.0}}, third[3][3][3] = {{{0.0}}};
    double fourth[3] = {0.0};
    for (uint32_t i = 0; i < 1 << 16; i++) {
        const float *const g = direction(i << 16);
        for (int a = 0; a < 3; a++) {
            const double ga = (double)g[a];
            first[a] += ga;
            fourth[a] += ga * ga * (double)g[(a + 1) % 3] * (double)g[(a + 1) % 3];
            for (int b = 0; b < 3; b++) {
                second[a][b] += ga * (double)g[b];
                for (int c = 0; c < 3; c++) {
                    third[a][b][c] += ga * (double)g[b] * (double)g[c];
                }
            }
        }
    }
    struct moments m = {0.0, 0.0, 0.0};
    const double length = (second[0][0] + second[1][1] + second[2][2]) / 3.0;
    for (int a = 0; a < 3; a++) {
        m.odd = fmax(m.odd, fabs(first[a]) / length);
        m.second = fmax(m.second, fabs(second[a][a] / length - 1.0));
        m.fourth =
            fmax(m.fourth, fabs(3.0 * fourth[a] / (fourth[0] + fourth[1] + fourth[2]) - 1.0));
        for (int b = 0; b < 3; b++) {
            m.second = fmax(m.second, b == a ? 0.0 : fabs(second[a][b]) / length);
            for (int c = 0; c < 3; c++) {
                m.odd = fmax(m.odd, fabs(third[a][b][c]) / length);
            }
        }
    }
    return m;
}

/* Gradient noise with these directions, by the definition: sum_c W_c g_c . (t - c), and its
   gradient. */
static inline void plain_noise(direction_fn *direction, const uint32_t key[3], const double p[3],
                               double *value, double gradient[3])
{
    double t[3], u[3], du[3];
    for (int i = 0; i < 3; i++) {
        t[i] = p[i] - floor(p[i]);
        u[i] = t[i] * t[i] * t[i] * (t[i] * (t[i] * 6.0 - 15.0) + 10.0);
        du[i] = 30.0 * t[i] * t[i] * (1.0 - t[i]) * (1.0 - t[i]);
        gradient[i] = 0.0;
    }
    *value = 0.0;
    for (int corner = 0; corner < 8; corner++) {
        uint32_t cell[3];
        double weight = 1.0, slope[3] = {1.0, 1.0, 1.0}, dot = 0.0;
        for (int i = 0; i < 3; i++) {
            const int side = corner >> i & 1;
            cell[i] = (uint32_t)(int32_t)floor(p[i]) + (uint32_t)side;
            weight *= side ? u[i] : 1.0 - u[i];
            for (int j = 0; j < 3; j++) {
                slope[j] *= i == j ? (side ? du[i] : -du[i]) : side ? u[i] : 1.0 - u[i];
            }
        }
        const float *const g = direction(hash3(keys_of(key), cell[0], cell[1], cell[2]));
        for (int i = 0; i < 3; i++) {
            dot += (double)g[i] * (t[i] - (double)(corner >> i & 1));
        }
        *value += weight * dot;
        for (int i = 0; i < 3; i++) {
            gradient[i] += weight * (double)g[i] + slope[i] * dot;
        }
    }
}

/* Variances: of dx, dy, dz anywhere, and of values on planes across x, y, z. */
struct variances {
    double slope[3], plane[3];
};

/* How far three numbers are from being equal. */
static inline double unevenness(const double v[3])
{
    const double least = fmin(v[0], fmin(v[1], v[2])), most = fmax(v[0], fmax(v[1], v[2]));
    return most / least - 1.0;
}

/* Draws a point within 2^20 cells of the origin, anywhere or on a lattice plane across an axis. */
static inline void draw_point(uint64_t *random, int plane, double p[3])
{
    for (int i = 0; i < 3; i++) {
        p[i] = check_random_double(random, 0x1p20);
        p[i] = i == plane ? floor(p[i]) : p[i];
    }
}

static inline void measure(direction_fn *direction, int samples, struct variances *v)
{
    uint32_t key[3];
    seed_keys(0, 0, key);
    uint64_t random = 1;
    *v = (struct variances){{0.0}, {0.0}};
    for (int n = 0; n < samples; n++) {
        double p[3], value, gradient[3];
        draw_point(&random, -1, p);
        plain_noise(direction, key, p, &value, gradient);
        for (int i = 0; i < 3; i++) {
            v->slope[i] += gradient[i] * gradient[i] / samples;
        }
        for (int plane = 0; plane < 3; plane++) {
            draw_point(&random, plane, p);
            plain_noise(direction, key, p, &value, gradient);
            v->plane[plane] += value * value / samples;
        }
    }
}

/* Measures the variances of the library's noise. */
static inline void measure_library(int samples, struct variances *v)
{
    const struct scarp_noise noise = {.seed = 0};
    double x[4], y[4], z[4];
    float value[4], dx[4], dy[4], dz[4];
    const struct scarp_samples out = {.value = value, .dx = dx, .dy = dy, .dz = dz};
    uint64_t random = 1;
    *v = (struct variances){{0.0}, {0.0}};
    for (int n = 0; n < samples; n++) {
        for (int i = 0; i < 4; i++) {
            double p[3];
            draw_point(&random, i - 1, p);
            x[i] = p[0];
            y[i] = p[1];
            z[i] = p[2];
        }
        CHECK(scarp_sample3_f64(&noise, 4, x, y, z, &out) == SCARP_OK, "refused");
        const float slope[3] = {dx[0], dy[0], dz[0]};
        for (int i = 0; i < 3; i++) {
            v->slope[i] += (double)slope[i] * (double)slope[i] / samples;
            v->plane[i] += (double)value[i + 1] * (double)value[i + 1] / samples;
        }
    }
}

static inline void variances_print(const char *name, const struct variances *v)
{
    printf("%s: variances of dx %.4f, dy %.4f, dz %.4f; of values on xy %.5f, xz %.5f, yz %.5f\n",
           name, v->slope[0], v->slope[1], v->slope[2], v->plane[2], v->plane[1], v->plane[0]);
}

/* 2^16 upper halves are not a multiple of 12: each direction is drawn 5461 or 5462 times. */
#define MOMENT_BOUND (2.0 / 5461.0)

static inline void test_isotropy(int bits)
{
    const double bound = UNEVEN * sqrt(fmax(1.0, 0x1p20 / (1 << bits)));
    struct variances v;
    measure_library(1 << bits, &v);
    variances_print("scarp", &v);
    CHECK(unevenness(v.slope) <= bound, "slopes differ by %.4f", unevenness(v.slope));
    CHECK(unevenness(v.plane) <= bound, "planes differ by %.4f", unevenness(v.plane));
    const struct moments m = moments_of(scarp_direction);
    CHECK(m.odd <= MOMENT_BOUND && m.second <= MOMENT_BOUND && m.fourth <= MOMENT_BOUND,
          "moments: odd %g, second %g, fourth %g", m.odd, m.second, m.fourth);
}

/* The plain noise equals the library's, so it shows what other directions would do to that. */
static inline void test_bad_directions(int bits)
{
    struct variances library, plain, bad;
    measure_library(1 << (bits - 4), &library);
    measure(scarp_direction, 1 << (bits - 4), &plain);
    const double scale = sqrt(library.slope[0] / plain.slope[0]);
    for (int i = 0; i < 3; i++) {
        CHECK(fabs(library.slope[i] / (scale * scale * plain.slope[i]) - 1.0) < 1e-4 &&
                  fabs(library.plane[i] / (scale * scale * plain.plane[i]) - 1.0) < 1e-4,
              "axis %d: the plain noise is another one", i);
    }
    measure(known_bad_direction, 1 << bits, &bad);
    variances_print("known bad directions", &bad);
    CHECK(unevenness(bad.slope) > 10.0 * UNEVEN && unevenness(bad.plane) > 10.0 * UNEVEN,
          "slopes %.4f, planes %.4f do not reject the bad directions", unevenness(bad.slope),
          unevenness(bad.plane));
    CHECK(moments_of(known_bad_direction).second > 0.1, "moments do not reject them");
}

#endif
