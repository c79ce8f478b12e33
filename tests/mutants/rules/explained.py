# SPDX-License-Identifier: MIT
"""Reads explained.txt: why mutations that no test notices are none that one could notice."""
import sys


def read_explained(path):
    """{(file, line's text, before, after): reason}; see the top of explained.txt."""
    reasons, file_name, entry = {}, None, []
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n") + [""]
    for line in lines:
        if line.startswith("#"):
            continue
        if line and line[0] != " ":
            file_name = line.strip()
        elif line.strip():
            entry.append(line.strip())
        elif entry:
            if len(entry) < 3 or " ==> " not in entry[1] and entry[1] != "*":
                sys.exit("explained.txt: not a line, a mutation and a reason: %s" % entry)
            before, after = ("*", "*") if entry[1] == "*" else entry[1].split(" ==> ", 1)
            reasons[file_name, entry[0], before, after] = " ".join(entry[2:])
            entry = []
    return reasons


def key_of(m):
    """What stays the same of a mutation when other lines change."""
    return m.file, m.source, m.before, m.after


def keys_of(m):
    """The keys of explanations that are about it."""
    yield key_of(m)
    yield m.file, m.source, "*", "*"


def reason_of(mutation, reasons):
    return next((reasons[key] for key in keys_of(mutation) if key in reasons), None)
