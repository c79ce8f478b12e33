// SPDX-License-Identifier: MIT
//
// A terrain that repeats after whole numbers of samples: every noise takes the nearest frequency
// that has whole cells there, as `scarp terrain --period` does.

const FACTOR_MAX = 1.5; // how much higher than asked for a frequency may become
const CELLS_MAX = 2 ** 30;

function fail(option, message) {
    throw Object.assign(new Error(message), {option});
}

function commonDivisor(a, b) {
    while (b !== 0) {
        [a, b] = [b, a % b];
    }
    return a;
}

const nearestCells = (frequency, step, samples) =>
    Math.max(1, Math.floor(frequency * step * samples + 0.5));

// The axes that a preset turns are straightened; those that were asked for are refused.
function makeStraight(r) {
    if (r.noise.rotate && !(`${r.of}rotate` in r.preset)) {
        fail(`${r.of}rotate`, "axes that are turned do not repeat: leave this or the period out");
    }
    r.noise.rotate = false;
}

function setPeriod(r, times) {
    const cells = r.unit.map(unit => times * unit);
    if (cells.some(n => n > CELLS_MAX)) {
        fail("period", "has more than 2^30 cells of the first octave");
    }
    r.noise.period = [...cells, 0];
    r.noise.frequency = times / (r.period[0] / r.unit[0] * r.step);
}

function makeWhole(r) {
    const wanted = r.noise.frequency, side = r.period[0] / r.unit[0];
    const times = nearestCells(wanted, r.step * side, 1);
    const frequency = times / (side * r.step);
    if (frequency > FACTOR_MAX * wanted && r.unit[0] > 1 && r.unit[1] > 1) {
        fail("period", "sides with a larger common divisor come nearer to the frequency");
    }
    setPeriod(r, times);
}

// A stretched noise has a frequency of its own along each side.
function makeStretchedWhole(r, terrain) {
    if (terrain.wind !== 270 && !("wind" in r.preset)) {
        fail("wind", "a stretched terrain repeats with 270 only");
    }
    terrain.wind = 270;
    const frequency = r.noise.frequency;
    const across = nearestCells(frequency, r.step, r.period[0]);
    const down = nearestCells(frequency / terrain.stretch, r.step, r.period[1]);
    if (across > CELLS_MAX || down > CELLS_MAX) {
        fail("period", "has more than 2^30 cells of the first octave");
    }
    const common = commonDivisor(across, down);
    r.unit = [across / common, down / common];
    setPeriod(r, common);
    terrain.stretch = r.period[1] * r.step * r.noise.frequency / down;
}

// Changes the noises of a terrain, so that it repeats. `preset` has the options of the preset.
export function repeat(terrain, period, preset) {
    const common = commonDivisor(...period);
    const common_unit = period.map(side => side / common);
    const base = {period, preset, step: terrain.raster.step, unit: common_unit};
    const first = {...base, of: "", noise: terrain.noise};
    makeStraight(first);
    if (terrain.stretch !== 1) {
        makeStretchedWhole(first, terrain);
    } else {
        makeWhole(first);
    }
    const others = {warp: first.unit, base: common_unit, mask: common_unit};
    for (const [name, unit] of Object.entries(others)) {
        if (terrain[name]) {
            const other = {...base, unit, of: `${name}-`, noise: terrain[name]};
            makeStraight(other);
            makeWhole(other);
        }
    }
}
