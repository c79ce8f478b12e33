// SPDX-License-Identifier: MIT
//
// The panel: fields for the parameters of the recipe, and for raster and light, in groups that
// fold.
import {GROUPS, parseNumber} from "./options.js";

const STEPS = 1000; // of a slider whose scale is logarithmic

function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (value !== undefined && value !== false) {
            made.setAttribute(key, value === true ? "" : value);
        }
    }
    made.append(...children);
    return made;
}

// The number that a slider stands for, in as few digits as its step has
function ofSlider(row, position) {
    if (row.scale !== "log") {
        return String(Number(Number(position).toFixed(6)));
    }
    const [low, high] = row.slider;
    return String(Number((low * (high / low) ** (position / STEPS)).toPrecision(3)));
}

function toSlider(row, number) {
    if (row.scale !== "log") {
        return number;
    }
    const [low, high] = row.slider;
    return Math.round(STEPS * Math.log(Math.max(number, low) / low) / Math.log(high / low));
}

// One row: a name, a slider for numbers, a text. change(name, text, isDragging) gets what is typed
// or dragged, begin() is called when a drag begins; undefined: back to the default.
class Field {
    constructor(row, change, begin = () => {}) {
        const id = `p-${row.name}`, isLog = row.scale === "log";
        this.row = row;
        this.input = element("input", {type: "text", id, spellcheck: "false", autocomplete: "off",
            inputmode: row.kind === "seed" ? "numeric" : "text",
            "aria-describedby": `${id}-message`});
        this.slider = row.slider && element("input", {type: "range", id: `${id}-slider`,
            "aria-label": row.label, min: isLog ? 0 : row.slider[0],
            max: isLog ? STEPS : row.slider[1], step: isLog ? 1 : row.step});
        this.message = element("p", {class: "message", id: `${id}-message`, role: "alert"});
        this.back = row.standard && element("button", {type: "button", class: "back",
            title: "Back to the default", "aria-label": `${row.label}: back to the default`}, "↺");
        const label = element("label", {for: id, title: row.hint}, row.label);
        this.box = element("div", {class: `field ${row.kind}`, "data-name": row.name}, label,
            ...(this.slider ? [this.slider] : []), this.input, ...(this.back ? [this.back] : []),
            this.message);
        this.input.addEventListener("input", () =>
            change(row.name, this.input.value.trim(), false));
        this.back?.addEventListener("click", () => change(row.name, undefined, false));
        for (const name of ["pointerdown", "keydown"]) {
            this.slider?.addEventListener(name, begin);
        }
        for (const name of ["input", "change"]) {
            this.slider?.addEventListener(name, () =>
                change(row.name, ofSlider(row, this.slider.value), name === "input"));
        }
    }

    // Shows a text. A field that is being typed in keeps its own.
    show(text, isGiven, message) {
        const {row, input, slider} = this;
        if (document.activeElement !== input || input.value.trim() === "") {
            input.value = text;
        }
        if (slider && document.activeElement !== slider) {
            slider.value = toSlider(row, Number(text));
        }
        slider?.setAttribute("aria-valuetext", text);
        this.tell(message);
        this.box.classList.toggle("given", isGiven);
        if (this.back) {
            this.back.disabled = !isGiven;
        }
    }

    tell(message) {
        if (this.message.textContent !== message) {
            this.message.textContent = message;
        }
        this.input.setAttribute("aria-invalid", String(message !== ""));
        this.box.classList.toggle("wrong", message !== "");
    }
}

// The row of a parameter; its slider has the interval, or what is near its number.
function rowOf({name, value, slider: [lowest, highest]}) {
    const far = Math.max(2 * Math.abs(value), 1), isBounded = highest - lowest < 1e9;
    const slider = isBounded ? [lowest, highest] : [value - far, value + far];
    const step = Number(((slider[1] - slider[0]) / 500).toPrecision(1));
    return {name, kind: "float", label: name, slider, step,
        hint: isBounded ? `from ${lowest} to ${highest}` : "any number"};
}

// change() is for options, setParam(entry, text, isDragging, isFirst) for numbers in the text.
export class Controls {
    constructor(form, params, change, setParam) {
        this.fields = [];
        this.params = {box: params, key: null, fields: [], entries: []};
        this.setParam = setParam;
        for (const group of GROUPS) {
            const fields = group.rows.map(row => new Field(row, change));
            const box = element("div", {role: "group", "aria-label": group.title},
                ...fields.map(field => field.box));
            form.append(element("details", {class: "group", id: `g-${group.id}`},
                element("summary", {}, group.title), box));
            this.fields.push(...fields);
        }
        form.addEventListener("submit", event => event.preventDefault());
    }

    show(given, messages, document_) {
        for (const field of this.fields) {
            const {name, standard} = field.row, text = given[name];
            field.show(text ?? standard, text !== undefined && text !== standard,
                messages.get(name) ?? "");
        }
        for (const {id, rows} of GROUPS) {
            const {classList} = document.getElementById(`g-${id}`);
            classList.toggle("has-wrong", rows.some(row => messages.has(row.name)));
            classList.toggle("has-given", rows.some(({name}) => name in given && name !== "seed"));
        }
        this.showParams(document_);
    }

    // Fields are made anew where the parameters are others. Those of a text with errors stay.
    showParams({entries, ok}) {
        const {params} = this, list = entries.filter(entry => entry.isParam);
        const key = JSON.stringify(list.map(({name, slider}) => [name, slider]));
        if (key !== params.key && (ok || list.length >= params.fields.length)) {
            params.fields = list.map(entry => this.paramField(entry));
            params.box.replaceChildren(...params.fields.map(field => field.box));
            params.key = key;
        }
        params.entries = list;
        params.box.hidden = params.fields.length === 0;
        for (const field of params.fields) {
            const entry = list.find(({name}) => name === field.row.name);
            if (entry) {
                field.show(String(entry.value), false, "");
            }
        }
    }

    paramField(first) {
        let isFirst = true;
        const row = rowOf(first), field = new Field(row, (name, text, isDragging) => {
            const entry = this.params.entries.find(each => each.name === name);
            if (!entry || Number.isNaN(parseNumber(text))) {
                field.tell(entry ? "is no number" : "the text has an error");
                return;
            }
            const [lowest, highest] = entry.slider, number = Number(text);
            if (number < lowest || number > highest) {
                field.tell(`is not a number from ${lowest} to ${highest}`);
                return;
            }
            this.setParam(entry, text, isDragging, isFirst);
            isFirst = !isDragging;
        }, () => {
            isFirst = true;
        });
        return field;
    }
}
