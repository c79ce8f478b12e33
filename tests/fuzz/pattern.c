/* SPDX-License-Identifier: MIT
 *
 * Names of tiles: a path that is accepted gives each tile a name of its own.
 *
 * Eleven bytes of numbers, then the path.
 */
#include "terrain/pattern.h"

#include <string.h>

#include "cli.h"
#include "draw.h"
#include "fuzz.h"

static struct tiling tiling_of(struct draw *bytes)
{
    const unsigned kind = (unsigned)draw_bits(bytes, 1);
    struct tiling tiling = {.numbered = (kind & 1) != 0, .level_count = 1 + (kind >> 1) % 3};
    const size_t across = 1 + (size_t)draw_bits(bytes, 2), down = 1 + (size_t)draw_bits(bytes, 2);
    for (unsigned n = 0; n < tiling.level_count; n++) {
        tiling.levels[n].across = tiling.numbered ? ((across - 1) >> n) + 1 : 1;
        tiling.levels[n].down = tiling.numbered ? ((down - 1) >> n) + 1 : 1;
    }
    return tiling;
}

static struct tile tile_of(const struct tiling *tiling, struct draw *bytes)
{
    struct tile tile = {.level = (unsigned)draw_bits(bytes, 1) % tiling->level_count,
                        .numbered = tiling->numbered};
    const struct level *const level = &tiling->levels[tile.level];
    tile.coarser = tiling->level_count - 1 - tile.level;
    tile.x = (size_t)draw_bits(bytes, 2) % level->across;
    tile.y = (size_t)draw_bits(bytes, 2) % level->down;
    tile.up = level->down - 1 - tile.y;
    return tile;
}

int LLVMFuzzerTestOneInput(const uint8_t *input, size_t size)
{
    struct draw bytes = {input, size};
    const struct tiling tiling = tiling_of(&bytes);
    const struct tile a = tile_of(&tiling, &bytes), b = tile_of(&tiling, &bytes);
    char *const path = fuzz_text(bytes.at, bytes.left);
    fuzz_no_errors();
    const bool is_right = pattern_check(path, &tiling, "--heights");
    fuzz_must_tell(!is_right, "a pattern");
    char *const name = pattern_expand(path, &a), *const other = pattern_expand(path, &b);
    char *const manifest = pattern_manifest(path), *const pattern = pattern_of(path, a.numbered);
    MUST(name != NULL && other != NULL && manifest != NULL && pattern != NULL, "no memory");
    MUST(strlen(manifest) >= strlen(".json"), "a manifest called %s", manifest);
    if (is_right) {
        const bool is_same = a.level == b.level && a.x == b.x && a.y == b.y;
        MUST((strcmp(name, other) == 0) == is_same,
             "'%s': tiles %zu,%zu and %zu,%zu are '%s' and '%s'", path, a.x, a.y, b.x, b.y, name,
             other);
    }
    free(pattern);
    free(manifest);
    free(other);
    free(name);
    free(path);
    return 0;
}
