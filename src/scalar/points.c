/* SPDX-License-Identifier: MIT
 *
 * The scalar kernels: the reference that every other instruction set must equal bit for bit, and
 * the fallback where none other can run. One point at a time, in plain C; shares nothing with
 * src/kernel.
 */
#include <math.h>

#include "../kernels.h"
#include "fractal.h"

static void store(const struct scarp_samples *out, size_t i, const struct sample *s)
{
    float *const arrays[] = {out->value, out->dx,  out->dy,  out->dz,  out->dxx,
                             out->dxy,   out->dxz, out->dyy, out->dyz, out->dzz};
    const float values[] = {s->value, s->dx,  s->dy,  s->dz,  s->dxx,
                            s->dxy,   s->dxz, s->dyy, s->dyz, s->dzz};
    for (size_t member = 0; member < sizeof arrays / sizeof arrays[0]; member++) {
        if (arrays[member] != NULL) {
            arrays[member][i] = values[member];
        }
    }
}

SCALAR_INLINE void points_f32(const struct scarp_plan *plan, size_t count,
                              const void *const position[3], const struct scarp_samples *out,
                              int dimensions)
{
    for (size_t i = 0; i < count; i++) {
        float x[3];
        for (int d = 0; d < dimensions; d++) {
            x[d] = ((const float *)position[d])[i];
        }
        struct sample sum = {0};
        for (int k = 0; k < plan->octaves; k++) {
            const struct scarp_octave *const o = &plan->octave[k];
            const int turned = plan->rotate && k > 0; /* octave 0 never is */
            const struct place place = place_f32(o, turned, x, dimensions);
            const struct sample n = basis(plan, o, &place, dimensions);
            add_octave(&sum, plan, o, turned, &n, dimensions);
        }
        store(out, i, &sum);
    }
}

SCALAR_INLINE void points_f64(const struct scarp_plan *plan, size_t count,
                              const void *const position[3], const struct scarp_samples *out,
                              int dimensions)
{
    for (size_t i = 0; i < count; i++) {
        double x[3];
        for (int d = 0; d < dimensions; d++) {
            x[d] = ((const double *)position[d])[i];
        }
        struct sample sum = {0};
        for (int k = 0; k < plan->octaves; k++) {
            const struct scarp_octave *const o = &plan->octave[k];
            const int turned = plan->rotate && k > 0; /* octave 0 never is */
            const struct place place = place_f64(o, turned, x, dimensions);
            const struct sample n = basis(plan, o, &place, dimensions);
            add_octave(&sum, plan, o, turned, &n, dimensions);
        }
        store(out, i, &sum);
    }
}

static void points2_f32(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points_f32(plan, count, position, out, 2);
}

static void points3_f32(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points_f32(plan, count, position, out, 3);
}

static void points2_f64(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points_f64(plan, count, position, out, 2);
}

static void points3_f64(const struct scarp_plan *plan, size_t count, const void *const position[3],
                        const struct scarp_samples *out)
{
    points_f64(plan, count, position, out, 3);
}

/* n = (-s dx, -s dy, 1) / length. The products of floats are exact in double and their squares do
   not overflow. 1 / length is length / length^2, so that infinite inputs give NaN. */
static void normals(size_t count, const float *dx, const float *dy, float height_scale, float *nx,
                    float *ny, float *nz)
{
    const double s = -(double)height_scale;
    for (size_t i = 0; i < count; i++) {
        const double x = s * (double)dx[i];
        const double y = s * (double)dy[i];
        const double squares = x * x + y * y + 1.0;
        const double inverse = sqrt(squares) / squares;
        if (nx != NULL) {
            nx[i] = (float)(x * inverse);
        }
        if (ny != NULL) {
            ny[i] = (float)(y * inverse);
        }
        if (nz != NULL) {
            nz[i] = (float)inverse;
        }
    }
}

const struct scarp_kernels scarp_kernels_scalar = {
    .isa = SCARP_ISA_SCALAR,
    .points2_f32 = points2_f32,
    .points2_f64 = points2_f64,
    .points3_f32 = points3_f32,
    .points3_f64 = points3_f64,
    .normals = normals,
};
