/* SPDX-License-Identifier: MIT
 *
 * Quantiles of a sample. The places are of the R2 sequence: multiples of the powers of the inverse
 * of the plastic number, whole parts left out. They fill a square evenly, and avoid lattice lines.
 */
#include "ground/spread.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shared/bounds.h"

#define PLACES 4096
#define PIECE 512  /* places that are sampled at once */
#define CELLS 64.0 /* across the square, of the noise with the largest cells */

static int compare(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return x < y ? -1 : x > y ? 1 : 0;
}

static void sample(const struct ground *ground, float value[PLACES])
{
    static const double steps[2] = {0.7548776662466927, 0.5698402909980532};
    struct ground still;
    double x[PIECE], y[PIECE];
    ground_limit(ground, 0.0, &still);
    /* A noise that flows becomes that of a whole turn: all frames have the same colours. */
    (void)scarp_recipe_set(&still.recipe, "phase", 1.0, NULL);
    const double size = CELLS * ground->cell;
    for (int first = 0; first < PLACES; first += PIECE) {
        for (int i = 0; i < PIECE; i++) {
            const double u = (first + i) * steps[0], v = (first + i) * steps[1];
            x[i] = (u - floor(u) - 0.5) * size;
            y[i] = (v - floor(v) - 0.5) * size;
        }
        if (!ground_dry_points(&still, PIECE, x, y,
                               &(struct scarp_samples){.value = value + first})) {
            memset(value + first, 0, PIECE * sizeof *value); /* maps are sampled, and fail, later */
        }
    }
}

void ground_spread(const struct ground *ground, struct spread *spread)
{
    float value[PLACES];
    sample(ground, value);
    qsort(value, PLACES, sizeof value[0], compare);
    size_t below = 0; /* places in the sea */
    const bool has_sea = ground_has_sea(ground);
    while (has_sea && below < PLACES && value[below] < ground->floor) {
        below++;
    }
    const size_t above = PLACES - below;
    const float median = value[PLACES - 1 - above / 2];
    const float highest = value[PLACES - 1 - above / 50];
    spread->sea = ground->floor;
    spread->low = has_sea ? ground->floor : value[PLACES / 50];
    spread->high = highest;
    spread->deep = below > 0 ? value[below / 10] : ground->lowest;
    if (!(spread->low < spread->high)) { /* no land, or all of it level */
        spread->high = spread->low + (1.0f + fabsf(spread->low));
    }
    const float least = (spread->high - spread->low) / 16.0f;
    spread->middle = within(median, spread->low + least, spread->high - least);
}
