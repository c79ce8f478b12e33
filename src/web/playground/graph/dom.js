// SPDX-License-Identifier: MIT
//
// Small helpers for elements and pointers.

const SVG = "http://www.w3.org/2000/svg";

function filled(made, attributes, children) {
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith("on")) {
            made.addEventListener(name.slice(2), value);
        } else if (value !== undefined && value !== null && value !== false) {
            made.setAttribute(name, value === true ? "" : value);
        }
    }
    made.append(...children);
    return made;
}

// An element: make("p", {class: "note", onclick: f}, "text")
export const make = (name, attributes = {}, ...children) =>
    filled(document.createElement(name), attributes, children);
export const draw = (name, attributes = {}, ...children) =>
    filled(document.createElementNS(SVG, name), attributes, children);

// Follows a pointer from where it went down until it goes up.
export function follow(event, move, up = () => {}) {
    const {pointerId} = event;
    const own = f => e => e.pointerId === pointerId && f(e);
    const onMove = own(move), onUp = own(e => {
        removeEventListener("pointermove", onMove);
        removeEventListener("pointerup", onUp);
        removeEventListener("pointercancel", onUp);
        up(e);
    });
    addEventListener("pointermove", onMove);
    addEventListener("pointerup", onUp);
    addEventListener("pointercancel", onUp);
}

// A field to type in, in the place of an element, until Enter or Escape or another place is taken.
// `done` gets the text, or null.
export function typeInto(element, text, label, done) {
    const field = make("input", {type: "text", class: "graph-type", "aria-label": label,
        spellcheck: "false", autocomplete: "off"});
    let isOpen = true;
    const close = value => {
        if (isOpen) {
            isOpen = false;
            field.replaceWith(element);
            done(value);
        }
    };
    field.value = text;
    field.addEventListener("keydown", event => {
        event.stopPropagation();
        if (event.key === "Enter" || event.key === "Escape") {
            event.preventDefault();
            close(event.key === "Enter" ? field.value.trim() : null);
        }
    });
    field.addEventListener("blur", () => close(field.value.trim()));
    field.addEventListener("pointerdown", event => event.stopPropagation());
    field.addEventListener("dblclick", event => event.stopPropagation());
    element.replaceWith(field);
    field.focus();
    field.select();
    return field;
}
