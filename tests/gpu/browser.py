# SPDX-License-Identifier: MIT
"""Runs the shaders in headless Chromium, and compares every bit with the C library.

    browser.py TEST CHROMIUM WRITE_CASES SOURCE [OPTION]      TEST: wgsl, webgl, control
    browser.py TEST CHROMIUM CASES SOURCE COUNT EVERY RECIPE...    TEST: recipes.wgsl, recipes.webgl

WRITE_CASES is the program that writes what to compare with, of recipes gpu_recipe_cases; SOURCE the
top of the repository, with the shaders and src/gpu/README.md, whose sample must compile. The page
says how it went: the exit status is 0, 1, or 77 where the browser lacks WebGPU or WebGL 2. OPTION
no-barrier lets compilers fuse operations.
"""
import os
import pathlib
import queue
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # among the sources
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "web"))
from chromium import Chromium, Handler, serve  # noqa: E402

SKIPPED = 77
TIME_LIMIT = 300  # seconds without a line of the report
messages = queue.Queue()


class Reports(Handler):
    """Queues what is posted."""
    def do_POST(self):
        messages.put((self.path, self.rfile.read(int(self.headers["Content-Length"])).decode()))
        self.send_response(204)
        self.end_headers()


def follow(browser):
    """Prints the report. Returns the status at its end, or None where there is no end."""
    since = time.monotonic()
    while True:
        try:
            where, text = messages.get(timeout=1)
        except queue.Empty:
            if browser.poll() is not None:
                print("the browser ended with status", browser.returncode)
                return None
            if time.monotonic() - since > TIME_LIMIT:
                print("no report for", TIME_LIMIT, "seconds")
                return None
            continue
        if where == "/end":
            return int(text)
        since = time.monotonic()
        print(text, flush=True)


def browse(chromium, url, scratch):
    """Opens the URL in a browser of its own, and ends all its processes."""
    page = Chromium(chromium, scratch)
    try:
        page.open(url)
        status = follow(page.browser)
        if status is None:
            page.log.seek(0)
            print("The browser says:", page.log.read().decode(errors="replace")[-4000:])
    finally:
        page.close()
    return 1 if status is None else status


def end(*_):
    """Lets every `finally` do its work when this is told to end."""
    sys.exit(1)


def main():
    test, chromium, write_cases, source, *options = sys.argv[1:]
    signal.signal(signal.SIGTERM, end)
    begin = time.monotonic()
    scratch = tempfile.mkdtemp(prefix="scarp-gpu-")
    try:
        cases = os.path.join(scratch, "cases")
        os.mkdir(cases)
        if test.startswith("recipes."):
            count, every, *recipes = options
            file = "scarp.wgsl" if test.endswith("wgsl") else "scarp.glsl"
            subprocess.run([write_cases, cases, count, every,
                            os.path.join(source, "include", file), *recipes], check=True)
            options = []
        else:
            subprocess.run([write_cases, cases], check=True)
        with open(os.path.join(source, "src", "gpu", "README.md"), encoding="utf-8") as readme, \
                open(os.path.join(cases, "example.wgsl"), "w", encoding="utf-8") as example:
            example.write(re.search(r"^```wgsl\n(.*?)^```$", readme.read(), re.M | re.S).group(1))
        site = pathlib.Path(scratch, "site")
        shutil.copytree(HERE, site)
        (site / "shaders").symlink_to(pathlib.Path(source, "include").resolve())
        (site / "cases").symlink_to(cases)
        server = serve(str(site), Reports)
        query = "&".join(["test=" + test, *options])
        url = f"http://127.0.0.1:{server.server_port}/page.html?{query}"
        status = browse(chromium, url, scratch)
        server.shutdown()
    finally:  # files of the browser may still appear while they are removed
        shutil.rmtree(scratch, ignore_errors=True)
    print(f"{time.monotonic() - begin:.1f} s")
    if status == SKIPPED and "chromium" in os.environ.get("SCARP_REQUIRE_TOOLS", "").split(","):
        print("FAILED (required): chromium must have what was missing")
        status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
