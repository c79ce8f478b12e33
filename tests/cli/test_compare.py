# SPDX-License-Identifier: MIT
"""The picture of normals from the gradient next to normals from differences."""
import math

import common
from common import SMALL, Case
from rasters import read_picture

class Compare(Case):
    """The picture of normals from the gradient next to normals from differences."""

    RIDGED = ("--fractal", "ridged", "--rotate", "--frequency", "0.02", "--octaves", "5")

    def compare(self, pixels, *arguments):
        """The three usual pictures, and the two halves of the fourth."""
        self.terrain(*arguments, "--compare", str(pixels))
        pictures = [read_picture(self.path(name)) for name in self.names("t")]
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
            (_, normal, *_), left, _ = self.compare(pixels, "--size", "19x11", *self.RIDGED)
            self.check_rows(left, [[sample for sample in row for _ in range(pixels)]
                                   for row in normal.rows for _ in range(pixels)])

    def test_differences_half(self):
        """Follows from the 16-bit heights only; at the edges from those of the next tiles."""
        width, height, scale = 31, 23, 30.0
        for fractal, share, more in (
                ("ridged", 1.0, ()), ("fbm", 2.0, ()),
                ("fbm", 0.375, ("--sea-level", "-0.125", "--plateau", "0.25")),
                ("ridged", 0.0, ("--sea-level", "1"))):
            for step in (0.25, 1.0):
                arguments = [*self.RIDGED, "--fractal", fractal, "--step", str(step), "--height",
                             str(scale), *more]
                _, _, right = self.compare(2, "--size", "%dx%d" % (width, height), *arguments)
                around = self.pictures("--size", "%dx%d" % (width + 2, height + 2), "--origin",
                                       "%g,%g" % (-step, -step), *arguments)[0].rows
                unit = share / 65535 * scale / (2 * step)
                for r in range(height):
                    for c in range(width):
                        dx = (around[r + 1][c + 2] - around[r + 1][c]) * unit
                        dy = (around[r][c + 1] - around[r + 2][c + 1]) * unit
                        length = math.hypot(dx, dy, 1)
                        expected = [127.5 * part / length + 127.5 for part in (-dx, -dy, 1)]
                        for one in (right[2 * r][2 * c], right[2 * r + 1][2 * c + 1]):
                            for a, b in zip(one, expected):
                                self.assertLess(abs(a - b), 0.51, (fractal, more, step, r, c))

    def test_down(self):
        """--normal-y turns the second component over, in both halves."""
        arguments = ("--size", "19x11", *self.RIDGED, "--height", "9")
        up = self.compare(2, *arguments)[1:]
        down = self.compare(2, *arguments, "--normal-y", "down")[1:]
        for one, other in zip(up, down):
            pairs = [pair for p, q in zip(one, other) for pair in zip(p, q)]
            self.assertGreater(len({a[1] for a, _ in pairs}), 20)
            for a, b in pairs:
                self.assertEqual((a[0], a[2]), (b[0], b[2]))
                self.assertIn(a[1] + b[1], (255, 256))

    def test_blocks(self):
        """Wide pictures are made in several blocks of rows, and differ from tiles in nothing."""
        _, _, whole = self.compare(1, "--size", "3000x20", *self.RIDGED)
        _, _, tile = self.compare(1, "--size", "100x9", "--origin", "1500,8", *self.RIDGED)
        self.check_rows(tile, [row[1500:1600] for row in whole[3:12]])

    def test_they_differ(self):
        """The gradient shows a crest that differences smear."""
        _, left, right = self.compare(1, "--size", "64x64", *self.RIDGED)
        far = sum(max(abs(a - b) for a, b in zip(p, q)) > 40
                  for one, other in zip(left, right) for p, q in zip(one, other))
        self.assertGreater(far, 64)

    def test_widest(self):
        self.terrain("--size", "65536x1", "--compare", "7", "--octaves", "1")
        self.terrain("--size", "1x65536", "--compare", "7", "--octaves", "1")


common.main(globals())
