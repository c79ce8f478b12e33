/* SPDX-License-Identifier: MIT
 *
 * For LD_PRELOAD: a system on which no file can be locked, as on some network file systems.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

int flock(int descriptor, int operation)
{
    (void)descriptor;
    (void)operation;
    errno = ENOLCK;
    return -1;
}

int fcntl(int descriptor, int command, ...)
{
    if (command == F_SETLK || command == F_SETLKW) {
        errno = ENOLCK;
        return -1;
    }
    va_list arguments;
    va_start(arguments, command);
    const long argument = va_arg(arguments, long);
    va_end(arguments);
    return (int)syscall(SYS_fcntl, descriptor, command, argument);
}

/* What programs with 64-bit file offsets call */
int fcntl64(int descriptor, int command, ...) __attribute__((alias("fcntl")));
