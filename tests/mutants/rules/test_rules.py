# SPDX-License-Identifier: MIT
"""rules.py finds what it says, and tells what tests notice from what they do not: on single functions, and
on a small library with tests of its own.

    test_rules.py SCRATCH_DIR
"""
import json
import os
import re
import shutil
import subprocess
import sys
import types
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import explained
import sites

SCRATCH = sys.argv.pop() if len(sys.argv) > 1 else ""

EXPRESSIONS = {
    "a + b * c": ["a - b * c", "a + b / c"],
    "a - b - c": ["a - b + c", "a + b - c"],
    "a * (b - c)": ["a / (b - c)", "a * (b + c)"],
    "(float)a * -b": ["(float)a / -b", "(float)a * b"],
    "(struct s *)p": [],
    "f(a, b - g(c)[d])": ["f(a, b + g(c)[d])"],
    "a & b": ["a | b"],
    "f(&a, *b)": [],
    "a < b": ["a >= b", "a <= b"],
    "a >= b && !c": ["a >= b || !c", "a < b && !c", "a > b && !c", "a >= b && c"],
    "a << b | c": ["a << b & c", "a >> b | c"],
    "a ^ b": ["a | b"],
    "a ? b : c": ["a ? c : b"],
    "a ? b : c ? d : e": ["a ? c ? d : e : b", "a ? b : c ? e : d"],
    "s.a->b[i] % c": ["s.a->b[i] * c"],
    "f(0)": ["f(1)"],
    "f(7u)": ["f(8u)", "f(6u)"],
    "f(2.5f)": ["f(2.50025f)", "f(-2.5f)"],
    "f(-2.5f)": ["f(2.5f)", "f(-2.50025f)"],
    "f(0.0)": ["f(0.001)"],
    "f(0x1p3f)": ["f(0x1.00068db8bac71p+3f)", "f(-0x1p3f)"],
    "sizeof *a": [],
    "UINT64_C(1)": [],
}

STATEMENTS = {
    "a += b - c;": ["a -= b - c;", "a += b + c;"],
    "const struct s *const p = q;": [],
    "float f[N - 1];": [],
    "static const float f = a + b;": [],
    "switch (a) { case A + 1: b(); }": [],
    "if (a == b) { c(); }": ["if (a != b) { c(); }"],
    "vf *a, *b = c;": [],
    "return /* - */ a; ": [],
    'f("a - b", \'-\');': [],
}

TOY = """
#define GLUED(x) toy_##x
#define LARGE 1000

int toy_sum(int a, int b)
{
    return a + b;
}

int toy_most(int a, int b)
{
    return a < b ? b : a;
}

int toy_deep(int a)
{
    return a ^ 16;
}

int toy_unused(int a)
{
    return -a;
}

unsigned long long toy_countdown(unsigned long long n)
{
    while (n != 0) {
        n = n - 2;
    }
    return n;
}

int toy_entry(int i)
{
    static const int table[4] = {1, 2, 3, 4};
    return table[i & 3];
}

int toy_1(void)
{
    return GLUED(1) != toy_1;
#if 0
    return 5;
#endif
}
"""

HEADER = """
int toy_sum(int, int), toy_most(int, int), toy_deep(int), toy_entry(int), toy_1(void);
unsigned long long toy_countdown(unsigned long long);
"""

QUICK = """
#include "toy.h"
int main(void)
{
    return toy_sum(2, 1) != 3 || toy_most(1, 2) != 2 || toy_most(2, 1) != 2 || toy_countdown(6) != 0 ||
           toy_entry(1 << 28) != 1 || toy_1();
}
"""

DEFAULT = """
#include "toy.h"
int main(void) { return toy_deep(16); }
"""

CMAKE = """
cmake_minimum_required(VERSION 3.25)
project(toy C)
add_library(scarp SHARED src/plan/toy.c)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
enable_testing()
foreach(test quick default)
  add_executable(toy_${test} ${test}.c)
  target_link_libraries(toy_${test} scarp)
endforeach()
add_test(NAME toy.default COMMAND toy_default)
"""

# What becomes of each mutation: how it ends, and the test that notices it
ENDS = {
    "a + b ==> a - b": ("failed", "toy_quick"),
    "a < b ? b : a ==> a < b ? a : b": ("failed", "toy_quick"),
    "a < b ? b : a ==> a >= b ? b : a": ("failed", "toy_quick"),
    "a < b ? b : a ==> a <= b ? b : a": ("survived", "-"),
    "a ^ 16 ==> a | 16": ("failed", "toy.default"),
    "a ^ 16 ==> a ^ 17": ("failed", "toy.default"),
    "a ^ 16 ==> a ^ 15": ("failed", "toy.default"),
    "-a ==> a": ("not met", "-"),
    "n != 0 ==> n == 0": ("failed", "toy_quick"),
    "n != 0 ==> n != 1": ("hung", "toy_quick"),
    "n - 2 ==> n + 2": ("hung", "toy_quick"),
    "n - 2 ==> n - 3": ("survived", "-"), # 6, 3, 0
    "n - 2 ==> n - 1": ("survived", "-"),
    "i & 3 ==> i | 3": ("crashed", "toy_quick"),
    "i & 3 ==> i & 4": ("survived", "-"), # since the test takes only the first entry
    "i & 3 ==> i & 2": ("survived", "-"),
    "GLUED(1) != toy_1 ==> GLUED(1) == toy_1": ("failed", "toy_quick"),
}

# An explanation for each survivor
EXPLAINED = """
# a comment
plan/toy.c
    return a < b ? b : a;
    a < b ? b : a ==> a <= b ? b : a
    Both are the same where
    they are equal.

    n = n - 2;
    *
    Who counts down in other steps comes to 0, too.

    return table[i & 3];
    i & 3 ==> i & 4
    Known.

    return table[i & 3];
    i & 3 ==> i & 2
    Known.

    function toy_unused
    Nobody calls it.
"""

STALE = """
    return a < c ? b : a;
    a < c ==> a <= c
    The line is no more.
"""


def mutated(text, around):
    """The texts with one mutation each."""
    source = sites.Source(around % text)
    found = []
    for k, site in enumerate(source.sites):
        for m in range(len(site.mutations)):
            changed = source.rewrite({(k, m): 1})
            made = source.text[:site.start] + site.mutations[m] + source.text[site.end:]
            assert changed == (source.text[:site.start] + "(scarp_rule_is(1) ? (" + site.mutations[m] + ") : ("
                               + source.text[site.start:site.end] + "))" + source.text[site.end:])
            found.append(made[len(around.split("%s")[0]):len(made) - len(around.split("%s")[1])])
    return found


class Sites(unittest.TestCase):
    def test_expressions(self):
        for text, expected in EXPRESSIONS.items():
            self.assertEqual(sorted(mutated(text, "int f(void)\n{\n    return %s;\n}\n")), sorted(expected), text)

    def test_statements(self):
        for text, expected in STATEMENTS.items():
            self.assertEqual(sorted(mutated(text, "int f(void)\n{\n    %s\n}\n")), sorted(expected), text)

    def test_outside_of_functions(self):
        source = sites.Source("#define A (1 + 2)\nenum { B = 3 };\nstatic int c[4] = {5};\nint f(int);\n")
        self.assertEqual((source.sites, source.left_out), ([], 3))

    def test_nested(self):
        source = sites.Source("int f(void) { return a + b * 2; }")
        self.assertEqual(source.rewrite({(0, 0): 1, (1, 0): 2, (2, 1): 3}),
                         "int f(void) { return (scarp_rule_is(1) ? (a - b * 2) : (a + (scarp_rule_is(2) ? "
                         "(b / 2) : (b * (scarp_rule_is(3) ? (1) : (2)))))); }")

    def test_lines_stay(self):
        text = "int f(void)\n{\n    return a + /* one\n two */ b\n        - c;\n}\n"
        source = sites.Source(text)
        numbers = {(k, 0): k + 1 for k in range(len(source.sites))}
        self.assertEqual(len(numbers), 2)
        changed = source.rewrite(numbers).split("\n")
        self.assertEqual(len(changed), len(text.split("\n")))
        self.assertIn("- c", changed[4])


class Toy(unittest.TestCase):
    """A library with tests that notice some of its mutations."""

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        cls.project = os.path.join(SCRATCH, "toy")
        os.makedirs(os.path.join(cls.project, "src", "plan"))
        for name, text in (("CMakeLists.txt", CMAKE), ("quick.c", QUICK), ("default.c", DEFAULT),
                           ("toy.h", HEADER), (os.path.join("src", "plan", "toy.c"), TOY)):
            with open(os.path.join(cls.project, name), "w", encoding="utf-8") as file:
                file.write(text)
        cls.first = cls.run_rules("")

    @classmethod
    def run_rules(cls, explained, *arguments):
        path = os.path.join(SCRATCH, "explained.txt")
        with open(path, "w", encoding="utf-8") as file:
            file.write(explained)
        return subprocess.run([sys.executable, "-B", os.path.join(HERE, "rules.py"), "--project", cls.project,
                               "--work", os.path.join(SCRATCH, "work"), "--explained", path, "--patience", "1",
                               "--quick", "toy_quick", "--sample", "0", *arguments],
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def test_what_becomes_of_them(self):
        with open(os.path.join(SCRATCH, "work", "results"), encoding="utf-8") as file:
            lines = [json.loads(line) for line in file]
        self.assertEqual({"%s ==> %s" % (line["mutation"]["before"], line["mutation"]["after"]):
                          (line["ended"], line["test"]) for line in lines}, ENDS)

    def test_survivors_fail(self):
        self.assertEqual(self.first.returncode, 1, self.first.stdout)
        self.assertIn("2 more were drawn and do not compile", self.first.stdout)
        self.assertEqual(self.first.stdout.count("SURVIVOR"), 6)
        self.assertIn("src/plan/toy.c:12: return a < b ? b : a;\n"
                      "    a < b ? b : a ==> a <= b ? b : a\n", self.first.stdout)

    def test_explained(self):
        again = self.run_rules(EXPLAINED, "--again")
        self.assertEqual(again.returncode, 0, again.stdout)
        self.assertIn("6 are tried", again.stdout)
        self.assertIn("17 mutations: 8 noticed by quick tests, 3 by default tests, 6 survived, of which 0 are not",
                      again.stdout)
        self.assertIn("Both are the same where they are equal.", again.stdout)

    def test_stale(self):
        again = self.run_rules(EXPLAINED + STALE, "--again")
        self.assertEqual(again.returncode, 1, again.stdout)
        self.assertIn("STALE", again.stdout)

    def test_unclear(self):
        places = [types.SimpleNamespace(file="a.c", function=name, source="return 0;", before="0", after="1")
                  for name in ("one", "two")]
        for functions, unclear in (("", 1), ("    in one, two\n", 0)):
            path = os.path.join(SCRATCH, "unclear.txt")
            with open(path, "w", encoding="utf-8") as file:
                file.write("a.c\n%s    return 0;\n    0 ==> 1\n    Nobody asks.\n" % functions)
            reasons = explained.read_explained(path)
            self.assertEqual(len(explained.ambiguous(reasons, places)), unclear)
            self.assertEqual([explained.reason_of(m, reasons) for m in places], ["Nobody asks."] * 2)

    def test_resumed(self):
        path = os.path.join(SCRATCH, "work", "results")
        with open(path, encoding="utf-8") as file:
            lines = file.readlines()
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(lines[:9])
        self.run_rules("", "--resume", "--jobs", "2")
        with open(path, encoding="utf-8") as file:
            resumed = file.readlines()
        self.assertEqual(resumed[:9], lines[:9])
        self.assertEqual(*(sorted(re.sub('"number": [0-9]*|"seconds": .*', "", line) for line in found)
                           for found in (resumed, lines)))

    def test_sample(self):
        arguments = ("--sample", "3", "--no-default", "--work", os.path.join(SCRATCH, "sample"))
        one, same, other = (self.run_rules("", *arguments, "--seed", seed).stdout for seed in "112")
        self.assertIn("3 are tried", one)
        self.assertEqual(*(re.sub(r"\d+(\.\d)? s", "", text) for text in (one, same)))
        self.assertNotEqual(*(re.sub(r"\d+(\.\d)? s", "", text) for text in (one, other)))


if __name__ == "__main__":
    unittest.main()
