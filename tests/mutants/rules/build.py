# SPDX-License-Identifier: MIT
"""Mutations of the library's sources, and a copy of the project in which they are compiled."""
import collections
import fnmatch
import json
import os
import re
import shlex
import shutil
import subprocess
import sys

import sites

HERE = os.path.dirname(os.path.abspath(__file__))
ROOMS = ("calls", "plan", "formulas", "scalar", "kernel", "simd", "recipe") # folders of src/
SHOWN = 70 # characters of an expression around what changes
RULES = 1 << 16 # numbers of mutations are less
CALL = re.compile(r"scarp_rule_is\s*\(\s*(\d+)\s*\)")

# Mutation number `index` of site number `site` of a file: what is `before` becomes `after`, both with some of
# the expression around it. `source` is the text of the line; `twin` counts those before it that look the same.
Mutation = collections.namedtuple("Mutation", "file function line source before after twin site index")


class Work:
    """The copy of the project and its build, in a directory that is kept."""

    def __init__(self, folder, project, vector_set, sanitized, thorough):
        self.folder, self.project, self.set, self.sanitized = folder, project, vector_set, sanitized
        self.is_thorough = "ON" if thorough else "OFF"
        self.tree = os.path.join(folder, "tree")
        self.build = os.path.join(folder, "sanitized" if sanitized else "build")
        self.sources = read_sources(project)
        self.ninja = shutil.which("ninja") is not None
        os.makedirs(folder, exist_ok=True)
        self.copy()
        self.parsed = parse(self.sources)

    def copy(self):
        """Brings the copy up to date, but for the library's sources. Files that are the same keep their
        times."""
        for folder, folders, files in os.walk(self.project):
            folders[:] = [f for f in folders if not re.match(r"[.]|build|(target|node_modules|__pycache__)$", f)
                          and os.path.join(folder, f) != self.folder]
            to = os.path.join(self.tree, os.path.relpath(folder, self.project))
            os.makedirs(to, exist_ok=True)
            for name in files:
                original, path = os.path.join(folder, name), os.path.join(to, name)
                if os.path.relpath(original, os.path.join(self.project, "src")) not in self.sources and (
                        not os.path.exists(path) or os.path.getmtime(path) != os.path.getmtime(original)):
                    shutil.copy2(original, path)

    def left_out(self, mutations):
        """How many numbers and operators of their files sites.py leaves out."""
        return sum(self.parsed[name].left_out for name in {m.file for m in mutations})

    def write(self, mutations):
        """Writes the sources with {number: mutation}."""
        by_file = collections.defaultdict(dict)
        for number, m in mutations.items():
            by_file[m.file][m.site, m.index] = number
        for name, text in self.sources.items():
            path = os.path.join(self.tree, "src", name)
            text = self.parsed[name].rewrite(by_file[name]) if name in by_file else text
            old = None
            if os.path.exists(path):
                with open(path, encoding="utf-8") as file:
                    old = file.read()
            if old != text:
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)

    def configure(self):
        switch = os.path.join(self.build, "rule.o")
        os.makedirs(self.build, exist_ok=True)
        compiler = shlex.split(os.environ.get("CC", "cc")) # CMake's default, too
        subprocess.run([*compiler, "-O1", "-fPIC", "-DRULES=%d" % RULES, "-c",
                        os.path.join(HERE, "rule.c"), "-o", switch], check=True)
        flags = "-w -DCHECK_STOPS=1 -include " + shlex.quote(os.path.join(HERE, "rule.h"))
        if self.sanitized:
            flags += " -fsanitize=address,undefined -fno-sanitize-recover=all"
        options = {"CMAKE_BUILD_TYPE": "Release", "CMAKE_C_FLAGS_RELEASE": "-O1", "CMAKE_C_FLAGS": flags,
                   "CMAKE_EXE_LINKER_FLAGS": switch, "CMAKE_SHARED_LINKER_FLAGS": switch,
                   "CMAKE_EXPORT_COMPILE_COMMANDS": "ON", "SCARP_OPTIMIZE": "OFF", "SCARP_SETS": self.set,
                   "SCARP_TEST_THOROUGH": self.is_thorough, "SCARP_BUILD_CLI": self.is_thorough,
                   "SCARP_BUILD_BENCH": "OFF", "SCARP_INSTALL": "OFF"}
        subprocess.run(["cmake", "--no-warn-unused-cli", "-S", self.tree, "-B", self.build]
                       + ["-D%s=%s" % option for option in options.items()]
                       + (["-G", "Ninja"] if self.ninja else []), check=True, stdout=subprocess.DEVNULL)

    def library_commands(self):
        """How each source of the library is compiled, and where."""
        with open(os.path.join(self.build, "compile_commands.json"), encoding="utf-8") as file:
            for entry in json.load(file):
                name = os.path.relpath(entry["file"], os.path.join(self.tree, "src"))
                if name.split(os.sep)[0] in ROOMS and "CMakeFiles/scarp.dir" in entry["command"]:
                    yield shlex.split(entry["command"]), entry["directory"]

    def compiled(self, mutations):
        """Those of the mutations that are in the library's sources once these are preprocessed."""
        self.write(dict(enumerate(mutations, 1)))
        self.configure()
        numbers = set()
        for command, folder in self.library_commands():
            command = command[:command.index("-o")] + ["-E", "-P", command[-1]]
            text = subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL).stdout # whole also after an error
            numbers.update(map(int, CALL.findall(text)))
        return [m for number, m in enumerate(mutations, 1) if number in numbers]

    def make(self, *targets):
        keep_going = ["-k", "0"] if self.ninja else ["-k"]
        return subprocess.run(["cmake", "--build", self.build, "-j", os.environ.get("JOBS", "1"), "--target",
                               *targets, "--", *keep_going],
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def make_tests(self, targets, programs):
        made = self.make(*(targets or map(os.path.basename, programs)))
        missing = [p for p in programs if not os.path.exists(p)]
        if made.returncode != 0 or missing:
            sys.exit("tests do not compile:\n%s\n%s" % (made.stdout[-4000:], " ".join(missing)))

    def compile(self, draw, wanted):
        """Compiles the first `wanted` mutations of `draw` that compile. Returns them, {number: mutation},
        and how many did not."""
        chosen = dict(enumerate(draw[:wanted], 1))
        drawn = len(chosen)
        dropped = 0
        while True:
            self.write(chosen)
            made = self.make("scarp")
            if made.returncode == 0:
                return chosen, dropped
            bad = self.bad_numbers(made.stdout, chosen)
            if not bad:
                sys.exit("the sources do not compile:\n" + made.stdout[-4000:])
            for number in bad:
                del chosen[number]
                dropped += 1
                if drawn < len(draw):
                    drawn += 1
                    chosen[drawn] = draw[drawn - 1]

    def bad_numbers(self, log, chosen):
        """The mutations that errors of the compiler are about. An error may be in a macro or in the
        compiler's header: lines around it name the places that led there."""
        bad = set()
        for message in re.split(r"\n(?=\S+: (?:In function|At top level)|(?:In file included|In function))", log):
            for error in re.split(r"\n(?=\S+?:\d+:\d+: (?:fatal )?error:)", message):
                if " error:" in error:
                    inlined = re.findall(r"inlined from .* at (\S+?):(\d+):(\d+)", message)
                    expanded = re.findall(r"^(\S+?):(\d+):(\d+): note: in expansion of", error, re.MULTILINE)
                    places = re.findall(r"^(\S+?):(\d+):(\d+): (?:fatal )?error:", error, re.MULTILINE)
                    bad.update(next(filter(None, (
                        self.numbers_at(path, int(line), int(column) - 1, (path, line, column) in expanded)
                        for path, line, column in places + expanded + inlined)), ()))
        return bad & set(chosen)

    def numbers_at(self, path, line, column, is_macro):
        """The mutation whose text is there; or those in the arguments of a macro; or those of the
        expression around; or all of the line."""
        path = os.path.normpath(os.path.join(self.build, path))
        name = os.path.relpath(path, os.path.join(self.tree, "src"))
        if name not in self.sources:
            return set()
        with open(path, encoding="utf-8") as file:
            text = file.read().split("\n")[line - 1]
        calls = [(m.start(), text.index("(", m.end()), int(m.group(1))) for m in CALL.finditer(text)]
        if is_macro and "(" in text[column:]:
            first = text.index("(", column)
            inside = {number for at, _, number in calls if first < at < end_of(text, first)}
            if inside:
                return inside
        there = [number for _, first, number in calls if first < column < end_of(text, first)]
        if there:
            return {there[-1]}
        around = [number for at, _, number in calls if at - 1 <= column < end_of(text, at - 1)]
        return {around[-1]} if around else {number for _, _, number in calls}


def end_of(text, first):
    """Where the parenthesis ends that begins at `first`; the end of the text if it is elsewhere."""
    depth = 0
    for at in range(first, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return len(text)


def read_sources(project):
    """The library's sources, by their names below src/"""
    sources, src = {}, os.path.join(project, "src")
    for room in ROOMS:
        for folder, _, files in os.walk(os.path.join(src, room)):
            for name in files:
                if name.endswith((".c", ".h")):
                    path = os.path.join(folder, name)
                    with open(path, encoding="utf-8") as file:
                        sources[os.path.relpath(path, src)] = file.read()
    return sources


def parse(sources):
    types = set().union(*map(sites.typedefs_of, sources.values()))
    return {name: sites.Source(text, types) for name, text in sorted(sources.items())}


def list_mutations(parsed, patterns):
    """All mutations, in the order of files and lines."""
    found = []
    for name, source in parsed.items():
        if any(fnmatch.fnmatch(name, pattern) for pattern in patterns):
            found += mutations_of(name, source)
    return found


def mutations_of(name, source):
    found, around, lines = [], [], source.text.split("\n")
    seen = collections.Counter()
    for k, site in enumerate(source.sites):
        around = [other for other in around if other.end >= site.end]
        shown = next((other for other in reversed(around) if other.end - other.start < SHOWN), site)
        line = source.line_of(site)
        for m, after in enumerate(site.mutations):
            changed = source.text[shown.start:site.start] + after + source.text[site.end:shown.end]
            words = (lines[line - 1].strip(), " ".join(source.text[shown.start:shown.end].split()),
                     " ".join(changed.split()))
            found.append(Mutation(name, site.function, line, *words, seen[words], k, m))
            seen[words] += 1
        around.append(site)
    return found
