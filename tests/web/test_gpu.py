# SPDX-License-Identifier: MIT
"""Tests that the playground lets WebGPU sample the terrain: see playground.py."""
import os
import shutil

from chromium import end, serve
from playground import SITE, Playground, fragment, hash_of, main

TEXT = """recipe 1
param tall = 80 [0, 300]
param sea = 10 [0, 50]
bend = noise(size=90, amplitude=20)
out land = tall * warp(noise(size=70, octaves=3), bend)
"""
PLACE = ["--size", "96x70", "--origin", "-37.25,19.5", "--step", "1.7"]
STATUS = "document.getElementById('status-gpu').textContent"
BY_GPU = f"{STATUS}.startsWith('picture by the GPU') && playground.last.isGpu && " \
    "document.documentElement.dataset.ready === 'yes'"
PRESS = "document.getElementById('gpu').click()"
# Notes what the status says of the GPU, and who made each frame.
NOTE = """(() => {
    globalThis.noted = {texts: [], frames: []};
    const status = document.getElementById("status-gpu"), {onFrame} = playground.pool;
    globalThis.watch ??= new MutationObserver(() => noted.texts.push(status.textContent));
    watch.observe(status, {childList: true});
    globalThis.first ??= onFrame;
    playground.pool.onFrame = frame => {
        noted.frames.push({isGpu: frame.isGpu, text: status.textContent,
            seed: frame.job.source.seed, isExact: frame.job.isExact === true});
        first(frame);
        if (frame.isGpu) { // as if it were saved before the module has made the numbers
            noted.exact = [playground.whole.isGpu, playground.exact()];
        }
    };
})()"""
# How many of the values that the GPU made differ from samples of the module at float places
DIFFERING = """(() => {
    const {job, raster: {width, height, origin, step}, values} = playground.last;
    const recipe = playground.terrain.scarp.recipe(job.source.text);
    recipe.seed = job.source.seed;
    const x = Float32Array.from(values, (_, i) => origin[0] + i % width * step);
    const y = Float32Array.from(values, (_, i) =>
        origin[1] + (height - 1 - Math.floor(i / width)) * step);
    const {value} = recipe.sample2(x, y, {value: new Float32Array(values.length)});
    recipe.free();
    return value.filter((v, i) => Math.max(v, SEA) !== values[i]).length;
})()"""


def has_webgpu(page):
    return page.run("navigator.gpu?.requestAdapter().then(found => found !== null) ?? false")


class Gpu(Playground):
    def setUp(self):
        self.open(PLACE, text=TEXT, view="hillshade")
        if not has_webgpu(self.page):
            self.skipTest("this browser has no WebGPU adapter")
        self.page.run(NOTE)

    def press(self):
        self.page.run(PRESS)
        self.page.wait(BY_GPU, 120)

    def noted(self):
        """What came since the last call: texts, and frames"""
        noted = self.page.run("({texts: noted.texts, frames: noted.frames.map(frame => "
                              "({...frame, seed: String(frame.seed)}))})")
        self.page.run("noted.texts = [], noted.frames = []; 0")
        return noted["texts"], noted["frames"]

    def expected_hash(self, text, *words):
        return hash_of([*PLACE, "--recipe", self.file("gpu.recipe", text), *words])

    def test_the_gpu_draws_once_its_shader_is_there(self):
        """Until then the module does; hash and files stay those of the module."""
        before = self.page.run("[...playground.whole.pixels].map(p => p & 255)")
        self.assertEqual(self.hash(), self.expected_hash(TEXT))
        self.page.run(PRESS)
        self.page.wait(f"{STATUS}.startsWith('compiling')")
        self.page.run("playground.changeSeed(1)")
        self.page.wait("noted.frames.some(({seed}) => seed === 2n)")
        self.page.run("playground.changeSeed(-1)")
        self.page.wait(BY_GPU, 120)
        texts, frames = self.noted()
        steps = ["looking", "compiling for the GPU … 0 s", "asking", "picture"]
        at = [next(i for i, text in enumerate(texts) if text.startswith(step)) for step in steps]
        self.assertEqual(at, sorted(at))
        self.assertIn("swiftshader", texts[-1])
        self.assertRegex(texts[-1], r" in [\d.]+ ms; hash and files by wasm in [\d.]+ ms$")
        for frame in frames:
            self.assertEqual(frame["isGpu"],
                             frame["text"].startswith("picture") and not frame["isExact"])
        self.assertEqual([frame["isGpu"] for frame in frames if frame["seed"] == "2"][0], False)
        self.assertEqual(self.page.run(DIFFERING.replace("SEA", "10")), 0)
        off = self.page.run("""playground.whole.values.reduce((most, value, i) =>
            Math.max(most, Math.abs(value - playground.last.values[i])), 0)""")
        self.assertTrue(0 < off < 0.01, off)
        self.assertEqual(self.hash(), self.expected_hash(TEXT))
        after = self.page.run("[...playground.last.pixels].map(p => p & 255)")
        self.assertLessEqual(max(abs(a - b) for a, b in zip(before, after)), 2)
        self.assertTrue(self.page.run("noted.exact[0]"))
        self.assertTrue(self.page.run("noted.exact[1].then(whole => whole === playground.whole)"))

    def test_all_views_look_alike(self):
        for text in (TEXT, TEXT.replace("\nout land = ", "\nout land = 0 * noise(erosion) + ")):
            self.write(text)
            self.ready()
            self.press()
            for view in ("relief", "hillshade", "value", "slope", "curvature"):
                with self.subTest(view):
                    self.page.run(f"playground.setView('{view}')")
                    self.page.wait(f"{BY_GPU} && playground.last.job.view === '{view}'", 120)
                    off = self.page.run("""(async () => {
                        const {last} = playground, bytes = ({pixels}) =>
                            new Uint8Array(pixels.buffer);
                        const other = await new Promise(done => playground.pictures.make(
                            last.job, null, done));
                        const a = bytes(last), b = bytes(other);
                        return [a.reduce((most, n, i) => Math.max(most, Math.abs(n - b[i])), 0),
                            new Set(last.pixels).size];
                    })()""")
                    self.assertLessEqual(off[0], 6)
                    self.assertGreater(off[1], 20)
            self.page.run(PRESS)
            self.page.run("playground.setView('hillshade')")
            self.ready()

    def test_numbers_need_no_other_shader_and_edits_do(self):
        self.press()
        self.noted()
        for tall in (90, 150, 210):
            self.write(TEXT.replace("80", str(tall)))
            self.page.run("playground.changeSeed(1)")
            self.page.wait(BY_GPU)
        texts, frames = self.noted()
        self.assertFalse([text for text in texts if not text.startswith("picture")])
        self.assertTrue(all(frame["isGpu"] or frame["isExact"] for frame in frames))
        self.assertEqual(self.page.run(DIFFERING.replace("SEA", "10")), 0)
        edited = TEXT.replace("octaves=3", "ridged, octaves=3")
        self.write(edited)
        self.page.wait(f"{STATUS}.startsWith('compiling')")
        self.page.wait(BY_GPU, 120)
        texts, frames = self.noted()
        self.assertFalse(frames[0]["isGpu"])
        self.assertTrue(frames[-1]["isExact"] and frames[-2]["isGpu"])
        self.assertEqual(self.page.run(DIFFERING.replace("SEA", "10")), 0)
        self.assertEqual(self.hash(), self.expected_hash(edited, "--seed", "4"))
        self.page.run("playground.work.undo()")  # that shader is there
        self.page.wait(BY_GPU)
        self.assertFalse([text for text in self.noted()[0] if text.startswith("compiling")])

    def test_what_the_gpu_cannot_show(self):
        """The module shows statements, and what is far away; the status says so."""
        self.press()
        self.page.run("playground.setNode('bend')")
        self.ready()
        self.assertEqual(self.shown("#status-gpu"),
                         "wasm draws this: the GPU shows the terrain only")
        self.assertFalse(self.page.run("playground.last.isGpu"))
        self.page.run("playground.setNode('')")
        self.page.wait(BY_GPU)
        self.page.run("playground.change({origin: '1e7,0'})")
        self.ready()
        self.assertIn("so far from the origin", self.shown("#status-gpu"))
        self.assertFalse(self.page.run("playground.last.isGpu"))
        self.page.run("playground.change({origin: '0,0'})")
        self.page.wait(BY_GPU)
        self.write("recipe 1\nspace 3\nout land = 9 * flat(noise(size=50))\n")
        self.page.wait(f"{STATUS}.includes('only recipes of the plane')")

    def test_the_url_remembers_the_switch(self):
        self.press()
        self.page.run("playground.flushHash()")
        self.assertIn("gpu=1", self.page.run("location.hash"))
        self.leave()
        self.open(PLACE, text=TEXT, gpu="1")
        self.page.wait(BY_GPU, 120)
        self.assertEqual(self.page.run("document.getElementById('gpu').ariaPressed"), "true")
        self.page.run(PRESS)
        self.page.wait("!playground.last.isGpu")
        self.ready()
        self.assertEqual(self.shown("#status-gpu"), "")
        self.page.run("playground.flushHash()")
        self.assertNotIn("gpu", self.page.run("location.hash"))

    def test_a_gpu_with_wrong_answers_is_not_taken(self):
        site = os.path.join(self.scratch, "wrong")
        shutil.copytree(SITE, site)
        path = os.path.join(site, "scarp.wgsl")
        with open(path, encoding="utf-8") as file:
            shader = file.read()
        wrong = shader.replace("SCARP_HASH_X: u32 = 0x1a2012f5u", "SCARP_HASH_X: u32 = 0x1a2012f7u")
        self.assertNotEqual(wrong, shader)
        with open(path, "w", encoding="utf-8") as file:
            file.write(wrong)
        server = serve(site)
        self.addCleanup(end, server)
        self.leave()
        self.page.open(f"http://127.0.0.1:{server.server_port}/index.html" +
                       fragment(PLACE, text=TEXT, view="hillshade"))
        self.ready()
        before = self.hash()
        self.page.run(PRESS)
        self.page.wait(f"{STATUS}.startsWith('wasm goes on')", 120)
        self.assertEqual(self.shown("#said"), self.shown("#status-gpu"))
        self.assertRegex(self.shown("#status-gpu"),
                         r"^wasm goes on: the GPU computes other numbers: \d+ of 4096 answers "
                         r"are wrong$")
        self.page.run("playground.changeSeed(1)")
        self.ready()
        self.assertFalse(self.page.run("playground.last.isGpu"))
        self.assertNotEqual(self.hash(), before)
        self.leave()


class Without(Playground):
    def says(self, text):
        """The status says why the module goes on, and that does."""
        self.page.wait(f"{STATUS} === 'wasm goes on: {text}'")
        self.page.run("playground.changeSeed(1)")
        self.page.wait("playground.whole.job.source.seed === 2n")
        self.ready()
        self.assertFalse(self.page.run("playground.last.isGpu"))


class NoGpu(Without):
    """A browser that has WebGPU, and no GPU for it"""
    without = ["--enable-unsafe-webgpu"]

    def test_it_says_so(self):
        self.open(PLACE, text=TEXT, view="hillshade", gpu="1")
        self.says("this browser finds no GPU for WebGPU")
        path = self.file("gpu.recipe", TEXT)
        self.assertEqual(self.hash(), hash_of([*PLACE, "--recipe", path, "--seed", "2"]))
        for said in self.page.console:  # by the browser itself
            self.assertIn("No available adapters", said)
        self.page.console.clear()


class NoWebGpu(Without):
    """Pages that are neither local nor encrypted have none."""
    options = ["--host-resolver-rules=MAP far.test 127.0.0.1"]

    def test_it_says_so(self):
        self.page.open(self.url.replace("127.0.0.1", "far.test") +
                       fragment(PLACE, text=TEXT, gpu="1"))
        self.ready()
        self.says("this browser has no WebGPU for this page")


if __name__ == "__main__":
    main()
