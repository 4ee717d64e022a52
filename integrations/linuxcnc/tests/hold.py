#!/usr/bin/env python3
"""hold.py MODULE [PLANNER…]: how long a feed hold (pin motion.feed-hold) takes until motion begins to brake, and until it rests, inside
LinuxCNC: just behind the beginning of motion, in its midst, on short lines, and where single commands begin; of these planners of
[TRAJ]TPMOD, "leadscrew_tp jerk=20000" and the stock one where none is given."""
import sys

import simulator

HEAD = "G21 G90 G17 G94 G64 P0.01\n"
LONG = HEAD + "G1 X300 F3000\nG1 Y100\nG1 X0\nG1 Y0\nM2\n"
SHORT = HEAD + "G64 P0.01 Q0 F3000\n" + "".join(f"G1 X{0.1 * n:.1f} Y{0.002 * (n % 3):.3f}\n" for n in range(1, 2501)) + "M2\n"
# After so many s of motion.
JOBS = {f"{name}-{after}": (program, after) for name, program in (("long", LONG), ("short", SHORT)) for after in (0, 0.1, 0.2, 0.4, 0.8, 2)}
BRAKES = 5  # mm/s² of the path, from which on it does, where it went on evenly before


def settings():
    hal = (simulator.HERE / "signals.hal").read_text().replace("cfg=fffbff", "cfg=fffbffb")
    return hal + "net hold => motion.feed-hold sampler.0.pin.6\n"


def judged(text):
    """ms from the hold until motion brakes, and until it rests."""
    rows = [line.split() for line in text.splitlines() if line.strip() != "overrun"]
    places = [[float(value) * 1e-6 for value in row[1:4]] for row in rows]
    speeds = [0] + [1000 * sum((a - b) ** 2 for a, b in zip(q, p)) ** 0.5 for p, q in zip(places, places[1:])]
    held = next(i for i, row in enumerate(rows) if row[7] == "1")
    # motmod's filter tells positions two periods late: the same for both planners.
    brakes = next(i for i in range(held, len(speeds)) if all((b - a) * 1000 < -BRAKES for a, b in zip(speeds[i:], speeds[i + 1:i + 4])))
    rests = next(i for i in range(brakes, len(speeds)) if speeds[i] == 0)
    return brakes - held, rests - held, speeds[held]


def main(module, *planners):
    jobs = [{"name": name, "program": program, "acts": [[0, "run", 0], [0, "motion", after], [0, "signal", ["hold", "1"]],
                                                        [0, "wait", 0.7], [0, "abort", 0], [0, "signal", ["hold", "0"]]]}
            for name, (program, after) in JOBS.items()]
    for planner in planners or ("leadscrew_tp jerk=20000", "tpmod"):
        results, log = simulator.play(module, planner, jobs, hal="signals.hal", hal_text=settings())
        for name, (text, said, _) in results.items():
            if said:
                sys.exit(f"{name}: {said}\n{log[-2000:]}")
            brakes, rests, speed = judged(text)
            print(f"{planner:30} {name:12} at {speed:5.1f} mm/s: brakes after {brakes:4} ms, rests after {rests:4} ms", flush=True)


if __name__ == "__main__":
    module, planners = simulator.arguments()
    main(module, *planners)
