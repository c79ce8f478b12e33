# SPDX-License-Identifier: MIT
"""The tables of C#: a part of Scarp.cs, which has to be one file. Enumerators get the names of C#.
Structures and calls have the names of scarp.h, and no types but those that every runtime passes to
C as they are."""
import os
import re
import sys

PATH = "src/bindings/csharp/Scarp.cs"
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
FIRST, LAST = "    // <tables>", "    // </tables>\n"
TYPES = {"char": "byte", "unsigned char": "byte", "int": "int", "int32_t": "int",
         "uint32_t": "uint", "float": "float", "int64_t": "long", "uint64_t": "ulong",
         "double": "double", "size_t": "UIntPtr", "void": "void"}
PREFIXES = {"scarp_status": "SCARP_(ERROR_)?", "scarp_isa": "SCARP_ISA_",
            "scarp_recipe_kind": "SCARP_RECIPE_"}
WORDS = {"out", "in", "ref", "params", "is", "as", "fixed", "base", "operator"}
WIDTH = 100


def fail(message):
    sys.exit("tables/csharp.py: " + message)


def camel(name):
    """recipe_kind as RecipeKind, of_octaves as OfOctaves"""
    return "".join(word.capitalize() for word in name.lower().split("_"))


def identifier(name):
    return "@" + name if name in WORDS else name


def kind_of(kind):
    """The type in C#. A pointer to a constant is a pointer."""
    stars = kind.count("*")
    kind = " ".join(kind.replace("*", " ").replace("const", " ").split())
    if kind.startswith("enum "):
        return camel(kind[11:]) + "*" * stars
    return (kind[7:] if kind.startswith("struct ") else TYPES[kind]) + "*" * stars


def enums(header):
    out = []
    for name, values in header.enums.items():
        out += ["", "    /// <summary>enum %s</summary>" % name,
                "    public enum %s" % camel(name[6:]), "    {"]
        prefix = PREFIXES.get(name, "SCARP_")
        out += ["        %s = %d," % (camel(re.sub("^" + prefix, "", member)), value)
                for member, value in values.items()] + ["    }"]
    return out


def array(structure, member):
    """The declarations of an array: a buffer of numbers, or a member for each pointer or
    structure."""
    name, kind = member["name"], kind_of(member["type"])
    (count,), other = product(member[8][1]), product(member[4][1])[0]
    if count != other:
        fail("the length of %s.%s depends on pointers" % (structure, name))
    if kind in TYPES.values() and kind != "UIntPtr":
        return ["public fixed %s %s[%d];" % (kind, identifier(name), count)]
    names, lines = ["%s%d" % (name, i) for i in range(count)], []
    while names:
        line = "public %s %s" % (kind, names.pop(0))
        while names and len(line) + len(names[0]) + 15 < WIDTH:
            line += ", " + names.pop(0)
        lines.append(line + ";")
    return lines


def product(lengths):
    made = 1
    for length in lengths:
        made *= length
    return [made]


def structure(name, s):
    """Members in their order. A rest whose length depends on pointers is left to the size, which
    does not."""
    members, size = list(s["members"]), ""
    if product(members[-1][4][1]) != product(members[-1][8][1]):
        if s[4][0] != s[8][0]:
            fail("%s has no size of its own" % name)
        members, size = members[:-1], ", Size = %d" % s[8][0]
    out = ["", "        [StructLayout(LayoutKind.Sequential%s)]" % size,
           "        public unsafe struct %s" % name, "        {"]
    for member in members:
        if member["expressions"]:
            lines = array(name, member)
        else:
            lines = ["public %s %s;" % (kind_of(member["type"]), identifier(member["name"]))]
        out += ["            " + line for line in lines]
    return out + ["        }"]


def function(name, returns, arguments):
    pieces = ["%s %s" % (kind_of(kind), identifier(of)) for of, kind in arguments]
    lines = ["", "        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]",
             "        public static extern %s %s(" % (kind_of(returns), name)]
    for i, piece in enumerate(pieces):
        piece += ", " if i + 1 < len(pieces) else ""
        if len(lines[-1]) + len(piece.rstrip()) + 2 > WIDTH:
            lines[-1] = lines[-1].rstrip()
            lines.append("            ")
        lines[-1] += piece
    lines[-1] += ");"
    return lines


def table(header):
    """Scarp.cs with its part that is made of the header."""
    with open(os.path.join(ROOT, PATH), encoding="utf-8") as file:
        text = file.read()
    before, first, rest = text.partition(FIRST)
    line, _, rest = rest.partition("\n")
    _, last, after = rest.partition(LAST)
    if not first or not last:
        fail("%s has no part between %s and %s" % (PATH, FIRST.strip(), LAST.strip()))
    major, minor, patch = header.version.split(".")
    out = enums(header) + [
        "",
        "    /// <summary>The calls and structures of scarp.h, as it has them: for jobs, Burst, and",
        "    /// what no class wraps. include/scarp.h has their contracts.</summary>",
        "    public static unsafe partial class Native", "    {",
        "        public const int VersionMajor = %s, VersionMinor = %s, VersionPatch = %s;" % (
            major, minor, patch)]
    out += ["        public const int %s = %d;" % pair for pair in header.constants.items()
            if not pair[0].startswith("SCARP_VERSION_")]
    for name, s in header.structures.items():
        out += structure(name, s)
    for name, (returns, arguments) in header.functions.items():
        out += function(name, returns, arguments)
    return before + first + line + "\n" + "\n".join(out[1:] + ["    }"]) + "\n" + last + after
