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

@STRUCTURES@
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

@FUNCTIONS@
