#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""readme.py README INCLUDE GLSLANG: compiles the README's shader in GLSL."""
import pathlib
import re
import subprocess
import sys
import tempfile

readme, include, glslang = sys.argv[1:]
blocks = re.findall(r"^```glsl\n(.*?)^```$", pathlib.Path(readme).read_text(), re.M | re.S)
assert len(blocks) == 1, f"the README has {len(blocks)} shaders in GLSL"
with tempfile.TemporaryDirectory() as scratch:
    source = pathlib.Path(scratch, "height.comp")
    source.write_text(blocks[0])
    subprocess.run([glslang, "-V", f"-I{include}", "-o", f"{scratch}/height.spv", source],
                   check=True)
