// SPDX-License-Identifier: MIT
//
// Colours of tokens, and of a bracket with its partner.
import {EditorState, StateField} from "@codemirror/state";
import {Decoration, EditorView, MatchDecorator, ViewPlugin} from "@codemirror/view";
import {matchBrackets} from "./plain.js";

// Each group of the expression is a kind of token.
const KINDS = ["comment", "keyword", "number", "function", "argument", "operator"];
const TOKENS = new RegExp("(#.*)|(?<=^)((?:recipe|param|out|space|tile)\\b)|" +
    "(?<!\\w)((?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?)|" +
    "([A-Za-z_]\\w*(?=\\s*\\())|([A-Za-z_]\\w*(?=\\s*=))|([-+*/^=,:()[\\]])|[A-Za-z_]\\w*", "g");
const marks = KINDS.map(kind => Decoration.mark({class: `tok-${kind}`}));

const decorator = new MatchDecorator({regexp: TOKENS, decorate: (add, from, to, match) => {
    const kind = match.slice(1).findIndex(group => group !== undefined);
    if (kind >= 0) {
        add(from, to, marks[kind]);
    }
}});
const tokens = ViewPlugin.define(view => ({
    decorations: decorator.createDeco(view),
    update(update) {
        this.decorations = decorator.updateDeco(update, this.decorations);
    },
}), {decorations: plugin => plugin.decorations});

const met = Decoration.mark({class: "cm-matchingBracket"});
const alone = Decoration.mark({class: "cm-nonmatchingBracket"});

function bracketsOf(state) {
    const {head, empty} = state.selection.main;
    const beside = [[head, -1], [head, 1], [head - 1, 1], [head + 1, -1]];
    const found = empty ? beside.map(([at, direction]) => matchBrackets(state, at, direction))
        .find(each => each !== null) ?? null : null;
    const places = found === null ? [] : [found.start, ...(found.end ? [found.end] : [])];
    return Decoration.set(places.map(({from, to}) => (found.matched ? met : alone).range(from, to)),
        true);
}
const brackets = StateField.define({
    create: bracketsOf,
    update: (value, {docChanged, selection, state}) =>
        docChanged || selection ? bracketsOf(state) : value,
    provide: field => EditorView.decorations.from(field),
});

export const colours = [tokens, brackets, EditorState.languageData.of(() =>
    [{commentTokens: {line: "#"}, closeBrackets: {brackets: ["(", "["]}}])];
