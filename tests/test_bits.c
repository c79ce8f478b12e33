/* SPDX-License-Identifier: MIT
 *
 * Every kernel against the scalar reference, bit for bit, on random and worst-case points.
 *
 *     test_bits ISA [POINTS]               the ISA must equal scalar
 *     test_bits --must-differ ISA [POINTS] the ISA must not: for builds with a deliberate mistake
 */
#include "cases.h"

/* Long runs compare whole blocks, short ones every tail: all lengths to 4 blocks of 16 and one. */
#define SHORT_RUN 65

struct arrays {
    float *reference[CASES_OUTPUTS], *tested[CASES_OUTPUTS];
};

static long compared, differing;

static void make_arrays(struct arrays *arrays, size_t count)
{
    for (int m = 0; m < CASES_OUTPUTS; m++) {
        arrays->reference[m] = malloc(count * sizeof(float));
        arrays->tested[m] = malloc(count * sizeof(float));
        if (arrays->reference[m] == NULL || arrays->tested[m] == NULL) {
            printf("out of memory\n");
            exit(EXIT_FAILURE);
        }
    }
}

static void sample_with(enum scarp_isa isa, const struct cases_call *call,
                        const struct cases_points *points, size_t first, size_t count,
                        float *const *arrays)
{
    const struct scarp_samples out = cases_outputs(call, arrays);
    if (scarp_isa_select(isa) != SCARP_OK ||
        cases_run(call, points, first, count, &out) != SCARP_OK) {
        printf("a call failed\n");
        exit(EXIT_FAILURE);
    }
}

static void report(const struct cases_call *call, int member, size_t i, float reference,
                   float tested)
{
    if (differing < CHECK_SHOWN) {
        printf("%dD basis %d fade %d order %d %s octaves %g: output %d of point %zu is %a (%08x), "
               "scalar gives %a (%08x)\n",
               call->dimensions, call->noise.basis, call->noise.fade, call->order,
               call->doubles ? "double" : "float", (double)call->noise.octaves, member, i,
               (double)tested, cases_float_bits(tested), (double)reference,
               cases_float_bits(reference));
    }
}

static void compare(const struct cases_call *call, const struct arrays *arrays, size_t first,
                    size_t count)
{
    const struct scarp_samples wanted = cases_outputs(call, arrays->reference);
    const float *const members[CASES_OUTPUTS] = {wanted.value, wanted.dx,  wanted.dy,  wanted.dz,
                                                 wanted.dxx,   wanted.dxy, wanted.dxz, wanted.dyy,
                                                 wanted.dyz,   wanted.dzz};
    for (int m = 0; m < CASES_OUTPUTS; m++) {
        if (members[m] == NULL) {
            continue;
        }
        for (size_t i = 0; i < count; i++) {
            const float reference = arrays->reference[m][first + i];
            const float tested = arrays->tested[m][i];
            compared++;
            if (cases_float_bits(reference) != cases_float_bits(tested)) {
                report(call, m, first + i, reference, tested);
                differing++;
            }
        }
    }
}

/* All settings on one class of points. Once whole, then in every short length at odd places. */
static void compare_class(enum scarp_isa isa, enum cases_class class, size_t count)
{
    struct cases_points points = cases_make(class, count);
    struct arrays arrays;
    make_arrays(&arrays, count);
    for (int index = 0; index < CASES_CALLS; index++) {
        const struct cases_call call = cases_call(index);
        sample_with(SCARP_ISA_SCALAR, &call, &points, 0, count, arrays.reference);
        sample_with(isa, &call, &points, 0, count, arrays.tested);
        compare(&call, &arrays, 0, count);
        for (size_t length = 1; length <= SHORT_RUN; length++) {
            const size_t first = (length * 37) % (count - length);
            for (int m = 0; m < CASES_OUTPUTS; m++) {
                memset(arrays.tested[m], 0x99, length * sizeof(float));
            }
            sample_with(isa, &call, &points, first, length, arrays.tested);
            compare(&call, &arrays, first, length);
        }
    }
    for (int m = 0; m < CASES_OUTPUTS; m++) {
        free(arrays.reference[m]);
        free(arrays.tested[m]);
    }
    cases_free(&points);
}

int main(int argc, char **argv)
{
    const int must_differ = argc > 1 && strcmp(argv[1], "--must-differ") == 0;
    argv += must_differ;
    argc -= must_differ;
    if (argc < 2) {
        printf("usage: test_bits [--must-differ] ISA [POINTS]\n");
        return EXIT_FAILURE;
    }
    const enum scarp_isa isa = check_select_isa(argv[1]);
    const size_t count = argc > 2 ? (size_t)strtoul(argv[2], NULL, 10) : 4099;
    if (count <= 2 * SHORT_RUN) {
        printf("POINTS must be above %d\n", 2 * SHORT_RUN);
        return EXIT_FAILURE;
    }
    for (int class = 0; class < CASES_CLASSES; class ++) {
        compare_class(isa, (enum cases_class) class, count);
    }
    printf("%s: %ld outputs compared with scalar, %ld differ\n", argv[1], compared, differing);
    return compared > 0 && (differing != 0) == must_differ ? EXIT_SUCCESS : EXIT_FAILURE;
}
