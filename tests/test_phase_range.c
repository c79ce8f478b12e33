/* SPDX-License-Identifier: MIT
 *
 * Proves by branch and bound, as test_range.c does for noise that stands still, that gradient noise
 * with a phase (scarp.h, "Flow") never exceeds scarp_phase_supremum, and that its derivative by the
 * phase never exceeds 4 pi times that. It also shows that numbers a bit smaller would be wrong.
 * Arguments: how much of the suprema the proof may add in 2D (1e-11) and in 3D (0: nothing). It
 * takes longer, the less there is.
 */
#include "../src/plan/phase.h"
#include "oracle.h"
#include "proof.h"

/*
 * With a phase, the gradients of the corners of a cell lie on circles: in 2D on the unit circle, in
 * 3D on four circles of radius 2 sqrt(2), each perpendicular to a diagonal d of a cube. They turn
 * with the speed of their circle. Which phases bring two corners to given places on circles does
 * not matter here: every corner may have any gradient on any circle, which is more than it has.
 * Then n_G(t) = sum_c W_c(t) g_c . (t - c) has the supremum
 *     S(t) = sum_c W_c(t) max_g g . (t - c).
 * Its derivative by the angle of the phase has s q in the place of g, with q a quarter of a turn
 * ahead on the same circle. Both are the maximum of sum_c W_c(t) h_c . (t - c) over vectors h that
 * lie on circles of the radii given here; for the derivative each radius is times the speed.
 *
 * The bound on a box with centre m and half-size h is that of proof.h. For signs s of the
 * components it is a sum over corners of the maximum over the circles of h . v with
 *     v = (W + h sum_i s_i d_i W)(t - c) + h W s,
 * which is the radius times the length of v in the plane of the circle. K, too, is as there, with
 * gradients of length R, the largest radius: |g . (t - c)| <= R sqrt(d), and R bounds components.
 */
struct circles {
    double radius[4]; /* of the circle around each diagonal; 2D has the first only */
};

static const double diagonals[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
static const double speeds[4] = {1.0, 1.0, 2.0, 2.0}; /* around each of them */

/* `by_phase`: whether the derivative by the angle is meant. */
static struct circles circles_of(int dimensions, int by_phase)
{
    struct circles circles;
    const double length = dimensions == 2 ? 1.0 : 2.0 * sqrt(2.0);
    for (int i = 0; i < 4; i++) {
        /* Around one point of the plane, vectors of both speeds turn. */
        const double speed = dimensions == 2 ? 2.0 : speeds[i];
        circles.radius[i] = length * (by_phase ? speed : 1.0);
    }
    return circles;
}

static const double *radii(const struct proof *proof)
{
    return ((const struct circles *)proof->vectors)->radius;
}

/* The largest h . v over all circles. */
static double support(const struct proof *proof, const double v[3])
{
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (proof->dimensions == 2) {
        return radii(proof)[0] * sqrt(square);
    }
    double largest = 0.0;
    for (int i = 0; i < 4; i++) {
        const double *const d = diagonals[i];
        const double along = d[0] * v[0] + d[1] * v[1] + d[2] * v[2];
        const double across = fmax(0.0, square - along * along / 3.0);
        largest = fmax(largest, radii(proof)[i] * radii(proof)[i] * across);
    }
    return sqrt(largest);
}

/* The weights of a corner: [0] is W, [1 + i] is d_i W. */
static void weights_of(const struct proof *proof, const double m[3], int corner, double w[4])
{
    for (int k = 0; k <= proof->dimensions; k++) {
        w[k] = 1.0;
        for (int i = 0; i < proof->dimensions; i++) {
            double u, du;
            fade_at(proof->fade, m[i], &u, &du);
            const int side = corner >> i & 1;
            w[k] *= k == 1 + i ? (side ? du : -du) : (side ? u : 1.0 - u);
        }
    }
}

/* The largest n_G(m) + h sum_i |d_i n_G(m)| over all G; with h = 0 this is S(m). */
static double first_order(const struct proof *proof, const double m[3], double h)
{
    const int d = proof->dimensions, choices = h > 0.0 ? 1 << d : 1;
    double sums[8] = {0.0};
    for (int corner = 0; corner < 1 << d; corner++) {
        double w[4];
        weights_of(proof, m, corner, w);
        for (int signs = 0; signs < choices; signs++) {
            double factor = w[0], v[3] = {0.0, 0.0, 0.0};
            for (int i = 0; i < d; i++) {
                const double step = signs >> i & 1 ? h : -h;
                factor += step * w[1 + i];
                v[i] = step * w[0];
            }
            for (int i = 0; i < d; i++) {
                v[i] += factor * (m[i] - (double)(corner >> i & 1));
            }
            sums[signs] += support(proof, v);
        }
    }
    double largest = sums[0];
    for (int signs = 1; signs < choices; signs++) {
        largest = fmax(largest, sums[signs]);
    }
    return largest;
}

static struct proof proof_of(int dimensions, enum scarp_fade fade, const struct circles *circles)
{
    const double largest = fmax(circles->radius[0], circles->radius[3]);
    return (struct proof){.dimensions = dimensions,
                          .fade = fade,
                          .first_order = first_order,
                          .vectors = circles,
                          .curvature = proof_curvature(
                              dimensions, fade, largest * sqrt((double)dimensions), largest)};
}

/*
 * Whether S <= limit on the whole cell. Mirrored along x, or along y and z together, the circles of
 * each radius are the same again. Mirrored along y alone, or z alone, circles of speed 1 and speed
 * 2 change places. So of the eight parts of a cell, that where t <= 1/2 stands for all if radii are
 * equal, else it and its neighbour along z do.
 */
static int bounded_in_cell(struct proof *proof)
{
    const int equal = radii(proof)[0] == radii(proof)[3];
    const double low[3] = {0.25, 0.25, 0.25}, high[3] = {0.25, 0.25, 0.75};
    return proof_bounded(proof, low, 0.25, 0) && (equal || proof_bounded(proof, high, 0.25, 0));
}

/* Checks the symmetry that bounded_in_cell() relies on. */
static void check_symmetry(const struct proof *proof)
{
    const int equal = radii(proof)[0] == radii(proof)[3];
    uint64_t random = 1;
    for (int i = 0; i < 3000; i++) {
        double t[3], mirrored[3];
        const int along = i % 3;
        for (int axis = 0; axis < 3; axis++) {
            const int turned = axis == along || (!equal && axis + along == 3);
            t[axis] = 0.5 + check_random_double(&random, 0.5);
            mirrored[axis] = turned ? 1.0 - t[axis] : t[axis];
        }
        const double a = first_order(proof, t, 0.0), b = first_order(proof, mirrored, 0.0);
        CHECK(fabs(a - b) <= 1e-13, "%.17g is %.17g in the mirror along axis %d", a, b, along);
    }
}

/* Searches for the maximum from the points of a coarse grid. Returns it, and its place in t. */
static double search(const struct proof *proof, double t[3])
{
    double best = 0.0;
    for (int i = 0; i < 64; i++) {
        double there[3] = {(0.5 + i % 4) / 4.0, (0.5 + i / 4 % 4) / 4.0, (0.5 + i / 16) / 4.0};
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
    double t[3] = {0.0, 0.0, 0.0};
    check_symmetry(proof);
    proof->limit = claimed * (1.0 + slack);
    const int proven = bounded_in_cell(proof);
    const double reached = search(proof, t);
    printf("%-10s %dD %-7s at most %.16g: %s within %g by %ld boxes down to 2^-%d; %.16g, %.1e "
           "less, is reached at (%.6f, %.6f, %.6f)\n",
           name, proof->dimensions, fade_names[proof->fade], claimed,
           proven ? "proven" : "NOT PROVEN", slack, proof->boxes, proof->depth + 1, reached,
           1.0 - reached / claimed, t[0], t[1], t[2]);
    CHECK(proven, "%s: %.17g (1 + %g) is not a bound", name, claimed, slack);
    CHECK(reached >= claimed * (1.0 - gap), "%s: %.17g is too large, only %.17g is reached", name,
          claimed, reached);

    /* The proof of too small a number must fail. */
    const double beside[3] = {t[0] + 1e-3, t[1] - 2e-3, t[2] + 1e-3};
    proof->limit = reached * (1.0 - 1e-8);
    CHECK(!proof_bounded(proof, beside, 4e-3, 0), "%s: %.17g is proven, though more is reached",
          name, proof->limit);
}

static void prove_suprema(int dimensions, enum scarp_fade fade, double slack)
{
    /* By the header, what single octaves may reach with a phase. */
    static const double reach[2][2] = {{1.0169038, 1.0162356}, {1.1233462, 1.1165551}};
    const double supremum = scarp_phase_supremum(fade, dimensions);
    const double length = dimensions == 2 ? 1.0 : 2.0; /* the oracle has shorter edges */
    const double still = length * oracle_gradient_supremum(dimensions, fade);
    const double stated = reach[dimensions - 2][fade];
    CHECK(supremum <= stated * still, "scarp.h says %.8g, but it is %.9g", stated,
          supremum / still);
    CHECK(supremum >= (stated - 1e-7) * still, "scarp.h says %.8g, but it is %.9g", stated,
          supremum / still);

    const struct circles at_phase = circles_of(dimensions, 0), by_phase = circles_of(dimensions, 1);
    struct proof value = proof_of(dimensions, fade, &at_phase);
    prove(&value, "value", supremum, slack, dimensions == 2 ? 1e-12 : 1e-9);

    /* By the header |dn / da| <= 4 pi reach, a in turns, hence |dn / d angle| <= 2 reach. */
    struct proof derivative = proof_of(dimensions, fade, &by_phase);
    prove(&derivative, "derivative", 2.0 * supremum, slack, dimensions == 2 ? 1e-12 : 6e-3);
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
