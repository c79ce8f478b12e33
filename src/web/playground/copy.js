// SPDX-License-Identifier: MIT
//
// What the copies have in common: the members of a noise that are not their defaults, numbers as
// text that reads back as the same bits, and the command line.
import {words} from "./state.js";

const DEFAULTS = {basis: "gradient", fade: "quintic", fractal: "fbm", rotate: false, seed: 0n,
    frequency: 1, octaves: 1, lacunarity: 2, gain: 0.5, amplitude: 1, erosion: 1, phase: 0,
    jitter: 1, sharpness: 0, ofOctaves: 0};
const DOUBLES = ["frequency"];

// The shortest text that reads back as the same float
export function floatText(number) {
    for (let digits = 1; digits <= 9; digits++) {
        const text = String(Number(number.toPrecision(digits)));
        if (Math.fround(Number(text)) === number) {
            return text;
        }
    }
    return String(number);
}

// Members of a noise that say something, as pairs of a name and a value
export function members(noise) {
    const pairs = Object.entries(DEFAULTS).filter(([name, value]) => noise[name] !== value)
        .map(([name]) => [name, noise[name]]);
    if (noise.period) {
        pairs.push(["period", noise.period]);
    }
    return pairs;
}

export const isFloat = name => !DOUBLES.includes(name);

// Noises of a terrain, each before the one that points to it
export function noises(terrain) {
    const list = [];
    if (terrain.warp) {
        list.push(["warp", terrain.warp]);
    }
    list.push(["noise", terrain.noise]);
    for (const name of ["mask", "base"]) {
        if (terrain[name]) {
            list.push([name, terrain[name]]);
        }
    }
    return list;
}

// A command that writes heights as floats, and the hillshade
export function asCommand(state) {
    const list = ["scarp", "terrain", ...words(state), "--heights", "heights.r32", "--hillshade",
        "hillshade.pgm"];
    const lines = [list.slice(0, 2).join(" ")];
    for (let i = 2; i < list.length;) {
        const hasValue = i + 1 < list.length && !list[i + 1].startsWith("--");
        const word = hasValue ? `${list[i]} ${list[i + 1]}` : list[i];
        const last = lines.length - 1;
        if (lines[last].length + word.length > 76) {
            lines.push(`    ${word}`);
        } else {
            lines[last] += ` ${word}`;
        }
        i += hasValue ? 2 : 1;
    }
    return lines.join(" \\\n") + "\n";
}
