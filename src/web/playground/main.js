// SPDX-License-Identifier: MIT
//
// The page: keeps the state, asks the workers for frames, and shows what comes of them.
import {check} from "./check.js";
import {Controls} from "./controls.js";
import {connectActions} from "./actions.js";
import {hasVectors} from "./compile.mjs";
import {sha256} from "./export.js";
import {connectKeys} from "./keys.js";
import {MapView, placeOf} from "./map.js";
import {ROWS} from "./parameters.js";
import {Pool} from "./pool.js";
import {loadPresets, paletteOf} from "./recipes.js";
import {NOISE, OWN, VIEWS, fromHash, textOf, toHash} from "./state.js";
import {loadTerrain} from "./terrain.js";
import {View3d, poseOf, poseText} from "./view3d.js";

const FRAME_MS = 20; // what a frame may take while something is dragged
const SAMPLES_MAX = 1.6e6; // of a raster that fits the window
const byId = id => document.getElementById(id);

class Page {
    constructor(terrain, presets) {
        this.terrain = terrain;
        this.presets = presets; // texts by name
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
        this.controls = new Controls(byId("groups"), byId("params"),
            (name, text, dragging) => this.change({[name]: text}, dragging),
            (name, text, dragging) => this.setValue(name, text, dragging));
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

    // Sets a parameter of the recipe; undefined takes it back.
    setValue(name, text, isDragging = false) {
        if (text === undefined) {
            delete this.state.values[name];
        } else {
            this.state.values[name] = text;
        }
        this.update(isDragging);
    }

    // A text of one's own. The last picture stays while it has errors.
    setText(text) {
        this.state.preset = OWN;
        this.state.text = text;
        this.update();
    }

    move(texts, isDragging) {
        this.change(texts, isDragging);
    }

    setView(view) {
        this.state.view = view;
        this.update();
    }

    // A preset brings its own numbers; seed, raster and light stay. One's own text begins with the
    // recipe that was shown.
    setPreset(preset) {
        const stays = ["seed", "size", "origin", "step", "azimuth", "altitude", "z-factor"];
        this.state.text = preset === OWN ? this.state.text ?? this.checked.text : null;
        this.state.preset = preset;
        this.state.values = {};
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
        this.checked = check(this.terrain, this.presets, this.state);
        this.controls.show(this.state, this.checked);
        this.showState();
        this.saveHash();
        if (this.checked.source !== null) {
            this.notice(null);
            this.request();
        } else {
            const [name, message] = [...this.checked.messages][0];
            const label = ROWS.get(name)?.label ?? name.replace(/^=/, "");
            this.notice(`${label}: ${message}`);
        }
    }

    // While something is dragged, as many samples as there is time for
    request() {
        const {options, source, text} = this.checked, [width, height] = options.size;
        const whole = {width, height, origin: options.origin, step: options.step};
        const ms = width * height * this.sampleMs;
        let every = 1;
        while (this.isDragging && ms / every ** 2 > FRAME_MS && every < 8) {
            every *= 2;
        }
        const raster = {...whole, width: Math.ceil(width / every), height: Math.ceil(height / every),
            step: whole.step * every};
        document.documentElement.dataset.ready = "no";
        this.pool.request({number: ++this.wishes, source, raster, whole, every,
            view: this.state.view, palette: paletteOf(text), azimuth: options.azimuth,
            altitude: options.altitude, zFactor: options["z-factor"]});
    }

    show(frame) {
        const {job, values, ms} = frame, {width, height} = frame.raster;
        const now = ms / (width * height);
        this.sampleMs = this.sampleMs === 2e-4 ? now : (3 * this.sampleMs + now) / 4;
        this.frames++;
        this.map.paint(frame, job.whole);
        this.last = frame;
        this.showWorld();
        const preview = job.every > 1 ? " (preview)" : "";
        const isWithout = job.view === "curvature" && !frame.numbers.hasHessian;
        byId("status-note").textContent = isWithout
            ? "this terrain has no Hessian: bends are differences of exact slopes" : "";
        byId("status-size").textContent = `${width} × ${height}${preview}`;
        byId("status-time").textContent = `${ms < 100 ? ms.toFixed(1) : Math.round(ms)} ms`;
        if (job.every > 1) {
            if (!this.isDragging) {
                this.request();
            }
            return;
        }
        this.whole = {...frame, values};
        if (!this.pool.isBusy && this.pool.next === null) {
            clearTimeout(this.idle);
            this.idle = setTimeout(() => this.finish(), this.isDragging ? 300 : 0);
        }
    }

    // What takes time that dragging has not: the hash of the heights
    async finish() {
        const {whole} = this, {floor, highest} = whole.numbers;
        const hash = await sha256(whole.values);
        if (whole !== this.whole) {
            return;
        }
        byId("status-hash").textContent = hash ? `heights ${hash.slice(0, 12)}…` : "";
        byId("status-hash").dataset.hash = hash ?? "";
        const [low, high] = [floor + 0, highest + 0].map(n => Number(n.toPrecision(9)));
        byId("heights-range").textContent = `16-bit heights: 0 is ${low}, 65535 is ${high}`;
        if (whole.job.number === this.wishes) {
            document.documentElement.dataset.ready = "yes";
        }
    }

    hover(at) {
        const readout = byId("readout"), {whole} = this, raster = whole?.raster;
        readout.hidden = !at || whole?.job.whole !== this.map.raster;
        if (!readout.hidden) {
            const [x, y] = placeOf(raster, at.column, at.row);
            const height = whole.values[at.row * raster.width + at.column];
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
        const area = byId("recipe-text"), {text, messages} = this.checked;
        if (document.activeElement !== area || state.preset !== OWN) {
            area.value = text ?? state.text ?? "";
        }
        byId("recipe-message").textContent = messages.get("recipe") ?? "";
        area.setAttribute("aria-invalid", String(messages.has("recipe")));
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
    byId("preset").append(...[...page.presets.keys()].map(name => new Option(name, name)),
        new Option("one noise", NOISE), new Option("a recipe of your own", OWN));
    byId("recipe-text").addEventListener("input", event => page.setText(event.target.value));
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
    const [terrain, presets] = await Promise.all([loadTerrain(), loadPresets()]);
    const page = new Page(terrain, presets);
    makeChoices(page);
    connectActions(page);
    connectKeys(page);
    const isSimd = hasVectors();
    byId("status-kernels").textContent = isSimd ? "wasm128" : "generic";
    byId("no-simd").hidden = isSimd;
    addEventListener("hashchange", event => { // saveHash() may have changed the URL since
        page.state = fromHash(new URL(event.newURL).hash);
        page.update();
    });
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
