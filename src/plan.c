/* SPDX-License-Identifier: MIT
 *
 * Turns the description of a noise into the constants of its octaves. It uses double arithmetic in
 * one fixed order, without libm, so that every platform computes the same constants.
 */
#include "plan.h"

#include <stddef.h>
#include <string.h>

#include "hybrid.h"
#include "kept.h"
#include "names.h"
#include "phase.h"
#include "suprema.h"

/* The layout is the binary interface, the same for every compiler; only pointers differ in size.
   reserved_in_use() relies on it. */
_Static_assert(offsetof(struct scarp_noise, erosion) == 48 &&
                   offsetof(struct scarp_noise, phase) == 52 &&
                   offsetof(struct scarp_noise, jitter) == 56 &&
                   offsetof(struct scarp_noise, sharpness) == 60 &&
                   offsetof(struct scarp_noise, period) == 64 &&
                   offsetof(struct scarp_noise, of_octaves) == 76 &&
                   offsetof(struct scarp_noise, warp) == 80 &&
                   offsetof(struct scarp_noise, plan) == 80 + sizeof(void *) &&
                   offsetof(struct scarp_noise, spare) == 80 + 2 * sizeof(void *) &&
                   sizeof(struct scarp_noise) == 192,
               "struct scarp_noise has 192 bytes without padding");
_Static_assert(sizeof((struct scarp_noise *)NULL)->spare >= 8, "some bytes stay spare");

/* While every f_k and the amplitude lie within these bounds, a_k f_k^2 times the largest second
   derivative (below 2^6 for every basis, per cell squared) stays under 2^127. So no outputs
   overflow but Hessians of ridged noise, which multiply gradients of octaves, and those of the
   distances of cellular noise, which are up to 2^40 at features. The constants of the
   octaves that matter stay normal floats, also in value noise, where they carry 2^-31. */
#define FREQUENCY_MIN 0x1p-32
#define FREQUENCY_MAX 0x1p48
#define RATIO_MIN 0.0625
#define RATIO_MAX 16.0
#define AMPLITUDE_MIN 0x1p-24
#define AMPLITUDE_MAX 0x1p24
#define EROSION_MIN 0x1p-24
#define EROSION_MAX 0x1p24
#define SHARPNESS_MIN 0x1p-24
#define SHARPNESS_MAX 0x1p24
#define SHARPNESS_USED_MIN 0x1p-8
#define SHARPNESS_USED_MAX 0x1p8
#define PERIOD_MAX 0x1p30

/*
 * The head-room for rounding. In units of the supremum, what is interpolated is at most 2 (a
 * corner's dot product: 1.995 in 2D, 1.930 in 3D; with a phase 2.0 and 1.984 of the supremum over
 * all phases) and differences are at most 4. Three fades, each within 1.94e-7 of the exact one, err
 * by at most 2.4e-6. Three levels of interpolation of three roundings each, and the dot products
 * before, err by at most 2.4e-6, the sum of 32 octaves by 32 * 2^-24 = 1.9e-6. Together that
 * is 6.7e-6, less than 2^-17 = 7.6e-6. Gradients that a phase turns are rounded to floats,
 * by 3.2e-7 at most, and products with them are no longer exact, which makes 7.3e-6.
 * Where simplex noise is largest, w is more than .4 at the vertices that matter, and within 2.4e-7,
 * so w^4 is within 2.4e-6 of itself. Distances are within 4e-7.
 */
#define HEADROOM (1.0 - 0x1p-17)

static double reach_of(const struct scarp_noise *noise, int dimensions)
{
    return noise->phase == 0.0f
               ? 1.0
               : scarp_phase_supremum(noise->fade, dimensions) / scarp_supremum(noise, dimensions);
}

/* The turn between octaves. The 2D turn is Quilez' (3-4-5 triangle), the 3D one has rational
   entries too, so neither accumulates more error than the products of doubles. */
static const double turn2[3][3] = {{0.8, -0.6, 0.0}, {0.6, 0.8, 0.0}, {0.0, 0.0, 1.0}};
static const double turn3[3][3] = {{0.0, 0.8, 0.6}, {-0.8, 0.36, -0.48}, {-0.6, -0.48, 0.64}};

struct parameters {
    double frequency, octaves, lacunarity, gain, amplitude, erosion, jitter, sharpness, of_octaves;
};

static double value_or(double value, double standard)
{
    return value == 0.0 ? standard : value;
}

static struct parameters parameters_of(const struct scarp_noise *noise)
{
    const double octaves = value_or((double)noise->octaves, 1.0);
    const struct parameters p = {
        .frequency = value_or(noise->frequency, 1.0),
        .octaves = octaves,
        .lacunarity = value_or((double)noise->lacunarity, 2.0),
        .gain = value_or((double)noise->gain, 0.5),
        .amplitude = value_or((double)noise->amplitude, 1.0),
        .erosion = value_or((double)noise->erosion, 1.0),
        .jitter = value_or((double)noise->jitter, 1.0),
        .sharpness = (double)sharpness_of(noise),
        .of_octaves = value_or((double)noise->of_octaves, octaves),
    };
    return p;
}

/* A NaN is not within. */
static int within(double value, double lowest, double highest)
{
    return value >= lowest && value <= highest;
}

/* Compares as unsigned, since a caller may put any number into an enumeration. */
static const char *unknown_member(const struct scarp_noise *noise)
{
    return (unsigned)noise->basis >= SCARP_BASES        ? "basis"
           : (unsigned)noise->fade >= SCARP_FADES       ? "fade"
           : (unsigned)noise->fractal >= SCARP_FRACTALS ? "fractal"
                                                        : NULL;
}

/* f_k is monotone in k, so the last one decides. */
static int last_frequency_valid(const struct parameters *p)
{
    double frequency = p->frequency;
    for (int k = 1; k < octave_count((float)p->octaves); k++) {
        frequency *= p->lacunarity;
    }
    return within(frequency, FREQUENCY_MIN, FREQUENCY_MAX);
}

static const char *const period_names[3] = {"period[0]", "period[1]", "period[2]"};

/* Whether a period of a noise of `octaves` octaves is at most PERIOD_MAX in each of them. */
static int period_valid(double period, double lacunarity, int octaves)
{
    for (int k = 1; k < octaves && period <= PERIOD_MAX; k++) {
        period *= lacunarity;
    }
    return period <= PERIOD_MAX;
}

/* What makes the noise's periods impossible. `p` is valid. */
static const char *period_member(const struct scarp_noise *noise, const struct parameters *p,
                                 int dimensions)
{
    const int octaves = octave_count((float)p->octaves);
    for (int i = 0; i < dimensions; i++) {
        if (noise->period[i] == 0) {
            continue;
        }
        if (octaves > 1 && p->lacunarity != (double)(int)p->lacunarity) {
            return "lacunarity";
        }
        if (!period_valid((double)noise->period[i], p->lacunarity, octaves)) {
            return period_names[i];
        }
    }
    return NULL;
}

/* Fractals that have a sharpness narrow its interval. */
static int sharpness_valid(const struct scarp_noise *noise, double sharpness)
{
    const int used = noise->fractal >= SCARP_PINGPONG;
    return used ? within(sharpness, SHARPNESS_USED_MIN, SHARPNESS_USED_MAX)
                : within(sharpness, SHARPNESS_MIN, SHARPNESS_MAX);
}

static int erosion_valid(const struct scarp_noise *noise, double erosion)
{
    return within(erosion, EROSION_MIN, noise->fractal == SCARP_JORDAN ? 1.0 : EROSION_MAX);
}

static const char *outside_member(const struct scarp_noise *noise, const struct parameters *p)
{
    const double magnitude = p->amplitude < 0.0 ? -p->amplitude : p->amplitude;
    return !within(p->frequency, FREQUENCY_MIN, FREQUENCY_MAX)     ? "frequency"
           : !within(p->octaves, 0.0, SCARP_MAX_OCTAVES)           ? "octaves"
           : !within(p->lacunarity, RATIO_MIN, RATIO_MAX)          ? "lacunarity"
           : !within(p->gain, RATIO_MIN, RATIO_MAX)                ? "gain"
           : !within(magnitude, AMPLITUDE_MIN, AMPLITUDE_MAX)      ? "amplitude"
           : !erosion_valid(noise, p->erosion)                     ? "erosion"
           : !within((double)noise->phase, -FLT_MAX, FLT_MAX)      ? "phase"
           : !within(p->jitter, FLT_TRUE_MIN, 1.0)                 ? "jitter"
           : !sharpness_valid(noise, p->sharpness)                 ? "sharpness"
           : !within(p->of_octaves, p->octaves, SCARP_MAX_OCTAVES) ? "of_octaves"
           : !last_frequency_valid(p)                              ? "octaves"
                                                                   : NULL;
}

/* Whether any reserved member is not zero. Reading wide words without branches takes less time than
   reading members one by one. */
static int reserved_in_use(const struct scarp_noise *noise)
{
    uintptr_t words[sizeof noise->spare / sizeof(uintptr_t)], bits = 0;
    memcpy(words, noise->spare, sizeof words);
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        bits |= words[i];
    }
    return bits != 0;
}

static enum scarp_status check_periods(const struct scarp_noise *noise, const struct parameters *p,
                                       int dimensions, const char **member)
{
    if ((*member = period_member(noise, p, dimensions)) != NULL) {
        return SCARP_ERROR_PARAMETER;
    }
    if (is_rotated(noise, octave_count((float)p->octaves))) {
        *member = "rotate";
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (noise->basis == SCARP_SIMPLEX && dimensions == 2 && noise->period[1] != 0) {
        *member = period_names[1];
        return SCARP_ERROR_UNSUPPORTED;
    }
    return SCARP_OK;
}

/* Makes all checks but that of the warp. `p` are the parameters of the noise. */
static enum scarp_status check_one(const struct scarp_noise *noise, const struct parameters *p,
                                   int dimensions, const char **member)
{
    if ((*member = unknown_member(noise)) != NULL) {
        return SCARP_ERROR_ENUM;
    }
    if ((*member = outside_member(noise, p)) != NULL) {
        return SCARP_ERROR_PARAMETER;
    }
    if (reserved_in_use(noise)) {
        *member = "spare";
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (noise->phase != 0.0f && noise->basis != SCARP_GRADIENT) {
        *member = "phase";
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (dimensions != 2 && dimensions != 3) {
        return SCARP_ERROR_PARAMETER;
    }
    return repeats(noise, dimensions) ? check_periods(noise, p, dimensions, member) : SCARP_OK;
}

/* Makes all checks. */
static enum scarp_status check(const struct scarp_noise *noise, const struct parameters *p,
                               int dimensions, const char **member)
{
    enum scarp_status status = check_one(noise, p, dimensions, member);
    int depth = 0;
    for (const struct scarp_noise *w = noise->warp; status == SCARP_OK && w != NULL; w = w->warp) {
        const struct parameters of_warp = parameters_of(w);
        status = ++depth > SCARP_MAX_WARPS ? SCARP_ERROR_UNSUPPORTED
                                           : check_one(w, &of_warp, dimensions, member);
        if (status != SCARP_OK) {
            *member = "warp";
        }
    }
    return status;
}

/*
 * Why values stay within: |n_k| <= 1 but for the rounding that HEADROOM covers, and the factors
 * that fractals multiply a_k n_k by lie in [0, 1] in float arithmetic too, since rounding is
 * monotone and 1 is a float: |n_k| <= 1 (turbulence); (1 - |n_k|)^2 <= 1 and the weights, which end
 * at 1 (ridged: |n_k| may exceed 1 by rounding or with a phase, which does no harm below 2);
 * 1 / (1 + erosion d.d) (erosion). What ping-pong folds, 1 - 2 |e| with |e| <= 1, is in [-1, 1].
 * max(0, 1 - |n_k|) and the products u_k are (Swiss), and 1 - erosion / (1 + s.s) (Jordan, where
 * n_k is squared, and has the head-room twice). These and turbulence sum numbers of one sign. So
 * every sum is at most the sum of the a_k, which is amplitude * HEADROOM. Single octaves show that
 * the bounds are reached. With a phase, |n_k| is at most the `reach`.
 */
struct scarp_interval scarp_plan_range(const struct scarp_noise *noise, int dimensions)
{
    const struct parameters p = parameters_of(noise);
    const double reach = reach_of(noise, dimensions);
    struct scarp_interval range = {-reach, reach};
    switch (noise->fractal) {
    case SCARP_TURBULENCE: range.lowest = 0.0; break;
    case SCARP_RIDGED:
    case SCARP_SWISS: range = (struct scarp_interval){0.0, 1.0}; break;
    case SCARP_JORDAN: range = (struct scarp_interval){0.0, reach * reach}; break;
    case SCARP_PINGPONG: range = (struct scarp_interval){-1.0, 1.0}; break;
    case SCARP_HYBRID:
        range = scarp_hybrid_range(p.sharpness, p.gain, (const double[2]){p.octaves, p.of_octaves},
                                   reach);
        break;
    default: break;
    }
    const double magnitude = p.amplitude < 0.0 ? -p.amplitude : p.amplitude;
    range.lowest *= magnitude;
    range.highest *= magnitude;
    const struct scarp_interval turned = {0.0 - range.highest, 0.0 - range.lowest}; /* no -0 */
    return p.amplitude < 0.0 ? turned : range;
}

enum scarp_status scarp_plan_check(const struct scarp_noise *noise, int dimensions,
                                   const char **member)
{
    const struct parameters p = parameters_of(noise);
    return check(noise, &p, dimensions, member);
}

/* The finaliser of splitmix64 (Steele, Lea and Flood 2014, with Stafford's mix 13): a bijection. */
static uint64_t mix64(uint64_t z)
{
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

#define GOLDEN_GAMMA UINT64_C(0x9e3779b97f4a7c15) /* 2^64 / golden ratio, odd */

/*
 * The seed of octave k > 0, such that the octave by itself is single-octave noise of that seed. The
 * seed is mixed before k comes in, so seeds that people choose (neighbours, complements, powers of
 * two) have no octaves in common. `mixed` is mix64(seed + GOLDEN_GAMMA). Octave 0 has `seed`
 * itself.
 */
static uint64_t octave_seed(uint64_t mixed, int k)
{
    return mix64(mixed + (uint64_t)k * GOLDEN_GAMMA);
}

/* Draws the keys of an octave from its stream, mix64(its seed + GOLDEN_GAMMA). The keys of x and y
   are a bijection of the seed, so no two seeds share an octave k. */
static void draw_keys(struct scarp_octave *octave, uint64_t stream)
{
    const uint64_t a = mix64(stream + GOLDEN_GAMMA);
    const uint64_t b = mix64(stream + 2 * GOLDEN_GAMMA);
    octave->key[0] = (uint32_t)a;
    octave->key[1] = (uint32_t)(a >> 32);
    octave->key[2] = (uint32_t)b;
}

static void draw_offset(struct scarp_octave *octave, uint64_t stream)
{
    const uint64_t b = mix64(stream + 2 * GOLDEN_GAMMA);
    const uint64_t c = mix64(stream + 3 * GOLDEN_GAMMA);
    const int32_t draws[3] = {(int32_t)(b >> 40), (int32_t)(c & 0xffffff), (int32_t)(c >> 40)};
    for (int i = 0; i < 3; i++) {
        octave->offset[i] = (double)draws[i] * 0x1p-24;
    }
}

/* `mixed` is as in octave_seed(). The first octave has the offset 0. */
static void draw_octave(struct scarp_octave *octave, uint64_t mixed, int k)
{
    if (k == 0) {
        draw_keys(octave, mixed);
        memset(octave->offset, 0, sizeof octave->offset);
    } else {
        const uint64_t stream = mix64(octave_seed(mixed, k) + GOLDEN_GAMMA);
        draw_keys(octave, stream);
        draw_offset(octave, stream);
    }
}

/* A row of the Jacobian, frequency times a row of the turn, and what the kernels need of it. */
static void set_axis(struct scarp_octave *octave, int i, const double turn[3], double amplitude)
{
    for (int j = 0; j < 3; j++) {
        const double slope = octave->frequency64 * turn[j];
        octave->jacobian64[i][j] = slope;
        octave->jacobian[i][j] = (float)slope;
        octave->gradient[i][j] = (float)(amplitude * slope);
    }
}

/* turn = by turn */
static void multiply(double turn[3][3], const double by[3][3])
{
    double product[3][3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            product[i][j] = by[i][0] * turn[0][j] + by[i][1] * turn[1][j] + by[i][2] * turn[2][j];
        }
    }
    memcpy(turn, product, sizeof product);
}

static void turn_axes(struct scarp_octave *octave, int octaves, int dimensions,
                      const double amplitude[SCARP_MAX_OCTAVES])
{
    double turn[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    for (int k = 0; k < octaves; k++) {
        for (int i = 0; i < dimensions; i++) {
            set_axis(&octave[k], i, turn[i], amplitude[k]);
        }
        multiply(turn, dimensions == 2 ? turn2 : turn3);
    }
}

/* The periods of all octaves. A check lets pass what is too long for an axis that the call does not
   have. */
static void set_periods(struct scarp_octave *octave, int octaves, const struct scarp_noise *noise,
                        double lacunarity)
{
    double ratio = 1.0;
    for (int k = 0; k < octaves; k++) {
        for (int i = 0; i < 3; i++) {
            const double period = (double)noise->period[i] * ratio;
            octave[k].last[i] = (period <= PERIOD_MAX ? (uint32_t)period : 0) - 1;
        }
        ratio *= lacunarity;
    }
}

/* Sets the weights w_k of the octaves that are summed, and gives the sum of those that the
   amplitudes are for. */
static double weigh_octaves(double weights[SCARP_MAX_OCTAVES], const struct parameters *p)
{
    const int octaves = octave_count((float)p->octaves), of = octave_count((float)p->of_octaves);
    double weight = 1.0, sum = 0.0;
    for (int k = 0; k < of; k++) {
        weights[k] = k == octaves - 1 ? weight * (p->octaves - (double)k) : weight;
        sum += k == of - 1 ? weight * (p->of_octaves - (double)k) : weight;
        weight *= p->gain;
    }
    return sum;
}

/* What weights are multiplied by to be amplitudes of 1 in all, `sum` being that of the weights. */
static double share_of(const struct scarp_noise *noise, const struct parameters *p, double sum)
{
    if (noise->fractal != SCARP_HYBRID) {
        return (noise->fractal == SCARP_JORDAN ? HEADROOM * HEADROOM : HEADROOM) / sum;
    }
    return SCARP_HYBRID_HEADROOM /
           scarp_hybrid_interval(p->sharpness, p->gain, p->of_octaves, 1.0).highest;
}

/* Computes the constants of all octaves of a checked noise. */
static void make_octaves(struct scarp_octave *octave, const struct scarp_noise *noise,
                         const struct parameters *p, int dimensions)
{
    const int octaves = octave_count((float)p->octaves);
    const double supremum = scarp_supremum(noise, dimensions);
    double weights[SCARP_MAX_OCTAVES], factors[SCARP_MAX_OCTAVES];
    const double scale = p->amplitude * share_of(noise, p, weigh_octaves(weights, p));
    const double stretch =
        noise->basis == SCARP_SIMPLEX && dimensions == 2 ? SCARP_TRIANGLE_ROWS : 1.0;
    const uint64_t mixed = mix64(noise->seed + GOLDEN_GAMMA);
    double frequency = p->frequency, share = 1.0;
    for (int k = 0; k < octaves; k++) {
        struct scarp_octave *const o = &octave[k];
        const double weighted = weights[k] * scale;
        const double factor = (noise->fractal == SCARP_FBM ? weighted : 1.0) / supremum;
        factors[k] = factor;
        o->weight = (float)weighted;
        o->amplitude = (float)factor;
        o->slope = (float)(factor * frequency);
        o->curvature = (float)(factor * frequency * frequency);
        o->frequency = (float)frequency;
        o->share = (float)share;
        if (!blends_corners(noise->basis)) {
            o->jitter = scarp_stray(noise);
            o->middle = (float)scarp_middle(noise, dimensions);
            o->stretch = stretch;
        }
        o->frequency64 = frequency;
        draw_octave(o, mixed, k);
        memset(o->last, 0xff, sizeof o->last);
        frequency *= p->lacunarity;
        share *= p->gain;
    }
    if (repeats(noise, dimensions)) {
        set_periods(octave, octaves, noise, p->lacunarity);
    }
    if (is_rotated(noise, octaves)) {
        turn_axes(octave, octaves, dimensions, factors);
    }
}

/* Checks the noise and computes its octaves, but for the phase. It is out of line for the sake of
   calls that keep theirs. */
static __attribute__((noinline)) enum scarp_status
octaves_of(struct scarp_octave *octave, const struct scarp_noise *noise, int dimensions)
{
    const struct parameters p = parameters_of(noise);
    const char *member;
    const enum scarp_status status = check(noise, &p, dimensions, &member);
    if (status == SCARP_OK && noise->warp == NULL) {
        make_octaves(octave, noise, &p, dimensions);
    }
    return status;
}

enum scarp_status scarp_plan_keep(struct scarp_plan *plan, const struct scarp_noise *noise,
                                  int dimensions)
{
    struct kept *const kept = (struct kept *)plan;
    const enum scarp_status status = octaves_of(kept->octave, noise, dimensions);
    if (status == SCARP_OK) {
        if (noise->warp == NULL && blends_corners(noise->basis)) {
            scarp_phase_set(kept->octave, octaves_in(noise), noise->phase);
        }
        kept->mark = mark_of(dimensions);
        memcpy(&kept->noise, noise, sizeof *noise);
    }
    return status;
}

/* The seed of a component of a warp or a potential: numbers that no octave has. */
static uint64_t component_seed(uint64_t seed, int component)
{
    return octave_seed(mix64(seed + GOLDEN_GAMMA), SCARP_MAX_OCTAVES + 1 + component);
}

/* How many components a level has, and whether they have seeds of their own. */
static int components_of(const struct scarp_warps *warps, int level, int dimensions)
{
    return level > 0 || warps->vector ? dimensions : 1;
}

/* Computes the octaves of a component of a level, which the noise describes; of level 0 without
   components, if there are none. */
static void make_level(struct scarp_octave *octave, const struct scarp_noise *described,
                       int dimensions, int components, int component)
{
    struct scarp_noise noise = *described;
    const struct parameters p = parameters_of(&noise);
    if (components > 1) {
        noise.seed = component_seed(noise.seed, component);
    }
    make_octaves(octave, &noise, &p, dimensions);
    if (noise.basis == SCARP_GRADIENT) {
        scarp_phase_set(octave, octaves_in(&noise), noise.phase);
    }
}

/* Makes the octaves of all levels and components, if there is room for them: one component after
   the other. */
static void make_levels(struct scarp_warps *warps, int dimensions)
{
    const struct scarp_noise *noise = warps->noise;
    int count = 0;
    for (int level = 0; level <= warps->depth; level++, noise = noise->warp) {
        count += octaves_in(noise) * components_of(warps, level, dimensions);
    }
    warps->has_all = count <= SCARP_MAX_OCTAVES;
    struct scarp_octave *octave = warps->space;
    noise = warps->noise;
    for (int level = 0; warps->has_all && level <= warps->depth; level++, noise = noise->warp) {
        const int components = components_of(warps, level, dimensions);
        for (int i = 0; i < components; i++) {
            make_level(octave, noise, dimensions, components, i);
            octave += octaves_in(noise);
        }
    }
}

void scarp_plan_level(struct scarp_call_plan *plan, const struct scarp_warps *warps,
                      struct scarp_kind kind, int level, int component)
{
    const struct scarp_noise *noise = warps->noise;
    struct scarp_octave *octave = warps->space;
    for (int i = 0; i < level; i++, noise = noise->warp) {
        octave += octaves_in(noise) * components_of(warps, i, kind.dimensions);
    }
    octave += octaves_in(noise) * component;
    if (!warps->has_all) {
        octave = warps->space;
        make_level(octave, noise, kind.dimensions, components_of(warps, level, kind.dimensions),
                   component);
    }
    kind.dphase = level == 0 ? kind.dphase : 0;
    plan_describe(plan, noise, kind);
    plan->octave = octave;
}

/* Makes the plan of a noise with warps, if these have what is asked for, too; or of potentials,
   with or without. */
static enum scarp_status plan_levels(struct scarp_call_plan *plan, struct scarp_octave *space,
                                     const struct scarp_noise *noise, struct scarp_kind kind,
                                     int vector)
{
    const struct scarp_kind of_warp = {.dimensions = kind.dimensions, .order = kind.order};
    int depth = 0;
    for (const struct scarp_noise *w = noise->warp; w != NULL; w = w->warp) {
        if (!has_outputs(w, of_warp)) {
            return SCARP_ERROR_UNSUPPORTED;
        }
        depth++;
    }
    plan_describe(plan, noise, kind);
    plan->plain = 0;
    plan->octave = NULL;
    plan->warps =
        (struct scarp_warps){.depth = depth, .vector = vector, .space = space, .noise = noise};
    make_levels(&plan->warps, kind.dimensions);
    return SCARP_OK;
}

enum scarp_status scarp_plan_call(struct scarp_call_plan *plan, struct scarp_octave *space,
                                  const struct scarp_noise *noise, struct scarp_kind kind)
{
    if (plan_kept(plan, noise, kind)) {
        return SCARP_OK;
    }
    const enum scarp_status status = octaves_of(space, noise, kind.dimensions);
    if (status != SCARP_OK) {
        return status;
    }
    if (!has_outputs(noise, kind)) {
        return SCARP_ERROR_UNSUPPORTED;
    }
    if (noise->warp != NULL) {
        return plan_levels(plan, space, noise, kind, 0);
    }
    plan_describe(plan, noise, kind);
    if (plan->flows) {
        scarp_phase_set(space, plan->octaves, noise->phase);
    }
    plan->octave = space;
    return SCARP_OK;
}

enum scarp_status scarp_plan_potentials(struct scarp_call_plan *plan, struct scarp_octave *space,
                                        const struct scarp_noise *noise, struct scarp_kind kind)
{
    if (kind.dimensions == 2) {
        return scarp_plan_call(plan, space, noise, kind);
    }
    const char *member;
    const enum scarp_status status = scarp_plan_check(noise, kind.dimensions, &member);
    return status != SCARP_OK          ? status
           : !has_outputs(noise, kind) ? SCARP_ERROR_UNSUPPORTED
                                       : plan_levels(plan, space, noise, kind, 1);
}
