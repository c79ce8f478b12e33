// SPDX-License-Identifier: MIT
//
// Terrain: the program's own code as a module, page.c. Recipes become grounds, and grounds samples and
// pixels.
import {hasVectors} from "./compile.mjs";

export const STRIP = 65536; // samples at once: they stay in the cache
const ARRAYS = ["value", "dx", "dy", "dxx", "dxy", "dyy", "bed", "nx", "ny", "nz", "sx", "sy", "sz"];
const NUMBERS = ["lowest", "highest", "floor", "hasSea", "hasHessian", "low", "high"];
const PROBLEMS = ["", "text", "terrain", "name", "value"]; // as in ground.h
const TEXT_MOST = 16384;
const NAME_MOST = 63;
const TEXT_TOO_LONG = "the text is longer than 16,384 bytes";

export async function loadTerrain() {
    const name = hasVectors() ? "./page-simd.wasm" : "./page-fallback.wasm";
    const response = await fetch(new URL(name, import.meta.url));
    const {instance} = await WebAssembly.instantiate(await response.arrayBuffer(), {});
    return new Terrain(instance.exports);
}

class Terrain {
    constructor(calls) {
        const {buffer} = calls.memory;
        this.calls = calls;
        this.arrays = Object.fromEntries(ARRAYS.map((name, i) =>
            [name, new Float32Array(buffer, calls.page_array(i), STRIP)]));
        this.pixels = new Uint32Array(buffer, calls.page_pixels(), STRIP);
        this.place = new Float64Array(buffer, calls.page_place(), 3);
        this.palettes = [];
        for (let i = 0, at; (at = calls.page_palette_name(i)) !== 0; i++) {
            this.palettes.push(this.textAt(at));
        }
    }

    textAt(at) {
        if (at === 0) {
            return null;
        }
        const bytes = new Uint8Array(this.calls.memory.buffer, at);
        return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    }

    // Writes a text that ends with a NUL.
    put(at, text, most) {
        const to = new Uint8Array(this.calls.memory.buffer, at, most + 1);
        to.fill(0);
        to.set(new TextEncoder().encode(text).subarray(0, most));
    }

    // Opens a recipe {text, values, seed, tile}, the tile as text, perhaps empty: null, or what is wrong {kind, message, line, name}.
    open({text, values, seed, tile}) {
        const {calls} = this, bytes = new TextEncoder().encode(text), names = Object.keys(values);
        if (bytes.length > TEXT_MOST) {
            return {kind: "text", message: TEXT_TOO_LONG, line: 1};
        }
        this.bytes = bytes;
        new Uint8Array(calls.memory.buffer, calls.page_text(), TEXT_MOST).set(bytes);
        for (const [i, name] of names.entries()) {
            this.put(calls.page_name(i), name, NAME_MOST);
            calls.page_value(i, values[name]);
        }
        this.put(calls.page_tile(), tile, NAME_MOST);
        const problem = PROBLEMS[calls.page_open(bytes.length, names.length, seed)];
        return problem === "" ? null : this.problem(problem, names);
    }

    problem(kind, names) {
        const {calls} = this, [line, column, from, , nearest] = [0, 1, 2, 3, 4].map(i =>
            calls.page_error(i));
        const member = this.textAt(calls.page_error_member());
        const said = this.textAt(calls.page_error_text());
        const name = kind === "name" || kind === "value" ? names[from] : null;
        const message = kind === "name" ? "there is no such parameter"
            : said === null ? "outside of its interval"
            : (member ? `${member}: ` : "") + said + (nearest ? `; nearest: ${nearest}` : "");
        return {kind, message, line: kind === "text" ? line : null, column, name};
    }

    // The parameters of the recipe that was opened last, which has no tile: {name, value, lowest,
    // highest}
    params() {
        const {calls} = this, list = [], decoder = new TextDecoder();
        for (let i = 0, is; (is = calls.page_entry(i, 0)) >= 0; i++) {
            if (is === 1) {
                const [from, to, value, lowest, highest] = [1, 2, 3, 4, 5].map(what =>
                    calls.page_entry(i, what));
                list.push({name: decoder.decode(this.bytes.subarray(from, to)), value, lowest,
                    highest});
            }
        }
        return list;
    }

    // What the ground is like; `low` and `high` after findSpread()
    numbers() {
        return Object.fromEntries(NUMBERS.map((name, i) => [name, this.calls.page_number(i)]));
    }

    findSpread() {
        this.calls.page_set_spread();
    }

    // A palette for usual heights, and the light
    setLook(name, azimuth, altitude) {
        const i = this.palettes.indexOf(name);
        this.calls.page_set_look(Math.max(i, 0), azimuth, altitude);
        this.light = [0, 1, 2].map(axis => this.calls.page_light(axis));
    }

    // Samples rows of a raster, before the sea covers them.
    sample({width, height, origin, step}, from, to, order) {
        this.place.set([...origin, step]);
        this.calls.page_sample(this.place.byteOffset, from - (height - 1), width, to - from, order);
    }
}
