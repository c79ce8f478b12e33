# SPDX-License-Identifier: MIT
"""What a user of the shared library writes in Python, with ctypes alone.

Usage: consumer.py LIBRARY VERSION
"""
import ctypes
import sys

COUNT = 37
OK, ERROR_NULL, ERROR_ENUM, ERROR_PARAMETER = range(4)


class Noise(ctypes.Structure):
    _fields_ = [
        ("basis", ctypes.c_int), ("fade", ctypes.c_int), ("fractal", ctypes.c_int),
        ("rotate", ctypes.c_uint32), ("seed", ctypes.c_uint64), ("frequency", ctypes.c_double),
        ("octaves", ctypes.c_float), ("lacunarity", ctypes.c_float), ("gain", ctypes.c_float),
        ("amplitude", ctypes.c_float), ("erosion", ctypes.c_float),
        ("later", ctypes.c_byte * 64)]  # fields that may be added


FloatPointer = ctypes.POINTER(ctypes.c_float)


class Samples(ctypes.Structure):
    _fields_ = [(name, FloatPointer)
                for name in "value dx dy dz dxx dxy dxz dyy dyz dzz".split()]


def main(path, version):
    library = ctypes.CDLL(path)
    library.scarp_version.restype = ctypes.c_char_p
    library.scarp_status_text.restype = ctypes.c_char_p
    assert library.scarp_version().decode() == version, library.scarp_version()
    assert library.scarp_status_text(ERROR_NULL) != library.scarp_status_text(OK)

    floats = ctypes.c_float * COUNT
    x = floats(*(0.3 + 0.17 * i for i in range(COUNT)))
    y = floats(*(0.4 for i in range(COUNT)))
    value, dx, dy = floats(), floats(), floats()
    out = Samples(value=value, dx=dx, dy=dy)
    noise = Noise(seed=42)

    def sample():
        return library.scarp_sample2(ctypes.byref(noise), ctypes.c_size_t(COUNT), x, y,
                                     ctypes.byref(out))

    assert sample() == OK
    assert all(all(array) for array in (value, dx, dy)), "a value or gradient is zero"
    assert all(abs(v) <= 1 for v in value)
    before = list(value)
    noise.basis = 99
    assert sample() == ERROR_ENUM
    noise.basis = 0
    noise.amplitude = float("inf")
    assert sample() == ERROR_PARAMETER
    assert list(value) == before, "an error wrote to the outputs"
    assert library.scarp_sample2(None, ctypes.c_size_t(COUNT), x, y, None) == ERROR_NULL
    noise.amplitude = 8
    assert sample() == OK
    # Same operations but for a factor that is a power of two.
    assert list(value) == [8 * v for v in before]
    print(f"scarp {version} through ctypes: ok")


main(*sys.argv[1:])
