// SPDX-License-Identifier: MIT
//
// Runs a program of WebAssembly under node, as the emulator of cmake/wasm32.cmake:
//
//     node wasi.mjs PROGRAM [ARGUMENT...]
//
// The program sees the files of this machine, the arguments and the environment.
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const [program, ...args] = process.argv.slice(2);
const wasi = new WASI({
    version: 'preview1',
    args: [program, ...args],
    env: process.env,
    preopens: { '/': '/' },
    returnOnExit: true,
});
const module = await WebAssembly.compile(await readFile(program));
const instance = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: wasi.wasiImport });
process.exitCode = wasi.start(instance);
