#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the rows of functions in README.md, beside this file, from ../plan/functions.def.

    table.py           writes them
    table.py --check   says if they are not current; exit status 1

The rows are those of one table, from the first that begins with a function of functions.def on.
"""
import pathlib
import re
import sys

ROOM = pathlib.Path(__file__).resolve().parent
DEFINITIONS = ROOM.parent / "plan" / "functions.def"
README = ROOM / "README.md"
TOKEN = re.compile(r'\s*("(?:[^"\\]|\\.)*"|[(),]|[^\s"(),]+)')


def arguments_of(text, at):
    """The arguments of a macro whose ( is at a place, and where it ends. A list of lists of tokens, in
    which a macro with its arguments is a pair."""
    found, at = [[]], at + 1
    while True:
        token = TOKEN.match(text, at)
        if token[1] == "(":
            inner, at = arguments_of(text, token.start(1))
            name = found[-1].pop() if found[-1] else ""
            found[-1].append((name, inner))
            continue
        at = token.end()
        if token[1] == ")":
            return found, at
        if token[1] == ",":
            found.append([])
        else:
            found[-1].append(token[1])


def plain(tokens):
    """What an argument is: strings put together, or a word."""
    return "".join(token[1:-1] if token.startswith('"') else token for token in tokens)


def expression_of(name, arguments):
    """A call with its arguments and defaults."""
    shown = []
    for (kind, values), in arguments:
        word = plain(values[0])
        if kind == "KNOTS":
            shown += ["x: %s" % plain(values[1]).split(",")[0][3:]] * 2 + ["..."]
        elif kind == "NUMBER":
            shown.append("%s=%g" % (word, float(plain(values[1]))))
        else:
            shown.append(word)
    return "%s(%s)" % (name, ", ".join(shown))


def rows_of(text):
    """The rows of functions that have a value in the table."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    text = re.sub(r"^#.*(?:\\\n.*)*\n", "", text, flags=re.M)
    for row in re.finditer(r"^(FUNCTION|WORD)\(", text, flags=re.M):
        columns, _ = arguments_of(text, row.end() - 1)
        value, derivative, interval, smoothness = [plain(column) for column in columns[-4:]]
        if value:
            (_, arguments), = columns[-6]
            yield "| `%s` | %s | %s | %s | %s |" % (expression_of(plain(columns[1]), arguments), value,
                                                    derivative, interval, smoothness)


def main():
    rows = [row.replace("|  |", "| |") for row in rows_of(DEFINITIONS.read_text())]
    first = rows[0].split("(")[0] + "("
    before = README.read_text()
    at = before.index(first)
    end = before.index("\n\n", at)
    after = before[:at] + "\n".join(rows) + before[end:]
    if after != before and sys.argv[1:] == ["--check"]:
        sys.exit("the table of functions in %s is not current: run %s" % (README, __file__))
    if after != before:
        README.write_text(after)


main()
