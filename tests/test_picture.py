# SPDX-License-Identifier: MIT
"""The examples src/examples/*.c that draw pictures: what they draw, and what they refuse.

    test_picture.py EXAMPLE Arguments|Picture|Small|isa=NAME [EMULATOR...] PROGRAM

An EXAMPLE may be one of the recipes in src/examples/recipes, which the program paint draws.
Where a picture is meant to change, this writes EXAMPLE.png anew, and prints what its line of SMALL
has to be:

    test_picture.py EXAMPLE --write PROGRAM
"""
import hashlib
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "cli"))
from pngs import encode_png
from rasters import decode_png, decode_pnm

SKIPPED = 77
PICTURES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "src", "examples")
LARGEST_FILE = 500 * 1000
WIDTH_HEIGHT = {"cloud": (960, 540)}
# How the recipes are drawn
RECIPES = {"alps": "--units 1600 --seed 3", "overworld": "--units 6000 --seed 20",
           "range": "--units 5000 --seed 1", "marble": "--units 3 --tones --seed 1",
           "clouds": "--units 6000 --seed 4"}
# SHA-256 of small pictures, on every machine; where code runs slowly, the smallest is enough
SMALL = {
    "cloud": {"32x18": "7b447340771cfc4db51f94542124b8f39ffbec4311b55aa55593a1ca4bcbc113",
              "96x54": "f0d89c54f585aea39c292b40962a2294b40f583d692ce42b0fc6f118b15b8fb9"},
    "mountains": {"32x18": "9e061547d276b03910eda45293476b0f9c436f4355701788599dc47665b87489",
                  "96x54": "346e8874722b87193411b19a17332852d4a20f9111fb501f66cec8a6c67acdcb"},
    "alps": {"32x18": "69d17e83862aec071861bd4e40ffdde8ef232ecb5e63ae499c757d784611e94c",
               "96x54": "5b682f1f4572638ae5300c39944d9575754cb52fabd8609bfb6ca6290ba37cbf"},
    "overworld": {"32x18": "5115c2baf3a208cfe98d9b53c0436baf439fc83a8e777f2cef05de5e7159b66d",
               "96x54": "9d1a9303c541b270bd93d377235a3b08ee2499b017599041b5961777569f92b3"},
    "range": {"32x18": "6f30056c594764c0a35137b9287871d4a4bbc4d291ee399b84ada7027bdd7c76",
               "96x54": "2f4b4c62d42fd5000ce986898c33e4bd28564fccee67dd4320e631dd49fd8d5f"},
    "marble": {"32x18": "aa86cf5a12246891654eb017fc61085eb285b3f94151a68477fda23b26f246cf",
               "96x54": "3cff2d5b67a07fbae1793e47b02ca55ffe323776b6d6a2b0b7bea2b149cdb99a"},
    "clouds": {"32x18": "3f3d63e2d232eb34d355d593f539e882ffef72c608585ac6c6be9c9722c6e81b",
               "96x54": "5189a327111e9dbcd353752de0244eb0e4061eccf2a25ebe8ff431b2d9db7a20"},
}
SIZES = ["32x18", "96x54"] if os.environ.get("SCARP_SPEED") == "full" else ["32x18"]
EXAMPLE = sys.argv[1]
NAME = "paint" if EXAMPLE in RECIPES else EXAMPLE  # of the program
FOLDER = os.path.join(PICTURES, "recipes") if EXAMPLE in RECIPES else PICTURES
PICTURE = os.path.join(FOLDER, EXAMPLE + ".png")
PROGRAM = []


def run(*arguments):
    return subprocess.run(PROGRAM + list(arguments), stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE)


def sha256(data):
    return hashlib.sha256(data).hexdigest()


class Isa(unittest.TestCase):
    name = None

    def test_bytes(self):
        for size in SIZES:
            drawn = run("--isa", self.name, size)
            self.assertEqual((drawn.returncode, drawn.stderr), (0, b""))
            self.assertEqual(sha256(drawn.stdout), SMALL[EXAMPLE][size], size)


class Small(unittest.TestCase):
    def test_bytes(self):
        for size in SIZES:
            self.assertEqual(sha256(run(size).stdout), SMALL[EXAMPLE][size], size)


class Arguments(unittest.TestCase):
    def refused(self, *arguments):
        result = run(*arguments)
        self.assertEqual((result.returncode, result.stdout), (2, b""), arguments)
        self.assertRegex(result.stderr.decode(), NAME + r": [^\n]+\n\Z")
        return result.stderr.decode()

    def test_sizes(self):
        for size in ("1x1", "5x2", "2x7"):
            drawn = run(size)
            self.assertEqual((drawn.returncode, drawn.stderr), (0, b""))
            picture = decode_pnm(drawn.stdout)
            self.assertEqual("%dx%d" % (picture.width, picture.height), size)

    def test_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "picture.ppm")
            written = run(path, "5x2")
            self.assertEqual((written.returncode, written.stdout, written.stderr), (0, b"", b""))
            with open(path, "rb") as file:
                self.assertEqual(file.read(), run("5x2").stdout)
            failed = run("5x2", os.path.join(folder, "missing", "picture.ppm"))
            self.assertEqual((failed.returncode, failed.stdout), (1, b""))
            self.assertRegex(failed.stderr.decode(), NAME + r": [^\n]+\n\Z")

    def test_refused(self):
        for size in ("0x5", "5x0", "960", "960x", "960x540x2", "16385x1", "1x16385", "9e9x1",
                     "99999999999999999999x1", "1x99999999999999999999", "5 x5", "5x-5"):
            self.assertIn("16384", self.refused(size))
        for arguments in (["--isa"], ["--help"], ["-"], ["a.ppm", "b.ppm"], ["5x2", "--isa"]):
            self.assertIn("usage", self.refused(*arguments))
        self.assertIn("--isa", self.refused("--isa", "abacus", "5x2"))
        self.assertIn("--isa", self.refused("--isa", "", "5x2"))


class Picture(unittest.TestCase):
    def test_pixels(self):
        with open(PICTURE, "rb") as file:
            committed = file.read()
        self.assertLess(len(committed), LARGEST_FILE)
        drawn, shown = decode_pnm(run().stdout), decode_png(committed)
        self.assertEqual(shown.shape(), (*WIDTH_HEIGHT.get(EXAMPLE, (640, 360)), 3, 8))
        self.assertEqual(drawn.shape(), shown.shape())
        self.assertTrue(drawn.rows == shown.rows, PICTURE + " is another picture")


def write():
    with open(PICTURE, "wb") as file:
        file.write(encode_png(run().stdout))
    print({size: sha256(run(size).stdout) for size in ("32x18", "96x54")})


def main():
    group, PROGRAM[:] = sys.argv[2], sys.argv[3:]
    if EXAMPLE in RECIPES:
        PROGRAM.extend(RECIPES[EXAMPLE].split() + [os.path.join(FOLDER, EXAMPLE + ".recipe")])
    if group == "--write":
        return write()
    if group.startswith("isa="):
        Isa.name = group[len("isa="):]
        group = "Isa"
        if run("--isa", Isa.name, "1x1").returncode == 2:
            required = Isa.name in os.environ.get("SCARP_REQUIRE_ISAS", "").split(",")
            print("%s cannot run here: %s" % (Isa.name, "FAILED (required)" if required else
                                              "skipped"))
            sys.exit(1 if required else SKIPPED)
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(globals()[group])
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(tests)
    sys.exit(0 if result.wasSuccessful() else 1)


if __name__ == "__main__":
    main()
