// SPDX-License-Identifier: MIT
//
// A worker: samples bands of rows of a terrain and makes pixels of them.
import {STRIP, loadTerrain} from "./terrain.js";
import {curvatureColours, hillshade, slopeColours, valueColours} from "./shade.js";

const ORDERS = {value: 0, curvature: 2}; // of derivatives; 1 for other views

let terrain = null;
let made = {key: null}; // what depends on the terrain alone, and stays while the map moves

function open({source}) {
    const key = JSON.stringify({...source, seed: String(source.seed)});
    if (made.key !== key) {
        const problem = terrain.open(source);
        if (problem !== null) {
            throw new Error(problem.message);
        }
        terrain.findSpread();
        made = {key, numbers: terrain.numbers()};
    }
    return made.numbers;
}

// Second derivatives as differences of exact first ones, along rows and down columns. The first
// and the last row are there for their neighbours alone.
function differences({dx, dy, dxx, dxy, dyy}, count, width, step) {
    const rows = count / width;
    for (let i = 0; i < count; i++) {
        const column = i % width, row = Math.floor(i / width);
        const a = column > 0 ? i - 1 : i, b = column < width - 1 ? i + 1 : i;
        const c = row > 0 ? i - width : i, d = row < rows - 1 ? i + width : i; // above, below
        dxx[i] = (dx[b] - dx[a]) / ((b - a || 1) * step);
        dyy[i] = (dy[c] - dy[d]) / (((d - c) / width || 1) * step);
        dxy[i] = (dy[b] - dy[a]) / ((b - a || 1) * step);
    }
}

const parts = (arrays, from, to) => Object.fromEntries(
    Object.entries(arrays).map(([name, array]) => [name, array.subarray(from, to)]));

function paint(job, numbers, count, pixels) {
    const {calls, arrays} = terrain, {view, zFactor, raster} = job, part = parts(arrays, 0, count);
    if (view === "value") {
        valueColours(part.value, numbers, pixels);
    } else if (view === "curvature") {
        curvatureColours(part, 1 / (12 * raster.step), pixels);
    } else {
        calls.page_normals(count, zFactor);
        const shade = zFactor !== 1 ? [part.sx, part.sy, part.sz] : [part.nx, part.ny, part.nz];
        if (view === "slope") {
            slopeColours(part.nz, pixels);
        } else if (view === "hillshade") {
            hillshade(shade, terrain.light, pixels);
        } else {
            calls.page_paint(count, zFactor !== 1);
            pixels.set(terrain.pixels.subarray(0, count));
        }
    }
}

// Samples and paints rows `from` to `to` of the job's raster.
function work(job) {
    const {raster, view, from, to} = job, {width} = raster, numbers = open(job);
    const values = new Float32Array(width * (to - from)), pixels = new Uint32Array(values.length);
    const edge = view === "curvature" && !numbers.hasHessian ? 1 : 0; // rows beside a strip
    const high = Math.floor(STRIP / width) - 2 * edge, order = ORDERS[view] ?? 1;
    terrain.setLook(job.palette, job.azimuth, job.altitude);
    for (let row = from; row < to; row += high) {
        const end = Math.min(row + high, to), count = (end - row) * width;
        terrain.sample(raster, row - edge, end + edge, edge === 1 ? 1 : order);
        if (edge === 1) {
            const whole = count + 2 * width;
            differences(terrain.arrays, whole, width, raster.step);
            for (const array of Object.values(terrain.arrays)) {
                array.copyWithin(0, width, width + count);
            }
        }
        terrain.calls.page_cover(count);
        const first = (row - from) * width;
        paint(job, numbers, count, pixels.subarray(first, first + count));
        values.set(terrain.arrays.value.subarray(0, count), first);
    }
    return {values, pixels, numbers};
}

onmessage = async ({data}) => {
    try {
        terrain ??= await loadTerrain();
        const result = work(data);
        postMessage({id: data.id, from: data.from, ...result},
            [result.values.buffer, result.pixels.buffer]);
    } catch (error) {
        postMessage({id: data.id, error: String(error.stack ?? error)});
    }
};
