// SPDX-License-Identifier: MIT
//
// Runs every case that write_cases wrote through a shader, and compares all bits with those of the
// C library. The query says what to run: ?test=wgsl, ?test=webgl, ?test=control, or recipes by
// ?test=recipes.wgsl and ?test=recipes.webgl. Lines of the
// report go to /say; /end takes 0 (passed), 1 (failed) or 77 (skipped), the exit status of ctest.
import {get} from "./common.js";
import {compareRecipes} from "./recipes.js";
import {openWebgpu} from "./webgpu.js";
import {openWebgl} from "./webgl.js";

const NAMES = ["value", "dx", "dy", "dz", "dxx", "dxy", "dxz", "dyy", "dyz", "dzz"];
const ORDERS = [0, 1, 1, 1, 2, 2, 2, 2, 2, 2];
const TINY = 0x03800000; // the bits of 2^-120
const INFINITY = 0x7f800000;
const FIRST_AMPLITUDE = 256 + 20; // bytes before octave[0].amplitude of struct scarp_gpu_plan

const post = (where, text) => fetch(where, {method: "POST", body: text});
const say = line => post("/say", line);

async function words(name) {
    return new Uint32Array(await (await get("/cases/" + name)).arrayBuffer());
}

// The sign of zeros, magnitudes below 2^-120 and payloads of NaN are not promised.
function same(a, b) {
    const m = a & 0x7fffffff, n = b & 0x7fffffff;
    return a === b || (m < TINY && n < TINY) || (m > INFINITY && n > INFINITY);
}

function asFloat(bits) {
    return new Float32Array(Uint32Array.of(bits).buffer)[0];
}

// Whether output `number` is one of a case: those along z only in space, derivatives up to `order`.
function has(item, number) {
    return ORDERS[number] <= item.order && (item.dimensions === 3 || !NAMES[number].includes("z"));
}

// Compares what a case has of the outputs, which are one after the other.
function compareOutputs(item, got, expected, count) {
    const result = {compared: 0, differing: 0, first: ""};
    for (let number = 0; number < NAMES.length; number++) {
        if (!has(item, number)) {
            continue;
        }
        for (let i = number * count; i < (number + 1) * count; i++) {
            result.compared++;
            if (!same(got[i], expected[i]) && result.differing++ === 0) {
                result.first = `; first: ${NAMES[number]}[${i % count}] is ${asFloat(got[i])}, ` +
                               `not ${asFloat(expected[i])}`;
            }
        }
    }
    return result;
}

// Answer i is of order i % 3; those expected of one order come after those of another.
function compareAnswers(item, got, expected, count) {
    const result = {compared: 0, differing: 0};
    for (let i = 0; i < count; i++) {
        if (i % 3 <= item.order) {
            result.compared++;
            result.differing += got[i] !== expected[i % 3 * count + i];
        }
    }
    return result;
}

// Runs case `number` with a plan, the words of a struct scarp_gpu_plan.
async function runCase(device, cases, number, plan) {
    const item = cases.list[number];
    const outputs = await device.sample(plan, item.dimensions, await words(`${number}.points`));
    const answers = await device.answers(plan, item.dimensions);
    const samples = compareOutputs(item, outputs.words, await words(`${number}.outputs`),
                                   cases.points);
    const hashes = compareAnswers(item, answers.words, await words(`${number}.answers`),
                                  cases.answers);
    const speed = Math.round(cases.points / outputs.seconds / 1000);
    await say(`${item.name}: ${samples.differing} of ${samples.compared} outputs differ, ` +
              `${hashes.differing} of ${hashes.compared} answers; ` +
              `${speed} thousand points/s${samples.first}`);
    return {samples, hashes};
}

async function runAll(device, cases) {
    const sum = {compared: 0, differing: 0, hashes: 0, wrong: 0};
    for (const number of cases.list.keys()) {
        const plan = await words(`${number}.plan`);
        const {samples, hashes} = await runCase(device, cases, number, plan);
        sum.compared += samples.compared;
        sum.differing += samples.differing;
        sum.hashes += hashes.compared;
        sum.wrong += hashes.differing;
    }
    await say(`in all: ${sum.differing} of ${sum.compared} outputs differ, ` +
              `${sum.wrong} of ${sum.hashes} answers`);
    return sum.compared > 0 && sum.differing === 0 && sum.wrong === 0;
}

// With its plan a case is right. Where the lowest bit of an amplitude is wrong, the comparison must
// notice.
async function noticesBit(device, cases) {
    const plan = await words("0.plan"), right = await runCase(device, cases, 0, plan);
    plan[FIRST_AMPLITUDE / 4] ^= 1;
    const wrong = await runCase(device, cases, 0, plan);
    return right.samples.differing === 0 && right.hashes.differing === 0 &&
           wrong.samples.differing > 0 && wrong.hashes.differing > 0;
}

// A shader that does not compile: the report must have the number of its line.
async function noticesError(open, cases) {
    const {device, errors} = await open(cases.points, {}, source => "no shader " + source);
    await say(`a shader with a mistake in line 1: ${errors.join(" | ")}`);
    return device === undefined && errors.some(error => /\b1\b/.test(error));
}

const OPENERS = {wgsl: openWebgpu, webgl: openWebgl};

// Compiles the shaders; null where the browser has no such thing.
async function opened(open, cases, options) {
    const {device, missing, errors} = await open(cases.points, options);
    if (missing) {
        await say(missing);
        return null;
    }
    for (const error of errors) {
        await say(error);
    }
    if (errors.length > 0) {
        throw new Error("the shader does not compile");
    }
    await say(`${device.name}; shaders compiled in ${device.seconds.toFixed(1)} s`);
    return device;
}

// Case 0 is plain gradient noise; a shader of nothing else compiles fast.
const CONTROL = {dimensions: [2], only: {basis: 0, fractal: 0, depth: 0}};

async function control(cases) {
    let controlled = 0;
    for (const [name, open] of Object.entries(OPENERS)) {
        const device = await opened(open, cases, CONTROL);
        if (device) {
            const bit = await noticesBit(device, cases), error = await noticesError(open, cases);
            await say(`${name}: ${bit ? "notices" : "DOES NOT NOTICE"} a wrong bit, ` +
                      `${error ? "reports" : "DOES NOT REPORT"} errors of the compiler`);
            if (!bit || !error) {
                return 1;
            }
            controlled++;
        }
    }
    return controlled > 0 ? 0 : 77;
}

async function main() {
    const query = new URLSearchParams(location.search), test = query.get("test");
    const cases = await (await get("/cases/index.json")).json();
    if (test === "control") {
        return control(cases);
    }
    if (test.startsWith("recipes.")) {
        return compareRecipes(test.slice("recipes.".length), cases, {say, words, same});
    }
    const device = await opened(OPENERS[test], cases, {barrier: !query.has("no-barrier")});
    return device ? (await runAll(device, cases) ? 0 : 1) : 77;
}

async function fail(error) {
    await say(String(error.stack || error));
    await post("/end", "1");
}

addEventListener("error", event => fail(event.message));
addEventListener("unhandledrejection", event => fail(event.reason));
await post("/end", String(await main()));
