# SPDX-License-Identifier: MIT
"""Compiles recipes as shaders, and runs them on a Vulkan device.

    recipes.py [--must-differ] CASES RUN GLSLANG COUNT EVERY FILE RECIPE...

CASES is the program gpu_recipe_cases, whose arguments COUNT and so on are; RUN is gpu_recipes. Says
how long the compilers take. --must-differ: shaders whose operations may be fused are no success.
"""
import os
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor


def main():
    words = sys.argv[1:]
    control = [word for word in words if word == "--must-differ"]
    cases, run, glslang, count, every, file, *recipes = [w for w in words if w not in control]
    is_hlsl = file.endswith(".hlsl")
    flags = ["-D", "-e", "main"] if is_hlsl else []
    flags += ["-DSCARP_FUSE"] if control else []
    with tempfile.TemporaryDirectory(prefix="scarp-recipes-") as folder:
        subprocess.run([cases, folder, count, every, file, *recipes], check=True)
        shaders = [name for name in os.listdir(folder) if name.endswith((".comp", ".hlsl"))]

        def compile_shader(name):
            source = os.path.join(folder, name)
            return subprocess.run([glslang, "--quiet", "-V", "-S", "comp", *flags, "-o",
                                   os.path.splitext(source)[0] + ".spv", source]).returncode

        begin = time.monotonic()
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            failed = sum(status != 0 for status in pool.map(compile_shader, shaders))
        print(f"{len(shaders)} shaders, {failed} do not compile; glslang took "
              f"{time.monotonic() - begin:.1f} s")
        if failed or not shaders:
            return 1
        return subprocess.run([run, *control, folder]).returncode


if __name__ == "__main__":
    sys.exit(main())
