// SPDX-License-Identifier: MIT
//! Recipes: compositions of noises as a text.
use crate::error::{ready, Error, Place, Status};
use crate::ffi;
use std::ffi::CString;

mod sample;
mod shader;
pub use sample::Scratch;

include!(concat!(env!("OUT_DIR"), "/presets.rs")); // PRESETS: pairs of a name and a text

const MOST_ERRORS: usize = 32;

/// A parameter of a recipe, and the interval that it has
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Param<'a> {
    /// Its name in the text
    pub name: &'a str,
    /// Its value
    pub value: f64,
    /// The interval, for a slider
    pub lowest: f64,
    /// The end of the interval
    pub highest: f64,
}

/// What an output is made of, or another field of the text
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Info {
    /// The length of the largest cell of all noises, in units of x and y; 0 without any
    pub largest_cell: f64,
    /// The length of the smallest cell
    pub smallest_cell: f64,
    /// Whether values may jump
    pub jumps: bool,
    /// Whether it depends on x, y and z
    pub axes: [bool; 3],
    /// The highest order of its derivatives
    pub order: u32,
}

/// A statement of the text: what does not change with parameters
#[derive(Clone, Debug)]
struct Entry {
    name: String,
    is_param: bool,
    is_field: bool,
    output: i32,
}

/// A composition of noises as a text, with exact derivatives and a promised range;
/// `src/recipe/README.md` of scarp teaches the language.
///
/// Calls that sample read a recipe, so any number of threads may share it; each has [`Scratch`]
/// memory of its own. Outputs are asked for by their names, and so is any other field of the text.
///
/// ```
/// use scarp::{Arrays, Grid, Recipe, Scratch};
/// let mut recipe = Recipe::new(
///     "recipe 1
///      param height = 110 [0, 10000]
///      bend   = noise(size=286, octaves=5, amplitude=75)
///      ridges = warp(noise(swiss, rotate, size=200, octaves=9, gain=0.45), bend)
///      out alps = height * ridges",
/// )?;
/// recipe.set("height", 900.0)?;
/// recipe.set_seed(8)?;
///
/// let grid = Grid { step: [30.0; 2], count: [64, 64], ..Grid::<2>::default() };
/// let (mut alps, mut bend) = (Arrays::plane(64 * 64, 1), Arrays::plane(64 * 64, 0));
/// let outputs = &mut [("alps", alps.samples()), ("bend", bend.samples())];
/// recipe.grid2(&grid, outputs, &mut Scratch::new())?;
///
/// let (lowest, highest) = recipe.range("alps")?;
/// assert!(alps.value.iter().all(|value| (lowest..=highest).contains(value)));
/// # Ok::<(), scarp::Error>(())
/// ```
///
/// Errors of the text have places:
///
/// ```
/// let error = scarp::Recipe::new("recipe 1\nout a = noise(size=100, octaves=99)").unwrap_err();
/// let place = &error.places()[0];
/// assert_eq!((place.line, place.column, place.member), (2, 33, Some("octaves")));
/// ```
#[derive(Clone)]
pub struct Recipe {
    c: Box<ffi::scarp_recipe>,
    plan: Vec<u64>, // made of `c` whenever that changes
    text: String,
    entries: Vec<Entry>,
    dimensions: usize,
    seed: u64,
}

impl std::fmt::Debug for Recipe {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Recipe").field("text", &self.text).field("seed", &self.seed).finish()
    }
}

impl std::str::FromStr for Recipe {
    type Err = Error;

    fn from_str(text: &str) -> Result<Recipe, Error> {
        Recipe::new(text)
    }
}

/// The names of the recipes that [`Recipe::preset`] has, those of the program `scarp`
///
/// ```
/// assert!(scarp::presets().any(|name| name == "alps"));
/// ```
pub fn presets() -> impl Iterator<Item = &'static str> {
    PRESETS.iter().map(|(name, _)| *name)
}

impl Recipe {
    /// Reads a text of at most 16,384 bytes. The seed of the world is 0, parameters have the values
    /// of the text. Errors have [places](Error::places), of which there may be several.
    pub fn new(text: &str) -> Result<Recipe, Error> {
        ready()?;
        // SAFETY: all zeros is a recipe, though none that calls take.
        let mut c = unsafe { crate::zeroed_box::<ffi::scarp_recipe>() };
        let mut errors = [ffi::scarp_recipe_error::default(); MOST_ERRORS];
        let mut found = 0;
        // SAFETY: all pointers are valid, for as many elements as they are said to have.
        let status = unsafe {
            let text_at = text.as_ptr().cast();
            let errors = errors.as_mut_ptr();
            ffi::scarp_recipe_parse(text_at, text.len(), &mut *c, errors, MOST_ERRORS, &mut found)
        };
        if status != ffi::SCARP_OK && found == 0 {
            let text = format!("a recipe has at most 16384 bytes, not {}", text.len());
            return Err(Error::new(Status::of(status), "text", text));
        }
        if status != ffi::SCARP_OK {
            let errors = &errors[..found.min(MOST_ERRORS)];
            return Err(Error::of_places(status, errors.iter().map(Place::of).collect()));
        }
        let (text, entries, plan) = (text.to_owned(), Vec::new(), Vec::new());
        let mut recipe = Recipe { c, plan, text, entries, dimensions: 2, seed: 0 };
        recipe.make_plan();
        recipe.entries = recipe.read_entries();
        recipe.dimensions = recipe.entry_at(0).map_or(2, |entry| entry.dimensions as usize);
        Ok(recipe)
    }

    /// A recipe of the program `scarp`. Coordinates, and most heights, are in metres.
    ///
    /// ```
    /// let alps = scarp::Recipe::preset("alps")?;
    /// assert_eq!(alps.outputs().collect::<Vec<_>>(), ["alps", "worn"]);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn preset(name: &str) -> Result<Recipe, Error> {
        match PRESETS.iter().find(|(each, _)| *each == name) {
            Some((_, text)) => Recipe::new(text),
            None => Err(Error::new(Status::Enum, format!("{:?}", name), "there is no such preset")),
        }
    }

    /// The constants of all noises, so that calls with few points are fast
    fn make_plan(&mut self) {
        // SAFETY: the pointer is valid.
        let bytes = unsafe { ffi::scarp_recipe_plan_size(&*self.c) };
        self.plan.resize(bytes / 8 + 1, 0);
        let to = self.plan.as_mut_ptr().cast();
        // SAFETY: both pointers are valid, and there is room for all bytes.
        if unsafe { ffi::scarp_recipe_plan_make(&*self.c, to, bytes) } != ffi::SCARP_OK {
            self.plan.fill(0); // no plan: calls with few points take longer
        }
    }

    fn entry_at(&self, index: usize) -> Option<ffi::scarp_recipe_entry> {
        let mut entry = ffi::scarp_recipe_entry::default();
        // SAFETY: both pointers are valid.
        let status = unsafe { ffi::scarp_recipe_entry_at(&*self.c, index, &mut entry) };
        (status == ffi::SCARP_OK).then_some(entry)
    }

    fn read_entries(&self) -> Vec<Entry> {
        let entries = (0..).map_while(|index| self.entry_at(index));
        entries
            .map(|entry| Entry {
                name: self
                    .text
                    .get(entry.name[0] as usize..entry.name[1] as usize)
                    .unwrap_or("")
                    .to_owned(),
                is_param: entry.is_param != 0,
                is_field: matches!(
                    entry.kind as u32,
                    ffi::SCARP_RECIPE_FIELD | ffi::SCARP_RECIPE_NOISE
                ),
                output: entry.output,
            })
            .collect()
    }

    /// The text
    pub fn text(&self) -> &str {
        &self.text
    }

    /// 2, or 3 if the text says `space 3`
    pub fn dimensions(&self) -> usize {
        self.dimensions
    }

    /// The names of the outputs, in the order of the text
    pub fn outputs(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().filter(|entry| entry.output >= 0).map(|entry| entry.name.as_str())
    }

    /// The parameters, in the order of the text
    ///
    /// ```
    /// let alps = scarp::Recipe::preset("alps")?;
    /// for param in alps.params() {
    ///     println!("{} = {} [{}, {}]", param.name, param.value, param.lowest, param.highest);
    /// }
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn params(&self) -> impl Iterator<Item = Param<'_>> {
        let entries = self.entries.iter().enumerate().filter(|(_, entry)| entry.is_param);
        entries.filter_map(move |(index, entry)| {
            let c = self.entry_at(index)?;
            let [lowest, highest] = c.slider;
            Some(Param { name: &entry.name, value: c.value, lowest, highest })
        })
    }

    /// The value of a parameter
    pub fn get(&self, name: &str) -> Option<f64> {
        let index = self.entries.iter().position(|each| each.is_param && each.name == name)?;
        self.entry_at(index).map(|entry| entry.value)
    }

    /// Sets a parameter, or `finest`: octaves whose cells are smaller than so many units are left
    /// out, 0 for none. The recipe is compiled again, which takes some microseconds. On an error
    /// the old value stays.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), Error> {
        let unknown =
            || Error::new(Status::Parameter, name.to_owned(), "there is no such parameter");
        let c_name = CString::new(name).map_err(|_| unknown())?;
        let mut error = ffi::scarp_recipe_error::default();
        // SAFETY: all pointers are valid, and the name ends with a 0.
        let status =
            unsafe { ffi::scarp_recipe_set(&mut *self.c, c_name.as_ptr(), value, &mut error) };
        if status == ffi::SCARP_OK {
            self.make_plan();
            return Ok(());
        }
        if !error.text.is_null() {
            return Err(Error::of_places(status, vec![Place::of(&error)]));
        }
        let param = self.params().find(|param| param.name == name);
        Err(match param {
            Some(param) => {
                let text = format!("{} is not in [{}, {}]", value, param.lowest, param.highest);
                Error::new(Status::of(status), name.to_owned(), text)
            }
            None if name == "finest" => Error::of(status, "finest"),
            None => unknown(),
        })
    }

    /// The seed of the world
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Sets the seed of the world, which all noises follow. A negative seed is 2^64 more:
    /// `set_seed(-1_i64 as u64)`.
    pub fn set_seed(&mut self, seed: u64) -> Result<(), Error> {
        // SAFETY: the pointer is valid.
        crate::error::check(unsafe { ffi::scarp_recipe_seed(&mut *self.c, seed) })?;
        self.make_plan();
        self.seed = seed;
        Ok(())
    }

    /// Makes the recipe repeat after so many units along x, y and z, in place of a tile in the text;
    /// with 0 for all it does not. The plane ignores the last. On an error the old tile stays.
    ///
    /// ```
    /// let mut recipe = scarp::Recipe::new("recipe 1\nout a = noise(size=50)")?;
    /// recipe.set_tile([200.0, 100.0, 0.0])?;
    /// assert_eq!(recipe.set_tile([210.0, 100.0, 0.0]).unwrap_err().places()[0].nearest, Some(52.5));
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn set_tile(&mut self, [x, y, z]: [f64; 3]) -> Result<(), Error> {
        let mut error = ffi::scarp_recipe_error::default();
        // SAFETY: both pointers are valid.
        let status = unsafe { ffi::scarp_recipe_tile(&mut *self.c, x, y, z, &mut error) };
        self.changed(status, &error, "tile")
    }

    /// Makes the recipe `by` times larger, as `scale(..., by)` does with each statement, and
    /// multiplies the first output by `heights`. On an error the old scale stays.
    ///
    /// ```
    /// let mut alps = scarp::Recipe::preset("alps")?;
    /// let (cells, top) = (alps.info("alps")?.largest_cell, alps.range("alps")?.1);
    /// alps.set_scale(2.0, 2.0)?; // a terrain with the same slopes
    /// assert_eq!(alps.info("alps")?.largest_cell, 2.0 * cells);
    /// assert!(alps.range("alps")?.1 > 1.99 * top);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn set_scale(&mut self, by: f64, heights: f64) -> Result<(), Error> {
        let mut error = ffi::scarp_recipe_error::default();
        // SAFETY: both pointers are valid.
        let status = unsafe { ffi::scarp_recipe_scale(&mut *self.c, by, heights, &mut error) };
        self.changed(status, &error, "scale")
    }

    /// The result of a call that changes the recipe, and its plan if there is no error
    fn changed(
        &mut self,
        status: ffi::scarp_status,
        error: &ffi::scarp_recipe_error,
        at_fault: &'static str,
    ) -> Result<(), Error> {
        match status {
            ffi::SCARP_OK => {
                self.make_plan();
                Ok(())
            }
            _ if !error.text.is_null() => Err(Error::of_places(status, vec![Place::of(error)])),
            _ => Err(Error::of(status, at_fault)),
        }
    }

    /// What an output is made of, or another field of the text
    pub fn info(&self, name: &str) -> Result<Info, Error> {
        let entry = self.entry_at(self.which(name)? as usize).unwrap_or_default();
        Ok(Info {
            largest_cell: entry.cell[0],
            smallest_cell: entry.cell[1],
            jumps: entry.jumps != 0,
            axes: [1, 2, 4].map(|axis| entry.axes & axis != 0),
            order: entry.order,
        })
    }

    /// The number of a statement that is a field
    fn which(&self, name: &str) -> Result<i32, Error> {
        let at = self.entries.iter().position(|each| each.is_field && each.name == name);
        at.map(|index| index as i32).ok_or_else(|| {
            Error::new(Status::Parameter, name.to_owned(), "there is no such output or field")
        })
    }

    /// The interval (lowest, highest) that values of an output, or of another field, never leave.
    /// It may be wider than need be, and is infinite where coordinates themselves count.
    pub fn range(&self, name: &str) -> Result<(f32, f32), Error> {
        self.range_of(name, std::ptr::null())
    }

    /// The same within a box, given by its lowest and its highest corner. In the plane elements 2
    /// change nothing.
    ///
    /// ```
    /// let slope = scarp::Recipe::new("recipe 1\nout a = 2 * x + y")?;
    /// assert_eq!(slope.range("a")?.1, f32::INFINITY);
    /// let (lowest, highest) = slope.range_in("a", [0.0; 3], [1.0, 3.0, 0.0])?;
    /// assert!(-0.001 < lowest && lowest <= 0.0 && 5.0 <= highest && highest < 5.001);
    /// # Ok::<(), scarp::Error>(())
    /// ```
    pub fn range_in(
        &self,
        name: &str,
        lowest: [f64; 3],
        highest: [f64; 3],
    ) -> Result<(f32, f32), Error> {
        self.range_of(name, &ffi::scarp_box { lowest, highest })
    }

    fn range_of(&self, name: &str, within: *const ffi::scarp_box) -> Result<(f32, f32), Error> {
        let which = self.which(name)?;
        let (mut lowest, mut highest) = (0.0, 0.0);
        // SAFETY: all pointers are valid, or NULL where that is allowed.
        let status =
            unsafe { ffi::scarp_recipe_range(&*self.c, which, within, &mut lowest, &mut highest) };
        match status {
            ffi::SCARP_OK => Ok((lowest, highest)),
            _ if within.is_null() => Err(Error::of(status, name.to_owned())),
            _ => Err(Error::new(Status::of(status), "box", "its ends are NaN or out of order")),
        }
    }

    /// For the calls of [`ffi`] that describe recipes to editors. It is valid as
    /// long as the recipe is neither changed nor moved away.
    pub fn as_ptr(&self) -> *const ffi::scarp_recipe {
        &*self.c
    }
}
