/* SPDX-License-Identifier: MIT
 *
 * Where gradient noise reaches its supremum, for the tests of ranges.
 */
#ifndef SCARP_TESTS_SUPREMA_H
#define SCARP_TESTS_SUPREMA_H

#define SUPREMUM_SEED 2

/*
 * Gradient noise of seed 2 and frequency 1 reaches its supremum here, by [dimensions - 2][fade],
 * with the sign + and -: at the maximisers that test_range.c states, in cells whose corners have
 * the right gradients. They were found by trying 10^5 cells in 2D and 10^9 in 3D; another
 * lattice hash has others.
 */
static const double supremum_places[2][2][2][3] = {
    {{{3534.5, -379.4734, 0.0}, {112.4734, -2855.5, 0.0}},
     {{-1381.5, 155.4667, 0.0}, {-447.4667, -3550.5, 0.0}}},
    {{{-95963.4815, 944134.6447, 832439.5}, {-722478.3553, 1013619.4815, -989922.5}},
     {{986541.4764, 458029.5, -961114.3244}, {-610107.3244, -923159.4764, 785642.5}}},
};

#endif
