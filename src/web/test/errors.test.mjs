// SPDX-License-Identifier: MIT
//
// What is wrong throws before anything is written.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { RecipeError, STATUS, ScarpError, load } from '../scarp.mjs';

const scarp = await load();
const x = new Float32Array(8),
    y = new Float32Array(8),
    z = new Float32Array(8);
const out = (length = 8) => ({ value: new Float32Array(length).fill(7) });

// Checks what a call throws, and that it leaves `given` as it was.
function refuses(what, call, expected) {
    test(what, () => {
        const given = out();
        assert.throws(() => call(given), expected);
        assert.ok(
            given.value.every((v) => v === 7),
            'something was written',
        );
    });
}

const noises = {
    octaves: 33,
    lacunarity: 17,
    gain: NaN,
    amplitude: Infinity,
    frequency: -1,
    jitter: 2,
    sharpness: 1e9,
    erosion: -1,
    phase: Infinity,
};
for (const [member, value] of Object.entries(noises)) {
    refuses(`${member} ${value}`, (o) => scarp.sample2({ [member]: value }, x, y, o), {
        name: 'ScarpError',
        status: STATUS.PARAMETER,
        code: 'SCARP_ERROR_PARAMETER',
        member,
    });
}
for (const [member, value] of [
    ['basis', 'perlin'],
    ['fade', 'linear'],
    ['fractal', 'fBm'],
    ['basis', 8],
    ['fade', -1],
    ['fractal', 0.5],
    ['basis', null],
]) {
    refuses(`${member} ${value}`, (o) => scarp.sample2({ [member]: value }, x, y, o), {
        name: 'ScarpError',
        status: STATUS.ENUM,
        member,
    });
}
for (const seed of [-0.5, 0.5, 2 ** 53, -(2 ** 53), -(2n ** 63n) - 1n, 2n ** 64n, NaN]) {
    refuses(`seed ${seed}`, (o) => scarp.sample2({ seed }, x, y, o), {
        name: 'ScarpError',
        status: STATUS.PARAMETER,
        member: 'seed',
    });
}
refuses('period -1', (o) => scarp.sample2({ period: [4, -1] }, x, y, o), { member: 'period[1]' });
refuses('period 2^30 + 1', (o) => scarp.sample2({ period: [2 ** 30 + 1, 0] }, x, y, o), {
    member: 'period[0]',
});
refuses('a period along one axis', (o) => scarp.sample2({ period: [4] }, x, y, o), TypeError);
refuses('an octave as text', (o) => scarp.sample2({ octaves: '3' }, x, y, o), TypeError);
for (const [what, knots, values] of [
    ['no knots', undefined, [1, 2]],
    ['other values than knots', [0, 1, 2], [1, 2]],
    ['knots as text', ['0', '1'], [1, 2]],
]) {
    refuses(
        `a curve with ${what}`,
        (o) => scarp.curve({ value: x }, knots, values, o),
        (error) => error instanceof TypeError && !/undefined/.test(error.message),
    );
}
for (const [what, knots] of [
    ['one knot', [0]],
    ['knots out of order', [1, 0]],
    ['65 knots', Array.from({ length: 65 }, (_, i) => i)],
]) {
    refuses(`a curve with ${what}`, (o) => scarp.curve({ value: x }, knots, knots, o), {
        name: 'ScarpError',
        status: STATUS.PARAMETER,
    });
}
refuses(
    'a misspelt member',
    (o) => scarp.sample2({ octave: 3 }, x, y, o),
    /no member "octave"; there are basis/,
);
refuses(
    'a misspelt member of a warp',
    (o) => scarp.sample2({ warp: { sed: 3 } }, x, y, o),
    /"sed"/,
);
refuses(
    'five warps',
    (o) => scarp.sample2({ warp: { warp: { warp: { warp: { warp: {} } } } } }, x, y, o),
    { status: STATUS.UNSUPPORTED, member: 'warp.warp.warp.warp.warp' },
);
refuses(
    'a warp of itself',
    (o) => {
        const noise = {};
        noise.warp = noise;
        scarp.sample2(noise, x, y, o);
    },
    { status: STATUS.UNSUPPORTED, member: 'warp.warp.warp.warp.warp' },
);
refuses(
    'a phase of simplex noise',
    (o) => scarp.sample2({ basis: 'simplex', phase: 0.5 }, x, y, o),
    { status: STATUS.UNSUPPORTED, member: 'phase' },
);
for (const noise of [null, undefined, 3, 'gradient', new Float32Array(4)]) {
    refuses(`the noise ${noise}`, (o) => scarp.sample2(noise, x, y, o), TypeError);
}

refuses(
    'dz in 2D',
    (o) => scarp.sample2({}, x, y, { ...o, dz: new Float32Array(8) }),
    (error) =>
        error instanceof ScarpError && error.status === STATUS.UNSUPPORTED && error.member === null,
);
refuses(
    'a Hessian of erosion',
    (o) => scarp.sample3({ fractal: 'erosion' }, x, y, z, { ...o, dxx: new Float32Array(8) }),
    { status: STATUS.UNSUPPORTED },
);
const turned = { rotate: true, octaves: 2, period: [4, 4] };
const noHessian = 'fractal: this fractal has no Hessian';
const dxx = new Float32Array(8);
for (const [message, status, call] of [
    [
        'rotate: turned axes cannot repeat',
        STATUS.UNSUPPORTED,
        (o) => scarp.sample2(turned, x, y, o),
    ],
    [
        'warp.rotate: turned axes cannot repeat',
        STATUS.UNSUPPORTED,
        (o) => scarp.sample2({ warp: turned }, x, y, o),
    ],
    [
        'warp.ofOctaves: below octaves',
        STATUS.PARAMETER,
        (o) => scarp.sample2({ warp: { octaves: 3, ofOctaves: 2 } }, x, y, o),
    ],
    [
        'warp.warp.seed: out of range [-9223372036854775808, 18446744073709551615]',
        STATUS.PARAMETER,
        (o) => scarp.sample2({ warp: { warp: { seed: 2n ** 64n } } }, x, y, o),
    ],
    [
        noHessian,
        STATUS.UNSUPPORTED,
        (o) => scarp.sample2({ fractal: 'swiss' }, x, y, { ...o, dxx }),
    ],
    [
        `warp.${noHessian}`,
        STATUS.UNSUPPORTED,
        (o) => scarp.grid2({ warp: { fractal: 'swiss' } }, { count: [4, 2] }, { ...o, dxx }),
    ],
    [
        noHessian,
        STATUS.UNSUPPORTED,
        (o) => scarp.vector2({ fractal: 'jordan' }, x, y, [o, { dxy: dxx }]),
    ],
    [noHessian, STATUS.UNSUPPORTED, () => scarp.curl2({ fractal: 'jordan' }, x, y, { vxy: dxx })],
    [
        'basis: only gradient noise has dphase',
        STATUS.UNSUPPORTED,
        (o) => scarp.sample2({ basis: 'value' }, x, y, { ...o, dphase: dxx }),
    ],
    [
        'step[1]: not finite',
        STATUS.PARAMETER,
        (o) => scarp.grid2({}, { step: [1, Infinity], count: [4, 2] }, o),
    ],
    [
        'warp: more than 32 octaves in the noise and its warps',
        STATUS.UNSUPPORTED,
        () => scarp.gpuPlan({ octaves: 20, warp: { octaves: 20 } }, 2),
    ],
    [
        'octaves: more than 32 in all components',
        STATUS.UNSUPPORTED,
        () => scarp.gpuPlan({ basis: 'simplex', octaves: 20 }, 2, { vector: true }),
    ],
    [noHessian, STATUS.UNSUPPORTED, () => scarp.gpuAnswers({ fractal: 'erosion' }, 2, 2)],
    [
        'the order of derivatives is not 0, 1 or 2',
        STATUS.PARAMETER,
        () => scarp.gpuAnswers({}, 2, 3),
    ],
    ['gain: outside [1/16, 16]', STATUS.PARAMETER, () => scarp.plan({ gain: 99 }, 2)],
    ['dimensions are neither 2 nor 3', STATUS.PARAMETER, () => scarp.range({}, 4)],
]) {
    refuses(message, call, { name: 'ScarpError', message, status });
}
refuses('a bad member of a recipe', () => scarp.recipe('recipe 1\nout a = noise(gain=99)'), {
    name: 'RecipeError',
    message: 'line 2: gain: outside [1/16, 16]',
});
refuses(
    'a misspelt output',
    (o) => scarp.sample2({}, x, y, { ...o, values: new Float32Array(8) }),
    TypeError,
);
refuses(
    'doubles as output',
    (o) => scarp.sample2({}, x, y, { ...o, dx: new Float64Array(8) }),
    TypeError,
);
refuses(
    'a list as output',
    (o) => scarp.sample2({}, x, y, { ...o, dx: [0, 0, 0, 0, 0, 0, 0, 0] }),
    TypeError,
);
refuses('a list as coordinate', (o) => scarp.sample2({}, [1], [2], o), TypeError);
refuses('no coordinates', (o) => scarp.sample2({}, undefined, undefined, o), TypeError);
refuses('two types of coordinates', (o) => scarp.sample2({}, x, new Float64Array(8), o), TypeError);
refuses('a short coordinate', (o) => scarp.sample2({}, x, new Float32Array(7), o), RangeError);
refuses(
    'a short output',
    (o) => scarp.sample2({}, x, y, { ...o, dx: new Float32Array(7) }),
    RangeError,
);
refuses(
    'a long output',
    (o) => scarp.sample2({}, x, y, { ...o, dx: new Float32Array(9) }),
    RangeError,
);
refuses('the outputs forgotten', () => scarp.sample2({}, x, y), TypeError);
refuses('an id of floats', () => scarp.cells2({}, x, y, { id: new Float32Array(8) }), TypeError);

for (const where of ['beside it', 'in the module']) {
    test(`arrays that overlap, ${where}`, () => {
        const all = where === 'beside it' ? new Float32Array(20) : scarp.alloc(Float32Array, 20);
        const a = all.subarray(0, 8),
            b = all.subarray(4, 12),
            c = all.subarray(8, 16);
        scarp.sample2({}, x, y, { value: a, dx: c });
        scarp.sample2({}, a, a, { value: c });
        const before = all.slice();
        assert.throws(() => scarp.sample2({}, x, y, { value: a, dx: b }), RangeError);
        assert.throws(() => scarp.sample2({}, x, y, { value: a, dx: a }), RangeError);
        assert.throws(() => scarp.sample2({}, a, y, { value: b }), RangeError);
        assert.throws(
            () => scarp.grid2({}, { count: [3, 2], rowStride: 5 }, { value: a, dx: b }),
            RangeError,
        );
        assert.deepEqual(all, before);
    });
}

const grids = [
    [{ count: [4, 2], first: [2n ** 53n - 2n, 0] }, { member: 'first[0]' }],
    [{ count: [4, 2], first: [0, 0.5] }, { member: 'first[1]' }],
    [{ count: [4, -2] }, { member: 'count[1]' }],
    [{ count: [4, 2], rowStride: 3 }, { member: 'rowStride' }],
    [
        { count: [4, 2], step: [1, Infinity] },
        { status: STATUS.PARAMETER, member: 'step[1]' },
    ],
    [
        { count: [4, 2], origin: [NaN, 0] },
        { status: STATUS.PARAMETER, member: 'origin[0]' },
    ],
    [{ count: [4, 2], steps: [1, 1] }, TypeError],
    [{ count: [4, 2, 1] }, TypeError],
    [{ count: [4, 2], step: 1 }, TypeError],
    [{ count: 8 }, TypeError],
    [{}, TypeError],
    [{ count: [4, 3] }, RangeError],
    [{ count: [4, 2], rowStride: 5 }, RangeError],
];
grids.forEach(([grid, expected], i) => {
    refuses(`grid ${i}`, (o) => scarp.grid2({}, grid, o), expected);
});
refuses('a short slice', (o) => scarp.grid3({}, { count: [2, 2, 2], sliceStride: 3 }, o), {
    member: 'sliceStride',
});

refuses('a chain without values', (o) => scarp.multiply({ dx: x }, { dx: y }, o), {
    status: STATUS.NULL,
});
refuses(
    'a chain of two lengths',
    (o) => scarp.add({ value: x }, { value: new Float32Array(7) }, o),
    RangeError,
);
refuses('k of 0', (o) => scarp.smoothMin({ value: x }, { value: y }, 0, o), {
    status: STATUS.PARAMETER,
});
refuses('no k', (o) => scarp.smoothMin({ value: x }, { value: y }, o), TypeError);
refuses('lo above hi', (o) => scarp.clamp({ value: x }, 1, 0, o), { status: STATUS.PARAMETER });
refuses('a partial misspelt', (o) => scarp.apply1({}, { fx: x }, o), TypeError);
refuses('an infinite height', () => scarp.normals(x, y, Infinity, { nx: z }), {
    status: STATUS.PARAMETER,
});

test('load', async () => {
    await assert.rejects(load({ SIMD: false }), TypeError);
    for (const memory of [-1, NaN, 0.5, '1', 2 ** 53, 2 ** 33]) {
        await assert.rejects(load({ memory }), RangeError);
    }
    const none = await load({ memory: 0 });
    assert.throws(() => none.alloc(Float32Array, 1), RangeError);
    none.sample2({}, x, y, out());
});

test('shaders', () => {
    const many = { octaves: 20, warp: { octaves: 20 } };
    assert.throws(() => scarp.gpuPlan(many, 2), { status: STATUS.UNSUPPORTED, member: 'warp' });
    assert.throws(() => scarp.gpuAnswers({}, 2, 3), { status: STATUS.PARAMETER });
    assert.throws(() => scarp.gpuAnswers({ fractal: 'swiss' }, 2, 2), {
        status: STATUS.UNSUPPORTED,
    });
    assert.throws(() => scarp.range({ gain: 99 }, 2), { member: 'gain' });
    assert.throws(() => scarp.plan({ gain: 99 }, 2), { member: 'gain' });
});

test('errors of a recipe', () => {
    const text = 'recipe 1\nout a = noise(size=1, octaves=99)\nout b = c + 1\n';
    assert.throws(
        () => scarp.recipe(text),
        (error) => {
            assert.ok(error instanceof RecipeError && error instanceof ScarpError);
            assert.equal(error.status, STATUS.PARAMETER);
            assert.deepEqual(
                error.errors.map(({ line, column }) => [line, column]),
                [
                    [2, 31],
                    [3, 9],
                ],
            );
            assert.equal(text.slice(error.errors[0].from, error.errors[0].to), '99');
            assert.equal(error.errors[0].member, 'octaves');
            assert.equal(error.errors[0].nearest, null);
            assert.match(error.message, /^line 2: /);
            return true;
        },
    );
    assert.throws(
        () => scarp.recipe('recipe 1\ntile 100, 100\nout a = noise(size=30)\n'),
        ({ errors }) => Math.abs(errors[0].nearest - 100 / 3) < 1e-9,
    );
    assert.throws(() => scarp.recipe('#'.repeat(70000)), { status: STATUS.SIZE });
});

const recipe = scarp.recipe('recipe 1\nparam a = 1 [0, 2]\nout o = a * noise(size=4)\n');
const space = scarp.recipe('recipe 1\nspace 3\nout o = noise(size=4)\n');
refuses('two outputs of a recipe with one', (o) => recipe.sample2(x, y, [o, {}]), {
    status: STATUS.PARAMETER,
});
refuses('no outputs of a recipe', () => recipe.sample2(x, y, []), RangeError);
refuses('an output of a recipe misspelt', (o) => recipe.sample2(x, y, { ...o, dX: z }), TypeError);
refuses('dz of the plane', (o) => recipe.sample2(x, y, { ...o, dz: new Float32Array(8) }), {
    status: STATUS.UNSUPPORTED,
});
refuses(
    'an output that is a coordinate and another',
    (o) => recipe.sample2(x, y, [o, o]),
    RangeError,
);
refuses('a recipe of space at points of the plane', (o) => space.sample2(x, y, o), {
    status: STATUS.NULL,
});
refuses(
    'a grid of the plane for a recipe of space',
    (o) => space.grid({ count: [4, 2] }, o),
    Error,
);
refuses('a step of infinity', (o) => recipe.grid({ count: [4, 2], step: [1, Infinity] }, o), {
    status: STATUS.PARAMETER,
});
test('parameters of a recipe', () => {
    assert.throws(() => recipe.set('b', 1), { status: STATUS.PARAMETER, member: 'b' });
    assert.throws(() => recipe.set('a', 3), { status: STATUS.PARAMETER });
    assert.throws(() => recipe.set('a', '1'), TypeError);
    assert.throws(() => recipe.set('a', NaN), ScarpError);
    assert.throws(() => recipe.tile(1, -1), { status: STATUS.PARAMETER, member: 'tile' });
    assert.throws(() => recipe.tile('1', 1), TypeError);
    assert.throws(() => recipe.scale(0), { status: STATUS.PARAMETER, member: 'scale' });
    assert.throws(() => {
        recipe.seed = -(2n ** 63n) - 1n;
    }, ScarpError);
    assert.equal(recipe.params[0].value, 1);
});
