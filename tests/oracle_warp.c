/* SPDX-License-Identifier: MIT
 *
 * Warps as scarp.h defines them: the noise is that of y = x + d(x), where d may have a warp, too.
 */
#include "oracle_warp.h"

#include <string.h>

void oracle_warped_make(struct oracle_warped *warped, const struct scarp_noise *noise,
                        int dimensions)
{
    warped->dimensions = dimensions;
    oracle_make(&warped->level[0][0], noise, dimensions);
    for (warped->depth = 0; (noise = noise->warp) != NULL;) {
        warped->depth++;
        for (int i = 0; i < dimensions; i++) {
            oracle_make_component(&warped->level[warped->depth][i], noise, dimensions, i);
        }
    }
}

void oracle_warped_at(const struct oracle_warped *warped, const double x[3],
                      struct oracle_sample *n)
{
    double y[3] = {x[0], x[1], x[2]};
    for (int level = warped->depth; level > 0; level--) {
        double moved[3] = {x[0], x[1], x[2]};
        for (int i = 0; i < warped->dimensions; i++) {
            struct oracle_sample d;
            oracle_evaluate(&warped->level[level][i], ORACLE_EXACT, y, &d);
            moved[i] += d.value;
        }
        memcpy(y, moved, sizeof y);
    }
    oracle_evaluate(&warped->level[0][0], ORACLE_EXACT, y, n);
}
