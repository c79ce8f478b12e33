/* SPDX-License-Identifier: MIT
 *
 * Where the samples of nodes are: in registers, or in the caller's arrays.
 */
#include "machine.h"

/* The reserved members, too. One by one: of a whole that is set to 0, gcc makes "rep stos", which
   takes longer than all else here. */
static void clear(struct scarp_samples *s)
{
    s->value = s->dx = s->dy = s->dz = NULL;
    s->dxx = s->dxy = s->dxz = s->dyy = s->dyz = s->dzz = s->dphase = NULL;
    s->spare[0] = s->spare[1] = s->spare[2] = s->spare[3] = s->spare[4] = NULL;
}

/* The samples of an output, in its arrays from an element on. */
static void find_output(const struct scarp_samples *out, size_t from, struct scarp_samples *to)
{
    clear(to);
    for (int i = 0; i < RECIPE_MEMBERS; i++) {
        float *array = recipe_member(out, i);
        if (array != NULL) {
            array += from;
            memcpy((char *)to + (size_t)i * sizeof array, &array, sizeof array);
        }
    }
}

void scarpi_recipe_find_samples(const struct recipe_machine *m, int node, struct scarp_samples *to)
{
    for (int i = 0; m->directs >> i != 0; i++) {
        if ((m->directs >> i & 1) != 0 && m->root[i] == node) {
            find_output(&m->out[i], m->direct_from, to);
            return;
        }
    }
    const int order = m->order_of[node], is_space = m->recipe->node[node].dimensions == 3;
    float *const at = m->registers + (size_t)m->schedule->register_of[node] * m->floats * m->room;
    float *next = at;
    clear(to);
    to->value = at;
    if (order >= 1) {
        to->dx = next += m->room;
        to->dy = next += m->room;
        to->dz = is_space ? next += m->room : NULL;
    }
    if (order >= 2) {
        to->dxx = next += m->room;
        to->dxy = next += m->room;
        to->dxz = is_space ? next += m->room : NULL;
        to->dyy = next += m->room;
        to->dyz = is_space ? next += m->room : NULL;
        to->dzz = is_space ? next + m->room : NULL;
    }
}
