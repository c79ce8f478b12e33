/* SPDX-License-Identifier: MIT
 *
 * Proves the suprema of simplex noise by branch and bound, that they are reached, and how large
 * second derivatives become. Argument: how much the proof may add to the suprema, relatively.
 */
#include "proof.h"
#include "suprema.h"

/*
 * Each vertex draws its gradient freely, so the supremum of n is that of
 *     S(p) = sum_v f_v(p),    f_v = w^4 max_g g . d,    d = p - v, w = max(0, r^2 - |d|^2).
 * The set of gradients is closed under a change of sign of each component, so -S is the infimum,
 * and S is symmetric about each vertex along each axis. S has the lattice's periods, too. Hence in
 * 2D 0 <= x <= 1/2, 0 <= y <= sqrt(3)/4 is enough, times the edge, and in 3D [0, 1/2]^3.
 *
 * The bound on a box with centre m and half-size h: Taylor's theorem says for every choice of
 * gradients
 *     n(p) <= n(m) + sum_i |p_i - m_i| |d_i n(m)| + |p - m|^2 / 2 max |H|.
 * Like proof.h says, the first two are at most the largest sum over vertices of the largest
 * f + h sum_i s_i d_i f over gradients, over the 2^n choices of signs s. The third is at most
 * h^2 n / 2 times the sum over vertices of the largest norm of
 *     H_ij = 48 w^2 q d_i d_j - 8 w^3 (g_i d_j + d_i g_j + q I_ij),    q = g . d,
 * in the box. Along unit vectors that is at most |g| (48 w^2 |d|^3 + 24 w^3 |d|).
 *
 * Second derivatives with respect to two axes are H_ij, with the largest over gradients for each
 * vertex; from m to a point of the box they grow by at most h sqrt(n) times the third derivatives
 *     -192 w q d_i d_j d_k + 48 w^2 (g_i d_j d_k + g_j d_i d_k + g_k d_i d_j)
 *     + 48 w^2 q (d_i I_jk + d_j I_ik + d_k I_ij) - 8 w^3 (g_i I_jk + g_j I_ik + g_k I_ij),
 * which along unit vectors is at most |g| (192 w |d|^4 + 288 w^2 |d|^2 + 24 w^3). For w the largest
 * in the box serves, and for |d| too.
 */
#define MOST_VERTICES 64
#define MOST_BOXES 4000000

struct field {
    const struct simplex *simplex;
    int vertices, rows, columns; /* rows and columns of the second derivative */
    double vertex[MOST_VERTICES][3], gradient[24][3], length;
};

static void draw_gradients(struct field *field)
{
    const int count = field->simplex->directions;
    for (int k = 0; k < count; k++) {
        double *const g = field->gradient[k];
        memset(g, 0, sizeof field->gradient[k]);
        if (count == 12) {
            g[k / 4] = k & 1 ? -1.0 : 1.0;
            g[(k / 4 + 1) % 3] = k & 2 ? -1.0 : 1.0;
        } else {
            const double angle = (k + 0.5) * 2.0 * acos(-1.0) / count;
            g[0] = cos(angle);
            g[1] = sin(angle);
        }
    }
    field->length = count == 12 ? sqrt(2.0) : 1.0;
}

/* Checks that the set of gradients is closed under a change of sign of each component. */
static void check_mirrored(const struct field *field)
{
    const int count = field->simplex->directions;
    for (int k = 0; k < count * field->simplex->dimensions; k++) {
        double nearest = HUGE_VAL;
        for (int other = 0; other < count; other++) {
            double distance = 0.0;
            for (int i = 0; i < 3; i++) {
                const double g = field->gradient[k % count][i];
                distance += fabs(field->gradient[other][i] - (i == k / count ? -g : g));
            }
            nearest = fmin(nearest, distance);
        }
        CHECK(nearest < 1e-14, "gradient %d has no mirror image along axis %d", k % count,
              k / count);
    }
}

/* Collects the vertices that reach into [0, 1/2]^n times the edge. */
static void place_vertices(struct field *field)
{
    const struct simplex *const s = field->simplex;
    field->vertices = 0;
    for (int k = s->dimensions == 3 ? -2 : 0; k <= (s->dimensions == 3 ? 3 : 0); k++) {
        for (int j = -2; j <= 3; j++) {
            for (int i = -2; i <= 3; i++) {
                /* In 3D each layer of cubes along z counts double: its corners and its centres. */
                const double shift = s->dimensions == 3 ? 0.5 * (k & 1) : 0.5 * (j & 1);
                const double v[3] = {i + shift, s->dimensions == 3 ? j + shift : sqrt(0.75) * j,
                                     0.5 * k};
                double outside = 0.0;
                for (int axis = 0; axis < s->dimensions; axis++) {
                    const double beyond = fmax(0.0, fmax(v[axis] - 0.5, -v[axis])) * s->edge;
                    outside += beyond * beyond;
                }
                if (outside < s->square) {
                    CHECK(field->vertices < MOST_VERTICES, "too many vertices");
                    for (int axis = 0; axis < 3; axis++) {
                        field->vertex[field->vertices][axis] = v[axis] * s->edge;
                    }
                    field->vertices++;
                }
            }
        }
    }
}

/* A vertex and a box around m: d, w and the square of d at m, and the largest w and |d| in it. */
struct reach {
    double d[3], square, w, most_w, most_d;
};

static struct reach reach_of(const struct field *field, int vertex, const double m[3], double h)
{
    struct reach r = {{0.0}, 0.0, 0.0, 0.0, 0.0};
    double least = 0.0, most = 0.0;
    for (int i = 0; i < field->simplex->dimensions; i++) {
        r.d[i] = m[i] - field->vertex[vertex][i];
        const double nearest = fmax(0.0, fabs(r.d[i]) - h), farthest = fabs(r.d[i]) + h;
        r.square += r.d[i] * r.d[i];
        least += nearest * nearest;
        most += farthest * farthest;
    }
    r.w = fmax(0.0, field->simplex->square - r.square);
    r.most_w = fmax(0.0, field->simplex->square - least);
    r.most_d = sqrt(fmin(most, field->simplex->square)); /* farther out f is 0 */
    return r;
}

/* Adds the largest f + h sum_i s_i d_i f of a vertex to `sums`, for each choice of signs s. */
static void add_first_order(const struct field *field, const struct reach *r, double h,
                            double sums[8])
{
    const int n = field->simplex->dimensions;
    const double w3 = r->w * r->w * r->w, w4 = w3 * r->w;
    double best[8] = {0.0};
    for (int k = 0; k < field->simplex->directions; k++) {
        const double *const g = field->gradient[k];
        const double q = g[0] * r->d[0] + g[1] * r->d[1] + g[2] * r->d[2];
        double along[3];
        for (int i = 0; i < n; i++) {
            along[i] = h * (w4 * g[i] - 8.0 * w3 * q * r->d[i]);
        }
        for (int signs = 0; signs < 1 << n; signs++) {
            double term = w4 * q;
            for (int i = 0; i < n; i++) {
                term += signs >> i & 1 ? along[i] : -along[i];
            }
            best[signs] = k == 0 ? term : fmax(best[signs], term);
        }
    }
    for (int signs = 0; signs < 1 << n; signs++) {
        sums[signs] += best[signs];
    }
}

/* A bound for S in the box; with h = 0 this is S(m). */
static double value_bound(const struct proof *proof, const double *m, double h)
{
    const struct field *const field = proof->vectors;
    const int n = proof->dimensions;
    double sums[8] = {0.0}, curvature = 0.0, largest = -HUGE_VAL;
    for (int v = 0; v < field->vertices; v++) {
        const struct reach r = reach_of(field, v, m, h);
        if (r.w > 0.0) {
            add_first_order(field, &r, h, sums);
        }
        curvature += r.most_w * r.most_w * r.most_d *
                     (48.0 * r.most_d * r.most_d + 24.0 * r.most_w) * field->length;
    }
    for (int signs = 0; signs < 1 << n; signs++) {
        largest = fmax(largest, sums[signs]);
    }
    return largest + 0.5 * n * h * h * curvature;
}

/* A bound for |H_ij| in the box, for the axes of the field; with h = 0 its largest value in m. */
static double second_bound(const struct proof *proof, const double *m, double h)
{
    const struct field *const field = proof->vectors;
    const int i = field->rows, j = field->columns;
    if (proof->boxes > MOST_BOXES) {
        return HUGE_VAL; /* gives up: the limit is wrong, or too close */
    }
    double sum = 0.0;
    for (int v = 0; v < field->vertices; v++) {
        const struct reach r = reach_of(field, v, m, h);
        const double w2 = r.w * r.w, w3 = w2 * r.w, most_d2 = r.most_d * r.most_d;
        double best = 0.0;
        for (int k = 0; k < field->simplex->directions; k++) {
            const double *const g = field->gradient[k];
            const double q = g[0] * r.d[0] + g[1] * r.d[1] + g[2] * r.d[2];
            best = fmax(best, 48.0 * w2 * q * r.d[i] * r.d[j] -
                                  8.0 * w3 * (g[i] * r.d[j] + r.d[i] * g[j] + (i == j ? q : 0.0)));
        }
        const double third =
            192.0 * most_d2 * most_d2 + 288.0 * r.most_w * most_d2 + 24.0 * r.most_w * r.most_w;
        sum += best + h * sqrt(proof->dimensions) * r.most_w * third * field->length;
    }
    return sum;
}

static void prove_supremum(struct field *field, double slack)
{
    const struct simplex *const s = field->simplex;
    struct proof proof = {.dimensions = s->dimensions,
                          .first_order = value_bound,
                          .vectors = field,
                          .limit = s->supremum * (1.0 + slack)};
    const double quarter = 0.25 * s->edge, centre[3] = {quarter, quarter, quarter};
    const int proven = proof_bounded(&proof, centre, quarter, 0);
    double p[3];
    memcpy(p, s->at, sizeof p);
    const double reached = proof_climb(&proof, p, 0x1p-14);
    printf("supremum %-12s %.17g = 1 / %.17g: %s within %g by %ld boxes down to 2^-%d; reached "
           "within %.0e at (%.8f, %.8f, %.8f)\n",
           s->name, s->supremum, 1.0 / s->supremum, proven ? "proven" : "NOT PROVEN", slack,
           proof.boxes, proof.depth + 1, fabs(1.0 - reached / s->supremum), p[0], p[1], p[2]);
    CHECK(proven, "%.17g (1 + %g) is not a bound", s->supremum, slack);
    CHECK(reached >= s->supremum * (1.0 - 1e-13), "only %.17g is reached", reached);
    for (int i = 0; i < s->dimensions; i++) {
        CHECK(fabs(p[i] - s->at[i]) <= 1e-6, "the maximum is at %.17g, not %.17g", p[i], s->at[i]);
    }
}

static void prove_second(struct field *field)
{
    const struct simplex *const s = field->simplex;
    struct proof proof = {.dimensions = s->dimensions,
                          .first_order = second_bound,
                          .vectors = field,
                          .limit = s->supremum * s->second};
    const double quarter = 0.25 * s->edge, centre[3] = {quarter, quarter, quarter};
    CHECK(s->second < 64.0, "%g suprema is more than check.c supposes", s->second);
    for (field->rows = 0; field->rows < s->dimensions; field->rows++) {
        for (field->columns = 0; field->columns <= field->rows; field->columns++) {
            const int proven = proof_bounded(&proof, centre, quarter, 0);
            CHECK(proven, "%s: d_%d%d exceeds %g suprema", s->name, field->rows, field->columns,
                  s->second);
        }
    }
    printf("second derivatives %s: below %g suprema, by %ld boxes down to 2^-%d\n", s->name,
           s->second, proof.boxes, proof.depth + 1);
}

int main(int argc, char **argv)
{
    const double slack = argc > 1 ? strtod(argv[1], NULL) : 0.0;
    if (slack <= 0.0) {
        printf("usage: %s SLACK (above 0)\n", argv[0]);
        return EXIT_FAILURE;
    }
    for (size_t i = 0; i < sizeof simplices / sizeof simplices[0]; i++) {
        struct field field = {.simplex = &simplices[i]};
        draw_gradients(&field);
        check_mirrored(&field);
        place_vertices(&field);
        prove_supremum(&field, slack);
        if (simplices[i].second > 0.0) {
            prove_second(&field);
        }
    }
    return check_done();
}
