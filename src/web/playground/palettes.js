// SPDX-License-Identifier: MIT
//
// Colours of the relief: the palettes of `scarp terrain` (src/cli/look/palette.c), and ramps for
// the other views. Colours are sRGB bytes.

export const PALETTES = {
    alpine: {
        stops: [[0, 82, 104, 70], [0.18, 104, 122, 74], [0.36, 140, 144, 92], [0.54, 168, 156, 114],
            [0.72, 162, 146, 124], [1, 176, 168, 160]],
        rock: [122, 114, 102], highRock: [142, 136, 130], snow: [232, 238, 246],
        sand: [206, 190, 146], shallow: [112, 166, 172], deep: [24, 56, 92],
        rockSlope: [0.90, 0.78], rockHeight: [0.3, 0.7], snowHeight: [0.70, 0.77],
        snowSlope: [0.55, 0.75], snowSun: 0.3, snowSteep: 0.7, sandHeight: [0.05, 0.015]},
    temperate: {
        stops: [[0, 86, 110, 70], [0.2, 104, 126, 74], [0.4, 136, 148, 90], [0.6, 164, 162, 108],
            [0.8, 176, 162, 122], [1, 192, 182, 156]],
        rock: [124, 116, 100], highRock: [144, 136, 122], snow: [232, 238, 246],
        sand: [214, 198, 154], shallow: [112, 172, 172], deep: [24, 64, 98],
        rockSlope: [0.88, 0.74], rockHeight: [0.3, 0.8], snowHeight: [100, 101],
        snowSlope: [0.5, 0.8], snowSun: 0, snowSteep: 0, sandHeight: [0.05, 0.015]},
    desert: {
        stops: [[0, 222, 192, 142], [0.25, 212, 172, 116], [0.45, 198, 146, 92],
            [0.62, 184, 126, 86], [0.8, 188, 136, 98], [1, 222, 186, 148]],
        rock: [158, 104, 76], highRock: [178, 122, 90], snow: [255, 255, 255],
        sand: [232, 208, 160], shallow: [96, 172, 160], deep: [22, 82, 104],
        rockSlope: [0.86, 0.72], rockHeight: [0.3, 0.8], snowHeight: [100, 101],
        snowSlope: [0.5, 0.8], snowSun: 0, snowSteep: 0, sandHeight: [0.08, 0.02]},
};

const OF_PRESET = {islands: "temperate", hills: "temperate", karst: "temperate", dunes: "desert",
    canyon: "desert", badlands: "desert"};

export const paletteOf = preset => PALETTES[OF_PRESET[preset] ?? "alpine"];

// A ramp as 256 colours: stops are bytes at equal distances.
function ramp(...stops) {
    const colours = new Uint32Array(256);
    for (let i = 0; i < 256; i++) {
        const at = i / 255 * (stops.length - 1), n = Math.min(Math.floor(at), stops.length - 2);
        const mix = c => Math.round(stops[n][c] + (at - n) * (stops[n + 1][c] - stops[n][c]));
        colours[i] = mix(0) | mix(1) << 8 | mix(2) << 16 | 255 << 24;
    }
    return colours;
}

// Low to high; level to vertical; hollow to crest
export const VALUE_RAMP = ramp([68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142],
    [38, 130, 142], [31, 158, 137], [53, 183, 121], [109, 205, 89], [180, 222, 44],
    [253, 231, 37]);
export const SLOPE_RAMP = ramp([252, 252, 244], [250, 226, 160], [246, 180, 94], [224, 110, 64],
    [168, 44, 64], [96, 16, 70], [36, 6, 44]);
export const CURVATURE_RAMP = ramp([8, 48, 107], [33, 102, 172], [103, 169, 207],
    [209, 229, 240], [247, 247, 247], [253, 219, 199], [239, 138, 98], [178, 24, 43],
    [103, 0, 31]);
