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

@STRUCTURES@
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

@ONLY@

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

@FUNCTIONS@
#endif
