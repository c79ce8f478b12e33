// SPDX-License-Identifier: MIT
//
// Bundles the page: node build.mjs MODULES PAGE RECIPE... takes libraries from the folder MODULES,
// where npm put them, and writes to the folder PAGE. Only what is needed at once is loaded at once.
import {readFileSync, readdirSync, rmSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {basename, dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const [modules, page, ...recipes] = process.argv.slice(2);
const {build} = createRequire(join(modules, "here.js"))("esbuild");
const folder = dirname(fileURLToPath(import.meta.url));

// The program's recipes, by name
const presets = Object.fromEntries(recipes.map(path =>
    [basename(path, ".recipe"), readFileSync(path, "utf8")]));
const plugin = {
    name: "presets",
    setup(on) {
        on.onResolve({filter: /^presets$/}, ({path}) => ({path, namespace: "presets"}));
        on.onLoad({filter: /./, namespace: "presets"}, () =>
            ({contents: `export default ${JSON.stringify(presets)};`}));
    },
};

const sheets = readdirSync(folder, {recursive: true}).filter(name => name.endsWith(".css") &&
    !name.includes("node_modules"));
for (const name of readdirSync(page).filter(name => /\.(js|css)$/.test(name))) {
    rmSync(join(page, name)); // chunks have other names after a change
}
const {metafile} = await build({
    absWorkingDir: folder, entryPoints: ["main.js", "worker.js", ...sheets], outdir: page,
    entryNames: "[name]", bundle: true, splitting: true, format: "esm", target: "es2022", minify: true,
    chunkNames: "[name]-[hash]", legalComments: "none", nodePaths: [modules], plugins: [plugin],
    alias: {"d3-transition": "./still.js", "d3-interpolate": "./still.js"},
    external: ["node:*"], metafile: true, logLevel: "warning",
});

// Licences of the libraries that are in the bundle
const names = new Set(Object.values(metafile.outputs).flatMap(({inputs}) =>
    Object.entries(inputs).filter(([, {bytesInOutput}]) => bytesInOutput > 0).map(([path]) =>
        /node_modules\/((@[^/]+\/)?[^/]+)\//.exec(path)?.[1])).filter(Boolean));
const texts = [...names].sort().map(name => {
    const at = join(modules, name), {version} = JSON.parse(readFileSync(join(at, "package.json")));
    const file = readdirSync(at).find(each => /^licen[cs]e/i.test(each));
    return `${name} ${version}\n\n${readFileSync(join(at, file), "utf8").trim()}\n`;
});
writeFileSync(join(page, "LICENSES.txt"), texts.join(`\n${"-".repeat(72)}\n\n`));
