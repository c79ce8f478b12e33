# SPDX-License-Identifier: MIT
"""Arrays on their way into C: coordinates of any shape, dtype and strides; outputs that are
checked; calls in bands, one thread each."""
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from ._library import STRUCTURES, ScarpError
from ._numbers import LIMIT, integer, number, several

FLOAT = np.dtype(np.float32)
DOUBLE = np.dtype(np.float64)
Grid = STRUCTURES["scarp_grid"]
BAND = 16384  # points of a thread, at least: less is not worth one


def real(name, value):
    """An array of real numbers. Raises TypeError for others, and for masked arrays, whose mask C
    would not see."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError("%s is a masked array: fill it first" % name)
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError("%s must be real numbers, not %s" % (name, array.dtype))
    return array


class Points:
    """Coordinates, as arrays of one shape that C can read.

    They are float32 if all of them are float32 or float16 (numbers beside such arrays adapt to
    them), else float64, for which the calls for large worlds serve.
    """
    __slots__ = ("arrays", "shape", "count", "double", "given")

    def __init__(self, coordinates):
        names = "xyz"
        arrays = [real(names[i], c) for i, c in enumerate(coordinates)]
        kinds = [a.dtype for c, a in zip(coordinates, arrays)
                 if not (a.ndim == 0 and isinstance(c, (int, float)))]
        self.double = not kinds or any(k.kind != "f" or k.itemsize > 4 for k in kinds)
        dtype = DOUBLE if self.double else FLOAT
        self.given = arrays
        self.shape = arrays[0].shape
        if any(a.shape != self.shape for a in arrays):
            try:
                arrays = np.broadcast_arrays(*arrays)
            except ValueError:
                raise ScarpError("coordinates do not broadcast: their shapes are " + ", ".join(
                    str(a.shape) for a in arrays)) from None
            self.shape = arrays[0].shape
        self.arrays = [readable(a, dtype) for a in arrays]
        self.count = self.arrays[0].size

    def pointers(self, start=0):
        step = 8 if self.double else 4
        return [a.ctypes.data + start * step for a in self.arrays]


def readable(array, dtype):
    """The array itself if C can read it, else a copy."""
    flags = array.flags
    if array.dtype == dtype and array.dtype.isnative and flags.c_contiguous and flags.aligned:
        return array
    return np.require(array, dtype, ("C", "A"))


def points(x, y, z=None):
    return Points((x, y) if z is None else (x, y, z))


# Outputs

class Outputs:
    """Arrays for the members that a call is asked for: those of the caller, checked, and new ones
    beside them. row and slice_ are strides in elements."""
    __slots__ = ("shape", "arrays", "row", "slice_")

    def __init__(self, shape, members, out=None, of="out", dtypes=None):
        self.shape, self.row, self.slice_ = shape, 0, 0
        given = {} if out is None else as_mapping(out, members, of)
        self.arrays = {}
        for name in members:
            dtype = (dtypes or {}).get(name, FLOAT)
            if name in given:
                check_output("%s[%r]" % (of, name), given[name], shape, dtype)
                self.arrays[name] = given[name]
            else:
                self.arrays[name] = np.empty(shape, dtype)

    def contiguous(self):
        """Raises ScarpError unless all are C-contiguous: calls for points know no strides."""
        for name, array in self.arrays.items():
            if not array.flags.c_contiguous:
                raise ScarpError("must be C-contiguous: only grids write into views of rows",
                                 "out[%r]" % name)
        return self

    def strided(self):
        """Finds the strides that all arrays share: views of rows of a larger map have others."""
        if 0 in self.shape:
            return self
        found = None
        for name, array in self.arrays.items():
            strides = strides_of("out[%r]" % name, array)
            if found is not None and strides != found:
                raise ScarpError("has other strides than the other arrays. With views of rows, "
                                 "give an array for every member", "out[%r]" % name)
            found = strides
        self.row = found[-2]
        self.slice_ = found[0] if len(self.shape) == 3 else 0
        return self

    def fill(self, structure, offset=0):
        """Writes addresses into a structure of C, so many elements behind the first ones."""
        for name, array in self.arrays.items():
            setattr(structure, name, array.ctypes.data + 4 * offset)
        return structure


def as_mapping(out, members, of):
    """The arrays of `out` by member. Raises for members that the call does not compute."""
    if isinstance(out, np.ndarray):
        out = {members[0]: out}
    elif not hasattr(out, "keys") and hasattr(out, "members"):
        out = {name: getattr(out, name) for name in out.members}
    elif not hasattr(out, "keys"):
        raise TypeError("%s must be an array, a mapping of members to arrays, or samples; not %s"
                        % (of, type(out).__name__))
    if not out:
        raise ScarpError("has no array", of)
    for name in out.keys():
        if name not in members:
            raise ScarpError("is not computed by this call; there are " + ", ".join(members),
                             "%s[%r]" % (of, name))
    return {name: out[name] for name in out.keys()}


def check_output(name, array, shape, dtype):
    """Raises unless C may write an array: its type, shape and memory."""
    if not isinstance(array, np.ndarray):
        raise TypeError("%s must be an array of NumPy, not %s" % (name, type(array).__name__))
    if isinstance(array, np.ma.MaskedArray):
        raise TypeError("%s must not be a masked array" % name)
    if array.dtype != dtype or not array.dtype.isnative:
        raise ScarpError("must be %s, not %s" % (dtype, array.dtype), name)
    if array.shape != shape:
        raise ScarpError("must have the shape %s, not %s" % (shape, array.shape), name)
    if not array.flags.writeable:
        raise ScarpError("is read-only", name)
    if not array.flags.aligned:
        raise ScarpError("is not aligned", name)


def strides_of(name, array):
    """Strides in elements of an array of a grid: rows must be contiguous, and must not overlap."""
    shape, steps = array.shape, []
    needed = 1
    for axis in reversed(range(array.ndim)):
        bytes_, size = array.strides[axis], shape[axis]
        stride = needed if size == 1 else bytes_ // 4
        if size > 1 and (bytes_ % 4 or (stride != 1 if axis == array.ndim - 1
                                        else stride < needed)):
            raise ScarpError("must have contiguous rows, one behind the other", name)
        steps.insert(0, stride)
        needed = stride * (size - 1) + needed if axis != array.ndim - 1 else size
    return steps


def check_overlap(outputs, inputs, in_place):
    """Raises where an output shares memory with another one, or with an input. Where calls work in
    place, it may be the very same array as an input."""
    written = list(outputs)
    for i, (name, array) in enumerate(written):
        for other_name, other in written[:i]:
            if shares(array, other):
                raise ScarpError("overlaps with %s" % other_name, name)
        for other in inputs:
            if shares(array, other) and not (in_place and same_place(array, other)):
                raise ScarpError("overlaps with an input", name)


def same_place(a, b):
    return (a.ctypes.data == b.ctypes.data and a.shape == b.shape and a.strides == b.strides
            and a.dtype == b.dtype)


def shares(a, b):
    return np.may_share_memory(a, b) and np.shares_memory(a, b)


# Grids

def shape_of(shape):
    """A shape in NumPy's order, of the plane or of space."""
    if not hasattr(shape, "__len__"):
        raise TypeError("shape must be (rows, columns), or (slices, rows, columns)")
    if len(shape) not in (2, 3):
        raise ScarpError("must be (rows, columns), or (slices, rows, columns)", "shape")
    return tuple(integer("shape[%d]" % i, n, 0, LIMIT) for i, n in enumerate(shape))


class Raster:
    """A uniform grid: its shape, and where it lies. step, origin and first are along x, y, z."""

    def __init__(self, shape, step, origin, first):
        self.shape = shape_of(shape)
        n = self.dimensions = len(self.shape)
        steps = [step] * n if np.ndim(step) == 0 else several("step", step, n)
        self.step = [number("step[%d]" % i, s) for i, s in enumerate(steps)]
        self.origin = [number("origin[%d]" % i, s) for i, s in enumerate(
            [0.0] * n if origin is None else several("origin", origin, n))]
        self.first = [integer("first[%d]" % i, s, -LIMIT, LIMIT) for i, s in enumerate(
            [0] * n if first is None else several("first", first, n))]
        for i in range(n):
            for name, value in (("step", self.step[i]), ("origin", self.origin[i])):
                if not np.isfinite(value):
                    raise ScarpError("must be finite, not %r" % value, "%s[%d]" % (name, i))
            if self.first[i] + self.shape[n - 1 - i] - 1 > LIMIT:
                raise ScarpError("the last index is beyond 2^53", "first[%d]" % i)

    def structure(self, outputs, start=0, stop=None):
        """The grid in C, of the rows (in space: slices) from start to stop."""
        n, grid = self.dimensions, Grid()
        for i in range(n):
            grid.origin[i], grid.step[i] = self.origin[i], self.step[i]
            grid.first[i], grid.count[i] = self.first[i], self.shape[n - 1 - i]
        if stop is not None:
            grid.first[n - 1] += start
            grid.count[n - 1] = stop - start
        grid.row_stride, grid.slice_stride = outputs.row, outputs.slice_
        return grid

    def offset(self, outputs, start):
        """Elements in front of a row, or a slice."""
        columns = self.shape[-1]
        row = outputs.row or columns
        return start * (row if self.dimensions == 2 else outputs.slice_ or row * self.shape[1])

    @property
    def extent(self):
        """The edges of the outermost samples: for imshow(..., origin="lower", extent=...)."""
        edges = []
        for i in range(self.dimensions):
            count = self.shape[self.dimensions - 1 - i]
            edges += [self.origin[i] + (self.first[i] - 0.5) * self.step[i],
                      self.origin[i] + (self.first[i] + count - 0.5) * self.step[i]]
        return tuple(edges)


# Bands

def bands(length, each, threads):
    """Parts of a length, as pairs: as many as there are threads, if each has enough points."""
    threads = integer("threads", threads, 1, 1024)
    if threads == 1 or length == 0:
        return [(0, length)]
    parts = min(threads, length, max(1, length * each // BAND))
    return [(length * i // parts, length * (i + 1) // parts) for i in range(parts)]


def in_bands(call, length, each, threads):
    """Runs call(start, stop) for each band, in threads of its own, and gives the greatest
    status: SCARP_OK, which is 0, only if all have it. C runs without the lock of Python."""
    parts = bands(length, each, threads)
    if len(parts) == 1:
        return call(*parts[0])
    with ThreadPoolExecutor(len(parts)) as pool:
        return max(pool.map(lambda part: call(*part), parts))
