/* SPDX-License-Identifier: MIT
 *
 * Adds up what the tiles take, for each product and then for each disk.
 */
#include "terrain/room.h"

#include <stdio.h>

#include "shared/amount.h"
#include "shared/error.h"
#include "shared/interrupt.h"
#include "shared/space.h"

#define LARGE 1000000000 /* bytes from which a run prints before it starts what it will take */

/* What is to be written, by product */
struct room {
    uint64_t exact[PRODUCTS_MAX], most[PRODUCTS_MAX];
};

static void add_tiles(struct job *job, struct room *room)
{
    for (size_t n = job->tiling.begin; n < job->tiling.end && !interrupted(); n++) {
        const struct tile tile = tiling_at(&job->tiling, n);
        products_measure(&job->products[0], job_level(job, tile.level), &tile, room->exact,
                         room->most);
    }
}

/* Takes off what is there. False without memory */
static bool subtract_files(struct job *job, struct room *room)
{
    struct products *const products = &job->products[0];
    for (size_t n = job->tiling.begin; n < job->tiling.end && !interrupted(); n++) {
        const struct tile tile = tiling_at(&job->tiling, n);
        if (!products_begin(products, job_level(job, tile.level), &tile)) {
            return false;
        }
        for (size_t i = 0; i < products->count; i++) {
            uint64_t *const left = room->exact[i] > 0 ? &room->exact[i] : &room->most[i];
            uint64_t size;
            struct file_time time;
            if (file_look(products->list[i].tile_path, &size, &time)) {
                *left -= size < *left ? size : *left;
            }
        }
    }
    return true;
}

/* What the disk of product `i` is to take of those products whose sizes are known */
struct disk {
    struct space space;
    uint64_t exact;
};

static bool find_disk(const struct products *products, const struct room *room, size_t i,
                      struct disk *disk)
{
    *disk = (struct disk){.exact = 0};
    if (!space_look(products->list[i].tile_path, &disk->space)) {
        return false;
    }
    for (size_t j = 0; j < products->count; j++) {
        struct space other;
        if (space_look(products->list[j].tile_path, &other) && other.device == disk->space.device) {
            disk->exact += room->exact[j];
        }
    }
    return true;
}

static uint64_t sum_of(const struct products *products, const struct room *room, bool *is_exact)
{
    uint64_t sum = 0;
    *is_exact = true;
    for (size_t i = 0; i < products->count; i++) {
        sum += room->exact[i] + room->most[i];
        *is_exact &= room->most[i] == 0;
    }
    return sum;
}

/* The first product of known size whose disk is too small; the count of products if all fit */
static size_t find_tight(const struct products *products, const struct room *room,
                         struct disk *disk)
{
    size_t i = 0;
    while (i < products->count && (room->exact[i] == 0 || !find_disk(products, room, i, disk) ||
                                   disk->exact <= disk->space.bytes)) {
        i++;
    }
    return i;
}

static void tell(const struct job *job, const struct room *room)
{
    const struct products *const products = &job->products[0];
    const size_t tiles = job->tiling.end - job->tiling.begin;
    struct disk disk;
    bool is_exact;
    const uint64_t sum = sum_of(products, room, &is_exact);
    char amount[AMOUNT_SIZE];
    printf("to write: %s%s in %zu tile%s", is_exact ? "" : "at most about ",
           amount_bytes(amount, sum), tiles, tiles == 1 ? "" : "s");
    if (find_disk(products, room, 0, &disk)) {
        printf("; free: %s", amount_bytes(amount, disk.space.bytes));
    }
    putchar('\n');
    fflush(stdout);
}

static int tell_tight(const struct products *products, size_t tight, const struct disk *disk)
{
    char needed[AMOUNT_SIZE], there[AMOUNT_SIZE];
    amount_bytes_two(needed, disk->exact, there, disk->space.bytes);
    cli_error("%s: %s do not fit where %s are free; a smaller --size, fewer --tiles or a --share "
              "will",
              products->list[tight].option, needed, there);
    return CLI_USAGE;
}

int room_check(struct job *job)
{
    static struct room room;
    struct products *const products = &job->products[0];
    struct disk disk;
    bool is_exact;
    room = (struct room){.exact = {0}};
    if (job->tiling.begin == job->tiling.end || !products_are_files(products)) {
        return CLI_SUCCESS;
    }
    const struct tile first = tiling_at(&job->tiling, job->tiling.begin);
    add_tiles(job, &room);
    if (!products_begin(products, job_level(job, first.level), &first)) {
        return CLI_USAGE;
    }
    if (find_tight(products, &room, &disk) < products->count ||
        sum_of(products, &room, &is_exact) >= LARGE) {
        if (!subtract_files(job, &room)) {
            return CLI_USAGE;
        }
    }
    if (interrupted()) {
        cli_error("interrupted: nothing was written");
        return CLI_FAILURE;
    }
    const size_t tight = find_tight(products, &room, &disk);
    if (tight < products->count) {
        return tell_tight(products, tight, &disk);
    }
    if (sum_of(products, &room, &is_exact) >= LARGE && !job->options->running.quiet) {
        tell(job, &room);
    }
    return CLI_SUCCESS;
}
