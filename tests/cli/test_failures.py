# SPDX-License-Identifier: MIT
"""Files that cannot be written to the end, and those that are no ordinary files."""
import os
import re
import stat
import subprocess
import threading
import time
import unittest

import common
from common import resource, SMALL, Case, has_png, has_threads, run, start
from rasters import read_bytes

POSIX = unittest.skipUnless(common.pty, "needs POSIX")
INTEGERS = {"--heights": ("r16", "pgm", "png")}
FULL = unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")


class FullDisk(Case):
    """A limit on the size of files stands for a disk that fills up, early and late."""

    SIZE = ("--size", "200x150", "--octaves", "3")

    def check(self, option, name, target, *more, least=0):
        """Fails at every limit from `least` on that is less than what the files take."""
        self.quietly(*self.SIZE, option, name, *more)
        largest = max(len(data) for data in self.all_bytes().values())
        self.clear()
        for limit in (0, 1024, 5000, largest // 2, largest - 1):
            if not least <= limit < largest:
                continue
            with self.subTest(file=name, limit=limit):
                result = run("terrain", *self.SIZE, option, name, *more, cwd=self.directory,
                             preexec_fn=common.file_limit(limit))
                self.check_one_line(result, 1, option, target)
                self.assertEqual(self.files(), [])
        self.quietly(*self.SIZE, option, name, *more, preexec_fn=common.file_limit(largest))
        self.clear()

    @POSIX
    def test_heights(self):
        for kind in ["r16", "r32", "pgm", "pfm", "img", "npy"] + ["png"] * has_png():
            self.check("--heights", "t." + kind, "t." + kind)

    @POSIX
    def test_other_layers(self):
        self.check("--normals", "t.npy", "t.npy")
        self.check("--normals", "t.pfm", "t.pfm")
        self.check("--hillshade", "t.img", "t.img")
        self.check("--gradient", "t.img", "t.img")

    @POSIX
    def test_pictures(self):
        self.check("--output", "t", "t-")
        self.check("--output", "t", "t-", "--compare", "2")

    @POSIX
    def test_one_of_several(self):
        """The others, which have room, are removed as well."""
        self.check("--normals", "n.npy", "n.npy", "--heights", "h.pgm", "--hillshade", "s.img",
                   least=100000)

    @POSIX
    def test_older_files(self):
        """They stay as they were."""
        self.quietly(*self.SIZE, "--seed", "5", "--heights", "h.r32", "--gradient", "g.img")
        old = self.all_bytes()
        result = run("terrain", *self.SIZE, "--heights", "h.r32", "--gradient", "g.img",
                     cwd=self.directory, preexec_fn=common.file_limit(200 * 150 * 8 - 1))
        self.check_one_line(result, 1, "--gradient", "g.img")
        self.check_same_files(self.all_bytes(), old)

    @POSIX
    def test_tiles(self):
        """The first tile that does not fit ends the run; those before it stay."""
        result = run("terrain", "--size", "100x100", "--tile", "80x80", "--tiles", "0:2,1:2",
                     "--heights", "h.r32", cwd=self.directory,
                     preexec_fn=common.file_limit(6400 - 1))
        self.check_one_line(result, 1, "--heights", "h_1_0.r32")
        self.assertEqual(self.files(), [])
        result = run("terrain", "--size", "250x200", "--tile", "200x40", "--tiles", "1:2,0:5",
                     "--heights", "h.r32", cwd=self.directory,
                     preexec_fn=common.file_limit(8000))
        self.assertEqual((result.returncode, len(self.files())), (0, 1 + 5))

    @POSIX
    def test_later_tile_cannot_be_opened(self):
        """Something was done by then, so it is no bad command line; the rest stays."""
        os.mkdir(self.path("h_1_0.r32"))
        result = run("terrain", "--size", "20x20", "--tile", "10x10", "--heights", "h.r32",
                     cwd=self.directory)
        self.check_one_line(result, 1, "--heights", "h_1_0.r32")
        self.assertEqual(self.files(), ["h.r32.json", "h_0_0.r32", "h_0_1.r32", "h_1_0.r32"])

    @FULL
    def test_device(self):
        for option, kinds in (("--heights", ["r32", "pgm", "npy", "pfm"] + ["png"] * has_png()),
                              ("--normals", ["ppm", "npy"]), ("--gradient", ["npy"])):
            for kind in kinds:
                with self.subTest(option=option, format=kind):
                    result = run("terrain", *SMALL, option, kind + ":/dev/full", "--hillshade",
                                 "s.pgm", cwd=self.directory)
                    self.check_one_line(result, 1, option, "/dev/full")
                    self.assertEqual(self.files(), [])
                    self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))

    @FULL
    def test_standard_output(self):
        """Help and facts, the closing line, and a file."""
        with open("/dev/full", "wb") as full:
            for arguments, words in ((["info"], ""), (["--help"], ""), (["terrain", "--help"], ""),
                                     (["terrain", *SMALL, "--output", self.path("t")], ""),
                                     (["terrain", *SMALL, "--heights", "pgm:-"], "--heights: "),
                                     (["terrain", *SMALL, "--gradient", "npy:-", "--quiet"],
                                      "--gradient: ")):
                with self.subTest(arguments=arguments):
                    result = run(*arguments, stdout=full)
                    self.assertEqual(result.returncode, 1)
                    self.assertRegex(result.stderr.decode(),
                                     r"\Ascarp: %sstandard output: [^\n]+\n\Z" % words)


class Refused(Case):
    """Threads that the system does not start: the others do the work."""

    SIZE = ("--size", "3000x300", "--octaves", "2")

    def setUp(self):
        super().setUp()
        if has_threads():
            self.SIZE += ("--threads", "4")

    @POSIX
    @unittest.skipUnless(common.SPEED == "full", "what is added to the program takes memory")
    def test_little_memory(self):
        """A run that gets no memory says so; every other one does all of it."""
        files = ("--heights", "h.r32", "--normals", "n." + ("png" if has_png() else "ppm"))
        self.quietly(*self.SIZE, *files)
        expected = self.all_bytes()
        self.clear()
        counts = set()
        for kibibytes in [*range(4000, 5500, 50), *range(5500, 20000, 250), 25000, 45000, 70000]:
            with self.subTest(kibibytes=kibibytes):
                result = run("terrain", *self.SIZE, *files, cwd=self.directory,
                             preexec_fn=common.limits(AS=kibibytes << 10))
                if result.returncode == 127:  # not even the program itself
                    self.assertFalse(result.stderr.startswith(b"scarp: "), result.stderr)
                elif result.returncode == 0:
                    self.check_same_files(self.all_bytes(), expected)
                    counts.add(re.search(rb" (\d) threads?\)", result.stdout).group(1))
                else:
                    self.assertIn(result.returncode, (1, 2))
                    self.check_one_line(result, result.returncode, "memory")
                    self.assertEqual(self.files(), [])
                self.clear()
        self.assertLessEqual({b"1", b"2", b"4"} if has_threads() else {b"1"}, counts)

    @POSIX
    @unittest.skipUnless(common.SPEED == "full", "what is added to the program takes memory")
    def test_little_stack(self):
        """The first thread takes what it needs, or says that it may not, before it begins."""
        self.quietly(*self.SIZE, "--heights", "h.r32")
        expected = self.all_bytes()
        for kibibytes in (96, 128, 192, 255, 256, 1024):
            with self.subTest(kibibytes=kibibytes):
                self.clear()
                limits = common.limits(STACK=kibibytes << 10)
                result = run("terrain", *self.SIZE, "--heights", "h.r32", "--quiet",
                             cwd=self.directory, preexec_fn=limits)
                if kibibytes < 256:
                    self.check_one_line(result, 1, "stack", "%d KiB" % kibibytes, "ulimit")
                    self.assertEqual(self.files(), [])
                else:
                    self.assertEqual((result.returncode, result.stderr), (0, b""))
                    self.check_same_files(self.all_bytes(), expected)
                hard = resource.getrlimit(resource.RLIMIT_STACK)[1]
                self.quietly(*self.SIZE, "--heights", "h.r32",
                             preexec_fn=common.limits(STACK=(kibibytes << 10, hard)))
                self.check_same_files(self.all_bytes(), expected)

    @unittest.skipUnless(os.path.exists("/proc/self/smaps") and common.SPEED != "emulated",
                         "needs Linux")
    def test_stack_is_taken_first(self):
        """Before there is anything to do: later, threads and files may have taken the memory. What
        is mapped does not count, since Linux gives every program that much."""
        process = start("sample", stdin=subprocess.PIPE)
        self.addCleanup(process.communicate)
        taken, end = 0, time.monotonic() + 20
        while taken < 128 and time.monotonic() < end:
            with open("/proc/%d/smaps" % process.pid, encoding="utf-8") as file:
                stack = re.search(r"\[stack\]\n(?:.*\n)*?Rss:\s+(\d+) kB", file.read())
            taken = int(stack.group(1)) if stack else 0
            time.sleep(0.01)
        self.assertGreaterEqual(taken, 128)

    @POSIX
    def test_settings_of_others(self):
        """The stack of a thread does not depend on what the environment wishes for others."""
        self.quietly(*self.SIZE, "--heights", "h.r32")
        expected = self.all_bytes()
        for environment in ({"OMP_STACKSIZE": "128k"}, {"OMP_STACKSIZE": "1000000g"},
                            {"OMP_NUM_THREADS": "-1"}, {"KMP_STACKSIZE": "16k"}):
            with self.subTest(environment=environment):
                self.clear()
                self.quietly(*self.SIZE, "--heights", "h.r32", env={**os.environ, **environment})
                self.check_same_files(self.all_bytes(), expected)


class Closed(Case):
    """Standard streams that the caller has closed: nothing that is printed gets into a file."""

    def closed(self, which, *arguments):
        return subprocess.run(["sh", "-c", 'exec "$@" %s' % which, "sh", *common.PROGRAM,
                               *arguments], cwd=self.directory, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)

    @POSIX
    def test_files(self):
        tiles = (*SMALL, "--tile", "20x30", "--heights", "w.img")
        self.quietly(*tiles)
        expected = self.all_bytes()
        self.clear()
        for which, status in (("2>&-", 0), (">&-", 1), ("<&-", 0), ("<&- >&- 2>&-", 1)):
            with self.subTest(closed=which):
                self.assertEqual(self.closed(which, "terrain", *tiles).returncode, status)
                self.check_same_files(self.all_bytes(), expected)
                self.clear()

    @POSIX
    def test_messages(self):
        """The message about the second tile goes nowhere, not into the manifest."""
        os.mkdir(self.path("w_0_1.r32"))
        tiles = (*SMALL, "--tile", "20x30", "--heights", "w.r32")
        self.check_one_line(run("terrain", *tiles, cwd=self.directory), 1, "w_0_1.r32")
        os.rmdir(self.path("w_0_1.r32"))
        expected = self.all_bytes()
        self.clear()
        os.mkdir(self.path("w_0_1.r32"))
        self.assertEqual(self.closed("2>&-", "terrain", *tiles).returncode, 1)
        os.rmdir(self.path("w_0_1.r32"))
        self.check_same_files(self.all_bytes(), expected)

    @POSIX
    def test_points(self):
        result = self.closed("<&-", "sample", "--input", "-", "--output", "v.csv")
        self.check_one_line(result, 2, "--input: standard input")
        self.assertEqual(self.files(), [])


class Pipes(Case):
    """Standard output and other files that are not ordinary ones."""

    SIZE = ("--size", "300x200", "--octaves", "2")

    def test_standard_output(self):
        """It gets the file's bytes and nothing else."""
        files = [("--heights", kind) for kind in ["r16", "r32", "pgm", "npy"] + ["png"] * has_png()]
        files += [("--normals", kind) for kind in ["ppm", "npy"] + ["png"] * has_png()]
        files += [("--hillshade", "pgm"), ("--gradient", "npy")]
        for option, kind in files:
            with self.subTest(option=option, format=kind):
                expected = self.layer(option, "t." + kind, *self.SIZE)
                result = run("terrain", *self.SIZE, option, kind + ":-", cwd=self.directory)
                self.assertEqual(result.returncode, 0)
                self.assertEqual(result.stdout == expected, True)
                heights = rb"16-bit heights: [^\n]*\n" if kind in INTEGERS.get(option, ()) else b""
                self.assertRegex(result.stderr,
                                 rb"\A" + heights + rb"300x200 samples in [^\n]*\n\Z")
                result = run("terrain", *self.SIZE, option, kind + ":-", "--quiet",
                             cwd=self.directory)
                self.assertEqual((result.stdout == expected, result.stderr), (True, b""))
                with open(self.path("redirected"), "wb") as file:
                    self.quietly_to(file, option, kind + ":-")
                self.assertEqual(self.bytes("redirected") == expected, True)
                self.clear()

    def quietly_to(self, file, *arguments):
        result = run("terrain", *self.SIZE, *arguments, "--quiet", cwd=self.directory, stdout=file)
        self.assertEqual((result.returncode, result.stderr), (0, b""))

    def test_with_other_files(self):
        expected = [self.layer(option, name, *self.SIZE)
                    for option, name in (("--heights", "h.r32"), ("--gradient", "g.npy"))]
        self.clear()
        result = run("terrain", *self.SIZE, "--heights", "r32:-", "--gradient", "g.npy",
                     cwd=self.directory)
        self.assertEqual([result.stdout, self.bytes("g.npy")] == expected, True)
        self.assertEqual(self.files(), ["g.npy"])

    @POSIX
    def test_closed_pipe(self):
        """Whoever reads goes away, as head does; the run ends with one line."""
        for arguments in (("--heights", "pgm:-"), ("--normals", "npy:-"),
                          ("--heights", "r32:-", "--normals", "n.npy"),
                          *[("--heights", "png:-", "--normals", "n.png")] * has_png()):
            for taken in (0, 100, 70000):
                with self.subTest(arguments=arguments, taken=taken):
                    process = start("terrain", "--size", "1000x1000", "--octaves", "1", *arguments,
                                    cwd=self.directory)
                    self.assertEqual(len(process.stdout.read(taken)), taken)
                    process.stdout.close()
                    error = process.stderr.read()
                    process.stderr.close()
                    self.assertEqual(process.wait(60), 1)
                    self.assertEqual(error, b"scarp: %s: standard output: Broken pipe\n" %
                                     arguments[0].encode())
                    self.assertEqual(self.files(), [])

    @POSIX
    def test_null(self):
        """A device takes as many layers as one likes, and remains."""
        self.quietly(*SMALL, "--heights", "r32:/dev/null", "--normals", "npy:/dev/null",
                     "--gradient", "npy:/dev/null", "--hillshade", "pgm:/dev/null")
        self.quietly(*SMALL, "--heights", "pfm:/dev/null", "--normals", "pfm:/dev/null",
                     "--hillshade", "s.pgm")
        self.assertEqual(self.files(), ["s.pgm"])
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    @POSIX
    def test_named_pipe(self):
        for option, kind in (("--heights", "r32"), ("--normals", "ppm"), ("--gradient", "npy")):
            with self.subTest(format=kind):
                expected = self.layer(option, "t." + kind, *self.SIZE)
                self.clear()
                os.mkfifo(self.path("p"))
                got = []
                reader = threading.Thread(target=lambda: got.append(read_bytes(self.path("p"))))
                reader.start()
                self.quietly(*self.SIZE, option, kind + ":p")
                reader.join(60)
                self.assertEqual(got == [expected], True)
                self.assertEqual(self.files(), ["p"])
                self.assertTrue(stat.S_ISFIFO(os.stat(self.path("p")).st_mode))
                self.clear()

    @POSIX
    def test_named_pipe_for_pfm(self):
        """It is written from its end, which a pipe does not allow."""
        os.mkfifo(self.path("p"))
        reader = os.open(self.path("p"), os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, reader)
        result = run("terrain", *SMALL, "--heights", "pfm:p", cwd=self.directory)
        self.check_one_line(result, 2, "--heights", "p: ")
        self.assertEqual(os.read(reader, 100), b"")

    @POSIX
    def test_links(self):
        """A symbolic link to a device is that device; one to a file can be replaced."""
        os.symlink("/dev/null", self.path("n"))
        self.quietly(*SMALL, "--heights", "r32:n")
        self.assertEqual(os.readlink(self.path("n")), "/dev/null")
        self.quietly(*SMALL, "--heights", "t.r32")
        os.symlink("t.r32", self.path("l.r32"))
        self.quietly(*SMALL, "--seed", "2", "--heights", "l.r32")
        self.assertNotIn(self.bytes("l.r32"), (b"", self.layer("--heights", "t.r32", *SMALL)))

    @unittest.skipUnless(hasattr(os, "geteuid") and os.geteuid() != 0, "root may write everything")
    def test_write_protected(self):
        """A file that may not be changed is not replaced either."""
        self.quietly(*SMALL, "--heights", "t.r32")
        os.chmod(self.path("t.r32"), 0o444)
        result = run("terrain", *SMALL, "--heights", "t.r32", cwd=self.directory)
        self.check_one_line(result, 2, "--heights", "t.r32")


common.main(globals())
