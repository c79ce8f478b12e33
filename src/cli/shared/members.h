/* SPDX-License-Identifier: MIT
 *
 * Defaults and intervals of struct scarp_noise. Of intervals that depend on the fractal, this has
 * the narrowest. Made by src/bindings/interface.py of include/scarp.h; do not change it by hand.
 */
#ifndef SCARP_CLI_MEMBERS_H
#define SCARP_CLI_MEMBERS_H

#define NOISE_FREQUENCY_DEFAULT 1
#define NOISE_FREQUENCY_BOUNDS 0x1p-32, 0x1p48
#define NOISE_OCTAVES_DEFAULT 1
#define NOISE_OCTAVES_BOUNDS 0, 32
#define NOISE_LACUNARITY_DEFAULT 2
#define NOISE_LACUNARITY_BOUNDS 0.0625, 16
#define NOISE_GAIN_DEFAULT 0.5
#define NOISE_GAIN_BOUNDS 0.0625, 16
#define NOISE_AMPLITUDE_DEFAULT 1
#define NOISE_AMPLITUDE_BOUNDS 0x1p-24, 0x1p24
#define NOISE_EROSION_DEFAULT 1
#define NOISE_EROSION_BOUNDS 0x1p-24, 0x1p24
#define NOISE_PHASE_DEFAULT 0
#define NOISE_JITTER_DEFAULT 1
#define NOISE_JITTER_BOUNDS 0, 1
#define NOISE_SHARPNESS_BOUNDS 0x1p-8, 256
#define NOISE_PERIOD_BOUNDS 1, 0x1p30

#endif
