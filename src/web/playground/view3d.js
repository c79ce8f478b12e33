// SPDX-License-Identifier: MIT
//
// The terrain in space, by WebGL 2: a block whose surface has the pixels of the map, with shadows,
// under a sky, and a camera that flies.
import {Camera} from "./camera.js";
import {Flight} from "./flight.js";
import {Multisampled, Texture, programOf, use} from "./gl.js";
import {extentOf, meshOf, verticesOf} from "./mesh.js";
import {BLOCK, GROUND, HEAVEN, PICTURE, SUNLIT, SURFACE} from "./shaders.js";
import {sunOf, sunlight, thinned} from "./sunlight.js";

export {poseOf, poseText} from "./camera.js";

const GRID_MAX = 512; // vertices along a side; more samples than that are skipped
const LIT_MAX = 1024; // likewise of the lights
const MESHES_MAX = 8; // that are kept

// Frames have the first of these details that takes so few milliseconds, or the last one: one of
// `times` vertices along a side, and samples of a pixel at edges. `cost` is what that takes of the
// time of the first one, in a renderer in software.
const FINE = {times: 1, samples: 4, cost: 1};
const MOVING = {ms: 40, details: [FINE, {times: 1, samples: 0, cost: 0.4},
    {times: 2, samples: 0, cost: 0.2}, {times: 4, samples: 0, cost: 0.1}]};
const RESTING = {ms: 500, details: [FINE, {times: 2, samples: 4, cost: 0.35}]};

// What the pixels of a view have of the sun and the sky. Other views are measurements: no shadows.
const LIGHTS = {
    relief: {sun: [1.06, 1, 0.9], sky: [0.27, 0.3, 0.36], isMirror: true},
    hillshade: {sun: [1, 1, 1], sky: [0.22, 0.22, 0.22], isMirror: false},
};
const NOWHERE = 1e9; // the height of a sea that is not there

function isNight() {
    const {theme} = document.documentElement.dataset;
    return (theme ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "")) === "dark";
}

export class View3d {
    // moved() is called when the camera has come to rest.
    constructor(canvas, moved) {
        this.canvas = canvas;
        this.gl = canvas.getContext("webgl2", {antialias: false, preserveDrawingBuffer: true});
        this.camera = new Camera();
        this.scene = null; // what is shown of a frame
        this.meshes = new Map(); // by their numbers of vertices
        this.pace = 0; // milliseconds that a frame with all vertices takes
        this.fence = null; // that tells when a frame is there
        if (this.gl !== null) {
            this.prepare();
            this.flight = new Flight(canvas, this.camera, {
                moving: () => this.draw(MOVING),
                resting: () => {
                    this.draw();
                    moved();
                },
            });
        }
    }

    get isThere() {
        return this.gl !== null;
    }

    get pose() {
        return this.camera.pose;
    }

    get flying() {
        return this.flight.isFlying;
    }

    prepare() {
        const {gl} = this;
        this.programs = {
            sunlit: programOf(gl, PICTURE, SUNLIT), surface: programOf(gl, GROUND, SURFACE),
            block: programOf(gl, GROUND, BLOCK), heaven: programOf(gl, PICTURE, HEAVEN),
        };
        const names = ["heights", "colours", "lights", "sunlit"];
        this.textures = Object.fromEntries(names.map((name, i) =>
            [name, new Texture(gl, i, {isSmooth: name !== "heights"})]));
        this.target = gl.createFramebuffer();
        this.multisampled = new Multisampled(gl);
        gl.depthFunc(gl.LEQUAL); // the sky lies where depths end
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        new ResizeObserver(() => this.draw()).observe(this.canvas);
        new MutationObserver(() => this.draw()).observe(document.documentElement,
            {attributeFilter: ["data-theme"]});
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    }

    // Takes a frame of the pool.
    show(frame) {
        if (frame !== this.scene?.frame) {
            this.scene = this.sceneOf(frame);
            this.shine();
        }
        this.draw();
    }

    // Gives the frame to the GPU.
    sceneOf(frame) {
        const {gl, textures} = this, {raster, values, pixels, job, numbers} = frame;
        const size = [raster.width, raster.height], longest = Math.max(...size);
        const [every, litEvery] = [GRID_MAX, LIT_MAX].map(most => Math.ceil(longest / most));
        const [grid, lit] = [every, litEvery].map(n => size.map(side => verticesOf(side, n)));
        const sun = sunOf(job.azimuth, job.altitude), light = LIGHTS[job.view] ?? null;
        const {lowest, mean, highest} = extentOf(values), perUnit = 1 / (longest * raster.step);
        const lights = light && sunlight(thinned(values, raster, litEvery, lit), lit,
            raster.step * litEvery, sun, job.zFactor);
        textures.heights.fill(grid, [gl.R32F, gl.RED, gl.FLOAT],
            thinned(values, raster, every, grid));
        textures.colours.fill(size, [gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE],
            new Uint8Array(pixels.buffer));
        textures.lights.fill(lights ? lit : [1, 1], [gl.RG8, gl.RG, gl.UNSIGNED_BYTE],
            lights ?? Uint8Array.of(255, 0));
        return {frame, size, every, grid, sun, light, middle: mean, perUnit,
            base: (lowest - mean - 0.05 * (highest - lowest)) * perUnit - 0.05,
            sea: light?.isMirror && numbers.hasSea ? (numbers.floor - mean) * perUnit : NOWHERE};
    }

    // Draws the map with its shadows into a texture. They depend only on heights and sun, so they
    // stay while the camera moves.
    shine() {
        const {gl, textures, scene} = this, {sunlit} = textures, {sun, size, light} = scene;
        const warm = Math.max(0, 1 - sun[2] / 0.5) ** 2; // low suns are redder
        sunlit.fill(size, [gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE], null);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D,
            sunlit.texture, 0);
        gl.viewport(0, 0, ...size);
        gl.disable(gl.DEPTH_TEST);
        use(gl, this.programs.sunlit, {colours: ["uniform1i", textures.colours.unit],
            lights: ["uniform1i", textures.lights.unit],
            sunlight: ["uniform3fv", light?.sun ?? [0, 0, 0]],
            skylight: ["uniform3fv", light?.sky ?? [1, 1, 1]],
            tint: ["uniform3f", 1 + 0.25 * warm, 1 - 0.05 * warm, 1 - 0.3 * warm]});
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.enable(gl.DEPTH_TEST);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        sunlit.reduce();
    }

    // The triangles with one of `times` vertices along a side
    mesh(times) {
        const [across, down] = this.scene.grid.map(n => verticesOf(n, times));
        const key = `${across} ${down}`;
        if (!this.meshes.has(key)) {
            if (this.meshes.size === MESHES_MAX) {
                const [oldest, {buffer}] = this.meshes.entries().next().value;
                this.gl.deleteBuffer(buffer);
                this.meshes.delete(oldest);
            }
            this.meshes.set(key, meshOf(this.gl, across, down));
        }
        return this.meshes.get(key);
    }

    draw({ms, details} = RESTING) {
        const {gl, canvas, scene} = this;
        if (scene === null || canvas.hidden) {
            return;
        }
        const dense = Math.min(devicePixelRatio, 2);
        const size = [canvas.clientWidth, canvas.clientHeight].map(n =>
            Math.max(1, Math.round(n * dense)));
        if (canvas.width !== size[0] || canvas.height !== size[1]) {
            [canvas.width, canvas.height] = size;
        }
        const begin = performance.now();
        const detail = details.find(({cost}) => cost * this.pace <= ms) ?? details.at(-1);
        if (detail.samples > 0) {
            this.multisampled.begin(size, detail.samples);
            this.drawScene(size, detail.times);
            this.multisampled.end(size);
        } else {
            this.drawScene(size, detail.times);
        }
        this.measure(begin, detail.cost);
    }

    drawScene(size, times) {
        const {gl, programs} = this, mesh = this.mesh(times);
        const uniforms = this.uniforms(mesh, times, size[0] / size[1]);
        gl.viewport(0, 0, ...size);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.buffer);
        use(gl, programs.surface, uniforms);
        gl.drawElements(gl.TRIANGLE_STRIP, mesh.surface, gl.UNSIGNED_INT, 0);
        use(gl, programs.block, {...uniforms, is_mirror: ["uniform1i", 0]});
        gl.drawElements(gl.TRIANGLE_STRIP, mesh.block, gl.UNSIGNED_INT, 4 * mesh.surface);
        use(gl, programs.heaven, uniforms);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    uniforms(mesh, times, aspect) {
        const {size, every, grid, sun, middle, perUnit, base, sea} = this.scene, {textures} = this;
        const perSample = 1 / Math.max(...size);
        const low = Math.max(0, 1 - Math.max(sun[2] - 0.02, 0) / 0.48); // below 30 degrees
        return {heights: ["uniform1i", textures.heights.unit],
            sunlit: ["uniform1i", textures.sunlit.unit],
            camera: ["uniformMatrix4fv", false, this.camera.matrix(aspect)],
            rays: ["uniformMatrix3fv", false, this.camera.rays(aspect)],
            eye: ["uniform3fv", this.pose.eye], scale: ["uniform3f", perSample, perSample, perUnit],
            middle: ["uniform1f", middle], base: ["uniform1f", base], sea: ["uniform1f", sea],
            is_mirror: ["uniform1i", 1],
            size: ["uniform2iv", size], grid: ["uniform2iv", grid],
            mesh: ["uniform2i", mesh.across, mesh.down], times: ["uniform1i", times],
            every: ["uniform1i", every], sun: ["uniform3fv", sun],
            low: ["uniform1f", low * low * (3 - 2 * low)], night: ["uniform1f", Number(isNight())]};
    }

    // Learns how long frames take, without waiting for them: of one at a time.
    measure(begin, cost) {
        const {gl} = this;
        if (this.fence !== null) {
            return;
        }
        this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        gl.flush();
        const look = () => {
            if (gl.getSyncParameter(this.fence, gl.SYNC_STATUS) !== gl.SIGNALED) {
                setTimeout(look, 4);
                return;
            }
            gl.deleteSync(this.fence);
            this.fence = null;
            const ms = (performance.now() - begin) / cost;
            this.pace = this.pace === 0 ? ms : (this.pace + ms) / 2;
        };
        setTimeout(look, 4);
    }
}
