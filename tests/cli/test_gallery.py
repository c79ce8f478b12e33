# SPDX-License-Identifier: MIT
"""The pictures in the README are what its commands make."""
import os
import re

import common
from common import ROOT, Case, run
from rasters import read_picture


class Gallery(Case):
    """The pictures in the README are what its commands make."""

    def test_commands(self):
        with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
            readme = file.read()
        shown = re.findall(r"\]\(src/cli/gallery/([^)]+)\)", readme)
        directory = os.path.join(ROOT, "src", "cli", "gallery")
        self.assertGreaterEqual(len(shown), 5)
        self.assertEqual(sorted(os.listdir(directory)), sorted(shown))
        self.assertLess(sum(os.path.getsize(os.path.join(directory, name)) for name in shown),
                        1000000)
        commands = {stem: command.split() for command, stem in
                    re.findall(r"^scarp (terrain .*--output (\S+))$", readme.replace("\\\n", ""),
                               re.MULTILINE)}
        for name in shown:
            with self.subTest(name=name):
                stem, kind = name[:-len(".png")].rsplit("-", 1)
                result = run(*commands[stem], "--quiet", cwd=self.directory)
                self.assertEqual((result.returncode, result.stderr), (0, b""))
                end = self.extensions[1 if kind == "compare" else 0]
                made = read_picture(self.path("%s-%s%s" % (stem, kind, end)))
                committed = read_picture(os.path.join(directory, name))
                self.check_rows(made.rows, committed.rows)


common.main(globals())
