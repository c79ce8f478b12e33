// SPDX-License-Identifier: MIT
//
// Finds the modules, in node and in browsers, and tells which one the engine can run.

// A module whose only function makes a vector: valid where engines have them.
const PROBE = '0 97 115 109 1 0 0 0 1 5 1 96 0 1 123 3 2 1 0 10 10 1 8 0 65 0 253 15 253 98 11';

export const hasVectors = () => WebAssembly.validate(Uint8Array.from(PROBE.split(' ')));

// The module that is beside this file, with vectors or without.
export async function compile(simd) {
    const url = simd
        ? new URL('./scarp-simd.wasm', import.meta.url)
        : new URL('./scarp-fallback.wasm', import.meta.url);
    if (url.protocol === 'file:') {
        // node, whose fetch() does not read files
        const { readFile } = await import(
            /* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises'
        );
        return WebAssembly.compile(await readFile(url));
    }
    const response = await fetch(url);
    if (!response.ok) {
        throw new Error(`${url}: ${response.status} ${response.statusText}`);
    }
    // Not compileStreaming: some servers send no MIME type for .wasm.
    return WebAssembly.compile(await response.arrayBuffer());
}
