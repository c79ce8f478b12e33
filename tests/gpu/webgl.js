// SPDX-License-Identifier: MIT
//
// Runs scarp.glsl in fragment shaders of WebGL 2.
import {WIDTH, draw, get, link, texelsOf} from "./common.js";

const PLANS = 2; // the plan is the second, so that indices are tested, too
const PLAN_BYTES = 5376;
const OUTPUTS = 10;
const ANSWERS = 4096;
const ORDERS = 3; // answer i is of order i % 3
const TARGETS = 3;

const HEAD = `#version 300 es
#define SCARP_PLANS ${PLANS}
`;

const SAMPLES = n => `
uniform highp usampler2D points;
layout(location = 0) out uvec4 target0;
layout(location = 1) out uvec4 target1;
layout(location = 2) out uvec4 target2;
void main() {
    vec3 p = uintBitsToFloat(texelFetch(points, ivec2(gl_FragCoord.xy), 0).xyz);
    ScarpSample s = scarp_sample${n}(1u, ${n === 2 ? "p.x, p.y" : "p.x, p.y, p.z"});
    target0 = floatBitsToUint(vec4(s.value, s.gradient));
    target1 = floatBitsToUint(vec4(s.diagonal.x, s.mixed.xy, s.diagonal.y));
    target2 = floatBitsToUint(vec4(s.mixed.z, s.diagonal.z, 0.0, 0.0));
}`;

const ANSWER = n => `
layout(location = 0) out uvec4 target0;
void main() {
    uint i = uint(gl_FragCoord.y) * ${WIDTH}u + uint(gl_FragCoord.x);
    target0 = uvec4(scarp_answer${n}(1u, i % ${ORDERS}u, i), 0u, 0u, 0u);
}`;

class Webgl {
    constructor(gl, name, count) {
        this.gl = gl;
        this.name = name;
        this.count = count;
        this.programs = {};
        this.seconds = 0;
        gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, gl.createBuffer());
        gl.bufferData(gl.UNIFORM_BUFFER, PLANS * PLAN_BYTES, gl.DYNAMIC_DRAW);
    }

    // Adds a program; returns what the compiler says if it fails.
    link(name, fragment, targets) {
        const begin = performance.now();
        try {
            this.programs[name] = link(this.gl, fragment, "ScarpPlans");
        } catch (error) {
            return [`scarp.glsl, ${name}: ${error.message.trim()}`];
        }
        this.run(name, new Uint32Array(PLAN_BYTES / 4), null, targets, 1); // compiles at last
        this.seconds += (performance.now() - begin) / 1000;
        return [];
    }

    // The targets of a shader with this plan, a list of words each, and how long it took.
    run(name, plan, texels, targets, height) {
        this.gl.bufferSubData(this.gl.UNIFORM_BUFFER, PLAN_BYTES, plan);
        return draw(this.gl, this.programs[name], targets, height, texels);
    }

    // `points`: x, then y, then z of `count` points
    async sample(plan, dimensions, points) {
        const {results, seconds} = this.run(`samples${dimensions}`, plan,
                                            texelsOf(points, this.count), TARGETS,
                                            this.count / WIDTH);
        const words = new Uint32Array(OUTPUTS * this.count);
        for (let i = 0; i < words.length; i++) {
            const output = Math.floor(i / this.count);
            words[i] = results[output >> 2][4 * (i % this.count) + (output & 3)];
        }
        return {words, seconds};
    }

    async answers(plan, dimensions) {
        const {results, seconds} = this.run(`answers${dimensions}`, plan, null, 1,
                                            ANSWERS / WIDTH);
        return {words: results[0].filter((_, i) => i % 4 === 0), seconds};
    }
}

// Returns {missing}, why there is no WebGL 2; or {errors} of the compiler; with {device} if none.
export async function openWebgl(count, {dimensions = [2, 3], barrier = true, only = {}},
                                edit = source => source) {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) {
        return {missing: "skipped: this browser has no WebGL 2"};
    }
    const info = gl.getExtension("WEBGL_debug_renderer_info");
    const name = `WebGL 2 on ${gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)}`;
    const macros = Object.entries(only).map(
        ([name, number]) => `#define SCARP_ONLY_${name.toUpperCase()} ${number}u\n`);
    const head = [HEAD, barrier ? "" : "#define SCARP_FUSE\n", ...macros, "#line 1\n"];
    const source = head.join("") + edit(await (await get("/shaders/scarp.glsl")).text());
    const device = new Webgl(gl, name + (barrier ? "" : ", without the barrier"), count);
    const errors = [];
    for (const n of dimensions) {
        errors.push(...device.link(`samples${n}`, source + SAMPLES(n), TARGETS));
        errors.push(...device.link(`answers${n}`, source + ANSWER(n), 1));
    }
    return errors.length > 0 ? {errors} : {device, errors};
}
