// SPDX-License-Identifier: MIT
//
// The page: keeps the state, asks the workers for frames, and shows what comes of them.
import {check} from "./check.js";
import {Controls} from "./controls.js";
import {connectActions} from "./actions.js";
import {heightsOf, heightRange, sha256} from "./export.js";
import {openGpu} from "./gpu.js";
import {withoutHessian} from "./ground.js";
import {connectKeys} from "./keys.js";
import {load} from "./scarp.mjs";
import {MapView, placeOf} from "./map.js";
import {ROWS} from "./parameters.js";
import {Pool} from "./pool.js";
import {PRESETS} from "./presets.js";
import {VIEWS, fromHash, textOf, toHash} from "./state.js";
import {View3d, poseOf, poseText} from "./view3d.js";

const FRAME_MS = 20; // what a frame may take while something is dragged
const SAMPLES_MAX = 1.6e6; // of a raster that fits the window
const byId = id => document.getElementById(id);

class Page {
    constructor(scarp) {
        this.scarp = scarp;
        this.state = fromHash(location.hash);
        this.checked = null;
        this.last = null; // the last frame
        this.whole = null; // the last frame that is no preview
        this.frames = 0;
        this.wishes = 0; // frames that were asked for
        this.sampleMs = 2e-4; // what a sample takes, learnt from frames
        this.isDragging = false;
        this.pool = new Pool(frame => this.show(frame), message => this.fail(message));
        this.map = new MapView(byId("map"), (texts, dragging) => this.move(texts, dragging),
            at => this.hover(at));
        this.controls = new Controls(byId("groups"),
            (name, text, dragging) => this.change({[name]: text}, dragging));
        this.world = null; // made when it is first looked at
    }

    // Changes options; undefined takes one back.
    change(texts, isDragging = false) {
        for (const [name, text] of Object.entries(texts)) {
            if (text === undefined) {
                delete this.state.given[name];
            } else {
                this.state.given[name] = text;
            }
        }
        this.update(isDragging);
    }

    move(texts, isDragging) {
        this.change(texts, isDragging);
    }

    setView(view) {
        this.state.view = view;
        this.update();
    }

    // A preset brings its own numbers; seed, raster and light stay.
    setPreset(preset) {
        const stays = ["seed", "size", "origin", "step", "azimuth", "altitude", "z-factor"];
        this.state.preset = preset;
        this.state.given = Object.fromEntries(Object.entries(this.state.given)
            .filter(([name]) => stays.includes(name)));
        this.update();
    }

    changeSeed(by) {
        const seed = this.checked.options.seed ?? 0n;
        this.change({seed: String(BigInt.asUintN(64, seed + BigInt(by)))});
    }

    // The raster that fills the stage
    fit() {
        const {clientWidth, clientHeight} = byId("map").parentElement;
        const dense = clientWidth * clientHeight * devicePixelRatio ** 2 <= SAMPLES_MAX;
        const scale = dense ? devicePixelRatio : 1;
        const sides = [clientWidth, clientHeight].map(n => Math.max(64, Math.floor(n * scale)));
        this.change({size: sides.join("x")});
    }

    update(isDragging = false) {
        this.isDragging = isDragging;
        this.checked = check(this.scarp, this.state);
        this.controls.show(this.state, this.checked);
        this.showState();
        this.saveHash();
        if (this.checked.terrain !== null) {
            this.notice(null);
            this.request();
        } else {
            const [name, message] = [...this.checked.messages][0], row = ROWS.get(name);
            const isTold = message.startsWith(`${row.member ?? row.name}:`);
            const of = row.prefix ? `${row.prefix.slice(0, -1)}: ` : "";
            this.notice(of + (isTold ? message : `${row.label}: ${message}`));
        }
    }

    // While something is dragged, as many samples as there is time for
    request() {
        const {terrain} = this.checked, {width, height, step} = terrain.raster;
        const ms = width * height * this.sampleMs;
        let every = 1;
        while (this.isDragging && ms / every ** 2 > FRAME_MS && every < 8) {
            every *= 2;
        }
        const raster = {...terrain.raster, width: Math.ceil(width / every),
            height: Math.ceil(height / every), step: step * every};
        document.documentElement.dataset.ready = "no";
        const job = {number: ++this.wishes, terrain: {...terrain, raster}, whole: terrain, every,
            view: this.state.view, preset: this.state.preset};
        if (this.state.gpu && this.gpu) {
            this.requestGpu({...job, verify: !this.isDragging});
        } else {
            this.pool.request(job);
        }
    }

    // Lets the GPU sample, then the workers paint. Only the latest wish is kept.
    async requestGpu(job) {
        this.nextOfGpu = job;
        if (this.gpuIsBusy) {
            return;
        }
        this.gpuIsBusy = true;
        while (this.nextOfGpu) {
            const now = this.nextOfGpu;
            this.nextOfGpu = null;
            try {
                this.pool.request({...now, given: await this.gpu.sample(now.terrain, now.view)});
            } catch (error) {
                this.pool.request({...now, failure: error.message});
            }
        }
        this.gpuIsBusy = false;
    }

    async setGpu(isOn) {
        this.state.gpu = isOn;
        this.update();
    }

    // Offers WebGPU where it is there; opening it takes a moment.
    async findGpu() {
        this.gpu = await openGpu(this.scarp).catch(() => null);
        byId("gpu").hidden = this.gpu === null;
        if (this.state.gpu) {
            this.sign(null);
            this.update();
        }
    }

    sign(text, kind) {
        byId("gpu-sign").hidden = text === null;
        byId("gpu-sign").className = `sign ${kind}`;
        byId("gpu-sign").textContent = text ?? "";
    }

    // Says whether the GPU's pixels are those of the CPU.
    showComparison({job, compared}) {
        if (job.failure) {
            this.sign(`WebGPU cannot sample this: ${job.failure}`, "differs");
        } else if (!job.given) {
            const isOn = this.state.gpu && this.gpu !== null;
            this.sign(isOn ? "WebGPU starts …" : null, "");
        } else if (!compared) {
            this.sign("WebGPU draws …", "");
        } else {
            const [pixels, differing, values, wrong] = ["pixels", "differing", "values", "wrong"]
                .map(name => compared[name].toLocaleString("en"));
            const isEqual = compared.differing + compared.wrong === 0;
            const text = isEqual ? `all ${pixels} pixels and ${values} values equal the CPU's`
                : `${differing} of ${pixels} pixels and ${wrong} of ${values} values differ ` +
                "from the CPU's";
            this.sign(`WebGPU: ${text}`, isEqual ? "equal" : "differs");
        }
    }

    show(frame) {
        const {job, values, ms} = frame, {width, height} = frame.raster;
        const now = ms / (width * height);
        this.sampleMs = this.sampleMs === 2e-4 ? now : (3 * this.sampleMs + now) / 4;
        this.frames++;
        this.map.paint(frame, job.whole.raster);
        this.last = frame;
        this.showComparison(frame);
        this.showWorld();
        const preview = job.every > 1 ? " (preview)" : "";
        const without = this.state.view === "curvature" ? withoutHessian(job.terrain) : null;
        byId("status-note").textContent = without === null ? ""
            : `${without} noise has no Hessian: bends are differences of exact slopes`;
        byId("status-size").textContent = `${width} × ${height}${preview}`;
        byId("status-time").textContent = `${ms < 100 ? ms.toFixed(1) : Math.round(ms)} ms`;
        if (job.every > 1 || (job.given && !job.verify)) {
            if (!this.isDragging) {
                this.request();
            }
            return;
        }
        this.whole = {...frame, terrain: job.whole, values};
        if (!this.pool.isBusy && this.pool.next === null) {
            clearTimeout(this.idle);
            this.idle = setTimeout(() => this.finish(), this.isDragging ? 300 : 0);
        }
    }

    // What takes time that dragging has not: the hash of the heights
    async finish() {
        const {whole} = this, scale = whole.terrain.height;
        const heights = heightsOf(whole.values, scale);
        const hash = await sha256(heights);
        if (whole !== this.whole) {
            return;
        }
        const [low, high] = heightRange(scale, whole.floor, whole.ceiling);
        byId("status-hash").textContent = hash ? `heights ${hash.slice(0, 12)}…` : "";
        byId("status-hash").dataset.hash = hash ?? "";
        byId("heights-range").textContent = `16-bit heights: 0 is ${Number(low.toPrecision(9))}, ` +
            `65535 is ${Number(high.toPrecision(9))}`;
        const isWaiting = this.state.gpu && this.gpu === undefined; // for a device
        if (whole.job.number === this.wishes && !isWaiting) {
            document.documentElement.dataset.ready = "yes";
        }
    }

    hover(at) {
        const readout = byId("readout"), {whole} = this;
        const raster = whole?.terrain.raster;
        readout.hidden = !at || raster !== this.map.raster;
        if (!readout.hidden) {
            const [x, y] = placeOf(raster, at.column, at.row);
            const height = whole.terrain.height * whole.values[at.row * raster.width + at.column];
            readout.textContent =
                `x ${x.toFixed(1)}  y ${y.toFixed(1)}  height ${height.toFixed(2)}`;
        }
    }

    showState() {
        const {state} = this;
        byId("preset").value = state.preset;
        byId("seed-now").textContent = textOf(state, "seed");
        document.querySelectorAll("#views button").forEach(button =>
            button.setAttribute("aria-checked", String(button.dataset.view === state.view)));
        byId("space").setAttribute("aria-pressed", String(state.space));
        byId("gpu").setAttribute("aria-pressed", String(state.gpu));
        byId("map").hidden = state.space;
        byId("world").hidden = !state.space;
        this.showWorld();
        byId("map").setAttribute("aria-label", `Map of the terrain ${state.preset}, ` +
            `seed ${textOf(state, "seed")}, ${state.view}`);
    }

    // Browsers allow some changes of the URL a second.
    saveHash() {
        clearTimeout(this.saving);
        this.saving = setTimeout(() => this.flushHash(), 150);
    }

    flushHash() {
        clearTimeout(this.saving);
        history.replaceState(null, "", toHash(this.state));
    }

    setSpace(space) {
        this.state.space = space;
        this.update();
    }

    // The frame in space, if that is what is looked at
    showWorld() {
        if (!this.state.space || !this.last) {
            return;
        }
        this.world ??= new View3d(byId("world"), () => {
            this.state.camera = poseText(this.world.pose);
            this.saveHash();
        });
        if (!this.world.isThere) {
            this.notice("This browser has no WebGL 2, which the view in space needs.");
            this.state.space = false;
            this.showState();
            return;
        }
        Object.assign(this.world.pose, poseOf(this.state.camera));
        this.world.show(this.last);
    }

    notice(text) {
        const notice = byId("notice");
        notice.hidden = text === null;
        notice.textContent = text ?? "";
    }

    fail(message) {
        this.notice(`The terrain cannot be computed: ${message.split("\n")[0]}`);
    }
}

function makeChoices(page) {
    byId("preset").append(...Object.keys(PRESETS).map(name => new Option(name, name)));
    byId("preset").addEventListener("change", event => page.setPreset(event.target.value));
    byId("views").append(...VIEWS.map((view, i) => {
        const button = document.createElement("button");
        Object.assign(button, {type: "button", textContent: view, title: `Key ${i + 1}`});
        button.dataset.view = view;
        button.setAttribute("role", "radio");
        button.addEventListener("click", () => page.setView(view));
        return button;
    }));
}

async function main() {
    const scarp = await load(), page = new Page(scarp);
    makeChoices(page);
    connectActions(page);
    connectKeys(page);
    const isSimd = scarp.isa === "wasm128";
    byId("status-kernels").textContent = `scarp ${scarp.version}, ${scarp.isa}`;
    byId("no-simd").hidden = isSimd;
    addEventListener("hashchange", event => { // saveHash() may have changed the URL since
        page.state = fromHash(new URL(event.newURL).hash);
        page.update();
    });
    page.findGpu();
    globalThis.playground = page; // for the console, and for tests
    if (page.state.given.size === undefined) {
        page.fit();
    } else {
        page.update();
    }
}

main().catch(error => {
    byId("notice").hidden = false;
    byId("notice").textContent = `The playground cannot start: ${error.message}`;
});
