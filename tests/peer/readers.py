"""The two readers that are compared: `leadscrew canon` and LinuxCNC's `rs274`, each in a process of its own."""
import pathlib
import shutil
import subprocess
import tempfile

import calls

HERE = pathlib.Path(__file__).resolve().parent
LONGEST = 20  # seconds that a program may take


class Outcome:
    """What came of a program: whether it was accepted, its motions, and where and why it was refused."""

    def __init__(self, accepted, output, reason="", line=None):
        self.accepted, self.output, self.reason, self.line = accepted, output, reason, line
        self.motions = calls.motions(output)


def rs274():
    return shutil.which("rs274")


def of_peer(program, folder=None, tools=None, parameters=None, ini=None):
    """Its HOME and its file of parameters are fresh; -b, so that it skips blocks behind a slash; tables are in inches."""
    with tempfile.TemporaryDirectory() as home:
        variables = pathlib.Path(home) / "variables"
        variables.write_bytes(pathlib.Path(parameters).read_bytes() if parameters else b"")
        words = [rs274(), "-g", "-b", "-v", variables]
        words += ["-t", tools] if tools else []
        words += ["-i", ini] if ini else []
        try:
            done = subprocess.run([*words, program], cwd=folder or home, env={"HOME": home, "PATH": "/usr/bin:/bin"},
                                  capture_output=True, timeout=LONGEST)
        except subprocess.TimeoutExpired:
            return Outcome(False, "", "takes too long", "")
    told = done.stderr.decode("latin-1").splitlines()
    reason = [line for line in told if line != "executing"]
    return Outcome(done.returncode == 0, done.stdout.decode("latin-1"), reason[-2] if len(reason) > 1 else "".join(reason),
                   reason[-1] if len(reason) > 1 else "")


def of_leadscrew(command, program, folder=None, options=()):
    try:
        done = subprocess.run([command, "canon", "--color", "never", "--dialect", "linuxcnc", "--machine", HERE / "wide.toml", *options, program],
                              cwd=folder, capture_output=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return Outcome(False, "", "takes too long", "")
    told = done.stderr.decode("latin-1").splitlines()
    for i, line in enumerate(told):
        if ": error: " in line or " error" in line.split(":")[-2:-1]:
            return Outcome(done.returncode == 0, done.stdout.decode("latin-1"), line, told[i + 1].strip() if i + 1 < len(told) else "")
    return Outcome(done.returncode == 0, done.stdout.decode("latin-1"), told[0] if told and done.returncode else "", "")


def bare(line):
    """A line without blanks and case."""
    return "".join(line.split()).lower()


def difference(ours, theirs):
    """Where two outcomes of one program part, in words; None where they do not. And calls.difference's other ways."""
    if ours.accepted != theirs.accepted:
        told = f"theirs refuses: {theirs.reason} [{theirs.line}]" if ours.accepted else f"ours refuses: {ours.reason} [{ours.line}]"
        return told, 0
    found, ways = calls.difference(ours.motions, theirs.motions, ours.accepted)
    if found is None and not ours.accepted and theirs.line and ours.line and bare(ours.line) != bare(theirs.line):
        found = f"both refuse, ours [{ours.line}] {ours.reason}, theirs [{theirs.line}] {theirs.reason}"
    return found, ways
