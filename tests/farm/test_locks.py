# SPDX-License-Identifier: MIT
"""Where no file can be locked, equal commands do some work twice, and the world is right.

    test_locks.py PROGRAM DOCUMENT SCRATCH LIBRARY    LIBRARY makes all locks fail
"""
import re
import signal
import sys

from farm import check, main, tell, wait_for


def test(new_farm):
    farm = new_farm("locks", layers=(), tile=160, size=(1250, 1310))
    command = farm.recipes["The simplest farm"].replace(" --quiet", "")
    numbers = []
    for environment in ({}, {"LD_PRELOAD": sys.argv[4]}):
        farm.clear()
        runs = [farm.start_shell(command, **environment) for _ in range(4)]
        if environment:
            victim = farm.victim()
            tell("kill -9 of process %d: %s" % (victim.pid, farm.story()))
            victim.signal(signal.SIGKILL)
            wait_for(lambda: any(run.poll() is not None for run in runs), "its end")
            runs.append(farm.start_shell(command, **environment))
        printed = [run.communicate()[0].decode() for run in runs]
        check(sum(run.returncode != 0 for run in runs) == len(environment), "how they ended:",
              printed)
        numbers.append(sum(map(int, re.findall(r"(?m)^(\d+) tiles?,", "".join(printed)))))
        tell("%s locks, all have ended: %s; so many were made: %d" % (
            "without" if environment else "with", farm.story(), numbers[-1]))
    total = farm.all_tiles()
    check(numbers[0] < total + 17, "with locks, tiles were made more than once")
    check(numbers[1] > total, "the library does not keep locks away")
    farm.check_complete()


main(test)
