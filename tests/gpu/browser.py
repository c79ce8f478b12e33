# SPDX-License-Identifier: MIT
"""Runs the shaders in headless Chromium, and compares every bit with the C library.

    browser.py TEST CHROMIUM WRITE_CASES SOURCE [OPTION]      TEST: wgsl, webgl, control
    browser.py TEST CHROMIUM CASES SOURCE COUNT EVERY RECIPE...    TEST: recipes.wgsl, recipes.webgl

WRITE_CASES is the program that writes what to compare with, of recipes gpu_recipe_cases; SOURCE the
top of the repository, with the shaders and src/gpu/README.md, whose sample must compile. The page
tells how it went: the exit status is 0, 1, or 77 where the browser lacks WebGPU or WebGL 2. OPTION
no-barrier lets compilers fuse operations.
"""
import http.server
import os
import queue
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

SKIPPED = 77
TIME_LIMIT = 300  # seconds without a line of the report
HERE = os.path.dirname(os.path.abspath(__file__))
FLAGS = ["--headless=new", "--no-first-run", "--no-default-browser-check", "--disable-sync",
         "--disable-background-networking", "--disable-component-update", "--disable-extensions",
         "--disable-breakpad", "--disable-crash-reporter", "--disable-dev-shm-usage",
         "--disable-gpu-watchdog",  # shaders may take long to compile
         # Processors do the work of a GPU: every machine has those.
         "--enable-unsafe-webgpu", "--enable-unsafe-swiftshader", "--use-angle=swiftshader",
         "--use-webgpu-adapter=swiftshader"]


def handler(folders, messages):
    """Serves files of `folders` (by the first part of the path), and queues what is posted."""
    class Handler(http.server.BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"
        disable_nagle_algorithm = True  # which waits between head and body
        kinds = {".html": "text/html", ".js": "text/javascript", ".json": "application/json"}

        def answer(self, status, kind="text/plain", body=b""):
            self.send_response(status)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def do_GET(self):
            name = self.path.split("?")[0].lstrip("/")
            folder, _, rest = name.rpartition("/")
            try:
                with open(os.path.join(folders[folder], rest), "rb") as file:
                    body = file.read()
            except (KeyError, OSError):
                self.answer(404)
                return
            kind = self.kinds.get(os.path.splitext(rest)[1], "application/octet-stream")
            self.answer(200, kind, body)

        def do_POST(self):
            text = self.rfile.read(int(self.headers["Content-Length"])).decode()
            messages.put((self.path, text))
            self.answer(204)

        def log_message(self, *_):
            pass

    return Handler


class Server(http.server.ThreadingHTTPServer):
    daemon_threads = True

    def handle_error(self, *_):
        pass  # the browser has gone


def follow(messages, browser):
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


def browse(chromium, url, messages, scratch):
    """Opens the URL in a browser of its own, and ends all its processes."""
    flags = FLAGS + ["--user-data-dir=" + os.path.join(scratch, "profile")]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        flags.append("--no-sandbox")
    with open(os.path.join(scratch, "log"), "w+b") as log:
        # A browser that is killed leaves temporary files behind.
        browser = subprocess.Popen([chromium, *flags, url], stdin=subprocess.DEVNULL, stdout=log,
                                   stderr=log, start_new_session=True,
                                   env=dict(os.environ, TMPDIR=scratch))
        try:
            status = follow(messages, browser)
        finally:
            try:
                os.killpg(browser.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            browser.wait()
        if status is None:
            log.seek(0)
            print("The browser says:", log.read().decode(errors="replace")[-4000:])
    return 1 if status is None else status


def end(*_):
    """Lets every `finally` do its work when this is told to end."""
    sys.exit(1)


def main():
    test, chromium, write_cases, source, *options = sys.argv[1:]
    signal.signal(signal.SIGTERM, end)
    begin = time.monotonic()
    messages = queue.Queue()
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
        folders = {"": HERE, "shaders": os.path.join(source, "include"), "cases": cases}
        server = Server(("127.0.0.1", 0), handler(folders, messages))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        query = "&".join(["test=" + test, *options])
        url = f"http://127.0.0.1:{server.server_port}/page.html?{query}"
        status = browse(chromium, url, messages, scratch)
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
