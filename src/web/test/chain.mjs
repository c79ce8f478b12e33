// SPDX-License-Identifier: MIT
//
// The calls of tests/bindings/chain.h: the names of samples, and numbers. Made by
// src/bindings/interface.py; do not change it by hand.
export const CHAIN = {
    affine: [['a'], [1.7, -0.3]],
    add: [['a', 'b'], []],
    multiply: [['a', 'b'], []],
    mix: [['a', 'b', 'a'], []],
    min: [['a', 'b'], []],
    max: [['a', 'b'], []],
    smoothMin: [['a', 'b'], [0.3]],
    smoothMax: [['a', 'b'], [0.3]],
    clamp: [['a'], [-0.2, 0.1]],
    abs: [['a'], []],
    smoothAbs: [['a'], [0.15]],
    smoothstep: [['a'], [0.25, -0.25]],
    terrace: [['a'], [7, 0.4, 0.8]],
    divide: [['a', 'b'], []],
    sqrt: [['a'], []],
    sine: [['a'], []],
    pulse: [['a'], []],
};
