# SPDX-License-Identifier: MIT
"""What changes the layers: light, exaggeration, the sea, the direction of y, the amplitude."""
import math
import re

import common
from common import SMALL, Case, rounded, run
from rasters import FLOAT, Picture, read_picture

WIDTH, HEIGHT = 40, 30  # of SMALL


class Layers(Case):
    def heights(self, *arguments):
        return Picture(WIDTH, HEIGHT, 1, FLOAT,
                       self.layer("--heights", "h.r32", *SMALL, *arguments)).flat()

    def read(self, option, name, *arguments):
        self.layer(option, name, *SMALL, *arguments)
        return read_picture(self.path(name)).flat()

    def check_hillshade(self, azimuth, altitude, factor):
        arguments = ("--azimuth", azimuth, "--altitude", altitude, "--z-factor", factor,
                     "--height", "40")
        greys = self.read("--hillshade", "s.pgm", *arguments)
        turn, up = math.radians(float(azimuth)), math.radians(float(altitude))
        light = (math.sin(turn) * math.cos(up), math.cos(turn) * math.cos(up), math.sin(up))
        for grey, slopes in zip(greys, self.read("--gradient", "g.npy", *arguments)):
            dx, dy = (float(factor) * slope for slope in slopes)
            shade = (-dx * light[0] - dy * light[1] + light[2]) / math.hypot(dx, dy, 1)
            self.assertLess(abs(grey - 255 * max(0.0, shade)), 0.5002)
        return greys

    def test_light(self):
        """The cosine of the angle between the light and the normals of the exaggerated ground."""
        seen = set()
        for azimuth, altitude, factor in (
                ("315", "45", "1"), ("0", "45", "1"), ("90", "30", "1"), ("180", "60", "2"),
                ("270", "10", "0.5"), ("360", "5", "7.5"), ("123.4", "33.3", "1"),
                ("45", "0", "1"), ("10", "90", "3"), ("225", "45", "0")):
            with self.subTest(azimuth=azimuth, altitude=altitude, factor=factor):
                seen.add(tuple(self.check_hillshade(azimuth, altitude, factor)))
        self.assertEqual(len(seen), 10)

    def test_light_from_above(self):
        """Then it does not matter where from; and a full turn is none."""
        one = self.check_hillshade("10", "90", "1")
        self.assertEqual(self.check_hillshade("200", "90", "1"), one)
        self.assertEqual(self.check_hillshade("0", "20", "1"),
                         self.check_hillshade("360", "20", "1"))

    def test_only_the_hillshade(self):
        """Light and exaggeration are of no matter to the other layers."""
        for option, name in (("--heights", "h.r32"), ("--normals", "n.npy"),
                             ("--gradient", "g.npy")):
            self.assertEqual(self.layer(option, name, *SMALL, "--azimuth", "20", "--altitude",
                                        "20", "--z-factor", "9"), self.layer(option, name, *SMALL))

    def test_normal_y(self):
        """Down turns over the second component of the normals, and nothing else."""
        for name in ("n.npy", "n.ppm", "n.pfm"):
            up = self.read("--normals", name)
            self.assertEqual(self.read("--normals", name, "--normal-y", "up"), up)
            down = self.read("--normals", name, "--normal-y", "down")
            self.assertNotEqual(down, up)
            if name != "n.ppm":
                self.assertEqual([(x, -y, z) for x, y, z in down], up)
            else:
                floats = self.read("--normals", "n.npy", "--normal-y", "down")
                self.assertEqual(down, [tuple(math.floor(127.5 * part + 128) for part in n)
                                        for n in floats])
                self.assertLessEqual({a[1] + b[1] for a, b in zip(up, down)}, {255, 256})
                self.assertEqual([(n[0], n[2]) for n in down], [(n[0], n[2]) for n in up])
        for option, name in (("--heights", "h.r32"), ("--hillshade", "s.pgm"),
                             ("--gradient", "g.npy")):
            self.assertEqual(self.layer(option, name, *SMALL, "--normal-y", "down"),
                             self.layer(option, name, *SMALL))

    def test_normal_y_of_the_comparison(self):
        """Both halves of it"""
        both = []
        for direction in ("up", "down"):
            self.quietly(*SMALL, "--normal-y", direction, "--compare", "1", "--output", "t")
            both.append(read_picture(self.path("t-compare" + self.extensions[1])).flat())
        self.assertLessEqual({a[1] + b[1] for a, b in zip(*both)}, {255, 256})
        self.assertEqual(*[[(n[0], n[2]) for n in one] for one in both])

    def test_sea_and_plateau(self):
        """Beyond the level everything is flat and at it; elsewhere nothing changes."""
        for level, height in (("0.125", "64"), ("-0.1", "75"), ("0", "33.3")):
            for option, sign in (("--sea-level", 1), ("--plateau", -1)):
                with self.subTest(option=option, level=level, height=height):
                    self.check_level(option, sign, level, height)

    def check_level(self, option, sign, level, height):
        # Ten cells wide, so that values lie on both sides of each level
        scale = ("--height", height, "--frequency", "0.25")
        arguments = (*scale, option, level)
        flat = rounded(rounded(float(level)) * rounded(float(height)))
        before, after = self.heights(*scale), self.heights(*arguments)
        # Rounding the product might join a value just on the other side with the level
        beyond = [sign * z < sign * flat for z in before]
        self.assertIn(True, beyond)
        self.assertIn(False, beyond)
        self.assertEqual(after, [flat if cut else z for z, cut in zip(before, beyond)])
        for layer, name, level_one in (("--gradient", "g.npy", (0, 0)),
                                       ("--normals", "n.npy", (0, 0, 1)),
                                       ("--normals", "n.ppm", (128, 128, 255))):
            unchanged = self.read(layer, name, *scale)
            self.assertEqual(self.read(layer, name, *arguments),
                             [level_one if cut else n for n, cut in zip(unchanged, beyond)])
        shades = self.read("--hillshade", "s.pgm", *arguments)
        self.assertEqual({shade for shade, cut in zip(shades, beyond) if cut},
                         {round(255 * math.sqrt(0.5))})

    def interval(self, *arguments):
        """The heights that the run says 0 and 65535 are, of a raster of 16 bits"""
        result = run("terrain", *SMALL, *arguments, "--heights", "h.pgm", cwd=self.directory)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        told = re.search(r"(?m)^16-bit heights: 0 is (\S+), 65535 is (\S+)$",
                         result.stdout.decode())
        self.assertNotIn("-0", told.groups())
        return tuple(map(float, told.groups()))

    def test_sixteen_bits_are_told(self):
        """What is left between the sea and the plateau has all the integers, and the run tells
        what they mean: the ends of the floats' interval."""
        for arguments, zero, full in (
                ((), -120, 120), (("--height", "0"), 0, 0), (("--amplitude", "-3"), -360, 360),
                (("--fractal", "ridged"), 0, 120),
                (("--fractal", "turbulence", "--amplitude", "-2"), -240, 0),
                (("--sea-level", "0", "--height", "1000"), 0, 1000),
                (("--sea-level", "-0", "--height", "1000"), 0, 1000),
                (("--sea-level", "-2", "--plateau", "7"), -120, 120),
                (("--sea-level", "-0.125", "--plateau", "0.25"), -15, 30),
                (("--sea-level", "1.5"), 120, 120), (("--plateau", "-9"), -120, -120),
                (("--sea-level", "0.1", "--plateau", "0.1"), rounded(120 * rounded(0.1)),
                 rounded(120 * rounded(0.1)))):
            with self.subTest(arguments=arguments):
                self.assertEqual(tuple(map(rounded, self.interval(*arguments))), (zero, full))
                greys = read_picture(self.path("h.pgm")).flat()
                floats = self.heights(*arguments)
                for grey, height in zip(greys, floats):
                    self.assertLessEqual(abs(zero + grey * (full - zero) / 65535 - height),
                                         0.501 * (full - zero) / 65535 + 1e-7 * abs(height))
                if zero == full and "0" not in arguments:
                    self.assertEqual((set(greys), set(floats)), ({0}, {zero}))

    def test_sixteen_bits_of_a_sea(self):
        """The sea is 0, and land has more integers than the range would leave."""
        with open(self.path("sea.recipe"), "w", encoding="utf-8") as file:
            file.write("recipe 1\nparam sea = 20 [-200, 200]\nout h = 100 * noise(octaves=4)\n")
        arguments = ("--recipe", "sea.recipe", "--step", "0.02")
        def read(*more):
            self.quietly("--size", "80x60", *arguments, *more, "--heights", "h.pgm")
            return read_picture(self.path("h.pgm")).flat()
        greys, before = read(), read("--set", "sea=-200")
        self.assertEqual(min(greys), 0)
        self.assertGreater(greys.count(0), 300)
        land = [b for a, b in zip(greys, before) if a > 0]
        self.assertGreater(max(greys) - 1, 2 * (max(land) - min(land)))

    def test_sea_above_plateau(self):
        result = run("terrain", *SMALL, "--sea-level", "0.2", "--plateau", "0.1",
                     cwd=self.directory)
        self.check_one_line(result, 2, "--plateau", "--sea-level")
        self.assertEqual(self.files(), [])

    def test_sea_beyond_the_range(self):
        """It is no lower and no higher than the noise can be."""
        for arguments, lowest, highest in (((), -1, 1), (("--fractal", "ridged"), 0, 1),
                                           (("--amplitude", "3"), -3, 3),
                                           (("--fractal", "turbulence", "--amplitude", "-2"),
                                            -2, 0)):
            with self.subTest(arguments=arguments):
                files = [[self.terrain(*SMALL, *arguments, *level) for level in levels]
                         for levels in ((("--sea-level", "16777216"),
                                         ("--sea-level", str(highest + 0.001)),
                                         ("--sea-level", str(highest))),
                                        (("--sea-level", "-16777216"),
                                         ("--sea-level", str(lowest - 0.001)),
                                         ("--sea-level", str(lowest)), ()))]
                for same in files:
                    self.assertEqual([one == same[0] for one in same], [True] * len(same))
                flat = self.heights(*arguments, "--sea-level", "16777216", "--height", "8")
                self.assertEqual(set(flat), {8.0 * highest})

    def test_amplitude(self):
        """It scales the floats and turns them over; integers are of the range that it scales."""
        plain = self.heights("--height", "64")
        for amplitude in (4, 0.25, -1, -2):
            self.assertEqual(self.heights("--height", "64", "--amplitude", str(amplitude)),
                             [amplitude * z for z in plain])
        self.assertEqual(self.layer("--heights", "h.r16", *SMALL, "--amplitude", "4"),
                         self.layer("--heights", "h.r16", *SMALL))
        for fractal in ("fbm", "ridged"):
            up = self.read("--heights", "h.pgm", "--fractal", fractal)
            down = self.read("--heights", "h.pgm", "--fractal", fractal, "--amplitude", "-1")
            self.assertLessEqual({a + b for a, b in zip(up, down)}, {65535, 65536})
        self.assertEqual([(-x, -y) for x, y in self.read("--gradient", "g.npy")],
                         self.read("--gradient", "g.npy", "--amplitude", "-1"))

    def test_height_scales(self):
        """--height scales floats and slopes; integers are of the values, which it leaves alone."""
        for option, name in (("--heights", "h.pfm"), ("--gradient", "g.img")):
            low, high = (self.read(option, name, "--height", height) for height in ("1", "16"))
            if option == "--gradient":
                self.assertEqual([(16 * x, 16 * y) for x, y in low], high)
            else:
                self.assertEqual([16 * z for z in low], high)
        self.assertEqual(self.layer("--heights", "h.r16", *SMALL, "--height", "1"),
                         self.layer("--heights", "h.r16", *SMALL, "--height", "16"))


common.main(globals())
