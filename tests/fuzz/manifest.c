/* SPDX-License-Identifier: MIT
 *
 * Manifests: those that are the same agree, and it does not matter which of two is there.
 */
#include "terrain/manifest.h"

#include <string.h>

#include "cli.h"
#include "fuzz.h"
#include "shared/error.h"
#include "shared/json.h"

#define MOST 100

static const char ours[] = "{\n  \"manifest\": 1,\n  \"scarp\": \"0.2.0\",\n  \"size\": [64, 64],\n"
                           "  \"seed\": 1,\n  \"recipe\": null,\n  \"set\": {},\n"
                           "  \"derived\": {\"heights\": [0, 1]}\n}\n";

/* Whether the manifest `there` is of the world of `text` */
static bool agrees(const char *there, size_t length, const char *text)
{
    struct manifest manifest = {.option = "--resume"};
    const char *const path = fuzz_file("w.json", (const uint8_t *)there, length);
    fuzz_no_errors();
    const int status = manifest_compare(&manifest, path, text);
    fuzz_must_tell(status != CLI_SUCCESS, "a manifest");
    manifest_close(&manifest, true);
    return status == CLI_SUCCESS;
}

/* Whether each key is there once */
static bool is_plain(const char *text)
{
    struct json_member members[MOST];
    const int count = json_read(text, members, MOST);
    for (int i = 0; i < count; i++) {
        if (json_find_same(members, count, &members[i]) != &members[i]) {
            return false;
        }
    }
    return count >= 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *const text = fuzz_text(bytes, size);
    const size_t length = strlen(text);
    const bool is_same = agrees((const char *)bytes, size, ours);
    MUST(!is_same || length == size, "a manifest with a byte that is 0");
    if (length == size && is_plain(text)) {
        if (is_same) {
            MUST(agrees(text, length, text), "a manifest differs from itself");
        }
        if (agrees(text, length, text)) {
            MUST(agrees(ours, strlen(ours), text) == is_same, "the other way round is different");
        }
    }
    free(text);
    return 0;
}
