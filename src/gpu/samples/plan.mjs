// SPDX-License-Identifier: MIT
//
// Writes relief.plan for webgpu.html and webgl.html with the npm package, as `relief relief.plan`
// does. A page can do that itself, and needs no file then.
import { writeFileSync } from 'node:fs';
import { load } from 'scarp-noise';

const scarp = await load();
const bend = { seed: 9, frequency: 1 / 190, octaves: 3, amplitude: 44 };
const ground = {
    fractal: 'swiss', rotate: true, seed: 14, frequency: 1 / 300, octaves: 7, amplitude: 160,
    sharpness: 0.12, warp: bend,
};
const plan = scarp.gpuPlan(ground, 2); // a Uint8Array of 5376 bytes
writeFileSync('relief.plan', plan);
