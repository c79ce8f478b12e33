# SPDX-License-Identifier: MIT
"""What the pictures show: it follows from the formulas in `scarp terrain --help`."""
import math
import re

import common
from common import FRACTALS, SMALL, Case, run, text_of

def shade(normal):
    """Hillshade as in GIS textbooks, from slope and aspect; y is north."""
    x, y, z = normal
    zenith, azimuth = math.radians(90 - 45), math.radians(315)
    slope = math.atan2(math.hypot(x, y), z)
    downhill = math.atan2(x, y)  # clockwise from north
    light = (math.cos(zenith) * math.cos(slope) +
             math.sin(zenith) * math.sin(slope) * math.cos(azimuth - downhill))
    return 255 * max(0.0, light)


def decoded(normal):
    return [(component - 127.5) / 127.5 for component in normal]


class Pictures(Case):
    """What the pictures show."""

    def test_defaults(self):
        """The help has the defaults that are used."""
        text = text_of("terrain", "--help")
        defaults = {}
        for block in re.split(r"\n(?=  --|\n)", text):
            option = re.match(r"  (--\S+) (?s:.*) \[(\S+)\]\Z", block)
            if option:
                defaults[option.group(1)] = option.group(2)
        self.assertEqual([defaults.pop("--tiles"), defaults.pop("--share")], ["all", "all"])
        self.assertEqual(defaults.pop("--of-octaves"), "--octaves")
        self.assertEqual(len(defaults), 23, defaults)
        self.assertEqual(defaults.pop("--size"), "1024x1024")
        self.assertEqual(defaults.pop("--overlap"), "0")  # which needs --tile
        explicit = [word for pair in defaults.items() for word in pair]
        plain = self.terrain("--size", "80x60")
        self.assertEqual(self.terrain("--size", "80x60", *explicit), plain)

    def test_spellings(self):
        base = self.terrain(*SMALL, "--seed", "16", "--gain", "0.5", "--origin", "-3.5,1e3")
        same = (("--seed", "0x10", "--gain", "5e-1", "--origin", "-3.5,1000"),
                ("--seed=0X10", "--gain=.5", "--origin=-3.5,+1000."),
                ("--seed", "99", "--seed", "0016", "--gain", "0.50", "--origin", "-3.5,1e3"))
        for arguments in same:
            with self.subTest(arguments=arguments):
                self.assertEqual(self.terrain(*SMALL, *arguments), base)

    def test_every_option_counts(self):
        """Each option changes the heights: a parameter that is not passed on would not."""
        variants = [()]
        for option, values in {"--seed": ("2", "4294967297", "0xffffffffffffffff"),
                               "--basis": ("value",), "--fade": ("cubic",),
                               "--fractal": FRACTALS[1:],
                               "--octaves": ("3", "3.5", "32"), "--frequency": ("0.031",),
                               "--lacunarity": ("2.1",), "--gain": ("0.6",),
                               "--origin": ("5,0", "0,5", "9007199254740992,0"),
                               "--step": ("1.5",), "--phase": ("0", "0.3", "-0.3")}.items():
            variants += [(option, value) for value in values]
        variants.append(("--rotate",))
        heights = {}
        for arguments in variants:
            data = self.terrain(*SMALL, *arguments)[0]
            self.assertNotIn(data, heights, (arguments, heights.get(data)))
            heights[data] = arguments
        self.assertEqual(len(heights), 20 + len(FRACTALS[1:]))

    def test_jitter_counts(self):
        """How far features stray matters to cellular noise, and to no other."""
        bases = ("gradient", "value", "simplex", "cell-f1", "cell-f2", "cell-edge", "cell-soft",
                 "cell-value")
        for basis in bases:
            pictures = [self.terrain(*SMALL, "--basis", basis, "--jitter", jitter)
                        for jitter in ("1", "0.5", "0.1")]
            different = 3 if basis.startswith("cell") else 1
            self.assertEqual(len(set(map(str, pictures))), different, basis)

    def test_erosion_counts(self):
        """How much it damps matters to the fractals that the help names, and to no other."""
        told = re.search(r"--erosion F(.*?)--sharpness", text_of("terrain", "--help"), re.S).group(1)
        takers = set(re.findall(r"\w+", told)) & set(FRACTALS)
        self.assertGreaterEqual(len(takers), 2)
        for fractal in FRACTALS:
            strengths = ["0.1", "0.5", "1"]  # all of these take more, but those where 1 is all
            if run("terrain", "--fractal", fractal, "--erosion", "2", "--print-recipe").returncode == 0:
                strengths = ["5.9604644775390625e-8", "1", "1.5", "16777216"]
            pictures = [self.terrain(*SMALL, "--fractal", fractal, "--erosion", strength)
                        for strength in strengths]
            for i in range(3):
                different = len({data[i] for data in pictures})
                self.assertEqual(different, len(strengths) if fractal in takers else 1, (fractal, i))
        # Hardly any of it: fBm, but for roundings to 16 bits
        slight = self.pictures(*SMALL, "--fractal", "erosion", "--erosion", "6e-8")[0].flat()
        fbm = self.pictures(*SMALL)[0].flat()
        self.assertLessEqual(max(abs(a - b) for a, b in zip(slight, fbm)), 1)
        # Nothing but erosion: flat, but where the sum of slopes is 0
        strong = self.pictures(*SMALL, "--fractal", "erosion", "--erosion", "16777216")[0].flat()
        self.assertLess(sorted(abs(grey - 32767.5) for grey in strong)[len(strong) * 9 // 10], 2)

    def test_sharpness_counts(self):
        """It matters to the fractals that have one, whose defaults are those of the help."""
        told = re.search(r"--sharpness F(.*?)--frequency", text_of("terrain", "--help"),
                         re.S).group(1)
        standards = {}
        for clause in told.split(";"):
            named = [word for word in re.findall(r"\w+", clause) if word in FRACTALS]
            standards.update(zip(named, re.findall(r"[0-9.]*[0-9]", clause.partition("[")[2])))
        self.assertGreaterEqual(len(standards), 4)
        for fractal in FRACTALS:
            standard = standards.get(fractal)
            other, same = (self.terrain(*SMALL, "--fractal", fractal, "--sharpness", sharpness)
                           for sharpness in ("0.5", standard or "0.75"))
            self.assertEqual(other != same, standard is not None, fractal)
            self.assertEqual(self.terrain(*SMALL, "--fractal", fractal), same, fractal)

    def test_bounds_are_allowed(self):
        for option, value in (("--octaves", "32"), ("--octaves", "0.5"), ("--gain", "16"),
                              ("--gain", "0.0625"), ("--lacunarity", "1"),
                              ("--step", "281474976710656"), ("--step", "3.5527136788005009e-15"),
                              ("--height", "16777216"), ("--origin", "-9007199254740992,0"),
                              ("--erosion", "16777216"), ("--erosion", "5.9604644775390625e-8"),
                              ("--compare", "1"), ("--compare", "7"),
                              ("--sea-level", "16777216"), ("--sea-level", "-16777216"),
                              ("--azimuth", "0"), ("--azimuth", "360"), ("--altitude", "0"),
                              ("--altitude", "90"), ("--z-factor", "0"), ("--z-factor", "16777216"),
                              ("--amplitude", "16777216"), ("--amplitude", "-16777216"),
                              ("--amplitude", "5.9604644775390625e-8"),
                              ("--amplitude", "-5.9604644775390625e-8"), ("--threads", "1"),
                              ("--phase", "3.4028234663852886e38"),
                              ("--phase", "-3.4028234663852886e38")):
            with self.subTest(option=option, value=value):
                self.terrain(*SMALL, option, value)
        for value in ("281474976710656", "2.3283064365386963e-10"):
            self.terrain("--size", "4x4", "--octaves", "1", "--frequency", value)
        for value in ("16", "0.0625"):
            self.terrain("--size", "4x4", "--octaves", "3", "--lacunarity", value)
        self.quietly("--size", "3x2", "--tile", "1000000x1000000", "--overlap", "1024", "--heights",
                     "t.r16", "--octaves", "1")
        self.assertEqual(len(self.bytes("t_0_0.r16")), 1027 * 1026 * 2)
        self.quietly("--size", "1000000x1000000", "--tile", "1x1", "--tiles",
                     "999999:1000000,999999:1000000", "--heights", "u.r16")
        self.assertEqual(len(self.bytes("u_999999_999999.r16")), 2)

    def test_height_is_vertical_scale(self):
        """--height changes normals and hillshade, never the heights."""
        low = self.terrain(*SMALL, "--height", "10")
        high = self.terrain(*SMALL, "--height", "20")
        self.assertEqual(low[0], high[0])
        self.assertNotEqual(low[1], high[1])
        self.assertNotEqual(low[2], high[2])

    def test_flat(self):
        _, normal, hillshade = self.pictures(*SMALL, "--height", "0")
        self.assertEqual(set(normal.flat()), {(128, 128, 255)})
        self.assertEqual(set(hillshade.flat()), {round(255 * math.sqrt(0.5))})

    def test_units(self):
        """All lengths twice as large: the same pictures, bit for bit."""
        self.assertEqual(
            self.terrain("--size", "50x40", "--origin", "3,5", "--step", "0.5", "--frequency",
                         "0.0625", "--height", "25"),
            self.terrain("--size", "50x40", "--origin", "6,10", "--step", "1", "--frequency",
                         "0.03125", "--height", "50"))

    def check_range(self, lowest, highest, *options):
        """Heights map this interval to 0 ... 65535: values are those of `scarp sample`."""
        options = ("--seed", "3", *options)
        points = "".join("%d %d\n" % (x, y) for y in reversed(range(9)) for x in range(9))
        values = run("sample", *options, input=points.encode()).stdout.split()
        heights = self.pictures("--size", "9x9", *options)[0].flat()
        self.assertEqual(len(values), len(heights))
        for value, grey in zip(values, heights):
            # The rounding to 16 bits, and the head-room of 2^-17 in the amplitude
            self.assertLess(abs(grey - 65535 * (float(value) - lowest) / (highest - lowest)), 2,
                            options)

    def test_range(self):
        """The range of the noise maps to 0 ... 65535, not the values that occur."""
        self.check_range(-1, 1, "--frequency", "0.05", "--octaves", "1")
        self.check_range(-1, 1, "--frequency", "0.3", "--octaves", "4", "--gain", "0.5")
        self.check_range(-3, 3, "--frequency", "0.3", "--octaves", "1", "--amplitude", "3",
                         "--basis", "value")
        height = self.pictures("--size", "64x64", "--frequency", "0.37", "--octaves", "1",
                               "--basis", "value")[0].flat()
        self.assertLess(min(height), 4000)
        self.assertGreater(max(height), 65535 - 4000)
        self.assertLess(abs(sum(height) / 4096 - 32767.5), 3000)

    def test_ranges_of_fractals(self):
        """[-1, 1] for fBm and erosion; [0, 1] for turbulence and ridged, whose one octave is the
        magnitude of fBm's, and the square of 1 less it."""
        one = ["--size", "48x48", "--frequency", "0.09", "--octaves", "1"]
        fbm = [grey / 32767.5 - 1 for grey in self.pictures(*one)[0].flat()]
        self.assertLess(min(fbm), -0.6)
        self.assertGreater(max(fbm), 0.6)
        for fractal, expected in (("turbulence", lambda n: abs(n)),
                                  ("ridged", lambda n: (1 - abs(n)) ** 2)):
            height = self.pictures(*one, "--fractal", fractal)[0].flat()
            for n, grey in zip(fbm, height):
                # The 16 bits of fBm, and the head-room of 2^-17 in its amplitude
                self.assertLess(abs(grey - 65535 * expected(n)), 4, fractal)
        for fractal, lowest in (("turbulence", 0), ("ridged", 0), ("erosion", -1), ("swiss", 0),
                                ("jordan", 0)):
            self.check_range(lowest, 1, "--frequency", "0.3", "--octaves", "1", "--fractal",
                             fractal)

    def test_tiles(self):
        """Tiles are pieces of the whole; the origin is the bottom left sample."""
        whole = self.pictures("--size", "300x128", "--rotate", "--frequency", "0.02",
                              "--origin", "-70,1000")
        for left, bottom in ((0, 0), (64, 0), (0, 64), (101, 37)):
            with self.subTest(left=left, bottom=bottom):
                tile = self.pictures("--size", "64x64", "--rotate", "--frequency", "0.02",
                                     "--origin", "%d,%d" % (-70 + left, 1000 + bottom))
                top = 128 - bottom - 64
                for one, all_of_it in zip(tile, whole):
                    self.assertEqual(one.rows, [row[left:left + 64]
                                                for row in all_of_it.rows[top:top + 64]])

    def test_origin(self):
        """The sample at 0,0 is the bottom left one."""
        noise = ["--seed", "1", "--frequency", "0.1", "--octaves", "1"]
        value = float(run("sample", *noise, input=b"0 0\n").stdout)
        height = self.pictures("--size", "8x6", *noise)[0]
        origin = height.rows[5][0]
        self.assertLess(abs(origin - 32767.5 * (1 + value)), 2)
        self.assertNotIn(origin, height.rows[5][1:] + height.rows[4])
        height = self.pictures("--size", "8x6", *noise, "--step", "0.5", "--origin", "-1.5,-1")[0]
        self.assertEqual(height.rows[3][3], origin)

    def test_normals(self):
        """Unit length, and perpendicular to the surface that the heights show."""
        for fractal in ("fbm", "erosion"):  # the others have creases
            with self.subTest(fractal=fractal):
                self.check_normals(fractal)

    def check_normals(self, fractal):
        size, scale = 96, 80.0
        height, normal, _ = self.pictures("--size", "%dx%d" % (size, size), "--octaves", "2",
                                          "--frequency", "0.005", "--height", str(scale),
                                          "--fractal", fractal)
        z = [[(2 * grey / 65535 - 1) * scale for grey in row] for row in height.rows]
        steepest = 0.0
        for r in range(1, size - 1):
            for c in range(1, size - 1):
                n = decoded(normal.rows[r][c])
                self.assertLess(abs(math.hypot(*n) - 1), math.sqrt(3) / 255)
                dx = (z[r][c + 1] - z[r][c - 1]) / 2
                dy = (z[r - 1][c] - z[r + 1][c]) / 2  # the row above is further north
                length = math.hypot(dx, dy, 1)
                steepest = max(steepest, math.hypot(dx, dy))
                # Half a step of 8 bits, and what differences of 16-bit heights cost
                for i, expected in enumerate((-dx / length, -dy / length, 1 / length)):
                    self.assertLess(abs(n[i] - expected), 0.5 / 127.5 + 0.006, (r, c, i))
        self.assertGreater(steepest, 0.3)

    def test_hillshade(self):
        """Follows from the normals; slopes towards the upper left of the picture are bright."""
        _, normal, hillshade = self.pictures("--size", "96x96", "--height", "40", "--frequency",
                                             "0.02")
        greys = hillshade.flat()
        for n, grey in zip(normal.flat(), greys):
            self.assertLess(abs(grey - shade(decoded(n))), 3.0, n)
        self.assertLess(min(greys), 60)
        self.assertGreater(max(greys), 240)

    def test_light_on_a_hill(self):
        """Independent of the normals: where the ground falls to the upper left it is brighter."""
        height, _, hillshade = self.pictures("--size", "96x96", "--frequency", "0.02", "--octaves",
                                             "1")
        falling, rising = [], []
        for r in range(1, 95):
            for c in range(1, 95):
                slope = height.rows[r + 1][c + 1] - height.rows[r - 1][c - 1]
                (falling if slope > 0 else rising).append(hillshade.rows[r][c])
        self.assertGreater(sum(falling) / len(falling), sum(rising) / len(rising) + 60)


common.main(globals())
