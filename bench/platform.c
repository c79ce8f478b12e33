/* SPDX-License-Identifier: MIT
 *
 * What C11 cannot ask: the time this thread has used, whether stderr is a terminal, the name of the
 * processor.
 */
#if defined(__APPLE__)
#define _DARWIN_C_SOURCE
#elif !defined(_WIN32)
#define _POSIX_C_SOURCE 200809L
#endif

#include "bench.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#if defined(_WIN32)
#include <io.h>
#include <windows.h>
#else
#include <unistd.h>
#endif
#if defined(__APPLE__)
#include <sys/sysctl.h>
#endif

#if defined(_WIN32)

/* Elapsed time: the time of a thread is counted in steps of 15 ms. */
double bench_seconds(void)
{
    LARGE_INTEGER now, frequency;
    QueryPerformanceCounter(&now);
    QueryPerformanceFrequency(&frequency);
    return (double)now.QuadPart / (double)frequency.QuadPart;
}

int bench_is_terminal_stderr(void)
{
    return _isatty(_fileno(stderr));
}

#else

double bench_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

int bench_is_terminal_stderr(void)
{
    return isatty(STDERR_FILENO);
}

#endif

#if defined(__APPLE__)

static int find_cpu_name(char *name, size_t size)
{
    return sysctlbyname("machdep.cpu.brand_string", name, &size, NULL, 0) == 0;
}

#elif defined(__linux__)

/* Finds the first line "key : value", and copies its value. The key ends before the space in front
   of the colon. */
static int read_cpuinfo(const char *key, char *value, size_t size)
{
    FILE *const file = fopen("/proc/cpuinfo", "r");
    const size_t length = strlen(key);
    char line[512];
    int found = 0;
    while (file != NULL && !found && fgets(line, sizeof line, file) != NULL) {
        if (strncmp(line, key, length) != 0) {
            continue;
        }
        const char *const colon = line + length + strspn(line + length, " \t");
        if (strncmp(colon, ": ", 2) == 0) {
            snprintf(value, size, "%.*s", (int)strcspn(colon + 2, "\n"), colon + 2);
            found = value[0] != '\0';
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return found;
}

/* x86 has "model name", which hypervisors shorten: family and model tell the generation. Others
   have one of the other keys, or nothing. */
static int find_cpu_name(char *name, size_t size)
{
    static const char *const keys[] = {"model name", "uarch", "cpu", "Model", "vendor_id"};
    char family[16], model[16];
    size_t i = 0;
    while (i < sizeof keys / sizeof keys[0] && !read_cpuinfo(keys[i], name, size)) {
        i++;
    }
    if (i == 0 && read_cpuinfo("cpu family", family, sizeof family) &&
        read_cpuinfo("model", model, sizeof model)) {
        const size_t length = strlen(name);
        snprintf(name + length, size - length, " (family %s, model %s)", family, model);
    }
    return i < sizeof keys / sizeof keys[0];
}

#else

static int find_cpu_name(char *name, size_t size)
{
    (void)name;
    (void)size;
    return 0;
}

#endif

void bench_cpu_name(char *name, size_t size)
{
#if defined(__aarch64__)
    const char *const family = "AArch64";
#elif defined(__x86_64__)
    const char *const family = "x86-64";
#else
    const char *const family = "unknown";
#endif
    if (!find_cpu_name(name, size)) {
        snprintf(name, size, "%s processor", family);
    }
}

void bench_utc_date(char *date, size_t size)
{
    const time_t now = time(NULL);
    const struct tm *const utc = gmtime(&now);
    if (utc == NULL || strftime(date, size, "%Y-%m-%dT%H:%M:%SZ", utc) == 0) {
        snprintf(date, size, "unknown");
    }
}
