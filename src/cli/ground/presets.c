/* SPDX-License-Identifier: MIT
 *
 * The presets. The README shows what they look like.
 */
#include "ground/presets.h"

#include <stddef.h>

#include "shared/options.h"

static option_words none = {NULL};
static option_words alps = {"--fractal", "ridged", "--rotate", "--frequency", "0.0035", "--octaves",
                            "7",         "--gain", "0.42",     "--height",    "100",    NULL};

/* The gain makes the second octave the dunes; the first one, faint, is where v_1 of ridged noise
   lets them be. A third octave would hide both. */
static option_words dunes = {"--fractal", "ridged",   "--rotate",     "--frequency", "0.0022",
                             "--octaves", "2",        "--lacunarity", "3.5",         "--gain",
                             "8",         "--height", "42",           NULL};

static option_words islands = {"--fractal", "erosion",     "--erosion", "0.25",
                               "--rotate",  "--frequency", "0.0045",    "--octaves",
                               "8",         "--gain",      "0.46",      "--height",
                               "170",       "--sea-level", "0.05",      NULL};

/* Valleys are where the noise changes its sign; the plateau leaves nothing else. */
static option_words canyon = {"--fractal", "turbulence", "--rotate", "--frequency", "0.004",
                              "--octaves", "8",          "--gain",   "0.36",        "--height",
                              "260",       "--plateau",  "0.22",     NULL};

/* The soft distance is low at features and high between them: basins in a net of crests. */
static option_words cirques = {"--basis",   "cell-soft", "--fractal", "erosion",
                               "--erosion", "0.3",       "--rotate",  "--frequency",
                               "0.004",     "--octaves", "8",         "--gain",
                               "0.44",      "--height",  "130",       NULL};

/* The distance turned over: domes with gullies between them. */
static option_words karst = {"--basis",   "cell-f1",  "--rotate", "--frequency", "0.0045",
                             "--octaves", "8",        "--gain",   "0.36",        "--amplitude",
                             "-1",        "--height", "110",      NULL};

static option_words crests = {"--fractal", "swiss",     "--rotate", "--frequency",
                              "0.0045",    "--octaves", "8",        "--gain",
                              "0.45",      "--height",  "65",       NULL};

/* The warp makes ranges of what would be round hills. */
static option_words hills = {"--fractal", "jordan",
                             "--erosion", "0.8",
                             "--rotate",  "--frequency",
                             "0.005",     "--octaves",
                             "8",         "--gain",
                             "0.42",      "--height",
                             "170",       "--warp-reach",
                             "60",        "--warp-octaves",
                             "3",         NULL};

/* The cirques, bent with all their layers */
static option_words folds = {
    "--basis",  "cell-soft",   "--fractal", "erosion",      "--erosion", "0.3",
    "--rotate", "--frequency", "0.004",     "--octaves",    "8",         "--gain",
    "0.42",     "--height",    "130",       "--warp-reach", "80",        "--warp-octaves",
    "3",        NULL};

const char *const preset_names[] = {"none",  "alps",   "dunes", "islands", "canyon", "cirques",
                                    "karst", "crests", "hills", "folds",   NULL};
const char *const *const preset_words[] = {none,    alps,  dunes,  islands, canyon,
                                           cirques, karst, crests, hills,   folds};
