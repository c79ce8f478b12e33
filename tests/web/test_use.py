# SPDX-License-Identifier: MIT
"""Tests what people do with the playground, and what they take away: see playground.py."""
import hashlib
import os
import shutil
import struct
import subprocess
import tempfile
import zlib

from playground import (CASES, CC, LIBRARY, NODE, PLACE, PROGRAM, ROOT, SITE, Playground, hash_of,
                        hillshade_of, main, program)


def pixels(png):
    """Size and decoded rows of a PNG with one 16-bit channel."""
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


class Use(Playground):
    def type(self, name, text):
        self.page.run(f"""(() => {{
            const field = document.getElementById("p-{name}");
            field.closest("details").open = true;
            field.focus();
            field.value = {text!r};
            field.dispatchEvent(new Event("input", {{bubbles: true}}));
        }})()""")

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
        words = ["--preset", "badlands", "--size", "96x96"]
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
        self.assertGreater(len(found), 50)
        self.assertEqual([role for role, name in found if name == "" and role != "group"], [])
        for what in (("slider", "Step"), ("textbox", "Step"), ("group", "Parameters of the recipe"),
                     ("textbox", "Text of the recipe"), ("slider", "gully"),
                     ("button", "Copy as JavaScript"), ("radio", "Relief"),
                     ("image", "Map of the terrain alps, seed 1, relief")):
            self.assertIn(what, found)

    def test_wrong_numbers_are_marked(self):
        words = ["--size", "64x64"]
        self.open(words)
        told = "is not a number "
        for name, text, message in [
                ("gain", "17", told + "from 1/16 to 16"),
                ("octaves", "33", told + "above 2^-150, at most 32"), ("octaves", "0", told),
                ("lacunarity", "two", told + "from 1/16 to 16"),
                ("amplitude", "", told + "of a magnitude from 2^-24 to 2^24"),
                ("seed", "18446744073709551616", "from 0 to 2^64 - 1"),
                ("height", "-1", told + "from 0 to 2^24"),
                ("frequency", "1e14", "octaves: "),
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
            .filter(row => row.lowest !== undefined && row.kind !== "point")
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
        for words, name, number in ((["--preset", "volcanic", *PLACE, "--set", "height=300"], "height", "301"),
                                    ([*PLACE, "--gain", "0.41", "--sea-level", "-0.2"], "gain", "0.3")):
            self.open(words, view="hillshade")
            self.type("seed", "12")
            call = "setValue" if "--preset" in words else "change"
            argument = f"'{name}', '{number}'" if call == "setValue" else f"{{{name}: '{number}'}}"
            self.page.run(f"playground.{call}({argument})")
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
            npm = os.path.join(SITE, os.pardir, "npm")
            for name in os.listdir(npm):
                if name.endswith((".mjs", ".wasm")):
                    shutil.copy(os.path.join(npm, name), package)
            with open(os.path.join(package, "package.json"), "w", encoding="utf-8") as file:
                file.write('{"type": "module", "exports": "./scarp.mjs"}')
            with open(os.path.join(folder, "terrain.mjs"), "w", encoding="utf-8") as file:
                file.write(text)
            subprocess.run([NODE, "terrain.mjs"], check=True, cwd=folder)

    def test_copies_have_the_bits_of_the_program(self):
        kinds = ["c", "command"] + (["javascript"] if NODE else [])
        cases = {**CASES, **{name: ["--preset", name, "--seed", "9"]
                             for name in ("alps", "dunes", "volcanic")},
                 "with a tile": ["--preset", "none", "--period", "128x64", "--rotate"][:4]}
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

    def test_copies_of_a_recipe(self):
        """The text is one that gives the same heights, with the values that were set."""
        self.open(["--preset", "canyon", *PLACE, "--set", "height=100", "--set", "strata=3"])
        path = os.path.join(self.scratch, "canyon.recipe")
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.copied("recipe"))
        self.assertEqual(hash_of([*PLACE, "--recipe", path]), self.hash())
        text = "recipe 1\nout a = 90 * noise(size=77, octaves=3) # 'quotes' \\ and more\n"
        self.open(PLACE, text=text)
        for kind in ["c", "command"] + (["javascript"] if NODE else []):
            with tempfile.TemporaryDirectory(dir=self.scratch) as folder:
                self.run_copy(kind, self.copied(kind), folder)
                with open(os.path.join(folder, "heights.r32"), "rb") as file:
                    self.assertEqual(hashlib.sha256(file.read()).hexdigest(), self.hash())

    def test_the_clipboard(self):
        self.open(["--preset", "hills", "--size", "32x32", "--set", "gully=0.04"])
        self.page.call("Browser.grantPermissions",
                       permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        text = self.copied("command")
        self.assertEqual(self.page.run("navigator.clipboard.readText()"), text)
        self.assertIn("Copied", self.shown("#code-note"))
        self.click("#copy-link")
        self.page.wait("document.getElementById('copy-link').textContent === 'Copied'")
        self.assertEqual(self.page.run("navigator.clipboard.readText()"),
                         self.page.run("location.href"))
        self.assertIn("gully%3D0.04", self.page.run("location.href"))
        self.page.call("Browser.resetPermissions")

    def test_downloads(self):
        words = ["--preset", "islands", *PLACE]
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


if __name__ == "__main__":
    main()
