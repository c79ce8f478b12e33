# SPDX-License-Identifier: MIT
"""What the tests of the playground share: the program, the browser, and what the page shows.

Pictures are asked for by the options of the program, which is what links of older pages name, too.

    test_NAME.py [CLASS.TEST...]

The environment says where things are: SCARP_PROGRAM, SCARP_CHROMIUM, SCARP_PLAYGROUND (the
assembled page), SCARP_CC and SCARP_LIBRARY (a C compiler, and the folder of the shared library),
SCARP_NODE, which may be empty. SCARP_REQUIRE_TOOLS with "chromium" in it turns a skipped test into
a failure.
"""
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

from chromium import Chromium, end, serve

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, os.pardir, os.pardir)
sys.dont_write_bytecode = True

SKIPPED = 77
PATIENCE = 60  # seconds for a picture
PROGRAM, CHROMIUM, SITE, CC, LIBRARY, NODE = (
    os.environ.get("SCARP_" + name, "")
    for name in ("PROGRAM", "CHROMIUM", "PLAYGROUND", "CC", "LIBRARY", "NODE"))

# Rasters that do not lie at the origin, and are no squares
PLACE = ["--size", "160x120", "--origin", "-37.5,19", "--step", "2.5"]
# Each case has what others have not.
CASES = {
    "cut": ["--fractal", "turbulence", "--sea-level", "0.2", "--plateau", "0.6"],
    "flow": ["--phase", "0.3", "--fade", "cubic", "--lacunarity", "1.9", "--of-octaves", "12"],
    "no flow": ["--phase", "0", "--amplitude", "-0.7"],
    "cells": ["--basis", "cell-edge", "--jitter", "0.6", "--rotate", "--octaves", "2.5"],
    "fractals": ["--fractal", "pingpong", "--sharpness", "1.1", "--octaves", "4.4"],
    "defaults": ["--seed", "0", "--frequency", "1", "--octaves", "1", "--gain", "0.5", "--step",
                 "0.125"],
    "far": ["--origin", "1e12,-3e11", "--step", "0.125", "--seed", "0xfedcba9876543210",
            "--fractal", "jordan", "--erosion", "0.9", "--z-factor", "2", "--azimuth", "117",
            "--altitude", "30"],
    "repeats": ["--fractal", "ridged", "--period", "256x128", "--step", "8"],
    "values": ["--preset", "alps", "--set", "height=300", "--set", "gully=0.1"],
    "a sea": ["--preset", "islands", "--set", "sea=90", "--origin", "2000,1500", "--step", "9"],
}
FLAGS = ("--rotate",)


def presets():
    """The names of the program's presets"""
    with open(os.path.join(ROOT, "src", "cli", "presets", "presets.cmake"),
              encoding="utf-8") as file:
        return re.search(r"scarp_presets ([a-z ]+)\)", file.read()).group(1).split()


def program(*words, cwd=None):
    return subprocess.run([PROGRAM, "terrain", *words, "--quiet"], check=True, cwd=cwd,
                          stdout=subprocess.PIPE).stdout


def hash_of(words):
    return hashlib.sha256(program(*words, "--heights", "r32:-")).hexdigest()


def hillshade_of(words):
    """The bytes of the picture, without the head of the file."""
    return program(*words, "--hillshade", "pgm:-").split(b"\n255\n", 1)[1]


def fragment(words, **view):
    """The part of the URL behind # for options of the program, and for a `text`"""
    pairs, words = [], list(words)
    while words:
        name = words.pop(0)
        pairs.append((name[2:], "1" if name in FLAGS else words.pop(0)))
    if "text" in view:
        pairs.append(("preset", "own"))
    elif "preset" not in dict(pairs):
        pairs.append(("preset", "none"))
    return "#" + urllib.parse.urlencode(pairs + list(view.items()))


class Playground(unittest.TestCase):
    """A class of tests, with a browser of its own: it gets `options`, and goes without some"""
    options = without = ()

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.mkdtemp(prefix="scarp-web-")
        cls.addClassCleanup(shutil.rmtree, cls.scratch, ignore_errors=True)
        cls.server = serve(SITE)
        cls.addClassCleanup(end, cls.server)
        cls.page = Chromium(CHROMIUM, cls.scratch, *cls.options, without=cls.without)
        cls.addClassCleanup(cls.page.close)
        cls.page.size(1200, 800)
        cls.url = f"http://127.0.0.1:{cls.server.server_port}/index.html"

    def tearDown(self):
        said = list(self.page.console)
        self.page.console.clear()
        self.assertEqual(said, [], "the console is silent")

    def open(self, words=(), **view):
        """Opens the page anew, or if it is there, what the part of the URL behind # says."""
        hash = fragment(words, **view)
        if self.page.run("globalThis.playground === undefined"):
            self.page.open(self.url + hash)
        else:
            self.page.run(f"""new Promise(done => {{
                addEventListener("hashchange", done, {{once: true}});
                location.hash = "{hash}&once={self.page.number}";
            }})""")
        self.ready()

    def write(self, text):
        """Makes this the text, as one step of the history."""
        self.page.run(f"playground.work.setText({json.dumps(text)})")

    def text(self):
        return self.page.run("playground.work.editor.text")

    def file(self, name, text):
        """A file with a text"""
        path = os.path.join(self.scratch, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def module(self, name):
        """The address of a module as it is before it is bundled, for import() in the page"""
        if not hasattr(type(self), "sources"):
            type(self).sources = serve(os.path.join(ROOT, "src", "web"))
            self.addClassCleanup(end, self.sources)
        return f"http://127.0.0.1:{self.sources.server_port}/playground/{name}"

    def leave(self):
        self.page.call("Page.navigate", url="about:blank")
        self.page.wait("location.href === 'about:blank'")

    def ready(self):
        notice = "document.getElementById('notice')?.textContent"
        self.page.wait("(document.documentElement?.dataset.ready === 'yes' && "
                       f"playground.work.editor !== null) || {notice}?.length > 0", PATIENCE)
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

    def shown(self, element):
        return self.page.run(f"document.querySelector({element!r}).textContent")

    def assert_relief(self, words):
        expected = program(*words, "--relief", "ppm:-").split(b"\n255\n", 1)[1]
        self.assertTrue(bytes(self.page.run("""[...playground.whole.pixels].flatMap(
            p => [p & 255, p >> 8 & 255, p >> 16 & 255])""")) == expected)


def main():
    """Runs the tests of the program that was started, if what they need is there."""
    def skip(why):
        is_required = "chromium" in os.environ.get("SCARP_REQUIRE_TOOLS", "").split(",")
        print(f"{'FAILED (required)' if is_required else 'skipped'}: {why}")
        sys.exit(1 if is_required else SKIPPED)

    for tool, path in (("chromium", CHROMIUM), ("the page", SITE), ("the program", PROGRAM)):
        if not os.path.exists(path):
            skip(f"{tool} is missing")
    result = unittest.main(exit=False).result
    if result.wasSuccessful() and result.skipped:
        skip(result.skipped[0][1])
    sys.exit(not result.wasSuccessful())
