#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures how many frames a second the view in space of the playground draws.

    speed_space.py CHROMIUM PLAYGROUND [OPTION...]

PLAYGROUND is the folder with the assembled page; options go to the browser. The view has 900 x 600
pixels, the terrain 512 x 512 samples. The camera turns, so that each frame differs from the one
before; reading a pixel waits for the end of each.
"""
import shutil
import sys
import tempfile

from chromium import Chromium, end, serve

PRESETS = ("alps", "islands", "dunes")
SIZE = (900, 600)
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


def main():
    scratch = tempfile.mkdtemp(prefix="scarp-web-")
    server = serve(sys.argv[2])
    browser = Chromium(sys.argv[1], scratch, *sys.argv[3:])
    try:
        browser.size(1300, 800)
        for preset in PRESETS:
            browser.open(f"http://127.0.0.1:{server.server_port}/index.html"
                         f"#preset={preset}&size=512x512&step=8&view=relief&space=3d")
            browser.wait("document.documentElement?.dataset.ready === 'yes'")
            browser.run(f"""Object.assign(document.getElementById("world").style,
                {{width: "{SIZE[0]}px", height: "{SIZE[1]}px"}})""")
            width, height, moving, resting, shown = browser.run(FLY)
            print(f"{preset} in {width} x {height}: {moving:.1f} frames a second while the camera "
                  f"moves, {resting:.1f} with all details; a new terrain takes {shown:.0f} ms",
                  flush=True)
    finally:
        browser.close()
        end(server)
        shutil.rmtree(scratch, ignore_errors=True)


if __name__ == "__main__":
    main()
