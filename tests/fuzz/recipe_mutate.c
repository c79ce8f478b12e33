/* SPDX-License-Identifier: MIT
 *
 *     recipe_mutate COUNT
 *
 * In place of libFuzzer: as many inputs of the fuzz target of recipes, made of the texts of
 * recipes.h and of random ones, of which some bytes, words or lines are changed.
 */
#include "fuzz.h"
#include "recipe.h"
#include "recipes.h"

static size_t mutate(struct recipe_writer *w, uint8_t *bytes, size_t size, size_t room)
{
    static const char *const words[] = {
        "noise(", "warp(",     "(",           ")",    ",",     "x",        "^3",     "^",  "-",
        " / ",    ": ",        "0",           "1e30", "flat(", "gullies(", "slope(", "\n", "out ",
        "param ", "space 3\n", "tile 4, 4\n", "#",    "at(",   "cell(",    "curve("};
    const uint32_t changes = recipe_draw(w, 4);
    for (uint32_t i = 0; i < changes; i++) {
        const size_t at = HEADER_SIZE + recipe_draw(w, (uint32_t)(size - HEADER_SIZE) + 1);
        const size_t cut =
            recipe_draw(w, 12) < size - at ? recipe_draw(w, 12) % (size - at + 1) : 0;
        const char *const word = words[recipe_draw(w, sizeof words / sizeof words[0])];
        const size_t length = recipe_draw(w, 2) == 0 ? strlen(word) : 0;
        if (size - cut + length > room) {
            continue;
        }
        memmove(bytes + at + length, bytes + at + cut, size - at - cut);
        memcpy(bytes + at, word, length);
        size += length - cut;
    }
    return size;
}

int main(int argc, char **argv)
{
    static struct recipe_writer w;
    static uint8_t bytes[17000];
    const int count = argc == 2 ? atoi(argv[1]) : 0;
    const struct recipe_counts *const counts = &recipe_counts;
    if (count < 1) {
        fprintf(stderr, "usage: recipe_mutate COUNT\n");
        return EXIT_FAILURE;
    }
    for (int i = 0; i < count; i++) {
        const char *text = recipe_texts[(size_t)i % RECIPE_TEXTS].text;
        if (i % 3 == 0) {
            recipe_write(&w, (uint64_t)i, 0);
            text = w.text;
        } else if (i % 3 == 1) {
            recipe_write_skips(&w, (uint64_t)i);
            text = w.text;
        }
        struct recipe_writer draw = {.state = (uint64_t)i};
        for (int k = 0; k < HEADER_SIZE; k++) {
            bytes[k] = (uint8_t)recipe_draw(&draw, 256);
        }
        bytes[HEADER_SHADER] &= i % 8 == 0 ? 255 : 254; /* which take long */
        size_t size = HEADER_SIZE + strlen(text);
        memcpy(bytes + HEADER_SIZE, text, size - HEADER_SIZE);
        size = mutate(&draw, bytes, size, sizeof bytes);
        LLVMFuzzerTestOneInput(bytes, size);
    }
    CHECK(counts->parsed == count && counts->read_well > count / 50 && counts->sampled > count / 50,
          "%ld texts, %ld are right, %ld samples", counts->parsed, counts->read_well,
          counts->sampled);
    printf("%ld texts, %ld are right, %ld samples\n", counts->parsed, counts->read_well,
           counts->sampled);
    return check_done();
}
