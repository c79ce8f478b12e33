#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The program src/gpu/samples/relief.c: its picture by a Vulkan device is, byte for byte, that by the library,
and the one in the document. Where the shader gives other bits, it says so.

    relief.py RELIEF SHADER FUSED PICTURE [SPIRV_OPT]      FUSED is the shader with SCARP_FUSE
    relief.py --write RELIEF PICTURE           writes the picture anew
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # among the sources
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "cli"))
from pngs import encode_png  # noqa: E402
from rasters import decode_png, decode_pnm  # noqa: E402

LARGEST_FILE = 800 * 1000
RELIEF = SHADER = FUSED = PICTURE = OPTIMISER = None


def run(*arguments):
    return subprocess.run([RELIEF, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True)


class Relief(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def drawn(self, *shader):
        """What the program says, and the bytes of its picture."""
        path = self.folder / "relief.ppm"
        result = run(path, *shader)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout, path.read_bytes()

    def test_device(self):
        said, by_device = self.drawn(SHADER)
        self.assertRegex(said, r"\A.+ keeps the bits: 4096 of 4096 answers are equal\n"
                               r"3712 of 3712 heights are the library's\n\Z")
        said, by_library = self.drawn()
        self.assertEqual(said, "")
        self.assertTrue(by_device == by_library, "the pictures differ")

    def test_optimised(self):
        """What the document advises for compile times keeps the bits."""
        if not OPTIMISER:
            self.skipTest("spirv-opt is missing")
        shader = self.folder / "optimised.spv"
        subprocess.run([OPTIMISER, "-O", SHADER, "-o", shader], check=True)
        self.assertLess(shader.stat().st_size, pathlib.Path(SHADER).stat().st_size)
        self.assertIn(" keeps the bits: 4096 of 4096 ", self.drawn(shader)[0])

    def test_fused(self):
        """The control: a shader that gives its bits up is found out by all three comparisons."""
        said, by_device = self.drawn(FUSED)
        self.assertIn(" DOES NOT KEEP the bits: ", said)
        equal, of = map(int, re.search(r"^(\d+) of (\d+) heights", said, re.M).groups())
        self.assertLess(equal, of)
        self.assertFalse(by_device == self.drawn()[1], "the pictures are equal")

    def test_document(self):
        """The picture in the document is the program's."""
        committed = pathlib.Path(PICTURE).read_bytes()
        self.assertLess(len(committed), LARGEST_FILE)
        drawn, shown = decode_pnm(self.drawn()[1]), decode_png(committed)
        self.assertEqual(drawn.shape(), shown.shape())
        self.assertTrue(drawn.rows == shown.rows, PICTURE + " is another picture")

    def test_refused(self):
        self.assertIn("usage", run().stderr)
        for arguments in (["missing/relief.ppm"], ["relief.ppm", "missing.spv"], ["a", "b", "c"]):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stdout), (1, ""), arguments)
            self.assertRegex(result.stderr, r"\A(relief: .+ failed|usage: .+)\n\Z")


def write(relief, picture):
    """Packs the library's picture."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "relief.ppm")
        subprocess.run([relief, path], check=True)
        pathlib.Path(picture).write_bytes(encode_png(pathlib.Path(path).read_bytes()))


if __name__ == "__main__":
    if sys.argv[1] == "--write":
        write(*sys.argv[2:])
    else:
        RELIEF, SHADER, FUSED, PICTURE, *optimisers = sys.argv[1:]
        OPTIMISER = optimisers[0] if optimisers else None
        unittest.main(argv=sys.argv[:1], verbosity=2)
