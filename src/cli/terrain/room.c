/* SPDX-License-Identifier: MIT
 *
 * Adds up what the tiles take, for each output and then for each disk.
 */
#include "terrain/room.h"

#include <stdio.h>

#include "shared/amount.h"
#include "shared/error.h"
#include "shared/interrupt.h"
#include "shared/space.h"

#define LARGE 1000000000 /* bytes from which a run is told before */

/* What is to be written, by output */
struct room {
    uint64_t exact[OUTPUTS_MAX], most[OUTPUTS_MAX];
};

static void add_tiles(struct job *job, struct room *room)
{
    for (size_t n = job->tiling.begin; n < job->tiling.end && !interrupted(); n++) {
        const struct tile tile = tiling_at(&job->tiling, n);
        outputs_measure(&job->outputs[0], job_level(job, tile.level), &tile, room->exact,
                        room->most);
    }
}

/* Takes off what is there. False without memory */
static bool subtract_files(struct job *job, struct room *room)
{
    struct outputs *const outputs = &job->outputs[0];
    for (size_t n = job->tiling.begin; n < job->tiling.end && !interrupted(); n++) {
        const struct tile tile = tiling_at(&job->tiling, n);
        if (!outputs_begin(outputs, job_level(job, tile.level), &tile)) {
            return false;
        }
        for (size_t i = 0; i < outputs->count; i++) {
            uint64_t *const left = room->exact[i] > 0 ? &room->exact[i] : &room->most[i];
            uint64_t size;
            struct file_time time;
            if (file_look(outputs->list[i].tile_path, &size, &time)) {
                *left -= size < *left ? size : *left;
            }
        }
    }
    return true;
}

/* What the disk of output `i` is to take of those outputs whose sizes are known */
struct disk {
    struct space space;
    uint64_t exact;
};

static bool find_disk(const struct outputs *outputs, const struct room *room, size_t i,
                      struct disk *disk)
{
    *disk = (struct disk){.exact = 0};
    if (!space_look(outputs->list[i].tile_path, &disk->space)) {
        return false;
    }
    for (size_t j = 0; j < outputs->count; j++) {
        struct space other;
        if (space_look(outputs->list[j].tile_path, &other) && other.device == disk->space.device) {
            disk->exact += room->exact[j];
        }
    }
    return true;
}

static uint64_t sum_of(const struct outputs *outputs, const struct room *room, bool *is_exact)
{
    uint64_t sum = 0;
    *is_exact = true;
    for (size_t i = 0; i < outputs->count; i++) {
        sum += room->exact[i] + room->most[i];
        *is_exact &= room->most[i] == 0;
    }
    return sum;
}

/* The first output of known size whose disk is too small; the count of outputs if there is none */
static size_t find_tight(const struct outputs *outputs, const struct room *room, struct disk *disk)
{
    size_t i = 0;
    while (i < outputs->count && (room->exact[i] == 0 || !find_disk(outputs, room, i, disk) ||
                                  disk->exact <= disk->space.bytes)) {
        i++;
    }
    return i;
}

static void tell(const struct job *job, const struct room *room)
{
    const struct outputs *const outputs = &job->outputs[0];
    const size_t tiles = job->tiling.end - job->tiling.begin;
    struct disk disk;
    bool is_exact;
    const uint64_t sum = sum_of(outputs, room, &is_exact);
    char amount[AMOUNT_SIZE];
    printf("to write: %s%s in %zu tile%s", is_exact ? "" : "at most about ",
           amount_bytes(amount, sum), tiles, tiles == 1 ? "" : "s");
    if (find_disk(outputs, room, 0, &disk)) {
        printf("; free: %s", amount_bytes(amount, disk.space.bytes));
    }
    putchar('\n');
    fflush(stdout);
}

static int tell_tight(const struct outputs *outputs, size_t tight, const struct disk *disk)
{
    char needed[AMOUNT_SIZE], there[AMOUNT_SIZE];
    amount_bytes_two(needed, disk->exact, there, disk->space.bytes);
    cli_error("%s: %s do not fit where %s are free; a smaller --size, fewer --tiles or a --share "
              "will",
              outputs->list[tight].option, needed, there);
    return CLI_USAGE;
}

int room_check(struct job *job)
{
    static struct room room;
    struct outputs *const outputs = &job->outputs[0];
    struct disk disk;
    bool is_exact;
    room = (struct room){.exact = {0}};
    if (job->tiling.begin == job->tiling.end || !outputs_are_files(outputs)) {
        return CLI_SUCCESS;
    }
    const struct tile first = tiling_at(&job->tiling, job->tiling.begin);
    add_tiles(job, &room);
    if (!outputs_begin(outputs, job_level(job, first.level), &first)) {
        return CLI_USAGE;
    }
    if (find_tight(outputs, &room, &disk) < outputs->count ||
        sum_of(outputs, &room, &is_exact) >= LARGE) {
        if (!subtract_files(job, &room)) {
            return CLI_USAGE;
        }
    }
    if (interrupted()) {
        cli_error("interrupted: nothing was written");
        return CLI_FAILURE;
    }
    const size_t tight = find_tight(outputs, &room, &disk);
    if (tight < outputs->count) {
        return tell_tight(outputs, tight, &disk);
    }
    if (sum_of(outputs, &room, &is_exact) >= LARGE && !job->options->running.quiet) {
        tell(job, &room);
    }
    return CLI_SUCCESS;
}
