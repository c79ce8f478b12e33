// SPDX-License-Identifier: MIT
//
// scarp's noise for WGSL. Generated from src/gpu; do not edit.
//
// Put this text before or after yours, which declares the plans, as many as it has:
//
//     @group(0) @binding(0) var<uniform> scarp_plan: array<ScarpPlan, 1>;
//     ...
//     let n = scarp_sample2(0u, x, y);  // of scarp_plan[0]: n.value, n.gradient.xy
//
// There are scarp_sample3, scarp_cells2 and 3 (of a cellular basis), scarp_curl2, and the chain rule,
// scarp_chain_multiply and the like; scarp_vector2 and 3 and scarp_curl3 read plans of
// scarp_gpu_vector_plan_make.
//
// scarp_gpu_plan_make (scarp.h) makes the bytes of a plan, and says what is promised. What a shader does
// not use of a sample costs nothing. Constants of the pipeline: scarp_only_basis,
// scarp_only_fractal, scarp_only_depth fix what all plans have in common, for smaller and faster
// shaders: an enumerator of scarp.h, and how many warps there are. WGSL lets compilers fuse
// operations, from which scarp_zero keeps them: without " ^ scarp_zero()" the text compiles
// faster, and gives the equal bits up.

override scarp_only_basis: u32 = 0xffffffffu;
override scarp_only_fractal: u32 = 0xffffffffu;
override scarp_only_depth: u32 = 0xffffffffu;

/* The constants of octaves, and of what they are octaves of. */

/* turn: with a phase the cosine and sine of the angle, then of twice that; of bases that take
   places the jitter, the middle and the stretch. */
struct ScarpOctave {
    key: vec3u,
    frequency: f32,
    weight: f32,
    amplitude: f32,
    slope: f32,
    curvature: f32,
    last: vec3u,
    share: f32,
    turn: vec4f,
    jacobian_x: vec3f,
    offset_x: f32,
    jacobian_y: vec3f,
    offset_y: f32,
    jacobian_z: vec3f,
    offset_z: f32,
    gradient_x: vec3f,
    inverse: f32,
    gradient_y: vec3f,
    reach: f32,
    gradient_z: vec3f,
    spare: f32,
}

/* component: 0 here; octaves_at() sets it to that of vector noise whose components share a lattice.
 */
struct ScarpLevel {
    basis: u32,
    fade: u32,
    fractal: u32,
    octaves: u32,
    rotate: u32,
    flows: u32,
    first: u32,
    component: u32,
    erosion: f32,
    sharpness: f32,
    inverse_weight: f32,
    spare1: f32,
}

/* The constants of a noise, as scarp_gpu_plan_make gives them. */

struct ScarpPlan {
    depth: u32,
    dimensions: u32,
    zero: u32,
    unit: f32,
    level: array<ScarpLevel, 5>,
    octave: array<ScarpOctave, 32>,
}

/* Numbers of bases, fades and fractals. */

const SCARP_GRADIENT: u32 = 0u;
const SCARP_VALUE: u32 = 1u;
const SCARP_SIMPLEX: u32 = 2u;
const SCARP_CELL_F1: u32 = 3u;
const SCARP_CELL_F2: u32 = 4u;
const SCARP_CELL_EDGE: u32 = 5u;
const SCARP_CELL_SOFT: u32 = 6u;
const SCARP_CELL_VALUE: u32 = 7u;

const SCARP_QUINTIC: u32 = 0u;
const SCARP_CUBIC: u32 = 1u;

const SCARP_FBM: u32 = 0u;
const SCARP_TURBULENCE: u32 = 1u;
const SCARP_RIDGED: u32 = 2u;
const SCARP_EROSION: u32 = 3u;
const SCARP_PINGPONG: u32 = 4u;
const SCARP_HYBRID: u32 = 5u;
const SCARP_SWISS: u32 = 6u;
const SCARP_JORDAN: u32 = 7u;
// 0, which compilers do not know
fn scarp_zero() -> u32 {
    return scarp_plan[0].zero;
}

fn scarp_only(fixed: u32, planned: u32) -> u32 {
    return select(fixed, planned, fixed == 0xffffffffu);
}

fn scarp_only_basis_of(basis: u32) -> u32 {
    return scarp_only(scarp_only_basis, basis);
}

fn scarp_only_fractal_of(fractal: u32) -> u32 {
    return scarp_only(scarp_only_fractal, fractal);
}

fn scarp_only_depth_of(depth: u32) -> u32 {
    return scarp_only(scarp_only_depth, depth);
}

// A result goes through an exclusive or with a number that the compiler does not know: 0.
fn scarp_add(a: f32, b: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a + b) ^ scarp_zero());
}

fn scarp_sub(a: f32, b: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a - b) ^ scarp_zero());
}

fn scarp_mul(a: f32, b: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a * b) ^ scarp_zero());
}

fn scarp_rough_inverse(a: f32) -> f32 {
    return 1.0f / a;
}

/* Signs of floats. */

const SCARP_SIGN: u32 = 0x80000000u;

/* Whether the sign bit is set. */
fn scarp_is_negative(a: f32) -> bool {
    return bitcast<u32>(a) >= SCARP_SIGN;
}

/* -a where `bit` is 1, a where it is 0. */
fn scarp_with_bit(a: f32, bit: u32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a) ^ (bit << 31u));
}

/* sign(n) a, and 0 where n is 0. */
fn scarp_with_sign(a: f32, n: f32) -> f32 {
    return select(scarp_with_bit(a, bitcast<u32>(n) >> 31u), 0.0f, n == 0.0f);
}

/* The operations that shading languages only approximate, and others of numbers. */

fn scarp_magnitude(a: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(a) & 0x7fffffffu);
}

/* One of two numbers. */
fn scarp_either(condition: bool, yes: f32, no: f32) -> f32 {
    return select(no, yes, condition);
}

/* The hash as a signed number, rounded to float, in two parts: only the addition rounds. */
fn scarp_lattice_value(hash: u32) -> f32 {
    return scarp_add(scarp_mul(f32(bitcast<i32>(hash) >> 16u), 65536.0f), f32(hash & 0xffffu));
}

/*
 * 1 / x, rounded to nearest, of positive x; 0 of 2^126 and more. With x = m 2^(e - 150), the result
 * is q 2^(103 - e), q being 2^47 / m, rounded. The estimate's q may be off by a few; the remainder
 * 2^47 - q m is small, so the low 32 bits of both numbers give it.
 */
fn scarp_inverse(x: f32) -> f32 {
    let bits: u32 = bitcast<u32>(x);
    let m: u32 = (bits & 0x7fffffu) | 0x800000u;
    let e: u32 = (bits >> 23u) & 255u;
    let estimate: f32 = scarp_rough_inverse(bitcast<f32>(0x3f800000u | (bits & 0x7fffffu)));
    var q: u32 = bitcast<u32>(i32(scarp_mul(estimate, 16777216.0f)));
    var r: i32 = bitcast<i32>(0u - q * m);
    for (var i: i32 = 0; i < 16 && (r < 0 || r >= bitcast<i32>(m)); i++) {
        q = select(q + 1u, q - 1u, r < 0);
        r = bitcast<i32>(0u - q * m);
    }
    q = select(q, q + 1u, 2 * r > bitcast<i32>(m));
    let rounded: f32 = bitcast<f32>(((252u - e) << 23u) + q);
    return select(rounded, 0.0f, e > 252u);
}

/*
 * The root of x, rounded to nearest, of normal x and 0. With x = m 2^(e - 150) and m doubled where
 * e is even, q is the root of 2^23 m, rounded.
 */
fn scarp_root(x: f32) -> f32 {
    let bits: u32 = bitcast<u32>(x);
    let e: u32 = bits >> 23u;
    let even: u32 = 1u - (e & 1u);
    let m: u32 = ((bits & 0x7fffffu) | 0x800000u) << even;
    let estimate: f32 = sqrt(bitcast<f32>((bits & 0x7fffffu) + ((127u + even) << 23u)));
    var q: u32 = bitcast<u32>(i32(scarp_mul(estimate, 8388608.0f)));
    var r: i32 = bitcast<i32>((m << 23u) - q * q);
    for (var i: i32 = 0; i < 16 && (r < 0 || r > bitcast<i32>(2u * q)); i++) {
        q = select(q + 1u, q - 1u, r < 0);
        r = bitcast<i32>((m << 23u) - q * q);
    }
    q = select(q, q + 1u, r > bitcast<i32>(q));
    let rounded: f32 = bitcast<f32>((((e + 127u) >> 1u) << 23u) + (q - 0x800000u));
    return select(rounded, 0.0f, e == 0u);
}

/*
 * a / b, rounded to nearest, of b that is neither 0 nor below 2^-126; 0 where that is below 2^-126.
 * With mantissas m of a and n of b, the quotient's is q: 2^23 m / n, or 2^24 m / n where m is less
 * than n, rounded.
 */
fn scarp_quotient(a: f32, b: f32) -> f32 {
    let m: u32 = (bitcast<u32>(a) & 0x7fffffu) | 0x800000u;
    let n: u32 = (bitcast<u32>(b) & 0x7fffffu) | 0x800000u;
    let less: u32 = select(0u, 1u, m < n);
    let of_a: i32 = bitcast<i32>((bitcast<u32>(a) >> 23u) & 255u);
    let of_b: i32 = bitcast<i32>((bitcast<u32>(b) >> 23u) & 255u);
    let e: i32 = of_a - of_b + 126 - bitcast<i32>(less);
    let left: f32 = bitcast<f32>(0x3f800000u | (m & 0x7fffffu));
    let estimate: f32 = scarp_mul(left, scarp_rough_inverse(bitcast<f32>(0x3f800000u | (n
            & 0x7fffffu))));
    var q: u32 = bitcast<u32>(i32(scarp_mul(estimate, scarp_either(m < n, 16777216.0f,
            8388608.0f))));
    var r: i32 = bitcast<i32>((m << (23u + less)) - q * n);
    for (var i: i32 = 0; i < 16 && (r < 0 || r >= bitcast<i32>(n)); i++) {
        q = select(q + 1u, q - 1u, r < 0);
        r = bitcast<i32>((m << (23u + less)) - q * n);
    }
    q = select(q, q + 1u, 2 * r > bitcast<i32>(n));
    let size: u32 = (bitcast<u32>(e) << 23u) + q;
    let sign: u32 = (bitcast<u32>(a) ^ bitcast<u32>(b)) & SCARP_SIGN;
    return select(bitcast<f32>(size | sign), 0.0f, of_a == 0 || e < 0);
}

/* The directions of gradients, computed, since memory is slower. */

/* The cosine of 11.25 degrees times 1, 3, 5, 7. */
fn scarp_cosine(i: u32) -> f32 {
    let first: f32 = select(0.831469612f, 0.980785280f, i == 0u);
    let second: f32 = select(0.195090322f, 0.555570233f, i == 2u);
    return select(second, first, i < 2u);
}

/* One of the 16 directions of the plane. */
fn scarp_direction2(i: u32) -> vec3f {
    let k: u32 = (i >> 1u) & 3u;
    return vec3f(scarp_with_bit(scarp_cosine(k), (i >> 3u) & 1u),
            scarp_with_bit(scarp_cosine(3u - k), i & 1u), 0.0f);
}

/* One of the 12 edges of a cube, twice as long: 0 along z, y or x. */
fn scarp_direction3(i: u32) -> vec3f {
    let axes: u32 = i >> 2u;
    let first: f32 = scarp_with_bit(2.0f, (i >> 1u) & 1u);
    let second: f32 = scarp_with_bit(2.0f, i & 1u);
    return vec3f(select(first, 0.0f, axes == 2u), select(select(first, 0.0f, axes == 1u), second,
            axes == 0u), select(second, 0.0f, axes == 0u));
}

/* A component of an edge after a quarter of a turn, times sqrt(3) / 2: 1, 2, -1 or -2, of which
   `axis` has two bits for each edge. */
fn scarp_quarter_along(axis: u32, i: u32) -> f32 {
    let bits: u32 = axis >> (2u * i);
    return scarp_with_bit(select(1.0f, 2.0f, (bits & 2u) != 0u), bits & 1u);
}

const SCARP_QUARTERS_X: u32 = 0xbe0550u;
const SCARP_QUARTERS_Y: u32 = 0x50be11u;
const SCARP_QUARTERS_Z: u32 = 0x1144beu;
const SCARP_TWO_OVER_ROOT_3: f32 = 1.15470054f;

/* An edge after a quarter of a turn. */
fn scarp_quarter3(i: u32) -> vec3f {
    return vec3f(scarp_mul(SCARP_TWO_OVER_ROOT_3, scarp_quarter_along(SCARP_QUARTERS_X, i)),
            scarp_mul(SCARP_TWO_OVER_ROOT_3, scarp_quarter_along(SCARP_QUARTERS_Y, i)),
            scarp_mul(SCARP_TWO_OVER_ROOT_3, scarp_quarter_along(SCARP_QUARTERS_Z, i)));
}

/* Vectors, and noise at a point. */

fn scarp_add3(a: vec3f, b: vec3f) -> vec3f {
    return vec3f(scarp_add(a.x, b.x), scarp_add(a.y, b.y), scarp_add(a.z, b.z));
}

fn scarp_sub3(a: vec3f, b: vec3f) -> vec3f {
    return vec3f(scarp_sub(a.x, b.x), scarp_sub(a.y, b.y), scarp_sub(a.z, b.z));
}

fn scarp_mul3(a: f32, b: vec3f) -> vec3f {
    return vec3f(scarp_mul(a, b.x), scarp_mul(a, b.y), scarp_mul(a, b.z));
}

/* Noise at a point. diagonal: the derivatives xx, yy, zz; mixed: xy, xz, yz. In 2D outputs along z
   mean nothing. */
struct ScarpSample {
    value: f32,
    gradient: vec3f,
    diagonal: vec3f,
    mixed: vec3f,
}

fn scarp_sample_of(value: f32, gradient: vec3f, diagonal: vec3f, mixed: vec3f) -> ScarpSample {
    let s: ScarpSample = ScarpSample(value, gradient, diagonal, mixed);
    return s;
}

fn scarp_constant(value: f32) -> ScarpSample {
    let none: vec3f = vec3f(0.0f, 0.0f, 0.0f);
    return scarp_sample_of(value, none, none, none);
}

fn scarp_sum_of(a: ScarpSample, b: ScarpSample) -> ScarpSample {
    return scarp_sample_of(scarp_add(a.value, b.value), scarp_add3(a.gradient, b.gradient),
            scarp_add3(a.diagonal, b.diagonal), scarp_add3(a.mixed, b.mixed));
}

fn scarp_difference_of(a: ScarpSample, b: ScarpSample) -> ScarpSample {
    return scarp_sample_of(scarp_sub(a.value, b.value), scarp_sub3(a.gradient, b.gradient),
            scarp_sub3(a.diagonal, b.diagonal), scarp_sub3(a.mixed, b.mixed));
}

/* What the lattice draws at its points, and its cells. */

const SCARP_HASH_X: u32 = 0x1a2012f5u;
const SCARP_HASH_Y: u32 = 0x14e84743u;
const SCARP_HASH_Z: u32 = 0xec1d7da1u;
const SCARP_HASH_K: u32 = 0x9e3779b9u;

fn scarp_hash_axis(i: u32, multiplier: u32, key: u32) -> u32 {
    let h: u32 = i * multiplier + key;
    return (h >> 8u) | (h << 24u);
}

fn scarp_hash2(key: vec3u, x: u32, y: u32) -> u32 {
    let h: u32 = scarp_hash_axis(x, SCARP_HASH_X, key.x) ^ scarp_hash_axis(y, SCARP_HASH_Y, key.y);
    return h * (h + SCARP_HASH_K);
}

fn scarp_joined3(key: vec3u, x: u32, y: u32, z: u32) -> u32 {
    return scarp_hash_axis(x, SCARP_HASH_X, key.x) ^ scarp_hash_axis(y, SCARP_HASH_Y, key.y)
            ^ scarp_hash_axis(z, SCARP_HASH_Z, key.z);
}

fn scarp_hash3(key: vec3u, x: u32, y: u32, z: u32) -> u32 {
    let h: u32 = scarp_joined3(key, x, y, z);
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
const SCARP_HASH_VALUES_1: u32 = 0x9e3779b1u;
const SCARP_HASH_VALUES_2: u32 = 0x85ebca6bu;

fn scarp_component_hash2(hash: u32, component: u32) -> u32 {
    return hash << (4u * component);
}

fn scarp_component_hash3(hash: u32, component: u32) -> u32 {
    let twelves: u32 = select(select(144u, 12u, component == 1u), 1u, component == 0u);
    return ((hash >> 16u) * twelves) << 16u;
}

fn scarp_component_hash_values(hash: u32, component: u32) -> u32 {
    let turned: u32 = (hash >> 16u) | (hash << 16u);
    let product: u32 = turned * select(SCARP_HASH_VALUES_2, SCARP_HASH_VALUES_1, component == 1u);
    return select(product, hash, component == 0u);
}

/* The cells after and before one along an axis, within the period whose last cell is `last`. */
fn scarp_cell_after(last: u32, cell: u32) -> u32 {
    return select(cell + 1u, 0u, cell == last);
}

fn scarp_cell_before(last: u32, cell: u32) -> u32 {
    return select(cell - 1u, last, cell == 0u);
}

/* The cell that is `steps` further, -2 to 2. */
fn scarp_cell_beside(last: u32, cell: u32, steps: i32) -> u32 {
    var c: u32 = cell;
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
    cell: vec3u,
    next: vec3u,
    t: vec3f,
}

/* The lattice of an octave. */
struct ScarpLattice {
    key: vec3u, /* of the hash */
    last: vec3u, /* the last cell of the period along each axis; 2^32 - 1 without period */
    flows: bool, /* whether gradients are turned */
    turn: vec4f, /* how far: the cosine and sine of an angle, then of twice that */
    jitter: f32, /* how far features of cellular noise stray, in units of 2^-32 cells */
    middle: f32, /* what is subtracted from distances */
    component: u32, /* which component of vector noise; 0 of noise that has one */
}

/* Bases that interpolate between lattice points. */

/* A fade with its derivatives. */
struct ScarpFade {
    u: f32,
    du: f32,
    ddu: f32,
}

/*
 * quintic: u = 6t^5 - 15t^4 + 10t^3   u' = 30 t^2 (t-1)^2   u'' = 60 t (t-1) (2t-1)
 * cubic:   u = 3t^2 - 2t^3            u' = 6 t (1-t)        u'' = 6 - 12t
 *
 * The quintic is evaluated as t^3 ((t-1) (6t-9) + 1), where nothing cancels. Over all floats in [0,
 * 1] that errs by at most 1.94e-7, never exceeds 1 + 2^-23, and is exact at 0 and 1. The usual
 * form, t^3 (t (6t-15) + 10), takes as many operations and errs by 1.1e-6.
 */
fn scarp_fade(kind: u32, t: f32) -> ScarpFade {
    let s: f32 = scarp_sub(t, 1.0f);
    let ts: f32 = scarp_mul(t, s);
    var f: ScarpFade;
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

fn scarp_mix(a: f32, b: f32, u: f32) -> f32 {
    return scarp_add(a, scarp_mul(u, scarp_sub(b, a)));
}

/* a x + b */
struct ScarpLine {
    a: f32,
    b: f32,
}

/* What a lattice column contributes. */
struct ScarpColumn {
    value: ScarpLine,
    y: ScarpLine,
    z: ScarpLine,
    yy: ScarpLine,
    yz: ScarpLine,
    zz: ScarpLine,
}

/* `is_flat`: nothing depends on x, all a are 0. */
fn scarp_at(l: ScarpLine, x: f32, is_flat: bool) -> f32 {
    return select(scarp_add(scarp_mul(l.a, x), l.b), l.b, is_flat);
}

/* The value and its derivatives along x, from the lines of both columns. */
fn scarp_across(l: ScarpLine, r: ScarpLine, x: f32, f: ScarpFade, is_flat: bool) -> f32 {
    return scarp_mix(scarp_at(l, x, is_flat), scarp_at(r, scarp_sub(x, 1.0f), is_flat), f.u);
}

fn scarp_across_dx(l: ScarpLine, r: ScarpLine, x: f32, f: ScarpFade, is_flat: bool) -> f32 {
    let step: f32 = scarp_mul(f.du, scarp_sub(scarp_at(r, scarp_sub(x, 1.0f), is_flat), scarp_at(l,
            x, is_flat)));
    return select(scarp_add(scarp_mix(l.a, r.a, f.u), step), step, is_flat);
}

fn scarp_across_dxx(l: ScarpLine, r: ScarpLine, x: f32, f: ScarpFade, is_flat: bool) -> f32 {
    let bend: f32 = scarp_mul(f.ddu, scarp_sub(scarp_at(r, scarp_sub(x, 1.0f), is_flat), scarp_at(l,
            x, is_flat)));
    return select(scarp_add(scarp_mul(scarp_mul(2.0f, f.du), scarp_sub(r.a, l.a)), bend), bend,
            is_flat);
}

fn scarp_join(l: ScarpColumn, r: ScarpColumn, x: f32, f: ScarpFade, is_flat: bool) -> ScarpSample {
    let s: ScarpSample = ScarpSample(scarp_across(l.value, r.value, x, f, is_flat),
            vec3f(scarp_across_dx(l.value, r.value, x, f, is_flat), scarp_across(l.y, r.y, x, f,
            is_flat), scarp_across(l.z, r.z, x, f, is_flat)), vec3f(scarp_across_dxx(l.value,
            r.value, x, f, is_flat), scarp_across(l.yy, r.yy, x, f, is_flat), scarp_across(l.zz,
            r.zz, x, f, is_flat)), vec3f(scarp_across_dx(l.y, r.y, x, f, is_flat),
            scarp_across_dx(l.z, r.z, x, f, is_flat), scarp_across(l.yz, r.yz, x, f, is_flat)));
    return s;
}

/* Gradient noise (Perlin 1985, 2002). */

/* The number of the direction that a hash draws. In 3D the upper half of the hash, times 12,
   chooses: any two are drawn equally often within 1 in 5461, so that the noise is the same along
   all axes. */
fn scarp_direction_index2(hash: u32) -> u32 {
    return hash >> 28u;
}

fn scarp_direction_index3(hash: u32) -> u32 {
    return ((hash >> 16u) * 12u) >> 16u;
}

/* A direction of noise that flows: some make two turns per turn of the phase, in 2D backwards. */
fn scarp_turned2(drawn: u32, turn: vec4f) -> vec3f {
    let is_opposite: bool = drawn >= 8u;
    let i: u32 = select(drawn, drawn ^ 9u, is_opposite);
    let is_quick: bool = ((i ^ (i >> 1u) ^ (i >> 3u)) & 1u) != 0u;
    let g: vec3f = scarp_direction2(i);
    let c: f32 = scarp_either(is_quick, turn.z, turn.x);
    let s: f32 = scarp_either(is_quick, -turn.w, turn.y);
    let x: f32 = scarp_sub(scarp_mul(c, g.x), scarp_mul(s, g.y));
    let y: f32 = scarp_add(scarp_mul(c, g.y), scarp_mul(s, g.x));
    return vec3f(select(x, -x, is_opposite), select(y, -y, is_opposite), 0.0f);
}

fn scarp_turned3(i: u32, turn: vec4f) -> vec3f {
    let is_quick: bool = ((0x93c >> i) & 1) != 0; /* 2, 3, 4, 5, 8 and 11 */
    let c: f32 = scarp_either(is_quick, turn.z, turn.x);
    let s: f32 = scarp_either(is_quick, turn.w, turn.y);
    return scarp_add3(scarp_mul3(c, scarp_direction3(i)), scarp_mul3(s, scarp_quarter3(i)));
}

fn scarp_drawn2(l: ScarpLattice, x: u32, y: u32) -> vec3f {
    let i: u32 = scarp_direction_index2(scarp_component_hash2(scarp_hash2(l.key, x, y),
            l.component));
    var g: vec3f = scarp_direction2(i);
    if (l.flows) {
        g = scarp_turned2(i, l.turn);
    }
    return g;
}

fn scarp_drawn3(l: ScarpLattice, x: u32, y: u32, z: u32) -> vec3f {
    let i: u32 = scarp_direction_index3(scarp_component_hash3(scarp_hash3(l.key, x, y, z),
            l.component));
    var g: vec3f = scarp_direction3(i);
    if (l.flows) {
        g = scarp_turned3(i, l.turn);
    }
    return g;
}

/* Column x of the cell: v is the fade along y. */
fn scarp_gradient_column2(l: ScarpLattice, x: u32, p: ScarpLocation, v: ScarpFade) -> ScarpColumn {
    let g0: vec3f = scarp_drawn2(l, x, p.cell.y);
    let g1: vec3f = scarp_drawn2(l, x, p.next.y);
    let dgx: f32 = scarp_sub(g1.x, g0.x);
    let dot0: f32 = scarp_mul(g0.y, p.t.y);
    let dot1: f32 = scarp_mul(g1.y, scarp_sub(p.t.y, 1.0f));
    let ddot: f32 = scarp_sub(dot1, dot0);
    let c: ScarpColumn = ScarpColumn(ScarpLine(scarp_add(g0.x, scarp_mul(v.u, dgx)), scarp_add(dot0,
            scarp_mul(v.u, ddot))), ScarpLine(scarp_mul(v.du, dgx), scarp_add(scarp_mix(g0.y, g1.y,
            v.u), scarp_mul(v.du, ddot))), ScarpLine(0.0f, 0.0f), ScarpLine(scarp_mul(v.ddu, dgx),
            scarp_add(scarp_mul(scarp_mul(2.0f, v.du), scarp_sub(g1.y, g0.y)), scarp_mul(v.ddu,
            ddot))), ScarpLine(0.0f, 0.0f), ScarpLine(0.0f, 0.0f));
    return c;
}

/* A lattice edge along z, interpolated over z. */
struct ScarpEdge {
    value: ScarpLine, /* in x */
    z: f32,
    zz: f32, /* first and second z derivative of value.b */
    gy: f32,
    dgy: f32, /* y component of the gradient, and its z derivative */
    dgx: f32, /* difference of the x components of the corners */
}

/* The edge at column x and row y of cells, ty from it along y; w is the fade along z. */
fn scarp_gradient_edge(l: ScarpLattice, x: u32, y: u32, ty: f32, p: ScarpLocation,
        w: ScarpFade) -> ScarpEdge {
    let g0: vec3f = scarp_drawn3(l, x, y, p.cell.z);
    let g1: vec3f = scarp_drawn3(l, x, y, p.next.z);
    let dg: vec3f = scarp_sub3(g1, g0);
    let dot0: f32 = scarp_add(scarp_mul(g0.y, ty), scarp_mul(g0.z, p.t.z));
    let dot1: f32 = scarp_add(scarp_mul(g1.y, ty), scarp_mul(g1.z, scarp_sub(p.t.z, 1.0f)));
    let ddot: f32 = scarp_sub(dot1, dot0);
    let e: ScarpEdge = ScarpEdge(ScarpLine(scarp_add(g0.x, scarp_mul(w.u, dg.x)), scarp_add(dot0,
            scarp_mul(w.u, ddot))), scarp_add(scarp_add(g0.z, scarp_mul(w.u, dg.z)), scarp_mul(w.du,
            ddot)), scarp_add(scarp_mul(scarp_mul(2.0f, w.du), dg.z), scarp_mul(w.ddu, ddot)),
            scarp_add(g0.y, scarp_mul(w.u, dg.y)), scarp_mul(w.du, dg.y), dg.x);
    return e;
}

fn scarp_gradient_column3(l: ScarpLattice, x: u32, p: ScarpLocation, v: ScarpFade,
        w: ScarpFade) -> ScarpColumn {
    let e0: ScarpEdge = scarp_gradient_edge(l, x, p.cell.y, p.t.y, p, w);
    let e1: ScarpEdge = scarp_gradient_edge(l, x, p.next.y, scarp_sub(p.t.y, 1.0f), p, w);
    let da: f32 = scarp_sub(e1.value.a, e0.value.a);
    let db: f32 = scarp_sub(e1.value.b, e0.value.b);
    let dgy: f32 = scarp_sub(e1.gy, e0.gy);
    let dz: f32 = scarp_sub(e1.z, e0.z);
    let ddgx: f32 = scarp_sub(e1.dgx, e0.dgx);
    let dgx: f32 = scarp_add(e0.dgx, scarp_mul(v.u, ddgx)); /* interpolated over y */
    let c: ScarpColumn = ScarpColumn(ScarpLine(scarp_add(e0.value.a, scarp_mul(v.u, da)),
            scarp_add(e0.value.b, scarp_mul(v.u, db))), ScarpLine(scarp_mul(v.du, da),
            scarp_add(scarp_add(e0.gy, scarp_mul(v.u, dgy)), scarp_mul(v.du, db))),
            ScarpLine(scarp_mul(w.du, dgx), scarp_add(e0.z, scarp_mul(v.u, dz))),
            ScarpLine(scarp_mul(v.ddu, da), scarp_add(scarp_mul(scarp_mul(2.0f, v.du), dgy),
            scarp_mul(v.ddu, db))), ScarpLine(scarp_mul(v.du, scarp_mul(w.du, ddgx)),
            scarp_add(scarp_mix(e0.dgy, e1.dgy, v.u), scarp_mul(v.du, dz))),
            ScarpLine(scarp_mul(w.ddu, dgx), scarp_mix(e0.zz, e1.zz, v.u)));
    return c;
}

fn scarp_gradient_at2(l: ScarpLattice, kind: u32, p: ScarpLocation) -> ScarpSample {
    let v: ScarpFade = scarp_fade(kind, p.t.y);
    return scarp_join(scarp_gradient_column2(l, p.cell.x, p, v), scarp_gradient_column2(l, p.next.x,
            p, v), p.t.x, scarp_fade(kind, p.t.x), false);
}

fn scarp_gradient_at3(l: ScarpLattice, kind: u32, p: ScarpLocation) -> ScarpSample {
    let v: ScarpFade = scarp_fade(kind, p.t.y);
    let w: ScarpFade = scarp_fade(kind, p.t.z);
    return scarp_join(scarp_gradient_column3(l, p.cell.x, p, v, w), scarp_gradient_column3(l,
            p.next.x, p, v, w), p.t.x, scarp_fade(kind, p.t.x), false);
}

fn scarp_gradient_at(l: ScarpLattice, kind: u32, p: ScarpLocation, dimensions: i32) -> ScarpSample {
    if (dimensions == 2) {
        return scarp_gradient_at2(l, kind, p);
    }
    return scarp_gradient_at3(l, kind, p);
}

/* Value noise. */

fn scarp_value2(l: ScarpLattice, x: u32, y: u32) -> f32 {
    return scarp_lattice_value(scarp_component_hash_values(scarp_hash2(l.key, x, y), l.component));
}

fn scarp_value3(l: ScarpLattice, x: u32, y: u32, z: u32) -> f32 {
    return scarp_lattice_value(scarp_component_hash_values(scarp_hash3(l.key, x, y, z),
            l.component));
}

fn scarp_value_column2(l: ScarpLattice, x: u32, p: ScarpLocation, v: ScarpFade) -> ScarpColumn {
    let c0: f32 = scarp_value2(l, x, p.cell.y);
    let c1: f32 = scarp_value2(l, x, p.next.y);
    let d: f32 = scarp_sub(c1, c0);
    let c: ScarpColumn = ScarpColumn(ScarpLine(0.0f, scarp_add(c0, scarp_mul(v.u, d))),
            ScarpLine(0.0f, scarp_mul(v.du, d)), ScarpLine(0.0f, 0.0f), ScarpLine(0.0f,
            scarp_mul(v.ddu, d)), ScarpLine(0.0f, 0.0f), ScarpLine(0.0f, 0.0f));
    return c;
}

fn scarp_value_column3(l: ScarpLattice, x: u32, p: ScarpLocation, v: ScarpFade,
        w: ScarpFade) -> ScarpColumn {
    let c00: f32 = scarp_value3(l, x, p.cell.y, p.cell.z);
    let c01: f32 = scarp_value3(l, x, p.cell.y, p.next.z);
    let c10: f32 = scarp_value3(l, x, p.next.y, p.cell.z);
    let c11: f32 = scarp_value3(l, x, p.next.y, p.next.z);
    let dz0: f32 = scarp_sub(c01, c00);
    let dz1: f32 = scarp_sub(c11, c10);
    let e0: f32 = scarp_add(c00, scarp_mul(w.u, dz0));
    let e1: f32 = scarp_add(c10, scarp_mul(w.u, dz1));
    let dy: f32 = scarp_sub(e1, e0);
    let ddz: f32 = scarp_sub(dz1, dz0);
    let dz: f32 = scarp_add(dz0, scarp_mul(v.u, ddz)); /* interpolated over y */
    let c: ScarpColumn = ScarpColumn(ScarpLine(0.0f, scarp_add(e0, scarp_mul(v.u, dy))),
            ScarpLine(0.0f, scarp_mul(v.du, dy)), ScarpLine(0.0f, scarp_mul(w.du, dz)),
            ScarpLine(0.0f, scarp_mul(v.ddu, dy)), ScarpLine(0.0f, scarp_mul(v.du, scarp_mul(w.du,
            ddz))), ScarpLine(0.0f, scarp_mul(w.ddu, dz)));
    return c;
}

fn scarp_value_at2(l: ScarpLattice, kind: u32, p: ScarpLocation) -> ScarpSample {
    let v: ScarpFade = scarp_fade(kind, p.t.y);
    return scarp_join(scarp_value_column2(l, p.cell.x, p, v), scarp_value_column2(l, p.next.x, p,
            v), p.t.x, scarp_fade(kind, p.t.x), true);
}

fn scarp_value_at3(l: ScarpLattice, kind: u32, p: ScarpLocation) -> ScarpSample {
    let v: ScarpFade = scarp_fade(kind, p.t.y);
    let w: ScarpFade = scarp_fade(kind, p.t.z);
    return scarp_join(scarp_value_column3(l, p.cell.x, p, v, w), scarp_value_column3(l, p.next.x, p,
            v, w), p.t.x, scarp_fade(kind, p.t.x), true);
}

fn scarp_value_at(l: ScarpLattice, kind: u32, p: ScarpLocation, dimensions: i32) -> ScarpSample {
    if (dimensions == 2) {
        return scarp_value_at2(l, kind, p);
    }
    return scarp_value_at3(l, kind, p);
}

/* Simplex noise (Perlin 2001, Gustavson 2005). */

/* What a vertex adds; `g` is its gradient, `r2` is r^2. */
fn scarp_vertex_at(d: vec3f, g: vec3f, r2: f32, dimensions: i32) -> ScarpSample {
    var across2: f32 = scarp_mul(d.y, d.y);
    var across: f32 = scarp_mul(g.y, d.y);
    if (dimensions == 3) {
        across2 = scarp_add(across2, scarp_mul(d.z, d.z));
        across = scarp_add(across, scarp_mul(g.z, d.z));
    }
    let left: f32 = scarp_sub(scarp_sub(r2, across2), scarp_mul(d.x, d.x));
    let w: f32 = select(0.0f, left, left > 0.0f);
    let q: f32 = scarp_add(scarp_mul(g.x, d.x), across);
    let w2: f32 = scarp_mul(w, w);
    let w3: f32 = scarp_mul(8.0f, scarp_mul(w2, w));
    let w4: f32 = scarp_mul(w2, w2);
    let wq: f32 = scarp_mul(w3, q);
    let bend: f32 = scarp_mul(scarp_mul(48.0f, w2), q);
    var s: ScarpSample = scarp_constant(scarp_mul(w4, q));
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
const SCARP_ROW_HEIGHT: f32 = 0.866025404f; /* sqrt(3) / 2 */
const SCARP_TRIANGLE_R2: f32 = 0.75f;

/* The vertex `column` to the right of the cell, in row y, at d from p. */
fn scarp_vertex2(l: ScarpLattice, p: ScarpLocation, column: i32, y: u32, d: vec3f) -> ScarpSample {
    let x: u32 = scarp_cell_beside(l.last.x, p.cell.x, column);
    return scarp_vertex_at(d, scarp_direction2(scarp_direction_index2(scarp_hash2(l.key, x, y))),
            SCARP_TRIANGLE_R2, 2);
}

fn scarp_simplex_at2(l: ScarpLattice, p: ScarpLocation) -> ScarpSample {
    let is_odd: bool = (p.cell.y & 1u) != 0u;
    let shift: f32 = scarp_mul(0.5f, p.t.y);
    let start: f32 = scarp_sub(p.t.x, select(0.0f, 0.5f, is_odd));
    let is_before: bool = start < shift; /* p is left of the line that vertex 0 begins */
    let k: i32 = select(0, -1, is_before);
    let above: i32 = select(k, k + 1, is_odd);
    let x: f32 = select(start, scarp_add(start, 1.0f), is_before); /* from vertex k of the row below */
    let y: f32 = scarp_mul(SCARP_ROW_HEIGHT, p.t.y);
    let y_above: f32 = scarp_sub(y, SCARP_ROW_HEIGHT);
    let is_lower: bool = scarp_add(x, shift) < 1.0f;
    let a: ScarpSample = scarp_vertex2(l, p, k + 1, p.cell.y, vec3f(scarp_sub(x, 1.0f), y, 0.0f));
    let b: ScarpSample = scarp_vertex2(l, p, above, p.next.y, vec3f(scarp_sub(x, 0.5f), y_above,
            0.0f));
    let c: ScarpSample = scarp_vertex2(l, p, select(above + 1, k, is_lower), select(p.next.y,
            p.cell.y, is_lower), vec3f(select(scarp_sub(x, 1.5f), x, is_lower), select(y_above, y,
            is_lower), 0.0f));
    return scarp_sum_of(scarp_sum_of(a, b), c);
}

/*
 * 3D: the corners and the centres of cubes. A tetrahedron has two centres, next to each other along
 * the axis on which p is furthest from the first; and two corners, next to each other along the
 * axis on which it is nearest. (r^2 is a little less than 1/2, so that the other vertices add
 * exactly 0 in float arithmetic, too: rows of grids may add any of them.)
 */
const SCARP_TETRAHEDRON_R2: f32 = 0.499999523f; /* 1/2 - 2^-21 */

/* Centres draw with another number than corners. */
const SCARP_HASH_CENTRE: u32 = 0xbcfa3e4du;

/* A vertex: how many cells its own is from that of p along each axis, and where p lies from it. */
struct ScarpVertex {
    x: i32,
    y: i32,
    z: i32,
    d: vec3f,
}

/* Draws with HASH_K or HASH_CENTRE. */
fn scarp_vertex3(l: ScarpLattice, p: ScarpLocation, v: ScarpVertex, hash_k: u32) -> ScarpSample {
    let h: u32 = scarp_joined3(l.key, scarp_cell_beside(l.last.x, p.cell.x, v.x),
            scarp_cell_beside(l.last.y, p.cell.y, v.y), scarp_cell_beside(l.last.z, p.cell.z, v.z));
    let g: vec3f = scarp_direction3(scarp_direction_index3(h * (h + hash_k)));
    return scarp_vertex_at(v.d, g, SCARP_TETRAHEDRON_R2, 3);
}

/* The second centre, the first corner and the second one along an axis: how many cells they are
   from that of p, and where p lies from them. */
struct ScarpEnds {
    centre: i32,
    corner0: i32,
    corner1: i32,
    d_centre: f32,
    d_corner0: f32,
    d_corner1: f32,
}

/* p lies at t from the first centre. */
fn scarp_ends_of(t: f32, is_furthest: bool, is_nearest: bool) -> ScarpEnds {
    let is_up: bool = !(t < 0.0f);
    let side: f32 = select(-0.5f, 0.5f, is_up);
    var e: ScarpEnds = ScarpEnds(0, 0, 0, t, scarp_sub(t, side), scarp_sub(t, side));
    e.corner0 = select(0, 1, is_up);
    e.corner1 = e.corner0;
    if (is_furthest) {
        e.centre = select(-1, 1, is_up);
        e.d_centre = scarp_sub(t, select(-1.0f, 1.0f, is_up));
    }
    if (is_nearest) {
        e.corner1 = 1 - e.corner0;
        e.d_corner1 = scarp_add(t, side);
    }
    return e;
}

fn scarp_simplex_at3(l: ScarpLattice, p: ScarpLocation) -> ScarpSample {
    let t: vec3f = scarp_sub3(p.t, vec3f(0.5f, 0.5f, 0.5f));
    let m: vec3f = vec3f(scarp_magnitude(t.x), scarp_magnitude(t.y), scarp_magnitude(t.z));
    let far_x: bool = m.x >= m.y && m.x >= m.z;
    let far_y: bool = !far_x && m.y >= m.z;
    let near_z: bool = m.z <= m.x && m.z <= m.y;
    let near_y: bool = !near_z && m.y <= m.x;
    let x: ScarpEnds = scarp_ends_of(t.x, far_x, !near_z && !near_y);
    let y: ScarpEnds = scarp_ends_of(t.y, far_y, near_y);
    let z: ScarpEnds = scarp_ends_of(t.z, !far_x && !far_y, near_z);
    let centre0: ScarpVertex = ScarpVertex(0, 0, 0, t);
    let centre1: ScarpVertex = ScarpVertex(x.centre, y.centre, z.centre, vec3f(x.d_centre,
            y.d_centre, z.d_centre));
    let corner0: ScarpVertex = ScarpVertex(x.corner0, y.corner0, z.corner0, vec3f(x.d_corner0,
            y.d_corner0, z.d_corner0));
    let corner1: ScarpVertex = ScarpVertex(x.corner1, y.corner1, z.corner1, vec3f(x.d_corner1,
            y.d_corner1, z.d_corner1));
    let centres: ScarpSample = scarp_sum_of(scarp_vertex3(l, p, centre0, SCARP_HASH_CENTRE),
            scarp_vertex3(l, p, centre1, SCARP_HASH_CENTRE));
    let corners: ScarpSample = scarp_sum_of(scarp_vertex3(l, p, corner0, SCARP_HASH_K),
            scarp_vertex3(l, p, corner1, SCARP_HASH_K));
    return scarp_sum_of(scarp_sum_of(corners, centres), scarp_constant(0.0f)); /* which turns a sum of -0 into 0 */
}

fn scarp_simplex_at(l: ScarpLattice, p: ScarpLocation, dimensions: i32) -> ScarpSample {
    if (dimensions == 2) {
        return scarp_simplex_at2(l, p);
    }
    return scarp_simplex_at3(l, p);
}

/* Cellular noise (Worley 1996). */

/* What a cell draws beside v_0, which is its hash. */
const SCARP_FEATURE_Y: u32 = 0xe41130e9u;
const SCARP_FEATURE_Z: u32 = 0x6ecea30du;
const SCARP_FEATURE_ID: u32 = 0xc603dc87u;

/* Where a point lies from the feature of a cell, and the hash of that cell. */
struct ScarpFeature {
    d: vec3f,
    s: f32,
    hash: u32,
}

/* How far t is from the feature of the cell `step` away, along an axis on which it drew v. */
fn scarp_feature_distance(t: f32, step: i32, jitter: f32, v: u32) -> f32 {
    let middle: f32 = scarp_add(f32(step), 0.5f);
    return scarp_sub(t, scarp_add(middle, scarp_mul(jitter, scarp_lattice_value(v))));
}

/* The feature of the cell that is (x, y, z) away from that of p. */
fn scarp_feature_at(l: ScarpLattice, p: ScarpLocation, x: i32, y: i32, z: i32,
        dimensions: i32) -> ScarpFeature {
    let cx: u32 = scarp_cell_beside(l.last.x, p.cell.x, x);
    let cy: u32 = scarp_cell_beside(l.last.y, p.cell.y, y);
    var f: ScarpFeature = ScarpFeature(vec3f(0.0f, 0.0f, 0.0f), 0.0f, scarp_hash2(l.key, cx, cy));
    if (dimensions == 3) {
        f.hash = scarp_hash3(l.key, cx, cy, scarp_cell_beside(l.last.z, p.cell.z, z));
    }
    f.d.x = scarp_feature_distance(p.t.x, x, l.jitter, f.hash);
    f.d.y = scarp_feature_distance(p.t.y, y, l.jitter, f.hash * SCARP_FEATURE_Y);
    var across2: f32 = scarp_mul(f.d.y, f.d.y);
    if (dimensions == 3) {
        f.d.z = scarp_feature_distance(p.t.z, z, l.jitter, f.hash * SCARP_FEATURE_Z);
        across2 = scarp_add(across2, scarp_mul(f.d.z, f.d.z));
    }
    f.s = scarp_add(scarp_mul(f.d.x, f.d.x), across2);
    return f;
}

/* 0, or NaN where a fraction is NaN, which a search for the least would pass over. */
fn scarp_zero_at(p: ScarpLocation) -> f32 {
    return scarp_mul(0.0f, scarp_add(p.t.x, scarp_add(p.t.y, p.t.z)));
}

/* Further than any search ends. */
const SCARP_FAR_AWAY: f32 = 64.0f;

/* The features that are nearest. */
struct ScarpNearest {
    first: ScarpFeature,
    second: ScarpFeature,
}

/* Only a strictly nearer feature replaces one. */
fn scarp_nearest_with(n: ScarpNearest, f: ScarpFeature) -> ScarpNearest {
    var m: ScarpNearest = n;
    if (f.s < n.first.s) {
        m.second = n.first;
        m.first = f;
    } else if (f.s < n.second.s) {
        m.second = f;
    }
    return m;
}

/* The square of the gap to the cell `step` away along an axis. */
fn scarp_gap2(t: f32, step: i32) -> f32 {
    let gap: f32 = select(scarp_sub(t, f32(step + 1)), scarp_sub(f32(step), t), step > 0);
    return select(scarp_mul(gap, gap), 0.0f, step == 0);
}

/* Whether a cell, and so its feature, is further away than s, by more than rounding. */
fn scarp_is_beyond(p: ScarpLocation, x: i32, y: i32, z: i32, s: f32) -> bool {
    return scarp_add(scarp_add(scarp_gap2(p.t.x, x), scarp_gap2(p.t.y, y)), scarp_gap2(p.t.z,
            z)) > scarp_mul(1.001f, s);
}

/* Whether the search looks at a cell. */
fn scarp_is_searched(p: ScarpLocation, ring: i32, x: i32, y: i32, z: i32, s: f32) -> bool {
    let is_inside: bool = x > -2 && x < 2 && y > -2 && y < 2 && z > -2 && z < 2;
    return ring == 1 || !(is_inside || scarp_is_beyond(p, x, y, z, s));
}

/*
 * Searches the cells around that of p, then those two steps away, of which few are near enough. No
 * feature beyond can be one of the two: it is at least 2 away from p, and both are nearer. (3^n
 * cells do not suffice: the nearest feature of these may be sqrt(n) away, and features two cells
 * off a little more than 1.)
 */
fn scarp_nearest_at(l: ScarpLattice, p: ScarpLocation, dimensions: i32) -> ScarpNearest {
    let far: f32 = scarp_add(SCARP_FAR_AWAY, scarp_zero_at(p)); /* nothing is nearer than NaN */
    let none: ScarpFeature = ScarpFeature(vec3f(far, far, far), far, 0u);
    var n: ScarpNearest = ScarpNearest(none, none);
    for (var ring: i32 = 1; ring <= 2; ring++) {
        let depth: i32 = select(0, ring, dimensions == 3);
        for (var z: i32 = -depth; z <= depth; z++) {
            for (var y: i32 = -ring; y <= ring; y++) {
                for (var x: i32 = -ring; x <= ring; x++) {
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
const SCARP_NO_DISTANCE: f32 = 8.27180613e-25f;

/* The distance from a feature. */
fn scarp_distance_to(f: ScarpFeature) -> ScarpSample {
    let distance: f32 = scarp_root(f.s);
    let r: f32 = select(scarp_inverse(distance), 0.0f, f.s <= SCARP_NO_DISTANCE);
    let g: vec3f = scarp_mul3(r, f.d);
    let s: ScarpSample = ScarpSample(distance, g, vec3f(scarp_mul(r, scarp_sub(1.0f, scarp_mul(g.x,
            g.x))), scarp_mul(r, scarp_sub(1.0f, scarp_mul(g.y, g.y))), scarp_mul(r, scarp_sub(1.0f,
            scarp_mul(g.z, g.z)))), vec3f(-scarp_mul(r, scarp_mul(g.x, g.y)), -scarp_mul(r,
            scarp_mul(g.x, g.z)), -scarp_mul(r, scarp_mul(g.y, g.z))));
    return s;
}

/* What a feature adds before the root; the gradient without the factor 8, the Hessian too. */
fn scarp_soft_term(f: ScarpFeature) -> ScarpSample {
    let a: f32 = select(0.0f, scarp_sub(1.0f, f.s), f.s < 1.0f);
    let a2: f32 = scarp_mul(a, a);
    let a4: f32 = scarp_mul(a2, a2);
    let a6: f32 = scarp_mul(a4, a2);
    let a7: f32 = scarp_mul(a6, a);
    let b: vec3f = scarp_mul3(scarp_mul(14.0f, a6), f.d);
    let s: ScarpSample = ScarpSample(scarp_mul(a4, a4), scarp_mul3(a7, f.d),
            vec3f(scarp_sub(scarp_mul(b.x, f.d.x), a7), scarp_sub(scarp_mul(b.y, f.d.y), a7),
            scarp_sub(scarp_mul(b.z, f.d.z), a7)), vec3f(scarp_mul(b.x, f.d.y), scarp_mul(b.x,
            f.d.z), scarp_mul(b.y, f.d.z)));
    return s;
}

/* Below this, V^2 counts as 0: derivatives are no more than its rounding there. */
const SCARP_NO_SUM: f32 = 7.52316385e-37f;

fn scarp_soft_root(sum: ScarpSample) -> ScarpSample {
    let v: f32 = scarp_root(sum.value);
    let r: f32 = select(scarp_mul(8.0f, scarp_inverse(v)), 0.0f, sum.value <= SCARP_NO_SUM);
    let q: f32 = scarp_mul(0.125f, r); /* 1 / V */
    let g: vec3f = scarp_mul3(r, sum.gradient);
    let squares: vec3f = vec3f(scarp_mul(g.x, g.x), scarp_mul(g.y, g.y), scarp_mul(g.z, g.z));
    let products: vec3f = vec3f(scarp_mul(g.x, g.y), scarp_mul(g.x, g.z), scarp_mul(g.y, g.z));
    return scarp_sample_of(-v, g, scarp_sub3(scarp_mul3(q, squares), scarp_mul3(r, sum.diagonal)),
            scarp_sub3(scarp_mul3(q, products), scarp_mul3(r, sum.mixed)));
}

fn scarp_soft_at(l: ScarpLattice, p: ScarpLocation, dimensions: i32) -> ScarpSample {
    let depth: i32 = select(0, 1, dimensions == 3);
    let zero: f32 = scarp_zero_at(p);
    let zeros: vec3f = vec3f(zero, zero, zero);
    var sum: ScarpSample = ScarpSample(zero, zeros, zeros, zeros);
    for (var z: i32 = -depth; z <= depth; z++) {
        for (var y: i32 = -1; y <= 1; y++) {
            for (var x: i32 = -1; x <= 1; x++) {
                sum = scarp_sum_of(sum, scarp_soft_term(scarp_feature_at(l, p, x, y, z,
                        dimensions)));
            }
        }
    }
    return scarp_soft_root(sum);
}

/* Each cell's own value, in units of 2^-31; all derivatives are 0. */
fn scarp_cell_value(f: ScarpFeature) -> ScarpSample {
    let zero: f32 = scarp_mul(0.0f, f.s); /* or NaN */
    let zeros: vec3f = vec3f(zero, zero, zero);
    return scarp_sample_of(scarp_add(scarp_lattice_value(f.hash * SCARP_FEATURE_ID), zero), zeros,
            zeros, zeros);
}

fn scarp_cells_at(l: ScarpLattice, basis: u32, p: ScarpLocation, dimensions: i32) -> ScarpSample {
    if (basis == SCARP_CELL_SOFT) {
        var soft: ScarpSample = scarp_soft_at(l, p, dimensions);
        soft.value = scarp_add(soft.value, l.middle);
        return soft;
    }
    let n: ScarpNearest = scarp_nearest_at(l, p, dimensions);
    if (basis == SCARP_CELL_VALUE) {
        return scarp_cell_value(n.first);
    }
    let first: ScarpSample = scarp_distance_to(n.first);
    var s: ScarpSample = scarp_distance_to(n.second);
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

fn scarp_lattice_of(o: ScarpOctave, l: ScarpLevel) -> ScarpLattice {
    let lattice: ScarpLattice = ScarpLattice(o.key, o.last, l.flows != 0u, o.turn, o.turn.x,
            o.turn.y, l.component);
    return lattice;
}

fn scarp_basis_at(o: ScarpOctave, l: ScarpLevel, p: ScarpLocation, dimensions: i32) -> ScarpSample {
    let lattice: ScarpLattice = scarp_lattice_of(o, l);
    var s: ScarpSample;
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

fn scarp_dot(a: vec3f, b: vec3f, dimensions: i32) -> f32 {
    var d: f32 = scarp_add(scarp_mul(a.x, b.x), scarp_mul(a.y, b.y));
    if (dimensions == 3) {
        d = scarp_add(d, scarp_mul(a.z, b.z));
    }
    return d;
}

/* A matrix of 3 rows. */
struct ScarpRows {
    x: vec3f,
    y: vec3f,
    z: vec3f,
}

fn scarp_rows_of(x: vec3f, y: vec3f, z: vec3f) -> ScarpRows {
    var m: ScarpRows;
    m.x = x;
    m.y = y;
    m.z = z;
    return m;
}

fn scarp_transposed(m: ScarpRows) -> ScarpRows {
    return scarp_rows_of(vec3f(m.x.x, m.y.x, m.z.x), vec3f(m.x.y, m.y.y, m.z.y), vec3f(m.x.z, m.y.z,
            m.z.z));
}

/* m v */
fn scarp_times(m: ScarpRows, v: vec3f, dimensions: i32) -> vec3f {
    return vec3f(scarp_dot(m.x, v, dimensions), scarp_dot(m.y, v, dimensions), scarp_dot(m.z, v,
            dimensions));
}

/* The transpose of m, times v. */
fn scarp_transposed_times(m: ScarpRows, v: vec3f, dimensions: i32) -> vec3f {
    return scarp_times(scarp_transposed(m), v, dimensions);
}

/* The Hessian. */
fn scarp_hessian_of(s: ScarpSample) -> ScarpRows {
    return scarp_rows_of(vec3f(s.diagonal.x, s.mixed.x, s.mixed.y), vec3f(s.mixed.x, s.diagonal.y,
            s.mixed.z), vec3f(s.mixed.y, s.mixed.z, s.diagonal.z));
}

/* Multiplies the outputs of each order by a factor of their own. */
fn scarp_scaled(n: ScarpSample, value: f32, gradient: f32, hessian: f32) -> ScarpSample {
    return scarp_sample_of(scarp_mul(value, n.value), scarp_mul3(gradient, n.gradient),
            scarp_mul3(hessian, n.diagonal), scarp_mul3(hessian, n.mixed));
}

/* v_i m_j + v_j m_i: the elements of a diagonal, and the others. */
fn scarp_crossed_diagonal(v: vec3f, m: vec3f) -> vec3f {
    return vec3f(scarp_add(scarp_mul(v.x, m.x), scarp_mul(v.x, m.x)), scarp_add(scarp_mul(v.y, m.y),
            scarp_mul(v.y, m.y)), scarp_add(scarp_mul(v.z, m.z), scarp_mul(v.z, m.z)));
}

fn scarp_crossed_mixed(v: vec3f, m: vec3f) -> vec3f {
    return vec3f(scarp_add(scarp_mul(v.x, m.y), scarp_mul(v.y, m.x)), scarp_add(scarp_mul(v.x, m.z),
            scarp_mul(v.z, m.x)), scarp_add(scarp_mul(v.y, m.z), scarp_mul(v.z, m.y)));
}

/* Where a point lies in the frame of an octave. */

fn scarp_within_period(last: u32, cell: i32) -> u32 {
    var within: u32 = bitcast<u32>(cell);
    if (last != 0xffffffffu) {
        let period: u32 = last + 1u;
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
    cell: u32,
    t: f32,
}

fn scarp_split(p: f32, last: u32) -> ScarpSplit {
    var s: ScarpSplit;
    if (scarp_magnitude(p) < 2147483648.0f) {
        let whole: i32 = i32(p);
        let lower: i32 = select(whole, whole - 1, f32(whole) > p);
        s.cell = scarp_within_period(last, lower);
        s.t = scarp_sub(p, f32(lower));
    } else {
        s.cell = scarp_within_period(last, bitcast<i32>(SCARP_SIGN));
        s.t = scarp_sub(p, p);
    }
    return s;
}

/* J x where axes are turned, else f x: how many cells of the octave x is along each axis. */
fn scarp_cells_along(o: ScarpOctave, turned: bool, x: vec3f, dimensions: i32) -> vec3f {
    var p: vec3f = scarp_mul3(o.frequency, x);
    if (turned) {
        p = scarp_times(scarp_rows_of(o.jacobian_x, o.jacobian_y, o.jacobian_z), x, dimensions);
    }
    return p;
}

/* Along y, triangles of simplex noise count their rows. */
fn scarp_stretched(o: ScarpOctave, basis: u32, cells: vec3f, dimensions: i32) -> vec3f {
    var p: vec3f = cells;
    if (basis == SCARP_SIMPLEX && dimensions == 2) {
        p.y = scarp_mul(p.y, o.turn.z);
    }
    return p;
}

/* Where a point lies by its splits along the axes. In 2D all of z is 0. */
fn scarp_location_in(last: vec3u, x: ScarpSplit, y: ScarpSplit, z: ScarpSplit,
        dimensions: i32) -> ScarpLocation {
    var at: ScarpLocation = ScarpLocation(vec3u(x.cell, y.cell, 0u), vec3u(scarp_cell_after(last.x,
            x.cell), scarp_cell_after(last.y, y.cell), 0u), vec3f(x.t, y.t, 0.0f));
    if (dimensions == 3) {
        at.t.z = z.t;
        at.cell.z = z.cell;
        at.next.z = scarp_cell_after(last.z, z.cell);
    }
    return at;
}

/* Along each axis p = J x + o, where axes are turned, else p = f x + o. */
fn scarp_location_of(o: ScarpOctave, basis: u32, turned: bool, x: vec3f,
        dimensions: i32) -> ScarpLocation {
    let offset: vec3f = vec3f(o.offset_x, o.offset_y, o.offset_z);
    let cells: vec3f = scarp_add3(scarp_cells_along(o, turned, x, dimensions), offset);
    let p: vec3f = scarp_stretched(o, basis, cells, dimensions);
    var z: ScarpSplit = ScarpSplit(0u, 0.0f);
    if (dimensions == 3) {
        z = scarp_split(p.z, o.last.z);
    }
    return scarp_location_in(o.last, scarp_split(p.x, o.last.x), scarp_split(p.y, o.last.y), z,
            dimensions);
}

/* What fractals make of an octave n, but for those that bend. */

fn scarp_jacobian_of(o: ScarpOctave) -> ScarpRows {
    return scarp_transposed(scarp_rows_of(o.jacobian_x, o.jacobian_y, o.jacobian_z));
}

/* The vector v, in the octave's axes, in those of the input: J^T v, or f v. */
fn scarp_to_input(o: ScarpOctave, turned: bool, v: vec3f, dimensions: i32) -> vec3f {
    var r: vec3f = scarp_mul3(o.frequency, v);
    if (turned) {
        r = scarp_times(scarp_jacobian_of(o), v, dimensions);
    }
    return r;
}

/* `n` with the Hessian A^T (H B); `a` and `b` are the transposes of A and B. */
fn scarp_with_hessian(n: ScarpSample, a: ScarpRows, b: ScarpRows, h: ScarpRows,
        dimensions: i32) -> ScarpSample {
    let hb: ScarpRows = scarp_transposed(scarp_rows_of(scarp_times(b, h.x, dimensions),
            scarp_times(b, h.y, dimensions), scarp_times(b, h.z, dimensions)));
    var s: ScarpSample = n;
    s.diagonal = vec3f(scarp_dot(a.x, hb.x, dimensions), scarp_dot(a.y, hb.y, dimensions),
            scarp_dot(a.z, hb.z, dimensions));
    s.mixed = vec3f(scarp_dot(a.x, hb.y, dimensions), scarp_dot(a.x, hb.z, dimensions),
            scarp_dot(a.y, hb.z, dimensions));
    return s;
}

/* The octave times its amplitude a, in the axes of the input: the gradient is (a J)^T g, the
   Hessian (a J)^T (H J). Where axes are not turned J is f, so the factors are a f and a f^2. */
fn scarp_in_input(o: ScarpOctave, turned: bool, n: ScarpSample, dimensions: i32) -> ScarpSample {
    var s: ScarpSample = scarp_scaled(n, o.amplitude, o.slope, o.curvature);
    if (turned) {
        let scaled_jacobian: ScarpRows = scarp_transposed(scarp_rows_of(o.gradient_x, o.gradient_y,
                o.gradient_z));
        s.gradient = scarp_times(scaled_jacobian, n.gradient, dimensions);
        s = scarp_with_hessian(s, scaled_jacobian, scarp_jacobian_of(o), scarp_hessian_of(n),
                dimensions);
    }
    return s;
}

fn scarp_with_sign3(a: vec3f, n: f32) -> vec3f {
    return vec3f(scarp_with_sign(a.x, n), scarp_with_sign(a.y, n), scarp_with_sign(a.z, n));
}

/* Turbulence */
fn scarp_magnitude_of(n: ScarpSample) -> ScarpSample {
    return scarp_sample_of(scarp_with_sign(n.value, n.value), scarp_with_sign3(n.gradient, n.value),
            scarp_with_sign3(n.diagonal, n.value), scarp_with_sign3(n.mixed, n.value));
}

/* Ping-pong: 1 - 2 |e|, where e = 1 - (t mod 2) rises where t falls. The derivatives lack their
   factor 2 sharpness, which comes with the weight, and are 0 on creases, where the value is 1 or
   -1. */
fn scarp_pingpong(n: ScarpSample, sharpness: f32) -> ScarpSample {
    let t: f32 = scarp_mul(scarp_add(n.value, 1.0f), sharpness);
    let e: f32 = scarp_sub(1.0f, scarp_sub(t, scarp_mul(2.0f, floor(scarp_mul(t, 0.5f)))));
    let value: f32 = scarp_sub(1.0f, scarp_mul(2.0f, scarp_magnitude(e)));
    let falling: f32 = select(1.0f, -1.0f, scarp_is_negative(e));
    let slope: f32 = select(falling, 0.0f, scarp_magnitude(value) == 1.0f);
    return scarp_sample_of(value, scarp_with_sign3(n.gradient, slope), scarp_with_sign3(n.diagonal,
            slope), scarp_with_sign3(n.mixed, slope));
}

/* Ridged noise: v r^2 with v = weight and r = 1 - m, m being |n|. Its derivatives are
       r^2 v_i - 2 v r m_i
       r^2 v_ij - 2 r (v_i m_j + v_j m_i) + 2 v m_i m_j - 2 v r m_ij */
fn scarp_ridge_first(v: f32, vi: f32, r: f32, mi: f32) -> f32 {
    return scarp_sub(scarp_mul(scarp_mul(r, r), vi), scarp_mul(scarp_mul(scarp_mul(2.0f, v), r),
            mi));
}

fn scarp_ridge_first3(v: f32, vi: vec3f, r: f32, mi: vec3f) -> vec3f {
    return vec3f(scarp_ridge_first(v, vi.x, r, mi.x), scarp_ridge_first(v, vi.y, r, mi.y),
            scarp_ridge_first(v, vi.z, r, mi.z));
}

/* `cross` is vi mj + vj mi, `mm` is mi mj. */
fn scarp_ridge_second(v: f32, r: f32, vij: f32, mij: f32, cross: f32, mm: f32) -> f32 {
    return scarp_add(scarp_sub(scarp_mul(scarp_mul(r, r), vij), scarp_mul(scarp_mul(2.0f, r),
            cross)), scarp_sub(scarp_mul(scarp_mul(2.0f, v), mm),
            scarp_mul(scarp_mul(scarp_mul(2.0f, v), r), mij)));
}

fn scarp_ridge(weight: ScarpSample, n: ScarpSample) -> ScarpSample {
    let m: ScarpSample = scarp_magnitude_of(n);
    let a: vec3f = scarp_crossed_diagonal(weight.gradient, m.gradient);
    let b: vec3f = scarp_crossed_mixed(weight.gradient, m.gradient);
    let g: vec3f = m.gradient;
    let vd: vec3f = weight.diagonal;
    let vm: vec3f = weight.mixed;
    let v: f32 = weight.value;
    let r: f32 = scarp_sub(1.0f, m.value);
    return scarp_sample_of(scarp_mul(v, scarp_mul(r, r)), scarp_ridge_first3(v, weight.gradient, r,
            g), vec3f(scarp_ridge_second(v, r, vd.x, m.diagonal.x, a.x, scarp_mul(g.x, g.x)),
            scarp_ridge_second(v, r, vd.y, m.diagonal.y, a.y, scarp_mul(g.y, g.y)),
            scarp_ridge_second(v, r, vd.z, m.diagonal.z, a.z, scarp_mul(g.z, g.z))),
            vec3f(scarp_ridge_second(v, r, vm.x, m.mixed.x, b.x, scarp_mul(g.x, g.y)),
            scarp_ridge_second(v, r, vm.y, m.mixed.y, b.y, scarp_mul(g.x, g.z)),
            scarp_ridge_second(v, r, vm.z, m.mixed.z, b.z, scarp_mul(g.y, g.z))));
}

/* The weight of the octave after one of ridged noise: 2 s, but 1 where that is more. */
fn scarp_ridge_weight(s: ScarpSample) -> ScarpSample {
    var weight: ScarpSample = scarp_constant(1.0f);
    if (scarp_mul(2.0f, s.value) < 1.0f) {
        weight = scarp_scaled(s, 2.0f, 2.0f, 2.0f);
    }
    return weight;
}

/* Hybrid noise: v r with v = weight and r = n + sharpness. Its derivatives are
       r v_i + v n_i
       r v_ij + v n_ij + v_i n_j + v_j n_i */
fn scarp_hybrid(weight: ScarpSample, n: ScarpSample, sharpness: f32) -> ScarpSample {
    let v: f32 = weight.value;
    let r: f32 = scarp_add(n.value, sharpness);
    let diagonal: vec3f = scarp_add3(scarp_mul3(r, weight.diagonal), scarp_mul3(v, n.diagonal));
    let mixed: vec3f = scarp_add3(scarp_mul3(r, weight.mixed), scarp_mul3(v, n.mixed));
    return scarp_sample_of(scarp_mul(v, r), scarp_add3(scarp_mul3(r, weight.gradient), scarp_mul3(v,
            n.gradient)), scarp_add3(diagonal, scarp_crossed_diagonal(weight.gradient, n.gradient)),
            scarp_add3(mixed, scarp_crossed_mixed(weight.gradient, n.gradient)));
}

/* The weight of the octave after one of hybrid noise: share u, but 1 or -1 where that is beyond. */
fn scarp_hybrid_weight(u: ScarpSample, share: f32) -> ScarpSample {
    let t: f32 = scarp_mul(share, u.value);
    var weight: ScarpSample = scarp_constant(select(1.0f, -1.0f, t < 0.0f));
    if (scarp_magnitude(t) < 1.0f) {
        weight = scarp_scaled(u, share, share, share);
    }
    return weight;
}

/* What slopes add up to, with the rows of the Jacobian. */
struct ScarpSlopes {
    d: vec3f,
    jacobian: ScarpRows,
}

fn scarp_sum_of_rows(a: ScarpRows, b: ScarpRows) -> ScarpRows {
    return scarp_rows_of(scarp_add3(a.x, b.x), scarp_add3(a.y, b.y), scarp_add3(a.z, b.z));
}

/* The slopes, to which those of an octave n, in its own axes, are added. */
fn scarp_steeper(slopes: ScarpSlopes, o: ScarpOctave, turned: bool, n: ScarpSample,
        dimensions: i32) -> ScarpSlopes {
    let h: ScarpRows = scarp_hessian_of(n);
    var s: ScarpSlopes;
    s.d = scarp_add3(slopes.d, n.gradient);
    s.jacobian = scarp_sum_of_rows(slopes.jacobian, scarp_rows_of(scarp_to_input(o, turned, h.x,
            dimensions), scarp_to_input(o, turned, h.y, dimensions), scarp_to_input(o, turned, h.z,
            dimensions)));
    return s;
}

/* An octave n of erosion; `slopes` have it, and `gradient` is its own in the axes of the input. */
fn scarp_eroded(slopes: ScarpSlopes, erosion: f32, n: f32, gradient: vec3f,
        dimensions: i32) -> ScarpSample {
    let q: f32 = scarp_inverse(scarp_add(1.0f, scarp_mul(erosion, scarp_dot(slopes.d, slopes.d,
            dimensions))));
    let damping: f32 = scarp_mul(scarp_mul(scarp_mul(2.0f, erosion), n), scarp_mul(q, q));
    let steepening: vec3f = scarp_transposed_times(slopes.jacobian, slopes.d, dimensions);
    var s: ScarpSample = scarp_constant(scarp_mul(q, n));
    s.gradient = scarp_sub3(scarp_mul3(q, gradient), scarp_mul3(damping, steepening));
    return s;
}

/* The fractals that bend, Swiss and Jordan noise. */

/* What goes from octave to octave. `weight`: ridged and hybrid noise; `slopes`: erosion and those
   that bend; `left`: how much of the octaves Swiss noise leaves, with its gradient. */
struct ScarpState {
    sum: ScarpSample,
    weight: ScarpSample,
    slopes: ScarpSlopes,
    left: f32,
    left_by: vec3f,
}

/* A gradient with respect to bent positions becomes one with respect to x: A^T g with A = I + reach
   (Jacobian of the slopes). */
fn scarp_unbent(slopes: ScarpSlopes, reach: f32, g: vec3f, dimensions: i32) -> vec3f {
    return scarp_add3(g, scarp_mul3(reach, scarp_transposed_times(slopes.jacobian, g, dimensions)));
}

/* A row of the Jacobian with what a component of the slope adds; `row` is that of the Hessian. */
fn scarp_bent_row(jacobian: vec3f, by: vec3f, slope: f32, product: f32, row: vec3f) -> vec3f {
    return scarp_add3(jacobian, scarp_add3(scarp_mul3(slope, by), scarp_mul3(product, row)));
}

/* The slopes with factor n times the slope g / f of an octave; `by` is the gradient of factor n. */
fn scarp_with_slope(slopes: ScarpSlopes, o: ScarpOctave, n: ScarpSample, product: f32, by: vec3f,
        dimensions: i32) -> ScarpSlopes {
    let h: ScarpRows = scarp_hessian_of(n);
    let slope: vec3f = scarp_mul3(o.inverse, n.gradient);
    let x: vec3f = scarp_mul3(o.inverse, scarp_unbent(slopes, o.reach, h.x, dimensions));
    let y: vec3f = scarp_mul3(o.inverse, scarp_unbent(slopes, o.reach, h.y, dimensions));
    let z: vec3f = scarp_mul3(o.inverse, scarp_unbent(slopes, o.reach, h.z, dimensions));
    var s: ScarpSlopes;
    s.d = scarp_add3(slopes.d, scarp_mul3(product, slope));
    s.jacobian = scarp_rows_of(scarp_bent_row(slopes.jacobian.x, by, slope.x, product, x),
            scarp_bent_row(slopes.jacobian.y, by, slope.y, product, y),
            scarp_bent_row(slopes.jacobian.z, by, slope.z, product, z));
    return s;
}

/* Swiss noise adds a u v with v = max(0, 1 - |n|), n being bent; S loses (a / a_0) u n g / f, and u
   is multiplied by the sum over a_0, at most by 1. */
fn scarp_swiss(state: ScarpState, o: ScarpOctave, inverse_weight: f32, n: ScarpSample,
        dimensions: i32) -> ScarpState {
    let share: f32 = scarp_mul(o.weight, inverse_weight);
    let u: f32 = state.left;
    let rest: f32 = scarp_sub(1.0f, scarp_magnitude(n.value));
    let v: f32 = select(rest, 0.0f, rest < 0.0f); /* NaN stays */
    let nj: vec3f = scarp_unbent(state.slopes, o.reach, n.gradient, dimensions);
    let none: vec3f = vec3f(0.0f, 0.0f, 0.0f);
    var vj: vec3f = scarp_with_sign3(nj, n.value);
    if (rest < 0.0f) {
        vj = none;
    }
    var s: ScarpState = state;
    let term: vec3f = scarp_mul3(o.weight, scarp_sub3(scarp_mul3(v, state.left_by), scarp_mul3(u,
            vj)));
    s.sum.gradient = scarp_add3(state.sum.gradient, term);
    s.sum.value = scarp_add(state.sum.value, scarp_mul(o.weight, scarp_mul(u, v)));
    let by: vec3f = scarp_mul3(-share, scarp_add3(scarp_mul3(n.value, state.left_by), scarp_mul3(u,
            nj)));
    s.slopes = scarp_with_slope(state.slopes, o, n, scarp_mul(-share, scarp_mul(u, n.value)), by,
            dimensions);
    let sum: f32 = scarp_mul(s.sum.value, inverse_weight);
    if (sum < 1.0f) {
        s.left_by = scarp_add3(scarp_mul3(sum, state.left_by), scarp_mul3(u,
                scarp_mul3(inverse_weight, s.sum.gradient)));
        s.left = scarp_mul(u, sum);
    }
    return s;
}

/* Jordan noise adds a q n^2 with q = 1 - erosion / (1 + S.S), but 1 in octave 0; S gains n g / f.
 */
fn scarp_jordan(state: ScarpState, o: ScarpOctave, erosion: f32, first: bool, n: ScarpSample,
        dimensions: i32) -> ScarpState {
    let square: f32 = scarp_mul(n.value, n.value);
    let p: f32 = scarp_inverse(scarp_add(1.0f, scarp_dot(state.slopes.d, state.slopes.d,
            dimensions)));
    let q: f32 = select(scarp_sub(1.0f, scarp_mul(erosion, p)), 1.0f, first);
    let damping: f32 = select(scarp_mul(scarp_mul(scarp_mul(2.0f, erosion), scarp_mul(p, p)),
            square), 0.0f, first);
    let by: vec3f = scarp_unbent(state.slopes, o.reach, n.gradient, dimensions);
    let steepening: vec3f = scarp_transposed_times(state.slopes.jacobian, state.slopes.d,
            dimensions);
    let term: vec3f = scarp_add3(scarp_mul3(damping, steepening), scarp_mul3(scarp_mul(2.0f, q),
            scarp_mul3(n.value, by)));
    var s: ScarpState = state;
    s.sum.gradient = scarp_add3(state.sum.gradient, scarp_mul3(o.weight, term));
    s.sum.value = scarp_add(state.sum.value, scarp_mul(o.weight, scarp_mul(q, square)));
    s.slopes = scarp_with_slope(state.slopes, o, n, n.value, by, dimensions);
    return s;
}

/* The sum of octaves. */

/* What octave 0 adds to. */
fn scarp_no_octaves() -> ScarpState {
    let none: vec3f = vec3f(0.0f, 0.0f, 0.0f);
    var state: ScarpState;
    state.sum = scarp_constant(0.0f);
    state.weight = scarp_constant(1.0f);
    state.slopes.d = none;
    state.slopes.jacobian = scarp_rows_of(none, none, none);
    state.left = 1.0f;
    state.left_by = none;
    return state;
}

/* Where octave k looks, which those before have bent if it is one of a fractal that bends. */
fn scarp_bent(state: ScarpState, o: ScarpOctave, k: u32, x: vec3f) -> vec3f {
    var y: vec3f = x;
    if (k > 0u) {
        y = scarp_add3(x, scarp_mul3(o.reach, state.slopes.d));
    }
    return y;
}

/* Each fractal adds the octave n, in the axes of the input, to the sum; n is not bent. */
fn scarp_with_fbm(state: ScarpState, n: ScarpSample) -> ScarpState {
    var s: ScarpState = state;
    s.sum = scarp_sum_of(state.sum, n);
    return s;
}

fn scarp_with_turbulence(state: ScarpState, o: ScarpOctave, n: ScarpSample) -> ScarpState {
    return scarp_with_fbm(state, scarp_scaled(scarp_magnitude_of(n), o.weight, o.weight, o.weight));
}

fn scarp_with_ridged(state: ScarpState, o: ScarpOctave, n: ScarpSample) -> ScarpState {
    let term: ScarpSample = scarp_ridge(state.weight, n);
    var s: ScarpState = scarp_with_fbm(state, scarp_scaled(term, o.weight, o.weight, o.weight));
    s.weight = scarp_ridge_weight(term);
    return s;
}

fn scarp_with_pingpong(state: ScarpState, o: ScarpOctave, l: ScarpLevel,
        n: ScarpSample) -> ScarpState {
    let slope: f32 = scarp_mul(o.weight, scarp_mul(2.0f, l.sharpness));
    return scarp_with_fbm(state, scarp_scaled(scarp_pingpong(n, l.sharpness), o.weight, slope,
            slope));
}

fn scarp_with_hybrid(state: ScarpState, o: ScarpOctave, l: ScarpLevel,
        n: ScarpSample) -> ScarpState {
    let term: ScarpSample = scarp_hybrid(state.weight, n, l.sharpness);
    var s: ScarpState = scarp_with_fbm(state, scarp_scaled(term, o.weight, o.weight, o.weight));
    s.weight = scarp_hybrid_weight(term, o.share);
    return s;
}

/* Adds an octave of erosion; n is the basis in the axes of the octave. */
fn scarp_with_erosion(state: ScarpState, o: ScarpOctave, l: ScarpLevel, n: ScarpSample,
        turned: bool, dimensions: i32) -> ScarpState {
    let basis: ScarpSample = scarp_scaled(n, o.amplitude, o.amplitude, o.amplitude);
    let gradient: vec3f = scarp_to_input(o, turned, basis.gradient, dimensions);
    var s: ScarpState = state;
    s.slopes = scarp_steeper(state.slopes, o, turned, basis, dimensions);
    let term: ScarpSample = scarp_eroded(s.slopes, l.erosion, basis.value, gradient, dimensions);
    s.sum = scarp_sum_of(state.sum, scarp_scaled(term, o.weight, o.weight, o.weight));
    return s;
}

/* Adds an octave n, in the axes of the input, of any fractal but erosion. */
fn scarp_with_noise(state: ScarpState, o: ScarpOctave, l: ScarpLevel, first: bool, n: ScarpSample,
        dimensions: i32) -> ScarpState {
    var s: ScarpState;
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
fn scarp_with_basis(state: ScarpState, o: ScarpOctave, l: ScarpLevel, first: bool, turned: bool,
        basis: ScarpSample, dimensions: i32) -> ScarpState {
    var s: ScarpState;
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
    x: ScarpSample,
    y: ScarpSample,
    z: ScarpSample,
}

/* A sample with its derivatives with respect to y becomes one with those with respect to x: with
   the Jacobian J of y, the gradient is J^T g, the Hessian J^T (H J) + sum_m g_m (Hessian of y_m).
 */
fn scarp_composed(s: ScarpSample, y: ScarpDisplaced, dimensions: i32) -> ScarpSample {
    let j: ScarpRows = scarp_transposed(scarp_rows_of(y.x.gradient, y.y.gradient, y.z.gradient));
    let diagonal: vec3f = scarp_transposed_times(scarp_rows_of(y.x.diagonal, y.y.diagonal,
            y.z.diagonal), s.gradient, dimensions);
    let mixed: vec3f = scarp_transposed_times(scarp_rows_of(y.x.mixed, y.y.mixed, y.z.mixed),
            s.gradient, dimensions);
    var r: ScarpSample = scarp_with_hessian(s, j, j, scarp_hessian_of(s), dimensions);
    r.gradient = scarp_times(j, s.gradient, dimensions);
    r.diagonal = scarp_add3(r.diagonal, diagonal);
    r.mixed = scarp_add3(r.mixed, mixed);
    return r;
}

/* What nothing has displaced. */
fn scarp_not_displaced() -> ScarpDisplaced {
    var y: ScarpDisplaced;
    y.x = scarp_constant(0.0f);
    y.y = y.x;
    y.z = y.x;
    return y;
}

/* Displacements of x become positions: their derivatives are those of x, too. */
fn scarp_positions_of(d: ScarpDisplaced) -> ScarpDisplaced {
    var y: ScarpDisplaced = d;
    y.x.gradient.x = scarp_add(y.x.gradient.x, 1.0f);
    y.y.gradient.y = scarp_add(y.y.gradient.y, 1.0f);
    y.z.gradient.z = scarp_add(y.z.gradient.z, 1.0f);
    return y;
}

fn scarp_values_of(y: ScarpDisplaced) -> vec3f {
    return vec3f(y.x.value, y.y.value, y.z.value);
}

fn scarp_displaced_of(x: ScarpSample, y: ScarpSample, z: ScarpSample) -> ScarpDisplaced {
    var d: ScarpDisplaced;
    d.x = x;
    d.y = y;
    d.z = z;
    return d;
}

/* Velocities without divergence. */

/* A velocity without divergence, and the rows of its Jacobian: the derivatives of each component.
 */
struct ScarpFlow {
    velocity: vec3f,
    x: vec3f,
    y: vec3f,
    z: vec3f,
}

/* Of a potential in the plane, v = (psi_y, -psi_x); nothing along z. */
fn scarp_curl_in_plane(psi: ScarpSample) -> ScarpFlow {
    var f: ScarpFlow;
    f.velocity = vec3f(psi.gradient.y, -psi.gradient.x, 0.0f);
    f.x = vec3f(psi.mixed.x, psi.diagonal.y, 0.0f);
    f.y = vec3f(-psi.diagonal.x, -psi.mixed.x, 0.0f);
    f.z = vec3f(0.0f, 0.0f, 0.0f);
    return f;
}

/* Of three potentials, with i, j, k = x, y, z in turn, v_i = d_j psi_k - d_k psi_j. */
fn scarp_curl_in_space(psi: ScarpDisplaced) -> ScarpFlow {
    let a: ScarpRows = scarp_hessian_of(psi.x);
    let b: ScarpRows = scarp_hessian_of(psi.y);
    let c: ScarpRows = scarp_hessian_of(psi.z);
    var f: ScarpFlow;
    f.velocity = vec3f(scarp_sub(psi.z.gradient.y, psi.y.gradient.z), scarp_sub(psi.x.gradient.z,
            psi.z.gradient.x), scarp_sub(psi.y.gradient.x, psi.x.gradient.y));
    f.x = scarp_sub3(c.y, b.z);
    f.y = scarp_sub3(a.z, c.x);
    f.z = scarp_sub3(b.x, a.y);
    return f;
}

/* The self-test of shaders. */

/* A coordinate of test point i, in steps of a unit. Every operation is exact. */
fn scarp_test_coordinate(unit: f32, i: u32, axis: u32) -> f32 {
    let key: vec3u = vec3u(0u, 0u, 0u);
    let cells: i32 = bitcast<i32>(scarp_hash2(key, i, axis) >> 12u) - 524288;
    return scarp_mul(f32(cells), unit);
}

/* The hash h with an output; what is below 2^-120 counts as 0. */
fn scarp_hash_with(h: u32, a: f32) -> u32 {
    let magnitude_bits: u32 = bitcast<u32>(a) & 0x7fffffffu;
    let bits: u32 = select(bitcast<u32>(a), 0u, magnitude_bits < 0x03800000u);
    return (((h << 5u) | (h >> 27u)) ^ bits) * SCARP_HASH_K;
}

/* The sum of the octaves at one point. */

fn scarp_octave_of(plan: u32, k: u32) -> ScarpOctave {
    return scarp_plan[plan].octave[k];
}

fn scarp_level_of(plan: u32, i: i32) -> ScarpLevel {
    var l: ScarpLevel = scarp_plan[plan].level[i];
    l.basis = scarp_only_basis_of(l.basis);
    l.fractal = scarp_only_fractal_of(l.fractal);
    return l;
}

/* Adds octave k of level l at x. */
fn scarp_with_octave(state: ScarpState, o: ScarpOctave, l: ScarpLevel, k: u32, x: vec3f,
        dimensions: i32) -> ScarpState {
    let turned: bool = l.rotate != 0u && k > 0u;
    var y: vec3f = x;
    if (l.fractal == SCARP_SWISS || l.fractal == SCARP_JORDAN) {
        y = scarp_bent(state, o, k, x);
    }
    let p: ScarpLocation = scarp_location_of(o, l.basis, turned, y, dimensions);
    let basis: ScarpSample = scarp_basis_at(o, l, p, dimensions);
    return scarp_with_basis(state, o, l, k == 0u, turned, basis, dimensions);
}

/* The noise of a component of a level, without warps; component 0 of a level that has one. */
fn scarp_octaves_at(plan: u32, given: ScarpLevel, component: u32, x: vec3f,
        dimensions: i32) -> ScarpSample {
    let shares_lattice: bool = given.basis == SCARP_GRADIENT || given.basis == SCARP_VALUE;
    var l: ScarpLevel = given;
    var state: ScarpState = scarp_no_octaves();
    if (shares_lattice) {
        l.component = component;
    } else {
        l.first = given.first + component * given.octaves;
    }
    for (var k: u32 = 0u; k < l.octaves; k++) {
        state = scarp_with_octave(state, scarp_octave_of(plan, l.first + k), l, k, x, dimensions);
    }
    return state.sum;
}

/* Noise with warps, and the self-test of scarp_gpu_answers. */

/* Components of a level, each at `at`, with derivatives with respect to x; `y` says how that
   depends on x, unless the level is the deepest. */
fn scarp_level_at(plan: u32, i: i32, components: i32, deepest: bool, at: vec3f, y: ScarpDisplaced,
        dimensions: i32) -> ScarpDisplaced {
    let l: ScarpLevel = scarp_level_of(plan, i);
    var d: ScarpDisplaced = y;
    for (var c: i32 = 0; c < components; c++) {
        var s: ScarpSample = scarp_octaves_at(plan, l, bitcast<u32>(c), at, dimensions);
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
fn scarp_components_at(plan: u32, x: vec3f, components: i32, dimensions: i32) -> ScarpDisplaced {
    let depth: i32 = bitcast<i32>(scarp_only_depth_of(scarp_plan[plan].depth));
    var at: vec3f = x;
    var y: ScarpDisplaced = scarp_not_displaced();
    for (var i: i32 = depth; i >= 0; i--) {
        var count: i32 = dimensions;
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
fn scarp_sample2(plan: u32, x: f32, y: f32) -> ScarpSample {
    return scarp_components_at(plan, vec3f(x, y, 0.0f), 1, 2).x;
}

/* What scarp_sample3 gives at (x, y, z). */
fn scarp_sample3(plan: u32, x: f32, y: f32, z: f32) -> ScarpSample {
    return scarp_components_at(plan, vec3f(x, y, z), 1, 3).x;
}

/* What scarp_vector2 gives, as x and y, of a plan by scarp_gpu_vector_plan_make. */
fn scarp_vector2(plan: u32, x: f32, y: f32) -> ScarpDisplaced {
    return scarp_components_at(plan, vec3f(x, y, 0.0f), 2, 2);
}

/* What scarp_vector3 gives. */
fn scarp_vector3(plan: u32, x: f32, y: f32, z: f32) -> ScarpDisplaced {
    return scarp_components_at(plan, vec3f(x, y, z), 3, 3);
}

/* The hash h with the outputs of a sample up to an order, in the order of struct scarp_samples. */
fn scarp_hash_with_sample(h: u32, s: ScarpSample, order: u32, dimensions: i32) -> u32 {
    let is_space: bool = dimensions == 3;
    var next: u32 = scarp_hash_with(h, s.value);
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
fn scarp_answer2(plan: u32, order: u32, i: u32) -> u32 {
    let unit: f32 = scarp_plan[plan].unit;
    let s: ScarpSample = scarp_sample2(plan, scarp_test_coordinate(unit, i, 0u),
            scarp_test_coordinate(unit, i, 1u));
    return scarp_hash_with_sample(0u, s, order, 2);
}

fn scarp_answer3(plan: u32, order: u32, i: u32) -> u32 {
    let unit: f32 = scarp_plan[plan].unit;
    let s: ScarpSample = scarp_sample3(plan, scarp_test_coordinate(unit, i, 0u),
            scarp_test_coordinate(unit, i, 1u), scarp_test_coordinate(unit, i, 2u));
    return scarp_hash_with_sample(0u, s, order, 3);
}

/* Cells and velocities of a plan. */

/* What scarp_cells2 and scarp_cells3 give: distances to the nearest feature and to the second,
   their gradients, and the place of the nearest. */
struct ScarpCells {
    id: u32,
    f1: f32,
    f2: f32,
    d1: vec3f,
    d2: vec3f,
    place: vec3f,
}

/* The cells around a point x, which lies at p in octave o; `unit` is the length of a cell. */
fn scarp_cells_around(o: ScarpOctave, p: ScarpLocation, unit: f32, x: vec3f,
        dimensions: i32) -> ScarpCells {
    var l: ScarpLattice = ScarpLattice(o.key, o.last, false, vec4f(0.0f, 0.0f, 0.0f, 0.0f), 0.0f,
            0.0f, 0u);
    l.jitter = o.turn.x;
    let n: ScarpNearest = scarp_nearest_at(l, p, dimensions);
    let first: ScarpSample = scarp_distance_to(n.first);
    let second: ScarpSample = scarp_distance_to(n.second);
    var c: ScarpCells;
    c.id = n.first.hash * SCARP_FEATURE_ID;
    c.f1 = scarp_mul(first.value, unit);
    c.f2 = scarp_mul(second.value, unit);
    c.d1 = first.gradient;
    c.d2 = second.gradient;
    c.place = scarp_sub3(x, scarp_mul3(unit, n.first.d));
    return c;
}

fn scarp_cells_in(plan: u32, x: vec3f, dimensions: i32) -> ScarpCells {
    let o: ScarpOctave = scarp_octave_of(plan, 0u);
    let p: ScarpLocation = scarp_location_of(o, SCARP_CELL_F1, false, x, dimensions);
    return scarp_cells_around(o, p, o.inverse, x, dimensions);
}

/* The cells of a noise whose basis is cellular. */
fn scarp_cells2(plan: u32, x: f32, y: f32) -> ScarpCells {
    return scarp_cells_in(plan, vec3f(x, y, 0.0f), 2);
}

fn scarp_cells3(plan: u32, x: f32, y: f32, z: f32) -> ScarpCells {
    return scarp_cells_in(plan, vec3f(x, y, z), 3);
}

/* What scarp_curl2 gives; nothing along z. */
fn scarp_curl2(plan: u32, x: f32, y: f32) -> ScarpFlow {
    return scarp_curl_in_plane(scarp_sample2(plan, x, y));
}

/* What scarp_curl3 gives, of a plan by scarp_gpu_vector_plan_make. */
fn scarp_curl3(plan: u32, x: f32, y: f32, z: f32) -> ScarpFlow {
    return scarp_curl_in_space(scarp_vector3(plan, x, y, z));
}

/* The chain rule over samples. */

/* a b, but 0 where a or b is 0, whatever the other one is. */
fn scarp_term(a: f32, b: f32) -> f32 {
    return scarp_either(a == 0.0f || b == 0.0f, 0.0f, scarp_mul(a, b));
}

fn scarp_terms(a: f32, b: vec3f) -> vec3f {
    return vec3f(scarp_term(a, b.x), scarp_term(a, b.y), scarp_term(a, b.z));
}

/* a_i b_j + a_j b_i */
fn scarp_crossed(ai: f32, aj: f32, bi: f32, bj: f32) -> f32 {
    return scarp_add(scarp_term(ai, bj), scarp_term(aj, bi));
}

/* a b, as scarp_multiply */
fn scarp_chain_multiply(a: ScarpSample, b: ScarpSample) -> ScarpSample {
    let g: vec3f = a.gradient;
    let h: vec3f = b.gradient;
    let diagonal: vec3f = scarp_add3(scarp_terms(b.value, a.diagonal), scarp_terms(a.value,
            b.diagonal));
    let mixed: vec3f = scarp_add3(scarp_terms(b.value, a.mixed), scarp_terms(a.value, b.mixed));
    return scarp_sample_of(scarp_term(a.value, b.value), scarp_add3(scarp_terms(b.value, g),
            scarp_terms(a.value, h)), scarp_add3(diagonal, vec3f(scarp_crossed(g.x, g.x, h.x, h.x),
            scarp_crossed(g.y, g.y, h.y, h.y), scarp_crossed(g.z, g.z, h.z, h.z))),
            scarp_add3(mixed, vec3f(scarp_crossed(g.x, g.y, h.x, h.y), scarp_crossed(g.x, g.z, h.x,
            h.z), scarp_crossed(g.y, g.z, h.y, h.z))));
}

/* a + m (b - a), as scarp_mix */
fn scarp_chain_mix(a: ScarpSample, b: ScarpSample, m: ScarpSample) -> ScarpSample {
    var nearer: ScarpSample = a;
    var share: ScarpSample = m;
    if (m.value > 0.5f) {
        nearer = b;
        share.value = scarp_sub(m.value, 1.0f);
    }
    return scarp_difference_of(nearer, scarp_chain_multiply(scarp_difference_of(a, b), share));
}

/* scale a + offset */
fn scarp_chain_affine(a: ScarpSample, scale: f32, offset: f32) -> ScarpSample {
    var s: ScarpSample = scarp_scaled(a, scale, scale, scale);
    s.value = scarp_add(s.value, offset);
    return s;
}

/* Where b is NaN, so is the lesser, or the greater, of a and b. */
fn scarp_chain_min(a: ScarpSample, b: ScarpSample) -> ScarpSample {
    var s: ScarpSample = a;
    if (b.value < a.value || b.value != b.value) {
        s = b;
    }
    return s;
}

fn scarp_chain_max(a: ScarpSample, b: ScarpSample) -> ScarpSample {
    var s: ScarpSample = a;
    if (a.value < b.value || b.value != b.value) {
        s = b;
    }
    return s;
}

/* f_aa a_i a_j of a gradient a */
fn scarp_squares_of(faa: f32, a: vec3f) -> vec3f {
    return vec3f(scarp_mul(scarp_mul(faa, a.x), a.x), scarp_mul(scarp_mul(faa, a.y), a.y),
            scarp_mul(scarp_mul(faa, a.z), a.z));
}

fn scarp_products_of(faa: f32, a: vec3f) -> vec3f {
    return vec3f(scarp_mul(scarp_mul(faa, a.x), a.y), scarp_mul(scarp_mul(faa, a.x), a.z),
            scarp_mul(scarp_mul(faa, a.y), a.z));
}

/* f(a), of which f_a and f_aa are the derivatives; as scarp_apply1 */
fn scarp_chain_apply1(a: ScarpSample, f: f32, fa: f32, faa: f32) -> ScarpSample {
    let first: ScarpSample = scarp_scaled(a, 0.0f, fa, fa);
    return scarp_sample_of(f, first.gradient, scarp_add3(first.diagonal, scarp_squares_of(faa,
            a.gradient)), scarp_add3(first.mixed, scarp_products_of(faa, a.gradient)));
}

/* A function of two samples, and its partial derivatives. */
struct ScarpPartials {
    f: f32,
    a: f32,
    b: f32,
    aa: f32,
    ab: f32,
    bb: f32,
}

/* f(a, b), as scarp_apply2 */
fn scarp_chain_apply2(a: ScarpSample, b: ScarpSample, p: ScarpPartials) -> ScarpSample {
    let g: vec3f = a.gradient;
    let h: vec3f = b.gradient;
    let diagonal: vec3f = scarp_add3(scarp_mul3(p.a, a.diagonal), scarp_mul3(p.b, b.diagonal));
    let mixed: vec3f = scarp_add3(scarp_mul3(p.a, a.mixed), scarp_mul3(p.b, b.mixed));
    return scarp_sample_of(p.f, scarp_add3(scarp_mul3(p.a, g), scarp_mul3(p.b, h)),
            scarp_add3(scarp_add3(diagonal, scarp_add3(scarp_squares_of(p.aa, g),
            scarp_squares_of(p.bb, h))), scarp_mul3(p.ab, scarp_crossed_diagonal(g, h))),
            scarp_add3(scarp_add3(mixed, scarp_add3(scarp_products_of(p.aa, g),
            scarp_products_of(p.bb, h))), scarp_mul3(p.ab, scarp_crossed_mixed(g, h))));
}

/* f(a) without second derivatives of f */
fn scarp_chain_straight(a: ScarpSample, f: f32, fa: f32) -> ScarpSample {
    var s: ScarpSample = scarp_scaled(a, 0.0f, fa, fa);
    s.value = f;
    return s;
}

/* The lesser, or the greater, of a and b, rounded where they differ by less than a width; k is that
   of the two functions below. */
fn scarp_smooth_of(a: ScarpSample, b: ScarpSample, takes_b: bool, k: vec3f) -> ScarpSample {
    let left: f32 = scarp_sub(1.0f, scarp_mul(scarp_magnitude(scarp_sub(a.value, b.value)), k.x));
    let h: f32 = scarp_either(left < 0.0f, 0.0f, left);
    let half_weight: f32 = scarp_mul(0.5f, scarp_mul(h, h));
    let rest: f32 = scarp_sub(1.0f, half_weight);
    let of_a: f32 = scarp_either(takes_b, half_weight, rest);
    let of_b: f32 = scarp_either(takes_b, rest, half_weight);
    let d: vec3f = scarp_sub3(a.gradient, b.gradient);
    let bend: f32 = scarp_mul(h, k.z);
    let diagonal: vec3f = scarp_add3(scarp_mul3(of_a, a.diagonal), scarp_mul3(of_b, b.diagonal));
    let mixed: vec3f = scarp_add3(scarp_mul3(of_a, a.mixed), scarp_mul3(of_b, b.mixed));
    return scarp_sample_of(scarp_sub(scarp_either(takes_b, b.value, a.value),
            scarp_mul(scarp_mul(scarp_mul(h, h), h), k.y)), scarp_add3(scarp_mul3(of_a, a.gradient),
            scarp_mul3(of_b, b.gradient)), scarp_add3(diagonal, scarp_squares_of(bend, d)),
            scarp_add3(mixed, scarp_products_of(bend, d)));
}

/* k: 1 / k, k / 6, -1 / k of the width k */
fn scarp_chain_smooth_min(a: ScarpSample, b: ScarpSample, k: vec3f) -> ScarpSample {
    return scarp_smooth_of(a, b, b.value < a.value || b.value != b.value, k);
}

/* k: 1 / k, -k / 6, 1 / k of the width k */
fn scarp_chain_smooth_max(a: ScarpSample, b: ScarpSample, k: vec3f) -> ScarpSample {
    return scarp_smooth_of(a, b, a.value < b.value || b.value != b.value, k);
}

fn scarp_chain_clamp(a: ScarpSample, lo: f32, hi: f32) -> ScarpSample {
    let v: f32 = a.value;
    let f: f32 = scarp_either(v < lo, lo, scarp_either(v > hi, hi, v));
    return scarp_chain_straight(a, f, scarp_either(v < lo || v > hi, 0.0f, scarp_add(1.0f,
            scarp_sub(v, v))));
}

fn scarp_chain_abs(a: ScarpSample) -> ScarpSample {
    let v: f32 = a.value;
    let down: f32 = scarp_either(v < 0.0f, -1.0f, scarp_sub(v, v)); /* 0, or NaN */
    return scarp_chain_straight(a, scarp_magnitude(v), scarp_either(v > 0.0f, 1.0f, down));
}

fn scarp_within_unit(t: f32) -> f32 {
    return scarp_either(t < 0.0f, 0.0f, scarp_either(t > 1.0f, 1.0f, t));
}

/* The quintic fade may exceed 1 by 2^-23. */
fn scarp_step_fade(t: f32) -> ScarpFade {
    var s: ScarpFade = scarp_fade(SCARP_QUINTIC, t);
    s.u = scarp_either(s.u > 1.0f, 1.0f, s.u);
    return s;
}

/* The step from lo to hi; `by` is 1 / (hi - lo). */
fn scarp_chain_smoothstep(a: ScarpSample, lo: f32, by: f32) -> ScarpSample {
    let s: ScarpFade = scarp_step_fade(scarp_within_unit(scarp_mul(scarp_sub(a.value, lo), by)));
    return scarp_chain_apply1(a, s.u, scarp_mul(s.du, by), scarp_mul(scarp_mul(s.ddu, by), by));
}

/* k: how many steps, 1 / steps, 1 / riser, strength */
fn scarp_chain_terrace(a: ScarpSample, k: vec4f) -> ScarpSample {
    let t: f32 = scarp_mul(a.value, k.x);
    let whole: f32 = floor(t);
    let u: f32 = scarp_sub(t, whole);
    let s: ScarpFade = scarp_step_fade(scarp_within_unit(scarp_add(scarp_mul(scarp_sub(u, 0.5f),
            k.z), 0.5f)));
    let rise: f32 = scarp_add(u, scarp_mul(k.w, scarp_sub(s.u, u)));
    return scarp_chain_apply1(a, scarp_mul(scarp_add(whole, rise), k.y), scarp_add(1.0f,
            scarp_mul(k.w, scarp_sub(scarp_mul(s.du, k.z), 1.0f))),
            scarp_mul(scarp_mul(scarp_mul(scarp_mul(s.ddu, k.z), k.z), k.x), k.w));
}

/* sqrt(a^2 + round^2) */
fn scarp_chain_smooth_abs(a: ScarpSample, round: f32, round2: f32) -> ScarpSample {
    let f: f32 = scarp_root(scarp_add(scarp_mul(a.value, a.value), round2));
    let by: f32 = scarp_inverse(f);
    let share: f32 = scarp_mul(round, by);
    return scarp_chain_apply1(a, f, scarp_mul(a.value, by), scarp_mul(scarp_mul(share, share), by));
}

/* More functions over samples. */

/* The root of a, 0 where that is negative. */
fn scarp_chain_sqrt(a: ScarpSample) -> ScarpSample {
    let v: f32 = scarp_either(a.value < 0.0f, 0.0f, a.value);
    let f: f32 = scarp_root(v);
    let is_flat: bool = f == 0.0f;
    let slope: f32 = scarp_mul(0.5f, scarp_inverse(scarp_either(is_flat, 1.0f, f)));
    let bend: f32 = scarp_mul(slope, scarp_mul(0.5f, scarp_inverse(scarp_either(is_flat, 1.0f,
            v))));
    return scarp_chain_apply1(a, f, scarp_either(is_flat, 0.0f, slope), scarp_either(is_flat, 0.0f,
            -bend));
}

/* a / b, where b is not 0. */
fn scarp_chain_divide(a: ScarpSample, b: ScarpSample) -> ScarpSample {
    let by: f32 = scarp_with_bit(scarp_inverse(scarp_magnitude(b.value)),
            bitcast<u32>(b.value) >> 31u);
    let f: f32 = scarp_quotient(a.value, b.value);
    let p: ScarpPartials = ScarpPartials(f, by, -scarp_mul(f, by), 0.0f, -scarp_mul(by, by),
            scarp_mul(scarp_mul(2.0f, scarp_mul(f, by)), by));
    return scarp_chain_apply2(a, b, p);
}

/* a folded to and fro: -1 at even numbers, 1 at odd ones. All floats of 2^24 and more are even. */
fn scarp_chain_pulse(a: ScarpSample) -> ScarpSample {
    let v: f32 = scarp_either(scarp_magnitude(a.value) < 16777216.0f, a.value, 0.0f);
    let lower: f32 = floor(v);
    let fraction: f32 = scarp_sub(v, lower);
    let up: f32 = scarp_sub(scarp_mul(2.0f, fraction), 1.0f);
    let is_odd: bool = (i32(lower) & 1) != 0;
    let slope: f32 = scarp_either(is_odd, -2.0f, 2.0f);
    return scarp_chain_straight(a, scarp_either(is_odd, -up, up), scarp_either(fraction == 0.0f,
            0.0f, slope));
}

/* The length of the gradient; no Hessian. */
fn scarp_chain_slope(a: ScarpSample, dimensions: i32) -> ScarpSample {
    let h: ScarpRows = scarp_hessian_of(a);
    let length: f32 = scarp_root(scarp_dot(a.gradient, a.gradient, dimensions));
    let by: f32 = scarp_either(length == 0.0f, 1.0f, length);
    let sums: vec3f = scarp_times(h, a.gradient, dimensions);
    var s: ScarpSample = scarp_constant(length);
    if (length != 0.0f) {
        s.gradient = vec3f(scarp_quotient(sums.x, by), scarp_quotient(sums.y, by),
                scarp_quotient(sums.z, by));
    }
    return s;
}

/* A piece of a curve at a. k and l are the knots around it, `first` and `last` those at the ends:
   x, value, slope, 1 / (the next x - x). */
fn scarp_chain_curve(a: ScarpSample, k: vec4f, l: vec4f, first: vec4f, last: vec4f) -> ScarpSample {
    let width: f32 = scarp_sub(l.x, k.x);
    let t: f32 = scarp_mul(scarp_sub(a.value, k.x), k.w);
    let rise: f32 = scarp_sub(l.y, k.y);
    let s0: f32 = scarp_mul(k.z, width);
    let s1: f32 = scarp_mul(l.z, width);
    let c2: f32 = scarp_sub(scarp_sub(scarp_mul(3.0f, rise), scarp_mul(2.0f, s0)), s1);
    let c3: f32 = scarp_sub(scarp_add(s0, s1), scarp_mul(2.0f, rise));
    let lowest: f32 = scarp_either(k.y < l.y, k.y, l.y);
    let highest: f32 = scarp_either(k.y < l.y, l.y, k.y);
    let v: f32 = scarp_add(k.y, scarp_mul(t, scarp_add(s0, scarp_mul(t, scarp_add(c2, scarp_mul(t,
            c3))))));
    let held: f32 = scarp_either(v < lowest, lowest, scarp_either(v > highest, highest, v));
    let is_before: bool = a.value <= first.x;
    let is_behind: bool = a.value >= last.x;
    let is_level: bool = is_before || is_behind;
    let slope: f32 = scarp_mul(scarp_add(s0, scarp_mul(t, scarp_add(scarp_mul(2.0f, c2),
            scarp_mul(t, scarp_mul(3.0f, c3))))), k.w);
    let bend: f32 = scarp_mul(scarp_mul(scarp_add(scarp_mul(2.0f, c2), scarp_mul(t, scarp_mul(6.0f,
            c3))), k.w), k.w);
    return scarp_chain_apply1(a, scarp_either(is_before, first.y, scarp_either(is_behind, last.y,
            held)), scarp_either(is_level, 0.0f, slope), scarp_either(is_level, 0.0f, bend));
}

/* The sine, as calls/partials. */

/* (2^32 high + low) / 2^64, or / 2^63 where that is said. */
struct ScarpWide {
    high: u32,
    low: u32,
}

fn scarp_wide_of(high: u32, low: u32) -> ScarpWide {
    let w: ScarpWide = ScarpWide(high, low);
    return w;
}

/* The product of two uints. */
fn scarp_product_of_words(a: u32, b: u32) -> ScarpWide {
    let al: u32 = a & 0xffffu;
    let ah: u32 = a >> 16u;
    let bl: u32 = b & 0xffffu;
    let bh: u32 = b >> 16u;
    let low: u32 = al * bl;
    let left: u32 = ah * bl;
    let right: u32 = al * bh;
    let middle: u32 = (low >> 16u) + (left & 0xffffu) + (right & 0xffffu);
    return scarp_wide_of(ah * bh + (left >> 16u) + (right >> 16u) + (middle >> 16u), (low
            & 0xffffu) | (middle << 16u));
}

fn scarp_sum_of_wides(a: ScarpWide, b: ScarpWide) -> ScarpWide {
    let low: u32 = a.low + b.low;
    let carry: u32 = select(0u, 1u, low < a.low);
    return scarp_wide_of(a.high + b.high + carry, low);
}

/* a - b, which is not below 0 */
fn scarp_difference_of_wides(a: ScarpWide, b: ScarpWide) -> ScarpWide {
    let borrow: u32 = select(0u, 1u, a.low < b.low);
    return scarp_wide_of(a.high - b.high - borrow, a.low - b.low);
}

/* a b, up to 2 units too small: without the product of the lower halves. */
fn scarp_product_of_wides(a: ScarpWide, b: ScarpWide) -> ScarpWide {
    let left: ScarpWide = scarp_product_of_words(a.high, b.low);
    let right: ScarpWide = scarp_product_of_words(a.low, b.high);
    let sum: ScarpWide = scarp_sum_of_wides(scarp_product_of_words(a.high, b.high),
            scarp_wide_of(0u, left.high));
    return scarp_sum_of_wides(sum, scarp_wide_of(0u, right.high));
}

/* c - z rest: a step of a series. `is_cosine` chooses the coefficient. */
fn scarp_step_of_series(z: ScarpWide, rest: ScarpWide, is_cosine: bool, of_sine: ScarpWide,
        of_cosine: ScarpWide) -> ScarpWide {
    var c: ScarpWide = of_sine;
    if (is_cosine) {
        c = of_cosine;
    }
    return scarp_difference_of_wides(c, scarp_product_of_wides(z, rest));
}

/* The Taylor series of the cosine of x, or of the sine over x, times 2^63, of z = x^2 2^64. */
fn scarp_series_of(z: ScarpWide, is_cosine: bool) -> ScarpWide {
    var s: ScarpWide = scarp_wide_of(0u, select(0x0000654bu, 0x0006b9fdu, is_cosine));
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
fn scarp_float_of_wide(w: ScarpWide, e: i32) -> f32 {
    var m: ScarpWide = w;
    var exponent: i32 = e;
    for (var i: i32 = 0; i < 4 && m.high < 0x80000000u; i++) {
        m = scarp_wide_of((m.high << 1u) | (m.low >> 31u), m.low << 1u);
        exponent = exponent - 1;
    }
    let q: u32 = (m.high >> 8u) + ((m.high >> 7u) & 1u);
    let rounded: f32 = bitcast<f32>((bitcast<u32>(exponent + 125) << 23u) + q);
    return select(rounded, 0.0f, exponent < -120);
}

/* a / 2^steps, steps below 64; or 4 a where they are -2. */
fn scarp_shifted(a: ScarpWide, steps: i32) -> ScarpWide {
    let by: u32 = bitcast<u32>(steps) & 31u;
    let crossing: u32 = select(a.high << (32u - by), 0u, by == 0u);
    var w: ScarpWide = scarp_wide_of(a.high >> by, (a.low >> by) | crossing);
    if (steps >= 32) {
        w = scarp_wide_of(0u, a.high >> by);
    }
    if (steps < 0) {
        w = scarp_wide_of((a.high << 2u) | (a.low >> 30u), a.low << 2u);
    }
    return w;
}

/* (pi / 2)^2 is this times 4 / 2^64. */
const SCARP_PI2_HIGH: u32 = 0x9de9e64du;
const SCARP_PI2_LOW: u32 = 0xf22ef2d2u;

/* c 2^e times the cosine of r quarters, or the sine of them, for which c is given times pi / 2;
   -1/2 <= r <= 1/2. */
fn scarp_quarter_wave(r: f32, is_cosine: bool, c: ScarpWide, e: i32) -> f32 {
    let bits: u32 = bitcast<u32>(r) & 0x7fffffffu;
    let exponent: i32 = bitcast<i32>(bits >> 23u) - 126; /* r is its mantissa / 2^24, times 2^exponent */
    let m: ScarpWide = scarp_wide_of((bits << 8u) | 0x80000000u, 0u);
    var z: ScarpWide = scarp_wide_of(0u, 0u);
    if (exponent > -32) {
        z = scarp_product_of_wides(scarp_product_of_wides(m, m), scarp_wide_of(SCARP_PI2_HIGH,
                SCARP_PI2_LOW));
        z = scarp_shifted(z, -2 * exponent - 2);
    }
    let wave: ScarpWide = scarp_product_of_wides(scarp_series_of(z, is_cosine), c);
    var value: f32 = scarp_float_of_wide(wave, e + 1);
    if (!is_cosine) {
        value = scarp_with_bit(scarp_float_of_wide(scarp_product_of_wides(wave, m),
                e + 1 + exponent), bitcast<u32>(r) >> 31u);
    }
    return value;
}

/* A sine of so many whole quarters and r of one, times 1, 2 pi or 4 pi^2: by `power` of 2 pi. */
fn scarp_sine_of_quarters(whole: i32, r: f32, power: i32) -> f32 {
    let is_cosine: bool = (whole & 1) != 0;
    var c: ScarpWide = scarp_wide_of(0x80000000u, 0u); /* 1 */
    var e: i32 = 1;
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
    return scarp_with_bit(scarp_quarter_wave(r, is_cosine, c, e), (bitcast<u32>(whole) >> 1u) & 1u);
}

/* The sine of a turns. All floats of 2^24 and more are whole numbers of turns. */
fn scarp_chain_sine(a: ScarpSample) -> ScarpSample {
    let v: f32 = scarp_either(scarp_magnitude(a.value) < 16777216.0f, a.value, 0.0f);
    let quarters: f32 = scarp_mul(4.0f, v);
    let below: i32 = i32(quarters);
    let rest: f32 = scarp_sub(quarters, f32(below));
    var whole: i32 = below;
    var r: f32 = rest;
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

const SCARP_GULLY_TAU2: f32 = 0.0025f; /* of tau = 0.05, where the direction of flat ground is soft */
const SCARP_GULLY_EPS2: f32 = 0.25f; /* of eps = 0.5, where waves of corners cancel */

/* Two numbers along x and y, or the parts of a complex number. */
struct ScarpPair2 {
    x: f32,
    y: f32,
}

/* A number with its derivatives along x and y. */
struct ScarpJet {
    value: f32,
    d: ScarpPair2,
}

/* A pair with its derivatives. */
struct ScarpPairJet {
    value: ScarpPair2,
    dx: ScarpPair2,
    dy: ScarpPair2,
}

fn scarp_pair_of(x: f32, y: f32) -> ScarpPair2 {
    let p: ScarpPair2 = ScarpPair2(x, y);
    return p;
}

fn scarp_sum2(a: ScarpPair2, b: ScarpPair2) -> ScarpPair2 {
    return scarp_pair_of(scarp_add(a.x, b.x), scarp_add(a.y, b.y));
}

fn scarp_difference2(a: ScarpPair2, b: ScarpPair2) -> ScarpPair2 {
    return scarp_pair_of(scarp_sub(a.x, b.x), scarp_sub(a.y, b.y));
}

fn scarp_scaled2(a: f32, b: ScarpPair2) -> ScarpPair2 {
    return scarp_pair_of(scarp_mul(a, b.x), scarp_mul(a, b.y));
}

fn scarp_dot2(a: ScarpPair2, b: ScarpPair2) -> f32 {
    return scarp_add(scarp_mul(a.x, b.x), scarp_mul(a.y, b.y));
}

/* a + u (b - a) */
fn scarp_mix2(a: ScarpPair2, b: ScarpPair2, u: f32) -> ScarpPair2 {
    return scarp_sum2(a, scarp_scaled2(u, scarp_difference2(b, a)));
}

/* a p + b q */
fn scarp_combined2(a: f32, p: ScarpPair2, b: f32, q: ScarpPair2) -> ScarpPair2 {
    return scarp_sum2(scarp_scaled2(a, p), scarp_scaled2(b, q));
}

/* The product of complex numbers; of a turn and a vector: the vector, turned. */
fn scarp_product2(a: ScarpPair2, b: ScarpPair2) -> ScarpPair2 {
    return scarp_pair_of(scarp_sub(scarp_mul(a.x, b.x), scarp_mul(a.y, b.y)),
            scarp_add(scarp_mul(a.x, b.y), scarp_mul(a.y, b.x)));
}

/* The constants of a call. */
struct ScarpGullyShape {
    low: f32,
    steepness: f32, /* where the step from floors to crests begins; 1 / its width */
    slope2: f32,
    slope2_low: f32, /* slopes where gullies have half their strength, squared */
    lowered: f32, /* 1 + floor */
    round: f32,
    round2: f32, /* and its square */
    fall: f32, /* 2 / (sqrt(1 + round^2) - round) */
    branch: f32,
}

/* The constants of an octave, whose axes are turned by R. */
struct ScarpGullyOctave {
    weight: f32, /* of v_k */
    keep: f32, /* 0 of the first octave */
    waves: ScarpPair2, /* stripes R */
    angles: ScarpPair2, /* 2 pi stripes R */
    cells: ScarpPair2, /* f_k R */
    stretch: f32, /* 2 pi stripes f_k */
}

/* What goes from octave to octave. */
struct ScarpGully {
    slope: ScarpPairJet,
    steep: ScarpJet,
    exposure: ScarpJet,
    sum: ScarpJet,
}

/* The base at a point: its height, its gradient and its Hessian. */
struct ScarpGullyBase {
    value: f32,
    dx: f32,
    dy: f32,
    dxx: f32,
    dxy: f32,
    dyy: f32,
}

/* The smooth step of the height from floors, 0, to crests, 1. */
fn scarp_height_of(g: ScarpGullyShape, b: ScarpGullyBase) -> ScarpJet {
    let raw: f32 = scarp_mul(scarp_sub(b.value, g.low), g.steepness);
    let above: f32 = scarp_either(raw < 0.0f, 0.0f, raw);
    let z: f32 = scarp_either(above > 1.0f, 1.0f, above);
    let by: f32 = scarp_mul(scarp_mul(scarp_mul(6.0f, z), scarp_sub(1.0f, z)), g.steepness);
    let h: ScarpJet = ScarpJet(scarp_mul(scarp_mul(z, z), scarp_sub(3.0f, scarp_mul(2.0f, z))),
            ScarpPair2(scarp_mul(by, b.dx), scarp_mul(by, b.dy)));
    return h;
}

fn scarp_gully_begin(g: ScarpGullyShape, b: ScarpGullyBase) -> ScarpGully {
    let h: ScarpJet = scarp_height_of(g, b);
    let gradient: ScarpPair2 = ScarpPair2(b.dx, b.dy);
    let rest: f32 = scarp_sub(1.0f, h.value);
    let slope2: f32 = scarp_add(scarp_mul(rest, g.slope2_low), scarp_mul(h.value, g.slope2));
    let unit: f32 = scarp_inverse(scarp_root(scarp_add(scarp_dot2(gradient, gradient), slope2)));
    let s: ScarpPair2 = scarp_scaled2(unit, gradient);
    let by: f32 = scarp_mul(scarp_mul(0.5f, unit), scarp_sub(g.slope2, g.slope2_low));
    let hx: f32 = scarp_add(scarp_add(scarp_mul(s.x, b.dxx), scarp_mul(s.y, b.dxy)), scarp_mul(by,
            h.d.x));
    let hy: f32 = scarp_add(scarp_add(scarp_mul(s.x, b.dxy), scarp_mul(s.y, b.dyy)), scarp_mul(by,
            h.d.y));
    let sx: ScarpPair2 = scarp_scaled2(unit, scarp_pair_of(scarp_sub(b.dxx, scarp_mul(s.x, hx)),
            scarp_sub(b.dxy, scarp_mul(s.y, hx))));
    let sy: ScarpPair2 = scarp_scaled2(unit, scarp_pair_of(scarp_sub(b.dxy, scarp_mul(s.x, hy)),
            scarp_sub(b.dyy, scarp_mul(s.y, hy))));
    let state: ScarpGully = ScarpGully(ScarpPairJet(s, sx, sy), ScarpJet(scarp_dot2(s, s),
            ScarpPair2(scarp_mul(2.0f, scarp_dot2(s, sx)), scarp_mul(2.0f, scarp_dot2(s, sy)))),
            ScarpJet(scarp_sub(1.0f, scarp_mul(rest, g.lowered)), scarp_scaled2(g.lowered, h.d)),
            ScarpJet(0.0f, ScarpPair2(0.0f, 0.0f)));
    return state;
}

/* sin(2 pi b), |b| <= 1/4; the error is at most 3.4e-9 before rounding. */
fn scarp_sine_of_quarter(b: f32) -> f32 {
    let z: f32 = scarp_mul(b, b);
    let p: f32 = scarp_sub(scarp_mul(scarp_add(scarp_mul(scarp_sub(scarp_mul(39.5367068f, z),
            76.5497824f), z), 81.6010040f), z), 41.3416550f);
    return scarp_mul(scarp_add(scarp_mul(p, z), 6.28318516f), b);
}

/* e^(2 pi i u), |u| < 2^22 */
fn scarp_wave_of(u: f32) -> ScarpPair2 {
    let v: f32 = scarp_sub(u, floor(scarp_add(u, 0.5f)));
    let a: f32 = scarp_magnitude(v);
    let rest: f32 = scarp_sub(0.5f, a);
    let folded: f32 = scarp_either(a < rest, a, rest);
    return scarp_pair_of(scarp_sine_of_quarter(scarp_sub(0.25f, a)),
            scarp_sine_of_quarter(scarp_either(v < 0.0f, scarp_sub(0.0f, folded), folded)));
}

/* The direction across the slope. */
fn scarp_across_slope(s: ScarpPairJet) -> ScarpPairJet {
    let unit: f32 = scarp_inverse(scarp_root(scarp_add(scarp_dot2(s.value, s.value),
            SCARP_GULLY_TAU2)));
    let t: ScarpPair2 = ScarpPair2(scarp_mul(s.value.y, scarp_sub(0.0f, unit)), scarp_mul(s.value.x,
            unit));
    let ex: ScarpPair2 = scarp_scaled2(unit, s.dx);
    let ey: ScarpPair2 = scarp_scaled2(unit, s.dy);
    let bx: f32 = scarp_sub(scarp_mul(t.y, ex.x), scarp_mul(t.x, ex.y));
    let by: f32 = scarp_sub(scarp_mul(t.y, ey.x), scarp_mul(t.x, ey.y));
    let across: ScarpPairJet = ScarpPairJet(t, ScarpPair2(scarp_sub(0.0f, scarp_add(scarp_mul(t.x,
            bx), ex.y)), scarp_sub(ex.x, scarp_mul(t.y, bx))), ScarpPair2(scarp_sub(0.0f,
            scarp_add(scarp_mul(t.x, by), ey.y)), scarp_sub(ey.x, scarp_mul(t.y, by))));
    return across;
}

/* The wave of a corner: `waves` is how many lie between the point and it. */
fn scarp_corner_wave(hash: u32, waves: f32) -> ScarpPair2 {
    return scarp_wave_of(scarp_add(scarp_mul(scarp_lattice_value(hash), 2.32830644e-10f), waves));
}

/* The derivative of Z along an axis: of the weights, and of the waves, which turn with t and with
   its derivative d. */
fn scarp_blend_slope(by_weights: ScarpPair2, t: f32, d: ScarpPair2, z: ScarpPair2,
        moment_x: ScarpPair2, moment_y: ScarpPair2) -> ScarpPair2 {
    let turn: ScarpPair2 = scarp_sum2(scarp_scaled2(t, z), scarp_combined2(d.x, moment_x, d.y,
            moment_y));
    return scarp_pair_of(scarp_sub(by_weights.x, turn.y), scarp_add(by_weights.y, turn.x));
}

/* The blend Z of an octave. */
fn scarp_blend_of(l: ScarpLattice, o: ScarpGullyOctave, p: ScarpLocation,
        t: ScarpPairJet) -> ScarpPairJet {
    let fx: ScarpFade = scarp_fade(SCARP_QUINTIC, p.t.x);
    let fy: ScarpFade = scarp_fade(SCARP_QUINTIC, p.t.y);
    let q: ScarpPair2 = scarp_product2(o.waves, t.value);
    let waves: f32 = scarp_add(scarp_mul(q.x, p.t.x), scarp_mul(q.y, p.t.y));
    let waves_y: f32 = scarp_sub(waves, q.y);
    let c00: ScarpPair2 = scarp_corner_wave(scarp_hash2(l.key, p.cell.x, p.cell.y), waves);
    let c10: ScarpPair2 = scarp_corner_wave(scarp_hash2(l.key, p.next.x, p.cell.y), scarp_sub(waves,
            q.x));
    let c01: ScarpPair2 = scarp_corner_wave(scarp_hash2(l.key, p.cell.x, p.next.y), waves_y);
    let c11: ScarpPair2 = scarp_corner_wave(scarp_hash2(l.key, p.next.x, p.next.y),
            scarp_sub(waves_y, q.x));
    let left: ScarpPair2 = scarp_mix2(c00, c01, fy.u);
    let right: ScarpPair2 = scarp_mix2(c10, c11, fy.u);
    let z: ScarpPair2 = scarp_mix2(left, right, fx.u);
    let top: ScarpPair2 = scarp_mix2(c01, c11, fx.u);
    let by_x: ScarpPair2 = scarp_scaled2(fx.du, scarp_difference2(right, left));
    let by_y: ScarpPair2 = scarp_scaled2(fy.du, scarp_mix2(scarp_difference2(c01, c00),
            scarp_difference2(c11, c10), fx.u));
    /* the sums of W (p - c) */
    let moment_x: ScarpPair2 = scarp_difference2(scarp_scaled2(p.t.x, z), scarp_scaled2(fx.u,
            right));
    let moment_y: ScarpPair2 = scarp_difference2(scarp_scaled2(p.t.y, z), scarp_scaled2(fy.u, top));
    /* in the axes of the input */
    let mx: ScarpPair2 = scarp_combined2(o.angles.x, moment_x, o.angles.y, moment_y);
    let my: ScarpPair2 = scarp_combined2(o.angles.x, moment_y, scarp_sub(0.0f, o.angles.y),
            moment_x);
    let wx: ScarpPair2 = scarp_combined2(o.cells.x, by_x, o.cells.y, by_y);
    let wy: ScarpPair2 = scarp_combined2(o.cells.x, by_y, scarp_sub(0.0f, o.cells.y), by_x);
    let blend: ScarpPairJet = ScarpPairJet(z, scarp_blend_slope(wx, scarp_mul(o.stretch, t.value.x),
            t.dx, z, mx, my), scarp_blend_slope(wy, scarp_mul(o.stretch, t.value.y), t.dy, z, mx,
            my));
    return blend;
}

/* The derivative d of a blend, once this is divided by its length: `w` is the quotient. */
fn scarp_quotient_slope(w: ScarpPair2, d: ScarpPair2, unit: f32) -> ScarpPair2 {
    let e: ScarpPair2 = scarp_scaled2(unit, d);
    return scarp_difference2(e, scarp_scaled2(scarp_dot2(w, e), w));
}

fn scarp_normalised(z: ScarpPairJet) -> ScarpPairJet {
    let unit: f32 = scarp_inverse(scarp_root(scarp_add(scarp_dot2(z.value, z.value),
            SCARP_GULLY_EPS2)));
    let w: ScarpPair2 = scarp_scaled2(unit, z.value);
    let n: ScarpPairJet = ScarpPairJet(w, scarp_quotient_slope(w, z.dx, unit),
            scarp_quotient_slope(w, z.dy, unit));
    return n;
}

/* The profile of a stripe, P(C). */
fn scarp_profile_of(g: ScarpGullyShape, w: ScarpPairJet) -> ScarpJet {
    let r: f32 = scarp_root(scarp_add(scarp_mul(scarp_sub(1.0f, w.value.x), 0.5f), g.round2));
    let by: f32 = scarp_mul(scarp_mul(0.25f, g.fall), scarp_inverse(r));
    let p: ScarpJet = ScarpJet(scarp_sub(1.0f, scarp_mul(scarp_sub(r, g.round), g.fall)),
            ScarpPair2(scarp_mul(by, w.dx.x), scarp_mul(by, w.dy.x)));
    return p;
}

/* Adds an octave at a point of its lattice. */
fn scarp_gully_octave_at(g: ScarpGullyShape, o: ScarpGullyOctave, l: ScarpLattice, p: ScarpLocation,
        state: ScarpGully) -> ScarpGully {
    let t: ScarpPairJet = scarp_across_slope(state.slope);
    let w: ScarpPairJet = scarp_normalised(scarp_blend_of(l, o, p, t));
    let height: ScarpJet = scarp_profile_of(g, w);
    let v: ScarpJet = state.exposure;
    let kept: f32 = scarp_mul(o.keep, v.value);
    let rest: f32 = scarp_sub(1.0f, scarp_mul(kept, v.value));
    let m: f32 = scarp_mul(state.steep.value, rest);
    let fall: f32 = scarp_mul(scarp_mul(2.0f, state.steep.value), kept);
    let dm: ScarpPair2 = scarp_combined2(rest, state.steep.d, scarp_sub(0.0f, fall), v.d);
    let d: f32 = scarp_sub(height.value, v.value);
    let next: ScarpJet = ScarpJet(scarp_add(v.value, scarp_mul(m, d)), scarp_sum2(v.d,
            scarp_combined2(d, dm, m, scarp_difference2(height.d, v.d))));
    let by: f32 = scarp_sub(0.0f, scarp_mul(scarp_mul(g.branch, m), w.value.y));
    let by_x: f32 = scarp_sub(0.0f, scarp_mul(g.branch, scarp_add(scarp_mul(dm.x, w.value.y),
            scarp_mul(m, w.dx.y))));
    let by_y: f32 = scarp_sub(0.0f, scarp_mul(g.branch, scarp_add(scarp_mul(dm.y, w.value.y),
            scarp_mul(m, w.dy.y))));
    let after: ScarpGully = ScarpGully(ScarpPairJet(scarp_sum2(state.slope.value, scarp_scaled2(by,
            t.value)), scarp_sum2(state.slope.dx, scarp_combined2(by_x, t.value, by, t.dx)),
            scarp_sum2(state.slope.dy, scarp_combined2(by_y, t.value, by, t.dy))), state.steep,
            next, ScarpJet(scarp_add(state.sum.value, scarp_mul(o.weight, next.value)),
            scarp_sum2(state.sum.d, scarp_scaled2(o.weight, next.d))));
    return after;
}

/* Steps of recipes, which scarp_recipe_shader calls. */

/* The place of a noise: m x + t, of rows that have t as their last element. */
fn scarp_placed(x: vec3f, a: vec4f, b: vec4f, c: vec4f, dimensions: i32) -> vec3f {
    let m: ScarpRows = scarp_rows_of(vec3f(a.x, a.y, a.z), vec3f(b.x, b.y, b.z), vec3f(c.x, c.y,
            c.z));
    return scarp_add3(scarp_times(m, x, dimensions), vec3f(a.w, b.w, c.w));
}

/* The rows m of a place, with the gradients of what displaces it. */
fn scarp_jacobian_with(a: vec4f, b: vec4f, c: vec4f, rest: ScarpDisplaced) -> ScarpRows {
    return scarp_rows_of(scarp_add3(vec3f(a.x, a.y, a.z), rest.x.gradient), scarp_add3(vec3f(b.x,
            b.y, b.z), rest.y.gradient), scarp_add3(vec3f(c.x, c.y, c.z), rest.z.gradient));
}

/* j_a (h j_b), and what the curvature of u adds along the gradient: over the axes of u. */
fn scarp_pulled_second(ja: vec3f, jb: vec3f, h: ScarpRows, bends: vec3f, dimensions: i32) -> f32 {
    var sum: f32 = scarp_add(scarp_mul(ja.x, scarp_mul(h.x.x, jb.x)), scarp_mul(ja.x,
            scarp_mul(h.x.y, jb.y)));
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

fn scarp_times_each(a: vec3f, b: vec3f) -> vec3f {
    return vec3f(scarp_mul(a.x, b.x), scarp_mul(a.y, b.y), scarp_mul(a.z, b.z));
}

/* A sample with derivatives with respect to u, of so many dimensions, becomes one with derivatives
   with respect to x: j are the gradients of u with respect to x, `rest` what displaces u. */
fn scarp_pulled(s: ScarpSample, j: ScarpRows, rest: ScarpDisplaced,
        dimensions: i32) -> ScarpSample {
    let h: ScarpRows = scarp_hessian_of(s);
    let by: ScarpRows = scarp_transposed(j);
    let g: vec3f = s.gradient;
    let r: ScarpDisplaced = rest;
    let xx: vec3f = vec3f(r.x.diagonal.x, r.y.diagonal.x, r.z.diagonal.x);
    let yy: vec3f = vec3f(r.x.diagonal.y, r.y.diagonal.y, r.z.diagonal.y);
    let zz: vec3f = vec3f(r.x.diagonal.z, r.y.diagonal.z, r.z.diagonal.z);
    let xy: vec3f = vec3f(r.x.mixed.x, r.y.mixed.x, r.z.mixed.x);
    let xz: vec3f = vec3f(r.x.mixed.y, r.y.mixed.y, r.z.mixed.y);
    let yz: vec3f = vec3f(r.x.mixed.z, r.y.mixed.z, r.z.mixed.z);
    return scarp_sample_of(s.value, scarp_times(by, g, dimensions), vec3f(scarp_pulled_second(by.x,
            by.x, h, scarp_times_each(g, xx), dimensions), scarp_pulled_second(by.y, by.y, h,
            scarp_times_each(g, yy), dimensions), scarp_pulled_second(by.z, by.z, h,
            scarp_times_each(g, zz), dimensions)), vec3f(scarp_pulled_second(by.x, by.y, h,
            scarp_times_each(g, xy), dimensions), scarp_pulled_second(by.x, by.z, h,
            scarp_times_each(g, xz), dimensions), scarp_pulled_second(by.y, by.z, h,
            scarp_times_each(g, yz), dimensions)));
}

/* A coordinate u of a place: its row of m, and what displaces it. */
fn scarp_coordinate_of(u: f32, row: vec4f, rest: ScarpSample) -> ScarpSample {
    var s: ScarpSample = rest;
    s.value = u;
    s.gradient = scarp_add3(vec3f(row.x, row.y, row.z), rest.gradient);
    return s;
}

/* Whether a mask is a number, 0 or 1, with all derivatives up to an order. */
fn scarp_is_level(mask: ScarpSample, number: f32, order: i32, dimensions: i32) -> bool {
    let g: vec3f = mask.gradient;
    let d: vec3f = mask.diagonal;
    let m: vec3f = mask.mixed;
    let is_plane: bool = dimensions == 2;
    let is_flat: bool = g.x == 0.0f && g.y == 0.0f && (is_plane || g.z == 0.0f);
    let is_straight: bool = d.x == 0.0f && m.x == 0.0f && d.y == 0.0f;
    let is_straight_up: bool = is_plane || (m.y == 0.0f && m.z == 0.0f && d.z == 0.0f);
    return mask.value == number && (order < 1 || is_flat) && (order < 2 || (is_straight
            && is_straight_up));
}

/* Components of a warp at y become such at x. */
fn scarp_composed_each(d: ScarpDisplaced, y: ScarpDisplaced, dimensions: i32) -> ScarpDisplaced {
    var r: ScarpDisplaced = d;
    r.x = scarp_composed(d.x, y, dimensions);
    r.y = scarp_composed(d.y, y, dimensions);
    if (dimensions == 3) {
        r.z = scarp_composed(d.z, y, dimensions);
    }
    return r;
}

/* What cells say: 0 the number of the cell, 1 and 2 the distance to the nearest feature and to the
   second. */
fn scarp_cell_sample(c: ScarpCells, what: i32) -> ScarpSample {
    var s: ScarpSample = scarp_constant(scarp_mul(scarp_lattice_value(c.id), 4.65661287e-10f));
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
fn scarp_gully_shape_of(a: vec4f, b: vec4f, c: vec4f) -> ScarpGullyShape {
    let g: ScarpGullyShape = ScarpGullyShape(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, c.x);
    return g;
}

fn scarp_gully_first(g: ScarpGullyShape, c: vec4f, base: ScarpSample) -> ScarpGully {
    let b: ScarpGullyBase = ScarpGullyBase(scarp_mul(base.value, c.y), scarp_mul(base.gradient.x,
            c.z), scarp_mul(base.gradient.y, c.z), scarp_mul(base.diagonal.x, c.w),
            scarp_mul(base.mixed.x, c.w), scarp_mul(base.diagonal.y, c.w));
    return scarp_gully_begin(g, b);
}

/* Octaves of gullies keep their own constants where noise has others: keep, stretch, and the pairs
   of waves, angles and cells. */
fn scarp_gully_with(state: ScarpGully, g: ScarpGullyShape, o: ScarpOctave, l: ScarpLevel,
        turned: bool, x: vec3f) -> ScarpGully {
    var own: ScarpGullyOctave;
    own.weight = o.weight;
    own.keep = o.turn.x;
    own.stretch = o.turn.y;
    own.waves = scarp_pair_of(o.turn.z, o.turn.w);
    own.angles = scarp_pair_of(o.gradient_x.x, o.gradient_x.y);
    own.cells = scarp_pair_of(o.gradient_y.x, o.gradient_y.y);
    let p: ScarpLocation = scarp_location_of(o, SCARP_GRADIENT, turned, x, 2);
    return scarp_gully_octave_at(g, own, scarp_lattice_of(o, l), p, state);
}

/* What gullies add to the base; a and b bring value and gradient back to its units. */
fn scarp_gully_displacement(state: ScarpGully, a: f32, b: f32) -> ScarpSample {
    var s: ScarpSample = scarp_constant(scarp_mul(a, state.sum.value));
    s.gradient = vec3f(scarp_mul(b, state.sum.d.x), scarp_mul(b, state.sum.d.y), 0.0f);
    return s;
}
