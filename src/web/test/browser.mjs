// SPDX-License-Identifier: MIT
//
// The package gives the bits of C in a browser, too: node browser.mjs CHROMIUM. The page sends what
// it finds to a server of this process.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';

const PAGE = `<!doctype html><script type="module">
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
const TYPES = { '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.txt': 'text/plain' };
const EXPECTED = 'wasm128 equal, generic equal';

const profile = mkdtempSync(join(tmpdir(), 'scarp-browser-'));
let browser;

function finish(result) {
    console.log(result);
    process.exitCode = result === EXPECTED ? 0 : 1;
    clearTimeout(patience);
    server.close();
    server.closeAllConnections();
    browser.once('close', () => rmSync(profile, { recursive: true, force: true, maxRetries: 9 }));
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
        response.writeHead(200, { 'content-type': 'text/html' }).end(PAGE);
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
    const options = ['--headless', '--no-sandbox', '--disable-gpu', `--user-data-dir=${profile}`];
    const page = `http://127.0.0.1:${server.address().port}/`;
    browser = spawn(process.argv[2], [...options, page], { stdio: 'ignore' });
});
