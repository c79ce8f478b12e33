// SPDX-License-Identifier: MIT
//
// The block of terrain as triangles: the surface, the walls below its edges, and the base. Vertex
// numbers below across * down are those of the grid, row by row; the same again are their feet.

const END = 0xffffffff; // of a strip

// How many vertices a side of `samples` samples has, of which every `every`th has one, and the last
export const verticesOf = (samples, every) => Math.ceil((samples - 1) / every) + 1;

// A strip of triangles for each pair of rows
function surfaceOf(across, down) {
    const indices = new Uint32Array((down - 1) * (2 * across + 1));
    let n = 0;
    for (let row = 0; row + 1 < down; row++) {
        for (let column = 0; column < across; column++) {
            indices[n++] = row * across + column;
            indices[n++] = (row + 1) * across + column;
        }
        indices[n++] = END;
    }
    return indices;
}

// The edge of the grid, all around
function edgeOf(across, down) {
    const edge = [], last = across * (down - 1);
    for (let column = 0; column < across - 1; column++) {
        edge.push(column);
    }
    for (let row = 0; row < down - 1; row++) {
        edge.push(row * across + across - 1);
    }
    for (let column = across - 1; column > 0; column--) {
        edge.push(last + column);
    }
    for (let row = down - 1; row > 0; row--) {
        edge.push(row * across);
    }
    return edge;
}

// {buffer, surface, block}: counts of indices. Those of walls and base follow those of the surface.
export function meshOf(gl, across, down) {
    const surface = surfaceOf(across, down), edge = edgeOf(across, down), feet = across * down;
    const walls = [...edge, edge[0] ?? 0].flatMap(i => [i, feet + i]);
    const corners = [0, across - 1, across * (down - 1), across * down - 1];
    const block = [...walls, END, ...corners.map(i => feet + i)];
    const indices = new Uint32Array(surface.length + block.length), buffer = gl.createBuffer();
    indices.set(surface);
    indices.set(block, surface.length);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
    return {buffer, across, down, surface: surface.length, block: block.length};
}

// The lowest, the mean and the highest value
export function extentOf(values) {
    let lowest = Infinity, highest = -Infinity, sum = 0;
    for (const value of values) {
        lowest = Math.min(lowest, value);
        highest = Math.max(highest, value);
        sum += value;
    }
    return {lowest, mean: sum / values.length, highest};
}
