"""Runs the programs of LinuxCNC's interpreter tests through leadscrew and rs274 and prints a table of where they part.

    linuxcnc_tests.py COMMAND TESTS [--record] [NAME…]

TESTS is the folder `tests` of LinuxCNC's sources. Programs that need Python or M-codes of a user
are told and not run. With NAMEs, only programs whose path holds one of them, with what was found in full. What was found
last stands in linuxcnc-tests.txt, with the cause of each difference: the status is 1 where a verdict is another one now,
and --record writes the verdicts of now, keeping the causes.
"""
import pathlib
import re
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import readers

RECORD = pathlib.Path(__file__).resolve().parent / "linuxcnc-tests.txt"
GROUPS = ("interp", "oword", "m70-m73", "ccomp", "lathe", "abort", "remap", "single-step", "motion-logger", "tlo", "trajectory-planner")
PYTHON = re.compile(r"^\s*(REMAP|TOPLEVEL|PATH_APPEND|ON_ABORT_COMMAND|PYTHON)|^\[PYTHON\]", re.M)
NOTES = re.compile(r"\([^)]*\)|;.*")
# What rs274 has in its tables where it is given none, inches.
BUILT_IN_TOOLS = "T1 P1 Z0.511\nT2 P2 Z0.1\nT3 P3 Z1.273\n"
# Both refuse for one reason and name another line: ours that of the call or of the end, theirs where a search ended.
ONE_REASON = (("missing-sub", "Failed to find sub|must be called with"),
              ("program-end", "File ended with no percent sign or program end"),
              ("cutter-gouge", "without gouging"))


def reason_to_leave(program, text):
    folder = program.parent
    if any(part in ("remap", "python", "pymove", "python-self", "plug", "compile") for part in program.parts):
        return "Python"
    if any(PYTHON.search(ini.read_text(errors="replace")) for ini in folder.glob("*.ini")):
        return "Python"
    if re.search(r"\(\s*py", text, re.I) or ";py" in text:
        return "Python"
    bare = NOTES.sub("", text)
    if re.search(r"M\s*1\d\d(?!\d)", bare, re.I):
        return "M-code of a user"
    return None


def tools_in_mm(table, folder):
    """rs274 without an INI reads a table in inches."""
    text = table.read_text(errors="replace") if table else BUILT_IN_TOOLS
    scaled = re.sub(r"([XYZUVWD])\s*([-+]?[\d.]+)", lambda m: f"{m[1]}{float(m[2]) * 25.4:.6f}", text.upper())
    target = folder / "of-leadscrew.tbl"
    target.write_text(scaled)
    return ["--tools", target]


def one_reason(ours, theirs):
    return any(f"[{code}]" in ours.reason and re.search(told, theirs.reason) for code, told in ONE_REASON)


def compare(command, program, root):
    text = program.read_text(errors="replace")
    name = str(program.relative_to(root))
    left = reason_to_leave(program, text)
    if left:
        return name, "left out", left, None
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "test"
        shutil.copytree(program.parent, folder)
        script = " ".join(path.read_text(errors="replace") for path in program.parent.glob("test.sh"))
        ini = next(iter(folder.glob("test.ini")), None) if "-i test.ini" in script else None
        table = next(iter(folder.glob("test.tbl")), None)
        copy = folder / program.name
        theirs = readers.of_peer(copy, folder, tools=table, ini=ini)
        ours = readers.of_leadscrew(command, copy, folder, tools_in_mm(table, folder))
    found, _ = readers.difference(ours, theirs)
    if found and found.startswith("both refuse") and one_reason(ours, theirs):
        found = None
    if found is None:
        return name, "same", "moves alike" if ours.accepted else f"both refuse: {ours.reason.split(': ', 1)[-1]}", None
    return name, "differs", found.splitlines()[0].replace(str(folder), ""), found


def recorded():
    """Verdicts and causes by names."""
    lines = RECORD.read_text(encoding="utf-8").splitlines() if RECORD.exists() else []
    rows = (line.split(None, 2) for line in lines if line and not line.startswith("#"))
    return {name: (verdict.replace("-", " "), rest[0] if rest else "") for verdict, name, *rest in rows}


def write_record(rows, before):
    text = "# What script/linuxcnc-tests finds: the verdict, the program, and the cause of a difference.\n"
    for name, verdict, why, _ in rows:
        kept = before[name][1] if name in before and before[name][0] == verdict else ""
        cause = "" if verdict == "same" else kept or why
        text += f"{verdict.replace(' ', '-'):9} {name} {cause}".rstrip() + "\n"
    RECORD.write_text(text, encoding="utf-8")


def main():
    command, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    wanted = [word for word in sys.argv[3:] if word != "--record"]
    if not readers.rs274():
        sys.exit("rs274 is not installed: script/install-packages peers")
    programs = [path for group in GROUPS for path in sorted((root / group).rglob("*.ngc"))]
    programs = [path for path in programs if not wanted or any(name in str(path.relative_to(root)) for name in wanted)]
    with ThreadPoolExecutor(2) as pool:
        rows = list(pool.map(lambda program: compare(command, program, root), programs))
    counts, before, changed = {}, recorded(), []
    for name, verdict, why, whole in rows:
        counts[verdict] = counts.get(verdict, 0) + 1
        known = before.get(name, ("not recorded", ""))
        if known[0] != verdict:
            changed.append(f"{name}: {verdict}, was: {known[0]}")
        cause = f"  ({known[1]})" if verdict == "differs" and known[1] else ""
        print(f"{verdict:9} {name:75} {whole if wanted and whole else why[:150]}{cause}")
    if "--record" in sys.argv:
        write_record(rows, before)
        changed = []
    print(", ".join(f"{verdict}: {count}" for verdict, count in sorted(counts.items())))
    if changed:
        sys.exit("\n".join(["other than recorded in tests/peer/linuxcnc-tests.txt:", *changed]))


if __name__ == "__main__":
    main()
