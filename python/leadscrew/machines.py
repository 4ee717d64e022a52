"""Machines: limits, period and kinematics."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Optional, Union

import numpy as np

from . import _core, checks

_LARGEST_FILE = 1 << 19  # bytes

_DIALECTS = ("leadscrew", "linuxcnc", "fanuc", "haas", "grbl", "mach3", "marlin", "fanuc-lathe")
_LOOPS = {
    "position_gain": "1/s", "velocity_gain": "1/s", "velocity_integral": "1/s²", "proportional": "units/mm",
    "integral": "units/(mm s)", "derivative": "units/mm", "gain": "mm/s a unit", "time_constant": "ms",
    "velocity_forward": "share, 0 … 1", "acceleration_forward": "share, 0 … 1",
}


class Machine:
    """What a machine can do: axes with travel, velocity, acceleration and jerk, its period, its tolerance. Never changes.

    Lengths are mm, angles degrees, times seconds. Axes are told in the order X Y Z A B C U V W, those that there are.
    """

    def __init__(self, core: _core.Machine) -> None:
        self._core = core

    @staticmethod
    def mill3() -> "Machine":
        """The built-in mill of three axes."""
        return Machine(_core.Machine.builtin())

    @staticmethod
    def load(path: Union[str, "os.PathLike[str]"]) -> "Machine":
        """Of a machine file, TOML. ProblemError has everything that is wrong with it; OSError where it cannot be read."""
        found = pathlib.Path(path)
        if found.stat().st_size > _LARGEST_FILE:
            raise ValueError(f"{path}: expected a machine file of at most {_LARGEST_FILE} bytes, "
                             f"found {found.stat().st_size}")
        return Machine(_core.Machine.of_text(found.read_bytes().decode("utf-8", "replace"), os.fspath(path)))

    @staticmethod
    def of_text(text: str, name: str = "<machine>") -> "Machine":
        """Of a machine file's text; `name` is for the places of errors."""
        return Machine(_core.Machine.of_text(checks.text(text, "text"), checks.text(name, "name")))

    @property
    def name(self) -> str:
        return self._core.name

    @property
    def axes(self) -> str:
        """Letters of its axes, such as "XYZAC"."""
        return self._core.axes

    @property
    def period(self) -> float:
        """Of the servo, s."""
        return self._core.period_ns / 1e9

    @property
    def tolerance(self) -> float:
        """Of smoothed paths (G64 without P), mm."""
        return self._core.tolerance

    @property
    def chord_error(self) -> float:
        """Between words, mm."""
        return self._core.chord_error

    @property
    def has_kinematics(self) -> bool:
        """Does it have a chain of rotary axes, so that tip and direction of the tool are known?"""
        return self._core.kinematics != "cartesian"

    def _limit(self, name: str) -> np.ndarray:
        return self._core.limits()[name][self.columns]

    @property
    def columns(self) -> list[int]:
        """Where its axes are in nine columns X Y Z A B C U V W."""
        return [checks.AXES.index(axis) for axis in self.axes]

    @property
    def velocity(self) -> np.ndarray:
        """Limit of each axis, mm/s or degrees/s."""
        return self._limit("velocity")

    @property
    def acceleration(self) -> np.ndarray:
        """Limit of each axis, mm/s² or degrees/s²."""
        return self._limit("acceleration")

    @property
    def jerk(self) -> np.ndarray:
        """Limit of each axis, mm/s³ or degrees/s³."""
        return self._limit("jerk")

    @property
    def travel(self) -> np.ndarray:
        """Least and greatest coordinate of each axis, k × 2, mm or degrees."""
        return np.stack([self._limit("travel_min"), self._limit("travel_max")], axis=1)

    def changed(self, *, velocity: Any = None, acceleration: Any = None, jerk: Any = None, travel: Any = None,
                period: Optional[float] = None, tolerance: Optional[float] = None,
                chord_error: Optional[float] = None, smoothing: Optional[str] = None,
                dialect: Optional[str] = None, name: Optional[str] = None) -> "Machine":
        """Another machine, with these values in place of its own.

        velocity, acceleration, jerk: > 0, mm/s or degrees/s and so on: one number for all axes, one for each, or a
        mapping {"X": 100}. travel: k × 2. period: s, 10e-6 … 20e-3. tolerance: mm, 0 or more. chord_error: mm, above 0.
        smoothing: "splines" or "least-time". dialect: of programs. ProblemError names the value that is not sound.
        """
        values: dict[str, Any] = {}
        units = {"velocity": "per s", "acceleration": "per s²", "jerk": "per s³"}
        for key, given in (("velocity", velocity), ("acceleration", acceleration), ("jerk", jerk)):
            if given is not None:
                values[key] = checks.per_axis(given, key, "mm or degrees " + units[key], self.axes)
        if travel is not None:
            both = checks.array(travel, "travel", f"{len(self.axes)} × 2")
            if both.shape != (len(self.axes), 2):
                raise ValueError(f"travel: expected {len(self.axes)} × 2, least and greatest of {' '.join(self.axes)}, "
                                 f"found {checks.shape_of(both)}")
            values["travel_min"] = checks.per_axis(both[:, 0], "travel", "mm or degrees", self.axes)
            values["travel_max"] = checks.per_axis(both[:, 1], "travel", "mm or degrees", self.axes)
        if period is not None:
            values["period_ns"] = round(checks.number(period, "period", "s", least=10e-6, greatest=20e-3) * 1e9)
        if tolerance is not None:
            values["tolerance"] = checks.number(tolerance, "tolerance", "mm", least=0)
        if chord_error is not None:
            values["chord_error"] = checks.number(chord_error, "chord_error", "mm", above=0)
        if smoothing is not None:
            values["smoothing"] = checks.choice(smoothing, "smoothing", ("splines", "least-time"))
        if dialect is not None:
            values["dialect"] = checks.choice(dialect, "dialect", _DIALECTS)
        if name is not None:
            values["name"] = checks.text(name, "name")
        return Machine(self._core.changed(values))

    def with_loops(self, *, controller: Optional[str] = None, **gains: float) -> "Machine":
        """Another machine, the drives of all axes tuned so, for simulate().

        controller: "cascade" or "pid". Of a cascade: position_gain Kv (1/s), velocity_gain (1/s), velocity_integral
        (1/s²). Of a PID: proportional (units/mm), integral (units/(mm s)), derivative (units/mm), gain (mm/s a unit),
        time_constant (ms). Of both: velocity_forward and acceleration_forward, shares 0 … 1.
        """
        loops: dict[str, Any] = {}
        if controller is not None:
            loops["controller"] = checks.choice(controller, "controller", ("cascade", "pid"))
        for key, value in gains.items():
            if key not in _LOOPS:
                raise TypeError(f"with_loops: expected {', '.join(_LOOPS)}, found {key!r}")
            loops[key] = checks.number(value, key, _LOOPS[key])
        return Machine(self._core.changed({"loops": loops}))

    def forward(self, axes: Any, tool: Any = (0, 0, 0)) -> tuple[np.ndarray, np.ndarray]:
        """Where the tool is, seen from the workpiece as it lies with all rotary axes at 0.

        axes: n × k, one column for each axis of the machine, mm and degrees; or words. tool: its offset in X, Y and Z,
        mm. Returns tips, n × 3, mm, and directions from the tip to the spindle, n × 3, unit vectors. ValueError of a
        machine without a chain of rotary axes.
        """
        return self._core.forward(checks.rows(axes, "axes", self.axes), checks.vectors(tool, "tool", 1))

    def inverse(self, tips: Any, directions: Any, tool: Any = (0, 0, 0)) -> np.ndarray:
        """Where axes are that hold the tool so: n × 2 × k, both pairs of angles, each from -180 to 180 degrees; NaN where
        there is none. At a pole there is one, with the free angle 0. tips, directions: n × 3; directions of any length."""
        at = checks.vectors(tips, "tips")
        along = checks.vectors(directions, "directions", at.shape[0])
        lengths = np.linalg.norm(along, axis=1)
        if np.any(lengths == 0):
            raise ValueError(f"directions: expected vectors of some length, found 0 0 0 in row {int(np.argmin(lengths))}")
        found = self._core.inverse(at, along / lengths[:, np.newaxis], checks.vectors(tool, "tool", 1))
        return found[:, :, self.columns]

    def __repr__(self) -> str:
        return f"<leadscrew.Machine {self.name}: {' '.join(self.axes)}, {self.period * 1e3:g} ms>"


def machine_of(machine: Any) -> Machine:
    """A machine that is given as such, by "mill3", or by the path of its file."""
    if isinstance(machine, Machine):
        return machine
    if machine is None or machine == "mill3":
        return Machine.mill3()
    if isinstance(machine, (str, os.PathLike)):
        return Machine.load(machine)
    raise TypeError(f"machine: expected a Machine, the path of a machine file, or \"mill3\", "
                    f"found {type(machine).__name__} {machine!r}")
