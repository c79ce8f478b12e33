// SPDX-License-Identifier: MIT
//
// Recipes: those of the program, and the one of a single noise, which is written as
// `scarp terrain --print-recipe` does.
import {PRESETS} from "./presets.js";

const f32 = Math.fround;

// The texts of the presets, by name
export async function loadPresets() {
    const texts = await Promise.all(PRESETS.map(async name => {
        const response = await fetch(new URL(`./${name}.recipe`, import.meta.url));
        return response.text();
    }));
    return new Map(PRESETS.map((name, i) => [name, texts[i]]));
}

export const paletteOf = text => /^#: palette (\w+)/m.exec(text)?.[1] ?? "alpine";

// The shortest text of a number, or of a float, that reads back as the same
export function numberText(number, isFloat = true) {
    for (let digits = 1; digits <= 17; digits++) {
        const text = String(Number(number.toPrecision(digits)));
        if (isFloat ? f32(Number(text)) === number : Number(text) === number) {
            return text;
        }
    }
    return String(number);
}

// Members of a noise and their defaults, in the order of the text
const MEMBERS = {octaves: 1, "of-octaves": null, lacunarity: 2, gain: 0.5, amplitude: 1, erosion: 1,
    jitter: 1, sharpness: null};

function noiseText(options) {
    const words = [["basis", "gradient"], ["fractal", "fbm"], ["fade", "quintic"]]
        .filter(([name, standard]) => options[name] !== standard)
        .map(([name]) => options[name].replace("-", "_"));
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

const within = (value, [lowest, highest]) =>
    value < lowest ? lowest : value > highest ? highest : value;

function fail(option, message) {
    throw Object.assign(new Error(message), {option});
}

function commonDivisor(a, b) {
    while (b !== 0) {
        [a, b] = [b, a % b];
    }
    return a;
}

const FACTOR_MAX = 1.5; // how much higher than asked for a frequency may become
const CELLS_MAX = 2 ** 30;

// The nearest frequency that has whole cells in a period
function wholeFrequency({frequency, rotate, period, step}) {
    const side = commonDivisor(...period), length = side * step;
    const times = Math.max(1, Math.floor(frequency * length + 0.5));
    if (rotate) {
        fail("rotate", "axes that are turned do not repeat: leave this or the period out");
    }
    if (times / length > FACTOR_MAX * frequency && period.every(n => n > side)) {
        fail("period", "sides with a larger common divisor come nearer to the frequency");
    }
    if (period.some(n => times * n / side > CELLS_MAX)) {
        fail("period", "has more than 2^30 cells of the first octave");
    }
    return times / length;
}

// The recipe of one noise. rangeOf(text) gives the interval of a recipe. Throws an Error with `option`
// where options do not go together.
export function recipeOfNoise(options, rangeOf) {
    const {period, step, height, plateau, "sea-level": sea} = options;
    let head = "recipe 1\n";
    const frequency = period === null ? options.frequency : wholeFrequency(options);
    if (period !== null) {
        head += `tile ${period.map(n => numberText(n * step, false)).join(", ")}\n`;
    }
    const noise = noiseText({...options, frequency});
    const phase = options.phase === null ? ""
        : `param phase = ${numberText(options.phase === 0 ? 1 : options.phase)}\n`;
    const range = rangeOf(`${head}${phase}out height = ${noise}\n`);
    if (plateau !== null && sea !== null && plateau < sea) {
        fail("plateau", "lies below the sea level");
    }
    const level = sea === null ? "" : `param sea = ${numberText(f32(height * within(sea, range)))}\n`;
    const top = plateau === null ? noise
        : `min(${noise}, ${numberText(f32(within(plateau, range)))})`;
    return `${head}${level}${phase}out height = ${numberText(height)} * ${top}\n`;
}
