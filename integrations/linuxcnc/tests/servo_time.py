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


def main(module, rounds="10"):
    clocks = {(name, planner): [] for name in NAMES for planner in PLANNERS}
    of_rounds = {planner: [] for planner in PLANNERS}
    for number in range(int(rounds)):
        for planner in sorted(PLANNERS, reverse=number % 2 == 1):
            jobs = [{"name": name, "program": PROGRAMS[name]} for name in NAMES]
            results, log = simulator.play(module, PLANNERS[planner], jobs, hal_text=hal_with_times())
            of_rounds[planner].append([])
            for name, (record, said, _) in results.items():
                if said:
                    raise RuntimeError(f"{name}: {said}\n{log[-2000:]}")
                found = clocks_in_motion(record)
                clocks[name, planner] += found
                of_rounds[planner][-1] += found
    print(f"{'program':<16}{'planner':<11}{'periods':>9}" + "".join(f"{name:>9}" for name in QUANTILES) + "  clocks")
    for name in NAMES:
        for planner in PLANNERS:
            values = clocks[name, planner]
            print(f"{name:<16}{planner:<11}{len(values):>9}" + "".join(f"{quantile(values, share):>9}" for share in QUANTILES.values()))
    # Other programs of the computer disturb some rounds.
    for planner in PLANNERS:
        counts = [len(values) for values in of_rounds[planner]]
        found = [quantile([quantile(values, share) for values in of_rounds[planner]], 0.5) for share in QUANTILES.values()]
        print(f"{'median of rounds':<16} {planner:<10}{sum(counts):>9}" + "".join(f"{value:>9}" for value in found))


if __name__ == "__main__":
    module, arguments = simulator.arguments()
    main(module, *arguments)
