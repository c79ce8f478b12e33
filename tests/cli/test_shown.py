# SPDX-License-Identifier: MIT
"""The commands that the documents show run as they are there; the tiles that they make for
engines have the sizes and the shared edges that engines want."""
import os
import re
import shlex
import shutil
import struct
import subprocess

import common
from common import ROOT, Case, run
from rasters import read_bytes
from test_gallery import gallery_commands

# The documents with commands, and how many each has besides those of the gallery, at least
MANUAL = "src/cli/README.md"
DOCUMENTS = {"README.md": 2, MANUAL: 9}


def shown_commands(name):
    """The commands at the beginning of lines in the document's blocks for the shell, but those of
    the gallery and of farms, which have tests of their own, and those of cmake."""
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        text = re.sub(r"(?ms)^## Farms\n.*?^## ", "## ", file.read())
    commands, pictures = [], gallery_commands().values()
    for block in re.findall(r"(?ms)^```sh\n(.*?)^```$", text):
        for line in block.replace("\\\n", "").splitlines():
            if not re.match("scarp |gdaldem ", line):
                continue
            words = shlex.split(line, comments=True)
            if words[1:] not in pictures:
                commands.append(words)
    return commands


def without(words, *options):
    """The words without some options and their values"""
    return [word for before, word in zip([""] + words, words)
            if word not in options and before not in options]


class Shown(Case):
    """Rasters are smaller than in the documents: by 16 along each edge, by 64 large ones."""

    def enter(self, document):
        """Lets commands run in a directory of the document's own."""
        self.here = self.path(document.replace("/", "-"))
        os.makedirs(self.here, exist_ok=True)
        if document in DOCUMENTS:  # the files that blocks write
            with open(os.path.join(ROOT, document), encoding="utf-8") as file:
                files = re.findall(r"(?ms)^cat > (\S+) <<'END'\n(.*?)^END$", file.read())
            for name, text in files:
                with open(os.path.join(self.here, name), "w", encoding="utf-8") as file:
                    file.write(text)

    def made(self, name):
        return read_bytes(os.path.join(self.here, name))

    def smaller(self, words):
        """The words with sizes divided, and formats that are there without zlib."""
        large = any(int(side) > 4096 for word in words if re.fullmatch(r"\d+x\d+", word)
                    for side in word.split("x"))
        words = [re.sub(r"\d+", lambda side: str(int(side.group(0)) // (64 if large else 16)), word)
                 if re.fullmatch(r"\d+x\d+", word) else word for word in words]
        if self.extensions[0] != ".png":
            colours = ("--normals", "--relief") if words[1] == "terrain" else ("--output",)
            words = [re.sub(r"\.png$", ".ppm" if before in colours else ".pgm", word)
                     for before, word in zip([""] + words, words)]
        return words

    def run_shown(self, words):
        """Runs a command of a document; gdaldem only if it is there, and can read the file."""
        words = self.smaller(words)
        if words[0] == "scarp":
            result = run(*words[1:], cwd=self.here)
            self.assertEqual((result.returncode, result.stderr), (0, b""), words)
            return result.stdout.decode()
        if shutil.which(words[0]):
            subprocess.run(words, cwd=self.here, check=True, stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE)
        return ""

    def test_commands(self):
        for name, count in DOCUMENTS.items():
            self.enter(name)
            commands = shown_commands(name)
            self.assertGreaterEqual(len(commands), count, name)
            for words in commands:
                with self.subTest(command=" ".join(words)):
                    self.run_shown(words)

    def sides(self, words):
        """The edges of raster and tile, which are squares."""
        both = [words[words.index(option) + 1].split("x") for option in ("--size", "--tile")]
        self.assertEqual([width for width, _ in both], [height for _, height in both])
        return [int(width) for width, _ in both]

    def tiles(self, words, name):
        """Runs a command, and gives the rows of its 2 x 2 tiles, by their places in the pattern,
        and how many samples they have along an edge."""
        size, tile = self.sides(words)
        self.assertEqual(size, 2 * tile)  # before it is divided
        told = self.run_shown(words)
        self.assertRegex(told, "(?m)^16-bit heights: 0 is .*, 65535 is ")
        words = self.smaller(words)
        size, tile = self.sides(words)
        overlap = int(words[words.index("--overlap") + 1]) if "--overlap" in words else 0
        self.assertEqual(size, 2 * tile)
        side, found = tile + overlap, {}
        for x in range(2):
            for y in range(2):
                data = self.made(name % (x, y))
                self.assertEqual(len(data), 2 * side * side)
                found[x, y] = [data[2 * side * row:2 * side * (row + 1)] for row in range(side)]
        return found, side

    def engine(self, part):
        """The one command of the manual that has this part in a word."""
        found = [words for words in shown_commands(MANUAL)
                 if any(part in word for word in words)]
        self.assertEqual(len(found), 1, part)
        return found[0]

    def test_unity(self):
        """The size is 2^n + 1; edges are shared, rows to the south and columns to the east; y
        counts northward; low bytes come first."""
        self.enter("unity")
        words = self.engine("unity/")
        self.assertEqual(bin(self.sides(words)[1]).count("1"), 1)
        tiles, side = self.tiles(words, "unity/alps_%d_%d.raw")
        for i in range(2):
            self.assertEqual([row[-2:] for row in tiles[0, i]], [row[:2] for row in tiles[1, i]])
            self.assertEqual(tiles[i, 1][-1], tiles[i, 0][0])
        self.run_shown(without(words, "--tile", "--overlap", "--heights") +
                       ["--heights", "whole.r16"])
        data = self.made("whole.r16")
        width = 2 * (side - 1)
        self.assertEqual(data[:2 * side], tiles[0, 1][0])  # north-west
        self.assertEqual(data[2 * width * (side - 1):][:2 * side], tiles[0, 0][0])
        heights = struct.unpack("<%dH" % (len(data) // 2), data)
        steps = sorted(abs(a - b) for a, b in zip(heights, heights[1:]))
        self.assertLess(steps[len(steps) // 2], 8192)  # with bytes swapped they would be noise

    def test_origin_of_unity(self):
        """With --origin 0,1 the overlap of the southernmost row lies at y = 0."""
        self.enter("origin")
        words = self.engine("unity/")
        self.assertEqual(words[words.index("--origin") + 1], "0,1")
        tiles, side = self.tiles(words, "unity/alps_%d_%d.raw")
        self.run_shown(["scarp", "terrain", "--preset", "alps", "--size", "%dx16" % (16 * side),
                        "--heights", "south.r16"])
        self.assertEqual(self.made("south.r16"), tiles[0, 0][-1])

    def test_unreal(self):
        """Names have _x and _y; tiles of World Composition are of a recommended size, and share
        edges; those of World Partition lie side by side."""
        self.enter("unreal")
        words = self.engine("composition/")
        self.assertEqual(words[words.index("--tile") + 1], "1008x1008")
        tiles, _ = self.tiles(words, "composition/alps_x%d_y%d.r16")
        self.assertEqual([row[-2:] for row in tiles[0, 0]], [row[:2] for row in tiles[1, 0]])
        self.assertEqual(tiles[0, 0][-1], tiles[0, 1][0])
        words = self.engine("partition/")
        self.assertNotIn("--overlap", words)
        parts, side = self.tiles(words, "partition/alps_x%d_y%d.r16")
        self.assertEqual([row[:2 * side] for row in tiles[0, 1][:side]], parts[0, 1])
        words = self.engine("unreal.r16")
        self.assertEqual(words[words.index("--size") + 1], "2017x2017")


if __name__ == "__main__":
    common.main(globals())
