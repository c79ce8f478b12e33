// SPDX-License-Identifier: MIT
//
// The buttons: seeds, copies, downloads, themes.
import {asC, asCommand, asJavaScript, asRecipe} from "./copy.js";
import {npy, png16, pngRgba, quantised, r16, save} from "./export.js";
import {presetOf, presets} from "./state.js";
import {GROUNDS} from "./terrain.js";

const byId = id => document.getElementById(id);
const BINARY = "application/octet-stream";

const COPIES = {
    recipe: {title: "Recipe", make: asRecipe},
    c: {title: "C", make: asC},
    command: {title: "Command line", make: asCommand},
    javascript: {title: "JavaScript", make: asJavaScript},
};

async function toClipboard(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false; // not allowed here
    }
}

// Programs need a recipe without errors; the text itself may be copied as it is.
async function copy(page, kind) {
    const {messages, source} = page.checked, [[, wrong] = []] = messages;
    const message = wrong ?? page.terrain.open(source); // what is shown may be a node of no terrain
    if (message !== null && kind !== "recipe") {
        page.say(`Not copied as ${COPIES[kind].title}: ${message}`);
        page.work.goToError();
        return;
    }
    await page.flushHash();
    const text = COPIES[kind].make(page, location.href);
    const isCopied = await toClipboard(text), area = byId("code-text");
    byId("code-title").textContent = COPIES[kind].title;
    byId("code-note").textContent = isCopied ? "Copied to the clipboard." :
        "The browser does not let the page copy: select the text and copy it.";
    area.value = text;
    byId("code").showModal();
    area.select();
    area.scrollTop = 0;
}

// Grounds as pixels: the first four as red, green, blue and alpha, or the fifth as red
function maskPixels(masks, first) {
    const count = masks.length / GROUNDS, pixels = new Uint8Array(4 * count);
    for (let i = 0; i < count; i++) {
        for (let c = 0; c < 4 && first + c < GROUNDS; c++) {
            pixels[4 * i + c] = masks[GROUNDS * i + first + c];
        }
    }
    return pixels;
}

function saveMasks(page, kind, name) {
    const {whole: {job, raster: {width, height}}} = page;
    const first = kind === "masks-1" ? 0 : 4;
    page.say("Masks are being made …");
    page.pictures.make({...job, node: null, view: "relief", hasMasks: true}, null,
        async ({error, masks}) => {
            page.say(error ? `Masks cannot be made: ${error.split("\n")[0]}` : "Masks are made.");
            if (!error) {
                save(await pngRgba(maskPixels(masks, first), width, height), `${name}-${kind}.png`);
            }
        });
}

// What is saved is what is shown: heights, or values of a node.
async function saveShown(page, kind) {
    if (page.whole === null || page.checked.source === null) {
        page.say("Not saved: there is no picture of this recipe yet.");
        return;
    }
    const shown = /masks|view/.test(kind) ? page.whole : await page.exact();
    const {values, raster: {width, height}, job} = shown;
    const [floor, highest] = page.look.interval(shown);
    const node = job.node ? `-${job.name.replace(/\W+/g, "-")}` : "";
    const name = `scarp-${presetOf(job.source.text) ?? "recipe"}${node}-${job.source.seed}`;
    const numbers = () => quantised(values, floor, highest);
    switch (kind) {
    case "png": save(await png16(numbers(), width, height), `${name}.png`); break;
    case "r16": save(new Blob([r16(numbers())], {type: BINARY}), `${name}.r16`); break;
    case "npy": save(new Blob([npy(values, width, height)], {type: BINARY}), `${name}.npy`);
        break;
    case "masks-1":
    case "masks-2": saveMasks(page, kind, name); break;
    default: {
        const canvas = byId(page.state.space ? "world" : "map");
        canvas.toBlob(blob => save(blob, `${name}-${page.look.view}.png`));
    }
    }
}

function changeTheme() {
    const root = document.documentElement, isDark = matchMedia("(prefers-color-scheme: dark)");
    const now = root.dataset.theme ?? (isDark.matches ? "dark" : "light");
    root.dataset.theme = now === "dark" ? "light" : "dark";
}

// The line between map and text is dragged, or moved by arrow keys.
function connectSplit() {
    const split = byId("split"), main = split.parentElement;
    const set = share => {
        const percent = Math.round(Math.min(Math.max(share, 15), 80));
        main.style.setProperty("--work", `${percent}%`);
        split.setAttribute("aria-valuenow", String(percent));
    };
    split.addEventListener("pointerdown", event => split.setPointerCapture(event.pointerId));
    split.addEventListener("pointermove", event => {
        if (split.hasPointerCapture(event.pointerId)) {
            const box = main.getBoundingClientRect();
            set(100 * (box.right - event.clientX) / box.width);
        }
    });
    split.addEventListener("keydown", ({key}) => {
        const by = {ArrowLeft: 2, ArrowRight: -2}[key] ?? 0;
        set(Number(split.getAttribute("aria-valuenow")) + by);
    });
}

function connectPresets(page) {
    byId("preset").append(...Object.keys(presets).map(name => new Option(name)),
        Object.assign(new Option("", ""), {disabled: true}));
    byId("preset").addEventListener("change", event => page.setPreset(presets[event.target.value]));
}

export function connectActions(page) {
    const on = (id, action) => byId(id).addEventListener("click", action);
    connectPresets(page);
    connectSplit();
    on("seed-down", () => page.changeSeed(-1));
    on("seed-up", () => page.changeSeed(1));
    on("seed-random", () => {
        const [a, b] = crypto.getRandomValues(new Uint32Array(2));
        page.change({seed: String((BigInt(a) << 32n) + BigInt(b))});
    });
    on("reset", () => page.reset());
    on("fit", () => page.fit());
    on("space", () => page.setSpace(!page.state.space));
    on("gpu", () => page.setGpu(!page.state.gpu));
    on("theme", changeTheme);
    on("help-open", () => byId("help").showModal());
    on("copy-link", async () => {
        await page.flushHash();
        byId("copy-link").textContent = await toClipboard(location.href) ? "Copied" : "Link";
        setTimeout(() => byId("copy-link").textContent = "Link", 1500);
    });
    for (const button of document.querySelectorAll("[data-copy]")) {
        button.addEventListener("click", () => copy(page, button.dataset.copy));
    }
    for (const button of document.querySelectorAll("[data-save]")) {
        button.addEventListener("click", () => saveShown(page, button.dataset.save));
    }
}
