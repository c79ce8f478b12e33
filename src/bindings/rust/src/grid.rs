// SPDX-License-Identifier: MIT
//! Uniform grids, and the bands of rows that threads take.
use crate::arrays::Samples;
use crate::error::{Error, Status};
use crate::ffi;

/// A uniform grid of the plane, `Grid<2>`, or of space, `Grid<3>`
///
/// Sample (i, j, k) lies at `origin[d] + (first[d] + index) * step[d]` along each axis d, in the
/// order x, y, z; it is element `k * slice_stride + j * row_stride + i` of each slice. So a world is
/// the same, to the bit, whatever tiles it is computed in: give tiles their `first`, and the same
/// origin and step.
///
/// ```
/// use scarp::Grid;
/// let tile = Grid { step: [0.5; 2], first: [256, 0], count: [64, 32], ..Grid::<2>::default() };
/// assert_eq!(tile.position([1, 2]), [128.5, 1.0]);
/// assert_eq!(tile.len(), Some(64 * 32));
/// ```
///
/// There are no others:
///
/// ```compile_fail,E0080
/// scarp::Grid::<4>::default();
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid<const D: usize> {
    /// Finite. By default 0
    pub origin: [f64; D],
    /// Finite; may be 0 or negative. By default 1
    pub step: [f64; D],
    /// The index of the first sample. By default 0
    pub first: [i64; D],
    /// How many samples there are along each axis. By default 0
    pub count: [usize; D],
    /// Elements from one row to the next, at least `count[0]`; 0: `count[0]`
    pub row_stride: usize,
    /// In space, elements from one slice to the next, at least those from its first to its last;
    /// 0: `count[1]` rows
    pub slice_stride: usize,
}

impl<const D: usize> Default for Grid<D> {
    fn default() -> Self {
        let () = Self::IS_OF_PLANE_OR_SPACE;
        Grid {
            origin: [0.0; D],
            step: [1.0; D],
            first: [0; D],
            count: [0; D],
            row_stride: 0,
            slice_stride: 0,
        }
    }
}

impl<const D: usize> Grid<D> {
    const IS_OF_PLANE_OR_SPACE: () = assert!(D == 2 || D == 3, "it is Grid<2> or Grid<3>");

    /// Where a sample lies
    pub fn position(&self, index: [usize; D]) -> [f64; D] {
        let mut at = self.origin;
        for (d, place) in at.iter_mut().enumerate() {
            *place += self.first[d].wrapping_add(index[d] as i64) as f64 * self.step[d];
        }
        at
    }

    /// Elements from one row, or in space from one slice, to the next
    fn stride(&self) -> Option<usize> {
        let row = if self.row_stride != 0 { self.row_stride } else { self.count[0] };
        match (D, self.slice_stride) {
            (2, _) => Some(row),
            (_, 0) => row.checked_mul(self.count[1]),
            (_, slice) => Some(slice),
        }
    }

    /// Elements from the first sample to the last: the least length of slices; `None` if there is
    /// no such number
    pub fn len(&self) -> Option<usize> {
        if self.is_empty() {
            return Some(0);
        }
        let row = if self.row_stride != 0 { self.row_stride } else { self.count[0] };
        let mut length = self.count[0];
        for (d, stride) in [(1, Some(row)), (2, self.stride())] {
            if d < D {
                length = length.checked_add(stride?.checked_mul(self.count[d] - 1)?)?;
            }
        }
        Some(length)
    }

    /// Whether there are no samples
    pub fn is_empty(&self) -> bool {
        let () = Self::IS_OF_PLANE_OR_SPACE; // also of grids that were not made by default()
        self.count.contains(&0)
    }

    pub(crate) fn needed(&self) -> Result<usize, Error> {
        self.len().ok_or_else(|| Error::of(ffi::SCARP_ERROR_SIZE, "count"))
    }

    pub(crate) fn c(&self) -> ffi::scarp_grid {
        let mut c = ffi::scarp_grid {
            row_stride: self.row_stride,
            slice_stride: if D == 3 { self.slice_stride } else { 0 },
            ..Default::default()
        };
        c.origin[..D].copy_from_slice(&self.origin);
        c.step[..D].copy_from_slice(&self.step);
        c.first[..D].copy_from_slice(&self.first);
        c.count[..D].copy_from_slice(&self.count);
        c
    }

    /// Cuts the grid and its outputs into bands of so many rows each, in space of so many slices.
    /// A band is a grid with outputs of its own, so threads may take them. Bands of 16 rows and
    /// more are computed about as fast as the whole.
    ///
    /// ```
    /// use scarp::{Arrays, Grid, Noise};
    /// let noise = Noise { octaves: 8.0, frequency: 0.01, ..Noise::default() };
    /// let grid = Grid { count: [256, 100], ..Grid::<2>::default() };
    /// let mut tile = Arrays::plane(256 * 100, 1);
    /// let mut out = tile.samples();
    /// std::thread::scope(|scope| {
    ///     let bands = grid.bands(&mut out, 50)?; // 50 rows for each of two threads
    ///     let threads: Vec<_> = bands
    ///         .map(|(band, mut out)| scope.spawn(move || noise.grid2(&band, &mut out)))
    ///         .collect();
    ///     threads.into_iter().try_for_each(|thread| thread.join().unwrap())
    /// })?;
    /// let mut whole = Arrays::plane(256 * 100, 1);
    /// noise.grid2(&grid, &mut whole.samples())?;
    /// assert!(tile == whole);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    ///
    /// A slice that is too short for the grid, strides that are too short, and bands of 0 rows are
    /// errors.
    pub fn bands<'a>(
        &self,
        out: &'a mut Samples<'_>,
        length: usize,
    ) -> Result<Bands<'a, D>, Error> {
        let mut sizes = crate::arrays::Sizes::grid(self.needed()?);
        out.c(&mut sizes);
        sizes.check()?;
        if length == 0 {
            return Err(Error::new(Status::Parameter, "length", "bands need one row at least"));
        }
        let row = if self.row_stride != 0 { self.row_stride } else { self.count[0] };
        let plane = Grid::<2> {
            count: [self.count[0], self.count[1]],
            row_stride: row,
            ..Default::default()
        };
        let stride = self.stride().ok_or_else(|| Error::of(ffi::SCARP_ERROR_SIZE, "count"))?;
        let short = if row < self.count[0] {
            Some("row_stride")
        } else if D == 3 && !self.is_empty() && plane.needed()? > stride {
            Some("slice_stride")
        } else {
            None
        };
        match short {
            Some(name) => Err(Error::of(ffi::SCARP_ERROR_PARAMETER, name)),
            None => Ok(Bands {
                grid: *self,
                out: out.reborrow(),
                left: if self.is_empty() { 0 } else { self.count[D - 1] },
                length,
                stride,
            }),
        }
    }

    /// The rows of the grid, in space its slices: bands of one
    ///
    /// ```
    /// use scarp::{Arrays, Grid, Noise};
    /// let grid = Grid { step: [0.25; 2], count: [5, 3], ..Grid::<2>::default() };
    /// let mut tile = Arrays::plane(15, 0);
    /// for (row, mut out) in grid.rows(&mut tile.samples())? {
    ///     Noise::default().grid2(&row, &mut out)?;
    ///     println!("y = {}: {:?}", row.position([0, 0])[1], out.value.unwrap());
    /// }
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn rows<'a>(&self, out: &'a mut Samples<'_>) -> Result<Bands<'a, D>, Error> {
        self.bands(out, 1)
    }
}

/// The bands of a grid, each with its outputs: see [`Grid::bands`]
#[derive(Debug)]
pub struct Bands<'a, const D: usize> {
    grid: Grid<D>, // count[D - 1] is that of the whole
    out: Samples<'a>,
    left: usize,
    length: usize,
    stride: usize,
}

impl<'a, const D: usize> Iterator for Bands<'a, D> {
    type Item = (Grid<D>, Samples<'a>);

    fn next(&mut self) -> Option<Self::Item> {
        if self.left == 0 {
            return None;
        }
        let mut band = self.grid;
        band.count[D - 1] = self.length.min(self.left);
        self.grid.first[D - 1] = self.grid.first[D - 1].saturating_add(self.length as i64);
        self.left -= band.count[D - 1];
        // The last band takes what is left, which need not be a whole row.
        let elements = self.stride.saturating_mul(band.count[D - 1]);
        Some((band, self.out.take_front(elements)))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let count = self.left / self.length + usize::from(self.left % self.length != 0);
        (count, Some(count))
    }
}

impl<const D: usize> ExactSizeIterator for Bands<'_, D> {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_cover_all() {
        let grid = Grid::<2> { count: [5, 7], row_stride: 8, ..Default::default() };
        assert_eq!(grid.len(), Some(6 * 8 + 5));
        let mut value = vec![0.0; 6 * 8 + 5];
        let mut out = Samples { value: Some(&mut value), ..Samples::default() };
        let bands = grid.bands(&mut out, 3).unwrap();
        assert_eq!(bands.len(), 3);
        let mut seen = Vec::new();
        for (band, out) in bands {
            let slice = out.value.unwrap();
            assert!(slice.len() >= band.len().unwrap());
            slice.iter_mut().for_each(|x| *x += 1.0);
            seen.push((band.first[1], band.count[1], slice.len()));
        }
        assert_eq!(seen, [(0, 3, 24), (3, 3, 24), (6, 1, 5)]);
        assert!(value.iter().all(|x| *x == 1.0));
    }

    #[test]
    fn slices_of_space() {
        let grid =
            Grid::<3> { count: [3, 2, 4], row_stride: 4, slice_stride: 10, ..Default::default() };
        assert_eq!(grid.len(), Some(3 * 10 + 4 + 3));
        let mut value = vec![0.0; 37];
        let mut out = Samples { value: Some(&mut value), ..Samples::default() };
        let lengths: Vec<_> = grid
            .rows(&mut out)
            .unwrap()
            .map(|(g, o)| (g.first[2], o.value.unwrap().len()))
            .collect();
        assert_eq!(lengths, [(0, 10), (1, 10), (2, 10), (3, 7)]);
    }

    #[test]
    fn mistakes() {
        let mut value = vec![0.0; 30];
        let mut out = Samples { value: Some(&mut value), ..Samples::default() };
        let grid = Grid::<2> { count: [5, 7], ..Default::default() };
        let error = grid.rows(&mut out).unwrap_err();
        assert_eq!((error.status(), error.member()), (Status::Size, Some("value")));
        let short = Grid { count: [5, 2], row_stride: 4, ..grid };
        assert_eq!(short.rows(&mut out).unwrap_err().member(), Some("row_stride"));
        let flat = Grid::<3> { count: [3, 2, 2], slice_stride: 5, ..Default::default() };
        assert_eq!(flat.rows(&mut out).unwrap_err().member(), Some("slice_stride"));
        let none = Grid { count: [5, 2], ..grid };
        assert_eq!(none.bands(&mut out, 0).unwrap_err().member(), Some("length"));
        let huge = Grid::<2> { count: [5, usize::MAX], ..Default::default() };
        assert_eq!((huge.len(), huge.rows(&mut out).unwrap_err().status()), (None, Status::Size));
        assert_eq!(Grid::<2>::default().rows(&mut out).unwrap().len(), 0);
    }
}
