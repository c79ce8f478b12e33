# SPDX-License-Identifier: MIT
"""The README's examples compile without a warning and print what the README says; its animation is
a loop.

    test_readme.py LANGUAGE README.md LIBRARY INCLUDE_DIR SCRATCH_DIR COMPILER_ID FLAGS COMPILER
                   [EMULATOR...]

LANGUAGE is c, cxx, python or sh. LIBRARY is the shared or static library; the Python example needs
a shared one and no emulator. For sh it is the program, and COMPILER the shell.
"""
import os
import re
import shlex
import subprocess
import sys

SKIPPED = 77
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
# In C++, -Wextra reports members that designated initialisers leave out, which is their purpose.
DESIGNATED = "-Wno-missing-field-initializers"
# What uses the functions that the README wraps the library in.
WRAPPED = """
#include <cstdio>
#include <vector>
int main()
{
    const std::vector<float> x{1, 2}, y{3, 4};
    std::vector<float> value(2);
    try {
        sample(scarp_noise{.basis = static_cast<scarp_basis>(99)}, x, y, value);
    } catch (const std::runtime_error &) {
        sample(scarp_noise{}, x, y, value);
        std::printf("%.1f\\n", value[0] * 0.0f);
    }
    return 0;
}
"""
FRAGMENT = """#include <scarp.h>
void fragment(struct scarp_noise noise, struct scarp_samples out);
void fragment(struct scarp_noise noise, struct scarp_samples out)
{
    (void)noise, (void)out;
%s}
int main(void)
{
    return 0;
}
"""


def blocks(text):
    """The fenced blocks of a Markdown text as (language, body)."""
    return re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def skip(reason):
    print("skipped:", reason)
    sys.exit(SKIPPED)


class Examples:
    def __init__(self, readme, library, include, scratch, compiler, emulator):
        with open(readme, encoding="utf-8") as file:
            self.blocks = blocks(file.read())
        self.library, self.folder, self.include = library, os.path.dirname(library), include
        self.scratch, self.compiler, self.emulator = scratch, compiler, emulator
        os.makedirs(scratch, exist_ok=True)

    def first(self, language):
        """The first block of the language, and the block that follows: what it prints."""
        return self.programs(language, "")[0]

    def programs(self, language, entry="main("):
        """The blocks of the language that have an entry, each with the block that follows."""
        following = self.blocks[1:] + [("", "")]
        return [(body, printed) for (kind, body), (_, printed) in zip(self.blocks, following)
                if kind == language and entry in body]

    def compile(self, name, text, *options):
        path = os.path.join(self.scratch, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        subprocess.run([self.compiler, *WARNINGS, "-I", self.include, *options, path, "-x", "none",
                        self.library, "-lm", "-Wl,-rpath," + self.folder, "-o", path + ".out"],
                       check=True)
        return path + ".out"

    def check_program(self, name, text, printed, *options):
        program = self.compile(name, text, *options)
        output = subprocess.run(self.emulator + [program], check=True, text=True,
                                stdout=subprocess.PIPE).stdout
        if output != printed:
            sys.exit("%s prints\n%sbut the README says\n%s" % (name, output, printed))

    def check_fragments(self, *options):
        """What is no whole program, inside a function with a noise and outputs."""
        fragments = [body for kind, body in self.blocks if kind == "c" and "main(" not in body]
        if not fragments:
            sys.exit("the README has no fragments in C")
        for number, body in enumerate(fragments):
            self.compile("fragment%d.c" % number, FRAGMENT % body, *options)

    def check_programs(self, language, suffix, *options):
        programs = self.programs(language)
        for number, (text, printed) in enumerate(programs):
            self.check_program("program%d.%s" % (number, suffix), text, printed, *options)
        return len(programs)

    def check_c(self):
        if self.check_programs("c", "c", "-std=c11") < 6:
            sys.exit("the README has fewer programs than one and five recipes")
        self.check_fragments("-std=c11")

    def check_cxx(self):
        """The examples in C are valid in C++20, too: their designators are in order."""
        self.check_programs("cpp", "cpp", "-std=c++20")
        as_cxx = ("-std=c++20", DESIGNATED, "-x", "c++")
        self.check_programs("c", "c", *as_cxx)
        for number, (kind, body) in enumerate(self.blocks):
            if kind == "cpp" and "main(" not in body:
                self.check_program("wrapper%d.cpp" % number, body + WRAPPED, "0.0\n",
                                   "-std=c++20", DESIGNATED)
        self.check_fragments(*as_cxx)

    def check_python(self):
        if ".so" not in os.path.basename(self.library) or self.emulator:
            skip("Python needs the shared library of its own processor")
        code, height = self.first("python")[0], float(self.first("c")[1].split()[1].rstrip(","))
        # A structure that is too short has whatever follows it in memory for reserved members.
        code += ("assert ctypes.sizeof(Noise) == 192\n"
                 "assert ctypes.sizeof(Samples) == 16 * ctypes.sizeof(ctypes.c_void_p)\n")
        environment = dict(os.environ, LD_LIBRARY_PATH=self.folder)
        printed = subprocess.run([sys.executable, "-c", code], check=True, text=True,
                                 env=environment, stdout=subprocess.PIPE).stdout
        status, first = re.match(r"(\d+) \[([-+.e\d]+)", printed).groups()
        told = re.search(r"(?m)# (\d+ \[.*\])$", code).group(1)
        if (status != "0" or abs(float(first) - height) > 1e-6 or
                not re.match(re.escape(told).replace(r"\.\.\.", r"\d*(e-?\d+)?"), printed)):
            sys.exit("the Python example prints %sbut the README says\n%s" % (printed, told))

    def run_in_shell(self, recipe):
        """Runs a recipe in the scratch directory, with the program as `scarp`."""
        program = os.path.join(self.scratch, "scarp")
        with open(program, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\nexec %s \"$@\"\n" % shlex.join(self.emulator + [self.library]))
        os.chmod(program, 0o755)
        path = os.path.abspath(self.scratch) + os.pathsep + os.environ["PATH"]
        return subprocess.run([self.compiler, "-e", "-c", recipe], cwd=self.scratch, check=True,
                              env=dict(os.environ, PATH=path), stdout=subprocess.PIPE).stdout

    def check_sh(self):
        """The animation is a loop: with one frame more, the last has the bytes of the first."""
        recipe = "".join(body for kind, body in self.blocks if kind == "sh" and "--phase" in body)
        frames = "seq 0 23"
        if recipe.count(frames) != 1:
            sys.exit("the recipe has no 24 frames:\n" + recipe)
        recipe = recipe.replace(frames, "seq 0 24")
        end = ".png"
        if not re.search(rb"(?m)^formats .*\bpng\b", self.run_in_shell("scarp info")):
            recipe, end = recipe.replace(".png", ".pgm"), ".pgm"
        for name in os.listdir(self.scratch):
            if name.endswith((".png", ".pgm")):
                os.remove(os.path.join(self.scratch, name))
        self.run_in_shell(recipe)
        for stem in ("height", "hill"):
            found = []
            for i in range(25):
                with open(os.path.join(self.scratch, "%s%d%s" % (stem, i, end)), "rb") as file:
                    found.append(file.read())
            if found[24] != found[0] or len(set(found)) != 24:
                sys.exit("%s: the frames are no loop of 24" % stem)


def main():
    language, readme, library, include, scratch, kind, flags, compiler, *emulator = sys.argv[1:]
    if language != "sh" and (not re.search("GNU|Clang", kind) or os.name != "posix"):
        skip("no flags known for " + kind)
    if language != "sh" and "-fsanitize" in flags:
        skip("the examples are not sanitized")
    examples = Examples(readme, library, include, scratch, compiler, emulator)
    getattr(examples, "check_" + language)()
    print("the examples do what the README says")


if __name__ == "__main__":
    main()
