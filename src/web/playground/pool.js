// SPDX-License-Identifier: MIT
//
// The workers of the page. Those of the map share a frame by bands of rows. While one is made, only
// the latest wish is kept, so dragging never queues up; a frame that takes long makes room for it.
// One more worker makes small pictures, one after the other.

const WORKERS_MAX = 8;
const BAND_MOST = 2 ** 20; // samples at once of the GPU
const PATIENCE_MS = 150; // for a frame of no drag, when there is a newer wish

function makeWorker(module, onMessage, onError) {
    const worker = new Worker(new URL("./worker.js", import.meta.url), {type: "module"});
    worker.postMessage(module);
    worker.onmessage = ({data}) => onMessage(data);
    worker.onerror = event => onError(event.message || "a worker did not start");
    return worker;
}

export class Pool {
    // onFrame gets each frame {raster, values, pixels, numbers, met, ms, job, isGpu}; onError a
    // text, and why the recipe is no terrain, or null.
    constructor(module, onFrame, onError) {
        const count = Math.max(1, Math.min(navigator.hardwareConcurrency || 2, WORKERS_MAX));
        this.onFrame = onFrame;
        this.onError = onError;
        this.next = null;
        this.frame = null;
        this.gpu = null; // who may sample frames in place of the workers: see gpu.js
        this.id = 0;
        this.workers = Array.from({length: count}, () =>
            makeWorker(module, data => this.receive(data), onError));
    }

    get isBusy() {
        return this.frame !== null;
    }

    // Asks for a frame, in place of any that has not begun.
    request(job) {
        this.next = job;
        if (this.frame === null) {
            this.start();
        } else if (!this.frame.job.isDragging) {
            const {job: {isExact}, begin} = this.frame;
            clearTimeout(this.timer);
            this.timer = setTimeout(() => this.next && this.start(),
                isExact ? 0 : Math.max(0, PATIENCE_MS - (performance.now() - begin)));
        }
    }

    start() {
        const job = this.next;
        clearTimeout(this.timer);
        this.next = null;
        this.make(job, job.isExact ? null : this.gpu);
    }

    // Has the workers make a frame, of samples of the GPU if that takes it.
    make(job, gpu) {
        const {width, height} = job.raster, count = width * height, id = ++this.id;
        const bands = this.bandsOf(height, gpu === null ? 1 : Math.ceil(count / BAND_MOST));
        this.frame = {job, left: bands.length, begin: performance.now(), isGpu: false,
            met: [Infinity, -Infinity], values: new Float32Array(count),
            pixels: new Uint32Array(count)};
        const post = (i, samples) => this.workers[i % this.workers.length].postMessage(
            {...job, id, ...bands[i], samples}, samples ? [samples.arrays.value.buffer] : []);
        const isTaken = gpu?.sample(id, job, bands, (band, samples) => {
            if (id !== this.id || this.frame === null) {
                return; // there is a newer one
            }
            if (band === null) {
                this.make(job, null);
            } else {
                this.frame.isGpu = true;
                post(band, samples);
            }
        });
        if (!isTaken) {
            bands.forEach((_, i) => post(i, null));
        }
    }

    // Rows for each worker, or more bands than there are workers
    bandsOf(height, least) {
        const count = Math.min(Math.max(this.workers.length, least), height);
        return Array.from({length: count}, (_, i) => ({from: Math.floor(i * height / count),
            to: Math.floor((i + 1) * height / count)}));
    }

    receive({id, error, problem, from, values, pixels, numbers, met}) {
        const {frame} = this;
        if (id !== this.id || frame === null) {
            return;
        }
        if (error) {
            this.frame = null;
            this.onError(error, problem, frame.job);
        } else {
            const first = from * frame.job.raster.width;
            frame.values.set(values, first);
            frame.pixels.set(pixels, first);
            frame.met = [Math.min(frame.met[0], met[0]), Math.max(frame.met[1], met[1])];
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

const KEPT = 500; // pictures

// Small pictures of nodes, and what else is made apart from the map
export class Pictures {
    constructor(module) {
        this.wishes = [];
        this.running = null;
        this.id = 0;
        this.kept = new Map();
        this.worker = makeWorker(module, data => this.receive(data), message =>
            this.receive({id: this.id, error: message}));
    }

    // Makes a job in one piece: done({values, pixels, masks, numbers, met}) or done({error}).
    // Returns what takes the wish back. Answers to the same key are kept; null: not to be kept.
    make(job, key, done) {
        if (key !== null && this.kept.has(key)) {
            const answer = this.kept.get(key);
            this.kept.delete(key);
            this.kept.set(key, answer); // the one that was used last
            done(answer);
            return () => {};
        }
        const wish = {job, key, done};
        this.wishes.push(wish);
        this.start();
        return () => {
            wish.done = () => {};
            this.wishes = this.wishes.filter(each => each !== wish);
        };
    }

    start() {
        if (this.running === null && this.wishes.length > 0) {
            this.running = this.wishes.shift();
            const {job} = this.running;
            this.worker.postMessage({...job, id: ++this.id, from: 0, to: job.raster.height});
        }
    }

    receive(data) {
        if (data.id !== this.id || this.running === null) {
            return;
        }
        const {key, done} = this.running;
        this.running = null;
        if (key !== null && !data.error) {
            delete data.values;
            this.kept.set(key, data);
            if (this.kept.size > KEPT) {
                this.kept.delete(this.kept.keys().next().value);
            }
        }
        done(data);
        this.start();
    }
}
