#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What src/gpu/README.md says is so, block by block. A block that no test knows is a mistake.

    readme.py blocks SOURCE GLSLANG      the shader in GLSL compiles; parts of samples are in the
                                         samples as they are here
    readme.py commands SOURCE LIBRARY    the commands build and run the program, which says what
                                         the document says

test_readme.py compiles what is C, browser.py the first shader in WGSL. The samples have tests of
their own.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SKIPPED = 77
PACKAGE = """Name: scarp
Description: for the test
Version: 0
Cflags: -I{include}
Libs: -L{lib} -lscarp
"""
# Samples whose parts the document shows, by the language of the block
PARTS = {"js": ("webgpu.html", "webgl.html", "plan.mjs"), "hlsl": ("Relief.compute", "Relief.usf"),
         "csharp": ("Relief.cs",), "cpp": ("Relief.cpp",)}
# How many blocks there are that others test
OTHERS = {"c": 2, "wgsl": 1}


class Readme:
    def __init__(self, source):
        self.source = pathlib.Path(source).resolve()
        text = (self.source / "src/gpu/README.md").read_text()
        self.blocks = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.M | re.S)
        assert text.count("```") == 2 * len(self.blocks), "a fence is not closed"

    def of(self, language):
        return [body for kind, body in self.blocks if kind == language]

    def samples(self):
        return self.source / "src/gpu/samples"


def check_part(readme, language, body):
    texts = [(readme.samples() / name).read_text() for name in PARTS[language]]
    assert any(body in text for text in texts), f"is in none of {PARTS[language]}:\n{body}"


def check_blocks(readme, glslang):
    for language in OTHERS:
        assert len(readme.of(language)) == OTHERS[language], f"blocks of {language}"
    for language, names in PARTS.items():
        assert len(readme.of(language)) > 0, f"no block of {language}"
    kinds = {kind for kind, _ in readme.blocks}
    assert kinds == {*OTHERS, *PARTS, "glsl", "sh", "text"}, kinds
    for language, body in readme.blocks:
        if language in PARTS:
            check_part(readme, language, body)
    assert len(readme.of("glsl")) == 1
    with tempfile.TemporaryDirectory() as scratch:
        source = pathlib.Path(scratch, "height.comp")
        source.write_text(readme.of("glsl")[0])
        subprocess.run([glslang, "-V", f"-I{readme.source}/include", "-o", f"{scratch}/height.spv",
                        source], check=True)
    print(len(readme.blocks), "blocks are right, or others test them")


def said_by_any(text):
    """What the program says, on whatever device."""
    return re.sub(r"^.* (keeps|DOES NOT KEEP) the bits", r"A device \1 the bits", text)


def check_commands(readme, library):
    if ".so" not in library:
        print("skipped: the commands link with the shared library")
        sys.exit(SKIPPED)
    folder = os.path.dirname(library)
    scripts, (printed,) = readme.of("sh"), readme.of("text")
    assert len(scripts) == 2
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        for sample in readme.samples().iterdir():
            if sample.suffix != ".png":
                (scratch / sample.name).write_bytes(sample.read_bytes())
        include = readme.source / "include"
        # The name of the variable is that of the installed file.
        (scratch / "scarp.pc").write_text(f"includedir={include}\n" +
                                          PACKAGE.format(include=include, lib=folder))
        environment = dict(os.environ, LD_LIBRARY_PATH=folder, PKG_CONFIG_PATH=str(scratch))
        said = [subprocess.run(["sh", "-e", "-c", script], cwd=scratch, check=True, text=True,
                               env=environment, stdout=subprocess.PIPE).stdout
                for script in scripts]
        assert said_by_any(said[0]) == said_by_any(printed), said[0]
        assert said[1] == "", said[1]
        for name in ("relief.ppm", "relief.plan", "scarp.wgsl", "scarp.glsl"):
            assert (scratch / name).stat().st_size > 0, name
    print("the commands do what the document says")


def main():
    what, source, argument = sys.argv[1:]
    {"blocks": check_blocks, "commands": check_commands}[what](Readme(source), argument)


if __name__ == "__main__":
    main()
