/* SPDX-License-Identifier: MIT
 *
 * Kinds of terrain: sets of the options of ground_options.h that go well together.
 */
#ifndef SCARP_CLI_PRESETS_H
#define SCARP_CLI_PRESETS_H

#define PRESETS_FIRST "none, alps, dunes, islands, canyon, badlands, hills,"
#define PRESETS_LAST "volcanic, highlands, cirques, karst, crests or folds"
#define PRESET_NAMES PRESETS_FIRST " " PRESETS_LAST

extern const char *const preset_names[];        /* ends with NULL */
extern const char *const *const preset_words[]; /* by name: options, as they would be typed */
extern const char *const preset_palettes[];     /* by name: the palette that suits it */

/* The help; a test holds it against preset_words. */
#define PRESET_HELP                                                                                \
    "presets    are options that go before those of the command line, wherever --preset "          \
    "stands:\n"                                                                                    \
    "  alps      --fractal swiss --rotate --frequency 0.005 --octaves 9 --gain 0.45\n"             \
    "            --height 110 --warp-reach 75 --warp-frequency 0.0035 --warp-octaves 5\n"          \
    "            --base-amplitude 1.4 --base-fractal hybrid --base-rotate\n"                       \
    "            --base-frequency 0.0016 --base-octaves 8 --base-gain 0.42\n"                      \
    "            --mask-band -0.5,0.25 --mask-rotate --mask-frequency 0.0016 --mask-octaves 3\n"   \
    "  dunes     --fractal ridged --frequency 0.012 --octaves 1 --height 24 --stretch 3\n"         \
    "            --wind 250 --warp-reach 40 --warp-frequency 0.008 --warp-octaves 2\n"             \
    "            --base-amplitude 0.5 --base-frequency 0.003 --base-octaves 2\n"                   \
    "            --mask-band -0.7,0.2 --mask-frequency 0.004\n"                                    \
    "  islands   --fractal erosion --erosion 0.25 --rotate --frequency 0.0045 --octaves 8\n"       \
    "            --gain 0.46 --height 170 --sea-level 0.05\n"                                      \
    "  canyon    --fractal turbulence --rotate --frequency 0.0022 --octaves 8 --gain 0.36\n"       \
    "            --height 400 --warp-reach 80 --warp-frequency 0.004 --warp-octaves 4\n"           \
    "            --terraces 14 --terrace-riser 0.4 --terrace-strength 0.7\n"                       \
    "  badlands  --fractal swiss --sharpness 0.25 --rotate --frequency 0.008 --octaves 8\n"        \
    "            --gain 0.45 --height 55 --warp-reach 50 --warp-frequency 0.005\n"                 \
    "            --warp-octaves 4 --warp-gain 0.4 --base-amplitude 0.6 --base-frequency 0.002\n"   \
    "            --base-octaves 3 --terraces 16 --terrace-strength 0.5\n"                          \
    "  hills     --fractal erosion --erosion 0.5 --rotate --frequency 0.004 --octaves 9\n"         \
    "            --gain 0.38 --height 95 --warp-reach 90 --warp-frequency 0.003\n"                 \
    "            --warp-octaves 4 --warp-gain 0.4\n"                                               \
    "  volcanic  --basis cell-f1 --fractal jordan --octaves 1 --frequency 0.0016\n"                \
    "            --crater 0.77 --height 280 --sea-level 0.1 --warp-reach 80\n"                     \
    "            --warp-frequency 0.003 --warp-octaves 7 --warp-gain 0.48\n"                       \
    "            --base-amplitude 0.28 --base-fractal erosion --base-rotate\n"                     \
    "            --base-frequency 0.006 --base-octaves 8 --base-gain 0.44\n"                       \
    "  highlands --fractal jordan --erosion 0.8 --rotate --frequency 0.005 --octaves 8\n"          \
    "            --gain 0.42 --height 170 --warp-reach 60 --warp-octaves 3\n"                      \
    "  cirques   --basis cell-soft --fractal erosion --erosion 0.3 --rotate --frequency 0.004\n"   \
    "            --octaves 8 --gain 0.44 --height 130\n"                                           \
    "  karst     --basis cell-f1 --rotate --frequency 0.0045 --octaves 8 --gain 0.36\n"            \
    "            --amplitude -1 --height 110\n"                                                    \
    "  crests    --fractal swiss --sharpness 0.25 --rotate --frequency 0.0045 --octaves 8\n"       \
    "            --gain 0.45 --height 90 --warp-reach 60 --warp-frequency 0.0035\n"                \
    "            --warp-octaves 4\n"                                                               \
    "  folds     --basis cell-soft --fractal erosion --erosion 0.3 --rotate --frequency 0.004\n"   \
    "            --octaves 8 --gain 0.42 --height 130 --warp-reach 80 --warp-octaves 3"

#endif
