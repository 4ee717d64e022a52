#!/usr/bin/python3
"""Stands in for LinuxCNC's screen: plays the jobs of jobs.json and records each one's words.

A job has a name, a start ("X10 Y0"), a program's text, and acts: [seconds after its start, what, value]. The program is run at
once, where no act runs it. NAME.record gets a line for each servo period: number, then X, Y and Z in nanometres, and outputs.
NAME.said gets what LinuxCNC has to say against it, NAME.end where it ended and how long the servo thread took, at most.
"""
import json
import pathlib
import time

import linuxcnc
from screen import at_rest, command, complaints, hal, mdi, open_program, polled, recorded, status, switch_on, wait_until

PATIENCE = 120  # s


def settle(rests, what):
    """Waits until this holds ten times, one behind the other."""
    times = 0

    def holds():
        nonlocal times
        times = times + 1 if rests() else 0
        return times == 10

    wait_until(holds, what, PATIENCE)


def is_over():
    """At rest, and no command is on its way."""
    return at_rest() and status.queued_mdi_commands == 0


def stands():
    before = status.joint_position
    status.poll()
    return status.joint_position == before


def jog(axis, speed, seconds):
    """From rest to rest."""
    settle(is_over, "rest before a jog")
    command.mode(linuxcnc.MODE_MANUAL)
    command.wait_complete()
    command.teleop_enable(1)
    command.wait_complete()
    command.jog(linuxcnc.JOG_CONTINUOUS, 0, axis, speed)
    time.sleep(seconds)
    command.jog(linuxcnc.JOG_STOP, 0, axis)
    settle(stands, "rest behind a jog")


def begin(mode, action):
    """A program or a command, in its mode; it is on its way."""
    status.poll()
    if status.task_mode != mode:
        command.mode(mode)
        command.wait_complete()
    action()
    wait_until(polled(lambda: status.echo_serial_number == command.serial), "the start", 10)


def run():
    begin(linuxcnc.MODE_AUTO, lambda: command.auto(linuxcnc.AUTO_RUN, 0))


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
    elif what == "signal":
        hal("sets", *value)
    elif what == "motion":
        wait_until(polled(lambda: status.current_vel > 0), "motion", PATIENCE)
        time.sleep(value)
    elif what == "wait":
        time.sleep(value)
    elif what == "mdi":
        mdi(value)
    elif what == "rest":
        settle(is_over, "rest")
    elif what == "jog":
        jog(*value)
    elif what == "send":
        begin(linuxcnc.MODE_MDI, lambda: command.mdi(value))
    elif what == "run":
        run()


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
        if "program" in job and not any(what == "run" for _, what, _ in job.get("acts", [])):
            run()
        for moment, what, value in job.get("acts", []):
            time.sleep(max(0, began + moment - time.monotonic()))
            act(what, value)
        settle(is_over, f"the end of {job['name']}")
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
