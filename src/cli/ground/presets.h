/* SPDX-License-Identifier: MIT
 *
 * Kinds of terrain: sets of options of `scarp terrain` that go well together.
 */
#ifndef SCARP_CLI_PRESETS_H
#define SCARP_CLI_PRESETS_H

#define PRESETS_FIRST "none, alps, dunes, islands, canyon, cirques,"
#define PRESETS_LAST "karst, crests, hills or folds"
#define PRESET_NAMES PRESETS_FIRST " " PRESETS_LAST

extern const char *const preset_names[];        /* ends with NULL */
extern const char *const *const preset_words[]; /* by name: options, as they would be typed */

/* The help; a test holds it against preset_words. */
#define PRESET_HELP                                                                                \
    "presets    are options that go before those of the command line, wherever --preset "          \
    "stands:\n"                                                                                    \
    "  alps     --fractal ridged --rotate --frequency 0.0035 --octaves 7 --gain 0.42\n"            \
    "           --height 100\n"                                                                    \
    "  dunes    --fractal ridged --rotate --frequency 0.0022 --octaves 2 --lacunarity 3.5\n"       \
    "           --gain 8 --height 42\n"                                                            \
    "  islands  --fractal erosion --erosion 0.25 --rotate --frequency 0.0045 --octaves 8\n"        \
    "           --gain 0.46 --height 170 --sea-level 0.05\n"                                       \
    "  canyon   --fractal turbulence --rotate --frequency 0.004 --octaves 8 --gain 0.36\n"         \
    "           --height 260 --plateau 0.22\n"                                                     \
    "  cirques  --basis cell-soft --fractal erosion --erosion 0.3 --rotate --frequency 0.004\n"    \
    "           --octaves 8 --gain 0.44 --height 130\n"                                            \
    "  karst    --basis cell-f1 --rotate --frequency 0.0045 --octaves 8 --gain 0.36\n"             \
    "           --amplitude -1 --height 110\n"                                                     \
    "  crests   --fractal swiss --rotate --frequency 0.0045 --octaves 8 --gain 0.45\n"             \
    "           --height 65\n"                                                                     \
    "  hills    --fractal jordan --erosion 0.8 --rotate --frequency 0.005 --octaves 8\n"           \
    "           --gain 0.42 --height 170 --warp-reach 60 --warp-octaves 3\n"                       \
    "  folds    --basis cell-soft --fractal erosion --erosion 0.3 --rotate --frequency 0.004\n"    \
    "           --octaves 8 --gain 0.42 --height 130 --warp-reach 80 --warp-octaves 3"

#endif
