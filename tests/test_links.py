# SPDX-License-Identifier: MIT
"""The documents hold together: every relative link and picture in every *.md exists, anchors
included, and the table of calls has every public function.

    test_links.py SOURCE_DIR
"""
import os
import re
import sys

# Documents that a reader starts from; the test must not pass because it found none.
EXPECTED = {"README.md", "CHANGELOG.md", "bench/README.md", "bench/results.md", "src/README.md",
            "src/cli/README.md", "src/examples/README.md", "src/gpu/README.md"}


def documents(source):
    """The Markdown files of the tree, without hidden directories and those of builds."""
    for folder, folders, names in os.walk(source):
        folders[:] = [name for name in folders if not name.startswith(".") and
                      not os.path.exists(os.path.join(folder, name, "CMakeCache.txt"))]
        for name in names:
            if name.endswith(".md"):
                yield os.path.relpath(os.path.join(folder, name), source)


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def prose(text):
    """The text without fenced blocks, code in a line, and comments, which have no links."""
    text = re.sub(r"(?ms)^```.*?^```$", "", text)
    text = re.sub(r"(?s)<!--.*?-->", "", text)
    return re.sub(r"`[^`\n]*`", lambda code: "x" * len(code.group(0)), text)


def anchors(text):
    """The names that pages of Markdown give to headings: letters, digits, - and _, in lower case."""
    found = set()
    without_code = re.sub(r"(?ms)^```.*?^```$", "", text)
    for heading in re.findall(r"(?m)^#{1,6} +(.*?) *$", without_code):
        name = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", name).replace(" ", "-")
        number = 0
        while name + ("-%d" % number if number else "") in found:
            number += 1
        found.add(name + ("-%d" % number if number else ""))
    return found


def check_links(source, names):
    """Complaints, and how many links there were."""
    complaints, count = [], 0
    heads = {}
    for name in names:
        text = read(source, name)
        for target in re.findall(r"\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)", prose(text)):
            if re.match(r"[a-z][a-z0-9+.-]*:", target):
                continue
            count += 1
            path, _, anchor = target.partition("#")
            full = os.path.normpath(os.path.join(os.path.dirname(name), path)) if path else name
            if not os.path.exists(os.path.join(source, full)):
                complaints.append("%s: there is no %s" % (name, target))
            elif anchor and full.endswith(".md"):
                if full not in heads:
                    heads[full] = anchors(read(source, full))
                if anchor not in heads[full]:
                    complaints.append("%s: no heading of %s is called #%s" % (name, full, anchor))
    return complaints, count


def check_calls(source):
    """Each public function is in one row of the table of calls, and no other name."""
    header = re.sub(r"(?s)/\*.*?\*/", "", read(source, "include", "scarp.h"))
    public = re.findall(r"(?m)^SCARP_API [^;]*?(scarp_\w+)\(", header)
    table = read(source, "src", "calls", "README.md")
    told = [name for row in re.findall(r"(?m)^\| (`scarp_[^|]*) \|", table)
            for name in re.findall(r"`(scarp_\w+)`", row)]
    complaints = ["src/calls/README.md: the table has no " + name
                  for name in sorted(set(public) - set(told))]
    complaints += ["src/calls/README.md: the table has %s, which is not public" % name
                   for name in sorted(set(told) - set(public))]
    complaints += ["src/calls/README.md: the table has %s %d times" % (name, told.count(name))
                   for name in sorted(set(told)) if told.count(name) > 1]
    return complaints, len(public)


def main():
    source = sys.argv[1]
    names = sorted(documents(source))
    complaints = ["there is no " + name for name in sorted(EXPECTED - set(names))]
    broken, links = check_links(source, names)
    wrong, calls = check_calls(source)
    complaints += broken + wrong
    if links < 60 or calls < 40:
        complaints.append("only %d links and %d calls were found" % (links, calls))
    print("\n".join(complaints + ["%d documents, %d links, %d calls" % (len(names), links, calls)]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
