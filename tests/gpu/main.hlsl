// SPDX-License-Identifier: MIT
//
// Samples noise at points for vulkan.c, as main.comp does. DIMENSIONS is 2 or 3.
#include "scarp.hlsl"

// 0 to 2: outputs up to this order. 3: the answers of the self-test.
[[vk::constant_id(0)]] const uint task = 2;

StructuredBuffer<float> point_of : register(t1);
RWStructuredBuffer<uint> result : register(u2);

[[vk::push_constant]] cbuffer Push { uint count; uint order; };

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID)
{
    uint i = id.x;
    if (i >= count) {
        return;
    }
    if (task == 3) {
#if DIMENSIONS == 3
        result[i] = scarp_answer3(0, order, i);
#else
        result[i] = scarp_answer2(0, order, i);
#endif
        return;
    }
#if DIMENSIONS == 3
    ScarpSample s = scarp_sample3(0, point_of[i], point_of[count + i], point_of[2 * count + i]);
#else
    ScarpSample s = scarp_sample2(0, point_of[i], point_of[count + i]);
#endif
    result[i] = asuint(s.value); // in the order of struct scarp_samples
    if (task >= 1) {
        result[count + i] = asuint(s.gradient.x);
        result[2 * count + i] = asuint(s.gradient.y);
        result[3 * count + i] = asuint(s.gradient.z);
    }
    if (task >= 2) {
        result[4 * count + i] = asuint(s.diagonal.x);
        result[5 * count + i] = asuint(s.mixed.x);
        result[6 * count + i] = asuint(s.mixed.y);
        result[7 * count + i] = asuint(s.diagonal.y);
        result[8 * count + i] = asuint(s.mixed.z);
        result[9 * count + i] = asuint(s.diagonal.z);
    }
}
