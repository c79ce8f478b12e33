/* SPDX-License-Identifier: MIT
 *
 * The calls of POSIX that handle files, by their own names on every system. Windows gets them from
 * windows_files.c and windows_system.c: there, a path is UTF-8, may be of any length, and names
 * what it names on POSIX systems. Macros of the same names stand for the calls there. They take the
 * wide calls of the system, and give long paths the prefix \\?\. (A manifest that sets the code
 * page to UTF-8 would need Windows 10, and a key of the registry for long paths.)
 */
#ifndef SCARP_CLI_POSIX_H
#define SCARP_CLI_POSIX_H

#ifdef _WIN32
#include "shared/windows.h"
#else
#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>
#endif

#endif
