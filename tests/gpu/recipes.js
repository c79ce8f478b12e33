// SPDX-License-Identifier: MIT
//
// Runs recipes as shaders, in compute shaders of WebGPU or fragment shaders of WebGL 2, and compares
// all outputs and the self-test with what recipe_cases.c wrote. It says how long pipelines take.
import {WIDTH, draw, get, link, texelsOf} from "./common.js";

const MEMBERS = 10;
const ORDERS = [0, 1, 1, 1, 2, 2, 2, 2, 2, 2];
const ALONG_Z = [3, 6, 8, 9];
const GROUP = 64;
const NAMES = ["value", "gradient.x", "gradient.y", "gradient.z", "diagonal.x", "mixed.x", "mixed.y",
    "diagonal.y", "mixed.z", "diagonal.z"];

const text = async name => (await get("/cases/" + name)).text();

// WebGPU

const wgslMain = ({orders, dimensions}) => `
@group(0) @binding(0) var<uniform> scarp_plan: ScarpRecipePlan;
@group(0) @binding(1) var<storage, read> points: array<f32>;
@group(0) @binding(2) var<storage, read_write> results: array<u32>;
@compute @workgroup_size(${GROUP})
fn outputs(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    let count = arrayLength(&points) / 3;
    let r = scarp_recipe(points[i], points[count + i]${dimensions === 3
        ? ", points[2 * count + i]" : ""});
${orders.flatMap((_, output) => NAMES.map((name, m) =>
        `    results[${output * MEMBERS + m} * count + i] = bitcast<u32>(r.out${output}.${name});`))
        .join("\n")}
}
@compute @workgroup_size(${GROUP})
fn answers(@builtin(global_invocation_id) id: vec3u) {
    results[id.x] = scarp_answer_recipe(id.x);
}`;

class Webgpu {
    static async open() {
        const adapter = await navigator.gpu?.requestAdapter();
        if (!adapter) {
            return {missing: "skipped: this browser has no WebGPU adapter"};
        }
        const gpu = await adapter.requestDevice();
        gpu.addEventListener("uncapturederror", event => {
            throw new Error(event.error.message);
        });
        gpu.lost.then(({message}) => {
            throw new Error(`the device is lost: ${message}`);
        });
        return {device: Object.assign(new Webgpu(), {gpu})};
    }

    buffer(size, usage, content) {
        const buffer = this.gpu.createBuffer({size, usage: usage | GPUBufferUsage.COPY_DST});
        if (content) {
            this.gpu.queue.writeBuffer(buffer, 0, content);
        }
        return buffer;
    }

    async pipeline(module, entryPoint) {
        const begin = performance.now();
        const pipeline = await this.gpu.createComputePipelineAsync(
            {layout: "auto", compute: {module, entryPoint}});
        return {pipeline, ms: performance.now() - begin};
    }

    async run(pipeline, buffers, threads, size) {
        const {STORAGE, COPY_SRC, MAP_READ} = GPUBufferUsage;
        const results = this.buffer(size, STORAGE | COPY_SRC), readable = this.buffer(size, MAP_READ);
        const entries = Object.entries({...buffers, 2: results}).map(
            ([binding, buffer]) => ({binding: Number(binding), resource: {buffer}}));
        const encoder = this.gpu.createCommandEncoder(), pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, this.gpu.createBindGroup(
            {layout: pipeline.getBindGroupLayout(0), entries}));
        pass.dispatchWorkgroups(threads / GROUP);
        pass.end();
        encoder.copyBufferToBuffer(results, 0, readable, 0, size);
        this.gpu.queue.submit([encoder.finish()]);
        await readable.mapAsync(GPUMapMode.READ);
        const words = new Uint32Array(readable.getMappedRange().slice(0));
        results.destroy();
        readable.destroy();
        return words;
    }

    // The words of all outputs, those of the answers, and what the first pipeline takes.
    async compute(item, source, uniforms, points, answers) {
        const module = this.gpu.createShaderModule({code: source + wgslMain(item)});
        const errors = (await module.getCompilationInfo()).messages
            .filter(({type}) => type === "error")
            .map(({lineNum, linePos, message}) => `${lineNum}:${linePos}: ${message}`);
        if (errors.length > 0) {
            throw new Error(`recipe ${item.number}: ${errors.slice(0, 3).join("; ")}`);
        }
        const {UNIFORM, STORAGE} = GPUBufferUsage, count = points.length / 3;
        const plan = this.buffer(uniforms.byteLength, UNIFORM, uniforms);
        const places = this.buffer(points.byteLength, STORAGE, points);
        const {pipeline, ms} = await this.pipeline(module, "outputs");
        const outputs = await this.run(pipeline, {0: plan, 1: places}, count,
            4 * MEMBERS * item.orders.length * count);
        const tested = item.number % 8 > 0 ? null : await this.run(
            (await this.pipeline(module, "answers")).pipeline, {0: plan}, answers, 4 * answers);
        plan.destroy();
        places.destroy();
        return {outputs, answers: tested, ms};
    }
}

// WebGL 2

const glslMain = ({dimensions}, output) => `
uniform highp usampler2D points;
layout(location = 0) out uvec4 target0;
layout(location = 1) out uvec4 target1;
layout(location = 2) out uvec4 target2;
void main() {
    vec3 p = uintBitsToFloat(texelFetch(points, ivec2(gl_FragCoord.xy), 0).xyz);
    ScarpSample s = scarp_recipe(${dimensions === 3 ? "p.x, p.y, p.z" : "p.x, p.y"}).out${output};
    target0 = floatBitsToUint(vec4(s.value, s.gradient));
    target1 = floatBitsToUint(vec4(s.diagonal.x, s.mixed.xy, s.diagonal.y));
    target2 = floatBitsToUint(vec4(s.mixed.z, s.diagonal.z, 0.0, 0.0));
}`;

const GLSL_ANSWER = `
layout(location = 0) out uvec4 target0;
void main() {
    uint i = uint(gl_FragCoord.y) * ${WIDTH}u + uint(gl_FragCoord.x);
    target0 = uvec4(scarp_answer_recipe(i), 0u, 0u, 0u);
}`;

class Webgl {
    static async open() {
        const gl = document.createElement("canvas").getContext("webgl2");
        return gl ? {device: Object.assign(new Webgl(), {gl})}
            : {missing: "skipped: this browser has no WebGL 2"};
    }

    // Words of so many targets.
    draw(number, fragment, targets, height, texels) {
        try {
            const program = link(this.gl, fragment, "ScarpRecipePlans");
            const {results} = draw(this.gl, program, targets, height, texels);
            this.gl.deleteProgram(program);
            return results;
        } catch (error) {
            throw new Error(`recipe ${number}: ${error.message}`);
        }
    }

    async compute(item, source, uniforms, points, answers) {
        const {gl} = this, count = points.length / 3, head = "#version 300 es\n" + source;
        const texels = texelsOf(points, count);
        const block = gl.createBuffer();
        gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, block);
        gl.bufferData(gl.UNIFORM_BUFFER, uniforms, gl.STATIC_DRAW);
        const outputs = new Uint32Array(MEMBERS * item.orders.length * count);
        let ms = 0;
        for (const output of item.orders.keys()) {
            const begin = performance.now();
            const words = this.draw(item.number, head + glslMain(item, output), 3, count / WIDTH,
                texels);
            ms += performance.now() - begin;
            for (let i = 0; i < MEMBERS * count; i++) {
                const m = Math.floor(i / count);
                outputs[output * MEMBERS * count + i] = words[m >> 2][4 * (i % count) + (m & 3)];
            }
        }
        const [tested] = item.number % 8 > 0 ? [null]
            : this.draw(item.number, head + GLSL_ANSWER, 1, answers / WIDTH, null);
        gl.deleteBuffer(block);
        return {outputs, answers: tested?.filter((_, i) => i % 4 === 0), ms};
    }
}

// How many of the words differ that a recipe has of its outputs.
function compare(item, got, expected, count, same) {
    const result = {compared: 0, differing: 0, first: ""};
    for (let i = 0; i < got.length; i++) {
        const output = Math.floor(i / count / MEMBERS), m = Math.floor(i / count) % MEMBERS;
        if (ORDERS[m] <= item.orders[output] &&
            (item.dimensions === 3 || !ALONG_Z.includes(m))) {
            result.compared++;
            if (!same(got[i], expected[i]) && result.differing++ === 0) {
                const [a, b] = new Float32Array(Uint32Array.of(got[i], expected[i]).buffer);
                result.first = `; first: output ${output}, ${NAMES[m]}, point ${i % count}: ` +
                    `${a}, not ${b}`;
            }
        }
    }
    return result;
}

// Returns an exit status.
export async function compareRecipes(kind, cases, {say, words, same}) {
    const {device, missing} = await (kind === "wgsl" ? Webgpu : Webgl).open();
    if (missing) {
        await say(missing);
        return 77;
    }
    const sum = {compared: 0, differing: 0, answers: 0, wrong: 0};
    for (const item of cases.list) {
        const n = item.number;
        const [source, uniforms, points, expected, answers] = [await text(`${n}.text`),
            ...await Promise.all(["uniforms", "points", "outputs", "answers"]
                .map(name => words(`${n}.${name}`)))];
        const got = await device.compute(item, source, uniforms, points, cases.answers);
        const {compared, differing, first} =
            compare(item, got.outputs, expected, cases.points, same);
        const wrong = got.answers ? answers.filter((answer, i) => answer !== got.answers[i]).length
            : 0;
        sum.compared += compared;
        sum.differing += differing;
        sum.answers += got.answers ? answers.length : 0;
        sum.wrong += wrong;
        await say(`recipe ${n}: ${differing} of ${compared} outputs differ, ${wrong} answers; ` +
            `compiled in ${(got.ms / 1000).toFixed(2)} s${first}`);
    }
    await say(`in all: ${sum.differing} of ${sum.compared} outputs differ, ` +
        `${sum.wrong} of ${sum.answers} answers`);
    return sum.compared > 0 && sum.answers > 0 && sum.differing === 0 && sum.wrong === 0 ? 0 : 1;
}
