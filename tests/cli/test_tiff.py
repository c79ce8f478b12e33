# SPDX-License-Identifier: MIT
"""GeoTIFF, and the coordinate systems of files. GDAL, where it is found, must open all of it."""
import json
import os
import shutil
import struct
import subprocess
import unittest

import common
from common import SPEED, Case, has_threads, run
from rasters import decode_envi_header, read_picture, tiff_tags

PLACE = ("--size", "300x270", "--frequency", "0.01", "--origin", "-3.25,1000", "--step", "0.5")
CORNER = (-3.5, 1134.75)


class Tiff(Case):
    """What is in the file, by a reader of its own; test_formats.py compares small ones."""

    def test_tiles(self):
        """Four tiles, three of which are cut off, of each kind of samples"""
        for option, kind, layer in (("--heights", "npy", 1), ("--relief", "npy", 3),
                                    ("--normals", "npy", 3), ("--gradient", "npy", 2)):
            self.quietly(*PLACE, option, "a.tif", *(("--threads", "2") if has_threads() else ()))
            self.quietly(*PLACE, option, "a." + kind)
            found, expected = (read_picture(self.path("a." + end)) for end in ("tif", kind))
            self.assertEqual(found.shape(), expected.shape())
            self.check_rows(found.rows, expected.rows)
            self.assertEqual(found.channels, layer)

    def test_place(self):
        """The corner of the first pixel, and a size; a system only if one was given"""
        self.quietly(*PLACE, "--heights", "a.tif")
        tags = tiff_tags(self.bytes("a.tif"))
        self.assertEqual((tags[33550], tags[33922]), ([0.5, 0.5, 0], [0, 0, 0, *CORNER, 0]))
        self.assertNotIn(34735, tags)
        self.assertEqual(tags[270], b"heights\0")
        self.quietly(*PLACE, "--crs", "EPSG:2056", "--heights", "a.tif")
        self.assertEqual(tiff_tags(self.bytes("a.tif"))[34735],
                         [1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 2056])

    def test_threads_and_bands(self):
        """Neither changes a byte; nor does what else is written."""
        self.quietly("--size", "700x1100", "--octaves", "1", "--heights", "a.tif", "--threads", "1")
        expected = self.bytes("a.tif")
        for more in (("--threads", "3" if has_threads() else "1"), ("--relief", "r.ppm", "--normals", "n.tif")):
            self.quietly("--size", "700x1100", "--octaves", "1", "--heights", "a.tif", *more)
            self.assertEqual(self.bytes("a.tif"), expected)

    def test_resume(self):
        """A file that was cut off, or is of another size, is written again."""
        arguments = (*PLACE, "--tile", "150x270", "--heights", "a.tif")
        self.quietly(*arguments)
        expected = self.all_bytes()
        for damage in (lambda data: data[:-1], lambda data: data + b"\0", lambda data: b"",
                       lambda data: data[:7], lambda data: b"MM" + data[2:],
                       lambda data: data[:4] + b"\xff\xff\xff\xff" + data[8:]):
            with open(self.path("a_0_1.tif"), "wb") as file:
                file.write(damage(expected["a_0_1.tif"]))
            self.quietly(*arguments, "--resume")
            self.check_same_files(self.all_bytes(), expected)

    @unittest.skipUnless(SPEED == "full", "samples and packs some 10 million samples before it writes")
    def test_big(self):
        """A raster that may take more than 4 GB has 64-bit offsets, as its first bytes say, while
        it is written, and by that of one which is just smaller."""
        for size, version in (("40000x23000", 42), ("40000x29000", 43)):
            process = common.start("terrain", "--size", size, "--octaves", "1", "--threads", "1",
                                   "--heights", "a.tif", cwd=self.directory)
            try:
                self.wait_for(lambda: any(os.path.getsize(self.path(name)) > 64
                                          for name in self.unfinished()), "the first tiles")
                name, = self.unfinished()
                with open(self.path(name), "rb") as file:
                    self.assertEqual(struct.unpack("<2sH", file.read(4)), (b"II", version))
            finally:
                process.terminate()
                process.communicate()
            self.assertEqual(self.unfinished(), [])


class Systems(Case):
    """--crs"""

    def test_utm(self):
        """ENVI names zones of UTM."""
        for number, zone, half in (("32601", "1", "North"), ("32760", "60", "South")):
            self.quietly(*PLACE, "--crs", "EPSG:" + number, "--heights", "a.img")
            self.assertEqual(decode_envi_header(self.bytes("a.hdr").decode())["map info"],
                             ["UTM", "1", "1", "-3.5", "1134.75", "0.5", "0.5", zone, half,
                              "WGS-84", "units=Meters"])

    def test_refused(self):
        for arguments, words in (
                (("--crs", "EPSG:4326", "--heights", "a.tif"), ("--crs", "4326", "degrees")),
                (("--crs", "EPSG:4979", "--heights", "a.tif"), ("--crs",)),
                (("--crs", "EPSG:1023", "--heights", "a.tif"), ("--crs", "1024 to 32766")),
                (("--crs", "EPSG:32767", "--heights", "a.tif"), ("--crs",)),
                (("--crs", "32632", "--heights", "a.tif"), ("--crs", "EPSG:N")),
                (("--crs", "EPSG:2056", "--heights", "a.img"), ("--crs", ".img", "32601", ".tif")),
                (("--crs", "EPSG:32661", "--heights", "a.img"), ("--crs", ".img")),
                (("--crs", "EPSG:32632", "--heights", "a.r32"), ("--crs", ".tif and .img"))):
            with self.subTest(arguments=arguments):
                self.check_one_line(run("terrain", *arguments, cwd=self.directory), 2, *words)
                self.assertEqual(self.files(), [])


@unittest.skipUnless(shutil.which("gdalinfo") and shutil.which("gdal_translate"), "no GDAL here")
class Gdal(Case):
    """GDAL opens what is written, where it lies, with the same samples."""

    def gdal(self, *command):
        result = subprocess.run(command, cwd=self.directory, check=False, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)
        # PROJ says this of ENVI's coordinates that are of no system.
        told = [line for line in result.stderr.splitlines() if b"PROJ: proj_get_ellipsoid" not in line]
        self.assertEqual((result.returncode, told), (0, []), command)
        return result.stdout

    def info(self, name):
        return json.loads(self.gdal("gdalinfo", "-json", name))

    def samples(self, name, *more):
        """What GDAL reads, as ENVI has it"""
        self.gdal("gdal_translate", "-q", "-of", "ENVI", "-co", "INTERLEAVE=BIP", *more, name,
                  "read.bin")
        return self.bytes("read.bin")

    def test_formats(self):
        """Every layer in every format that GDAL knows, with the bands of the raw samples"""
        wanted = {"--heights": ("tif", "img"), "--normals": ("tif", "img"),
                  "--hillshade": ("tif", "img"), "--relief": ("tif", "img"),
                  "--gradient": ("tif", "img"), "--slope": ("tif", "img"),
                  "--curvature": ("tif", "img")}
        if common.has_png():
            wanted["--relief"] += ("png",)
        for option, kinds in wanted.items():
            names = ["%s.%s" % (option[2:], kind) for kind in kinds]
            for name in names:
                self.quietly(*PLACE, option, name)
            expected = self.bytes(names[1])
            for name in names:
                with self.subTest(name=name):
                    self.assertEqual(self.samples(name), expected)
                    found = self.info(name)
                    self.assertEqual(found["size"], [300, 270])
                    if not name.endswith(".png"):
                        self.assertEqual(found["geoTransform"],
                                         [CORNER[0], 0.5, 0, CORNER[1], 0, -0.5])

    def test_masks(self):
        """An RGBA picture, and five files"""
        alps = ("--size", "300x270", "--step", "30", "--preset", "alps")
        self.quietly(*alps, "--masks", "m.tif")
        self.assertEqual(len(self.samples("m-rock.tif")), 300 * 270)
        if common.has_png():
            self.quietly(*alps, "--masks", "m.png")
            bands = self.info("m-1.png")["bands"]
            self.assertEqual([band["colorInterpretation"] for band in bands],
                             ["Red", "Green", "Blue", "Alpha"])
            self.assertEqual(self.samples("m-1.png")[3::4], self.samples("m-vegetation.tif"))

    def test_overviews(self):
        """Levels of one .tif are its overviews, with their samples."""
        self.quietly(*PLACE, "--levels", "4", "--heights", "a.tif", "--crs", "EPSG:2056")
        self.assertEqual(self.files(), ["a.tif", "a.tif.ovr", "a.tif.ovr.ovr", "a.tif.ovr.ovr.ovr"])
        band, = self.info("a.tif")["bands"]
        self.assertEqual([overview["size"] for overview in band["overviews"]],
                         [[150, 135], [75, 68], [38, 34]])
        self.quietly(*PLACE, "--levels", "4", "--heights", "a.r32")
        for k in (1, 2, 3):
            self.assertEqual(self.samples("a.tif", "-oo", "OVERVIEW_LEVEL=%d" % (k - 1)),
                             self.bytes("a-level%d.r32" % k))

    def test_systems(self):
        self.quietly(*PLACE, "--crs", "EPSG:32633", "--heights", "a.tif", "--normals", "n.img")
        self.assertIn('ID["EPSG",32633]', self.info("a.tif")["coordinateSystem"]["wkt"])
        self.assertIn('"UTM zone 33N"', self.info("n.img")["coordinateSystem"]["wkt"].replace(
            "WGS 84 / ", ""))

    def test_one_row(self):
        for size in ("1x1", "257x1", "1x513"):
            self.quietly("--size", size, "--heights", "a.tif", "--normals", "n.tif")
            self.quietly("--size", size, "--heights", "a.r32", "--normals", "n.img")
            self.assertEqual(self.samples("a.tif"), self.bytes("a.r32"))
            self.assertEqual(self.samples("n.tif"), self.bytes("n.img"))


common.main(globals())
