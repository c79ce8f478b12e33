# SPDX-License-Identifier: MIT
"""When files appear, and when they must not."""
import os

import common
from common import SMALL, Case, run
from rasters import read_picture

class Files(Case):
    """When files appear, and when they must not."""

    def test_default_stem(self):
        result = run("terrain", "--size", "20x10", cwd=self.directory)
        self.assertEqual(result.returncode, 0)
        self.assertEqual(self.files(), sorted(self.names("terrain")))

    def test_shapes(self):
        for width, height in ((1, 1), (7, 5), (65, 3), (1, 70000), (70000, 1),
                              (1000000, 1)):
            with self.subTest(width=width, height=height):
                self.terrain("--size", "%dx%d" % (width, height))
                pictures = [read_picture(self.path(name)) for name in self.names("t")]
                self.assertEqual([picture.shape() for picture in pictures],
                                 [(width, height, 1, 16), (width, height, 3, 8),
                                  (width, height, 1, 8), (width, height, 3, 8)])

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
        os.remove(self.path(names[3]))
        os.mkdir(self.path(names[1]))
        result = run("terrain", *SMALL, "--seed", "9", "--output", self.path("t"))
        self.check_one_line(result, 2, "--output", names[1])
        self.assertEqual(self.files(), sorted(names[:2]))
        with open(self.path(names[0]), "rb") as file:
            self.assertEqual(file.read(), old)


common.main(globals())
