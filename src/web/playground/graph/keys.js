// SPDX-License-Identifier: MIT
//
// Keys of the ground and of cards.

const STEP = 20; // units that Alt and an arrow key move a card
const AGAIN = 1000; // milliseconds in which moves are one step of the history
const WAYS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

export class Keys {
    constructor(desk) {
        this.desk = desk;
        desk.ground.addEventListener("keydown", event => this.#groundKey(event));
        desk.root.addEventListener("keydown", event => this.#anyKey(event));
        desk.root.addEventListener("pointerdown", () => {
            [this.usesPointer, this.isPressed] = [true, true];
        }, true);
        for (const end of ["pointerup", "pointercancel"]) {
            addEventListener(end, () => {
                this.isPressed = false;
            });
        }
    }

    #anyKey(event) {
        const isTyping = event.target.matches("input[type=text]");
        if ((event.ctrlKey || event.metaKey) && !isTyping) {
            const key = event.key.toLowerCase();
            if (key === "z" || key === "y") {
                event.preventDefault();
                event.stopPropagation();
                this.desk[key === "y" || event.shiftKey ? "redo" : "undo"]();
            }
        }
        if (event.key.startsWith("Arrow") || event.key === "Tab" && event.shiftKey) {
            this.usesPointer = false;
        }
    }

    // Tab adds where the pointer was used last; by keyboard it goes on to what is next.
    #groundKey(event) {
        const view = this.desk.viewOf(event.target);
        const isPlain = event.target === this.desk.ground || event.target === view?.element;
        const isAdding = event.key === "Insert" || event.key === "Tab" && !event.shiftKey &&
            this.usesPointer;
        if (isPlain && isAdding) {
            event.preventDefault();
            const box = (view?.element ?? this.desk.ground).getBoundingClientRect();
            this.desk.openMenu({x: box.left + 40, y: box.top + 40}, {});
        } else if (event.target === this.desk.ground && event.key.startsWith("Arrow")) {
            event.preventDefault();
            this.desk.views.get(this.desk.selectedName ?? this.desk.cards[0]?.id)?.element.focus();
        }
    }

    // Keys of a card
    press(event, view) {
        const {key, target} = event, {element, card} = view;
        if (target !== element) {
            if (key === "Escape") {
                event.preventDefault();
                element.focus();
            }
            return;
        }
        if (key === "Delete" || key === "Backspace") {
            view.act(event.ctrlKey || event.metaKey ? "inline" : "remove");
        } else if (key === "F2") {
            view.act("rename");
        } else if (key === "Enter") {
            element.querySelector(".graph-rows :is(select, input, button)")?.focus();
        } else if (key.startsWith("Arrow") && event.altKey && !this.desk.isList) {
            const [dx, dy] = WAYS[key];
            const join = this.lastMoved === card.id && performance.now() - this.movedAt < AGAIN;
            this.desk.stage.move(card, parseFloat(element.style.left) + dx * STEP,
                parseFloat(element.style.top) + dy * STEP, join);
            [this.lastMoved, this.movedAt] = [card.id, performance.now()];
        } else if (key.startsWith("Arrow")) {
            this.#goTo(view, key);
        } else {
            return;
        }
        event.preventDefault();
    }

    // The nearest card in a direction
    #goTo(view, key) {
        const centre = ({element}) => {
            const box = element.getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2];
        };
        const [x, y] = centre(view);
        const along = {ArrowLeft: (dx, dy) => [-dx, dy], ArrowRight: (dx, dy) => [dx, dy],
            ArrowUp: (dx, dy) => [-dy, dx], ArrowDown: (dx, dy) => [dy, dx]}[key];
        let best = null, least = Infinity;
        for (const other of this.desk.views.values()) {
            const [ox, oy] = centre(other), [ahead, aside] = along(ox - x, oy - y);
            const distance = ahead + 2 * Math.abs(aside);
            if (other !== view && ahead > 4 && distance < least) {
                [best, least] = [other, distance];
            }
        }
        best?.element.focus({preventScroll: true});
        if (best) {
            this.desk.stage.reveal(best.card.id);
        }
    }
}
