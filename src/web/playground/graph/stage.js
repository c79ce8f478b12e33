// SPDX-License-Identifier: MIT
//
// The ground that cards lie on: where they are, how it is moved and zoomed, and what is to be seen.
import {select as select3} from "d3-selection";
import {zoom, zoomIdentity} from "d3-zoom";
import {follow} from "./dom.js";
import {setPlaces} from "./edits.js";
import {apart, arrange, placeBeside} from "./layout.js";

const SETTLED = 100; // milliseconds after which a card that moves has begun to
const NEAR = 4; // pixels that are no drag
const EDGE = 24, ABOVE = 54; // pixels around all cards
const READABLE = 0.62; // the least scale that a graph is shown at first

const keyOf = ({from, to, row}) => `${from} ${to} ${row}`;

export class Stage {
    constructor(desk) {
        this.desk = desk;
        this.laid = new Map(); // where the layout put cards
        this.ways = new Map(); // on which wires pass columns
        this.wish = null; // {name, x, y}: where the next card shall lie
        this.transform = zoomIdentity;
        this.zoom = zoom().scaleExtent([0.15, 2.5])
            .filter(event => !desk.isList && !event.button && (event.type === "wheel" ||
                !event.target.closest(".graph-card")))
            .on("zoom", ({transform}) => this.#zoomed(transform));
        select3(desk.ground).call(this.zoom).on("dblclick.zoom", null);
    }

    get isOff() {
        return this.desk.isList || this.desk.root.offsetWidth === 0;
    }

    #boxes() {
        return this.desk.cards.map(({id}) => {
            const {element, top} = this.desk.views.get(id);
            return {id, width: element.offsetWidth, height: element.offsetHeight,
                out: top.offsetTop + top.offsetHeight / 2};
        });
    }

    #ports() {
        return this.desk.wires.list.map(({from, to, row}) => ({from, to,
            port: this.desk.wires.portOf(this.desk.views.get(to), row)}));
    }

    // Lays out all cards, closed, as they are most of the time.
    layout() {
        if (this.isOff) {
            this.place();
            return;
        }
        this.desk.root.classList.add("is-measured");
        this.desk.wires.update();
        const {places, ways} = arrange(this.#boxes(), this.#ports());
        this.laid = places;
        this.ways = new Map(this.desk.wires.list.map((wire, i) => [wire, ways[i]]).map(([wire, way]) =>
            [keyOf(wire), {way, ends: [wire.from, wire.to].map(id => places.get(id))}]));
        this.desk.root.classList.remove("is-measured");
        this.place();
    }

    // Where a wire passes columns, if its cards still lie where they were laid
    wayOf(wire) {
        const found = this.ways.get(keyOf(wire));
        const isThere = found?.ends.every(({x, y}, i) => {
            const {offsetLeft, offsetTop} = this.desk.views.get(i === 0 ? wire.from : wire.to).element;
            return Math.abs(offsetLeft - x) < 2 && Math.abs(offsetTop - y) < 2;
        });
        return isThere ? found.way : [];
    }

    placeOf(id) {
        return this.desk.model.places.get(id) ?? this.laid.get(id);
    }

    // Shows each card at its place. New ones get theirs, and none covers another.
    place() {
        this.desk.wires.update();
        if (this.isOff) {
            this.desk.wires.paint();
            return;
        }
        const boxes = this.#boxes(), ports = this.#ports();
        const places = new Map(this.desk.cards.filter(({id}) => this.placeOf(id))
            .map(({id}) => [id, this.placeOf(id)]));
        for (const box of boxes) {
            if (!places.has(box.id)) {
                const place = this.wish?.name === box.id ? this.wish
                    : placeBeside(box, ports, boxes, places, this.#middle());
                this.laid.set(box.id, {x: place.x, y: place.y});
                places.set(box.id, this.laid.get(box.id));
            }
        }
        this.wish = null;
        for (const [id, {x, y}] of apart(boxes, places)) {
            const {element} = this.desk.views.get(id);
            element.style.left = `${x}px`;
            element.style.top = `${y}px`;
        }
        this.#animate();
    }

    #middle() {
        const {clientWidth, clientHeight} = this.desk.ground;
        const [x, y] = this.transform.invert([clientWidth / 2, clientHeight / 2]);
        return {x: Math.round(x), y: Math.round(y)};
    }

    // Wires follow cards while these move.
    #animate() {
        this.until = performance.now() + SETTLED;
        this.desk.wires.paint();
        const step = () => {
            const isMoving = this.desk.world.getAnimations({subtree: true}).length > 0;
            this.desk.wires.paint();
            this.frame = isMoving || performance.now() < this.until ? requestAnimationFrame(step) : 0;
        };
        this.frame ||= requestAnimationFrame(step);
    }

    // Shows all cards, or at first as many as can be read: the last ones.
    fit({isFirst = false} = {}) {
        if (this.isOff || this.desk.cards.length === 0) {
            return;
        }
        const boxes = this.#boxes().map(box => {
            const {style} = this.desk.views.get(box.id).element;
            return {...box, x: parseFloat(style.left), y: parseFloat(style.top)};
        });
        const left = Math.min(...boxes.map(({x}) => x)), top = Math.min(...boxes.map(({y}) => y));
        const right = Math.max(...boxes.map(box => box.x + box.width));
        const bottom = Math.max(...boxes.map(box => box.y + box.height));
        const wide = this.desk.ground.clientWidth - 2 * EDGE;
        const high = this.desk.ground.clientHeight - ABOVE - EDGE;
        const all = Math.min(1.1, wide / (right - left), high / (bottom - top));
        const scale = isFirst ? Math.max(all, READABLE) : all;
        const last = boxes.find(({x, width}) => x + width === right);
        // The middle of what is seen, not so far out that there is nothing
        const middle = (wish, low, high, size) => size >= high - low ? (low + high) / 2
            : Math.min(Math.max(wish, low + size / 2), high - size / 2);
        const x = middle(right, left, right, wide / scale);
        const y = middle(last.y + last.height / 2, top, bottom, high / scale);
        this.zoom.transform(select3(this.desk.ground), zoomIdentity
            .translate(EDGE + wide / 2 - scale * x, ABOVE + high / 2 - scale * y).scale(scale));
    }

    #zoomed(transform) {
        this.transform = transform;
        const {x, y, k} = transform, {style} = this.desk.ground;
        this.desk.world.style.transform = `translate(${x}px, ${y}px) scale(${k})`;
        style.backgroundPosition = `${x}px ${y}px`;
        style.backgroundSize = `${22 * k}px ${22 * k}px`;
    }

    worldAt({clientX, clientY}) {
        const {left, top} = this.desk.ground.getBoundingClientRect();
        return this.transform.invert([clientX - left, clientY - top]);
    }

    reveal(name) {
        const view = this.desk.views.get(name);
        if (!view || this.desk.root.offsetWidth === 0) {
            return;
        }
        if (this.desk.isList) {
            view.element.scrollIntoView({block: "nearest"});
            return;
        }
        const {style, offsetWidth, offsetHeight} = view.element, {k} = this.transform;
        const [left, top] = this.transform.apply([parseFloat(style.left), parseFloat(style.top)]);
        const {clientWidth, clientHeight} = this.desk.ground;
        // As little as must be; the title is seen in any case.
        const by = (low, size, first, last) => Math.max(first - low, Math.min(0, last - low - size));
        this.zoom.translateBy(select3(this.desk.ground),
            by(left, offsetWidth * k, EDGE, clientWidth - EDGE) / k,
            by(top, offsetHeight * k, ABOVE, clientHeight - EDGE) / k);
    }

    startDrag(event, view) {
        if (event.button !== 0 || this.desk.isList || this.desk.isStale ||
            event.target.closest("button, select, input, .graph-socket")) {
            return;
        }
        const {element} = view, left = element.offsetLeft, top = element.offsetTop;
        const {clientX, clientY} = event;
        let isMoved = false;
        follow(event, at => {
            const dx = at.clientX - clientX, dy = at.clientY - clientY;
            if (isMoved || Math.hypot(dx, dy) >= NEAR) {
                isMoved = true;
                element.classList.add("is-dragged");
                element.style.left = `${left + dx / this.transform.k}px`;
                element.style.top = `${top + dy / this.transform.k}px`;
                this.desk.wires.paint();
            }
        }, () => {
            element.classList.remove("is-dragged");
            if (isMoved) {
                this.move(view.card, parseFloat(element.style.left), parseFloat(element.style.top));
            }
        });
    }

    // A card that is moved by hand is stored in the text; small ones are not.
    move(card, x, y, join = false) {
        if (card.isSub) {
            this.laid.set(card.id, {x, y});
            this.place();
        } else if (!this.desk.perform((model, read) => setPlaces(model, read, [[card.id, x, y]]),
            {join, says: `${card.title} is moved`})) {
            this.place();
        }
    }
}
