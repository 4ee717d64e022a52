"""docs/diagnostics.md has every code of the reader's diagnostics, and each of its examples provokes its code. Codes of other
rooms stand in its table, and a test names each.

    diagnostics.py COMMAND SOURCE SCRATCH
"""
import json
import pathlib
import re
import subprocess
import sys

command, source, scratch = pathlib.Path(sys.argv[1]).resolve(), *(pathlib.Path(word).resolve() for word in sys.argv[2:4])
scratch.mkdir(parents=True, exist_ok=True)

# A call that reports a problem, up to the code: the first text of its arguments that is one word.
CALL = re.compile(r'\b(?:error|warning|note|curve_error|error_where_kept|warning_where_kept|error_at|warning_at|report|problem|'
                  r'send|warn)\(\s*(?:[^";]*?,\s*)??"([a-z][a-z0-9]*(?:-[a-z0-9]+)*)"')
# The same in other rooms, where more functions make them.
FURTHER = re.compile(r'\b(?:problem|failure|report|add|refusal|state_refusal|trace_problem|refused|system_failure|system_problem|at|'
                     r'warning|error)\s*\(\s*(?:[^";{}]*?[,?:]\s*)??"([a-z][a-z0-9]*(?:-[a-z0-9]+)+)"'
                     r'|Severity::\w+,\s*"([a-z][a-z0-9-]*)"|"(program-changed)"')
# What nothing can provoke from outside: each says that it is a defect.
DEFECTS = {"planning-failed", "study-slot", "travel-unchecked"}
SECTION = re.compile(r"^## ([a-z0-9-]+)\n(.*?)(?=^## |\Z)", re.MULTILINE | re.DOTALL)
EXAMPLE = re.compile(r"^```(ngc|tbl|var)([^\n]*)\n(.*?)\n?```$", re.MULTILINE | re.DOTALL)

problems = []


def codes_of_sources():
    codes = set()
    for path in [*(source / "src/leadscrew/gcode").glob("*.cpp"), source / "src/leadscrew/language/lint.cpp"]:
        codes.update(CALL.findall(path.read_text(encoding="utf-8")))
    return codes


def codes_of_other_rooms():
    codes = set()
    for path in (source / "src/leadscrew").rglob("*.cpp"):
        if path.parent.name not in ("gcode", "language", "markup"):
            codes.update(next(filter(None, found)) for found in FURTHER.findall(path.read_text(encoding="utf-8")))
    return codes


def written_out(text, info):
    """Of `repeat=N` the lines so often, with {n} counted; of `wide=N` one line of so many bytes."""
    repeat, wide = re.search(r"repeat=(\d+)", info), re.search(r"wide=(\d+)", info)
    if repeat:
        return "".join(text.replace("{n}", str(number)) + "\n" for number in range(1, int(repeat[1]) + 1))
    if wide:
        return (text * (int(wide[1]) // len(text) + 1))[:int(wide[1])] + "\n"
    return text + "\n" if text else ""


def codes_of(section):
    words = []
    for kind, info, text in EXAMPLE.findall(section):
        name = {"ngc": "part.ngc", "tbl": "tools.tbl", "var": "part.var"}[kind]
        (scratch / name).write_text(written_out(text, info), encoding="utf-8")
        if kind == "tbl":
            words += ["--tools", name]
        if kind == "var":
            words += ["--parameters", name]
        for word in info.split():
            if word.startswith("fuel="):
                words += ["--fuel", word.removeprefix("fuel=")]
            if "=" not in word:
                words += ["--lint"] if word == "lint" else ["--dialect", word]
    done = subprocess.run([command, "check", "part.ngc", "--json", *words], cwd=scratch, capture_output=True, text=True)
    if done.stdout:
        return {each["code"] for each in json.loads(done.stdout)["diagnostics"]}
    return set(re.findall(r"\[([a-z0-9-]+)\]$", done.stderr, re.MULTILINE))


page = (source / "docs/diagnostics.md").read_text(encoding="utf-8")
sections = SECTION.findall(page)
told = [code for code, _ in sections]
if told != sorted(set(told)):
    problems.append("docs/diagnostics.md: codes stand in the order of the alphabet, each once")
for code in sorted(codes_of_sources() - set(told)):
    problems.append(f"{code}: in the sources, not in docs/diagnostics.md")
for code in sorted(set(told) - codes_of_sources()):
    problems.append(f"{code}: in docs/diagnostics.md, not in the sources")
for code, section in sections:
    test = re.search(r"^Its test is in `(tests/[a-z_/]+\.cpp)`\.$", section, re.MULTILINE)
    if test:
        if not re.search(rf"(?<![a-z-]){code}(?![a-z-])", (source / test[1]).read_text(encoding="utf-8")):
            problems.append(f"{code}: {test[1]} does not name it")
    elif not EXAMPLE.search(section):
        problems.append(f"{code}: has no example")
    elif code not in (found := codes_of(section)):
        problems.append(f"{code}: its example provokes {sorted(found)}")
table = set(re.findall(r"`([a-z0-9-]+)`", " ".join(re.findall(r"^\| (`[^|]*`) \|", page, re.MULTILINE))))
tests = "".join(path.read_text(encoding="utf-8", errors="replace") for path in (source / "tests").rglob("*.cpp"))
for code in sorted(codes_of_other_rooms() - table - set(told)):
    problems.append(f"{code}: in the sources, not in the table of docs/diagnostics.md")
for code in sorted(table - codes_of_other_rooms()):
    problems.append(f"{code}: in the table of docs/diagnostics.md, not in the sources")
for code in sorted(table - DEFECTS):
    if not re.search(rf"(?<![a-z-]){code}(?![a-z-])", tests):
        problems.append(f"{code}: no test names it")
if len(told) < 50:
    problems.append(f"docs/diagnostics.md has {len(told)} codes: is this the page?")
print(f"{len(told)} codes of the reader, {len(table)} of other rooms")
sys.exit("\n".join(problems) or 0)
