/* SPDX-License-Identifier: MIT
 *
 * Proves the suprema of cellular noise (suprema.h) for several jitters by branch and bound
 * over the point, and that features reach them. Argument: how much the proof may add to the
 * suprema, relatively.
 */
#include "proof.h"
#include "suprema.h"

/*
 * Boxes of features are symmetric about the middle of the cell, so p in [0, 1/2]^n is enough. Cells
 * further away than two have neither the second least of the largest distances nor a feature within
 * a distance of 1.
 *
 * The distances to the nearest and to the farthest point of a box change by no more than p moves,
 * which is at most h sqrt(n) from the centre of a box of half-size h. So do the least and the
 * second least of them. The largest F2 - F1 is, over the cells that may have the nearest feature,
 * the least of the other cells' largest distances less the least distance of this one, and changes
 * by no more than twice that.
 */
enum quantity { F1, F2, EDGE, SOFT, QUANTITIES };

static const char *const names[] = {"F1", "F2", "F2 - F1", "V"};

struct cells {
    enum quantity quantity;
    double jitter;
};

#define MOST_CELLS 125

/* The cells around p, in [0, 1]^n, and how far their centres are from p along each axis. */
static int offsets_of(int dimensions, const double p[3], double offsets[MOST_CELLS][3])
{
    int count = 0;
    for (int z = dimensions == 3 ? -2 : 0; z <= (dimensions == 3 ? 2 : 0); z++) {
        for (int y = -2; y <= 2; y++) {
            for (int x = -2; x <= 2; x++, count++) {
                offsets[count][0] = x + 0.5 - p[0];
                offsets[count][1] = y + 0.5 - p[1];
                offsets[count][2] = dimensions == 3 ? z + 0.5 - p[2] : 0.0;
            }
        }
    }
    return count;
}

static double distance_bound(const struct proof *proof, const double *m, double h)
{
    const struct cells *const cells = proof->vectors;
    const double half = 0.5 * cells->jitter;
    double offsets[MOST_CELLS][3], nearest[MOST_CELLS], farthest[MOST_CELLS];
    double first = HUGE_VAL, second = HUGE_VAL, edge = 0.0;
    const int count = offsets_of(proof->dimensions, m, offsets);
    for (int c = 0; c < count; c++) {
        double near = 0.0, far = 0.0;
        for (int i = 0; i < proof->dimensions; i++) {
            const double offset = fabs(offsets[c][i]), gap = fmax(0.0, offset - half);
            near += gap * gap;
            far += (offset + half) * (offset + half);
        }
        nearest[c] = sqrt(near);
        farthest[c] = sqrt(far);
        second = fmin(second, fmax(first, farthest[c]));
        first = fmin(first, farthest[c]);
    }
    for (int c = 0; c < count; c++) {
        edge = fmax(edge, (farthest[c] > first ? first : second) - nearest[c]);
    }
    const double moved = h * sqrt(proof->dimensions);
    return cells->quantity == F1   ? first + moved
           : cells->quantity == F2 ? second + moved
                                   : edge + 2.0 * moved;
}

/*
 * V^2 is at most the sum of (1 - s)^8 over the cells, with s = sum_i e_i^2 and e_i the distance to
 * the box along axis i. This has continuous first derivatives -16 (1 - s)^7 e_i, and almost
 * everywhere the second ones 224 (1 - s)^6 e e^T less a matrix without negative eigenvalues. So on
 * a box it is at most
 *     f(m) + h sum_i |d_i f(m)| + h^2 n / 2 sum over cells of 224 (1 - s)^6 s,
 * where in the last sum 1 - s and s are the largest in the box.
 */
static double soft_bound(const struct proof *proof, const double *m, double h)
{
    const struct cells *const cells = proof->vectors;
    const int n = proof->dimensions;
    double offsets[MOST_CELLS][3], value = 0.0, slope[3] = {0.0}, curvature = 0.0;
    const int count = offsets_of(n, m, offsets);
    for (int c = 0; c < count; c++) {
        double s = 0.0, least = 0.0, most = 0.0, e[3] = {0.0};
        for (int i = 0; i < n; i++) {
            const double beyond = fabs(offsets[c][i]) - 0.5 * cells->jitter;
            const double low = fmax(0.0, beyond - h), high = fmax(0.0, beyond + h);
            e[i] = copysign(fmax(0.0, beyond), offsets[c][i]);
            s += e[i] * e[i];
            least += low * low;
            most += high * high;
        }
        const double a = fmax(0.0, 1.0 - s), a7 = pow(a, 7.0);
        value += a7 * a;
        for (int i = 0; i < n; i++) {
            slope[i] += 16.0 * a7 * e[i]; /* e shrinks as p grows */
        }
        curvature += 224.0 * pow(fmax(0.0, 1.0 - least), 6.0) * fmin(most, 1.0);
    }
    return value + h * (fabs(slope[0]) + fabs(slope[1]) + fabs(slope[2])) +
           0.5 * n * h * h * curvature;
}

static double claim_of(const struct cells *cells, int dimensions)
{
    switch (cells->quantity) {
    case F1: return cells_f1(dimensions, cells->jitter);
    case F2: return cells_f2(dimensions, cells->jitter);
    case EDGE: return cells_edge(dimensions, cells->jitter);
    default: return cells_soft(dimensions, cells->jitter);
    }
}

/* Takes the quantity of features that are at p or as near as they can be, if `near` says so, and
   else as far away as they can be. */
static double measured(const struct cells *cells, int dimensions, const double p[3], int own_near,
                       int others_near)
{
    double offsets[MOST_CELLS][3], first = HUGE_VAL, second = HUGE_VAL, sum = 0.0;
    const int count = offsets_of(dimensions, p, offsets);
    for (int c = 0; c < count; c++) {
        const int near = c == count / 2 ? own_near : others_near;
        double s = 0.0;
        for (int i = 0; i < dimensions; i++) {
            const double aside = fmin(0.5 * cells->jitter, fabs(offsets[c][i]));
            const double moved = near ? -aside : 0.5 * cells->jitter;
            const double d = offsets[c][i] + (offsets[c][i] < 0.0 ? -moved : moved);
            s += d * d;
        }
        second = fmin(second, fmax(first, s));
        first = fmin(first, s);
        sum += pow(fmax(0.0, 1.0 - s), 8.0);
    }
    return cells->quantity == F1     ? sqrt(first)
           : cells->quantity == F2   ? sqrt(second)
           : cells->quantity == EDGE ? sqrt(second) - sqrt(first)
                                     : sqrt(sum);
}

/* The largest quantity of features at the centre of a cell, at its corner, and at the corner of its
   box. */
static double reached_by(const struct cells *cells, int dimensions)
{
    const double places[3] = {0.0, 0.5 * (1.0 - cells->jitter), 0.5};
    double largest = 0.0;
    for (int place = 0; place < 3; place++) {
        const double p[3] = {places[place], places[place], places[place]};
        for (int near = 0; near < 4; near++) {
            largest = fmax(largest, measured(cells, dimensions, p, near & 1, near >> 1));
        }
    }
    return largest;
}

static void prove(enum quantity quantity, int dimensions, double jitter, double slack)
{
    const struct cells cells = {quantity, jitter};
    const double claimed = claim_of(&cells, dimensions);
    const double limit = claimed * (1.0 + slack), centre[3] = {0.25, 0.25, 0.25};
    struct proof proof = {.dimensions = dimensions,
                          .first_order = quantity == SOFT ? soft_bound : distance_bound,
                          .vectors = &cells,
                          .limit = quantity == SOFT ? limit * limit : limit};
    const int proven = proof_bounded(&proof, centre, 0.25, 0);
    const double reached = reached_by(&cells, dimensions);
    const int exact = quantity != SOFT || jitter >= CELLS_SOFT_JITTER;
    printf("supremum %dD %-7s jitter %-6g %.17g: %s within %g by %ld boxes down to 2^-%d; "
           "%.17g reached\n",
           dimensions, names[quantity], jitter, claimed, proven ? "proven" : "NOT PROVEN", slack,
           proof.boxes, proof.depth + 1, reached);
    CHECK(proven, "%.17g (1 + %g) is not a bound", claimed, slack);
    CHECK(reached <= claimed * (1.0 + 1e-14), "%.17g is reached", reached);
    CHECK(!exact || reached >= claimed * (1.0 - 1e-14), "only %.17g is reached", reached);
}

int main(int argc, char **argv)
{
    const double jitters[] = {1.0, 0.9, 0.8, 0.75, 0.65, 0.5625, 0.5, 0.3, 0.1, 0x1p-10};
    const double slack = argc > 1 ? strtod(argv[1], NULL) : 0.0;
    if (slack <= 0.0) {
        printf("usage: %s SLACK (above 0)\n", argv[0]);
        return EXIT_FAILURE;
    }
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int quantity = F1; quantity < QUANTITIES; quantity++) {
            for (size_t i = 0; i < sizeof jitters / sizeof jitters[0]; i++) {
                prove((enum quantity)quantity, dimensions, jitters[i], slack);
            }
        }
    }
    return check_done();
}
