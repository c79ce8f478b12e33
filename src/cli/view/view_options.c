/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp view` and its help.
 */
#include "view/view_options.h"

#include <stddef.h>

#include "look/palette.h"
#include "presets/presets.h"
#include "shared/number.h"

#define FIELD(name) offsetof(struct view_options, name)

/* Reads numbers with commas between them, each in its interval, and nothing else. */
static bool read_numbers(const char *text, size_t count, const double (*bounds)[2], double *numbers)
{
    for (size_t i = 0; i < count; i++) {
        if (i > 0 && *text++ != ',') {
            return false;
        }
        text = number_read(text, &numbers[i]);
        if (text == NULL || !(numbers[i] >= bounds[i][0] && numbers[i] <= bounds[i][1])) {
            return false;
        }
    }
    return *text == '\0';
}

static enum option_result parse_camera(const struct option *option, const char *text, void *field)
{
    const double bounds[3][2] = {
        {-0x1p40, 0x1p40}, {-0x1p40, 0x1p40}, {option->lowest, option->highest}};
    double numbers[3];
    if (!read_numbers(text, 3, bounds, numbers)) {
        return OPTION_INVALID;
    }
    *(struct view_camera *)field = (struct view_camera){numbers[0], numbers[1], numbers[2]};
    return OPTION_VALID;
}

static enum option_result parse_direction(const struct option *option, const char *text,
                                          void *field)
{
    const double bounds[2][2] = {{0, 360}, {option->lowest, option->highest}};
    double numbers[2];
    if (!read_numbers(text, 2, bounds, numbers)) {
        return OPTION_INVALID;
    }
    *(struct view_direction *)field = (struct view_direction){numbers[0], numbers[1]};
    return OPTION_VALID;
}

static const struct option picture_rows[] = {
    {OPTION_FILE("--output", output, "the picture: .png .ppm .img .tif .npy; must be given"),
     .of_run = 1},
    {OPTION_SIZE("--size", size, "960x540", 1, 16384, "pixels across and down")},
    {OPTION_COUNT("--samples", samples, "4", 1, 256, "rays for each pixel where it needs them")},
};

static const struct option camera_rows[] = {
    {OPTION_READ(parse_camera, "X,Y,H", "--camera", camera,
                 "three numbers X,Y,H, X and Y from -2^40 to 2^40 and H from -2^24 to 2^24",
                 "where it is: H is the height, in the unit of x and y, which must be above "
                 "the ground"),
     .otherwise = "where it sees most of the view", .lowest = -0x1p24, .highest = 0x1p24},
    {OPTION_READ(
         parse_direction, "AZ,EL", "--look", look,
         "two numbers AZ,EL, AZ from 0 to 360 and EL from -89 to 89",
         "where it looks: degrees clockwise from north, from 0 to 360, and above the horizon, "
         "from -89 to 89"),
     .otherwise = "over the view, with the horizon in the upper third", .lowest = -89,
     .highest = 89},
    {OPTION_DOUBLE("--fov", fov, "56", 1, 150, "how much it sees from left to right, in degrees")},
    {OPTION_POINT(
        "--origin", origin, "0,0", -0x1p40, 0x1p40,
        "the bottom left corner of the view, a square four times as wide as the terrain is "
        "usually high, from 1024 to 16384 units; a camera without --camera looks over it")},
};

static const struct option light_rows[] = {
    {OPTION_TEXT("--palette", palette, "NAME", PALETTE_NAMES ", or a file",
                 "colours of the ground: alpine, temperate, desert, arctic or grey; or a FILE with "
                 "colours of heights: see scarp help terrain"),
     .otherwise = "that of the preset"},
    {OPTION_READ(parse_direction, "AZ,ALT", "--sun", sun,
                 "two numbers AZ,ALT, AZ from 0 to 360 and ALT from 1 to 90",
                 "where the sun is: degrees clockwise from north, from 0 to 360, and above the "
                 "horizon, from 1 to 90"),
     .standard = "225,24", .lowest = 1, .highest = 90},
    {OPTION_READ(option_float, "F", "--haze", haze, "0 or a number from 1 to 2^24",
                 "the distance at which haze takes most of the light, in units, from 1 to 2^24; 0 "
                 "is clear air"),
     .otherwise = "four times the side of the view", .lowest = 0, .highest = 0x1p24},
};

static const struct option_group groups[] = {
    OPTION_GROUP("the picture", picture_rows, 0),
    OPTION_GROUP("the camera", camera_rows, 0),
    OPTION_GROUP("colours, light and air", light_rows, 0),
    GROUND_GROUPS(FIELD(ground)),
    RUNNING_GROUP(FIELD(running)),
};

const struct option_table view_table = {
    .command = "view",
    .purpose =
        "Shows a terrain from a camera, and writes the picture to a file. The options of the\n"
        "terrain are those of scarp terrain.",
    .notes[0] =
        "FILE       The extension says which format. So does a word before the name: ppm:FILE.\n"
        "           FILE - is standard output, as in ppm:-. .png is there with zlib only.\n"
        "units      One unit of x and y is taken for a metre: so large are trees, and so wide is\n"
        "           the line of the shore. Snow and trees depend on the usual heights of the\n"
        "           terrain, which scarp help terrain explains under relief. Rock depends on the\n"
        "           slopes in the view.\n"
        "view       The square that begins at --origin. Without --camera, the camera is\n"
        "           where it sees most of it, looks over it, and has the sun at its side if\n"
        "           there is such a place. The last line that is printed gives the camera as\n"
        "           options.\n"
        "far        Nothing is shown that is farther away than 20 times the view, or 20 times\n"
        "           the height of the camera above the lowest ground. Haze hides that end.\n"
        "rays       A pixel takes one ray, or all of --samples where its neighbours differ from\n"
        "           it. Steps of a ray are as long as the slopes of the picture allow, except\n"
        "           those of one place in 200. So a ray may pass over the thinnest needles of\n"
        "           rock. Octaves whose cells are smaller than a pixel are left out there, as\n"
        "           --of-octaves does.\n"
        "memory     52 MiB at most, and 3 MiB per thread.\n"
        "\n" PRESET_HELP,
    .groups = groups,
    .count = sizeof groups / sizeof groups[0],
    .standard = ground_standard,
    .removed = ground_removed,
};
