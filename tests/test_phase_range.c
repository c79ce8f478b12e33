/* SPDX-License-Identifier: MIT
 *
 * Proves by branch and bound, as test_range.c does for noise that stands still, that gradient noise
 * with a phase (scarp.h, "Flow") never exceeds scarpi_phase_supremum, and that its derivative with
 * respect to the phase never exceeds 4 pi times that. It also shows that numbers a bit smaller
 * would be wrong.
 * Arguments: how much of the suprema the proof may add in 2D (1e-11) and in 3D (0: nothing). It
 * takes longer, the less there is.
 */
#include "../src/plan/phase.h"
#include "oracle.h"
#include "proof.h"

/*
 * 2D: the gradients of the corners are unit vectors. Which phases bring two corners to given
 * directions does not matter: some phases let all corners of a cell point away from its middle,
 * where the maximum is. So every corner may have any direction, and n_G(t) = sum_c W_c(t) g_c .
 * (t - c) has the supremum S(t) = sum_c W_c(t) |t - c|. Speeds are 1 and -2, so the derivative with
 * respect to the angle of the phase is at most twice that.
 *
 * 3D: at a phase, each corner has one of twelve gradients, three on each of four circles. One phase
 * turns all, so boxes have a fourth coordinate: t[3] is the phase in thirds of a turn. That is a
 * period: a third of a turn takes each three to themselves.
 *
 * The bound on a box with centre m and half-size h is that of proof.h. For signs s of the
 * components it is a sum over corners of the maximum over their gradients g of g . v, with
 *     v = (W + h sum_i s_i d_i W)(t - c) + h W s,
 * in 3D plus h s_3 W (d_3 g) . (t - c).
 */

/* The weights of a corner: [0] is W, [1 + i] is d_i W. */
static void weights_of(enum scarp_fade fade, int dimensions, const double *m, int corner,
                       double w[4])
{
    for (int k = 0; k <= dimensions; k++) {
        w[k] = 1.0;
        for (int i = 0; i < dimensions; i++) {
            double u, du;
            fade_at(fade, m[i], &u, &du);
            const int side = corner >> i & 1;
            w[k] *= k == 1 + i ? (side ? du : -du) : (side ? u : 1.0 - u);
        }
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* v of a corner, for signs s. */
static void direction_of(double v[3], const double w[4], const double off[3], int dimensions,
                         double h, int signs)
{
    double factor = w[0];
    for (int i = 0; i < dimensions; i++) {
        const double step = signs >> i & 1 ? h : -h;
        factor += step * w[1 + i];
        v[i] = step * w[0];
    }
    for (int i = 0; i < dimensions; i++) {
        v[i] += factor * off[i];
    }
}

static double largest_of(const double *sums, int count)
{
    double largest = sums[0];
    for (int i = 1; i < count; i++) {
        largest = fmax(largest, sums[i]);
    }
    return largest;
}

/* The largest n_G(m) + h sum_i |d_i n_G(m)| over all G in 2D; with h = 0 this is S(m). */
static double first_order2(const struct proof *proof, const double *m, double h)
{
    const int choices = h > 0.0 ? 4 : 1;
    double sums[4] = {0.0};
    for (int corner = 0; corner < 4; corner++) {
        const double off[3] = {m[0] - (double)(corner & 1), m[1] - (double)(corner >> 1), 0.0};
        double w[4];
        weights_of(proof->fade, 2, m, corner, w);
        for (int signs = 0; signs < choices; signs++) {
            double v[3] = {0.0, 0.0, 0.0};
            direction_of(v, w, off, 2, h, signs);
            sums[signs] += sqrt(dot(v, v));
        }
    }
    return largest_of(sums, choices);
}

#define GRADIENTS 12
#define THIRD 2.0943951023931953 /* of a turn */

/* The gradients at a phase, and their derivatives with respect to t[3]. */
struct turned {
    double g[GRADIENTS][3], by_phase[GRADIENTS][3];
};

/* The table of scarp.h: diagonals, edges in units of half their length here, speeds. With `rates`,
   the gradients are replaced by their derivatives with respect to the angle of the phase. */
static struct turned turned_at(double thirds, int rates)
{
    static const double diagonals[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    static const double edges[GRADIENTS][3] = {{1, -1, 0},  {-1, 0, 1}, {0, 1, -1},  {1, 1, 0},
                                               {-1, 0, -1}, {0, -1, 1}, {-1, -1, 0}, {1, 0, -1},
                                               {0, 1, 1},   {-1, 1, 0}, {1, 0, 1},   {0, -1, -1}};
    const double angle = thirds * THIRD;
    const double cosines[2] = {cos(angle), cos(2.0 * angle)};
    const double sines[2] = {sin(angle), sin(2.0 * angle)};
    struct turned t;
    for (int i = 0; i < GRADIENTS; i++) {
        const double speed = i < 6 ? 1.0 : 2.0, c = cosines[i / 6], s = sines[i / 6];
        const double *const d = diagonals[i / 3], *const e = edges[i];
        for (int k = 0; k < 3; k++) {
            const int l = (k + 1) % 3, n = (k + 2) % 3;
            const double ahead = (d[l] * e[n] - d[n] * e[l]) / sqrt(3.0);
            const double g = 2.0 * (c * e[k] + s * ahead), q = 2.0 * (c * ahead - s * e[k]);
            t.g[i][k] = rates ? speed * q : g;
            t.by_phase[i][k] = speed * THIRD * (rates ? -speed * g : q);
        }
    }
    return t;
}

static int is_rates(const struct proof *proof)
{
    return *(const int *)proof->vectors;
}

/*
 * K of proof.h on a box: `product`, the largest |g . (t - c)| there, is R times the largest
 * distance from a corner, R being the largest length of a gradient. No gradient turns faster than 2
 * thirds of a turn per unit of t[3], so with the largest |u'| U |d_i3 n| <= 2 THIRD (2 U product +
 * R)     |d_33 n| <= (2 THIRD)^2 product.
 */
static double curvature_at(const struct proof *proof, const double *m, double h)
{
    const double radius = 2.0 * sqrt(2.0) * (is_rates(proof) ? 2.0 : 1.0);
    const double u = proof->fade == SCARP_QUINTIC ? 15.0 / 8.0 : 3.0 / 2.0;
    const double turning = 2.0 * THIRD;
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        const double far = fmax(m[i], 1.0 - m[i]) + h;
        square += far * far;
    }
    const double product = radius * sqrt(square);
    return proof_curvature(3, proof->fade, product, radius) +
           6.0 * turning * (2.0 * u * product + radius) + turning * turning * product;
}

/* Adds the largest terms of a corner to the sums for all signs. */
static void add_corner(double sums[16], const struct turned *turned, const double w[4],
                       const double off[3], double h)
{
    double v[3][8], back[8], ahead[8];
    for (int signs = 0; signs < 8; signs++) {
        double of_signs[3];
        direction_of(of_signs, w, off, 3, h, signs);
        for (int i = 0; i < 3; i++) {
            v[i][signs] = of_signs[i];
        }
        back[signs] = ahead[signs] = -HUGE_VAL;
    }
    for (int i = 0; i < GRADIENTS; i++) {
        const double moved = h * w[0] * dot(turned->by_phase[i], off), *const g = turned->g[i];
        for (int signs = 0; signs < 8; signs++) {
            const double product = g[0] * v[0][signs] + g[1] * v[1][signs] + g[2] * v[2][signs];
            const double less = product - moved, more = product + moved;
            back[signs] = less > back[signs] ? less : back[signs];
            ahead[signs] = more > ahead[signs] ? more : ahead[signs];
        }
    }
    for (int signs = 0; signs < 8; signs++) {
        sums[signs] += back[signs];
        sums[8 + signs] += ahead[signs];
    }
}

/* The same in 3D, with the bound of second order; with h = 0 this is S(m). */
static double second_order3(const struct proof *proof, const double *m, double h)
{
    const struct turned turned = turned_at(m[3], is_rates(proof));
    double sums[16] = {0.0};
    for (int corner = 0; corner < 8; corner++) {
        double w[4], off[3];
        for (int i = 0; i < 3; i++) {
            off[i] = m[i] - (double)(corner >> i & 1);
        }
        weights_of(proof->fade, 3, m, corner, w);
        add_corner(sums, &turned, w, off, h);
    }
    return h > 0.0 ? largest_of(sums, 16) + 0.5 * h * h * curvature_at(proof, m, h) : sums[0];
}

/*
 * Whether S <= limit everywhere. In 2D a quarter of the cell is enough. In 3D, half a turn
 * around x takes the gradients to themselves at every phase. Half a turn around (0, 1, -1) takes
 * them to those of the opposite phase, and their derivatives with respect to the phase to the
 * opposite of these, so that the cell is mirrored besides. So y <= 1/2 and a sixth of a turn will
 * do.
 */
static int bounded_in_cell(struct proof *proof)
{
    const double centre[4] = {0.25, 0.25, 0.25, 0.25};
    int proven = proof->dimensions == 2 ? proof_bounded(proof, centre, 0.25, 0) : 1;
    for (int i = 0; proof->dimensions == 4 && i < 4; i++) {
        const double part[4] = {i % 2 == 0 ? 0.25 : 0.75, 0.25, i / 2 == 0 ? 0.25 : 0.75, 0.25};
        proven = proven && proof_bounded(proof, part, 0.25, 0);
    }
    return proven;
}

/* Checks the symmetry that bounded_in_cell() relies on. */
static void check_symmetry(const struct proof *proof)
{
    uint64_t random = 1;
    for (int i = 0; i < 3000; i++) {
        double t[4];
        for (int axis = 0; axis < 4; axis++) {
            t[axis] = 0.5 + check_random_double(&random, 0.5);
        }
        const double mirrored[2][2] = {{1.0 - t[0], t[1]}, {t[0], 1.0 - t[1]}};
        const int rates = proof->dimensions == 4 && is_rates(proof); /* these change sign */
        const double turned[3][4] = {{t[0], 1.0 - t[1], 1.0 - t[2], t[3]},
                                     {rates ? t[0] : 1.0 - t[0], rates ? t[2] : 1.0 - t[2],
                                      rates ? t[1] : 1.0 - t[1], -t[3]},
                                     {t[0], t[1], t[2], t[3] + 1.0}};
        const int flat = proof->dimensions == 2;
        for (int n = 0; n < (flat ? 2 : 3); n++) {
            const double a = proof->first_order(proof, t, 0.0);
            const double b = proof->first_order(proof, flat ? mirrored[n] : turned[n], 0.0);
            CHECK(fabs(a - b) <= 1e-13, "%.17g is %.17g after symmetry %d", a, b, n);
        }
    }
}

/* Searches for the maximum from the points of a coarse grid. Returns it, and its place in t. */
static double search(const struct proof *proof, double t[4])
{
    double best = 0.0;
    for (int i = 0; i < 32; i++) {
        double there[4] = {(0.5 + i % 2) / 2.0, (0.5 + i / 2 % 2) / 2.0, (0.5 + i / 4 % 2) / 2.0,
                           (0.5 + i / 8) / 4.0};
        const double value = proof_climb(proof, there, 0x1p-4);
        if (value > best) {
            best = value;
            memcpy(t, there, sizeof there);
        }
    }
    return best;
}

/* Proves that S is at most claimed (1 + slack), and that it reaches claimed (1 - gap) at least. */
static void prove(struct proof *proof, const char *name, double claimed, double slack, double gap)
{
    double t[4] = {0.0, 0.0, 0.0, 0.0};
    check_symmetry(proof);
    proof->limit = claimed * (1.0 + slack);
    const int proven = bounded_in_cell(proof);
    const double reached = search(proof, t);
    printf("%-10s %dD %-7s at most %.16g: %s within %g by %ld boxes down to 2^-%d; %.16g, %.1e "
           "less, is reached at (%.6f, %.6f, %.6f)",
           name, proof->dimensions == 2 ? 2 : 3, fade_names[proof->fade], claimed,
           proven ? "proven" : "NOT PROVEN", slack, proof->boxes, proof->depth + 1, reached,
           1.0 - reached / claimed, t[0], t[1], t[2]);
    if (proof->dimensions == 4) {
        printf(" and %.6f turns", t[3] / 3.0);
    }
    printf("\n");
    CHECK(proven, "%s: %.17g (1 + %g) is not a bound", name, claimed, slack);
    CHECK(reached >= claimed * (1.0 - gap), "%s: %.17g is too large, only %.17g is reached", name,
          claimed, reached);

    /* The proof of too small a number must fail. */
    const double beside[4] = {t[0] + 1e-3, t[1] - 2e-3, t[2] + 1e-3, t[3] - 1e-3};
    proof->limit = reached * (1.0 - 1e-8);
    CHECK(!proof_bounded(proof, beside, 4e-3, 0), "%s: %.17g is proven, though more is reached",
          name, proof->limit);
}

static void prove_suprema(int dimensions, enum scarp_fade fade, double slack)
{
    /* By the header, what single octaves may reach with a phase. */
    static const double reach[2][2] = {{1.0169038, 1.0162356}, {1.1100620, 1.1037150}};
    const double supremum = scarpi_phase_supremum(fade, dimensions);
    const double length = dimensions == 2 ? 1.0 : 2.0; /* the oracle has shorter edges */
    const double still = length * oracle_gradient_supremum(dimensions, fade);
    const double stated = reach[dimensions - 2][fade];
    CHECK(supremum <= stated * still, "scarp.h says %.8g, but it is %.9g", stated,
          supremum / still);
    CHECK(supremum >= (stated - 1e-7) * still, "scarp.h says %.8g, but it is %.9g", stated,
          supremum / still);

    static const int rates[2] = {0, 1};
    struct proof value = {
        .dimensions = 4, .fade = fade, .first_order = second_order3, .vectors = &rates[0]};
    if (dimensions == 2) {
        value.dimensions = 2;
        value.first_order = first_order2;
        value.curvature = proof_curvature(2, fade, sqrt(2.0), 1.0);
    }
    prove(&value, "value", supremum, slack, dimensions == 2 ? 1e-12 : 1e-9);
    if (dimensions == 3) { /* by the header |dn / da| <= 4 pi reach, a in turns */
        struct proof derivative = value;
        derivative.vectors = &rates[1];
        derivative.boxes = 0;
        derivative.depth = 0;
        prove(&derivative, "derivative", 2.0 * supremum, slack, 0.13);
    }
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        printf("usage: %s SLACK2 SLACK3\n", argv[0]);
        return EXIT_FAILURE;
    }
    for (int i = 0; i < 4; i++) {
        const enum scarp_fade fade = i % 2 == 0 ? SCARP_QUINTIC : SCARP_CUBIC;
        prove_suprema(2 + i / 2, fade, strtod(argv[1 + i / 2], NULL));
    }
    return check_done();
}
