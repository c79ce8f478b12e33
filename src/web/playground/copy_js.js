// SPDX-License-Identifier: MIT
//
// "Copy as JavaScript": a module that computes the heights and the hillshade of the picture.
import {floatText, isFloat, members, noises} from "./copy.js";
import {lightOf} from "./shade.js";

function memberText(name, value) {
    switch (typeof value) {
    case "string": return `"${value}"`;
    case "bigint": return `${value}n`;
    case "number": return isFloat(name) ? floatText(value) : String(value);
    default: return JSON.stringify(value);
    }
}

function noiseText(name, noise, hasWarp) {
    const list = members(noise).map(([member, value]) => `${member}: ${memberText(member, value)}`);
    if (hasWarp) {
        list.push("warp");
    }
    const lines = [""];
    for (const text of list) {
        const last = lines.length - 1, line = lines[last];
        if (line.length + text.length > 84) {
            lines.push(text);
        } else {
            lines[last] = line === "" ? text : `${line}, ${text}`;
        }
    }
    return `const ${name} = {${lines.join(",\n    ")}};\n`;
}

const numbers = list => `[${list.join(", ")}]`;

function stretchedText(ground) {
    const times = (n, slope) => `f32(f32(${floatText(Math.fround(n))}) * ${slope})`;
    const turn = `for (let i = 0; i < count; i++) { // slopes along x and y
    const u = terrain.dx[i], v = terrain.dy[i];
    terrain.dx[i] = ${times(ground.along[0], "u")} + ${times(ground.across[0], "v")};
    terrain.dy[i] = ${times(ground.along[1], "u")} + ${times(ground.across[1], "v")};
}\n`;
    if (ground.isAligned) {
        return `const times = ${ground.across[1]}; // across the wind
scarp.grid2(noise, {...grid, origin: [grid.origin[0], grid.origin[1] * times],
    step: [grid.step[0], grid.step[1] * times]}, terrain);\n${turn}`;
    }
    const [a, b] = ground.along, [c, d] = ground.across;
    return `const along = new Float64Array(count), across = new Float64Array(count);
for (let i = 0; i < count; i++) { // along the wind, and across it
    const x = grid.origin[0] + grid.step[0] * (i % width);
    const y = grid.origin[1] + grid.step[1] * (Math.floor(i / width) + 1 - height);
    along[i] = ${a} * x + ${b} * y;
    across[i] = ${c} * x + ${d} * y;
}
scarp.sample2(noise, along, across, terrain);\n${turn}`;
}

function combineText(ground) {
    let text = "";
    if (ground.rim < Infinity) {
        text += `scarp.affine(terrain, -1, ${floatText(Math.fround(2 * ground.rim))}, other);
scarp.min(terrain, other, terrain); // craters\n`;
    }
    if (ground.mask) {
        text += `scarp.grid2(mask, grid, other);
scarp.smoothstep(other, ${ground.maskBand.map(floatText).join(", ")}, other);
scarp.multiply(terrain, other, terrain);\n`;
    }
    if (ground.base) {
        text += `scarp.grid2(base, grid, other);\nscarp.add(terrain, other, terrain);\n`;
    }
    if (ground.terraces !== 0) {
        const list = [ground.terraces, ground.riser, ground.strength].map(floatText).join(", ");
        text += `scarp.terrace(terrain, ${list}, terrain);\n`;
    }
    if (ground.floor > ground.lowest || ground.ceiling < ground.highest) {
        const list = [ground.floor, ground.ceiling].map(floatText).join(", ");
        text += `scarp.clamp(terrain, ${list}, terrain);\n`;
    }
    return text;
}

// `ground` is that of makeGround, `link` the page.
export function asJavaScript(terrain, ground, link) {
    const {raster} = terrain, light = lightOf(terrain.azimuth, terrain.altitude);
    const hasOther = ground.rim < Infinity || ground.mask || ground.base;
    const shade = floatText(Math.fround(ground.heightScale * terrain.zFactor));
    return `// A terrain of scarp's playground:
// ${link}
//
// npm install scarp-noise && node terrain.mjs
//
// Writes heights.r32, which is floats row by row from the top, and hillshade.pgm.
import {writeFile} from "node:fs/promises";
import {load} from "scarp-noise";

const scarp = await load();
const width = ${raster.width}, height = ${raster.height}, count = width * height;
const f32 = Math.fround, array = () => new Float32Array(count);

${noises(terrain).map(([name, noise]) => noiseText(name, noise, name === "noise" &&
        terrain.warp)).join("")}const grid = {origin: ${numbers(raster.origin)}, step: ${
    numbers([raster.step, -raster.step])},
    first: [0, 1 - height], count: [width, height]}; // rows go down, y goes up

const terrain = {value: array(), dx: array(), dy: array()}; // with its exact gradient
${hasOther ? "const other = {value: array(), dx: array(), dy: array()};\n" : ""}${
    ground.isStretched ? stretchedText(ground) : "scarp.grid2(noise, grid, terrain);\n"}${
    combineText(ground)}
const normals = {nx: array(), ny: array(), nz: array()};
scarp.normals(terrain.dx, terrain.dy, ${shade}, normals);
const heights = terrain.value.map(value => f32(${floatText(ground.heightScale)}) * value);
const {nx, ny, nz} = normals, pixels = new Uint8Array(count);
for (let i = 0; i < count; i++) {
    const light = ${light[0]} * nx[i] + ${light[1]} * ny[i] + ${light[2]} * nz[i];
    pixels[i] = light > 0 ? light * 255 + 0.5 : 0;
}
await writeFile("heights.r32", heights);
await writeFile("hillshade.pgm", Buffer.concat([
    Buffer.from(\`P5\\n\${width} \${height}\\n255\\n\`), pixels]));
`;
}
