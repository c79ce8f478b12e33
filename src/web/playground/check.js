// SPDX-License-Identifier: MIT
//
// What is wrong with the state, by the name of the option or the parameter.
import {ROWS} from "./parameters.js";
import {numberText, recipeOfNoise} from "./recipes.js";
import {NOISE, OWN, parse, parseNumber} from "./state.js";

const POWERS = new Map([[2 ** -150, "2^-150"], [2 ** -149, "above 2^-150"], [2 ** -48, "2^-48"],
    [2 ** -32, "2^-32"], [2 ** -24, "2^-24"], [2 ** -20, "2^-20"], [2 ** -8, "2^-8"],
    [1 / 16, "1/16"], [2 ** 8, "2^8"], [2 ** 16, "2^16"], [2 ** 24, "2^24"], [2 ** 48, "2^48"],
    [2 ** 53, "2^53"], [2 ** 128 - 2 ** 104, "2^128 - 2^104"]]);

function boundText(number) {
    const sign = number < 0 ? "-" : "";
    return sign + (POWERS.get(Math.abs(number)) ?? String(Math.abs(number)));
}

// The interval of a row in words
export function intervalOf(row) {
    const from = boundText(row.lowest), to = boundText(row.highest);
    switch (row.kind) {
    case "seed": return "an integer from 0 to 2^64 - 1, decimal or 0x and hexadecimal";
    case "size": return "WIDTHxHEIGHT with both from 1 to 1000000";
    case "point": return `two numbers from ${from} to ${to}, with a comma between`;
    case "choice": return `one of ${row.choices.join(", ")}`;
    case "magnitude": return `a number of a magnitude from ${from} to ${to}`;
    default: return from.startsWith("above") ? `a number ${from}, at most ${to}`
        : `a number from ${from} to ${to}`;
    }
}

// The page keeps whole rasters in memory, and paints them at once.
const SIDE_MAX = 16384;
const SAMPLES_MAX = 2 ** 24;

function checkSize([width, height], messages) {
    if (Math.max(width, height) > SIDE_MAX || width * height > SAMPLES_MAX) {
        messages.set("size", "the page shows at most 2^24 samples and 16384 along a side; the " +
            "command line makes more");
    }
}

const optionOf = member => member?.startsWith("period") ? "period" : member?.replace("_", "-");

// What a recipe needs beside its text: numbers of its parameters. Those that are none are told.
function valuesOf(state, messages) {
    const values = {};
    for (const [name, text] of Object.entries(state.values)) {
        values[name] = parseNumber(text);
        if (!Number.isFinite(values[name])) {
            messages.set(`=${name}`, "is no number");
        }
    }
    return values;
}

// The recipe of the state; with one noise, it is written.
function textOfState(state, options, presets, terrain) {
    if (state.preset !== NOISE) {
        return state.preset === OWN ? state.text : presets.get(state.preset);
    }
    return recipeOfNoise(options, text => {
        const problem = terrain.open({text, values: {}, seed: 0n, tile: ""});
        if (problem !== null) {
            const option = optionOf(problem.message.split(":")[0]);
            throw Object.assign(new Error(problem.message),
                {option: ROWS.has(option) ? option : "frequency"});
        }
        const {lowest, highest} = terrain.numbers();
        return [lowest, highest];
    });
}

// Where a problem of a recipe is told: at the parameter, or with the text
function tell(problem, state, messages) {
    if (problem.name !== null) {
        messages.set(`=${problem.name}`, problem.message);
    } else {
        const place = problem.line ? `line ${problem.line}: ` : "";
        messages.set("recipe", place + problem.message);
    }
}

// {options, messages, source, params}: messages by option, by "=" and parameter, and "recipe";
// `source` is what workers take, null if there are messages. `terrain` is that of the page.
export function check(terrain, presets, state) {
    const {options, wrong} = parse(state), messages = new Map();
    for (const name of wrong) {
        messages.set(name, `is not ${intervalOf(ROWS.get(name))}`);
    }
    let source = null, params = [], text = null;
    const values = valuesOf(state, messages);
    if (messages.size === 0) {
        checkSize(options.size, messages);
        try {
            text = textOfState(state, options, presets, terrain);
            const isRecipe = state.preset !== NOISE, {period, step, seed} = options;
            const tile = isRecipe && period !== null
                ? period.map(n => numberText(n * step, false)).join(", ") : "";
            const plain = {text, values: {}, seed, tile: ""};
            source = {text, values: isRecipe ? values : {}, seed, tile};
            let problem = terrain.open(plain);
            params = problem === null && isRecipe ? terrain.params() : [];
            problem ??= terrain.open(source);
            if (problem !== null) {
                tell(problem, state, messages);
            }
        } catch (error) {
            if (!error.option) {
                throw error;
            }
            messages.set(error.option, error.message);
        }
    }
    return {options, messages, params, text, source: messages.size === 0 ? source : null};
}
