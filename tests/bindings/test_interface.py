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
COPIED = ("include/scarp.h", "src/web/layout.mjs", "src/bindings/interface.py",
          "src/bindings/interface.json", "src/bindings/python/scarp/_interface.py")


def run(tree, *arguments):
    return subprocess.run([sys.executable, "-B", os.path.join(
        tree, "src", "bindings", "interface.py"), *arguments], text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE)


class Interface(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        for name in COPIED:
            to = os.path.join(SCRATCH, name)
            os.makedirs(os.path.dirname(to), exist_ok=True)
            shutil.copy(os.path.join(SOURCE, name), to)

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
        with open(os.path.join(SOURCE, "include", "scarp.h"), encoding="utf-8") as file:
            header = re.sub(r"(?s)/\*.*?\*/", "", file.read())
        with open(os.path.join(SOURCE, "src/bindings/interface.json"), encoding="utf-8") as file:
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
                       r"\1 == PLACE(52, 56)", text)
        self.assertNotEqual(wrong, text)
        self.assertNotEqual(compile_(wrong).returncode, 0)

    def test_stale(self):
        """A member, an enumerator or a call more is noticed; so is a table that was changed."""
        header = "include/scarp.h"
        for name, old, new, complaint in (
                (header, "    float phase SCARP_ZERO;",
                 "    float extra SCARP_ZERO;\n    float phase SCARP_ZERO;", "a noise is"),
                (header, "    SCARP_CUBIC ", "    SCARP_LINEAR, SCARP_CUBIC ", "interface.json"),
                (header, "SCARP_API int scarp_isa_supported(",
                 "SCARP_API int scarp_more(void);\nSCARP_API int scarp_isa_supported(",
                 "_interface.py"),
                (header, "    float *dphase SCARP_ZERO;", "    float *dtime SCARP_ZERO;", "SAMPLES is"),
                (header, "    size_t slice_stride SCARP_ZERO;",
                 "    size_t other_stride SCARP_ZERO;", "a grid is"),
                ("src/web/layout.mjs", "ofOctaves: 76", "ofOctaves: 72", "a noise is"),
                ("src/web/layout.mjs", "PLAN_SIZE = 12288", "PLAN_SIZE = 12280", "PLAN_SIZE is"),
                ("src/bindings/python/scarp/_interface.py", "'phase'", "'fase'",
                 "_interface.py is not current")):
            with self.subTest(new):
                self.setUp()
                self.assertEqual(run(SCRATCH, "--check").returncode, 0)
                self.change(name, old, new)
                done = run(SCRATCH, "--check")
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(complaint, done.stderr)


unittest.main(argv=sys.argv[:1])
