# SPDX-License-Identifier: MIT
"""A real Slurm, whose node2 loses its power in the middle of the array; and srun.

The cluster is three nodes on this machine, made by slurm.sh. Its daemons are always ended.
"""
import glob
import os
import re
import subprocess

from farm import REQUIRED, check, main, need, skip, tell, wait_for
from rasters import read_bytes

HERE = os.path.dirname(os.path.abspath(__file__))
NODE = "node2"
# Two tasks of four CPUs run at once on a node.
NODES, CPUS = 3, 8


class Cluster:
    def __init__(self, farm):
        self.farm = farm
        self.directory = farm.path(os.pardir, "cluster")
        farm.environment["SLURM_CONF"] = os.path.join(self.directory, "slurm.conf")

    def do(self, *words):
        subprocess.run([os.path.join(HERE, "slurm.sh"), self.directory, *map(str, words)],
                       env=self.farm.environment, stdout=subprocess.DEVNULL, check=True)

    def tasks(self, array=None):
        """The tasks of all arrays, or one: dictionaries of what scontrol prints"""
        text = self.farm.output("scontrol", "show", "job", "--oneliner").decode()
        found = [dict(re.findall(r"(\w+)=(\S*)", line)) for line in text.splitlines()
                 if "JobId=" in line]
        return [task for task in found if array in (None, int(task.get("ArrayJobId", 0)))]

    def queued(self):
        text = self.farm.output("squeue", "--noheader", "--array", "--format=%F_%K %T")
        return text.decode().splitlines()

    def node_state(self):
        text = self.farm.output("sinfo", "--noheader", "--nodes=" + NODE, "--format=%T")
        return text.decode().strip()

    def explain(self):
        """For those who read of a failure"""
        for name in ("slurmctld.log", NODE + ".log"):
            text = read_bytes(os.path.join(self.directory, name)).decode(errors="replace")
            print("the end of %s:" % name, *text.splitlines()[-30:], sep="\n")
        for path in sorted(glob.glob(self.farm.path("slurm-*.out"))):
            print("%s: %s" % (path, read_bytes(path).decode(errors="replace")))


def on_node(process):
    return process.environment("SLURMD_NODENAME") == NODE


def names(tasks):
    return ", ".join(sorted((task["ArrayTaskId"] for task in tasks), key=int))


def run_array(farm, cluster):
    """The array, with a power cut at node2; returns the numbers of both jobs."""
    with open(farm.path("world.sbatch"), "w", encoding="utf-8") as file:
        file.write(farm.recipes["world.sbatch"])
    farm.run("Slurm")
    first, second = sorted({int(task["ArrayJobId"]) for task in cluster.tasks()})
    farm.output("scontrol", "hold", str(second))  # to see what the first leaves for it
    victim = farm.victim(on_node)
    cut = [process.share().partition("/")[0] for process in farm.processes()
           if on_node(process) and process.stop()]
    cluster.do("kill", NODE)
    tell("%s loses its power: slurmd, slurmstepd and scarp (tasks %s; process %d was in the middle "
         "of a tile) are killed with -9; %s" % (NODE, ", ".join(sorted(cut, key=int)), victim.pid,
                                                farm.story()))
    wait_for(lambda: cluster.node_state().startswith("down"), "Slurm to miss %s" % NODE)
    again = [task for task in cluster.tasks(first) if int(task["Restarts"]) > 0]
    check(set(cut) <= {task["ArrayTaskId"] for task in again}, "requeued were only tasks",
          names(again))
    tell("Slurm has missed it and requeued tasks %s; %s" % (names(again), farm.story()))
    cluster.do("node", NODE)
    wait_for(lambda: cluster.node_state() in ("idle", "mixed", "allocated"), "its return")
    tell("%s has its power back" % NODE)
    wait_for(lambda: not any(line.startswith("%d_" % first) for line in cluster.queued()),
             "the end of the array", 120)
    return first, second


def check_array(farm, cluster, first, second):
    tasks = cluster.tasks(first)
    check(len(tasks) == 16 and {task["JobState"] for task in tasks} == {"COMPLETED"},
          "tasks and their ends:", [(task["ArrayTaskId"], task["JobState"]) for task in tasks])
    tell("all 16 tasks are completed; requeued were %s; %s" % (
        names([task for task in tasks if int(task["Restarts"]) > 0]), farm.story()))
    check(farm.tiles() == farm.all_tiles(), "the array leaves tiles out:", farm.story())
    before = {path: state for path, state in farm.state().items() if "slurm-" not in path}
    farm.output("scontrol", "release", str(second))
    wait_for(lambda: not cluster.queued(), "the end of the second array", 120)
    check({task["JobState"] for task in cluster.tasks(second)} == {"COMPLETED"}, "the second array")
    check({path: state for path, state in farm.state().items() if "slurm-" not in path} == before,
          "the second array writes files")
    tell("the second array has found nothing to do")


def check_steps(farm):
    """srun, and what the document says of -n without it"""
    farm.run("srun")
    tell("srun has run four tasks: " + farm.story())
    farm.output("sbatch", "--wait", "-n", "3", "--output=tasks.txt", "--wrap",
                "echo SLURM_NTASKS=$SLURM_NTASKS")
    check(read_bytes(farm.path("tasks.txt")) == b"SLURM_NTASKS=3\n", "sbatch -n 3 without srun")
    tell("sbatch -n 3 without srun has run once, with SLURM_NTASKS=3")
    gap = farm.start_shell(farm.recipes["world.sbatch"], SLURM_ARRAY_TASK_ID="7",
                           SLURM_ARRAY_TASK_MIN="3", SLURM_ARRAY_TASK_COUNT="2",
                           SLURM_CPUS_PER_TASK="1")
    check(gap.wait() == 2, "the second task of --array=3,7 is not refused")
    farm.check_complete()


def test(new_farm):
    if not REQUIRED:
        skip("starts daemons, which SCARP_TEST_FARM=1 in the environment allows")
    os.environ["PATH"] += os.pathsep + "/usr/sbin" + os.pathsep + "/sbin"
    need("munged", "munge", "slurmctld", "slurmd", "sbatch", "srun", "scontrol", "sinfo", "squeue")
    farm = new_farm("slurm")
    cluster = Cluster(farm)
    passed = False
    try:
        cluster.do("start", NODES, CPUS)
        tell("a cluster of %d nodes is up" % NODES)
        check_array(farm, cluster, *run_array(farm, cluster))
        farm.check_complete()
        steps = new_farm("srun", slow=False, layers=())
        Cluster(steps)
        check_steps(steps)
        passed = True
    finally:
        if not passed:
            cluster.explain()
        cluster.do("stop")


main(test)
