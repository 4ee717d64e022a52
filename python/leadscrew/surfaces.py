"""Surfaces from arrays."""

from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np

from . import _core, checks

_PATTERNS = ("zig", "zigzag", "spiral", "iso-scallop", "planar")


class Surface:
    """A rational B-spline surface.

    points: nu × nv × 3, control points, mm. weights: nu × nv, above 0; all 1 by default. degree: in u and v, 1 … 5.
    knots: of u and of v, points + degree + 1 each, clamped; uniform from 0 to 1 by default.
    """

    def __init__(self, points: Any, *, weights: Any = None, degree: Union[int, tuple[int, int]] = 3,
                 knots: Optional[tuple[Any, Any]] = None) -> None:
        net = checks.array(points, "points", "nu × nv × 3")
        if net.ndim != 3 or net.shape[2] != 3:
            raise ValueError(f"points: expected shape nu × nv × 3, found {checks.shape_of(net)}")
        weighted = np.ones(net.shape[:2]) if weights is None else checks.array(weights, "weights", "nu × nv")
        if weighted.shape != net.shape[:2]:
            raise ValueError(f"weights: expected {checks.shape_of(net[:, :, 0])}, one a point, "
                             f"found {checks.shape_of(weighted)}")
        pair = (degree, degree) if isinstance(degree, (int, np.integer)) else tuple(degree)
        if len(pair) != 2:
            raise ValueError(f"degree: expected one, or two for u and v, found {len(pair)}")
        spaced: list[list[float]] = [[], []]
        if knots is not None:
            if len(knots) != 2:
                raise ValueError(f"knots: expected two lists, of u and of v, found {len(knots)}")
            spaced = [list(checks.array(each, "knots", "numbers").ravel()) for each in knots]
        both = tuple(checks.whole(each, "degree", 1, 5) for each in pair)
        self._core = _core.Surface(np.concatenate([net, weighted[:, :, np.newaxis]], axis=2), both, spaced)

    @property
    def range(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Least and greatest parameter in u, and in v."""
        return self._core.range()

    def evaluate(self, u: Any, v: Any) -> dict[str, np.ndarray]:
        """At n pairs of parameters, which are broadcast against each other; beyond a range they count as its end.

        position, by_u and by_v (derivatives), mm, and normal, unit vectors on the side of Su × Sv: shape of u and v, × 3.
        curvature: both principal ones, the greater first, 1/mm, × 2. NaN where the normal vanishes.
        """
        us, vs = np.broadcast_arrays(checks.array(u, "u", "parameters"), checks.array(v, "v", "parameters"))
        found = self._core.evaluate(np.ascontiguousarray(us).ravel(), np.ascontiguousarray(vs).ravel())
        return {name: values.reshape(us.shape + values.shape[1:]) for name, values in found.items()}

    def blocks(self, number: int = 1) -> str:
        """The blocks that define it in a program as surface D `number` (G6.4), read back to the last bit."""
        return self._core.blocks(checks.whole(number, "number", 0, 32767))

    def passes(self, *, radius: float, corner_radius: Optional[float] = None, scallop: Optional[float] = None,
               step: Optional[float] = None, pattern: str = "zigzag", along: str = "u", orientation: str = "fixed",
               lead: float = 0, tilt: float = 0, side: int = 1, start_corner: int = 1, allow_gouge: bool = False,
               progress: Any = None) -> list[dict[str, Any]]:
        """Passes of a tool over all of it, and the links between them, in order.

        radius and corner_radius of the tool, mm: a ball by default. Either scallop, the height of ridges, or step, both mm.
        pattern: "zig", "zigzag", "spiral", "iso-scallop" or "planar"; along "u" or "v". orientation: "fixed" along Z,
        "normal", or "leaned" by lead along the pass and tilt across it, degrees. side: 1 where the tool is on that of
        Su × Sv, -1 on the other. Each is a dict: tip, axis and contact, n × 3, mm; uv, n × 2; is_link; number.
        ValueError says why there are none: where the tool gouges, or an axis points into the surface.
        """
        round_edge = checks.number(radius, "radius", "mm", above=0)
        if (scallop is None) == (step is None):
            raise TypeError("passes: expected either scallop or step")
        options = {
            "radius": round_edge,
            "corner_radius": round_edge if corner_radius is None else
            checks.number(corner_radius, "corner_radius", "mm", least=0, greatest=round_edge),
            "scallop": 0.0 if scallop is None else checks.number(scallop, "scallop", "mm", above=0),
            "step": 0.0 if step is None else checks.number(step, "step", "mm", above=0),
            "pattern": _PATTERNS.index(checks.choice(pattern, "pattern", _PATTERNS)),
            "along": checks.choice(along, "along", ("u", "v")),
            "orientation": checks.choice(orientation, "orientation", ("fixed", "normal", "leaned")),
            "lead": checks.number(lead, "lead", "degrees", least=-89, greatest=89),
            "tilt": checks.number(tilt, "tilt", "degrees", least=-89, greatest=89),
            "side": int(checks.choice(str(side), "side", ("1", "-1"))),
            "start_corner": checks.whole(start_corner, "start_corner", 1, 4),
            "allow_gouge": bool(allow_gouge),
        }
        return self._core.passes(options, checks.progress(progress))
