#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures how many frames a second the playground shows while a slider is dragged.

    speed.py CHROMIUM PLAYGROUND [OPTION...]

PLAYGROUND is the folder with the assembled page; options go to the browser. Frames are whole here,
as large as the raster; the page itself shows previews with fewer samples where there is no time.
WebGPU is that of the adapter that is named, here one in software.
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


def main():
    scratch = tempfile.mkdtemp(prefix="scarp-web-")
    server = serve(sys.argv[2])
    browser = Chromium(sys.argv[1], scratch, *sys.argv[3:])
    try:
        browser.size(1200, 800)
        for preset, size, view, by in itertools.product(PRESETS, SIZES, VIEWS, SAMPLERS):
            browser.open(f"http://127.0.0.1:{server.server_port}/index.html#preset={preset}&step=4"
                         f"&size={size}&view={view}{'&gpu=1' if by == 'WebGPU' else ''}")
            browser.wait(READY)
            if by == "WebGPU":
                browser.wait(f"{GPU}.startsWith('wasm goes on') || playground.last.isGpu", 120)
                by = browser.run(GPU)
                browser.wait(READY)
            frames, ms, workers = browser.run(DRAG)
            print(f"{preset} {size} {view}, {by}: {frames:.1f} frames a second, of which each "
                  f"takes {workers} workers {ms:.1f} ms", flush=True)
    finally:
        browser.close()
        end(server)
        shutil.rmtree(scratch, ignore_errors=True)


if __name__ == "__main__":
    main()
