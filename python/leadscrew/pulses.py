"""Interpolators of reference pulses: a line or an arc, every register at every clock."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from . import _core, checks

_GREATEST = 1 << 30


def pulse_methods() -> list[str]:
    """Names of the interpolators."""
    return _core.pulse_names()["method"]


class Pulses:
    """What an interpolator made of a curve.

    table: clocks × columns, whole numbers. columns: their names: "clock", the pulse "dx" and "dy", the place "X" and "Y" (BLU),
    and the method's registers. figures: clocks, pulses, position, max_error and rms_error (BLU), worst, worst_clock, done.
    conventions: what was in force: bits, capacity, preload, order, tie, end.
    """

    def __init__(self, core: _core.Pulses, most: int, progress: Any) -> None:
        self.columns: list[str] = core.columns()
        self.table: np.ndarray = core.table(most, progress)
        self.figures: dict[str, Any] = core.figures()
        self.conventions: dict[str, Any] = core.conventions()

    def column(self, name: str) -> np.ndarray:
        """One column of the table: a view."""
        return self.table[:, self.columns.index(checks.choice(name, "column", self.columns))]

    @property
    def places(self) -> np.ndarray:
        """Where each clock has led, n × 2, BLU."""
        first = self.columns.index("X")
        return self.table[:, first:first + 2]


def _point(value: Any, name: str) -> tuple[int, int]:
    try:
        given = list(value)
    except TypeError as error:
        raise TypeError(f"{name}: expected two whole numbers (BLU), found {value!r}") from error
    if len(given) != 2:
        raise ValueError(f"{name}: expected two whole numbers (BLU), found {len(given)}")
    return (checks.whole(given[0], name, -_GREATEST, _GREATEST), checks.whole(given[1], name, -_GREATEST, _GREATEST))


def _options(given: dict[str, Any]) -> dict[str, Any]:
    names = _core.pulse_names()
    options: dict[str, Any] = {}
    for key, value in given.items():
        if value is None or value is False:
            continue
        if key in ("preload", "order", "tie", "accumulation"):
            options[key] = checks.choice(value, key, names[key])
        elif key == "bits":
            options[key] = checks.whole(value, key, 1, 30)
        elif key == "capacity":
            options[key] = checks.whole(value, key, 1, _GREATEST)
        elif key == "places":
            options[key] = checks.whole(value, key, 1, 16)
        elif key == "free":
            options[key] = 1
        elif key == "semi_axes":
            options[key] = list(_point(value, key))
        else:
            raise TypeError(f"pulses: expected preload, order, tie, accumulation, bits, capacity, places, free or semi_axes, "
                            f"found {key!r}")
    return options


def pulse_line(start: Any, end: Any, *, method: str = "koren", most: int = 10_000_000, progress: Any = None,
               **options: Any) -> Pulses:
    """A line between two places, BLU (basic length units), |coordinate| up to 2^30. method: one of pulse_methods(). most:
    clocks that are made at most. Options: preload, bits, capacity, as `leadscrew pulse` has them."""
    core = _core.Pulses(checks.choice(method, "method", pulse_methods()), False, _point(start, "start"),
                        _point(end, "end"), (0, 0), 1, _options(options))
    return Pulses(core, checks.whole(most, "most", 1, 100_000_000), checks.progress(progress))


def pulse_arc(start: Any, end: Any, *, center: Any = (0, 0), clockwise: bool = False, method: str = "koren",
              most: int = 10_000_000, progress: Any = None, **options: Any) -> Pulses:
    """An arc about a centre, a full circle where start and end are one place; BLU. Options: preload, order, tie,
    accumulation, bits, capacity, places, free, semi_axes, as `leadscrew pulse` has them. ProblemError: "end-off-circle"."""
    core = _core.Pulses(checks.choice(method, "method", pulse_methods()), True, _point(start, "start"),
                        _point(end, "end"), _point(center, "center"), -1 if clockwise else 1, _options(options))
    return Pulses(core, checks.whole(most, "most", 1, 100_000_000), checks.progress(progress))
