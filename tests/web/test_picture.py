# SPDX-License-Identifier: MIT
"""Tests that the playground shows the terrain of the program, to the bit: see playground.py."""
import os
import re
import shutil


from chromium import serve
from playground import CASES, PLACE, PROGRAM, SITE, Playground, fragment, hash_of, main, presets

WITH_HESSIAN = ("dunes",)  # gullies have none


class Picture(Playground):
    def test_presets_have_the_bits_of_the_program(self):
        for name in presets():
            with self.subTest(name):
                self.same(["--preset", name, "--seed", "5", *PLACE])

    def test_options_have_the_bits_of_the_program(self):
        for name, words in CASES.items():
            with self.subTest(name):
                self.same(PLACE + words)

    def test_relief_has_the_bytes_of_the_program(self):
        for name in presets():
            with self.subTest(name):
                words = ["--preset", name, "--step", "5", "--size", "120x90", "--z-factor", "1.5"]
                self.open(words, view="relief")
                self.assert_relief(words)

    def test_large_raster_is_whole(self):
        """Slopes that round otherwise change a pixel in some hundred thousand."""
        self.same(["--octaves", "3", "--height", "400", "--size", "1200x901"])

    def test_all_views_of_all_presets(self):
        for name in presets():
            for view in ("relief", "value", "slope", "curvature"):
                with self.subTest(name + " " + view):
                    self.open(["--preset", name, "--size", "64x64", "--step", "24"], view=view)
                    colours = self.page.run("""(() => {
                        const map = document.getElementById("map");
                        const {data} = map.getContext("2d").getImageData(0, 0, 64, 64);
                        return new Set(new Uint32Array(data.buffer)).size;
                    })()""")
                    self.assertGreater(colours, 20)
                    note = self.shown("#status-note")
                    self.assertEqual("has no Hessian" in note,
                                     view == "curvature" and name not in WITH_HESSIAN, name)

    def test_bends_are_those_of_the_hessian(self):
        """With and without a Hessian, the same smooth terrain has nearly the same bends."""
        text = "recipe 1\nh = noise(size=60, octaves=2)\nout a = 30 * h%s\n"
        pictures = []
        for more in ("", " + 0 * noise(erosion, octaves=2)"):
            self.open(["--size", "90x70", "--step", "0.5"], text=text % more, view="curvature")
            self.assertEqual("no Hessian" in self.shown("#status-note"), more != "")
            pictures.append(self.page.run("[...playground.whole.pixels].map(p => p & 255)"))
        off = [abs(a - b) for a, b in zip(*pictures)]
        self.assertGreater(len(set(pictures[0])), 20)
        self.assertLess(sum(off) / len(off), 2)

    def test_a_recipe_of_ones_own(self):
        """It has the bits of the program; while it has errors, they are told and the picture stays."""
        text = "recipe 1\nparam tall = 80 [0, 300]\nbend = noise(size=90, amplitude=20)\n" \
            "out a = tall * warp(noise(ridged, size=70, octaves=4), bend)\n"
        path = os.path.join(self.scratch, "own.recipe")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        self.open(PLACE, text=text, view="hillshade")
        self.assertEqual(self.hash(), hash_of([*PLACE, "--recipe", path]))
        self.page.run("playground.setValue('tall', '200')")
        self.ready()
        self.assertEqual(self.hash(), hash_of([*PLACE, "--recipe", path, "--set", "tall=200"]))
        before = self.greys()
        self.page.run("playground.setText(playground.state.text.replace('warp(', 'wrap('))")
        self.assertIn("line 4", self.shown("#recipe-message"))
        self.assertIn("line 4", self.shown("#notice"))
        self.assertTrue(self.greys() == before)
        self.page.run("playground.setText(playground.state.text.replace('wrap(', 'warp('))")
        self.ready()
        self.assertEqual(self.shown("#recipe-message"), "")
        self.page.run("playground.setValue('tall', '301')")
        self.assertIn("tall: outside of its interval", self.shown("#notice"))
        self.page.run("playground.setValue('tall', undefined)")
        self.ready()

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
        os.remove(os.path.join(site, "page-simd.wasm"))
        server = serve(site)
        self.addCleanup(server.shutdown)
        self.addCleanup(self.leave)
        words = ["--preset", "islands", *PLACE, "--step", "20"]
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
