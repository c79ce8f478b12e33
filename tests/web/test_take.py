# SPDX-License-Identifier: MIT
"""Tests what people take away from the playground: see playground.py."""
import gzip
import hashlib
import os
import re
import shutil
import struct
import subprocess
import tempfile
import zlib

from playground import (CASES, CC, LIBRARY, NODE, PLACE, PROGRAM, ROOT, SITE, Playground, hash_of,
                        hillshade_of, main, program)

# Gzipped bytes of what browsers load: the page and its text editor, and what buttons make them load
SIZES_MOST = {"": 146_000, "graph": 54_000, "view3d": 8_500, "gpu": 4_500}
KINDS = ["c", "command"] + (["javascript"] if NODE else [])


def pixels(png):
    """Size and decoded rows of a PNG with one 16-bit channel, or four of 8 bits."""
    data, at, head = b"", 8, None
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + size]
        head = body if kind == b"IHDR" else head
        data += body if kind == b"IDAT" else b""
        assert zlib.crc32(kind + body) == struct.unpack(">I", png[at + 8 + size:at + 12 + size])[0]
        at += 12 + size
    width, height = struct.unpack(">II", head[:8])
    step = {b"\x10\0": 2, b"\x08\x06": 4}[head[8:10]]
    raw, row, rows = zlib.decompress(data), step * width, []
    above = bytes(row)
    for y in range(height):
        kind, line = raw[y * (row + 1)], bytearray(raw[y * (row + 1) + 1:(y + 1) * (row + 1)])
        for x in range(row):
            a, b = line[x - step] if x >= step else 0, above[x]
            c = above[x - step] if x >= step else 0
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[x] = (line[x] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        rows.append(bytes(line))
        above = rows[-1]
    return (width, height), rows


class Take(Playground):
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
        cases = {**CASES, **{name: ["--preset", name, "--seed", "9"]
                             for name in ("alps", "dunes", "volcanic")}}
        for name, words in cases.items():
            words = PLACE + words
            self.open(words)
            heights, shade = hash_of(words), hillshade_of(words)
            for kind in KINDS:
                with self.subTest(f"{name} as {kind}"), \
                        tempfile.TemporaryDirectory(dir=self.scratch) as folder:
                    self.run_copy(kind, self.copied(kind), folder)
                    with open(os.path.join(folder, "heights.r32"), "rb") as file:
                        self.assertEqual(hashlib.sha256(file.read()).hexdigest(), heights)
                    with open(os.path.join(folder, "hillshade.pgm"), "rb") as file:
                        self.assertTrue(file.read().split(b"\n255\n", 1)[1] == shade)

    def test_copies_of_a_recipe(self):
        """The text is one that gives the same heights; nothing in it is mistaken for code."""
        self.open(["--preset", "canyon", *PLACE, "--set", "height=100", "--set", "strata=3"])
        path = self.file("canyon.recipe", self.copied("recipe"))
        self.assertEqual(hash_of([*PLACE, "--recipe", path]), self.hash())
        text = "recipe 1\n# END\n#'quotes' \\ `${and}` ??/ more: ä 🏔\nout a = 90 * noise(size=77)\n"
        self.open(PLACE, text=text)
        for kind in KINDS:
            with tempfile.TemporaryDirectory(dir=self.scratch) as folder:
                self.run_copy(kind, self.copied(kind), folder)
                with open(os.path.join(folder, "heights.r32"), "rb") as file:
                    self.assertEqual(hashlib.sha256(file.read()).hexdigest(), self.hash())

    def test_a_recipe_with_an_error_is_not_copied_as_code(self):
        self.open(PLACE, text="recipe 1\nout a = 9 * noise(size=60)\n")
        self.write("recipe 1\nout a = 9 * nose(size=60)\n")
        for kind, title in (("c", "C"), ("command", "Command line"), ("javascript", "JavaScript")):
            self.click(f"[data-copy={kind}]")
            self.assertFalse(self.page.run("document.getElementById('code').open"))
            self.assertRegex(self.shown("#said"), f"^Not copied as {title}: line 2: ")
            self.assertFalse(self.page.run("document.getElementById('said').hidden"))
            self.assertEqual(self.page.run("document.activeElement.className"), "cm-content")
            state = "playground.work.editor.view.state"
            self.assertEqual(self.page.run(f"{state}.sliceDoc({state}.selection.main.from, "
                                           f"{state}.selection.main.to)"), "nose(size=60)")
            self.page.run("document.getElementById('said').textContent = ''")
        self.assertIn("nose(size", self.copied("recipe"))

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
        self.assertIn("#recipe=", self.page.run("location.href"))
        self.page.call("Browser.resetPermissions")

    def download(self, kind):
        """The name and the bytes of what a button saves."""
        folder = os.path.join(self.scratch, "downloads")
        self.page.call("Browser.setDownloadBehavior", behavior="allowAndName",
                       downloadPath=folder, eventsEnabled=True)
        self.page.downloads.clear()
        self.click(f"[data-save={kind}]")
        while not (self.page.downloads and
                   all(done for _, done in self.page.downloads.values())):
            message = self.page.receive(10)
            self.assertIsNotNone(message, "the download ends")
            self.page.note(message)
        (guid, (name, _)), = self.page.downloads.items()
        with open(os.path.join(folder, guid), "rb") as file:
            return name, file.read()

    def test_heights(self):
        words = ["--preset", "islands", *PLACE]
        self.open(words)
        for kind in ("png", "r16", "npy"):
            with self.subTest(kind):
                name, got = self.download(kind)
                self.assertEqual(name, f"scarp-islands-1.{kind}")
                expected = program(*words, "--heights", kind + ":-")
                if kind == "png":
                    got, expected = pixels(got), pixels(expected)
                self.assertTrue(got == expected)

    def test_statements_are_saved_as_outputs(self):
        text = "recipe 1\nbend = noise(size=90, amplitude=20)\nout a = 9 * bend\n"
        path = self.file("bend.recipe", text + "out node = bend\n")
        self.open(PLACE, text=text)
        self.page.run("playground.setNode('bend')")
        self.ready()
        name, got = self.download("r16")
        self.assertEqual(name, "scarp-recipe-bend-1.r16")
        self.assertTrue(got == program(*PLACE, "--recipe", path, "--out", "node=r16:-"))
        self.page.run("playground.setNode('')")
        self.ready()

    def test_masks(self):
        seen = set()
        for preset, step in (("alps", "9"), ("islands", "25"), ("dunes", "3")):
            words = ["--preset", preset, "--size", "160x120", "--step", step]
            self.open(words)
            stem = os.path.join(self.scratch, "mask.png")
            program(*words, "--masks", stem)
            for part in "12":
                name, got = self.download("masks-" + part)
                self.assertEqual(name, f"scarp-{preset}-1-masks-{part}.png")
                with open(stem.replace(".png", f"-{part}.png"), "rb") as file:
                    expected = pixels(file.read())
                self.assertTrue(pixels(got) == expected, f"{preset} {part}")
                seen.update(b"".join(expected[1]))
        self.assertGreater(len(seen), 99)

    def test_picture(self):
        self.open(["--preset", "hills", "--size", "40x30"], view="slope")
        name, got = self.download("view")
        self.assertEqual((name, got[:4], struct.unpack(">II", got[16:24])),
                         ("scarp-hills-1-slope.png", b"\x89PNG", (40, 30)))

    def test_size_of_the_page(self):
        """All that browsers may load, but for WebAssembly and shaders, by what needs it"""
        sizes = dict.fromkeys(SIZES_MOST, 0)
        for name in os.listdir(SITE):
            if name.endswith((".js", ".css", ".html")):
                part = re.match(r"graph|view3d|gpu|", name).group(0)
                with open(os.path.join(SITE, name), "rb") as file:
                    sizes[part] += len(gzip.compress(file.read(), 9))
        print(f"gzipped: {sizes}, in all {sum(sizes.values())} bytes")
        for part, most in SIZES_MOST.items():
            self.assertTrue(1000 < sizes[part] < most, sizes)
        with open(os.path.join(SITE, "LICENSES.txt"), encoding="utf-8") as file:
            self.assertIn("@codemirror/view", file.read())


if __name__ == "__main__":
    main()
