// SPDX-License-Identifier: MIT
//
// How much sun each place of a terrain gets: which share of the disc its horizon leaves, and how
// far the ground faces it. Both depend only on heights and sun, not on the camera.

const RADIUS = 0.8 * Math.PI / 180; // of the sun: three times the true one, for softer edges
const STEEPEST = 89.5 * Math.PI / 180; // where the tangent ends

// The unit vector to the sun: east, north, up. The azimuth goes clockwise from north, in degrees.
export function sunOf(azimuth, altitude) {
    const a = azimuth * Math.PI / 180, h = altitude * Math.PI / 180;
    return [Math.sin(a) * Math.cos(h), Math.cos(a) * Math.cos(h), Math.sin(h)];
}

// Every `every`th sample along rows and columns, and the last ones
export function thinned(values, {width, height}, every, [across, down]) {
    if (every === 1) {
        return values;
    }
    const thin = new Float32Array(across * down);
    for (let row = 0, n = 0; row < down; row++) {
        const first = Math.min(row * every, height - 1) * width;
        for (let column = 0; column < across; column++) {
            thin[n++] = values[first + Math.min(column * every, width - 1)];
        }
    }
    return thin;
}

// The share of the sun above a horizon: `low` is the height where its lower rim is hidden, `high`
// where its upper rim is.
function shareOf(height, low, high) {
    if (height >= low) {
        return 1;
    }
    if (height <= high) {
        return 0;
    }
    const t = (height - high) / (low - high);
    return t * t * (3 - 2 * t);
}

// Walks away from the sun, a row (or a column) at a time. Lines of sight cross the row at its whole
// numbers plus a fraction, the same for all. Each keeps the heights to which it lies in shadow,
// which sink from row to row. Rows have `count` samples, `stride` apart.
function walk(values, lit, {rows, count, first, rowStride, stride, slope, sinkLow, sinkHigh}) {
    const spare = Math.ceil(Math.abs(slope) * rows) + 2, most = count + 2 * spare;
    const low = new Float64Array(most).fill(-Infinity), high = low.slice();
    const share = new Float64Array(count + 1); // of the line at sample j - 1 plus the fraction
    for (let i = 0; i < rows; i++) {
        const offset = i * slope, whole = Math.floor(offset), part = offset - whole;
        const row = first + i * rowStride;
        for (let j = -1, before = values[row]; j < count; j++) {
            const after = values[row + Math.min(j + 1, count - 1) * stride];
            const height = before + part * (after - before), line = j - whole + spare;
            share[j + 1] = shareOf(height, low[line], high[line]);
            low[line] = Math.max(low[line], height) - sinkLow;
            high[line] = Math.max(high[line], height) - sinkHigh;
            before = after;
        }
        for (let j = 0; j < count; j++) {
            lit[row + j * stride] = share[j + 1] + part * (share[j] - share[j + 1]);
        }
    }
}

// The share of the sun that each sample sees, from 0 to 1. Row 0 is the northern one; `step` is how
// far samples are apart.
export function sunShares(values, [across, down], step, [east, north, up]) {
    const lit = new Float32Array(values.length).fill(1), altitude = Math.asin(up);
    const flat = Math.hypot(east, north);
    if (flat < 1e-6) {
        return lit;
    }
    const column = east / flat, row = -north / flat; // to the sun
    const isAcross = Math.abs(column) > Math.abs(row);
    const [along, aside] = isAcross ? [column, row] : [row, column];
    const [rows, count] = isAcross ? [across, down] : [down, across];
    const [rowStride, stride] = isAcross ? [1, across] : [across, 1];
    const far = step / Math.abs(along);
    walk(values, lit, {rows, count, stride, slope: -aside / Math.abs(along),
        first: along > 0 ? (rows - 1) * rowStride : 0,
        rowStride: along > 0 ? -rowStride : rowStride,
        sinkLow: far * Math.tan(Math.max(altitude - RADIUS, 0)),
        sinkHigh: far * Math.tan(Math.min(altitude + RADIUS, STEEPEST))});
    return lit;
}

// Two bytes a sample: the share of the sun, and the cosine of the angle between it and the ground,
// whose slopes are multiplied by `zFactor`.
export function sunlight(values, [across, down], step, sun, zFactor) {
    const lit = sunShares(values, [across, down], step, sun), [east, north, up] = sun;
    const bytes = new Uint8Array(2 * lit.length);
    for (let row = 0, i = 0; row < down; row++) {
        const above = row > 0 ? across : 0, below = row < down - 1 ? across : 0;
        const perRow = zFactor / (step * ((above + below) / across || 1));
        for (let column = 0; column < across; column++, i++) {
            const left = column > 0 ? 1 : 0, right = column < across - 1 ? 1 : 0;
            const perColumn = zFactor / (step * (left + right || 1));
            const dx = (values[i + right] - values[i - left]) * perColumn;
            const dy = (values[i - above] - values[i + below]) * perRow;
            const cosine = (up - east * dx - north * dy) / Math.sqrt(1 + dx * dx + dy * dy);
            bytes[2 * i] = 255 * lit[i] + 0.5;
            bytes[2 * i + 1] = 255 * Math.max(cosine, 0) + 0.5;
        }
    }
    return bytes;
}
