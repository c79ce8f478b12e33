/* SPDX-License-Identifier: MIT
 *
 * What scarp defines, in double precision: the lattice and its hash, the octaves' keys, offsets,
 * frequencies and axes, the normalisation, and the positions.
 */
#include "oracle.h"

#include <math.h>

/* The constants in the definition of the lattice. */
static const uint32_t hash_axis_multiplier[3] = {0x1a2012f5, 0x14e84743, 0xec1d7da1};
static const uint32_t hash_addend = 0x9e3779b9;

#define DEGREE (3.14159265358979323846 / 180.0)

double oracle_gradient_supremum(int dimensions, enum scarp_fade fade)
{
    if (dimensions == 2) {
        return fade == SCARP_QUINTIC ? 0.69535270367848662 : 0.69580995165323791;
    }
    return fade == SCARP_QUINTIC ? 1.0363538112118029 : 1.0449051896098760;
}

int oracle_gradient_count(int dimensions)
{
    return dimensions == 2 ? 16 : 12;
}

void oracle_gradient_vector(int dimensions, unsigned index, double vector[3])
{
    if (dimensions == 2) {
        /* A direction of the first quadrant; bit 3 mirrors x, bit 0 mirrors y. */
        const double angle = (11.25 + 22.5 * (double)(index >> 1 & 3)) * DEGREE;
        vector[0] = index & 8 ? -cos(angle) : cos(angle);
        vector[1] = index & 1 ? -sin(angle) : sin(angle);
        vector[2] = 0.0;
    } else {
        /* An edge in the plane across z, y or x; the bits below are the signs of its components. */
        const int across = 2 - (int)(index / 4);
        const int first = across == 0 ? 1 : 0, second = across == 2 ? 1 : 2;
        vector[across] = 0.0;
        vector[first] = index & 2 ? -1.0 : 1.0;
        vector[second] = index & 1 ? -1.0 : 1.0;
    }
}

uint32_t oracle_stepped(const struct oracle_lattice *lattice, int axis, uint32_t cell, int steps)
{
    const int64_t period = lattice->period[axis];
    if (period == INT64_C(1) << 32) {
        return cell + (uint32_t)steps; /* as below, but faster */
    }
    const int64_t remainder = ((int64_t)cell + steps) % period;
    return (uint32_t)(remainder < 0 ? remainder + period : remainder);
}

uint32_t oracle_mixed(const struct oracle_lattice *lattice, const uint32_t cell[3],
                      const int step[3])
{
    uint32_t mixed = 0;
    for (int i = 0; i < lattice->dimensions; i++) {
        const uint32_t inside = oracle_stepped(lattice, i, cell[i], step[i]);
        const uint32_t axis = inside * hash_axis_multiplier[i] + lattice->key[i];
        mixed ^= axis / 256 + axis % 256 * 16777216; /* rotates the bits */
    }
    return mixed;
}

uint32_t oracle_hash(uint32_t mixed)
{
    return mixed * mixed + hash_addend * mixed;
}

static uint32_t hash(const struct oracle_lattice *lattice, const uint32_t point[3])
{
    static const int here[3] = {0, 0, 0};
    return oracle_hash(oracle_mixed(lattice, point, here));
}

/* What a component draws is what noise with one draws of another hash. Gradients of the plane: each
   component has four bits, from the top on. In space: the upper half is a number with 16 digits
   behind the point, and each component takes the whole part of 12 times what the one before has
   left. Values: the halves of the hash change places, and a multiplier goes with each component. */
static uint32_t component_drawn(uint32_t h, int component, int is_value, int dimensions)
{
    static const uint64_t multiplier[3] = {0, 0x9e3779b1, 0x85ebca6b};
    if (component == 0) {
        return h;
    }
    if (is_value) {
        return (uint32_t)(multiplier[component] * (h / 65536 + h % 65536 * 65536ull));
    }
    uint32_t left = h / 65536;
    for (int i = 0; i < component; i++) {
        left = left * (dimensions == 2 ? 16 : 12) % 65536;
    }
    return left * 65536;
}

const double *oracle_gradient_drawn(const struct oracle_lattice *lattice, uint32_t drawn)
{
    /* The upper 16 bits, as a fraction, choose among equally likely gradients. */
    const int count = oracle_gradient_count(lattice->dimensions);
    return lattice->gradient[(uint32_t)count * (drawn >> 16) / 65536];
}

static void draw_gradient(const void *opaque, const uint32_t point[3], double corner[3])
{
    const struct oracle_lattice *const lattice = opaque;
    const uint32_t drawn =
        component_drawn(hash(lattice, point), lattice->component, 0, lattice->dimensions);
    const double *const gradient = oracle_gradient_drawn(lattice, drawn);
    corner[0] = gradient[0];
    corner[1] = gradient[1];
    corner[2] = gradient[2];
}

/* The hash as a signed number, rounded to float, in units of 2^-31. */
static void draw_value(const void *opaque, const uint32_t point[3], double corner[3])
{
    const struct oracle_lattice *const lattice = opaque;
    const double all = (double)component_drawn(hash(lattice, point), lattice->component, 1, 0);
    corner[0] = (double)(float)(all >= 0x1p31 ? all - 0x1p32 : all) * 0x1p-31;
}

double oracle_lattice_value(const struct oracle *oracle, int k, const uint32_t point[3])
{
    const struct oracle_octave *const octave = &oracle->octave[k];
    const struct oracle_lattice lattice = {
        .key = octave->of.key, .period = octave->period, .dimensions = oracle->dimensions};
    double corner[3];
    draw_value(&lattice, point, corner);
    return corner[0];
}

/* Turns the gradients of octave k by 2^k times the phase. */
static void turn_gradients(struct oracle_octave *octave, int dimensions, double phase, int k)
{
    const double turns = fmod(ldexp(phase, k), 1.0);
    for (unsigned i = 0; i < (unsigned)oracle_gradient_count(dimensions); i++) {
        oracle_gradient_turned(dimensions, i, turns, octave->gradient[i], octave->turning[i]);
        for (int axis = 0; axis < 3; axis++) {
            octave->turning[i][axis] = ldexp(octave->turning[i][axis], k);
        }
    }
}

/* Sets the supremum and the middle of the basis. */
static void scale_basis(struct oracle *oracle)
{
    const int d = oracle->dimensions;
    oracle->supremum = 1.0;
    oracle->middle = 0.0;
    switch (oracle->basis) {
    case SCARP_GRADIENT: oracle->supremum = oracle_gradient_supremum(d, oracle->fade); break;
    case SCARP_SIMPLEX:
        oracle->supremum = d == 2 ? 0.062366952212268554 : 0.013007101282926131;
        break;
    case SCARP_CELL_F1:
    case SCARP_CELL_F2:
    case SCARP_CELL_EDGE:
    case SCARP_CELL_SOFT:
        oracle->supremum = 0.5 * oracle_cells_supremum(oracle->basis, d, oracle->jitter);
        oracle->middle = oracle->basis == SCARP_CELL_SOFT ? -oracle->supremum : oracle->supremum;
        break;
    default: break;
    }
}

void oracle_make(struct oracle *oracle, const struct scarp_noise *noise, int dimensions)
{
    const double lacunarity = octaves_or((double)noise->lacunarity, 2.0);
    struct octave made[ORACLE_OCTAVES];
    oracle->basis = noise->basis;
    oracle->fade = noise->fade;
    oracle->fractal = noise->fractal;
    oracle->erosion = octaves_or((double)noise->erosion, 1.0);
    oracle->sharpness = octaves_sharpness(noise);
    oracle->dimensions = dimensions;
    oracle->component = 0;
    oracle->jitter = octaves_or((double)noise->jitter, 1.0);
    scale_basis(oracle);
    oracle->octaves = octaves_make(noise, dimensions, made);
    for (int k = 0; k < oracle->octaves; k++) {
        struct oracle_octave *const octave = &oracle->octave[k];
        octave->of = made[k];
        turn_gradients(octave, dimensions, (double)noise->phase, k);
        for (int i = 0; i < 3; i++) {
            const double period = (double)noise->period[i] * pow(lacunarity, k);
            octave->period[i] = noise->period[i] == 0 ? INT64_C(1) << 32 : (int64_t)period;
        }
    }
}

void oracle_make_component(struct oracle *oracle, const struct scarp_noise *noise, int dimensions,
                           int component)
{
    const int shares = blends_corners(noise->basis);
    struct scarp_noise of_component = *noise;
    of_component.seed = check_random_number(check_random_number(noise->seed, 1),
                                            33u + (shares ? 0u : (unsigned)component));
    oracle_make(oracle, &of_component, dimensions);
    oracle->component = shares ? component : 0;
}

uint32_t oracle_inside_period(double cell, int64_t period)
{
    const int64_t remainder = (int64_t)cell % period;
    return (uint32_t)(remainder < 0 ? remainder + period : remainder);
}

/* What component i of p_k is multiplied by: 2D simplex noise counts rows of triangles. */
static double stretch(const struct oracle *oracle, int i)
{
    const int rows = oracle->basis == SCARP_SIMPLEX && oracle->dimensions == 2 && i == 1;
    return rows ? 1.1547005383792515 /* 2 / sqrt(3) */ : 1.0;
}

/* Component i of p_k = J_k x + o_k. */
static double position(const struct oracle *oracle, int k, enum oracle_rounding rounding,
                       const double x[3], int i)
{
    const struct oracle_octave *const octave = &oracle->octave[k];
    const double *const axis = octave->of.axes[i];
    if (rounding == ORACLE_F32) {
        float sum = (float)axis[0] * (float)x[0];
        for (int j = 1; j < oracle->dimensions; j++) {
            sum += (float)axis[j] * (float)x[j];
        }
        sum += (float)octave->of.offset[i];
        return (double)(sum * (float)stretch(oracle, i));
    }
    double sum = axis[0] * x[0];
    for (int j = 1; j < oracle->dimensions; j++) {
        sum += axis[j] * x[j];
    }
    return (sum + octave->of.offset[i]) * stretch(oracle, i);
}

/* Rounds to a multiple of 2^-24. */
static double rounded(double t)
{
    return rint(t * 0x1p24) * 0x1p-24;
}

/* Splits component i of p_k as the _f64 calls do where axes are turned: J_k x + o_k is the sum of
   what depends on the first coordinate and of the rest. Gives the cell, and returns the fraction.
 */
static double place_turned(const struct oracle *oracle, int k, const double x[3], int i,
                           double *cell)
{
    const struct oracle_octave *const octave = &oracle->octave[k];
    const double *const axis = octave->of.axes[i], s = stretch(oracle, i);
    const double p = axis[0] * s * x[0];
    double q = axis[1] * s * x[1];
    if (oracle->dimensions == 3) {
        q += axis[2] * s * x[2];
    }
    const double t = rounded(p - floor(p)) + rounded(q - floor(q) + octave->of.offset[i] * s);
    *cell = floor(p) + floor(q) + floor(t);
    return t - floor(t);
}

/* Splits p_k into cell and fraction. */
static void place(const struct oracle *oracle, int k, enum oracle_rounding rounding,
                  const double x[3], uint32_t cell[3], double t[3])
{
    for (int i = 0; i < 3; i++) {
        cell[i] = 0;
        t[i] = 0.0;
    }
    for (int i = 0; i < oracle->dimensions; i++) {
        const int64_t period = oracle->octave[k].period[i];
        double turned_cell;
        if (rounding == ORACLE_F64 && oracle->octave[k].of.turned) {
            t[i] = place_turned(oracle, k, x, i, &turned_cell);
            cell[i] = oracle_inside_period(turned_cell, period);
            continue;
        }
        const double p = position(oracle, k, rounding, x, i), lower = floor(p);
        if (rounding == ORACLE_F32 && !(p >= -0x1p31 && p < 0x1p31)) {
            cell[i] = oracle_inside_period(-0x1p31, period);
            continue;
        }
        cell[i] = oracle_inside_period(lower, period);
        t[i] = rounding == ORACLE_EXACT ? p - lower : (double)(float)(p - lower);
    }
}

/* The basis, raw, and what gradient noise has besides. */
static void basis_at(const struct oracle *oracle, const struct oracle_octave *octave,
                     const uint32_t cell[3], const double t[3], struct oracle_sample *n)
{
    struct oracle_lattice lattice = {.key = octave->of.key,
                                     .period = octave->period,
                                     .dimensions = oracle->dimensions,
                                     .component = oracle->component,
                                     .gradient = octave->gradient};
    struct oracle_sample turning;
    switch (oracle->basis) {
    case SCARP_GRADIENT:
        oracle_gradient_noise(draw_gradient, &lattice, oracle->dimensions, oracle->fade, cell, t,
                              n);
        lattice.gradient = octave->turning;
        oracle_gradient_noise(draw_gradient, &lattice, oracle->dimensions, oracle->fade, cell, t,
                              &turning);
        n->phase = turning.value;
        for (int i = 0; i < oracle->dimensions; i++) {
            n->gradient_phase[i] = turning.gradient[i];
        }
        break;
    case SCARP_VALUE:
        oracle_value_noise(draw_value, &lattice, oracle->dimensions, oracle->fade, cell, t, n);
        break;
    case SCARP_SIMPLEX: oracle_simplex_noise(&lattice, cell, t, n); break;
    default: oracle_cell_noise(&lattice, oracle->basis, oracle->jitter, cell, t, n); break;
    }
}

void oracle_octave_at(const struct oracle *oracle, enum oracle_rounding rounding, int k,
                      const double x[3], struct oracle_sample *n)
{
    uint32_t cell[3];
    double t[3];
    place(oracle, k, rounding, x, cell, t);
    basis_at(oracle, &oracle->octave[k], cell, t, n);
    n->value = (n->value - oracle->middle) / oracle->supremum;
    n->phase /= oracle->supremum;
    for (int i = 0; i < oracle->dimensions; i++) {
        n->gradient[i] /= oracle->supremum;
        n->gradient_phase[i] /= oracle->supremum;
        for (int j = 0; j < oracle->dimensions; j++) {
            n->hessian[i][j] /= oracle->supremum;
        }
    }
}

void oracle_evaluate(const struct oracle *oracle, enum oracle_rounding rounding, const double x[3],
                     struct oracle_sample *sum)
{
    struct oracle_creases creases;
    oracle_evaluate_creased(oracle, rounding, x, sum, &creases);
}

/* How far p_k is, at least, from the lattice's planes, or from where the octave has its creases. */
static double octave_clearance(const struct oracle *oracle, int k, const double x[3])
{
    uint32_t cell[3];
    double t[3], clearance = 1.0;
    struct oracle_sample n;
    place(oracle, k, ORACLE_EXACT, x, cell, t);
    if (oracle->basis != SCARP_GRADIENT && oracle->basis != SCARP_VALUE) {
        basis_at(oracle, &oracle->octave[k], cell, t, &n);
        return n.clearance;
    }
    for (int i = 0; i < oracle->dimensions; i++) {
        clearance = fmin(clearance, fmin(t[i], 1.0 - t[i]));
    }
    return clearance;
}

double oracle_clearance(const struct oracle *oracle, const double x[3])
{
    double clearance = 1.0;
    for (int k = 0; k < oracle->octaves; k++) {
        clearance =
            fmin(clearance, octave_clearance(oracle, k, x) / oracle->octave[k].of.frequency);
    }
    return clearance;
}
