// SPDX-License-Identifier: MIT
//
// node browser.mjs CHROMIUM TEST: what the package does in a browser. The page sends what it finds
// to a server of this process.
//
//     bits      the package gives the bits of C
//     webgpu    the sample of README.md with WebGPU runs as it stands there, and prints what stands
//               below it; 77 where the browser has no WebGPU
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';

const BITS = `<!doctype html><script type="module">
const lines = [];
try {
    const { load } = await import('./scarp.mjs');
    const { lines: cases } = await import('./test/cases.mjs');
    const expected = await (await fetch('./test/expected.txt')).text();
    for (const options of [{}, { simd: false }]) {
        const scarp = await load(options);
        const equal = cases(scarp, true).join('\\n') + '\\n' === expected;
        lines.push(scarp.isa + (equal ? ' equal' : ' different'));
    }
} catch (error) {
    lines.push(String(error));
}
await fetch('./result', { method: 'POST', body: lines.join(', ') });
</script>`;
// The map of names does what node does with the names of a package.
const WEBGPU = `<!doctype html>
<script type="importmap">{"imports": {"scarp-noise": "./scarp.mjs", "scarp-noise/": "./"}}</script>
<script type="module">
const lines = [];
console.log = (...words) => lines.push(words.join(' '));
try {
    if (await navigator.gpu?.requestAdapter()) {
        await import('./sample.mjs');
    } else {
        lines.push('skipped: this browser has no WebGPU');
    }
} catch (error) {
    lines.push(String(error));
}
await fetch('./result', { method: 'POST', body: lines.join('\\n') });
</script>`;
const TYPES = { '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.txt': 'text/plain' };
const QUIET = [
    '--headless=new',
    '--no-sandbox',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--disable-gpu-watchdog',
];
// Processors do the work of a GPU: every machine has those.
const GPU = [
    '--enable-unsafe-webgpu',
    '--enable-unsafe-swiftshader',
    '--use-webgpu-adapter=swiftshader',
];
const REQUIRED = (process.env.SCARP_REQUIRE_TOOLS ?? '').split(',').includes('chromium');

const readme = readFileSync(new URL('../README.md', import.meta.url), 'utf8');
const [, sample, printed] = /```javascript\n(.*?)```\n\n```text\n(.*?)\n```/s.exec(readme);
const TESTS = {
    bits: { page: BITS, expected: 'wasm128 equal, generic equal', flags: ['--disable-gpu'] },
    webgpu: { page: WEBGPU, expected: printed, flags: GPU },
};
const { page, expected, flags } = TESTS[process.argv[3]];

const profile = mkdtempSync(join(tmpdir(), 'scarp-browser-'));
let browser;

// Processes of the browser write for a moment after it has ended.
function remove(tries) {
    try {
        rmSync(profile, { recursive: true, force: true });
    } catch {
        if (tries > 0) {
            setTimeout(remove, 100, tries - 1);
        }
    }
}

function finish(result) {
    console.log(result);
    const isSkipped = result.startsWith('skipped') && !REQUIRED;
    process.exitCode = result === expected ? 0 : isSkipped ? 77 : 1;
    clearTimeout(patience);
    server.close();
    server.closeAllConnections();
    browser.once('close', () => remove(50));
    browser.kill();
}

const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    if (request.method === 'POST') {
        let body = '';
        for await (const part of request) {
            body += part;
        }
        response.end();
        finish(body);
    } else if (pathname === '/') {
        response.writeHead(200, { 'content-type': 'text/html' }).end(page);
    } else if (pathname === '/sample.mjs') {
        response.writeHead(200, { 'content-type': TYPES['.mjs'] }).end(sample);
    } else {
        try {
            const bytes = readFileSync(new URL(`..${pathname}`, import.meta.url));
            response.writeHead(200, { 'content-type': TYPES[extname(pathname)] ?? '' }).end(bytes);
        } catch {
            response.writeHead(404).end();
        }
    }
});
const patience = setTimeout(() => finish('the page did not answer'), 100000);
server.listen(0, '127.0.0.1', () => {
    const options = [...QUIET, ...flags, `--user-data-dir=${profile}`];
    const url = `http://127.0.0.1:${server.address().port}/`;
    browser = spawn(process.argv[2], [...options, url], { stdio: 'ignore' });
});
