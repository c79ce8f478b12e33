// SPDX-License-Identifier: MIT
//
// Bundles the page: node build.mjs MODULES PAGE LANGUAGE RECIPE... takes libraries from the folder
// MODULES, where npm put them, and writes to the folder PAGE. Only what is needed at once is loaded
// at once. LANGUAGE is the document that has the formulas of functions.
import {readFileSync, readdirSync, rmSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {basename, dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const [modules, page, language, ...recipes] = process.argv.slice(2);
const {build} = createRequire(join(modules, "here.js"))("esbuild");
const folder = dirname(fileURLToPath(import.meta.url));

// The program's recipes, by name
const presets = Object.fromEntries(recipes.map(path =>
    [basename(path, ".recipe"), readFileSync(path, "utf8")]));

// What tables of the document tell of each function: [what, text] of each column that is filled in
const formulas = {};
let columns = [];
for (const line of readFileSync(language, "utf8").split("\n")) {
    const [first, ...cells] = line.startsWith("|") ? line.split("|").slice(1, -1).map(cell =>
        cell.replace(/[`*]/g, "").trim()) : [""];
    columns = first === "expression" ? cells : first === "" ? [] : columns;
    const rows = cells.map((text, i) => [columns[i], text]).filter(([what, text]) =>
        what && text && text !== "see scarp.h");
    for (const name of new Set([...first.matchAll(/(\w+)\(/g)].map(found => found[1]))) {
        const isNext = name in formulas;
        (formulas[name] ??= []).push(...rows.map(([what, text]) =>
            [isNext ? `${first}, ${what}` : what, text]));
    }
}

// Modules that are made here
const virtual = {presets, formulas};
const plugin = {
    name: "virtual",
    setup(on) {
        on.onResolve({filter: /^(presets|formulas)$/}, ({path}) => ({path, namespace: "virtual"}));
        on.onLoad({filter: /./, namespace: "virtual"}, ({path}) =>
            ({contents: `export default ${JSON.stringify(virtual[path])};`}));
    },
};

const sheets = readdirSync(folder, {recursive: true}).filter(name => name.endsWith(".css") &&
    !name.includes("node_modules"));
for (const name of readdirSync(page).filter(name => /\.(js|css)$/.test(name))) {
    rmSync(join(page, name)); // chunks have other names after a change
}
const {metafile} = await build({
    absWorkingDir: folder, outdir: page,
    entryPoints: ["main.js", "worker.js", "gpuworker.js", ...sheets],
    entryNames: "[name]", bundle: true, splitting: true, format: "esm", target: "es2022",
    minify: true, chunkNames: "[name]-[hash]", legalComments: "none", nodePaths: [modules],
    plugins: [plugin],
    alias: {"d3-transition": "./still.js", "d3-interpolate": "./still.js",
        "@codemirror/language": "./editor/plain.js", "@lezer/common": "./editor/plain.js"},
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
