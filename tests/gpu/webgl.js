// SPDX-License-Identifier: MIT
//
// Runs scarp.glsl in fragment shaders of WebGL 2. Results are integers, in up to three targets.
import {get} from "./get.js";

const PLANS = 2; // the plan is the second, so that indices are tested, too
const PLAN_BYTES = 5376;
const OUTPUTS = 10;
const ANSWERS = 4096;
const ORDERS = 3; // answer i is of order i % 3
const TARGETS = 3;
const WIDTH = 256;

const VERTEX = `#version 300 es
void main() { // one triangle that covers everything
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

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

    texture(height, texels) {
        const gl = this.gl, texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, WIDTH, height, 0, gl.RGBA_INTEGER,
                      gl.UNSIGNED_INT, texels);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        return texture;
    }

    // Binds that many targets of this height.
    bindTargets(targets, height) {
        const gl = this.gl, attachments = [];
        gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
        for (let target = 0; target < targets; target++) {
            attachments.push(gl.COLOR_ATTACHMENT0 + target);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, attachments[target], gl.TEXTURE_2D,
                                    this.texture(height, null), 0);
        }
        gl.drawBuffers(attachments);
        gl.viewport(0, 0, WIDTH, height);
        return attachments;
    }

    // Adds a program; returns what the compiler says if it fails.
    link(name, fragment, targets) {
        const gl = this.gl, program = gl.createProgram(), begin = performance.now();
        for (const [type, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, fragment]]) {
            const shader = gl.createShader(type);
            gl.shaderSource(shader, source);
            gl.compileShader(shader);
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
                return [`scarp.glsl, ${name}: ${gl.getShaderInfoLog(shader).trim()}`];
            }
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
            return [`scarp.glsl, ${name}: ${gl.getProgramInfoLog(program)}`];
        }
        gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, "ScarpPlans"), 0);
        this.programs[name] = program;
        this.run(name, new Uint32Array(PLAN_BYTES / 4), null, targets, 1); // compiles at last
        this.seconds += (performance.now() - begin) / 1000;
        return [];
    }

    // The targets of a shader with this plan, a list of words each, and how long it took.
    run(name, plan, texels, targets, height) {
        const gl = this.gl, attachments = this.bindTargets(targets, height);
        this.texture(height, texels);
        gl.useProgram(this.programs[name]);
        gl.bufferSubData(gl.UNIFORM_BUFFER, PLAN_BYTES, plan);
        const begin = performance.now();
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const results = attachments.map(attachment => {
            const words = new Uint32Array(4 * WIDTH * height);
            gl.readBuffer(attachment);
            gl.readPixels(0, 0, WIDTH, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, words);
            return words;
        });
        const error = gl.getError();
        if (error !== gl.NO_ERROR) {
            throw new Error(`WebGL error 0x${error.toString(16)}`);
        }
        return {results, seconds: (performance.now() - begin) / 1000};
    }

    // `points`: x, then y, then z of `count` points
    async sample(plan, dimensions, points) {
        const texels = new Uint32Array(4 * this.count);
        for (let i = 0; i < points.length; i++) {
            texels[4 * (i % this.count) + Math.floor(i / this.count)] = points[i];
        }
        const {results, seconds} = this.run(`samples${dimensions}`, plan, texels, TARGETS,
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
