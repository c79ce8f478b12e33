/* SPDX-License-Identifier: MIT
 *
 * The calls of test_curl.c: their points, their outputs as a list, the noises, and comparison by
 * bits.
 */
#ifndef SCARP_TESTS_CURL_H
#define SCARP_TESTS_CURL_H

#define POINTS 1031
#define MEMBERS 12
#include "near.h"

static const char *const names[MEMBERS] = {"vx",  "vy",  "vz",  "vxx", "vxy", "vxz",
                                           "vyx", "vyy", "vyz", "vzx", "vzy", "vzz"};
enum { VX, VY, VZ, VXX, VXY, VXZ, VYX, VYY, VYZ, VZX, VZY, VZZ };

/* By bits. */
#define VELOCITY2 (1u << VX | 1u << VY)
#define VELOCITY3 (VELOCITY2 | 1u << VZ)
#define ALL2 (VELOCITY2 | 1u << VXX | 1u << VXY | 1u << VYX | 1u << VYY)
#define ALL3 0xfffu

static inline unsigned all_of(int dimensions)
{
    return dimensions == 3 ? ALL3 : ALL2;
}

/* Without the Jacobian. */
static inline unsigned velocity_of(int dimensions)
{
    return dimensions == 3 ? VELOCITY3 : VELOCITY2;
}

/* Those that every noise has, or all. */
static inline unsigned members_of(const struct scarp_noise *noise, int dimensions)
{
    return noise->fractal < SCARP_EROSION ? all_of(dimensions) : velocity_of(dimensions);
}

/* The arrays of the members in `wanted`, from element `first` on. */
static inline struct scarp_flow arrays(struct near *n, unsigned wanted, size_t first)
{
    float *at[MEMBERS];
    arrays_at(n, wanted, first, at);
    const struct scarp_flow out = {.vx = at[VX],
                                   .vy = at[VY],
                                   .vz = at[VZ],
                                   .vxx = at[VXX],
                                   .vxy = at[VXY],
                                   .vxz = at[VXZ],
                                   .vyx = at[VYX],
                                   .vyy = at[VYY],
                                   .vyz = at[VYZ],
                                   .vzx = at[VZX],
                                   .vzy = at[VZY],
                                   .vzz = at[VZZ]};
    return out;
}

static inline enum scarp_status find(struct call c, const struct scarp_noise *noise, size_t first,
                                     size_t count, const struct scarp_flow *out)
{
    return FIND(c, noise, first, count, out, scarp_curl);
}

static inline void find_all(struct call c, const struct scarp_noise *noise, struct near *to)
{
    const struct scarp_flow out = arrays(to, members_of(noise, c.dimensions), 0);
    poison(to);
    const enum scarp_status status = find(c, noise, 0, POINTS, &out);
    CHECK(status == SCARP_OK, "%dD: %s", c.dimensions, scarp_status_text(status));
}

#define NOISES 18

static const struct scarp_noise deep = {.seed = 21, .amplitude = 0.25f, .frequency = 0.5},
                                warp = {.seed = 22, .amplitude = 0.5f, .octaves = 2.0f},
                                warped_warp = {.seed = 23, .basis = SCARP_SIMPLEX, .warp = &deep};

static const struct scarp_noise noises[NOISES] = {
    {.seed = 1},
    {.seed = 2, .octaves = 3.5f, .gain = 0.4f, .frequency = 0.37, .amplitude = 2.5f},
    {.seed = 3, .octaves = 10.0f, .rotate = 1},
    {.seed = 4, .octaves = 12.0f, .frequency = 0.01}, /* more than a call has room for */
    {.seed = 5, .octaves = 32.0f, .lacunarity = 1.25f, .basis = SCARP_VALUE},
    {.seed = 6, .fade = SCARP_CUBIC, .octaves = 2.0f, .phase = 0.3f},
    {.seed = 7, .basis = SCARP_SIMPLEX, .octaves = 2.0f, .rotate = 1},
    {.seed = 8, .basis = SCARP_CELL_SOFT, .octaves = 2.0f},
    {.seed = 9, .basis = SCARP_CELL_F1, .jitter = 0.5f},
    {.seed = 10, .fractal = SCARP_RIDGED, .octaves = 3.0f},
    {.seed = 11, .fractal = SCARP_TURBULENCE, .octaves = 2.0f, .basis = SCARP_VALUE},
    {.seed = 12, .fractal = SCARP_EROSION, .octaves = 3.0f},
    {.seed = 13, .fractal = SCARP_SWISS, .octaves = 3.0f},
    {.seed = 14, .fractal = SCARP_JORDAN, .octaves = 3.0f, .warp = &warp},
    {.seed = 15, .octaves = 3.0f, .period = {4, 7, 5}},
    {.seed = 16, .octaves = 2.0f, .warp = &warp},
    {.seed = 17, .basis = SCARP_SIMPLEX, .octaves = 9.0f, .warp = &warped_warp},
    {.seed = 18, .octaves = 3.0f, .warp = &warped_warp, .phase = 0.7f},
};

/* Compares members of `here` with those of `there`. */
static inline void compare(const char *what, int noise, unsigned wanted, size_t first, size_t count)
{
    for (int m = 0; m < MEMBERS; m++) {
        for (size_t i = first; (wanted >> m & 1) != 0 && i < first + count; i++) {
            if (bits_of(&here, m, i) != bits_of(&there, m, i)) {
                CHECK_BITS(0, "%s, noise %d: %s[%zu] is %a, not %a", what, noise, names[m], i,
                           (double)of(&here, m, i), (double)of(&there, m, i));
                return;
            }
        }
    }
    CHECK_BITS(1, "%s", what);
}

#endif
