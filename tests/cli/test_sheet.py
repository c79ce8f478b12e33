# SPDX-License-Identifier: MIT
"""scarp sheet: panels are what scarp terrain makes, in their order, and labelled."""
import math
import os
import re
import unittest

import common
from common import ROOT, Case, has_png, has_threads, run, start
from rasters import read_picture

GROUND = ("--frequency", "0.05", "--octaves", "3")
PANEL = ("--panel", "40x24", "--step", "2")
ONE = ("--samples", "1")


def font():
    """The dots of each character, from the source."""
    with open(os.path.join(ROOT, "src", "cli", "sheet", "font.c"), encoding="utf-8") as file:
        lines = re.findall(r"(?m)^    \{((?:0x[0-9a-f]{2}(?:, )?){9})\}, /\*", file.read())
    return {chr(32 + i): [int(byte, 16) for byte in line.split(", ")]
            for i, line in enumerate(lines)}


FONT = font()


def dots(text, scale=1):
    """Rows of a text, a byte per pixel: 1 is ink; with a character's room on both sides"""
    rows = ["00000 " + "".join(format(FONT[c][row], "05b") + "0" for c in text) + "000000"
            for row in range(9)]
    return [bytes(int(dot) for dot in row.replace(" ", "0") for _ in range(scale))
            for row in rows for _ in range(scale)]


class Sheet(Case):
    def sheet(self, *arguments, name="s.ppm"):
        result = run("sheet", *arguments, "--quiet", "--output", name, cwd=self.directory)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""))
        return read_picture(self.path(name)).rows

    def terrain_rows(self, *arguments, layer="--relief"):
        name = "t.ppm" if layer == "--relief" else "t.pgm"
        self.quietly("--size", "40x24", "--step", "2", *GROUND, *arguments, layer, name)
        rows = read_picture(self.path(name)).rows
        return rows if layer == "--relief" else [[(grey,) * 3 for grey in row] for row in rows]

    def place(self, page, panel):
        """Where the page has the panel, which must be there once: column and row."""
        found = []
        width = len(panel[0])
        for y in range(len(page) - len(panel) + 1):
            for x in range(len(page[y]) - width + 1):
                if page[y][x] == panel[0][0] and page[y][x:x + width] == panel[0] and all(
                        page[y + i][x:x + width] == row for i, row in enumerate(panel)):
                    found.append((x, y))
        self.assertEqual(len(found), 1, found)
        return found[0]

    def texts(self, page, *texts):
        """Where the page has each text, in any size: tuples of column, row and pixels per dot."""
        paper = page[0][0]
        ink = [bytes(pixel != paper for pixel in row) for row in page]
        places = []
        for text in texts:
            found = []
            for scale in (1, 2):
                rows = dots(text, scale)
                first = next(i for i, row in enumerate(rows) if any(row))
                for y in range(len(page) - len(rows) + 1):
                    x = ink[y + first].find(rows[first])
                    while x >= 0:
                        if all(ink[y + k][x:x + len(row)] == row for k, row in enumerate(rows)):
                            found.append((x + 6 * scale, y, scale))
                        x = ink[y + first].find(rows[first], x + 1)
            places.append(found)
        return places

    def check_labels(self, sheet, *labels, more=()):
        """The panels of a sheet with these labels, in their order"""
        page = self.sheet(*PANEL, "--panel", "176x16", "--step", "8", *ONE, *GROUND, *more,
                          "--sheet", sheet)
        places = self.texts(page, *labels)
        for label, place in zip(labels, places):
            self.assertEqual(len(place), 1, (sheet, label, place))
        order = [(y, x) for (x, y, _), in places]
        self.assertEqual(order, sorted(order))
        return page

    def test_font(self):
        self.assertEqual(len(FONT), 95)
        self.assertEqual(len({tuple(rows) for rows in FONT.values()}), 95)
        self.assertTrue(all(0 <= byte < 32 for rows in FONT.values() for byte in rows))
        self.assertEqual([c for c in FONT if not any(FONT[c])], [" "])

    def test_cells(self):
        """In their order, the pixels of scarp terrain"""
        for layer in ("relief", "hillshade"):
            page = self.sheet(*PANEL, *ONE, *GROUND, "--layer", layer, "--height", "30",
                              "--sheet", "seed=3..5,gain=0.25..0.75/2")
            places = [[self.place(page, self.terrain_rows("--height", "30", "--seed", seed,
                                                          "--gain", gain, layer="--" + layer))
                       for seed in ("3", "4", "5")] for gain in ("0.25", "0.75")]
            (a, b, c), (d, e, f) = places
            self.assertTrue(a[0] == d[0] < b[0] == e[0] < c[0] == f[0], places)
            self.assertTrue(a[1] == b[1] == c[1] < d[1] == e[1] == f[1], places)
            self.assertGreaterEqual(b[0] - a[0], 44)
            self.assertGreaterEqual(d[1] - a[1], 24 + 9)

    def test_labels(self):
        """Below each panel and next to its left edge; titles above columns and left of rows"""
        page = self.sheet("--panel", "130x24", "--step", "2", *ONE, *GROUND, "--sheet",
                          "seed=1..2,gain=0.3|0.5")
        labels = self.texts(page, "seed 1  gain 0.3", "seed 2  gain 0.3", "seed 1  gain 0.5",
                            "seed 2  gain 0.5")
        self.assertEqual([len(label) for label in labels], [1] * 4)
        titles = self.texts(page, "seed 1", "seed 2", "gain 0.3", "gain 0.5")
        self.assertEqual([scale for title in titles for _, _, scale in title].count(2), 4)
        for (seed, column) in (("1", titles[0]), ("2", titles[1])):
            for (gain, row) in (("0.3", titles[2]), ("0.5", titles[3])):
                self.quietly("--size", "130x24", "--step", "2", *GROUND, "--seed", seed, "--gain",
                             gain, "--relief", "t.ppm")
                x, y = self.place(page, read_picture(self.path("t.ppm")).rows)
                label = labels[(gain == "0.5") * 2 + (seed == "2")][0]
                self.assertTrue(label[0] == x and y + 24 < label[1] < y + 32, label)
                above = [place for place in column if place[2] == 2][0]
                self.assertTrue(above[0] == x and above[1] < y, above)
                beside = [place for place in row if place[2] == 2][0]
                self.assertTrue(beside[0] < x - 90 and y <= beside[1] < y + 24, beside)

    def test_contrast(self):
        page = self.sheet(*PANEL, *GROUND, "--sheet", "seed=1..2,gain=0.3|0.5")
        paper = page[0][0]
        (x, y, scale), = [place for place in self.texts(page, "gain 0.3")[0] if place[0] < 20]
        ink = page[y + 2 * scale][x - 6 * scale + dots("gain 0.3", scale)[2 * scale].index(1)]
        self.assertGreater(min(ink) - max(paper), 150)

    def test_samples(self):
        """Pixels are roots of means of squares of samples around them."""
        for count, width in ((2, 40), (3, 40), (8, 130)):
            step = 2 / count
            aside = -(count - 1) / 2 * step
            self.quietly("--size", "%dx%d" % (width * count, 24 * count), "--step", repr(step),
                         "--origin", "%r,%r" % (7 + aside, aside), *GROUND, "--relief", "t.ppm")
            fine = read_picture(self.path("t.ppm")).rows
            panel = [[tuple(int(math.sqrt(sum(fine[count * r + i][count * c + j][part] ** 2
                                             for i in range(count) for j in range(count)) /
                                         count ** 2) + 0.5) for part in range(3))
                     for c in range(width)] for r in range(24)]
            page = self.sheet(*PANEL, "--panel", "%dx24" % width, *GROUND, "--samples", str(count),
                              "--origin", "7,0",
                              "--sheet", "seed=1")
            self.place(page, panel)

    def test_ranges(self):
        """What A..B and A..B/N are, and lists"""
        self.check_labels("seed=1..4", "seed 1", "seed 2", "seed 3", "seed 4")
        self.check_labels("seed=12..10", "seed 12", "seed 11", "seed 10")
        self.check_labels("seed=18446744073709551614..18446744073709551615",
                          "seed 18446744073709551614", "seed 18446744073709551615")
        self.check_labels("gain=0.3..0.6", "gain 0.3", "gain 0.4", "gain 0.5", "gain 0.6")
        self.check_labels("gain=.5..1/3", "gain 0.5", "gain 0.75", "gain 1")
        self.check_labels("sea-level=-1..1", "sea-level -1", "sea-level 0", "sea-level 1")
        self.check_labels("scale=1..3/3", "scale 1", "scale 2", "scale 3")
        self.check_labels("height=1e2..3e2/2", "height 100", "height 300")
        self.check_labels("octaves=1..2/4", "octaves 1", "octaves 1.33333", "octaves 1.66667",
                          "octaves 2")
        self.check_labels("fractal=fbm|swiss,octaves=1..2", "fractal fbm  octaves 1",
                          "fractal swiss  octaves 1", "fractal fbm  octaves 2",
                          "fractal swiss  octaves 2")
        self.check_labels("origin=-0.5,0.25|0,0,seed=5", "origin -0.5,0.25  seed 5",
                          "origin 0,0  seed 5")
        self.check_labels("gain=0.5", "gain 0.5")

    def test_many_in_rows(self):
        """With one parameter, panels go on in the next row, but for a few."""
        labels = ["seed %d" % seed for seed in range(1, 8)]
        page = self.check_labels("seed=1..7", *labels)
        places = self.texts(page, *labels)
        self.assertEqual(len({place[0][1] for place in places}), 3)
        page = self.check_labels("seed=1..5", *labels[:5])
        self.assertEqual(len({place[0][1] for place in self.texts(page, *labels[:5])}), 1)

    def test_recipes(self):
        """The seed is an option with a recipe, too; other names are its parameters."""
        page = self.sheet(*PANEL, *ONE, "--preset", "alps", "--sheet", "seed=3..4,gully=0|0.3")
        places = []
        for gully in ("0", "0.3"):
            for seed in ("3", "4"):
                self.quietly("--size", "40x24", "--step", "2", "--preset", "alps", "--seed", seed,
                             "--set", "gully=" + gully, "--relief", "t.ppm")
                places.append(self.place(page, read_picture(self.path("t.ppm")).rows))
        self.assertEqual(places, sorted(places, key=lambda place: (place[1], place[0])))

    def test_kinds_of_options(self):
        """Presets with their palettes, switches, palettes, and what is on the command line"""
        page = self.sheet(*PANEL, *ONE, "--sheet", "preset=dunes|islands")
        for preset in ("dunes", "islands"):
            self.quietly("--size", "40x24", "--step", "2", "--preset", preset, "--relief", "t.ppm")
            self.place(page, read_picture(self.path("t.ppm")).rows)
        page = self.sheet(*PANEL, *ONE, *GROUND, "--rotate", "--sheet",
                          "rotate=off|on,palette=arctic|grey")
        for rotate in ((), ("--rotate",)):
            for palette in ("arctic", "grey"):
                self.place(page, self.terrain_rows(*rotate, "--palette", palette))
        with open(self.path("p.txt"), "w", encoding="utf-8") as file:
            file.write("0% 0 0 0\n100% 255 255 0\n")
        page = self.sheet(*PANEL, *ONE, *GROUND, "--sheet", "palette=p.txt|alpine,azimuth=0..90/2")
        self.place(page, self.terrain_rows("--palette", "p.txt", "--azimuth", "90"))

    def test_same_bytes(self):
        """Whatever the number of threads, the instruction set and the format"""
        arguments = ("--panel", "70x50", *GROUND, "--sheet", "seed=1..7")
        page = self.sheet(*arguments, "--threads", "1")
        for more in (("--isa", "scalar"),) + ((("--threads", "3"), ()) if has_threads() else ()):
            self.assertEqual(self.sheet(*arguments, *more), page)
        if has_png():
            self.assertEqual(self.sheet(*arguments, name="s.png"), page)
        result = run("sheet", *arguments, "--output", "ppm:-", cwd=self.directory)
        self.assertEqual(result.stdout, self.bytes("s.ppm"))
        self.assertRegex(result.stderr.decode(), r"\A7 panels of 70x50 pixels in [^\n]*\n\Z")

    def test_default(self):
        result = run("sheet", "--panel", "32x24", cwd=self.directory)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertRegex(result.stdout.decode(), r"\A9 panels of 32x24 pixels in [^\n]*\n\Z")
        self.assertEqual(self.files(), ["sheet.png" if has_png() else "sheet.ppm"])

    def test_large(self):
        """A hundred panels; the largest panels"""
        page = self.sheet("--panel", "16x16", *ONE, "--octaves", "1", "--sheet",
                          "seed=1..50,gain=0.3|0.4")
        self.assertGreater(len(page[0]), 50 * 16)
        page = self.sheet("--panel", "1024x1024", *ONE, "--octaves", "1", "--sheet", "seed=1")
        self.assertGreater(len(page), 1024)

    @unittest.skipUnless(common.pty, "needs POSIX")
    def test_progress(self):
        """On a terminal, unless it is to be quiet"""
        arguments = ("sheet", *PANEL, *GROUND, "--output", self.path("s.ppm"))
        status, shown = self.on_terminal(*arguments)
        self.assertEqual(status, 0)
        self.assertRegex(shown, r"\A0\.\.\.10\.\.\..*\.\.\.100 - done\.\r\n\Z")
        self.assertEqual(self.on_terminal(*arguments, "--quiet"), (0, ""))

    @unittest.skipUnless(common.resource, "needs POSIX")
    def test_full_disk(self):
        """A file that fails leaves nothing, and one that was there stays."""
        for name in ("s.ppm",) + (("s.png",) if has_png() else ()):
            with open(self.path(name), "wb") as file:
                file.write(b"old")
            result = run("sheet", *PANEL, *GROUND, "--output", name, cwd=self.directory,
                         preexec_fn=common.file_limit(1000))
            self.check_one_line(result, 1, "--output", name)
            self.assertEqual(self.all_bytes(), {name: b"old"})
            os.remove(self.path(name))

    @unittest.skipUnless(common.signal, "needs POSIX")
    def test_interrupt(self):
        process = start("sheet", "--panel", "1024x1024", "--samples", "8", "--octaves", "32",
                        "--lacunarity", "1.1", "--sheet", "seed=1..30", "--output", "s.ppm",
                        cwd=self.directory)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.wait_for_unfinished("s.ppm")
        process.send_signal(common.signal.SIGINT)
        self.assertEqual(process.wait(common.PATIENCE), -common.signal.SIGINT)
        self.assertRegex(process.stderr.read().decode(), r"\Ascarp: interrupted: [^\n]*\n\Z")
        self.assertEqual(self.files(), [])

    def check_bad(self, *arguments, words=()):
        with self.subTest(arguments=arguments):
            result = run("sheet", *PANEL, *arguments, cwd=self.directory)
            self.check_one_line(result, 2, *words)
            self.assertEqual(self.files(), [])

    def test_refused(self):
        for text, *words in (
                ("", "--sheet"), ("seed", "NAME=VALUES"), ("=1", "NAME=VALUES"),
                ("1..4", "NAME=VALUES"), ("seed=", "seed", "1 to 63"), ("seed=1|", "1 to 63"),
                ("seed=1..4,", "--seed"), ("seed=1..4;gain=1", "--sheet", "A..B"),
                ("bogus=1", "bogus", "no parameter"), ("-seed=1", "no parameter"),
                ("threads=1..2", "threads", "no parameter"), ("panel=1", "no parameter"),
                ("output=1", "no parameter"), ("quiet=0", "no parameter"), ("a=b", "NAME=VALUE"),
                ("sheet=1", "no parameter"), ("help=1", "no parameter"),
                ("seed=1..2,gain=0.3,height=1", "more than 2"), ("seed=1,seed=2", "twice"),
                ("seed=1..101", "100"), ("seed=1..11,octaves=1..10", "11 times 10", "100"),
                ("seed=0..18446744073709551615", "100"), ("gain=0.1..0.2/101", "A..B/N"),
                ("gain=0.1..0.2/1", "A..B/N"), ("gain=0.1..0.2/x", "A..B/N"),
                ("gain=0.1..", "A..B"), ("gain=0.1..x", "A..B"), ("gain=1..2..3", "A..B"),
                ("gain=0.1..1e999", "A..B"), ("sea-level=-1000..1000", "100"),
                ("seed=" + "|".join("1" * 101), "100"), ("seed=" + "1" * 64, "63"),
                ("seed=1..2/3", "--seed", "'1.5'"), ("gain=0.3..99", "--gain", "'33.2'"),
                ("gain=0", "--gain", "1/16"), ("basis=magic", "--basis", "gradient"),
                ("seed=1,rotate=yes", "rotate", "off or on"), ("preset=alps|mars", "--preset"),
                ("palette=nowhere.txt", "--palette"), ("warp-octaves=2..3", "no parameter"),
                ("lacunarity=16,octaves=32", "--frequency"),
                ("x" * 30 + "=1", "NAME=VALUES")):
            self.check_bad("--sheet", text, words=words)
        self.check_bad("--output", "s.jpg", words=("--output", ".ppm"))
        self.check_bad("--output", "s.pgm", words=("--output", ".ppm"))
        self.check_bad("--output", "missing/s.ppm", words=("--output", "missing"))
        self.check_bad("--panel", "15x16", words=("--panel", "16 to 1024"))
        self.check_bad("--panel", "16x1025", words=("--panel", "16 to 1024"))
        self.check_bad("--samples", "9", words=("--samples", "1 to 8"))
        self.check_bad("--layer", "normals", words=("--layer", "relief or hillshade"))
        self.check_bad("--size", "10x10", words=("--size", "unknown"))


common.main(globals())
