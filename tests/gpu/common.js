// SPDX-License-Identifier: MIT
//
// Files from browser.py, and shaders of WebGL 2 whose results are integers, in some targets.
export const WIDTH = 256; // of textures and targets

const VERTEX = `#version 300 es
void main() { // one triangle that covers everything
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

export async function get(name) {
    const response = await fetch(name);
    if (!response.ok) {
        throw new Error(`there is no ${name}`);
    }
    return response;
}

// The program of a fragment shader whose plans are in a block of that name. What the compiler says
// against it is thrown.
export function link(gl, fragment, block) {
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
        gl.deleteShader(shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        const said = gl.getAttachedShaders(program).map(shader => gl.getShaderInfoLog(shader));
        throw new Error(`${said.join("")} ${gl.getProgramInfoLog(program)}`);
    }
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, block), 0);
    return program;
}

function makeTexture(gl, height, texels) {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, WIDTH, height, 0, gl.RGBA_INTEGER,
        gl.UNSIGNED_INT, texels);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return texture;
}

// x, then y, then z of `count` points as a texture has them
export function texelsOf(points, count) {
    const texels = new Uint32Array(4 * count);
    for (let i = 0; i < points.length; i++) {
        texels[4 * (i % count) + Math.floor(i / count)] = points[i];
    }
    return texels;
}

// Draws so many targets of this height; returns their words, a list for each, and how long it took.
export function draw(gl, program, targets, height, texels) {
    const framebuffer = gl.createFramebuffer(), attachments = [], textures = [];
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    for (let i = 0; i < targets; i++) {
        attachments.push(gl.COLOR_ATTACHMENT0 + i);
        textures.push(makeTexture(gl, height, null));
        gl.framebufferTexture2D(gl.FRAMEBUFFER, attachments[i], gl.TEXTURE_2D, textures[i], 0);
    }
    gl.drawBuffers(attachments);
    gl.viewport(0, 0, WIDTH, height);
    textures.push(makeTexture(gl, height, texels));
    gl.useProgram(program);
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
    const seconds = (performance.now() - begin) / 1000;
    textures.forEach(texture => gl.deleteTexture(texture));
    gl.deleteFramebuffer(framebuffer);
    return {results, seconds};
}
