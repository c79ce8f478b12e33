# SPDX-License-Identifier: MIT
"""The examples compile without a warning as their first lines say, outside of the project.

    test_picture_compile.py SOURCE_DIR LIBRARY SCRATCH_DIR COMPILER_ID FLAGS COMPILER [EMULATOR...]

The compiler may fuse operations here, so bytes may differ a little from those of the tests.
"""
import os
import re
import subprocess
import sys

SKIPPED = 77
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]


def skip(reason):
    print("skipped:", reason)
    sys.exit(SKIPPED)


def main():
    source, library, scratch, kind, flags, compiler, *emulator = sys.argv[1:]
    if not re.search("GNU|Clang", kind) or os.name != "posix":
        skip("no flags known for " + kind)
    if "-fsanitize" in flags:
        skip("the examples are not sanitized here")
    os.makedirs(scratch, exist_ok=True)
    folder = os.path.dirname(library)
    alps = os.path.join(source, "src", "examples", "recipes", "alps.recipe")
    for name, standard, *more in (("cloud", "-std=c11"), ("mountains", "-std=gnu17"),
                                  ("paint", "-std=c11", alps)):
        program = os.path.join(scratch, name)
        subprocess.run([compiler, standard, "-O3", *WARNINGS, "-I", os.path.join(source, "include"),
                        os.path.join(source, "src", "examples", name + ".c"), "-L", folder,
                        "-lscarp", "-lm", "-Wl,-rpath," + folder, "-o", program], check=True)
        drawn = subprocess.run(emulator + [program, "16x9", *more], check=True, stdout=subprocess.PIPE)
        head = b"P6\n16 9\n255\n"
        if not drawn.stdout.startswith(head) or len(drawn.stdout) != len(head) + 3 * 16 * 9:
            sys.exit(name + " draws no picture of 16 x 9 pixels")
    print("the examples compile")


if __name__ == "__main__":
    main()
