#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures how many frames a second the playground shows.

    speed.py map CHROMIUM PLAYGROUND [OPTION...]      while a slider is dragged
    speed.py space CHROMIUM PLAYGROUND [OPTION...]    in space

PLAYGROUND is the folder with the assembled page; options go to the browser. Frames of the map are
whole here, as large as the raster; the page itself shows previews with fewer samples where there is
no time. WebGPU is that of the adapter that is named, here one in software. The view in space has
900 x 600 pixels, the terrain 512 x 512 samples. The camera turns, so that each frame differs from the
one before; reading a pixel waits for the end of each.
"""
import itertools
import shutil
import sys
import tempfile

from chromium import Chromium, end, serve

PRESETS = ("hills", "alps")
SIZES = ("512x512", "1024x1024")
VIEWS = ("hillshade", "relief")
SAMPLERS = ("wasm", "WebGPU")
READY = "document.documentElement?.dataset.ready === 'yes' && playground.work.editor !== null"
GPU = "document.getElementById('status-gpu').textContent"
DRAG = """new Promise(done => {
    const slider = document.getElementById("p-height-slider"), page = globalThis.playground;
    clearTimeout(page.settling);
    const show = page.show.bind(page), begin = performance.now();
    let shown = 0, ms = 0, moves = 0;
    page.sampleMs = 0;
    page.pool.onFrame = frame => {
        shown += frame.job.isExact ? 0 : 1;
        ms += frame.job.isExact ? 0 : frame.ms;
        show(frame);
        page.sampleMs = 1e-9; // so fast that there is no need of previews
    };
    const move = () => {
        slider.value = 600 + 200 * Math.sin(moves++ / 20);
        slider.dispatchEvent(new Event("input", {bubbles: true}));
        const seconds = (performance.now() - begin) / 1000;
        if (seconds < 5 || shown < 3) {
            requestAnimationFrame(move);
        } else {
            page.pool.onFrame = show;
            done([shown / seconds, ms / shown, page.pool.workers.length]);
        }
    };
    move();
})"""
SPACE_PRESETS = ("alps", "islands", "dunes")
SPACE_SIZE = (900, 600)
FLY = """(async () => {
    const world = globalThis.playground.world, {gl, canvas} = world, pixel = new Uint8Array(4);
    const end = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    const turn = async (ms, draw) => {
        const begin = performance.now();
        let count = 0;
        for (; performance.now() - begin < ms; count++) {
            world.pose.yaw += 0.01;
            draw();
            end();
            await new Promise(requestAnimationFrame);
        }
        return 1000 * count / (performance.now() - begin);
    };
    await turn(1000, () => world.draw()); // learns how long frames take
    const moving = await turn(5000, () => world.flight.moving());
    const resting = await turn(3000, () => world.draw());
    const last = globalThis.playground.last, begin = performance.now();
    for (let i = 0; i < 5; i++) {
        world.show({...last});
        end();
    }
    return [canvas.width, canvas.height, moving, resting, (performance.now() - begin) / 5];
})()"""


def measure_map(browser, page):
    browser.size(1200, 800)
    for preset, size, view, by in itertools.product(PRESETS, SIZES, VIEWS, SAMPLERS):
        browser.open(f"{page}#preset={preset}&step=4"
                     f"&size={size}&view={view}{'&gpu=1' if by == 'WebGPU' else ''}")
        browser.wait(READY)
        if by == "WebGPU":
            browser.wait(f"{GPU}.startsWith('wasm goes on') || playground.last.isGpu", 120)
            by = browser.run(GPU)
            browser.wait(READY)
        frames, ms, workers = browser.run(DRAG)
        print(f"{preset} {size} {view}, {by}: {frames:.1f} frames a second, of which each "
              f"takes {workers} workers {ms:.1f} ms", flush=True)


def measure_space(browser, page):
    browser.size(1300, 800)
    for preset in SPACE_PRESETS:
        browser.open(f"{page}#preset={preset}&size=512x512&step=8&view=relief&space=3d")
        browser.wait("document.documentElement?.dataset.ready === 'yes'")
        browser.run(f"""Object.assign(document.getElementById("world").style,
            {{width: "{SPACE_SIZE[0]}px", height: "{SPACE_SIZE[1]}px"}})""")
        width, height, moving, resting, shown = browser.run(FLY)
        print(f"{preset} in {width} x {height}: {moving:.1f} frames a second while the camera "
              f"moves, {resting:.1f} with all details; a new terrain takes {shown:.0f} ms",
              flush=True)


def main():
    what, chromium, playground, *options = sys.argv[1:]
    scratch = tempfile.mkdtemp(prefix="scarp-web-")
    server = serve(playground)
    browser = Chromium(chromium, scratch, *options)
    try:
        {"map": measure_map, "space": measure_space}[what](
            browser, f"http://127.0.0.1:{server.server_port}/index.html")
    finally:
        browser.close()
        end(server)
        shutil.rmtree(scratch, ignore_errors=True)


if __name__ == "__main__":
    main()
