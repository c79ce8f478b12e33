// SPDX-License-Identifier: MIT
//
// npm pack makes a package that has what it needs and nothing else, and that can be used by name:
// in JavaScript, and with its types if there is a tsc. All that its package.json names is there.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const FILES = [
    'LICENSE',
    'NOTICE',
    'README.md',
    'compile.mjs',
    'interface.mjs',
    'layout.mjs',
    'memory.mjs',
    'package.json',
    'recipe.mjs',
    'scarp-fallback.wasm',
    'scarp-simd.wasm',
    'scarp.d.ts',
    'scarp.glsl',
    'scarp.hlsl',
    'scarp.mjs',
    'scarp.wgsl',
    'shader.d.ts',
];

const USE = `import { load, PARTS, Recipe, RecipeError, ScarpError, type Noise, type Scarp, type Span }
    from 'scarp-noise';
import wgsl from 'scarp-noise/scarp.wgsl';
import glsl from 'scarp-noise/scarp.glsl';
import hlsl from 'scarp-noise/scarp.hlsl';
const texts: string[] = [wgsl, glsl, hlsl];
const scarp: Scarp = await load({ memory: 1 << 20 });
const noise: Noise = { basis: 'simplex', seed: 7n, period: [4, 0, 4], warp: { octaves: 2 } };
const out = scarp.sample3(noise, Float32Array.of(1), Float32Array.of(2), Float32Array.of(3),
    { value: new Float32Array(1), dz: scarp.alloc(Float32Array, 1) });
const z: number = out.dz[0];
scarp.grid2(noise, { count: [2, 2], first: [-1n, 3] }, { value: new Float32Array(4) });
const fault: ScarpError | null = scarp.noiseCheck(noise, 2);
const recipe: Recipe = scarp.recipe('recipe 1\\nparam a = 1 [0, 2]\\nout o = a * x\\n');
recipe.set('a', 2).grid({ count: [2, 2] }, { value: new Float32Array(4) });
const shader: string = recipe.shader('wgsl', '', { order: 2 });
const bytes: Uint8Array = recipe.uniforms(), answers: Uint32Array = recipe.answers(0);
const lowest: number = recipe.params[0].lowest + recipe.range()[0];
const spans: Span[] = recipe.parts.map(({ span }) => span);
recipe.sample2(out.value, out.value, [out], { which: [PARTS + spans.length - 1] });
const words: readonly string[] | null = scarp.recipeFunctions[0].arguments[0].words;
const lines: (e: RecipeError) => number[] = (e) => e.errors.map(({ line }) => line);
// @ts-expect-error: there is no such word
const wrong: Noise = { basis: 'perlin' };
console.log(z, fault, lowest, lines, words, wrong, texts, shader, bytes, answers);
`;

// The files that a package.json names: in exports, types and lists, and in the words of scripts
function named({ main, types, exports, files, scripts = {} }) {
    const leaves = (node) =>
        typeof node === 'string' ? [node] : Object.values(node ?? {}).flatMap(leaves);
    const words = Object.values(scripts).flatMap((script) => script.split(/\s+/));
    const paths = words.filter((word) => /[./]/.test(word) && !word.startsWith('-'));
    return [main, types, ...leaves(exports), ...files, ...paths].map((path) =>
        path.replace(/^\.\//, ''),
    );
}

// Those that are not among the packed files; a star stands for any part of a name.
function missing(manifest, packed) {
    return named(manifest).filter((path) => {
        const parts = path.split('*').map((part) => part.replace(/[.+?()[\]{}|^$\\]/g, '\\$&'));
        const pattern = new RegExp(`^${parts.join('[^/]*')}$`);
        return !packed.some((file) => pattern.test(file));
    });
}

function checkManifest(manifest, packed) {
    assert.deepEqual(missing(manifest, packed), []);
    const wrong = [
        [{ ...manifest, scripts: { test: 'node --test test/*.test.mjs' } }, 'test/*.test.mjs'],
        [{ ...manifest, types: './gone.d.ts' }, 'gone.d.ts'],
        [{ ...manifest, main: './gone.mjs' }, 'gone.mjs'],
        [{ ...manifest, files: [...manifest.files, 'gone.wgsl'] }, 'gone.wgsl'],
        [{ ...manifest, exports: { './a': { types: './scarp.d.ts', default: './a.js' } } }, 'a.js'],
    ];
    for (const [bad, path] of wrong) {
        assert.deepEqual(missing(bad, packed), [path], 'this test notices what is missing');
    }
    // The address is the builder's to give; without one there is none.
    const url = process.env.SCARP_REPOSITORY;
    assert.deepEqual(manifest.repository, url ? { type: 'git', url } : undefined);
}

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
    checkManifest(
        JSON.parse(readFileSync(join(installed, 'package.json'), 'utf8')),
        packed.files.map(({ path }) => path),
    );

    writeFileSync(
        join(folder, 'use.mjs'),
        `import { load } from 'scarp-noise';
        const { value } = (await load()).sample2({}, Float32Array.of(0.5), Float32Array.of(0.25),
            { value: new Float32Array(1) });
        if (!(Math.abs(value[0]) <= 1)) throw new Error(String(value[0]));
        const { readFile } = await import('node:fs/promises');
        for (const language of ['wgsl', 'glsl', 'hlsl']) {
            const url = import.meta.resolve('scarp-noise/scarp.' + language);
            const text = await readFile(new URL(url), 'utf8');
            if (!text.includes('scarp_sample2')) throw new Error(language);
        }`,
    );
    execFileSync(process.execPath, ['use.mjs'], { cwd: folder });

    writeFileSync(join(folder, 'use.mts'), USE);
    const compilerOptions = { strict: true, noEmit: true, target: 'es2022', module: 'nodenext' };
    writeFileSync(
        join(folder, 'tsconfig.json'),
        JSON.stringify({ compilerOptions: { ...compilerOptions, types: [] }, files: ['use.mts'] }),
    );
    const tsc = spawnSync('tsc', ['-p', '.'], { cwd: folder, encoding: 'utf8' });
    console.log(tsc.error ? 'no tsc: the types were not checked' : 'tsc checked the types');
    assert.ok(tsc.error || tsc.status === 0, tsc.stdout);
} finally {
    rmSync(folder, { recursive: true });
}
