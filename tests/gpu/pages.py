#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pages of src/gpu/samples in headless Chromium: they draw what the heights and slopes of the
library give, and their console is silent.

    pages.py webgpu|webgl CHROMIUM WRITE_RELIEF SOURCE [SCREENSHOT.png]

The exit status is 77 where the browser has no such context.
"""
import array
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # among the sources
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "web"), str(HERE.parent / "cli")]
from chromium import Chromium, serve  # noqa: E402
from rasters import decode_png  # noqa: E402

SKIPPED = 77
WIDTH, HEIGHT = 800, 450
TOLERANCE = 2  # of 255: shaders only approximate roots and smoothstep
STEP = 7  # of the pixels that are compared
# Without a GPU, Chromium puts pictures of WebGPU on a page only where it draws pages with Vulkan, too.
OPTIONS = ["--use-vulkan=swiftshader", "--enable-features=Vulkan"]
SHADERS = {"webgpu": "scarp.wgsl", "webgl": "scarp.glsl"}


def smoothstep(low, high, x):
    t = min(max((x - low) / (high - low), 0), 1)
    return t * t * (3 - 2 * t)


def mix(a, b, t):
    return [x + (y - x) * t for x, y in zip(a, b)]


def color(height, dx, dy):
    """What the shaders of both pages give, 0 to 255."""
    up = 1 / math.sqrt(dx * dx + dy * dy + 1)
    light = max(up * (0.55 * dx + 0.55 * dy + 0.63), 0) + 0.2 * up
    white = smoothstep(122, 140, height) * smoothstep(0.5, 0.7, up)
    green = smoothstep(0.5, 0.75, up) * (1 - smoothstep(110, 136, height))
    rock = mix((0.42, 0.36, 0.30), (0.28, 0.31, 0.13), green)
    return [255 * min(math.sqrt(light * c), 1) for c in mix(rock, (0.9, 0.93, 0.98), white)]


def compare(pixels, shot):
    """Complains of the first pixel that is of another color; `pixels` as write_relief writes."""
    count = WIDTH * HEIGHT
    assert len(pixels) == 3 * count
    seen = set()
    for i in range(0, count, STEP):
        expected = color(*(pixels[k * count + i] for k in range(3)))
        got = shot[i // WIDTH][i % WIDTH]
        seen.add(got)
        if max(abs(a - b) for a, b in zip(expected, got)) > TOLERANCE:
            sys.exit(f"pixel {i % WIDTH},{i // WIDTH} is {got}, not {expected}")
    print(f"{len(range(0, count, STEP))} pixels are right, of {len(seen)} colors")


def look(page, url, screenshot):
    """The rows of the canvas, as the page shows it."""
    page.size(WIDTH + 40, HEIGHT + 100)
    page.open(url)
    page.wait("document.querySelector('p')?.textContent.length > 0 && "
              "document.querySelector('p').textContent !== 'The shader compiles.'", 120)
    said = page.run("document.querySelector('p').textContent")
    print(said)
    if said.startswith("this browser has no"):
        required = "chromium" in os.environ.get("SCARP_REQUIRE_TOOLS", "").split(",")
        sys.exit(1 if required else SKIPPED)
    page.screenshot(screenshot)
    if said != "Drawn." or page.console:
        sys.exit(f"the page says {said!r}, its console {page.console}")
    left, top = page.run("(({x, y}) => [x, y])"
                         "(document.querySelector('canvas').getBoundingClientRect())")
    picture = decode_png(pathlib.Path(screenshot).read_bytes())
    return [row[int(left):int(left) + WIDTH] for row in picture.rows[int(top):int(top) + HEIGHT]]


def main():
    name, program, write_relief, source, *screenshot = sys.argv[1:]
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        site = pathlib.Path(scratch, "site")
        site.mkdir()
        source = pathlib.Path(source)
        shutil.copy(source / "src/gpu/samples" / f"{name}.html", site)
        shutil.copy(source / "include" / SHADERS[name], site)
        subprocess.run([write_relief, site / "relief.plan", f"{scratch}/pixels"], check=True)
        pixels = array.array("f", pathlib.Path(scratch, "pixels").read_bytes())
        server = serve(str(site))
        page = Chromium(program, scratch, *(OPTIONS if name == "webgpu" else []))
        try:
            shot = look(page, f"http://127.0.0.1:{server.server_port}/{name}.html",
                        screenshot[0] if screenshot else f"{scratch}/page.png")
        finally:
            page.close()
            server.shutdown()
    compare(pixels, shot)


if __name__ == "__main__":
    main()
