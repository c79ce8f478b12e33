// SPDX-License-Identifier: MIT
//
// Samples of noises by scarp.wgsl. Shaders take float coordinates, as scarp_sample2 does: workers
// compare every value with what that gives.
import {floatPlaces, gridOf, makeGround, withoutHessian} from "./ground.js";

const PLAN_BYTES = 5376;
const GROUP = 64;
const MAIN = `
@group(0) @binding(0) var<uniform> scarp_plan: array<ScarpPlan, 1>;
@group(0) @binding(1) var<storage, read> points: array<f32>;
@group(0) @binding(2) var<storage, read_write> results: array<f32>;
override second: bool = false;

@compute @workgroup_size(${GROUP})
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(num_workgroups) groups: vec3u) {
    let i = id.x + id.y * groups.x * ${GROUP}u;
    let count = arrayLength(&points) / 2u;
    if (i >= count) {
        return;
    }
    let s = scarp_sample2(0u, points[i], points[count + i]);
    results[i] = s.value;
    results[count + i] = s.gradient.x;
    results[2u * count + i] = s.gradient.y;
    if (second) {
        results[3u * count + i] = s.diagonal.x;
        results[4u * count + i] = s.mixed.x;
        results[5u * count + i] = s.diagonal.y;
    }
}
`;
const BASES = ["gradient", "value", "simplex", "cell-f1", "cell-f2", "cell-edge", "cell-soft",
    "cell-value"];
const FRACTALS = ["fbm", "turbulence", "ridged", "erosion", "pingpong", "hybrid", "swiss",
    "jordan"];
export const FIRST = ["value", "dx", "dy"];
export const ALL = [...FIRST, "dxx", "dxy", "dyy"];

// What all levels of a noise have in common makes its shader smaller.
function constantsOf(noise, second) {
    const constants = {scarp_only_depth: noise.warp ? 1 : 0, second: second ? 1 : 0};
    if (!noise.warp || noise.warp.basis === noise.basis) {
        constants.scarp_only_basis = BASES.indexOf(noise.basis);
    }
    if (!noise.warp || noise.warp.fractal === noise.fractal) {
        constants.scarp_only_fractal = FRACTALS.indexOf(noise.fractal);
    }
    return constants;
}

// A device that samples; null where the browser has none.
export async function openGpu(scarp) {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) {
        return null;
    }
    const {maxStorageBufferBindingSize, maxBufferSize} = adapter.limits;
    const device = await adapter.requestDevice({requiredLimits: {maxStorageBufferBindingSize,
        maxBufferSize}});
    const source = await (await fetch(new URL("./scarp.wgsl", import.meta.url))).text();
    return new Gpu(scarp, device, device.createShaderModule({code: source + MAIN}));
}

class Gpu {
    constructor(scarp, device, module) {
        Object.assign(this, {scarp, device, module});
        this.pipelines = new Map();
        this.buffers = new Map();
        this.plan = device.createBuffer({size: PLAN_BYTES,
            usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
    }

    pipeline(constants) {
        const key = JSON.stringify(constants);
        if (!this.pipelines.has(key)) {
            this.pipelines.set(key, this.device.createComputePipelineAsync({layout: "auto",
                compute: {module: this.module, entryPoint: "main", constants}}));
        }
        return this.pipelines.get(key);
    }

    buffer(name, size, usage) {
        let buffer = this.buffers.get(name);
        if (buffer?.size !== size) {
            buffer?.destroy();
            buffer = this.device.createBuffer({size, usage});
            this.buffers.set(name, buffer);
        }
        return buffer;
    }

    // Samples of one noise at points, by the names of their members
    async sampleNoise(noise, [x, y], names) {
        const {device} = this, count = x.length, bytes = 4 * count * names.length;
        const {STORAGE, COPY_DST, COPY_SRC, MAP_READ} = GPUBufferUsage;
        const pipeline = await this.pipeline(constantsOf(noise, names.length > FIRST.length));
        const points = this.buffer("points", 8 * count, STORAGE | COPY_DST);
        const results = this.buffer("results", bytes, STORAGE | COPY_SRC);
        const readable = this.buffer("readable", bytes, COPY_DST | MAP_READ);
        device.queue.writeBuffer(this.plan, 0, this.scarp.gpuPlan(noise, 2));
        device.queue.writeBuffer(points, 0, x);
        device.queue.writeBuffer(points, 4 * count, y);
        const entries = [this.plan, points, results].map((buffer, binding) =>
            ({binding, resource: {buffer}}));
        const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, device.createBindGroup({layout: pipeline.getBindGroupLayout(0),
            entries}));
        const groups = Math.ceil(count / GROUP), across = Math.min(groups, 32768);
        pass.dispatchWorkgroups(across, Math.ceil(groups / across));
        pass.end();
        encoder.copyBufferToBuffer(results, 0, readable, 0, bytes);
        device.queue.submit([encoder.finish()]);
        await readable.mapAsync(GPUMapMode.READ);
        const floats = new Float32Array(readable.getMappedRange().slice(0));
        readable.unmap();
        return Object.fromEntries(names.map((name, i) =>
            [name, floats.subarray(i * count, (i + 1) * count)]));
    }

    // Samples of all noises of a terrain, by their names
    async sample(terrain, view) {
        const ground = makeGround(this.scarp, terrain), {raster} = terrain;
        const places = floatPlaces(ground, gridOf(raster)), given = {};
        const names = view === "curvature" && withoutHessian(ground) === null ? ALL : FIRST;
        for (const name of ["noise", "mask", "base"]) {
            if (ground[name]) {
                const at = name === "noise" ? places.noise : places.plain;
                given[name] = await this.sampleNoise(ground[name], at, names);
            }
        }
        return given;
    }
}
