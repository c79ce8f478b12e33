# SPDX-License-Identifier: MIT
"""Tests that meet mutations: how each ends, and which one notices most in least time."""
import collections
import json
import os
import resource
import signal
import subprocess
import time

from build import RULES

LONGEST = 120    # seconds of the processor that a test takes without a mutation
MEMORY = 8 << 20 # KiB of a test's address space: a mutation may ask for any amount
LIMITS = 'ulimit -c 0; ulimit -S -t %s; ulimit -v %s; exec "$@"'
OTHER_LABELS = "cli|bench|package|readme|cost|farm|mutants|rust|csharp|godot|example" # not of the library

# What runs first. ISA stands for the vector set, GOLDEN and RECIPES for files of tests/,
# INCLUDE for the folder of shaders.
QUICK = ("test_bits ISA 131 13", "test_golden GOLDEN ISA", "test_golden GOLDEN scalar 5", "test_chain ISA",
         "test_chain scalar", "test_grid ISA 250", "test_recipe_bits ISA 5 RECIPES", "test_recipe", "test_recipe_calls", "test_recipe_described",
         "test_plan ISA", "test_gullies ISA", "test_curl ISA", "test_vector ISA", "test_shapes",
         "recipe_mutate 500", "test_gpu_recipe INCLUDE")


class Test:
    def __init__(self, name, command, folder, environment):
        self.name, self.command, self.folder, self.environment = name, command, folder, environment
        self.program = command[0]
        self.patience, self.memory = LONGEST, MEMORY
        self.seconds, self.used, self.met = 0.0, 0.0, b"" # without a mutation
        self.kills, self.spent = collections.Counter(), collections.Counter() # by room

    def run(self, number, met=None):
        """How it ends with the mutation of that number: "passed", "skipped", "failed", "crashed", "hung"."""
        environment = dict(os.environ, SCARP_RULE=str(number), **self.environment)
        environment.pop("SCARP_REQUIRE_ISAS", None) # this build has one set, and no programs
        environment.pop("SCARP_REQUIRE_TOOLS", None)
        if met:
            environment["SCARP_RULE_MET"] = met
        limits = ["sh", "-c", LIMITS % (self.patience, self.memory), "sh"]
        process = subprocess.Popen(limits + self.command, cwd=self.folder, env=environment,
                                   start_new_session=True, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
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
        began, used = time.monotonic(), processor_seconds()
        ended = self.run(0, met)
        self.seconds, self.used = time.monotonic() - began, processor_seconds() - used
        with open(met, "rb") as file:
            self.met = file.read()
        if ended not in ("passed", "skipped"):
            print("left out, since without a mutation it %s: %s" % (ended, self.name))
        return ended == "passed" and any(self.met)

    def meets(self, number):
        return self.met[4 * number] != 0

    def rank(self, room):
        """Kills per second in that room so far; a guess for one that has not run."""
        return (self.kills[room] + 0.5) / (self.spent[room] + self.seconds + 0.1)


def processor_seconds():
    """What children took until now."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def quick_tests(work, lines):
    words = {"ISA": work.set, "GOLDEN": os.path.join(work.tree, "tests", "golden.txt"),
             "RECIPES": os.path.join(work.tree, "tests", "recipes.txt"),
             "INCLUDE": os.path.join(work.tree, "include")}
    for line in lines:
        program, *arguments = line.split()
        yield Test(line, [os.path.join(work.build, "bin", program)] + [words.get(a, a) for a in arguments],
                   work.build, {})


def default_tests(work, names):
    """What ctest runs of the library's tests, or of those with these names."""
    chosen = ["-R", names] if names else ["-LE", OTHER_LABELS]
    listed = subprocess.run(["ctest", "--test-dir", work.build, "--show-only=json-v1", *chosen],
                            check=True, text=True, stdout=subprocess.PIPE).stdout
    for entry in json.loads(listed)["tests"]:
        properties = {p["name"]: p["value"] for p in entry.get("properties", [])}
        environment = dict(e.split("=", 1) for e in properties.get("ENVIRONMENT", []))
        if "command" in entry:
            yield Test(entry["name"], entry["command"], properties.get("WORKING_DIRECTORY", work.build),
                       environment)


def useful(tests, work, patience):
    """Those that pass without a mutation and come by one. From then on they have `patience` seconds of the
    processor, or three times what they took."""
    met = os.path.join(work.folder, "met")
    for test in tests:
        test.memory = "unlimited" if work.sanitized else MEMORY # shadows take terabytes
    kept = [test for test in tests if test.try_unchanged(met)]
    for test in kept:
        test.patience = max(patience, int(3 * test.used))
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
