// SPDX-License-Identifier: MIT
//
// "Copy as C": a program that writes the heights and the hillshade of the picture.
import {floatText, isFloat, members, noises} from "./copy.js";
import {lightOf} from "./shade.js";

const MEMBERS = {ofOctaves: "of_octaves"}; // those that the header spells otherwise
const ENUMS = ["basis", "fade", "fractal"];

function float(number) {
    const text = floatText(number);
    return `${/[.e]/.test(text) ? text : `${text}.0`}f`;
}

function double(number) {
    const text = String(number);
    return /[.e]/.test(text) ? text : `${text}.0`;
}

const enumerator = word => `SCARP_${word.toUpperCase().replace("-", "_")}`;

function memberText(name, value) {
    if (ENUMS.includes(name)) {
        return enumerator(value);
    }
    switch (name) {
    case "rotate": return "1";
    case "seed": return `${value}u`;
    case "period": return `{${value.slice(0, 2).join(", ")}}`;
    default: return isFloat(name) ? float(value) : double(value);
    }
}

function noiseText(name, noise, warp) {
    const list = members(noise).map(([member, value]) =>
        `.${MEMBERS[member] ?? member} = ${memberText(member, value)}`);
    if (warp) {
        list.push(".warp = &warp");
    }
    if (list.length === 0) {
        list.push(".seed = 0"); // ISO C has no empty initialiser
    }
    const lines = [];
    for (const text of list) {
        const last = lines.length - 1;
        if (last < 0 || lines[last].length + text.length > 84) {
            lines.push(text);
        } else {
            lines[last] += `, ${text}`;
        }
    }
    return `    const struct scarp_noise ${name} = {\n${lines.map(line =>
        `        ${line},\n`).join("")}    };\n`;
}

function gridText(raster, ground) {
    const [x, y] = raster.origin, isAligned = ground.isStretched && ground.isAligned;
    const grid = (name, originY, step) => `    const struct scarp_grid ${name} = {
        .origin = {${double(x)}, ${double(originY)}},
        .step = {${double(raster.step)}, ${double(step)}},
        .first = {0, 1 - HEIGHT}, /* rows go down, y goes up */
        .count = {WIDTH, HEIGHT},
    };\n`;
    const across = ground.across[1], isNeeded = !isAligned || ground.mask || ground.base;
    return (isNeeded ? grid("grid", y, -raster.step) : "") +
        (isAligned ? grid("stretched", y * across, -raster.step * across) : "");
}

// The noise across the wind
function stretchedText(raster, ground) {
    const [ax, ay, bx, by] = [...ground.along, ...ground.across].map(n => float(Math.fround(n)));
    const turn = `    for (int i = 0; i < COUNT; i++) { /* slopes along x and y */
        const float u = dx[i], v = dy[i];
        dx[i] = ${ax} * u + ${bx} * v;
        dy[i] = ${ay} * u + ${by} * v;
    }\n`;
    if (ground.isAligned) {
        return `    scarp_grid2(&noise, &stretched, &terrain);\n${turn}`;
    }
    const [a, b] = ground.along.map(double), [c, d] = ground.across.map(double);
    return `    for (int i = 0; i < COUNT; i++) { /* along the wind, and across it */
        const double x = grid.origin[0] + grid.step[0] * (i % WIDTH);
        const double y = grid.origin[1] + grid.step[1] * (i / WIDTH + 1 - HEIGHT);
        along[i] = ${a} * x + ${b} * y;
        across[i] = ${c} * x + ${d} * y;
    }
    scarp_sample2_f64(&noise, COUNT, along, across, &terrain);\n${turn}`;
}

function combineText(ground) {
    let text = "";
    if (ground.rim < Infinity) {
        const twice = float(Math.fround(2 * ground.rim));
        text += `    scarp_affine(COUNT, &terrain, -1.0f, ${twice}, &other);
    scarp_min(COUNT, &terrain, &other, &terrain); /* craters */\n`;
    }
    if (ground.mask) {
        const [from, to] = ground.maskBand.map(float);
        text += `    scarp_grid2(&mask, &grid, &other);
    scarp_smoothstep(COUNT, &other, ${from}, ${to}, &other);
    scarp_multiply(COUNT, &terrain, &other, &terrain);\n`;
    }
    if (ground.base) {
        text += `    scarp_grid2(&base, &grid, &other);
    scarp_add(COUNT, &terrain, &other, &terrain);\n`;
    }
    if (ground.terraces !== 0) {
        const numbers = [ground.terraces, ground.riser, ground.strength].map(float).join(", ");
        text += `    scarp_terrace(COUNT, &terrain, ${numbers}, &terrain);\n`;
    }
    if (ground.floor > ground.lowest || ground.ceiling < ground.highest) {
        const [low, high] = [ground.floor, ground.ceiling].map(float);
        text += `    scarp_clamp(COUNT, &terrain, ${low}, ${high}, &terrain);\n`;
    }
    return text;
}

// `ground` is that of makeGround, `link` the page.
export function asC(terrain, ground, link) {
    const {raster} = terrain, hasOther = ground.rim < Infinity || ground.mask || ground.base;
    const isTurned = ground.isStretched && !ground.isAligned;
    const light = lightOf(terrain.azimuth, terrain.altitude);
    const scale = Math.fround(ground.heightScale);
    const shade = Math.fround(scale * terrain.zFactor);
    return `/* A terrain of scarp's playground:
   ${link.replaceAll("*/", "* /")}

   cc -O2 -ffp-contract=off terrain.c -lscarp -o terrain && ./terrain

   Writes heights.r32, which is floats row by row from the top, and hillshade.pgm. */
#include <scarp.h>
#include <stdio.h>

enum { WIDTH = ${raster.width}, HEIGHT = ${raster.height}, COUNT = WIDTH * HEIGHT };

static float value[COUNT], dx[COUNT], dy[COUNT]; /* the terrain and its exact gradient */
${hasOther ? "static float other_value[COUNT], other_dx[COUNT], other_dy[COUNT];\n" : ""}${
    isTurned ? "static double along[COUNT], across[COUNT];\n" : ""
}static float nx[COUNT], ny[COUNT], nz[COUNT];
static unsigned char pixels[COUNT];

static int save(const char *name, const char *head, const void *data, size_t size)
{
    FILE *const file = fopen(name, "wb");
    if (file == NULL) {
        return 1;
    }
    const int failed = fputs(head, file) < 0 || fwrite(data, size, COUNT, file) != COUNT;
    return fclose(file) != 0 || failed;
}

int main(void)
{
${noises(terrain).map(([name, noise]) => noiseText(name, noise, name === "noise" &&
        terrain.warp)).join("")}${gridText(raster, ground)
}    const struct scarp_samples terrain = {.value = value, .dx = dx, .dy = dy};
${hasOther ? `    const struct scarp_samples other = {
        .value = other_value, .dx = other_dx, .dy = other_dy};\n` : ""}
${ground.isStretched ? stretchedText(raster, ground)
        : "    scarp_grid2(&noise, &grid, &terrain);\n"}${combineText(ground)}
    scarp_normals(COUNT, dx, dy, ${float(shade)}, nx, ny, nz);
    for (int i = 0; i < COUNT; i++) {
        const double light = ${double(light[0])} * nx[i] + ${double(light[1])} * ny[i] +
                             ${double(light[2])} * nz[i];
        pixels[i] = (unsigned char)(light > 0.0 ? light * 255.0 + 0.5 : 0.0);
        value[i] *= ${float(scale)}; /* from here on, heights */
    }
    return save("heights.r32", "", value, sizeof value[0]) ||
           save("hillshade.pgm", "P5\\n${raster.width} ${raster.height}\\n255\\n", pixels, 1);
}
`;
}
