#!/usr/bin/env python3
"""spindle.py MODULE: threads, taps and feed per revolution inside LinuxCNC, under a spindle that wanders by 5 %. Every record
is held against the limits by its own differences."""
import sys
import unittest

import simulator
from interventions import ACCELERATION, JERK, VELOCITY, Record

HEAD = "G21 G90 G17 G94\nM3 S600\n"
JOBS = {
    "thread": {"program": HEAD + "G0 Z10\nG4 P1\nG33 Z-10 K1\nM5\nG0 Z0\nM2\n"},
    "two-threads": {"program": HEAD + "G0 Z10\nG4 P1\nG33 Z0 K1\nG33 X2 Z-10 K1\nM5\nG0 Z0\nM2\n"},
    "cycle": {"program": HEAD + "G0 X10 Z5\nG4 P1\nG18 G76 P1 Z-8 I-1 J0.2 K0.6 R1 Q0 H0 E0 L0\nM5\nM2\n"},
    "tap": {"program": HEAD + "G0 Z5\nG4 P1\nG33.1 Z-8 K1\nM5\nM2\n"},
    "per-revolution": {"program": HEAD + "G4 P1\nG95 F0.2\nG1 X5\nG94\nM5\nM2\n"},
    "aborted-thread": {"program": HEAD + "G4 P1\nG33 Z-30 K1\nM5\nM2\n", "acts": [[3, "abort", 0]]},
    "aborted-tap": {"program": HEAD + "G4 P1\nG33.1 Z-30 K1\nM5\nM2\n", "acts": [[3, "abort", 0]]},
}


TRAVERSE = 1  # of motion.motion-type
PASSES = 3  # of that cycle


class Turns:
    """What spindle.hal's sampler takes down behind so many axes, a period each: the spindle's revolutions, and whether the move is
    one of the program's threads: of a line with G33, G76 or G33.1, and no rapid between them."""

    def __init__(self, text, program, axes=3):
        lines = {number for number, line in enumerate(program.splitlines(), 1) if "G33" in line or "G76" in line}
        rows = [row.split()[1 + axes:] for row in text.splitlines() if row.strip() != "overrun"]
        self.revolutions = [float(row[0]) for row in rows]
        self.are_threads = [int(row[1]) in lines and int(row[2]) != TRAVERSE for row in rows]


def errors(places, turns, top, start, end, lead=1):
    """Of each period of threads from `top` on, in which they are between `start` and `end`: the distance from the spindle's own place,
    mm; and how far it has turned the axis in these periods, forth and back, mm. By the words that belong together: motmod's filter
    tells positions two periods late."""
    found, travel = [], 0
    for i, place in enumerate(places[2:]):
        if turns.are_threads[i] and start > place > end:
            found.append(abs(top - lead * turns.revolutions[i] - place))
            travel += lead * abs(turns.revolutions[i] - turns.revolutions[i - 1])
    return found, travel


class Spindle(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        jobs = [{"name": name, **job} for name, job in JOBS.items() if not names or name in names]
        cls.results, cls.log = simulator.play(module, "leadscrew_tp jerk=20000", jobs, hal="spindle.hal")

    def record(self, name):
        """The record within limits, and the spindle's turns."""
        if name not in self.results:
            self.skipTest("not asked for")
        text, complaint, self.end = self.results[name]
        self.assertEqual(complaint, "", self.log[-2000:])
        record = Record(text, outputs=False)
        for order, limit in ((1, VELOCITY), (2, ACCELERATION), (3, JERK)):
            self.assertLessEqual(record.differences(order), 1.001 * limit, f"order {order}")
        return record, Turns(text, JOBS[name]["program"])

    def is_in_step(self, record, turns, top, end, ways=1):
        """Behind a run-in of 1.3 mm, within P of 0.01 mm, in each period of so many ways to `end`, or as deep as it goes."""
        depths = [place[2] for place in record.places]
        found, travel = errors(depths, turns, top, top - 1.3, end)
        print(f"{len(found)} periods, {travel:.3f} mm, {1e3 * max(found):.2f} µm at most")
        self.assertAlmostEqual(travel, ways * (top - 1.3 - max(end, min(depths))), delta=0.03 * ways)
        self.assertLess(max(found), 0.01)

    def test_thread_is_in_step_behind_its_run_in(self):
        self.is_in_step(*self.record("thread"), 10, -9)

    def test_threads_one_behind_the_other(self):
        record, turns = self.record("two-threads")
        self.is_in_step(record, turns, 10, 0.5)
        self.assertLess(min(place[2] for place in record.places), -9.999)

    def test_cycle_of_threading(self):
        self.is_in_step(*self.record("cycle"), 5, -7, ways=PASSES)

    def test_tap_comes_back_to_where_it_began(self):
        record, turns = self.record("tap")
        self.is_in_step(record, turns, 5, -10, ways=2)
        self.assertLess(min(place[2] for place in record.places), -8)
        self.assertTrue(any(place[2] == 5 for place in record.places[-1000:]))

    def test_feed_per_revolution(self):
        self.assertAlmostEqual(self.record("per-revolution")[0].differences(1), 2.1, delta=0.05)

    def test_aborted_thread(self):
        record, _ = self.record("aborted-thread")
        self.assertGreater(record.places[-1][2], -29)

    def test_aborted_tap(self):
        record, _ = self.record("aborted-tap")
        self.assertGreater(record.places[-1][2], -29)


if __name__ == "__main__":
    module, names = simulator.arguments()
    unittest.main(argv=sys.argv[:1])
