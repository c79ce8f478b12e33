/* SPDX-License-Identifier: MIT
 *
 * Kinds of terrain: sets of options of `scarp terrain` that go well together.
 */
#ifndef SCARP_CLI_PRESETS_H
#define SCARP_CLI_PRESETS_H

#define PRESET_NAMES "none, alps, dunes, islands, canyon, cirques or karst"

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
    "           --amplitude -1 --height 110"

#endif
