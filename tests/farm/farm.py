# SPDX-License-Identifier: MIT
"""What the tests of farms share: the recipes of src/cli/README.md, a small world, processes to kill.

    test_NAME.py PROGRAM DOCUMENT SCRATCH [LIBRARY]

Each runs recipes of the document as they are there, in a directory of its own below SCRATCH, and
prints what happens. Only the world is smaller than there. LIBRARY is for test_killed.py.
With SCARP_TEST_FARM=1 in the environment a missing tool is a failure, and daemons may be started;
else such a test is skipped.
"""
import glob
import os
import re
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "cli"))
from rasters import decode_envi_header, read_bytes, read_picture  # noqa: E402

SKIPPED = 77
REQUIRED = os.environ.get("SCARP_TEST_FARM") == "1"
# The blocks of the section, by the first word or words of the comment that opens them
RECIPES = ("The world", "The simplest farm", "world.sbatch", "Slurm", "srun", "Open MPI",
           "GNU parallel", "Kubernetes", "Levels", "GDAL", "Verify")
STARTED = time.monotonic()


def tell(text):
    print("%6.1f s  %s" % (time.monotonic() - STARTED, text), flush=True)


def check(condition, *message):
    if not condition:
        raise SystemExit("FAILED: " + " ".join(str(word) for word in message))


def recipes(document):
    """The fenced blocks of the section "Farms", all of them known here, by their names."""
    with open(document, encoding="utf-8") as file:
        section = re.search(r"^## Farms\n(.*?)^## ", file.read(), re.MULTILINE | re.DOTALL).group(1)
    found = {}
    for body in re.findall(r"^```\w+\n(.*?)^```$", section, re.MULTILINE | re.DOTALL):
        name = re.match(r"(?:#!.*\n)?# ([^:\n]*):", body).group(1)
        check(name not in found, "two recipes are called", name)
        found[name] = body
    check(sorted(found) == sorted(RECIPES), "recipes in the document:", sorted(found),
          "known to the tests:", sorted(RECIPES))
    return found


def need(*tools):
    """Ends the test where a tool is missing."""
    missing = [tool for tool in tools if shutil.which(tool) is None]
    if missing:
        skip("not installed: " + ", ".join(missing))


def skip(reason):
    print("%s: %s" % (reason, "FAILED (SCARP_TEST_FARM=1)" if REQUIRED else "skipped"))
    sys.exit(1 if REQUIRED else SKIPPED)


def wait_for(condition, what, seconds=60):
    """Waits until the condition is true, and returns its value."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        check(time.monotonic() < end, "gave up waiting for", what)
        time.sleep(0.005)


class Process:
    """A process of anybody's, from /proc; nothing is known of it once it has gone."""

    def __init__(self, pid):
        self.pid = pid

    def read(self, name):
        try:
            return read_bytes("/proc/%d/%s" % (self.pid, name))
        except OSError:
            return b""

    def link(self, name):
        try:
            return os.readlink("/proc/%d/%s" % (self.pid, name))
        except OSError:
            return ""

    def arguments(self):
        return self.read("cmdline").decode().split("\0")[:-1]

    def environment(self, name):
        parts = self.read("environ").split(b"\0")
        values = dict(part.split(b"=", 1) for part in parts if b"=" in part)
        return values.get(name.encode(), b"").decode()

    def share(self):
        arguments = self.arguments()
        return arguments[arguments.index("--share") + 1] if "--share" in arguments else None

    def state(self):
        return self.read("stat").rpartition(b") ")[2][:1].decode()

    def writes(self):
        """The unfinished files that it has open"""
        try:
            numbers = os.listdir("/proc/%d/fd" % self.pid)
        except OSError:
            return []
        paths = {self.link("fd/" + number) for number in numbers}
        return sorted(path for path in paths if path.endswith(".part"))

    def stop(self):
        """Stops it; True if it was in the middle of a tile."""
        try:
            os.kill(self.pid, signal.SIGSTOP)
        except ProcessLookupError:
            return False
        wait_for(lambda: self.state() in ("T", "Z", "X", ""), "process %d to stop" % self.pid)
        if self.writes():
            return True
        self.signal(signal.SIGCONT)
        return False

    def signal(self, number):
        try:
            os.kill(self.pid, number)
        except ProcessLookupError:
            pass


class Farm:
    """A directory in which recipes run."""
    # Dear samples, so that runs can be killed
    SLOW = {"--isa": "scalar"}

    def __init__(self, name, slow=True, layers=(("--hillshade", "shades/{y}/{x}"),), tile=128,
                 size=(2000, 2100)):
        program, document, scratch = sys.argv[1:4]
        self.program = os.path.realpath(program)
        self.recipes = recipes(document)
        self.directory = os.path.join(os.path.realpath(scratch), name)
        shutil.rmtree(self.directory, ignore_errors=True)
        os.makedirs(self.directory)
        self.environment = dict(os.environ, LC_ALL="C", PATH=os.path.dirname(self.program) +
                                os.pathsep + os.environ["PATH"])
        self.runs = []
        self.width, self.height = size
        self.tile = tile  # those at the right and at the bottom are smaller
        has_png = re.search(rb"(?m)^formats .*\bpng\b", self.output("scarp", "info"))
        self.make_world([(option, path + (".png" if has_png else ".pgm"))
                         for option, path in layers], slow)

    def make_world(self, layers, slow):
        """What the document's world becomes: smaller, with more layers."""
        self.run("The world")
        words = read_bytes(self.path("world")).decode().split()
        self.options = dict(zip(words[::2], words[1::2]))
        check({"--size", "--tile", "--heights"} <= set(self.options), "options of the world:",
              words)
        self.options["--size"] = "%dx%d" % (self.width, self.height)
        self.options["--tile"] = "%dx%d" % (self.tile, self.tile)
        self.options.update(self.SLOW if slow else {})
        self.heights = self.options["--heights"]
        self.layers = [("--heights", self.heights)] + layers
        self.options.update(layers)
        with open(self.path("world"), "w", encoding="utf-8") as file:
            file.write(" ".join(word for option in self.options.items() for word in option) + "\n")

    def path(self, *names):
        return os.path.join(self.directory, *names)

    def output(self, *command):
        """Standard output of a command that must succeed"""
        result = subprocess.run(command, cwd=self.directory, env=self.environment, check=False,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        check(result.returncode == 0, command, "->", result.returncode, result.stdout.decode(),
              result.stderr.decode())
        return result.stdout

    def start(self, name):
        """A recipe, as it is, in a shell."""
        return self.start_shell(self.recipes[name])

    def start_shell(self, script, **environment):
        self.runs.append(subprocess.Popen(
            ["sh", "-c", script], cwd=self.directory, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, env=dict(self.environment, **environment)))
        return self.runs[-1]

    def end(self):
        """Ends what still runs: after a failure."""
        for run in self.runs:
            if run.poll() is None:
                run.terminate()
        for process in self.processes():
            process.signal(signal.SIGKILL)

    def run(self, name):
        run = self.start(name)
        run.communicate()
        check(run.returncode == 0, "the recipe", name, "ends with", run.returncode)

    def processes(self):
        """The scarps that work in this directory"""
        found = [Process(int(pid)) for pid in os.listdir("/proc") if pid.isdigit()]
        return [process for process in found if process.link("exe") == self.program and
                process.link("cwd") == self.directory and process.state() not in "ZX"]

    def clear(self):
        """Removes all but `world`."""
        for name in os.listdir(self.directory):
            if os.path.isdir(self.path(name)):
                shutil.rmtree(self.path(name))
            elif name != "world":
                os.remove(self.path(name))

    def unfinished(self):
        return glob.glob(self.path("**", "*.part"), recursive=True)

    def tiles(self):
        """How many are there"""
        return len(glob.glob(self.path(re.sub("{[^}]*}", "*", self.heights))))

    def all_tiles(self):
        return -(-self.width // self.tile) * -(-self.height // self.tile)

    def victim(self, among=lambda process: True):
        """A process that is stopped in the middle of a tile, when some tiles are there."""
        def find():
            if self.tiles() < 20:
                return None
            return next((process for process in self.processes()
                         if among(process) and process.writes() and process.stop()), None)
        return wait_for(find, "a process that writes")

    def story(self):
        return "%d of %d tiles are there, %d files are unfinished" % (
            self.tiles(), self.all_tiles(), len(self.unfinished()))

    def state(self):
        """What changes when a file is written again"""
        paths = glob.glob(self.path("**"), recursive=True)
        return {path: (os.stat(path).st_ino, os.stat(path).st_mtime_ns) for path in paths
                if os.path.isfile(path)}

    def check_complete(self):
        """The world is there, as one file would have it, and nothing else."""
        check(self.unfinished() == [], "unfinished files stay:", self.unfinished())
        check(self.tiles() == self.all_tiles(), "there are", self.tiles(), "tiles of",
              self.all_tiles())
        self.make_whole()
        for option, pattern in self.layers:
            compare_tiles(self, pattern, self.whole(option))
            tell("%s: all %d samples are those of one file without tiles" % (
                pattern, self.width * self.height))
        before = self.state()
        command = self.start_shell(self.recipes["The simplest farm"].replace(" --quiet", ""))
        check(command.communicate()[0] == b"nothing to do: all files are there\n" and
              self.state() == before, "the proof that a world is complete")

    def whole(self, option):
        return "whole" + option + os.path.splitext(dict(self.layers)[option])[1]

    def make_whole(self):
        """One file without tiles per layer, by the best instruction set"""
        options = dict(self.options, **{option: self.whole(option) for option, _ in self.layers})
        del options["--tile"]
        options.pop("--isa", None)
        self.output("scarp", "terrain", "--quiet",
                    *[word for option in options.items() for word in option])

    def tile_name(self, pattern, x, y):
        return self.path(pattern.replace("{x}", str(x)).replace("{y}", str(y)))


def envi_rows(path):
    """Width, height, and the rows as bytes"""
    fields = decode_envi_header(read_bytes(path[:-len("img")] + "hdr").decode())
    width, height = int(fields["samples"]), int(fields["lines"])
    size = width * int(fields["bands"]) * {"1": 1, "4": 4}[fields["data type"]]
    data = read_bytes(path)
    check(len(data) == height * size, path, "has", len(data), "bytes")
    return width, height, [data[row * size:(row + 1) * size] for row in range(height)]


def rows_of(path):
    """As envi_rows; of other formats the rows as samples"""
    if path.endswith(".img"):
        return envi_rows(path)
    picture = read_picture(path)
    return picture.width, picture.height, picture.rows


def compare_tiles(farm, pattern, name):
    width, height, rows = rows_of(farm.path(name))
    check((width, height) == (farm.width, farm.height), name, "has", width, "x", height, "samples")
    unit = len(rows[0]) // width
    for y in range(-(-height // farm.tile)):
        for x in range(-(-width // farm.tile)):
            left, top = x * farm.tile, y * farm.tile
            tile = farm.tile_name(pattern, x, y)
            made = rows_of(tile)
            expected = [row[left * unit:(left + farm.tile) * unit]
                        for row in rows[top:top + farm.tile]]
            check(made[:2] == (len(expected[0]) // unit, len(expected)) and made[2] == expected,
                  tile, "differs from its part of", name)


def main(test):
    """Runs a test, which gets a function that makes a Farm and sees to its end."""
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    farms = []

    def new(*arguments, **more):
        farms.append(Farm(*arguments, **more))
        return farms[-1]
    try:
        test(new)
    finally:
        for farm in farms:
            farm.end()
    tell("passed")
