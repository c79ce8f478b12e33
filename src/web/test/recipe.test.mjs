// SPDX-License-Identifier: MIT
//
// What editors ask of a recipe: statements, parts, functions, errors, and samples of any node.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { scarp_scratch as SCRATCH } from '../interface.mjs';
import { PARTS, RecipeError, bind, load } from '../scarp.mjs';

const scarp = await load({ memory: 2 ** 22 });

const LAND = `# Hügel 🏔 und Täler
recipe 1
param height = 90 [0, 400] # für alle
bend = noise(size=300, octaves=3, amplitude=60)
hills = warp(noise(ridged, size=200, octaves=5), bend)
mask = smoothstep(hills, 0.25, hi=0.5)
out land = -height * hills^2 + 3
out moist = mix(bend, x, mask) # 🏔
`;

// Errors of `text` are allowed.
function withRecipe(text, use) {
    const recipe = scarp.recipe(text, { tolerant: true });
    try {
        return use(recipe);
    } finally {
        recipe.free();
    }
}

test('statements have their places in the string', () =>
    withRecipe(LAND, ({ entries, errors }) => {
        assert.deepEqual(errors, []);
        assert.deepEqual(
            entries.map(({ name, span }) => [name, LAND.slice(...span)]),
            [
                ['height', 'param height = 90 [0, 400] # für alle'],
                ['bend', 'bend = noise(size=300, octaves=3, amplitude=60)'],
                ['hills', 'hills = warp(noise(ridged, size=200, octaves=5), bend)'],
                ['mask', 'mask = smoothstep(hills, 0.25, hi=0.5)'],
                ['land', 'out land = -height * hills^2 + 3'],
                ['moist', 'out moist = mix(bend, x, mask) # 🏔'],
            ],
        );
        entries.forEach(({ index, name, nameSpan }, i) => {
            assert.equal(index, i);
            assert.equal(LAND.slice(...nameSpan), name);
        });
        assert.deepEqual(
            entries.map(({ kind }) => kind),
            ['number', 'noise', 'noise', 'field', 'field', 'field'],
        );
        assert.deepEqual(
            entries.map(({ isParam, output }) => [isParam, output]),
            [[true, -1], [false, -1], [false, -1], [false, -1], [false, 0], [false, 1]],
        );
        const [height, , , mask, land] = entries;
        assert.equal(height.value, 90);
        assert.deepEqual(height.slider, [0, 400]);
        assert.equal(height.part, -1);
        assert.deepEqual(mask.range, [0, 1]);
        assert.equal(land.axes, 3);
        assert.equal(land.order, 2);
        assert.match(land.hash, /^[0-9a-f]+$/);
    }));

test('parts are a tree', () =>
    withRecipe(LAND, ({ entries, parts }) => {
        const whole = parts[entries[4].part];
        assert.equal(LAND.slice(...whole.span), '-height * hills^2 + 3');
        assert.equal(whole.operation, '+');
        assert.equal(whole.parent, -1);
        const inside = (of) => parts.filter(({ parent }) => parent === of.index);
        const [product, three] = inside(whole);
        assert.equal(product.operation, '*');
        assert.deepEqual([three.kind, three.value], ['number', 3]);
        const [sign, power] = inside(product);
        assert.deepEqual([sign.operation, power.operation], ['-', '^']);
        const [name] = inside(sign);
        assert.deepEqual([name.name, name.entry, name.function], ['height', 0, -1]);
        assert.equal(LAND.slice(...name.nameSpan), 'height');

        const call = parts[entries[3].part];
        assert.equal(scarp.recipeFunctions[call.function].name, 'smoothstep');
        const given = inside(call);
        assert.deepEqual(
            given.map(({ argument }) => argument),
            ['', '', 'hi'],
        );
        assert.equal(given[0].argumentSpan, null);
        assert.equal(LAND.slice(...given[2].argumentSpan), 'hi');
        parts.forEach(({ index }, i) => assert.equal(index, i));
    }));

test('the functions are those of the language', () => {
    const functions = scarp.recipeFunctions;
    assert.equal(functions, scarp.recipeFunctions);
    const of = (name) => functions.find((each) => each.name === name);
    assert.equal(of('smoothstep').text, 'A mask: from 0 at lo to 1 at hi.');
    assert.deepEqual(of('smoothstep').arguments[1], {
        name: 'lo',
        text: 'the lower end',
        kind: 'number',
        isNeeded: true,
        otherwise: 0,
        lowest: -1,
        highest: 1,
        words: null,
    });
    const [basis] = of('noise').arguments;
    assert.equal(basis.kind, 'word');
    assert.deepEqual(basis.words, scarp.bases.map((word) => word.replace('-', '_')));
    assert.equal(of('noise').arguments.find(({ name }) => name === 'gain').otherwise, 0.5);
    assert.equal(of('curve').arguments.at(-1).kind, 'knot');
    assert.equal(of('warp').arguments[1].kind, 'noise');
    assert.ok(functions.length > 20 && functions.every(({ text }) => text.endsWith('.')));
});

test('a tolerant recipe tells what is wrong and reads the rest', () => {
    const wrong = LAND.replace('0.25', '🏔').replace('x, mask', 'y, mask, mask');
    withRecipe(wrong, (recipe) => {
        const { entries, errors } = recipe;
        assert.ok(errors.length >= 2);
        assert.equal(errors[0].line, 6);
        assert.equal(errors[0].from, wrong.indexOf('🏔', 12));
        assert.equal(errors[0].column, wrong.split('\n')[5].indexOf('🏔') + 1);
        assert.equal(errors.at(-1).line, 8);
        const kinds = Object.fromEntries(entries.map(({ name, kind }) => [name, kind]));
        assert.equal(kinds.hills, 'noise');
        assert.equal(kinds.mask, 'bad');
        const value = new Float32Array(4);
        const hills = entries.find(({ name }) => name === 'hills').index;
        recipe.grid({ count: [4, 1], step: [50, 50] }, { value }, { which: hills });
        assert.equal(new Set(value).size, 4);
        assert.throws(() => recipe.grid({ count: [4, 1] }, { value }, { which: 3 }), /\w/);
        assert.throws(() => recipe.grid({ count: [4, 1] }, { value }), /\w/);
    });
    assert.throws(() => scarp.recipe(wrong), RecipeError);
    assert.throws(() => scarp.recipe('#'.repeat(20000), { tolerant: true }), { status: 4 });
    assert.throws(() => scarp.recipe(LAND, { lenient: true }), TypeError);
});

test('any node may be sampled', () =>
    withRecipe(LAND, (recipe) => {
        const { entries, parts } = recipe;
        const x = Float64Array.from({ length: 60 }, (_, i) => 17 * i);
        const points = (which) => recipe.sample2(x, x, { value: new Float32Array(60) }, { which });
        const [bend, hills, mask, land] = [1, 2, 3, 4].map((n) => points(n).value);
        assert.deepEqual(land, recipe.sample2(x, x, { value: new Float32Array(60) }).value);
        assert.deepEqual(points(PARTS + entries[2].part).value, hills);
        const power = parts.find(({ operation }) => operation === '^').index;
        assert.deepEqual(points(PARTS + power).value, hills.map((v) => Math.fround(v * v)));
        const both = [{ value: new Float32Array(60) }, { value: new Float32Array(60) }];
        recipe.sample2(x, x, both, { which: [3, 1] });
        assert.deepEqual([both[0].value, both[1].value], [mask, bend]);
        const grid = { count: [60, 1], step: [17, 17] };
        const rows = recipe.grid(grid, { value: new Float32Array(60) }, { which: 2 });
        assert.equal(rows.value[0], hills[0]);
        assert.deepEqual(recipe.range(0, { which: 3 }), [0, 1]);
        const [low, high] = recipe.range(0, {
            which: PARTS + parts.find(({ name }) => name === 'x').index,
            box: { lowest: [-5, 0], highest: [7, 1] },
        });
        assert.ok(low <= -5 && low > -5.01 && high >= 7 && high < 7.01);
        assert.deepEqual(recipe.range(1), entries[5].range);
        for (const which of [-1, 0.5, 'land', [1, 2]]) {
            assert.throws(() => points(which), RangeError);
        }
        assert.throws(() => points(99));
        assert.throws(() => recipe.range(2));
    }));

test('hashes tell what has to be drawn anew', () => {
    const hashes = (text) =>
        withRecipe(text, ({ entries }) => Object.fromEntries(entries.map((e) => [e.name, e.hash])));
    const before = hashes(LAND),
        after = hashes(LAND.replace('octaves=3', 'octaves=4').replace('recipe 1\n', 'recipe 1\n\n'));
    const changed = Object.keys(before).filter((name) => before[name] !== after[name]);
    assert.deepEqual(changed, ['bend', 'hills', 'mask', 'land', 'moist']);
    assert.deepEqual(hashes(LAND.replace('hi=0.5', 'hi=0.6')).hills, before.hills);
});

// The hash of header and shaders, of outputs one after the other
function hashOf(outputs) {
    const bits = new Uint32Array(Float32Array.from(outputs).buffer);
    return bits.reduce((hash, word) => {
        const counted = (word & 0x7fffffff) < 0x03800000 ? 0 : word;
        return Math.imul(((hash << 5) | (hash >>> 27)) ^ counted, 0x9e3779b9) >>> 0;
    }, 0);
}

test('a shader is cut to what it uses, and has its numbers in a buffer', () => {
    const text = 'recipe 1\nparam k = 2 [0, 9]\nout land = k * noise(octaves=3, rotate)\n';
    const files = ['glsl', 'hlsl', 'wgsl'].map((language) =>
        readFileSync(new URL(`../scarp.${language}`, import.meta.url), 'utf8'),
    );
    withRecipe(text, (recipe) => {
        const wgsl = recipe.shader('wgsl', files[2], { order: 2 });
        assert.match(wgsl, /fn scarp_recipe_land\(x: f32, y: f32\) -> ScarpSample \{/);
        assert.ok(wgsl.length < files[2].length / 2);
        assert.ok(!wgsl.includes('scarp_simplex_at'));
        assert.match(recipe.shader('glsl', files[0]), /ScarpSample scarp_recipe_land\(float x/);
        assert.match(recipe.shader('hlsl', files[1]), /cbuffer ScarpRecipePlans/);
        const [numbers, levels, octaves] = [...wgsl.matchAll(/array<\w+, (\d+)>/g)].map(
            ([, count]) => Number(count),
        );
        const before = recipe.uniforms();
        assert.equal(before.length, 16 + 16 * numbers + 48 * levels + 160 * octaves);
        recipe.set('k', 3);
        assert.notDeepEqual(recipe.uniforms(), before);
        assert.equal(recipe.shader('wgsl', files[2], { order: 2 }), wgsl);
        const unit = new DataView(before.buffer).getFloat32(4, true);
        assert.ok(Number.isInteger(Math.log2(unit)));
        assert.throws(() => recipe.shader('metal', files[0]), TypeError);
        assert.throws(() => recipe.shader('wgsl', files[2], { order: 3 }), {
            code: 'SCARP_ERROR_PARAMETER',
        });
        assert.throws(() => recipe.shader('wgsl', 'no shader'), { code: 'SCARP_ERROR_PARAMETER' });
    });
    withRecipe('recipe 1\nparam k = 1.5\nout a = k + 0 * x\n', (recipe) => {
        assert.deepEqual([...new Set(recipe.answers(0))], [hashOf([1.5])]);
        assert.deepEqual([...new Set(recipe.answers())], [hashOf([1.5, 0, 0])]);
        assert.equal(recipe.answers().length, 4096);
    });
});

test('plans of vector noise have octaves for each component', () => {
    const noise = { basis: 'simplex', octaves: 3 };
    const [one, all] = [false, true].map((vector) => scarp.gpuPlan(noise, 3, { vector }));
    assert.equal(all.length, one.length);
    assert.notDeepEqual(all, one);
    assert.throws(() => scarp.gpuPlan({ ...noise, octaves: 11 }, 3, { vector: true }), {
        member: 'octaves',
    });
});

test('calls work in memory of the best size, and in less where there is no more', async () => {
    const sum = Array.from({ length: 23 }, (_, i) => `n${i}`).join(' + ');
    const noises = Array.from({ length: 23 }, (_, i) => `n${i} = noise(size=30, seed=${i})\n`);
    const all = Array.from({ length: 23 }, (_, i) => `n${i} * sum`).join(' + ');
    const text = `recipe 1\n${noises.join('')}sum = ${sum}\nall = ${all}\nout a = 2 * n1\n`;
    const grid = { count: [100, 80], step: [3, 4] },
        names = ['value', 'dx', 'dyy'];
    const sample = (recipe, which) => {
        const arrays = (length) =>
            Object.fromEntries(names.map((name) => [name, new Float32Array(length)]));
        const out = arrays(8000),
            one = arrays(1);
        recipe.grid(grid, out, { which });
        recipe.sample2(new Float64Array([3 * 99]), new Float64Array([4 * 79]), one, { which });
        names.forEach((name) => assert.equal(one[name][0], out[name][7999]));
        return out;
    };
    const tight = await load({ memory: 130 * 1024 });
    const large = scarp.recipe(text),
        inside = tight.recipe(text);
    for (const { index, name } of large.entries.filter(({ name }) => /^(a|all)$/.test(name))) {
        assert.deepEqual(sample(inside, index), sample(large, index), name);
    }
    tight.alloc(Float32Array, 8000); // what calls work in gives way
    assert.throws(() => tight.alloc(Float32Array, 8000), RangeError);
    large.free();
});

test('recipes share what calls work in, and change apart', () => {
    const [a, b] = [scarp.recipe(LAND), scarp.recipe(LAND)];
    const value = () => new Float32Array(5000);
    const grid = { count: [100, 50], step: [9, 9] };
    const before = a.grid(grid, { value: value() }).value;
    b.set('height', 180);
    const higher = b.grid(grid, { value: value() }).value;
    assert.notDeepEqual(higher, before);
    assert.deepEqual(a.grid(grid, { value: value() }).value, before);
    a.free();
    assert.deepEqual(b.grid(grid, { value: value() }).value, higher);
    b.free();
});

test('calls bring the plan of the recipe as it is', async () => {
    const bytes = readFileSync(new URL('../scarp-simd.wasm', import.meta.url));
    const { exports } = (await WebAssembly.instantiate(bytes)).instance;
    const places = []; // of recipes and of the scratch structures of calls
    const watched = Object.fromEntries(
        ['scarp_recipe_sample', 'scarp_recipe_sample_f64', 'scarp_recipe_grid'].map((name) => [
            name,
            (...all) => {
                places.push([all[0], all.at(-1)]);
                return exports[name](...all);
            },
        ]),
    );
    const bound = bind({ ...exports, ...watched }, 2 ** 22);
    const recipe = bound.recipe(LAND);
    const check = () => {
        recipe.sample2(new Float32Array(1), new Float32Array(1), { value: new Float32Array(1) });
        recipe.sample2(new Float64Array(1), new Float64Array(1), { value: new Float32Array(1) });
        recipe.grid({ count: [4, 3] }, { value: new Float32Array(12) });
        assert.equal(places.length, 3);
        for (const [at, scratch] of places.splice(0)) {
            const plan = new DataView(exports.memory.buffer).getUint32(scratch + SCRATCH.plan, true);
            const size = exports.scarp_recipe_plan_size(at);
            const fresh = bound.alloc(Uint32Array, Math.ceil(size / 4));
            assert.equal(exports.scarp_recipe_plan_make(at, fresh.byteOffset, size), 0);
            const bytesAt = (place) => new Uint8Array(exports.memory.buffer, place, size).slice();
            assert.ok(size > 0 && plan > 0);
            assert.deepEqual(bytesAt(plan), bytesAt(fresh.byteOffset));
            bound.free(fresh);
        }
    };
    check();
    recipe.seed = 7;
    check();
    recipe.set('finest', 50);
    check();
    assert.throws(() => recipe.set('height', -1));
    recipe.scale(2, 3);
    check();
    recipe.free();
    bound.alloc(Float32Array, (2 ** 22 - 128) / 4); // nothing is left behind
});
