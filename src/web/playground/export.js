// SPDX-License-Identifier: MIT
//
// Heights as files: 16-bit PNG, R16 and NPY with the bytes or numbers that `scarp terrain` writes.

// Heights as integers: 0 at the floor, 65535 at the ceiling
export function quantised(values, floor, ceiling) {
    const left = ceiling - floor, steps = left > 0 ? 65535 / left : 0;
    return Uint16Array.from(values, value => Math.trunc((value - floor) * steps + 0.5));
}

export async function sha256(bytes) {
    if (!globalThis.crypto?.subtle) {
        return null; // pages that are neither local nor encrypted
    }
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return Array.from(digest, byte => byte.toString(16).padStart(2, "0")).join("");
}

function swapped(numbers, bytes, toHigh) {
    const size = bytes.byteLength / numbers.length, view = new DataView(bytes.buffer);
    for (let i = 0; i < numbers.length; i++) {
        if (size === 2) {
            view.setUint16(2 * i, numbers[i], !toHigh);
        } else {
            view.setFloat32(4 * i, numbers[i], true);
        }
    }
    return bytes;
}

export const r16 = numbers => swapped(numbers, new Uint8Array(2 * numbers.length), false);

export function npy(heights, width, height) {
    const head = `{'descr': '<f4', 'fortran_order': False, 'shape': (${height}, ${width}), }`;
    const bytes = new Uint8Array(128 + 4 * heights.length);
    bytes.set([0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59, 1, 0, 118, 0]);
    bytes.set(new TextEncoder().encode(head.padEnd(117) + "\n"), 10);
    bytes.set(swapped(heights, new Uint8Array(4 * heights.length), false), 128);
    return bytes;
}

const CRC = Uint32Array.from({length: 256}, (_, n) => {
    for (let k = 0; k < 8; k++) {
        n = n & 1 ? n >>> 1 ^ 0xedb88320 : n >>> 1;
    }
    return n;
});

function chunk(name, data) {
    const bytes = new Uint8Array(12 + data.length), view = new DataView(bytes.buffer);
    view.setUint32(0, data.length);
    bytes.set(new TextEncoder().encode(name), 4);
    bytes.set(data, 8);
    let crc = 0xffffffff;
    for (const byte of bytes.subarray(4, 8 + data.length)) {
        crc = CRC[(crc ^ byte) & 255] ^ crc >>> 8;
    }
    view.setUint32(8 + data.length, ~crc >>> 0);
    return bytes;
}

async function deflated(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

// A PNG of rows of bytes. They are stored as differences to the row above, which deflate makes
// smaller.
async function png(raw, {width, height, depth, colour}) {
    const row = raw.length / height, rows = new Uint8Array((row + 1) * height);
    for (let y = 0; y < height; y++) {
        rows[y * (row + 1)] = 2;
        for (let x = 0; x < row; x++) {
            const i = y * row + x;
            rows[y * (row + 1) + 1 + x] = raw[i] - (y > 0 ? raw[i - row] : 0);
        }
    }
    const head = new Uint8Array(13), view = new DataView(head.buffer);
    view.setUint32(0, width);
    view.setUint32(4, height);
    head.set([depth, colour, 0, 0, 0], 8);
    const signature = new Uint8Array([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]);
    return new Blob([signature, chunk("IHDR", head), chunk("IDAT", await deflated(rows)),
        chunk("IEND", new Uint8Array(0))], {type: "image/png"});
}

export const png16 = (numbers, width, height) =>
    png(swapped(numbers, new Uint8Array(2 * numbers.length), true),
        {width, height, depth: 16, colour: 0});

export const pngRgba = (bytes, width, height) =>
    png(bytes, {width, height, depth: 8, colour: 6});

export function save(blob, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
