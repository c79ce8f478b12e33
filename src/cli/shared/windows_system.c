/* SPDX-License-Identifier: MIT
 *
 * Windows itself: arguments, consoles, the entries of directories, locks, processes, time.
 */
#include <windows.h>

#include <shellapi.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "shared/windows.h"

static UINT console_before; /* what the console took characters for; 0: it stays so */

static void restore_console(void)
{
    SetConsoleOutputCP(console_before);
}

bool windows_is_console(void)
{
    DWORD mode;
    return GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

bool windows_start(int *argc, char ***argv)
{
    int count = 0;
    wchar_t **const wide = CommandLineToArgvW(GetCommandLineW(), &count);
    char **const narrow = calloc((size_t)count + 1, sizeof *narrow);
    bool complete = wide != NULL && narrow != NULL;
    for (int i = 0; complete && i < count; i++) {
        narrow[i] = windows_narrow(wide[i]);
        complete = narrow[i] != NULL;
    }
    LocalFree(wide);
    _setmode(1, _O_BINARY);
    _setmode(2, _O_BINARY);
    if (windows_is_console() && GetConsoleOutputCP() != CP_UTF8) {
        console_before = GetConsoleOutputCP();
        SetConsoleOutputCP(CP_UTF8);
        atexit(restore_console);
    }
    *argc = count;
    *argv = narrow;
    return complete;
}

/* ---- directories ---- */

struct windows_directory {
    HANDLE search;
    WIN32_FIND_DATAW found;
    bool is_first;
    struct dirent entry;
};

DIR *windows_opendir(const char *path)
{
    char *const pattern = malloc(strlen(path) + sizeof "/*");
    DIR *const directory = calloc(1, sizeof *directory);
    if (pattern == NULL || directory == NULL) {
        free(pattern);
        free(directory);
        errno = ENOMEM;
        return NULL;
    }
    strcpy(pattern, path);
    strcat(pattern, "/*");
    wchar_t *const wide = windows_wide(pattern);
    directory->search =
        wide != NULL ? FindFirstFileW(wide, &directory->found) : INVALID_HANDLE_VALUE;
    if (wide != NULL && directory->search == INVALID_HANDLE_VALUE) {
        windows_set_errno();
    }
    directory->is_first = true;
    free(wide);
    free(pattern);
    if (directory->search == INVALID_HANDLE_VALUE) {
        free(directory);
        return NULL;
    }
    return directory;
}

struct dirent *windows_readdir(DIR *directory)
{
    if (!directory->is_first && !FindNextFileW(directory->search, &directory->found)) {
        return NULL;
    }
    directory->is_first = false;
    char *const name = windows_narrow(directory->found.cFileName);
    directory->entry.d_name[0] = '\0';
    if (name != NULL && strlen(name) < sizeof directory->entry.d_name) {
        strcpy(directory->entry.d_name, name);
    }
    free(name);
    return &directory->entry;
}

int windows_closedir(DIR *directory)
{
    FindClose(directory->search);
    free(directory);
    return 0;
}

/* ---- locks ---- */

/* Nobody can read or write what is locked here, so locks lie where no file has bytes. */
#define LOCKS_BEGIN (UINT64_C(1) << 62)

static int set_lock(int descriptor, uint64_t place, bool locks)
{
    const uint64_t at = LOCKS_BEGIN + place;
    const HANDLE file = (HANDLE)_get_osfhandle(descriptor);
    OVERLAPPED where = {.Offset = (DWORD)at, .OffsetHigh = (DWORD)(at >> 32)};
    const BOOL done = locks ? LockFileEx(file, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY,
                                         0, 1, 0, &where)
                            : UnlockFileEx(file, 0, 1, 0, &where);
    if (!done) {
        windows_set_errno();
    }
    return done ? 0 : -1;
}

int windows_flock(int descriptor, int operation)
{
    return set_lock(descriptor, 0, (operation & LOCK_EX) != 0);
}

int windows_fcntl(int descriptor, int command, ...)
{
    if (command != F_SETLK) {
        return 0; /* F_GETFL: nothing that matters here */
    }
    va_list arguments;
    va_start(arguments, command);
    const struct flock *const lock = va_arg(arguments, const struct flock *);
    va_end(arguments);
    const int result = set_lock(descriptor, 1 + (uint64_t)lock->l_start, lock->l_type == F_WRLCK);
    errno = result != 0 && errno == EWOULDBLOCK ? EAGAIN : errno;
    return result;
}

/* ---- processes and time ---- */

int windows_kill(long process)
{
    const HANDLE handle = OpenProcess(SYNCHRONIZE, FALSE, (DWORD)process);
    if (handle == NULL) {
        errno = GetLastError() == ERROR_INVALID_PARAMETER ? ESRCH : EPERM;
        return -1;
    }
    const bool has_ended = WaitForSingleObject(handle, 0) == WAIT_OBJECT_0;
    CloseHandle(handle);
    errno = ESRCH;
    return has_ended ? -1 : 0;
}

int windows_gethostname(char *name, size_t size)
{
    DWORD room = (DWORD)size;
    return GetComputerNameExA(ComputerNameDnsHostname, name, &room) ? 0 : -1;
}

int windows_statvfs(const char *path, struct statvfs *disk)
{
    ULARGE_INTEGER available, all;
    wchar_t *const wide = windows_wide(path);
    const bool is_known = wide != NULL && GetDiskFreeSpaceExW(wide, &available, &all, NULL) != 0;
    if (wide != NULL && !is_known) {
        windows_set_errno();
    }
    free(wide);
    if (!is_known) {
        return -1;
    }
    disk->f_frsize = 1;
    disk->f_bavail = available.QuadPart;
    disk->f_blocks = all.QuadPart;
    return 0;
}

int windows_nanosleep(const struct timespec *duration)
{
    Sleep((DWORD)(duration->tv_sec * 1000 + duration->tv_nsec / 1000000));
    return 0;
}

int windows_timespec_get(struct timespec *now)
{
    FILETIME time;
    GetSystemTimePreciseAsFileTime(&time);
    const uint64_t steps = (uint64_t)time.dwHighDateTime << 32 | time.dwLowDateTime;
    const uint64_t since_1970 = steps - UINT64_C(116444736000000000);
    now->tv_sec = (time_t)(since_1970 / 10000000);
    now->tv_nsec = (long)(since_1970 % 10000000 * 100);
    return TIME_UTC;
}
