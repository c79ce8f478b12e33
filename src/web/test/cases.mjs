// SPDX-License-Identifier: MIT
//
// The cases of expected.c, computed with the package: lines(scarp, copied) gives what that prints.
// Arrays are copied, or lie in the module's memory.
import { CHAIN } from './chain.mjs';

const POINTS = 301,
    MOST = 1024,
    ROW = 23,
    ROWS = 9,
    SLICE = ROW * ROWS + 4;
const SAMPLES = ['value', 'dx', 'dy', 'dz', 'dxx', 'dxy', 'dxz', 'dyy', 'dyz', 'dzz'];
const CELLS = ['f1', 'f2', 'id', 'x', 'y', 'z', 'dx1', 'dy1', 'dz1', 'dx2', 'dy2', 'dz2'];
const FLOW = ['vx', 'vy', 'vz', 'vxx', 'vxy', 'vxz', 'vyx', 'vyy', 'vyz', 'vzx', 'vzy', 'vzz'];

function* random(state) {
    for (;;) {
        state ^= state << 13;
        state ^= state >>> 17;
        state ^= state << 5;
        yield state >>> 0;
    }
}

function hashWords(hash, array) {
    for (const word of new Uint32Array(array.buffer, array.byteOffset, array.byteLength / 4)) {
        hash = Math.imul(hash ^ word, 16777619);
        hash ^= hash >>> 15;
    }
    return hash;
}

const hex = (hash) => (hash >>> 0).toString(16).padStart(8, '0');

export function lines(scarp, copied) {
    const text = [];
    const allocated = [];
    const make = (type, length) => {
        if (copied) {
            return new type(length);
        }
        allocated.push(scarp.alloc(type, length));
        return allocated.at(-1);
    };
    const line = (name, more, hash) => text.push(`${name}${more} ${hex(hash)}`);

    const single = [],
        double = [],
        random32 = random(20240229);
    for (let axis = 0; axis < 3; axis++) {
        single.push(make(Float32Array, POINTS));
        double.push(make(Float64Array, POINTS));
        for (let i = 0; i < POINTS; i++) {
            const x = ((random32.next().value >>> 8) - 2 ** 23) * 2 ** -14;
            single[axis][i] = x;
            double[axis][i] = x * 4097;
        }
    }
    const sets = [0, 1, 2].map(() => Array.from({ length: 16 }, () => make(Float32Array, MOST)));
    const clear = (set) => set.forEach((array) => array.fill(0));
    const hashArrays = (set) => set.reduce(hashWords, 2166136261);
    const points = (array) => array.subarray(0, POINTS);

    const ask = (set, dimensions, order, dphase, cut) => {
        clear(set);
        const out = {};
        SAMPLES.forEach((name, i) => {
            if (
                name === 'value' ||
                (name.length - 1 <= order && !(dimensions === 2 && name.includes('z')))
            ) {
                out[name] = cut(set[i]);
            }
        });
        if (dphase) {
            out.dphase = cut(set[10]);
        }
        return out;
    };

    const gridOf = (d) => {
        const grid = {
            origin: [-1.25, -1.25, -1.25],
            step: [0.0625, 0.125, 0.1875],
            first: [-3, 5, 2],
            count: [21, ROWS, 3],
        };
        for (const name of Object.keys(grid)) {
            grid[name] = grid[name].slice(0, d);
        }
        return { ...grid, rowStride: ROW, ...(d === 3 && { sliceStride: SLICE }) };
    };

    // Whether the noise has that output.
    const has = (noise, d, name) => {
        const at = new Float32Array(1);
        try {
            scarp[`sample${d}`](noise, ...[at, at, at].slice(0, d), { [name]: new Float32Array(1) });
            return true;
        } catch {
            return false;
        }
    };

    const visitNoise = (noise, d, more) => {
        const order = has(noise, d, 'dxx') ? 2 : 1;
        const dphase = has(noise, d, 'dphase');
        const out = ask(sets[0], d, order, dphase, points);
        scarp[`sample${d}`](noise, ...single.slice(0, d), out);
        line(`sample${d}`, more, hashArrays(sets[0]));
        scarp[`sample${d}`](noise, ...double.slice(0, d), out);
        line(`sample${d}_f64`, more, hashArrays(sets[0]));
        scarp[`grid${d}`](
            noise,
            gridOf(d),
            ask(sets[0], d, order, dphase, (array) => array),
        );
        line(`grid${d}`, more, hashArrays(sets[0]));
    };

    const visitBases = (d) => {
        scarp.bases.forEach((basis, b) =>
            scarp.fractals.forEach((fractal, f) => {
                const n = ((d - 2) * 8 + b) * 8 + f;
                const noise = {
                    basis,
                    fractal,
                    fade: scarp.fades[n % 2],
                    rotate: n % 3 === 0,
                    seed: BigInt.asUintN(64, 0x9e3779b97f4a7c15n * BigInt(n + 1)),
                    frequency: 0.37,
                    octaves: 3.5,
                };
                if (basis === 'gradient' && n % 2 === 1) {
                    noise.phase = 0.3125;
                }
                if (n % 4 === 2) {
                    noise.jitter = 0.75;
                }
                if (n % 5 === 1) {
                    noise.gain = 0.4375;
                    noise.lacunarity = 1.9375;
                }
                visitNoise(noise, d, ` ${basis} ${fractal}`);
            }),
        );
    };

    const visitSpecial = (d) => {
        const deep = { basis: 'value', seed: 3, amplitude: 0.5 };
        const warp = { basis: 'simplex', octaves: 2, warp: deep };
        visitNoise({ octaves: 3, amplitude: 2, warp }, d, ' warped');
        visitNoise(
            { octaves: 3, period: [3, 5, 7], ofOctaves: 6, seed: 2n ** 64n - 1n },
            d,
            ' periodic',
        );
        visitNoise(
            { fractal: 'pingpong', octaves: 2, sharpness: 1.5, amplitude: -3 },
            d,
            ' folded',
        );
        visitNoise({ fractal: 'erosion', octaves: 5, erosion: 0.3 }, d, ' eroded');
        visitNoise({ octaves: 2, seed: 6, offsetFirst: true }, d, ' first');
    };

    const visitFields = (d) => {
        const noise = { frequency: 0.25, seed: 11, jitter: 0.875 };
        const pick = (names) =>
            Object.fromEntries(
                names
                    .map((name, i) => [name, points(sets[0][i])])
                    .filter(([name]) => d === 3 || !name.includes('z'))
                    .map(([name, a]) => [
                        name,
                        name === 'id' ? new Uint32Array(a.buffer, a.byteOffset, POINTS) : a,
                    ]),
            );
        for (const [stem, names] of [
            ['cells', CELLS],
            ['curl', FLOW],
        ]) {
            clear(sets[0]);
            scarp[`${stem}${d}`](noise, ...single.slice(0, d), pick(names));
            line(`${stem}${d}`, '', hashArrays(sets[0]));
            scarp[`${stem}${d}`](noise, ...double.slice(0, d), pick(names));
            line(`${stem}${d}_f64`, '', hashArrays(sets[0]));
        }
    };

    const visitVector = (d) => {
        const noise = { octaves: 2, seed: 5, warp: { basis: 'value', seed: 6 } };
        const out = sets.slice(0, d).map((set) => ask(set, d, 2, true, points));
        for (const [more, position] of [
            ['', single],
            ['_f64', double],
        ]) {
            scarp[`vector${d}`](noise, ...position.slice(0, d), out);
            const hash = sets.slice(0, d).reduce((h, set) => set.reduce(hashWords, h), 2166136261);
            line(`vector${d}${more}`, '', hash);
        }
    };

    const visitChain = () => {
        const [a, b] = [sets[0], sets[1]].map((set) => ask(set, 3, 2, false, points));
        scarp.sample3({ octaves: 2 }, ...single, a);
        scarp.sample3({ basis: 'simplex' }, ...single, b);
        const partials = { f: a.value, fa: a.dx, fb: a.dy, faa: b.dx, fab: b.dy, fbb: b.dz };
        const calls = {
            curve: [a, [-0.25, 0.125, 0.5], [0, 1, 0.75]],
            slope: [a],
            apply1: [a, partials],
            apply2: [a, b, partials],
        };
        const simple = Object.entries(CHAIN).map(([name, [samples, numbers]]) => [
            name,
            [...samples.map((which) => (which === 'a' ? a : b)), ...numbers],
        ]);
        for (const [name, args] of [...simple, ...Object.entries(calls)]) {
            const out = ask(sets[2], 3, name === 'slope' ? 1 : 2, false, points);
            scarp[name](...args, out);
            line(name, '', hashArrays(sets[2]));
        }
        clear(sets[2]);
        const [nx, ny, nz] = sets[2].map(points);
        scarp.normals(a.dx, a.dy, 1.9, { nx, ny, nz });
        line('normals', '', hashArrays(sets[2]));
    };

    const visitRest = () => {
        const noise = { fractal: 'hybrid', octaves: 4.5, warp: { basis: 'simplex', seed: 5 } };
        for (const d of [2, 3]) {
            line('range', ` ${d}`, hashWords(2166136261, Float32Array.from(scarp.range(noise, d))));
            line('gpuPlan', ` ${d}`, hashWords(2166136261, scarp.gpuPlan(noise, d)));
            line('gpuAnswers', ` ${d}`, hashWords(2166136261, scarp.gpuAnswers(noise, d, 2)));
        }
    };

    const visitRecipe = (statements, d) => {
        const recipe = scarp.recipe(`recipe 1\n${statements.join('\n')}\n`);
        recipe.seed = 2n ** 64n - 7n;
        recipe.set('height', 2.5);
        const out = ask(sets[0], d, 2, false, points);
        recipe[`sample${d}`](...single.slice(0, d), out);
        line('recipe sample', ` ${d}`, hashArrays(sets[0]));
        recipe[`sample${d}`](...double.slice(0, d), out);
        line('recipe sample_f64', ` ${d}`, hashArrays(sets[0]));
        recipe.grid(
            gridOf(d),
            ask(sets[0], d, 2, false, (array) => array),
        );
        line('recipe grid', ` ${d}`, hashArrays(sets[0]));
        recipe.free();
    };

    const visitRecipes = () => {
        visitRecipe(
            [
                'param height = 1 [0, 4]',
                'bend = noise(size=3, octaves=3, amplitude=0.5)',
                'hills = warp(noise(ridged, size=2, octaves=5, rotate), bend)',
                'out land = height * max(hills, noise(simplex, size=5), smooth=0.25)',
            ],
            2,
        );
        visitRecipe(
            [
                'space 3',
                'param height = 1 [0, 4]',
                'out rock = height * noise(size=3, octaves=4) - 0.25 * z',
            ],
            3,
        );
    };

    for (const d of [2, 3]) {
        visitBases(d);
        visitSpecial(d);
        visitFields(d);
        visitVector(d);
    }
    visitChain();
    visitRest();
    visitRecipes();
    allocated.forEach((array) => scarp.free(array));
    return text;
}
