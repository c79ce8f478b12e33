/* SPDX-License-Identifier: MIT
 *
 * Four lanes take a stripe of 32 bytes at a time; what is left comes in steps of 8, 4 and 1.
 */
#include "shared/hash.h"

#include <errno.h>
#include <stdio.h>

#include "shared/interrupt.h"
#include "shared/posix.h"

#define STRIPE 32

static const uint64_t p1 = 0x9e3779b185ebca87, p2 = 0xc2b2ae3d27d4eb4f, p3 = 0x165667b19e3779f9,
                      p4 = 0x85ebca77c2b2ae63, p5 = 0x27d4eb2f165667c5;

static uint64_t turn(uint64_t x, int bits)
{
    return x << bits | x >> (64 - bits);
}

/* A number of so many bytes, the low one first */
static uint64_t get(const uint8_t *from, int bytes)
{
    uint64_t number = 0;
    for (int i = bytes - 1; i >= 0; i--) {
        number = number << 8 | from[i];
    }
    return number;
}

static uint64_t take(uint64_t lane, uint64_t input)
{
    return turn(lane + input * p2, 31) * p1;
}

static void take_stripe(uint64_t lane[4], const uint8_t *bytes)
{
    for (int i = 0; i < 4; i++) {
        lane[i] = take(lane[i], get(bytes + 8 * i, 8));
    }
}

/* The sum of `length` bytes, whose whole stripes the lanes have taken; the rest is at `from`. */
static uint64_t finish(const uint64_t lane[4], uint64_t length, const uint8_t *from)
{
    size_t left = (size_t)(length % STRIPE);
    uint64_t sum = lane[2] + p5;
    if (length >= STRIPE) {
        sum = turn(lane[0], 1) + turn(lane[1], 7) + turn(lane[2], 12) + turn(lane[3], 18);
        for (int i = 0; i < 4; i++) {
            sum = (sum ^ take(0, lane[i])) * p1 + p4;
        }
    }
    sum += length;
    for (; left >= 8; left -= 8, from += 8) {
        sum = turn(sum ^ take(0, get(from, 8)), 27) * p1 + p4;
    }
    for (; left >= 4; left -= 4, from += 4) {
        sum = turn(sum ^ get(from, 4) * p1, 23) * p2 + p3;
    }
    for (; left > 0; left--, from++) {
        sum = turn(sum ^ *from * p5, 11) * p1;
    }
    sum = (sum ^ sum >> 33) * p2;
    sum = (sum ^ sum >> 29) * p3;
    return sum ^ sum >> 32;
}

/* Bytes: shorter files are read to their end, so that a tile that was made is not lost. */
#define PATIENCE ((uint64_t)1 << 26)

bool hash_file(const char *path, uint64_t *sum)
{
    uint64_t lane[4] = {p1 + p2, p2, 0, 0 - p1}, length = 0;
    uint8_t bytes[512 * STRIPE];
    size_t count, taken;
    errno = 0;
    FILE *const file = fopen(path, "rb");
    if (file == NULL) {
        return false;
    }
    bool is_stopped = false;
    do {
        count = fread(bytes, 1, sizeof bytes, file);
        length += count;
        for (taken = 0; taken + STRIPE <= count; taken += STRIPE) {
            take_stripe(lane, bytes + taken);
        }
        is_stopped = count > 0 && length % PATIENCE == 0 && interrupted();
    } while (count == sizeof bytes && !is_stopped);
    const bool is_read = ferror(file) == 0 && !is_stopped;
    const int reason = is_stopped ? EINTR : errno;
    fclose(file);
    errno = reason;
    *sum = finish(lane, length, bytes + taken);
    return is_read;
}
