// SPDX-License-Identifier: MIT
//
// The workers of the map. They share a frame by bands of rows; while one is made, only the latest
// wish is kept, so dragging never queues up.

const WORKERS_MAX = 8;

export class Pool {
    // onFrame gets each frame {raster, values, pixels, numbers, ms, job}, onError a text.
    constructor(onFrame, onError) {
        const count = Math.max(1, Math.min(navigator.hardwareConcurrency || 2, WORKERS_MAX));
        this.onFrame = onFrame;
        this.onError = onError;
        this.next = null;
        this.frame = null;
        this.id = 0;
        this.workers = Array.from({length: count}, () => {
            const worker = new Worker(new URL("./worker.js", import.meta.url), {type: "module"});
            worker.onmessage = ({data}) => this.receive(data);
            worker.onerror = event => this.onError(event.message || "a worker did not start");
            return worker;
        });
    }

    get isBusy() {
        return this.frame !== null;
    }

    // Asks for a frame, in place of any that has not begun.
    request(job) {
        this.next = job;
        if (this.frame === null) {
            this.start();
        }
    }

    start() {
        const job = this.next, {width, height} = job.raster;
        this.next = null;
        this.id++;
        const bands = Math.min(this.workers.length, height);
        this.frame = {job, left: bands, begin: performance.now(),
            values: new Float32Array(width * height), pixels: new Uint32Array(width * height)};
        for (let i = 0; i < bands; i++) {
            const from = Math.floor(i * height / bands), to = Math.floor((i + 1) * height / bands);
            this.workers[i].postMessage({...job, id: this.id, from, to});
        }
    }

    receive({id, error, from, values, pixels, numbers}) {
        const {frame} = this;
        if (id !== this.id || frame === null) {
            return;
        }
        if (error) {
            this.frame = null;
            this.onError(error);
        } else {
            const first = from * frame.job.raster.width;
            frame.values.set(values, first);
            frame.pixels.set(pixels, first);
            if (--frame.left > 0) {
                return;
            }
            this.frame = null;
            const ms = performance.now() - frame.begin;
            this.onFrame({...frame, raster: frame.job.raster, numbers, ms});
        }
        if (this.next !== null && this.frame === null) {
            this.start();
        }
    }
}
