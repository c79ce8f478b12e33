// SPDX-License-Identifier: MIT
//
// The sample src/gpu/samples/plan.mjs writes the plan that the library in C writes, on a processor
// with the low byte first:
//
//     node plan.mjs PACKAGE SAMPLE      PACKAGE is the folder of scarp.mjs
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [scarp, sample] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'scarp-'));
try {
    const text = readFileSync(sample, 'utf8');
    const address = pathToFileURL(resolve(scarp, 'scarp.mjs')).href;
    assert.equal(text.split("'scarp-noise'").length, 2);
    writeFileSync(join(folder, 'plan.mjs'), text.replace("'scarp-noise'", `'${address}'`));
    execFileSync(process.execPath, ['plan.mjs'], { cwd: folder });
    const plan = readFileSync(join(folder, 'relief.plan'));
    const expected = readFileSync(new URL('relief.sha256', import.meta.url), 'utf8').trim();
    assert.equal(plan.length, 5376);
    assert.equal(createHash('sha256').update(plan).digest('hex'), expected);
} finally {
    rmSync(folder, { recursive: true });
}
