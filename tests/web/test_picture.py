# SPDX-License-Identifier: MIT
"""Tests that the playground shows the terrain of the program, to the bit: see playground.py."""
import hashlib
import os
import shutil

from chromium import end, serve
from playground import (CASES, PLACE, SITE, Playground, fragment, hash_of, main, presets,
                        program)

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
        """It has the bits of the program; with errors, it shows them and the picture stays."""
        text = "recipe 1\nparam tall = 80 [0, 300]\nbend = noise(size=90, amplitude=20)\n" \
            "out a = tall * warp(noise(ridged, size=70, octaves=4), bend)\n"
        path = self.file("own.recipe", text)
        self.open(PLACE, text=text, view="hillshade")
        self.assertEqual(self.hash(), hash_of([*PLACE, "--recipe", path]))
        self.write(text.replace("80", "200"))
        self.ready()
        self.assertEqual(self.hash(), hash_of([*PLACE, "--recipe", path, "--set", "tall=200"]))
        before, stale = self.greys(), "getComputedStyle(document.getElementById('map')).opacity"
        self.write(text.replace("warp(", "wrap("))
        self.assertIn("line 4", self.shown("#recipe-message"))
        self.assertIn("line 4", self.shown("#notice"))
        self.assertTrue(self.greys() == before)
        self.assertLess(float(self.page.run(stale)), 0.6)
        self.write(text)
        self.ready()
        self.assertEqual(self.shown("#recipe-message"), "")
        self.assertEqual(self.page.run(stale), "1")

    def test_what_is_no_terrain_is_told(self):
        self.open(PLACE, text="recipe 1\nout a = noise(size=70)\n")
        for text, told in (("out a = x", "no bound"), ("out a = 3", "no height"),
                           ("space 3\nout a = noise(size=9)", "depends on z")):
            self.write(f"recipe 1\n{text}\n")
            self.page.wait(f"document.getElementById('notice').textContent.includes('{told}')")
            self.assertIn(told, self.shown("#recipe-message"))
            self.assertEqual(self.page.run("playground.recipe.errors.length"), 0)
        self.page.run("playground.setNode('a')")  # a cut through space at z = 0
        self.page.wait("playground.whole.job.node?.isSpace && document.documentElement."
                       "dataset.ready === 'yes'")
        self.assertTrue(self.page.run("document.getElementById('notice').hidden"))
        self.page.run("playground.setNode('')")
        self.write("recipe 1\nout a = noise(size=70)\n")
        self.ready()

    def test_statements_and_parts_are_looked_at(self):
        """Values are those that the program writes for an output, the interval is shown and met."""
        text = "recipe 1\nbend = noise(size=90, amplitude=20)\nhigh = smoothstep(bend, -5, 5)\n" \
            "out a = 50 * noise(size=70) * high\n"
        self.open(PLACE, text=text, view="slope")

        def expected(expression):
            path = self.file("node.recipe", text + f"out node = {expression}\n")
            return hashlib.sha256(program(*PLACE, "--recipe", path, "--out",
                                          "node=r32:-")).hexdigest()

        self.page.run("playground.setNode('bend')")
        self.ready()
        self.assertEqual(self.hash(), expected("bend"))
        self.assertEqual(self.page.run("playground.last.job.view"), "slope")
        self.assertRegex(self.shown("#range"), r"^bend: promised -20 … 20, met -1\d.* … 1\d.*slope")
        self.page.run("playground.setNode('high')")
        self.page.run("playground.setView('value')")
        self.ready()
        self.assertEqual(self.hash(), expected("high"))
        self.assertIn("promised 0 … 1", self.shown("#range"))
        greys = self.greys()
        self.assertNotIn(b"?????", greys, "masks are grey")
        self.assertGreater(max(greys) - min(greys), 250)
        self.assertEqual(self.page.run("[...document.querySelectorAll('#views button')].map("
                                       "button => button.disabled)"),
                         [True, True, False, False, True])
        self.page.run("playground.setNode('*')")
        for word, expression in (("noise(size=70)", "noise(size=70)"),
                                 ("50 *", "50 * noise(size=70)"),
                                 ("bend, -5", "bend"), ("smoothstep(", "high")):
            at = text.index(word)
            self.page.run(f"playground.work.editor.select({at})")
            self.ready()
            self.assertEqual(self.hash(), expected(expression), word)
        self.page.run("playground.setNode('')")
        self.ready()

    def test_small_pictures(self):
        """They show the middle of the map, and what is the same is not drawn again."""
        self.open(["--preset", "islands", "--size", "120x90", "--step", "20"], view="relief")
        take = """which => new Promise(done => playground.picture(which, 60, 45,
            ({image: {data, width}, lowest, highest}) => done(
                [width, new Set(new Uint32Array(data.buffer)).size, lowest, highest])))"""
        entries = self.page.run("playground.recipe.entries.map(({name, kind}) => [name, kind])")
        met = set()
        for index, (name, kind) in enumerate(entries):
            if kind in ("field", "noise"):
                width, colours, lowest, highest = self.page.run(f"({take})({index})")
                self.assertEqual(width, 60)
                self.assertGreater(colours, 20, name)
                self.assertLess(lowest, highest)
                met.add((lowest, highest))
        self.assertEqual(len(met), 10, "each shows something else")
        made = self.page.run("playground.pictures.id")
        self.page.run(f"({take})({index})")
        self.assertEqual(self.page.run("playground.pictures.id"), made)
        part = self.page.run("65536 + playground.recipe.parts.find(p => p.kind === 'noise').index")
        self.assertEqual(self.page.run(f"({take})({part})")[0], 60)
        made = self.page.run("playground.pictures.id")
        self.page.run("playground.changeSeed(1)")
        self.ready()
        self.page.run(f"({take})({index})")
        self.assertEqual(self.page.run("playground.pictures.id"), made + 1)
        called = self.page.run("""new Promise(done => {
            let calls = 0;
            playground.picture(4, 61, 45, () => calls++)();
            playground.picture(4, 62, 45, () => done(calls));
        })""")
        self.assertEqual(called, 0, "a wish can be taken back")

    def test_a_newer_wish_replaces_an_older_one(self):
        """Typing is never held up by a picture that takes seconds."""
        self.open(["--preset", "alps", "--size", "96x96"])
        self.page.run("playground.change({size: '3000x3000'})")
        self.page.wait("playground.pool.isBusy")
        self.page.run("""(() => {
            const {onFrame} = playground.pool;
            globalThis.shown = [];
            playground.pool.onFrame = frame => {
                shown.push(frame.raster.width);
                onFrame(frame);
            };
        })()""")
        self.page.run("""playground.work.setText("recipe 1\\nout a = 9 * noise(size=40)\\n");
            playground.change({size: "96x96"})""")
        self.ready()
        self.assertEqual(self.page.run("[...new Set(shown)]"), [96])

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
        camera = self.page.run("playground.flushHash().then(() => "
                               "location.hash.match(/camera=([^&]*)/)[1])")
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
        os.remove(os.path.join(site, "page-simd.wasm"))
        script = self.page.call("Page.addScriptToEvaluateOnNewDocument",
                                source="WebAssembly.validate = () => false;")["identifier"]
        server = serve(site)
        self.addCleanup(end, server)
        self.addCleanup(self.leave)
        words = ["--preset", "islands", *PLACE, "--step", "20"]
        self.page.open(f"http://127.0.0.1:{server.server_port}/index.html" +
                       fragment(words, view="relief"))
        self.ready()
        self.assertFalse(self.page.run("document.getElementById('no-simd').hidden"))
        self.assertNotIn("wasm128", self.shown("#status-kernels"))
        self.assertEqual(self.hash(), hash_of(words))
        self.assert_relief(words)
        self.page.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script)
        self.leave()
        self.open(["--preset", "hills", "--size", "32x32"])
        self.assertTrue(self.page.run("document.getElementById('no-simd').hidden"))
        self.assertIn("wasm128", self.shown("#status-kernels"))


if __name__ == "__main__":
    main()
