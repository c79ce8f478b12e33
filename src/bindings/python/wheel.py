#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a wheel of the module, with the shared library and the presets inside. It needs nothing but
Python, and no network.

    wheel.py LIBRARY FOLDER [PLATFORM]

LIBRARY is the shared library for the platform, by default that of this Python, as linux_x86_64.
The name of the wheel is printed. The same files give the same bytes.
"""
import base64
import hashlib
import os
import re
import sys
import sysconfig
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
PRESETS = os.path.join(ROOT, "src", "cli", "presets")
METADATA = """Metadata-Version: 2.1
Name: scarp
Version: {version}
Summary: Noise for terrain, with exact derivatives, as arrays of NumPy
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy>=1.20
Description-Content-Type: text/markdown

{text}"""
WHEEL = """Wheel-Version: 1.0
Generator: scarp
Root-Is-Purelib: false
Tag: {tag}
"""


def read(*path):
    with open(os.path.join(*path), "rb") as file:
        return file.read()


def version():
    """The version, as the tables of the module have it."""
    return re.search(r"(?m)^VERSION = '(.*)'$",
                     read(HERE, "scarp", "_interface.py").decode()).group(1)


def name_of(library):
    """The file name under which the module looks for the library beside itself."""
    name, abi = os.path.basename(library), ".".join(version().split(".")[:2])
    if ".so" in name:
        return "libscarp.so." + abi
    if name.endswith(".dylib"):
        return "libscarp.%s.dylib" % abi
    return name


def contents(library, tag):
    """All files of the wheel but RECORD, by name."""
    files = {}
    package = os.path.join(HERE, "scarp")
    for name in sorted(os.listdir(package)):
        if name.endswith((".py", ".pyi", ".typed")):
            files["scarp/" + name] = read(package, name)
    for name in sorted(os.listdir(PRESETS)):
        if name.endswith(".recipe"):
            files["scarp/presets/" + name] = read(PRESETS, name)
    files["scarp/" + name_of(library)] = read(library)
    info = "scarp-%s.dist-info/" % version()
    files[info + "METADATA"] = METADATA.format(
        version=version(), text=read(HERE, "README.md").decode()).encode()
    files[info + "WHEEL"] = WHEEL.format(tag=tag).encode()
    files[info + "LICENSE"] = read(ROOT, "LICENSE")
    return files, info + "RECORD"


def record(files, own):
    lines = []
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")
        lines.append("%s,sha256=%s,%d" % (name, digest, len(data)))
    return "\n".join(lines + [own + ",,"]) + "\n"


def write(path, files):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if ".so" in name else 0o644) << 16
            wheel.writestr(entry, data)


def main(library, folder, platform=None):
    platform = re.sub(r"[-.]", "_", platform or sysconfig.get_platform())
    tag = "py3-none-" + platform
    files, own = contents(library, tag)
    files[own] = record(files, own).encode()
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "scarp-%s-%s.whl" % (version(), tag))
    write(path, files)
    print(path)


if len(sys.argv) not in (3, 4):
    sys.exit(__doc__)
main(*sys.argv[1:])
