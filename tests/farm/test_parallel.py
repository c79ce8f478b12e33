# SPDX-License-Identifier: MIT
"""GNU parallel starts a share again whose process was killed."""
import signal

from farm import check, main, need, tell


def test(new_farm):
    need("parallel")
    farm = new_farm("parallel")
    if b"GNU parallel" not in farm.output("parallel", "--version"):
        need("parallel of GNU")
    run = farm.start("GNU parallel")
    victim = farm.victim()
    tell("kill -9 of share %s: %s" % (victim.share(), farm.story()))
    victim.signal(signal.SIGKILL)
    status = run.wait()
    check(status == 0, "parallel ends with", status)
    tell("parallel has started it again, and ended: " + farm.story())
    farm.check_complete()


main(test)
