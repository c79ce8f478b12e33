# SPDX-License-Identifier: MIT
"""The stubs of types name what the Python module has: classes, methods, their arguments.

    test_stubs.py SOURCE_DIR LIBRARY
"""
import ast
import inspect
import os
import re
import unittest

from common import MODULE, SOURCE, prepare, run

prepare()
import scarp  # noqa: E402
from scarp import _gullies, _interface, _noise, _samples  # noqa: E402


def stub():
    with open(os.path.join(MODULE, "scarp", "__init__.pyi"), encoding="utf-8") as file:
        return ast.parse(file.read())


def arguments_of(function):
    """Names of arguments in a stub, those by name alone behind a *."""
    a = function.args
    return ([x.arg for x in a.args] + (["*"] + [x.arg for x in a.kwonlyargs]
                                       if a.kwonlyargs else []) +
            (["**" + a.kwarg.arg] if a.kwarg else []))


def arguments_here(function):
    found = []
    for p in inspect.signature(function).parameters.values():
        if p.kind == p.KEYWORD_ONLY and "*" not in found:
            found.append("*")
        found.append("**" + p.name if p.kind == p.VAR_KEYWORD else p.name)
    return found


class Stubs(unittest.TestCase):
    def compare(self, node, of, where):
        here = getattr(of, node.name)
        if isinstance(here, property):
            return
        told, there = arguments_of(node), arguments_here(here)
        if of is scarp.Gullies and node.name == "__init__":
            there = there[:-1] + list(_gullies.NUMBERS)
            self.assertEqual(sorted(told), sorted(there))
            return
        if re.match("__r?(add|sub|mul|truediv|neg|pos|abs|[gs]etattr)__$", node.name):
            self.assertEqual(len(told), len(there), where + node.name)
            return
        self.assertEqual(told, there, where + node.name)

    def test_names(self):
        told = set()
        for node in stub().body:
            if isinstance(node, ast.ClassDef):
                told.add(node.name)
                for part in node.body:
                    if isinstance(part, ast.FunctionDef) and not any(
                            getattr(d, "id", "") == "property" for d in part.decorator_list):
                        self.compare(part, getattr(scarp, node.name), node.name + ".")
            elif isinstance(node, ast.FunctionDef):
                told.add(node.name)
                self.compare(node, scarp, "")
            elif isinstance(node, ast.AnnAssign):
                told.add(node.target.id)
        self.assertEqual(told - {"__all__"}, set(scarp.__all__))

    def test_every_method_is_told(self):
        classes = {n.name: {f.name for f in n.body if isinstance(f, ast.FunctionDef)} |
                   {f.target.id for f in n.body if isinstance(f, ast.AnnAssign)}
                   for n in stub().body if isinstance(n, ast.ClassDef)}
        for name in ("Samples", "Noise", "Gullies", "Recipe"):
            public = {m for m in dir(getattr(scarp, name)) if not m.startswith("_")}
            self.assertLessEqual(public, classes[name], name)

    def test_members_of_the_header(self):
        """Every member of the structures that users fill in, or read, has its place here."""
        def of(name):
            return {m for m, _, _ in _interface.STRUCTURES[name][1] if not m.startswith("spare")}

        noise = set(inspect.signature(scarp.Noise).parameters)
        self.assertEqual(noise | {"plan"}, of("scarp_noise"))  # plans are for C alone
        self.assertEqual(set(_gullies.NUMBERS) | {"seed", "rotate", "period", "offset_first"},
                         of("scarp_gullies"))
        self.assertEqual(set(_samples.MEMBERS), of("scarp_samples"))
        self.assertEqual({n for part in _noise.CELLS[3] for n in part}, of("scarp_cells"))
        self.assertEqual({n for part in _noise.FLOW[3] for n in part}, of("scarp_flow"))
        self.assertEqual(len(of("scarp_eroded")), 6)

    def test_docstrings(self):
        for name in scarp.__all__:
            thing = getattr(scarp, name)
            if inspect.isclass(thing) or inspect.isfunction(thing):
                self.assertTrue(inspect.getdoc(thing), name)
            for method, function in inspect.getmembers(thing, inspect.isfunction):
                if not method.startswith("_"):
                    self.assertTrue(inspect.getdoc(function), name + "." + method)

    def test_syntax_of_python_3_9(self):
        for folder, _, names in os.walk(os.path.join(SOURCE, "src", "bindings")):
            for name in names:
                if name.endswith((".py", ".pyi")):
                    with open(os.path.join(folder, name), encoding="utf-8") as file:
                        ast.parse(file.read(), feature_version=(3, 9))


run()
