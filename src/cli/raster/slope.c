/* SPDX-License-Identifier: MIT
 *
 * Slopes and curvatures, in double and without libm's functions, which differ between systems;
 * square roots do not.
 */
#include "raster/slope.h"

#include <math.h>

/* tan(22.5 degrees) and its inverse */
#define LOW 0.41421356237309503
#define HIGH 2.4142135623730949

/* The angle of a tangent t from 0 on, in degrees: 0, 45 or 90 of them, and by Taylor's series that
   of a tangent u between -LOW and LOW, to a part in 10^11. */
static inline double degrees_of(double t)
{
    const double u = t < LOW ? t : t < HIGH ? (t - 1.0) / (t + 1.0) : -1.0 / t;
    const double whole = t < LOW ? 0.0 : t < HIGH ? 45.0 : 90.0;
    const double s = u * u;
    double sum = 1.0 / 27.0;
    for (int n = 25; n > 0; n -= 2) {
        sum = 1.0 / n - s * sum;
    }
    return whole + u * sum * 57.295779513082323; /* 180 / pi */
}

void slope_degrees(size_t count, const float *dx, const float *dy, float *degrees)
{
    for (size_t i = 0; i < count; i++) {
        const double x = (double)dx[i], y = (double)dy[i];
        degrees[i] = (float)degrees_of(sqrt(x * x + y * y));
    }
}

/* Of a graph f: -((1 + fy^2) fxx - 2 fx fy fxy + (1 + fx^2) fyy) / (2 (1 + fx^2 + fy^2)^(3/2)),
   with the sign that makes crests positive (M. P. do Carmo, Differential Geometry of Curves and
   Surfaces, section 3-3) */
void slope_curvature(size_t count, const struct scarp_samples *samples, float *curvature)
{
    for (size_t i = 0; i < count; i++) {
        const double x = (double)samples->dx[i], y = (double)samples->dy[i];
        const double xx = (double)samples->dxx[i], yy = (double)samples->dyy[i];
        const double xy = (double)samples->dxy[i];
        const double square = 1.0 + x * x + y * y;
        const double bend = (1.0 + y * y) * xx - 2.0 * x * y * xy + (1.0 + x * x) * yy;
        curvature[i] = 0.0f - (float)(bend / (2.0 * square * sqrt(square)));
    }
}
