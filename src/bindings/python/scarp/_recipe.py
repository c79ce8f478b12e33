# SPDX-License-Identifier: MIT
"""Recipes: compositions of noises as a text."""
import ctypes
import os
import threading
from collections import namedtuple

import numpy as np

from ._arrays import Outputs, Raster, check_overlap, in_bands, points
from ._interface import ENUMS
from ._library import HERE, STATUS, STATUS_NAMES, STRUCTURES, ScarpError, complain, lib
from ._numbers import number, order, seed_of, several
from ._samples import Samples, members_of

_Error, _Entry, _Outputs, _Scratch, _Samples, _Box = (STRUCTURES["scarp_" + name] for name in (
    "recipe_error", "recipe_entry", "recipe_outputs", "scratch", "samples", "box"))
ERRORS = 32     # how many errors of a text are told
MOST_SCRATCH = 2 ** 28  # bytes that calls are tried with
FIELDS = tuple(ENUMS["scarp_recipe_kind"]["SCARP_RECIPE_" + kind] for kind in ("FIELD", "NOISE"))


class _Memory(ctypes.c_uint64 * (ctypes.sizeof(STRUCTURES["scarp_recipe"]) // 8)):
    """A recipe in C. Once it is made it stays as it is, with what calls take beside it: the address
    of its plan, and the best sizes of scratch memory for orders 0 to 2."""

    def prepare(self):
        recipe = ctypes.addressof(self)
        size = lib.scarp_recipe_plan_size(recipe)
        self.words = np.empty(size // 8 + 1, np.uint64)
        self.plan = self.words.ctypes.data
        if lib.scarp_recipe_plan_make(recipe, self.plan, size):
            self.plan = None  # then few points take longer
        self.best = [lib.scarp_recipe_scratch_size(recipe, i, 0) for i in range(3)]


Param = namedtuple("Param", "value lowest highest")
Param.__doc__ = "A parameter of a recipe: its value, and the interval that it has."
Info = namedtuple("Info", "cell jumps axes order")
Info.__doc__ = """What an output is. cell: (largest, smallest), the lengths of its cells in units of x and
y, or (0, 0) without a noise. jumps: whether values may jump. axes: those it depends on, such as "xy".
order: the highest order of its derivatives."""
Place = namedtuple("Place", "line column text member nearest")
Place.__doc__ = """An error of a text: line and column, counted from 1 (columns are characters); a
clause; the member at fault, or None; a number that would do there, or 0."""


class RecipeError(ScarpError):
    """What is wrong with a recipe. line and column are those of the first error, counted from 1;
    errors has all of them, as Places. nearest is a number that would do, or 0."""

    def __init__(self, errors, status="SCARP_ERROR_PARAMETER"):
        first = errors[0]
        lines = ["line %d, column %d: %s%s%s" % (
            e.line, e.column, e.member + ": " if e.member else "", e.text,
            "; %.9g would do" % e.nearest if e.nearest else "") for e in errors]
        super().__init__("\n".join(lines), None, status)
        self.errors, self.member = list(errors), first.member
        self.line, self.column, self.nearest = first.line, first.column, first.nearest

    def __reduce__(self):
        return RecipeError, (self.errors, self.status)


def place_of(error):
    """A Place of an error in C. Its columns are bytes, and characters as well: a line has no others
    in front of its first error but those of ASCII."""
    return Place(error.line, error.column, error.text.decode(),
                 error.member.decode() if error.member else None, error.nearest)


class Recipe:
    """A composition of noises as a text; src/recipe/README.md teaches the language.

    text         the text, a str
    seed         the seed of the world, an integer in [-2^63, 2^64); a negative one is 2^64 more
    finest       octaves whose cells are smaller than so many units are left out; 0: none
    **params     values of parameters

    Parameters are attributes: recipe.height = 200. Those whose names a Recipe has already (seed,
    grid, ...) are reached by set(). params has all of them, with their intervals. outputs: the
    names of the outputs. dimensions: 2, or 3 for `space 3`.

    Raises RecipeError, a ValueError with line and column, for a text with errors, or a value with
    which it has one; AttributeError for a parameter that does not exist; ScarpError for a value
    outside its interval.
    Any number of threads may sample a recipe, also while another one changes it: a call uses the
    parameters that it began with.
    """
    __slots__ = ("_memory", "_text", "_lock", "_seed", "_finest", "_tile", "_scale", "_entries",
                 "_outputs", "dimensions", "__weakref__")

    def __init__(self, text, seed=0, finest=0.0, **params):
        if not isinstance(text, str):
            raise TypeError("text must be a str, not %s" % type(text).__name__)
        put = lambda name, value: object.__setattr__(self, name, value)
        put("_text", text.encode("utf-8"))
        put("_lock", threading.Lock())
        put("_seed", 0)
        put("_finest", 0.0)
        put("_tile", None)
        put("_scale", None)
        memory = _Memory()
        errors, found = (_Error * ERRORS)(), ctypes.c_size_t()
        status = lib.scarp_recipe_parse(self._text, len(self._text), ctypes.addressof(memory),
                                        ctypes.addressof(errors), ERRORS, ctypes.byref(found))
        if found.value and status:
            raise RecipeError([place_of(e) for e in errors[:min(found.value, ERRORS)]],
                              STATUS_NAMES[status])
        if status:
            raise ScarpError("a recipe has at most 16,384 bytes, not %d" % len(self._text), "text",
                             STATUS_NAMES[status])
        self._describe(memory)
        put("dimensions", next(iter(self._entries.values()))[1].dimensions)
        if seed != 0:
            self.seed = seed
        if finest != 0:
            self.finest = finest
        for name, value in params.items():
            self.set(name, value)

    # What is in the text

    def _describe(self, memory):
        entries, index = {}, 0
        memory.prepare()
        while True:
            entry = _Entry()
            if lib.scarp_recipe_entry_at(ctypes.addressof(memory), index, ctypes.addressof(entry)):
                break
            name = self._text[entry.name[0]:entry.name[1]].decode()
            entries[name] = (index, entry)
            index += 1
        outputs = sorted((e.output, name) for name, (_, e) in entries.items() if e.output >= 0)
        object.__setattr__(self, "_entries", entries)
        object.__setattr__(self, "_outputs", tuple(name for _, name in outputs))
        object.__setattr__(self, "_memory", memory)

    @property
    def text(self):
        return self._text.decode("utf-8")

    @property
    def outputs(self):
        return self._outputs

    @property
    def params(self):
        return {name: Param(e.value, e.slider[0], e.slider[1])
                for name, (_, e) in self._entries.items() if e.is_param}

    def __getattr__(self, name):
        if not name.startswith("_") and name in self._entries and self._entries[name][1].is_param:
            return self._entries[name][1].value
        raise AttributeError("the recipe has no parameter %r%s" % (
            name, "" if name.startswith("_") else "; there are " + ", ".join(self.params)))

    def __setattr__(self, name, value):
        if name == "seed":
            self._change(lib.scarp_recipe_seed, seed_of(value))
            object.__setattr__(self, "_seed", seed_of(value))
        elif hasattr(type(self), name) and name != "finest":
            raise AttributeError("%s cannot be set" % name)
        else:
            self.set(name, value)

    def __dir__(self):
        return sorted(set(object.__dir__(self)) | set(self.params))

    @property
    def seed(self):
        """The seed of the world."""
        return self._seed

    @property
    def finest(self):
        """Octaves whose cells are smaller than so many units are left out; 0: none."""
        return self._finest

    def set(self, name, value):
        """Sets a parameter, or "finest"."""
        value = number(name, value)
        if name != "finest" and name not in self.params:
            raise AttributeError("the recipe has no parameter %r; there are %s" % (
                name, ", ".join(self.params)))
        if name != "finest":
            _, lowest, highest = self.params[name]
            if not lowest <= value <= highest:
                raise ScarpError("%r is not in [%.9g, %.9g]" % (value, lowest, highest), name)
        error = _Error()
        self._change(lib.scarp_recipe_set, name.encode(), value, ctypes.addressof(error),
                     error=error, at_fault=name)
        if name == "finest":
            object.__setattr__(self, "_finest", value)

    def tile(self, x, y, z=0.0):
        """Makes the recipe repeat after so many units along each axis, in place of a tile in the
        text; with 0 for all, it does not repeat."""
        sides = number("x", x), number("y", y), number("z", z)
        error = _Error()
        self._change(lib.scarp_recipe_tile, *sides, ctypes.addressof(error), error=error,
                     at_fault="tile")
        object.__setattr__(self, "_tile", sides)

    def scale(self, by, heights=1.0):
        """Makes the recipe so many times larger, as scale(..., by) does with each statement, and
        multiplies the first output by `heights`. 1 changes nothing."""
        factors = number("by", by), number("heights", heights)
        error = _Error()
        self._change(lib.scarp_recipe_scale, *factors, ctypes.addressof(error), error=error,
                     at_fault="scale")
        object.__setattr__(self, "_scale", factors)

    def info(self, output=None):
        """What an output is, or any other field of the text; default the first output: an Info."""
        (name,), _ = self._which([output or self._outputs[0]])
        entry = self._entries[name][1]
        axes = "".join(axis for i, axis in enumerate("xyz") if entry.axes >> i & 1)
        return Info(tuple(entry.cell), bool(entry.jumps), axes, entry.order)

    def _change(self, call, *arguments, error=None, at_fault="seed"):
        """Changes a copy and puts it in the place of the recipe: calls under way keep theirs."""
        with self._lock:
            memory = _Memory.from_buffer_copy(self._memory)
            status = call(ctypes.addressof(memory), *arguments)
            if status and error is not None and error.text:
                raise RecipeError([place_of(error)], STATUS_NAMES[status])
            if status:
                raise complain(status, at_fault)
            self._describe(memory)

    def __reduce__(self):
        return _recipe_of, (self.text, self._seed, self._finest,
                            {name: p.value for name, p in self.params.items()},
                            self._scale, self._tile)

    def __repr__(self):
        return "<scarp.Recipe of %s>" % ", ".join(self._outputs)

    # Samples

    def _which(self, output):
        """Names of statements, their numbers in C, and whether a tuple was asked for."""
        several_ = not isinstance(output, str) and output is not None
        names = list(output) if several_ else [output or self._outputs[0]]
        for name in names:
            if name not in self._entries or self._entries[name][1].kind not in FIELDS:
                raise ScarpError("there is no such output or field; there are " + ", ".join(
                    n for n, (_, e) in self._entries.items() if e.kind in FIELDS), repr(name))
        if not 1 <= len(names) <= 16:
            raise ScarpError("from 1 to 16 outputs, not %d" % len(names), "output")
        return names, several_

    def _prepare(self, output, orders, shape, dimensions, out):
        if dimensions != self.dimensions:
            raise ScarpError("the recipe is of %s" % (
                "space: it needs z" if self.dimensions == 3 else "the plane: it has no z"))
        names, several_ = self._which(output)
        for name in names:
            there = self._entries[name][1].order
            if there < orders:
                raise ScarpError("%r has no derivatives of the order %d, only up to %d" % (
                    name, orders, there), "derivatives", "SCARP_ERROR_UNSUPPORTED")
        if out is not None and several_ and (not isinstance(out, (list, tuple))
                                             or len(out) != len(names)):
            raise TypeError("out must be a sequence with an entry for each output")
        given = list(out) if several_ and out is not None else [out] * len(names)
        members = members_of(dimensions, orders)
        return names, several_, [Outputs(shape, members, o) for o in given]

    def _run(self, names, orders, outputs, each, call):
        """A function of a band, which has `each` points per row, or per point: with its own
        structures and scratch memory."""
        memory, entries = self._memory, self._entries
        which = (ctypes.c_int32 * len(names))(*[entries[name][0] for name in names])

        def band(start, stop, offset):
            out = (_Samples * len(names))()
            for of, o in zip(out, outputs):
                o.fill(of, offset)
            asked = _Outputs(out=ctypes.addressof(out), which=ctypes.addressof(which),
                             count=len(names))
            here = ctypes.addressof(memory), start, stop, ctypes.addressof(asked)
            best, few = memory.best[orders], lib.scarp_recipe_scratch_size(
                here[0], orders, max((stop - start) * each, 1))
            size, status = min(best, few or best), STATUS["SCARP_ERROR_SIZE"]
            # That is the size for outputs of the text. Other fields may need more.
            while status == STATUS["SCARP_ERROR_SIZE"] and size <= MOST_SCRATCH:
                scratch = np.empty(size // 8 + 1, np.uint64)
                room = _Scratch(memory=scratch.ctypes.data, size=8 * scratch.size,
                                plan=memory.plan)
                status = call(*here, ctypes.addressof(room))
                size = max(2 * size, 8192)
            return status
        return band

    def grid(self, shape, step=1.0, origin=None, first=None, *, derivatives=0, output=None,
             out=None, threads=1):
        """Samples on a uniform grid, as Noise.grid() has it: shape is NumPy's, (rows, columns);
        step, origin and first are in the order x, y, z.

        output    the name of an output, or of any field in the text; default the first output.
                  A sequence of names gives a tuple of Samples, at little more cost than one.
        out       as in Noise.grid(); for a sequence of outputs, a sequence.
        """
        raster, orders = Raster(shape, step, origin, first), order(derivatives)
        names, several_, outputs = self._prepare(output, orders, raster.shape, raster.dimensions,
                                                 out)
        if out is not None:
            self._check_out(names, outputs, ())
        plain = outputs[0]

        def call(recipe, start, stop, asked, room):
            grid = raster.structure(plain, start, stop)
            return lib.scarp_recipe_grid(recipe, ctypes.addressof(grid), asked, room)

        each = int(np.prod(raster.shape[1:], dtype=float))
        run = self._run(names, orders, outputs, each, call)
        status = in_bands(lambda start, stop: run(start, stop, raster.offset(plain, start)),
                          raster.shape[0], each, threads)
        return self._results(status, several_, outputs, raster.shape, raster.extent)

    def at(self, x, y, z=None, *, derivatives=0, output=None, out=None, threads=1):
        """Samples at points, as Noise.at() has it; output is as in grid()."""
        given, orders = points(x, y, z), order(derivatives)
        names, several_, outputs = self._prepare(output, orders, given.shape, len(given.arrays),
                                                 out)
        if out is not None:
            self._check_out(names, outputs, given.arrays)
        function = lib.scarp_recipe_sample_f64 if given.double else lib.scarp_recipe_sample

        def call(recipe, start, stop, asked, room):
            where = given.pointers(start) + [None] * (3 - len(given.arrays))
            return function(recipe, stop - start, *where, asked, room)

        run = self._run(names, orders, outputs, 1, call)
        status = in_bands(lambda start, stop: run(start, stop, start), given.count, 1, threads)
        return self._results(status, several_, outputs, given.shape, None)

    @staticmethod
    def _check_out(names, outputs, points_):
        """Arrays of the caller: one set of strides, no overlap."""
        arrays = []
        for name, of in zip(names, outputs):
            of.contiguous() if points_ else of.strided()
            arrays += [("%s.%s" % (name, member), a) for member, a in of.arrays.items()]
            if (of.row, of.slice_) != (outputs[0].row, outputs[0].slice_):
                raise ScarpError("all arrays of a call need the same strides", "out")
        check_overlap(arrays, points_, False)

    def _results(self, status, several_, outputs, shape, extent):
        if status:
            raise complain(status)
        made = tuple(Samples._of(of.arrays, shape, extent) for of in outputs)
        return made if several_ else made[0]

    def range(self, output=None, box=None):
        """(lowest, highest): the interval that values never leave, rounding included.

        box: ((x0, y0), (x1, y1)), or with z in space: points outside it do not count. Without one
        the interval holds everywhere, and is infinite where coordinates themselves count."""
        (name,), _ = self._which([output or self._outputs[0]])
        lowest, highest, where = ctypes.c_float(), ctypes.c_float(), None
        if box is not None:
            where = _Box()
            for ends, corner, what in zip((where.lowest, where.highest), several("box", box, 2),
                                          ("lowest", "highest")):
                for i, value in enumerate(several("box", corner, self.dimensions)):
                    ends[i] = number("box", value)
        memory = self._memory  # held here: another thread may put a new one in its place
        status = lib.scarp_recipe_range(
            ctypes.addressof(memory), self._entries[name][0],
            None if where is None else ctypes.addressof(where), ctypes.byref(lowest),
            ctypes.byref(highest))
        if status:
            raise complain(status, "box" if box is not None else None)
        return lowest.value, highest.value


def _recipe_of(text, seed, finest, params, scale=None, tile=None):
    recipe = Recipe(text, seed, finest)
    for name, value in params.items():  # which may have the name of an argument
        recipe.set(name, value)
    if scale is not None:
        recipe.scale(*scale)
    if tile is not None:
        recipe.tile(*tile)
    return recipe


# The recipes of the program

def _folder():
    """Where presets are: beside this file, or in the tree that it is a part of."""
    beside = os.path.join(HERE, "presets")
    tree = os.path.join(HERE, "..", "..", "..", "cli", "presets")
    return beside if os.path.isdir(beside) else os.path.normpath(tree)


def presets():
    """The names of presets, as the program scarp has them: a tuple."""
    return tuple(sorted(name[:-7] for name in os.listdir(_folder()) if name.endswith(".recipe")))


def preset(name, seed=0, finest=0.0, **params):
    """A recipe of the program: preset("alps", seed=8, height=900). Coordinates, and most heights,
    are in metres. Raises ScarpError for a name that there is not."""
    if name not in presets():
        raise ScarpError("there is no preset %r; there are %s" % (name, ", ".join(presets())))
    with open(os.path.join(_folder(), name + ".recipe"), encoding="utf-8") as file:
        return Recipe(file.read(), seed, finest, **params)
