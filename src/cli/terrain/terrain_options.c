/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp terrain` and its help.
 */
#include "terrain/terrain_options.h"

#include <stddef.h>

#include "presets/presets.h"

#define FIELD(name) offsetof(struct terrain_options, name)

static const struct option raster_rows[] = {
    {.name = "--size",
     .argument = "WxH",
     .standard = "1024x1024",
     .allowed = "WIDTHxHEIGHT with both from 1 to 1000000",
     .help = "samples across and down, each from 1 to 1000000",
     .parse = option_size,
     .offset = FIELD(size),
     .lowest = 1,
     .highest = 1e6},
    {.name = "--origin",
     .argument = "X,Y",
     .standard = "0,0",
     .allowed = "two numbers X,Y from -2^53 to 2^53",
     .help = "position of the bottom left sample, each from -2^53 to 2^53",
     .parse = option_point,
     .offset = FIELD(origin),
     .lowest = -0x1p53,
     .highest = 0x1p53},
    {.name = "--step",
     .argument = "F",
     .standard = "1",
     .allowed = "a number from 2^-48 to 2^48",
     .help = "distance between samples, in the unit of x and y,\nfrom 2^-48 to 2^48",
     .parse = option_double,
     .offset = FIELD(step),
     .lowest = 0x1p-48,
     .highest = 0x1p48},
    {.name = "--tileable",
     .help = "--period with the raster's own size: copies fit side by side",
     .offset = FIELD(tileable)},
};

#define FILE_ALLOWED "a file name, of which the extension tells the format"

static const struct option file_rows[] = {
    {.name = "--heights",
     .argument = "FILE",
     .allowed = FILE_ALLOWED,
     .help = "heights: .png .pgm .r16 (16-bit integers), .r32 .pfm .img .npy\n(floats)",
     .parse = option_text,
     .offset = FIELD(heights),
     .of_run = 1},
    {.name = "--normals",
     .argument = "FILE",
     .allowed = FILE_ALLOWED,
     .help = "unit normals: .png .ppm (8-bit red, green, blue), .pfm .img\n.npy (floats)",
     .parse = option_text,
     .offset = FIELD(normals),
     .of_run = 1},
    {.name = "--hillshade",
     .argument = "FILE",
     .allowed = FILE_ALLOWED,
     .help = "light and shade: .png .pgm .img .npy (8-bit)",
     .parse = option_text,
     .offset = FIELD(hillshade),
     .of_run = 1},
    {.name = "--relief",
     .argument = "FILE",
     .allowed = FILE_ALLOWED,
     .help = "the ground in colours, lit: .png .ppm .img .npy (8-bit)",
     .parse = option_text,
     .offset = FIELD(relief),
     .of_run = 1},
    {.name = "--gradient",
     .argument = "FILE",
     .allowed = FILE_ALLOWED,
     .help = "slopes of the heights along x and y: .img .npy (floats)",
     .parse = option_text,
     .offset = FIELD(gradient),
     .of_run = 1},
    {.name = "--output",
     .argument = "STEM",
     .allowed = "the beginning of file names: not empty, no separator at its end",
     .help =
         "short for STEM-height, STEM-normal, STEM-hillshade and\nSTEM-relief: .png, or without "
         "zlib .pgm and .ppm [terrain, if no\nfile is asked for]",
     .parse = option_stem,
     .offset = FIELD(output),
     .of_run = 1},
    {.name = "--compare",
     .argument = "N",
     .allowed = "an integer from 1 to 7",
     .help =
         "with --output, also STEM-compare: N by N pixels per sample,\nfrom 1 to 7 [not written]",
     .parse = option_count,
     .offset = FIELD(compare),
     .lowest = 1,
     .highest = 7},
};

static const char *const directions[] = {"up", "down", NULL};

static const struct option look_rows[] = {
    {.name = "--normal-y",
     .argument = "NAME",
     .standard = "up",
     .allowed = "up or down",
     .help = "where the second component of normals grows, green: up\n(OpenGL) or down (DirectX)",
     .parse = option_choice,
     .offset = FIELD(normal_down),
     .choices = directions},
};

static const struct option tile_rows[] = {
    {.name = "--tile",
     .argument = "WxH",
     .allowed = "WIDTHxHEIGHT with both from 1 to 1000000",
     .help = "write tiles of so many samples, NAME_y_x or by patterns (see\nbelow): y counts down "
             "from the top, x from the left, both from\n0 [one file]",
     .parse = option_size,
     .offset = FIELD(tile),
     .lowest = 1,
     .highest = 1e6},
    {.name = "--tiles",
     .argument = "X0:X1,Y0:Y1",
     .allowed = "four integers X0:X1,Y0:Y1 from 0 to 1000000, X0 below X1 and Y0 below Y1",
     .help = "only those with X0 <= x < X1 and Y0 <= y < Y1 [all]",
     .parse = option_range,
     .offset = FIELD(tiles),
     .lowest = 0,
     .highest = 1e6,
     .of_run = 1},
    {.name = "--share",
     .argument = "I/N",
     .allowed = "two integers I/N, N from 1 to 1000000 and I from 0 to N - 1",
     .help = "only share I, from 0, of N equal shares of these tiles, N from 1\nto 1000000 [all]",
     .parse = option_share,
     .offset = FIELD(share),
     .lowest = 0,
     .highest = 1e6,
     .of_run = 1},
    {.name = "--overlap",
     .argument = "N",
     .standard = "0",
     .allowed = "an integer from 0 to 1024",
     .help = "samples that a tile also has of its neighbours to the right\nand below, from 0 to "
             "1024; engines want 1",
     .parse = option_count,
     .offset = FIELD(overlap),
     .lowest = 0,
     .highest = 1024},
    {.name = "--resume",
     .help = "leave out tiles that are there already, and those that another\nrun is writing: runs "
             "with the same options share the work",
     .offset = FIELD(resume),
     .of_run = 1},
};

static const struct option_group groups[] = {
    OPTION_GROUP("the raster", raster_rows, 0),
    OPTION_GROUP("files, any of which may be asked for together", file_rows, 0),
    OPTION_GROUP("how they look", look_rows, 0),
    LOOK_GROUPS(NULL, FIELD(look)),
    OPTION_GROUP("tiles", tile_rows, 0),
    GROUND_GROUPS(FIELD(ground)),
    RUNNING_GROUP(FIELD(running)),
};

const struct option_table terrain_table = {
    .command = "terrain",
    .purpose =
        "Samples a terrain (a sum of octaves of noise) with its exact gradient and writes its\n"
        "heights, normals, hillshade, relief in colours and gradient to files.",
    .notes =
        "FILE       its extension tells the format, or what stands before it: r32:FILE. FILE may\n"
        "           be - for standard output, as in pgm:-. Files appear under their name when "
        "they\n"
        "           are complete and on the disk; until then they are beside it, under a name of\n"
        "           this run alone that ends with .part.\n"
        "\n"
        ".png       with zlib only           .pgm .ppm  netpbm's, high byte first\n"
        ".r16 .r32  no header, low byte first           .pfm  floats, bottom row first\n"
        ".img       ENVI, which GDAL opens; NAME.hdr beside NAME.img tells the raster's place\n"
        ".npy       NumPy's: height x width, or height x width x components\n"
        "\n"
        "place      column c and row r lie at x = X + c step and y = Y + (H - 1 - r) step: x "
        "grows\n"
        "           to the right (east) and y upward (north).\n"
        "period     copies fit to rounding, and to the bit if width, height and step are powers "
        "of\n"
        "           two. Lacunarity is a whole number then.\n"
        "phase      frames at the phases 0, 1/N, 2/N, ... (N - 1)/N are a loop: a whole turn\n"
        "           later, files have the same bytes. Octave k, from 0, makes 2^k loops a turn,\n"
        "           its fastest gradients twice as many: with N below 6 * 2^octaves detail\n"
        "           flickers, with twice that it flows smoothly. At phase 0 the noise is that\n"
        "           without --phase.\n"
        "heights    floats are in the unit of x and y. Integers divide the interval that heights\n"
        "           never leave, and not what occurs, so tiles of one terrain fit together: n stands\n"
        "           for ZERO + n (FULL - ZERO) / 65535, and the run prints ZERO and FULL. Of a\n"
        "           recipe, scarp recipe tells that interval. Of one noise it is the height times\n"
        "           the amplitude times [-1, 1], or [0, 1] with turbulence, ridged, swiss and\n"
        "           jordan; hybrid has its own. The sea raises its lower end, the plateau lowers\n"
        "           its upper one. What flows reaches further, but for ridged, swiss and pingpong:\n"
        "           with --phase, also --phase 0, the 1 is 1.0169038 (quintic) or 1.0162356\n"
        "           (cubic), with jordan its square: all frames have one scale.\n"
        "normals    n = (-dx, -dy, 1) / length, with dx and dy the slopes of the heights: red\n"
        "           is east, green north, blue up. Bytes are floor(127.5 n + 128).\n"
        "hillshade  round(255 n.light), 0 where that is negative, of normals whose slopes are\n"
        "           multiplied by the z-factor.\n"
        "relief     A height is 0 where 2 % of the places are lower, 0.4 where half of them are, "
        "1\n"
        "           where 2 % are higher, and linear between; with a sea, the places are those of\n"
        "           the land, and 0 is the sea. There are 4096 places, in a square of 64 cells\n"
        "           around 0,0 whatever the raster, so every raster and every tile of a terrain\n"
        "           has the same colours. The palette has a colour for each height. Rock shows\n"
        "           where it is steep. Snow lies high up, lower on level ground and away from the\n"
        "           light. Sand lies on flat shores. Water is darker where its bed is deeper.\n"
        "           Colours are mixed as squares of sRGB, and multiplied by the light, 1.06 1.00\n"
        "           0.90 max(0, n.light) + 0.27 0.30 0.36 (1 + n_z) / 2, with the normals of the\n"
        "           hillshade. What is x above 3/4 becomes 1 - 1 / (16 x - 8). Bytes are the\n"
        "           roots.\n"
        "palette    Without --palette it is that of the recipe, which a line `#: palette NAME`\n"
        "           tells, else alpine. A FILE has colours of heights in the unit of x and y,\n"
        "           linear between, without rock, snow,\n"
        "           sand and water, but lit. Its lines are those of gdaldem color-relief, height\n"
        "           red green blue [alpha], or a height and a name (white, black, red, green,\n"
        "           blue, yellow, magenta, cyan, aqua, grey, lightgrey, darkgrey, orange, brown,\n"
        "           purple, violet, indigo); 50% is the height in the middle between 0 and 1 of\n"
        "           above; alpha and lines of nv are not used. Or they are GMT's, if FILE ends\n"
        "           with .cpt or a comment tells the COLOR_MODEL, which must be RGB: z0 red green\n"
        "           blue z1 red green blue, or red/green/blue or names; B and F for what is below\n"
        "           and above; N is not used. A line that begins with # is a comment.\n"
        "gradient   dx and dy.\n"
        "compare    on the left the normals, on the right normals of the same places with dx and\n"
        "           dy by central differences of the 16-bit heights, two steps apart.\n"
        "tiles      hold the same samples as one file would. Those at the right and at the bottom\n"
        "           are smaller if the size is no multiple; the overlap goes beyond the raster.\n"
        "patterns   in FILE, {x} and {y} stand for the place of a tile from the left and from the\n"
        "           top, {-y} for that from the bottom, all from 0; {x:04} has at least four\n"
        "           digits. Directories are made. Without them tiles are called NAME_y_x.\n"
        "world      FILE.json beside the tiles (y_x.png.json for w/{y}/{x}.png) tells what they "
        "all\n"
        "           depend on. The first run writes it; a run that would write other tiles is\n"
        "           refused. Remove it to begin anew: older tiles are then written again, and a\n"
        "           run that still goes on ends if that is another world.\n"
        "resume     takes a tile for complete if it is no older than the world, and as large as "
        "it\n"
        "           must be; PNG has to end as it must. Runs that share a world need no locks for\n"
        "           that; where locks reach, no tile is written twice.\n"
        "memory     40 MiB and 2 MiB per thread, unless 32 rows of the files are more, 64 of PNG.\n"
        "\n" PRESET_HELP,
    .groups = groups,
    .count = sizeof groups / sizeof groups[0],
    .standard = ground_standard,
    .removed = ground_removed,
};
