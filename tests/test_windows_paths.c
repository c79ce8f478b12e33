/* SPDX-License-Identifier: MIT
 *
 * What paths become on Windows. Wine has no limit of 260 characters, so the prefix that lifts it
 * shows here alone.
 */
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "shared/windows.h"

#define LONG 300

static void check_wide(const char *start, const wchar_t *expected)
{
    char path[LONG + 64];
    strcpy(path, start);
    memset(path + strlen(path), 'a', LONG);
    path[strlen(start) + LONG] = '\0';
    wchar_t *const wide = windows_wide(path);
    CHECK(wide != NULL && wcsncmp(wide, expected, wcslen(expected)) == 0, "%s...", start);
    CHECK(wide != NULL && wcslen(wide) == wcslen(expected) + LONG, "%s...: length", start);
    free(wide);
}

static void check_root(const char *path, size_t expected)
{
    const size_t length = windows_root_length(path);
    CHECK(length == expected, "%s: the root has %d characters", path, (int)length);
}

int main(void)
{
    check_wide("C:/dir/../", L"\\\\?\\C:\\");
    check_wide("\\\\machine\\share\\", L"\\\\?\\UNC\\machine\\share\\");
    check_wide("\\\\?\\C:\\", L"\\\\?\\C:\\");
    wchar_t *const short_one = windows_wide("dir/\xc3\xa4.png");
    CHECK(short_one != NULL && wcscmp(short_one, L"dir/\xe4.png") == 0, "a short path");
    free(short_one);
    CHECK(windows_wide("\xff.png") == NULL && errno == EILSEQ, "no UTF-8");
    check_root("a/b", 0);
    check_root("/a/b", 0);
    check_root("C:\\a", 2);
    check_root("C:a", 2);
    check_root("\\\\machine\\share\\a", 15);
    check_root("//machine/share", 15);
    check_root("\\\\?\\C:\\a", 6);
    check_root("\\\\?\\UNC\\machine\\share\\a", 21);
    return check_done();
}
