# SPDX-License-Identifier: MIT
"""Tests that the playground shows the terrain of the program, to the bit: see playground.py."""
import os
import re
import shutil
import subprocess
import sys


from chromium import serve
from playground import (CASES, PAGE, PLACE, PROGRAM, SITE, Playground, fragment, hash_of, main,
                        presets)

WITHOUT_HESSIAN = ("alps", "islands", "badlands", "hills", "volcanic", "highlands", "cirques",
                   "crests", "folds")


class Picture(Playground):
    def test_presets_are_current(self):
        made = subprocess.run([sys.executable, os.path.join(PAGE, "presets.py"), PROGRAM],
                              check=True, stdout=subprocess.PIPE).stdout
        with open(os.path.join(PAGE, "presets.js"), "rb") as file:
            self.assertEqual(file.read(), made, "run src/web/playground/presets.py")

    def test_presets_have_the_bits_of_the_program(self):
        for name in presets.presets(PROGRAM):
            with self.subTest(name):
                self.same(["--preset", name, "--seed", "5", *PLACE])

    def test_options_have_the_bits_of_the_program(self):
        for name, words in CASES.items():
            with self.subTest(name):
                self.same(PLACE + words)

    def test_relief_has_the_bytes_of_the_program(self):
        for name in presets.presets(PROGRAM):
            with self.subTest(name):
                words = ["--preset", name, "--step", "5", "--size", "120x90", "--z-factor", "1.5"]
                self.open(words, view="relief")
                self.assert_relief(words)

    def test_large_raster_is_whole(self):
        """Slopes that round otherwise change a pixel in some hundred thousand."""
        self.same(["--stretch", "3", "--wind", "111", "--octaves", "3", "--height", "400",
                   "--size", "1200x901"])

    def test_all_views_of_all_presets(self):
        for name in presets.presets(PROGRAM):
            for view in ("relief", "value", "slope", "curvature"):
                with self.subTest(name + " " + view):
                    # 256 units on a side: one dune
                    self.open(["--preset", name, "--size", "64x64", "--step", "4"], view=view)
                    colours = self.page.run("""(() => {
                        const map = document.getElementById("map");
                        const {data} = map.getContext("2d").getImageData(0, 0, 64, 64);
                        return new Set(new Uint32Array(data.buffer)).size;
                    })()""")
                    self.assertGreater(colours, 32)
                    note = self.shown("#status-note")
                    self.assertEqual("has no Hessian" in note,
                                     view == "curvature" and name in WITHOUT_HESSIAN, name)

    def test_hessians_are_those_of_the_gradients(self):
        """Second derivatives of all that makes a terrain, against differences of first ones"""
        self.open(["--stretch", "2", "--wind", "200", "--frequency", "0.03", "--octaves", "3",
                   "--base-amplitude", "0.5", "--base-fractal", "hybrid", "--mask-band", "-0.6,0.7",
                   "--warp-reach", "9", "--crater", "0.4", "--terraces", "3",
                   "--terrace-strength", "0.4", "--step", "0.02", "--size", "200x150"])
        shares = self.page.run("""(async () => {
            const {Sampler, differences, gridOf, makeGround} = await import("./ground.js");
            const {terrain} = playground.checked, {width, height, step} = terrain.raster;
            const sampler = new Sampler(playground.scarp, makeGround(playground.scarp, terrain));
            const names = ["value", "dx", "dy", "dxx", "dxy", "dyy"];
            const exact = Object.fromEntries(names.map(name =>
                [name, new Float32Array(width * height)]));
            sampler.uncutGrid(gridOf(terrain.raster), exact);
            const other = {...exact, dxx: exact.dxx.slice(), dxy: exact.dxy.slice(),
                dyy: exact.dyy.slice()};
            differences(other, width, step);
            return ["dxx", "dxy", "dyy"].map(name => {
                let differing = 0, all = 0; // creases differ, but are few
                for (let i = 0; i < width * height; i++) {
                    const column = i % width, row = Math.floor(i / width);
                    if (column * row > 0 && column < width - 1 && row < height - 1) {
                        differing += Math.abs(exact[name][i] - other[name][i]);
                        all += Math.abs(exact[name][i]);
                    }
                }
                return differing / all;
            });
        })()""")
        for share in shares:
            self.assertGreater(share, 0)
            self.assertLess(share, 0.02, shares)

    def test_webgpu_says_whether_its_pixels_are_equal(self):
        self.open(["--size", "8x8"])
        self.page.wait("playground.gpu !== undefined")
        if self.page.run("playground.gpu === null"):
            self.skipTest("this browser has no WebGPU")
        for words, view in ((["--preset", "none", "--octaves", "4"], "hillshade"),
                            (["--stretch", "2", "--wind", "30", "--octaves", "3"], "curvature"),
                            (["--preset", "islands", "--base-amplitude", "0.2"], "relief")):
            with self.subTest(words):
                self.open(words + PLACE, view=view, gpu="1")
                self.page.wait("document.querySelector('#gpu-sign.equal') !== null", 120)
                self.assertIn("all 19,200 pixels", self.shown("#gpu-sign"))
                self.ready()
                self.assertEqual(self.hash(), hash_of(words + PLACE), "copies stay true")
        words = ["--warp-reach", "20", "--warp-octaves", "30"] + PLACE
        self.open(words, view="hillshade", gpu="1")
        self.assertIn("cannot sample this: warp", self.shown("#gpu-sign.differs"))
        self.assertEqual(self.hash(), hash_of(words), "the processor does it")
        # A sample that is wrong must be told.
        self.open(["--octaves", "2"] + PLACE, view="value", gpu="1")
        self.addCleanup(self.leave)
        self.page.run("""(() => {
            const sample = playground.gpu.sample.bind(playground.gpu);
            playground.gpu.sample = async (...all) => {
                const given = await sample(...all);
                given.noise.value[4711] += 0.25;
                given.noise.dx[4712] *= 1 + 2 ** -23;
                return given;
            };
            playground.update();
        })()""")
        self.page.wait("document.querySelector('#gpu-sign.differs') !== null", 60)
        self.assertIn("1 of 19,200 pixels and 2 of 57,600 ", self.shown("#gpu-sign"))

    def test_space(self):
        self.open(["--preset", "alps", "--size", "128x96", "--step", "8"], space="3d")
        look = """(() => {
            const world = document.getElementById("world"), gl = world.getContext("webgl2");
            const data = new Uint8Array(4 * world.width * world.height);
            gl.readPixels(0, 0, world.width, world.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
            const colours = new Set(new Uint32Array(data.buffer));
            return [gl.getError(), colours.size, data.reduce((a, b) => (31 * a + b) % 1000003, 0)];
        })()"""
        error, colours, before = self.page.run(look)
        self.assertEqual(error, 0)
        self.assertGreater(colours, 1000)
        self.page.run("document.activeElement.blur()")
        self.page.key("w", text="w")
        x, y, _ = self.centre("#world")
        self.page.mouse("mousePressed", x, y)
        self.page.mouse("mouseMoved", x + 90, y + 20, buttons=1)
        self.page.mouse("mouseReleased", x + 90, y + 20)
        self.page.wait("!playground.world.flying")
        self.assertNotEqual(self.page.run(look)[2], before)
        camera = self.page.run("playground.flushHash(), location.hash.match(/camera=([^&]*)/)[1]")
        url = self.page.run("location.href")
        self.leave()
        self.page.open(url)
        self.ready()
        self.assertEqual(self.page.run("Object.values(playground.world.pose).flat().map("
                                       "n => n.toFixed(3)).join(',')"), camera)

    def test_without_simd(self):
        """Where engines have no vectors the page says so, and the bits stay, also in workers."""
        site = os.path.join(self.scratch, "without-simd")
        shutil.copytree(SITE, site)
        with open(os.path.join(site, "compile.mjs"), "r+", encoding="utf-8") as file:
            text, count = re.subn(r"hasVectors = \(\) =>[^;]*;", "hasVectors = () => false;",
                                  file.read())
            self.assertEqual(count, 1)
            file.seek(0)
            file.truncate()
            file.write(text)
        for name in ("scarp-simd.wasm", "relief-simd.wasm"):
            os.remove(os.path.join(site, name))
        server = serve(site)
        self.addCleanup(server.shutdown)
        self.addCleanup(self.leave)
        words = ["--preset", "islands", *PLACE]
        self.page.open(f"http://127.0.0.1:{server.server_port}/index.html" +
                       fragment(words, view="relief"))
        self.ready()
        self.assertFalse(self.page.run("document.getElementById('no-simd').hidden"))
        self.assertNotIn("wasm128", self.shown("#status-kernels"))
        self.assertEqual(self.hash(), hash_of(words))
        self.assert_relief(words)
        self.leave()
        self.open(["--preset", "hills", "--size", "32x32"])
        self.assertTrue(self.page.run("document.getElementById('no-simd').hidden"))
        self.assertIn("wasm128", self.shown("#status-kernels"))


if __name__ == "__main__":
    main()
