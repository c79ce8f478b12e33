# SPDX-License-Identifier: MIT
"""Files that somebody else has to do with: another run, a link, another user."""
import os
import unittest

import common
from common import SMALL, Case, run, start

LARGE = ["--size", "400x300"]  # normals fill a pipe


@unittest.skipUnless(common.resource, "needs POSIX")
class Shared(Case):
    def read_file(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def write_file(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)

    def test_two_runs(self):
        """The second is refused as long as the first, which a pipe holds up, writes the file."""
        self.quietly(*LARGE, "--heights", "r32:whole")
        os.mkfifo(self.path("pipe"))
        first = start("terrain", *LARGE, "--heights", "r32:" + self.path("a"), "--normals",
                      "npy:" + self.path("pipe"), "--quiet")
        with open(self.path("pipe"), "rb") as pipe:  # waits for the first run to open it
            self.assertIn("a.part", self.files())
            result = run("terrain", *SMALL, "--seed", "9", "--heights", "r32:" + self.path("a"))
            self.check_one_line(result, 2, "--heights", "another run")
            self.assertIn("a.part", self.files())
            pipe.read()
        self.assertEqual((*first.communicate(), first.returncode), (b"", b"", 0))
        self.assertEqual(self.read_file("a"), self.read_file("whole"))
        self.assertNotIn("a.part", self.files())

    def test_after_a_killed_run(self):
        """What it left is not locked."""
        os.mkfifo(self.path("pipe"))
        first = start("terrain", *LARGE, "--heights", "r32:" + self.path("a"), "--normals",
                      "npy:" + self.path("pipe"), "--quiet")
        with open(self.path("pipe"), "rb"):
            first.kill()
            first.communicate()
        self.assertIn("a.part", self.files())
        self.quietly(*SMALL, "--heights", "r32:a")
        self.assertEqual(self.files(), ["a", "pipe"])

    def test_link(self):
        """What it leads to is replaced."""
        os.mkdir(self.path("real"))
        self.write_file("real/r.r32", b"old")
        os.symlink(os.path.join("real", "r.r32"), self.path("link.r32"))
        self.quietly(*SMALL, "--heights", "link.r32")
        self.assertTrue(os.path.islink(self.path("link.r32")))
        self.assertEqual(len(self.read_file("real/r.r32")), 40 * 30 * 4)
        self.assertEqual(os.listdir(self.path("real")), ["r.r32"])

    def test_name_is_taken(self):
        """By a directory, while the run goes on: what has its name by then stays, and is whole."""
        self.write_file("h.r32", b"old")
        os.mkfifo(self.path("pipe"))
        first = start("terrain", *LARGE, "--heights", self.path("h.r32"), "--normals",
                      self.path("n.npy"), "--gradient", "npy:" + self.path("pipe"), "--quiet")
        with open(self.path("pipe"), "rb") as pipe:
            os.makedirs(self.path("n.npy/taken"))
            pipe.read()
        error = first.communicate()[1].decode()
        self.assertEqual(first.returncode, 1)
        self.assertRegex(error, r"\Ascarp: --normals: [^\n]*n\.npy: [^\n]+\n\Z")
        self.assertEqual(self.files(), ["h.r32", "n.npy", "pipe"])
        self.assertEqual(len(self.read_file("h.r32")), 400 * 300 * 4)

    def test_header_of_envi(self):
        """Without it, the raster is not complete."""
        self.quietly(*SMALL, "--heights", "a.IMG")
        self.assertEqual(self.files(), ["a.IMG", "a.hdr"])
        os.remove(self.path("a.hdr"))
        self.quietly(*SMALL, "--heights", "a.IMG", "--resume")
        self.assertEqual(self.files(), ["a.IMG", "a.hdr"])

    @unittest.skipUnless(os.path.exists("/dev/stdout"), "needs /dev/stdout")
    def test_device(self):
        """The closing line does not follow what went to standard output under another name."""
        result = run("terrain", "--size", "2x1", "--heights", "r32:/dev/stdout")
        self.assertEqual((result.returncode, len(result.stdout)), (0, 8))


common.main(globals())
