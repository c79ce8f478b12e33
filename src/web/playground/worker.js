// SPDX-License-Identifier: MIT
//
// A worker: samples bands of rows of a terrain and makes pixels of them.
import {Sampler, differences, floatPlaces, gridOf, makeGround, piecesOf,
    withoutHessian} from "./ground.js";
import {load} from "./scarp.mjs";
import {paletteOf} from "./palettes.js";
import {loadRelief} from "./relief.js";
import {curvatureColours, hillshade, lightOf, slopeColours, valueColours} from "./shade.js";
import {spreadOf} from "./spread.js";

const STRIP = 32768; // samples that are computed at once: they stay in the cache
const NORMALS = ["nx", "ny", "nz"];

let scarp = null, relief = null;
let made = {key: null}; // what depends on the terrain alone, and stays while the map moves

function groundOf(terrain) {
    const {raster, azimuth, altitude, zFactor, ...rest} = terrain;
    const key = JSON.stringify(rest, (_, value) => typeof value === "bigint" ? `${value}n` :
        value === Infinity || value === -Infinity ? String(value) : value);
    if (made.key !== key) {
        const ground = makeGround(scarp, terrain);
        made = {key, ground, sampler: new Sampler(scarp, ground), spread: null};
    }
    return made;
}

function arrays(names, count) {
    return Object.fromEntries(names.map(name => [name, new Float32Array(count)]));
}

function normalsOf(samples, scale, count) {
    const normals = arrays(NORMALS, count);
    scarp.normals(samples.dx, samples.dy, scale, normals);
    return NORMALS.map(name => normals[name]);
}

// What the views need to know of the whole terrain
function lookOf(job, ground) {
    const {terrain, view, preset} = job, light = lightOf(terrain.azimuth, terrain.altitude);
    if (view === "relief" || view === "value") {
        made.spread ??= spreadOf(scarp, ground);
    }
    if (view === "relief") {
        relief.set(paletteOf(preset), light, made.spread);
    }
    const hasBed = view === "relief" && made.spread.hasSea;
    return {view, light, spread: made.spread, hasBed, hasHessian: withoutHessian(ground) === null};
}

function paint(look, job, samples, bed, pixels) {
    const {terrain} = job, {ground} = made, count = pixels.length, scale = ground.heightScale;
    if (look.view === "value") {
        valueColours(samples.value, look.spread, pixels);
        return;
    }
    if (look.view === "curvature") {
        curvatureColours(samples, scale, 1 / (12 * terrain.raster.step), pixels);
        return;
    }
    const exaggerated = Math.fround(scale * terrain.zFactor);
    const normal = normalsOf(samples, scale, count);
    if (look.view === "slope") {
        slopeColours(normal[2], pixels);
        return;
    }
    const shade = terrain.zFactor !== 1 ? normalsOf(samples, exaggerated, count) : normal;
    if (look.view === "hillshade") {
        hillshade(shade, look.light, pixels);
    } else {
        relief.paint({value: samples.value, bed, normal, shade}, pixels);
    }
}

const TINY = 2 ** -120; // shaders may take 0 for what is below

function differing(a, b) {
    let count = 0;
    for (let i = 0; i < a.length; i++) {
        count += a[i] !== b[i] && !(Math.abs(a[i]) < TINY && Math.abs(b[i]) < TINY);
    }
    return count;
}

// Compares samples of a GPU with those of the library, and the pixels that both make.
class Comparison {
    constructor() {
        this.result = {pixels: 0, differing: 0, values: 0, wrong: 0};
    }

    add(look, job, grid, given, pixels) {
        const {ground, sampler} = made, places = floatPlaces(ground, grid), {result} = this;
        const expected = {};
        for (const [name, samples] of Object.entries(given)) {
            const at = name === "noise" ? places.noise : places.plain;
            expected[name] = arrays(Object.keys(samples), pixels.length);
            scarp.sample2(ground[name], ...at, expected[name]);
            for (const [member, array] of Object.entries(samples)) {
                result.values += array.length;
                result.wrong += differing(array, expected[name][member]);
            }
        }
        const own = new Uint32Array(pixels.length);
        const out = arrays(Object.keys(given.noise), own.length);
        sampler.uncutGiven(expected, out);
        const bed = look.hasBed ? out.value.slice() : null;
        sampler.clamp(out);
        paint(look, job, out, bed, own);
        result.pixels += own.length;
        for (let i = 0; i < own.length; i++) {
            result.differing += own[i] !== pixels[i];
        }
    }
}

// Paints what a GPU has sampled. Values stay those of the terrain, in double, unless it is dragged.
function workGiven(job) {
    const {terrain, from, to, given} = job, {raster} = terrain, {width} = raster;
    const {ground, sampler} = groundOf(terrain), look = lookOf(job, ground);
    const values = new Float32Array(width * (to - from)), pixels = new Uint32Array(values.length);
    const high = Math.max(2, Math.floor(STRIP / width)), comparison = new Comparison();
    for (let row = from; row < to; row += high) {
        const end = Math.min(row + high, to), first = (row - from) * width;
        const last = (end - from) * width, grid = gridOf(raster, row, end);
        const strip = Object.fromEntries(Object.entries(given).map(([name, samples]) =>
            [name, piecesOf(samples, first, last)]));
        const out = arrays(Object.keys(given.noise), last - first);
        sampler.uncutGiven(strip, out);
        const bed = look.hasBed ? out.value.slice() : null, painted = pixels.subarray(first, last);
        sampler.clamp(out);
        paint(look, job, out, bed, painted);
        if (job.verify) {
            comparison.add(look, job, grid, strip, painted);
            sampler.uncutGrid(grid, {value: out.value});
            sampler.clamp({value: out.value});
        }
        values.set(out.value, first);
    }
    return {values, pixels, floor: ground.floor, ceiling: ground.ceiling,
        compared: job.verify ? comparison.result : null};
}

// Samples and paints rows `from` to `to` of the job's raster.
function work(job) {
    const {terrain, from, to} = job, {raster} = terrain;
    const {ground, sampler} = groundOf(terrain), look = lookOf(job, ground);
    const count = raster.width * (to - from), values = new Float32Array(count);
    const pixels = new Uint32Array(count);
    const names = ["value", ...(look.view === "value" ? [] : ["dx", "dy"]),
        ...(look.view === "curvature" ? ["dxx", "dxy", "dyy"] : [])];
    const edge = look.view === "curvature" && !look.hasHessian ? 1 : 0; // rows beside a strip
    const high = Math.max(2, Math.floor(STRIP / raster.width)), {width} = raster;
    const out = arrays(names, width * (Math.min(high, to - from) + 2 * edge));
    for (let row = from; row < to; row += high) {
        const end = Math.min(row + high, to);
        const whole = piecesOf(out, 0, (end - row + 2 * edge) * width);
        const part = piecesOf(whole, edge * width, (end - row + edge) * width);
        const {dxx, dxy, dyy, ...firsts} = whole;
        sampler.uncutGrid(gridOf(raster, row - edge, end + edge), edge === 0 ? whole : firsts);
        if (edge === 1) {
            differences(whole, width, raster.step);
        }
        const bed = look.hasBed ? part.value.slice() : null;
        sampler.clamp(part);
        const first = (row - from) * width, last = (end - from) * width;
        paint(look, job, part, bed, pixels.subarray(first, last));
        values.set(part.value, first);
    }
    const {floor, ceiling} = ground;
    return {values, pixels, floor, ceiling};
}

onmessage = async ({data}) => {
    try {
        if (relief === null) {
            [scarp, relief] = await Promise.all([load(), loadRelief()]);
        }
        const result = data.given ? workGiven(data) : work(data);
        postMessage({id: data.id, from: data.from, ...result},
            [result.values.buffer, result.pixels.buffer]);
    } catch (error) {
        postMessage({id: data.id, error: String(error.stack ?? error)});
    }
};
