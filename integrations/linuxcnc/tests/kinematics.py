#!/usr/bin/env python3
"""kinematics.py MODULE LEADSCREW: tool centre point control on a trunnion inside LinuxCNC (bench/peers/five-axes.ini, xyzac-trt-kins),
planned within the limits of the joints, by machines/table-table-ac.toml; judged by leadscrew's referee. Pins that say otherwise than
the file are found."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import simulator
from spindle import errors

sys.path.insert(0, str(simulator.SCREEN.parent))
from record_to_trace import write_trace  # noqa: E402

PEERS = simulator.SCREEN.parent
MACHINE = simulator.HERE.parents[2] / "machines" / "table-table-ac.toml"
PLANNER = f"leadscrew_tp jerk=60000 machine={MACHINE}"
HEAD = "G21 G90 G17 G94 G64 P0.01\n"
PATH = ("G1 X20 Y10 Z5 A20 C30 F3000\nG1 X0 Y20 A-15 C80\nG1 X-20 Y5 Z0 A10 C10\nG2 X10 Y5 I15 J0\nG1 A-25 F2000\nG1 C200\n"
        "G0 X0 Y0 Z0 A0 C0\n")
TOOL = "G43.1 Z30\n", "G49\n"
JOINT_LIMITS = [400, 400, 400, 180, 360], [3000, 3000, 3000, 1500, 3000], [60000, 60000, 60000, 30000, 60000]
JOBS = {
    "trunnion": {"program": HEAD + PATH + "M2\n"},
    "override": {"program": HEAD + PATH + "M2\n", "acts": [[0.5, "feed", 0.5], [1.2, "pause", 0], [1.6, "resume", 0], [2, "feed", 1.3]]},
}

# Along Z of the part on a table that is tilted and turned, from Z5 on, after a way of 5 mm that tells where it leads.
THREAD = "G21 G90 G17 G94\nM3 S{speed}\nG0 X10 Y-5 Z{far} A25 C40\nG4 P0.4\nG0 Z{top}\nG4 P1\n{thread}\nM5\nM2\n"
THREADS = {
    "thread": {"speed": 600, "top": 5, "lead": 1, "thread": "G33 Z-15 K1", "end": -14, "least": 1200},
    "fast-thread": {"speed": 1200, "top": 40, "lead": 1.5, "run_in": 5, "thread": "G33 Z-20 K1.5", "end": -14, "least": 800},
    "cycle": {"speed": 600, "top": 5, "lead": 1, "thread": "G18 G76 P1 Z-8 I-1 J0.2 K0.6 R1 Q0 H0 E0 L0", "end": -7, "least": 2000},
    "tap": {"speed": 600, "top": 5, "lead": 1, "thread": "G33.1 Z-8 K1", "end": -10, "least": 1200},
    "turning": {"speed": 600, "top": 5, "lead": 1, "thread": "G33 Z-15 C50 K1", "end": -14, "least": 0},
}


def with_spindle(text):
    """The machine with the spindle of spindle.hal, and the sampler takes down its turns."""
    spindle = [line for line in (simulator.HERE / "spindle.hal").read_text().splitlines()
               if any(word in line for word in ("spindle", "siggen", "wander", "revolutions", "index")) and "names=x-nm" not in line]
    text = text.replace("a-nd,c-nd", "a-nd,c-nd,spindle-rps").replace("cfg=fffff", "cfg=ffffff")
    return text.replace("addf sampler.0", "\n".join(spindle).replace("sampler.0.pin.3", "sampler.0.pin.5") + "\naddf sampler.0")


def rests(places):
    """Where it rests for a fifth of a second, in their order."""
    found, since = [], 0
    for i in range(1, len(places)):
        if places[i] != places[i - 1]:
            since = i
        elif i - since == 200:
            found.append(places[i])
    return found


def play(jobs, hal=lambda text: text):
    ini = (PEERS / "five-axes.ini").read_text().replace("./record.py", "./play.py\nMAX_FEED_OVERRIDE = 1.5")
    ini = ini.replace("[TRAJ]\n", f"[TRAJ]\nTPMOD = {PLANNER}\n").replace("five-axes.hal", "machine.hal")
    listed = [{"name": name, **job} for name, job in jobs.items()]
    return simulator.play(module, "", listed, ini_text=ini, hal_text=hal((PEERS / "five-axes.hal").read_text()))


def worst_of(places, order, limits):
    """The greatest difference of any joint, over its limit."""
    worst = 0
    for joint, limit in enumerate(limits):
        values = [place[joint] for place in places]
        for _ in range(order):
            values = [(b - a) * 1000 for a, b in zip(values, values[1:])]
        worst = max(worst, max(map(abs, values)) / limit)
    return worst


class OnATrunnion(unittest.TestCase):
    def judge(self, text, program):
        """Of the record, by the referee: within the limits of each joint, and the tip within P."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "record").write_text(text)
            (folder / "program.ngc").write_text(program)
            write_trace(folder / "record", folder / "trace.csv")
            verify = subprocess.run([leadscrew, "verify", "--json", "--machine", MACHINE, folder / "trace.csv", folder / "program.ngc"],
                                    capture_output=True, text=True)
        self.assertIn(verify.returncode, (0, 1), verify.stderr)
        found = json.loads(verify.stdout)
        for axis in found["axes"]:
            for what in ("velocity", "acceleration", "jerk"):
                self.assertLessEqual(axis[f"{what}_ratio"], 1.001, f"{what} of {axis}")
        self.assertLessEqual(found["tip"]["deviation_mm"], 0.01)
        print(found["time_s"], found["tip"]["deviation_mm"], [round(axis["jerk_ratio"], 4) for axis in found["axes"]])

    def test_joints_keep_their_limits(self):
        results, log = play(JOBS)
        for name, (record, said, end) in results.items():
            with self.subTest(name):
                self.assertEqual(said, "", log[-2000:])
                for value in end["position"]:
                    self.assertAlmostEqual(value, 0, places=9)
                self.judge(record, "G43.4\n" + JOBS[name]["program"])

    def test_threads_and_taps_are_in_step_within_the_limits_of_joints(self):
        jobs = {name: {"program": THREAD.format(far=thread["top"] + 5, **thread)} for name, thread in THREADS.items()}
        results, log = play(jobs, with_spindle)
        self.assertIn("moves rotary axes", log)
        self.assertNotEqual(results.pop("turning")[1], "")
        for name, (text, said, _) in results.items():
            with self.subTest(name):
                self.assertEqual(said, "", log[-2000:])
                rows = [[float(value) for value in line.split()[1:]] for line in text.splitlines() if line.strip() != "overrun"]
                places = [[value * 1e-6 for value in row[:5]] for row in rows]
                worst = [worst_of(places, order, limits) for order, limits in enumerate(JOINT_LIMITS, 1)]
                self.assertLessEqual(max(worst), 1.001)
                thread, (_, far, near, *_) = THREADS[name], rests(places)
                way = [b - a for a, b in zip(far[:3], near[:3])]
                depths = [thread["top"] - sum((q - p) * w for p, q, w in zip(near, place, way)) / 5 for place in places]
                found = errors(depths, [row[5] for row in rows], thread["top"], thread["top"] - thread.get("run_in", 1.3), thread["end"],
                               thread["lead"])
                print(name, len(found), "periods", f"{1e3 * max(found):.2f} µm", worst)
                self.assertGreater(len(found), thread["least"])
                self.assertLess(max(found), 0.01)

    def test_a_tools_length_counts(self):
        def with_tool(text):
            return text.replace("setp xyzac-trt-kins.tool-offset 0", "net tool-length motion.tooloffset.z => xyzac-trt-kins.tool-offset")
        program = HEAD + TOOL[0] + PATH + TOOL[1] + "G0 X0 Y0 Z0\nM2\n"
        results, log = play({"tool": {"program": program}}, with_tool)
        record, said, _ = results["tool"]
        self.assertEqual(said, "", log[-2000:])
        rows = [[float(value) * 1e-6 for value in line.split()[1:]] for line in record.splitlines() if line.strip() != "overrun"]
        self.assertLessEqual(worst_of(rows, 3, JOINT_LIMITS[2]), 1.001)

    def test_pins_that_differ_from_the_file_are_found(self):
        for pin in ("z-offset -49.99", "tool-offset 1"):
            name = pin.split()[0]
            results, log = play({"differs": {"program": HEAD + PATH + "M2\n"}},
                                lambda text: "".join(f"setp xyzac-trt-kins.{pin}\n" if f"kins.{name}" in line else line
                                                     for line in text.splitlines(keepends=True)))
            record, said, _ = results["differs"]
            self.assertIn("kinematics differ", log)
            self.assertNotEqual(said, "")


if __name__ == "__main__":
    module, (leadscrew, *names) = simulator.arguments()
    unittest.main(argv=[sys.argv[0], *names])
