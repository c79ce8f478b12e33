// SPDX-License-Identifier: MIT
//
// The package gives the bits of the C library: expected.txt is what expected.c prints, and a test
// of the library keeps it so.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { load } from '../scarp.mjs';
import { lines } from './cases.mjs';

const file = await readFile(new URL('./expected.txt', import.meta.url), 'utf8');
const expected = file.trimEnd().split('\n');

for (const simd of [true, false]) {
    for (const copied of [true, false]) {
        const name = `bits, ${simd ? 'vectors' : 'fallback'}, ${copied ? 'copied' : 'in place'}`;
        test(name, async () => {
            const scarp = await load({ simd });
            assert.equal(scarp.isa, simd ? 'wasm128' : 'generic');
            assert.deepEqual(lines(scarp, copied), expected);
        });
    }
}

// More than the stage holds at once: points and grids go in parts.
test('the parts of large arrays have the bits of the whole', async () => {
    const scarp = await load();
    const noise = { octaves: 2, seed: 5 };
    const count = 300001;
    const x = Float64Array.from({ length: count }, (_, i) => i / 64);
    const y = Float64Array.from({ length: count }, (_, i) => (i % 97) / 8);
    const inside = [x, y].map((array) => scarp.alloc(Float64Array, count));
    inside[0].set(x);
    inside[1].set(y);
    const whole = { value: scarp.alloc(Float32Array, count), dx: scarp.alloc(Float32Array, count) };
    const parts = { value: new Float32Array(count), dx: scarp.alloc(Float32Array, count) };
    scarp.sample2(noise, ...inside, whole);
    scarp.sample2(noise, x, y, parts);
    assert.deepEqual(parts.value, Float32Array.from(whole.value));
    assert.deepEqual(parts.dx, whole.dx);
});

for (const [name, count, strides] of [
    ['a long row', [400000, 2], {}],
    ['rows', [1000, 300], { rowStride: 1003 }],
    ['slices', [64, 48, 100], {}],
    ['large slices', [600, 300, 2], { rowStride: 601, sliceStride: 200000 }],
]) {
    test(`the parts of a grid have the bits of the whole: ${name}`, async () => {
        const scarp = await load();
        const grid = {
            count,
            step: count.map(() => 0.03),
            first: count.map((_, i) => 7 - i),
            ...strides,
        };
        const length =
            count.length === 2
                ? (strides.rowStride ?? count[0]) * count[1]
                : (strides.sliceStride ?? count[0] * count[1]) * count[2];
        const whole = {
            value: scarp.alloc(Float32Array, length),
            dy: scarp.alloc(Float32Array, length),
        };
        const parts = {
            value: new Float32Array(length).fill(9),
            dy: new Float32Array(length).fill(9),
        };
        whole.value.fill(9);
        whole.dy.fill(9); // what is between rows stays
        scarp[`grid${count.length}`]({}, grid, whole);
        scarp[`grid${count.length}`]({}, grid, parts);
        assert.ok(
            Buffer.compare(
                Buffer.from(parts.value.buffer),
                Buffer.from(Float32Array.from(whole.value).buffer),
            ) === 0,
        );
        assert.ok(
            Buffer.compare(
                Buffer.from(parts.dy.buffer),
                Buffer.from(Float32Array.from(whole.dy).buffer),
            ) === 0,
        );
    });
}
