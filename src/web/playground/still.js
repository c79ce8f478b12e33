// SPDX-License-Identifier: MIT
//
// In place of d3-transition and d3-interpolate, which d3-zoom takes to animate zooms: here none is.
import {selection} from "d3-selection";

selection.prototype.interrupt = function () {
    return this;
};
export const interrupt = () => {};
export const interpolateZoom = (from, to) => () => to;
