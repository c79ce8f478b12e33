// SPDX-License-Identifier: MIT
//
// A worker: samples bands of rows of a terrain, or of any node of a recipe, and makes pixels of
// them. The first message is the module, each other one a job. A job ends early when a newer one
// comes.
import {GROUNDS, STRIP, loadTerrain} from "./terrain.js";
import {curvatureColours, fieldColours, hillshade, slopeColours, steepnessColours, valueColours}
    from "./shade.js";

const ORDERS = {value: 0, curvature: 2}; // of derivatives; 1 for other views
const LOOK = 48; // samples along a side that tell which values a node has, about

let loading = null, terrain = null;
let latest = -1; // the number of the last job
let made = {key: null}; // what depends only on the recipe, and stays while the map moves

const channel = new MessageChannel();
// Lets messages come in.
const pause = () => new Promise(done => {
    channel.port1.onmessage = done;
    channel.port2.postMessage(0);
});

function openGround({source}) {
    const key = `${source.seed} ground ${source.text}`;
    if (made.key !== key) {
        close();
        const problem = terrain.open(source);
        if (problem !== null) {
            throw Object.assign(new Error(problem), {problem});
        }
        terrain.findSpread();
        made = {key, numbers: terrain.numbers()};
    }
    return made.numbers;
}

function openRecipe({source}) {
    const key = `${source.seed} recipe ${source.text}`;
    if (made.key !== key) {
        close();
        const recipe = terrain.scarp.recipe(source.text);
        recipe.seed = source.seed;
        made = {key, recipe};
    }
    return made.recipe;
}

function close() {
    made.recipe?.free();
    made = {key: null};
}

// Second derivatives as differences of exact first ones, along rows and down columns. The first
// and the last row are there only for their neighbours.
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

// How to work on rows of the ground: strip(row, end, values, pixels, masks)
function groundWork(job) {
    const {raster, view} = job, {width} = raster, numbers = openGround(job);
    const {samples} = job; // of rows from - edge to to + edge, if the GPU has made them
    const edge = samples?.edge ?? // rows above and below a strip
        (view === "curvature" && !numbers.hasHessian ? 1 : 0);
    terrain.setLook(job.palette, job.azimuth, job.altitude);
    const strip = (row, end, values, pixels, masks) => {
        const count = (end - row) * width, order = edge === 1 ? 1 : ORDERS[view] ?? 1;
        if (samples) {
            const first = (row - job.from) * width;
            terrain.take(parts(samples.arrays, first, first + count + 2 * edge * width));
        } else {
            terrain.sample(raster, row - edge, end + edge, order);
        }
        if (edge === 1) {
            differences(terrain.arrays, count + 2 * width, width, raster.step);
            for (const array of Object.values(terrain.arrays)) {
                array.copyWithin(0, width, width + count);
            }
        }
        terrain.calls.page_cover(count);
        paint(job, numbers, count, pixels);
        values.set(terrain.arrays.value.subarray(0, count));
        masks?.set(terrain.masks(count));
    };
    return {numbers, strip, high: Math.floor(STRIP / width) - 2 * edge};
}

const extremes = (values, of = i => values[i]) => {
    let lowest = Infinity, highest = -Infinity;
    for (let i = 0; i < values.length; i++) {
        const value = of(i);
        lowest = value < lowest ? value : lowest;
        highest = value > highest ? value : highest;
    }
    return [lowest, highest];
};

// The same for a node {which, order, range, isSpace}. A recipe of space is cut at z = 0.
function nodeWork(job) {
    const {raster, node, view} = job, {width, height, origin, step} = raster;
    const recipe = openRecipe(job), {arrays} = terrain;
    const isSlope = view === "slope" && node.order > 0;
    const sample = (across, rows, first, every) => {
        const box = node.isSpace ? [0] : [];
        const out = parts(isSlope ? {value: arrays.value, dx: arrays.dx, dy: arrays.dy}
            : {value: arrays.value}, 0, across * rows);
        const one = box.map(() => 1);
        recipe.grid({origin: [...origin, ...box], step: [step * every, -step * every, ...one],
            first: [0, first, ...box], count: [across, rows, ...one]}, out, {which: node.which});
        return out;
    };
    // What most values are like is told by a look at all of the raster: bands agree.
    const every = Math.max(1, Math.ceil(Math.max(width, height) / LOOK));
    const [across, rows] = [width, height].map(n => Math.ceil(n / every));
    const look = sample(across, rows, -Math.floor((height - 1) / every), every);
    const met = extremes(look.value);
    const [, steepest] = isSlope ? extremes(look.value, i => Math.hypot(look.dx[i], look.dy[i]))
        : [0, 0];
    const strip = (row, end, values, pixels) => {
        const out = sample(width, end - row, row - (height - 1), 1);
        if (isSlope) {
            steepnessColours(out, steepest, pixels);
        } else {
            fieldColours(out.value, met, pixels);
        }
        values.set(out.value);
    };
    const [low, high] = node.range;
    const numbers = {floor: low, lowest: low, highest: high, steepest};
    return {numbers, strip, high: Math.floor(STRIP / width)};
}

// Rows `from` to `to` of the job's raster; null if a newer job has come.
async function work(job) {
    const {raster: {width}, from, to} = job;
    const {numbers, strip, high} = job.node ? nodeWork(job) : groundWork(job);
    const values = new Float32Array(width * (to - from)), pixels = new Uint32Array(values.length);
    const masks = job.hasMasks ? new Uint8Array(GROUNDS * values.length) : null;
    for (let row = from; row < to; row += high) {
        const end = Math.min(row + high, to), first = (row - from) * width;
        const last = first + (end - row) * width;
        strip(row, end, values.subarray(first, last), pixels.subarray(first, last),
            masks?.subarray(GROUNDS * first, GROUNDS * last));
        if (end < to) {
            await pause();
            if (latest !== job.id) {
                return null;
            }
        }
    }
    return {values, pixels, masks, numbers, met: extremes(values)};
}

onmessage = async ({data}) => {
    if (data instanceof WebAssembly.Module) {
        loading = loadTerrain(data);
        return;
    }
    latest = data.id;
    try {
        terrain = await loading;
        const result = latest === data.id ? await work(data) : null;
        if (result !== null) {
            const {values, pixels, masks} = result;
            postMessage({id: data.id, from: data.from, ...result},
                [values.buffer, pixels.buffer, ...(masks ? [masks.buffer] : [])]);
        }
    } catch (error) {
        postMessage({id: data.id, problem: error.problem ?? null,
            error: String(error.stack ?? error)});
    }
};
