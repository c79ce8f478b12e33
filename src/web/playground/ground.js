// SPDX-License-Identifier: MIT
//
// The terrain, as src/cli/ground/ground.c of the program has it, by the package's chain rule:
//
//     value = terraces(base(p) + mask(p) crater(noise(p))), at least `floor` and at most `ceiling`
//
// Values and gradients have the bits of `scarp terrain`; here there are second derivatives, too.

const f32 = Math.fround;
const FIRST = ["dx", "dy"];
const SECOND = ["dxx", "dxy", "dyy"];
const NO_HESSIAN = ["erosion", "swiss", "jordan"];

const within = (value, lowest, highest) =>
    value < lowest ? lowest : value > highest ? highest : value;

// The sine of degrees that is the same everywhere: see src/cli/shared/sine.c.
export function sine(degrees) {
    const quarters = Math.trunc(degrees / 90 + 0.5);
    const rest = degrees - 90 * quarters, x = rest * 0.017453292519943295;
    const odd = quarters % 2 !== 0;
    let sum = 1;
    for (let n = odd ? 18 : 19; n > 1; n -= 2) {
        sum = 1 - x * x / (n * (n - 1)) * sum;
    }
    const magnitude = odd ? sum : x * sum;
    return quarters % 4 < 2 ? magnitude : -magnitude;
}

// The interval that values never leave, in floats
function rangeOf(scarp, ground) {
    let [lowest, highest] = scarp.range(ground.noise, 2);
    if (highest > ground.rim) {
        const turned = f32(f32(2 * ground.rim) - highest);
        lowest = turned < lowest ? turned : lowest;
        highest = ground.rim;
    }
    if (ground.mask) {
        lowest = Math.min(lowest, 0);
        highest = Math.max(highest, 0);
    }
    if (ground.base) {
        const [below, above] = scarp.range(ground.base, 2);
        lowest = f32(lowest + below);
        highest = f32(highest + above);
    }
    if (ground.terraces !== 0) {
        lowest = f32(Math.floor(f32(lowest * ground.terraces)) / ground.terraces);
        highest = f32(Math.ceil(f32(highest * ground.terraces)) / ground.terraces);
    }
    return [lowest, highest];
}

// Makes the ground of a terrain of state.js.
export function makeGround(scarp, terrain) {
    const {noise, base, mask, stretch, wind} = terrain;
    const ground = {
        noise, base, mask, maskBand: terrain.maskBand, rim: terrain.crater,
        terraces: terrain.terraces, riser: terrain.terraceRiser,
        strength: terrain.terraceStrength, heightScale: terrain.height,
        isStretched: stretch !== 1, isAligned: wind === 270,
        along: [-sine(wind), -sine(wind + 90)],
        across: [sine(wind + 90) / stretch, -sine(wind) / stretch],
    };
    const [lowest, highest] = rangeOf(scarp, ground);
    const floor = within(terrain.seaLevel, lowest, highest);
    const ceiling = within(terrain.plateau, lowest, highest);
    return Object.assign(ground, {lowest, highest, floor, ceiling});
}

// The fractal for which there are no second derivatives, or null
export function withoutHessian({noise, base, mask}) {
    const found = [noise, noise.warp, base, mask].find(n => n && NO_HESSIAN.includes(n.fractal));
    return found ? found.fractal : null;
}

const piecesOf = (samples, from, to) => Object.fromEntries(
    Object.entries(samples).map(([name, array]) => [name, array.subarray(from, to)]));

// Turns slopes, and bends, along the axes of the noise to those along x and y.
function turn(ground, count, out) {
    if (!out.dx) {
        return;
    }
    const a = f32(ground.along[0]), b = f32(ground.along[1]);
    const c = f32(ground.across[0]), d = f32(ground.across[1]);
    const {dx, dy, dxx, dxy, dyy} = out;
    for (let i = 0; i < count; i++) {
        const u = dx[i], v = dy[i];
        dx[i] = f32(f32(a * u) + f32(c * v));
        dy[i] = f32(f32(b * u) + f32(d * v));
    }
    for (let i = 0; dxx && i < count; i++) {
        const uu = dxx[i], uv = dxy[i], vv = dyy[i];
        dxx[i] = a * a * uu + 2 * a * c * uv + c * c * vv;
        dxy[i] = a * b * uu + (a * d + b * c) * uv + c * d * vv;
        dyy[i] = b * b * uu + 2 * b * d * uv + d * d * vv;
    }
}

// Coordinates in the frame that has the wind along its first axis
function alongWind({along, across}, x, y) {
    const u = new Float64Array(x.length), v = new Float64Array(x.length);
    for (let i = 0; i < x.length; i++) {
        u[i] = along[0] * x[i] + along[1] * y[i];
        v[i] = across[0] * x[i] + across[1] * y[i];
    }
    return [u, v];
}

// The places of a grid as floats, which shaders take: those of the noise, and those of mask and
// base
export function floatPlaces(ground, grid) {
    const {x, y} = placesOf(grid), floats = list => list.map(array => Float32Array.from(array));
    const plain = floats([x, y]);
    return {plain, noise: ground.isStretched ? floats(alongWind(ground, x, y)) : plain};
}

// Samples of one ground at places of several kinds. Arrays are kept from call to call.
export class Sampler {
    constructor(scarp, ground) {
        this.scarp = scarp;
        this.ground = ground;
        this.kept = new Map();
    }

    // Arrays of another sample, with the members of `out`
    other(out, count) {
        const other = {};
        for (const name of Object.keys(out)) {
            let array = this.kept.get(name);
            if (!array || array.length < count) {
                array = new Float32Array(count);
                this.kept.set(name, array);
            }
            other[name] = array.subarray(0, count);
        }
        return other;
    }

    // Combines samples of the noise, in `out`, with mask and base, of which sample(noise, out)
    // gives the same places.
    combine(count, sample, out) {
        const {scarp, ground} = this, other = this.other(out, count);
        if (ground.rim < Infinity) {
            scarp.affine(out, -1, f32(2 * ground.rim), other);
            scarp.min(out, other, out);
        }
        if (ground.mask) {
            sample(ground.mask, other);
            scarp.smoothstep(other, ground.maskBand[0], ground.maskBand[1], other);
            scarp.multiply(out, other, out);
        }
        if (ground.base) {
            sample(ground.base, other);
            scarp.add(out, other, out);
        }
        if (ground.terraces !== 0) {
            scarp.terrace(out, ground.terraces, ground.riser, ground.strength, out);
        }
    }

    // Values and whatever else `out` has, before sea and plateau
    uncutGrid(grid, out) {
        const {scarp, ground} = this, count = grid.count[0] * grid.count[1];
        if (!ground.isStretched) {
            scarp.grid2(ground.noise, grid, out);
        } else if (ground.isAligned) {
            const times = n => n * ground.across[1];
            const origin = [grid.origin[0], times(grid.origin[1])];
            const step = [grid.step[0], times(grid.step[1])];
            scarp.grid2(ground.noise, {...grid, origin, step}, out);
            turn(ground, count, out);
        } else {
            const {x, y} = placesOf(grid);
            this.stretched(x, y, out);
        }
        this.combine(count, (noise, other) => scarp.grid2(noise, grid, other), out);
    }

    stretched(x, y, out) {
        this.scarp.sample2(this.ground.noise, ...alongWind(this.ground, x, y), out);
        turn(this.ground, x.length, out);
    }

    // The same at points, which are doubles
    uncutPoints(x, y, out) {
        const {scarp, ground} = this;
        if (ground.isStretched) {
            this.stretched(x, y, out);
        } else {
            scarp.sample2(ground.noise, x, y, out);
        }
        this.combine(x.length, (noise, other) => scarp.sample2(noise, x, y, other), out);
    }

    // Combines samples of each noise that were made elsewhere, at the same places.
    uncutGiven(given, out) {
        const put = (samples, to) => Object.keys(to).forEach(name => to[name].set(samples[name]));
        put(given.noise, out);
        if (this.ground.isStretched) {
            turn(this.ground, out.value.length, out);
        }
        this.combine(out.value.length, (noise, other) =>
            put(noise === this.ground.mask ? given.mask : given.base, other), out);
    }

    // What the sea covers or the plateau cuts off is flat.
    clamp(out) {
        const {floor, ceiling, lowest, highest} = this.ground, {value} = out;
        if (floor <= lowest && ceiling >= highest) {
            return;
        }
        const slopes = [...FIRST, ...SECOND].map(name => out[name]).filter(Boolean);
        for (let i = 0; i < value.length; i++) {
            if (value[i] >= floor && value[i] <= ceiling) {
                continue;
            }
            value[i] = value[i] < floor ? floor : ceiling;
            for (const slope of slopes) {
                slope[i] = 0;
            }
        }
    }
}

// The places of a grid as doubles
export function placesOf(grid) {
    const [across, down] = grid.count, count = across * down;
    const x = new Float64Array(count), y = new Float64Array(count);
    for (let i = 0; i < count; i++) {
        x[i] = grid.origin[0] + grid.step[0] * (grid.first[0] + i % across);
        y[i] = grid.origin[1] + grid.step[1] * (grid.first[1] + Math.floor(i / across));
    }
    return {x, y};
}

// Second derivatives as differences of exact first ones, along rows and down columns. The first
// and the last row are there for their neighbours alone.
export function differences(out, width, step) {
    const rows = out.value.length / width;
    for (let i = 0; i < out.value.length; i++) {
        const column = i % width, row = Math.floor(i / width);
        const a = column > 0 ? i - 1 : i, b = column < width - 1 ? i + 1 : i;
        const c = row > 0 ? i - width : i, d = row < rows - 1 ? i + width : i; // above, below
        out.dxx[i] = (out.dx[b] - out.dx[a]) / ((b - a || 1) * step);
        out.dyy[i] = (out.dy[c] - out.dy[d]) / (((d - c) / width || 1) * step);
        out.dxy[i] = (out.dy[b] - out.dy[a]) / ((b - a || 1) * step);
    }
}

// Rows `from` to `to` of a raster. Rows go down and y goes up, so the step along them is negative.
export function gridOf({width, height, origin, step}, from = 0, to = height) {
    return {origin: [...origin], step: [step, -step], first: [0, from - (height - 1)],
        count: [width, to - from]};
}

export {piecesOf};
