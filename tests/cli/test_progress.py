# SPDX-License-Identifier: MIT
"""What is printed on the way and at the end."""
import os
import re
import unittest

import common
from common import SMALL, Case, has_threads, run, text_of

# In the manner of GDAL's programs
ALL = "0...10...20...30...40...50...60...70...80...90...100"
SUMMARY = (r"\A%s samples in (?:[1-9]\d*\.\d{3} s|\d+\.\d ms|\d+\.\d us): "
           r"(?:[1-9]\d{0,2}|\d{1,2}\.\d*[1-9]|[1-9]\d{0,2}\.\d (?:thousand|million|billion)) samples per second "
           r"\((\S+), (\d+) threads?\)\n\Z")
HEIGHTS = r"16-bit heights: 0 is \S+, 65535 is \S+\n"


class Progress(Case):
    """What is printed on the way and at the end."""

    def test_summary(self):
        result = run("terrain", "--size", "70x50", "--isa", "scalar", "--output", self.path("t"))
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        found = re.search(SUMMARY % (HEIGHTS + "70x50"), result.stdout.decode())
        self.assertEqual(found.group(1), "scalar")

    def test_units(self):
        """They suit the amounts: no raster is so small that 0.0 million samples are printed."""
        for size in ("1x1", "3x1", "40x30", "2000x1500"):
            result = run("terrain", "--size", size, "--octaves", "1", "--heights", "h.r32",
                         cwd=self.directory)
            self.assertRegex(result.stdout.decode(), SUMMARY % size)

    def test_best_isa_by_default(self):
        result = run("terrain", *SMALL, "--output", self.path("t"))
        active = re.search(r"(?m)^(\S+) +yes +yes$", text_of("info")).group(1)
        self.assertEqual(re.search(SUMMARY % (HEIGHTS + "40x30"), result.stdout.decode()).group(1),
                         active)

    def threads_told(self, size, *arguments):
        result = run("terrain", "--octaves", "1", "--size", size, *arguments, "--heights",
                     self.path("h.r32"))
        count = re.search(SUMMARY % size, result.stdout.decode()).group(2)
        self.assertEqual("%s threads)" % count in result.stdout.decode(), count != "1")
        return count

    def test_threads_are_told(self):
        """How many worked: a small raster is one thread's, whatever was allowed."""
        for count in ("1", "2", "7") if has_threads() else ("1",):
            self.assertEqual(self.threads_told("3000x300", "--threads", count), count)
            self.assertEqual(self.threads_told("40x30", "--threads", count), "1")
        expected = re.search(r"(?m)^threads +POSIX: (\d+)", text_of("info"))
        self.assertEqual(self.threads_told("3000x300"),
                         str(min(int(expected.group(1)), 12)) if expected else "1")

    def test_tiles_are_told(self):
        """How many were written, without those that were there."""
        arguments = ("terrain", *SMALL, "--tile", "10x10", "--heights", self.path("t.r32"))
        self.assertRegex(run(*arguments).stdout.decode(),
                         SUMMARY % "12 tiles, 1200")
        for name in ("t_0_0.r32", "t_2_3.r32"):
            os.remove(self.path(name))
        self.assertRegex(run(*arguments, "--resume").stdout.decode(),
                         SUMMARY % "2 tiles, 200")
        self.assertEqual(run(*arguments, "--resume").stdout,
                         b"nothing to do: all files are there\n")

    def test_file_on_standard_output(self):
        """It has standard output for itself: the summary goes to stderr."""
        result = run("terrain", *SMALL, "--heights", "r32:-", "--normals", self.path("t.npy"))
        self.assertRegex(result.stderr.decode(), SUMMARY % "40x30")
        self.assertEqual(len(result.stdout), 40 * 30 * 4)

    def test_heights_are_told(self):
        """Before the closing line, whether anything was written or not; of integers only."""
        for name, line in (("h.r16", HEIGHTS), ("h.pgm", HEIGHTS), ("pgm:h.r32", HEIGHTS),
                           ("h.r32", ""), ("h.npy", ""), ("h.img", ""), ("r32:h.pgm", "")):
            with self.subTest(name=name):
                result = run("terrain", *SMALL, "--normals", "n.npy", "--heights", name,
                             cwd=self.directory)
                self.assertRegex(result.stdout.decode(), SUMMARY % (line + "40x30"))
        arguments = (*SMALL, "--tile", "20x20", "--heights", "h.r16", "--resume")
        for last in (SUMMARY % (HEIGHTS + "4 tiles, 1200"),
                     r"\A" + HEIGHTS + r"nothing to do: all files are there\n\Z"):
            result = run("terrain", *arguments, cwd=self.directory)
            self.assertRegex(result.stdout.decode(), last)
        result = run("terrain", *SMALL, "--heights", "r16:-")
        self.assertRegex(result.stderr.decode(), SUMMARY % (HEIGHTS + "40x30"))
        self.assertEqual(len(result.stdout), 40 * 30 * 2)

    def test_quiet(self):
        result = run("terrain", *SMALL, "--quiet", "--output", self.path("t"))
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""))
        self.assertEqual(len(self.files()), 4)

    @unittest.skipUnless(common.pty, "needs POSIX")
    def test_terminal(self):
        arguments = ("terrain", "--size", "1200x700", "--threads", "1", "--output", self.path("t"))
        self.assertEqual(self.on_terminal(*arguments), (0, ALL + " - done.\r\n"))
        self.assertEqual(self.on_terminal(*arguments, "--quiet"), (0, ""))

    @unittest.skipUnless(common.pty, "needs POSIX")
    def test_tiles_on_terminal(self):
        """One line for all tiles together; those that are left out count as done."""
        arguments = ("terrain", *SMALL, "--tile", "12x7", "--overlap", "1", "--heights",
                     self.path("t.r32"))
        self.assertEqual(self.on_terminal(*arguments), (0, ALL + " - done.\r\n"))
        os.remove(self.path("t_1_1.r32"))
        self.assertEqual(self.on_terminal(*arguments, "--resume"), (0, ALL + " - done.\r\n"))

    @unittest.skipUnless(common.pty, "needs POSIX")
    def test_error_on_terminal(self):
        """The message has a line of its own, whenever it comes."""
        os.mkdir(self.path("directory"))
        for target, limit, status in (("directory", 10 ** 6, 2), ("missing/t", 10 ** 6, 2),
                                      ("t", 1024, 1), ("t", 10 ** 6, 1), ("t", 3359999, 1)):
            with self.subTest(target=target, limit=limit):
                result, shown = self.on_terminal("terrain", "--size", "1200x700", "--threads", "1",
                                                 "--heights", "r32:" + self.path(target),
                                                 preexec_fn=common.file_limit(limit))
                self.assertEqual(result, status, shown)
                ticks, error, end = shown.split("\r\n")
                self.assertTrue(ALL.startswith(ticks) and ticks, shown)
                self.assertTrue(error.startswith("scarp: --heights: "), shown)
                self.assertEqual(end, "")
                self.assertEqual(self.files(), ["directory"])


common.main(globals())
