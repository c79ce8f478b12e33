/* SPDX-License-Identifier: MIT
 *
 * The choice of the instruction set through scarp.h. Part of tests/test_api.c.
 */
#ifndef SCARP_TESTS_API_ISA_H
#define SCARP_TESTS_API_ISA_H

#include <limits.h>

#include "outputs.h"

static inline void test_isa_unknown(void)
{
    const int unknown[] = {check_isa_count(), 1000, INT_MAX, -1, INT_MIN};
    CHECK(scarp_isa_select(SCARP_ISA_SCALAR) == SCARP_OK, "scalar");
    for (size_t i = 0; i < sizeof unknown / sizeof unknown[0]; i++) {
        const enum scarp_isa isa = (enum scarp_isa)unknown[i];
        CHECK(!scarp_isa_supported(isa), "%d", unknown[i]);
        CHECK(scarp_isa_select(isa) == SCARP_ERROR_ENUM, "%d", unknown[i]);
        CHECK(scarp_isa_active() == SCARP_ISA_SCALAR, "%d changed the choice", unknown[i]);
    }
}

/* Ranks the sets: scalar is the worst, then comes the portable one, then those made for a
   processor, of which a later one is better. */
static inline int isa_rank(enum scarp_isa isa)
{
    return isa == SCARP_ISA_SCALAR ? 0 : isa == SCARP_ISA_GENERIC ? 1 : 2 + (int)isa;
}

/* Must run before anything has selected an instruction set. Leaves the best one selected. */
static inline void test_isa(void)
{
    const enum scarp_isa first = scarp_isa_active();
    enum scarp_isa best = SCARP_ISA_SCALAR;
    int refused = 0;
    CHECK(!scarp_isa_supported(SCARP_ISA_NONE), "none is no instruction set");
    CHECK(scarp_isa_supported(SCARP_ISA_SCALAR), "scalar runs everywhere");
    for (int i = SCARP_ISA_SCALAR; i < check_isa_count(); i++) {
        const enum scarp_isa isa = (enum scarp_isa)i;
        CHECK(scarp_isa_select(SCARP_ISA_SCALAR) == SCARP_OK, "scalar");
        const enum scarp_status status = scarp_isa_select(isa);
        if (scarp_isa_supported(isa)) {
            CHECK(status == SCARP_OK && scarp_isa_active() == isa, "%s", scarp_isa_name(isa));
            best = isa_rank(isa) > isa_rank(best) ? isa : best;
        } else {
            CHECK(status == SCARP_ERROR_UNSUPPORTED, "%s", scarp_isa_name(isa));
            CHECK(scarp_isa_active() == SCARP_ISA_SCALAR, "%s changed the choice",
                  scarp_isa_name(isa));
            refused++;
        }
    }
    CHECK(refused > 0, "no processor has both SSE and NEON");
    CHECK(first == best, "%s was chosen, not %s", scarp_isa_name(first), scarp_isa_name(best));
    test_isa_unknown();
    CHECK(scarp_isa_select(SCARP_ISA_NONE) == SCARP_OK, "none");
    CHECK(scarp_isa_active() == best, "none leads to %s", scarp_isa_name(scarp_isa_active()));
}

#endif
