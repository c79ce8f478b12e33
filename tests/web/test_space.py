# SPDX-License-Identifier: MIT
"""Tests what the view in space of the playground shows: see playground.py."""
import math
import random

from playground import Playground, main

FOCAL = 1 / math.tan(0.45)  # of camera.js
FLAT = "recipe 1\nout a = 0 * x\n"
# A ridge from north to south, at the middle of 128 samples
RIDGE = "recipe 1\nout a = 30 * (1 - smoothstep(abs(x - 63.5), 0, 9))\n"
RADIUS = 0.8  # degrees, of the sun of sunlight.js

READ = """(() => {
    const {gl, canvas} = playground.world, pixel = new Uint8Array(4);
    return [%s].map(([x, y]) => {
        gl.readPixels(Math.floor((0.5 + 0.5 * x) * canvas.width),
            Math.floor((0.5 + 0.5 * y) * canvas.height), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        return [...pixel];
    });
})()"""


def apart(a, b):
    return sum(abs(p - q) for p, q in zip(a[:3], b[:3]))


def light(pixel):
    return sum(pixel[:3])


def pose(eye, yaw=0.0, pitch=0.0):
    return ",".join(f"{number:.3f}" for number in (*eye, yaw, pitch))


class Space(Playground):
    def look(self, camera, text, view="hillshade", azimuth=270, altitude=35, **more):
        """Opens a terrain of 128 x 128 samples of 1, from a camera."""
        self.open(["--size", "128x128", "--azimuth", str(azimuth), "--altitude", str(altitude)],
                  text=text, view=view, space="3d", camera=camera, **more)
        self.page.run("new Promise(done => setTimeout(done, 50))")
        self.page.run("playground.world.pace = 0, playground.world.draw()")

    def read(self, *places):
        """Pixels at places from -1 to 1, to the right and up"""
        return self.page.run(READ % ",".join(f"[{x}, {y}]" for x, y in places))

    def sky(self, *places):
        """What would be at places without any terrain"""
        self.page.run("(gl => { gl.drawElements = () => {}; playground.world.draw(); "
                      "delete gl.drawElements; })(playground.world.gl)")
        pixels = self.read(*places)
        self.page.run("playground.world.draw()")
        return pixels

    def from_above(self, east, height=1.2):
        """Where a camera that looks down from a height sees the place so far east of the middle"""
        aspect = self.page.run("playground.world.canvas.width / playground.world.canvas.height")
        return (east * FOCAL / aspect / height, 0.0)

    def test_the_block_has_sides_and_a_base(self):
        """No ray below the edge of the terrain meets the sky."""
        middle = (0.0, 0.0)
        for name, camera in (("south", pose((0, -1.2, -0.03))),
                             ("east", pose((1.2, 0.2, -0.02), -math.pi / 2)),
                             ("north", pose((0.1, 1.2, -0.03), math.pi)),
                             ("west", pose((-1.2, 0, -0.01), math.pi / 2)),
                             ("a corner", pose((-1, -1, -0.02), math.pi / 4)),
                             ("below", pose((0.1, -0.2, -0.6), 0, 1.5))):
            with self.subTest(name):
                self.look(camera, FLAT)
                (shown,), (sky,) = self.read(middle), self.sky(middle)
                self.assertGreater(apart(shown, sky), 60, (shown, sky))
        self.look(pose((0, -1.2, -0.5)), FLAT)
        self.assertEqual(self.read(middle), self.sky(middle), "below the base is nothing")

    def test_sides_follow_the_edge(self):
        """Where the edge is high, the side is, too; next to that is sky."""
        self.look(pose((0, -1.2, 0.1)), RIDGE)
        ridge, beside = (0.0, 0.0), (0.4, 0.0)
        self.assertGreater(apart(self.read(ridge)[0], self.sky(ridge)[0]), 60)
        self.assertEqual(self.read(beside), self.sky(beside))

    def test_sides_close_at_each_detail(self):
        """Frames of a moving camera have fewer triangles, and no gaps either."""
        self.look(pose((0.4, -1.1, 0.02), -0.4, -0.05), RIDGE)
        places = [(x / 20, -0.13) for x in range(-5, 6)]
        sky = self.sky(*places)
        for pace, size in ((0, "128 128"), (200, "65 65"), (1e6, "33 33")):
            self.page.run(f"playground.world.meshes.clear(), playground.world.pace = {pace}, "
                          "playground.world.flight.moving()")
            shown = self.read(*places)
            for a, b in zip(shown, sky):
                self.assertGreater(apart(a, b), 40, size)
            sizes = self.page.run("[...playground.world.meshes.keys()]")
            self.assertEqual(sizes, [size])

    def test_ridges_cast_shadows(self):
        places = (-0.2, 0.2)  # west and east of the ridge, on level ground
        for view, few in (("hillshade", 0.7), ("relief", 0.85)):
            for azimuth, lee in ((270, 1), (90, 0)):
                with self.subTest(f"{view} {azimuth}"):
                    self.look(pose((0, 0, 1.2), 0, -1.5), RIDGE, view, azimuth, 35)
                    seen = self.read(*[self.from_above(east) for east in places])
                    self.assertLess(light(seen[lee]), few * light(seen[1 - lee]), seen)
                    self.page.run("playground.world.pose.eye = [0, 0, 0.8], "
                                  "playground.world.draw()")
                    near = self.read(*[self.from_above(east, 0.8) for east in places])
                    self.assertLess(light(near[lee]), few * light(near[1 - lee]), "from anywhere")
                    self.look(pose((0, 0, 1.2), 0, -1.5), RIDGE, view, azimuth, 89)
                    high = self.read(*[self.from_above(east) for east in places])
                    self.assertLess(apart(*high), 12, "under a high sun there are no shadows")
                    self.assertLess(light(seen[lee]), few * light(high[lee]))

    def test_measurements_have_no_shadows(self):
        for view in ("value", "slope", "curvature"):
            with self.subTest(view):
                self.look(pose((0, 0, 1.2), 0, -1.5), RIDGE, view, 270, 35)
                self.assertLess(apart(*self.read(self.from_above(-0.2), self.from_above(0.2))), 6)

    def test_shadows_are_those_of_rays(self):
        """Rays to the rims of the sun, over the same heights, show what is lit and what is dark."""
        self.open(["--size", "96x80", "--step", "24"], space="3d",
                  text="recipe 1\nout a = 700 * noise(size=600, octaves=3)\n")
        values = self.page.run("[...playground.whole.values]")
        random.seed(1)
        for azimuth, altitude in ((0, 20), (90, 35), (197, 12), (251.5, 28), (315, 40), (340, 5)):
            lit = self.page.run(f"""import("{self.module("sunlight.js")}").then(({{sunOf, sunShares}}) =>
                [...sunShares(playground.whole.values, [96, 80], 24,
                    sunOf({azimuth}, {altitude}))])""")
            dark, bright, wrong = 0, 0, []
            for _ in range(400):
                column, row = random.randrange(96), random.randrange(80)
                rise = highest_rise(values, 96, 80, column, row, azimuth) / 24
                over = math.degrees(math.atan(rise)) - altitude
                got = lit[row * 96 + column]
                if over > RADIUS + 1.5:
                    dark += 1
                    wrong += [(column, row, got)] if got > 0.5 else []
                elif over < -RADIUS - 1.5:
                    bright += 1
                    wrong += [(column, row, got)] if got < 0.5 else []
            with self.subTest(f"{azimuth} {altitude}"):
                self.assertGreater(dark, 15)
                self.assertGreater(bright, 15)
                self.assertLessEqual(len(wrong), 0.02 * (dark + bright), wrong)

    def test_shadows_have_soft_edges(self):
        """The farther from what casts it, the wider the edge is."""
        self.open(["--size", "32x32"])
        widths = self.page.run(f"import('{self.module('sunlight.js')}')" + """.then(({sunOf, sunShares}) =>
            [10, 40].map(high => {
                const values = new Float32Array(256 * 3);
                values[20] = values[276] = values[532] = high;
                const lit = sunShares(values, [256, 3], 1, sunOf(270, 20)).subarray(256, 512);
                const isSoft = share => share > 0.02 && share < 0.98;
                return [lit[21], lit[255], lit.filter(isSoft).length];
            }))""")
        for dark, bright, _ in widths:
            self.assertEqual((dark, bright), (0, 1))
        self.assertGreaterEqual(widths[0][2], 2)
        self.assertGreater(widths[1][2], 2 * widths[0][2])

    def test_the_sky(self):
        """It is bluer higher up, brighter around the sun, and dark on dark pages."""
        away = (0, 3, 0.2)  # from the terrain
        column = [(0.0, y / 4) for y in range(-3, 5)]
        self.look(pose(away, 0, 0.4), FLAT, azimuth=180, altitude=40)
        pixels = self.read(*column)
        blues = [p[2] - p[0] for p in pixels]
        self.assertGreater(blues[-1], blues[0] + 25, pixels)
        self.assertTrue(all(b >= a - 2 for a, b in zip(blues, blues[1:])), pixels)
        self.look(pose(away, 0, 0.4), FLAT, azimuth=0, altitude=math.degrees(0.4))
        sun, beside, far = self.read((0, 0), (0.12, 0), (0.9, 0))
        self.assertGreater(light(sun), light(beside) + 10)
        self.assertGreater(light(beside), light(far) + 10)
        self.look(pose(away, 0, 0.05), FLAT, azimuth=0, altitude=5)
        red, = self.read((0.5, 0))
        self.assertGreater(red[0], red[2] + 30, "a low sun reddens the sky")
        self.page.scheme("dark")
        self.addCleanup(self.page.scheme, "light")
        self.page.run("new Promise(done => setTimeout(done, 100))")
        dark = self.read(*column)
        self.assertLess(max(map(light, dark)), 400)

    def test_haze_takes_what_is_far(self):
        """The ground comes closer to the colour of the horizon."""
        self.look(pose((0, -0.6, 0.05), 0, 0), FLAT, view="value")
        horizon, = self.sky((0.0, 0.02))
        near, far = self.read((0.0, -0.7), (0.0, -0.1))
        self.assertLess(apart(far, horizon), 0.97 * apart(near, horizon))
        self.page.run("playground.world.pose.eye = [0, -3.5, 0.3], playground.world.draw()")
        away, = self.read((0.0, -0.19))
        self.assertLess(apart(away, horizon), 0.6 * apart(near, horizon))

    def test_letters_that_are_typed_do_not_fly(self):
        self.look(pose((0, -0.85, 0.5), 0, -0.6), FLAT)
        before = self.page.run("playground.world.pose.eye")
        self.page.run("""(() => {
            const field = document.createElement("div");
            field.contentEditable = "true";
            document.body.append(field);
            field.focus();
        })()""")
        self.page.key("w", text="w")
        self.page.run("new Promise(done => setTimeout(done, 60))")
        self.assertEqual(self.page.run("playground.world.pose.eye"), before)
        self.page.run("document.activeElement.remove()")
        self.page.key("w", text="w")
        self.page.wait("!playground.world.flying")
        self.assertNotEqual(self.page.run("playground.world.pose.eye"), before)


def highest_rise(values, width, height, column, row, azimuth):
    """The steepest rise to any height towards an azimuth, for a step of 1"""
    east, north = math.sin(math.radians(azimuth)), math.cos(math.radians(azimuth))
    here, best, far = values[row * width + column], -math.inf, 0.0
    while True:
        far += 0.25
        x, y = column + far * east, row - far * north
        if not (0 <= x <= width - 1 and 0 <= y <= height - 1):
            return best
        i, j = min(int(x), width - 2), min(int(y), height - 2)
        u, v = x - i, y - j
        above = (1 - u) * values[j * width + i] + u * values[j * width + i + 1]
        below = (1 - u) * values[(j + 1) * width + i] + u * values[(j + 1) * width + i + 1]
        if far >= 1:
            best = max(best, ((1 - v) * above + v * below - here) / far)


if __name__ == "__main__":
    main()
