// SPDX-License-Identifier: MIT
//
// The terrain in space, by WebGL 2: the heights of the map as a surface with its pixels on it, and
// a camera that flies.

const GRID_MAX = 512; // vertices along a side; more samples than that are skipped
const VERTEX = `#version 300 es
precision highp float;
uniform highp sampler2D heights;
uniform mat4 camera;
uniform vec3 scale; // of sample numbers and values
uniform float middle; // the value at the height 0 of space
uniform ivec2 size;
uniform int across, every;
uniform vec3 eye;
out vec2 place;
out float distance_to;
void main() {
    ivec2 at = min(ivec2(gl_VertexID % across, gl_VertexID / across) * every, size - 1);
    float height = texelFetch(heights, at, 0).r - middle;
    vec3 p = vec3(vec2(at) - 0.5 * vec2(size - 1), height) * scale * vec3(1.0, -1.0, 1.0);
    place = (vec2(at) + 0.5) / vec2(size);
    distance_to = length(p - eye);
    gl_Position = camera * vec4(p, 1.0);
}`;
const FRAGMENT = `#version 300 es
precision highp float;
uniform sampler2D colours;
uniform vec3 sky;
in vec2 place;
in float distance_to;
out vec4 colour;
void main() {
    float haze = 1.0 - exp(-0.12 * distance_to * distance_to);
    colour = vec4(mix(texture(colours, place).rgb, sky, 0.75 * haze), 1.0);
}`;

function shader(gl, type, source) {
    const made = gl.createShader(type);
    gl.shaderSource(made, source);
    gl.compileShader(made);
    return made;
}

function programOf(gl) {
    const program = gl.createProgram();
    gl.attachShader(program, shader(gl, gl.VERTEX_SHADER, VERTEX));
    gl.attachShader(program, shader(gl, gl.FRAGMENT_SHADER, FRAGMENT));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        throw new Error(gl.getProgramInfoLog(program));
    }
    return program;
}

// A strip of triangles for each pair of rows
function indicesOf(across, down) {
    const indices = new Uint32Array((down - 1) * (2 * across + 1));
    let n = 0;
    for (let row = 0; row + 1 < down; row++) {
        for (let column = 0; column < across; column++) {
            indices[n++] = row * across + column;
            indices[n++] = (row + 1) * across + column;
        }
        indices[n++] = 0xffffffff; // the strip ends
    }
    return indices;
}

// The mean of some thousand values
function meanOf(values) {
    const every = Math.ceil(values.length / 4096);
    let sum = 0, count = 0;
    for (let i = 0; i < values.length; i += every) {
        sum += values[i];
        count++;
    }
    return sum / count;
}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scaled = (a, s) => a.map(x => x * s);
const sum = (a, b) => a.map((x, i) => x + b[i]);
const unit = a => scaled(a, 1 / Math.hypot(...a));

export class View3d {
    // moved() is called when the camera has come to rest.
    constructor(canvas, moved) {
        this.canvas = canvas;
        this.moved = moved;
        this.gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
        this.keys = new Set();
        this.fingers = new Map();
        this.frame = null;
        this.pose = {eye: [0, -0.85, 0.5], yaw: 0, pitch: -0.6};
        if (this.gl !== null) {
            this.prepare();
            this.listen();
        }
    }

    get isThere() {
        return this.gl !== null;
    }

    prepare() {
        const {gl} = this;
        this.program = programOf(gl);
        this.place = name => gl.getUniformLocation(this.program, name);
        this.heights = this.texture(gl.NEAREST);
        this.colours = this.texture(gl.LINEAR);
        this.indices = gl.createBuffer();
        gl.enable(gl.DEPTH_TEST);
        new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    texture(filter) {
        const {gl} = this, texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, filter],
            [gl.TEXTURE_MAG_FILTER, filter], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
            [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) {
            gl.texParameteri(gl.TEXTURE_2D, name, value);
        }
        return texture;
    }

    // Takes a frame of the pool.
    show(frame) {
        const {gl} = this, {width, height} = frame.raster;
        gl.bindTexture(gl.TEXTURE_2D, this.heights);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, width, height, 0, gl.RED, gl.FLOAT, frame.values);
        gl.bindTexture(gl.TEXTURE_2D, this.colours);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE,
            new Uint8Array(frame.pixels.buffer));
        const every = Math.ceil(Math.max(width, height) / GRID_MAX);
        const [across, down] = [width, height].map(n => Math.ceil((n - 1) / every) + 1);
        if (this.across !== across || this.down !== down) {
            Object.assign(this, {across, down});
            const indices = indicesOf(across, down);
            this.count = indices.length;
            gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
            gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
        }
        this.frame = {raster: frame.raster, scale: 1, every,
            middle: meanOf(frame.values)};
        this.draw();
    }

    axes() {
        const {yaw, pitch} = this.pose;
        const ahead = [Math.sin(yaw) * Math.cos(pitch), Math.cos(yaw) * Math.cos(pitch),
            Math.sin(pitch)];
        const right = unit(cross(ahead, [0, 0, 1]));
        return {ahead, right, up: cross(right, ahead)};
    }

    cameraMatrix() {
        const {ahead, right, up} = this.axes(), {eye} = this.pose, {canvas} = this;
        const near = 0.002, far = 20, focal = 1 / Math.tan(0.45);
        const aspect = canvas.width / canvas.height, wide = focal / Math.max(aspect, 0.01);
        const view = [right, up, scaled(ahead, -1)].map(axis => [...axis, -dot(axis, eye)]);
        const a = (far + near) / (near - far), b = 2 * far * near / (near - far);
        const rows = [scaled(view[0], aspect < 1 ? focal : wide),
            scaled(view[1], aspect < 1 ? focal * aspect : focal),
            [a * view[2][0], a * view[2][1], a * view[2][2], a * view[2][3] + b],
            scaled(view[2], -1)];
        return new Float32Array([0, 1, 2, 3].flatMap(c => rows.map(row => row[c])));
    }

    draw() {
        const {gl, canvas, frame} = this;
        if (frame === null || canvas.hidden) {
            return;
        }
        const dense = Math.min(devicePixelRatio, 2);
        const width = Math.round(canvas.clientWidth * dense);
        const height = Math.round(canvas.clientHeight * dense);
        if (canvas.width !== width || canvas.height !== height) {
            Object.assign(canvas, {width, height});
        }
        const isDark = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
        const theme = document.documentElement.dataset.theme ?? isDark;
        const sky = theme === "dark" ? [0.16, 0.2, 0.25] : [0.76, 0.83, 0.9];
        gl.viewport(0, 0, width, height);
        gl.clearColor(...sky, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        this.setUniforms(sky);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
        gl.drawElements(gl.TRIANGLE_STRIP, this.count, gl.UNSIGNED_INT, 0);
    }

    setUniforms(sky) {
        const {gl, place} = this, {raster, scale, every} = this.frame;
        const perSample = 1 / Math.max(raster.width, raster.height);
        gl.useProgram(this.program);
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, this.heights);
        gl.activeTexture(gl.TEXTURE1);
        gl.bindTexture(gl.TEXTURE_2D, this.colours);
        gl.activeTexture(gl.TEXTURE0);
        gl.uniform1i(place("heights"), 0);
        gl.uniform1i(place("colours"), 1);
        gl.uniform1i(place("across"), this.across);
        gl.uniform1i(place("every"), every);
        gl.uniform2i(place("size"), raster.width, raster.height);
        gl.uniform3f(place("scale"), perSample, perSample, scale * perSample / raster.step);
        gl.uniform1f(place("middle"), this.frame.middle);
        gl.uniform3f(place("sky"), ...sky);
        gl.uniform3f(place("eye"), ...this.pose.eye);
        gl.uniformMatrix4fv(place("camera"), false, this.cameraMatrix());
    }

    // Moves along the axes of the camera, by fractions of the terrain's width.
    fly(right, ahead, up) {
        const axes = this.axes(), {pose} = this;
        pose.eye = sum(sum(pose.eye, scaled(axes.right, right)),
            sum(scaled(axes.ahead, ahead), [0, 0, up]));
    }

    look(right, up) {
        this.pose.yaw += right;
        this.pose.pitch = Math.max(-1.5, Math.min(1.5, this.pose.pitch + up));
    }

    listen() {
        const {canvas} = this, moves = "wasdqe";
        addEventListener("keydown", event => {
            const key = event.key.toLowerCase(), typed = event.target.matches("input, textarea");
            if (canvas.hidden || typed || event.ctrlKey || event.metaKey || event.altKey ||
                key.length !== 1 || !moves.includes(key)) {
                return;
            }
            this.keys.add(key);
            this.start();
        });
        addEventListener("keyup", event => this.keys.delete(event.key.toLowerCase()));
        addEventListener("blur", () => this.keys.clear());
        canvas.addEventListener("pointerdown", event => {
            canvas.setPointerCapture(event.pointerId);
            this.fingers.set(event.pointerId, event);
        });
        canvas.addEventListener("pointermove", event => this.dragged(event));
        for (const name of ["pointerup", "pointercancel"]) {
            canvas.addEventListener(name, event => {
                this.fingers.delete(event.pointerId);
                this.moved();
            });
        }
        canvas.addEventListener("wheel", event => {
            event.preventDefault();
            this.fly(0, -Math.sign(event.deltaY) * 0.05, 0);
            this.draw();
            this.moved();
        }, {passive: false});
    }

    // One finger or the mouse looks around; with Shift or the right button, or two fingers, moves.
    dragged(event) {
        const before = this.fingers.get(event.pointerId);
        if (before === undefined) {
            return;
        }
        const size = this.canvas.clientHeight;
        const x = (event.clientX - before.clientX) / size;
        const y = (event.clientY - before.clientY) / size;
        if (this.fingers.size > 1) {
            const [a, b] = [...this.fingers.values()];
            const spread = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
            this.fingers.set(event.pointerId, event);
            const [c, d] = [...this.fingers.values()];
            const now = Math.hypot(c.clientX - d.clientX, c.clientY - d.clientY);
            this.fly(-x / 2, (now - spread) / size, y / 2);
        } else if (event.shiftKey || event.buttons === 2) {
            this.fly(-x, 0, y);
        } else {
            this.look(-1.5 * x, 1.5 * y);
        }
        this.fingers.set(event.pointerId, event);
        this.draw();
    }

    // Flies as long as keys are held.
    start() {
        if (this.flying) {
            return;
        }
        this.flying = true;
        let last = performance.now();
        const next = now => {
            const far = Math.min(now - last, 100) * 0.0004, {keys} = this;
            const axis = (plus, minus) => far * (keys.has(plus) - keys.has(minus));
            last = now;
            this.fly(axis("d", "a"), axis("w", "s"), axis("e", "q"));
            this.draw();
            this.flying = keys.size > 0 && !this.canvas.hidden;
            if (this.flying) {
                requestAnimationFrame(next);
            } else {
                this.moved();
            }
        };
        requestAnimationFrame(next);
    }
}

// The camera as text, for the URL, and back
export const poseText = ({eye, yaw, pitch}) =>
    [...eye, yaw, pitch].map(n => n.toFixed(3)).join(",");

export function poseOf(text) {
    const numbers = String(text).split(",").map(Number);
    const [x, y, z, yaw, pitch] = numbers;
    return numbers.length === 5 && numbers.every(n => Math.abs(n) < 1000)
        ? {eye: [x, y, z], yaw, pitch} : null;
}
