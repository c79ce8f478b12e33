// SPDX-License-Identifier: MIT
//
// Prints million samples per second of some calls, for each module: node bench.mjs
import { load } from './scarp.mjs';

const side = 1024,
    points = 4096;
const grid = { count: [side, side], step: [0.01, 0.01] };

function cases(scarp) {
    const floats = (n) => scarp.alloc(Float32Array, n);
    const value = floats(side * side),
        dx = floats(side * side),
        dy = floats(side * side);
    const own = { value: new Float32Array(side * side) };
    const x = floats(points),
        y = floats(points);
    for (let i = 0; i < points; i++) {
        x[i] = Math.random() * 1000;
        y[i] = Math.random() * 1000;
    }
    const cut = Object.fromEntries(
        Object.entries({ value, dx, dy }).map(([name, a]) => [name, a.subarray(0, points)]),
    );
    const few = { value: floats(1) };
    const one = [floats(1), floats(1)];
    return {
        'grid, value': [side * side, () => scarp.grid2({}, grid, { value })],
        'grid, value, copied': [side * side, () => scarp.grid2({}, grid, own)],
        'grid, gradient': [side * side, () => scarp.grid2({}, grid, { value, dx, dy })],
        'grid, 8 octaves, value': [side * side, () => scarp.grid2({ octaves: 8 }, grid, { value })],
        'grid, 8 octaves, gradient': [
            side * side,
            () => scarp.grid2({ octaves: 8 }, grid, { value, dx, dy }),
        ],
        'grid, 8 octaves, ridged': [
            side * side,
            () => scarp.grid2({ octaves: 8, fractal: 'ridged' }, grid, { value }),
        ],
        'points, value': [points, () => scarp.sample2({}, x, y, { value: cut.value })],
        'points, gradient': [points, () => scarp.sample2({}, x, y, cut)],
        'points, 8 octaves, gradient': [points, () => scarp.sample2({ octaves: 8 }, x, y, cut)],
        'points, simplex, value': [
            points,
            () => scarp.sample2({ basis: 'simplex' }, x, y, { value: cut.value }),
        ],
        'points, cell-f1, value': [
            points,
            () => scarp.sample2({ basis: 'cell-f1' }, x, y, { value: cut.value }),
        ],
        'one point': [1, () => scarp.sample2({}, ...one, few)],
    };
}

// The best of some rounds, each of 20 ms at least.
function rate(count, call) {
    let best = 0;
    for (let round = 0; round < 12; round++) {
        const start = performance.now();
        let calls = 0,
            time;
        do {
            call();
            calls++;
            time = performance.now() - start;
        } while (time < 20);
        best = Math.max(best, (count * calls) / time / 1000);
    }
    return best;
}

for (const simd of [true, false]) {
    const scarp = await load({ simd });
    console.log(`${scarp.isa}, million samples per second`);
    for (const [name, [count, call]] of Object.entries(cases(scarp))) {
        console.log(`  ${name.padEnd(30)} ${rate(count, call).toFixed(1).padStart(8)}`);
    }
}
