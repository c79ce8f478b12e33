# SPDX-License-Identifier: MIT
"""Tests the playground in headless Chromium, against the program.

    test_playground.py [TEST...]

The environment tells where things are: SCARP_PROGRAM, SCARP_CHROMIUM, SCARP_PLAYGROUND (the
assembled page), SCARP_CC and SCARP_LIBRARY (a C compiler, and the folder of the shared library),
SCARP_NODE, which may be empty. SCARP_REQUIRE_TOOLS with "chromium" in it turns a skipped test into
a failure.
"""
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

from chromium import Chromium, serve

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, os.pardir, os.pardir)
PAGE = os.path.join(ROOT, "src", "web", "playground")
sys.path.insert(0, PAGE)
sys.dont_write_bytecode = True
import presets  # noqa: E402

SKIPPED = 77
PATIENCE = 20  # seconds for a picture
PROGRAM, CHROMIUM, SITE, CC, LIBRARY, NODE = (
    os.environ.get("SCARP_" + name, "")
    for name in ("PROGRAM", "CHROMIUM", "PLAYGROUND", "CC", "LIBRARY", "NODE"))

WITHOUT_HESSIAN = ("alps", "islands", "badlands", "hills", "volcanic", "highlands", "cirques",
                   "crests", "folds")
# Rasters that do not lie at the origin, and are no squares
PLACE = ["--size", "160x120", "--origin", "-37.5,19", "--step", "2.5"]
# Each case has what others have not.
CASES = {
    "turned wind": ["--stretch", "2.5", "--wind", "200", "--base-amplitude", "0.5"],
    "aligned wind": ["--stretch", "0.5", "--fractal", "erosion", "--sea-level", "-0.1"],
    "cut": ["--preset", "alps", "--sea-level", "0.2", "--plateau", "0.9", "--terraces", "5"],
    "flow": ["--phase", "0.3", "--fade", "cubic", "--lacunarity", "1.9", "--of-octaves", "12"],
    "no flow": ["--phase", "0", "--amplitude", "-0.7"],
    "cells": ["--basis", "cell-edge", "--jitter", "0.6", "--warp-reach", "20", "--warp-gain",
              "0.3", "--warp-octaves", "2.5", "--warp-basis", "simplex", "--warp-rotate"],
    "fractals": ["--fractal", "pingpong", "--sharpness", "1.1", "--octaves", "4.4",
                 "--base-amplitude", "-0.3", "--base-fractal", "hybrid", "--mask-band", "0.4,-0.3",
                 "--mask-basis", "value", "--mask-seed", "77", "--crater", "0.2"],
    "defaults": ["--seed", "0", "--frequency", "1", "--octaves", "1", "--gain", "0.5",
                 "--base-amplitude", "1", "--step", "0.125"],
    "far": ["--origin", "1e12,-3e11", "--step", "0.125", "--seed", "0xfedcba9876543210",
            "--fractal", "jordan", "--erosion", "0.9", "--z-factor", "2", "--azimuth", "117",
            "--altitude", "30"],
    "repeats": ["--preset", "alps", "--period", "256x128", "--step", "8"],
    "repeats in the wind": ["--preset", "dunes", "--period", "300x200", "--step", "4"],
}


def program(*words, cwd=None):
    return subprocess.run([PROGRAM, "terrain", *words, "--quiet"], check=True, cwd=cwd,
                          stdout=subprocess.PIPE).stdout


def hash_of(words):
    return hashlib.sha256(program(*words, "--heights", "r32:-")).hexdigest()


def hillshade_of(words):
    """The bytes of the picture, without the head of the file."""
    return program(*words, "--hillshade", "pgm:-").split(b"\n255\n", 1)[1]


def fragment(words, **view):
    pairs = list(presets.options(words).items())
    pairs = [(name, "1" if value is True else value) for name, value in pairs]
    if "preset" not in dict(pairs):
        pairs.append(("preset", "none"))
    return "#" + urllib.parse.urlencode(pairs + list(view.items()))


class Playground(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.mkdtemp(prefix="scarp-web-")
        cls.addClassCleanup(shutil.rmtree, cls.scratch, ignore_errors=True)
        cls.server = serve(SITE)
        cls.addClassCleanup(cls.server.shutdown)
        cls.page = Chromium(CHROMIUM, cls.scratch)
        cls.addClassCleanup(cls.page.close)
        cls.page.size(1200, 800)
        cls.url = f"http://127.0.0.1:{cls.server.server_port}/index.html"

    def tearDown(self):
        said = list(self.page.console)
        self.page.console.clear()
        self.assertEqual(said, [], "the console is silent")

    def open(self, words=(), **view):
        """Opens the page anew, or if it is there, what the part of the URL behind # tells."""
        hash = fragment(words, **view)
        if self.page.run("globalThis.playground === undefined"):
            self.page.open(self.url + hash)
        else:
            self.page.run(f"""new Promise(done => {{
                addEventListener("hashchange", done, {{once: true}});
                location.hash = "{hash}&once={self.page.number}";
            }})""")
        self.ready()

    def leave(self):
        self.page.call("Page.navigate", url="about:blank")
        self.page.wait("location.href === 'about:blank'")

    def ready(self):
        notice = "document.getElementById('notice')?.textContent"
        self.page.wait("document.documentElement?.dataset.ready === 'yes' || "
                       f"{notice}?.length > 0", PATIENCE)
        self.assertEqual(self.page.run(notice), "")

    def hash(self):
        return self.page.run("document.getElementById('status-hash').dataset.hash")

    def greys(self):
        """The red of the pixels that the map shows, after a look at the others."""
        text = self.page.run("""(() => {
            const map = document.getElementById("map");
            const {data} = map.getContext("2d").getImageData(0, 0, map.width, map.height);
            let text = "";
            for (let i = 0; i < data.length; i += 4) {
                const isGrey = data[i] === data[i + 1] && data[i] === data[i + 2];
                text += isGrey && data[i + 3] === 255 ? String.fromCharCode(data[i]) : "?????";
            }
            return text;
        })()""")
        return text.encode("latin-1")

    def same(self, words):
        self.open(words, view="hillshade")
        self.assertEqual(self.hash(), hash_of(words), "the heights are those of the program")
        self.assertTrue(self.greys() == hillshade_of(words), "so is every pixel of the hillshade")

    def centre(self, element):
        return self.page.run(f"""(() => {{
            const element = document.querySelector({element!r});
            element.scrollIntoView({{block: "center"}});
            const box = element.getBoundingClientRect();
            return [box.x + box.width / 2, box.y + box.height / 2, box.width];
        }})()""")

    def click(self, element):
        x, y, _ = self.centre(element)
        self.page.mouse("mousePressed", x, y)
        self.page.mouse("mouseReleased", x, y)

    def type(self, name, text):
        self.page.run(f"""(() => {{
            const field = document.getElementById("p-{name}");
            field.closest("details").open = true;
            field.focus();
            field.value = {text!r};
            field.dispatchEvent(new Event("input", {{bubbles: true}}));
        }})()""")

    def shown(self, element):
        return self.page.run(f"document.querySelector({element!r}).textContent")

    # The terrain

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

    def assert_relief(self, words):
        expected = program(*words, "--relief", "ppm:-").split(b"\n255\n", 1)[1]
        self.assertTrue(bytes(self.page.run("""[...playground.whole.pixels].flatMap(
            p => [p & 255, p >> 8 & 255, p >> 16 & 255])""")) == expected)

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

    # Using it

    def test_a_slider_is_dragged(self):
        words = ["--fractal", "fbm", "--octaves", "8", "--size", "256x256"]
        self.open(words, view="hillshade")
        before = self.page.run("playground.frames")
        x, y, width = self.centre("#p-gain-slider")
        self.page.mouse("mousePressed", x, y)
        for i in range(1, 21):
            self.page.mouse("mouseMoved", x + i * width / 80, y, buttons=1)
        self.page.mouse("mouseReleased", x + width / 4, y)
        self.ready()
        self.assertGreater(self.page.run("playground.frames"), before + 5, "it follows")
        gain = self.page.run("document.getElementById('p-gain').value")
        self.assertGreater(float(gain), 0.6)
        self.assertEqual(self.hash(), hash_of(words + ["--gain", gain]))
        self.assertTrue(self.greys() == hillshade_of(words + ["--gain", gain]))

    def test_the_map_is_dragged_and_zoomed(self):
        words = ["--preset", "hills", "--size", "256x256"]
        self.open(words, view="hillshade")
        x, y, _ = self.centre("#map")

        def under(x, y):
            """The place that the page tells of a point of the map"""
            self.page.mouse("mouseMoved", x, y)
            words = self.shown("#readout").split()
            self.assertEqual(words[::2], ["x", "y", "height"])
            return [float(word) for word in words[1::2]]

        before = under(x, y)
        self.page.mouse("mousePressed", x, y)
        for i in range(5):
            self.page.mouse("mouseMoved", x - 15 * i, y + 10 * i, buttons=1)
        self.page.mouse("mouseReleased", x - 60, y + 40)
        self.ready()
        after = under(x - 60, y + 40)
        self.assertLessEqual(max(abs(a - b) for a, b in zip(before[:2], after[:2])), 1.01)
        x, y = x + 130, y - 210
        before = under(x, y)
        self.page.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0,
                       deltaY=-100)
        self.page.wait("document.getElementById('p-step').value !== '1'")
        self.ready()
        after = under(x, y)
        self.assertLessEqual(max(abs(a - b) for a, b in zip(before[:2], after[:2])), 1.01)
        origin, step = [self.page.run(f"document.getElementById('p-{name}').value")
                        for name in ("origin", "step")]
        self.assertNotEqual(origin, "0,0")
        self.assertLess(float(step), 1)
        words += ["--origin", origin, "--step", step]
        self.assertEqual(self.hash(), hash_of(words))

    def test_keys(self):
        words = ["--preset", "karst", "--size", "96x96"]
        self.open(words, view="hillshade")
        self.page.run("document.activeElement.blur()")
        for key in ("ArrowRight", "ArrowUp", "ArrowRight", "ArrowLeft"):
            self.page.key(key)
        self.ready()
        self.assertEqual(self.shown("#seed-now"), "3")
        self.assertEqual(self.hash(), hash_of(words + ["--seed", "3"]))
        for i, view in enumerate(["relief", "hillshade", "value", "slope", "curvature"]):
            self.page.key(str(i + 1), text=str(i + 1))
            self.ready()
            self.assertEqual(self.page.run("playground.state.view"), view)
            chosen = self.shown("#views [aria-checked=true]")
            self.assertEqual(chosen, view)

    def test_all_views_of_all_presets(self):
        for name in presets.presets(PROGRAM):
            for view in ("relief", "value", "slope", "curvature"):
                with self.subTest(name + " " + view):
                    self.open(["--preset", name, "--size", "64x64"], view=view)
                    colours = self.page.run("""(() => {
                        const map = document.getElementById("map");
                        const {data} = map.getContext("2d").getImageData(0, 0, 64, 64);
                        return new Set(new Uint32Array(data.buffer)).size;
                    })()""")
                    self.assertGreater(colours, 16)
                    note = self.shown("#status-note")
                    self.assertEqual("has no Hessian" in note,
                                     view == "curvature" and name in WITHOUT_HESSIAN, name)

    def test_screen_readers_have_names_for_all(self):
        self.open(["--preset", "alps", "--size", "32x32"])
        self.page.run("document.querySelectorAll('details').forEach(d => d.open = true)")
        self.page.call("Accessibility.enable")
        nodes = self.page.call("Accessibility.getFullAXTree")["nodes"]
        self.page.call("Accessibility.disable")
        roles = {"button", "slider", "textbox", "checkbox", "combobox", "radio", "image",
                 "spinbutton", "group", "radiogroup", "dialog"}
        found = [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in nodes
                 if not node["ignored"] and node["role"]["value"] in roles]
        self.assertGreater(len(found), 120)
        self.assertEqual([role for role, name in found if name == "" and role != "group"], [])
        for what in (("slider", "Gain"), ("textbox", "Gain"), ("group", "Warp"),
                     ("button", "Copy as JavaScript"), ("radio", "Relief"),
                     ("image", "Map of the terrain alps, seed 1, relief")):
            self.assertIn(what, found)

    def test_wrong_numbers_are_marked(self):
        words = ["--size", "64x64"]
        self.open(words)
        told = ": a number is not finite or outside its interval; "
        for name, text, message in [
                ("gain", "17", "gain" + told + "from 1/16 to 16"),
                ("octaves", "33", "octaves" + told + "above 2^-150, at most 32"),
                ("octaves", "0", "octaves" + told),
                ("lacunarity", "two", "lacunarity" + told + "from 1/16 to 16"),
                ("amplitude", "", "amplitude" + told + "a magnitude from 2^-24 to 2^24"),
                ("seed", "18446744073709551616", "from 0 to 2^64 - 1"),
                ("height", "-1", "height" + told + "from 0 to 2^24"),
                ("warp-reach", "1e-9", "amplitude" + told + "0 or from 2^-24 to 2^24"),
                ("frequency", "1e14", "octaves: a number is not finite or outside its interval"),
                ("mask-band", "1", "two numbers from -16 to 16"),
                ("size", "0x64", "from 1 to 1000000"),
                ("size", "8192x4096", "at most 2^24 samples")]:
            with self.subTest(f"{name} {text}"):
                self.type(name, text)
                marked = self.page.run(
                    "[...document.querySelectorAll('[aria-invalid=true]')].map(e => e.id)")
                # The last octave's frequency is told of octaves.
                place = "octaves" if name == "frequency" else name
                self.assertEqual(marked, ["p-" + place])
                self.assertIn(message, self.shown(f"#p-{place}-message"))
                self.assertIn(message, self.shown("#notice"))
                self.page.run(f"playground.change({{{name!r}: undefined}})")
                self.assertEqual(self.page.run(
                    "document.querySelectorAll('[aria-invalid=true]').length"), 0)
                self.assertTrue(self.page.run("document.getElementById('notice').hidden"))
        self.page.run("playground.change({size: '64x64'})")
        self.ready()
        self.assertEqual(self.hash(), hash_of(words))

    def test_intervals_are_those_of_the_program(self):
        """What the page takes for valid, the program takes, and the other way round."""
        self.open(["--size", "8x8", "--octaves", "1"])
        rows = self.page.run("""import("./parameters.js").then(({ROWS}) => [...ROWS.values()]
            .filter(row => row.lowest !== undefined && row.kind !== "point" && !row.prefix)
            .map(({name, lowest, highest, kind}) => ({name, lowest, highest, kind})))""")
        self.assertGreater(len(rows), 15)
        for row in rows:
            for number in (row["lowest"], row["highest"], row["highest"] * 1.001,
                           row["lowest"] * 0.999 if row["lowest"] > 0
                           else row["lowest"] * 1.001 - 1e-300):
                text = repr(number)
                self.page.run(f"playground.change({{{row['name']!r}: '{text}'}})")
                wrong = self.page.run(f"playground.checked.messages.has({row['name']!r})")
                said = subprocess.run(
                    [PROGRAM, "terrain", "--size", "8x8", "--octaves", "1", f"--{row['name']}",
                     text, "--heights", "r32:-", "--quiet"], stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE, text=True).stderr
                with self.subTest(f"{row['name']} {text}"):
                    self.assertEqual(wrong, f"--{row['name']}: " in said, said)
                self.page.run(f"playground.change({{{row['name']!r}: undefined}})")
        self.ready()

    def test_the_url_has_the_state(self):
        words = ["--preset", "volcanic", *PLACE, "--gain", "0.41", "--sea-level", "-0.2",
                 "--base-octaves", "4"]
        self.open(words, view="hillshade")
        self.type("seed", "12")
        self.page.run("document.getElementById('p-rotate').click()")
        self.page.run("document.querySelector('[data-name=crater] .back') && "
                      "playground.change({crater: null})")
        self.ready()
        before = self.hash(), self.greys()
        self.page.run("playground.flushHash()")
        url = self.page.run("location.href")
        self.leave()
        self.page.open(url)
        self.ready()
        self.assertEqual(self.page.run("playground.flushHash(), location.href"), url)
        self.assertEqual((self.hash(), self.greys()), before)
        self.assertEqual(self.page.run("playground.state.given.seed"), "12")

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
        words = ["--warp-reach", "20", "--warp-octaves", "12"] + PLACE
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

    # What leaves the page

    def copied(self, kind):
        self.click(f"[data-copy={kind}]")
        self.page.wait("document.getElementById('code').open")
        text = self.page.run("document.getElementById('code-text').value")
        self.page.run("document.getElementById('code').close()")
        return text

    def run_copy(self, kind, text, folder):
        """Runs a copy in a folder, to which it writes heights.r32 and hillshade.pgm."""
        if kind == "c":
            with open(os.path.join(folder, "terrain.c"), "w", encoding="utf-8") as file:
                file.write(text)
            subprocess.run([*CC.split(), "-O1", "-Wall", "-Wextra", "-Werror",
                            "-ffp-contract=off", "-I", os.path.join(ROOT, "include"),
                            "terrain.c", "-L", LIBRARY, "-Wl,-rpath," + LIBRARY, "-lscarp", "-lm",
                            "-o", "terrain"], check=True, cwd=folder)
            subprocess.run(["./terrain"], check=True, cwd=folder)
        elif kind == "command":
            bin = os.path.join(folder, "bin")
            os.mkdir(bin)
            os.symlink(PROGRAM, os.path.join(bin, "scarp"))
            subprocess.run(["sh", "-e", "-c", text], check=True, cwd=folder,
                           stdout=subprocess.DEVNULL,
                           env=dict(os.environ, PATH=bin + ":" + os.environ["PATH"]))
        else:
            package = os.path.join(folder, "node_modules", "scarp-noise")
            os.makedirs(package)
            for name in os.listdir(SITE):
                if name.endswith((".mjs", ".wasm")):
                    shutil.copy(os.path.join(SITE, name), package)
            with open(os.path.join(package, "package.json"), "w", encoding="utf-8") as file:
                file.write('{"type": "module", "exports": "./scarp.mjs"}')
            with open(os.path.join(folder, "terrain.mjs"), "w", encoding="utf-8") as file:
                file.write(text)
            subprocess.run([NODE, "terrain.mjs"], check=True, cwd=folder)

    def test_copies_have_the_bits_of_the_program(self):
        kinds = ["c", "command"] + (["javascript"] if NODE else [])
        cases = {**CASES, **{name: ["--preset", name, "--seed", "9"]
                             for name in ("alps", "dunes", "volcanic", "badlands")}}
        for name, words in cases.items():
            words = PLACE + words
            self.open(words)
            heights, shade = hash_of(words), hillshade_of(words)
            for kind in kinds:
                with self.subTest(f"{name} as {kind}"), \
                        tempfile.TemporaryDirectory(dir=self.scratch) as folder:
                    self.run_copy(kind, self.copied(kind), folder)
                    with open(os.path.join(folder, "heights.r32"), "rb") as file:
                        self.assertEqual(hashlib.sha256(file.read()).hexdigest(), heights)
                    with open(os.path.join(folder, "hillshade.pgm"), "rb") as file:
                        self.assertTrue(file.read().split(b"\n255\n", 1)[1] == shade)

    def test_a_command_line_without_what_the_preset_has(self):
        """Flags of a preset cannot be taken back on a command line: it is told without its name."""
        self.open(["--preset", "volcanic", *PLACE])
        self.page.run("playground.change({rotate: '0', crater: null})")
        self.ready()
        text = self.copied("command")
        self.assertNotIn("--preset", text)
        self.assertNotIn("--crater", text)
        with tempfile.TemporaryDirectory(dir=self.scratch) as folder:
            self.run_copy("command", text, folder)
            with open(os.path.join(folder, "heights.r32"), "rb") as file:
                self.assertEqual(hashlib.sha256(file.read()).hexdigest(), self.hash())

    def test_the_clipboard(self):
        self.open(["--preset", "hills", "--size", "32x32", "--gain", "0.4"])
        self.page.call("Browser.grantPermissions",
                       permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        text = self.copied("command")
        self.assertEqual(self.page.run("navigator.clipboard.readText()"), text)
        self.assertIn("Copied", self.shown("#code-note"))
        self.click("#copy-link")
        self.page.wait("document.getElementById('copy-link').textContent === 'Copied'")
        self.assertEqual(self.page.run("navigator.clipboard.readText()"),
                         self.page.run("location.href"))
        self.assertIn("gain=0.4", self.page.run("location.href"))
        self.page.call("Browser.resetPermissions")

    def test_downloads(self):
        words = ["--preset", "islands", "--phase", "0", *PLACE]  # a phase has its own range
        self.open(words)
        folder = os.path.join(self.scratch, "downloads")
        self.page.call("Browser.setDownloadBehavior", behavior="allowAndName",
                       downloadPath=folder, eventsEnabled=True)
        for kind, option in (("png", "png"), ("r16", "r16"), ("npy", "npy")):
            with self.subTest(kind):
                self.page.downloads.clear()
                self.click(f"[data-save={kind}]")
                self.page.wait("true")
                while not (self.page.downloads and
                           all(done for _, done in self.page.downloads.values())):
                    message = self.page.receive(10)
                    self.assertIsNotNone(message, "the download ends")
                    self.page.note(message)
                (guid, (name, _)), = self.page.downloads.items()
                self.assertEqual(name, f"scarp-islands-1.{kind}")
                with open(os.path.join(folder, guid), "rb") as file:
                    got = file.read()
                if kind == "png":
                    got, expected = pixels(got), pixels(program(*words, "--heights", "png:-"))
                else:
                    expected = program(*words, "--heights", option + ":-")
                self.assertTrue(got == expected)

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


def pixels(png):
    """Size and decoded rows of a PNG with one 16-bit channel."""
    import struct
    import zlib
    data, at, head = b"", 8, None
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + size]
        head = body if kind == b"IHDR" else head
        data += body if kind == b"IDAT" else b""
        assert zlib.crc32(kind + body) == struct.unpack(">I", png[at + 8 + size:at + 12 + size])[0]
        at += 12 + size
    width, height = struct.unpack(">II", head[:8])
    assert head[8:10] == b"\x10\0"
    raw, row, rows = zlib.decompress(data), 2 * width, []
    above = bytes(row)
    for y in range(height):
        kind, line = raw[y * (row + 1)], bytearray(raw[y * (row + 1) + 1:(y + 1) * (row + 1)])
        for x in range(row):
            a, b = line[x - 2] if x >= 2 else 0, above[x]
            c = above[x - 2] if x >= 2 else 0
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[x] = (line[x] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        rows.append(bytes(line))
        above = rows[-1]
    return (width, height), rows


if __name__ == "__main__":
    for tool, path in (("chromium", CHROMIUM), ("the page", SITE), ("the program", PROGRAM)):
        if not os.path.exists(path):
            is_required = "chromium" in os.environ.get("SCARP_REQUIRE_TOOLS", "").split(",")
            print(f"{'FAILED (required)' if is_required else 'skipped'}: {tool} is missing")
            sys.exit(1 if is_required else SKIPPED)
    unittest.main()
