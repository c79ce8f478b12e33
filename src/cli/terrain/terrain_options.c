/* SPDX-License-Identifier: MIT
 *
 * The options of `scarp terrain` and its help.
 */
#include "terrain/terrain_options.h"

#include <stddef.h>

#include "ground/ground.h"
#include "presets/presets.h"

#define FIELD(name) offsetof(struct terrain_options, name)

static const struct option raster_rows[] = {
    {OPTION_SIZE("--size", size, "1024x1024", 1, 1e6, "samples across and down")},
    {OPTION_POINT("--origin", origin, "0,0", -0x1p53, 0x1p53,
                  "position of the bottom left sample")},
    {OPTION_DOUBLE("--step", step, "1", 0x1p-48, 0x1p48,
                   "distance between samples, in the unit of x and y")},
    {OPTION_FLAG("--tileable", tileable,
                 "--period with the raster's own size: copies fit side by side")},
    {OPTION_COUNT("--levels", levels, "1", 1, LEVELS_MOST,
                  "write N rasters, each half as wide as the one before, with the octaves that its "
                  "step can show: NAME, NAME-level1, NAME-level2 ...")},
    {OPTION_FLAG("--band-limit", band_limit,
                 "leave out octaves whose cells are smaller than two samples, also without "
                 "--levels and in level 0: they flicker, and large forms do not need them")},
    {OPTION_READ(option_epsg, "EPSG:N", "--crs", crs,
                 "EPSG:N, N from 1024 to 32766 the number of a projected system; those of degrees, "
                 "such as 4326, are none",
                 "the coordinate system of x and y, for .tif; and for .img if it is a zone of UTM, "
                 "EPSG:32601 to 32660 in the north, 32701 to 32760 in the south"),
     .otherwise = "no system", .lowest = 1024, .highest = 32766},
};

static const struct option file_rows[] = {
    {OPTION_FILE("--heights", heights,
                 "heights: .png .pgm .r16 (16-bit integers), .r32 .pfm .img .tif .npy (floats)"),
     .of_run = 1},
    {OPTION_FILE("--normals", normals,
                 "unit normals: .png .ppm (8-bit red, green, blue), .pfm .img .tif .npy (floats)"),
     .of_run = 1},
    {OPTION_FILE("--hillshade", hillshade, "light and shade: .png .pgm .img .tif .npy (8-bit)"),
     .of_run = 1},
    {OPTION_FILE("--relief", relief,
                 "the ground in colours, lit: .png .ppm .img .tif .npy (8-bit)"),
     .of_run = 1},
    {OPTION_FILE("--gradient", gradient,
                 "slopes of the heights along x and y: .img .tif .npy (floats)"),
     .of_run = 1},
    {OPTION_FILE("--slope", slope,
                 "degrees from level ground, 0 to 90: formats as heights; 16-bit integers divide "
                 "90 degrees"),
     .of_run = 1},
    {OPTION_FILE("--curvature", curvature,
                 "mean curvature in 1 / unit, above 0 on crests, where the recipe has second "
                 "derivatives: .r32 .pfm .img .tif .npy"),
     .of_run = 1},
    {OPTION_READ(option_list, "NAME=FILE", "--out", out,
                 "an output of the recipe and a file, NAME=FILE, at most 15 times",
                 "the values of an output of the recipe; repeat it for others: formats as heights"),
     .otherwise = "not written", .highest = GROUND_FIELDS_MOST, .of_run = 1},
    {OPTION_READ(
         option_stem, "STEM", "--masks", masks,
         "the beginning of file names: not empty, no separator at its end",
         "how much of 255 is rock, snow, sand, vegetation and water, as the relief has them: "
         "STEM-rock and so on, .png or without zlib .pgm; STEM.EXT makes STEM-rock.EXT and "
         "so on, STEM.png two files: see below"),
     .otherwise = "not written", .of_run = 1},
    {OPTION_READ(
         option_stem, "STEM", "--output", output,
         "the beginning of file names: not empty, no separator at its end",
         "short for STEM-height, STEM-normal, STEM-hillshade and STEM-relief: .png, or without "
         "zlib .pgm and .ppm"),
     .otherwise = "terrain, if no file is asked for", .of_run = 1},
    {OPTION_COUNT("--compare", compare, NULL, 1, 7,
                  "with --output, also STEM-compare: N by N pixels per sample"),
     .otherwise = "not written"},
};

static const char *direction_word(int index)
{
    static const char *const words[] = {"up", "down", NULL};
    return words[index];
}

static const struct option look_rows[] = {
    {OPTION_CHOICE(
        "--normal-y", normal_down, "up", direction_word,
        "where the second component of normals, green, grows (OpenGL: up; DirectX: down)")},
};

static const struct option tile_rows[] = {
    {OPTION_SIZE("--tile", tile, NULL, 1, 1e6,
                 "write tiles of W by H samples, called NAME_y_x or by patterns (see below): y "
                 "counts down from the top, x from the left, both from 0"),
     .otherwise = "one file"},
    {OPTION_READ(option_range, "X0:X1,Y0:Y1", "--tiles", tiles,
                 "four integers X0:X1,Y0:Y1 from 0 to 1000000, X0 below X1 and Y0 below Y1",
                 "write only tiles with X0 <= x < X1 and Y0 <= y < Y1"),
     .otherwise = "all", .lowest = 0, .highest = 1e6, .of_run = 1},
    {OPTION_READ(
         option_share, "I/N", "--share", share,
         "two integers I/N, N from 1 to 1000000 and I from 0 to N - 1",
         "write only share I of N equal shares of these tiles, I from 0, N from 1 to 1000000"),
     .otherwise = "all", .lowest = 0, .highest = 1e6, .of_run = 1},
    {OPTION_COUNT(
        "--overlap", overlap, "0", 0, 1024,
        "samples that a tile also has of its neighbours to the right and below (engines want 1)")},
    {OPTION_FLAG("--resume", resume,
                 "leave out tiles that are there already, and those that another run is writing: "
                 "runs with the same options share the work"),
     .of_run = 1},
    {OPTION_FLAG(
         "--verify", verify,
         "write nothing, but compare the files with the checksums that the runs which wrote "
         "them have kept"),
     .of_run = 1},
};

static const struct option_group groups[] = {
    OPTION_GROUP("the raster", raster_rows, 0),
    OPTION_GROUP("files, any number in one run", file_rows, 0),
    OPTION_GROUP("how they look", look_rows, 0),
    LOOK_GROUPS(NULL, FIELD(look)),
    OPTION_GROUP("tiles", tile_rows, 0),
    GROUND_GROUPS(FIELD(ground)),
    RUNNING_GROUP(FIELD(running)),
};

const struct option_table terrain_table = {
    .command = "terrain",
    .purpose =
        "Samples a terrain, which is a recipe or one noise, on a grid, and writes its heights,\n"
        "normals, hillshade, relief in colours and exact slopes to files.",
    .notes[0] =
        "FILE       The extension says which format. So does a word before the name: r32:FILE.\n"
        "           FILE - is standard output, as in pgm:-. A file gets its name when it is\n"
        "           complete and on the disk. Until then it lies in the same directory, under a\n"
        "           name of this run only that ends with .part.\n"
        "\n"
        ".png       only with zlib           .pgm .ppm  netpbm's, high byte first\n"
        ".r16 .r32  no header, low byte first           .pfm  floats, bottom row first\n"
        ".img       ENVI, which GDAL opens; NAME.hdr next to NAME.img has the raster's place\n"
        ".tif       GeoTIFF in tiles of 256 x 256, deflated if there is zlib; above 4 GB it is a\n"
        "           BigTIFF\n"
        ".npy       NumPy's: height x width, or height x width x components\n"
        "\n"
        "place      Column c and row r lie at x = X + c step and y = Y + (H - 1 - r) step, where\n"
        "           X,Y is --origin and H is the height of --size. x grows to the right (east)\n"
        "           and y upward (north).\n"
        "period     Copies fit but for rounding. They fit to the bit if width, height and step\n"
        "           are powers of two. Lacunarity must be a whole number.\n"
        "phase      Frames at the phases 0, 1/N, 2/N, ... (N - 1)/N are a loop: one turn later,\n"
        "           files have the same bytes. Octave k, counted from 0, makes 2^k loops in a\n"
        "           turn, and its fastest gradients twice as many. With N below 6 * 2^octaves\n"
        "           detail flickers; with twice that it flows smoothly. Phase 0 is the noise\n"
        "           without --phase.\n"
        "heights    Floats are in the unit of x and y. An integer n stands for ZERO + n (FULL -\n"
        "           ZERO) / 65535, and the run prints ZERO and FULL. They are the ends of the\n"
        "           interval that heights never leave. They do not depend on the heights that\n"
        "           occur, so tiles of one terrain fit together. For a recipe, scarp recipe\n"
        "           prints that interval. For one noise it is the height times the amplitude\n"
        "           times [-1, 1], or [0, 1] with turbulence, ridged, swiss and jordan; hybrid\n"
        "           has its own. --sea-level raises its lower end, --plateau lowers its upper\n"
        "           one. Noise that flows reaches further, except ridged, swiss and pingpong. So\n"
        "           with --phase, also with --phase 0, the 1 becomes 1.0169038 (quintic) or\n"
        "           1.0162356 (cubic), with jordan the square of that, and all frames have one\n"
        "           scale.\n"
        "normals    n = (-dx, -dy, 1) / length, where dx and dy are the slopes of the heights.\n"
        "           Red is east, green north, blue up. Bytes are floor(127.5 n + 128).\n"
        "hillshade  round(255 n.light), or 0 where that is negative. The slopes in n are\n"
        "           multiplied by the z-factor.\n",
    .notes[1] =
        "relief     Each height becomes a number: 0 where 2 % of all places are lower, 0.4 where\n"
        "           half of them are lower, 1 where 2 % are higher, and linear between. With a\n"
        "           sea, only places on land count, and 0 is the sea. The places are 4096, in a\n"
        "           square of 64 cells around 0,0, whatever the raster is. So every raster and\n"
        "           every tile of a terrain has the same colours. The palette has a colour for\n"
        "           each number. Rock shows where it is steep. Snow lies high up; it lies lower\n"
        "           on level ground and away from the light. Sand lies on flat shores. Water is\n"
        "           darker where it is deeper. Colours are mixed as squares of sRGB, and\n"
        "           multiplied by the light, 1.06 1.00 0.90 max(0, n.light) + 0.27 0.30 0.36 (1\n"
        "           + n_z) / 2, with the normals of the hillshade. A product x above 3/4 becomes\n"
        "           1 - 1 / (16 x - 8). Bytes are the roots.\n"
        "palette    Without --palette it is the one that a line `#: palette NAME` of the recipe\n"
        "           names, else alpine. A FILE has colours for heights in the unit of x and y,\n"
        "           linear between. Its colours are lit, but there is no rock, snow, sand or\n"
        "           water. Its lines are those of gdaldem color-relief: height red green blue\n"
        "           [alpha], or a height and a name (white, black, red, green, blue, yellow,\n"
        "           magenta, cyan, aqua, grey, lightgrey, darkgrey, orange, brown, purple,\n"
        "           violet, indigo). 50% is the height in the middle between 0 and 1 of relief.\n"
        "           Alpha and lines of nv are not used. If FILE ends with .cpt, or a comment\n"
        "           tells the COLOR_MODEL, which must be RGB, lines are those of GMT: z0 red\n"
        "           green blue z1 red green blue, or red/green/blue or names. B and F are the\n"
        "           colours below and above; N is not used. A line that begins with # is a\n"
        "           comment.\n"
        "gradient   dx and dy, the slopes of the heights.\n"
        "slope      The angle whose tangent is the length of the gradient.\n"
        "curvature  The mean curvature, which is 1 / R on top of a sphere of radius R. It is\n"
        "           -((1 + dy^2) dxx - 2 dx dy dxy + (1 + dx^2) dyy) / (2 (1 + dx^2 + dy^2)^1.5).\n"
        "           The sea has none. Fractals of slopes, gullies, slopes and distances in\n"
        "           cells have no second derivatives.\n"
        "out        Values are those of the recipe. --scale makes places larger and not the\n"
        "           values, and a height has no sea. 16-bit integers divide the interval that\n"
        "           the output never leaves; the run prints it.\n"
        "masks      STEM.png becomes two files. STEM-1.png has rock as red, snow as green, sand\n"
        "           as blue and vegetation as alpha. STEM-2.png has water as red, and 0 else.\n"
        "           The five are 255 together at each sample. Ground that is none of the others\n"
        "           counts as vegetation; with the palette desert as sand, with arctic as snow.\n"
        "compare    The left half shows the normals. The right half shows normals of the same\n"
        "           places from central differences of the 16-bit heights, two steps apart.\n",
    .notes[2] =
        "tiles      They hold the samples that one file would hold. Tiles at the right and at\n"
        "           the bottom are smaller if the size is no multiple of the tile. The overlap\n"
        "           reaches beyond the raster. A run writes at most 10,000,000.\n"
        "patterns   In FILE, {x} and {y} are the number of a tile from the left and from the\n"
        "           top, {-y} from the bottom, all from 0. {x:04} has at least four digits.\n"
        "           Directories are made. Without a pattern tiles are called NAME_y_x.\n"
        "levels     Level n has a sample in the middle of each 2^n x 2^n samples of level 0. It\n"
        "           leaves out octaves whose cells are smaller than two of its steps. The scale\n"
        "           of integers and the colours are those of level 0. In FILE, {level} is n,\n"
        "           {-level} the number of levels after it. Tiles of all levels have the same\n"
        "           size; x and y count those of their level. GDAL takes the levels of one .tif\n"
        "           for its overviews: NAME.tif.ovr, NAME.tif.ovr.ovr and so on.\n"
        "world      FILE.json next to the tiles (y_x.png.json for w/{y}/{x}.png), the manifest,\n"
        "           has all that the tiles depend on. The first run writes it. A run that would\n"
        "           write other tiles is refused. Remove the manifest to begin anew: older tiles\n"
        "           are then written again, and a run of another world that still goes on ends.\n"
        "resume     A tile counts as complete if it is no older than the manifest, and as large\n"
        "           as it must be; a PNG also has to end as it must. Runs that share a world\n"
        "           need no locks for that. Where files can be locked, no tile is written twice.\n"
        "verify     Next to the manifest FILE.json a run keeps checksums in FILE.sums, share I of\n"
        "           N in FILE.I-N.sums: XXH64 of each file, which xxhsum -c reads, too.\n"
        "memory     40 MiB and 2 MiB per thread, unless 32 rows of all files together take more;\n"
        "           64 rows with a PNG, 512 with a TIFF; rows of files that are compressed count\n"
        "           twice.\n"
        "\n" PRESET_HELP,
    .groups = groups,
    .count = sizeof groups / sizeof groups[0],
    .standard = ground_standard,
    .removed = ground_removed,
};
