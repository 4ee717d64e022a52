"""What is wrong with a program, a machine file or a path, and where: as exceptions."""

from __future__ import annotations

import dataclasses
from typing import Sequence


@dataclasses.dataclass(frozen=True)
class Diagnostic:
    """One thing that was found, as the command has it.

    severity is "note", "warning" or "error"; code is stable, such as "arc-radius" (docs/diagnostics.md lists all);
    message says what was found and hint what would be right. line counts from 1 and column in bytes from 1; 0: not
    known. source is the line of text; field says which value it is about, such as "jerk.X".
    """

    severity: str
    code: str
    message: str
    hint: str = ""
    file: str = ""
    line: int = 0
    column: int = 0
    source: str = ""
    field: str = ""

    def __str__(self) -> str:
        place = self.file
        if self.line > 0:
            place += f":{self.line}" + (f":{self.column}" if self.column > 0 else "")
        text = f"{place}: " if place else ""
        text += f"{self.severity}: {self.message} [{self.code}]"
        if self.source and self.column > 0:
            text += f"\n    {self.source}\n    {' ' * (self.column - 1)}^"
        return text + (f"\n    hint: {self.hint}" if self.hint else "")


class ProblemError(ValueError):
    """A program, machine file, tool table or path that is not sound, or motion that failed.

    diagnostics has all that was found, warnings too, in the order of the text. code, message, hint, file, line,
    column and field are those of the first error.
    """

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        self.diagnostics: tuple[Diagnostic, ...] = tuple(diagnostics)
        errors = [each for each in self.diagnostics if each.severity == "error"] or list(self.diagnostics)
        first = errors[0]
        self.code = first.code
        self.message = first.message
        self.hint = first.hint
        self.file = first.file
        self.line = first.line
        self.column = first.column
        self.field = first.field
        super().__init__("\n".join(str(each) for each in errors))

    def __reduce__(self) -> tuple[type[ProblemError], tuple[tuple[Diagnostic, ...]]]:
        """By its diagnostics, so that copies and other processes have all of it."""
        return type(self), (self.diagnostics,)
