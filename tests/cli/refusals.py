# SPDX-License-Identifier: MIT
"""Many refusals by one process: test_cli_refused (refused.c)."""
import os
import subprocess


def refusals(program, cases):
    """What test_cli_refused, which is next to the program, says of each case, a list of words: what
    came of it, how many errors there were, and the last. None where it was not built."""
    ending = ".exe" if program[-1].endswith(".exe") else ""
    beside = os.path.join(os.path.dirname(program[-1]), "test_cli_refused" + ending)
    if not os.path.exists(beside):
        return None
    words = [[word if isinstance(word, bytes) else word.encode() for word in case] for case in cases]
    data = b"".join(b"%d " % len(case) + b"".join(b"%d %s " % (len(word), word) for word in case)
                    for case in words)
    result = subprocess.run(program[:-1] + [beside], input=data, stdout=subprocess.PIPE,
                            timeout=300, check=True)
    lines = result.stdout.decode(errors="replace").split("\n")
    assert len(lines) == len(cases) + 1 and lines[-1] == "", (len(lines), len(cases))
    return [(came, int(count), error) for came, count, error in
            (line.split(" ", 2) for line in lines[:-1])]
