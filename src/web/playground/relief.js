// SPDX-License-Identifier: MIT
//
// The colours of the relief, as src/cli/look/relief.c: the palette's ramp at the height, mixed with
// sand, rock and snow, or water; then the light of sun and sky. All numbers are floats, and every
// operation rounds as it does there, so the bytes are those of `scarp terrain --relief`.

const f32 = Math.fround;
const RUN = 256; // pixels that go through the passes at once
const SUN = [1.06, 1.00, 0.90].map(f32);
const SKY = [0.27, 0.30, 0.36].map(f32);
const OPAQUE = 0xff000000;

const byte = number => f32(number / 255);

// A number that grows from 0 to 1 between two others, squared off
class Step {
    constructor([from, to]) {
        this.from = f32(from);
        this.per = f32(1 / f32(f32(to) - this.from));
    }

    at(x) {
        const t = f32(f32(x - this.from) * this.per), u = t < 0 ? 0 : t > 1 ? 1 : t;
        return f32(f32(u * u) * f32(3 - f32(2 * u)));
    }
}

const steps = (palette, names) => Object.fromEntries(names.map(name =>
    [name, new Step(palette[name])]));

// What is the same for all pixels
export function makeRelief(palette, spread, light) {
    const squares = colour => colour.map(byte).map(c => f32(c * c));
    const {low, middle, high, sea, deep} = spread;
    return {
        stops: palette.stops.map(([height, ...colour]) => [f32(height), ...colour.map(byte)]),
        ...steps(palette, ["rockSlope", "rockHeight", "snowHeight", "snowSlope", "sandHeight"]),
        rock: squares(palette.rock), highRock: squares(palette.highRock),
        snow: squares(palette.snow), sand: squares(palette.sand),
        shallow: palette.shallow.map(byte), deep: palette.deep.map(byte),
        east: f32(f32(palette.snowSun) * f32(light[0])),
        north: f32(f32(palette.snowSun) * f32(light[1])), steep: f32(palette.snowSteep),
        light: light.map(f32), hasSea: spread.hasSea, middle, sea,
        below: f32(f32(0.4) / f32(middle - low)), above: f32(f32(0.6) / f32(high - middle)),
        perDepth: f32(1 / f32(sea - deep)),
    };
}

// Arrays of a run, which are used again and again
const height = new Float32Array(RUN), share = new Float32Array(RUN);
const ground = [0, 1, 2].map(() => new Float32Array(RUN));

function takeRamp(stops, count) {
    const [red, green, blue] = ground;
    let next = 0; // the first stop above the height
    for (let i = 0; i < count; i++) {
        const h = height[i];
        while (next < stops.length && stops[next][0] <= h) {
            next++;
        }
        while (next > 0 && stops[next - 1][0] > h) {
            next--;
        }
        const b = stops[next < stops.length ? next : stops.length - 1];
        const a = next === 0 ? b : stops[next - 1];
        const t = a === b ? 0 : f32(f32(h - a[0]) / f32(b[0] - a[0]));
        const r = f32(a[1] + f32(f32(b[1] - a[1]) * t));
        const g = f32(a[2] + f32(f32(b[2] - a[2]) * t));
        const l = f32(a[3] + f32(f32(b[3] - a[3]) * t));
        red[i] = r * r;
        green[i] = g * g;
        blue[i] = l * l;
    }
}

// Mixes the pixels with a colour.
function mix(count, colour) {
    for (let c = 0; c < 3; c++) {
        const to = ground[c], square = colour[c];
        for (let i = 0; i < count; i++) {
            to[i] = to[i] + f32(f32(square - to[i]) * share[i]);
        }
    }
}

function takeGround(relief, nx, ny, nz, first, count) {
    const {east, north, steep, rockSlope, rockHeight, snowHeight, snowSlope, sandHeight} = relief;
    if (relief.hasSea) {
        for (let i = 0; i < count; i++) {
            share[i] = sandHeight.at(height[i]);
        }
        mix(count, relief.sand);
    }
    for (let i = 0; i < count; i++) {
        share[i] = rockSlope.at(nz[first + i]);
    }
    mix(count, relief.rock);
    for (let i = 0; i < count; i++) {
        share[i] = share[i] * rockHeight.at(height[i]);
    }
    mix(count, relief.highRock);
    for (let i = 0; i < count; i++) {
        const z = nz[first + i];
        const lower = f32(f32(f32(east * nx[first + i]) + f32(north * ny[first + i])) +
            f32(steep * f32(1 - z)));
        share[i] = snowHeight.at(f32(height[i] - lower)) * snowSlope.at(z);
    }
    mix(count, relief.snow);
}

function takeWater({sea, perDepth, shallow, deep}, bed, first, count) {
    const quarter = f32(0.25);
    for (let i = 0; i < count; i++) {
        const b = bed[first + i];
        if (b < sea) {
            const under = f32(f32(sea - b) * perDepth), depth = under > 0 ? under : 0;
            const share = f32(f32(1.25 * depth) / f32(depth + quarter));
            const t = share < 1 ? share : 1;
            for (let c = 0; c < 3; c++) {
                const colour = f32(shallow[c] + f32(f32(deep[c] - shallow[c]) * t));
                ground[c][i] = colour * colour;
            }
        }
    }
}

// The byte of a pixel: what is up to 3/4 stays, and all that is brighter is brought below 1.
function byteOf(square) {
    const four = f32(f32(4 * square) - 3), over = four > 0 ? four : 0;
    const kept = square < 0.75 ? square : 0.75;
    const soft = f32(kept + f32(0.25 * f32(over / f32(1 + over))));
    return f32(f32(f32(Math.sqrt(soft)) * 255) + 0.5) | 0;
}

function takeLight({light: [east, north, up]}, [x, y, z], first, count, pixels) {
    const [red, green, blue] = ground;
    for (let i = 0; i < count; i++) {
        const k = first + i;
        const lit = f32(f32(f32(east * x[k]) + f32(north * y[k])) + f32(up * z[k]));
        const direct = lit > 0 ? lit : 0, open = f32(0.5 + f32(0.5 * z[k]));
        const r = byteOf(f32(red[i] * f32(f32(SUN[0] * direct) + f32(SKY[0] * open))));
        const g = byteOf(f32(green[i] * f32(f32(SUN[1] * direct) + f32(SKY[1] * open))));
        const b = byteOf(f32(blue[i] * f32(f32(SUN[2] * direct) + f32(SKY[2] * open))));
        pixels[k] = r | g << 8 | b << 16 | OPAQUE;
    }
}

// `bed` has the values below the sea, too; normals are those of the ground, `shade` is lit.
export function reliefColours(relief, {value, bed, normal, shade}, pixels) {
    const {middle, below, above} = relief, lowest = f32(0.4);
    for (let first = 0; first < pixels.length; first += RUN) {
        const count = Math.min(RUN, pixels.length - first);
        for (let i = 0; i < count; i++) {
            const over = f32(value[first + i] - middle);
            height[i] = lowest + f32(over * (over < 0 ? below : above));
        }
        takeRamp(relief.stops, count);
        takeGround(relief, normal[0], normal[1], normal[2], first, count);
        if (relief.hasSea) {
            takeWater(relief, bed, first, count);
        }
        takeLight(relief, shade, first, count, pixels);
    }
}
