/* SPDX-License-Identifier: MIT
 *
 * What windows_files.c and windows_system.c give to posix.h, and what Windows needs besides. Macros
 * give these functions the names that POSIX has for them. All fail as POSIX says, with errno.
 */
#ifndef SCARP_CLI_WINDOWS_H
#define SCARP_CLI_WINDOWS_H

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <time.h>
#include <wchar.h>

#ifdef _MSC_VER
typedef ptrdiff_t ssize_t;
typedef int pid_t;
#endif
typedef unsigned windows_mode_t;
#define mode_t windows_mode_t

/* The arguments as UTF-8, and standard streams that pass bytes on as they are. Call it first. False
   without memory. */
bool windows_start(int *argc, char ***argv);

/* `path` from the root on, with '/' between its parts; in memory that the caller frees */
char *windows_absolute(const char *path);

/* How much of `path` names what no call can make: a drive, or a machine and what it shares */
size_t windows_root_length(const char *path);

/* Whether both name one file where upper and lower case are the same */
bool windows_is_same(const char *a, const char *b);

/* Whether stderr is a console. (_isatty says so of NUL, too.) */
bool windows_is_console(void);

/* Private to the two files: `path` as Windows takes it, in memory that the caller frees; NULL with
   errno. The same the other way; and errno for what GetLastError says. */
wchar_t *windows_wide(const char *path);
char *windows_narrow(const wchar_t *path);
void windows_set_errno(void);

/* ---- files ---- */

struct windows_stat {
    uint64_t st_dev, st_ino;
    unsigned st_mode;
    uint64_t st_nlink;
    int64_t st_size;
    struct timespec st_mtim, st_ctim;
};
int windows_stat(const char *path, struct windows_stat *status);
int windows_fstat(int descriptor, struct windows_stat *status);
#undef stat
#undef fstat
#define stat windows_stat
#define fstat windows_fstat
#undef S_ISREG
#undef S_ISCHR
#define S_ISREG(mode) (((mode)&_S_IFMT) == _S_IFREG)
#define S_ISCHR(mode) (((mode)&_S_IFMT) == _S_IFCHR)

#define O_RDONLY _O_RDONLY
#define O_WRONLY _O_WRONLY
#define O_RDWR _O_RDWR
#define O_CREAT _O_CREAT
#define O_EXCL _O_EXCL
#define O_TRUNC _O_TRUNC
#define O_APPEND _O_APPEND
#define O_CLOEXEC 0 /* no file goes to another program here */
#define O_NOFOLLOW 0
#define O_NONBLOCK 0
#define O_DIRECTORY 0x10000000 /* fails with EACCES: directories cannot be synchronised here */
int windows_open(const char *path, int flags, ...);
FILE *windows_fopen(const char *path, const char *mode);
#define open(...) windows_open(__VA_ARGS__)
#define fopen(path, mode) windows_fopen(path, mode)
#define fdopen _fdopen
#define fileno _fileno
#define close(descriptor) _close(descriptor)
#define dup(descriptor) _dup(descriptor)
#define fsync(descriptor) _commit(descriptor)
#define fchmod(descriptor, mode) ((void)(descriptor), (void)(mode), 0)
#undef fseeko
#define fseeko(stream, offset, whence) _fseeki64(stream, offset, whence)
#define off_t int64_t

ssize_t windows_read(int descriptor, void *bytes, size_t count);
ssize_t windows_write(int descriptor, const void *bytes, size_t count);
#define read(descriptor, bytes, count) windows_read(descriptor, bytes, count)
#define write(descriptor, bytes, count) windows_write(descriptor, bytes, count)

struct statvfs {
    uint64_t f_blocks, f_bavail, f_frsize;
};
int windows_statvfs(const char *path, struct statvfs *disk);
#define statvfs(path, disk) windows_statvfs(path, disk)

/* Like POSIX's, rename replaces a file that is there. */
int windows_rename(const char *from, const char *to);
int windows_link(const char *from, const char *to);
int windows_unlink(const char *path);
int windows_mkdir(const char *path);
int windows_rmdir(const char *path);
#define rename(from, to) windows_rename(from, to)
#define link(from, to) windows_link(from, to)
#define unlink(path) windows_unlink(path)
#define remove(path) windows_unlink(path)
#define mkdir(path, mode) windows_mkdir(path)
#define rmdir(path) windows_rmdir(path)

/* The path without symbolic links. A link to what is not there is not followed. */
char *windows_realpath(const char *path);
#define realpath(path, resolved) windows_realpath(path)
#define readlink(path, target, size) ((void)(path), (void)(target), (ssize_t)-1)

#define LOCK_EX 2
#define LOCK_NB 4
int windows_flock(int descriptor, int operation);
#define flock(descriptor, operation) windows_flock(descriptor, operation)

#define F_GETFL 3
#define F_SETLK 6
#define F_WRLCK 1
#define F_UNLCK 2
struct flock {
    short l_type, l_whence;
    off_t l_start, l_len;
};
int windows_fcntl(int descriptor, int command, ...);
#define fcntl(...) windows_fcntl(__VA_ARGS__)

struct dirent {
    char d_name[1024]; /* 255 units of UTF-16 are at most 765 bytes */
};
typedef struct windows_directory DIR;
DIR *windows_opendir(const char *path);
struct dirent *windows_readdir(DIR *directory);
int windows_closedir(DIR *directory);
#define opendir(path) windows_opendir(path)
#define readdir(directory) windows_readdir(directory)
#define closedir(directory) windows_closedir(directory)

/* ---- the system ---- */

/* 0 if there is a process of that number, -1 with ESRCH if not. */
int windows_kill(long process);
#define kill(process, signal) windows_kill((long)(process))
#define getpid() _getpid()

int windows_gethostname(char *name, size_t size);
#define gethostname(name, size) windows_gethostname(name, size)

int windows_nanosleep(const struct timespec *duration);
#define nanosleep(duration, rest) windows_nanosleep(duration)

int windows_timespec_get(struct timespec *now);
#undef TIME_UTC
#define TIME_UTC 1
#define timespec_get(now, base) windows_timespec_get(now)

#endif
