"""CNC part programs, waypoints and curves into motion.

    import leadscrew
    result = leadscrew.run("part.ngc", machine="mill.toml")
    print(result.time_s, result.deviation_mm)
    result.words["position"][:, 0]          # X at each servo period, without a copy

Lengths are mm, angles degrees, times seconds, feeds mm/s. Columns of axes stand in the order X Y Z A B C U V W: in words and
states all nine, in what is given those of the machine. ProblemError says what is wrong with a program, where, and what would
be right; TypeError and ValueError say what was expected of an argument.
"""

from __future__ import annotations

from . import _core
from .machines import Machine
from .motion import RAPID, Path, Program, check, curve, plan, run, simulate, tool_path, verify, waypoints
from .problems import Diagnostic, ProblemError
from .pulses import Pulses, pulse_arc, pulse_line, pulse_methods
from .results import CHANGING, CONSTANT, REST, Check, Result, Simulation, Trajectory, Verdict
from .studies import studies, study
from .surfaces import Surface

__version__: str = _core.version

__all__ = [
    "CHANGING", "CONSTANT", "Check", "Diagnostic", "Machine", "Path", "ProblemError", "Program", "Pulses", "RAPID", "REST",
    "Result", "Simulation", "Surface", "Trajectory", "Verdict", "check", "curve", "plan", "pulse_arc", "pulse_line",
    "pulse_methods", "run", "simulate", "studies", "study", "tool_path", "verify", "waypoints",
]
