// SPDX-License-Identifier: MIT
//
// The memory of the module: blocks for arrays of the caller, and a stage for arrays that are
// elsewhere, which are copied there and back, part by part. Memory has its size from the start, so
// that no array ever loses its buffer.

const ALIGN = 64;
const PAGE = 65536;
const STAGE = 512 * 1024; // bytes: a part should stay in the caches

const TYPES = { Float32Array, Float64Array, Uint32Array };

export const isArray = (array, type) =>
    ArrayBuffer.isView(array) && array[Symbol.toStringTag] === type;

const up = (bytes) => (bytes + ALIGN - 1) & ~(ALIGN - 1);

export class Memory {
    // `fixed` bytes are the caller's own, from `base` on; `arrays` bytes are for allocate().
    constructor(memory, base, fixed, arrays) {
        this.base = Math.ceil(base / ALIGN) * ALIGN;
        this.stage = Math.ceil((this.base + fixed) / ALIGN) * ALIGN;
        const start = this.stage + STAGE;
        const pages = Math.ceil((start + arrays) / PAGE);
        const lack = pages - memory.buffer.byteLength / PAGE;
        if (lack > 0) {
            memory.grow(lack); // throws a RangeError
        }
        this.buffer = memory.buffer;
        this.view = new DataView(this.buffer);
        this.u32 = new Uint32Array(this.buffer);
        this.free = [{ at: start, size: Math.floor((start + arrays) / ALIGN) * ALIGN - start }];
        this.used = new Map(); // from where a block is to its size
        this.work = { at: 0, size: 0 };
    }

    allocate(bytes) {
        const size = Math.max(Math.ceil(bytes / ALIGN), 1) * ALIGN;
        const i = this.free.findIndex((block) => block.size >= size);
        if (i < 0 && this.work.size > 0) {
            this.dropWorkspace();
            return this.allocate(bytes);
        }
        if (i < 0) {
            throw new RangeError(
                `no ${bytes} bytes are left in one piece: load scarp with more, ` +
                    'as in load({ memory: 256 * 2 ** 20 })',
            );
        }
        const block = this.free[i];
        const at = block.at;
        block.at += size;
        block.size -= size;
        if (block.size === 0) {
            this.free.splice(i, 1);
        }
        this.used.set(at, size);
        return at;
    }

    release(at) {
        const size = this.used.get(at);
        if (size === undefined) {
            throw new TypeError('this is no array of alloc(), or it was freed before');
        }
        this.used.delete(at);
        let i = this.free.findIndex((block) => block.at > at);
        i = i < 0 ? this.free.length : i;
        this.free.splice(i, 0, { at, size });
        for (const k of [i, i - 1]) {
            // join what touches
            const one = this.free[k],
                next = this.free[k + 1];
            if (one !== undefined && next !== undefined && one.at + one.size === next.at) {
                one.size += next.size;
                this.free.splice(k + 1, 1);
            }
        }
    }

    // The block that calls work in, one for all: of so many bytes, or of what is left in one piece.
    // It gives way to other blocks, between calls.
    workspace(bytes) {
        if (this.work.size < bytes) {
            this.dropWorkspace();
            const size = Math.min(bytes, Math.max(0, ...this.free.map((block) => block.size)));
            this.work = size > 0 ? { at: this.allocate(size), size } : { at: 0, size: 0 };
        }
        return this.work;
    }

    dropWorkspace() {
        if (this.work.size > 0) {
            this.release(this.work.at);
            this.work = { at: 0, size: 0 };
        }
    }

    text(at) {
        if (at === 0) {
            return null;
        }
        let text = '';
        for (let code; (code = this.view.getUint8(at)) !== 0; at++) {
            text += String.fromCharCode(code);
        }
        return text;
    }

    holds(array) {
        return array.buffer === this.buffer;
    }

    // The places on the stage of those arrays that are elsewhere. The same array has one place.
    // `uses`: { array, slot, out }; the pointer of each goes to its slot.
    places(uses) {
        const places = [];
        for (const use of uses) {
            if (this.holds(use.array)) {
                continue;
            }
            let place = places.find(
                ({ array }) =>
                    array.buffer === use.array.buffer && array.byteOffset === use.array.byteOffset,
            );
            if (place === undefined) {
                places.push((place = { array: use.array, at: 0, in: false, out: false }));
            }
            place.in ||= !use.out;
            place.out ||= use.out;
            use.place = place;
        }
        return places;
    }

    // How many elements of all places fit on the stage.
    room(places) {
        const bytes = places.reduce((sum, { array }) => sum + array.BYTES_PER_ELEMENT, 0);
        return bytes === 0 ? Infinity : Math.floor((STAGE / bytes - ALIGN) / ALIGN) * ALIGN;
    }

    // Gives each place room for n elements and tells the slots: element `start` of arrays that lie
    // in this memory.
    point(uses, places, start, n) {
        let at = this.stage;
        for (const place of places) {
            place.at = at;
            at += up(n * place.array.BYTES_PER_ELEMENT);
        }
        for (const { array, slot, place } of uses) {
            this.u32[slot >> 2] =
                place === undefined ? array.byteOffset + start * array.BYTES_PER_ELEMENT : place.at;
        }
    }

    staged(place, n) {
        return new TYPES[place.array[Symbol.toStringTag]](this.buffer, place.at, n);
    }

    // Calls call(n) for all elements, as often as the stage demands.
    run(count, uses, call) {
        const places = this.places(uses);
        const most = this.room(places);
        let start = 0;
        do {
            const n = Math.min(count - start, most);
            this.point(uses, places, start, n);
            for (const place of places) {
                if (place.in) {
                    this.staged(place, n).set(place.array.subarray(start, start + n));
                }
            }
            call(n);
            for (const place of places) {
                if (place.out) {
                    place.array.set(this.staged(place, n), start);
                }
            }
            start += n;
        } while (start < count);
    }

    // Boxes of the grid go through the stage, rows beside each other, and are copied from there.
    runGrid(grid, uses, call) {
        const places = uses.map((use) => (use.place = { array: use.array, at: 0 }));
        const room = this.room(places);
        const size = [Math.min(grid.count[0], room)];
        size[1] = Math.min(grid.count[1], Math.floor(room / size[0]));
        size[2] = Math.min(grid.count[2], Math.floor(room / (size[0] * grid.count[1])) || 1);
        const box = (from) => {
            const [nx, ny, nz] = size.map((n, axis) => Math.min(n, grid.count[axis] - from[axis]));
            this.point(uses, places, 0, nx * ny * nz);
            call(from, [nx, ny, nz], 0, 0);
            for (const place of places) {
                const staged = this.staged(place, nx * ny * nz);
                for (let row = 0; row < ny * nz; row++) {
                    const j = from[1] + (row % ny),
                        k = from[2] + Math.floor(row / ny);
                    place.array.set(
                        staged.subarray(row * nx, (row + 1) * nx),
                        k * grid.sliceStride + j * grid.rowStride + from[0],
                    );
                }
            }
        };
        for (let k = 0; k < grid.count[2]; k += size[2]) {
            for (let j = 0; j < grid.count[1]; j += size[1]) {
                for (let i = 0; i < grid.count[0]; i += size[0]) {
                    box([i, j, k]);
                }
            }
        }
    }
}

// Throws unless an array has the type, of this realm or another, and the length.
export function checkArray(name, array, type, length) {
    if (!isArray(array, type)) {
        throw new TypeError(`${name} must be a ${type}`);
    }
    if (array.length !== length) {
        throw new RangeError(`${name} has ${array.length} elements, not ${length}`);
    }
}

// Throws where an output overlaps what else is used, unless it is the very same array as an input.
export function checkOverlaps(uses) {
    const end = ({ array, length }) =>
        array.byteOffset + (length ?? array.length) * array.BYTES_PER_ELEMENT;
    uses.forEach((a, i) => {
        for (const b of uses.slice(0, i)) {
            if (
                !(a.out || b.out) ||
                a.array.buffer !== b.array.buffer ||
                end(a) <= b.array.byteOffset ||
                end(b) <= a.array.byteOffset
            ) {
                continue;
            }
            const same =
                a.array.byteOffset === b.array.byteOffset &&
                a.array.constructor.BYTES_PER_ELEMENT === b.array.constructor.BYTES_PER_ELEMENT;
            if (!same || (a.out && b.out)) {
                throw new RangeError(`${a.name} and ${b.name} overlap`);
            }
        }
    });
}
