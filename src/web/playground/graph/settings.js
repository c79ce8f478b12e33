// SPDX-License-Identifier: MIT
//
// What stands in front of all statements: whether the recipe is of the plane or of space, and the
// tile after which it repeats.
import {make} from "./dom.js";
import {setSetting} from "./edits.js";

const AXES = ["x", "y", "z"];
const TILE = 1024; // units, where none was told

export class Settings {
    constructor(desk) {
        this.desk = desk;
        this.space = make("select", {"aria-label": "Dimensions", onchange: () => this.#setSpace()},
            make("option", {value: "2"}, "of the plane"), make("option", {value: "3"}, "of space"));
        this.isTiled = make("input", {type: "checkbox", onchange: () => this.#setTile()});
        this.sides = AXES.map(axis => make("input", {type: "text", inputmode: "decimal",
            "aria-label": `Length of the tile along ${axis}`, onchange: () => this.#setTile()}));
        this.title = make("summary", {}, "Settings");
        this.element = make("details", {class: "graph-settings"}, this.title, make("div", {},
            make("label", {}, "Recipe ", this.space),
            make("label", {}, this.isTiled, " repeats after"),
            make("span", {class: "graph-sides"}, ...this.sides), " units"));
    }

    #done(result) {
        if (!result) {
            this.update();
        }
    }

    #setSpace() {
        const {value} = this.space, has = this.desk.model.settings.space !== null;
        this.#done(this.desk.perform((model, read) =>
            setSetting(model, read, "space", value === "2" && has ? null : value),
        {says: `the recipe is ${value === "2" ? "of the plane" : "of space"}`}));
    }

    #setTile() {
        const axes = this.desk.model.document.isSpace ? 3 : 2;
        const text = this.sides.slice(0, axes).map(side => side.value.trim() || TILE).join(", ");
        this.#done(this.desk.perform((model, read) =>
            setSetting(model, read, "tile", this.isTiled.checked ? text : null),
        {says: this.isTiled.checked ? `it repeats after ${text}` : "it does not repeat"}));
    }

    update() {
        const {model} = this.desk, {tile} = model.settings, isSpace = model.document.isSpace;
        this.space.value = isSpace ? "3" : "2";
        this.isTiled.checked = tile !== null;
        const sides = tile ? tile.text.split(",").map(side => side.trim()) : [];
        this.sides.forEach((field, i) => {
            field.value = sides[i] ?? "";
            field.disabled = tile === null;
            field.hidden = i === 2 && !isSpace;
        });
        this.title.textContent = ["Settings", isSpace && "space", tile && `tile ${tile.text}`]
            .filter(Boolean).join(" · ");
    }
}
