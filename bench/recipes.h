/* SPDX-License-Identifier: MIT
 *
 * The recipes of workloads.
 */
#ifndef SCARP_BENCH_RECIPES_H
#define SCARP_BENCH_RECIPES_H

#include "work.h"

/* A parsed recipe with its scratch memory. NULL: there is none of that title, or no memory. */
struct bench_recipe *bench_recipe_make(const struct bench_work *work);
void bench_recipe_free(struct bench_recipe *recipe);

/* Evaluates it: on the grid of the workload if that has one, else at points, which are floats, or
   if the workload says so, doubles. */
enum scarp_status bench_recipe_run(struct bench_recipe *recipe, const struct bench_work *work,
                                   const void *const x[3], const struct scarp_samples *out);

/* The grid of a workload. */
struct scarp_grid bench_work_grid(const struct bench_work *work);

#endif
