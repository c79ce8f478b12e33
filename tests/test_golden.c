/* SPDX-License-Identifier: MIT
 *
 * The same bits everywhere: hashes of outputs against those committed in golden.txt, which were
 * computed once. Comparing with the scalar kernels of the same build is not enough: a compiler may
 * have changed both alike.
 *
 *     test_golden FILE ISA    every hash must equal the one in FILE
 *     test_golden --print     writes such a file; only when results are meant to change
 */
#include "cases.h"

#define POINTS 1031 /* two whole chunks with every instruction set, and a tail */

/* Member, then its class of points: FNV-1a over the bits, low byte first, all NaNs alike. */
static uint64_t hash_array(uint64_t hash, const float *array, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint32_t bits = cases_float_bits(array[i]);
        for (int shift = 0; shift < 32; shift += 8) {
            hash = (hash ^ (bits >> shift & 0xff)) * UINT64_C(0x100000001b3);
        }
    }
    return hash;
}

static uint64_t hash_call(const struct cases_call *call, const struct cases_points *points)
{
    static float storage[CASES_OUTPUTS][POINTS];
    float *arrays[CASES_OUTPUTS];
    for (int m = 0; m < CASES_OUTPUTS; m++) {
        arrays[m] = storage[m];
    }
    memset(storage, 0, sizeof storage);
    const struct scarp_samples out = cases_outputs(call, arrays);
    if (cases_run(call, points, 0, POINTS, &out) != SCARP_OK) {
        printf("a call failed\n");
        exit(EXIT_FAILURE);
    }
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (int m = 0; m < CASES_OUTPUTS; m++) {
        hash = hash_array(hash, storage[m], POINTS);
    }
    return hash;
}

static uint64_t hash_normals(const struct cases_points *points)
{
    static float n[3][POINTS];
    if (scarp_normals(POINTS, points->f[0], points->f[1], 1.75f, n[0], n[1], n[2]) != SCARP_OK) {
        printf("a call failed\n");
        exit(EXIT_FAILURE);
    }
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (int i = 0; i < 3; i++) {
        hash = hash_array(hash, n[i], POINTS);
    }
    return hash;
}

/* One line of the file: class, call (CASES_CALLS stands for the normals), hash. */
static void visit(FILE *golden, int class, int call, uint64_t hash)
{
    if (golden == NULL) {
        printf("%d %d %016llx\n", class, call, (unsigned long long)hash);
        return;
    }
    int golden_class, golden_call;
    unsigned long long golden_hash;
    if (fscanf(golden, "%d %d %llx", &golden_class, &golden_call, &golden_hash) != 3) {
        printf("the file of golden values ends early\n");
        exit(EXIT_FAILURE);
    }
    CHECK(golden_class == class && golden_call == call && golden_hash == hash,
          "class %d call %d: %016llx, golden: class %d call %d %016llx", class, call,
          (unsigned long long)hash, golden_class, golden_call, golden_hash);
}

static void visit_all(FILE *golden)
{
    for (int class = 0; class < CASES_CLASSES; class ++) {
        struct cases_points points = cases_make((enum cases_class) class, POINTS);
        for (int index = 0; index < CASES_CALLS; index++) {
            const struct cases_call call = cases_call(index);
            visit(golden, class, index, hash_call(&call, &points));
        }
        visit(golden, class, CASES_CALLS, hash_normals(&points));
        cases_free(&points);
    }
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--print") == 0) {
        scarp_isa_select(SCARP_ISA_SCALAR);
        visit_all(NULL);
        return EXIT_SUCCESS;
    }
    FILE *const golden = argc == 3 ? fopen(argv[1], "r") : NULL;
    if (golden == NULL) {
        printf("usage: test_golden FILE ISA | --print (FILE must be readable)\n");
        return EXIT_FAILURE;
    }
    check_select_isa(argv[2]);
    visit_all(golden);
    fclose(golden);
    return check_done();
}
