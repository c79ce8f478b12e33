// SPDX-License-Identifier: MIT
//
// How noises and grids are written as structures of scarp.h, which lie in the memory of the module as
// interface.mjs says.

import {
    SCARP_GPU_ANSWERS,
    scarp_cells,
    scarp_flow,
    scarp_gpu_plan,
    scarp_grid,
    scarp_noise,
    scarp_noise_types,
    scarp_partials,
    scarp_plan,
    scarp_samples,
    scarp_status,
} from './interface.mjs';

export const camel = (name) => name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());

// The members of a structure, as scarp.h spells them
const membersOf = (structure) => Object.keys(structure).filter((name) => name !== 'SIZE');

export const STATUS = Object.freeze(
    Object.fromEntries(
        Object.entries(scarp_status).map(([name, value]) => [
            name.replace(/^SCARP_(ERROR_)?/, ''),
            value,
        ]),
    ),
);
const CODES = Object.keys(scarp_status);

// What a call of the library returned, if that was not SCARP_OK.
export class ScarpError extends Error {
    constructor(status, text, member = null) {
        super(member === null ? text : `${member}: ${text}`);
        this.name = 'ScarpError';
        this.status = status; // as in STATUS
        this.code = CODES[status] ?? 'SCARP_ERROR'; // as scarp.h spells it
        this.member = member; // of the noise, as 'warp.octaves', or of the grid; null if none is
        this.text = text; // what is wrong, without the member
    }
}

export const NOISE_SIZE = scarp_noise.SIZE,
    GRID_SIZE = scarp_grid.SIZE,
    ARRAYS_SIZE = scarp_samples.SIZE, // of all structures of arrays: the largest
    PLAN_SIZE = scarp_plan.SIZE,
    GPU_PLAN_SIZE = scarp_gpu_plan.SIZE,
    GPU_ANSWERS = SCARP_GPU_ANSWERS;
export const LEVELS = 6; // a noise, its four warps, and one more, which the library refuses

export const SAMPLES = membersOf(scarp_samples);
export const CELLS = membersOf(scarp_cells);
export const FLOW = membersOf(scarp_flow);
export const PARTIALS = membersOf(scarp_partials);

const GRID_MEMBERS = membersOf(scarp_grid).map(camel);

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

// A seed may be any of 64 bits, or negative, which is 2^64 more. Numbers beyond 2^53 may have been
// rounded, which nobody wants.
export function seedOf(seed, name = 'seed') {
    if (typeof seed === 'number' && !Number.isSafeInteger(seed)) {
        throw new ScarpError(
            STATUS.PARAMETER,
            'beyond 2^53 - 1, and for fractions, give a BigInt',
            name,
        );
    }
    return BigInt.asUintN(64, integer(name, seed, -(2n ** 63n), 2n ** 64n - 1n));
}

function numbersOf(what, list, least, most) {
    if (
        !(Array.isArray(list) || ArrayBuffer.isView(list)) ||
        list.length < least ||
        list.length > most
    ) {
        const count = least === most ? `${least} ` : least > 0 ? `${least} or ${most} ` : '';
        throw new TypeError(`${what} must be ${count}numbers`);
    }
    return Array.from(list);
}

// How many knots a curve has. The library refuses too few and too many.
export function checkKnots(x, values) {
    const most = Number.MAX_SAFE_INTEGER;
    const knots = numbersOf('x', x, 0, most).map((value) => checkNumber('x', value)).length;
    numbersOf('values', values, knots, knots).forEach((value) => checkNumber('values', value));
    return knots;
}

function putEnumerator(view, at, name, value, words) {
    const number = typeof value === 'number' ? value : words.indexOf(value);
    if (!Number.isInteger(number) || number < 0 || number >= words.length) {
        throw new ScarpError(
            STATUS.ENUM,
            `there is no ${name.split('.').at(-1)} ${JSON.stringify(value)}; there are ` +
                words.join(', '),
            name,
        );
    }
    view.setUint32(at, number, true);
}

// How members of a noise are written, by their types. Names are paths, for errors.
const WRITERS = {
    enum: putEnumerator,
    float: (view, at, name, value) => view.setFloat32(at, checkNumber(name, value), true),
    double: (view, at, name, value) => view.setFloat64(at, checkNumber(name, value), true),
    uint32_t: (view, at, name, value) => view.setUint32(at, value ? 1 : 0, true), // a switch
    uint64_t: (view, at, name, value) => view.setBigUint64(at, seedOf(value, name), true),
    'uint32_t[3]': (view, at, name, value) =>
        numbersOf(name, value, 2, 3).forEach((cells, i) => {
            const whole = integer(`${name}[${i}]`, cells, 0n, 2n ** 30n);
            view.setUint32(at + 4 * i, Number(whole), true);
        }),
    pointer: () => {}, // its warp and its plan stay 0
};
const NOISE_MEMBERS = membersOf(scarp_noise).map((name) => ({
    name: camel(name),
    offset: scarp_noise[name],
    write: WRITERS[scarp_noise_types[name]],
}));
const NOISE_NAMES = NOISE_MEMBERS.map(({ name }) => name).filter((name) => name !== 'plan');

// Writes one level; `path` leads to it
function putLevel(view, at, noise, words, path) {
    checkMembers('a noise', noise, NOISE_NAMES);
    new Uint8Array(view.buffer, at, NOISE_SIZE).fill(0);
    for (const { name, offset, write } of NOISE_MEMBERS) {
        if (noise[name] !== undefined) {
            write(view, at + offset, path + name, noise[name], words[name]);
        }
    }
}

// Writes a noise with its warps, one after the other.
export function putNoise(view, at, noise, words) {
    putLevel(view, at, noise, words, '');
    for (
        let level = 1;
        noise.warp !== undefined && noise.warp !== null && level < LEVELS;
        level++
    ) {
        noise = noise.warp;
        putLevel(view, at + level * NOISE_SIZE, noise, words, 'warp.'.repeat(level));
        view.setUint32(
            at + (level - 1) * NOISE_SIZE + scarp_noise.warp,
            at + level * NOISE_SIZE,
            true,
        );
    }
}

export function putPlan(view, at, plan) {
    view.setUint32(at + scarp_noise.plan, plan, true);
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
    const { origin, step, first, count, row_stride, slice_stride } = scarp_grid;
    grid.origin.forEach((value, i) => {
        view.setFloat64(at + origin + 8 * i, value, true);
        view.setFloat64(at + step + 8 * i, grid.step[i], true);
        view.setBigInt64(at + first + 8 * i, grid.first[i] + BigInt(from[i]), true);
        view.setUint32(at + count + 4 * i, size[i], true);
    });
    view.setUint32(at + row_stride, rowStride, true);
    view.setUint32(at + slice_stride, sliceStride, true);
}
