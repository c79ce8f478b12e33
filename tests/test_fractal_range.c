/* SPDX-License-Identifier: MIT
 *
 * Tests the guaranteed ranges of turbulence, ridged, erosion, ping-pong and hybrid by searches that
 * try to leave the interval of scarp_range on either side, random points first, then pattern
 * searches from the lowest and highest ones and from places where the basis is known to have its
 * supremum. Single octaves reach both ends. (test_range.c proves the suprema, and searches fBm.)
 * Argument: the number of random points per case.
 */
#include "fractal.h"
#include "suprema.h"

#define KEPT 8

/* A search for the lowest [0] and highest [1] values of one noise. */
struct search {
    struct block *block;
    struct scarp_noise noise;
    int dimensions;
    double bounds[2];
    int kept[2];
    struct {
        double value, x[3];
    } best[2][KEPT]; /* the best one first */
};

/*
 * What hybrid noise would be in units of its amplitude if each n_k were 1 or -1, as the bits of
 * `signs` say. The range contains that for all signs, and is hardly wider.
 */
static double hybrid_of(const struct scarp_noise *noise, unsigned signs)
{
    const double gain = noise->gain != 0.0f ? (double)noise->gain : 0.5;
    const double sharpness = noise->sharpness != 0.0f ? (double)noise->sharpness : (double)0.7f;
    const double of =
        noise->of_octaves != 0.0f ? (double)noise->of_octaves : (double)noise->octaves;
    double sums[2] = {0.0, 0.0}, v[2] = {1.0, 1.0}; /* of these signs, and where all n_k are 1 */
    for (int k = 0; k < of; k++) {
        const double n[2] = {(signs >> k & 1) != 0 ? 1.0 : -1.0, 1.0};
        const double parts[2] = {fmax(fmin((double)noise->octaves - k, 1.0), 0.0),
                                 fmin(of - k, 1.0)};
        for (int i = 0; i < 2; i++) {
            const double t = pow(gain, k) * v[i] * (n[i] + sharpness);
            sums[i] += parts[i] * t;
            v[i] = fmax(fmin(t, 1.0), -1.0);
        }
    }
    return sums[0] / sums[1];
}

/* Checks the range of hybrid noise: it is what signs reach, but for the room for roundings, and
   ends at 0 with a sharpness of 1. */
static void check_hybrid(const struct scarp_noise *noise, const float range[2])
{
    const int up = noise->amplitude > 0.0f, count = (int)ceilf(noise->octaves);
    const double a = (double)noise->amplitude;
    const double lowest = (double)range[up ? 0 : 1] / a, highest = (double)range[up ? 1 : 0] / a;
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (unsigned signs = 0; signs < 1u << count; signs++) {
        least = fmin(least, (1.0 - 0x1p-16) * hybrid_of(noise, signs));
        most = fmax(most, (1.0 - 0x1p-16) * hybrid_of(noise, signs));
    }
    CHECK(highest == 1.0 && most <= 1.0, "highest %g, %g is possible", highest, most);
    CHECK(lowest <= least && lowest >= least - 0x1p-15, "lowest %g, %g is possible", lowest, least);
    CHECK(noise->sharpness != 1.0f || lowest == 0.0, "lowest %g with a sharpness of 1", lowest);
}

/* Begins a search, and checks the range against what scarp.h says of it. */
static void begin(struct search *search)
{
    const enum scarp_fractal fractal = search->noise.fractal;
    const float a = search->noise.amplitude;
    const int one_sided = fractal == SCARP_TURBULENCE || fractal == SCARP_RIDGED;
    const int is_hybrid = fractal == SCARP_HYBRID, flows = search->noise.phase != 0.0f;
    float lowest = NAN, highest = NAN;
    const float expected[2] = {one_sided ? fminf(a, 0.0f) : -fabsf(a),
                               one_sided ? fmaxf(a, 0.0f) : fabsf(a)};
    CHECK(scarp_range(&search->noise, search->dimensions, &lowest, &highest) == SCARP_OK,
          "refused");
    if (is_hybrid && !flows) {
        check_hybrid(&search->noise, (const float[2]){lowest, highest});
    }
    CHECK(is_hybrid || flows || (lowest == expected[0] && highest == expected[1]),
          "%s, amplitude %g: [%g, %g]", fractal_name((int)fractal), (double)a, (double)lowest,
          (double)highest);
    search->bounds[0] = (double)lowest;
    search->bounds[1] = (double)highest;
}

/* Whether a is beyond b on side 0 or 1. */
static int beyond(int side, double a, double b)
{
    return side == 0 ? a < b : a > b;
}

static void keep(struct search *search, int side, double value, const double x[3])
{
    int slot = search->kept[side];
    while (slot > 0 && beyond(side, value, search->best[side][slot - 1].value)) {
        slot--;
    }
    if (slot == KEPT) {
        return;
    }
    const int last = search->kept[side] < KEPT ? search->kept[side]++ : KEPT - 1;
    memmove(&search->best[side][slot + 1], &search->best[side][slot],
            (size_t)(last - slot) * sizeof search->best[side][0]);
    search->best[side][slot].value = value;
    memcpy(search->best[side][slot].x, x, sizeof search->best[side][slot].x);
}

/* Samples the first `count` points of the block: all values must be within the range. */
static const float *probe(struct search *search, size_t count)
{
    struct block *const block = search->block;
    const float *const values = block->out.array[0];
    const struct scarp_samples out = {.value = block->out.array[0]};
    const enum scarp_status status =
        search->dimensions == 2
            ? scarp_sample2_f64(&search->noise, count, block->d[0], block->d[1], &out)
            : scarp_sample3_f64(&search->noise, count, block->d[0], block->d[1], block->d[2], &out);
    CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
    size_t outside = 0, last = 0;
    for (size_t i = 0; i < count; i++) {
        const double value = (double)values[i];
        if (!(value >= search->bounds[0] && value <= search->bounds[1])) { /* or NaN */
            outside++;
            last = i;
        }
    }
    CHECK(outside == 0, "%zu values outside: %.9g at (%.17g, %.17g, %.17g)", outside,
          (double)values[last], block->d[0][last], block->d[1][last], block->d[2][last]);
    return values;
}

/* Samples random points. Every other one is on the lattice of octave 0, where value noise has its
   extremes. */
static void search_random(struct search *search, long points)
{
    struct block *const block = search->block;
    uint64_t random = 1;
    for (long done = 0; done < points; done += BLOCK) {
        for (size_t i = 0; i < BLOCK; i++) {
            for (int axis = 0; axis < 3; axis++) {
                const double x = check_random_double(&random, 0x1p12);
                block->d[axis][i] = i % 2 == 0 ? floor(x) : x;
            }
        }
        const float *const values = probe(search, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            double x[3];
            block_point(block, i, x);
            keep(search, 0, (double)values[i], x);
            keep(search, 1, (double)values[i], x);
        }
    }
}

/* Moves x to a local extreme by pattern search, as far as floats show a difference. */
static double climb(struct search *search, int side, double value, double x[3])
{
    struct block *const block = search->block;
    const size_t neighbours = 2 * (size_t)search->dimensions;
    for (double step = 0x1p-4; step > 0x1p-26;) {
        for (size_t i = 0; i < neighbours; i++) {
            for (size_t axis = 0; axis < 3; axis++) {
                const double move = i % 2 == 0 ? step : -step;
                block->d[axis][i] = x[axis] + (axis == i / 2 ? move : 0.0);
            }
        }
        const float *const values = probe(search, neighbours);
        size_t best = 0;
        for (size_t i = 1; i < neighbours; i++) {
            best = beyond(side, (double)values[i], (double)values[best]) ? i : best;
        }
        if (beyond(side, (double)values[best], value)) {
            value = (double)values[best];
            x[best / 2] += best % 2 == 0 ? step : -step;
        } else {
            step *= 0.5;
        }
    }
    return value;
}

/* Finds the lowest and the highest value, as parts of the amplitude. */
static void search_extremes(struct search *search, double reached[2])
{
    for (int side = 0; side < 2; side++) {
        reached[side] = search->best[side][0].value;
        const int places = blends_corners(search->noise.basis) ? 2 : 0;
        for (int k = 0; k < search->kept[side] + places; k++) {
            double x[3], value;
            if (k < search->kept[side]) {
                memcpy(x, search->best[side][k].x, sizeof x);
                value = search->best[side][k].value;
            } else {
                const int sign = k - search->kept[side];
                memcpy(x, supremum_places[search->dimensions - 2][search->noise.fade][sign],
                       sizeof x);
                for (int axis = 0; axis < 3; axis++) {
                    search->block->d[axis][0] = x[axis];
                }
                value = (double)probe(search, 1)[0];
            }
            value = climb(search, side, value, x);
            reached[side] = beyond(side, value, reached[side]) ? value : reached[side];
        }
    }
}

/* `reachable` is the part of the range, between the extremes found, that is known to be reached. */
static void check_case(struct block *block, const struct scarp_noise *noise, int dimensions,
                       long points, double reachable)
{
    struct search search = {.block = block, .noise = *noise, .dimensions = dimensions};
    double reached[2];
    begin(&search);
    search_random(&search, points);
    search_extremes(&search, reached);
    const double width = search.bounds[1] - search.bounds[0];
    const double gap[2] = {(reached[0] - search.bounds[0]) / width,
                           (search.bounds[1] - reached[1]) / width};
    printf("%-10s %-8s %-7s %dD %4g octaves in [%g, %g]: gaps below %.1e, above %.1e of it\n",
           fractal_name((int)noise->fractal), basis_name((int)noise->basis),
           fractal_fades[noise->fade], dimensions, (double)noise->octaves, search.bounds[0],
           search.bounds[1], gap[0], gap[1]);
    if (noise->octaves <= 1.0f && blends_corners(noise->basis) && noise->sharpness == 0.0f &&
        noise->phase == 0.0f) {
        CHECK(gap[0] <= 1e-3 && gap[1] <= 1e-3, "an end is not reached: %g, %g", gap[0], gap[1]);
    }
    CHECK(1.0 - gap[0] - gap[1] >= reachable, "only %g of the range were reached",
          1.0 - gap[0] - gap[1]);
}

/*
 * Simplex and cellular noise with all fractals; fBm of one octave has the range of the basis.
 * Random points do not find where features of several cells are as far off as can be, which is the
 * harder the more they stray.
 */
static void check_own(struct block *block, long points)
{
    static const struct {
        enum scarp_basis basis;
        float jitter;
        double reachable[2]; /* by single octaves of fBm in 2D and 3D, with 10^4 points */
    } own[] = {
        {SCARP_SIMPLEX, 0.0f, {0.9998, 0.9998}}, {SCARP_CELL_F1, 0.0f, {0.8, 0.65}},
        {SCARP_CELL_F1, 0.01f, {0.995, 0.99}},   {SCARP_CELL_F2, 0.0f, {0.86, 0.7}},
        {SCARP_CELL_F2, 0.01f, {0.5, 0.5}}, /* of [1/2, 1]: two features are never near */
        {SCARP_CELL_EDGE, 0.0f, {0.76, 0.58}},   {SCARP_CELL_EDGE, 0.01f, {0.99, 0.99}},
        {SCARP_CELL_SOFT, 0.0f, {0.83, 0.52}},   {SCARP_CELL_VALUE, 0.0f, {0.999, 0.999}},
    };
    for (size_t i = 0; i < 24 * (sizeof own / sizeof own[0]); i++) {
        const struct scarp_noise noise = {.basis = own[i / 24].basis,
                                          .jitter = own[i / 24].jitter,
                                          .fractal = (enum scarp_fractal)(i / 2 % 6),
                                          .octaves = i / 12 % 2 == 0 ? 1.0f : 3.5f,
                                          .amplitude = i / 12 % 2 == 0 ? -2.5f : 1.0f,
                                          .seed = 2};
        const int dimensions = 2 + (int)(i % 2);
        const int single = noise.octaves == 1.0f && noise.fractal == SCARP_FBM;
        check_case(block, &noise, dimensions, points,
                   single ? own[i / 24].reachable[dimensions - 2] : 0.09);
    }
}

/* Ping-pong and hybrid with other sharpness, gains and octaves; hybrid with one above 1 has a
   positive lowest value, of fewer octaves a lower one. */
static void check_sharp(struct block *block, long points)
{
    static const struct {
        struct scarp_noise noise;
        double reachable; /* with 10^4 points */
    } cases[] = {
        {{.octaves = 1.0f, .amplitude = 1.0f, .sharpness = 1.0f}, 0.998},
        {{.octaves = 1.0f, .amplitude = -2.0f, .sharpness = 256.0f}, 0.96},
        {{.octaves = 1.0f, .amplitude = 1.0f, .sharpness = 0x1p-8f}, 0.0},
        {{.octaves = 4.0f, .amplitude = 1.0f, .sharpness = 1.5f, .gain = 0.84f}, 0.4},
        {{.octaves = 2.5f, .of_octaves = 8.0f, .amplitude = 1.0f, .sharpness = 3.0f}, 0.1},
        {{.octaves = 0.5f, .of_octaves = 8.0f, .amplitude = -1.0f, .sharpness = 3.0f}, 0.01},
        {{.octaves = 10.0f, .amplitude = 1.0f, .sharpness = 0.25f, .gain = 0.84f}, 0.2},
        {{.octaves = 9.0f, .amplitude = 1.0f, .sharpness = 0x1p-8f, .gain = 16.0f}, 0.005},
        {{.octaves = 6.0f, .amplitude = 1.0f, .sharpness = 1.0f, .gain = 1.0f}, 0.3},
        {{.octaves = 5.0f, .amplitude = 1.0f, .sharpness = 1.0f, .gain = 16.0f}, 0.3},
        {{.octaves = 5.0f, .amplitude = 1.0f, .gain = 16.0f}, 0.3},
        {{.octaves = 1.0f, .amplitude = 1.0f, .phase = 15.0f / 64.0f}, 0.7},
        {{.octaves = 3.0f, .amplitude = -1.0f, .phase = 15.0f / 64.0f, .gain = 1.5f}, 0.3},
    };
    for (size_t i = 0; i < 4 * (sizeof cases / sizeof cases[0]); i++) {
        struct scarp_noise noise = cases[i / 4].noise;
        noise.basis =
            noise.phase != 0.0f ? SCARP_GRADIENT : SCARP_VALUE; /* whose extremes are found */
        noise.fractal = i / 2 % 2 == 0 ? SCARP_PINGPONG : SCARP_HYBRID;
        check_case(block, &noise, 2 + (int)(i % 2), points, cases[i / 4].reachable);
    }
}

int main(int argc, char **argv)
{
    static const struct {
        struct scarp_noise noise;
        double reachable; /* with 10^4 points */
    } cases[] = {
        {{.seed = 2, .octaves = 1.0f, .amplitude = 1.0f}, 0.998},
        {{.seed = 2, .octaves = 1.0f, .amplitude = -3.7f}, 0.998},
        {{.seed = 2, .octaves = 0.3f, .amplitude = 0x1p-20f, .erosion = 8.0f}, 0.998},
        {{.seed = 2, .octaves = 5.0f, .amplitude = 1e6f}, 0.45},
        {{.seed = 2, .octaves = 2.5f, .amplitude = -0.1f, .rotate = 1, .gain = 0.7f}, 0.5},
        {{.seed = 2, .octaves = 12.0f, .amplitude = 1.0f, .gain = 1.5f, .lacunarity = 1.3f}, 0.28},
    };
    const long points = check_argument(argc, argv, 1, BLOCK, "POINTS");
    struct block *const block = block_make();
    for (size_t i = 0; i < 40 * (sizeof cases / sizeof cases[0]); i++) {
        struct scarp_noise noise = cases[i / 40].noise;
        noise.fractal = (enum scarp_fractal)(SCARP_TURBULENCE + i / 8 % 5);
        noise.basis = (enum scarp_basis)(i / 4 % 2);
        noise.fade = (enum scarp_fade)(i / 2 % 2);
        check_case(block, &noise, 2 + (int)(i % 2), points, cases[i / 40].reachable);
    }
    check_own(block, points);
    check_sharp(block, points);
    block_free(block);
    return check_done();
}
