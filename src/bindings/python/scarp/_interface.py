# SPDX-License-Identifier: MIT
"""Tables of scarp.h. Made by src/bindings/interface.py; do not change them by hand.

Where the sizes of pointers matter, a number is two: for 4 bytes, and for 8.
"""
VERSION = '0.2.0'

CONSTANTS = {
    'SCARP_VERSION_MAJOR': 0,
    'SCARP_VERSION_MINOR': 2,
    'SCARP_VERSION_PATCH': 0,
    'SCARP_CURVE_KNOTS': 64,
    'SCARP_RECIPE_PARTS': 65536,
    'SCARP_RECIPE_OUTPUT': -1,
    'SCARP_GPU_ANSWERS': 4096,
}

ENUMS = {
    'scarp_status': {
        'SCARP_OK': 0,
        'SCARP_ERROR_NULL': 1,
        'SCARP_ERROR_ENUM': 2,
        'SCARP_ERROR_PARAMETER': 3,
        'SCARP_ERROR_SIZE': 4,
        'SCARP_ERROR_UNSUPPORTED': 5,
    },
    'scarp_basis': {
        'SCARP_GRADIENT': 0,
        'SCARP_VALUE': 1,
        'SCARP_SIMPLEX': 2,
        'SCARP_CELL_F1': 3,
        'SCARP_CELL_F2': 4,
        'SCARP_CELL_EDGE': 5,
        'SCARP_CELL_SOFT': 6,
        'SCARP_CELL_VALUE': 7,
    },
    'scarp_fade': {
        'SCARP_QUINTIC': 0,
        'SCARP_CUBIC': 1,
    },
    'scarp_fractal': {
        'SCARP_FBM': 0,
        'SCARP_TURBULENCE': 1,
        'SCARP_RIDGED': 2,
        'SCARP_EROSION': 3,
        'SCARP_PINGPONG': 4,
        'SCARP_HYBRID': 5,
        'SCARP_SWISS': 6,
        'SCARP_JORDAN': 7,
    },
    'scarp_recipe_kind': {
        'SCARP_RECIPE_BAD': 0,
        'SCARP_RECIPE_NUMBER': 1,
        'SCARP_RECIPE_FIELD': 2,
        'SCARP_RECIPE_NOISE': 3,
        'SCARP_RECIPE_WORD': 4,
        'SCARP_RECIPE_KNOT': 5,
    },
    'scarp_language': {
        'SCARP_GLSL': 0,
        'SCARP_HLSL': 1,
        'SCARP_WGSL': 2,
    },
    'scarp_isa': {
        'SCARP_ISA_NONE': 0,
        'SCARP_ISA_SCALAR': 1,
        'SCARP_ISA_SSE41': 2,
        'SCARP_ISA_AVX2': 3,
        'SCARP_ISA_AVX512': 4,
        'SCARP_ISA_NEON': 5,
        'SCARP_ISA_GENERIC': 6,
        'SCARP_ISA_WASM128': 7,
    },
}

# size, then name, type and lengths of each member
STRUCTURES = {
    'scarp_noise': (192, (
        ('basis', 'i4', ()),
        ('fade', 'i4', ()),
        ('fractal', 'i4', ()),
        ('rotate', 'u4', ()),
        ('seed', 'u8', ()),
        ('frequency', 'f8', ()),
        ('octaves', 'f4', ()),
        ('lacunarity', 'f4', ()),
        ('gain', 'f4', ()),
        ('amplitude', 'f4', ()),
        ('erosion', 'f4', ()),
        ('phase', 'f4', ()),
        ('jitter', 'f4', ()),
        ('sharpness', 'f4', ()),
        ('period', 'u4', (3,)),
        ('of_octaves', 'f4', ()),
        ('warp', 'pointer', ()),
        ('plan', 'pointer', ()),
        ('offset_first', 'u4', ()),
        ('spare_word', 'u4', ()),
        ('spare', 'u4', ((24, 22),)),
    )),
    'scarp_samples': ((64, 128), (
        ('value', 'pointer', ()),
        ('dx', 'pointer', ()),
        ('dy', 'pointer', ()),
        ('dz', 'pointer', ()),
        ('dxx', 'pointer', ()),
        ('dxy', 'pointer', ()),
        ('dxz', 'pointer', ()),
        ('dyy', 'pointer', ()),
        ('dyz', 'pointer', ()),
        ('dzz', 'pointer', ()),
        ('dphase', 'pointer', ()),
        ('spare', 'pointer', (5,)),
    )),
    'scarp_grid': (192, (
        ('origin', 'f8', (3,)),
        ('step', 'f8', (3,)),
        ('first', 'i8', (3,)),
        ('count', 'size', (3,)),
        ('row_stride', 'size', ()),
        ('slice_stride', 'size', ()),
        ('spare', 'u4', ((25, 20),)),
    )),
    'scarp_plan': (12288, (
        ('first', 'u8', ()),
        ('rest', 'u1', (12280,)),
    )),
    'scarp_flow': ((64, 128), (
        ('vx', 'pointer', ()),
        ('vy', 'pointer', ()),
        ('vz', 'pointer', ()),
        ('vxx', 'pointer', ()),
        ('vxy', 'pointer', ()),
        ('vxz', 'pointer', ()),
        ('vyx', 'pointer', ()),
        ('vyy', 'pointer', ()),
        ('vyz', 'pointer', ()),
        ('vzx', 'pointer', ()),
        ('vzy', 'pointer', ()),
        ('vzz', 'pointer', ()),
        ('spare', 'pointer', (4,)),
    )),
    'scarp_cells': ((64, 128), (
        ('f1', 'pointer', ()),
        ('f2', 'pointer', ()),
        ('id', 'pointer', ()),
        ('x', 'pointer', ()),
        ('y', 'pointer', ()),
        ('z', 'pointer', ()),
        ('dx1', 'pointer', ()),
        ('dy1', 'pointer', ()),
        ('dz1', 'pointer', ()),
        ('dx2', 'pointer', ()),
        ('dy2', 'pointer', ()),
        ('dz2', 'pointer', ()),
        ('spare', 'pointer', (4,)),
    )),
    'scarp_partials': ((32, 64), (
        ('f', 'pointer', ()),
        ('fa', 'pointer', ()),
        ('fb', 'pointer', ()),
        ('faa', 'pointer', ()),
        ('fab', 'pointer', ()),
        ('fbb', 'pointer', ()),
        ('spare', 'pointer', (2,)),
    )),
    'scarp_gullies': (128, (
        ('seed', 'u8', ()),
        ('frequency', 'f8', ()),
        ('amplitude', 'f4', ()),
        ('octaves', 'f4', ()),
        ('of_octaves', 'f4', ()),
        ('lacunarity', 'f4', ()),
        ('gain', 'f4', ()),
        ('depth', 'f4', ()),
        ('cells', 'f4', ()),
        ('slope', 'f4', ()),
        ('slope_low', 'f4', ()),
        ('low', 'f4', ()),
        ('high', 'f4', ()),
        ('floor', 'f4', ()),
        ('stripes', 'f4', ()),
        ('branch', 'f4', ()),
        ('round', 'f4', ()),
        ('keep', 'f4', ()),
        ('period', 'u4', (2,)),
        ('rotate', 'u4', ()),
        ('offset_first', 'u4', ()),
        ('spare', 'u4', (8,)),
    )),
    'scarp_eroded': ((64, 128), (
        ('value', 'pointer', ()),
        ('dx', 'pointer', ()),
        ('dy', 'pointer', ()),
        ('displacement', 'pointer', ()),
        ('displacement_dx', 'pointer', ()),
        ('displacement_dy', 'pointer', ()),
        ('spare', 'pointer', (10,)),
    )),
    'scarp_recipe': (65536, (
        ('first', 'u8', ()),
        ('rest', 'u1', (65528,)),
    )),
    'scarp_recipe_error': ((56, 72), (
        ('from', 'size', ()),
        ('to', 'size', ()),
        ('line', 'i4', ()),
        ('column', 'i4', ()),
        ('text', 'text', ()),
        ('member', 'text', ()),
        ('nearest', 'f8', ()),
        ('spare', 'u4', (6,)),
    )),
    'scarp_scratch': (64, (
        ('memory', 'pointer', ()),
        ('size', 'size', ()),
        ('plan', 'pointer', ()),
        ('spare', 'u4', ((13, 10),)),
    )),
    'scarp_recipe_outputs': ((48, 56), (
        ('out', 'pointer', ()),
        ('which', 'pointer', ()),
        ('count', 'i4', ()),
        ('spare', 'u4', (9,)),
    )),
    'scarp_box': (48, (
        ('lowest', 'f8', (3,)),
        ('highest', 'f8', (3,)),
    )),
    'scarp_recipe_entry': (112, (
        ('span', 'u4', (2,)),
        ('name', 'u4', (2,)),
        ('kind', 'i4', ()),
        ('is_param', 'i4', ()),
        ('output', 'i4', ()),
        ('part', 'i4', ()),
        ('value', 'f8', ()),
        ('slider', 'f8', (2,)),
        ('range', 'f4', (2,)),
        ('axes', 'u4', ()),
        ('order', 'u4', ()),
        ('hash', 'u8', ()),
        ('cell', 'f8', (2,)),
        ('jumps', 'u4', ()),
        ('dimensions', 'u4', ()),
        ('spare', 'u4', (2,)),
    )),
    'scarp_recipe_part': (112, (
        ('span', 'u4', (2,)),
        ('name', 'u4', (2,)),
        ('argument', 'u4', (2,)),
        ('kind', 'i4', ()),
        ('function', 'i4', ()),
        ('entry', 'i4', ()),
        ('parent', 'i4', ()),
        ('operation', 'i4', ()),
        ('axes', 'u4', ()),
        ('order', 'u4', ()),
        ('range', 'f4', (2,)),
        ('value', 'f8', ()),
        ('hash', 'u8', ()),
        ('spare', 'u4', (8,)),
    )),
    'scarp_recipe_argument': ((64, 72), (
        ('name', 'text', ()),
        ('text', 'text', ()),
        ('kind', 'i4', ()),
        ('is_needed', 'i4', ()),
        ('otherwise', 'f8', ()),
        ('lowest', 'f8', ()),
        ('highest', 'f8', ()),
        ('words', 'pointer', ()),
        ('spare', 'u4', (4,)),
    )),
    'scarp_recipe_function': ((36, 48), (
        ('name', 'text', ()),
        ('text', 'text', ()),
        ('argument', 'pointer', ()),
        ('arguments', 'i4', ()),
        ('spare', 'u4', (5,)),
    )),
    'scarp_gpu_octave': (160, (
        ('key', 'u4', (3,)),
        ('frequency', 'f4', ()),
        ('weight', 'f4', ()),
        ('amplitude', 'f4', ()),
        ('slope', 'f4', ()),
        ('curvature', 'f4', ()),
        ('last', 'u4', (3,)),
        ('share', 'f4', ()),
        ('turn', 'f4', (4,)),
        ('jacobian', 'f4', (3, 4)),
        ('gradient', 'f4', (3, 4)),
    )),
    'scarp_gpu_level': (48, (
        ('basis', 'u4', ()),
        ('fade', 'u4', ()),
        ('fractal', 'u4', ()),
        ('octaves', 'u4', ()),
        ('rotate', 'u4', ()),
        ('flows', 'u4', ()),
        ('first', 'u4', ()),
        ('spare0', 'u4', ()),
        ('erosion', 'f4', ()),
        ('sharpness', 'f4', ()),
        ('inverse_weight', 'f4', ()),
        ('spare1', 'f4', ()),
    )),
    'scarp_gpu_plan': (5376, (
        ('depth', 'u4', ()),
        ('dimensions', 'u4', ()),
        ('zero', 'u4', ()),
        ('unit', 'f4', ()),
        ('level', 'scarp_gpu_level', (5,)),
        ('octave', 'scarp_gpu_octave', (32,)),
    )),
    'scarp_shader': ((64, 72), (
        ('language', 'i4', ()),
        ('order', 'i4', ()),
        ('file', 'text', ()),
        ('length', 'size', ()),
        ('spare', 'u4', (12,)),
    )),
}

# what 0 stands for, where that is another number
DEFAULTS = {
    'scarp_noise': {
        'frequency': 1.0,
        'octaves': 1.0,
        'lacunarity': 2.0,
        'gain': 0.5,
        'amplitude': 1.0,
        'erosion': 1.0,
        'phase': 0.0,
        'jitter': 1.0,
    },
    'scarp_gullies': {
        'frequency': 1.0,
        'amplitude': 1.0,
        'octaves': 5.0,
        'lacunarity': 2.0,
        'gain': 0.45,
        'depth': 0.25,
        'cells': 3.0,
        'slope': 1.125,
        'slope_low': 1.75,
        'low': -1.0,
        'high': 1.0,
        'floor': 0.5,
        'stripes': 1.5,
        'branch': 0.8,
        'round': 0.15,
        'keep': 1.0,
    },
}

# result, then arguments
FUNCTIONS = {
    'scarp_sample2': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_sample3': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_sample2_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_sample3_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_grid2': ('i4', (
        'pointer', 'pointer', 'pointer',
    )),
    'scarp_grid3': ('i4', (
        'pointer', 'pointer', 'pointer',
    )),
    'scarp_normals': ('i4', (
        'size', 'pointer', 'pointer', 'f4', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_range': ('i4', (
        'pointer', 'i4', 'pointer', 'pointer',
    )),
    'scarp_noise_check': ('i4', (
        'pointer', 'i4', 'pointer',
    )),
    'scarp_noise_fault': ('text', (
        'pointer', 'i4', 'i4', 'i4', 'pointer',
    )),
    'scarp_grid_fault': ('text', (
        'pointer', 'i4', 'pointer',
    )),
    'scarp_plan_make': ('i4', (
        'pointer', 'i4', 'pointer',
    )),
    'scarp_vector_plan_make': ('i4', (
        'pointer', 'i4', 'pointer',
    )),
    'scarp_vector2': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_vector3': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_vector2_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_vector3_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_curl2': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_curl3': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_curl2_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_curl3_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_cells2': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_cells3': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_cells2_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_cells3_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_affine': ('i4', (
        'size', 'pointer', 'f4', 'f4', 'pointer',
    )),
    'scarp_add': ('i4', (
        'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_multiply': ('i4', (
        'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_mix': ('i4', (
        'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_min': ('i4', (
        'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_max': ('i4', (
        'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_smooth_min': ('i4', (
        'size', 'pointer', 'pointer', 'f4', 'pointer',
    )),
    'scarp_smooth_max': ('i4', (
        'size', 'pointer', 'pointer', 'f4', 'pointer',
    )),
    'scarp_clamp': ('i4', (
        'size', 'pointer', 'f4', 'f4', 'pointer',
    )),
    'scarp_abs': ('i4', (
        'size', 'pointer', 'pointer',
    )),
    'scarp_smooth_abs': ('i4', (
        'size', 'pointer', 'f4', 'pointer',
    )),
    'scarp_smoothstep': ('i4', (
        'size', 'pointer', 'f4', 'f4', 'pointer',
    )),
    'scarp_terrace': ('i4', (
        'size', 'pointer', 'f4', 'f4', 'f4', 'pointer',
    )),
    'scarp_divide': ('i4', (
        'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_sqrt': ('i4', (
        'size', 'pointer', 'pointer',
    )),
    'scarp_sine': ('i4', (
        'size', 'pointer', 'pointer',
    )),
    'scarp_pulse': ('i4', (
        'size', 'pointer', 'pointer',
    )),
    'scarp_curve': ('i4', (
        'size', 'pointer', 'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_slope': ('i4', (
        'size', 'pointer', 'pointer',
    )),
    'scarp_apply1': ('i4', (
        'size', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_apply2': ('i4', (
        'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_gullies2': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_gullies2_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_gullies_grid2': ('i4', (
        'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_gullies_range': ('i4', (
        'pointer', 'f4', 'f4', 'pointer', 'pointer',
    )),
    'scarp_gullies_check': ('i4', (
        'pointer', 'pointer',
    )),
    'scarp_gullies_fault': ('text', (
        'pointer', 'pointer',
    )),
    'scarp_recipe_parse': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'size', 'pointer',
    )),
    'scarp_recipe_seed': ('i4', (
        'pointer', 'u8',
    )),
    'scarp_recipe_set': ('i4', (
        'pointer', 'pointer', 'f8', 'pointer',
    )),
    'scarp_recipe_tile': ('i4', (
        'pointer', 'f8', 'f8', 'f8', 'pointer',
    )),
    'scarp_recipe_scale': ('i4', (
        'pointer', 'f8', 'f8', 'pointer',
    )),
    'scarp_recipe_sample': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_recipe_sample_f64': ('i4', (
        'pointer', 'size', 'pointer', 'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_recipe_grid': ('i4', (
        'pointer', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_recipe_scratch_size': ('size', (
        'pointer', 'i4', 'size',
    )),
    'scarp_recipe_plan_size': ('size', (
        'pointer',
    )),
    'scarp_recipe_plan_make': ('i4', (
        'pointer', 'pointer', 'size',
    )),
    'scarp_recipe_range': ('i4', (
        'pointer', 'i4', 'pointer', 'pointer', 'pointer',
    )),
    'scarp_recipe_entry_at': ('i4', (
        'pointer', 'size', 'pointer',
    )),
    'scarp_recipe_part_at': ('i4', (
        'pointer', 'size', 'pointer',
    )),
    'scarp_recipe_function_at': ('i4', (
        'size', 'pointer',
    )),
    'scarp_gpu_plan_make': ('i4', (
        'pointer', 'i4', 'pointer', 'pointer',
    )),
    'scarp_gpu_vector_plan_make': ('i4', (
        'pointer', 'i4', 'pointer', 'pointer',
    )),
    'scarp_gpu_plan_fault': ('text', (
        'pointer', 'i4', 'i4', 'pointer',
    )),
    'scarp_gpu_answers': ('i4', (
        'pointer', 'i4', 'i4', 'pointer',
    )),
    'scarp_recipe_shader': ('i4', (
        'pointer', 'pointer', 'pointer', 'size', 'pointer',
    )),
    'scarp_recipe_uniforms': ('i4', (
        'pointer', 'pointer', 'size', 'pointer',
    )),
    'scarp_recipe_answers': ('i4', (
        'pointer', 'i4', 'pointer',
    )),
    'scarp_basis_name': ('text', (
        'i4',
    )),
    'scarp_fade_name': ('text', (
        'i4',
    )),
    'scarp_fractal_name': ('text', (
        'i4',
    )),
    'scarp_status_text': ('text', (
        'i4',
    )),
    'scarp_version': ('text', (
    )),
    'scarp_isa_active': ('i4', (
    )),
    'scarp_isa_supported': ('i4', (
        'i4',
    )),
    'scarp_isa_select': ('i4', (
        'i4',
    )),
    'scarp_isa_name': ('text', (
        'i4',
    )),
}
