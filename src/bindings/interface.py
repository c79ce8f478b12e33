#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Describes include/scarp.h for bindings of other languages: enumerators, structures with the
offsets of their members, and calls. The header is the only source; what is written here is made
of it.

    interface.py            writes interface.json and the parts of bindings (tables/)
    interface.py --check    says what of that is not current, and which documents of a binding lack
                            a member of a noise
    interface.py --asserts  prints a C file that compiles if the offsets are those of its compiler
"""
import json
import os
import re
import sys

from header import Header, both
from tables import chain, cpp, csharp, python, rust, web

TABLES = (cpp, csharp, python, rust, web)

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
HEADER = "include/scarp.h"
DESCRIPTION = "src/bindings/interface.json"
CALLS = "tests/bindings/chain.h"

# Where a binding documents the members of a noise: a file, what stands before them and behind them,
# and whether names are camelCase
DOCUMENTS = (("src/web/scarp.d.ts", "export interface Noise {", "\n}", True),
             ("src/bindings/python/scarp/__init__.pyi", "class Noise:", "-> None", False),
             ("src/bindings/python/scarp/_noise.py", "class Noise:\n", "\n    None ", False),
             ("src/bindings/csharp/Scarp.cs", "class Noise\n", "// On its way to C", False),
             ("src/bindings/rust/src/noise.rs", "pub struct Noise<'a> {", "\n}", False))


def description(header):
    """The content of interface.json. Where the sizes of pointers matter, a number is two."""
    def member(m):
        made = {"name": m["name"], "type": m["type"], "offset": both(m[4][0], m[8][0])}
        if m["expressions"]:
            made["length"] = [both(*pair) for pair in zip(m[4][1], m[8][1])]
        if m["default"] is not None:
            made["default"] = m["default"]
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
            ' "functions": {\n%s\n },\n "chain": {\n%s\n }\n}\n') % (
                json.dumps(header.version),
                lines({k: json.dumps(v) for k, v in header.constants.items()}),
                lines({k: json.dumps(v) for k, v in header.enums.items()}),
                lines(structures), lines(functions),
                lines({k: json.dumps(v) for k, v in chain.described(header).items()}))


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


def read(path):
    path = os.path.join(ROOT, path)
    if not os.path.exists(path):
        return ""
    with open(path, encoding="utf-8") as file:
        return file.read()


def undocumented(header):
    """What documents of bindings do not say of a noise."""
    for path, first, last, is_camel in DOCUMENTS:
        told = set(re.findall(r"\w+", read(path).partition(first)[2].partition(last)[0]))
        for member in header.structures["scarp_noise"]["members"]:
            name = member["name"]
            if is_camel:
                name = re.sub(r"_(.)", lambda letter: letter.group(1).upper(), name)
            if name not in told and name != "plan" and not name.startswith("spare"):
                yield "%s does not tell of %s" % (path, name)


def main(arguments):
    header = Header(read(HEADER))
    made = {DESCRIPTION: description(header), CALLS: chain.calls_in_c(header)}
    for module in TABLES:
        made.update(module.made(header, read))
    if arguments == ["--asserts"]:
        sys.stdout.write(asserts(header))
    elif arguments == ["--check"]:
        complaints = ["%s is not current: run src/bindings/interface.py" % path
                      for path, text in made.items() if read(path) != text]
        complaints += undocumented(header)
        if complaints:
            sys.exit("\n".join(complaints))
        print("%d structures and %d calls of scarp.h are in %s" % (
            len(header.structures), len(header.functions), ", ".join(made)))
    elif not arguments:
        for path, text in made.items():
            with open(os.path.join(ROOT, path), "w", encoding="utf-8") as file:
                file.write(text)
    else:
        sys.exit(__doc__)


main(sys.argv[1:])
