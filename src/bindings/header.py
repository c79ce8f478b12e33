# SPDX-License-Identifier: MIT
"""Reads what include/scarp.h declares: enumerators, structures with the offsets of their members,
calls. It knows the header's own style, and no more of C.

Offsets are given for pointers of 4 bytes (WebAssembly) and of 8 bytes, where doubles lie at
multiples of 8 bytes. They do not on 32-bit x86, so some offsets differ there.
"""
import re
import sys

SIZES = {"char": 1, "unsigned char": 1, "int": 4, "int32_t": 4, "uint32_t": 4, "float": 4,
         "int64_t": 8, "uint64_t": 8, "double": 8}


def fail(message):
    sys.exit("interface.py: " + message)


def plain(text):
    """The header without comments, directives and the words of C++."""
    text = re.sub(r"(?s)/\*.*?\*/", " ", text)
    text = re.sub(r"(?m)^[ \t]*#(?:.*\\\n)*.*$", "", text)
    return text.replace('extern "C" {', "")


def commented(body):
    """The lines of a structure, each with its comment: behind it on its line, or before it."""
    found, comment = [], ""
    for part in re.findall(r"(?s)/\*.*?\*/|(?:(?!/\*)[^;])+;[ \t]*(?:/\*.*?\*/)?", body):
        if part.startswith("/*"):
            comment = part
            continue
        line, _, behind = part.partition("/*")
        found.append((line.strip().rstrip(";"), behind or comment))
        comment = ""
    return found


def default(comment):
    """What a comment says as `Default 2.`; None if it says nothing of the kind."""
    said = re.search(r"\bDefault\s+(-?[0-9.]*[0-9])", comment)
    return float(said.group(1)) if said else None


def titles(text):
    """What comments say of functions: `scarp_name - this`, up to the first empty line."""
    found = re.findall(r"(?s)/\*\s+(?:\* )?(\w+) - (.*?)\s*(?:\n \*\n|\*/)", text)
    return {name: " ".join(re.sub(r"\n \* ?", " ", title).split()) for name, title in found}


def number(text):
    """2^-24, -2^10, 1/16 or 0.5 as a number; None for anything else."""
    power = re.fullmatch(r"(-?)2\^(-?\d+)", text)
    if power:
        return float(power.group(1) + "1") * 2.0 ** int(power.group(2))
    quotient = re.fullmatch(r"(-?[0-9.]*[0-9])(?:/(\d+))?", text)
    return float(quotient.group(1)) / float(quotient.group(2) or 1) if quotient else None


def intervals(comment):
    """The intervals of numbers that a comment says, as `[1/16, 16]` or `(0, 32]`, as pairs."""
    found = [tuple(map(number, pair)) for pair in re.findall(
        r"[\[(]([-0-9^./]+),\s+([-0-9^./]+)\]", comment)]
    return [pair for pair in found if None not in pair]


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


def both(four, eight):
    """A number for pointers of 4 bytes and of 8; one if they are the same."""
    return four if four == eight else (four, eight)


class Header:
    """What the header declares."""

    def __init__(self, text):
        self.version = ".".join(re.findall(
            r"#define SCARP_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text))
        self.constants = {name: int(value) for name, value in re.findall(
            r"(?m)^#define (SCARP_\w+) \(?(-?\d+)\)?(?: /\*.*)?$", text)}
        self.enums, self.structures, self.functions = {}, {}, {}
        self.titles = titles(text)
        bodies = dict(re.findall(r"(?ms)^struct (\w+) \{\n(.*?)^\};", text))
        text = plain(text)
        for name, body in re.findall(r"\benum (\w+) \{([^}]*)\};", text):
            self.enums[name] = self.enumerators(body)
        for name, body in bodies.items():
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
        members = [{"name": name, "type": kind, "expressions": dimensions,
                    "default": default(comment), "intervals": intervals(comment),
                    "comment": " ".join(re.sub(r"/\*|\*/", " ", comment).split())}
                   for line, comment in commented(body)
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
