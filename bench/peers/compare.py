#!/usr/bin/env python3
"""compare.py LEADSCREW FOLDER [linuxcnc] [five-axes]: leadscrew beside LinuxCNC, a table for each machine, or for those that
are named; every trace is judged by leadscrew's referee.

Programs, records, traces and LinuxCNC's log are left in FOLDER.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from programs import machines
from record_to_trace import write_trace

HERE = pathlib.Path(__file__).resolve().parent
LOCK = pathlib.Path("/tmp/linuxcnc.lock")


def start_words(letters, place):
    return [f"{letter}{value:.15g}" for letter, value in zip(letters, place)]


def options_of(machine, program):
    return [*machine.options, "--start", ",".join(start_words(machine.letters, program.start))]


def run_leadscrew(leadscrew, folder, machine, program):
    """The trace of the program, or why there is none."""
    trace = folder / f"{program.name}.leadscrew.csv"
    trace.unlink(missing_ok=True)
    run = subprocess.run(
        [leadscrew, "run", "--quiet", *options_of(machine, program), "--trace", trace, folder / f"{program.name}.ngc"],
        capture_output=True, text=True)
    if run.returncode > 1:
        return None, (run.stderr.strip() or f"exit status {run.returncode}").splitlines()[0]
    return trace, None


def run_linuxcnc(folder, machine, listed):
    """Lets LinuxCNC run all programs; says what went wrong, if anything."""
    if LOCK.exists():
        return f"it is running already, says {LOCK}"
    # It keeps files beside its configuration, and refuses to be root: so it gets a folder and, if need be, a user.
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        for name in (f"{machine.configuration}.ini", f"{machine.configuration}.hal", "record.py", "screen.py"):
            shutil.copy(HERE / name, scratch)
        for program in listed:
            (scratch / f"{program.name}.ngc").write_text(program.peer_text or program.text)
            place = start_words(machine.letters, program.peer_start or program.start)
            (scratch / f"{program.name}.start").write_text(" ".join(place))
        user = []
        if os.geteuid() == 0:
            user = ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"]
            for path in (scratch, *scratch.iterdir()):
                shutil.chown(path, "nobody", "nogroup")
        environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
        # RUNTESTS: what it says goes to our log, not to files of its own.
        environment |= {"HOME": str(scratch), "RUNTESTS": "1"}
        with open(folder / f"{machine.configuration}.log", "w") as log:
            subprocess.run([*user, "timeout", "900", "linuxcnc", scratch / f"{machine.configuration}.ini"], env=environment,
                           cwd=scratch, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT)
        for result in (*scratch.glob("*.record"), *scratch.glob("*.said")):
            shutil.copy(result, folder)
    if not all((folder / f"{program.name}.said").exists() for program in listed):
        return f"it did not run everything, see {folder}/{machine.configuration}.log"
    return None


def version():
    """Of Debian's package, with a space before it; nothing for a LinuxCNC from elsewhere."""
    package = subprocess.run(["dpkg-query", "--show", "--showformat= ${Version}", "linuxcnc-uspace"],
                             capture_output=True, text=True)
    return package.stdout.split("+")[0]


def linuxcnc_trace(folder, program):
    """The trace that LinuxCNC's record makes, or why there is none."""
    record, said = folder / f"{program.name}.record", folder / f"{program.name}.said"
    if not said.exists():
        return None, "not run"
    if said.read_text():
        return None, "refused: " + said.read_text().splitlines()[0]
    trace = folder / f"{program.name}.linuxcnc.csv"
    try:
        write_trace(record, trace)
    except ValueError as error:
        return None, str(error)
    return trace, None


def judge(leadscrew, folder, machine, program, trace):
    verify = subprocess.run(
        [leadscrew, "verify", "--json", *options_of(machine, program), trace, folder / f"{program.name}.ngc"],
        capture_output=True, text=True)
    if verify.returncode > 1:
        raise RuntimeError(f"the referee cannot read {trace}: {verify.stderr}")
    return json.loads(verify.stdout)


def row(title, controller, found):
    """A line of the table; found is the referee's verdict, or text."""
    head = f"{title:<22}{controller:<11}"
    if isinstance(found, str):
        return (head + "  " + found)[:100]
    peak = {what: max(axis[f"{what}_ratio"] for axis in found["axes"]) for what in ("velocity", "acceleration", "jerk")}
    tip = found.get("tip")  # where there is tool centre point control
    deviation = (tip or found)["deviation_mm"] * 1e3
    direction = f"{tip['orientation_deviation_deg']:>12.4f}" if tip else ""
    return (head + f"{found['time_s']:>9.3f}{deviation:>12.2f}{found['tolerance_mm'] * 1e3:>11g}"
            f"{peak['velocity']:>11.2f}{peak['acceleration']:>14.2f}{peak['jerk']:>8.2f}{direction}")


def table(leadscrew, folder, machine, listed):
    """Prints it; says what went wrong with LinuxCNC, if anything."""
    for program in listed:
        (folder / f"{program.name}.ngc").write_text(program.text)
    installed = shutil.which("linuxcnc") is not None
    trouble = run_linuxcnc(folder, machine, listed) if installed else None

    print(f"Words every 1 ms; {machine.told}.\n"
          f"LinuxCNC{version() if installed else ''} knows no limit of jerk: its figure is a multiple of the same.\n")
    has_direction = "C" in machine.letters
    print(f"{'':<33}{'time':>9}{'deviation':>12}{'tolerance':>11}{'velocity':>11}{'acceleration':>14}{'jerk':>8}"
          + f"{'direction':>12}" * has_direction)
    print(f"{'program':<22}{'controller':<11}{'s':>9}{'µm':>12}{'µm':>11}{'peak, in multiples of limit':>33}"
          + f"{'off by °':>12}" * has_direction)
    for program in listed:
        trace, problem = run_leadscrew(leadscrew, folder, machine, program)
        print(row(program.title, "leadscrew", problem or judge(leadscrew, folder, machine, program, trace)))
        if installed:
            trace, problem = linuxcnc_trace(folder, program)
            print(row("", "LinuxCNC", problem or judge(leadscrew, folder, machine, program, trace)))
    if not installed:
        print("LinuxCNC is not installed, and not measured: script/install-packages peers")
    print(flush=True)
    return trouble


def main(leadscrew, folder, *only):
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    troubles = [table(leadscrew, folder, machine, listed)
                for machine, listed in machines() if not only or machine.configuration in only]
    if any(troubles):
        sys.exit(f"LinuxCNC: {', '.join(filter(None, troubles))}")


main(*sys.argv[1:])
