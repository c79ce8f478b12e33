#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes include/scarp.glsl, scarp.hlsl and scarp.wgsl from the C of this directory.

    shaders.py           writes them
    shaders.py --check   says which are not what it would write; exit status 1

c.h says what part of C this understands. head.glsl, head.hlsl and head.wgsl are what each language
needs around it.
"""
import pathlib
import re
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
INCLUDE = HERE.parent.parent / "include"
STRUCTURES = ["plan"]
FUNCTIONS = ["numbers", "lattice", "corners", "gradient", "value", "simplex", "cells", "basis",
             "shape", "bend", "octaves", "noise"]
DEFINED = re.compile(r"static inline (?:struct )?\w+ (\w+)\(")

# What the languages call the types. GLSL has the names of C's typedefs.
TYPES = {
    "glsl": {},
    "hlsl": {"vec3": "float3", "uvec3": "uint3", "vec4": "float4"},
    "wgsl": {"float": "f32", "int": "i32", "uint": "u32", "bool": "bool", "vec3": "vec3f",
             "uvec3": "vec3u", "vec4": "vec4f"},
}

# What WGSL has in the place of functions that the heads of the others define.
WGSL_CALLS = {"vec3_of": "vec3f", "float_of_bits": "bitcast<f32>", "bits_of": "bitcast<u32>",
              "int_of": "bitcast<i32>", "uint_of": "bitcast<u32>", "float_of_int": "f32",
              "float_of_uint": "f32", "whole_of": "i32", "floor_of": "floor", "rough_root": "sqrt",
              "only_basis": "scarp_only_basis_of", "only_fractal": "scarp_only_fractal_of",
              "only_depth": "scarp_only_depth_of"}


def source(name):
    """A file's text, with its opening comment as a title, without what only C needs."""
    text = (HERE / f"{name}.h").read_text()
    title = re.search(r"\* Shaders: ([^;.]*)[;.]", text).group(1)
    title = " ".join(title.replace("\n *", " ").split())
    title = textwrap.fill(f"{title[0].upper()}{title[1:]}. */", 94, subsequent_indent="   ")
    text = re.sub(r"\A/\*.*?\*/\n", f"/* {title}\n", text, flags=re.S)
    text = re.sub(r"(?m)^#(ifndef|include|endif).*\n|^#define \w+_H\n", "", text)
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


def capital(match):
    return "Scarp" + "".join(word.capitalize() for word in match.group(1).split("_"))


def prefixed(text, functions, macros):
    """Names with the prefix of the library: struct place is ScarpPlace, at() is scarp_at()."""
    text = re.sub(r"\bstruct (\w+)(?= \{)", lambda m: "struct " + capital(m), text)
    text = re.sub(r"\bstruct (?!Scarp)(\w+)", capital, text)
    text = re.sub(r"(?<![\w.])(" + "|".join(functions) + r")(?=\()", r"scarp_\1", text)
    return re.sub(r"(?<![\w.])(" + "|".join(macros) + r")\b", r"SCARP_\1", text)


def like_c(text, types):
    """GLSL and HLSL: local constants are variables, since GLSL ES wants constants to be known."""
    text = text.replace("static inline ", "")
    text = re.sub(r"(?m)^(\s+)const ", r"\1", text)
    for name, other in types.items():
        text = re.sub(rf"\b{name}\b", other, text)
    return text


def wgsl(text, types):
    for name, other in WGSL_CALLS.items():
        text = re.sub(rf"\bscarp_{name}(?=\()", other, text)
    text = re.sub(r"\bscarp_pick\w*\(", "scarp_pick(", text)
    kind = r"(" + "|".join(types) + r"|Scarp\w+)"

    def typed(name):
        return types.get(name, name)

    def members(match):
        body = re.sub(rf"(?m)^    {kind} (\w+)\[(\d+)\];",
                      lambda m: f"    {m[2]}: array<{typed(m[1])}, {m[3]}>,", match[2])
        body = re.sub(rf"(?m)^    {kind} (\w+);", lambda m: f"    {m[2]}: {typed(m[1])},", body)
        return match[1] + body + "}"

    def function(match):
        parameters = re.sub(rf"{kind} (\w+)", lambda m: f"{m[2]}: {typed(m[1])}", match[3])
        parameters = " ".join(parameters.split())
        return f"fn {match[2]}({parameters}) -> {typed(match[1])} {{"

    text = re.sub(r"(struct \w+ \{\n)(.*?)\};", members, text, flags=re.S)
    text = re.sub(rf"static inline {kind} (\w+)\(([^)]*)\)\n\{{", function, text)
    text = re.sub(r"(?m)^#define (\w+) (\S+u)$", r"const \1: u32 = \2;", text)
    text = re.sub(r"(?m)^#define (\w+) (\S+f)$", r"const \1: f32 = \2;", text)
    text = re.sub(rf"(?m)^(\s+)const {kind} (\w+) =",
                  lambda m: f"{m[1]}let {m[3]}: {typed(m[2])} =", text)
    text = re.sub(rf"(?m)^(\s+){kind} (\w+)( =|;)",
                  lambda m: f"{m[1]}var {m[3]}: {typed(m[2])}{m[4]}", text)
    text = re.sub(rf"for \({kind} (\w+) =", lambda m: f"for (var {m[2]}: {typed(m[1])} =", text)
    return text


def picks(text):
    """scarp_pick(a, b, c) of WGSL is select(c, b, a)."""
    while "scarp_pick(" in text:
        start = text.rindex("scarp_pick(")  # none is inside of its arguments
        at, depth, arguments = start + len("scarp_pick("), 0, [""]
        while depth >= 0:
            c = text[at]
            depth += (c == "(") - (c == ")")
            if depth < 0:
                break
            if c == "," and depth == 0:
                arguments.append("")
            else:
                arguments[-1] += c
            at += 1
        condition, yes, no = (" ".join(argument.split()) for argument in arguments)
        text = f"{text[:start]}select({no}, {yes}, {condition}){text[at + 1:]}"
    return text


def wrapped(line):
    """A line, broken after commas, "=" and before operators, so that it has at most 100 columns."""
    indent = re.match(" *", line).group(0) + "        "
    lines = []
    while len(line) > 100:
        at = max(m.end() for m in re.finditer(r"\S([,=] | (?=[&^|]+ ))", line[:101]))
        lines.append(line[:at].rstrip())
        line = indent + line[at:]
    return lines + [line]


def laid_out(text):
    """The statements of a text, laid out for the names that they have now."""
    lines, statement = [], ""
    for line in text.split("\n"):
        if not statement and line.lstrip().startswith(("#", "/*", "*")):
            lines.append(line)
            continue
        statement = f"{statement} {line.strip()}" if statement else line
        unfinished = statement.count("(") > statement.count(")") or statement[-1:] in tuple("=^|&")
        if not unfinished:
            lines += wrapped(statement)
            statement = ""
    return "\n".join(lines)


def shader(language):
    hooks = DEFINED.findall((HERE / "c.h").read_text())
    parts = ["\n".join(map(source, names)) for names in (STRUCTURES, FUNCTIONS)]
    functions = hooks + DEFINED.findall("".join(parts))
    macros = re.findall(r"#define (\w+) ", "".join(parts))
    text = (HERE / f"head.{language}").read_text()
    for name, part in zip(("@STRUCTURES@", "@FUNCTIONS@"), parts):
        part = prefixed(part, functions, macros)
        types = TYPES[language]
        part = picks(wgsl(part, types)) if language == "wgsl" else like_c(part, types)
        text = text.replace(name + "\n", laid_out(part))
    return text


def main():
    stale = 0
    for language in TYPES:
        path, text = INCLUDE / f"scarp.{language}", shader(language)
        if sys.argv[1:] != ["--check"]:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            print(f"{path} is not what src/gpu/shaders.py writes")
            stale = 1
    return stale


sys.exit(main())
