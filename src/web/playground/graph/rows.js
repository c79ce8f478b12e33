// SPDX-License-Identifier: MIT
//
// What cards show, as data: a card for each statement, with a row for each input, number, formula or
// call; and where a statement is spread out, a small card for each of its operators and calls.
import {missing} from "./arguments.js";
import {isField} from "../document.js";
import {functionOf, isCall, isLeaf, isNumber, isSign, textOf, within} from "./model.js";
import {kindText} from "./offers.js";

export const PARTS = 65536; // the number of the first part, among nodes that have pictures
const SIGNS = {"+": "+", "-": "−", "*": "×", "/": "÷", "^": "^"};

// A call that is more than arithmetic has a section of its own; others stay in their formula.
function isRich(model, part) {
    for (const inner of within(part)) {
        if (isCall(inner) && (functionOf(model, inner).arguments.every(slot => !slot.isNeeded) ||
            inner.children.some(child => child.kind === "knot" || child.kind === "word" ||
                child.argumentSpan !== null))) {
            return true;
        }
    }
    return false;
}

export const isShortened = (model, part) => isCall(part) && isRich(model, part);

class Rows {
    constructor(model, statement, isSpread, cards) {
        Object.assign(this, {model, statement, isSpread, cards, rows: []});
    }

    // A part that stands somewhere: an argument, an operand
    place(part, label, depth) {
        if (isNumber(part)) {
            this.rows.push({type: "number", label, part});
        } else if (isLeaf(part)) {
            this.rows.push({type: "input", label, part});
        } else if (this.isSpread) {
            this.rows.push({type: "link", label, part, id: this.spread(part)});
        } else if (isShortened(this.model, part)) {
            this.rows.push({type: "head", label, part, depth, text: kindText(this.model, part)});
            this.call(part, depth + 1);
        } else {
            this.rows.push({type: "formula", label, part, depth});
            this.leaves(part, depth);
        }
    }

    // Inside of a formula: its names and numbers, and sections of its calls
    leaves(part, depth, label = "") {
        for (const child of part.children) {
            const operation = isCall(part) || isSign(part) || child === part.children[0] &&
                child.operation === "" && label === "" ? "" : SIGNS[part.operation];
            const name = child.slot?.name ?? "";
            const own = isCall(part) ? name.length > 1 ? name : "" : operation;
            if (isLeaf(child)) {
                this.rows.push({type: isNumber(child) ? "number" : "input", label: own, part: child,
                    isInFormula: true});
            } else if (isShortened(this.model, child)) {
                this.place(child, "", depth);
            } else {
                this.leaves(child, depth, own);
            }
        }
    }

    // All that a statement or a small card is made of
    body(part, depth) {
        if (isCall(part)) {
            this.call(part, depth);
        } else if (!this.isSpread) {
            this.rows.push({type: "formula", label: "", part, depth});
            this.leaves(part, depth);
            this.rows.push({type: "operands", part});
        } else {
            this.operands(part, part.operation);
        }
    }

    // Sums and products of many as one card
    operands(part, operation) {
        const isSum = operation === "+" || operation === "-";
        part.children.forEach((child, i) => {
            const own = i === 0 && part.children.length > 1 ? isSum ? "+" : "×" : SIGNS[part.operation];
            const goesOn = i === 0 && child.children.length === 2 && child.operation !== "" &&
                ["+", "-"].includes(child.operation) === isSum &&
                textOf(this.model, child)[0] !== "(";
            if (goesOn) {
                this.operands(child, operation);
            } else {
                this.place(child, own, 0);
            }
        });
    }

    call(part, depth) {
        const signature = functionOf(this.model, part);
        if (signature.arguments.some(slot => slot.words !== null)) {
            this.rows.push({type: "words", part});
        }
        // The only input of a call needs no name of one letter.
        const isOnly = signature.arguments.filter(slot => slot.kind === "field").length === 1;
        const labelOf = ({slot}) => slot === null || isOnly && slot.name.length === 1 ? "" : slot.name;
        const knots = part.children.filter(child => child.kind === "knot");
        if (knots.length > 0) {
            this.rows.push({type: "curve", part});
        }
        for (const child of part.children) {
            if (child.kind === "word") {
                continue;
            }
            if (child.kind !== "knot") {
                this.place(child, labelOf(child), depth);
            } else if (knots.some(({children: [, value]}) => !isNumber(value))) {
                this.place(child.children[1], `at ${textOf(this.model, child.children[0])}`, depth);
            }
        }
        if (missing(this.model, part).length > 0) {
            this.rows.push({type: "more", part});
        }
    }

    // A small card for a part, in front of that of its statement
    spread(part) {
        const steps = [];
        for (let p = part; p.above !== null; p = p.above) {
            steps.unshift(p.above.children.indexOf(p));
        }
        const id = `${this.statement.name}/${steps.join(".")}`;
        const inside = new Rows(this.model, this.statement, true, this.cards);
        inside.body(part, 0);
        this.cards.push({id, statement: this.statement, part, isSub: true, isSpread: true,
            title: isCall(part) ? functionOf(this.model, part).name : SIGNS[part.operation],
            kind: `in ${this.statement.name}`, type: part.kind, node: isField(part) ? PARTS + part.index : -1,
            hash: part.hash, range: part.range, rows: inside.rows, note: ""});
        return id;
    }
}

const noteOf = statement => [statement.noteAbove, statement.note].filter(Boolean).join(" — ");

// What numbers a closed card has, in a line
function briefOf(model, rows) {
    return rows.filter(row => row.type === "number" && !row.isInFormula && row.label !== "seed")
        .map(row => `${row.label} ${textOf(model, row.part)}`).join(" · ");
}

function cardOf(model, statement, isSpread, cards) {
    const {root} = statement, rows = new Rows(model, statement, isSpread, cards);
    if (statement.isParam) {
        rows.rows.push({type: "value", statement});
    } else if (root !== null && isLeaf(root)) {
        rows.place(root, "is", 0);
    } else if (root !== null) {
        rows.body(root, 0);
    }
    const note = noteOf(statement), brief = briefOf(model, rows.rows);
    return {id: statement.name, statement, part: root, isSub: false, isSpread,
        canSpread: root !== null && [...within(root)].some(part => part !== root && !isLeaf(part) &&
            part.kind !== "knot"),
        title: statement.name, type: statement.kind,
        kind: statement.isParam ? "parameter" : root === null ? "error" : kindText(model, root),
        node: isField(statement) ? statement.index : -1, hash: statement.hash, range: statement.range,
        rows: [...rows.rows, ...(brief === "" ? [] : [{type: "brief", text: brief}]),
            ...(note === "" ? [] : [{type: "note", text: note}])], note};
}

// All cards, small ones in front of the statement that they are of
export function cardsOf(model, isSpread) {
    const cards = [];
    for (const statement of model.statements) {
        cards.push(cardOf(model, statement, isSpread(statement.name), cards));
    }
    return cards;
}

// Wires between cards: {from, to, row, part}, with the number of the row
export function wiresOf(model, cards) {
    const ids = new Set(cards.map(card => card.id));
    return cards.flatMap(to => to.rows.flatMap((row, index) => {
        const from = row.type === "link" ? row.id
            : row.type === "input" && row.part.entry >= 0 ? model.statements[row.part.entry].name
                : null;
        return from !== null && ids.has(from) ? [{from, to: to.id, row: index, part: row.part}] : [];
    }));
}
