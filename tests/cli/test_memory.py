# SPDX-License-Identifier: MIT
"""A raster of any size takes little memory."""
import os
import subprocess
import sys

import common
from common import PROGRAM, Case, has_threads, skip_all

if not sys.platform.startswith("linux"):
    skip_all("only Linux shows the memory of one process in known units")
if common.SPEED != "full":
    skip_all("%s: what is added to the program takes memory and time" % common.SPEED)

MEBIBYTES = 1 << 10  # in the unit of ru_maxrss


class Memory(Case):
    def peak(self, *arguments):
        """The most that was resident at once, in MiB"""
        process = subprocess.Popen([*PROGRAM, "terrain", *arguments, "--octaves", "1", "--quiet",
                                    *(("--threads", "2") if has_threads() else ())],
                                   cwd=self.directory)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return usage.ru_maxrss / MEBIBYTES

    def test_large(self):
        """134 million samples, whose files would take 2 GB"""
        self.assertLess(self.peak("--size", "32768x4096", "--heights", "r32:/dev/null",
                                  "--normals", "npy:/dev/null"), 120)

    def test_wide(self):
        """As the help says: 32 rows of the files, where these are more; here 122 MiB."""
        self.assertLess(self.peak("--size", "1000000x40", "--heights", "r32:/dev/null"), 122 + 30)

    def test_tiles(self):
        """What a tile took is given back."""
        whole = self.peak("--size", "256x256", "--heights", "r32:/dev/null")
        tiles = self.peak("--size", "1024x1024", "--tile", "16x16", "--heights", "h.r32",
                          "--normals", "n.npy")
        self.assertLess(tiles, whole + 20)


common.main(globals())
