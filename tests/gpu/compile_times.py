#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How long drivers take to compile the shaders: the table of src/gpu/README.md. No test.

    compile_times.py GPU_VULKAN GLSLANG SPIRV_OPT CHROMIUM [RUNS]

Medians of RUNS (5) in seconds, from the shader as a driver gets it to the result of one point:
SPIR-V in Vulkan, as glslang made it and after spirv-opt -O, without Mesa's cache of shaders; WGSL in
WebGPU, in a new browser for each run. These are seconds of a processor in the process that compiles, so that other work on
the machine does not count.
"""
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # among the sources
HERE = pathlib.Path(__file__).resolve().parent
INCLUDE = HERE.parent.parent / "include"
sys.path.insert(0, str(HERE.parent / "web"))
import chromium  # noqa: E402

TASKS = ("value", "gradient")
# What is fixed, by the name of the table
FIXED = {"everything": {}, "one basis": {"basis": 0}, "one basis, no warp": {"basis": 0, "depth": 0},
         "one basis, one fractal, no warp": {"basis": 0, "fractal": 0, "depth": 0}}
GLSL = """#version 450
#extension GL_GOOGLE_include_directive : require
#include "scarp.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = 2) writeonly buffer Results { vec4 result; };
void main() {
    float x = scarp_plan[0].unit;
    ScarpSample n = scarp_sample%d(0u, %s);
    result = vec4(n.value, %s);
}
"""
NOTHING = "#version 450\nvoid main() {}\n"
WGSL = """
@group(0) @binding(0) var<uniform> scarp_plan: array<ScarpPlan, 1>;
@group(0) @binding(1) var<storage, read_write> result: array<vec4f, 1>;
@compute @workgroup_size(1) fn main() {
    let x = scarp_plan[0].unit;
    let n = scarp_sample%d(0u, %s);
    result[0] = vec4f(n.value, %s);
}
"""
NO_WGSL = """
@group(0) @binding(0) var<uniform> a: vec4f;
@group(0) @binding(1) var<storage, read_write> b: array<vec4f, 1>;
@compute @workgroup_size(1) fn main() { b[0] = a; }
"""
PAGE = """(async (code, fixed) => {
    const adapter = await navigator.gpu.requestAdapter(), gpu = await adapter.requestDevice();
    const constants = Object.fromEntries(
        Object.entries(fixed).map(([name, value]) => ["scarp_only_" + name, value]));
    const make = (size, usage) => gpu.createBuffer({size, usage});
    const buffers = [make(5376, GPUBufferUsage.UNIFORM), make(16, GPUBufferUsage.STORAGE)];
    const compute = {module: gpu.createShaderModule({code}), entryPoint: "main", constants};
    const pipeline = await gpu.createComputePipelineAsync({layout: "auto", compute});
    const encoder = gpu.createCommandEncoder(), pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, gpu.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries:
        buffers.map((buffer, binding) => ({binding, resource: {buffer}}))}));
    pass.dispatchWorkgroups(1);
    pass.end();
    gpu.queue.submit([encoder.finish()]);
    await gpu.queue.onSubmittedWorkDone();
})"""


def filled(shader, d, task):
    """The shader in so many dimensions, with what it takes of the sample."""
    return shader % (d, ", ".join("x" * d), {"value": "0.0, 0.0, 0.0", "gradient": "n.gradient"}[task])


def vulkan(gpu_vulkan, glslang, optimise, fixed, d, task):
    """`optimise` is a command. The program runs two shaders: this one in the place of that in 2D, and one that does nothing."""
    only = [f"-DSCARP_ONLY_{name.upper()}={value}u" for name, value in fixed.items()]
    with tempfile.TemporaryDirectory() as scratch:
        for name, text in (("main-2d", filled(GLSL, d, task)), ("main-3d", NOTHING)):
            source = pathlib.Path(scratch, name + ".comp")
            source.write_text(text)
            subprocess.run([glslang, "--quiet", "-V", *only, f"-I{INCLUDE}",
                            "-o", f"{scratch}/{name}.spv", source], check=True)
        if optimise:
            subprocess.run([*optimise, f"{scratch}/main-2d.spv", "-o", f"{scratch}/main-2d.spv"],
                           check=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        said = subprocess.run([gpu_vulkan, f"{scratch}/main", "64", "value", "no such case"],
                              stdout=subprocess.PIPE, text=True,
                              env=dict(os.environ, MESA_SHADER_CACHE_DISABLE="true")).stdout
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert said.count("compiled in") == 2, said
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def gpu_process_time(browser):
    """Seconds that the process has worked which compiles for this browser, known by its folder."""
    for process in pathlib.Path("/proc").iterdir():
        try:
            if os.getsid(int(process.name)) != browser.browser.pid:
                continue
            if b"--type=gpu-process" in (process / "cmdline").read_bytes():
                of = (process / "stat").read_text().rpartition(")")[2].split()
                return (int(of[11]) + int(of[12])) / os.sysconf("SC_CLK_TCK")
        except (ValueError, OSError):
            continue
    raise RuntimeError("the browser has no process for the GPU")


def webgpu(program, fixed, d, task):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        server = chromium.serve(scratch)
        browser = chromium.Chromium(program, scratch)
        try:
            browser.open(f"http://127.0.0.1:{server.server_port}/")
            browser.wait("document.readyState == 'complete' && location.port != ''")
            browser.run(f"{PAGE}({json.dumps(NO_WGSL)}, {{}})")
            code = (INCLUDE / "scarp.wgsl").read_text() + filled(WGSL, d, task)
            before = gpu_process_time(browser)
            browser.run(f"{PAGE}({json.dumps(code)}, {json.dumps(fixed)})")
            return gpu_process_time(browser) - before
        finally:
            browser.close()
            server.shutdown()
            server.server_close()


def main():
    gpu_vulkan, glslang, spirv_opt, program, *runs = sys.argv[1:]
    for name, fixed in FIXED.items():
        for task in TASKS:
            for d in (2, 3):
                for driver, measure in (
                        ("llvmpipe", lambda: vulkan(gpu_vulkan, glslang, [], fixed, d, task)),
                        ("llvmpipe after spirv-opt",
                         lambda: vulkan(gpu_vulkan, glslang, [spirv_opt, "-O"], fixed, d, task)),
                        ("SwiftShader", lambda: webgpu(program, fixed, d, task))):
                    times = [measure() for _ in range(int(runs[0]) if runs else 5)]
                    print(f"{name}, {task} {d}D, {driver}: {statistics.median(times):.2f} "
                          f"({min(times):.2f} to {max(times):.2f})", flush=True)


if __name__ == "__main__":
    main()
