# SPDX-License-Identifier: MIT
"""Samples: values with their derivatives, and functions of them by the chain rule."""
import ctypes

import numpy as np

from ._arrays import FLOAT, readable, real
from ._chain import Chain
from ._library import STRUCTURES, ScarpError, complain, lib
from ._numbers import is_number, number, single

MEMBERS = ("value", "dx", "dy", "dz", "dxx", "dxy", "dxz", "dyy", "dyz", "dzz", "dphase")
# What must be there for each member, beside the value: a second derivative needs first ones.
NEEDS = {"dxx": ("dx",), "dxy": ("dx", "dy"), "dxz": ("dx", "dz"), "dyy": ("dy",),
         "dyz": ("dy", "dz"), "dzz": ("dz",)}
SECOND = tuple(NEEDS)
LINEAR = ("scarp_affine", "scarp_add")  # whose derivatives need nothing else
_Samples, _Partials = STRUCTURES["scarp_samples"], STRUCTURES["scarp_partials"]


def members_of(dimensions, order, dphase=False):
    """The names that a call computes."""
    axes = "xy" if dimensions == 2 else "xyz"
    found = ["value"]
    if order >= 1:
        found += ["d" + a for a in axes]
    if order >= 2:
        found += ["d" + a + b for i, a in enumerate(axes) for b in axes[i:]]
    return found + (["dphase"] if dphase else [])


class Samples(Chain):
    """Values, and their exact partial derivatives, as float32 arrays of one shape.

    value           the value
    dx, dy, dz      the gradient, per unit of input
    dxx, dxy, ...   the Hessian, per unit of input squared
    dphase          the derivative with respect to the phase, per turn

    A member that was not asked for raises AttributeError. members: the names that are there, a
    tuple. shape: their shape. extent: of grids, the edges (left, right, bottom, top) for imshow
    with origin="lower"; else None.

    Operators and methods make new samples, with all derivatives that both operands have, by the
    chain rule: + - * / with samples and numbers, unary -, abs(). Numbers are constants; their
    derivatives are 0. Both operands need the same shape, and derivatives by the same coordinates.
    Everything is computed in float32. Samples raises ScarpError (a ValueError) for shapes that
    differ and for numbers outside their interval.
    """
    __slots__ = ("_arrays", "shape", "extent")
    __array_ufunc__ = None  # arrays have no derivatives: array * samples is a TypeError

    def __init__(self, value, extent=None, **derivatives):
        """Samples of arrays of your own; float32 arrays are not copied."""
        arrays = dict(derivatives, value=value)
        for name in arrays:
            if name not in MEMBERS:
                raise TypeError("samples have no member %r; there are %s" % (
                    name, ", ".join(MEMBERS)))
        self.shape = np.shape(value)
        self._arrays = {}
        for name in MEMBERS:
            if name in arrays:
                array = real(name, arrays[name])
                if array.shape != self.shape:
                    raise ScarpError("must have the shape %s of the value, not %s" % (
                        self.shape, array.shape), name)
                self._arrays[name] = array if array.dtype == FLOAT else array.astype(FLOAT)
        self.extent = extent

    @classmethod
    def _of(cls, arrays, shape, extent=None):
        made = cls.__new__(cls)
        made._arrays, made.shape, made.extent = arrays, shape, extent
        return made

    def __getattr__(self, name):
        if name in MEMBERS:
            try:
                return self._arrays[name]
            except KeyError:
                raise AttributeError("%s was not computed: ask for it by %s" % (
                    name, "dphase=True" if name == "dphase" else
                    "derivatives=%d" % (2 if name in SECOND else 1))) from None
        raise AttributeError("samples have no member %r" % name)

    def __dir__(self):
        return sorted(set(object.__dir__(self)) | set(self._arrays))

    def __getstate__(self):
        return self._arrays, self.shape, self.extent

    def __setstate__(self, state):
        self._arrays, self.shape, self.extent = state

    def __repr__(self):
        return "<scarp.%s %s: %s>" % (type(self).__name__, self.shape, ", ".join(self._arrays))

    @property
    def members(self):
        return tuple(self._arrays)

    def normals(self, height_scale=1.0):
        """Unit normals of the surface z = height_scale * value, an array of shape + (3,).

        x and y are the axes of the input, z points up. It needs dx and dy; height_scale is in
        units of input per unit of value."""
        if "dx" not in self._arrays or "dy" not in self._arrays:
            raise ScarpError("normals need dx and dy: ask for derivatives=1")
        scale = single("height_scale", height_scale)
        dx, dy = (self._flat(name) for name in ("dx", "dy"))
        out = np.empty((3,) + self.shape, FLOAT)
        status = lib.scarp_normals(dx.size, dx.ctypes.data, dy.ctypes.data, scale,
                                   *(plane.ctypes.data for plane in out.reshape(3, -1)))
        if status:
            raise complain(status, "height_scale")
        return np.moveaxis(out, 0, -1)

    # The chain rule

    def _flat(self, name):
        array = self._arrays[name]
        if array.shape != self.shape:
            raise ScarpError("was reshaped", name)
        return readable(array, FLOAT)

    def constant(self, value):
        """Samples that have a number everywhere, with the members of these; derivatives are 0."""
        arrays = {name: np.zeros(self.shape, FLOAT) for name in self._arrays}
        arrays["value"] = np.full(self.shape, single("value", value), FLOAT)
        return Samples._of(arrays, self.shape, self.extent)

    def _other(self, other):
        """Samples of an operand, which may be a number; None for all else."""
        if isinstance(other, Samples):
            return other
        return self.constant(other) if is_number(other) else None

    def _needed(self, what, other):
        made = self._other(other)
        if made is None:
            raise TypeError("%s must be samples or a number, not %s" % (
                what, type(other).__name__))
        return made

    def __neg__(self):
        return self.affine(-1.0)

    def __pos__(self):
        return self

    def __abs__(self):
        """The magnitude, with a crease at 0."""
        return _call("scarp_abs", [self])

    def __add__(self, other):
        if isinstance(other, Samples):
            return _call("scarp_add", [self, other])
        return self.affine(1.0, other) if is_number(other) else NotImplemented

    __radd__ = __add__

    def __sub__(self, other):
        if isinstance(other, Samples):
            return _call("scarp_add", [self, -other])
        # a float: unsigned integers of NumPy wrap
        return self.affine(1.0, -number("other", other)) if is_number(other) else NotImplemented

    def __rsub__(self, other):
        return self.affine(-1.0, other) if is_number(other) else NotImplemented

    def __mul__(self, other):
        if isinstance(other, Samples):
            return _call("scarp_multiply", [self, other])
        return self.affine(other) if is_number(other) else NotImplemented

    __rmul__ = __mul__

    def __truediv__(self, other):
        other = self._other(other)
        return NotImplemented if other is None else _call("scarp_divide", [self, other])

    def __rtruediv__(self, other):
        other = self._other(other)
        return NotImplemented if other is None else _call("scarp_divide", [other, self])

    def _chain(self, name, scalars, **others):
        """A function of the chain rule: operands but the first one by their names, and pairs of a
        name and a number."""
        inputs = [self] + [self._needed(what, other) for what, other in others.items()]
        return _call(name, inputs, scalars)

    def curve(self, x, value):
        """A smooth curve through 2 to 64 knots, which has value[k] where self is x[k]. It never
        overshoots, and is level outside. x must rise."""
        x, value = (np.ascontiguousarray(real(name, a), FLOAT) for name, a in
                    (("x", x), ("value", value)))
        if x.ndim != 1 or x.shape != value.shape:
            raise ScarpError("x and value must be as many numbers: %s, %s" % (
                x.shape, value.shape), "knots")
        return _run("scarp_curve", [self], _members([self]), self.shape, self.extent,
                    (x.size, x.ctypes.data, value.ctypes.data), "x, value")

    def slope(self):
        """The length of the gradient. It needs dx and dy (and dz in space), and has derivatives
        of one order less; no second ones."""
        axes = [a for a in "xyz" if "d" + a in self._arrays]
        if len(axes) < 2:
            raise ScarpError("a slope needs the gradient: ask for derivatives=1")
        pairs = ["d" + min(a, b) + max(a, b) for a in axes for b in axes]
        members = ["value"] + ["d" + a for a in axes if all(p in self._arrays for p in pairs)]
        return _run("scarp_slope", [self], members, self.shape, self.extent)

    def apply(self, f, fa=None, faa=None):
        """Any function of self, given at each point as arrays of this shape (or numbers): f, its
        derivative fa, its second derivative faa. Without fa there are no derivatives, without faa
        no second ones."""
        return _apply("scarp_apply1", [self], [("f", f)], [("fa", fa)], [("faa", faa)])

    def apply2(self, other, f, fa=None, fb=None, faa=None, fab=None, fbb=None):
        """Any function of self (a) and other (b), given at each point, as apply() has it."""
        return _apply("scarp_apply2", [self, self._needed("other", other)], [("f", f)],
                      [("fa", fa), ("fb", fb)], [("faa", faa), ("fab", fab), ("fbb", fbb)])


def _members(inputs, values=True):
    """Members that all inputs have, with what these need."""
    shape = inputs[0].shape
    for other in inputs[1:]:
        if other.shape != shape:
            raise ScarpError("samples of different shapes: %s, %s" % (shape, other.shape))
        space = ["dz" in s._arrays for s in (inputs[0], other)]
        if all("dx" in s._arrays for s in (inputs[0], other)) and space[0] != space[1]:
            raise ScarpError("samples of the plane and of space: one has dz, the other has not")
    found = [name for name in MEMBERS if all(name in s._arrays for s in inputs)]
    return [name for name in found if not values or all(n in found for n in NEEDS.get(name, ()))]


def _call(name, inputs, scalars=()):
    """A function of the chain rule, with numbers behind the samples."""
    given = [single(what, value) for what, value in scalars]
    return _run(name, inputs, _members(inputs, name not in LINEAR), inputs[0].shape, inputs[0].extent, given,
                ", ".join(what for what, _ in scalars) or None)


def _run(name, inputs, members, shape, extent, arguments=(), at_fault=None, partials=None):
    """Calls C. New arrays are written, so nothing overlaps."""
    keep, structures = [], []
    for samples in inputs:
        structure = _Samples()
        for member in samples._arrays:
            array = samples._flat(member)
            keep.append(array)
            setattr(structure, member, array.ctypes.data)
        structures.append(structure)
    out, arrays = _Samples(), {}
    for member in members:
        arrays[member] = np.empty(shape, FLOAT)
        setattr(out, member, arrays[member].ctypes.data)
    count = arrays["value"].size
    before = [ctypes.byref(s) for s in structures] + ([ctypes.byref(partials)] if partials else [])
    status = getattr(lib, name)(count, *before, *arguments, ctypes.byref(out))
    if status:
        raise complain(status, at_fault)
    return Samples._of(arrays, shape, extent)


def _apply(name, inputs, *orders):
    partials, keep, shape = _Partials(), [], inputs[0].shape
    given = 0
    for order, group in enumerate(orders):
        there = [value is not None for _, value in group]
        if any(there) and not (all(there) and given == order):
            raise ScarpError("of %s all must be given, with those of lower order" % ", ".join(
                what for what, _ in group))
        given += all(there)
        for what, value in group:
            if value is None:
                continue
            array = real(what, value)
            if array.ndim and array.shape != shape:
                raise ScarpError("must have the shape %s, not %s" % (shape, array.shape), what)
            array = readable(np.broadcast_to(array, shape), FLOAT)
            keep.append(array)
            setattr(partials, what, array.ctypes.data)
    members = [m for m in _members(inputs) if m == "value" or given > (2 if m in SECOND else 1)]
    return _run(name, inputs, members, shape, inputs[0].extent, partials=partials)
