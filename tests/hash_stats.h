/* SPDX-License-Identifier: MIT
 *
 * Statistics for tests/test_hash.c, all brought to one scale: z, which is standard normal if the
 * hash is as good as random numbers. Each is booked under a topic, and a table shows the worst of
 * every topic.
 */
#ifndef SCARP_TESTS_HASH_STATS_H
#define SCARP_TESTS_HASH_STATS_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>

enum topic {
    TOPIC_UNIFORM,    /* one index */
    TOPIC_PAIRS2,     /* g(i) with g(i + e), 2D, components of e below 2^24 */
    TOPIC_PAIRS3,     /* the same, 3D */
    TOPIC_CORNERS4,   /* the corners of a 2D cell jointly, their exclusive or, alternating sum */
    TOPIC_CORNERS8,   /* the same of a 3D cell, and of its faces */
    TOPIC_TWIST,      /* the alternating sum of the hashes themselves, 2D */
    TOPIC_SEEDS,      /* neighbouring seeds at the same points */
    TOPIC_SEQUENCE,   /* many seeds at one point */
    TOPIC_VALUE,      /* lattice values: moments, bins, correlation along e */
    TOPIC_OCTAVES,    /* octaves of one noise around the origin */
    TOPIC_SPECTRA,    /* peaks of the spectra of lines, in units of their means: no z */
    TOPIC_LINES,      /* a line with others at any shift */
    TOPIC_CENTRES,    /* corners and centres of simplex noise, in pairs */
    TOPIC_TETRAHEDRA, /* the corners and centres of a tetrahedron jointly */
    TOPIC_FEATURES,   /* the numbers of one feature of cellular noise */
    TOPIC_NEIGHBOURS, /* the numbers of two features */
    TOPIC_COMPONENTS, /* the components of vector noise, in pairs and all three */
    TOPICS
};

static const char *const topic_names[TOPICS] = {"uniform index",
                                                "pairs 2D",
                                                "pairs 3D",
                                                "4 corners",
                                                "8 corners",
                                                "twist",
                                                "neighbouring seeds",
                                                "sequence of seeds",
                                                "value noise bits",
                                                "octaves at the origin",
                                                "spectra of lines",
                                                "lines at all shifts",
                                                "centres",
                                                "tetrahedra",
                                                "features",
                                                "neighbouring features",
                                                "components"};

struct report {
    double worst[TOPICS], lowest[TOPICS];
    long tests[TOPICS];
    char where[TOPICS][96];
};

static inline void report_reset(struct report *report)
{
    for (int topic = 0; topic < TOPICS; topic++) {
        report->worst[topic] = -HUGE_VAL;
        report->lowest[topic] = HUGE_VAL;
        report->tests[topic] = 0;
        report->where[topic][0] = '\0';
    }
}

/* Books one z. NaN, which comes from a field without variation, counts as infinite. The printf
   format that follows says which test it was. */
#define REPORT(report, topic, z, ...)                                                              \
    do {                                                                                           \
        const double report_given = (z);                                                           \
        const double report_z = isnan(report_given) ? HUGE_VAL : report_given;                     \
        (report)->tests[topic]++;                                                                  \
        (report)->lowest[topic] = fmin((report)->lowest[topic], report_z);                         \
        if (report_z > (report)->worst[topic]) {                                                   \
            (report)->worst[topic] = report_z;                                                     \
            snprintf((report)->where[topic], sizeof(report)->where[topic], __VA_ARGS__);           \
        }                                                                                          \
    } while (0)

static inline void report_print(const struct report *report, const char *title)
{
    printf("%s\n  %-22s %6s %9s %9s  %s\n", title, "topic", "tests", "lowest z", "worst z",
           "worst is");
    for (int topic = 0; topic < TOPICS; topic++) {
        if (report->tests[topic] > 0) {
            printf("  %-22s %6ld %9.1f %9.1f  %s\n", topic_names[topic], report->tests[topic],
                   report->lowest[topic], report->worst[topic], report->where[topic]);
        }
    }
}

/* Compares the counts with those of `cells` equally likely cells. */
static inline double chi_square(const uint32_t *counts, int cells, double total)
{
    const double expected = total / cells;
    double sum = 0.0;
    for (int i = 0; i < cells; i++) {
        const double d = counts[i] - expected;
        sum += d * d;
    }
    return sum / expected;
}

/*
 * Chi-square to z by the cube root (Wilson and Hilferty 1931). The plain (chi2 - dof) / sqrt(2 dof)
 * is the same thing for thousands of degrees of freedom, but its upper tail is far too heavy for
 * 15 of them: 5 would be passed by 1 in 5000 instead of 1 in 3.5 million.
 */
static inline double chi_square_z(const uint32_t *counts, int cells, double total)
{
    const double dof = cells - 1;
    const double spread = 2.0 / (9.0 * dof);
    return (cbrt(chi_square(counts, cells, total) / dof) - (1.0 - spread)) / sqrt(spread);
}

/* How far a table of 16 x 16 is from independence: Cramer's V, from 0 to 1. */
static inline double cramers_v(const uint32_t *counts, double total)
{
    return sqrt(chi_square(counts, 256, total) / (total * 15.0));
}

/* The correlation of n pairs as z (two-sided: its magnitude). Numbers that are all the same count
   as correlated. */
static inline double correlation_z(const float *a, const float *b, int n)
{
    double sa = 0.0, sb = 0.0, saa = 0.0, sbb = 0.0, sab = 0.0;
    for (int i = 0; i < n; i++) {
        const double x = (double)a[i], y = (double)b[i];
        sa += x;
        sb += y;
        saa += x * x;
        sbb += y * y;
        sab += x * y;
    }
    const double covariance = sab - sa * sb / n;
    const double variances = (saa - sa * sa / n) * (sbb - sb * sb / n);
    return (variances > 0.0 ? fabs(covariance) / sqrt(variances) : 1.0) * sqrt((double)n);
}

#endif
