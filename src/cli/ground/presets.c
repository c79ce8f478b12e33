/* SPDX-License-Identifier: MIT
 *
 * The presets. cli/README.md shows what they look like.
 */
#include "ground/presets.h"

#include <stddef.h>

#include "shared/options.h"

static option_words none = {NULL};

/* Ridges on high ground alone: the mask is the first octaves of the base, a hybrid, whose low
   ground is flat. */
static option_words alps = {"--fractal",
                            "swiss",
                            "--rotate",
                            "--frequency",
                            "0.005",
                            "--octaves",
                            "9",
                            "--gain",
                            "0.45",
                            "--height",
                            "110",
                            "--warp-reach",
                            "75",
                            "--warp-frequency",
                            "0.0035",
                            "--warp-octaves",
                            "5",
                            "--base-amplitude",
                            "1.4",
                            "--base-fractal",
                            "hybrid",
                            "--base-rotate",
                            "--base-frequency",
                            "0.0016",
                            "--base-octaves",
                            "8",
                            "--base-gain",
                            "0.42",
                            "--mask-band",
                            "-0.5,0.25",
                            "--mask-rotate",
                            "--mask-frequency",
                            "0.0016",
                            "--mask-octaves",
                            "3",
                            NULL};

/* Each octave but the first would draw its own dunes across those of the others. */
static option_words dunes = {"--fractal",
                             "ridged",
                             "--frequency",
                             "0.012",
                             "--octaves",
                             "1",
                             "--height",
                             "24",
                             "--stretch",
                             "3",
                             "--wind",
                             "250",
                             "--warp-reach",
                             "40",
                             "--warp-frequency",
                             "0.008",
                             "--warp-octaves",
                             "2",
                             "--base-amplitude",
                             "0.5",
                             "--base-frequency",
                             "0.003",
                             "--base-octaves",
                             "2",
                             "--mask-band",
                             "-0.7,0.2",
                             "--mask-frequency",
                             "0.004",
                             NULL};

static option_words islands = {"--fractal", "erosion",     "--erosion", "0.25",
                               "--rotate",  "--frequency", "0.0045",    "--octaves",
                               "8",         "--gain",      "0.46",      "--height",
                               "170",       "--sea-level", "0.05",      NULL};

/* Valleys are where the noise changes its sign; terraces are the strata of their walls. */
static option_words canyon = {
    "--fractal", "turbulence",       "--rotate", "--frequency",        "0.0022", "--octaves",
    "8",         "--gain",           "0.36",     "--height",           "400",    "--warp-reach",
    "80",        "--warp-frequency", "0.004",    "--warp-octaves",     "4",      "--terraces",
    "14",        "--terrace-riser",  "0.4",      "--terrace-strength", "0.7",    NULL};

static option_words badlands = {"--fractal",   "swiss",
                                "--sharpness", "0.25",
                                "--rotate",    "--frequency",
                                "0.008",       "--octaves",
                                "8",           "--gain",
                                "0.45",        "--height",
                                "55",          "--warp-reach",
                                "50",          "--warp-frequency",
                                "0.005",       "--warp-octaves",
                                "4",           "--warp-gain",
                                "0.4",         "--base-amplitude",
                                "0.6",         "--base-frequency",
                                "0.002",       "--base-octaves",
                                "3",           "--terraces",
                                "16",          "--terrace-strength",
                                "0.5",         NULL};

static option_words hills = {"--fractal", "erosion",
                             "--erosion", "0.5",
                             "--rotate",  "--frequency",
                             "0.004",     "--octaves",
                             "9",         "--gain",
                             "0.38",      "--height",
                             "95",        "--warp-reach",
                             "90",        "--warp-frequency",
                             "0.003",     "--warp-octaves",
                             "4",         "--warp-gain",
                             "0.4",       NULL};

/* The square of the distance is 1 at the features of cells, and falls the less steeply the farther
   it is from them: cones, down to the sea. With more octaves it would jump, as scarp.h says. */
static option_words volcanic = {"--basis",
                                "cell-f1",
                                "--fractal",
                                "jordan",
                                "--octaves",
                                "1",
                                "--frequency",
                                "0.0016",
                                "--crater",
                                "0.77",
                                "--height",
                                "280",
                                "--sea-level",
                                "0.1",
                                "--warp-reach",
                                "80",
                                "--warp-frequency",
                                "0.003",
                                "--warp-octaves",
                                "7",
                                "--warp-gain",
                                "0.48",
                                "--base-amplitude",
                                "0.28",
                                "--base-fractal",
                                "erosion",
                                "--base-rotate",
                                "--base-frequency",
                                "0.006",
                                "--base-octaves",
                                "8",
                                "--base-gain",
                                "0.44",
                                NULL};

/* The warp makes ranges of what would be round hills. */
static option_words highlands = {"--fractal", "jordan",
                                 "--erosion", "0.8",
                                 "--rotate",  "--frequency",
                                 "0.005",     "--octaves",
                                 "8",         "--gain",
                                 "0.42",      "--height",
                                 "170",       "--warp-reach",
                                 "60",        "--warp-octaves",
                                 "3",         NULL};

/* The soft distance is low at features and high between them: basins in a net of crests. */
static option_words cirques = {"--basis",   "cell-soft", "--fractal", "erosion",
                               "--erosion", "0.3",       "--rotate",  "--frequency",
                               "0.004",     "--octaves", "8",         "--gain",
                               "0.44",      "--height",  "130",       NULL};

/* The distance turned over: domes with gullies between them. */
static option_words karst = {"--basis",   "cell-f1",  "--rotate", "--frequency", "0.0045",
                             "--octaves", "8",        "--gain",   "0.36",        "--amplitude",
                             "-1",        "--height", "110",      NULL};

static option_words crests = {"--fractal", "swiss",          "--sharpness", "0.25",
                              "--rotate",  "--frequency",    "0.0045",      "--octaves",
                              "8",         "--gain",         "0.45",        "--height",
                              "90",        "--warp-reach",   "60",          "--warp-frequency",
                              "0.0035",    "--warp-octaves", "4",           NULL};

/* The cirques, bent with all their layers */
static option_words folds = {
    "--basis",  "cell-soft",   "--fractal", "erosion",      "--erosion", "0.3",
    "--rotate", "--frequency", "0.004",     "--octaves",    "8",         "--gain",
    "0.42",     "--height",    "130",       "--warp-reach", "80",        "--warp-octaves",
    "3",        NULL};

const char *const preset_names[] = {"none",     "alps",   "dunes",    "islands",   "canyon",
                                    "badlands", "hills",  "volcanic", "highlands", "cirques",
                                    "karst",    "crests", "folds",    NULL};
const char *const *const preset_words[] = {none,     alps,   dunes,    islands,   canyon,
                                           badlands, hills,  volcanic, highlands, cirques,
                                           karst,    crests, folds};

const char *const preset_palettes[] = {"alpine",    "alpine",    "desert", "temperate", "desert",
                                       "desert",    "temperate", "alpine", "alpine",    "alpine",
                                       "temperate", "alpine",    "alpine"};
