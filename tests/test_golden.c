/* SPDX-License-Identifier: MIT
 *
 * Results have the same bits everywhere: the hashes of outputs equal those in golden.txt, which
 * were computed once. Comparing with the scalar kernels of the same build is not enough: a compiler
 * may have changed both alike.
 *
 *     test_golden FILE ISA                every group of cases has a line in FILE, NAME HASH, and
 *                                         every line a group, in any order; the hashes are equal
 *     test_golden FILE ISA EVERY          the same for one of EVERY groups; lines may be left over
 *     test_golden --must-differ FILE ISA  the same, but hashes must differ: for mutants
 *     test_golden --frozen FILE           the lines of version 0.2 are as they were released
 *     test_golden --renew FILE            writes FILE again, for new cases. Names that it lacks get
 *                                         a third word: their lines are not of 0.2
 */
#include "cases.h"
#include "chain.h"
#include "gullies.h"
#include "vectors.h"

/* The cases of a group differ in what is asked for and in the precision of coordinates. One hash
   goes over all their outputs. */
#define POINTS 1031       /* two whole parts of the widest vectors, and a tail */
#define VECTOR_POINTS 263 /* the same of vectors that are half as wide */
#define LINES_MAX 65536

struct line {
    char name[80], mark[8]; /* the third word, "" of lines of 0.2 */
    unsigned long long hash;
    int used;
};

/* The lines of 0.2: how many there are, and a hash of their names and hashes. Results of released
   versions do not change, so neither do these. */
#define FROZEN_LINES 2028
#define FROZEN_HASH 0x2a4336b6c0252a32ull

static struct line *lines;
static size_t line_count;
static FILE *renewed; /* what is written instead of comparing; NULL: nothing */

static void read_lines(const char *path)
{
    char text[256];
    FILE *const golden = fopen(path, "r");
    if (golden == NULL) {
        printf("cannot read %s\n", path);
        exit(EXIT_FAILURE);
    }
    lines = check_allocate(LINES_MAX * sizeof *lines);
    while (fgets(text, sizeof text, golden) != NULL) {
        struct line *const line = &lines[line_count];
        line->used = 0;
        line->mark[0] = '\0';
        CHECK(line_count < LINES_MAX - 1 &&
                  sscanf(text, "%79s %llx %7s", line->name, &line->hash, line->mark) >= 2,
              "line %zu: %s", line_count + 1, text);
        line_count += check_failures == 0;
    }
    fclose(golden);
}

/* The first line of this name that no case has used. */
static struct line *find_line(const char *name)
{
    static size_t at; /* after the last one that was found, where the next one should be */
    for (size_t i = 0; i < line_count; i++, at++) {
        struct line *const line = &lines[at % line_count];
        if (!line->used && strcmp(line->name, name) == 0) {
            line->used = 1;
            return line;
        }
    }
    return NULL;
}

static void visit(const char *name, uint64_t hash)
{
    const struct line *const line = find_line(name);
    if (renewed != NULL) {
        fprintf(renewed, "%s %016llx%s%s\n", name, (unsigned long long)hash,
                line != NULL && line->mark[0] == '\0' ? "" : " ",
                line == NULL ? "added" : line->mark);
        return;
    }
    CHECK(line != NULL, "%s has no line", name);
    CHECK_BITS(line == NULL || line->hash == hash, "%s: %016llx, golden: %016llx", name,
               (unsigned long long)hash, line->hash);
}

/* Functions of samples, of three flowing noises at the points of a class. */
static void visit_chain(enum cases_class class, const struct cases_points *points)
{
    const unsigned mask = (1u << OUTPUTS) - 1;
    struct outputs sampled[CHAIN_INPUTS], o = outputs_make(POINTS);
    struct scarp_samples in[CHAIN_INPUTS];
    char name[80];
    for (int k = 0; k < CHAIN_INPUTS; k++) {
        const struct scarp_noise noise = {.seed = 3 + (uint64_t)k, .phase = 0.3f};
        sampled[k] = outputs_make(POINTS);
        in[k] = outputs_subset(&sampled[k], mask);
        CHECK(scarp_sample3(&noise, POINTS, points->f[0], points->f[1], points->f[2], &in[k]) ==
                  SCARP_OK,
              "input %d", k);
    }
    const struct scarp_partials partials = chain_any_partials(in);
    const struct scarp_samples out = outputs_subset(&o, mask);
    for (int f = 0; f < CHAINS && !check_enough(); f++) {
        snprintf(name, sizeof name, "chain/%s/%s", chain_kinds[f].name, class_names[class]);
        CHECK(chain_call((enum chain)f, POINTS, in, &partials, &out) == SCARP_OK, "%s", name);
        visit(name, outputs_hash(FNV_BASIS, &o, mask, POINTS));
    }
    for (int k = 0; k < CHAIN_INPUTS; k++) {
        outputs_free(&sampled[k]);
    }
    outputs_free(&o);
}

/* Gullies in a noise at the points of a class, by floats, then by doubles. */
static void visit_gullies(enum cases_class class, const struct cases_points *points)
{
    const struct scarp_noise noise = {.seed = 4, .octaves = 2.0f};
    struct outputs base = outputs_make(POINTS), o = outputs_make(POINTS);
    const struct scarp_samples in = outputs_subset(&base, OUTPUTS_ALL2);
    const struct scarp_eroded out = eroded_of(o.array, OUT_ALL);
    char name[80];
    CHECK(scarp_sample2(&noise, POINTS, points->f[0], points->f[1], &in) == SCARP_OK, "a base");
    for (size_t n = 0; n < DESCRIPTIONS && !check_enough(); n++) {
        const struct scarp_gullies *const g = &descriptions[n];
        snprintf(name, sizeof name, "gullies/%d/%s", (int)g->seed, class_names[class]);
        CHECK(scarp_gullies2(g, POINTS, points->f[0], points->f[1], &in, &out) == SCARP_OK, "%s",
              name);
        uint64_t hash = outputs_hash(FNV_BASIS, &o, OUT_ALL, POINTS);
        CHECK(scarp_gullies2_f64(g, POINTS, points->d[0], points->d[1], &in, &out) == SCARP_OK,
              "%s", name);
        hash = outputs_hash(hash, &o, OUT_ALL, POINTS);
        visit(name, hash);
    }
    outputs_free(&base);
    outputs_free(&o);
}

/* All components of vector noise, by floats, then by doubles, in 2D, then in 3D */
static void visit_vectors(enum cases_class class, const struct cases_points *points)
{
    struct outputs o[3];
    char name[80];
    const struct inputs in = cases_inputs(points, 0);
    for (int i = 0; i < 3; i++) {
        o[i] = outputs_make(VECTOR_POINTS);
    }
    for (int n = 0; n < VECTORS && !check_enough(); n++) {
        uint64_t hash = FNV_BASIS;
        snprintf(name, sizeof name, "vector/%d/%s", n, class_names[class]);
        for (int f = 0; f < FUNCTIONS; f++) {
            const enum function function = (enum function)f;
            const unsigned all = outputs_of(&vector_noises[n], function);
            const struct scarp_samples out[3] = {
                outputs_subset(&o[0], all), outputs_subset(&o[1], all), outputs_subset(&o[2], all)};
            CHECK(vector_call(function, &vector_noises[n], VECTOR_POINTS, &in, out) == SCARP_OK,
                  "%s", name);
            for (int i = 0; i < function_dimensions(function); i++) {
                hash = outputs_hash(hash, &o[i], all, VECTOR_POINTS);
            }
        }
        visit(name, hash);
    }
    for (int i = 0; i < 3; i++) {
        outputs_free(&o[i]);
    }
}

static int every = 1; /* one of so many groups is computed */

/* A group of cases that follow each other, those of other dimensions in between. */
struct group {
    char name[80]; /* "" before the first one */
    int number;
    uint64_t hash;
};

static int is_computed(const struct group *group)
{
    return group->number % every == 0;
}

static void end_group(const struct group *group)
{
    if (group->name[0] != '\0' && is_computed(group)) {
        visit(group->name, group->hash);
    }
}

/* Ends the group if the next case is of another one. */
static void go_on(struct group *group, const struct cases_call *next)
{
    if (strcmp(group->name, next->group) != 0) {
        end_group(group);
        snprintf(group->name, sizeof group->name, "%s", next->group);
        group->number++;
        group->hash = FNV_BASIS;
    }
}

static void visit_cases(enum cases_class class, const struct cases_points *points,
                        const struct outputs *o)
{
    struct group groups[2] = {{.name = ""}, {.name = ""}}; /* 2D, 3D */
    struct cases_call call;
    for (int n = 0; !check_enough() && cases_next(&call, class, &n);) {
        struct group *const group = &groups[function_dimensions(call.function) - 2];
        go_on(group, &call);
        if (is_computed(group)) {
            cases_run(&call, points, 0, POINTS, o);
            group->hash = outputs_hash(group->hash, o, call.wanted, POINTS);
        }
    }
    for (int i = 0; i < 2 && !check_enough(); i++) {
        end_group(&groups[i]);
    }
}

static void visit_class(enum cases_class class)
{
    struct cases_points points = cases_make(class, POINTS);
    struct outputs o = outputs_make(POINTS);
    char name[80];
    visit_cases(class, &points, &o);
    snprintf(name, sizeof name, "normals/%s", class_names[class]);
    CHECK(scarp_normals(POINTS, points.f[0], points.f[1], 1.75f, o.array[0], o.array[1],
                        o.array[2]) == SCARP_OK,
          "%s", name);
    visit(name, outputs_hash(FNV_BASIS, &o, 7, POINTS));
    visit_chain(class, &points);
    visit_gullies(class, &points);
    visit_vectors(class, &points);
    outputs_free(&o);
    cases_free(&points);
}

static void visit_all(void)
{
    for (int class = 0; class < CASES_CLASSES && !check_enough(); class ++) {
        visit_class((enum cases_class) class);
    }
    for (size_t i = 0; i < line_count && every == 1 && renewed == NULL && !check_enough(); i++) {
        CHECK(lines[i].used, "%s has no group, or more than one line", lines[i].name);
    }
}

/* What the file says of 0.2 has to be all that it said. */
static void check_frozen(void)
{
    uint64_t hash = FNV_BASIS;
    int count = 0;
    for (size_t i = 0; i < line_count; i++) {
        if (lines[i].mark[0] == '\0') {
            hash = (hash ^ fnv_text(lines[i].name) ^ lines[i].hash) * UINT64_C(0x100000001b3);
            count++;
        }
    }
    CHECK(count == FROZEN_LINES && hash == FROZEN_HASH,
          "%d lines of 0.2 with the hash %#llx, released: %d, %#llx", count,
          (unsigned long long)hash, FROZEN_LINES, FROZEN_HASH);
}

/* The file is there as it was until all of the new one is. */
static int renew(const char *path)
{
    char unfinished[4096];
    snprintf(unfinished, sizeof unfinished, "%s.new", path);
    read_lines(path);
    renewed = fopen(unfinished, "w");
    if (renewed == NULL) {
        printf("cannot write %s\n", unfinished);
        return EXIT_FAILURE;
    }
    scarp_isa_select(SCARP_ISA_SCALAR);
    visit_all();
    return fclose(renewed) == 0 && check_failures == 0 && rename(unfinished, path) == 0
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "--frozen") == 0) {
        read_lines(argv[2]);
        check_frozen();
        return check_done();
    }
    if (argc == 3 && strcmp(argv[1], "--renew") == 0) {
        return renew(argv[2]);
    }
    argc = check_take_aim(argc, &argv);
    every = argc == 4 ? atoi(argv[3]) : 1;
    if (argc < 3 || argc > 4 || every < 1) {
        printf("usage: test_golden [--must-differ] FILE ISA [EVERY] | --frozen FILE | "
               "--renew FILE\n");
        return EXIT_FAILURE;
    }
    check_select_isa(argv[2]);
    read_lines(argv[1]);
    visit_all();
    free(lines);
    return check_done();
}
