// SPDX-License-Identifier: MIT
//
// Samples of the terrain by WebGPU, where its answers agree with the module's. All of it happens in
// a worker; until that is ready, and wherever it cannot help, the module samples. It serves the first
// output of a recipe of the plane: statements, parts, small pictures and masks stay the module's.
// Workers of the page paint its samples as they paint the module's, sea included.
//
// Places are floats here and doubles in the program, so the picture may differ in last places. The
// page then has the module sample the same raster once more, for the hash, the numbers under the
// pointer and all files but the picture. A GPU in software, as tests have, is slower than the module.
const FAR = 2 ** 18; // samples from the origin, where floats are off by a 64th of the step

const seconds = since => Math.floor((performance.now() - since) / 1000);
const timeText = ms => ms === undefined ? ""
    : ` in ${ms < 100 ? ms.toFixed(1) : Math.round(ms)} ms`;

export class Gpu {
    // show(text) gets the state in words, say(text) what of that is news; ready() is called when
    // the GPU can take a frame.
    constructor(module, {show, say, ready}) {
        Object.assign(this, {showText: show, say, ready});
        this.state = {name: "loading", since: performance.now()};
        this.ms = {}; // what frames take
        this.frame = null; // {id, give} of the one that is being made
        this.worker = new Worker(new URL("./gpuworker.js", import.meta.url), {type: "module"});
        this.worker.postMessage(module);
        this.worker.onmessage = ({data}) => this.receive(data);
        this.worker.onerror = event => this.receive({state: {name: "off",
            why: event.message || "its worker did not start"}});
        this.timer = setInterval(() => this.show(), 200);
        this.show();
    }

    close() {
        clearInterval(this.timer);
        this.worker.terminate();
        this.drop();
        this.showText("");
    }

    // Why the module makes this frame, whatever the GPU can; null if the GPU may
    refusal({node, raster: {width, height, origin, step}}) {
        const far = Math.max(...[width, height].flatMap((count, axis) =>
            [Math.abs(origin[axis]), Math.abs(origin[axis] + (count - 1) * step)]));
        return node ? "the GPU shows the terrain only" : far > FAR * step
            ? "floats, which the GPU has for places, are too coarse so far from the origin" : null;
    }

    // Asks for a frame: true if it is taken. Then give(band, samples) is called for each band,
    // or give(null) if there will be none. The GPU is told of frames that it cannot make yet, too:
    // their recipes are what it gets ready for.
    sample(id, job, bands, give) {
        this.refused = this.refusal(job);
        if (this.refused === null) {
            const isTaken = this.state.name === "on";
            const {source, raster, view} = job;
            this.frame = isTaken ? {id, give} : null;
            this.worker.postMessage({id, source, raster, isCurved: view === "curvature",
                bands: isTaken ? bands : null});
        }
        this.show();
        return this.refused === null && this.frame !== null;
    }

    // Learns how long frames take: the GPU's, and the module's of the same raster.
    note({isGpu, job, ms}) {
        if (isGpu || job.isExact) {
            this.ms = isGpu ? {gpu: ms} : {...this.ms, wasm: ms};
            this.show();
        }
    }

    receive({id, state, band, samples}) {
        if (state) {
            const isNew = state.name !== this.state.name;
            this.state = {...state, since: isNew ? performance.now() : this.state.since};
            this.show();
            if (isNew && (state.name === "off" || (state.name === "on" && !this.hasDrawn))) {
                this.say(this.text());
            }
            if (state.name === "on" && isNew) {
                this.hasDrawn = true;
                this.ready();
            } else if (state.name === "off") {
                this.drop();
            }
        } else if (id === this.frame?.id) {
            this.frame.give(band, samples);
        }
    }

    // Gives back the frame that was taken, if there is one.
    drop() {
        const {frame} = this;
        this.frame = null;
        frame?.give(null);
    }

    show() {
        const text = this.text();
        if (text !== this.shown) {
            this.shown = text;
            this.showText(text);
        }
    }

    text() {
        const {name, since, why, adapter} = this.state, {gpu, wasm} = this.ms;
        if (this.refused && name !== "off") {
            return `wasm draws this: ${this.refused}`;
        }
        switch (name) {
        case "loading": return "looking for the GPU …";
        case "compiling": return `compiling for the GPU … ${seconds(since)} s`;
        case "asking": return "asking the GPU …";
        case "off": return `wasm goes on: ${why}`;
        default: return `picture by the GPU (${adapter})${timeText(gpu)}; ` +
            `hash and files by wasm${timeText(wasm)}`;
        }
    }
}
