// SPDX-License-Identifier: MIT
//
// Tables of scarp.h, for pointers of 4 bytes. Made by src/bindings/interface.py; do not change them
// by hand. Of a structure: its SIZE in bytes, and the offset of each member.

export const SCARP_VERSION_MAJOR = 0;
export const SCARP_VERSION_MINOR = 2;
export const SCARP_VERSION_PATCH = 0;
export const SCARP_CURVE_KNOTS = 64;
export const SCARP_RECIPE_PARTS = 65536;
export const SCARP_RECIPE_OUTPUT = -1;
export const SCARP_GPU_ANSWERS = 4096;

export const scarp_status = {
    SCARP_OK: 0, SCARP_ERROR_NULL: 1, SCARP_ERROR_ENUM: 2, SCARP_ERROR_PARAMETER: 3,
    SCARP_ERROR_SIZE: 4, SCARP_ERROR_UNSUPPORTED: 5,
};
export const scarp_basis = {
    SCARP_GRADIENT: 0, SCARP_VALUE: 1, SCARP_SIMPLEX: 2, SCARP_CELL_F1: 3, SCARP_CELL_F2: 4,
    SCARP_CELL_EDGE: 5, SCARP_CELL_SOFT: 6, SCARP_CELL_VALUE: 7,
};
export const scarp_fade = { SCARP_QUINTIC: 0, SCARP_CUBIC: 1 };
export const scarp_fractal = {
    SCARP_FBM: 0, SCARP_TURBULENCE: 1, SCARP_RIDGED: 2, SCARP_EROSION: 3, SCARP_PINGPONG: 4,
    SCARP_HYBRID: 5, SCARP_SWISS: 6, SCARP_JORDAN: 7,
};
export const scarp_recipe_kind = {
    SCARP_RECIPE_BAD: 0, SCARP_RECIPE_NUMBER: 1, SCARP_RECIPE_FIELD: 2, SCARP_RECIPE_NOISE: 3,
    SCARP_RECIPE_WORD: 4, SCARP_RECIPE_KNOT: 5,
};
export const scarp_language = { SCARP_GLSL: 0, SCARP_HLSL: 1, SCARP_WGSL: 2 };
export const scarp_isa = {
    SCARP_ISA_NONE: 0, SCARP_ISA_SCALAR: 1, SCARP_ISA_SSE41: 2, SCARP_ISA_AVX2: 3,
    SCARP_ISA_AVX512: 4, SCARP_ISA_NEON: 5, SCARP_ISA_GENERIC: 6, SCARP_ISA_WASM128: 7,
};

export const scarp_noise = {
    SIZE: 192, basis: 0, fade: 4, fractal: 8, rotate: 12, seed: 16, frequency: 24, octaves: 32,
    lacunarity: 36, gain: 40, amplitude: 44, erosion: 48, phase: 52, jitter: 56, sharpness: 60,
    period: 64, of_octaves: 76, warp: 80, plan: 84, offset_first: 88,
};
export const scarp_noise_types = {
    basis: 'enum', fade: 'enum', fractal: 'enum', rotate: 'uint32_t', seed: 'uint64_t',
    frequency: 'double', octaves: 'float', lacunarity: 'float', gain: 'float', amplitude: 'float',
    erosion: 'float', phase: 'float', jitter: 'float', sharpness: 'float', period: 'uint32_t[3]',
    of_octaves: 'float', warp: 'pointer', plan: 'pointer', offset_first: 'uint32_t',
};

export const scarp_samples = {
    SIZE: 64, value: 0, dx: 4, dy: 8, dz: 12, dxx: 16, dxy: 20, dxz: 24, dyy: 28, dyz: 32, dzz: 36,
    dphase: 40,
};

export const scarp_grid = {
    SIZE: 192, origin: 0, step: 24, first: 48, count: 72, row_stride: 84, slice_stride: 88,
};

export const scarp_plan = { SIZE: 12288, first: 0, rest: 8 };

export const scarp_flow = {
    SIZE: 64, vx: 0, vy: 4, vz: 8, vxx: 12, vxy: 16, vxz: 20, vyx: 24, vyy: 28, vyz: 32, vzx: 36,
    vzy: 40, vzz: 44,
};

export const scarp_cells = {
    SIZE: 64, f1: 0, f2: 4, id: 8, x: 12, y: 16, z: 20, dx1: 24, dy1: 28, dz1: 32, dx2: 36,
    dy2: 40, dz2: 44,
};

export const scarp_partials = { SIZE: 32, f: 0, fa: 4, fb: 8, faa: 12, fab: 16, fbb: 20 };

export const scarp_gullies = {
    SIZE: 128, seed: 0, frequency: 8, amplitude: 16, octaves: 20, of_octaves: 24, lacunarity: 28,
    gain: 32, depth: 36, cells: 40, slope: 44, slope_low: 48, low: 52, high: 56, floor: 60,
    stripes: 64, branch: 68, round: 72, keep: 76, period: 80, rotate: 88, offset_first: 92,
};

export const scarp_eroded = {
    SIZE: 64, value: 0, dx: 4, dy: 8, displacement: 12, displacement_dx: 16, displacement_dy: 20,
};

export const scarp_recipe = { SIZE: 65536, first: 0, rest: 8 };

export const scarp_recipe_error = {
    SIZE: 56, from: 0, to: 4, line: 8, column: 12, text: 16, member: 20, nearest: 24,
};

export const scarp_scratch = { SIZE: 64, memory: 0, size: 4, plan: 8 };

export const scarp_recipe_outputs = { SIZE: 48, out: 0, which: 4, count: 8 };

export const scarp_box = { SIZE: 48, lowest: 0, highest: 24 };

export const scarp_recipe_entry = {
    SIZE: 112, span: 0, name: 8, kind: 16, is_param: 20, output: 24, part: 28, value: 32,
    slider: 40, range: 56, axes: 64, order: 68, hash: 72, cell: 80, jumps: 96, dimensions: 100,
};

export const scarp_recipe_part = {
    SIZE: 112, span: 0, name: 8, argument: 16, kind: 24, function: 28, entry: 32, parent: 36,
    operation: 40, axes: 44, order: 48, range: 52, value: 64, hash: 72,
};

export const scarp_recipe_argument = {
    SIZE: 64, name: 0, text: 4, kind: 8, is_needed: 12, otherwise: 16, lowest: 24, highest: 32,
    words: 40,
};

export const scarp_recipe_function = { SIZE: 36, name: 0, text: 4, argument: 8, arguments: 12 };

export const scarp_gpu_octave = {
    SIZE: 160, key: 0, frequency: 12, weight: 16, amplitude: 20, slope: 24, curvature: 28,
    last: 32, share: 44, turn: 48, jacobian: 64, gradient: 112,
};

export const scarp_gpu_level = {
    SIZE: 48, basis: 0, fade: 4, fractal: 8, octaves: 12, rotate: 16, flows: 20, first: 24,
    erosion: 32, sharpness: 36, inverse_weight: 40,
};

export const scarp_gpu_plan = {
    SIZE: 5376, depth: 0, dimensions: 4, zero: 8, unit: 12, level: 16, octave: 256,
};

export const scarp_shader = { SIZE: 64, language: 0, order: 4, file: 8, length: 12 };
