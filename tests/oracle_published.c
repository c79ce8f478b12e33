/* SPDX-License-Identifier: MIT
 *
 * Somebody else's numbers. The oracle's formulas of simplex noise, of gradients that turn, of
 * periods and of nearest features are fed with what other authors draw from, and must give the
 * numbers that those authors published or that their programs print. (oracle_check.c does so with
 * improved noise.) Each number is named with its source.
 */
#include "check.h"
#include "oracle.h"

#define TURN (2.0 * 3.14159265358979323846)
#define WHOLE (INT64_C(1) << 32) /* no period */

/* Splits a point into cell and fractions. */
static void place(const struct oracle_lattice *lattice, const double *x, uint32_t cell[3],
                  double t[3])
{
    for (int i = 0; i < 3; i++) {
        cell[i] = 0;
        t[i] = 0.0;
    }
    for (int i = 0; i < lattice->dimensions; i++) {
        cell[i] = oracle_inside_period(floor(x[i]), lattice->period[i]);
        t[i] = x[i] - floor(x[i]);
    }
}

/*
 * psrdnoise (S. Gustavson and I. McEwan, "Tiling simplex noise and flow noise in two and three
 * dimensions", JCGT 11(1), 2022; MIT licence). The lattice has the oracle's vertices, but rows 1
 * apart in 2D. The numbers are what src/psrddnoise2.glsl and src/psrdnoise3.glsl of version
 * 2021-12-02 (repository stegu/psrdnoise, commit b169834) return where all arithmetic is in double.
 */
struct psrdnoise {
    struct oracle_lattice lattice;
    double alpha; /* in radians */
};

static double modulo(double a, double b)
{
    return a - b * floor(a / b);
}

/* The column, row and layer of a vertex, within the periods. */
static void wrap(const struct oracle_lattice *lattice, const uint32_t cell[3], const int step[3],
                 double wrapped[3])
{
    for (int i = 0; i < lattice->dimensions; i++) {
        const uint32_t inside = oracle_stepped(lattice, i, cell[i], step[i]);
        const int negative = lattice->period[i] == WHOLE && inside >= 0x80000000u;
        wrapped[i] = (double)inside - (negative ? 0x1p32 : 0.0);
    }
}

/* The vertex (x, row) has the skewed coordinates (x + row / 2, row). */
static void draw_psrdnoise2(const void *opaque, const uint32_t cell[3], const int step[3],
                            int centre, double gradient[3])
{
    const struct psrdnoise *const psrdnoise = opaque;
    double v[3], derivative[3];
    (void)centre;
    wrap(&psrdnoise->lattice, cell, step, v);
    const double u = v[0] + (v[1] + modulo(v[1], 2.0)) / 2.0;
    double hash = modulo(u, 289.0);
    hash = modulo((51.0 * hash + 2.0) * hash + v[1], 289.0);
    hash = modulo((34.0 * hash + 10.0) * hash, 289.0);
    oracle_turn_in_plane(0.07482 * hash, 1.0, psrdnoise->alpha / TURN, gradient, derivative);
}

static double permute(double a)
{
    const double b = modulo(a, 289.0);
    return modulo((34.0 * b + 10.0) * b, 289.0);
}

/* The direction s on a Fibonacci spiral turns towards q: q' on the equator, at the angle psi, goes
   with the turn that takes the pole to s. The axis is s x q. */
static void draw_psrdnoise3(const void *opaque, const uint32_t cell[3], const int step[3],
                            int centre, double gradient[3])
{
    const struct psrdnoise *const psrdnoise = opaque;
    double v[3], derivative[3];
    wrap(&psrdnoise->lattice, cell, step, v);
    const double x = v[0] + 0.5 * centre, y = v[1] + 0.5 * centre, z = v[2] + 0.5 * centre;
    const double hash = permute(permute(permute(x + y) + x + z) + y + z);
    const double theta = 3.883222077 * hash, psi = 0.108705628 * hash;
    const double up = 0.996539792 - 0.006920415 * hash, out = sqrt(1.0 - up * up);
    const double s[3] = {cos(theta) * out, sin(theta) * out, up};
    const double apart = cos(psi) * cos(theta) - sin(psi) * sin(theta); /* cos(psi + theta) */
    const double q[3] = {sin(psi) * up - (1.0 - up) * apart * sin(theta),
                         cos(psi) * up + (1.0 - up) * apart * cos(theta),
                         -(s[1] * cos(psi) + s[0] * sin(psi))};
    double axis[3];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        axis[i] = s[j] * q[k] - s[k] * q[j];
    }
    oracle_turn_about(axis, s, 1.0, psrdnoise->alpha / TURN, gradient, derivative);
}

/* The point; the periods, where 0 is none; alpha; the value, the gradient, and in 2D the second
   derivatives with respect to xx, yy and xy. */
static const double in_plane[][11] = {
    {0.3, 0.4, 0.0, 0.0, 0.0, 0.11990391218472954, -1.0209270670331263, -3.529715035419175,
     -9.186202228274643, -6.965376761764646, -2.442800588132344},
    {-7.21, 5.37, 0.0, 0.0, 0.0, 0.355318984460464, -1.2107607104553153, -3.595027800286073,
     -8.581916800579299, -10.99331331060101, -4.816792588751814},
    {12.6, -40.9, 0.0, 0.0, 0.7, -0.21344559051057424, 1.7974776144718172, -3.49409641083786,
     -1.2172832111544687, 9.637227609993687, 2.020786655721315},
    {2.9, 3.85, 0.0, 0.0, 2.5, 0.678441770848142, -1.0666009146241422, -2.279674949038257,
     -10.216633492717468, -16.273469497459217, -5.425950384358193},
    {-100.2, -33.3, 0.0, 0.0, -1.3, -0.6383231195226071, 1.636723139262412, -1.7984809896971239,
     17.15328729542571, 10.822254964843282, -0.2559541862209904},
    {2.9, 3.85, 3.0, 4.0, 0.0, -0.37821611957382856, 3.3879294098632813, -0.5913476788125003,
     11.518759346250011, 3.2488808412500045, 5.451185443124997},
    {-0.1, -0.15, 3.0, 4.0, 0.0, -0.3782161195738283, 3.387929409863282, -0.5913476788125002,
     11.518759346250004, 3.248880841250001, 5.451185443125001},
    {5.9, -4.15, 3.0, 4.0, 0.0, -0.3782161195738267, 3.3879294098632835, -0.5913476788124992,
     11.51875934624996, 3.2488808412499846, 5.4511854431250155},
    {-13.45, 7.6, 5.0, 2.0, 1.1, -0.15749263980414527, 1.4554697359738036, 2.923233006391686,
     -3.318973548144596, -2.9862097418634534, 4.080262715693439},
    {1.25, 100.75, 7.0, 0.0, 4.0, -0.5347996118958814, 0.4359081857172796, -1.910736385504607,
     19.185937965684943, 8.788370831425626, 3.8227950838158624},
};
static const double in_space[][11] = {
    {0.3, 0.4, 0.2, 0.0, 0.0, 0.0, 0.0, -0.3033309252264459, -0.8077080026829329,
     -0.14001228742137903, -1.992590897401057},
    {-7.21, 5.37, 1.63, 0.0, 0.0, 0.0, 0.0, 0.03905895966352684, 0.4637493416072343,
     -0.5605158362572189, 3.282681241244451},
    {12.6, -40.9, 3.15, 0.0, 0.0, 0.0, 0.7, -0.5384208097326364, -3.0186092683194725,
     -1.3700947980826257, -0.9971787947133925},
    {2.9, 3.85, -8.4, 0.0, 0.0, 0.0, 2.5, -0.35491084900891157, 0.6023304300884103,
     0.09180602760908815, -1.7440456024308453},
    {2.9, 3.85, 1.7, 3.0, 4.0, 2.0, 0.0, -0.6506211316520917, -0.7397107324434972,
     -1.6787482517353125, -1.1398509207239587},
    {-0.1, -0.15, -0.3, 3.0, 4.0, 2.0, 0.0, -0.6506211316520916, -0.7397107324434964,
     -1.6787482517353134, -1.139850920723957},
    {5.9, -4.15, 7.7, 3.0, 4.0, 2.0, 0.0, -0.6506211316520917, -0.7397107324434933,
     -1.678748251735317, -1.139850920723953},
    {-13.45, 7.6, 2.05, 5.0, 2.0, 7.0, 1.1, -0.01259306364532121, 1.2243408141184586,
     1.453697731051367, -0.7640156435168576},
    {1.25, 100.6, -3.3, 7.0, 0.0, 1.0, -4.0, -0.1862753693191311, -1.2155206212824858,
     -1.1267830645708823, 1.9050887941217245},
};

static void compare(const double row[11], int dimensions, double turns)
{
    const int d = dimensions;
    const double alpha = row[2 * d] + TURN * turns, *const expected = &row[2 * d + 1];
    int64_t period[3];
    for (int i = 0; i < d; i++) {
        period[i] = row[d + i] == 0.0 ? WHOLE : (int64_t)row[d + i];
    }
    const struct psrdnoise psrdnoise = {{.period = period, .dimensions = d}, alpha};
    const struct oracle_simplex simplex = {
        .dimensions = d,
        .row = 1.0,
        .square = d == 2 ? 0.8 : 0.5,
        .power = d == 2 ? 4.0 : 3.0,
        .draw = d == 2 ? draw_psrdnoise2 : draw_psrdnoise3,
        .lattice = &psrdnoise,
    };
    const double scale = d == 2 ? 10.9 : 39.5;
    uint32_t cell[3];
    double t[3];
    struct oracle_sample n;
    place(&psrdnoise.lattice, row, cell, t);
    oracle_simplex_sum(&simplex, cell, t, &n);
    double worst = fabs(scale * n.value - expected[0]);
    for (int i = 0; i < d; i++) {
        worst = larger(worst, fabs(scale * n.gradient[i] - expected[1 + i]));
    }
    if (d == 2) {
        worst = larger(worst, fabs(scale * n.hessian[0][0] - expected[3]));
        worst = larger(worst, fabs(scale * n.hessian[1][1] - expected[4]));
        worst = larger(worst, fabs(scale * n.hessian[0][1] - expected[5]));
    }
    CHECK(worst <= 1e-11, "psrdnoise %dD (%g, %g, ...), alpha %g: off by %g", d, row[0], row[1],
          alpha, worst);
}

static void check_psrdnoise(void)
{
    for (int turns = -1; turns <= 1; turns++) {
        for (size_t i = 0; i < sizeof in_plane / sizeof in_plane[0]; i++) {
            compare(in_plane[i], 2, turns);
        }
        for (size_t i = 0; i < sizeof in_space / sizeof in_space[0]; i++) {
            compare(in_space[i], 3, turns);
        }
    }
}

/*
 * stb_perlin 0.5 (S. Barrett; public domain): stb_perlin_noise3_wrap_nonpow2 with the periods
 * 5, 3, 7 and the seed 9 (repository nothings/stb, commit 2bb4a0a), where all arithmetic is in
 * double. Its hash is not asked: `drawn` is the gradient of each lattice point of one period,
 * layer by layer along z, five of each row. Periods are the oracle's.
 */
static const int64_t stb_period[3] = {5, 3, 7};

static void draw_stb(const void *opaque, const uint32_t point[3], double corner[3])
{
    static const char drawn[7][16] = {"02024a194704398", "b517833992b1831", "171834b2a253191",
                                      "6907027536ab8b5", "917b04772b35910", "3769a9296523686",
                                      "929a6a1135349aa"};
    uint32_t inside[3];
    for (int i = 0; i < 3; i++) {
        inside[i] = oracle_stepped(opaque, i, point[i], 0);
    }
    const char digit[2] = {drawn[inside[2]][5 * inside[1] + inside[0]], '\0'};
    const int number = (int)strtol(digit, NULL, 16);
    const int across = 2 - number / 4; /* edges of a cube across z, y, x; two bits are signs */
    const int first = across == 0 ? 1 : 0, second = across == 2 ? 1 : 2;
    corner[across] = 0.0;
    corner[first] = number & 1 ? -1.0 : 1.0;
    corner[second] = number & 2 ? -1.0 : 1.0;
}

static void check_stb(void)
{
    static const struct {
        double x[3], value;
    } published[] = {
        {{0.25, 0.5, 0.75}, 0.052642345428466797},
        {{4.75, 2.5, 6.125}, 0.21230650693178177}, /* across all three seams */
        {{-0.25, -0.5, -0.75}, 0.211181640625},
        {{-23.1875, 47.3125, -88.5625}, 0.024861963226311068},
        {{1000.625, -1000.375, 999.9375}, -0.02716843381666445},
        {{5.0, 3.0, 7.5}, 0.25},
        {{-5.5, -3.0, 0.0625}, 0.031180679798126221},
        {{2.3125, 1.6875, 3.4375}, 0.005535549486096282},
        {{9.8125, 2.0625, -0.9375}, 0.12020036693980111},
    };
    const struct oracle_lattice lattice = {.period = stb_period, .dimensions = 3};
    for (size_t i = 0; i < sizeof published / sizeof published[0]; i++) {
        const double *const x = published[i].x;
        uint32_t cell[3];
        double t[3];
        struct oracle_sample n;
        place(&lattice, x, cell, t);
        oracle_gradient_noise(draw_stb, &lattice, 3, SCARP_QUINTIC, cell, t, &n);
        CHECK(fabs(n.value - published[i].value) <= 1e-14,
              "stb_perlin (%g, %g, %g): %.17g, published %.17g", x[0], x[1], x[2], n.value,
              published[i].value);
    }
}

/*
 * OpenSimplex2 (K. Spencer; CC0; repository KdotJPG/OpenSimplex2, commit e09a947, java/) divides by
 * the largest value of its noise, and states it. Vertices draw their gradients freely, so it is the
 * largest sum where each vertex has its best gradient. The triangles have the edge sqrt(2/3) and
 * r^2 = 1/2, in the smoother variant 2/3: with edges of 1, that is 3/4, as in scarp, and 1, and the
 * values are (2/3)^-4.5 times as large. In 3D the smoother variant has r^2 = 3/4. (The faster one
 * in 3D leaves out vertices that are in reach.)
 */
struct free_lattice {
    double row, t[3]; /* the point */
    int dimensions;
};

/* The 24 directions 7.5 degrees + k * 15; in 3D 48 vectors of one length, with the components
   (a, a, 1) and (b, c, 0) in any order and with any signs. a = 1 + sqrt(3/2). */
static void opensimplex_vector(int dimensions, int number, double vector[3])
{
    if (dimensions == 2) {
        const double angle = (number + 0.5) * TURN / 24.0;
        vector[0] = cos(angle);
        vector[1] = sin(angle);
        vector[2] = 0.0;
        return;
    }
    static const double a = 2.22474487139, b = 3.0862664687972017, c = 1.1721513422464978;
    const int axis = number % 3, kind = number / 3 % 2, signs = number / 6;
    const double first = kind == 0 ? a : signs & 4 ? b : c;
    const double second = kind == 0 ? a : signs & 4 ? c : b;
    vector[(axis + 1) % 3] = signs & 1 ? -first : first;
    vector[(axis + 2) % 3] = signs & 2 ? -second : second;
    vector[axis] = kind == 1 ? 0.0 : signs & 4 ? -1.0 : 1.0;
}

static void draw_best(const void *opaque, const uint32_t cell[3], const int step[3], int centre,
                      double gradient[3])
{
    const struct free_lattice *const lattice = opaque;
    double most = -HUGE_VAL;
    const int odd_row = lattice->dimensions == 2 && (cell[1] + (uint32_t)step[1]) % 2 == 1;
    const double d[3] = {lattice->t[0] - (step[0] + (centre || odd_row ? 0.5 : 0.0)),
                         (lattice->t[1] - (step[1] + (centre ? 0.5 : 0.0))) * lattice->row,
                         lattice->dimensions == 3 ? lattice->t[2] - (step[2] + (centre ? 0.5 : 0.0))
                                                  : 0.0};
    for (int number = 0; number < (lattice->dimensions == 2 ? 24 : 48); number++) {
        double v[3];
        opensimplex_vector(lattice->dimensions, number, v);
        const double q = v[0] * d[0] + v[1] * d[1] + v[2] * d[2];
        if (q > most) {
            most = q;
            memcpy(gradient, v, sizeof v);
        }
    }
}

static double largest_at(int dimensions, double square, const double t[3])
{
    static const uint32_t cell[3] = {0, 0, 0};
    struct oracle_simplex simplex = oracle_simplex_own(dimensions);
    const struct free_lattice lattice = {
        .row = simplex.row, .t = {t[0], t[1], t[2]}, .dimensions = dimensions};
    simplex.square = square != 0.0 ? square : simplex.square;
    simplex.draw = draw_best;
    simplex.lattice = &lattice;
    struct oracle_sample n;
    oracle_simplex_sum(&simplex, cell, t, &n);
    return n.value;
}

/* Climbs from t in steps along the axes, which become smaller. */
static double climb(int dimensions, double square, double t[3])
{
    double most = largest_at(dimensions, square, t);
    for (double step = 0x1p-5; step > 0x1p-22; step /= 2.0) {
        for (int better = 1; better;) {
            better = 0;
            for (int way = 0; way < 2 * dimensions; way++) {
                double next[3] = {t[0], t[1], t[2]};
                next[way / 2] = fmin(1.0, fmax(0.0, next[way / 2] + (way % 2 ? -step : step)));
                const double value = largest_at(dimensions, square, next);
                if (value > most) {
                    most = value;
                    memcpy(t, next, sizeof next);
                    better = 1;
                }
            }
        }
    }
    return most;
}

static void check_opensimplex(void)
{
    static const struct {
        const char *name;
        int dimensions, starts;   /* along each axis of half a cell */
        double square, published; /* r^2, or 0 for that of scarp */
    } of[] = {
        {"OpenSimplex2 2D", 2, 6, 0.0, 0.01001634121365712},
        {"OpenSimplex2S 2D", 2, 6, 1.0, 0.05481866495625118},
        {"OpenSimplex2S 3D", 3, 3, 0.75, 0.2781926117527186},
    };
    for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) {
        double most = 0.0;
        const int starts = of[i].starts, d = of[i].dimensions;
        for (int start = 0; start < (d == 2 ? starts * starts : starts * starts * starts);
             start++) {
            double t[3] = {(start % starts + 0.5) / starts / 2.0,
                           (start / starts % starts + 0.5) / starts / 2.0,
                           d == 3 ? (start / starts / starts + 0.5) / starts / 2.0 : 0.0};
            most = fmax(most, climb(d, of[i].square, t));
        }
        const double scale = d == 2 ? pow(2.0 / 3.0, 4.5) : 1.0;
        printf("%-17s largest value %.15f, published %.15f\n", of[i].name, scale * most,
               of[i].published);
        CHECK(fabs(scale * most / of[i].published - 1.0) <= 1e-11, "%s: %.17g, published %.17g",
              of[i].name, scale * most, of[i].published);
    }
}

int main(void)
{
    check_psrdnoise();
    check_stb();
    check_opensimplex();
    return check_done();
}
