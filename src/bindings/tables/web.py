# SPDX-License-Identifier: MIT
"""The tables of the npm package, for pointers of 4 bytes."""
import re
import textwrap

PATH = "src/web/interface.mjs"
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
