# SPDX-License-Identifier: MIT
"""Scarp.cs, compiled and run by Mono: the layout of structures, the bits of C, what mistakes are
told, the snippets of its page, and Unity's sample with declarations in the place of Unity.

    test_csharp.py SOURCE_DIR MCS MONO LIBRARY HASHES SCRATCH_DIR
    test_csharp.py SOURCE_DIR MCS MONO LIBRARY overhead SCRATCH_DIR

The second one times calls, and tests nothing.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

SOURCE, MCS, MONO, LIBRARY, HASHES, SCRATCH = sys.argv[1:]
BINDING = os.path.join(SOURCE, "src", "bindings", "csharp")
HERE = os.path.join(SOURCE, "tests", "bindings", "csharp")
PROGRAM = os.path.join(SCRATCH, "Tests.exe")
RECIPE = os.path.join(SOURCE, "src", "cli", "presets", "alps.recipe")
SKIPPED = 77


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def run(*command):
    # Mono looks for libscarp.so there.
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env=dict(os.environ, LD_LIBRARY_PATH=os.path.dirname(LIBRARY)))
    if done.returncode:
        raise AssertionError("%s:\n%s" % (" ".join(command), done.stdout))
    return done.stdout


def snippets():
    """The blocks in C# of its page, and what stands in the block behind each."""
    blocks = re.findall(r"^```(\w*)\n(.*?)^```$", read(BINDING, "README.md"), re.M | re.S)
    return [(body, blocks[i + 1][1]) for i, (kind, body) in enumerate(blocks) if kind == "csharp"]


def readme():
    """A class that runs the snippets one after another, with a line between them."""
    usings, bodies = set(), []
    for body, _ in snippets():
        usings.update(re.findall(r"(?m)^using [\w.]+;$", body))
        bodies.append(re.sub(r"(?m)^using [\w.]+;\n", "", body))
    block = '        {\n%s        }\n        System.Console.WriteLine("--");\n'
    return "%s\nstatic class Readme\n{\n    public static void Run()\n    {\n%s    }\n}\n" % (
        "\n".join(sorted(usings)), "".join(block % body for body in bodies))


def compile_all():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    os.makedirs(SCRATCH)
    path = os.path.join(SCRATCH, "Readme.cs")
    with open(path, "w", encoding="utf-8") as file:
        file.write(readme())
    sources = [os.path.join(HERE, name) for name in sorted(os.listdir(HERE))]
    run(MCS, "-unsafe", "-optimize", "-langversion:latest", "-warn:4", "-warnaserror",
        "-out:" + PROGRAM, os.path.join(BINDING, "Scarp.cs"),
        os.path.join(BINDING, "unity", "TerrainSample.cs"),
        os.path.join(SOURCE, "tests", "gpu", "UnityEngine.cs"), path, *sources)


class Layout:
    """The structures of Scarp.cs, laid out by the rule of C# for pointers of some size."""
    SIZES = {"byte": 1, "int": 4, "uint": 4, "float": 4, "long": 8, "ulong": 8, "double": 8}

    def __init__(self, text, pointer):
        self.pointer, self.sizes, self.aligns, self.offsets = pointer, {}, {}, {}
        self.enums = re.findall(r"public enum (\w+)", text)
        for size, name, body in re.findall(
                r"\[StructLayout\(LayoutKind\.Sequential(?:, Size = (\d+))?\)\]\s+"
                r"public unsafe struct (\w+)\s+\{(.*?)\n        \}", text, re.S):
            self.add(name, int(size or 0), body)

    def of(self, kind):
        if kind.endswith("*") or kind == "UIntPtr":
            return self.pointer, self.pointer
        if kind in self.enums:
            return 4, 4
        size = self.SIZES.get(kind) or self.sizes[kind]
        return size, self.aligns.get(kind, size)

    def add(self, name, least, body):
        at, widest, offsets = 0, 1, {}
        for kind, members in re.findall(r"public (?:fixed )?([\w*]+) ([^;]+);", body):
            size, align = self.of(kind)
            for member in members.split(", "):
                member, count = re.fullmatch(r"@?(\w+)(?:\[(\d+)\])?", member).groups()
                at = -(-at // align) * align
                offsets[member] = at
                at, widest = at + size * int(count or 1), max(widest, align)
        self.sizes[name] = max(-(-at // widest) * widest, least)
        self.aligns[name], self.offsets[name] = widest, offsets


class CSharp(unittest.TestCase):
    def setUp(self):
        self.maxDiff = None
        self.described = json.loads(read(SOURCE, "src", "bindings", "interface.json"))

    def expected(self, which):
        """Sizes and offsets: the first of pairs for pointers of 4 bytes, the second for 8."""
        pick = lambda number: number[which] if isinstance(number, list) else number
        return {name: (pick(s["size"]), {m["name"]: pick(m["offset"]) for m in s["members"]})
                for name, s in self.described["structures"].items()}

    def compare(self, which, sizes, offsets):
        """Arrays of pointers are numbered members; spare words at the end may be left out."""
        wanted = self.expected(which)
        self.assertEqual(set(sizes), set(wanted))
        for name, (size, members) in wanted.items():
            self.assertEqual(sizes[name], size, name)
            for member, at in members.items():
                told = offsets[name].get(member, offsets[name].get(member + "0"))
                if told is None and member == "spare" and name in (
                        "scarp_noise", "scarp_grid", "scarp_scratch"):
                    continue
                self.assertEqual(told, at, name + "." + member)

    def test_layout_as_written(self):
        text = read(BINDING, "Scarp.cs")
        for which, pointer in ((0, 4), (1, 8)):
            layout = Layout(text, pointer)
            self.compare(which, layout.sizes, layout.offsets)

    def test_layout_as_run(self):
        sizes, offsets, enums = {}, {}, {}
        for name, member, number in (line.split() for line in run(
                MONO, PROGRAM, "layout").splitlines()):
            if not name.startswith("scarp_"):
                enums.setdefault(name.lower(), {})[member.lower()] = int(number)
            elif member == "=":
                sizes[name] = int(number)
            else:
                offsets.setdefault(name, {})[member] = int(number)
        which = offsets["scarp_samples"]["dx"] // 8
        self.compare(which, sizes, offsets)
        wanted = {name[6:].replace("_", ""): {
            re.sub("^scarp_(error_|isa_|recipe_)?", "", member.lower()).replace("_", ""): number
            for member, number in values.items()}
            for name, values in self.described["enums"].items()}
        self.assertEqual(enums, wanted)

    def test_defaults(self):
        told = dict(line.split() for line in run(MONO, PROGRAM, "defaults").splitlines())
        members = self.described["structures"]["scarp_noise"]["members"]
        wanted = {m["name"].title().replace("_", ""): m.get("default", 0.0) for m in members
                  if m["type"] in ("float", "double")}
        self.assertEqual({name: float(value) for name, value in told.items()}, wanted)

    def test_every_call(self):
        told = re.findall(r"public static extern [\w*]+ (\w+)\(", read(BINDING, "Scarp.cs"))
        self.assertEqual(told, list(self.described["functions"]))

    def test_hashes(self):
        self.assertEqual(run(MONO, PROGRAM, "hashes", RECIPE), run(HASHES, RECIPE))

    def test_wrappers(self):
        self.assertIn("wrappers do", run(MONO, PROGRAM, "wrappers",
                                         os.path.join(SOURCE, "include", "scarp.hlsl")))

    def test_mistakes(self):
        self.assertRegex(run(MONO, PROGRAM, "mistakes"), r"\d\d mistakes are told")

    def test_readme(self):
        self.assertEqual(run(MONO, PROGRAM, "readme"),
                         "".join(printed + "--\n" for _, printed in snippets()))
        self.assertGreaterEqual(len(snippets()), 2)

    def test_terrain(self):
        self.assertIn("heights from", run(MONO, PROGRAM, "terrain"))


if ".so" not in os.path.basename(LIBRARY):
    print("skipped: C# needs the shared library")
    sys.exit(SKIPPED)
compile_all()
if HASHES == "overhead":
    print(run(MONO, PROGRAM, "overhead"), end="")
else:
    unittest.main(argv=sys.argv[:1])
