# SPDX-License-Identifier: MIT
"""What the Python module takes and refuses.

    test_module.py SOURCE_DIR LIBRARY
"""
import copy
import ctypes
import math
import os
import pickle
import subprocess
import sys
import tempfile
import threading
import unittest

from common import LIBRARY, MODULE, prepare, run

prepare()
import numpy as np  # noqa: E402
import scarp  # noqa: E402
from scarp import _arrays  # noqa: E402

F = np.float32
_arrays.BAND = 64  # so that small calls in threads have bands


def equal(a, b):
    np.testing.assert_array_equal(a, b)


class Mistakes(unittest.TestCase):
    """The seven mistakes that calls by ctypes do not notice."""
    noise = scarp.Noise(seed=42, octaves=2)
    x = np.linspace(0, 5, 8, dtype=F)

    def refused(self, text, call, kind=ValueError):
        with self.assertRaisesRegex(kind, text):
            call()

    def test_1_double_output(self):
        out = np.full(8, 7.0)
        self.refused("out.*float32, not float64", lambda: self.noise.at(self.x, self.x, out=out))
        equal(out, np.full(8, 7.0))

    def test_2_small_output(self):
        for shape in ((7,), (4, 8), (8, 1), (0,)):
            self.refused("shape", lambda: self.noise.at(self.x, self.x, out=np.empty(shape, F)))

    def test_3_small_input(self):
        self.refused("broadcast|mismatch", lambda: self.noise.at(self.x, self.x[:7]),
                     scarp.ScarpError)

    def test_4_forgotten_tail(self):
        from scarp import _interface, _library
        size, members = _interface.STRUCTURES["scarp_noise"]
        _interface.STRUCTURES["short"] = size, members[:-1]
        try:
            self.refused("another size", lambda: _library._structure("short"), ImportError)
        finally:
            del _interface.STRUCTURES["short"]

    def test_5_pointer_as_integer(self):
        out = np.empty(8, F)
        self.refused("out must be", lambda: self.noise.at(self.x, self.x, out=out.ctypes.data),
                     TypeError)

    def test_6_strided_view(self):
        whole = np.full(16, 7, F)
        self.refused("contiguous", lambda: self.noise.at(self.x, self.x, out=whole[::2]))
        board = np.full((8, 16), 7, F)
        self.refused("contiguous", lambda: self.noise.grid((8, 8), out=board[:, ::2]))
        self.refused("contiguous", lambda: self.noise.grid((16, 8), out=board.T))
        self.refused("contiguous", lambda: self.noise.grid((8, 16), out=board[::-1]))
        self.assertTrue((whole == 7).all() and (board == 7).all())

    def test_7_no_output(self):
        self.refused("no array", lambda: self.noise.at(self.x, self.x, out={}))
        self.assertEqual(self.noise.at(self.x, self.x).members, ("value",))


class Arrays(unittest.TestCase):
    noise = scarp.Noise(seed=1, frequency=0.3, octaves=3)

    def setUp(self):
        self.x = np.linspace(-4, 9, 30)
        self.want = self.noise.at(self.x, self.x * 2).value

    def test_strides_and_orders(self):
        wide = np.zeros((30, 3))
        wide[:, 1] = self.x
        equal(self.noise.at(wide[:, 1], self.x * 2).value, self.want)
        equal(self.noise.at(self.x[::-1], self.x[::-1] * 2).value, self.want[::-1])
        square = self.x.reshape(5, 6)
        equal(self.noise.at(np.asfortranarray(square), square * 2).value,
              self.want.reshape(5, 6))
        unaligned = np.frombuffer(b"x" + self.x.tobytes(), np.uint8)[1:].view(np.float64)
        equal(self.noise.at(unaligned, self.x * 2).value, self.want)
        equal(self.noise.at(self.x.astype(">f8"), self.x * 2).value, self.want)
        locked = self.x.copy()
        locked.flags.writeable = False
        equal(self.noise.at(locked, self.x * 2).value, self.want)

    def test_dtypes(self):
        whole = np.arange(5)
        for kind in (np.int8, np.uint16, np.int64, np.float64):
            equal(self.noise.at(whole.astype(kind), 0.25).value,
                  self.noise.at(whole.astype(float), np.full(5, 0.25)).value)
        single = self.x.astype(F)
        far = single + F(2 ** 23)
        # float32 takes the calls for float32, numbers beside it included; float64 the others.
        equal(self.noise.at(far, 0.5).value, self.noise.at(far, np.full(30, 0.5, F)).value)
        self.assertTrue((self.noise.at(far, 0.5).value !=
                         self.noise.at(far.astype(float) + 0.3, 0.5).value).any())
        equal(self.noise.at(single.astype(np.float16), 1).value,
              self.noise.at(single.astype(np.float16).astype(F), 1).value)
        for bad in (single > 0, single.astype(complex), single.astype(str),
                    np.array([1, None] * 15), np.ma.masked_array(single, single > 3)):
            with self.assertRaises(TypeError):
                self.noise.at(bad, single)

    def test_broadcasting(self):
        x, y = np.arange(7.0), np.arange(5.0)[:, None]
        board = self.noise.at(x, y, derivatives=1)
        grid = self.noise.grid((5, 7), derivatives=1)
        for name in grid.members:
            equal(getattr(board, name), getattr(grid, name))
        self.assertEqual(self.noise.at(1.5, 2).value.shape, ())
        self.assertEqual(self.noise.at([], []).value.shape, (0,))
        self.assertEqual(self.noise.grid((0, 4)).value.shape, (0, 4))
        self.assertEqual(self.noise.at(x, y, 0.5, derivatives=2).dyz.shape, (5, 7))
        equal(self.noise.at(math.nan, 1.0).value, math.nan)

    def test_views_of_rows(self):
        board = np.full((40, 60), 9, F)
        want = self.noise.grid((20, 30), 0.5, first=(3, 4)).value
        self.noise.grid((20, 30), 0.5, first=(3, 4), out=board[10:30, 5:35], threads=2)
        equal(board[10:30, 5:35], want)
        self.assertEqual((board != 9).sum(), 600)
        box = np.full((6, 8, 9), 9, F)
        inner = box[1:4, 2:7, 3:7]
        self.noise.grid((3, 5, 4), out=inner)
        equal(inner, self.noise.grid((3, 5, 4)).value)
        self.assertEqual((box != 9).sum(), 60)
        big = [np.empty((40, 60), F) for _ in range(3)]
        out = dict(zip(("value", "dx", "dy"), (b[:20, :30] for b in big)))
        self.noise.grid((20, 30), derivatives=1, out=out)
        equal(big[2][:20, :30], self.noise.grid((20, 30), derivatives=1).dy)
        with self.assertRaisesRegex(ValueError, "strides"):
            self.noise.grid((20, 30), derivatives=1, out={"value": big[0][:20, :30]})

    def test_outputs(self):
        x, y = self.x.astype(F), np.ones(30, F)
        want = self.noise.at(x, y, derivatives=1)
        dx = np.empty(30, F)
        got = self.noise.at(x, y, derivatives=1, out={"dx": dx})
        self.assertIs(got.dx, dx)
        equal(dx, want.dx)
        equal(got.value, want.value)
        again = self.noise.at(x, y, derivatives=1, out=got)
        self.assertIs(again.value, got.value)
        locked = np.empty(30, F)
        locked.flags.writeable = False
        unaligned = np.empty(121, np.uint8)[1:].view(F)
        for out, text in ((locked, "read-only"), (unaligned, "aligned"), ({"dz": dx}, "dz"),
                          ({"value": dx, "dx": dx}, "overlaps"), (dx.astype(">f4"), "float32"),
                          ({"value": np.arange(40, dtype=F)[:30]}, None)):
            if text:
                with self.assertRaisesRegex(ValueError, text):
                    self.noise.at(x, y, derivatives=1, out=out)
        for out in ([1.0] * 30, np.ma.zeros(30, F), 5, {"value": [0.0] * 30}):
            with self.assertRaises(TypeError):
                self.noise.at(x, y, out=out)

    def test_overlap(self):
        whole = np.linspace(0, 4, 60, dtype=F)
        x, y = whole[:30], np.ones(30, F)
        want = self.noise.at(x, y).value
        with self.assertRaisesRegex(ValueError, "overlaps with an input"):
            self.noise.at(x, y, out=whole[1:31])
        parts = np.empty(31, F)
        with self.assertRaisesRegex(ValueError, "dy: overlaps with dx"):
            self.noise.at(x, y, derivatives=1, out={"dx": parts[1:], "dy": parts[:30]})
        doubles = np.linspace(0, 4, 30)
        with self.assertRaisesRegex(ValueError, "overlaps with an input"):
            self.noise.at(doubles, y.astype(float), out=doubles.view(F)[:30])
        self.noise.at(x, y, out=x)  # in place
        equal(x, want)


class Members(unittest.TestCase):
    def named(self, member, call, kind=scarp.ScarpError):
        with self.assertRaises(kind) as caught:
            call()
        self.assertEqual(caught.exception.member, member)
        self.assertIsInstance(caught.exception, ValueError)

    def test_numbers(self):
        for name, values in {
                "octaves": (33, -1, math.nan, 0, 1e-60), "gain": (17, 0, math.inf),
                "frequency": (0, -1, math.nan, 1e300), "amplitude": (0, 1e39, 1e-50),
                "seed": (-2 ** 63 - 1, 2 ** 64, -0.5), "jitter": (1.5,), "phase": (math.nan, 1e39, 1e-60),
                "basis": ("perlin", 99, -1), "fractal": ("fBm",), "fade": ("linear",)}.items():
            for value in values:
                self.named(name, lambda: scarp.Noise(**{name: value}))
        self.named("of_octaves", lambda: scarp.Noise(octaves=4, of_octaves=3))
        self.named("period[1]", lambda: scarp.Noise(period=(4, -1)))
        self.named("period[1]", lambda: scarp.Noise(period=(4, 2 ** 32 + 4)))
        self.named("phase", lambda: scarp.Noise("simplex", phase=0.5))
        self.named("frequency", lambda: scarp.Gullies(frequency=-1))
        self.named("keep", lambda: scarp.Gullies(keep=0))
        self.named("base_range", lambda: scarp.Gullies().range((-1, 0, 1)))
        self.assertEqual(repr(scarp.Gullies(period=np.array([8, 4]))),
                         "Gullies(period=(8, 4))")
        self.assertRaises(TypeError, scarp.Gullies().at, np.zeros(3), np.zeros(3), np.zeros(3))
        for bad in ("1", None, [1], 1j, True):
            if bad is not None:
                with self.assertRaises(TypeError):
                    scarp.Noise(octaves=bad)
        with self.assertRaises(TypeError):
            scarp.Noise(warp="noise")
        with self.assertRaises(TypeError):
            scarp.Noise(octave=3)

    def test_dimensions(self):
        columns = scarp.Noise("simplex", period=(4, 4, 4))  # of space alone
        self.assertEqual(columns.grid((2, 2, 2)).value.shape, (2, 2, 2))
        self.named("period[1]", lambda: columns.grid((2, 2)))
        self.named("period[1]", lambda: columns.range())
        self.assertEqual(scarp.Noise(amplitude=3).range(3), (-3.0, 3.0))
        self.named("dimensions", lambda: columns.range(4))

    def test_derivatives(self):
        self.named("derivatives", lambda: scarp.Noise().grid((2, 2), derivatives=3))
        self.named("derivatives", lambda: scarp.Noise().cells(1, 2, derivatives=2))
        with self.assertRaises(TypeError):
            scarp.Noise().grid((2, 2), derivatives=True)
        with self.assertRaisesRegex(AttributeError, "derivatives=2"):
            scarp.Noise().grid((2, 2), derivatives=1).dxx

    def test_reasons(self):
        """Errors say what the library says: which member, also of a warp, and why."""
        swiss = scarp.Noise(fractal="swiss")
        bent = scarp.Noise(warp=scarp.Noise(warp=swiss))
        columns = scarp.Noise("simplex", period=(4, 4, 4))
        no_hessian = "fractal: this fractal has no Hessian"
        for said, status, call in (
                ("rotate: turned axes cannot repeat", "UNSUPPORTED",
                 lambda: scarp.Noise(rotate=True, octaves=2, period=(4, 4))),
                ("octaves: outside (0, 32]", "PARAMETER", lambda: scarp.Noise(octaves=33)),
                ("phase: only gradient noise has a phase", "UNSUPPORTED",
                 lambda: scarp.Noise("value", phase=1)),
                ("warp.period[1]: simplex noise repeats along x only in 2D; a slice of 3D, with periods, repeats along both", "UNSUPPORTED",
                 lambda: scarp.Noise(warp=columns).grid((2, 2))),
                ("warp.period[1]: simplex noise repeats along x only in 2D; a slice of 3D, with periods, repeats along both", "UNSUPPORTED",
                 lambda: scarp.Noise(warp=columns).range()),
                (no_hessian, "UNSUPPORTED", lambda: swiss.grid((2, 2), derivatives=2)),
                ("warp.warp." + no_hessian, "UNSUPPORTED", lambda: bent.at(1, 2, derivatives=2)),
                ("warp.warp." + no_hessian, "UNSUPPORTED", lambda: bent.vector(1, 2, derivatives=2)),
                (no_hessian, "UNSUPPORTED", lambda: swiss.curl(1, 2, derivatives=1)),
                ("basis: only gradient noise has dphase", "UNSUPPORTED",
                 lambda: scarp.Noise("value").at(1, 2, dphase=True)),
                ("floor: outside [-1, 1]", "PARAMETER", lambda: scarp.Gullies(floor=2))):
            with self.assertRaises(scarp.ScarpError) as caught:
                call()
            self.assertEqual(str(caught.exception), said)
            self.assertEqual(caught.exception.status, "SCARP_ERROR_" + status)

    def test_grid_arguments(self):
        noise = scarp.Noise()
        self.named("origin[1]", lambda: noise.grid((2, 2), origin=(0, math.nan)))
        self.named("step[0]", lambda: noise.grid((2, 2), step=math.inf))
        self.named("first[0]", lambda: noise.grid((2, 2), first=(2 ** 53, 0)))
        self.named("first[1]", lambda: noise.grid((2, 2), first=(0, 2 ** 64)))
        self.named("first[0]", lambda: noise.grid((2, 2), first=(0.5, 0)))
        self.named("shape[0]", lambda: noise.grid((-1, 2)))
        self.named("shape", lambda: noise.grid((4,)))
        self.named("step", lambda: noise.grid((2, 2), step=(1, 1, 1)))
        self.named("threads", lambda: noise.grid((2, 2), threads=0))
        with self.assertRaises((MemoryError, ValueError)):
            noise.grid((2 ** 40, 2 ** 40))
        tile = noise.grid((3, 4), 2.0, (10, 20), (1, 2))
        self.assertEqual(tile.extent, (11.0, 19.0, 23.0, 29.0))

    def test_noise_is_a_value(self):
        warp = scarp.Noise("simplex", amplitude=9)
        noise = scarp.Noise(fractal="ridged", seed=2 ** 64 - 1, octaves=2.5, warp=warp)
        for other in (copy.deepcopy(noise), pickle.loads(pickle.dumps(noise)), noise.replace()):
            self.assertEqual(other, noise)
            self.assertEqual(hash(other), hash(noise))
            equal(other.grid((4, 4)).value, noise.grid((4, 4)).value)
        self.assertNotEqual(noise.replace(seed=1), noise)
        self.assertEqual((noise.seed, noise.octaves, noise.gain, noise.warp.basis),
                         (2 ** 64 - 1, 2.5, 0.5, "simplex"))
        self.assertEqual(repr(scarp.Noise(octaves=3)), "Noise(octaves=3.0)")
        with self.assertRaises(AttributeError):
            noise.octaves = 3
        # The warp lives as long as the noise, whoever else forgets it.
        lost = scarp.Noise(warp=scarp.Noise(amplitude=5))
        want = lost.grid((9, 9)).value
        junk = [scarp.Noise(amplitude=k + 1) for k in range(100)]
        equal(lost.grid((9, 9)).value, want)
        del junk
        deep = scarp.Noise()
        for _ in range(4):
            deep = scarp.Noise(warp=deep)
        self.named("warp.warp.warp.warp.warp", lambda: scarp.Noise(warp=deep))


class Chain(unittest.TestCase):
    def setUp(self):
        where = dict(derivatives=2, step=0.1)
        self.a = scarp.Noise(seed=1).grid((6, 7), **where)
        self.b = scarp.Noise(seed=2).grid((6, 7), **where)

    def test_operators(self):
        a, b = self.a, self.b
        for got, value, dx in (
                (a + b, a.value + b.value, a.dx + b.dx), (a - b, a.value - b.value, a.dx - b.dx),
                (a * b, a.value * b.value, b.value * a.dx + a.value * b.dx),
                (2 - a, 2 - a.value, -a.dx), (1 + a, 1 + a.value, a.dx), (-a, -a.value, -a.dx),
                (a / 2, a.value / F(2), a.dx / F(2)), (a - 1, a.value - 1, a.dx),
                (abs(a), abs(a.value), np.sign(a.value) * a.dx),
                (3 / (b + 4), 3 / (b.value + 4), -3 * b.dx / (b.value + 4) ** 2),
                (a.clamp(-9, 9), a.value, a.dx), (a.min(b), np.minimum(a.value, b.value), None),
                (a.max(0.1), np.maximum(a.value, F(0.1)), None),
                (a.mix(b, 0.25), a.value + F(0.25) * (b.value - a.value), None),
                (a.sine(), np.sin(2 * np.pi * a.value), None),
                (a.slope(), np.hypot(a.dx, a.dy), None),
                (a.apply(a.value ** 3, 3 * a.value ** 2, 6 * a.value), a.value ** 3,
                 3 * a.value ** 2 * a.dx),
                (a.apply2(b, a.value + b.value, 1, 1), a.value + b.value, a.dx + b.dx)):
            np.testing.assert_allclose(got.value, value, rtol=1e-5, atol=1e-6)
            if dx is not None:
                np.testing.assert_allclose(got.dx, dx, rtol=1e-4, atol=1e-5)
            self.assertEqual(got.extent, a.extent)

    def test_members(self):
        a, b = self.a, self.b
        first = scarp.Noise().grid((6, 7), derivatives=1)
        self.assertEqual((a * b).members, a.members)
        self.assertEqual((a * first).members, ("value", "dx", "dy"))
        self.assertEqual(a.slope().members, ("value", "dx", "dy"))
        self.assertEqual(first.slope().members, ("value",))
        self.assertEqual(a.apply(a.value).members, ("value",))
        self.assertEqual(a.apply(a.value, 1).members, ("value", "dx", "dy"))
        self.assertEqual(a.terrace(4).members, a.members)
        self.assertEqual(a.curve([-1, 0, 1], [0, 0.5, 0]).members, a.members)

    def test_refused(self):
        a = self.a
        for call in (lambda: a + scarp.Noise().grid((7, 6)), lambda: a.clamp(1, 0),
                     lambda: a.smooth_max(self.b, 0), lambda: a * math.inf, lambda: a + 1e39,
                     lambda: a.curve([0, 0], [1, 2]), lambda: a.curve([0], [1]),
                     lambda: a.apply2(self.b, a.value, fa=1), lambda: a.apply(np.zeros(3)),
                     lambda: scarp.Noise().grid((2, 2)).normals(), lambda: a.normals(math.nan),
                     lambda: scarp.Noise().grid((2, 2)).slope(),
                     lambda: scarp.Gullies().grid(scarp.Noise().grid((6, 7))),
                     lambda: scarp.Samples(np.zeros(3), dx=np.zeros(4)),
                     lambda: scarp.Noise().at(1, 2, 3, derivatives=1) *
                     scarp.Noise().at(1, 2, derivatives=1)):
            self.assertRaises(ValueError, call)
        for call in (lambda: a + a.value, lambda: a.value * a, lambda: a * "2",
                     lambda: a.mix(self.b, a.value), lambda: scarp.Samples(np.zeros(3), dw=1)):
            self.assertRaises(TypeError, call)

    def test_own_samples(self):
        x = np.linspace(-1, 1, 11)
        ramp = scarp.Samples(x, dx=np.ones(11), dy=np.zeros(11))
        np.testing.assert_allclose((ramp * ramp).dx, 2 * x, rtol=1e-5, atol=1e-6)
        wide = np.arange(24, dtype=F).reshape(4, 6)
        equal((scarp.Samples(wide[:, ::2]) + 1).value, wide[:, ::2] + 1)
        back = pickle.loads(pickle.dumps(self.a))
        equal(back.dxy, self.a.dxy)

    def test_numbers_of_numpy(self):
        for number in (np.uint8(5), np.int64(5), np.float64(5), np.float16(5)):
            equal((self.a - number).value, (self.a - 5).value)
            self.assertEqual((self.a - number).members, self.a.members)
        self.assertRaises(TypeError, lambda: self.a + np.bool_(True))
        self.assertRaises(TypeError, lambda: self.a - True)


TEXT = """recipe 1
param high = 10 [1, 100]
# größer
a = noise(size=20, octaves=3)
out hill = high * a
out level = clamp(a, 0, 1)
"""


class Recipes(unittest.TestCase):
    def check_changed(self):
        """Tile and scale are those of texts."""
        head, behind = TEXT.split("\n", 1)
        recipe = scarp.Recipe(TEXT, seed=3)
        recipe.scale(2, 3)
        recipe.tile(160, 80)
        text = (head + "\ntile 160, 80\n" + behind).replace("noise(size=20", "noise(size=40")
        want = scarp.Recipe(text.replace("high * a", "3 * (high * a)"), seed=3)
        again = pickle.loads(pickle.dumps(recipe))
        for one in (recipe, again):
            for output in ("hill", "level"):
                equal(one.grid((5, 6), 7.0, output=output).value,
                      want.grid((5, 6), 7.0, output=output).value)
        self.assertEqual(recipe.info(), ((40.0, 10.0), False, "xy", 2))
        self.assertEqual(scarp.Recipe("recipe 1\nspace 3\nout c = z * cell(noise(size=3))").info("c"),
                         scarp.Info((3.0, 3.0), True, "xyz", 2))
        with self.assertRaises(scarp.RecipeError) as caught:
            recipe.tile(161, 80)
        self.assertEqual((caught.exception.line, caught.exception.nearest), (4, 20.125))
        self.assertRaises(scarp.ScarpError, recipe.scale, 0)
        self.assertRaises(TypeError, recipe.scale, "2")
        equal(recipe.grid((5, 6)).value, again.grid((5, 6)).value)

    def test_parameters(self):
        recipe = scarp.Recipe(TEXT, high=20)
        self.assertEqual((recipe.high, recipe.params["high"]), (20.0, (20.0, 1.0, 100.0)))
        one = recipe.grid((5, 6)).value
        recipe.high = 40
        equal(recipe.grid((5, 6)).value, 2 * one)
        seeded = scarp.Recipe(TEXT, seed=2 ** 64 - 1)
        self.assertEqual(seeded.seed, 2 ** 64 - 1)
        for given in (-1, np.int64(-1), -1.0):
            self.assertEqual(scarp.Recipe(TEXT, seed=given).seed, 2 ** 64 - 1)
            self.assertEqual(scarp.Noise(seed=given), scarp.Noise(seed=2 ** 64 - 1))
        self.assertEqual(scarp.Noise(seed=-2 ** 63).seed, 2 ** 63)
        where = {"shape": (4, 5), "step": 0.3}
        base = scarp.Noise(seed=3).grid(**where, derivatives=1)
        self.assertTrue((scarp.Gullies(seed=-7).grid(base, step=0.3)[0].value ==
                         scarp.Gullies(seed=2 ** 64 - 7).grid(base, step=0.3)[0].value).all())
        self.assertRaises(ValueError, scarp.Gullies().range, (1, 0))
        self.assertFalse((seeded.grid((5, 6)).value == one / 2).all())
        recipe.finest = 8
        self.assertFalse((recipe.grid((5, 6)).value == 2 * one).all())
        again = pickle.loads(pickle.dumps(recipe))
        self.assertEqual((again.high, again.finest), (40.0, 8.0))
        equal(again.grid((5, 6)).value, recipe.grid((5, 6)).value)
        named = scarp.Recipe(TEXT.replace("high", "seed"))  # as an argument is
        named.set("seed", 30)
        self.assertEqual(pickle.loads(pickle.dumps(named)).params["seed"].value, 30.0)
        self.check_changed()
        for value in (0.5, 101, math.nan):
            with self.assertRaisesRegex(scarp.ScarpError, r"not in \[1, 100\]") as caught:
                recipe.high = value
            self.assertEqual(caught.exception.member, "high")
        self.assertEqual(recipe.high, 40.0)
        self.assertRaises(AttributeError, lambda: recipe.low)
        self.assertRaises(AttributeError, setattr, recipe, "hihg", 2)
        self.assertRaises(AttributeError, setattr, recipe, "grid", 2)
        self.assertRaises(ValueError, setattr, recipe, "seed", -2 ** 63 - 1)

    def test_errors(self):
        with self.assertRaises(scarp.RecipeError) as caught:
            scarp.Recipe("recipe 1\n# é\nb = noise(size=3)\nout a = nose(size=3)\n")
        error = caught.exception
        self.assertEqual((error.line, error.column), (4, 9))
        self.assertIn("line 4, column 9", str(error))
        with self.assertRaises(scarp.RecipeError) as caught:
            scarp.Recipe("recipe 1\nout a = é + nose(size=3)\n# é\nb = noise(seize=3)\n")
        self.assertEqual([(e.line, e.column) for e in caught.exception.errors], [(2, 9), (4, 17)])
        with self.assertRaises(scarp.RecipeError) as caught:
            scarp.Recipe("recipe 1\nout a = noise(size=3, octaves=99) + noise(size=2, gain=80)\n")
        self.assertEqual([e.member for e in caught.exception.errors], ["octaves", "gain"])
        self.assertEqual(caught.exception.member, "octaves")
        self.assertEqual(len(pickle.loads(pickle.dumps(caught.exception)).errors), 2)
        self.assertRaises(ValueError, scarp.Recipe, "recipe 1\n" + "#" * 17000)
        self.assertRaises(TypeError, scarp.Recipe, b"recipe 1")
        self.assertRaises(ValueError, scarp.preset, "../alps")

    def test_outputs(self):
        recipe = scarp.Recipe(TEXT)
        self.assertEqual(recipe.outputs, ("hill", "level"))
        hill, level, a = recipe.grid((9, 8), derivatives=1, output=("hill", "level", "a"))
        equal(hill.value, recipe.grid((9, 8)).value)
        equal(level.dx, recipe.grid((9, 8), derivatives=1, output="level").dx)
        np.testing.assert_allclose(hill.value, 10 * a.value, rtol=1e-6)
        equal(recipe.at(np.arange(8.0), np.arange(9.0)[:, None]).value, hill.value)
        for bad in ("high", "nothing", ()):
            self.assertRaises(ValueError, recipe.grid, (2, 2), output=bad)
        lowest, highest = recipe.range()
        self.assertTrue(lowest <= hill.value.min() and hill.value.max() <= highest)
        self.assertEqual(recipe.range("level"), (0.0, 1.0))
        self.assertRaises(ValueError, recipe.range, None, ((1, 1), (0, 0)))
        board = np.full((9, 20), 7, F)
        recipe.grid((9, 8), out=board[:, 4:12], threads=2)
        equal(board[:, 4:12], hill.value)
        self.assertEqual((board != 7).sum(), 72)
        x = np.linspace(0, 9, 9, dtype=F)
        self.assertRaises(ValueError, recipe.at, x, x, out=x)  # recipes are not in place

    def test_orders_and_space(self):
        sharp = scarp.Recipe("recipe 1\nout a = noise(swiss, size=9)\n")
        with self.assertRaises(scarp.ScarpError) as caught:
            sharp.grid((3, 3), derivatives=2)
        self.assertEqual(caught.exception.member, "derivatives")
        solid = scarp.Recipe("recipe 1\nspace 3\nout a = noise(size=9, octaves=2)\n")
        self.assertEqual((sharp.dimensions, solid.dimensions), (2, 3))
        self.assertEqual(solid.grid((2, 3, 4), derivatives=2).dzz.shape, (2, 3, 4))
        self.assertRaises(ValueError, solid.grid, (3, 4))
        self.assertRaises(ValueError, sharp.at, 1, 2, 3)

    def test_presets(self):
        names = scarp.presets()
        self.assertIn("alps", names)
        for name in names:
            recipe = scarp.preset(name, seed=3)
            lowest, highest = recipe.range()
            tile = recipe.grid((4, 5), 30.0, output=recipe.outputs)[0].value
            self.assertTrue(lowest <= tile.min() <= tile.max() <= highest, name)

    def test_few_points(self):
        """Single points have the bits of many, of a field that needs more memory than the outputs,
        too."""
        noises = "".join("n%d = noise(size=3, seed=%d)\n" % (i, i) for i in range(1, 30))
        whole = " + ".join("n%d" % i for i in range(1, 30))
        many = " + ".join("n%d * sum" % i for i in range(1, 30))
        recipe = scarp.Recipe("recipe 1\n%ssum = %s\nmany = %s\nout a = x" % (noises, whole, many))
        x = np.arange(20.0)
        for output in ("a", "many"):
            all_ = recipe.at(x, -x, derivatives=2, output=output)
            for i in range(20):
                one = recipe.at(x[i], -x[i], derivatives=2, output=output)
                for name in ("value", "dx", "dyy"):
                    equal(getattr(one, name), getattr(all_, name)[i])

    def test_plan(self):
        """All calls bring the plan that C makes of the recipe as it is then."""
        from scarp import _recipe
        brought = []

        class Watched:
            def __getattr__(self, name):
                function = getattr(lib, name)
                if name not in ("scarp_recipe_sample", "scarp_recipe_sample_f64",
                                "scarp_recipe_grid"):
                    return function

                def call(*arguments):
                    room = _recipe._Scratch.from_address(arguments[-1])
                    brought.append((arguments[0], room.plan))
                    return function(*arguments)
                return call

        def check(recipe):
            del brought[:]
            recipe.grid((20, 30), threads=3)
            recipe.at(1.0, 2.0)
            recipe.at(F(1), F(2))
            self.assertGreater(len(brought), 3)
            for memory, plan in brought:
                size = lib.scarp_recipe_plan_size(memory)
                want = np.empty(size // 8 + 1, np.uint64)
                self.assertEqual(lib.scarp_recipe_plan_make(memory, want.ctypes.data, size), 0)
                self.assertGreater(size, 0)
                self.assertEqual(ctypes.string_at(plan, size), want.tobytes()[:size])

        lib, _recipe.lib = _recipe.lib, Watched()
        try:
            recipe = scarp.Recipe(TEXT, seed=3)
            check(recipe)
            recipe.seed = 4
            check(recipe)
            recipe.finest = 8
            check(recipe)
            recipe.scale(2, 3)
            recipe.tile(160, 80)
            check(recipe)
            check(copy.copy(recipe))
        finally:
            _recipe.lib = lib

    def test_copies(self):
        recipe = scarp.Recipe(TEXT, seed=3, high=20)
        before = recipe.grid((5, 6)).value
        for other in (copy.copy(recipe), copy.deepcopy(recipe)):
            other.high = 40
            equal(other.grid((5, 6)).value, 2 * before)
            equal(recipe.grid((5, 6)).value, before)

    def test_shared(self):
        """Threads share a recipe, for large calls and for single points."""
        recipe, x = scarp.preset("alps", seed=3), np.arange(5000.0) * 7
        want, wrong = recipe.at(x, -x, derivatives=1), []

        def sample(first):
            for i in range(first, first + 50):
                one = recipe.at(x[i:i + 1], -x[i:i + 1], derivatives=1)
                if one.value[0] != want.value[i] or one.dx[0] != want.dx[i]:
                    wrong.append(i)
                if recipe.at(x, -x).value.tobytes() != want.value.tobytes():
                    wrong.append(-1)

        pool = [threading.Thread(target=sample, args=(i,)) for i in range(4)]
        for thread in pool:
            thread.start()
        for thread in pool:
            thread.join()
        self.assertEqual(wrong, [])
        equal(recipe.at(x, -x, threads=4).value, want.value)

    def test_threads(self):
        """A recipe changes while others sample it: every result is one of the two."""
        recipe = scarp.Recipe(TEXT, high=10)
        want, ranges = {recipe.grid((40, 40)).value.tobytes()}, {recipe.range()}
        recipe.high = 20
        want.add(recipe.grid((40, 40)).value.tobytes())
        ranges.add(recipe.range())
        stop, wrong = threading.Event(), []

        def sample():
            while not stop.is_set():
                if recipe.grid((40, 40)).value.tobytes() not in want:
                    wrong.append(1)
                if recipe.range() not in ranges:
                    wrong.append(2)

        pool = [threading.Thread(target=sample) for _ in range(2)]
        for thread in pool:
            thread.start()
        try:
            for i in range(100):
                memory = recipe._memory
                before = bytes(memory)
                recipe.high = (10, 20)[i % 2]
                self.assertEqual(bytes(memory), before)  # calls under way read it
        finally:
            stop.set()
            for thread in pool:
                thread.join()
        self.assertEqual(wrong, [])


class Examples(unittest.TestCase):
    def test_bands(self):
        """The map in bands is the map; other examples need what only they need."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "map.npy")
            subprocess.run([sys.executable, "-B", os.path.join(MODULE, "examples", "bands.py"),
                            path, "300", "2"], check=True, stdout=subprocess.DEVNULL,
                           env={**os.environ, "PYTHONPATH": MODULE})
            equal(np.load(path), scarp.preset("alps", seed=8).grid((300, 300), 10).value)


class Loading(unittest.TestCase):
    def python(self, code, **environment):
        given = {**os.environ, "PYTHONPATH": MODULE, **environment}
        return subprocess.run([sys.executable, "-B", "-c", code], env=given, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def test_missing_library(self):
        done = self.python("import scarp", SCARP_LIBRARY=os.path.join(MODULE, "none.so"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("LibraryError", done.stderr)
        self.assertIn("SCARP_LIBRARY", done.stderr)
        with tempfile.NamedTemporaryFile(suffix=".so") as file:
            file.write(b"no library")
            file.flush()
            self.assertIn("not found", self.python("import scarp", SCARP_LIBRARY=file.name).stderr)

    def test_system_library(self):
        done = self.python("import scarp; print(scarp.VERSION_OF_LIBRARY)", SCARP_LIBRARY="",
                           LD_LIBRARY_PATH=os.path.dirname(LIBRARY))
        self.assertEqual(done.stdout.strip(), scarp.__version__, done.stderr)

    def test_version(self):
        from scarp._library import VERSION, check_version
        major, minor, patch = VERSION
        check_version("%d.%d.%d" % (major, minor, patch + 3), "it")
        for told in ("%d.%d.%d" % (major, minor + 1, patch), "9.9.9", "1", "x.y.z"):
            with self.assertRaisesRegex(scarp.LibraryError, "it is version"):
                check_version(told, "it")

    def test_words(self):
        self.assertEqual(scarp.BASES[:2], ("gradient", "value"))
        self.assertIn(scarp.isa(), scarp.isas())
        try:
            scarp.select_isa("scalar")
            self.assertEqual(scarp.isa(), "scalar")
        finally:
            scarp.select_isa()
        self.assertRaises(ValueError, scarp.select_isa, "sse9")


run()
