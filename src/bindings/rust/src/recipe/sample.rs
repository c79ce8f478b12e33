// SPDX-License-Identifier: MIT
//! Samples of recipes, at points and on grids.
use super::Recipe;
use crate::arrays::{Samples, Sizes};
use crate::coordinate::Coordinate;
use crate::error::{Error, Status};
use crate::ffi;
use crate::grid::Grid;

const MOST_OUTPUTS: usize = 16;
const MOST_SCRATCH: usize = 1 << 26; // bytes

/// Memory that calls of recipes use while they run. Keep one for each thread: calls then allocate
/// nothing, but for the first one.
///
/// ```
/// use scarp::{Arrays, Recipe, Scratch};
/// let recipe = Recipe::preset("hills")?;
/// let (mut scratch, mut point) = (Scratch::new(), Arrays::plane(1, 0));
/// for i in 0..10 {
///     let out = &mut [("hills", point.samples())];
///     recipe.sample2(&[f64::from(i)], &[0.0], out, &mut scratch)?;
/// }
/// # Ok::<(), scarp::Error>(())
/// ```
#[derive(Debug, Default)]
pub struct Scratch(Vec<u64>);

impl Scratch {
    /// Without memory yet
    pub fn new() -> Scratch {
        Scratch::default()
    }

    fn c(&mut self, bytes: usize, plan: &[u64]) -> ffi::scarp_scratch {
        let words = bytes / 8 + 1;
        if self.0.len() < words {
            self.0.resize(words, 0);
        }
        ffi::scarp_scratch {
            memory: self.0.as_mut_ptr().cast(),
            size: 8 * words,
            plan: plan.as_ptr().cast(),
            ..Default::default()
        }
    }
}

impl Recipe {
    /// Samples of outputs at points of the plane: pairs of a name and of slices, which have as many
    /// elements as there are points. One to 16 outputs; several take little more time than one.
    /// Coordinates of floats give the bits of shaders, those of doubles the bits of grids.
    pub fn sample2<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        outputs: &mut [(&str, Samples<'_>)],
        scratch: &mut Scratch,
    ) -> Result<(), Error> {
        self.of_dimensions(2)?;
        let mut sizes = Sizes::points(x.len());
        let at = [x.as_ptr(), sizes.input(y, "y"), std::ptr::null()];
        self.sample(at, sizes, outputs, scratch)
    }

    /// Samples of outputs at points of space, of a recipe that says `space 3`
    ///
    /// ```
    /// use scarp::{Arrays, Recipe, Scratch};
    /// let recipe = Recipe::new("recipe 1\nspace 3\nout a = noise(size=8) - z / 4")?;
    /// let mut out = Arrays::space(2, 1);
    /// let (x, y, z) = ([0.5, 1.5], [2.5, 3.5], [0.0, 9.0]);
    /// recipe.sample3(&x, &y, &z, &mut [("a", out.samples())], &mut Scratch::new())?;
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn sample3<T: Coordinate>(
        &self,
        x: &[T],
        y: &[T],
        z: &[T],
        outputs: &mut [(&str, Samples<'_>)],
        scratch: &mut Scratch,
    ) -> Result<(), Error> {
        self.of_dimensions(3)?;
        let mut sizes = Sizes::points(x.len());
        let at = [x.as_ptr(), sizes.input(y, "y"), sizes.input(z, "z")];
        self.sample(at, sizes, outputs, scratch)
    }

    fn sample<T: Coordinate>(
        &self,
        [x, y, z]: [*const T; 3],
        sizes: Sizes,
        outputs: &mut [(&str, Samples<'_>)],
        scratch: &mut Scratch,
    ) -> Result<(), Error> {
        let count = sizes.count;
        self.run(sizes, outputs, scratch, |outputs, scratch| {
            // SAFETY: `run` has checked all slices. No output is another slice, since it is
            // borrowed for writing.
            unsafe { T::RECIPE(&*self.c, count, x, y, z, outputs, scratch) }
        })
    }

    /// Samples of outputs on a grid of the plane: slices are as those of
    /// [`Noise::grid2`](crate::Noise::grid2).
    pub fn grid2(
        &self,
        grid: &Grid<2>,
        outputs: &mut [(&str, Samples<'_>)],
        scratch: &mut Scratch,
    ) -> Result<(), Error> {
        self.grid(grid, outputs, scratch)
    }

    /// Samples of outputs on a grid of space, of a recipe that says `space 3`
    pub fn grid3(
        &self,
        grid: &Grid<3>,
        outputs: &mut [(&str, Samples<'_>)],
        scratch: &mut Scratch,
    ) -> Result<(), Error> {
        self.grid(grid, outputs, scratch)
    }

    fn grid<const D: usize>(
        &self,
        grid: &Grid<D>,
        outputs: &mut [(&str, Samples<'_>)],
        scratch: &mut Scratch,
    ) -> Result<(), Error> {
        self.of_dimensions(D)?;
        let c = grid.c();
        self.run(Sizes::grid(grid.needed()?), outputs, scratch, |outputs, scratch| {
            // SAFETY: `run` has checked that all slices reach from the first sample to the last.
            unsafe { ffi::scarp_recipe_grid(&*self.c, &c, outputs, scratch) }
        })
    }

    fn of_dimensions(&self, dimensions: usize) -> Result<(), Error> {
        if dimensions == self.dimensions {
            return Ok(());
        }
        let text =
            if dimensions == 2 { "the recipe is of space" } else { "the recipe is of the plane" };
        Err(Error::new(Status::Parameter, "dimensions", text))
    }

    /// Checks the slices, sees to the scratch memory, and calls.
    fn run(
        &self,
        mut sizes: Sizes,
        outputs: &mut [(&str, Samples<'_>)],
        scratch: &mut Scratch,
        call: impl Fn(*const ffi::scarp_recipe_outputs, *const ffi::scarp_scratch) -> ffi::scarp_status,
    ) -> Result<(), Error> {
        if outputs.is_empty() || outputs.len() > MOST_OUTPUTS {
            let text = format!("from 1 to 16 outputs, not {}", outputs.len());
            return Err(Error::new(Status::Parameter, "outputs", text));
        }
        let mut out = [ffi::scarp_samples::default(); MOST_OUTPUTS];
        let (mut which, mut order) = ([0; MOST_OUTPUTS], 0);
        for (i, (name, samples)) in outputs.iter_mut().enumerate() {
            which[i] = self.which(name)?;
            out[i] = samples.c(&mut sizes);
            order = order.max(order_of(samples));
        }
        sizes.check()?;
        let asked = ffi::scarp_recipe_outputs {
            out: out.as_ptr(),
            which: which.as_ptr(),
            count: outputs.len() as i32,
            ..Default::default()
        };
        // SAFETY: the pointer is valid.
        let bytes_of = |points| unsafe { ffi::scarp_recipe_scratch_size(&*self.c, order, points) };
        let bytes = match (bytes_of(sizes.count.max(1)), bytes_of(0)) {
            (0, best) => best, // more points than memory has room for
            (few, best) => few.min(best),
        };
        let mut status = call(&asked, &scratch.c(bytes, &self.plan));
        // That is the size for outputs of the text. Other fields may need more.
        let mut more = bytes.max(8192);
        while status == ffi::SCARP_ERROR_SIZE && more < MOST_SCRATCH {
            more *= 2;
            status = call(&asked, &scratch.c(more, &self.plan));
        }
        self.blame(status, outputs)
    }

    /// The error of a call that failed: the first output whose derivatives do not exist, or the
    /// grid
    fn blame(
        &self,
        status: ffi::scarp_status,
        outputs: &[(&str, Samples<'_>)],
    ) -> Result<(), Error> {
        match status {
            ffi::SCARP_OK => Ok(()),
            ffi::SCARP_ERROR_UNSUPPORTED => {
                let lacks = |(name, asked): &&(&str, Samples<'_>)| self.lacks(name, asked);
                let name = outputs.iter().find(lacks).map_or("", |(name, _)| *name);
                let text = "it does not have all derivatives that are asked for";
                Err(Error::new(Status::Unsupported, name.to_owned(), text))
            }
            ffi::SCARP_ERROR_PARAMETER => Err(Error::of(status, "grid")),
            _ => Err(Error::of(status, "")),
        }
    }

    /// Whether an output does not have what is asked of it
    fn lacks(&self, name: &str, asked: &Samples<'_>) -> bool {
        let entry = self.which(name).ok().and_then(|index| self.entry_at(index as usize));
        let has_z = any(&[&asked.dz, &asked.dxz, &asked.dyz, &asked.dzz]);
        asked.dphase.is_some()
            || self.dimensions == 2 && has_z
            || entry.map_or(false, |entry| (entry.order as i32) < order_of(asked))
    }
}

fn any(slices: &[&Option<&mut [f32]>]) -> bool {
    slices.iter().any(|slice| slice.is_some())
}

/// The highest order of derivatives that are asked for
fn order_of(out: &Samples<'_>) -> i32 {
    if any(&[&out.dxx, &out.dxy, &out.dxz, &out.dyy, &out.dyz, &out.dzz]) {
        2
    } else {
        i32::from(any(&[&out.dx, &out.dy, &out.dz]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether the recipe has the plan that C makes of it now
    fn has_plan(recipe: &Recipe) -> bool {
        // SAFETY: all pointers are valid, and there is room for all bytes.
        unsafe {
            let bytes = ffi::scarp_recipe_plan_size(recipe.as_ptr());
            let mut plan = vec![0u64; bytes / 8 + 1];
            let to = plan.as_mut_ptr().cast();
            bytes > 0
                && ffi::scarp_recipe_plan_make(recipe.as_ptr(), to, bytes) == ffi::SCARP_OK
                && recipe.plan[..bytes / 8] == plan[..bytes / 8]
        }
    }

    #[test]
    fn a_recipe_has_its_plan() -> Result<(), Error> {
        let mut recipe =
            Recipe::new("recipe 1\nparam h = 1 [0, 9]\nout a = h * noise(size=8, octaves=3)")?;
        assert!(has_plan(&recipe));
        recipe.set_seed(7)?;
        assert!(has_plan(&recipe));
        recipe.set("finest", 4.0)?;
        assert!(recipe.set("h", -1.0).is_err() && has_plan(&recipe));
        let mut other = recipe.clone();
        other.set_scale(2.0, 3.0)?;
        other.set_tile([64.0, 32.0, 0.0])?;
        assert!(has_plan(&other) && has_plan(&recipe) && other.plan != recipe.plan);
        let room = Scratch::new().c(100, &recipe.plan);
        assert!(room.plan == recipe.plan.as_ptr().cast() && room.size >= 100);
        Ok(())
    }
}
