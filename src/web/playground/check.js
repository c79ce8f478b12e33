// SPDX-License-Identifier: MIT
//
// What is wrong with the options, in the library's own words, by the name of the option.
import {PARTS, ROWS} from "./parameters.js";
import {numberOf, parse, terrainOf, textOf} from "./state.js";

const POWERS = new Map([[2 ** -150, "2^-150"], [2 ** -149, "above 2^-150"], [2 ** -48, "2^-48"],
    [2 ** -32, "2^-32"], [2 ** -24, "2^-24"], [2 ** -20, "2^-20"], [2 ** -8, "2^-8"],
    [1 / 16, "1/16"], [2 ** 8, "2^8"], [2 ** 16, "2^16"], [2 ** 24, "2^24"], [2 ** 48, "2^48"],
    [2 ** 53, "2^53"], [2 ** 128 - 2 ** 104, "2^128 - 2^104"]]);

function numberText(number) {
    const sign = number < 0 ? "-" : "";
    return sign + (POWERS.get(Math.abs(number)) ?? String(Math.abs(number)));
}

// The interval of a row in words
export function intervalOf(row) {
    const from = numberText(row.lowest), to = numberText(row.highest);
    switch (row.kind) {
    case "seed": return "an integer from 0 to 2^64 - 1, decimal or 0x and hexadecimal";
    case "size": return "WIDTHxHEIGHT with both from 1 to 1000000";
    case "point": return `two numbers from ${from} to ${to}, with a comma between`;
    case "choice": return row.choices.join(", ");
    case "magnitude": return `a magnitude from ${from} to ${to}`;
    case "zero-or-more": return `0 or from ${from} to ${to}`;
    case "zero-or-magnitude": return `0 or a magnitude from ${from} to ${to}`;
    default: return from.startsWith("above") ? `${from}, at most ${to}` : `from ${from} to ${to}`;
    }
}

// What the library says of this number alone, in a noise of defaults. Of what it does not know, it
// would say the same.
function saidOf(scarp, state, row) {
    const isNumber = row.member && row.kind !== "seed";
    const error = isNumber && scarp.noiseCheck({[row.member]: numberOf(state, row.name)}, 2);
    if (error) {
        return error.message;
    }
    const other = scarp.noiseCheck({gain: NaN}, 2);
    return other.message.replace("gain", row.name);
}

const optionOf = member => member.startsWith("period") ? "period"
    : member === "ofOctaves" ? "of-octaves" : member;

// Checks how valid numbers go together: each noise by itself, as calls would.
function checkNoises(scarp, terrain, messages) {
    const noises = {"": {...terrain.noise, warp: null}, "warp-": terrain.warp,
        "base-": terrain.base && {...terrain.base, amplitude: 1}, "mask-": terrain.mask};
    for (const [prefix, noise] of Object.entries(noises)) {
        const error = noise && scarp.noiseCheck(noise, 2);
        if (error) {
            const option = optionOf(error.member);
            messages.set(ROWS.has(prefix + option) ? prefix + option : option, error.message);
        }
    }
}

// The page keeps whole rasters in memory, and paints them at once.
const SIDE_MAX = 16384;
const SAMPLES_MAX = 2 ** 24;

function checkTerrain(options, messages) {
    const [width, height] = options.size;
    if (Math.max(width, height) > SIDE_MAX || width * height > SAMPLES_MAX) {
        messages.set("size", "the page shows at most 2^24 samples and 16384 along a side; the " +
            "command line makes more");
    }
    const {plateau, "sea-level": sea, "mask-band": band} = options;
    if (plateau !== null && sea !== null && plateau < sea) {
        messages.set("plateau", "lies below the sea level");
    }
    const [a, b] = band.map(Math.fround);
    if (PARTS["mask-"](options) && !(Math.abs(Math.fround(b - a)) >= 2 ** -60)) {
        messages.set("mask-band", "the numbers are closer than 2^-60, and not equal");
    }
}

// {options, messages, terrain}: messages by option; the terrain is null if there are any.
export function check(scarp, state) {
    const {options, wrong} = parse(state), messages = new Map();
    for (const name of wrong) {
        const row = ROWS.get(name);
        messages.set(name, `${saidOf(scarp, state, row)}; ${intervalOf(row)}`);
    }
    let terrain = null;
    if (messages.size === 0) {
        checkTerrain(options, messages);
        try {
            terrain = terrainOf(options, state.preset);
            checkNoises(scarp, terrain, messages);
        } catch (error) {
            if (!error.option) {
                throw error;
            }
            messages.set(error.option, error.message);
        }
    }
    return {options, messages, terrain: messages.size === 0 ? terrain : null,
        text: name => textOf(state, name)};
}
