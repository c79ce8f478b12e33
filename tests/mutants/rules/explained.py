# SPDX-License-Identifier: MIT
"""Reads explained.txt: why mutations that no test notices are none that one could notice."""
import sys

ANY = ""  # in place of the name of a function: the line is in no other

def read_explained(path):
    """{a key of keys_of: reason}; see the top of explained.txt."""
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
            functions = entry.pop(0)[len("in "):].split(", ") if entry[0].startswith("in ") else [ANY]
            key, reason = key_and_reason(entry)
            for function in functions:
                reasons[(file_name, function, *key)] = reason
            entry = []
    return reasons


def key_and_reason(entry):
    if entry[0].startswith("function ") and len(entry) > 1:
        return (entry[0], "*", "*"), " ".join(entry[1:])
    if len(entry) > 2 and entry[1] == "*":
        return (entry[0], "*", "*"), " ".join(entry[2:])
    if len(entry) > 2 and " ==> " in entry[1]:
        return (entry[0], *entry[1].split(" ==> ", 1)), " ".join(entry[2:])
    sys.exit("explained.txt: neither a line, a mutation and a reason, nor a function and a reason: %s" % entry)


def key_of(m):
    """What stays the same of a mutation when other lines change."""
    return m.file, m.source, m.before, m.after, m.twin


def keys_of(m):
    """The keys of explanations that are about it."""
    for function in (m.function, ANY):
        yield m.file, function, m.source, m.before, m.after
        yield m.file, function, m.source, "*", "*"
    yield m.file, ANY, "function " + m.function, "*", "*"


def ambiguous(reasons, mutations):
    """The keys that name no function, though their line is in several."""
    functions = {}
    for m in mutations:
        for key in keys_of(m):
            functions.setdefault(key, set()).add(m.function)
    return [key for key in reasons if key[1] == ANY and len(functions.get(key, ())) > 1]


def reason_of(mutation, reasons):
    return next((reasons[key] for key in keys_of(mutation) if key in reasons), None)
