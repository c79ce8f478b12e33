# SPDX-License-Identifier: MIT
"""Files and standard output have the committed hashes on every system. PNG is not among them: its
bytes are those of one version of zlib.

    test_golden.py print PROGRAM...   prints tests/cli/golden.txt anew
"""
import hashlib
import os
import sys

import common

LIST = os.path.join(os.path.dirname(os.path.abspath(__file__)), "golden.txt")
NOISE = ["--size", "61x47", "--origin", "-3.5,1e3", "--seed", "7", "--octaves", "5.5", "--frequency",
         "0.03", "--quiet"]
POINTS = b"x,y,name\n1,2,a\n-0.25,1e-3,b\n1e5,3.14159274,c\n"
# The name of a case, its arguments, what it reads, and the files that it makes
CASES = (
    ("arrays", ["terrain", *NOISE, "--rotate", "--heights", "h.r32", "--normals", "n.npy",
                "--hillshade", "s.pgm", "--gradient", "g.npy"], b"",
     ("h.r32", "n.npy", "s.pgm", "g.npy")),
    ("pictures", ["terrain", *NOISE, "--fractal", "ridged", "--basis", "simplex", "--heights",
                  "h.pgm", "--normals", "n.ppm", "--hillshade", "s.img"], b"",
     ("h.pgm", "n.ppm", "s.img", "s.hdr")),
    ("floats", ["terrain", *NOISE, "--basis", "cell-f1", "--rotate", "--heights", "h.pfm",
                "--normals", "n.img"], b"", ("h.pfm", "n.img", "n.hdr")),
    ("stream", ["terrain", *NOISE, "--fractal", "erosion", "--heights", "r16:-"], b"", ()),
    ("text", ["sample", "--octaves", "3", "--columns", "x,y", "--gradient", "--hessian", "--keep"],
     POINTS, ()),
    ("npy", ["sample", "--octaves", "3", "--columns", "x,y", "--gradient", "--output", "o.npy"],
     POINTS, ("o.npy",)),
    ("info", ["info", "--help"], b"", ()),
)


def hashes(directory):
    """Lines of golden.txt: case, file or "-" for standard output, SHA-256"""
    for name, arguments, stdin, files in CASES:
        result = common.run(*arguments, cwd=directory, input=stdin)
        assert result.returncode == 0, result
        outputs = [("-", result.stdout)] if result.stdout else []
        outputs += [(file, common.read_bytes(os.path.join(directory, file))) for file in files]
        for file, data in outputs:
            yield "%s %s %s" % (name, file, hashlib.sha256(data).hexdigest())


class Golden(common.Case):
    def test_hashes(self):
        with open(LIST, encoding="ascii") as file:
            self.assertEqual(list(hashes(self.directory)), file.read().splitlines())


if len(sys.argv) > 2 and sys.argv[1] == "print":
    common.PROGRAM.extend(sys.argv[2:])
    with common.tempfile.TemporaryDirectory() as scratch:
        print("\n".join(hashes(scratch)))
    sys.exit(0)
common.main(globals())
