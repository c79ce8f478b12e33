# SPDX-License-Identifier: MIT
"""The Job's container, run for every index as Kubernetes would; one is killed and gets a successor.

Without Kubernetes: this tries what the YAML says about the command and its environment.
"""
import signal

from farm import check, main, skip, tell, wait_for

try:
    import yaml
except ImportError:
    yaml = None


def container(text):
    """The shell's script and the environment, from the text of the Job."""
    job = yaml.safe_load(text)
    check(job["apiVersion"] == "batch/v1" and job["kind"] == "Job", "it is a Job of batch/v1")
    spec = job["spec"]
    pod = spec["template"]["spec"]
    check(spec["completionMode"] == "Indexed" and pod["restartPolicy"] == "Never", "it is indexed")
    box, = pod["containers"]
    check(box["command"] == ["sh", "-c"] and len(box["args"]) == 1, "a shell runs one script")
    check("$(" not in box["args"][0], "Kubernetes would replace $(NAME) itself")
    environment = {}
    for variable in box["env"]:
        value = variable.get("value")
        if value is None:
            source = variable["valueFrom"]["resourceFieldRef"]["resource"]
            check(source == "limits.cpu", "where the environment comes from:", source)
            value = box["resources"]["limits"]["cpu"]
        environment[variable["name"]] = value
    check(environment["SHARES"] == str(spec["completions"]), "one share per completion")
    mount, = box["volumeMounts"]
    volume, = pod["volumes"]
    check(mount["name"] == volume["name"] and mount["mountPath"] == box["workingDir"],
          "it works in the volume")
    return box["args"][0], environment, spec["completions"]


def test(new_farm):
    if yaml is None:
        skip("not installed: Python's yaml")
    farm = new_farm("kubernetes")
    script, environment, count = container(farm.recipes["Kubernetes"])

    def start(index):
        return farm.start_shell(script, JOB_COMPLETION_INDEX=str(index), **environment)
    pods = [start(index) for index in range(count)]
    victim = farm.victim()
    index = int(victim.environment("JOB_COMPLETION_INDEX"))
    check(victim.share() == "%d/%d" % (index, count), "its share:", victim.share())
    tell("kill -9 of share %s: %s" % (victim.share(), farm.story()))
    victim.signal(signal.SIGKILL)
    wait_for(lambda: pods[index].poll() is not None, "its end")
    pods[index] = start(index)
    ends = [pod.wait() for pod in pods]
    check(ends == [0] * count, "how they ended:", ends)
    tell("it has a successor, and all have ended: " + farm.story())
    farm.check_complete()


main(test)
