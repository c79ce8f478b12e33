// SPDX-License-Identifier: MIT
//
// The knots of a call as a curve that is drawn: knots are dragged, or moved with the arrow keys; a
// double click adds one, or takes one away, and so do Insert and Delete.
import {addKnot, knotsOf, moveKnot, removeKnot} from "./arguments.js";
import {draw, follow, make} from "./dom.js";
import {isNumber, numberText} from "./model.js";

const WIDTH = 190, HEIGHT = 64, EDGE = 8, STEPS = 48;

// A line through knots that does not overshoot, for the picture: cubic pieces whose slopes at knots
// are the harmonic means of the slopes next to them.
export function through(points, x) {
    const last = points.length - 1;
    if (x <= points[0][0] || last === 0) {
        return points[0][1];
    }
    if (x >= points[last][0]) {
        return points[last][1];
    }
    const i = points.findIndex(([place]) => place > x) - 1;
    const rise = k => (points[k + 1][1] - points[k][1]) / (points[k + 1][0] - points[k][0]);
    const slope = k => {
        const a = k > 0 ? rise(k - 1) : 0, b = k < last ? rise(k) : 0;
        return a * b > 0 ? 2 * a * b / (a + b) : 0;
    };
    const [x0, y0] = points[i], [x1, y1] = points[i + 1], h = x1 - x0, t = (x - x0) / h;
    return y0 * (1 + 2 * t) * (1 - t) ** 2 + h * slope(i) * t * (1 - t) ** 2 +
        y1 * t * t * (3 - 2 * t) + h * slope(i + 1) * t * t * (t - 1);
}

const stepOf = size => 10 ** Math.floor(Math.log10(size / 99 || 1));

export class Curve {
    constructor(desk) {
        this.desk = desk;
        this.isHeld = false;
        this.svg = draw("svg", {viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "group",
            "aria-label": "Knots"});
        this.add = make("button", {type: "button", onclick: () => this.#more(this.focus ?? 0)},
            "+ knot");
        this.fewer = make("button", {type: "button", onclick: () => this.#less(this.focus)},
            "− knot");
        this.element = make("div", {class: "graph-curve"}, this.svg,
            make("div", {class: "graph-knots"}, this.add, this.fewer));
        this.svg.addEventListener("dblclick", event => this.#doubled(event));
        this.svg.addEventListener("pointerdown", event => this.#drag(event));
        this.svg.addEventListener("keydown", event => this.#key(event));
    }

    get #call() {
        return this.row.part;
    }

    // Knots as numbers; what is a field is drawn at the middle, and moves only along x.
    #points() {
        return knotsOf(this.#call).map(({x, value}) =>
            [x.value, isNumber(value) || value.kind === "number" ? value.value : 0]);
    }

    update(row) {
        this.row = row;
        const points = this.#points();
        if (!this.isHeld) {
            const xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
            const wide = (low, high) => high > low ? [low, high] : [low - 0.5, high + 0.5];
            this.box = [wide(Math.min(...xs), Math.max(...xs)),
                wide(Math.min(...ys), Math.max(...ys))];
        }
        this.#paint(points);
    }

    #toX = x => EDGE + (x - this.box[0][0]) / (this.box[0][1] - this.box[0][0]) * (WIDTH - 2 * EDGE);
    #toY = y => HEIGHT - EDGE - (y - this.box[1][0]) / (this.box[1][1] - this.box[1][0]) *
        (HEIGHT - 2 * EDGE);

    #at({clientX, clientY}) {
        const box = this.svg.getBoundingClientRect();
        const x = (clientX - box.left) / box.width * WIDTH, y = (clientY - box.top) / box.height * HEIGHT;
        const [[x0, x1], [y0, y1]] = this.box;
        return [x0 + (x - EDGE) / (WIDTH - 2 * EDGE) * (x1 - x0),
            y0 + (HEIGHT - EDGE - y) / (HEIGHT - 2 * EDGE) * (y1 - y0)];
    }

    #paint(points) {
        const [[x0, x1], [y0, y1]] = this.box;
        const line = Array.from({length: STEPS + 1}, (_, i) => {
            const x = x0 + (x1 - x0) * i / STEPS;
            return `${this.#toX(x).toFixed(1)},${this.#toY(through(points, x)).toFixed(1)}`;
        });
        const focused = this.svg.contains(document.activeElement) ? this.focus : null;
        const zero = y0 < 0 && y1 > 0 ? [draw("path", {class: "zero",
            d: `M0,${this.#toY(0)}H${WIDTH}`})] : [];
        const knots = points.map(([x, y], i) => draw("circle", {r: 4.5, cx: this.#toX(x),
            cy: this.#toY(y), tabindex: 0, role: "slider", "data-knot": i, "aria-valuenow": y,
            "aria-label": `Knot ${i + 1} of ${points.length}`,
            "aria-valuetext": `${numberText(y)} at ${numberText(x)}`}));
        this.svg.replaceChildren(...zero, draw("path", {d: `M${line.join("L")}`}), ...knots);
        knots.forEach((knot, i) => knot.addEventListener("focus", () => {
            this.focus = i;
        }));
        if (focused !== null) {
            knots[Math.min(focused, knots.length - 1)]?.focus({preventScroll: true});
        }
        this.fewer.disabled = points.length < 3;
    }

    // Moves a knot to a place between its neighbours. Fields keep what they are.
    #move(i, x, y, join) {
        const points = this.#points(), knot = knotsOf(this.#call)[i], [[x0, x1], [y0, y1]] = this.box;
        const step = stepOf(x1 - x0), rise = stepOf(y1 - y0);
        const low = i > 0 ? points[i - 1][0] + step : -Infinity;
        const high = i < points.length - 1 ? points[i + 1][0] - step : Infinity;
        const place = isNumber(knot.x) ? numberText(Math.min(Math.max(x, low), high), step) : null;
        const value = isNumber(knot.value) ? numberText(y, rise) : null;
        return this.desk.perform((model, read) =>
            moveKnot(model, read, this.#call, i, place, value), {join, says: null, isQuiet: true});
    }

    #drag(event) {
        const i = Number(event.target.dataset?.knot ?? NaN);
        if (event.button !== 0 || Number.isNaN(i) || this.desk.isStale) {
            return;
        }
        event.preventDefault();
        event.stopPropagation();
        event.target.focus({preventScroll: true});
        this.focus = i;
        this.isHeld = true;
        let hasBegun = false;
        follow(event, moved => {
            const [x, y] = this.#at(moved);
            hasBegun = this.#move(i, x, y, hasBegun) || hasBegun;
        }, () => {
            this.isHeld = false;
            this.update(this.row);
        });
    }

    #doubled(event) {
        event.stopPropagation();
        const i = Number(event.target.dataset?.knot ?? NaN);
        if (Number.isNaN(i)) {
            this.#put(...this.#at(event));
        } else {
            this.#less(i);
        }
    }

    #put(x, y) {
        const [[x0, x1], [y0, y1]] = this.box;
        const hasFields = knotsOf(this.#call).some(({value}) => !isNumber(value));
        const text = `${numberText(x, stepOf(x1 - x0))}: ${hasFields ? "0"
            : numberText(y, stepOf(y1 - y0))}`;
        this.desk.perform((model, read) => addKnot(model, read, this.#call, x, text),
            {says: `a knot at ${text}`});
    }

    // A knot more, in the middle between one and the next
    #more(i) {
        const points = this.#points(), at = Math.min(i, points.length - 2);
        const x = (points[at][0] + points[at + 1][0]) / 2;
        this.#put(x, through(points, x));
    }

    #less(i) {
        const at = Math.min(i ?? Infinity, knotsOf(this.#call).length - 1);
        this.desk.perform((model, read) => removeKnot(model, read, this.#call, at),
            {says: `knot ${at + 1} is gone`});
    }

    #key(event) {
        const i = Number(event.target.dataset?.knot ?? NaN);
        const move = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
        if (Number.isNaN(i)) {
            return;
        }
        if (move[event.key]) {
            const [x, y] = this.#points()[i], [[x0, x1], [y0, y1]] = this.box;
            const times = event.shiftKey ? 10 : 1, [dx, dy] = move[event.key];
            this.#move(i, x + dx * times * stepOf(x1 - x0), y + dy * times * stepOf(y1 - y0), false);
        } else if (event.key === "Insert" || event.key === "+") {
            this.#more(i);
        } else if (event.key === "Delete" || event.key === "Backspace") {
            this.#less(i);
        } else {
            return;
        }
        event.preventDefault();
        event.stopPropagation();
    }
}
