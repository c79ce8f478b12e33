// SPDX-License-Identifier: MIT
//
// Cards as elements. A card is built anew only if its rows are others than before, so that what is
// held or focused stays while its numbers change.
import {Curve} from "./curve.js";
import {make, typeInto} from "./dom.js";
import {bypass, inline, remove, rename, toggleOut} from "./edits.js";
import {isNumber, shortNumber, textOf} from "./model.js";
import {kindText} from "./offers.js";
import {Formula, Interval, Slider, paramSource, partSource} from "./numbers.js";
import {Plug} from "./plugs.js";
import {isShortened} from "./rows.js";
import {More, Operands, Words} from "./words.js";

export const PICTURE = [196, 84]; // pixels

// What of a card decides how it is built: all but numbers and names that are plugged in
function shapeOf(model, card) {
    const words = ({part}) => part ? [part.name, part.children.length] : [];
    return JSON.stringify([card.isSub, card.isSpread, card.canSpread, card.node >= 0,
        card.rows.map(row => [row.type, row.label, row.isInFormula, row.depth, row.id,
            row.type === "words" || row.type === "more" ? words(row) : 0,
            row.type === "head" ? row.text : 0])]);
}

const kindClass = type => ({number: "is-number", noise: "is-noise"}[type] ?? "is-field");

// A button that makes a part a statement of its own, and one that takes a call away
function sectionButtons(desk, rowOf) {
    const name = make("button", {type: "button", class: "graph-small", title:
        "Make this a statement of its own", onclick: () => desk.extract(rowOf().part)}, "name");
    const away = make("button", {type: "button", class: "graph-small", title:
        "Take this away and keep what it changes", "aria-label": "Take away", onclick: () =>
        desk.perform((model, read) => bypass(model, read, rowOf().part), {says: "taken away"})}, "×");
    return [name, away];
}

const makers = {
    value: (desk, row, view) => {
        const slider = new Slider(desk, paramSource(desk)), interval = new Interval(desk);
        view.content.push(slider.element, interval.element);
        view.parts.push(slider, interval);
    },
    number: (desk, row, view) => {
        const slider = new Slider(desk, partSource(desk));
        const plug = new Plug(desk, row.part, row.label);
        view.content.push(slider.element, plug.element);
        view.parts.push(slider, {update: ({part}) => plug.update(part)});
        view.isPlace = true;
    },
    input: (desk, row, view) => {
        const label = make("em", {}, row.label ?? ""), plug = new Plug(desk, row.part, row.label);
        view.content.push(label, plug.element);
        view.parts.push({update: ({part}) => plug.update(part)});
        view.isPlace = true;
    },
    link: (desk, row, view) => {
        const what = make("b");
        view.content.push(make("em", {}, row.label ?? ""), what);
        view.parts.push({update: ({part}) => {
            what.textContent = kindText(desk.model, part);
        }});
        view.isPlace = true;
    },
    formula: (desk, row, view) => {
        const formula = new Formula(desk);
        view.content.push(formula.element);
        view.parts.push(formula);
        if (row.depth > 0 || row.label) {
            view.content.push(...sectionButtons(desk, () => view.row));
        }
    },
    head: (desk, row, view) => {
        const title = make("span");
        view.content.push(title, ...sectionButtons(desk, () => view.row));
        view.parts.push({update: ({label, text}) => {
            title.textContent = label ? `${label}: ${text}` : text;
        }});
    },
    words: (desk, row, view) => view.add(new Words(desk, row)),
    curve: (desk, row, view) => view.add(new Curve(desk)),
    more: (desk, row, view) => view.add(new More(desk, row)),
    operands: (desk, row, view) => view.add(new Operands(desk, row)),
    brief: (desk, row, view) => view.addText(),
    note: (desk, row, view) => view.addText(),
};

class RowView {
    constructor(desk, row, card) {
        Object.assign(this, {row, content: [], parts: [], isPlace: false});
        makers[row.type](desk, row, this);
        this.element = make("div", {class: `graph-row is-${row.type}${row.depth > 0 ? " is-deep" : ""}${
            row.isInFormula ? " is-in-formula" : ""}`});
        if (this.isPlace) {
            this.socket = make("span", {class: "graph-socket", "aria-hidden": "true"});
            this.socket.addEventListener("pointerdown", event =>
                desk.wires.start(event, {card: card.card, row: this.row}));
            this.element.append(this.socket);
        }
        this.element.append(...this.content);
        this.element.addEventListener("pointerenter", () => card.mark(this.row.part));
        this.element.addEventListener("pointerleave", () => card.mark(null));
        this.desk = desk;
    }

    add(part) {
        this.content.push(part.element);
        this.parts.push(part);
    }

    addText() {
        const text = make("p");
        this.content.push(text);
        this.parts.push({update: row => {
            text.textContent = row.text;
        }});
    }

    update(row) {
        this.row = row;
        this.parts.forEach(part => part.update(row));
        if (this.socket) {
            const {part} = row, isPlugged = row.type === "link" || part.entry >= 0;
            const type = part.slot?.kind === "noise" ? "noise" : part.kind;
            this.socket.className = `graph-socket ${kindClass(type)}${isPlugged ? "" : " is-free"}`;
        }
    }
}

// Actions of a statement's card, as a native select
function actionSelect(desk, view) {
    const list = [["", "⋯"], ["rename", "Rename (F2)"], ["below", "Add what comes from it"],
        ["inline", "Put into its uses (Ctrl+Delete)"], ["remove", "Delete (Delete)"]];
    const select = make("select", {class: "graph-actions", "aria-label": "Actions", onchange: () => {
        const {value} = select;
        select.value = "";
        view.act(value);
    }}, ...list.map(([value, text]) => make("option", {value}, text)));
    return select;
}

export class CardView {
    constructor(desk, card) {
        this.desk = desk;
        this.card = card;
        this.shape = shapeOf(desk.model, card);
        this.name = make("b");
        this.kind = make("i");
        this.socket = make("span", {class: "graph-socket is-out", "aria-hidden": "true"});
        this.top = make("div", {class: "graph-top"}, this.name, this.kind, ...this.#buttons(),
            this.socket);
        this.rowsElement = make("div", {class: "graph-rows"});
        this.element = make("article", {class: "graph-card", tabindex: 0, "data-id": card.id},
            this.top, ...this.#picture(), this.rowsElement);
        this.rows = card.rows.map(row => new RowView(desk, row, this));
        this.rowsElement.append(...this.rows.map(row => row.element));
        this.#listen();
    }

    #buttons() {
        const {desk, card} = this;
        const button = (text, title, onclick) => make("button", {type: "button",
            class: "graph-small", title, "aria-label": title, onclick}, text);
        if (card.isSub) {
            return [button("name", "Make this a statement of its own", () => this.act("extract"))];
        }
        this.out = card.statement.isParam ? null : button("out", "An output of the recipe", () =>
            this.act("out"));
        this.spread = card.canSpread ? button(card.isSpread ? "⊟" : "⊞",
            card.isSpread ? "Fold into one card" : "Spread out: operators as cards", () =>
                desk.spread(this.card.statement.name)) : null;
        return [this.out, this.spread, actionSelect(desk, this)].filter(Boolean);
    }

    #picture() {
        if (this.card.node < 0) {
            return [];
        }
        const [width, height] = PICTURE;
        this.canvas = make("canvas", {width, height});
        this.range = make("span");
        this.picture = make("div", {class: "graph-picture"}, this.canvas, this.range);
        return [this.picture];
    }

    #listen() {
        const {desk, element, top, socket, name} = this;
        socket.addEventListener("pointerdown", event => desk.wires.start(event, {card: this.card}));
        top.addEventListener("pointerdown", event => desk.stage.startDrag(event, this));
        name.addEventListener("dblclick", event => {
            event.stopPropagation();
            this.act("rename");
        });
        element.addEventListener("pointerdown", event => this.#pressed(event));
        element.addEventListener("focusin", () => {
            if (!desk.keys.isPressed) {
                desk.select(this.card);
                desk.stage.reveal(this.card.id);
            }
        });
        element.addEventListener("keydown", event => desk.keys.press(event, this));
    }

    // A card that is selected opens; what is held must not move away, so then it opens afterwards.
    #pressed({target}) {
        const pick = () => desk.views.get(this.card.id) && desk.select(desk.views.get(this.card.id).card);
        const {desk} = this;
        if (target.closest("select, input, button, .graph-socket, [data-part], [data-knot]")) {
            addEventListener("pointerup", () => setTimeout(pick), {once: true});
        } else {
            pick();
        }
    }

    act(what) {
        const {desk, card} = this, {statement} = card, {name} = statement;
        if (what === "rename" && !card.isSub) {
            this.#rename();
        } else if (what === "below") {
            desk.openMenu(this.element.getBoundingClientRect(), {source: statement});
        } else if (what === "extract") {
            desk.extract(card.part);
        } else if (what === "out") {
            desk.perform((model, read) => toggleOut(model, read, statement),
                {says: `${name} is ${statement.isExplicitOut ? "no output now" : "an output"}`});
        } else if (what === "inline" && !card.isSub) {
            desk.perform((model, read) => inline(model, read, statement),
                {says: `${name} stands in its uses now`});
        } else if (what === "remove" || what === "inline") {
            const {length} = statement.uses;
            desk.perform((model, read) => card.isSub ? bypass(model, read, card.part)
                : remove(model, read, statement), {says: card.isSub ? "taken away"
                : `${name} is deleted${length > 0 ? `; ${length} input${length > 1 ? "s" : ""
                } lost it` : ""}`});
        }
    }

    #rename() {
        const {desk, card: {statement}} = this;
        typeInto(this.name, statement.name, `Name instead of ${statement.name}`, name => {
            if (name !== null && name !== statement.name) {
                desk.rename(statement, name, (model, read) => rename(model, read, statement, name));
            } else {
                this.element.focus({preventScroll: true});
            }
        });
    }

    // Marks the part of a formula that a row is about
    mark(part) {
        for (const piece of this.element.querySelectorAll("[data-part]")) {
            piece.classList.toggle("is-marked", part !== null && part !== undefined &&
                Number(piece.dataset.part) === part.index);
        }
    }

    fits(card) {
        return this.shape === shapeOf(this.desk.model, card);
    }

    update(card, isSelected) {
        this.card = card;
        const {element, statement} = {element: this.element, statement: card.statement};
        const isOutput = !card.isSub && statement.output >= 0;
        this.name.textContent = card.title;
        this.kind.textContent = card.kind;
        this.socket.className = `graph-socket is-out ${kindClass(card.type)}`;
        element.className = ["graph-card", kindClass(card.type), card.isSub && "is-sub",
            isOutput && "is-output", statement.isParam && "is-param", isSelected && "is-selected",
            element.classList.contains("is-dragged") && "is-dragged"].filter(Boolean).join(" ");
        this.out?.setAttribute("aria-pressed", isOutput);
        element.setAttribute("aria-label", this.#spoken(card));
        card.rows.forEach((row, i) => this.rows[i].update(row));
        for (const field of element.querySelectorAll("input, select, button, circle")) {
            field.tabIndex = isSelected ? 0 : -1;
        }
    }

    #spoken(card) {
        const names = card.rows.filter(row => row.type === "input").map(row =>
            textOf(this.desk.model, row.part));
        return [card.title, card.kind, card.statement.output >= 0 && !card.isSub ? "output" : "",
            names.length > 0 ? `from ${names.join(", ")}` : "", card.note].filter(Boolean).join(", ");
    }

    showPicture({image, lowest, highest}) {
        const context = this.canvas.getContext("2d");
        if (image instanceof ImageData) {
            [this.canvas.width, this.canvas.height] = [image.width, image.height];
            context.putImageData(image, 0, 0);
        } else if (image) {
            context.drawImage(image, 0, 0, this.canvas.width, this.canvas.height);
        }
        this.range.textContent = `${shortNumber(lowest)} … ${shortNumber(highest)}`;
    }
}

// A part that a wire may be dropped on, under a point: an input, a number, or a piece of a formula
export function placeUnder(model, target, view) {
    const piece = target.closest("[data-part]");
    if (piece) {
        const part = model.parts[Number(piece.dataset.part)];
        return isNumber(part) || !isShortened(model, part) ? part : null;
    }
    const row = target.closest(".graph-row");
    const found = view.rows.find(({element, isPlace}) => element === row && isPlace);
    return found ? found.row.part : null;
}

