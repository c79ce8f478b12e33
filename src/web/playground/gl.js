// SPDX-License-Identifier: MIT
//
// Programs, uniforms and textures of WebGL 2.

function shaderOf(gl, type, source) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    return shader;
}

// {program, places}: the places of its uniforms by name
export function programOf(gl, vertex, fragment) {
    const program = gl.createProgram();
    gl.attachShader(program, shaderOf(gl, gl.VERTEX_SHADER, vertex));
    gl.attachShader(program, shaderOf(gl, gl.FRAGMENT_SHADER, fragment));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        throw new Error(gl.getProgramInfoLog(program));
    }
    const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
    const names = Array.from({length: count}, (_, i) => gl.getActiveUniform(program, i).name);
    const places = new Map(names.map(name => [name, gl.getUniformLocation(program, name)]));
    return {program, places};
}

// Begins to use a program. Uniforms are {name: [call, ...arguments]}; it need not have all of them.
export function use(gl, {program, places}, uniforms) {
    gl.useProgram(program);
    for (const [name, [call, ...values]] of Object.entries(uniforms)) {
        if (places.has(name)) {
            gl[call](places.get(name), ...values);
        }
    }
}

// A texture that stays bound to a unit
export class Texture {
    constructor(gl, unit, {isSmooth}) {
        Object.assign(this, {gl, unit, isSmooth, texture: gl.createTexture()});
        const large = isSmooth ? gl.LINEAR : gl.NEAREST;
        const small = isSmooth ? gl.LINEAR_MIPMAP_NEAREST : gl.NEAREST;
        this.bind();
        for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, small], [gl.TEXTURE_MAG_FILTER, large],
            [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) {
            gl.texParameteri(gl.TEXTURE_2D, name, value);
        }
    }

    bind() {
        this.gl.activeTexture(this.gl.TEXTURE0 + this.unit);
        this.gl.bindTexture(this.gl.TEXTURE_2D, this.texture);
    }

    // `data` may be null: then something is drawn into it.
    fill([width, height], [inner, format, type], data) {
        const {gl} = this;
        this.bind();
        gl.texImage2D(gl.TEXTURE_2D, 0, inner, width, height, 0, format, type, data);
        if (data !== null) {
            this.reduce();
        }
    }

    // Makes the smaller pictures, for what is far.
    reduce() {
        if (this.isSmooth) {
            this.bind();
            this.gl.generateMipmap(this.gl.TEXTURE_2D);
        }
    }
}

// Pictures with several samples of each pixel, for smooth edges
export class Multisampled {
    constructor(gl) {
        this.gl = gl;
        this.target = gl.createFramebuffer();
        this.buffers = [gl.createRenderbuffer(), gl.createRenderbuffer()];
        this.size = [0, 0];
    }

    // What follows is drawn into it.
    begin(size, samples) {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
        if (this.size[0] === size[0] && this.size[1] === size[1]) {
            return;
        }
        this.size = size;
        for (const [i, [format, place]] of [[gl.RGBA8, gl.COLOR_ATTACHMENT0],
            [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]].entries()) {
            gl.bindRenderbuffer(gl.RENDERBUFFER, this.buffers[i]);
            gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, ...size);
            gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, this.buffers[i]);
        }
    }

    // Puts it on the canvas.
    end(size) {
        const {gl} = this;
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.target);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
        gl.blitFramebuffer(0, 0, ...size, 0, 0, ...size, gl.COLOR_BUFFER_BIT, gl.NEAREST);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }
}
