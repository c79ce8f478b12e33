/* SPDX-License-Identifier: MIT
 *
 * Shaders: the constants of a noise, member by member as scarp_gpu_plan gives them. Included by
 * c.h.
 */
#ifndef SCARP_GPU_PLAN_H
#define SCARP_GPU_PLAN_H

/* turn: with a phase the cosine and sine of the angle, then of twice that; of bases that take
   places the jitter, the middle and the stretch. */
struct octave {
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

struct level {
    uint basis;
    uint fade;
    uint fractal;
    uint octaves;
    uint rotate;
    uint flows;
    uint first;
    uint spare0;
    float erosion;
    float sharpness;
    float inverse_weight;
    float spare1;
};

struct plan {
    uint depth;
    uint dimensions;
    uint zero;
    float unit;
    struct level level[5];
    struct octave octave[32];
};

/* The numbers of enum scarp_basis, scarp_fade and scarp_fractal. */
#define GRADIENT 0u
#define VALUE 1u
#define SIMPLEX 2u
#define CELL_F1 3u
#define CELL_F2 4u
#define CELL_EDGE 5u
#define CELL_SOFT 6u
#define CELL_VALUE 7u

#define QUINTIC 0u

#define FBM 0u
#define TURBULENCE 1u
#define RIDGED 2u
#define EROSION 3u
#define PINGPONG 4u
#define HYBRID 5u
#define SWISS 6u
#define JORDAN 7u

#endif
