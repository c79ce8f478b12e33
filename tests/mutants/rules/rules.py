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
tries the survivors of the last run once more, after a test was added or an explanation; --sanitize finds
those that only touch memory that is not theirs.
`SCARP_RULE=17 DIR/build/bin/test_bits avx2` tries the mutation of the last run that has the number 17.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import random
import sys
import time

from build import HERE, RULES, Mutation, Work, list_mutations, parse, read_sources
from explained import ambiguous, key_of, keys_of, read_explained, reason_of
from tests import QUICK, default_tests, first_to_notice, processor_seconds, quick_tests, useful

# What became of a mutation. `stage` is that of `test`, which noticed it, or "none"; `ended` says how, or
# "survived", or "not met" if no test comes by.
Verdict = collections.namedtuple("Verdict", "number mutation stage test ended seconds")


class Judge:
    """Runs tests on mutations, stage after stage, and writes a line of each to `results` once it is known
    what becomes of it. After `end` nothing begins."""

    def __init__(self, stages, results, jobs, end):
        self.stages, self.results, self.jobs, self.end = stages, results, jobs, end

    def judge(self, stage, tests, number, mutation):
        """The verdict of a stage; None: no test notices the mutation, and there is another stage."""
        began = time.monotonic()
        test, ended = first_to_notice(tests, number, mutation.file.split("/")[0])
        if test is None:
            if stage != self.stages[-1][0]:
                return None
            is_met = any(t.meets(number) for _, others in self.stages for t in others)
            stage, test, ended = "none", "-", "survived" if is_met else "not met"
        verdict = Verdict(number, mutation, stage, test, ended, round(time.monotonic() - began, 1))
        write_verdict(verdict, self.results)
        return verdict

    def judge_all(self, mutations):
        """The verdicts of {number: mutation}."""
        verdicts, left = [], dict(mutations)
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for stage, tests in self.stages:
                def judge_one(number):
                    return self.judge(stage, tests, number, left[number]) if time.monotonic() < self.end else None
                found = [v for v in pool.map(judge_one, list(left)) if v is not None]
                verdicts += found
                for verdict in found:
                    del left[verdict.number]
        if left:
            print("%d mutations are not judged, since the time is over" % len(left))
        return verdicts


def write_verdict(verdict, results):
    line = dict(verdict._asdict(), mutation=verdict.mutation._asdict())
    print(json.dumps(line), file=results, flush=True)


def read_verdicts(path):
    """The verdicts of the last run, in the order in which they were found."""
    with open(path, encoding="utf-8") as file:
        lines = [json.loads(line) for line in file]
    return [Verdict(**dict(line, mutation=Mutation(**line["mutation"]))) for line in lines]


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
        print("STALE, it fits no line: %s: %s%s: %s ==> %s" % shown(key))
    unclear = ambiguous(reasons, mutations)
    for key in unclear:
        print("UNCLEAR, it fits several functions, and names none: %s: %s%s: %s ==> %s" % shown(key))
    return len(stale) + len(unclear)


def shown(key):
    file, function, *rest = key
    return file, function and function + ": ", *rest


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--work", default="rules-work", help="directory that keeps builds")
    parser.add_argument("--sample", type=int, default=500, help="so many mutations; 0: all")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--files", nargs="+", default=["*"], help="patterns of files below src/")
    parser.add_argument("--again", action="store_true", help="those that survived the last run")
    parser.add_argument("--resume", action="store_true", help="go on where the last run ended")
    parser.add_argument("--jobs", type=int, default=1, help="so many tests at a time")
    parser.add_argument("--sanitize", action="store_true", help="compile with AddressSanitizer and UBSan")
    parser.add_argument("--tests", metavar="REGEX", help="only default tests of these names")
    parser.add_argument("--thorough", action="store_true", help="thorough ones, and the program, too")
    parser.add_argument("--no-default", action="store_true", help="leave the default tests out")
    parser.add_argument("--minutes", type=float, default=1e9, help="begin with no mutation later")
    parser.add_argument("--stale", action="store_true", help="only check that explanations fit a line each")
    parser.add_argument("--set", default="avx2", help="the vector set")
    parser.add_argument("--patience", type=int, default=5, help="seconds of the processor for a quick test")
    parser.add_argument("--quick", nargs="+", help="quick tests in place of those of tests.py")
    parser.add_argument("--explained", default=os.path.join(HERE, "explained.txt"))
    parser.add_argument("--project", default=os.path.dirname(os.path.dirname(os.path.dirname(HERE))))
    return parser.parse_args()


def draw_mutations(work, arguments, last):
    """All that may be tried, in the order in which it is."""
    mutations = list_mutations(work.parsed, arguments.files)
    if arguments.again:
        survivors = {key_of(v.mutation) for v in last if v.stage == "none"}
        mutations = [m for m in mutations if key_of(m) in survivors]
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
    if arguments.stale:
        parsed = parse(read_sources(arguments.project))
        sys.exit(report_stale(reasons, list_mutations(parsed, ["*"])) > 0)
    work = Work(os.path.abspath(arguments.work), os.path.abspath(arguments.project), arguments.set,
                arguments.sanitize, arguments.thorough)
    path = os.path.join(work.folder, "results")
    last = read_verdicts(path) if arguments.again or arguments.resume else []
    draw = draw_mutations(work, arguments, last)
    chosen, dropped = work.compile(draw, len(draw) if arguments.again else arguments.sample or len(draw))
    quick = list(quick_tests(work, arguments.quick or QUICK))
    work.make_tests([] if arguments.no_default else ["all"], [t.program for t in quick])
    print("%d are tried, seed %d; %d more were drawn and do not compile; %.0f s to here" % (
        len(chosen), arguments.seed, dropped, time.monotonic() - began), flush=True)
    stages = [("quick", useful(quick, work, arguments.patience))]
    if not arguments.no_default:
        stages.append(("default", useful(list(default_tests(work, arguments.tests)), work, 2 * arguments.patience)))
    print("; ".join("%d %s tests take %.1f s" % (len(tests), stage, sum(t.seconds for t in tests))
                    for stage, tests in stages) + "; %.0f s to here" % (time.monotonic() - began), flush=True)
    kept = last if arguments.resume else [v for v in last if v.stage != "none"]
    known = {key_of(v.mutation) for v in kept}
    with open(path, "w", encoding="utf-8") as results:
        for verdict in kept:
            write_verdict(verdict, results)
        judge = Judge(stages, results, arguments.jobs, began + 60 * arguments.minutes)
        verdicts = judge.judge_all({n: m for n, m in chosen.items() if key_of(m) not in known})
    finish(kept + verdicts, reasons, list_mutations(work.parsed, ["*"]), began)


def finish(verdicts, reasons, mutations, began):
    """Reports all verdicts, and exits."""
    unexplained = report(verdicts, reasons)
    stale = report_stale(reasons, mutations)
    stages = collections.Counter(v.stage for v in verdicts)
    print("\n%d mutations: %d noticed by quick tests, %d by default tests, %d survived, of which %d are not "
          "explained; %d explanations fit nothing, or too much; %.0f s, %.0f s of processors" % (
              len(verdicts), stages["quick"], stages["default"], stages["none"], unexplained, stale,
              time.monotonic() - began, processor_seconds()))
    sys.exit(1 if unexplained or stale else 0)


if __name__ == "__main__":
    main()
