// SPDX-License-Identifier: MIT
//
// Numbers as sliders, which can be typed in, too; and numbers in formulas, which are dragged.
import {follow, make, typeInto} from "./dom.js";
import {intervalOf, setInterval, setText, setValue} from "./edits.js";
import {isCall, isNumber, numberText, textOf, within} from "./model.js";
import {isShortened} from "./rows.js";

const POSITIONS = 200; // of a slider whose scale is logarithmic
const DRAG = 4; // pixels of a drag for a step

// How a slider maps: {low, high, isLog, step}
function scaleOf([low, high]) {
    const isLog = low > 0 && high / low >= 100;
    const isWhole = Number.isInteger(low) && Number.isInteger(high) && high - low >= 8;
    return {low, high, isLog, step: isWhole ? 1 : 10 ** Math.floor(Math.log10((high - low) / 99))};
}

// The text of a number at a position of a slider
function textAtPosition(scale, position) {
    if (!scale.isLog) {
        return numberText(position, scale.step);
    }
    const value = scale.low * (scale.high / scale.low) ** (position / POSITIONS);
    return numberText(Number(value.toPrecision(value >= 1000 ? 3 : 2)), 1e-9);
}

function positionOf(scale, value) {
    return !scale.isLog ? value
        : POSITIONS * Math.log(Math.max(value, scale.low) / scale.low) /
            Math.log(scale.high / scale.low);
}

const isText = text => /^-?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text);

// A slider. `source` tells {value, text, interval, label, set(model, read, text)} of a row.
export class Slider {
    constructor(desk, source) {
        this.desk = desk;
        this.source = source;
        this.isHeld = false;
        this.hasBegun = false;
        this.range = make("input", {type: "range"});
        this.name = make("em");
        this.value = make("b");
        this.element = make("div", {class: "graph-number"}, this.range, this.name, this.value);
        this.#listen();
    }

    #listen() {
        const {range} = this;
        range.addEventListener("pointerdown", event => {
            [this.isHeld, this.hasBegun] = [true, false];
            follow(event, () => {}, () => this.#release());
        });
        range.addEventListener("input", () => {
            const text = textAtPosition(this.scale, Number(range.value));
            this.#set(text, this.isHeld && this.hasBegun);
            this.hasBegun = true;
        });
        range.addEventListener("change", () => this.#release());
        range.addEventListener("keydown", event => {
            if (event.key === "Enter") {
                event.preventDefault();
                this.type();
            }
        });
        this.element.addEventListener("dblclick", event => {
            event.stopPropagation();
            this.type();
        });
    }

    #release() {
        this.isHeld = false;
        this.update(this.row);
    }

    #set(text, join) {
        if (text !== this.source(this.row).text) {
            this.desk.perform((model, read) => this.source(this.row).set(model, read, text),
                {join, says: null});
        }
    }

    type() {
        const {text, label} = this.source(this.row);
        this.isHeld = false;
        typeInto(this.value, text, label, typed => {
            if (typed !== null && typed !== text) {
                if (isText(typed)) {
                    this.#set(typed, false);
                } else {
                    this.desk.say(`${typed} is no number`);
                }
            }
        });
    }

    update(row) {
        this.row = row;
        const {value, text, interval, label} = this.source(row), {range} = this;
        if (!this.isHeld || this.scale === undefined) {
            this.scale = scaleOf(interval);
        }
        const {low, high, isLog, step} = this.scale;
        const ends = isLog ? [0, POSITIONS, 1] : [low, high, step];
        ["min", "max", "step"].forEach((name, i) => {
            range[name] = name === "step" && this.isHeld ? "any" : ends[i];
        });
        const position = positionOf(this.scale, value);
        if (!this.isHeld) {
            range.value = position;
        }
        range.setAttribute("aria-label", label);
        range.setAttribute("aria-valuetext", text);
        range.style.setProperty("--part", `${100 * (position - ends[0]) / (ends[1] - ends[0])}%`);
        this.name.textContent = row.label ?? "";
        this.value.textContent = text;
    }
}

// A number of the text, as the source of a slider
export const partSource = desk => ({part, label}) => ({value: part.value,
    text: textOf(desk.model, part), interval: intervalOf(part),
    label: `${label || "number"} of ${part.statement.name}`,
    set: (model, read, text) => setText(model, read, part.span, text)});

const isTold = ([low, high]) => low > -1e59 && high < 1e59 && low < high;

export const paramSource = desk => ({statement}) => ({value: statement.value,
    text: desk.model.text.slice(...statement.valueSpan),
    interval: isTold(statement.slider) ? statement.slider
        : intervalOf({value: statement.value, slot: null}),
    label: statement.name, set: (model, read, text) => setValue(model, read, statement, text)});

// The ends of a parameter's interval, as fields
export class Interval {
    constructor(desk) {
        this.fields = ["lowest", "highest"].map((name, i) => make("input", {type: "text",
            inputmode: "decimal", onchange: () => this.#set(desk), "aria-label": name, "data-i": i}));
        this.element = make("div", {class: "graph-interval"}, "from ", this.fields[0], " to ",
            this.fields[1]);
    }

    #set(desk) {
        const [lowest, highest] = this.fields.map(field => field.value.trim());
        if (!isText(lowest) || !isText(highest)) {
            desk.say("an interval has two numbers");
            this.update(this.row);
            return;
        }
        const done = desk.perform((model, read) =>
            setInterval(model, read, this.row.statement, lowest, highest),
        {says: `${this.row.statement.name} goes from ${lowest} to ${highest}`});
        if (!done) {
            this.update(this.row);
        }
    }

    update(row) {
        this.row = row;
        const {slider, name} = row.statement;
        this.fields.forEach((field, i) => {
            field.value = isTold(slider) ? numberText(slider[i], 1e-9) : "";
            field.setAttribute("aria-label", `${i === 0 ? "lowest" : "highest"} ${name}`);
        });
    }
}

// The parts of a formula that are shown as what they are: names, numbers, and calls as name(…)
function* pieces(model, part) {
    if (part.children.length === 0 || isShortened(model, part)) {
        yield part;
    } else {
        for (const child of part.children) {
            yield* pieces(model, child);
        }
    }
}

// A formula as one line of text
export class Formula {
    constructor(desk) {
        this.desk = desk;
        this.code = make("code");
        this.element = this.code;
        this.code.addEventListener("pointerdown", event => this.#drag(event));
    }

    update(row) {
        this.row = row;
        const {model} = this.desk, {part} = row;
        const line = row.label ? [`${row.label}: `] : [];
        let at = part.span[0];
        for (const piece of pieces(model, part)) {
            const isShort = isCall(piece), [from, to] = piece.span;
            line.push(model.text.slice(at, from).replace(/\s+/g, " "));
            line.push(make(isShort ? "i" : isNumber(piece) ? "s" : "u", {"data-part": piece.index},
                isShort ? `${piece.name}(…)` : model.text.slice(from, to)));
            at = to;
        }
        this.code.replaceChildren(...line, model.text.slice(at, part.span[1]).replace(/\s+/g, " "));
    }

    #drag(event) {
        const held = event.target.closest("s");
        if (event.button !== 0 || held === null || this.desk.isStale) {
            return;
        }
        event.preventDefault();
        event.stopPropagation();
        const index = [...this.code.querySelectorAll("s")].indexOf(held);
        const number = () => [...within(this.row.part)].filter(isNumber)
            .find(part => part.index === Number(this.code.querySelectorAll("s")[index].dataset.part));
        const {value} = number(), size = Math.abs(value);
        const step = 10 ** (Math.floor(Math.log10(size || 1)) - 1);
        let hasBegun = false;
        follow(event, ({clientX}) => {
            const part = number();
            const text = numberText(value + Math.round((clientX - event.clientX) / DRAG) * step, step);
            if (text !== textOf(this.desk.model, part)) {
                this.desk.perform((model, read) => setText(model, read, part.span, text),
                    {join: hasBegun, says: null});
                hasBegun = true;
            }
        });
    }
}
