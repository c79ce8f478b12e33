// SPDX-License-Identifier: MIT
//
// The side panel: a field for each row of the table of parameters, in groups that fold.
import {GROUPS} from "./parameters.js";
import {defaultText, numberOf, textOf} from "./state.js";

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
        this.back = element("button", {type: "button", class: "back", title: "Back to the preset",
            "aria-label": `${row.label}: back to the preset`}, "↺");
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

    // Shows the state. A field that is being typed in keeps its text.
    show(state, {options, messages, noise}) {
        const {row, input} = this, text = textOf(state, row.name), inherited = options[row.name];
        const shown = row.inherits && state.given[row.name] === undefined && inherited !== undefined
            ? String(inherited) : text;
        if (row.kind === "flag") {
            input.checked = text === true || text === "1";
        } else if (document.activeElement !== input || input.value.trim() === "") {
            input.value = shown ?? "";
        }
        if (this.slider && document.activeElement !== this.slider) {
            this.slider.value = toSlider(row, shown === null ? (row.slider[0]) : Number(shown));
        }
        this.slider?.setAttribute("aria-valuetext", shown ?? row.unset);
        const message = messages.get(row.name) ?? "";
        if (this.message.textContent !== message) {
            this.message.textContent = message;
        }
        input.setAttribute("aria-invalid", String(message !== ""));
        this.box.classList.toggle("wrong", message !== "");
        const given = state.given[row.name], isGiven = given !== undefined &&
            String(given) !== String(defaultText(state, row.name) ?? null);
        this.box.classList.toggle("given", isGiven);
        this.box.classList.toggle("unset", shown === null);
        this.back.disabled = !isGiven;
        const isServed = !row.serves || !noise || row.serves(noise) || isGiven;
        this.box.hidden = !(isServed && (!row.shown || row.shown(options))) && message === "";
    }
}

// The panel. change(name, text, isDragging) gets what is typed or dragged; undefined: take it back.
export class Controls {
    constructor(form, change) {
        this.fields = [];
        for (const group of GROUPS) {
            const fields = group.rows.map(row => new Field(row, change));
            const details = element("details", {class: "group", id: `g-${group.id}`,
                open: Boolean(group.open)}, element("summary", {}, group.title),
            ...fields.map(field => field.box));
            form.append(details);
            this.fields.push(...fields);
        }
        form.addEventListener("submit", event => event.preventDefault());
    }

    show(state, parsed) {
        for (const field of this.fields) {
            const {prefix} = field.row;
            const noise = prefix === undefined ? null : {
                basis: textOf(state, `${prefix}basis`), fractal: textOf(state, `${prefix}fractal`),
                octaves: numberOf(state, `${prefix}octaves`),
            };
            field.show(state, {...parsed, noise});
        }
        for (const {id, rows} of GROUPS) {
            const group = document.getElementById(`g-${id}`);
            group.classList.toggle("has-wrong", rows.some(row => parsed.messages.has(row.name)));
            group.classList.toggle("has-given", rows.some(row => row.name in state.given &&
                row.name !== "seed"));
        }
    }
}
