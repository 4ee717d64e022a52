"""Published experiments made again."""

from __future__ import annotations

import json
from typing import Any

from . import _core, checks


def studies() -> dict[str, str]:
    """Names of the studies, each with its title."""
    return {each["name"]: each["title"] for each in json.loads(_core.study_list())["studies"]}


def study(name: str) -> list[dict[str, Any]]:
    """Makes one again: a row a figure, with the keys of `leadscrew study NAME --json`: group, what, published, ours, unit,
    verdict, why. Some take minutes, and are made by a process of its own; an interrupt ends it within a tenth of a second."""
    found = _core.study(checks.choice(name, "name", studies()))
    return json.loads(found)["rows"]
