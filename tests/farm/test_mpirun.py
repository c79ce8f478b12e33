# SPDX-License-Identifier: MIT
"""mpirun starts four processes; when one is killed it ends them all, and a second run completes the
world."""
import os
import signal

from farm import check, main, need, tell


def test(new_farm):
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
    tell("kill -9 of share %s: %s" % (victim.share(), farm.story()))
    victim.signal(signal.SIGKILL)
    status = run.wait()
    check(status != 0, "mpirun does not say that a process died")
    tell("mpirun has ended with %d: %s" % (status, farm.story()))
    farm.run("Open MPI")
    tell("mpirun again, to its end: " + farm.story())
    farm.check_complete()


main(test)
