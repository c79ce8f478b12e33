# SPDX-License-Identifier: MIT
"""What tests of the Python module have in common. They run as

    test_NAME.py SOURCE_DIR LIBRARY [argument...]

and skip where the interpreter cannot load the library."""
import os
import struct
import sys
import unittest

SKIPPED = 77
SOURCE, LIBRARY, *REST = sys.argv[1:]
MODULE = os.path.join(SOURCE, "src", "bindings", "python")


def skip(reason):
    print("skipped:", reason)
    sys.exit(SKIPPED)


def prepare():
    """Lets the module of the source tree find the library of this build."""
    if os.environ.get("SCARP_LOADS") == "OFF":
        skip("Python loads no library with instruments in it, nor one of another processor")
    if ".so" not in os.path.basename(LIBRARY):
        skip("the module needs a shared library")
    with open(LIBRARY, "rb") as file:
        head = file.read(20)
    with open(os.path.realpath(sys.executable), "rb") as file:
        own = file.read(20)
    if head[4:6] + head[18:20] != own[4:6] + own[18:20] or struct.calcsize("P") not in (4, 8):
        skip("the library is of another processor than Python")
    os.environ["SCARP_LIBRARY"] = LIBRARY
    sys.path.insert(0, MODULE)
    sys.dont_write_bytecode = True


def run():
    unittest.main(argv=sys.argv[:1])
