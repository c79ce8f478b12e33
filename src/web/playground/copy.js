// SPDX-License-Identifier: MIT
//
// What the page gives away: the recipe, the command line, and programs in C and JavaScript that
// write the heights and the hillshade of the picture.
import {numberText, wordsOf} from "./options.js";
import {presetOf} from "./state.js";

const double = number => /[.e]/.test(String(number)) ? String(number) : `${number}.0`;
const quoted = text => JSON.stringify(text).replaceAll("\\u", "\\\\u").replaceAll("??", "?\\?");

// Words in lines of at most 76 characters
function wrapped(list) {
    const lines = [list.slice(0, 2).join(" ")];
    for (let i = 2; i < list.length;) {
        const hasValue = i + 1 < list.length && !list[i + 1].startsWith("--");
        const word = hasValue ? `${list[i]} ${list[i + 1]}` : list[i], last = lines.length - 1;
        if (lines[last].length + word.length > 76) {
            lines.push(`    ${word}`);
        } else {
            lines[last] += ` ${word}`;
        }
        i += hasValue ? 2 : 1;
    }
    return lines.join(" \\\n") + "\n";
}

const ended = text => text.replace(/\n?$/, "\n");

export const asRecipe = ({state}) => ended(state.text);

// A word that no line of the text is
function endOf(text) {
    let end = "END";
    while (text.split("\n").includes(end)) {
        end += "_";
    }
    return end;
}

// A command that writes heights as floats, and the hillshade
export function asCommand({state: {text, given}}) {
    const preset = presetOf(text), end = endOf(text);
    const file = preset === null ? `cat > terrain.recipe <<'${end}'\n${ended(text)}${end}\n` : "";
    const source = preset === null ? ["--recipe", "terrain.recipe"] : ["--preset", preset];
    return file + wrapped(["scarp", "terrain", ...source, ...wordsOf(given), "--heights",
        "heights.r32", "--hillshade", "hillshade.pgm"]);
}

const lines = text => text.replace(/\n$/, "").split("\n");

// What copies have in common: the level of the sea, or null, and numbers of the raster
function partsOf({terrain, checked: {source, options}}) {
    terrain.open(source);
    const {hasSea, floor} = terrain.numbers();
    terrain.findSpread();
    terrain.setLook("alpine", options.azimuth, options.altitude);
    return {source, options, light: terrain.light, sea: hasSea ? floor : null,
        text: lines(source.text)};
}

export function asC(page, link) {
    const {source, options, light, sea, text} = partsOf(page);
    const [width, height] = options.size, [x, y] = options.origin, {step} = options;
    const float = number => `${double(Number(numberText(number)))}f`;
    return `/* A terrain of scarp's playground:
   ${link.replaceAll("*/", "* /")}

   cc -O2 -ffp-contract=off terrain.c -lscarp -o terrain && ./terrain

   Writes heights.r32, which is floats row by row from the top, and hillshade.pgm. */
#include <scarp.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = ${width}, HEIGHT = ${height}, COUNT = WIDTH * HEIGHT };

static const char text[] =
${text.map(line => `    ${quoted(line + "\n")}`).join("\n")};

static struct scarp_recipe recipe;
static float value[COUNT], dx[COUNT], dy[COUNT]; /* heights and their exact gradient */
static float nx[COUNT], ny[COUNT], nz[COUNT];
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
    struct scarp_recipe_error error = {.text = "the text is too long"};
    if (scarp_recipe_parse(text, strlen(text), &recipe, &error, 1, NULL) != SCARP_OK) {
        fprintf(stderr, "line %d: %s\\n", (int)error.line, error.text);
        return 1;
    }
    scarp_recipe_seed(&recipe, ${source.seed}u);
    const struct scarp_grid grid = {
        .origin = {${double(x)}, ${double(y)}},
        .step = {${double(step)}, ${double(-step)}},
        .first = {0, 1 - HEIGHT}, /* rows go down, y goes up */
        .count = {WIDTH, HEIGHT},
    };
    const struct scarp_samples terrain = {.value = value, .dx = dx, .dy = dy};
    const struct scarp_recipe_outputs outputs = {.out = &terrain, .count = 1};
    static uint64_t memory[32768];
    const struct scarp_scratch scratch = {.memory = memory, .size = sizeof memory};
    scarp_recipe_grid(&recipe, &grid, &outputs, &scratch);
${sea === null ? "" : `    for (int i = 0; i < COUNT; i++) {
        if (value[i] < ${float(sea)}) { /* the sea is flat */
            value[i] = ${float(sea)};
            dx[i] = dy[i] = 0.0f;
        }
    }
`}    scarp_normals(COUNT, dx, dy, ${float(options["z-factor"])}, nx, ny, nz);
    for (int i = 0; i < COUNT; i++) {
        const double light = ${double(light[0])} * nx[i] + ${double(light[1])} * ny[i] +
                             ${double(light[2])} * nz[i];
        pixels[i] = (unsigned char)(light > 0.0 ? light * 255.0 + 0.5 : 0.0);
    }
    return save("heights.r32", "", value, sizeof value[0]) ||
           save("hillshade.pgm", "P5\\n${width} ${height}\\n255\\n", pixels, 1);
}
`;
}

export function asJavaScript(page, link) {
    const {source, options, light, sea, text} = partsOf(page);
    const [width, height] = options.size, {origin, step} = options;
    return `// A terrain of scarp's playground:
// ${link}
//
// npm install scarp-noise && node terrain.mjs
//
// Writes heights.r32, which is floats row by row from the top, and hillshade.pgm.
import {writeFileSync} from "node:fs";
import {load} from "scarp-noise";

const text = [
${text.map(line => `    ${JSON.stringify(line)},`).join("\n")}
].join("\\n") + "\\n";

const width = ${width}, height = ${height}, count = width * height;
const scarp = await load();
const recipe = scarp.recipe(text);
recipe.seed = ${source.seed}n;
const value = new Float32Array(count), dx = new Float32Array(count), dy = new Float32Array(count);
recipe.grid({origin: [${origin.join(", ")}], step: [${step}, ${-step}], first: [0, 1 - height],
    count: [width, height]}, {value, dx, dy}); // rows go down, y goes up
recipe.free();
${sea === null ? "" : `for (let i = 0; i < count; i++) {
    if (value[i] < ${numberText(sea)}) { // the sea is flat
        value[i] = ${numberText(sea)};
        dx[i] = dy[i] = 0;
    }
}
`}const [nx, ny, nz] = [0, 1, 2].map(() => new Float32Array(count));
scarp.normals(dx, dy, ${numberText(options["z-factor"])}, {nx, ny, nz});
const pixels = Uint8Array.from(nx, (_, i) => {
    const light = ${light[0]} * nx[i] + ${light[1]} * ny[i] + ${light[2]} * nz[i];
    return light > 0 ? Math.trunc(light * 255 + 0.5) : 0;
});
const heights = new DataView(new ArrayBuffer(4 * count));
value.forEach((number, i) => heights.setFloat32(4 * i, number, true));
writeFileSync("heights.r32", heights);
writeFileSync("hillshade.pgm", Buffer.concat([Buffer.from(\`P5\\n\${width} \${height}\\n255\\n\`),
    pixels]));
`;
}
