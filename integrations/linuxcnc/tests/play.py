#!/usr/bin/python3
"""Stands in for LinuxCNC's screen: plays the jobs of jobs.json and records each one's words.

A job has a name, a start ("X10 Y0"), a program's text or an MDI command, and acts: [seconds after its start, what, value].
NAME.record gets a line for each servo period: number, then X, Y and Z in nanometres, and outputs. NAME.said gets what
LinuxCNC has to say against it, NAME.end where it ended and how long the servo thread took, at most.
"""
import json
import pathlib
import time

import linuxcnc
from screen import at_rest, command, complaints, hal, mdi, open_program, polled, recorded, status, switch_on, wait_until

PATIENCE = 120  # s


def jog(axis, speed, seconds):
    command.mode(linuxcnc.MODE_MANUAL)
    command.wait_complete()
    command.teleop_enable(1)
    command.wait_complete()
    command.jog(linuxcnc.JOG_CONTINUOUS, 0, axis, speed)
    time.sleep(seconds)
    command.jog(linuxcnc.JOG_STOP, 0, axis)
    time.sleep(0.5)


def act(what, value):
    if what == "feed":
        command.feedrate(value)
    elif what == "rapid":
        command.rapidrate(value)
    elif what == "maxvel":
        command.maxvel(value)
    elif what == "pause":
        command.auto(linuxcnc.AUTO_PAUSE)
    elif what == "resume":
        command.auto(linuxcnc.AUTO_RESUME)
    elif what == "step":
        command.auto(linuxcnc.AUTO_STEP)
    elif what == "abort":
        command.abort()
    elif what == "off":
        command.state(linuxcnc.STATE_OFF)
    elif what == "pin":
        hal("setp", *value)
    elif what == "mdi":
        mdi(value)
    elif what == "jog":
        jog(*value)


def play(job):
    """The job, from its start."""
    complaints()
    command.feedrate(1)
    command.rapidrate(1)
    command.maxvel(greatest_velocity)
    mdi("G21 G90 G53 G0 Z0")
    mdi(f"G21 G90 G53 G0 {job.get('start', 'X0 Y0 Z0')}")
    program = pathlib.Path(job["name"] + ".ngc")
    if "program" in job:
        program.write_text(job["program"])
        open_program(program)
    with recorded(job["name"] + ".record"):
        began = time.monotonic()
        if "program" in job:
            command.auto(linuxcnc.AUTO_RUN, 0)
            wait_until(polled(lambda: status.echo_serial_number == command.serial), "the start")
        for moment, what, value in job.get("acts", []):
            time.sleep(max(0, began + moment - time.monotonic()))
            act(what, value)
        wait_until(at_rest, f"the end of {job['name']}", PATIENCE)
    status.poll()
    end = {"position": status.position[:6], "servo_thread_ns": hal("getp", "motion-controller.tmax")}
    pathlib.Path(job["name"] + ".end").write_text(json.dumps(end))
    pathlib.Path(job["name"] + ".said").write_text("\n".join(complaints()))


switch_on()
status.poll()
greatest_velocity = status.max_velocity
if not greatest_velocity > 0:
    raise ValueError(f"greatest velocity {greatest_velocity}")
for job in json.loads(pathlib.Path("jobs.json").read_text()):
    try:
        play(job)
    except TimeoutError as late:
        pathlib.Path(job["name"] + ".said").write_text(f"timeout: {late}; {complaints()}")
        break
