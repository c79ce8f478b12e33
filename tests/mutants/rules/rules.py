# SPDX-License-Identifier: MIT
"""Mutations by rule: what do the tests not notice?

    rules.py [--work DIR] [--sample N] [--seed S] [--files PATTERN...] [--no-default] [--again] ...

draws N mutations of all that sites.py finds in the library's sources, or in those that are named (below
src/, as kernel/basis/fade.h or 'recipe/*'). It compiles a copy of the project with all of them inside, each
behind a switch, and runs tests with one after the other switched on:

    1. bits, golden, chain, grid, recipe and other tests of one vector set and of the reference, with few
       points, which stop at the first difference and have 5 seconds each
    2. whatever these do not notice meets the default tests

A test runs only if it comes by the mutation. Tests that notice most in least time come first. A mutation
that makes a test endless, or crash, is noticed. One that nothing notices is a *survivor*: either a test is
missing, or no result is wrong, and explained.txt says why. The exit status is 1 if a survivor is not
explained, or if an explanation fits no line any more.

DIR keeps the copy, its build, and `results`, a line per mutation, which grows while tests run. --again
tries the survivors of the last run once more, after a test was added or an explanation.
`SCARP_RULE=17 DIR/build/bin/test_bits avx2` tries the mutation of the last run that has the number 17.
"""
import argparse
import collections
import json
import os
import random
import sys
import time

from build import HERE, RULES, Work, list_mutations
from explained import keys_of, read_explained, reason_of
from tests import QUICK, default_tests, first_to_notice, quick_tests, useful

# What became of a mutation. `stage` is that of `test`, which noticed it, or "none"; `ended` tells how, or
# "survived", or "not met" if no test comes by.
Verdict = collections.namedtuple("Verdict", "number mutation stage test ended seconds")


def judge(number, mutation, quick, default):
    began = time.monotonic()
    room = mutation.file.split("/")[0]
    for stage, tests in (("quick", quick), ("default", default)):
        test, ended = first_to_notice(tests, number, room)
        if test is not None:
            break
    else:
        met = any(t.meets(number) for t in quick + default)
        stage, test, ended = "none", "-", "survived" if met else "not met"
    return Verdict(number, mutation, stage, test, ended, round(time.monotonic() - began, 1))


def judge_all(chosen, quick, default, results, minutes):
    """Runs tests on the mutations, until the time is over, and writes a line of each to `results`."""
    end = time.monotonic() + 60 * minutes
    verdicts = []
    for number, mutation in chosen.items():
        if time.monotonic() > end:
            print("%d mutations are left out, since the time is over" % (len(chosen) - len(verdicts)))
            break
        verdict = judge(number, mutation, quick, default)
        verdicts.append(verdict)
        write_verdict(verdict, results)
    return verdicts


def write_verdict(verdict, results):
    line = dict(verdict._asdict(), mutation=verdict.mutation._asdict())
    print(json.dumps(line), file=results, flush=True)


def read_verdicts(path):
    with open(path, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def is_of(mutation, lines):
    """Whether the mutation is in lines of `results`, wherever in its file it stands now."""
    return any(all(line["mutation"][key] == getattr(mutation, key)
                   for key in ("file", "source", "before", "after")) for line in lines)


def report(verdicts, reasons):
    """Prints what became of the mutations. Returns how many survived without an explanation."""
    tests = collections.Counter((v.stage, v.test) for v in verdicts if v.stage != "none")
    ends = collections.Counter(v.ended for v in verdicts)
    print("\nnoticed by")
    for (stage, test), count in tests.most_common():
        print("  %4d  %s (%s)" % (count, test, stage))
    print("of these, %d crashed and %d hung\n" % (ends["crashed"], ends["hung"]))
    unexplained = 0
    for v in verdicts:
        if v.stage == "none":
            m, reason = v.mutation, reason_of(v.mutation, reasons)
            unexplained += reason is None
            print("%s %d, %s\n    src/%s:%d: %s\n    %s ==> %s" % (
                "SURVIVOR" if reason is None else "explained", v.number, v.ended, m.file, m.line, m.source,
                m.before, m.after) + ("\n    " + reason if reason else ""))
    return unexplained


def report_stale(reasons, mutations):
    known = {key for m in mutations for key in keys_of(m)}
    stale = [key for key in reasons if key not in known]
    for key in stale:
        print("STALE, it fits no line: %s: %s: %s ==> %s" % key)
    return len(stale)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--work", default="rules-work", help="directory that keeps builds")
    parser.add_argument("--sample", type=int, default=500, help="so many mutations; 0: all")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--files", nargs="+", default=["*"], help="patterns of files below src/")
    parser.add_argument("--again", action="store_true", help="those that survived the last run")
    parser.add_argument("--no-default", action="store_true", help="leave the default tests out")
    parser.add_argument("--minutes", type=float, default=1e9, help="begin with no mutation later")
    parser.add_argument("--set", default="avx2", help="the vector set")
    parser.add_argument("--patience", type=int, default=5, help="seconds of the processor for a quick test")
    parser.add_argument("--quick", nargs="+", help="quick tests in place of those of tests.py")
    parser.add_argument("--explained", default=os.path.join(HERE, "explained.txt"))
    parser.add_argument("--project", default=os.path.dirname(os.path.dirname(os.path.dirname(HERE))))
    return parser.parse_args()


def draw_mutations(work, arguments, last):
    """All that may be tried, in the order in which it is."""
    mutations = list_mutations(work, arguments.files)
    if arguments.again:
        mutations = [m for m in mutations if is_of(m, [line for line in last if line["stage"] == "none"])]
    if not mutations or len(mutations) >= RULES:
        sys.exit("%d mutations in these files" % len(mutations))
    compiled = work.compiled(mutations)
    print("%d mutations, of which %d are compiled for %s and scalar; %d numbers and operators are outside of "
          "functions, or constant" % (len(mutations), len(compiled), work.set, work.left_out(mutations)))
    random.Random(arguments.seed).shuffle(compiled)
    return compiled


def main():
    arguments = parse_arguments()
    began = time.monotonic()
    reasons = read_explained(arguments.explained)
    work = Work(os.path.abspath(arguments.work), os.path.abspath(arguments.project), arguments.set)
    path = os.path.join(work.folder, "results")
    last = read_verdicts(path) if arguments.again else []
    draw = draw_mutations(work, arguments, last)
    chosen, dropped = work.compile(draw, len(draw) if arguments.again else arguments.sample or len(draw))
    quick = list(quick_tests(work, arguments.quick or QUICK, arguments.patience))
    work.make_tests([] if arguments.no_default else ["all"], [t.program for t in quick])
    print("%d are tried, seed %d; %d more were drawn and do not compile; %.0f s to here" % (
        len(chosen), arguments.seed, dropped, time.monotonic() - began), flush=True)
    quick = useful(quick, work, arguments.patience)
    default = [] if arguments.no_default else useful(default_tests(work), work, 10)
    print("%d quick tests take %.1f s, %d default tests %.1f s; %.0f s to here" % (
        len(quick), sum(t.seconds for t in quick), len(default), sum(t.seconds for t in default),
        time.monotonic() - began), flush=True)
    with open(path, "w", encoding="utf-8") as results:
        for line in last:
            if line["stage"] != "none":
                print(json.dumps(line), file=results)
        verdicts = judge_all(chosen, quick, default, results, arguments.minutes)
    unexplained = report(verdicts, reasons)
    stale = report_stale(reasons, list_mutations(work, ["*"]))
    stages = collections.Counter(v.stage for v in verdicts)
    print("\n%d mutations: %d noticed by quick tests, %d by default tests, %d survived, of which %d are not "
          "explained; %d explanations fit nothing; %.0f s" % (
              len(verdicts), stages["quick"], stages["default"], stages["none"], unexplained, stale,
              time.monotonic() - began))
    sys.exit(1 if unexplained or stale else 0)


if __name__ == "__main__":
    main()
