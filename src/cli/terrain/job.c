/* SPDX-License-Identifier: MIT
 *
 * Takes each tile of a run: claims it, looks for its files, writes and finishes them.
 */
#include "terrain/job.h"

#include <errno.h>

#include "shared/error.h"
#include "shared/interrupt.h"
#include "terrain/pipeline.h"

/* Tells why a tile was not written, and returns the exit status of that. */
static int tell_failure(struct job *job, const struct products *products, const struct tile *tile,
                        enum pipeline_result result)
{
    progress_end(&job->progress, false);
    if (interrupted()) { /* which also ends writes that wait, and the opening of a pipe */
        cli_error("interrupted: unfinished files are removed%s",
                  job->tiling.numbered ? ", finished tiles stay; see --resume" : "");
        return CLI_FAILURE;
    }
    if (result == PIPELINE_NO_MEMORY) {
        cli_error("no memory for rows of %zu samples", tile->width);
        return CLI_FAILURE;
    }
    const struct product *product = products->list;
    while (!product->failed) {
        product++;
    }
    product_error(product);
    /* A file that cannot be had is the command line's fault, a reader that has gone is not. */
    return result == PIPELINE_NOT_OPENED && product->reason != EPIPE && job->written == 0
               ? CLI_USAGE
               : CLI_FAILURE;
}

/* Before files have their names: no file of a run that is killed is without its checksum. */
static bool keep_sums(struct job *job, struct products *products)
{
    const bool kept = job->manifest.file == NULL || sums_keep(&job->sums, products);
    job->sums_reason = kept ? 0 : errno;
    return kept;
}

static void finish(void *context)
{
    struct job *const job = context;
    struct products *const products = &job->products[1 - job->turn];
    const bool is_complete = products_complete(products) && keep_sums(job, products);
    job->is_orphan = is_complete && !manifest_is_there(&job->manifest);
    job->is_finished = is_complete && !job->is_orphan && products_publish(products);
}

/* No tile takes its name next to the manifest of another world, for which it would be taken. */
static int finish_orphan(struct job *job)
{
    progress_end(&job->progress, false);
    const int status = manifest_open_again(&job->manifest);
    job->is_finished = status == CLI_SUCCESS && products_publish(&job->products[1 - job->turn]);
    return status;
}

/* Lets the tile at hand reach the disk while the next one is made. Pipes may keep it waiting, which
   only signals end, so they do not go aside. */
static void start_finishing(struct job *job, const struct tile *tile)
{
    const bool waits = products_wait(&job->products[job->turn]);
    job->last = *tile;
    job->is_finishing = true;
    job->turn = 1 - job->turn;
    if (waits) {
        finish(job);
    } else {
        crew_start_aside(job->crew, finish, job);
    }
}

static int tell_sums(struct job *job)
{
    progress_end(&job->progress, false);
    cli_error("%s: %s: %s", job->manifest.option, job->sums.path, file_reason(job->sums_reason));
    return CLI_FAILURE;
}

/* Waits until the tile before is finished. */
static int end_finishing(struct job *job)
{
    if (!job->is_finishing) {
        return CLI_SUCCESS;
    }
    crew_wait_aside(job->crew);
    job->is_finishing = false;
    struct products *const products = &job->products[1 - job->turn];
    int status = job->is_orphan ? finish_orphan(job) : CLI_SUCCESS;
    if (job->is_finished) {
        job->written++;
        job->samples += (uint64_t)job->last.width * job->last.height;
    } else {
        if (status == CLI_SUCCESS) {
            status = job->sums_reason != 0 && !interrupted()
                         ? tell_sums(job)
                         : tell_failure(job, products, &job->last, PIPELINE_FAILED);
        }
        /* The tile at hand may lie in directories that were made for this one. */
        products_discard(&job->products[job->turn]);
    }
    products_discard(products);
    manifest_release(&job->manifest, job->last.number);
    return status;
}

static int write_tile(struct job *job, const struct tile *tile)
{
    struct products *const products = &job->products[job->turn];
    const enum pipeline_result result =
        products_open(products, job->manifest.file)
            ? pipeline_run(&job->level, tile, products, job->crew, &job->progress)
            : PIPELINE_NOT_OPENED;
    int status = end_finishing(job);
    if (status == CLI_SUCCESS && result == PIPELINE_DONE) {
        start_finishing(job, tile);
        return CLI_SUCCESS;
    }
    if (status == CLI_SUCCESS) {
        status = tell_failure(job, products, tile, result);
    }
    products_discard(products);
    return status;
}

enum tile_state { TILE_MISSING, TILE_THERE, TILE_BUSY };

/* Claims the tile, unless it need not be written. */
static enum tile_state claim(const struct job *job, const struct tile *tile)
{
    const struct products *const products = &job->products[job->turn];
    const bool resume = job->options->resume != 0;
    if (resume && products_are_there(products, job->manifest.time)) {
        return TILE_THERE;
    }
    const bool claimed = manifest_claim(&job->manifest, tile->number);
    if (!resume) {
        return TILE_MISSING;
    }
    if (!claimed) {
        return TILE_BUSY;
    }
    /* Another run may have finished it just before the claim. */
    if (products_are_there(products, job->manifest.time)) {
        manifest_release(&job->manifest, tile->number);
        return TILE_THERE;
    }
    return TILE_MISSING;
}

const struct surface *job_level(struct job *job, unsigned level)
{
    if (!job->has_level || job->level_number != level) {
        surface_set_level(&job->surface, level, job->options->band_limit != 0, &job->level);
        job->level_number = level;
        job->has_level = true;
    }
    return &job->level;
}

/* Writes tile number `n` of the range, if need be. */
static int visit_tile(struct job *job, size_t n)
{
    const struct tile tile = tiling_at(&job->tiling, n);
    struct products *const products = &job->products[job->turn];
    if (!products_begin(products, job_level(job, tile.level), &tile)) {
        return CLI_FAILURE;
    }
    const enum tile_state state = claim(job, &tile);
    if (state == TILE_MISSING || interrupted()) {
        return write_tile(job, &tile);
    }
    job->busy += state == TILE_BUSY ? 1 : 0;
    products_sweep(products);
    progress_skip(&job->progress, tile.height);
    return CLI_SUCCESS;
}

static int visit_tiles(struct job *job)
{
    int status = CLI_SUCCESS;
    job->busy = 0;
    for (size_t n = job->tiling.begin; n < job->tiling.end && status == CLI_SUCCESS; n++) {
        status = visit_tile(job, n);
    }
    const int finished = end_finishing(job);
    return status != CLI_SUCCESS ? status : finished;
}

int job_run(struct job *job)
{
    uint64_t rows = 0;
    for (size_t n = job->tiling.begin; n < job->tiling.end; n++) {
        rows += tiling_at(&job->tiling, n).height;
    }
    progress_start(&job->progress, rows, job->options->running.quiet != 0);
    int status = visit_tiles(job);
    if (status == CLI_SUCCESS && job->busy > 0) {
        /* The run that had them may have ended without writing them. */
        status = visit_tiles(job);
    }
    progress_end(&job->progress, status == CLI_SUCCESS);
    return status;
}
