// SPDX-License-Identifier: MIT
//! The calls of tests/bindings/chain.h, apart and in place. Made by src/bindings/interface.py; do not
//! change it by hand.
use scarp::{chain, Error, Samples, View};

type Apart = fn(&View<'_>, &View<'_>, &mut Samples<'_>) -> Result<(), Error>;
/// Of `a`, which is written, with a copy of it
type InPlace = fn(&mut Samples<'_>, &View<'_>, &View<'_>) -> Result<(), Error>;

#[rustfmt::skip]
pub const FUNCTIONS: &[(&str, Apart, InPlace)] = &[
    ("affine",
     |a, _, out| chain::affine(a, 1.7, -0.3, out),
     |a, _, _| a.affine(1.7, -0.3)),
    ("add",
     |a, b, out| chain::add(a, b, out),
     |a, _, b| a.add(b)),
    ("multiply",
     |a, b, out| chain::multiply(a, b, out),
     |a, _, b| a.multiply(b)),
    ("mix",
     |a, b, out| chain::mix(a, b, a, out),
     |a, copy, b| a.mix(b, copy)),
    ("min",
     |a, b, out| chain::min(a, b, out),
     |a, _, b| a.min(b)),
    ("max",
     |a, b, out| chain::max(a, b, out),
     |a, _, b| a.max(b)),
    ("smooth_min",
     |a, b, out| chain::smooth_min(a, b, 0.3, out),
     |a, _, b| a.smooth_min(b, 0.3)),
    ("smooth_max",
     |a, b, out| chain::smooth_max(a, b, 0.3, out),
     |a, _, b| a.smooth_max(b, 0.3)),
    ("clamp",
     |a, _, out| chain::clamp(a, -0.2, 0.1, out),
     |a, _, _| a.clamp(-0.2, 0.1)),
    ("abs",
     |a, _, out| chain::abs(a, out),
     |a, _, _| a.abs()),
    ("smooth_abs",
     |a, _, out| chain::smooth_abs(a, 0.15, out),
     |a, _, _| a.smooth_abs(0.15)),
    ("smoothstep",
     |a, _, out| chain::smoothstep(a, 0.25, -0.25, out),
     |a, _, _| a.smoothstep(0.25, -0.25)),
    ("terrace",
     |a, _, out| chain::terrace(a, 7.0, 0.4, 0.8, out),
     |a, _, _| a.terrace(7.0, 0.4, 0.8)),
    ("divide",
     |a, b, out| chain::divide(a, b, out),
     |a, _, b| a.divide(b)),
    ("sqrt",
     |a, _, out| chain::sqrt(a, out),
     |a, _, _| a.sqrt()),
    ("sine",
     |a, _, out| chain::sine(a, out),
     |a, _, _| a.sine()),
    ("pulse",
     |a, _, out| chain::pulse(a, out),
     |a, _, _| a.pulse()),
];
