# SPDX-License-Identifier: MIT
"""The relief in colours, held against its formula, and palettes from files."""
import math
import os
import re

import common
from common import ROOT, Case, has_png, run
from rasters import read_picture

PALETTES = ("alpine", "temperate", "desert", "arctic", "grey")
# Slopes of all kinds, and heights that are exact multiples of values
FREQUENCY, SCALE = 0.06, 16.0
GROUND = ("--frequency", str(FREQUENCY), "--octaves", "5", "--seed", "3", "--height", "16")
SMALL = ("--size", "48x40", *GROUND)
SEA = ("--sea-level", "-0.0625")
SUN, SKY = (1.06, 1.0, 0.9), (0.27, 0.3, 0.36)


def light(azimuth=315.0, altitude=45.0):
    turn, up = math.radians(azimuth), math.radians(altitude)
    return math.sin(turn) * math.cos(up), math.cos(turn) * math.cos(up), math.sin(up)


def palette_of(name):
    """The numbers of a palette, from its source."""
    with open(os.path.join(ROOT, "src", "cli", "look", "palette.c"), encoding="utf-8") as file:
        source = file.read()
    number = r"(-?[\d.]+)f"
    colour = r"RGB\((\d+), (\d+), (\d+)\)"
    stops = re.search(r"%s_stops\[\] = \{(.*?)\n\};" % name, source, re.S).group(1)
    members = re.search(r'\.name = "%s",(.*?)\}(,\n    \{|,?\n\};)' % name, source, re.S).group(1)
    palette = {"ramp": [(float(height), tuple(int(part) / 255 for part in rgb))
                        for height, *rgb in re.findall(r"\{%s, %s" % (number, colour), stops)],
               "snow_sun": 0.0, "snow_steep": 0.0}
    for key, *rgb in re.findall(r"\.(\w+) = %s" % colour, members):
        palette[key] = tuple(int(part) / 255 for part in rgb)
    for key, first, second in re.findall(r"\.(\w+) = \{%s, %s\}" % (number, number), members + "}"):
        palette[key] = float(first), float(second)
    for key, value in re.findall(r"\.(\w+) = %s" % number, members):
        palette[key] = float(value)
    return palette


def smooth(x, pair):
    u = min(max((x - pair[0]) / (pair[1] - pair[0]), 0.0), 1.0)
    return u * u * (3 - 2 * u)


def mixed(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def squares(colour):
    return tuple(part * part for part in colour)


def at_height(ramp, height, below=None, above=None):
    """Two entries at one height are a step, with the second colour at that height."""
    if height < ramp[0][0]:
        return below or ramp[0][1]
    if height >= ramp[-1][0]:
        return above or ramp[-1][1]
    k = max(k for k in range(len(ramp)) if ramp[k][0] <= height)
    (low, a), (high, b) = ramp[k], ramp[k + 1]
    return mixed(a, b, (height - low) / (high - low))


def lit(ground, normal, sun):
    """The pixel, not rounded"""
    direct = max(0.0, sum(a * b for a, b in zip(normal, sun)))
    pixel = []
    for part, one, two in zip(ground, SUN, SKY):
        x = part * (one * direct + two * (1 + normal[2]) / 2)
        pixel.append(255 * math.sqrt(x if x <= 0.75 else 1 - 1 / (16 * x - 8)))
    return pixel


class Painted(Case):
    def relief(self, *arguments, name="r.ppm"):
        self.layer("--relief", name, *arguments)
        return read_picture(self.path(name)).flat()

    def floats(self, option, *arguments):
        self.layer(option, "f.npy", *arguments)
        return read_picture(self.path("f.npy")).flat()

    def spread(self, sea=None):
        """The values that are 0, 0.4 and 1, and where the sea is deep, from samples of the noise.
        """
        points = []
        for i in range(4096):
            points.append(" ".join(repr((i * g % 1.0 - 0.5) * (64 / FREQUENCY))
                                   for g in (0.7548776662466927, 0.5698402909980532)))
        result = run("sample", "--gain", "0.4", *GROUND[:6], "--input", "-", "--input-format", "text",
                     "--output", "-", "--output-format", "text",
                     input="\n".join(points).encode())
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        values = sorted(float(line) for line in result.stdout.split())
        self.assertEqual(len(values), 4096)
        bed = [value for value in values if sea is not None and value < sea]
        land = values[len(bed):]
        return {"low": sea if sea is not None else values[4096 // 50],
                "middle": land[-1 - len(land) // 2], "high": land[-1 - len(land) // 50],
                "deep": bed[len(bed) // 10] if bed else None}

    def ground(self, palette, spread, value, bed, sea, normal, sun):
        if sea is not None and bed < sea:
            depth = (sea - bed) / (sea - spread["deep"])
            return squares(mixed(palette["shallow"], palette["deep"],
                                 min(1.0, 1.25 * depth / (depth + 0.25))))
        over = value - spread["middle"]
        h = 0.4 + (0.4 * over / (spread["middle"] - spread["low"]) if over < 0 else
                   0.6 * over / (spread["high"] - spread["middle"]))
        colour = squares(at_height(palette["ramp"], h))
        if sea is not None:
            colour = mixed(colour, squares(palette["sand"]), smooth(h, palette["sand_height"]))
        steep = smooth(normal[2], palette["rock_slope"])
        colour = mixed(colour, squares(palette["rock"]), steep)
        colour = mixed(colour, squares(palette["high_rock"]),
                       steep * smooth(h, palette["rock_height"]))
        lower = (palette["snow_sun"] * (sun[0] * normal[0] + sun[1] * normal[1]) +
                 palette["snow_steep"] * (1 - normal[2]))
        return mixed(colour, squares(palette["snow"]), smooth(h - lower, palette["snow_height"]) *
                     smooth(normal[2], palette["snow_slope"]))

    def check_close(self, pixels, expected):
        self.assertEqual(len(pixels), len(expected))
        for i, (pixel, wanted) in enumerate(zip(pixels, expected)):
            for part, number in zip(pixel, wanted):
                self.assertLess(abs(part - number), 0.51, (i, pixel, wanted))


class Relief(Painted):
    def check_palette(self, name, sea, azimuth=315.0, altitude=45.0):
        arguments = (*SMALL, "--azimuth", str(azimuth), "--altitude", str(altitude))
        wet = arguments + (("--sea-level", str(sea)) if sea is not None else ())
        palette, spread = palette_of(name), self.spread(sea)
        sun = light(azimuth, altitude)
        beds = [height / SCALE for height in self.floats("--heights", *arguments)]
        values = [height / SCALE for height in self.floats("--heights", *wet)]
        normals = self.floats("--normals", *wet)
        expected = [lit(self.ground(palette, spread, value, bed, sea, normal, sun), normal, sun)
                    for value, bed, normal in zip(values, beds, normals)]
        pixels = self.relief(*wet, "--palette", name)
        self.check_close(pixels, expected)
        return pixels

    def test_formula(self):
        """Every pixel of every palette, on land and with a sea"""
        seen = set()
        for name in PALETTES:
            for sea in (None, -0.0625):
                with self.subTest(palette=name, sea=sea):
                    seen.add(tuple(self.check_palette(name, sea)))
        self.assertEqual(len(seen), 10)

    def test_masks(self):
        """Masks are the shares of these colours, rounded: the formula of the ground with a colour
        of its own for each of five grounds."""
        names = ("rock", "snow", "sand", "vegetation", "water")
        unit = {name: tuple(float(name == other) for other in names) for name in names}
        for name in PALETTES:
            ramp = unit[{"desert": "sand", "arctic": "snow"}.get(name, "vegetation")]
            palette = {**palette_of(name), "ramp": [(0.0, ramp), (1.0, ramp)],
                       "rock": unit["rock"], "high_rock": unit["rock"], "snow": unit["snow"],
                       "sand": unit["sand"], "shallow": unit["water"], "deep": unit["water"]}
            for sea in (None, -0.0625):
                wet = SMALL if sea is None else [*SMALL, "--sea-level", str(sea)]
                spread, sun = self.spread(sea), light()
                beds = [height / SCALE for height in self.floats("--heights", *SMALL)]
                values = [height / SCALE for height in self.floats("--heights", *wet)]
                normals = self.floats("--normals", *wet)
                self.quietly(*wet, "--palette", name, "--masks", "m.npy")
                masks = [read_picture(self.path("m-%s.npy" % ground)).flat() for ground in names]
                for pixel, value, bed, normal in zip(zip(*masks), values, beds, normals):
                    self.assertEqual(sum(pixel), 255)
                    expected = self.ground(palette, spread, value, bed, sea, normal, sun)
                    for part, share in zip(pixel, expected):
                        self.assertLess(abs(part - 255 * share), 1.01, (name, sea, pixel))

    def test_light(self):
        """It comes from where it is asked for, and snow keeps away from it."""
        self.check_palette("arctic", None, 90.0, 20.0)
        self.check_palette("alpine", -0.0625, 200.0, 70.0)

    def test_all_materials(self):
        """The ground of these tests has rock, snow, sand and water, each here and there."""
        plain = self.relief(*SMALL, "--palette", "alpine")
        wet = self.relief(*SMALL, *SEA, "--palette", "alpine")
        self.assertGreater(sum(blue > 1.3 * red for red, green, blue in wet), 100)
        self.assertGreater(sum(min(pixel) > 200 for pixel in plain), 20)
        flat = self.relief(*SMALL, "--height", "1", "--palette", "alpine")
        self.assertGreater(sum(green > 1.1 * red for red, green, blue in flat),
                           1.5 * sum(green > 1.1 * red for red, green, blue in plain))

    def test_exaggeration(self):
        """The light sees it, snow and rock do not: the factor 0 lights level ground."""
        palette, spread = palette_of("alpine"), self.spread()
        values = [height / SCALE for height in self.floats("--heights", *SMALL)]
        normals = self.floats("--normals", *SMALL)
        sun = light()
        expected = [lit(self.ground(palette, spread, value, value, None, normal, sun), (0, 0, 1),
                        sun) for value, normal in zip(values, normals)]
        self.check_close(self.relief(*SMALL, "--z-factor", "0"), expected)

    def test_formats(self):
        pixels = self.relief(*SMALL)
        for name in ("r.npy", "r.img") + (("r.png",) if has_png() else ()):
            self.assertEqual(self.relief(*SMALL, name=name), pixels)
        self.quietly(*SMALL, "--output", "t")
        self.assertEqual(read_picture(self.path(self.names("t")[3])).flat(), pixels)
        self.quietly(*SMALL, *SEA, "--relief", "a.ppm", "--heights", "h.r32", "--normals", "n.ppm",
                     "--hillshade", "s.pgm", "--gradient", "g.npy", "--z-factor", "2")
        others = self.all_bytes()
        for option, name in (("--relief", "a.ppm"), ("--heights", "h.r32"),
                             ("--normals", "n.ppm"), ("--hillshade", "s.pgm"),
                             ("--gradient", "g.npy")):
            self.assertEqual(self.layer(option, name, *SMALL, *SEA, "--z-factor", "2"),
                             others[name])

    def test_tiles(self):
        """The colours do not depend on the raster: tiles are parts of the whole."""
        arguments = (*SMALL, *SEA)
        self.quietly(*arguments, "--relief", "r.ppm")
        whole = read_picture(self.path("r.ppm")).rows
        self.quietly(*arguments, "--tile", "20x16", "--overlap", "1", "--relief", "t.ppm")
        for row in range(3):
            for column in range(3):
                rows = read_picture(self.path("t_%d_%d.ppm" % (row, column))).rows
                for r, line in enumerate(rows[:40 - 16 * row]):
                    self.assertEqual(line[:48 - 20 * column],
                                     whole[16 * row + r][20 * column:20 * column + len(line)])
        part = self.relief(*arguments, "--size", "10x8", "--origin", "20,16")
        self.assertEqual(part, [pixel for row in whole[16:24] for pixel in row[20:30]])

    def test_long_rows(self):
        arguments = (*SMALL, *SEA, "--size", "700x3")
        self.quietly(*arguments, "--relief", "r.ppm")
        self.quietly(*arguments, "--tile", "100x3", "--relief", "t.ppm")
        for column in range(7):
            tile = read_picture(self.path("t_0_%d.ppm" % column)).rows
            whole = read_picture(self.path("r.ppm")).rows
            self.assertEqual(tile, [row[100 * column:100 * column + 100] for row in whole])

    def test_frames(self):
        """A terrain that flows has the same colours of heights in all frames."""
        frame = ("--phase", "0.37", "--palette", "ramp.txt")
        with open(self.path("ramp.txt"), "w", encoding="utf-8") as file:
            file.write("0% 0 0 0\n100% 255 255 255\n")
        first, second = self.relief(*SMALL, *frame), self.relief(*SMALL, *frame, "--phase", "0")
        self.assertNotEqual(first, second)
        # Where heights and normals are the same, colours are: nowhere lit, so only heights count
        dark = ("--z-factor", "0")
        greys = []
        for phase in ("0", "0.37"):
            pixels = self.relief(*SMALL, *frame, *dark, "--phase", phase)
            heights = self.floats("--heights", *SMALL, *frame, *dark, "--phase", phase)
            greys += list(zip(heights, pixels))
        greys.sort()
        self.assertEqual([pixel for _, pixel in greys], sorted(pixel for _, pixel in greys))

    def test_levels(self):
        """Nothing but water, nothing but plateau, no height at all"""
        for arguments in (("--sea-level", "100"), ("--plateau", "-100"), ("--height", "0"),
                          ("--sea-level", "100", "--plateau", "100"), ("--height", "16777216"),
                          ("--sea-level", "-0.9999"), ("--altitude", "0"),
                          ("--amplitude", "1e-7")):
            with self.subTest(arguments=arguments):
                pixels = self.relief(*SMALL, *arguments)
                self.assertEqual(len(pixels), 48 * 40)
                self.assertGreater(max(map(max, pixels)), 0)
        blue = set(self.relief(*SMALL, "--sea-level", "100"))
        self.assertTrue(all(blue > red for red, green, blue in blue))

    def test_presets(self):
        """Each has the palette that its recipe names."""
        size = ("--size", "24x16", "--step", "97")
        names = re.findall(r"(?m)^  (\w+) +\S", common.text_of("help", "recipe").split("presets ")[1])
        palettes = {name: re.search(r"(?m)^#: palette (\w+)$", common.text_of("recipe", name, "--text"))
                    .group(1) for name in names if name in common.text_of("help", "terrain")}
        self.assertGreater(len(set(palettes.values())), 2, palettes)
        for preset, palette in palettes.items():
            made = self.relief(*size, "--preset", preset)
            self.assertEqual(self.relief(*size, "--preset", preset, "--palette", palette), made)
            self.assertNotEqual(self.relief(*size, "--preset", preset, "--palette", "grey"), made)


class Alike(Case):
    """Colours follow what the height depends on, however the text says it."""
    SCALED = "recipe 1\nout h = 100 * scale(noise(octaves=3), 1000)\n"
    SIZED = "recipe 1\nout h = 100 * noise(size=1000, octaves=3)\n"
    UNUSED = ("recipe 1\nwide = noise(size=100000)\nrough = noise(cell_value, size=3)\n"
              + SIZED[9:] + "out other = wide + rough\n")

    def layer(self, text, command, option, *arguments):
        with open(self.path("r.recipe"), "w", encoding="utf-8") as file:
            file.write(text)
        result = run(command, "--recipe", "r.recipe", "--size", "64x48", option, "r.ppm", *arguments,
                     cwd=self.directory)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return read_picture(self.path("r.ppm")).flat()

    def test_cells(self):
        for more in ([], ["--scale", "2"], ["--seed", "5", "--levels", "2"]):
            made = [self.layer(text, "terrain", "--relief", "--step", "40", *more)
                    for text in (self.SCALED, self.SIZED, self.UNUSED)]
            self.assertGreater(len(set(made[0])), 300)
            self.assertEqual(made[0], made[1])
            self.assertEqual(made[1], made[2])

    def test_jumps(self):
        views = [self.layer(text, "view", "--output", "--quiet") for text in
                 (self.SIZED, self.UNUSED)]
        self.assertEqual(views[0], views[1])


class Palettes(Painted):
    """Palettes from files"""

    def write(self, text, name="p.txt"):
        with open(self.path(name), "wb") as file:
            file.write(text.encode())
        return name

    def check_file(self, text, ramp, name="p.txt", below=None, above=None, arguments=SMALL):
        """The ramp holds heights in units, and colours of 255."""
        ramp = [(height, tuple(part / 255 for part in rgb)) for height, rgb in ramp]
        ends = [end and tuple(part / 255 for part in end) for end in (below, above)]
        expected = [lit(squares(at_height(ramp, height, *ends)), normal, light())
                    for height, normal in zip(self.floats("--heights", *arguments),
                                              self.floats("--normals", *arguments))]
        pixels = self.relief(*arguments, "--palette", self.write(text, name))
        self.check_close(pixels, expected)
        return pixels

    def test_gdal(self):
        """Its forms and separators; entries are sorted; what lies beyond has the end's colour."""
        ramp = [(-4, (0, 60, 200)), (0, (250, 240, 110)), (2.5, (20, 120, 40)),
                (5, (165, 42, 42)), (7, (255, 255, 255))]
        pixels = self.check_file("# a comment\n-4 0 60 200\n0 250 240 110\n2.5 20 120 40\n"
                                 "5 165 42 42\n7 255 255 255\n", ramp)
        for text in ("\ufeff-4 0 60 200\r\n0 250 240 110\r\n2.5 20 120 40\r\n5 brown\r\n7 white\r\n",
                     "7 white\n5,brown\n2.5:20:120:40\n0\t250\t240\t110\n\n-4 0 60 200 0\n",
                     "nv 0 0 0 0\r\n7 255 255 255 255\r\n  5\t Brown\r\n2.5, 20, 120, 40\r\n"
                     "+0 250.0 240 110\r\n-.4e1 0 60 200",
                     "#COLOUR\n  # more\n5 brown\n7 White\n-4 0 60 200\n2.5 20 120 40\n"
                     "0 250 240 110\nnv 1 2 3\n"):
            with self.subTest(text=text):
                self.assertEqual(self.relief(*SMALL, "--palette", self.write(text)), pixels)
        self.check_file("5 10 200 30", [(5, (10, 200, 30))])

    def test_steps(self):
        """Two colours at one height are a step."""
        self.check_file("-9 10 20 30\n0.5 40 50 60\n0.5 200 100 0\n9 250 250 250\n",
                        [(-9, (10, 20, 30)), (0.5, (40, 50, 60)), (0.5, (200, 100, 0)),
                         (9, (250, 250, 250))])

        level = (*SMALL, "--height", "0")
        self.check_file("-1 10 20 30\n0 40 50 60\n0 200 100 0\n9 250 250 250\n",
                        [(0, (200, 100, 0))], arguments=level)

    def test_percent(self):
        """Between the heights that are 0 and 1 for the named palettes; a plateau is the upper end.
        """
        spread = self.spread()
        low, high = (SCALE * spread[key] for key in ("low", "high"))
        self.check_file("100% 255 255 255\n0% 0 0 0\n25% 200 50 50\n",
                        [(low, (0, 0, 0)), (0.75 * low + 0.25 * high, (200, 50, 50)),
                         (high, (255, 255, 255))])
        self.check_file("100% 255 255 255\n0% 0 0 0\n", [(low, (0, 0, 0)), (2, (255, 255, 255))],
                        arguments=(*SMALL, "--plateau", "0.125"))

    def test_gmt(self):
        """Slices, steps between them, and colours for what lies beyond"""
        ramp = [(-5, (0, 0, 128)), (0, (0, 128, 255)), (0, (20, 120, 40)), (3, (165, 42, 42)),
                (3, (165, 42, 42)), (5, (255, 255, 255))]
        pixels = self.check_file(
            "# COLOR_MODEL = RGB\n-5 0 0 128 0 0 128 255\n0 20 120 40 3 165 42 42\n"
            "3 165 42 42 5 255 255 255\nB 255 0 0\nF 0 255 0\nN 128 128 128\n", ramp,
            "p.cpt", (255, 0, 0), (0, 255, 0))
        for name, text in (("q.CPT", "-5 0/0/128 0 0/128/255 L\n0 20/120/40 3 brown U ;meadow\n"
                                     "3 brown 5 white B; top; 1\nB red\nF 0/255/0\nN -\n"),
                           ("p.txt", "#COLOR_MODEL = +RGB\n-5\t0/0/128\t0\t0/128/255\n"
                                     "0 20/120/40 3 Brown\n\n3 brown 5 white\nF 0 255 0\nB red")):
            with self.subTest(text=text):
                self.assertEqual(self.relief(*SMALL, "--palette", self.write(text, name)), pixels)
        self.check_file("-5 0 0 128 0 0 128 255\n", ramp[:2], "p.cpt")

    def test_sea_and_plateau(self):
        """A file colours the bed of the sea and what the plateau leaves; the light sees both flat.
        """
        text = "-9 0 0 100\n0 200 220 255\n0 40 120 40\n9 255 255 255\n"
        ramp = [(-9, (0, 0, 100)), (0, (200, 220, 255)), (0, (40, 120, 40)),
                (9, (255, 255, 255))]
        ramp = [(height, tuple(part / 255 for part in rgb)) for height, rgb in ramp]
        cut = (*SMALL, "--sea-level", "0", "--plateau", "0.125")
        dry = self.floats("--heights", *SMALL)
        expected = [lit(squares(at_height(ramp, min(height, 2.0))), normal, light())
                    for height, normal in zip(dry, self.floats("--normals", *cut))]
        self.check_close(self.relief(*cut, "--palette", self.write(text)), expected)

    def check_bad(self, text, line, *words, name="p.txt"):
        with self.subTest(text=text[:80]):
            self.clear()
            self.write(text, name)
            result = run("terrain", *SMALL, "--relief", "r.ppm", "--palette", name,
                         cwd=self.directory)
            self.check_one_line(result, 2, "--palette: %s, line %d:" % (name, line), *words)
            self.assertEqual(self.files(), [name])

    def test_bad_lines(self):
        self.check_bad("", 0, "without a colour")
        self.check_bad("# nothing\n\nnv 1 2 3\n", 3, "without a colour")
        self.check_bad("0 1 2 3\nten 1 2 3\n", 2, "'ten'", "height")
        self.check_bad("0 1 2\n", 1, "height red green blue")
        self.check_bad("0 1 2 3 4 5\n", 1, "height red green blue")
        self.check_bad("0\n", 1, "height red green blue")
        self.check_bad("# one\n0 1 2 256\n", 2, "'256'", "0 to 255")
        self.check_bad("0 1 -2 3\n", 1, "'-2'")
        self.check_bad("0 1 2 x3\n", 1, "'x3'")
        self.check_bad("0 1 2 3 300\n", 1, "'300'")
        self.check_bad("0 mauve\n", 1, "'mauve'", "colour")
        self.check_bad("0 1/2/3\n", 1, "'1/2/3'")
        self.check_bad("nan 1 2 3\n", 1, "'nan'")
        self.check_bad("1e10 1 2 3\n", 1, "'1e10'")
        self.check_bad("5%% 1 2 3\n", 1, "'5%%'")
        self.check_bad("nv mauve\n", 1, "'mauve'")
        self.check_bad("0 1 2 3\n" + "1 " * 600, 2, "longer than 1022")
        self.check_bad("".join("%d 1 2 3\n" % i for i in range(4097)), 4097, "more than 4096")
        self.check_bad("\x89PNG\r\n\x1a\n\0", 1)

    def test_bad_slices(self):
        for text, line, *words in (
                ("", 0, "without a colour"),
                ("0 1 2 3 1 1 2 3\n2 1 2 3 3 1 2 3\n", 2, "where the one before ends"),
                ("0 1 2 3 0 1 2 3\n", 1, "no higher"),
                ("0 1 2 3 10 1 2\n", 1, "z0 red green blue"),
                ("0 1 2 3\n", 1, "'1'", "colour"),
                ("0 1/2 1 1/2/3\n", 1, "'1/2'"),
                ("0 1/2/3 1 1/2/300\n", 1, "'1/2/300'"),
                ("0 1-0.5-0.5 1 2-0.5-0.5\n", 1, "'1-0.5-0.5'"),
                ("10% 1/2/3 20% 1/2/3\n", 1, "'10%'"),
                ("B 1 2\n", 1, "B red green blue"),
                ("0 red 1 blue\nF mauve\n", 2, "'mauve'"),
                ("# COLOR_MODEL = HSV\n0 1 2 3 1 1 2 3\n", 1, "RGB"),
                ("# COLOR_MODEL=+cmyk\n", 1, "RGB")):
            self.check_bad(text, line, *words, name="p.cpt")

    def test_no_file(self):
        for name in ("alpin", "missing/p.txt", "."):
            result = run("terrain", *SMALL, "--relief", "r.ppm", "--palette", name,
                         cwd=self.directory)
            self.check_one_line(result, 2, "--palette", "'%s'" % name,
                                "alpine, temperate, desert, arctic or grey")
            self.assertEqual(self.files(), [])

    def test_world(self):
        """Tiles of one world have one palette, by what the file holds."""
        arguments = (*SMALL, "--tile", "20x20", "--relief", "t.ppm")
        self.write("0 1 2 3\n9 9 9 9\n", "a.txt")
        self.write("0 1 2 3\n9 9 9 9\n", "b.txt")
        self.write("0 1 2 3\n9 9 9 8\n", "c.txt")
        self.quietly(*arguments, "--palette", "a.txt")
        self.quietly(*arguments, "--palette", "b.txt", "--resume")
        for other in ("c.txt", "alpine"):
            result = run("terrain", *arguments, "--palette", other, cwd=self.directory)
            self.check_one_line(result, 2, "palette")


common.main(globals())
