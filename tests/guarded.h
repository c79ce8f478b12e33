/* SPDX-License-Identifier: MIT
 *
 * Memory between two pages that cannot be touched, for tests/test_memory.c. POSIX only; elsewhere
 * GUARDED_EXISTS is 0. Include it first: it asks the system for more than C11.
 */
#ifndef SCARP_TESTS_GUARDED_H
#define SCARP_TESTS_GUARDED_H

#if !defined(_WIN32) && !defined(__wasm__)
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#define _DARWIN_C_SOURCE
#include <sys/mman.h>
#include <unistd.h>
#define GUARDED_EXISTS 1
#else
#define GUARDED_EXISTS 0
#endif

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* `size` usable bytes from `start` on: whole pages, with a guard page on either side. */
struct guarded {
    unsigned char *start;
    size_t size;
    unsigned char *writable; /* of read-only bytes: the same bytes elsewhere, or NULL */
};

#if GUARDED_EXISTS
static inline struct guarded guarded_make(size_t bytes)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    struct guarded g = {.size = (bytes + page - 1) / page * page};
    unsigned char *const all =
        mmap(NULL, g.size + 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if ((void *)all == MAP_FAILED || mprotect(all, page, PROT_NONE) != 0 ||
        mprotect(all + page + g.size, page, PROT_NONE) != 0) {
        printf("cannot map memory\n");
        exit(EXIT_FAILURE);
    }
    g.start = all + page;
    return g;
}

static inline void guarded_protect(const struct guarded *g, int readonly)
{
    if (mprotect(g->start, g->size, readonly ? PROT_READ : PROT_READ | PROT_WRITE) != 0) {
        printf("cannot protect memory\n");
        exit(EXIT_FAILURE);
    }
}

/* Bytes that only guarded_write() can write. Two views of one file take no system call for each
   write; where there is no such file, the pages are made writable each time. */
static inline struct guarded guarded_make_readonly(size_t bytes)
{
    struct guarded g = guarded_make(bytes);
    FILE *const file = tmpfile();
    if (file != NULL && ftruncate(fileno(file), (off_t)g.size) == 0) {
        void *const writable =
            mmap(NULL, g.size, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(file), 0);
        if (writable != MAP_FAILED && mmap(g.start, g.size, PROT_READ, MAP_SHARED | MAP_FIXED,
                                           fileno(file), 0) == (void *)g.start) {
            g.writable = writable;
        }
    }
    if (file != NULL) {
        fclose(file); /* the views stay */
    }
    if (g.writable == NULL) {
        guarded_protect(&g, 1);
    }
    return g;
}

/* Writes to `to`, which lies in read-only bytes. */
static inline void guarded_write(const struct guarded *g, void *to, const void *from, size_t bytes)
{
    if (g->writable != NULL) {
        memcpy(g->writable + ((unsigned char *)to - g->start), from, bytes);
        return;
    }
    guarded_protect(g, 0);
    memcpy(to, from, bytes);
    guarded_protect(g, 1);
}
#endif

#endif
