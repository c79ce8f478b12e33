// SPDX-License-Identifier: MIT
//
// What the module reads in the text of a recipe, as plain data, which workers can be sent; and
// changes of texts.

// {text, ok, errors, entries, parts, functions, isSpace}: see Recipe in scarp.d.ts. Entries of
// param have the span of their number, too: `valueSpan`.
export function readDocument(scarp, text) {
    const functions = scarp.recipeFunctions;
    let recipe = null;
    try {
        recipe = scarp.recipe(text, {tolerant: true});
    } catch (error) {
        const wrong = {line: 1, column: 1, from: 0, to: text.length, member: null, nearest: null,
            text: error.code === "SCARP_ERROR_SIZE" ? "the text is longer than 16,384 bytes"
                : error.message};
        return {text, ok: false, errors: [wrong], entries: [], parts: [], functions,
            isSpace: false};
    }
    const {errors, parts, isSpace} = recipe;
    const entries = recipe.entries.map(entry =>
        entry.isParam ? {...entry, valueSpan: valueSpan(text, entry)} : entry);
    recipe.free();
    return {text, ok: errors.length === 0, errors, entries, parts, functions, isSpace};
}

// The module tells where a parameter and its name stand; its number is the next word behind "=".
function valueSpan(text, {span, nameSpan}) {
    const found = /^\s*=\s*(-?\s*[^\s[#]+)/.exec(text.slice(nameSpan[1], span[1]));
    const to = found ? nameSpan[1] + found[0].length : span[1];
    return found ? [to - found[1].length, to] : [to, to];
}

// The text after changes, which are {from, to, insert} of the text before
export function applied(text, changes) {
    let made = "", at = 0;
    for (const {from, to, insert} of inOrder(changes)) {
        made += text.slice(at, from) + insert;
        at = to;
    }
    return made + text.slice(at);
}

// By place; what is inserted at a place stands before what is replaced there.
export function inOrder(changes) {
    return changes.map((change, i) => ({to: change.from, insert: "", ...change, i}))
        .sort((a, b) => a.from - b.from || a.to - b.to || a.i - b.i)
        .map(({from, to, insert}) => ({from, to, insert}));
}

// Whether a statement or a part has a value at each point
export const isField = ({kind}) => kind === "field" || kind === "noise";

// What the library says of an error, and a number that would do
export const errorText = ({member, text, nearest}) =>
    `${member ? `${member}: ` : ""}${text}${nearest === null ? "" : `: ${nearest}`}`;
