// SPDX-License-Identifier: MIT
//
// From samples to pixels: the hillshade of `scarp terrain` to the byte; value, slope and curvature
// through ramps.
import {ABOVE_RAMP, BELOW_RAMP, CURVATURE_RAMP, MASK_RAMP, SLOPE_RAMP, VALUE_RAMP} from
    "./palettes.js";

const OPAQUE = 0xff000000;

export function hillshade([x, y, z], [east, north, up], pixels) {
    for (let i = 0; i < pixels.length; i++) {
        const light = east * x[i] + north * y[i] + up * z[i];
        const shade = Math.max(0, Math.trunc(light * 255 + 0.5));
        pixels[i] = shade * 0x010101 | OPAQUE;
    }
}

const indexOf = t => t <= 0 ? 0 : t >= 1 ? 255 : Math.trunc(255 * t + 0.5);

export function valueColours(value, {low, high}, pixels) {
    const per = 1 / (high - low);
    for (let i = 0; i < pixels.length; i++) {
        pixels[i] = VALUE_RAMP[indexOf((value[i] - low) * per)];
    }
}

// Angles from 0 to 60 degrees and more
export function slopeColours(normalZ, pixels) {
    const per = 1 / (Math.PI / 3);
    for (let i = 0; i < pixels.length; i++) {
        pixels[i] = SLOPE_RAMP[indexOf(Math.acos(Math.min(normalZ[i], 1)) * per)];
    }
}

// Mean curvature of heights: hollows are blue, crests red. `unit` is what is half coloured.
export function curvatureColours({dx, dy, dxx, dxy, dyy}, unit, pixels) {
    for (let i = 0; i < pixels.length; i++) {
        const p = dx[i], q = dy[i], length = 1 + p * p + q * q;
        const mean = ((1 + q * q) * dxx[i] - 2 * p * q * dxy[i] + (1 + p * p) * dyy[i]) /
            (2 * length * Math.sqrt(length));
        const t = -mean / unit;
        pixels[i] = CURVATURE_RAMP[indexOf(0.5 + 0.5 * t / (1 + Math.abs(t)))];
    }
}

// Values of any field, of which most lie in an interval: masks in [0, 1] from black to white; where
// 0 lies inside, it is the edge between slate and sand.
export function fieldColours(value, [low, high], pixels) {
    if (low >= 0 && high <= 1) {
        low = 0;
        high = 1;
    }
    const far = Math.max(-low, high), per = 1 / (high - low || 1);
    const ramp = low === 0 && high === 1 ? MASK_RAMP : VALUE_RAMP, isSigned = low < 0 && high > 0;
    for (let i = 0; i < pixels.length; i++) {
        const v = value[i];
        pixels[i] = !isSigned ? ramp[indexOf((v - low) * per)]
            : v < 0 ? BELOW_RAMP[indexOf(1 + v / far)] : ABOVE_RAMP[indexOf(v / far)];
    }
}

// Lengths of gradients, from 0 to `most`
export function steepnessColours({dx, dy}, most, pixels) {
    for (let i = 0; i < pixels.length; i++) {
        pixels[i] = SLOPE_RAMP[indexOf(Math.hypot(dx[i], dy[i]) / (most || 1))];
    }
}
