/* SPDX-License-Identifier: MIT
 *
 * Part of the modules of the npm package: holds what layout.mjs says about structures. A change
 * there must be made in both files.
 */
#include "scarp.h"

#define AT(type, member, offset)                                                                   \
    _Static_assert(offsetof(struct scarp_##type, member) == (offset), #type "." #member)
#define SIZE(type, size) _Static_assert(sizeof(struct scarp_##type) == (size), #type)

SIZE(noise, 192);
AT(noise, basis, 0);
AT(noise, fade, 4);
AT(noise, fractal, 8);
AT(noise, rotate, 12);
AT(noise, seed, 16);
AT(noise, frequency, 24);
AT(noise, octaves, 32);
AT(noise, lacunarity, 36);
AT(noise, gain, 40);
AT(noise, amplitude, 44);
AT(noise, erosion, 48);
AT(noise, phase, 52);
AT(noise, jitter, 56);
AT(noise, sharpness, 60);
AT(noise, period, 64);
AT(noise, of_octaves, 76);
AT(noise, warp, 80);
AT(noise, plan, 84);

SIZE(grid, 192);
AT(grid, origin, 0);
AT(grid, step, 24);
AT(grid, first, 48);
AT(grid, count, 72);
AT(grid, row_stride, 84);
AT(grid, slice_stride, 88);

SIZE(samples, 64);
AT(samples, dphase, 40);
SIZE(cells, 64);
AT(cells, dz2, 44);
SIZE(flow, 64);
AT(flow, vzz, 44);
SIZE(partials, 32);
AT(partials, fbb, 20);

SIZE(recipe, 65536);
SIZE(recipe_error, 56);
AT(recipe_error, text, 16);
AT(recipe_error, nearest, 24);
SIZE(recipe_entry, 112);
AT(recipe_entry, name, 8);
AT(recipe_entry, kind, 16);
AT(recipe_entry, is_param, 20);
AT(recipe_entry, output, 24);
AT(recipe_entry, part, 28);
AT(recipe_entry, value, 32);
AT(recipe_entry, slider, 40);
AT(recipe_entry, range, 56);
AT(recipe_entry, axes, 64);
AT(recipe_entry, order, 68);
AT(recipe_entry, hash, 72);
SIZE(recipe_part, 112);
AT(recipe_part, name, 8);
AT(recipe_part, argument, 16);
AT(recipe_part, kind, 24);
AT(recipe_part, function, 28);
AT(recipe_part, entry, 32);
AT(recipe_part, parent, 36);
AT(recipe_part, operation, 40);
AT(recipe_part, axes, 44);
AT(recipe_part, order, 48);
AT(recipe_part, range, 52);
AT(recipe_part, value, 64);
AT(recipe_part, hash, 72);
SIZE(recipe_argument, 64);
AT(recipe_argument, kind, 8);
AT(recipe_argument, is_needed, 12);
AT(recipe_argument, otherwise, 16);
AT(recipe_argument, words, 40);
SIZE(recipe_function, 36);
AT(recipe_function, argument, 8);
AT(recipe_function, arguments, 12);
SIZE(box, 48);
_Static_assert(SCARP_RECIPE_KNOT == 5, "kinds");
_Static_assert(SCARP_RECIPE_PARTS == 65536, "parts");
SIZE(recipe_outputs, 48);
AT(recipe_outputs, which, 4);
AT(recipe_outputs, count, 8);
SIZE(scratch, 56);
AT(scratch, size, 4);

SIZE(plan, 12288);
SIZE(gpu_plan, 5376);
_Static_assert(SCARP_GPU_ANSWERS == 4096, "answers");
AT(shader, order, 4);
AT(shader, file, 8);
AT(shader, length, 12);
SIZE(shader, 64);
_Static_assert(SCARP_GLSL == 0 && SCARP_HLSL == 1 && SCARP_WGSL == 2, "languages");
