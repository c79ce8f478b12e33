# SPDX-License-Identifier: MIT
"""Tests the playground as an editor of recipes: see playground.py."""
import time

from playground import PLACE, Playground, hash_of, hillshade_of, main

TEXT = """recipe 1
param tall = 80 [0, 300] # Höhe 🏔
bend = noise(size=90, amplitude=20)
out a = tall * warp(noise(ridged, size=70, octaves=4), bend)
"""


class Edit(Playground):
    def put(self, text, at=None):
        """Types at the end of the first `at`, else where the cursor is."""
        if at is not None:
            self.page.run(f"playground.work.editor.select({self.index(at) + len(at)})")
        self.page.run("playground.work.editor.view.focus()")
        for letter in text:
            self.page.key(letter, text=letter)

    def index(self, what):
        """Where it is in the string of the page, whose mountains count twice"""
        return self.page.run(f"playground.work.editor.text.indexOf({what!r})")

    def press(self, key, code, modifiers=0):
        for kind in ("keyDown", "keyUp"):
            self.page.call("Input.dispatchKeyEvent", type=kind, key=key, modifiers=modifiers,
                           windowsVirtualKeyCode=code)

    def undo(self):
        self.page.run("playground.work.undo()")

    def marked(self):
        return self.page.run("[...document.querySelectorAll('.cm-lintRange-error')].map("
                             "each => each.textContent).join('')")

    def test_errors_are_marked_where_they_are(self):
        self.open(PLACE, text=TEXT)
        self.assertEqual(self.marked(), "")
        self.put("x", ", bend")
        self.page.wait("document.querySelector('.cm-lintRange-error') !== null")
        self.assertEqual(self.marked(), "bendx")
        self.assertEqual(self.page.run(
            "document.querySelectorAll('.cm-lint-marker-error').length"), 1)
        self.assertIn("line 4", self.shown("#recipe-message"))
        self.page.run("playground.work.editor.select(0)")
        self.press("F8", 119)
        self.assertEqual(self.page.run(
            "(({from, to}) => playground.work.editor.text.slice(from, to))"
            "(playground.work.editor.view.state.selection.main)"), "bendx")
        self.undo()
        self.ready()
        self.assertEqual((self.text(), self.marked()), (TEXT, ""))
        self.write(TEXT.replace("amplitude", "🏔 amp").replace("70", "many"))
        self.assertEqual(self.page.run("playground.recipe.errors.length"), 2)
        self.assertIn("many", self.marked())
        self.write(TEXT)
        self.ready()

    def test_an_error_tells_a_number_that_would_do(self):
        self.open(PLACE, text=TEXT)
        self.write("recipe 1\ntile 100, 100\nout a = 9 * noise(size=30)\n")
        self.assertEqual(self.marked(), "noise(size=30)")
        self.assertRegex(self.shown("#notice"), r"^recipe: line 3: .*fits: 33\.33")
        x, y, _ = self.centre(".cm-lintRange-error")
        self.page.mouse("mouseMoved", x, y)
        self.page.wait("document.querySelector('.cm-diagnosticText') !== null")
        self.assertIn("33.33", self.shown(".cm-diagnosticText"))
        self.page.mouse("mouseMoved", 5, 5)
        self.write(TEXT)
        self.ready()

    def test_colours_and_brackets(self):
        self.open(PLACE, text=TEXT)
        words = {kind: self.page.run(f"[...document.querySelectorAll('.tok-{kind}')].map("
                                     "each => each.textContent)")
                 for kind in ("comment", "keyword", "number", "function", "argument")}
        self.assertEqual(words["comment"], ["# Höhe 🏔"])
        self.assertEqual(words["keyword"], ["recipe", "param", "out"])
        self.assertEqual(words["function"], ["noise", "warp", "noise"])
        self.assertEqual(words["argument"][:4], ["tall", "bend", "size", "amplitude"])
        self.assertEqual(words["number"], ["1", "80", "0", "300", "90", "20", "70", "4"])
        for at, pair in (("warp(", "()"), ("4)", "()"), ("bend)", "()"), ("80 [", "[]"), ("size", "")):
            self.put("", at)
            self.assertEqual("".join(sorted(self.page.run(
                "[...document.querySelectorAll('.cm-matchingBracket')].map(each => "
                "each.textContent)"))), pair, at)
        self.put("", "bend)")
        self.page.call("Input.insertText", text="(")
        self.assertIn("bend)()", self.text(), "brackets close")
        self.undo()
        self.write(TEXT)
        self.put("", "bend)")
        self.press("/", 191, modifiers=2)
        self.assertIn("\n# out a", self.text())
        self.press("/", 191, modifiers=2)
        self.assertEqual(self.text(), TEXT)
        self.put("    ", "bend)\n")
        self.press("Enter", 13)
        self.assertTrue(self.text().endswith("    \n    ") or self.text().endswith("\n\n    "))
        self.write(TEXT)
        self.ready()

    def test_completion_inserts(self):
        self.open(PLACE, text=TEXT)
        self.put("\nmask = smooths", "bend)\n")
        self.page.wait("document.querySelector('.cm-tooltip-autocomplete [aria-selected]')"
                       "?.textContent.startsWith('smoothstep')")
        self.assertIn("A mask", self.shown(".cm-tooltip-autocomplete [aria-selected]"))
        self.page.run("new Promise(done => setTimeout(done, 120))")  # it takes no key at once
        self.press("Enter", 13)
        self.assertIn("mask = smoothstep(a, lo, hi)", self.text())
        self.page.run("document.activeElement.blur()")
        self.put(", octa", "ridged")
        self.page.wait("document.querySelector('.cm-tooltip-autocomplete [aria-selected]')"
                       "?.textContent.startsWith('octaves=')")
        options = self.page.run("[...document.querySelectorAll('.cm-completionLabel')].map("
                                "each => each.textContent)")
        self.assertEqual(options[0], "octaves=")
        self.assertIn("of_octaves=", options)
        self.press("Escape", 27)
        self.write(TEXT + "out b = be")
        self.put("n", "out b = be")
        self.page.wait("document.querySelector('.cm-tooltip-autocomplete [aria-selected]')"
                       "?.textContent.startsWith('bend')")
        self.press("Escape", 27)
        self.write(TEXT)
        self.ready()

    def test_help_tells_what_a_word_is(self):
        """In the words of the module, with the formulas of the language's document"""
        self.open(PLACE, text=TEXT + "out mask = smoothstep(bend, 0, 1)\n")
        for word, title, told in (
                ("warp", "warp(f, by)", "A field, bent by a noise."),
                ("warp", "warp(f, by)", "f is looked up at (x + w_0, y + w_1)"),
                ("smooth", "smoothstep(a, lo, hi)", "value 6t^5 - 15t^4 + 10t^3 of t = (a - lo)"),
                ("octaves", "noise: octaves",
                 "how many octaves are summed; a fraction fades in (1 … 12"),
                ("ridged", "noise: fractal", "how octaves are summed"),
                ("bend)", "bend", "never outside of -20 … 20"),
                ("tall *", "tall", "a parameter, 80, from 0 to 300")):
            at = self.index(word) + 1
            x, y = self.page.run(f"(({{left, top, bottom}}) => [left, (top + bottom) / 2])"
                                 f"(playground.work.editor.view.coordsAtPos({at}))")
            self.page.mouse("mouseMoved", 5, 5)
            self.page.wait("document.querySelector('.recipe-help') === null")
            self.page.mouse("mouseMoved", x + 2, y)
            self.page.wait("document.querySelector('.recipe-help') !== null")
            self.assertEqual(self.shown(".recipe-help strong"), title)
            self.assertIn(told, self.shown(".recipe-help"))
        self.page.mouse("mouseMoved", 5, 5)
        self.put("", "warp")
        self.press("F1", 112)
        self.assertTrue(self.shown("#said").startswith("warp(f, by)\nA field, bent by a noise."))

    def test_a_slider_writes_its_number(self):
        """It follows; the picture is that of the text, and the whole drag is one step to undo."""
        words = ["--preset", "hills", "--size", "256x256", "--step", "4"]
        self.open(words, view="hillshade")
        text, before = self.text(), self.page.run("playground.frames")
        x, y, width = self.centre("#p-gully-slider")
        self.page.mouse("mousePressed", x, y)
        for i in range(1, 21):
            self.page.mouse("mouseMoved", x + i * width / 80, y, buttons=1)
        self.page.mouse("mouseReleased", x + width / 4, y)
        self.ready()
        self.assertGreater(self.page.run("playground.frames"), before + 5, "it follows")
        gully = self.page.run("document.getElementById('p-gully').value")
        self.assertNotEqual(self.text(), text)
        words += ["--set", "gully=" + gully]
        self.assertEqual(self.hash(), hash_of(words))
        self.assertTrue(self.greys() == hillshade_of(words))
        self.assertEqual(self.page.run("document.getElementById('preset').selectedOptions[0].text"),
                         "hills, edited")
        self.click("#undo")
        self.assertEqual(self.text(), text)
        self.ready()
        self.assertEqual(self.page.run("document.getElementById('preset').value"), "hills")
        self.click("#redo")
        self.assertIn(gully, self.text())
        self.ready()

    def test_edits_of_others_join(self):
        """As those of the graph: {join} makes an edit a part of the step before."""
        self.open(PLACE, text=TEXT)
        at = self.index("80")
        edit = "playground.work.host().edit([{from: %d, to: %d, insert: '%s'}], {join: %s})"
        self.page.run(edit % (at, at + 2, "90", "false"))
        for number in ("91", "92", "93"):
            time.sleep(0.3)  # a drag may take its time
            self.page.run(edit % (at, at + 2, number, "true"))
        time.sleep(0.6)
        self.page.run(edit % (at, at + 2, "93", "true"))
        self.page.run(edit % (at, at + 2, "94", "false"))
        self.assertIn("= 94 [", self.text())
        self.undo()
        self.assertIn("= 93 [", self.text())
        self.undo()
        self.assertEqual(self.text(), TEXT)
        self.page.run("playground.work.host().edit([{from: 0, to: 0, insert: '# a\\n'}, "
                      f"{{from: {at}, to: {at + 2}, insert: '7'}}])")
        self.assertEqual(self.text(), "# a\n" + TEXT.replace("80", "7"))
        self.undo()
        self.assertEqual(self.text(), TEXT)
        self.ready()

    def test_typing_is_undone_in_groups(self):
        self.open(PLACE, text=TEXT)
        self.put("123", "tall = ")
        self.assertIn("= 12380", self.text())
        self.undo()
        self.assertEqual(self.text(), TEXT)
        self.ready()

    def test_presets_fill_the_text(self):
        self.open(["--preset", "alps", "--size", "32x32", "--seed", "4"])
        self.page.run("""(() => {
            const list = document.getElementById("preset");
            list.value = "mesas";
            list.dispatchEvent(new Event("change"));
        })()""")
        self.ready()
        self.assertIn("out mesas", self.text())
        self.assertEqual(self.hash(),
                         hash_of(["--preset", "mesas", "--size", "32x32", "--seed", "4"]))
        self.undo()
        self.assertIn("out alps", self.text())
        self.ready()

    def test_places_are_those_of_the_string(self):
        """The module counts bytes, and the text has letters of several."""
        self.open(PLACE, text="# 🏔 ä\n" + TEXT)
        found = self.page.run("""(({text, entries, ok, isSpace, functions}) => [ok, isSpace,
            functions.length > 20, entries.map(({nameSpan, span, valueSpan}) => [nameSpan, span,
            valueSpan].map(each => each && text.slice(...each)))])(playground.recipe)""")
        self.assertEqual(found, [True, False, True, [
            ["tall", "param tall = 80 [0, 300] # Höhe 🏔", "80"],
            ["bend", "bend = noise(size=90, amplitude=20)", None],
            ["a", "out a = tall * warp(noise(ridged, size=70, octaves=4), bend)", None]]])

    def test_large_texts(self):
        """What is too long is said; the longest is edited without waiting."""
        self.open(PLACE, text=TEXT)
        self.write("recipe 1\n" + "# " + "x" * 17000)
        self.assertIn("longer than 16,384 bytes", self.shown("#notice"))
        lines = "".join(f"n{i} = noise(size={90 + i}) + 0.5 * noise(size={40 + i})\n"
                        for i in range(20))
        self.write("recipe 1\n" + lines + "out a = 9 * " + " + ".join(f"n{i}" for i in range(20)))
        self.ready()
        took = self.page.run("""(() => {
            const begin = performance.now();
            for (let i = 0; i < 10; i++) {
                playground.work.edit([{from: 9, to: 9, insert: "# "}, ]);
                playground.work.undo();
            }
            return (performance.now() - begin) / 20;
        })()""")
        self.assertLess(took, 40)
        self.write(TEXT)
        self.ready()


if __name__ == "__main__":
    main()
