/* SPDX-License-Identifier: MIT
 *
 * Numbers as text: what is read is written, in each of the ways, and read again as it was.
 */
#include "shared/number.h"

#include <math.h>
#include <string.h>

#include "fuzz.h"

static void read_again(const char *text, const char *end, double value)
{
    double again;
    MUST(*end == '\0' && strlen(text) < NUMBER_SIZE, "'%s' is too long", text);
    MUST(number_read(text, &again) == end && memcmp(&again, &value, sizeof value) == 0,
         "'%s' is %.17g, and not %.17g", text, again, value);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char written[NUMBER_SIZE];
    char *const text = fuzz_text(bytes, size);
    double value = NAN;
    const char *const end = number_read(text, &value);
    if (end != NULL) {
        MUST(end > text && end <= text + strlen(text), "a number ends before it begins");
        MUST(!isnan(value), "'%s' is no number", text);
    }
    if (end != NULL && isfinite(value)) {
        read_again(written, number_write_double(written, value), value);
        read_again(written, number_write_shortest(written, value, 0), value);
    }
    if (end != NULL && fabs(value) <= 3.4e38) {
        const float single = (float)value;
        double again;
        number_write_float(written, single);
        MUST(number_read(written, &again) != NULL && (float)again == single, "'%s'", written);
        number_write_shortest(written, (double)single, 1);
        MUST(number_read(written, &again) != NULL && (float)again == single, "'%s'", written);
    }
    free(text);
    return 0;
}
