/* SPDX-License-Identifier: MIT
 *
 * Sampling the terrain: the noise, whole; then mask, base and terraces in pieces that stay in the
 * cache, by the library's chain rule.
 */
#include "ground/ground.h"

#include <math.h>
#include <stdint.h>

#include "shared/error.h"
#include "shared/sine.h"

#define PIECE 1024 /* points that are combined at once */

/* Arrays of one more sample */
struct piece {
    float value[PIECE], dx[PIECE], dy[PIECE];
};

static struct scarp_samples samples_of(struct piece *piece, bool has_gradient)
{
    return (struct scarp_samples){.value = piece->value,
                                  .dx = has_gradient ? piece->dx : NULL,
                                  .dy = has_gradient ? piece->dy : NULL};
}

/* `out` from its point number `first` on */
static struct scarp_samples samples_from(const struct scarp_samples *out, size_t first)
{
    return (struct scarp_samples){.value = out->value + first,
                                  .dx = out->dx != NULL ? out->dx + first : NULL,
                                  .dy = out->dy != NULL ? out->dy + first : NULL};
}

static float within(float value, float lowest, float highest)
{
    return value < lowest ? lowest : value > highest ? highest : value;
}

/* Sums and products of numbers in intervals round to numbers in the intervals of sums and products,
   since rounding keeps the order. Terraces leave a value between the two multiples of 1 / terraces
   that are nearest. */
static void set_range(struct ground *ground, float sea_level, float plateau)
{
    float lowest, highest;
    scarp_range(ground->noise, 2, &lowest, &highest);
    if (highest > ground->rim) {
        const float turned = 2.0f * ground->rim - highest;
        lowest = turned < lowest ? turned : lowest;
        highest = ground->rim;
    }
    if (ground->has_mask) {
        lowest = lowest < 0.0f ? lowest : 0.0f;
        highest = highest > 0.0f ? highest : 0.0f;
    }
    if (ground->has_base) {
        float below, above;
        scarp_range(&ground->base, 2, &below, &above);
        lowest += below;
        highest += above;
    }
    if (ground->terraces != 0.0f) {
        lowest = floorf(lowest * ground->terraces) / ground->terraces;
        highest = ceilf(highest * ground->terraces) / ground->terraces;
    }
    ground->lowest = lowest;
    ground->highest = highest;
    ground->floor = within(sea_level, lowest, highest);
    ground->ceiling = within(plateau, lowest, highest);
}

/* Coordinates of the noise are those of a frame that has the wind along its first axis. */
static void set_stretch(struct ground *ground, double stretch, double wind)
{
    ground->is_stretched = stretch != 1.0;
    ground->is_aligned = wind == 270.0;
    ground->along[0] = -sine(wind);
    ground->along[1] = -sine(wind + 90.0);
    ground->across[0] = sine(wind + 90.0) / stretch;
    ground->across[1] = -sine(wind) / stretch;
}

bool ground_make(const struct ground_options *options, struct ground *ground)
{
    *ground = (struct ground){
        .has_base = options->base.amplitude != 0.0f,
        .has_mask = options->mask.band.x != options->mask.band.y,
        .mask_from = (float)options->mask.band.x,
        .mask_to = (float)options->mask.band.y,
        .rim = options->crater,
        .terraces = options->terraces,
        .terrace_riser = options->terrace_riser,
        .terrace_strength = options->terrace_strength,
        .height_scale = options->height,
    };
    if (!noise_make(&options->noise, &options->warp, 2, ground->noise) ||
        (ground->has_base && !noise_make_part(&options->base.noise, "base-", 2, &ground->base)) ||
        (ground->has_mask && !noise_make_part(&options->mask.noise, "mask-", 2, &ground->mask))) {
        return false;
    }
    ground->base.amplitude = options->base.amplitude;
    if (ground->has_mask && !(fabsf(ground->mask_to - ground->mask_from) >= 0x1p-60f)) {
        cli_error("--mask-band: the numbers are closer than 2^-60, and not equal");
        return false;
    }
    if (options->plateau < options->sea_level) {
        cli_error("--plateau: lies below --sea-level");
        return false;
    }
    set_stretch(ground, options->stretch, options->wind);
    set_range(ground, options->sea_level, options->plateau);
    return true;
}

/* The points where one octave of cell-f1 jumps are not looked at. */
static bool noise_jumps(const struct scarp_noise *noise)
{
    const bool is_creased = noise->basis == SCARP_CELL_F1 || noise->basis == SCARP_CELL_F2 ||
                            noise->basis == SCARP_CELL_EDGE;
    const bool has_slopes = noise->fractal == SCARP_EROSION || noise->fractal == SCARP_SWISS ||
                            noise->fractal == SCARP_JORDAN;
    return noise->basis == SCARP_CELL_VALUE ||
           (is_creased && has_slopes && noise->octaves > 1.0f) ||
           (noise->basis == SCARP_CELL_EDGE && noise->fractal == SCARP_EROSION) ||
           (noise->warp != NULL && noise_jumps(noise->warp));
}

bool ground_jumps(const struct ground *ground)
{
    return noise_jumps(ground->noise) || (ground->has_base && noise_jumps(&ground->base)) ||
           (ground->has_mask && noise_jumps(&ground->mask));
}

void ground_cut(const struct ground *ground, size_t count, const struct scarp_samples *out)
{
    if (ground->floor <= ground->lowest && ground->ceiling >= ground->highest) {
        return;
    }
    for (size_t i = 0; i < count; i++) {
        const float value = out->value[i];
        if (value >= ground->floor && value <= ground->ceiling) {
            continue;
        }
        out->value[i] = value < ground->floor ? ground->floor : ground->ceiling;
        if (out->dx != NULL) {
            out->dx[i] = out->dy[i] = 0.0f;
        }
    }
}

/* Turns slopes along the axes of the noise to those along x and y. */
static void turn_gradient(const struct ground *ground, size_t count,
                          const struct scarp_samples *out)
{
    if (out->dx == NULL) {
        return;
    }
    const float along_x = (float)ground->along[0], along_y = (float)ground->along[1];
    const float across_x = (float)ground->across[0], across_y = (float)ground->across[1];
    for (size_t i = 0; i < count; i++) {
        const float u = out->dx[i], v = out->dy[i];
        out->dx[i] = along_x * u + across_x * v;
        out->dy[i] = along_y * u + across_y * v;
    }
}

/* The noise at points; no call of the library here can fail: the noises were checked, and what
   options allow of places lies within 2^53. */
static void sample_points(const struct ground *ground, size_t count, const double *x,
                          const double *y, const struct scarp_samples *out)
{
    if (!ground->is_stretched) {
        scarp_sample2_f64(ground->noise, count, x, y, out);
        return;
    }
    double u[PIECE], v[PIECE];
    for (size_t first = 0; first < count; first += PIECE) {
        const size_t n = count - first < PIECE ? count - first : PIECE;
        for (size_t i = 0; i < n; i++) {
            u[i] = ground->along[0] * x[first + i] + ground->along[1] * y[first + i];
            v[i] = ground->across[0] * x[first + i] + ground->across[1] * y[first + i];
        }
        const struct scarp_samples piece = samples_from(out, first);
        scarp_sample2_f64(ground->noise, n, u, v, &piece);
    }
    turn_gradient(ground, count, out);
}

/* The noise on a grid whose axes the wind turns: the points of the grid, one by one */
static void sample_turned(const struct ground *ground, const struct scarp_grid *grid,
                          const struct scarp_samples *out)
{
    double x[PIECE], y[PIECE];
    const size_t across = grid->count[0], count = across * grid->count[1];
    for (size_t first = 0; first < count; first += PIECE) {
        const size_t n = count - first < PIECE ? count - first : PIECE;
        for (size_t i = 0; i < n; i++) {
            const int64_t column = grid->first[0] + (int64_t)((first + i) % across);
            const int64_t row = grid->first[1] + (int64_t)((first + i) / across);
            x[i] = grid->origin[0] + grid->step[0] * (double)column;
            y[i] = grid->origin[1] + grid->step[1] * (double)row;
        }
        const struct scarp_samples piece = samples_from(out, first);
        sample_points(ground, n, x, y, &piece);
    }
}

static void sample_grid(const struct ground *ground, const struct scarp_grid *grid,
                        const struct scarp_samples *out)
{
    if (!ground->is_stretched) {
        scarp_grid2(ground->noise, grid, out);
    } else if (ground->is_aligned) {
        struct scarp_grid stretched = *grid;
        stretched.origin[1] *= ground->across[1];
        stretched.step[1] *= ground->across[1];
        scarp_grid2(ground->noise, &stretched, out);
        turn_gradient(ground, grid->count[0] * grid->count[1], out);
    } else {
        sample_turned(ground, grid, out);
    }
}

/* Combines a piece of the noise, in `out`, with the mask and the base, of which `sample` gives the
   same piece of a noise. */
typedef void sample_piece_fn(const void *piece, const struct scarp_noise *noise,
                             const struct scarp_samples *out);

static void combine(const struct ground *ground, size_t count, sample_piece_fn *sample,
                    const void *piece, const struct scarp_samples *out)
{
    struct piece memory;
    const struct scarp_samples other = samples_of(&memory, out->dx != NULL);
    if (ground->rim < INFINITY) {
        scarp_affine(count, out, -1.0f, 2.0f * ground->rim, &other);
        scarp_min(count, out, &other, out);
    }
    if (ground->has_mask) {
        sample(piece, &ground->mask, &other);
        scarp_smoothstep(count, &other, ground->mask_from, ground->mask_to, &other);
        scarp_multiply(count, out, &other, out);
    }
    if (ground->has_base) {
        sample(piece, &ground->base, &other);
        scarp_add(count, out, &other, out);
    }
    if (ground->terraces != 0.0f) {
        scarp_terrace(count, out, ground->terraces, ground->terrace_riser, ground->terrace_strength,
                      out);
    }
}

static bool is_plain(const struct ground *ground)
{
    return !ground->has_mask && !ground->has_base && ground->terraces == 0.0f &&
           ground->rim == INFINITY;
}

static void sample_piece_of_grid(const void *piece, const struct scarp_noise *noise,
                                 const struct scarp_samples *out)
{
    scarp_grid2(noise, piece, out);
}

/* Combines the samples of a grid: some rows at a time, or parts of a row that is longer. */
static void combine_grid(const struct ground *ground, const struct scarp_grid *grid,
                         const struct scarp_samples *out)
{
    const size_t columns = grid->count[0], rows = grid->count[1];
    const size_t wide = columns < PIECE ? columns : PIECE;
    const size_t high = wide < PIECE ? PIECE / wide : 1;
    for (size_t row = 0; row < rows; row += high) {
        for (size_t column = 0; column < columns; column += wide) {
            struct scarp_grid piece = *grid;
            piece.first[0] += (int64_t)column;
            piece.first[1] += (int64_t)row;
            piece.count[0] = columns - column < wide ? columns - column : wide;
            piece.count[1] = rows - row < high ? rows - row : high;
            const struct scarp_samples part = samples_from(out, row * columns + column);
            combine(ground, piece.count[0] * piece.count[1], sample_piece_of_grid, &piece, &part);
        }
    }
}

void ground_uncut_grid(const struct ground *ground, const struct scarp_grid *grid,
                       const struct scarp_samples *out)
{
    sample_grid(ground, grid, out);
    if (!is_plain(ground)) {
        combine_grid(ground, grid, out);
    }
}

void ground_grid(const struct ground *ground, const struct scarp_grid *grid,
                 const struct scarp_samples *out)
{
    ground_uncut_grid(ground, grid, out);
    ground_cut(ground, grid->count[0] * grid->count[1], out);
}

struct points {
    size_t count;
    const double *x, *y;
};

static void sample_piece_of_points(const void *piece, const struct scarp_noise *noise,
                                   const struct scarp_samples *out)
{
    const struct points *const points = piece;
    scarp_sample2_f64(noise, points->count, points->x, points->y, out);
}

void ground_uncut_points(const struct ground *ground, size_t count, const double *x,
                         const double *y, const struct scarp_samples *out)
{
    sample_points(ground, count, x, y, out);
    for (size_t first = 0; first < count && !is_plain(ground); first += PIECE) {
        const struct points piece = {count - first < PIECE ? count - first : PIECE, x + first,
                                     y + first};
        const struct scarp_samples part = samples_from(out, first);
        combine(ground, piece.count, sample_piece_of_points, &piece, &part);
    }
}

void ground_points(const struct ground *ground, size_t count, const double *x, const double *y,
                   const struct scarp_samples *out)
{
    ground_uncut_points(ground, count, x, y, out);
    ground_cut(ground, count, out);
}

/* How many octaves have cells of at least `finest` units. Between two numbers of octaves, linear in
   the size of the cell, which needs no logarithm. */
static void limit(struct scarp_noise *noise, double finest)
{
    const float whole = noise->octaves;
    const double lacunarity = (double)noise->lacunarity;
    double cell = 1.0 / noise->frequency;
    float octaves = 1.0f;
    if (lacunarity <= 1.0) {
        return;
    }
    while (octaves < whole && cell / lacunarity >= finest) {
        cell /= lacunarity;
        octaves += 1.0f;
    }
    if (octaves < whole && cell > finest) {
        octaves += (float)((cell / finest - 1.0) / (lacunarity - 1.0));
    }
    if (octaves < whole) {
        noise->of_octaves = noise->of_octaves != 0.0f ? noise->of_octaves : whole;
        noise->octaves = octaves;
    }
}

void ground_limit(const struct ground *ground, double finest, struct ground *limited)
{
    *limited = *ground;
    if (ground->noise[0].warp != NULL) {
        limited->noise[0].warp = &limited->noise[1];
    }
    limit(&limited->noise[0], finest);
    if (limited->has_base) {
        limit(&limited->base, finest);
    }
    if (limited->has_mask) {
        limit(&limited->mask, finest);
    }
}
