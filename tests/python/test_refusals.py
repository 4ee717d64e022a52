"""What is wrong raises, and says what was expected and what was found."""

import copy
import pathlib
import subprocess
import sys
import pickle
import tempfile
import unittest

import numpy as np
from common import EXAMPLES, MACHINES

import leadscrew

PROBLEM = leadscrew.ProblemError
NAN = float("nan")
TRUNNION = leadscrew.Machine.load(MACHINES / "table-table-ac.toml")
PATCH = np.stack([*np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij"), np.zeros((4, 4))], axis=2)
BOWL = PATCH * [10, 10, 1] + np.array([0, 0, 1]) * ((PATCH - 1.5) ** 2).sum(axis=2)[..., np.newaxis] * 6

# What is called, the exception, what its text says.
CASES = [
    (lambda: leadscrew.run(42), TypeError, "expected a path or a program's text, found int 42"),
    (lambda: leadscrew.run("G1 X1\n", machine=3), TypeError, "machine: expected a Machine.*found int 3"),
    (lambda: leadscrew.run("M2\n", tolerance="0.1"), TypeError, r"tolerance: expected a number \(mm\), found str '0.1'"),
    (lambda: leadscrew.run("M2\n", tolerance=-1), ValueError, r"tolerance: expected 0 or more \(mm\), found -1"),
    (lambda: leadscrew.run("M2\n", period=1), ValueError, r"period: expected 1e-05 or more and at most 0.02 \(s\), found 1"),
    (lambda: leadscrew.run("M2\n", mode="round"), ValueError, "mode: expected one of blend, exact-stop, found 'round'"),
    (lambda: leadscrew.run("M2\n", interpolator="cubic"), ValueError, "interpolator: expected one of arc-length"),
    (lambda: leadscrew.run("M2\n", fuel=2.5), TypeError, "fuel: expected a whole number, found float 2.5"),
    (lambda: leadscrew.run("M2\n", start={"Q": 1}), ValueError, "start: expected axes X Y Z, found 'Q'"),
    (lambda: leadscrew.run("M2\n", start=[1, 2, 3, 4]), ValueError, "start: expected 1 to 3 columns, X Y Z, found 4"),
    (lambda: leadscrew.run("M2\n", progress=1), TypeError, "progress: expected a function"),
    (lambda: leadscrew.Program("M2\n", text="M2\n"), TypeError, "expected either the path of a program, or text="),
    (lambda: leadscrew.waypoints([[0, 0, 0]]), ValueError, "points: expected 2 or more, found 1"),
    (lambda: leadscrew.waypoints([0, 1, 2]), ValueError, "points: expected shape n × 3, columns X Y Z, found 3"),
    (lambda: leadscrew.waypoints([[0, 0], [1]]), ValueError, "points: .*rows of different lengths"),
    (lambda: leadscrew.waypoints([["a", "b"], ["c", "d"]]), TypeError, "points: expected n × 3.*found <U1"),
    (lambda: leadscrew.waypoints([[0, 0], [NAN, 1]]), ValueError, r"points: expected finite numbers, found nan at \[1, 0\]"),
    (lambda: leadscrew.waypoints(np.zeros((3, 5))), ValueError, "points: expected 1 to 3 columns, X Y Z, found 5"),
    (lambda: leadscrew.waypoints([[0, 0], [1, 0]], feed=0), ValueError, r"feed: expected more than 0 \(mm/s\), found 0"),
    (lambda: leadscrew.waypoints([[0, 0], [1, 0]], feed=[1, 2, 3]), ValueError, r"feed: expected one above 0, or 1 of them"),
    (lambda: leadscrew.waypoints([[0, 0], [1, 0]], feed="60"), TypeError, "feed: expected a number"),
    (lambda: leadscrew.curve([[0, 0], [1, 0], [2, 1], [3, 0]], weights=[1, 1]), ValueError, "weights: expected 4"),
    (lambda: leadscrew.curve([[0, 0], [1, 0], [2, 1], [3, 0]], degree=9), ValueError, "degree: expected 1 to 5, found 9"),
    (lambda: leadscrew.Path().arc([1, 0], [1, 2, 3]), ValueError, "center: expected two coordinates of the plane XY, found 3"),
    (lambda: leadscrew.Path().dwell(-1), ValueError, r"seconds: expected 0 or more and at most 1e\+06 \(s\), found -1"),
    (lambda: leadscrew.Machine.mill3().changed(jerk=[1, 2]), ValueError, "jerk: expected a number, or 3 of them, X Y Z, found 2"),
    (lambda: leadscrew.Machine.mill3().changed(travel=[1, 2, 3]), ValueError, "travel: expected 3 × 2"),
    (lambda: leadscrew.Machine.mill3().with_loops(stiffness=1), TypeError, "expected position_gain.*found 'stiffness'"),
    (lambda: leadscrew.Machine.mill3().forward([[0, 0, 0]]), ValueError, "cartesian: expected one with a chain of rotary axes"),
    (lambda: TRUNNION.inverse([[0, 0, 0]], [[0, 0, 0]]), ValueError, "directions: expected vectors of some length, found 0 0 0"),
    (lambda: TRUNNION.inverse([[0, 0, 0]], [[0, 0, 1], [0, 0, 1]]), ValueError, "directions: expected 1 rows"),
    (lambda: TRUNNION.inverse([[0, 0]], [[0, 0, 1]]), ValueError, "tips: expected shape n × 3, found 1 × 2"),
    (lambda: leadscrew.tool_path([[0, 0, 0]] * 2, [[0, 0, 1]] * 2, feed=10, machine="mill3"), ValueError, "which is cartesian"),
    (lambda: leadscrew.verify([], "M2\n"), ValueError, "positions: expected shape n × 3"),
    (lambda: leadscrew.verify(np.zeros(3, dtype=[("t", float)]), "M2\n"), ValueError, "expected words, with a field position, found fields t"),
    (lambda: leadscrew.plan("M2\n").at("now"), TypeError, "times: expected n times"),
    (lambda: leadscrew.run("M2\n").axis("A"), ValueError, "axis: expected one of X, Y, Z, found 'A'"),
    (lambda: leadscrew.run("M2\n").derivative(4), ValueError, "order: expected 1 to 3, found 4"),
    (lambda: leadscrew.Surface(np.zeros((4, 4))), ValueError, "points: expected shape nu × nv × 3, found 4 × 4"),
    (lambda: leadscrew.Surface(np.zeros((4, 4, 3))), ValueError, "coincide: expected a surface without folds"),
    (lambda: leadscrew.Surface(PATCH[:3]), ValueError, "in u do not go together"),
    (lambda: leadscrew.Surface(PATCH, weights=np.zeros((4, 4))), ValueError, "weight 0 is not above 0"),
    (lambda: leadscrew.Surface(PATCH).passes(radius=1), TypeError, "expected either scallop or step"),
    (lambda: leadscrew.Surface(PATCH).passes(radius=-1, step=1), ValueError, r"radius: expected more than 0 \(mm\), found -1"),
    (lambda: leadscrew.Surface(BOWL).passes(radius=30, step=1), ValueError, "gouges where it touches: expected a smaller tool"),
    (lambda: leadscrew.pulse_arc((5, 0), (0, 5.5)), TypeError, "end: expected a whole number, found float 5.5"),
    (lambda: leadscrew.pulse_arc((5, 0), 5), TypeError, r"end: expected two whole numbers \(BLU\), found 5"),
    (lambda: leadscrew.pulse_line((0, 0), (5, 5), method="best"), ValueError, "method: expected one of point-comparison"),
    (lambda: leadscrew.pulse_line((0, 0), (5, 5), method="bresenham", bits=8, preload="half"), ValueError, "does not have an option"),
    (lambda: leadscrew.study("nothing"), ValueError, "name: expected one of butterfly"),
    (lambda: leadscrew.run("M2\n").nothing, AttributeError, "has no 'nothing'; its figures are schema"),
]

# What is not sound: called, and the code of the first error.
PROBLEMS = [
    (lambda: leadscrew.run("no-such-file.ngc"), "io-open"),
    (lambda: leadscrew.Machine.of_text("name = 3"), "machine-axes"),
    (lambda: leadscrew.Machine.mill3().changed(jerk=-1), "machine-limit"),
    (lambda: leadscrew.Path().line([1e6, 0, 0]), "travel"),
    (lambda: leadscrew.Path().arc([10, 0, 0], [4, 4], feed=10), "arc-radius"),
    (lambda: leadscrew.curve([[0, 0], [1, 0]], degree=3), "curve-points"),
    (lambda: leadscrew.Path(start={"X": 1e6}), "travel"),
    (lambda: leadscrew.pulse_arc((5, 0), (0, 6)), "end-off-circle"),
    (lambda: leadscrew.simulate("G1 X10 F600\nM2\n", machine=leadscrew.Machine.mill3().with_loops(
        controller="cascade", position_gain=1e6)), "servo-unstable"),
]


class Refusals(unittest.TestCase):
    def test_say_what_was_expected_and_what_was_found(self):
        for number, (call, kind, text) in enumerate(CASES):
            with self.subTest(number=number, text=text), self.assertRaisesRegex(kind, text):
                call()

    def test_of_what_is_not_sound_have_the_code_of_the_library(self):
        for number, (call, code) in enumerate(PROBLEMS):
            with self.subTest(number=number, code=code), self.assertRaises(PROBLEM) as raised:
                call()
            self.assertEqual(raised.exception.code, code)

    def test_of_programs_have_all_places(self):
        with self.assertRaises(PROBLEM) as raised:
            leadscrew.run("G21 G90 G94\nG1 X10 F600\nG2 X5 Y5 I3\nG77\nM2\n", name="part.ngc")
        error = raised.exception
        self.assertEqual((error.code, error.file, error.line, error.column), ("arc-radius", "part.ngc", 3, 1))
        self.assertIn("the centre must be", error.hint)
        self.assertEqual([each.line for each in error.diagnostics], [3, 4])
        self.assertIn("part.ngc:3:1: error: arc radius differs", str(error))
        self.assertIn("G2 X5 Y5 I3\n    ^", str(error))

    def test_of_machine_files_have_all_places(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "wrong.toml"
            text = (MACHINES / "mill3.toml").read_text().replace("period_us", "period_uss")
            file.write_text(text)
            with self.assertRaises(PROBLEM) as raised:
                leadscrew.run("M2\n", machine=file)
        self.assertEqual(raised.exception.code, "machine-key")
        self.assertEqual(raised.exception.line, 1 + text[:text.index("period_uss")].count("\n"))

    def test_of_checks_are_told_and_not_raised(self):
        found = leadscrew.check("G2 X5 Y5 I3 F100\nM2\n")
        self.assertEqual(found.diagnostics[0].code, "arc-radius")
        self.assertEqual(leadscrew.check(EXAMPLES / "04-square.ngc").diagnostics, ())

    def test_of_a_study_that_has_no_memory_say_so(self):
        # In a process of its own, whose memory may not grow; the study runs in another.
        text = """
import resource
import leadscrew
with open("/proc/self/statm") as file:
    most = int(file.read().split()[0]) * resource.getpagesize() + 400_000
resource.setrlimit(resource.RLIMIT_AS, (most, most))
try:
    leadscrew.study("limits")
except RuntimeError as error:
    print(error, flush=True)
"""
        said = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=False)
        self.assertEqual((said.stdout, said.stderr, said.returncode), ("std::bad_alloc\n", "", 0))

    def test_change_nothing(self):
        path = leadscrew.Path().line([10, 0, 0], feed=50)
        with self.assertRaises(PROBLEM):
            path.line([1e6, 0, 0])
        self.assertEqual(path.end.tolist(), [10, 0, 0])
        with self.assertRaises(PROBLEM):
            path.lines([[20, 0, 0], [1e6, 0, 0], [30, 0, 0]], feed=50)
        self.assertEqual(path.end.tolist(), [10, 0, 0])
        self.assertEqual(path.run().moves, 1)

    def test_are_the_same_in_another_process(self):
        with self.assertRaises(PROBLEM) as raised:
            leadscrew.run("G21 G90 G94\nG1 X10 F600\nG2 X5 Y5 I3\nG77\nM2\n", name="part.ngc")
        for again in (pickle.loads(pickle.dumps(raised.exception)), copy.copy(raised.exception)):
            self.assertIs(type(again), PROBLEM)
            self.assertEqual(again.diagnostics, raised.exception.diagnostics)
            self.assertEqual((str(again), again.code, again.line, again.hint),
                             (str(raised.exception), "arc-radius", 3, raised.exception.hint))


if __name__ == "__main__":
    unittest.main()
