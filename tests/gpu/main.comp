// SPDX-License-Identifier: MIT
//
// Samples noise at points for vulkan.c. DIMENSIONS is 2 or 3.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "scarp.glsl"

layout(local_size_x = 64) in;

// 0 to 2: outputs up to this order. 3: the answers of the self-test.
layout(constant_id = 0) const uint task = 2u;

layout(std430, binding = 1) readonly buffer Points { float point[]; };
layout(std430, binding = 2) writeonly buffer Results { uint result[]; };
layout(push_constant) uniform Push { uint count; uint order; };

void write(uint number, float x)
{
    result[number * count + gl_GlobalInvocationID.x] = floatBitsToUint(x);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) {
        return;
    }
    if (task == 3u) {
#if DIMENSIONS == 3
        result[i] = scarp_answer3(0u, order, i);
#else
        result[i] = scarp_answer2(0u, order, i);
#endif
        return;
    }
#if DIMENSIONS == 3
    ScarpSample s = scarp_sample3(0u, point[i], point[count + i], point[2u * count + i]);
#else
    ScarpSample s = scarp_sample2(0u, point[i], point[count + i]);
#endif
    write(0u, s.value); // in the order of struct scarp_samples
    if (task >= 1u) {
        write(1u, s.gradient.x);
        write(2u, s.gradient.y);
        write(3u, s.gradient.z);
    }
    if (task >= 2u) {
        write(4u, s.diagonal.x);
        write(5u, s.mixed.x);
        write(6u, s.mixed.y);
        write(7u, s.diagonal.y);
        write(8u, s.mixed.z);
        write(9u, s.diagonal.z);
    }
}
