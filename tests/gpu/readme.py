#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""readme.py DOCUMENT INCLUDE GLSLANG: compiles the shader in GLSL of src/gpu/README.md."""
import pathlib
import re
import subprocess
import sys
import tempfile

document, include, glslang = sys.argv[1:]
blocks = re.findall(r"^```glsl\n(.*?)^```$", pathlib.Path(document).read_text(), re.M | re.S)
assert len(blocks) == 1, f"{document} has {len(blocks)} shaders in GLSL"
with tempfile.TemporaryDirectory() as scratch:
    source = pathlib.Path(scratch, "height.comp")
    source.write_text(blocks[0])
    subprocess.run([glslang, "-V", f"-I{include}", "-o", f"{scratch}/height.spv", source],
                   check=True)
