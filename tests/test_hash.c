/* SPDX-License-Identifier: MIT
 *
 * The lattice hash and the keys against statistics of random numbers. Usage: test_hash [BITS], with
 * 2^BITS points in a block (20).
 *
 * Every statistic is a z (hash_stats.h): standard normal for random numbers. Several thousand are
 * taken, so one of them lies beyond 5 by chance with a probability near 1/1000; all inputs are
 * fixed, so what passes once passes always. The same statistics must reject a hash that is known
 * to be bad. hash_sets.h has those of single blocks, hash_seeds.h those of seeds and octaves.
 *
 * Only too little uniformity counts, not too much: multiplication spreads neighbours out more
 * evenly than chance would (low z), which does noise no harm.
 */
#include "hash_seeds.h"
#include "hash_sets.h"

#define BOUND 5.0
#define FIELDS2 4
#define FIELDS3 2
#define BAD_BITS 16 /* what is bad shows in few points */

/*
 * Shifts of 2^24 and more touch only the top 8 bits of the products i * HASH_X, so the two indices
 * are not quite independent. Nothing shows points that far apart side by side; what matters is that
 * the fields differ. Bounds on Cramer's V (0: independent, 1: one index tells the other), by
 * exponent from 24; random numbers have 0.004 in 2^20 points, and FAR_NOISE / sqrt(points) in
 * general.
 */
static const double far_bound[8] = {0.02, 0.02, 0.02, 0.02, 0.02, 0.08, 0.06, 0.15};
#define FAR_NOISE 5.0

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

static void check_report(const struct report *report)
{
    for (int topic = 0; topic < TOPICS; topic++) {
        CHECK(report->tests[topic] > 0, "no test of %s", topic_names[topic]);
        CHECK(report->worst[topic] <= BOUND, "%s: z = %.1f, bound %.1f, for %s", topic_names[topic],
              report->worst[topic], BOUND, report->where[topic]);
    }
}

/* Far shifts and periods, over both dimensions and all axes: the worst V of each power of two. */
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
        printf(" %.3f", worst[k]);
    }
    printf("\n");
    workspace_free(&w);
}

static void test_far(int bits)
{
    double worst[8] = {0};
    far_worst(&scarp_hash, bits, worst);
    for (int k = 0; k < 8; k++) {
        const double bound = far_bound[k] + FAR_NOISE / sqrt(1 << bits);
        CHECK(worst[k] <= bound, "shift 2^%d: V = %.3f, bound %.3f", 24 + k, worst[k], bound);
    }
}

static void test_bad_hash(int bits)
{
    static const enum topic seen[] = {TOPIC_PAIRS2, TOPIC_PAIRS3, TOPIC_CORNERS8, TOPIC_SEEDS};
    struct report report;
    report_reset(&report);
    test_blocks(&report, &known_bad_hash, bits);
    report_print(&report, known_bad_hash.name);
    for (size_t i = 0; i < sizeof seen / sizeof seen[0]; i++) {
        CHECK(report.worst[seen[i]] > 2 * BOUND, "%s: z = %.1f does not reject the bad hash",
              topic_names[seen[i]], report.worst[seen[i]]);
    }
    double worst[8] = {0};
    far_worst(&known_bad_hash, bits, worst);
    CHECK(worst[0] > 2 * far_bound[0], "V = %.3f at 2^24 does not reject the bad hash", worst[0]);
}

int main(int argc, char **argv)
{
    const int bits = argc > 1 ? atoi(argv[1]) : 20;
    struct report report;
    report_reset(&report);
    test_blocks(&report, &scarp_hash, bits);
    test_seed_sequence(&report, bits);
    test_octaves(&report, bits);
    report_print(&report, scarp_hash.name);
    check_report(&report);
    test_far(bits);
    test_distinct_keys(bits);
    test_bad_hash(bits < BAD_BITS ? bits : BAD_BITS);
    return check_done();
}
