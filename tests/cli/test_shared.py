# SPDX-License-Identifier: MIT
"""Files that somebody else has to do with: another run, a link, another user."""
import os
import re
import socket
import stat
import subprocess
import unittest

import common
from common import SMALL, Case, run, start
from rasters import read_bytes

try:
    import fcntl
except ImportError:
    fcntl = None

LARGE = ["--size", "400x300"]  # normals fill a pipe


@unittest.skipUnless(common.resource, "needs POSIX")
class Shared(Case):
    def read_file(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def write_file(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)

    def hold(self, *arguments, size=LARGE):
        """Starts a run that a pipe holds up until it is read."""
        if not os.path.exists(self.path("pipe")):
            os.mkfifo(self.path("pipe"))
        return start("terrain", *size, *arguments, "--normals", "npy:pipe", "--quiet",
                     cwd=self.directory)

    def test_two_runs(self):
        """Each has a file of its own; what ends last stays, whole."""
        for seed in ("1", "9"):
            self.quietly(*LARGE, "--seed", seed, "--heights", "r32:whole" + seed)
        first = self.hold("--heights", "r32:a")
        with open(self.path("pipe"), "rb") as pipe:  # waits for the first run to open it
            self.assertEqual(len(self.unfinished("a")), 1)
            self.quietly(*LARGE, "--seed", "9", "--heights", "r32:a")
            self.assertEqual(self.read_file("a"), self.read_file("whole9"))
            self.assertEqual(len(self.unfinished("a")), 1)
            pipe.read()
        self.assertEqual((*first.communicate(), first.returncode), (b"", b"", 0))
        self.assertEqual(self.read_file("a"), self.read_file("whole1"))
        self.assertEqual(self.unfinished(), [])

    def test_one_file_by_two_names(self):
        os.symlink("a.npy", self.path("b.npy"))
        os.symlink(".", self.path("here"))
        os.symlink("nowhere.npy", self.path("c.npy"))
        for names in (("a.npy", "./a.npy"), ("a.npy", "b.npy"), ("b.npy", "here/a.npy"),
                      ("c.npy", "nowhere.npy"), ("img:a.hdr", "img:a.img")):
            with self.subTest(names=names):
                result = run("terrain", *SMALL, "--heights", names[0], "--gradient", names[1],
                             cwd=self.directory)
                self.check_one_line(result, 2, "--gradient", names[1].split(":")[-1],
                                    "another option")
                self.assertEqual(self.files(), ["b.npy", "c.npy", "here"])

    def test_links_in_the_way(self):
        """Nobody else's file is written, whatever it is called."""
        self.write_file("victim", b"secret")
        os.symlink("victim", self.path("a.r32.part"))
        os.mkfifo(self.path("b.r32.part"))
        self.write_file("c.r32.part", b"mine")
        for name in ("a.r32", "b.r32", "c.r32"):
            self.quietly(*SMALL, "--heights", name)
            self.assertEqual(len(self.read_file(name)), 40 * 30 * 4)
        self.assertEqual((self.read_file("victim"), self.read_file("c.r32.part")),
                         (b"secret", b"mine"))
        self.assertEqual(self.unfinished(), ["a.r32.part", "b.r32.part", "c.r32.part"])

    def test_after_a_killed_run(self):
        """What it left goes with the next run in that directory; what a living one has stays."""
        living = self.hold("--heights", "r32:b")
        with open(self.path("pipe"), "rb") as pipe:
            dead = self.hold("--heights", "r32:a")
            self.wait_for_unfinished("a")
            dead.kill()
            dead.communicate()
            self.quietly(*SMALL, "--heights", "r32:c")
            self.assertEqual([len(self.unfinished(name)) for name in "abc"], [0, 1, 0])
            pipe.read()
        self.assertEqual((*living.communicate(), living.returncode), (b"", b"", 0))
        self.assertEqual(self.files(), ["b", "c", "pipe"])

    @unittest.skipUnless(os.path.exists("/proc/self/stat"), "needs Linux's /proc")
    def test_after_a_zombie(self):
        """A killed process is dead, too, while nobody has asked for its status."""
        dead = self.hold("--heights", "r32:a")
        self.addCleanup(dead.communicate)
        self.wait_for_unfinished("a")
        dead.kill()
        self.wait_for(lambda: read_bytes("/proc/%d/stat" % dead.pid).split()[2] == b"Z")
        self.quietly(*SMALL, "--heights", "r32:c")
        self.assertEqual(self.unfinished(), [])

    def test_after_the_same_number(self):
        """In a container that is started again, the new process has the number of the dead one.
        What somebody has locked stays also then."""
        host = re.sub("[^A-Za-z0-9.]", "_", socket.gethostname())[:64]
        with open(self.path("locked"), "wb") as locked:
            fcntl.flock(locked, fcntl.LOCK_EX)
            script = ('touch "x.$0-$$-0123456789abcdef.part"; '
                      'mv locked "y.$0-$$-0123456789abcdef.part"; exec "$@"')
            subprocess.run(["sh", "-c", script, host, *common.PROGRAM, "terrain", *SMALL,
                            "--heights", "r32:c", "--quiet"], cwd=self.directory, check=True)
            (name,) = self.unfinished()
            self.assertEqual(name[0], "y")

    def test_locked_file_stays(self):
        """Its process may be in a container, where it cannot be seen."""
        dead = self.hold("--heights", "r32:a")
        self.wait_for_unfinished("a")
        dead.kill()
        dead.communicate()
        (name,) = self.unfinished()
        with open(self.path(name), "ab") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            self.quietly(*SMALL, "--heights", "r32:c")
            self.assertEqual(self.unfinished(), [name])
        self.quietly(*SMALL, "--heights", "r32:c")
        self.assertEqual(self.unfinished(), [])

    def test_other_names_stay(self):
        """Those of other machines, of living processes, and whatever only resembles them."""
        dead = start("info")
        dead.communicate()
        host = re.sub("[^A-Za-z0-9.]", "_", socket.gethostname())[:64]
        number = "0123456789abcdef"
        stale = "x.%s-%d-%s.part" % (host, dead.pid, number)
        names = ["x.%s-%d-%s.part" % (host, os.getpid(), number),
                 "x.elsewhere-%d-%s.part" % (dead.pid, number),
                 "x.%s-%d-%s.part" % (host, dead.pid, number[1:]),
                 "x.%s-%d-%s" % (host, dead.pid, number),
                 "%s-%d-%s.part" % (host, dead.pid, number), "x.r32.part"]
        for name in [stale, *names]:
            self.write_file(name, b"mine")
        self.quietly(*SMALL, "--heights", "a.r32")
        self.assertEqual(self.files(), sorted(["a.r32", *names]))

    def test_long_names(self):
        """The unfinished name is no longer than the system allows."""
        for name in ("n" * 251 + ".r32", "\u00fc" * 125 + ".r32"):
            self.quietly(*SMALL, "--heights", name)
            self.assertEqual(len(self.read_file(name)), 40 * 30 * 4)

    def test_mode(self):
        """A file keeps the permissions that it had; a new one has what the umask leaves."""
        self.quietly(*SMALL, "--heights", "new.r32", preexec_fn=lambda: os.umask(0o027))
        self.assertEqual(stat.S_IMODE(os.stat(self.path("new.r32")).st_mode), 0o640)
        for mode in (0o600, 0o664, 0o755):
            os.chmod(self.path("new.r32"), mode)
            self.quietly(*SMALL, "--seed", str(mode), "--heights", "new.r32")
            self.assertEqual(stat.S_IMODE(os.stat(self.path("new.r32")).st_mode), mode)

    def test_hard_link(self):
        """The other names keep the old contents."""
        self.write_file("a.r32", b"old")
        os.link(self.path("a.r32"), self.path("b.r32"))
        self.quietly(*SMALL, "--heights", "a.r32")
        self.assertEqual(self.read_file("b.r32"), b"old")
        self.assertEqual(len(self.read_file("a.r32")), 40 * 30 * 4)

    def test_link_to_nothing(self):
        """What it leads to is made."""
        os.mkdir(self.path("real"))
        os.symlink(os.path.join("real", "r.r32"), self.path("link.r32"))
        os.symlink("link.r32", self.path("again.r32"))
        self.quietly(*SMALL, "--heights", "again.r32")
        self.assertEqual(os.listdir(self.path("real")), ["r.r32"])
        os.symlink("round.r32", self.path("round.r32"))
        result = run("terrain", *SMALL, "--heights", "round.r32", cwd=self.directory)
        self.check_one_line(result, 2, "--heights", "round.r32")

    def test_link(self):
        """What it leads to is replaced."""
        os.mkdir(self.path("real"))
        self.write_file("real/r.r32", b"old")
        os.symlink(os.path.join("real", "r.r32"), self.path("link.r32"))
        self.quietly(*SMALL, "--heights", "link.r32")
        self.assertTrue(os.path.islink(self.path("link.r32")))
        self.assertEqual(len(self.read_file("real/r.r32")), 40 * 30 * 4)
        self.assertEqual(os.listdir(self.path("real")), ["r.r32"])

    def test_name_is_taken(self):
        """By a directory, while the run goes on: what has its name by then stays, and is whole."""
        self.write_file("h.r32", b"old")
        os.mkfifo(self.path("pipe"))
        first = start("terrain", *LARGE, "--heights", self.path("h.r32"), "--normals",
                      self.path("n.npy"), "--gradient", "npy:" + self.path("pipe"), "--quiet")
        with open(self.path("pipe"), "rb") as pipe:
            os.makedirs(self.path("n.npy/taken"))
            pipe.read()
        error = first.communicate()[1].decode()
        self.assertEqual(first.returncode, 1)
        self.assertRegex(error, r"\Ascarp: --normals: [^\n]*n\.npy: [^\n]+\n\Z")
        self.assertEqual(self.files(), ["h.r32", "n.npy", "pipe"])
        self.assertEqual(len(self.read_file("h.r32")), 400 * 300 * 4)

    def test_header_of_envi(self):
        """Without it, the raster is not complete."""
        self.quietly(*SMALL, "--heights", "a.IMG")
        self.assertEqual(self.files(), ["a.IMG", "a.hdr"])
        os.remove(self.path("a.hdr"))
        self.quietly(*SMALL, "--heights", "a.IMG", "--resume")
        self.assertEqual(self.files(), ["a.IMG", "a.IMG.json", "a.hdr"])

    @unittest.skipUnless(os.path.exists("/dev/stdout"), "needs /dev/stdout")
    def test_device(self):
        """The closing line does not follow what went to standard output under another name."""
        result = run("terrain", "--size", "2x1", "--heights", "r32:/dev/stdout")
        self.assertEqual((result.returncode, len(result.stdout)), (0, 8))


common.main(globals())
