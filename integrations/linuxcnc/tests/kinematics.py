#!/usr/bin/env python3
"""kinematics.py MODULE LEADSCREW: tool centre point control inside LinuxCNC on trunnions and a fork head (xyzac-trt-kins,
xyzbc-trt-kins, 5axiskins; bench/peers/five-axes.ini), planned within the limits of the joints, by files of machines/; judged by
leadscrew's referee. Pins that say otherwise than the file are found. With kinematics of other kinds (trivkins, corexykins,
lineardeltakins) the limits of the world are kept. No period takes the servo thread long."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import simulator
from spindle import PASSES, Turns, errors

sys.path.insert(0, str(simulator.SCREEN.parent))
from record_to_trace import write_trace  # noqa: E402

PEERS = simulator.SCREEN.parent
MACHINES = simulator.HERE.parents[2] / "machines"
MACHINE = MACHINES / "table-table-ac.toml"
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
    "thread": {"speed": 600, "top": 5, "lead": 1, "thread": "G33 Z-15 K1", "end": -14},
    "fast-thread": {"speed": 1200, "top": 40, "lead": 1.5, "run_in": 5, "thread": "G33 Z-20 K1.5", "end": -14},
    "cycle": {"speed": 600, "top": 5, "lead": 1, "thread": "G18 G76 P1 Z-8 I-1 J0.2 K0.6 R1 Q0 H0 E0 L0", "end": -7, "ways": PASSES},
    "tap": {"speed": 600, "top": 5, "lead": 1, "thread": "G33.1 Z-8 K1", "end": -10, "ways": 2},
    "turning": {"speed": 600, "top": 5, "lead": 1, "thread": "G33 Z-15 C50 K1", "end": -14},
}


def with_spindle(text):
    """The machine with the spindle of spindle.hal, and the sampler takes down what this one's does."""
    spindle = [line for line in (simulator.HERE / "spindle.hal").read_text().splitlines()
               if any(word in line for word in ("spindle", "siggen", "wander", "revolutions", "index", "net thread")) and "names=x-nm" not in line]
    text = text.replace("a-nd,c-nd", "a-nd,c-nd,spindle-rps").replace("cfg=fffff", "cfg=ffffffss")
    return text.replace("addf sampler.0", re.sub("sampler.0.pin.(.)", lambda pin: f"sampler.0.pin.{int(pin[1]) + 2}", "\n".join(spindle)) + "\naddf sampler.0")


def rests(places):
    """Where it rests for a fifth of a second, in their order."""
    found, since = [], 0
    for i in range(1, len(places)):
        if places[i] != places[i - 1]:
            since = i
        elif i - since == 200:
            found.append(places[i])
    return found


def play(jobs, hal=lambda text: text, ini=lambda text: text, machine=MACHINE):
    text = (PEERS / "five-axes.ini").read_text().replace("./record.py", "./play.py\nMAX_FEED_OVERRIDE = 1.5")
    text = text.replace("[TRAJ]\n", f"[TRAJ]\nTPMOD = leadscrew_tp jerk=60000 machine={machine}\n").replace("five-axes.hal", "machine.hal")
    listed = [{"name": name, **job} for name, job in jobs.items()]
    return simulator.play(module, "", listed, ini_text=ini(text), hal_text=hal((PEERS / "five-axes.hal").read_text()))


def replaced(text, changes):
    for old, new in changes.items():
        text = text.replace(old, new)
    return text


def without_trunnion(text):
    """The machine without the pins of its kinematics."""
    return "".join(line for line in text.splitlines(keepends=True) if "xyzac-trt-kins" not in line)


# By their modules: the machine's file, what is changed of it, what of the trunnion's settings, and the pins. The tilt of 5axiskins
# turns the other way.
HEADS_AND_TABLES = {
    "xyzbc-trt-kins": ("table-table-bc", {}, {"xyzac-trt-kins coordinates=xyzac": "xyzbc-trt-kins coordinates=xyzbc"},
                       "".join(f"setp xyzbc-trt-kins.{pin}\n" for pin in ("x-rot-point 0", "y-rot-point 0", "z-rot-point 0", "x-offset 0",
                                                                          "z-offset -60", "tool-offset 0"))),
    "5axiskins": ("head-head-bc", {"[axis.B]\n": "[axis.B]\nsign = -1\n"}, {"xyzac-trt-kins coordinates=xyzac": "5axiskins", "JOINTS = 5": "JOINTS = 6",
                                            "[JOINT_0]": "[AXIS_W]\nMAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\n\n[JOINT_5]\nTYPE = LINEAR\n"
                                                         "MAX_VELOCITY = 100\nMAX_ACCELERATION = 1000\nHOME_SEQUENCE = 0\n\n[JOINT_0]"},
                  "setp 5axiskins.pivot-length 180\nnet w joint.5.motor-pos-cmd => joint.5.motor-pos-fb\n"),
}
# By their modules, with mill3's limits: settings that differ, and of X, Y and Z by joints 0, 1 and 2.
IN_THE_WORLD = {
    "trivkins coordinates=XYZ": {},
    "corexykins": {},
    "lineardeltakins": {"HOME_SEQUENCE = 0": "HOME = 235.36\nHOME_OFFSET = 235.36\nHOME_SEQUENCE = 0"},
}
MILL = ("G1 X20 Y10 Z5 F3000\nG1 X0 Y20\nG2 X30 Y20 I15 J0\nG3 X30 Y20 Z-5 I-10 J0 P2\nG1 X31 Y21 F200\nG0 X0 Y0 Z0\n")


def in_the_world(kinematics, changes):
    """Of settings and HAL: axes' commands are taken down instead of joints'."""
    ini = (simulator.HERE / "machine.ini").read_text().replace("@PLANNER@", "leadscrew_tp jerk=20000").replace("@HAL@", "machine.hal")
    ini = replaced(ini, {"trivkins coordinates=XYZ": kinematics, **changes})
    hal = (simulator.HERE / "machine.hal").read_text().replace("cfg=fff", "cfg=fffss")
    for joint, axis in enumerate("xyz"):
        hal = hal.replace(f"motor-pos-fb {axis}-nm.in", f"motor-pos-fb\nnet {axis}-axis axis.{axis}.pos-cmd => {axis}-nm.in")
    hal += "net controller-time motion-controller.time => sampler.0.pin.3\nnet handler-time motion-command-handler.time => sampler.0.pin.4\n"
    return ini, hal


def with_times(text):
    """The trunnion's HAL with what both functions of motmod take, in clocks, as two columns more."""
    return (text.replace("cfg=fffff", "cfg=fffffss") + "net controller-time motion-controller.time => sampler.0.pin.5\n"
            "net handler-time motion-command-handler.time => sampler.0.pin.6\n")


def clocks_of(record, first):
    """Of both functions together, of each period."""
    rows = [line.split()[1 + first:] for line in record.splitlines() if line.strip() != "overrun"]
    return sorted(int(controller) + int(handler) for controller, handler in rows)


def told_clocks(clocks):
    return "clocks: median {}, 99.9 % {}, greatest {}".format(*(clocks[min(len(clocks) - 1, int(share * len(clocks)))] for share in (0.5, 0.999, 1)))


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
    def judge(self, text, program, machine=MACHINE, letters=None):
        """Of the record, by the referee: within the limits of each joint, and the tip within P."""
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "record").write_text(text)
            (folder / "program.ngc").write_text(program)
            write_trace(folder / "record", folder / "trace.csv", letters)
            verify = subprocess.run([leadscrew, "verify", "--json", "--machine", machine, folder / "trace.csv", folder / "program.ngc"],
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

    def test_heads_and_other_tables(self):
        program = (HEAD + PATH).replace("A", "B") + "M2\n"
        for kinematics, (name, of_file, of_settings, pins) in HEADS_AND_TABLES.items():
            def settings(text):
                text = replaced(text, of_settings).replace("AXIS_A", "AXIS_B")
                return text.replace("Y Z A C", "Y Z B C" + " W" * ("AXIS_W" in text))
            with self.subTest(kinematics), tempfile.TemporaryDirectory(dir="/var/tmp") as folder:
                os.chmod(folder, 0o755)
                machine = pathlib.Path(folder) / "machine.toml"
                machine.write_text(replaced((MACHINES / f"{name}.toml").read_text(), of_file))
                results, log = play({"path": {"program": program}}, lambda text: with_times(without_trunnion(text) + pins), settings, machine)
                record, said, _ = results["path"]
                self.assertEqual(said, "", log[-2000:])
                print(kinematics, told_clocks(clocks_of(record, 5)))
                joints = "\n".join(line if line == "overrun" else " ".join(line.split()[:6]) for line in record.splitlines())
                self.judge(joints, "G43.4\n" + program, machine, "XYZBC")

    def test_kinematics_of_other_kinds_keep_the_limits_of_the_world(self):
        program = "G21 G90 G17 G94 G64 P0.01\n" + MILL + "M2\n"
        for kinematics, changes in IN_THE_WORLD.items():
            with self.subTest(kinematics):
                ini, hal = in_the_world(kinematics, changes)
                results, log = simulator.play(module, "", [{"name": "mill", "program": program}], ini_text=ini, hal_text=hal)
                record, said, end = results["mill"]
                self.assertEqual(said, "", log[-2000:])
                places = [[float(value) * 1e-6 for value in line.split()[1:4]] for line in record.splitlines() if line.strip() != "overrun"]
                for order, limit in ((1, 200), (2, 1000), (3, 20000)):
                    self.assertLessEqual(worst_of(places, order, [limit] * 3), 1.001, f"order {order}")
                for value in end["position"][:3]:
                    self.assertAlmostEqual(value, 0, places=6)
                self.assertGreater(max(place[0] for place in places), 30)
                print(kinematics, told_clocks(clocks_of(record, 3)))

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
                top, end, ways = thread["top"] - thread.get("run_in", 1.3), max(thread["end"], min(depths)), thread.get("ways", 1)
                turns = Turns(text, jobs[name]["program"], axes=5)
                found, travel = errors(depths, turns, thread["top"], top, end, thread["lead"])
                print(name, len(found), "periods", f"{travel:.3f} mm {1e3 * max(found):.2f} µm", worst)
                self.assertAlmostEqual(travel, ways * (top - end), delta=0.03 * ways)
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
