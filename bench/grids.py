#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares grids with the same samples as points: reads what scarp-bench --work '*step0.05' --json wrote.

    python3 grids.py FILE [LEAST]

Prints each grid that has less than LEAST (0.93) of the speed of its points, by the fastest of the repeats, and the
slowest grid of each kernel set. Exits with 1 if there is one below LEAST."""

import json
import sys

if len(sys.argv) not in (2, 3):
    sys.exit(__doc__)
with open(sys.argv[1], encoding="utf-8") as file:
    rows = json.load(file)["rows"]
least = float(sys.argv[2]) if len(sys.argv) == 3 else 0.93
times = {(row["isa"], row["work"]): row["fastest_ns_per_point"] for row in rows if row["library"] == "scarp"}
slowest, below = {}, []
for (isa, work), points in times.items():
    grid = times.get((isa, work.replace("/as-points", "")))
    if "/as-points" in work and grid:
        found = (points / grid, isa, work.replace("/as-points", ""), points, grid)
        slowest[isa] = min(slowest.get(isa, found), found)
        below += [found] if found[0] < least else []
if not slowest:
    sys.exit("there are no grids with their points in " + sys.argv[1])
for title, list_ in (("below %g of their points" % least, sorted(below)), ("slowest", sorted(slowest.values()))):
    print("%s: %d" % (title, len(list_)))
    for speed, isa, work, points, grid in list_:
        print("  %.2f  %-8s %-50s points %.3f ns, grid %.3f ns" % (speed, isa, work, points, grid))
sys.exit(1 if below else 0)
