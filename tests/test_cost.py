# SPDX-License-Identifier: MIT
"""Instructions per point or grid sample, counted with callgrind, against the figures committed in cost.txt.

    test_cost.py PROGRAM COST_FILE SCRATCH_DIR PROCESSOR COMPILER BUILD_TYPE FLAGS
        check
    test_cost.py --print PROGRAM COST_FILE SCRATCH_DIR
        the figures as they are

Counts are exact for one compiler and one set of flags, so only builds like the one that the file was
made with are checked; others are skipped, and say so.
"""
import os
import re
import subprocess
import sys

SLACK = 1.03
SKIPPED = 77
# Valgrind hides AVX-512, whichever sets have to be tested here.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "SCARP_REQUIRE_ISAS"}


def instructions_per_point(program, words, scratch):
    """Instructions that the public sample or grid call executes for one point."""
    out = os.path.join(scratch, "callgrind.out")
    run = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=" + out,
                          "--toggle-collect=scarp_sample*", "--toggle-collect=scarp_grid*", program]
                         + words, env=ENVIRONMENT,
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if run.returncode == SKIPPED:
        return None
    collected = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or collected is None or int(collected.group(1)) == 0:
        sys.exit("callgrind failed on " + " ".join(words) + ":\n" + run.stdout + run.stderr)
    return int(collected.group(1)) / int(run.stdout)


def read_costs(path):
    """Lines `isa call basis outputs fractal octaves figure`; # begins a comment."""
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split("#")[0].split()
            if words:
                yield words[:6], float(words[6])


def skip(reason):
    print("skipped:", reason)
    sys.exit(SKIPPED)


def main():
    if sys.argv[1] == "--print":
        program, costs, scratch = sys.argv[2:]
        for words, _ in read_costs(costs):
            print(*words, "%.2f" % instructions_per_point(program, words, scratch))
        return
    program, costs, scratch, processor, compiler, build_type, flags = sys.argv[1:]
    if (processor not in ("processor: x86_64", "processor: AMD64")
            or not compiler.startswith("GNU 12.") or build_type != "build type: Release"
            or flags.strip() != "flags:"):
        skip("the figures are those of x86-64, gcc 12, Release, without further flags; this is "
             "%s, %s, %s, %s" % (processor, compiler, build_type, flags))
    worse = counted = 0
    for words, figure in read_costs(costs):
        measured = instructions_per_point(program, words, scratch)
        if measured is None:
            print("%-40s skipped: cannot run here" % " ".join(words))
            continue
        counted += 1
        verdict = "worse" if measured > figure * SLACK else "better" if measured < figure / SLACK else ""
        worse += verdict == "worse"
        print("%-40s %8.2f, committed %8.2f %s" % (" ".join(words), measured, figure, verdict))
    if counted == 0:
        sys.exit("nothing was counted")
    if worse:
        sys.exit("%d workloads take more instructions than committed" % worse)


if __name__ == "__main__":
    main()
