#!/usr/bin/python3
"""packages.py SOURCE BUILD SCRATCH: what the packages say of themselves, without making them.

The changelog's last entry is of the project's version; each package has its licences told; and a bill of materials is found
wrong when it lacks a package, is of another, or names what it does not have.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

source, build, scratch = map(pathlib.Path, sys.argv[1:])
contents = source / "packaging" / "contents.py"
failures = []


def expect(condition, message):
    if not condition:
        failures.append(message)


def run(*command):
    return subprocess.run([str(each) for each in command], capture_output=True, text=True)


def package(folder, depends):
    """A package with nothing in it."""
    control = scratch / "package" / "DEBIAN" / "control"
    control.parent.mkdir(parents=True, exist_ok=True)
    control.write_text(f"Package: libleadscrew0.1\nVersion: 0.1.0\nArchitecture: all\nMaintainer: nobody <nobody@leadscrew.invalid>\n"
                       f"Depends: {depends}\nDescription: {folder.name}\n", encoding="utf-8")
    folder.mkdir()
    made = run("dpkg-deb", "--build", scratch / "package", folder)
    expect(made.returncode == 0, made.stderr)


def objections(bill, folder):
    path = scratch / "bill.json"
    path.write_text(json.dumps(bill), encoding="utf-8")
    checked = run(contents, "check", path, folder)
    return checked.stderr if checked.returncode else ""


shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)

version = re.search(r"^project\(leadscrew VERSION ([\d.]+)", (source / "CMakeLists.txt").read_text(encoding="utf-8"), re.MULTILINE)[1]
entry = (source / "packaging" / "changelog.in").read_text(encoding="utf-8").splitlines()[0]
expect(entry.startswith(f"leadscrew ({version}) "), f"the changelog begins with '{entry}', not with version {version}")

names = re.findall(r'set\(CPACK_DEBIAN_\w+_PACKAGE_NAME "([^"]+)"\)', (build / "CPackConfig.cmake").read_text(encoding="utf-8"))
expect({"leadscrew", "libleadscrew-dev"} <= set(names), f"packages are {names}")
for name in names:
    told = run(contents, "copyright", name, scratch / "copyright")
    text = (scratch / "copyright").read_text(encoding="utf-8") if told.returncode == 0 else told.stderr
    expect("The Leadscrew authors" in text and "Debian's package libexpected-dev" in text, f"licences of {name}: {text[-500:]}")

package(scratch / "one", "libc6 (>= 2.36)")
package(scratch / "other", "libc6")
told = run(contents, "sbom", scratch / "one")
expect(told.returncode == 0, told.stderr)
bill = json.loads(told.stdout)
expect(objections(bill, scratch / "one") == "", objections(bill, scratch / "one"))
found = {each["name"]: each for each in bill["packages"]}
expect("pkg:deb/debian/libc6@" in json.dumps(found["libc6"]), "libc6 is depended upon, and is not in the bill")
expect("is not in it" in objections(bill, scratch / "other"), "a bill of another package is accepted")
expect("leads nowhere" in objections({**bill, "packages": [each for each in bill["packages"] if each["name"] != "libc6"]},
                                     scratch / "one"), "a bill without what it names is accepted")
expect("dataLicense" in objections({**bill, "dataLicense": "MIT"}, scratch / "one"), "a bill under another licence is accepted")
sys.exit("\n".join(failures) or None)
