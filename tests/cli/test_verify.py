# SPDX-License-Identifier: MIT
"""Checksums of a world, and whether its files fit on the disk."""
import os
import re
import shutil
import subprocess
import unittest

import common
from common import Case, run
from rasters import read_bytes

WORLD = ("--size", "40x30", "--tile", "20x15", "--frequency", "0.03", "--octaves", "3")
FILES = ("--heights", "w/{y}/{x}.img", "--relief", "w/{y}/{x}.npy")
MASK = 2 ** 64 - 1
P1, P2, P3, P4, P5 = (0x9E3779B185EBCA87, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9,
                      0x85EBCA77C2B2AE63, 0x27D4EB2F165667C5)


def turn(x, bits):
    return (x << bits | x >> (64 - bits)) & MASK


def xxh64(data):
    """Of the description "xxHash fast digest algorithm", version 0.1.1, with seed 0"""
    def take(lane, number):
        return turn((lane + number * P2) & MASK, 31) * P1 & MASK

    def number(at, size):
        return int.from_bytes(data[at:at + size], "little")
    lanes, at = [(P1 + P2) & MASK, P2, 0, -P1 & MASK], 0
    while len(data) - at >= 32:
        lanes = [take(lane, number(at + 8 * i, 8)) for i, lane in enumerate(lanes)]
        at += 32
    total = P5
    if at > 0:
        total = sum(turn(lane, bits) for lane, bits in zip(lanes, (1, 7, 12, 18))) & MASK
        for lane in lanes:
            total = ((total ^ take(0, lane)) * P1 + P4) & MASK
    total = (total + len(data)) & MASK
    while len(data) - at >= 8:
        total = (turn(total ^ take(0, number(at, 8)), 27) * P1 + P4) & MASK
        at += 8
    if len(data) - at >= 4:
        total = (turn(total ^ number(at, 4) * P1 & MASK, 23) * P2 + P3) & MASK
        at += 4
    for byte in data[at:]:
        total = turn(total ^ byte * P5 & MASK, 11) * P1 & MASK
    total = (total ^ total >> 33) * P2 & MASK
    total = (total ^ total >> 29) * P3 & MASK
    return total ^ total >> 32


class Verify(Case):
    """--verify"""

    def sums(self, name):
        """The lines of a file of checksums: hashes by path"""
        lines = self.bytes(name).decode().splitlines()
        for line in lines:
            self.assertRegex(line, r"\A[0-9a-f]{16}  [^ ]+\Z")
        return {line[18:]: int(line[:16], 16) for line in lines}

    def verify(self, *more, status=0):
        before = {path: read_bytes(path) for path in self.walk()}
        result = run("terrain", *WORLD, *FILES, "--verify", *more, cwd=self.directory)
        self.assertEqual({path: read_bytes(path) for path in self.walk()}, before)
        self.assertEqual(result.returncode, status, result)
        return (result.stderr if status else result.stdout).decode()

    def walk(self):
        return [os.path.join(directory, name) for directory, _, names in os.walk(self.directory)
                for name in names]

    def write(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)

    def test_hashes(self):
        """They are XXH64 of files of many lengths, by names as seen from there, and of all files."""
        self.assertEqual(xxh64(b""), 0xEF46DB3751D8E999)
        self.assertEqual(xxh64(b"Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1)
        self.quietly(*WORLD, *FILES)
        found = self.sums("w/y_x.img.sums")
        self.assertEqual(len(found), 4 * 3)
        for name, value in found.items():
            self.assertEqual(value, xxh64(self.bytes(os.path.join("w", name))), name)
        for width in range(1, 40):
            self.quietly("--size", "%dx1" % width, "--hillshade", "s.npy", "--heights", "s.r16",
                         "--resume")
            for name, value in self.sums("s.r16.sums").items():
                self.assertEqual(value, xxh64(self.bytes(name)), (name, width))
            for name in ("s.npy", "s.r16", "s.r16.json", "s.r16.sums"):
                os.remove(self.path(name))

    @unittest.skipUnless(shutil.which("xxhsum"), "no xxhsum here")
    def test_xxhsum(self):
        self.quietly(*WORLD, *FILES)
        subprocess.run(["xxhsum", "-c", "-q", "y_x.img.sums"], cwd=self.path("w"), check=True)

    def test_whole(self):
        """What was written is right, by whatever shares, and a share looks at its own."""
        for share in ("1/3", "0/3", "2/3"):
            self.quietly(*WORLD, *FILES, "--share", share)
        self.assertEqual(sorted(name for name in os.listdir(self.path("w")) if "sums" in name),
                         ["y_x.img.%d-3.sums" % i for i in range(3)])
        self.assertRegex(self.verify(), r"\A12 files, \d+\.\d\d kB: as they were written\n\Z")
        self.assertRegex(self.verify("--share", "0/3"), r"\A6 files")
        self.assertEqual(self.verify("--quiet"), "")

    def test_damage(self):
        self.quietly(*WORLD, *FILES)
        whole = self.bytes("w/1/0.img")
        self.write("w/1/0.img", whole[:-1] + bytes([whole[-1] ^ 1]))
        header = self.bytes("w/0/1.hdr")
        self.write("w/0/1.hdr", header + b"\n")
        os.remove(self.path("w/0/0.npy"))
        told = self.verify(status=1).splitlines()
        self.assertEqual(told, [
            "scarp: w/0/0.npy: is missing", "scarp: w/0/1.hdr: differs from what was written",
            "scarp: w/1/0.img: differs from what was written",
            "scarp: --verify: of 12 files 1 are missing, 2 changed and 0 without a checksum"])
        os.remove(self.path("w/0/1.hdr"))
        os.remove(self.path("w/1/0.img"))
        self.quietly(*WORLD, *FILES, "--resume")
        self.assertIn("12 files", self.verify())

    def test_lines(self):
        """Of two lines of one file either is right; what is no line is left out, and a file
        without a line is told."""
        self.quietly(*WORLD, *FILES)
        name = "w/y_x.img.sums"
        lines = self.bytes(name).splitlines(True)
        other = b"0" * 16 + lines[0][16:]
        self.write(name, b"".join([other, *lines, other, b"torn 12345", b"\n", lines[3][:20]]))
        self.assertIn("12 files", self.verify())
        self.write(name, b"".join(lines[1:]))
        self.assertIn("1 without a checksum", self.verify(status=1))
        self.write("w/y_x.img.7-9.sums", lines[0])
        self.write("w/y_x.img.other.sums", b"\0" * 100)
        self.assertIn("12 files", self.verify())
        os.remove(self.path(name))
        self.assertIn("11 without a checksum", self.verify(status=1))

    def test_older_world(self):
        """A file that is older than the manifest is not of this world."""
        self.quietly(*WORLD, *FILES)
        os.utime(self.path("w/0/0.npy"), (1, 1))
        self.assertIn("w/0/0.npy: is older", self.verify(status=1))

    def test_levels(self):
        arguments = ("--size", "40x30", "--levels", "3", "--heights", "h.r32", "--resume")
        self.quietly(*arguments)
        self.assertEqual(sorted(self.sums("h.r32.sums")), ["h-level1.r32", "h-level2.r32", "h.r32"])
        result = run("terrain", *arguments, "--verify", cwd=self.directory)
        self.assertRegex(result.stdout.decode(), r"\A3 files")

    def test_failed_run(self):
        """A run that wrote nothing leaves no checksums."""
        os.mkdir(self.path("w_0_0.r32"))
        result = run("terrain", *WORLD, "--heights", "w.r32", cwd=self.directory)
        self.check_one_line(result, 2, "--heights")
        self.assertEqual(os.listdir(self.directory), ["w_0_0.r32"])

    def test_refused(self):
        result = run("terrain", *WORLD, *FILES, "--verify", cwd=self.directory)
        self.check_one_line(result, 2, "--heights", "w/y_x.img.json")
        result = run("terrain", "--heights", "h.r32", "--verify", cwd=self.directory)
        self.check_one_line(result, 2, "--verify", "--tile or --resume")
        self.assertEqual(os.listdir(self.directory), [])
        self.quietly(*WORLD, *FILES)
        result = run("terrain", *WORLD, *FILES, "--verify", "--seed", "2", cwd=self.directory)
        self.check_one_line(result, 2, "another world", "--seed")


class Space(Case):
    """What does not fit is refused before anything is written."""

    def test_refused(self):
        for arguments, words in (
                (("--size", "1000000x1000000", "--heights", "h.r32"),
                 ("--heights: 4.00 TB", "are free")),
                (("--size", "1000000x1000000", "--tile", "10000x10000", "--heights", "h.png",
                  "--normals", "w/{y}/{x}.npy"), ("--normals: 12.00 TB",)),
                (("--size", "1000000x900000", "--levels", "2", "--heights", "h.img"),
                 ("--heights: 4.50 TB",)),
                (("--size", "1000000x1000000", "--tile", "5000x5000", "--share", "0/2",
                  "--heights", "r32:h"), ("--heights: 2.00 TB",))):
            if "h.png" in arguments and not common.has_png():
                continue
            with self.subTest(arguments=arguments):
                result = run("terrain", *arguments, cwd=self.directory)
                self.check_one_line(result, 2, *words)
                self.assertEqual(os.listdir(self.directory), [])

    @unittest.skipUnless(common.pty, "needs POSIX")
    def test_told(self):
        """A line before a large run: bytes, tiles, free space; what is there does not count."""
        arguments = ("--size", "20000x20000", "--tile", "10000x10000", "--octaves", "1",
                     "--heights", "h.r32")
        if shutil.disk_usage(self.directory).free < 3e9:
            self.skipTest("the disk is too full")
        for there, told in ((0, "1.60 GB in 4 tiles"), (1, "1.20 GB in 4 tiles")):
            if there:
                with open(self.path("h_0_0.r32"), "wb") as file:
                    file.truncate(400000000)
            process = common.start("terrain", *arguments, cwd=self.directory)
            line = process.stdout.readline().decode()
            process.terminate()
            process.communicate()
            self.assertRegex(line, r"\Ato write: %s; free: \d+\.\d\d [GT]B\n\Z" % told)
            self.assertNotIn("h.r32.json", self.files())

    def test_small(self):
        """Small runs, and those to standard output, say nothing."""
        result = run("terrain", "--size", "400x400", "--octaves", "1", "--heights", "h.r32",
                     cwd=self.directory)
        self.assertEqual(len(re.findall("\n", result.stdout.decode())), 1)


common.main(globals())
