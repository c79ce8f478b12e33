/* SPDX-License-Identifier: MIT
 *
 *     test_recipe_bits [--must-differ] ISA COUNT FILE
 *     test_recipe_bits --print          hashes for that file, tests/recipes.txt
 *
 * What must not change a bit of a recipe: points or grids, the size of the scratch memory, a plan,
 * where the recipe lies, which other outputs are asked for, and the kernel set. All texts of recipes.h,
 * and COUNT random ones, each with all orders of derivatives that it has.
 */
#include "recipes.h"

#define WIDTH 21
#define HEIGHT 11
#define DEPTH 5
#define MOST (WIDTH * HEIGHT * DEPTH)
#define ARRAYS 10

static struct scarp_recipe recipe, copy;
static double position[3][MOST];
static float float_position[3][MOST];
static uint64_t memory[1 << 17];
static uint64_t plan[1 << 16]; /* of the recipe */

struct result {
    float array[ARRAYS][MOST];
};
static struct result reference, met;

static struct scarp_grid grid_of(int is_space)
{
    const struct scarp_grid grid = {.origin = {-3.25, 1.5, 0.75},
                                    .step = {0.37, 0.41, 0.83},
                                    .count = {WIDTH, HEIGHT, is_space ? DEPTH : 1}};
    return grid;
}

static size_t spread(int is_space)
{
    const struct scarp_grid g = grid_of(is_space);
    size_t i = 0;
    for (size_t z = 0; z < g.count[2]; z++) {
        for (size_t y = 0; y < g.count[1]; y++) {
            for (size_t x = 0; x < g.count[0]; x++, i++) {
                position[0][i] = g.origin[0] + (double)x * g.step[0];
                position[1][i] = g.origin[1] + (double)y * g.step[1];
                position[2][i] = g.origin[2] + (double)z * g.step[2];
                for (int a = 0; a < 3; a++) {
                    float_position[a][i] = (float)position[a][i];
                }
            }
        }
    }
    return i;
}

enum how { POINTS, GRID, FLOATS };

static uint64_t hash; /* of the results of the scalar kernels for a text */

static void add_to_hash(const struct result *r)
{
    for (int i = 0; i < ARRAYS; i++) {
        for (int k = 0; k < MOST; k++) {
            uint32_t bits = 0x7fc00000u; /* NaN */
            if (r->array[i][k] == r->array[i][k]) {
                memcpy(&bits, &r->array[i][k], sizeof bits);
            }
            for (int byte = 0; byte < 4; byte++) {
                hash = fnv_byte(hash, bits >> 8 * byte & 255);
            }
        }
    }
}

/* Whatever is in the scratch memory before */
static enum scarp_status evaluate(const struct scarp_recipe *of, enum how how, int order,
                                  int is_space, const struct scarp_scratch *scratch,
                                  struct result *to)
{
    const struct scarp_samples out = recipe_samples(to->array[0], MOST, order, is_space);
    const struct scarp_recipe_outputs outputs = {.out = &out, .count = 1};
    const struct scarp_grid grid = grid_of(is_space);
    const size_t count = (size_t)(WIDTH * HEIGHT * (is_space ? DEPTH : 1));
    memset(to, 0, sizeof *to);
    memset(memory, scratch != NULL && scratch->size % 3 == 0 ? 0 : 0xff, 1 << 16);
    return how == GRID     ? scarp_recipe_grid(of, &grid, &outputs, scratch)
           : how == POINTS ? scarp_recipe_sample_f64(of, count, position[0], position[1],
                                                     position[2], &outputs, scratch)
                           : scarp_recipe_sample(of, count, float_position[0], float_position[1],
                                                 float_position[2], &outputs, scratch);
}

/* One text, with one order. */
static void check_order(const char *name, enum scarp_isa isa, int order, int is_space)
{
    const size_t sizes[] = {0, scarp_recipe_scratch_size(&recipe, order, 48),
                            scarp_recipe_scratch_size(&recipe, order, 200), sizeof memory};
    const struct scarp_scratch whole = {.memory = memory, .size = sizeof memory};
    (void)scarp_isa_select(SCARP_ISA_SCALAR);
    const enum scarp_status status = evaluate(&recipe, POINTS, order, is_space, &whole, &reference);
    CHECK(status == SCARP_OK, "%s, order %d: %s", name, order, scarp_status_text(status));
    add_to_hash(&reference);
    (void)scarp_isa_select(isa);
    for (int i = 0; i < 4; i++) {
        for (int how = POINTS; how <= GRID; how++) {
            const struct scarp_scratch scratch = {
                .memory = (char *)memory + i, .size = sizes[i], .plan = i > 1 ? plan : NULL};
            const enum scarp_status s = evaluate(i == 1 ? &copy : &recipe, (enum how)how, order,
                                                 is_space, i == 0 ? NULL : &scratch, &met);
            CHECK(s == SCARP_OK || (i == 0 && s == SCARP_ERROR_SIZE), "%s, order %d, %s: %s", name,
                  order, how == GRID ? "grid" : "points", scarp_status_text(s));
            CHECK_BITS(
                s != SCARP_OK || recipe_same(reference.array[0], met.array[0], ARRAYS * MOST),
                "%s, order %d, %s, scratch %d", name, order, how == GRID ? "grid" : "points", i);
        }
    }
    (void)scarp_isa_select(SCARP_ISA_SCALAR);
    (void)evaluate(&recipe, FLOATS, order, is_space, &whole, &reference);
    add_to_hash(&reference);
    (void)scarp_isa_select(isa);
    const struct scarp_scratch small = {.memory = memory, .size = sizes[1], .plan = plan};
    (void)evaluate(&copy, FLOATS, order, is_space, &small, &met);
    CHECK_BITS(recipe_same(reference.array[0], met.array[0], ARRAYS * MOST), "%s, order %d, floats",
               name, order);
}

/* Values do not depend on the derivatives that are asked for. */
static void check_values(const char *name, int order, int is_space)
{
    const struct scarp_scratch whole = {.memory = memory, .size = sizeof memory};
    (void)evaluate(&recipe, POINTS, order, is_space, &whole, &reference);
    (void)evaluate(&recipe, POINTS, 0, is_space, &whole, &met);
    CHECK_BITS(memcmp(reference.array[0], met.array[0], sizeof met.array[0]) == 0,
               "%s: values differ with derivatives", name);
}

/* Random recipes may pass a limit. */
static void check_text(const char *name, const char *text, enum scarp_isa isa, int is_random)
{
    struct scarp_recipe_error error = {0};
    const enum scarp_status status =
        scarp_recipe_parse(text, strlen(text), &recipe, &error, 1, NULL);
    if (is_random && status == SCARP_ERROR_SIZE) {
        return;
    }
    hash = FNV_BASIS;
    CHECK(status == SCARP_OK, "%s: %d:%d: %s\n%s", name, (int)error.line, (int)error.column,
          error.text != NULL ? error.text : "", text);
    if (status != SCARP_OK) {
        return;
    }
    (void)scarp_recipe_seed(&recipe, fnv_text(name));
    memcpy(&copy, &recipe, sizeof copy);
    CHECK(scarp_recipe_plan_make(&recipe, plan, sizeof plan) == SCARP_OK, "%s: no plan", name);
    const int is_space = strstr(text, "space 3") != NULL, most = recipe_order(&recipe);
    (void)spread(is_space);
    for (int order = 0; order <= most && !check_enough(); order++) {
        check_order(name, isa, order, is_space);
    }
    check_values(name, most, is_space);
}

/* Outputs that are computed at once are the same as each alone: those that others need, those that
   nobody needs, and those that are computed once per column of a grid, in any order. */
static void check_together(enum scarp_isa isa)
{
    enum { OUTPUTS = 5, WAYS = 2 };
    static const char together[] =
        SPACE "out a = n * z\nout b = flat(m)\nout c = a + b\nout d = flat(noise(seed=5)) * 2\n"
              "out e = m - n";
    static struct result results[OUTPUTS];
    struct scarp_samples out[OUTPUTS];
    const struct scarp_grid grid = grid_of(1);
    const struct scarp_recipe_outputs all = {.out = out, .count = OUTPUTS};
    (void)scarp_isa_select(isa);
    CHECK(scarp_recipe_parse(together, strlen(together), &recipe, NULL, 0, NULL) == SCARP_OK, "%s",
          together);
    (void)spread(1);
    for (int way = 0; way < WAYS * 3; way++) {
        const int order = way / WAYS;
        const size_t least = scarp_recipe_scratch_size(&recipe, order, 48);
        const struct scarp_scratch scratch = {.memory = memory,
                                              .size = way % WAYS == 0 ? sizeof memory : least};
        memset(results, 0, sizeof results);
        for (int i = 0; i < OUTPUTS; i++) {
            out[i] = recipe_samples(results[i].array[0], MOST, order, 1);
        }
        CHECK(scarp_recipe_grid(&recipe, &grid, &all, &scratch) == SCARP_OK, "order %d", order);
        for (int32_t i = 0; i < OUTPUTS; i++) {
            const struct scarp_samples alone = recipe_samples(reference.array[0], MOST, order, 1);
            const int32_t which = i + 2; /* after n and m */
            const struct scarp_recipe_outputs one = {.out = &alone, .which = &which, .count = 1};
            memset(&reference, 0, sizeof reference);
            CHECK(scarp_recipe_sample_f64(&recipe, MOST, position[0], position[1], position[2],
                                          &one, &scratch) == SCARP_OK,
                  "output %d", (int)i);
            CHECK_BITS(recipe_same(reference.array[0], results[i].array[0], ARRAYS * MOST),
                       "output %d of %d, order %d, scratch %d", (int)i, OUTPUTS, order, way % WAYS);
        }
    }
}

/* The hash that FILE has for a name; 0: none. */
static uint64_t golden_hash(FILE *file, const char *name)
{
    char line[128], word[64];
    unsigned long long golden;
    rewind(file);
    while (fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%63s %llx", word, &golden) == 2 && strcmp(word, name) == 0) {
            return (uint64_t)golden;
        }
    }
    return 0;
}

/* Others that grids and points must agree on: displaced by the first node of the text, and places
   in places. */
static void check_more_texts(enum scarp_isa isa)
{
    static const char *const texts[] = {
        "recipe 1\nspace 3\na = at(noise(seed=2), x + noise(), y, 0.5)",
        "recipe 1\nspace 3\nu = noise()\na = at(noise(seed=2), u, y, 0.5)",
        SPACE "a = turn(stretch(move(turn(n, 40, y), 1, 2, 3), 0.5, 2, 3), 30, x)",
        SPACE "a = wind(turn(n * z, 20, x), 30, 2) + 0 * m",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        check_text(texts[i], texts[i], isa, 0);
    }
}

static void check_texts(enum scarp_isa isa, FILE *file)
{
    for (size_t i = 0; i < RECIPE_TEXTS && !check_enough(); i++) {
        const char *const name = recipe_texts[i].name;
        check_text(name, recipe_texts[i].text, isa, 0);
        if (file == NULL) {
            printf("%s %016llx\n", name, (unsigned long long)hash);
        } else if (!check_enough()) {
            CHECK_BITS(golden_hash(file, name) == hash, "%s: the hash is %016llx", name,
                       (unsigned long long)hash);
        }
    }
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    if (argc == 2 && strcmp(argv[1], "--print") == 0) {
        check_texts(SCARP_ISA_SCALAR, NULL);
        return EXIT_SUCCESS;
    }
    if (argc != 4) {
        fprintf(stderr, "usage: test_recipe_bits [--must-differ] ISA COUNT FILE | --print\n");
        return EXIT_FAILURE;
    }
    const enum scarp_isa isa = check_select_isa(argv[1]);
    const int count = atoi(argv[2]);
    FILE *const file = fopen(argv[3], "r");
    if (file == NULL) {
        fprintf(stderr, "cannot read %s\n", argv[3]);
        return EXIT_FAILURE;
    }
    check_texts(isa, file);
    (void)fclose(file);
    check_together(isa);
    check_more_texts(isa);
    for (int i = 0; i < count && !check_enough(); i++) {
        static struct recipe_writer w;
        char name[32];
        recipe_write(&w, (uint64_t)i, i % 2);
        snprintf(name, sizeof name, "random %d", i);
        check_text(name, w.text, isa, 1);
    }
    return check_done();
}
