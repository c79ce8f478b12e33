// SPDX-License-Identifier: MIT
//
// Runs scarp.wgsl in compute shaders.
import {get} from "./common.js";

const PLANS = 2; // the plan is the second, so that indices are tested, too
const PLAN_BYTES = 5376;
const OUTPUTS = 10;
const ANSWERS = 4096;
const ORDERS = 3; // answer i is of order i % 3
const GROUP = 64;

const MAIN = `
@group(0) @binding(0) var<uniform> scarp_plan: array<ScarpPlan, ${PLANS}>;
@group(0) @binding(1) var<storage, read> points: array<f32>;
@group(0) @binding(2) var<storage, read_write> results: array<u32>;

fn put(i: u32, count: u32, s: ScarpSample) {
    results[i] = bitcast<u32>(s.value);
    results[count + i] = bitcast<u32>(s.gradient.x);
    results[2 * count + i] = bitcast<u32>(s.gradient.y);
    results[3 * count + i] = bitcast<u32>(s.gradient.z);
    results[4 * count + i] = bitcast<u32>(s.diagonal.x);
    results[5 * count + i] = bitcast<u32>(s.mixed.x);
    results[6 * count + i] = bitcast<u32>(s.mixed.y);
    results[7 * count + i] = bitcast<u32>(s.diagonal.y);
    results[8 * count + i] = bitcast<u32>(s.mixed.z);
    results[9 * count + i] = bitcast<u32>(s.diagonal.z);
}

@compute @workgroup_size(${GROUP})
fn samples2(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    let count = arrayLength(&points) / 3;
    if (i < count) {
        put(i, count, scarp_sample2(1u, points[i], points[count + i]));
    }
}

@compute @workgroup_size(${GROUP})
fn samples3(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    let count = arrayLength(&points) / 3;
    if (i < count) {
        put(i, count, scarp_sample3(1u, points[i], points[count + i], points[2 * count + i]));
    }
}

@compute @workgroup_size(${GROUP})
fn answers2(@builtin(global_invocation_id) id: vec3u) {
    results[id.x] = scarp_answer2(1u, id.x % ${ORDERS}, id.x);
}

@compute @workgroup_size(${GROUP})
fn answers3(@builtin(global_invocation_id) id: vec3u) {
    results[id.x] = scarp_answer3(1u, id.x % ${ORDERS}, id.x);
}
`;

class Webgpu {
    constructor(gpu, name, count) {
        const make = (size, usage) => gpu.createBuffer({size, usage});
        const {UNIFORM, STORAGE, COPY_DST, COPY_SRC, MAP_READ} = GPUBufferUsage;
        const size = 4 * Math.max(OUTPUTS * count, ANSWERS);
        this.gpu = gpu;
        this.name = name;
        this.count = count;
        this.plans = make(PLANS * PLAN_BYTES, UNIFORM | COPY_DST);
        this.points = make(3 * 4 * count, STORAGE | COPY_DST);
        this.results = make(size, STORAGE | COPY_SRC);
        this.readable = make(size, MAP_READ | COPY_DST);
        this.pipelines = {};
    }

    async compile(module, dimensions, constants) {
        const begin = performance.now();
        for (const n of dimensions) {
            for (const entryPoint of [`samples${n}`, `answers${n}`]) {
                this.pipelines[entryPoint] = await this.gpu.createComputePipelineAsync({
                    layout: "auto",
                    compute: {module, entryPoint, constants}
                });
            }
        }
        this.seconds = (performance.now() - begin) / 1000;
    }

    // Words of the results of a shader with this plan, and how long they took.
    async run(entryPoint, plan, buffers, threads, size) {
        const pipeline = this.pipelines[entryPoint];
        const entries = Object.entries(buffers).map(
            ([binding, buffer]) => ({binding: Number(binding), resource: {buffer}}));
        const group = this.gpu.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries});
        this.gpu.queue.writeBuffer(this.plans, PLAN_BYTES, plan);
        const begin = performance.now();
        const encoder = this.gpu.createCommandEncoder();
        const pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        pass.dispatchWorkgroups(Math.ceil(threads / GROUP));
        pass.end();
        encoder.copyBufferToBuffer(this.results, 0, this.readable, 0, 4 * size);
        this.gpu.queue.submit([encoder.finish()]);
        await this.readable.mapAsync(GPUMapMode.READ, 0, 4 * size);
        const seconds = (performance.now() - begin) / 1000;
        const words = new Uint32Array(this.readable.getMappedRange(0, 4 * size).slice(0));
        this.readable.unmap();
        return {words, seconds};
    }

    // `points`: x, then y, then z of `count` points
    sample(plan, dimensions, points) {
        this.gpu.queue.writeBuffer(this.points, 0, points);
        return this.run(`samples${dimensions}`, plan,
                        {0: this.plans, 1: this.points, 2: this.results}, this.count,
                        OUTPUTS * this.count);
    }

    answers(plan, dimensions) {
        return this.run(`answers${dimensions}`, plan, {0: this.plans, 2: this.results},
                        ANSWERS, ANSWERS);
    }
}

// Compiles the sample of src/gpu/README.md, whose pipeline fixes what it can: that is fast.
async function compileExample(gpu, source) {
    const example = await (await get("/cases/example.wgsl")).text();
    await gpu.createComputePipelineAsync({
        layout: "auto",
        compute: {module: gpu.createShaderModule({code: source + example}), entryPoint: "main",
                  constants: {scarp_only_basis: 0, scarp_only_fractal: 0, scarp_only_depth: 0}}
    });
}

// Returns {missing}, why there is no WebGPU; or {errors} of the compiler; with {device} if none.
export async function openWebgpu(count, {dimensions = [2, 3], barrier = true, only = {}},
                                 edit = source => source) {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) {
        return {missing: "skipped: this browser has no WebGPU adapter"};
    }
    const gpu = await adapter.requestDevice(), errors = [];
    const {vendor, architecture, description} = adapter.info;
    const name = `WebGPU on ${[vendor, architecture, description].filter(Boolean).join(" ")}`;
    gpu.addEventListener("uncapturederror", event => {
        throw new Error(event.error.message);
    });
    gpu.lost.then(({message}) => {
        throw new Error(`the device is lost: ${message}`);
    });
    const file = await (await get("/shaders/scarp.wgsl")).text();
    const source = barrier ? file : file.replaceAll(" ^ scarp_zero()", "");
    const code = edit(source + MAIN);
    gpu.pushErrorScope("validation");
    const module = gpu.createShaderModule({code});
    for (const {type, lineNum, linePos, message} of (await module.getCompilationInfo()).messages) {
        if (type === "error") {
            errors.push(`scarp.wgsl:${lineNum}:${linePos}: ${message}`);
        }
    }
    await gpu.popErrorScope();
    if (errors.length > 0) {
        return {errors};
    }
    const device = new Webgpu(gpu, name + (barrier ? "" : ", without the barrier"), count);
    const constants = {};
    for (const [name, number] of Object.entries(only)) {
        constants[`scarp_only_${name}`] = number;
    }
    await device.compile(module, dimensions, constants);
    await compileExample(gpu, source);
    return {device, errors};
}
