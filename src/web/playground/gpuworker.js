// SPDX-License-Identifier: MIT
//
// A worker: samples terrains by WebGPU. The first message is the module, each other one a frame. Of
// each recipe it makes a shader, which is compiled again only if its text is another one, and asks
// that for the answers that the module gives. It tells its state: "compiling", "asking", "on" with
// the name of the adapter, or "off" with why.
import {loadTerrain} from "./terrain.js";

const REST_MS = 200; // without another shader, before one is compiled
const KEPT = 8; // shaders
const GROUP = 8; // threads along a side
const MEMBERS = {value: "value", dx: "gradient.x", dy: "gradient.y", dxx: "diagonal.x",
    dxy: "mixed.x", dyy: "diagonal.y"};
const membersOf = order => Object.keys(MEMBERS).slice(0, [1, 3, 6][order]);

const rest = ms => new Promise(done => {
    setTimeout(done, ms);
});

// A message that is a sentence for people
class Refusal extends Error {}

const entryPoints = order => `
@group(0) @binding(0) var<uniform> scarp_plan: ScarpRecipePlan;
struct PageRaster { width: u32, rows: u32, at: array<f32> }
@group(0) @binding(1) var<storage, read> page_raster: PageRaster;
@group(0) @binding(2) var<storage, read_write> page_results: array<u32>;

@compute @workgroup_size(${GROUP}, ${GROUP})
fn page_heights(@builtin(global_invocation_id) id: vec3u) {
    let width = page_raster.width;
    let rows = page_raster.rows;
    if (id.x >= width || id.y >= rows) {
        return;
    }
    let s = scarp_recipe(page_raster.at[id.x], page_raster.at[width + id.y]).out0;
    let i = id.y * width + id.x;
    let count = width * rows;
${membersOf(order).map((name, m) =>
        `    page_results[${m}u * count + i] = bitcast<u32>(s.${MEMBERS[name]});`).join("\n")}
}

@compute @workgroup_size(${GROUP * GROUP})
fn page_answers(@builtin(global_invocation_id) id: vec3u) {
    page_results[id.x] = scarp_answer_recipe(id.x);
}`;

let file = "", terrain = null, device = null, layout = null, adapterName = "";
let wish = null; // the plan of the last frame
let lost = null; // why there is no device any more
let newest = -1; // the number of the last frame
let told = "";
const kept = new Map(); // by the text of a shader: {heights}, its pipeline, or {why}

function tell(state) {
    const text = JSON.stringify(state);
    if (text !== told) {
        told = text;
        postMessage({state});
    }
}

// What came of a plan; undefined while nothing did
const madeOf = plan => lost ?? (plan.why ? plan : kept.get(plan.shader));
const tellOf = ({why}) => tell(why ? {name: "off", why} : {name: "on", adapter: adapterName});

async function open(module) {
    if (!navigator.gpu) {
        throw new Refusal("this browser has no WebGPU for this page");
    }
    const adapter = await navigator.gpu.requestAdapter({powerPreference: "high-performance"});
    if (!adapter) {
        throw new Refusal("this browser finds no GPU for WebGPU");
    }
    const response = await fetch(new URL("./scarp.wgsl", import.meta.url));
    if (!response.ok) {
        throw new Refusal(`scarp.wgsl: ${response.status}`);
    }
    [file, terrain, device] = await Promise.all([response.text(), loadTerrain(module),
        adapter.requestDevice()]);
    const {vendor, architecture, description} = adapter.info ?? {};
    adapterName = description || [vendor, architecture].filter(Boolean).join(" ") || "WebGPU";
    layout = device.createBindGroupLayout({entries: ["uniform", "read-only-storage", "storage"]
        .map((type, binding) => ({binding, visibility: GPUShaderStage.COMPUTE, buffer: {type}}))});
    device.lost.then(({message}) => {
        lost = {why: `the GPU was lost: ${message}`};
        tellOf(lost);
    });
}

function fail(error) {
    const [first] = String(error.message).split("\n");
    tell({name: "off", why: error instanceof Refusal ? first : `the GPU failed: ${first}`});
}

function withRecipe({text, seed}, use) {
    const recipe = terrain.scarp.recipe(text);
    try {
        recipe.seed = seed;
        return use(recipe);
    } finally {
        recipe.free();
    }
}

// What the GPU needs for a frame: {key, source, order, edge, shader, uniforms}, or {key, why} if it
// is none for the GPU. The edge is how many rows above and below each band are sampled, for differences.
function planOf({source, isCurved}) {
    const key = `${isCurved} ${source.seed} ${source.text}`;
    return key === wish?.key ? wish : withRecipe(source, recipe => {
        const height = recipe.entries.find(({output}) => output === 0);
        if (!height || height.order === 0 || recipe.isSpace) {
            return {key, why: recipe.isSpace ? "the GPU shows only recipes of the plane"
                : height ? "this terrain has no gradient" : "this recipe has no output"};
        }
        const order = isCurved ? Math.min(height.order, 2) : 1;
        return {key, source, order, edge: isCurved && order < 2 ? 1 : 0,
            shader: recipe.shader("wgsl", file, {order}), uniforms: recipe.uniforms()};
    });
}

function bufferOf(size, usage, ...parts) {
    const buffer = device.createBuffer({size, usage: usage | GPUBufferUsage.COPY_DST});
    let at = 0;
    for (const part of parts) {
        device.queue.writeBuffer(buffer, at, part);
        at += part.byteLength;
    }
    return buffer;
}

// Runs a pipeline. Returns a function that waits for the words of the results.
function run(pipeline, {uniforms}, places, groups, words) {
    const {UNIFORM, STORAGE, COPY_SRC, MAP_READ} = GPUBufferUsage, size = 4 * words;
    const buffers = [bufferOf(uniforms.byteLength, UNIFORM, uniforms),
        bufferOf(places.reduce((sum, part) => sum + part.byteLength, 0), STORAGE, ...places),
        bufferOf(size, STORAGE | COPY_SRC)];
    const readable = bufferOf(size, MAP_READ), encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({layout, entries: buffers.map((buffer, binding) =>
        ({binding, resource: {buffer}}))}));
    pass.dispatchWorkgroups(...groups);
    pass.end();
    encoder.copyBufferToBuffer(buffers[2], 0, readable, 0, size);
    device.queue.submit([encoder.finish()]);
    const mapped = readable.mapAsync(GPUMapMode.READ);
    return async () => {
        await mapped;
        const result = readable.getMappedRange().slice(0);
        [...buffers, readable].forEach(buffer => buffer.destroy());
        return result;
    };
}

async function compile(plan) {
    device.pushErrorScope("validation");
    const module = device.createShaderModule({code: plan.shader + entryPoints(plan.order)});
    const wrong = await device.popErrorScope();
    if (wrong) {
        throw new Refusal(`it does not take the shader: ${wrong.message}`);
    }
    const ofPipelines = device.createPipelineLayout({bindGroupLayouts: [layout]});
    const [heights, answers] = await Promise.all(["page_heights", "page_answers"].map(entryPoint =>
        device.createComputePipelineAsync({layout: ofPipelines, compute: {module, entryPoint}})));
    if (wish.shader === plan.shader) {
        tell({name: "asking"});
    }
    const expected = withRecipe(plan.source, recipe => recipe.answers(plan.order));
    const found = new Uint32Array(await run(answers, plan, [new Uint32Array(3)],
        [expected.length / GROUP ** 2], expected.length)());
    const differing = expected.filter((answer, i) => answer !== found[i]).length;
    return differing === 0 ? {heights} : {why: "the GPU computes other numbers: " +
        `${differing} of ${expected.length} answers are wrong`};
}

// Compiles shaders, one after the other, until there is that of the last wish.
let isCompiling = false;
async function pursue() {
    if (isCompiling) {
        return;
    }
    isCompiling = true;
    while (!madeOf(wish)) {
        const plan = wish;
        tell({name: "compiling"});
        await rest(REST_MS);
        if (wish.shader === plan.shader) {
            kept.set(plan.shader, await compile(plan).catch(error => ({why: error.message})));
        }
    }
    isCompiling = false;
    tellOf(madeOf(wish));
    while (kept.size > KEPT) {
        kept.delete([...kept.keys()].find(shader => shader !== wish.shader));
    }
}

// Samples bands of rows, so many at once that the GPU works while one is read. Places are rounded
// to floats once.
async function sample({id, raster: {width, height, origin, step}, bands}, plan, pipeline) {
    const names = membersOf(plan.order);
    const xs = Float32Array.from({length: width}, (_, i) => origin[0] + i * step);
    const work = ({from, to}) => {
        const rows = to - from + 2 * plan.edge, count = width * rows;
        const ys = Float32Array.from({length: rows}, (_, i) =>
            origin[1] + (height - 1 - (from - plan.edge + i)) * step);
        const wait = run(pipeline, plan, [Uint32Array.of(width, rows), xs, ys],
            [width, rows].map(n => Math.ceil(n / GROUP)), names.length * count);
        return async band => {
            const buffer = await wait();
            const arrays = Object.fromEntries(names.map((name, m) =>
                [name, new Float32Array(buffer, 4 * m * count, count)]));
            postMessage({id, band, samples: {edge: plan.edge, arrays}}, [buffer]);
        };
    };
    let last = null;
    for (const [i, band] of bands.entries()) {
        if (newest !== id) {
            break;
        }
        const next = work(band);
        await last?.(i - 1);
        last = next;
    }
    await last?.(bands.length - 1);
}

async function take(job) {
    newest = job.id;
    const plan = wish = planOf(job), made = madeOf(plan);
    if (job.bands) {
        if (made?.heights) {
            await sample(job, plan, made.heights);
        } else {
            postMessage({id: job.id, band: null});
        }
    }
    if (wish !== plan) {
        return; // a newer frame tells how things stand
    }
    if (made) {
        tellOf(made);
    } else {
        await pursue();
    }
}

let early = null; // the last frame that was asked for too early
onmessage = async ({data}) => {
    try {
        if (data instanceof WebAssembly.Module) {
            await open(data);
            if (early !== null) {
                await take(early);
            }
        } else if (layout === null) {
            early = data;
        } else {
            await take(data);
        }
    } catch (error) {
        fail(error);
    }
};
