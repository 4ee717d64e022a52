#!/usr/bin/env python3
"""random_programs.py MODULE COUNT SEED: random programs inside LinuxCNC with overrides, pauses, aborts and MDI at random
instants. Limits are kept, nothing hangs, nothing complains, and what is not aborted ends where its program ends."""
import random
import sys

import simulator
from interventions import ACCELERATION, JERK, VELOCITY, Record

HEAD = "G21 G90 G17 G94\n"


def program_of(draw):
    """Lines, arcs, helices and rapids within 40 mm, and where they end."""
    x = y = z = 0.0
    blocks = [draw.choice(["G61", "G61.1", "G64 P0.01", "G64 P0.05", "G64 P0.2"])]
    for _ in range(draw.randint(3, 12)):
        kind = draw.random()
        blocks.append(f"F{draw.choice([900, 1800, 3000, 6000])}")
        if kind < 0.15:
            x, y = round(draw.uniform(-20, 20), 3), round(draw.uniform(-20, 20), 3)
            blocks.append(f"G0 X{x} Y{y}")
        elif kind < 0.35:
            i, j = round(draw.uniform(1, 6), 3), round(draw.uniform(-4, 4), 3)
            z = round(draw.uniform(-5, 5), 3)
            blocks.append(f"{draw.choice(['G2', 'G3'])} X{x} Y{y} Z{z} I{i} J{j} P{draw.randint(1, 2)}")
        elif kind < 0.45:
            blocks.append(draw.choice(["M62 P0", "M63 P0", "M67 E0 Q1.5", "G4 P0.05", "M64 P0"]))
        else:
            step = draw.choice([0.02, 0.5, 3, 15])
            x, y, z = (round(v + draw.uniform(-step, step), 4) for v in (x, y, z))
            x, y, z = (max(-40.0, min(40.0, v)) for v in (x, y, max(z, -10.0)))
            blocks.append(f"G1 X{x} Y{y} Z{z}")
    return HEAD + "\n".join(blocks) + "\nM2\n", (x, y, z)


def acts_of(draw):
    """What happens meanwhile, and whether the program is aborted."""
    acts, moment = [], 0.1
    for _ in range(draw.randint(0, 4)):
        moment = round(moment + draw.uniform(0.05, 0.7), 3)
        if draw.random() < 0.3:
            acts.append([moment, "pause", 0])
            moment = round(moment + draw.uniform(0.05, 0.5), 3)
            acts.append([moment, "resume", 0])
        else:
            what, least, most = draw.choice([("feed", 0.3, 1.5), ("rapid", 0.3, 1), ("maxvel", 20, 200)])
            acts.append([moment, what, round(draw.uniform(least, most), 2)])
    aborts = draw.random() < 0.25
    if aborts:
        moment = round(moment + draw.uniform(0.02, 0.5), 3)
        acts += [[moment, "abort", 0], [round(moment + 0.4, 3), "mdi", "G21 G90 G1 F3000 X1 Y2 Z3"]]
    return acts, aborts


def complaint_of(result, end):
    record_text, said, ended = result
    if said:
        return said
    record = Record(record_text)
    for order, limit in ((1, VELOCITY), (2, ACCELERATION), (3, JERK)):
        if record.differences(order) > 1.001 * limit:
            return f"difference {order}: {record.differences(order):.1f}"
    if max(abs(a - b) for a, b in zip(ended["position"], end)) > 1e-9:
        return f"ended at {ended['position']}, not at {end}"
    return ""


def main(module, count, seed):
    jobs, ends = [], {}
    for number in range(int(count)):
        draw = random.Random(f"{seed}/{number}")
        text, end = program_of(draw)
        acts, aborts = acts_of(draw)
        name = f"random-{number}"
        jobs.append({"name": name, "program": text, "acts": acts})
        ends[name] = (1.0, 2.0, 3.0) if aborts else end
    results, log = simulator.play(module, "leadscrew_tp jerk=20000", jobs, seconds=20 * len(jobs) + 60, hal="signals.hal")
    failed = 0
    for job in jobs:
        if complaint := complaint_of(results[job["name"]], ends[job["name"]]):
            failed += 1
            print(f"{job['name']}: {complaint}\n{job['acts']}\n{job['program']}")
    print(f"{len(jobs) - failed} of {len(jobs)} as they should be, seed {seed}")
    if failed:
        print(log[-2000:])
    sys.exit(bool(failed))


if __name__ == "__main__":
    module, numbers = simulator.arguments()
    main(module, *numbers)
