#!/usr/bin/python3
"""Stands in for LinuxCNC's screen: plays the jobs of jobs.json and records each one's words.

A job has a name, a start ("X10 Y0"), a program's text or an MDI command, and acts: [seconds after its start, what, value].
NAME.record gets a line for each servo period: number, then X, Y and Z in nanometres, and outputs. NAME.said gets what
LinuxCNC has to say against it, NAME.end where it ended and how long the servo thread took, at most.
"""
import json
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


def wait_until(holds, what, seconds=60):
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise TimeoutError(what)
        time.sleep(0.005)


def polled(holds):
    def now():
        status.poll()
        return holds()
    return now


at_rest = polled(lambda: status.interp_state == linuxcnc.INTERP_IDLE and status.queue == 0 and status.inpos)


def hal(*words):
    return subprocess.run(["halcmd", *words], check=True, capture_output=True, text=True).stdout.strip()


def switch_on():
    for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
        command.state(state)
        command.wait_complete()
    command.home(-1)
    wait_until(polled(lambda: all(status.homed[: status.joints])), "homing")


def mdi(text):
    command.mode(linuxcnc.MODE_MDI)
    command.wait_complete()
    command.mdi(text)
    command.wait_complete(60)
    wait_until(at_rest, text)


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
    """The job, with some rest before and after it."""
    complaints()
    command.feedrate(1)
    command.rapidrate(1)
    mdi("G21 G90 G53 G0 Z0")
    mdi(f"G21 G90 G53 G0 {job.get('start', 'X0 Y0 Z0')}")
    program = pathlib.Path(job["name"] + ".ngc")
    if "program" in job:
        program.write_text(job["program"])
        command.mode(linuxcnc.MODE_AUTO)
        command.wait_complete()
        command.program_open(str(program.resolve()))
        command.wait_complete()
    sampler = subprocess.Popen(["halsampler", "-t", job["name"] + ".record"])
    hal("setp", "sampler.0.enable", "1")
    time.sleep(0.1)
    began = time.monotonic()
    if "program" in job:
        command.auto(linuxcnc.AUTO_RUN, 0)
        wait_until(polled(lambda: status.echo_serial_number == command.serial), "the start")
    for moment, what, value in job.get("acts", []):
        time.sleep(max(0, began + moment - time.monotonic()))
        act(what, value)
    wait_until(at_rest, f"the end of {job['name']}")
    time.sleep(0.1)
    hal("setp", "sampler.0.enable", "0")
    wait_until(lambda: int(hal("getp", "sampler.0.curr-depth")) == 0, "emptying the sampler")
    sampler.terminate()
    sampler.wait()
    status.poll()
    end = {"position": status.position[:3], "servo_thread_ns": hal("getp", "motion-controller.tmax")}
    pathlib.Path(job["name"] + ".end").write_text(json.dumps(end))
    pathlib.Path(job["name"] + ".said").write_text("\n".join(complaints()))


switch_on()
for job in json.loads(pathlib.Path("jobs.json").read_text()):
    try:
        play(job)
    except TimeoutError as late:
        pathlib.Path(job["name"] + ".said").write_text(f"timeout: {late}; {complaints()}")
        break
