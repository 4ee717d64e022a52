"""What is given, as numbers that the library takes; or TypeError and ValueError that say what was expected and what was
found."""

from __future__ import annotations

import numbers
import os
from typing import Any, Iterable, Mapping, Optional, Sequence

import numpy as np

AXES = "XYZABCUVW"


def number(value: Any, name: str, unit: str, least: Optional[float] = None, greatest: Optional[float] = None,
           above: Optional[float] = None, rapid: bool = False) -> float:
    """A finite number of a unit, within a range; infinite too where `rapid`."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (numbers.Real, np.integer, np.floating)):
        raise TypeError(f"{name}: expected a number ({unit}), found {type(value).__name__} {value!r}")
    found = float(value)
    wanted = []
    if least is not None:
        wanted.append(f"{least:g} or more")
    if above is not None:
        wanted.append(f"more than {above:g}")
    if greatest is not None:
        wanted.append(f"at most {greatest:g}")
    text = " and ".join(wanted) or "finite"
    infinite = rapid and found == np.inf
    wrong = (not np.isfinite(found) and not infinite) or (least is not None and found < least)
    wrong = wrong or (above is not None and found <= above) or (greatest is not None and found > greatest)
    if wrong:
        raise ValueError(f"{name}: expected {text} ({unit}), found {found:g}")
    return found


def whole(value: Any, name: str, least: int, greatest: int) -> int:
    """A whole number within a range."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"{name}: expected a whole number, found {type(value).__name__} {value!r}")
    if not least <= value <= greatest:
        raise ValueError(f"{name}: expected {least} to {greatest}, found {value}")
    return int(value)


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected text, found {type(value).__name__} {value!r}")
    return value


def choice(value: Any, name: str, choices: Iterable[str]) -> str:
    """One of these names."""
    known = list(choices)
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected one of {', '.join(known)}, found {type(value).__name__} {value!r}")
    if value not in known:
        raise ValueError(f"{name}: expected one of {', '.join(known)}, found {value!r}")
    return value


def array(value: Any, name: str, shape: str) -> np.ndarray:
    """An array of finite floats. `shape` is for the message."""
    try:
        found = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name}: expected {shape}, found rows of different lengths") from error
    if found.dtype == object and found.size > 0 and isinstance(found.flat[0], (list, tuple)):
        raise ValueError(f"{name}: expected {shape}, found rows of different lengths")
    if found.dtype.kind not in "iuf":
        raise TypeError(f"{name}: expected {shape} of numbers, found {found.dtype} of shape {found.shape}")
    found = np.asarray(found, dtype=np.float64, order="C")
    if not np.all(np.isfinite(found)):
        place = tuple(int(i) for i in np.argwhere(~np.isfinite(found))[0])
        raise ValueError(f"{name}: expected finite numbers, found {found[place]} at {list(place)}")
    return found


def vectors(value: Any, name: str, count: Optional[int] = None) -> np.ndarray:
    """n × 3; one vector counts as 1 × 3."""
    found = np.atleast_2d(array(value, name, "n × 3"))
    if found.ndim != 2 or found.shape[1] != 3:
        raise ValueError(f"{name}: expected shape n × 3, found {shape_of(found)}")
    if count is not None and found.shape[0] != count:
        raise ValueError(f"{name}: expected {count} rows, as many as the other array has, found {found.shape[0]}")
    return found


def shape_of(found: np.ndarray) -> str:
    return " × ".join(str(n) for n in found.shape) or "a single number"


def rows(value: Any, name: str, axes: str, base: Optional[np.ndarray] = None) -> np.ndarray:
    """Positions n × k as n × 9: columns are the machine's axes, the first k of them, or X Y Z A B C U V W where there
    are nine; structured words as they come. Axes without a column are as in `base`, else 0."""
    given = value
    if isinstance(value, np.ndarray) and value.dtype.names:
        if "position" not in value.dtype.names:
            raise ValueError(f"{name}: expected words, with a field position, found fields {', '.join(value.dtype.names)}")
        given = value["position"]
    found = array(given, name, f"n × {len(axes)}, columns {' '.join(axes)}")
    if found.ndim != 2:
        raise ValueError(f"{name}: expected shape n × {len(axes)}, columns {' '.join(axes)}, found {shape_of(found)}")
    if found.shape[1] == len(AXES):
        return found
    if not 1 <= found.shape[1] <= len(axes):
        raise ValueError(f"{name}: expected 1 to {len(axes)} columns, {' '.join(axes)}, found {found.shape[1]}")
    nine = np.zeros((found.shape[0], len(AXES)))
    if base is not None:
        nine[:] = base
    for column, axis in enumerate(axes[: found.shape[1]]):
        nine[:, AXES.index(axis)] = found[:, column]
    return nine


def position(value: Any, name: str, axes: str) -> np.ndarray:
    """Nine coordinates: of a sequence in the order of the machine's axes, or of a mapping such as {"X": 10}."""
    nine = np.zeros(len(AXES))
    if value is None:
        return nine
    if isinstance(value, Mapping):
        for axis, coordinate in value.items():
            if axis not in axes:
                raise ValueError(f"{name}: expected axes {' '.join(axes)}, found {axis!r}")
            nine[AXES.index(axis)] = number(coordinate, f"{name}[{axis!r}]", "mm or degrees")
        return nine
    found = array(value, name, f"up to {len(axes)} coordinates {' '.join(axes)}")
    if found.ndim != 1 or found.size > len(AXES) or found.size < 1:
        raise ValueError(f"{name}: expected up to {len(axes)} coordinates {' '.join(axes)}, found {shape_of(found)}")
    return rows(found[np.newaxis], name, axes)[0]


def per_axis(value: Any, name: str, unit: str, axes: str) -> np.ndarray:
    """Of all nine axes: one number for each that the machine has, a sequence, or a mapping by letters; NaN where it is to
    stay as it is."""
    nine = np.full(len(AXES), np.nan)
    if isinstance(value, Mapping):
        for axis, each in value.items():
            if axis not in axes:
                raise ValueError(f"{name}: expected axes {' '.join(axes)}, found {axis!r}")
            nine[AXES.index(axis)] = number(each, f"{name}[{axis!r}]", unit)
        return nine
    found = array(value, name, f"a number, or {len(axes)} numbers ({unit})")
    if found.ndim == 0:
        found = np.full(len(axes), float(found))
    if found.shape != (len(axes),):
        raise ValueError(f"{name}: expected a number, or {len(axes)} of them, {' '.join(axes)}, found {shape_of(found)}")
    for column, axis in enumerate(axes):
        nine[AXES.index(axis)] = found[column]
    return nine


def progress(function: Any) -> Any:
    if function is not None and not callable(function):
        raise TypeError(f"progress: expected a function of the share that is done, found {type(function).__name__}")
    return function


def paths(value: Any, name: str) -> Sequence[str]:
    given = [value] if isinstance(value, (str, os.PathLike)) else value
    try:
        return [os.fspath(each) for each in given]
    except TypeError as error:
        raise TypeError(f"{name}: expected paths of folders, found {value!r}") from error
