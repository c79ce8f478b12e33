// SPDX-License-Identifier: MIT
//
// What a menu may offer: statements that could be added, and names that could be plugged in. Each
// offer is an edit that is tried before it is shown, so the menu has what fits the place.
import {freshSeed, likely} from "./arguments.js";
import {extract, freshName, replaced, textAt, wire} from "./edits.js";
import {isField} from "../document.js";
import {functionOf, isCall, isNumber, needsOf, numberText} from "./model.js";
import {accept} from "./trial.js";

const OPERATORS = [
    ["sum", "+ 0", "a + b: lay one field over another"],
    ["product", "* 1", "a × b: a mask, a strength"],
    ["difference", "- 0", "a − b: take one field from another"],
    ["quotient", "/ 2", "a ÷ b"],
    ["square", "^2", "a × a"],
];

// The interval of a field, finite
const rangeOf = source => source !== null && source.range.every(Number.isFinite) &&
    source.range[0] < source.range[1] ? source.range : [-1, 1];

// The middle one of the sizes of a text, or of the interval of the slider
function usualSize(model, slot) {
    const sizes = model.parts.filter(part => part.slot?.name === "size" && part.value > 0)
        .map(part => part.value).sort((a, b) => a - b);
    return sizes.length > 0 ? sizes[sizes.length >> 1] : likely(slot, 0.6);
}

// A call without inputs of its own, as noise: large enough to be seen
function sourceText(model, f, word, members) {
    const has = name => f.arguments.find(slot => slot.name === name);
    const given = {...(has("size") && {size: usualSize(model, has("size"))}),
        ...(has("octaves") && {octaves: 5}), ...members,
        ...(has("seed") && {seed: freshSeed(model)})};
    const list = [...(word ? [word] : []), ...Object.entries(given).map(([name, value]) =>
        `${name}=${numberText(value)}`)];
    return `${f.name}(${list.join(", ")})`;
}

const needsNothing = f => f.arguments.every(slot => !slot.isNeeded);
const sourceOf = model => model.functions.find(needsNothing);

// Knots of numbers that change nothing yet, and knots of fields: one of them is right.
function knotsTexts([low, high], text) {
    const step = 10 ** Math.floor(Math.log10((high - low) / 20));
    const at = share => numberText(low + (high - low) * share, step);
    return [`${at(0.3)}: ${text}, ${at(0.7)}: 0`,
        [0, 0.5, 1].map(share => `${at(share)}: ${at(share)}`).join(", ")];
}

// Texts of a call whose first input is `text`, the likeliest first
function callTexts(model, f, text, range) {
    const noise = sourceOf(model), size = usualSize(model, noise.arguments.find(slot =>
        slot.name === "size"));
    const fresh = sourceText(model, noise, "", {octaves: 3, amplitude: Number((size / 5)
        .toPrecision(2))});
    const needed = f.arguments.filter(slot => slot.isNeeded);
    const numbers = needed.filter(slot => slot.kind === "number");
    const isOfValues = numbers.length === 2 && numbers.every(slot => slot.lowest === -1 &&
        slot.highest === 1);
    const number = (slot, i) => isOfValues
        ? numberText(range[0] + (range[1] - range[0]) * (i === 0 ? 0.35 : 0.65), 0.001)
        : numberText(likely(slot, numbers.length === 1 ? 0.6 : i === 0 ? 0.25 : 0.75));
    const hasKnots = needed.some(slot => slot.kind === "knot"), knots = knotsTexts(range, text);
    const withOthers = (others, way) => {
        const rest = [...others];
        let isFirst = true, i = 0;
        // `at` takes a third field in space.
        const isFull = others.length > 2;
        const slots = f.arguments.filter(slot => slot.isNeeded || isFull && slot.kind === "field");
        const list = slots.map(slot => {
            if (isFirst && (slot.kind === "field" || slot.kind === "noise")) {
                isFirst = false;
                return text;
            }
            return slot.kind === "field" ? rest.shift() ?? "0" : slot.kind === "noise" ? fresh
                : slot.kind === "knot" ? knots[way] : number(slot, i++);
        });
        const named = needed.length < 2 && f.arguments.some(slot => slot.name === "size")
            ? [`size=${numberText(size)}`, `seed=${freshSeed(model)}`] : [];
        return `${f.name}(${[...list, ...named].join(", ")})`;
    };
    const fills = hasKnots ? [[], []] : [["x", "y"], ["x", "y", "z"], ["0", "0.5"], ["0", "0"]];
    return [...new Set(fills.map(withOthers))];
}

// A line of text at a place, which may be the end of a text without a newline
const lineAt = (model, at, line) => ({from: at, to: at,
    insert: at > 0 && model.text[at - 1] !== "\n" ? model.newline + line
        : line + model.newline});

// Where a statement without inputs stands: above the first output
function aboveOutputs(model) {
    const outputs = model.statements.filter(statement => statement.output >= 0);
    return outputs.length > 0 ? Math.min(...outputs.map(statement => statement.top))
        : model.text.length;
}

// A statement of one of several texts: in front of a place that takes its name, or below its source
function statementOffer(name, text, group, texts, place) {
    return {name, text, group, attempt: (model, read) => {
        const made = freshName(model, name), {target, at} = place;
        const uses = target ? [replaced(target.span, made)] : [];
        return {...accept(model, texts().map(line =>
            [lineAt(model, at, `${made} = ${line}`), ...uses]), read), name: made};
    }};
}

function paramOffer(model, target) {
    return {name: "parameter", text: "a number with a slider", group: "numbers",
        attempt: (next, read) => {
            if (target && isNumber(target)) {
                return extract(next, read, target);
            }
            const made = freshName(next, "amount");
            const params = next.statements.filter(statement => statement.isParam &&
                (!target || statement.end <= target.statement.top));
            const at = params[params.length - 1]?.end ?? target?.statement.top ??
                next.statements[0]?.top ?? next.text.length;
            return {...accept(next, [[lineAt(next, at, `param ${made} = 1 [0, 4]`),
                ...(target ? [replaced(target.span, made)] : [])]], read), name: made};
        }};
}

// The statement that a new one comes from if nothing was told
function usualSource(model, target, selected) {
    const fields = model.statements.filter(statement => isField(statement) &&
        (!target || !needsOf(model, statement).has(target.statement)));
    return fields.includes(selected) ? selected
        : fields.filter(statement => statement.output < 0).pop() ?? fields.pop() ?? null;
}

function nameOffers(model, target) {
    return model.statements.filter(statement => statement !== target.statement &&
        target.entry !== statement.index).map(statement => ({
        name: statement.name, group: "names", isName: true,
        text: statement.isParam ? "a number that is there already" : "what is there already",
        attempt: (next, read) => ({...wire(next, read, statement, target), name: statement.name}),
    }));
}

// Offers for a place: {source} a wire that ends nowhere, {target} an input that takes what is new,
// or neither. Attempts of an offer take (model, read) and return what edits return, and a `name`.
export function offersFor(model, {source = null, target = null, selected = null, isWire = false}) {
    const from = source ?? (target && !isNumber(target) ? null : usualSource(model, target, selected));
    const text = from?.name ?? (target ? textAt(model, target, {above: null}) : "x");
    const range = rangeOf(from ?? (target?.range && isField(target) ? target : null));
    const loose = target?.operation ? `(${text})` : text;
    const below = {target, at: target ? target.statement.top : from?.end ?? aboveOutputs(model)};
    const free = {target, at: target ? target.statement.top : aboveOutputs(model)};
    const list = [];
    for (const f of model.functions) {
        if (!needsNothing(f)) {
            list.push(statementOffer(f.name, f.text, "functions",
                () => callTexts(model, f, text, range), below));
        } else if (!source && !isWire) {
            list.push(statementOffer(f.name, f.text, "sources", () => [sourceText(model, f, "", {})],
                free));
            for (const slot of f.arguments.filter(({words}) => (words?.length ?? 0) > 2)) {
                list.push(...slot.words.map(word => statementOffer(`${word} ${f.name}`,
                    `${f.name} whose ${slot.name} is ${word}`, "sources",
                    () => [sourceText(model, f, word, {})], free)));
            }
        }
    }
    list.push(...OPERATORS.map(([name, tail, what]) => statementOffer(name, what, "formulas",
        () => [tail.startsWith("^") ? loose + tail : `${loose} ${tail}`], below)));
    if (!source && !isWire) {
        list.push(paramOffer(model, target));
    }
    return target && !isWire ? [...nameOffers(model, target), ...list] : list;
}

// Whether an offer is one for some words of a search
export function isFound(offer, search) {
    const text = `${offer.name} ${offer.text} ${offer.group}`.toLowerCase();
    return search.toLowerCase().split(/\s+/).every(word => text.includes(word));
}

// A word or two on what a part is
export function kindText(model, part) {
    if (isCall(part)) {
        const words = part.children.filter(child => child.kind === "word" &&
            child.slot?.words.length > 2).map(child => child.name.replaceAll("_", " "));
        return [...words, functionOf(model, part).name.replaceAll("_", " ")].join(" ");
    }
    return part.operation !== "" ? "formula" : isNumber(part) ? "number" : "name";
}
