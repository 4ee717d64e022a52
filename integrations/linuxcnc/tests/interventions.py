#!/usr/bin/env python3
"""interventions.py MODULE: overrides, pause, abort, MDI, jogs, outputs and probing inside LinuxCNC. Every record is held
against the limits of velocity, acceleration and jerk by its own differences."""
import sys
import unittest

import simulator

VELOCITY, ACCELERATION, JERK = 200, 1000, 20000  # mm/s, mm/s^2, mm/s^3
HEAD = "G21 G90 G17 G94\n"
PATH = HEAD + "G64 P0.01 F1200\n" + "G1 X10\nG1 Y10\nG2 X30 Y10 I10 J0\nG1 X60\nG1 Y0\nG1 X0 Y0\n" + "M2\n"


class Record:
    """Positions in mm, and what was sampled with them, a period each."""

    def __init__(self, text, outputs=True):
        rows = [line.split() for line in text.splitlines() if line.strip() != "overrun"]
        self.numbers = [int(row[0]) for row in rows]
        self.places = [[float(value) * 1e-6 for value in row[1:4]] for row in rows]
        if not outputs:
            return
        self.outputs = [int(float(row[4])) for row in rows]
        self.analogs = [float(row[5]) for row in rows]
        self.jogs = [row[-1] == "1" for row in rows]

    def differences(self, order):
        """The greatest of an axis, mm/s^order."""
        worst = 0
        for axis in range(3):
            values = [place[axis] for place in self.places]
            for _ in range(order):
                values = [(b - a) * 1000 for a, b in zip(values, values[1:])]
            worst = max(worst, max(map(abs, values), default=0))
        return worst

    def beyond_limits(self):
        """What is greater than its limit, of the whole record: velocity and acceleration of every word, jerk of all but those in whose
        reach a jog moves (pin motion.teleop-mode in the last column), which motmod plans itself without such a limit. Where words were
        lost there is none to judge."""
        moves_by_jog = [is_jog and i > 0 and self.places[i] != self.places[i - 1] for i, is_jog in enumerate(self.jogs)]
        for order, limit in ((1, VELOCITY), (2, ACCELERATION), (3, JERK)):
            reach = [range(i - order, i + 1) for i in range(order, len(self.places)) if self.numbers[i] - self.numbers[i - order] == order]
            if order == 3:
                reach = [words for words in reach if not any(moves_by_jog[words[0]:words[-1] + 1])]
            for axis in range(3):
                for words in reach:
                    values = [self.places[i][axis] for i in words]
                    while len(values) > 1:
                        values = [(b - a) * 1000 for a, b in zip(values, values[1:])]
                    if abs(values[0]) > 1.001 * limit:
                        return f"difference {order} of {'XYZ'[axis]} at word {words[-1]}: {values[0]:.1f}"
        return ""

    def speed(self, second):
        """Along the path, at that time of the record, mm/s."""
        i = int(1000 * second)
        return 1000 * sum((a - b) ** 2 for a, b in zip(self.places[i + 1], self.places[i])) ** 0.5


JOBS = {
    "overrides": {"program": PATH, "acts": [[1, "feed", 0.5], [2, "pause", 0], [3, "resume", 0], [3.6, "feed", 1.5]]},
    "beyond": {"program": PATH, "acts": [[1, "feed", 5.0]]},
    "greatest-velocity": {"program": PATH, "acts": [[1, "maxvel", 10], [2, "maxvel", 0], [3, "maxvel", 200]]},
    "abort": {"program": PATH, "acts": [[1.5, "abort", 0]]},
    "after-abort": {"acts": [[0, "mdi", "G21 G90 G1 F3000 X5 Y5"], [0, "mdi", "G2 X5 Y5 I3 J0"], [0, "mdi", "G0 X0 Y0"]]},
    "jog-then-run": {"program": PATH, "acts": [[20, "jog", [0, 20, 0.7]], [22, "mdi", "G53 G0 X3 Y4 Z0"]]},
    "steps": {"program": PATH, "acts": [[1, "pause", 0], [1.5, "step", 0], [2.5, "resume", 0]]},
    "outputs": {"program": HEAD + "G61 F1200\nG1 X5\nM62 P0\nM67 E0 Q2.5\nG1 X10\nM63 P0\nG1 X15\nM64 P0\nG1 X20\nM65 P0\nM68 E0 Q1\nM2\n"},
    "outputs-blended": {"program": HEAD + "G64 P0.05 F1200\nG1 X5\nM62 P0\nG1 X10 Y1\nM63 P0\nG1 X15 Y0\nM2\n"},
    "adaptive": {"program": HEAD + "M52 P1\nG64 P0.01 F1200\nG1 X60\nM52 P0\nM2\n", "acts": [
        [0.8, "pin", ["motion.adaptive-feed", "0.5"]], [1.6, "pin", ["motion.adaptive-feed", "0"]],
        [2.2, "pin", ["motion.adaptive-feed", "0.8"]], [3, "pin", ["motion.adaptive-feed", "1"]]]},
    "rapid-override": {"program": HEAD + "G0 X80\nG0 X0\nM2\n", "acts": [[0, "rapid", 0.2]]},
    "probe": {"program": HEAD + "G38.2 Z-40 F600\n(DEBUG,#5063)\nG1 F1200 Z-2\nM2\n"},
    "dwell": {"program": HEAD + "G64 P0.01 F3000\nG1 X10\nG4 P0.2\nG1 Y10\nM2\n"},
    "helix": {"program": HEAD + "G64 P0.01 F3000\nG2 X0 Y0 Z-8 I10 J0 P4\nG18 G3 X10 Z-8 I5 K0\nG19 G2 Y10 Z-8 J5 K0\nM2\n"},
    "off": {"program": PATH, "acts": [[1.5, "off", 0]]},
}


class Interventions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        jobs = [{"name": name, **job} for name, job in JOBS.items() if not names or name in names]
        cls.results, cls.log = simulator.play(module, "leadscrew_tp jerk=20000", jobs, hal="signals.hal")

    def record(self, name, said=""):
        if name not in self.results:
            self.skipTest("not asked for")
        text, complaint, self.end = self.results[name]
        self.assertEqual(complaint, said, self.log[-2000:])
        record = Record(text)
        self.assertEqual(record.numbers, list(range(record.numbers[0], record.numbers[0] + len(record.numbers))))
        for order, limit in ((1, VELOCITY), (2, ACCELERATION), (3, JERK)):
            self.assertLessEqual(record.differences(order), 1.001 * limit, f"order {order}")
        return record

    def ends_at(self, *place):
        for found, wanted in zip(self.end["position"], place):
            self.assertAlmostEqual(found, wanted, places=9)

    def test_overrides_pause_and_resume(self):
        record = self.record("overrides")
        for second, speed in ((0.9, 20), (1.6, 10), (2.6, 0), (3.5, 10), (4.2, 30)):
            self.assertAlmostEqual(record.speed(second), speed, delta=0.2, msg=f"at {second} s")
        self.ends_at(0, 0, 0)

    def test_override_is_held_to_what_linuxcnc_allows(self):
        self.assertLessEqual(self.record("beyond").differences(1), 1.5 * 20 * 1.001)

    def test_greatest_velocity_holds_for_moves_under_way(self):
        record = self.record("greatest-velocity")
        for second, speed in ((0.9, 20), (1.9, 10), (2.9, 0), (3.9, 20)):
            self.assertAlmostEqual(record.speed(second), speed, delta=0.2, msg=f"at {second} s")
        self.ends_at(0, 0, 0)

    def test_abort_comes_to_rest_on_the_path(self):
        record = self.record("abort")
        self.assertEqual(record.places[-1], record.places[-50])
        self.assertNotEqual(record.places[-1], [0, 0, 0])

    def test_mdi_goes_on_after_an_abort(self):
        self.record("after-abort")
        self.ends_at(0, 0, 0)

    def test_jog_then_mdi(self):
        name = "jog-then-run"
        if name not in self.results:
            self.skipTest("not asked for")
        _, complaint, self.end = self.results[name]
        self.assertEqual(complaint, "", self.log[-2000:])
        self.ends_at(3, 4, 0)

    def test_single_steps(self):
        self.record("steps")
        self.ends_at(0, 0, 0)

    def test_outputs_come_with_their_moves(self):
        record = self.record("outputs")
        on = [i for i, (a, b) in enumerate(zip(record.outputs, record.outputs[1:])) if (a, b) == (0, 1)]
        off = [i for i, (a, b) in enumerate(zip(record.outputs, record.outputs[1:])) if (a, b) == (1, 0)]
        self.assertEqual((len(on), len(off)), (2, 2))
        # motmod's filter tells positions two periods late.
        for i, x in ((on[0], 5), (off[0], 10), (on[1], 15), (off[1], 20)):
            self.assertAlmostEqual(record.places[i][0], x, delta=0.07)
        self.assertEqual(record.analogs[on[0] + 1], 2.5)
        self.assertEqual(record.analogs[-1], 1)

    def test_outputs_of_blended_moves(self):
        record = self.record("outputs-blended")
        on = record.outputs.index(1)
        off = on + record.outputs[on:].index(0)
        self.assertAlmostEqual(record.places[on][0], 5, delta=0.3)
        self.assertAlmostEqual(record.places[off][0], 10, delta=0.3)

    def test_adaptive_feed(self):
        record = self.record("adaptive")
        for second, speed in ((0.8, 20), (1.5, 10), (2.1, 0), (2.9, 16)):
            self.assertAlmostEqual(record.speed(second), speed, delta=0.3, msg=f"at {second} s")
        self.ends_at(60, 0, 0)

    def test_override_of_rapids(self):
        self.assertLessEqual(self.record("rapid-override").differences(1), 0.2 * VELOCITY * 1.001)

    def test_probing_stops_within_limits(self):
        name = "probe"
        if name not in self.results:
            self.skipTest("not asked for")
        said = self.results[name][1]
        record = self.record(name, said)
        self.assertAlmostEqual(float(said), -12, delta=0.03)
        furthest = min(place[2] for place in record.places)
        self.assertLess(furthest, -12)
        self.assertGreater(furthest, -13)
        self.ends_at(0, 0, -2)

    def test_dwell(self):
        self.record("dwell")
        self.ends_at(10, 10, 0)

    def test_helix_and_arcs_of_other_planes(self):
        self.record("helix")
        self.ends_at(10, 10, -8)

    def test_off_in_motion(self):
        if "off" not in self.results:
            self.skipTest("not asked for")
        self.assertEqual(self.results["off"][1], "", self.log[-2000:])


if __name__ == "__main__":
    module, names = simulator.arguments()
    unittest.main(argv=sys.argv[:1])
