// SPDX-License-Identifier: MIT
//
// The select of an input: what is plugged in, what else fits, and what can be done with the place.
// It is the way to wire by keyboard, by screen reader and on a phone. What fits is found when it is
// opened, since each name is tried.
import {removeArgument} from "./arguments.js";
import {make} from "./dom.js";
import {dropOperand, extract, unplug, wire} from "./edits.js";
import {isNumber, isUse, textOf} from "./model.js";

const isOperand = part => part.above !== null && part.above.operation !== "" &&
    part.above.children.length === 2;

// What can be done with a part, as [key, label, edit]
function actionsOf(part) {
    const list = [];
    if (isUse(part)) {
        list.push(["unplug", "take it away", (m, r, p) => unplug(m, r, p)]);
    }
    if (isOperand(part)) {
        list.push(["drop", "remove from the formula", (m, r, p) => dropOperand(m, r, p)]);
    } else if (part.slot !== null && !part.slot.isNeeded) {
        list.push(["argument", "remove this argument", (m, r, p) => removeArgument(m, r, p)]);
    }
    if (isNumber(part)) {
        list.push(["param", "make it a parameter", (m, r, p) => extract(m, r, p)]);
    }
    return list;
}

// Names that fit in the place of a part
const namesFor = (desk, part) => desk.model.statements.filter(statement =>
    statement.index !== part.entry && statement !== part.statement &&
    !wire(desk.model, desk.read, statement, part).refusal).map(({name}) => name);

export class Plug {
    constructor(desk, part, label) {
        this.desk = desk;
        this.label = label;
        this.element = make("select", {class: "graph-plug", onfocus: () => this.fill(),
            onpointerdown: () => this.fill(), onchange: () => this.choose(),
            onblur: () => this.update(this.part)});
        this.update(part);
    }

    update(part) {
        this.part = part;
        this.now = isNumber(part) ? "number" : textOf(this.desk.model, part);
        this.element.setAttribute("aria-label", `${this.label || "input"} of ${
            part.statement.name}: ${isNumber(part) ? "a number; plug in" : "from"}`);
        if (document.activeElement !== this.element || this.element.value !== this.now) {
            this.element.replaceChildren(make("option", {value: this.now}, this.now));
        }
    }

    fill() {
        if (this.element.options.length > 1 || this.desk.isStale) {
            return;
        }
        const option = (value, text) => make("option", {value}, text);
        const names = namesFor(this.desk, this.part);
        this.element.append(...names.map(name => option(`=${name}`, name)),
            make("hr"), option("new", "new …"),
            ...actionsOf(this.part).map(([key, text]) => option(key, text)));
    }

    choose() {
        const {value} = this.element, {desk, part} = this;
        this.element.value = this.now;
        if (value === "new") {
            desk.openMenu(this.element.getBoundingClientRect(), {target: part});
        } else if (value.startsWith("=")) {
            const source = desk.model.byName.get(value.slice(1));
            desk.perform((model, read) => wire(model, read, source, part),
                {says: `${source.name} goes to ${part.statement.name}`});
        } else {
            const action = actionsOf(part).find(([key]) => key === value);
            if (action) {
                desk.perform((model, read) => action[2](model, read, part),
                    {says: `${action[1]}: done`});
            }
        }
    }
}
