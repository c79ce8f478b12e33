// SPDX-License-Identifier: MIT
//
// The state of the page: which recipe, the values of its parameters and the options that were given
// as text, and the view.
import {GROUPS, OF_NOISE, ROWS} from "./parameters.js";
import {PRESETS} from "./presets.js";

export const VIEWS = ["relief", "hillshade", "value", "slope", "curvature"];
export const NOISE = "none", OWN = "own"; // in place of a preset: one noise, a text of one's own
const TINY = 2 ** -149;
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

export function initialState() {
    return {preset: PRESETS[0], text: null, values: {}, given: {}, view: "relief", space: false,
        camera: null};
}

export function parseNumber(text) {
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
};

// What an option is without being given: the default; null: unset.
export function defaultText(state, name) {
    const text = ROWS.get(name).standard ?? null;
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

// Parses all options that count. `wrong` has the names of those that are not within their intervals.
export function parse(state) {
    const options = {}, wrong = [];
    for (const row of ROWS.values()) {
        const text = textOf(state, row.name);
        if (OF_NOISE.has(row.name) && state.preset !== NOISE) {
            continue;
        }
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
    return {options, wrong};
}

// Options as words of a command line
export function words(state) {
    const list = state.preset === NOISE ? []
        : state.preset === OWN ? ["--recipe", "terrain.recipe"] : ["--preset", state.preset];
    for (const [name, text] of Object.entries(state.values)) {
        list.push("--set", `${name}=${text}`);
    }
    for (const row of ROWS.values()) {
        const text = state.given[row.name];
        const isLeft = OF_NOISE.has(row.name) && state.preset !== NOISE;
        if (text === undefined || text === null || isLeft) {
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
    if (state.preset === OWN) {
        query.set("text", state.text);
    }
    for (const [name, text] of Object.entries(state.values)) {
        query.append("set", `${name}=${text}`);
    }
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
    return "#" + query.toString().replaceAll("%2C", ",");
}

// What is unknown is left out: URLs of other versions still show something.
export function fromHash(hash) {
    const query = new URLSearchParams(hash.replace(/^#/, "")), state = initialState();
    for (const [name, text] of query) {
        if (name === "preset" && [NOISE, OWN, ...PRESETS].includes(text)) {
            state.preset = text;
        } else if (name === "text") {
            state.text = text;
        } else if (name === "set" && text.includes("=")) {
            const at = text.indexOf("=");
            state.values[text.slice(0, at)] = text.slice(at + 1);
        } else if (name === "view" && VIEWS.includes(text)) {
            state.view = text;
        } else if (ROWS.has(name)) {
            state.given[name] = text === "unset" ? null : text;
        }
    }
    if (state.preset === OWN && state.text === null) {
        state.preset = PRESETS[0];
    }
    state.space = query.get("space") === "3d";
    state.camera = query.get("camera");
    return state;
}
