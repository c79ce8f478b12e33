# SPDX-License-Identifier: MIT
"""Command lines that are refused, and what is said about them."""
import re

import common
from common import FLAGS, FRACTALS, OPTIONS, SMALL, Case, run, supported_isas, text_of
from refusals import refusals


class Errors(Case):
    """Command lines that ask for what is not possible: nothing may be done."""

    def check(self, option, *arguments):
        with self.subTest(arguments=arguments):
            result = run("terrain", *arguments, cwd=self.directory)
            self.check_one_line(result, 2, option)
            self.assertEqual(self.files(), [])

    def check_all(self, cases):
        """Checks pairs of an option and arguments: the first and the last by runs, and all of them
        by one process that has the parts of the program."""
        told = refusals(common.PROGRAM, [("terrain", *arguments) for _, arguments in cases])
        for option, arguments in cases if told is None else (cases[0], cases[-1]):
            self.check(option, *arguments)
        for (option, arguments), (came, count, error) in zip(cases, told or ()):
            with self.subTest(arguments=arguments):
                self.assertEqual((came, count), ("bad", 1), error)
                self.assertIn(option, error)

    def check_values(self, option, *values):
        self.check_all([(option, (*SMALL, *words)) for value in values
                        for words in ((option, value), (option + "=" + value,))])

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
        cases = []
        for name in ["--" + name for name in OPTIONS]:
            if name[2:] not in FLAGS:
                cases += [(name, (name,)), (name, (name, "--quiet")), (name, (name + "=",))]
            elif name != "--help":
                cases += [(name, (name + "=1",)), (name, (name + "=",))]
        self.check_all(cases)

    def test_numbers(self):
        for option in ("--step", "--height", "--frequency", "--octaves", "--lacunarity", "--gain",
                       "--erosion", "--jitter", "--sharpness", "--of-octaves", "--sea-level", "--azimuth", "--altitude", "--z-factor",
                       "--amplitude", "--phase"):
            self.check_values(option, "", "one", "1x", "1 ", " 1", "1,5", "nan", "inf", "-inf",
                              "1e999", "0x", "1.2.3", "--1", ".", "+")
            if option not in ("--sea-level", "--amplitude", "--phase"):
                self.check_values(option, "-1")

    def test_intervals(self):
        self.check_values("--step", "0", "3.5e-15", "2.9e14")
        self.check_values("--height", "16777217", "-0.001", "1e300")
        self.check_values("--frequency", "0", "-0", "2.3e-10", "2.9e14", "1e-400")
        self.check_values("--octaves", "0", "1e-46", "32.01", "1e39")
        self.check_values("--lacunarity", "0", "0.0624", "16.0001", "1e39")
        self.check_values("--gain", "0", "0.0624", "16.0001", "1e-46")
        self.check_values("--jitter", "0", "-0", "1.0000001", "-1", "1e-46", "nan")
        self.check_values("--erosion", "0", "5.9e-8", "16777217", "-1", "1e39")
        self.check_values("--sharpness", "0", "0.0039", "256.01", "-1", "1e39")
        self.check_values("--of-octaves", "0", "1e-46", "32.01", "1e39")
        self.check_values("--sea-level", "16777217", "-16777217", "1e39")
        self.check_values("--azimuth", "-0.001", "360.001")
        self.check_values("--altitude", "-0.001", "90.001")
        self.check_values("--z-factor", "-0.001", "16777217", "1e39")
        self.check_values("--amplitude", "0", "-0", "5.9e-8", "-5.9e-8", "16777217", "-16777217",
                          "1e39")
        self.check_values("--phase", "3.4028235e38", "-3.4028235e38", "1e39")
        self.check_values("--overlap", "1025", "-1", "+1", "1.5", "one", "",
                          "18446744073709551617")
        self.check_values("--threads", "0", "1025", "-1", "1.5", "two", "",
                          "18446744073709551617")
        self.check_values("--compare", "0", "8", "-1", "+1", "1.5", "1x", "one", "",
                          "18446744073709551617")

    def test_limits_are_told(self):
        """The message names what is allowed, in the words of the help."""
        text = text_of("terrain", "--help")
        for option, value, allowed in (("--erosion", "0", "from 2^-24 to 2^24"),
                                       ("--compare", "8", "from 1 to 7"),
                                       ("--fractal", "fBm", " or ".join(
                                           (", ".join(FRACTALS[:-1]), FRACTALS[-1]))),
                                       ("--basis", "x", "gradient, value, simplex, cell-f1, cell-f2, "
                                                       "cell-edge, cell-soft or cell-value"),
                                       ("--fade", "x", "quintic or cubic")):
            result = run("terrain", option, value, cwd=self.directory)
            self.check_one_line(result, 2, option, "'%s'" % value, allowed)
            entry = re.search(r"\n  %s (?s:.*?)(?=\n  --)" % option, text).group()
            self.assertIn(allowed, " ".join(entry.split()))
        self.assertEqual(self.files(), [])

    def test_last_octave(self):
        for arguments in (("--frequency", "2e14", "--octaves", "2"),
                          ("--lacunarity", "16", "--octaves", "32"),
                          ("--lacunarity", "0.0625", "--octaves", "32")):
            for option in ("--frequency", "--lacunarity", "--octaves"):
                self.check(option, *arguments)

    def test_sizes(self):
        for option in ("--size", "--tile"):
            self.check_sizes(option)

    def check_sizes(self, option):
        self.check_values(option, "64", "64x", "x64", "0x64", "64x0", "-1x64", "64x-1", "64x64x1",
                          "64*64", "1000001x1", "1x1000001", "1.5x2", "64 x64", "64x64 ", "64X64",
                          "99999999999999999999x1", "18446744073709551617x1", "64,64")

    def test_count_of_tiles(self):
        """A run that would write more files than can be meant"""
        for size, tile, more, told in (
                ("100000x100000", "1x1", (), "10000000000"), ("100000x100000", "1x1", ("--verify",), "10000000000"),
                ("1000000x1000000", "1x1", (), "1000000000000"),
                ("100000x100000", "1x1", ("--share", "0/999"), "10010011"),
                ("100000x100000", "1x1", ("--tiles", "0:10001,0:1000"), "10001000"),
                ("7000x1500", "1x1", ("--resume",), "10500000"),
                ("4000x2000", "1x1", ("--levels", "5"), "10656250")):
            with self.subTest(size=size, more=more):
                result = run("terrain", "--size", size, "--tile", tile, *more, "--heights", "h.r32",
                             cwd=self.directory)
                self.check_one_line(result, 2, "--tile: %s tiles" % told, "at most 10000000")
                self.assertEqual(self.files(), [])

    def test_tiles(self):
        self.check_values("--tiles", "0:1", "0:1,", "0:1,0", "0:1,0:1,0:1", "0-1,0-1", "0:1;0:1",
                          "1:1,0:1", "0:1,2:2", "2:1,0:1", "-1:1,0:1", "0:1,0:1.5", "0:1, 0:1",
                          "0:1000001,0:1", "0:1,0:1000001", ":,:", "0:18446744073709551617,0:1")

    def test_origins(self):
        self.check_values("--origin", "1", "1,", ",1", "1,2,3", "1;2", "nan,0", "0,inf", "1, 2",
                          "9.1e15,0", "0,-9.1e15")

    def test_seeds(self):
        self.check_values("--seed", "+1", "-", "--1", "-0x1", "-1.0", "-9223372036854775809", "1.0", "1e3", "18446744073709551616",
                          "0x10000000000000000", "0x", "ff", "0xfg", " 1", "1 ")

    def test_choices(self):
        self.check_values("--basis", "simple", "cell", "Gradient", "gradient ", "")
        self.check_values("--fade", "linear", "quinti", "")
        self.check_values("--fractal", "fBm", "ridge", "erosion ", "0", "")
        self.check_values("--normal-y", "Up", "left", "-1", "")
        self.check_values("--preset", "alp", "Alps", "")
        self.check_values("--isa", "sse9", "none", "", "avx")

    def test_unsupported_isa(self):
        missing = [isa for isa in ("sse4.1", "avx2", "avx512", "neon")
                   if isa not in supported_isas()]
        self.assertTrue(missing)  # no processor has both NEON and AVX
        for isa in missing:
            self.check("--isa", "--isa", isa)

    def test_nearest_name(self):
        """An unknown option suggests the one that was meant, if there is one."""
        for word, meant in (("--octave", "--octaves"), ("--heigts=a.r32", "--heights"),
                            ("--hillshde", "--hillshade"), ("--ocatves", "--octaves"),
                            ("--freq", "--frequency"), ("--band", "--band-limit"),
                            ("-seed", "--seed"), ("--qiet", "--quiet"), ("--sie", "--size"),
                            ("--masks-", "--masks")):
            result = run("terrain", word, "1", cwd=self.directory)
            self.check_one_line(result, 2, word + ": unknown option",
                                "did you mean %s? See: scarp terrain --help" % meant)
        for word in ("--bogus", "--", "-", "-x", "--il", "--o", "--e", "x" * 40, "--" + "y" * 40):
            error = run("terrain", word, cwd=self.directory).stderr.decode()
            self.assertNotIn("did you mean", error, word)
        result = run("sample", "--outptu", "a.csv", cwd=self.directory)
        self.check_one_line(result, 2, "did you mean --output? See: scarp sample --help")

    def test_twice(self):
        """Of two files of one option the first would be forgotten."""
        for option, value in (("--heights", "a.r32"), ("--output", "t"), ("--masks", "m"),
                              ("--palette", "grey"), ("--recipe", "r")):
            self.check(option, *SMALL, option, value, option + "=" + value)
            error = run("terrain", *SMALL, option, value, option, "b.r32", cwd=self.directory)
            self.check_one_line(error, 2, option + ": is given twice")
        run("sample", "--input", "-", "--output", "-", cwd=self.directory, input=b"")
        result = run("sample", "--output", "a.csv", "--output", "b.csv", cwd=self.directory,
                     input=b"1,2\n")
        self.check_one_line(result, 2, "--output: is given twice")
        self.assertEqual(self.files(), [])
        self.quietly(*SMALL, "--gain", "0.3", "--gain", "0.4", "--heights", "a.r32")  # the last one

    def test_first_good_then_bad(self):
        self.check("--gain", *SMALL, "--gain", "0.5", "--gain", "x")
        self.check("--bogus", "--quiet", "--bogus")


common.main(globals())
