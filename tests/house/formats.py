"""docs/formats.md and docs/schemas say what the command writes: real output of every verb is held against them.

    formats.py COMMAND SOURCE SCRATCH

Every schema must fit some output, and every key of every schema must occur in one. That a schema would object is seen
each time: to a key that is missing, and to one that it does not know.
"""
import base64
import copy
import csv
import json
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.request

import jsonschema
import numpy

command, source, scratch = pathlib.Path(sys.argv[1]).resolve(), *(pathlib.Path(word).resolve() for word in sys.argv[2:4])
page = (source / "docs/formats.md").read_text(encoding="utf-8")
problems = []
statuses = set()

SLOW_STUDIES = {"limits", "tube", "bounds", "surface"}  # tests/study has them
AXES = "XYZABCUVW"
POSES = ["tx", "ty", "tz", "i", "j", "k"]  # columns of machines with kinematics


def check(holds, message):
    if not holds:
        problems.append(message)


def run(*words, status=0):
    """What the command prints; its exit status must be this one."""
    done = subprocess.run([command, *map(str, words)], cwd=scratch, capture_output=True, text=True)
    statuses.add(done.returncode)
    check(done.returncode == status, f"{' '.join(map(str, words))}: ended with {done.returncode}\n{done.stderr}")
    return done.stdout


# Schemas


class Schemas:
    def __init__(self, folder):
        self.base = folder.as_uri() + "/"
        self.files = {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted(folder.glob("*.json"))}
        self.resolver = jsonschema.RefResolver(
            self.base, {}, store={f"{self.base}{name}.json": schema for name, schema in self.files.items()})
        self.keys = {}  # of every object of every file, by id: how often each occurred
        for name, schema in self.files.items():
            jsonschema.Draft202012Validator.check_schema(schema)
            self.enter(name, schema)
        self.fitted = set()

    def enter(self, at, schema):
        """Looks whether an object leaves nothing open, and counts none of its keys yet."""
        if not isinstance(schema, dict):
            return
        if schema.get("type") == "object":
            check(schema.get("additionalProperties") is False, f"{at} allows keys that it does not know")
            check("required" in schema or "patternProperties" in schema, f"{at} does not say which keys are required")
            self.keys[id(schema)] = {key: (f"{at}.{key}", 0) for key in schema.get("properties", {})}
            for key, value in schema.get("properties", {}).items():
                told = value.get("description") or self.resolved(value).get("description")
                check(bool(told), f"{at}.{key} has no description")
        for key, value in schema.items():
            if key in ("properties", "patternProperties", "$defs"):
                for name, each in value.items():
                    self.enter(f"{at}.{name}", each)
            elif key in ("items", "anyOf"):
                for each in value if isinstance(value, list) else [value]:
                    self.enter(at, each)

    def resolved(self, schema):
        while "$ref" in schema:
            file, _, pointer = schema["$ref"].partition("#")
            schema = self.files[file.removesuffix(".json")]
            for step in filter(None, pointer.split("/")):
                schema = schema[step]
        return schema

    def validator(self, schema):
        return jsonschema.Draft202012Validator(schema, resolver=self.resolver)

    def fit(self, name, value, what):
        """Holds a value against a schema, and the schema against the value with a key too few and too many."""
        self.fitted.add(name)
        schema = self.files[name]
        for error in self.validator(schema).iter_errors(value):
            problems.append(f"{what} does not fit {name}.json: {error.json_path}: {error.message[:300]}")
        self.count(schema, value)
        for key in schema["required"]:
            check(not self.accepts(schema, {k: v for k, v in value.items() if k != key}), f"{name}.json misses no {key}")
        check(not self.accepts(schema, {**value, "no_key": 0}), f"{name}.json takes any key")

    def accepts(self, schema, value):
        return self.validator(schema).is_valid(value)

    def count(self, schema, value):
        schema = self.resolved(schema)
        for each in schema.get("anyOf", []):
            if self.accepts(each, value):
                self.count(each, value)
        if isinstance(value, list) and "items" in schema:
            for item in value:
                self.count(schema["items"], item)
        if isinstance(value, dict) and schema.get("type") == "object":
            known = self.keys[id(schema)]
            for key, item in value.items():
                if key in known:
                    known[key] = (known[key][0], known[key][1] + 1)
                    self.count(schema["properties"][key], item)

    def conclude(self):
        for name in self.files:
            check(name in self.fitted or name in ("parts", "diagnostic"), f"no output was held against {name}.json")
        for known in self.keys.values():
            for key, count in known.values():
                check(count > 0, f"no output has {key}")
        told = {schema.get("properties", {}).get("schema", {}).get("const") for schema in self.files.values()}
        for path in (source / "src").rglob("*.?pp"):
            for name in re.findall(r'"(leadscrew\.[a-z-]+/\d+)"', path.read_text(encoding="utf-8")):
                check(name in told, f"{path.name} writes {name}, which has no file in docs/schemas")


def json_of(schemas, name, *words, status=0):
    output = run(*words, "--json", status=status)
    try:
        value = json.loads(output)
    except ValueError:
        problems.append(f"{' '.join(map(str, words))} prints no JSON:\n{output[:300]}")
        return {}
    schemas.fit(name, value, "the output of " + " ".join(map(str, words)))
    return value


# Tables of the page


def table(kind, name):
    """The rows of a table behind <!-- kind: name -->, cell by cell, without the ticks of names."""
    found = re.search(rf"<!-- {kind}: {name} -->\n(.*?)<!-- end -->", page, re.DOTALL)
    if not found:
        sys.exit(f"docs/formats.md has no table of {kind} {name}")
    rows = [[cell.strip() for cell in line.strip("|").split(" |")] for line in found[1].splitlines() if line.startswith("|")]
    return rows[2:]


def columns(name, axes, verb="run", laser=False, poses=False):
    """Names and units that a file has by the page."""
    found = []
    for cell, unit, meaning in table("columns", name):
        if ("`simulate` only" in meaning and verb != "simulate") or ("`[laser]` only" in meaning and not laser):
            continue
        if cell.strip("`") in POSES and not poses:
            continue
        column = cell.strip("`")
        for axis in axes if "{axis}" in column else [""]:
            units = unit.split(", ")
            found.append((column.replace("{axis}", axis), units[-1] if axis in "ABC" and axis else units[0]))
    return found


def names(named):
    return [name for name, _ in named]


def rows_of(file):
    with open(scratch / file, newline="", encoding="utf-8") as text:
        return list(csv.reader(text))


def check_header(file, expected):
    header = rows_of(file)[0]
    check(header == names(expected), f"{file} has the columns {header}, docs/formats.md has {names(expected)}")


# What is run

examples, machines = source / "examples", source / "machines"
square = examples / "04-square.ngc"


def prepare():
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    (scratch / "good.ngc").write_text("G21 G90\nS800 M3\nG1 X1 F600\nM8\nX2 M62 P3\nM67 E2 Q0.5\nG4 P0.01\nG0 X0\n")
    (scratch / "tip.ngc").write_text("G21 G90 G64 P0.01 E0.1\nG43.4 H0\nG1 X1 A5 F600\nC9\nM2\n")
    (scratch / "bad.ngc").write_text("G21\nG1 X\nM2\n")
    (scratch / "says.ngc").write_text("G21 G90\n(MSG,begin)\nG0 X1 (PRINT,%d#<_value>)\nM2\n")
    (scratch / "fast.ngc").write_text("G21 G90\nG1 X9 F30000\nM2\n")
    (scratch / "turn.ngc").write_text("G21 G90\nG1 A30 X5 F600\nA0\nM2\n")
    (scratch / "gouge.ngc").write_text("T1 M6\nG0 Z50\nG6.4 D1 P3 Q2 I3 J2\nX0 Y0 Z9\nX10 Z0\nX20 Z9\nX0 Y20\nX10 Z0\nX20 Z9\n"
                                       "G6.5 D1 Q3 L2 Z20 F3000\nG1 X10 Y10 Z2\nG0 Z50\nM2\n")
    (scratch / "shapes.tbl").write_text("T1 D40 R20 L60 H80 K50\n")
    worn = (machines / "mill6.toml").read_text(encoding="utf-8")
    worn = worn.replace("[axis.A]\n", "[axis.A]\nbacklash_deg = 0.01\n").replace("[axis.X]\n", "[axis.X]\nbacklash_mm = 0.01\n")
    (scratch / "worn6.toml").write_text(worn)
    (scratch / "thread.ngc").write_text("G21 G90\nS300 M3\nG33 Z-10 K1\nG33 Z-10.01 K1\nM2\n")
    mill = (machines / "mill3.toml").read_text(encoding="utf-8")
    (scratch / "spindle.toml").write_text(f"{mill}\n[spindle]\nnoise = 0.05\n", encoding="utf-8")


def check_runs(schemas):
    json_of(schemas, "version", "--version")
    json_of(schemas, "run", "run", "good.ngc")
    json_of(schemas, "run", "run", square, "--machine", machines / "mill3-worn.toml", "--pulses", "steps.vcd")
    json_of(schemas, "run", "run", square, "--pulses", "steps.csv", "--pulse-method", "dda", "--accelerate")
    json_of(schemas, "run", "run", "turn.ngc", "--machine", "worn6.toml", "--pulses", "turn.csv")
    json_of(schemas, "run", "run", examples / "09-butterfly.ngc", "--interpolator", "uniform", status=1)
    json_of(schemas, "run", "run", "tip.ngc", "--machine", machines / "table-table-ac.toml")
    json_of(schemas, "run", "run", "thread.ngc", "--machine", "spindle.toml")
    json_of(schemas, "runs", "run", "good.ngc", square, "bad.ngc", status=3)
    json_of(schemas, "runs", "check", "good.ngc", "bad.ngc", status=3)
    json_of(schemas, "runs", "simulate", "good.ngc", square)
    json_of(schemas, "runs", "run", "good.ngc", square, "--machine", "none.toml", status=4)
    for words in (["run", "bad.ngc"], ["simulate", "bad.ngc"], ["drive", "bad.ngc"], ["verify", "steps.csv", "bad.ngc"]):
        json_of(schemas, "rejected", *words, status=3)
    json_of(schemas, "rejected", "run", "none.ngc", status=4)
    json_of(schemas, "rejected", "check", square, "--machine", "none.toml", status=4)
    json_of(schemas, "check", "check", "good.ngc")
    json_of(schemas, "check", "check", "fast.ngc")
    json_of(schemas, "check", "check", "says.ngc")
    json_of(schemas, "check", "check", "--gouge", "gouge.ngc", "--tools", "shapes.tbl", status=1)
    json_of(schemas, "check", "check", "bad.ngc", status=3)


def check_recordings(schemas):
    """Of a page that stands beside the command as it is installed, the result and the words are those of the run."""
    beside = scratch / "installed"
    (beside / "bin").mkdir(parents=True)
    (beside / "share/leadscrew").mkdir(parents=True)
    installed = shutil.copy(command, beside / "bin/leadscrew")
    begin, end = '<script type="application/json" id="recording" data-schema="leadscrew.recording/1">', "</script>"
    (beside / "share/leadscrew/program.html").write_text(f"<title>page</title>{begin}{end}<p>behind</p>\n", encoding="utf-8")
    (scratch / "marks.ngc").write_text("(</script><!-- & )\nG21 G90 G43.1 Z3\nG1 X1 F600\nG0 X0\nM2\n")
    for words, status in ((["marks.ngc"], 0), ([examples / "03-arcs-in-three-planes.ngc"], 0),
                          (["gouge.ngc", "--tools", "shapes.tbl", "--allow-gouge"], 0),
                          (["tip.ngc", "--machine", machines / "table-table-ac.toml"], 0)):
        line = [installed, "run", *map(str, words), "--report", "page.html", "--trace", "page.csv", "--json"]
        done = subprocess.run(line, cwd=scratch, capture_output=True, text=True)
        check(done.returncode == status, f"{line}: ended with {done.returncode}\n{done.stderr}")
        text = (scratch / "page.html").read_text(encoding="utf-8")
        check(text.count(end) == 1 and text.endswith("<p>behind</p>\n"), "a recording ends its element")
        recording = json.loads(text[text.index(begin) + len(begin):text.index(end)])
        schemas.fit("recording", recording, f"the page of {words[0]}")
        check(recording["result"] == json.loads(done.stdout), f"the page of {words[0]} has another result than was printed")
        check(recording["text"] == (scratch / words[0]).read_text(encoding="utf-8"), f"the page of {words[0]} has another text")
        check_samples(recording, words[0])

    # Of a program that the page has no room for, the report is the command's own page.
    (scratch / "long.ngc").write_text("G21 G90\n" + "(no room for it)\n" * 270_000 + "G1 X1 F600\nM2\n")
    subprocess.run([installed, "run", "long.ngc", "--report", "page.html", "--quiet"], cwd=scratch, check=True)
    text = (scratch / "page.html").read_text(encoding="utf-8")
    check(begin not in text and "Keeps every limit" in text, "a program of more than 4 MiB is in the page")
    # Nor where the page is one of another version, that knows other recordings.
    page = beside / "share/leadscrew/program.html"
    page.write_text(page.read_text(encoding="utf-8").replace("leadscrew.recording/1", "leadscrew.recording/0"), encoding="utf-8")
    subprocess.run([installed, "run", "marks.ngc", "--report", "page.html", "--quiet"], cwd=scratch, check=True)
    check("Keeps every limit" in (scratch / "page.html").read_text(encoding="utf-8"), "a page of another version has the recording")


def check_samples(recording, program):
    samples, (header, *rows) = recording["samples"], rows_of("page.csv")
    every, count = samples["words_each"], samples["count"]
    check(count <= 65536 and count == -(-(len(rows) - 1) // every) + 1, f"the page of {program} has {count} samples each {every}")
    taken = numpy.array([rows[min(i * every, len(rows) - 1)] for i in range(count)], dtype=float)
    for name, kind, columns in (("position", "<f8", samples["axes"]), ("feed", "<f8", ["feed"]), ("s", "<f8", ["s"]),
                                ("line", "<i4", ["line"])):
        told = numpy.frombuffer(base64.b64decode(samples[name]), dtype=kind).reshape(count, len(columns))
        check(numpy.array_equal(told, taken[:, [header.index(each) for each in columns]]), f"{program}: {name} is not the trace's")
    for name in ("velocity", "acceleration", "jerk"):
        check((name in samples) == (every > 1), f"{program}: {name} is told though every word is, or is not though it must be")
    distance, tolerance = (numpy.frombuffer(base64.b64decode(samples[name]), dtype="<f4") for name in ("distance", "tolerance"))
    check(len(distance) == len(tolerance) == count and (distance <= tolerance + 2e-6).all(), f"{program}: words leave the tolerance")
    check(distance.max() <= recording["result"]["deviation_mm"] + 2e-6, f"{program}: words are farther than the deviation")
    poses = numpy.frombuffer(base64.b64decode(samples["tip"]), dtype="<f4").reshape(count, 3)
    if "tx" in header:
        check(numpy.allclose(poses, taken[:, [header.index(each) for each in POSES[:3]]], atol=1e-4), f"{program}: another tip")
    blocks = recording["blocks"]
    seconds = numpy.frombuffer(base64.b64decode(blocks["seconds"]), dtype="<f8")
    check(len(seconds) == blocks["count"] and abs(seconds.sum() - recording["result"]["time_s"]) < 1e-6,
          f"{program}: blocks take {seconds.sum()} s of {recording['result']['time_s']}")


def check_traces(schemas):
    run("run", square, "--trace", "words.csv", "--quiet")
    run("run", square, "--trace", "words.npy", "--quiet")
    json_of(schemas, "verify", "verify", "words.csv", square)
    json_of(schemas, "verify", "verify", "words.csv", "good.ngc", status=1)
    check_header("words.csv", columns("trace", "XYZ"))
    check_array(schemas, "words", columns("trace", "XYZ"), square)

    run("simulate", square, "--trace", "slides.csv", "--quiet")
    run("simulate", square, "--trace", "slides.npy", "--quiet")
    check_header("slides.csv", columns("trace", "XYZ", verb="simulate"))
    check_array(schemas, "slides", columns("trace", "XYZ", verb="simulate"), square)

    laser = machines / "laser.toml"
    run("run", "good.ngc", "--machine", laser, "--trace", "laser.csv", "--quiet")
    run("run", "good.ngc", "--machine", laser, "--trace", "laser.npy", "--quiet")
    axes = [axis for axis in AXES if f"[axis.{axis}]" in laser.read_text(encoding="utf-8")]
    check_header("laser.csv", columns("trace", axes, laser=True))
    check_array(schemas, "laser", columns("trace", axes, laser=True), "good.ngc")

    trunnion = machines / "table-table-ac.toml"
    run("run", "tip.ngc", "--machine", trunnion, "--trace", "tip.csv", "--quiet")
    run("run", "tip.ngc", "--machine", trunnion, "--trace", "tip.npy", "--quiet")
    check_header("tip.csv", columns("trace", "XYZAC", poses=True))
    check_array(schemas, "tip", columns("trace", "XYZAC", poses=True), "tip.ngc")
    json_of(schemas, "verify", "verify", "tip.csv", "tip.ngc", "--machine", trunnion)
    json_of(schemas, "simulate", "simulate", "tip.ngc", "--machine", trunnion)

    run("run", "turn.ngc", "--machine", "worn6.toml", "--trace", "turn.npy", "--quiet")
    schemas.fit("trace", json.loads((scratch / "turn.npy.json").read_text()), "turn.npy.json")
    foreign = numpy.zeros(9, dtype=[("t", "<f8"), ("x", "<f8"), ("Y", "<f8")])
    foreign["t"] = numpy.arange(9) * 1e-3
    numpy.save(scratch / "foreign.npy", foreign)
    judged = json_of(schemas, "verify", "verify", "foreign.npy", square, status=1)
    check(judged["feed"]["ripple"] is None, "a foreign trace has a ripple")


def check_array(schemas, stem, expected, program):
    """NPY against the page, against its side file, and against the CSV of the same words."""
    side = json.loads((scratch / f"{stem}.npy.json").read_text(encoding="utf-8"))
    schemas.fit("trace", side, f"{stem}.npy.json")
    told = [(column["name"], column["unit"]) for column in side["columns"]]
    check(told == expected, f"{stem}.npy.json has the columns {told}, docs/formats.md has {expected}")
    check(side["program"] == str(program) and side["trace"] == f"{stem}.npy", f"{stem}.npy.json is of another program")
    with open(scratch / f"{stem}.npy", "rb") as file:
        version = numpy.lib.format.read_magic(file)
        shape, fortran, dtype = numpy.lib.format.read_array_header_1_0(file)
        check((version, fortran, dtype.str, file.tell()) == ((1, 0), False, "<f8", 128), f"{stem}.npy has another layout")
    array = numpy.load(scratch / f"{stem}.npy")
    rows = rows_of(f"{stem}.csv")
    check(array.shape == shape == (len(rows) - 1, len(expected)), f"{stem}.npy has the shape {array.shape}")
    check(numpy.array_equal(array, numpy.array(rows[1:], dtype=float)), f"{stem}.npy and {stem}.csv differ")
    check(numpy.allclose(array[:, 0], numpy.arange(len(array)) * side["period_s"]), f"{stem}.npy has another period")


def check_tables():
    run("run", "good.ngc", "--events", "events.csv", "--blocks", "blocks.csv", "--quiet")
    check_header("events.csv", columns("events", "XYZ"))
    codes = [row[4] for row in rows_of("events.csv")[1:]]
    check(codes == ["S", "M3", "M8", "M62", "M67", "M2"], f"events.csv has the codes {codes}")
    check_header("blocks.csv", columns("blocks", "XYZ"))
    check(rows_of("blocks.csv")[-1][1] == "G0 X0", "blocks.csv ends with another block")
    check_header("steps.csv", columns("steps", "XYZ"))
    signals = {(scope, name) for scope, name in signals_of("steps.vcd")}
    told = {("steps", cells[0].strip("`").replace("{axis}", axis)) for cells in table("signals", "steps") for axis in "XYZ"}
    check(signals == told, f"steps.vcd has the signals {signals}, docs/formats.md has {told}")
    run("pulse", "--arc", "--start", "5,1", "--end", "1,5", "--center", "0,0", "--method", "dda,point-comparison", "--vcd",
        "pulses.vcd", "--quiet")
    signals = signals_of("pulses.vcd")
    check({scope for scope, _ in signals} == {"common", "dda", "point_comparison"}, "pulses.vcd has other scopes")
    for cell, scope, meaning in table("signals", "pulses"):
        for name in re.findall(r"`(\w+)`", cell.split(" and ")[0]) + re.findall(r"`(\w+_\w+)`", meaning):
            for each in ["common"] if scope == "common" else ["dda", "point_comparison"]:
                is_shown = (each, name) in signals or name in "XY"  # only where registers count from elsewhere
                check(is_shown, f"pulses.vcd has no {name} in {each}")
    common = {name for scope, name in signals if scope == "common"}
    for name in common:
        check(f"`{name}`" in page, f"pulses.vcd has {name}, docs/formats.md has not")


def signals_of(file):
    scope, found = None, []
    for line in (scratch / file).read_text(encoding="utf-8").splitlines():
        words = line.split()
        if line.startswith("$scope"):
            scope = words[2]
        elif line.startswith("$var"):
            found.append((scope, words[4]))
    return found


def check_measures(schemas):
    (scratch / "ball.tbl").write_text("T1 D10 R5\n")
    (scratch / "patch.ngc").write_text("G21 G90 T1 M6\nG6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX8\nX0 Y6\nX8\n"
                                       "G6.5 D1 H0.05 L1 Z2 F6000\nG0 X20\nM2\n")
    (scratch / "cuts.ngc").write_text((scratch / "patch.ngc").read_text().replace("G0 X20", "G0 Z2 X4 Y3\nG1 Z-0.1\nG0 Z2"))
    measure = ["--tools", "ball.tbl", "--start", "Z5"]
    for name in ("patch", "cuts"):
        run("run", f"{name}.ngc", *measure, "--trace", f"{name}.csv", "--quiet")
    few = [*measure, "--places", "5000", "--map", "map.csv", "--picture", "map.svg"]
    json_of(schemas, "measure", "measure", "cuts.csv", "cuts.ngc", *few, status=1)
    found = json_of(schemas, "measure", "measure", "patch.csv", "patch.ngc", *few)
    check(0.045 < found["surfaces"][0]["ridge"]["mm"] < 0.0501, f"ridges of 0.05 mm are {found['surfaces'][0]['ridge']}")
    check_header("map.csv", columns("map", "XYZ"))
    places = found["surfaces"][0]["columns"] * found["surfaces"][0]["rows"]
    check(len(rows_of("map.csv")) == places + 1, "map.csv has another number of places")
    json_of(schemas, "rejected", "measure", "patch.csv", square, status=3)


def sweep_of_another_build(words):
    other = scratch / "other"
    other.write_bytes(command.read_bytes() + b"other")
    other.chmod(0o755)
    subprocess.run([other, *map(str, words), "--quiet"], cwd=scratch, check=True)


def check_sweeps(schemas):
    words = ["sweep", "--programs", square, "bad.ngc", "none.ngc", "--tolerance", "0.001,0.01", "--out", "swept"]
    sweep_of_another_build(words)
    swept = json_of(schemas, "sweep", *words)
    check(swept.get("rows") == 6 and swept.get("kept") == 2, f"a sweep of three programs has told {swept}")
    check(swept.get("other_builds", [{}])[0].get("rows") == 6, f"a sweep of another build has told {swept}")
    bought = json_of(schemas, "sweep", "sweep", "--programs", square, "--optimise", "--out", "bought")
    best = bought["sensitivities"][0]
    check(best["limit"] == "jerk X" or best["limit"] == "jerk Y", f"the limit to buy for a square is {best}")
    told = {cell.strip("`") for cell, _, _ in table("sweep", "results")}
    found = {key for line in (scratch / "swept/results.jsonl").read_text(encoding="utf-8").splitlines() for key in json.loads(line)}
    check(told == found | {"first_violation", "changed", "factor"}, f"rows of a sweep and docs/formats.md differ in {told ^ found}")
    array = numpy.load(scratch / "swept/results.npy")
    check(list(array.dtype.names) == rows_of("swept/results.csv")[0], "results.npy and results.csv have other columns")
    check(len(array) == 6 and array["status"][0] == b"kept", f"results.npy holds {array}")


def check_simulations(schemas):
    json_of(schemas, "simulate", "simulate", square)
    json_of(schemas, "simulate", "simulate", "turn.ngc", "--machine", "worn6.toml")
    json_of(schemas, "simulate", "simulate", "curve:circle", "--pulses")
    json_of(schemas, "simulate", "simulate", square, "--adaptive", "--sensor-fault", "nan@0.5")


def check_drives(schemas):
    json_of(schemas, "drive", "drive", "turn.ngc", "--machine", "worn6.toml")
    json_of(schemas, "drive", "drive", "fast.ngc", "--state", "fast.state", "--trace", "taken.npy", "--axes", "went.csv")
    schemas.fit("state", json.loads((scratch / "fast.state").read_text(encoding="utf-8")), "the state of a drive")
    schemas.fit("trace", json.loads((scratch / "taken.npy.json").read_text(encoding="utf-8")), "taken.npy.json")
    trunnion = ["--machine", machines / "table-table-ac.toml"]
    json_of(schemas, "drive", "drive", "tip.ngc", *trunnion, "--state", "tip.state", "--trace", "driven.csv", "--axes", "tip-went.csv")
    state = json.loads((scratch / "tip.state").read_text(encoding="utf-8"))
    schemas.fit("state", state, "the state of five axes")
    check("tool" in state, "the state of five axes has no tool")
    check_header("driven.csv", columns("trace", "XYZAC", poses=True))
    check_header("tip-went.csv", columns("trace", "XYZAC"))
    check_header("went.csv", columns("trace", "XYZ"))
    # Its last word is of a subprogram in a file of its own.
    (scratch / "called.ngc").write_text("o<called> sub\nG1 X#1 F6000\nM2\no<called> endsub\n", encoding="utf-8")
    (scratch / "calls.ngc").write_text("G1 X0.5 F6000\no<called> call [1]\n", encoding="utf-8")
    json_of(schemas, "drive", "drive", "calls.ngc", "--state", "calls.state")
    schemas.fit("state", json.loads((scratch / "calls.state").read_text(encoding="utf-8")), "the state in a subprogram")
    (scratch / "half.ngc").write_text("G1 X0.5 F6000\no<called> call [0.6]\n", encoding="utf-8")
    run("run", "half.ngc", "--trace", "half.csv", "--quiet")
    json_of(schemas, "verify", "verify", "half.csv", "calls.ngc", status=1)
    json_of(schemas, "drive", "drive", "fast.ngc", "--sink", "sink.csv")
    json_of(schemas, "drive", "drive", "thread.ngc", "--machine", "spindle.toml")
    check_header("sink.csv", columns("trace", "XYZ"))


def check_live(schemas):
    """With the page beside the command, as it is installed."""
    bin, web = scratch / "served/bin", scratch / "served/share/leadscrew/web"
    bin.mkdir(parents=True)
    web.mkdir(parents=True)
    shutil.copy(command, bin / "leadscrew")
    shutil.copy(command.parent / "leadscrew-serve.so", bin)
    (web / "index.html").write_text("<html></html>")
    drive = subprocess.Popen([bin / "leadscrew", "drive", "tip.ngc", "--machine", machines / "table-table-ac.toml", "--serve", "0"],
                             cwd=scratch, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    address = re.search(r"http://127.0.0.1:\d+/", drive.stderr.readline())[0]
    name, count = "", 0
    for line in urllib.request.urlopen(address + "live"):
        key, _, value = line.decode().strip().partition(": ")
        name = value if key == "event" else name
        if key == "data" and name in ("machine", "sample"):
            schemas.fit(f"live-{name}", json.loads(value), f"the event {name}")
            count += 1
    check(count > 2, f"drive --serve has told {count} events")
    drive.communicate()
    statuses.add(drive.returncode)


def check_pulses(schemas):
    arc = ["pulse", "--arc", "--start", "5,0", "--end", "0,5", "--center", "0,0", "--ccw"]
    json_of(schemas, "pulse", *arc, "--path")
    json_of(schemas, "pulse", *arc, "--method", "dda", "--bits", "4", "--order", "x-first", "--preload", "zero")
    json_of(schemas, "pulse", *arc, "--free", "--preload", "minus-one", "--method", "koren")
    json_of(schemas, "pulse", *arc, "--places", "6", "--method", "dda")
    json_of(schemas, "pulse", "pulse", "--ellipse", "12,7", "--start", "12,0", "--end", "0,-7", "--cw", "--path")
    json_of(schemas, "pulse", "pulse", "--line", "--end", "11,-7", "--path")
    json_of(schemas, "pulse", "pulse", "--arc", "--start", "5,0", "--end", "0,9", "--center", "0,0", status=3)


def check_designs(schemas):
    sizes = ["design", "--travel", "600", "--blu", "0.01", "--max-feed", "12000", "--min-distance", "50"]
    json_of(schemas, "design-integrators", *sizes)
    json_of(schemas, "design-integrators", *sizes, "--from", "20,10", "--to", "120,60", "--feed", "3000")
    json_of(schemas, "design-timer", "design", "--timer", "--clock", "1024", "--delays", "2,4,8")
    inverse = ["design", "--inverse-time", "--travel", "12", "--blu", "0.0001", "--max-feed", "30"]
    json_of(schemas, "design-inverse-time", *inverse)
    json_of(schemas, "design-inverse-time", *inverse, "--distance", "2", "--feed", "10")
    json_of(schemas, "design-inverse-time", *inverse, "--radius", "2", "--feed", "10")
    json_of(schemas, "design-rejected", "design", "--timer", "--clock", "1024", "--delays", "-2", status=3)


def check_surfaces(schemas):
    """With a reading program of the tests beside the command; tests/exchange has the real one."""
    if not (command.parent / "leadscrew-exchange").exists():
        run("surfaces", "part.step", "--json", status=2)
    bin = scratch / "bin"
    bin.mkdir()
    shutil.copy(command, bin / "leadscrew")
    faces = [{"number": 1, "type": "plane", "reversed": True, "deviation": 1e-4, "area": 12.0, "low": [0, 0, 0], "high": [4, 3, 0],
              "degree": [1, 1], "points": [2, 2], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]],
              "net": [0, 0, 0, 1, 4, 0, 0, 1, 0, 3, 0, 1, 4, 3, 0, 1]},
             {"number": 2, "type": "plane", "reversed": False, "deviation": None, "area": None, "low": [0, 0, 0],
              "high": [0, 0, 0], "refusal": {"code": "face-trimmed", "why": "is trimmed", "hint": ""}}]
    lines = [{"format": "STEP", "unit": "mm"}, *({"face": face} for face in faces), {"end": True}]
    (bin / "leadscrew-exchange").write_text("#!/bin/sh\ncat <<'E'\n" + "\n".join(map(json.dumps, lines)) + "\nE\n")
    (bin / "leadscrew-exchange").chmod(0o755)
    (scratch / "part.step").write_text("ISO-10303-21;\n")
    for words, status in ([], 0), (["--all", "--output", "faces.ngc"], 0), (["--face", "2", "--output", "none.ngc"], 3):
        done = subprocess.run([bin / "leadscrew", "surfaces", "part.step", "--json", *words], cwd=scratch, capture_output=True,
                              text=True)
        check(done.returncode == status, f"surfaces {words} ended with {done.returncode}: {done.stderr}")
        schemas.fit("surfaces", json.loads(done.stdout), "the output of surfaces")


def check_studies(schemas):
    listed = json_of(schemas, "study-list", "study", "list")
    for study in listed["studies"]:
        if study["name"] not in SLOW_STUDIES:
            json_of(schemas, "study", "study", study["name"])


# What is read

EXAMPLES = {
    "name": '"mill"', "travel_mm": "[-500, 500]", "max_velocity_mm_s": "200",
    "max_acceleration_mm_s2": "1000", "max_jerk_mm_s3": "20000", "blu_mm": "0.001",
    "pitch_errors_mm": "[[-500, 0.02], [500, 0]]", "pitch_errors_backward_mm": "[[-500, 0.02], [500, 0]]",
    "backlash_takeup_mm_s": "20", "position_gain_per_s": "40", "velocity_gain_per_s": "200",
    "proportional_per_mm": "1.25", "command_limit": "24", "breakaway_mm_s2": "1",
    "encoder_counts_per_mm": "1000", "plane_mm": "{}",
    "box_mm": "[[0, 0, -20, 60, 40, 0]]", "pocket_mm": "[[10, 10, -5, 30, 30, 1]]", "sphere_mm": "[[0, 0, -20, 12]]",
    "surface": '"face.ngc"', "surface_at_mm": "[0, 0, -20]",
    "cylinder_mm": "[[0, 0, -20, 0, 0, 0, 12]]", "bore_mm": "[[50, 20, -10, 50, 20, 1, 5]]"}


def machine_text(rows, without=None, rotary=False):
    text, last = "", ""
    for place, key, default, _ in rows:
        if (place, key) == without:
            continue
        if place != last:
            text += place.strip("`").replace("X", "A" if rotary else "X") + "\n"
            last = place
        key = key.strip("`")
        literal = default.strip("`")
        value = EXAMPLES.get(key) or (literal if re.fullmatch(r'[\d.]+|".*"|true|false', literal) else None)
        check(value is not None, f"there is no example of the machine file's {key}")
        text += f"{key.replace('_mm', '_deg') if rotary and 'axis' in place else key} = {value}\n"
    return text


def check_machine_files():
    rows = table("keys", "machine")
    (scratch / "face.ngc").write_text("G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX60\nX0 Y40\nX60 Z1\n")
    (scratch / "all.toml").write_text(machine_text(rows))
    run("check", "fast.ngc", "--machine", "all.toml", "--quiet")
    (scratch / "still.ngc").write_text("G21\nM2\n")
    (scratch / "rotary.toml").write_text(machine_text(rows, rotary=True))
    run("check", "still.ngc", "--machine", "rotary.toml", "--quiet")
    for place, key, default, _ in rows:
        if default != "needed":
            continue
        (scratch / "less.toml").write_text(machine_text(rows, without=(place, key)))
        run("check", "fast.ngc", "--machine", "less.toml", "--quiet", status=3)
    # Machines of five axes: one file has every key.
    chain = table("keys", "chain")
    five_axes = (machines / "table-table-ac.toml").read_text(encoding="utf-8")
    for _, key, _, _ in chain:
        check(re.search(rf"^{key.strip('`')} = ", five_axes, re.M), f"machines/table-table-ac.toml lacks {key}")
    run("check", "still.ngc", "--machine", machines / "table-table-ac.toml", "--quiet")
    keys = (source / "src/leadscrew/config/machine_keys.hpp").read_text(encoding="utf-8")
    others = {"axis", "drive", "laser", "probe", "spindle", "splines", "kinematics_geometry"}
    known = set(re.findall(r'"([a-z_0-9]+)"', keys)) - others
    told = {key.strip("`") for _, key, _, _ in rows + chain}
    told |= {key.replace("_mm", "_deg") for key in told} & known
    check(told == known, f"machine files: {sorted(told ^ known)} stands in docs/formats.md or in machine_keys.hpp alone")


def check_tool_tables():
    letters = []
    for cell, _ in table("letters", "tools"):
        letters += AXES if "{axis}" in cell else [cell.strip("`")]
    (scratch / "tools.tbl").write_text(" ".join(f"{letter}{'1 2'[2 * (letter in 'DL')]}" for letter in letters) + " ;all of it\n")
    run("check", "fast.ngc", "--tools", "tools.tbl", "--quiet")
    for letter in set("ABCDEFGHIJKLMNOPQRSTUVWXYZ") - set(letters):
        (scratch / "tools.tbl").write_text(f"T1 {letter}1\n")
        run("check", "fast.ngc", "--tools", "tools.tbl", "--quiet", status=3)


def check_statuses():
    run("run", status=2)
    told = {int(row[0]) for row in re.findall(r"^\| (\d+) \| (.*) \|$", page[page.index("## Exit status"):page.index("## JSON")], re.M)}
    check(told == statuses | {130}, f"exit statuses are {sorted(statuses)} and 130, docs/formats.md has {sorted(told)}")


def main():
    prepare()
    schemas = Schemas(source / "docs/schemas")
    check_runs(schemas)
    check_recordings(schemas)
    check_traces(schemas)
    check_tables()
    check_measures(schemas)
    check_sweeps(schemas)
    check_simulations(schemas)
    check_drives(schemas)
    check_live(schemas)
    check_pulses(schemas)
    check_designs(schemas)
    check_surfaces(schemas)
    check_studies(schemas)
    check_machine_files()
    check_tool_tables()
    check_statuses()
    schemas.conclude()
    formats = subprocess.run([source / "script/formats", "--check"], capture_output=True, text=True)
    check(formats.returncode == 0, formats.stderr)
    sys.exit("\n".join(problems) or 0)


main()
