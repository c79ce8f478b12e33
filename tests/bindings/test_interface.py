# SPDX-License-Identifier: MIT
"""The description of scarp.h for bindings is current, holds for the compiler, and says no where it
is not.

    test_interface.py SOURCE_DIR SCRATCH_DIR COMPILER...
"""
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

SOURCE, SCRATCH, *COMPILER = sys.argv[1:]
DESCRIBED = os.path.join("src", "bindings", "interface.json")
HEADER = os.path.join("include", "scarp.h")


def run(tree, *arguments):
    return subprocess.run([sys.executable, "-B", os.path.join(
        tree, "src", "bindings", "interface.py"), *arguments], text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def make_writable():
    """Copies of sources that nobody may write are written here, and removed."""
    for folder, _, names in os.walk(SCRATCH):
        for path in [folder] + [os.path.join(folder, name) for name in names]:
            os.chmod(path, os.stat(path).st_mode | 0o200)


class Interface(unittest.TestCase):
    def setUp(self):
        make_writable()
        shutil.rmtree(SCRATCH, ignore_errors=True)
        shutil.copytree(os.path.join(SOURCE, "src", "bindings"),
                        os.path.join(SCRATCH, "src", "bindings"),
                        ignore=shutil.ignore_patterns("__pycache__", "target"))
        shutil.copytree(os.path.join(SOURCE, "src", "web"), os.path.join(SCRATCH, "src", "web"),
                        ignore=shutil.ignore_patterns("playground"))
        shutil.copytree(os.path.join(SOURCE, "tests", "bindings"),
                        os.path.join(SCRATCH, "tests", "bindings"))
        shutil.copytree(os.path.join(SOURCE, "tests", "cpp"), os.path.join(SCRATCH, "tests", "cpp"))
        for name in (HEADER, HEADER + "pp", "src/plan/members.h", "src/cli/shared/members.h"):
            os.makedirs(os.path.dirname(os.path.join(SCRATCH, name)), exist_ok=True)
            shutil.copy(os.path.join(SOURCE, name), os.path.join(SCRATCH, name))
        make_writable()

    def change(self, name, old, new):
        path = os.path.join(SCRATCH, name)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        self.assertIn(old, text)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace(old, new, 1))

    def test_current(self):
        done = run(SOURCE, "--check")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_everything_is_told(self):
        with open(os.path.join(SOURCE, HEADER), encoding="utf-8") as file:
            header = re.sub(r"(?s)/\*.*?\*/", "", file.read())
        with open(os.path.join(SOURCE, DESCRIBED), encoding="utf-8") as file:
            told = json.load(file)
        self.assertEqual(len(re.findall(r"(?m)^SCARP_API ", header)), len(told["functions"]))
        self.assertEqual(set(re.findall(r"(?m)^struct (\w+) \{", header)), set(told["structures"]))
        self.assertEqual(set(re.findall(r"(?m)^enum (\w+) \{", header)), set(told["enums"]))

    def test_compiler(self):
        """The offsets are those of the compiler."""
        text = run(SOURCE, "--asserts").stdout
        self.assertGreater(text.count("_Static_assert"), 200)
        path = os.path.join(SCRATCH, "asserts.c")

        def compile_(text):
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            return subprocess.run([*COMPILER, "-std=c11", "-fsyntax-only", "-I",
                                   os.path.join(SOURCE, "include"), path], text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

        done = compile_(text)
        self.assertEqual(done.returncode, 0, done.stdout)
        wrong = re.sub(r"(offsetof\(struct scarp_noise, phase\)) == PLACE\(52, 52\)",
                       r"\1 == PLACE(56, 56)", text)
        self.assertNotEqual(wrong, text)
        self.assertNotEqual(compile_(wrong).returncode, 0)

    def test_stale(self):
        """A member, an enumerator or a call more is noticed; so is a table that was changed."""
        for name, old, new, complaint in (
                (HEADER, "    float *dphase SCARP_ZERO;", "    float *dtime SCARP_ZERO;",
                 "interface.mjs is not current"),
                (HEADER, "    SCARP_CUBIC ", "    SCARP_LINEAR, SCARP_CUBIC ", "interface.json"),
                (HEADER, "SCARP_API int scarp_isa_supported(",
                 "SCARP_API int scarp_more(void);\nSCARP_API int scarp_isa_supported(",
                 "_interface.py"),
                ("src/web/interface.mjs", "of_octaves: 76", "of_octaves: 72", "interface.mjs"),
                ("src/web/scarp.d.ts", "jitter?: number", "jittre?: number",
                 "scarp.d.ts does not tell of jitter"),
                ("src/bindings/csharp/Scarp.cs", "public float jitter;", "public int jitter;",
                 "Scarp.cs is not current"),
                ("src/bindings/python/scarp/_interface.py", "'phase'", "'fase'",
                 "_interface.py is not current"),
                ("src/cli/shared/members.h", "GAIN_DEFAULT 0.5", "GAIN_DEFAULT 0.6",
                 "members.h is not current"),
                ("src/plan/members.h", "2.0, 0x1p-4", "2.5, 0x1p-4",
                 "scarp.h: the default of noise.lacunarity is 2.5"),
                ("src/plan/members.h", "0x1p-6, 0x1p6", "0x1p-6, 0x1p7",
                 "scarp.h: gullies.cells has another interval"),
                ("src/plan/members.h", '"outside [2^-8, 2^8]"', '"outside [2^-8, 2^9]"',
                 "members.h: narrow.sharpness: outside [2^-8, 2^9]"),
                ("src/plan/members.h", "5.0, 1.0, 8.0", "6.0, 1.0, 8.0",
                 "scarp.h: the default of gullies.octaves is 6"),
                ("src/web/scarp.d.ts", "0.5 by default", "0.6 by default",
                 "scarp.d.ts: gain of noise has another default"),
                ("src/bindings/csharp/Scarp.cs", "in [1/16, 16]. Default 0.5",
                 "in [1/16, 8]. Default 0.5", "Scarp.cs: Gain of noise has another interval"),
                ("src/bindings/rust/src/noise.rs", "in [1/16, 16]. By default 2",
                 "in [1/16, 16]. By default 3", "noise.rs: lacunarity of noise has another"),
                ("src/bindings/rust/src/gullies.rs", "By default 1.75", "By default 1.7",
                 "gullies.rs: slope_low of gullies has another default"),
                ("src/bindings/python/scarp/_noise.py", "Default 0.5", "Default 0.25",
                 "_noise.py: gain of noise has another default"),
                ("src/bindings/python/scarp/_gullies.py", "Default 0.15", "Default 0.2",
                 "_gullies.py: round of gullies has another default")):
            with self.subTest(new):
                self.setUp()
                self.assertEqual(run(SCRATCH, "--check").returncode, 0)
                self.change(name, old, new)
                done = run(SCRATCH, "--check")
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(complaint, done.stderr)

    def test_one_more_member(self):
        """A new member of a noise is in every table once the script has run. What is left are the
        documents, which the script names."""
        self.change(HEADER, "    float phase SCARP_ZERO;",
                    "    float phase SCARP_ZERO;\n\n    /* more. Default 7. */\n"
                    "    float other_one SCARP_ZERO;")
        self.assertEqual(run(SCRATCH).returncode, 0)
        with open(os.path.join(SCRATCH, DESCRIBED), encoding="utf-8") as file:
            members = json.load(file)["structures"]["scarp_noise"]["members"]
        self.assertIn({"name": "other_one", "type": "float", "offset": 56, "default": 7.0}, members)
        for table, line in (("src/web/interface.mjs", "other_one: 56"),
                            ("src/web/interface.mjs", "other_one: 'float'"),
                            ("src/bindings/csharp/Scarp.cs", "public float other_one;"),
                            ("src/bindings/python/scarp/_interface.py", "'other_one': 7.0"),
                            ("src/bindings/rust/src/ffi.rs", "pub const other_one: f32 = 7.0;"),
                            ("src/bindings/rust/src/ffi.rs", "pub other_one: f32,")):
            with open(os.path.join(SCRATCH, table), encoding="utf-8") as file:
                self.assertIn(line, file.read())
        done = run(SCRATCH, "--check")
        self.assertEqual(done.stderr.splitlines(), [
            "src/web/scarp.d.ts does not tell of otherOne",
            "src/bindings/python/scarp/__init__.pyi does not tell of other_one",
            "src/bindings/python/scarp/_noise.py does not tell of other_one",
            "src/bindings/csharp/Scarp.cs does not tell of other_one",
            "src/bindings/rust/src/noise.rs does not tell of other_one"])

    def test_one_more_function(self):
        """A new function of the chain rule is in every binding and in the tests of each, with its
        comment, once the script has run."""
        declared = "SCARP_API enum scarp_status scarp_sqrt("
        new = ("/*\n * scarp_soft_cut - `a` where it is below `b`,\n * else `lo`\n *\n * More.\n */\n"
               "SCARP_API enum scarp_status scarp_soft_cut(size_t count, const struct scarp_samples *a,"
               " const struct scarp_samples *b, float lo, const struct scarp_samples *out);\n\n")
        self.change(HEADER, declared, new + declared)
        self.assertEqual(run(SCRATCH).returncode, 0)
        done = run(SCRATCH, "--check")
        self.assertEqual(done.returncode, 0, done.stderr)
        for path, line in (
                ("src/bindings/python/scarp/_chain.py", "def soft_cut(self, other, lo):\n"
                 '        """`self` where it is below `other`, else `lo`."""'),
                ("src/bindings/python/scarp/__init__.pyi",
                 "def soft_cut(self, other: Operand, lo: float) -> Samples: ..."),
                ("src/bindings/csharp/Scarp.cs", "/// <summary><c>a</c> where it is below <c>b</c>, "
                 "else <c>lo</c>.</summary>\n        public static void SoftCut("
                 "int count, in Samples a, in Samples b, float lo, in Samples to)"),
                ("src/bindings/rust/src/chain.rs", "/// `a` where it is below `b`, else `lo`.\n"
                 "    soft_cut(b; lo), scarp_soft_cut;"),
                ("src/web/scarp.mjs", "softCut(a, b, lo, out) {"),
                ("src/web/scarp.d.ts", "softCut<T extends Samples>(a: Samples, b: Samples, "
                 "lo: number, out: T): T;"),
                ("tests/bindings/chain.h", "scarp_soft_cut(count, a, b, 0.3f, out)"),
                ("tests/bindings/csharp/Chain.cs", "Samples.SoftCut(n, a, b, 0.3f, to)"),
                ("src/bindings/rust/tests/functions/mod.rs", "chain::soft_cut(a, b, 0.3, out)"),
                ("src/web/test/chain.mjs", "softCut: [['a', 'b'], [0.3]]")):
            with open(os.path.join(SCRATCH, path), encoding="utf-8") as file:
                self.assertIn(line, file.read())
        self.change(HEADER, "float lo, const struct scarp_samples *out", "float lo, int which, "
                    "const struct scarp_samples *out")
        self.assertIn("scarp_soft_cut is no function of samples", run(SCRATCH, "--check").stderr)


unittest.main(argv=sys.argv[:1])
