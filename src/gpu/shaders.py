#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes include/scarp.glsl, scarp.hlsl and scarp.wgsl from the C of src/formulas and src/gpu.

    shaders.py           writes them
    shaders.py --check   says which are not what it would write; exit status 1

subset.py reads that C, and refuses what shaders cannot have. head.glsl, head.hlsl and head.wgsl are
what each language needs around it: among others, functions that add, subtract and multiply floats,
since compilers of shaders fuse and reorder operators.
"""
import pathlib
import re
import sys
import textwrap

sys.dont_write_bytecode = True  # among the sources
from subset import (BLANK, RANK, Assign, Comment, Declare, Define, For, Function,  # noqa: E402
                    Known, Refused, Return, Source, Struct, Tree)

SRC = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = SRC.parent / "include"
STRUCTURES = ["formulas/octave", "gpu/plan"]
FUNCTIONS = ["formulas/signs", "gpu/numbers", "gpu/directions", "formulas/sample",
             "formulas/lattice", "formulas/corners", "formulas/gradient", "formulas/value",
             "formulas/simplex", "formulas/cells", "formulas/basis", "formulas/matrices",
             "formulas/positions", "formulas/fractal", "formulas/bend", "formulas/octaves",
             "formulas/warp", "formulas/curl", "formulas/answers", "gpu/octaves", "gpu/noise", "gpu/flow",
             "formulas/chain", "gpu/chain", "gpu/sine", "formulas/gullies", "gpu/recipe"]

# The functions of the heads: operators of floats, conversions by what comes of what, and ?: .
HOOKS = {"+": "add", "-": "sub", "*": "mul"}
CASTS = {("float", "int"): "float_of_int", ("float", "uint"): "float_of_uint",
         ("int", "float"): "whole_of", ("int", "uint"): "int_of", ("uint", "int"): "uint_of"}
PICKS = {"float": "pick", "int": "pick_int", "uint": "pick_uint"}


def enumerators():
    """The bases, fades and fractals of scarp.h as constants."""
    text = re.sub(r"/\*.*?\*/", "", (INCLUDE / "scarp.h").read_text(), flags=re.S)
    found = [Comment("/* Shaders: numbers of bases, fades and fractals. */")]
    for kind in ("basis", "fade", "fractal"):
        names = re.search(rf"enum scarp_{kind} {{(.*?)}};", text, re.S)[1]
        found += [BLANK] + [Define(name, Tree("number", "uint", f"{i}u"))
                            for i, name in enumerate(re.findall(r"SCARP_(\w+)", names))]
    return found


def known_at_first():
    """What the files named c.h and the heads declare."""
    known = Known()
    for it in enumerators():
        if isinstance(it, Define):
            known.constants["SCARP_" + it.name] = it.value.type
    known.values["scarp_plan"] = "plan[]"
    head = r"static inline (\w+) (\w+)\(([^)]*)\)"
    for room in ("formulas", "gpu"):
        for type_, name, parameters in re.findall(head, (SRC / room / "c.h").read_text()):
            known.functions[name] = type_, [p.split()[0] for p in parameters.split(", ")]
    return known


def is_hooked(tree):
    """Whether an operator becomes a call."""
    return tree.kind == "binary" and tree.text in HOOKS and tree.type == "float"


def is_mixed(rank, own):
    """Whether WGSL wants parentheses where C has none: around operands of shifts, of other bitwise
    operators, and around && in ||."""
    return rank in (0, 2, 3, 4, 7) and own not in (5, 6) and (own != rank or rank == 7)


def literal(tree):
    """A number; hexadecimal floats are only in C."""
    if tree.type != "float" or "x" not in tree.text.lower():
        return tree.text
    text = f"{float.fromhex(tree.text[:-1]):.9g}"
    return text + ("f" if "." in text or "e" in text else ".0f")


class Glsl:
    """Turns trees into lines of GLSL. Local constants are variables: GLSL ES wants constants to be
    known when it compiles."""
    TYPES = {}

    def type(self, name):
        capital = "Scarp" + "".join(word.capitalize() for word in name.split("_"))
        scalars = ("float", "int", "uint", "bool", "vec3", "uvec3", "vec4")
        return self.TYPES.get(name, name if name in scalars else capital)

    def call(self, name, arguments):
        return f"scarp_{name}({', '.join(arguments)})"

    def braces(self, type_, parts):
        """What initialises a structure or a vector."""
        return f"{self.type(type_)}({', '.join(parts)})"

    # Expressions

    def show(self, tree):
        parts = tree.parts
        if tree.kind == "number":
            return literal(tree)
        if tree.kind == "name":
            return tree.text
        if tree.kind == "constant":
            return f"SCARP_{tree.text.replace('SCARP_', '')}"
        if tree.kind == "member":
            return f"{self.show(parts[0])}.{tree.text}"
        if tree.kind == "index":
            return f"{self.show(parts[0])}[{self.show(parts[1])}]"
        if tree.kind == "unary":
            return tree.text + self.operand(parts[0], len(RANK))
        if tree.kind == "binary" and not is_hooked(tree):
            rank = RANK[tree.text]
            left, right = self.operand(parts[0], rank), self.operand(parts[1], rank, 1)
            return f"{left} {tree.text} {right}"
        if tree.kind == "braces":
            return self.braces(tree.type, [self.show(part) for part in parts])
        name = {"call": tree.text, "binary": HOOKS.get(tree.text), "pick": PICKS.get(tree.type),
                "cast": CASTS.get((tree.type, parts[0].type if parts else ""))}[tree.kind]
        return self.call(name, [self.show(part) for part in parts])

    def operand(self, tree, rank, is_right=0):
        """An operand of an operator of this rank, in parentheses if it has some or needs them."""
        text = self.show(tree)
        if tree.kind not in ("unary", "binary") or is_hooked(tree):
            return text
        own = RANK[tree.text] if tree.kind == "binary" else len(RANK)
        if tree.in_parentheses or own < rank + is_right or is_mixed(rank, own) and own < len(RANK):
            return f"({text})"
        return text

    # Statements

    def declared(self, variable, ending=";"):
        value = f" = {self.show(variable.value)}" if variable.value else ""
        return f"{self.type(variable.type)} {variable.name}{value}{ending}"

    def assigned(self, step):
        target = self.show(step.target)
        return f"{target} = {self.show(step.value)}" if step.value else target + step.operator

    def block(self, body, depth):
        """The lines of a block, with its last brace."""
        return self.lines(body, depth + 1) + ["    " * depth + "}"]

    def statement(self, it, depth):
        indent = "    " * depth
        if isinstance(it, Declare):
            return wrapped(indent + self.declared(it))
        if isinstance(it, Assign):
            return wrapped(f"{indent}{self.assigned(it)};")
        if isinstance(it, Return):
            return wrapped(f"{indent}return {self.show(it.value)};")
        if isinstance(it, For):
            head = f"{self.declared(it.start)} {self.show(it.condition)}; {self.assigned(it.step)}"
            return wrapped(f"{indent}for ({head}) {{") + self.block(it.body, depth)
        lines, before = [], indent
        for condition, body in it.branches:
            head = f"if ({self.show(condition)}) {{" if condition else "{"
            lines += wrapped(before + head) + self.block(body, depth)
            before = lines.pop() + " else "
        return lines + [indent + "}"]

    # Files

    def defined(self, it):
        return [f"#define SCARP_{it.name} {literal(it.value)}"]

    def member(self, it):
        return f"{self.type(it.type)} {it.name}" + (f"[{it.value.text}];" if it.value else ";")

    def struct(self, it):
        lines = [f"struct {self.type(it.name)} {{"]
        for member in it.members:
            if isinstance(member, Comment):
                remark(lines, member, 1)
            else:
                lines.append("    " + self.member(member))
        return lines + ["};"]

    def head(self, it):
        parameters = ", ".join(self.declared(parameter, "") for parameter in it.parameters)
        return wrapped(f"{self.type(it.type)} scarp_{it.name}({parameters})") + ["{"]

    def lines(self, items, depth=0):
        lines = []
        for it in items:
            if isinstance(it, Comment):
                remark(lines, it, depth)
            elif isinstance(it, Function):
                lines += self.head(it) + self.block(it.body, 0)
            elif isinstance(it, Struct):
                lines += self.struct(it)
            elif isinstance(it, Define):
                lines += self.defined(it)
            else:
                lines += self.statement(it, depth)
        return lines


class Hlsl(Glsl):
    TYPES = {"vec3": "float3", "uvec3": "uint3", "vec4": "float4"}

    def braces(self, type_, parts):
        return f"{{{', '.join(parts)}}}"


class Wgsl(Glsl):
    TYPES = {"float": "f32", "int": "i32", "uint": "u32", "vec3": "vec3f", "uvec3": "vec3u",
             "vec4": "vec4f"}

    # What WGSL has in the place of functions that the heads of the others define
    CALLS = {"vec3_of": "vec3f", "float_of_bits": "bitcast<f32>", "bits_of": "bitcast<u32>",
             "int_of": "bitcast<i32>", "uint_of": "bitcast<u32>", "float_of_int": "f32",
             "float_of_uint": "f32", "whole_of": "i32", "floor_of": "floor", "rough_root": "sqrt",
             "only_basis": "scarp_only_basis_of", "only_fractal": "scarp_only_fractal_of",
             "only_depth": "scarp_only_depth_of"}

    def call(self, name, arguments):
        if name in PICKS.values():
            condition, yes, no = arguments
            return f"select({no}, {yes}, {condition})"
        return f"{self.CALLS.get(name, 'scarp_' + name)}({', '.join(arguments)})"

    def declared(self, variable, ending=";"):
        keyword = "let" if variable.is_const else "var"
        value = f" = {self.show(variable.value)}" if variable.value else ""
        return f"{keyword} {variable.name}: {self.type(variable.type)}{value}{ending}"

    def defined(self, it):
        return [f"const SCARP_{it.name}: {self.type(it.value.type)} = {literal(it.value)};"]

    def member(self, it):
        type_ = self.type(it.type)
        return f"{it.name}: " + (f"array<{type_}, {it.value.text}>," if it.value else f"{type_},")

    def struct(self, it):
        return super().struct(it)[:-1] + ["}"]

    def head(self, it):
        parameters = ", ".join(f"{p.name}: {self.type(p.type)}" for p in it.parameters)
        return wrapped(f"fn scarp_{it.name}({parameters}) -> {self.type(it.type)} {{")


def wrapped(line):
    """A line, broken after commas, "=" and before operators, so that it has at most 100 columns."""
    indent = re.match(" *", line).group(0) + "        "
    lines = []
    while len(line) > 100:
        at = max(m.end() for m in re.finditer(r"\S([,=] | (?=[&^|]+ ))", line[:101]))
        lines.append(line[:at].rstrip())
        line = indent + line[at:]
    return lines + [line]


def remark(lines, comment, depth):
    """Adds a comment, or an empty line."""
    if comment.is_beside:
        lines[-1] += " " + comment.text
    elif comment != BLANK:
        lines += ("    " * depth + comment.text).split("\n")
    elif lines and lines[-1] != "":
        lines.append("")


def titled(items):
    """What a file has, with its opening comment as a title."""
    title = re.search(r"\* (?:Formulas|Shaders): ([^;.]*)[;.]", items[0].text).group(1)
    title = " ".join(title.replace("\n *", " ").split())
    title = textwrap.fill(f"/* {title[0].upper()}{title[1:]}. */", 97, subsequent_indent="   ")
    return [Comment(title)] + items[1:]


def only(name):
    """What a shader takes for a number of its plan that a macro may fix"""
    return (f"uint scarp_only_{name}(uint {name})\n{{\n#ifdef SCARP_ONLY_{name.upper()}\n"
            f"    return SCARP_ONLY_{name.upper()};\n#else\n    return {name};\n#endif\n}}\n")


def shader(language, parts):
    text = (SRC / f"gpu/head.{language}").read_text()
    text = text.replace("@ONLY@\n", "\n".join(map(only, ("basis", "fractal", "depth"))))
    write = {"glsl": Glsl, "hlsl": Hlsl, "wgsl": Wgsl}[language]()
    for name, files in parts.items():
        texts = ["\n".join(write.lines(titled(items))).rstrip() + "\n" for items in files]
        text = text.replace(f"@{name}@\n", "\n".join(texts))
    return text


def main():
    known, stale = known_at_first(), 0
    try:
        parts = {name: [Source(SRC / f"{file}.h", known).file() for file in files]
                 for name, files in (("STRUCTURES", STRUCTURES), ("FUNCTIONS", FUNCTIONS))}
        parts["STRUCTURES"].append(enumerators())
    except Refused as why:
        print(why)
        return 1
    for language in ("glsl", "hlsl", "wgsl"):
        path, text = INCLUDE / f"scarp.{language}", shader(language, parts)
        if sys.argv[1:] != ["--check"]:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            print(f"{path} is not what src/gpu/shaders.py writes")
            stale = 1
    return stale


if __name__ == "__main__":
    sys.exit(main())
