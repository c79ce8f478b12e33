# SPDX-License-Identifier: MIT
"""What is special about Windows: paths, standard streams, locks, Ctrl-C. Under wine, a path of
Linux is one of the drive Z:."""
import os
import re
import signal

import common
from common import SMALL, Case, run, start

ENDED_BY_CONTROL_C = 0xC000013A


class Windows(Case):
    def check_heights(self, path):
        os.makedirs(os.path.dirname(self.path(path)), exist_ok=True)
        self.quietly(*SMALL, "--heights", path)
        self.assertEqual(self.bytes(path), self.layer("--heights", "plain.r32", *SMALL))

    def test_characters(self):
        """Files are replaced, and messages name them as the user did."""
        path = os.path.join("Gr\u00f6\u00dfe", "\u5c71 \U0001f3d4", "h\u00f6hen.r32")
        self.check_heights(path)
        self.quietly(*SMALL, "--seed", "1", "--heights", path)
        self.check_heights(path)
        result = run("terrain", "--heights", path + "/", cwd=self.directory)
        self.check_one_line(result, 2, path)
        result = run("sample", "--input", "\u00f6.csv", cwd=self.directory)
        self.check_one_line(result, 2, "\u00f6.csv", "No such file or directory")

    def test_long_path(self):
        """Longer than the 260 characters that most calls of Windows take"""
        parts = ["a directory with a long name, number %02d of many" % i for i in range(10)]
        self.assertGreater(len(os.path.join(*parts)), 400)
        pattern = os.path.join(*parts, "{x}-{y}")
        for _ in range(2):
            self.quietly("--size", "32x32", "--tile", "16x16", "--resume", "--heights",
                         pattern + ".r32", "--gradient", pattern + ".npy")
        # Besides tiles, the manifest and the checksums
        self.assertEqual(len(os.listdir(self.path(os.path.join(*parts)))), 4 * 2 + 2)
        path = os.path.join(*parts, "\u00e4.r32")
        self.check_heights(path)
        self.check_heights(path)

    def test_drive(self):
        """The drive is there already; the directories on it are made."""
        path = "Z:" + self.path("new/one/{x}-{y}.r32").replace("/", "\\")
        self.quietly(*SMALL, "--tile", "40x30", "--heights", path)
        self.assertEqual(self.bytes("new/one/0-0.r32"),
                         self.layer("--heights", "plain.r32", *SMALL))

    def test_refused(self):
        os.mkdir(self.path("here"))
        for path in ("here", "here\\", "no:such/file.r32", "a?.r32"):
            with self.subTest(path=path):
                result = run("terrain", *SMALL, "--heights", "r32:" + path, cwd=self.directory)
                self.check_one_line(result, 2, "--heights")
                self.assertEqual(self.files(), ["here"])
        self.assertEqual(os.listdir(self.path("here")), [])

    def test_capitals_are_the_same_name(self):
        result = run("terrain", *SMALL, "--normals", "a.npy", "--gradient", "A.NPY",
                     cwd=self.directory)
        self.check_one_line(result, 2, "already written by another option")
        self.assertEqual(self.files(), [])

    def test_bytes_are_left_alone(self):
        """No end of a line becomes two characters, no Ctrl-Z ends an input."""
        result = run("terrain", *SMALL, "--heights", "r32:-", "--quiet", cwd=self.directory)
        self.assertEqual(result.stdout, self.layer("--heights", "plain.r32", *SMALL))
        self.quietly(*SMALL, "--tile", "20x20", "--heights", "{x}-{y}.img")
        texts = [name for name in self.files() if name.endswith((".hdr", ".json"))]
        self.assertGreater(len(texts), 4)
        texts = [self.bytes(name) for name in texts]
        texts += [run("--help").stdout, run("sample", input=b"x,y\n\n1,2\n").stdout]
        for text in texts:
            self.assertIn(b"\n", text)
            self.assertNotIn(b"\r", text)
        points = b"\x93NUMPY\x01\x00\x76\x00"
        points += b"{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }".ljust(117) + b"\n"
        points += b"\x1a\r\n\x1a\r\n\x1a\x40" * 6
        result = run("sample", "--output-format", "csv", input=points)
        self.assertEqual((result.returncode, result.stdout.count(b"\n")), (0, 4), result)

    def test_closed_pipe(self):
        process = start("terrain", "--size", "900x900", "--quiet", "--heights", "r32:-",
                        cwd=self.directory)
        process.stdout.read(100)
        process.stdout.close()
        error = process.stderr.read()
        process.stderr.close()
        self.assertEqual(process.wait(), 1)
        self.assertEqual(error, b"scarp: --heights: standard output: Broken pipe\n")

    def start_long(self):
        """A run that would take minutes, in directories that it has made"""
        process = start("terrain", "--size", "9000x9000", "--tile", "9000x9000", "--octaves",
                        "16", "--rotate", "--heights", "made/by/it/{x}-{y}.r32", cwd=self.directory)
        made = self.path("made/by/it")
        self.wait_for(lambda: os.path.isdir(made) and self.being_written(made), made)
        return process

    def being_written(self, made):
        """What it writes; the description of all tiles may be next to that, finished or not."""
        return [name for name in os.listdir(made) if name.startswith("0-0.r32") and name.endswith(".part")]

    def kill(self, process):
        process.kill()
        process.wait()
        process.stdout.close()
        process.stderr.close()

    def test_control_c(self):
        process = self.start_long()
        process.send_signal(signal.SIGINT)  # which wine passes on as Ctrl-C
        _, error = process.communicate()
        self.assertRegex(error, b"^scarp: interrupted: unfinished files are removed[^\n]*\n$")
        self.assertEqual(process.returncode & 0xff, ENDED_BY_CONTROL_C & 0xff)
        self.assertEqual(self.files(), [])

    def test_killed(self):
        """The next run removes what a killed one left."""
        process = self.start_long()
        self.kill(process)
        made = self.path("made/by/it")
        self.assertEqual(len(self.being_written(made)), 1)
        self.quietly(*SMALL, "--heights", "made/by/it/other.r32")
        self.assertEqual(self.being_written(made), [])
        self.assertIn("other.r32", os.listdir(made))

    def test_living_files_stay(self):
        process = self.start_long()
        self.quietly(*SMALL, "--heights", "made/by/it/other.r32")
        left = os.listdir(self.path("made/by/it"))
        self.kill(process)
        self.assertIn("other.r32", left)
        self.assertTrue([name for name in left if name.endswith(".part")], left)

    def test_two_runs_share_tiles(self):
        """Locks show them which tiles the other one is at: none is written twice."""
        arguments = ["terrain", "--size", "256x256", "--octaves", "16", "--tile", "32x32", "--resume",
                     "--threads", "1", "--heights", "{x}-{y}.r32"]
        runs = [start(*arguments, cwd=self.directory) for _ in range(2)]
        written = 0
        for process in runs:
            told, error = process.communicate()
            self.assertEqual((process.returncode, error), (0, b""))
            written += sum(int(n) for n in re.findall(r"(\d+) tiles?\b", told.decode()))
        self.assertEqual(written, 64)
        self.assertEqual(len([name for name in self.files() if name.endswith(".r32")]), 64)
        self.assertEqual(self.unfinished(), [])


common.main(globals())
