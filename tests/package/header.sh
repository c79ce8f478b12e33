#!/bin/sh
# SPDX-License-Identifier: MIT
# The header by itself, strictly, in the oldest and newer standards of C and C++.
. ./common.sh

case $c_compiler_id in
GNU | *Clang) ;;
*) skip "no flags known for $c_compiler_id" ;;
esac

# Twice, for the include guard, and with what no language may lay out in its own way. In C++,
# members have defaults from C++14 on, and nothing else may come of that.
program()
{
    cat <<'EOF'
#include "scarp.h"
#include "scarp.h"
#define SAME(name, a, b) typedef char name[(a) == (b) ? 1 : -1]
#define POINTERS(n) ((n) * sizeof(void *))
SAME(noise_size, sizeof(struct scarp_noise), 192);
SAME(seed_offset, offsetof(struct scarp_noise, seed), 16);
SAME(octaves_offset, offsetof(struct scarp_noise, octaves), 32);
SAME(period_offset, offsetof(struct scarp_noise, period), 64);
SAME(warp_offset, offsetof(struct scarp_noise, warp), 80);
SAME(plan_offset, offsetof(struct scarp_noise, plan), 80 + POINTERS(1));
SAME(first_offset, offsetof(struct scarp_noise, offset_first), 80 + POINTERS(2));
SAME(plan_size, sizeof(struct scarp_plan), 12288);
SAME(samples_size, sizeof(struct scarp_samples), POINTERS(16));
SAME(dphase_offset, offsetof(struct scarp_samples, dphase), POINTERS(10));
SAME(cells_size, sizeof(struct scarp_cells), POINTERS(16));
SAME(dz2_offset, offsetof(struct scarp_cells, dz2), POINTERS(11));
SAME(flow_size, sizeof(struct scarp_flow), POINTERS(16));
SAME(vzz_offset, offsetof(struct scarp_flow, vzz), POINTERS(11));
SAME(grid_size, sizeof(struct scarp_grid), 192);
SAME(count_offset, offsetof(struct scarp_grid, count), 72);
SAME(partials_size, sizeof(struct scarp_partials), POINTERS(8));
SAME(fbb_offset, offsetof(struct scarp_partials, fbb), POINTERS(5));
SAME(gullies_size, sizeof(struct scarp_gullies), 128);
SAME(keep_offset, offsetof(struct scarp_gullies, keep), 76);
SAME(first_gullies_offset, offsetof(struct scarp_gullies, offset_first), 92);
SAME(eroded_size, sizeof(struct scarp_eroded), POINTERS(16));
SAME(displacement_offset, offsetof(struct scarp_eroded, displacement_dy), POINTERS(5));
SAME(recipe_size, sizeof(struct scarp_recipe), 65536);
SAME(error_line_offset, offsetof(struct scarp_recipe_error, line), POINTERS(2));
SAME(scratch_size, sizeof(struct scarp_scratch), 64);
SAME(which_offset, offsetof(struct scarp_recipe_outputs, which), POINTERS(1));
SAME(box_size, sizeof(struct scarp_box), 48);
SAME(slider_offset, offsetof(struct scarp_recipe_entry, slider), 40);
SAME(argument_offset, offsetof(struct scarp_recipe_part, argument), 16);
SAME(words_offset, offsetof(struct scarp_recipe_argument, words),
     offsetof(struct scarp_recipe_argument, highest) + 8);
SAME(arguments_offset, offsetof(struct scarp_recipe_function, arguments), POINTERS(3));
SAME(file_offset, offsetof(struct scarp_shader, file), 8);
SAME(octave_size, sizeof(struct scarp_gpu_octave), 160);
SAME(level_size, sizeof(struct scarp_gpu_level), 48);
SAME(gpu_plan_size, sizeof(struct scarp_gpu_plan), 5376);
#ifdef SCARP_ZERO
#error "the header leaves a macro of its own behind"
#endif
#if defined(__cplusplus) && __cplusplus >= 201103L
#include <type_traits>
#define PLAIN(type)                                                                                \
    static_assert(std::is_standard_layout<type>::value &&                                          \
                      std::is_trivially_copyable<type>::value &&                                   \
                      std::is_trivially_destructible<type>::value,                                 \
                  "C lays it out likewise")
PLAIN(scarp_noise);
PLAIN(scarp_samples);
PLAIN(scarp_cells);
PLAIN(scarp_flow);
PLAIN(scarp_grid);
PLAIN(scarp_partials);
PLAIN(scarp_gullies);
PLAIN(scarp_eroded);
PLAIN(scarp_recipe_error);
PLAIN(scarp_scratch);
PLAIN(scarp_recipe_outputs);
PLAIN(scarp_box);
PLAIN(scarp_recipe_entry);
PLAIN(scarp_recipe_part);
PLAIN(scarp_recipe_argument);
PLAIN(scarp_recipe_function);
PLAIN(scarp_shader);
#define BARE(type)                                                                                 \
    static_assert(std::is_trivial<type>::value && std::is_standard_layout<type>::value,            \
                  "declaring it takes no time")
BARE(scarp_plan);
BARE(scarp_recipe);
BARE(scarp_gpu_octave);
BARE(scarp_gpu_level);
BARE(scarp_gpu_plan);
#endif
#if defined(__cplusplus) && __cplusplus >= 201402L
/* Constant only if each member has a default */
#define ZEROS(type)                                                                                \
    extern const type zero_##type;                                                                 \
    constexpr type zero_##type
ZEROS(scarp_noise);
ZEROS(scarp_samples);
ZEROS(scarp_cells);
ZEROS(scarp_flow);
ZEROS(scarp_grid);
ZEROS(scarp_partials);
ZEROS(scarp_gullies);
ZEROS(scarp_eroded);
ZEROS(scarp_recipe_error);
ZEROS(scarp_scratch);
ZEROS(scarp_recipe_outputs);
ZEROS(scarp_box);
ZEROS(scarp_recipe_entry);
ZEROS(scarp_recipe_part);
ZEROS(scarp_recipe_argument);
ZEROS(scarp_recipe_function);
ZEROS(scarp_shader);
static_assert(zero_scarp_noise.basis == SCARP_GRADIENT && zero_scarp_noise.period[2] == 0 &&
                  zero_scarp_noise.warp == nullptr && zero_scarp_noise.offset_first == 0 &&
                  zero_scarp_gullies.offset_first == 0 && zero_scarp_samples.spare[4] == nullptr,
              "members are 0 by default");
#endif
#if defined(__cplusplus) && __cplusplus >= 202002L
constexpr scarp_noise hills{.seed = 42, .frequency = 0.01, .octaves = 6};
constexpr scarp_grid tile{.step = {0.5, 0.5}, .count = {512, 512}};
constexpr scarp_gullies gullies{.depth = 0.5f};
constexpr scarp_samples samples{.dx = nullptr};
constexpr scarp_cells cells{.id = nullptr};
constexpr scarp_flow flow{.vx = nullptr};
constexpr scarp_eroded eroded{.value = nullptr};
constexpr scarp_partials partials{.f = nullptr};
constexpr scarp_scratch scratch{.size = 0};
constexpr scarp_recipe_outputs outputs{.count = 1};
constexpr scarp_shader shader{.language = SCARP_WGSL};
static_assert(hills.gain == 0 && tile.count[2] == 0 && gullies.seed == 0 &&
                  samples.value == nullptr && cells.f1 == nullptr && flow.vzz == nullptr &&
                  eroded.dx == nullptr && partials.fb == nullptr && scratch.memory == nullptr &&
                  outputs.which == nullptr && shader.order == 0,
              "what is not given is 0");
#endif
EOF
}

# check COMPILER LANGUAGE STANDARD FLAG...
check()
{
    compiler=$1 dialect=$2 standard=$3
    shift 3
    echo "$dialect, $standard $*"
    program |
        "$compiler" -x "$dialect" "-std=$standard" -I"$source_dir/include" -Wall -Wextra \
            -Wpedantic -Wconversion -Wundef -Wshadow -Werror "$@" -fsyntax-only -
}

if [ "$language" = C ]; then
    for standard in c99 c11 c17; do
        check "$c_compiler" c $standard -Wstrict-prototypes
    done
else
    check "$cxx_compiler" c++ c++98
    for standard in c++11 c++14 c++17 c++20; do
        check "$cxx_compiler" c++ $standard -Wold-style-cast
    done
    # The other compilers that are here
    for compiler in g++ clang++ clang++-14 clang++-19; do
        if echo '#include <type_traits>' | "$compiler" -x c++ -fsyntax-only - 2>/dev/null; then
            for standard in c++98 c++14 c++20; do
                check "$compiler" c++ $standard
            done
        fi
    done
fi

# The layout where pointers have 32 bits, on processors that align doubles to 4 bytes and to 8, if
# the compiler knows them. That needs no C library, which may be missing.
for processor in -m32 --target=armv7-none-eabi; do
    if echo '' | "$c_compiler" -x c "$processor" -ffreestanding -fsyntax-only - 2>/dev/null; then
        check "$c_compiler" c c11 "$processor" -ffreestanding
    else
        echo "$c_compiler does not know $processor"
    fi
done
