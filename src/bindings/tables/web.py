# SPDX-License-Identifier: MIT
"""The tables of the npm package, for pointers of 4 bytes, and the functions of the chain rule."""
import re
import textwrap

from tables import chain
from tables.arrays import arrays
from tables.text import replaced, wrapped

PATH = "src/web/interface.mjs"
METHODS, TYPES, TESTED = "src/web/scarp.mjs", "src/web/scarp.d.ts", "src/web/test/chain.mjs"
ARRAYS = (("Samples", "scarp_samples", "Arrays of values and of their derivatives. Members that are "
           "left out are not computed."),
          ("Cells", "scarp_cells", "What is near a point: distances, the cell's number, the "
           "feature's position, gradients."),
          ("Flow", "scarp_flow", "A velocity and its Jacobian: `vxy` is the derivative of `vx` with "
           "respect to y."),
          ("Partials", "scarp_partials", "A function of a, or of a and b, at each point, with its "
           "partial derivatives."))
WORDS = (("scarp_basis", "Basis",
          "Perlin's gradient noise, value noise, simplex noise, and five kinds of cellular noise."),
         ("scarp_fade", "Fade", "The blend between lattice points of gradient and value noise."),
         ("scarp_fractal", "Fractal", "How octaves are summed."))
TYPED = ("scarp_noise",)  # structures that are written member by member

FIRST = """\
// SPDX-License-Identifier: MIT
//
// Tables of scarp.h, for pointers of 4 bytes. Made by src/bindings/interface.py; do not change them
// by hand. Of a structure: its SIZE in bytes, and the offset of each member.
"""


def literal(name, pairs):
    """An object of these pairs, on lines of at most 100 columns."""
    text = ", ".join("%s:\0%s" % pair for pair in pairs)  # lines do not break at \0
    lines = [line.replace("\0", " ") for line in textwrap.wrap(text, 95)]
    if len(lines) == 1 and len(name) + len(text) < 76:
        return "export const %s = { %s };" % (name, lines[0])
    return "export const %s = {\n    %s,\n};" % (name, "\n    ".join(lines))


def kind(member):
    text = re.sub(r"^const ", "", member["type"])
    if "*" in text:
        return "pointer"
    text = "enum" if text.startswith("enum ") else text
    return text + "".join("[%d]" % n for n in member[4][1])


def table(header):
    """The content of interface.mjs."""
    out = [FIRST]
    out += ["export const %s = %d;" % pair for pair in header.constants.items()] + [""]
    out += [literal(name, values.items()) for name, values in header.enums.items()]
    for name, structure in header.structures.items():
        members = [m for m in structure["members"] if not m["name"].startswith("spare")]
        out += ["", literal(name, [("SIZE", structure[4][0])] +
                            [(m["name"], m[4][0]) for m in members])]
        if name in TYPED:
            out += [literal(name + "_types", [(m["name"], "'%s'" % kind(m)) for m in members])]
    return "\n".join(out) + "\n"


def methods(header):
    for f in chain.functions(header):
        numbers = "{ %s }" % ", ".join(f.numbers) if f.numbers else "{}"
        yield "    %s(%s) {" % (f.camel, ", ".join(f.inputs + f.numbers + ["out"]))
        yield "        return this.#chain('%s', { %s }, %s, out);" % (
            f.name, ", ".join(f.inputs), numbers)
        yield "    }"


def comment(indent, text):
    lines = wrapped(indent + "/** ", text + " */", indent + " * ")
    if len(lines) > 1:
        return [indent + "/**"] + wrapped(indent + " * ", text, indent + " * ") + [indent + " */"]
    return lines


def interfaces(header):
    """The objects of arrays"""
    out = []
    for name, structure, about in ARRAYS:
        out += ["", *comment("", about), "export interface %s {" % name]
        for array in arrays(header, structure):
            kind = "Uint32Array" if array.kind == "uint32_t" else "Float32Array"
            out += comment("    ", array.about + ".") + ["    %s?: %s | null;" % (array.name, kind)]
        out.append("}")
    return out[1:]


def types(header):
    for f in chain.functions(header):
        parameters = ([name + ": Samples" for name in f.inputs] +
                      [name + ": number" for name in f.numbers] + ["out: T"])
        line = "    %s<T extends Samples>(%s): T;" % (f.camel, ", ".join(parameters))
        if len(line) > 100:
            line = "    %s<T extends Samples>(\n%s\n    ): T;" % (
                f.camel, "\n".join("        %s," % each for each in parameters))
        yield from comment("    ", f.about()) + [line]


def words(header):
    """The unions of words that enumerators have."""
    for enum, name, comment in WORDS:
        yield "/** %s */" % comment
        given = ["'%s'" % text[6:].lower().replace("_", "-") for text in header.enums[enum]]
        line = "export type %s = %s;" % (name, " | ".join(given))
        if len(line) > 100:
            line = "    " + " | ".join(given) + ";"
            line = "export type %s =\n" % name + (
                line if len(line) <= 100 else "\n".join("    | " + each for each in given) + ";")
        yield line


def tested(header):
    """The content of test/chain.mjs."""
    out = ["// SPDX-License-Identifier: MIT", "//",
           "// The calls of tests/bindings/chain.h: the names of samples, and numbers. Made by",
           "// src/bindings/interface.py; do not change it by hand.", "export const CHAIN = {"]
    out += ["    %s: [[%s], [%s]]," % (
        f.camel, ", ".join(("'a'", "'b'", "'a'")[:len(f.inputs)]),
        ", ".join(map(str, f.given.values())))
        for f in chain.functions(header) if f.call != chain.SLOPE]
    return "\n".join(out + ["};"]) + "\n"


def made(header, read):
    """Files with what is made of the header: pairs of a path and a text"""
    yield PATH, table(header)
    yield METHODS, replaced(METHODS, read(METHODS), "chain", methods(header))
    text = replaced(TYPES, read(TYPES), "words", words(header))
    text = replaced(TYPES, text, "arrays", interfaces(header))
    yield TYPES, replaced(TYPES, text, "chain", types(header))
    yield TESTED, tested(header)
