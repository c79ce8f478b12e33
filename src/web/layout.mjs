// SPDX-License-Identifier: MIT
//
// The structures of scarp.h as they lie in the memory of the module, and how noises and grids are
// written there. module.c holds the numbers.

export const STATUS = Object.freeze({
    OK: 0,
    NULL: 1,
    ENUM: 2,
    PARAMETER: 3,
    SIZE: 4,
    UNSUPPORTED: 5,
});
const CODES = Object.keys(STATUS).map((name) =>
    name === 'OK' ? 'SCARP_OK' : 'SCARP_ERROR_' + name,
);

// What a call of the library returned, if that was not SCARP_OK.
export class ScarpError extends Error {
    constructor(status, text, member = null) {
        super(member === null ? text : `${member}: ${text}`);
        this.name = 'ScarpError';
        this.status = status; // as in STATUS
        this.code = CODES[status] ?? 'SCARP_ERROR'; // as scarp.h spells it
        this.member = member; // of the noise, or of the grid; null if none is at fault
    }
}

export const NOISE_SIZE = 192,
    GRID_SIZE = 192,
    ARRAYS_SIZE = 64,
    PLAN_SIZE = 12288;
export const GPU_PLAN_SIZE = 5376,
    GPU_ANSWERS = 4096;
export const LEVELS = 6; // a noise, its four warps, and one more, which the library refuses

export const SAMPLES = [
    'value',
    'dx',
    'dy',
    'dz',
    'dxx',
    'dxy',
    'dxz',
    'dyy',
    'dyz',
    'dzz',
    'dphase',
];
export const CELLS = ['f1', 'f2', 'id', 'x', 'y', 'z', 'dx1', 'dy1', 'dz1', 'dx2', 'dy2', 'dz2'];
export const FLOW = [
    'vx',
    'vy',
    'vz',
    'vxx',
    'vxy',
    'vxz',
    'vyx',
    'vyy',
    'vyz',
    'vzx',
    'vzy',
    'vzz',
];
export const PARTIALS = ['f', 'fa', 'fb', 'faa', 'fab', 'fbb'];

const ENUMERATORS = { basis: 0, fade: 4, fractal: 8 };
const FLOATS = {
    octaves: 32,
    lacunarity: 36,
    gain: 40,
    amplitude: 44,
    erosion: 48,
    phase: 52,
    jitter: 56,
    sharpness: 60,
    ofOctaves: 76,
};
const PERIOD = 64,
    WARP = 80,
    PLAN = 84;
const NOISE_MEMBERS = [
    ...Object.keys(ENUMERATORS),
    'rotate',
    'seed',
    'frequency',
    ...Object.keys(FLOATS),
    'period',
    'warp',
];
const GRID_MEMBERS = ['origin', 'step', 'first', 'count', 'rowStride', 'sliceStride'];

// Throws where an object has members that there are not: they may be misspelt.
export function checkMembers(what, object, members) {
    if (object === null || typeof object !== 'object' || ArrayBuffer.isView(object)) {
        throw new TypeError(`${what} must be an object`);
    }
    for (const name in object) {
        if (!members.includes(name)) {
            throw new TypeError(`${what} has no member "${name}"; there are ${members.join(', ')}`);
        }
    }
}

export function checkNumber(what, value) {
    if (typeof value !== 'number') {
        throw new TypeError(`${what} must be a number`);
    }
    return value;
}

const LIMIT = 2n ** 53n;

// An integer in [least, most], from a number or a BigInt. Others are as wrong as numbers that the
// library refuses.
function integer(name, value, least, most) {
    if (typeof value !== 'bigint' && typeof value !== 'number') {
        throw new TypeError(`${name} must be a number or a BigInt`);
    }
    if (typeof value === 'number' && !Number.isInteger(value)) {
        throw new ScarpError(STATUS.PARAMETER, 'an integer is needed', name);
    }
    const whole = BigInt(value);
    if (whole < least || whole > most) {
        throw new ScarpError(STATUS.PARAMETER, `out of range [${least}, ${most}]`, name);
    }
    return whole;
}

// A seed may be any of 64 bits. Numbers beyond 2^53 may have been rounded, which nobody wants.
export function seedOf(seed) {
    if (typeof seed === 'number' && !Number.isSafeInteger(seed)) {
        throw new ScarpError(
            STATUS.PARAMETER,
            'beyond 2^53 - 1, and for fractions, give a BigInt',
            'seed',
        );
    }
    return integer('seed', seed, 0n, 2n ** 64n - 1n);
}

function numbersOf(what, list, least, most) {
    if (
        !(Array.isArray(list) || ArrayBuffer.isView(list)) ||
        list.length < least ||
        list.length > most
    ) {
        throw new TypeError(
            `${what} must be ${least === most ? least : `${least} or ${most}`} numbers`,
        );
    }
    return Array.from(list);
}

function putEnumerator(view, at, name, value, words) {
    const number = typeof value === 'number' ? value : words[name].indexOf(value);
    if (!Number.isInteger(number) || number < 0 || number >= words[name].length) {
        throw new ScarpError(
            STATUS.ENUM,
            `there is no ${name} ${JSON.stringify(value)}; there are ` + words[name].join(', '),
            name,
        );
    }
    view.setUint32(at, number, true);
}

// Writes one level; its warp and plan stay 0.
function putLevel(view, at, noise, words) {
    checkMembers('a noise', noise, NOISE_MEMBERS);
    new Uint8Array(view.buffer, at, NOISE_SIZE).fill(0);
    for (const [name, offset] of Object.entries(ENUMERATORS)) {
        if (noise[name] !== undefined) {
            putEnumerator(view, at + offset, name, noise[name], words);
        }
    }
    for (const [name, offset] of Object.entries(FLOATS)) {
        if (noise[name] !== undefined) {
            view.setFloat32(at + offset, checkNumber(name, noise[name]), true);
        }
    }
    view.setUint32(at + 12, noise.rotate ? 1 : 0, true);
    view.setBigUint64(at + 16, seedOf(noise.seed ?? 0), true);
    view.setFloat64(at + 24, checkNumber('frequency', noise.frequency ?? 0), true);
    numbersOf('period', noise.period ?? [0, 0], 2, 3).forEach((cells, i) => {
        const whole = integer(`period[${i}]`, cells, 0n, 2n ** 30n);
        view.setUint32(at + PERIOD + 4 * i, Number(whole), true);
    });
}

// Writes a noise with its warps, one after the other.
export function putNoise(view, at, noise, words) {
    putLevel(view, at, noise, words);
    for (
        let level = 1;
        noise.warp !== undefined && noise.warp !== null && level < LEVELS;
        level++
    ) {
        noise = noise.warp;
        putLevel(view, at + level * NOISE_SIZE, noise, words);
        view.setUint32(at + (level - 1) * NOISE_SIZE + WARP, at + level * NOISE_SIZE, true);
    }
}

export function putPlan(view, at, plan) {
    view.setUint32(at + PLAN, plan, true);
}

// Reads the members of a grid, checks those that the library sees in parts only, and fills in
// what is left out.
export function readGrid(grid, dimensions) {
    checkMembers('a grid', grid, GRID_MEMBERS);
    const list = (name, other) =>
        numbersOf(name, grid[name] ?? Array(dimensions).fill(other), dimensions, dimensions);
    if (grid.count === undefined) {
        throw new TypeError('a grid needs a count along each axis');
    }
    const count = list('count').map((n, i) => Number(integer(`count[${i}]`, n, 0n, LIMIT)));
    const first = list('first', 0).map((n, i) => integer(`first[${i}]`, n, -LIMIT, LIMIT));
    first.forEach((n, i) =>
        integer(`first[${i}]`, n + BigInt(Math.max(count[i] - 1, 0)), -LIMIT, LIMIT),
    );
    const origin = list('origin', 0).map((x, i) => checkNumber(`origin[${i}]`, x));
    const step = list('step', 1).map((x, i) => checkNumber(`step[${i}]`, x));
    const rowStride = Number(integer('rowStride', grid.rowStride ?? 0, 0n, LIMIT)) || count[0];
    const slice = count[1] === 0 ? 0 : (count[1] - 1) * rowStride + count[0];
    const sliceStride =
        Number(integer('sliceStride', grid.sliceStride ?? 0, 0n, LIMIT)) || count[1] * rowStride;
    if (rowStride < count[0]) {
        throw new ScarpError(STATUS.PARAMETER, 'shorter than a row', 'rowStride');
    }
    if (dimensions === 3 && sliceStride < slice) {
        throw new ScarpError(STATUS.PARAMETER, 'shorter than a slice', 'sliceStride');
    }
    const slices = dimensions === 3 ? count[2] : 1;
    const empty = count.includes(0);
    return {
        origin,
        step,
        first,
        count: [...count, 1].slice(0, 3),
        rowStride,
        sliceStride,
        empty,
        length: empty ? 0 : (slices - 1) * sliceStride + slice,
    };
}

// Writes the part of a grid that begins at `from` and has `size` samples along each axis.
export function putGrid(view, at, grid, from, size, rowStride, sliceStride) {
    new Uint8Array(view.buffer, at, GRID_SIZE).fill(0);
    grid.origin.forEach((origin, i) => {
        view.setFloat64(at + 8 * i, origin, true);
        view.setFloat64(at + 24 + 8 * i, grid.step[i], true);
        view.setBigInt64(at + 48 + 8 * i, grid.first[i] + BigInt(from[i]), true);
        view.setUint32(at + 72 + 4 * i, size[i], true);
    });
    view.setUint32(at + 84, rowStride, true);
    view.setUint32(at + 88, sliceStride, true);
}
