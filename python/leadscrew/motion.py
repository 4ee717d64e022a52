"""Programs and paths, and what is done with them: run, checked, planned, judged, simulated."""

from __future__ import annotations

import os
from typing import Any, Callable, Mapping, Optional, Union

import numpy as np

from . import _core, checks
from .machines import Machine, machine_of
from .results import Check, Result, Simulation, Trajectory, Verdict

Progress = Optional[Callable[[float], Any]]

RAPID = float("inf")
"""The feed of a move that is as fast as the axes allow."""


class _Work:
    """What programs and paths have alike."""

    def __init__(self, machine: Machine, core: _core.Work) -> None:
        self.machine = machine
        self._work = core

    def run(self, progress: Progress = None) -> Result:
        """Makes its words and has the referee judge them, without the interpreter's lock.

        progress: called some twenty times a second with the share of it that has been read; returns False to end.
        ProblemError has everything that is wrong, with places; KeyboardInterrupt ends the run within a tenth of a second.
        """
        return Result(self.machine, self._work.run(checks.progress(progress)))

    def check(self, progress: Progress = None) -> Check:
        """Reads it and moves nothing. What is wrong with it stands in diagnostics, and is not raised."""
        return Check(self.machine, self._work.check(checks.progress(progress)))

    def plan(self, progress: Progress = None) -> Trajectory:
        """The motion at any time, velocity, acceleration and jerk too; it is not judged. ProblemError as of run()."""
        return Trajectory(self.machine, self._work.plan(checks.progress(progress)))

    def verify(self, positions: Any, progress: Progress = None) -> Verdict:
        """The referee's word on positions, one a period of the machine: n × k, columns the machine's axes, mm or degrees; or
        words. Nothing of what makes motion has a part in it."""
        rows = checks.rows(positions, "positions", self.machine.axes)
        if rows.shape[0] == 0:
            raise ValueError("positions: expected one row or more, found none")
        return Verdict(self.machine, self._work.judge(rows, checks.progress(progress)))

    def simulate(self, *, pulses: bool = False, progress: Progress = None) -> Simulation:
        """Its words through the simulated loops of the machine's drives (Machine.with_loops), until the slides stand.
        pulses: through pulse-driven loops. ProblemError "servo-unstable" of a loop that is not stable."""
        return Simulation(self.machine, self._work.simulate(bool(pulses), checks.progress(progress)))


class Program(_Work):
    """A part program: of a file, or of a text that has more than one line or is given as `text`.

    machine: a Machine, a machine file's path, or "mill3". tools: path of a tool table. start: where motion begins, mm or
    degrees. mode: "blend" or "exact-stop", and tolerance, mm, in place of what the program says. subprograms: folders.
    fuel: lines that may be read in loops and subprograms. allow_gouge: surfaces are machined though the tool gouges.
    interpolator: how words step along curves: "arc-length", "taylor1", "taylor2", "newton" or "uniform". period: of the
    servo, s, in place of the machine's.
    """

    def __init__(self, program: Union[str, "os.PathLike[str]", None] = None, *, text: Optional[str] = None,
                 machine: Any = None, tools: Union[str, "os.PathLike[str]", None] = None, start: Any = None,
                 period: Optional[float] = None, mode: Optional[str] = None, tolerance: Optional[float] = None,
                 subprograms: Any = (), fuel: Optional[int] = None, allow_gouge: bool = False,
                 interpolator: Optional[str] = None, name: str = "<text>") -> None:
        of = machine_of(machine)
        if period is not None:
            of = of.changed(period=period)
        options: dict[str, Any] = {"subprograms": checks.paths(subprograms, "subprograms"), "allow_gouge": bool(allow_gouge)}
        if tools is not None:
            options["tools_name"] = os.fspath(tools)
            with open(tools, encoding="utf-8", errors="replace") as file:
                options["tools"] = file.read()
        if mode is not None:
            options["mode"] = checks.choice(mode, "mode", ("blend", "exact-stop"))
        if tolerance is not None:
            options["tolerance"] = checks.number(tolerance, "tolerance", "mm", least=0)
        if fuel is not None:
            options["fuel"] = checks.whole(fuel, "fuel", 1, 10**15)
        if interpolator is not None:
            options["interpolator"] = checks.choice(interpolator, "interpolator",
                                                    ("arc-length", "taylor1", "taylor2", "newton", "uniform"))
        if (program is None) == (text is None):
            raise TypeError("Program: expected either the path of a program, or text=")
        if program is not None and not isinstance(program, (str, os.PathLike)):
            raise TypeError(f"program: expected a path or a program's text, found {type(program).__name__} {program!r}")
        if text is None and isinstance(program, str) and "\n" in program:
            text = program
        if text is not None:
            given, called = checks.text(text, "text"), checks.text(name, "name") or "<text>"
        else:
            given, called = os.fspath(program), ""  # type: ignore[arg-type]
        super().__init__(of, _core.Program(of._core, given, called, checks.position(start, "start", of.axes), options))


class Path(_Work):
    """Moves that are given one by one or as arrays: lines, arcs, curves, dwells, from `start` on; smoothed within a tolerance.

    machine: as for Program. start: mm or degrees. tolerance: mm; by default the machine's; 0: moves are joined as they
    are, with a stop where there is a corner. Each method returns the path, so that calls may be strung together. The
    line of a word is the number of its move, from 1.
    """

    def __init__(self, *, machine: Any = None, start: Any = None, tolerance: Optional[float] = None,
                 period: Optional[float] = None, name: str = "<path>") -> None:
        of = machine_of(machine)
        if period is not None:
            of = of.changed(period=period)
        moves = _core.Moves(of._core, checks.text(name, "name"), checks.position(start, "start", of.axes))
        super().__init__(of, moves)
        self._moves = moves
        if tolerance is not None:
            self.smooth(tolerance)

    @property
    def end(self) -> np.ndarray:
        """Where the moves so far end: of the machine's axes, mm or degrees."""
        return self._moves.end[self.machine.columns]

    def smooth(self, tolerance: float) -> "Path":
        """How moves from now on are joined: within so many mm of them, or exactly (0)."""
        self._moves.smooth(checks.number(tolerance, "tolerance", "mm", least=0))
        return self

    def lines(self, points: Any, feed: Any = RAPID) -> "Path":
        """Straight through points, n × k, columns the machine's axes, mm or degrees; axes without a column stay. feed: mm/s
        (degrees/s where rotary axes alone move), above 0, one for all or n; RAPID: as fast as the axes allow."""
        ends = checks.rows(points, "points", self.machine.axes, self._moves.end)
        self._moves.lines(ends, _feeds(feed, ends.shape[0]))
        return self

    def line(self, point: Any, feed: float = RAPID) -> "Path":
        """Straight to one point: coordinates in the order of the machine's axes, or {"X": 10}."""
        if isinstance(point, Mapping):
            end = self._moves.end.copy()
            given = checks.position(point, "point", self.machine.axes)
            for axis in point:
                end[checks.AXES.index(axis)] = given[checks.AXES.index(axis)]
        else:
            end = checks.rows(np.atleast_2d(checks.array(point, "point", "coordinates")), "point", self.machine.axes,
                              self._moves.end)[0]
        self._moves.lines(end[np.newaxis], _feeds(feed, 1))
        return self

    def arc(self, end: Any, center: Any, *, plane: str = "XY", turns: int = 1, feed: float = RAPID) -> "Path":
        """Circular in a plane, "XY", "ZX" or "YZ", about a centre, mm, along its first and second axis. turns: 1
        counterclockwise, -1 clockwise; 2, -2, … a whole turn more. Other axes go straight."""
        to = checks.rows(np.atleast_2d(checks.array(end, "end", "coordinates")), "end", self.machine.axes, self._moves.end)
        both = checks.array(center, "center", "two coordinates")
        if both.shape != (2,):
            raise ValueError(f"center: expected two coordinates of the plane {plane}, found {checks.shape_of(both)}")
        in_plane = checks.choice(plane, "plane", ("XY", "ZX", "YZ"))
        self._moves.arc(to[0], in_plane, both[0], both[1], checks.whole(turns, "turns", -1000000, 1000000), _feed(feed))
        return self

    def curve(self, points: Any, *, degree: int = 3, weights: Any = None, knots: Any = None,
              feed: float = RAPID) -> "Path":
        """Along a NURBS curve that begins where the path ends. points: the control points behind the first, which is that
        place, n × k, mm or degrees; or, with it, n + 1, where the first one is that place. degree 1 … 5. weights: one
        a control point, 1e-9 … 1e9; all 1 by default. knots: as many as control points + degree + 1, clamped; uniform by
        default."""
        given = checks.rows(points, "points", self.machine.axes, self._moves.end)
        if given.shape[0] == 0 or not np.array_equal(given[0], self._moves.end):
            given = np.concatenate([self._moves.end[np.newaxis], given])
        count = given.shape[0]
        of = checks.whole(degree, "degree", 1, 5)
        weighted = np.ones(count) if weights is None else checks.array(weights, "weights", f"{count} numbers")
        if weighted.shape != (count,):
            raise ValueError(f"weights: expected {count}, one for each control point, the first included, "
                             f"found {checks.shape_of(weighted)}")
        spaced = [] if knots is None else list(checks.array(knots, "knots", f"{count + of + 1} numbers").ravel())
        self._moves.curve(given, weighted, spaced, of, _feed(feed))
        return self

    def dwell(self, seconds: float) -> "Path":
        """Stands still, 0 s or more."""
        self._moves.dwell(checks.number(seconds, "seconds", "s", least=0, greatest=1e6))
        return self

    def stop(self) -> "Path":
        """Motion rests here before it goes on."""
        self._moves.stop()
        return self


def _feed(feed: Any) -> float:
    return checks.number(feed, "feed", "mm/s", above=0, rapid=True)


def _feeds(feed: Any, count: int) -> np.ndarray:
    if np.ndim(feed) == 0:
        return np.full(count, _feed(feed))
    feeds = np.asarray(feed)
    if feeds.dtype.kind not in "iuf":
        raise TypeError(f"feed: expected numbers (mm/s), found {feeds.dtype}")
    if feeds.shape != (count,) or np.any(~(feeds > 0)):
        raise ValueError(f"feed: expected one above 0, or {count} of them (mm/s), found {checks.shape_of(feeds)}")
    return np.ascontiguousarray(feeds, dtype=np.float64)


def run(program: Any, *, progress: Progress = None, **options: Any) -> Result:
    """Runs a part program: a path, or a text of more than one line. Options are those of Program."""
    return Program(program, **options).run(progress)


def check(program: Any, *, progress: Progress = None, **options: Any) -> Check:
    """Reads a part program and moves nothing. Options are those of Program."""
    return Program(program, **options).check(progress)


def plan(program: Any, *, progress: Progress = None, **options: Any) -> Trajectory:
    """The motion of a part program at any time. Options are those of Program."""
    return Program(program, **options).plan(progress)


def simulate(program: Any, *, pulses: bool = False, progress: Progress = None, **options: Any) -> Simulation:
    """A part program through the simulated loops of the machine's drives. Options are those of Program."""
    return Program(program, **options).simulate(pulses=pulses, progress=progress)


def verify(positions: Any, program: Any, *, progress: Progress = None, **options: Any) -> Verdict:
    """The referee's word on positions, n × k, or words, one a period, along a part program. Options are those of Program."""
    return Program(program, **options).verify(positions, progress)


def waypoints(points: Any, *, feed: Any = RAPID, tolerance: Optional[float] = None, stops: bool = False,
              start: Any = None, machine: Any = None, period: Optional[float] = None) -> Path:
    """A path through points, n × k, columns the machine's axes, mm or degrees, from the first one on, or from `start`.

    feed: mm/s, one for all or one a move. tolerance: mm; by default the machine's. stops: motion rests at each.
    """
    of = machine_of(machine)
    rows = checks.rows(points, "points", of.axes)
    if rows.shape[0] < (2 if start is None else 1):
        raise ValueError(f"points: expected 2 or more, found {rows.shape[0]}")
    begin = rows[0] if start is None else checks.position(start, "start", of.axes)
    moves = rows[1:] if start is None else rows
    path = Path(machine=of, start=begin, tolerance=tolerance, period=period)
    feeds = _feeds(feed, moves.shape[0])
    if not stops:
        return path.lines(moves, feeds)
    for end, each in zip(moves, feeds):
        path.lines(end[np.newaxis], each).stop()
    return path


def curve(points: Any, *, degree: int = 3, weights: Any = None, knots: Any = None, feed: float = RAPID,
          machine: Any = None, period: Optional[float] = None) -> Path:
    """A path along one NURBS curve: control points n × k, columns the machine's axes, mm or degrees. As Path.curve()."""
    of = machine_of(machine)
    rows = checks.rows(points, "points", of.axes)
    if rows.shape[0] < 2:
        raise ValueError(f"points: expected 2 or more, found {rows.shape[0]}")
    return Path(machine=of, start=rows[0], period=period).curve(rows, degree=degree, weights=weights, knots=knots, feed=feed)


def tool_path(tips: Any, directions: Any, *, feed: float, tolerance: float = 0.01, orientation_tolerance: float = 0.05,
              machine: Any, period: Optional[float] = None) -> Program:
    """A path of the tool's tip in five axes: a program with G43.5, which has its text in `text`.

    tips: n × 3, mm, in the workpiece as it lies with all rotary axes at 0. directions: n × 3, from the tip to the
    spindle, of any length. feed: of the tip, mm/s, above 0. tolerance: of the tip, mm; orientation_tolerance: degrees.
    The tool has no length: tips are where the machine's gauge point is. Motion begins at rest over the first tip.
    """
    of = machine_of(machine)
    if not of.has_kinematics:
        raise ValueError(f"machine: expected one with a chain of rotary axes, found {of.name}, which is cartesian")
    at = checks.vectors(tips, "tips")
    along = checks.vectors(directions, "directions", at.shape[0])
    if at.shape[0] < 2:
        raise ValueError(f"tips: expected 2 or more, found {at.shape[0]}")
    both = of.inverse(at[:1], along[:1])[0, 0]
    if np.any(np.isnan(both)):
        raise ValueError(f"directions: expected some that {of.name} can hold, found {along[0].tolist()} in row 0")
    angles = " ".join(f"{axis}{value:.6f}" for axis, value in zip(of.axes, both) if axis in "ABC")
    fed = checks.number(feed, "feed", "mm/s", above=0) * 60
    lines = ["G21 G90 G94", f"G64 P{checks.number(tolerance, 'tolerance', 'mm', least=0):g} "
             f"E{checks.number(orientation_tolerance, 'orientation_tolerance', 'degrees', above=0):g}",
             f"G0 {angles}", "G43.5 H0"]
    for i, (tip, direction) in enumerate(zip(at, along / np.linalg.norm(along, axis=1)[:, np.newaxis])):
        place = " ".join(f"{letter}{value:.9f}" for letter, value in zip("XYZIJK", (*tip, *direction)))
        lines.append(("G0 " if i == 0 else f"G1 F{fed:.9g} " if i == 1 else "") + place)
    text = "\n".join([*lines, "G49", "M2", ""])
    program = Program(text=text, machine=of, period=period, name="<tool path>")
    program.text = text  # type: ignore[attr-defined]
    return program
