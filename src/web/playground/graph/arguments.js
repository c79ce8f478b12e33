// SPDX-License-Identifier: MIT
//
// Gestures inside of calls, as edits of the text: words, arguments, knots of curves.
import {bare, functionOf, numberText} from "./model.js";
import {replaced, withoutArgument} from "./edits.js";
import {accept} from "./trial.js";

// A number for an argument that nobody has told: where a slider does something
export function likely(slot, share = 0.6) {
    const {lowest, highest} = slot;
    const value = lowest > 0 && highest / lowest >= 10 ? lowest * (highest / lowest) ** share
        : lowest + (highest - lowest) * share;
    return Number(value.toPrecision(2));
}

// One more than the greatest seed of a text
export function freshSeed(model) {
    const seeds = model.parts.filter(part => part.slot?.name === "seed" && part.kind === "number");
    return 1 + Math.max(0, ...seeds.map(part => part.value));
}

const atEnd = (model, call, text) => {
    const end = bare(model, call)[1] - 1, last = call.children[call.children.length - 1];
    return last ? {from: last.span[1], to: last.span[1], insert: `, ${text}`}
        : {from: end, to: end, insert: text};
};
const atFront = (model, call, text) => {
    const from = model.text.indexOf("(", call.nameSpan[1]) + 1;
    return {from, to: from, insert: call.children.length > 0 ? `${text}, ` : text};
};

// The word of an argument: another one, or none where it is ""
export function setWord(model, read, call, slot, word) {
    const child = call.children.find(part => part.slot === slot);
    if (child) {
        return accept(model, [[word === "" ? withoutArgument(child) : replaced(child.span, word)]],
            read);
    }
    return word === "" ? {refusal: "this changes nothing"}
        : accept(model, [[atFront(model, call, word)], [atEnd(model, call, word)]], read);
}

// Arguments of a call that are numbers or fields and are not given
export const missing = (model, call) => functionOf(model, call).arguments.filter(slot =>
    (slot.kind === "number" || slot.kind === "field") && !slot.isNeeded &&
    !call.children.some(child => child.slot === slot));

export function addArgument(model, read, call, slot) {
    const values = slot.name === "seed" ? [freshSeed(model)]
        : slot.kind === "field" ? [0]
        : [...new Set([slot.otherwise || likely(slot), likely(slot), slot.lowest, slot.highest])];
    return accept(model, values.map(value =>
        [atEnd(model, call, `${slot.name}=${numberText(value)}`)]), read);
}

export const removeArgument = (model, read, part) => accept(model, [[withoutArgument(part)]], read);

// Knots of a call, as {part, x, value}: parts of the place and of what is there
export const knotsOf = call => call.children.filter(child => child.kind === "knot")
    .map(part => ({part, x: part.children[0], value: part.children[1]}));

// Moves a knot. Texts that are null stay.
export function moveKnot(model, read, call, index, x, value) {
    const knot = knotsOf(call)[index];
    return accept(model, [[...(x === null ? [] : [replaced(knot.x.span, x)]),
        ...(value === null ? [] : [replaced(knot.value.span, value)])]], read);
}

// A knot more, in the order of places. Its text is "x: value".
export function addKnot(model, read, call, x, text) {
    const knots = knotsOf(call), next = knots.find(knot => knot.x.value > x);
    const last = knots[knots.length - 1].part.span[1];
    return accept(model, [[next ? {from: next.part.span[0], to: next.part.span[0], insert: `${text}, `}
        : {from: last, to: last, insert: `, ${text}`}]], read);
}

export const removeKnot = (model, read, call, index) =>
    accept(model, [[withoutArgument(knotsOf(call)[index].part)]], read);
