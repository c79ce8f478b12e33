// SPDX-License-Identifier: MIT
//
// The text of the recipe in CodeMirror: errors at their place, completion, help, and one history
// for all edits, those of sliders and of the graph among them.
import {autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap} from
    "@codemirror/autocomplete";
import {defaultKeymap, history, historyKeymap, indentLess, indentMore, isolateHistory, redo,
    redoDepth, undo, undoDepth} from "@codemirror/commands";
import {lintGutter, lintKeymap, setDiagnostics} from "@codemirror/lint";
import {Annotation, EditorState, Transaction} from "@codemirror/state";
import {EditorView, drawSelection, highlightActiveLine, hoverTooltip, keymap, lineNumbers} from
    "@codemirror/view";
import {errorText} from "../document.js";
import {colours} from "./colours.js";
import {completion, helpAt} from "./language.js";

const GROUP_MS = 500; // typing without a pause is one step of the history
const joined = Annotation.define();

// Steps join if an edit says so, or is typed next to the last one at once.
function historyOfAll() {
    let last = 0; // when the text changed
    const timer = EditorView.updateListener.of(({docChanged}) => {
        last = docChanged ? Date.now() : last;
    });
    return [timer, history({newGroupDelay: 2 ** 40, joinToEvent: (transaction, isAdjacent) =>
        transaction.annotation(joined) ?? (isAdjacent && Date.now() - last < GROUP_MS)})];
}

function tooltip({from, to, title, lines}) {
    return {pos: from, end: to, above: true, create: () => {
        const dom = document.createElement("div"), head = document.createElement("strong");
        dom.className = "recipe-help";
        head.textContent = title;
        dom.append(head, ...lines.map(line => {
            const row = document.createElement("p"), name = document.createElement("code");
            const [word, text] = Array.isArray(line) ? line : ["", line];
            name.textContent = word;
            row.append(...(word ? [name, " "] : []), text);
            return row;
        }));
        return {dom};
    }};
}

function diagnosticOf(error, length) {
    const from = Math.min(error.from, length), to = Math.min(Math.max(error.to, from), length);
    return {from, to, severity: "error", message: errorText(error)};
}

// on: {read(): document, changed(text), moved(at, hasFocus), help(text)}
export class Editor {
    constructor(parent, text, on) {
        this.on = on;
        const {read} = on;
        this.view = new EditorView({parent, state: EditorState.create({doc: text, extensions: [
            lineNumbers(), historyOfAll(), drawSelection(), colours, closeBrackets(),
            highlightActiveLine(), lintGutter(),
            autocompletion({override: [completion(read)], icons: false}),
            hoverTooltip((view, at) => {
                const help = helpAt(read(), at);
                return help && tooltip(help);
            }),
            keymap.of([...closeBracketsKeymap, ...completionKeymap, ...lintKeymap, ...historyKeymap,
                ...defaultKeymap, {key: "Mod-]", run: indentMore}, {key: "Mod-[", run: indentLess},
                {key: "F1", run: ({state}) => this.help(state.selection.main.head)}]),
            EditorView.contentAttributes.of({"aria-label": "Text of the recipe",
                "aria-describedby": "recipe-message", autocapitalize: "off"}),
            EditorView.updateListener.of(update => this.updated(update)),
        ]})});
    }

    get text() {
        return this.view.state.doc.toString();
    }

    // Tells what the word at a place is, for those who have no pointer.
    help(at) {
        const help = helpAt(this.on.read(), at);
        this.on.help(help === null ? "There is no help for this place."
            : [help.title, ...help.lines.map(line => [line].flat().join(" "))].join("\n"));
        return true;
    }

    updated({docChanged, selectionSet, state, view}) {
        if (docChanged) {
            this.on.changed(state.doc.toString());
        }
        if (docChanged || selectionSet) {
            this.on.moved(state.selection.main.head, view.hasFocus);
        }
    }

    // One step of the history, or a part of the last one: {join}
    edit(changes, {userEvent = "input", selection, join = false} = {}) {
        this.view.dispatch({changes, selection, scrollIntoView: selection !== undefined,
            annotations: [joined.of(join), ...(join ? [] : [isolateHistory.of("before"),
                Transaction.userEvent.of(userEvent)])]});
    }

    // Shows another text, which is one step, unless it is the same.
    replace(text) {
        const old = this.text;
        if (text !== old) {
            this.edit([{from: 0, to: old.length, insert: text}]);
        }
    }

    select(from, to = from) {
        this.view.dispatch({selection: {anchor: from, head: to}, effects:
            EditorView.scrollIntoView(from, {y: "nearest"})});
    }

    tell(errors) {
        const {state} = this.view, {length} = state.doc;
        this.view.dispatch(setDiagnostics(state, errors.map(error => diagnosticOf(error, length))));
    }

    undo() {
        undo(this.view);
    }

    redo() {
        redo(this.view);
    }

    get depths() {
        return [undoDepth(this.view.state), redoDepth(this.view.state)];
    }
}
