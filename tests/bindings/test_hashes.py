# SPDX-License-Identifier: MIT
"""The module gives the bits of C: hashes.c makes the same calls.

    test_hashes.py SOURCE_DIR LIBRARY PROGRAM
"""
import json
import os
import subprocess
import unittest

from common import REST, SOURCE, prepare, run

prepare()
import numpy as np  # noqa: E402
import scarp  # noqa: E402
from scarp import _arrays  # noqa: E402

_arrays.BAND = 64  # so that calls in threads have bands: the grids here are small
COUNT, SHAPE = 1031, (37, 53)
RECIPE = os.path.join(SOURCE, "src", "cli", "presets", "alps.recipe")
HESSIAN2 = ("value", "dx", "dy", "dxx", "dxy", "dyy")


def fnv(arrays):
    value = 0xcbf29ce484222325
    for array in arrays:
        for byte in np.ascontiguousarray(array).tobytes():
            value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return "%016x" % value


def members(samples, names):
    return [getattr(samples, name) for name in names]


class Hashes(unittest.TestCase):
    def test_bands(self):
        self.assertEqual(_arrays.bands(37, 53, 2), [(0, 18), (18, 37)])
        self.assertEqual(_arrays.bands(1031, 1, 3), [(0, 343), (343, 687), (687, 1031)])
        self.assertEqual(_arrays.bands(3, 10, 8), [(0, 3)])

    @classmethod
    def setUpClass(cls):
        lines = subprocess.run([*REST, RECIPE], check=True, text=True,
                               stdout=subprocess.PIPE).stdout.splitlines()
        cls.golden = dict(line.split() for line in lines)
        cls.told = set()
        i = np.arange(COUNT)
        cls.d = [(i * (7 + 4 * axis)) % 1024 * 0.375 - 100.0 * axis for axis in range(3)]
        cls.f = [x.astype(np.float32) for x in cls.d]
        cls.warp = scarp.Noise("simplex", seed=7, frequency=0.02, octaves=2, amplitude=15)
        cls.warped = scarp.Noise(fractal="ridged", rotate=True, seed=0xfedcba9876543210,
                                 frequency=0.01, octaves=6, warp=cls.warp)
        cls.flowing = scarp.Noise(seed=5, octaves=3, phase=0.3, offset_first=True)
        cls.where = dict(step=(0.5, -0.25), origin=(-3, 5), first=(-20, 7))

    @classmethod
    def tearDownClass(cls):
        assert cls.told == set(cls.golden), "not compared: %s" % (set(cls.golden) - cls.told)

    def same(self, name, arrays):
        self.assertEqual(fnv(arrays), self.golden[name], name)
        self.told.add(name)

    def test_points(self):
        for name, xy in (("sample2", self.f), ("sample2_f64", self.d)):
            for threads in (1, 3):
                s = self.warped.at(*xy[:2], derivatives=2, threads=threads)
                self.same(name, members(s, HESSIAN2))
        for name, xyz in (("sample3", self.f), ("sample3_f64", self.d)):
            s = self.flowing.at(*xyz, derivatives=2, dphase=True)
            self.same(name, members(s, s.members))
            self.assertEqual(len(s.members), 11)

    def test_others(self):
        u, v = self.warp.vector(*self.f[:2], derivatives=2)
        self.same("vector2", members(u, HESSIAN2) + members(v, HESSIAN2))
        u, v = self.warp.vector(*self.f[:2], derivatives=2, threads=2)
        self.same("vector2", members(u, HESSIAN2) + members(v, HESSIAN2))
        cells = scarp.Noise("cell-f1", seed=9, jitter=0.75).cells(*self.d[:2], derivatives=1,
                                                                  threads=2)
        self.assertEqual(cells.id.dtype, np.uint32)
        self.same("cells2_f64", members(cells, ("f1", "f2", "id", "x", "y", "dx1", "dy1", "dx2",
                                                "dy2")))
        flow = self.flowing.curl(*self.f)
        self.same("curl3", members(flow, ("vx", "vy", "vz")))

    def test_grids(self):
        for threads in (1, 2):
            s = self.warped.grid(SHAPE, derivatives=2, threads=threads, **self.where)
            self.same("grid2", members(s, HESSIAN2))
        tile = scarp.Noise("value", "pingpong", fade="cubic", seed=3, frequency=0.25, octaves=2.5,
                           gain=0.4, sharpness=1.5, period=(8, 16, 4), of_octaves=4)
        for threads in (1, 3):
            s = tile.grid((7, 13, 11), (0.125, 0.25, 0.5), (1, 2, 3), (1, -2, 3), derivatives=1,
                          threads=threads)
            self.same("grid3", members(s, ("value", "dx", "dy", "dz")))

    def test_chain(self):
        base = scarp.Noise(seed=4, frequency=0.02, octaves=2).grid(SHAPE, derivatives=2,
                                                                   **self.where)
        gullies = scarp.Gullies(seed=4, frequency=0.02, depth=0.3, offset_first=True)
        for threads in (1, 3):
            eroded, displacement = gullies.grid(base, derivatives=1, threads=threads, **self.where)
            self.same("gullies_grid2", members(eroded, ("value", "dx", "dy")) +
                      members(displacement, ("value", "dx", "dy")))
        x = -3 + (-20.0 + np.arange(SHAPE[1])) * 0.5
        y = 5 + (7.0 + np.arange(SHAPE[0]))[:, None] * -0.25
        points, _ = gullies.at(base, x, y, derivatives=1, threads=2)
        np.testing.assert_array_equal(points.dx, eroded.dx)
        b = self.warped.grid(SHAPE, derivatives=2, **self.where)
        self.same("chain", members(3 * (base.smooth_max(b, 0.25) * b) - 1, HESSIAN2))
        normals = b.normals(20)
        self.assertEqual(normals.shape, SHAPE + (3,))
        self.same("normals", [normals[..., i] for i in range(3)])

    def test_functions(self):
        """Each function of the chain rule: a method or an operator"""
        operators = {"add": "__add__", "multiply": "__mul__", "divide": "__truediv__",
                     "abs": "__abs__"}
        with open(os.path.join(SOURCE, "src", "bindings", "interface.json"),
                  encoding="utf-8") as file:
            functions = json.load(file)["chain"]
        a = self.warp.at(*self.f[:2], derivatives=2)
        of = {"a": a, "b": self.warped.at(*self.f[:2], derivatives=2), "m": a}
        for name, told in functions.items():
            if name != "slope":
                operands = [of[which] for which in told["inputs"]]
                call = getattr(scarp.Samples, operators.get(name, name))
                self.same(name, members(call(*operands, **told["numbers"]), HESSIAN2))

    def test_recipe(self):
        recipe = scarp.preset("alps", seed=8)
        recipe.height = 900
        names = ("value", "dx", "dy")
        for threads in (1, 2):
            alps, worn = recipe.grid(SHAPE, derivatives=1, output=recipe.outputs, threads=threads,
                                     **self.where)
            self.same("recipe_grid", members(alps, names) + members(worn, names))
        alps, worn = recipe.at(*self.f[:2], derivatives=1, output=["alps", "worn"], threads=2)
        self.same("recipe_sample", members(alps, names) + members(worn, names))


run()
