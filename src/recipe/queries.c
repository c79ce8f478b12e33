/* SPDX-License-Identifier: MIT
 *
 * What nodes read, and what places, outputs and noises of the graph are.
 */
#include "graph.h"

#include <string.h>

_Static_assert(offsetof(struct scarp_noise, warp) == 80 || sizeof(void *) != 8,
               "struct recipe_noise has all of a noise but its pointers");

int scarpi_recipe_traits(int operation)
{
#define OPERATOR(NAME, name, FORM, COMPUTED, take, traits, ...) [OP_##NAME] = (traits),
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
    static const uint8_t traits_of[OP_COUNT] = {
        [OP_CONSTANT] = CAN_BE_LEVEL,
        [OP_GULLIES] = NEEDS_SLOPES | IS_C1,
#include "../plan/functions.def"
    };
    return traits_of[operation];
}

int scarpi_recipe_frame_dimensions(const struct recipe *recipe, int frame)
{
    return frame < 0 ? recipe->dimensions : recipe->place[frame].dimensions;
}

int scarpi_recipe_output_node(const struct recipe *recipe, int output)
{
    return recipe->expression[recipe->statement[recipe->output[output]].expression].node;
}

int scarpi_recipe_is_frame(const struct recipe *recipe, int place)
{
    const struct recipe_place *const p = &recipe->place[place];
    int same = p->dimensions == scarpi_recipe_frame_dimensions(recipe, p->frame);
    for (int i = 0; i < p->dimensions; i++) {
        same = same && p->rest[i] < 0;
        for (int j = 0; j < 3; j++) {
            same = same && p->m[i][j] == (i == j ? 1.0 : 0.0);
        }
    }
    return same;
}

void scarpi_recipe_matrix(const struct recipe *recipe, int place, double matrix[3][3])
{
    const struct recipe_place *const p = &recipe->place[place];
    memcpy(matrix, p->m, sizeof p->m);
    if (p->frame < 0) {
        return;
    }
    double outer[3][3];
    scarpi_recipe_matrix(recipe, p->frame, outer);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            matrix[i][j] =
                p->m[i][0] * outer[0][j] + p->m[i][1] * outer[1][j] + p->m[i][2] * outer[2][j];
        }
    }
}

/* Adds the rests of a place: those that derivatives depend on, or the others. */
static int add_rests(const struct recipe *recipe, const struct recipe_node *n, int slopes,
                     int16_t *reads)
{
    const struct recipe_place *const p = &recipe->place[n->place];
    int count = 0;
    for (int i = 0; i < p->dimensions; i++) {
        if (p->rest[i] >= 0 && has_slopes_of(n, i) == slopes) {
            reads[count++] = p->rest[i];
        }
    }
    return count;
}

int scarpi_recipe_reads(const struct recipe *recipe, int node, int16_t reads[RECIPE_READS],
                        int *slopes)
{
    const struct recipe_node *const n = &recipe->node[node];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        if (n->in[i] >= 0) {
            reads[count++] = n->in[i];
        }
    }
    if (n->place < 0) {
        *slopes = count;
        return count;
    }
    count += add_rests(recipe, n, 1, reads + count);
    *slopes = count;
    count += add_rests(recipe, n, 0, reads + count);
    if (n->operation == OP_PULL) { /* positions are no matter, only the Jacobian */
        return count;
    }
    for (int p = recipe->place[n->place].frame; p >= 0; p = recipe->place[p].frame) {
        for (int i = 0; i < recipe->place[p].dimensions; i++) {
            if (recipe->place[p].rest[i] >= 0) {
                reads[count++] = recipe->place[p].rest[i];
            }
        }
    }
    return count;
}

void scarpi_recipe_spell_noise(const struct recipe *recipe, int index, struct scarp_noise noise[5])
{
    /* Without an offset all seeds have the same places at the origin. */
    static const struct scarp_noise others = {.offset_first = 1};
    enum { MEMBERS = sizeof recipe->noise[0].noise };
    for (int i = 0; index >= 0 && i < 5; i++, index = recipe->noise[index].warp) {
        memcpy(&noise[i], recipe->noise[index].noise, MEMBERS);
        memcpy((char *)&noise[i] + MEMBERS, (const char *)&others + MEMBERS,
               sizeof noise[i] - MEMBERS);
        noise[i].warp = recipe->noise[index].warp >= 0 ? &noise[i + 1] : NULL;
    }
}
