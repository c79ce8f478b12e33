# SPDX-License-Identifier: MIT
"""The program scarp, from outside.

    test_cli.py GROUP PROGRAM...      one of the classes below
    test_cli.py isa=NAME PROGRAM...   the pictures do not depend on the instruction set NAME

PROGRAM may begin with an emulator. Pictures are decoded here, by nothing but zlib; what they must
show follows from the formulas in `scarp terrain --help`.
"""
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

try:
    import pty
    import resource
    import signal
except ImportError:  # not a POSIX system
    pty = resource = signal = None

PROGRAM = []
SKIPPED = 77
NAMES = ("height", "normal", "hillshade")
OPTIONS = ("size", "origin", "step", "height", "seed", "basis", "fade", "fractal", "erosion",
           "frequency", "octaves", "lacunarity", "gain", "rotate", "compare", "threads", "isa",
           "output", "quiet", "help")
FRACTALS = ("fbm", "turbulence", "ridged", "erosion")
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir)
# Cheap to compute, and every option of the noise matters in it
SMALL = ["--size", "40x30", "--frequency", "0.03"]


def run(*arguments, cwd=None, **more):
    more.setdefault("stdout", subprocess.PIPE)
    more.setdefault("stderr", subprocess.PIPE)
    return subprocess.run(PROGRAM + list(arguments), cwd=cwd, timeout=300, **more)


def text_of(*arguments):
    """Standard output of a run that must succeed in silence on stderr."""
    result = run(*arguments)
    assert result.returncode == 0 and result.stderr == b"", (arguments, result)
    return result.stdout.decode()


def supported_isas():
    return re.findall(r"^(\S+) +yes ", text_of("info"), re.MULTILINE)


def has_png():
    return "pictures: PNG" in text_of("info")


def extensions():
    return [".png"] * 3 if has_png() else [".pgm", ".ppm", ".pgm"]


# Pictures: a Picture is width, height, channels, depth and rows, lists of samples (tuples for
# colour), top row first.

class Picture:
    def __init__(self, width, height, channels, depth, data):
        samples = struct.unpack(">%d%s" % (len(data) * 8 // depth, "H" if depth == 16 else "B"),
                                data)
        assert len(samples) == width * height * channels, "length of the samples"
        if channels > 1:
            samples = list(zip(*[iter(samples)] * channels))
        self.width, self.height, self.channels, self.depth = width, height, channels, depth
        self.rows = [list(samples[i * width:(i + 1) * width]) for i in range(height)]

    def flat(self):
        return [sample for row in self.rows for sample in row]


def unfilter(kind, line, above, bpp):
    """PNG specification, section 9."""
    for i in range(len(line)):
        a = line[i - bpp] if i >= bpp else 0
        b = above[i]
        c = above[i - bpp] if i >= bpp else 0
        if kind == 0:
            return
        if kind == 4:
            p = a + b - c
            distance, predicted = min((abs(p - a), 0), (abs(p - b), 1), (abs(p - c), 2))
            predicted = (a, b, c)[predicted]
        else:
            predicted = (None, a, b, (a + b) // 2)[kind]
        line[i] = (line[i] + predicted) & 255


def decode_png(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "signature"
    at, chunks = 8, []
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        checksum, = struct.unpack(">I", data[at + 8 + length:at + 12 + length])
        assert checksum == zlib.crc32(name + body), "checksum"
        chunks.append((name, body))
        at += 12 + length
    assert chunks[0][0] == b"IHDR" and chunks[-1] == (b"IEND", b""), "first and last chunk"
    width, height, depth, colour, method, filters, interlace = struct.unpack(">IIBBBBB",
                                                                            chunks[0][1])
    assert colour in (0, 2) and (method, filters, interlace) == (0, 0, 0), "kind"
    channels = 1 if colour == 0 else 3
    raw = zlib.decompress(b"".join(body for name, body in chunks if name == b"IDAT"))
    bpp = channels * depth // 8
    stride = width * bpp
    assert len(raw) == height * (stride + 1), "length"
    above, lines = bytearray(stride), []
    for i in range(height):
        line = bytearray(raw[i * (stride + 1) + 1:(i + 1) * (stride + 1)])
        unfilter(raw[i * (stride + 1)], line, above, bpp)
        lines.append(line)
        above = line
    return Picture(width, height, channels, depth, b"".join(lines))


def decode_pnm(data):
    header = re.match(rb"P([56])\n(\d+) (\d+)\n(\d+)\n", data)
    kind, width, height, maximum = (int(field) for field in header.groups())
    assert maximum in (255, 65535), "maximum"
    return Picture(width, height, 1 if kind == 5 else 3, 8 if maximum == 255 else 16,
                   data[header.end():])


def read_picture(path):
    with open(path, "rb") as file:
        data = file.read()
    return decode_png(data) if path.endswith(".png") else decode_pnm(data)


class Case(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.extensions = extensions()

    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="scarp-cli-")
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def path(self, name):
        return os.path.join(self.directory, name)

    def files(self):
        return sorted(os.listdir(self.directory))

    def names(self, stem):
        return [stem + "-" + name + end for name, end in zip(NAMES, self.extensions)]

    def terrain(self, *arguments, stem="t"):
        """Runs `scarp terrain`; returns the bytes of the three files."""
        result = run("terrain", *arguments, "--quiet", "--output", self.path(stem))
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""),
                         arguments)
        contents = []
        for name in self.names(stem):
            with open(self.path(name), "rb") as file:
                contents.append(file.read())
        return contents

    def pictures(self, *arguments):
        self.terrain(*arguments)
        return [read_picture(self.path(name)) for name in self.names("t")]

    def check_rows(self, rows, expected):
        """Like assertEqual, but that shows the difference, which takes minutes for pictures."""
        self.assertEqual(len(rows), len(expected))
        self.assertEqual([r for r in range(len(rows)) if rows[r] != expected[r]], [],
                         "rows that differ")

    def check_one_line(self, result, status, *words):
        """One line on stderr with all the words, nothing on stdout."""
        error = result.stderr.decode()
        self.assertEqual(result.returncode, status, error)
        self.assertEqual(result.stdout, b"")
        self.assertRegex(error, r"\Ascarp: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, error)
        return error


class Commands(Case):
    """What is asked for help and facts."""

    def test_info(self):
        text = text_of("info")
        self.assertRegex(text, r"\Ascarp \d+\.\d+\.\d+\n")
        self.assertNotIn("warning", text)
        rows = re.findall(r"^(\S+) +(yes|no) +(yes|no)$", text, re.MULTILINE)
        self.assertEqual([row[0] for row in rows],
                         ["scalar", "sse4.1", "avx2", "avx512", "neon"])
        self.assertEqual(rows[0][1], "yes")
        active = [row for row in rows if row[2] == "yes"]
        self.assertEqual(len(active), 1)
        self.assertEqual(active[0][1], "yes")
        self.assertRegex(text, r"\npictures: (PNG, with libpng \d|PGM and PPM)")

    def test_version(self):
        self.assertEqual(text_of("--version"), text_of("info").split("\n")[0] + "\n")

    def test_help(self):
        usage = text_of("--help")
        for command in ("terrain", "info", "help"):
            self.assertRegex(usage, r"(?m)^  %s " % command)
        self.assertEqual(text_of("help"), usage)
        self.assertEqual(text_of("-h"), usage)
        for command in ("terrain", "info"):
            help_text = text_of(command, "--help")
            self.assertTrue(help_text.startswith("usage: scarp " + command))
            self.assertEqual(text_of("help", command), help_text)
            self.assertEqual(text_of(command, "-h"), help_text)

    def test_terrain_help(self):
        text = text_of("terrain", "--help")
        self.assertEqual(re.findall(r"(?m)^  --(\S+)", text), list(OPTIONS))
        self.assertLessEqual(max(len(line) for line in text.split("\n")), 90)
        for name, end in zip(NAMES + ("compare",), self.extensions + self.extensions[1:2]):
            self.assertIn("STEM-%s%s" % (name, end), text)

    def test_nothing(self):
        result = run()
        self.assertEqual((result.returncode, result.stdout), (2, b""))
        self.assertTrue(result.stderr.startswith(b"usage: scarp <command>"))

    def test_unknown(self):
        self.check_one_line(run("mountain"), 2, "mountain", "command")
        self.check_one_line(run("help", "mountain"), 2, "mountain", "command")
        self.check_one_line(run("--mountain"), 2, "--mountain", "option")
        self.check_one_line(run("info", "--all"), 2, "--all")
        self.check_one_line(run("info", "all"), 2, "all")


class Errors(Case):
    """Command lines that ask for what is not possible: nothing may be done."""

    def check(self, option, *arguments):
        with self.subTest(arguments=arguments):
            result = run("terrain", *arguments, cwd=self.directory)
            self.check_one_line(result, 2, option)
            self.assertEqual(self.files(), [])

    def check_values(self, option, *values):
        for value in values:
            self.check(option, *SMALL, option, value)
            self.check(option, *SMALL, option + "=" + value)

    def test_names(self):
        for word in ("--bogus", "-s", "--siz", "--sizes", "--bogus=1", "-", "--", "--quie"):
            self.check(word.split("=")[0], word)
        self.check("stray", "stray")
        self.check("stray", *SMALL, "stray")

    def test_one_line_whatever_is_typed(self):
        self.check("--seed", "--seed", "1\n2")
        self.check("--seed", "--seed", "x" * 5000)
        self.check("--a?b", "--a\nb")
        self.check("--output", "--output", "missing\n/t")

    def test_missing_values(self):
        for name in OPTIONS:
            if name not in ("rotate", "quiet", "help"):
                self.check("--" + name, "--" + name)
                self.check("--" + name, "--" + name, "--quiet")
                self.check("--" + name, "--" + name + "=")
        self.check("--rotate", "--rotate=1")
        self.check("--quiet", "--quiet=")

    def test_numbers(self):
        for option in ("--step", "--height", "--frequency", "--octaves", "--lacunarity", "--gain",
                       "--erosion"):
            self.check_values(option, "", "one", "1x", "1 ", " 1", "1,5", "nan", "inf", "-inf",
                              "1e999", "-1", "0x", "1.2.3", "--1", ".", "+")

    def test_intervals(self):
        self.check_values("--step", "0", "3.5e-15", "2.9e14")
        self.check_values("--height", "16777217", "-0.001", "1e300")
        self.check_values("--frequency", "0", "-0", "2.3e-10", "2.9e14", "1e-400")
        self.check_values("--octaves", "0", "1e-46", "32.01", "1e39")
        self.check_values("--lacunarity", "0", "0.0624", "16.0001", "1e39")
        self.check_values("--gain", "0", "0.0624", "16.0001", "1e-46")
        self.check_values("--erosion", "0", "5.9e-8", "16777217", "-1", "1e39")
        self.check_values("--compare", "0", "8", "-1", "+1", "1.5", "1x", "one", "",
                          "18446744073709551617")

    def test_limits_are_told(self):
        """The message names what is allowed, in the words of the help."""
        text = text_of("terrain", "--help")
        for option, value, allowed in (("--erosion", "0", "from 2^-24 to 2^24"),
                                       ("--compare", "8", "from 1 to 7"),
                                       ("--fractal", "fBm", "fbm, turbulence, ridged or erosion"),
                                       ("--basis", "x", "gradient or value"),
                                       ("--fade", "x", "quintic or cubic")):
            result = run("terrain", option, value, cwd=self.directory)
            self.check_one_line(result, 2, option, "'%s'" % value, allowed)
            entry = re.search(r"\n  %s (?s:.*?)(?=\n  --)" % option, text).group()
            self.assertIn(allowed, entry)
        self.assertEqual(self.files(), [])

    def test_last_octave(self):
        for arguments in (("--frequency", "2e14", "--octaves", "2"),
                          ("--lacunarity", "16", "--octaves", "32"),
                          ("--lacunarity", "0.0625", "--octaves", "32")):
            for option in ("--frequency", "--lacunarity", "--octaves"):
                self.check(option, *arguments)

    def test_sizes(self):
        self.check_values("--size", "64", "64x", "x64", "0x64", "64x0", "-1x64", "64x-1", "64x64x1",
                          "64*64", "65537x1", "1x65537", "1.5x2", "64 x64", "64x64 ", "64X64",
                          "99999999999999999999x1", "18446744073709551617x1", "64,64")

    def test_origins(self):
        self.check_values("--origin", "1", "1,", ",1", "1,2,3", "1;2", "nan,0", "0,inf", "1, 2",
                          "9.1e15,0", "0,-9.1e15")

    def test_seeds(self):
        self.check_values("--seed", "-1", "+1", "1.0", "1e3", "18446744073709551616",
                          "0x10000000000000000", "0x", "ff", "0xfg", " 1", "1 ")

    def test_choices(self):
        self.check_values("--basis", "simplex", "Gradient", "gradient ", "")
        self.check_values("--fade", "linear", "quinti", "")
        self.check_values("--fractal", "fBm", "ridge", "erosion ", "0", "")
        self.check_values("--isa", "sse9", "none", "", "avx")

    def test_unsupported_isa(self):
        missing = [isa for isa in ("sse4.1", "avx2", "avx512", "neon")
                   if isa not in supported_isas()]
        self.assertTrue(missing)  # no processor has both NEON and AVX
        for isa in missing:
            self.check("--isa", "--isa", isa)

    def test_first_good_then_bad(self):
        self.check("--gain", *SMALL, "--gain", "0.5", "--gain", "x")
        self.check("--bogus", "--quiet", "--bogus")


class Files(Case):
    """When files appear, and when they must not."""

    def test_default_stem(self):
        result = run("terrain", "--size", "20x10", cwd=self.directory)
        self.assertEqual(result.returncode, 0)
        self.assertEqual(self.files(), sorted(self.names("terrain")))

    def test_formats(self):
        for width, height in ((1, 1), (7, 5), (65, 3), (1, 65536), (65536, 1)):
            with self.subTest(width=width, height=height):
                pictures = self.pictures("--size", "%dx%d" % (width, height))
                self.assertEqual([(p.width, p.height, p.channels, p.depth) for p in pictures],
                                 [(width, height, 1, 16), (width, height, 3, 8),
                                  (width, height, 1, 8)])

    def test_replaces(self):
        first = self.terrain(*SMALL, "--seed", "3")
        self.assertNotEqual(self.terrain(*SMALL, "--seed", "4"), first)
        self.assertEqual(self.terrain(*SMALL, "--seed", "3"), first)
        self.assertEqual(self.files(), sorted(self.names("t")))

    def test_unwritable(self):
        missing = os.path.join(self.directory, "missing", "t")
        self.check_one_line(run("terrain", *SMALL, "--output", missing), 2, "--output", "missing")
        self.check_one_line(run("terrain", *SMALL, "--output", self.path("") + os.sep), 2,
                            "--output")
        self.assertEqual(self.files(), [])

    def test_one_is_unwritable(self):
        """The second name is taken by a directory; the first one was there and must stay."""
        names = self.names("t")
        old = self.terrain(*SMALL)[0]
        os.remove(self.path(names[1]))
        os.remove(self.path(names[2]))
        os.mkdir(self.path(names[1]))
        result = run("terrain", *SMALL, "--seed", "9", "--output", self.path("t"))
        self.check_one_line(result, 2, "--output", names[1])
        self.assertEqual(self.files(), sorted(names[:2]))
        with open(self.path(names[0]), "rb") as file:
            self.assertEqual(file.read(), old)

    @unittest.skipUnless(resource, "needs POSIX")
    def test_full_disk(self):
        """A limit on the size of files stands for a disk that fills up, early and late."""
        whole = max(len(data) for data in self.terrain("--size", "200x200"))
        for name in self.names("t"):
            os.remove(self.path(name))

        # LLVM 14's OpenMP makes a file of 1 KiB for itself, and ends the program when it cannot.
        for limit in (1024, 5000, whole - 1):
            def limit_files():
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

            with self.subTest(limit=limit):
                result = run("terrain", "--size", "200x200", "--output", self.path("t"),
                             preexec_fn=limit_files)
                self.check_one_line(result, 1, "--output", self.directory)
                self.assertEqual(self.files(), [])

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_full_stdout(self):
        with open("/dev/full", "wb") as full:
            for arguments in (["info"], ["--help"],
                              ["terrain", *SMALL, "--output", self.path("t")]):
                with self.subTest(arguments=arguments):
                    result = run(*arguments, stdout=full)
                    self.assertEqual(result.returncode, 1)
                    self.assertRegex(result.stderr, rb"\Ascarp: standard output: [^\n]+\n\Z")


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
        """The help tells the defaults that are used."""
        text = text_of("terrain", "--help")
        defaults = {}
        for block in re.split(r"\n(?=  --|\n)", text):
            option = re.match(r"  (--\S+) (?s:.*) \[(\S+)\]\Z", block)
            if option:
                defaults[option.group(1)] = option.group(2)
        self.assertEqual(len(defaults), 14, defaults)
        self.assertEqual(defaults.pop("--size"), "1024x1024")
        self.assertEqual(defaults.pop("--output"), "terrain")
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
                               "--step": ("1.5",)}.items():
            variants += [(option, value) for value in values]
        variants.append(("--rotate",))
        heights = {}
        for arguments in variants:
            data = self.terrain(*SMALL, *arguments)[0]
            self.assertNotIn(data, heights, (arguments, heights.get(data)))
            heights[data] = arguments
        self.assertEqual(len(heights), 20)

    def test_erosion_counts(self):
        """How much it damps matters to --fractal erosion, and to no other."""
        for fractal in FRACTALS:
            pictures = [self.terrain(*SMALL, "--fractal", fractal, "--erosion", strength)
                        for strength in ("5.9604644775390625e-8", "1", "1.5", "16777216")]
            for i in range(3):
                different = [len({data[i] for data in pictures})]
                self.assertEqual(different, [4 if fractal == "erosion" else 1], (fractal, i))
        # Hardly any of it: fBm, but for roundings to 16 bits
        slight = self.pictures(*SMALL, "--fractal", "erosion", "--erosion", "6e-8")[0].flat()
        fbm = self.pictures(*SMALL)[0].flat()
        self.assertLessEqual(max(abs(a - b) for a, b in zip(slight, fbm)), 1)
        # Nothing but erosion: flat, but where the sum of slopes is 0
        strong = self.pictures(*SMALL, "--fractal", "erosion", "--erosion", "16777216")[0].flat()
        self.assertLess(sorted(abs(grey - 32767.5) for grey in strong)[len(strong) * 9 // 10], 2)

    def test_bounds_are_allowed(self):
        for option, value in (("--octaves", "32"), ("--octaves", "0.5"), ("--gain", "16"),
                              ("--gain", "0.0625"), ("--lacunarity", "1"),
                              ("--step", "281474976710656"), ("--step", "3.5527136788005009e-15"),
                              ("--height", "16777216"), ("--origin", "-9007199254740992,0"),
                              ("--erosion", "16777216"), ("--erosion", "5.9604644775390625e-8"),
                              ("--compare", "1"), ("--compare", "7")):
            with self.subTest(option=option, value=value):
                self.terrain(*SMALL, option, value)
        for value in ("281474976710656", "2.3283064365386963e-10"):
            self.terrain("--size", "4x4", "--octaves", "1", "--frequency", value)
        for value in ("16", "0.0625"):
            self.terrain("--size", "4x4", "--octaves", "3", "--lacunarity", value)

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

    def test_range(self):
        """The range of the noise maps to 0 ... 65535, not the values that occur."""
        # Gradient noise is 0 on the lattice.
        height = self.pictures("--size", "9x9", "--frequency", "1", "--octaves", "1")[0]
        self.assertEqual(set(height.flat()), {32768})
        # Value noise is uniform there: 4096 draws come close to the ends.
        height = self.pictures("--size", "64x64", "--frequency", "1", "--octaves", "1", "--basis",
                               "value")[0].flat()
        self.assertLess(min(height), 400)
        self.assertGreater(max(height), 65535 - 400)
        self.assertLess(abs(sum(height) / 4096 - 32767.5), 5 * 65535 / math.sqrt(12 * 4096))

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
        at_lattice = ["--size", "3x3", "--frequency", "1", "--octaves", "1"]
        for fractal, grey in (("turbulence", (0,)), ("ridged", (65534, 65535)),
                              ("erosion", (32768,))):
            height = self.pictures(*at_lattice, "--fractal", fractal)[0].flat()
            self.assertEqual(len(set(height)), 1)
            self.assertIn(height[0], grey)

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
        """Gradient noise is 0 at 0,0 and nowhere near; that sample is the bottom left one."""
        height = self.pictures("--size", "8x6", "--frequency", "0.1", "--octaves", "1")[0]
        self.assertEqual(height.rows[5][0], 32768)
        self.assertNotIn(32768, height.rows[5][1:] + height.rows[4])
        height = self.pictures("--size", "8x6", "--frequency", "0.1", "--octaves", "1",
                               "--step", "0.5", "--origin", "-1.5,-1")[0]
        self.assertEqual(height.rows[3][3], 32768)

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


class Compare(Case):
    """The picture of normals from the gradient beside normals from differences."""

    RIDGED = ("--fractal", "ridged", "--rotate", "--frequency", "0.02", "--octaves", "5")

    def compare(self, pixels, *arguments):
        """The three usual pictures, and the two halves of the fourth."""
        pictures = self.pictures(*arguments, "--compare", str(pixels))
        both = read_picture(self.path("t-compare" + self.extensions[1]))
        self.assertEqual((both.channels, both.depth), (3, 8))
        self.assertEqual((both.width, both.height),
                         (2 * pixels * pictures[0].width, pixels * pictures[0].height))
        middle = both.width // 2
        return (pictures, [row[:middle] for row in both.rows],
                [row[middle:] for row in both.rows])

    def test_only_when_asked(self):
        plain = self.terrain(*SMALL)
        self.assertEqual(self.files(), sorted(self.names("t")))
        self.assertEqual(self.terrain(*SMALL, "--compare", "2"), plain)
        self.assertEqual(self.files(),
                         sorted(self.names("t") + ["t-compare" + self.extensions[1]]))

    def test_gradient_half(self):
        """Every sample of the normals, enlarged."""
        for pixels in (1, 2, 7):
            (_, normal, _), left, _ = self.compare(pixels, "--size", "19x11", *self.RIDGED)
            self.check_rows(left, [[sample for sample in row for _ in range(pixels)]
                                   for row in normal.rows for _ in range(pixels)])

    def test_differences_half(self):
        """Follows from the 16-bit heights alone; at the edges from those of the next tiles."""
        width, height, scale = 31, 23, 30.0
        for fractal, lowest in (("ridged", 0.0), ("fbm", -1.0)):
            for step in (0.25, 1.0):
                arguments = [*self.RIDGED, "--fractal", fractal, "--step", str(step), "--height",
                             str(scale)]
                _, _, right = self.compare(2, "--size", "%dx%d" % (width, height), *arguments)
                around = self.pictures("--size", "%dx%d" % (width + 2, height + 2), "--origin",
                                       "%g,%g" % (-step, -step), *arguments)[0].rows
                unit = (1 - lowest) / 65535 * scale / (2 * step)
                for r in range(height):
                    for c in range(width):
                        dx = (around[r + 1][c + 2] - around[r + 1][c]) * unit
                        dy = (around[r][c + 1] - around[r + 2][c + 1]) * unit
                        length = math.hypot(dx, dy, 1)
                        expected = [127.5 * part / length + 127.5 for part in (-dx, -dy, 1)]
                        for one in (right[2 * r][2 * c], right[2 * r + 1][2 * c + 1]):
                            for a, b in zip(one, expected):
                                self.assertLess(abs(a - b), 0.51, (fractal, step, r, c))

    def test_blocks(self):
        """Wide pictures are made in several blocks of rows, and differ from tiles in nothing."""
        _, _, whole = self.compare(1, "--size", "3000x20", *self.RIDGED)
        _, _, tile = self.compare(1, "--size", "100x9", "--origin", "1500,8", *self.RIDGED)
        self.check_rows(tile, [row[1500:1600] for row in whole[3:12]])

    def test_they_differ(self):
        """The gradient tells of a crest what differences smear."""
        _, left, right = self.compare(1, "--size", "64x64", *self.RIDGED)
        far = sum(max(abs(a - b) for a, b in zip(p, q)) > 40
                  for one, other in zip(left, right) for p, q in zip(one, other))
        self.assertGreater(far, 64)

    def test_widest(self):
        self.terrain("--size", "65536x1", "--compare", "7", "--octaves", "1")
        self.terrain("--size", "1x65536", "--compare", "7", "--octaves", "1")


class Gallery(Case):
    """The pictures in the README are what its commands make."""

    def test_commands(self):
        with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
            readme = file.read()
        shown = re.findall(r"\]\(src/cli/gallery/([^)]+)\)", readme)
        directory = os.path.join(ROOT, "src", "cli", "gallery")
        self.assertEqual(len(shown), 5)
        self.assertEqual(sorted(os.listdir(directory)), sorted(shown))
        self.assertLess(sum(os.path.getsize(os.path.join(directory, name)) for name in shown),
                        200000)
        commands = {stem: command.split() for command, stem in
                    re.findall(r"^scarp (terrain .*--output (\S+))$", readme.replace("\\\n", ""),
                               re.MULTILINE)}
        for name in shown:
            with self.subTest(name=name):
                stem, kind = name[:-len(".png")].rsplit("-", 1)
                result = run(*commands[stem], "--quiet", cwd=self.directory)
                self.assertEqual((result.returncode, result.stderr), (0, b""))
                end = self.extensions[1 if kind == "compare" else 0]
                made = read_picture(self.path("%s-%s%s" % (stem, kind, end)))
                committed = read_picture(os.path.join(directory, name))
                self.check_rows(made.rows, committed.rows)


SUMMARY = (r"\A%s samples in \d+\.\d{3} s, of which \d+\.\d{3} s sampled values, gradients and normals: "
           r"\d+\.\d million samples per second \((.+)\)\n\Z")


class Progress(Case):
    """What is printed on the way and at the end."""

    def test_summary(self):
        result = run("terrain", "--size", "70x50", "--isa", "scalar", "--output", self.path("t"))
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertRegex(result.stdout.decode(), SUMMARY % "70x50")
        self.assertIn("(scalar)", result.stdout.decode())

    def test_best_isa_by_default(self):
        result = run("terrain", *SMALL, "--output", self.path("t"))
        active = re.search(r"(?m)^(\S+) +yes +yes$", text_of("info")).group(1)
        self.assertEqual(re.search(SUMMARY % "40x30", result.stdout.decode()).group(1), active)

    def test_quiet(self):
        result = run("terrain", *SMALL, "--quiet", "--output", self.path("t"))
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""))
        self.assertEqual(len(self.files()), 3)

    def on_terminal(self, *arguments, **more):
        """Runs with stderr on a terminal; returns the status and what the terminal got."""
        ours, theirs = pty.openpty()
        process = subprocess.Popen(PROGRAM + list(arguments), stdout=subprocess.DEVNULL,
                                   stderr=theirs, **more)
        os.close(theirs)
        shown = b""
        while True:
            try:
                data = os.read(ours, 4096)
            except OSError:  # Linux: the other end is closed
                data = b""
            if not data:
                break
            shown += data
        os.close(ours)
        return process.wait(), shown.decode()

    @unittest.skipUnless(pty, "needs POSIX")
    def test_terminal(self):
        arguments = ("terrain", "--size", "1200x700", "--threads", "1", "--output", self.path("t"))
        status, shown = self.on_terminal(*arguments)
        self.assertEqual(status, 0)
        percents = [int(percent) for percent in re.findall(r"\rsampling +(\d+) %", shown)]
        self.assertGreater(len(percents), 5)
        self.assertEqual(percents, sorted(set(percents)))
        self.assertEqual(percents[-1], 100)
        self.assertNotIn("\n", shown)
        self.assertRegex(shown, r"\r {14}\r\Z")  # and it is gone
        self.assertEqual(self.on_terminal(*arguments, "--quiet"), (0, ""))

    @unittest.skipUnless(pty, "needs POSIX")
    def test_error_on_terminal(self):
        """The message has a line of its own."""
        def limit_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000000, 1000000))

        status, shown = self.on_terminal("terrain", "--size", "1200x700", "--threads", "1",
                                         "--output", self.path("t"), preexec_fn=limit_files)
        self.assertEqual(status, 1)
        self.assertRegex(shown, r"sampling +\d+ %\r {14}\rscarp: --output: [^\n]+\r\n\Z")


class Isa(Case):
    name = None

    def test_same_bytes(self):
        for arguments in ((), ("--rotate", "--basis", "value", "--fade", "cubic"),
                          ("--fractal", "turbulence", "--rotate"), ("--fractal", "ridged"),
                          ("--fractal", "erosion", "--erosion", "2.5", "--fade", "cubic"),
                          ("--origin", "-123456789.5,4e9", "--step", "0.37", "--octaves", "12.3")):
            with self.subTest(arguments=arguments):
                size = ["--size", "131x67", "--frequency", "0.03", *arguments]
                self.assertEqual(self.terrain(*size, "--isa", self.name),
                                 self.terrain(*size, "--isa", "scalar"))

    def test_named(self):
        result = run("terrain", *SMALL, "--isa", self.name, "--output", self.path("t"))
        self.assertIn("(%s)" % self.name, result.stdout.decode())


class Threads(Case):
    """Whatever the number of threads, the pictures are the same."""

    # Several blocks for every thread: a block has 131072 samples, or one row, of each.
    SIZE = ("--size", "700x801", "--octaves", "3", "--compare", "1")

    def test_same_bytes(self):
        threads = "from 1 to 1024" in text_of("terrain", "--help")
        one = self.terrain(*self.SIZE, "--threads", "1")
        for count in ("2", "3", "16") if threads else ():
            with self.subTest(threads=count):
                self.assertEqual(self.terrain(*self.SIZE, "--threads", count) == one, True)
        self.assertEqual(self.terrain(*self.SIZE) == one, True)
        if not threads:
            result = run("terrain", *SMALL, "--threads", "2", "--output", self.path("t"))
            self.assertEqual((result.returncode, result.stdout), (2, b""))
            self.assertIn(b"without OpenMP", result.stderr)


def choose_isa(name):
    """Ends the program if the instruction set cannot run: as skipped, or failed if required."""
    if name not in supported_isas():
        required = name in os.environ.get("SCARP_REQUIRE_ISAS", "").split(",")
        print("%s cannot run here: %s" % (name, "FAILED (required)" if required else "skipped"))
        sys.exit(1 if required else SKIPPED)
    Isa.name = name


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    PROGRAM.extend(sys.argv[2:])
    group = sys.argv[1]
    if group.startswith("isa="):
        choose_isa(group[len("isa="):])
        group = "Isa"
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(globals()[group])
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(tests)
    sys.exit(0 if result.wasSuccessful() and result.testsRun > len(result.skipped) else 1)


main()
