// SPDX-License-Identifier: MIT
//
// scarp's noise for HLSL. Generated from src/gpu; do not edit.
//
//     #define SCARP_PLANS 1       // how many plans are in the constant buffer; default 1
//     #define SCARP_REGISTER b0   // where that is; default b0
//     #include "scarp.hlsl"
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
#ifndef SCARP_HLSL
#define SCARP_HLSL

#ifndef SCARP_PLANS
#define SCARP_PLANS 1
#endif
#ifndef SCARP_REGISTER
#define SCARP_REGISTER b0
#endif

@STRUCTURES@
cbuffer ScarpPlans : register(SCARP_REGISTER)
{
    ScarpPlan scarp_plan[SCARP_PLANS];
};

// 0, which compilers do not know
uint scarp_zero()
{
    return scarp_plan[0].zero;
}

@ONLY@

// One rounding each.
#ifdef SCARP_FUSE
#define SCARP_PRECISE
#else
#define SCARP_PRECISE precise
#endif

float scarp_add(float a, float b)
{
    SCARP_PRECISE float c = a + b;
    return c;
}

float scarp_sub(float a, float b)
{
    SCARP_PRECISE float c = a - b;
    return c;
}

float scarp_mul(float a, float b)
{
    SCARP_PRECISE float c = a * b;
    return c;
}

#define scarp_vec3_of(x, y, z) float3(x, y, z)
#define scarp_pick(condition, yes, no) ((condition) ? (yes) : (no))
#define scarp_pick_int(condition, yes, no) ((condition) ? (yes) : (no))
#define scarp_pick_uint(condition, yes, no) ((condition) ? (yes) : (no))
#define scarp_float_of_bits(a) asfloat(a)
#define scarp_bits_of(a) asuint(a)
#define scarp_int_of(a) asint(a)
#define scarp_uint_of(a) asuint(a)
#define scarp_float_of_int(a) float(a)
#define scarp_float_of_uint(a) float(a)
#define scarp_whole_of(a) int(a)
#define scarp_floor_of(a) floor(a)
#define scarp_rough_inverse(a) (1.0 / (a))
#define scarp_rough_root(a) sqrt(a)

@FUNCTIONS@
#endif
