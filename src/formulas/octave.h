/* SPDX-License-Identifier: MIT
 *
 * Formulas: the constants of octaves, and of what they are octaves of; member by member, and with
 * the layout, of struct scarp_gpu_octave and struct scarp_gpu_level.
 */
#ifndef SCARP_FORMULAS_OCTAVE_H
#define SCARP_FORMULAS_OCTAVE_H

#include "c.h"

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

/* component: 0 here; octaves_at() sets it to that of vector noise whose components share a lattice.
 */
struct level {
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

#endif
