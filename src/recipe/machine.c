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

void scarpi_recipe_find_output(const struct scarp_samples *out, size_t from,
                               struct scarp_samples *to)
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

/* The register of a node: of steps of other axes, its copy for them. */
static int register_of(const struct recipe_machine *m, int node)
{
    const struct recipe_schedule *const s = m->schedule;
    for (int i = 0; m->has_parts && s->axes_of[node] != m->axes && i < s->copies; i++) {
        if (s->copy[i].node == node && s->copy[i].axes == m->axes) {
            return s->copy[i].in_register;
        }
    }
    return s->register_of[node];
}

void scarpi_recipe_find_samples(const struct recipe_machine *m, int node, struct scarp_samples *to)
{
    const int home = m->schedule->home_of[node];
    if (home > 0 && (m->directs >> (home - 1) & 1) != 0) {
        scarpi_recipe_find_output(&m->out[home - 1], m->direct_from, to);
    } else {
        scarpi_recipe_find_in_register(m, node, register_of(m, node), to);
    }
}

void scarpi_recipe_find_in_register(const struct recipe_machine *m, int node, int k,
                                    struct scarp_samples *to)
{
    const int order = m->order_of[node], is_space = m->recipe->node[node].dimensions == 3;
    float *const at = m->registers + (size_t)k * m->floats * m->room;
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
