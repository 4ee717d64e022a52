"""What runs, checks, plans, judgements and simulations tell."""

from __future__ import annotations

import json
import os
from typing import Any, Mapping, Union

import numpy as np

from . import _core, checks
from .machines import Machine
from .problems import Diagnostic

REST, CHANGING, CONSTANT = 0, 1, 2
"""What `state` of a word says of the speed along the path."""


class _Found:
    """Figures, by the names of the command's JSON, and what was worth a warning or a note."""

    def __init__(self, machine: Machine, found: Mapping[str, Any]) -> None:
        self.machine = machine
        self.figures: dict[str, Any] = json.loads(found["figures"])
        self.diagnostics: tuple[Diagnostic, ...] = tuple(found["diagnostics"])

    def __getitem__(self, name: str) -> Any:
        return self.figures[name]

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("_") and "figures" in self.__dict__ and name in self.figures:
            return self.figures[name]
        raise AttributeError(f"{type(self).__name__} has no {name!r}; its figures are "
                             f"{', '.join(self.__dict__.get('figures', {}))}")

    def __repr__(self) -> str:
        return f"<leadscrew.{type(self).__name__} {self.figures.get('program', '')}>"


class Result(_Found):
    """A run. Figures have the names of `leadscrew run --json` (docs/formats.md), as attributes and by [name]: time_s, bound_s,
    deviation_mm, violation_count, losses, …

    words: a structured array, one row a servo period from t = 0, that shares the memory of the library: tick, position
    (9 columns X Y Z A B C U V W, mm and degrees), path_length (mm), speed and feed (mm/s), line, block (line with its
    text and visit), state. blocks: what each move took: line, begin, seconds, least_seconds (s), length, feed_asked,
    feed_reached (mm/s), from, to, middle (n × 9), cause. events: spindle, tool, coolant, outputs, each a dict. kept: did
    plan and words keep every limit and the tolerance?
    """

    def __init__(self, machine: Machine, found: Mapping[str, Any]) -> None:
        super().__init__(machine, found)
        self.words: np.ndarray = found["words"]
        self.events: list[dict[str, Any]] = found["events"]
        self.kept: bool = found["kept"]
        self._blocks: np.ndarray = found["blocks"]

    @property
    def blocks(self) -> np.ndarray:
        """What each move took: a structured array, a row a move."""
        text = [(name, "U24") if name == "cause" else (name, *self._blocks.dtype[name].subdtype)
                if self._blocks.dtype[name].subdtype else (name, self._blocks.dtype[name])
                for name in self._blocks.dtype.names]
        return self._blocks.astype(text)

    @property
    def time(self) -> np.ndarray:
        """Of each word, s."""
        return (self.words["tick"] * round(self.machine.period * 1e9)).astype(np.float64) / 1e9

    @property
    def positions(self) -> np.ndarray:
        """Of the machine's axes, n × k, mm or degrees."""
        return self.words["position"][:, self.machine.columns]

    def axis(self, letter: str) -> np.ndarray:
        """Position of one axis at each word, mm or degrees: a view of words."""
        return self.words["position"][:, checks.AXES.index(checks.choice(letter, "axis", self.machine.axes))]

    def derivative(self, order: int) -> np.ndarray:
        """Differences of the words over the period^order: velocity, acceleration, jerk (1, 2, 3) of the machine's axes,
        n × k, as if they stood still before the first word."""
        order = checks.whole(order, "order", 1, 3)
        still = np.repeat(self.positions[:1], order, axis=0)
        return np.diff(np.concatenate([still, self.positions]), order, axis=0) / self.machine.period**order

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes words as `leadscrew run --trace FILE.npy` does, columns t line s feed and the axes."""
        words = self.words
        np.save(path, np.column_stack([self.time, words["line"], words["path_length"], words["feed"], self.positions]))


class Check(_Found):
    """What reading alone has told. Figures have the names of `leadscrew check --json`: blocks, moves, bound_s, extents."""


class Verdict(_Found):
    """What the referee says. Figures have the names of `leadscrew verify --json`: deviation_mm, tolerance_mm, axes, violations.
    kept: does it object to nothing?"""

    def __init__(self, machine: Machine, found: Mapping[str, Any]) -> None:
        super().__init__(machine, found)
        self.kept: bool = found["kept"]


class Simulation(_Found):
    """Where slides went under their loops. Figures have the names of `leadscrew simulate --json`: contour, axes, settling_s.

    rows: a structured array without a copy, one row a period: the word's tick, position, …, and beside them of each axis
    actual (of the slide, mm), velocity (mm/s), control (of the controller) and current (mm/s²), 9 columns each.
    """

    def __init__(self, machine: Machine, found: Mapping[str, Any]) -> None:
        super().__init__(machine, found)
        self.rows: np.ndarray = found["rows"]
        self.kept: bool = found["kept"]

    @property
    def time(self) -> np.ndarray:
        """Of each row, s."""
        return self.rows["tick"] * self.machine.period


class Trajectory:
    """A motion planned to its end, as polynomials of time."""

    def __init__(self, machine: Machine, core: _core.Trajectory) -> None:
        self.machine = machine
        self._core = core

    @property
    def duration(self) -> float:
        """From its first instant to rest at its end, s."""
        return self._core.duration

    @property
    def length(self) -> float:
        """Travelled, mm; degrees where only rotary axes move."""
        return self._core.length

    def at(self, times: Any) -> np.ndarray:
        """At these times, s, n of them: a structured array of position, velocity, acceleration and jerk (9 columns each, mm
        or degrees, per s, s², s³), path_length, speed, feed, line, block, state. Before 0 as at 0, behind the end at rest."""
        return self._core.at(np.atleast_1d(checks.array(times, "times", "n times (s)")).ravel())

    @property
    def words(self) -> np.ndarray:
        """Words as run() gives them, bit for bit; a new array with each call."""
        return self._core.words()
