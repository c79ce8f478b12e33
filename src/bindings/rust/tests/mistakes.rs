// SPDX-License-Identifier: MIT
//! Mistakes are errors that say what is at fault, and nothing is written then.
use scarp::*;

const X: [f32; 4] = [0.5, 1.5, 2.5, 3.5];

/// Checks the status, and the member at fault; "" for none.
#[track_caller]
fn refused<T: std::fmt::Debug>(result: Result<T, Error>, status: Status, member: &str) {
    let error = result.unwrap_err();
    assert_eq!((error.status(), error.member().unwrap_or("")), (status, member), "{}", error);
    assert!(!error.to_string().is_empty());
}

fn value(slice: &mut [f32]) -> Samples<'_> {
    Samples { value: Some(slice), ..Samples::default() }
}

#[test]
fn lengths() {
    let noise = Noise::default();
    let (mut three, mut four, mut five) = ([7.0; 3], [7.0; 4], [7.0; 5]);
    for wrong in [&mut three[..], &mut five[..]] {
        refused(noise.sample2(&X, &X, &mut value(wrong)), Status::Size, "value");
        assert!(wrong.iter().all(|x| *x == 7.0));
    }
    refused(noise.sample2(&X, &X[1..], &mut value(&mut four)), Status::Size, "y");
    refused(noise.sample3(&X, &X, &X[..0], &mut value(&mut four)), Status::Size, "z");
    let mut out = Samples { dx: Some(&mut three), ..value(&mut four) };
    refused(noise.sample2(&X, &X, &mut out), Status::Size, "dx");
    let mut vector = [value(&mut four), value(&mut three)];
    refused(noise.vector2(&X, &X, &mut vector), Status::Size, "value");
    let mut cells = Cells { f2: Some(&mut three), ..Cells::default() };
    refused(noise.cells2(&X, &X, &mut cells), Status::Size, "f2");
    let mut flow = Flow { vx: Some(&mut three), ..Flow::default() };
    refused(noise.curl3(&X, &X, &X, &mut flow), Status::Size, "vx");
    assert_eq!((three, four, five), ([7.0; 3], [7.0; 4], [7.0; 5]));

    let error = noise.sample2(&X, &X, &mut value(&mut three)).unwrap_err();
    assert_eq!(error.to_string(), "value: the slice has 3 elements, and there are 4 points");
    noise.sample2::<f32>(&[], &[], &mut value(&mut [])).unwrap();
    noise.sample2(&X, &X, &mut Samples::default()).unwrap();
}

#[test]
fn grids() {
    let noise = Noise::default();
    let grid = Grid::<2> { count: [5, 4], row_stride: 6, ..Grid::default() };
    let mut long = [7.0; 24];
    refused(noise.grid2(&grid, &mut value(&mut long[..22])), Status::Size, "value");
    assert_eq!(long, [7.0; 24]);
    noise.grid2(&grid, &mut value(&mut long[..23])).unwrap();
    assert_eq!((long[5], long[23]), (7.0, 7.0)); // nothing between the rows, or behind them

    let short = Grid { row_stride: 4, ..grid };
    refused(noise.grid2(&short, &mut value(&mut long)), Status::Parameter, "grid");
    let endless = Grid { step: [f64::INFINITY, 1.0], ..grid };
    refused(noise.grid2(&endless, &mut value(&mut long)), Status::Parameter, "grid");
    for count in [[usize::MAX, 2], [2, usize::MAX], [usize::MAX, usize::MAX]] {
        let huge = Grid::<2> { count, ..Grid::default() };
        assert_eq!(noise.grid2(&huge, &mut value(&mut long)).unwrap_err().status(), Status::Size);
    }
    let huge = Grid::<3> { count: [2, 2, 2], slice_stride: usize::MAX, ..Grid::default() };
    refused(noise.grid3(&huge, &mut value(&mut long)), Status::Size, "count");
    let cube = Grid::<3> { count: [3, 3, 3], ..Grid::default() };
    refused(noise.grid3(&cube, &mut value(&mut long)), Status::Size, "value");
    noise.grid2(&Grid { count: [0, 9], ..grid }, &mut value(&mut [])).unwrap();
}

#[test]
fn members() {
    let d = Noise::default();
    for (noise, status, member) in [
        (Noise { octaves: f32::NAN, ..d }, Status::Parameter, "octaves"),
        (Noise { octaves: 33.0, ..d }, Status::Parameter, "octaves"),
        (Noise { frequency: f64::INFINITY, ..d }, Status::Parameter, "frequency"),
        (Noise { frequency: 0.0, ..d }, Status::Parameter, "frequency"),
        (Noise { amplitude: -0.0, ..d }, Status::Parameter, "amplitude"),
        (Noise { jitter: 2.0, ..d }, Status::Parameter, "jitter"),
        (Noise { octaves: 3.0, period: [0, 1 << 30, 0], ..d }, Status::Parameter, "period[1]"),
        (Noise { basis: Basis::Value, phase: 0.5, ..d }, Status::Unsupported, "phase"),
    ] {
        let mut out = [7.0; 4];
        refused(noise.sample2(&X, &X, &mut value(&mut out)), status, member);
        refused(noise.range(2), status, member);
        refused(noise.check(2), status, member);
        refused(Plan::new(&noise, 2), status, member);
        refused(GpuPlan::new(&noise, 2), status, member);
        assert_eq!(out, [7.0; 4]);

        let bend = Noise { warp: Some(&noise), ..d };
        let bent = Noise { warp: Some(&bend), ..d };
        refused(
            bent.sample2(&X, &X, &mut value(&mut out)),
            status,
            &format!("warp.warp.{}", member),
        );
    }
    refused(d.range(4), Status::Parameter, "dimensions");
    refused(d.check(usize::MAX), Status::Parameter, "dimensions");
    refused(Plan::new(&d, 1), Status::Parameter, "dimensions");
    refused(d.gpu_answers(2, 3), Status::Parameter, "order");
    let long = Noise { octaves: 20.0, ..d };
    let bent = Noise { warp: Some(&long), ..long };
    refused(GpuPlan::new(&bent, 2), Status::Unsupported, "warp");
    refused(bent.gpu_answers(2, 0), Status::Unsupported, "warp");
    let swiss = Noise { fractal: Fractal::Swiss, ..d };
    refused(swiss.gpu_answers(2, 2), Status::Unsupported, "order");
}

/// The library takes four warps, and says no to a circle.
#[test]
fn warps() {
    let d = Noise::default();
    let (a, out) = (Noise { warp: Some(&d), ..d }, &mut [0.0; 4]);
    let b = Noise { warp: Some(&a), ..d };
    let c = Noise { warp: Some(&b), ..d };
    let four = Noise { warp: Some(&c), ..d };
    four.sample2(&X, &X, &mut value(out)).unwrap();
    let five = Noise { warp: Some(&four), ..d };
    refused(five.sample2(&X, &X, &mut value(out)), Status::Unsupported, "warp.warp.warp.warp.warp");
    static CIRCLE: Noise<'static> = Noise { warp: Some(&CIRCLE), ..Noise::DEFAULT };
    assert_eq!(CIRCLE.sample2(&X, &X, &mut value(out)).unwrap_err().status(), Status::Unsupported);
}

#[test]
fn outputs_that_do_not_exist() {
    let (mut a, mut b) = ([7.0; 4], [7.0; 4]);
    let mut out = Samples { dz: Some(&mut b), ..value(&mut a) };
    refused(Noise::default().sample2(&X, &X, &mut out), Status::Unsupported, "dz");
    let eroded = Noise { fractal: Fractal::Erosion, octaves: 3.0, ..Noise::default() };
    let mut out = Samples { dxy: Some(&mut b), ..value(&mut a) };
    refused(eroded.sample2(&X, &X, &mut out), Status::Unsupported, "dxy");
    let swiss = Noise { fractal: Fractal::Swiss, ..Noise::default() };
    refused(swiss.sample2(&X, &X, &mut out), Status::Unsupported, "dxy");
    let bent = Noise { warp: Some(&eroded), ..Noise::default() };
    refused(bent.sample2(&X, &X, &mut out), Status::Unsupported, "dxy");
    let mut out = Samples { dphase: Some(&mut b), ..value(&mut a) };
    let cells = Noise { basis: Basis::CellF1, ..Noise::default() };
    refused(cells.sample2(&X, &X, &mut out), Status::Unsupported, "dphase");
    assert_eq!((a, b), ([7.0; 4], [7.0; 4]));
}

#[test]
fn chain_rule() {
    let (mut a, mut b) = (Arrays::plane(4, 1), Arrays::plane(3, 1));
    let mut out = Arrays::plane(4, 1);
    refused(chain::add(&a.view(), &b.view(), &mut out.samples()), Status::Size, "value");
    refused(a.samples().add(&b.view()), Status::Size, "value");
    refused(a.samples().smooth_abs(f32::NAN), Status::Parameter, "");
    refused(chain::abs(&View { dx: None, ..a.view() }, &mut out.samples()), Status::Null, "");
    refused(b.samples().clamp(2.0, 1.0), Status::Parameter, "");
    refused(chain::curve(&a.view(), &X, &X[1..], &mut out.samples()), Status::Size, "value");
    refused(chain::curve(&a.view(), &X[..1], &X[..1], &mut out.samples()), Status::Parameter, "");
    let short = Partials { f: Some(&X[1..]), ..Partials::default() };
    refused(chain::apply1(&a.view(), &short, &mut out.samples()), Status::Size, "f");
    let (mut n, mut m, mut k) = ([0.0; 4], [0.0; 3], [0.0; 4]);
    refused(normals(&X, &X, 1.0, [&mut n, &mut m, &mut k]), Status::Size, "ny");
    refused(normals(&X, &X[1..], 1.0, [&mut n, &mut [], &mut k]), Status::Size, "dy");
}

#[test]
fn gullies() {
    let base = Arrays::plane(4, 1);
    let mut out = [7.0; 4];
    let d = Gullies::default();
    for (gullies, member) in [
        (Gullies { octaves: 0.0, ..d }, "octaves"),
        (Gullies { frequency: 0.0, ..d }, "frequency"),
        (Gullies { depth: f32::NAN, ..d }, "depth"),
    ] {
        let mut out = Eroded { value: Some(&mut out), ..Eroded::default() };
        refused(gullies.sample2(&X, &X, &base.view(), &mut out), Status::Parameter, member);
        refused(gullies.range((-1.0, 1.0)), Status::Parameter, member);
    }
    let mut five = [7.0; 5];
    let mut long = Eroded { dx: Some(&mut five), ..Eroded::default() };
    refused(d.sample2(&X, &X, &base.view(), &mut long), Status::Size, "dx");
    let mut fits = Eroded { value: Some(&mut out), ..Eroded::default() };
    let flat = View { dx: None, ..base.view() };
    refused(d.sample2(&X, &X, &flat, &mut fits), Status::Null, "");
    refused(
        d.sample2(&X, &X, &View { dx: Some(&X[1..]), ..base.view() }, &mut fits),
        Status::Size,
        "dx",
    );
    let grid = Grid::<2> { count: [3, 2], ..Grid::default() };
    refused(d.grid2(&grid, &base.view(), &mut fits), Status::Size, "value");
    let endless = Grid::<2> { count: [2, 2], step: [f64::NAN; 2], ..grid };
    refused(d.grid2(&endless, &base.view(), &mut fits), Status::Parameter, "grid");
    assert_eq!((out, five), ([7.0; 4], [7.0; 5]));
}

#[test]
fn recipes() {
    let text = "recipe 1\nout a = noise(size=100, octaves=99)\nout b = nose(size=4)";
    let error = Recipe::new(text).unwrap_err();
    let places = error.places();
    assert_eq!(places.len(), 2);
    assert_eq!((places[0].line, places[0].column, places[0].member), (2, 33, Some("octaves")));
    assert_eq!(&text[places[0].span.clone()], "99");
    assert_eq!(places[1].line, 3);
    assert_eq!(
        error.to_string().lines().next(),
        Some("line 2, column 33: octaves: outside (0, 32]")
    );
    refused(Recipe::new(&" ".repeat(16385)), Status::Size, "text");
    refused(Recipe::preset("alp"), Status::Enum, "\"alp\"");

    let mut recipe =
        Recipe::new("recipe 1\nparam h = 2 [1, 9]\nlow = noise(size=9)\nout a = h * low").unwrap();
    refused(recipe.set_tile([1.0, -1.0, 0.0]), Status::Parameter, "tile");
    refused(recipe.set_scale(f64::NAN, 1.0), Status::Parameter, "scale");
    refused(recipe.info("h").map(|_| ()), Status::Parameter, "h");
    refused(recipe.set("h", 10.0), Status::Parameter, "h");
    refused(recipe.set("h", f64::NAN), Status::Parameter, "h");
    refused(recipe.set("k", 1.0), Status::Parameter, "k");
    refused(recipe.set("h\0", 1.0), Status::Parameter, "h\0");
    refused(recipe.set("finest", -1.0), Status::Parameter, "finest");
    assert_eq!((recipe.get("h"), recipe.get("a")), (Some(2.0), None));
    recipe.set("h", 9.0).unwrap();
    assert_eq!(recipe.get("h"), Some(9.0));
    refused(recipe.range("h"), Status::Parameter, "h");
    refused(recipe.range_in("a", [1.0; 3], [0.0; 3]), Status::Parameter, "box");

    let (scratch, mut four, mut five) = (&mut Scratch::new(), [7.0; 4], [7.0; 5]);
    refused(recipe.sample2(&X, &X, &mut [("a", value(&mut five))], scratch), Status::Size, "value");
    refused(
        recipe.sample2(&X, &X, &mut [("h", value(&mut four))], scratch),
        Status::Parameter,
        "h",
    );
    refused(recipe.sample2(&X, &X, &mut [], scratch), Status::Parameter, "outputs");
    refused(
        recipe.sample3(&X, &X, &X, &mut [("a", value(&mut four))], scratch),
        Status::Parameter,
        "dimensions",
    );
    let mut phase = Samples { dphase: Some(&mut five[..4]), ..Samples::default() };
    refused(
        recipe.sample2(&X, &X, &mut [("low", value(&mut four)), ("a", phase.reborrow())], scratch),
        Status::Unsupported,
        "a",
    );
    let mut up = Samples { dz: Some(&mut five[..4]), ..Samples::default() };
    refused(
        recipe.sample2(&X, &X, &mut [("low", value(&mut four)), ("a", up.reborrow())], scratch),
        Status::Unsupported,
        "a",
    );
    assert_eq!((four, five), ([7.0; 4], [7.0; 5]));
    recipe.sample2(&X, &X, &mut [("low", value(&mut four))], scratch).unwrap();
    assert_ne!(four, [7.0; 4]);

    let space = Recipe::new("recipe 1\nspace 3\nout a = noise(size=9) + z").unwrap();
    assert_eq!((space.dimensions(), recipe.dimensions()), (3, 2));
    refused(
        space.sample2(&X, &X, &mut [("a", value(&mut four))], scratch),
        Status::Parameter,
        "dimensions",
    );
    let eroded = Recipe::new("recipe 1\nout a = noise(erosion, size=9, octaves=3)").unwrap();
    let mut second = Samples { dxx: Some(&mut four), ..Samples::default() };
    refused(
        eroded.sample2(&X, &X, &mut [("a", second.reborrow())], scratch),
        Status::Unsupported,
        "a",
    );
    // The output at fault is named, not one that lacks what another is asked for.
    let two = "recipe 1\nout a = noise(erosion, size=9, octaves=3)\nout b = noise(swiss, size=9)";
    refused(
        Recipe::new(two).unwrap().sample2(
            &X,
            &X,
            &mut [("a", value(&mut five[..4])), ("b", second.reborrow())],
            scratch,
        ),
        Status::Unsupported,
        "b",
    );
    refused(recipe.shader(Language::Glsl, 0, "no shader"), Status::Parameter, "");
    refused(recipe.answers(3), Status::Parameter, "");
}

/// More fields than outputs have scratch memory for
#[test]
fn all_presets() {
    let mut scratch = Scratch::new();
    for name in presets() {
        let recipe = Recipe::preset(name).unwrap();
        let output = recipe.outputs().next().unwrap().to_owned();
        let mut out = [f32::NAN; 4];
        recipe.sample2(&X, &X, &mut [(&output, value(&mut out))], &mut scratch).unwrap();
        let (lowest, highest) = recipe.range(&output).unwrap();
        assert!(out.iter().all(|x| (lowest..=highest).contains(x)), "{}", name);
    }
    assert_eq!(presets().count(), 9);
}
