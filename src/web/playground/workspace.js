// SPDX-License-Identifier: MIT
//
// Where the recipe is edited: as text and as graph. Both are loaded when the page is there. Every
// edit goes through the editor of the text, so there is one history; before it is there, edits just
// happen.
import {applied, isField, readDocument} from "./document.js";
import {PARTS} from "../scarp.mjs";

const byId = id => document.getElementById(id);
const PANES = ["text", "graph"];

// The smallest part around a place that has a value at each point, else the statement: the numbers
// of the node and of the statement, or null
export function nodeAt({entries, parts}, at) {
    const holds = ({span}) => span[0] <= at && at <= span[1];
    const entry = entries.find(holds);
    const inside = parts.filter(part => holds(part) && isField(part))
        .sort((a, b) => a.span[1] - a.span[0] - (b.span[1] - b.span[0]));
    return entry === undefined ? null
        : {which: inside.length > 0 ? PARTS + inside[0].index : entry.index, entry: entry.index};
}

const loadSheet = name => new Promise((done, fail) => {
    const link = document.createElement("link");
    Object.assign(link, {rel: "stylesheet", href: name, onload: done,
        onerror: () => fail(new Error(`${name} is missing`))});
    document.head.append(link);
});

export class Workspace {
    constructor(page) {
        this.page = page;
        this.editor = null;
        this.graph = null;
        this.cursor = 0;
        this.fallback = byId("recipe-text");
        this.fallback.addEventListener("input", () => page.textChanged(this.fallback.value));
        PANES.forEach(pane => byId(`tab-${pane}`).addEventListener("click", () =>
            page.setPane(pane)));
        byId("undo").addEventListener("click", () => this.undo());
        byId("redo").addEventListener("click", () => this.redo());
    }

    async load() {
        const {Editor} = await import("./editor/editor.js");
        this.editor = new Editor(byId("editor"), this.page.state.text, {
            read: () => this.page.recipe,
            changed: text => this.page.textChanged(text),
            moved: (at, isOurs) => this.moved(at, isOurs),
            help: text => this.page.say(text),
        });
        this.fallback.hidden = true;
        this.show(this.page.recipe);
    }

    // {from, to, insert} each; {join} makes them a part of the last step, as while something is
    // dragged.
    edit(changes, options = {}) {
        this.page.isDragging ||= options.join === true;
        if (this.editor) {
            this.editor.edit(changes, options);
        } else {
            this.page.textChanged(applied(this.page.state.text, changes));
        }
        this.page.settle();
    }

    // Another text, as one step
    setText(text) {
        if (this.editor) {
            this.editor.replace(text);
        } else {
            this.page.textChanged(text);
        }
    }

    undo() {
        this.editor?.undo();
    }

    redo() {
        this.editor?.redo();
    }

    moved(at, isOurs) {
        const {recipe} = this.page, before = nodeAt(recipe, this.cursor), now = nodeAt(recipe, at);
        this.cursor = at;
        if (before?.which === now?.which) {
            return;
        }
        if (isOurs && now !== null) {
            this.graph?.select(now.entry);
        }
        this.page.lookAtCursor();
    }

    // The graph tells which statement is selected there.
    selected(index) {
        const entry = this.page.recipe.entries[index];
        if (entry && this.editor) {
            this.editor.select(entry.nameSpan[0]);
        } else if (entry) {
            this.moved(entry.nameSpan[0], false);
        }
    }

    goToError() {
        const [error] = this.page.recipe.errors;
        this.page.setPane("text");
        if (this.editor && error) {
            this.editor.select(error.from, error.to);
            this.editor.view.focus();
        }
    }

    show(recipe) {
        const {text} = this.page.state;
        this.editor?.tell(recipe.errors);
        if (this.fallback.value !== text) {
            this.fallback.value = text;
        }
        this.showPane();
        const [undone, redone] = this.editor?.depths ?? [0, 0];
        byId("undo").disabled = undone === 0;
        byId("redo").disabled = redone === 0;
        this.showGraph();
    }

    showPane() {
        const {pane} = this.page.state;
        PANES.forEach(each => {
            byId(`tab-${each}`).setAttribute("aria-selected", String(each === pane));
            byId(`pane-${each}`).hidden = each !== pane;
        });
        document.documentElement.dataset.pane = pane;
    }

    async showGraph() {
        if (this.page.state.pane !== "graph") {
            return;
        }
        if (this.graph === null) {
            this.loading ??= this.loadGraph();
            await this.loading;
        }
        this.graph?.update(this.page.look.placed(this.page.recipe));
    }

    async loadGraph() {
        try {
            const {createGraph} = await import("./graph/graph.js");
            await loadSheet("graph.css");
            this.graph = createGraph(byId("pane-graph"), this.host());
            const now = nodeAt(this.page.recipe, this.cursor);
            if (now !== null) {
                this.graph.select(now.entry);
            }
        } catch (error) {
            byId("pane-graph").textContent = `The graph cannot be shown: ${error.message}`;
        }
    }

    // What the graph may ask
    host() {
        const {page} = this;
        return {
            edit: (changes, options) => this.edit(changes, options),
            undo: () => this.undo(),
            redo: () => this.redo(),
            selected: index => this.selected(index),
            picture: (...all) => page.picture(...all),
            read: text => readDocument(page.terrain.scarp, text),
        };
    }
}
