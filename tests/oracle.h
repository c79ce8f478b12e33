/* SPDX-License-Identifier: MIT
 *
 * The oracle: scarp's noise again, in double precision, from the published closed forms and the
 * definition in scarp.h. It shares no code with src/. oracle.c has what scarp defines (lattice,
 * octaves), oracle_basis.c, oracle_simplex.c and oracle_cells.c the published formulas of an
 * octave, oracle_fractal.c the fractals. oracle_check.c and oracle_published.c feed the same
 * formulas with what other authors draw from; oracle_perlin.c is one such lattice.
 */
#ifndef SCARP_TESTS_ORACLE_H
#define SCARP_TESTS_ORACLE_H

#include "octaves.h"

#define ORACLE_OCTAVES 32

/* What is rounded to float before the double arithmetic begins. The position of a point decides
   which function value is asked for; reproducing how the calls round it leaves the error of the
   evaluation as the only difference. */
enum oracle_rounding {
    ORACLE_EXACT, /* nothing: p_k and its fraction are double */
    ORACLE_F32,   /* as the float calls: J_k, o_k, every operation of p_k, and the fraction */
    ORACLE_F64 /* as the _f64 calls: p_k is double, its fraction is rounded to float; where axes are
                  turned, both parts of p_k are rounded to multiples of 2^-24 */
};

/* Value, gradient and Hessian, the derivative with respect to the phase, and that of the gradient,
   which only octaves have. In 2D whatever has a z is 0, and so is the Hessian of erosion. */
struct oracle_sample {
    double value, gradient[3], hessian[3][3];
    double phase, gradient_phase[3];
    /* Of simplex and cellular noise in an octave's own axes: how far p is, at least, from where a
       derivative jumps that differences see; and the distance of the nearest feature, or 1 where
       that is more or no derivative has a pole there. Sums do not have them. */
    double clearance, nearest;
};

struct oracle_octave {
    struct octave of;
    int64_t period[3]; /* in cells of this octave; 2^32 without one */
    double gradient[16][3],
        turning[16][3]; /* what the lattice draws from; with respect to the phase */
};

struct oracle {
    enum scarp_basis basis;
    enum scarp_fade fade;
    enum scarp_fractal fractal;
    double erosion, jitter, sharpness;
    int dimensions, octaves;
    int component;   /* of vector noise whose components draw from one lattice; else 0 */
    double supremum; /* of |basis - middle|, which scarp divides by */
    double middle;   /* what it subtracts before */
    struct oracle_octave octave[ORACLE_OCTAVES];
};

/* A drawn lattice: the gradient at an integer point, or in corner[0] the value. Coordinates are
   modulo 2^32; in 2D point[2] is 0. */
typedef void oracle_draw(const void *lattice, const uint32_t point[3], double corner[3]);

/* An octave's lattice, as scarp's oracle_draw functions get it. */
struct oracle_lattice {
    const uint32_t *key;
    const int64_t *period;
    int dimensions;
    int component; /* of the oracle */
    const double (*gradient)[3];
};

/* The number h that the axes of the cell `step` from `cell` mix to, and the hash h (h + K). Periods
   are minded. */
uint32_t oracle_mixed(const struct oracle_lattice *lattice, const uint32_t cell[3],
                      const int step[3]);
uint32_t oracle_hash(uint32_t mixed);

/* The cell `steps` further along an axis, and the cell with this number, within the period. */
uint32_t oracle_stepped(const struct oracle_lattice *lattice, int axis, uint32_t cell, int steps);
uint32_t oracle_inside_period(double cell, int64_t period);

/* The gradient that a hash draws. */
const double *oracle_gradient_drawn(const struct oracle_lattice *lattice, uint32_t hash);

/* The supremum of |gradient noise| by which scarp divides. test_range.c proves it. */
double oracle_gradient_supremum(int dimensions, enum scarp_fade fade);

/* The supremum of the distances that cellular noise is made of: oracle_cells.c. */
double oracle_cells_supremum(enum scarp_basis basis, int dimensions, double jitter);

/* How many gradients there are, and number `index` of them: in 3D edges (1, 1, 0), half as long as
   scarp's, which it divides by twice the supremum. */
int oracle_gradient_count(int dimensions);
void oracle_gradient_vector(int dimensions, unsigned index, double vector[3]);

/* The same after `turns` of a vector of speed 1, and its derivative with respect to `turns`:
   oracle_phase.c. */
void oracle_gradient_turned(int dimensions, unsigned index, double turns, double vector[3],
                            double derivative[3]);

/* What that is made of: the direction at this angle after `turns` at this speed; and a vector
   across the axis, of length 1, that turns about it. */
void oracle_turn_in_plane(double still, double speed, double turns, double vector[3],
                          double derivative[3]);
void oracle_turn_about(const double axis[3], const double still[3], double speed, double turns,
                       double vector[3], double derivative[3]);

/* The value that the lattice of octave k draws at an integer point, in [-1, 1). */
double oracle_lattice_value(const struct oracle *oracle, int k, const uint32_t point[3]);

void oracle_make(struct oracle *oracle, const struct scarp_noise *noise, int dimensions);

/* Likewise of a component of vector noise, without the warp of the noise. */
void oracle_make_component(struct oracle *oracle, const struct scarp_noise *noise, int dimensions,
                           int component);

void oracle_evaluate(const struct oracle *oracle, enum oracle_rounding rounding, const double x[3],
                     struct oracle_sample *sum);

/* Octave k at x, scaled so that |value| reaches 1; derivatives with respect to p_k. */
void oracle_octave_at(const struct oracle *oracle, enum oracle_rounding rounding, int k,
                      const double x[3], struct oracle_sample *n);

/* Where the creases are: of turbulence and ridged n_k = 0, and for ridged 2 s_k = 1; of ping-pong
   where t is an integer; of hybrid where the weight is clamped; of Swiss noise n_k = 0, |n_k| = 1,
   and where what octaves are multiplied by is clamped. */
struct oracle_creases {
    double clearance; /* the smallest |n_k|, and for ridged |2 s_k - 1|, and so on; HUGE_VAL without
                         creases */
    uint64_t side;    /* which side of each crease: bit k for n_k < 0, bit 32 + k for 2 s_k >= 1 */
    double border;    /* the smallest clearance of any octave's sample, see above */
    double nearest;   /* and the smallest distance of a feature */
};

/* oracle_fractal.c: like oracle_evaluate, but fills *creases too. */
void oracle_evaluate_creased(const struct oracle *oracle, enum oracle_rounding rounding,
                             const double x[3], struct oracle_sample *sum,
                             struct oracle_creases *creases);

/* oracle_fractal.c: the gradient of erosion as others compute it, with the q_k taken as constants:
   sum a_k q_k G_k; that of the fractals that bend with the S_k taken as constants. */
void oracle_frozen_gradient(const struct oracle *oracle, enum oracle_rounding rounding,
                            const double x[3], double gradient[3]);

/* A lower bound of the distance from x to the nearest lattice plane of any octave, in the units of
   x. */
double oracle_clearance(const struct oracle *oracle, const double x[3]);

/* oracle_basis.c: one octave on a cell of a lattice, t being the position inside, in [0, 1]. */
void oracle_value_noise(oracle_draw *draw, const void *lattice, int dimensions,
                        enum scarp_fade fade, const uint32_t cell[3], const double t[3],
                        struct oracle_sample *n);
void oracle_gradient_noise(oracle_draw *draw, const void *lattice, int dimensions,
                           enum scarp_fade fade, const uint32_t cell[3], const double t[3],
                           struct oracle_sample *n);

/* oracle_simplex.c, oracle_cells.c: the same on scarp's lattice. In 2D simplex noise, cells along y
   are rows of triangles, and so is t; derivatives are by p. */
void oracle_simplex_noise(const struct oracle_lattice *lattice, const uint32_t cell[3],
                          const double t[3], struct oracle_sample *n);
void oracle_cell_noise(const struct oracle_lattice *lattice, enum scarp_basis basis, double jitter,
                       const uint32_t cell[3], const double t[3], struct oracle_sample *n);

/* Simplex noise as authors differ in it: rows of triangles with edge 1 are `row` apart, in 3D there
   are the corners and the centres of cubes; kernels are (square - d.d)^power. `draw` is the
   gradient of the vertex `step` from a cell, the centre of that cube where `centre` is 1. */
typedef void oracle_draw_vertex(const void *lattice, const uint32_t cell[3], const int step[3],
                                int centre, double gradient[3]);
struct oracle_simplex {
    int dimensions;
    double row, square, power;
    oracle_draw_vertex *draw;
    const void *lattice;
};
void oracle_simplex_sum(const struct oracle_simplex *simplex, const uint32_t cell[3],
                        const double t[3], struct oracle_sample *n);

/* What scarp has, without a lattice. */
struct oracle_simplex oracle_simplex_own(int dimensions);

/* oracle_cells.c: the features by distance from p, nearest first, as scarp_cells2 has them. */
#define ORACLE_FEATURES 3
struct oracle_feature {
    double square, distance, d[3]; /* d: p less the feature */
    uint32_t hash;
};
void oracle_features(const struct oracle_lattice *lattice, double jitter, const uint32_t cell[3],
                     const double t[3], struct oracle_feature nearest[ORACLE_FEATURES]);

/* What that is made of, for other features: none yet, and one more at d from p. */
void oracle_features_none(struct oracle_feature nearest[ORACLE_FEATURES]);
void oracle_features_add(int dimensions, struct oracle_feature feature,
                         struct oracle_feature nearest[ORACLE_FEATURES]);

/* The basis by the nearest features; not SCARP_CELL_SOFT. */
void oracle_cell_noise_of(const struct oracle_feature f[ORACLE_FEATURES], enum scarp_basis basis,
                          int dimensions, struct oracle_sample *n);

/* The number of a feature's cell that scarp_cells2 returns. */
uint32_t oracle_feature_id(uint32_t hash);

/* oracle_perlin.c: the lattice of improved noise (Perlin 2002). `lattice` is not used. */
oracle_draw oracle_perlin_gradient;

#endif
