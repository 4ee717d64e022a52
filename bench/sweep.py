#!/usr/bin/env python3
"""What a sweep takes beside its tasks, and how near its model comes to what is measured.

script/bench --sweep [TASKS]

Random programs (10 ms each, about) on 1, 2 and 4 processes alone and on 1, 2 and 4 ranks of MPI. Printed of each:

tasks       processor time of all tasks, as the shards have it, s
beyond      processor time of everything that was started, mpirun too, less that of the tasks, over that of the tasks
run         from the first task's begin to the last one's end, s
own         the model's time for it, from this sweep's own tasks, and by how much that differs
one         the same, from the tasks as one process alone has measured them

Other work on the computer makes runs longer and leaves processor time nearly as it is.
"""

import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

PROCESSES = (1, 2, 4)


def processor_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def sweep(starter, command, folder, tasks):
    """Processor seconds of all that was started."""
    before = processor_of_children()
    words = [*starter(folder.name), "sweep", "--random", str(tasks), "--seed", "3", "--quiet", "--out", str(folder)]
    words = [command if word == "COMMAND" else word for word in words]
    if "mpirun" not in words[0]:
        words += ["--processes", folder.name.split("-")[1]]
    subprocess.run(words, check=True, stderr=subprocess.PIPE)
    return processor_of_children() - before


def alone(_):
    return ["COMMAND"]


def ranked(name):
    root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    return ["mpirun", *root, "--oversubscribe", "-n", name.split("-")[1], "COMMAND"]


def spent_in(folder):
    lines = [line for shard in sorted((folder / "shards").iterdir()) for line in shard.read_text().splitlines()]
    return [json.loads(line)["spent"] for line in lines]


def modelled(command, folder, count, processors):
    """Seconds of a run on so many processes, which share the processors."""
    asked = f"{count}@{min(count, processors)}"
    told = subprocess.run(
        [command, "sweep", "--model", asked, "--out", str(folder)], check=True, capture_output=True, text=True
    ).stdout
    return float(told.splitlines()[-1].split()[2])


def main():
    command = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/release/leadscrew")
    tasks = int(sys.argv[2]) if len(sys.argv) > 2 else 4000
    processors = len(os.sched_getaffinity(0))
    print(f"{tasks} tasks, {processors} processors")
    print(f"{'':14}{'tasks s':>9}{'beyond':>9}{'run s':>9}{'own s':>9}{'':>9}{'one s':>9}{'':>9}")
    with tempfile.TemporaryDirectory() as scratch:
        one = None
        for name, starter in (("processes", alone), ("mpirun", ranked)):
            for count in PROCESSES:
                folder = pathlib.Path(scratch) / f"{name}-{count}"
                processor = sweep(starter, command, folder, tasks)
                spent = spent_in(folder)
                own = sum(task["processor_s"] for task in spent)
                run = max(task["end"] for task in spent) - min(task["begin"] for task in spent)
                one = one or folder
                models = [modelled(command, source, count, processors) for source in (folder, one)]
                row = f"{name + ' ' + str(count):14}{own:9.3f}{processor / own - 1:9.2%}{run:9.3f}"
                for model in models:
                    row += f"{model:9.3f}{model / run - 1:+9.2%}"
                print(row, flush=True)


if __name__ == "__main__":
    main()
