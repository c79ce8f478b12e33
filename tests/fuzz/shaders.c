/* SPDX-License-Identifier: MIT
 *
 * The constants of a noise for shaders, and the answers of their self-test.
 */
#include "../outputs.h"

#include "arguments.h"

#define ANSWERS_OFTEN 8 /* one of so many inputs asks for answers, which take 4,096 points */
#define ANSWERS_OCTAVES 6

typedef enum scarp_status make_plan(const struct scarp_noise *noise, int dimensions,
                                    struct scarp_gpu_plan *plan, const char **member);

static make_plan *const make_plans[2] = {scarp_gpu_plan_make, scarp_gpu_vector_plan_make};

static int octaves_of(const struct scarp_noise *noise)
{
    return noise->octaves == 0.0f ? 1 : (int)ceilf(noise->octaves);
}

/* The octaves that a plan needs, as the header says */
static int octaves_needed(const struct scarp_noise *noise, int dimensions, int is_vector)
{
    int needed = 0;
    for (; noise != NULL; noise = noise->warp) {
        needed += octaves_of(noise) * (is_vector && !blends_corners(noise->basis) ? dimensions : 1);
        is_vector = 1;
    }
    return needed;
}

/* Members that no noise fills in */
static void check_unused(const struct scarp_gpu_plan *plan)
{
    fuzz_must(plan->zero == 0 && plan->unit > 0.0f);
    for (int i = 0; i < 5; i++) {
        fuzz_must(plan->level[i].spare0 == 0 && plan->level[i].spare1 == 0.0f);
        fuzz_must((uint32_t)i <= plan->depth || plan->level[i].octaves == 0);
    }
    for (int k = 0; k < 32; k++) {
        fuzz_must(plan->octave[k].gradient[2][3] == 0.0f);
    }
}

static void note_plan(const struct scarp_gpu_plan *plan)
{
    uint32_t word;
    for (size_t i = 0; i < sizeof *plan / sizeof word; i++) {
        memcpy(&word, (const char *)plan + i * sizeof word, sizeof word);
        fuzz_note(word);
    }
}

static enum scarp_status check_plan(const struct scarp_noise *noise, int dimensions, int is_vector)
{
    static struct scarp_gpu_plan plan, again;
    const char *member = "", *of_fault = "";
    memset(&plan, POISON, sizeof plan);
    memset(&again, 0, sizeof again);
    const enum scarp_status status = make_plans[is_vector](noise, dimensions, &plan, &member);
    const char *const fault = scarp_gpu_plan_fault(noise, dimensions, is_vector, &of_fault);
    fuzz_note((uint64_t)status);
    fuzz_must((status == SCARP_OK) == (fault == NULL));
    fuzz_must(member == NULL || status != SCARP_OK);
    fuzz_must(member != NULL || status == SCARP_OK || (dimensions != 2 && dimensions != 3));
    fuzz_must(member == of_fault || strcmp(member, of_fault) == 0);
    fuzz_must(make_plans[is_vector](noise, dimensions, &again, NULL) == status);
    if (status != SCARP_OK) {
        fuzz_must(all_poison(&plan, sizeof plan));
    } else {
        fuzz_must(memcmp(&plan, &again, sizeof plan) == 0);
        check_unused(&plan);
        note_plan(&plan);
    }
    const enum scarp_status expected = scarp_noise_check(noise, dimensions, NULL);
    const int is_long = expected == SCARP_OK && octaves_needed(noise, dimensions, is_vector) > 32;
    fuzz_must(status == (is_long ? SCARP_ERROR_UNSUPPORTED : expected));
    return status;
}

/* All sets answer alike, and on an error nothing. */
static void check_answers(const struct scarp_noise *noise, int dimensions, int order,
                          enum scarp_status of_plan)
{
    static uint32_t reference[SCARP_GPU_ANSWERS], answer[SCARP_GPU_ANSWERS];
    const int is_served = of_plan == SCARP_OK && order >= 0 && order <= noise_order(noise);
    memset(reference, POISON, sizeof reference);
    fuzz_must(scarp_isa_select(SCARP_ISA_SCALAR) == SCARP_OK);
    const enum scarp_status status = scarp_gpu_answers(noise, dimensions, order, reference);
    fuzz_must((status == SCARP_OK) == is_served);
    fuzz_must(status == SCARP_OK || all_poison(reference, sizeof reference));
    for (enum scarp_isa isa = SCARP_ISA_SCALAR; scarp_isa_name(isa) != NULL; isa++) {
        if (scarp_isa_supported(isa)) {
            memset(answer, POISON, sizeof answer);
            fuzz_must(scarp_isa_select(isa) == SCARP_OK);
            fuzz_must(scarp_gpu_answers(noise, dimensions, order, answer) == status);
            fuzz_must(memcmp(answer, reference, sizeof answer) == 0);
        }
    }
    for (int i = 0; i < SCARP_GPU_ANSWERS && status == SCARP_OK; i++) {
        fuzz_note(reference[i]);
    }
    fuzz_must(scarp_isa_select(SCARP_ISA_NONE) == SCARP_OK);
}

void fuzz_shaders(const uint8_t *bytes, size_t size)
{
    static struct fuzz_noise noise;
    struct draw d = {bytes, size};
    const int dimensions = draw_rarely(&d, 16) ? (int)draw_byte(&d) : 2 + (int)draw_below(&d, 2);
    int order = (int)draw_below(&d, 4);
    order -= draw_rarely(&d, 16);
    const int asks = draw_rarely(&d, ANSWERS_OFTEN);
    fuzz_draw_noise(&d, dimensions, &noise);
    const struct scarp_noise *const top = &noise.level[0];
    const enum scarp_status status = check_plan(top, dimensions, 0);
    fuzz_calls++;
    fuzz_served += status == SCARP_OK;
    check_plan(top, dimensions, 1);
    if (asks && (status != SCARP_OK || octaves_needed(top, dimensions, 0) <= ANSWERS_OCTAVES)) {
        check_answers(top, dimensions, order, status);
    }
}
