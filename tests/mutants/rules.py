# SPDX-License-Identifier: MIT
"""Mutations by rule: what do the tests not notice?

    rules.py [--work DIR] [--sample N] [--seed S] [--files PATTERN...] [--sets SET,...] [--no-default]
             [--minutes M]

draws N mutations of all that sites.py finds in the library's sources, or takes all of the files that are
named (src/-relative, as kernel/basis/fade.h or 'recipe/*'). It compiles a copy of the project with all of
them inside, each behind a switch, and runs tests with one after the other switched on:

    1. bits, golden, chain, grid, recipe and other tests of one vector set and of the reference, with few
       points, which stop at the first difference and have 5 seconds each
    2. whatever that does not notice meets the default tests

A test runs only if it comes by the mutation. Those that notice most in least time come first. A mutation
that makes a test endless, or crash, is noticed. One that nothing notices is a *survivor*, and must stand
in explained.txt with the reason why no result is wrong. The exit status is 1 if a survivor does not
stand there.

DIR keeps the copy, the builds, and `results`, a line per mutation, which grows while tests run.
`SCARP_RULE=17 DIR/build/bin/test_bits avx2` tries mutation 17 of the last run.
"""
import argparse
import collections
import fnmatch
import json
import mmap
import os
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import time

import sites

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
ROOMS = ("calls", "plan", "formulas", "scalar", "kernel", "simd", "recipe")
RULES = 1 << 16       # numbers of mutations are less
PATIENCE = 5          # seconds of the processor for a quick test
MEMORY = 8 << 30      # bytes of a test's address space: a mutation may ask for any amount
OTHER_LABELS = "cli|bench|package|readme|cost|farm|mutants|rust|csharp|godot|example" # not of the library
CALL = re.compile(r"scarp_rule_is\s*\(\s*(\d+)\s*\)")

# What runs first. ISA stands for the vector set, GOLDEN and RECIPES for files of tests/.
QUICK = ("test_bits ISA 131 13", "test_golden GOLDEN ISA", "test_golden GOLDEN scalar 5", "test_chain ISA",
         "test_chain scalar", "test_grid ISA 250", "test_recipe_bits ISA 5 RECIPES", "test_recipe",
         "test_plan ISA", "test_gullies ISA", "test_curl ISA", "test_vector ISA", "test_shapes")

Mutation = collections.namedtuple("Mutation", "file line source before after site index")


class Work:
    """The copy of the project and its build, in a directory that is kept."""

    def __init__(self, folder, vector_set):
        self.tree, self.build = os.path.join(folder, "tree"), os.path.join(folder, "build")
        self.folder, self.set = folder, vector_set
        self.sources = {}
        os.makedirs(folder, exist_ok=True)

    def copy(self):
        """Brings the copy up to date. Files that are the same keep their times."""
        for folder, folders, files in os.walk(ROOT):
            folders[:] = [f for f in folders if f[0] != "." and f not in ("target", "node_modules", "__pycache__")
                          and not f.startswith("build") and os.path.join(folder, f) != self.folder]
            to = os.path.join(self.tree, os.path.relpath(folder, ROOT))
            os.makedirs(to, exist_ok=True)
            for name in files:
                original, path = os.path.join(folder, name), os.path.join(to, name)
                relative = os.path.relpath(original, os.path.join(ROOT, "src"))
                if relative.split(os.sep)[0] in ROOMS and name.endswith((".c", ".h")):
                    with open(original, encoding="utf-8") as file:
                        self.sources[relative] = file.read()
                elif not os.path.exists(path) or os.path.getmtime(path) < os.path.getmtime(original):
                    shutil.copy(original, path)
        types = set().union(*map(sites.typedefs_of, self.sources.values()))
        self.parsed = {name: sites.Source(text, types) for name, text in sorted(self.sources.items())}

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
        switch = os.path.join(self.folder, "rule.o")
        subprocess.run(["cc", "-O1", "-fPIC", "-DRULES=%d" % RULES, "-c", os.path.join(HERE, "rule.c"),
                        "-o", switch], check=True)
        flags = "-w -DCHECK_STOPS=1 -include " + shlex.quote(os.path.join(HERE, "rule.h"))
        subprocess.run(["cmake", "-S", self.tree, "-B", self.build, "-DCMAKE_BUILD_TYPE=Release",
                        "-DCMAKE_C_FLAGS_RELEASE=-O1", "-DSCARP_OPTIMIZE=OFF", "-DCMAKE_C_FLAGS=" + flags,
                        "-DCMAKE_EXE_LINKER_FLAGS=" + switch, "-DCMAKE_SHARED_LINKER_FLAGS=" + switch,
                        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DSCARP_SETS=" + self.set,
                        "-DSCARP_BUILD_CLI=OFF", "-DSCARP_BUILD_BENCH=OFF", "-DSCARP_INSTALL=OFF"]
                       + (["-G", "Ninja"] if shutil.which("ninja") else []),
                       check=True, stdout=subprocess.DEVNULL)

    def library_commands(self):
        """How each source of the library is compiled."""
        with open(os.path.join(self.build, "compile_commands.json"), encoding="utf-8") as file:
            for entry in json.load(file):
                if os.path.relpath(entry["file"], os.path.join(self.tree, "src")).split(os.sep)[0] in ROOMS and (
                        "CMakeFiles/scarp.dir" in entry["command"]):
                    yield shlex.split(entry["command"]), entry["directory"]

    def compiled(self):
        """The numbers of the mutations in sources as this build sees them, preprocessed."""
        numbers = set()
        for command, folder in self.library_commands():
            command = command[:command.index("-o")] + ["-E", "-P", command[-1]]
            text = subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL).stdout # also after errors of pasting
            numbers.update(map(int, CALL.findall(text)))
        return numbers

    def make(self, *targets):
        return subprocess.run(["cmake", "--build", self.build, "-j", os.environ.get("JOBS", "1"), "--target",
                               *targets, "--", "-k" + ("0" if shutil.which("ninja") else "")],
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

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
        """The mutations that errors of the compiler are about: the one that begins last before the error,
        or, where none does, all of the line. Inlined functions are named in lines of their own."""
        bad = set()
        lines = log.split("\n")
        for k, text in enumerate(lines):
            places = re.findall(r"(\S+?):(\d+):(\d+): (?:fatal )?error:", text)
            if places: # the error may be in the compiler's header
                before = []
                for up in reversed(lines[max(k - 20, 0):k]):
                    if not re.search(r"inlined from|In function|included from|^ +from ", up):
                        break
                    before += re.findall(r"inlined from .* at (\S+?):(\d+):(\d+)", up)
                for path, line, column in places + before:
                    found = self.numbers_at(path, int(line), int(column), chosen)
                    bad.update(found)
                    if found:
                        break
        return bad

    def numbers_at(self, path, line, column, chosen):
        path = path if os.path.isabs(path) else os.path.join(self.build, path)
        name = os.path.relpath(os.path.normpath(path), os.path.join(self.tree, "src"))
        if name not in self.sources:
            return set()
        with open(os.path.normpath(path), encoding="utf-8") as file:
            text = file.read().split("\n")[line - 1]
        calls = [(m.start() + 1, int(m.group(1))) for m in CALL.finditer(text)]
        before = [number for at, number in calls if at <= column]
        found = before[-1:] or [number for _, number in calls]
        if not found: # an expression that began in a line above
            found = [n for n, m in chosen.items() if m.file == name and m.line in (line, line - 1)]
        return {number for number in found if number in chosen}


class Test:
    def __init__(self, name, command, folder, environment, patience):
        self.name, self.command, self.folder, self.environment = name, command, folder, environment
        self.patience, self.seconds, self.met = patience, 0.0, b""
        self.kills, self.spent = collections.Counter(), collections.Counter() # by room

    def run(self, number, met=None):
        """How it ends with the mutation of that number: "passed", "skipped", "failed", "crashed", "hung"."""
        environment = dict(os.environ, SCARP_RULE=str(number), **self.environment)
        if met:
            environment["SCARP_RULE_MET"] = met
        process = subprocess.Popen(self.command, cwd=self.folder, env=environment, start_new_session=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, preexec_fn=lambda: limit(self.patience))
        try: # others may have the processor, too
            status = process.wait(10 * self.patience)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            return "hung"
        return "passed" if status == 0 else "skipped" if status == 77 else (
            "hung" if status == -signal.SIGXCPU else
            "crashed" if status < 0 or status >= 128 else "failed")

    def try_unchanged(self, met):
        """Runs it without a mutation, and notes which ones it comes by. Says whether it is of use."""
        with open(met, "wb") as file:
            file.truncate(4 * RULES)
        began = time.monotonic()
        ended = self.run(0, met)
        self.seconds = time.monotonic() - began
        with open(met, "rb") as file:
            self.met = file.read()
        return ended == "passed" and any(self.met)

    def meets(self, number):
        return self.met[4 * number] != 0

    def rank(self, room):
        """Kills per second in that room so far; a guess for one that has not run."""
        return (self.kills[room] + 0.5) / (self.spent[room] + self.seconds + 0.1)


def limit(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 30, 1 << 30))


def quick_tests(work):
    words = {"ISA": work.set, "GOLDEN": os.path.join(work.tree, "tests", "golden.txt"),
             "RECIPES": os.path.join(work.tree, "tests", "recipes.txt")}
    for line in QUICK:
        program, *arguments = line.split()
        yield Test(line, [os.path.join(work.build, "bin", program)] + [words.get(a, a) for a in arguments],
                   work.build, {}, PATIENCE)


def default_tests(work):
    """What ctest runs of the library's tests."""
    listed = subprocess.run(["ctest", "--test-dir", work.build, "--show-only=json-v1", "-LE", OTHER_LABELS],
                            check=True, text=True, stdout=subprocess.PIPE).stdout
    for entry in json.loads(listed)["tests"]:
        properties = {p["name"]: p["value"] for p in entry.get("properties", [])}
        environment = dict(e.split("=", 1) for e in properties.get("ENVIRONMENT", []))
        if "command" in entry:
            yield Test(entry["name"], entry["command"], properties.get("WORKING_DIRECTORY", work.build),
                       environment, 120)


def useful(tests, met):
    kept = [test for test in tests if test.try_unchanged(met)]
    for test in kept: # a debugged or crowded machine has the time
        test.patience = min(test.patience, max(PATIENCE, 3 * int(test.seconds)))
    return kept


def first_to_notice(tests, number, room):
    """The first test that does not pass with the mutation, and how it ends; None, None: all pass."""
    for test in sorted((t for t in tests if t.meets(number)), key=lambda t: -t.rank(room)):
        began = time.monotonic()
        ended = test.run(number)
        test.spent[room] += time.monotonic() - began
        if ended != "passed":
            test.kills[room] += 1
            return test.name, ended
    return None, None


def list_mutations(work, patterns):
    """All mutations, in the order of files and lines."""
    found = []
    for name, source in work.parsed.items():
        if not any(fnmatch.fnmatch(name, pattern) for pattern in patterns):
            continue
        lines = source.text.split("\n")
        for k, site in enumerate(source.sites):
            line = source.line_of(site)
            before = " ".join(source.text[site.start:site.end].split())
            found += [Mutation(name, line, lines[line - 1].strip(), before, after, k, m)
                      for m, after in enumerate(site.mutations)]
    return found


def read_explained(path):
    """{(file, line's text, before, after): reason}; see the top of explained.txt."""
    reasons, file_name, entry = {}, None, []
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n") + [""]
    for line in lines:
        if line.startswith("#"):
            continue
        if line and line[0] != " ":
            file_name = line.strip()
        elif line.strip():
            entry.append(line.strip())
        elif entry:
            if len(entry) < 3 or " ==> " not in entry[1] and entry[1] != "*":
                sys.exit("explained.txt: not a line, a mutation and a reason: %s" % entry)
            before, after = ("*", "*") if entry[1] == "*" else entry[1].split(" ==> ", 1)
            reasons[file_name, entry[0], before, after] = " ".join(entry[2:])
            entry = []
    return reasons


def keys_of(m):
    yield m.file, m.source, m.before, m.after
    yield m.file, m.source, "*", "*"


def report_stale(reasons, all_mutations):
    known = {key for m in all_mutations for key in keys_of(m)}
    stale = [key for key in reasons if key not in known]
    for file, line, before, after in stale:
        print("STALE in explained.txt: %s: %s: %s ==> %s" % (file, line, before, after))
    return len(stale)


def judge(chosen, quick, default, results, minutes):
    """Runs tests on all mutations. Yields (number, mutation, stage, test, how it ended)."""
    end = time.monotonic() + 60 * minutes
    for number, m in chosen.items():
        if time.monotonic() > end:
            print("out of time")
            return
        began = time.monotonic()
        room, stage = m.file.split("/")[0], "quick"
        test, ended = first_to_notice(quick, number, room)
        if test is None and default:
            stage = "default"
            test, ended = first_to_notice(default, number, room)
        if test is None:
            met = any(t.meets(number) for t in quick + default)
            stage, ended = "none", "survived" if met else "not met"
        verdict = (number, m, stage, test or "-", ended)
        print("%d %s:%d %s (%s, %s, %.1f s): %s ==> %s" % (number, m.file, m.line, ended, stage, test,
                                                       time.monotonic() - began, m.before, m.after),
              file=results, flush=True)
        yield verdict


def report(verdicts, reasons):
    """Prints what became of the mutations. Returns how many survived without an explanation."""
    tests = collections.Counter((v[2], v[3]) for v in verdicts if v[2] != "none")
    ends = collections.Counter(v[4] for v in verdicts)
    print("\nnoticed by")
    for (stage, test), count in tests.most_common():
        print("  %4d  %s (%s)" % (count, test, stage))
    print("of these, %d crashed and %d hung" % (ends["crashed"], ends["hung"]))
    unexplained = 0
    for number, m, stage, _, ended in verdicts:
        if stage == "none":
            reason = next((reasons[key] for key in keys_of(m) if key in reasons), None)
            unexplained += reason is None
            print("%s %d, %s:\n  src/%s:%d: %s\n    %s ==> %s\n    %s" % (
                "SURVIVOR" if reason is None else "explained", number, ended, m.file, m.line, m.source,
                m.before, m.after, reason or "no explanation"))
    return unexplained


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--work", default="rules-work", help="directory that keeps builds")
    parser.add_argument("--sample", type=int, default=500, help="so many mutations; 0: all")
    parser.add_argument("--seed", type=int, default=1, help="of the sample")
    parser.add_argument("--files", nargs="*", default=["*"], help="patterns of files in src/")
    parser.add_argument("--set", default="avx2", help="the vector set")
    parser.add_argument("--no-default", action="store_true", help="leave the default tests out")
    parser.add_argument("--minutes", type=float, default=1e9, help="stop after that")
    parser.add_argument("--explained", default=os.path.join(HERE, "explained.txt"))
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    began = time.monotonic()
    work = Work(os.path.abspath(arguments.work), arguments.set)
    work.copy()
    everything = list_mutations(work, ["*"])
    mutations = list_mutations(work, arguments.files)
    if not mutations or len(mutations) >= RULES:
        sys.exit("%d mutations in these files" % len(mutations))
    work.write(dict(enumerate(mutations, 1)))
    work.configure()
    compiled = work.compiled()
    draw = [m for number, m in enumerate(mutations, 1) if number in compiled]
    print("%d mutations; %d are compiled for %s and scalar; %d numbers and operators are outside of "
          "functions, or constant" % (len(mutations), len(draw), work.set,
                                      sum(work.parsed[name].left_out for name in {m.file for m in mutations})))
    wanted = min(arguments.sample or len(draw), len(draw))
    random.Random(arguments.seed).shuffle(draw)
    chosen, dropped = work.compile(draw, wanted)
    made = work.make("all")
    if made.returncode != 0:
        sys.exit("tests do not compile:\n" + made.stdout[-4000:])
    print("%d mutations are tried, seed %d; %d others do not compile; %.0f s to here" % (
        len(chosen), arguments.seed, dropped, time.monotonic() - began))
    met = os.path.join(work.folder, "met")
    quick = useful(quick_tests(work), met)
    default = [] if arguments.no_default else useful(default_tests(work), met)
    print("quick tests %.1f s, default tests %.1f s (%d); %.0f s to here" % (
        sum(t.seconds for t in quick), sum(t.seconds for t in default), len(default),
        time.monotonic() - began), flush=True)
    with open(os.path.join(work.folder, "results"), "w", encoding="utf-8") as results:
        verdicts = list(judge(chosen, quick, default, results, arguments.minutes))
    reasons = read_explained(arguments.explained)
    unexplained = report(verdicts, reasons)
    stale = report_stale(reasons, everything)
    survived = sum(v[2] == "none" for v in verdicts)
    print("%d mutations: %d noticed by quick tests, %d by default tests, %d survived, of which %d are not "
          "explained; %d explanations are stale; %.0f s" % (
              len(verdicts), sum(v[2] == "quick" for v in verdicts), sum(v[2] == "default" for v in verdicts),
              survived, unexplained, stale, time.monotonic() - began))
    sys.exit(1 if unexplained or stale else 0)


if __name__ == "__main__":
    main()
