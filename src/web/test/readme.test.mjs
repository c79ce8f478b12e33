// SPDX-License-Identifier: MIT
//
// The samples of README.md run as they stand there, and print what stands below them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const readme = await readFile(new URL('../README.md', import.meta.url), 'utf8');
const samples = [...readme.matchAll(/```js\n(.*?)```\n\n```text\n(.*?)```/gs)];

test('there are samples, each with what it prints', () => {
    assert.ok(samples.length >= 3);
    assert.equal(samples.length, readme.match(/```js/g).length);
});

samples.forEach(([, code, expected], i) => {
    test(`sample ${i + 1}`, async () => {
        const folder = await mkdtemp(join(tmpdir(), 'scarp-'));
        try {
            const file = join(folder, 'sample.mjs');
            await writeFile(
                file,
                code.replace("'scarp-noise'", `'${new URL('../scarp.mjs', import.meta.url)}'`),
            );
            assert.equal(execFileSync(process.execPath, [file], { encoding: 'utf8' }), expected);
        } finally {
            await rm(folder, { recursive: true });
        }
    });
});
