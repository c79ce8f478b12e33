// SPDX-License-Identifier: MIT
//
// What commands and autocompletion of CodeMirror take from @codemirror/language and @lezer/common, for
// a language without a tree: the module parses. The libraries themselves would be a seventh of the page.
import {Facet} from "@codemirror/state";

const node = {name: "", type: {prop: () => undefined}, parent: null, firstChild: null,
    childBefore: () => null, childAfter: () => null};
const tree = {resolveInner: () => node, resolveStack: () => ({node, next: null})};
export const syntaxTree = () => tree;
export const NodeProp = {};

// Lines begin as the line above does.
export const indentUnit = Facet.define({combine: ([unit]) => unit ?? "    "});
export const getIndentUnit = state => state.facet(indentUnit).length;
export const indentString = (state, columns) => " ".repeat(columns);
export const getIndentation = () => null;
export class IndentContext {
    constructor(state) {
        this.state = state;
    }

    lineIndent(at) {
        return /^\s*/.exec(this.state.doc.lineAt(at).text)[0].length;
    }
}

const PAIRS = "()[]", FAR = 4000; // letters to look through

// The bracket next to `at`, behind it (1) or before it (-1), and its partner:
// {start, end: {from, to}, matched}, or null
export function matchBrackets(state, at, direction) {
    const first = direction > 0 ? at : at - 1;
    const bracket = state.sliceDoc(Math.max(first, 0), first + 1);
    const kind = PAIRS.indexOf(bracket);
    if (first < 0 || bracket === "" || kind < 0 || (kind % 2 === 0) !== (direction > 0)) {
        return null;
    }
    const from = Math.max(0, first - FAR), text = state.sliceDoc(from, first + FAR)
        .replace(/#.*/g, comment => " ".repeat(comment.length));
    const partner = PAIRS[kind ^ 1], start = {from: first, to: first + 1};
    for (let i = first - from, depth = 0; i >= 0 && i < text.length; i += direction) {
        depth += text[i] === bracket ? 1 : text[i] === partner ? -1 : 0;
        if (depth === 0) {
            const end = text[i] === partner ? {from: from + i, to: from + i + 1} : undefined;
            return {start, end, matched: end !== undefined};
        }
    }
    return {start, matched: false};
}
