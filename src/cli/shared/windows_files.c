/* SPDX-License-Identifier: MIT
 *
 * Files on Windows, by the calls of POSIX that posix.h names. Paths go to the wide calls of the
 * system, which know all characters; long ones with the prefix that lifts their limit of 260.
 */
#include <windows.h>

#include <stdlib.h>
#include <string.h>

#include "shared/windows.h"

/* Directories are limited to 248 characters, with room for a name of 12 in them. */
#define SHORT_MOST 240

void windows_set_errno(void)
{
    static const struct {
        DWORD error;
        int number;
    } known[] = {{ERROR_FILE_NOT_FOUND, ENOENT},
                 {ERROR_PATH_NOT_FOUND, ENOENT},
                 {ERROR_INVALID_NAME, ENOENT},
                 {ERROR_BAD_PATHNAME, ENOENT},
                 {ERROR_BAD_NETPATH, ENOENT},
                 {ERROR_BAD_NET_NAME, ENOENT},
                 {ERROR_INVALID_DRIVE, ENOENT},
                 {ERROR_ACCESS_DENIED, EACCES},
                 {ERROR_SHARING_VIOLATION, EACCES},
                 {ERROR_WRITE_PROTECT, EROFS},
                 {ERROR_LOCK_VIOLATION, EWOULDBLOCK},
                 {ERROR_FILE_EXISTS, EEXIST},
                 {ERROR_ALREADY_EXISTS, EEXIST},
                 {ERROR_DIR_NOT_EMPTY, ENOTEMPTY},
                 {ERROR_DIRECTORY, ENOTDIR},
                 {ERROR_DISK_FULL, ENOSPC},
                 {ERROR_HANDLE_DISK_FULL, ENOSPC},
                 {ERROR_FILE_TOO_LARGE, EFBIG},
                 {ERROR_TOO_MANY_OPEN_FILES, EMFILE},
                 {ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG},
                 {ERROR_INVALID_HANDLE, EBADF},
                 {ERROR_NOT_ENOUGH_MEMORY, ENOMEM},
                 {ERROR_OUTOFMEMORY, ENOMEM},
                 {ERROR_BROKEN_PIPE, EPIPE},
                 {ERROR_NO_DATA, EPIPE},
                 {ERROR_PIPE_NOT_CONNECTED, EPIPE},
                 {ERROR_OPERATION_ABORTED, EINTR},
                 {ERROR_INVALID_PARAMETER, EINVAL},
                 {ERROR_NO_UNICODE_TRANSLATION, EILSEQ},
                 {ERROR_NOT_SUPPORTED, ENOSYS},
                 {ERROR_INVALID_FUNCTION, ENOSYS},
                 {ERROR_NOT_SAME_DEVICE, EXDEV}};
    const DWORD error = GetLastError();
    errno = EIO;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (known[i].error == error) {
            errno = known[i].number;
        }
    }
}

/* ---- paths ---- */

static bool begins_with(const wchar_t *path, const wchar_t *start)
{
    return wcsncmp(path, start, wcslen(start)) == 0;
}

/* Takes `path`, and returns it, or in its place one that may be long. */
static wchar_t *lift_limit(wchar_t *path)
{
    static const wchar_t to_long[] = L"\\\\?\\", to_share[] = L"\\\\?\\UNC";
    const DWORD size = GetFullPathNameW(path, 0, NULL, NULL); /* with the NUL */
    if (size <= SHORT_MOST || begins_with(path, to_long) || begins_with(path, L"\\\\.\\")) {
        return path;
    }
    const size_t room = sizeof to_share / sizeof to_share[0];
    wchar_t *const lifted = malloc((size + room) * sizeof *lifted);
    wchar_t *const full = lifted + room;
    if (lifted == NULL || GetFullPathNameW(path, size, full, NULL) != size - 1) {
        free(lifted);
        free(path);
        errno = ENOMEM;
        return NULL;
    }
    free(path);
    /* Of \\machine\share, one of the first two separators stays. */
    const bool is_share = begins_with(full, L"\\\\");
    const wchar_t *const from = is_share ? full + 1 : full;
    wcscpy(lifted, is_share ? to_share : to_long);
    memmove(lifted + wcslen(lifted), from, (wcslen(from) + 1) * sizeof *from);
    return lifted;
}

wchar_t *windows_wide(const char *path)
{
    const int size = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, NULL, 0);
    if (size == 0) {
        windows_set_errno();
        return NULL;
    }
    wchar_t *const wide = malloc((size_t)size * sizeof *wide);
    if (wide == NULL) {
        errno = ENOMEM;
        return NULL;
    }
    MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, size);
    return lift_limit(wide);
}

char *windows_narrow(const wchar_t *path)
{
    const int size = WideCharToMultiByte(CP_UTF8, 0, path, -1, NULL, 0, NULL, NULL);
    char *const narrow = size > 0 ? malloc((size_t)size) : NULL;
    if (narrow == NULL) {
        errno = ENOMEM;
        return NULL;
    }
    WideCharToMultiByte(CP_UTF8, 0, path, -1, narrow, size, NULL, NULL);
    return narrow;
}

/* A path without what lift_limit puts in front of it */
static char *narrow_plainly(wchar_t *path)
{
    if (begins_with(path, L"\\\\?\\UNC\\")) {
        path += 6;
        path[0] = L'\\';
    } else if (begins_with(path, L"\\\\?\\") && path[4] != L'\0' && path[5] == L':') {
        path += 4;
    }
    return windows_narrow(path);
}

char *windows_absolute(const char *path)
{
    wchar_t *const wide = windows_wide(path);
    const DWORD size = wide != NULL ? GetFullPathNameW(wide, 0, NULL, NULL) : 0;
    wchar_t *const full = size > 0 ? malloc(size * sizeof *full) : NULL;
    char *absolute = NULL;
    if (full != NULL && GetFullPathNameW(wide, size, full, NULL) == size - 1) {
        absolute = narrow_plainly(full);
    }
    free(wide);
    free(full);
    for (char *c = absolute; c != NULL && *c != '\0'; c++) {
        *c = *c == '\\' ? '/' : *c;
    }
    if (absolute != NULL && absolute[0] >= 'a' && absolute[0] <= 'z' && absolute[1] == ':') {
        absolute[0] = (char)(absolute[0] - 'a' + 'A');
    }
    return absolute;
}

static bool is_separator(char c)
{
    return c == '/' || c == '\\';
}

size_t windows_root_length(const char *path)
{
    size_t at = 0;
    if (is_separator(path[0]) && is_separator(path[1])) {
        /* \\machine\share, \\?\C: and \\?\UNC\machine\share */
        const bool is_long = path[2] == '?';
        const int parts = is_long ? (strncmp(path + 4, "UNC", 3) == 0 ? 4 : 2) : 2;
        at = 2;
        for (int i = 0; i < parts && path[at] != '\0'; i++) {
            at += i > 0 ? 1 : 0;
            while (path[at] != '\0' && !is_separator(path[at])) {
                at++;
            }
        }
    } else if (path[0] != '\0' && path[1] == ':') {
        at = 2;
    }
    return at;
}

bool windows_is_same(const char *a, const char *b)
{
    wchar_t *const first = windows_wide(a), *const second = windows_wide(b);
    const bool same = first != NULL && second != NULL &&
                      CompareStringOrdinal(first, -1, second, -1, TRUE) == CSTR_EQUAL;
    free(first);
    free(second);
    return same;
}

/* Asks for nothing but to know about the file, which may be a directory. */
static HANDLE open_to_look(const wchar_t *path)
{
    return CreateFileW(path, FILE_READ_ATTRIBUTES,
                       FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, NULL, OPEN_EXISTING,
                       FILE_FLAG_BACKUP_SEMANTICS, NULL);
}

char *windows_realpath(const char *path)
{
    wchar_t *const wide = windows_wide(path);
    char *real = NULL;
    const HANDLE file = wide != NULL ? open_to_look(wide) : INVALID_HANDLE_VALUE;
    if (wide != NULL && file == INVALID_HANDLE_VALUE) {
        windows_set_errno();
    }
    free(wide);
    if (file == INVALID_HANDLE_VALUE) {
        return NULL;
    }
    const DWORD size = GetFinalPathNameByHandleW(file, NULL, 0, 0);
    wchar_t *const final = size > 0 ? malloc((size + 1) * sizeof *final) : NULL;
    if (final != NULL && GetFinalPathNameByHandleW(file, final, size + 1, 0) > 0) {
        real = narrow_plainly(final);
    } else {
        real = windows_absolute(path); /* not every file system can tell */
    }
    free(final);
    CloseHandle(file);
    return real;
}

/* ---- opening ---- */

static bool is_directory(const wchar_t *path)
{
    const DWORD attributes = GetFileAttributesW(path);
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
}

/* Whether `path` names a pipe: to open one is to join it, and it cannot be made. */
static bool is_pipe(const wchar_t *path)
{
    static const wchar_t start[] = L"\\\\.\\pipe\\";
    const size_t length = sizeof start / sizeof start[0] - 1;
    for (size_t i = 0; i < length; i++) {
        const wchar_t c = path[i] == L'/' ? L'\\' : path[i];
        if (c != start[i]) {
            return false;
        }
    }
    return true;
}

/* Everybody may open, rename and remove the file meanwhile, as on POSIX systems. */
int windows_open(const char *path, int flags, ...)
{
    /* Who may only append writes behind the end, wherever others have brought that. */
    const DWORD access = (flags & O_APPEND) != 0   ? GENERIC_READ | FILE_APPEND_DATA
                         : (flags & O_RDWR) != 0   ? GENERIC_READ | GENERIC_WRITE
                         : (flags & O_WRONLY) != 0 ? GENERIC_WRITE
                                                   : GENERIC_READ;
    const DWORD share = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    const DWORD creation = (flags & O_EXCL) != 0    ? CREATE_NEW
                           : (flags & O_TRUNC) != 0 ? CREATE_ALWAYS
                           : (flags & O_CREAT) != 0 ? OPEN_ALWAYS
                                                    : OPEN_EXISTING;
    if ((flags & O_DIRECTORY) != 0) {
        errno = EACCES;
        return -1;
    }
    wchar_t *const wide = windows_wide(path);
    if (wide == NULL) {
        return -1;
    }
    const HANDLE file =
        CreateFileW(wide, access, share, NULL, is_pipe(wide) ? OPEN_EXISTING : creation,
                    FILE_ATTRIBUTE_NORMAL, NULL);
    if (file == INVALID_HANDLE_VALUE) {
        windows_set_errno();
        errno = errno == EACCES && is_directory(wide) ? EISDIR : errno;
    }
    free(wide);
    if (file == INVALID_HANDLE_VALUE) {
        return -1;
    }
    const int descriptor = _open_osfhandle((intptr_t)file, _O_BINARY | _O_NOINHERIT);
    if (descriptor < 0) {
        CloseHandle(file);
    }
    return descriptor;
}

FILE *windows_fopen(const char *path, const char *mode)
{
    const int flags = strchr(mode, '+') != NULL ? O_RDWR : mode[0] == 'r' ? O_RDONLY : O_WRONLY;
    const int descriptor =
        windows_open(path, mode[0] == 'w' ? flags | O_CREAT | O_TRUNC : flags, 0666);
    FILE *const stream = descriptor >= 0 ? _fdopen(descriptor, mode) : NULL;
    if (descriptor >= 0 && stream == NULL) {
        _close(descriptor);
    }
    return stream;
}

/* ---- looking ---- */

/* From steps of 100 ns since 1601 */
static struct timespec to_time(int64_t steps)
{
    const int64_t since_1970 = steps - INT64_C(116444736000000000);
    return (struct timespec){.tv_sec = (time_t)(since_1970 / 10000000),
                             .tv_nsec = (long)(since_1970 % 10000000 * 100)};
}

static int look(HANDLE file, struct windows_stat *status)
{
    BY_HANDLE_FILE_INFORMATION about;
    FILE_BASIC_INFO times;
    *status = (struct windows_stat){0};
    switch (GetFileType(file)) {
    case FILE_TYPE_CHAR: status->st_mode = _S_IFCHR; return 0;
    case FILE_TYPE_PIPE: status->st_mode = _S_IFIFO; return 0;
    case FILE_TYPE_DISK: break;
    default: errno = EBADF; return -1;
    }
    if (!GetFileInformationByHandle(file, &about) ||
        !GetFileInformationByHandleEx(file, FileBasicInfo, &times, sizeof times)) {
        windows_set_errno();
        return -1;
    }
    const bool is_folder = (about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
    status->st_mode = (is_folder ? _S_IFDIR : _S_IFREG) | 0666u;
    status->st_dev = about.dwVolumeSerialNumber;
    status->st_ino = (uint64_t)about.nFileIndexHigh << 32 | about.nFileIndexLow;
    status->st_nlink = about.nNumberOfLinks;
    status->st_size = (int64_t)((uint64_t)about.nFileSizeHigh << 32 | about.nFileSizeLow);
    status->st_mtim = to_time(times.LastWriteTime.QuadPart);
    status->st_ctim = times.ChangeTime.QuadPart != 0 ? to_time(times.ChangeTime.QuadPart)
                                                     : status->st_mtim; /* FAT has none */
    return 0;
}

int windows_stat(const char *path, struct windows_stat *status)
{
    wchar_t *const wide = windows_wide(path);
    if (wide == NULL) {
        return -1;
    }
    if (is_pipe(wide)) {
        *status = (struct windows_stat){.st_mode = _S_IFIFO};
        free(wide);
        return 0;
    }
    const HANDLE file = open_to_look(wide);
    if (file == INVALID_HANDLE_VALUE) {
        windows_set_errno();
    }
    free(wide);
    if (file == INVALID_HANDLE_VALUE) {
        return -1;
    }
    const int result = look(file, status);
    CloseHandle(file);
    return result;
}

int windows_fstat(int descriptor, struct windows_stat *status)
{
    return look((HANDLE)_get_osfhandle(descriptor), status);
}

/* ---- reading and writing ---- */

#define TRANSFER_MOST ((size_t)1 << 20)

ssize_t windows_read(int descriptor, void *bytes, size_t count)
{
    const DWORD wanted = (DWORD)(count < TRANSFER_MOST ? count : TRANSFER_MOST);
    DWORD done = 0;
    SetLastError(ERROR_SUCCESS);
    if (!ReadFile((HANDLE)_get_osfhandle(descriptor), bytes, wanted, &done, NULL)) {
        if (GetLastError() == ERROR_BROKEN_PIPE || GetLastError() == ERROR_HANDLE_EOF) {
            return 0;
        }
        windows_set_errno();
        errno = errno == EACCES ? EBADF : errno;
        return -1;
    }
    if (done == 0 && GetLastError() == ERROR_OPERATION_ABORTED) { /* a console, by Ctrl-C */
        errno = EINTR;
        return -1;
    }
    return (ssize_t)done;
}

ssize_t windows_write(int descriptor, const void *bytes, size_t count)
{
    const DWORD wanted = (DWORD)(count < TRANSFER_MOST ? count : TRANSFER_MOST);
    DWORD done = 0;
    if (!WriteFile((HANDLE)_get_osfhandle(descriptor), bytes, wanted, &done, NULL)) {
        windows_set_errno();
        return -1;
    }
    return (ssize_t)done;
}

/* ---- names ---- */

#define TRIES 20
#define PAUSE 25 /* milliseconds */

/* Calls `action` until it succeeds. Virus scanners and the like hold files open for a moment. */
static int insist(BOOL (*action)(const wchar_t *from, const wchar_t *to), const char *from,
                  const char *to)
{
    wchar_t *const first = windows_wide(from), *const second = to != NULL ? windows_wide(to) : NULL;
    int result = -1;
    for (int i = 0; first != NULL && (to == NULL || second != NULL) && i < TRIES; i++) {
        if (action(first, second)) {
            result = 0;
            break;
        }
        const DWORD error = GetLastError();
        windows_set_errno();
        if (error != ERROR_ACCESS_DENIED && error != ERROR_SHARING_VIOLATION) {
            break;
        }
        Sleep(PAUSE);
    }
    free(first);
    free(second);
    return result;
}

static BOOL replace(const wchar_t *from, const wchar_t *to)
{
    return MoveFileExW(from, to, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH);
}

static BOOL make_link(const wchar_t *from, const wchar_t *to)
{
    return CreateHardLinkW(to, from, NULL);
}

static BOOL delete (const wchar_t *path, const wchar_t *unused)
{
    (void)unused;
    return DeleteFileW(path);
}

int windows_rename(const char *from, const char *to)
{
    return insist(replace, from, to);
}

int windows_link(const char *from, const char *to)
{
    return insist(make_link, from, to);
}

int windows_unlink(const char *path)
{
    return insist(delete, path, NULL);
}

int windows_mkdir(const char *path)
{
    wchar_t *const wide = windows_wide(path);
    const bool made = wide != NULL && CreateDirectoryW(wide, NULL);
    if (wide != NULL && !made) {
        windows_set_errno();
        errno = is_directory(wide) ? EEXIST : errno; /* access is denied to make a drive */
    }
    free(wide);
    return made ? 0 : -1;
}

int windows_rmdir(const char *path)
{
    wchar_t *const wide = windows_wide(path);
    const bool removed = wide != NULL && RemoveDirectoryW(wide);
    if (wide != NULL && !removed) {
        windows_set_errno();
    }
    free(wide);
    return removed ? 0 : -1;
}
