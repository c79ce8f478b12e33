// SPDX-License-Identifier: MIT
//
// Keys, mouse, fingers and wheel fly the camera of the view in space.

const MOVES = "wasdqe";
const TYPED = "input, textarea, select, [contenteditable=true]"; // what takes letters itself
const REST_MS = 200; // without the wheel: the camera rests

export class Flight {
    // moving() is called for each step of the camera, resting() when it has come to rest.
    constructor(canvas, camera, {moving, resting}) {
        Object.assign(this, {canvas, camera, moving, resting});
        this.keys = new Set(); // that are held
        this.taps = new Set(); // that were pressed since the last step, and may be up again
        this.fingers = new Map();
        this.isFlying = false;
        this.listenToKeys();
        this.listenToPointers();
    }

    listenToKeys() {
        addEventListener("keydown", event => {
            const key = event.key.toLowerCase(), isTyped = event.target.closest?.(TYPED);
            if (this.canvas.hidden || isTyped || event.ctrlKey || event.metaKey || event.altKey ||
                key.length !== 1 || !MOVES.includes(key)) {
                return;
            }
            this.keys.add(key);
            this.taps.add(key);
            this.start();
        });
        addEventListener("keyup", event => this.keys.delete(event.key.toLowerCase()));
        addEventListener("blur", () => this.keys.clear());
    }

    listenToPointers() {
        const {canvas} = this;
        canvas.addEventListener("pointerdown", event => {
            canvas.setPointerCapture(event.pointerId);
            this.fingers.set(event.pointerId, event);
        });
        canvas.addEventListener("pointermove", event => this.drag(event));
        for (const name of ["pointerup", "pointercancel"]) {
            canvas.addEventListener(name, event => {
                this.fingers.delete(event.pointerId);
                this.resting();
            });
        }
        canvas.addEventListener("contextmenu", event => event.preventDefault());
        canvas.addEventListener("wheel", event => {
            event.preventDefault();
            this.camera.fly(0, -Math.sign(event.deltaY) * 0.05, 0);
            this.moving();
            clearTimeout(this.wheel);
            this.wheel = setTimeout(() => this.resting(), REST_MS);
        }, {passive: false});
    }

    // One finger or the mouse looks around; with Shift or the right button, or two fingers, moves.
    drag(event) {
        const before = this.fingers.get(event.pointerId), {camera} = this;
        if (before === undefined) {
            return;
        }
        const size = this.canvas.clientHeight;
        const x = (event.clientX - before.clientX) / size;
        const y = (event.clientY - before.clientY) / size;
        if (this.fingers.size > 1) {
            const [a, b] = [...this.fingers.values()];
            const spread = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
            this.fingers.set(event.pointerId, event);
            const [c, d] = [...this.fingers.values()];
            const now = Math.hypot(c.clientX - d.clientX, c.clientY - d.clientY);
            camera.fly(-x / 2, (now - spread) / size, y / 2);
        } else if (event.shiftKey || event.buttons === 2) {
            camera.fly(-x, 0, y);
        } else {
            camera.look(-1.5 * x, 1.5 * y);
        }
        this.fingers.set(event.pointerId, event);
        this.moving();
    }

    // Flies as long as keys are held.
    start() {
        if (this.isFlying) {
            return;
        }
        this.isFlying = true;
        let last = performance.now();
        const next = now => {
            const far = Math.min(Math.max(now - last, 8), 100) * 0.0004, {keys, taps} = this;
            const is = key => keys.has(key) || taps.has(key);
            const axis = (plus, minus) => far * (is(plus) - is(minus));
            last = now;
            this.camera.fly(axis("d", "a"), axis("w", "s"), axis("e", "q"));
            taps.clear();
            this.moving();
            this.isFlying = keys.size > 0 && !this.canvas.hidden;
            if (this.isFlying) {
                requestAnimationFrame(next);
            } else {
                this.resting();
            }
        };
        requestAnimationFrame(next);
    }
}
