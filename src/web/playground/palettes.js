// SPDX-License-Identifier: MIT
//
// Ramps for the views that have no palette of `scarp terrain`.

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
// Below 0 and above it, from far to near and from near to far, and between 0 and 1: masks
export const BELOW_RAMP = ramp([24, 36, 48], [70, 98, 120], [172, 190, 200]);
export const ABOVE_RAMP = ramp([240, 226, 198], [196, 148, 92], [92, 52, 26]);
export const MASK_RAMP = ramp([0, 0, 0], [255, 255, 255]);
