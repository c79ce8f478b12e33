// SPDX-License-Identifier: MIT
//
// The state of the page: a preset, the options that were given beside it as text, and the view.
// Resolving it gives what `scarp terrain` makes of the same options.
import {GROUPS, PARTS, ROWS} from "./parameters.js";
import {PRESETS} from "./presets.js";
import {repeat} from "./repeat.js";

export const VIEWS = ["relief", "hillshade", "value", "slope", "curvature"];
const TINY = 2 ** -149;
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

export function initialState() {
    return {preset: "alps", given: {seed: "1"}, view: "relief", space: false, camera: null,
        gpu: false};
}

function parseNumber(text) {
    return NUMBER.test(text) ? Number(text) : NaN;
}

function isWithin(row, number) {
    if (row.lowest === TINY && Math.fround(number) === 0) {
        return false;
    }
    return number >= Math.min(row.lowest, TINY === row.lowest ? 0 : row.lowest) &&
        number <= row.highest;
}

const isMagnitude = (row, number) => isWithin(row, Math.abs(number));

const parsers = {
    choice: (row, text) => row.choices.includes(text) ? text : undefined,
    flag: (row, text) => Boolean(text) && text !== "0",
    seed: (row, text) => {
        const is = /^(\d+|0x[0-9a-f]+)$/i.test(text);
        return is && BigInt(text) < 2n ** 64n ? BigInt(text) : undefined;
    },
    size: (row, text) => {
        const found = /^(\d+)x(\d+)$/.exec(text);
        const size = found ? [Number(found[1]), Number(found[2])] : [0, 0];
        return size.every(n => n >= 1 && n <= 1e6) ? size : undefined;
    },
    point: (row, text) => {
        const numbers = String(text).split(",").map(parseNumber);
        const is = numbers.length === 2 && numbers.every(n => isWithin(row, n));
        return is ? numbers : undefined;
    },
    double: (row, text) => {
        const number = parseNumber(text);
        return isWithin(row, number) ? number : undefined;
    },
    float: (row, text) => {
        const number = parseNumber(text);
        return isWithin(row, number) ? Math.fround(number) : undefined;
    },
    magnitude: (row, text) => {
        const number = parseNumber(text);
        return isMagnitude(row, number) ? Math.fround(number) : undefined;
    },
    "zero-or-more": (row, text) => {
        const number = parseNumber(text);
        return number === 0 || isWithin(row, number) ? Math.fround(number) + 0 : undefined;
    },
    "zero-or-magnitude": (row, text) => {
        const number = parseNumber(text);
        return number === 0 || isMagnitude(row, number) ? Math.fround(number) + 0 : undefined;
    },
};

// What an option is without being given: that of the preset, or the default; null: unset.
export function defaultText(state, name) {
    const row = ROWS.get(name), preset = PRESETS[state.preset] ?? {};
    const text = preset[name] ?? row.standard ?? null;
    return text === null || text === true || text === false ? text : String(text);
}

export function textOf(state, name) {
    return state.given[name] ?? defaultText(state, name);
}

// The number of an option as it stands, even outside its interval
export function numberOf(state, name) {
    const row = ROWS.get(name), text = textOf(state, name);
    if (row.kind === "seed") {
        return parsers.seed(row, text) ?? 0n;
    }
    return text === null ? 0 : parseNumber(String(text));
}

// Every option of the noises that follow the first one has that of the first one where it inherits.
function inherit(state, options) {
    for (const prefix of Object.keys(PARTS)) {
        for (const name of ["seed", "frequency"]) {
            const own = prefix + name;
            const isSet = own in state.given || own in (PRESETS[state.preset] ?? {});
            if (!isSet) {
                options[own] = options[name];
            }
        }
    }
}

// Parses all options. `wrong` has the names of those that are not within their intervals.
export function parse(state) {
    const options = {}, wrong = [];
    for (const row of ROWS.values()) {
        const text = textOf(state, row.name);
        if (text === null) {
            options[row.name] = null;
            continue;
        }
        const value = parsers[row.kind](row, text);
        if (value === undefined) {
            wrong.push(row.name);
        }
        options[row.name] = value;
    }
    inherit(state, options);
    return {options, wrong};
}

// At 0 ranges would be others than at all other phases; a whole turn later the bits are the same.
const phaseOf = phase => phase === null ? 0 : phase === 0 ? 1 : phase;

// A noise in the form that the package takes
function noiseOf(options, prefix) {
    const get = name => options[prefix + name];
    return {
        basis: get("basis"), fade: get("fade"), fractal: get("fractal"), rotate: get("rotate"),
        seed: get("seed"), frequency: get("frequency"), octaves: get("octaves"),
        lacunarity: get("lacunarity"), gain: get("gain"), amplitude: 1, erosion: get("erosion"),
        phase: phaseOf(get("phase")), jitter: get("jitter"), sharpness: get("sharpness") ?? 0,
        ofOctaves: get("of-octaves") ?? 0,
    };
}

// The terrain of options that are all valid: plain data, which workers get. Throws an Error with
// `option` where a period does not go together with the rest.
export function terrainOf(options, preset) {
    const [width, height] = options.size;
    const terrain = {
        noise: noiseOf(options, ""), warp: null, base: null, mask: null,
        maskBand: options["mask-band"].map(Math.fround),
        stretch: options.stretch, wind: options.wind, height: options.height,
        seaLevel: options["sea-level"] ?? -Infinity, plateau: options.plateau ?? Infinity,
        crater: options.crater ?? Infinity, terraces: options.terraces,
        terraceRiser: options["terrace-riser"], terraceStrength: options["terrace-strength"],
        raster: {width, height, origin: options.origin, step: options.step},
        azimuth: options.azimuth, altitude: options.altitude, zFactor: options["z-factor"],
    };
    terrain.noise.amplitude = options.amplitude;
    if (PARTS["warp-"](options)) {
        terrain.warp = {...noiseOf(options, "warp-"), amplitude: options["warp-reach"]};
    }
    if (PARTS["base-"](options)) {
        terrain.base = {...noiseOf(options, "base-"), amplitude: options["base-amplitude"]};
    }
    if (PARTS["mask-"](options)) {
        terrain.mask = noiseOf(options, "mask-");
    }
    if (options.period !== null) {
        repeat(terrain, options.period, PRESETS[preset] ?? {});
    }
    terrain.noise.warp = terrain.warp;
    return terrain;
}

// Options as words of a command line. Flags cannot be taken back, nor can numbers that a preset
// gives be unset: then all options of the preset that are left are told, without its name.
export function words(state) {
    const preset = PRESETS[state.preset] ?? {};
    const isTaken = Object.entries(state.given).some(([name, text]) =>
        name in preset && (text === null || (ROWS.get(name).kind === "flag" && text === "0")));
    const list = isTaken || state.preset === "none" ? [] : ["--preset", state.preset];
    const told = isTaken ? {...preset, ...state.given} : state.given;
    const {options} = parse(state);
    for (const row of ROWS.values()) {
        const text = told[row.name];
        const prefix = Object.keys(PARTS).find(part => row.prefix === part);
        const isLeft = text === undefined || text === null || (prefix && !PARTS[prefix](options));
        if (isLeft) {
            continue;
        }
        if (row.kind === "flag") {
            list.push(...(text !== "0" ? [`--${row.name}`] : []));
        } else {
            list.push(`--${row.name}`, String(text));
        }
    }
    return list;
}

// The state as the part of the URL behind #
export function toHash(state) {
    const query = new URLSearchParams();
    query.set("preset", state.preset);
    for (const group of GROUPS) {
        for (const {name} of group.rows) {
            const text = state.given[name];
            if (text !== undefined) {
                query.set(name, text ?? "unset");
            }
        }
    }
    query.set("view", state.view);
    if (state.space) {
        query.set("space", "3d");
        if (state.camera) {
            query.set("camera", state.camera);
        }
    }
    if (state.gpu) {
        query.set("gpu", "1");
    }
    return "#" + query.toString().replaceAll("%2C", ",");
}

// What is unknown is left out: URLs of other versions still show something.
export function fromHash(hash) {
    const query = new URLSearchParams(hash.replace(/^#/, "")), state = initialState();
    if ([...query].length === 0) {
        return state;
    }
    state.given = {};
    for (const [name, text] of query) {
        if (name === "preset" && text in PRESETS) {
            state.preset = text;
        } else if (name === "view" && VIEWS.includes(text)) {
            state.view = text;
        } else if (ROWS.has(name)) {
            state.given[name] = text === "unset" ? null : text;
        }
    }
    state.space = query.get("space") === "3d";
    state.camera = query.get("camera");
    state.gpu = query.get("gpu") === "1";
    return state;
}
