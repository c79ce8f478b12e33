/* SPDX-License-Identifier: MIT
 *
 * The recipes of workloads.
 */
#ifndef SCARP_BENCH_RECIPES_H
#define SCARP_BENCH_RECIPES_H

#include <stdint.h>

#include "work.h"

/* The texts that the build takes from files: those of bench/, and some of src/examples/recipes. */
struct bench_text {
    const char *title, *text; /* not ended by a NUL */
    size_t length;
};

extern const struct bench_text bench_texts[]; /* ends with a NULL */

/* How much scratch memory is best */
#define BENCH_BEST_SCRATCH SIZE_MAX

/* A parsed recipe with so many bytes of scratch memory. NULL: there is none of that title, or no
   memory. */
struct bench_recipe *bench_recipe_make(const struct bench_work *work, size_t scratch);
void bench_recipe_free(struct bench_recipe *recipe);

/* Evaluates it: on the grid of the workload if that has one, else at points, which are floats, or
   if the workload says so, doubles. */
enum scarp_status bench_recipe_run(struct bench_recipe *recipe, const struct bench_work *work,
                                   const void *const x[3], const struct scarp_samples *out);

/* The grid of a workload. */
struct scarp_grid bench_work_grid(const struct bench_work *work);

#endif
