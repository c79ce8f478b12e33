# SPDX-License-Identifier: MIT
"""NumPy's arrays in and out."""
import itertools
import math
import os
import struct
import sys
import unittest

import common
from common import run, float32, npy, read_npy, make_input, some_points, Case, BLOCK


sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "cli"))
from refusals import refusals


class Npy(Case):
    def setUp(self):
        super().setUp()
        self.points = [(1.5, 2.25), (-3.5, 4.75), (0.125, 1000.5)]
        self.expected = self.text(make_input("text", self.points))

    def check(self, data):
        self.assertEqual(self.text(data, "--output-format", "text"), self.expected)

    def test_read(self):
        for descr in ("<f4", "<f8", ">f4", ">f8"):
            for version in ((1, 0), (2, 0), (3, 0)):
                with self.subTest(descr=descr, version=version):
                    self.check(npy(self.points, descr, version))
        header = npy(self.points)[10:128]
        for text in (b"{\"shape\":(3L,2L),'fortran_order':False,'descr':\"<f8\"}",
                     b"{ 'shape' : ( 3 , 2 , ) , 'fortran_order' : False , 'descr' : '<f8' , } ",
                     header.replace(b"\n", b" ")):
            self.check(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text +
                       npy(self.points)[128:])
        self.check(npy(self.points) + b"more")  # as NumPy: another array may follow

    def test_types(self):
        """Floats and integers of all widths, in both orders"""
        for kind, points in (
                ("f2", [(1.5, -2.25), (65504.0, 2 ** -24), (-0.0009765625, 1023 * 2 ** -24)]),
                ("i1", [(-128, 127), (0, -1)]), ("u1", [(255, 128), (0, 1)]),
                ("i2", [(-32768, 32767), (256, -1)]), ("u2", [(65535, 32768), (256, 1)]),
                ("i4", [(-2 ** 31, 2 ** 31 - 1), (65536, -1)]), ("u4", [(2 ** 32 - 1, 2 ** 31), (65536, 1)]),
                ("i8", [(-2 ** 63, 2 ** 53), (2 ** 32, -1), (-2 ** 53 - 2, 3)]),
                ("u8", [(2 ** 63, 2 ** 64 - 2048), (2 ** 32, 1)])):
            expected = self.text("".join("%.17g %.17g %.17g\n" % (x, y, x) for x, y in points))
            three = [(x, y, x) for x, y in points]
            for order in "<>|" if kind.endswith("1") else "<>":
                for fortran in (False, True):
                    with self.subTest(kind=kind, order=order, fortran=fortran):
                        data = npy(three, order + kind, fortran_order=fortran)
                        self.assertEqual(self.text(data, "--output-format", "text"), expected)
        for bits in (0x7c00, 0xfc00, 0x7e00):
            self.check_refused(npy([(1, 2)], "<f2")[:128] + struct.pack("<2H", 0x3c00, bits),
                               "point 1 of 1: column 2: ", "is not a finite number",
                               arguments=("--output", self.path("o")))

    def test_fortran(self):
        """One column after the other, as np.array([x, y]).T is saved"""
        for dims, descr, count in ((2, "<f8", 3 * BLOCK + 1), (3, ">f4", 40001), (3, "<f8", 100000)):
            points = [tuple(float32(c) for c in point) for point in some_points(dims, count)]
            self.assertEqual(self.sample(npy(points, descr, fortran_order=True)),
                             self.sample(npy(points, descr)))
        four = [(9.0, *point, math.nan) for point in self.points]
        for words in (("--columns", "2,3"), ("--columns", "3,2")):
            self.assertEqual(self.sample(npy(four, fortran_order=True), *words),
                             self.sample(npy(four), *words))
        self.assertEqual(self.sample(npy(self.points, fortran_order=True), "--keep"),
                         self.sample(npy(self.points), "--keep"))
        data = npy([(1.0, 2.0), (math.nan, 1.0), (3.0, 4.0)], fortran_order=True)
        self.check_refused(data, "point 2 of 3: column 1: 'nan'", arguments=("--output-format", "text"),
                           output=self.sample("1 2"))
        self.check(npy(self.points, fortran_order=True) + b"more")

    def test_written(self):
        self.sample(make_input("text", self.points), "--output", self.path("o.npy"))
        data = self.read("o.npy")
        self.assertEqual(len(data), 128 + 4 * 3)
        self.assertEqual(self.sample(npy(self.points)), data)
        self.assertEqual("".join("%.9g\n" % row[0] for row in read_npy(data)[2]), self.expected)

    def test_own_output(self):
        """What is written can be read."""
        self.sample(make_input("text", self.points), "--gradient", "--output", self.path("o.npy"))
        rows = read_npy(self.read("o.npy"))[2]
        self.assertEqual(self.text(b"", "--input", self.path("o.npy"), "--output-format", "text"),
                         self.text(make_input("text", rows)))

    def test_many(self):
        for dims, descr, count in ((2, "<f8", 3 * BLOCK + 1), (3, ">f4", 40001), (3, "<f8", BLOCK)):
            points = [tuple(float32(c) for c in point) for point in some_points(dims, count)]
            out = read_npy(self.sample(npy(points, descr)))
            self.assertEqual(len(out[2]), count)
            text = self.text(npy(points, descr), "--output-format", "text")
            self.assertEqual(text, self.text(make_input("text", points)))

    def test_empty(self):
        for columns in (2, 3):
            data = npy([], columns=columns)
            self.assertEqual(read_npy(self.sample(data, "--gradient")), ("<f4", columns + 1, []))
            self.assertEqual(self.sample(data, "--output-format", "text"), b"")
            self.assertEqual(self.sample(data, "--output-format", "csv"), b"value\n")

    def test_refused(self):
        good = npy(self.points)
        for data, words in (
                (npy(self.points, "|f8"), ("type '|f8'",)),
                (npy(self.points, "<f1"), ("type '<f1'",)),
                (npy(self.points, "<i3"), ("type '<i3'",)),
                (npy(self.points, "|b1"), ("type '|b1'", "f2, f4, f8, i1 to i8")),
                (npy(self.points, "<f16"), ("type '<f16'",)),
                (npy(self.points, "<c8"), ("type '<c8'",)),
                (npy(self.points, shape=(6,)), ("1 dimensions", "(n, 2) or (n, 3)")),
                (npy(self.points, shape=()), ("0 dimensions",)),
                (npy(self.points, shape=(1, 3, 2)), ("3 dimensions",)),
                (npy(self.points, shape=(6, 1)), ("(6, 1)", "--columns")),
                (npy(self.points, shape=(3, 9)), ("(3, 9)", "; NumPy's .T turns it")),
                (npy(self.points, fortran_order=True)[:-1], ("ends after 2 of 3 points",)),
                (npy(self.points, fortran_order=True)[:-17], ("ends after 0 of 3 points",)),
                (npy(self.points, fortran_order=True)[:140], ("ends after 0 of 3 points",)),
                (npy(self.points, fortran_order=True, shape=(10 ** 18, 2)),
                 ("ends after 0 of 1000000000000000000 points",)),
                (npy(self.points, shape=(1, 6)), ("(1, 6)", "--columns")),
                (npy(self.points, shape=(-3, 2)), ("header",)),
                (npy(self.points, shape=(10 ** 30, 2)), ("header",)),
                (good.replace(b"'descr': '<f8'", b"'descr': [('x', '<f8'), ('y', '<f8')]", 1)
                 .replace(b"               \n", b"\n"), ("type '[...]'",)),
                (npy(self.points, other=1), ("header",)),
                (good.replace(b"shape", b"shade"), ("header",)),
                (good.replace(b"False", b"Falsy"), ("header",)),
                (good.replace(b"{", b"["), ("header",)),
                (npy(self.points, version=(4, 0)), ("version",)),
                (npy(self.points, version=(1, 1)), ("version",)),
                (good[:-1], ("ends after 2 of 3 points",)),
                (good[:128], ("ends after 0 of 3 points",)),
                (good[:100], ("ends in its .npy header",)),
                (good[:9], ("not a .npy file",))):
            with self.subTest(data=data):
                words = ("scarp: --input: standard input: ",) + words
                self.check_refused(data, *words, arguments=("--output", self.path("o.csv")))
                self.assertEqual(self.files(), [])
        self.check_refused(npy([(1, 2)]), "(1, 2)", arguments=("--dims", "3"))
        self.check_refused(b"\x93NUMPX", ":1: ")
        huge = b"\x93NUMPY\x02\x00" + struct.pack("<I", 1 << 31) + b" " * 200000
        self.check_refused(huge, "header")
        # A row must fit into the input's buffer: 2^17 bytes, of doubles 2^14.
        widest = npy([tuple(range(1 << 14))])
        self.assertEqual(self.text(widest, "--dims", "2", "--output-format", "text"),
                         self.text(b"0 1\n"))
        self.check_refused(npy([tuple(range((1 << 14) + 1))]), "has more than 16384 columns",
                           arguments=("--dims", "2"))

    def test_every_truncation(self):
        """Wherever it ends: one line, no crash."""
        data = npy(self.points, "<f4")
        for length in range(6, len(data)):
            self.check_refused(data[:length], "standard input: ",
                               arguments=("--output", self.path("o.txt")))

    def test_pipe(self):
        """A header that must be completed at the end needs a file."""
        for kind in ("csv", "text"):
            self.check_refused(make_input(kind, self.points), "--output: standard output: ", ".npy",
                               arguments=("--output-format", "npy"))
        with open(self.path("o"), "wb") as file:
            self.assertEqual(run("--output-format", "npy", data=b"1.5 2.25", stdout=file).stderr,
                             b"")
        self.assertEqual(len(read_npy(self.read("o"))[2]), 1)

    @unittest.skipUnless(common.resource, "needs POSIX")
    def test_append(self):
        """Nor may it be completed in what others wrote."""
        for mode, before in (("ab", b""), ("ab", b"before"), ("r+b", b"before")):
            self.write("o", before)
            with open(self.path("o"), mode) as file:
                file.seek(0, os.SEEK_END)
                result = run("--output-format", "npy", data=b"1.5 2.25", stdout=file)
            self.assertEqual((result.returncode, self.read("o")), (2, before))
            self.assertRegex(result.stderr, rb"\Ascarp: --output: standard output: [^\n]+\n\Z")


class Description(Case):
    """The dictionary before the array: a header that NumPy would not write is refused."""

    POINTS = [(1.5, 2.25), (-3.5, 4.75), (0.125, 1000.5)]
    GOOD = b"{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }"

    def array(self, text):
        if isinstance(text, str):
            text = text.encode()
        return (b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text +
                npy(self.POINTS)[128:])

    def setUp(self):
        super().setUp()
        self.bad = []

    def tearDown(self):
        """All headers that check_bad was given: the first and the last by runs, and all of them by one
        process that has the parts of the program."""
        texts = [text for text, _ in self.bad]
        told = refusals(common.PROGRAM, [("npy", text) for text in texts])
        for text, words in self.bad if told is None else self.bad[:1] + self.bad[-1:]:
            self.run_bad(text, *words)
        for (text, words), (came, count, error) in zip(self.bad, told or ()):
            with self.subTest(text=text):
                self.assertEqual((came, count), ("bad", 1), error)
                for word in ("the .npy header ",) + words:
                    self.assertIn(word, error)

    def check_bad(self, text, *words):
        self.bad.append((text.encode() if isinstance(text, str) else text, words))

    def run_bad(self, text, *words):
        with self.subTest(text=text):
            self.check_refused(self.array(text), "scarp: --input: standard input: the .npy header ",
                               *words, arguments=("--output", self.path("o.npy")))
            self.assertEqual(self.files(), [])

    def test_good(self):
        good = self.GOOD.decode()
        expected = self.sample(npy(self.POINTS))
        for text in (good, good + " " * 60 + "\n", good + "\n", good + "\n   \n", "  " + good,
                     good.replace(", }", "}"), good.replace(" ", ""), good.replace("2)", "2,)"),
                     good.replace("2)", "2L)"), good.replace("'", '"'),
                     good.replace("{", "{\n").replace(", ", " ,\n").replace(":", " :")):
            with self.subTest(text=text):
                self.assertEqual(self.sample(self.array(text)), expected)

    def test_twice(self):
        """A key that comes twice, with another value or the same."""
        good = self.GOOD.decode()
        for more in ("'shape': (3, 2)", "'shape': (1, 2)", "'descr': '<f4'", "'descr': '<f8'",
                     "'fortran_order': True", "'fortran_order': False"):
            self.check_bad(good.replace("}", more + "}"), "twice")
            self.check_bad(good.replace("}", more + ", }"), "twice")
            self.check_bad(good.replace("{", "{" + more + ", "), "twice")

    def test_missing(self):
        good = self.GOOD.decode()
        for member in ("'descr': '<f8', ", "'fortran_order': False, ", "'shape': (3, 2), "):
            self.check_bad(good.replace(member, ""), "not all of 'descr', ")
        self.check_bad("{}", "not all of 'descr', ")
        self.check_bad("")

    def test_behind(self):
        """Something behind the closing brace but padding."""
        for more in (b"x", b"}", b"{}", b",", b" 1", b"\n#", b"{'descr': '<f4'}", b"     '\n", b";",
                     b"\0", b"   \0", b"\0\n", b"\t", b"\x0b", b"\xff"):
            self.check_bad(self.GOOD + more)
            self.check_bad(self.GOOD + b" " * 50 + more + b"\n")

    def test_values(self):
        good = self.GOOD.decode()
        for word in ("True1", "False1", "Falsy", "FalseTrue", "false", "0", "None", "Fals",
                     "False.", "'False'", "False False", "(False)", ""):
            self.check_bad(good.replace("False", word))
        for shape in ("(3,,2)", "(3 2)", "(,3,2)", "(3,2,,)", "(03,2)", "(3,02)", "(00,2)",
                      "(3,+2)", "(-3,2)", "(3,-2)", "(+3,2)", "(3,2", "3,2)", "3,2", "(3)", "(,)",
                      "[3,2]", "(3.0,2)", "(3e0,2)", "(0x3,2)", "(3_0,2)", "(3,2 L)", "(3l,2)",
                      "(3LL,2)", "((3,2))", "(3;2)", "('3',2)", "(3, 2))", "()()", "",
                      "(18446744073709551617,2)"):
            self.check_bad(good.replace("(3, 2)", shape))
        for descr in ("<f8", "'<f8", "<f8'", "'<f8\"", "'<f8''", "('<f8')", "u'<f8'", "'<f' '8'",
                      "'<f8\n'", "'\\x3cf8'", "[('x', '<f8')", "[", "[]]", ""):
            self.check_bad(good.replace("'<f8'", descr))

    def test_marks(self):
        """Commas, colons and braces: each must be there, once."""
        good = self.GOOD.decode()
        for i, c in enumerate(good):
            if c in ",:{}()'" and i != good.rindex(","):  # the last comma may be left out
                self.check_bad(good[:i] + good[i + 1:])
                self.check_bad(good[:i] + " " + good[i + 1:])
            if c in ",:{}()'":
                self.check_bad(good[:i] + c + good[i:])

    def test_bytes(self):
        """No control character anywhere, a NUL least of all; not even inside a name."""
        good = self.GOOD
        for c in (b"\0", b"\t", b"\r", b"\x7f", b"\x1b"):
            for i in range(len(good) + 1):
                self.check_bad(good[:i] + c + good[i:])
            for i in range(len(good)):
                self.check_bad(good[:i] + c + good[i + 1:])


class NotFinite(Case):
    """NaN and infinity are no coordinates, as in text: see also Numbers in test_values.py."""

    BAD = (math.nan, -math.nan, math.inf, -math.inf)
    TOLD = b"scarp: --skip-bad: %d malformed %s of standard input %s left out\n"

    def told(self, count):
        return self.TOLD % ((count, b"points", b"were") if count > 1 else (count, b"point", b"was"))

    def test_refused(self):
        for bad, descr, column in itertools.product(self.BAD, ("<f4", "<f8", ">f4", ">f8"),
                                                    (0, 1, 2)):
            points = [[1.5, 2.25, 3.5] for _ in range(5)]
            points[3][column] = bad
            self.check_refused(npy(points, descr), "scarp: --input: standard input: point 4 of 5: "
                               "column %d: '%r' is not a finite number\n" % (column + 1, bad),
                               arguments=("--output", self.path("o.npy")))
            self.assertEqual(self.files(), [])

    def test_other_columns(self):
        """Only coordinates need to be finite."""
        points = [(math.nan, 1.5, math.inf, 2.25)]
        self.assertEqual(self.sample(npy(points), "--columns", "2,4"),
                         self.sample(npy([(1.5, 2.25)])))
        self.assertEqual(self.sample(npy([(1.5, 2.25, math.nan)]), "--dims", "2"),
                         self.sample(npy([(1.5, 2.25)])))
        self.check_refused(npy(points), "point 1 of 1: column 3: 'inf'", arguments=(
            "--columns", "2,3", "--output", self.path("o.npy")))

    def test_earlier_points(self):
        """Standard output has got the points before it, wherever blocks end."""
        for count in (1, 100, BLOCK, 2 * BLOCK + 5):
            points = [(1.0, 2.0)] * count + [(math.nan, 2.0), (math.inf, 1.0), (1.0, 2.0)]
            self.check_refused(npy(points), "point %d of %d: column 1: 'nan'"
                               % (count + 1, count + 3), output=self.sample("1 2") * count,
                               arguments=("--output-format", "text"))

    def test_skip_bad(self):
        """The header of the results has their number."""
        good = some_points(2, 3 * BLOCK + 7)
        points = list(good)
        for i in (len(points), 2 * BLOCK + 1, BLOCK, 5, 5, 0):
            points.insert(i, (1.5, math.nan) if i % 2 else (math.inf, 1.5))
        for keep in ((), ("--keep",)):
            target = self.path("o.npy")
            self.assertEqual(self.sample(npy(points), "--skip-bad", "--output", target, *keep,
                                         error=self.told(6)), b"")
            self.assertEqual(self.read("o.npy"), self.sample(npy(good), *keep))
            descr, columns, rows = read_npy(self.read("o.npy"))
            self.assertEqual((descr, columns, len(rows)), ("<f8", 3, len(good)) if keep
                             else ("<f4", 1, len(good)))
            for kind in ("csv", "text"):
                options = ("--output-format", kind) + keep
                self.assertEqual(self.sample(npy(points), "--skip-bad", *options,
                                             error=self.told(6)), self.sample(npy(good), *options))
        self.sample(npy(points), "--skip-bad", "--quiet", "--output", target)
        self.sample(npy(good), "--skip-bad", "--output", target)  # nothing to tell

    def test_skip_many(self):
        """Whole blocks, and everything."""
        for count in (1, 3 * BLOCK + 1):
            bad = [(math.nan, 1.0)] * count
            self.sample(npy(bad), "--skip-bad", "--output", self.path("o.npy"),
                        error=self.told(count))
            self.assertEqual(read_npy(self.read("o.npy")), ("<f4", 1, []))
            self.assertEqual(self.sample(npy(bad + [(1, 2)] + bad), "--skip-bad", "--output-format",
                                         "text", error=self.told(2 * count)), self.sample("1 2"))

    def test_cut_short(self):
        """Points that were left out count as read."""
        data = npy([(math.nan, 1.0), (1.0, 2.0), (math.nan, 1.0), (1.0, 2.0)])
        self.check_refused(data[:-1], "ends after 3 of 4 points",
                           arguments=("--skip-bad", "--output", self.path("o.npy")))
        self.assertEqual(self.files(), [])

    def test_pipe(self):
        """How many points will be left out is known at the end."""
        self.check_refused(npy([(1, 2)]), "--output: standard output: ", ".npy", "file of its own",
                           arguments=("--skip-bad",))
        with open(self.path("o"), "wb") as file:
            result = run("--skip-bad", data=npy([(1, 2), (math.nan, 1)]), stdout=file)
        self.assertEqual((result.returncode, result.stderr), (0, self.told(1)))
        self.assertEqual(read_npy(self.read("o"))[2], [[float32(float(self.sample("1 2")))]])


common.main(globals())
