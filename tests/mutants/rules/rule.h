/* SPDX-License-Identifier: MIT
 *
 * The switch of mutations by rule. rules.py has this included before every source. It includes
 * nothing, since sources define what they want of the system's headers.
 */
#ifndef SCARP_TESTS_RULE_H
#define SCARP_TESTS_RULE_H

/* The number of the mutation that is switched on, 0: none; and which ones were met by control. */
extern __attribute__((visibility("hidden"))) int scarp_rule;
extern __attribute__((visibility("hidden"))) int *scarp_rule_met;

static inline __attribute__((always_inline, unused)) int scarp_rule_is(int number)
{
    scarp_rule_met[number] = 1;
    return scarp_rule == number;
}

#endif
