/* SPDX-License-Identifier: MIT
 *
 * The crew, the clock, and the end of the closing line.
 */
#include "shared/running.h"

#include <time.h>

#include "scarp.h"
#include "shared/error.h"
#include "shared/posix.h"

bool running_select(int isa)
{
    const enum scarp_status status = scarp_isa_select((enum scarp_isa)isa);
    if (status != SCARP_OK) {
        cli_error("--isa: %s", scarp_status_text(status));
    }
    return status == SCARP_OK;
}

struct crew *running_begin(const struct running_options *options)
{
    if (!running_select(options->isa)) {
        return NULL;
    }
    struct crew *const crew =
        crew_open(options->threads != 0 ? options->threads : crew_processors());
    if (crew == NULL) {
        cli_error("--threads: no memory");
    }
    return crew;
}

double running_seconds(void)
{
    struct timespec now = {0, 0}; /* stays so without a clock */
#if defined(CLOCK_MONOTONIC) && !defined(_WIN32)
    clock_gettime(CLOCK_MONOTONIC, &now);
#else
    timespec_get(&now, TIME_UTC);
#endif
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

void running_print(FILE *stream, const struct crew *crew)
{
    const size_t threads = crew_size(crew);
    fprintf(stream, " (%s, %zu thread%s)\n", scarp_isa_name(scarp_isa_active()), threads,
            threads == 1 ? "" : "s");
}
