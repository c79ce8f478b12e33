# SPDX-License-Identifier: MIT
"""The wheel installs into an empty folder, and works there without the tree and the environment.

    test_wheel.py SOURCE_DIR LIBRARY SCRATCH_DIR
"""
import base64
import hashlib
import os
import shutil
import subprocess
import sys
import unittest
import zipfile

from common import LIBRARY, MODULE, REST, prepare, run

prepare()
SAMPLE = """
import os, sys
import scarp
from scarp import _library
assert os.path.dirname(scarp.__file__) == os.path.join(sys.argv[1], "scarp"), scarp.__file__
assert _library.path_of_library.startswith(sys.argv[1]), _library.path_of_library
height = scarp.preset("alps", seed=8).grid((64, 64), step=30, derivatives=1)
print(height.value.shape, scarp.__version__, float(height.value[0, 0]))
"""


class Wheel(unittest.TestCase):
    def setUp(self):
        self.scratch = REST[0]
        shutil.rmtree(self.scratch, ignore_errors=True)
        os.makedirs(self.scratch)
        self.wheel = self.make(self.scratch)

    @staticmethod
    def make(folder):
        return subprocess.run([sys.executable, "-B", os.path.join(MODULE, "wheel.py"), LIBRARY,
                               folder], check=True, text=True,
                              stdout=subprocess.PIPE).stdout.strip()

    def test_contents(self):
        with zipfile.ZipFile(self.wheel) as wheel:
            names = wheel.namelist()
            record = [n for n in names if n.endswith(".dist-info/RECORD")]
            self.assertEqual(len(record), 1)
            lines = wheel.read(record[0]).decode().split()
            self.assertEqual([line.split(",")[0] for line in lines], names)
            for line in lines[:-1]:
                name, digest, size = line.split(",")
                data = wheel.read(name)
                mine = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=")
                self.assertEqual((digest, size), ("sha256=" + mine.decode(), str(len(data))))
        for name in ("__init__.py", "__init__.pyi", "py.typed", "presets/alps.recipe"):
            self.assertIn("scarp/" + name, names)
        with open(self.wheel, "rb") as one, open(
                self.make(os.path.join(self.scratch, "again")), "rb") as other:
            self.assertEqual(one.read(), other.read())

    def test_installed(self):
        place = os.path.join(self.scratch, "place")
        pip = [sys.executable, "-m", "pip"]
        if subprocess.run(pip + ["--version"], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode == 0:
            subprocess.run(pip + ["install", "--quiet", "--no-index", "--no-deps",
                                  "--no-compile", "--target", place, self.wheel], check=True)
        else:
            with zipfile.ZipFile(self.wheel) as wheel:
                wheel.extractall(place)
        environment = {k: v for k, v in os.environ.items()
                       if k not in ("SCARP_LIBRARY", "LD_LIBRARY_PATH", "PYTHONPATH")}
        environment["PYTHONPATH"] = place
        done = subprocess.run([sys.executable, "-B", "-c", SAMPLE, place], check=True, text=True,
                              cwd=self.scratch, env=environment, stdout=subprocess.PIPE)
        self.assertTrue(done.stdout.startswith("(64, 64) "), done.stdout)


run()
