# SPDX-License-Identifier: MIT
"""The tables of the module for Python."""
import re

from header import both

PATH = "src/bindings/python/scarp/_interface.py"
CODES = {"char": "i1", "unsigned char": "u1", "int": "i4", "int32_t": "i4", "uint32_t": "u4",
         "float": "f4", "int64_t": "i8", "uint64_t": "u8", "double": "f8", "size_t": "size"}


def code(kind):
    """The type as the tables of Python spell it."""
    if "*" in kind:
        return "text" if kind == "const char *" else "pointer"
    kind = re.sub(r"^const ", "", kind)
    if kind.startswith("enum "):
        return "i4"
    return kind[7:] if kind.startswith("struct ") else CODES[kind]


def table(header):
    """The content of _interface.py."""
    def dims(m):
        return tuple(both(*pair) for pair in zip(m[4][1], m[8][1]))

    out = ["# SPDX-License-Identifier: MIT",
           '"""Tables of scarp.h. Made by src/bindings/interface.py; do not change them by hand.',
           "", "Where the sizes of pointers matter, a number is two: for 4 bytes, and for 8.",
           '"""',
           "VERSION = %r" % header.version, "", "CONSTANTS = {"]
    out += ["    %r: %d," % pair for pair in header.constants.items()] + ["}", "", "ENUMS = {"]
    for name, values in header.enums.items():
        out += ["    %r: {" % name] + ["        %r: %d," % pair for pair in values.items()]
        out += ["    },"]
    out += ["}", "", "# size, then name, type and lengths of each member", "STRUCTURES = {"]
    for name, s in header.structures.items():
        out += ["    %r: (%r, (" % (name, both(s[4][0], s[8][0]))]
        out += ["        (%r, %r, %r)," % (m["name"], code(m["type"]), dims(m))
                for m in s["members"]] + ["    )),"]
    out += ["}", "", "# what 0 stands for, where that is another number", "DEFAULTS = {"]
    for name, s in header.structures.items():
        given = {m["name"]: m["default"] for m in s["members"] if m["default"] is not None}
        if given:
            out += ["    %r: {" % name] + ["        %r: %r," % pair for pair in given.items()]
            out += ["    },"]
    out += ["}", "", "# result, then arguments", "FUNCTIONS = {"]
    for name, (returns, arguments) in header.functions.items():
        result = "text" if returns == "const char *" else code(returns)
        kinds = ["pointer" if code(kind) == "text" else code(kind) for _, kind in arguments]
        out += ["    %r: (%r, (" % (name, result)]
        line = "       "
        for kind in kinds:
            if len(line) + len(kind) + 4 > 96:
                out, line = out + [line], "       "
            line += " %r," % kind
        out += ([line] if line.strip() else []) + ["    )),"]
    return "\n".join(out + ["}"]) + "\n"
