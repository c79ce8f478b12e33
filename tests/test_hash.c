/* SPDX-License-Identifier: MIT
 *
 * Compares statistics of the lattice hash and of the keys with those of random numbers. Usage:
 * test_hash [BITS], with 2^BITS points in a block (20).
 *
 * Every statistic is a z (hash_stats.h): standard normal for random numbers. Several thousand are
 * taken, so one of them lies beyond 5 by chance with a probability near 1/1000; all inputs are
 * fixed, so what passes once passes always. Each statistic must also reject a hash that is known to
 * be bad, by twice its bound. hash_sets.h has those of single blocks, hash_seeds.h those of seeds
 * and octaves, hash_lines.h those of lattice lines, hash_isotropy.h those of the
 * directions of 3D gradients, hash_cells.h those of simplex and cellular noise, hash_components.h
 * those of the components of vector noise; hash_repeats.h looks for parts of the lattice elsewhere.
 *
 * Only too little uniformity counts, not too much: multiplication spreads neighbours out more
 * evenly than chance would (low z), which does noise no harm.
 */
#include "hash_cells.h"
#include "hash_components.h"
#include "hash_isotropy.h"
#include "hash_lines.h"
#include "hash_repeats.h"
#include "hash_seeds.h"
#include "hash_sets.h"

#define BOUND 5.0
#define PEAK_BOUND 30.0  /* times the mean; see hash_lines.h */
#define SHIFTS_BOUND 7.0 /* the largest of 2^25 */
#define FAR_BOUND 6.0    /* of Cramer's V, over sqrt(points); random numbers have 4.1 */
#define FIELDS2 4
#define FIELDS3 2
#define BAD_BITS 16 /* few points are enough to reject a bad hash */

static void test_blocks(struct report *report, const struct hash *hash, int bits)
{
    struct workspace w;
    workspace_make(&w, bits);
    for (int i = 0; i < FIELDS2; i++) {
        const struct field f = field_make(i, 2, bits);
        test_uniform(report, hash, &f, &w);
        test_pairs(report, TOPIC_PAIRS2, hash, &f, &w);
        test_corners4(report, hash, &f, &w);
        test_values(report, hash, &f, &w);
        test_seed_pairs(report, hash, &f, &w);
    }
    for (int i = 0; i < FIELDS3; i++) {
        const struct field f = field_make(i == 0 ? 0 : 2, 3, bits);
        test_uniform(report, hash, &f, &w);
        test_pairs(report, TOPIC_PAIRS3, hash, &f, &w);
        test_corners8(report, hash, &f, &w);
        test_values(report, hash, &f, &w);
        test_seed_pairs(report, hash, &f, &w);
    }
    workspace_free(&w);
}

static double bound_of(int topic)
{
    return topic == TOPIC_SPECTRA ? PEAK_BOUND : topic == TOPIC_LINES ? SHIFTS_BOUND : BOUND;
}

static void check_report(const struct report *report)
{
    for (int topic = 0; topic < TOPICS; topic++) {
        CHECK(report->tests[topic] > 0, "no test of %s", topic_names[topic]);
        const double bound = bound_of(topic);
        CHECK(report->worst[topic] <= bound, "%s: %.1f, bound %.1f, for %s", topic_names[topic],
              report->worst[topic], bound, report->where[topic]);
    }
}

/* Finds the worst V for shifts of 2^24 and larger powers of two along an axis, over both dimensions
   and all axes. */
static void far_worst(const struct hash *hash, int bits, double worst[8])
{
    struct workspace w;
    workspace_make(&w, bits);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        for (int i = 0; i < 2; i++) {
            const struct field f = field_make(2 * i, dimensions, bits);
            far_pairs(hash, &f, &w, worst);
        }
    }
    printf("shifts of 2^24 to 2^31, worst Cramer's V:");
    for (int k = 0; k < 8; k++) {
        printf(" %.4f", worst[k]);
    }
    printf("\n");
    workspace_free(&w);
}

static void test_far(int bits)
{
    const double bound = FAR_BOUND / sqrt(1 << bits);
    double worst[8] = {0};
    far_worst(&scarp_hash, bits, worst);
    for (int k = 0; k < 8; k++) {
        CHECK(worst[k] <= bound, "shift 2^%d: V = %.4f, bound %.4f", 24 + k, worst[k], bound);
    }
}

#define BIT(topic) (1u << (topic))

/* Checks that the report rejects a hash in these topics, a set of bits. */
static void check_rejected(const struct report *report, const char *name, unsigned topics,
                           unsigned *rejected)
{
    report_print(report, name);
    for (int topic = 0; topic < TOPICS; topic++) {
        if ((topics & BIT(topic)) != 0) {
            CHECK(report->worst[topic] > 2.0 * bound_of(topic), "%s: %.1f does not reject \"%s\"",
                  topic_names[topic], report->worst[topic], name);
        }
    }
    *rejected |= topics;
}

static void test_bad_blocks(int bits, unsigned *rejected)
{
    static const struct {
        const struct hash *hash;
        unsigned topics;
    } bad[] = {
        {&prime_hash, BIT(TOPIC_PAIRS2) | BIT(TOPIC_PAIRS3) | BIT(TOPIC_CORNERS8)},
        {&sum_hash, BIT(TOPIC_CORNERS4) | BIT(TOPIC_CORNERS8) | BIT(TOPIC_TWIST)},
        {&moved_hash, BIT(TOPIC_SEEDS)},
        {&uneven_hash, BIT(TOPIC_UNIFORM) | BIT(TOPIC_VALUE)},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct report report;
        report_reset(&report);
        test_blocks(&report, bad[i].hash, bits);
        check_rejected(&report, bad[i].hash->name, bad[i].topics, rejected);
    }
    double worst[8] = {0};
    far_worst(&prime_hash, bits, worst);
    CHECK(worst[0] > 2.0 * FAR_BOUND / sqrt(1 << bits), "V = %.4f does not reject \"%s\"", worst[0],
          prime_hash.name);
}

/* Tests what is bad between seeds, between octaves, along lines, at centres or in cells. */
static void test_bad_lattices(int bits, unsigned *rejected)
{
    struct report report;
    report_reset(&report);
    test_seed_sequence(&report, &moved_hash, bits);
    test_line_pairs(&report, &moved_hash, bits);
    check_rejected(&report, moved_hash.name, BIT(TOPIC_SEQUENCE) | BIT(TOPIC_LINES), rejected);
    report_reset(&report);
    test_centres(&report, &tied_hash, bits);
    check_rejected(&report, tied_hash.name, BIT(TOPIC_CENTRES) | BIT(TOPIC_TETRAHEDRA), rejected);
    report_reset(&report);
    test_features(&report, &scarp_hash, &small_features, bits);
    check_rejected(&report, small_features.name, BIT(TOPIC_FEATURES), rejected);
    report_reset(&report);
    test_features(&report, &sum_hash, &scarp_features, bits);
    check_rejected(&report, sum_hash.name, BIT(TOPIC_NEIGHBOURS), rejected);
    report_reset(&report);
    test_components(&report, &field_draws, bits);
    check_rejected(&report, field_draws.name, BIT(TOPIC_COMPONENTS), rejected);
    report_reset(&report);
    test_components(&report, &alike_draws, bits);
    check_rejected(&report, alike_draws.name, BIT(TOPIC_COMPONENTS), rejected);
    report_reset(&report);
    test_octaves(&report, OCTAVES_ALIKE, bits);
    check_rejected(&report, "known bad octaves: alike", BIT(TOPIC_OCTAVES), rejected);
    report_reset(&report);
    test_spectra(&report, &product_hash, bits);
    check_rejected(&report, product_hash.name, BIT(TOPIC_SPECTRA), rejected);
}

static void test_bad(int bits)
{
    unsigned rejected = 0;
    test_bad_blocks(bits, &rejected);
    test_bad_lattices(bits, &rejected);
    CHECK(rejected == BIT(TOPICS) - 1, "topics %#x have rejected nothing",
          (BIT(TOPICS) - 1) & ~rejected);
    test_bad_directions(bits);
    test_bad_repeats(bits);
}

/* Tests the hashes that components draw from as if each were the hash of the lattice. Those of
   gradients have only upper halves. */
static void test_component_hashes(int bits)
{
    for (size_t i = 0; i < sizeof component_hashes / sizeof component_hashes[0]; i++) {
        const struct hash *const hash = &component_hashes[i];
        struct report report;
        report_reset(&report);
        test_blocks(&report, hash, bits);
        report_print(&report, hash->name);
        for (int topic = 0; topic < TOPICS; topic++) {
            CHECK(report.tests[topic] == 0 || report.worst[topic] <= bound_of(topic) ||
                      (topic == TOPIC_VALUE && i < 2),
                  "%s, %s: %.1f, for %s", hash->name, topic_names[topic], report.worst[topic],
                  report.where[topic]);
        }
    }
}

int main(int argc, char **argv)
{
    const int bits = argc > 1 ? atoi(argv[1]) : 20;
    struct report report;
    report_reset(&report);
    test_blocks(&report, &scarp_hash, bits);
    test_seed_sequence(&report, &scarp_hash, bits);
    test_octaves(&report, OCTAVES_OF_SCARP, bits);
    test_spectra(&report, &scarp_hash, bits);
    test_line_pairs(&report, &scarp_hash, bits);
    test_centres(&report, &centre_hash, bits);
    test_features(&report, &scarp_hash, &scarp_features, bits);
    for (size_t i = 0; i < sizeof scarp_draws / sizeof scarp_draws[0]; i++) {
        test_components(&report, &scarp_draws[i], bits - 2);
    }
    report_print(&report, scarp_hash.name);
    check_report(&report);
    test_component_hashes(bits - 3);
    test_far(bits);
    test_distinct_keys(bits);
    test_spectral();
    test_isotropy(bits);
    test_repeats(&scarp_hash, bits);
    test_bad(bits < BAD_BITS ? bits : BAD_BITS);
    return check_done();
}
