/* SPDX-License-Identifier: MIT
 *
 *     fuzz_pack add PACKED FILE...
 *     fuzz_pack unpack PACKED FOLDER
 *
 * `add` adds files as inputs to a packed file (packed.h), under their names without folders. It
 * makes the packed file if there is none, and skips a file whose bytes are an input already. After
 * an error, the packed file is as it was. `unpack` writes each input as a file into a folder that
 * exists.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "packed.h"

static const char *base_name(const char *path)
{
    const char *name = path;
    for (; *path != '\0'; path++) {
        if (*path == '/' || *path == '\\') {
            name = path + 1;
        }
    }
    return name;
}

static int fail(const char *path, const char *wrong)
{
    fprintf(stderr, "fuzz_pack: %s: %s\n", path, wrong);
    return EXIT_FAILURE;
}

static int add(struct packed *set, const char *path, int count, char **files)
{
    static uint8_t bytes[PACKED_MOST];
    size_t added = 0;
    for (int i = 0; i < count; i++) {
        size_t size = 0;
        const char *wrong = packed_load(files[i], bytes, &size);
        if (wrong == NULL && packed_find(set, bytes, size) == NULL) {
            wrong = packed_add(set, base_name(files[i]), bytes, size);
            added++;
        }
        if (wrong != NULL) {
            return fail(files[i], wrong);
        }
    }
    const char *const wrong = added > 0 ? packed_write(set, path) : NULL;
    if (wrong != NULL) {
        return fail(path, wrong);
    }
    printf("%s: %zu added, %zu inputs\n", path, added, set->count);
    return EXIT_SUCCESS;
}

static int unpack(const struct packed *set, const char *folder)
{
    char path[4096];
    for (size_t i = 0; i < set->count; i++) {
        const struct packed_input *const input = &set->inputs[i];
        const int length = snprintf(path, sizeof path, "%s/%s", folder, input->name);
        FILE *const file = length > 0 && (size_t)length < sizeof path ? fopen(path, "wb") : NULL;
        const int is_written =
            file != NULL && fwrite(input->bytes, 1, input->size, file) == input->size;
        const int is_closed = file != NULL && fclose(file) == 0;
        if (!is_written || !is_closed) {
            return fail(path, "cannot be written");
        }
    }
    return EXIT_SUCCESS;
}

static int exists(const char *path)
{
    FILE *const file = fopen(path, "rb");
    if (file != NULL) {
        fclose(file);
    }
    return file != NULL;
}

int main(int argc, char **argv)
{
    struct packed set = {0};
    const int adds = argc >= 4 && strcmp(argv[1], "add") == 0;
    if (!adds && !(argc == 4 && strcmp(argv[1], "unpack") == 0)) {
        fprintf(stderr, "usage: fuzz_pack add PACKED FILE...\n"
                        "       fuzz_pack unpack PACKED FOLDER\n");
        return EXIT_FAILURE;
    }
    const char *const wrong = adds && !exists(argv[2]) ? NULL : packed_read(&set, argv[2]);
    const int status = wrong != NULL ? fail(argv[2], wrong)
                       : adds        ? add(&set, argv[2], argc - 3, argv + 3)
                                     : unpack(&set, argv[3]);
    packed_free(&set);
    return status;
}
