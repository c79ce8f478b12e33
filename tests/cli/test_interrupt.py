# SPDX-License-Identifier: MIT
"""Runs that are told to stop: they tidy up, say so, and end by the signal, at once."""
import os
import re
import signal
import subprocess
import sys
import time

import common
from common import PATIENCE, Case, has_threads, skip_all, start

try:
    import fcntl
    import resource
    import termios
except ImportError:
    skip_all("needs POSIX")

# Minutes of work, in bands that take a fraction of a second
LONG = ("--size", "3000x100000", "--octaves", "32", "--frequency", "0.01", "--lacunarity", "1.1",
        "--threads", "1", "--quiet")
FILES = ("--heights", "h.r32", "--normals", "n.npy", "--gradient", "g.img")
# What ends a process and comes from a keyboard, a shell or a batch system
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGALRM, signal.SIGQUIT,
           signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU)


class Interrupt(Case):
    def begin(self, *arguments, preexec_fn=None, **more):
        def prepare():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))  # some of the signals dump it here
            if preexec_fn:
                preexec_fn()
        process = start("terrain", *arguments, cwd=self.directory, preexec_fn=prepare, **more)

        def end():
            process.kill()
            process.communicate()
        self.addCleanup(end)
        return process

    def check_ended(self, process, number, words=""):
        """By the signal, soon, with one line on stderr and nothing on standard output."""
        output, error = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, -number, error)
        self.assertIn(output, (b"", None))
        text = error.decode()
        if len(common.PROGRAM) > 1:  # an emulator tells of signals that dump the memory
            text = re.sub(r"(?m)^qemu: uncaught target signal [^\n]*\n", "", text)
        self.assertRegex(text, r"\Ascarp: interrupted: [^\n]*%s[^\n]*\n\Z" % words)

    def test_one_raster(self):
        """No file is left, and those of an earlier run stay as they were."""
        for number in SIGNALS:
            with self.subTest(signal=number):
                for name in ("h.r32", "g.hdr"):
                    with open(self.path(name), "wb") as file:
                        file.write(b"old")
                process = self.begin(*LONG, *FILES)
                self.wait_for_unfinished("g.hdr")
                process.send_signal(number)
                self.check_ended(process, number)
                self.assertEqual(self.all_bytes(), {"h.r32": b"old", "g.hdr": b"old"})

    def test_tiles(self):
        """Finished ones stay; of the one at hand nothing does. A pipe holds the run there."""
        arguments = ("--size", "40x30", "--tile", "10x10", *FILES)
        self.quietly(*arguments)
        contents = self.all_bytes()
        for number in SIGNALS:
            with self.subTest(signal=number):
                self.clear()
                os.mkfifo(self.path("n_1_1.npy"))
                process = self.begin(*arguments)
                self.wait_for_unfinished("h_1_1.r32")
                time.sleep(0.05)  # until the run waits for a reader, most likely
                process.send_signal(number)
                self.check_ended(process, number, "finished tiles stay")
                os.remove(self.path("n_1_1.npy"))
                self.check_same_files(self.all_bytes(), {
                    name: data for name, data in contents.items()
                    if name == "h.r32.json" or
                    name.split("_", 1)[1][:3] in ("0_0", "0_1", "0_2", "0_3", "1_0")})
                self.quietly(*arguments, "--resume")
                self.check_same_files(self.all_bytes(), contents)

    def test_before_the_first_tile(self):
        """While files that are there are looked for, to tell how much is to be written"""
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.begin("--size", "10000x1000", "--tile", "1x1", "--normals", "n.npy",
                                 "--octaves", "1", "--quiet")
            time.sleep(0.5)
            begin = time.monotonic()
            process.send_signal(number)
            self.check_ended(process, number)
            self.assertLess(time.monotonic() - begin, 3)
            self.assertEqual(self.files(), [])

    def test_before_the_picture(self):
        """While a camera is looked for, in a terrain that takes long"""
        noises = ["n%d = warp(noise(size=%d, octaves=32, lacunarity=1.2), "
                  "noise(size=50, octaves=20, lacunarity=1.2, amplitude=3))\n" % (i, 100 + i)
                  for i in range(12)]
        with open(self.path("r.recipe"), "w", encoding="utf-8") as file:
            file.write("recipe 1\n" + "".join(noises) +
                       "out h = 10 * (%s)\n" % " + ".join("n%d" % i for i in range(12)))
        for pause in (0.2, 1, 2):
            process = start("view", "--recipe", "r.recipe", "--isa", "scalar", "--output", "v.ppm",
                            cwd=self.directory)
            time.sleep(pause)
            begin = time.monotonic()
            process.send_signal(signal.SIGINT)
            self.check_ended(process, signal.SIGINT)
            self.assertLess(time.monotonic() - begin, 15)
            self.assertEqual(self.files(), ["r.recipe"])

    def full_pipe(self, *arguments, **more):
        """Starts a run, and waits until it waits for whoever reads its standard output."""
        reading, writing = os.pipe()
        self.addCleanup(os.close, reading)
        process = self.begin(*arguments, stdout=writing, **more)
        os.close(writing)
        seen = []

        def is_full():
            waiting = int.from_bytes(fcntl.ioctl(reading, termios.FIONREAD, bytes(4)),
                                     sys.byteorder)
            seen.append(waiting)
            time.sleep(0.005)
            return len(seen) > 20 and waiting > 0 and set(seen[-20:]) == {waiting}
        self.wait_for(is_full, seen)
        return process, reading

    def test_full_pipe(self):
        """A write that waits ends, whichever thread waits there and however much was written."""
        waits = [(arguments, threads) for threads in (("1", "2", "5") if has_threads() else ("1",))
                 for arguments in (("--heights", "r32:-"), ("--heights", "pgm:-"),
                                   ("--normals", "npy:-"), ("--heights", "h.r32", "--hillshade",
                                                            "pgm:-", "--gradient", "g.npy"))]
        for i, (arguments, threads) in enumerate(waits):
            with self.subTest(arguments=arguments, threads=threads):
                process, _ = self.full_pipe("--size", "900x900", "--octaves", "1", *arguments,
                                            "--threads", threads)
                begin = time.monotonic()
                number = SIGNALS[i % len(SIGNALS)]
                process.send_signal(number)
                self.check_ended(process, number)
                self.assertLess(time.monotonic() - begin, 10)
                self.assertEqual(self.files(), [])

    def test_any_moment(self):
        """Just before a write that would wait for ever, too."""
        threads = ("--threads", "2") if has_threads() else ()
        for i in range(200 if common.SPEED == "full" else 40):
            reading, writing = os.pipe()
            process = self.begin("--size", "900x900", "--octaves", "1", "--normals", "npy:-",
                                 *threads, stdout=writing, stderr=subprocess.DEVNULL)
            os.close(writing)
            time.sleep(i % 40 * 0.0005)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(PATIENCE), -signal.SIGINT)
            os.close(reading)

    def test_full_pipe_png(self):
        if not common.has_png():
            self.skipTest("needs zlib")
        process, _ = self.full_pipe("--size", "900x900", "--octaves", "9", "--heights", "png:-")
        process.send_signal(signal.SIGINT)
        self.check_ended(process, signal.SIGINT)

    def test_named_pipe_without_reader(self):
        """Opening it waits."""
        os.mkfifo(self.path("p"))
        process = self.begin("--size", "9x9", "--heights", "h.r32", "--normals", "npy:p")
        self.wait_for_unfinished("h.r32")
        time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        self.check_ended(process, signal.SIGINT)
        self.assertEqual(self.files(), ["p"])

    def test_stopped_and_continued(self):
        """That is no request to end: the file is whole."""
        process, reading = self.full_pipe("--size", "400x400", "--octaves", "1", "--heights",
                                          "r32:-")
        process.send_signal(signal.SIGSTOP)
        time.sleep(0.05)
        process.send_signal(signal.SIGCONT)
        with os.fdopen(os.dup(reading), "rb") as file:
            data = file.read()
        process.wait(PATIENCE)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(data == self.layer("--heights", "h.r32", "--size", "400x400", "--octaves",
                                            "1"), True)

    def test_time_is_up(self):
        """The system itself tells a process that it has had its share of the processors."""
        process = self.begin(*LONG, *FILES, preexec_fn=common.limits(CPU=(1, 60)))
        self.check_ended(process, signal.SIGXCPU)
        self.assertEqual(self.files(), [])

    def test_ignored(self):
        """As by nohup: what is ignored when the program starts stays so."""
        def ignore():
            for number in SIGNALS:
                signal.signal(number, signal.SIG_IGN)

        process, reading = self.full_pipe("--size", "400x400", "--octaves", "1", "--heights",
                                          "r32:-", preexec_fn=ignore)
        for number in SIGNALS:
            process.send_signal(number)
        time.sleep(0.05)
        with os.fdopen(os.dup(reading), "rb") as file:
            self.assertEqual(len(file.read()), 400 * 400 * 4)
        self.assertEqual(process.wait(PATIENCE), 0)

    def test_on_terminal(self):
        """The message has a line of its own."""
        ours, theirs = common.pty.openpty()
        self.addCleanup(os.close, ours)
        process = self.begin(*LONG[:-1], *FILES, stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        self.wait_for_unfinished("g.hdr")
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(PATIENCE), -signal.SIGINT)
        self.assertRegex(os.read(ours, 4096).decode(),
                         r"\A0[.\d]*\r\nscarp: interrupted: [^\n]*\r\n\Z")


common.main(globals())
