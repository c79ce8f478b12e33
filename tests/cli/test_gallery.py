# SPDX-License-Identifier: MIT
"""The pictures in the documents are what their commands make."""
import os
import re
import shlex

import common
from common import ROOT, Case, run
from rasters import read_picture

# Where pictures are shown, and how many each shows of the gallery, at least
DOCUMENTS = {"README.md": 4, "src/cli/README.md": 21}
GALLERY = os.path.join(ROOT, "src", "cli", "gallery")


def read_documents():
    """The documents by name"""
    texts = {}
    for name in DOCUMENTS:
        with open(os.path.join(ROOT, name), encoding="utf-8") as file:
            texts[name] = file.read()
    return texts


def gallery_commands():
    """The words after `scarp` of the command that makes each picture: it names the picture, or
    its stem after --output."""
    text = "".join(read_documents().values()).replace("\\\n", "")
    lines = [shlex.split(line, comments=True)
             for block in re.findall(r"(?ms)^```sh\n(.*?)^```$", text)
             for line in re.findall(r"(?m)^scarp (.*)$", block)]
    commands = {}
    for name in os.listdir(GALLERY):
        stem = name.rsplit("-", 1)[0]
        found = [words for words in lines if name in words or
                 ("--output", stem) in zip(words, words[1:])]
        if found:
            commands[name] = found[-1]
    return commands


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
                        6000000)

    def test_commands(self):
        commands = gallery_commands()
        made = sorted(os.listdir(GALLERY))
        self.assertGreaterEqual(len(made), 25)
        if os.environ.get("SCARP_SPEED", "full") != "full":  # of pictures with millions of rays
            made = [name for name in made if commands[name][0] != "view"]
            self.assertGreaterEqual(len(made), 20)
        for name in made:
            with self.subTest(name=name):
                committed = read_picture(os.path.join(GALLERY, name))
                file = os.path.splitext(name)[0] + self.extensions[committed.channels == 3]
                words = [file if word == name else word for word in commands[name]]
                result = run(*words, "--quiet", cwd=self.directory)
                self.assertEqual((result.returncode, result.stderr), (0, b""))
                self.check_rows(read_picture(self.path(file)).rows, committed.rows)


if __name__ == "__main__":
    common.main(globals())
