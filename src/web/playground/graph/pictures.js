// SPDX-License-Identifier: MIT
//
// Pictures of cards: asked of the host when a card is on the screen and what it shows has changed.
import {PICTURE} from "./cards.js";

const PATIENCE = 5000; // milliseconds, after which a picture that did not come is asked for again

export class Pictures {
    constructor(host) {
        this.host = host;
        this.asked = new Map(); // of cards: {hash, view, node, time, cancel}
        this.views = new Map(); // of elements
        this.observer = new IntersectionObserver(entries => this.#seen(entries),
            {rootMargin: "60px"});
    }

    #seen(entries) {
        for (const {target, isIntersecting} of entries) {
            const view = this.views.get(target);
            if (view) {
                view.isVisible = isIntersecting;
                this.#ask(view);
            }
        }
    }

    // A card is there, or has changed.
    update(view) {
        if (!view.canvas) {
            return;
        }
        if (this.views.get(view.element) !== view) {
            this.views.set(view.element, view);
            this.observer.observe(view.element);
        }
        this.#ask(view);
    }

    #ask(view) {
        const {id, node, hash} = view.card;
        if (!view.isVisible || view.shown === hash) {
            return;
        }
        const asked = this.asked.get(id);
        const isSame = asked?.hash === hash && asked.view === view && asked.node === node;
        if (isSame && performance.now() - asked.time < PATIENCE) {
            return;
        }
        asked?.cancel?.();
        const entry = {hash, view, node, time: performance.now(), cancel: null};
        this.asked.set(id, entry);
        entry.cancel = this.host.picture(node, ...PICTURE, result => {
            if (this.asked.get(id) === entry) {
                view.shown = hash;
                view.showPicture(result);
                this.asked.delete(id);
            }
        });
        // The host has none while it reads a text, and says nothing later.
        setTimeout(() => this.asked.get(id) === entry && this.#ask(view), PATIENCE + 50);
    }

    // A card that is built anew keeps its picture until there is another.
    hand(from, to) {
        if (from.canvas && to.canvas) {
            [to.canvas.width, to.canvas.height] = [from.canvas.width, from.canvas.height];
            to.canvas.getContext("2d").drawImage(from.canvas, 0, 0);
            to.range.textContent = from.range.textContent;
            [to.shown, to.isVisible] = [from.shown, from.isVisible];
        }
        this.forget(from);
    }

    forget(view) {
        const asked = this.asked.get(view.card.id);
        if (asked?.view === view) {
            asked.cancel?.();
            this.asked.delete(view.card.id);
        }
        this.observer.unobserve(view.element);
        this.views.delete(view.element);
    }
}
