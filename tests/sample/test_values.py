# SPDX-License-Identifier: MIT
"""Kinds of files, numbers and options: each point gets what the library gives there."""
import ctypes
import itertools
import math
import os
import random
import re
import struct
import subprocess
import sys
import unittest

import common
from common import (run, float32, reference, npy, read_npy, make_input, read_output,
                    some_points, Case, BLOCK, KINDS, ENDS, RESULTS, BY_PHASE, TYPED, MEANT,
                    FLOWING, FLOWING_MEANT)


class Help(Case):
    OPTIONS = ("input input-format delimiter columns dims skip-bad keep output output-format gradient "
               "hessian dphase preset recipe set scale print-recipe seed basis jitter fade fractal erosion sharpness frequency "
               "octaves of-octaves lacunarity gain "
               "phase rotate amplitude period isa quiet help").split()

    def test_help(self):
        text = self.text(b"", "--help")
        self.assertTrue(text.startswith("usage: scarp sample [options]\n"))
        self.assertEqual(re.findall(r"(?m)^  --(\S+)", text), self.OPTIONS)
        self.assertEqual(re.findall(r"(?m)^([a-z][^\n]*):$", text),
                         ["points", "results", "the noise",
                          "one noise, without --preset and --recipe", "running"])
        self.assertIn("\n  --seed ", text.split("\none noise,")[0])  # recipes have one, too
        self.assertLessEqual(max(len(line) for line in text.split("\n")), 90)
        for dims in (2, 3):
            self.assertIn("  in %dD  %s\n" % (dims, " ".join((*RESULTS[dims], BY_PHASE))), text)

    def test_listed(self):
        usage = subprocess.run(common.PROGRAM + ["--help"], stdout=subprocess.PIPE,
                               check=True).stdout
        self.assertRegex(usage.decode(), r"(?m)^  sample  ")


class Formats(Case):
    """Every kind of input into every kind of output."""

    def test_all(self):
        for dims, kind, out, keep in itertools.product((2, 3), KINDS, KINDS, (False, True)):
            for count in (1, 7):
                with self.subTest(dims=dims, kind=kind, out=out, keep=keep, count=count):
                    self.check(some_points(dims, count), kind, out, keep)

    def check(self, points, kind, out, keep):
        dims = len(points[0])
        data = make_input(kind, points, header=True)
        target = self.path("out" + ENDS[out])
        arguments = ["--gradient", "--hessian", "--output", target]
        self.assertEqual(self.sample(data, *arguments, *(["--keep"] if keep else [])), b"")
        header, rows = read_output(out, self.read(target))
        names = ["x", "y", "z"][:dims] * keep + RESULTS[dims]
        self.assertEqual(header, names if out == "csv" else None)
        self.assertEqual([len(row) for row in rows], [len(names)] * len(points))
        if keep:
            self.assertEqual([tuple(row[:dims]) for row in rows], points)
        if out == "npy":
            self.assertEqual(read_npy(self.read(target))[0], "<f8" if keep else "<f4")
        text = self.text(make_input("text", points), "--gradient", "--hessian")
        plain = [[float32(float(field)) for field in line.split()] for line in text.splitlines()]
        self.assertEqual([[float32(number) for number in row[len(row) - len(RESULTS[dims]):]]
                          for row in rows], plain)

    def test_which_format(self):
        """The option beats the name, the name the input."""
        csv, text = b"x,y\n1.5,2\n", b"1.5 2\n"
        value = self.text(text)
        self.assertEqual(self.text(csv), "value\n" + value)
        self.assertEqual(self.text(csv, "--output-format", "text"), value)
        self.assertEqual(self.text(text, "--output-format", "csv"), "value\n" + value)
        self.sample(text, "--output", self.path("a.csv"))
        self.assertEqual(self.read("a.csv").decode(), "value\n" + value)
        self.sample(text, "--output", self.path("b.dat"))
        self.assertEqual(self.read("b.dat").decode(), value)
        self.sample(text, "--output", self.path("c.csv"), "--output-format", "npy")
        self.assertEqual(read_npy(self.read("c.csv"))[2], [[float32(float(value))]])
        self.assertEqual(read_npy(self.sample(npy([(1.5, 2)])))[2], [[float32(float(value))]])
        self.assertEqual(self.sample(npy([(1.5, 2)]), "--output-format", "csv").decode(),
                         "value\n" + value)
        self.check_refused(csv, "'x,y'", arguments=("--input-format", "text"))
        self.check_refused(text, "1 column", arguments=("--input-format", "csv"))
        self.check_refused(text, ".npy", arguments=("--input-format", "npy"))
        self.check_refused(npy([(1, 2)]), ":1: ", arguments=("--input-format", "csv"))
        for end, kind in ((".csv", "csv"), (".txt", "text")):
            self.write("in" + end, csv if kind == "text" else text)  # the name says nothing here
            self.sample(b"", "--input", self.path("in" + end))

    def test_columns(self):
        for dims in (2, 3):
            line = " ".join(["0.25"] * dims)
            for options, names in ((("--gradient",), RESULTS[dims][:dims + 1]),
                                   (("--hessian",), ["value"] + RESULTS[dims][dims + 1:]),
                                   ((), ["value"]),
                                   (("--hessian", "--gradient"), RESULTS[dims])):
                every = dict(zip(RESULTS[dims],
                                 self.text(line, "--gradient", "--hessian").split()))
                lines = self.text(line, *options, "--output-format", "csv").split()
                self.assertEqual(lines, [",".join(names),
                                         ",".join(every[name] for name in names)])

    def test_empty(self):
        """No points: what an empty table looks like."""
        for data in (b"", b"\n\n", b"# nothing\n", b"\xef\xbb\xbf", b"  \t\r\n"):
            self.assertEqual(self.sample(data), b"")
            self.assertEqual(self.sample(data, "--output-format", "csv", "--keep", "--gradient"),
                             b"x,y,value,dx,dy\n")
            self.assertEqual(self.sample(data, "--output-format", "csv", "--keep", "--dims", "3"),
                             b"x,y,z,value\n")
            self.assertEqual(self.sample(data, "--input-format", "csv"), b"value\n")
            for dims, columns in ((), 3), (("--dims", "3"), 4):
                self.sample(data, "--gradient", "--output", self.path("e.npy"), *dims)
                self.assertEqual(read_npy(self.read("e.npy")), ("<f4", columns, []))
        self.assertEqual(self.sample(b"x,y\n", "--keep"), b"x,y,value\n")
        self.assertEqual(self.sample(b"x,y\n", "--output-format", "text"), b"")


def offset_of(seed):
    """o_0 of the plane, in cells: "Seeds" of scarp.h has the numbers that octave 0 draws."""
    def number(start, count):
        z = (start + count * 0x9e3779b97f4a7c15) % 2 ** 64
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9 % 2 ** 64
        z = (z ^ z >> 27) * 0x94d049bb133111eb % 2 ** 64
        return z ^ z >> 31
    stream = number(seed, 1)
    return (number(stream, 2) >> 40) / 2 ** 24, number(stream, 3) % 2 ** 24 / 2 ** 24


class Values(Case):
    """What is written is what the library gives."""

    @unittest.skipUnless(sys.argv[2:3] != ["-"], "the library cannot be loaded")
    def test_library(self):
        for dims in (2, 3):
            points = some_points(dims, 2 * BLOCK + 37)
            for kind in KINDS:
                with self.subTest(dims=dims, kind=kind):
                    out = self.sample(make_input(kind, points), *TYPED, "--gradient", "--hessian")
                    _, rows = read_output(kind, out)
                    rows = [[float32(number) for number in row] for row in rows]
                    self.assertEqual(rows == reference(points, RESULTS[dims], **MEANT), True)
                    out = self.sample(make_input(kind, points), *FLOWING, "--gradient", "--hessian")
                    _, rows = read_output(kind, out)
                    rows = [[float32(number) for number in row] for row in rows]
                    names = (*RESULTS[dims], BY_PHASE)
                    self.assertEqual(rows == reference(points, names, **FLOWING_MEANT), True)
            rows = read_output("npy", self.sample(npy(points)))[1]
            self.assertEqual(rows == reference(points, ["value"]), True)

    def test_differences(self):
        """The gradient and the Hessian are those of the values and of the gradient."""
        h = 2.0 ** -8
        for dims in (2, 3):
            points = some_points(dims, 50)
            around = [tuple(c + sign * h * (d == axis) for d, c in enumerate(point))
                      for point in points for axis in range(dims) for sign in (-1, 1)]
            options = ("--gradient", "--hessian", "--frequency", "0.1", "--seed", "5")
            here = read_output("text", self.sample(make_input("text", points), *options))[1]
            there = read_output("text", self.sample(make_input("text", around), *options))[1]
            names = RESULTS[dims]
            for i, row in enumerate(here):
                for a in range(dims):
                    before, after = there[2 * (i * dims + a):][:2]
                    slopes = [(q - p) / (2 * h) for p, q in zip(before, after)]
                    self.assertAlmostEqual(row[1 + a], slopes[0], delta=1e-4)
                    for b in range(a, dims):
                        second = names.index("d" + "xyz"[a] + "xyz"[b])
                        self.assertAlmostEqual(row[second], slopes[1 + b], delta=1e-4)

    def test_lattice(self):
        """Gradient noise is 0 on the lattice, which the seed moves, and another noise where the
        seed is another."""
        for seed in (0, 7):
            x, y = offset_of(seed)
            lattice = "".join("%r %r\n" % (i - x, -3 * i - y) for i in range(9))
            self.assertEqual({float(v) for v in self.text(lattice, "--seed", str(seed)).split()},
                             {0.0})
        self.assertNotEqual(float(self.text("0 0")), 0.0)
        self.assertNotEqual(self.text("0.5 0.5"), self.text("0.5 0.5", "--seed", "2"))
        self.assertEqual(self.text("0.5 0.5"), self.text("0.5 0.5", "--seed", "0"))

    def test_double_precision(self):
        """Far from the origin a quarter of a cell still counts, and cells repeat after 2^32."""
        for kind in KINDS:
            points = [(2.0 ** 34 + 0.25, 0.5), (2.0 ** 34, 0.5), (0.25, 0.5), (0.0, 0.5)]
            rows = read_output(kind, self.sample(make_input(kind, points)))[1]
            self.assertGreater(abs(rows[0][0] - rows[1][0]), 0.01)
            for far, near in zip(rows, rows[2:]):
                self.assertAlmostEqual(far[0], near[0], delta=1e-5)  # doubles have 2^-19 there

    def test_instruction_sets(self):
        points = make_input("npy", some_points(3, 500))
        info = subprocess.run(common.PROGRAM + ["info"], stdout=subprocess.PIPE,
                               check=True).stdout
        isas = re.findall(r"(?m)^(\S+) +yes ", info.decode())
        self.assertIn("scalar", isas)
        outputs = {self.sample(points, *TYPED, "--hessian", "--isa", isa) for isa in isas}
        self.assertEqual(len(outputs), 1)


class Recipes(Case):
    """Presets and recipes at points"""

    def terrain(self, *arguments):
        """Heights and slopes of `scarp terrain` at 4 by 3 places, from the bottom left one"""
        subprocess.run(common.PROGRAM + ["terrain", "--size", "4x3", "--step", "250", "--origin",
                                         "1000,500", "--quiet", *arguments, "--heights", "h.r32",
                                         "--gradient", "g.img"], cwd=self.directory, check=True)
        heights = struct.unpack("<12f", self.read("h.r32"))
        slopes = struct.unpack("<24f", self.read("g.img"))
        flat = [[h, slopes[2 * i], slopes[2 * i + 1]] for i, h in enumerate(heights)]
        return [row for line in (flat[8:], flat[4:8], flat[:4]) for row in line]

    POINTS = [(1000.0 + 250 * i, 500.0 + 250 * j) for j in range(3) for i in range(4)]

    def test_terrain(self):
        """The same as of `scarp terrain`, the sea included"""
        for words in (["--preset", "islands"], ["--preset", "alps", "--seed", "7"],
                      ["--preset", "dunes", "--set", "height=5", "--scale", "2"]):
            rows = read_output("npy", self.sample(npy(self.POINTS), *words, "--gradient"))[1]
            self.assertEqual(rows, self.terrain(*words), words)

    def test_hessian(self):
        text = "recipe 1\nout a = noise(size=9, octaves=3)^2 - %s\n"
        self.write("r.recipe", (text % "0").encode())
        words = ["--recipe", self.path("r.recipe"), "--seed", "5", "--gradient", "--hessian"]
        points = some_points(2, 40)
        rows = read_output("npy", self.sample(npy(points), *words))[1]
        noise = read_output("npy", self.sample(npy(points), "--seed", "5", "--octaves", "3",
                                               "--frequency", repr(1 / 9), *words[4:]))[1]
        for row, (v, dx, dy, dxx, dxy, dyy) in zip(rows, noise):
            for found, meant in zip(row, (v * v, 2 * v * dx, 2 * v * dy, 2 * (v * dxx + dx * dx),
                                          2 * (v * dxy + dx * dy), 2 * (v * dyy + dy * dy))):
                self.assertAlmostEqual(found, meant, delta=2e-6)

    def test_space(self):
        self.write("s.recipe", b"recipe 1\nspace 3\nout a = noise(octaves=2) + z\n")
        points = some_points(3, 40)
        rows = read_output("npy", self.sample(npy(points), "--recipe", self.path("s.recipe"),
                                              "--gradient"))[1]
        noise = read_output("npy", self.sample(npy(points), "--seed", "1", "--octaves", "2",
                                               "--gradient"))[1]
        for row, one, point in zip(rows, noise, points):
            self.assertEqual(row[1:3], one[1:3])
            self.assertAlmostEqual(row[0], one[0] + point[2], delta=1e-5)

    def test_refused(self):
        self.write("s.recipe", b"recipe 1\nspace 3\nout a = noise()\n")
        self.write("e.recipe", b"recipe 1\nout a = noise(erosion, octaves=2)\n")
        space, erosion = self.path("s.recipe"), self.path("e.recipe")
        for points, words, told in (
                ("1 2\n", ["--recipe", space], "points have no z"),
                ("1 2 3\n", ["--preset", "alps"], "--dims 2"),
                ("1 2\n", ["--recipe", erosion, "--hessian"], "no second derivatives"),
                ("1 2\n", ["--preset", "alps", "--dphase"], "--dphase"),
                ("1 2\n", ["--preset", "alps", "--octaves", "3"], "--octaves"),
                ("1 2\n", ["--preset", "alps", "--period", "4,4"], "--period"),
                ("1 2\n", ["--preset", "alps", "--set", "x=1"], "no parameter 'x'"),
                ("1 2\n", ["--set", "x=1"], "needs --preset"),
                ("1 2\n", ["--scale", "2"], "needs --preset"),
                ("1 2\n", ["--recipe", "no.recipe"], "no.recipe"),
                ("1 2\n", ["--warp-reach", "2"], "warp(")):
            self.check_refused(points, told, arguments=words)


class Numbers(Case):
    """How numbers are read and written."""

    def test_read(self):
        """As Python reads them; .npy takes them as they are."""
        numbers = random.Random(7)
        words = ("0 -0 +1 1. .5 -.5 1e0 1E+2 25e-2 00012 0.1 1234567890123456789 "
                 "12345678901234567890123 9007199254740993 -9007199254740993.5 1e15 1e-300 1e-400 "
                 "0.000000000000000000001 1234.56789012345678 123456789012345.678 2e0001").split()
        words += [repr(numbers.uniform(-1e6, 1e6)) for _ in range(500)]
        words += ["%.6f" % numbers.uniform(-1e6, 1e6) for _ in range(500)]
        words += ["%.19g" % numbers.uniform(-1, 1) for _ in range(500)]
        words += ["%d" % numbers.randrange(-10 ** 18, 10 ** 18) for _ in range(100)]
        words += ["%.3e" % numbers.uniform(-1, 1) for _ in range(100)]
        target = self.path("o.npy")
        self.sample("".join(word + ",0\n" for word in words), "--keep", "--output", target)
        read = [row[0] for row in read_npy(self.read("o.npy"))[2]]
        self.assertEqual([struct.pack("<d", number) for number in read],
                         [struct.pack("<d", float(word)) for word in words])

    def test_written(self):
        """%.9g of the floats that .npy holds, for values of every size."""
        points = [(x, y) for x, y in some_points(2, 3000)] + [(i / 64.0, 0.5) for i in range(200)]
        for amplitude in ("1", "-0.001953125", "6e-8", "1000", "70000.5", "16777216"):
            options = ("--gradient", "--hessian", "--frequency", "0.7", "--amplitude", amplitude)
            held = read_npy(self.sample(npy(points), *options))[2]
            words = self.text(npy(points), *options, "--output-format", "text").split("\n")
            self.assertEqual(words.pop(), "")
            expected = [" ".join("%.9g" % number for number in row) for row in held]
            self.assertEqual([pair for pair in zip(words, expected) if pair[0] != pair[1]], [])

    def test_not_finite(self):
        """No coordinate, in any format: an error, or left out."""
        for kind, number in itertools.product(KINDS, (math.nan, -math.nan, math.inf, -math.inf)):
            data = make_input(kind, [(0.5, 2.5), (3.5, number), (number, 1.5)], header=True)
            arguments = ("--keep", "--output", self.path("o.npy"))
            self.check_refused(data, "column 2: '%s' is not a finite number" % repr(number),
                               arguments=arguments)
            self.assertEqual(self.files(), [])
            self.sample(data, "--skip-bad", *arguments,
                        error=b"scarp: --skip-bad: 2 malformed %s of standard input were left out\n"
                        % (b"points" if kind == "npy" else b"lines"))
            rows = read_npy(self.read("o.npy"))[2]
            self.assertEqual([row[:2] for row in rows], [[0.5, 2.5]])
            os.remove(self.path("o.npy"))

    def test_malformed(self):
        for word in ("nan", "NaN", "-nan", "inf", "-inf", "Infinity", "1e999", "-1e999", "0x10",
                     "0x1p3", "1e", "1e+", "1.2.3", "--1", "+-1", "1,5,5", ",5", "1,", "1.5,5", "1,5.5", ".", "-", "1d5", "1_0",
                     "one", "1;2", "'1'"):
            self.check_refused("1 2\n3 %s\n" % word, "standard input:2: column 2: '%s'" % word,
                               output=self.sample("1 2"), arguments=("--input-format", "text"))

    def test_overflow(self):
        """A finite coordinate may lie beyond every cell. A NaN has no sign, in any format."""
        options = ("--frequency", "2e14", "--gradient")
        points = [(1e300, 0.5), (-1e300, 0.5), (0.5, 0.5)]
        for kind in KINDS:
            lines = self.text(make_input(kind, points), *options, "--output-format", "text")
            self.assertEqual(lines.split("\n")[:2], ["nan nan nan"] * 2)
            self.assertNotIn("nan", lines.split("\n")[2])
        held = self.sample(npy(points), *options)
        self.assertEqual(held[-36:-12], struct.pack("<I", 0x7fc00000) * 6)

    def test_precision_kept(self):
        """Coordinates of .npy in text: all digits of a double, nine of a float."""
        point = (0.1, 1.0 / 3)
        line = self.text(npy([point]), "--keep", "--output-format", "text").split()
        self.assertEqual(line[:2], ["%.17g" % number for number in point])
        line = self.text(npy([point], "<f4"), "--keep", "--output-format", "text").split()
        self.assertEqual(line[:2], ["%.9g" % float32(number) for number in point])


# The library's octaves are floats above 0, at most 32, and a 0 would mean the default.
OCTAVES_REFUSED = ("0", "-0", "7.006e-46", "1e-46", "1e-400", "-1e-45", "32.000001", "33",
                   "nan", "inf")
OCTAVES_TAKEN = ("1e-45", "7.0065e-46", "1.5e-45", "1e-40", "1.1754943e-38", "0.5", "1", "32")


class Options(Case):
    """Command lines that ask for what is not possible: refused before anything is read."""

    def check(self, *arguments):
        """Standard input stays open: a run that waited for it would not end."""
        ours, theirs = os.pipe()
        try:
            result = subprocess.run(common.PROGRAM + ["sample", *arguments], stdin=ours, timeout=60,
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        finally:
            os.close(ours)
            os.close(theirs)
        self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
        self.assertRegex(result.stderr.decode(), r"\Ascarp: %s[:,] ?[^\n]+\n\Z" %
                         re.escape(arguments[0].split("=")[0]))

    def test_values(self):
        for option, values in (("--dims", ("1", "4", "0", "two", "", "2.5", "-2")),
                               ("--input-format", ("CSV", "txt", "", "json")),
                               ("--output-format", ("CSV", "txt", "", "png")),
                               ("--isa", ("sse9", "none", "")),
                               ("--input", ("",)), ("--output", ("",)),
                               ("--seed", ("-9223372036854775809", "x")),
                               ("--octaves", OCTAVES_REFUSED),
                               ("--columns", ("x", "1,1", "x,y,z,w", "0,1", "")),
                               ("--phase", ("", "x", "nan", "inf", "-inf", "1e39")),
                               ("--fractal", ("fBm",)), ("--frequency", ("0", "nan"))):
            self.check(option)
            for value in values:
                self.check(option, value)
                self.check(option + "=" + value)
        for flag in ("--keep", "--skip-bad", "--gradient", "--hessian", "--dphase", "--quiet"):
            self.check(flag + "=1")
        self.check("--size", "3")
        self.check("points.csv")

    def test_octaves(self):
        """Each that the library takes; the bound is named in the same words everywhere."""
        points = some_points(2, 20)
        data, options = make_input("text", points), ("--gradient", "--lacunarity", "1.5")
        for word in OCTAVES_TAKEN:
            rows = read_output("text", self.sample(data, "--octaves", word, *options))[1]
            if common.LIBRARY != "-":
                held = ctypes.c_float(float(word)).value
                self.assertGreater(held, 0)
                expected = reference(points, RESULTS[2][:3], octaves=held, lacunarity=1.5)
                self.assertEqual([[float32(number) for number in row] for row in rows], expected)
        for word in OCTAVES_REFUSED:
            self.check_refused(b"", "scarp: --octaves: '%s' is not a number above 2^-150, at most "
                               "32\n" % word, arguments=("--octaves", word))
        text = re.sub(r"\s+", " ", self.text(b"", "--help"))
        self.assertRegex(text, r"--octaves F [^\[]*; above 2\^-150, at most 32 \[1\]")

    def test_hessian_of_erosion(self):
        for fractal in ("erosion", "swiss", "jordan"):
            self.check("--hessian", "--fractal", fractal)
            self.sample("1 2\n", "--gradient", "--fractal", fractal)
        for fractal in ("swiss", "jordan"):
            self.check("--dphase", "--fractal", fractal)

    def test_erosion_of_jordan(self):
        self.check("--erosion=1.5", "--fractal", "jordan")
        self.sample("1 2\n", "--erosion", "1", "--fractal", "jordan")
        self.sample("1 2\n", "--gradient", "--fractal", "erosion")

    def test_value_noise_does_not_flow(self):
        self.check("--phase", "0.5", "--basis", "value")
        self.check("--dphase", "--basis", "value")

    def test_last_octave(self):
        self.check("--frequency", "2e14", "--octaves", "2")


common.main(globals())
