# SPDX-License-Identifier: MIT
"""Gullies and spurs that run down the slopes of a base."""
import ctypes

from . import _interface
from ._arrays import Outputs, Raster, in_bands, points
from ._library import STRUCTURES, ScarpError, complain, lib, told
from ._numbers import integer, member, order, seed_of, several, single
from ._samples import Samples

_Gullies, _Samples, _Eroded = (STRUCTURES["scarp_" + name] for name in (
    "gullies", "samples", "eroded"))
NUMBERS = tuple(name for name, kind, _ in _interface.STRUCTURES["scarp_gullies"][1]
                if kind in ("f4", "f8"))
NEEDED = (("value", "dx", "dy"), ("value", "dx", "dy", "dxx", "dxy", "dyy"))


class Gullies:
    """Gullies that run down a base and branch: erosion as a function of the place.

    frequency    of the base: cells per unit of input. Default 1
    amplitude    of the base: half the height from its floors to its crests. Default 1
    octaves      in (0, 32]. Default 5
    of_octaves   weights are those of a sum of so many octaves
    lacunarity   frequency ratio between octaves. Default 2
    gain         weight ratio between octaves. Default 0.45
    depth        how far the base is displaced at most, in amplitudes. Default 0.25
    cells        cells of the first gullies per cell of the base. Default 3
    slope        where gullies of crests have half their depth. Default 1.125
    slope_low    the same of floors. Default 1.75
    low, high    the heights of floors and of crests, in amplitudes: -1 and 1
    floor        how far floors sink. Default 0.5
    stripes      gullies per cell. Default 1.5
    branch       how far octaves turn those after them. Default 0.8
    round        how round crests are. Default 0.15
    keep         how far crests and floors are spared. Default 1
    seed         an integer in [-2^63, 2^64); a negative one is 2^64 more
    rotate       turn the axes between octaves
    offset_first whether the seed moves octave 0, too
    period       cells of the base after which gullies repeat along x and y; 0: never

    0 would stand for the default, so it is an error; for an effect that is not wanted give 2^-24.
    Raises ScarpError, a ValueError, that names the member at fault.
    """
    __slots__ = ("_given", "_gullies")

    def __init__(self, *, seed=0, rotate=False, period=None, offset_first=False, **numbers):
        gullies = _Gullies()
        self._given = dict(numbers, seed=seed, rotate=rotate, period=period,
                           offset_first=offset_first)
        for name, value in numbers.items():
            if name not in NUMBERS:
                raise TypeError("gullies have no member %r; there are %s" % (
                    name, ", ".join(NUMBERS)))
            if value is not None:
                setattr(gullies, name, member(name, value, "f8" if name == "frequency" else "f4"))
        gullies.seed, gullies.rotate = seed_of(seed), int(bool(rotate))
        gullies.offset_first = int(bool(offset_first))
        if period is not None:
            if not hasattr(period, "__len__") or len(period) != 2:
                raise ScarpError("two integers are needed, one for each axis", "period")
            gullies.period[:] = [integer("period[%d]" % i, p, 0, 2 ** 30)
                                 for i, p in enumerate(period)]
            self._given["period"] = tuple(gullies.period)
        self._gullies = gullies
        status = lib.scarp_gullies_check(ctypes.addressof(gullies), None)
        if status:
            raise complain(status, *told(lib.scarp_gullies_fault, ctypes.addressof(gullies)))

    def __repr__(self):
        return "Gullies(%s)" % ", ".join(
            "%s=%r" % pair for pair in self._given.items() if pair[1])

    def __reduce__(self):
        return _gullies_of, (self._given,)

    def range(self, base_range):
        """(lowest, highest) of the result, for a base that stays within (lowest, highest)."""
        lo, hi = (single("base_range", v) for v in several("base_range", base_range, 2))
        if lo > hi:
            raise ScarpError("the lowest value is above the highest", "base_range")
        lowest, highest = ctypes.c_float(), ctypes.c_float()
        status = lib.scarp_gullies_range(ctypes.addressof(self._gullies), lo, hi,
                                         ctypes.byref(lowest), ctypes.byref(highest))
        if status:
            raise complain(status)
        return lowest.value, highest.value

    def at(self, base, x, y, *, derivatives=0, threads=1):
        """Draws gullies into samples of a base at the points (x, y), where it was sampled.

        base has value, dx and dy; for derivatives=1 its Hessian, too. x, y are as in Noise.at();
        they broadcast to the shape of the base. Returns (eroded, displacement), two Samples:
        the base plus the displacement, and the displacement alone."""
        given, orders = points(x, y), order(derivatives, 1)
        _check_base(base)
        if given.shape != base.shape:
            raise ScarpError("the base has the shape %s, the points %s" % (
                base.shape, given.shape))
        call = lib.scarp_gullies2_f64 if given.double else lib.scarp_gullies2

        def run(start, stop, before, out):
            return call(ctypes.addressof(self._gullies), stop - start, *given.pointers(start),
                        ctypes.addressof(before), ctypes.addressof(out))

        return self._draw(base, orders, run, given.count, 1, 1, threads, None)

    def grid(self, base, step=1.0, origin=None, first=None, *, derivatives=0, threads=1):
        """Draws gullies into samples of a base on a uniform grid of the plane.

        step, origin, first are those of the base's grid, in the order x, y. base and result are
        as in at()."""
        _check_base(base)
        raster, orders = Raster(base.shape, step, origin, first), order(derivatives, 1)
        if raster.dimensions != 2:
            raise ScarpError("gullies are of the plane: the base needs rows and columns")
        plain = Outputs(raster.shape, ())

        def run(start, stop, before, out):
            grid = raster.structure(plain, start, stop)
            return lib.scarp_gullies_grid2(ctypes.addressof(self._gullies),
                                           ctypes.addressof(grid), ctypes.addressof(before),
                                           ctypes.addressof(out))

        return self._draw(base, orders, run, base.shape[0], base.shape[1], base.shape[1], threads,
                          raster.extent)

    def _draw(self, base, orders, run, length, each, stride, threads, extent):
        for name in NEEDED[orders]:
            if name not in base.members:
                raise ScarpError("the base needs it: sample it with derivatives=%d" % (orders + 1),
                                 name)
        inputs = {name: base._flat(name) for name in NEEDED[orders]}
        names = ("value", "dx", "dy") if orders else ("value",)
        moved = {"value": "displacement", "dx": "displacement_dx", "dy": "displacement_dy"}
        outputs = Outputs(base.shape, names + tuple(moved[name] for name in names))

        def band(start, stop):
            before, at = _Samples(), start * stride
            for name, array in inputs.items():
                setattr(before, name, array.ctypes.data + 4 * at)
            return run(start, stop, before, outputs.fill(_Eroded(), at))

        status = in_bands(band, length, each, threads)
        if status:
            raise complain(status)
        arrays = outputs.arrays
        return (Samples._of({name: arrays[name] for name in names}, base.shape, extent),
                Samples._of({name: arrays[moved[name]] for name in names}, base.shape, extent))


def _check_base(base):
    if not isinstance(base, Samples):
        raise TypeError("base must be Samples, not %s" % type(base).__name__)


def _gullies_of(given):
    return Gullies(**given)
