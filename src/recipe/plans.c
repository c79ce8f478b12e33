/* SPDX-License-Identifier: MIT */
#include "plans.h"

#include <string.h>

#include "../plan/kept.h"
#include "../plan/plan.h"
#include "graph.h"

/* A noise in the plane or in space, as a noise or as vector noise. */
#define KINDS 4 /* of plans for a noise */
#define SLOTS (RECIPE_NOISES * KINDS)

#define ALIGNMENT _Alignof(struct scarp_plan)

_Static_assert(sizeof(struct kept) % ALIGNMENT == 0 && sizeof(struct scarp_octave) % ALIGNMENT == 0,
               "plans follow each other");

/* "SCRR" and the version: octaves may differ between versions. */
#define MARK                                                                                       \
    (UINT64_C(0x53435252) << 32 | SCARP_VERSION_MAJOR << 24 | SCARP_VERSION_MINOR << 16 |          \
     SCARP_VERSION_PATCH << 8)

static int slot_of(int noise, int dimensions, int is_vector)
{
    return noise * KINDS + (dimensions - 2) * 2 + is_vector;
}

/* Where everything is. */
struct layout {
    size_t bytes;
    uint32_t at[SLOTS];
};

/* The place of a noise with the same constants, or 0. */
static uint32_t same_constants(const struct layout *l, const struct recipe *r, int noise, int kind)
{
    for (int i = 0; i < r->noises; i++) {
        if (l->at[i * KINDS + kind] != 0 &&
            memcmp(r->noise[i].noise, r->noise[noise].noise, sizeof r->noise[i].noise) == 0) {
            return l->at[i * KINDS + kind];
        }
    }
    return 0;
}

/* A noise without its warps. */
static struct scarp_noise noise_alone(const struct recipe *r, int index)
{
    struct scarp_noise levels[5];
    scarpi_recipe_spell_noise(r, index, levels);
    levels[0].warp = NULL;
    return levels[0];
}

/* Adds a noise with its warps. */
static void add_noise(struct layout *l, const struct recipe *r, int index, int dimensions,
                      int is_vector)
{
    for (; index >= 0; index = r->noise[index].warp, is_vector = 1) {
        const int slot = slot_of(index, dimensions, is_vector);
        l->at[slot] = same_constants(l, r, index, slot % KINDS);
        if (l->at[slot] == 0) {
            const struct scarp_noise noise = noise_alone(r, index);
            l->at[slot] = (uint32_t)l->bytes;
            l->bytes += scarpi_plan_bytes(&noise, dimensions, is_vector);
        }
    }
}

/* Lays out what the outputs need. */
static void lay_out(struct layout *l, const struct recipe *r)
{
    const size_t head = sizeof(struct recipe_plan) + (size_t)(r->noises * KINDS) * sizeof l->at[0];
    memset(l, 0, sizeof *l);
    l->bytes = (head + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    for (int k = 0; k < r->schedule.steps; k++) {
        const struct recipe_node *const n = &r->node[r->schedule.step[k]];
        if (n->operation == OP_NOISE || n->operation == OP_VECTOR || n->operation == OP_CELL) {
            add_noise(l, r, n->index, r->place[n->place].dimensions, n->operation == OP_VECTOR);
        }
    }
}

size_t scarpi_recipe_plan_bytes(const struct recipe *recipe)
{
    struct layout l;
    lay_out(&l, recipe);
    return l.bytes;
}

enum scarp_status scarpi_recipe_plan_write(const struct recipe *recipe, void *memory)
{
    struct recipe_plan *const plan = memory;
    enum scarp_status status = SCARP_OK;
    struct layout l;
    lay_out(&l, recipe);
    memset(memory, 0, l.bytes);
    plan->slots = (uint32_t)(recipe->noises * KINDS);
    memcpy(plan->at, l.at, plan->slots * sizeof plan->at[0]);
    for (uint32_t slot = 0; status == SCARP_OK && slot < plan->slots; slot++) {
        if (l.at[slot] != 0) {
            const struct scarp_noise noise = noise_alone(recipe, (int)slot / KINDS);
            const int dimensions = 2 + (int)slot % KINDS / 2, is_vector = (int)slot % 2;
            status = scarpi_plan_keep((char *)memory + l.at[slot],
                                      scarpi_plan_bytes(&noise, dimensions, is_vector), &noise,
                                      dimensions, is_vector);
        }
    }
    plan->mark = status == SCARP_OK ? MARK : 0;
    return status;
}

const struct recipe_plan *scarpi_recipe_plan_of(const void *plan)
{
    const struct recipe_plan *const p = plan;
    return p != NULL && (uintptr_t)plan % ALIGNMENT == 0 && p->mark == MARK ? p : NULL;
}

void scarpi_recipe_bring_plans(const struct recipe_plan *plan, const struct recipe *recipe,
                               int index, int dimensions, int is_vector, struct scarp_noise *noise)
{
    for (; plan != NULL && index >= 0; index = recipe->noise[index].warp, is_vector = 1, noise++) {
        const uint32_t slot = (uint32_t)slot_of(index, dimensions, is_vector);
        const uint32_t at = slot < plan->slots ? plan->at[slot] : 0;
        noise->plan = at != 0 ? (const void *)((const char *)plan + at) : NULL;
    }
}
