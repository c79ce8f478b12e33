# SPDX-License-Identifier: MIT
"""Files of one world: their manifest, their names by patterns, and runs that share them."""
import json
import os
import re
import signal
import subprocess
import time
import unittest

import common
from common import Case, run, start

TERRAIN = ("--size", "40x30", "--tile", "10x10", "--frequency", "0.03", "--octaves", "3")
TILES = [(y, x) for y in range(3) for x in range(4)]
POSIX = unittest.skipUnless(common.pty, "needs POSIX")


class WorldCase(Case):
    def walk(self):
        """All files below the test's directory but checksums, with their bytes"""
        found = {}
        for directory, _, names in os.walk(self.directory):
            for name in names:
                path = os.path.join(directory, name)
                if name.endswith(".sums"):
                    continue
                with open(path, "rb") as file:
                    found[os.path.relpath(path, self.directory)] = file.read()
        return found

    def walk_files(self):
        """The same without pipes and what is not complete"""
        return {name: self.bytes(name) for name in self.files()
                if os.path.isfile(self.path(name)) and not name.endswith(".part")}

    def directories(self):
        return sorted(os.path.relpath(os.path.join(directory, name), self.directory)
                      for directory, names, _ in os.walk(self.directory) for name in names)

    def refused(self, *arguments, words=()):
        """The run is refused, and nothing changes."""
        before, directories = self.walk(), self.directories()
        result = run("terrain", *arguments, cwd=self.directory)
        error = self.check_one_line(result, 2, *words)
        self.check_same_files(self.walk(), before)
        self.assertEqual(self.directories(), directories)
        return error

    def write(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)

    def manifest(self, name="w.r32.json"):
        return json.loads(self.bytes(name))


class Manifest(WorldCase):
    """What all files of a world have in common is next to them, and no other world joins."""

    def test_contents(self):
        self.quietly(*TERRAIN, "--seed", "18446744073709551615", "--overlap", "1", "--origin",
                     "-7.25,1e9", "--height", "0.1", "--sea-level", "-0.25", "--rotate",
                     "--amplitude", "-3", "--normal-y", "down",
                     "--heights", "w.r32", "--normals", "npy:n.v1", "--hillshade", "s.img")
        found = self.manifest()
        derived = found.pop("derived")
        self.assertEqual(found, {
            "manifest": 1, "scarp": re.search(r"[\d.]+", common.text_of("--version")).group(),
            "size": [40, 30], "tile": [10, 10], "overlap": 1, "origin": [-7.25, 1e9], "step": 1,
            "period": [0, 0], "tileable": False, "height": 0.1, "sea-level": -0.25, "plateau": None,
            "scale": 1, "recipe": None, "set": {}, "compare": 0, "normal-y": "down",
            "azimuth": 315, "altitude": 45, "z-factor": 1, "seed": 18446744073709551615,
            "basis": "gradient", "jitter": 1, "fade": "quintic", "fractal": "fbm", "erosion": 1,
            "sharpness": None, "frequency": 0.03, "octaves": 3, "of-octaves": None, "lacunarity": 2, "gain": 0.4, "amplitude": -3,
            "phase": None, "rotate": True, "heights": "w_{y}_{x}.r32", "normals": "npy:n_{y}_{x}.v1",
            "hillshade": "s_{y}_{x}.img", "relief": None, "palette": None, "gradient": None,
            "slope": None, "curvature": None, "out": [], "masks": None, "output": None, "levels": 1,
            "band-limit": False, "crs": None})
        self.assertEqual(derived["tiles"], [4, 3])
        self.assertEqual([common.rounded(height) for height in derived["range"]],
                         [common.rounded(-0.3), common.rounded(0.3)])
        self.assertEqual([common.rounded(height) for height in derived["16-bit heights"]],
                         [common.rounded(-0.025), common.rounded(0.3)])

    def test_every_option(self):
        """Whatever changes the bytes is refused, with its name and both values; what does not is
        not. An option that is neither here nor there fails this test."""
        self.quietly(*TERRAIN, "--heights", "w.r32", "--normals", "n.npy")
        files = ("--heights", "w.r32", "--normals", "n.npy")
        changes = {"size": ("40x29", "[40, 30]", "[40, 29]"), "origin": ("0,1", "[0, 0]", "[0, 1]"),
                   "step": ("2", "1", "2"), "height": ("7", "120", "7"),
                   "period": ("100x100", "[0, 0]", "[100, 100]"),
                   "sea-level": ("0.25", "null", "0.25"), "plateau": ("0.5", "null", "0.5"),
                   "normal-y": ("down", '"up"', '"down"'), "azimuth": ("0", "315", "0"),
                   "altitude": ("1", "45", "1"), "z-factor": ("3", "1", "3"),
                   "tile": ("10x11", "[10, 10]", "[10, 11]"), "overlap": ("1", "0", "1"),
                   "seed": ("2", "1", "2"), "basis": ("value", '"gradient"', '"value"'),
                   "jitter": ("0.5", "1", "0.5"), "fade": ("cubic", '"quintic"', '"cubic"'),
                   "fractal": ("ridged", '"fbm"', '"ridged"'), "erosion": ("2", "1", "2"),
                   "sharpness": ("2", "null", "2"), "of-octaves": ("4", "null", "4"),
                   "frequency": ("0.5", "0.03", "0.5"), "octaves": ("2.5", "3", "2.5"),
                   "lacunarity": ("3", "2", "3"), "gain": ("0.25", "0.4", "0.25"),
                   "amplitude": ("-1", "1", "-1"), "phase": ("0", "null", "0"), "rotate": (None, "false", "true"),
                   "scale": ("3", "1", "3"), "gradient": ("g.npy", "null", '"g_{y}_{x}.npy"'),
                   "hillshade": ("s.npy", "null", '"s_{y}_{x}.npy"'),
                   "relief": ("c.npy", "null", '"c_{y}_{x}.npy"'),
                   "slope": ("d.npy", "null", '"d_{y}_{x}.npy"'),
                   "curvature": ("e.npy", "null", '"e_{y}_{x}.npy"'),
                   "out": ("height=f.r32", "[]", '["height=f_{y}_{x}.r32"]'),
                   "masks": ("m.npy", "null", '"m-rock_{y}_{x}.npy"'),
                   "levels": ("2", "1", "2"), "band-limit": (None, "false", "true"),
                   "output": ("t", "null", '"t-height_{y}_{x}' + self.extensions[0] + '"')}
        same = {"tiles": "0:1,0:1", "share": "0/2", "threads": "1", "isa": "scalar",
                "preset": "none"}
        for name, (value, there, here) in changes.items():
            with self.subTest(option=name):
                words = ("w.r32.json", "--%s is %s there and %s here" % (name, there, here))
                arguments = ("--" + name, *([value] if value else []))
                self.refused(*TERRAIN, *files, *arguments, "--resume", words=words)
                self.refused(*TERRAIN, *files, *arguments, words=words)
        before = self.walk()
        for name, value in same.items():
            self.quietly(*TERRAIN, *files, "--" + name, value, "--resume")
        self.check_same_files(self.walk(), before)
        self.refused(*TERRAIN, "--heights", "w.r32", words=('"n_{y}_{x}.npy" there and null here',))
        self.refused(*TERRAIN, "--heights", "w.r32", "--normals", "npy:n", "--resume",
                     words=('"n_{y}_{x}.npy" there and "npy:n_{y}_{x}" here',))
        # test_period.py has --tileable, which is no option for this size, test_relief.py --palette,
        # test_recipe.py recipes, test_tiff.py --crs, test_verify.py --verify.
        rest = {"tileable", "palette", "recipe", "set", "print-recipe", "heights", "normals", "compare",
                "crs", "resume", "verify", "quiet", "help"}
        self.assertEqual(set(common.OPTIONS), set(changes) | set(same) | rest)

    def test_several_differences(self):
        self.quietly(*TERRAIN, "--heights", "w.r32")
        self.refused(*TERRAIN, "--heights", "w.r32", "--seed", "7", "--gain", "0.5", words=(
            "--seed is 1 there and 7 here; --gain is 0.4 there and 0.5 here",))

    def test_other_version(self):
        self.quietly(*TERRAIN, "--heights", "w.r32")
        for old, new, words in (
                (b'"scarp": "', b'"scarp": "9', ("scarp is \"9",)),
                (b'"manifest": 1', b'"manifest": 2', ("version 2", "version 1")),
                (b'"manifest": 1', b'"manifest": "x"', ("no manifest",)),
                (b'"manifest": 1,', b'', ("no manifest",)),
                (b'"gain": 0.4,', b'', ("--gain is nothing there and 0.4 here",)),
                (b'"gain": 0.4,', b'"gain": 0.4', ("not JSON",)),
                (b'}\n}', b'}\n} x', ("not JSON",)), (b'}\n}', b'}\n', ("not JSON",)),
                (b'{\n  "manifest"', b'[\n  "manifest"', ("not JSON",)),
                (b'"null"', b'', ()), (b': null', b': nul', ("not JSON",)),
                (b'"heights": "', b'"heights": "\\x', ("not JSON",)),
                (b'"manifest": 1', b'"manifest": 1.5', ("no manifest",)),
                (b'"seed": 1,', b'"seed": 1, "seed": 2,', ("--seed is 2 there and 1 here",)),
                (b'"seed": 1,', b'"seed": 1, "warp": 4,',
                 ("--warp is 4 there and nothing here",)),
                (b'}\n}', b'}\n}\0 x', ("not JSON",)),
                (b'"seed": 1', b'"seed": 01', ("not JSON",))):
            with self.subTest(new=new):
                text = self.bytes("w.r32.json")
                if old in text:
                    self.write("w.r32.json", text.replace(old, new, 1))
                    self.refused(*TERRAIN, "--heights", "w.r32", "--resume",
                                 words=("--heights: w.r32.json", *words))
                self.write("w.r32.json", text)
        for data in (b"rubbish", b"[" * 100000, b" " * 70000, b"{}", b"\0"):
            with self.subTest(data=data[:10]):
                self.write("w.r32.json", data)
                self.refused(*TERRAIN, "--heights", "w.r32", words=("--heights: w.r32.json",))

    def test_empty(self):
        """Where there are no hard links, a run that is killed may leave an empty one."""
        self.quietly(*TERRAIN, "--heights", "w.r32")
        expected = self.walk()
        for name in self.files():
            self.write(name, b"")
        self.quietly(*TERRAIN, "--heights", "w.r32", "--resume")
        self.check_same_files(self.walk(), expected)

    @POSIX
    def test_no_file(self):
        """What is no ordinary file is no manifest; nothing waits for a pipe."""
        for make in (os.mkdir, os.mkfifo):
            make(self.path("w.r32.json"))
            error = self.check_one_line(run("terrain", *TERRAIN, "--heights", "w.r32",
                                            cwd=self.directory, timeout=10), 2, "--heights")
            self.assertIn("w.r32.json is not JSON", error)
            self.assertEqual(self.files(), ["w.r32.json"])
            subprocess.run(["rm", "-r", self.path("w.r32.json")], check=True)

    def test_removed(self):
        """Without it, what is there is of unknown origin: the world begins anew."""
        self.quietly(*TERRAIN, "--heights", "w.r32")
        old = self.walk()
        os.remove(self.path("w.r32.json"))
        self.quietly(*TERRAIN, "--heights", "w.r32", "--resume", "--seed", "2")
        new = self.walk()
        self.assertEqual({name for name in old if old[name] == new[name]}, set())
        for name in new:
            os.remove(self.path(name))
        self.quietly(*TERRAIN, "--heights", "w.r32", "--seed", "2")
        self.check_same_files(self.walk(), new)

    @POSIX
    def test_times(self):
        """What is of an older world stays so when its time is set to come, and a manifest from
        the future keeps no run from finding its tiles."""
        self.quietly(*TERRAIN, "--heights", "w.r32", "--seed", "2")
        expected = self.walk()
        self.clear()
        self.quietly(*TERRAIN, "--heights", "w.r32")
        os.remove(self.path("w.r32.json"))
        later = time.time() + 1e6
        for name in self.files():
            os.utime(self.path(name), (later, later))
        time.sleep(0.02)  # some systems count time in larger steps
        self.quietly(*TERRAIN, "--heights", "w.r32", "--seed", "2", "--resume")
        self.check_same_files(self.walk(), expected)
        os.utime(self.path("w.r32.json"), (later, later))
        time.sleep(0.02)
        arguments = (*TERRAIN, "--heights", self.path("w.r32"), "--seed", "2", "--resume")
        self.quietly(*arguments)
        self.assertIn("nothing to do", common.text_of("terrain", *arguments))
        self.check_same_files(self.walk(), expected)

    def test_moved(self):
        """It holds no paths but those from itself: a world can be moved, and be seen from
        elsewhere."""
        os.makedirs(self.path("a/b"))
        self.quietly(*TERRAIN, "--heights", "a/w.r32", "--normals", "a/b/n.npy", "--gradient",
                     "./g.npy")
        names = {name: value for name, value in self.manifest("a/w.r32.json").items()
                 if name in ("heights", "normals", "gradient")}
        self.assertEqual(names, {"heights": "w_{y}_{x}.r32", "normals": "b/n_{y}_{x}.npy",
                                 "gradient": "../g_{y}_{x}.npy"})
        before = self.walk()
        self.quietly(*TERRAIN, "--heights", self.path("a/b/../w.r32"), "--normals",
                     self.path("a//b/n.npy"), "--gradient", "a/../g.npy", "--resume")
        self.check_same_files(self.walk(), before)

    def test_nothing_was_written(self):
        """A run that fails at its first tile leaves no manifest either."""
        os.mkdir(self.path("w_0_0.r32"))
        self.refused(*TERRAIN, "--heights", "w.r32", words=("w_0_0.r32",))
        os.rmdir(self.path("w_0_0.r32"))
        self.refused(*TERRAIN, "--heights", "missing/w.r32", words=("missing/w.r32.json",))
        self.refused(*TERRAIN, "--heights", "new/{y}/{x}.r32", "--normals", "missing/n.npy",
                     words=("missing/n_0_0.npy",))

    @POSIX
    def test_link(self):
        """A link in its place is followed, also when it is removed again."""
        os.symlink("m.json", self.path("w.r32.json"))
        os.mkdir(self.path("w_0_0.r32"))
        result = run("terrain", *TERRAIN, "--heights", "w.r32", cwd=self.directory)
        self.check_one_line(result, 2, "w_0_0.r32")
        self.assertEqual(self.files(), ["w.r32.json", "w_0_0.r32"])
        os.rmdir(self.path("w_0_0.r32"))
        self.quietly(*TERRAIN, "--heights", "w.r32")
        self.assertTrue(os.path.islink(self.path("w.r32.json")))
        self.assertEqual(self.manifest("m.json"), self.manifest())

    def test_other_file(self):
        """No raster takes its place."""
        for tiles, heights, normals in ((("--resume",), "w.r32", "npy:w.r32.json"),
                                        (("--tile", "2x1"), "w0.r32", "npy:w{x}.r32.json")):
            self.refused("--size", "4x1", *tiles, "--heights", heights, "--normals", normals,
                         words=("--normals: " + heights + ".json", "is the manifest"))

    @POSIX
    def test_first_of_many(self):
        """Of runs that start together one makes it; all agree, or all but one world are refused."""
        for i in range(10):
            runs = [start("terrain", *TERRAIN, "--heights", "w.r32", "--resume", "--seed",
                          str(n % 2), "--quiet", cwd=self.directory) for n in range(6)]
            states = [(process.communicate()[1], process.returncode) for process in runs]
            seed = self.manifest()["seed"]
            for n, (error, code) in enumerate(states):
                self.assertEqual(code, 0 if n % 2 == seed else 2, error)
            found = self.walk()
            self.clear()
            if i % 5 == 0:
                self.quietly(*TERRAIN, "--heights", "w.r32", "--seed", str(seed))
                self.check_same_files(found, self.walk())
                self.clear()


class Patterns(WorldCase):
    """Where the numbers of a tile are in its name."""

    def test_names(self):
        expected = {}
        self.quietly(*TERRAIN, "--heights", "w.r32")
        for y, x in TILES:
            expected[y, x] = self.bytes("w_%d_%d.r32" % (y, x))
        self.clear()
        for pattern, name, manifest in (
                ("w/{y}/{x}.r32", lambda y, x: "w/%d/%d.r32" % (y, x), "w/y_x.r32.json"),
                ("w/{-y}/{x}.r32", lambda y, x: "w/%d/%d.r32" % (2 - y, x), "w/-y_x.r32.json"),
                ("t_x{x:02}_y{y:03}.r32", lambda y, x: "t_x%02d_y%03d.r32" % (x, y),
                 "t_xx_yy.r32.json"),
                ("{x}{y}/{x}-{-y:010}/a.b.r32",
                 lambda y, x: "%d%d/%d-%010d/a.b.r32" % (x, y, x, 2 - y), "xy_x--y_a.b.r32.json"),
                ("r32:d/{y}{x}", lambda y, x: "d/%d%d" % (y, x), "d/yx.json")):
            with self.subTest(pattern=pattern):
                self.quietly(*TERRAIN, "--heights", pattern)
                found = self.walk()
                self.assertIn(manifest, found)
                del found[manifest]
                self.check_same_files(found, {name(y, x): expected[y, x] for y, x in TILES})
                subprocess.run(["rm", "-r", *os.listdir(self.directory)], cwd=self.directory,
                               check=True)

    def test_stem_and_header(self):
        self.quietly("--size", "4x2", "--tile", "2x2", "--output", "o/{y}/{x}", "--gradient",
                     "g/{x}.img")
        names = [os.path.join("o", "0", name) for x in "01" for name in self.names(x)]
        self.assertEqual(sorted(self.walk()), sorted(
            [*names, "g/0.img", "g/0.hdr", "g/1.img", "g/1.hdr", "g/x.img.json"]))

    def test_resume(self):
        arguments = (*TERRAIN, "--heights", "w/{y}/{x}.img")
        self.quietly(*arguments)
        contents = self.walk()
        os.remove(self.path("w/1/2.img"))
        for x in range(4):
            os.remove(self.path("w/2/%d.img" % x))
            os.remove(self.path("w/2/%d.hdr" % x))
        os.rmdir(self.path("w/2"))
        self.quietly(*arguments, "--resume")
        self.check_same_files(self.walk(), contents)

    def test_braces_without_tiles(self):
        """What is no placeholder is part of a name."""
        self.quietly("--size", "2x2", "--heights", "{a}{.r32")
        self.assertEqual(self.files(), ["{a}{.r32"])

    def test_refused(self):
        for pattern, words in (
                ("w/{y}.r32", ("no {x}", "4 tiles of a row")),
                ("w/{x}.r32", ("no {y} or {-y}", "3 tiles of a column")),
                ("{x}_{y}_{z}.r32", ("'{z}", "{x}, {y}, {-y}")), ("{x}_{y}_{.r32", ("'{.r32'",)),
                ("{x:4}_{y}.r32", ("'{x:4}",)), ("{x:0}_{y}.r32", ("'{x:0}",)),
                ("{x:019}_{y}.r32", ("'{x:019}",)), ("{x:04_{y}.r32", ("'{x:04_",)),
                ("{-x}_{y}.r32", ("'{-x}",)), ("{X}_{y}.r32", ("'{X}",)), ("{}.r32", ("'{}",))):
            with self.subTest(pattern=pattern):
                self.refused(*TERRAIN, "--heights", pattern, words=("--heights: ", *words))
        self.refused("--size", "9x9", "--heights", "{x}.r32", words=("--heights", "needs --tile"))
        self.refused("--size", "9x9", "--output", "{-y}t", words=("--output", "needs --tile"))
        self.refused(*TERRAIN, "--heights", "{x}_{y}.npy", "--gradient", "{x:01}_{y}.npy",
                     words=("--gradient", "another option"))
        self.write("file", b"mine")
        self.refused(*TERRAIN, "--heights", "file/{x}_{y}.r32", words=("--heights", "file/"))
        self.quietly("--size", "4x1", "--tile", "2x1", "--heights", "one/{x}.r32")
        self.quietly("--size", "1x4", "--tile", "1x2", "--heights", "two/{-y}.r32")

    @POSIX
    def test_interrupted(self):
        """Directories that were made for a tile which was not finished go with it."""
        os.makedirs(self.path("p/0"))
        os.mkfifo(self.path("p/0/0.npy"))
        process = start("terrain", *TERRAIN, "--heights", "w/a/{y}/{x}.r32", "--normals",
                        "p/{y}/{x}.npy", cwd=self.directory)
        self.wait_for(lambda: os.path.exists(self.path("w/a/0")) and os.listdir(self.path("w/a/0")))
        time.sleep(0.05)
        process.send_signal(signal.SIGTERM)
        self.check_one_line(subprocess.CompletedProcess((), 0, *process.communicate()), 0)
        self.assertEqual(process.returncode, -signal.SIGTERM)
        self.assertEqual(self.directories(), ["p", "p/0"])


class Shares(WorldCase):
    """Several runs make one world."""

    def setUp(self):
        super().setUp()
        self.quietly(*TERRAIN, "--heights", "w.r32")
        self.expected = self.walk()
        self.clear()

    def test_shares(self):
        """Every tile is in exactly one, in order, and shares are equal but for one tile."""
        for count in (1, 2, 3, 5, 7, 12, 13, 1000000):
            with self.subTest(count=count):
                order, sizes = [], []
                for i in sorted({*range(min(count, 20)), count - 1}):
                    self.quietly(*TERRAIN, "--heights", "w.r32", "--share", "%d/%d" % (i, count))
                    found = self.walk()
                    self.check_same_files(found, {name: self.expected[name] for name in found})
                    mine = [tile for tile in TILES if "w_%d_%d.r32" % tile in found]
                    self.assertEqual(len(found) - 1, len(mine))
                    order += mine
                    sizes.append(len(mine))
                    self.clear()
                self.assertEqual(order, TILES)
                self.assertLessEqual(max(sizes) - min(sizes), 1)

    def test_share_of_some(self):
        found = []
        for i in range(3):
            self.quietly(*TERRAIN, "--heights", "w.r32", "--tiles", "1:3,1:3", "--share",
                         "%d/3" % i)
            found.append(sorted(self.walk())[1:])
            self.clear()
        self.assertEqual(found, [["w_1_1.r32", "w_1_2.r32"], ["w_2_1.r32"], ["w_2_2.r32"]])

    def test_summary(self):
        for share, words in (("3/4", "3 tiles"), ("11/12", "1 tile,"),
                             ("12/13", "more shares than tiles")):
            result = run("terrain", *TERRAIN, "--heights", "w.r32", "--share", share,
                         cwd=self.directory)
            self.assertEqual((result.returncode, result.stderr), (0, b""))
            self.assertIn(words, result.stdout.decode())

    def test_refused(self):
        for text in ("3/3", "0/0", "4/3", "1", "1/", "/2", "-1/2", "0/-1", "0/1000001", "0/2x",
                     "0.5/2", "0 /2", "18446744073709551616/2"):
            self.refused(*TERRAIN, "--heights", "w.r32", "--share", text,
                         words=("--share: '%s' is not two integers I/N" % text, "1000000"))
        self.refused("--size", "9x9", "--heights", "w.r32", "--share", "0/2",
                     words=("--share: needs --tile",))

    def hold(self, *arguments):
        """Starts a run that a pipe in place of its tile 1_2 holds up."""
        process = start("terrain", *TERRAIN, "--heights", "w.r32", "--normals", "n.npy", *arguments,
                        cwd=self.directory)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.wait_for_unfinished("w_1_2.r32")
        return process

    @POSIX
    def test_manifest_goes(self):
        """While a run is at a tile its manifest is removed, and perhaps another world begun: the
        tile takes its name only next to a manifest of its own world."""
        files = ("--heights", "w.r32", "--normals", "n.npy")
        self.quietly(*TERRAIN, *files)
        expected = self.walk()
        for seed in (None, "1", "2"):
            with self.subTest(seed=seed):
                self.clear()
                os.mkfifo(self.path("n_1_2.npy"))
                first = self.hold("--quiet")
                os.remove(self.path("w.r32.json"))
                if seed:
                    self.quietly(*TERRAIN, *files, "--seed", seed, "--tiles", "0:1,0:1")
                other = self.walk_files()
                self.bytes("n_1_2.npy")  # the run goes on
                output, error = first.communicate()
                if seed == "2":
                    self.check_one_line(subprocess.CompletedProcess((), first.returncode, output,
                                                                    error), 1, "--heights",
                                        "w.r32.json", "--seed is 2 there and 1 here")
                    self.check_same_files(self.walk_files(), other)
                else:
                    self.assertEqual((first.returncode, output, error), (0, b"", b""))
                    os.remove(self.path("n_1_2.npy"))
                    self.quietly(*TERRAIN, *files, "--resume")
                    self.check_same_files(self.walk(), expected)

    @POSIX
    def test_busy_tiles(self):
        """With --resume, a tile that another run is writing is left to it; without, it is written
        twice, and right."""
        self.quietly(*TERRAIN, "--heights", "w.r32", "--normals", "n.npy")
        expected = self.walk()
        self.clear()
        os.mkfifo(self.path("n_1_2.npy"))
        first = self.hold("--quiet")
        result = run("terrain", *TERRAIN, "--heights", "w.r32", "--normals", "n.npy", "--resume",
                     cwd=self.directory)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertRegex(result.stdout, rb"\A1 tile left to other runs\n5 tiles, 500 samples ")
        result = run("terrain", *TERRAIN, "--heights", "w.r32", "--normals", "n.npy", "--resume",
                     cwd=self.directory)
        self.assertEqual(result.stdout, b"1 tile left to other runs\n"
                                        b"nothing to do: all other files are there\n")
        first.kill()
        first.wait()
        os.remove(self.path("n_1_2.npy"))
        self.quietly(*TERRAIN, "--heights", "w.r32", "--normals", "n.npy", "--resume")
        self.check_same_files(self.walk(), expected)

    @POSIX
    def test_identical_commands(self):
        """Runs without any index share a world; one is killed and started again."""
        side, octaves = ("512", "24") if common.SPEED == "full" else ("256", "6")
        arguments = ("--size", side + "x" + side, "--tile", "32x32", "--octaves", octaves,
                     "--threads", "1", "--heights", "v.img", "--resume")
        self.quietly(*arguments)
        expected = self.walk()
        self.clear()
        runs = [start("terrain", *arguments, cwd=self.directory) for _ in range(4)]
        self.wait_for(lambda: len(self.files()) > 60)
        runs[0].kill()
        runs.append(start("terrain", *arguments, cwd=self.directory))
        made = 0
        for process in runs:
            output, error = process.communicate()
            self.assertEqual(error, b"")
            self.assertEqual(process.returncode, -9 if process is runs[0] else 0)
            made += int((re.search(rb"(?m)^(\d+) tiles?,", output) or [b"", b"0"])[1])
        self.quietly(*arguments)  # what the killed one had, if nobody was left to take it
        self.check_same_files(self.walk(), expected)
        if common.SPEED == "full":
            self.assertLess(made, 256 + 16)  # little was written twice


class Limits(WorldCase):
    """A run that meets a limit of the system ends well, or leaves nothing."""

    @POSIX
    def test_open_files(self):
        for arguments in (("--heights", "w.r32"), ("--heights", "w.img", "--normals", "n.npy"),
                          (*TERRAIN, "--heights", "w.r32"),
                          (*TERRAIN, "--heights", "d/{y}/{x}.img", "--resume")):
            for limit in range(3, 10):
                with self.subTest(arguments=arguments, limit=limit):
                    arguments = ("--size", "40x30", *arguments, "--threads", "1", "--quiet")
                    self.quietly(*arguments)
                    expected = self.walk()
                    subprocess.run(["rm", "-r", *os.listdir(self.directory)], cwd=self.directory,
                                   check=True)
                    result = subprocess.run(
                        ["sh", "-c", 'ulimit -n %d; exec "$@"' % limit, "sh", *common.PROGRAM,
                         "terrain", *arguments], cwd=self.directory, stderr=subprocess.PIPE,
                        stdout=subprocess.PIPE, check=False)
                    if result.returncode == 0:
                        self.check_same_files(self.walk(), expected)
                        subprocess.run(["rm", "-r", *os.listdir(self.directory)],
                                       cwd=self.directory, check=True)
                    elif result.stderr.startswith(b"scarp: "):
                        self.check_one_line(result, result.returncode)
                        self.assertIn(result.returncode, (1, 2))
                        left = self.walk()  # finished tiles stay
                        self.check_same_files(left, {name: expected[name] for name in left})
                        if result.returncode == 2 or "--tile" not in arguments:
                            self.assertEqual((left, self.directories()), ({}, []))
                        if left:
                            subprocess.run(["rm", "-r", *os.listdir(self.directory)],
                                           cwd=self.directory, check=True)
                    self.assertEqual((self.files(), self.directories()), ([], []), result)


common.main(globals())
