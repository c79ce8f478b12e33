// SPDX-License-Identifier: MIT
//
// What a picture needs besides the text of the recipe, under the names that `scarp terrain` has,
// with its intervals and defaults: fields, checks, the URL and the command line are made from this
// table.
//
// A row has a name (an option without its dashes), a kind, a label, an interval, and for numbers
// what its slider covers.
const LARGE = 2 ** 24;

export const GROUPS = [
    {id: "raster", title: "Raster", rows: [
        {name: "seed", kind: "seed", label: "Seed", standard: "1",
         hint: "An integer of 64 bits, decimal or 0x and hexadecimal. Arrow keys change it."},
        {name: "size", kind: "size", label: "Size", standard: "1024x1024",
         hint: "Samples across and down"},
        {name: "origin", kind: "point", label: "Origin", standard: "0,0", lowest: -(2 ** 53),
         highest: 2 ** 53, hint: "x,y of the bottom left sample"},
        {name: "step", kind: "double", label: "Step", standard: "1", lowest: 2 ** -48,
         highest: 2 ** 48, slider: [1 / 64, 64], scale: "log", hint: "Distance between samples"},
    ]},
    {id: "light", title: "Light", rows: [
        {name: "azimuth", kind: "double", label: "Azimuth", standard: "315", lowest: 0,
         highest: 360, slider: [0, 360], step: 1,
         hint: "Where the light comes from, in degrees from north"},
        {name: "altitude", kind: "double", label: "Altitude", standard: "45", lowest: 0,
         highest: 90, slider: [0, 90], step: 1, hint: "Degrees above the horizon"},
        {name: "z-factor", kind: "float", label: "Exaggeration", standard: "1", lowest: 0,
         highest: LARGE, slider: [0, 5], step: 0.05, hint: "Multiplies heights for the light only"},
    ]},
];

export const ROWS = new Map(GROUPS.flatMap(group => group.rows).map(row => [row.name, row]));

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
export const parseNumber = text => NUMBER.test(text) ? Number(text) : NaN;

// The shortest text of a number, or of a float, that reads back as the same
export function numberText(number, isFloat = true) {
    for (let digits = 1; digits <= 17; digits++) {
        const text = String(Number(number.toPrecision(digits)));
        if (isFloat ? Math.fround(Number(text)) === number : Number(text) === number) {
            return text;
        }
    }
    return String(number);
}

const isWithin = (row, number) => number >= row.lowest && number <= row.highest;

const parsers = {
    seed: (row, text) => /^(-?\d+|0x[0-9a-f]+)$/i.test(text) && BigInt(text) < 2n ** 64n
        && BigInt(text) >= -(2n ** 63n) ? BigInt.asUintN(64, BigInt(text)) : undefined,
    size: (row, text) => {
        const size = /^(\d+)x(\d+)$/.exec(text)?.slice(1).map(Number) ?? [0, 0];
        return size.every(n => n >= 1 && n <= 1e6) ? size : undefined;
    },
    point: (row, text) => {
        const numbers = text.split(",").map(parseNumber);
        return numbers.length === 2 && numbers.every(n => isWithin(row, n)) ? numbers : undefined;
    },
    double: (row, text) => isWithin(row, parseNumber(text)) ? Number(text) : undefined,
    float: (row, text) => isWithin(row, parseNumber(text)) ? Math.fround(Number(text)) : undefined,
};

const POWERS = new Map([[2 ** -48, "2^-48"], [2 ** 24, "2^24"], [2 ** 48, "2^48"],
    [2 ** 53, "2^53"]]);
const boundText = number =>
    (number < 0 ? "-" : "") + (POWERS.get(Math.abs(number)) ?? Math.abs(number));

// The interval of a row in words
function intervalOf(row) {
    const from = boundText(row.lowest), to = boundText(row.highest);
    switch (row.kind) {
    case "seed": return "an integer from -2^63 to 2^64 - 1, decimal or 0x and hexadecimal";
    case "size": return "WIDTHxHEIGHT with both from 1 to 1000000";
    case "point": return `two numbers from ${from} to ${to}, with a comma between`;
    default: return `a number from ${from} to ${to}`;
    }
}

// The page keeps whole rasters in memory, and paints them at once.
const SIDE_MAX = 16384;
const SAMPLES_MAX = 2 ** 24;
const TOO_LARGE = "the page shows at most 2^24 samples and 16384 along a side; the command line " +
    "makes more";

// {options, messages}: the values of all rows, and what is wrong, by name. `given` has texts.
export function parseOptions(given) {
    const options = {}, messages = new Map();
    for (const row of ROWS.values()) {
        const value = parsers[row.kind](row, given[row.name] ?? row.standard);
        options[row.name] = value;
        if (value === undefined) {
            messages.set(row.name, `is not ${intervalOf(row)}`);
        }
    }
    const [width, height] = options.size ?? [0, 0];
    if (Math.max(width, height) > SIDE_MAX || width * height > SAMPLES_MAX) {
        messages.set("size", TOO_LARGE);
    }
    return {options, messages};
}

// Given options as words of a command line
export const wordsOf = given => [...ROWS.keys()].filter(name => given[name] !== undefined)
    .flatMap(name => [`--${name}`, given[name]]);
