// SPDX-License-Identifier: MIT
//
// What is looked at: the terrain, a statement, or the part at the cursor. Nodes are shown by value
// or slope, with the interval that is promised and the one that is met.
import {PARTS} from "../scarp.mjs";
import {isField} from "./document.js";
import {CURSOR, OF_NODES, TERRAIN, VIEWS} from "./state.js";
import {nodeAt} from "./workspace.js";

const byId = id => document.getElementById(id);
const short = number => Number.isFinite(number) ? String(Number((number + 0).toPrecision(4)))
    : number > 0 ? "∞" : "−∞";
const interval = ([low, high]) => `${short(low)} … ${short(high)}`;

export class Look {
    constructor(page) {
        this.page = page;
        this.node = null; // as described() has it
        this.name = ""; // what is shown, for people; "": the terrain
        this.key = null;
        byId("node").addEventListener("change", event => page.setNode(event.target.value));
        byId("views").append(...VIEWS.map((view, i) => {
            const button = document.createElement("button");
            Object.assign(button, {type: "button", textContent: view, title: `Key ${i + 1}`});
            button.dataset.view = view;
            button.setAttribute("role", "radio");
            button.addEventListener("click", () => page.setView(view));
            return button;
        }));
    }

    get isTerrain() {
        return this.node === null;
    }

    get isAtCursor() {
        return this.page.state.node === CURSOR;
    }

    get view() {
        const {view} = this.page.state;
        return this.isTerrain || OF_NODES.includes(view) ? view : OF_NODES[0];
    }

    // Finds the node of the state in a document. While that has errors, the last one stays.
    read(recipe) {
        const {state, work} = this.page;
        if (!recipe.ok) {
            return;
        }
        const at = this.isAtCursor ? nodeAt(recipe, work.cursor)?.which
            : recipe.entries.find(({name, isParam}) => name === state.node && !isParam)?.index;
        const isNone = state.node === TERRAIN || at === undefined;
        const found = isNone ? null : this.described(recipe, at);
        this.node = found && isField(found) ? found : null;
        this.name = this.node === null ? "" : found.name;
    }

    described({text, entries, parts, isSpace}, which) {
        const each = which >= PARTS ? parts[which - PARTS] : entries[which];
        const {kind, range, order, hash, span, output = -1} = each;
        const name = which >= PARTS ? text.slice(...span).replace(/\s+/g, " ").slice(0, 60)
            : each.name;
        return {which, kind, range, order, hash, isSpace, name, output};
    }

    showState() {
        const {recipe, state} = this.page, list = byId("node");
        const names = recipe.entries.filter(isField).map(({name}) => name);
        const key = JSON.stringify(names);
        if (recipe.ok && key !== this.key) {
            list.replaceChildren(new Option("the terrain", TERRAIN),
                new Option("the part at the cursor", CURSOR),
                ...names.map(name => new Option(name)));
            this.key = key;
        }
        list.value = [TERRAIN, CURSOR, ...names].includes(state.node) ? state.node : TERRAIN;
        for (const button of byId("views").children) {
            const {view} = button.dataset;
            button.setAttribute("aria-checked", String(view === this.view));
            button.disabled = !this.isTerrain && !OF_NODES.includes(view);
        }
    }

    // The ends of what 16 bits tell: the promise, or without one what is met
    interval({job, numbers: {floor, highest}, met}) {
        return job.node && !(Number.isFinite(floor) && Number.isFinite(highest)) ? met
            : [floor, highest];
    }

    show({job, numbers, met}) {
        const {lowest, highest, steepest, hasHessian} = numbers;
        const hasNone = job.node ? job.view === "slope" && job.node.order === 0
            : job.view === "curvature" && !hasHessian;
        byId("range").textContent = `${job.name ? `${job.name}: ` : ""}promised ` +
            `${interval([lowest, highest])}, met ${interval(met)}` +
            (job.node && job.view === "slope" && steepest > 0
                ? `; slope up to about ${short(steepest)}` : "");
        byId("status-note").textContent = !hasNone ? "" : job.node
            ? "this part has no gradient: its values are shown"
            : "this terrain has no Hessian: bends are differences of exact slopes";
    }

    // The document for those who keep pictures by their hashes: these change with seed, place and
    // light, too, but not while something is dragged.
    placed(recipe) {
        const {checked, isDragging} = this.page;
        if (!isDragging) {
            this.place = Object.values(checked.options).join(" ");
        }
        const placed = each => ({...each, hash: `${each.hash} ${this.place}`});
        return {...recipe, entries: recipe.entries.map(placed), parts: recipe.parts.map(placed)};
    }

    // See Page.picture. What is the same as before an edit has the same key.
    picture(which, width, height, callback) {
        const {page} = this, {recipe} = page, {options, source} = page.checked;
        const list = which >= PARTS ? recipe.parts : recipe.entries;
        const node = list[which % PARTS] && this.described(recipe, which);
        if (source === null || !node || !isField(node)) {
            return () => {};
        }
        const [across, down] = options.size, every = Math.min(across / width, down / height);
        const step = options.step * every;
        const origin = [[across, width], [down, height]].map(([all, n], axis) =>
            options.origin[axis] + (all - n * every) / 2 * options.step);
        const raster = {width, height, origin, step};
        const isLand = node.output === 0 && !node.isSpace;
        const job = page.jobOf(raster, isLand ? "relief" : "value", isLand ? null : node);
        const sea = recipe.entries.find(({name, isParam}) => isParam && name === "sea")?.hash;
        const key = JSON.stringify([node.hash, raster, isLand && [sea, job.palette, job.azimuth,
            job.altitude, job.zFactor], String(source.seed)]);
        return page.pictures.make(job, key, ({error, pixels, met}) => {
            if (!error) {
                const bytes = new Uint8ClampedArray(pixels.buffer);
                callback({image: new ImageData(bytes, width, height), lowest: met[0],
                    highest: met[1]});
            }
        });
    }
}
