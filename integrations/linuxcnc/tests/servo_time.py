#!/usr/bin/env python3
"""servo_time.py MODULE [ROUNDS]: the time that motmod's two functions take in each servo period, with Leadscrew's planner and with
the stock one, by turns, inside LinuxCNC; of the periods in motion. LinuxCNC's own pins tell it (motion-controller.time,
motion-command-handler.time), in clocks of the processor's time stamp counter."""
import simulator
from table import PLANNERS, PROGRAMS

NAMES = ("cubic-f6000", "square-g64", "line-5000", "arcs-g64", "rapids")
QUANTILES = {"median": 0.5, "99 %": 0.99, "99.9 %": 0.999}


def hal_with_times():
    text = (simulator.HERE / "machine.hal").read_text().replace("cfg=fff", "cfg=fffss")
    return (text + "net controller-time motion-controller.time => sampler.0.pin.3\n"
            "net handler-time motion-command-handler.time => sampler.0.pin.4\n")


def clocks_in_motion(record):
    """Of both functions, of each period from the first in which something moves to the last."""
    rows = [line.split() for line in record.splitlines() if line.strip() != "overrun"]
    moving = [i for i in range(1, len(rows)) if rows[i][1:4] != rows[i - 1][1:4]]
    return [int(row[4]) + int(row[5]) for row in rows[moving[0]:moving[-1] + 1]]


def quantile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def main(module, rounds="5"):
    clocks = {(name, planner): [] for name in NAMES for planner in PLANNERS}
    for _ in range(int(rounds)):
        for planner, words in PLANNERS.items():
            jobs = [{"name": name, "program": PROGRAMS[name]} for name in NAMES]
            results, log = simulator.play(module, words, jobs, hal_text=hal_with_times())
            for name, (record, said, _) in results.items():
                if said:
                    raise RuntimeError(f"{name}: {said}\n{log[-2000:]}")
                clocks[name, planner] += clocks_in_motion(record)
    print(f"{'program':<14}{'planner':<11}{'periods':>9}" + "".join(f"{name:>9}" for name in QUANTILES) + "  clocks")
    for name in (*NAMES, "all"):
        for planner in PLANNERS:
            values = clocks[name, planner] if name in NAMES else [value for n in NAMES for value in clocks[n, planner]]
            found = "".join(f"{quantile(values, share):>9}" for share in QUANTILES.values())
            print(f"{name:<14}{planner:<11}{len(values):>9}{found}")


if __name__ == "__main__":
    module, arguments = simulator.arguments()
    main(module, *arguments)
