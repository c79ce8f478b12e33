// SPDX-License-Identifier: MIT
//
// Words of a call as selects and boxes, and selects that add something to a call or to a formula.
import {addArgument, missing, setWord} from "./arguments.js";
import {make} from "./dom.js";
import {addOperand} from "./edits.js";
import {functionOf} from "./model.js";

const shown = word => word.replaceAll("_", " ");

// A select or a box for each argument that is a word
export class Words {
    constructor(desk, row) {
        this.desk = desk;
        this.row = row;
        this.slots = functionOf(desk.model, row.part).arguments.filter(slot => slot.words !== null);
        this.fields = this.slots.map(slot => slot.words.length === 1 ? this.#box(slot)
            : this.#select(slot));
        this.element = make("div", {class: "graph-words"}, ...this.fields.map(({whole}) => whole));
    }

    #set(slot, word) {
        const done = this.desk.perform((model, read) =>
            setWord(model, read, this.row.part, this.#now(slot), word),
        {says: `${slot.name}: ${word || "the usual one"}`});
        if (!done) {
            this.update(this.row);
        }
    }

    // The same argument of the table that came with the newest text
    #now(slot) {
        return functionOf(this.desk.model, this.row.part).arguments.find(
            ({name}) => name === slot.name);
    }

    #box(slot) {
        const field = make("input", {type: "checkbox", title: slot.text, onchange: () =>
            this.#set(slot, field.checked ? slot.words[0] : "")});
        return {field, whole: make("label", {title: slot.text}, field, slot.words[0])};
    }

    #select(slot) {
        const field = make("select", {"aria-label": slot.name, title: slot.text,
            onchange: () => this.#set(slot, field.value)},
        make("option", {value: ""}, `usual ${slot.name}`),
        ...slot.words.map(word => make("option", {value: word}, shown(word))));
        return {field, whole: field};
    }

    update(row) {
        this.row = row;
        this.fields.forEach(({field}, i) => {
            const {name} = this.slots[i];
            const given = row.part.children.find(child => child.kind === "word" &&
                child.slot?.name === name);
            if (field.type === "checkbox") {
                field.checked = given !== undefined;
            } else {
                field.value = given?.name ?? "";
                field.classList.toggle("is-usual", given === undefined);
            }
        });
    }
}

// A select that does something and shows its title again. `list` tells [value, text] when opened.
class Adder {
    constructor(title, label, list, choose) {
        const first = make("option", {value: ""}, title);
        this.element = make("select", {class: "graph-adder", "aria-label": label,
            onfocus: () => this.fill(), onpointerdown: () => this.fill(),
            onblur: () => this.element.replaceChildren(first),
            onchange: () => {
                const {value} = this.element;
                this.element.value = "";
                choose(value);
            }}, first);
        this.fill = () => {
            if (this.element.options.length === 1) {
                this.element.append(...list().map(([value, text]) => make("option", {value}, text)));
            }
        };
    }

    update() {}
}

// "+ parameter": arguments that the call may have and has not
export class More extends Adder {
    constructor(desk, row) {
        const slot = name => missing(desk.model, this.row.part).find(other => other.name === name);
        super("+ parameter", "Add a parameter", () => missing(desk.model, this.row.part)
            .filter(other => !addArgument(desk.model, desk.read, this.row.part, other).refusal)
            .map(({name, text}) => [name, `${name}: ${text}`]),
        name => desk.perform((model, read) => addArgument(model, read, this.row.part, slot(name)),
            {says: `${name} can be set now`}));
        this.row = row;
    }

    update(row) {
        this.row = row;
    }
}

const OPERANDS = {"+": ["0", "+ a term"], "-": ["0", "− a term"], "*": ["1", "× a factor"],
    "/": ["1", "÷ a divisor"]};

// "+ term": another operand of a formula
export class Operands extends Adder {
    constructor(desk, row) {
        super("+ term", "Add to the formula",
            () => Object.entries(OPERANDS).map(([sign, [, text]]) => [sign, text]),
            sign => desk.perform((model, read) =>
                addOperand(model, read, this.row.part, sign, OPERANDS[sign][0]),
            {says: `${OPERANDS[sign][1]} more`}));
        this.row = row;
    }

    update(row) {
        this.row = row;
    }
}
