// SPDX-License-Identifier: MIT
//! The calls that come twice, for floats and for doubles.
use crate::ffi::*;

pub trait Calls: Sized {
    const SAMPLE2: Plane<Self, scarp_samples>;
    const SAMPLE3: Space<Self, scarp_samples>;
    const VECTOR2: Plane<Self, scarp_samples>;
    const VECTOR3: Space<Self, scarp_samples>;
    const CELLS2: Plane<Self, scarp_cells>;
    const CELLS3: Space<Self, scarp_cells>;
    const CURL2: Plane<Self, scarp_flow>;
    const CURL3: Space<Self, scarp_flow>;
    const GULLIES2: Gullies<Self>;
    const RECIPE: Recipe<Self>;
}

type P<T> = *const T;
pub type Plane<T, Out> =
    unsafe extern "C" fn(P<scarp_noise>, usize, P<T>, P<T>, P<Out>) -> scarp_status;
pub type Space<T, Out> =
    unsafe extern "C" fn(P<scarp_noise>, usize, P<T>, P<T>, P<T>, P<Out>) -> scarp_status;
pub type Gullies<T> = unsafe extern "C" fn(
    P<scarp_gullies>,
    usize,
    P<T>,
    P<T>,
    P<scarp_samples>,
    P<scarp_eroded>,
) -> scarp_status;
pub type Recipe<T> = unsafe extern "C" fn(
    P<scarp_recipe>,
    usize,
    P<T>,
    P<T>,
    P<T>,
    P<scarp_recipe_outputs>,
    P<scarp_scratch>,
) -> scarp_status;

/// Coordinates: `f32`, or `f64` for large worlds, where floats are too coarse
///
/// Coordinates of floats give the bits of shaders; those of doubles give the bits of grids.
///
/// ```
/// use scarp::{Noise, Samples};
/// let (mut near, mut far) = ([0.0], [0.0]);
/// let mut at = |x: f64, value: &mut [f32]| {
///     Noise::default().sample2(&[x], &[0.5], &mut Samples { value: Some(value), ..Samples::default() })
/// };
/// at(0.25, &mut near)?;
/// at(0.25 + 2f64.powi(32), &mut far)?; // the lattice repeats after 2^32 cells
/// assert_eq!(near, far);
/// # Ok::<(), scarp::Error>(())
/// ```
pub trait Coordinate: Calls {}

impl Coordinate for f32 {}
impl Coordinate for f64 {}

impl Calls for f32 {
    const SAMPLE2: Plane<Self, scarp_samples> = scarp_sample2;
    const SAMPLE3: Space<Self, scarp_samples> = scarp_sample3;
    const VECTOR2: Plane<Self, scarp_samples> = scarp_vector2;
    const VECTOR3: Space<Self, scarp_samples> = scarp_vector3;
    const CELLS2: Plane<Self, scarp_cells> = scarp_cells2;
    const CELLS3: Space<Self, scarp_cells> = scarp_cells3;
    const CURL2: Plane<Self, scarp_flow> = scarp_curl2;
    const CURL3: Space<Self, scarp_flow> = scarp_curl3;
    const GULLIES2: Gullies<Self> = scarp_gullies2;
    const RECIPE: Recipe<Self> = scarp_recipe_sample;
}

impl Calls for f64 {
    const SAMPLE2: Plane<Self, scarp_samples> = scarp_sample2_f64;
    const SAMPLE3: Space<Self, scarp_samples> = scarp_sample3_f64;
    const VECTOR2: Plane<Self, scarp_samples> = scarp_vector2_f64;
    const VECTOR3: Space<Self, scarp_samples> = scarp_vector3_f64;
    const CELLS2: Plane<Self, scarp_cells> = scarp_cells2_f64;
    const CELLS3: Space<Self, scarp_cells> = scarp_cells3_f64;
    const CURL2: Plane<Self, scarp_flow> = scarp_curl2_f64;
    const CURL3: Space<Self, scarp_flow> = scarp_curl3_f64;
    const GULLIES2: Gullies<Self> = scarp_gullies2_f64;
    const RECIPE: Recipe<Self> = scarp_recipe_sample_f64;
}
