# SPDX-License-Identifier: MIT
"""The pictures in the documents are what their commands make."""
import os
import re

import common
from common import ROOT, Case, run
from rasters import read_bytes, read_picture

# Where pictures are shown, and how many each shows of the gallery, at least
DOCUMENTS = {"README.md": 5, "src/cli/README.md": 14}
GALLERY = os.path.join(ROOT, "src", "cli", "gallery")
# Pictures that no command of a document makes, and what they are copies of
COPIES = {"landscape.png": os.path.join(ROOT, "src", "gpu", "landscape.png")}


def read_documents():
    """The documents by name"""
    texts = {}
    for name in DOCUMENTS:
        with open(os.path.join(ROOT, name), encoding="utf-8") as file:
            texts[name] = file.read()
    return texts


def gallery_commands():
    """The words after `scarp` of the commands that make pictures, by the stem of their files"""
    text = "".join(read_documents().values()).replace("\\\n", "")
    return {stem: command.split() for command, stem in
            re.findall(r"^scarp (terrain .*--output (\S+))$", text, re.MULTILINE)}


class Gallery(Case):
    """The pictures in the documents are what their commands make."""

    def test_all_are_shown(self):
        shown = set()
        for name, text in read_documents().items():
            found = re.findall(r"\]\((?:[\w./-]+/)?gallery/([^)]+)\)", text)
            self.assertGreaterEqual(len(found), DOCUMENTS[name], name)
            shown.update(found)
        self.assertEqual(sorted(os.listdir(GALLERY)), sorted(shown))
        self.assertLess(sum(os.path.getsize(os.path.join(GALLERY, name)) for name in shown),
                        2000000)

    def test_commands(self):
        commands = gallery_commands()
        made = sorted(set(os.listdir(GALLERY)) - set(COPIES))
        self.assertGreaterEqual(len(made), 18)
        for name in made:
            with self.subTest(name=name):
                stem, kind = name[:-len(".png")].rsplit("-", 1)
                result = run(*commands[stem], "--quiet", cwd=self.directory)
                self.assertEqual((result.returncode, result.stderr), (0, b""))
                end = self.extensions[1 if kind == "compare" else 0]
                picture = read_picture(self.path("%s-%s%s" % (stem, kind, end)))
                committed = read_picture(os.path.join(GALLERY, name))
                self.check_rows(picture.rows, committed.rows)

    def test_copies(self):
        for name, source in COPIES.items():
            self.assertEqual(read_bytes(os.path.join(GALLERY, name)), read_bytes(source), name)


if __name__ == "__main__":
    common.main(globals())
