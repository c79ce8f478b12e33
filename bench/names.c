/* SPDX-License-Identifier: MIT
 *
 * The names of workloads. They are made from the same fields that the measurement reads, so they
 * cannot disagree.
 */
#include "work.h"

#include <stdio.h>

static const char *const layout_names[] = {"points", "grid",    "normals", "product",    "vector",
                                           "curl",   "gullies", "recipe",  "recipe-grid"};
static const char *const pattern_names[] = {"", "/sequential", "/same-cell"};
static const char *const warp_names[] = {"", "/warped", "/warped-by-value"};
static const char *const output_names[BENCH_OUTPUTS] = {
    "value", "+gradient", "+hessian", "+dphase", "forward-differences", "central-differences"};

/* The edges of a grid: one number if they are equal */
static void write_edges(char *text, size_t size, const struct bench_work *work)
{
    const size_t *const n = work->grid;
    const int in_space = work->dimensions == 3;
    if (n[0] == n[1] && (!in_space || n[1] == n[2])) {
        snprintf(text, size, "%zu", n[0]);
    } else if (!in_space) {
        snprintf(text, size, "%zux%zu", n[0], n[1]);
    } else {
        snprintf(text, size, "%zux%zux%zu", n[0], n[1], n[2]);
    }
}

void bench_work_write_name(struct bench_work *work)
{
    if (work->layout == BENCH_NORMALS) {
        snprintf(work->name, sizeof work->name, "%s", layout_names[work->layout]);
        return;
    }
    if (work->layout == BENCH_PRODUCT) {
        snprintf(work->name, sizeof work->name, "%s%d/%s/n=%zu", layout_names[work->layout],
                 work->dimensions, output_names[work->output], work->points);
        return;
    }
    if (work->layout == BENCH_GULLIES) {
        snprintf(work->name, sizeof work->name, "%s%d/octaves%d%s%s/%s/n=%zu",
                 layout_names[work->layout], work->dimensions, work->octaves,
                 work->turned ? "/turned" : "", work->f64 ? "/f64" : "", output_names[work->output],
                 work->points);
        return;
    }
    if (work->layout == BENCH_RECIPE) {
        snprintf(work->name, sizeof work->name, "%s%d/%s%s/%s/n=%zu", layout_names[work->layout],
                 work->dimensions, work->title, work->f64 ? "/f64" : "", output_names[work->output],
                 work->points);
        return;
    }
    char fade[16] = "", fractal[32] = "", title[32] = "", size[72] = "", period[24] = "", edges[32];
    write_edges(edges, sizeof edges, work);
    if (work->layout == BENCH_RECIPE_GRID) {
        snprintf(work->name, sizeof work->name, "%s%d/%s/%s/%s", layout_names[work->layout],
                 work->dimensions, work->title, output_names[work->output], edges);
        return;
    }
    if (work->fade != SCARP_QUINTIC) {
        snprintf(fade, sizeof fade, "/%s", scarp_fade_name(work->fade));
    }
    if (work->octaves > 1) {
        snprintf(fractal, sizeof fractal, "/%s%d", scarp_fractal_name(work->fractal),
                 work->octaves);
    }
    if (work->title != NULL) {
        snprintf(title, sizeof title, "/%s", work->title);
    }
    if (work->layout == BENCH_GRID) {
        snprintf(size, sizeof size, "/%s%s/step%g", edges, work->as_points ? "/as-points" : "",
                 (double)work->step);
    } else if (work->points != BENCH_STANDARD_POINTS) {
        snprintf(size, sizeof size, "/n=%zu", work->points);
    }
    if (work->period != 0) {
        snprintf(period, sizeof period, "/period%u", work->period);
    }
    snprintf(work->name, sizeof work->name, "%s%d/%s%s%s%s%s%s%s%s%s%s/%s%s",
             layout_names[work->layout], work->dimensions, scarp_basis_name(work->basis), fade,
             fractal, work->turned ? "/turned" : "", period, work->phase != 0.0f ? "/flow" : "",
             warp_names[work->warp], title, work->f64 ? "/f64" : "", pattern_names[work->pattern],
             output_names[work->output], size);
}
