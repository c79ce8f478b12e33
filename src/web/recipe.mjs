// SPDX-License-Identifier: MIT
//
// Recipes: compositions of noises as a text. What is wrong in a text throws a RecipeError with all
// errors of it.
import { SAMPLES, STATUS, ScarpError, checkNumber, putGrid, readGrid } from './layout.mjs';
import { checkOverlaps } from './memory.mjs';

export const RECIPE_SIZE = 65536;
const ERROR_SIZE = 56,
    ENTRY_SIZE = 112,
    OUTPUTS_SIZE = 48,
    SCRATCH_SIZE = 56;
const ERRORS = 64; // that are told at most
const SCRATCH = 256 * 1024; // bytes: about a thousand points of a large recipe
const MOST = 16; // outputs
const SAMPLES_SIZE = 64;

export class RecipeError extends ScarpError {
    constructor(status, text, errors) {
        super(status, errors.length > 0 ? `line ${errors[0].line}: ${errors[0].text}` : text);
        this.name = 'RecipeError';
        this.errors = errors; // { line, column, from, to, text, member, nearest }
    }
}

export class Recipe {
    #tools; // of class Scarp
    #at; // where the recipe is; behind it what calls want
    #text;
    #seed = 0n;

    constructor(tools, text) {
        const { memory } = tools;
        this.#tools = tools;
        this.#text = new TextEncoder().encode(text);
        const rest = ERRORS * ERROR_SIZE + ENTRY_SIZE + OUTPUTS_SIZE + SCRATCH_SIZE;
        this.#at = memory.allocate(RECIPE_SIZE + rest + MOST * SAMPLES_SIZE + SCRATCH);
        try {
            this.#parse();
        } catch (error) {
            this.free();
            throw error;
        }
    }

    // Places in the block
    get #errors() {
        return this.#at + RECIPE_SIZE;
    }
    get #entry() {
        return this.#errors + ERRORS * ERROR_SIZE;
    }
    get #outputs() {
        return this.#entry + ENTRY_SIZE;
    }
    get #scratch() {
        return this.#outputs + OUTPUTS_SIZE;
    }
    get #samples() {
        return this.#scratch + SCRATCH_SIZE;
    }

    #parse() {
        const { exports, memory } = this.#tools;
        const { view } = memory,
            length = this.#text.length,
            text = memory.allocate(length + 1);
        new Uint8Array(memory.buffer, text, length).set(this.#text);
        new Uint8Array(memory.buffer, this.#at + RECIPE_SIZE, SCRATCH_SIZE).fill(0);
        const found = this.#entry;
        view.setUint32(found, 0, true);
        const status = exports.scarp_recipe_parse(
            text,
            length,
            this.#at,
            this.#errors,
            ERRORS,
            found,
        );
        memory.release(text);
        if (status !== STATUS.OK) {
            const count = Math.min(view.getUint32(found, true), ERRORS);
            const errors = Array.from({ length: count }, (_, i) => this.#error(i));
            throw new RecipeError(status, this.#tools.text(status), errors);
        }
        new Uint8Array(memory.buffer, this.#outputs, OUTPUTS_SIZE + SCRATCH_SIZE).fill(0);
        view.setUint32(this.#outputs, this.#samples, true);
        view.setUint32(this.#scratch, this.#samples + MOST * SAMPLES_SIZE, true);
        view.setUint32(this.#scratch + 4, SCRATCH, true);
    }

    #error(i) {
        const { memory } = this.#tools,
            { view } = memory,
            at = this.#errors + i * ERROR_SIZE;
        const [from, to, line, column, text, member] = [0, 4, 8, 12, 16, 20].map((offset) =>
            view.getUint32(at + offset, true),
        );
        const nearest = view.getFloat64(at + 24, true);
        return {
            line,
            column,
            from,
            to,
            text: memory.text(text),
            member: memory.text(member),
            nearest: nearest === 0 ? null : nearest,
        };
    }

    // The statements: { name, isParam, output, value, slider, range }
    get entries() {
        const { exports, memory } = this.#tools,
            { view } = memory,
            list = [],
            at = this.#entry;
        const decoder = new TextDecoder();
        while (exports.scarp_recipe_entry_at(this.#live(), list.length, at) === STATUS.OK) {
            const name = this.#text.subarray(
                view.getUint32(at + 8, true),
                view.getUint32(at + 12, true),
            );
            list.push({
                name: decoder.decode(name),
                isParam: view.getInt32(at + 20, true) === 1,
                output: view.getInt32(at + 24, true),
                value: view.getFloat64(at + 32, true),
                slider: [view.getFloat64(at + 40, true), view.getFloat64(at + 48, true)],
                range: [view.getFloat32(at + 56, true), view.getFloat32(at + 60, true)],
            });
        }
        return list;
    }

    get params() {
        return this.entries
            .filter((entry) => entry.isParam)
            .map(({ name, value, slider: [lowest, highest] }) => ({ name, value, lowest, highest }));
    }
    get outputs() {
        return this.entries
            .filter((entry) => entry.output >= 0)
            .sort((a, b) => a.output - b.output)
            .map(({ name, range }) => ({ name, range }));
    }

    get seed() {
        return this.#seed;
    }
    set seed(seed) {
        const whole = this.#tools.seedOf(seed);
        this.#tools.expect(this.#tools.exports.scarp_recipe_seed(this.#live(), whole));
        this.#seed = whole;
    }

    // Sets a parameter, or "finest".
    set(name, value) {
        const { exports, memory } = this.#tools;
        checkNumber('value', value);
        const bytes = new TextEncoder().encode(`${name}\0`),
            at = memory.allocate(bytes.length);
        new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
        const status = exports.scarp_recipe_set(this.#live(), at, value, this.#errors);
        memory.release(at);
        if (status !== STATUS.OK) {
            const error = this.#error(0);
            throw error.text === null
                ? new ScarpError(status, 'no such parameter, or outside its interval', name)
                : new RecipeError(status, '', [error]);
        }
        return this;
    }

    // The interval that values of an output never leave
    range(output = 0) {
        return this.outputs[output].range;
    }

    // Whether it is of space
    get isSpace() {
        const { exports, memory } = this.#tools;
        memory.view.setUint32(this.#outputs + 8, 1, true);
        new Uint8Array(memory.buffer, this.#samples, SAMPLES_SIZE).fill(0);
        const at = this.#entry; // a double of any value
        return (
            exports.scarp_recipe_sample_f64(
                this.#live(),
                1,
                at,
                at,
                0,
                this.#outputs,
                this.#scratch,
            ) === STATUS.NULL
        );
    }

    // Outputs of the text, from the first one on: an object of arrays, or several in an array
    #uses(out, make) {
        const list = Array.isArray(out) ? out : [out];
        if (list.length < 1 || list.length > MOST) {
            throw new RangeError(`out has from 1 to ${MOST} outputs`);
        }
        this.#tools.memory.view.setUint32(this.#outputs + 8, list.length, true);
        return list.flatMap((samples, i) =>
            make(list.length > 1 ? `out[${i}]` : 'out', samples, this.#samples + i * SAMPLES_SIZE),
        );
    }

    grid(members, out) {
        const { exports, memory } = this.#tools,
            dimensions = this.isSpace ? 3 : 2;
        const grid = readGrid(members, dimensions),
            at = this.#tools.gridAt;
        const uses = this.#uses(out, (what, samples, slots) =>
            this.#tools.gridArrays(what, samples, slots, grid),
        );
        checkOverlaps(uses);
        if (grid.empty) {
            return out;
        }
        const call = (from, size, rowStride, sliceStride) => {
            putGrid(memory.view, at, grid, from, size, rowStride, sliceStride);
            this.#tools.expect(
                exports.scarp_recipe_grid(this.#live(), at, this.#outputs, this.#scratch),
            );
        };
        memory.runGrid(grid, uses, call);
        return out;
    }

    sample2(x, y, out) {
        return this.#points([x, y], out);
    }
    sample3(x, y, z, out) {
        return this.#points([x, y, z], out);
    }

    #points(position, out) {
        const { exports, memory } = this.#tools;
        const { uses, slots, isDouble } = this.#tools.coordinates(position);
        const count = position[0].length;
        uses.push(
            ...this.#uses(out, (what, samples, at) =>
                this.#tools.arrays(what, samples, SAMPLES, at, true, count),
            ),
        );
        checkOverlaps(uses);
        const call = exports[isDouble ? 'scarp_recipe_sample_f64' : 'scarp_recipe_sample'];
        memory.run(count, uses, (n) => {
            const [x, y, z = 0] = slots.map((slot) => memory.u32[slot >> 2]);
            this.#tools.expect(
                call(this.#live(), n, x, y, z, this.#outputs, this.#scratch),
            );
        });
        return out;
    }

    #live() {
        if (this.#at === 0) {
            throw new TypeError('the recipe was freed');
        }
        return this.#at;
    }

    free() {
        this.#tools.memory.release(this.#live());
        this.#at = 0;
    }
}
