/* SPDX-License-Identifier: MIT
 *
 *     test_gpu_recipe DIRECTORY      that of scarp.glsl, scarp.hlsl and scarp.wgsl
 *
 * Recipes as the text of shaders: it is whole, has nothing that nobody calls, and depends on what
 * it is said to depend on; and what the calls refuse. gpu.recipes runs it.
 */
#include "recipes.h"

enum { CAPACITY = 1 << 18 };

static struct scarp_recipe recipe;
static char text[CAPACITY], other[CAPACITY];
static char files[3][1 << 18];
static struct scarp_shader how[3];

static void read_files(const char *directory)
{
    static const char *const names[] = {"glsl", "hlsl", "wgsl"};
    for (int i = 0; i < 3; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/scarp.%s", directory, names[i]);
        FILE *const file = fopen(path, "rb");
        if (file == NULL) {
            perror(path);
            exit(EXIT_FAILURE);
        }
        how[i].language = i;
        how[i].file = files[i];
        how[i].length = fread(files[i], 1, sizeof files[i], file);
        CHECK(how[i].length > 1000 && how[i].length < sizeof files[i], "%s", path);
        fclose(file);
    }
}

static void open_recipe(const char *of)
{
    struct scarp_recipe_error error = {0};
    CHECK(scarp_recipe_parse(of, strlen(of), &recipe, &error, 1, NULL) == SCARP_OK, "%d:%d: %s",
          (int)error.line, (int)error.column, error.text);
}

static size_t write_shader(int language, int order, char *to)
{
    size_t length = 0;
    how[language].order = order;
    const enum scarp_status status =
        scarp_recipe_shader(&recipe, &how[language], to, CAPACITY, &length);
    CHECK(status == SCARP_OK && strlen(to) == length, "%s", scarp_status_text(status));
    return length;
}

static int is_in_name(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

/* How often `name(` of `length` is in the text, and how often it is declared. */
static int count_calls(const char *name, size_t length, int *declared)
{
    int calls = 0;
    *declared = 0;
    for (const char *at = strstr(text, "scarp_"); at != NULL; at = strstr(at + 1, "scarp_")) {
        if (strncmp(at, name, length) == 0 && at[length] == '(' && !is_in_name(at[-1])) {
            const int is_declared = at - text >= 3 && strncmp(at - 3, "fn ", 3) == 0;
            *declared += is_declared;
            calls += !is_declared;
        }
    }
    return calls;
}

static int is_one_of(const char *name, const char *beginning)
{
    return strncmp(name, beginning, strlen(beginning)) == 0;
}

/* In WGSL each function that is called is there once, and each that is there is called, but for
   those that the recipe offers, and what is in its own text anyway. */
static void check_whole(const char *name)
{
    for (const char *at = strstr(text, "scarp_"); at != NULL; at = strstr(at + 1, "scarp_")) {
        size_t length = 0;
        while (is_in_name(at[length])) {
            length++;
        }
        int declared;
        if (at[length] != '(' || is_in_name(at[-1])) {
            continue;
        }
        const int calls = count_calls(at, length, &declared);
        const int is_offered = is_one_of(at, "scarp_recipe") || is_one_of(at, "scarp_own_") ||
                               is_one_of(at, "scarp_answer_recipe") ||
                               is_one_of(at, "scarp_add(") || is_one_of(at, "scarp_sub(") ||
                               is_one_of(at, "scarp_mul(");
        CHECK(declared == 1, "%s: %.*s is declared %d times", name, (int)length, at, declared);
        CHECK(calls > 0 || is_offered, "%s: nobody calls %.*s", name, (int)length, at);
    }
}

/* A variable of scarp_recipe(): a letter and the number of a node, as r12, or open and that of a
   guard. */
struct variable {
    char name[16];
    int depth; /* of the block that declares it */
};

static const char *end_of_word(const char *at)
{
    while (is_in_name(*at) || (*at >= 'A' && *at <= 'Z')) {
        at++;
    }
    return at;
}

/* In GLSL, variables are used after their declaration, which is the word behind a type, and in its
   block. */
static void check_scopes(const char *name)
{
    static struct variable known[1024];
    int count = 0, depth = 0, follows = 0; /* follows: a word and one space */
    const char *at = strstr(text, "ScarpRecipe scarp_recipe(float");
    CHECK(at != NULL, "%s: no function", name);
    for (at = at != NULL ? strchr(at, '{') : ""; *at != '\0'; at++) {
        const char *const end = end_of_word(at);
        const size_t length = (size_t)(end - at);
        depth += (*at == '{') - (*at == '}');
        if (depth == 0) {
            break;
        }
        while (*at == '}' && count > 0 && known[count - 1].depth > depth) {
            count--;
        }
        const int is_numbered = at[0] >= 'a' && at[1] <= '9';
        if (length > 1 && length < sizeof known[0].name && at[-1] != '.' &&
            (is_numbered || is_one_of(at, "open"))) {
            int i = 0;
            while (i < count &&
                   (strncmp(known[i].name, at, length) != 0 || known[i].name[length] != '\0')) {
                i++;
            }
            CHECK((i < count) != follows, "%s: %.*s %s", name, (int)length, at,
                  follows ? "is declared twice" : "is not declared here");
            if (follows) {
                known[count].depth = depth;
                snprintf(known[count++].name, sizeof known[0].name, "%.*s", (int)length, at);
            }
        }
        follows = length > 0 && *end == ' ' && is_in_name(end[1]);
        at = length > 0 ? end - (*end != ' ') : at;
    }
    CHECK(depth == 0 && *at == '}', "%s: blocks end", name);
}

/* Looking for what nobody calls takes long: `is_whole` asks for it. */
static void check_text(const char *name, int is_whole)
{
    for (int language = 0; language < 3; language++) {
        const size_t length = write_shader(language, 2, text);
        CHECK(strstr(text, "scarp_plan[") == NULL && strstr(text, "scarp_recipe(") != NULL &&
                  strstr(text, "scarp_answer_recipe(") != NULL,
              "%s, language %d", name, language);
        CHECK(length < how[language].length, "%s: cut to %zu of %zu bytes", name, length,
              how[language].length);
        if (language == SCARP_WGSL && is_whole) {
            check_whole(name);
        } else if (language == SCARP_GLSL) {
            check_scopes(name);
        }
    }
}

/* Noises that share a warp, each in a block of its own, and in the block around */
static void check_shared_warps(void)
{
    static const char *const texts[] = {
        PLANE "w = noise(amplitude=0.3)\n"
              "a = mix(warp(n, w), warp(m, w), smoothstep(noise(seed=3), -0.1, 0.1))",
        "recipe 1\nw = noise(amplitude=0.3)\na = mix(warp(noise(seed=1), w), "
        "warp(noise(seed=2), w), smoothstep(noise(seed=3), -0.1, 0.1)) + warp(noise(seed=4), w)",
        PLANE "w = noise(amplitude=0.3)\na = warp(n, w) + warp(m, w) * smoothstep(n, -0.1, 0.1)",
        PLANE "w = noise(amplitude=0.3)\na = warp(n * x + m, w) * smoothstep(n, -0.1, 0.1)",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        open_recipe(texts[i]);
        (void)write_shader(0, 2, text);
        check_scopes(texts[i]);
        CHECK(strstr(text, "; c < 2u; c++") != NULL && strstr(text, "; c < 3u; c++") == NULL,
              "%s: warps of the plane have two components", texts[i]);
    }
    open_recipe(SPACE "w = noise(amplitude=0.3)\na = warp(n, w)");
    (void)write_shader(0, 2, text);
    CHECK(strstr(text, "; c < 3u; c++") != NULL, "warps of space have three components");
}

/* Noises of different kinds have functions of their own. */
static void check_kinds(void)
{
    static const char *const noises[] = {"noise()", "noise(value)", "noise(cubic)",
                                         "noise(rotate, octaves=2)", "noise(ridged, octaves=2)"};
    for (int i = 1; i < 5; i++) {
        char both[128];
        snprintf(both, sizeof both, "recipe 1\nout a = %s\nout b = %s\n", noises[0], noises[i]);
        open_recipe(both);
        (void)write_shader(0, 0, text);
        CHECK(strstr(text, "scarp_own_kind1(uint") != NULL &&
                  strstr(text, "scarp_own_kind2(uint") == NULL,
              "%s: two kinds", both);
    }
    static const struct {
        const char *noise, *call;
        int number;
    } calls[] = {{"cubic", "gradient_at", SCARP_CUBIC},
                 {"value", "value_at", SCARP_QUINTIC},
                 {"cell_f2", "cells_at", SCARP_CELL_F2}};
    for (int i = 0; i < 3; i++) {
        char one[64], call[64];
        snprintf(one, sizeof one, "recipe 1\nout a = noise(%s)\n", calls[i].noise);
        snprintf(call, sizeof call, "scarp_%s(scarp_lattice_of(o, l), %du", calls[i].call,
                 calls[i].number);
        open_recipe(one);
        (void)write_shader(0, 0, text);
        CHECK(strstr(text, call) != NULL, "%s: no %s", one, call);
    }
    open_recipe("recipe 1\nout a = noise()\nout b = noise(seed=5, size=3)\n");
    (void)write_shader(0, 0, text);
    CHECK(strstr(text, "scarp_own_kind1(uint") == NULL, "seeds and sizes are of one kind");
}

/* A capacity that does not suffice: the call says one that does, and writes no byte beyond. */
static void check_capacities(void)
{
    open_recipe(recipe_texts[0].text);
    const size_t length = write_shader(0, 1, text);
    const size_t capacities[] = {0, 1, 100, length / 2, length - 1, length};
    for (size_t i = 0; i < sizeof capacities / sizeof capacities[0]; i++) {
        size_t wanted = 0;
        memset(other, 0x5a, sizeof other);
        CHECK(scarp_recipe_shader(&recipe, &how[0], capacities[i] > 0 ? other : NULL, capacities[i],
                                  &wanted) == SCARP_ERROR_SIZE,
              "capacity %zu", capacities[i]);
        CHECK(other[capacities[i]] == 0x5a && wanted >= length, "capacity %zu: %zu", capacities[i],
              wanted);
        CHECK(scarp_recipe_shader(&recipe, &how[0], other, wanted + 1, &wanted) == SCARP_OK &&
                  strcmp(text, other) == 0,
              "the capacity that it says suffices");
    }
}

/* Seeds and numbers change the buffer, and not the text. */
static void check_uniforms(void)
{
    static unsigned char before[65536], after[65536];
    size_t size = 0, least = 0;
    open_recipe("recipe 1\nparam a = 2 [0, 9]\nn = noise(rotate, octaves=3)\nout b = a * n + x\n");
    (void)write_shader(2, 2, text);
    CHECK(scarp_recipe_uniforms(&recipe, before, sizeof before, &size) == SCARP_OK &&
              size % 16 == 0 && size >= 16 + 48 + 3 * 160,
          "%zu bytes", size);
    CHECK(scarp_recipe_uniforms(&recipe, NULL, 0, &least) == SCARP_ERROR_SIZE && least == size,
          "the size is said");
    memset(after, 0x5a, sizeof after);
    CHECK(scarp_recipe_uniforms(&recipe, after, size - 1, &least) == SCARP_ERROR_SIZE &&
              after[0] == 0x5a,
          "nothing is written");
    (void)scarp_recipe_seed(&recipe, 7);
    (void)write_shader(2, 2, other);
    CHECK(strcmp(text, other) == 0, "the text is the same with another seed");
    CHECK(scarp_recipe_uniforms(&recipe, after, sizeof after, &least) == SCARP_OK &&
              least == size && memcmp(before, after, size) != 0,
          "the buffer is not");
    CHECK(after[size] == 0x5a, "nothing is written beyond the buffer");
    memcpy(before, after, size);
    CHECK(scarp_recipe_set(&recipe, "a", 3.5, NULL) == SCARP_OK, "set");
    (void)write_shader(2, 2, other);
    CHECK(strcmp(text, other) == 0, "the text is the same with another number");
    CHECK(scarp_recipe_uniforms(&recipe, after, sizeof after, &least) == SCARP_OK &&
              least == size && memcmp(before, after, size) != 0,
          "the buffer is not");
    CHECK(scarp_recipe_set(&recipe, "a", 1.0, NULL) == SCARP_OK, "set");
    (void)write_shader(2, 2, other);
    CHECK(strcmp(text, other) != 0, "a factor of 1 is another text");
    CHECK(scarp_recipe_set(&recipe, "a", 2.0, NULL) == SCARP_OK, "set");
    (void)write_shader(2, 2, other);
    CHECK(strcmp(text, other) == 0, "the text is that of before again");
    (void)write_shader(2, 1, other);
    CHECK(strcmp(text, other) != 0, "the text depends on the order");
    CHECK(scarp_recipe_scale(&recipe, 2.0, 3.0, NULL) == SCARP_OK, "scale");
    (void)write_shader(2, 2, text);
    CHECK(scarp_recipe_scale(&recipe, 5.0, 7.0, NULL) == SCARP_OK, "scale");
    (void)write_shader(2, 2, other);
    CHECK(strcmp(text, other) == 0, "the text is the same with other factors that are not 1");
}

/* The buffer of each text is as long as it says, and nothing beyond is written. A curve has x,
   value, slope and the inverse of the length to the next knot. */
static void check_buffers(void)
{
    static unsigned char buffer[65536];
    static const float knots[2][4] = {{0.5f, 1.0f, 0.0f, 0.25f}, {4.5f, 5.0f, 0.0f, 0.0f}};
    float found[2][4];
    for (size_t i = 0; i < RECIPE_TEXTS; i++) {
        size_t size = 0, again = 0;
        open_recipe(recipe_texts[i].text);
        (void)scarp_recipe_uniforms(&recipe, NULL, 0, &size);
        memset(buffer, 0x5a, sizeof buffer);
        CHECK(size < sizeof buffer &&
                  scarp_recipe_uniforms(&recipe, buffer, size, &again) == SCARP_OK &&
                  again == size && buffer[size] == 0x5a,
              "%s: %zu bytes", recipe_texts[i].name, size);
    }
    size_t size = 0;
    open_recipe("recipe 1\na = curve(x, 0.5: 1, 4.5: 5)\n");
    (void)scarp_recipe_uniforms(&recipe, buffer, sizeof buffer, &size);
    memcpy(found, buffer + 16, sizeof found);
    CHECK(memcmp(found, knots, sizeof found) == 0, "knots: %g %g %g %g, %g %g %g %g",
          (double)found[0][0], (double)found[0][1], (double)found[0][2], (double)found[0][3],
          (double)found[1][0], (double)found[1][1], (double)found[1][2], (double)found[1][3]);
}

/* The hash of header and shaders, of one output. */
static uint32_t hash_with(uint32_t hash, float output)
{
    uint32_t bits;
    memcpy(&bits, &output, sizeof bits);
    bits = (bits & 0x7fffffffu) < 0x03800000u ? 0 : bits;
    return ((hash << 5 | hash >> 27) ^ bits) * 0x9e3779b9u;
}

/* Answers are hashes of outputs: equal ones of equal outputs, and only of those up to the order.
 */
static void check_answers(void)
{
    static uint32_t answers[3][SCARP_GPU_ANSWERS], constant[SCARP_GPU_ANSWERS];
    open_recipe("recipe 1\nout a = noise(octaves=2)\nout b = noise(swiss, octaves=2)\n");
    for (int order = 0; order < 3; order++) {
        CHECK(scarp_recipe_answers(&recipe, order, answers[order]) == SCARP_OK, "%d", order);
    }
    CHECK(memcmp(answers[0], answers[1], sizeof answers[0]) != 0 &&
              memcmp(answers[1], answers[2], sizeof answers[0]) != 0,
          "answers depend on the order");
    open_recipe("recipe 1\nparam k = 1.5\nout a = k + 0 * x\n");
    CHECK(scarp_recipe_answers(&recipe, 1, constant) == SCARP_OK, "a number");
    const uint32_t expected = hash_with(hash_with(hash_with(0, 1.5f), 0.0f), 0.0f);
    for (int i = 0; i < SCARP_GPU_ANSWERS; i++) {
        CHECK(constant[i] == expected, "answer %d: %08x, not %08x", i, constant[i], expected);
    }
}

static void check_errors(void)
{
    size_t length;
    uint32_t answers[1];
    struct scarp_shader wrong;
    open_recipe(recipe_texts[0].text);
    how[0].order = 1;
    CHECK(scarp_recipe_shader(NULL, &how[0], text, CAPACITY, &length) == SCARP_ERROR_NULL &&
              scarp_recipe_shader(&recipe, NULL, text, CAPACITY, &length) == SCARP_ERROR_NULL &&
              scarp_recipe_shader(&recipe, &how[0], NULL, 1, &length) == SCARP_ERROR_NULL &&
              scarp_recipe_shader(&recipe, &how[0], text, CAPACITY, NULL) == SCARP_ERROR_NULL,
          "NULL");
    wrong = how[0];
    wrong.file = NULL;
    CHECK(scarp_recipe_shader(&recipe, &wrong, text, CAPACITY, &length) == SCARP_ERROR_NULL,
          "no file");
    wrong = how[0];
    wrong.language = 3;
    CHECK(scarp_recipe_shader(&recipe, &wrong, text, CAPACITY, &length) == SCARP_ERROR_ENUM,
          "language");
    wrong = how[0];
    wrong.order = 3;
    CHECK(scarp_recipe_shader(&recipe, &wrong, text, CAPACITY, &length) == SCARP_ERROR_PARAMETER,
          "order");
    wrong = how[0];
    wrong.spare[11] = 1;
    CHECK(scarp_recipe_shader(&recipe, &wrong, text, CAPACITY, &length) == SCARP_ERROR_UNSUPPORTED,
          "a reserved member");
    for (int i = 0; i < 9; i++) { /* a file of another language */
        wrong = how[i / 3];
        wrong.language = i % 3;
        wrong.order = 1;
        CHECK(scarp_recipe_shader(&recipe, &wrong, text, CAPACITY, &length) ==
                  (i / 3 == i % 3 ? SCARP_OK : SCARP_ERROR_PARAMETER),
              "file %d as language %d", i / 3, i % 3);
    }
    wrong = how[0];
    wrong.file = "void main() {}\n";
    wrong.length = strlen(wrong.file);
    CHECK(scarp_recipe_shader(&recipe, &wrong, text, CAPACITY, &length) == SCARP_ERROR_PARAMETER,
          "another file");
    CHECK(scarp_recipe_uniforms(NULL, text, CAPACITY, &length) == SCARP_ERROR_NULL &&
              scarp_recipe_uniforms(&recipe, text, CAPACITY, NULL) == SCARP_ERROR_NULL &&
              scarp_recipe_answers(NULL, 0, answers) == SCARP_ERROR_NULL &&
              scarp_recipe_answers(&recipe, 0, NULL) == SCARP_ERROR_NULL &&
              scarp_recipe_answers(&recipe, 3, answers) == SCARP_ERROR_PARAMETER,
          "NULL, and an order");
    (void)scarp_recipe_parse("recipe 1\na = b\n", 15, &recipe, NULL, 0, NULL);
    CHECK(scarp_recipe_shader(&recipe, &how[0], text, CAPACITY, &length) == SCARP_ERROR_PARAMETER &&
              scarp_recipe_uniforms(&recipe, text, CAPACITY, &length) == SCARP_ERROR_PARAMETER &&
              scarp_recipe_answers(&recipe, 0, answers) == SCARP_ERROR_PARAMETER,
          "a recipe with an error");
}

/* Names of outputs that shading languages do not have as they are. */
static void check_names(void)
{
    open_recipe(
        "recipe 1\nn = noise()\nout a__b = n\nout a_b = 2 * n\nout _c_ = n\nout float = n\n");
    (void)write_shader(0, 0, text);
    CHECK(strstr(text, "scarp_recipe_a_b(") != NULL && strstr(text, "scarp_recipe_c_(") != NULL &&
              strstr(text, "scarp_recipe_float(") != NULL && strstr(text, "__") == NULL,
          "names");
    const char *const first = strstr(text, "ScarpSample scarp_recipe_a_b(");
    CHECK(first != NULL && strstr(first + 1, "ScarpSample scarp_recipe_a_b(") == NULL,
          "of two outputs that have the same name, the first one has it");
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        printf("usage: test_gpu_recipe DIRECTORY\n");
        return EXIT_FAILURE;
    }
    read_files(argv[1]);
    for (size_t i = 0; i < RECIPE_TEXTS; i++) {
        open_recipe(recipe_texts[i].text);
        check_text(recipe_texts[i].name, i % 8 == 0);
    }
    check_shared_warps();
    check_kinds();
    check_buffers();
    check_capacities();
    check_uniforms();
    check_answers();
    check_errors();
    check_names();
    return check_done();
}
