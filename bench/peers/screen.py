"""What stands in for LinuxCNC's screen: commands, waiting, and the sampler that takes down words. It lies beside the scripts that
LinuxCNC starts as its DISPLAY, with Debian's Python."""
import contextlib
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


def open_program(program):
    command.mode(linuxcnc.MODE_AUTO)
    command.wait_complete()
    command.program_open(str(program.resolve()))
    command.wait_complete()


@contextlib.contextmanager
def recorded(file):
    """Takes down words as long as it lasts, with some rest before and after."""
    sampler = subprocess.Popen(["halsampler", "-t", file])
    hal("setp", "sampler.0.enable", "1")
    time.sleep(0.1)
    yield
    time.sleep(0.1)
    hal("setp", "sampler.0.enable", "0")
    wait_until(lambda: int(hal("getp", "sampler.0.curr-depth")) == 0, "emptying the sampler")
    sampler.terminate()
    sampler.wait()
