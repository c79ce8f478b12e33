/* SPDX-License-Identifier: MIT
 *
 * Taylor's series within half a quarter turn.
 */
#include "shared/sine.h"

#include <stdbool.h>

double sine(double degrees)
{
    const int quarters = (int)(degrees / 90.0 + 0.5);
    const double rest = degrees - 90.0 * quarters; /* exact: in [-45, 45] */
    const double x = rest * 0.017453292519943295;  /* pi / 180 */
    /* Taylor's series from its smallest term on: of the sine, of the cosine after odd quarters */
    const bool odd = quarters % 2 != 0;
    double sum = 1.0;
    for (int n = odd ? 18 : 19; n > 1; n -= 2) {
        sum = 1.0 - x * x / (double)(n * (n - 1)) * sum;
    }
    const double magnitude = odd ? sum : x * sum;
    return quarters % 4 < 2 ? magnitude : -magnitude;
}
