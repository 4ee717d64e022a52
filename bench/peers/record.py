#!/usr/bin/python3
"""Stands in for LinuxCNC's screen: runs the programs of its folder and records each one's words.

NAME.ngc is run from where NAME.start says ("X10 Y0"). NAME.record gets a line for each servo period: number, then the
joints in nanometres and millionths of a degree. NAME.said gets what LinuxCNC has to say against the program: nothing, if it ran.
"""
import pathlib

import linuxcnc
from screen import at_rest, command, complaints, mdi, open_program, recorded, switch_on, wait_until


def record(program, file):
    """Runs the program; returns what LinuxCNC said against it."""
    complaints()
    open_program(program)
    with recorded(file):
        command.auto(linuxcnc.AUTO_RUN, 0)
        command.wait_complete(60)
        wait_until(at_rest, f"the end of {program}")
    return complaints()


switch_on()
for program in sorted(pathlib.Path(".").glob("*.ngc")):
    mdi("G21 G90 G53 G0 Z0")
    mdi(f"G21 G90 G53 G0 {program.with_suffix('.start').read_text()}")
    said = record(program, program.with_suffix(".record"))
    program.with_suffix(".said").write_text("\n".join(said))
