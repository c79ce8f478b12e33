#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares recipes with the same work by hand: reads what these wrote:

    scarp-bench --work 'recipe*' --peers --scratch 0,32768,65536,262144,1048576 --json FILE
    python3 recipes.py FILE...

Prints a table for each kernel set, by the fastest of the repeats: the nanoseconds per point by hand and in which way, the
speed of the recipe over it with the best size of scratch memory and with the others, and over FastNoise2."""

import json
import sys

if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
    sys.exit(__doc__)
times, ways, works, sizes, isas = {}, {}, [], set(), []
for name in sys.argv[1:]:
    with open(name, encoding="utf-8") as file:
        for row in json.load(file)["rows"]:
            work, _, size = row["work"].partition("/scratch=")
            if not work.startswith("recipe"):
                continue
            size = int(size) if size else None
            library = row["library"].partition("-")[0]
            times.setdefault((work, row["isa"], library, size), row["fastest_ns_per_point"])
            if "way" in row:
                ways.setdefault((work, row["isa"]), row["way"])
            works += [work] * (work not in works)
            isas += [row["isa"]] * (row["isa"] not in isas)
            sizes.update({size} - {None})
sizes = [None, *sorted(sizes)]


def ratio(slower, faster):
    return "%.2f" % (slower / faster) if slower and faster else ""


for isa in isas:
    print("\n| %s | by hand, ns | way | best | %sover FastNoise2 |" % (
        isa, "".join("%d | " % size for size in sizes[1:])))
    print("|---|---:|---|" + "---:|" * (len(sizes) + 1))
    for work in works:
        hand = times.get((work, isa, "by hand", None))
        recipe = times.get((work, isa, "scarp", None))
        if hand and recipe:
            cells = [work, "%.3f" % hand, ways[work, isa]]
            cells += [ratio(hand, times.get((work, isa, "scarp", size))) for size in sizes]
            cells.append(ratio(times.get((work, isa, "FastNoise2", None)), recipe))
            print("| %s |" % " | ".join(cells))
