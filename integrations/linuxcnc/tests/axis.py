#!/usr/bin/env python3
"""axis.py MODULE PICTURE: the example of the HAL file, with LinuxCNC's own screen AXIS under Xvfb. Its program is run, a limit of jerk
follows its output, and the screen is written to PICTURE (PNG) on the way. 77 where there is no LinuxCNC or no Xvfb."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import simulator

EXAMPLE = simulator.HERE.parent / "example"
# Beside AXIS, with Debian's Python: switches on, runs the program, looks.
BESIDE = """
import json, pathlib, subprocess, time
for _ in range(600):
    shown = subprocess.run(["halcmd", "-s", "show", "comp"], capture_output=True, text=True).stdout
    if "axisui" in shown:
        break
    time.sleep(0.1)
from screen import at_rest, command, complaints, hal, mdi, polled, status, wait_until
import linuxcnc
from PIL import ImageGrab
time.sleep(3)
# AXIS gives commands of its own meanwhile.
for state, found in ((linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ESTOP), (linuxcnc.STATE_ON, linuxcnc.STATE_ESTOP_RESET)):
    for _ in range(50):
        command.state(state)
        time.sleep(0.2)
        status.poll()
        if status.task_state != found:
            break
command.mode(linuxcnc.MODE_MANUAL)
command.wait_complete()
command.teleop_enable(0)
command.wait_complete()
command.home(-1)
wait_until(polled(lambda: all(status.homed[: status.joints])), "homing", 20)
mdi("G0 X0 Y0 Z5")
jerk = [float(hal("getp", "leadscrew-tp." + name + "-jerk")) for name in "xz"]
mdi("M64 P0")
time.sleep(0.1)
jerk.append(float(hal("getp", "leadscrew-tp.x-jerk")))
mdi("M65 P0")
said = complaints()
subprocess.run(["axis-remote", str(pathlib.Path("flower.ngc").resolve())], check=True)
time.sleep(3)
command.mode(linuxcnc.MODE_AUTO)
command.wait_complete()
command.auto(linuxcnc.AUTO_RUN, 0)
wait_until(polled(lambda: status.current_vel > 40 and status.motion_line > 10), "motion", 60)
time.sleep(1)
status.poll()
velocity = status.current_vel
ImageGrab.grab(xdisplay="").save("axis.png")
wait_until(at_rest, "the end", 120)
status.poll()
pathlib.Path("axis.json").write_text(json.dumps({"jerk": jerk, "said": said + complaints(), "velocity": velocity,
    "end": status.position[:3], "late": int(hal("getp", "leadscrew-tp.late"))}))
subprocess.run(["axis-remote", "--quit"])
"""


def main(module, picture):
    with tempfile.TemporaryDirectory(dir="/var/tmp") as scratch:
        scratch = pathlib.Path(scratch)
        for path in (*EXAMPLE.iterdir(), simulator.SCREEN):
            shutil.copy(path, scratch)
        (scratch / "beside.py").write_text(BESIDE)
        command = ("Xvfb :7 -screen 0 740x752x24 >xvfb.log 2>&1 & export DISPLAY=:7; sleep 2;"
                   " /usr/bin/python3 beside.py >beside.log 2>&1 & exec timeout 150 linuxcnc leadscrew.ini")
        log = simulator.run(module, scratch, command)
        found = scratch / "axis.json"
        if not found.exists():
            sys.exit(log + "".join(path.read_text() for path in (scratch / "beside.log", scratch / "xvfb.log") if path.exists()))
        shutil.copy(scratch / "axis.png", picture)
        result = json.loads(found.read_text())
    print(result)
    wrong = []
    if result["jerk"] != [20000, 10000, 5000]:
        wrong.append("limits of jerk by pins")
    if result["end"] != [0, 0, 10]:
        wrong.append("the program's end")
    if result["said"]:
        wrong.append("what LinuxCNC says")
    if pathlib.Path(picture).stat().st_size < 20000:
        wrong.append("an empty screen")
    sys.exit(", ".join(wrong) or 0)


if __name__ == "__main__":
    module, arguments = simulator.arguments()
    if shutil.which("Xvfb") is None:
        print("Xvfb is not installed: skipped")
        sys.exit(77)
    main(module, *arguments)
