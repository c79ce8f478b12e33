// SPDX-License-Identifier: MIT
//! The crate gives the bits of C: tests/bindings/hashes.c of scarp makes the same calls, and prints
//! hashes of the outputs. SCARP_HASHES in the environment names that program; without it nothing is
//! compared, but everything is called.
use scarp::*;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

mod functions;

const COUNT: usize = 1031;
const ROWS: usize = 37;
const COLUMNS: usize = 53;
type Result<T = ()> = std::result::Result<T, Error>;

/// What C gives, by the name of the case
fn golden() -> BTreeMap<String, String> {
    let program = match std::env::var_os("SCARP_HASHES") {
        Some(program) => program,
        None => return BTreeMap::new(),
    };
    let places = ["presets/alps.recipe", "../../cli/presets/alps.recipe"];
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let recipe = places.iter().map(|place| here.join(place)).find(|path| path.is_file());
    let told = Command::new(program).arg(recipe.unwrap()).output().unwrap();
    assert!(told.status.success());
    let lines = String::from_utf8(told.stdout).unwrap();
    lines
        .lines()
        .filter_map(|line| line.split_once(' '))
        .map(|(name, hash)| (name.into(), hash.into()))
        .collect()
}

struct Told(BTreeMap<String, String>);

impl Told {
    fn same(&mut self, name: &str, arrays: &[&[f32]]) {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for byte in arrays.iter().flat_map(|array| array.iter()).flat_map(|x| x.to_ne_bytes()) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
        if std::env::var_os("SCARP_HASHES").is_some() {
            assert_eq!(self.0.remove(name), Some(format!("{:016x}", hash)), "{}", name);
        }
    }
}

/// The members of the plane, in the order of the structure
fn hessian2(of: &Arrays) -> [&[f32]; 6] {
    [&of.value, &of.dx, &of.dy, &of.dxx, &of.dxy, &of.dyy]
}

fn gradient2(of: &Arrays) -> [&[f32]; 3] {
    [&of.value, &of.dx, &of.dy]
}

/// Coordinates that are exact in floats
fn axis(axis: usize) -> Vec<f64> {
    (0..COUNT).map(|i| ((i * (7 + 4 * axis)) % 1024) as f64 * 0.375 - 100.0 * axis as f64).collect()
}

fn floats(axis: &[f64]) -> Vec<f32> {
    axis.iter().map(|x| *x as f32).collect()
}

const WARP: Noise<'static> = Noise {
    basis: Basis::Simplex,
    seed: 7,
    frequency: 0.02,
    octaves: 2.0,
    amplitude: 15.0,
    ..Noise::DEFAULT
};
const WARPED: Noise<'static> = Noise {
    fractal: Fractal::Ridged,
    rotate: true,
    seed: 0xfedc_ba98_7654_3210,
    frequency: 0.01,
    octaves: 6.0,
    warp: Some(&WARP),
    ..Noise::DEFAULT
};
const FLOWING: Noise<'static> =
    Noise { seed: 5, octaves: 3.0, phase: 0.3, offset_first: true, ..Noise::DEFAULT };

fn grid() -> Grid<2> {
    Grid {
        origin: [-3.0, 5.0],
        step: [0.5, -0.25],
        first: [-20, 7],
        count: [COLUMNS, ROWS],
        ..Grid::default()
    }
}

#[test]
fn hashes() -> Result {
    let mut told = Told(golden());
    points(&mut told)?;
    others(&mut told)?;
    grids(&mut told)?;
    chain_rule(&mut told)?;
    recipes(&mut told)?;
    functions_apart_and_in_place(&mut told)?;
    assert!(told.0.is_empty(), "not compared: {:?}", told.0);
    Ok(())
}

fn points(told: &mut Told) -> Result {
    let d = [axis(0), axis(1), axis(2)];
    let f = [floats(&d[0]), floats(&d[1]), floats(&d[2])];
    let mut out = Arrays::plane(COUNT, 2);
    WARPED.sample2(&f[0], &f[1], &mut out.samples())?;
    told.same("sample2", &hessian2(&out));
    WARPED.sample2(&d[0], &d[1], &mut out.samples())?;
    told.same("sample2_f64", &hessian2(&out));

    let mut out = Arrays::space(COUNT, 2);
    out.dphase = vec![0.0; COUNT];
    for name in ["sample3", "sample3_f64"] {
        match name {
            "sample3" => FLOWING.sample3(&f[0], &f[1], &f[2], &mut out.samples())?,
            _ => FLOWING.sample3(&d[0], &d[1], &d[2], &mut out.samples())?,
        }
        let o = &out;
        told.same(
            name,
            &[
                &o.value, &o.dx, &o.dy, &o.dz, &o.dxx, &o.dxy, &o.dxz, &o.dyy, &o.dyz, &o.dzz,
                &o.dphase,
            ],
        );
    }
    Ok(())
}

fn others(told: &mut Told) -> Result {
    let d = [axis(0), axis(1), axis(2)];
    let f = [floats(&d[0]), floats(&d[1]), floats(&d[2])];
    let (mut u, mut v) = (Arrays::plane(COUNT, 2), Arrays::plane(COUNT, 2));
    WARP.vector2(&f[0], &f[1], &mut [u.samples(), v.samples()])?;
    told.same("vector2", &[hessian2(&u), hessian2(&v)].concat());

    let mut o: Vec<_> = (0..8).map(|_| vec![0.0f32; COUNT]).collect();
    let mut id = vec![0; COUNT];
    let [f1, f2, x, y, dx1, dy1, dx2, dy2] = eight(&mut o);
    let mut out = Cells {
        id: Some(&mut id),
        z: None,
        dz1: None,
        dz2: None,
        ..Cells { f1, f2, x, y, dx1, dy1, dx2, dy2, ..Cells::default() }
    };
    let worley = Noise { basis: Basis::CellF1, seed: 9, jitter: 0.75, ..Noise::DEFAULT };
    worley.cells2(&d[0], &d[1], &mut out)?;
    let id: Vec<_> = id.iter().map(|id| f32::from_bits(*id)).collect();
    let mut arrays: Vec<&[f32]> = o.iter().map(|array| &array[..]).collect();
    arrays.insert(2, &id);
    told.same("cells2_f64", &arrays);

    let [vx, vy, vz, ..] = eight(&mut o);
    FLOWING.curl3(&f[0], &f[1], &f[2], &mut Flow { vx, vy, vz, ..Flow::default() })?;
    told.same("curl3", &[&o[0], &o[1], &o[2]]);
    Ok(())
}

fn eight(arrays: &mut [Vec<f32>]) -> [Option<&mut [f32]>; 8] {
    let mut each = arrays.iter_mut().map(|array| &mut array[..]);
    [(); 8].map(|_| each.next())
}

fn grids(told: &mut Told) -> Result {
    let mut out = Arrays::plane(ROWS * COLUMNS, 2);
    WARPED.grid2(&grid(), &mut out.samples())?;
    told.same("grid2", &hessian2(&out));

    // The same in threads, and by rows
    let mut banded = Arrays::plane(ROWS * COLUMNS, 2);
    let mut samples = banded.samples();
    let bands = grid().bands(&mut samples, 10)?;
    assert_eq!(bands.len(), 4);
    std::thread::scope(|scope| {
        for (band, mut out) in bands {
            scope.spawn(move || WARPED.grid2(&band, &mut out).unwrap());
        }
    });
    assert!(banded == out);
    let mut rows = Arrays::plane(ROWS * COLUMNS, 2);
    for (row, mut out) in grid().rows(&mut rows.samples())? {
        WARPED.grid2(&row, &mut out)?;
    }
    assert!(rows == out);

    let tile = Noise {
        basis: Basis::Value,
        fade: Fade::Cubic,
        fractal: Fractal::Pingpong,
        seed: 3,
        frequency: 0.25,
        octaves: 2.5,
        gain: 0.4,
        sharpness: 1.5,
        period: [8, 16, 4],
        of_octaves: 4.0,
        ..Noise::DEFAULT
    };
    let voxels = Grid {
        origin: [1.0, 2.0, 3.0],
        step: [0.125, 0.25, 0.5],
        first: [1, -2, 3],
        count: [11, 13, 7],
        ..Grid::default()
    };
    let mut out = Arrays::space(11 * 13 * 7, 1);
    tile.grid3(&voxels, &mut out.samples())?;
    told.same("grid3", &[&out.value, &out.dx, &out.dy, &out.dz]);
    let mut sliced = Arrays::space(11 * 13 * 7, 1);
    for (slices, mut out) in voxels.bands(&mut sliced.samples(), 3)? {
        tile.grid3(&slices, &mut out)?;
    }
    assert!(sliced == out);
    Ok(())
}

fn chain_rule(told: &mut Told) -> Result {
    const SIZE: usize = ROWS * COLUMNS;
    let base = Noise { seed: 4, frequency: 0.02, octaves: 2.0, ..Noise::DEFAULT };
    let gullies =
        Gullies { seed: 4, frequency: 0.02, depth: 0.3, offset_first: true, ..Gullies::default() };
    let mut a = Arrays::plane(SIZE, 2);
    base.grid2(&grid(), &mut a.samples())?;
    let mut o: Vec<_> = (0..8).map(|_| vec![0.0f32; SIZE]).collect();
    let [value, dx, dy, displacement, displacement_dx, displacement_dy, ..] = eight(&mut o);
    let mut out = Eroded { value, dx, dy, displacement, displacement_dx, displacement_dy };
    gullies.grid2(&grid(), &a.view(), &mut out)?;
    told.same("gullies_grid2", &[&o[0], &o[1], &o[2], &o[3], &o[4], &o[5]]);

    let mut b = Arrays::plane(SIZE, 2);
    WARPED.grid2(&grid(), &mut b.samples())?;
    let mut apart = Arrays::plane(SIZE, 2);
    chain::smooth_max(&a.view(), &b.view(), 0.25, &mut apart.samples())?;
    a.samples().smooth_max(&b.view(), 0.25)?; // in place
    assert!(a == apart);
    a.samples().multiply(&b.view())?;
    a.samples().affine(3.0, -1.0)?;
    told.same("chain", &hessian2(&a));

    let [nx, ny, nz, ..] = eight(&mut o);
    normals(&b.dx, &b.dy, 20.0, [nx.unwrap(), ny.unwrap(), nz.unwrap()])?;
    told.same("normals", &[&o[0], &o[1], &o[2]]);
    Ok(())
}

fn functions_apart_and_in_place(told: &mut Told) -> Result {
    let (x, y) = (floats(&axis(0)), floats(&axis(1)));
    let (mut a, mut b) = (Arrays::plane(COUNT, 2), Arrays::plane(COUNT, 2));
    WARP.sample2(&x, &y, &mut a.samples())?;
    WARPED.sample2(&x, &y, &mut b.samples())?;
    for (name, apart, in_place) in functions::FUNCTIONS {
        let (mut out, mut changed) = (Arrays::plane(COUNT, 2), a.clone());
        apart(&a.view(), &b.view(), &mut out.samples())?;
        told.same(name, &hessian2(&out));
        in_place(&mut changed.samples(), &a.view(), &b.view())?;
        assert!(changed == out, "{} in place", name);
    }
    Ok(())
}

fn recipes(told: &mut Told) -> Result {
    let mut recipe = Recipe::preset("alps")?;
    recipe.set_seed(8)?;
    recipe.set("height", 900.0)?;
    let mut scratch = Scratch::new();
    let (mut alps, mut worn) = (Arrays::plane(ROWS * COLUMNS, 1), Arrays::plane(ROWS * COLUMNS, 1));
    let outputs = &mut [("alps", alps.samples()), ("worn", worn.samples())];
    recipe.grid2(&grid(), outputs, &mut scratch)?;
    told.same("recipe_grid", &[gradient2(&alps), gradient2(&worn)].concat());

    let (x, y) = (floats(&axis(0)), floats(&axis(1)));
    let (mut alps, mut worn) = (Arrays::plane(COUNT, 1), Arrays::plane(COUNT, 1));
    // The order is that of the call.
    let outputs = &mut [("worn", worn.samples()), ("alps", alps.samples())];
    recipe.sample2(&x, &y, outputs, &mut scratch)?;
    told.same("recipe_sample", &[gradient2(&alps), gradient2(&worn)].concat());
    Ok(())
}
