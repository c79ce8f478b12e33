// SPDX-License-Identifier: MIT
//
// The map: paints frames, and turns the mouse, fingers and the wheel into moves and zooms.

const tidy = number => String(Number(number.toPrecision(12)));

// Where sample (column, row) of a raster lies
export function placeOf({height, origin, step}, column, row) {
    return [origin[0] + column * step, origin[1] + (height - 1 - row) * step];
}

export class MapView {
    // move({origin, step}, isDragging) gets texts of what changes; hover(place or null) a sample.
    constructor(canvas, move, hover) {
        this.canvas = canvas;
        this.move = move;
        this.hover = hover;
        this.raster = null; // the whole one, of which a preview shows fewer samples
        this.fingers = new Map();
        canvas.addEventListener("pointerdown", event => this.down(event));
        canvas.addEventListener("pointermove", event => this.moved(event));
        for (const name of ["pointerup", "pointercancel"]) {
            canvas.addEventListener(name, event => this.up(event));
        }
        canvas.addEventListener("pointerleave", () => hover(null));
        canvas.addEventListener("wheel", event => this.wheel(event), {passive: false});
    }

    paint({pixels, raster}, whole) {
        const {canvas} = this, {width, height} = raster;
        if (canvas.width !== width || canvas.height !== height) {
            canvas.width = width;
            canvas.height = height;
        }
        const bytes = new Uint8ClampedArray(pixels.buffer);
        canvas.getContext("2d", {alpha: false}).putImageData(
            new ImageData(bytes, width, height), 0, 0);
        this.raster = whole;
    }

    // The sample under the pointer, as fractions of the raster: the picture is letterboxed.
    at(event) {
        const box = this.canvas.getBoundingClientRect(), {width, height} = this.raster;
        const scale = Math.min(box.width / width, box.height / height);
        const left = box.left + (box.width - width * scale) / 2;
        const top = box.top + (box.height - height * scale) / 2;
        return {column: (event.clientX - left) / scale, row: (event.clientY - top) / scale};
    }

    down(event) {
        if (this.raster === null || event.button > 0) {
            return;
        }
        this.canvas.setPointerCapture(event.pointerId);
        this.fingers.set(event.pointerId, event);
        this.begin();
    }

    // Two fingers zoom around their middle, one moves.
    begin() {
        const [a, b] = [...this.fingers.values()];
        const middle = b ? {clientX: (a.clientX + b.clientX) / 2,
            clientY: (a.clientY + b.clientY) / 2} : a;
        this.start = a && {at: this.at(middle), raster: {...this.raster}, spread: b
            ? Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) : 0};
    }

    moved(event) {
        if (this.raster === null) {
            return;
        }
        if (!this.fingers.has(event.pointerId)) {
            const {column, row} = this.at(event), x = Math.floor(column), y = Math.floor(row);
            const {width, height} = this.raster;
            this.hover(x >= 0 && y >= 0 && x < width && y < height ? {column: x, row: y} : null);
            return;
        }
        this.fingers.set(event.pointerId, event);
        const [a, b] = [...this.fingers.values()], {raster, at, spread} = this.start;
        const now = this.at(b ? {clientX: (a.clientX + b.clientX) / 2,
            clientY: (a.clientY + b.clientY) / 2} : a);
        const factor = b ? spread / Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) : 1;
        this.place(raster, at, now, factor, true);
    }

    // Lets what lay `from` lie under `to`, with the step times `factor`. Samples stay those of one
    // grid unless that zooms.
    place(raster, from, to, factor, isDragging) {
        const step = factor === 1 ? raster.step : Number((raster.step * factor).toPrecision(4));
        const round = factor === 1 ? Math.round : n => n;
        const origin = [raster.origin[0] + round(from.column - to.column * step / raster.step) *
            raster.step, raster.origin[1] + round((raster.height - 1 - from.row) -
            (raster.height - 1 - to.row) * step / raster.step) * raster.step];
        this.move({origin: origin.map(tidy).join(","), step: String(step)}, isDragging);
    }

    up(event) {
        if (this.fingers.delete(event.pointerId)) {
            this.begin();
            this.move({}, false);
        }
    }

    wheel(event) {
        if (this.raster === null) {
            return;
        }
        event.preventDefault();
        const at = this.at(event), times = Math.max(-1, Math.min(1, event.deltaY / 100));
        this.place(this.raster, at, at, 2 ** (times / 2), true);
        clearTimeout(this.settle);
        this.settle = setTimeout(() => this.move({}, false), 200);
    }

    // Moves by fractions of the raster, or zooms around its middle.
    step(right, up, factor = 1) {
        const {width, height} = this.raster;
        const from = {column: width / 2 + right * width, row: height / 2 - up * height};
        this.place(this.raster, from, {column: width / 2, row: height / 2}, factor, false);
    }
}
