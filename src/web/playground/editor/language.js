// SPDX-License-Identifier: MIT
//
// Completion and help for recipes. Here are only tokens; what a function or a name is comes from
// the module, in the document: see document.js. Formulas are those of src/recipe/README.md.
import {snippetCompletion} from "@codemirror/autocomplete";
import formulas from "formulas";

const WORD = /^[A-Za-z_]\w*/;

// The name of the call whose parentheses are open before `at`, and "" outside of any
function callAt(text, at) {
    for (let i = at - 1, closed = 0; i >= 0; i--) {
        if (text[i] === ")") {
            closed++;
        } else if (text[i] === "(" && closed-- === 0) {
            return /([A-Za-z_]\w*)\s*$/.exec(text.slice(0, i))?.[1] ?? "";
        } else if (text[i] === "\n" && closed === 0 && /^\w/.test(text.slice(i + 1))) {
            return "";
        }
    }
    return "";
}

const numberText = number => String(Number(number.toPrecision(6)));
const intervalText = ([lowest, highest]) => `${numberText(lowest)} … ${numberText(highest)}`;

// What an argument takes, in a few words
function argumentText({text, kind, isNeeded, otherwise, lowest, highest, words}) {
    const takes = words ? words.join(", ")
        : kind === "number" && lowest < highest ? intervalText([lowest, highest]) : kind;
    const without = isNeeded || words || kind !== "number" ? "" : `, otherwise ${otherwise}`;
    return `${text} (${takes}${without})`;
}

// A call with what it needs
function signature({name, arguments: list}) {
    const words = list.map(argument => argument.kind === "knot" ? "x: value, …"
        : argument.isNeeded ? argument.name : `${argument.name}=…`);
    return `${name}(${words.slice(0, 6).join(", ")}${words.length > 6 ? ", …" : ""})`;
}

function functionOption(each) {
    const needed = each.arguments.filter(argument => argument.isNeeded);
    const fields = needed.map(({name, kind}) => kind === "knot" ? "${-1}: ${0}, ${1}: ${1}"
        : `\${${name}}`);
    return snippetCompletion(`${each.name}(${fields.join(", ")}\${})`,
        {label: each.name, type: "function", detail: each.text.replace(/\.$/, "")});
}

function argumentOptions({arguments: list}) {
    return list.flatMap(argument => argument.words
        ? argument.words.map(label => ({label, type: "enum", detail: argument.text, boost: 2}))
        : argument.kind === "number" ? [{label: `${argument.name}=`, type: "property",
            detail: argumentText(argument), boost: 1}] : []);
}

const STATEMENTS = [["param ", "a number with an interval and a slider"],
    ["out ", "an output; the first one is the height"], ["tile ", "repeats after so many units"],
    ["space 3", "noises of space"]];

// read() gives the document.
export const completion = read => context => {
    const word = context.matchBefore(/[A-Za-z_]\w*/), {functions, entries} = read();
    if (word === null && !context.explicit) {
        return null;
    }
    const text = context.state.doc.toString(), from = word?.from ?? context.pos;
    const line = context.state.doc.lineAt(from), open = callAt(text, from);
    if (line.from === from && open === "") {
        return {from, options: STATEMENTS.map(([label, detail]) =>
            ({label, detail, type: "keyword"})), validFor: /^\w*$/};
    }
    const before = entries.filter(({span}) => span[1] < line.from);
    const call = functions.find(({name}) => name === open);
    return {from, validFor: /^\w*$/, options: [
        ...(call ? argumentOptions(call) : []),
        ...before.map(({name, kind, isParam}) => ({label: name, type: isParam ? "constant"
            : "variable", detail: isParam ? "parameter" : kind})),
        ...["x", "y", "z"].map(label => ({label, type: "variable", detail: "the place"})),
        ...functions.map(functionOption),
    ]};
};

// Lines of help for the word at `at`: {from, to, title, lines}; null: there is none.
export function helpAt({text, functions, entries}, at) {
    const before = /\w*$/.exec(text.slice(0, at))[0], behind = /^\w*/.exec(text.slice(at))[0];
    const word = before + behind, from = at - before.length, to = at + behind.length;
    const place = {from, to};
    if (!WORD.test(word)) {
        return null;
    }
    const isCall = /^\s*\(/.test(text.slice(to));
    const called = isCall && functions.find(({name}) => name === word);
    if (called) {
        return {...place, title: signature(called), lines: [called.text,
            ...(formulas[word] ?? []),
            ...called.arguments.map(argument => [argument.name, argumentText(argument)])]};
    }
    const open = functions.find(({name}) => name === callAt(text, from));
    const argument = open?.arguments.find(({name, words}) => words?.includes(word) ||
        name === word && /^\s*=/.test(text.slice(to)));
    if (argument) {
        return {...place, title: `${open.name}: ${argument.name}`, lines: [argumentText(argument)]};
    }
    const entry = entries.find(({name}) => name === word);
    return entry ? {...place, title: word, lines: aboutEntry(entry)} : null;
}

function aboutEntry({kind, isParam, value, slider, range, axes, order}) {
    if (isParam) {
        return [`a parameter, ${numberText(value)}, from ${numberText(slider[0])} to ` +
            numberText(slider[1])];
    }
    if (kind === "bad") {
        return ["has an error, or uses what has one"];
    }
    if (kind === "number") {
        return [`a number: ${numberText(value)}`];
    }
    const depends = ["x", "y", "z"].filter((_, i) => axes & 1 << i).join(", ");
    return [`a ${kind} of ${depends || "no axis"}`, `never outside of ${intervalText(range)}`,
        ["no derivatives", "exact gradient", "exact gradient and Hessian"][Math.min(order, 2)]];
}
