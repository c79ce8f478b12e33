// SPDX-License-Identifier: MIT
//! How long calls of the crate take beside the same calls of C, whose structures are filled in once:
//! the fastest of interleaved repeats, in nanoseconds, and their ratio.
//!
//!     cargo run --release --example overhead [repeats]
use scarp::{ffi, Grid, Noise, Plan, Recipe, Samples, Scratch};
use std::time::Instant;

/// The least time that two functions take, per call
fn fastest(repeats: usize, calls: usize, mut a: impl FnMut(), mut b: impl FnMut()) -> [f64; 2] {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..repeats {
        for (least, function) in least.iter_mut().zip([&mut a as &mut dyn FnMut(), &mut b]) {
            let start = Instant::now();
            (0..calls).for_each(|_| function());
            *least = least.min(start.elapsed().as_secs_f64() * 1e9 / calls as f64);
        }
    }
    least
}

fn tell(what: &str, [crate_, c]: [f64; 2]) {
    println!("{:36} {:>12.1} {:>12.1} {:>8.3}", what, crate_, c, crate_ / c);
}

fn points(what: &str, repeats: usize, noise: &Noise<'_>, count: usize, calls: usize) {
    let x: Vec<f32> = (0..count).map(|i| (i * 7919 % 65536) as f32 / 64.0).collect();
    let y: Vec<f32> = (0..count).map(|i| (i * 104729 % 65536) as f32 / 64.0).collect();
    let (mut value, mut other) = (vec![0.0; count], vec![0.0; count]);
    let c = ffi::scarp_samples { value: other.as_mut_ptr(), ..Default::default() };
    let of_c: *const ffi::scarp_noise = (noise as *const Noise<'_>).cast();
    let times = fastest(
        repeats,
        calls,
        || {
            let mut out = Samples { value: Some(&mut value), ..Samples::default() };
            noise.sample2(&x, &y, &mut out).unwrap();
        },
        // SAFETY: the layout of a noise is that of C; all slices have so many elements.
        || unsafe {
            assert_eq!(ffi::scarp_sample2(of_c, count, x.as_ptr(), y.as_ptr(), &c), ffi::SCARP_OK)
        },
    );
    tell(what, times);
    assert_eq!(value, other);
}

fn grid(repeats: usize, noise: &Noise<'_>) {
    let grid = Grid::<2> { step: [0.01; 2], count: [1024, 1024], ..Grid::default() };
    let (mut value, mut other) = (vec![0.0; 1 << 20], vec![0.0; 1 << 20]);
    let out = ffi::scarp_samples { value: other.as_mut_ptr(), ..Default::default() };
    let mut c = ffi::scarp_grid::default();
    (c.step, c.count) = ([0.01, 0.01, 0.0], [1024, 1024, 0]);
    let of_c: *const ffi::scarp_noise = (noise as *const Noise<'_>).cast();
    let times = fastest(
        repeats,
        1,
        || {
            let mut out = Samples { value: Some(&mut value), ..Samples::default() };
            noise.grid2(&grid, &mut out).unwrap();
        },
        // SAFETY: the layout of a noise is that of C; the slice has 1024 x 1024 elements.
        || unsafe { assert_eq!(ffi::scarp_grid2(of_c, &c, &out), ffi::SCARP_OK) },
    );
    tell("a grid of 1024 x 1024", times);
    assert_eq!(value, other);
}

fn recipe(repeats: usize) -> Result<(), scarp::Error> {
    let alps = Recipe::preset("alps")?;
    let (x, y, mut value, mut other) = ([100.0f32], [50.0f32], [0.0f32], [0.0f32]);
    let mut scratch = Scratch::new();
    let out = ffi::scarp_samples { value: other.as_mut_ptr(), ..Default::default() };
    let outputs = ffi::scarp_recipe_outputs { out: &out, count: 1, ..Default::default() };
    let (mut memory, mut plan) = (vec![0u64; 8192], vec![0u64; 8192]);
    let (at, size) = (memory.as_mut_ptr().cast(), 8 * memory.len());
    let (plan_at, plan_size) = (plan.as_mut_ptr().cast(), 8 * plan.len());
    // SAFETY: the recipe is valid, and there is room for so many bytes.
    let status = unsafe { ffi::scarp_recipe_plan_make(alps.as_ptr(), plan_at, plan_size) };
    assert_eq!(status, ffi::SCARP_OK);
    let room = ffi::scarp_scratch { memory: at, size, plan: plan_at, ..Default::default() };
    let times = fastest(
        repeats,
        100,
        || {
            let out = Samples { value: Some(&mut value), ..Samples::default() };
            alps.sample2(&x, &y, &mut [("alps", out)], &mut scratch).unwrap();
        },
        || unsafe {
            // SAFETY: all slices have one element.
            let (x, y, z) = (x.as_ptr(), y.as_ptr(), std::ptr::null());
            let status = ffi::scarp_recipe_sample(alps.as_ptr(), 1, x, y, z, &outputs, &room);
            assert_eq!(status, ffi::SCARP_OK)
        },
    );
    tell("1 point of the preset alps", times);
    assert_eq!(value, other);
    Ok(())
}

fn main() -> Result<(), scarp::Error> {
    let repeats = std::env::args().nth(1).map_or(99, |n| n.parse().expect("repeats: a number"));
    println!("{:36} {:>12} {:>12} {:>8}", "nanoseconds per call", "crate", "C", "ratio");
    let noise = Noise::default();
    let plan = Plan::new(&noise, 2)?;
    let kept = Noise { plan: Some(&plan), ..noise };
    points("1 point, with a plan", repeats, &kept, 1, 2_000);
    points("1 point", repeats, &noise, 1, 1_000);
    points("4096 points", repeats, &noise, 4096, 20);
    grid(repeats, &Noise { octaves: 8.0, ..noise });
    recipe(repeats)
}
