# SPDX-License-Identifier: MIT
"""The parts of Scarp.cs, which has to be one file. Enumerators get the names of C#. Structures and
calls have the names of scarp.h, and no types but those that every runtime passes to C as they
are."""
import re
import sys
from itertools import groupby

from tables import chain
from tables.arrays import arrays
from tables.text import replaced, wrapped

PATH = "src/bindings/csharp/Scarp.cs"
TESTED = "tests/bindings/csharp/Chain.cs"
TYPES = {"char": "byte", "unsigned char": "byte", "int": "int", "int32_t": "int",
         "uint32_t": "uint", "float": "float", "int64_t": "long", "uint64_t": "ulong",
         "double": "double", "size_t": "UIntPtr", "void": "void"}
SPANS = (("Samples", "scarp_samples"), ("Cells", "scarp_cells"), ("Flow", "scarp_flow"))
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
    return "\n".join(out + ["    };", "}", *tested_spans(header)]) + "\n"


def tested_spans(header):
    """For Lengths.cs: names of members, and structures of which one array is another"""
    out = ["", "static class Spans", "{"]
    for name, structure in SPANS:
        members = arrays(header, structure)
        out += ["    public static readonly string[] %s = {" % name]
        out += broken(" " * 8, ['"%s"' % m.camel for m in members], "", " " * 8) + ["    };", ""]
        out += ["    public static %s %sOf(int i, System.Span<float> a)" % (name, name), "    {",
                "        return new %s {" % name]
        for i, m in enumerate(members):
            given = "Lengths.If(i == %d, a)" % i
            if m.kind != "float":
                given = "System.Runtime.InteropServices.MemoryMarshal.Cast<float, %s>(%s)" % (
                    TYPES[m.kind], given)
            out.append("            %s = %s," % (m.camel, given))
        out += ["        };", "    }", ""]
    return out[:-1] + ["}"]


def structure_of_spans(name, members):
    """A structure of arrays, with what its checks need"""
    out = ["", *about(ABOUT[name], "    ")] if name in ABOUT else [""]
    out += ["    public ref partial struct %s" % name, "    {"]
    for kind, of_kind in groupby(members, lambda each: each.kind):
        out += broken(" " * 8 + "public Span<%s> " % TYPES[kind], [m.camel for m in of_kind], ";",
                      " " * 12)
    names = ['"to.%s"' % m.camel for m in members] + ['""'] * (16 - len(members))
    out += ["", "        internal static readonly string[] Names = {"]
    out += broken(" " * 12, names, "", " " * 12) + ["        };", ""]
    out += ["        // How many arrays are given. Throws if one is too short.",
            "        internal static int Check(in %s s, long needed, string name)" % name,
            "        {", "            return 0"]
    out += ['                + Arguments.Room(s.%s, needed, name, "%s")' % (m.camel, m.camel)
            for m in members]
    out[-1] += ";"
    if name != "Samples":
        out += ["        }", "", "        // The first array for which the plane has nothing, or null",
                "        internal static string AlongZ(in %s s)" % name, "        {",
                "            Span<float> none = default(Span<float>);", "            return"]
        out += ['                s.%s != none ? "to.%s" :' % (m.camel, m.camel)
                for m in members if m.is_of_space] + ["                null;"]
    return out + ["        }", "    }"]


def pinned(name, structure, members):
    """A method of Noise that pins the arrays of cells or a flow, and calls"""
    out = ["", "        void Fields(int dimensions, int count, void* x, void* y, void* z, bool isFloat,",
           "                    in %s to)" % name, "        {",
           '            Arguments.Given(%s.Check(to, count, "to"), count,' % name,
           "                            dimensions == 2 ? %s.AlongZ(to) : null);" % name]
    for kind, of_kind in groupby(sorted(members, key=lambda m: m.kind), lambda m: m.kind):
        out += broken("            fixed (%s* " % TYPES[kind],
                      ["%s_ = to.%s" % (m.name, m.camel) for m in of_kind], ")", " " * 16)
    out[-1] += " {"
    out += ["                var into = new Native.%s {" % structure]
    out += broken(" " * 20, ["%s = %s_" % (m.name, m.name) for m in members], "", " " * 20)
    return out + ["                };", "                Other(dimensions, count, x, y, z, isFloat, %s);"
                  % ("&into, null" if name == "Cells" else "null, &into"),
                  "            }", "        }"]


def at_points(stem, dimensions, kind, about_it, results, body):
    """A method for coordinates of floats, or doubles"""
    axes = "xyz"[:dimensions]
    out = about(about_it, "        ") if about_it else []
    out += broken("        public void %s%d(" % (stem, dimensions),
                  ["ReadOnlySpan<%s> %s" % (kind, axis) for axis in axes] + results, ")", " " * 12)
    out += ["        {"]
    out += ['            Arguments.Same(x.Length, %s.Length, "%s");' % (axis, axis)
            for axis in axes[1:]]
    out += ["            fixed (%s* %s) {" % (
        kind, ", ".join("p%s = %s" % (axis, axis) for axis in axes))]
    return out + ["                " + line for line in body] + ["            }", "        }"]


POINTS = ("Sample", "Vector", "Cells", "Curl")
ABOUT = {
    "Cells": "What is near a point. F1, F2: distances to the nearest feature and to the second, in "
             "units of input; Id: a number drawn for the nearest one's cell; X, Y, Z: where it is; "
             "Dx1 ... and Dx2 ...: the gradients of F1 and F2.",
    "Flow": "A velocity without divergence, and its Jacobian: Vxy is the derivative of Vx with "
            "respect to y. Per unit of input.",
    "Sample2": "Samples at points (x[i], y[i]). Arrays of `to` have at least as many elements as x. "
               "Detail fades some 2^23 cells from the origin: doubles are for large worlds. With "
               "floats an output may be the very same array as a coordinate.",
    "Sample2F64": "Samples at points of doubles, as Sample2 of floats. Outputs cannot be in place.",
    "Sample3": "Samples at points (x[i], y[i], z[i]) of space.",
    "Sample3F64": "Samples at points of space of doubles.",
    "Vector2": "Vector noise: component 0 and 1 at points of the plane, as warps displace them.",
    "Vector3": "Vector noise at points of space: components 0, 1 and 2.",
    "Cells2": "The cells around points, of frequency, seed, jitter and period; the basis changes "
              "nothing.",
    "Curl2": "A velocity without divergence at points, of which this noise is the potential."}
RECIPE = ("Samples an output, or any other field of the text, at points; default: the first output. "
          "Arrays of `to` have at least as many elements as x, and overlap nothing.")


def every_call():
    """Pairs of dimensions and a type of coordinates, with the end of names, and pointers"""
    for dimensions in (2, 3):
        for kind in ("float", "double"):
            yield (dimensions, kind, "F64" if kind == "double" else "",
                   "px, py, pz" if dimensions == 3 else "px, py, null")


def points(header):
    """The methods of Noise that differ by the dimension and by the type of coordinates"""
    out = []
    for stem in POINTS:
        for dimensions, kind, end, pointers in every_call():
            name = "%s%d%s" % (stem, dimensions, end)
            request = "var r = new Request(Op.%s, x.Length, %s);" % (name, pointers)
            results, body = ["in Samples to"], [request, "Run(&r, to);"]
            if stem == "Vector":
                each = ["first", "second", "third"][:dimensions]
                results = ["in Samples " + one for one in each]
                body = [request, "Run(&r, %s);" % ", ".join(
                    each + ["default(Samples)"] * (3 - dimensions))]
            elif stem != "Sample":
                results = ["in %s to" % ("Cells" if stem == "Cells" else "Flow")]
                body = ["Fields(%d, x.Length, %s, %s, to);" % (
                    dimensions, pointers, "true" if kind == "float" else "false")]
            out += ["", *at_points(stem, dimensions, kind, ABOUT.get(name), results, body)]
    for name, structure in SPANS[1:]:
        out += pinned(name, structure, arrays(header, structure))
    return out[1:]


def recipe_points():
    out = []
    for dimensions, kind, end, pointers in every_call():
        body = ["var r = new Request(Op.Recipe%s, x.Length, %s);" % (end, pointers),
                "Run(&r, %d, to, output);" % dimensions]
        out += ["", *at_points("Sample", dimensions, kind, "" if out else RECIPE,
                               ["in Samples to", "string output = null"], body)]
    return out[1:]


def pin(members, parameter, place, name, last):
    """Pins the arrays of samples, then goes on. The slow check is for the message."""
    out = ["            fixed (float*"]
    out += ["                %s = &MemoryMarshal.GetReference(%s.%s)," % (m.name, parameter, m.camel)
            for m in members]
    out[-1] = out[-1][:-1] + ") {"
    out.append("                long n = r->length;")
    for i, m in enumerate(members):
        out.append("                %s%s.%s.Length < n && %s != null" % (
            "    || " if i else "if (", parameter, m.camel, m.name))
    out[-1] += ") {"
    out += ["                    Samples.Check(%s, n, r->NameOf(%s));" % (parameter, name),
            "                }"]
    out += ["                into[%s].%s = %s;" % (place, m.name, m.name) for m in members]
    return out + ["                return %s;" % last, "            }", "        }"]


def pins(header):
    """How Request pins arrays"""
    members = arrays(header, "scarp_samples")
    return [
        "        // Pins the first of the samples, then the others, then calls.",
        "        public static Status Pin(Request* r, Native.scarp_samples* into, int filled, int all,",
        "                                 in Samples first, in Samples second, in Samples third,",
        "                                 in Samples fourth)", "        {",
        "            if (filled + 1 == all) {", "                return Pin(r, into, all, first);",
        "            }"] + pin(
            members, "first", "filled", "filled",
            "Pin(r, into, filled + 1, all, second, third, fourth, default(Samples))") + [
        "", "        // The last one, which most calls have alone",
        "        public static Status Pin(Request* r, Native.scarp_samples* into, int all, in Samples last)",
        "        {"] + pin(members, "last", "all - 1", "all - 1", "r->Run(into, all)")


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
    text, structures = read(PATH), []
    for name, structure in SPANS:
        structures += structure_of_spans(name, arrays(header, structure))
    for part, lines in (("arrays", structures[1:]), ("points", points(header)),
                        ("chain", methods(header)), ("recipe", recipe_points()),
                        ("pins", pins(header)), ("tables", tables(header))):
        text = replaced(PATH, text, part, lines)
    yield PATH, text
    yield TESTED, tested(header)
