// SPDX-License-Identifier: MIT
//
// What the package adds to the calls of the library: modules, memory, words, plans.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { scarp_basis, scarp_fractal } from '../interface.mjs';
import { RecipeError, load } from '../scarp.mjs';

const scarp = await load({ memory: 2 ** 20 });

for (const name of ['scarp-simd', 'scarp-fallback']) {
    test(`${name} imports nothing`, async () => {
        const bytes = await readFile(new URL(`../${name}.wasm`, import.meta.url));
        assert.deepEqual(WebAssembly.Module.imports(await WebAssembly.compile(bytes)), []);
    });
}

test('without vectors, the other module is taken', async () => {
    const { validate } = WebAssembly;
    try {
        WebAssembly.validate = () => false;
        assert.equal((await load()).isa, 'generic');
    } finally {
        WebAssembly.validate = validate;
    }
    assert.equal((await load()).isa, 'wasm128');
});

test('words and versions', async () => {
    const { version } = JSON.parse(await readFile(new URL('../package.json', import.meta.url)));
    assert.equal(scarp.version, version);
    assert.equal(scarp.bases[0], 'gradient');
    assert.equal(scarp.bases.length, Object.keys(scarp_basis).length);
    assert.deepEqual(scarp.fades, ['quintic', 'cubic']);
    assert.equal(scarp.fractals.length, Object.keys(scarp_fractal).length);
    assert.deepEqual(scarp.isas, ['wasm128']);
    scarp.selectIsa('wasm128');
    scarp.selectIsa(null);
    assert.throws(() => scarp.selectIsa('avx2'), { code: 'SCARP_ERROR_UNSUPPORTED' });
    assert.throws(() => scarp.selectIsa('abc'), { code: 'SCARP_ERROR_ENUM' });
});

test('numbers serve as enumerators', () => {
    const x = Float32Array.of(0.3, 4.7),
        y = Float32Array.of(1.1, 2.6);
    const word = scarp.sample2({ basis: 'simplex', fractal: 'ridged' }, x, y, {
        value: new Float32Array(2),
    });
    const number = scarp.sample2({ basis: 2, fractal: 2 }, x, y, { value: new Float32Array(2) });
    assert.deepEqual(number, word);
});

test('outputs may replace inputs', () => {
    const noise = { octaves: 3 };
    const at = Float32Array.from({ length: 200000 }, (_, i) => i / 7);
    const expected = scarp.sample2(noise, at, at, { value: new Float32Array(200000) }).value;
    const x = at.slice();
    scarp.sample2(noise, x, at, { value: x });
    assert.deepEqual(x, expected);
    const a = { value: expected.slice() };
    scarp.affine(a, 2, 1, a);
    assert.deepEqual(
        a.value,
        expected.map((v) => Math.fround(Math.fround(2 * v) + 1)),
    );
});

test('blocks are reused, join, and are aligned', () => {
    const all = 2 ** 20 - 64;
    const blocks = Array.from({ length: 8 }, () => scarp.alloc(Float32Array, 1000));
    for (const block of blocks) {
        assert.equal(block.byteOffset % 64, 0);
        assert.ok(block.every((v) => v === 0));
        block.fill(1);
    }
    assert.throws(() => scarp.alloc(Uint32Array, all / 4), RangeError);
    for (const i of [3, 1, 2, 7, 0, 5, 6, 4]) {
        scarp.free(blocks[i]);
        assert.throws(() => scarp.free(blocks[i]), TypeError);
    }
    const large = scarp.alloc(Uint32Array, all / 4); // in one piece again
    assert.ok(large.every((v) => v === 0));
    scarp.free(large);
    scarp.free(scarp.alloc(Float64Array, 0));
    assert.throws(() => scarp.free(new Float32Array(1)), TypeError);
    assert.throws(() => scarp.alloc(Int8Array, 4), TypeError);
    assert.throws(() => scarp.alloc(Float32Array, -1), RangeError);
});

test('plans change no bit', () => {
    const noise = { basis: 'simplex', octaves: 5, seed: 8n, warp: { seed: 4 } };
    const x = Float64Array.of(0.3, 4.7, 1e6),
        y = Float64Array.of(1.1, 2.6, -3e6);
    for (const warp of [null, noise.warp]) {
        const plan = scarp.plan({ ...noise, warp }, 2);
        scarp.sample2({}, x, y, { value: new Float32Array(3) }); // another noise in between
        const kept = scarp.sample2(plan, x, y, { value: new Float32Array(3) });
        assert.deepEqual(
            kept,
            scarp.sample2({ ...noise, warp }, x, y, { value: new Float32Array(3) }),
        );
        assert.deepEqual(scarp.range(plan, 2), scarp.range({ ...noise, warp }, 2));
        scarp.freePlan(plan);
        assert.throws(() => scarp.freePlan(plan), TypeError);
        assert.throws(() => scarp.sample2(plan, x, y, { value: new Float32Array(3) }), TypeError);
    }
});

test('no points, no samples', () => {
    const none = new Float32Array(0);
    scarp.sample2({}, none, none, { value: none });
    scarp.grid2({}, { count: [0, 5] }, { value: none });
    scarp.grid3({}, { count: [4, 5, 0] }, {});
    scarp.add({}, {}, {});
    const out = {};
    assert.equal(scarp.sample2({}, Float32Array.of(1), Float32Array.of(2), out), out);
});

test('noiseCheck', () => {
    assert.equal(scarp.noiseCheck({ octaves: 8 }, 2), null);
    assert.equal(scarp.noiseCheck({ octaves: 99 }, 2).member, 'octaves');
    assert.equal(scarp.noiseCheck({ octaves: 4, ofOctaves: 3 }, 3).member, 'ofOctaves');
    assert.equal(scarp.noiseCheck({ octaves: 9, period: [0, 2 ** 29] }, 2).member, 'period[1]');
    assert.equal(scarp.noiseCheck({ basis: 'cell' }, 2).member, 'basis');
    assert.equal(scarp.noiseCheck({ warp: { gain: -1 } }, 2).member, 'warp.gain');
    assert.equal(scarp.noiseCheck({ warp: { basis: 'cell' } }, 2).member, 'warp.basis');
    assert.equal(scarp.noiseCheck({ octaves: 99 }, 2).text, 'outside (0, 32]');
    assert.equal(scarp.noiseCheck({}, 4).member, null);
    assert.equal(scarp.noiseCheck({}, 4).code, 'SCARP_ERROR_PARAMETER');
});

const LAND = `recipe 1
param height = 90 [0, 400]
param sharp = 0.25 [0.1, 1]
bend = noise(size=300, octaves=3, amplitude=60)
hills = warp(noise(ridged, size=200, octaves=5), bend)
out land = height * hills
out moist = 0.5 + 0.5 * noise(simplex, size=500)
`;

test('a recipe has parameters, outputs and an interval', () => {
    const recipe = scarp.recipe(LAND);
    assert.deepEqual(recipe.params, [
        { name: 'height', value: 90, lowest: 0, highest: 400 },
        { name: 'sharp', value: 0.25, lowest: 0.1, highest: 1 },
    ]);
    assert.deepEqual(
        recipe.outputs.map(({ name }) => name),
        ['land', 'moist'],
    );
    assert.deepEqual(recipe.range(), [0, 90]);
    assert.equal(recipe.set('height', 200), recipe);
    assert.equal(recipe.params[0].value, 200);
    assert.deepEqual(recipe.range(0), [0, 200]);
    assert.deepEqual(recipe.range(1), recipe.outputs[1].range);
    assert.equal(recipe.isSpace, false);
    recipe.free();
    const space = scarp.recipe('recipe 1\nspace 3\nout o = noise(size=9)\n');
    assert.equal(space.isSpace, true);
    space.free();
});

test('tile and scale of a recipe are those of a text', () => {
    const recipe = scarp.recipe('recipe 1\nout a = noise(size=2)\nout b = cell(noise(size=4))\n'),
        text = scarp.recipe(
            'recipe 1\ntile 16, 32\nout a = 3 * scale(noise(size=2), 2)\n' +
                'out b = scale(cell(noise(size=4)), 2)\n',
        );
    const sample = (of) => {
        const out = [{ value: new Float32Array(64) }, { value: new Float32Array(64) }];
        return of.grid({ count: [8, 8], step: [0.7, 3] }, out);
    };
    assert.notDeepEqual(sample(recipe), sample(text));
    assert.equal(recipe.scale(2, 3), recipe);
    assert.equal(recipe.tile(16, 32), recipe);
    assert.deepEqual(sample(recipe), sample(text));
    assert.deepEqual(
        recipe.entries.map(({ cell, jumps, dimensions }) => [...cell, jumps, dimensions]),
        [
            [4, 4, false, 2],
            [8, 8, true, 2],
        ],
    );
    recipe.free();
    text.free();
});

test('grids and points of a recipe agree, with several outputs', () => {
    const recipe = scarp.recipe(LAND),
        count = [37, 5];
    recipe.seed = -1;
    assert.equal(recipe.seed, 2n ** 64n - 1n);
    recipe.seed = -(2n ** 63n);
    assert.equal(recipe.seed, 2n ** 63n);
    recipe.seed = 12n;
    assert.equal(recipe.seed, 12n);
    const make = () => ({
        value: new Float32Array(185),
        dx: new Float32Array(185),
        dxy: new Float32Array(185),
    });
    const grid = [make(), make()],
        points = [make(), make()];
    const x = Float64Array.from({ length: 185 }, (_, i) => -40 + 8 * (i % 37)),
        y = Float64Array.from({ length: 185 }, (_, i) => 16 * Math.floor(i / 37));
    assert.equal(recipe.grid({ origin: [-40, 0], step: [8, 16], count }, grid), grid);
    assert.equal(recipe.sample2(x, y, points), points);
    assert.deepEqual(grid, points);
    assert.ok(new Set(grid[0].value).size > 100);
    const other = make();
    recipe.seed = 13n;
    recipe.sample2(x, y, other);
    assert.notDeepEqual(other, points[0]);
    recipe.free();
});

test('many points of a recipe are sampled in pieces', () => {
    const recipe = scarp.recipe(LAND);
    const n = 150000,
        x = Float32Array.from({ length: n }, (_, i) => i / 3);
    const { value } = recipe.sample2(x, x, { value: new Float32Array(n) });
    for (const i of [0, 70001, n - 1]) {
        const at = x.subarray(i, i + 1);
        const one = recipe.sample2(at, at, { value: new Float32Array(1) });
        assert.equal(one.value[0], value[i]);
    }
    recipe.free();
});

test('recipes give their memory back', () => {
    for (let i = 0; i < 200; i++) {
        scarp.recipe(LAND).free();
        assert.throws(() => scarp.recipe('recipe 1\n'), RecipeError);
    }
    const recipe = scarp.recipe(LAND);
    recipe.free();
    assert.throws(() => recipe.free(), /was freed/);
    assert.throws(() => recipe.set('height', 1), /was freed/);
    assert.throws(() => recipe.entries, /was freed/);
});
