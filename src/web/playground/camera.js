// SPDX-License-Identifier: MIT
//
// The camera of the view in space: where it is, where it looks, and what that makes of points. The
// terrain is 1 wide; x goes east, y north, z up.

const NEAR = 0.002, FAR = 20;
const FOCAL = 1 / Math.tan(0.45); // of the shorter side

export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scaled = (a, s) => a.map(x => x * s);
export const sum = (a, b) => a.map((x, i) => x + b[i]);
export const unit = a => scaled(a, 1 / Math.hypot(...a));

export class Camera {
    constructor() {
        this.pose = {eye: [0, -0.85, 0.5], yaw: 0, pitch: -0.6};
    }

    // Unit vectors: where it looks, and what is right and up in the picture
    axes() {
        const {yaw, pitch} = this.pose;
        const ahead = [Math.sin(yaw) * Math.cos(pitch), Math.cos(yaw) * Math.cos(pitch),
            Math.sin(pitch)];
        const right = unit(cross(ahead, [0, 0, 1]));
        return {ahead, right, up: cross(right, ahead)};
    }

    // What points are multiplied by, across and up the picture
    focals(aspect) {
        return aspect < 1 ? [FOCAL, FOCAL * aspect] : [FOCAL / aspect, FOCAL];
    }

    // From points to the clip space of WebGL, column by column
    matrix(aspect) {
        const {ahead, right, up} = this.axes(), {eye} = this.pose;
        const [wide, high] = this.focals(aspect);
        const view = [right, up, scaled(ahead, -1)].map(axis => [...axis, -dot(axis, eye)]);
        const a = (FAR + NEAR) / (NEAR - FAR), b = 2 * FAR * NEAR / (NEAR - FAR);
        const rows = [scaled(view[0], wide), scaled(view[1], high),
            [a * view[2][0], a * view[2][1], a * view[2][2], a * view[2][3] + b],
            scaled(view[2], -1)];
        return new Float32Array([0, 1, 2, 3].flatMap(c => rows.map(row => row[c])));
    }

    // The ray through a place of the picture is x * columns 0 + y * columns 1 + columns 2, with x
    // and y from -1 to 1.
    rays(aspect) {
        const {ahead, right, up} = this.axes(), [wide, high] = this.focals(aspect);
        return new Float32Array([...scaled(right, 1 / wide), ...scaled(up, 1 / high), ...ahead]);
    }

    // Moves along its axes, by fractions of the terrain's width.
    fly(right, ahead, up) {
        const axes = this.axes(), {pose} = this;
        pose.eye = sum(sum(pose.eye, scaled(axes.right, right)),
            sum(scaled(axes.ahead, ahead), [0, 0, up]));
    }

    look(right, up) {
        this.pose.yaw += right;
        this.pose.pitch = Math.max(-1.5, Math.min(1.5, this.pose.pitch + up));
    }
}

// The camera as text, for the URL, and back
export const poseText = ({eye, yaw, pitch}) =>
    [...eye, yaw, pitch].map(n => n.toFixed(3)).join(",");

export function poseOf(text) {
    const numbers = String(text).split(",").map(Number);
    const [x, y, z, yaw, pitch] = numbers;
    return numbers.length === 5 && numbers.every(n => Math.abs(n) < 1000)
        ? {eye: [x, y, z], yaw, pitch} : null;
}
