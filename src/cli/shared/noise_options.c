/* SPDX-License-Identifier: MIT
 *
 * The rows of the options that say which noise. Their defaults are those of struct scarp_noise.
 */
#include "shared/noise_options.h"

#include <stddef.h>
#include <string.h>

#include "shared/error.h"
#include "shared/members.h"
#include "shared/number.h"

#define FIELD(name) offsetof(struct noise_options, name)
#define TEXT(x) #x
#define TEXT_OF(x) TEXT(x)
#define STANDARD(member) TEXT_OF(NOISE_##member##_DEFAULT)

static const char *basis_word(int basis)
{
    return scarp_basis_name((enum scarp_basis)basis);
}

static const char *fade_word(int fade)
{
    return scarp_fade_name((enum scarp_fade)fade);
}

static const char *fractal_word(int fractal)
{
    return scarp_fractal_name((enum scarp_fractal)fractal);
}

const struct option noise_seed_rows[NOISE_SEED_ROWS] = {
    {OPTION_READ(option_seed, "N", "--seed", seed,
                 "an integer from -2^63 to 2^64 - 1, decimal or 0x and hexadecimal",
                 "each seed is another noise: an integer of 64 bits, decimal or 0x..."),
     .standard = "0"},
};

const struct option noise_option_rows[NOISE_OPTION_COUNT] = {
    {OPTION_CHOICE("--basis", basis, "gradient", basis_word, "the noise of an octave")},
    {OPTION_POSITIVE(
        "--jitter", jitter, STANDARD(JITTER), NOISE_JITTER_BOUNDS,
        "with --basis cell-..., how far features, the random points of cells, stray from the "
        "middles of their cells")},
    {OPTION_CHOICE("--fade", fade, "quintic", fade_word, "how lattice points are blended")},
    {OPTION_CHOICE("--fractal", fractal, "fbm", fractal_word,
                   "how octaves are summed (erosion, swiss and jordan of cell-f1, cell-f2 and "
                   "cell-edge have cliffs)")},
    {OPTION_FLOAT("--erosion", erosion, STANDARD(EROSION), NOISE_EROSION_BOUNDS,
                  "with --fractal erosion, how strongly slopes damp octaves; with jordan, how "
                  "strongly flat ground damps them, at most 1")},
    {OPTION_FLOAT(
        "--sharpness", sharpness, NULL, NOISE_SHARPNESS_BOUNDS,
        "with --fractal pingpong, how often octaves are folded [2]; with hybrid, how high they lie "
        "[0.7]; with swiss and jordan, how far slopes bend them [0.15, 0.35]")},
    {OPTION_DOUBLE("--frequency", frequency, STANDARD(FREQUENCY), NOISE_FREQUENCY_BOUNDS,
                   "lattice cells of the first octave per unit of the coordinates")},
    {OPTION_POSITIVE("--octaves", octaves, STANDARD(OCTAVES), NOISE_OCTAVES_BOUNDS,
                     "octaves that are summed, the last one faded in by a fraction")},
    {OPTION_POSITIVE("--of-octaves", of_octaves, NULL, NOISE_OCTAVES_BOUNDS,
                     "compute the first --octaves of a sum of so many octaves, with the amplitudes "
                     "that they have in that sum"),
     .otherwise = "--octaves"},
    {OPTION_FLOAT("--lacunarity", lacunarity, STANDARD(LACUNARITY), NOISE_LACUNARITY_BOUNDS,
                  "frequency ratio from octave to octave")},
    {OPTION_FLOAT("--gain", gain, STANDARD(GAIN), NOISE_GAIN_BOUNDS,
                  "amplitude ratio from octave to octave")},
    {OPTION_READ(
         option_float, "F", "--phase", phase, "a finite number, at most 2^128 - 2^104 in magnitude",
         "how far the gradients of the lattice are turned, in turns: as it grows, the noise "
         "flows in place, and loops after 1; any finite float, only with --basis gradient"),
     .otherwise = "it stands still", .lowest = -0x1.fffffep127, .highest = 0x1.fffffep127},
    {OPTION_FLAG("--rotate", rotate,
                 "turn the axes between octaves: hides the lattice's directions")},
    {OPTION_MAGNITUDE("--amplitude", amplitude, STANDARD(AMPLITUDE), NOISE_AMPLITUDE_BOUNDS,
                      "what values are multiplied by; a negative one turns them over")},
};

/* Where a fault has to do with other options: these, besides that of the member, and what helps */
static const struct {
    const char *member;
    enum scarp_status status;
    const char *others, *advice;
} advices[] = {
    {"rotate", SCARP_ERROR_UNSUPPORTED, "", "; leave it out with --period"},
    {"phase", SCARP_ERROR_UNSUPPORTED, "", "; leave it out or take --basis gradient"},
    {"period", SCARP_ERROR_UNSUPPORTED, "", "; leave it out or take another --basis"},
    {"period", SCARP_ERROR_PARAMETER, "", "; fewer --octaves or a lower --lacunarity will do"},
    {"octaves", SCARP_ERROR_PARAMETER, "--frequency, --lacunarity, ", ""},
};

/* Each number was checked by itself; what is left is how they go together. The option is called as
   the member, which has no index then, and `-` for `_`. */
static void refuse(enum scarp_status status, const char *member, const char *reason)
{
    const char *others = "", *advice = "";
    char option[16];
    size_t length = 0;
    while (length < sizeof option - 1 && member[length] != '\0' && member[length] != '[') {
        option[length] = member[length] == '_' ? '-' : member[length];
        length++;
    }
    option[length] = '\0';
    for (size_t i = 0; i < sizeof advices / sizeof *advices; i++) {
        if (advices[i].status == status && strcmp(advices[i].member, option) == 0) {
            others = advices[i].others;
            advice = advices[i].advice;
        }
    }
    cli_error("%s--%s: %s%s", others, option, reason, advice);
}

/* What flows reaches further than what does not, so at 0 the library's range is another one
   than at all other phases, and 16-bit heights would have another scale. A whole turn later the
   noise has the same bits, and the range of the other frames. */
static float phase_of(const struct noise_options *options)
{
    return options->phase == NOISE_UNSET ? 0.0f : options->phase == 0.0f ? 1.0f : options->phase;
}

static float given(float number)
{
    return number == NOISE_UNSET ? 0.0f : number;
}

static struct scarp_noise noise_of(const struct noise_options *options)
{
    struct scarp_noise noise = {
        .basis = (enum scarp_basis)options->basis,
        .fade = (enum scarp_fade)options->fade,
        .fractal = (enum scarp_fractal)options->fractal,
        .rotate = (uint32_t)options->rotate,
        .seed = options->seed,
        .frequency = options->frequency,
        .octaves = options->octaves,
        .lacunarity = options->lacunarity,
        .gain = options->gain,
        .amplitude = options->amplitude,
        .erosion = options->erosion,
        .jitter = options->jitter,
        .phase = phase_of(options),
        .sharpness = given(options->sharpness),
        .of_octaves = given(options->of_octaves),
        .offset_first = 1, /* as in recipes */
    };
    memcpy(noise.period, options->period, sizeof noise.period);
    return noise;
}

bool noise_make(const struct noise_options *options, int dimensions, struct scarp_noise *made)
{
    const char *member;
    *made = noise_of(options);
    const enum scarp_status status = scarp_noise_check(made, dimensions, &member);
    if (status != SCARP_OK) {
        refuse(status, member, scarp_noise_fault(made, dimensions, 0, 0, NULL));
    }
    return status == SCARP_OK;
}

/* Adds a comma, but for the first argument, and a word, of which `-` becomes `_`. */
static void add_word(struct text *text, bool *is_first, const char *word)
{
    text_add(text, "%s", *is_first ? "" : ", ");
    *is_first = false;
    for (; *word != '\0'; word++) {
        text_add(text, "%c", *word == '-' ? '_' : *word);
    }
}

static void add_member(struct text *text, bool *is_first, const char *name, double value,
                       bool is_float)
{
    char number[NUMBER_SIZE];
    number_write_shortest(number, value, is_float);
    add_word(text, is_first, name);
    text_add(text, "=%s", number);
}

void noise_write(const struct noise_options *options, struct text *text)
{
    const struct noise_options *const o = options;
    const struct {
        const char *name;
        float value, standard;
    } members[] = {
        {"octaves", o->octaves, NOISE_OCTAVES_DEFAULT},
        {"of_octaves", o->of_octaves, NOISE_UNSET},
        {"lacunarity", o->lacunarity, NOISE_LACUNARITY_DEFAULT},
        {"gain", o->gain, NOISE_GAIN_DEFAULT},
        {"amplitude", o->amplitude, NOISE_AMPLITUDE_DEFAULT},
        {"erosion", o->erosion, NOISE_EROSION_DEFAULT},
        {"jitter", o->jitter, NOISE_JITTER_DEFAULT},
        {"sharpness", o->sharpness, NOISE_UNSET},
    };
    bool is_first = true;
    text_add(text, "noise(");
    if (o->basis != SCARP_GRADIENT) {
        add_word(text, &is_first, basis_word(o->basis));
    }
    if (o->fractal != SCARP_FBM) {
        add_word(text, &is_first, fractal_word(o->fractal));
    }
    if (o->fade != SCARP_QUINTIC) {
        add_word(text, &is_first, fade_word(o->fade));
    }
    if (o->rotate) {
        add_word(text, &is_first, "rotate");
    }
    add_member(text, &is_first, "frequency", o->frequency, false);
    for (size_t i = 0; i < sizeof members / sizeof members[0]; i++) {
        if (members[i].value != members[i].standard) {
            add_member(text, &is_first, members[i].name, (double)members[i].value, true);
        }
    }
    if (o->phase != NOISE_UNSET) {
        add_word(text, &is_first, "phase=phase");
    }
    text_add(text, ")");
}
