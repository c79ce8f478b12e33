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
    {name: "basis", kind: "choice", label: "Basis", choices: BASES, standard: "gradient",
     hint: "The noise of one octave"},
    {name: "fractal", kind: "choice", label: "Fractal", choices: FRACTALS, standard: "fbm",
     hint: "How octaves are summed"},
    {name: "frequency", kind: "double", label: "Frequency", standard: 1, lowest: 2 ** -32,
     highest: 2 ** 48, slider: [0.0005, 0.05], scale: "log",
     hint: "Lattice cells of the first octave per unit of x and y"},
    {name: "octaves", kind: "float", label: "Octaves", standard: 1, lowest: TINY, highest: 32,
     slider: [1, 12], step: 0.05,
     hint: "How many are summed; a fraction fades the last one in"},
    {name: "lacunarity", kind: "float", label: "Lacunarity", standard: 2, lowest: 1 / 16,
     highest: 16, slider: [1.5, 3.5], step: 0.01, serves: hasOctaves,
     hint: "Ratio of frequencies from octave to octave"},
    {name: "gain", kind: "float", label: "Gain", standard: 0.5, lowest: 1 / 16, highest: 16,
     slider: [0.1, 0.9], step: 0.005, serves: hasOctaves,
     hint: "Ratio of amplitudes from octave to octave"},
    {name: "amplitude", kind: "magnitude", label: "Amplitude", standard: 1, lowest: 1 / LARGE,
     highest: LARGE, slider: [-2, 2], step: 0.05,
     hint: "Scales values, and turns them over where it is negative"},
    {name: "rotate", kind: "flag", label: "Turn axes between octaves", standard: false,
     serves: hasOctaves, hint: "Hides the directions of the lattice"},
    {name: "fade", kind: "choice", label: "Fade", choices: FADES, standard: "quintic",
     serves: noise => ["gradient", "value"].includes(noise.basis),
     hint: "The blend between lattice points"},
    {name: "erosion", kind: "float", label: "Erosion", standard: 1, lowest: 1 / LARGE,
     highest: LARGE, slider: [0.01, 4], scale: "log",
     serves: isOneOf("erosion", "jordan"),
     hint: "How strongly slopes damp octaves; of jordan noise at most 1"},
    {name: "sharpness", kind: "float", label: "Sharpness", lowest: 2 ** -8, highest: 2 ** 8,
     unset: "by fractal", slider: [0.02, 4], scale: "log",
     serves: isOneOf("pingpong", "hybrid", "swiss", "jordan"),
     hint: "Folds of pingpong, offset of hybrid, bends of swiss and jordan"},
    {name: "jitter", kind: "float", label: "Jitter", standard: 1, lowest: TINY, highest: 1,
     slider: [0.01, 1], step: 0.01, serves: isCell,
     hint: "How far features stray from the middles of their cells"},
    {name: "phase", kind: "float", label: "Phase", lowest: -FLOAT_MAX, highest: FLOAT_MAX,
     unset: "still", slider: [0, 1], step: 0.002,
     serves: noise => noise.basis === "gradient",
     hint: "Turns of the gradients: the noise flows, and loops after 1"},
    {name: "of-octaves", kind: "float", label: "Of octaves", lowest: TINY, highest: 32,
     unset: "octaves", slider: [1, 12], step: 0.05, serves: hasOctaves,
     hint: "Amplitudes are those of a sum of so many octaves"},
];

const WORLD = [
    {name: "seed", kind: "seed", label: "Seed", standard: "1",
     hint: "An integer of 64 bits, decimal or 0x and hexadecimal. Arrow keys change it."},
];

const SHAPE = [
    {name: "height", kind: "float", label: "Height", standard: 120, lowest: 0, highest: LARGE,
     slider: [0, 500], step: 1, hint: "Vertical size of value 1, in the unit of x and y"},
    {name: "sea-level", kind: "float", label: "Sea level", lowest: -LARGE, highest: LARGE,
     unset: "no sea", slider: [-1, 1], step: 0.005, hint: "Noise values below become this one, as water"},
    {name: "plateau", kind: "float", label: "Plateau", lowest: -LARGE, highest: LARGE,
     unset: "none", slider: [-1, 1], step: 0.005, hint: "Noise values above become this one"},
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

// What `scarp terrain` has in place of the defaults of the library
const STANDARD = {frequency: 0.0025, octaves: 9, gain: 0.4};

// Of one noise are the first two groups; with a recipe, its parameters stand in their place.
export const GROUPS = [
    {id: "noise", title: "Noise", open: true, ofNoise: true, rows: NOISE.map(row => ({
        ...row, standard: STANDARD[row.name] ?? row.standard}))},
    {id: "terrain", title: "Terrain", open: true, ofNoise: true, rows: SHAPE},
    {id: "world", title: "World", rows: WORLD},
    {id: "raster", title: "Raster", rows: RASTER},
    {id: "light", title: "Light", rows: LIGHT},
];

export const ROWS = new Map(GROUPS.flatMap(group => group.rows).map(row => [row.name, row]));
export const OF_NOISE = new Set(GROUPS.filter(group => group.ofNoise).flatMap(group =>
    group.rows.map(row => row.name)));
