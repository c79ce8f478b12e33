// SPDX-License-Identifier: MIT
//! The chain rule: functions of samples, with exact derivatives
//!
//! Whatever output is there is computed: the value f(a) or f(a, b) at each point, and its
//! derivatives. An output needs the same member of every input, a derivative the values, too, and a
//! second derivative the first ones along its axes. `scarp.h` has each formula. Work in chunks of
//! about 4,096 points, sampling included: then the slices stay in the caches.
//!
//! The functions here write to slices of their own; methods of [`Samples`] with the same names
//! change samples in place.
//!
//! ```
//! use scarp::{Arrays, Noise, chain};
//! let (x, y) = ([0.5, 1.5, 2.5], [0.25; 3]);
//! let (mut hills, mut rocks) = (Arrays::plane(3, 1), Arrays::plane(3, 1));
//! Noise { seed: 1, ..Noise::default() }.sample2(&x, &y, &mut hills.samples())?;
//! Noise { seed: 2, ..Noise::default() }.sample2(&x, &y, &mut rocks.samples())?;
//!
//! // A smooth union, with its exact gradient, in slices of its own
//! let mut ground = Arrays::plane(3, 1);
//! chain::smooth_max(&hills.view(), &rocks.view(), 0.1, &mut ground.samples())?;
//! // and in place
//! hills.samples().smooth_max(&rocks.view(), 0.1)?;
//! assert_eq!(hills, ground);
//! # Ok::<(), scarp::Error>(())
//! ```
use crate::arrays::{Partials, Samples, Sizes, View};
use crate::error::{check, ready, Error, Status};
use crate::ffi;

/// Functions of `a`, further inputs and numbers, which have methods of the same name
macro_rules! functions {
    ($($(#[$about:meta])* $name:ident($($input:ident)*; $($number:ident)*), $call:ident;)*) => {
        $(
            $(#[$about])*
            pub fn $name(
                a: &View<'_>,
                $($input: &View<'_>,)*
                $($number: f32,)*
                out: &mut Samples<'_>,
            ) -> Result<(), Error> {
                ready()?;
                let mut sizes = Sizes::points(a.count());
                let a = a.c(&mut sizes);
                $(let $input = $input.c(&mut sizes);)*
                let out = out.c(&mut sizes);
                sizes.check()?;
                // SAFETY: all slices have so many elements. No output is another slice, since it
                // is borrowed for writing.
                check(unsafe { ffi::$call(sizes.count, &a, $(&$input,)* $($number,)* &out) })
            }
        )*

        /// The [chain rule](crate::chain) in place. All members that are there are computed.
        impl Samples<'_> {
            $(
                $(#[$about])*
                pub fn $name(
                    &mut self,
                    $($input: &View<'_>,)*
                    $($number: f32,)*
                ) -> Result<(), Error> {
                    ready()?;
                    let mut sizes = Sizes::points(self.view().count());
                    let out = self.c(&mut sizes);
                    $(let $input = $input.c(&mut sizes);)*
                    sizes.check()?;
                    // SAFETY: as above. Outputs are the very same slices as those of `a`, which the
                    // call allows.
                    check(unsafe {
                        ffi::$call(sizes.count, &out, $(&$input,)* $($number,)* &out)
                    })
                }
            )*
        }
    };
}

functions! {
    // <chain> made by src/bindings/interface.py of include/scarp.h: do not change them by hand
    /// `scale * a + offset`.
    affine(; scale offset), scarp_affine;
    /// `a + b`, in all members.
    add(b;), scarp_add;
    /// `a * b`: a product is 0 where a factor is 0, even if the other one is NaN.
    multiply(b;), scarp_multiply;
    /// `a` where `m` is 0, `b` where `m` is 1, and `a + m * (b - a)` between: slopes of `m` count,
    /// too.
    mix(b m;), scarp_mix;
    /// The lesser of `a` and `b`, with a crease where both are equal; NaN before any number.
    min(b;), scarp_min;
    /// The greater of `a` and `b`, with a crease where both are equal; NaN before any number.
    max(b;), scarp_max;
    /// The lesser of `a` and `b`, without a crease: less by `k / 6` at most, where they differ by
    /// less than `k`.
    smooth_min(b; k), scarp_smooth_min;
    /// The greater of `a` and `b`, without a crease: more by `k / 6` at most, where they differ by
    /// less than `k`.
    smooth_max(b; k), scarp_smooth_max;
    /// `a`, but `lo` where it is less and `hi` where it is more, with creases there.
    clamp(; lo hi), scarp_clamp;
    /// `|a|`, with a crease at 0.
    abs(;), scarp_abs;
    /// `sqrt(a^2 + round^2)`: the magnitude of `a`, with a round floor.
    smooth_abs(; round), scarp_smooth_abs;
    /// From 0 where `a` is `lo` or beyond, to 1 where it is `hi` or beyond: masks for mixes.
    smoothstep(; lo hi), scarp_smoothstep;
    /// Steps in a slope: `steps` per unit of value, of which the part `riser`, in [2^-20, 1],
    /// rises. `strength`, in [0, 1], says how level treads are.
    terrace(; steps riser strength), scarp_terrace;
    /// `a / b`: infinite or NaN where `b` is 0.
    divide(b;), scarp_divide;
    /// The square root of `a`, and 0 where `a` is less than 0.
    sqrt(;), scarp_sqrt;
    /// `sin(2 pi a)`: `a` counts turns.
    sine(;), scarp_sine;
    /// `a` folded to and fro between -1 and 1, with the period 2.
    pulse(;), scarp_pulse;
    // </chain>
}

/// A smooth curve through knots, which are from 2 to 64: `value[k]` where a is `x[k]`. It never
/// overshoots.
///
/// ```
/// use scarp::{Arrays, chain};
/// let (mut a, mut out) = (Arrays::plane(3, 0), Arrays::plane(3, 0));
/// a.value = vec![-1.0, 0.5, 2.0];
/// chain::curve(&a.view(), &[0.0, 0.5, 1.0], &[10.0, 20.0, 40.0], &mut out.samples())?;
/// assert_eq!(out.value, [10.0, 20.0, 40.0]);
/// # Ok::<(), scarp::Error>(())
/// ```
pub fn curve(a: &View<'_>, x: &[f32], value: &[f32], out: &mut Samples<'_>) -> Result<(), Error> {
    ready()?;
    if x.len() != value.len() {
        let text = format!("there are {} values, and {} knots", value.len(), x.len());
        return Err(Error::new(Status::Size, "value", text));
    }
    let mut sizes = Sizes::points(a.count());
    let (a, out) = (a.c(&mut sizes), out.c(&mut sizes));
    sizes.check()?;
    let (knots, x, value) = (x.len(), x.as_ptr(), value.as_ptr());
    // SAFETY: all slices have so many elements, and there are so many knots.
    check(unsafe { ffi::scarp_curve(sizes.count, &a, knots, x, value, &out) })
}

/// The length of the gradient of a. The value needs `dx` and `dy` (and `dz`, if it is there), a
/// derivative the second ones along its axis. It has no second derivatives.
pub fn slope(a: &View<'_>, out: &mut Samples<'_>) -> Result<(), Error> {
    ready()?;
    let mut sizes = Sizes::points(a.count());
    let (a, out) = (a.c(&mut sizes), out.c(&mut sizes));
    sizes.check()?;
    // SAFETY: all slices have so many elements.
    check(unsafe { ffi::scarp_slope(sizes.count, &a, &out) })
}

/// Any function of a, given at each point: its value `f`, and its derivatives `fa` and `faa`
///
/// ```
/// use scarp::{Arrays, Partials, chain};
/// let (mut a, mut out) = (Arrays::plane(2, 1), Arrays::plane(2, 1));
/// (a.value, a.dx, a.dy) = (vec![2.0, 3.0], vec![1.0, 1.0], vec![0.0, 0.5]);
/// let f: Vec<_> = a.value.iter().map(|x| x * x).collect();
/// let fa: Vec<_> = a.value.iter().map(|x| 2.0 * x).collect();
/// let square = Partials { f: Some(&f), fa: Some(&fa), ..Partials::default() };
/// chain::apply1(&a.view(), &square, &mut out.samples())?;
/// assert_eq!((out.value, out.dx, out.dy), (vec![4.0, 9.0], vec![4.0, 6.0], vec![0.0, 3.0]));
/// # Ok::<(), scarp::Error>(())
/// ```
pub fn apply1(a: &View<'_>, function: &Partials<'_>, out: &mut Samples<'_>) -> Result<(), Error> {
    ready()?;
    let mut sizes = Sizes::points(a.count());
    let (a, function) = (a.c(&mut sizes), function.c(&mut sizes));
    let out = out.c(&mut sizes);
    sizes.check()?;
    // SAFETY: all slices have so many elements.
    check(unsafe { ffi::scarp_apply1(sizes.count, &a, &function, &out) })
}

/// Any function of a and b, given at each point, as [`apply1`]
pub fn apply2(
    a: &View<'_>,
    b: &View<'_>,
    function: &Partials<'_>,
    out: &mut Samples<'_>,
) -> Result<(), Error> {
    ready()?;
    let mut sizes = Sizes::points(a.count());
    let (a, b) = (a.c(&mut sizes), b.c(&mut sizes));
    let (function, out) = (function.c(&mut sizes), out.c(&mut sizes));
    sizes.check()?;
    // SAFETY: all slices have so many elements.
    check(unsafe { ffi::scarp_apply2(sizes.count, &a, &b, &function, &out) })
}

/// Unit normals of the surface z = `height_scale` value, from its gradient: the components along x,
/// along y, and up. `height_scale` is in units of input per unit of value.
///
/// ```
/// let (mut nx, mut ny, mut nz) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// scarp::normals(&[0.0, 1.0], &[0.0, 0.0], 1.0, [&mut nx, &mut ny, &mut nz])?;
/// assert_eq!((nx[0], nz[0], nx[1], ny[1]), (0.0, 1.0, -0.5f32.sqrt(), 0.0));
/// # Ok::<(), scarp::Error>(())
/// ```
pub fn normals(
    dx: &[f32],
    dy: &[f32],
    height_scale: f32,
    out: [&mut [f32]; 3],
) -> Result<(), Error> {
    ready()?;
    let mut sizes = Sizes::points(dx.len());
    let dy = sizes.input(dy, "dy");
    let [nx, ny, nz] = out;
    let (nx, ny, nz) = (
        sizes.output(&mut Some(nx), "nx"),
        sizes.output(&mut Some(ny), "ny"),
        sizes.output(&mut Some(nz), "nz"),
    );
    sizes.check()?;
    // SAFETY: all slices have so many elements.
    let status =
        unsafe { ffi::scarp_normals(sizes.count, dx.as_ptr(), dy, height_scale, nx, ny, nz) };
    match status {
        ffi::SCARP_ERROR_PARAMETER => Err(Error::of(status, "height_scale")),
        _ => check(status),
    }
}
