# SPDX-License-Identifier: MIT
"""Looks for arithmetic of floats that a compiler of SPIR-V may fuse or evaluate otherwise.

    contraction.py [--must-find] SPIRV-DIS FILE...

Every addition, subtraction and multiplication must be decorated NoContraction, and no instruction
may be there whose order of operations is open (dot products, matrices, fma, mix and the like).
Prints how much there is of everything, and fails if anything is found, or with --must-find if
nothing is found in one of the files.
"""
import os
import re
import subprocess
import sys

PLAIN = {"FAdd", "FSub", "FMul"}
# A sum of products of its own accord, or vectors of products
SUMS = {"Dot", "VectorTimesScalar", "MatrixTimesScalar", "VectorTimesMatrix", "MatrixTimesVector",
        "MatrixTimesMatrix", "OuterProduct", "FMod", "FRem"}
# Of the extended instructions, those that have one exact result, and the square root
EXACT = {"FAbs", "Floor", "FMin", "FMax", "FSign", "FClamp", "NMin", "NMax", "NClamp", "Sqrt"}
WHOLE = {"UMin", "UMax", "UClamp", "SMin", "SMax", "SClamp", "SAbs", "SSign", "FindILsb",
         "FindSMsb", "FindUMsb"}


def disassembled(disassembler, path):
    return subprocess.run([disassembler, "--no-color", path], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def count(found, name):
    found[name] = found.get(name, 0) + 1


def look(disassembler, path):
    """Prints what is in the file and returns what may be fused."""
    text = disassembled(disassembler, path)
    decorated = set(re.findall(r"OpDecorate (%\S+) NoContraction", text))
    all_of, open_to = {}, {}
    for result, name in re.findall(r"(%\S+) = Op(\w+)", text):
        if name in PLAIN or name in SUMS or name in ("FDiv", "FNegate"):
            count(all_of, name)
        if (name in PLAIN and result not in decorated) or name in SUMS:
            count(open_to, name)
    for name in re.findall(r"= OpExtInst %\S+ %\S+ (\w+)", text):
        count(all_of, name)
        if name not in EXACT | WHOLE:
            count(open_to, name)
    listed = ", ".join(f"{n} {name}" for name, n in sorted(all_of.items()))
    bare = ", ".join(f"{n} {name}" for name, n in sorted(open_to.items())) or "none"
    print(f"{os.path.basename(path)}: {os.path.getsize(path)} bytes; {listed}; open to fusing: {bare}")
    return sum(open_to.values())


def main(arguments):
    must_find = arguments[:1] == ["--must-find"]
    disassembler, *paths = arguments[must_find:]
    failed = not paths
    for path in paths:
        failed |= (look(disassembler, path) > 0) != must_find
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
