/* SPDX-License-Identifier: MIT
 *
 * The crew, the clock, and the end of the closing line.
 */
#include "shared/running.h"

#include <time.h>

#include "scarp.h"
#include "shared/error.h"
#include "shared/posix.h"

struct crew *running_begin(const struct running_options *options)
{
    scarp_isa_select((enum scarp_isa)options->isa);
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
