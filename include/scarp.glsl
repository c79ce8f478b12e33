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
// There are scarp_sample3, scarp_cells2 and 3 (of a cellular basis), scarp_curl2, and the chain rule,
// scarp_chain_multiply and the like; scarp_vector2 and 3 and scarp_curl3 read plans of
// scarp_gpu_vector_plan_make.
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

/* The constants of octaves, and of what they are octaves of. */

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

/* The constants of a noise, as scarp_gpu_plan_make gives them. */

struct ScarpPlan {
    uint depth;
    uint dimensions;
    uint zero;
    float unit;
    ScarpLevel level[5];
    ScarpOctave octave[32];
};

/* Numbers of bases, fades and fractals. */

#define SCARP_GRADIENT 0u
#define SCARP_VALUE 1u
#define SCARP_SIMPLEX 2u
#define SCARP_CELL_F1 3u
#define SCARP_CELL_F2 4u
#define SCARP_CELL_EDGE 5u
#define SCARP_CELL_SOFT 6u
#define SCARP_CELL_VALUE 7u

#define SCARP_QUINTIC 0u
#define SCARP_CUBIC 1u

#define SCARP_FBM 0u
#define SCARP_TURBULENCE 1u
#define SCARP_RIDGED 2u
#define SCARP_EROSION 3u
#define SCARP_PINGPONG 4u
#define SCARP_HYBRID 5u
#define SCARP_SWISS 6u
#define SCARP_JORDAN 7u
#if defined(VULKAN)
#define SCARP_LAYOUT layout(std140, set = SCARP_SET, binding = SCARP_BINDING)
#elif defined(GL_ES)
#define SCARP_LAYOUT layout(std140)
#else
#define SCARP_LAYOUT layout(std140, binding = SCARP_BINDING)
#endif

SCARP_LAYOUT uniform ScarpPlans
{
    ScarpPlan scarp_plan[SCARP_PLANS];
};

// 0, which compilers do not know
uint scarp_zero()
{
    return scarp_plan[0].zero;
}

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
#define SCARP_KEPT(a) uintBitsToFloat(floatBitsToUint(a) ^ scarp_zero())
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

/* Signs of floats. */

#define SCARP_SIGN 0x80000000u

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

/* sign(n) a, and 0 where n is 0. */
float scarp_with_sign(float a, float n)
{
    return scarp_pick(n == 0.0f, 0.0f, scarp_with_bit(a, scarp_bits_of(n) >> 31u));
}

/* The operations that shading languages only approximate, and others of numbers. */

float scarp_magnitude(float a)
{
    return scarp_float_of_bits(scarp_bits_of(a) & 0x7fffffffu);
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

/*
 * a / b, rounded to nearest, of b that is neither 0 nor below 2^-126; 0 where that is below 2^-126.
 * With mantissas m of a and n of b, the quotient's is q: 2^23 m / n, or 2^24 m / n where m is less
 * than n, rounded.
 */
float scarp_quotient(float a, float b)
{
    uint m = (scarp_bits_of(a) & 0x7fffffu) | 0x800000u;
    uint n = (scarp_bits_of(b) & 0x7fffffu) | 0x800000u;
    uint less = scarp_pick_uint(m < n, 1u, 0u);
    int of_a = scarp_int_of((scarp_bits_of(a) >> 23u) & 255u);
    int of_b = scarp_int_of((scarp_bits_of(b) >> 23u) & 255u);
    int e = of_a - of_b + 126 - scarp_int_of(less);
    float left = scarp_float_of_bits(0x3f800000u | (m & 0x7fffffu));
    float estimate = scarp_mul(left, scarp_rough_inverse(scarp_float_of_bits(0x3f800000u | (n
            & 0x7fffffu))));
    uint q = scarp_uint_of(scarp_whole_of(scarp_mul(estimate, scarp_either(m < n, 16777216.0f,
            8388608.0f))));
    int r = scarp_int_of((m << (23u + less)) - q * n);
    for (int i = 0; i < 16 && (r < 0 || r >= scarp_int_of(n)); i++) {
        q = scarp_pick_uint(r < 0, q - 1u, q + 1u);
        r = scarp_int_of((m << (23u + less)) - q * n);
    }
    q = scarp_pick_uint(2 * r > scarp_int_of(n), q + 1u, q);
    uint size = (scarp_uint_of(e) << 23u) + q;
    uint sign = (scarp_bits_of(a) ^ scarp_bits_of(b)) & SCARP_SIGN;
    return scarp_pick(of_a == 0 || e < 0, 0.0f, scarp_float_of_bits(size | sign));
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

/* v_i m_j + v_j m_i: the elements of a diagonal, and the others. */
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

/* J x where axes are turned, else f x: how many cells of the octave x is along each axis. */
vec3 scarp_cells_along(ScarpOctave o, bool turned, vec3 x, int dimensions)
{
    vec3 p = scarp_mul3(o.frequency, x);
    if (turned) {
        p = scarp_times(scarp_rows_of(o.jacobian_x, o.jacobian_y, o.jacobian_z), x, dimensions);
    }
    return p;
}

/* Along y, triangles of simplex noise count their rows. */
vec3 scarp_stretched(ScarpOctave o, uint basis, vec3 cells, int dimensions)
{
    vec3 p = cells;
    if (basis == SCARP_SIMPLEX && dimensions == 2) {
        p.y = scarp_mul(p.y, o.turn.z);
    }
    return p;
}

/* Where a point lies by its splits along the axes. In 2D all of z is 0. */
ScarpLocation scarp_location_in(uvec3 last, ScarpSplit x, ScarpSplit y, ScarpSplit z,
        int dimensions)
{
    ScarpLocation at = ScarpLocation(uvec3(x.cell, y.cell, 0u), uvec3(scarp_cell_after(last.x,
            x.cell), scarp_cell_after(last.y, y.cell), 0u), vec3(x.t, y.t, 0.0f));
    if (dimensions == 3) {
        at.t.z = z.t;
        at.cell.z = z.cell;
        at.next.z = scarp_cell_after(last.z, z.cell);
    }
    return at;
}

/* Along each axis p = J x + o, where axes are turned, else p = f x + o. */
ScarpLocation scarp_location_of(ScarpOctave o, uint basis, bool turned, vec3 x, int dimensions)
{
    vec3 offset = scarp_vec3_of(o.offset_x, o.offset_y, o.offset_z);
    vec3 cells = scarp_add3(scarp_cells_along(o, turned, x, dimensions), offset);
    vec3 p = scarp_stretched(o, basis, cells, dimensions);
    ScarpSplit z = ScarpSplit(0u, 0.0f);
    if (dimensions == 3) {
        z = scarp_split(p.z, o.last.z);
    }
    return scarp_location_in(o.last, scarp_split(p.x, o.last.x), scarp_split(p.y, o.last.y), z,
            dimensions);
}

/* What fractals make of an octave n, but for those that bend. */

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

/* The octave times its amplitude a, in the axes of the input: the gradient is (a J)^T g, the
   Hessian (a J)^T (H J). Where axes are not turned J is f, so the factors are a f and a f^2. */
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

vec3 scarp_with_sign3(vec3 a, float n)
{
    return scarp_vec3_of(scarp_with_sign(a.x, n), scarp_with_sign(a.y, n), scarp_with_sign(a.z, n));
}

/* Turbulence */
ScarpSample scarp_magnitude_of(ScarpSample n)
{
    return scarp_sample_of(scarp_with_sign(n.value, n.value), scarp_with_sign3(n.gradient, n.value),
            scarp_with_sign3(n.diagonal, n.value), scarp_with_sign3(n.mixed, n.value));
}

/* Ping-pong: 1 - 2 |e|, where e = 1 - (t mod 2) rises where t falls. The derivatives lack their
   factor 2 sharpness, which comes with the weight, and are 0 on creases, where the value is 1 or
   -1. */
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

/* Ridged noise: v r^2 with v = weight and r = 1 - m, m being |n|. Its derivatives are
       r^2 v_i - 2 v r m_i
       r^2 v_ij - 2 r (v_i m_j + v_j m_i) + 2 v m_i m_j - 2 v r m_ij */
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

/* Hybrid noise: v r with v = weight and r = n + sharpness. Its derivatives are
       r v_i + v n_i
       r v_ij + v n_ij + v_i n_j + v_j n_i */
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

/* The fractals that bend, Swiss and Jordan noise. */

/* What goes from octave to octave. `weight`: ridged and hybrid noise; `slopes`: erosion and those
   that bend; `left`: how much of the octaves Swiss noise leaves, with its gradient. */
struct ScarpState {
    ScarpSample sum;
    ScarpSample weight;
    ScarpSlopes slopes;
    float left;
    vec3 left_by;
};

/* A gradient with respect to bent positions becomes one with respect to x: A^T g with A = I + reach
   (Jacobian of the slopes). */
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

/* Swiss noise adds a u v with v = max(0, 1 - |n|), n being bent; S loses (a / a_0) u n g / f, and u
   is multiplied by the sum over a_0, at most by 1. */
ScarpState scarp_swiss(ScarpState state, ScarpOctave o, float inverse_weight, ScarpSample n,
        int dimensions)
{
    float share = scarp_mul(o.weight, inverse_weight);
    float u = state.left;
    float rest = scarp_sub(1.0f, scarp_magnitude(n.value));
    float v = scarp_pick(rest < 0.0f, 0.0f, rest); /* NaN stays */
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

/* Jordan noise adds a q n^2 with q = 1 - erosion / (1 + S.S), but 1 in octave 0; S gains n g / f.
 */
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

/* The sum of octaves. */

/* What octave 0 adds to. */
ScarpState scarp_no_octaves()
{
    vec3 none = scarp_vec3_of(0.0f, 0.0f, 0.0f);
    ScarpState state;
    state.sum = scarp_constant(0.0f);
    state.weight = scarp_constant(1.0f);
    state.slopes.d = none;
    state.slopes.jacobian = scarp_rows_of(none, none, none);
    state.left = 1.0f;
    state.left_by = none;
    return state;
}

/* Where octave k looks, which those before have bent if it is one of a fractal that bends. */
vec3 scarp_bent(ScarpState state, ScarpOctave o, uint k, vec3 x)
{
    vec3 y = x;
    if (k > 0u) {
        y = scarp_add3(x, scarp_mul3(o.reach, state.slopes.d));
    }
    return y;
}

/* Each fractal adds the octave n, in the axes of the input, to the sum; n is not bent. */
ScarpState scarp_with_fbm(ScarpState state, ScarpSample n)
{
    ScarpState s = state;
    s.sum = scarp_sum_of(state.sum, n);
    return s;
}

ScarpState scarp_with_turbulence(ScarpState state, ScarpOctave o, ScarpSample n)
{
    return scarp_with_fbm(state, scarp_scaled(scarp_magnitude_of(n), o.weight, o.weight, o.weight));
}

ScarpState scarp_with_ridged(ScarpState state, ScarpOctave o, ScarpSample n)
{
    ScarpSample term = scarp_ridge(state.weight, n);
    ScarpState s = scarp_with_fbm(state, scarp_scaled(term, o.weight, o.weight, o.weight));
    s.weight = scarp_ridge_weight(term);
    return s;
}

ScarpState scarp_with_pingpong(ScarpState state, ScarpOctave o, ScarpLevel l, ScarpSample n)
{
    float slope = scarp_mul(o.weight, scarp_mul(2.0f, l.sharpness));
    return scarp_with_fbm(state, scarp_scaled(scarp_pingpong(n, l.sharpness), o.weight, slope,
            slope));
}

ScarpState scarp_with_hybrid(ScarpState state, ScarpOctave o, ScarpLevel l, ScarpSample n)
{
    ScarpSample term = scarp_hybrid(state.weight, n, l.sharpness);
    ScarpState s = scarp_with_fbm(state, scarp_scaled(term, o.weight, o.weight, o.weight));
    s.weight = scarp_hybrid_weight(term, o.share);
    return s;
}

/* Adds an octave of erosion; n is the basis in the axes of the octave. */
ScarpState scarp_with_erosion(ScarpState state, ScarpOctave o, ScarpLevel l, ScarpSample n,
        bool turned, int dimensions)
{
    ScarpSample basis = scarp_scaled(n, o.amplitude, o.amplitude, o.amplitude);
    vec3 gradient = scarp_to_input(o, turned, basis.gradient, dimensions);
    ScarpState s = state;
    s.slopes = scarp_steeper(state.slopes, o, turned, basis, dimensions);
    ScarpSample term = scarp_eroded(s.slopes, l.erosion, basis.value, gradient, dimensions);
    s.sum = scarp_sum_of(state.sum, scarp_scaled(term, o.weight, o.weight, o.weight));
    return s;
}

/* Adds an octave n, in the axes of the input, of any fractal but erosion. */
ScarpState scarp_with_noise(ScarpState state, ScarpOctave o, ScarpLevel l, bool first,
        ScarpSample n, int dimensions)
{
    ScarpState s;
    if (l.fractal == SCARP_SWISS) {
        s = scarp_swiss(state, o, l.inverse_weight, n, dimensions);
    } else if (l.fractal == SCARP_JORDAN) {
        s = scarp_jordan(state, o, l.erosion, first, n, dimensions);
    } else if (l.fractal == SCARP_TURBULENCE) {
        s = scarp_with_turbulence(state, o, n);
    } else if (l.fractal == SCARP_RIDGED) {
        s = scarp_with_ridged(state, o, n);
    } else if (l.fractal == SCARP_PINGPONG) {
        s = scarp_with_pingpong(state, o, l, n);
    } else if (l.fractal == SCARP_HYBRID) {
        s = scarp_with_hybrid(state, o, l, n);
    } else {
        s = scarp_with_fbm(state, n);
    }
    return s;
}

/* Adds an octave of the basis, in its own axes. */
ScarpState scarp_with_basis(ScarpState state, ScarpOctave o, ScarpLevel l, bool first, bool turned,
        ScarpSample basis, int dimensions)
{
    ScarpState s;
    if (l.fractal == SCARP_EROSION) {
        s = scarp_with_erosion(state, o, l, basis, turned, dimensions);
    } else {
        s = scarp_with_noise(state, o, l, first, scarp_in_input(o, turned, basis, dimensions),
                dimensions);
    }
    return s;
}

/* Noise at displaced positions. */

/* The coordinates of displaced positions, with their derivatives: how far they are displaced. */
struct ScarpDisplaced {
    ScarpSample x;
    ScarpSample y;
    ScarpSample z;
};

/* A sample with its derivatives with respect to y becomes one with those with respect to x: with
   the Jacobian J of y, the gradient is J^T g, the Hessian J^T (H J) + sum_m g_m (Hessian of y_m).
 */
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

/* What nothing has displaced. */
ScarpDisplaced scarp_not_displaced()
{
    ScarpDisplaced y;
    y.x = scarp_constant(0.0f);
    y.y = y.x;
    y.z = y.x;
    return y;
}

/* Displacements of x become positions: their derivatives are those of x, too. */
ScarpDisplaced scarp_positions_of(ScarpDisplaced d)
{
    ScarpDisplaced y = d;
    y.x.gradient.x = scarp_add(y.x.gradient.x, 1.0f);
    y.y.gradient.y = scarp_add(y.y.gradient.y, 1.0f);
    y.z.gradient.z = scarp_add(y.z.gradient.z, 1.0f);
    return y;
}

vec3 scarp_values_of(ScarpDisplaced y)
{
    return scarp_vec3_of(y.x.value, y.y.value, y.z.value);
}

ScarpDisplaced scarp_displaced_of(ScarpSample x, ScarpSample y, ScarpSample z)
{
    ScarpDisplaced d;
    d.x = x;
    d.y = y;
    d.z = z;
    return d;
}

/* Velocities without divergence. */

/* A velocity without divergence, and the rows of its Jacobian: the derivatives of each component.
 */
struct ScarpFlow {
    vec3 velocity;
    vec3 x;
    vec3 y;
    vec3 z;
};

/* Of a potential in the plane, v = (psi_y, -psi_x); nothing along z. */
ScarpFlow scarp_curl_in_plane(ScarpSample psi)
{
    ScarpFlow f;
    f.velocity = scarp_vec3_of(psi.gradient.y, -psi.gradient.x, 0.0f);
    f.x = scarp_vec3_of(psi.mixed.x, psi.diagonal.y, 0.0f);
    f.y = scarp_vec3_of(-psi.diagonal.x, -psi.mixed.x, 0.0f);
    f.z = scarp_vec3_of(0.0f, 0.0f, 0.0f);
    return f;
}

/* Of three potentials, with i, j, k = x, y, z in turn, v_i = d_j psi_k - d_k psi_j. */
ScarpFlow scarp_curl_in_space(ScarpDisplaced psi)
{
    ScarpRows a = scarp_hessian_of(psi.x);
    ScarpRows b = scarp_hessian_of(psi.y);
    ScarpRows c = scarp_hessian_of(psi.z);
    ScarpFlow f;
    f.velocity = scarp_vec3_of(scarp_sub(psi.z.gradient.y, psi.y.gradient.z),
            scarp_sub(psi.x.gradient.z, psi.z.gradient.x), scarp_sub(psi.y.gradient.x,
            psi.x.gradient.y));
    f.x = scarp_sub3(c.y, b.z);
    f.y = scarp_sub3(a.z, c.x);
    f.z = scarp_sub3(b.x, a.y);
    return f;
}

/* The self-test of shaders. */

/* A coordinate of test point i, in steps of a unit. Every operation is exact. */
float scarp_test_coordinate(float unit, uint i, uint axis)
{
    uvec3 key = uvec3(0u, 0u, 0u);
    int cells = scarp_int_of(scarp_hash2(key, i, axis) >> 12u) - 524288;
    return scarp_mul(scarp_float_of_int(cells), unit);
}

/* The hash h with an output; what is below 2^-120 counts as 0. */
uint scarp_hash_with(uint h, float a)
{
    uint magnitude_bits = scarp_bits_of(a) & 0x7fffffffu;
    uint bits = scarp_pick_uint(magnitude_bits < 0x03800000u, 0u, scarp_bits_of(a));
    return (((h << 5u) | (h >> 27u)) ^ bits) * SCARP_HASH_K;
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

/* Adds octave k of level l at x. */
ScarpState scarp_with_octave(ScarpState state, ScarpOctave o, ScarpLevel l, uint k, vec3 x,
        int dimensions)
{
    bool turned = l.rotate != 0u && k > 0u;
    vec3 y = x;
    if (l.fractal == SCARP_SWISS || l.fractal == SCARP_JORDAN) {
        y = scarp_bent(state, o, k, x);
    }
    ScarpLocation p = scarp_location_of(o, l.basis, turned, y, dimensions);
    ScarpSample basis = scarp_basis_at(o, l, p, dimensions);
    return scarp_with_basis(state, o, l, k == 0u, turned, basis, dimensions);
}

/* The noise of a component of a level, without warps; component 0 of a level that has one. */
ScarpSample scarp_octaves_at(uint plan, ScarpLevel given, uint component, vec3 x, int dimensions)
{
    bool shares_lattice = given.basis == SCARP_GRADIENT || given.basis == SCARP_VALUE;
    ScarpLevel l = given;
    ScarpState state = scarp_no_octaves();
    if (shares_lattice) {
        l.component = component;
    } else {
        l.first = given.first + component * given.octaves;
    }
    for (uint k = 0u; k < l.octaves; k++) {
        state = scarp_with_octave(state, scarp_octave_of(plan, l.first + k), l, k, x, dimensions);
    }
    return state.sum;
}

/* Noise with warps, and the self-test of scarp_gpu_answers. */

/* Components of a level, each at `at`, with derivatives with respect to x; `y` says how that
   depends on x, unless the level is the deepest. */
ScarpDisplaced scarp_level_at(uint plan, int i, int components, bool deepest, vec3 at,
        ScarpDisplaced y, int dimensions)
{
    ScarpLevel l = scarp_level_of(plan, i);
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

/* So many components of vector noise; one is the noise. */
ScarpDisplaced scarp_components_at(uint plan, vec3 x, int components, int dimensions)
{
    int depth = scarp_int_of(scarp_only_depth(scarp_plan[plan].depth));
    vec3 at = x;
    ScarpDisplaced y = scarp_not_displaced();
    for (int i = depth; i >= 0; i--) {
        int count = dimensions;
        if (i == 0) {
            count = components;
        }
        y = scarp_level_at(plan, i, count, i == depth, at, y, dimensions);
        if (i > 0) {
            y = scarp_positions_of(y);
            at = scarp_add3(x, scarp_values_of(y));
        }
    }
    return y;
}

/* What scarp_sample2 gives at (x, y); outputs along z mean nothing. */
ScarpSample scarp_sample2(uint plan, float x, float y)
{
    return scarp_components_at(plan, scarp_vec3_of(x, y, 0.0f), 1, 2).x;
}

/* What scarp_sample3 gives at (x, y, z). */
ScarpSample scarp_sample3(uint plan, float x, float y, float z)
{
    return scarp_components_at(plan, scarp_vec3_of(x, y, z), 1, 3).x;
}

/* What scarp_vector2 gives, as x and y, of a plan by scarp_gpu_vector_plan_make. */
ScarpDisplaced scarp_vector2(uint plan, float x, float y)
{
    return scarp_components_at(plan, scarp_vec3_of(x, y, 0.0f), 2, 2);
}

/* What scarp_vector3 gives. */
ScarpDisplaced scarp_vector3(uint plan, float x, float y, float z)
{
    return scarp_components_at(plan, scarp_vec3_of(x, y, z), 3, 3);
}

/* The hash h with the outputs of a sample up to an order, in the order of struct scarp_samples. */
uint scarp_hash_with_sample(uint h, ScarpSample s, uint order, int dimensions)
{
    bool is_space = dimensions == 3;
    uint next = scarp_hash_with(h, s.value);
    if (order > 0u) {
        next = scarp_hash_with(scarp_hash_with(next, s.gradient.x), s.gradient.y);
        if (is_space) {
            next = scarp_hash_with(next, s.gradient.z);
        }
    }
    if (order > 1u) {
        next = scarp_hash_with(scarp_hash_with(next, s.diagonal.x), s.mixed.x);
        if (is_space) {
            next = scarp_hash_with(next, s.mixed.y);
        }
        next = scarp_hash_with(next, s.diagonal.y);
        if (is_space) {
            next = scarp_hash_with(scarp_hash_with(next, s.mixed.z), s.diagonal.z);
        }
    }
    return next;
}

/* The self-test: a hash of the outputs at test point i up to an order, which is answer i of
   scarp_gpu_answers where the shader has the bits of the library. */
uint scarp_answer2(uint plan, uint order, uint i)
{
    float unit = scarp_plan[plan].unit;
    ScarpSample s = scarp_sample2(plan, scarp_test_coordinate(unit, i, 0u),
            scarp_test_coordinate(unit, i, 1u));
    return scarp_hash_with_sample(0u, s, order, 2);
}

uint scarp_answer3(uint plan, uint order, uint i)
{
    float unit = scarp_plan[plan].unit;
    ScarpSample s = scarp_sample3(plan, scarp_test_coordinate(unit, i, 0u),
            scarp_test_coordinate(unit, i, 1u), scarp_test_coordinate(unit, i, 2u));
    return scarp_hash_with_sample(0u, s, order, 3);
}

/* Cells and velocities of a plan. */

/* What scarp_cells2 and scarp_cells3 give: distances to the nearest feature and to the second,
   their gradients, and the place of the nearest. */
struct ScarpCells {
    uint id;
    float f1;
    float f2;
    vec3 d1;
    vec3 d2;
    vec3 place;
};

/* The cells around a point x, which lies at p in octave o; `unit` is the length of a cell. */
ScarpCells scarp_cells_around(ScarpOctave o, ScarpLocation p, float unit, vec3 x, int dimensions)
{
    ScarpLattice l = ScarpLattice(o.key, o.last, false, vec4(0.0f, 0.0f, 0.0f, 0.0f), 0.0f, 0.0f,
            0u);
    l.jitter = o.turn.x;
    ScarpNearest n = scarp_nearest_at(l, p, dimensions);
    ScarpSample first = scarp_distance_to(n.first);
    ScarpSample second = scarp_distance_to(n.second);
    ScarpCells c;
    c.id = n.first.hash * SCARP_FEATURE_ID;
    c.f1 = scarp_mul(first.value, unit);
    c.f2 = scarp_mul(second.value, unit);
    c.d1 = first.gradient;
    c.d2 = second.gradient;
    c.place = scarp_sub3(x, scarp_mul3(unit, n.first.d));
    return c;
}

ScarpCells scarp_cells_in(uint plan, vec3 x, int dimensions)
{
    ScarpOctave o = scarp_octave_of(plan, 0u);
    ScarpLocation p = scarp_location_of(o, SCARP_CELL_F1, false, x, dimensions);
    return scarp_cells_around(o, p, o.inverse, x, dimensions);
}

/* The cells of a noise whose basis is cellular. */
ScarpCells scarp_cells2(uint plan, float x, float y)
{
    return scarp_cells_in(plan, scarp_vec3_of(x, y, 0.0f), 2);
}

ScarpCells scarp_cells3(uint plan, float x, float y, float z)
{
    return scarp_cells_in(plan, scarp_vec3_of(x, y, z), 3);
}

/* What scarp_curl2 gives; nothing along z. */
ScarpFlow scarp_curl2(uint plan, float x, float y)
{
    return scarp_curl_in_plane(scarp_sample2(plan, x, y));
}

/* What scarp_curl3 gives, of a plan by scarp_gpu_vector_plan_make. */
ScarpFlow scarp_curl3(uint plan, float x, float y, float z)
{
    return scarp_curl_in_space(scarp_vector3(plan, x, y, z));
}

/* The chain rule over samples. */

/* a b, but 0 where a or b is 0, whatever the other one is. */
float scarp_term(float a, float b)
{
    return scarp_either(a == 0.0f || b == 0.0f, 0.0f, scarp_mul(a, b));
}

vec3 scarp_terms(float a, vec3 b)
{
    return scarp_vec3_of(scarp_term(a, b.x), scarp_term(a, b.y), scarp_term(a, b.z));
}

/* a_i b_j + a_j b_i */
float scarp_crossed(float ai, float aj, float bi, float bj)
{
    return scarp_add(scarp_term(ai, bj), scarp_term(aj, bi));
}

/* a b, as scarp_multiply */
ScarpSample scarp_chain_multiply(ScarpSample a, ScarpSample b)
{
    vec3 g = a.gradient;
    vec3 h = b.gradient;
    vec3 diagonal = scarp_add3(scarp_terms(b.value, a.diagonal), scarp_terms(a.value, b.diagonal));
    vec3 mixed = scarp_add3(scarp_terms(b.value, a.mixed), scarp_terms(a.value, b.mixed));
    return scarp_sample_of(scarp_term(a.value, b.value), scarp_add3(scarp_terms(b.value, g),
            scarp_terms(a.value, h)), scarp_add3(diagonal, scarp_vec3_of(scarp_crossed(g.x, g.x,
            h.x, h.x), scarp_crossed(g.y, g.y, h.y, h.y), scarp_crossed(g.z, g.z, h.z, h.z))),
            scarp_add3(mixed, scarp_vec3_of(scarp_crossed(g.x, g.y, h.x, h.y), scarp_crossed(g.x,
            g.z, h.x, h.z), scarp_crossed(g.y, g.z, h.y, h.z))));
}

/* a + m (b - a), as scarp_mix */
ScarpSample scarp_chain_mix(ScarpSample a, ScarpSample b, ScarpSample m)
{
    ScarpSample nearer = a;
    ScarpSample share = m;
    if (m.value > 0.5f) {
        nearer = b;
        share.value = scarp_sub(m.value, 1.0f);
    }
    return scarp_difference_of(nearer, scarp_chain_multiply(scarp_difference_of(a, b), share));
}

/* scale a + offset */
ScarpSample scarp_chain_affine(ScarpSample a, float scale, float offset)
{
    ScarpSample s = scarp_scaled(a, scale, scale, scale);
    s.value = scarp_add(s.value, offset);
    return s;
}

/* Where b is NaN, so is the lesser, or the greater, of a and b. */
ScarpSample scarp_chain_min(ScarpSample a, ScarpSample b)
{
    ScarpSample s = a;
    if (b.value < a.value || b.value != b.value) {
        s = b;
    }
    return s;
}

ScarpSample scarp_chain_max(ScarpSample a, ScarpSample b)
{
    ScarpSample s = a;
    if (a.value < b.value || b.value != b.value) {
        s = b;
    }
    return s;
}

/* f_aa a_i a_j of a gradient a */
vec3 scarp_squares_of(float faa, vec3 a)
{
    return scarp_vec3_of(scarp_mul(scarp_mul(faa, a.x), a.x), scarp_mul(scarp_mul(faa, a.y), a.y),
            scarp_mul(scarp_mul(faa, a.z), a.z));
}

vec3 scarp_products_of(float faa, vec3 a)
{
    return scarp_vec3_of(scarp_mul(scarp_mul(faa, a.x), a.y), scarp_mul(scarp_mul(faa, a.x), a.z),
            scarp_mul(scarp_mul(faa, a.y), a.z));
}

/* f(a), of which f_a and f_aa are the derivatives; as scarp_apply1 */
ScarpSample scarp_chain_apply1(ScarpSample a, float f, float fa, float faa)
{
    ScarpSample first = scarp_scaled(a, 0.0f, fa, fa);
    return scarp_sample_of(f, first.gradient, scarp_add3(first.diagonal, scarp_squares_of(faa,
            a.gradient)), scarp_add3(first.mixed, scarp_products_of(faa, a.gradient)));
}

/* A function of two samples, and its partial derivatives. */
struct ScarpPartials {
    float f;
    float a;
    float b;
    float aa;
    float ab;
    float bb;
};

/* f(a, b), as scarp_apply2 */
ScarpSample scarp_chain_apply2(ScarpSample a, ScarpSample b, ScarpPartials p)
{
    vec3 g = a.gradient;
    vec3 h = b.gradient;
    vec3 diagonal = scarp_add3(scarp_mul3(p.a, a.diagonal), scarp_mul3(p.b, b.diagonal));
    vec3 mixed = scarp_add3(scarp_mul3(p.a, a.mixed), scarp_mul3(p.b, b.mixed));
    return scarp_sample_of(p.f, scarp_add3(scarp_mul3(p.a, g), scarp_mul3(p.b, h)),
            scarp_add3(scarp_add3(diagonal, scarp_add3(scarp_squares_of(p.aa, g),
            scarp_squares_of(p.bb, h))), scarp_mul3(p.ab, scarp_crossed_diagonal(g, h))),
            scarp_add3(scarp_add3(mixed, scarp_add3(scarp_products_of(p.aa, g),
            scarp_products_of(p.bb, h))), scarp_mul3(p.ab, scarp_crossed_mixed(g, h))));
}

/* f(a) without second derivatives of f */
ScarpSample scarp_chain_straight(ScarpSample a, float f, float fa)
{
    ScarpSample s = scarp_scaled(a, 0.0f, fa, fa);
    s.value = f;
    return s;
}

/* The lesser, or the greater, of a and b, rounded where they differ by less than a width; k is that
   of the two functions below. */
ScarpSample scarp_smooth_of(ScarpSample a, ScarpSample b, bool takes_b, vec3 k)
{
    float left = scarp_sub(1.0f, scarp_mul(scarp_magnitude(scarp_sub(a.value, b.value)), k.x));
    float h = scarp_either(left < 0.0f, 0.0f, left);
    float half_weight = scarp_mul(0.5f, scarp_mul(h, h));
    float rest = scarp_sub(1.0f, half_weight);
    float of_a = scarp_either(takes_b, half_weight, rest);
    float of_b = scarp_either(takes_b, rest, half_weight);
    vec3 d = scarp_sub3(a.gradient, b.gradient);
    float bend = scarp_mul(h, k.z);
    vec3 diagonal = scarp_add3(scarp_mul3(of_a, a.diagonal), scarp_mul3(of_b, b.diagonal));
    vec3 mixed = scarp_add3(scarp_mul3(of_a, a.mixed), scarp_mul3(of_b, b.mixed));
    return scarp_sample_of(scarp_sub(scarp_either(takes_b, b.value, a.value),
            scarp_mul(scarp_mul(scarp_mul(h, h), h), k.y)), scarp_add3(scarp_mul3(of_a, a.gradient),
            scarp_mul3(of_b, b.gradient)), scarp_add3(diagonal, scarp_squares_of(bend, d)),
            scarp_add3(mixed, scarp_products_of(bend, d)));
}

/* k: 1 / k, k / 6, -1 / k of the width k */
ScarpSample scarp_chain_smooth_min(ScarpSample a, ScarpSample b, vec3 k)
{
    return scarp_smooth_of(a, b, b.value < a.value || b.value != b.value, k);
}

/* k: 1 / k, -k / 6, 1 / k of the width k */
ScarpSample scarp_chain_smooth_max(ScarpSample a, ScarpSample b, vec3 k)
{
    return scarp_smooth_of(a, b, a.value < b.value || b.value != b.value, k);
}

ScarpSample scarp_chain_clamp(ScarpSample a, float lo, float hi)
{
    float v = a.value;
    float f = scarp_either(v < lo, lo, scarp_either(v > hi, hi, v));
    return scarp_chain_straight(a, f, scarp_either(v < lo || v > hi, 0.0f, scarp_add(1.0f,
            scarp_sub(v, v))));
}

ScarpSample scarp_chain_abs(ScarpSample a)
{
    float v = a.value;
    float down = scarp_either(v < 0.0f, -1.0f, scarp_sub(v, v)); /* 0, or NaN */
    return scarp_chain_straight(a, scarp_magnitude(v), scarp_either(v > 0.0f, 1.0f, down));
}

float scarp_within_unit(float t)
{
    return scarp_either(t < 0.0f, 0.0f, scarp_either(t > 1.0f, 1.0f, t));
}

/* The quintic fade may exceed 1 by 2^-23. */
ScarpFade scarp_step_fade(float t)
{
    ScarpFade s = scarp_fade(SCARP_QUINTIC, t);
    s.u = scarp_either(s.u > 1.0f, 1.0f, s.u);
    return s;
}

/* The step from lo to hi; `by` is 1 / (hi - lo). */
ScarpSample scarp_chain_smoothstep(ScarpSample a, float lo, float by)
{
    ScarpFade s = scarp_step_fade(scarp_within_unit(scarp_mul(scarp_sub(a.value, lo), by)));
    return scarp_chain_apply1(a, s.u, scarp_mul(s.du, by), scarp_mul(scarp_mul(s.ddu, by), by));
}

/* k: how many steps, 1 / steps, 1 / riser, strength */
ScarpSample scarp_chain_terrace(ScarpSample a, vec4 k)
{
    float t = scarp_mul(a.value, k.x);
    float whole = scarp_floor_of(t);
    float u = scarp_sub(t, whole);
    ScarpFade s = scarp_step_fade(scarp_within_unit(scarp_add(scarp_mul(scarp_sub(u, 0.5f), k.z),
            0.5f)));
    float rise = scarp_add(u, scarp_mul(k.w, scarp_sub(s.u, u)));
    return scarp_chain_apply1(a, scarp_mul(scarp_add(whole, rise), k.y), scarp_add(1.0f,
            scarp_mul(k.w, scarp_sub(scarp_mul(s.du, k.z), 1.0f))),
            scarp_mul(scarp_mul(scarp_mul(scarp_mul(s.ddu, k.z), k.z), k.x), k.w));
}

/* sqrt(a^2 + round^2) */
ScarpSample scarp_chain_smooth_abs(ScarpSample a, float round, float round2)
{
    float f = scarp_root(scarp_add(scarp_mul(a.value, a.value), round2));
    float by = scarp_inverse(f);
    float share = scarp_mul(round, by);
    return scarp_chain_apply1(a, f, scarp_mul(a.value, by), scarp_mul(scarp_mul(share, share), by));
}

/* More functions over samples. */

/* The root of a, 0 where that is negative. */
ScarpSample scarp_chain_sqrt(ScarpSample a)
{
    float v = scarp_either(a.value < 0.0f, 0.0f, a.value);
    float f = scarp_root(v);
    bool is_flat = f == 0.0f;
    float slope = scarp_mul(0.5f, scarp_inverse(scarp_either(is_flat, 1.0f, f)));
    float bend = scarp_mul(slope, scarp_mul(0.5f, scarp_inverse(scarp_either(is_flat, 1.0f, v))));
    return scarp_chain_apply1(a, f, scarp_either(is_flat, 0.0f, slope), scarp_either(is_flat, 0.0f,
            -bend));
}

/* a / b, where b is not 0. */
ScarpSample scarp_chain_divide(ScarpSample a, ScarpSample b)
{
    float by = scarp_with_bit(scarp_inverse(scarp_magnitude(b.value)),
            scarp_bits_of(b.value) >> 31u);
    float f = scarp_quotient(a.value, b.value);
    ScarpPartials p = ScarpPartials(f, by, -scarp_mul(f, by), 0.0f, -scarp_mul(by, by),
            scarp_mul(scarp_mul(2.0f, scarp_mul(f, by)), by));
    return scarp_chain_apply2(a, b, p);
}

/* a folded to and fro: -1 at even numbers, 1 at odd ones. All floats of 2^24 and more are even. */
ScarpSample scarp_chain_pulse(ScarpSample a)
{
    float v = scarp_either(scarp_magnitude(a.value) < 16777216.0f, a.value, 0.0f);
    float lower = scarp_floor_of(v);
    float fraction = scarp_sub(v, lower);
    float up = scarp_sub(scarp_mul(2.0f, fraction), 1.0f);
    bool is_odd = (scarp_whole_of(lower) & 1) != 0;
    float slope = scarp_either(is_odd, -2.0f, 2.0f);
    return scarp_chain_straight(a, scarp_either(is_odd, -up, up), scarp_either(fraction == 0.0f,
            0.0f, slope));
}

/* The length of the gradient; no Hessian. */
ScarpSample scarp_chain_slope(ScarpSample a, int dimensions)
{
    ScarpRows h = scarp_hessian_of(a);
    float length = scarp_root(scarp_dot(a.gradient, a.gradient, dimensions));
    float by = scarp_either(length == 0.0f, 1.0f, length);
    vec3 sums = scarp_times(h, a.gradient, dimensions);
    ScarpSample s = scarp_constant(length);
    if (length != 0.0f) {
        s.gradient = scarp_vec3_of(scarp_quotient(sums.x, by), scarp_quotient(sums.y, by),
                scarp_quotient(sums.z, by));
    }
    return s;
}

/* A piece of a curve at a. k and l are the knots around it, `first` and `last` those at the ends:
   x, value, slope, 1 / (the next x - x). */
ScarpSample scarp_chain_curve(ScarpSample a, vec4 k, vec4 l, vec4 first, vec4 last)
{
    float width = scarp_sub(l.x, k.x);
    float t = scarp_mul(scarp_sub(a.value, k.x), k.w);
    float rise = scarp_sub(l.y, k.y);
    float s0 = scarp_mul(k.z, width);
    float s1 = scarp_mul(l.z, width);
    float c2 = scarp_sub(scarp_sub(scarp_mul(3.0f, rise), scarp_mul(2.0f, s0)), s1);
    float c3 = scarp_sub(scarp_add(s0, s1), scarp_mul(2.0f, rise));
    float lowest = scarp_either(k.y < l.y, k.y, l.y);
    float highest = scarp_either(k.y < l.y, l.y, k.y);
    float v = scarp_add(k.y, scarp_mul(t, scarp_add(s0, scarp_mul(t, scarp_add(c2, scarp_mul(t,
            c3))))));
    float held = scarp_either(v < lowest, lowest, scarp_either(v > highest, highest, v));
    bool is_before = a.value <= first.x;
    bool is_behind = a.value >= last.x;
    bool is_level = is_before || is_behind;
    float slope = scarp_mul(scarp_add(s0, scarp_mul(t, scarp_add(scarp_mul(2.0f, c2), scarp_mul(t,
            scarp_mul(3.0f, c3))))), k.w);
    float bend = scarp_mul(scarp_mul(scarp_add(scarp_mul(2.0f, c2), scarp_mul(t, scarp_mul(6.0f,
            c3))), k.w), k.w);
    return scarp_chain_apply1(a, scarp_either(is_before, first.y, scarp_either(is_behind, last.y,
            held)), scarp_either(is_level, 0.0f, slope), scarp_either(is_level, 0.0f, bend));
}

/* The sine, as calls/partials. */

/* (2^32 high + low) / 2^64, or / 2^63 where that is said. */
struct ScarpWide {
    uint high;
    uint low;
};

ScarpWide scarp_wide_of(uint high, uint low)
{
    ScarpWide w = ScarpWide(high, low);
    return w;
}

/* The product of two uints. */
ScarpWide scarp_product_of_words(uint a, uint b)
{
    uint al = a & 0xffffu;
    uint ah = a >> 16u;
    uint bl = b & 0xffffu;
    uint bh = b >> 16u;
    uint low = al * bl;
    uint left = ah * bl;
    uint right = al * bh;
    uint middle = (low >> 16u) + (left & 0xffffu) + (right & 0xffffu);
    return scarp_wide_of(ah * bh + (left >> 16u) + (right >> 16u) + (middle >> 16u), (low
            & 0xffffu) | (middle << 16u));
}

ScarpWide scarp_sum_of_wides(ScarpWide a, ScarpWide b)
{
    uint low = a.low + b.low;
    uint carry = scarp_pick_uint(low < a.low, 1u, 0u);
    return scarp_wide_of(a.high + b.high + carry, low);
}

/* a - b, which is not below 0 */
ScarpWide scarp_difference_of_wides(ScarpWide a, ScarpWide b)
{
    uint borrow = scarp_pick_uint(a.low < b.low, 1u, 0u);
    return scarp_wide_of(a.high - b.high - borrow, a.low - b.low);
}

/* a b, up to 2 units too small: without the product of the lower halves. */
ScarpWide scarp_product_of_wides(ScarpWide a, ScarpWide b)
{
    ScarpWide left = scarp_product_of_words(a.high, b.low);
    ScarpWide right = scarp_product_of_words(a.low, b.high);
    ScarpWide sum = scarp_sum_of_wides(scarp_product_of_words(a.high, b.high), scarp_wide_of(0u,
            left.high));
    return scarp_sum_of_wides(sum, scarp_wide_of(0u, right.high));
}

/* c - z rest: a step of a series. `is_cosine` chooses the coefficient. */
ScarpWide scarp_step_of_series(ScarpWide z, ScarpWide rest, bool is_cosine, ScarpWide of_sine,
        ScarpWide of_cosine)
{
    ScarpWide c = of_sine;
    if (is_cosine) {
        c = of_cosine;
    }
    return scarp_difference_of_wides(c, scarp_product_of_wides(z, rest));
}

/* The Taylor series of the cosine of x, or of the sine over x, times 2^63, of z = x^2 2^64. */
ScarpWide scarp_series_of(ScarpWide z, bool is_cosine)
{
    ScarpWide s = scarp_wide_of(0u, scarp_pick_uint(is_cosine, 0x0006b9fdu, 0x0000654bu));
    s = scarp_step_of_series(z, s, is_cosine, scarp_wide_of(0x00000000u, 0x006b9fd0u),
            scarp_wide_of(0x00000000u, 0x064e5d2au));
    s = scarp_step_of_series(z, s, is_cosine, scarp_wide_of(0x00000000u, 0x5849184fu),
            scarp_wide_of(0x00000004u, 0x7bb63bfeu));
    s = scarp_step_of_series(z, s, is_cosine, scarp_wide_of(0x00000035u, 0xcc8acfebu),
            scarp_wide_of(0x0000024fu, 0xc9f6ef14u));
    s = scarp_step_of_series(z, s, is_cosine, scarp_wide_of(0x0000171du, 0xe3a556c7u),
            scarp_wide_of(0x0000d00du, 0x00d00d01u));
    s = scarp_step_of_series(z, s, is_cosine, scarp_wide_of(0x00068068u, 0x06806807u),
            scarp_wide_of(0x002d82d8u, 0x2d82d82eu));
    s = scarp_step_of_series(z, s, is_cosine, scarp_wide_of(0x01111111u, 0x11111111u),
            scarp_wide_of(0x05555555u, 0x55555555u));
    s = scarp_step_of_series(z, s, is_cosine, scarp_wide_of(0x15555555u, 0x55555555u),
            scarp_wide_of(0x40000000u, 0x00000000u));
    s = scarp_step_of_series(z, s, is_cosine, scarp_wide_of(0x80000000u, 0x00000000u),
            scarp_wide_of(0x80000000u, 0x00000000u));
    return s;
}

/* w / 2^64 times 2^e, rounded to a float. */
float scarp_float_of_wide(ScarpWide w, int e)
{
    ScarpWide m = w;
    int exponent = e;
    for (int i = 0; i < 4 && m.high < 0x80000000u; i++) {
        m = scarp_wide_of((m.high << 1u) | (m.low >> 31u), m.low << 1u);
        exponent = exponent - 1;
    }
    uint q = (m.high >> 8u) + ((m.high >> 7u) & 1u);
    float rounded = scarp_float_of_bits((scarp_uint_of(exponent + 125) << 23u) + q);
    return scarp_pick(exponent < -120, 0.0f, rounded);
}

/* a / 2^steps, steps below 64; or 4 a where they are -2. */
ScarpWide scarp_shifted(ScarpWide a, int steps)
{
    uint by = scarp_uint_of(steps) & 31u;
    uint crossing = scarp_pick_uint(by == 0u, 0u, a.high << (32u - by));
    ScarpWide w = scarp_wide_of(a.high >> by, (a.low >> by) | crossing);
    if (steps >= 32) {
        w = scarp_wide_of(0u, a.high >> by);
    }
    if (steps < 0) {
        w = scarp_wide_of((a.high << 2u) | (a.low >> 30u), a.low << 2u);
    }
    return w;
}

/* (pi / 2)^2 is this times 4 / 2^64. */
#define SCARP_PI2_HIGH 0x9de9e64du
#define SCARP_PI2_LOW 0xf22ef2d2u

/* c 2^e times the cosine of r quarters, or the sine of them, for which c is given times pi / 2;
   -1/2 <= r <= 1/2. */
float scarp_quarter_wave(float r, bool is_cosine, ScarpWide c, int e)
{
    uint bits = scarp_bits_of(r) & 0x7fffffffu;
    int exponent = scarp_int_of(bits >> 23u) - 126; /* r is its mantissa / 2^24, times 2^exponent */
    ScarpWide m = scarp_wide_of((bits << 8u) | 0x80000000u, 0u);
    ScarpWide z = scarp_wide_of(0u, 0u);
    if (exponent > -32) {
        z = scarp_product_of_wides(scarp_product_of_wides(m, m), scarp_wide_of(SCARP_PI2_HIGH,
                SCARP_PI2_LOW));
        z = scarp_shifted(z, -2 * exponent - 2);
    }
    ScarpWide wave = scarp_product_of_wides(scarp_series_of(z, is_cosine), c);
    float value = scarp_float_of_wide(wave, e + 1);
    if (!is_cosine) {
        value = scarp_with_bit(scarp_float_of_wide(scarp_product_of_wides(wave, m),
                e + 1 + exponent), scarp_bits_of(r) >> 31u);
    }
    return value;
}

/* A sine of so many whole quarters and r of one, times 1, 2 pi or 4 pi^2: by `power` of 2 pi. */
float scarp_sine_of_quarters(int whole, float r, int power)
{
    bool is_cosine = (whole & 1) != 0;
    ScarpWide c = scarp_wide_of(0x80000000u, 0u); /* 1 */
    int e = 1;
    if (power == 0 && !is_cosine) {
        c = scarp_wide_of(0xc90fdaa2u, 0x2168c235u);
        e = 1;
    }
    if (power == 1 && is_cosine) {
        c = scarp_wide_of(0xc90fdaa2u, 0x2168c235u);
        e = 3;
    }
    if (power == 1 && !is_cosine) {
        c = scarp_wide_of(0x9de9e64du, 0xf22ef2d2u);
        e = 4;
    }
    if (power == 2 && is_cosine) {
        c = scarp_wide_of(0x9de9e64du, 0xf22ef2d2u);
        e = 6;
    }
    if (power == 2 && !is_cosine) {
        c = scarp_wide_of(0xf80cdac9u, 0xc4ebe0f0u);
        e = 6;
    }
    return scarp_with_bit(scarp_quarter_wave(r, is_cosine, c, e), (scarp_uint_of(whole) >> 1u)
            & 1u);
}

/* The sine of a turns. All floats of 2^24 and more are whole numbers of turns. */
ScarpSample scarp_chain_sine(ScarpSample a)
{
    float v = scarp_either(scarp_magnitude(a.value) < 16777216.0f, a.value, 0.0f);
    float quarters = scarp_mul(4.0f, v);
    int below = scarp_whole_of(quarters);
    float rest = scarp_sub(quarters, scarp_float_of_int(below));
    int whole = below;
    float r = rest;
    if (rest >= 0.5f) {
        whole = below + 1;
        r = scarp_sub(rest, 1.0f);
    }
    if (rest <= -0.5f) {
        whole = below - 1;
        r = scarp_add(rest, 1.0f);
    }
    return scarp_chain_apply1(a, scarp_sine_of_quarters(whole, r, 0),
            scarp_sine_of_quarters(whole + 1, r, 1), -scarp_sine_of_quarters(whole, r, 2));
}

/* Gullies, which run down the slope of a base (scarp. */

#define SCARP_GULLY_TAU2 0.0025f /* of tau = 0.05, where the direction of flat ground is soft */
#define SCARP_GULLY_EPS2 0.25f /* of eps = 0.5, where waves of corners cancel */

/* Two numbers along x and y, or the parts of a complex number. */
struct ScarpPair2 {
    float x;
    float y;
};

/* A number with its derivatives along x and y. */
struct ScarpJet {
    float value;
    ScarpPair2 d;
};

/* A pair with its derivatives. */
struct ScarpPairJet {
    ScarpPair2 value;
    ScarpPair2 dx;
    ScarpPair2 dy;
};

ScarpPair2 scarp_pair_of(float x, float y)
{
    ScarpPair2 p = ScarpPair2(x, y);
    return p;
}

ScarpPair2 scarp_sum2(ScarpPair2 a, ScarpPair2 b)
{
    return scarp_pair_of(scarp_add(a.x, b.x), scarp_add(a.y, b.y));
}

ScarpPair2 scarp_difference2(ScarpPair2 a, ScarpPair2 b)
{
    return scarp_pair_of(scarp_sub(a.x, b.x), scarp_sub(a.y, b.y));
}

ScarpPair2 scarp_scaled2(float a, ScarpPair2 b)
{
    return scarp_pair_of(scarp_mul(a, b.x), scarp_mul(a, b.y));
}

float scarp_dot2(ScarpPair2 a, ScarpPair2 b)
{
    return scarp_add(scarp_mul(a.x, b.x), scarp_mul(a.y, b.y));
}

/* a + u (b - a) */
ScarpPair2 scarp_mix2(ScarpPair2 a, ScarpPair2 b, float u)
{
    return scarp_sum2(a, scarp_scaled2(u, scarp_difference2(b, a)));
}

/* a p + b q */
ScarpPair2 scarp_combined2(float a, ScarpPair2 p, float b, ScarpPair2 q)
{
    return scarp_sum2(scarp_scaled2(a, p), scarp_scaled2(b, q));
}

/* The product of complex numbers; of a turn and a vector: the vector, turned. */
ScarpPair2 scarp_product2(ScarpPair2 a, ScarpPair2 b)
{
    return scarp_pair_of(scarp_sub(scarp_mul(a.x, b.x), scarp_mul(a.y, b.y)),
            scarp_add(scarp_mul(a.x, b.y), scarp_mul(a.y, b.x)));
}

/* The constants of a call. */
struct ScarpGullyShape {
    float low;
    float steepness; /* where the step from floors to crests begins; 1 / its width */
    float slope2;
    float slope2_low; /* slopes where gullies have half their strength, squared */
    float lowered; /* 1 + floor */
    float round;
    float round2; /* and its square */
    float fall; /* 2 / (sqrt(1 + round^2) - round) */
    float branch;
};

/* The constants of an octave, whose axes are turned by R. */
struct ScarpGullyOctave {
    float weight; /* of v_k */
    float keep; /* 0 of the first octave */
    ScarpPair2 waves; /* stripes R */
    ScarpPair2 angles; /* 2 pi stripes R */
    ScarpPair2 cells; /* f_k R */
    float stretch; /* 2 pi stripes f_k */
};

/* What goes from octave to octave. */
struct ScarpGully {
    ScarpPairJet slope;
    ScarpJet steep;
    ScarpJet exposure;
    ScarpJet sum;
};

/* The base at a point: its height, its gradient and its Hessian. */
struct ScarpGullyBase {
    float value;
    float dx;
    float dy;
    float dxx;
    float dxy;
    float dyy;
};

/* The smooth step of the height from floors, 0, to crests, 1. */
ScarpJet scarp_height_of(ScarpGullyShape g, ScarpGullyBase b)
{
    float raw = scarp_mul(scarp_sub(b.value, g.low), g.steepness);
    float above = scarp_either(raw < 0.0f, 0.0f, raw);
    float z = scarp_either(above > 1.0f, 1.0f, above);
    float by = scarp_mul(scarp_mul(scarp_mul(6.0f, z), scarp_sub(1.0f, z)), g.steepness);
    ScarpJet h = ScarpJet(scarp_mul(scarp_mul(z, z), scarp_sub(3.0f, scarp_mul(2.0f, z))),
            ScarpPair2(scarp_mul(by, b.dx), scarp_mul(by, b.dy)));
    return h;
}

ScarpGully scarp_gully_begin(ScarpGullyShape g, ScarpGullyBase b)
{
    ScarpJet h = scarp_height_of(g, b);
    ScarpPair2 gradient = ScarpPair2(b.dx, b.dy);
    float rest = scarp_sub(1.0f, h.value);
    float slope2 = scarp_add(scarp_mul(rest, g.slope2_low), scarp_mul(h.value, g.slope2));
    float unit = scarp_inverse(scarp_root(scarp_add(scarp_dot2(gradient, gradient), slope2)));
    ScarpPair2 s = scarp_scaled2(unit, gradient);
    float by = scarp_mul(scarp_mul(0.5f, unit), scarp_sub(g.slope2, g.slope2_low));
    float hx = scarp_add(scarp_add(scarp_mul(s.x, b.dxx), scarp_mul(s.y, b.dxy)), scarp_mul(by,
            h.d.x));
    float hy = scarp_add(scarp_add(scarp_mul(s.x, b.dxy), scarp_mul(s.y, b.dyy)), scarp_mul(by,
            h.d.y));
    ScarpPair2 sx = scarp_scaled2(unit, scarp_pair_of(scarp_sub(b.dxx, scarp_mul(s.x, hx)),
            scarp_sub(b.dxy, scarp_mul(s.y, hx))));
    ScarpPair2 sy = scarp_scaled2(unit, scarp_pair_of(scarp_sub(b.dxy, scarp_mul(s.x, hy)),
            scarp_sub(b.dyy, scarp_mul(s.y, hy))));
    ScarpGully state = ScarpGully(ScarpPairJet(s, sx, sy), ScarpJet(scarp_dot2(s, s),
            ScarpPair2(scarp_mul(2.0f, scarp_dot2(s, sx)), scarp_mul(2.0f, scarp_dot2(s, sy)))),
            ScarpJet(scarp_sub(1.0f, scarp_mul(rest, g.lowered)), scarp_scaled2(g.lowered, h.d)),
            ScarpJet(0.0f, ScarpPair2(0.0f, 0.0f)));
    return state;
}

/* sin(2 pi b), |b| <= 1/4; the error is at most 3.4e-9 before rounding. */
float scarp_sine_of_quarter(float b)
{
    float z = scarp_mul(b, b);
    float p = scarp_sub(scarp_mul(scarp_add(scarp_mul(scarp_sub(scarp_mul(39.5367068f, z),
            76.5497824f), z), 81.6010040f), z), 41.3416550f);
    return scarp_mul(scarp_add(scarp_mul(p, z), 6.28318516f), b);
}

/* e^(2 pi i u), |u| < 2^22 */
ScarpPair2 scarp_wave_of(float u)
{
    float v = scarp_sub(u, scarp_floor_of(scarp_add(u, 0.5f)));
    float a = scarp_magnitude(v);
    float rest = scarp_sub(0.5f, a);
    float folded = scarp_either(a < rest, a, rest);
    return scarp_pair_of(scarp_sine_of_quarter(scarp_sub(0.25f, a)),
            scarp_sine_of_quarter(scarp_either(v < 0.0f, scarp_sub(0.0f, folded), folded)));
}

/* The direction across the slope. */
ScarpPairJet scarp_across_slope(ScarpPairJet s)
{
    float unit = scarp_inverse(scarp_root(scarp_add(scarp_dot2(s.value, s.value),
            SCARP_GULLY_TAU2)));
    ScarpPair2 t = ScarpPair2(scarp_mul(s.value.y, scarp_sub(0.0f, unit)), scarp_mul(s.value.x,
            unit));
    ScarpPair2 ex = scarp_scaled2(unit, s.dx);
    ScarpPair2 ey = scarp_scaled2(unit, s.dy);
    float bx = scarp_sub(scarp_mul(t.y, ex.x), scarp_mul(t.x, ex.y));
    float by = scarp_sub(scarp_mul(t.y, ey.x), scarp_mul(t.x, ey.y));
    ScarpPairJet across = ScarpPairJet(t, ScarpPair2(scarp_sub(0.0f, scarp_add(scarp_mul(t.x, bx),
            ex.y)), scarp_sub(ex.x, scarp_mul(t.y, bx))), ScarpPair2(scarp_sub(0.0f,
            scarp_add(scarp_mul(t.x, by), ey.y)), scarp_sub(ey.x, scarp_mul(t.y, by))));
    return across;
}

/* The wave of a corner: `waves` is how many lie between the point and it. */
ScarpPair2 scarp_corner_wave(uint hash, float waves)
{
    return scarp_wave_of(scarp_add(scarp_mul(scarp_lattice_value(hash), 2.32830644e-10f), waves));
}

/* The derivative of Z along an axis: of the weights, and of the waves, which turn with t and with
   its derivative d. */
ScarpPair2 scarp_blend_slope(ScarpPair2 by_weights, float t, ScarpPair2 d, ScarpPair2 z,
        ScarpPair2 moment_x, ScarpPair2 moment_y)
{
    ScarpPair2 turn = scarp_sum2(scarp_scaled2(t, z), scarp_combined2(d.x, moment_x, d.y,
            moment_y));
    return scarp_pair_of(scarp_sub(by_weights.x, turn.y), scarp_add(by_weights.y, turn.x));
}

/* The blend Z of an octave. */
ScarpPairJet scarp_blend_of(ScarpLattice l, ScarpGullyOctave o, ScarpLocation p, ScarpPairJet t)
{
    ScarpFade fx = scarp_fade(SCARP_QUINTIC, p.t.x);
    ScarpFade fy = scarp_fade(SCARP_QUINTIC, p.t.y);
    ScarpPair2 q = scarp_product2(o.waves, t.value);
    float waves = scarp_add(scarp_mul(q.x, p.t.x), scarp_mul(q.y, p.t.y));
    float waves_y = scarp_sub(waves, q.y);
    ScarpPair2 c00 = scarp_corner_wave(scarp_hash2(l.key, p.cell.x, p.cell.y), waves);
    ScarpPair2 c10 = scarp_corner_wave(scarp_hash2(l.key, p.next.x, p.cell.y), scarp_sub(waves,
            q.x));
    ScarpPair2 c01 = scarp_corner_wave(scarp_hash2(l.key, p.cell.x, p.next.y), waves_y);
    ScarpPair2 c11 = scarp_corner_wave(scarp_hash2(l.key, p.next.x, p.next.y), scarp_sub(waves_y,
            q.x));
    ScarpPair2 left = scarp_mix2(c00, c01, fy.u);
    ScarpPair2 right = scarp_mix2(c10, c11, fy.u);
    ScarpPair2 z = scarp_mix2(left, right, fx.u);
    ScarpPair2 top = scarp_mix2(c01, c11, fx.u);
    ScarpPair2 by_x = scarp_scaled2(fx.du, scarp_difference2(right, left));
    ScarpPair2 by_y = scarp_scaled2(fy.du, scarp_mix2(scarp_difference2(c01, c00),
            scarp_difference2(c11, c10), fx.u));
    /* the sums of W (p - c) */
    ScarpPair2 moment_x = scarp_difference2(scarp_scaled2(p.t.x, z), scarp_scaled2(fx.u, right));
    ScarpPair2 moment_y = scarp_difference2(scarp_scaled2(p.t.y, z), scarp_scaled2(fy.u, top));
    /* in the axes of the input */
    ScarpPair2 mx = scarp_combined2(o.angles.x, moment_x, o.angles.y, moment_y);
    ScarpPair2 my = scarp_combined2(o.angles.x, moment_y, scarp_sub(0.0f, o.angles.y), moment_x);
    ScarpPair2 wx = scarp_combined2(o.cells.x, by_x, o.cells.y, by_y);
    ScarpPair2 wy = scarp_combined2(o.cells.x, by_y, scarp_sub(0.0f, o.cells.y), by_x);
    ScarpPairJet blend = ScarpPairJet(z, scarp_blend_slope(wx, scarp_mul(o.stretch, t.value.x),
            t.dx, z, mx, my), scarp_blend_slope(wy, scarp_mul(o.stretch, t.value.y), t.dy, z, mx,
            my));
    return blend;
}

/* The derivative d of a blend, once this is divided by its length: `w` is the quotient. */
ScarpPair2 scarp_quotient_slope(ScarpPair2 w, ScarpPair2 d, float unit)
{
    ScarpPair2 e = scarp_scaled2(unit, d);
    return scarp_difference2(e, scarp_scaled2(scarp_dot2(w, e), w));
}

ScarpPairJet scarp_normalised(ScarpPairJet z)
{
    float unit = scarp_inverse(scarp_root(scarp_add(scarp_dot2(z.value, z.value),
            SCARP_GULLY_EPS2)));
    ScarpPair2 w = scarp_scaled2(unit, z.value);
    ScarpPairJet n = ScarpPairJet(w, scarp_quotient_slope(w, z.dx, unit), scarp_quotient_slope(w,
            z.dy, unit));
    return n;
}

/* The profile of a stripe, P(C). */
ScarpJet scarp_profile_of(ScarpGullyShape g, ScarpPairJet w)
{
    float r = scarp_root(scarp_add(scarp_mul(scarp_sub(1.0f, w.value.x), 0.5f), g.round2));
    float by = scarp_mul(scarp_mul(0.25f, g.fall), scarp_inverse(r));
    ScarpJet p = ScarpJet(scarp_sub(1.0f, scarp_mul(scarp_sub(r, g.round), g.fall)),
            ScarpPair2(scarp_mul(by, w.dx.x), scarp_mul(by, w.dy.x)));
    return p;
}

/* Adds an octave at a point of its lattice. */
ScarpGully scarp_gully_octave_at(ScarpGullyShape g, ScarpGullyOctave o, ScarpLattice l,
        ScarpLocation p, ScarpGully state)
{
    ScarpPairJet t = scarp_across_slope(state.slope);
    ScarpPairJet w = scarp_normalised(scarp_blend_of(l, o, p, t));
    ScarpJet height = scarp_profile_of(g, w);
    ScarpJet v = state.exposure;
    float kept = scarp_mul(o.keep, v.value);
    float rest = scarp_sub(1.0f, scarp_mul(kept, v.value));
    float m = scarp_mul(state.steep.value, rest);
    float fall = scarp_mul(scarp_mul(2.0f, state.steep.value), kept);
    ScarpPair2 dm = scarp_combined2(rest, state.steep.d, scarp_sub(0.0f, fall), v.d);
    float d = scarp_sub(height.value, v.value);
    ScarpJet next = ScarpJet(scarp_add(v.value, scarp_mul(m, d)), scarp_sum2(v.d, scarp_combined2(d,
            dm, m, scarp_difference2(height.d, v.d))));
    float by = scarp_sub(0.0f, scarp_mul(scarp_mul(g.branch, m), w.value.y));
    float by_x = scarp_sub(0.0f, scarp_mul(g.branch, scarp_add(scarp_mul(dm.x, w.value.y),
            scarp_mul(m, w.dx.y))));
    float by_y = scarp_sub(0.0f, scarp_mul(g.branch, scarp_add(scarp_mul(dm.y, w.value.y),
            scarp_mul(m, w.dy.y))));
    ScarpGully after = ScarpGully(ScarpPairJet(scarp_sum2(state.slope.value, scarp_scaled2(by,
            t.value)), scarp_sum2(state.slope.dx, scarp_combined2(by_x, t.value, by, t.dx)),
            scarp_sum2(state.slope.dy, scarp_combined2(by_y, t.value, by, t.dy))), state.steep,
            next, ScarpJet(scarp_add(state.sum.value, scarp_mul(o.weight, next.value)),
            scarp_sum2(state.sum.d, scarp_scaled2(o.weight, next.d))));
    return after;
}

/* Steps of recipes, which scarp_recipe_shader calls. */

/* The place of a noise: m x + t, of rows that have t as their last element. */
vec3 scarp_placed(vec3 x, vec4 a, vec4 b, vec4 c, int dimensions)
{
    ScarpRows m = scarp_rows_of(scarp_vec3_of(a.x, a.y, a.z), scarp_vec3_of(b.x, b.y, b.z),
            scarp_vec3_of(c.x, c.y, c.z));
    return scarp_add3(scarp_times(m, x, dimensions), scarp_vec3_of(a.w, b.w, c.w));
}

/* The rows m of a place, with the gradients of what displaces it. */
ScarpRows scarp_jacobian_with(vec4 a, vec4 b, vec4 c, ScarpDisplaced rest)
{
    return scarp_rows_of(scarp_add3(scarp_vec3_of(a.x, a.y, a.z), rest.x.gradient),
            scarp_add3(scarp_vec3_of(b.x, b.y, b.z), rest.y.gradient), scarp_add3(scarp_vec3_of(c.x,
            c.y, c.z), rest.z.gradient));
}

/* j_a (h j_b), and what the curvature of u adds along the gradient: over the axes of u. */
float scarp_pulled_second(vec3 ja, vec3 jb, ScarpRows h, vec3 bends, int dimensions)
{
    float sum = scarp_add(scarp_mul(ja.x, scarp_mul(h.x.x, jb.x)), scarp_mul(ja.x, scarp_mul(h.x.y,
            jb.y)));
    if (dimensions == 3) {
        sum = scarp_add(sum, scarp_mul(ja.x, scarp_mul(h.x.z, jb.z)));
    }
    sum = scarp_add(sum, bends.x);
    sum = scarp_add(sum, scarp_mul(ja.y, scarp_mul(h.y.x, jb.x)));
    sum = scarp_add(sum, scarp_mul(ja.y, scarp_mul(h.y.y, jb.y)));
    if (dimensions == 3) {
        sum = scarp_add(sum, scarp_mul(ja.y, scarp_mul(h.y.z, jb.z)));
    }
    sum = scarp_add(sum, bends.y);
    if (dimensions == 3) {
        sum = scarp_add(sum, scarp_mul(ja.z, scarp_mul(h.z.x, jb.x)));
        sum = scarp_add(sum, scarp_mul(ja.z, scarp_mul(h.z.y, jb.y)));
        sum = scarp_add(sum, scarp_mul(ja.z, scarp_mul(h.z.z, jb.z)));
        sum = scarp_add(sum, bends.z);
    }
    return sum;
}

vec3 scarp_times_each(vec3 a, vec3 b)
{
    return scarp_vec3_of(scarp_mul(a.x, b.x), scarp_mul(a.y, b.y), scarp_mul(a.z, b.z));
}

/* A sample with derivatives with respect to u, of so many dimensions, becomes one with derivatives
   with respect to x: j are the gradients of u with respect to x, `rest` what displaces u. */
ScarpSample scarp_pulled(ScarpSample s, ScarpRows j, ScarpDisplaced rest, int dimensions)
{
    ScarpRows h = scarp_hessian_of(s);
    ScarpRows by = scarp_transposed(j);
    vec3 g = s.gradient;
    ScarpDisplaced r = rest;
    vec3 xx = scarp_vec3_of(r.x.diagonal.x, r.y.diagonal.x, r.z.diagonal.x);
    vec3 yy = scarp_vec3_of(r.x.diagonal.y, r.y.diagonal.y, r.z.diagonal.y);
    vec3 zz = scarp_vec3_of(r.x.diagonal.z, r.y.diagonal.z, r.z.diagonal.z);
    vec3 xy = scarp_vec3_of(r.x.mixed.x, r.y.mixed.x, r.z.mixed.x);
    vec3 xz = scarp_vec3_of(r.x.mixed.y, r.y.mixed.y, r.z.mixed.y);
    vec3 yz = scarp_vec3_of(r.x.mixed.z, r.y.mixed.z, r.z.mixed.z);
    return scarp_sample_of(s.value, scarp_times(by, g, dimensions),
            scarp_vec3_of(scarp_pulled_second(by.x, by.x, h, scarp_times_each(g, xx), dimensions),
            scarp_pulled_second(by.y, by.y, h, scarp_times_each(g, yy), dimensions),
            scarp_pulled_second(by.z, by.z, h, scarp_times_each(g, zz), dimensions)),
            scarp_vec3_of(scarp_pulled_second(by.x, by.y, h, scarp_times_each(g, xy), dimensions),
            scarp_pulled_second(by.x, by.z, h, scarp_times_each(g, xz), dimensions),
            scarp_pulled_second(by.y, by.z, h, scarp_times_each(g, yz), dimensions)));
}

/* A coordinate u of a place: its row of m, and what displaces it. */
ScarpSample scarp_coordinate_of(float u, vec4 row, ScarpSample rest)
{
    ScarpSample s = rest;
    s.value = u;
    s.gradient = scarp_add3(scarp_vec3_of(row.x, row.y, row.z), rest.gradient);
    return s;
}

/* Whether a mask is a number, 0 or 1, with all derivatives up to an order. */
bool scarp_is_level(ScarpSample mask, float number, int order, int dimensions)
{
    vec3 g = mask.gradient;
    vec3 d = mask.diagonal;
    vec3 m = mask.mixed;
    bool is_plane = dimensions == 2;
    bool is_flat = g.x == 0.0f && g.y == 0.0f && (is_plane || g.z == 0.0f);
    bool is_straight = d.x == 0.0f && m.x == 0.0f && d.y == 0.0f;
    bool is_straight_up = is_plane || (m.y == 0.0f && m.z == 0.0f && d.z == 0.0f);
    return mask.value == number && (order < 1 || is_flat) && (order < 2 || (is_straight
            && is_straight_up));
}

/* Components of a warp at y become such at x. */
ScarpDisplaced scarp_composed_each(ScarpDisplaced d, ScarpDisplaced y, int dimensions)
{
    ScarpDisplaced r = d;
    r.x = scarp_composed(d.x, y, dimensions);
    r.y = scarp_composed(d.y, y, dimensions);
    if (dimensions == 3) {
        r.z = scarp_composed(d.z, y, dimensions);
    }
    return r;
}

/* What cells say: 0 the number of the cell, 1 and 2 the distance to the nearest feature and to the
   second. */
ScarpSample scarp_cell_sample(ScarpCells c, int what)
{
    ScarpSample s = scarp_constant(scarp_mul(scarp_lattice_value(c.id), 4.65661287e-10f));
    if (what == 1) {
        s.value = c.f1;
        s.gradient = c.d1;
    }
    if (what == 2) {
        s.value = c.f2;
        s.gradient = c.d2;
    }
    return s;
}

/* The constants of gullies: a is low, steepness, slope2, slope2_low; b is lowered, round, round2,
   fall; c is branch, and what brings the base to units of the call, value, gradient, Hessian. */
ScarpGullyShape scarp_gully_shape_of(vec4 a, vec4 b, vec4 c)
{
    ScarpGullyShape g = ScarpGullyShape(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, c.x);
    return g;
}

ScarpGully scarp_gully_first(ScarpGullyShape g, vec4 c, ScarpSample base)
{
    ScarpGullyBase b = ScarpGullyBase(scarp_mul(base.value, c.y), scarp_mul(base.gradient.x, c.z),
            scarp_mul(base.gradient.y, c.z), scarp_mul(base.diagonal.x, c.w),
            scarp_mul(base.mixed.x, c.w), scarp_mul(base.diagonal.y, c.w));
    return scarp_gully_begin(g, b);
}

/* Octaves of gullies keep their own constants where noise has others: keep, stretch, and the pairs
   of waves, angles and cells. */
ScarpGully scarp_gully_with(ScarpGully state, ScarpGullyShape g, ScarpOctave o, ScarpLevel l,
        bool turned, vec3 x)
{
    ScarpGullyOctave own;
    own.weight = o.weight;
    own.keep = o.turn.x;
    own.stretch = o.turn.y;
    own.waves = scarp_pair_of(o.turn.z, o.turn.w);
    own.angles = scarp_pair_of(o.gradient_x.x, o.gradient_x.y);
    own.cells = scarp_pair_of(o.gradient_y.x, o.gradient_y.y);
    ScarpLocation p = scarp_location_of(o, SCARP_GRADIENT, turned, x, 2);
    return scarp_gully_octave_at(g, own, scarp_lattice_of(o, l), p, state);
}

/* What gullies add to the base; a and b bring value and gradient back to its units. */
ScarpSample scarp_gully_displacement(ScarpGully state, float a, float b)
{
    ScarpSample s = scarp_constant(scarp_mul(a, state.sum.value));
    s.gradient = scarp_vec3_of(scarp_mul(b, state.sum.d.x), scarp_mul(b, state.sum.d.y), 0.0f);
    return s;
}
#endif
