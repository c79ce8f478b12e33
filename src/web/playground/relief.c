/* SPDX-License-Identifier: MIT
 *
 * The relief of `scarp terrain` as a module for the page: the program's own code, between arrays
 * that the page fills and reads.
 */
#include "look/relief.h"

#include <stdint.h>

#include "look/palette.h"

#define COUNT 32768 /* pixels at once */

enum { VALUE, BED, NORMAL, SHADE = NORMAL + 3, ARRAYS = SHADE + 3 };

static float arrays[ARRAYS][COUNT];
static uint8_t rgb[3 * COUNT];
static uint32_t pixels[COUNT];
static struct palette palette;
static struct relief relief;

/* What the page calls */
float *page_array(int i);
uint32_t *page_pixels(void);
const char *page_palette_name(int i);
void page_set_look(int i, double east, double north, double up);
void page_set_spread(float low, float middle, float high, float sea, float deep);
void page_paint(int count, int has_bed, int has_shade);

/* Palettes of files are not for the page. */
bool palette_read(struct palette *to, const char *option, const char *path)
{
    (void)to;
    (void)option;
    (void)path;
    return false;
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

void page_set_look(int i, double east, double north, double up)
{
    palette = *palette_find(palette_names[i]);
    palette_resolve(&palette, 0.0f, 1.0f);
    relief.palette = &palette;
    relief.light[0] = east;
    relief.light[1] = north;
    relief.light[2] = up;
}

void page_set_spread(float low, float middle, float high, float sea, float deep)
{
    relief.low = low;
    relief.middle = middle;
    relief.high = high;
    relief.sea = sea;
    relief.deep = deep;
}

/* Paints `count` pixels. Without a sea, there is no bed; without a z-factor, what is lit are the
   normals. */
void page_paint(int count, int has_bed, int has_shade)
{
    const int lit = has_shade ? SHADE : NORMAL;
    const struct relief_samples samples = {
        .value = arrays[VALUE],
        .bed = has_bed ? arrays[BED] : NULL,
        .normal = {arrays[NORMAL], arrays[NORMAL + 1], arrays[NORMAL + 2]},
        .shade = {arrays[lit], arrays[lit + 1], arrays[lit + 2]},
    };
    relief_colours(&relief, &samples, (size_t)count, rgb);
    for (int i = 0; i < count; i++) {
        pixels[i] = rgb[3 * i] | (uint32_t)rgb[3 * i + 1] << 8 | (uint32_t)rgb[3 * i + 2] << 16 |
                    UINT32_C(0xff000000);
    }
}
