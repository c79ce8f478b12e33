// SPDX-License-Identifier: MIT
//! The declarations of `scarp.h`. Made by src/bindings/interface.py; do not change them by hand.
//!
//! `scarp.h` has the contracts. Calls are unsafe: nothing here checks lengths. Zero a structure
//! before you fill it in: `scarp_noise::default()`, or `Plan::new` and `Recipe::new` of the crate
//! for what calls write as a whole.
#![allow(non_camel_case_types, missing_docs)]
use std::mem::size_of;
use std::os::raw::{c_char, c_int, c_void};

/// The version of the header that the declarations were made of
pub const VERSION: &str = "0.2.0";

pub const SCARP_VERSION_MAJOR: i32 = 0;
pub const SCARP_VERSION_MINOR: i32 = 2;
pub const SCARP_VERSION_PATCH: i32 = 0;
pub const SCARP_CURVE_KNOTS: i32 = 64;
pub const SCARP_RECIPE_PARTS: i32 = 65536;
pub const SCARP_RECIPE_OUTPUT: i32 = -1;
pub const SCARP_GPU_ANSWERS: i32 = 4096;

pub type scarp_status = u32;
pub const SCARP_OK: scarp_status = 0;
pub const SCARP_ERROR_NULL: scarp_status = 1;
pub const SCARP_ERROR_ENUM: scarp_status = 2;
pub const SCARP_ERROR_PARAMETER: scarp_status = 3;
pub const SCARP_ERROR_SIZE: scarp_status = 4;
pub const SCARP_ERROR_UNSUPPORTED: scarp_status = 5;

pub type scarp_basis = u32;
pub const SCARP_GRADIENT: scarp_basis = 0;
pub const SCARP_VALUE: scarp_basis = 1;
pub const SCARP_SIMPLEX: scarp_basis = 2;
pub const SCARP_CELL_F1: scarp_basis = 3;
pub const SCARP_CELL_F2: scarp_basis = 4;
pub const SCARP_CELL_EDGE: scarp_basis = 5;
pub const SCARP_CELL_SOFT: scarp_basis = 6;
pub const SCARP_CELL_VALUE: scarp_basis = 7;

pub type scarp_fade = u32;
pub const SCARP_QUINTIC: scarp_fade = 0;
pub const SCARP_CUBIC: scarp_fade = 1;

pub type scarp_fractal = u32;
pub const SCARP_FBM: scarp_fractal = 0;
pub const SCARP_TURBULENCE: scarp_fractal = 1;
pub const SCARP_RIDGED: scarp_fractal = 2;
pub const SCARP_EROSION: scarp_fractal = 3;
pub const SCARP_PINGPONG: scarp_fractal = 4;
pub const SCARP_HYBRID: scarp_fractal = 5;
pub const SCARP_SWISS: scarp_fractal = 6;
pub const SCARP_JORDAN: scarp_fractal = 7;

pub type scarp_recipe_kind = u32;
pub const SCARP_RECIPE_BAD: scarp_recipe_kind = 0;
pub const SCARP_RECIPE_NUMBER: scarp_recipe_kind = 1;
pub const SCARP_RECIPE_FIELD: scarp_recipe_kind = 2;
pub const SCARP_RECIPE_NOISE: scarp_recipe_kind = 3;
pub const SCARP_RECIPE_WORD: scarp_recipe_kind = 4;
pub const SCARP_RECIPE_KNOT: scarp_recipe_kind = 5;

pub type scarp_language = u32;
pub const SCARP_GLSL: scarp_language = 0;
pub const SCARP_HLSL: scarp_language = 1;
pub const SCARP_WGSL: scarp_language = 2;

pub type scarp_isa = u32;
pub const SCARP_ISA_NONE: scarp_isa = 0;
pub const SCARP_ISA_SCALAR: scarp_isa = 1;
pub const SCARP_ISA_SSE41: scarp_isa = 2;
pub const SCARP_ISA_AVX2: scarp_isa = 3;
pub const SCARP_ISA_AVX512: scarp_isa = 4;
pub const SCARP_ISA_NEON: scarp_isa = 5;
pub const SCARP_ISA_GENERIC: scarp_isa = 6;
pub const SCARP_ISA_WASM128: scarp_isa = 7;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_noise {
    pub basis: scarp_basis,
    pub fade: scarp_fade,
    pub fractal: scarp_fractal,
    pub rotate: u32,
    pub seed: u64,
    pub frequency: f64,
    pub octaves: f32,
    pub lacunarity: f32,
    pub gain: f32,
    pub amplitude: f32,
    pub erosion: f32,
    pub phase: f32,
    pub jitter: f32,
    pub sharpness: f32,
    pub period: [u32; 3],
    pub of_octaves: f32,
    pub warp: *const scarp_noise,
    pub plan: *const scarp_plan,
    pub offset_first: u32,
    pub spare_word: u32,
    pub spare: [u32; (192 - 88 - 2 * size_of::<usize>()) / 4],
}

impl Default for scarp_noise {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_samples {
    pub value: *mut f32,
    pub dx: *mut f32,
    pub dy: *mut f32,
    pub dz: *mut f32,
    pub dxx: *mut f32,
    pub dxy: *mut f32,
    pub dxz: *mut f32,
    pub dyy: *mut f32,
    pub dyz: *mut f32,
    pub dzz: *mut f32,
    pub dphase: *mut f32,
    pub spare: [*mut f32; 5],
}

impl Default for scarp_samples {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_grid {
    pub origin: [f64; 3],
    pub step: [f64; 3],
    pub first: [i64; 3],
    pub count: [usize; 3],
    pub row_stride: usize,
    pub slice_stride: usize,
    pub spare: [u32; (192 - 72 - 5 * size_of::<usize>()) / 4],
}

impl Default for scarp_grid {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_plan {
    pub first: u64,
    pub rest: [u8; 12288 - 8],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_flow {
    pub vx: *mut f32,
    pub vy: *mut f32,
    pub vz: *mut f32,
    pub vxx: *mut f32,
    pub vxy: *mut f32,
    pub vxz: *mut f32,
    pub vyx: *mut f32,
    pub vyy: *mut f32,
    pub vyz: *mut f32,
    pub vzx: *mut f32,
    pub vzy: *mut f32,
    pub vzz: *mut f32,
    pub spare: [*mut f32; 4],
}

impl Default for scarp_flow {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_cells {
    pub f1: *mut f32,
    pub f2: *mut f32,
    pub id: *mut u32,
    pub x: *mut f32,
    pub y: *mut f32,
    pub z: *mut f32,
    pub dx1: *mut f32,
    pub dy1: *mut f32,
    pub dz1: *mut f32,
    pub dx2: *mut f32,
    pub dy2: *mut f32,
    pub dz2: *mut f32,
    pub spare: [*mut f32; 4],
}

impl Default for scarp_cells {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_partials {
    pub f: *const f32,
    pub fa: *const f32,
    pub fb: *const f32,
    pub faa: *const f32,
    pub fab: *const f32,
    pub fbb: *const f32,
    pub spare: [*const f32; 2],
}

impl Default for scarp_partials {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_gullies {
    pub seed: u64,
    pub frequency: f64,
    pub amplitude: f32,
    pub octaves: f32,
    pub of_octaves: f32,
    pub lacunarity: f32,
    pub gain: f32,
    pub depth: f32,
    pub cells: f32,
    pub slope: f32,
    pub slope_low: f32,
    pub low: f32,
    pub high: f32,
    pub floor: f32,
    pub stripes: f32,
    pub branch: f32,
    pub round: f32,
    pub keep: f32,
    pub period: [u32; 2],
    pub rotate: u32,
    pub offset_first: u32,
    pub spare: [u32; 8],
}

impl Default for scarp_gullies {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_eroded {
    pub value: *mut f32,
    pub dx: *mut f32,
    pub dy: *mut f32,
    pub displacement: *mut f32,
    pub displacement_dx: *mut f32,
    pub displacement_dy: *mut f32,
    pub spare: [*mut f32; 10],
}

impl Default for scarp_eroded {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_recipe {
    pub first: u64,
    pub rest: [u8; 65536 - 8],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_recipe_error {
    pub from: usize,
    pub to: usize,
    pub line: i32,
    pub column: i32,
    pub text: *const c_char,
    pub member: *const c_char,
    pub nearest: f64,
    pub spare: [u32; 6],
}

impl Default for scarp_recipe_error {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_scratch {
    pub memory: *mut c_void,
    pub size: usize,
    pub plan: *const c_void,
    pub spare: [u32; (64 - 3 * size_of::<usize>()) / 4],
}

impl Default for scarp_scratch {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_recipe_outputs {
    pub out: *const scarp_samples,
    pub which: *const i32,
    pub count: i32,
    pub spare: [u32; 9],
}

impl Default for scarp_recipe_outputs {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_box {
    pub lowest: [f64; 3],
    pub highest: [f64; 3],
}

impl Default for scarp_box {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_recipe_entry {
    pub span: [u32; 2],
    pub name: [u32; 2],
    pub kind: i32,
    pub is_param: i32,
    pub output: i32,
    pub part: i32,
    pub value: f64,
    pub slider: [f64; 2],
    pub range: [f32; 2],
    pub axes: u32,
    pub order: u32,
    pub hash: u64,
    pub cell: [f64; 2],
    pub jumps: u32,
    pub dimensions: u32,
    pub spare: [u32; 2],
}

impl Default for scarp_recipe_entry {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_recipe_part {
    pub span: [u32; 2],
    pub name: [u32; 2],
    pub argument: [u32; 2],
    pub kind: i32,
    pub function: i32,
    pub entry: i32,
    pub parent: i32,
    pub operation: i32,
    pub axes: u32,
    pub order: u32,
    pub range: [f32; 2],
    pub value: f64,
    pub hash: u64,
    pub spare: [u32; 8],
}

impl Default for scarp_recipe_part {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_recipe_argument {
    pub name: *const c_char,
    pub text: *const c_char,
    pub kind: i32,
    pub is_needed: i32,
    pub otherwise: f64,
    pub lowest: f64,
    pub highest: f64,
    pub words: *const *const c_char,
    pub spare: [u32; 4],
}

impl Default for scarp_recipe_argument {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_recipe_function {
    pub name: *const c_char,
    pub text: *const c_char,
    pub argument: *const scarp_recipe_argument,
    pub arguments: i32,
    pub spare: [u32; 5],
}

impl Default for scarp_recipe_function {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_gpu_octave {
    pub key: [u32; 3],
    pub frequency: f32,
    pub weight: f32,
    pub amplitude: f32,
    pub slope: f32,
    pub curvature: f32,
    pub last: [u32; 3],
    pub share: f32,
    pub turn: [f32; 4],
    pub jacobian: [[f32; 4]; 3],
    pub gradient: [[f32; 4]; 3],
}

impl Default for scarp_gpu_octave {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_gpu_level {
    pub basis: u32,
    pub fade: u32,
    pub fractal: u32,
    pub octaves: u32,
    pub rotate: u32,
    pub flows: u32,
    pub first: u32,
    pub spare0: u32,
    pub erosion: f32,
    pub sharpness: f32,
    pub inverse_weight: f32,
    pub spare1: f32,
}

impl Default for scarp_gpu_level {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_gpu_plan {
    pub depth: u32,
    pub dimensions: u32,
    pub zero: u32,
    pub unit: f32,
    pub level: [scarp_gpu_level; 5],
    pub octave: [scarp_gpu_octave; 32],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct scarp_shader {
    pub language: i32,
    pub order: i32,
    pub file: *const c_char,
    pub length: usize,
    pub spare: [u32; 12],
}

impl Default for scarp_shader {
    fn default() -> Self {
        // SAFETY: numbers and pointers may be 0.
        unsafe { std::mem::zeroed() }
    }
}

/// What 0 stands for in members that are numbers, by structure
#[allow(non_upper_case_globals)]
pub mod defaults {
    pub mod scarp_noise {
        pub const frequency: f64 = 1.0;
        pub const octaves: f32 = 1.0;
        pub const lacunarity: f32 = 2.0;
        pub const gain: f32 = 0.5;
        pub const amplitude: f32 = 1.0;
        pub const erosion: f32 = 1.0;
        pub const jitter: f32 = 1.0;
    }
    pub mod scarp_gullies {
        pub const frequency: f64 = 1.0;
        pub const amplitude: f32 = 1.0;
        pub const octaves: f32 = 5.0;
        pub const lacunarity: f32 = 2.0;
        pub const gain: f32 = 0.45;
        pub const depth: f32 = 0.25;
        pub const cells: f32 = 3.0;
        pub const slope: f32 = 1.125;
        pub const slope_low: f32 = 1.75;
        pub const low: f32 = -1.0;
        pub const high: f32 = 1.0;
        pub const floor: f32 = 0.5;
        pub const stripes: f32 = 1.5;
        pub const branch: f32 = 0.8;
        pub const round: f32 = 0.15;
        pub const keep: f32 = 1.0;
    }
}

extern "C" {
    pub fn scarp_sample2(
        noise: *const scarp_noise,
        count: usize,
        x: *const f32,
        y: *const f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_sample3(
        noise: *const scarp_noise,
        count: usize,
        x: *const f32,
        y: *const f32,
        z: *const f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_sample2_f64(
        noise: *const scarp_noise,
        count: usize,
        x: *const f64,
        y: *const f64,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_sample3_f64(
        noise: *const scarp_noise,
        count: usize,
        x: *const f64,
        y: *const f64,
        z: *const f64,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_grid2(
        noise: *const scarp_noise,
        grid: *const scarp_grid,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_grid3(
        noise: *const scarp_noise,
        grid: *const scarp_grid,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_normals(
        count: usize,
        dx: *const f32,
        dy: *const f32,
        height_scale: f32,
        nx: *mut f32,
        ny: *mut f32,
        nz: *mut f32,
    ) -> scarp_status;
    pub fn scarp_range(
        noise: *const scarp_noise,
        dimensions: c_int,
        lowest: *mut f32,
        highest: *mut f32,
    ) -> scarp_status;
    pub fn scarp_noise_check(
        noise: *const scarp_noise,
        dimensions: c_int,
        member: *mut *const c_char,
    ) -> scarp_status;
    pub fn scarp_noise_fault(
        noise: *const scarp_noise,
        dimensions: c_int,
        order: c_int,
        dphase: c_int,
        member: *mut *const c_char,
    ) -> *const c_char;
    pub fn scarp_grid_fault(
        grid: *const scarp_grid,
        dimensions: c_int,
        member: *mut *const c_char,
    ) -> *const c_char;
    pub fn scarp_plan_make(
        noise: *const scarp_noise,
        dimensions: c_int,
        plan: *mut scarp_plan,
    ) -> scarp_status;
    pub fn scarp_vector_plan_make(
        noise: *const scarp_noise,
        dimensions: c_int,
        plan: *mut scarp_plan,
    ) -> scarp_status;
    pub fn scarp_vector2(
        noise: *const scarp_noise,
        count: usize,
        x: *const f32,
        y: *const f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_vector3(
        noise: *const scarp_noise,
        count: usize,
        x: *const f32,
        y: *const f32,
        z: *const f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_vector2_f64(
        noise: *const scarp_noise,
        count: usize,
        x: *const f64,
        y: *const f64,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_vector3_f64(
        noise: *const scarp_noise,
        count: usize,
        x: *const f64,
        y: *const f64,
        z: *const f64,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_curl2(
        noise: *const scarp_noise,
        count: usize,
        x: *const f32,
        y: *const f32,
        out: *const scarp_flow,
    ) -> scarp_status;
    pub fn scarp_curl3(
        noise: *const scarp_noise,
        count: usize,
        x: *const f32,
        y: *const f32,
        z: *const f32,
        out: *const scarp_flow,
    ) -> scarp_status;
    pub fn scarp_curl2_f64(
        noise: *const scarp_noise,
        count: usize,
        x: *const f64,
        y: *const f64,
        out: *const scarp_flow,
    ) -> scarp_status;
    pub fn scarp_curl3_f64(
        noise: *const scarp_noise,
        count: usize,
        x: *const f64,
        y: *const f64,
        z: *const f64,
        out: *const scarp_flow,
    ) -> scarp_status;
    pub fn scarp_cells2(
        noise: *const scarp_noise,
        count: usize,
        x: *const f32,
        y: *const f32,
        out: *const scarp_cells,
    ) -> scarp_status;
    pub fn scarp_cells3(
        noise: *const scarp_noise,
        count: usize,
        x: *const f32,
        y: *const f32,
        z: *const f32,
        out: *const scarp_cells,
    ) -> scarp_status;
    pub fn scarp_cells2_f64(
        noise: *const scarp_noise,
        count: usize,
        x: *const f64,
        y: *const f64,
        out: *const scarp_cells,
    ) -> scarp_status;
    pub fn scarp_cells3_f64(
        noise: *const scarp_noise,
        count: usize,
        x: *const f64,
        y: *const f64,
        z: *const f64,
        out: *const scarp_cells,
    ) -> scarp_status;
    pub fn scarp_affine(
        count: usize,
        a: *const scarp_samples,
        scale: f32,
        offset: f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_add(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_multiply(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_mix(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        m: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_min(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_max(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_smooth_min(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        k: f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_smooth_max(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        k: f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_clamp(
        count: usize,
        a: *const scarp_samples,
        lo: f32,
        hi: f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_abs(
        count: usize,
        a: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_smooth_abs(
        count: usize,
        a: *const scarp_samples,
        round: f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_smoothstep(
        count: usize,
        a: *const scarp_samples,
        lo: f32,
        hi: f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_terrace(
        count: usize,
        a: *const scarp_samples,
        steps: f32,
        riser: f32,
        strength: f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_divide(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_sqrt(
        count: usize,
        a: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_sine(
        count: usize,
        a: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_pulse(
        count: usize,
        a: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_curve(
        count: usize,
        a: *const scarp_samples,
        knots: usize,
        x: *const f32,
        value: *const f32,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_slope(
        count: usize,
        a: *const scarp_samples,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_apply1(
        count: usize,
        a: *const scarp_samples,
        function: *const scarp_partials,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_apply2(
        count: usize,
        a: *const scarp_samples,
        b: *const scarp_samples,
        function: *const scarp_partials,
        out: *const scarp_samples,
    ) -> scarp_status;
    pub fn scarp_gullies2(
        gullies: *const scarp_gullies,
        count: usize,
        x: *const f32,
        y: *const f32,
        base: *const scarp_samples,
        out: *const scarp_eroded,
    ) -> scarp_status;
    pub fn scarp_gullies2_f64(
        gullies: *const scarp_gullies,
        count: usize,
        x: *const f64,
        y: *const f64,
        base: *const scarp_samples,
        out: *const scarp_eroded,
    ) -> scarp_status;
    pub fn scarp_gullies_grid2(
        gullies: *const scarp_gullies,
        grid: *const scarp_grid,
        base: *const scarp_samples,
        out: *const scarp_eroded,
    ) -> scarp_status;
    pub fn scarp_gullies_range(
        gullies: *const scarp_gullies,
        base_lowest: f32,
        base_highest: f32,
        lowest: *mut f32,
        highest: *mut f32,
    ) -> scarp_status;
    pub fn scarp_gullies_check(
        gullies: *const scarp_gullies,
        member: *mut *const c_char,
    ) -> scarp_status;
    pub fn scarp_gullies_fault(
        gullies: *const scarp_gullies,
        member: *mut *const c_char,
    ) -> *const c_char;
    pub fn scarp_recipe_parse(
        text: *const c_char,
        length: usize,
        recipe: *mut scarp_recipe,
        errors: *mut scarp_recipe_error,
        capacity: usize,
        found: *mut usize,
    ) -> scarp_status;
    pub fn scarp_recipe_seed(recipe: *mut scarp_recipe, seed: u64) -> scarp_status;
    pub fn scarp_recipe_set(
        recipe: *mut scarp_recipe,
        name: *const c_char,
        value: f64,
        error: *mut scarp_recipe_error,
    ) -> scarp_status;
    pub fn scarp_recipe_tile(
        recipe: *mut scarp_recipe,
        x: f64,
        y: f64,
        z: f64,
        error: *mut scarp_recipe_error,
    ) -> scarp_status;
    pub fn scarp_recipe_scale(
        recipe: *mut scarp_recipe,
        by: f64,
        heights: f64,
        error: *mut scarp_recipe_error,
    ) -> scarp_status;
    pub fn scarp_recipe_sample(
        recipe: *const scarp_recipe,
        count: usize,
        x: *const f32,
        y: *const f32,
        z: *const f32,
        outputs: *const scarp_recipe_outputs,
        scratch: *const scarp_scratch,
    ) -> scarp_status;
    pub fn scarp_recipe_sample_f64(
        recipe: *const scarp_recipe,
        count: usize,
        x: *const f64,
        y: *const f64,
        z: *const f64,
        outputs: *const scarp_recipe_outputs,
        scratch: *const scarp_scratch,
    ) -> scarp_status;
    pub fn scarp_recipe_grid(
        recipe: *const scarp_recipe,
        grid: *const scarp_grid,
        outputs: *const scarp_recipe_outputs,
        scratch: *const scarp_scratch,
    ) -> scarp_status;
    pub fn scarp_recipe_scratch_size(
        recipe: *const scarp_recipe,
        order: c_int,
        points: usize,
    ) -> usize;
    pub fn scarp_recipe_plan_size(recipe: *const scarp_recipe) -> usize;
    pub fn scarp_recipe_plan_make(
        recipe: *const scarp_recipe,
        memory: *mut c_void,
        size: usize,
    ) -> scarp_status;
    pub fn scarp_recipe_range(
        recipe: *const scarp_recipe,
        which: i32,
        r#box: *const scarp_box,
        lowest: *mut f32,
        highest: *mut f32,
    ) -> scarp_status;
    pub fn scarp_recipe_entry_at(
        recipe: *const scarp_recipe,
        index: usize,
        entry: *mut scarp_recipe_entry,
    ) -> scarp_status;
    pub fn scarp_recipe_part_at(
        recipe: *const scarp_recipe,
        index: usize,
        part: *mut scarp_recipe_part,
    ) -> scarp_status;
    pub fn scarp_recipe_function_at(
        index: usize,
        function: *mut scarp_recipe_function,
    ) -> scarp_status;
    pub fn scarp_gpu_plan_make(
        noise: *const scarp_noise,
        dimensions: c_int,
        plan: *mut scarp_gpu_plan,
        member: *mut *const c_char,
    ) -> scarp_status;
    pub fn scarp_gpu_vector_plan_make(
        noise: *const scarp_noise,
        dimensions: c_int,
        plan: *mut scarp_gpu_plan,
        member: *mut *const c_char,
    ) -> scarp_status;
    pub fn scarp_gpu_plan_fault(
        noise: *const scarp_noise,
        dimensions: c_int,
        vector: c_int,
        member: *mut *const c_char,
    ) -> *const c_char;
    pub fn scarp_gpu_answers(
        noise: *const scarp_noise,
        dimensions: c_int,
        order: c_int,
        answer: *mut u32,
    ) -> scarp_status;
    pub fn scarp_recipe_shader(
        recipe: *const scarp_recipe,
        how: *const scarp_shader,
        text: *mut c_char,
        capacity: usize,
        length: *mut usize,
    ) -> scarp_status;
    pub fn scarp_recipe_uniforms(
        recipe: *const scarp_recipe,
        bytes: *mut c_void,
        capacity: usize,
        size: *mut usize,
    ) -> scarp_status;
    pub fn scarp_recipe_answers(
        recipe: *const scarp_recipe,
        order: c_int,
        answer: *mut u32,
    ) -> scarp_status;
    pub fn scarp_basis_name(basis: scarp_basis) -> *const c_char;
    pub fn scarp_fade_name(fade: scarp_fade) -> *const c_char;
    pub fn scarp_fractal_name(fractal: scarp_fractal) -> *const c_char;
    pub fn scarp_status_text(status: scarp_status) -> *const c_char;
    pub fn scarp_version() -> *const c_char;
    pub fn scarp_isa_active() -> scarp_isa;
    pub fn scarp_isa_supported(isa: scarp_isa) -> c_int;
    pub fn scarp_isa_select(isa: scarp_isa) -> scarp_status;
    pub fn scarp_isa_name(isa: scarp_isa) -> *const c_char;
}

#[cfg(test)]
mod layout {
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    // Numbers are those of the description: for pointers of 4 bytes, and of 8. They hold where
    // doubles lie at multiples of 8 bytes, which they do not on 32-bit x86.
    macro_rules! layout {
        ($name:ident: $four:expr, $eight:expr; $($member:ident: $at4:expr, $at8:expr;)*) => {
            #[test]
            fn $name() {
                if align_of::<f64>() != 8 {
                    return;
                }
                let here = |four, eight| if size_of::<usize>() == 4 { four } else { eight };
                assert_eq!(size_of::<super::$name>(), here($four, $eight));
                let place = MaybeUninit::<super::$name>::uninit();
                let start = place.as_ptr();
                $(
                    // SAFETY: the address is taken, and nothing is read.
                    let member = unsafe { addr_of!((*start).$member) } as usize;
                    let name = stringify!($member);
                    assert_eq!(member - start as usize, here($at4, $at8), "{}", name);
                )*
            }
        };
    }

    layout! {
        scarp_noise: 192, 192;
        basis: 0, 0;
        fade: 4, 4;
        fractal: 8, 8;
        rotate: 12, 12;
        seed: 16, 16;
        frequency: 24, 24;
        octaves: 32, 32;
        lacunarity: 36, 36;
        gain: 40, 40;
        amplitude: 44, 44;
        erosion: 48, 48;
        phase: 52, 52;
        jitter: 56, 56;
        sharpness: 60, 60;
        period: 64, 64;
        of_octaves: 76, 76;
        warp: 80, 80;
        plan: 84, 88;
        offset_first: 88, 96;
        spare_word: 92, 100;
        spare: 96, 104;
    }

    layout! {
        scarp_samples: 64, 128;
        value: 0, 0;
        dx: 4, 8;
        dy: 8, 16;
        dz: 12, 24;
        dxx: 16, 32;
        dxy: 20, 40;
        dxz: 24, 48;
        dyy: 28, 56;
        dyz: 32, 64;
        dzz: 36, 72;
        dphase: 40, 80;
        spare: 44, 88;
    }

    layout! {
        scarp_grid: 192, 192;
        origin: 0, 0;
        step: 24, 24;
        first: 48, 48;
        count: 72, 72;
        row_stride: 84, 96;
        slice_stride: 88, 104;
        spare: 92, 112;
    }

    layout! {
        scarp_plan: 12288, 12288;
        first: 0, 0;
        rest: 8, 8;
    }

    layout! {
        scarp_flow: 64, 128;
        vx: 0, 0;
        vy: 4, 8;
        vz: 8, 16;
        vxx: 12, 24;
        vxy: 16, 32;
        vxz: 20, 40;
        vyx: 24, 48;
        vyy: 28, 56;
        vyz: 32, 64;
        vzx: 36, 72;
        vzy: 40, 80;
        vzz: 44, 88;
        spare: 48, 96;
    }

    layout! {
        scarp_cells: 64, 128;
        f1: 0, 0;
        f2: 4, 8;
        id: 8, 16;
        x: 12, 24;
        y: 16, 32;
        z: 20, 40;
        dx1: 24, 48;
        dy1: 28, 56;
        dz1: 32, 64;
        dx2: 36, 72;
        dy2: 40, 80;
        dz2: 44, 88;
        spare: 48, 96;
    }

    layout! {
        scarp_partials: 32, 64;
        f: 0, 0;
        fa: 4, 8;
        fb: 8, 16;
        faa: 12, 24;
        fab: 16, 32;
        fbb: 20, 40;
        spare: 24, 48;
    }

    layout! {
        scarp_gullies: 128, 128;
        seed: 0, 0;
        frequency: 8, 8;
        amplitude: 16, 16;
        octaves: 20, 20;
        of_octaves: 24, 24;
        lacunarity: 28, 28;
        gain: 32, 32;
        depth: 36, 36;
        cells: 40, 40;
        slope: 44, 44;
        slope_low: 48, 48;
        low: 52, 52;
        high: 56, 56;
        floor: 60, 60;
        stripes: 64, 64;
        branch: 68, 68;
        round: 72, 72;
        keep: 76, 76;
        period: 80, 80;
        rotate: 88, 88;
        offset_first: 92, 92;
        spare: 96, 96;
    }

    layout! {
        scarp_eroded: 64, 128;
        value: 0, 0;
        dx: 4, 8;
        dy: 8, 16;
        displacement: 12, 24;
        displacement_dx: 16, 32;
        displacement_dy: 20, 40;
        spare: 24, 48;
    }

    layout! {
        scarp_recipe: 65536, 65536;
        first: 0, 0;
        rest: 8, 8;
    }

    layout! {
        scarp_recipe_error: 56, 72;
        from: 0, 0;
        to: 4, 8;
        line: 8, 16;
        column: 12, 20;
        text: 16, 24;
        member: 20, 32;
        nearest: 24, 40;
        spare: 32, 48;
    }

    layout! {
        scarp_scratch: 64, 64;
        memory: 0, 0;
        size: 4, 8;
        plan: 8, 16;
        spare: 12, 24;
    }

    layout! {
        scarp_recipe_outputs: 48, 56;
        out: 0, 0;
        which: 4, 8;
        count: 8, 16;
        spare: 12, 20;
    }

    layout! {
        scarp_box: 48, 48;
        lowest: 0, 0;
        highest: 24, 24;
    }

    layout! {
        scarp_recipe_entry: 112, 112;
        span: 0, 0;
        name: 8, 8;
        kind: 16, 16;
        is_param: 20, 20;
        output: 24, 24;
        part: 28, 28;
        value: 32, 32;
        slider: 40, 40;
        range: 56, 56;
        axes: 64, 64;
        order: 68, 68;
        hash: 72, 72;
        cell: 80, 80;
        jumps: 96, 96;
        dimensions: 100, 100;
        spare: 104, 104;
    }

    layout! {
        scarp_recipe_part: 112, 112;
        span: 0, 0;
        name: 8, 8;
        argument: 16, 16;
        kind: 24, 24;
        function: 28, 28;
        entry: 32, 32;
        parent: 36, 36;
        operation: 40, 40;
        axes: 44, 44;
        order: 48, 48;
        range: 52, 52;
        value: 64, 64;
        hash: 72, 72;
        spare: 80, 80;
    }

    layout! {
        scarp_recipe_argument: 64, 72;
        name: 0, 0;
        text: 4, 8;
        kind: 8, 16;
        is_needed: 12, 20;
        otherwise: 16, 24;
        lowest: 24, 32;
        highest: 32, 40;
        words: 40, 48;
        spare: 44, 56;
    }

    layout! {
        scarp_recipe_function: 36, 48;
        name: 0, 0;
        text: 4, 8;
        argument: 8, 16;
        arguments: 12, 24;
        spare: 16, 28;
    }

    layout! {
        scarp_gpu_octave: 160, 160;
        key: 0, 0;
        frequency: 12, 12;
        weight: 16, 16;
        amplitude: 20, 20;
        slope: 24, 24;
        curvature: 28, 28;
        last: 32, 32;
        share: 44, 44;
        turn: 48, 48;
        jacobian: 64, 64;
        gradient: 112, 112;
    }

    layout! {
        scarp_gpu_level: 48, 48;
        basis: 0, 0;
        fade: 4, 4;
        fractal: 8, 8;
        octaves: 12, 12;
        rotate: 16, 16;
        flows: 20, 20;
        first: 24, 24;
        spare0: 28, 28;
        erosion: 32, 32;
        sharpness: 36, 36;
        inverse_weight: 40, 40;
        spare1: 44, 44;
    }

    layout! {
        scarp_gpu_plan: 5376, 5376;
        depth: 0, 0;
        dimensions: 4, 4;
        zero: 8, 8;
        unit: 12, 12;
        level: 16, 16;
        octave: 256, 256;
    }

    layout! {
        scarp_shader: 64, 72;
        language: 0, 0;
        order: 4, 4;
        file: 8, 8;
        length: 12, 16;
        spare: 16, 24;
    }
}
