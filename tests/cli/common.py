# SPDX-License-Identifier: MIT
"""What the tests of the program share: running it, and where its files go.

    test_NAME.py CLASS PROGRAM...     one class of test_NAME.py
    test_same.py isa=NAME PROGRAM...  the class Isa, for one instruction set

PROGRAM may begin with an emulator. Tests see the program from outside: what it prints, writes,
accepts and refuses. SCARP_SPEED in the environment is "full", or tells why the program is slow
and its memory no measure: "slow" with sanitizers or for debugging, "emulated".
"""
import glob
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import time
import unittest

from rasters import read_bytes, read_picture

try:
    import pty
    import resource
    import signal
except ImportError:  # not a POSIX system
    pty = resource = signal = None

PROGRAM = []
SKIPPED = 77
PATIENCE = 60  # seconds
SPEED = os.environ.get("SCARP_SPEED", "full")
NAMES = ("height", "normal", "hillshade", "relief")
OPTIONS = ("size", "origin", "step", "tileable", "levels", "band-limit", "crs",
           "heights", "normals", "hillshade", "relief", "gradient", "slope", "curvature", "out",
           "masks", "output", "compare",
           "normal-y", "palette", "azimuth", "altitude", "z-factor",
           "tile", "tiles", "share", "overlap", "resume", "verify",
           "preset", "recipe", "set", "scale", "print-recipe", "period",
           "seed", "basis", "jitter", "fade", "fractal", "erosion", "sharpness",
           "frequency", "octaves", "of-octaves", "lacunarity", "gain", "phase", "rotate", "amplitude",
           "height", "sea-level", "plateau", "threads", "isa", "quiet", "help")
FLAGS = ("tileable", "band-limit", "resume", "verify", "rotate", "print-recipe", "quiet", "help")
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, os.pardir)
with open(os.path.join(ROOT, "src", "bindings", "interface.json"), encoding="utf-8") as file:
    FRACTALS = tuple(name[6:].lower() for name in json.load(file)["enums"]["scarp_fractal"])
# Cheap to compute, and every option of the noise matters in it
SMALL = ["--size", "40x30", "--frequency", "0.03"]


def run(*arguments, cwd=None, **more):
    more.setdefault("stdout", subprocess.PIPE)
    more.setdefault("stderr", subprocess.PIPE)
    more.setdefault("timeout", 300)
    return subprocess.run(PROGRAM + list(arguments), cwd=cwd, **more)


def start(*arguments, **more):
    """A run that goes on while the test does something to it."""
    more.setdefault("stdout", subprocess.PIPE)
    more.setdefault("stderr", subprocess.PIPE)
    return subprocess.Popen(PROGRAM + list(arguments), **more)


def text_of(*arguments):
    """Standard output of a run that must succeed in silence on stderr."""
    result = run(*arguments)
    assert result.returncode == 0 and result.stderr == b"", (arguments, result)
    return result.stdout.decode()


def supported_isas():
    return re.findall(r"^(\S+) +yes ", text_of("info"), re.MULTILINE)


def has_png():
    return re.search(r"(?m)^formats .*\bpng\b", text_of("info")) is not None


def has_threads():
    return re.search(r"(?m)^threads +POSIX: \d", text_of("info")) is not None


def extensions():
    return [".png"] * 4 if has_png() else [".pgm", ".ppm", ".pgm", ".ppm"]


def limits(**values):
    """For preexec_fn: sets limits of the system, as FSIZE=100: files of at most 100 bytes. Of two
    values, the second is the hard limit."""
    def apply():
        for name, value in values.items():
            both = value if isinstance(value, tuple) else (value, value)
            resource.setrlimit(getattr(resource, "RLIMIT_" + name), both)
    return apply


def file_limit(limit):
    """For preexec_fn: files cannot grow beyond `limit` bytes, as if the disk were full."""
    return limits(FSIZE=limit)


def rounded(value):
    """To a 32-bit float"""
    return struct.unpack("<f", struct.pack("<f", value))[0]


class Case(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.extensions = extensions()

    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="scarp-cli-")
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def path(self, name):
        return os.path.join(self.directory, name)

    def files(self):
        """All of them but checksums, which test_verify.py looks at"""
        return sorted(name for name in os.listdir(self.directory) if not name.endswith(".sums"))

    def clear(self):
        for name in os.listdir(self.directory):
            os.remove(self.path(name))

    def unfinished(self, name=""):
        """Files that have not taken their name yet: of one name, or all"""
        return sorted(os.path.basename(path) for path in
                      glob.glob(self.path(glob.escape(name) + "*.part")))

    def wait_for(self, condition, what=""):
        end = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), end, what)
            time.sleep(0.001)

    def wait_for_unfinished(self, name):
        self.wait_for(lambda: self.unfinished(name), name)

    def names(self, stem):
        return [stem + "-" + name + end for name, end in zip(NAMES, self.extensions)]

    def quietly(self, *arguments, **more):
        """Runs `scarp terrain` in the test's directory, where it must succeed in silence."""
        result = run("terrain", *arguments, "--quiet", cwd=self.directory, **more)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""),
                         arguments)

    def terrain(self, *arguments, stem="t"):
        """Runs `scarp terrain`; returns the bytes of the four files."""
        self.quietly(*arguments, "--output", stem)
        return [self.bytes(name) for name in self.names(stem)]

    def pictures(self, *arguments):
        """Like terrain, but as pictures; netpbm's, which are faster to read than PNG."""
        names = ("t-height.pgm", "t-normal.ppm", "t-hillshade.pgm")
        self.quietly(*arguments, "--heights", names[0], "--normals", names[1], "--hillshade",
                     names[2])
        return [read_picture(self.path(name)) for name in names]

    def layer(self, option, name, *arguments):
        """Runs `scarp terrain` for one file; returns its bytes."""
        self.quietly(*arguments, option, name)
        return self.bytes(name.split(":")[-1])

    def bytes(self, name):
        return read_bytes(self.path(name))

    def all_bytes(self):
        return {name: self.bytes(name) for name in self.files()}

    def check_same_files(self, files, expected):
        """Like assertEqual of dictionaries, but that shows the differences of large files."""
        self.assertEqual(sorted(files), sorted(expected))
        self.assertEqual([name for name in sorted(files) if files[name] != expected[name]], [],
                         "files that differ")

    def check_rows(self, rows, expected):
        """Like assertEqual, but that shows the difference, which takes minutes for pictures."""
        self.assertEqual(len(rows), len(expected))
        self.assertEqual([r for r in range(len(rows)) if rows[r] != expected[r]], [],
                         "rows that differ")

    def check_one_line(self, result, status, *words, stdout=b""):
        """One line on stderr with all the words, nothing on stdout."""
        error = result.stderr.decode()
        self.assertEqual(result.returncode, status, error)
        self.assertEqual(result.stdout, stdout)
        self.assertRegex(error, r"\Ascarp(-bench)?: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, error)
        return error

    def on_terminal(self, *arguments, **more):
        """Runs with stderr on a terminal; returns the status and what the terminal got."""
        ours, theirs = pty.openpty()
        process = start(*arguments, stdout=subprocess.DEVNULL, stderr=theirs, **more)
        os.close(theirs)
        shown = b""
        while True:
            try:
                data = os.read(ours, 4096)
            except OSError:  # Linux: the other end is closed
                data = b""
            if not data:
                break
            shown += data
        os.close(ours)
        return process.wait(), shown.decode()


def skip_all(reason, required=False):
    """Ends the program: as skipped, or failed if what is missing was required."""
    print("%s: %s" % (reason, "FAILED (required)" if required else "skipped"))
    sys.exit(1 if required else SKIPPED)


def main(module):
    """Runs the class of the module that the command line names."""
    if module["__name__"] != "__main__":
        return
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    PROGRAM.extend(sys.argv[2:])
    group = sys.argv[1]
    if group.startswith("isa="):
        group = "Isa"
        name = sys.argv[1][len("isa="):]
        if name not in supported_isas():
            skip_all("%s cannot run here" % name,
                     name in os.environ.get("SCARP_REQUIRE_ISAS", "").split(","))
        module[group].name = name
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(module[group])
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(tests)
    if result.wasSuccessful() and result.testsRun == len(result.skipped):
        skip_all(group)
    sys.exit(0 if result.wasSuccessful() else 1)
