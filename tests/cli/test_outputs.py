# SPDX-License-Identifier: MIT
"""Files besides the height: outputs of a recipe, masks, slopes and curvature."""
import json
import math
import re

import common
from common import SMALL, Case, has_png, run
from rasters import FLOAT, U16_LOW, Picture, read_picture

RECIPE = b"""recipe 1
param sea = 0 [-50, 50]
land = noise(size=30, octaves=3)
out a = 40 * land + 3
out ridge = smooth_abs(land, 0.1)
out plain = 7 * smoothstep(land, -0.5, 0.5) - 3
out grows = x + land
out b = 12
"""
SIZE = ("--size", "41x27")


class OutputsCase(Case):
    def setUp(self):
        super().setUp()
        with open(self.path("r.recipe"), "wb") as file:
            file.write(RECIPE)

    def floats(self, name, width=41, height=27):
        return Picture(width, height, 1, FLOAT, self.bytes(name)).flat()

    def refused(self, *arguments, words=()):
        result = run("terrain", *SIZE, *arguments, cwd=self.directory)
        error = self.check_one_line(result, 2, *words)
        self.assertEqual([name for name in self.files() if name != "r.recipe"], [])
        return error


class Fields(OutputsCase):
    """--out NAME=FILE"""

    def alone(self, name, *arguments):
        """What the program says of a recipe whose only output is this one"""
        text = re.sub(rb"(?m)^out (?!%s )" % name.encode(), b"", RECIPE)
        with open(self.path("alone.recipe"), "wb") as file:
            file.write(text.replace(b"param sea", b"param no"))
        self.quietly(*SIZE, *arguments, "--recipe", "alone.recipe", "--heights", "alone.r32")
        return self.floats("alone.r32")

    def test_values(self):
        """Each output is, to the bit, what it is as the only height; the sea does not cover it."""
        for arguments in ((), ("--seed", "5", "--step", "0.5", "--origin", "7,-3")):
            self.quietly(*SIZE, *arguments, "--recipe", "r.recipe", "--heights", "h.r32", "--out",
                         "ridge=ridge.r32", "--out", "plain=plain.r32", "--out", "a=a.r32")
            for name in ("ridge", "plain", "a"):
                found = self.floats(name + ".r32")
                self.assertEqual(found, self.alone(name, *arguments), name)
                self.assertGreater(len(set(found)), 500)
            heights, dry = self.floats("h.r32"), self.floats("a.r32")
            self.assertEqual(heights, [max(value, 0.0) for value in dry])
            self.assertLess(min(dry), 0)

    def test_scale(self):
        """--scale makes places larger, and of all outputs only the height."""
        self.quietly(*SIZE, "--recipe", "r.recipe", "--out", "ridge=ridge.r32", "--out", "a=a.r32")
        plain = {name: self.floats(name) for name in ("ridge.r32", "a.r32")}
        self.quietly(*SIZE, "--recipe", "r.recipe", "--scale", "4", "--step", "4", "--out",
                     "ridge=ridge.r32", "--out", "a=a.r32")
        self.assertEqual(self.floats("ridge.r32"), plain["ridge.r32"])
        self.assertEqual(self.floats("a.r32"), [4 * value for value in plain["a.r32"]])

    def test_formats(self):
        """Floats agree; integers divide the interval that the run prints."""
        kinds = ("r32", "pfm", "img", "tif", "npy", "r16", "pgm") + (("png",) if has_png() else ())
        files = [word for kind in kinds for word in ("--out", "plain=plain." + kind)]
        result = run("terrain", *SIZE, "--recipe", "r.recipe", *files, cwd=self.directory)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        lowest, highest = re.search(r"16-bit plain: 0 is (\S+), 65535 is (\S+)\n",
                                    result.stdout.decode()).groups()
        self.assertEqual((float(lowest), float(highest)), (-3, 4))
        values = self.floats("plain.r32")
        integers = [math.floor((value + 3) / 7 * 65535 + 0.5) for value in values]
        for kind in kinds[1:]:
            if kind == "r16":
                found = Picture(41, 27, 1, U16_LOW, self.bytes("plain.r16"))
            else:
                found = read_picture(self.path("plain." + kind))
            self.assertEqual(found.flat(), values if found.depth == 32 else integers, kind)
        self.assertEqual(result.stdout.count(b"16-bit plain"), len(kinds) - 5)

    def test_same_field_twice(self):
        """One output may go to several files, next to all other layers."""
        self.quietly(*SIZE, "--recipe", "r.recipe", "--out", "a=a.npy", "--out", "a=a.r32",
                     "--relief", "c.npy", "--heights", "h.r32")
        self.assertEqual(read_picture(self.path("a.npy")).flat(), self.floats("a.r32"))

    def test_one_noise(self):
        self.quietly(*SIZE, "--sea-level", "0", "--out", "height=h.r32", "--heights", "w.r32")
        self.assertEqual([max(value, 0.0) for value in self.floats("h.r32")],
                         self.floats("w.r32"))

    def test_order_does_not_count(self):
        """A run with the same outputs in another order goes on with the same world."""
        outs = ("--out", "ridge=r.r32", "--out", "a=a.r32", "--out", "a=b.npy")
        world = (*SIZE, "--recipe", "r.recipe", "--tile", "20x20")
        self.quietly(*world, *outs)
        self.assertEqual(json.loads(self.bytes("a.r32.json"))["out"],
                         ["a=a_{y}_{x}.r32", "a=b_{y}_{x}.npy", "ridge=r_{y}_{x}.r32"])
        self.quietly(*world, *outs[4:], *outs[:4], "--resume")
        result = run("terrain", *world, *outs[2:], "--resume", cwd=self.directory)
        self.check_one_line(result, 2, "--out is [", "ridge=r_{y}_{x}.r32")

    def test_refused(self):
        recipe = ("--recipe", "r.recipe")
        self.refused(*recipe, "--out", "rigde=t.r32",
                     words=("--out: r.recipe has no output 'rigde'", "a, ridge, plain, grows, b"))
        self.refused(*recipe, "--out", "sea=t.r32", words=("--out", "'sea'"))
        self.refused(*recipe, "--out", "b=t.r32", words=("--out", "'b'", "depend on the place"))
        self.refused(*recipe, "--out", "grows=t.r16", words=("--out", "grows", ".r32"))
        self.refused(*recipe, "--out", "ridge=t.ppm", words=("--out", "'t.ppm'", ".r16"))
        for text in ("ridge", "=t.r32", "ridge=", "x" * 300 + "=t.r32"):
            self.refused(*recipe, "--out", text, words=("--out", "NAME=FILE"))
        self.refused(*recipe, *("--out", "ridge=t.r32") * 2, words=("--out", "already written"))
        self.refused(*recipe, *("--out", "ridge=t.r32") * 16, words=("--out", "at most 15"))
        self.refused("--out", "alps=t.r32", words=("--out: one noise", "it has height"))
        with open(self.path("r.recipe"), "wb") as file:
            file.write(b"recipe 1\nspace 3\nb = noise(size=9)\nout a = flat(b)\nout c = b\n")
        self.refused(*recipe, "--out", "c=t.r32", words=("--out", "'c'", "depends on z"))

    def test_grows(self):
        """What has no bound goes to floats."""
        self.quietly(*SIZE, "--recipe", "r.recipe", "--out", "grows=g.r32")
        self.assertGreater(self.floats("g.r32")[40], 39)


class Masks(OutputsCase):
    """--masks"""

    WORLD = ("--size", "41x27", "--step", "90", "--preset")
    NAMES = ("rock", "snow", "sand", "vegetation", "water")

    def masks(self, *arguments):
        """The five masks, by their names"""
        self.quietly(*self.WORLD, *arguments, "--masks", "m.npy")
        return [read_picture(self.path("m-%s.npy" % name)).flat() for name in self.NAMES]

    def test_sum(self):
        """They are 255 together, and what a preset has is there."""
        for preset, there in (("alps", "rock snow vegetation"), ("dunes", "sand"), ("mesas", "rock sand"),
                              ("islands", "rock sand vegetation water")):
            with self.subTest(preset=preset):
                masks = self.masks(preset)
                self.assertEqual({sum(pixel) for pixel in zip(*masks)}, {255})
                found = [name for name, mask in zip(self.NAMES, masks) if max(mask) > 128]
                self.assertLessEqual(set(there.split()), set(found))
                if preset != "dunes":
                    self.assertGreater(max(len(set(mask)) for mask in masks), 30)

    def test_water(self):
        """Water is where the ground is covered, and there is nothing else there."""
        *_, water = self.masks("islands")
        self.quietly(*self.WORLD, "islands", "--heights", "h.r32", "--out", "islands=dry.r32")
        covered = [wet > dry for wet, dry in zip(self.floats("h.r32"), self.floats("dry.r32"))]
        self.assertEqual(water, [255 * one for one in covered])
        self.assertEqual(set(covered), {False, True})

    def test_relief_agrees(self):
        """Snow is the brightest of the grounds that the relief shows."""
        rock, snow, _, vegetation, water = self.masks("range")
        self.quietly(*self.WORLD, "range", "--relief", "c.npy")
        colours = read_picture(self.path("c.npy")).flat()
        mean = lambda mask: sum(sum(c) for c, m in zip(colours, mask) if m == 255) / max(
            1, mask.count(255))
        self.assertGreater(min(rock.count(255), snow.count(255), vegetation.count(255)), 5)
        self.assertGreater(mean(snow), mean(vegetation))
        self.assertGreater(mean(snow), mean(rock))
        self.assertEqual(set(water), {0})

    def test_png(self):
        """Two pictures of four channels each"""
        if not has_png():
            self.refused("--preset", "alps", "--masks", "m.png", words=("--masks", "m"))
            return
        masks = self.masks("islands")
        self.quietly(*self.WORLD, "islands", "--masks", "m.png")
        first, second = (read_picture(self.path("m-%d.png" % n)) for n in (1, 2))
        self.assertEqual(first.shape(), (41, 27, 4, 8))
        self.assertEqual(first.flat(), list(zip(*masks[:4])))
        self.assertEqual(second.flat(), [(water, 0, 0, 0) for water in masks[4]])

    def test_names(self):
        grey = self.extensions[0]
        for stem, names in (("m", ["m-%s" + grey]), ("d/{y}_{x}.img", ["d/0_0-%s.img", "d/0_0-%s.hdr"]),
                            ("m.tif", ["m-%s.tif"])):
            self.quietly("--size", "9x9", "--preset", "alps", *(["--tile", "9x9"] * ("{" in stem)),
                         "--masks", stem)
            for name in self.NAMES:
                for pattern in names:
                    self.assertGreater(len(self.bytes(pattern % name)), 80)

    def test_refused(self):
        with open(self.path("p.txt"), "w", encoding="utf-8") as file:
            file.write("0 1 2 3\n100 4 5 6\n")
        result = run("terrain", *SMALL, "--palette", "p.txt", "--masks", "m", cwd=self.directory)
        self.check_one_line(result, 2, "--masks", "--palette")
        for stem in ("-", "d/", "m.jpg", "m.r16", "m.ppm"):
            result = run("terrain", *SMALL, "--masks", stem, cwd=self.directory)
            self.check_one_line(result, 2, "--masks")
        self.assertEqual(self.files(), ["p.txt", "r.recipe"])


class Slopes(OutputsCase):
    """--slope and --curvature"""

    PLACE = ("--size", "41x27", "--frequency", "0.03", "--octaves", "4", "--rotate")

    def test_slope(self):
        """The angle of the gradient, to a float's precision; integers divide 90 degrees."""
        for height in ("0.001", "40", "90000"):
            result = run("terrain", *self.PLACE, "--height", height, "--gradient", "g.npy",
                         "--slope", "s.r32", cwd=self.directory)
            self.assertEqual((result.returncode, result.stderr), (0, b""))
            for found, (dx, dy) in zip(self.floats("s.r32"),
                                       read_picture(self.path("g.npy")).flat()):
                exact = math.degrees(math.atan(math.hypot(dx, dy)))
                self.assertLessEqual(abs(found - exact), 2 ** -24 * exact * 1.001, (dx, dy))
        result = run("terrain", *self.PLACE, "--height", "40", "--slope", "s.r16",
                     cwd=self.directory)
        self.assertIn(b"16-bit slope: 0 is 0, 65535 is 90\n", result.stdout)
        self.quietly(*self.PLACE, "--height", "40", "--slope", "s.r32")
        self.assertEqual(Picture(41, 27, 1, U16_LOW, self.bytes("s.r16")).flat(),
                         [math.floor(value / 90 * 65535 + 0.5) for value in self.floats("s.r32")])

    def test_water_is_level(self):
        self.quietly(*self.PLACE, "--sea-level", "0", "--heights", "h.r32", "--slope", "s.r32",
                     "--curvature", "c.r32")
        under = [height == 0 for height in self.floats("h.r32")]
        for name in ("s.r32", "c.r32"):
            values = self.floats(name)
            self.assertEqual({value for value, wet in zip(values, under) if wet}, {0.0})
            self.assertNotIn(0.0, [value for value, wet in zip(values, under) if not wet])

    def test_sphere(self):
        """On top of a sphere of radius R, 1 / R: a recipe that is one there, nearly. Hollows have
        the other sign."""
        for sign in (1, -1):
            text = "recipe 1\nout a = %d * 40 * (noise(size=4096) - 1.5 * clamp((x^2 + y^2) / " \
                   "3200, -2, 2))\n" % sign
            with open(self.path("r.recipe"), "w", encoding="utf-8") as file:
                file.write(text)
            self.quietly("--size", "1x1", "--recipe", "r.recipe", "--curvature", "c.r32",
                         "--gradient", "g.npy")
            found, = self.floats("c.r32", 1, 1)
            self.assertGreater(sign * found, 0)
            self.assertLess(abs(sign * found - 1.5 * 40 * 2 / 3200), 1e-3 * 0.0375)

    def test_formula(self):
        """The mean curvature of the Hessian that scarp sample prints"""
        self.quietly(*self.PLACE, "--height", "1", "--curvature", "c.r32")
        points = "".join("%d,%d\n" % (x, 26 - y) for y in range(27) for x in range(41))
        result = run("sample", "--seed", "1", "--frequency", "0.03", "--octaves", "4", "--rotate", "--gain", "0.4",
                     "--gradient", "--hessian", input=points.encode())
        rows = [[float(word) for word in line.split(",")] for line in
                result.stdout.decode().split() if line[0] in "-0123456789"]
        self.assertEqual(len(rows), 41 * 27)
        largest = max(abs(value) for value in self.floats("c.r32"))
        for found, (_, fx, fy, fxx, fxy, fyy) in zip(self.floats("c.r32"), rows):
            square = 1 + fx * fx + fy * fy
            bend = (1 + fy * fy) * fxx - 2 * fx * fy * fxy + (1 + fx * fx) * fyy
            self.assertLess(abs(found + bend / (2 * square ** 1.5)), 1e-6 * largest)

    def test_refused(self):
        for words in (("--fractal", "erosion"), ("--preset", "alps"),
                      ("--fractal", "swiss")):
            self.refused(*words, "--curvature", "c.r32", words=("--curvature", "second derivatives"))
        self.refused("--curvature", "c.r16", words=("--curvature", ".r32"))
        self.refused("--slope", "s.ppm", words=("--slope", ".r16"))


common.main(globals())
