# SPDX-License-Identifier: MIT
"""The parts of Scarp.cs, which has to be one file. Enumerators get the names of C#. Structures and
calls have the names of scarp.h, and no types but those that every runtime passes to C as they
are."""
import re
import sys

from tables import chain
from tables.text import replaced, wrapped

PATH = "src/bindings/csharp/Scarp.cs"
TESTED = "tests/bindings/csharp/Chain.cs"
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


def about(text, indent):
    """A summary, with code as C# marks it."""
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return wrapped(indent + "/// ", "<summary>%s</summary>" % text, indent + "/// ", WIDTH,
                   ("<c>", "</c>"))


def broken(first, pieces, last, indent):
    """A list on lines that are not too long."""
    lines = [first]
    for i, piece in enumerate(pieces or [""]):
        piece += last if i + 1 >= len(pieces) else ", "
        if len(lines[-1]) + len(piece.rstrip()) > WIDTH:
            lines[-1] = lines[-1].rstrip()
            lines.append(indent)
        lines[-1] += piece
    return lines


def function(name, returns, arguments):
    pieces = ["%s %s" % (kind_of(kind), identifier(of)) for of, kind in arguments]
    return ["", "        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]"] + broken(
        "        public static extern %s %s(" % (kind_of(returns), name), pieces, ");", " " * 12)


def method(f):
    """A method of Samples for a function of the chain rule"""
    parameters = (["int count"] + ["in Samples " + name for name in f.inputs] +
                  ["float " + identifier(name) for name in f.numbers] + ["in Samples to"])
    samples = f.inputs + ["default(Samples)"] * (len(chain.INPUTS) - len(f.inputs))
    given = (["Function." + f.pascal, '"%s"' % ", ".join(f.numbers), "count",
              str(len(f.inputs))] + samples + ["to"] + [identifier(name) for name in f.numbers])
    first, indent = "        public static void %s(" % f.pascal, " " * 12
    return (about(f.about(), "        ") + broken(first, parameters, ")", indent) + ["        {"] +
            broken(indent + "Run(", given, ");", indent + "    ") + ["        }", ""])


def methods(header):
    """The part of Samples that the functions of the chain rule are"""
    all_ = chain.functions(header)
    out = [line for f in all_ for line in method(f)]
    out += ["        internal enum Function", "        {"]
    out += broken(" " * 12, [f.pascal for f in all_], "", " " * 12) + ["        }", ""]
    out += ["        internal static Status Call(Function function, UIntPtr count,",
            "                                    Native.scarp_samples* s, float* x)", "        {",
            "            switch (function) {"]
    for f in all_:
        given = ["count", "s"] + ["s + %d" % i for i in range(1, len(f.inputs))]
        given += ["x[%d]" % i for i in range(len(f.numbers))] + ["s + %d" % len(f.inputs)]
        label = "default:" if f is all_[-1] else "case Function.%s:" % f.pascal
        out.append("            %s return Native.%s(%s);" % (label, f.call, ", ".join(given)))
    return out + ["            }", "        }"]


def tested(header):
    """tests/bindings/csharp/Chain.cs: the calls that tests/bindings/chain.h has in C"""
    out = ["// SPDX-License-Identifier: MIT", "//",
           "// The calls of tests/bindings/chain.h. Made by src/bindings/interface.py; do not change it "
           "by hand.", "using Scarp;", "", "static class Chain", "{",
           "    public delegate void Call(int count, in Samples a, in Samples b, in Samples to);", "",
           "    public static readonly string[] Names = {"]
    all_ = [f for f in chain.functions(header) if f.call != chain.SLOPE]
    out += broken(" " * 8, ['"%s"' % f.name for f in all_], "", " " * 8)
    out += ["    };", "    public static readonly Call[] Calls = {"]
    for f in all_:
        given = ["n"] + list(("a", "b", "a")[:len(f.inputs)])
        given += ["%sf" % float(number) for number in f.given.values()] + ["to"]
        out += ["        (int n, in Samples a, in Samples b, in Samples to) =>",
                "            Samples.%s(%s)," % (f.pascal, ", ".join(given))]
    return "\n".join(out + ["    };", "}"]) + "\n"


def tables(header):
    """What of Scarp.cs is made of structures, enumerators and calls"""
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
    return out[1:] + ["    }"]


def made(header, read):
    """Files with what is made of the header: pairs of a path and a text"""
    text = replaced(PATH, read(PATH), "chain", methods(header))
    yield PATH, replaced(PATH, text, "tables", tables(header))
    yield TESTED, tested(header)
