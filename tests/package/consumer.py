# SPDX-License-Identifier: MIT
"""What a user of the shared library writes in Python, with only ctypes.

Usage: consumer.py LIBRARY VERSION
"""
import ctypes
import sys

COUNT = 37
OK, ERROR_NULL, ERROR_ENUM, ERROR_PARAMETER, ERROR_SIZE, ERROR_UNSUPPORTED = range(6)
POINTER_SIZE = ctypes.sizeof(ctypes.c_void_p)
SIZE_SIZE = ctypes.sizeof(ctypes.c_size_t)


class Noise(ctypes.Structure):
    _fields_ = [
        ("basis", ctypes.c_int), ("fade", ctypes.c_int), ("fractal", ctypes.c_int),
        ("rotate", ctypes.c_uint32), ("seed", ctypes.c_uint64), ("frequency", ctypes.c_double),
        ("octaves", ctypes.c_float), ("lacunarity", ctypes.c_float), ("gain", ctypes.c_float),
        ("amplitude", ctypes.c_float), ("erosion", ctypes.c_float), ("phase", ctypes.c_float),
        ("jitter", ctypes.c_float), ("sharpness", ctypes.c_float),
        ("period", ctypes.c_uint32 * 3), ("of_octaves", ctypes.c_float), ("warp", ctypes.c_void_p),
        ("plan", ctypes.c_void_p), ("offset_first", ctypes.c_uint32),
        ("spare", ctypes.c_uint32 * ((192 - 84 - 2 * POINTER_SIZE) // 4))]


FloatPointer = ctypes.POINTER(ctypes.c_float)


class Samples(ctypes.Structure):
    _fields_ = [(name, FloatPointer)
                for name in "value dx dy dz dxx dxy dxz dyy dyz dzz dphase".split()] + [
                    ("spare", FloatPointer * 5)]


class Grid(ctypes.Structure):
    _fields_ = [
        ("origin", ctypes.c_double * 3), ("step", ctypes.c_double * 3),
        ("first", ctypes.c_int64 * 3), ("count", ctypes.c_size_t * 3),
        ("row_stride", ctypes.c_size_t), ("slice_stride", ctypes.c_size_t),
        ("spare", ctypes.c_uint32 * ((192 - 72 - 5 * SIZE_SIZE) // 4))]


def names(call):
    """All that a function gives for 0, 1, ... until it gives NULL."""
    call.restype = ctypes.c_char_p
    found = []
    while call(len(found)) is not None:
        found.append(call(len(found)).decode())
    return found


def check_layout():
    assert ctypes.sizeof(Noise) == ctypes.sizeof(Grid) == 192
    assert (Noise.erosion.offset, Noise.period.offset, Noise.warp.offset) == (48, 64, 80)
    assert ctypes.sizeof(Samples) == 16 * POINTER_SIZE


def check_names(library):
    for call, first, count in ((library.scarp_basis_name, "gradient", 8),
                               (library.scarp_fade_name, "quintic", 2),
                               (library.scarp_fractal_name, "fbm", 8)):
        assert names(call)[0] == first and len(set(names(call))) >= count
    assert names(library.scarp_isa_name)[:2] == ["none", "scalar"]
    assert library.scarp_isa_supported(1)


def check_faults(library):
    noise, member = Noise(), ctypes.c_char_p()

    def check():
        return library.scarp_noise_check(ctypes.byref(noise), 2, ctypes.byref(member))

    assert (check(), member.value) == (OK, None)
    noise.period[1] = 5
    assert (check(), member.value) == (OK, None)
    noise.phase = 0.5
    assert (check(), member.value) == (OK, None)
    noise.basis = 1
    assert (check(), member.value) == (ERROR_UNSUPPORTED, b"phase")
    noise.basis, noise.phase = 2, 0
    assert (check(), member.value) == (ERROR_UNSUPPORTED, b"period[1]")
    noise.basis = 7
    assert (check(), member.value) == (OK, None)
    noise.jitter = 1.5
    assert (check(), member.value) == (ERROR_PARAMETER, b"jitter")
    noise.jitter, noise.basis = 0.5, 0
    noise.of_octaves = 0.5
    assert (check(), member.value) == (ERROR_PARAMETER, b"of_octaves")
    noise.of_octaves = 1
    assert (check(), member.value) == (OK, None)
    noise.gain = 17
    assert (check(), member.value) == (ERROR_PARAMETER, b"gain")


def check_grid(library, noise, before):
    """A grid of the same samples as the points of main(), which are exact in floats."""
    value = (ctypes.c_float * COUNT)()
    out = Samples(value=value)
    grid = Grid(origin=(0.28125, 0.4375, 0), step=(0.125, 0, 0), count=(COUNT, 1, 1))

    def sample():
        return library.scarp_grid2(ctypes.byref(noise), ctypes.byref(grid), ctypes.byref(out))

    assert sample() == OK
    assert list(value) == before
    grid.spare[len(grid.spare) - 1] = 1
    assert sample() == ERROR_UNSUPPORTED


def main(path, version):
    library = ctypes.CDLL(path)
    library.scarp_version.restype = ctypes.c_char_p
    library.scarp_status_text.restype = ctypes.c_char_p
    assert library.scarp_version().decode() == version, library.scarp_version()
    assert library.scarp_status_text(ERROR_NULL) != library.scarp_status_text(OK)
    check_layout()
    check_names(library)
    check_faults(library)

    floats = ctypes.c_float * COUNT
    x = floats(*(0.28125 + 0.125 * i for i in range(COUNT)))
    y = floats(*(0.4375 for i in range(COUNT)))
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
    check_grid(library, noise, before)
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
