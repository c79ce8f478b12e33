#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The samples of src/gpu/samples for Unity and Unreal, without these.

    engines.py hlsl GLSLANG RELIEF SOURCE             their shaders run in Vulkan, by relief, and
                                                      draw the library's picture
    engines.py csharp MCS MONO LIBRARY WRITE_RELIEF SOURCE
                                                      the C# fills the constant buffer as C does
    engines.py cpp COMPILER SOURCE                    the C++ compiles
"""
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SKIPPED = 77


def run(*command, **options):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, **options).stdout


def samples(source):
    return pathlib.Path(source, "src/gpu/samples")


def hlsl(scratch, glslang, relief, source):
    include = pathlib.Path(source, "include")
    run(relief, scratch / "library.ppm")
    # Unreal's folders, with one of its headers, which does not matter here
    text = (samples(source) / "Relief.usf").read_text()
    for virtual in ("/Engine/Public/Platform.ush", "/Plugin/Scarp/scarp.ush"):
        assert text.count(f'#include "{virtual}"\n') == 1, virtual
        text = text.replace(virtual, virtual.rpartition("/")[2])
    (scratch / "Platform.ush").write_text("")
    (scratch / "scarp.ush").write_bytes((include / "scarp.hlsl").read_bytes())
    (scratch / "Relief.usf").write_text(text)
    for shader in (samples(source) / "Relief.compute", scratch / "Relief.usf"):
        compiled = scratch / (shader.name + ".spv")
        command = [glslang, "-D", "-V", "-S", "comp", "-e", "main", "--auto-map-bindings"]
        run(*command, "--source-entrypoint", "Relief", f"-I{include}", f"-I{scratch}",
            "-o", compiled, shader)
        picture = scratch / (shader.name + ".ppm")
        said = run(relief, picture, compiled)
        assert "3712 of 3712 heights are the library's" in said, said
        assert picture.read_bytes() == (scratch / "library.ppm").read_bytes(), shader.name
        print(shader.name, "draws the library's picture")
    run(*command, "--source-entrypoint", "Answers", f"-I{include}", "-o", compiled,
        samples(source) / "Relief.compute")
    said = run(relief, picture, compiled)
    assert " keeps the bits: 4096 of 4096 answers are equal" in said, said
    print("Relief.compute gives the answers")


def csharp(scratch, mcs, mono, library, write_relief, source):
    if ".so" not in library:
        print("skipped: C# needs the shared library")
        sys.exit(SKIPPED)
    program = scratch / "Unity.exe"
    run(mcs, "-unsafe", "-langversion:latest", "-warnaserror", "-warn:4", f"-out:{program}",
        HERE / "Unity.cs", HERE / "UnityEngine.cs", samples(source) / "Relief.cs",
        pathlib.Path(source, "src/bindings/csharp/Scarp.cs"))
    said = run(mono, program, scratch / "plan",
               env=dict(os.environ, LD_LIBRARY_PATH=os.path.dirname(library)))
    assert "4096 answers are equal" in said, said
    run(write_relief, scratch / "relief.plan", scratch / "pixels")
    plan = (scratch / "relief.plan").read_bytes()
    assert len(plan) == 5376 and (scratch / "plan").read_bytes() == plan
    if sys.byteorder == "little":  # JavaScript writes the same: plan.mjs
        expected = (HERE / "relief.sha256").read_text().strip()
        assert hashlib.sha256(plan).hexdigest() == expected, "relief.sha256 is of another plan"
    print("C# fills the constant buffer with the bytes of C")


def cpp(scratch, compiler, source):
    for name in ("GlobalShader.h", "PipelineStateCache.h", "ShaderParameterUtils.h"):
        (scratch / name).write_text('#include "unreal.h"\n')
    run(compiler, "-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", f"-I{scratch}",
        f"-I{HERE}", f"-I{source}/include", samples(source) / "Relief.cpp")
    print("Relief.cpp compiles")


def main():
    with tempfile.TemporaryDirectory() as scratch:
        {"hlsl": hlsl, "csharp": csharp, "cpp": cpp}[sys.argv[1]](pathlib.Path(scratch),
                                                                  *sys.argv[2:])


if __name__ == "__main__":
    main()
