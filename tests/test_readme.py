# SPDX-License-Identifier: MIT
"""The samples in the documents compile without a warning, print what is shown there, and make the
pictures that are there; the animation is a loop.

    test_readme.py LANGUAGE SOURCE_DIR LIBRARY INCLUDE_DIR SCRATCH_DIR COMPILER_ID FLAGS COMPILER
                   [EMULATOR...]

LANGUAGE is c, cxx, python or sh. LIBRARY is the shared or static library; the Python sample needs
a shared one and no emulator. COMPILER compiles the language; for python it is an interpreter with
NumPy, for sh the shell, and LIBRARY the program. With SCARP_RENEW=1 in the environment, pictures
and what samples print are written anew.
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "cli"))
from pngs import encode_png
from rasters import read_bytes, read_picture

SKIPPED = 77
OPTIONS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror", "-ffp-contract=off"]
# The documents that have samples, and how many they have of each kind, at least: a document whose
# samples are not found must not pass.
DOCUMENTS = {
    "README.md": {"program": 2, "fragment": 1, "python": 1},
    "src/bindings/README.md": {"program in C++": 1},
    "src/examples/published.md": {"program": 1},
    "src/examples/README.md": {"program": 14, "python": 2, "session": 3},
    "src/cli/README.md": {"animation": 1},
    "src/gpu/README.md": {"fragment": 2},
    "src/recipe/README.md": {"program": 1},
    "src/bindings/python/README.md": {"python": 2},
}
# The document whose samples are short, and make pictures: the longest, in lines; who makes which
# picture, and the largest file
COOKBOOK = "src/examples/README.md"
LONGEST = 25
PICTURES = {"c": ("particles",), "python": ("biomes", "scatter"), "sh": ("paving",)}
LARGEST_FILE = 60000
FRAGMENT = """#include <scarp.h>
#include <stdlib.h>
#include <string.h>
extern struct scarp_recipe recipe;
extern const char *wgsl;
void fragment(struct scarp_noise noise, struct scarp_samples out);
void fragment(struct scarp_noise noise, struct scarp_samples out)
{
    (void)noise, (void)out;
%s}
"""
# Runs samples, a list on stdin, and says what each prints.
INTERPRETER = """
import contextlib, io, json, sys
printed = []
for code in json.load(sys.stdin):
    with contextlib.redirect_stdout(io.StringIO()) as stream:
        exec(code, {"__name__": "__main__"})
    printed.append(stream.getvalue())
json.dump(printed, sys.stdout)
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

    def printing(self, language):
        """The blocks of a language, each with what it prints: the block that follows, if that is of
        none."""
        following = self.blocks[1:] + [("", "")]
        return [(body, printed * (after == "")) for (kind, body), (after, printed)
                in zip(self.blocks, following) if kind == language]

    def programs(self, language):
        """The whole programs, each with what it prints"""
        return [(body, printed) for body, printed in self.printing(language)
                if language == "python" or "main(" in body]

    def sessions(self):
        """What a reader types who has the program, with what it prints"""
        return [(body, printed) for body, printed in self.printing("sh")
                if self.name == COOKBOOK and re.search(r"(?m)^ *scarp ", body)]

    def pieces(self, language):
        """What is no whole program."""
        return [body for kind, body in self.blocks if kind == language and "main(" not in body]

    def enough(self, kind, samples):
        """The samples, of which there must be as many as DOCUMENTS says."""
        if len(samples) < DOCUMENTS[self.name].get(kind, 0):
            sys.exit("%s has %d samples of the kind %s, not %d" % (
                self.name, len(samples), kind, DOCUMENTS[self.name][kind]))
        if self.name == COOKBOOK:
            for sample in samples:
                text = sample if isinstance(sample, str) else sample[0]
                if text.count("\n") > LONGEST:
                    sys.exit("%d lines are too long:\n%s" % (text.count("\n"), text))
        return samples


class Examples:
    def __init__(self, source, library, include, scratch, compiler, emulator):
        self.documents = [Document(name, source) for name in DOCUMENTS]
        self.source, self.library, self.include, self.scratch = (
            os.path.abspath(path) for path in (source, library, include, scratch))
        self.folder = os.path.dirname(self.library)
        self.compiler, self.emulator = compiler, emulator
        self.count = 0
        shutil.rmtree(scratch, ignore_errors=True)
        os.makedirs(scratch)

    def samples(self, kind, of):
        """All samples of a kind, each with the name of a file."""
        for document in self.documents:
            for number, sample in enumerate(document.enough(kind, of(document))):
                stem = re.sub(r"\W+", "-", "%s-%s%d" % (document.name, kind, number))
                self.count += 1
                yield stem, sample

    def write(self, name, text):
        path = os.path.join(self.scratch, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def compile(self, *arguments):
        subprocess.run([self.compiler, *OPTIONS, "-I", self.include, *arguments], check=True)

    def check_valid(self, paths, *options):
        """They need not run: one run of the compiler looks at all."""
        self.compile("-fsyntax-only", *options, *paths)

    def check_program(self, name, text, printed, *options):
        path = self.write(name, text)
        self.compile(*options, path, "-x", "none", self.library, "-lm", "-pthread",
                     "-Wl,-rpath," + self.folder, "-o", path + ".out")
        output = subprocess.run(self.emulator + [path + ".out"], cwd=self.scratch, check=True,
                                text=True, stdout=subprocess.PIPE).stdout
        self.check_printed(name, output, printed)

    def renew_printed(self, output, printed):
        """Writes the output into the document that has what was printed before."""
        before, after = ("```\n%s```\n" % text for text in (printed, output))
        paths = [os.path.join(self.source, name) for name in DOCUMENTS]
        texts = {path: read_bytes(path).decode() for path in paths}
        path, = [path for path in paths for _ in range(texts[path].count(before))]
        with open(path, "w", encoding="utf-8") as file:
            file.write(texts[path].replace(before, after))

    def check_printed(self, name, output, printed):
        if output != printed and os.environ.get("SCARP_RENEW") == "1":
            self.renew_printed(output, printed)
        elif output != printed:
            sys.exit("%s prints\n%sbut the document says\n%s" % (name, output, printed))

    def check_pictures(self, language):
        """Each has the pixels of the committed one."""
        folder = os.path.join(self.source, os.path.dirname(COOKBOOK), "cookbook")
        names = sorted(name + ".png" for all_of in PICTURES.values() for name in all_of)
        if sorted(os.listdir(folder)) != names:
            sys.exit("%s has %s, not %s" % (folder, sorted(os.listdir(folder)), names))
        for name in PICTURES[language]:
            path = os.path.join(folder, name + ".png")
            made, = [os.path.join(self.scratch, file) for file in os.listdir(self.scratch)
                     if re.fullmatch(name + "[.](png|pgm|ppm)", file)]
            if os.environ.get("SCARP_RENEW") == "1":
                data = read_bytes(made)
                with open(path, "wb") as file:
                    file.write(data if made.endswith(".png") else encode_png(data))
            drawn, shown = read_picture(made), read_picture(path)
            if drawn.shape() != shown.shape() or drawn.rows != shown.rows:
                sys.exit("%s is another picture than %s" % (path, made))
            if os.path.getsize(path) > LARGEST_FILE:
                sys.exit("%s is too large" % path)

    def pieces(self):
        """The files of pieces, each inside a function with a noise and outputs"""
        return [self.write(stem + ".c", FRAGMENT % piece)
                for stem, piece in self.samples("fragment", lambda d: d.pieces("c"))]

    def check_c(self):
        for stem, (text, printed) in self.samples("program", lambda d: d.programs("c")):
            self.check_program(stem + ".c", text, printed, "-std=c11")
        self.check_valid(self.pieces(), "-std=c11")
        self.check_pictures("c")

    def check_cxx(self):
        """The samples in C are valid in C++20, too: their designators are in order."""
        paths = [self.write(stem + ".c", text)
                 for stem, (text, _) in self.samples("program", lambda d: d.programs("c"))]
        self.check_valid(paths + self.pieces(), "-std=c++20", "-x", "c++")
        for stem, (text, printed) in self.samples("program in C++", lambda d: d.programs("cpp")):
            self.check_program(stem + ".cpp", text, printed, "-std=c++20")

    def check_python(self):
        if ".so" not in os.path.basename(self.library) or self.emulator:
            skip("Python needs the shared library of its own processor")
        environment = dict(os.environ, SCARP_LIBRARY=self.library, PYTHONDONTWRITEBYTECODE="1",
                           PYTHONPATH=os.path.join(self.source, "src", "bindings", "python"))
        samples = list(self.samples("python", lambda d: d.programs("python")))
        outputs = json.loads(subprocess.run(
            [self.compiler, "-c", INTERPRETER], cwd=self.scratch, check=True, text=True,
            env=environment, input=json.dumps([code for _, (code, _) in samples]),
            stdout=subprocess.PIPE).stdout)
        for (stem, (_, printed)), output in zip(samples, outputs):
            self.check_printed(stem, output, printed)
        self.check_pictures("python")

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
        self.has_png = re.search(rb"(?m)^formats .*\bpng\b", self.run_in_shell("scarp info"))
        for stem, (typed, printed) in self.samples("session", lambda d: d.sessions()):
            if not self.has_png:
                typed = typed.replace(".png", ".pgm")
            self.check_printed(stem, self.run_in_shell(typed).decode(), printed)
        self.check_pictures("sh")
        self.check_animation()

    def check_animation(self):
        """It is a loop: with one frame more, the last has the bytes of the first."""
        recipe = "".join(body for _, body in self.samples("animation", lambda d: [
            body for kind, body in d.blocks if kind == "sh" and "--phase" in body]))
        frames = "seq 0 23"
        if recipe.count(frames) != 1:
            sys.exit("the recipe has no 24 frames:\n" + recipe)
        recipe = recipe.replace(frames, "seq 0 24")
        end = ".png"
        if not self.has_png:
            recipe, end = recipe.replace(".png", ".pgm"), ".pgm"
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
