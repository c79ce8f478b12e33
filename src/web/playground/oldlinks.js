// SPDX-License-Identifier: MIT
//
// Links that older pages gave away: they tell the options of one noise, of which a recipe is made
// as `scarp terrain --print-recipe` does, or values with a recipe, which become numbers of its
// text.
import {readDocument} from "./document.js";
import {numberText, parseNumber} from "./options.js";

const f32 = Math.fround;

// Members of a noise with what they are without being given, and what the page began with
const MEMBERS = {octaves: 1, "of-octaves": null, lacunarity: 2, gain: 0.5, amplitude: 1, erosion: 1,
    jitter: 1, sharpness: null};
const WORDS = {basis: "gradient", fractal: "fbm", fade: "quintic"};
const BEGIN = {...MEMBERS, ...WORDS, frequency: 0.0025, octaves: 9, gain: 0.4, height: 120,
    "sea-level": null, plateau: null, phase: null};

function noiseText(options) {
    const words = Object.keys(WORDS).filter(name => options[name] !== WORDS[name])
        .map(name => options[name].replace("-", "_"));
    if (options.rotate) {
        words.push("rotate");
    }
    words.push(`frequency=${numberText(options.frequency, false)}`);
    for (const [name, standard] of Object.entries(MEMBERS)) {
        if (options[name] !== standard) {
            words.push(`${name.replace("-", "_")}=${numberText(options[name])}`);
        }
    }
    if (options.phase !== null) {
        words.push("phase=phase");
    }
    return `noise(${words.join(", ")})`;
}

const commonDivisor = (a, b) => b === 0 ? a : commonDivisor(b, a % b);
const within = (value, [lowest, highest]) => Math.min(Math.max(value, lowest), highest);

// The nearest frequency that has whole cells in a period
function wholeFrequency(frequency, period, step) {
    const length = commonDivisor(...period) * step;
    return Math.max(1, Math.floor(frequency * length + 0.5)) / length;
}

// The last one counts.
const textIn = (query, name) => query.getAll(name).at(-1) ?? null;

function optionsOf(query) {
    const options = {...BEGIN, rotate: !["0", null].includes(textIn(query, "rotate"))};
    for (const name of Object.keys(BEGIN)) {
        const text = textIn(query, name), number = parseNumber(text ?? "");
        if (text === "unset") {
            options[name] = null;
        } else if (name in WORDS) {
            options[name] = text ?? options[name];
        } else if (!Number.isNaN(number)) {
            options[name] = name === "frequency" ? number : f32(number);
        }
    }
    return options;
}

// The recipe of one noise; `tile` is a line, or empty.
function recipeOfNoise(options, tile, scarp) {
    const {height, plateau, "sea-level": sea, phase} = options, noise = noiseText(options);
    const head = `recipe 1\n${tile}`;
    const param = phase === null ? "" : `param phase = ${numberText(phase === 0 ? 1 : phase)}\n`;
    const [alone] = readDocument(scarp, `${head}${param}out height = ${noise}\n`).entries.slice(-1);
    const level = sea === null ? ""
        : `param sea = ${numberText(f32(height * within(sea, alone.range)))}\n`;
    const top = plateau === null ? noise
        : `min(${noise}, ${numberText(f32(within(plateau, alone.range)))})`;
    return `${head}${level}${param}out height = ${numberText(height)} * ${top}\n`;
}

// The text with numbers of parameters in place
function withValues(text, query, scarp) {
    for (const pair of query.getAll("set")) {
        const [name, number] = pair.split("=");
        const entry = readDocument(scarp, text).entries.find(each => each.isParam &&
            each.name === name);
        if (entry && !Number.isNaN(parseNumber(number ?? ""))) {
            const [from, to] = entry.valueSpan;
            text = text.slice(0, from) + number + text.slice(to);
        }
    }
    return text;
}

// The text for a link; `text` is the one that it names.
export function textOfOldLink(query, text, scarp) {
    const step = parseNumber(textIn(query, "step") ?? "1");
    const period = /^(\d+)x(\d+)$/.exec(textIn(query, "period") ?? "")?.slice(1).map(Number);
    const tile = period ? `tile ${period.map(n => numberText(n * step, false)).join(", ")}\n` : "";
    if (query.get("preset") !== "none") {
        return withValues(text.replace(/^(recipe 1[^\n]*\n)/m, `$1${tile}`), query, scarp);
    }
    const options = optionsOf(query);
    if (period) {
        options.frequency = wholeFrequency(options.frequency, period, step);
    }
    return recipeOfNoise(options, tile, scarp);
}
