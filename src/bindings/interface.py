#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Describes include/scarp.h for bindings of other languages: enumerators, structures with the
offsets of their members, and calls. The header is the only source; what is written here is made
of it.

    interface.py            writes interface.json and the tables of bindings
    interface.py --check    says what of that is not current, and where src/web/layout.mjs differs
    interface.py --asserts  prints a C file that compiles if the offsets are those of its compiler

Offsets are given for pointers of 4 bytes (WebAssembly) and of 8 bytes, where doubles lie at
multiples of 8 bytes. They do not on 32-bit x86, so some offsets differ there.
"""
import json
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
HEADER = os.path.join(ROOT, "include", "scarp.h")
LAYOUT = os.path.join(ROOT, "src", "web", "layout.mjs")
DESCRIPTION = os.path.join(HERE, "interface.json")
PYTHON = os.path.join(HERE, "python", "scarp", "_interface.py")

SIZES = {"char": 1, "unsigned char": 1, "int": 4, "int32_t": 4, "uint32_t": 4, "float": 4,
         "int64_t": 8, "uint64_t": 8, "double": 8}
CODES = {"char": "i1", "unsigned char": "u1", "int": "i4", "int32_t": "i4", "uint32_t": "u4",
         "float": "f4", "int64_t": "i8", "uint64_t": "u8", "double": "f8", "size_t": "size"}


def fail(message):
    sys.exit("interface.py: " + message)


def plain(text):
    """The header without comments, directives and the words of C++."""
    text = re.sub(r"(?s)/\*.*?\*/", " ", text)
    text = re.sub(r"(?m)^[ \t]*#(?:.*\\\n)*.*$", "", text)
    return text.replace('extern "C" {', "")


def declared(declaration):
    """`const float *x, *y` as pairs of a name and a type; an array is (name, type, dimensions)."""
    # A default, as C++ has it: `= 1`, `{1}`, or a macro behind the name.
    declaration = re.sub(r"=[^,]*|\{[^}]*\}|\bSCARP_[A-Z_]+\b(\([^)]*\))?", "", declaration)
    declaration = " ".join(declaration.split())
    match = re.match(r"((?:const |unsigned )*(?:struct |enum )?\w+) ?(.*)$", declaration)
    if not match:
        fail("cannot read the declaration: " + declaration)
    base, found = match.group(1), []
    for part in match.group(2).split(","):
        part = re.match(r"\s*((?:\*|const\b|\s)*)(\w+)\s*((?:\[[^]]*\])*)\s*$", part)
        if not part:
            fail("cannot read a part of: " + declaration)
        stars, name, dimensions = part.groups()
        stars = stars.replace(" ", "").replace("const", " const ").rstrip()
        found.append((name, base + (" " + stars if stars else ""),
                      re.findall(r"\[([^]]*)\]", dimensions)))
    return found


def length(expression, pointer):
    """The number of elements that an array says, where a pointer has so many bytes."""
    text = re.sub(r"sizeof\((void \*|size_t)\)", str(pointer), expression)
    if not re.fullmatch(r"[0-9+\-*/() ]+", text):
        fail("cannot compute [%s]" % expression)
    return eval(text.replace("/", "//"))  # digits and operators alone


class Header:
    """What the header declares."""

    def __init__(self, text):
        self.version = ".".join(re.findall(
            r"#define SCARP_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text))
        self.constants = {name: int(value) for name, value in re.findall(
            r"(?m)^#define (SCARP_\w+) \(?(-?\d+)\)?(?: /\*.*)?$", text)}
        text = plain(text)
        self.enums, self.structures, self.functions = {}, {}, {}
        for name, body in re.findall(r"\benum (\w+) \{([^}]*)\};", text):
            self.enums[name] = self.enumerators(body)
        for name, body in re.findall(r"(?ms)^struct (\w+) \{\n(.*?)^\};", text):
            self.structures[name] = self.structure(body)
        for returns, name, arguments in re.findall(
                r"SCARP_API ([^;()]*?)(\w+)\(([^)]*)\)[^;]*;", text):
            self.functions[name] = (" ".join(returns.split()), [
                self.argument(*argument) for text_of in arguments.split(",")
                if text_of.strip() != "void" for argument in declared(text_of)])

    @staticmethod
    def enumerators(body):
        found, value = {}, 0
        for part in filter(None, (part.strip() for part in body.split(","))):
            name, _, given = (piece.strip() for piece in part.partition("="))
            value = int(given) if given else value
            found[name], value = value, value + 1
        return found

    @staticmethod
    def argument(name, kind, dimensions):
        return name, kind + " *" if dimensions else kind

    def size(self, kind, pointer):
        """Size and alignment of a type."""
        if "*" in kind:
            return pointer, pointer
        kind = re.sub(r"^const ", "", kind)
        if kind.startswith("enum "):
            return 4, 4
        if kind == "size_t":
            return pointer, pointer
        if kind.startswith("struct "):
            return self.structures[kind[7:]][pointer]
        return SIZES[kind], SIZES[kind]

    def structure(self, body):
        """Members, with their offsets for both sizes of pointers; and the sizes."""
        members = [{"name": name, "type": kind, "expressions": dimensions}
                   for line in body.split(";") if line.strip()
                   for name, kind, dimensions in declared(line)]
        made = {"members": members}
        for pointer in (4, 8):
            at, widest = 0, 1
            for member in members:
                size, align = self.size(member["type"], pointer)
                at = -(-at // align) * align
                lengths = [length(e, pointer) for e in member["expressions"]]
                member[pointer] = at, lengths
                for count in lengths:
                    size *= count
                at, widest = at + size, max(widest, align)
            made[pointer] = -(-at // widest) * widest, widest
        return made


def both(four, eight):
    return four if four == eight else [four, eight]


def description(header):
    """The content of interface.json. Where the sizes of pointers matter, a number is two."""
    def member(m):
        made = {"name": m["name"], "type": m["type"], "offset": both(m[4][0], m[8][0])}
        if m["expressions"]:
            made["length"] = [both(*pair) for pair in zip(m[4][1], m[8][1])]
        return made

    def lines(mapping):
        return ",\n".join("  %s: %s" % (json.dumps(key), value) for key, value in mapping.items())

    structures = {name: '{"size": %s, "members": [\n   %s]}' % (
        json.dumps(both(s[4][0], s[8][0])),
        ",\n   ".join(json.dumps(member(m)) for m in s["members"]))
        for name, s in header.structures.items()}
    functions = {name: json.dumps({"returns": returns, "arguments": arguments})
                 for name, (returns, arguments) in header.functions.items()}
    return ('{\n "made_by": "src/bindings/interface.py, of include/scarp.h",\n "version": %s,\n'
            ' "constants": {\n%s\n },\n "enums": {\n%s\n },\n "structures": {\n%s\n },\n'
            ' "functions": {\n%s\n }\n}\n') % (
                json.dumps(header.version),
                lines({k: json.dumps(v) for k, v in header.constants.items()}),
                lines({k: json.dumps(v) for k, v in header.enums.items()}),
                lines(structures), lines(functions))


def code(kind):
    """The type as the tables of Python spell it."""
    if "*" in kind:
        return "text" if kind == "const char *" else "pointer"
    kind = re.sub(r"^const ", "", kind)
    if kind.startswith("enum "):
        return "i4"
    return kind[7:] if kind.startswith("struct ") else CODES[kind]


def python_table(header):
    """The content of _interface.py."""
    def dims(m):
        return tuple(four if four == eight else (four, eight)
                     for four, eight in zip(m[4][1], m[8][1]))

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
        out += ["    %r: (%r, (" % (name, both_tuple(s[4][0], s[8][0]))]
        out += ["        (%r, %r, %r)," % (m["name"], code(m["type"]), dims(m))
                for m in s["members"]] + ["    )),"]
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


def both_tuple(four, eight):
    return four if four == eight else (four, eight)


def asserts(header):
    """A C file that compiles where the offsets hold."""
    out = ["#include <scarp.h>", "#include <stddef.h>", "struct probe { char c; double d; };",
           "#define NATURAL (offsetof(struct probe, d) == 8)",
           "#define PLACE(four, eight) (sizeof(void *) == 4 ? (four) : (eight))"]
    say = '_Static_assert(!NATURAL || %s == PLACE(%d, %d), "%s");'
    for name, s in header.structures.items():
        out.append(say % ("sizeof(struct %s)" % name, s[4][0], s[8][0], name))
        for m in s["members"]:
            out.append(say % ("offsetof(struct %s, %s)" % (name, m["name"]), m[4][0], m[8][0],
                              name + "." + m["name"]))
    for values in header.enums.values():
        out += ['_Static_assert(%s == %d, "%s");' % (name, value, name)
                for name, value in values.items()]
    return "\n".join(out) + "\n"


class Layout:
    """What src/web/layout.mjs says of the same structures."""

    def __init__(self, text, header):
        self.text, self.header, self.complaints = text, header, []

    def expect(self, what, said, meant):
        if said != meant:
            self.complaints.append("src/web/layout.mjs: %s is %r, in scarp.h %r" % (
                what, said, meant))

    def number(self, name):
        found = re.search(r"\b%s = (\d+)" % name, self.text)
        return int(found.group(1)) if found else None

    def words(self, name):
        found = re.search(r"\b%s = \[(.*?)\]" % name, self.text, re.S)
        return re.findall(r"'(\w+)'", found.group(1)) if found else None

    def table(self, name):
        found = re.search(r"\b%s = (?:Object\.freeze\()?\{(.*?)\}" % name, self.text, re.S)
        return {re.sub(r"[A-Z]", lambda c: "_" + c.group(0).lower(), key)
                if not key.isupper() else key: int(value)
                for key, value in re.findall(r"(\w+): (\d+)", found.group(1))} if found else {}

    def offsets(self, structure):
        return {m["name"]: m[4][0] for m in self.header.structures[structure]["members"]
                if m["name"] != "spare"}

    def check(self):
        of = self.header.structures
        for name, meant in (("NOISE_SIZE", of["scarp_noise"][4][0]),
                            ("GRID_SIZE", of["scarp_grid"][4][0]),
                            ("PLAN_SIZE", of["scarp_plan"][4][0]),
                            ("GPU_PLAN_SIZE", of["scarp_gpu_plan"][4][0]),
                            ("GPU_ANSWERS", self.header.constants["SCARP_GPU_ANSWERS"])):
            self.expect(name, self.number(name), meant)
        for name, structure in (("SAMPLES", "scarp_samples"), ("CELLS", "scarp_cells"),
                                ("FLOW", "scarp_flow")):
            self.expect(name, self.words(name), list(self.offsets(structure)))
            self.expect("ARRAYS_SIZE", self.number("ARRAYS_SIZE"), of[structure][4][0])
        self.expect("PARTIALS", self.words("PARTIALS"), list(self.offsets("scarp_partials")))
        self.expect("STATUS", self.table("STATUS"), {
            name.replace("SCARP_", "").replace("ERROR_", ""): value
            for name, value in self.header.enums["scarp_status"].items()})
        self.check_noise()
        self.check_grid()
        return self.complaints

    def check_noise(self):
        said = {**self.table("ENUMERATORS"), **self.table("FLOATS")}
        said.update({name.lower(): self.number(name) for name in ("PERIOD", "WARP", "PLAN")})
        for name, text in (("rotate", r"setUint32\(at \+ (\d+), noise\.rotate"),
                           ("seed", r"setBigUint64\(at \+ (\d+), seedOf"),
                           ("frequency", r"setFloat64\(at \+ (\d+), checkNumber\('frequency'")):
            found = re.search(text, self.text)
            said[name] = int(found.group(1)) if found else None
        self.expect("a noise", dict(sorted(said.items())),
                    dict(sorted(self.offsets("scarp_noise").items())))

    def check_grid(self):
        said = {}
        for name, text in (("origin", r"setFloat64\(at( )\+ 8 \* i, origin"),
                           ("step", r"setFloat64\(at \+ (\d+) \+ 8 \* i, grid\.step"),
                           ("first", r"setBigInt64\(at \+ (\d+) \+ 8 \* i, grid\.first"),
                           ("count", r"setUint32\(at \+ (\d+) \+ 4 \* i, size"),
                           ("row_stride", r"setUint32\(at \+ (\d+), rowStride"),
                           ("slice_stride", r"setUint32\(at \+ (\d+), sliceStride")):
            found = re.search(text, self.text)
            said[name] = int("0" + found.group(1).strip()) if found else None
        self.expect("a grid", said, self.offsets("scarp_grid"))


def read(path):
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        return file.read()


def main(arguments):
    header = Header(read(HEADER))
    made = {DESCRIPTION: description(header), PYTHON: python_table(header)}
    if arguments == ["--asserts"]:
        sys.stdout.write(asserts(header))
    elif arguments == ["--check"]:
        complaints = ["%s is not current: run src/bindings/interface.py" %
                      os.path.relpath(path, ROOT) for path, text in made.items()
                      if read(path) != text] + Layout(read(LAYOUT), header).check()
        if complaints:
            sys.exit("\n".join(complaints))
        print("%d structures, %d calls and layout.mjs are those of scarp.h" % (
            len(header.structures), len(header.functions)))
    elif not arguments:
        for path, text in made.items():
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
    else:
        sys.exit(__doc__)


main(sys.argv[1:])
