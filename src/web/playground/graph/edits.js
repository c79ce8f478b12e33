// SPDX-License-Identifier: MIT
//
// Gestures as edits of the text. Each takes a model, and `read`, which tries a text, and returns
// {changes, document} or a {refusal}: a clause that says why not. Statements and their uses are here,
// what lies inside of calls is in arguments.js.
import {bare, functionOf, isCall, isNumber, isSign, isWrapped, needsOf, numberText, textOf}
    from "./model.js";
import {Draft, accept, moved} from "./trial.js";

export const replaced = ([from, to], insert) => ({from, to, insert});

// A span of the text as another text
export const setText = (model, read, span, text) => accept(model, [[replaced(span, text)]], read);

const isOperation = part => part !== null && part.operation !== "";

// The text of a part where `place` stands, in parentheses where operators would tear it
export function textAt(model, part, place) {
    const text = textOf(model, part);
    const isLoose = (isOperation(part) || text.startsWith("-")) && !isWrapped(model, part);
    return isLoose && isOperation(place.above) ? `(${text})` : text;
}

// What stands for a part that is taken away, while the text around it stays
function neutral(model, part) {
    if (part.slot?.kind === "number" && part.kind === "number") {
        return numberText(part.value, 1e-9);
    }
    return ["*", "/"].includes(part.above?.operation) ? "1" : "0";
}

// Takes an argument away, with its comma
export function withoutArgument(part) {
    const all = part.above.children, i = all.indexOf(part);
    const start = child => child.argumentSpan?.[0] ?? child.span[0];
    return i > 0 ? {from: all[i - 1].span[1], to: part.span[1], insert: ""}
        : {from: start(part), to: all[1] ? start(all[1]) : part.span[1], insert: ""};
}

const isInput = child => child.slot !== null &&
    (child.slot.kind === "field" || child.slot.kind === "noise");

// Ways to lose an input, the nearest to it first: a number stands for it, the argument goes, its
// call becomes another of its inputs, and then the same for what is around.
function waysToLose(model, part) {
    const ways = [];
    for (let place = part; place !== null; place = place.above) {
        if (place.kind === "knot" || place.kind === "word") {
            continue;
        }
        ways.push([replaced(place.span, neutral(model, place))]);
        if (place.slot !== null && place.above !== null && isCall(place.above)) {
            if (!place.slot.isNeeded) {
                ways.push([withoutArgument(place)]);
            }
            for (const other of place.above.children) {
                if (other !== place && isInput(other)) {
                    ways.push([replaced(place.above.span, textAt(model, other, place.above))]);
                }
            }
        }
    }
    return ways;
}

export const unplug = (model, read, part) => accept(model, waysToLose(model, part), read);

// A call becomes its first input.
export function bypass(model, read, part) {
    const inputs = isCall(part) ? part.children.filter(isInput)
        : part.children.filter(child => !isNumber(child));
    const ways = inputs.map(input => [replaced(part.span, textAt(model, input, part))]);
    return accept(model, ways.length > 0 ? ways : waysToLose(model, part), read);
}

const hasExplicitOut = model => model.statements.some(statement => statement.isExplicitOut);

// Moves a statement, and what it needs, above another one. The last statement stays the output.
function lifts(model, source, target) {
    const moves = model.statements.filter(statement =>
        statement.first > target.first && needsOf(model, source).has(statement));
    const text = moves.map(statement => {
        const [name] = statement.nameSpan, {top, end} = statement;
        const isOutput = !hasExplicitOut(model) && statement.output >= 0;
        const block = isOutput ? `${model.text.slice(top, name)}out ${model.text.slice(name, end)}`
            : model.text.slice(top, end);
        return block.endsWith("\n") ? block : block + model.newline;
    }).join("");
    return moves.length === 0 ? [] : [{from: target.top, to: target.top, insert: text},
        ...moves.map(({top, end}) => ({from: top, to: end, insert: ""}))];
}

// Puts the name of a statement in the place of a part. `from` is a use that it leaves.
export function wire(model, read, source, part, from = null) {
    const target = part.statement;
    if (source === target || needsOf(model, source).has(target)) {
        return {refusal: `${source.name} needs ${target.name}: that would be a circle`};
    }
    const plug = [...lifts(model, source, target), replaced(part.span, source.name)];
    const plugged = accept(model, [plug], read);
    if (plugged.refusal || from === null || from === part) {
        return plugged;
    }
    const draft = new Draft(model, read);
    draft.do(() => plugged);
    const at = moved(plugged.changes, from.span[0]);
    const left = draft.model.parts.find(({entry, span}) => entry >= 0 && span[0] === at);
    if (left) {
        draft.do((next, reading) => unplug(next, reading, left));
    }
    return draft.result;
}

// The line of a statement, the comment above it if that is of no other, and its place
function linesOf(model, statement) {
    const top = statement.isFollowed ? statement.first : statement.top;
    const place = model.places.get(statement.name);
    return [{from: top, to: statement.end, insert: ""},
        ...(place ? [{from: place.line.from, to: place.line.end, insert: ""}] : [])];
}

// Deletes a statement. Its uses lose their inputs.
export function remove(model, read, statement) {
    const draft = new Draft(model, read), {name} = statement;
    for (let uses = statement.uses.length; uses > 0;) {
        const [use] = draft.model.byName.get(name).uses.slice(-1);
        draft.do((next, reading) => unplug(next, reading, use));
        uses = draft.refusal === null ? draft.model.byName.get(name).uses.length : 0;
    }
    draft.do((next, reading) =>
        accept(next, [linesOf(next, next.byName.get(name))], reading));
    return draft.result;
}

// Puts the expression of a statement in the place of each of its uses.
export function inline(model, read, statement) {
    if (statement.uses.length === 0) {
        return {refusal: `nothing uses ${statement.name}`};
    }
    const changes = statement.uses.map(use => {
        const text = statement.root ? textAt(model, statement.root, use)
            : model.text.slice(...statement.valueSpan);
        return replaced(use.nameSpan, text.startsWith("-") && isOperation(use.above)
            ? `(${text})` : text);
    });
    return accept(model, [[...changes, ...linesOf(model, statement)]], read);
}

const isName = name => /^[A-Za-z_]\w*$/.test(name);

export function rename(model, read, statement, name) {
    if (!isName(name)) {
        return {refusal: "a name has letters, digits and _"};
    }
    const place = model.places.get(statement.name);
    return accept(model, [[replaced(statement.nameSpan, name),
        ...statement.uses.map(use => replaced(use.nameSpan, name)),
        ...(place ? [placeLine(model, name, place.x, place.y, place)] : [])]], read);
}

// A name that is free, made of a word
export function freshName(model, word) {
    const isTaken = name => model.byName.has(name) ||
        model.functions.some(f => f.name === name || f.arguments.some(a => a.words?.includes(name)));
    const stem = word.replace(/\W/g, "").replace(/_?\d+$/, "") || "part";
    let name = stem;
    for (let i = model.functions.some(f => f.name === stem) ? 1 : 2; isTaken(name); i++) {
        name = `${stem}_${i}`;
    }
    return name;
}

// The interval of a slider for a number: that of its argument, wide enough, else one around it
export function intervalOf(part) {
    const {value} = part, slot = part.slot?.kind === "number" ? part.slot : null;
    if (slot !== null && slot.lowest < slot.highest) {
        return [Math.min(slot.lowest, value), Math.max(slot.highest, value)];
    }
    const size = Math.abs(value), top = size <= 1 ? 1 : size * 2;
    return value < 0 ? [-top, top] : [0, top];
}

// Where a new param stands: below the others, above its use
function placeOfParam(model, statement) {
    const above = model.statements.filter(other => other.isParam && other.end <= statement.top);
    return above.length > 0 ? above[above.length - 1].end : statement.top;
}

// Makes a part a statement of its own, or a number a parameter.
export function extract(model, read, part, name = null) {
    const {statement} = part;
    const word = isNumber(part) ? part.slot?.name ?? "amount"
        : isCall(part) ? functionOf(model, part).name : "part";
    const made = name ?? freshName(model, word === "part" || isNumber(part) ? word : `${word}_1`);
    let text = model.text.slice(...bare(model, part));
    text = text.includes("\n") && !isCall(part) ? `(${text})` : text;
    const [lowest, highest] = isNumber(part) ? intervalOf(part) : [0, 0];
    const line = isNumber(part)
        ? `param ${made} = ${text} [${numberText(lowest)}, ${numberText(highest)}]`
        : `${made} = ${text}`;
    const at = isNumber(part) ? placeOfParam(model, statement) : statement.top;
    return {...accept(model, [[{from: at, to: at, insert: line + model.newline},
        replaced(part.span, made)]], read), name: made};
}

// Whether a statement is written out: `out name = ...`
export function toggleOut(model, read, statement) {
    const [from] = statement.span, [name] = statement.nameSpan;
    return accept(model, [[statement.isExplicitOut ? {from, to: name, insert: ""}
        : {from: name, to: name, insert: "out "}]], read);
}

// One operand more, of a formula as a whole
export function addOperand(model, read, part, operation, text) {
    const [from, to] = bare(model, part);
    const isSum = ["+", "-"].includes(part.operation);
    const needsWrap = ["*", "/"].includes(operation) && isSum || operation === "^" && isOperation(part);
    return accept(model, [needsWrap
        ? [{from, to: from, insert: "("}, {from: to, to, insert: `) ${operation} ${text}`}]
        : [{from: to, to, insert: ` ${operation} ${text}`}]], read);
}

// One operand fewer
export function dropOperand(model, read, part) {
    const above = part.above, other = above?.children.find(child => child !== part);
    if (!other || above.operation === "" || isSign(above)) {
        return unplug(model, read, part);
    }
    const isFirst = part.span[0] < other.span[0];
    const sign = {"-": "-", "/": "1 / "}[above.operation] ?? "";
    return accept(model, [[isFirst ? {from: part.span[0], to: other.span[0], insert: sign}
        : {from: other.span[1], to: part.span[1], insert: ""}]], read);
}

function placeLine(model, name, x, y, place) {
    const text = `#: ${name} ${Math.round(x)} ${Math.round(y)}`;
    if (place) {
        return {from: place.line.from, to: place.line.from + place.line.text.length, insert: text};
    }
    const end = model.text.length, {newline} = model;
    const gap = (model.text.endsWith("\n") || end === 0 ? "" : newline) +
        (model.places.size > 0 ? "" : newline);
    return {from: end, to: end, insert: gap + text + newline};
}

// Stores where cards lie: places are [name, x, y]. `#: palette` is another line already.
export const setPlaces = (model, read, places) => places.some(([name]) => name === "palette")
    ? {refusal: "a card that is called palette has no line of its own"}
    : accept(model, [places.map(([name, x, y]) =>
        placeLine(model, name, x, y, model.places.get(name)))], read);

// Forgets where cards lie, with the empty line above the first place.
export function forgetPlaces(model, read) {
    const places = [...model.places.values()].map(({line}) => line);
    if (places.length === 0) {
        return {refusal: "no card has a place of its own"};
    }
    const first = Math.min(...places.map(line => line.from)), before = model.lines.findIndex(
        line => line.from === first) - 1;
    const gap = model.lines[before];
    const isGap = gap?.text.trim() === "" && places.every(line => line.from >= first) &&
        !/\S/.test(applyTail(model, first, places));
    return accept(model, [[...(isGap ? [{from: gap.from, to: gap.end, insert: ""}] : []),
        ...places.map(line => ({from: line.from, to: line.end, insert: ""}))]], read);
}

// What is left behind a place when lines are gone
const applyTail = (model, from, lines) => model.lines.filter(line => line.from >= from &&
    !lines.includes(line)).map(line => line.text).join("");

// space and tile: `text` is what stands behind the word; null takes the line away.
export function setSetting(model, read, word, text) {
    const found = model.settings[word], recipe = model.settings.recipe;
    if (found) {
        return accept(model, [[text === null ? {from: found.line.from, to: found.line.end, insert: ""}
            : replaced(found.span, text)]], read);
    }
    const at = (word === "tile" ? model.settings.space : null)?.line.end ?? recipe?.line.end ?? 0;
    return text === null ? {refusal: "this changes nothing"}
        : accept(model, [[{from: at, to: at, insert: `${word} ${text}${model.newline}`}]], read);
}

// The value of a parameter, and its interval
export const setValue = (model, read, statement, text) =>
    setText(model, read, statement.valueSpan, text);

export function setInterval(model, read, statement, lowest, highest) {
    const text = `[${lowest}, ${highest}]`, [, end] = statement.valueSpan;
    return accept(model, [[statement.intervalSpan ? replaced(statement.intervalSpan, text)
        : {from: end, to: end, insert: ` ${text}`}]], read);
}
