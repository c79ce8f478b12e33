# SPDX-License-Identifier: MIT
"""Warps: another noise displaces positions."""
import re

import common
from common import FRACTALS, SMALL, WARP, Case, run, text_of

# Cheap, and every option of the warp matters in it
WARPED = [*SMALL, "--octaves", "2", "--warp-reach", "12", "--warp-octaves", "2"]


class Warp(Case):
    def heights(self, *arguments):
        return self.layer("--heights", "h.r32", *arguments)

    def test_every_option_counts(self):
        """Each changes the heights: a parameter that is not passed on would not."""
        variants = [(), ("--warp-reach", "0"), ("--warp-reach", "13"), ("--warp-rotate",)]
        for option, values in {"seed": ("2", "4294967297"), "basis": ("value", "cell-f1"),
                               "fade": ("cubic",), "fractal": FRACTALS[1:], "octaves": ("3", "2.5"),
                               "frequency": ("0.031",), "lacunarity": ("2.1",), "gain": ("0.6",),
                               "of-octaves": ("3",), "phase": ("0.3",)}.items():
            variants += [("--warp-" + option, value) for value in values]
        variants += [("--warp-basis", "cell-f1", "--warp-jitter", "0.5"),
                     ("--warp-fractal", "erosion", "--warp-erosion", "0.5"),
                     ("--warp-fractal", "swiss", "--warp-sharpness", "0.5")]
        words = " ".join(word for variant in variants for word in variant)
        self.assertEqual([name for name in WARP if "--warp-" + name not in words], [])
        heights = {}
        for arguments in variants:
            if "--warp-reach" in arguments:
                data = self.heights(*SMALL, "--octaves", "2", *arguments)
            else:
                data = self.heights(*WARPED, *arguments)
            self.assertNotIn(data, heights, (arguments, heights.get(data)))
            heights[data] = arguments

    def test_defaults(self):
        """The seed and the frequency are those of the noise, wherever options stand."""
        for seed, frequency in (("1", "0.03"), ("5", "0.02")):
            noise = ["--seed", seed, "--frequency", frequency]
            self.assertEqual(self.heights(*WARPED, *noise),
                             self.heights("--warp-seed", seed, "--warp-frequency", frequency,
                                          "--warp-gain", "0.5", *WARPED, *noise))
        self.assertNotEqual(self.heights(*WARPED, "--warp-seed", "2"),
                            self.heights(*WARPED, "--seed", "2"))

    def test_preset(self):
        """What a preset says of its warp can be changed, and the warp left out."""
        size = ["--size", "40x30", "--preset", "folds"]
        plain = self.heights("--size", "40x30", "--basis", "cell-soft", "--fractal", "erosion",
                             "--erosion", "0.3", "--rotate", "--frequency", "0.004", "--octaves",
                             "8", "--gain", "0.42")
        self.assertEqual(self.heights(*size, "--height", "120", "--warp-reach", "0"), plain)
        self.assertNotEqual(self.heights(*size, "--warp-octaves", "2"), self.heights(*size))

    def test_tiles(self):
        """Tiles are pieces of the whole, with slopes and light."""
        files = ["--heights", "t.npy", "--gradient", "g.npy", "--hillshade", "s.pgm"]
        for arguments in (WARPED, ["--preset", "hills", "--size", "40x30"],
                          ["--preset", "crests", "--size", "40x30"]):
            self.quietly(*arguments, *files)
            whole = self.all_bytes()
            self.clear()
            self.quietly(*arguments, "--tile", "17x11", *files, "--threads", "1")
            tiles = self.all_bytes()
            for name, size in (("t.npy", 4), ("g.npy", 8), ("s.pgm", 1)):
                rows = [b""] * 30
                for y in range(3):
                    for x in range(3):
                        tile = tiles["%s_%d_%d%s" % (name[0], y, x, name[1:])]
                        width, height = min(17, 40 - 17 * x), min(11, 30 - 11 * y)
                        data = tile[len(tile) - width * height * size:]
                        for r in range(height):
                            row = data[r * width * size:(r + 1) * width * size]
                            rows[11 * y + r] += row
                self.assertEqual(b"".join(rows) == whole[name][-1200 * size:], True, name)
            self.clear()

    def test_isas(self):
        for arguments in (WARPED, *(["--preset", preset, "--size", "40x30"]
                                    for preset in ("crests", "hills", "folds"))):
            files = {self.heights(*arguments, "--isa", isa) for isa in common.supported_isas()}
            self.assertEqual(len(files), 1)

    def test_help(self):
        """All are named, in a few lines."""
        for command in ("terrain", "sample"):
            text = text_of("help", command)
            part = re.search(r"(?m)^(?:the )?warp:\n((?:  .*\n)+)", text).group(1)
            self.assertEqual(re.findall(r"--warp-[a-z-]+", part),
                             ["--warp-reach"] + ["--warp-" + name for name in WARP])
            self.assertLess(part.count("\n"), 12)


class WarpRefused(Case):
    def refused(self, start, command, *words):
        result = run(command, *words, cwd=self.directory, input=b"")
        error = self.check_one_line(result, 2)
        self.assertTrue(error.startswith("scarp: " + start), error)
        self.assertEqual(self.files(), [])

    def test_reach(self):
        for command in ("terrain", "sample"):
            for text in ("", "x", "-1", "nan", "inf", "16777217", "5.9e-8", "1e-46", "1e39"):
                self.refused("--warp-reach: '%s' is not 0 or a number from 2^-24 to 2^24" % text,
                             command, "--warp-reach", text)
            self.refused("--warp-reach: has no value", command, "--warp-reach")
            self.refused("--warp-amplitude: unknown option", command, "--warp-amplitude", "2")
            self.refused("--warp-warp-seed: unknown option", command, "--warp-warp-seed", "2")
        self.quietly(*SMALL, "--warp-reach", "5.9604644775390625e-8", "--heights", "h.r32")
        self.quietly(*SMALL, "--warp-reach", "16777216", "--heights", "h.r32")

    def test_without_reach(self):
        for command in ("terrain", "sample"):
            for name in WARP:
                value = [] if name == "rotate" else ["cubic"] if name == "fade" else \
                    ["value"] if name == "basis" else ["fbm"] if name == "fractal" else ["1"]
                for reach in ([], ["--warp-reach", "0"]):
                    self.refused("--warp-%s: needs a --warp-reach above 0\n" % name, command,
                                 "--warp-" + name, *value, *reach)
        self.refused("--warp-gain: needs", "terrain", "--preset", "folds", "--warp-reach", "0",
                     "--warp-gain", "0.5")

    def test_members(self):
        """Faults of the warp are told by its options, those of the noise by the noise's."""
        for words, start in (
                ("--warp-octaves 3 --warp-of-octaves 2", "--warp-of-octaves: is less than --warp-"),
                ("--warp-frequency 2e14 --warp-octaves 2", "--warp-frequency, --warp-lacunarity, "),
                ("--warp-basis value --warp-phase 0.5", "--warp-phase: only the gradients of --w"),
                ("--warp-fractal jordan --warp-erosion 2", "--warp-erosion: is more than 1"),
                ("--fractal jordan --erosion 2", "--erosion: is more than 1"),
                ("--octaves 3 --of-octaves 2 --warp-octaves 3 --warp-of-octaves 2",
                 "--of-octaves: is less than --octaves"),
                ("--warp-gain 0", "--warp-gain: '0' is not a number from 1/16 to 16"),
                ("--warp-fractal x", "--warp-fractal: 'x' is not fbm, turbulence, "),
                ("--warp-rotate=1", "--warp-rotate: takes no value")):
            for command in ("terrain", "sample"):
                self.refused(start, command, "--warp-reach", "3", *words.split())

    def test_results(self):
        for fractal in ("erosion", "swiss", "jordan"):
            self.refused("--hessian: --warp-fractal %s has no" % fractal, "sample", "--hessian",
                         "--warp-reach", "2", "--warp-fractal", fractal)
            self.refused("--hessian: --fractal %s has no" % fractal, "sample", "--hessian",
                         "--fractal", fractal)
        for fractal in ("swiss", "jordan"):
            self.refused("--dphase: --fractal %s has no" % fractal, "sample", "--dphase",
                         "--fractal", fractal)


common.main(globals())
