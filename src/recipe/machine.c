/* SPDX-License-Identifier: MIT
 *
 * Where the samples of nodes are: in registers, or in the caller's arrays.
 */
#include "machine.h"

static struct scarp_samples shifted(const struct scarp_samples *samples, size_t by)
{
    struct scarp_samples s = {0};
    for (int i = 0; i < RECIPE_MEMBERS; i++) {
        float *array = recipe_member(samples, i);
        array = array == NULL ? NULL : array + by;
        memcpy((char *)&s + (size_t)i * sizeof array, &array, sizeof array);
    }
    return s;
}

struct scarp_samples scarpi_recipe_samples(const struct recipe_machine *m, int node)
{
    for (int i = 0; m->directs >> i != 0; i++) {
        if ((m->directs >> i & 1) != 0 && m->root[i] == node) {
            return shifted(&m->out[i], m->direct_from);
        }
    }
    const int order = m->order_of[node], is_space = m->recipe->node[node].dimensions == 3;
    float *const at = m->registers + (size_t)m->schedule->register_of[node] * m->floats * m->room;
    struct scarp_samples s = {.value = at};
    float *next = at;
    if (order >= 1) {
        s.dx = next += m->room;
        s.dy = next += m->room;
        s.dz = is_space ? next += m->room : NULL;
    }
    if (order >= 2) {
        s.dxx = next += m->room;
        s.dxy = next += m->room;
        s.dxz = is_space ? next += m->room : NULL;
        s.dyy = next += m->room;
        s.dyz = is_space ? next += m->room : NULL;
        s.dzz = is_space ? next + m->room : NULL;
    }
    return s;
}
