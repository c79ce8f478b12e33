// SPDX-License-Identifier: MIT
//
// The module of the page, page.c: grounds, samples and pixels by the program's own code, and the
// calls of the npm package for recipes.
import {hasVectors} from "../compile.mjs";
import {bind} from "../scarp.mjs";

export const STRIP = 65536; // samples at once: they stay in the cache
export const GROUNDS = 5; // of masks
const ARRAYS = ["value", "dx", "dy", "dxx", "dxy", "dyy", "bed", "nx", "ny", "nz", "sx", "sy",
    "sz"];
const NUMBERS = ["lowest", "highest", "floor", "hasSea", "hasHessian", "low", "high"];
const MEMORY = 4 * 2 ** 20; // bytes for recipes
const TEXT_MOST = 16384;

// The module is compiled once; workers are sent it.
export async function compileModule() {
    const name = hasVectors() ? "./page-simd.wasm" : "./page-fallback.wasm";
    const response = await fetch(new URL(name, import.meta.url));
    if (!response.ok) {
        throw new Error(`${name}: ${response.status}`);
    }
    return WebAssembly.compile(await response.arrayBuffer());
}

export async function loadTerrain(module) {
    const {exports} = await WebAssembly.instantiate(module, {});
    return new Terrain(exports);
}

class Terrain {
    constructor(calls) {
        this.scarp = bind(calls, MEMORY); // memory grows here, and not later
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
        const bytes = new Uint8Array(this.calls.memory.buffer, at);
        return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    }

    // Opens a recipe as a terrain: null, or why it is none.
    open({text, seed}) {
        const {calls} = this, bytes = new TextEncoder().encode(text);
        if (bytes.length > TEXT_MOST) {
            return "the text is longer than 16,384 bytes";
        }
        new Uint8Array(calls.memory.buffer, calls.page_text(), TEXT_MOST).set(bytes);
        return calls.page_open(bytes.length, seed) === 0 ? null
            : this.textAt(calls.page_error_text());
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

    // Takes samples that were made elsewhere, {value, dx, ...}, in place of sample().
    take(samples) {
        for (const [name, array] of Object.entries(samples)) {
            this.arrays[name].set(array);
        }
    }

    // How much of each ground the last `count` samples have, GROUNDS bytes each
    masks(count) {
        const at = this.calls.page_masks(count);
        return new Uint8Array(this.calls.memory.buffer, at, GROUNDS * count);
    }
}
