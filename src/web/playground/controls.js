// SPDX-License-Identifier: MIT
//
// The side panel: a field for each row of the table of parameters, in groups that fold.
import {GROUPS} from "./parameters.js";
import {NOISE, defaultText, numberOf, textOf} from "./state.js";

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

const isNumber = row => row.slider !== undefined;

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

function makeSlider(row, id) {
    const isLog = row.scale === "log", [low, high] = row.slider;
    return element("input", {type: "range", id: `${id}-slider`, "aria-label": row.label,
        min: isLog ? 0 : low, max: isLog ? STEPS : high, step: isLog ? 1 : row.step});
}

function makeInput(row, id) {
    if (row.kind === "choice") {
        return element("select", {id}, ...row.choices.map(word =>
            element("option", {value: word}, word)));
    }
    if (row.kind === "flag") {
        return element("input", {type: "checkbox", id});
    }
    return element("input", {type: "text", id, spellcheck: "false",
        inputmode: row.kind === "seed" ? "numeric" : "text", placeholder: row.unset,
        "aria-describedby": `${id}-message`});
}

// One row of the panel
class Field {
    constructor(row, change) {
        const id = `p-${row.name}`;
        this.row = row;
        this.input = makeInput(row, id);
        this.slider = isNumber(row) ? makeSlider(row, id) : null;
        this.message = element("p", {class: "message", id: `${id}-message`, role: "alert"});
        this.back = element("button", {type: "button", class: "back", title: "Back to the default",
            "aria-label": `${row.label}: back to the default`}, "↺");
        const label = element("label", {for: id, title: row.hint}, row.label);
        this.box = element("div", {class: `field ${row.kind}`, "data-name": row.name}, label,
            ...(this.slider ? [this.slider] : []), this.input, this.back, this.message);
        this.input.addEventListener(row.kind === "flag" || row.kind === "choice" ? "change"
            : "input", () => change(row.name, this.typed(), false));
        this.slider?.addEventListener("input", () =>
            change(row.name, ofSlider(row, this.slider.value), true));
        this.slider?.addEventListener("change", () =>
            change(row.name, ofSlider(row, this.slider.value), false));
        this.back.addEventListener("click", () => change(row.name, undefined, false));
    }

    typed() {
        if (this.row.kind === "flag") {
            return this.input.checked ? "1" : "0";
        }
        const text = this.input.value.trim();
        return text === "" ? (this.row.unset ? null : "") : text;
    }

    // Shows a text, which is the default unless it was given; null: unset. A field that is being typed
    // in keeps its text.
    show({text, isGiven, message}) {
        const {row, input} = this;
        if (row.kind === "flag") {
            input.checked = text === true || text === "1";
        } else if (document.activeElement !== input || input.value.trim() === "") {
            input.value = text ?? "";
        }
        if (this.slider && document.activeElement !== this.slider) {
            this.slider.value = toSlider(row, text === null ? row.slider[0] : Number(text));
        }
        this.slider?.setAttribute("aria-valuetext", text ?? row.unset);
        if (this.message.textContent !== message) {
            this.message.textContent = message;
        }
        input.setAttribute("aria-invalid", String(message !== ""));
        this.box.classList.toggle("wrong", message !== "");
        this.box.classList.toggle("given", isGiven);
        this.box.classList.toggle("unset", text === null);
        this.back.disabled = !isGiven;
    }
}

// The row of a parameter of a recipe; its slider has the interval, or what is near its number.
function rowOf({name, value, lowest, highest}) {
    const far = Math.max(2 * Math.abs(value), 1);
    const isBounded = highest - lowest < 1e9;
    const slider = isBounded ? [lowest, highest] : [value - far, value + far];
    const step = Number(((slider[1] - slider[0]) / 500).toPrecision(1));
    return {name, kind: "float", label: name, slider, step,
        hint: isBounded ? `from ${lowest} to ${highest}` : "any number"};
}

// The panel. change(name, text, isDragging) gets what is typed or dragged, setValue() that of a
// parameter; undefined: take it back.
export class Controls {
    constructor(form, params, change, setValue) {
        this.fields = [];
        this.params = {box: params, key: null, fields: []};
        this.setValue = setValue;
        for (const group of GROUPS) {
            const fields = group.rows.map(row => new Field(row, change));
            const box = element("div", {role: "group", "aria-label": group.title},
                ...fields.map(field => field.box));
            const details = element("details", {class: "group", id: `g-${group.id}`,
                open: Boolean(group.open)}, element("summary", {}, group.title), box);
            form.append(details);
            this.fields.push(...fields);
        }
        form.addEventListener("submit", event => event.preventDefault());
    }

    show(state, {messages, params}) {
        const noise = {basis: textOf(state, "basis"), fractal: textOf(state, "fractal"),
            octaves: numberOf(state, "octaves")};
        for (const field of this.fields) {
            const {row} = field, given = state.given[row.name];
            const isGiven = given !== undefined &&
                String(given) !== String(defaultText(state, row.name) ?? null);
            const message = messages.get(row.name) ?? "";
            field.show({text: textOf(state, row.name), isGiven, message});
            field.box.hidden = !(!row.serves || row.serves(noise) || isGiven) && message === "";
        }
        for (const {id, rows, ofNoise} of GROUPS) {
            const group = document.getElementById(`g-${id}`);
            group.hidden = Boolean(ofNoise) && state.preset !== NOISE;
            group.classList.toggle("has-wrong", rows.some(row => messages.has(row.name)));
            group.classList.toggle("has-given", rows.some(row => row.name in state.given &&
                row.name !== "seed"));
        }
        this.showParams(state, params, messages);
    }

    // Fields are made anew where the parameters are others. Those of a text with errors stay.
    showParams(state, params, messages) {
        const {box} = this.params, isNoise = state.preset === NOISE;
        const key = JSON.stringify(params.map(({name, lowest, highest}) => [name, lowest, highest]));
        if (key !== this.params.key && !(params.length === 0 && messages.has("recipe"))) {
            const fields = params.map(param => new Field(rowOf(param), this.setValue));
            box.replaceChildren(...fields.map(field => field.box));
            Object.assign(this.params, {key, fields});
        }
        box.hidden = isNoise || this.params.fields.length === 0;
        for (const field of this.params.fields) {
            const {name} = field.row, param = params.find(each => each.name === name);
            const given = state.values[name], standard = param ? String(param.value) : "";
            field.show({text: given ?? standard, isGiven: given !== undefined,
                message: messages.get(`=${name}`) ?? ""});
        }
    }
}
