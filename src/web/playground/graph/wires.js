// SPDX-License-Identifier: MIT
//
// Wires between cards: how they are drawn, and how they are pulled with a pointer.
import {placeUnder} from "./cards.js";
import {draw, follow} from "./dom.js";
import {extract, unplug, wire} from "./edits.js";
import {wiresOf} from "./rows.js";
import {Draft, moved} from "./trial.js";

const NEAR = 5; // pixels that are no drag

function curveTo([x0, y0], [x1, y1]) {
    const bend = Math.max(34, Math.min(150, Math.abs(x1 - x0) / 2));
    return `M${x0},${y0}C${x0 + bend},${y0} ${x1 - bend},${y1} ${x1},${y1}`;
}

// Through the ways on which it passes columns
function pathOf(start, ways, end) {
    let path = "", at = start;
    for (const [x0, x1, y] of ways) {
        path += `${curveTo(at, [x0, y])}H${x1}`;
        at = [x1, y];
    }
    return path + curveTo(at, end);
}

export class Wires {
    constructor(desk, svg) {
        this.desk = desk;
        this.svg = svg;
        this.list = [];
        this.loose = null;
    }

    // Where a card gives, in units of the world
    outOf({element, top}) {
        return [element.offsetLeft + element.offsetWidth,
            element.offsetTop + top.offsetTop + top.offsetHeight / 2 + 1];
    }

    // The height of a row in its card; what is hidden takes at the title.
    portOf(view, index) {
        const row = view.rows[index]?.element;
        return row?.offsetHeight > 0 ? row.offsetTop + row.offsetHeight / 2 + 1
            : view.top.offsetHeight / 2 + 1;
    }

    intoRow(view, index) {
        return [view.element.offsetLeft, view.element.offsetTop + this.portOf(view, index)];
    }

    update() {
        this.list = wiresOf(this.desk.model, this.desk.cards);
    }

    paint() {
        const {desk} = this, made = [], selected = desk.selectedName;
        if (desk.isList) {
            this.svg.replaceChildren();
            return;
        }
        for (const item of this.list) {
            const from = desk.views.get(item.from), to = desk.views.get(item.to);
            const d = pathOf(this.outOf(from), desk.stage.wayOf(item), this.intoRow(to, item.row));
            const isLit = [from, to].some(({card}) => card.statement.name === selected);
            made.push(draw("path", {d, class: `is-${from.card.type}${isLit ? " is-lit" : ""}`}));
            made.push(this.#hit(d, item));
        }
        if (this.loose) {
            made.push(draw("path", {d: this.loose, class: "is-loose"}));
        }
        this.svg.replaceChildren(...made);
    }

    // A wide path that takes the pointer
    #hit(d, {part, from}) {
        const {desk} = this, {card} = desk.views.get(from);
        return draw("path", {d, class: "is-hit", "data-from": from, "data-part": part.index,
            onclick: event => {
                if (event.altKey) {
                    desk.perform((model, read) => unplug(model, read, part),
                        {says: `${card.title} is taken off`});
                }
            },
            ondblclick: event => {
                event.stopPropagation();
                desk.openMenu({x: event.clientX, y: event.clientY}, {target: part, isWire: true,
                    source: card.isSub ? null : card.statement, wish: null});
            }});
    }

    // Pulls a wire out of a card, off an input, or from an input that has none.
    start(event, {card, row}) {
        const {desk} = this;
        if (event.button !== 0 || desk.isList || desk.isStale) {
            return;
        }
        event.preventDefault();
        event.stopPropagation();
        const isPlugged = row?.type === "input" && row.part.entry >= 0;
        const pull = row === undefined ? {card, from: null}
            : isPlugged ? {card: desk.views.get(desk.model.statements[row.part.entry].name).card,
                from: row.part}
                : {target: row.part, view: desk.views.get(card.id), row: card.rows.indexOf(row)};
        const start = [event.clientX, event.clientY];
        let isPulled = false;
        follow(event, at => {
            if (!isPulled && Math.hypot(at.clientX - start[0], at.clientY - start[1]) >= NEAR) {
                isPulled = true;
                this.#mark(pull);
            }
            if (isPulled) {
                const point = desk.stage.worldAt(at);
                this.loose = pull.card ? curveTo(this.outOf(desk.views.get(pull.card.id)), point)
                    : curveTo(point, this.intoRow(pull.view, pull.row));
                this.paint();
            }
        }, at => {
            this.loose = null;
            this.#unmark();
            this.paint();
            if (isPulled && at.type === "pointerup") {
                this.#drop(pull, at);
            }
        });
    }

    // The edit that a wire from a card to a part is
    #edit(card, part, from) {
        return (model, read) => {
            if (!card.isSub) {
                return wire(model, read, card.statement, part, from);
            }
            const draft = new Draft(model, read), made = extract(model, read, card.part);
            draft.do(() => made);
            const start = made.refusal ? 0 : moved(made.changes, part.span[0]);
            const length = part.span[1] - part.span[0];
            const target = draft.model.parts.find(({span}) => span[0] === start &&
                span[1] === start + length);
            draft.do((next, reading) => target ? wire(next, reading, next.byName.get(made.name),
                target) : {refusal: "this is a part of what it would go to"});
            return draft.result;
        };
    }

    #mark({card, from, target}) {
        const {desk} = this, {model, read} = desk;
        desk.root.classList.add("is-wiring");
        for (const view of desk.views.values()) {
            if (target) {
                view.element.classList.toggle("is-fitting", !view.card.isSub &&
                    !wire(model, read, view.card.statement, target).refusal);
                continue;
            }
            for (const {row, element, isPlace} of view.rows) {
                const fits = isPlace && row.part !== from && element.offsetHeight > 0 &&
                    !this.#edit(card, row.part, null)(model, read).refusal;
                element.classList.toggle("is-fitting", fits);
            }
        }
    }

    #unmark() {
        const {root} = this.desk;
        root.classList.remove("is-wiring");
        root.querySelectorAll(".is-fitting").forEach(element =>
            element.classList.remove("is-fitting"));
    }

    #drop({card, from, target}, event) {
        const {desk} = this, {clientX: x, clientY: y} = event;
        const under = document.elementFromPoint(x, y);
        const view = desk.viewOf(under);
        if (!view && !desk.ground.contains(under)) {
            return;
        }
        if (target) {
            if (view && !view.card.isSub) {
                this.#connect(view.card, target, null);
            } else if (!view) {
                desk.openMenu({x, y}, {target, wish: desk.stage.worldAt(event)});
            }
            return;
        }
        const part = view && placeUnder(desk.model, under, view);
        if (part) {
            if (part !== from) {
                this.#connect(card, part, from);
            }
        } else if (!view && from) {
            desk.perform((model, read) => unplug(model, read, from),
                {says: `${card.title} is taken off`});
        } else if (!view && !card.isSub) {
            desk.openMenu({x, y}, {source: card.statement, wish: desk.stage.worldAt(event)});
        } else if (view && view.card !== card) {
            desk.say("A wire ends at an input or at a number.");
        }
    }

    #connect(card, part, from) {
        this.desk.perform(this.#edit(card, part, from),
            {says: `${card.title} goes to ${part.statement.name}`});
    }
}
