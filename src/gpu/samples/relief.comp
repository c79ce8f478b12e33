// SPDX-License-Identifier: MIT
//
// Height and slopes of the terrain of relief.c at each pixel of its picture; or what the driver
// answers to its self-test.
#version 460
#extension GL_GOOGLE_include_directive : require
#define SCARP_ONLY_BASIS 0u // SCARP_GRADIENT, of noise and warp. Their fractals differ, so that
#define SCARP_ONLY_DEPTH 1u // SCARP_ONLY_FRACTAL cannot fix them. One warp.
#include "scarp.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 0) const bool tests = false;

layout(std430, binding = 1) writeonly buffer Results
{
    uint result[]; // answers; or bits of floats: all heights, then all slopes along x, then along y
};

layout(push_constant) uniform Push
{
    uint count, width; // invocations; pixels in a row
};

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) {
        return;
    }
    if (tests) {
        result[i] = scarp_answer2(0u, 1u, i);
        return;
    }
    ScarpSample ground = scarp_sample2(0u, float(i % width), float(i / width));
    result[i] = floatBitsToUint(ground.value);
    result[count + i] = floatBitsToUint(ground.gradient.x);
    result[2u * count + i] = floatBitsToUint(ground.gradient.y);
}
