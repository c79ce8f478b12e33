/* SPDX-License-Identifier: MIT
 *
 * Calls whose status recipes must keep. What was compiled is what these calls take, so none of them
 * should fail; but a call that does leaves its outputs as they were, which nobody wrote. With this
 * header, gcc warns wherever a status is dropped, behind a cast to void, too.
 */
#ifndef SCARP_RECIPE_STATUSES_H
#define SCARP_RECIPE_STATUSES_H

#include "../calls/chain.h"
#include "../calls/partials.h"
#include "../calls/run.h"
#include "scarp.h"

#ifdef __GNUC__
#define KEEP_STATUS __attribute__((warn_unused_result))
#define MUST_KEEP(call) extern __typeof__(call) call KEEP_STATUS

MUST_KEEP(scarp_sample2);
MUST_KEEP(scarp_sample3);
MUST_KEEP(scarp_sample2_f64);
MUST_KEEP(scarp_sample3_f64);
MUST_KEEP(scarp_grid2);
MUST_KEEP(scarp_grid3);
MUST_KEEP(scarp_vector2);
MUST_KEEP(scarp_vector3);
MUST_KEEP(scarp_vector2_f64);
MUST_KEEP(scarp_vector3_f64);
MUST_KEEP(scarp_cells2);
MUST_KEEP(scarp_cells3);
MUST_KEEP(scarp_cells2_f64);
MUST_KEEP(scarp_cells3_f64);
MUST_KEEP(scarp_gullies2);
MUST_KEEP(scarp_gullies2_f64);
MUST_KEEP(scarp_gullies_grid2);
#define OPERATOR(NAME, name, ...) MUST_KEEP(scarp_##name);
#define FUNCTION(...) OPERATOR(__VA_ARGS__)
#include "../plan/functions.def"
MUST_KEEP(scarp_range);
MUST_KEEP(scarp_gullies_range);
MUST_KEEP(scarpi_run);
MUST_KEEP(scarpi_chain_numbers);
MUST_KEEP(scarpi_chain_values);
MUST_KEEP(scarpi_curve_slopes);

#undef MUST_KEEP
#else
#define KEEP_STATUS
#endif

#endif
