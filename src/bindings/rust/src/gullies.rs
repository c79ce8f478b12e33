// SPDX-License-Identifier: MIT
//! Gullies and spurs that run down the slopes of a base.
use crate::arrays::{Eroded, Sizes, View};
use crate::coordinate::Coordinate;
use crate::error::{ready, text_of, Error, Status};
use crate::ffi::{self, defaults::scarp_gullies as defaults};
use crate::grid::Grid;
use crate::noise::Reserved;

/// Gullies that run down a base and branch: erosion as a function of the place
///
/// All lengths are in cells of the base, all heights in its amplitudes, so a terrain scales as a
/// whole. `scarp.h` has the formula, and what makes a good base. 0 would be the default in C; here
/// it is an error. For an effect that is not wanted give 2^-24.
///
/// ```
/// use scarp::{Arrays, Eroded, Grid, Gullies, Noise};
/// let grid = Grid { step: [10.0; 2], count: [64, 64], ..Grid::<2>::default() };
/// let mut base = Arrays::plane(64 * 64, 1); // gradients show gullies where to run
/// let hills = Noise { seed: 1, frequency: 1.0 / 400.0, octaves: 3.0, amplitude: 90.0, ..Noise::default() };
/// hills.grid2(&grid, &mut base.samples())?;
///
/// let gullies = Gullies { seed: 3, frequency: 1.0 / 400.0, amplitude: 90.0, ..Gullies::default() };
/// let mut height = vec![0.0; 64 * 64];
/// let mut out = Eroded { value: Some(&mut height), ..Eroded::default() };
/// gullies.grid2(&grid, &base.view(), &mut out)?;
///
/// let (lowest, highest) = gullies.range(hills.range(2)?)?;
/// assert!(height.iter().all(|value| (lowest..=highest).contains(value)));
/// # Ok::<(), scarp::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Gullies {
    /// All 64 bits count. A negative seed is 2^64 more: `-1_i64 as u64`.
    pub seed: u64,
    /// Of the base: cells per unit of input. By default 1
    pub frequency: f64,
    /// Of the base: half the height from its floors to its crests. By default 1
    pub amplitude: f32,
    /// In (0, 32]. A fraction fades in. By default 5
    pub octaves: f32,
    /// Weights are those of a sum of so many octaves; 0: `octaves`
    pub of_octaves: f32,
    /// The ratio of frequencies between octaves. By default 2
    pub lacunarity: f32,
    /// The ratio of weights between octaves. By default 0.45
    pub gain: f32,
    /// How far the base is displaced at most, in amplitudes. By default 0.25
    pub depth: f32,
    /// Cells of the first gullies per cell of the base. By default 3
    pub cells: f32,
    /// Where gullies of crests have half their depth. By default 1.125
    pub slope: f32,
    /// The same of floors. By default 1.75
    pub slope_low: f32,
    /// The height of floors. By default -1
    pub low: f32,
    /// The height of crests. By default 1
    pub high: f32,
    /// How far floors sink: 1 as deep as gullies, -1 filled up. By default 0.5
    pub floor: f32,
    /// Gullies per cell. By default 1.5
    pub stripes: f32,
    /// How far octaves turn those after them. By default 0.8
    pub branch: f32,
    /// Of crests: 0.05 is an arete, 1 rolling. By default 0.15
    pub round: f32,
    /// How much crests and floors of an octave are spared by the next one. By default 1
    pub keep: f32,
    /// Cells of the base after which gullies repeat along each axis; 0: never
    pub period: [u32; 2],
    /// Turn the axes between octaves
    pub rotate: bool,
    #[doc(hidden)]
    pub reserved_of_rotate: Reserved<[u8; 3]>,
    /// Whether the first gullies, too, have an offset that the seed draws
    pub offset_first: bool,
    #[doc(hidden)]
    pub reserved_of_offset_first: Reserved<[u8; 3]>,
    #[doc(hidden)]
    pub reserved: Reserved<[u32; 8]>,
}

impl Default for Gullies {
    fn default() -> Self {
        Gullies {
            seed: 0,
            frequency: defaults::frequency,
            amplitude: defaults::amplitude,
            octaves: defaults::octaves,
            of_octaves: 0.0,
            lacunarity: defaults::lacunarity,
            gain: defaults::gain,
            depth: defaults::depth,
            cells: defaults::cells,
            slope: defaults::slope,
            slope_low: defaults::slope_low,
            low: defaults::low,
            high: defaults::high,
            floor: defaults::floor,
            stripes: defaults::stripes,
            branch: defaults::branch,
            round: defaults::round,
            keep: defaults::keep,
            period: [0; 2],
            rotate: false,
            reserved_of_rotate: Reserved([0; 3]),
            offset_first: false,
            reserved_of_offset_first: Reserved([0; 3]),
            reserved: Reserved([0; 8]),
        }
    }
}

impl Gullies {
    fn c(&self) -> *const ffi::scarp_gullies {
        (self as *const Gullies).cast() // the layout is that of C: a test compares it
    }

    /// Whether calls take these gullies; if not, the error names the member at fault.
    pub fn check(&self) -> Result<(), Error> {
        ready()?;
        let numbers = [
            ("amplitude", self.amplitude),
            ("octaves", self.octaves),
            ("lacunarity", self.lacunarity),
            ("gain", self.gain),
            ("depth", self.depth),
            ("cells", self.cells),
            ("slope", self.slope),
            ("slope_low", self.slope_low),
            ("low", self.low),
            ("high", self.high),
            ("floor", self.floor),
            ("stripes", self.stripes),
            ("branch", self.branch),
            ("round", self.round),
            ("keep", self.keep),
        ];
        let zero = numbers.iter().find(|(_, number)| *number == 0.0).map(|(name, _)| *name);
        let zero = if self.frequency == 0.0 { Some("frequency") } else { zero };
        if let Some(name) = zero {
            let text = "must not be 0. Leave it out for the default, or give 2^-24 for no effect";
            return Err(Error::new(Status::Parameter, name, text));
        }
        let mut member = std::ptr::null();
        // SAFETY: all pointers are valid, or may be null, and the layout is that of C.
        let (status, text) = unsafe {
            let status = ffi::scarp_gullies_check(self.c(), &mut member);
            (status, ffi::scarp_gullies_fault(self.c(), std::ptr::null_mut()))
        };
        match text_of(text) {
            None => Ok(()),
            Some(text) => Err(Error::new(Status::of(status), text_of(member).unwrap_or(""), text)),
        }
    }

    /// The interval (lowest, highest) that values never leave, for a base that stays within
    /// another
    pub fn range(&self, base: (f32, f32)) -> Result<(f32, f32), Error> {
        self.check()?;
        let (mut lowest, mut highest) = (0.0, 0.0);
        // SAFETY: all pointers are valid.
        crate::error::check(unsafe {
            ffi::scarp_gullies_range(self.c(), base.0, base.1, &mut lowest, &mut highest)
        })?;
        Ok((lowest, highest))
    }

    /// Draws gullies into a base at the points (x\[i\], y\[i\]), where it was sampled. The base has
    /// `value`, `dx` and `dy`, and for derivatives `dxx`, `dxy` and `dyy`.
    pub fn sample2<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        base: &View<'_>,
        out: &mut Eroded<'_>,
    ) -> Result<(), Error> {
        self.check()?;
        let mut sizes = Sizes::points(x.len());
        let y = sizes.input(y, "y");
        let (base, out) = (base.c(&mut sizes), out.c(&mut sizes));
        sizes.check()?;
        // SAFETY: all slices have so many elements. No output is another slice, since it is
        // borrowed for writing.
        crate::error::check(unsafe {
            T::GULLIES2(self.c(), sizes.count, x.as_ptr(), y, &base, &out)
        })
    }

    /// Draws gullies into a base on a grid, as [`Gullies::sample2`]. Slices are as those of
    /// [`Noise::grid2`](crate::Noise::grid2).
    pub fn grid2(
        &self,
        grid: &Grid<2>,
        base: &View<'_>,
        out: &mut Eroded<'_>,
    ) -> Result<(), Error> {
        self.check()?;
        let mut sizes = Sizes::grid(grid.needed()?);
        let (base, out) = (base.c(&mut sizes), out.c(&mut sizes));
        sizes.check()?;
        // SAFETY: all slices reach from the first sample to the last.
        let status = unsafe { ffi::scarp_gullies_grid2(self.c(), &grid.c(), &base, &out) };
        match status {
            ffi::SCARP_ERROR_PARAMETER => Err(Error::of(status, "grid")),
            _ => crate::error::check(status),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::mem::size_of;
    use std::ptr::addr_of;

    #[test]
    fn layout() {
        assert_eq!(size_of::<Gullies>(), size_of::<ffi::scarp_gullies>());
        let gullies = Gullies::default();
        let c = gullies.c();
        macro_rules! same {
            ($($member:ident)*) => {$(
                // SAFETY: addresses are taken, and nothing is read.
                let of_c = unsafe { addr_of!((*c).$member) } as usize;
                assert_eq!(addr_of!(gullies.$member) as usize, of_c, stringify!($member));
            )*};
        }
        same!(seed frequency amplitude octaves of_octaves lacunarity gain depth cells slope
            slope_low low high floor stripes branch round keep period rotate
            offset_first);
    }

    /// The defaults are those of C: zeros there give the same bits.
    #[test]
    fn defaults() {
        let (x, y) = ([0.3f32, 1.7, 2.9], [0.1f32, 0.6, 5.2]);
        let slopes = [0.7f32, -0.4, 1.1];
        let base = View { value: Some(&y), dx: Some(&slopes), dy: Some(&x), ..View::default() };
        let (mut ours, mut theirs) = ([0.0; 3], [0.0; 3]);
        let mut out = Eroded { value: Some(&mut ours), ..Eroded::default() };
        Gullies::default().sample2(&x, &y, &base, &mut out).unwrap();
        let zeros = ffi::scarp_gullies::default();
        let mut sizes = Sizes::points(3);
        let base = base.c(&mut sizes);
        let c = ffi::scarp_eroded { value: theirs.as_mut_ptr(), ..Default::default() };
        // SAFETY: all slices have three elements.
        let status = unsafe { ffi::scarp_gullies2(&zeros, 3, x.as_ptr(), y.as_ptr(), &base, &c) };
        assert_eq!((status, ours), (ffi::SCARP_OK, theirs));
        assert_ne!(ours, y);
    }
}
