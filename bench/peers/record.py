#!/usr/bin/python3
"""Stands in for LinuxCNC's screen: runs the programs of its folder and records each one's words.

NAME.ngc is run from where NAME.start says ("X10 Y0"). NAME.record gets a line for each servo period: number, then the
joints in nanometres and millionths of a degree. NAME.said gets what LinuxCNC has to say against the program: nothing, if it ran.
"""
import pathlib
import subprocess
import time

import linuxcnc

command, status, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()


def complaints():
    """What LinuxCNC reported since the last call."""
    said = []
    while message := errors.poll():
        said.append(str(message[1]).strip())
    return said


def wait_until(holds, what, seconds=600):
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise TimeoutError(what)
        time.sleep(0.02)


def homed():
    status.poll()
    return all(status.homed[: status.joints])


def at_rest():
    status.poll()
    return status.interp_state == linuxcnc.INTERP_IDLE and status.queue == 0 and status.inpos


def switch_on():
    for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
        command.state(state)
        command.wait_complete()
    command.home(-1)
    wait_until(homed, "homing")


def go_to(place):
    command.mode(linuxcnc.MODE_MDI)
    command.wait_complete()
    command.mdi(f"G21 G90 G53 G0 {place}")
    command.wait_complete(60)
    wait_until(at_rest, f"the move to {place}")


def enable_sampler(on):
    subprocess.run(["halcmd", "setp", "sampler.0.enable", str(int(on))], check=True)


def sampler_is_empty():
    depth = subprocess.run(["halcmd", "getp", "sampler.0.curr-depth"], check=True, capture_output=True, text=True)
    return int(depth.stdout) == 0


def record(program, file):
    """Runs the program, with some rest before and after it; returns what LinuxCNC said against it."""
    complaints()
    command.mode(linuxcnc.MODE_AUTO)
    command.wait_complete()
    command.program_open(str(program.resolve()))
    command.wait_complete()
    sampler = subprocess.Popen(["halsampler", "-t", file])
    enable_sampler(True)
    time.sleep(0.1)
    command.auto(linuxcnc.AUTO_RUN, 0)
    command.wait_complete(60)
    wait_until(at_rest, f"the end of {program}")
    time.sleep(0.1)
    enable_sampler(False)
    wait_until(sampler_is_empty, "emptying the sampler")
    sampler.terminate()
    sampler.wait()
    return complaints()


switch_on()
for program in sorted(pathlib.Path(".").glob("*.ngc")):
    go_to("Z0")
    go_to(program.with_suffix(".start").read_text())
    said = record(program, program.with_suffix(".record"))
    program.with_suffix(".said").write_text("\n".join(said))
