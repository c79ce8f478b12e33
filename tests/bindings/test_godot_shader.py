# SPDX-License-Identifier: MIT
"""The shader on the page about Godot compiles as GLSL 450, with the functions of a recipe in it.

    test_godot_shader.py SOURCE_DIR GLSLANG SCRATCH_DIR [EMULATOR...] SCARP
"""
import os
import re
import subprocess
import sys

PLACE = "// Here stands what shader(file, 0) returns: its buffer is at set 0, binding 0.\n"


def main():
    source, glslang, scratch, *scarp = sys.argv[1:]
    with open(os.path.join(source, "src/bindings/godot/README.md"), encoding="utf-8") as file:
        page = file.read()
    shader, = re.findall(r"(?ms)^```glsl\n(.*?)^```$", page)
    version, main_text = shader.split(PLACE)
    assert version == "#version 450\n", version
    os.makedirs(scratch, exist_ok=True)
    path = os.path.join(scratch, "page.comp")
    functions = subprocess.run([*scarp, "recipe", "alps", "--shader", "glsl", "--derivatives", "0"],
                               check=True, stdout=subprocess.PIPE, text=True).stdout
    with open(path, "w", encoding="utf-8") as file:
        file.write(version + functions + main_text)
    run = subprocess.run([glslang, "-V", "-o", os.path.join(scratch, "page.spv"), path],
                         stdout=subprocess.PIPE, text=True)
    if run.returncode != 0:
        sys.exit(run.stdout)
    print("compiles:", len(functions), "bytes of functions")


main()
