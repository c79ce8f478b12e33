// SPDX-License-Identifier: MIT
//
// scarp for JavaScript: const scarp = await load(). The calls are those of scarp.h, on typed
// arrays. An array may be any; those of scarp.alloc() are not copied. Everything is checked before
// anything is written.
import {
    ARRAYS_SIZE,
    CELLS,
    FLOW,
    GPU_ANSWERS,
    GPU_PLAN_SIZE,
    GRID_SIZE,
    LEVELS,
    NOISE_SIZE,
    PARTIALS,
    PLAN_SIZE,
    SAMPLES,
    STATUS,
    ScarpError,
    camel,
    checkKnots,
    checkMembers,
    checkNumber,
    putGrid,
    putNoise,
    putPlan,
    readGrid,
    seedOf,
} from './layout.mjs';
import { compile, hasVectors } from './compile.mjs';
import { Memory, checkArray, checkOverlaps, isArray } from './memory.mjs';

import { PARTS, Recipe, RecipeError, functionsOf } from './recipe.mjs';

export { PARTS, RecipeError, STATUS, ScarpError };

// The derivatives that arrays ask of a noise. The Jacobian of a velocity takes those of order 2.
function askedOf(uses) {
    const has = (pattern) => uses.some(({ name, out }) => out && pattern.test(name));
    return { order: has(/\.[dv][xyz]{2}$/) ? 2 : 0, dphase: has(/\.dphase$/) };
}

// A noise that is checked and ready, for many calls with few points.
class Plan {
    constructor(at, dimensions) {
        this.at = at;
        this.dimensions = dimensions;
        Object.freeze(this);
    }
}

class Scarp {
    #exports;
    #memory;
    #words; // of the enumerators
    #at; // where structures are
    #plans = new Set();
    #functions = null;

    constructor(exports, bytes) {
        const sizes = {
            noise: LEVELS * NOISE_SIZE,
            grid: GRID_SIZE,
            out: 3 * ARRAYS_SIZE, // vector noise has one for each component
            a: ARRAYS_SIZE,
            b: ARRAYS_SIZE,
            m: ARRAYS_SIZE,
            pointers: ARRAYS_SIZE,
        };
        const fixed = Object.values(sizes).reduce((sum, size) => sum + size, 0);
        this.#exports = exports;
        this.#memory = new Memory(exports.memory, exports.__heap_base.value, fixed, bytes);
        this.#at = {};
        let at = this.#memory.base;
        for (const [name, size] of Object.entries(sizes)) {
            this.#at[name] = at;
            at += size;
        }
        const names = (call) => {
            const list = [];
            for (let name; (name = this.#memory.text(call(list.length))) !== null;) {
                list.push(name);
            }
            return Object.freeze(list);
        };
        this.#words = {
            basis: names(exports.scarp_basis_name),
            fade: names(exports.scarp_fade_name),
            fractal: names(exports.scarp_fractal_name),
            isa: names(exports.scarp_isa_name),
        };
    }

    get version() {
        return this.#memory.text(this.#exports.scarp_version());
    }
    get bases() {
        return this.#words.basis;
    }
    get fades() {
        return this.#words.fade;
    }
    get fractals() {
        return this.#words.fractal;
    }

    // Kernel sets: the one in use, and all that run here.
    get isa() {
        return this.#words.isa[this.#exports.scarp_isa_active()];
    }
    get isas() {
        return this.#words.isa.filter((_, isa) => this.#exports.scarp_isa_supported(isa));
    }
    selectIsa(name) {
        const isa = name === null ? 0 : this.#words.isa.indexOf(name);
        this.#expect(this.#exports.scarp_isa_select(isa));
    }

    // Arrays in the module's memory, which calls read and write in place.
    alloc(type, length) {
        if (![Float32Array, Float64Array, Uint32Array].includes(type)) {
            throw new TypeError('alloc() makes a Float32Array, a Float64Array or a Uint32Array');
        }
        if (!Number.isSafeInteger(length) || length < 0) {
            throw new RangeError('a length is an integer, and not negative');
        }
        const at = this.#memory.allocate(length * type.BYTES_PER_ELEMENT);
        return new type(this.#memory.buffer, at, length).fill(0);
    }
    free(array) {
        if (!ArrayBuffer.isView(array) || !this.#memory.holds(array)) {
            throw new TypeError('this is no array of alloc(), or it was freed before');
        }
        this.#memory.release(array.byteOffset);
    }

    #text(status) {
        return this.#memory.text(this.#exports.scarp_status_text(status));
    }

    // Throws what a status says; of a noise, with the member at fault, and why. `asked`: see #fault.
    #expect(status, noise = 0, dimensions = 0, asked = {}) {
        if (status !== STATUS.OK) {
            const fault = noise === 0 ? null : this.#fault(noise, dimensions, asked);
            throw fault !== null && fault.status === status
                ? fault
                : new ScarpError(status, this.#text(status));
        }
    }

    // What is wrong with a noise, or what it lacks of the derivatives that are asked for, or null
    #fault(noise, dimensions, { order = 0, dphase = false } = {}) {
        const own = this.#exports.scarp_noise_check(noise, dimensions, 0);
        const lacking = [0, 1, 2].includes(order) ? STATUS.UNSUPPORTED : STATUS.PARAMETER;
        return this.#told(
            own === STATUS.OK ? lacking : own,
            'scarp_noise_fault',
            noise,
            dimensions,
            order,
            dphase,
        );
    }

    // What a call of the library, which takes a place for a member last, tells of a fault, or null
    #told(status, call, ...parameters) {
        const at = this.#at.pointers;
        const text = this.#memory.text(this.#exports[call](...parameters, at));
        return text === null
            ? null
            : new ScarpError(status, text, this.#member(this.#memory.view.getUint32(at, true)));
    }

    // A member as it is called here, from the name that the library gives.
    #member(at) {
        const name = this.#memory.text(at);
        return name === null ? null : camel(name);
    }

    // Where the noise is: a plan lies where it was made, others are written.
    #noise(noise) {
        if (noise instanceof Plan) {
            if (!this.#plans.has(noise)) {
                throw new TypeError('the plan was freed, or is of another load()');
            }
            return noise.at;
        }
        putNoise(this.#memory.view, this.#at.noise, noise, this.#words);
        return this.#at.noise;
    }

    // What memory.run() wants to know of the members of a structure of arrays.
    #arrays(what, object, names, slots, out, length) {
        checkMembers(what, object, names);
        new Uint8Array(this.#memory.buffer, slots, ARRAYS_SIZE).fill(0);
        const uses = [];
        names.forEach((name, i) => {
            const array = object[name];
            if (array !== undefined && array !== null) {
                checkArray(
                    `${what}.${name}`,
                    array,
                    names === CELLS && name === 'id' ? 'Uint32Array' : 'Float32Array',
                    length,
                );
                uses.push({ name: `${what}.${name}`, array, slot: slots + 4 * i, out });
            }
        });
        return uses;
    }

    #coordinates(list) {
        const type = isArray(list[0], 'Float64Array') ? 'Float64Array' : 'Float32Array';
        return list.map((array, axis) => {
            checkArray('xyz'[axis], array, type, list[0]?.length);
            return { name: 'xyz'[axis], array, slot: this.#at.pointers + 4 * axis, out: false };
        });
    }

    // A call with points: scarp_<stem><dimensions>, with _f64 if coordinates are doubles.
    #points(stem, noise, position, out, names) {
        const at = this.#noise(noise);
        const uses = this.#coordinates(position);
        const count = position[0].length;
        uses.push(...this.#arrays('out', out, names, this.#at.out, true, count));
        this.#runPoints(stem, at, position, uses);
        return out;
    }

    // The same with a structure of arrays for each axis.
    #vector(noise, position, out) {
        const dimensions = position.length;
        if (!Array.isArray(out) || out.length !== dimensions) {
            throw new TypeError(`out must be an array of ${dimensions} objects`);
        }
        const at = this.#noise(noise);
        const uses = this.#coordinates(position);
        const count = position[0].length;
        out.forEach((samples, i) => {
            const slots = this.#at.out + i * ARRAYS_SIZE;
            uses.push(...this.#arrays(`out[${i}]`, samples, SAMPLES, slots, true, count));
        });
        this.#runPoints('vector', at, position, uses);
        return out;
    }

    #runPoints(stem, at, position, uses) {
        const dimensions = position.length;
        const count = position[0].length;
        checkOverlaps(uses);
        const suffix = isArray(position[0], 'Float64Array') ? '_f64' : '';
        const call = this.#exports[`scarp_${stem}${dimensions}${suffix}`];
        const { u32 } = this.#memory,
            first = this.#at.pointers >> 2;
        this.#memory.run(count, uses, (n) => {
            const pointers = Array.from(u32.subarray(first, first + dimensions));
            this.#expect(call(at, n, ...pointers, this.#at.out), at, dimensions, askedOf(uses));
        });
    }

    sample2(noise, x, y, out) {
        return this.#points('sample', noise, [x, y], out, SAMPLES);
    }
    sample3(noise, x, y, z, out) {
        return this.#points('sample', noise, [x, y, z], out, SAMPLES);
    }
    vector2(noise, x, y, out) {
        return this.#vector(noise, [x, y], out);
    }
    vector3(noise, x, y, z, out) {
        return this.#vector(noise, [x, y, z], out);
    }
    cells2(noise, x, y, out) {
        return this.#points('cells', noise, [x, y], out, CELLS);
    }
    cells3(noise, x, y, z, out) {
        return this.#points('cells', noise, [x, y, z], out, CELLS);
    }
    curl2(noise, x, y, out) {
        return this.#points('curl', noise, [x, y], out, FLOW);
    }
    curl3(noise, x, y, z, out) {
        return this.#points('curl', noise, [x, y, z], out, FLOW);
    }

    grid2(noise, grid, out) {
        return this.#grid(2, noise, grid, out);
    }
    grid3(noise, grid, out) {
        return this.#grid(3, noise, grid, out);
    }

    #grid(dimensions, noise, members, out) {
        const at = this.#noise(noise);
        const grid = readGrid(members, dimensions);
        const uses = this.#gridArrays(out, grid);
        checkOverlaps(uses);
        if (grid.empty) {
            return out;
        }
        const call = (from, size, rowStride, sliceStride) => {
            putGrid(this.#memory.view, this.#at.grid, grid, from, size, rowStride, sliceStride);
            const status = this.#exports[`scarp_grid${dimensions}`](
                at,
                this.#at.grid,
                this.#at.out,
            );
            if (status !== STATUS.OK) {
                const fault = this.#told(status, 'scarp_grid_fault', this.#at.grid, dimensions);
                if (fault !== null) {
                    throw fault;
                }
            }
            this.#expect(status, at, dimensions, askedOf(uses));
        };
        if (uses.every(({ array }) => this.#memory.holds(array))) {
            this.#memory.point(uses, [], 0, 0);
            call([0, 0, 0], grid.count, grid.rowStride, dimensions === 3 ? grid.sliceStride : 0);
        } else {
            this.#memory.runGrid(grid, uses, call);
        }
        return out;
    }

    // Arrays of a grid may be longer than what is written.
    #gridArrays(out, grid, what = 'out', slots = this.#at.out) {
        checkMembers(what, out, SAMPLES);
        const uses = [];
        new Uint8Array(this.#memory.buffer, slots, ARRAYS_SIZE).fill(0);
        SAMPLES.forEach((name, i) => {
            const array = out[name];
            if (array === undefined || array === null) {
                return;
            }
            checkArray(`${what}.${name}`, array, 'Float32Array', array.length);
            if (array.length < grid.length) {
                throw new RangeError(
                    `${what}.${name} has ${array.length} elements, not ${grid.length}`,
                );
            }
            uses.push({
                name: `${what}.${name}`,
                array,
                slot: slots + 4 * i,
                out: true,
                length: grid.length,
            });
        });
        return uses;
    }

    normals(dx, dy, heightScale, out) {
        const uses = [dx, dy].map((array, i) => {
            checkArray(['dx', 'dy'][i], array, 'Float32Array', dx?.length);
            return { name: ['dx', 'dy'][i], array, slot: this.#at.pointers + 4 * i, out: false };
        });
        uses.push(...this.#arrays('out', out, ['nx', 'ny', 'nz'], this.#at.out, true, dx.length));
        checkOverlaps(uses);
        checkNumber('heightScale', heightScale);
        const { u32 } = this.#memory,
            slope = this.#at.pointers >> 2,
            normal = this.#at.out >> 2;
        this.#memory.run(dx.length, uses, (n) =>
            this.#expect(
                this.#exports.scarp_normals(
                    n,
                    u32[slope],
                    u32[slope + 1],
                    heightScale,
                    u32[normal],
                    u32[normal + 1],
                    u32[normal + 2],
                ),
            ),
        );
        return out;
    }

    // A function of samples. `names` are the members of the last input.
    #chain(stem, samples, numbers, out, names = SAMPLES) {
        const inputs = Object.entries(samples);
        Object.entries(numbers).forEach(([name, value]) => checkNumber(name, value));
        const length = Object.values(out ?? {}).find((array) => array)?.length ?? 0;
        const slots = [this.#at.a, this.#at.b, this.#at.m];
        const uses = inputs.flatMap(([name, of], i) =>
            this.#arrays(
                name,
                of,
                i === inputs.length - 1 ? names : SAMPLES,
                slots[i],
                false,
                length,
            ),
        );
        uses.push(...this.#arrays('out', out, SAMPLES, this.#at.out, true, length));
        checkOverlaps(uses);
        const rest = [...slots.slice(0, inputs.length), ...Object.values(numbers), this.#at.out];
        const call = this.#exports[`scarp_${stem}`];
        this.#memory.run(length, uses, (n) => this.#expect(call(n, ...rest)));
        return out;
    }

    // <chain> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    affine(a, scale, offset, out) {
        return this.#chain('affine', { a }, { scale, offset }, out);
    }
    add(a, b, out) {
        return this.#chain('add', { a, b }, {}, out);
    }
    multiply(a, b, out) {
        return this.#chain('multiply', { a, b }, {}, out);
    }
    mix(a, b, m, out) {
        return this.#chain('mix', { a, b, m }, {}, out);
    }
    min(a, b, out) {
        return this.#chain('min', { a, b }, {}, out);
    }
    max(a, b, out) {
        return this.#chain('max', { a, b }, {}, out);
    }
    smoothMin(a, b, k, out) {
        return this.#chain('smooth_min', { a, b }, { k }, out);
    }
    smoothMax(a, b, k, out) {
        return this.#chain('smooth_max', { a, b }, { k }, out);
    }
    clamp(a, lo, hi, out) {
        return this.#chain('clamp', { a }, { lo, hi }, out);
    }
    abs(a, out) {
        return this.#chain('abs', { a }, {}, out);
    }
    smoothAbs(a, round, out) {
        return this.#chain('smooth_abs', { a }, { round }, out);
    }
    smoothstep(a, lo, hi, out) {
        return this.#chain('smoothstep', { a }, { lo, hi }, out);
    }
    terrace(a, steps, riser, strength, out) {
        return this.#chain('terrace', { a }, { steps, riser, strength }, out);
    }
    divide(a, b, out) {
        return this.#chain('divide', { a, b }, {}, out);
    }
    sqrt(a, out) {
        return this.#chain('sqrt', { a }, {}, out);
    }
    sine(a, out) {
        return this.#chain('sine', { a }, {}, out);
    }
    pulse(a, out) {
        return this.#chain('pulse', { a }, {}, out);
    }
    slope(a, out) {
        return this.#chain('slope', { a }, {}, out);
    }
    // </chain>
    // `x` and `values` are lists of numbers.
    curve(a, x, values, out) {
        const knots = checkKnots(x, values),
            at = this.#memory.allocate(8 * knots);
        try {
            const place = new Float32Array(this.#memory.buffer, at, 2 * knots);
            place.set(x);
            place.set(values, knots);
            return this.#chain('curve', { a }, { knots, at, values: at + 4 * knots }, out);
        } finally {
            this.#memory.release(at);
        }
    }
    apply1(a, f, out) {
        return this.#chain('apply1', { a, f }, {}, out, PARTIALS);
    }
    apply2(a, b, f, out) {
        return this.#chain('apply2', { a, b, f }, {}, out, PARTIALS);
    }

    // The functions of recipes, with their arguments
    get recipeFunctions() {
        this.#functions ??= functionsOf({ exports: this.#exports, memory: this.#memory });
        return this.#functions;
    }

    // A composition of noises; free() it. A tolerant one may have errors.
    recipe(text, options = {}) {
        checkMembers('recipe()', options, ['tolerant']);
        return new Recipe(
            {
                exports: this.#exports,
                memory: this.#memory,
                gridAt: this.#at.grid,
                seedOf,
                text: (status) => this.#text(status),
                expect: (status) => this.#expect(status),
                arrays: (...all) => this.#arrays(...all),
                gridArrays: (what, out, slots, grid) => this.#gridArrays(out, grid, what, slots),
                coordinates: (list) => ({
                    uses: this.#coordinates(list),
                    slots: list.map((_, axis) => this.#at.pointers + 4 * axis),
                    isDouble: isArray(list[0], 'Float64Array'),
                }),
            },
            text,
            options.tolerant === true,
        );
    }

    // What calls would throw for this noise, or null.
    noiseCheck(noise, dimensions) {
        try {
            return this.#fault(this.#noise(noise), dimensions);
        } catch (error) {
            if (error instanceof ScarpError) {
                return error;
            }
            throw error;
        }
    }

    range(noise, dimensions) {
        const at = this.#noise(noise),
            to = this.#at.pointers;
        this.#expect(this.#exports.scarp_range(at, dimensions, to, to + 4), at, dimensions);
        return [this.#memory.view.getFloat32(to, true), this.#memory.view.getFloat32(to + 4, true)];
    }

    // A noise for many calls with few points: give it to them in place of the noise, then free it.
    plan(noise, dimensions) {
        const { view } = this.#memory;
        putNoise(view, this.#at.noise, noise, this.#words);
        const fault = this.#fault(this.#at.noise, dimensions);
        if (fault !== null) {
            throw fault;
        }
        const at = this.#memory.allocate(LEVELS * NOISE_SIZE + PLAN_SIZE);
        putNoise(view, at, noise, this.#words);
        this.#exports.scarp_plan_make(at, dimensions, at + LEVELS * NOISE_SIZE);
        putPlan(view, at, at + LEVELS * NOISE_SIZE);
        const plan = new Plan(at, dimensions);
        this.#plans.add(plan);
        return plan;
    }
    freePlan(plan) {
        if (!this.#plans.delete(plan)) {
            throw new TypeError('this is no plan of plan(), or it was freed before');
        }
        this.#memory.release(plan.at);
    }

    // The constants for shaders, and what shaders must answer.
    gpuPlan(noise, dimensions, { vector = false } = {}) {
        const to = this.#gpuPlan(noise, dimensions, vector);
        return new Uint8Array(this.#memory.buffer, to, GPU_PLAN_SIZE).slice();
    }
    gpuAnswers(noise, dimensions, order) {
        const to = this.#gpuPlan(noise, dimensions, false);
        const at = this.#noise(noise);
        this.#expect(
            this.#exports.scarp_gpu_answers(at, dimensions, checkNumber('order', order), to),
            at,
            dimensions,
            { order },
        );
        return new Uint32Array(this.#memory.buffer, to, GPU_ANSWERS).slice();
    }

    // A noise that calls take may have too many octaves for shaders: the member tells.
    #gpuPlan(noise, dimensions, isVector) {
        const { stage } = this.#memory,
            at = this.#noise(noise);
        const make = isVector ? 'scarp_gpu_vector_plan_make' : 'scarp_gpu_plan_make';
        const status = this.#exports[make](at, dimensions, stage, 0);
        if (status !== STATUS.OK) {
            throw this.#told(status, 'scarp_gpu_plan_fault', at, dimensions, isVector);
        }
        return stage;
    }
}

// load({ simd, memory }): `memory` bytes are for alloc(), `simd` false does without vectors.
export async function load(options = {}) {
    checkMembers('load()', options, ['simd', 'memory']);
    const { simd = hasVectors(), memory = 64 * 2 ** 20 } = options;
    if (!Number.isSafeInteger(memory) || memory < 0) {
        throw new RangeError('memory is a number of bytes');
    }
    const instance = await WebAssembly.instantiate(await compile(simd), {});
    return bind(instance.exports, memory);
}

// The same calls for another module, which exports those of scarp.h among its own
export const bind = (exports, memory) => new Scarp(exports, memory);
