// SPDX-License-Identifier: MIT
//
// The graph of a recipe: its text as cards and wires. A statement is a card, and each use of a name is
// an input of its own. The text is the only state; each gesture is an edit of it, which the host does,
// and then tells the new document.
import {CardView} from "./cards.js";
import {draw, make} from "./dom.js";
import {extract, forgetPlaces} from "./edits.js";
import {Keys} from "./keys.js";
import {Menu} from "./menu.js";
import {modelOf} from "./model.js";
import {Pictures} from "./pictures.js";
import {cardsOf} from "./rows.js";
import {Settings} from "./settings.js";
import {Stage} from "./stage.js";
import {Wires} from "./wires.js";

const MANY = 7; // statements: with more, only the selected card shows its sliders
const NARROW = 560; // pixels: below that, cards are a list

class Graph {
    constructor(container, host) {
        this.host = host;
        this.model = null;
        this.isStale = false;
        this.isList = false;
        this.cards = [];
        this.views = new Map(); // of ids of cards
        this.spreads = new Set(); // names of statements that are spread out, or not if all are
        this.isAllSpread = false;
        this.isAllOpen = null; // null: as many statements as there are decide
        this.selectedName = null;
        this.read = text => host.read(text);
        this.#build(container);
        this.#listen();
    }

    #build(container) {
        this.svg = draw("svg", {class: "graph-wires", "aria-hidden": "true"});
        this.world = make("div", {class: "graph-world"}, this.svg);
        this.ground = make("div", {class: "graph-ground", tabindex: 0, role: "group", "aria-label":
            "Cards of the recipe. Insert adds one, arrows go from card to card, F2 renames, " +
            "Delete deletes."}, this.world);
        this.error = make("p", {class: "graph-error", hidden: true});
        this.said = make("p", {class: "graph-said", role: "status", "aria-live": "polite"});
        this.root = make("section", {class: "graph", "aria-label": "Graph"});
        this.settings = new Settings(this);
        this.root.append(this.#tools(), this.error, this.ground, this.said);
        container.append(this.root);
        this.menu = new Menu(this, this.root);
        this.wires = new Wires(this, this.svg);
        this.pictures = new Pictures(this.host);
        this.stage = new Stage(this);
        this.keys = new Keys(this);
    }

    #tools() {
        const button = (text, title, onclick) => make("button", {type: "button", title, onclick}, text);
        const add = button("+ Add", "Add a statement (Tab or Insert)", () => {
            const {left, bottom} = add.getBoundingClientRect();
            this.openMenu({x: left, y: bottom + 6}, {});
        });
        this.spreadButton = button("Spread out", "Operators as cards", () => {
            this.isAllSpread = !this.isAllSpread;
            this.spreads.clear();
            this.#relayout();
        });
        this.openButton = button("Sliders", "All sliders, or those of the selected card", () => {
            this.isAllOpen = this.isCompact;
            this.#relayout();
        });
        this.tidyButton = button("Tidy", "Lay out all cards anew", () => this.tidy());
        this.fitButton = button("Fit", "Show all cards", () => this.stage.fit());
        return make("div", {class: "graph-tools", role: "toolbar", "aria-label": "Graph"}, add,
            this.spreadButton, this.openButton, this.tidyButton, this.fitButton,
            this.settings.element);
    }

    #listen() {
        const {ground, root} = this;
        ground.addEventListener("dblclick", event => {
            if (!event.target.closest(".graph-card")) {
                this.openMenu({x: event.clientX, y: event.clientY}, {wish: this.stage.worldAt(event)});
            }
        });
        this.observer = new ResizeObserver(() => this.#resized());
        this.observer.observe(root);
    }

    get isCompact() {
        return this.isAllOpen === null ? this.model?.statements.length > MANY : !this.isAllOpen;
    }

    // What the host calls when the text has changed

    update(document) {
        const wasStale = this.isStale;
        this.isStale = !document.ok;
        this.root.classList.toggle("is-stale", this.isStale);
        this.world.inert = this.isStale;
        this.error.hidden = !this.isStale;
        if (this.isStale) {
            const [{line, column, text}] = document.errors;
            this.error.textContent = `Line ${line}, column ${column}: ${text}. ${this.model?.document.ok
                ? "These are the cards of before." : ""}`;
            if (this.model?.document.ok) {
                return;
            }
        } else if (wasStale) {
            this.say("The text has no error now.");
        }
        this.#take(modelOf(document));
    }

    #take(model) {
        const old = this.model;
        const kept = old?.statements.filter(({name}) => model.byName.has(name)).length ?? 0;
        const isNew = old === null || kept * 2 < Math.max(old.statements.length, 1);
        this.model = model;
        if (isNew) {
            this.stage.laid.clear();
            this.spreads.clear();
            this.selectedName = null;
        } else {
            this.#followNames(old, model);
        }
        if (isNew) {
            this.#measure();
        }
        this.#render();
        if (isNew || this.stage.laid.size === 0) {
            this.stage.layout();
            this.stage.fit({isFirst: true});
        } else {
            this.stage.place();
        }
    }

    // A statement that has another name, in the same place of the text, stays where it was.
    #followNames(old, model) {
        if (old.statements.length !== model.statements.length) {
            return;
        }
        old.statements.forEach(({name}, i) => {
            const next = model.statements[i].name;
            if (name !== next && !model.byName.has(name) && this.stage.laid.has(name)) {
                this.stage.laid.set(next, this.stage.laid.get(name));
                this.selectedName = this.selectedName === name ? next : this.selectedName;
            }
        });
    }

    // Makes the elements that the model asks for.
    #render() {
        const {model, views} = this;
        this.cards = cardsOf(model, name => this.isAllSpread !== this.spreads.has(name));
        this.root.classList.toggle("is-compact", this.isCompact);
        this.spreadButton.setAttribute("aria-pressed", this.isAllSpread);
        this.openButton.setAttribute("aria-pressed", !this.isCompact);
        this.settings.update();
        const ids = new Set(this.cards.map(card => card.id));
        for (const [id, view] of views) {
            if (!ids.has(id)) {
                this.#drop(id, view);
            }
        }
        for (const card of this.cards) {
            let view = views.get(card.id);
            if (!view?.fits(card)) {
                view = this.#renew(card, view);
            }
            view.update(card, card.statement.name === this.selectedName);
            if (this.isList) {
                this.world.append(view.element);
            }
            this.pictures.update(view);
        }
    }

    #renew(card, old) {
        const view = new CardView(this, card);
        this.views.set(card.id, view);
        if (!old) {
            this.world.append(view.element);
            return view;
        }
        const fields = element => [...element.querySelectorAll("input, select, button")];
        const focused = document.activeElement, had = old.element.contains(focused);
        const at = fields(old.element).indexOf(focused);
        view.element.style.cssText = old.element.style.cssText;
        old.element.replaceWith(view.element);
        this.pictures.hand(old, view);
        if (had) {
            const same = at < 0 ? null : fields(view.element)[at];
            (same?.tagName === focused.tagName ? same : view.element).focus({preventScroll: true});
        }
        return view;
    }

    #drop(id, view) {
        const had = view.element.contains(document.activeElement);
        this.pictures.forget(view);
        view.element.remove();
        this.views.delete(id);
        this.stage.laid.delete(id);
        if (had) {
            this.ground.focus({preventScroll: true});
        }
    }

    #relayout() {
        this.#render();
        this.stage.layout();
        this.stage.fit();
    }

    tidy() {
        if (this.model.places.size > 0) {
            this.perform(forgetPlaces, {says: "All cards are laid out anew."});
        }
        this.stage.layout();
        this.stage.fit();
    }

    // Whether there is room for wires. Returns whether that has changed.
    #measure() {
        const {offsetWidth} = this.root, was = this.isList;
        this.isList = offsetWidth === 0 ? was : offsetWidth < NARROW;
        this.root.classList.toggle("is-list", this.isList);
        return this.isList !== was;
    }

    #resized() {
        const hasChanged = this.#measure(), isFirst = this.stage.laid.size === 0;
        if (this.model && this.root.offsetWidth > 0 && (hasChanged || isFirst && !this.isList)) {
            this.#render();
            if (isFirst) {
                this.stage.layout();
            } else {
                this.stage.place();
            }
            this.stage.fit({isFirst});
        }
    }

    viewOf(element) {
        const card = element?.closest?.(".graph-card");
        return card ? this.views.get(card.dataset.id) : null;
    }

    // Selection

    select(card) {
        if (typeof card === "number") {
            const {name} = this.model?.statements[card] ?? {};
            if (name !== undefined && name !== this.selectedName) {
                this.#mark(name);
                this.stage.reveal(name);
            }
            return;
        }
        const {name, index} = card.statement;
        if (name !== this.selectedName) {
            this.#mark(name);
            this.host.selected(index);
        }
    }

    #mark(name) {
        this.selectedName = name;
        for (const view of this.views.values()) {
            view.update(view.card, view.card.statement.name === name);
        }
        this.stage.place();
    }

    // Edits

    say(text) {
        this.said.textContent = text;
        this.said.classList.add("is-shown");
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.said.classList.remove("is-shown"), 3500);
    }

    // Does an edit if it is not refused. Returns whether it was done.
    perform(edit, {join = false, says = null, isQuiet = false} = {}) {
        if (this.isStale) {
            this.say("The text has an error; mend it first.");
            return false;
        }
        const result = edit(this.model, this.read);
        if (result.refusal) {
            if (!isQuiet) {
                this.say(`That does not go: ${result.refusal}.`);
            }
            return false;
        }
        this.host.edit(result.changes, {join});
        if (this.model.text !== result.document.text) {
            this.update(result.document);
        }
        if (says) {
            this.say(says);
        }
        return true;
    }

    openMenu(point, context) {
        if (this.isStale || !this.model) {
            this.say("The text has an error; mend it first.");
            return;
        }
        this.menu.open(point, {selected: this.model.byName.get(this.selectedName) ?? null, ...context});
    }

    // Does what was chosen in the menu, and selects what it made.
    take(offer, {wish}) {
        let name = null;
        this.perform((model, read) => {
            const result = offer.attempt(model, read);
            name = result.name;
            this.stage.wish = wish && !offer.isName ? {name, x: Math.round(wish[0]), y: Math.round(wish[1])}
                : null;
            this.selectedName = result.refusal || offer.isName ? this.selectedName : name;
            return result;
        }, {says: offer.isName ? `${offer.name} is plugged in` : `${offer.name} is added`});
        const view = this.views.get(name);
        if (view && !offer.isName) {
            this.host.selected(view.card.statement.index);
            view.element.focus({preventScroll: true});
            this.stage.reveal(name);
        }
    }

    extract(part) {
        let name = null;
        this.perform((model, read) => {
            const result = extract(model, read, part);
            name = result.name;
            return result;
        }, {says: "it is a statement of its own now"});
        this.views.get(name)?.element.focus({preventScroll: true});
    }

    rename(statement, name, edit) {
        const place = this.stage.laid.get(statement.name);
        this.perform((model, read) => {
            const result = edit(model, read);
            if (!result.refusal) {
                this.stage.laid.set(name, place);
                this.selectedName = name;
            }
            return result;
        }, {says: `${statement.name} is called ${name} now`});
        this.views.get(this.selectedName)?.element.focus({preventScroll: true});
    }

    spread(name) {
        if (!this.spreads.delete(name)) {
            this.spreads.add(name);
        }
        this.#relayout();
        this.views.get(name)?.element.focus({preventScroll: true});
    }

    undo() {
        this.host.undo();
        this.say("Undone.");
    }

    redo() {
        this.host.redo();
        this.say("Done again.");
    }
}

// Makes the graph in a container. Returns {update(document), select(entryIndex)}. Documents are as
// readDocument() has them. The host has
//   edit(changes, {join})   does {from, to, insert} each, as one step; with `join` it is a part of the
//                           last one
//   undo(), redo()
//   read(text)              the document of a text that may be there next
//   selected(entryIndex)    a statement was selected
//   picture(node, width, height, callback)   asks for a picture of a statement, or of PARTS plus a
//                           part, and returns what takes the wish back; callback({image, lowest,
//                           highest}) gets an ImageData, or what canvases draw
export function createGraph(container, host) {
    const graph = new Graph(container, host);
    return {update: document => graph.update(document), select: index => graph.select(index)};
}
