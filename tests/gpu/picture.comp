#version 460
// SPDX-License-Identifier: MIT
//
// A landscape, raymarched: the picture of src/gpu/README.md. For each pixel, where its ray meets
// the ground, with height and slopes there, so that picture.c can compare them with the library's;
// then the color. Plan 0 is the ground for rays, plan 1 has more octaves of the same sum for the light.
#extension GL_GOOGLE_include_directive : require
#define SCARP_PLANS 2
#define SCARP_ONLY_DEPTH 0u
#include "scarp.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 2) writeonly buffer Pixels
{
    float pixels[];
};
layout(push_constant) uniform Push
{
    uint count, width;
};

const vec3 EYE = vec3(310.0, 460.0, 96.0); // z points up
const vec3 SUN = vec3(0.80, -0.36, 0.36);
const float FAR = 3000.0;

float ground(vec2 p)
{
    return scarp_sample2(0u, p.x, p.y).value;
}

// How far along the ray the ground is, from `t` on; FAR, if it is not met.
float meets(vec3 eye, vec3 ray, float t, float far, int steps)
{
    for (int i = 0; i < steps && t < far; i++) {
        vec3 p = eye + t * ray;
        float above = p.z - ground(p.xy);
        if (above < 0.001 * t) {
            return t;
        }
        t += 0.4 * above + (p.z > 150.0 && ray.z > 0.0 ? far : 0.0);
    }
    return t < far ? t : FAR;
}

vec3 sky_along(vec3 ray)
{
    float up = max(ray.z, 0.0), sun = max(dot(ray, normalize(SUN)), 0.0);
    vec3 color = mix(vec3(0.60, 0.69, 0.80), vec3(0.20, 0.38, 0.66), pow(up, 0.6));
    return color + vec3(0.9, 0.55, 0.25) * (0.25 * pow(sun, 8.0) + 0.6 * pow(sun, 64.0));
}

vec3 light_at(vec3 p, ScarpSample s)
{
    vec3 normal = normalize(vec3(-s.gradient.xy, 1.0)), sun = normalize(SUN);
    float lit = max(dot(normal, sun), 0.0);
    if (lit > 0.0) {
        lit *= smoothstep(0.0, 1.0, meets(p + vec3(0.0, 0.0, 0.6), sun, 1.0, 400.0, 60) / FAR);
    }
    float flat_ground = smoothstep(0.74, 0.86, normal.z);
    float height = p.z + 6.0 * normal.x;
    vec3 rock = mix(vec3(0.16, 0.14, 0.12), vec3(0.27, 0.22, 0.17), 0.5 + 0.5 * normal.y);
    vec3 grass = mix(vec3(0.06, 0.09, 0.03), vec3(0.13, 0.13, 0.05), smoothstep(-10.0, 30.0, p.z));
    vec3 color = mix(rock, grass, flat_ground * (1.0 - smoothstep(18.0, 34.0, height)));
    color = mix(color, vec3(0.86, 0.89, 0.94),
                smoothstep(34.0, 50.0, height) * smoothstep(0.55, 0.75, normal.z));
    float sky = 0.5 + 0.5 * normal.z, back = max(dot(normal, vec3(-sun.xy, 0.0)), 0.0);
    return color * (lit * vec3(2.6, 2.2, 1.7) + sky * vec3(0.24, 0.34, 0.50) +
                    back * vec3(0.20, 0.17, 0.14));
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) {
        return;
    }
    uint height = count / width;
    vec2 at = (vec2(i % width, i / width) + 0.5 - 0.5 * vec2(width, height)) / float(height);
    vec3 ahead = normalize(vec3(0.72, 0.66, -0.24));
    vec3 right = normalize(vec3(ahead.y, -ahead.x, 0.0));
    vec3 ray = normalize(1.15 * ahead + at.x * right - at.y * cross(right, ahead));
    float t = meets(EYE, ray, 1.0, FAR, 400);
    vec3 p = EYE + t * ray, color = sky_along(ray);
    ScarpSample s = scarp_sample2(1u, p.x, p.y);
    if (t < FAR) {
        float haze = 1.0 - exp(-pow(t / 2300.0, 1.5));
        color = mix(light_at(vec3(p.xy, s.value), s), vec3(0.60, 0.69, 0.80), haze);
    }
    color = pow(color / (1.0 + 0.35 * color), vec3(1.0 / 2.2));
    float of_pixel[8] = float[8](p.x, p.y, s.value, s.gradient.x, s.gradient.y, color.r, color.g,
                                 color.b);
    for (uint k = 0u; k < 8u; k++) {
        pixels[k * count + i] = of_pixel[k];
    }
}
