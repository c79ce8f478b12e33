#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Describes include/scarp.h for bindings of other languages: enumerators, structures with the
offsets of their members, and calls. The header is the only source; what is written here is made
of it.

    interface.py            writes interface.json and the parts of bindings (tables/)
    interface.py --check    says what of that is not current, which documents of a binding lack a
                            member of a noise, and which have another default or interval. It also
                            compares the header with src/plan/members.h, of which the library is
                            made.
    interface.py --asserts  prints a C file that compiles if the offsets are those of its compiler
"""
import json
import os
import re
import sys

from header import Header, both, intervals
from tables import chain, cpp, csharp, program, python, rust, web

TABLES = (cpp, csharp, program, python, rust, web)

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
HEADER = "include/scarp.h"
MEMBERS = "src/plan/members.h"
DESCRIPTION = "src/bindings/interface.json"
CALLS = "tests/bindings/chain.h"

# Where a binding documents the members of a noise: a file, what stands before them and behind them,
# and whether names are camelCase
DOCUMENTS = (("src/web/scarp.d.ts", "export interface Noise {", "\n}", True),
             ("src/bindings/python/scarp/__init__.pyi", "class Noise:", "-> None", False),
             ("src/bindings/python/scarp/_noise.py", "class Noise:\n", "\n    None ", False),
             ("src/bindings/csharp/Scarp.cs", "class Noise\n", "// On its way to C", False),
             ("src/bindings/rust/src/noise.rs", "pub struct Noise<'a> {", "\n}", False))

# The same, where it has defaults and intervals: the structure, what stands before and behind, and
# how a member has its text
BEFORE = r"(?s)/\*\*(?P<text>(?:(?!\*/).)*)\*/\s*(?P<name>\w+)\?:"
SLASHES = r"(?P<text>(?: *///.*\n)+) *(?:pub|public \w+) (?P<name>\w+)"
COLUMNS = r"(?m)^    (?P<name>\w+) +(?P<text>.*(?:\n {10,}.*)*)"
DESCRIBED = (("src/web/scarp.d.ts", "noise", "export interface Noise {", "\n}", BEFORE),
             ("src/bindings/csharp/Scarp.cs", "noise", "class Noise\n", "// On its way to C",
              SLASHES),
             ("src/bindings/rust/src/noise.rs", "noise", "pub struct Noise<'a> {", "\n}", SLASHES),
             ("src/bindings/rust/src/gullies.rs", "gullies", "pub struct Gullies {", "\n}",
              SLASHES),
             ("src/bindings/python/scarp/_noise.py", "noise", "class Noise:\n", "\n    None ",
              COLUMNS),
             ("src/bindings/python/scarp/_gullies.py", "gullies", "class Gullies:\n", "\n    0 ",
              COLUMNS))


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


def rows():
    """The default and the intervals of each number in src/plan/members.h, by structure."""
    def number(text):
        return None if "FLT_MAX" in text else float.fromhex(text) if "x" in text else float(text)

    made, text = {}, read(MEMBERS).replace("\\\n", "")
    for name in ("noise", "gullies", "narrow"):
        row = re.search(r"#define SCARP_%s_MEMBERS\(.*?\)(.*)" % name.upper(), text).group(1)
        made[name] = {}
        for member, standard, lowest, highest, why in re.findall(
                r'NUMBER\(X, (\w+), \w+, ([^,]+), ([^,]+), ([^,]+), +"(.*?)"', row):
            made[name][member] = number(standard), [(number(lowest), number(highest))], why
        for member, lowest, highest, why in re.findall(
                r'NARROW\(X, (\w+), \w+, ([^,]+), ([^,]+), +"(.*?)"', row):
            made[name][member] = None, [(number(lowest), number(highest))], why
        for member, standard in re.findall(r"OTHER\(X, (\w+), ([^,]+),", row):
            of_noise = made["noise"].get(member, (0.0, [], ""))
            made[name][member] = number(standard), of_noise[1], ""
    return made


def differences(header):
    """Where the header, or a text of src/plan/members.h, says another number than its rows."""
    made = rows()
    for name in ("noise", "gullies"):
        members = {m["name"]: m for m in header.structures["scarp_" + name]["members"]}
        for member, (standard, allowed, why) in made[name].items():
            said = members[member]
            narrow = made["narrow"].get(member, (None, [], ""))[1] if name == "noise" else []
            if (said["default"] or 0.0) != standard:
                yield "%s: the default of %s.%s is %g" % (HEADER, name, member, standard)
            if set(said["intervals"]) - set(allowed + narrow):
                yield "%s: %s.%s has another interval" % (HEADER, name, member)
            if not said["intervals"] and re.search(r"outside [\[(][-0-9]", why):
                yield "%s: %s.%s has no interval" % (HEADER, name, member)
    for name, members in made.items():
        for member, (_, allowed, why) in members.items():
            if intervals(why) and intervals(why) != allowed:
                yield "%s: %s.%s: %s" % (MEMBERS, name, member, why)


def disagreements(header):
    """Documents of bindings that say another default or interval than the header."""
    for path, structure, first, last, pattern in DESCRIBED:
        members = {m["name"]: m for m in header.structures["scarp_" + structure]["members"]}
        found = 0
        for match in re.finditer(pattern, read(path).partition(first)[2].partition(last)[0]):
            member = members.get(re.sub(r"(?<=.)([A-Z])", r"_\1", match.group("name")).lower())
            if member is None or not member["default"]:
                continue
            found += 1
            text = re.sub(r"\s*(///|\n)\s*\*?\s*", " ", match.group("text"))
            standards = re.findall(r"\b[Dd]efault (-?[0-9.]*[0-9])", text)
            standards += re.findall(r"(-?[0-9.]*[0-9]) by default", text)
            if {float(standard) for standard in standards} - {member["default"]}:
                yield "%s: %s of %s has another default" % (path, match.group("name"), structure)
            if set(intervals(text)) - set(member["intervals"]):
                yield "%s: %s of %s has another interval" % (path, match.group("name"), structure)
        if found < 5:
            yield "%s: the documents of %s have another form" % (path, structure)


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
        complaints += [*undocumented(header), *differences(header), *disagreements(header)]
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
