// SPDX-License-Identifier: MIT
//
// A small host of the graph: a field of text with a history of its own, and pictures of the module,
// in grey. globalThis.test has what tests ask for.
import { load } from '../../../src/web/scarp.mjs';
import { applied, readDocument } from '../../../src/web/playground/document.js';
import { createGraph } from '../../../src/web/playground/graph/graph.js';
import { arrange, crossings } from '../../../src/web/playground/graph/layout.js';

const scarp = await load();
const field = document.getElementById('text');
const past = [], future = [];
let text = '', recipe = null, pictures = 0;

const read = (some) => readDocument(scarp, some);

function show(next) {
    text = next;
    field.value = text;
    recipe?.free();
    recipe = null;
    const document = read(text);
    if (document.ok) {
        recipe = scarp.recipe(text);
    }
    graph.update(document);
}

const host = {
    read,
    edit(changes, { join = false } = {}) {
        if (!join) {
            past.push(text);
            future.length = 0;
        }
        test.edits.push(changes);
        show(applied(text, changes));
    },
    undo() {
        if (past.length > 0) {
            future.push(text);
            show(past.pop());
        }
    },
    redo() {
        if (future.length > 0) {
            past.push(text);
            show(future.pop());
        }
    },
    selected(index) {
        test.selected = index;
    },
    picture(node, width, height, callback) {
        const timer = setTimeout(() => {
            if (recipe) {
                callback(drawn(node, width, height));
            }
        }, 5);
        return () => clearTimeout(timer);
    },
};

function drawn(node, width, height) {
    pictures++;
    const step = 3000 / width, value = new Float32Array(width * height);
    const grid = { count: [width, height], step: [step, step] };
    if (recipe.isSpace) {
        grid.count.push(1);
        grid.step.push(1);
    }
    recipe.grid(grid, { value }, { which: node });
    let lowest = Infinity, highest = -Infinity;
    for (const v of value) {
        lowest = Math.min(lowest, v);
        highest = Math.max(highest, v);
    }
    const image = new ImageData(width, height);
    value.forEach((v, i) => {
        image.data.fill((255 * (v - lowest)) / (highest - lowest || 1), 4 * i, 4 * i + 3);
        image.data[4 * i + 3] = 255;
    });
    return { image, lowest, highest };
}

const graph = createGraph(document.getElementById('graph'), host);
const test = {
    edits: [], selected: null, arrange, crossings, read,
    get text() {
        return text;
    },
    get pictures() {
        return pictures;
    },
    get steps() {
        return past.length;
    },
    open(next) {
        past.length = future.length = test.edits.length = 0;
        show(next);
    },
    type(next) {
        past.push(text);
        show(next);
    },
    undo: () => host.undo(),
    select: (index) => graph.select(index),
};
globalThis.test = test;
field.addEventListener('change', () => test.type(field.value));
document.documentElement.dataset.ready = 'yes';
