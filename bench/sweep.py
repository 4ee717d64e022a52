#!/usr/bin/env python3
"""What a sweep takes beside its tasks, and how near its model comes to what is measured.

script/bench --sweep [TASKS]

Random programs (some 10 ms each) on 1, 2 and 4 processes alone and on 1, 2 and 4 ranks of MPI. Printed of each:

tasks       processor time of all tasks, as the shards have it, s
a task      the mean of it, ms
beyond      processor time of everything that was started, mpirun too, less that of the tasks, over that of the tasks
start       of that, what a sweep of one task a process takes beyond it: of any sweep, however long; s
of 10 ms    beyond, the start too, over the time of as many tasks of 10 ms: no more than 2 %, or this ends with 1
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
TASK = 0.010  # s, of what is asked
MOST = 0.02  # beyond such tasks


def processor_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def sweep(starter, command, folder, count, tasks):
    """Processor seconds of all that was started, and what each task took."""
    before = processor_of_children()
    words = [*starter(count), "sweep", "--random", str(tasks), "--seed", "3", "--quiet", "--out", str(folder)]
    words = [command if word == "COMMAND" else word for word in words]
    if "mpirun" not in words[0]:
        words += ["--processes", str(count)]
    subprocess.run(words, check=True, stderr=subprocess.PIPE)
    return processor_of_children() - before, spent_in(folder)


def alone(_):
    return ["COMMAND"]


def ranked(count):
    root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    return ["mpirun", *root, "--oversubscribe", "-n", str(count), "COMMAND"]


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
    print(f"{'':14}{'tasks s':>9}{'a task ms':>11}{'start s':>9}{'beyond':>9}{'of 10 ms':>10}{'run s':>9}{'own s':>9}{'':>9}{'one s':>9}{'':>9}")
    with tempfile.TemporaryDirectory() as scratch:
        one, worst = None, 0
        for name, starter in (("processes", alone), ("mpirun", ranked)):
            for count in PROCESSES:
                folder = pathlib.Path(scratch) / f"{name}-{count}"
                processor, spent = sweep(starter, command, folder, count, tasks)
                own = sum(task["processor_s"] for task in spent)
                started, few = sweep(starter, command, folder.parent / f"start-{name}-{count}", count, count)
                start = started - sum(task["processor_s"] for task in few)
                run = max(task["end"] for task in spent) - min(task["begin"] for task in spent)
                one = one or folder
                models = [modelled(command, source, count, processors) for source in (folder, one)]
                beyond = processor - own
                worst = max(worst, beyond / len(spent) / TASK)
                row = f"{name + ' ' + str(count):14}{own:9.3f}{1e3 * own / len(spent):11.2f}{start:9.3f}"
                row += f"{beyond / own:9.2%}{beyond / len(spent) / TASK:10.2%}{run:9.3f}"
                for model in models:
                    row += f"{model:9.3f}{model / run - 1:+9.2%}"
                print(row, flush=True)
    print(f"beyond tasks of 10 ms: {worst:.2%} at most, {'no more' if worst <= MOST else 'MORE'} than {MOST:.0%}")
    return 0 if worst <= MOST else 1


if __name__ == "__main__":
    sys.exit(main())
