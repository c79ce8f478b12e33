# SPDX-License-Identifier: MIT
"""The samples in the documents compile without a warning and print what stands there; the animation
is a loop.

    test_readme.py LANGUAGE SOURCE_DIR LIBRARY INCLUDE_DIR SCRATCH_DIR COMPILER_ID FLAGS COMPILER
                   [EMULATOR...]

LANGUAGE is c, cxx, python or sh. LIBRARY is the shared or static library; the Python sample needs
a shared one and no emulator. COMPILER compiles the language; for python it is an interpreter with
NumPy, for sh the shell, and LIBRARY the program.
"""
import os
import re
import shlex
import subprocess
import sys

SKIPPED = 77
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
# The documents that have samples, and how many they have of each kind, at least: a document whose
# samples are not found must not pass.
DOCUMENTS = {
    "README.md": {"program": 2, "fragment": 1, "python": 1},
    "src/bindings/README.md": {"program in C++": 1},
    "src/examples/published.md": {"program": 1},
    "src/examples/README.md": {"program": 4, "fragment": 2},
    "src/cli/README.md": {"animation": 1},
    "src/gpu/README.md": {"fragment": 2},
    "src/recipe/README.md": {"program": 1},
    "src/bindings/python/README.md": {"python": 2},
}
FRAGMENT = """#include <scarp.h>
#include <string.h>
extern struct scarp_recipe recipe;
extern const char *wgsl;
struct scarp_recipe recipe;
const char *wgsl = "";
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


class Document:
    """The samples of one document."""

    def __init__(self, name, source):
        self.name = name
        with open(os.path.join(source, name), encoding="utf-8") as file:
            self.blocks = blocks(file.read())

    def programs(self, language):
        """The whole programs, each with the block that follows: what it prints."""
        following = self.blocks[1:] + [("", "")]
        return [(body, printed) for (kind, body), (_, printed) in zip(self.blocks, following)
                if kind == language and (language == "python" or "main(" in body)]

    def pieces(self, language):
        """What is no whole program."""
        return [body for kind, body in self.blocks if kind == language and "main(" not in body]

    def enough(self, kind, samples):
        """The samples, of which there must be as many as DOCUMENTS says."""
        if len(samples) < DOCUMENTS[self.name].get(kind, 0):
            sys.exit("%s has %d samples of the kind %s, not %d" % (
                self.name, len(samples), kind, DOCUMENTS[self.name][kind]))
        return samples


class Examples:
    def __init__(self, source, library, include, scratch, compiler, emulator):
        self.source, self.documents = source, [Document(name, source) for name in DOCUMENTS]
        self.library, self.folder, self.include = library, os.path.dirname(library), include
        self.scratch, self.compiler, self.emulator = scratch, compiler, emulator
        self.count = 0
        os.makedirs(scratch, exist_ok=True)

    def samples(self, kind, of):
        """All samples of a kind, each with the name of a file."""
        for document in self.documents:
            for number, sample in enumerate(document.enough(kind, of(document))):
                stem = re.sub(r"\W+", "-", "%s-%s%d" % (document.name, kind, number))
                self.count += 1
                yield stem, sample

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
            sys.exit("%s prints\n%sbut the document says\n%s" % (name, output, printed))

    def check_all_c(self, *options):
        """Whole programs, and pieces inside a function with a noise and outputs."""
        for stem, (text, printed) in self.samples("program", lambda d: d.programs("c")):
            self.check_program(stem + ".c", text, printed, *options)
        for stem, piece in self.samples("fragment", lambda d: d.pieces("c")):
            self.compile(stem + ".c", FRAGMENT % piece, *options)

    def check_c(self):
        self.check_all_c("-std=c11")

    def check_cxx(self):
        """The samples in C are valid in C++20, too: their designators are in order."""
        cxx = ("-std=c++20",)
        self.check_all_c(*cxx, "-x", "c++")
        for stem, (text, printed) in self.samples("program in C++", lambda d: d.programs("cpp")):
            self.check_program(stem + ".cpp", text, printed, *cxx)

    def check_python(self):
        if ".so" not in os.path.basename(self.library) or self.emulator:
            skip("Python needs the shared library of its own processor")
        environment = dict(os.environ, SCARP_LIBRARY=self.library, PYTHONDONTWRITEBYTECODE="1",
                           PYTHONPATH=os.path.join(self.source, "src", "bindings", "python"))
        for stem, (code, told) in self.samples("python", lambda d: d.programs("python")):
            printed = subprocess.run([self.compiler, "-c", code], check=True, text=True,
                                     env=environment, stdout=subprocess.PIPE).stdout
            if printed != told:
                sys.exit("%s prints\n%sbut the document says\n%s" % (stem, printed, told))

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
        recipe = "".join(body for _, body in self.samples("animation", lambda d: [
            body for kind, body in d.blocks if kind == "sh" and "--phase" in body]))
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
    language, source, library, include, scratch, kind, flags, compiler, *emulator = sys.argv[1:]
    if language != "sh" and (not re.search("GNU|Clang", kind) or os.name != "posix"):
        skip("no flags known for " + kind)
    if language != "sh" and "-fsanitize" in flags:
        skip("the examples are not sanitized")
    examples = Examples(source, library, include, scratch, compiler, emulator)
    getattr(examples, "check_" + language)()
    print("%d samples do what the documents say" % examples.count)


if __name__ == "__main__":
    main()
