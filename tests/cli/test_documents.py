# SPDX-License-Identifier: MIT
"""What is written about the program besides its help: man page, completion, the manual's sessions."""
import os
import re
import subprocess

import common
from common import ROOT, Case, run, text_of

MANUAL = os.environ["SCARP_MANUAL"]
COMMANDS = ("terrain", "view", "sheet", "sample", "recipe", "info")


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


class Documents(Case):
    def test_manual(self):
        """The man page has the version and the help of each command."""
        page = read(MANUAL)
        self.assertIn(text_of("--version").strip(), page.splitlines()[2])
        self.assertNotRegex(page, "@[A-Z]+@")
        plain = page.replace("\\-", "-").replace("\\&", "").replace("\\e", "\\")
        for command in COMMANDS[:-1]:
            self.assertIn(text_of("help", command).strip("\n"), plain)

    def test_info_in_manual(self):
        """The manual's `scarp info` has the same lines, and with zlib the same formats."""
        printed = re.search(r"(?m)^```\n(scarp \d.*\n(?:.*\n)+?)```",
                            read("src", "cli", "README.md"))
        lines, told = text_of("info").splitlines(), printed.group(1).splitlines()
        self.assertEqual([line[:16] for line in lines[:-3]], [line[:16] for line in told[:-3]])
        if common.has_png():
            self.assertEqual(lines[-1], told[-1])


class Roff(Case):
    """Needs groff."""

    def test_manual_is_roff(self):
        result = subprocess.run(["groff", "-man", "-Tascii", "-ww", MANUAL],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True)
        self.assertEqual(result.stderr, b"")
        shown = re.sub(rb".\x08|\x1b\[\d+m", b"", result.stdout).decode()  # bold, underlined
        for word in ("--sea-level F", ".png .pgm .r16", "--hessian", "EXIT STATUS"):
            self.assertIn(word, shown)


class Completion(Case):
    """And what else a shell reads. Needs bash."""

    def complete(self, *words):
        """What the completion offers for the last word."""
        script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _scarp; '
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        result = subprocess.run(["bash", "-c", script, "bash",
                                 os.path.join(ROOT, "src", "cli", "scarp.bash"),
                                 common.PROGRAM[-1], *words],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True,
                                cwd=self.directory)
        self.assertEqual(result.stderr, b"")
        return result.stdout.decode().split()

    def test_completion_of_commands(self):
        self.assertEqual(self.complete("te"), ["terrain"])
        self.assertEqual(sorted(self.complete("help", "")), sorted(COMMANDS))
        with open(self.path("some.csv"), "wb"):
            self.assertEqual(self.complete("sample", "--input", "so"), ["some.csv"])

    def test_completion_of_options(self):
        """All that the help says; an emulated program is not there to be asked. Numbers have
        none."""
        if len(common.PROGRAM) != 1:
            self.skipTest("needs a program that runs by itself")
        for command in COMMANDS:
            options = re.findall(r"(?m)^  (--[a-z-]+)", text_of("help", command))
            self.assertEqual(options.count("--help"), 1)
            self.assertEqual(self.complete(command, "--"), options)
        self.assertEqual(self.complete("terrain", "--gain", ""), [])
        self.assertIn("--gain", self.complete("terrain", "--rotate", "--"))
        self.assertIn("alps", self.complete("recipe", ""))

    def test_completion_of_words(self):
        """The words that the help has for an option, which are there as "a, b or c"."""
        for command in COMMANDS[:-1]:
            text = re.sub(r"\n {18}", " ", text_of("help", command))
            for option in re.findall(r"(?m)^  (--[a-z-]+) NAME(?!=)", text):
                if (option in ("--preset", "--basis", "--fade", "--fractal")
                        and len(common.PROGRAM) != 1):
                    continue  # an emulated program is not there to be asked
                words = self.complete(command, option, "")
                told = re.search(r"(?m)^  %s NAME.*$" % option, text).group(0)
                self.assertGreaterEqual(len(words), 2, option)
                for word in words:
                    self.assertIn(word, told)
                count = told.count(", ") + told.count(" or ")
                self.assertTrue(len(words) <= count + 1, (words, told))

    def test_sample_in_manual(self):
        """The manual's session with scarp sample prints what it says."""
        command, printed = re.search(r"(?m)^\$ (printf .*\| scarp sample .*)\n((?:.+\n)+)```",
                                     read("src", "cli", "README.md")).groups()
        words = command.split("| scarp ")[1].split()
        points = subprocess.run(["bash", "-c", command.split(" | ")[0]], stdout=subprocess.PIPE,
                                check=True).stdout
        self.assertEqual(run(*words, input=points).stdout.decode(), printed)


common.main(globals())
