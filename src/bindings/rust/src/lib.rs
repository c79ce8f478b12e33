// SPDX-License-Identifier: MIT
//! scarp: noise for terrain, with exact gradients and Hessians
//!
//! The crate calls the C library scarp, and gives its bits: the same on every machine. Lengths of
//! slices are checked, the rest is what C does; `scarp.h` has all formulas and contracts.
//!
//! ```
//! use scarp::{Fractal, Noise, Samples};
//!
//! let noise = Noise {
//!     fractal: Fractal::Ridged,
//!     rotate: true,
//!     seed: 42,
//!     frequency: 0.01,
//!     octaves: 6.0,
//!     amplitude: 60.0,
//!     ..Noise::default()
//! };
//! let (x, y) = ([0.0, 10.0, 20.0], [5.0, 5.0, 5.0]); // f32, or f64 for large worlds
//! let (mut height, mut dx, mut dy) = ([0.0; 3], [0.0; 3], [0.0; 3]);
//! let mut out = Samples {
//!     value: Some(&mut height),
//!     dx: Some(&mut dx),
//!     dy: Some(&mut dy),
//!     ..Samples::default()
//! };
//! noise.sample2(&x, &y, &mut out)?;
//! # Ok::<(), scarp::Error>(())
//! ```
//!
//! - [`Noise`] at points and on a [`Grid`]; [`Arrays`] own memory, [`Samples`] borrow it.
//! - [`Grid::bands`] cuts a grid for threads.
//! - [`Recipe`]: a composition of noises as a text. [`chain`]: the same by calls. [`Gullies`].
//! - [`ffi`] has the declarations of C.
#![deny(missing_docs)]
#![deny(unsafe_op_in_unsafe_fn)]
#![warn(missing_debug_implementations, rust_2018_idioms)]

#[macro_use]
mod members;
mod arrays;
pub mod chain;
mod coordinate;
mod error;
#[allow(missing_debug_implementations)]
pub mod ffi;
mod grid;
mod gullies;
mod noise;
mod recipe;
mod shaders;
mod words;

pub use arrays::{Arrays, Cells, Eroded, Flow, Partials, Samples, View};
pub use chain::normals;
pub use coordinate::Coordinate;
pub use error::{Error, Place, Status};
pub use grid::{Bands, Grid};
pub use gullies::Gullies;
pub use noise::{Noise, Plan};
pub use recipe::{presets, Info, Param, Recipe, Scratch};
pub use shaders::GpuPlan;
pub use words::{Basis, Fade, Fractal, Isa, Language};

/// The version of the library that runs, as `major.minor.patch`
///
/// ```
/// assert!(scarp::version().starts_with("0."));
/// ```
pub fn version() -> &'static str {
    // SAFETY: the call takes nothing.
    error::text_of(unsafe { ffi::scarp_version() }).unwrap_or("")
}

/// A value of zeros that never was on the stack, where it may have no room
///
/// # Safety
///
/// All zeros must be a valid T, and T must not be empty.
pub(crate) unsafe fn zeroed_box<T>() -> Box<T> {
    let layout = std::alloc::Layout::new::<T>();
    // SAFETY: T is not empty; the memory is of its layout, and initialised.
    unsafe {
        let memory = std::alloc::alloc_zeroed(layout);
        if memory.is_null() {
            std::alloc::handle_alloc_error(layout);
        }
        Box::from_raw(memory.cast())
    }
}

/// What README.md shows is compiled and run with the other documents.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
