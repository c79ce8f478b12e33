// SPDX-License-Identifier: MIT
//! Calls that hashes.rs does not compare do what they are called.
use scarp::*;

type Result<T = ()> = std::result::Result<T, Error>;
const COUNT: usize = 64;

/// Coordinates that are exact in floats
fn axis(step: usize) -> Vec<f64> {
    (0..COUNT).map(|i| (i * step % 61) as f64 / 16.0 - 1.5).collect()
}

fn floats(axis: &[f64]) -> Vec<f32> {
    axis.iter().map(|x| *x as f32).collect()
}

/// Equal but for rounding, and not all the same
#[track_caller]
fn near(a: &[f32], b: &[f32]) {
    assert_eq!(a.len(), b.len());
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-4), "{:?} {:?}", a, b);
    assert!(a.iter().any(|x| *x != a[0]));
}

fn value(slice: &mut [f32]) -> Option<&mut [f32]> {
    Some(slice)
}

/// Doubles give what floats give, where these are exact, of every call.
#[test]
fn floats_and_doubles() -> Result {
    let (d, noise) = ([axis(7), axis(11), axis(17)], Noise { octaves: 2.0, ..Noise::default() });
    let f = [floats(&d[0]), floats(&d[1]), floats(&d[2])];
    let new = || Arrays::space(COUNT, 0);
    let (mut u, mut v, mut w) = (new(), new(), new());
    let (mut p, mut q, mut r) = (new(), new(), new());
    noise.vector2(&f[0], &f[1], &mut [u.samples(), v.samples()])?;
    noise.vector2(&d[0], &d[1], &mut [p.samples(), q.samples()])?;
    near(&u.value, &p.value);
    near(&v.value, &q.value);
    assert_ne!(u, v);
    noise.vector3(&f[0], &f[1], &f[2], &mut [u.samples(), v.samples(), w.samples()])?;
    noise.vector3(&d[0], &d[1], &d[2], &mut [p.samples(), q.samples(), r.samples()])?;
    for (a, b) in [(&u, &p), (&v, &q), (&w, &r)] {
        near(&a.value, &b.value);
    }
    assert!(u != v && v != w && w != u);

    // F1 is what the basis is made of, and its gradient a unit vector.
    let (mut f1, mut dx, mut dy, mut dz) =
        (vec![0.0; COUNT], vec![0.0; COUNT], vec![0.0; COUNT], vec![0.0; COUNT]);
    let mut again = vec![0.0; COUNT];
    let mut out =
        Cells { f1: value(&mut f1), dx1: value(&mut dx), dy1: value(&mut dy), ..Cells::default() };
    noise.cells2(&f[0], &f[1], &mut out)?;
    noise.cells2(&d[0], &d[1], &mut Cells { f1: value(&mut again), ..Cells::default() })?;
    near(&f1, &again);
    assert!(dx.iter().zip(&dy).all(|(x, y)| (x * x + y * y - 1.0).abs() < 1e-5));
    let mut out = Cells {
        f1: value(&mut f1),
        dx1: value(&mut dx),
        dy1: value(&mut dy),
        dz1: value(&mut dz),
        ..Cells::default()
    };
    noise.cells3(&f[0], &f[1], &f[2], &mut out)?;
    noise.cells3(&d[0], &d[1], &d[2], &mut Cells { f1: value(&mut again), ..Cells::default() })?;
    near(&f1, &again);
    assert!((0..COUNT).all(|i| (dx[i].powi(2) + dy[i].powi(2) + dz[i].powi(2) - 1.0).abs() < 1e-5));
    Ok(())
}

/// A velocity is the gradient, turned by a quarter.
#[test]
fn curl() -> Result {
    let (x, y, noise) = (axis(7), axis(11), Noise { octaves: 3.0, ..Noise::default() });
    let mut gradient = Arrays::plane(COUNT, 1);
    noise.sample2(&x, &y, &mut gradient.samples())?;
    let (mut vx, mut vy, mut vz) = (vec![0.0; COUNT], vec![0.0; COUNT], vec![0.0; COUNT]);
    let mut out = Flow { vx: value(&mut vx), vy: value(&mut vy), ..Flow::default() };
    noise.curl2(&x, &y, &mut out)?;
    assert_eq!(vx, gradient.dy);
    assert!(vy.iter().zip(&gradient.dx).all(|(v, dx)| *v == -dx));
    noise.curl2(&floats(&x), &floats(&y), &mut Flow { vx: value(&mut vx), ..Flow::default() })?;
    near(&vx, &gradient.dy);
    let mut of = |z: &dyn Fn(&mut Flow<'_>) -> Result| {
        z(&mut Flow { vz: value(&mut vz), ..Flow::default() }).map(|_| vz.clone())
    };
    let a = of(&|out| noise.curl3(&x, &y, &x, out))?;
    let b = of(&|out| noise.curl3(&floats(&x), &floats(&y), &floats(&x), out))?;
    near(&a, &b);
    Ok(())
}

#[test]
fn gullies_and_recipes() -> Result {
    let (x, y) = (axis(7), axis(11));
    let mut base = Arrays::plane(COUNT, 1);
    Noise::default().sample2(&x, &y, &mut base.samples())?;
    let (mut a, mut b) = (vec![0.0; COUNT], vec![0.0; COUNT]);
    let gullies = Gullies::default();
    gullies.sample2(
        &x,
        &y,
        &base.view(),
        &mut Eroded { value: value(&mut a), ..Eroded::default() },
    )?;
    let mut out = Eroded { value: value(&mut b), ..Eroded::default() };
    gullies.sample2(&floats(&x), &floats(&y), &base.view(), &mut out)?;
    assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-2));
    assert_ne!(a, base.value);

    let recipe = Recipe::new("recipe 1\nspace 3\nout a = noise(size=2) + z")?;
    let scratch = &mut Scratch::new();
    fn of(slice: &mut [f32]) -> Samples<'_> {
        Samples { value: value(slice), ..Samples::default() }
    }
    recipe.sample3(&x, &y, &x, &mut [("a", of(&mut a))], scratch)?;
    recipe.sample3(&floats(&x), &floats(&y), &floats(&x), &mut [("a", of(&mut b))], scratch)?;
    near(&a, &b);
    let grid = Grid::<3> { count: [4, 4, 4], step: [0.25; 3], ..Grid::default() };
    recipe.grid3(&grid, &mut [("a", of(&mut a))], scratch)?;
    let at = |i: usize, j: usize, k: usize| grid.position([i, j, k]);
    let points: Vec<_> = (0..64).map(|n| at(n % 4, n / 4 % 4, n / 16)).collect();
    let [x, y, z] = [0, 1, 2].map(|d| points.iter().map(|p| p[d]).collect::<Vec<f64>>());
    recipe.sample3(&x, &y, &z, &mut [("a", of(&mut b))], scratch)?;
    assert_eq!(a, b);

    let mut recipe = Recipe::new("recipe 1\nspace 3\nout a = noise(size=2)")?;
    let text = "recipe 1\nspace 3\ntile 8, 12, 4\nout a = 5 * scale(noise(size=2), 2)";
    recipe.set_scale(2.0, 5.0)?;
    recipe.set_tile([8.0, 12.0, 4.0])?;
    recipe.grid3(&grid, &mut [("a", of(&mut a))], scratch)?;
    Recipe::new(text)?.grid3(&grid, &mut [("a", of(&mut b))], scratch)?;
    assert_eq!(a, b);
    let info = recipe.info("a")?;
    assert_eq!((info.largest_cell, info.smallest_cell, info.order), (4.0, 4.0, 2));
    assert!(info.axes == [true; 3] && !info.jumps);
    assert!(Recipe::new("recipe 1\nout a = cell(noise())")?.info("a")?.jumps);
    Ok(())
}

/// A field that is no output may need more memory than the outputs do.
#[test]
fn a_field_of_many_parts() -> Result {
    // All noises are held until their sum is there.
    let names: Vec<_> = (1..24).map(|i| format!("n{}", i)).collect();
    let noises: String =
        names.iter().map(|n| format!("{} = noise(size=3, seed={})\n", n, &n[1..])).collect();
    let parts: Vec<_> = names.iter().map(|n| format!("{} * sum", n)).collect();
    let (sum, many) = (names.join(" + "), parts.join(" + "));
    let text = format!("recipe 1\n{}sum = {}\nmany = {}\nout a = x", noises, sum, many);
    let (recipe, mut out) = (Recipe::new(&text)?, Arrays::plane(COUNT, 2));
    let (x, y) = (axis(7), axis(11));
    recipe.sample2(&x, &y, &mut [("many", out.samples())], &mut Scratch::new())?;
    assert!(out.value.iter().any(|x| *x != 0.0));
    Ok(())
}

/// Threads share a recipe, for large calls and for single points.
#[test]
fn a_recipe_in_threads() -> Result {
    const MANY: usize = 5000;
    let recipe = Recipe::preset("alps")?;
    let x: Vec<f64> = (0..MANY).map(|i| i as f64 * 7.0).collect();
    let mut expected = Arrays::plane(MANY, 1);
    recipe.sample2(&x, &x, &mut [("alps", expected.samples())], &mut Scratch::new())?;
    std::thread::scope(|scope| {
        for thread in 0..4 {
            let (recipe, x, expected) = (&recipe, &x, &expected);
            scope.spawn(move || {
                let (mut scratch, mut out) = (Scratch::new(), Arrays::plane(MANY, 1));
                let mut point = Arrays::plane(1, 1);
                for i in (0..MANY).skip(thread).step_by(100) {
                    recipe.sample2(x, x, &mut [("alps", out.samples())], &mut scratch).unwrap();
                    assert!(out == *expected);
                    let at = &x[i..i + 1];
                    recipe.sample2(at, at, &mut [("alps", point.samples())], &mut scratch).unwrap();
                    assert_eq!((point.value[0], point.dx[0]), (out.value[i], out.dx[i]));
                }
            });
        }
    });
    Ok(())
}

/// A clone is a recipe of its own.
#[test]
fn a_clone_of_a_recipe() -> Result {
    let recipe = Recipe::preset("alps")?;
    let height = recipe.get("height").unwrap();
    let mut other = recipe.clone();
    other.set("height", 2.0 * height)?;
    other.set_seed(8)?;
    assert_eq!((recipe.get("height"), recipe.seed()), (Some(height), 0));
    let of = |recipe: &Recipe| -> Result<Arrays> {
        let mut out = Arrays::plane(COUNT, 0);
        recipe.sample2(&axis(7), &axis(11), &mut [("alps", out.samples())], &mut Scratch::new())?;
        Ok(out)
    };
    assert!(of(&recipe)? == of(&Recipe::preset("alps")?)? && of(&recipe)? != of(&other)?);
    Ok(())
}

/// Functions that take or give other members than most
#[test]
fn functions() {
    let mut slope = [0.0];
    let steep = View { dx: Some(&[3.0]), dy: Some(&[4.0]), ..View::default() };
    chain::slope(&steep, &mut Samples { value: Some(&mut slope), ..Samples::default() }).unwrap();
    assert_eq!(slope, [5.0]);
    let (a, sum) = (View { value: Some(&[0.75]), ..View::default() }, &[7.0]);
    let sum = Partials { f: Some(sum), ..Partials::default() };
    chain::apply2(&a, &a, &sum, &mut Samples { value: Some(&mut slope), ..Samples::default() })
        .unwrap();
    assert_eq!(slope, [7.0]);
}

/// Rows and slices of a grid lie as far apart as it says.
#[test]
fn strides() -> Result {
    let (noise, dense) = (
        Noise { seed: 3, ..Noise::default() },
        Grid::<3> { step: [0.3; 3], count: [3, 2, 2], ..Grid::default() },
    );
    let (mut a, mut b) = (Arrays::space(12, 1), Arrays::space(28, 1));
    assert!(a.dz.len() == 12 && a.dzz.is_empty() && Arrays::space(2, 2).dzz.len() == 2);
    noise.grid3(&dense, &mut a.samples())?;
    let loose = Grid { row_stride: 5, slice_stride: 20, ..dense };
    assert_eq!(loose.len(), Some(28));
    noise.grid3(&loose, &mut b.samples())?;
    for i in 0..12 {
        let at = i / 6 * 20 + i / 3 % 2 * 5 + i % 3;
        assert_eq!((a.value[i], a.dz[i]), (b.value[at], b.dz[at]));
    }
    Ok(())
}

/// Any of the members tells how many samples there are.
#[test]
fn views_of_one_member() {
    macro_rules! each {
        ($($member:ident)*) => {$(
            let mut one = Arrays { $member: vec![2.0; 3], ..Arrays::default() };
            one.samples().affine(3.0, 1.0).unwrap();
            let expected = if stringify!($member) == "value" { 7.0 } else { 6.0 };
            assert_eq!(one.$member, [expected; 3], stringify!($member));
        )*};
    }
    each!(value dx dy dz dxx dxy dxz dyy dyz dzz dphase);
}

#[test]
fn shaders() -> Result {
    let noise = Noise { octaves: 3.0, ..Noise::default() };
    let (plan, vector) = (GpuPlan::new(&noise, 2)?, GpuPlan::of_vector(&noise, 2)?);
    assert_ne!(plan.as_bytes(), vector.as_bytes());
    assert_ne!(noise.gpu_answers(2, 0)?, noise.gpu_answers(2, 1)?);
    assert_ne!(noise.gpu_answers(2, 0)?, noise.gpu_answers(3, 0)?);
    let mut hills = Recipe::preset("hills")?;
    let (uniforms, answers) = (hills.uniforms()?, hills.answers(0)?);
    hills.set_seed(3)?;
    assert_eq!(hills.seed(), 3);
    assert_ne!(hills.uniforms()?, uniforms);
    assert_ne!(hills.answers(0)?, answers);
    hills.set_seed(-1_i64 as u64)?; // negative seeds are 2^64 more, from i32, too
    assert_eq!(hills.seed(), u64::MAX);
    assert_eq!(Noise { seed: -7_i32 as u64, ..noise }.seed, u64::MAX - 6);
    let long = "recipe 1\nout a = noise(octaves=32) + noise(seed=2, octaves=32)";
    let uniforms = Recipe::new(long)?.uniforms()?; // in more room than the first try has
    assert!(uniforms.len() > 64 * 160 && uniforms.len() % 16 == 0);
    assert!(uniforms[uniforms.len() - 160..].iter().any(|byte| *byte != 0));
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../include/scarp.glsl");
    if let Ok(file) = std::fs::read_to_string(file) {
        let text = hills.shader(Language::Glsl, 1, &file)?;
        assert!(text.contains("scarp_recipe_hills(") && !text.contains('\0'));
        assert!(hills.shader(Language::Wgsl, 1, &file).is_err());
    }
    Ok(())
}
