# SPDX-License-Identifier: MIT
"""The program scarp-bench, from outside.

    test_bench.py GROUP PROGRAM...      one of the classes below

PROGRAM may begin with an emulator. Nothing here depends on how fast anything is.
"""
import fnmatch
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "cli"))
import common
from common import main, pty

OPTIONS = ("work", "isa", "peers", "min-time", "repeat", "scratch", "json", "svg", "markdown", "from", "list",
           "quiet", "help")
FLAGS = ("peers", "markdown", "list", "quiet", "help")
ISAS = ["scalar", "sse4.1", "avx2", "avx512", "neon", "generic", "wasm128"]
# The least that can be measured
QUICK = ["--min-time", "0.001", "--repeat", "1"]
ONE = [*QUICK, "--work", "points2/gradient/value"]
# Grids that take long in instrumented builds, and one that is measured only by its whole name
LARGE = re.compile(r"grid2/.*/(4096|16384)/|grid3/.*/256/")
ON_REQUEST = "grid2/gradient/value/16384/step0.01"
BASES = ("gradient", "value", "simplex", "cell-f1", "cell-f2", "cell-edge", "cell-soft",
         "cell-value")
SHAPES = {"2": ("17", "33", "65", "129"),
          "3": ("16", "17", "18", "34", "31x32x32", "40x32x32", "5x33x5", "16x256x16", "256x16x16")}
SVG = "{http://www.w3.org/2000/svg}"


def run(*arguments, **more):
    return common.run(*arguments, timeout=600, **more)


def text_of(*arguments):
    """Standard output of a run that must succeed in silence on stderr."""
    result = run(*arguments, "--quiet")  # a slow machine would say how far it is
    assert result.returncode == 0 and result.stderr == b"", (arguments, result)
    return result.stdout.decode()


def report_of(*arguments):
    return json.loads(text_of(*arguments, "--json", "-"))


def names_of(*arguments):
    return text_of("--list", *arguments).splitlines()


def samples_of(name):
    """The samples of a grid, None of other workloads"""
    grid = re.match(r"grid(\d)/.*/([\dx]+)(/as-points)?/step[\d.]+$", name)
    if grid is None:
        grid = re.match(r"recipe-grid(\d)/.*?/([\dx]+)(/scratch=\d+)?$", name)
    if grid is None:
        assert "grid" not in name.split("/")[0], name
        return None
    edges = [int(edge) for edge in grid.group(2).split("x")]
    return math.prod(edges * int(grid.group(1)) if len(edges) == 1 else edges)


def has_peers():
    """Whether there is another library. "plain C", which draws gullies alone, is none."""
    result = run(*QUICK, "--work", "points3/gradient/value", "--peers", "--json", "-")
    return result.returncode == 0 and any(row["library"] != "scarp"
                                          for row in json.loads(result.stdout)["rows"])


class Case(common.Case):
    @classmethod
    def setUpClass(cls):
        """The program has no formats to ask for."""

    def check_rows(self, rows):
        for row in rows:
            with self.subTest(row=row):
                self.assertTrue(1e-3 < row["ns_per_point"] < 1e7)
                self.assertTrue(0 < row["fastest_ns_per_point"] <= row["ns_per_point"] * 1.00001)
                self.assertAlmostEqual(row["mpoints_per_s"] * row["ns_per_point"] / 1000, 1, 4)
                self.assertGreaterEqual(row["spread"], 0)
                size = re.search(r"/n=(\d+)(/scratch=\d+)?$", row["work"])
                self.assertEqual(row["points"], samples_of(row["work"]) or
                                 (int(size.group(1)) if size else 65536))


class Selection(Case):
    """Which workloads and instruction sets are chosen."""

    def test_help(self):
        text = text_of("--help")
        for name in OPTIONS:
            self.assertRegex(text, r"(?m)^  --%s\b" % name)
        self.assertLessEqual(max(len(line) for line in text.splitlines()), 100)
        self.assertEqual(text_of("-h"), text)

    def test_list(self):
        names = names_of()
        self.assertEqual(len(names), len(set(names)))
        for d in "23":
            for basis in ("gradient", "value"):
                for output in ("value", "+gradient", "+hessian", "forward-differences",
                               "central-differences"):
                    self.assertIn("points%s/%s/%s" % (d, basis, output), names)
                self.assertIn("points%s/%s/fbm8/+hessian" % (d, basis), names)
            for kind in ("fbm8/turned", "cubic", "f64", "sequential", "same-cell"):
                self.assertIn("points%s/gradient/%s/+gradient" % (d, kind), names)
            for points in (1, 4, 16, 64, 256, 4096, 1048576):
                self.assertIn("points%s/gradient/value/n=%d" % (d, points), names)
            for output in ("value", "+gradient", "+hessian"):
                for fractal in ("turbulence8", "ridged8"):
                    self.assertIn("points%s/gradient/%s/%s" % (d, fractal, output), names)
            for output in ("value", "+gradient", "forward-differences", "central-differences"):
                self.assertIn("points%s/gradient/erosion8/%s" % (d, output), names)
            sizes = {"2": (256, 1024, 4096), "3": (64, 256)}[d]
            for output in ("value", "+gradient"):
                for size in sizes:
                    self.assertIn("grid%s/gradient/%s/%d/step0.01" % (d, output, size), names)
                for kind in ("gradient/fbm8", "gradient/fbm8/turned", "value"):
                    self.assertIn("grid%s/%s/%s/%d/step0.01" % (d, kind, output, sizes[-2]), names)
                for fractal in ("ridged8", "erosion8"):
                    self.assertIn("grid2/gradient/%s/%s/1024/step0.01" % (fractal, output), names)
            for step in ("0.1", "0.3", "1.7"):
                size = {"2": 1024, "3": 256}[d]
                self.assertIn("grid%s/gradient/value/%d/step%s" % (d, size, step), names)
        for basis in ("gradient", "value"):
            self.assertIn("points2/%s/erosion8/turned/+gradient" % basis, names)
        self.assertFalse([name for name in names if "erosion" in name and "hessian" in name])
        self.assertIn("normals", names)
        for noise in ("fbm9/terrain-fbm/%s/1024/step0.0025",
                      "ridged7/turned/terrain-ridged/%s/1024/step0.0035",
                      "ridged2/turned/terrain-waves/%s/1024/step0.0022",
                      "erosion8/turned/terrain-erosion/%s/1024/step0.0045",
                      "turbulence8/turned/terrain-turbulence/%s/1024/step0.004",
                      "swiss8/turned/terrain-swiss/%s/1024/step0.0045"):
            for output in ("value", "+gradient"):
                self.assertIn("grid2/gradient/" + noise % output, names)
        for noise in ("cell-soft/erosion8/turned/terrain-soft/%s/1024/step0.004",
                      "cell-f1/fbm8/turned/terrain-cells/%s/1024/step0.0045"):
            for output in ("value", "+gradient"):
                self.assertIn("grid2/" + noise % output, names)
        self.assertIn("grid2/gradient/fbm3/quick-noise/value/1024/step0.0078125", names)
        for title in ("fade", "alps", "overworld", "marble"):
            self.assertIn("recipe-grid2/%s/value/512" % title, names)
        for scaled in ("", "scaled-"):
            for output in ("value", "+gradient"):
                for row in ("2/%snoise1/%s/256", "2/%snoise4/%s/1024", "3/%snoise1/%s/256x16x16",
                            "3/%swarped/%s/32"):
                    self.assertIn("recipe-grid" + row % (scaled, output), names)
        for shape in ("32", "16x16x256", "256x16x16"):
            self.assertIn("recipe-grid3/density/+gradient/" + shape, names)
        for points in (1, 4, 16, 64, 4096):
            self.assertIn("recipe2/alps/f64/value/n=%d" % points, names)
            self.assertIn("recipe3/density/f64/value/n=%d" % points, names)
        for basis in BASES:
            for kind in ("", "/fbm4", "/fbm4/turned"):
                for output in ("value", "+gradient"):
                    for d, shapes in SHAPES.items():
                        for shape in shapes:
                            name = "grid%s/%s%s/%s/%s" % (d, basis, kind, output, shape)
                            self.assertIn(name + "/step0.05", names)
                            self.assertIn(name + "/as-points/step0.05", names)

    def test_patterns(self):
        names = names_of()
        for pattern in ("points2/*", "points?/gradient/value", "*", "*fbm8*value", "*/n=16",
                        "points?/*/+*", "*/*/*/*", "normal?"):
            self.assertEqual(names_of("--work", pattern),
                             [name for name in names if fnmatch.fnmatchcase(name, pattern)])
        self.assertEqual(names_of("--work", "points2/gradient/value"), ["points2/gradient/value"])
        self.assertEqual(names_of("--work=fbm8"), [name for name in names if "fbm8" in name])
        self.assertEqual(names_of("--work", "normals,points3/value/value"),
                         ["points3/value/value", "normals"])

    def test_on_request(self):
        """A grid of 1 GB is listed like all others, but no pattern starts it."""
        self.assertIn(ON_REQUEST, names_of())
        self.assertEqual(names_of("--work", ON_REQUEST), [ON_REQUEST])
        self.check_one_line(run(*QUICK, "--work", "16384"), 2, "--work")
        rows = report_of(*QUICK, "--isa", "scalar", "--work", "grid2/gradient/value/1*/step0.01")
        self.assertEqual([row["work"] for row in rows["rows"]],
                         ["grid2/gradient/value/1024/step0.01"])

    def test_shapes(self):
        """Grids of many shapes, and the same samples as points"""
        name = "grid3/simplex/value/5x33x5%s/step0.05"
        rows = report_of(*QUICK, "--isa", "scalar", "--work", "grid3/simplex/value/5x*")["rows"]
        self.assertEqual([(row["work"], row["points"]) for row in rows],
                         [(name % "", 825), (name % "/as-points", 825)])

    def test_grids(self):
        """grids.py compares them."""
        def grids(grid, points):
            rows = [{"work": "a%s/step0.05" % text, "isa": "avx2", "library": "scarp", "fastest_ns_per_point": time}
                    for text, time in (("", grid), ("/as-points", points))]
            script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench", "grids.py")
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "rows.json")
                with open(path, "w", encoding="utf-8") as file:
                    json.dump({"rows": rows}, file)
                return subprocess.run([sys.executable, script, path], stdout=subprocess.PIPE, text=True)
        slow, fast = grids(2.0, 1.8), grids(2.0, 1.9)
        self.assertEqual((slow.returncode, fast.returncode), (1, 0))
        self.assertRegex(slow.stdout, r"below 0.93 of their points: 1\n  0.90  avx2 +a/step0.05 ")
        self.assertRegex(fast.stdout, r"below 0.93 of their points: 0\nslowest: 1\n  0.95  avx2 ")

    def test_isas(self):
        report = report_of(*ONE)
        isas = report["isas"].split()
        self.assertEqual(isas, [isa for isa in ISAS if isa in isas])
        self.assertEqual(isas[0], "scalar")
        self.assertEqual([row["isa"] for row in report["rows"]], isas)
        for isa in isas:
            self.assertEqual([row["isa"] for row in report_of(*ONE, "--isa", isa)["rows"]], [isa])
        listed = report_of(*ONE, "--isa", isas[-1] + ",scalar")["rows"]
        self.assertEqual({row["isa"] for row in listed}, {isas[-1], "scalar"})

    def test_required_isas(self):
        """A list that the environment gives must not be shortened in silence."""
        isas = report_of(*ONE)["isas"].split()
        for isa in filter(None, os.environ.get("SCARP_REQUIRE_ISAS", "").split(",")):
            self.assertIn(isa, isas)


class Results(Case):
    """What is measured and how it is told."""

    def test_json(self):
        report = report_of(*ONE)
        for key in ("version", "date", "cpu", "isas", "compiler", "flags"):
            self.assertTrue(report[key].strip() or key == "flags", key)
        self.assertRegex(report["version"], r"\A\d+\.\d+\.\d+\Z")
        self.assertRegex(report["date"], r"\A\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ\Z")
        self.assertEqual((report["min_time"], report["repeat"]), (0.001, 1))
        self.check_rows(report["rows"])
        for row in report["rows"]:
            self.assertEqual((row["library"], row["spread"]), ("scarp", 0))
            self.assertNotIn("note", row)

    def test_files(self):
        text = text_of(*ONE, "--repeat", "3", "--json", self.path("a.json"), "--svg",
                       self.path("a.svg"))
        self.assertEqual(self.files(), ["a.json", "a.svg"])
        with open(self.path("a.json")) as file:
            report = json.load(file)
        self.check_rows(report["rows"])
        shown = re.findall(r"^points2/gradient/value +scarp +(\S+) +(\S+) +(\S+)", text, re.M)
        self.assertEqual([row[0] for row in shown], report["isas"].split())
        for (_, time, _), row in zip(shown, report["rows"]):
            self.assertAlmostEqual(float(time), row["ns_per_point"], 2)

    def test_differences(self):
        self.check_differences("points2/gradient/")

    @unittest.skipIf(sys.argv[3:], "emulated processors are about 100 times slower")
    def test_differences_of_erosion(self):
        self.check_differences("points2/gradient/erosion8/")
        self.check_differences("points3/gradient/erosion8/")

    def check_differences(self, stem):
        work = ",".join(stem + name for name in ("+gradient", "forward-differences",
                                                 "central-differences"))
        report = report_of(*QUICK, "--isa", "scalar", "--work", work, "--repeat", "3")
        self.check_rows(report["rows"])
        self.assertEqual([row.get("note") for row in report["rows"]],
                         [None, "forward differences", "central differences"])
        with open(self.path("a.json"), "w") as file:
            json.dump(report, file)
        ratios = dict(re.findall(r"^(\S+) +scarp +scalar +([\d.]+) times faster$",
                                 text_of("--from", self.path("a.json")), re.M))
        exact = report["rows"][0]["ns_per_point"]
        self.assertEqual(len(ratios), 2)
        for row in report["rows"][1:]:
            self.assertAlmostEqual(float(ratios[row["work"]]), row["ns_per_point"] / exact, 1)

    def test_markdown(self):
        text = text_of(*QUICK, "--work", "points2/gradient/value,normals", "--markdown", "--json",
                       self.path("a.json"))
        with open(self.path("a.json")) as file:
            report = json.load(file)
        table = [[cell.strip() for cell in line.strip("|").split("|")]
                 for line in text.splitlines() if line.startswith("|")]
        isas = report["isas"].split()
        self.assertEqual(table[0][1:], ["scarp " + isa for isa in isas])
        self.assertEqual(table[1], ["---"] + ["---:"] * len(isas))
        self.assertEqual([line[0] for line in table[2:]], ["points2/gradient/value", "normals"])
        for line in table[2:]:
            rates = [row["mpoints_per_s"] for row in report["rows"] if row["work"] == line[0]]
            for cell, rate in zip(line[1:], rates, strict=True):
                self.assertLess(abs(float(cell) - rate), 0.51)
        for word in (report["cpu"], report["compiler"], report["version"]):
            self.assertIn(word, text)

    def write_report(self, name, rows, **header):
        with open(self.path(name), "w") as file:
            json.dump({"version": "1.2.3", "date": "2001-02-03T04:05:06Z", "cpu": "a <b> & \"c\"",
                       "isas": "scalar avx2", "compiler": "cc", "flags": "-O2", "min_time": 1,
                       "repeat": 5, **header, "rows": rows}, file, indent=1)

    @staticmethod
    def row(work, isa, rate, library="scarp", **more):
        return {"work": work, "isa": isa, "library": library, "points": 65536,
                "ns_per_point": 1000 / rate, "mpoints_per_s": rate,
                "fastest_ns_per_point": 900 / rate, "spread": 0.25, **more}

    def test_chart(self):
        note = {"note": "central differences"}
        self.write_report("a.json", [
            self.row("points2/gradient/value", "scalar", 40), self.row("points2/gradient/value",
                                                                       "avx2", 800),
            self.row("points2/gradient/value", "avx2", 600, "other & <others>"),
            self.row("points2/gradient/+gradient", "avx2", 500),
            self.row("points2/gradient/central-differences", "avx2", 125, **note)])
        text_of("--from", self.path("a.json"), "--svg", self.path("a.svg"))
        root = ElementTree.parse(self.path("a.svg")).getroot()
        self.assertEqual((root.tag, root.get("width")), (SVG + "svg", "900"))
        texts = ["".join(text.itertext()) for text in root.iter(SVG + "text")]
        for word in ("points2/gradient/value", "points2/gradient/+gradient", "scarp scalar",
                     "other & <others> avx2", "800", "40.0", "600", "500", "125"):
            self.assertIn(word, texts)
        self.assertTrue(any("a <b> & \"c\", 2001-02-03" in text for text in texts))
        bars = [float(bar.get("width")) for bar in root.iter(SVG + "rect")
                if bar.get("height") == "13.0" and bar.get("fill") != "#fff"]
        self.assertEqual(len(bars), 5)
        for bar, part in zip(bars, (40 / 800, 1, 600 / 800, 1, 125 / 500)):
            self.assertAlmostEqual(bar / bars[1], part, 2)
        for rect in root.iter(SVG + "rect"):
            if not rect.get("width").endswith("%"):
                self.assertLessEqual(float(rect.get("x")) + float(rect.get("width")), 900)

    def test_from(self):
        """What is written can be read; of rows that two files have, the first counts."""
        first = [self.row("w/value", "avx2", 100), self.row("w/value", "scalar", 10)]
        second = [self.row("w/value", "avx2", 1),
                  self.row("v/value", "avx2", 5, "peer", note="n", way="w")]
        self.write_report("a.json", first)
        self.write_report("b.json", second, cpu="another")
        files = self.path("a.json") + "," + self.path("b.json")
        report = report_of("--from", files)
        self.assertEqual(report["rows"], first + second[1:])
        self.assertEqual((report["cpu"], report["repeat"]), ("a <b> & \"c\"", 5))
        self.assertEqual(report_of("--from", files, "--work", "v/*")["rows"], second[1:])
        self.assertEqual(report_of("--from", files, "--isa", "scalar")["rows"], first[1:])

    @unittest.skipUnless(pty, "needs POSIX")
    def test_progress(self):
        self.assertEqual(self.on_terminal(*ONE, "--quiet"), (0, ""))
        status, shown = self.on_terminal(*ONE)
        self.assertEqual(status, 0)
        self.assertRegex(shown, r"\rpass 1 of 1: +0 %, \d+ s left")
        self.assertRegex(shown, r"\r {50}\r\Z")

    def test_peers(self):
        if run("--list", "--peers").returncode != 0:
            self.check_one_line(run(*ONE, "--peers"), 2, "--peers")
        if not has_peers():
            self.skipTest("no peer was found")
        work = "points3/gradient/value,points3/gradient/+gradient"
        rows = report_of(*QUICK, "--work", work, "--peers")["rows"]
        self.check_rows(rows)
        self.assertGreater(len({row["library"] for row in rows}), 1)
        for row in rows:
            estimated = row["library"] != "scarp" and row["work"].endswith("+gradient")
            self.assertEqual(row.get("note"), "central differences" if estimated else None)

    def test_peers_of_fractals(self):
        if not has_peers():
            self.skipTest("no peer was found")
        works = ["points%s/gradient/%s8/value" % (d, fractal)
                 for d in "23" for fractal in ("fbm", "turbulence", "ridged", "erosion")]
        rows = report_of(*QUICK, "--work", ",".join(works), "--peers")["rows"]
        self.check_rows(rows)
        libraries = {work: {row["library"] for row in rows if row["work"] == work}
                     for work in works}
        self.assertEqual(libraries["points3/gradient/ridged8/value"],
                         libraries["points3/gradient/fbm8/value"])
        for d in "23":
            stem = "points%s/gradient/" % d
            self.assertEqual(libraries[stem + "erosion8/value"], {"scarp"})
            self.assertEqual(libraries[stem + "turbulence8/value"],
                             libraries[stem + "fbm8/value"] - {"FastNoiseLite"})

    def test_peers_of_grids(self):
        """Only FastNoise2 has grid calls, and no gradient."""
        if not has_peers():
            self.skipTest("no peer was found")
        rows = report_of(*QUICK, "--work", "grid2/gradient/*/256/*,grid3/value/*",
                         "--peers")["rows"]
        self.check_rows(rows)
        libraries = {row["library"] for row in rows}
        self.assertLessEqual(libraries, {"scarp", "FastNoise2", "FastNoise2-strict"})
        for row in rows:
            self.assertNotIn("note", row)
            self.assertTrue("/+" not in row["work"] or row["library"] == "scarp")


    def test_peers_of_presets(self):
        """All take part with the nearest that they have, and say what it is."""
        if not has_peers():
            self.skipTest("no peer was found")
        rows = report_of(*QUICK, "--isa", "scalar", "--work", "grid2/*/terrain-*,quick-noise,"
                         "points3/gradient/value", "--peers")["rows"]
        self.check_rows(rows)
        everyone = {row["library"] for row in rows if row["work"] == "points3/gradient/value"}
        fractals = {"fbm": "", "ridged": "axes not turned", "waves": "axes not turned",
                    "erosion": "fBm, axes not turned", "turbulence": "axes not turned",
                    "cells": "axes not turned", "swiss": "fBm, axes not turned"}
        without = {"turbulence": {"FastNoiseLite"}, "cells": {"stb_perlin", "libnoise"}}
        for row in rows:
            with self.subTest(row=row):
                preset = re.search(r"/terrain-(\w+)/", row["work"])
                if row["library"] == "scarp" or row["work"].startswith("points3"):
                    self.assertNotIn("note", row)
                    continue
                self.assertNotIn("/+", row["work"])
                notes = [fractals[preset.group(1)] if preset else ""]
                notes += ["in 3D"] * (row["library"] in ("stb_perlin", "libnoise"))
                self.assertEqual(row.get("note", ""), ", ".join(filter(None, notes)))
        for word in [*("-%s/" % name for name in fractals), "quick-noise"]:
            self.assertEqual({row["library"] for row in rows
                              if word in row["work"] and "/+" not in row["work"]},
                             everyone - without.get(word.strip("-/"), set()))

    def test_plain_gullies(self):
        """The formulas by the compiler's vectors, in closed form as well: floats, straight axes."""
        if run("--list", "--peers").returncode != 0:
            self.skipTest("no peer was found")
        rows = report_of(*QUICK, "--work", "gullies2/*/n=4096", "--peers")["rows"]
        self.check_rows(rows)
        plain = {row["work"] for row in rows if row["library"] == "plain C"}
        if plain:
            self.assertEqual(plain, {row["work"] for row in rows if "f64" not in row["work"]})
        self.assertLessEqual({row["library"] for row in rows}, {"scarp", "plain C"})
        for row in rows:
            self.assertNotIn("note", row)

    def test_recipes_by_hand(self):
        """The way that was the fastest is named; there is one only for few points."""
        if run("--list", "--peers").returncode != 0:
            self.skipTest("no peer was found")
        rows = report_of(*QUICK, "--isa", "scalar", "--peers", "--work",
                         "recipe-grid2/noise1/value/256,recipe3/density/f64/value/n=4")["rows"]
        self.check_rows(rows)
        self.assertEqual([(row["work"], row["library"]) for row in rows],
                         [(work, library) for work in ("recipe-grid2/noise1/value/256",
                                                       "recipe3/density/f64/value/n=4")
                          for library in ("scarp", "by hand")])
        self.assertRegex(rows[1]["way"], r"\A(whole|(bands|pieces) of \d+)\Z")
        self.assertEqual(rows[3]["way"], "whole")
        for row in rows[::2]:
            self.assertNotIn("way", row)

    def test_scratch(self):
        """Recipes have a row for each size of their scratch memory, other rows do not."""
        grid, points = "recipe-grid2/noise1/value/256", "recipe2/alps/f64/value/n=16"
        rows = report_of(*QUICK, "--isa", "scalar", "--scratch", "0,65536", "--work",
                         "points2/gradient/value,%s,%s" % (grid, points))["rows"]
        self.check_rows(rows)
        self.assertEqual([row["work"] for row in rows],
                         ["points2/gradient/value"] +
                         [work + scratch for work in (grid, points)
                          for scratch in ("", "/scratch=0", "/scratch=65536")])

    def test_recipe_table(self):
        """recipes.py compares them."""
        grid = "recipe-grid3/density/value/32"
        with open(self.path("rows.json"), "w") as file:
            json.dump({"rows": [self.row(grid, "avx2", 90), self.row(grid + "/scratch=65536", "avx2", 80),
                                self.row(grid, "avx2", 100, "by hand", way="whole"),
                                self.row(grid, "avx2", 20, "FastNoise2"),
                                self.row("points2/gradient/value", "avx2", 20)]}, file)
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench", "recipes.py")
        shown = subprocess.run([sys.executable, script, self.path("rows.json")], check=True,
                               stdout=subprocess.PIPE, text=True).stdout
        self.assertEqual([line for line in shown.splitlines() if "density" in line],
                         ["| recipe-grid3/density/value/32 | 9.000 | whole | 0.90 | 0.80 | 4.50 |"])

    def test_peers_of_few_points(self):
        if not has_peers():
            self.skipTest("no peer was found")
        works = ["points3/gradient/value/n=%d" % n for n in (1, 4, 16, 64)]
        rows = report_of(*QUICK, "--isa", "scalar", "--work", ",".join(works), "--peers")["rows"]
        self.check_rows(rows)
        libraries = [{row["library"] for row in rows if row["work"] == work} for work in works]
        if libraries[0] == {"scarp"}:
            self.skipTest("no peer that was found takes one point at a time")
        self.assertEqual(libraries, 4 * [libraries[0]])


class Every(Case):
    """What takes long: all workloads, and a large one."""

    @unittest.skipIf(sys.argv[3:], "emulated processors are about 100 times slower")
    def test_every_workload(self):
        best = report_of(*ONE)["isas"].split()[-1]
        names = [name for name in names_of() if not LARGE.match(name)]
        rows = report_of("--min-time", "0.000001", "--repeat", "1", "--isa", best,
                         "--work", ",".join(names))["rows"]
        self.assertEqual([row["work"] for row in rows], names)
        self.check_rows(rows)
        for row in rows:
            output = row["work"].split("/")[-1]
            note = output.replace("-", " ") if output.endswith("-differences") else None
            self.assertEqual((row["library"], row["isa"], row.get("note")), ("scarp", best, note))

    @unittest.skipIf(sys.argv[3:], "emulated processors are about 100 times slower")
    def test_large_grid(self):
        """A call that is longer than its slice; and arrays of different sizes"""
        best = report_of(*ONE)["isas"].split()[-1]
        work = ["points2/gradient/+hessian", "grid2/gradient/value/4096/step0.01"]
        rows = report_of("--min-time", "0.001", "--repeat", "7", "--isa", best,
                         "--work", ",".join(work))["rows"]
        self.assertEqual([row["work"] for row in rows], work)
        self.check_rows(rows)


class Errors(Case):
    """Command lines that ask for what is not possible: nothing may be done."""

    def check(self, option, *arguments):
        with self.subTest(arguments=arguments):
            before = self.files()
            self.check_one_line(run(*arguments, cwd=self.directory), 2, option)
            self.assertEqual(self.files(), before)

    def test_names(self):
        for word in ("--bogus", "-w", "--wor", "--works", "--bogus=1", "-", "--", "stray"):
            self.check(word.split("=")[0], word)
            self.check(word.split("=")[0], *ONE, word)

    def test_missing_values(self):
        for name in OPTIONS:
            if name not in FLAGS:
                self.check("--" + name, "--" + name)
                self.check("--" + name, "--" + name, "--quiet")
                self.check("--" + name, "--" + name + "=")
            elif name != "help":
                self.check("--" + name, "--" + name + "=1")

    def test_numbers(self):
        for value in ("", "one", "1x", " 1", "1 ", "1,5", "nan", "inf", "-1", "0", "1e999", "3601"):
            self.check("--min-time", *ONE, "--json", "x.json", "--min-time", value)
        for value in ("", "0", "-1", "1.5", "1001", "1e2", "0x5", "99999999999999999999", " 5"):
            self.check("--repeat", *ONE, "--json", "x.json", "--repeat=" + value)

    def test_scratch(self):
        for value in ("", "one", "1K", "-1", "1.5", "1,", ",1", "1,,2", "1073741825", " 5", "0x5",
                      "1,2,3,4,5,6,7,8,9"):
            self.check("--scratch", *ONE, "--json", "x.json", "--scratch", value)

    def test_work(self):
        for value in ("bogus", "points4/*", "", "points2/gradient/value,bogus", "?", "a\nb",
                      "x" * 3000, "normals,", ",normals", "normals,,normals", ","):
            self.check("--work", *QUICK, "--json", "x.json", "--work", value)
            self.check("--work", "--list", "--work", value)

    def test_isa(self):
        for value in ("bogus", "AVX2", "scalar,", ",scalar", "scalar,bogus", "none", " scalar"):
            self.check("--isa", *ONE, "--json", "x.json", "--isa", value)
        here = report_of(*ONE)["isas"].split()
        absent = [isa for isa in ISAS if isa not in here]
        self.assertTrue(absent)
        for isa in absent:
            self.check("--isa", *ONE, "--json", "x.json", "--svg", "x.svg", "--isa", isa)
            self.check("--isa", *ONE, "--isa", "scalar," + isa)

    def test_files(self):
        for option in ("--json", "--svg"):
            for name in ("missing/x", ".", "missing\n/x"):
                self.check(option, *ONE, option, name)
        self.check("--svg", *ONE, "--json", "x.json", "--svg", "missing/x.svg")
        self.check("--json", *ONE, "--json", "-", "--markdown")

    def test_existing_file_survives(self):
        with open(self.path("x.json"), "w") as file:
            file.write("precious")
        self.check("--isa", *ONE, "--json", "x.json", "--isa", "bogus")
        self.check("--work", *QUICK, "--json", "x.json", "--work", "bogus")
        self.check("--svg", *ONE, "--json", "x.json", "--svg", "missing/x.svg")
        with open(self.path("x.json")) as file:
            self.assertEqual(file.read(), "precious")

    def test_from(self):
        good = report_of(*ONE, "--isa", "scalar")
        for name, text in (("empty", ""), ("text", "hello"), ("array", "[]"), ("object", "{}"),
                           ("rows", "{\"rows\":[]}"), ("cut", json.dumps(good)[:-2]),
                           ("more", json.dumps(good) + "x"),
                           ("zero", json.dumps(good).replace('"ns_per_point": ',
                                                             '"ns_per_point": -')),
                           ("string", "{\"version\":\"" + "x" * 9999)):
            with open(self.path(name), "w") as file:
                file.write(text)
            self.check("--from", "--from", name, "--json", "x.json")
        with open(self.path("good"), "w") as file:
            json.dump(good, file)
        self.check("--from", "--from", "missing")
        self.check("--from", "--from", "good", "--list")
        self.check("--from", "--from", "good", "--peers")
        self.check("--work", "--from", "good", "--work", "bogus", "--json", "x.json")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_full_disk(self):
        for option in ("--json", "--svg"):
            result = run(*ONE, option, "/dev/full")
            self.assertEqual(result.returncode, 1)
            self.assertRegex(result.stderr.decode(), r"\Ascarp-bench: %s: [^\n]+\n\Z" % option)
        with open("/dev/full", "w") as full:
            result = run(*ONE, stdout=full)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr.decode(), r"\Ascarp-bench: standard output: [^\n]+\n\Z")


main(globals())
