/* SPDX-License-Identifier: MIT
 *
 * The peer "by hand" of the benchmark computes what the recipe computes, whichever way it goes.
 * Programs may join factors that recipes do not, so last bits may differ.
 */
#include "../bench/hand.h"
#include "../bench/peer.h"
#include "../bench/recipes.h"
#include "check.h"

enum { POINTS = 12000, MEMBERS = 4 };

static float by_recipe[MEMBERS][POINTS], by_hand[MEMBERS][POINTS];
static double coordinates[3][POINTS];
static float floats[3][POINTS];

static struct scarp_samples samples(float s[MEMBERS][POINTS], const struct bench_work *work)
{
    const int has_gradient = work->output == BENCH_PLUS_GRADIENT;
    return (struct scarp_samples){.value = s[0],
                                  .dx = has_gradient ? s[1] : NULL,
                                  .dy = has_gradient ? s[2] : NULL,
                                  .dz = has_gradient && work->dimensions == 3 ? s[3] : NULL};
}

/* A smaller workload, which no way divides without a remainder. */
static void shrink(struct bench_work *work)
{
    static const size_t plane[3] = {150, 61, 1}, space[3] = {66, 5, 36};
    if (work->layout == BENCH_RECIPE_GRID) {
        memcpy(work->grid, work->dimensions == 3 ? space : plane, sizeof work->grid);
        work->points = work->grid[0] * work->grid[1] * work->grid[2];
    }
}

static void compare(const struct bench_work *work, const char *way)
{
    for (int m = 0; m < MEMBERS; m++) {
        float largest = 0, difference = 0;
        for (size_t i = 0; i < work->points; i++) {
            largest = fmaxf(largest, fabsf(by_recipe[m][i]));
            /* not a maximum, which would ignore NaN */
            const float d = fabsf(by_recipe[m][i] - by_hand[m][i]);
            difference = d <= difference ? difference : d;
        }
        CHECK(difference <= 1e-4f * largest, "%s, %s: member %d is off by %g of %g", work->name,
              way, m, (double)difference, (double)largest);
    }
}

static int check_work(struct bench_work *work)
{
    shrink(work);
    void *const state = bench_peer_hand.open(work, scarp_isa_active());
    struct bench_recipe *const recipe = bench_recipe_make(work, BENCH_BEST_SCRATCH);
    const struct scarp_samples expected = samples(by_recipe, work), out = samples(by_hand, work);
    const void *at[3];
    char way[32];
    int ways = 0;
    for (int d = 0; d < 3; d++) {
        at[d] = work->f64 ? (const void *)coordinates[d] : floats[d];
    }
    CHECK(state == NULL || recipe != NULL, "%s: there is no recipe", work->name);
    memset(by_recipe, 0, sizeof by_recipe);
    if (state != NULL && recipe != NULL) {
        CHECK(bench_recipe_run(recipe, work, at, &expected) == SCARP_OK, "%s", work->name);
        for (; bench_hand_way(work, ways, way, sizeof way); ways++) {
            memset(by_hand, 0, sizeof by_hand);
            CHECK(bench_hand_run(state, ways, work, at, &out), "%s, %s", work->name, way);
            compare(work, way);
        }
        CHECK(bench_peer_hand.choose(state, work, at, &out) != NULL, "%s", work->name);
    }
    bench_recipe_free(recipe);
    if (state != NULL) {
        bench_peer_hand.close(state);
    }
    return ways;
}

int main(void)
{
    struct bench_work work;
    int ways = 0, titles = 0;
    uint64_t random = 1;
    for (size_t i = 0; i < POINTS; i++) {
        for (int d = 0; d < 3; d++) {
            random = random * UINT64_C(6364136223846793005) + 1442695040888963407u;
            coordinates[d][i] = (double)(random >> 40) * 0x1p-14 - 512;
            floats[d][i] = (float)coordinates[d][i];
        }
    }
    for (size_t i = 0; bench_work_get(i, &work); i++) {
        const int is_recipe = work.layout == BENCH_RECIPE || work.layout == BENCH_RECIPE_GRID;
        if (is_recipe && strncmp(work.title, "terrain-", 8) != 0) {
            const int found = check_work(&work);
            CHECK(found > 0, "%s: is not done by hand", work.name);
            ways += found;
            titles++;
        }
    }
    CHECK(ways > 2 * titles, "%d ways of %d recipes", ways, titles);
    return check_done();
}
