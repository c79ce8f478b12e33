// SPDX-License-Identifier: MIT
//
// The buttons: seeds, copies, downloads, themes.
import {asC, asCommand, asJavaScript, asRecipe} from "./copy.js";
import {npy, png16, quantised, r16, save} from "./export.js";

const byId = id => document.getElementById(id);
const BINARY = "application/octet-stream";

const COPIES = {
    recipe: {title: "Recipe", make: asRecipe},
    c: {title: "C", make: asC},
    command: {title: "Command line", make: asCommand},
    javascript: {title: "JavaScript", make: asJavaScript},
};

// The text of a copy; null while the options are not all valid
export function copyText(page, kind) {
    page.flushHash();
    return page.checked.source && COPIES[kind].make(page, location.href);
}

async function toClipboard(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false; // not allowed here
    }
}

async function copy(page, kind) {
    const text = copyText(page, kind);
    if (text === null) {
        return;
    }
    const isCopied = await toClipboard(text), area = byId("code-text");
    byId("code-title").textContent = COPIES[kind].title;
    byId("code-note").textContent = isCopied ? "Copied to the clipboard." :
        "The browser does not let the page copy: select the text and copy it.";
    area.value = text;
    byId("code").showModal();
    area.select();
    area.scrollTop = 0;
}

async function saveHeights(page, kind) {
    const {whole} = page;
    if (whole === null) {
        return;
    }
    const {values, raster: {width, height}, numbers: {floor, highest}} = whole;
    const name = `scarp-${page.state.preset}-${whole.job.source.seed}`;
    const numbers = () => quantised(values, floor, highest);
    switch (kind) {
    case "png": save(await png16(numbers(), width, height), `${name}.png`); break;
    case "r16": save(new Blob([r16(numbers())], {type: BINARY}), `${name}.r16`); break;
    case "npy": save(new Blob([npy(values, width, height)], {type: BINARY}), `${name}.npy`);
        break;
    default: {
        const canvas = byId(page.state.space ? "world" : "map");
        canvas.toBlob(blob => save(blob, `${name}-${page.state.view}.png`));
    }
    }
}

function changeTheme() {
    const root = document.documentElement, isDark = matchMedia("(prefers-color-scheme: dark)");
    const now = root.dataset.theme ?? (isDark.matches ? "dark" : "light");
    root.dataset.theme = now === "dark" ? "light" : "dark";
}

export function connectActions(page) {
    const on = (id, action) => byId(id).addEventListener("click", action);
    on("seed-down", () => page.changeSeed(-1));
    on("seed-up", () => page.changeSeed(1));
    on("seed-random", () => {
        const [a, b] = crypto.getRandomValues(new Uint32Array(2));
        page.change({seed: String((BigInt(a) << 32n) + BigInt(b))});
    });
    on("reset", () => page.setPreset(page.state.preset));
    on("fit", () => page.fit());
    on("space", () => page.setSpace(!page.state.space));
    on("theme", changeTheme);
    on("help-open", () => byId("help").showModal());
    on("copy-link", async () => {
        page.flushHash();
        byId("copy-link").textContent = await toClipboard(location.href) ? "Copied" : "Link";
        setTimeout(() => byId("copy-link").textContent = "Link", 1500);
    });
    for (const button of document.querySelectorAll("[data-copy]")) {
        button.addEventListener("click", () => copy(page, button.dataset.copy));
    }
    for (const button of document.querySelectorAll("[data-save]")) {
        button.addEventListener("click", () => saveHeights(page, button.dataset.save));
    }
}
