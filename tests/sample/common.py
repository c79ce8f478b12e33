# SPDX-License-Identifier: MIT
"""What the tests of `scarp sample` share: running it, files of points, the library itself.

    test_NAME.py CLASS LIBRARY PROGRAM...   one class of test_NAME.py

LIBRARY is the shared library, or "-" where Python cannot load it: its results are then left out of
the comparisons. PROGRAM may begin with an emulator.
"""
import ctypes
import os
import random
import re
import struct
import subprocess
import sys
import tempfile
import unittest

try:
    import resource
    import signal
except ImportError:  # not a POSIX system
    resource = signal = None

PROGRAM = []
LIBRARY = None
BLOCK = 4096
KINDS = ("csv", "text", "npy")
ENDS = {"csv": ".csv", "text": ".txt", "npy": ".npy"}
RESULTS = {2: "value dx dy dxx dxy dyy".split(),
           3: "value dx dy dz dxx dxy dxz dyy dyz dzz".split()}
BY_PHASE = "dphase"  # the last result
# Every option of the noise, as it is typed and as the library takes it
TYPED = ("--seed 0x123456789abcdef0 --basis value --fade cubic --fractal ridged --frequency 0.37 "
         "--octaves 3.5 --lacunarity 2.5 --gain 0.625 --amplitude -3 --erosion 2 --rotate").split()
MEANT = {"seed": 0x123456789abcdef0, "basis": 1, "fade": 1, "fractal": 2, "frequency": 0.37,
         "octaves": 3.5, "lacunarity": 2.5, "gain": 0.625, "amplitude": -3, "erosion": 2,
         "rotate": 1}
# And what is for gradient noise only
FLOWING = "--seed 77 --fade cubic --frequency 0.21 --octaves 3 --phase -0.15625 --dphase".split()
FLOWING_MEANT = {"seed": 77, "fade": 1, "frequency": 0.21, "octaves": 3, "phase": -0.15625}


def run(*arguments, data=b"", **more):
    """Runs `scarp sample` with the bytes (or the text) on standard input."""
    if isinstance(data, str):
        data = data.encode()
    if "stdin" not in more:
        more["input"] = data
    more.setdefault("stdout", subprocess.PIPE)
    return subprocess.run(PROGRAM + ["sample", *arguments], stderr=subprocess.PIPE, timeout=300,
                          **more)


def float32(number):
    return struct.unpack("<f", struct.pack("<f", number))[0]


class Noise(ctypes.Structure):
    _fields_ = [("basis", ctypes.c_int), ("fade", ctypes.c_int), ("fractal", ctypes.c_int),
                ("rotate", ctypes.c_uint32), ("seed", ctypes.c_uint64),
                ("frequency", ctypes.c_double), ("octaves", ctypes.c_float),
                ("lacunarity", ctypes.c_float), ("gain", ctypes.c_float),
                ("amplitude", ctypes.c_float), ("erosion", ctypes.c_float),
                ("phase", ctypes.c_float), ("jitter", ctypes.c_float),
                ("sharpness", ctypes.c_float), ("period", ctypes.c_uint32 * 3),
                ("of_octaves", ctypes.c_float), ("warp", ctypes.c_void_p),
                ("plan", ctypes.c_void_p), ("offset_first", ctypes.c_uint32),
                ("reserved", ctypes.c_uint32 * (27 - ctypes.sizeof(ctypes.c_void_p) // 2))]


class Samples(ctypes.Structure):
    _fields_ = [(name, ctypes.POINTER(ctypes.c_float)) for name in (*RESULTS[3], BY_PHASE)] + [
        ("reserved", ctypes.c_void_p * 5)]


def reference(points, names, **noise):
    """What the library itself gives at the points: a list of rows. The program's noise has
    offset_first."""
    dims, count = len(points[0]), len(points)
    arrays = {name: (ctypes.c_float * count)() for name in names}
    axes = [(ctypes.c_double * count)(*axis) for axis in zip(*points)]
    call = getattr(ctypes.CDLL(LIBRARY), "scarp_sample%d_f64" % dims)
    status = call(ctypes.byref(Noise(offset_first=1, **noise)), ctypes.c_size_t(count), *axes,
                  ctypes.byref(Samples(**arrays)))
    assert status == 0, status
    return [list(row) for row in zip(*(arrays[name] for name in names))]


# NumPy's types and those of struct
TYPES = {"f2": "e", "f4": "f", "f8": "d", "i1": "b", "i2": "h", "i4": "i", "i8": "q", "u1": "B",
         "u2": "H", "u4": "I", "u8": "Q"}


def npy(rows, descr="<f8", version=(1, 0), columns=None, **header):
    """The bytes of a .npy file."""
    columns = columns if columns is not None else len(rows[0])
    fields = {"descr": descr, "fortran_order": False, "shape": (len(rows), columns)}
    fields.update(header)
    text = repr(fields).encode()
    size = 2 if version[0] == 1 else 4
    text += b" " * (-(len(text) + 9 + size) % 64) + b"\n"
    order, kind = descr[0].replace("|", "<"), TYPES.get(descr[1:], "d")
    if fields["fortran_order"]:
        rows = zip(*rows)
    flat = [number for row in rows for number in row]
    return (b"\x93NUMPY" + bytes(version) + struct.pack("<H" if size == 2 else "<I", len(text)) +
            text + struct.pack("%s%d%s" % (order, len(flat), kind), *flat))


def read_npy(data):
    """The type and the rows of a .npy file, which must be as NumPy writes it."""
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:8]
    length, = struct.unpack("<H", data[8:10])
    assert (length + 10) % 64 == 0 and data[9 + length:10 + length] == b"\n", length
    header = re.fullmatch(r"\{'descr': '(<f[48])', 'fortran_order': False, "
                          r"'shape': \((\d+), (\d+)\), \} *\n", data[10:10 + length].decode())
    descr, rows, columns = header.group(1), int(header.group(2)), int(header.group(3))
    flat = struct.unpack("<%d%s" % (rows * columns, "f" if descr == "<f4" else "d"),
                         data[10 + length:])
    return descr, columns, [list(flat[i * columns:(i + 1) * columns]) for i in range(rows)]


def make_input(kind, points, header=False):
    if kind == "npy":
        return npy(points)
    separator = "," if kind == "csv" else " "
    lines = [separator.join(repr(number) for number in point) for point in points]
    if header and kind == "csv":
        lines.insert(0, "x,y,z"[:2 * len(points[0]) - 1])
    return "\n".join(lines + [""]).encode()


def read_output(kind, data):
    """The header row (None without one) and the rows of numbers."""
    if kind == "npy":
        return None, read_npy(data)[2]
    lines = data.decode().split("\n")
    assert lines.pop() == "", "the last line has no end"
    rows = [line.split("," if kind == "csv" else " ") for line in lines]
    header = rows.pop(0) if rows and re.match("[a-mo-z]", rows[0][0]) else None
    return header, [[float(field) for field in row] for row in rows]


def some_points(dims, count, seed=1):
    numbers = random.Random(seed)
    return [tuple(numbers.uniform(-50, 50) for _ in range(dims)) for _ in range(count)]


class Case(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="scarp-sample-")
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def path(self, name):
        return os.path.join(self.directory, name)

    def write(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def files(self):
        return sorted(os.listdir(self.directory))

    def sample(self, data, *arguments, error=b""):
        """Standard output of a run that must succeed."""
        result = run(*arguments, data=data)
        self.assertEqual((result.returncode, result.stderr), (0, error), arguments)
        return result.stdout

    def text(self, data, *arguments):
        return self.sample(data, *arguments).decode()

    def check_refused(self, data, *words, arguments=(), status=2, output=b""):
        """One line on stderr with all the words, and only this on standard output."""
        result = run(*arguments, data=data)
        error = result.stderr.decode(errors="replace")
        self.assertEqual((result.returncode, result.stdout), (status, output), error)
        self.assertRegex(error, r"\Ascarp: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, error)


def main(tests_of_file):
    """Runs the class that the command line names, out of a file's globals()."""
    global LIBRARY
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    LIBRARY = sys.argv[2]
    PROGRAM.extend(sys.argv[3:])
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(tests_of_file[sys.argv[1]])
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(tests)
    sys.exit(0 if result.wasSuccessful() and result.testsRun > len(result.skipped) else 1)
