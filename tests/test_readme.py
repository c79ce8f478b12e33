# SPDX-License-Identifier: MIT
"""The README's programs print what the README says.

    test_readme.py README.md LIBRARY INCLUDE_DIR SCRATCH_DIR COMPILER [EMULATOR...]

LIBRARY is the shared or static library; the Python example needs a shared one and no emulator.
"""
import os
import re
import subprocess
import sys


def blocks(text):
    """The fenced blocks of a Markdown text as (language, body)."""
    return re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def main():
    readme, library, include, scratch, compiler, *emulator = sys.argv[1:]
    with open(readme, encoding="utf-8") as file:
        fenced = blocks(file.read())
    c_at = next(i for i, (language, _) in enumerate(fenced) if language == "c")
    expected = fenced[c_at + 1][1]
    python = next(body for language, body in fenced if language == "python")

    os.makedirs(scratch, exist_ok=True)
    source, program = os.path.join(scratch, "hello.c"), os.path.join(scratch, "hello")
    with open(source, "w", encoding="utf-8") as file:
        file.write(fenced[c_at][1])
    folder = os.path.dirname(library)
    subprocess.run([compiler, "-std=c11", "-Wall", "-Wextra", "-Werror", "-I", include, source,
                    library, "-lm", "-Wl,-rpath," + folder, "-o", program], check=True)
    printed = subprocess.run(emulator + [program], check=True, text=True,
                             stdout=subprocess.PIPE).stdout
    if printed != expected:
        sys.exit("the C example prints\n" + printed + "but the README says\n" + expected)

    if ".so" in os.path.basename(library) and not emulator:
        environment = dict(os.environ, LD_LIBRARY_PATH=folder)
        printed = subprocess.run([sys.executable, "-c", python], check=True, text=True,
                                 env=environment, stdout=subprocess.PIPE).stdout
        status, first = re.match(r"(\d+) \[([-+.e\d]+)", printed).groups()
        if status != "0" or abs(float(first) - float(expected.split()[1].rstrip(","))) > 1e-6:
            sys.exit("the Python example prints " + printed)
    print("the examples print what the README says")


if __name__ == "__main__":
    main()
