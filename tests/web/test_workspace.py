# SPDX-License-Identifier: MIT
"""Tests the graph in the page, where the editor of the text has the history: see playground.py."""
import time

from playground import Playground, main

TEXT = """recipe 1
param tall = 80 [0, 300]
bend = noise(size=90, amplitude=20)
shape = curve(bend, -20: 0, 0: 0.4, 20: 1)
out a = tall * warp(noise(ridged, size=70, octaves=4), bend) + shape
"""
PLACE = ["--size", "160x120", "--step", "2"]


class Workspace(Playground):
    def show(self):
        self.open(PLACE, text=TEXT, pane="graph")
        self.page.wait("document.querySelectorAll('.graph-card').length === 4 && "
                       "playground.work.editor !== null", 60)
        time.sleep(0.3)

    def state(self):
        return self.page.run("playground.work.editor.text")

    def drag(self, element, dx, dy):
        x, y, width = self.page.run(f"""(() => {{
            const box = document.querySelector({element!r}).getBoundingClientRect();
            return [box.x + box.width / 2, box.y + box.height / 2, box.width];
        }})()""")
        self.page.mouse("mouseMoved", x, y)
        self.page.mouse("mousePressed", x, y)
        for i in range(1, 7):
            self.page.mouse("mouseMoved", x + dx * i / 6, y + dy * i / 6)
        self.page.mouse("mouseReleased", x + dx, y + dy)
        self.ready()

    def test_cards_have_pictures(self):
        self.show()
        self.page.wait("[...document.querySelectorAll('.graph-picture span')].every("
                       "range => range.textContent.includes('…'))", 60)
        self.assertEqual(self.page.run("document.querySelectorAll('.graph-picture').length"), 3)

    def test_drags_are_steps_of_the_one_history(self):
        self.show()
        self.drag("[data-id=shape] [data-knot='1']", 8, -8)
        knot = self.state()
        self.assertNotIn("0: 0.4,", knot)
        self.drag("[data-id=tall] input[type=range]", 30, 0)
        self.assertNotEqual(self.state(), knot)
        self.click("#undo")
        self.assertEqual(self.state(), knot)
        self.click("#undo")
        self.assertEqual(self.state(), TEXT)
        self.assertTrue(self.page.run("document.getElementById('undo').disabled"))
        self.ready()

    def test_an_error_dims_the_last_good_graph(self):
        self.show()
        self.page.run("playground.work.editor.edit([{from: 9, to: 9, insert: '?'}], {})")
        self.page.wait("document.querySelector('.graph.is-stale') !== null")
        self.assertEqual(self.page.run("document.querySelectorAll('.graph-card').length"), 4)
        self.assertIn("line 2", self.shown(".graph-error").lower())
        self.click("#undo")
        self.page.wait("document.querySelector('.graph.is-stale') === null")
        self.ready()

    def test_the_graph_and_the_text_select_together(self):
        self.show()
        self.page.run("document.querySelector('[data-id=bend]').dispatchEvent("
                      "new PointerEvent('pointerdown', {bubbles: true}))")
        at = self.page.run("playground.work.editor.view.state.selection.main.from")
        self.assertEqual(TEXT[at:at + 4], "bend")
        # A line down in the text is the next card.
        self.click("#tab-text")
        self.page.run("playground.work.editor.view.focus()")
        self.page.key("ArrowDown")
        self.click("#tab-graph")
        self.page.wait("document.querySelector('.is-selected')?.dataset.id === 'shape'")


if __name__ == "__main__":
    main()
