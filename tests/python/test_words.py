"""Words are those of `leadscrew run --trace`, bit for bit, and are handed over without a copy."""

import pathlib
import tempfile
import unittest

import numpy as np
from common import EXAMPLES, MACHINES, command_json

import leadscrew

# Three axes with tools and cycles, arcs in three planes, a rotary axis, curves; then five axes through lines and a pole.
CASES = {
    "01-plate": {"tools": EXAMPLES / "tools.tbl"},
    "03-arcs-in-three-planes": {},
    "04-square": {},
    "07-rotary": {"machine": MACHINES / "mill6.toml"},
    "09-butterfly": {},
    "11-splines": {},
    "13-blade": {"machine": MACHINES / "table-table-ac.toml"},
    "15-through-a-pole": {"machine": MACHINES / "table-table-ac.toml"},
}


class Words(unittest.TestCase):
    def test_are_those_of_the_trace_and_figures_those_of_json(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, options in CASES.items():
                with self.subTest(name):
                    program = EXAMPLES / f"{name}.ngc"
                    trace = pathlib.Path(folder) / f"{name}.npy"
                    given = [part for key, path in options.items() for part in (f"--{key}", path)]
                    told = command_json("run", program, "--trace", trace, *given)
                    result = leadscrew.run(program, **options)
                    rows = np.load(trace)
                    words = result.words
                    ours = np.column_stack([result.time, words["line"], words["path_length"], words["feed"], result.positions])
                    self.assertEqual(rows[:, :ours.shape[1]].tobytes(), ours.tobytes())
                    if rows.shape[1] > ours.shape[1]:  # tip and direction, of a machine with a chain, as the tool is held
                        _, directions = result.machine.forward(words)
                        np.testing.assert_allclose(directions, rows[:, -3:], atol=1e-12)
                    for key, value in told.items():
                        if key not in ("cpu", "program"):
                            self.assertEqual(value, result[key], key)

    def test_saved_are_the_file_that_the_command_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            trace, saved = pathlib.Path(folder) / "trace.npy", pathlib.Path(folder) / "saved.npy"
            command_json("run", EXAMPLES / "04-square.ngc", "--trace", trace)
            leadscrew.run(EXAMPLES / "04-square.ngc").save(saved)
            self.assertEqual(np.load(trace).tobytes(), np.load(saved).tobytes())

    def test_a_million_are_not_copied(self):
        path = leadscrew.Path(tolerance=0)
        for _ in range(52):
            path.line([100, 0, 0], feed=10).line([0, 0, 0], feed=10)
        words = path.run().words
        self.assertGreater(len(words), 1_000_000)
        self.assertFalse(words.flags.owndata)
        self.assertEqual(type(words.base).__name__, "PyCapsule")
        self.assertEqual(words.strides, (words.dtype.itemsize,))
        first = words["position"][:, 0]
        self.assertTrue(np.shares_memory(first, words))
        self.assertFalse(first.flags.owndata)

    def test_stay_when_the_run_is_forgotten(self):
        words = leadscrew.run(EXAMPLES / "04-square.ngc").words
        again = leadscrew.run(EXAMPLES / "04-square.ngc").words
        np.testing.assert_array_equal(words, again)

    def test_of_paths_are_those_of_the_program_that_asks_for_the_same(self):
        path = leadscrew.waypoints([[0, 0, 0], [40, 0, 0], [60, 30, 5], [40, 60, 10]], feed=100, tolerance=0.05).run()
        program = leadscrew.run("G21 G90 G94 G64 P0.05\nG1 X40 F6000\nX60 Y30 Z5\nX40 Y60 Z10\nM2\n")
        np.testing.assert_array_equal(path.words["position"], program.words["position"])

    def test_of_a_plan_are_those_of_the_run(self):
        program = leadscrew.Program(EXAMPLES / "09-butterfly.ngc")
        result, planned = program.run(), program.plan()
        np.testing.assert_array_equal(planned.words["position"], result.words["position"])
        np.testing.assert_array_equal(planned.at(result.time)["position"], result.words["position"])

    def test_by_a_text_are_those_of_its_file(self):
        text = (EXAMPLES / "04-square.ngc").read_text()
        np.testing.assert_array_equal(leadscrew.run(text).words, leadscrew.run(EXAMPLES / "04-square.ngc").words)


if __name__ == "__main__":
    unittest.main()
