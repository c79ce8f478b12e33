# SPDX-License-Identifier: MIT
"""The tables of the module for Python, and the functions of the chain rule that are methods."""
import re
import textwrap

from header import both
from tables import chain
from tables.arrays import arrays
from tables.text import replaced, wrapped

PATH = "src/bindings/python/scarp/_interface.py"
METHODS, STUBS = "src/bindings/python/scarp/_chain.py", "src/bindings/python/scarp/__init__.pyi"
# Operators, and what has other members than its input: Samples has these itself.
BY_HAND = ("scarp_add", "scarp_multiply", "scarp_divide", "scarp_abs", chain.SLOPE)
NAMES = {"a": "self", "b": "other", "m": "mask"}
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


def methods(header):
    """Functions of the chain rule, with their operands, and what they take where one is not
    given."""
    for f in chain.functions(header):
        if f.call not in BY_HAND:
            yield f, [NAMES[name] for name in f.inputs], chain.DEFAULTS.get(f.name, {})


def methods_as_code(header):
    """The content of _chain.py."""
    out = ["# SPDX-License-Identifier: MIT",
           '"""Functions of scarp.h that are methods of samples. Made by src/bindings/interface.py; do',
           'not change them by hand."""', "", "", "class Chain:",
           '    """Functions of samples, by the chain rule."""',
           "    __slots__ = ()"]
    for f, operands, given in methods(header):
        numbers = [name + ("=" + given[name] if name in given else "") for name in f.numbers]
        out += ["", "    def %s(%s):" % (f.name, ", ".join(operands + numbers))]
        out += wrapped('        """', f.about(NAMES) + '"""', "        ")
        given = ["%s=%s" % (name, name) for name in operands[1:]]
        scalars = ", ".join('("%s", %s)' % (name, name) for name in f.numbers)
        line = "        return self._chain(%s)" % ", ".join(
            ['"%s"' % f.call, "[%s]" % scalars] + given)
        out += textwrap.wrap(line, 100, subsequent_indent=" " * 27)
    return "\n".join(out) + "\n"


def methods_as_stubs(header):
    for f, operands, given in methods(header):
        arguments = operands[:1] + [name + ": Operand" for name in operands[1:]]
        arguments += [name + ": float" + (" = ..." if name in given else "") for name in f.numbers]
        yield "    def %s(%s) -> Samples: ..." % (f.name, ", ".join(arguments))


def made(header, read):
    """Files with what is made of the header: pairs of a path and a text"""
    yield PATH, table(header)
    yield METHODS, methods_as_code(header)
    text = replaced(STUBS, read(STUBS), "chain", methods_as_stubs(header))
    text = replaced(STUBS, text, "samples", (
        "    @property\n    def %s(self) -> Array: ..." % array.name
        for array in arrays(header, "scarp_samples")))
    for name in ("cells", "flow"):
        text = replaced(STUBS, text, name, (
            "    %s: %s" % (array.name, "NDArray[np.uint32]" if array.kind == "uint32_t" else "Array")
            for array in arrays(header, "scarp_" + name)))
    yield STUBS, text
