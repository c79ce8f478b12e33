/* SPDX-License-Identifier: MIT
 *
 * Tests of the operations that look up floats in small tables, with `ops` and `lanes`. Part of tests/test_vec.c.
 */
#ifndef SCARP_TESTS_VEC_LOOKUPS_H
#define SCARP_TESTS_VEC_LOOKUPS_H

#define TABLE_MAX (2 * LANES_MAX)

/* Makes a hash per lane: its upper 16 bits come from `upper`, those below are extreme or random. */
static void make_hashes(uint32_t *hash, uint32_t upper, uint64_t *state)
{
    static const uint32_t below[] = {0, 0xffff, 0x8000, 0x7fff};
    for (int i = 0; i < lanes; i++) {
        const uint64_t random = check_random(state);
        hash[i] = ((upper + (uint32_t)i * 4099u) & 0xffffu) << 16;
        hash[i] |= random >> 63 ? below[random & 3] : (uint32_t)random & 0xffffu;
    }
}

static void test_lookup(void)
{
    static const struct lookup tables[] = {
        LOOKUP_TABLE_HIGH(0x3f91a2b4u, 0x35ff6e5du, 0x6c878787u, 0x3c4cd55eu),
        LOOKUP_TABLE_LOW(0x3f2d2d2du, 0x50525253u, 0x413bbbbbu, 0x21800001u)};
    static const struct lookup_top top =
        LOOKUP_TOP(0x11, 0x92, 0x23, 0x40, 0xc0, 0x66, 0xf7, 0x08, 0x79, 0x8a, 0x3b, 0xec);
    uint64_t state = 5;
    for (uint32_t upper = 0; upper < 65536; upper++) {
        uint32_t hash[LANES_MAX];
        float found[2][LANES_MAX], topped[LANES_MAX];
        make_hashes(hash, upper, &state);
        ops->lookup(found[0], &tables[0], hash);
        ops->lookup(found[1], &tables[1], hash);
        ops->lookup_top(topped, &top, hash);
        for (int i = 0; i < lanes; i++) {
            for (int t = 0; t < 2; t++) {
                const uint32_t wanted = tables[t].entry[hash[i] >> 28];
                CHECK(bits_of_float(found[t][i]) == wanted,
                      "table %d, lane %d, hash %#x: %#x, not %#x", t, i, hash[i],
                      bits_of_float(found[t][i]), wanted);
            }
            const uint32_t byte = top.top[(hash[i] >> 16) * 12 >> 16];
            CHECK(bits_of_float(topped[i]) == byte << 24, "top, lane %d, hash %#x: %#x, not %#x", i,
                  hash[i], bits_of_float(topped[i]), byte << 24);
        }
    }
}

/* The four vectors of hashes are independent: each index is in each of them. */
static void test_lookup_four(void)
{
    static const struct lookup tables[] = {
        LOOKUP_TABLE_HIGH(0x12345678u, 0x0fedcba9u, 0x7e0f1e2du, 0x00ff80a5u),
        LOOKUP_TABLE_LOW(0x5a5a5a01u, 0x02a4a4a6u, 0x77070776u, 0x33000002u)};
    uint64_t state = 9;
    for (uint32_t upper = 0; upper < 65536; upper += 7) {
        uint32_t hash[4 * LANES_MAX];
        float found[4 * LANES_MAX];
        for (uint32_t n = 0; n < 4; n++) {
            make_hashes(hash + n * (uint32_t)lanes, upper * (2 * n + 1), &state);
        }
        for (int t = 0; t < 2; t++) {
            ops->lookup_four(found, &tables[t], hash);
            for (int i = 0; i < 4 * lanes; i++) {
                const uint32_t wanted = tables[t].entry[hash[i] >> 28];
                CHECK(bits_of_float(found[i]) == wanted,
                      "table %d, vector %d, lane %d, hash %#x: %#x, not %#x", t, i / lanes,
                      i % lanes, hash[i], bits_of_float(found[i]), wanted);
            }
        }
    }
}

static void check_sixteen(float found[2][4 * LANES_MAX], const uint32_t *entry,
                          const uint32_t *index, int shift)
{
    for (int i = 0; i < 4 * lanes; i++) {
        const uint32_t wanted = entry[index[i] >> shift & 15];
        CHECK(bits_of_float(found[0][i]) == wanted && bits_of_float(found[1][i]) == wanted,
              "lane %d, index %#x: %#x and %#x, not %#x", i, index[i], bits_of_float(found[0][i]),
              bits_of_float(found[1][i]), wanted);
    }
}

/* Random floats of all bits, and such that are negatives of each other. */
static void test_sixteen(void)
{
    uint64_t state = 10;
    for (int round = 0; round < 4000; round++) {
        uint32_t index[4 * LANES_MAX], bits[16];
        float entry[16], found[2][4 * LANES_MAX];
        for (int i = 0; i < 16; i++) {
            bits[i] = (uint32_t)(check_random(&state) >> 32) & 0xbfffffffu; /* no NaN */
        }
        for (int i = 0; i < 4 * lanes; i++) {
            index[i] = (uint32_t)(check_random(&state) >> 32);
        }
        memcpy(entry, bits, sizeof entry);
        ops->sixteen(found[0], found[1], entry, index);
        check_sixteen(found, bits, index, 0);
        for (int i = 0; i < 8; i++) {
            bits[i ^ 9] = bits[i] ^ 0x80000000u;
        }
        memcpy(entry, bits, sizeof entry);
        ops->sixteen_odd(found[0], found[1], entry, index);
        check_sixteen(found, bits, index, 28);
    }
}

static void test_among(void)
{
    uint64_t state = 12;
    for (int round = 0; round < 4000; round++) {
        uint32_t index[LANES_MAX], bits[LANES_MAX];
        float entry[LANES_MAX], found[LANES_MAX];
        for (int i = 0; i < lanes; i++) {
            bits[i] = (uint32_t)(check_random(&state) >> 32) & 0xbfffffffu; /* no NaN */
            index[i] = (uint32_t)(check_random(&state) >> 32);
        }
        memcpy(entry, bits, sizeof entry);
        ops->among(found, entry, index);
        for (int i = 0; i < lanes; i++) {
            const uint32_t wanted = bits[index[i] % (uint32_t)lanes];
            CHECK(bits_of_float(found[i]) == wanted, "lane %d, index %#x: %#x, not %#x", i,
                  index[i], bits_of_float(found[i]), wanted);
        }
    }
}

static void test_twelfth(void)
{
    uint64_t state = 11;
    for (uint32_t upper = 0; upper < 65536; upper++) {
        uint32_t hash[LANES_MAX], found[LANES_MAX];
        make_hashes(hash, upper, &state);
        ops->twelfth(found, hash);
        for (int i = 0; i < lanes; i++) {
            const uint32_t wanted = (hash[i] >> 16) * 12 >> 16;
            CHECK(found[i] == wanted, "lane %d, hash %#x: %u, not %u", i, hash[i], found[i],
                  wanted);
        }
    }
}

/* Asks for every entry in every lane, and for random ones in the others. */
static void test_permute(void)
{
    float entries[TABLE_MAX + LANES_MAX];
    uint64_t state = 6;
    for (int round = 0; round < 64; round++) {
        for (int i = 0; i < TABLE_MAX + LANES_MAX; i++) {
            entries[i] = float_of((uint32_t)check_random(&state) & 0xff7fffffu);
        }
        for (int asked = 0; asked < lanes * ops->table; asked++) {
            const int lane = asked / ops->table;
            uint32_t index[LANES_MAX], before[LANES_MAX];
            float found[LANES_MAX], next[LANES_MAX], slid[LANES_MAX];
            for (int i = 0; i < lanes; i++) {
                index[i] = (uint32_t)(check_random(&state) % (uint64_t)ops->table);
                index[i] = i == lane ? (uint32_t)(asked % ops->table) : index[i];
                before[i] = index[i] > 0 ? index[i] - 1 : 0;
            }
            ops->permute(found, entries, index, 0);
            ops->permute(next, entries, before, 1);
            ops->slide(slid, entries, entries + ops->table, index);
            for (int i = 0; i < lanes; i++) {
                const float *const e = entries;
                CHECK(!DIFFERENT32(found[i], e[index[i]]), "lane %d of entry %u", i, index[i]);
                CHECK(!DIFFERENT32(next[i], e[before[i] + 1]), "lane %d after %u", i, before[i]);
                CHECK(!DIFFERENT32(slid[i], e[(uint32_t)lanes + index[i]]), "lane %d of slid %u", i,
                      index[i]);
            }
        }
    }
}

#endif
