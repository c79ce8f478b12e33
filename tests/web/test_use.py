# SPDX-License-Identifier: MIT
"""Tests what people do with the playground besides the recipe: see playground.py."""
import re
import subprocess

from playground import PLACE, PROGRAM, Playground, hash_of, main


class Use(Playground):
    def type(self, name, text):
        self.page.run(f"""(() => {{
            const field = document.getElementById("p-{name}");
            const details = field.closest("details");
            if (details) {{
                details.open = true;
            }}
            field.focus();
            field.value = {text!r};
            field.dispatchEvent(new Event("input", {{bubbles: true}}));
        }})()""")

    def test_the_map_is_dragged_and_zoomed(self):
        words = ["--preset", "hills", "--size", "256x256"]
        self.open(words, view="hillshade")
        x, y, _ = self.centre("#map")

        def under(x, y):
            """The place that the page shows of a point of the map"""
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
        self.page.run("document.querySelector('#views [aria-checked=true]').focus()")
        self.page.key("ArrowRight")
        self.ready()
        self.assertEqual(self.page.run("playground.state.view"), "relief")
        self.page.run("document.getElementById('split').focus()")
        self.page.key("ArrowLeft")
        self.assertEqual(self.page.run("document.activeElement.ariaValueNow"), "44")
        self.assertEqual(self.shown("#seed-now"), "3")

    def test_keys_are_for_the_text_while_it_is_written(self):
        self.open(["--preset", "badlands", "--size", "32x32"])
        self.page.run("playground.work.editor.view.focus()")
        self.page.key("ArrowRight")
        self.page.key("3", text="3")
        self.assertEqual(self.shown("#seed-now"), "1")
        self.assertEqual(self.page.run("playground.state.view"), "relief")
        self.assertEqual(self.text()[:2], "#3")

    def test_screen_readers_have_names_for_all(self):
        self.open(["--preset", "alps", "--size", "32x32"])
        self.page.run("document.querySelectorAll('details').forEach(d => d.open = true)")
        self.page.call("Accessibility.enable")
        nodes = self.page.call("Accessibility.getFullAXTree")["nodes"]
        self.page.call("Accessibility.disable")
        roles = {"button", "slider", "textbox", "checkbox", "combobox", "radio", "image", "tab",
                 "spinbutton", "group", "radiogroup", "dialog", "tabpanel", "splitter"}
        found = [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in nodes
                 if not node["ignored"] and node["role"]["value"] in roles]
        self.assertGreater(len(found), 50)
        self.assertEqual([role for role, name in found if name == "" and role != "group"], [])
        for what in (("slider", "Step"), ("textbox", "Step"), ("group", "Parameters of the recipe"),
                     ("textbox", "Text of the recipe"), ("slider", "gully"), ("tab", "Graph"),
                     ("button", "Copy as JavaScript"), ("radio", "Relief"), ("combobox", "Show"),
                     ("image", "Map of the terrain alps, seed 1, relief")):
            self.assertIn(what, found)

    def test_wrong_numbers_are_marked(self):
        words = ["--size", "64x64"]
        self.open(words)
        for name, text, message in [
                ("step", "two", "is not a number from 2^-48 to 2^48"),
                ("altitude", "91", "is not a number from 0 to 90"),
                ("azimuth", "", "is not a number from 0 to 360"),
                ("z-factor", "-1", "is not a number from 0 to 2^24"),
                ("origin", "3", "two numbers from -2^53 to 2^53"),
                ("seed", "18446744073709551616", "from -2^63 to 2^64 - 1"),
                ("size", "0x64", "from 1 to 1000000"),
                ("size", "8192x4096", "at most 2^24 samples")]:
            with self.subTest(f"{name} {text}"):
                self.type(name, text)
                marked = self.page.run(
                    "[...document.querySelectorAll('[aria-invalid=true]')].map(e => e.id)")
                self.assertEqual(marked, ["p-" + name])
                self.assertIn(message, self.shown(f"#p-{name}-message"))
                self.assertIn(message, self.shown("#notice"))
                self.page.run(f"playground.change({{{name!r}: undefined}})")
                self.assertEqual(self.page.run(
                    "document.querySelectorAll('[aria-invalid=true]').length"), 0)
                self.assertTrue(self.page.run("document.getElementById('notice').hidden"))
        self.page.run("playground.change({size: '64x64'})")
        self.ready()
        self.assertEqual(self.hash(), hash_of(words))

    def test_numbers_of_parameters_are_checked(self):
        self.open(["--preset", "alps", "--size", "32x32"])
        before = self.text()
        for text, told in (("much", "is no number"), ("1", "is not a number from 0 to 0.4")):
            self.type("gully", text)
            self.assertEqual(self.shown("#p-gully-message"), told)
            self.assertEqual(self.text(), before)
        self.type("gully", "0.1")
        self.assertEqual(self.shown("#p-gully-message"), "")
        self.assertEqual(self.text(), re.sub(r"(gully  = )0.22", r"\g<1>0.1", before))

    def test_intervals_are_those_of_the_program(self):
        """What the page takes for valid, the program takes, and the other way round."""
        self.open(["--size", "8x8"])
        rows = self.page.run(f"""import("{self.module('options.js')}").then(({{ROWS}}) =>
            [...ROWS.values()].filter(row => row.slider).map(row =>
                [row.name, row.lowest, row.highest]))""")
        self.assertGreater(len(rows), 3)
        for name, lowest, highest in rows:
            for number in (lowest, highest, highest * 1.001, lowest * 0.999 - 1e-300):
                text = repr(float(number))
                self.page.run(f"playground.change({{{name!r}: '{text}'}})")
                wrong = self.page.run(f"playground.checked.messages.has({name!r})")
                said = subprocess.run(
                    [PROGRAM, "terrain", "--size", "8x8", f"--{name}", text, "--heights", "r32:-",
                     "--quiet"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                    text=True).stderr
                with self.subTest(f"{name} {text}"):
                    self.assertEqual(wrong, f"--{name}: " in said, said)
                self.page.run(f"playground.change({{{name!r}: undefined}})")
        self.ready()

    def test_reset_takes_back_all(self):
        """A seed that is none, too; a preset that was changed, and options"""
        self.open(["--preset", "hills", "--size", "48x48"])
        text = self.text()
        for name, wrong in (("seed", "no seed"), ("azimuth", "400")):
            self.type(name, wrong)
            self.assertFalse(self.page.run("document.getElementById('notice').hidden"))
            self.write(text.replace("noise(", "nose("))
            self.click("#reset")
            self.ready()
            self.assertEqual(self.shown("#seed-now"), "1")
            self.assertEqual(self.text(), text)
            self.assertEqual(self.page.run("playground.state.given"),
                             {"step": "4", "size": "48x48"})
            self.assertEqual(self.page.run(f"document.getElementById('p-{name}').value"),
                             {"seed": "1", "azimuth": "315"}[name])
        self.page.run("playground.work.undo()")
        self.assertIn("nose(", self.text(), "it is one step of the history")
        self.page.run("playground.work.redo()")
        self.ready()

    def test_the_url_has_the_state(self):
        for words, edit, form in ((["--preset", "volcanic", *PLACE], None, "#preset=volcanic&"),
                                  ([*PLACE, "--gain", "0.41", "--sea-level", "-0.2"],
                                   ("noise(", "noise( "), "#recipe=")):
            self.open(words, view="hillshade")
            self.type("seed", "12")
            if edit:
                self.write(self.text().replace(*edit) + "# 🏔\n")
            self.page.run("playground.setNode('*')")
            self.page.run("playground.setNode('')")
            self.ready()
            before = self.hash(), self.greys(), self.text()
            url = self.page.run("playground.flushHash().then(() => location.href)")
            self.assertIn(form, url)
            self.leave()
            self.page.open(url)
            self.ready()
            self.assertEqual(self.page.run("playground.flushHash().then(() => location.href)"), url)
            self.assertEqual((self.hash(), self.greys(), self.text()), before)
            self.assertEqual(self.page.run("playground.state.given.seed"), "12")

    def test_a_browser_that_cannot_deflate(self):
        text = "recipe 1\nout a = 9 * noise(size=60) # ä & b\n"
        self.open(PLACE, text=text)
        url = self.page.run("""(() => {
            const {CompressionStream} = globalThis;
            delete globalThis.CompressionStream;
            return playground.flushHash().then(() => {
                globalThis.CompressionStream = CompressionStream;
                return location.href;
            });
        })()""")
        self.assertIn("#text=recipe+1%0A", url)
        self.leave()
        self.page.open(url)
        self.ready()
        self.assertEqual(self.text(), text)

    def test_links_that_are_broken_show_something(self):
        for hash in ("#recipe=!!", "#recipe=AAAA", "#preset=constructor&step=x",
                     "#node=none&view=none"):
            self.page.run(f"location.hash = '{hash}'")
            self.page.wait("document.documentElement.dataset.ready === 'yes' || "
                           "!document.getElementById('notice').hidden")
        self.page.run("playground.reset()")
        self.ready()

    def test_phones_and_dark_screens(self):
        """Nothing is wider than the screen, and what is tapped is large enough."""
        self.open(["--preset", "alps", "--size", "64x64"])
        try:
            self.page.size(400, 800, mobile=True)
            for scheme in ("dark", "light"):
                self.page.scheme(scheme)
                wide, small = self.page.run("""[document.documentElement.scrollWidth,
                    [...document.querySelectorAll("aside button")].filter(button => {
                        const {width, height} = button.getBoundingClientRect();
                        return width > 0 && height < 30 && !button.closest(".cm-editor, .field");
                    }).map(button => button.textContent)]""")
                self.assertLessEqual(wide, 400)
                self.assertEqual(small, [])
        finally:
            self.page.size(1200, 800)
            self.page.scheme("light")


if __name__ == "__main__":
    main()
