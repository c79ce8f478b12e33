// SPDX-License-Identifier: MIT
//
// The colours of the relief: a module of the program's own code, relief.c.
import {hasVectors} from "./compile.mjs";

const COUNT = 32768; // pixels at once
const VALUE = 0, BED = 1, NORMAL = 2, SHADE = 5, ARRAYS = 8; // as in relief.c

export async function loadRelief() {
    const name = hasVectors() ? "./relief-simd.wasm" : "./relief-fallback.wasm";
    const response = await fetch(new URL(name, import.meta.url));
    const {instance} = await WebAssembly.instantiate(await response.arrayBuffer(), {});
    return new Relief(instance.exports);
}

class Relief {
    constructor(calls) {
        const {buffer} = calls.memory;
        this.calls = calls;
        this.arrays = Array.from({length: ARRAYS}, (_, i) =>
            new Float32Array(buffer, calls.page_array(i), COUNT));
        this.pixels = new Uint32Array(buffer, calls.page_pixels(), COUNT);
        this.palettes = [];
        for (let i = 0, at; (at = calls.page_palette_name(i)) !== 0; i++) {
            const bytes = new Uint8Array(buffer, at);
            this.palettes.push(new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0))));
        }
    }

    // What is the same for all pixels: the name of a palette, the unit vector to the light, usual
    // values
    set(palette, light, {low, middle, high, sea, deep}) {
        this.calls.page_set_look(this.palettes.indexOf(palette), ...light);
        this.calls.page_set_spread(low, middle, high, sea, deep);
    }

    // `bed` has the values below the sea, too, or is null; `shade` are the normals that are lit.
    paint({value, bed, normal, shade}, pixels) {
        const {arrays, calls} = this, hasShade = shade !== normal;
        for (let first = 0; first < pixels.length; first += COUNT) {
            const last = Math.min(first + COUNT, pixels.length);
            const put = (i, array) => arrays[i].set(array.subarray(first, last));
            put(VALUE, value);
            normal.forEach((array, i) => put(NORMAL + i, array));
            if (bed !== null) {
                put(BED, bed);
            }
            if (hasShade) {
                shade.forEach((array, i) => put(SHADE + i, array));
            }
            calls.page_paint(last - first, bed !== null, hasShade);
            pixels.set(this.pixels.subarray(0, last - first), first);
        }
    }
}
