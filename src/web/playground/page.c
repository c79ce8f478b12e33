/* SPDX-License-Identifier: MIT
 *
 * The terrain of `scarp terrain` as a module for the page: the program's own code of grounds, usual
 * heights and reliefs, between arrays that the page reads.
 */
#include <stdint.h>
#include <string.h>

#include "ground/ground.h"
#include "ground/spread.h"
#include "look/palette.h"
#include "look/relief.h"

#define COUNT 65536 /* samples at once */
#define TEXT_MOST 16384

enum { VALUE, DX, DY, DXX, DXY, DYY, BED, NORMAL, SHADE = NORMAL + 3, ARRAYS = SHADE + 3 };
enum { LOWEST, HIGHEST, FLOOR, HAS_SEA, HAS_HESSIAN, LOW, HIGH };

static float arrays[ARRAYS][COUNT];
static uint8_t rgb[3 * COUNT], masks[PALETTE_GROUNDS * COUNT];
static uint32_t pixels[COUNT];
static char text[TEXT_MOST];
static struct ground ground;
static struct scarp_recipe_error error;
static struct spread spread;
static struct palette palette;
static struct relief relief;
static bool has_hessian;

/* What the page calls */
char *page_text(void);
int page_open(int length, uint64_t seed);
const char *page_error_text(void);
double page_number(int what);
float *page_array(int i);
uint32_t *page_pixels(void);
const char *page_palette_name(int i);
int page_sample(const double place[3], int first, int columns, int rows, int order);
double *page_place(void);
void page_cover(int count);
void page_normals(int count, float z_factor);
void page_set_spread(void);
void page_set_look(int i, double azimuth, double altitude);
double page_light(int axis);
void page_paint(int count, int has_shade);
const uint8_t *page_masks(int count);

/* Palettes of files are not for the page. */
bool palette_read(struct palette *to, const char *option, const char *path)
{
    (void)to;
    (void)option;
    (void)path;
    return false;
}

/* Where the page writes a recipe */
char *page_text(void)
{
    return text;
}

/* Opens the recipe of `length` bytes. Returns an enum ground_problem. */
int page_open(int length, uint64_t seed)
{
    const struct ground_source source = {.text = text, .length = (size_t)length, .seed = seed};
    const enum ground_problem problem = ground_open(&ground, &source, &error);
    if (problem == GROUND_FINE) {
        const double origin = 0.0;
        float second;
        has_hessian =
            ground_points(&ground, 1, &origin, &origin, &(struct scarp_samples){.dxx = &second});
    }
    return (int)problem;
}

const char *page_error_text(void)
{
    return error.text;
}

double page_number(int what)
{
    switch (what) {
    case LOWEST: return ground.lowest;
    case HIGHEST: return ground.highest;
    case FLOOR: return ground.floor;
    case HAS_SEA: return ground_has_sea(&ground);
    case HAS_HESSIAN: return has_hessian;
    case LOW: return spread.low;
    default: return spread.high;
    }
}

float *page_array(int i)
{
    return arrays[i];
}

uint32_t *page_pixels(void)
{
    return pixels;
}

/* The name of palette i, or NULL after the last */
const char *page_palette_name(int i)
{
    return palette_names[i];
}

/* Where the page writes the x and the y of the raster's corner, and the step */
double *page_place(void)
{
    static double place[3];
    return place;
}

/* Samples rows of a raster, the bed in place of the sea. Rows go down: row 0 lies at y, and `first`
   is the number of the first row of these. Derivatives up to the order from 0 to 2 are computed. */
int page_sample(const double place[3], int first, int columns, int rows, int order)
{
    const struct scarp_grid grid = {.origin = {place[0], place[1]},
                                    .step = {place[2], -place[2]},
                                    .first = {0, first},
                                    .count = {(size_t)columns, (size_t)rows, 1}};
    const struct scarp_samples out = {.value = arrays[VALUE],
                                      .dx = order > 0 ? arrays[DX] : NULL,
                                      .dy = order > 0 ? arrays[DY] : NULL,
                                      .dxx = order > 1 ? arrays[DXX] : NULL,
                                      .dxy = order > 1 ? arrays[DXY] : NULL,
                                      .dyy = order > 1 ? arrays[DYY] : NULL};
    return ground_dry_grid(&ground, &grid, &out);
}

/* Keeps the bed, and covers the ground with the sea. */
void page_cover(int count)
{
    const struct scarp_samples out = {.value = arrays[VALUE],
                                      .dx = arrays[DX],
                                      .dy = arrays[DY],
                                      .dxx = arrays[DXX],
                                      .dxy = arrays[DXY],
                                      .dyy = arrays[DYY]};
    memcpy(arrays[BED], arrays[VALUE], (size_t)count * sizeof(float));
    ground_cover(&ground, (size_t)count, &out);
}

/* Makes normals, and those that are lit. */
void page_normals(int count, float z_factor)
{
    const size_t n = (size_t)count;
    scarp_normals(n, arrays[DX], arrays[DY], 1.0f, arrays[NORMAL], arrays[NORMAL + 1],
                  arrays[NORMAL + 2]);
    scarp_normals(n, arrays[DX], arrays[DY], z_factor, arrays[SHADE], arrays[SHADE + 1],
                  arrays[SHADE + 2]);
}

/* Looks which heights the ground usually has. */
void page_set_spread(void)
{
    ground_spread(&ground, &spread);
}

void page_set_look(int i, double azimuth, double altitude)
{
    palette = *palette_find(palette_names[i]);
    palette_resolve(&palette, spread.low, spread.high);
    relief.palette = &palette;
    relief.low = spread.low;
    relief.middle = spread.middle;
    relief.high = spread.high;
    relief.sea = spread.sea;
    relief.deep = spread.deep;
    relief_light(azimuth, altitude, relief.light);
}

/* The unit vector to the light: east, north, up */
double page_light(int axis)
{
    return relief.light[axis];
}

/* What the relief is made of. Without a z-factor, what is lit are the normals. */
static struct relief_samples samples_of(int has_shade)
{
    const int lit = has_shade ? SHADE : NORMAL;
    return (struct relief_samples){
        .value = arrays[VALUE],
        .bed = ground_has_sea(&ground) ? arrays[BED] : NULL,
        .normal = {arrays[NORMAL], arrays[NORMAL + 1], arrays[NORMAL + 2]},
        .shade = {arrays[lit], arrays[lit + 1], arrays[lit + 2]},
    };
}

/* Paints `count` pixels as a relief. */
void page_paint(int count, int has_shade)
{
    const struct relief_samples samples = samples_of(has_shade);
    relief_colours(&relief, &samples, (size_t)count, rgb);
    for (int i = 0; i < count; i++) {
        pixels[i] = rgb[3 * i] | (uint32_t)rgb[3 * i + 1] << 8 | (uint32_t)rgb[3 * i + 2] << 16 |
                    UINT32_C(0xff000000);
    }
}

/* The grounds of `count` samples, five bytes each, as relief_masks has them */
const uint8_t *page_masks(int count)
{
    const struct relief_samples samples = samples_of(0);
    relief_masks(&relief, &samples, (size_t)count, masks);
    return masks;
}
