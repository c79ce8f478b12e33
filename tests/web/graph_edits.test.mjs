// SPDX-License-Identifier: MIT
//
// Gestures of the graph as edits of texts: each on every place of every recipe of the program and
// of the examples, and thousands in a row at random. No edit that is done brings an error, changes
// are small and in order, and taking them back gives the old bytes.
//
// SCARP_PACKAGE is the folder of the npm package, SCARP_GRAPH that of the page's sources.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const load = (folder, name) => import(pathToFileURL(join(process.env[folder], name)));
const { load: loadScarp } = await load('SCARP_PACKAGE', 'scarp.mjs');
const { applied, readDocument } = await load('SCARP_GRAPH', 'document.js');
const graph = (name) => load('SCARP_GRAPH', `graph/${name}.js`);
const { modelOf, bare, isCall, isNumber, isUse, within, numberText } = await graph('model');
const { accept, Draft } = await graph('trial');
const edits = await graph('edits');
const calls = await graph('arguments');
const { offersFor } = await graph('offers');
const { cardsOf, wiresOf } = await graph('rows');

const scarp = await loadScarp();
const read = (text) => readDocument(scarp, text);
const folders = ['src/cli/presets', 'src/examples/recipes'];
const texts = new Map(
    folders.flatMap((folder) =>
        readdirSync(join(root, folder))
            .filter((name) => name.endsWith('.recipe'))
            .map((name) => [`${folder}/${name}`, readFileSync(join(root, folder, name), 'utf8')]),
    ),
);

// What takes changes back
function inverse(text, changes) {
    let by = 0;
    return changes.map(({ from, to, insert }) => {
        const at = from + by;
        by += insert.length - (to - from);
        return { from: at, to: at + insert.length, insert: text.slice(from, to) };
    });
}

// A result that was done is one that can be done and taken back. Returns the new model, or null.
function check(model, result, what) {
    if (result.refusal !== undefined) {
        assert.equal(typeof result.refusal, 'string', what);
        assert.ok(result.refusal.length > 3, what);
        return null;
    }
    let at = 0;
    for (const { from, to, insert } of result.changes) {
        assert.ok(at <= from && from <= to && to <= model.text.length, what);
        assert.equal(typeof insert, 'string', what);
        at = to;
    }
    const text = applied(model.text, result.changes);
    assert.equal(text, result.document.text, what);
    const document = read(text);
    assert.ok(document.errors.length <= model.document.errors.length, what);
    assert.equal(applied(text, inverse(model.text, result.changes)), model.text, what);
    return modelOf(document);
}

// All gestures of a model, as [what, function]
function* gestures(model) {
    const pull = (what, call) => [what, () => call(model, read)];
    for (const statement of model.statements) {
        const { name } = statement;
        yield pull(`delete ${name}`, (m, r) => edits.remove(m, r, statement));
        yield pull(`inline ${name}`, (m, r) => edits.inline(m, r, statement));
        yield pull(`rename ${name}`, (m, r) => edits.rename(m, r, statement, `${name}_9`));
        yield pull(`out ${name}`, (m, r) => edits.toggleOut(m, r, statement));
        yield pull(`place ${name}`, (m, r) => edits.setPlaces(m, r, [[name, 10.4, -7]]));
        if (statement.isParam) {
            yield pull(`value ${name}`, (m, r) =>
                edits.setValue(m, r, statement, numberText(statement.slider[1] / 2)));
            yield pull(`interval ${name}`, (m, r) => edits.setInterval(m, r, statement, -9, 99999));
        }
    }
    for (const part of model.parts) {
        const what = `${part.index}: ${model.text.slice(...part.span)}`;
        if (part.kind === 'word' || part.kind === 'knot') {
            continue;
        }
        yield pull(`unplug ${what}`, (m, r) => edits.unplug(m, r, part));
        yield pull(`drop ${what}`, (m, r) => edits.dropOperand(m, r, part));
        yield pull(`extract ${what}`, (m, r) => edits.extract(m, r, part));
        yield pull(`bypass ${what}`, (m, r) => edits.bypass(m, r, part));
        for (const operation of ['+', '*', '-', '/']) {
            yield pull(`${operation} ${what}`, (m, r) =>
                edits.addOperand(m, r, part, operation, '2'));
        }
        if (isCall(part)) {
            yield* gesturesOfCall(model, part, pull, what);
        }
    }
    yield pull('space', (m, r) => edits.setSetting(m, r, 'space', '3'));
    yield pull('tile', (m, r) => edits.setSetting(m, r, 'tile', '512, 512'));
    yield pull('forget', (m, r) => edits.forgetPlaces(m, r));
}

function* gesturesOfCall(model, part, pull, what) {
    const signature = model.functions[part.function];
    for (const slot of signature.arguments.filter(({ words }) => words !== null)) {
        for (const word of ['', ...slot.words]) {
            yield pull(`word ${word} ${what}`, (m, r) => calls.setWord(m, r, part, slot, word));
        }
    }
    for (const slot of calls.missing(model, part)) {
        yield pull(`argument ${slot.name} ${what}`, (m, r) => calls.addArgument(m, r, part, slot));
    }
    for (const [i, knot] of calls.knotsOf(part).entries()) {
        const x = numberText(knot.x.value + 0.01);
        yield pull(`knot ${i} ${what}`, (m, r) => calls.moveKnot(m, r, part, i, x, null));
        yield pull(`no knot ${i} ${what}`, (m, r) => calls.removeKnot(m, r, part, i));
        yield pull(`a knot ${i} ${what}`, (m, r) =>
            calls.addKnot(m, r, part, knot.x.value + 0.01, `${x}: 0`));
    }
}

for (const [name, text] of texts) {
    test(`each gesture on ${name}`, () => {
        const model = modelOf(read(text));
        assert.equal(model.document.ok, true);
        let done = 0;
        for (const [what, gesture] of gestures(model)) {
            done += check(model, gesture(), what) !== null;
        }
        assert.ok(done > 8 * model.statements.length, `${done} gestures are done`);
    });

    test(`wires of ${name}`, () => {
        const model = modelOf(read(text));
        const uses = model.parts.filter((part) => isUse(part) || isNumber(part));
        for (const part of uses.filter((_, i) => i % 3 === 0)) {
            for (const source of model.statements) {
                const what = `${source.name} to ${part.index}`;
                const next = check(model, edits.wire(model, read, source, part), what);
                if (next !== null && source.index !== part.entry) {
                    const count = next.byName.get(source.name).uses.length;
                    assert.equal(count, source.uses.length + 1, what);
                }
            }
        }
    });

    test(`offers on ${name}`, () => {
        const model = modelOf(read(text));
        const fields = model.statements.filter((statement) => !statement.isParam);
        const use = model.parts.find(isUse);
        const contexts = [{}, { source: fields[0] }, { target: use, source: model.statements[use.entry],
            isWire: true }, { target: use }, { target: model.parts.findLast(isNumber) }];
        for (const context of contexts) {
            const offers = offersFor(model, context);
            const names = new Set();
            for (const offer of offers) {
                const result = offer.attempt(model, read);
                const next = check(model, result, offer.name);
                if (next !== null) {
                    names.add(offer.name);
                    assert.ok(next.byName.has(result.name), offer.name);
                }
            }
            if (context.source && !context.target) {
                for (const name of ['warp', 'turn', 'at', 'smoothstep', 'terrace', 'curve', 'blend',
                    'mix', 'min', 'sum', 'product']) {
                    assert.ok(names.has(name), `${name} comes from ${context.source.name}`);
                }
            }
            // Where a noise or a number is expected, few functions fit.
            if (context.target?.slot?.kind === 'number') {
                assert.ok(names.has(context.isWire ? 'sum' : 'parameter'), [...names].join());
                assert.ok(!names.has('terrace'));
            } else if (context.target?.slot?.kind === 'noise') {
                assert.ok(names.has('warp') && !names.has('terrace'), [...names].join());
            } else {
                assert.ok(names.size > 3, `${names.size} offers for ${Object.keys(context)}`);
            }
        }
    });
}

// What some gestures make of a text
const TEXT = `recipe 1
param tall = 90 [0, 400] # metres
bend = noise(size=300, amplitude=60)
# The ridges
ridges = warp(noise(ridged, size=200), bend)
land = tall * clamp(ridges, lo=-0.5 * tall, hi=1) - bend / 2

# What is on it
bumps = noise(size=9) # small
all = land + bumps
`;
const partOf = (model, text, i = 0) =>
    model.parts.filter((part) => model.text.slice(...part.span) === text)[i];
const named = (model, name) => model.byName.get(name);
const MADE = [
    ['a wire upwards takes the line, its comment, and what it needs',
        (m) => edits.wire(m, read, named(m, 'bumps'), partOf(m, 'bend', 0)),
        [['ridged, size=200), bend)', 'ridged, size=200), bumps)'],
            ['\n# What is on it\nbumps = noise(size=9) # small\n', '\n'],
            ['# The ridges', '# What is on it\nbumps = noise(size=9) # small\n# The ridges']]],
    ['a warp without its noise', (m) => edits.unplug(m, read, partOf(m, 'bend', 0)),
        [['warp(noise(ridged, size=200), bend)', 'noise(ridged, size=200)']]],
    ['a factor is 1', (m) => edits.unplug(m, read, partOf(m, 'tall', 0)),
        [['land = tall *', 'land = 1 *']]],
    ['a term is 0', (m) => edits.unplug(m, read, partOf(m, 'bumps')), [['land + bumps', 'land + 0']]],
    ['a statement goes; a comment above more lines stays', (m) => edits.remove(m, read, named(m, 'ridges')),
        [['# The ridges\nridges = warp(noise(ridged, size=200), bend)\n', '# The ridges\n'],
            ['clamp(ridges,', 'clamp(0,']]],
    ['a statement is put into its uses', (m) => edits.inline(m, read, named(m, 'land')),
        [['land = tall * clamp(ridges, lo=-0.5 * tall, hi=1) - bend / 2\n', ''],
            ['all = land', 'all = (tall * clamp(ridges, lo=-0.5 * tall, hi=1) - bend / 2)']]],
    ['a number becomes a parameter', (m) => edits.extract(m, read, partOf(m, '300')),
        [['\nbend', '\nparam size = 300 [1, 10000]\nbend'], ['size=300', 'size=size']]],
    ['a part becomes a statement', (m) => edits.extract(m, read, partOf(m, '-0.5 * tall')),
        [['\nland', '\npart = -0.5 * tall\nland'], ['lo=-0.5 * tall', 'lo=part']]],
    ['a call is taken away', (m) => edits.bypass(m, read,
        partOf(m, 'clamp(ridges, lo=-0.5 * tall, hi=1)')),
        [['clamp(ridges, lo=-0.5 * tall, hi=1)', 'ridges']]],
    ['a first operand goes', (m) => edits.dropOperand(m, read, partOf(m, 'land')),
        [['all = land + bumps', 'all = bumps']]],
    ['a factor more around a sum', (m) => edits.addOperand(m, read, named(m, 'all').root, '*', '1'),
        [['all = land + bumps', 'all = (land + bumps) * 1']]],
];

for (const [what, gesture, changes] of MADE) {
    test(what, () => {
        const model = modelOf(read(TEXT));
        const expected = changes.reduce((text, [old, next]) => {
            assert.ok(text.includes(old), old);
            return text.replace(old, next);
        }, TEXT);
        const result = gesture(model);
        check(model, result, what);
        assert.equal(result.refusal ?? applied(TEXT, result.changes), expected);
    });
}

function random(seed) {
    let state = seed;
    return (count) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return Math.floor((state / 2 ** 32) * count);
    };
}

test('thousands of gestures in a row, at random', () => {
    let done = 0, tried = 0;
    const next = random(20261126);
    for (const [name, text] of texts) {
        let model = modelOf(read(text));
        const history = [];
        for (let i = 0; i < 260; i++) {
            const all = [...gestures(model)];
            for (const source of model.statements) {
                const part = model.parts[next(model.parts.length)];
                if (part && part.kind !== 'word' && part.kind !== 'knot') {
                    all.push([`wire ${source.name}`, () => edits.wire(model, read, source, part)]);
                }
            }
            const offers = offersFor(model, {});
            const offer = offers[next(offers.length)];
            // Longer texts would be slower, so what makes them shorter is as likely.
            const [what, gesture] = next(5) === 0
                ? [`offer ${offer.name}`, () => offer.attempt(model, read)]
                : all[next(model.parts.length > 120 ? model.statements.length * 3 : all.length)];
            tried++;
            const after = check(model, gesture(), `${name}, ${i}: ${what}\n${model.text}`);
            if (after !== null) {
                const cards = cardsOf(after, (card) => card.length % 2 === 0);
                assert.equal(new Set(cards.map((card) => card.id)).size, cards.length);
                wiresOf(after, cards).forEach(({ part }) => assert.ok(part));
                history.push(model.text);
                model = after;
                done++;
            }
        }
    }
    assert.ok(tried > 3000 && done > 1200, `${done} of ${tried} are done`);
});
