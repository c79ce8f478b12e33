/* SPDX-License-Identifier: MIT
 *
 * Tests the guaranteed ranges. First it proves the suprema of gradient noise, by which the library
 * divides (test_accuracy.c checks that it does), by branch and bound. Then it searches maximisers,
 * extreme lattice values and random points for values outside the interval of scarp_range, and
 * checks that the head-room for rounding is needed.
 * Argument: the number of points per search.
 */
#include "oracle.h"
#include "proof.h"
#include "suprema.h"

/*
 * Gradient noise in a cell is n_G(t) = sum_c W_c(t) g_c . (t - c) over the corners c, G being the
 * choice of their gradients. Each corner is free, so the supremum is that of
 *     S(t) = max_G n_G(t) = sum_c W_c(t) max_g g . (t - c).
 * The set of gradients is closed under a change of sign of each component. Hence -S is the infimum,
 * and S is symmetric about the middle of the cell along each axis: t in [0, 1/2]^d is enough.
 *
 * The bound on a box (proof.h) is the largest n_G(m) + h sum_i s_i d_i n_G(m) over the 2^d choices
 * of signs s. For given signs that is a sum of terms of one corner each, so the maximum over G is
 * taken corner by corner, although there are 16^4 or 12^8 choices.
 */
struct gradients {
    int count;
    double of[16][3];
};

/* The largest n_G(m) + h sum_i |d_i n_G(m)| over all G; with h = 0 this is S(m). */
static double first_order(const struct proof *proof, const double *m, double h)
{
    const struct gradients *const gradients = proof->vectors;
    const int d = proof->dimensions;
    double weight[3][2], slope[3][2], sums[8] = {0.0};
    for (int i = 0; i < d; i++) {
        fade_at(proof->fade, m[i], &weight[i][1], &slope[i][1]);
        weight[i][0] = 1.0 - weight[i][1];
        slope[i][0] = -slope[i][1];
    }
    for (int corner = 0; corner < 1 << d; corner++) {
        double w = 1.0, dw[3] = {1.0, 1.0, 1.0}, best[8] = {0.0};
        for (int i = 0; i < d; i++) {
            const int side = corner >> i & 1;
            w *= weight[i][side];
            for (int j = 0; j < d; j++) {
                dw[j] *= i == j ? slope[i][side] : weight[i][side];
            }
        }
        for (int k = 0; k < gradients->count; k++) {
            const double *const g = gradients->of[k];
            double dot = 0.0, along[3];
            for (int i = 0; i < d; i++) {
                dot += g[i] * (m[i] - (double)(corner >> i & 1));
            }
            for (int i = 0; i < d; i++) {
                along[i] = h * (dw[i] * dot + w * g[i]);
            }
            for (int signs = 0; signs < 1 << d; signs++) {
                double term = w * dot;
                for (int i = 0; i < d; i++) {
                    term += signs >> i & 1 ? along[i] : -along[i];
                }
                best[signs] = k == 0 || term > best[signs] ? term : best[signs];
            }
        }
        for (int signs = 0; signs < 1 << d; signs++) {
            sums[signs] += best[signs];
        }
    }
    double largest = sums[0];
    for (int signs = 1; signs < 1 << d; signs++) {
        largest = fmax(largest, sums[signs]);
    }
    return largest;
}

/* Where S has its maximum, to the digits that src/plan/suprema.c states. */
static const double *maximiser(int dimensions, enum scarp_fade fade)
{
    static const double at[2][2][3] = {{{0.5, 0.5266}, {0.4667, 0.5}},
                                       {{0.5185, 0.5, 0.3553}, {0.5, 0.5236, 0.6756}}};
    return at[dimensions - 2][fade];
}

/* Draws the gradients, and checks that they are closed under a change of sign of components. */
static void draw_gradients(struct gradients *gradients, int dimensions)
{
    const int count = oracle_gradient_count(dimensions);
    gradients->count = count;
    for (unsigned k = 0; k < (unsigned)count; k++) {
        oracle_gradient_vector(dimensions, k, gradients->of[k]);
    }
    for (int k = 0; k < count * dimensions; k++) {
        const double *const g = gradients->of[k % count];
        const int axis = k / count;
        int found = 0;
        for (int other = 0; other < count; other++) {
            double distance = 0.0;
            for (int i = 0; i < dimensions; i++) {
                const double mirrored = i == axis ? -g[i] : g[i];
                distance += fabs(gradients->of[other][i] - mirrored);
            }
            found |= distance < 1e-15;
        }
        CHECK(found, "gradient %d has no mirror image along axis %d", k % count, axis);
    }
}

static void prove_supremum(int dimensions, enum scarp_fade fade, double slack)
{
    const double claimed = oracle_gradient_supremum(dimensions, fade);
    const double product =
        dimensions == 2 ? sqrt(2.0) /* unit vectors */ : 2.0; /* two components */
    struct gradients gradients;
    struct proof proof = {.dimensions = dimensions,
                          .fade = fade,
                          .first_order = first_order,
                          .vectors = &gradients,
                          .curvature = proof_curvature(dimensions, fade, product, 1.0),
                          .limit = claimed * (1.0 + slack)};
    draw_gradients(&gradients, dimensions);
    const double centre[3] = {0.25, 0.25, 0.25};
    const int proven = proof_bounded(&proof, centre, 0.25, 0);
    double t[3];
    const double *const stated = maximiser(dimensions, fade);
    memcpy(t, stated, sizeof t);
    const double reached = proof_climb(&proof, t, 0x1p-14);
    printf("supremum %dD %-7s %.16g: %s within %g by %ld boxes down to 2^-%d; reached within %.0e "
           "at (%.6f, %.6f, %.6f)\n",
           dimensions, fade_names[fade], claimed, proven ? "proven" : "NOT PROVEN", slack,
           proof.boxes, proof.depth + 1, fabs(1.0 - reached / claimed), t[0], t[1], t[2]);
    CHECK(proven, "%.17g (1 + %g) is not a bound", claimed, slack);
    CHECK(reached >= claimed * (1.0 - 1e-13), "only %.17g is reached", reached);
    for (int i = 0; i < dimensions; i++) {
        CHECK(fabs(t[i] - stated[i]) <= 1e-4, "the maximum is at %.17g, not %g", t[i], stated[i]);
    }
}

#define BLOCK 1000
#define KEPT 24

/* A search for extreme values of one noise. */
struct search {
    struct scarp_noise noise;
    int dimensions;
    float lowest, highest; /* from scarp_range */
    long samples;
    int kept;
    struct {
        float magnitude;
        double x[3];
    } best[KEPT]; /* unordered; the smallest magnitude is at `weakest` */
    int weakest;
};

static double points[3][BLOCK];
static float values[BLOCK];

static struct search begin(const struct scarp_noise *noise, int dimensions)
{
    struct search search = {.noise = *noise, .dimensions = dimensions};
    const float amplitude = noise->amplitude == 0.0f ? 1.0f : fabsf(noise->amplitude);
    CHECK(scarp_range(noise, dimensions, &search.lowest, &search.highest) == SCARP_OK, "refused");
    CHECK(search.lowest == -amplitude && search.highest == amplitude, "[%g, %g] for amplitude %g",
          (double)search.lowest, (double)search.highest, (double)noise->amplitude);
    return search;
}

static void keep(struct search *search, size_t i)
{
    const int slot = search->kept < KEPT ? search->kept++ : search->weakest;
    search->best[slot].magnitude = fabsf(values[i]);
    for (int axis = 0; axis < 3; axis++) {
        search->best[slot].x[axis] = points[axis][i];
    }
    search->weakest = 0;
    for (int k = 1; k < search->kept; k++) {
        if (search->best[k].magnitude < search->best[search->weakest].magnitude) {
            search->weakest = k;
        }
    }
}

/* Samples the first `count` points: all values must be within the range. Keeps the largest. */
static void probe(struct search *search, size_t count)
{
    const struct scarp_samples out = {.value = values};
    const enum scarp_status status =
        search->dimensions == 2
            ? scarp_sample2_f64(&search->noise, count, points[0], points[1], &out)
            : scarp_sample3_f64(&search->noise, count, points[0], points[1], points[2], &out);
    CHECK(status == SCARP_OK, "%s", scarp_status_text(status));
    size_t outside = 0, last = 0;
    for (size_t i = 0; i < count; i++) {
        if (!(values[i] >= search->lowest && values[i] <= search->highest)) { /* or NaN */
            outside++;
            last = i;
        }
    }
    CHECK(outside == 0, "%zu values outside: %.9g at (%.17g, %.17g, %.17g)", outside,
          (double)values[last], points[0][last], points[1][last], points[2][last]);
    search->samples += (long)count;
}

static void probe_and_keep(struct search *search, size_t count)
{
    probe(search, count);
    for (size_t i = 0; i < count; i++) {
        if (search->kept < KEPT || fabsf(values[i]) > search->best[search->weakest].magnitude) {
            keep(search, i);
        }
    }
}

/* Moves each kept point to the local extreme by pattern search. Returns the largest magnitude. */
static float climb(struct search *search)
{
    float largest = 0.0f;
    const size_t neighbours = 2 * (size_t)search->dimensions;
    for (int k = 0; k < search->kept; k++) {
        double *const x = search->best[k].x;
        for (double step = 0x1p-6; step > 0x1p-24;) {
            for (size_t i = 0; i < neighbours; i++) {
                for (size_t axis = 0; axis < 3; axis++) {
                    const double move = i % 2 == 0 ? step : -step;
                    points[axis][i] = x[axis] + (axis == i / 2 ? move : 0.0);
                }
            }
            probe(search, neighbours);
            size_t best = 0;
            for (size_t i = 1; i < neighbours; i++) {
                best = fabsf(values[i]) > fabsf(values[best]) ? i : best;
            }
            if (fabsf(values[best]) > search->best[k].magnitude) {
                search->best[k].magnitude = fabsf(values[best]);
                x[best / 2] += best % 2 == 0 ? step : -step;
            } else {
                step *= 0.5;
            }
        }
        largest = fmaxf(largest, search->best[k].magnitude);
    }
    return largest;
}

/* `reachable` is a fraction of the range that a search of this size is known to reach. */
static void report(struct search *search, const char *name, double reachable)
{
    const float largest = climb(search);
    const double fraction = (double)largest / (double)search->highest;
    printf("%-44s %dD %-7s: |value| up to %.9f of the range, %ld samples\n", name,
           search->dimensions, fade_names[search->noise.fade], fraction, search->samples);
    CHECK(fraction >= reachable, "only %g of the range was reached, not %g", fraction, reachable);
}

/*
 * Samples gradient noise at the maximiser of S and its images under the symmetries of the cell, in
 * many cells, and keeps those whose corners happen to have (nearly) the gradients that maximise it.
 * In 2D one cell in 16^4 has the very pattern; in 3D one in some 12^8 per image, so that only a
 * search of 10^8 samples is likely to meet it.
 */
static void search_maximisers(int dimensions, enum scarp_fade fade, long samples, double reachable)
{
    const double *const t = maximiser(dimensions, fade);
    const struct scarp_noise noise = {.fade = fade, .seed = 2, .amplitude = -1.0f};
    struct search search = begin(&noise, dimensions);
    uint64_t random = 1;
    while (search.samples < samples) {
        for (size_t i = 0; i < BLOCK; i++) {
            const uint64_t image = check_random(&random);
            const int first = (int)((image >> 8) % (uint64_t)dimensions);
            const int second =
                dimensions == 2 ? 1 - first : (first + 1 + (int)(image >> 4 & 1)) % 3;
            const int axes[3] = {first, second, 3 - first - second};
            for (int k = 0; k < dimensions; k++) {
                const double fraction = image >> k & 1 ? t[k] : 1.0 - t[k];
                points[axes[k]][i] = floor(check_random_double(&random, 0x1p20)) + fraction;
            }
        }
        probe_and_keep(&search, BLOCK);
    }
    report(&search, "gradient noise, maximisers", reachable);
}

/*
 * Where gradient noise has its supremum, roundings lift some values above it, so that without
 * head-room they would leave the range: they are greater than HEADROOM, but not than 1. (The 2D
 * quintic noise happens to round down at its places.)
 */
#define HEADROOM (1.0f - 0x1p-17f) /* of src/plan/octaves.c */

static void search_headroom(int dimensions, enum scarp_fade fade)
{
    const struct scarp_noise noise = {.fade = fade, .seed = SUPREMUM_SEED};
    struct search search = begin(&noise, dimensions);
    long beyond = 0;
    float largest = 0.0f;
    uint64_t random = 1;
    for (int block = 0; block < 16; block++) {
        const double *const place = supremum_places[dimensions - 2][fade][block % 2];
        for (size_t i = 0; i < BLOCK; i++) {
            for (int axis = 0; axis < 3; axis++) {
                points[axis][i] = place[axis] + check_random_double(&random, 0x1p-14);
            }
        }
        probe(&search, BLOCK);
        for (size_t i = 0; i < BLOCK; i++) {
            largest = fmaxf(largest, fabsf(values[i]));
            beyond += fabsf(values[i]) > HEADROOM;
        }
    }
    printf("head-room, gradient noise %dD %-7s: |value| up to %.9f, %ld of %ld beyond %.9f\n",
           dimensions, fade_names[fade], (double)largest, beyond, search.samples, (double)HEADROOM);
    CHECK(fabsf(largest / HEADROOM - 1.0f) <= 0x1p-22f, "up to %.9g: not the supremum",
          (double)largest);
    CHECK(beyond > 0 || (dimensions == 2 && fade == SCARP_QUINTIC), "no value needs head-room");
}

/*
 * Searches value noise between two neighbours with extreme lattice values: of the same sign, where
 * the interpolation has no room left, and of opposite sign, where an error of the fade weighs most.
 */
static void search_edges(int dimensions, enum scarp_fade fade, long samples)
{
    const struct scarp_noise noise = {.basis = SCARP_VALUE, .fade = fade, .seed = 3};
    struct search search = begin(&noise, dimensions);
    double edge[2][3] = {{0.0}};
    float extreme[2] = {0.0f, 0.0f};
    uint64_t random = 1;
    while (search.samples < samples) {
        const double y = floor(check_random_double(&random, 0x1p30));
        const double z = floor(check_random_double(&random, 0x1p30));
        for (size_t i = 0; i < BLOCK; i++) {
            points[0][i] = (double)i;
            points[1][i] = y;
            points[2][i] = z;
        }
        probe_and_keep(&search, BLOCK);
        for (size_t i = 0; i + 1 < BLOCK; i++) {
            const float weaker = fminf(fabsf(values[i]), fabsf(values[i + 1]));
            const int opposite = (values[i] < 0.0f) != (values[i + 1] < 0.0f);
            if (weaker > extreme[opposite]) {
                extreme[opposite] = weaker;
                for (int axis = 0; axis < 3; axis++) {
                    edge[opposite][axis] = points[axis][i];
                }
            }
        }
    }
    for (int opposite = 0; opposite < 2; opposite++) {
        for (int block = 0; block < 100; block++) {
            for (size_t i = 0; i < BLOCK; i++) {
                /* Half of them within 2^-6 of the ends, next to the edge too. */
                const double span = i % 2 == 0 ? 0x1p-6 : 1.0;
                const double along = check_random_double(&random, span);
                points[0][i] = edge[opposite][0] + (along < 0.0 ? 1.0 + along : along);
                points[1][i] = edge[opposite][1] + check_random_double(&random, 0x1p-8);
                points[2][i] = edge[opposite][2] + check_random_double(&random, 0x1p-8);
            }
            probe_and_keep(&search, BLOCK);
        }
    }
    report(&search, "value noise, extreme edges", 0.999);
}

static void search_random(const char *name, const struct scarp_noise *noise, int dimensions,
                          long samples, double reachable)
{
    struct search search = begin(noise, dimensions);
    uint64_t random = 1;
    while (search.samples < samples) {
        for (size_t i = 0; i < BLOCK; i++) {
            for (int axis = 0; axis < 3; axis++) {
                points[axis][i] = check_random_double(&random, 0x1p12);
            }
        }
        probe_and_keep(&search, BLOCK);
    }
    report(&search, name, reachable);
}

static void search_all_random(long samples)
{
    static const struct {
        const char *name;
        struct scarp_noise noise;
        double reachable; /* at 50,000 samples, in 3D */
    } cases[] = {
        {"gradient, 1 octave", {.seed = 1}, 0.7},
        {"value, 1 octave", {.seed = 1, .basis = SCARP_VALUE}, 0.9},
        {"gradient, 8 octaves, negative", {.seed = 5, .octaves = 8, .amplitude = -3.7f}, 0.4},
        {"value, 8 octaves",
         {.seed = 5, .octaves = 8, .amplitude = 1e6f, .basis = SCARP_VALUE},
         0.4},
        {"gradient, 4.5 octaves, cubic, turned",
         {.octaves = 4.5f, .gain = 0.0625f, .rotate = 1, .fade = SCARP_CUBIC},
         0.6},
        {"value, 32 octaves, slow, gain 1, turned",
         {.octaves = 32, .lacunarity = 1.1f, .gain = 1.0f, .rotate = 1, .basis = SCARP_VALUE},
         0.3},
        {"value, a hundredth of an octave, cubic",
         {.octaves = 0.01f, .amplitude = 0x1p-20f, .basis = SCARP_VALUE, .fade = SCARP_CUBIC},
         0.9},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        /* The first four are those that callers use; the others are slow or odd. */
        const long n = i < 4 ? samples : samples / 10;
        search_random(cases[i].name, &cases[i].noise, 2, n, cases[i].reachable);
        search_random(cases[i].name, &cases[i].noise, 3, n, cases[i].reachable);
    }
}

int main(int argc, char **argv)
{
    const long samples = check_argument(argc, argv, 1, BLOCK, "SAMPLES");
    /* On emulated processors fewer samples are asked for; then the proof is coarser too. */
    const int emulated = samples < 1000000;
    for (int i = 0; i < 4; i++) {
        const int dimensions = i < 2 ? 2 : 3;
        const enum scarp_fade fade = i % 2 == 0 ? SCARP_QUINTIC : SCARP_CUBIC;
        prove_supremum(dimensions, fade, emulated ? 1e-6 : 1e-12);
        search_maximisers(dimensions, fade, dimensions == 2 ? samples : 10 * samples,
                          dimensions == 3 ? 0.9
                          : emulated      ? 0.98
                                          : 0.9999);
        search_headroom(dimensions, fade);
        search_edges(dimensions, fade, samples);
    }
    search_all_random(samples);
    return check_done();
}
