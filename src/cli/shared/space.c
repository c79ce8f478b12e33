/* SPDX-License-Identifier: MIT
 *
 * Asks the nearest directory above a file that is there.
 */
#include "shared/space.h"

#include <stdlib.h>
#include <string.h>

#include "shared/path.h"
#include "shared/posix.h"
#include "shared/text.h"

/* The directory of a path without its separator, "." for none; in place */
static void go_up(char *path)
{
    size_t length = path_directory_length(path);
    while (length > 1 && path_directory_length(path) == length) {
        path[--length] = '\0';
    }
    path[length] = '\0';
}

/* Of a directory that is there */
static bool look(const char *directory, struct space *space)
{
    struct stat status;
    struct statvfs disk;
    if (stat(directory, &status) != 0 || statvfs(directory, &disk) != 0 || disk.f_blocks == 0) {
        return false;
    }
    space->device = (uint64_t)status.st_dev;
    space->bytes = (uint64_t)disk.f_bavail * disk.f_frsize;
    return true;
}

bool space_look(const char *path, struct space *space)
{
    char *const directory = text_copy(path);
    struct stat status;
    bool is_known = false;
    while (directory != NULL && directory[0] != '\0') {
        const size_t before = strlen(directory);
        go_up(directory);
        const char *const there = directory[0] != '\0' ? directory : ".";
        if (stat(there, &status) == 0) {
            is_known = look(there, space);
            break;
        }
        if (strlen(directory) >= before) {
            break;
        }
    }
    free(directory);
    return is_known;
}
