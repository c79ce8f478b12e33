# SPDX-License-Identifier: MIT
"""Noise: what to sample, and the calls that sample it."""
import ctypes
import inspect

import numpy as np

from . import _interface
from ._arrays import Outputs, Raster, check_overlap, in_bands, points
from ._library import BASES, FADES, FRACTALS, STRUCTURES, ScarpError, complain, lib, told
from ._numbers import integer, member, order, seed_of, single
from ._samples import Samples, members_of

_Noise, _Samples = STRUCTURES["scarp_noise"], STRUCTURES["scarp_samples"]
_Cells, _Flow = STRUCTURES["scarp_cells"], STRUCTURES["scarp_flow"]
WORDS = {"basis": BASES, "fade": FADES, "fractal": FRACTALS}
# The members of a noise, with their types, and what C takes where they are 0
MEMBERS = {name: kind if not lengths else kind + "[]"
           for name, kind, lengths in _interface.STRUCTURES["scarp_noise"][1]
           if name != "plan" and not name.startswith("spare")}
ZEROS = _interface.DEFAULTS["scarp_noise"]
CELLS = {2: (("f1", "f2", "id", "x", "y"), ("dx1", "dy1", "dx2", "dy2")),
         3: (("f1", "f2", "id", "x", "y", "z"), ("dx1", "dy1", "dz1", "dx2", "dy2", "dz2"))}
FLOW = {2: (("vx", "vy"), ("vxx", "vxy", "vyx", "vyy")),
        3: (("vx", "vy", "vz"), ("vxx", "vxy", "vxz", "vyx", "vyy", "vyz", "vzx", "vzy", "vzz"))}


def enumerator(name, value):
    """The number of a word, or of a number that there is."""
    words = WORDS[name]
    if isinstance(value, str):
        if value not in words:
            raise ScarpError("there is no %r; there are %s" % (value, ", ".join(words)), name,
                             "SCARP_ERROR_ENUM")
        return words.index(value)
    try:
        return integer(name, value, 0, len(words) - 1)
    except ScarpError as error:
        raise ScarpError(error.text, name, "SCARP_ERROR_ENUM") from None


def default(name):
    """What a member is that is not given: as it reads here."""
    if name in WORDS:
        return WORDS[name][0]
    return ZEROS.get(name, {"u8": 0, "u4": False}.get(MEMBERS[name]))


# How members are written, by their types: each returns what the member reads as, from then on.

def write_word(noise, name, value):
    setattr(noise, name, enumerator(name, value))
    return WORDS[name][getattr(noise, name)]


def write_number(noise, name, value):
    kind = MEMBERS[name]
    if ZEROS.get(name) == 0:
        value = single(name, value)
    else:
        value = member(name, value, kind)
    setattr(noise, name, value)
    return value


def write_switch(noise, name, value):
    setattr(noise, name, int(bool(value)))
    return bool(value)


def write_seed(noise, name, value):
    setattr(noise, name, seed_of(value))
    return getattr(noise, name)


def write_counts(noise, name, values):
    if not hasattr(values, "__len__") or len(values) not in (2, 3):
        raise ScarpError("two or three integers are needed, one for each axis", name)
    counts = tuple(integer("%s[%d]" % (name, i), p, 0, 2 ** 30) for i, p in enumerate(values))
    getattr(noise, name)[:len(counts)] = counts
    return counts


def write_noise(noise, name, value):
    if not isinstance(value, Noise):
        raise TypeError("%s must be a Noise, not %s" % (name, type(value).__name__))
    setattr(noise, name, value._address)
    return value


WRITERS = {"i4": write_word, "f4": write_number, "f8": write_number, "u4": write_switch,
           "u8": write_seed, "u4[]": write_counts, "pointer": write_noise}


class Record:
    """Arrays of one shape by name, as attributes: what cells() and curl() give."""
    __slots__ = ("_arrays", "shape")

    def __init__(self, arrays, shape):
        self._arrays, self.shape = arrays, shape

    def __getattr__(self, name):
        if not name.startswith("_") and name in self._arrays:
            return self._arrays[name]
        raise AttributeError("%s was not computed, or does not exist; there are %s" % (
            name, ", ".join(self._arrays) if not name.startswith("_") else ""))

    def __getstate__(self):
        return self._arrays, self.shape

    def __setstate__(self, state):
        self._arrays, self.shape = state

    @property
    def members(self):
        return tuple(self._arrays)

    def __repr__(self):
        return "<scarp.%s %s: %s>" % (type(self).__name__, self.shape, ", ".join(self._arrays))


class Cells(Record):
    """What is near each point: float32 arrays, but id.

    f1, f2              the distances to the nearest feature and to the second, in units of input
    id                  uint32: a number drawn for the cell of the nearest feature
    x, y, z             where the nearest feature is
    dx1, dy1, dz1       the gradient of f1, with derivatives=1; dx2, dy2, dz2 that of f2
    """
    __slots__ = ()


class Flow(Record):
    """A velocity without divergence: vx, vy, vz; with derivatives=1 its Jacobian, of which vxy is
    the derivative of vx with respect to y. float32 arrays, per unit of input."""
    __slots__ = ()


class Noise:
    """Noise with exact derivatives. It does not change; replace() makes another one.

    basis        "gradient", "value", "simplex", "cell-f1", "cell-f2", "cell-edge", "cell-soft",
                 "cell-value"
    fractal      how octaves are summed: "fbm", "turbulence", "ridged" and others, which are in
                 scarp.FRACTALS. Some have no Hessian: see include/scarp.h.
    fade         "quintic" or "cubic"
    seed         an integer in [-2^63, 2^64); a negative one is 2^64 more
    frequency    lattice cells per unit of input. Default 1
    octaves      in (0, 32]. Default 1; a fraction fades the last one in
    lacunarity   frequency ratio between octaves, in [1/16, 16]. Default 2
    gain         amplitude ratio between octaves, in [1/16, 16]. Default 0.5
    amplitude    scales every output. Default 1
    rotate       turn the axes between octaves, which hides the lattice's directions
    offset_first whether the seed moves octave 0, too; else every seed has a lattice point at (0, 0)
    erosion, sharpness, jitter
                 of some fractals and of cellular noise: see include/scarp.h
    phase        turns of the gradients, so noise flows; 1 is a loop. Gradient noise alone
    period       cells of octave 0 after which the noise repeats along x, y (and z); 0: never
    of_octaves   amplitudes are those of a sum of so many octaves: levels of detail
    warp         a Noise that displaces positions, in units of input

    None stands for the default. Raises ScarpError, a ValueError, that names the member at fault.
    A number that C would take for the default, 0, is an error.
    """
    __slots__ = ("_given", "_noise", "_address")

    def __init__(self, basis=None, fractal=None, **given):
        given.update(basis=basis, fractal=fractal)
        noise, kept = _Noise(), {}
        for name in given:
            if name not in MEMBERS:
                raise TypeError("a noise has no member %r; there are %s" % (
                    name, ", ".join(MEMBERS)))
        for name, kind in MEMBERS.items():
            value, write = given.get(name), WRITERS[kind]
            kept[name] = default(name) if value is None else write(noise, name, value)
        self._keep(kept, noise)
        if self._status(2) and self._status(3):  # some noises are of space alone
            raise complain(self._status(2), *self._fault(2))

    def _keep(self, given, noise):
        # C reads the warp by its address: _given holds it as long as this noise is there.
        object.__setattr__(self, "_given", given)
        object.__setattr__(self, "_noise", noise)
        object.__setattr__(self, "_address", ctypes.addressof(noise))

    def __getattr__(self, name):
        if not name.startswith("_") and name in self._given:
            return self._given[name]
        raise AttributeError("a noise has no member %r" % name)

    def __setattr__(self, name, value):
        raise AttributeError("a noise does not change: use replace(%s=...)" % name)

    def __dir__(self):
        return sorted(set(object.__dir__(self)) | set(self._given))

    def __reduce__(self):
        return _noise_of, (self._given,)

    def __eq__(self, other):
        return self._given == other._given if isinstance(other, Noise) else NotImplemented

    def __hash__(self):
        return hash(tuple(sorted((k, v) for k, v in self._given.items() if k != "warp"
                                 and v is not None)) + (hash(self._given["warp"]),))

    def __repr__(self):
        shown = ["%s=%r" % (k, v) for k, v in self._given.items()
                 if v != default(k)]
        return "Noise(%s)" % ", ".join(shown)

    def replace(self, **changes):
        """A noise that differs in these members."""
        return Noise(**{**self._given, **changes})

    def _status(self, dimensions):
        return lib.scarp_noise_check(self._address, dimensions, None)

    def _fault(self, dimensions, orders=0, dphase=False):
        """(member, text) of what makes calls refuse this noise, or has not what they ask for."""
        return told(lib.scarp_noise_fault, self._address, dimensions, orders, int(dphase))

    def _refuse(self, status, dimensions, orders, dphase):
        """Raises for a call that failed, which asked for such derivatives of the noise."""
        raise complain(self._status(dimensions) or status,
                       *self._fault(dimensions, orders, dphase))

    def range(self, dimensions=2):
        """(lowest, highest): the interval that values never leave, rounding included."""
        dimensions = integer("dimensions", dimensions, 2, 3)
        lowest, highest = ctypes.c_float(), ctypes.c_float()
        status = lib.scarp_range(self._address, dimensions, ctypes.byref(lowest),
                                 ctypes.byref(highest))
        if status:
            raise complain(status, *self._fault(dimensions))
        return lowest.value, highest.value

    def grid(self, shape, step=1.0, origin=None, first=None, *, derivatives=0, dphase=False,
             out=None, threads=1):
        """Samples on a uniform grid.

        shape        NumPy's order: (rows, columns) = (along y, along x), or (slices, rows,
                     columns) for x, y and z. Element [j, i] lies at
                     x = origin[0] + (first[0] + i) * step[0], y = origin[1] + (first[1] + j) *
                     step[1]. Row 0 is at the bottom of a map: imshow(..., origin="lower").
        step, origin, first
                     in the order x, y, z. step: a number, or one for each axis; origin: default
                     0; first: integers, the index of the first sample. Tiles of one world have
                     the same origin and step, and a `first` of their own: they fit to the bit.
        derivatives  0, 1 or 2: value; with the gradient; with the Hessian
        dphase       with the derivative with respect to the phase
        out          where results go: an array for the value, or a mapping of members to arrays
                     (float32, this shape). Views of rows of a larger map will do.
        threads      how many; each takes a band of rows, or of slices

        Returns Samples, float32 arrays of this shape. Raises ScarpError, a ValueError, and
        MemoryError for arrays that do not fit.
        """
        raster, orders = Raster(shape, step, origin, first), order(derivatives)
        n = raster.dimensions
        members = members_of(n, orders, dphase)
        outputs = Outputs(raster.shape, members, out)
        if out is not None:
            outputs.strided()
            check_overlap(outputs.arrays.items(), (), False)
        function = lib.scarp_grid2 if n == 2 else lib.scarp_grid3

        def band(start, stop):
            grid = raster.structure(outputs, start, stop)
            samples = outputs.fill(_Samples(), raster.offset(outputs, start))
            return function(self._address, ctypes.addressof(grid), ctypes.addressof(samples))

        length = raster.shape[0]
        each = int(np.prod(raster.shape[1:], dtype=float))
        status = in_bands(band, length, each, threads)
        if status:
            self._refuse(status, n, orders, dphase)
        return Samples._of(outputs.arrays, raster.shape, raster.extent)

    def at(self, x, y, z=None, *, derivatives=0, dphase=False, out=None, threads=1):
        """Samples at points.

        x, y, z      arrays or numbers, of any shape, strides and real dtype, which broadcast.
                     float32 and float16 are computed in float32; anything wider, integers and
                     numbers alone, in float64, for large worlds.
        out          as in grid(), but arrays must be contiguous. With float32 coordinates an
                     output may be the very same array as a coordinate.
        The rest is as in grid(). A coordinate that is not finite gives NaN.
        """
        given, orders = points(x, y, z), order(derivatives)
        n = len(given.arrays)
        outputs = self._outputs(given, members_of(n, orders, dphase), out)
        function = POINTS[n, given.double]

        def band(start, stop):
            part = outputs.fill(_Samples(), start)
            return function(self._address, stop - start, *given.pointers(start),
                            ctypes.addressof(part))

        status = in_bands(band, given.count, 1, threads)
        if status:
            self._refuse(status, n, orders, dphase)
        return Samples._of(outputs.arrays, given.shape)

    @staticmethod
    def _outputs(given, members, out, dtypes=None):
        outputs = Outputs(given.shape, members, out, dtypes=dtypes)
        if out is not None:
            outputs.contiguous()
            check_overlap(outputs.arrays.items(), given.arrays, not given.double)
        return outputs

    def vector(self, x, y, z=None, *, derivatives=0, threads=1):
        """Vector noise at points: a tuple of Samples, one for each axis, as warps displace points
        by them. Arguments are as in at()."""
        given, orders = points(x, y, z), order(derivatives)
        n = len(given.arrays)
        outputs = [Outputs(given.shape, members_of(n, orders)) for _ in range(n)]
        function = getattr(lib, "scarp_vector%d%s" % (n, "_f64" if given.double else ""))

        def band(start, stop):
            parts = (_Samples * n)()
            for part, of in zip(parts, outputs):
                of.fill(part, start)
            return function(self._address, stop - start, *given.pointers(start),
                            ctypes.addressof(parts))

        status = in_bands(band, given.count, 1, threads)
        if status:
            self._refuse(status, n, orders, False)
        return tuple(Samples._of(of.arrays, given.shape) for of in outputs)

    def cells(self, x, y, z=None, *, derivatives=0, out=None, threads=1):
        """The Cells around points, of frequency, seed, jitter and period; the basis changes
        nothing. derivatives: 0 or 1. Other arguments are as in at(); id is uint32."""
        return self._record("scarp_cells", _Cells, CELLS, Cells, (x, y, z),
                            order(derivatives, 1), out, threads)

    def curl(self, x, y, z=None, *, derivatives=0, out=None, threads=1):
        """The Flow, a velocity without divergence, of which this noise is the potential.
        derivatives: 0, or 1 for the Jacobian. Other arguments are as in at()."""
        return self._record("scarp_curl", _Flow, FLOW, Flow, (x, y, z), order(derivatives, 1),
                            out, threads)

    def _record(self, name, structure, names, kind, coordinates, orders, out, threads):
        given = points(*coordinates)
        n = len(given.arrays)
        members = list(names[n][0] + (names[n][1] if orders else ()))
        outputs = self._outputs(given, members, out, {"id": np.dtype(np.uint32)})
        function = getattr(lib, "%s%d%s" % (name, n, "_f64" if given.double else ""))

        def band(start, stop):
            part = outputs.fill(structure(), start)
            return function(self._address, stop - start, *given.pointers(start),
                            ctypes.addressof(part))

        status = in_bands(band, given.count, 1, threads)
        if status:
            self._refuse(status, n, 2 * orders if kind is Flow else 0, False)
        return kind(outputs.arrays, given.shape)


def _signature():
    """What Noise() takes, for help(): its arguments are the members of C."""
    kinds = inspect.Parameter
    names = ["basis", "fractal"] + [m for m in MEMBERS if m not in ("basis", "fractal")]
    return inspect.Signature([kinds("self", kinds.POSITIONAL_OR_KEYWORD)] + [
        kinds(name, kinds.POSITIONAL_OR_KEYWORD if i < 2 else kinds.KEYWORD_ONLY,
              default=default(name)) for i, name in enumerate(names)])


Noise.__init__.__signature__ = _signature()
POINTS = {(2, False): lib.scarp_sample2, (3, False): lib.scarp_sample3,
          (2, True): lib.scarp_sample2_f64, (3, True): lib.scarp_sample3_f64}


def _noise_of(given):
    return Noise(**given)
