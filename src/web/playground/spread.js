// SPDX-License-Identifier: MIT
//
// Which values a terrain usually has: quantiles of 4096 places around 0,0 that depend on the
// frequencies alone, so that colours stay while the map moves. As src/cli/ground/spread.c.
import {Sampler} from "./ground.js";

const PLACES = 4096;
const CELLS = 64; // across the square, of the noise with the largest cells
const STEPS = [0.7548776662466927, 0.5698402909980532]; // the R2 sequence
const f32 = Math.fround;

// A noise that flows becomes that of a whole turn: all phases have the same colours.
function stopped(noise) {
    return noise && {...noise, phase: noise.phase !== 0 ? 1 : 0, warp: stopped(noise.warp)};
}

function places(ground) {
    const frequencies = [ground.noise, ground.base, ground.mask].filter(Boolean)
        .map(noise => noise.frequency);
    const size = CELLS / Math.min(...frequencies);
    const x = new Float64Array(PLACES), y = new Float64Array(PLACES);
    for (let i = 0; i < PLACES; i++) {
        const u = i * STEPS[0], v = i * STEPS[1];
        x[i] = (u - Math.floor(u) - 0.5) * size;
        y[i] = (v - Math.floor(v) - 0.5) * size;
    }
    return {x, y};
}

export function spreadOf(scarp, ground) {
    const still = {...ground, noise: stopped(ground.noise), base: stopped(ground.base),
        mask: stopped(ground.mask)};
    const {x, y} = places(ground), value = new Float32Array(PLACES);
    new Sampler(scarp, still).uncutPoints(x, y, {value});
    value.sort();
    const hasSea = ground.floor > ground.lowest;
    let below = 0;
    while (hasSea && below < PLACES && value[below] < ground.floor) {
        below++;
    }
    const above = PLACES - below;
    const median = value[PLACES - 1 - Math.floor(above / 2)];
    const highest = value[PLACES - 1 - Math.floor(above / 50)];
    const low = hasSea ? ground.floor : value[Math.floor(PLACES / 50)];
    let high = Math.min(highest, ground.ceiling);
    if (!(low < high)) { // no land, or all of it level
        high = f32(low + f32(1 + Math.abs(low)));
    }
    const least = f32(f32(high - low) / 16);
    const middle = Math.max(f32(low + least), Math.min(median, f32(high - least)));
    const deep = below > 0 ? value[Math.floor(below / 10)] : ground.lowest;
    return {low, middle, high, sea: ground.floor, deep, hasSea};
}
