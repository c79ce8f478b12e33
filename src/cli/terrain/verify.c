/* SPDX-License-Identifier: MIT
 *
 * Reads every file once, in the order of the tiles.
 */
#include "terrain/verify.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include "shared/amount.h"
#include "shared/error.h"
#include "shared/hash.h"
#include "shared/interrupt.h"
#include "shared/path.h"

#define TOLD_MOST 20 /* files that are named one by one */

struct verification {
    struct job *job;
    struct sums_list list;
    size_t right, missing, changed, unknown;
    uint64_t bytes;
};

/* Tells what is wrong with a file, of the first ones that are. */
static void tell(struct verification *to, size_t *count, const char *path, const char *what)
{
    ++*count;
    if (to->missing + to->changed + to->unknown <= TOLD_MOST) {
        progress_end(&to->job->progress, false);
        cli_error("%s: %s", path, what);
    }
}

/* False without memory */
static bool look_at(struct verification *to, const char *path)
{
    const struct manifest *const manifest = &to->job->manifest;
    uint64_t size, hash;
    struct file_time time;
    if (!file_look(path, &size, &time)) {
        tell(to, &to->missing, path, "is missing");
        return true;
    }
    if (file_is_older(time, manifest->time)) {
        tell(to, &to->changed, path, "is older than the manifest");
        return true;
    }
    if (!hash_file(path, &hash)) {
        if (interrupted()) {
            return true; /* the caller sees that, too */
        }
        tell(to, &to->changed, path, file_reason(errno));
        return true;
    }
    char *const relative = path_relative(path, manifest->path);
    if (relative == NULL) {
        return false;
    }
    to->bytes += size;
    switch (sums_find(&to->list, relative, hash)) {
    case SUMS_SAME: to->right++; break;
    case SUMS_DIFFERENT: tell(to, &to->changed, path, "differs from what was written"); break;
    default: tell(to, &to->unknown, path, "has no checksum"); break;
    }
    free(relative);
    return true;
}

/* The files of a tile. False without memory */
static bool look_at_tile(struct verification *to, const struct tile *tile)
{
    struct job *const job = to->job;
    struct products *const products = &job->products[0];
    if (!products_begin(products, job_level(job, tile->level), tile)) {
        return false;
    }
    for (size_t i = 0; i < products->count; i++) {
        const struct product *const product = &products->list[i];
        char *const beside =
            product->format->beside != NULL ? product->format->beside(product->tile_path) : NULL;
        const bool is_done =
            look_at(to, product->tile_path) && (beside == NULL || look_at(to, beside));
        free(beside);
        if (!is_done) {
            cli_error("%s: no memory", product->option);
            return false;
        }
    }
    return true;
}

static int tell_result(const struct verification *of)
{
    const size_t all = of->right + of->missing + of->changed + of->unknown;
    if (of->right < all) {
        cli_error("--verify: of %zu files %zu are missing, %zu changed and %zu without a checksum",
                  all, of->missing, of->changed, of->unknown);
        return CLI_FAILURE;
    }
    if (!of->job->options->running.quiet) {
        char size[AMOUNT_SIZE];
        printf("%zu file%s, %s: as %s written\n", all, all == 1 ? "" : "s",
               amount_bytes(size, of->bytes), all == 1 ? "it was" : "they were");
    }
    return CLI_SUCCESS;
}

int verify_files(struct job *job)
{
    static struct verification verification;
    const struct tiling *const tiling = &job->tiling;
    verification = (struct verification){.job = job};
    if (!sums_read(&verification.list, job->manifest.path)) {
        cli_error("--verify: %s: %s", job->manifest.path, file_reason(errno));
        sums_free(&verification.list);
        return CLI_FAILURE;
    }
    progress_start(&job->progress, tiling->end - tiling->begin, job->options->running.quiet != 0);
    bool is_done = true;
    for (size_t n = tiling->begin; n < tiling->end && is_done && !interrupted(); n++) {
        const struct tile tile = tiling_at(tiling, n);
        is_done = look_at_tile(&verification, &tile);
        progress_add(&job->progress, 1);
    }
    progress_end(&job->progress, is_done && !interrupted());
    sums_free(&verification.list);
    if (interrupted()) {
        cli_error("interrupted: not all files were checked");
    }
    return is_done && !interrupted() ? tell_result(&verification) : CLI_FAILURE;
}
