// SPDX-License-Identifier: MIT
//
// The parameters: those of `scarp terrain` under the same names, with the same intervals and
// defaults. Controls, checks, the URL and the command line are made from this table.
//
// A row has a name (an option without its dashes), a kind, a label, an interval, and for numbers
// what its slider covers. `unset` is what the picture shows while no number is given.

const BASES = ["gradient", "value", "simplex", "cell-f1", "cell-f2", "cell-edge", "cell-soft",
    "cell-value"];
const FADES = ["quintic", "cubic"];
const FRACTALS = ["fbm", "turbulence", "ridged", "erosion", "pingpong", "hybrid", "swiss",
    "jordan"];

const TINY = 2 ** -149; // numbers above 2^-150 are not 0 as floats
const LARGE = 2 ** 24;
const FLOAT_MAX = 2 ** 128 - 2 ** 104;

const isCell = noise => noise.basis.startsWith("cell");
const isOneOf = (...words) => noise => words.includes(noise.fractal);
const hasOctaves = noise => noise.octaves > 1;

// What a noise is: the members of struct scarp_noise. `serves` says for which noises a row matters.
const NOISE = [
    {name: "seed", kind: "seed", label: "Seed", standard: "0", member: "seed",
     hint: "An integer of 64 bits, decimal or 0x and hexadecimal. Arrow keys change it."},
    {name: "basis", kind: "choice", label: "Basis", choices: BASES, standard: "gradient",
     hint: "The noise of one octave"},
    {name: "fractal", kind: "choice", label: "Fractal", choices: FRACTALS, standard: "fbm",
     hint: "How octaves are summed"},
    {name: "frequency", kind: "double", label: "Frequency", standard: 1, lowest: 2 ** -32,
     highest: 2 ** 48, slider: [0.0005, 0.05], scale: "log", member: "frequency",
     hint: "Lattice cells of the first octave per unit of x and y"},
    {name: "octaves", kind: "float", label: "Octaves", standard: 1, lowest: TINY, highest: 32,
     slider: [1, 12], step: 0.05, member: "octaves",
     hint: "How many are summed; a fraction fades the last one in"},
    {name: "lacunarity", kind: "float", label: "Lacunarity", standard: 2, lowest: 1 / 16,
     highest: 16, slider: [1.5, 3.5], step: 0.01, member: "lacunarity", serves: hasOctaves,
     hint: "Ratio of frequencies from octave to octave"},
    {name: "gain", kind: "float", label: "Gain", standard: 0.5, lowest: 1 / 16, highest: 16,
     slider: [0.1, 0.9], step: 0.005, member: "gain", serves: hasOctaves,
     hint: "Ratio of amplitudes from octave to octave"},
    {name: "amplitude", kind: "magnitude", label: "Amplitude", standard: 1, lowest: 1 / LARGE,
     highest: LARGE, slider: [-2, 2], step: 0.05, member: "amplitude", first: true,
     hint: "Scales values, and turns them over where it is negative"},
    {name: "rotate", kind: "flag", label: "Turn axes between octaves", standard: false,
     serves: hasOctaves, hint: "Hides the directions of the lattice"},
    {name: "fade", kind: "choice", label: "Fade", choices: FADES, standard: "quintic",
     serves: noise => ["gradient", "value"].includes(noise.basis),
     hint: "The blend between lattice points"},
    {name: "erosion", kind: "float", label: "Erosion", standard: 1, lowest: 1 / LARGE,
     highest: LARGE, slider: [0.01, 4], scale: "log", member: "erosion",
     serves: isOneOf("erosion", "jordan"),
     hint: "How strongly slopes damp octaves; of jordan noise at most 1"},
    {name: "sharpness", kind: "float", label: "Sharpness", lowest: 2 ** -8, highest: 2 ** 8,
     unset: "by fractal", slider: [0.02, 4], scale: "log", member: "sharpness",
     serves: isOneOf("pingpong", "hybrid", "swiss", "jordan"),
     hint: "Folds of pingpong, offset of hybrid, bends of swiss and jordan"},
    {name: "jitter", kind: "float", label: "Jitter", standard: 1, lowest: TINY, highest: 1,
     slider: [0.01, 1], step: 0.01, member: "jitter", serves: isCell,
     hint: "How far features stray from the middles of their cells"},
    {name: "phase", kind: "float", label: "Phase", lowest: -FLOAT_MAX, highest: FLOAT_MAX,
     unset: "still", slider: [0, 1], step: 0.002, member: "phase",
     serves: noise => noise.basis === "gradient",
     hint: "Turns of the gradients: the noise flows, and loops after 1"},
    {name: "of-octaves", kind: "float", label: "Of octaves", lowest: TINY, highest: 32,
     unset: "octaves", slider: [1, 12], step: 0.05, member: "ofOctaves", serves: hasOctaves,
     hint: "Amplitudes are those of a sum of so many octaves"},
];

const SHAPE = [
    {name: "height", kind: "float", label: "Height", standard: 120, lowest: 0, highest: LARGE,
     slider: [0, 500], step: 1, hint: "Vertical size of value 1, in the unit of x and y"},
    {name: "sea-level", kind: "float", label: "Sea level", lowest: -LARGE, highest: LARGE,
     unset: "no sea", slider: [-1, 1], step: 0.005, hint: "Values below become this one"},
    {name: "plateau", kind: "float", label: "Plateau", lowest: -LARGE, highest: LARGE,
     unset: "none", slider: [-1, 1], step: 0.005, hint: "Values above become this one"},
    {name: "crater", kind: "float", label: "Crater rim", lowest: -LARGE, highest: LARGE,
     unset: "none", slider: [-1, 1], step: 0.005,
     hint: "What the noise has above is turned down, a crater in each summit"},
    {name: "stretch", kind: "double", label: "Stretch", standard: 1, lowest: 1 / 16, highest: 16,
     slider: [1 / 8, 8], scale: "log",
     hint: "How many times longer the noise is across the wind than along it"},
    {name: "wind", kind: "double", label: "Wind from", standard: 270, lowest: 0, highest: 360,
     slider: [0, 360], step: 1, hint: "Degrees clockwise from north"},
    {name: "terraces", kind: "float", label: "Terraces", standard: 0, lowest: 0, highest: 65536,
     slider: [0, 40], step: 0.5, hint: "How many per 1 of value; 0: none"},
    {name: "terrace-riser", kind: "float", label: "Riser", standard: 0.5, lowest: 2 ** -20,
     highest: 1, slider: [0.02, 1], step: 0.01, hint: "The part of a terrace that rises",
     shown: o => o.terraces !== 0},
    {name: "terrace-strength", kind: "float", label: "Strength", standard: 0.75, lowest: 0,
     highest: 1, slider: [0, 1], step: 0.01, hint: "How level the rest of a terrace is",
     shown: o => o.terraces !== 0},
];

const RASTER = [
    {name: "size", kind: "size", label: "Size", standard: "1024x1024",
     hint: "Samples across and down"},
    {name: "origin", kind: "point", label: "Origin", standard: "0,0", lowest: -(2 ** 53),
     highest: 2 ** 53, hint: "x,y of the bottom left sample"},
    {name: "step", kind: "double", label: "Step", standard: 1, lowest: 2 ** -48, highest: 2 ** 48,
     slider: [1 / 64, 64], scale: "log", hint: "Distance between samples"},
    {name: "period", kind: "size", label: "Period", unset: "never repeats",
     hint: "Repeats after so many samples, WxH, without a seam"},
];

const LIGHT = [
    {name: "azimuth", kind: "double", label: "Azimuth", standard: 315, lowest: 0, highest: 360,
     slider: [0, 360], step: 1, hint: "Where the light comes from, in degrees from north"},
    {name: "altitude", kind: "double", label: "Altitude", standard: 45, lowest: 0, highest: 90,
     slider: [0, 90], step: 1, hint: "Degrees above the horizon"},
    {name: "z-factor", kind: "float", label: "Exaggeration", standard: 1, lowest: 0,
     highest: LARGE, slider: [0, 5], step: 0.05, hint: "Multiplies heights for the light only"},
];

const REACH = {name: "warp-reach", kind: "zero-or-more", label: "Reach", standard: 0,
    lowest: 1 / LARGE, highest: LARGE, slider: [0, 200], step: 1, member: "amplitude",
    hint: "How far positions are displaced along each axis; 0: no warp"};
const BASE = {name: "base-amplitude", kind: "zero-or-magnitude", label: "Amplitude", standard: 0,
    lowest: 1 / LARGE, highest: LARGE, slider: [-2, 2], step: 0.05, member: "amplitude",
    hint: "How far another noise, which is added, moves values; 0: no base"};
const BAND = {name: "mask-band", kind: "point", label: "Band", standard: "0,0", lowest: -16,
    highest: 16,
    hint: "A,B: the noise fades in where the mask grows from A to B; equal numbers: no mask"};

// The rows of a noise beside the first one. Its seed and frequency are those of the first one.
function part(prefix, isThere) {
    return NOISE.filter(row => !row.first).map(row => ({
        ...row, name: prefix + row.name, base: row.name, prefix, shown: isThere,
        inherits: row.name === "seed" || row.name === "frequency",
    }));
}

export const hasWarp = options => options["warp-reach"] !== 0;
export const hasBase = options => options["base-amplitude"] !== 0;
export const hasMask = ({"mask-band": band}) => band === undefined || band[0] !== band[1];

// What `scarp terrain` has in place of the defaults of the library
const STANDARD = {seed: "1", frequency: 0.0025, octaves: 9, gain: 0.4};

export const GROUPS = [
    {id: "noise", title: "Noise", open: true, rows: NOISE.map(row => ({
        ...row, base: row.name, prefix: "", standard: STANDARD[row.name] ?? row.standard}))},
    {id: "terrain", title: "Terrain", open: true, rows: SHAPE},
    {id: "warp", title: "Warp", rows: [REACH, ...part("warp-", hasWarp)]},
    {id: "base", title: "Base", rows: [BASE, ...part("base-", hasBase)]},
    {id: "mask", title: "Mask", rows: [BAND, ...part("mask-", hasMask)]},
    {id: "raster", title: "Raster", rows: RASTER},
    {id: "light", title: "Light", rows: LIGHT},
];

export const ROWS = new Map(GROUPS.flatMap(group => group.rows).map(row => [row.name, row]));

// Parts of the name of options that follow the first noise, with what makes them be there
export const PARTS = {"warp-": hasWarp, "base-": hasBase, "mask-": hasMask};
