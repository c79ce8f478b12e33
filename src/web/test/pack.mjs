// SPDX-License-Identifier: MIT
//
// npm pack makes a package that has what it needs and nothing else, and that can be used by name:
// in JavaScript, and with its types if there is a tsc.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const FILES = [
    'LICENSE',
    'README.md',
    'compile.mjs',
    'layout.mjs',
    'memory.mjs',
    'package.json',
    'recipe.mjs',
    'scarp-fallback.wasm',
    'scarp-simd.wasm',
    'scarp.d.ts',
    'scarp.mjs',
];

const USE = `import { load, PARTS, Recipe, RecipeError, ScarpError, type Noise, type Scarp, type Span }
    from 'scarp-noise';
const scarp: Scarp = await load({ memory: 1 << 20 });
const noise: Noise = { basis: 'simplex', seed: 7n, period: [4, 0, 4], warp: { octaves: 2 } };
const out = scarp.sample3(noise, Float32Array.of(1), Float32Array.of(2), Float32Array.of(3),
    { value: new Float32Array(1), dz: scarp.alloc(Float32Array, 1) });
const z: number = out.dz[0];
scarp.grid2(noise, { count: [2, 2], first: [-1n, 3] }, { value: new Float32Array(4) });
const fault: ScarpError | null = scarp.noiseCheck(noise, 2);
const recipe: Recipe = scarp.recipe('recipe 1\\nparam a = 1 [0, 2]\\nout o = a * x\\n');
recipe.set('a', 2).grid({ count: [2, 2] }, { value: new Float32Array(4) });
const lowest: number = recipe.params[0].lowest + recipe.range()[0];
const spans: Span[] = recipe.parts.map(({ span }) => span);
recipe.sample2(out.value, out.value, [out], { which: [PARTS + spans.length - 1] });
const words: readonly string[] | null = scarp.recipeFunctions[0].arguments[0].words;
const lines: (e: RecipeError) => number[] = (e) => e.errors.map(({ line }) => line);
// @ts-expect-error: there is no such word
const wrong: Noise = { basis: 'perlin' };
console.log(z, fault, lowest, lines, words, wrong);
`;

const folder = mkdtempSync(join(tmpdir(), 'scarp-pack-'));
try {
    const options = {
        encoding: 'utf8',
        env: { ...process.env, npm_config_cache: join(folder, 'cache') },
    };
    const [packed] = JSON.parse(
        execFileSync('npm', ['pack', '--json', '--offline', '--pack-destination', folder], options),
    );
    assert.deepEqual(packed.files.map(({ path }) => path).sort(), FILES.sort());
    console.log(`${packed.filename}: ${packed.size} bytes, ${packed.unpackedSize} unpacked`);

    const installed = join(folder, 'node_modules', 'scarp-noise');
    mkdirSync(installed, { recursive: true });
    execFileSync('tar', [
        '-xzf',
        join(folder, packed.filename),
        '-C',
        installed,
        '--strip-components=1',
    ]);
    writeFileSync(
        join(folder, 'use.mjs'),
        `import { load } from 'scarp-noise';
        const { value } = (await load()).sample2({}, Float32Array.of(0.5), Float32Array.of(0.25),
            { value: new Float32Array(1) });
        if (!(Math.abs(value[0]) <= 1)) throw new Error(String(value[0]));`,
    );
    execFileSync(process.execPath, ['use.mjs'], { cwd: folder });

    writeFileSync(join(folder, 'use.mts'), USE);
    const tsc = spawnSync(
        'tsc',
        [
            '--strict',
            '--noEmit',
            '--target',
            'es2022',
            '--module',
            'nodenext',
            '--types',
            '',
            'use.mts',
        ],
        { cwd: folder, encoding: 'utf8' },
    );
    console.log(tsc.error ? 'no tsc: the types were not checked' : 'tsc checked the types');
    assert.ok(tsc.error || tsc.status === 0, tsc.stdout);
} finally {
    rmSync(folder, { recursive: true });
}
