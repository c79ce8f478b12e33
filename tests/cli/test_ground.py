# SPDX-License-Identifier: MIT
"""What a terrain is made of beside its noise: base, mask, terraces and wind."""
import math
import struct

import common
from common import FRACTALS, SMALL, WARP, Case, run

SIZE = ["--size", "40x30"]
CHEAP = [*SMALL, "--octaves", "2"]
BASED = [*CHEAP, "--base-amplitude", "0.5", "--base-seed", "9", "--base-octaves", "2"]
MASKED = [*CHEAP, "--mask-band", "-0.1,0.3", "--mask-seed", "9", "--mask-octaves", "2"]
ALL = [*BASED, "--mask-band", "-0.2,0.2", "--mask-frequency", "0.02", "--terraces", "7",
       "--stretch", "3", "--wind", "240", "--crater", "0.15", "--sea-level", "-0.1"]


class Ground(Case):
    def floats(self, option, *arguments):
        data = self.layer(option, "f.img", *arguments)
        return struct.unpack("<%df" % (len(data) // 4), data)

    def values(self, *arguments):
        return self.floats("--heights", *arguments, "--height", "1")

    def check_close(self, found, expected, within):
        self.assertEqual(len(found), len(expected))
        self.assertLessEqual(max(abs(a - b) for a, b in zip(found, expected)), within)

    def test_every_option_of_base_and_mask_counts(self):
        """Each changes the heights: a parameter that is not passed on would not."""
        changes = {"seed": ("2", "4294967297"), "basis": ("value", "cell-f1"), "fade": ("cubic",),
                   "fractal": FRACTALS[1:], "octaves": ("3", "2.5"), "frequency": ("0.031",),
                   "lacunarity": ("2.1",), "gain": ("0.6",), "of-octaves": ("3",),
                   "phase": ("0.3",)}
        for part, arguments in (("base", BASED), ("mask", MASKED)):
            variants = [["--%s-%s" % (part, name), value]
                        for name, values in changes.items() for value in values]
            of = "--" + part + "-"
            variants += [[], [of + "rotate"], [of + "basis", "cell-f1", of + "jitter", "0.5"],
                         [of + "fractal", "erosion", of + "erosion", "0.5"],
                         [of + "fractal", "swiss", of + "sharpness", "0.5"]]
            words = " ".join(word for variant in variants for word in variant)
            self.assertEqual([name for name in WARP if of + name not in words], [])
            made = {self.layer("--heights", "h.r32", *arguments, *variant): variant
                    for variant in variants}
            self.assertEqual(len(made), len(variants), made.values())

    def test_base_is_added(self):
        base = ["--size", "40x30", "--seed", "9", "--frequency", "0.03", "--octaves", "2", "--gain",
                "0.5", "--amplitude", "0.5"]
        expected = [a + b for a, b in zip(self.values(*CHEAP), self.values(*base))]
        self.check_close(self.values(*BASED), expected, 2e-7)

    def test_mask_multiplies(self):
        mask = self.values("--size", "40x30", "--seed", "9", "--frequency", "0.03", "--octaves",
                           "2", "--gain", "0.5")
        t = [min(max((m + 0.1) / 0.4, 0), 1) for m in mask]
        smooth = [u * u * u * (u * (6 * u - 15) + 10) for u in t]
        expected = [a * b for a, b in zip(self.values(*CHEAP), smooth)]
        self.assertTrue(0 in smooth and 1 in smooth)
        self.check_close(self.values(*MASKED), expected, 1e-6)
        turned = self.values(*MASKED, "--mask-band", "0.3,-0.1")
        self.check_close([a + b for a, b in zip(turned, expected)], self.values(*CHEAP), 1e-6)

    def test_crater(self):
        """What is above the rim is as far below it, before mask and base; the rest stays."""
        plain = self.values(*CHEAP)
        made = self.values(*CHEAP, "--crater", "0.2")
        self.check_close(made, [0.2 - abs(v - 0.2) for v in plain], 1e-6)
        self.assertEqual([m for m, v in zip(made, plain) if v <= 0.2],
                         [v for v in plain if v <= 0.2])
        self.assertGreater(sum(v > 0.2 for v in plain), 50)
        slopes = [self.floats("--gradient", *CHEAP, *crater, "--height", "1")
                  for crater in ([], ["--crater", "0.2"])]
        for value, before, after in zip(plain, slopes[0][::2], slopes[1][::2]):
            self.assertEqual(after, before if value <= 0.2 else -before)
        self.assertNotEqual(self.values(*BASED, "--crater", "0.2"), self.values(*BASED))

    def test_terraces(self):
        """Treads are level where strength is 1, and values move by half a step at most."""
        plain = self.values(*CHEAP)
        made = self.values(*CHEAP, "--terraces", "20", "--terrace-strength", "1",
                           "--terrace-riser", "0.25")
        self.check_close(made, plain, 0.025 + 1e-6)
        level = sum(abs(20 * v - round(20 * v)) < 1e-4 for v in made)
        self.assertGreater(level, 0.6 * len(made))
        self.check_close(self.values(*CHEAP, "--terraces", "20", "--terrace-strength", "0"), plain,
                         1e-6)

    def test_stretch(self):
        """Across the wind, which comes from the west unless told otherwise, all is longer."""
        plain = self.values(*CHEAP, "--size", "40x10", "--origin", "0,4")
        made = self.values(*CHEAP, "--size", "40x28", "--origin", "0,12", "--stretch", "3")
        self.assertEqual(made[:40] + made[120:160] + made[1080:],
                         plain[:40] + plain[40:80] + plain[360:])

    def test_wind(self):
        """From the south it is the same terrain turned by a quarter."""
        west = self.values(*CHEAP, "--size", "30x40", "--origin", "0,0", "--stretch", "3")
        south = self.values(*CHEAP, "--size", "40x30", "--origin", "-39,0", "--stretch", "3",
                            "--wind", "180")
        # (x, y) of the first is (-y, x) of the second; rows go down.
        turned = [west[30 * c + 29 - r] for r in range(30) for c in range(40)]
        self.check_close(south, turned, 1e-6)

    def test_gradient(self):
        """It is that of the heights, through mask, base, terraces and wind."""
        fine = ["--step", "0.0078125", "--height", "1"]
        for arguments in (BASED, MASKED, ALL[:-4], [*CHEAP, "--stretch", "3"],
                          [*CHEAP, "--stretch", "0.25", "--wind", "30"],
                          [*CHEAP, "--terraces", "9"]):
            for origin in ("3,4", "100,-70"):
                where = [*arguments, *fine, "--origin", origin]
                heights = self.floats("--heights", *where)
                gradient = self.floats("--gradient", *where)
                rows = [heights[40 * r:40 * r + 40] for r in range(30)]
                across = [(row[c + 3] - row[c - 3]) / 0.046875 for row in rows[8:22]
                          for c in range(8, 32)]
                up = [(rows[r - 3][c] - rows[r + 3][c]) / 0.046875 for r in range(8, 22)
                      for c in range(8, 32)]
                inner = [(40 * r + c) * 2 for r in range(8, 22) for c in range(8, 32)]
                slopes = [gradient[i] for i in inner], [gradient[i + 1] for i in inner]
                steepest = max(map(abs, slopes[0] + slopes[1]))
                self.check_close(slopes[0], across, 0.02 * steepest + 1e-4)
                self.check_close(slopes[1], up, 0.02 * steepest + 1e-4)

    def test_range(self):
        """Values stay in the interval that 16-bit heights are mapped to."""
        for arguments in (BASED, MASKED, ALL, [*MASKED, "--fractal", "ridged"],
                          [*CHEAP, "--fractal", "ridged", "--terraces", "1.9"],
                          [*CHEAP, "--crater", "-0.4"], [*CHEAP, "--crater", "0.1"],
                          [*BASED, "--base-fractal", "ridged", "--base-amplitude", "-2"]):
            self.quietly(*arguments, "--height", "1", "--size", "200x150", "--step", "9", "--tile",
                         "200x150", "--heights", "h.r32")
            with open(self.path("h_0_0.r32"), "rb") as file:
                data = file.read()
            with open(self.path("h.r32.json"), encoding="utf-8") as file:
                text = file.read()
            lowest, highest = (float(n) for n in text[text.index('"range": [') + 10:].split("]")[0]
                               .split(","))
            self.clear()
            values = struct.unpack("<30000f", data)
            self.assertGreaterEqual(min(values), lowest)
            self.assertLessEqual(max(values), highest)
            self.assertGreater(max(values) - min(values), 0.2 * (highest - lowest))

    def test_tiles_and_threads(self):
        for arguments in (ALL, [*ALL, "--wind", "270"]):
            self.quietly(*arguments, "--heights", "t.r32", "--gradient", "g.npy")
            whole = self.all_bytes()
            self.clear()
            self.quietly(*arguments, "--tile", "17x11", "--heights", "t.r32", "--threads", "1")
            rows = [b""] * 30
            for y in range(3):
                for x in range(3):
                    width = min(17, 40 - 17 * x)
                    data = self.bytes("t_%d_%d.r32" % (y, x))
                    for r in range(min(11, 30 - 11 * y)):
                        rows[11 * y + r] += data[4 * width * r:4 * width * (r + 1)]
            self.assertEqual(b"".join(rows), whole["t.r32"])
            self.clear()

    def test_isas(self):
        for arguments in (ALL, MASKED):
            made = {self.layer("--heights", "h.r32", *arguments, "--isa", isa)
                    for isa in common.supported_isas()}
            self.assertEqual(len(made), 1)

    def test_repeats(self):
        """With a base, a mask, and wind: the frequencies are chosen for each."""
        for arguments in ([*BASED, "--mask-band", "0,0.3", "--frequency", "0.07", "--base-frequency",
                           "0.05", "--mask-frequency", "0.04"],
                          [*CHEAP, "--frequency", "0.1", "--stretch", "2.7"],
                          [*CHEAP, "--frequency", "0.1", "--stretch", "2.7", "--warp-reach", "5"]):
            self.quietly(*arguments, "--size", "64x32", "--tileable", "--heights", "one.r32")
            self.quietly(*arguments, "--size", "128x64", "--period", "64x32", "--heights",
                         "four.r32")
            one = struct.unpack("<2048f", self.bytes("one.r32"))
            four = struct.unpack("<8192f", self.bytes("four.r32"))
            for r in range(64):
                row = one[64 * (r % 32):64 * (r % 32) + 64]
                self.check_close(four[128 * r:128 * r + 128], row * 2, 0.02)
            self.assertGreater(max(one) - min(one), 10)


class GroundRefused(Case):
    def refused(self, start, *words):
        result = run("terrain", *SIZE, "--heights", "h.r32", *words, cwd=self.directory)
        error = self.check_one_line(result, 2)
        self.assertTrue(error.startswith("scarp: " + start), error)
        self.assertEqual(self.files(), [])

    def test_values(self):
        for option, allowed, texts in (
                ("--base-amplitude", "0 or a number whose", ("", "x", "nan", "inf", "5e-8", "2e7")),
                ("--mask-band", "two numbers A,B from -16 to 16",
                 ("", "1", "0,x", "0,17", "nan,1", "0,1,2")),
                ("--crater", "a number from -2^24 to 2^24", ("x", "nan", "inf", "16777217")),
                ("--stretch", "a number from 1/16 to 16", ("0", "-1", "0.06", "17", "nan")),
                ("--wind", "a number from 0 to 360", ("-1", "361", "west")),
                ("--terraces", "a number from 0 to 2^16", ("-1", "65537", "nan")),
                ("--terrace-riser", "a number from 2^-20 to 1", ("0", "1.1", "nan")),
                ("--terrace-strength", "a number from 0 to 1", ("-0.1", "1.1", "nan"))):
            for text in texts:
                self.refused("%s: '%s' is not %s" % (option, text, allowed), option, text)
        self.refused("--mask-band: the numbers are closer", "--mask-band", "0,1e-30")

    def test_without_the_noise(self):
        for part, needs in (("base", "a --base-amplitude"), ("mask", "a --mask-band")):
            for name in WARP:
                value = {"rotate": [], "fade": ["cubic"], "basis": ["value"],
                         "fractal": ["fbm"]}.get(name, ["1"])
                self.refused("--%s-%s: needs %s\n" % (part, name, needs),
                             "--%s-%s" % (part, name), *value)

    def test_members(self):
        for part, there in (("base", ["--base-amplitude", "1"]), ("mask", ["--mask-band", "0,1"])):
            for words, start in (
                    ("--P-octaves 3 --P-of-octaves 2", "--P-of-octaves: is less than --P-octaves"),
                    ("--P-basis value --P-phase 0.5", "--P-phase: only the gradients of --P-basis"),
                    ("--P-fractal jordan --P-erosion 2", "--P-erosion: is more than 1"),
                    ("--P-rotate --tileable", "--P-rotate: axes that are turned do not repeat"),
                    ("--P-lacunarity 2.5 --P-octaves 2 --tileable",
                     "--P-lacunarity: is no whole")):
                self.refused(start.replace("P-", part + "-"), *there, "--frequency", "0.1",
                             *words.replace("P-", part + "-").split())
        self.refused("--mask-amplitude: unknown option", "--mask-amplitude", "2")
        self.refused("--wind: a stretched terrain repeats with 270 only", "--tileable", "--stretch",
                     "2", "--wind", "90")


common.main(globals())
