// SPDX-License-Identifier: MIT
//
// The menu of what can be added: a field to search in, and a list. What does not fit the place is not
// in it: each offer is tried, some at a time so that nothing waits.
import {make} from "./dom.js";
import {isFound, offersFor} from "./offers.js";

const SLICE = 8; // milliseconds

export class Menu {
    constructor(desk, parent) {
        this.desk = desk;
        this.offers = [];
        this.search = make("input", {type: "text", role: "combobox", "aria-expanded": "true",
            "aria-controls": "graph-offers", "aria-label": "Search what can be added",
            autocomplete: "off", spellcheck: "false", placeholder: "Search",
            oninput: () => this.#show(), onkeydown: event => this.#key(event)});
        this.list = make("ul", {id: "graph-offers", role: "listbox", "aria-label": "What fits here"});
        this.count = make("p", {class: "graph-count", "aria-live": "polite"});
        this.dialog = make("dialog", {class: "graph-menu", "aria-label": "Add",
            onclick: event => event.target === this.dialog && this.dialog.close(),
            onclose: () => this.#closed(), onkeydown: event => event.stopPropagation()},
        this.search, this.list, this.count);
        parent.append(this.dialog);
    }

    // `context` is as offersFor() has it; `done` gets the name of what was made.
    open({x, y}, context) {
        this.before = document.activeElement;
        this.context = context;
        const {model, read} = this.desk;
        this.offers = [];
        this.at = 0;
        this.search.value = "";
        const waiting = offersFor(model, context), run = {};
        this.run = run;
        const work = () => {
            const end = performance.now() + SLICE;
            while (waiting.length > 0 && performance.now() < end) {
                const offer = waiting.shift();
                if (!offer.attempt(model, read).refusal) {
                    this.offers.push(offer);
                }
            }
            if (this.run === run) {
                this.isReady = waiting.length === 0;
                this.#show();
                if (!this.isReady) {
                    setTimeout(work);
                }
            }
        };
        const style = this.dialog.style;
        style.left = `${Math.max(8, Math.min(x, innerWidth - 348))}px`;
        style.top = `${Math.max(8, Math.min(y, innerHeight - 388))}px`;
        this.dialog.showModal();
        this.search.focus();
        work();
    }

    #closed() {
        this.run = null;
        if (this.before?.isConnected) {
            this.before.focus({preventScroll: true});
        }
    }

    // What is called as the search begins stands in front of what only tells of it.
    get found() {
        const search = this.search.value.trim().toLowerCase();
        const found = this.offers.filter(offer => isFound(offer, search));
        const isCalled = offer => search !== "" && offer.name.toLowerCase().startsWith(search);
        return [...found.filter(isCalled), ...found.filter(offer => !isCalled(offer))];
    }

    #show() {
        const {found} = this;
        this.at = Math.min(this.at, Math.max(0, found.length - 1));
        let group = "";
        const items = found.flatMap((offer, i) => {
            const title = offer.group === group || this.search.value !== "" ? []
                : [make("li", {role: "presentation", class: "graph-group"}, offer.group)];
            group = offer.group;
            return [...title, make("li", {id: `graph-offer-${i}`, role: "option",
                onclick: () => this.#choose(offer)}, make("b", {}, offer.name),
            make("span", {}, offer.text))];
        });
        this.list.replaceChildren(...items);
        this.list.setAttribute("aria-busy", String(!this.isReady));
        this.count.textContent = found.length > 0 ? "" : this.isReady ? "Nothing of that fits here."
            : "Looking for what fits here …";
        this.#mark();
    }

    #mark() {
        const items = [...this.list.querySelectorAll("[role=option]")], item = items[this.at];
        items.forEach(other => other.setAttribute("aria-selected", String(other === item)));
        item?.scrollIntoView({block: "nearest"});
        this.search.setAttribute("aria-activedescendant", item?.id ?? "");
    }

    #key(event) {
        const step = {ArrowDown: 1, ArrowUp: -1}[event.key], {found} = this;
        if (step && found.length > 0) {
            event.preventDefault();
            this.at = (this.at + step + found.length) % found.length;
            this.#mark();
        } else if (event.key === "Enter") {
            event.preventDefault();
            if (found[this.at]) {
                this.#choose(found[this.at]);
            }
        } else if (event.key === "Tab") {
            event.preventDefault();
        }
    }

    #choose(offer) {
        this.dialog.close();
        this.desk.take(offer, this.context);
    }
}
