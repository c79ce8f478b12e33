# SPDX-License-Identifier: MIT
"""Noise that flows: --phase of both commands, and --dphase."""
import array
import json
import math
import re

import common
from common import FRACTALS, SMALL, Case, run
from rasters import read_picture

FILES = ("--heights", "h.npy", "--normals", "n.npy", "--hillshade", "s.pgm",
         "--gradient", "g.npy")
KINDS = ([], ["--rotate", "--fade", "cubic", "--amplitude", "-3"], ["--period", "20x10"],
         *(["--fractal", fractal] for fractal in FRACTALS[1:]))
# How far noise reaches in 2D, by fade; include/scarp.h, "Flow"
REACH = {"quintic": 1.0169038, "cubic": 1.0162356}


def floats(data):
    values = array.array("f")
    values.frombytes(data)
    return values


class Phase(Case):
    def frame(self, phase, *arguments):
        """All layers of a frame, 16-bit heights included; no --phase if that is None."""
        words = [*SMALL, *arguments, *([] if phase is None else ["--phase", str(phase)])]
        self.quietly(*words, *FILES)
        self.quietly(*words, "--heights", "h.r16", "--normals", "n.ppm")
        return self.all_bytes()

    def heights(self, phase, *arguments):
        """Values of the noise"""
        return floats(self.layer("--heights", "h.r32", *SMALL, *arguments, "--height", "1",
                                 "--phase", str(phase)))

    def test_loop(self):
        """A whole turn later all layers are the same, to the byte."""
        for arguments in KINDS:
            with self.subTest(arguments=arguments):
                first = self.frame(0, *arguments)
                whole = ["1"] if arguments else ["1", "-1", "24", "3.4e38", "-0", "1e-60"]
                for turns in whole:
                    self.check_same_files(self.frame(turns, *arguments), first)
                later = self.frame("0.25", *arguments)
                for turns in ("1.25", "-0.75"):
                    self.check_same_files(self.frame(turns, *arguments), later)
                for name in first:
                    self.assertNotEqual(later[name], first[name], name)

    def test_phase_0(self):
        """The noise is that without a phase; its 16-bit heights have the scale of the others."""
        # [0, 1], and [-1, 1] where octaves are folded
        unscaled = {"ridged", "swiss", "pingpong"}
        for arguments in KINDS:
            with self.subTest(arguments=arguments):
                still, first = self.frame(None, *arguments), self.frame(0, *arguments)
                scaled = still.pop("h.r16") != first.pop("h.r16")
                self.assertEqual(scaled, unscaled.isdisjoint(arguments))
                self.check_same_files(first, still)

    def told(self, *arguments):
        """What 0 and 65535 stand for, as printed and in the manifest, which must agree"""
        result = run("terrain", *SMALL, *arguments, "--tile", "40x30", "--heights", "w.r16",
                     cwd=self.directory)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        printed = re.search(rb"16-bit heights: 0 is (\S+), 65535 is (\S+)\n", result.stdout)
        manifest = json.loads(self.bytes("w.r16.json"))
        ends = [float(number) for number in printed.groups()]
        self.assertEqual(manifest["derived"]["16-bit heights"], ends)
        return ends, [end / manifest["height"] for end in manifest["derived"]["range"]], manifest["phase"]

    def test_scale(self):
        """All frames have one scale, which is printed and is that of the samples."""
        for fade, fractal, low, amplitude in (("quintic", "fbm", -1, 1), ("cubic", "fbm", -1, 1),
                                              ("quintic", "erosion", -1, 1),
                                              ("quintic", "turbulence", 0, 3),
                                              ("quintic", "ridged", 0, 1)):
            options = ["--fade", fade, "--fractal", fractal, "--height", "64", "--amplitude",
                       str(amplitude)]
            reach = 1 if fractal == "ridged" else REACH[fade]
            for phase in (0, 0.5, -0.001):
                with self.subTest(options=options, phase=phase):
                    ends, limits, noted = self.told(*options, "--phase", str(phase))
                    self.assertEqual(noted, phase)
                    for end, limit, sign in zip(ends, limits, (low, 1)):
                        self.assertAlmostEqual(limit, sign * amplitude * reach, delta=1e-6)
                        self.assertAlmostEqual(end, 64 * limit, delta=1e-4)
                    exact = self.layer("--heights", "h.r32", *SMALL, *options, "--phase",
                                       str(phase))
                    step = (ends[1] - ends[0]) / 65535
                    held = array.array("H")
                    held.frombytes(self.bytes("w_0_0.r16"))
                    for grey, height in zip(held, floats(exact)):
                        self.assertLessEqual(abs(ends[0] + grey * step - height), 0.5001 * step)
                self.clear()
            ends, limits, noted = self.told(*options)
            self.assertEqual((limits, noted), ([low * amplitude, amplitude], None))
            self.clear()

    def test_levels(self):
        """The sea and the plateau bound 16-bit heights as they do without a phase."""
        ends, _, _ = self.told("--sea-level", "0.05", "--plateau", "0.5", "--height", "64",
                               "--phase", "0.3")
        self.assertEqual([common.rounded(end) for end in ends], [common.rounded(3.2), 32])

    def test_neighbours(self):
        """Values move no faster than the bound of scarp.h, and they do move."""
        h = 2.0 ** -9
        for fractal in ("fbm", "turbulence"):
            for octaves, gain in ((1, 0.5), (2, 0.5), (4, 0.25)):
                options = ["--fractal", fractal, "--octaves", str(octaves), "--gain", str(gain)]
                weights = [gain ** k for k in range(octaves)]
                speed = sum(w * 2 ** k for k, w in enumerate(weights)) / sum(weights)
                most = h * 4 * math.pi * speed * REACH["quintic"] + 2.0 ** -20
                self.assertLess(most, 0.1)
                phase, far = -0.25, 0.0
                before = self.heights(phase, *options)
                for _ in range(4):
                    phase += h
                    frame = self.heights(phase, *options)
                    far = max(far, *(abs(a - b) for a, b in zip(frame, before)))
                    before = frame
                self.assertLess(far, most, options)
                self.assertGreater(far, most / 20, options)

    def test_tileable(self):
        """Copies fit at any phase."""
        for phase in ("0", "0.3", "-17.77"):
            for arguments in ([], ["--fractal", "turbulence", "--frequency", "0.05"]):
                with self.subTest(phase=phase, arguments=arguments):
                    self.check_copies("--phase", phase, *arguments)

    def check_copies(self, *arguments):
        pictures = []
        for words in (("--size", "64x32", "--tileable"), ("--size", "128x64", "--period", "64x32")):
            self.quietly(*arguments, *words, "--heights", "h.pgm", "--normals", "n.ppm",
                         "--hillshade", "s.pgm")
            pictures.append([read_picture(self.path(name)).rows
                             for name in ("h.pgm", "n.ppm", "s.pgm")])
        for one, four in zip(*pictures):
            self.assertGreater(len({grey for row in one for grey in row}), 10)
            self.check_rows(four, [row * 2 for row in one] * 2)

    def test_tiles(self):
        """Tiles of a frame are the same as the whole."""
        self.quietly(*SMALL, "--phase", "0.7", "--heights", "whole.r32")
        self.quietly(*SMALL, "--phase", "0.7", "--tile", "20x30", "--heights", "t.r32")
        whole = floats(self.bytes("whole.r32"))
        for x in range(2):
            self.assertEqual(list(floats(self.bytes("t_0_%d.r32" % x))),
                             [whole[40 * r + 20 * x + c] for r in range(30) for c in range(20)])


class Flow(Case):
    """Points that flow: `scarp sample`."""

    def sample(self, points, *arguments):
        """Rows of numbers"""
        text = "".join(" ".join(map(repr, point)) + "\n" for point in points)
        result = run("sample", *arguments, input=text.encode())
        self.assertEqual((result.returncode, result.stderr), (0, b""), arguments)
        return [[float(word) for word in line.split()]
                for line in result.stdout.decode().splitlines()]

    def points(self, dims):
        return [tuple(0.37 * i - 7 + 0.61 * d * (i % 7) for d in range(dims)) for i in range(60)]

    def test_raster(self):
        """Points have the values and the slopes of the raster."""
        size, options = (7, 5), ["--seed", "9", "--frequency", "0.3", "--octaves", "3", "--rotate",
                                 "--gain", "0.6", "--phase", "0.4"]
        for fractal in FRACTALS:
            with self.subTest(fractal=fractal):
                self.quietly("--size", "%dx%d" % size, "--origin", "-2,3", "--step", "0.25",
                             "--height", "1", *options, "--fractal", fractal, "--heights", "h.npy",
                             "--gradient", "g.npy")
                points = [(-2 + 0.25 * c, 3 + 0.25 * (size[1] - 1 - r))
                          for r in range(size[1]) for c in range(size[0])]
                rows = self.sample(points, *options, "--fractal", fractal, "--gradient")
                value, slope = (floats(self.bytes(name)[-4 * count * len(points):])
                                for name, count in (("h.npy", 1), ("g.npy", 2)))
                self.assertEqual([[common.rounded(number) for number in row] for row in rows],
                                 [[v, *slope[2 * i:2 * i + 2]] for i, v in enumerate(value)])

    @staticmethod
    def flowing():
        """The fractals with a derivative with respect to the phase"""
        return [fractal for fractal in FRACTALS if run(
            "sample", "--fractal", fractal, "--dphase", input=b"0 0\n").returncode == 0]

    def test_loop(self):
        flowing = self.flowing()
        self.assertIn("erosion", flowing)
        for dims in (2, 3):
            for fractal in flowing:
                options = ["--fractal", fractal, "--octaves", "3", "--gradient", "--dphase"]
                still = self.sample(self.points(dims), *options)
                for turns in ("0", "1", "-5"):
                    self.assertEqual(self.sample(self.points(dims), *options, "--phase", turns),
                                     still)
                self.assertNotEqual(self.sample(self.points(dims), *options, "--phase", "0.5"),
                                    still)

    def test_dphase(self):
        """It is the slope of the values of two runs, one a little before and one after."""
        h = 2.0 ** -11
        for dims in (2, 3):
            for fractal in self.flowing():
                for phase in (0.0, 0.375, -3.0625):
                    with self.subTest(dims=dims, fractal=fractal, phase=phase):
                        self.check_dphase(dims, phase, h, "--fractal", fractal, "--octaves", "2",
                                          "--seed", "5")

    def check_dphase(self, dims, phase, h, *options):
        points = self.points(dims)
        rows = self.sample(points, *options, "--dphase", "--phase", str(phase))
        found = [row[-1] for row in rows]
        after, before = (self.sample(points, *options, "--phase", str(phase + sign * h))
                         for sign in (1, -1))
        off = sorted(abs(found[i] - (a[0] - b[0]) / (2 * h))
                     for i, (a, b) in enumerate(zip(after, before)))
        creases = 0 if "fbm" in options or "erosion" in options else 3  # points that lie near one
        self.assertLess(off[len(off) - 1 - creases], 0.01)
        self.assertGreater(max(abs(number) for number in found), 1)

    def test_columns(self):
        """It comes last, with all others or alone."""
        for dims, words, names in (
                (2, ["--dphase"], "value,dphase"),
                (2, ["--gradient", "--dphase"], "value,dx,dy,dphase"),
                (3, ["--dphase", "--hessian", "--gradient"],
                 "value,dx,dy,dz,dxx,dxy,dxz,dyy,dyz,dzz,dphase")):
            result = run("sample", *words, "--phase", "0.1", "--output-format", "csv",
                         input=b"0.5 0.25 0.75\n"[:8 if dims == 2 else None])
            lines = result.stdout.decode().splitlines()
            self.assertEqual(lines[0], names)
            self.assertEqual(len(lines[1].split(",")), len(names.split(",")))
        plain = self.sample(self.points(2), "--gradient", "--hessian")
        self.assertEqual([row[:-1] for row in self.sample(self.points(2), "--gradient", "--hessian",
                                                          "--dphase")], plain)


class PhaseRefused(Case):
    def refused(self, name, command, *words):
        result = run(command, *words, cwd=self.directory, input=b"")
        error = self.check_one_line(result, 2)
        self.assertTrue(error.startswith("scarp: %s: " % name), error)
        self.assertEqual(self.files(), [])
        return error

    def test_numbers(self):
        for command in ("terrain", "sample"):
            for text in ("", "x", "nan", "inf", "-inf", "-nan", "1e39", "-1e39", "3.41e38", "1/2",
                         "0.5 ", "1,5", "0x1"):
                with self.subTest(command=command, text=text):
                    error = self.refused("--phase", command, "--phase", text)
                    self.assertIn("is not a finite number", error)

    def test_value_noise(self):
        """What has no gradients cannot turn them, at no phase; the message says what can."""
        for command in ("terrain", "sample"):
            for phase in ("0", "0.5", "1"):
                error = self.refused("--phase", command, "--basis", "value", "--phase", phase)
                self.assertIn("--basis gradient", error)
        error = self.refused("--dphase", "sample", "--basis", "value", "--dphase")
        self.assertIn("--basis gradient", error)
        self.refused("--dphase", "terrain", "--dphase")

    def test_others(self):
        """What else does not go together is refused as without a phase."""
        self.refused("--hessian", "sample", "--fractal", "erosion", "--hessian", "--dphase")
        self.refused("--rotate", "terrain", "--tileable", "--rotate", "--phase", "0.5")


common.main(globals())
