"""Runs Debian's LinuxCNC in simulation, in namespaces of its own: nothing is installed, and no other LinuxCNC is met."""
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SCREEN = HERE.parents[2] / "bench" / "peers" / "screen.py"
MODULES = pathlib.Path("/usr/lib/linuxcnc/modules")

# In the namespaces: a folder of modules with ours among them, a /tmp of its own, the loop interface, a user that is not root.
# There is no real-time kernel: that its servo thread comes in time, other programs give way.
INSIDE = """
set -e
mount -t tmpfs none /tmp
mkdir /tmp/modules
cp -a {modules}/. /tmp/modules/
cp {module} /tmp/modules/leadscrew_tp.so
mount --bind /tmp/modules {modules}
ip link set lo up 2>/dev/null || true
cd {scratch}
exec nice -n -10 setpriv --reuid=nobody --regid=nogroup --clear-groups bash -c {command}
"""


def run(module, scratch, command):
    """Runs the command in this folder and the namespaces, with the module; returns what it prints."""
    for path in (scratch, *scratch.iterdir()):
        shutil.chown(path, "nobody", "nogroup")
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    # RUNTESTS: what it says goes to our log. Its servo thread gets its priority without a real-time kernel too.
    environment |= {"HOME": str(scratch), "RUNTESTS": "1", "LINUXCNC_FORCE_REALTIME": "1"}
    script = INSIDE.format(modules=MODULES, module=module, scratch=scratch, command=shlex.quote(command))
    ran = subprocess.run(["unshare", "--mount", "--ipc", "--net", "--pid", "--fork", "--mount-proc", "--kill-child", "bash", "-c", script],
                         env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    return ran.stdout + ran.stderr


def play(module, planner, jobs, seconds=600, hal="machine.hal", hal_text=None, ini_text=None):
    """Plays jobs (play.py) with this planner of [TRAJ]TPMOD and this HAL file, or its text; returns {name: (record, said, end)},
    and LinuxCNC's log."""
    with tempfile.TemporaryDirectory(dir="/var/tmp") as scratch:
        scratch = pathlib.Path(scratch)
        ini = (HERE / "machine.ini").read_text().replace("@PLANNER@", planner).replace("@HAL@", hal)
        (scratch / "machine.ini").write_text(ini_text or ini)
        (scratch / hal).write_text(hal_text or (HERE / hal).read_text())
        for script in (HERE / "play.py", SCREEN):
            shutil.copy(script, scratch)
        (scratch / "jobs.json").write_text(json.dumps(jobs))
        log = run(module, scratch, f"timeout {seconds} linuxcnc machine.ini")
        results = {}
        for job in jobs:
            said = scratch / (job["name"] + ".said")
            record = scratch / (job["name"] + ".record")
            end = scratch / (job["name"] + ".end")
            results[job["name"]] = (record.read_text() if record.exists() else "",
                                    said.read_text() if said.exists() else "it was not played",
                                    json.loads(end.read_text()) if end.exists() else {})
        return results, log


def arguments():
    """Of the command: the module, and what follows. Ends it where LinuxCNC cannot be run."""
    if shutil.which("linuxcnc") is None or os.geteuid() != 0:
        print("LinuxCNC is not installed, or this is not root: skipped")
        sys.exit(77)
    return sys.argv[1], sys.argv[2:]
