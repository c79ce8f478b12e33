// SPDX-License-Identifier: MIT
//
// Bundles the page of the tests of the graph: node build.mjs MODULES PACKAGE TO takes libraries from
// MODULES, where npm put them, and the module from PACKAGE, and writes to the folder TO.
import { copyFileSync, mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [modules, from, to] = process.argv.slice(2);
const { build } = createRequire(join(modules, 'here.js'))('esbuild');
const here = dirname(fileURLToPath(import.meta.url));
const page = join(here, '../../../src/web/playground');
const still = join(page, 'still.js');

mkdirSync(to, { recursive: true });
await build({
    absWorkingDir: here, entryPoints: ['page.js'], outdir: to, bundle: true, format: 'esm',
    target: 'es2022', nodePaths: [modules], external: ['node:*'], logLevel: 'warning',
    alias: { 'd3-transition': still, 'd3-interpolate': still },
});
for (const file of [join(here, 'index.html'), join(page, 'style.css'), join(page, 'graph/graph.css'),
    join(from, 'scarp-simd.wasm'), join(from, 'scarp-fallback.wasm')]) {
    copyFileSync(file, join(to, file.split('/').pop()));
}
