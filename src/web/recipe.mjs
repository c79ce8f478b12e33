// SPDX-License-Identifier: MIT
//
// Recipes: compositions of noises as a text. What is wrong in a text throws a RecipeError with all
// errors of it, or is told beside what could be read. Places in the text are indices of the string;
// the module counts bytes of UTF-8.
import {
    SCARP_RECIPE_PARTS,
    scarp_box as BOX,
    scarp_language,
    scarp_recipe as RECIPE,
    scarp_recipe_argument as ARGUMENT,
    scarp_recipe_entry as ENTRY,
    scarp_recipe_error as ERROR,
    scarp_recipe_function as FUNCTION,
    scarp_recipe_kind,
    scarp_recipe_outputs as OUTPUTS,
    scarp_recipe_part as PART,
    scarp_scratch as STORE,
    scarp_shader as SHADER,
} from './interface.mjs';
import {
    ARRAYS_SIZE,
    GPU_ANSWERS,
    SAMPLES,
    STATUS,
    ScarpError,
    checkNumber,
    putGrid,
    readGrid,
} from './layout.mjs';
import { checkOverlaps } from './memory.mjs';

const DESCRIPTION_SIZE = Math.max(ENTRY.SIZE, PART.SIZE, FUNCTION.SIZE);
const ERRORS = 64; // that are told at most
const SCRATCH = 256 * 1024; // bytes, for a text with errors: some points of any field
const MOST_SCRATCH = 2 ** 26; // bytes that calls are tried with
const MOST = 16; // outputs
const ORDERS = { dx: 1, dy: 1, dz: 1, dxx: 2, dxy: 2, dxz: 2, dyy: 2, dyz: 2, dzz: 2 };
// Names of enumerators, as they are called here: 'glsl', 'field'
const wordsOf = (enumerators) =>
    Object.keys(enumerators).map((name) => name.replace(/^.*_/, '').toLowerCase());
const LANGUAGES = wordsOf(scarp_language),
    KINDS = wordsOf(scarp_recipe_kind);
export const PARTS = SCARP_RECIPE_PARTS; // the number of the first part, among nodes

const sentenceOf = ({ line, member, text }) =>
    `line ${line}: ${member === null ? '' : `${member}: `}${text}`;

export class RecipeError extends ScarpError {
    constructor(status, text, errors) {
        super(status, errors.length > 0 ? sentenceOf(errors[0]) : text);
        this.name = 'RecipeError';
        this.errors = errors; // { line, column, from, to, text, member, nearest }
    }
}

// The index of the string at which each byte of its UTF-8 stands; null where all are the same.
function indicesOf(text, bytes) {
    if (bytes.length === text.length) {
        return null;
    }
    const indices = new Uint32Array(bytes.length + 1);
    let byte = 0;
    for (let i = 0; i < text.length; i++) {
        const code = text.codePointAt(i),
            count = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
        indices.fill(i, byte, byte + count);
        byte += count;
        i += code > 0xffff ? 1 : 0;
    }
    indices[byte] = text.length;
    return indices;
}

// The functions of the language, as the module tells them
export function functionsOf({ exports, memory }) {
    const { view } = memory,
        list = [],
        at = memory.allocate(DESCRIPTION_SIZE);
    const u32 = (place) => view.getUint32(place, true);
    const argumentOf = (place) => {
        const words = [];
        const list = u32(place + ARGUMENT.words);
        for (let word = list; word !== 0 && u32(word) !== 0; word += 4) {
            words.push(memory.text(u32(word)));
        }
        return Object.freeze({
            name: memory.text(u32(place + ARGUMENT.name)),
            text: memory.text(u32(place + ARGUMENT.text)),
            kind: KINDS[u32(place + ARGUMENT.kind)],
            isNeeded: u32(place + ARGUMENT.is_needed) === 1,
            otherwise: view.getFloat64(place + ARGUMENT.otherwise, true),
            lowest: view.getFloat64(place + ARGUMENT.lowest, true),
            highest: view.getFloat64(place + ARGUMENT.highest, true),
            words: list === 0 ? null : Object.freeze(words),
        });
    };
    while (exports.scarp_recipe_function_at(list.length, at) === STATUS.OK) {
        const first = u32(at + FUNCTION.argument);
        const places = Array.from(
            { length: u32(at + FUNCTION.arguments) },
            (_, i) => first + i * ARGUMENT.SIZE,
        );
        list.push(
            Object.freeze({
                name: memory.text(u32(at + FUNCTION.name)),
                text: memory.text(u32(at + FUNCTION.text)),
                arguments: Object.freeze(places.map(argumentOf)),
            }),
        );
    }
    memory.release(at);
    return Object.freeze(list);
}

export class Recipe {
    #tools; // of class Scarp
    #at; // where the recipe is; behind it what calls want
    #plan = 0; // where its plan is, which is made whenever it changes
    #text;
    #indices;
    #faults = [];
    #seed = 0n;

    constructor(tools, text, isTolerant) {
        const { memory } = tools;
        this.#tools = tools;
        this.#text = String(text);
        const rest = ERRORS * ERROR.SIZE + DESCRIPTION_SIZE + OUTPUTS.SIZE + STORE.SIZE;
        const numbers = MOST * ARRAYS_SIZE + 4 * MOST + BOX.SIZE;
        this.#at = memory.allocate(RECIPE.SIZE + rest + numbers);
        try {
            this.#parse(isTolerant);
        } catch (error) {
            this.free();
            throw error;
        }
    }

    // Places in the block
    get #errors() {
        return this.#at + RECIPE.SIZE;
    }
    get #description() {
        return this.#errors + ERRORS * ERROR.SIZE;
    }
    get #outputs() {
        return this.#description + DESCRIPTION_SIZE;
    }
    get #scratch() {
        return this.#outputs + OUTPUTS.SIZE;
    }
    get #samples() {
        return this.#scratch + STORE.SIZE;
    }
    get #which() {
        return this.#samples + MOST * ARRAYS_SIZE;
    }
    get #box() {
        return this.#which + 4 * MOST;
    }

    #parse(isTolerant) {
        const { exports, memory } = this.#tools;
        const bytes = new TextEncoder().encode(this.#text);
        const { view } = memory,
            length = bytes.length,
            at = memory.allocate(length + 1);
        this.#indices = indicesOf(this.#text, bytes);
        new Uint8Array(memory.buffer, at, length).set(bytes);
        const found = this.#description;
        view.setUint32(found, 0, true);
        const status = exports.scarp_recipe_parse(
            at,
            length,
            this.#at,
            this.#errors,
            ERRORS,
            found,
        );
        memory.release(at);
        const count = Math.min(view.getUint32(found, true), ERRORS);
        this.#faults = Array.from({ length: count }, (_, i) => this.#error(i));
        if (status !== STATUS.OK && !(isTolerant && count > 0)) {
            throw new RecipeError(status, this.#tools.text(status), this.#faults);
        }
        new Uint8Array(memory.buffer, this.#outputs, OUTPUTS.SIZE + STORE.SIZE).fill(0);
        view.setUint32(this.#outputs + OUTPUTS.out, this.#samples, true);
        this.#makePlan();
    }

    // The constants of all noises, so that calls with few points are fast; none without memory
    #makePlan() {
        const { exports, memory } = this.#tools;
        this.#dropPlan();
        const size = exports.scarp_recipe_plan_size(this.#at);
        try {
            this.#plan = size > 0 ? memory.allocate(size) : 0;
        } catch {
            // Calls are slower, and give the same.
        }
        if (this.#plan !== 0) {
            this.#tools.expect(exports.scarp_recipe_plan_make(this.#at, this.#plan, size));
        }
        memory.view.setUint32(this.#scratch + STORE.plan, this.#plan, true);
    }
    #dropPlan() {
        if (this.#plan !== 0) {
            this.#tools.memory.release(this.#plan);
            this.#plan = 0;
        }
    }

    #span(at) {
        const { view } = this.#tools.memory;
        const bytes = [view.getUint32(at, true), view.getUint32(at + 4, true)];
        return this.#indices === null ? bytes : bytes.map((byte) => this.#indices[byte]);
    }
    // null for an empty one
    #spanOrNull(at) {
        const [from, to] = this.#span(at);
        return to > from ? [from, to] : null;
    }
    #word(span) {
        return span === null ? '' : this.#text.slice(...span);
    }

    #error(i) {
        const { memory } = this.#tools,
            { view } = memory,
            at = this.#errors + i * ERROR.SIZE;
        const [from, to] = this.#span(at + ERROR.from);
        const [line, text, member] = [ERROR.line, ERROR.text, ERROR.member].map((offset) =>
            view.getUint32(at + offset, true),
        );
        const nearest = view.getFloat64(at + ERROR.nearest, true);
        return {
            line,
            column: from - (from > 0 ? this.#text.lastIndexOf('\n', from - 1) : -1),
            from,
            to,
            text: memory.text(text),
            member: memory.text(member),
            nearest: nearest === 0 ? null : nearest,
        };
    }

    // What is wrong with the text; only a tolerant recipe has any.
    get errors() {
        return this.#faults;
    }

    // What a call describes, from number 0 to the last: `read` makes an object of what lies at a
    // place.
    #described(call, read) {
        const { exports } = this.#tools,
            list = [],
            at = this.#description;
        while (exports[call](this.#live(), list.length, at) === STATUS.OK) {
            list.push(read(at, list.length));
        }
        return list;
    }

    get entries() {
        const { view } = this.#tools.memory;
        return this.#described('scarp_recipe_entry_at', (at, index) => {
            const nameSpan = this.#span(at + ENTRY.name);
            return {
                index,
                name: this.#word(nameSpan),
                span: this.#span(at + ENTRY.span),
                nameSpan,
                kind: KINDS[view.getInt32(at + ENTRY.kind, true)],
                isParam: view.getInt32(at + ENTRY.is_param, true) === 1,
                output: view.getInt32(at + ENTRY.output, true),
                part: view.getInt32(at + ENTRY.part, true),
                value: view.getFloat64(at + ENTRY.value, true),
                slider: [
                    view.getFloat64(at + ENTRY.slider, true),
                    view.getFloat64(at + ENTRY.slider + 8, true),
                ],
                range: [
                    view.getFloat32(at + ENTRY.range, true),
                    view.getFloat32(at + ENTRY.range + 4, true),
                ],
                axes: view.getUint32(at + ENTRY.axes, true),
                order: view.getUint32(at + ENTRY.order, true),
                hash: view.getBigUint64(at + ENTRY.hash, true).toString(16),
                cell: [
                    view.getFloat64(at + ENTRY.cell, true),
                    view.getFloat64(at + ENTRY.cell + 8, true),
                ],
                jumps: view.getUint32(at + ENTRY.jumps, true) === 1,
                dimensions: view.getUint32(at + ENTRY.dimensions, true),
            };
        });
    }

    get parts() {
        const { view } = this.#tools.memory;
        return this.#described('scarp_recipe_part_at', (at, index) => {
            const nameSpan = this.#spanOrNull(at + PART.name),
                argumentSpan = this.#spanOrNull(at + PART.argument);
            const [kind, call, entry, parent, operation] = [
                PART.kind,
                PART.function,
                PART.entry,
                PART.parent,
                PART.operation,
            ].map((offset) => view.getInt32(at + offset, true));
            return {
                index,
                span: this.#span(at + PART.span),
                name: this.#word(nameSpan),
                nameSpan,
                argument: this.#word(argumentSpan),
                argumentSpan,
                kind: KINDS[kind],
                function: call,
                entry,
                parent,
                operation: operation === 0 ? '' : String.fromCharCode(operation),
                axes: view.getUint32(at + PART.axes, true),
                order: view.getUint32(at + PART.order, true),
                range: [
                    view.getFloat32(at + PART.range, true),
                    view.getFloat32(at + PART.range + 4, true),
                ],
                value: view.getFloat64(at + PART.value, true),
                hash: view.getBigUint64(at + PART.hash, true).toString(16),
            };
        });
    }

    get params() {
        return this.entries
            .filter((entry) => entry.isParam)
            .map(({ name, value, slider: [lowest, highest] }) => ({
                name,
                value,
                lowest,
                highest,
            }));
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
        this.#makePlan();
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
        return this.#changed(status, 'no such parameter, or outside its interval', name);
    }

    // Makes it repeat, as the line `tile x, y` of a text does, or with 0 not at all.
    tile(x, y, z = 0) {
        Object.entries({ x, y, z }).forEach(([name, side]) => checkNumber(name, side));
        const { exports } = this.#tools;
        const status = exports.scarp_recipe_tile(this.#live(), x, y, z, this.#errors);
        return this.#changed(status, 'no length of a tile', 'tile');
    }

    // Makes it so many times larger, and the values of the first output.
    scale(by, heights = 1) {
        Object.entries({ by, heights }).forEach(([name, factor]) => checkNumber(name, factor));
        const { exports } = this.#tools;
        const status = exports.scarp_recipe_scale(this.#live(), by, heights, this.#errors);
        return this.#changed(status, 'a factor from 2^-40 to 2^40 is expected', 'scale');
    }

    #changed(status, otherwise, name) {
        if (status !== STATUS.OK) {
            const error = this.#error(0);
            throw error.text === null
                ? new ScarpError(status, otherwise, name)
                : new RecipeError(status, '', [error]);
        }
        this.#makePlan();
        return this;
    }

    // The interval that values of an output, or of a node, never leave, in a box or everywhere
    range(output = 0, { which = null, box = null } = {}) {
        const { exports, memory } = this.#tools,
            to = this.#description;
        const node = which ?? this.entries.find((entry) => entry.output === output)?.index ?? -2;
        if (box !== null) {
            const ends = [box.lowest, box.highest].flatMap(([x, y, z = 0]) => [x, y, z]);
            ends.forEach((x, i) => memory.view.setFloat64(this.#box + BOX.lowest + 8 * i, x, true));
        }
        const at = box === null ? 0 : this.#box;
        this.#tools.expect(exports.scarp_recipe_range(this.#live(), node, at, to, to + 4));
        return [memory.view.getFloat32(to, true), memory.view.getFloat32(to + 4, true)];
    }

    // Whether it is of space
    get isSpace() {
        const { exports, memory } = this.#tools,
            at = this.#description;
        return (
            exports.scarp_recipe_entry_at(this.#live(), 0, at) === STATUS.OK &&
            memory.view.getUint32(at + ENTRY.dimensions, true) === 3
        );
    }

    // Outputs of the text, from the first one on, or nodes by number: an object of arrays, or
    // several in an array
    #uses(out, which, make) {
        const list = Array.isArray(out) ? out : [out],
            { view } = this.#tools.memory;
        if (list.length < 1 || list.length > MOST) {
            throw new RangeError(`out has from 1 to ${MOST} outputs`);
        }
        const nodes = which === null || Array.isArray(which) ? which : [which];
        if (nodes !== null && nodes.length !== list.length) {
            throw new RangeError('which has as many numbers as there are outputs');
        }
        nodes?.forEach((node, i) => {
            if (!Number.isInteger(node) || node < 0 || node >= 2 ** 31) {
                throw new RangeError(
                    'which has numbers of statements, or PARTS plus that of a part',
                );
            }
            view.setInt32(this.#which + 4 * i, node, true);
        });
        view.setUint32(this.#outputs + OUTPUTS.which, nodes === null ? 0 : this.#which, true);
        view.setUint32(this.#outputs + OUTPUTS.count, list.length, true);
        return list.flatMap((samples, i) =>
            make(list.length > 1 ? `out[${i}]` : 'out', samples, this.#samples + i * ARRAYS_SIZE),
        );
    }

    grid(members, out, { which = null } = {}) {
        const { exports, memory } = this.#tools,
            dimensions = this.isSpace ? 3 : 2;
        const grid = readGrid(members, dimensions),
            at = this.#tools.gridAt;
        const uses = this.#uses(out, which, (what, samples, slots) =>
            this.#tools.gridArrays(what, samples, slots, grid),
        );
        checkOverlaps(uses);
        if (grid.empty) {
            return out;
        }
        const points = grid.count.reduce((all, count) => all * count, 1);
        const call = (from, size, rowStride, sliceStride) => {
            putGrid(memory.view, at, grid, from, size, rowStride, sliceStride);
            this.#run(points, out, () =>
                exports.scarp_recipe_grid(this.#live(), at, this.#outputs, this.#scratch),
            );
        };
        memory.runGrid(grid, uses, call);
        return out;
    }

    sample2(x, y, out, { which = null } = {}) {
        return this.#points([x, y], out, which);
    }
    sample3(x, y, z, out, { which = null } = {}) {
        return this.#points([x, y, z], out, which);
    }

    #points(position, out, which) {
        const { exports, memory } = this.#tools;
        const { uses, slots, isDouble } = this.#tools.coordinates(position);
        const count = position[0].length;
        uses.push(
            ...this.#uses(out, which, (what, samples, at) =>
                this.#tools.arrays(what, samples, SAMPLES, at, true, count),
            ),
        );
        checkOverlaps(uses);
        const call = exports[isDouble ? 'scarp_recipe_sample_f64' : 'scarp_recipe_sample'];
        memory.run(count, uses, (n) => {
            const [x, y, z = 0] = slots.map((slot) => memory.u32[slot >> 2]);
            this.#run(n, out, () =>
                call(this.#live(), n, x, y, z, this.#outputs, this.#scratch),
            );
        });
        return out;
    }

    // Calls with scratch memory of the best size for the outputs of the text, or less if fewer
    // points do with that. Other fields may need more.
    #run(points, out, call) {
        const { exports, memory, expect } = this.#tools;
        const orders = [out].flat().flatMap(Object.keys).map((name) => ORDERS[name] ?? 0);
        const [best, few] = [0, Math.min(Math.max(points, 1), 2 ** 31 - 1)].map(
            (many) => exports.scarp_recipe_scratch_size(this.#live(), Math.max(0, ...orders), many),
        );
        let bytes = best === 0 ? SCRATCH : few > 0 && few < best ? few : best;
        for (let status = STATUS.SIZE; status === STATUS.SIZE; bytes = Math.max(2 * bytes, 8192)) {
            const { at, size } = memory.workspace(bytes);
            memory.view.setUint32(this.#scratch + STORE.memory, at, true);
            memory.view.setUint32(this.#scratch + STORE.size, Math.min(size, bytes), true);
            status = call();
            if (status !== STATUS.SIZE || bytes > MOST_SCRATCH) {
                expect(status);
            }
        }
    }

    // What a call writes that is given a capacity and says a size: `call` takes place, capacity and
    // where the size goes.
    #written(call, use) {
        const { memory } = this.#tools,
            size = this.#description;
        memory.view.setUint32(size, 0, true);
        const status = call(0, 0, size);
        if (status !== STATUS.SIZE) {
            this.#tools.expect(status);
        }
        const capacity = memory.view.getUint32(size, true) + 1,
            at = memory.allocate(capacity);
        try {
            this.#tools.expect(call(at, capacity, size));
            return use(new Uint8Array(memory.buffer, at, memory.view.getUint32(size, true)));
        } finally {
            memory.release(at);
        }
    }

    // The recipe as functions of a shading language: `file` is the text of scarp.wgsl, or of its like.
    shader(language, file, { order = 1 } = {}) {
        const { exports, memory } = this.#tools;
        const number = LANGUAGES.indexOf(language);
        if (number < 0) {
            throw new TypeError(`language is one of ${LANGUAGES.join(', ')}`);
        }
        const bytes = new TextEncoder().encode(file),
            how = memory.allocate(SHADER.SIZE + bytes.length);
        try {
            const u32 = new Uint32Array(memory.buffer, how, SHADER.SIZE / 4);
            u32.fill(0);
            u32[SHADER.language / 4] = number;
            u32[SHADER.order / 4] = checkNumber('order', order);
            u32[SHADER.file / 4] = how + SHADER.SIZE;
            u32[SHADER.length / 4] = bytes.length;
            new Uint8Array(memory.buffer, how + SHADER.SIZE, bytes.length).set(bytes);
            return this.#written(
                (at, capacity, size) =>
                    exports.scarp_recipe_shader(this.#live(), how, at, capacity, size),
                (text) => new TextDecoder().decode(text),
            );
        } finally {
            memory.release(how);
        }
    }

    // The bytes of the shader's uniform buffer
    uniforms() {
        const { scarp_recipe_uniforms: call } = this.#tools.exports;
        return this.#written(
            (at, capacity, size) => call(this.#live(), at, capacity, size),
            (bytes) => bytes.slice(),
        );
    }

    // What the self-test of the shader must answer
    answers(order = 1) {
        const { exports, memory } = this.#tools,
            at = memory.allocate(4 * GPU_ANSWERS);
        try {
            this.#tools.expect(
                exports.scarp_recipe_answers(this.#live(), checkNumber('order', order), at),
            );
            return new Uint32Array(memory.buffer, at, GPU_ANSWERS).slice();
        } finally {
            memory.release(at);
        }
    }

    #live() {
        if (this.#at === 0) {
            throw new TypeError('the recipe was freed');
        }
        return this.#at;
    }

    free() {
        this.#tools.memory.release(this.#live());
        this.#dropPlan();
        this.#at = 0;
    }
}
