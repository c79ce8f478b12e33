// SPDX-License-Identifier: MIT
//
// scarp's noise for GLSL: Vulkan, and WebGL 2. Generated from src/gpu; do not edit.
//
//     #version 460
//     #extension GL_GOOGLE_include_directive : require
//     #define SCARP_PLANS 1   // how many plans are in the uniform block; default 1
//     #define SCARP_SET 0     // where that is; default 0 and 0
//     #define SCARP_BINDING 0
//     #include "scarp.glsl"
//     ...
//     ScarpSample n = scarp_sample2(0u, x, y);  // of scarp_plan[0]: n.value, n.gradient.xy
//
// scarp_gpu_plan_make (scarp.h) makes the bytes of a plan, and says what is promised. What a shader does
// not use of a sample costs nothing. Smaller and faster shaders fix what all plans have in common:
// SCARP_ONLY_BASIS and SCARP_ONLY_FRACTAL, an enumerator of scarp.h as 2u, and SCARP_ONLY_DEPTH,
// how many warps there are, as 0u. SCARP_FUSE gives the equal bits up.
//
// With SCARP_ROUND, Vulkan promises to round to the nearest float, which most devices do anyway: for
// devices that have shaderRoundingModeRTEFloat32. The file must then come before any declaration.
#ifndef SCARP_GLSL
#define SCARP_GLSL

#ifdef SCARP_ROUND
#extension GL_EXT_spirv_intrinsics : require
spirv_execution_mode(extensions = ["SPV_KHR_float_controls"], capabilities = [4467], 4462, 32);
#endif

#ifdef GL_ES
precision highp float;
precision highp int;
#endif
#ifndef SCARP_PLANS
#define SCARP_PLANS 1
#endif
#ifndef SCARP_SET
#define SCARP_SET 0
#endif
#ifndef SCARP_BINDING
#define SCARP_BINDING 0
#endif

/* The constants of a noise, member by member as scarp_gpu_plan_make gives them. */

/* turn: with a phase the cosine and sine of the angle, then of twice that; of bases that take
   places the jitter, the middle and the stretch. */
struct ScarpOctave {
    uvec3 key;
    float frequency;
    float weight;
    float amplitude;
    float slope;
    float curvature;
    uvec3 last;
    float share;
    vec4 turn;
    vec3 jacobian_x;
    float offset_x;
    vec3 jacobian_y;
    float offset_y;
    vec3 jacobian_z;
    float offset_z;
    vec3 gradient_x;
    float inverse;
    vec3 gradient_y;
    float reach;
    vec3 gradient_z;
    float spare;
};

/* component: 0 here; octaves_at() sets it to that of vector noise whose components share a lattice.
 */
struct ScarpLevel {
    uint basis;
    uint fade;
    uint fractal;
    uint octaves;
    uint rotate;
    uint flows;
    uint first;
    uint component;
    float erosion;
    float sharpness;
    float inverse_weight;
    float spare1;
};

struct ScarpPlan {
    uint depth;
    uint dimensions;
    uint zero;
    float unit;
    ScarpLevel level[5];
    ScarpOctave octave[32];
};

/* The numbers of enum scarp_basis, but of cellular noise, and of enum scarp_fractal. */
#define SCARP_GRADIENT 0u
#define SCARP_VALUE 1u
#define SCARP_SIMPLEX 2u

#define SCARP_FBM 0u
#define SCARP_TURBULENCE 1u
#define SCARP_RIDGED 2u
#define SCARP_EROSION 3u
#define SCARP_PINGPONG 4u
#define SCARP_HYBRID 5u
#define SCARP_SWISS 6u
#define SCARP_JORDAN 7u
#if defined(VULKAN)
layout(std140, set = SCARP_SET, binding = SCARP_BINDING)
#elif defined(GL_ES)
layout(std140)
#else
layout(std140, binding = SCARP_BINDING)
#endif
uniform ScarpPlans
{
    ScarpPlan scarp_plan[SCARP_PLANS];
};

uint scarp_only_basis(uint basis)
{
#ifdef SCARP_ONLY_BASIS
    return SCARP_ONLY_BASIS;
#else
    return basis;
#endif
}

uint scarp_only_fractal(uint fractal)
{
#ifdef SCARP_ONLY_FRACTAL
    return SCARP_ONLY_FRACTAL;
#else
    return fractal;
#endif
}

uint scarp_only_depth(uint depth)
{
#ifdef SCARP_ONLY_DEPTH
    return SCARP_ONLY_DEPTH;
#else
    return depth;
#endif
}

// One rounding each. Without `precise`, which WebGL does not have, results go through an exclusive
// or with a number that the compiler does not know: 0.
#if defined(SCARP_FUSE)
#define SCARP_PRECISE
#define SCARP_KEPT(a) (a)
#elif defined(GL_ES)
#define SCARP_PRECISE
#define SCARP_KEPT(a) uintBitsToFloat(floatBitsToUint(a) ^ scarp_plan[0].zero)
#else
#define SCARP_PRECISE precise
#define SCARP_KEPT(a) (a)
#endif

float scarp_add(float a, float b)
{
    SCARP_PRECISE float c = a + b;
    return SCARP_KEPT(c);
}

float scarp_sub(float a, float b)
{
    SCARP_PRECISE float c = a - b;
    return SCARP_KEPT(c);
}

float scarp_mul(float a, float b)
{
    SCARP_PRECISE float c = a * b;
    return SCARP_KEPT(c);
}

#define scarp_vec3_of(x, y, z) vec3(x, y, z)
#define scarp_pick(condition, yes, no) ((condition) ? (yes) : (no))
#define scarp_pick_int(condition, yes, no) ((condition) ? (yes) : (no))
#define scarp_pick_uint(condition, yes, no) ((condition) ? (yes) : (no))
#define scarp_float_of_bits(a) uintBitsToFloat(a)
#define scarp_bits_of(a) floatBitsToUint(a)
#define scarp_int_of(a) int(a)
#define scarp_uint_of(a) uint(a)
#define scarp_float_of_int(a) float(a)
#define scarp_float_of_uint(a) float(a)
#define scarp_whole_of(a) int(a)
#define scarp_floor_of(a) floor(a)
#define scarp_rough_inverse(a) (1.0 / (a))
#define scarp_rough_root(a) sqrt(a)

/* Bits of floats, and the two operations that shading languages only approximate. */

#define SCARP_SIGN 0x80000000u

float scarp_magnitude(float a)
{
    return scarp_float_of_bits(scarp_bits_of(a) & 0x7fffffffu);
}

/* Whether the sign bit is set. */
bool scarp_is_negative(float a)
{
    return scarp_bits_of(a) >= SCARP_SIGN;
}

/* -a where `bit` is 1, a where it is 0. */
float scarp_with_bit(float a, uint bit)
{
    return scarp_float_of_bits(scarp_bits_of(a) ^ (bit << 31u));
}

/* One of two numbers. */
float scarp_either(bool condition, float yes, float no)
{
    return scarp_pick(condition, yes, no);
}

/* The hash as a signed number, rounded to float, in two parts: only the addition rounds. */
float scarp_lattice_value(uint hash)
{
    return scarp_add(scarp_mul(scarp_float_of_int(scarp_int_of(hash) >> 16u), 65536.0f),
            scarp_float_of_uint(hash & 0xffffu));
}

/*
 * 1 / x, rounded to nearest, of positive x; 0 of 2^126 and more. With x = m 2^(e - 150), the result
 * is q 2^(103 - e), q being 2^47 / m, rounded. The estimate's q may be off by a few; the remainder
 * 2^47 - q m is small, so the low 32 bits of both numbers give it.
 */
float scarp_inverse(float x)
{
    uint bits = scarp_bits_of(x);
    uint m = (bits & 0x7fffffu) | 0x800000u;
    uint e = (bits >> 23u) & 255u;
    float estimate = scarp_rough_inverse(scarp_float_of_bits(0x3f800000u | (bits & 0x7fffffu)));
    uint q = scarp_uint_of(scarp_whole_of(scarp_mul(estimate, 16777216.0f)));
    int r = scarp_int_of(0u - q * m);
    for (int i = 0; i < 16 && (r < 0 || r >= scarp_int_of(m)); i++) {
        q = scarp_pick_uint(r < 0, q - 1u, q + 1u);
        r = scarp_int_of(0u - q * m);
    }
    q = scarp_pick_uint(2 * r > scarp_int_of(m), q + 1u, q);
    float rounded = scarp_float_of_bits(((252u - e) << 23u) + q);
    return scarp_pick(e > 252u, 0.0f, rounded);
}

/*
 * The root of x, rounded to nearest, of normal x and 0. With x = m 2^(e - 150) and m doubled where
 * e is even, q is the root of 2^23 m, rounded.
 */
float scarp_root(float x)
{
    uint bits = scarp_bits_of(x);
    uint e = bits >> 23u;
    uint even = 1u - (e & 1u);
    uint m = ((bits & 0x7fffffu) | 0x800000u) << even;
    float estimate = scarp_rough_root(scarp_float_of_bits((bits
            & 0x7fffffu) + ((127u + even) << 23u)));
    uint q = scarp_uint_of(scarp_whole_of(scarp_mul(estimate, 8388608.0f)));
    int r = scarp_int_of((m << 23u) - q * q);
    for (int i = 0; i < 16 && (r < 0 || r > scarp_int_of(2u * q)); i++) {
        q = scarp_pick_uint(r < 0, q - 1u, q + 1u);
        r = scarp_int_of((m << 23u) - q * q);
    }
    q = scarp_pick_uint(r > scarp_int_of(q), q + 1u, q);
    float rounded = scarp_float_of_bits((((e + 127u) >> 1u) << 23u) + (q - 0x800000u));
    return scarp_pick(e == 0u, 0.0f, rounded);
}

/* The directions of gradients, computed, since memory is slower. */

/* The cosine of 11.25 degrees times 1, 3, 5, 7. */
float scarp_cosine(uint i)
{
    float first = scarp_pick(i == 0u, 0.980785280f, 0.831469612f);
    float second = scarp_pick(i == 2u, 0.555570233f, 0.195090322f);
    return scarp_pick(i < 2u, first, second);
}

/* One of the 16 directions of the plane. */
vec3 scarp_direction2(uint i)
{
    uint k = (i >> 1u) & 3u;
    return scarp_vec3_of(scarp_with_bit(scarp_cosine(k), (i >> 3u) & 1u),
            scarp_with_bit(scarp_cosine(3u - k), i & 1u), 0.0f);
}

/* One of the 12 edges of a cube, twice as long: 0 along z, y or x. */
vec3 scarp_direction3(uint i)
{
    uint axes = i >> 2u;
    float first = scarp_with_bit(2.0f, (i >> 1u) & 1u);
    float second = scarp_with_bit(2.0f, i & 1u);
    return scarp_vec3_of(scarp_pick(axes == 2u, 0.0f, first), scarp_pick(axes == 0u, second,
            scarp_pick(axes == 1u, 0.0f, first)), scarp_pick(axes == 0u, 0.0f, second));
}

/* A component of an edge after a quarter of a turn, times sqrt(3) / 2: 1, 2, -1 or -2, of which
   `axis` has two bits for each edge. */
float scarp_quarter_along(uint axis, uint i)
{
    uint bits = axis >> (2u * i);
    return scarp_with_bit(scarp_pick((bits & 2u) != 0u, 2.0f, 1.0f), bits & 1u);
}

#define SCARP_QUARTERS_X 0xbe0550u
#define SCARP_QUARTERS_Y 0x50be11u
#define SCARP_QUARTERS_Z 0x1144beu
#define SCARP_TWO_OVER_ROOT_3 1.15470054f

/* An edge after a quarter of a turn. */
vec3 scarp_quarter3(uint i)
{
    return scarp_vec3_of(scarp_mul(SCARP_TWO_OVER_ROOT_3, scarp_quarter_along(SCARP_QUARTERS_X, i)),
            scarp_mul(SCARP_TWO_OVER_ROOT_3, scarp_quarter_along(SCARP_QUARTERS_Y, i)),
            scarp_mul(SCARP_TWO_OVER_ROOT_3, scarp_quarter_along(SCARP_QUARTERS_Z, i)));
}

/* Vectors, and noise at a point. */

vec3 scarp_add3(vec3 a, vec3 b)
{
    return scarp_vec3_of(scarp_add(a.x, b.x), scarp_add(a.y, b.y), scarp_add(a.z, b.z));
}

vec3 scarp_sub3(vec3 a, vec3 b)
{
    return scarp_vec3_of(scarp_sub(a.x, b.x), scarp_sub(a.y, b.y), scarp_sub(a.z, b.z));
}

vec3 scarp_mul3(float a, vec3 b)
{
    return scarp_vec3_of(scarp_mul(a, b.x), scarp_mul(a, b.y), scarp_mul(a, b.z));
}

/* Noise at a point. diagonal: the derivatives xx, yy, zz; mixed: xy, xz, yz. In 2D outputs along z
   mean nothing. */
struct ScarpSample {
    float value;
    vec3 gradient;
    vec3 diagonal;
    vec3 mixed;
};

ScarpSample scarp_sample_of(float value, vec3 gradient, vec3 diagonal, vec3 mixed)
{
    ScarpSample s = ScarpSample(value, gradient, diagonal, mixed);
    return s;
}

ScarpSample scarp_constant(float value)
{
    vec3 none = vec3(0.0f, 0.0f, 0.0f);
    return scarp_sample_of(value, none, none, none);
}

ScarpSample scarp_sum_of(ScarpSample a, ScarpSample b)
{
    return scarp_sample_of(scarp_add(a.value, b.value), scarp_add3(a.gradient, b.gradient),
            scarp_add3(a.diagonal, b.diagonal), scarp_add3(a.mixed, b.mixed));
}

ScarpSample scarp_difference_of(ScarpSample a, ScarpSample b)
{
    return scarp_sample_of(scarp_sub(a.value, b.value), scarp_sub3(a.gradient, b.gradient),
            scarp_sub3(a.diagonal, b.diagonal), scarp_sub3(a.mixed, b.mixed));
}

/* What the lattice draws at its points, and its cells. */

#define SCARP_HASH_X 0x1a2012f5u
#define SCARP_HASH_Y 0x14e84743u
#define SCARP_HASH_Z 0xec1d7da1u
#define SCARP_HASH_K 0x9e3779b9u

uint scarp_hash_axis(uint i, uint multiplier, uint key)
{
    uint h = i * multiplier + key;
    return (h >> 8u) | (h << 24u);
}

uint scarp_hash2(uvec3 key, uint x, uint y)
{
    uint h = scarp_hash_axis(x, SCARP_HASH_X, key.x) ^ scarp_hash_axis(y, SCARP_HASH_Y, key.y);
    return h * (h + SCARP_HASH_K);
}

uint scarp_joined3(uvec3 key, uint x, uint y, uint z)
{
    return scarp_hash_axis(x, SCARP_HASH_X, key.x) ^ scarp_hash_axis(y, SCARP_HASH_Y, key.y)
            ^ scarp_hash_axis(z, SCARP_HASH_Z, key.z);
}

uint scarp_hash3(uvec3 key, uint x, uint y, uint z)
{
    uint h = scarp_joined3(key, x, y, z);
    return h * (h + SCARP_HASH_K);
}

/*
 * Vector noise has components that draw from one hash of each lattice point: these give the hash
 * that stands in for h in the draws of a component, 0, 1 or 2. Component 0 draws as noise with one
 * component does.
 *
 * Draws are made of the top of a hash, and so are these: the low bits of h (h + k) depend on those
 * of neighbours. In 2D, gradients are drawn by four bits, and components take four bits each. In
 * 3D, the upper half times 12 has the number of the gradient above its fraction, of which the next
 * component makes the same again. Values take all bits. There the halves change places, so that the
 * upper one moves every bit of the product. tests/hash_components.h has statistics of all pairs of
 * components.
 */
#define SCARP_HASH_VALUES_1 0x9e3779b1u
#define SCARP_HASH_VALUES_2 0x85ebca6bu

uint scarp_component_hash2(uint hash, uint component)
{
    return hash << (4u * component);
}

uint scarp_component_hash3(uint hash, uint component)
{
    uint twelves = scarp_pick_uint(component == 0u, 1u, scarp_pick_uint(component == 1u, 12u,
            144u));
    return ((hash >> 16u) * twelves) << 16u;
}

uint scarp_component_hash_values(uint hash, uint component)
{
    uint turned = (hash >> 16u) | (hash << 16u);
    uint product = turned * scarp_pick_uint(component == 1u, SCARP_HASH_VALUES_1,
            SCARP_HASH_VALUES_2);
    return scarp_pick_uint(component == 0u, hash, product);
}

/* The cells after and before one along an axis, within the period whose last cell is `last`. */
uint scarp_cell_after(uint last, uint cell)
{
    return scarp_pick_uint(cell == last, 0u, cell + 1u);
}

uint scarp_cell_before(uint last, uint cell)
{
    return scarp_pick_uint(cell == 0u, last, cell - 1u);
}

/* The cell that is `steps` further, -2 to 2. */
uint scarp_cell_beside(uint last, uint cell, int steps)
{
    uint c = cell;
    if (steps > 0) {
        c = scarp_cell_after(last, c);
    }
    if (steps > 1) {
        c = scarp_cell_after(last, c);
    }
    if (steps < 0) {
        c = scarp_cell_before(last, c);
    }
    if (steps < -1) {
        c = scarp_cell_before(last, c);
    }
    return c;
}

/* A point of one octave: along each axis the lattice points on either side, modulo 2^32 or the
   period, and the position in between, in [0, 1] (rounding can reach 1; the noise is continuous
   there). In 2D all of z is 0. */
struct ScarpLocation {
    uvec3 cell;
    uvec3 next;
    vec3 t;
};

/* The lattice of an octave. */
struct ScarpLattice {
    uvec3 key; /* of the hash */
    uvec3 last; /* the last cell of the period along each axis; 2^32 - 1 without period */
    bool flows; /* whether gradients are turned */
    vec4 turn; /* how far: the cosine and sine of an angle, then of twice that */
    float jitter; /* how far features of cellular noise stray, in units of 2^-32 cells */
    float middle; /* what is subtracted from distances */
    uint component; /* which component of vector noise; 0 of noise that has one */
};

/* Bases that interpolate between lattice points. */

#define SCARP_QUINTIC 0u

/* A fade with its derivatives. */
struct ScarpFade {
    float u;
    float du;
    float ddu;
};

/*
 * quintic: u = 6t^5 - 15t^4 + 10t^3   u' = 30 t^2 (t-1)^2   u'' = 60 t (t-1) (2t-1)
 * cubic:   u = 3t^2 - 2t^3            u' = 6 t (1-t)        u'' = 6 - 12t
 *
 * The quintic is evaluated as t^3 ((t-1) (6t-9) + 1), where nothing cancels. Over all floats in [0,
 * 1] that errs by at most 1.94e-7, never exceeds 1 + 2^-23, and is exact at 0 and 1. The usual
 * form, t^3 (t (6t-15) + 10), takes as many operations and errs by 1.1e-6.
 */
ScarpFade scarp_fade(uint kind, float t)
{
    float s = scarp_sub(t, 1.0f);
    float ts = scarp_mul(t, s);
    ScarpFade f;
    if (kind == SCARP_QUINTIC) {
        f.u = scarp_mul(scarp_mul(scarp_mul(t, t), t), scarp_add(scarp_mul(s, scarp_sub(scarp_mul(t,
                6.0f), 9.0f)), 1.0f));
        f.du = scarp_mul(30.0f, scarp_mul(ts, ts));
        f.ddu = scarp_mul(scarp_mul(60.0f, ts), scarp_add(t, s));
    } else {
        f.u = scarp_mul(scarp_mul(t, t), scarp_sub(3.0f, scarp_mul(2.0f, t)));
        f.du = scarp_mul(-6.0f, ts);
        f.ddu = scarp_sub(6.0f, scarp_mul(12.0f, t));
    }
    return f;
}

float scarp_mix(float a, float b, float u)
{
    return scarp_add(a, scarp_mul(u, scarp_sub(b, a)));
}

/* a x + b */
struct ScarpLine {
    float a;
    float b;
};

/* What a lattice column contributes. */
struct ScarpColumn {
    ScarpLine value;
    ScarpLine y;
    ScarpLine z;
    ScarpLine yy;
    ScarpLine yz;
    ScarpLine zz;
};

/* `is_flat`: nothing depends on x, all a are 0. */
float scarp_at(ScarpLine l, float x, bool is_flat)
{
    return scarp_pick(is_flat, l.b, scarp_add(scarp_mul(l.a, x), l.b));
}

/* The value and its derivatives along x, from the lines of both columns. */
float scarp_across(ScarpLine l, ScarpLine r, float x, ScarpFade f, bool is_flat)
{
    return scarp_mix(scarp_at(l, x, is_flat), scarp_at(r, scarp_sub(x, 1.0f), is_flat), f.u);
}

float scarp_across_dx(ScarpLine l, ScarpLine r, float x, ScarpFade f, bool is_flat)
{
    float step = scarp_mul(f.du, scarp_sub(scarp_at(r, scarp_sub(x, 1.0f), is_flat), scarp_at(l, x,
            is_flat)));
    return scarp_pick(is_flat, step, scarp_add(scarp_mix(l.a, r.a, f.u), step));
}

float scarp_across_dxx(ScarpLine l, ScarpLine r, float x, ScarpFade f, bool is_flat)
{
    float bend = scarp_mul(f.ddu, scarp_sub(scarp_at(r, scarp_sub(x, 1.0f), is_flat), scarp_at(l, x,
            is_flat)));
    return scarp_pick(is_flat, bend, scarp_add(scarp_mul(scarp_mul(2.0f, f.du), scarp_sub(r.a,
            l.a)), bend));
}

ScarpSample scarp_join(ScarpColumn l, ScarpColumn r, float x, ScarpFade f, bool is_flat)
{
    ScarpSample s = ScarpSample(scarp_across(l.value, r.value, x, f, is_flat),
            vec3(scarp_across_dx(l.value, r.value, x, f, is_flat), scarp_across(l.y, r.y, x, f,
            is_flat), scarp_across(l.z, r.z, x, f, is_flat)), vec3(scarp_across_dxx(l.value,
            r.value, x, f, is_flat), scarp_across(l.yy, r.yy, x, f, is_flat), scarp_across(l.zz,
            r.zz, x, f, is_flat)), vec3(scarp_across_dx(l.y, r.y, x, f, is_flat),
            scarp_across_dx(l.z, r.z, x, f, is_flat), scarp_across(l.yz, r.yz, x, f, is_flat)));
    return s;
}

/* Gradient noise (Perlin 1985, 2002). */

/* The number of the direction that a hash draws. In 3D the upper half of the hash, times 12,
   chooses: any two are drawn equally often within 1 in 5461, so that the noise is the same along
   all axes. */
uint scarp_direction_index2(uint hash)
{
    return hash >> 28u;
}

uint scarp_direction_index3(uint hash)
{
    return ((hash >> 16u) * 12u) >> 16u;
}

/* A direction of noise that flows: some make two turns per turn of the phase, in 2D backwards. */
vec3 scarp_turned2(uint drawn, vec4 turn)
{
    bool is_opposite = drawn >= 8u;
    uint i = scarp_pick_uint(is_opposite, drawn ^ 9u, drawn);
    bool is_quick = ((i ^ (i >> 1u) ^ (i >> 3u)) & 1u) != 0u;
    vec3 g = scarp_direction2(i);
    float c = scarp_either(is_quick, turn.z, turn.x);
    float s = scarp_either(is_quick, -turn.w, turn.y);
    float x = scarp_sub(scarp_mul(c, g.x), scarp_mul(s, g.y));
    float y = scarp_add(scarp_mul(c, g.y), scarp_mul(s, g.x));
    return scarp_vec3_of(scarp_pick(is_opposite, -x, x), scarp_pick(is_opposite, -y, y), 0.0f);
}

vec3 scarp_turned3(uint i, vec4 turn)
{
    bool is_quick = ((0x93c >> i) & 1) != 0; /* 2, 3, 4, 5, 8 and 11 */
    float c = scarp_either(is_quick, turn.z, turn.x);
    float s = scarp_either(is_quick, turn.w, turn.y);
    return scarp_add3(scarp_mul3(c, scarp_direction3(i)), scarp_mul3(s, scarp_quarter3(i)));
}

vec3 scarp_drawn2(ScarpLattice l, uint x, uint y)
{
    uint i = scarp_direction_index2(scarp_component_hash2(scarp_hash2(l.key, x, y), l.component));
    vec3 g = scarp_direction2(i);
    if (l.flows) {
        g = scarp_turned2(i, l.turn);
    }
    return g;
}

vec3 scarp_drawn3(ScarpLattice l, uint x, uint y, uint z)
{
    uint i = scarp_direction_index3(scarp_component_hash3(scarp_hash3(l.key, x, y, z),
            l.component));
    vec3 g = scarp_direction3(i);
    if (l.flows) {
        g = scarp_turned3(i, l.turn);
    }
    return g;
}

/* Column x of the cell: v is the fade along y. */
ScarpColumn scarp_gradient_column2(ScarpLattice l, uint x, ScarpLocation p, ScarpFade v)
{
    vec3 g0 = scarp_drawn2(l, x, p.cell.y);
    vec3 g1 = scarp_drawn2(l, x, p.next.y);
    float dgx = scarp_sub(g1.x, g0.x);
    float dot0 = scarp_mul(g0.y, p.t.y);
    float dot1 = scarp_mul(g1.y, scarp_sub(p.t.y, 1.0f));
    float ddot = scarp_sub(dot1, dot0);
    ScarpColumn c = ScarpColumn(ScarpLine(scarp_add(g0.x, scarp_mul(v.u, dgx)), scarp_add(dot0,
            scarp_mul(v.u, ddot))), ScarpLine(scarp_mul(v.du, dgx), scarp_add(scarp_mix(g0.y, g1.y,
            v.u), scarp_mul(v.du, ddot))), ScarpLine(0.0f, 0.0f), ScarpLine(scarp_mul(v.ddu, dgx),
            scarp_add(scarp_mul(scarp_mul(2.0f, v.du), scarp_sub(g1.y, g0.y)), scarp_mul(v.ddu,
            ddot))), ScarpLine(0.0f, 0.0f), ScarpLine(0.0f, 0.0f));
    return c;
}

/* A lattice edge along z, interpolated over z. */
struct ScarpEdge {
    ScarpLine value; /* in x */
    float z;
    float zz; /* first and second z derivative of value.b */
    float gy;
    float dgy; /* y component of the gradient, and its z derivative */
    float dgx; /* difference of the x components of the corners */
};

/* The edge at column x and row y of cells, ty from it along y; w is the fade along z. */
ScarpEdge scarp_gradient_edge(ScarpLattice l, uint x, uint y, float ty, ScarpLocation p,
        ScarpFade w)
{
    vec3 g0 = scarp_drawn3(l, x, y, p.cell.z);
    vec3 g1 = scarp_drawn3(l, x, y, p.next.z);
    vec3 dg = scarp_sub3(g1, g0);
    float dot0 = scarp_add(scarp_mul(g0.y, ty), scarp_mul(g0.z, p.t.z));
    float dot1 = scarp_add(scarp_mul(g1.y, ty), scarp_mul(g1.z, scarp_sub(p.t.z, 1.0f)));
    float ddot = scarp_sub(dot1, dot0);
    ScarpEdge e = ScarpEdge(ScarpLine(scarp_add(g0.x, scarp_mul(w.u, dg.x)), scarp_add(dot0,
            scarp_mul(w.u, ddot))), scarp_add(scarp_add(g0.z, scarp_mul(w.u, dg.z)), scarp_mul(w.du,
            ddot)), scarp_add(scarp_mul(scarp_mul(2.0f, w.du), dg.z), scarp_mul(w.ddu, ddot)),
            scarp_add(g0.y, scarp_mul(w.u, dg.y)), scarp_mul(w.du, dg.y), dg.x);
    return e;
}

ScarpColumn scarp_gradient_column3(ScarpLattice l, uint x, ScarpLocation p, ScarpFade v,
        ScarpFade w)
{
    ScarpEdge e0 = scarp_gradient_edge(l, x, p.cell.y, p.t.y, p, w);
    ScarpEdge e1 = scarp_gradient_edge(l, x, p.next.y, scarp_sub(p.t.y, 1.0f), p, w);
    float da = scarp_sub(e1.value.a, e0.value.a);
    float db = scarp_sub(e1.value.b, e0.value.b);
    float dgy = scarp_sub(e1.gy, e0.gy);
    float dz = scarp_sub(e1.z, e0.z);
    float ddgx = scarp_sub(e1.dgx, e0.dgx);
    float dgx = scarp_add(e0.dgx, scarp_mul(v.u, ddgx)); /* interpolated over y */
    ScarpColumn c = ScarpColumn(ScarpLine(scarp_add(e0.value.a, scarp_mul(v.u, da)),
            scarp_add(e0.value.b, scarp_mul(v.u, db))), ScarpLine(scarp_mul(v.du, da),
            scarp_add(scarp_add(e0.gy, scarp_mul(v.u, dgy)), scarp_mul(v.du, db))),
            ScarpLine(scarp_mul(w.du, dgx), scarp_add(e0.z, scarp_mul(v.u, dz))),
            ScarpLine(scarp_mul(v.ddu, da), scarp_add(scarp_mul(scarp_mul(2.0f, v.du), dgy),
            scarp_mul(v.ddu, db))), ScarpLine(scarp_mul(v.du, scarp_mul(w.du, ddgx)),
            scarp_add(scarp_mix(e0.dgy, e1.dgy, v.u), scarp_mul(v.du, dz))),
            ScarpLine(scarp_mul(w.ddu, dgx), scarp_mix(e0.zz, e1.zz, v.u)));
    return c;
}

ScarpSample scarp_gradient_at2(ScarpLattice l, uint kind, ScarpLocation p)
{
    ScarpFade v = scarp_fade(kind, p.t.y);
    return scarp_join(scarp_gradient_column2(l, p.cell.x, p, v), scarp_gradient_column2(l, p.next.x,
            p, v), p.t.x, scarp_fade(kind, p.t.x), false);
}

ScarpSample scarp_gradient_at3(ScarpLattice l, uint kind, ScarpLocation p)
{
    ScarpFade v = scarp_fade(kind, p.t.y);
    ScarpFade w = scarp_fade(kind, p.t.z);
    return scarp_join(scarp_gradient_column3(l, p.cell.x, p, v, w), scarp_gradient_column3(l,
            p.next.x, p, v, w), p.t.x, scarp_fade(kind, p.t.x), false);
}

ScarpSample scarp_gradient_at(ScarpLattice l, uint kind, ScarpLocation p, int dimensions)
{
    if (dimensions == 2) {
        return scarp_gradient_at2(l, kind, p);
    }
    return scarp_gradient_at3(l, kind, p);
}

/* Value noise. */

float scarp_value2(ScarpLattice l, uint x, uint y)
{
    return scarp_lattice_value(scarp_component_hash_values(scarp_hash2(l.key, x, y), l.component));
}

float scarp_value3(ScarpLattice l, uint x, uint y, uint z)
{
    return scarp_lattice_value(scarp_component_hash_values(scarp_hash3(l.key, x, y, z),
            l.component));
}

ScarpColumn scarp_value_column2(ScarpLattice l, uint x, ScarpLocation p, ScarpFade v)
{
    float c0 = scarp_value2(l, x, p.cell.y);
    float c1 = scarp_value2(l, x, p.next.y);
    float d = scarp_sub(c1, c0);
    ScarpColumn c = ScarpColumn(ScarpLine(0.0f, scarp_add(c0, scarp_mul(v.u, d))), ScarpLine(0.0f,
            scarp_mul(v.du, d)), ScarpLine(0.0f, 0.0f), ScarpLine(0.0f, scarp_mul(v.ddu, d)),
            ScarpLine(0.0f, 0.0f), ScarpLine(0.0f, 0.0f));
    return c;
}

ScarpColumn scarp_value_column3(ScarpLattice l, uint x, ScarpLocation p, ScarpFade v, ScarpFade w)
{
    float c00 = scarp_value3(l, x, p.cell.y, p.cell.z);
    float c01 = scarp_value3(l, x, p.cell.y, p.next.z);
    float c10 = scarp_value3(l, x, p.next.y, p.cell.z);
    float c11 = scarp_value3(l, x, p.next.y, p.next.z);
    float dz0 = scarp_sub(c01, c00);
    float dz1 = scarp_sub(c11, c10);
    float e0 = scarp_add(c00, scarp_mul(w.u, dz0));
    float e1 = scarp_add(c10, scarp_mul(w.u, dz1));
    float dy = scarp_sub(e1, e0);
    float ddz = scarp_sub(dz1, dz0);
    float dz = scarp_add(dz0, scarp_mul(v.u, ddz)); /* interpolated over y */
    ScarpColumn c = ScarpColumn(ScarpLine(0.0f, scarp_add(e0, scarp_mul(v.u, dy))), ScarpLine(0.0f,
            scarp_mul(v.du, dy)), ScarpLine(0.0f, scarp_mul(w.du, dz)), ScarpLine(0.0f,
            scarp_mul(v.ddu, dy)), ScarpLine(0.0f, scarp_mul(v.du, scarp_mul(w.du, ddz))),
            ScarpLine(0.0f, scarp_mul(w.ddu, dz)));
    return c;
}

ScarpSample scarp_value_at2(ScarpLattice l, uint kind, ScarpLocation p)
{
    ScarpFade v = scarp_fade(kind, p.t.y);
    return scarp_join(scarp_value_column2(l, p.cell.x, p, v), scarp_value_column2(l, p.next.x, p,
            v), p.t.x, scarp_fade(kind, p.t.x), true);
}

ScarpSample scarp_value_at3(ScarpLattice l, uint kind, ScarpLocation p)
{
    ScarpFade v = scarp_fade(kind, p.t.y);
    ScarpFade w = scarp_fade(kind, p.t.z);
    return scarp_join(scarp_value_column3(l, p.cell.x, p, v, w), scarp_value_column3(l, p.next.x, p,
            v, w), p.t.x, scarp_fade(kind, p.t.x), true);
}

ScarpSample scarp_value_at(ScarpLattice l, uint kind, ScarpLocation p, int dimensions)
{
    if (dimensions == 2) {
        return scarp_value_at2(l, kind, p);
    }
    return scarp_value_at3(l, kind, p);
}

/* Simplex noise (Perlin 2001, Gustavson 2005). */

/* What a vertex adds; `g` is its gradient, `r2` is r^2. */
ScarpSample scarp_vertex_at(vec3 d, vec3 g, float r2, int dimensions)
{
    float across2 = scarp_mul(d.y, d.y);
    float across = scarp_mul(g.y, d.y);
    if (dimensions == 3) {
        across2 = scarp_add(across2, scarp_mul(d.z, d.z));
        across = scarp_add(across, scarp_mul(g.z, d.z));
    }
    float left = scarp_sub(scarp_sub(r2, across2), scarp_mul(d.x, d.x));
    float w = scarp_pick(left > 0.0f, left, 0.0f);
    float q = scarp_add(scarp_mul(g.x, d.x), across);
    float w2 = scarp_mul(w, w);
    float w3 = scarp_mul(8.0f, scarp_mul(w2, w));
    float w4 = scarp_mul(w2, w2);
    float wq = scarp_mul(w3, q);
    float bend = scarp_mul(scarp_mul(48.0f, w2), q);
    ScarpSample s = scarp_constant(scarp_mul(w4, q));
    s.gradient.x = scarp_sub(scarp_mul(w4, g.x), scarp_mul(wq, d.x));
    s.gradient.y = scarp_sub(scarp_mul(w4, g.y), scarp_mul(wq, d.y));
    s.diagonal.x = scarp_sub(scarp_mul(scarp_mul(bend, d.x), d.x), scarp_mul(w3,
            scarp_add(scarp_mul(scarp_mul(2.0f, g.x), d.x), q)));
    s.diagonal.y = scarp_sub(scarp_mul(scarp_mul(bend, d.y), d.y), scarp_mul(w3,
            scarp_add(scarp_mul(scarp_mul(2.0f, g.y), d.y), q)));
    s.mixed.x = scarp_sub(scarp_mul(scarp_mul(bend, d.x), d.y), scarp_mul(w3,
            scarp_add(scarp_mul(g.x, d.y), scarp_mul(g.y, d.x))));
    if (dimensions == 3) {
        s.gradient.z = scarp_sub(scarp_mul(w4, g.z), scarp_mul(wq, d.z));
        s.diagonal.z = scarp_sub(scarp_mul(scarp_mul(bend, d.z), d.z), scarp_mul(w3,
                scarp_add(scarp_mul(scarp_mul(2.0f, g.z), d.z), q)));
        s.mixed.y = scarp_sub(scarp_mul(scarp_mul(bend, d.x), d.z), scarp_mul(w3,
                scarp_add(scarp_mul(g.x, d.z), scarp_mul(g.z, d.x))));
        s.mixed.z = scarp_sub(scarp_mul(scarp_mul(bend, d.y), d.z), scarp_mul(w3,
                scarp_add(scarp_mul(g.y, d.z), scarp_mul(g.z, d.y))));
    }
    return s;
}

/*
 * 2D: triangles of edge 1 in rows along x, sqrt(3) / 2 apart: p.t.y and the cells along y count
 * rows. In odd rows vertex i stands at x = i + 1/2. The triangle's lower side lies in the row below
 * p or its upper side in the row above; two of its corners are the same for both.
 */
#define SCARP_ROW_HEIGHT 0.866025404f /* sqrt(3) / 2 */
#define SCARP_TRIANGLE_R2 0.75f

/* The vertex `column` to the right of the cell, in row y, at d from p. */
ScarpSample scarp_vertex2(ScarpLattice l, ScarpLocation p, int column, uint y, vec3 d)
{
    uint x = scarp_cell_beside(l.last.x, p.cell.x, column);
    return scarp_vertex_at(d, scarp_direction2(scarp_direction_index2(scarp_hash2(l.key, x, y))),
            SCARP_TRIANGLE_R2, 2);
}

ScarpSample scarp_simplex_at2(ScarpLattice l, ScarpLocation p)
{
    bool is_odd = (p.cell.y & 1u) != 0u;
    float shift = scarp_mul(0.5f, p.t.y);
    float start = scarp_sub(p.t.x, scarp_pick(is_odd, 0.5f, 0.0f));
    bool is_before = start < shift; /* p is left of the line that vertex 0 begins */
    int k = scarp_pick_int(is_before, -1, 0);
    int above = scarp_pick_int(is_odd, k + 1, k);
    float x = scarp_pick(is_before, scarp_add(start, 1.0f), start); /* from vertex k of the row below */
    float y = scarp_mul(SCARP_ROW_HEIGHT, p.t.y);
    float y_above = scarp_sub(y, SCARP_ROW_HEIGHT);
    bool is_lower = scarp_add(x, shift) < 1.0f;
    ScarpSample a = scarp_vertex2(l, p, k + 1, p.cell.y, scarp_vec3_of(scarp_sub(x, 1.0f), y,
            0.0f));
    ScarpSample b = scarp_vertex2(l, p, above, p.next.y, scarp_vec3_of(scarp_sub(x, 0.5f), y_above,
            0.0f));
    ScarpSample c = scarp_vertex2(l, p, scarp_pick_int(is_lower, k, above + 1),
            scarp_pick_uint(is_lower, p.cell.y, p.next.y), scarp_vec3_of(scarp_pick(is_lower, x,
            scarp_sub(x, 1.5f)), scarp_pick(is_lower, y, y_above), 0.0f));
    return scarp_sum_of(scarp_sum_of(a, b), c);
}

/*
 * 3D: the corners and the centres of cubes. A tetrahedron has two centres, next to each other along
 * the axis on which p is furthest from the first; and two corners, next to each other along the
 * axis on which it is nearest. (r^2 is a little less than 1/2, so that the other vertices add
 * exactly 0 in float arithmetic, too: rows of grids may add any of them.)
 */
#define SCARP_TETRAHEDRON_R2 0.499999523f /* 1/2 - 2^-21 */

/* Centres draw with another number than corners. */
#define SCARP_HASH_CENTRE 0xbcfa3e4du

/* A vertex: how many cells its own is from that of p along each axis, and where p lies from it. */
struct ScarpVertex {
    int x;
    int y;
    int z;
    vec3 d;
};

/* Draws with HASH_K or HASH_CENTRE. */
ScarpSample scarp_vertex3(ScarpLattice l, ScarpLocation p, ScarpVertex v, uint hash_k)
{
    uint h = scarp_joined3(l.key, scarp_cell_beside(l.last.x, p.cell.x, v.x),
            scarp_cell_beside(l.last.y, p.cell.y, v.y), scarp_cell_beside(l.last.z, p.cell.z, v.z));
    vec3 g = scarp_direction3(scarp_direction_index3(h * (h + hash_k)));
    return scarp_vertex_at(v.d, g, SCARP_TETRAHEDRON_R2, 3);
}

/* The second centre, the first corner and the second one along an axis: how many cells they are
   from that of p, and where p lies from them. */
struct ScarpEnds {
    int centre;
    int corner0;
    int corner1;
    float d_centre;
    float d_corner0;
    float d_corner1;
};

/* p lies at t from the first centre. */
ScarpEnds scarp_ends_of(float t, bool is_furthest, bool is_nearest)
{
    bool is_up = !(t < 0.0f);
    float side = scarp_pick(is_up, 0.5f, -0.5f);
    ScarpEnds e = ScarpEnds(0, 0, 0, t, scarp_sub(t, side), scarp_sub(t, side));
    e.corner0 = scarp_pick_int(is_up, 1, 0);
    e.corner1 = e.corner0;
    if (is_furthest) {
        e.centre = scarp_pick_int(is_up, 1, -1);
        e.d_centre = scarp_sub(t, scarp_pick(is_up, 1.0f, -1.0f));
    }
    if (is_nearest) {
        e.corner1 = 1 - e.corner0;
        e.d_corner1 = scarp_add(t, side);
    }
    return e;
}

ScarpSample scarp_simplex_at3(ScarpLattice l, ScarpLocation p)
{
    vec3 t = scarp_sub3(p.t, scarp_vec3_of(0.5f, 0.5f, 0.5f));
    vec3 m = scarp_vec3_of(scarp_magnitude(t.x), scarp_magnitude(t.y), scarp_magnitude(t.z));
    bool far_x = m.x >= m.y && m.x >= m.z;
    bool far_y = !far_x && m.y >= m.z;
    bool near_z = m.z <= m.x && m.z <= m.y;
    bool near_y = !near_z && m.y <= m.x;
    ScarpEnds x = scarp_ends_of(t.x, far_x, !near_z && !near_y);
    ScarpEnds y = scarp_ends_of(t.y, far_y, near_y);
    ScarpEnds z = scarp_ends_of(t.z, !far_x && !far_y, near_z);
    ScarpVertex centre0 = ScarpVertex(0, 0, 0, t);
    ScarpVertex centre1 = ScarpVertex(x.centre, y.centre, z.centre, vec3(x.d_centre, y.d_centre,
            z.d_centre));
    ScarpVertex corner0 = ScarpVertex(x.corner0, y.corner0, z.corner0, vec3(x.d_corner0,
            y.d_corner0, z.d_corner0));
    ScarpVertex corner1 = ScarpVertex(x.corner1, y.corner1, z.corner1, vec3(x.d_corner1,
            y.d_corner1, z.d_corner1));
    ScarpSample centres = scarp_sum_of(scarp_vertex3(l, p, centre0, SCARP_HASH_CENTRE),
            scarp_vertex3(l, p, centre1, SCARP_HASH_CENTRE));
    ScarpSample corners = scarp_sum_of(scarp_vertex3(l, p, corner0, SCARP_HASH_K), scarp_vertex3(l,
            p, corner1, SCARP_HASH_K));
    return scarp_sum_of(scarp_sum_of(corners, centres), scarp_constant(0.0f)); /* which turns a sum of -0 into 0 */
}

ScarpSample scarp_simplex_at(ScarpLattice l, ScarpLocation p, int dimensions)
{
    if (dimensions == 2) {
        return scarp_simplex_at2(l, p);
    }
    return scarp_simplex_at3(l, p);
}

/* Cellular noise (Worley 1996). */

/* What a cell draws beside v_0, which is its hash. */
#define SCARP_FEATURE_Y 0xe41130e9u
#define SCARP_FEATURE_Z 0x6ecea30du
#define SCARP_FEATURE_ID 0xc603dc87u

/* Where a point lies from the feature of a cell, and the hash of that cell. */
struct ScarpFeature {
    vec3 d;
    float s;
    uint hash;
};

/* How far t is from the feature of the cell `step` away, along an axis on which it drew v. */
float scarp_feature_distance(float t, int step, float jitter, uint v)
{
    float middle = scarp_add(scarp_float_of_int(step), 0.5f);
    return scarp_sub(t, scarp_add(middle, scarp_mul(jitter, scarp_lattice_value(v))));
}

/* The feature of the cell that is (x, y, z) away from that of p. */
ScarpFeature scarp_feature_at(ScarpLattice l, ScarpLocation p, int x, int y, int z, int dimensions)
{
    uint cx = scarp_cell_beside(l.last.x, p.cell.x, x);
    uint cy = scarp_cell_beside(l.last.y, p.cell.y, y);
    ScarpFeature f = ScarpFeature(vec3(0.0f, 0.0f, 0.0f), 0.0f, scarp_hash2(l.key, cx, cy));
    if (dimensions == 3) {
        f.hash = scarp_hash3(l.key, cx, cy, scarp_cell_beside(l.last.z, p.cell.z, z));
    }
    f.d.x = scarp_feature_distance(p.t.x, x, l.jitter, f.hash);
    f.d.y = scarp_feature_distance(p.t.y, y, l.jitter, f.hash * SCARP_FEATURE_Y);
    float across2 = scarp_mul(f.d.y, f.d.y);
    if (dimensions == 3) {
        f.d.z = scarp_feature_distance(p.t.z, z, l.jitter, f.hash * SCARP_FEATURE_Z);
        across2 = scarp_add(across2, scarp_mul(f.d.z, f.d.z));
    }
    f.s = scarp_add(scarp_mul(f.d.x, f.d.x), across2);
    return f;
}

/* 0, or NaN where a fraction is NaN, which a search for the least would pass over. */
float scarp_zero_at(ScarpLocation p)
{
    return scarp_mul(0.0f, scarp_add(p.t.x, scarp_add(p.t.y, p.t.z)));
}

/* Further than any search ends. */
#define SCARP_FAR_AWAY 64.0f

/* The features that are nearest. */
struct ScarpNearest {
    ScarpFeature first;
    ScarpFeature second;
};

/* Only a strictly nearer feature replaces one. */
ScarpNearest scarp_nearest_with(ScarpNearest n, ScarpFeature f)
{
    ScarpNearest m = n;
    if (f.s < n.first.s) {
        m.second = n.first;
        m.first = f;
    } else if (f.s < n.second.s) {
        m.second = f;
    }
    return m;
}

/* The square of the gap to the cell `step` away along an axis. */
float scarp_gap2(float t, int step)
{
    float gap = scarp_pick(step > 0, scarp_sub(scarp_float_of_int(step), t), scarp_sub(t,
            scarp_float_of_int(step + 1)));
    return scarp_pick(step == 0, 0.0f, scarp_mul(gap, gap));
}

/* Whether a cell, and so its feature, is further away than s, by more than rounding. */
bool scarp_is_beyond(ScarpLocation p, int x, int y, int z, float s)
{
    return scarp_add(scarp_add(scarp_gap2(p.t.x, x), scarp_gap2(p.t.y, y)), scarp_gap2(p.t.z,
            z)) > scarp_mul(1.001f, s);
}

/* Whether the search looks at a cell. */
bool scarp_is_searched(ScarpLocation p, int ring, int x, int y, int z, float s)
{
    bool is_inside = x > -2 && x < 2 && y > -2 && y < 2 && z > -2 && z < 2;
    return ring == 1 || !(is_inside || scarp_is_beyond(p, x, y, z, s));
}

/*
 * Searches the cells around that of p, then those two steps away, of which few are near enough. No
 * feature beyond can be one of the two: it is at least 2 away from p, and both are nearer. (3^n
 * cells do not suffice: the nearest feature of these may be sqrt(n) away, and features two cells
 * off a little more than 1.)
 */
ScarpNearest scarp_nearest_at(ScarpLattice l, ScarpLocation p, int dimensions)
{
    float far = scarp_add(SCARP_FAR_AWAY, scarp_zero_at(p)); /* nothing is nearer than NaN */
    ScarpFeature none = ScarpFeature(vec3(far, far, far), far, 0u);
    ScarpNearest n = ScarpNearest(none, none);
    for (int ring = 1; ring <= 2; ring++) {
        int depth = scarp_pick_int(dimensions == 3, ring, 0);
        for (int z = -depth; z <= depth; z++) {
            for (int y = -ring; y <= ring; y++) {
                for (int x = -ring; x <= ring; x++) {
                    if (scarp_is_searched(p, ring, x, y, z, n.second.s)) {
                        n = scarp_nearest_with(n, scarp_feature_at(l, p, x, y, z, dimensions));
                    }
                }
            }
        }
    }
    return n;
}

/* Below this, a point lies on the feature. */
#define SCARP_NO_DISTANCE 8.27180613e-25f

/* The distance from a feature. */
ScarpSample scarp_distance_to(ScarpFeature f)
{
    float distance = scarp_root(f.s);
    float r = scarp_pick(f.s <= SCARP_NO_DISTANCE, 0.0f, scarp_inverse(distance));
    vec3 g = scarp_mul3(r, f.d);
    ScarpSample s = ScarpSample(distance, g, vec3(scarp_mul(r, scarp_sub(1.0f, scarp_mul(g.x,
            g.x))), scarp_mul(r, scarp_sub(1.0f, scarp_mul(g.y, g.y))), scarp_mul(r, scarp_sub(1.0f,
            scarp_mul(g.z, g.z)))), vec3(-scarp_mul(r, scarp_mul(g.x, g.y)), -scarp_mul(r,
            scarp_mul(g.x, g.z)), -scarp_mul(r, scarp_mul(g.y, g.z))));
    return s;
}

/* What a feature adds before the root; the gradient without the factor 8, the Hessian too. */
ScarpSample scarp_soft_term(ScarpFeature f)
{
    float a = scarp_pick(f.s < 1.0f, scarp_sub(1.0f, f.s), 0.0f);
    float a2 = scarp_mul(a, a);
    float a4 = scarp_mul(a2, a2);
    float a6 = scarp_mul(a4, a2);
    float a7 = scarp_mul(a6, a);
    vec3 b = scarp_mul3(scarp_mul(14.0f, a6), f.d);
    ScarpSample s = ScarpSample(scarp_mul(a4, a4), scarp_mul3(a7, f.d),
            vec3(scarp_sub(scarp_mul(b.x, f.d.x), a7), scarp_sub(scarp_mul(b.y, f.d.y), a7),
            scarp_sub(scarp_mul(b.z, f.d.z), a7)), vec3(scarp_mul(b.x, f.d.y), scarp_mul(b.x,
            f.d.z), scarp_mul(b.y, f.d.z)));
    return s;
}

/* Below this, V^2 counts as 0: derivatives are no more than its rounding there. */
#define SCARP_NO_SUM 7.52316385e-37f

ScarpSample scarp_soft_root(ScarpSample sum)
{
    float v = scarp_root(sum.value);
    float r = scarp_pick(sum.value <= SCARP_NO_SUM, 0.0f, scarp_mul(8.0f, scarp_inverse(v)));
    float q = scarp_mul(0.125f, r); /* 1 / V */
    vec3 g = scarp_mul3(r, sum.gradient);
    vec3 squares = scarp_vec3_of(scarp_mul(g.x, g.x), scarp_mul(g.y, g.y), scarp_mul(g.z, g.z));
    vec3 products = scarp_vec3_of(scarp_mul(g.x, g.y), scarp_mul(g.x, g.z), scarp_mul(g.y, g.z));
    return scarp_sample_of(-v, g, scarp_sub3(scarp_mul3(q, squares), scarp_mul3(r, sum.diagonal)),
            scarp_sub3(scarp_mul3(q, products), scarp_mul3(r, sum.mixed)));
}

ScarpSample scarp_soft_at(ScarpLattice l, ScarpLocation p, int dimensions)
{
    int depth = scarp_pick_int(dimensions == 3, 1, 0);
    float zero = scarp_zero_at(p);
    vec3 zeros = vec3(zero, zero, zero);
    ScarpSample sum = ScarpSample(zero, zeros, zeros, zeros);
    for (int z = -depth; z <= depth; z++) {
        for (int y = -1; y <= 1; y++) {
            for (int x = -1; x <= 1; x++) {
                sum = scarp_sum_of(sum, scarp_soft_term(scarp_feature_at(l, p, x, y, z,
                        dimensions)));
            }
        }
    }
    return scarp_soft_root(sum);
}

/* Each cell's own value, in units of 2^-31; all derivatives are 0. */
ScarpSample scarp_cell_value(ScarpFeature f)
{
    float zero = scarp_mul(0.0f, f.s); /* or NaN */
    vec3 zeros = vec3(zero, zero, zero);
    return scarp_sample_of(scarp_add(scarp_lattice_value(f.hash * SCARP_FEATURE_ID), zero), zeros,
            zeros, zeros);
}

/* The numbers of enum scarp_basis. */
#define SCARP_CELL_F1 3u
#define SCARP_CELL_F2 4u
#define SCARP_CELL_EDGE 5u
#define SCARP_CELL_SOFT 6u
#define SCARP_CELL_VALUE 7u

ScarpSample scarp_cells_at(ScarpLattice l, uint basis, ScarpLocation p, int dimensions)
{
    if (basis == SCARP_CELL_SOFT) {
        ScarpSample soft = scarp_soft_at(l, p, dimensions);
        soft.value = scarp_add(soft.value, l.middle);
        return soft;
    }
    ScarpNearest n = scarp_nearest_at(l, p, dimensions);
    if (basis == SCARP_CELL_VALUE) {
        return scarp_cell_value(n.first);
    }
    ScarpSample first = scarp_distance_to(n.first);
    ScarpSample s = scarp_distance_to(n.second);
    if (basis == SCARP_CELL_F1) {
        s = first;
    }
    if (basis == SCARP_CELL_EDGE) {
        s = scarp_difference_of(s, first);
    }
    s.value = scarp_sub(s.value, l.middle);
    return s;
}

/* One octave of noise with gradient and Hessian, in units of cells. */

/* What the formulas leave to shaders */

ScarpLattice scarp_lattice_of(ScarpOctave o, ScarpLevel l)
{
    ScarpLattice lattice = ScarpLattice(o.key, o.last, l.flows != 0u, o.turn, o.turn.x, o.turn.y,
            l.component);
    return lattice;
}

ScarpSample scarp_basis_at(ScarpOctave o, ScarpLevel l, ScarpLocation p, int dimensions)
{
    ScarpLattice lattice = scarp_lattice_of(o, l);
    ScarpSample s;
    if (l.basis == SCARP_GRADIENT) {
        s = scarp_gradient_at(lattice, l.fade, p, dimensions);
    } else if (l.basis == SCARP_VALUE) {
        s = scarp_value_at(lattice, l.fade, p, dimensions);
    } else if (l.basis == SCARP_SIMPLEX) {
        s = scarp_simplex_at(lattice, p, dimensions);
    } else {
        s = scarp_cells_at(lattice, l.basis, p, dimensions);
    }
    return s;
}

/* Arithmetic with vectors and symmetric matrices. */

float scarp_dot(vec3 a, vec3 b, int dimensions)
{
    float d = scarp_add(scarp_mul(a.x, b.x), scarp_mul(a.y, b.y));
    if (dimensions == 3) {
        d = scarp_add(d, scarp_mul(a.z, b.z));
    }
    return d;
}

/* A matrix of 3 rows. */
struct ScarpRows {
    vec3 x;
    vec3 y;
    vec3 z;
};

ScarpRows scarp_rows_of(vec3 x, vec3 y, vec3 z)
{
    ScarpRows m;
    m.x = x;
    m.y = y;
    m.z = z;
    return m;
}

ScarpRows scarp_transposed(ScarpRows m)
{
    return scarp_rows_of(scarp_vec3_of(m.x.x, m.y.x, m.z.x), scarp_vec3_of(m.x.y, m.y.y, m.z.y),
            scarp_vec3_of(m.x.z, m.y.z, m.z.z));
}

/* m v */
vec3 scarp_times(ScarpRows m, vec3 v, int dimensions)
{
    return scarp_vec3_of(scarp_dot(m.x, v, dimensions), scarp_dot(m.y, v, dimensions),
            scarp_dot(m.z, v, dimensions));
}

/* The transpose of m, times v. */
vec3 scarp_transposed_times(ScarpRows m, vec3 v, int dimensions)
{
    return scarp_times(scarp_transposed(m), v, dimensions);
}

/* The Hessian. */
ScarpRows scarp_hessian_of(ScarpSample s)
{
    return scarp_rows_of(scarp_vec3_of(s.diagonal.x, s.mixed.x, s.mixed.y), scarp_vec3_of(s.mixed.x,
            s.diagonal.y, s.mixed.z), scarp_vec3_of(s.mixed.y, s.mixed.z, s.diagonal.z));
}

/* Multiplies the outputs of each order by a factor of their own. */
ScarpSample scarp_scaled(ScarpSample n, float value, float gradient, float hessian)
{
    return scarp_sample_of(scarp_mul(value, n.value), scarp_mul3(gradient, n.gradient),
            scarp_mul3(hessian, n.diagonal), scarp_mul3(hessian, n.mixed));
}

/* Where a point lies in the frame of an octave. */

uint scarp_within_period(uint last, int cell)
{
    uint within = scarp_uint_of(cell);
    if (last != 0xffffffffu) {
        uint period = last + 1u;
        if (cell < 0) {
            within = last - (~within) % period;
        } else {
            within = within % period;
        }
    }
    return within;
}

/* A point along one axis of an octave: its cell, and where it lies inside. */
struct ScarpSplit {
    uint cell;
    float t;
};

ScarpSplit scarp_split(float p, uint last)
{
    ScarpSplit s;
    if (scarp_magnitude(p) < 2147483648.0f) {
        int whole = scarp_whole_of(p);
        int lower = scarp_pick_int(scarp_float_of_int(whole) > p, whole - 1, whole);
        s.cell = scarp_within_period(last, lower);
        s.t = scarp_sub(p, scarp_float_of_int(lower));
    } else {
        s.cell = scarp_within_period(last, scarp_int_of(SCARP_SIGN));
        s.t = scarp_sub(p, p);
    }
    return s;
}

/* Along each axis p = J x + o, where axes are turned, else p = f x + o. */
vec3 scarp_position_of(ScarpOctave o, bool turned, vec3 x, int dimensions)
{
    vec3 p = scarp_mul3(o.frequency, x);
    if (turned) {
        p = scarp_times(scarp_rows_of(o.jacobian_x, o.jacobian_y, o.jacobian_z), x, dimensions);
    }
    return scarp_add3(p, scarp_vec3_of(o.offset_x, o.offset_y, o.offset_z));
}

/* Along y, triangles of simplex noise count their rows. */
ScarpLocation scarp_location_of(ScarpOctave o, uint basis, bool turned, vec3 x, int dimensions)
{
    vec3 p = scarp_position_of(o, turned, x, dimensions);
    if (basis == SCARP_SIMPLEX && dimensions == 2) {
        p.y = scarp_mul(p.y, o.turn.z);
    }
    ScarpSplit sx = scarp_split(p.x, o.last.x);
    ScarpSplit sy = scarp_split(p.y, o.last.y);
    ScarpLocation at = ScarpLocation(uvec3(sx.cell, sy.cell, 0u), uvec3(scarp_cell_after(o.last.x,
            sx.cell), scarp_cell_after(o.last.y, sy.cell), 0u), vec3(sx.t, sy.t, 0.0f));
    if (dimensions == 3) {
        ScarpSplit sz = scarp_split(p.z, o.last.z);
        at.t.z = sz.t;
        at.cell.z = sz.cell;
        at.next.z = scarp_cell_after(o.last.z, sz.cell);
    }
    return at;
}

/* What fractals make of an octave, but for those that bend. */

ScarpRows scarp_jacobian_of(ScarpOctave o)
{
    return scarp_transposed(scarp_rows_of(o.jacobian_x, o.jacobian_y, o.jacobian_z));
}

/* The vector v, in the octave's axes, in those of the input: J^T v, or f v. */
vec3 scarp_to_input(ScarpOctave o, bool turned, vec3 v, int dimensions)
{
    vec3 r = scarp_mul3(o.frequency, v);
    if (turned) {
        r = scarp_times(scarp_jacobian_of(o), v, dimensions);
    }
    return r;
}

/* `n` with the Hessian A^T (H B); `a` and `b` are the transposes of A and B. */
ScarpSample scarp_with_hessian(ScarpSample n, ScarpRows a, ScarpRows b, ScarpRows h, int dimensions)
{
    ScarpRows hb = scarp_transposed(scarp_rows_of(scarp_times(b, h.x, dimensions), scarp_times(b,
            h.y, dimensions), scarp_times(b, h.z, dimensions)));
    ScarpSample s = n;
    s.diagonal = scarp_vec3_of(scarp_dot(a.x, hb.x, dimensions), scarp_dot(a.y, hb.y, dimensions),
            scarp_dot(a.z, hb.z, dimensions));
    s.mixed = scarp_vec3_of(scarp_dot(a.x, hb.y, dimensions), scarp_dot(a.x, hb.z, dimensions),
            scarp_dot(a.y, hb.z, dimensions));
    return s;
}

/* The octave times its amplitude, in the axes of the input. */
ScarpSample scarp_in_input(ScarpOctave o, bool turned, ScarpSample n, int dimensions)
{
    ScarpSample s = scarp_scaled(n, o.amplitude, o.slope, o.curvature);
    if (turned) {
        ScarpRows scaled_jacobian = scarp_transposed(scarp_rows_of(o.gradient_x, o.gradient_y,
                o.gradient_z));
        s.gradient = scarp_times(scaled_jacobian, n.gradient, dimensions);
        s = scarp_with_hessian(s, scaled_jacobian, scarp_jacobian_of(o), scarp_hessian_of(n),
                dimensions);
    }
    return s;
}

/* sign(n) a, and 0 where n is 0. */
float scarp_with_sign(float a, float n)
{
    return scarp_pick(n == 0.0f, 0.0f, scarp_with_bit(a, scarp_bits_of(n) >> 31u));
}

vec3 scarp_with_sign3(vec3 a, float n)
{
    return scarp_vec3_of(scarp_with_sign(a.x, n), scarp_with_sign(a.y, n), scarp_with_sign(a.z, n));
}

/* |n|: turbulence */
ScarpSample scarp_magnitude_of(ScarpSample n)
{
    return scarp_sample_of(scarp_with_sign(n.value, n.value), scarp_with_sign3(n.gradient, n.value),
            scarp_with_sign3(n.diagonal, n.value), scarp_with_sign3(n.mixed, n.value));
}

/* Ping-pong. The derivatives lack their factor 2 sharpness, which comes with the weight. */
ScarpSample scarp_pingpong(ScarpSample n, float sharpness)
{
    float t = scarp_mul(scarp_add(n.value, 1.0f), sharpness);
    float e = scarp_sub(1.0f, scarp_sub(t, scarp_mul(2.0f, scarp_floor_of(scarp_mul(t, 0.5f)))));
    float value = scarp_sub(1.0f, scarp_mul(2.0f, scarp_magnitude(e)));
    float falling = scarp_pick(scarp_is_negative(e), -1.0f, 1.0f);
    float slope = scarp_pick(scarp_magnitude(value) == 1.0f, 0.0f, falling);
    return scarp_sample_of(value, scarp_with_sign3(n.gradient, slope), scarp_with_sign3(n.diagonal,
            slope), scarp_with_sign3(n.mixed, slope));
}

/* Ridged noise: v r^2 with v = weight and r = 1 - m. */
float scarp_ridge_first(float v, float vi, float r, float mi)
{
    return scarp_sub(scarp_mul(scarp_mul(r, r), vi), scarp_mul(scarp_mul(scarp_mul(2.0f, v), r),
            mi));
}

vec3 scarp_ridge_first3(float v, vec3 vi, float r, vec3 mi)
{
    return scarp_vec3_of(scarp_ridge_first(v, vi.x, r, mi.x), scarp_ridge_first(v, vi.y, r, mi.y),
            scarp_ridge_first(v, vi.z, r, mi.z));
}

/* vi mj + vj mi, for the elements of the diagonal and the others. */
vec3 scarp_crossed_diagonal(vec3 v, vec3 m)
{
    return scarp_vec3_of(scarp_add(scarp_mul(v.x, m.x), scarp_mul(v.x, m.x)),
            scarp_add(scarp_mul(v.y, m.y), scarp_mul(v.y, m.y)), scarp_add(scarp_mul(v.z, m.z),
            scarp_mul(v.z, m.z)));
}

vec3 scarp_crossed_mixed(vec3 v, vec3 m)
{
    return scarp_vec3_of(scarp_add(scarp_mul(v.x, m.y), scarp_mul(v.y, m.x)),
            scarp_add(scarp_mul(v.x, m.z), scarp_mul(v.z, m.x)), scarp_add(scarp_mul(v.y, m.z),
            scarp_mul(v.z, m.y)));
}

/* `cross` is vi mj + vj mi, `mm` is mi mj. */
float scarp_ridge_second(float v, float r, float vij, float mij, float cross, float mm)
{
    return scarp_add(scarp_sub(scarp_mul(scarp_mul(r, r), vij), scarp_mul(scarp_mul(2.0f, r),
            cross)), scarp_sub(scarp_mul(scarp_mul(2.0f, v), mm),
            scarp_mul(scarp_mul(scarp_mul(2.0f, v), r), mij)));
}

ScarpSample scarp_ridge(ScarpSample weight, ScarpSample n)
{
    ScarpSample m = scarp_magnitude_of(n);
    vec3 a = scarp_crossed_diagonal(weight.gradient, m.gradient);
    vec3 b = scarp_crossed_mixed(weight.gradient, m.gradient);
    vec3 g = m.gradient;
    vec3 vd = weight.diagonal;
    vec3 vm = weight.mixed;
    float v = weight.value;
    float r = scarp_sub(1.0f, m.value);
    return scarp_sample_of(scarp_mul(v, scarp_mul(r, r)), scarp_ridge_first3(v, weight.gradient, r,
            g), scarp_vec3_of(scarp_ridge_second(v, r, vd.x, m.diagonal.x, a.x, scarp_mul(g.x,
            g.x)), scarp_ridge_second(v, r, vd.y, m.diagonal.y, a.y, scarp_mul(g.y, g.y)),
            scarp_ridge_second(v, r, vd.z, m.diagonal.z, a.z, scarp_mul(g.z, g.z))),
            scarp_vec3_of(scarp_ridge_second(v, r, vm.x, m.mixed.x, b.x, scarp_mul(g.x, g.y)),
            scarp_ridge_second(v, r, vm.y, m.mixed.y, b.y, scarp_mul(g.x, g.z)),
            scarp_ridge_second(v, r, vm.z, m.mixed.z, b.z, scarp_mul(g.y, g.z))));
}

/* The weight of the octave after one of ridged noise: 2 s, but 1 where that is more. */
ScarpSample scarp_ridge_weight(ScarpSample s)
{
    ScarpSample weight = scarp_constant(1.0f);
    if (scarp_mul(2.0f, s.value) < 1.0f) {
        weight = scarp_scaled(s, 2.0f, 2.0f, 2.0f);
    }
    return weight;
}

/* Hybrid noise: v r with v = weight and r = n + sharpness. */
ScarpSample scarp_hybrid(ScarpSample weight, ScarpSample n, float sharpness)
{
    float v = weight.value;
    float r = scarp_add(n.value, sharpness);
    vec3 diagonal = scarp_add3(scarp_mul3(r, weight.diagonal), scarp_mul3(v, n.diagonal));
    vec3 mixed = scarp_add3(scarp_mul3(r, weight.mixed), scarp_mul3(v, n.mixed));
    return scarp_sample_of(scarp_mul(v, r), scarp_add3(scarp_mul3(r, weight.gradient), scarp_mul3(v,
            n.gradient)), scarp_add3(diagonal, scarp_crossed_diagonal(weight.gradient, n.gradient)),
            scarp_add3(mixed, scarp_crossed_mixed(weight.gradient, n.gradient)));
}

/* The weight of the octave after one of hybrid noise: share u, but 1 or -1 where that is beyond. */
ScarpSample scarp_hybrid_weight(ScarpSample u, float share)
{
    float t = scarp_mul(share, u.value);
    ScarpSample weight = scarp_constant(scarp_pick(t < 0.0f, -1.0f, 1.0f));
    if (scarp_magnitude(t) < 1.0f) {
        weight = scarp_scaled(u, share, share, share);
    }
    return weight;
}

/* What slopes add up to, with the rows of the Jacobian. */
struct ScarpSlopes {
    vec3 d;
    ScarpRows jacobian;
};

ScarpRows scarp_sum_of_rows(ScarpRows a, ScarpRows b)
{
    return scarp_rows_of(scarp_add3(a.x, b.x), scarp_add3(a.y, b.y), scarp_add3(a.z, b.z));
}

/* The slopes, to which those of an octave n, in its own axes, are added. */
ScarpSlopes scarp_steeper(ScarpSlopes slopes, ScarpOctave o, bool turned, ScarpSample n,
        int dimensions)
{
    ScarpRows h = scarp_hessian_of(n);
    ScarpSlopes s;
    s.d = scarp_add3(slopes.d, n.gradient);
    s.jacobian = scarp_sum_of_rows(slopes.jacobian, scarp_rows_of(scarp_to_input(o, turned, h.x,
            dimensions), scarp_to_input(o, turned, h.y, dimensions), scarp_to_input(o, turned, h.z,
            dimensions)));
    return s;
}

/* An octave n of erosion; `slopes` have it, and `gradient` is its own in the axes of the input. */
ScarpSample scarp_eroded(ScarpSlopes slopes, float erosion, float n, vec3 gradient, int dimensions)
{
    float q = scarp_inverse(scarp_add(1.0f, scarp_mul(erosion, scarp_dot(slopes.d, slopes.d,
            dimensions))));
    float damping = scarp_mul(scarp_mul(scarp_mul(2.0f, erosion), n), scarp_mul(q, q));
    vec3 steepening = scarp_transposed_times(slopes.jacobian, slopes.d, dimensions);
    ScarpSample s = scarp_constant(scarp_mul(q, n));
    s.gradient = scarp_sub3(scarp_mul3(q, gradient), scarp_mul3(damping, steepening));
    return s;
}

/* The fractals that bend. */

/* What goes from octave to octave. `weight`: ridged and hybrid noise; `slopes`: erosion and those
   that bend; `left`: how much of the octaves Swiss noise leaves, with its gradient. */
struct ScarpState {
    ScarpSample sum;
    ScarpSample weight;
    ScarpSlopes slopes;
    float left;
    vec3 left_by;
};

/* A gradient by bent positions becomes one by x: A^T g with A = I + reach (Jacobian of the slopes).
 */
vec3 scarp_unbent(ScarpSlopes slopes, float reach, vec3 g, int dimensions)
{
    return scarp_add3(g, scarp_mul3(reach, scarp_transposed_times(slopes.jacobian, g, dimensions)));
}

/* A row of the Jacobian with what a component of the slope adds; `row` is that of the Hessian. */
vec3 scarp_bent_row(vec3 jacobian, vec3 by, float slope, float product, vec3 row)
{
    return scarp_add3(jacobian, scarp_add3(scarp_mul3(slope, by), scarp_mul3(product, row)));
}

/* The slopes with factor n times the slope g / f of an octave; `by` is the gradient of factor n. */
ScarpSlopes scarp_with_slope(ScarpSlopes slopes, ScarpOctave o, ScarpSample n, float product,
        vec3 by, int dimensions)
{
    ScarpRows h = scarp_hessian_of(n);
    vec3 slope = scarp_mul3(o.inverse, n.gradient);
    vec3 x = scarp_mul3(o.inverse, scarp_unbent(slopes, o.reach, h.x, dimensions));
    vec3 y = scarp_mul3(o.inverse, scarp_unbent(slopes, o.reach, h.y, dimensions));
    vec3 z = scarp_mul3(o.inverse, scarp_unbent(slopes, o.reach, h.z, dimensions));
    ScarpSlopes s;
    s.d = scarp_add3(slopes.d, scarp_mul3(product, slope));
    s.jacobian = scarp_rows_of(scarp_bent_row(slopes.jacobian.x, by, slope.x, product, x),
            scarp_bent_row(slopes.jacobian.y, by, slope.y, product, y),
            scarp_bent_row(slopes.jacobian.z, by, slope.z, product, z));
    return s;
}

ScarpState scarp_swiss(ScarpState state, ScarpOctave o, float inverse_weight, ScarpSample n,
        int dimensions)
{
    float share = scarp_mul(o.weight, inverse_weight);
    float u = state.left;
    float rest = scarp_sub(1.0f, scarp_magnitude(n.value));
    float v = scarp_pick(rest < 0.0f, 0.0f, rest);
    vec3 nj = scarp_unbent(state.slopes, o.reach, n.gradient, dimensions);
    vec3 none = scarp_vec3_of(0.0f, 0.0f, 0.0f);
    vec3 vj = scarp_with_sign3(nj, n.value);
    if (rest < 0.0f) {
        vj = none;
    }
    ScarpState s = state;
    vec3 term = scarp_mul3(o.weight, scarp_sub3(scarp_mul3(v, state.left_by), scarp_mul3(u, vj)));
    s.sum.gradient = scarp_add3(state.sum.gradient, term);
    s.sum.value = scarp_add(state.sum.value, scarp_mul(o.weight, scarp_mul(u, v)));
    vec3 by = scarp_mul3(-share, scarp_add3(scarp_mul3(n.value, state.left_by), scarp_mul3(u, nj)));
    s.slopes = scarp_with_slope(state.slopes, o, n, scarp_mul(-share, scarp_mul(u, n.value)), by,
            dimensions);
    float sum = scarp_mul(s.sum.value, inverse_weight);
    if (sum < 1.0f) {
        s.left_by = scarp_add3(scarp_mul3(sum, state.left_by), scarp_mul3(u,
                scarp_mul3(inverse_weight, s.sum.gradient)));
        s.left = scarp_mul(u, sum);
    }
    return s;
}

ScarpState scarp_jordan(ScarpState state, ScarpOctave o, float erosion, bool first, ScarpSample n,
        int dimensions)
{
    float square = scarp_mul(n.value, n.value);
    float p = scarp_inverse(scarp_add(1.0f, scarp_dot(state.slopes.d, state.slopes.d, dimensions)));
    float q = scarp_pick(first, 1.0f, scarp_sub(1.0f, scarp_mul(erosion, p)));
    float damping = scarp_pick(first, 0.0f, scarp_mul(scarp_mul(scarp_mul(2.0f, erosion),
            scarp_mul(p, p)), square));
    vec3 by = scarp_unbent(state.slopes, o.reach, n.gradient, dimensions);
    vec3 steepening = scarp_transposed_times(state.slopes.jacobian, state.slopes.d, dimensions);
    vec3 term = scarp_add3(scarp_mul3(damping, steepening), scarp_mul3(scarp_mul(2.0f, q),
            scarp_mul3(n.value, by)));
    ScarpState s = state;
    s.sum.gradient = scarp_add3(state.sum.gradient, scarp_mul3(o.weight, term));
    s.sum.value = scarp_add(state.sum.value, scarp_mul(o.weight, scarp_mul(q, square)));
    s.slopes = scarp_with_slope(state.slopes, o, n, n.value, by, dimensions);
    return s;
}

/* The sum of the octaves at one point. */

ScarpOctave scarp_octave_of(uint plan, uint k)
{
    return scarp_plan[plan].octave[k];
}

ScarpLevel scarp_level_of(uint plan, int i)
{
    ScarpLevel l = scarp_plan[plan].level[i];
    l.basis = scarp_only_basis(l.basis);
    l.fractal = scarp_only_fractal(l.fractal);
    return l;
}

bool scarp_bends(ScarpLevel l)
{
    return l.fractal == SCARP_SWISS || l.fractal == SCARP_JORDAN;
}

/* The octave n, in the axes of the input, as the fractal adds it to the sum; n is not bent. */
ScarpState scarp_shaped(ScarpState state, ScarpOctave o, ScarpLevel l, ScarpSample n)
{
    ScarpState s = state;
    ScarpSample term = n;
    float slope = o.weight;
    if (l.fractal == SCARP_TURBULENCE) {
        term = scarp_magnitude_of(n);
    }
    if (l.fractal == SCARP_RIDGED) {
        term = scarp_ridge(state.weight, n);
        s.weight = scarp_ridge_weight(term);
    }
    if (l.fractal == SCARP_PINGPONG) {
        term = scarp_pingpong(n, l.sharpness);
        slope = scarp_mul(o.weight, scarp_mul(2.0f, l.sharpness));
    }
    if (l.fractal == SCARP_HYBRID) {
        term = scarp_hybrid(state.weight, n, l.sharpness);
        s.weight = scarp_hybrid_weight(term, o.share);
    }
    if (l.fractal != SCARP_FBM) {
        term = scarp_scaled(term, o.weight, slope, slope);
    }
    s.sum = scarp_sum_of(state.sum, term);
    return s;
}

/* Adds an octave of erosion; n is the basis in the axes of the octave. */
ScarpState scarp_erosion(ScarpState state, ScarpOctave o, float strength, ScarpSample n,
        bool turned, int dimensions)
{
    ScarpSample basis = scarp_scaled(n, o.amplitude, o.amplitude, o.amplitude);
    vec3 gradient = scarp_to_input(o, turned, basis.gradient, dimensions);
    ScarpState s = state;
    s.slopes = scarp_steeper(state.slopes, o, turned, basis, dimensions);
    ScarpSample term = scarp_eroded(s.slopes, strength, basis.value, gradient, dimensions);
    s.sum = scarp_sum_of(state.sum, scarp_scaled(term, o.weight, o.weight, o.weight));
    return s;
}

/* Adds octave k of level l at x. */
ScarpState scarp_with_octave(ScarpState state, ScarpOctave o, ScarpLevel l, uint k, vec3 x,
        int dimensions)
{
    bool turned = l.rotate != 0u && k > 0u;
    vec3 y = x;
    if (scarp_bends(l) && k > 0u) {
        y = scarp_add3(x, scarp_mul3(o.reach, state.slopes.d));
    }
    ScarpLocation p = scarp_location_of(o, l.basis, turned, y, dimensions);
    ScarpSample basis = scarp_basis_at(o, l, p, dimensions);
    ScarpState s;
    if (l.fractal == SCARP_EROSION) {
        s = scarp_erosion(state, o, l.erosion, basis, turned, dimensions);
    } else {
        ScarpSample n = scarp_in_input(o, turned, basis, dimensions);
        if (l.fractal == SCARP_SWISS) {
            s = scarp_swiss(state, o, l.inverse_weight, n, dimensions);
        } else if (l.fractal == SCARP_JORDAN) {
            s = scarp_jordan(state, o, l.erosion, k == 0u, n, dimensions);
        } else {
            s = scarp_shaped(state, o, l, n);
        }
    }
    return s;
}

/* The noise of a component of a level, without warps; component 0 of a level that has one. */
ScarpSample scarp_octaves_at(uint plan, ScarpLevel given, uint component, vec3 x, int dimensions)
{
    vec3 none = scarp_vec3_of(0.0f, 0.0f, 0.0f);
    bool shares_lattice = given.basis == SCARP_GRADIENT || given.basis == SCARP_VALUE;
    ScarpLevel l = given;
    ScarpState state;
    if (shares_lattice) {
        l.component = component;
    } else {
        l.first = given.first + component * given.octaves;
    }
    state.sum = scarp_constant(0.0f);
    state.weight = scarp_constant(1.0f);
    state.slopes.d = none;
    state.slopes.jacobian = scarp_rows_of(none, none, none);
    state.left = 1.0f;
    state.left_by = none;
    for (uint k = 0u; k < l.octaves; k++) {
        state = scarp_with_octave(state, scarp_octave_of(plan, l.first + k), l, k, x, dimensions);
    }
    return state.sum;
}

/* Noise with warps, as scalar/warp. */

/* The coordinates of displaced positions, with their derivatives: how far they are displaced. */
struct ScarpDisplaced {
    ScarpSample x;
    ScarpSample y;
    ScarpSample z;
};

/* A sample at y with its derivatives by y becomes one with its derivatives by x: with the Jacobian
   J of y, the gradient is J^T g, the Hessian J^T (H J) + sum_m g_m (Hessian of y_m). */
ScarpSample scarp_composed(ScarpSample s, ScarpDisplaced y, int dimensions)
{
    ScarpRows j = scarp_transposed(scarp_rows_of(y.x.gradient, y.y.gradient, y.z.gradient));
    vec3 diagonal = scarp_transposed_times(scarp_rows_of(y.x.diagonal, y.y.diagonal, y.z.diagonal),
            s.gradient, dimensions);
    vec3 mixed = scarp_transposed_times(scarp_rows_of(y.x.mixed, y.y.mixed, y.z.mixed), s.gradient,
            dimensions);
    ScarpSample r = scarp_with_hessian(s, j, j, scarp_hessian_of(s), dimensions);
    r.gradient = scarp_times(j, s.gradient, dimensions);
    r.diagonal = scarp_add3(r.diagonal, diagonal);
    r.mixed = scarp_add3(r.mixed, mixed);
    return r;
}

/* The components of a level, each at `at`, by x; `y` says how that depends on x, unless the level
   is the deepest. */
ScarpDisplaced scarp_level_at(uint plan, int i, bool deepest, vec3 at, ScarpDisplaced y,
        int dimensions)
{
    ScarpLevel l = scarp_level_of(plan, i);
    int components = scarp_pick_int(i > 0, dimensions, 1);
    ScarpDisplaced d = y;
    for (int c = 0; c < components; c++) {
        ScarpSample s = scarp_octaves_at(plan, l, scarp_uint_of(c), at, dimensions);
        if (!deepest) {
            s = scarp_composed(s, y, dimensions);
        }
        if (c == 0) {
            d.x = s;
        } else if (c == 1) {
            d.y = s;
        } else {
            d.z = s;
        }
    }
    return d;
}

ScarpSample scarp_noise_at(uint plan, vec3 x, int dimensions)
{
    int depth = scarp_int_of(scarp_only_depth(scarp_plan[plan].depth));
    vec3 at = x;
    ScarpDisplaced y;
    y.x = scarp_constant(0.0f);
    y.y = y.x;
    y.z = y.x;
    for (int i = depth; i >= 0; i--) {
        y = scarp_level_at(plan, i, i == depth, at, y, dimensions);
        if (i > 0) {
            y.x.gradient.x = scarp_add(y.x.gradient.x, 1.0f);
            y.y.gradient.y = scarp_add(y.y.gradient.y, 1.0f);
            y.z.gradient.z = scarp_add(y.z.gradient.z, 1.0f);
            at = scarp_add3(x, scarp_vec3_of(y.x.value, y.y.value, y.z.value));
        }
    }
    return y.x;
}

/* What scarp_sample2 gives at (x, y); outputs along z mean nothing. */
ScarpSample scarp_sample2(uint plan, float x, float y)
{
    return scarp_noise_at(plan, scarp_vec3_of(x, y, 0.0f), 2);
}

/* What scarp_sample3 gives at (x, y, z). */
ScarpSample scarp_sample3(uint plan, float x, float y, float z)
{
    return scarp_noise_at(plan, scarp_vec3_of(x, y, z), 3);
}

/* A coordinate of test point i. */
float scarp_test_coordinate(uint plan, uint i, uint axis)
{
    uvec3 key;
    key.x = 0u;
    key.y = 0u;
    key.z = 0u;
    int cells = scarp_int_of(scarp_hash2(key, i, axis) >> 12u) - 524288;
    return scarp_mul(scarp_float_of_int(cells), scarp_plan[plan].unit);
}

/* The hash h with an output; what is below 2^-120 counts as 0. */
uint scarp_hash_with(uint h, float a)
{
    uint magnitude_bits = scarp_bits_of(a) & 0x7fffffffu;
    uint bits = scarp_pick_uint(magnitude_bits < 0x03800000u, 0u, scarp_bits_of(a));
    return (((h << 5u) | (h >> 27u)) ^ bits) * SCARP_HASH_K;
}

/* The self-test: a hash of the outputs at test point i up to an order, which is answer i of
   scarp_gpu_answers where the shader has the bits of the library. */
uint scarp_answer2(uint plan, uint order, uint i)
{
    ScarpSample s = scarp_sample2(plan, scarp_test_coordinate(plan, i, 0u),
            scarp_test_coordinate(plan, i, 1u));
    uint h = scarp_hash_with(0u, s.value);
    if (order > 0u) {
        h = scarp_hash_with(scarp_hash_with(h, s.gradient.x), s.gradient.y);
    }
    if (order > 1u) {
        h = scarp_hash_with(scarp_hash_with(scarp_hash_with(h, s.diagonal.x), s.mixed.x),
                s.diagonal.y);
    }
    return h;
}

uint scarp_answer3(uint plan, uint order, uint i)
{
    ScarpSample s = scarp_sample3(plan, scarp_test_coordinate(plan, i, 0u),
            scarp_test_coordinate(plan, i, 1u), scarp_test_coordinate(plan, i, 2u));
    uint h = scarp_hash_with(0u, s.value);
    if (order > 0u) {
        h = scarp_hash_with(scarp_hash_with(scarp_hash_with(h, s.gradient.x), s.gradient.y),
                s.gradient.z);
    }
    if (order > 1u) {
        h = scarp_hash_with(scarp_hash_with(scarp_hash_with(h, s.diagonal.x), s.mixed.x),
                s.mixed.y);
        h = scarp_hash_with(scarp_hash_with(scarp_hash_with(h, s.diagonal.y), s.mixed.z),
                s.diagonal.z);
    }
    return h;
}
#endif
