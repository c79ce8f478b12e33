/* SPDX-License-Identifier: MIT
 *
 * Is erosion what was published under that idea, and fBm with derivatives too (I. Quilez, "Value
 * noise derivatives", 2008)? Both recurrences in double as the article has them: they move the
 * point from octave to octave, and the second one a matrix for the derivatives. What scarp adds is
 * handed in: the lattice values of each octave, the offset of its position, and the constant that
 * normalises the sum. The article's matrices are read row by row, as it prints them; its shading
 * language reads them by columns, and so turns the octaves the other way round.
 * Argument: the number of points.
 */
#include "fractal.h"

/* The published recurrences use one lattice for all octaves, scarp one for each. */
struct lattice {
    const struct oracle *oracle;
    int octave;
};

static void draw(const void *opaque, const uint32_t point[3], double corner[3])
{
    const struct lattice *const lattice = opaque;
    corner[0] = oracle_lattice_value(lattice->oracle, lattice->octave, point);
    corner[1] = corner[2] = 0.0;
}

/* Value noise in [-1, 1] at p, in the lattice and with the offset of octave k. The fraction is
   rounded as the calls round it, so only the error of the evaluation is seen. */
static struct oracle_sample noised(const struct oracle *oracle, int k, const double p[3])
{
    const struct lattice lattice = {oracle, k};
    uint32_t cell[3] = {0, 0, 0};
    double t[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < oracle->dimensions; i++) {
        const double q = p[i] + oracle->octave[k].of.offset[i];
        cell[i] = (uint32_t)(int64_t)floor(q);
        t[i] = (double)(float)(q - floor(q));
    }
    struct oracle_sample n;
    oracle_value_noise(draw, &lattice, oracle->dimensions, oracle->fade, cell, t, &n);
    return n;
}

/* terrain(): a += b n / (1 + d.d), b /= 2, p = 2 m p, 15 times. */
static double terrain(const struct oracle *oracle, const double x[3])
{
    double a = 0.0, b = 1.0, d[2] = {0.0, 0.0}, p[3] = {x[0], x[1], 0.0};
    for (int i = 0; i < 15; i++) {
        const struct oracle_sample n = noised(oracle, i, p);
        d[0] += n.gradient[0];
        d[1] += n.gradient[1];
        a += b * n.value / (1.0 + d[0] * d[0] + d[1] * d[1]);
        b *= 0.5;
        const double turned[2] = {0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1]};
        p[0] = 2.0 * turned[0];
        p[1] = 2.0 * turned[1];
    }
    return a;
}

/* fbm(): a += b n, d += b m grad n, b *= s, x = f m3 x, m = f m3^-1 m; f and s as floats hold them.
 */
static struct oracle_sample fbm(const struct oracle *oracle, const double at[3], int octaves)
{
    static const double m3[3][3] = {{0.0, 0.8, 0.6}, {-0.8, 0.36, -0.48}, {-0.6, -0.48, 0.64}};
    const double f = (double)1.98f, s = (double)0.49f;
    double x[3] = {at[0], at[1], at[2]}, b = 1.0;
    double m[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    struct oracle_sample sum = {.value = 0.0};
    for (int k = 0; k < octaves; k++) {
        const struct oracle_sample n = noised(oracle, k, x);
        double next[3], product[3][3];
        sum.value += b * n.value;
        for (int i = 0; i < 3; i++) {
            next[i] = f * (m3[i][0] * x[0] + m3[i][1] * x[1] + m3[i][2] * x[2]);
            for (int j = 0; j < 3; j++) {
                sum.gradient[i] += b * m[i][j] * n.gradient[j];
                /* The inverse of a turn is its transpose. */
                product[i][j] = f * (m3[0][i] * m[0][j] + m3[1][i] * m[1][j] + m3[2][i] * m[2][j]);
            }
        }
        memcpy(x, next, sizeof x);
        memcpy(m, product, sizeof m);
        b *= s;
    }
    return sum;
}

/* (1 - 2^-17) / sum w_k, the published sums starting with w_0 = 1. */
static double normalisation(double gain, int octaves)
{
    double sum = 0.0;
    for (int k = octaves - 1; k >= 0; k--) {
        sum = 1.0 + gain * sum;
    }
    return (1.0 - 0x1p-17) / sum;
}

/* Checks that both agree within three times what was measured, a few roundings of 2^-24. */
static void check_terrain(struct block *block, enum scarp_fade fade, long points)
{
    const struct scarp_noise noise = {.basis = SCARP_VALUE,
                                      .fade = fade,
                                      .fractal = SCARP_EROSION,
                                      .rotate = 1,
                                      .seed = 2008,
                                      .frequency = 0x1p-6,
                                      .octaves = 15.0f};
    struct oracle oracle;
    oracle_make(&oracle, &noise, 2);
    const double scale = normalisation(0.5, 15);
    double worst = 0.0, squares = 0.0;
    uint64_t random = 1;
    for (long done = 0; done < points; done += BLOCK) {
        block_random(block, &random, 1024.0f);
        block_sample(block, &noise, SAMPLE2_F64, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            double x[3];
            block_point(block, i, x);
            const double p[3] = {0x1p-6 * x[0], 0x1p-6 * x[1], 0.0};
            const double expected = scale * terrain(&oracle, p);
            const struct oracle_sample n = block_result(block, &noise, SAMPLE2_F64, i);
            worst = larger(worst, fabs(n.value - expected));
            squares += expected * expected;
        }
    }
    printf("terrain, %s: values of RMS %.3f agree within %.1e\n", fractal_fades[fade],
           sqrt(squares / (double)points), worst);
    CHECK(worst <= 6e-7, "erosion is off by %g", worst);
    CHECK(squares / (double)points > 0.01, "nothing to compare: RMS %g",
          sqrt(squares / (double)points));
}

static void check_fbm(struct block *block, enum scarp_fade fade, long points)
{
    const int octaves = 8;
    const struct scarp_noise noise = {.basis = SCARP_VALUE,
                                      .fade = fade,
                                      .rotate = 1,
                                      .seed = 1978,
                                      .octaves = (float)octaves,
                                      .lacunarity = 1.98f,
                                      .gain = 0.49f};
    struct oracle oracle;
    oracle_make(&oracle, &noise, 3);
    const double scale = normalisation((double)0.49f, octaves), unit = fractal_unit(&oracle, 1);
    double worst[2] = {0.0, 0.0};
    uint64_t random = 2;
    for (long done = 0; done < points; done += BLOCK) {
        block_random(block, &random, 16.0f);
        block_sample(block, &noise, SAMPLE3_F64, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            double x[3];
            block_point(block, i, x);
            const struct oracle_sample expected = fbm(&oracle, x, octaves);
            const struct oracle_sample n = block_result(block, &noise, SAMPLE3_F64, i);
            worst[0] = larger(worst[0], fabs(n.value - scale * expected.value));
            for (int a = 0; a < 3; a++) {
                const double slope = scale * expected.gradient[a];
                worst[1] = larger(worst[1], fabs(n.gradient[a] - slope) / unit);
            }
        }
    }
    printf("fBm with derivatives, %s: values agree within %.1e, gradients within %.1e\n",
           fractal_fades[fade], worst[0], worst[1]);
    CHECK(worst[0] <= 6e-7 && worst[1] <= 7e-7, "off by %g, %g", worst[0], worst[1]);
}

int main(int argc, char **argv)
{
    const long points = check_argument(argc, argv, 1, BLOCK, "POINTS") / BLOCK * BLOCK;
    struct block *const block = block_make();
    for (int fade = SCARP_QUINTIC; fade <= SCARP_CUBIC; fade++) {
        check_terrain(block, (enum scarp_fade)fade, points);
        check_fbm(block, (enum scarp_fade)fade, points);
    }
    block_free(block);
    return check_done();
}
