// SPDX-License-Identifier: MIT
//
// Where cards lie. dagre finds ranks and a first order; then sources of a rank are sorted by the
// inputs that they go to, which dagre does not know. Cards are {id, width, height}, wires {from, to,
// port} with the height of the input in its card; places are a Map of ids to {x, y}. Wires that pass a
// column have a place of their own in it, so that they do not go behind its cards.
//
// Cards are laid out when a recipe is opened, by Tidy, and when operators are spread out. Nothing else
// moves a card, but for those below one that opens. A card that was moved by hand has a line
// `#: name x y` in the text.
import {Graph, layout} from "@dagrejs/dagre";

const GAP = 22, RANKS = 48, SWEEPS = 8;
const WIRE = 6; // the height that a wire takes where it passes

// How many pairs of wires between the same two columns cross
export function crossings(cards, wires, places) {
    const boxes = new Map(cards.map(card => [card.id, card]));
    const lines = wires.map(({from, to, port}) => ({
        x0: places.get(from).x, x1: places.get(to).x,
        y0: places.get(from).y + boxes.get(from).out, y1: places.get(to).y + port}));
    let count = 0;
    for (let i = 0; i < lines.length; i++) {
        for (let j = 0; j < i; j++) {
            const a = lines[i], b = lines[j];
            const left = Math.max(a.x0, b.x0), right = Math.min(a.x1, b.x1);
            const at = ({x0, x1, y0, y1}, x) => x1 === x0 ? y0 : y0 + (y1 - y0) * (x - x0) / (x1 - x0);
            count += left < right && (at(a, left) - at(b, left)) * (at(a, right) - at(b, right)) < 0;
        }
    }
    return count;
}

function firstPlaces(cards, wires) {
    const graph = new Graph().setGraph({rankdir: "LR", nodesep: GAP, ranksep: RANKS,
        ranker: "network-simplex"}).setDefaultEdgeLabel(() => ({}));
    for (const {id, width, height} of cards) {
        graph.setNode(id, {width, height});
    }
    for (const {from, to} of wires) {
        graph.setEdge(from, to, {weight: 1});
    }
    layout(graph);
    return new Map(cards.map(({id, width, height}) => {
        const {x, y} = graph.node(id);
        return [id, {x: x - width / 2, y: y - height / 2, middle: x}];
    }));
}

// Puts the cards of a column below each other, each as near as can be to where it is wanted.
export function stack(column, wanted) {
    const blocks = [];
    for (const card of column) {
        const height = card.height + GAP;
        let block = {cards: [card], size: height, sum: wanted.get(card.id), offset: 0};
        block.y = block.sum;
        // Blocks that overlap become one, at the mean of what its cards want.
        while (blocks.length > 0 && blocks[blocks.length - 1].y + blocks[blocks.length - 1].size >
            block.y) {
            const above = blocks.pop();
            const sum = above.sum + block.sum - block.cards.length * above.size;
            const list = [...above.cards, ...block.cards];
            block = {cards: list, size: above.size + block.size, sum, y: sum / list.length};
        }
        blocks.push(block);
    }
    const places = new Map();
    for (const {cards, y} of blocks) {
        let at = y;
        for (const card of cards) {
            places.set(card.id, at);
            at += card.height + GAP;
        }
    }
    return places;
}

// The columns from left to right, each from top to bottom
function columnsOf(cards, places) {
    const columns = new Map();
    for (const card of cards) {
        const {middle} = places.get(card.id);
        columns.set(middle, [...(columns.get(middle) ?? []), card]);
    }
    return [...columns].sort(([a], [b]) => a - b).map(([, column]) =>
        column.sort((a, b) => places.get(a.id).y - places.get(b.id).y));
}

// Sorts each column by where its wires go (or come from), and moves its cards towards there.
function sweep(columns, wires, places, out, isBack) {
    const order = isBack ? [...columns].reverse() : columns;
    for (const column of order) {
        const wanted = new Map(column.map(card => {
            const ends = wires.filter(wire => (isBack ? wire.from : wire.to) === card.id)
                .map(({from, to, port}) => isBack ? places.get(to).y + port - out.get(from)
                    : places.get(from).y + out.get(from) - port);
            const mean = ends.reduce((sum, y) => sum + y, 0) / ends.length;
            return [card.id, ends.length > 0 ? mean : places.get(card.id).y];
        }));
        column.sort((a, b) => wanted.get(a.id) - wanted.get(b.id));
        for (const [id, y] of stack(column, wanted)) {
            places.set(id, {...places.get(id), y});
        }
    }
}

// Makes small cards where wires pass columns: {all, parts, passes}, with the parts that wires are cut
// into, and for each wire what it passes.
function cut(cards, wires, places) {
    const columns = columnsOf(cards, places), all = [...cards], parts = [];
    const columnOf = new Map(columns.flatMap((column, i) => column.map(({id}) => [id, i])));
    const passes = wires.map(({from, to, port}, i) => {
        const first = columnOf.get(from), last = columnOf.get(to), list = [];
        let before = from;
        for (let c = first + 1; c < last; c++) {
            const {middle} = places.get(columns[c][0].id), share = (c - first) / (last - first);
            const width = Math.max(...columns[c].map(card => card.width));
            const pass = {id: `${i} passes ${c}`, width, height: WIRE, out: WIRE / 2};
            places.set(pass.id, {x: middle - width / 2, middle, y: places.get(from).y * (1 - share) +
                (places.get(to).y + port) * share});
            all.push(pass);
            list.push(pass);
            parts.push({from: before, to: pass.id, port: WIRE / 2});
            before = pass.id;
        }
        parts.push({from: before, to, port});
        return list;
    });
    return {all, parts, passes};
}

// Places for all cards, and for each wire the ways [x0, x1, y] on which it passes columns
export function arrange(cards, wires) {
    if (cards.length === 0) {
        return {places: new Map(), ways: []};
    }
    let places = firstPlaces(cards, wires);
    const {all, parts, passes} = cut(cards, wires, places);
    const out = new Map(all.map(card => [card.id, card.out]));
    let best = places, fewest = Infinity;
    for (let i = 0; i < SWEEPS; i++) {
        places = new Map([...places].map(([id, place]) => [id, {...place}]));
        sweep(columnsOf(all, places), parts, places, out, i % 2 === 0);
        const count = crossings(all, parts, places);
        if (count < fewest) {
            [best, fewest] = [places, count];
        }
    }
    const round = id => ({x: Math.round(best.get(id).x), y: Math.round(best.get(id).y)});
    return {places: new Map(cards.map(({id}) => [id, round(id)])),
        ways: passes.map(list => list.map(({id, width, out: middle}) => {
            const {x, y} = round(id);
            return [x, x + width, y + middle];
        }))};
}

const meet = (a, b, gap) => a.x < b.x + b.width + gap && b.x < a.x + a.width + gap &&
    a.y < b.y + b.height + gap && b.y < a.y + a.height + gap;

// Where cards are shown so that none covers another: those that would be covered go down. The card
// `first` stays where it is.
export function apart(cards, places, first = null, gap = 10) {
    const shown = [], result = new Map();
    const boxes = cards.map(card => ({...card, ...places.get(card.id)}));
    boxes.sort((a, b) => (b.id === first) - (a.id === first) || a.y - b.y || a.x - b.x);
    for (const box of boxes) {
        for (let hit = true; hit;) {
            hit = shown.find(other => meet(box, other, gap - 0.5));
            if (hit) {
                box.y = hit.y + hit.height + gap;
            }
        }
        shown.push(box);
        result.set(box.id, {x: box.x, y: box.y});
    }
    return result;
}

// A place for a card that is new: right of what it comes from, else left of where it goes.
export function placeBeside(card, wires, cards, places, otherwise) {
    const boxes = new Map(cards.map(other => [other.id, other]));
    const sources = wires.filter(wire => wire.to === card.id && places.has(wire.from));
    const targets = wires.filter(wire => wire.from === card.id && places.has(wire.to));
    let {x, y} = otherwise;
    if (sources.length > 0) {
        x = Math.max(...sources.map(({from}) => places.get(from).x + boxes.get(from).width)) + RANKS;
        y = places.get(sources[0].from).y;
    } else if (targets.length > 0) {
        x = places.get(targets[0].to).x - card.width - RANKS;
        y = places.get(targets[0].to).y + targets[0].port - card.out;
    }
    const others = cards.filter(other => other.id !== card.id && places.has(other.id))
        .map(other => ({...other, ...places.get(other.id)}));
    for (let hit = true; hit;) {
        hit = others.find(other => meet({x, y, width: card.width, height: card.height}, other, 12));
        y = hit ? hit.y + hit.height + GAP : y;
    }
    return {x: Math.round(x), y: Math.round(y)};
}
