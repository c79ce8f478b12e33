# SPDX-License-Identifier: MIT
"""What becomes of files when calls of the system fail, or a run is killed in one: strace shows it."""
import os
import re
import shutil
import signal
import subprocess

import common
from common import run
from test_world import WorldCase


class TracedCase(WorldCase):
    def trace(self, *arguments):
        """Runs under strace with its options, then the program's after "--"."""
        strace = shutil.which("strace")
        if not strace or len(common.PROGRAM) != 1:
            self.skipTest("needs strace, and no emulator")
        at = arguments.index("--")
        result = subprocess.run([strace, "-f", *arguments[:at], *common.PROGRAM,
                                 *arguments[at + 1:]], cwd=self.directory,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300,
                                check=False)
        if b"ptrace" in result.stderr:
            self.skipTest("strace may not trace here")
        return result

    def traced(self, *arguments):
        """What strace logs of a run that succeeds"""
        log = self.path("log")
        result = self.trace("-o", log, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(log, encoding="utf-8") as file:
            text = file.read()
        os.remove(log)
        return text


class PowerCut(TracedCase):
    """What has its name is on the disk: seen by the order of the system's calls."""

    def calls(self, *arguments):
        """The calls that matter, as ("fsync", name) or ("rename", from, to), in their order"""
        text = self.traced("-y", "-e", "trace=fsync,rename,link,renameat,renameat2,linkat", "--",
                           *arguments)
        found = []
        for line in text.splitlines():
            fsync = re.search(r" fsync\(\d+<(.*)>\) += 0$", line)
            move = re.search(r" (rename|link)\(\"(.*)\", \"(.*)\"\) += 0$", line)
            self.assertNotIn("unfinished", line)
            if fsync:
                found.append(("fsync", os.path.basename(fsync[1])))
            elif move:
                found.append((move[1], *map(os.path.basename, move.groups()[1:])))
        return found

    def check_order(self, calls, names, also=()):
        """Each file is synchronised before the first of them is renamed, and then the directory."""
        here = os.path.basename(self.directory)
        moves = [call for call in calls if call[0] != "fsync"]
        self.assertEqual([call[2] for call in moves], names)
        first = calls.index(moves[0])
        self.assertEqual(sorted(name for _, name in calls[:first]),
                         sorted([*also, *(call[1] for call in moves)]))
        self.assertIn(("fsync", here), calls[calls.index(moves[-1]):])

    def test_raster(self):
        self.check_order(self.calls("terrain", "--size", "9x9", "--heights", "h.img", "--normals",
                                    "n.npy"), ["h.hdr", "h.img", "n.npy"])

    def test_points(self):
        self.write("p.csv", b"1,2\n")
        self.check_order(self.calls("sample", "--input", "p.csv", "--output", "v.csv"), ["v.csv"])

    def test_tiles(self):
        """The manifest is on the disk before the first tile is renamed, and checksums are before the
        tile that they are of."""
        calls = self.calls("terrain", "--size", "4x2", "--tile", "2x2", "--heights", "w.r32")
        manifest = next(i for i, call in enumerate(calls) if call[-1] == "w.r32.json") + 1
        self.check_order(calls[:manifest + 1], ["w.r32.json"])
        sums = ["w.r32.sums"]
        self.check_order(calls[manifest + 1:manifest + 5], ["w_0_0.r32"], sums)
        self.check_order(calls[manifest + 5:], ["w_0_1.r32"], sums)


class Faults(TracedCase):
    """Each of the calls that make files fails once, or is where a run is killed."""

    WORLD = ("terrain", "--size", "40x30", "--tile", "20x30", "--threads", "1", "--quiet",
             "--heights", "w/{y}/{x}.img", "--normals", "w/{y}/{x}.npy", "--hillshade",
             "s/{y}{x}.pgm", "--resume")
    FAULTS = (("link", ("error=EIO", "error=EPERM", "signal=KILL")),
              ("rename", ("error=EIO", "signal=KILL")), ("unlink", ("signal=KILL",)),
              ("fsync", ("error=EIO", "error=ENOSYS", "error=EINTR", "signal=KILL")),
              ("mkdir", ("error=ENOSPC", "signal=KILL")), ("flock", ("error=ENOLCK",)))

    def setUp(self):
        super().setUp()
        log = self.traced("-e", "trace=" + ",".join(call for call, _ in self.FAULTS), "--",
                          *self.WORLD)
        self.expected = self.walk()
        # strace counts the calls of each thread.
        calls = re.findall(r"(?m)^(\d+) +(\w+)\(", log)
        self.counts = {call: max(calls.count((thread, call)) for thread, _ in calls)
                       for call, _ in self.FAULTS}
        if not all(self.counts.values()):
            self.skipTest("this system's calls have other names: %s" % self.counts)

    def empty(self):
        for name in self.files():
            subprocess.run(["rm", "-r", self.path(name)], check=True)

    def check_left(self, result):
        """After a failure: whole files, none without what belongs to it, no empty directory."""
        self.check_one_line(result, result.returncode, "--")
        self.assertIn(result.returncode, (1, 2))
        left = self.walk()
        self.check_same_files(left, {name: self.expected.get(name) for name in left})
        self.assertEqual([name for name in self.directories()
                          if not os.listdir(self.path(name))], [], "empty directories")
        tiles = [name for name in left if name != "w/y_x.img.json"]
        if result.returncode == 2 or not tiles:
            self.assertEqual(left, {})
            self.assertEqual([name for _, _, names in os.walk(self.directory) for name in names
                              if name.endswith(".sums")], [], "checksums of nothing")
        for name in tiles:
            tile = re.search(r"(\d)\.", name)[1]
            self.assertEqual([name for name in self.expected
                              if name not in left and re.search(tile + r"\.", name)], [])

    def check_fault(self, call, fault, *more, status=None):
        """Returns whether the program met the fault, and not the system that loads it."""
        self.empty()
        result = self.trace("-o", os.devnull, "-e", "inject=%s:%s" % (call, fault), *more, "--",
                            *self.WORLD)
        if b"invalid" in result.stderr:
            self.skipTest("strace cannot inject faults")
        if result.returncode == 127 and b"shared librar" in result.stderr:
            return False
        if status is not None:
            self.assertEqual(result.returncode, status, result.stderr)
        if result.returncode == 0:
            self.assertEqual(result.stderr, b"")
            self.check_same_files(self.walk(), self.expected)
        elif result.returncode != -signal.SIGKILL:
            self.check_left(result)
        self.assertEqual(run(*self.WORLD, cwd=self.directory).stderr, b"")
        self.check_same_files(self.walk(), self.expected)
        return True

    def test_each_call(self):
        for call, faults in self.FAULTS:
            for fault in faults:
                for n in (*range(1, self.counts[call] + 1), "1+"):
                    if n == "1+" and fault == "error=EINTR":
                        continue  # a call that is interrupted is made again
                    with self.subTest(call=call, fault=fault, when=n):
                        self.check_fault(call, "%s:when=%s" % (fault, n))

    def test_directory_goes(self):
        """Another run removes the directory that it made just before a file is opened there."""
        self.empty()
        log = self.traced("-e", "trace=openat", "--", *self.WORLD)
        calls = re.findall(r"(?m)^(\d+) +openat\((.*)", log)
        ours = [text for thread, text in calls if thread == calls[0][0]]
        opened = [n for n, text in enumerate(ours, 1) if re.search(r"\.[^/]*\.part\"", text)]
        self.assertGreaterEqual(len(opened), 9)
        for n in (opened[1], opened[3]):  # the first files that need w/0 and s
            self.empty()
            result = self.trace("-o", os.devnull, "-e", "inject=openat:error=ENOENT:when=%d" % n,
                                "--", *self.WORLD)
            self.assertEqual((result.returncode, result.stderr), (0, b""))
            self.check_same_files(self.walk(), self.expected)

    def test_manifest_goes(self):
        """Whenever a run looks, its manifest has just been removed by another one."""
        self.empty()
        log = self.traced("-e", "trace=stat,newfstatat", "--", *self.WORLD)
        counts, looks = {}, []
        for thread, call, text in re.findall(r"(?m)^(\d+) +(stat|newfstatat)\((.*)", log):
            counts[thread, call] = counts.get((thread, call), 0) + 1
            if "y_x.img.json\"" in text:
                looks.append((call, counts[thread, call]))
        self.assertGreaterEqual(len(looks), 5)
        # A number that a call has in one thread, it may have in another before the program begins.
        met = []
        for call, n in sorted(set(looks)):
            with self.subTest(call=call, when=n):
                met.append(self.check_fault(call, "error=ENOENT:when=%d" % n, status=0))
        self.assertGreaterEqual(sum(met), len(met) // 2)

    def test_without_hard_links(self):
        for n in range(1, self.counts["rename"] + 2):
            with self.subTest(when=n):
                self.check_fault("rename", "error=EIO:when=%d" % n, "-e", "inject=link:error=EPERM")
        self.check_fault("rename", "signal=KILL:when=1", "-e", "inject=link:error=EPERM")


common.main(globals())
