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
                  "N rasters, each half as wide as the one before, with the octaves that its step "
                  "can show: NAME, NAME-level1, NAME-level2 ...")},
    {OPTION_FLAG("--band-limit", band_limit,
                 "leave out octaves whose cells are smaller than two samples, in level 0, too: "
                 "they flicker, and large forms do not need them")},
    {.name = "--crs",
     .argument = "EPSG:N",
     .allowed = "EPSG:N, N from 1024 to 32766 the number of a projected system; those of degrees, "
                "such as 4326, are none",
     .help = "the coordinate system of x and y, for .tif; and for .img if it is a zone of UTM, "
             "EPSG:32601 to 32660 in the north, 32701 to 32760 in the south",
     .otherwise = "no system",
     .parse = option_epsg,
     .offset = FIELD(crs),
     .lowest = 1024,
     .highest = 32766},
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
    {.name = "--out",
     .argument = "NAME=FILE",
     .allowed = "an output of the recipe and a file, NAME=FILE, at most 15 times",
     .help = "the values of an output of the recipe, once for each of them: formats as heights",
     .otherwise = "not written",
     .parse = option_list,
     .offset = FIELD(out),
     .highest = GROUND_FIELDS_MOST,
     .of_run = 1},
    {.name = "--masks",
     .argument = "STEM",
     .allowed = "the beginning of file names: not empty, no separator at its end",
     .help = "how much of 255 is rock, snow, sand, vegetation and water, as the relief has them: "
             "STEM-rock and so on, .png or without zlib .pgm; of STEM.EXT, STEM-rock.EXT; of "
             "STEM.png two, told below",
     .otherwise = "not written",
     .parse = option_stem,
     .offset = FIELD(masks),
     .of_run = 1},
    {.name = "--output",
     .argument = "STEM",
     .allowed = "the beginning of file names: not empty, no separator at its end",
     .help = "short for STEM-height, STEM-normal, STEM-hillshade and STEM-relief: .png, or without "
             "zlib .pgm and .ppm",
     .otherwise = "terrain, if no file is asked for",
     .parse = option_stem,
     .offset = FIELD(output),
     .of_run = 1},
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
        "where the second component of normals grows, green (OpenGL: up; DirectX: down)")},
};

static const struct option tile_rows[] = {
    {OPTION_SIZE("--tile", tile, NULL, 1, 1e6,
                 "write tiles of so many samples, NAME_y_x or by patterns (see below): y counts "
                 "down from the top, x from the left, both from 0"),
     .otherwise = "one file"},
    {.name = "--tiles",
     .argument = "X0:X1,Y0:Y1",
     .allowed = "four integers X0:X1,Y0:Y1 from 0 to 1000000, X0 below X1 and Y0 below Y1",
     .help = "only those with X0 <= x < X1 and Y0 <= y < Y1",
     .otherwise = "all",
     .parse = option_range,
     .offset = FIELD(tiles),
     .lowest = 0,
     .highest = 1e6,
     .of_run = 1},
    {.name = "--share",
     .argument = "I/N",
     .allowed = "two integers I/N, N from 1 to 1000000 and I from 0 to N - 1",
     .help = "only share I, from 0, of N equal shares of these tiles, N from 1 to 1000000",
     .otherwise = "all",
     .parse = option_share,
     .offset = FIELD(share),
     .lowest = 0,
     .highest = 1e6,
     .of_run = 1},
    {OPTION_COUNT(
        "--overlap", overlap, "0", 0, 1024,
        "samples that a tile also has of its neighbours to the right and below (engines want 1)")},
    {OPTION_FLAG("--resume", resume,
                 "leave out tiles that are there already, and those that another run is writing: "
                 "runs with the same options share the work"),
     .of_run = 1},
    {OPTION_FLAG("--verify", verify,
                 "write nothing, but compare the files that are there with the checksums that the "
                 "runs which wrote them have kept"),
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
        ".tif       GeoTIFF in tiles of 256 x 256, deflated if there is zlib; more than 4 GB make\n"
        "           it a BigTIFF\n"
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
        "heights    floats are in the unit of x and y. Integers divide the interval that\n"
        "           heights never leave, and not what occurs, so tiles of one terrain fit\n"
        "           together: n stands for ZERO + n (FULL - ZERO) / 65535, and the run prints\n"
        "           ZERO and FULL. Of a recipe, scarp recipe tells that interval. Of one noise\n"
        "           it is the height times the amplitude times [-1, 1], or [0, 1] with\n"
        "           turbulence, ridged, swiss and jordan; hybrid has its own. The sea raises\n"
        "           its lower end, the plateau lowers its upper one. What flows reaches\n"
        "           further, but for ridged, swiss and pingpong: with --phase, also --phase 0,\n"
        "           the 1 is 1.0169038 (quintic) or 1.0162356 (cubic), with jordan its square:\n"
        "           all frames have one scale.\n"
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
        "           linear between, without rock, snow, sand and water, but lit. Its lines are\n"
        "           those of gdaldem color-relief, height red green blue [alpha], or a height\n"
        "           and a name (white, black, red, green, blue, yellow, magenta, cyan, aqua,\n"
        "           grey, lightgrey, darkgrey, orange, brown, purple, violet, indigo); 50% is\n"
        "           the height in the middle between 0 and 1 of above; alpha and lines of nv\n"
        "           are not used. Or they are GMT's, if FILE ends with .cpt or a comment tells\n"
        "           the COLOR_MODEL, which must be RGB: z0 red green blue z1 red green blue,\n"
        "           or red/green/blue or names; B and F for what is below and above; N is not\n"
        "           used. A line that begins with # is a comment.\n"
        "gradient   dx and dy.\n"
        "slope      the angle whose tangent is the length of the gradient.\n"
        "curvature  the mean curvature, 1 / R on top of a sphere of radius R. It is\n"
        "           -((1 + dy^2) dxx - 2 dx dy dxy + (1 + dx^2) dyy) / (2 (1 + dx^2 + dy^2)^1.5).\n"
        "           The sea has none. Erosion, swiss, jordan, gullies, slopes and distances in\n"
        "           cells have no second derivatives.\n"
        "out        Values are as the recipe has them, without --scale, which makes places "
        "larger,\n"
        "           and the height without the sea. 16-bit integers divide the interval that the\n"
        "           output never leaves, which the run prints.\n"
        "masks      STEM.png becomes STEM-1.png, whose red is rock, green snow, blue sand and "
        "alpha\n"
        "           vegetation, and STEM-2.png, whose red is water and all else 0. The five are "
        "255\n"
        "           together at each sample. What is none of the others, and shows the palette's\n"
        "           ramp, is vegetation; with desert it is sand, with arctic snow.\n"
        "compare    on the left the normals, on the right normals of the same places with dx and\n"
        "           dy by central differences of the 16-bit heights, two steps apart.\n"
        "tiles      hold the same samples as one file would. Those at the right and at the bottom\n"
        "           are smaller if the size is no multiple; the overlap goes beyond the raster.\n"
        "patterns   in FILE, {x} and {y} stand for the place of a tile from the left and from the\n"
        "           top, {-y} for that from the bottom, all from 0; {x:04} has at least four\n"
        "           digits. Directories are made. Without them tiles are called NAME_y_x.\n"
        "levels     Each sample of level n lies in the middle of the 2^n x 2^n samples that it\n"
        "           stands for, and octaves whose cells are smaller than two of its steps are "
        "left\n"
        "           out. The scale of integers and the colours are those of level 0. In FILE\n"
        "           {level} stands for n, {-level} for the number of levels after it. Tiles of "
        "all\n"
        "           levels have the same size; x and y count those of their level. Of one .tif,\n"
        "           levels are its overviews to GDAL: NAME.tif.ovr, NAME.tif.ovr.ovr and so on.\n"
        "world      FILE.json beside the tiles (y_x.png.json for w/{y}/{x}.png) tells what they "
        "all\n"
        "           depend on. The first run writes it; a run that would write other tiles is\n"
        "           refused. Remove it to begin anew: older tiles are then written again, and a\n"
        "           run that still goes on ends if that is another world.\n"
        "resume     takes a tile for complete if it is no older than the world, and as large as "
        "it\n"
        "           must be; PNG has to end as it must. Runs that share a world need no locks for\n"
        "           that; where locks reach, no tile is written twice.\n"
        "verify     Beside the manifest FILE.json a run keeps checksums in FILE.sums, share I of\n"
        "           N in FILE.I-N.sums: XXH64 of each file, which xxhsum -c reads, too.\n"
        "memory     40 MiB and 2 MiB per thread, unless 32 rows of all files together are more;\n"
        "           64 rows with a PNG, 512 with a TIFF, and what is packed once more.\n"
        "\n" PRESET_HELP,
    .groups = groups,
    .count = sizeof groups / sizeof groups[0],
    .standard = ground_standard,
    .removed = ground_removed,
};
