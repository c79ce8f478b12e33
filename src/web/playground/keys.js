// SPDX-License-Identifier: MIT
//
// Keys that work wherever nothing is typed.
import {VIEWS} from "./state.js";

const SEEDS = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1};
const MOVES = {a: [-0.1, 0], d: [0.1, 0], w: [0, 0.1], s: [0, -0.1]};
const ZOOMS = {"+": 1 / Math.SQRT2, "=": 1 / Math.SQRT2, "-": Math.SQRT2};

const isField = element => element.matches("input, select, textarea, summary, [role=separator]") ||
    element.closest(".cm-editor, #pane-graph") !== null;

function press(page, key) {
    if (key in SEEDS) {
        page.changeSeed(SEEDS[key]);
    } else if (key >= "1" && key <= String(VIEWS.length)) {
        document.querySelectorAll("#views button")[key - 1].click();
    } else if (key === "0") {
        page.setSpace(!page.state.space);
    } else if (key === "?") {
        document.getElementById("help").showModal();
    } else if (!page.state.space && key in MOVES) {
        page.map.step(...MOVES[key]);
    } else if (!page.state.space && key in ZOOMS) {
        page.map.step(0, 0, ZOOMS[key]);
    } else {
        return false;
    }
    return true;
}

export function connectKeys(page) {
    addEventListener("keydown", event => {
        const isOpen = document.querySelector("dialog[open]") !== null;
        if (event.ctrlKey || event.altKey || event.metaKey || isOpen || isField(event.target)) {
            return;
        }
        // Of views and panes, arrows choose the next one.
        const radio = event.target.closest("[role=radiogroup], [role=tablist]");
        if (radio && event.key.startsWith("Arrow")) {
            const buttons = [...radio.querySelectorAll("button:enabled")];
            const at = buttons.indexOf(event.target) + SEEDS[event.key];
            const next = buttons[(at + buttons.length) % buttons.length];
            next.focus();
            next.click();
            event.preventDefault();
        } else if (press(page, event.key)) {
            event.preventDefault();
        }
    });
}
