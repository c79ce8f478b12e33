/* SPDX-License-Identifier: MIT
 *
 * The recipes of the program make terrain: water runs off where they claim it, no direction of the
 * lattice shows, nothing jumps, and every value of their parameters will do.
 *
 *     test_presets SEEDS             all presets with seeds from 1 to SEEDS
 *     test_presets SEEDS --print     prints the figures, too
 *
 * What a preset claims is in its comments: `#: drains`, `#: directed` (its direction is meant),
 * `#: sand` (no slope is steeper than sand lies).
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "presets/presets.h"
#include "scarp.h"

#define SIDE 400    /* samples of the map on which water runs, */
#define STEP 3.0    /* and their distance */
#define WAVES 1024  /* samples of the map whose directions are looked at */
#define POOLED 0.02 /* basins shallower than this share of the relief do not count */
/* Shares of the land in closed basins where water runs off: of a map, and the mean over seeds */
#define MOST_POOLED 0.02
#define MEAN_POOLED 0.025

/* Presets of which single maps have more */
static const struct {
    const char *name;
    double most;
} more_pooled[] = {{"range", 0.12}, {"badlands", 0.04}};

static struct scarp_recipe recipe;
static float height[WAVES * WAVES], slope_x[WAVES * WAVES], slope_y[WAVES * WAVES];

struct preset_text {
    const char *name;
    char text[16385];
    int drains, is_directed, is_sand;
};

static double most_pooled(const char *name)
{
    double most = MOST_POOLED;
    for (size_t i = 0; i < sizeof more_pooled / sizeof more_pooled[0]; i++) {
        most = strcmp(name, more_pooled[i].name) == 0 ? more_pooled[i].most : most;
    }
    return most;
}

static void read_preset(int number, struct preset_text *preset)
{
    preset->name = preset_name(number);
    memcpy(preset->text, preset_list[number].text, preset_list[number].length);
    preset->text[preset_list[number].length] = '\0';
    preset->drains = strstr(preset->text, "#: drains") != NULL;
    preset->is_directed = strstr(preset->text, "#: directed") != NULL;
    preset->is_sand = strstr(preset->text, "#: sand") != NULL;
}

static void sample(size_t side, double step)
{
    static uint64_t memory[1 << 16];
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    const struct scarp_grid grid = {.step = {step, step}, .count = {side, side, 1}};
    const struct scarp_samples out = {.value = height, .dx = slope_x, .dy = slope_y};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    CHECK(scarp_recipe_grid(&recipe, &grid, &outputs, &scratch) == SCARP_OK, "no samples");
}

/* The level of the sea; minus infinity without one */
static float sea_of(const char *text)
{
    struct scarp_recipe_entry entry;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        if (entry.is_param && entry.name[1] - entry.name[0] == 3 &&
            memcmp(text + entry.name[0], "sea", 3) == 0) {
            return (float)entry.value;
        }
    }
    return -INFINITY;
}

/* A queue of samples, the lowest first */
struct queue {
    struct queued {
        float level;
        int sample;
    } heap[SIDE * SIDE];
    int count;
};

static void push(struct queue *queue, float level, int at)
{
    int child = queue->count++;
    while (child > 0 && queue->heap[(child - 1) / 2].level > level) {
        queue->heap[child] = queue->heap[(child - 1) / 2];
        child = (child - 1) / 2;
    }
    queue->heap[child] = (struct queued){level, at};
}

static struct queued pop(struct queue *queue)
{
    const struct queued first = queue->heap[0], last = queue->heap[--queue->count];
    int parent = 0;
    for (int child = 1; child < queue->count; child = 2 * parent + 1) {
        if (child + 1 < queue->count && queue->heap[child + 1].level < queue->heap[child].level) {
            child++;
        }
        if (queue->heap[child].level >= last.level) {
            break;
        }
        queue->heap[parent] = queue->heap[child];
        parent = child;
    }
    queue->heap[parent] = last;
    return first;
}

static float relief_of(size_t count)
{
    float lowest = INFINITY, highest = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        lowest = height[i] < lowest ? height[i] : lowest;
        highest = height[i] > highest ? height[i] : highest;
    }
    return highest - lowest;
}

/* The share of land in closed basins: water rises from the edges of the map and from the sea,
   always where it is lowest (Barnes et al. 2014, priority flood). */
static double closed_basins(float sea)
{
    static struct queue queue;
    static unsigned char is_wet[SIDE * SIDE];
    const float deep = (float)POOLED * relief_of((size_t)SIDE * SIDE);
    int land = 0, pooled = 0;
    memset(is_wet, 0, sizeof is_wet);
    queue.count = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const int x = i % SIDE, y = i / SIDE;
        if (x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1 || height[i] <= sea) {
            is_wet[i] = 1;
            push(&queue, height[i], i);
        }
        land += height[i] > sea;
    }
    while (queue.count > 0) {
        const struct queued here = pop(&queue);
        pooled += here.level - height[here.sample] > deep;
        for (int n = 0; n < 9; n++) {
            const int x = here.sample % SIDE + n % 3 - 1, y = here.sample / SIDE + n / 3 - 1;
            const int next = y * SIDE + x;
            if (x >= 0 && y >= 0 && x < SIDE && y < SIDE && !is_wet[next]) {
                is_wet[next] = 1;
                push(&queue, height[next] > here.level ? height[next] : here.level, next);
            }
        }
    }
    return land > 0 ? (double)pooled / land : 0.0;
}

/* The discrete Fourier transform of WAVES numbers, in place, `stride` apart (Cooley and Tukey). */
static void transform(double *re, double *im, size_t stride)
{
    for (size_t i = 0, j = 0; i < WAVES; i++) {
        if (i < j) {
            const double a = re[i * stride], b = im[i * stride];
            re[i * stride] = re[j * stride];
            im[i * stride] = im[j * stride];
            re[j * stride] = a;
            im[j * stride] = b;
        }
        size_t bit = WAVES / 2;
        for (; j & bit; bit /= 2) {
            j ^= bit;
        }
        j |= bit;
    }
    for (size_t half = 1; half < WAVES; half *= 2) {
        for (size_t k = 0; k < half; k++) {
            const double angle = -3.14159265358979323846 * (double)k / (double)half;
            const double c = cos(angle), s = sin(angle);
            for (size_t i = k; i < WAVES; i += 2 * half) {
                double *const ar = &re[i * stride], *const ai = &im[i * stride];
                double *const br = &re[(i + half) * stride], *const bi = &im[(i + half) * stride];
                const double tr = c * *br - s * *bi, ti = c * *bi + s * *br;
                *br = *ar - tr;
                *bi = *ai - ti;
                *ar += tr;
                *ai += ti;
            }
        }
    }
}

/* Power by direction, of waves from 64 to 512 samples long: how much more waves within 7.5 degrees
   of the axes have than others of their length, a sum over lengths and maps. */
struct directions {
    double ratio;
    int count;
};

static void add_directions(struct directions *sum)
{
    static double re[WAVES * WAVES], im[WAVES * WAVES];
    double mean = 0.0;
    for (size_t i = 0; i < (size_t)WAVES * WAVES; i++) {
        mean += (double)height[i] / (WAVES * WAVES);
    }
    for (size_t i = 0; i < (size_t)WAVES * WAVES; i++) {
        const double turn = 2.0 * 3.14159265358979323846 / WAVES;
        const double wx = 0.5 - 0.5 * cos(turn * (double)(i % WAVES));
        const double wy = 0.5 - 0.5 * cos(turn * (double)(i / WAVES));
        re[i] = ((double)height[i] - mean) * wx * wy;
        im[i] = 0.0;
    }
    for (size_t i = 0; i < WAVES; i++) {
        transform(re + i * WAVES, im + i * WAVES, 1);
    }
    for (size_t i = 0; i < 17; i++) { /* longer waves along x than these are not asked for */
        transform(re + i, im + i, WAVES);
    }
    for (int ring = 2; ring < 16; ring++) {
        double axes = 0.0, all = 0.0;
        int axis_waves = 0, waves = 0;
        for (int i = 0; i < 33 * 17; i++) {
            const int x = i % 17, y = i / 17 - 16;
            const double length = hypot(x, y);
            const size_t at = (size_t)((y + WAVES) % WAVES) * WAVES + (size_t)x;
            if (length < ring || length >= ring + 1) {
                continue;
            }
            const double power = re[at] * re[at] + im[at] * im[at];
            const double aside = (double)(abs(x) < abs(y) ? abs(x) : abs(y)) / length;
            const int is_axis = aside <= sin(7.5 / 180.0 * 3.14159265358979323846);
            waves++;
            all += power;
            axis_waves += is_axis;
            axes += is_axis ? power : 0.0;
        }
        sum->ratio += axes / axis_waves / (all / waves);
        sum->count++;
    }
}

/* The steepest slope, but for one sample in a thousand, in degrees */
static double steepest(size_t count)
{
    static uint32_t counts[9001];
    memset(counts, 0, sizeof counts);
    for (size_t i = 0; i < count; i++) {
        const double slope = hypot((double)slope_x[i], (double)slope_y[i]);
        counts[(int)(atan(slope) / 3.14159265358979323846 * 18000.0)]++;
    }
    size_t left = count / 1000;
    int degree = 9000;
    while (degree > 0 && counts[degree] <= left) {
        left -= counts[degree--];
    }
    return degree / 100.0;
}

/* Looks closely at the neighbours whose heights differ most from what their slopes say: between
   them, heights change by many small steps, or by one jump. Returns the share of the largest step.
 */
static double worst_jump(size_t side)
{
    enum { POINTS = 257 };
    static double x[POINTS], y[POINTS];
    static float between[POINTS];
    double worst = 0.0, step = 0.0, way = 0.0;
    size_t at = 0;
    for (size_t i = 0; i + side < side * side; i++) {
        const double rise = (double)height[i + side] - (double)height[i];
        const double most = fabs((double)slope_y[i]) + fabs((double)slope_y[i + side]);
        at = fabs(rise) - most > worst ? i : at;
        worst = fabs(rise) - most > worst ? fabs(rise) - most : worst;
    }
    for (size_t i = 0; i < POINTS; i++) {
        x[i] = (double)(at % side);
        y[i] = (double)(at / side) + (double)i / (POINTS - 1);
    }
    const struct scarp_samples out = {.value = between};
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    CHECK(scarp_recipe_sample_f64(&recipe, POINTS, x, y, NULL, &outputs, NULL) == SCARP_OK,
          "no samples");
    for (size_t i = 1; i < POINTS; i++) {
        const double rise = fabs((double)between[i] - (double)between[i - 1]);
        step = rise > step ? rise : step;
        way += rise;
    }
    return way > 0.0 ? step / way : 0.0;
}

/* Everything about a preset with all seeds */
static void look_at(const struct preset_text *preset, int seeds, int prints)
{
    double most = 0.0, sum = 0.0, steep = 0.0, jump = 0.0;
    struct directions directions = {.count = 0};
    for (int seed = 1; seed <= seeds; seed++) {
        scarp_recipe_seed(&recipe, (uint64_t)seed);
        sample(SIDE, STEP);
        const double share = closed_basins(sea_of(preset->text));
        most = share > most ? share : most;
        sum += share;
        if (preset->drains) {
            CHECK(share <= most_pooled(preset->name),
                  "%s, seed %d: %.1f %% of the land lies in closed basins", preset->name, seed,
                  100.0 * share);
        }
        sample(WAVES, 4.0);
        add_directions(&directions);
        sample(WAVES, 1.0);
        const double degrees = steepest((size_t)WAVES * WAVES);
        steep = degrees > steep ? degrees : steep;
        const double over = worst_jump(WAVES);
        jump = over > jump ? over : jump;
    }
    if (prints) {
        printf("%-10s basins %.2f %% at most, %.2f mean; axes %.2f; steepest %.1f degrees; jump "
               "%.4f\n",
               preset->name, 100.0 * most, 100.0 * sum / seeds, directions.ratio / directions.count,
               steep, jump);
    }
    CHECK(!preset->drains || sum / seeds <= MEAN_POOLED,
          "%s: %.1f %% of the land lies in closed basins, a mean over seeds", preset->name,
          100.0 * sum / seeds);
    if (!preset->is_directed && seeds >= 12) { /* few seeds have few waves */
        CHECK(directions.ratio / directions.count <= 1.15,
              "%s: the axes have %.2f times the mean power", preset->name,
              directions.ratio / directions.count);
    }
    if (preset->is_sand) {
        CHECK(steep <= 34.0, "%s: sand lies at %.1f degrees", preset->name, steep);
    }
    CHECK(jump < 0.25, "%s: heights jump: %.2f of a rise is one step", preset->name, jump);
}

/* The ends of each parameter's interval, one at a time */
static void check_parameters(const struct preset_text *preset)
{
    struct scarp_recipe_entry entry;
    struct scarp_recipe changed;
    for (size_t i = 0; scarp_recipe_entry_at(&recipe, i, &entry) == SCARP_OK; i++) {
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)(entry.name[1] - entry.name[0]),
                 preset->text + entry.name[0]);
        for (int end = 0; end < 2 && entry.is_param; end++) {
            float lowest = NAN, highest = NAN;
            changed = recipe;
            CHECK(fabs(entry.slider[end]) < 1e9, "%s: %s has no interval", preset->name, name);
            CHECK(scarp_recipe_set(&changed, name, entry.slider[end], NULL) == SCARP_OK,
                  "%s: %s=%g will not do", preset->name, name, entry.slider[end]);
            CHECK(scarp_recipe_range(&changed, SCARP_RECIPE_OUTPUT, NULL, &lowest, &highest) ==
                          SCARP_OK &&
                      highest - lowest < INFINITY,
                  "%s: %s=%g has no range", preset->name, name, entry.slider[end]);
        }
    }
}

/* The first line says what it is, and fits into help. The palette is one of the program's. */
static void check_comments(const struct preset_text *preset)
{
    static const char *const palettes[] = {"alpine", "temperate", "desert", "arctic", "grey"};
    const char *const palette = strstr(preset->text, "#: palette ");
    int is_known = 0;
    CHECK(strncmp(preset->text, "# ", 2) == 0 && strcspn(preset->text, "\n") <= 72,
          "%s: the first line is no comment of at most 70 characters", preset->name);
    for (int i = 0; palette != NULL && i < 5; i++) {
        is_known |= strncmp(palette + strlen("#: palette "), palettes[i], strlen(palettes[i])) == 0;
    }
    CHECK(is_known, "%s: no palette of the program", preset->name);
}

/* Each noise has a seed of its own, so no two of them are equal, in no preset. */
static void check_seeds(void)
{
    static int seen[10000];
    static struct preset_text preset;
    for (int i = 1; preset_name(i) != NULL; i++) {
        read_preset(i, &preset);
        for (const char *at = preset.text; (at = strstr(at, "seed=")) != NULL; at++) {
            const int seed = atoi(at + 5);
            CHECK(seed > 0 && seed < 10000 && !seen[seed], "%s: seed %d is there twice",
                  preset.name, seed);
            seen[seed] = 1;
        }
        for (const char *at = preset.text; (at = strstr(at, "noise(")) != NULL; at++) {
            const size_t length = strcspn(at, ")");
            const char *const seed = strstr(at, "seed=");
            CHECK(seed != NULL && seed < at + length, "%s: a noise has no seed of its own",
                  preset.name);
        }
    }
}

int main(int argc, char **argv)
{
    static struct preset_text preset;
    const int seeds = argc > 1 ? atoi(argv[1]) : 0;
    if (seeds < 1) {
        fprintf(stderr, "usage: test_presets SEEDS [--print] [NAME]\n");
        return 2;
    }
    check_seeds();
    for (int i = 1; preset_name(i) != NULL; i++) {
        if (argc > 3 && strcmp(argv[3], preset_name(i)) != 0) {
            continue;
        }
        struct scarp_recipe_error error = {.text = NULL};
        read_preset(i, &preset);
        CHECK(scarp_recipe_parse(preset.text, strlen(preset.text), &recipe, &error, 1, NULL) ==
                  SCARP_OK,
              "%s, line %d: %s", preset.name, (int)error.line, error.text);
        check_comments(&preset);
        check_parameters(&preset);
        look_at(&preset, seeds, argc > 2);
    }
    return check_done();
}
