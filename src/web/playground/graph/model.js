// SPDX-License-Identifier: MIT
//
// A document as a tree: statements with their lines and comments, parts with their children, and
// which argument of its function each child is. Spans and kinds are those of the module.

const PLACE = /^#:[ \t]*([A-Za-z_]\w*)[ \t]+(-?\d+)[ \t]+(-?\d+)[ \t]*$/;
const NUMBER = "-?\\s*[\\d.]+(?:[eE][-+]?\\d+)?";
const INTERVAL = new RegExp(`\\[\\s*(${NUMBER})\\s*,\\s*(${NUMBER})\\s*\\]`);

// The lines of a text: {from, to, end}, with `end` behind the newline
function linesOf(text) {
    const lines = [];
    for (let from = 0; from < text.length || lines.length === 0;) {
        const at = text.indexOf("\n", from), end = at < 0 ? text.length : at + 1;
        lines.push({from, to: at < 0 ? end : at, end, text: text.slice(from, at < 0 ? end : at)
            .replace(/\r$/, "")});
        from = end;
    }
    return lines;
}

// The span of a part without the parentheses around it
export function bare(model, part) {
    let [from, to] = part.span;
    const inside = part.nameSpan?.[0] ?? (part.children.length > 0 && part.operation !== "" &&
        !isSign(part) ? part.children[0].span[0] : Infinity);
    while (model.text[from] === "(" && from < inside) {
        from += /^\(\s*/.exec(model.text.slice(from, to))[0].length;
        to -= /\s*\)$/.exec(model.text.slice(from, to))?.[0].length ?? 0;
    }
    return [from, to];
}

export const isSign = part => part.operation === "-" && part.children.length === 1;
export const isCall = part => part.function >= 0;
export const isNumber = part => part.operation === "" && part.nameSpan === null &&
    part.children.length === 0;
export const isUse = part => part.entry >= 0;
export const isLeaf = part => part.children.length === 0 && !isCall(part);
export const isWrapped = (model, part) => bare(model, part)[0] !== part.span[0];
export const textOf = (model, part) => model.text.slice(...part.span);

// All parts below one, and itself, in the order of the text
export function* within(part) {
    yield part;
    for (const child of part.children) {
        yield* within(child);
    }
}

// Tells each child of a call its argument: words have their own, others stand in order.
function bind(call, signature) {
    let position = 0;
    for (const child of call.children) {
        if (child.argumentSpan) {
            child.slot = signature.arguments.find(a => a.name === child.argument) ?? null;
        } else if (child.kind === "word") {
            child.slot = signature.arguments.find(a => a.words?.includes(child.name)) ?? null;
        } else if (child.kind === "knot") {
            child.slot = signature.arguments.find(a => a.kind === "knot") ?? null;
        } else {
            child.slot = signature.arguments[position++] ?? null;
        }
    }
}

function partsOf(document) {
    const parts = document.parts.map(part => ({...part, operation: part.operation || "",
        nameSpan: part.nameSpan ?? null, argumentSpan: part.argumentSpan ?? null, children: [],
        slot: null, above: null, statement: null}));
    for (const part of parts) {
        if (part.parent >= 0) {
            part.above = parts[part.parent];
            part.above.children.push(part);
        }
    }
    for (const part of parts) {
        part.children.sort((a, b) => a.span[0] - b.span[0]);
        if (part.function >= 0) {
            bind(part, document.functions[part.function]);
        }
    }
    return parts;
}

const isComment = line => /^[ \t]*#(?!:)/.test(line.text);

// Lines of a statement, and of the comments right above it
function blockOf(lines, [from, to]) {
    const first = lines.findLastIndex(line => line.from <= from);
    const last = lines.findLastIndex(line => line.from < Math.max(to, from + 1));
    let top = first;
    while (top > 0 && isComment(lines[top - 1])) {
        top--;
    }
    return {first: lines[first].from, end: lines[last].end, top: lines[top].from,
        isFollowed: lines[last + 1] !== undefined && lines[last + 1].text.trim() !== "",
        above: lines.slice(top, first).map(line => line.text)};
}

const words = comment => comment.replace(/^[ \t]*#[ \t]*/, "").trim();

function statementOf(entry, model, parts, lines) {
    const root = entry.part >= 0 ? parts[entry.part] : null;
    const from = root?.span[1] ?? entry.nameSpan[1];
    const tail = model.text.slice(from, Math.max(entry.span[1], from));
    const hash = tail.indexOf("#");
    const statement = {...entry, entry, root, ...blockOf(lines, entry.span),
        note: hash < 0 ? "" : words(tail.slice(hash)),
        isExplicitOut: !entry.isParam && entry.span[0] < entry.nameSpan[0], uses: []};
    statement.noteAbove = statement.above.map(words).join(" ");
    if (entry.isParam) {
        const body = hash < 0 ? tail : tail.slice(0, hash), found = INTERVAL.exec(body);
        const at = from + (found?.index ?? 0);
        statement.intervalSpan = found && [at, at + found[0].length];
    }
    for (const part of root ? within(root) : []) {
        part.statement = statement;
    }
    return statement;
}

// space and tile: the module has no entries of settings, which stand on lines of their own.
function settingsOf(lines, end) {
    const settings = {recipe: null, space: null, tile: null};
    for (const line of lines) {
        const found = /^(recipe|space|tile)\b[ \t]*([^#]*)/.exec(line.text);
        if (found && line.from < end) {
            const from = line.from + found[0].indexOf(found[2], found[1].length);
            settings[found[1]] = {line, text: found[2].trim(),
                span: [from, from + found[2].trimEnd().length]};
        }
    }
    return settings;
}

function placesOf(lines) {
    const places = new Map();
    for (const line of lines) {
        const found = PLACE.exec(line.text);
        if (found) {
            places.set(found[1], {x: Number(found[2]), y: Number(found[3]), line});
        }
    }
    return places;
}

// {document, text, functions, statements, parts, byName, settings, places, newline}
export function modelOf(document) {
    const {text, functions} = document, lines = linesOf(text), parts = partsOf(document);
    const model = {document, text, functions, parts, lines,
        newline: text.includes("\r\n") ? "\r\n" : "\n"};
    model.statements = document.entries.map(entry => statementOf(entry, model, parts, lines));
    model.byName = new Map(model.statements.map(statement => [statement.name, statement]));
    model.settings = settingsOf(lines, model.statements[0]?.span[0] ?? text.length);
    model.places = placesOf(lines);
    for (const part of parts) {
        if (part.entry >= 0) {
            model.statements[part.entry].uses.push(part);
        }
    }
    return model;
}

// The statements that one needs, itself included
export function needsOf(model, statement, found = new Set()) {
    if (!found.has(statement)) {
        found.add(statement);
        for (const part of statement.root ? within(statement.root) : []) {
            if (part.entry >= 0) {
                needsOf(model, model.statements[part.entry], found);
            }
        }
    }
    return found;
}

export const functionOf = (model, part) => model.functions[part.function];

// The shortest text of a number in some digits behind the point
export function numberText(value, step = 1e-6) {
    const digits = Math.max(0, Math.min(9, Math.ceil(-Math.log10(step) - 1e-9)));
    const text = value.toFixed(digits);
    return (digits > 0 ? text.replace(/\.?0+$/, "") : text).replace(/^-0$/, "0");
}

// The same for readers: three digits, and a minus sign
export function shortNumber(value) {
    if (!Number.isFinite(value)) {
        return value < 0 ? "−∞" : value > 0 ? "∞" : "none";
    }
    const size = Math.abs(value);
    const text = size < 1e-9 ? "0" : size >= 1e6 || size < 1e-3 ? value.toExponential(1)
        : numberText(value, size >= 100 ? 1 : size >= 10 ? 0.1 : 0.01);
    return text.replace("-", "−");
}
