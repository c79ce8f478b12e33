/* SPDX-License-Identifier: MIT
 *
 * Every kernel gives the bits of the scalar reference, on random and worst-case points.
 *
 *     test_bits ISA [POINTS [STEP]]    the ISA must equal scalar; each STEP-th short run is made
 *     test_bits --must-differ ISA ...  the ISA must differ: for mutants
 */
#include "cases.h"

/* Long runs compare whole blocks, short ones every tail: their lengths go up to four of the widest
   blocks and one point. */
#define SHORT_RUN 65

static struct outputs reference, tested;
static size_t step = 1; /* between the lengths of short runs */

static void compare(const struct cases_call *call, size_t first, size_t count)
{
    for (int m = 0; m < OUTPUTS; m++) {
        if ((call->wanted >> m & 1) != 0) {
            const float *const expected = reference.array[m] + first;
            const size_t i = first_difference(expected, tested.array[m], count);
            CHECK_BITS(i == count,
                       "%s, %zu points from %zu on: %s[%zu] is %a (%08x), scalar gives %a (%08x)",
                       call->name, count, first, output_names[m], i, (double)tested.array[m][i],
                       float_bits(&tested.array[m][i]), (double)expected[i],
                       float_bits(&expected[i]));
        }
    }
}

/* How many of the points are compared: of bases whose reference is slow not all, and fewer of the
   short runs, which go through the same code. */
struct extent {
    size_t count, step;
};

static struct extent extent_of(const struct cases_call *call, size_t count)
{
    const size_t slowness = call->noise.warp != NULL                   ? 8
                            : fractal_bends(call->noise.fractal)       ? 4
                            : blends_corners(call->noise.basis)        ? 1
                            : call->noise.basis == SCARP_SIMPLEX       ? 4
                            : function_dimensions(call->function) == 2 ? 8
                                                                       : 16;
    const size_t least = 2 * SHORT_RUN + 1;
    const struct extent extent = {count / slowness > least ? count / slowness : least,
                                  slowness == 1 ? step : 3 * step};
    return extent;
}

/* Compares the same points, all at once and a few, of calls that keep a plan, and then short runs
   that begin anywhere, of which every other one keeps a plan. */
static void compare_planned(struct cases_call *call, const struct cases_points *points,
                            struct extent extent)
{
    static struct scarp_plan plan;
    const int dimensions = function_dimensions(call->function);
    CHECK(scarp_plan_make(&call->noise, dimensions, &plan) == SCARP_OK, "%s: no plan", call->name);
    call->noise.plan = &plan;
    for (size_t length = extent.count; length > 0; length /= 20) {
        outputs_poison(&tested);
        cases_run(call, points, 0, length, &tested);
        compare(call, 0, length);
    }
    tested.capacity = SHORT_RUN;
    for (size_t length = 1; length <= SHORT_RUN; length += extent.step) {
        const size_t first = (length * 37) % (extent.count - length);
        call->noise.plan = length % 2 == 1 ? &plan : NULL;
        outputs_poison(&tested);
        cases_run(call, points, first, length, &tested);
        compare(call, first, length);
    }
    tested.capacity = points->count;
    call->noise.plan = NULL;
}

/* Compares all settings on one class of points. */
static void compare_class(enum scarp_isa isa, enum cases_class class, size_t count)
{
    struct cases_points points = cases_make(class, count);
    struct cases_call call;
    for (int n = 0; !check_enough() && cases_next(&call, class, &n);) {
        const struct extent extent = extent_of(&call, count);
        scarp_isa_select(SCARP_ISA_SCALAR);
        cases_run(&call, &points, 0, extent.count, &reference);
        scarp_isa_select(isa);
        outputs_poison(&tested);
        cases_run(&call, &points, 0, extent.count, &tested);
        compare(&call, 0, extent.count);
        compare_planned(&call, &points, extent);
    }
    cases_free(&points);
}

int main(int argc, char **argv)
{
    argc = check_take_aim(argc, &argv);
    if (argc < 2) {
        printf("usage: test_bits [--must-differ] ISA [POINTS [STEP]]\n");
        return EXIT_FAILURE;
    }
    const enum scarp_isa isa = check_select_isa(argv[1]);
    const size_t count = argc > 2 ? (size_t)strtoul(argv[2], NULL, 10) : 4099;
    step = argc > 3 ? (size_t)strtoul(argv[3], NULL, 10) : 1;
    if (count <= 2 * SHORT_RUN || step == 0) {
        printf("POINTS must be above %d, STEP above 0\n", 2 * SHORT_RUN);
        return EXIT_FAILURE;
    }
    reference = outputs_make(count);
    tested = outputs_make(count);
    for (int class = 0; class < CASES_CLASSES; class ++) {
        compare_class(isa, (enum cases_class) class, count);
    }
    outputs_free(&reference);
    outputs_free(&tested);
    return check_done();
}
