# SPDX-License-Identifier: MIT
"""Text that the tables of all languages need: lines, and marked parts of files."""
import sys
import textwrap

MADE = "made by src/bindings/interface.py of include/scarp.h: do not change them by hand"


def wrapped(first, text, after, width=100, code="``"):
    """Lines that begin with `first`, and with `after` from the second one on. Code, which is in
    backticks, is not broken; `code` is what marks it in a language."""
    parts = text.split("`")
    for i in range(1, len(parts), 2):
        parts[i] = code[0] + parts[i].replace(" ", "\0") + code[1]
    lines = textwrap.wrap("".join(parts), width, initial_indent=first, subsequent_indent=after,
                          break_long_words=False, break_on_hyphens=False)
    return [line.replace("\0", " ") for line in lines]


def replaced(path, text, name, lines):
    """The text with other lines between the line that has <name> and the one that has </name>."""
    before, first, rest = text.partition("<%s>" % name)
    line, _, rest = rest.partition("\n")
    _, last, after = rest.partition("</%s>" % name)
    if not first or not last:
        sys.exit("%s has no part <%s> that ends with </%s>" % (path, name, name))
    comment = before[before.rfind("\n") + 1:]
    return before + first + line + "\n" + "\n".join(lines) + "\n" + comment + last + after
