// SPDX-License-Identifier: MIT
//! Noise: what to sample, and the calls that sample it.
use crate::arrays::{Cells, Flow, Samples, Sizes};
use crate::coordinate::Coordinate;
use crate::error::{Error, Status};
use crate::ffi::{self, defaults::scarp_noise as defaults};
use crate::grid::Grid;
use crate::words::{Basis, Fade, Fractal};
use std::mem::size_of;
use std::os::raw::c_int;

mod check;
mod plan;
pub use plan::Plan;

/// Bytes that later versions give a meaning: zeros
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(transparent)]
pub struct Reserved<T>(pub(crate) T);

pub(crate) const SPARE: usize = (192 - 84 - 2 * size_of::<usize>()) / 4;

/// Noise with exact derivatives: a description, which calls read. `scarp.h` has all formulas.
///
/// ```
/// use scarp::{Arrays, Basis, Fractal, Grid, Noise};
///
/// let bend = Noise { basis: Basis::Simplex, seed: 7, frequency: 0.02, amplitude: 15.0, ..Noise::default() };
/// let noise = Noise {
///     fractal: Fractal::Ridged,
///     seed: 42,
///     frequency: 0.01,
///     octaves: 6.0,
///     warp: Some(&bend),
///     ..Noise::default()
/// };
/// let grid = Grid { origin: [100.0, 200.0], step: [0.5; 2], count: [640, 480], ..Grid::<2>::default() };
/// let mut tile = Arrays::plane(640 * 480, 1);
/// noise.grid2(&grid, &mut tile.samples())?;
///
/// let (lowest, highest) = noise.range(2)?;
/// assert_eq!((lowest, highest), (0.0, 1.0));
/// assert!(tile.value.iter().all(|value| (lowest..=highest).contains(value)));
/// # Ok::<(), scarp::Error>(())
/// ```
///
/// A warp is borrowed, so it cannot go away before the noise does:
///
/// ```compile_fail,E0597
/// let mut noise = scarp::Noise::default();
/// {
///     let bend = scarp::Noise { amplitude: 15.0, ..Default::default() };
///     noise.warp = Some(&bend);
/// }
/// noise.range(2).unwrap();
/// ```
///
/// In C, 0 stands for the default. Here 0 is an error where that would surprise: of `frequency`,
/// `octaves`, `lacunarity`, `gain`, `amplitude`, `erosion` and `jitter`. It has the layout of
/// `struct scarp_noise`, so a call costs no more than in C.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Noise<'a> {
    /// The noise of one octave
    pub basis: Basis,
    /// The blend between lattice points
    pub fade: Fade,
    /// How octaves are summed
    pub fractal: Fractal,
    /// Turn the axes between octaves, which hides the lattice's directions
    pub rotate: bool,
    #[doc(hidden)]
    pub reserved_of_rotate: Reserved<[u8; 3]>,
    /// All 64 bits count. A negative seed is 2^64 more: `-1_i64 as u64`.
    pub seed: u64,
    /// Lattice cells per unit of input. By default 1
    pub frequency: f64,
    /// In (0, 32]. A fraction fades the last one in. By default 1
    pub octaves: f32,
    /// The ratio of frequencies between octaves, in [1/16, 16]. By default 2
    pub lacunarity: f32,
    /// The ratio of amplitudes between octaves, in [1/16, 16]. By default 0.5
    pub gain: f32,
    /// Scales every output; its magnitude in [2^-24, 2^24]. By default 1
    pub amplitude: f32,
    /// Erosion: how strongly slopes damp octaves. By default 1. For other fractals see `scarp.h`
    pub erosion: f32,
    /// Turns of the gradients, so that noise flows; 1 is a loop. Gradient noise alone
    pub phase: f32,
    /// Cellular noise: how far features stray from the middles of their cells, in (0, 1]
    pub jitter: f32,
    /// Of some fractals, in [2^-8, 2^8]: see `scarp.h`. 0: the default of the fractal
    pub sharpness: f32,
    /// Cells of octave 0, in [1, 2^30], after which the noise repeats along each axis; 0: never
    pub period: [u32; 3],
    /// Amplitudes are those of a sum of so many octaves: for levels of detail. 0: `octaves`
    pub of_octaves: f32,
    /// Displaces positions, in units of input. Four warps at most
    pub warp: Option<&'a Noise<'a>>,
    /// The constants of this noise, for many calls with few points
    pub plan: Option<&'a Plan>,
    /// Whether octave 0, too, has an offset that the seed draws: without one every seed has a
    /// lattice point at the origin
    pub offset_first: bool,
    #[doc(hidden)]
    pub reserved_of_offset_first: Reserved<[u8; 3]>,
    #[doc(hidden)]
    pub reserved: Reserved<[u32; SPARE]>,
}

impl Default for Noise<'_> {
    fn default() -> Self {
        Noise::DEFAULT
    }
}

impl<'a> Noise<'a> {
    /// One octave of gradient noise with seed 0, one lattice cell per unit of input
    pub const DEFAULT: Noise<'a> = Noise {
        basis: Basis::Gradient,
        fade: Fade::Quintic,
        fractal: Fractal::Fbm,
        rotate: false,
        reserved_of_rotate: Reserved([0; 3]),
        seed: 0,
        frequency: defaults::frequency,
        octaves: defaults::octaves,
        lacunarity: defaults::lacunarity,
        gain: defaults::gain,
        amplitude: defaults::amplitude,
        erosion: defaults::erosion,
        phase: 0.0,
        jitter: defaults::jitter,
        sharpness: 0.0,
        period: [0; 3],
        of_octaves: 0.0,
        warp: None,
        plan: None,
        offset_first: false,
        reserved_of_offset_first: Reserved([0; 3]),
        reserved: Reserved([0; SPARE]),
    };

    pub(crate) fn c(&self) -> *const ffi::scarp_noise {
        // The layout is that of C: a test compares it. `rotate` and `offset_first` are 0 or
        // not, in any order of bytes.
        (self as *const Noise<'a>).cast()
    }

    /// The interval (lowest, highest) that values never leave, rounding included
    pub fn range(&self, dimensions: usize) -> Result<(f32, f32), Error> {
        self.prepare()?;
        let (mut lowest, mut highest) = (0.0, 0.0);
        let number = c_int::try_from(dimensions).unwrap_or(0);
        // SAFETY: all pointers are valid.
        let status = unsafe { ffi::scarp_range(self.c(), number, &mut lowest, &mut highest) };
        self.blame(status, dimensions, Vec::new)?;
        Ok((lowest, highest))
    }

    /// Samples at the points (x\[i\], y\[i\]) of the plane. All slices have the same length. Where a
    /// coordinate is not finite, outputs are NaN.
    pub fn sample2<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        out: &mut Samples<'_>,
    ) -> Result<(), Error> {
        self.plane(x, y, T::SAMPLE2, |sizes| out.c(sizes))
    }

    /// Samples at points of space, as [`Noise::sample2`]
    ///
    /// ```
    /// use scarp::{Arrays, Noise};
    /// let mut out = Arrays::space(2, 2);
    /// Noise { seed: 5, octaves: 3.0, ..Noise::default() }
    ///     .sample3(&[0.5, 1.5], &[2.25, 2.25], &[0.0, 9.0], &mut out.samples())?;
    /// assert!(out.dzz.iter().all(|curvature| curvature.is_finite()));
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn sample3<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        z: &[T],
        out: &mut Samples<'_>,
    ) -> Result<(), Error> {
        self.space([x, y, z], T::SAMPLE3, |sizes| out.c(sizes))
    }

    /// Both components of the vector noise that this noise makes, as warps displace points by them
    ///
    /// ```
    /// use scarp::{Arrays, Noise};
    /// let (mut u, mut v) = (Arrays::plane(2, 0), Arrays::plane(2, 0));
    /// Noise::default().vector2(&[0.5, 1.5], &[0.25, 0.75], &mut [u.samples(), v.samples()])?;
    /// assert_ne!(u.value, v.value);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn vector2<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        out: &mut [Samples<'_>; 2],
    ) -> Result<(), Error> {
        let [u, v] = out;
        self.plane(x, y, T::VECTOR2, |sizes| [u.c(sizes), v.c(sizes)])
    }

    /// All three components of vector noise in space
    pub fn vector3<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        z: &[T],
        out: &mut [Samples<'_>; 3],
    ) -> Result<(), Error> {
        let [u, v, w] = out;
        self.space([x, y, z], T::VECTOR3, |sizes| [u.c(sizes), v.c(sizes), w.c(sizes)])
    }

    /// The cells of cellular noise around points of the plane, of this frequency, seed, jitter and
    /// period; other members change nothing.
    ///
    /// ```
    /// use scarp::{Cells, Noise};
    /// let (mut distance, mut id) = ([0.0; 2], [0; 2]);
    /// let mut out = Cells { f1: Some(&mut distance), id: Some(&mut id), ..Cells::default() };
    /// Noise::default().cells2(&[0.5, 7.5], &[0.5, 0.5], &mut out)?;
    /// assert_ne!(id[0], id[1]);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn cells2<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        out: &mut Cells<'_>,
    ) -> Result<(), Error> {
        self.plane(x, y, T::CELLS2, |sizes| out.c(sizes))
    }

    /// The cells around points of space
    pub fn cells3<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        z: &[T],
        out: &mut Cells<'_>,
    ) -> Result<(), Error> {
        self.space([x, y, z], T::CELLS3, |sizes| out.c(sizes))
    }

    /// A velocity without divergence at points of the plane, of which this noise is the potential
    ///
    /// ```
    /// use scarp::{Flow, Noise};
    /// let (mut vx, mut vy) = ([0.0; 2], [0.0; 2]);
    /// let mut out = Flow { vx: Some(&mut vx), vy: Some(&mut vy), ..Flow::default() };
    /// Noise { octaves: 3.0, gain: 0.4, ..Noise::default() }.curl2(&[0.5, 1.5], &[0.25, 0.5], &mut out)?;
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn curl2<T: Coordinate>(&self, x: &[T], y: &[T], out: &mut Flow<'_>) -> Result<(), Error> {
        self.plane(x, y, T::CURL2, |sizes| out.c(sizes))
    }

    /// A velocity without divergence at points of space
    pub fn curl3<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        z: &[T],
        out: &mut Flow<'_>,
    ) -> Result<(), Error> {
        self.space([x, y, z], T::CURL3, |sizes| out.c(sizes))
    }

    #[inline]
    fn plane<T: Coordinate, Out, C>(
        &self,
        x: &[T],
        y: &[T],
        call: crate::coordinate::Plane<T, Out>,
        mut out: impl FnMut(&mut Sizes) -> C,
    ) -> Result<(), Error> {
        self.prepare()?;
        let mut sizes = Sizes::points(x.len());
        let y = sizes.input(y, "y");
        let c = out(&mut sizes);
        sizes.check()?;
        let c: *const C = &c;
        // SAFETY: all slices have so many elements. No output is another slice, since it is
        // borrowed for writing. C is Out, or as many of them as the call has components.
        let status = unsafe { call(self.c(), sizes.count, x.as_ptr(), y, c.cast()) };
        self.blame(status, 2, || Sizes::names(out))
    }

    #[inline]
    fn space<T: Coordinate, Out, C>(
        &self,
        at: [&[T]; 3],
        call: crate::coordinate::Space<T, Out>,
        mut out: impl FnMut(&mut Sizes) -> C,
    ) -> Result<(), Error> {
        self.prepare()?;
        let mut sizes = Sizes::points(at[0].len());
        let (y, z) = (sizes.input(at[1], "y"), sizes.input(at[2], "z"));
        let c = out(&mut sizes);
        sizes.check()?;
        let c: *const C = &c;
        // SAFETY: as in `plane`
        let status = unsafe { call(self.c(), sizes.count, at[0].as_ptr(), y, z, c.cast()) };
        self.blame(status, 3, || Sizes::names(out))
    }

    /// Samples on a uniform grid of the plane: the bits of [`Noise::sample2`] with doubles, and
    /// much faster. Slices have [`Grid::len`] elements or more; nothing between the rows is
    /// touched.
    pub fn grid2(&self, grid: &Grid<2>, out: &mut Samples<'_>) -> Result<(), Error> {
        self.grid(grid, ffi::scarp_grid2, out)
    }

    /// Samples on a uniform grid of space
    ///
    /// ```
    /// use scarp::{Arrays, Grid, Noise};
    /// let grid = Grid { step: [0.125; 3], count: [16, 16, 16], ..Grid::<3>::default() };
    /// let mut chunk = Arrays::space(16 * 16 * 16, 1);
    /// Noise::default().grid3(&grid, &mut chunk.samples())?;
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn grid3(&self, grid: &Grid<3>, out: &mut Samples<'_>) -> Result<(), Error> {
        self.grid(grid, ffi::scarp_grid3, out)
    }

    fn grid<const D: usize>(
        &self,
        grid: &Grid<D>,
        call: unsafe extern "C" fn(
            *const ffi::scarp_noise,
            *const ffi::scarp_grid,
            *const ffi::scarp_samples,
        ) -> ffi::scarp_status,
        out: &mut Samples<'_>,
    ) -> Result<(), Error> {
        self.prepare()?;
        let mut sizes = Sizes::grid(grid.needed()?);
        let c = out.c(&mut sizes);
        sizes.check()?;
        // SAFETY: all slices reach from the first sample to the last.
        let status = unsafe { call(self.c(), &grid.c(), &c) };
        if status == ffi::SCARP_ERROR_PARAMETER && self.fault(D).is_none() {
            let text = "an origin or step is not finite, an index is outside [-2^53, 2^53], or a \
                        stride is too short";
            return Err(Error::new(Status::Parameter, "grid", text));
        }
        self.blame(status, D, || Sizes::names(|sizes| out.c(sizes)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ptr::addr_of;

    /// A noise can be handed to C as it is.
    #[test]
    fn layout() {
        assert_eq!(size_of::<Noise<'_>>(), size_of::<ffi::scarp_noise>());
        let noise = Noise::DEFAULT;
        let c = noise.c();
        macro_rules! same {
            ($($member:ident)*) => {$(
                // SAFETY: addresses are taken, and nothing is read.
                let of_c = unsafe { addr_of!((*c).$member) } as usize;
                assert_eq!(addr_of!(noise.$member) as usize, of_c, stringify!($member));
                assert_eq!(std::mem::size_of_val(&noise.$member), unsafe { size(addr_of!((*c).$member)) }
                    - if ["rotate", "offset_first"].contains(&stringify!($member)) { 3 } else { 0 });
            )*};
        }
        unsafe fn size<T>(_: *const T) -> usize {
            size_of::<T>()
        }
        same!(basis fade fractal rotate seed frequency octaves lacunarity gain amplitude erosion
            phase jitter sharpness period of_octaves warp plan offset_first);
        let turned = Noise { rotate: true, ..noise };
        let moved = Noise { offset_first: true, ..noise };
        // SAFETY: the layout is that of C, and all bytes are initialised.
        unsafe {
            assert_eq!(((*c).rotate, (*c).lacunarity, (*c).frequency), (0, 2.0, 1.0));
            assert_ne!((*turned.c()).rotate, 0);
            assert_eq!((*turned.c()).offset_first, 0);
            assert_ne!((*moved.c()).offset_first, 0);
            assert_eq!((*moved.c()).spare_word, 0);
            assert!((*c).spare.iter().all(|word| *word == 0));
        }
    }

    /// The defaults are those of C: zeros there give the same bits.
    #[test]
    fn zeros() {
        let (x, y) = ([0.3f32, 1.7, 2.9], [0.1f32, 0.6, 5.2]);
        for fractal in Fractal::ALL {
            for basis in [Basis::Gradient, Basis::CellF1] {
                let noise = Noise { basis, fractal: *fractal, octaves: 3.0, ..Noise::DEFAULT };
                let zeros = ffi::scarp_noise {
                    basis: basis as u32,
                    fractal: *fractal as u32,
                    octaves: 3.0,
                    ..Default::default()
                };
                let (mut ours, mut theirs) = ([0.0; 3], [0.0; 3]);
                let mut out = Samples { value: Some(&mut ours), ..Samples::default() };
                noise.sample2(&x, &y, &mut out).unwrap();
                let c = ffi::scarp_samples { value: theirs.as_mut_ptr(), ..Default::default() };
                // SAFETY: all slices have three elements.
                let status = unsafe { ffi::scarp_sample2(&zeros, 3, x.as_ptr(), y.as_ptr(), &c) };
                assert_eq!((status, ours), (ffi::SCARP_OK, theirs), "{} {}", basis, fractal);
            }
        }
    }

    #[test]
    fn threads_may_share_it() {
        fn shared<T: Send + Sync>() {}
        shared::<Noise<'_>>();
        shared::<Plan>();
        shared::<crate::Gullies>();
        shared::<crate::Recipe>();
        shared::<Error>();
        shared::<crate::Bands<'_, 2>>();
    }
}
