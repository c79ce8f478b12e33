// SPDX-License-Identifier: MIT
//
// Edits are tried before they are done: the module reads the text that would be there, and one that
// has more errors than now is refused with the module's sentence.
import {applied, inOrder} from "../document.js";
import {modelOf} from "./model.js";

// Where a place of the old text is in the new one
export function moved(changes, place) {
    let by = 0;
    for (const {from, to, insert} of inOrder(changes)) {
        if (to > place || (from === to && from === place)) {
            break;
        }
        by += insert.length - (to - from);
    }
    return place + by;
}

const sentence = ({errors: [{text, member}]}) => member ? `${text} (${member})` : text;

// The first of several lists of changes that brings no new error: {changes, document}; or else a
// {refusal}, which is what the module says of the first one.
export function accept(model, alternatives, read) {
    let refusal = null;
    for (const changes of alternatives) {
        const text = applied(model.text, changes);
        if (text === model.text) {
            continue;
        }
        const document = read(text);
        if (document.errors.length <= model.document.errors.length) {
            return {changes: inOrder(changes), document};
        }
        refusal ??= sentence(document);
    }
    return {refusal: refusal ?? "this changes nothing"};
}

// Several edits in a row that become one list of changes of the first text: pieces of it, and what
// was inserted between them.
export class Draft {
    constructor(model, read) {
        this.model = model;
        this.read = read;
        this.length = model.text.length;
        this.pieces = [{from: 0, to: this.length}];
        this.refusal = null;
    }

    // Does an edit, which a function of model and `read` tells. Returns whether it was accepted.
    do(edit) {
        const result = this.refusal === null ? edit(this.model, this.read) : this;
        if (result.refusal) {
            this.refusal = result.refusal;
            return false;
        }
        for (const change of [...result.changes].reverse()) {
            this.#replace(change);
        }
        this.model = modelOf(result.document);
        return true;
    }

    #replace({from, to, insert}) {
        const before = [], after = [];
        let at = 0;
        for (const piece of this.pieces) {
            const size = piece.text === undefined ? piece.to - piece.from : piece.text.length;
            const cut = (a, b) => piece.text === undefined
                ? {from: piece.from + a, to: piece.from + b} : {text: piece.text.slice(a, b)};
            const low = Math.min(Math.max(from - at, 0), size);
            const high = Math.min(Math.max(to - at, 0), size);
            if (low > 0) {
                before.push(cut(0, low));
            }
            if (high < size) {
                after.push(cut(high, size));
            }
            at += size;
        }
        this.pieces = [...before, ...(insert === "" ? [] : [{text: insert}]), ...after];
    }

    // {changes, document}, or a {refusal}
    get result() {
        if (this.refusal !== null) {
            return {refusal: this.refusal};
        }
        const changes = [];
        let at = 0, insert = "";
        for (const piece of [...this.pieces, {from: this.length, to: this.length}]) {
            if (piece.text !== undefined) {
                insert += piece.text;
                continue;
            }
            if (piece.from > at || insert !== "") {
                changes.push({from: at, to: piece.from, insert});
            }
            [at, insert] = [piece.to, ""];
        }
        return {changes, document: this.model.document};
    }
}
