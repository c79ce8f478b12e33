/* SPDX-License-Identifier: MIT
 *
 * The public functions that make a shader of a recipe.
 */
#include "shader.h"

#include <string.h>

#include "../calls/run.h"
#include "../calls/shaders.h"
#include "../dispatch/fpmode.h"
#include "../formulas/answers.h"
#include "evaluate.h"
#include "graph.h"

static enum scarp_status find_recipe(const struct scarp_recipe *recipe, const struct recipe **r)
{
    if (recipe == NULL) {
        return SCARP_ERROR_NULL;
    }
    *r = scarpi_recipe_of(recipe);
    return (*r)->version == RECIPE_VERSION && !(*r)->is_bad ? SCARP_OK : SCARP_ERROR_PARAMETER;
}

/* Which derivatives each node has, so that outputs have theirs up to an order. */
static void set_orders(struct shader_writer *w, int order)
{
    const struct recipe *const r = w->recipe;
    for (int i = 0; i < r->outputs; i++) {
        const int node = scarpi_recipe_output_node(r, i), has = r->node[node].order;
        w->order_of[node] = (uint8_t)(order < has ? order : has);
    }
    scarpi_recipe_raise_orders(r, &r->schedule, w->order_of);
}

static NOINLINE enum scarp_status write(const struct recipe *r, const struct scarp_shader *how,
                                        struct shader_text *text)
{
    const struct shader_uniforms none = {NULL, NULL, NULL};
    struct shader_slots slots;
    struct shader_writer w = {.recipe = r, .slots = &slots, .to = text};
    const enum scarp_status status = scarpi_shader_lay_out(r, &none, &slots);
    if (status != SCARP_OK) {
        return status;
    }
    set_orders(&w, how->order);
    scarpi_shader_put_head(&w);
    const struct shader_cut cut = {how->file, how->length, text->length};
    scarpi_shader_put_functions(&w, how->order);
    return scarpi_shader_cut(&cut, text) ? SCARP_OK : SCARP_ERROR_PARAMETER;
}

enum scarp_status scarp_recipe_shader(const struct scarp_recipe *recipe,
                                      const struct scarp_shader *how, char *text, size_t capacity,
                                      size_t *length)
{
    const struct recipe *r = NULL;
    enum scarp_status status = find_recipe(recipe, &r);
    if (how == NULL || how->file == NULL || (text == NULL && capacity > 0) || length == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (status != SCARP_OK) {
        return status;
    }
    if (how->language < SCARP_GLSL || how->language > SCARP_WGSL) {
        return SCARP_ERROR_ENUM;
    }
    if (how->order < 0 || how->order > 2) {
        return SCARP_ERROR_PARAMETER;
    }
    for (size_t i = 0; i < sizeof how->spare / sizeof how->spare[0]; i++) {
        if (how->spare[i] != 0) {
            return SCARP_ERROR_UNSUPPORTED;
        }
    }
    struct shader_text to = {text, capacity > 0 ? capacity - 1 : 0, 0, how->language};
    const struct fpmode caller = fpmode_enter();
    status = write(r, how, &to);
    fpmode_leave(caller);
    if (status == SCARP_OK) {
        *length = to.length;
        status = to.length > to.capacity || capacity == 0 ? SCARP_ERROR_SIZE : SCARP_OK;
    }
    if (status == SCARP_OK) {
        text[to.length] = '\0';
    }
    return status;
}

#define HEAD_BYTES 16

/* Slots are counted first, by all the calls that fill them in, too: one that fails does so before
   anything is written. */
static NOINLINE enum scarp_status fill(const struct recipe *r, void *bytes, size_t capacity,
                                       size_t *size)
{
    const struct shader_uniforms none = {NULL, NULL, NULL};
    struct shader_slots slots;
    const enum scarp_status status = scarpi_shader_lay_out(r, &none, &slots);
    if (status != SCARP_OK) {
        return status;
    }
    const size_t numbers = (size_t)slots.numbers * 16, levels = (size_t)slots.levels * 48;
    *size = HEAD_BYTES + numbers + levels + (size_t)slots.octaves * 160;
    if (*size > capacity) {
        return SCARP_ERROR_SIZE;
    }
    char *const at = bytes;
    const struct shader_uniforms to = {
        (float(*)[4])(void *)(at + HEAD_BYTES),
        (struct scarp_gpu_level *)(void *)(at + HEAD_BYTES + numbers),
        (struct scarp_gpu_octave *)(void *)(at + HEAD_BYTES + numbers + levels)};
    memset(bytes, 0, *size);
    memcpy(at + 4, &slots.unit, sizeof slots.unit);
    return scarpi_shader_lay_out(r, &to, &slots);
}

enum scarp_status scarp_recipe_uniforms(const struct scarp_recipe *recipe, void *bytes,
                                        size_t capacity, size_t *size)
{
    const struct recipe *r = NULL;
    enum scarp_status status = find_recipe(recipe, &r);
    if ((bytes == NULL && capacity > 0) || size == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (status != SCARP_OK) {
        return status;
    }
    const struct fpmode caller = fpmode_enter();
    status = fill(r, bytes, capacity, size);
    fpmode_leave(caller);
    return status;
}

/*
 * The self-test
 */

#define CHUNK 16 /* points of a call, without scratch memory */
#define MEMBERS 10

struct answering {
    const struct scarp_recipe *recipe;
    int order;
    float unit;
};

static void set_point(const struct answering *a, uint32_t first, float position[3][CHUNK])
{
    for (uint32_t i = 0; i < CHUNK; i++) {
        for (uint32_t axis = 0; axis < 3; axis++) {
            position[axis][i] = test_coordinate(a->unit, first + i, axis);
        }
    }
}

/* The members that an output has, up to the order, in the order of struct scarp_samples. */
static void set_members(const struct recipe *r, int output, int order, float array[MEMBERS][CHUNK],
                        struct scarp_samples *to)
{
    static const unsigned char of[MEMBERS] = {0, 1, 1, 1, 2, 2, 2, 2, 2, 2};
    static const unsigned along_z = 1u << 3 | 1u << 6 | 1u << 8 | 1u << 9;
    const int has = r->node[scarpi_recipe_output_node(r, output)].order;
    memset(to, 0, sizeof *to);
    for (int i = 0; i < MEMBERS; i++) {
        const int is_there =
            of[i] <= order && of[i] <= has && (r->dimensions == 3 || (along_z >> i & 1) == 0);
        float *const member = is_there ? array[i] : NULL;
        memcpy((char *)to + (size_t)i * sizeof member, &member, sizeof member);
    }
}

/* Output by output, so that the stack need not hold all of them. */
static NOINLINE enum scarp_status answer_chunk(const struct answering *a, uint32_t first,
                                               uint32_t *answer)
{
    const struct recipe *const r = scarpi_recipe_of(a->recipe);
    float position[3][CHUNK], array[MEMBERS][CHUNK];
    set_point(a, first, position);
    memset(answer, 0, CHUNK * sizeof *answer);
    for (int output = 0; output < r->outputs; output++) {
        struct scarp_samples samples;
        const int32_t which = r->output[output];
        const struct scarp_recipe_outputs outputs = {.out = &samples, .which = &which, .count = 1};
        set_members(r, output, a->order, array, &samples);
        const enum scarp_status status = scarp_recipe_sample(
            a->recipe, CHUNK, position[0], position[1], position[2], &outputs, NULL);
        if (status != SCARP_OK) {
            return status;
        }
        for (int k = 0; k < MEMBERS; k++) {
            float *member;
            memcpy(&member, (const char *)&samples + (size_t)k * sizeof member, sizeof member);
            for (int i = 0; member != NULL && i < CHUNK; i++) {
                answer[i] = hash_with(answer[i], member[i]);
            }
        }
    }
    return SCARP_OK;
}

static NOINLINE enum scarp_status find_unit(const struct recipe *r, float *unit)
{
    const struct shader_uniforms none = {NULL, NULL, NULL};
    struct shader_slots slots;
    const enum scarp_status status = scarpi_shader_lay_out(r, &none, &slots);
    *unit = slots.unit;
    return status;
}

/* What a chunk needs may be left out of others, so all are computed twice: the first time, nothing
   is written, and a call that fails is noticed. */
static enum scarp_status answer_all(const struct answering *a, uint32_t *answer)
{
    uint32_t tried[CHUNK];
    enum scarp_status status = SCARP_OK;
    for (int is_last = 0; is_last < 2; is_last++) {
        for (uint32_t i = 0; status == SCARP_OK && i < SCARP_GPU_ANSWERS; i += CHUNK) {
            status = answer_chunk(a, i, is_last ? answer + i : tried);
        }
    }
    return status;
}

enum scarp_status scarp_recipe_answers(const struct scarp_recipe *recipe, int order,
                                       uint32_t *answer)
{
    const struct recipe *r = NULL;
    enum scarp_status status = find_recipe(recipe, &r);
    if (answer == NULL) {
        return SCARP_ERROR_NULL;
    }
    if (status == SCARP_OK && (order < 0 || order > 2)) {
        status = SCARP_ERROR_PARAMETER;
    }
    if (status != SCARP_OK) {
        return status;
    }
    struct answering answering = {.recipe = recipe, .order = order};
    const struct fpmode caller = fpmode_enter();
    status = find_unit(r, &answering.unit);
    fpmode_leave(caller);
    return status == SCARP_OK ? answer_all(&answering, answer) : status;
}
