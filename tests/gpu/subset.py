#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The part of C that becomes shaders: what src/gpu/subset.py refuses, each with its line and why,
and what comes of the rest.

    subset.py DIRECTORY-OF-THE-SCRIPTS WORK-DIRECTORY
"""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import shaders  # noqa: E402
import subset  # noqa: E402

WORK = pathlib.Path(sys.argv[2])
HEAD = "static inline float f(float a, int i, uint u, bool b, vec3 v)\n{\n"

# Statements of that function, and what the refusal of the last line says.
REFUSED = [
    ("return a * i;", "float is wanted, not int"),
    ("return i * a;", "int is wanted, not float"),
    ("return i;", "float is wanted, not int"),
    ("return u == i ? a : 0.0f;", "uint is wanted, not int"),
    ("return i == 1 ? a : 1;", "float is wanted, not int"),
    ("return (float)b;", "do not convert bool to float"),
    ("return (float)a;", "do not convert float to float"),
    ("return a / 2.0f;", "use inverse()"),
    ("return a % 2.0f;", "no % of float"),
    ("return 1.0 * a;", "1.0 is no float"),
    ("return 0x1.8 * a;", "0x1.8 is no float"),
    ("return v + v;", "no + of vec3"),
    ("return -u == 0u ? a : 0.0f;", "no - of uint"),
    ("return b == b ? a : 0.0f;", "no == of bool"),
    ("return !i ? a : 0.0f;", "no ! of int"),
    ("return i & 1 ? a : 0.0f;", "bool is wanted, not int"),
    ("int k = i << i;", "uint is wanted, not int"),
    ("vec3 w = b ? v : v;", "chooses numbers, not vec3"),
    ("return w;", "w is unknown"),
    ("return v.w;", "vec3 has no member w"),
    ("return v[0];", "vec3 has no element"),
    ("return sinf(a);", "sinf() is unknown"),
    ("return f(a, i, u, b, v);", "f() is unknown"),
    ("return magnitude(a, a);", "takes 1 arguments, not 2"),
    ("return magnitude(u);", "float is wanted, not uint"),
    ("float line = a;", "line is a word of a shading language"),
    ("double d = 0.0;", "double is unknown"),
    ("float *p = &a;", "no pointers"),
    ("a += 1.0f;", "neither constants nor parameters"),
    ("const float c = a;\nc = a;", "neither constants nor parameters"),
    ("float c = a;\nc++;", "++ is for whole numbers"),
    ("float c = a;\nc /= a;", "is wanted, not /"),
    ("magnitude(a);", "only variables change"),
    ("if (b)\nreturn a;", "{ is wanted, not return"),
    ("while (b) {", "without while"),
    ("switch (i) {", "without switch"),
    ("for (int k = 0, n = 9; k < n; k++) {", "one variable"),
    ("for (int k = 0; k < 9; k++) {\ncontinue;", "without continue"),
    ("vec3 w = {a, a, a, a};", "too many numbers"),
    ("vec3 w = {.x = a, .x = a};", "twice"),
    ("vec3 w = {.w = a};", "vec3 has no member w"),
    ("vec3 w = {i, a, a};", "float is wanted, not int"),
    ("return {a};", "a name is wanted, not {"),
    ("return a, a;", "; is wanted, not ,"),
    ("return a @ a;", "; is wanted, not @"),
    ("vec3 w = v->x;", "is wanted, not ->"),
    ("const float *const p = 0;", "no pointers"),
]

# Text outside of functions.
REFUSED_FILES = [
    ("#define TWICE(x) ((x) + (x))", "no directive but #define of a number"),
    ("#define HALF 0.5", "no directive but #define of a number"),
    ("#ifdef SOMETHING", "no directive but #define of a number"),
    ("typedef int number;", "static is wanted, not typedef"),
    ("float f(float a)", "static is wanted, not float"),
    ("static inline void f(float a)", "void is no type"),
    ("static inline float f(struct none a)", "struct none is unknown"),
    ("struct pair {\n    float buffer;", "buffer is a word of a shading language"),
    ("struct pair {\n    float a;", "the end of the file"),
]

TAKEN = """\
#define HALF 0x1p-1f

/* Two numbers. */
struct two_numbers {
    float a, b; /* finite */
};

struct box {
    struct two_numbers low, high;
    vec3 middle;
    uint count;
};

static inline float f(struct two_numbers n, uint u, int i, bool b)
{
    /* why */
    float sum = n.a - n.b * HALF - (n.a + 1.0f);
    for (int k = 0; k < 3 && (b || i > k); k++) {
        sum += (float)k * sum; /* beside */
    }
    const uint h = u >> 8 | u << 24 ^ 1;
    if (h == 0) {
        sum = i > 1 ? -(sum * sum) : -sum;
    } else if (b) {
        return (float)(h & 0xff);
    }
    const struct box box = {n, .high.b = sum * sum, .middle = {sum, .z = 0x1.8p1f}};
    return 2 * (i + 1) > 4 ? box.high.b : 0.0f;
}
"""

WGSL = """\
const SCARP_HALF: f32 = 0.5f;

/* Two numbers. */
struct ScarpTwoNumbers {
    a: f32,
    b: f32, /* finite */
}

struct ScarpBox {
    low: ScarpTwoNumbers,
    high: ScarpTwoNumbers,
    middle: vec3f,
    count: u32,
}

fn scarp_f(n: ScarpTwoNumbers, u: u32, i: i32, b: bool) -> f32 {
    /* why */
    var sum: f32 = scarp_sub(scarp_sub(n.a, scarp_mul(n.b, SCARP_HALF)), scarp_add(n.a, 1.0f));
    for (var k: i32 = 0; k < 3 && (b || i > k); k++) {
        sum = scarp_add(sum, scarp_mul(f32(k), sum)); /* beside */
    }
    let h: u32 = (u >> 8u) | ((u << 24u) ^ 1u);
    if (h == 0u) {
        sum = select(-sum, -scarp_mul(sum, sum), i > 1);
    } else if (b) {
        return f32(h & 0xffu);
    }
    let box: ScarpBox = ScarpBox(n, ScarpTwoNumbers(0.0f, scarp_mul(sum, sum)), vec3f(sum, 0.0f,
            3.0f), 0u);
    return select(0.0f, box.high.b, 2 * (i + 1) > 4);
}"""


def read(text):
    """What subset.py makes of a text."""
    path = WORK / "subset.h"
    path.write_text(text)
    known = subset.Known()
    known.functions["magnitude"] = "float", ["float"]
    return subset.Source(path, known).file()


def check_refused(text, why):
    """Whether a text is refused in its last line."""
    line = text.rstrip("\n").count("\n") + 1
    try:
        read(text)
    except subset.Refused as refused:
        said = str(refused)
        if said.startswith(f"{WORK / 'subset.h'}:{line}: ") and why in said:
            return 0
        print(f"{text}\nis refused by\n    {said}\nand not for \"{why}\" in line {line}")
        return 1
    print(f"{text}\nis taken: \"{why}\" was to be said")
    return 1


def check_later():
    """Whether formulas that no shader has yet keep to the part of C."""
    known = shaders.known_at_first()
    try:
        for name in shaders.STRUCTURES + shaders.FUNCTIONS + ["formulas/gullies"]:
            subset.Source(shaders.SRC / (name + ".h"), known).file()
    except subset.Refused as refused:
        print(refused)
        return 1
    return 0


def check_written():
    written = "\n".join(shaders.Wgsl().lines(read(TAKEN)))
    if written != WGSL:
        print(f"This is written:\n{written}\ninstead of:\n{WGSL}")
    return written != WGSL


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    failures = sum(check_refused(HEAD + text, why) for text, why in REFUSED)
    failures += sum(check_refused(text, why) for text, why in REFUSED_FILES)
    failures += check_later() + check_written()
    print(f"{len(REFUSED) + len(REFUSED_FILES)} texts to refuse, 2 to take: {failures} failures")
    return failures != 0


sys.exit(main())
