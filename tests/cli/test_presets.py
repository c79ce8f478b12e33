# SPDX-License-Identifier: MIT
"""A preset is the options that the help tells, before those of the command line."""
import re
import struct

import common
from common import Case, run, text_of

SIZE = ("--size", "60x40")
FILES = ("--heights", "h.r32", "--normals", "n.npy", "--hillshade", "s.pgm")


def told():
    """The options of each preset, from the help."""
    text = text_of("terrain", "--help")
    lines = text[text.index("\npresets "):].split("\n")[2:]
    presets = {}
    for line in lines:
        name, words = re.match(r"  (\w*) +(--.*)\Z", line).groups() if line else ("", "")
        if name:
            presets[name] = words.split()
        elif words:
            presets[list(presets)[-1]] += words.split()
    return presets


def jumps(words, part):
    """Whether the noise of a part, "" or "base-", jumps, as scarp.h says under "Jumps"."""
    def value(name, standard):
        option = "--" + part + name
        return words[words.index(option) + 1] if option in words else standard
    basis, fractal = value("basis", "gradient"), value("fractal", "fbm")
    octaves = float(value("octaves", "8"))
    by_slopes = fractal in ("erosion", "swiss", "jordan")
    return (basis == "cell-value" or
            basis in ("cell-f1", "cell-f2", "cell-edge") and by_slopes and octaves > 1 or
            basis == "cell-edge" and fractal == "erosion")


class Presets(Case):
    def make(self, *arguments):
        self.quietly(*SIZE, *arguments, *FILES)
        return self.all_bytes()

    def test_names(self):
        """The names that the option allows are those whose options are told."""
        text = text_of("terrain", "--help")
        entry = re.search(r"\n  --preset (?s:.*?)(?=\n  --)", text).group()
        names = re.search(r"(\w+(, \w+)+ or \w+)", " ".join(entry.split())).group()
        self.assertEqual(re.findall(r"\w+", names.replace(" or ", ", ")), ["none", *told()])
        self.assertEqual(list(told()), ["alps", "dunes", "islands", "canyon", "badlands",
                                        "hills", "volcanic", "highlands", "cirques", "karst",
                                        "crests", "folds"])

    def test_options_are_told(self):
        plain = self.make()
        self.check_same_files(self.make("--preset", "none"), plain)
        seen = [plain["h.r32"]]
        for name, words in told().items():
            with self.subTest(preset=name):
                made = self.make("--preset", name)
                self.check_same_files(made, self.make(*words))
                self.check_same_files(self.make("--preset=" + name), made)
                self.assertNotIn(made["h.r32"], seen)
                seen.append(made["h.r32"])

    def test_no_jumps(self):
        """By the rule; and rows of samples 0.01 units apart have no step of a tenth of a unit."""
        self.assertTrue(jumps(["--basis", "cell-f1", "--fractal", "swiss"], ""))
        for name, words in told().items():
            for part in ("", "warp-", "base-", "mask-"):
                self.assertFalse(jumps(words, part), (name, part))
            for seed in range(1, 5):
                self.quietly("--preset", name, "--seed", str(seed), "--size", "16384x1", "--step",
                             "0.01", "--origin", f"{97 * seed},{31 * seed}", "--heights", "h.r32")
                row = struct.unpack("<16384f", self.all_bytes()["h.r32"])
                most = max(abs(b - a) for a, b in zip(row, row[1:]))
                self.assertLess(most, 0.1, (name, seed))

    def test_options_win(self):
        """Wherever they stand, also where they say what would be so without a preset."""
        for name, words in told().items():
            for option, value in (("--octaves", "3"), ("--octaves", "9"), ("--height", "120"),
                                  ("--fractal", "fbm"), ("--frequency", "0.0025"),
                                  ("--gain", "0.4"), ("--sea-level", "-0.5"), ("--seed", "4")):
                with self.subTest(preset=name, option=option):
                    expected = self.make(*words, option, value)
                    self.check_same_files(self.make("--preset", name, option, value), expected)
                    self.check_same_files(self.make(option, value, "--preset", name), expected)
                    self.check_same_files(self.make(option, "7", option, value, "--preset", name)
                                          if option != "--fractal" else expected, expected)

    def test_last_wins(self):
        """It replaces the presets before it, of which nothing is left."""
        dunes = self.make("--preset", "dunes")
        self.check_same_files(self.make("--preset", "islands", "--preset", "dunes"), dunes)
        self.check_same_files(self.make("--preset", "islands", "--rotate", "--preset", "dunes"),
                              dunes)
        self.check_same_files(self.make("--preset", "canyon", "--preset", "none"), self.make())

    def test_unknown(self):
        for name in ("Alps", "alp", "alps ", "", "1"):
            result = run("terrain", *SIZE, "--preset", name, cwd=self.directory)
            self.check_one_line(result, 2, "--preset", "none, alps, dunes, islands, canyon, badlands, "
                                "hills, volcanic, highlands, cirques, karst, crests or folds")
        self.assertEqual(self.files(), [])

    def test_bad_option_beside(self):
        """A preset that would make it good does not hide it."""
        result = run("terrain", *SIZE, "--gain", "x", "--preset", "alps", cwd=self.directory)
        self.check_one_line(result, 2, "--gain")
        result = run("terrain", "--preset", "alps", "--frequency", "281474976710656",
                     cwd=self.directory)
        self.check_one_line(result, 2, "--frequency")
        self.assertEqual(self.files(), [])


common.main(globals())
