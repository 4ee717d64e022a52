#!/usr/bin/env python3
"""table.py MODULE LEADSCREW FOLDER [NAME…]: programs by Leadscrew's planner and by the stock one inside LinuxCNC, judged by
leadscrew's referee. Records, traces and logs are left in FOLDER."""
import json
import math
import pathlib
import subprocess
import sys

import simulator

sys.path.insert(0, str(simulator.HERE.parents[2] / "bench" / "peers"))
from record_to_trace import write_trace  # noqa: E402

HEAD = "G21 G90 G17 G94\n"
PLANNERS = {"leadscrew": "leadscrew_tp jerk=20000", "stock": "tpmod"}


def cubic(count):
    return [(20 * u, ((-50 * u + 80) * u - 10) * u) for u in (i / count for i in range(1, count + 1))]


def lines(points):
    return "".join(f"G1 X{x:.9f} Y{y:.9f}\n" for x, y in points)


def bent(count):
    """Lines of 10 µm along a great circle, so that none of them can be merged."""
    radius = 200
    return [(radius * math.sin(0.01 * i / radius), radius * (1 - math.cos(0.01 * i / radius))) for i in range(1, count + 1)]


SQUARE = lines([(10, 0), (10, 10), (0, 10), (0, 0)])
ARCS = "G2 X20 Y0 I10 J0\nG3 X40 Y0 I10 J0\nG1 X60\nG17 G3 X60 Y0 Z-10 I0 J10 P3\nG18 G2 X80 Z-10 I10 K0\nG17 G1 X90 Y5\n"
PROGRAMS = {
    "square-g61.1": HEAD + "G61.1 F6000\n" + SQUARE + "M2\n",
    "square-g61": HEAD + "G61 F6000\n" + SQUARE + "M2\n",
    "square-g64": HEAD + "G64 P0.01 F6000\n" + SQUARE + "M2\n",
    "cubic-f6000": HEAD + "G64 P0.01 F6000\n" + lines(cubic(1000)) + "M2\n",
    "cubic-f600": HEAD + "G64 P0.01 F600\n" + lines(cubic(1000)) + "M2\n",
    "line-5000": HEAD + "G64 P0.01 F6000\n" + lines([(0.01 * i, 0) for i in range(1, 5001)]) + "M2\n",
    "bent-5000": HEAD + "G64 P0.01 F6000\n" + lines(bent(5000)) + "M2\n",
    "arcs-g64": HEAD + "G64 P0.01 F6000\n" + ARCS + "M2\n",
    "arcs-g61": HEAD + "G61 F6000\n" + ARCS + "M2\n",
    "rapids": HEAD + "G64 P0.01 F3000\nG0 X30\nG1 Y10\nG0 X0\nG1 Y0\nM2\n",
}


def judge(leadscrew, folder, name, planner, text):
    """A row of figures, or why there is none."""
    trace, record, program = (folder / f"{name}.{planner}.{ending}" for ending in ("csv", "record", "ngc"))
    program.write_text(text)
    try:
        write_trace(record, trace)
    except ValueError as error:
        return str(error)
    verify = subprocess.run([leadscrew, "verify", "--json", "--dialect", "linuxcnc", trace, program], capture_output=True, text=True)
    if verify.returncode > 1:
        return verify.stderr.strip()
    found = json.loads(verify.stdout)
    worst = {what: max(axis[f"{what}_ratio"] for axis in found["axes"]) for what in ("velocity", "acceleration", "jerk")}
    return {"time": found["time_s"], "deviation": found["deviation_mm"] * 1e3, **worst}


def main(module, leadscrew, folder, *names):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    programs = {name: text for name, text in PROGRAMS.items() if not names or name in names}
    jobs = [{"name": name, "program": text} for name, text in programs.items()]
    found = {}
    for planner, words in PLANNERS.items():
        results, log = simulator.play(module, words, jobs)
        (folder / f"{planner}.log").write_text(log)
        for name, (record, said, end) in results.items():
            (folder / f"{name}.{planner}.record").write_text(record)
            row = judge(leadscrew, folder, name, planner, programs[name]) if not said else said
            found[name, planner] = row
            found[name, planner, "servo"] = end.get("servo_thread_ns", "")
    print(f"{'program':<14}{'planner':<11}{'s':>8}{'deviation µm':>14}{'velocity':>10}{'acceleration':>14}{'jerk':>9}  of the limit")
    for name in programs:
        for planner in PLANNERS:
            row = found[name, planner]
            head = f"{name:<14}{planner:<11}"
            if isinstance(row, str):
                print(head, row.splitlines()[0][:90])
            else:
                print(f"{head}{row['time']:>8.3f}{row['deviation']:>14.2f}{row['velocity']:>10.3f}{row['acceleration']:>14.3f}"
                      f"{row['jerk']:>9.4f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
