# SPDX-License-Identifier: MIT
"""What is asked for help and facts."""
import os
import re
import unittest

import common
from common import OPTIONS, Case, has_threads, run, text_of

FORMATS = ["pgm", "ppm", "r16", "r32", "pfm", "img", "tif", "npy"]
GROUPS = ["the raster", "files, any number in one run", "how they look", "tiles",
          "the terrain", "one noise, without --preset and --recipe", "running"]


class Commands(Case):
    """What is asked for help and facts."""

    def test_info(self):
        text = text_of("info")
        self.assertRegex(text, r"\Ascarp \d+\.\d+\.\d+\n")
        self.assertNotIn("warning", text)
        rows = re.findall(r"^(\S+) +(yes|no) +(yes|no)$", text, re.MULTILINE)
        self.assertEqual([row[0] for row in rows],
                         ["scalar", "sse4.1", "avx2", "avx512", "neon", "generic", "wasm128"])
        self.assertEqual(rows[0][1], "yes")
        active = [row for row in rows if row[2] == "yes"]
        self.assertEqual(len(active), 1)
        self.assertEqual(active[0][1], "yes")
        png, threads, formats = re.search(r"\n\nzlib +(.+)\nthreads +(.+)\nformats +(.+)\n\Z",
                                          text).groups()
        self.assertRegex(png, r"\A(\d+\.\d+|not found: )")
        self.assertRegex(threads, r"\A(POSIX: \d+|not found: one thread)\Z")
        self.assertEqual(formats.split(), ["png"] * (png[0] != "n") + FORMATS)

    @unittest.skipUnless(hasattr(os, "sched_setaffinity"), "needs Linux")
    def test_processors(self):
        """As many threads as there are processors that the program may use."""
        if not has_threads():
            self.skipTest("this program has no threads")
        allowed = sorted(os.sched_getaffinity(0))
        self.assertIn("threads          POSIX: %d\n" % len(allowed), text_of("info"))
        result = run("info", preexec_fn=lambda: os.sched_setaffinity(0, allowed[-1:]))
        self.assertIn(b"threads          POSIX: 1\n", result.stdout)

    def test_version(self):
        self.assertEqual(text_of("--version"), text_of("info").split("\n")[0] + "\n")

    def test_help(self):
        usage = text_of("--help")
        for command in ("terrain", "view", "sheet", "sample", "recipe", "info", "help"):
            self.assertRegex(usage, r"(?m)^  %s " % command)
        self.assertEqual(text_of("help"), usage)
        self.assertEqual(text_of("-h"), usage)
        for command in ("terrain", "view", "sheet", "sample", "recipe", "info"):
            help_text = text_of(command, "--help")
            self.assertTrue(help_text.startswith("usage: scarp " + command))
            self.assertEqual(text_of("help", command), help_text)
            self.assertEqual(text_of(command, "-h"), help_text)

    def test_terrain_help(self):
        text = text_of("terrain", "--help")
        self.assertEqual(re.findall(r"(?m)^  --(\S+)", text), list(OPTIONS))
        self.assertLessEqual(max(len(line) for line in text.split("\n")), 90)
        self.assertEqual(re.findall(r"(?m)^(\w[^\n]*):$", text), GROUPS)
        for word in ("STEM-height", "STEM-normal", "STEM-hillshade", "STEM-relief",
                     "STEM-compare"):
            self.assertIn(word, text)
        stem = re.search(r"\n  --output (?s:.*?)(?=\n  --)", text).group()
        for end in set(self.extensions):
            self.assertIn(end, stem)

    def test_formats_are_told(self):
        """Every format that the program has is in its help, and not a word of others."""
        text = text_of("terrain", "--help")
        options = text[:text.index("\nhow they look")]
        told = set(re.findall(r" \.(\w+)", options)) - {"png"}
        self.assertEqual(told, set(FORMATS))

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


common.main(globals())
