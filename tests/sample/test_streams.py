# SPDX-License-Identifier: MIT
"""Pipes, full disks, and files that must stay as they are."""
import itertools
import os
import re
import subprocess
import time
import unittest

import common
from common import run, npy, make_input, some_points, Case, BLOCK, KINDS, ENDS


class Streams(Case):
    """Pipes, slow ones and closed ones, and disks that are full."""

    def start(self, *arguments):
        process = subprocess.Popen(common.PROGRAM + ["sample", *arguments], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.wait)
        for stream in (process.stdin, process.stdout, process.stderr):
            self.addCleanup(stream.close)
        self.addCleanup(process.kill)
        return process

    def feed(self, process, data):
        process.stdin.write(data)
        process.stdin.flush()

    def check_interrupted(self, process):
        """One line, and the death that a shell expects."""
        time.sleep(0.3)  # in all likelihood it waits by then; if not, it must end all the same
        process.send_signal(common.signal.SIGINT)
        self.assertEqual(process.wait(20), -common.signal.SIGINT)
        self.assertRegex(process.stderr.read(), rb"\Ascarp: interrupted: [^\n]+\n\Z")

    @unittest.skipUnless(common.signal, "needs POSIX")
    def test_interrupted_reading(self):
        """Half a line that came before is not taken for a whole one."""
        output = os.path.join(self.directory, "o.csv")
        process = self.start("--output", output)
        self.feed(process, b"1,2\n3")
        while self.files() == []:  # it knows of signals before it opens files
            time.sleep(0.01)
        self.check_interrupted(process)
        self.assertEqual(self.files(), [])

    @unittest.skipUnless(common.signal, "needs POSIX")
    def test_interrupted_writing(self):
        """While a pipe is full that nobody reads."""
        points = os.path.join(self.directory, "points.txt")
        with open(points, "wb") as file:
            file.write(b"1.5 2.5\n" * 100000)
        process = self.start("--input", points)
        self.assertEqual(len(process.stdout.read(1)), 1)
        self.check_interrupted(process)

    def test_blocks(self):
        """A block that is complete is answered before the input ends."""
        for data, head, width in ((b"1 2\n" * BLOCK, 0, len(self.sample("1 2"))),
                                  (npy([(1.0, 2.0)] * BLOCK + [(0, 0)]), 128, 4)):
            process = self.start()
            self.feed(process, data)
            out = process.stdout.read(head + width * BLOCK)
            self.assertEqual(len(out), head + width * BLOCK)
            process.stdin.close()
            self.assertEqual(process.wait(), 0)

    def test_single_points(self):
        """Even a single line, and half a line when its other half comes."""
        options = ("--keep", "--amplitude", "5")
        process = self.start(*options)
        for i in range(20):
            point = b"%d %d.5" % (i, i)
            self.feed(process, point + b"\n")
            self.assertEqual(process.stdout.readline(), self.sample(point, *options))
        self.feed(process, b"5 6\n7 ")
        self.assertEqual(process.stdout.readline()[:4], b"5 6 ")
        self.feed(process, b"8\r")
        self.feed(process, b"\n9 9")
        self.assertEqual(process.stdout.readline()[:4], b"7 8 ")
        process.stdin.close()
        self.assertEqual(process.stdout.read()[:4], b"9 9 ")
        self.assertEqual((process.wait(), process.stderr.read()), (0, b""))

    def test_pieces(self):
        """The same results in whatever pieces the input comes."""
        for kind in KINDS:
            data = make_input(kind, some_points(3, 300), header=True)
            expected = self.sample(data)
            for size in (1, 7, 1000):
                process = self.start()
                for i in range(0, min(len(data), 60 * size), size):
                    self.feed(process, data[i:i + size])
                out = process.communicate(data[min(len(data), 60 * size):])
                self.assertEqual(out, (expected, b""), (kind, size))

    def test_long_line_in_pieces(self):
        """A line that is too long stays so when it comes in parts between good ones."""
        process = self.start("--skip-bad")
        for piece in (b"1 2\n1 ", b"1" * 100000, b"1" * 100000, b"1 2\n3 4\n"):
            self.feed(process, piece)
        process.stdin.close()
        self.assertEqual(process.stdout.read(), self.sample("1 2\n3 4\n"))
        self.assertIn(b" 1 malformed line ", process.stderr.read())

    @unittest.skipUnless(common.resource and os.path.exists("/proc/self/status"), "needs Linux")
    def test_memory(self):
        """A long input takes no more memory than a short one."""
        if os.environ.get("SCARP_SPEED") != "full":
            self.skipTest("a sanitizer or an emulator takes memory of its own")
        process = self.start("--output", os.devnull, "--output-format", "text", "--keep")
        def peak():
            with open("/proc/%d/status" % process.pid) as file:
                return int(re.search(r"VmHWM:\s+(\d+)", file.read()).group(1))
        block = b"1234.5 6789.25\n" * 10000
        self.feed(process, block * 4)
        first = peak()
        for _ in range(60):
            self.feed(process, block)
        last = peak()
        process.stdin.close()
        self.assertEqual(process.wait(), 0)
        self.assertLess(last - first, 1024)

    def check_failure(self, result, status, word):
        self.assertEqual(result[0], status, result)
        self.assertRegex(result[1].decode(), r"\Ascarp: --output: [^\n]*%s[^\n]*: [^\n]+\n\Z" %
                         re.escape(word))

    @unittest.skipUnless(common.resource, "needs POSIX")
    def test_closed_pipe(self):
        process = self.start()
        process.stdout.close()
        try:
            self.feed(process, b"1 2\n" * 100000)
            process.stdin.close()
        except BrokenPipeError:
            pass
        self.check_failure((process.wait(), process.stderr.read()), 1, "standard output")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_dev_full(self):
        for data in (b"1 2\n", b"1 2\n" * 100000, b"x,y\n", npy([(1, 2)]), npy([], columns=2)):
            with open("/dev/full", "wb") as full:
                result = run(data=data, stdout=full)
            self.check_failure((result.returncode, result.stderr), 1, "standard output")
            result = run("--output", "/dev/full", data=data)
            self.check_failure((result.returncode, result.stderr), 1, "/dev/full")
        with open("/dev/full", "wb") as full:
            self.assertEqual(run(data=b"", stdout=full).returncode, 0)  # nothing was lost

    @unittest.skipUnless(common.resource, "needs POSIX")
    def test_full_disk(self):
        """A limit on the size of files stands for a disk that fills up. Files stay as they were."""
        points = some_points(2, 20000)
        for kind, out in itertools.product(("text", "npy"), KINDS):
            for limit in (1024, 50000):
                def limit_files():
                    common.signal.signal(common.signal.SIGXFSZ, common.signal.SIG_IGN)
                    common.resource.setrlimit(common.resource.RLIMIT_FSIZE, (limit, limit))

                self.write("o", b"old")
                result = run("--output", self.path("o"), "--output-format", out,
                             data=make_input(kind, points), preexec_fn=limit_files)
                self.check_failure((result.returncode, result.stderr), 1, self.path("o"))
                self.assertEqual((self.files(), self.read("o")), (["o"], b"old"))


class Files(Case):
    def test_same_file(self):
        for kind in KINDS:
            points = some_points(3, 10000)
            data = make_input(kind, points, header=True)
            path = self.write("p" + ENDS[kind], data)
            self.sample(b"", "--input", path, "--output", path, "--keep")
            self.assertEqual(self.read("p" + ENDS[kind]), self.sample(data, "--keep"))
            os.remove(path)
        self.assertEqual(self.files(), [])

    def test_untouched(self):
        """A run that fails leaves the file that is there, and nothing else."""
        path = self.write("o.csv", b"old")
        bad = self.write("bad.csv", b"1,2\n" * 10000 + b"1\n")
        for arguments in (("--input", bad), ("--input", self.path("none")), ("--seed", "x"),
                          ("--input", self.directory), ("--hessian", "--fractal", "erosion")):
            self.check_refused(b"1,2\n", arguments=arguments + ("--output", path))
            self.assertEqual((self.files(), self.read("o.csv")), (["bad.csv", "o.csv"], b"old"))
        self.check_refused(b"", bad + ":10001: ", arguments=("--input", bad, "--output", bad))
        self.assertEqual(len(self.read("bad.csv")), 40002)

    def test_dash(self):
        expected = self.sample("1 2")
        self.assertEqual(self.sample("1 2", "--input", "-", "--output", "-"), expected)
        self.assertEqual(self.sample("1 2", "--input=-", "--output=-"), expected)

    def test_unreadable(self):
        missing = self.path("none")
        self.check_refused(b"", "scarp: --input: %s: " % missing, arguments=("--input", missing))
        self.check_refused(b"", "scarp: --input: %s: " % self.directory,
                           arguments=("--input", self.directory))
        if common.resource and os.geteuid() != 0:
            path = self.write("secret", b"1 2\n")
            os.chmod(path, 0)
            self.check_refused(b"", path, arguments=("--input", path))

    def test_unwritable(self):
        for path in (os.path.join(self.path("none"), "o.csv"), self.directory):
            self.check_refused(b"1 2\n", "scarp: --output: %s: " % path,
                               arguments=("--output", path))
        self.assertEqual(self.files(), [])


common.main(globals())
