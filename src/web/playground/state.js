// SPDX-License-Identifier: MIT
//
// The state of the page: the text of the recipe, options that were given as text, and what is
// looked at. All of it stands in the URL; the text is deflated there, unless it is a preset as it
// was.
import presets from "presets";
import {ROWS} from "./options.js";

export {presets};
export const VIEWS = ["relief", "hillshade", "value", "slope", "curvature"];
export const OF_NODES = ["value", "slope"]; // views of a statement or a part
export const TERRAIN = "", CURSOR = "*"; // in place of the name of the statement that is shown

// What a page shows without a URL; the step lets a range of mountains be seen.
export const initialState = () => ({text: Object.values(presets)[0], given: {step: "4"},
    view: VIEWS[0], node: TERRAIN, space: false, gpu: false, camera: null, pane: "text"});

// The preset whose text this is; null for others
export const presetOf = text =>
    Object.keys(presets).find(name => presets[name] === text) ?? null;

export const paletteOf = text => /^#: palette (\w+)/m.exec(text)?.[1] ?? "alpine";

async function through(bytes, stream) {
    const piped = new Blob([bytes]).stream().pipeThrough(stream);
    return new Uint8Array(await new Response(piped).arrayBuffer());
}

async function packed(text) {
    const bytes = await through(text, new CompressionStream("deflate-raw"));
    return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_")
        .replaceAll("=", "");
}

async function unpacked(word) {
    const bytes = atob(word.replaceAll("-", "+").replaceAll("_", "/"));
    return new TextDecoder().decode(await through(Uint8Array.from(bytes, c => c.charCodeAt(0)),
        new DecompressionStream("deflate-raw")));
}

// The state as the part of the URL behind #
export async function toHash(state) {
    const query = new URLSearchParams(), preset = presetOf(state.text);
    if (preset !== null) {
        query.set("preset", preset);
    } else if ("CompressionStream" in globalThis) {
        query.set("recipe", await packed(state.text));
    } else {
        query.set("text", state.text);
    }
    for (const name of ROWS.keys()) {
        if (state.given[name] !== undefined) {
            query.set(name, state.given[name]);
        }
    }
    query.set("view", state.view);
    for (const [name, value, standard] of [["node", state.node, TERRAIN],
        ["pane", state.pane, "text"], ["space", state.space ? "3d" : "", ""],
        ["gpu", state.gpu ? "1" : "", ""],
        ["camera", state.space && state.camera ? state.camera : "", ""]]) {
        if (value !== standard) {
            query.set(name, value);
        }
    }
    return "#" + query.toString().replaceAll("%2C", ",");
}

// Links of older pages name the options of one noise, values of parameters, and a period.
const isOld = query => query.get("preset") === "none" || query.has("set") || query.has("period");

// What is unknown is left out: URLs of other versions still show something.
export async function fromHash(hash, scarp) {
    const query = new URLSearchParams(hash.replace(/^#/, "")), state = initialState();
    if (hash.length > 1) {
        state.given = Object.fromEntries([...query].filter(([name]) => ROWS.has(name)));
    }
    state.view = VIEWS.find(view => view === query.get("view")) ?? VIEWS[0];
    state.pane = query.get("pane") === "graph" ? "graph" : "text";
    state.node = query.get("node") ?? TERRAIN;
    state.space = query.get("space") === "3d";
    state.gpu = query.get("gpu") === "1";
    state.camera = query.get("camera");
    const preset = Object.keys(presets).find(name => name === query.get("preset"));
    state.text = presets[preset] ?? query.get("text") ?? state.text;
    if (query.has("recipe")) {
        state.text = await unpacked(query.get("recipe")).catch(() => state.text);
    }
    if (isOld(query)) {
        const {textOfOldLink} = await import("./oldlinks.js");
        state.text = textOfOldLink(query, state.text, scarp);
    }
    state.text = state.text.replace(/\r\n?/g, "\n");
    return state;
}
