// SPDX-License-Identifier: MIT
//
// The page: keeps the state, asks the workers for frames, and shows what comes of them.
import {connectActions} from "./actions.js";
import {hasVectors} from "../compile.mjs";
import {Controls} from "./controls.js";
import {errorText, readDocument} from "./document.js";
import {sha256} from "./export.js";
import {connectKeys} from "./keys.js";
import {Look} from "./look.js";
import {MapView, placeOf} from "./map.js";
import {ROWS, parseOptions} from "./options.js";
import {Pictures, Pool} from "./pool.js";
import {fromHash, initialState, paletteOf, presetOf, toHash} from "./state.js";
import {compileModule, loadTerrain} from "./terrain.js";
import {Workspace} from "./workspace.js";

const FRAME_MS = 20; // what a frame may take while something is dragged
const SETTLE_MS = 250; // of rest, after which a drag has ended
const SAMPLES_MAX = 1.6e6; // of a raster that fits the window
const byId = id => document.getElementById(id);

class Page {
    constructor(module, terrain, state) {
        this.terrain = terrain;
        this.state = state;
        this.base = state.text; // what Reset returns to
        this.recipe = readDocument(terrain.scarp, state.text);
        this.checked = null;
        this.last = null; // the last frame
        this.whole = null; // the last frame that is no preview
        this.frames = 0;
        this.wishes = 0; // frames that were asked for
        this.sampleMs = 2e-4; // what a sample takes, learnt from frames
        this.isDragging = false;
        this.module = module;
        this.waiting = []; // for exact numbers
        this.pool = new Pool(module, frame => this.show(frame), (...all) => this.fail(...all));
        this.pictures = new Pictures(module);
        this.map = new MapView(byId("map"), (texts, dragging) => this.change(texts, dragging),
            at => this.hover(at));
        this.controls = new Controls(byId("groups"), byId("params"),
            (name, text, dragging) => this.change({[name]: text}, dragging),
            (...all) => this.setParam(...all));
        this.work = new Workspace(this);
        this.look = new Look(this);
        this.world = null; // made when it is first looked at
        this.fitted = null; // the size that fills the stage
        new ResizeObserver(() => this.stageResized()).observe(byId("map").parentElement);
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

    // A parameter is a number in the text. A drag is one step of the history.
    setParam({valueSpan: [from, to]}, text, isDragging, isFirst) {
        this.isDragging = isDragging;
        if (this.state.text.slice(from, to) === text) {
            this.update(isDragging);
        } else {
            this.work.edit([{from, to, insert: text}], {userEvent: "input.drag", join: !isFirst});
        }
    }

    // What is dragged may not tell its end, or rest.
    settle() {
        clearTimeout(this.settling);
        if (this.isDragging) {
            this.settling = setTimeout(() => this.update(), SETTLE_MS);
        }
    }

    // The text is another one. The last picture stays while it has errors.
    textChanged(text) {
        if (text !== this.state.text) {
            this.state.text = text;
            this.recipe = readDocument(this.terrain.scarp, text);
            this.update(this.isDragging);
        }
    }

    setView(view) {
        this.state.view = view;
        this.update();
    }

    setPane(pane) {
        this.state.pane = pane;
        this.work.showPane();
        this.work.showGraph();
        this.saveHash();
    }

    setNode(name) {
        this.state.node = name;
        this.update();
    }

    setPreset(text) {
        this.base = text;
        this.work.setText(text);
    }

    // The text as it came, and all options as at first, but for the size
    reset() {
        const size = this.checked.messages.has("size") ? undefined : this.state.given.size;
        this.state.given = {...initialState().given, size: size ?? this.sizeThatFits()};
        this.updateWith(this.base);
    }

    // Updates once, whether the text is another one or not.
    updateWith(text) {
        if (text === this.state.text) {
            this.update();
        } else {
            this.work.setText(text);
        }
    }

    changeSeed(by) {
        const seed = this.checked.options.seed ?? 0n;
        this.change({seed: String(BigInt.asUintN(64, seed + BigInt(by)))});
    }

    fit() {
        this.change({size: this.sizeThatFits()});
    }

    // Of the raster that fills the stage
    sizeThatFits() {
        const {clientWidth, clientHeight} = byId("map").parentElement;
        const dense = clientWidth * clientHeight * devicePixelRatio ** 2 <= SAMPLES_MAX;
        const scale = dense ? devicePixelRatio : 1;
        const sides = [clientWidth, clientHeight].map(n => Math.max(64, Math.floor(n * scale)));
        this.fitted = sides.join("x");
        return this.fitted;
    }

    // A raster that filled the stage goes on to do so.
    stageResized() {
        clearTimeout(this.resizing);
        this.resizing = setTimeout(() => {
            if (this.state.given.size === this.fitted) {
                this.fit();
            }
        }, SETTLE_MS);
    }

    // What is wrong: {options, messages, source}; `source` is what workers take, null if there are
    // messages: by option, and "recipe" for the text.
    check() {
        const {options, messages} = parseOptions(this.state.given), {text} = this.state;
        const [error] = this.recipe.errors;
        if (error) {
            messages.set("recipe", `line ${error.line}: ${errorText(error)}`);
        }
        const source = messages.size === 0 ? {text, seed: options.seed} : null;
        return {options, messages, source};
    }

    update(isDragging = false) {
        this.isDragging = isDragging;
        this.settle();
        this.look.read(this.recipe);
        this.checked = this.check();
        const {messages} = this.checked;
        this.controls.show(this.state.given, messages, this.recipe);
        this.work.show(this.recipe);
        this.showState();
        this.saveHash();
        this.tell(messages);
        if (this.checked.source !== null) {
            this.request();
        }
    }

    // Tells what is wrong; the last picture stays, dimmed.
    tell(messages) {
        const [[name, message] = []] = messages;
        this.notice(name === undefined ? null : `${ROWS.get(name)?.label ?? name}: ${message}`);
        byId("recipe-message").textContent = messages.get("recipe") ?? "";
        byId("map").classList.toggle("stale", name !== undefined);
        byId("world").classList.toggle("stale", name !== undefined);
    }

    lookAtCursor() {
        if (this.look.isAtCursor && this.checked !== null) {
            this.update(this.isDragging);
        }
    }

    jobOf(raster, view, node) {
        const {options, source} = this.checked;
        return {source, raster, view, node, palette: paletteOf(source.text),
            azimuth: options.azimuth, altitude: options.altitude, zFactor: options["z-factor"]};
    }

    // While something is dragged, as many samples as there is time for
    request() {
        const {options} = this.checked, [width, height] = options.size;
        const whole = {width, height, origin: options.origin, step: options.step};
        const ms = width * height * this.sampleMs;
        let every = 1;
        while (this.isDragging && ms / every ** 2 > FRAME_MS && every < 8) {
            every *= 2;
        }
        const raster = {...whole, width: Math.ceil(width / every),
            height: Math.ceil(height / every), step: whole.step * every};
        document.documentElement.dataset.ready = "no";
        this.pool.request({...this.jobOf(raster, this.look.view, this.look.node), whole, every,
            number: ++this.wishes, name: this.look.name, isDragging: this.isDragging});
    }

    // A small picture of a node, of the middle of what the map shows: a number of a statement, or
    // 65536 and that of a part. callback({image, lowest, highest}); returns what takes the wish
    // back.
    picture(which, width, height, callback) {
        return this.look.picture(which, width, height, callback);
    }

    show(frame) {
        const {job, values, ms} = frame, {width, height} = frame.raster;
        this.pool.gpu?.note(frame);
        if (job.isExact) {
            this.whole = {...this.whole, values, isGpu: false};
            this.finish();
            return;
        }
        const now = ms / (width * height);
        this.sampleMs = this.sampleMs === 2e-4 ? now : (3 * this.sampleMs + now) / 4;
        this.frames++;
        this.map.paint(frame, job.whole);
        this.last = frame;
        this.drawn = this.showWorld();
        this.look.show(frame);
        byId("status-size").textContent =
            `${width} × ${height}${job.every > 1 ? " (preview)" : ""}`;
        byId("status-time").textContent = `${ms < 100 ? ms.toFixed(1) : Math.round(ms)} ms`;
        if (job.every > 1) {
            if (!this.isDragging && this.checked.source !== null) {
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

    // What takes time that dragging has not: the hash of the heights, and these themselves if the
    // picture is the GPU's, which has floats for places.
    async finish() {
        const {whole} = this;
        if (whole.isGpu) {
            if (this.pool.isBusy || this.pool.next !== null) {
                return; // a newer frame comes
            }
            this.pool.request({...whole.job, isExact: true, isDragging: false});
            return;
        }
        const hash = await sha256(whole.values);
        await this.drawn;
        if (whole !== this.whole) {
            return;
        }
        this.waiting.splice(0).forEach(done => done(whole));
        byId("status-hash").textContent = hash ? `SHA-256 ${hash.slice(0, 12)}…` : "";
        byId("status-hash").dataset.hash = hash ?? "";
        const [low, high] = this.look.interval(whole).map(n => Number((n + 0).toPrecision(9)));
        byId("heights-range").textContent = `16 bits: 0 is ${low}, 65535 is ${high}`;
        if (whole.job.number === this.wishes) {
            document.documentElement.dataset.ready = "yes";
        }
    }

    // The last frame that is no preview, with the numbers of the module
    exact() {
        return this.whole.isGpu ? new Promise(done => this.waiting.push(done)) : this.whole;
    }

    hover(at) {
        const readout = byId("readout"), {whole} = this, raster = whole?.raster;
        readout.hidden = !at || whole?.job.whole !== this.map.raster;
        if (!readout.hidden) {
            const [x, y] = placeOf(raster, at.column, at.row);
            const value = whole.values[at.row * raster.width + at.column];
            readout.textContent = `x ${x.toFixed(1)}  y ${y.toFixed(1)}  ` +
                (whole.job.node ? `value ${Number(value.toPrecision(4))}` :
                    `height ${value.toFixed(2)}`);
        }
    }

    showState() {
        const {state} = this, preset = presetOf(state.text), seed = state.given.seed ?? "1";
        const base = presetOf(this.base), own = byId("preset").lastElementChild;
        own.textContent = base === null ? "your own recipe" : `${base}, edited`;
        own.hidden = preset !== null;
        byId("preset").value = preset ?? "";
        byId("seed-now").textContent = seed;
        byId("space").setAttribute("aria-pressed", String(state.space));
        byId("gpu").setAttribute("aria-pressed", String(state.gpu));
        byId("map").hidden = state.space;
        byId("world").hidden = !state.space;
        this.showWorld();
        this.look.showState();
        byId("map").setAttribute("aria-label", `Map of ${this.look.name || "the terrain"} ` +
            `${preset ?? own.textContent}, seed ${seed}, ${this.look.view}`);
    }

    // Browsers allow some changes of the URL a second.
    saveHash() {
        clearTimeout(this.saving);
        this.saving = setTimeout(() => this.flushHash(), 150);
    }

    async flushHash() {
        clearTimeout(this.saving);
        const {text} = this.state, hash = await toHash(this.state);
        if (text === this.state.text) {
            history.replaceState(null, "", hash);
        }
    }

    setSpace(space) {
        this.state.space = space;
        this.update();
    }

    setGpu(isOn) {
        this.state.gpu = isOn;
        this.update();
        this.openGpu();
    }

    // Lets the GPU sample, or no more, as the state says.
    async openGpu() {
        if (this.state.gpu === (this.pool.gpu !== null)) {
            return;
        }
        const {Gpu} = await import("./gpu.js"), {gpu} = this.pool;
        const request = () => this.checked.source !== null && this.request();
        if (this.state.gpu && gpu === null) {
            const show = text => byId("status-gpu").textContent = text;
            this.pool.gpu = new Gpu(this.module, {show, say: text => this.say(text),
                ready: request});
        } else if (!this.state.gpu && gpu !== null) {
            this.pool.gpu = null;
            gpu.close();
        }
        request();
    }

    // The frame in space, if that is what is looked at
    async showWorld() {
        if (!this.state.space || !this.last) {
            return;
        }
        const {View3d, poseOf, poseText} = await import("./view3d.js");
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

    // Tells what a button did, or why it did not.
    say(text) {
        const said = byId("said");
        said.hidden = false;
        said.textContent = text;
        clearTimeout(this.saying);
        this.saying = setTimeout(() => said.hidden = true, 6000);
    }

    // A recipe that is no terrain is found by workers, as their frames are.
    fail(message, problem = null, job = null) {
        if (problem === null) {
            this.notice(`The terrain cannot be computed: ${message.split("\n")[0]}`);
        } else if (job.number === this.wishes && this.checked.source !== null) {
            this.checked.source = null;
            this.checked.messages.set("recipe", problem);
            this.tell(this.checked.messages);
        }
    }

    // Another state, from the URL
    open(state) {
        this.base = state.text;
        const {given} = state, size = given.size ?? this.sizeThatFits();
        this.state = {...state, given: {...given, size}, text: this.state.text};
        this.updateWith(state.text);
        this.openGpu();
    }
}

async function main() {
    const module = await compileModule(), terrain = await loadTerrain(module);
    const page = new Page(module, terrain, await fromHash(location.hash, terrain.scarp));
    connectActions(page);
    connectKeys(page);
    const isSimd = hasVectors();
    byId("status-kernels").textContent = isSimd ? "wasm128" : "generic";
    byId("no-simd").hidden = isSimd;
    let opened = 0;
    addEventListener("hashchange", async event => { // saveHash() may have changed the URL since
        const turn = ++opened;
        document.documentElement.dataset.ready = "no";
        page.notice(null);
        const state = await fromHash(new URL(event.newURL).hash, terrain.scarp);
        if (turn === opened) { // none came meanwhile
            page.open(state);
        }
    });
    globalThis.playground = page; // for the console, and for tests
    page.open(page.state);
    await page.work.load();
}

main().catch(error => {
    byId("notice").hidden = false;
    byId("notice").textContent = `The playground cannot start: ${error.message}`;
});
