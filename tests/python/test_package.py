"""The package beside the command and beside formulas: judged traces, loops, kinematics, surfaces, pulses, studies; and its
stubs and docstrings beside what it has."""

import ast
import inspect
import pathlib
import tempfile
import unittest

import numpy as np
from common import EXAMPLES, MACHINES, TREE, command_json

import leadscrew
from leadscrew import _core

TRUNNION = leadscrew.Machine.load(MACHINES / "table-table-ac.toml")


class BesideTheCommand(unittest.TestCase):
    def compare(self, ours, told, leave_out=()):
        for key, value in told.items():
            if key not in ("program", "cpu", *leave_out):
                self.assertEqual(ours[key], value, key)

    def test_a_check_says_the_same(self):
        self.compare(leadscrew.check(EXAMPLES / "03-arcs-in-three-planes.ngc").figures,
                     command_json("check", EXAMPLES / "03-arcs-in-three-planes.ngc"), ["messages", "message_count"])

    def test_the_referee_says_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            trace = pathlib.Path(folder) / "trace.npy"
            command_json("run", EXAMPLES / "04-square.ngc", "--trace", trace)
            rows = np.load(trace)
            rows[300:, 4] += 0.05
            np.save(trace, rows)
            told = command_json("verify", trace, EXAMPLES / "04-square.ngc", status=1)
            ours = leadscrew.verify(rows[:, 4:], EXAMPLES / "04-square.ngc")
            self.assertFalse(ours.kept)
            # The feed that a trace tells is not told by positions.
            self.compare(ours.figures, told, ["trace", "diagnostics", "feed", "violations", "violation_count"])
            self.assertGreater(ours.violation_count, 0)

    def test_loops_say_the_same(self):
        machine = MACHINES / "mill3-drives.toml"
        ours = leadscrew.simulate(EXAMPLES / "04-square.ngc", machine=machine)
        self.compare(ours.figures, command_json("simulate", EXAMPLES / "04-square.ngc", "--machine", machine))
        self.assertFalse(ours.rows.flags.owndata)
        gains = leadscrew.Machine.mill3().with_loops(controller="pid", proportional=2, integral=2, derivative=15,
                                                     velocity_forward=0, acceleration_forward=0)
        ours = leadscrew.simulate(EXAMPLES / "04-square.ngc", machine=gains)
        self.compare(ours.figures, command_json("simulate", EXAMPLES / "04-square.ngc", "--gains", "2,2,15", status=1))

    def test_pulses_say_the_same(self):
        for method in leadscrew.pulse_methods():
            told = command_json("pulse", "--arc", "--start", "50,0", "--end", "0,50", "--ccw", "--method", method, "--path")
            ours = leadscrew.pulse_arc((50, 0), (0, 50), method=method)
            method_told = told["methods"][0]
            self.assertEqual(ours.figures["clocks"], method_told["clocks"])
            self.assertEqual(ours.figures["pulses"], method_told["pulses"])
            self.assertEqual(ours.figures["max_error"], method_told["max_error_blu"])
            self.assertEqual(ours.places[-1].tolist(), [0, 50])

    def test_studies_say_the_same(self):
        told = command_json("study", "lecture")
        self.assertEqual(leadscrew.study("lecture"), told["rows"])
        self.assertIn("lecture", leadscrew.studies())


class Paths(unittest.TestCase):
    def test_keep_limits_and_tolerance(self):
        rng = np.random.default_rng(1980)
        machine = leadscrew.Machine.mill3()
        for _ in range(3):
            points = np.cumsum(rng.uniform(-15, 15, (8, 3)), axis=0)
            points -= points.min(axis=0)
            for path in (leadscrew.waypoints(points, tolerance=0.05, machine=machine), leadscrew.curve(points, machine=machine),
                         leadscrew.waypoints(points, stops=True, feed=40, machine=machine)):
                result = path.run()
                self.assertTrue(result.kept)
                self.assertTrue(path.verify(result.words).kept)
                np.testing.assert_allclose(result.positions[-1], points[-1], atol=1e-9)

    def test_go_in_any_axes(self):
        six = leadscrew.Machine.load(MACHINES / "mill6.toml")
        points = np.array([[0, 0, 0, 0, 0, 0], [20, 10, 5, 30, -20, 60], [30, 20, 0, 0, 10, 90.0]])
        result = leadscrew.waypoints(points, machine=six, tolerance=0.1).run()
        self.assertTrue(result.kept)
        np.testing.assert_allclose(result.positions[-1], points[-1], atol=1e-9)

    def test_have_arcs_dwells_and_stops(self):
        path = leadscrew.Path(start=[10, 0, 0])
        path.arc([0, 10, 5], [0, 0], feed=20).dwell(0.25).line({"Z": 0}, feed=20).stop().line([0, 0], feed=20)
        result = path.run()
        self.assertTrue(result.kept)
        self.assertEqual(result.dwell_s, 0.25)
        radii = np.hypot(*result.positions[result.words["line"] == 1][:, :2].T)
        np.testing.assert_allclose(radii, 10, atol=1e-9)

    def test_of_the_tool_keep_tip_and_direction(self):
        turn = np.linspace(0, np.pi, 60)
        directions = np.stack([0.3 * np.cos(turn), 0.3 * np.sin(turn), np.ones_like(turn)], axis=1)
        tips = np.stack([20 * np.cos(turn), 20 * np.sin(turn), 0 * turn], axis=1)
        result = leadscrew.tool_path(tips, directions, feed=20, machine=TRUNNION).run()
        self.assertTrue(result.kept)
        led, along = TRUNNION.forward(result.words[-1:])
        np.testing.assert_allclose(led[0], tips[-1], atol=1e-6)
        np.testing.assert_allclose(along[0], directions[-1] / np.linalg.norm(directions[-1]), atol=1e-6)

    def test_states_are_derivatives_of_one_another(self):
        planned = leadscrew.waypoints([[0, 0, 0], [50, 20, 5]]).plan()
        middle = np.linspace(0.1, 0.9, 50) * planned.duration
        step = 1e-6
        before, at, after = (planned.at(middle + d) for d in (-step, 0, step))
        for name, derivative in (("position", "velocity"), ("velocity", "acceleration")):
            slope = (after[name] - before[name]) / (2 * step)
            np.testing.assert_allclose(slope, at[derivative], rtol=1e-3, atol=0.5)


class Kinematics(unittest.TestCase):
    def test_forward_undoes_inverse(self):
        rng = np.random.default_rng(1980)
        for name in ("table-table-ac", "head-b-table-c", "head-head-ac"):
            machine = leadscrew.Machine.load(MACHINES / f"{name}.toml")
            tips, directions = rng.uniform(-50, 50, (200, 3)), rng.normal(size=(200, 3)) * [0.3, 0.3, 0] + [0, 0, 1]
            unit = directions / np.linalg.norm(directions, axis=1)[:, np.newaxis]
            both = machine.inverse(tips, directions, tool=[0, 0, 80])
            self.assertEqual(both.shape, (200, 2, 5))
            for solution in (0, 1):
                led, along = machine.forward(both[:, solution], tool=[0, 0, 80])
                np.testing.assert_allclose(led, tips, atol=1e-9)
                np.testing.assert_allclose(along, unit, atol=1e-12)


class Surfaces(unittest.TestCase):
    def test_are_those_of_a_cylinder(self):
        # A quarter of a cylinder of radius 10, exactly: rational of degree 2.
        w = np.sqrt(0.5)
        quarter = np.array([[10, 0], [10, 10], [0, 10.0]])
        points = np.stack([np.column_stack([np.full(3, x), quarter]) for x in (0.0, 30.0)])
        surface = leadscrew.Surface(points, weights=[[1, w, 1]] * 2, degree=(1, 2))
        found = surface.evaluate(np.linspace(0, 1, 5)[:, np.newaxis], np.linspace(0, 1, 7))
        np.testing.assert_allclose(np.hypot(found["position"][..., 1], found["position"][..., 2]), 10, atol=1e-12)
        np.testing.assert_allclose(np.abs(found["curvature"]).max(axis=-1), 0.1, rtol=1e-12)
        np.testing.assert_allclose(np.linalg.norm(found["normal"], axis=-1), 1, rtol=1e-12)
        np.testing.assert_allclose(np.abs(np.sum(found["normal"] * found["by_u"], axis=-1)), 0, atol=1e-12)

    def test_have_passes_that_touch_them(self):
        x, y = np.meshgrid(np.linspace(0, 30, 5), np.linspace(0, 20, 5), indexing="ij")
        surface = leadscrew.Surface(np.stack([x, y, 2 * np.sin(x / 10) + y / 10], axis=2))
        passes = surface.passes(radius=3, step=2)
        cuts = [each for each in passes if not each["is_link"]]
        self.assertEqual([each["number"] for each in cuts], list(range(len(cuts))))
        for each in cuts:
            at = surface.evaluate(each["uv"][:, 0], each["uv"][:, 1])
            np.testing.assert_allclose(at["position"], each["contact"], atol=1e-9)
            np.testing.assert_allclose(each["tip"], at["position"] + 3 * at["normal"] - [0, 0, 3], atol=1e-9)

    def test_are_read_back_by_programs(self):
        x, y = np.meshgrid(np.linspace(0, 20, 4), np.linspace(0, 20, 4), indexing="ij")
        surface = leadscrew.Surface(np.stack([x, y, x * y / 200], axis=2))
        program = "G21 G90 G94\nT4 M6\n" + surface.blocks(3) + "G0 Z20\nG6.5 D3 H0.1 Z20 F3000\nG0 Z20\nM2\n"
        self.assertTrue(leadscrew.run(program, tools=EXAMPLES / "tools.tbl").kept)


def members(tree):
    """Of a stub: its functions, and its classes with their members."""
    found = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            found[node.name] = {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
        elif isinstance(node, ast.FunctionDef):
            found[node.name] = None
        elif isinstance(node, ast.AnnAssign) and not node.target.id.startswith("_"):
            found[node.target.id] = None
    return found


class Stubs(unittest.TestCase):
    def test_name_what_the_module_has(self):
        stub = members(ast.parse((TREE / "python" / "leadscrew" / "_core.pyi").read_text()))
        has = {}
        for name, value in vars(_core).items():
            if name.startswith("__"):
                continue
            has[name] = {each for each in vars(value) if not each.startswith("_") or each == "__init__"} \
                if inspect.isclass(value) else None
        for name, known in stub.items():
            if known is not None and "__init__" not in known:
                has[name].discard("__init__")  # those that refuse to be made
        self.assertEqual(stub, has)

    def test_of_arguments_are_those_of_the_module(self):
        tree = ast.parse((TREE / "python" / "leadscrew" / "_core.pyi").read_text())
        for node in tree.body:
            for function in node.body if isinstance(node, ast.ClassDef) else [node]:
                if not isinstance(function, ast.FunctionDef) or function.decorator_list:
                    continue
                of = getattr(_core, node.name)
                told = (getattr(of, function.name) if of is not None and isinstance(node, ast.ClassDef) else of).__doc__
                for argument in function.args.args:
                    if argument.arg != "self":
                        self.assertIn(f"{argument.arg}: ", told, f"{node.name}.{function.name}")

    def test_are_installed_with_the_package(self):
        folder = pathlib.Path(leadscrew.__file__).parent
        self.assertTrue((folder / "py.typed").exists())
        self.assertTrue((folder / "_core.pyi").exists())

    def test_docstrings_and_types_are_there(self):
        for name in leadscrew.__all__:
            value = getattr(leadscrew, name)
            if not (inspect.isclass(value) or inspect.isfunction(value)):
                continue
            self.assertTrue(value.__doc__, name)
            for inner, each in [(name, value)] if inspect.isfunction(value) else vars(value).items():
                if inner.startswith("_") or not (inspect.isfunction(each) or isinstance(each, property)):
                    continue
                function = each.fget if isinstance(each, property) else each
                self.assertIn("return", function.__annotations__, f"{name}.{inner}")
                if name != "Diagnostic" and not (isinstance(each, property) and inner == "name"):
                    self.assertTrue(each.__doc__, f"{name}.{inner}")


if __name__ == "__main__":
    unittest.main()
