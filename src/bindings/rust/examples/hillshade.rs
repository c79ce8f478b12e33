// SPDX-License-Identifier: MIT
//! A shaded map of the preset alps, whose bands of rows threads compute. It writes hillshade.pgm.
//!
//!     cargo run --release --example hillshade [width height threads]
use scarp::{Arrays, Error, Grid, Recipe, Samples, Scratch};
use std::{env, fs, thread};

const METRES: f64 = 20.0; // between samples

/// Light from the north-west, of the exact gradient: no neighbours are needed, so maps of tiles
/// have no seams.
fn shade(dx: f32, dy: f32) -> u8 {
    let light = (1.0 + dx - dy) / (3.0 * (1.0 + dx * dx + dy * dy)).sqrt();
    (255.0 * light.clamp(0.0, 1.0)) as u8
}

fn draw(recipe: &Recipe, width: usize, height: usize, threads: usize) -> Result<Vec<u8>, Error> {
    let grid = Grid { step: [METRES; 2], count: [width, height], ..Grid::<2>::default() };
    let mut map = Arrays::plane(width * height, 1);
    let mut out = Samples { value: None, ..map.samples() };
    let rows = (height + threads - 1) / threads;
    thread::scope(|scope| {
        let bands = grid.bands(&mut out, rows)?.map(|(band, out)| {
            let draw = move || recipe.grid2(&band, &mut [("alps", out)], &mut Scratch::new());
            scope.spawn(draw)
        });
        let running: Vec<_> = bands.collect(); // all of them are started
        running.into_iter().try_for_each(|thread| thread.join().expect("a thread panicked"))
    })?;
    // Row 0 of a picture is the north.
    let rows = map.dx.chunks(width).zip(map.dy.chunks(width)).rev();
    Ok(rows.flat_map(|(dx, dy)| dx.iter().zip(dy).map(|(dx, dy)| shade(*dx, *dy))).collect())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut numbers = env::args().skip(1).map(|argument| argument.parse());
    let mut next = |otherwise| numbers.next().unwrap_or(Ok(otherwise));
    let (width, height, threads) = (next(800)?, next(600)?, next(2)?.max(1));

    let mut recipe = Recipe::preset("alps")?;
    recipe.set_seed(8)?;
    let picture = draw(&recipe, width, height, threads)?;
    let mut file = format!("P5\n{} {}\n255\n", width, height).into_bytes();
    file.extend(picture);
    fs::write("hillshade.pgm", file)?;
    Ok(())
}
