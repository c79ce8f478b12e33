# SPDX-License-Identifier: MIT
"""Processes that share a world, one of which is killed.

    test_killed.py NAME PROGRAM DOCUMENT SCRATCH LIBRARY    LIBRARY makes all locks fail
"""
import os
import re
import signal
import sys

from farm import check, main, need, tell, wait_for


def kill(farm, victim, name):
    tell("kill -9 of %s: %s" % (name, farm.story()))
    victim.signal(signal.SIGKILL)


def same(new_farm):
    """Four equal commands without an index share a world; one is killed half way and started again."""
    farm = new_farm("same")
    runs = [farm.start("The simplest farm") for _ in range(4)]
    wait_for(lambda: farm.tiles() > farm.all_tiles() // 2, "half of the tiles")
    victim = farm.victim()
    kill(farm, victim, "process %d, which writes %s" % (
        victim.pid, ", ".join(path.rpartition("/")[2] for path in victim.writes())))
    wait_for(lambda: any(run.poll() is not None for run in runs), "its end")
    runs.append(farm.start("The simplest farm"))
    tell("started again")
    ends = sorted(run.wait() != 0 for run in runs)
    check(ends == [False] * 4 + [True], "how the runs ended:", [run.returncode for run in runs])
    tell("all have ended: " + farm.story())
    farm.check_complete()


def locks(new_farm):
    """Where no file can be locked, equal commands do some work twice, and the world is right."""
    farm = new_farm("locks", layers=(), tile=160, size=(1250, 1310))
    command = farm.recipes["The simplest farm"].replace(" --quiet", "")
    numbers = []
    for environment in ({}, {"LD_PRELOAD": sys.argv[4]}):
        farm.clear()
        runs = [farm.start_shell(command, **environment) for _ in range(4)]
        if environment:
            victim = farm.victim()
            kill(farm, victim, "process %d" % victim.pid)
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


def mpirun(new_farm):
    """mpirun starts four processes; when one is killed it ends them all, and a second run completes the
    world."""
    need("mpirun")
    farm = new_farm("mpirun")
    # More processes than cores; and root, as whom it does not like to run
    farm.environment["OMPI_MCA_rmaps_base_oversubscribe"] = "1"
    if os.geteuid() == 0:
        farm.environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    if b"Open MPI" not in farm.output("mpirun", "--version"):
        need("mpirun of Open MPI")
    run = farm.start("Open MPI")
    victim = farm.victim()
    shares = sorted(process.share() or "none" for process in farm.processes())
    check(shares == ["%d/4" % i for i in range(4)], "shares of the processes:", shares)
    kill(farm, victim, "share %s" % victim.share())
    status = run.wait()
    check(status != 0, "mpirun does not say that a process died")
    tell("mpirun has ended with %d: %s" % (status, farm.story()))
    farm.run("Open MPI")
    tell("mpirun again, to its end: " + farm.story())
    farm.check_complete()


def parallel(new_farm):
    """GNU parallel starts a share again whose process was killed."""
    need("parallel")
    farm = new_farm("parallel")
    if b"GNU parallel" not in farm.output("parallel", "--version"):
        need("parallel of GNU")
    run = farm.start("GNU parallel")
    victim = farm.victim()
    kill(farm, victim, "share %s" % victim.share())
    status = run.wait()
    check(status == 0, "parallel ends with", status)
    tell("parallel has started it again, and ended: " + farm.story())
    farm.check_complete()


main({"same": same, "locks": locks, "mpirun": mpirun, "parallel": parallel}[sys.argv.pop(1)])
