# SPDX-License-Identifier: MIT
"""Recipes: presets, files, one noise; values, scale, seeds; what is refused; `scarp recipe`."""
import os
import re
import struct

import common
from common import FRACTALS, ROOT, SMALL, Case, has_threads, run, text_of

SIZE = ("--size", "48x40", "--step", "7")
RECIPE = """# A test
#: palette desert
recipe 1
param height = 90 [0, 400]
param sea = 4 [-50, 50]
bend = noise(size=80, amplitude=20, seed=2)
land = warp(noise(ridged, size=60, octaves=3), bend)
out a = height * (land - 0.4) + 5
out b = land
"""


def presets():
    with open(os.path.join(ROOT, "src", "cli", "presets", "presets.cmake"),
              encoding="utf-8") as file:
        return re.search(r"scarp_presets ([a-z ]+)\)", file.read()).group(1).split()


class Recipes(Case):
    def write(self, text, name="r.recipe"):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return name

    def heights(self, *arguments, layer="--heights", **more):
        data = self.layer(layer, "f.img", *arguments, **more)
        return struct.unpack("<%df" % (len(data) // 4), data)

    def check_close(self, found, expected, within):
        self.assertEqual(len(found), len(expected))
        self.assertLessEqual(max(abs(a - b) for a, b in zip(found, expected)), within)

    def test_ways(self):
        """A preset, its text in a file and on standard input give the same bytes."""
        for name in presets():
            text = text_of("recipe", name, "--text")
            self.write(text)
            size = ("--size", "48x40", "--step", "97")
            made = self.heights(*size, "--preset", name)
            self.assertEqual(self.heights(*size, "--recipe", "r.recipe"), made, name)
            result = run("terrain", *size, "--recipe", "-", "--heights", "r32:-", "--quiet",
                         input=text.encode())
            self.assertEqual(result.stderr, b"")
            self.assertGreater(len(set(made)), 300, name)
            self.assertEqual(len(result.stdout), 4 * len(made))
            self.assertEqual(text_of("terrain", "--preset", name, "--print-recipe"), text)
        self.write("\ufeff" + text.replace("\n", "\r\n"))  # as editors of Windows write it
        self.assertEqual(self.heights(*size, "--recipe", "r.recipe"), made)

    def test_presets_differ(self):
        self.assertEqual(len({self.heights(*SIZE, "--origin", "9000,0", "--preset", name)
                              for name in presets()}),
                         len(presets()))
        self.assertEqual(self.heights(*SIZE, "--preset", "alps", "--preset", "none"),
                         self.heights(*SIZE))

    def test_one_noise(self):
        """The recipe that is printed for it gives the same bytes, whatever its options are."""
        variants = [["--fractal", fractal] for fractal in FRACTALS]
        variants += [["--basis", basis] for basis in ("value", "simplex", "cell-f1", "cell-f2",
                                                      "cell-edge", "cell-soft", "cell-value")]
        variants += [["--fade", "cubic"], ["--rotate"], ["--octaves", "2.5", "--of-octaves", "4"],
                     ["--lacunarity", "2.5", "--gain", "0.7", "--amplitude", "-0.3"],
                     ["--fractal", "erosion", "--erosion", "0.3"], ["--phase", "0.37"],
                     ["--phase", "0"], ["--basis", "cell-f1", "--jitter", "0.5"],
                     ["--fractal", "swiss", "--sharpness", "0.4"], ["--height", "3.3"],
                     ["--sea-level", "0.05"], ["--plateau", "0.125"], ["--plateau", "-5"],
                     ["--sea-level", "-0.1", "--plateau", "0.3", "--height", "71"],
                     ["--period", "64x32"]]
        seen = set()
        for variant in variants:
            words = [*SMALL, "--octaves", "3", *variant]
            self.write(text_of("terrain", *words, "--print-recipe"))
            made = self.heights(*words)
            again = self.heights("--size", "40x30", "--recipe", "r.recipe")
            self.assertEqual(again, made, variant)
            seen.add(made)
        self.assertGreaterEqual(len(seen), len(variants) - 2)  # phase 0, octaves above 2.5

    def test_values(self):
        self.write(RECIPE)
        plain = self.heights(*SIZE, "--recipe", "r.recipe", "--set", "sea=-50")
        high = self.heights(*SIZE, "--recipe", "r.recipe", "--set", "sea=-50", "--set",
                            "height=45")
        self.check_close(high, [(h - 5) / 2 + 5 for h in plain], 2e-5)
        self.write(RECIPE.replace("= 90", "= 45").replace("sea = 4", "sea = -50"), "q.recipe")
        self.assertEqual(self.heights(*SIZE, "--recipe", "q.recipe"), high)
        self.assertEqual(self.heights(*SIZE, "--recipe", "r.recipe", "--set", "height=1", "--set",
                                      "sea=-50", "--set", "height=45"), high)  # the last counts

    def test_seed(self):
        self.write(RECIPE)
        made = [self.heights(*SIZE, "--recipe", "r.recipe", "--seed", seed)
                for seed in ("1", "2", "0x10000000000")]
        self.assertEqual(len(set(made)), 3)
        self.assertEqual(made[0], self.heights(*SIZE, "--recipe", "r.recipe"))

    def test_negative_seeds(self):
        """All commands take them, as 2^64 more; in recipes they are other streams."""
        self.write(RECIPE)
        words = [*SIZE, "--recipe", "r.recipe", "--seed"]
        for negative, same in (("-1", "18446744073709551615"), ("-0x", None),
                               ("-9223372036854775808", "0x8000000000000000"), ("-0", "0")):
            if same is None:
                self.check_one_line(run("terrain", *words, negative, "--heights", "n.r32",
                                        cwd=self.directory), 2, "--seed")
                continue
            made = self.heights(*words, negative)
            self.assertEqual(made, self.heights(*words, same))
            points = [run("sample", "--seed", seed, "--frequency", "0.3", input=b"1,2\n")
                      for seed in (negative, same)]
            self.assertEqual(points[0].stdout, points[1].stdout)
            self.assertEqual(points[0].returncode, 0)
        self.write(RECIPE.replace("seed=2", "seed=-2"), "q.recipe")
        self.assertNotEqual(self.heights(*SIZE, "--recipe", "q.recipe"),
                            self.heights(*SIZE, "--recipe", "r.recipe"))

    def test_scale(self):
        """Places and heights; slopes stay."""
        self.write(RECIPE)
        for scale, within in (("4", 0), ("0.25", 0), ("3", 2e-4)):
            factor = float(scale)
            small = self.heights("--size", "40x30", "--step", "2", "--recipe", "r.recipe")
            slopes = self.heights("--size", "40x30", "--step", "2", "--recipe", "r.recipe",
                                  layer="--gradient")
            large = ["--size", "40x30", "--step", str(2 * factor), "--recipe", "r.recipe",
                     "--scale", scale]
            self.check_close(self.heights(*large), [factor * h for h in small], within)
            self.check_close(self.heights(*large, layer="--gradient"), slopes,
                             1e-4 if within else 0)

    def test_sea(self):
        """It is flat at its level, and where it is dry, the ground is as it is without."""
        self.write(RECIPE)
        wet = self.heights(*SIZE, "--recipe", "r.recipe")
        dry = self.heights(*SIZE, "--recipe", "r.recipe", "--set", "sea=-50")
        self.assertEqual(list(wet), [max(h, 4.0) for h in dry])
        self.assertIn(4.0, wet)
        slopes = self.heights(*SIZE, "--recipe", "r.recipe", layer="--gradient")
        for h, dx, dy in zip(wet, slopes[::2], slopes[1::2]):
            self.assertTrue((dx, dy) == (0, 0) or h > 4.0)

    def test_palette(self):
        self.write(RECIPE)
        made = self.layer("--relief", "r.ppm", *SIZE, "--recipe", "r.recipe")
        self.assertEqual(made, self.layer("--relief", "r.ppm", *SIZE, "--recipe", "r.recipe",
                                          "--palette", "desert"))
        self.write(RECIPE.replace("#: palette desert\n", ""))
        self.assertEqual(self.layer("--relief", "r.ppm", *SIZE, "--recipe", "r.recipe"),
                         self.layer("--relief", "r.ppm", *SIZE, "--recipe", "r.recipe",
                                    "--palette", "alpine"))

    def test_same_everywhere(self):
        """The same bytes on all sets, with any number of threads, and in tiles."""
        self.write(RECIPE)
        words = ["--size", "64x48", "--step", "3", "--recipe", "r.recipe"]
        whole = self.heights(*words)
        for isa in common.supported_isas():
            self.assertEqual(self.heights(*words, "--isa", isa), whole, isa)
        if has_threads():
            self.assertEqual(self.heights(*words, "--threads", "3"), whole)
        self.quietly(*words, "--tile", "32x48", "--heights", "t.r32")
        with open(self.path("t_0_1.r32"), "rb") as file:
            right = struct.unpack("<1536f", file.read())
        self.assertEqual(right, tuple(h for row in range(48) for h in
                                      whole[64 * row + 32:64 * row + 64]))

    def test_tile(self):
        """--period writes a tile; of what does not fit, the message has the nearest."""
        self.write(RECIPE.replace("size=80", "size=64").replace("size=60", "size=32"))
        two = self.heights("--size", "128x64", "--period", "64x64", "--recipe", "r.recipe")
        rows = [two[128 * r:128 * r + 128] for r in range(64)]
        self.assertTrue(all(row[:64] == row[64:] for row in rows))
        self.write(RECIPE)
        result = run("terrain", "--recipe", "r.recipe", "--tileable", "--size", "64x64",
                     "--heights", "h.r32", cwd=self.directory)
        self.check_one_line(result, 2, "--period: r.recipe, line 6", "the nearest size that fits: size=64\n")
        # What no size mends comes first, with its own line.
        for text, told in (
                ("a = noise(size=10)\nout h = noise(size=1500, rotate, octaves=2)",
                 "line 3, column 9: rotate: turned axes cannot repeat\n"),
                ("a = noise(size=1500, rotate, octaves=2)\nout h = warp(noise(size=10), a)",
                 "line 2, column 5: rotate: turned axes cannot repeat\n"),
                ("out h = gullies(noise(size=10), size=1500, octaves=3, rotate)",
                 "line 2, column 9: rotate: turned axes cannot repeat\n"),
                ("out h = noise(size=1500, lacunarity=2.5, octaves=2)",
                 "line 2, column 9: lacunarity: not a whole number"),
                ("out h = noise(simplex, size=1500)",
                 "line 2, column 9: period[1]: simplex noise repeats along x only in 2D; a slice of 3D"),
                ("out h = noise(size=1500)", "line 2, column 9: the tile is not a whole number of cells; "
                 "`nearest` is the nearest size that fits: size=1250\n")):
            with self.subTest(text=text):
                with open(self.path("r.recipe"), "w", encoding="utf-8") as file:
                    file.write("recipe 1\n" + text + "\n")
                result = run("terrain", "--recipe", "r.recipe", "--tileable", "--size", "1250x1250",
                             "--heights", "h.r32", cwd=self.directory)
                self.check_one_line(result, 2, "--period: r.recipe, " + told)
        result = run("terrain", "--preset", "alps", "--tileable", "--size", "1250x1250", "--heights",
                     "h.r32", cwd=self.directory)
        self.check_one_line(result, 2, "--period: alps, line 10, column 11: rotate: ", "turned axes cannot repeat")

    def test_sheet(self):
        """A sheet varies parameters."""
        self.write(RECIPE)
        words = ["--recipe", "r.recipe", "--panel", "40x30", "--samples", "1", "--quiet"]
        for sheet in ("height=50..200/3", "seed=1..2,height=20|90", "sea=-9..9/2",
                      "seed=-1..1", "seed=-1000000001..-1000000000"):
            result = run("sheet", *words, "--sheet", sheet, "--output", "s.ppm",
                         cwd=self.directory)
            self.assertEqual((result.returncode, result.stderr), (0, b""))
        result = run("sheet", *words, "--sheet", "depth=1..2", "--output", "t.ppm",
                     cwd=self.directory)
        self.check_one_line(result, 2, "--set", "no parameter 'depth'", "height [0, 400]")
        self.assertNotIn("t.ppm", self.files())

    def test_manifest(self):
        """Another text, or another value, is another world; the order of values is not."""
        self.write(RECIPE)
        self.write(RECIPE.replace("+ 5", "+ 6"), "q.recipe")
        words = ["terrain", "--size", "64x64", "--tile", "32x64", "--heights", "t.r16", "--quiet",
                 "--resume"]
        first = [*words, "--recipe", "r.recipe", "--set", "height=80", "--set", "sea=3"]
        self.assertEqual(run(*first, cwd=self.directory).returncode, 0)
        again = [*words, "--recipe", "r.recipe", "--set", "sea=3", "--set", "height=7", "--set",
                 "height=80"]
        self.assertEqual(run(*again, cwd=self.directory).stderr, b"")
        for other in (["--recipe", "r.recipe", "--set", "height=81", "--set", "sea=3"],
                      ["--recipe", "q.recipe", "--set", "height=80", "--set", "sea=3"],
                      ["--recipe", "r.recipe", "--set", "height=80", "--set", "sea=3", "--scale",
                       "2"], []):
            result = run(*words, *other, cwd=self.directory)
            self.check_one_line(result, 2, "--heights", "another world")


class RecipesRefused(Case):
    def refused(self, text, *told, words=("--recipe", "r.recipe"), command="terrain"):
        """One line with these texts; nothing is written."""
        if text is not None:
            with open(self.path("r.recipe"), "wb") as file:
                file.write(text.encode() if isinstance(text, str) else text)
        output = "--output" if command in ("view", "sheet") else "--heights"
        for each in (command,):
            result = run(each, *words, output, "h.ppm" if output == "--output" else "h.r32",
                         cwd=self.directory)
            self.check_one_line(result, 2, *told)
        self.assertEqual([name for name in self.files() if name != "r.recipe"], [])

    def test_texts(self):
        for text, told in (("recipe 1\nout a = noise(size=0)\n", "r.recipe, line 2, column 20"),
                           ("recipe 1\nout a = foo(3)\n", "line 2, column 9: there is no such"),
                           ("recipe 1\nout a = x\n", "no bound"),
                           ("recipe 1\nout a = 3\n", "no height"),
                           ("recipe 1\nspace 3\nout a = noise()\n", "of the plane"),
                           ("", "line 1"), ("recipe 2\n", "line 1"),
                           ("recipe 1\n#: palette sky\nout a = noise()\n", "'sky' is no palette"),
                           ("#" * 16385, "longer than 16384 bytes"),
                           (b"recipe 1\0\n", "a byte that is 0")):
            with self.subTest(text=text[:40]):
                self.refused(text, "--recipe", told, words=("--recipe", "r.recipe", "--relief",
                                                            "q.ppm"))

    def test_files(self):
        self.refused(None, "--recipe", "no.recipe", words=("--recipe", "no.recipe"))
        self.refused(None, "--recipe", words=("--recipe", "."))
        self.refused(None, "--preset", "is not none, " + presets()[0],
                     words=("--preset", "everest"))
        self.refused(None, "--recipe", "--preset",
                     words=("--preset", presets()[0], "--recipe", "r.recipe"))

    def test_values(self):
        text = "recipe 1\nparam a = 1 [0, 2]\nparam b = 8\nout h = a * noise(size=b)\n"
        for value, told in (("a=3", "a=3 is outside"), ("c=1", "no parameter 'c'; it has a [0, 2]"),
                            ("a", "NAME=VALUE"), ("a=x", "NAME=VALUE"), ("=1", "NAME=VALUE"),
                            ("a=nan", "NAME=VALUE"), ("a=1,b=2", "NAME=VALUE"),
                            ("b=0", "b=0: line 4")):
            self.refused(text, "--set", told, words=("--recipe", "r.recipe", "--set", value))
        self.refused(None, "--set", words=("--set", "a=1"))

    def test_options_of_one_noise(self):
        for option, value in (("--octaves", "3"), ("--height", "9"), ("--sea-level", "0"),
                              ("--fractal", "fbm"), ("--frequency", "0.0025"),
                              ("--amplitude", "1"), ("--plateau", "1")):
            for command in ("terrain", "view", "sheet"):
                self.refused(None, option, "--set", "--preset", command=command,
                             words=("--preset", presets()[0], option, value))
        self.refused(None, "--rotate", "--set", words=("--preset", presets()[0], "--rotate"))

    def test_removed(self):
        for option, value, told in (("--warp-reach", "3", "warp("), ("--base-amplitude", "1", "a + b"),
                                    ("--mask-band", "0,1", "smoothstep"), ("--wind", "3", "wind("),
                                    ("--terraces", "3", "terrace("), ("--stretch", "2", "wind("),
                                    ("--crater", "1", "min(")):
            for command in ("terrain", "view", "sheet"):
                self.refused(None, option, told, words=(option, value), command=command)


class Command(Case):
    """`scarp recipe`"""

    def test_presets(self):
        """What is printed is a recipe again, with its parameters and outputs as comments behind it."""
        for name in presets():
            printed = text_of("recipe", name)
            with open(self.path("r.recipe"), "w", encoding="utf-8") as file:
                file.write(printed)
            self.assertEqual(text_of("recipe", self.path("r.recipe"), "--text"), printed)
            told = printed[printed.index("\n# outputs\n"):]
            numbers = re.search(r"never leaves \[(\S+), (\S+)\]; lowest (\S+), middle (\S+), "
                                r"highest (\S+)\n", told).groups()
            low, high, lowest, middle, highest = map(float, numbers)
            self.assertTrue(low <= lowest < middle < highest <= high, numbers)
            self.assertRegex(told, r"# cost\n#   [\d.]+ ns per sample, with the gradient [\d.]+ ")
            for parameter in re.findall(r"(?m)^param (\w+) ", printed):
                self.assertRegex(printed, r"(?m)^#   %s +=" % parameter)

    def test_set(self):
        printed = text_of("recipe", presets()[0], "--set", "height=100", "--seed", "3")
        self.assertRegex(printed, r"(?m)^#   height +=  ?100 ")

    def test_errors(self):
        """All of them, a line each"""
        result = run("recipe", "-", input=b"recipe 1\nout a = noise(size=0)\nb = foo(3)\n")
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        lines = result.stderr.decode().splitlines()
        self.assertEqual(len(lines), 2, lines)
        self.assertIn("standard input, line 2, column 20", lines[0])
        self.assertIn("line 3, column 5: there is no such function", lines[1])
        for words in ((), ("no.recipe",), ("--seed", "3"), (presets()[0], "x")):
            self.check_one_line(run("recipe", *words, cwd=self.directory), 2)

    def test_space(self):
        printed = run("recipe", "-", input=b"recipe 1\nspace 3\nout a = noise(size=9)\n").stdout
        self.assertIn(b"never leaves [-1, 1]", printed)

    def test_shader(self):
        """The text holds in any seed; buffer and answers are those of the library's layout."""
        def shader(*options):
            text = text_of("recipe", "alps", "--shader", "wgsl", "--uniforms", self.path("u"),
                           "--answers", self.path("a"), *options)
            with open(self.path("u"), "rb") as uniforms, open(self.path("a"), "rb") as answers:
                return text, uniforms.read(), answers.read()

        text, uniforms, answers = shader()
        numbers, levels, octaves = (int(n) for n in re.findall(r"array<\w+, (\d+)>", text))
        self.assertEqual(len(uniforms), 16 + 16 * numbers + 48 * levels + 160 * octaves)
        self.assertEqual(len(answers), 4 * 4096)
        self.assertIn("fn scarp_recipe_alps(x: f32, y: f32) -> ScarpSample {", text)
        other = shader("--seed", "2")
        self.assertEqual(other[0], text)
        self.assertNotEqual(other[1], uniforms)
        self.assertNotEqual(other[2], answers)
        self.assertNotEqual(shader("--set", "height=700")[1], uniforms)
        self.assertNotEqual(shader("--derivatives", "0")[2], answers)
        for language in "glsl", "hlsl":
            text = text_of("recipe", "alps", "--shader", language)
            self.assertIn("ScarpSample scarp_recipe_alps(float x, float y)\n{\n", text)
        for words in ("--shader", "metal"), ("--shader", "glsl", "--derivatives", "3"):
            self.assertEqual(run("recipe", "alps", *words).returncode, 2)
        both = run("recipe", "alps", "--text", "--uniforms", self.path("both"))
        self.assertEqual((both.returncode, both.stdout), (2, b""))
        self.assertFalse(os.path.exists(self.path("both")))
        result = run("recipe", "alps", "--uniforms", self.path("none/u"))
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count(b"\n"), 1)

    def test_help(self):
        """The file says its language."""
        told = text_of("help", "recipe")
        for word in ("smoothstep(a, lo, hi)", "gullies(f, ", "terrace(", "--set NAME=VALUE"):
            self.assertIn(word, told)


common.main(globals())
