# SPDX-License-Identifier: MIT
"""Four equal commands without an index share a world; one is killed half way and started again."""
import signal

from farm import check, main, tell, wait_for


def test(new_farm):
    farm = new_farm("same")
    runs = [farm.start("The simplest farm") for _ in range(4)]
    wait_for(lambda: farm.tiles() > farm.all_tiles() // 2, "half of the tiles")
    victim = farm.victim()
    tell("kill -9 of process %d, which writes %s: %s" % (
        victim.pid, ", ".join(path.rpartition("/")[2] for path in victim.writes()), farm.story()))
    victim.signal(signal.SIGKILL)
    wait_for(lambda: any(run.poll() is not None for run in runs), "its end")
    runs.append(farm.start("The simplest farm"))
    tell("started again")
    ends = sorted(run.wait() != 0 for run in runs)
    check(ends == [False] * 4 + [True], "how the runs ended:", [run.returncode for run in runs])
    tell("all have ended: " + farm.story())
    farm.check_complete()


main(test)
