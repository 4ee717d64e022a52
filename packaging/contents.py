#!/usr/bin/python3
"""What the packages are made of, besides Leadscrew itself: headers that are compiled in, libraries for WebAssembly, and packages
of npm that a page is bundled from; with their versions and licences.

    contents.py copyright PACKAGE FILE      the file that Debian has of each package, with the text of every licence in it
    contents.py sbom FOLDER                 a bill of materials of the packages in FOLDER, SPDX 2.3 as JSON, on standard output
    contents.py check FILE FOLDER           says what is wrong with a bill of materials of the packages in FOLDER
"""
import base64
import datetime
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import uuid

source = pathlib.Path(__file__).resolve().parent.parent
web = source / "web"

# Debian's packages whose code is compiled into what a package holds. Shared libraries are none of them: they are depended upon.
compiled_in = {
    "leadscrew": ["libexpected-dev", "libfast-float-dev", "libcli11-dev", "libfmt-dev", "nlohmann-json3-dev"],
    "libleadscrew": ["libexpected-dev", "libfast-float-dev", "libfmt-dev"],
    "libleadscrew-dev": ["libexpected-dev", "libfast-float-dev", "libfmt-dev"],
    "leadscrew-web": ["libexpected-dev", "libfast-float-dev", "libfmt-dev", "libcpp-httplib-dev", "nlohmann-json3-dev", "wasi-libc",
                      "libc++-19-dev-wasm32", "libclang-rt-19-dev-wasm32"],
    "leadscrew-mpi": ["libexpected-dev", "libfmt-dev"],
    "leadscrew-exchange": ["libexpected-dev", "libfast-float-dev", "nlohmann-json3-dev"],
    "python3-leadscrew": ["libexpected-dev", "libfast-float-dev", "libfmt-dev", "pybind11-dev"],
}
# As SPDX writes them; the full texts are in Debian's own copyright files.
licences = {
    "libexpected-dev": "CC0-1.0",
    "libfast-float-dev": "MIT OR Apache-2.0",
    "libcli11-dev": "BSD-3-Clause",
    "libfmt-dev": "MIT",
    "nlohmann-json3-dev": "MIT",
    "libcpp-httplib-dev": "MIT",
    "wasi-libc": "CC0-1.0 AND BSD-2-Clause AND MIT",
    "libc++-19-dev-wasm32": "Apache-2.0 WITH LLVM-exception",
    "libclang-rt-19-dev-wasm32": "Apache-2.0 WITH LLVM-exception",
    "pybind11-dev": "BSD-3-Clause",
}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def without_interface(package):
    """libleadscrew0.1 as libleadscrew: the name of a library's package has the version of its interface."""
    return re.sub(r"^(libleadscrew)\d[\d.]*$", r"\1", package)


def compiled_into(package):
    """Names of Debian's packages that are compiled into one of ours, and that are installed here."""
    names = compiled_in[without_interface(package)]
    known = output("dpkg-query", "--show", "--showformat=${db:Status-Status} ${Package}\n").splitlines()
    return [name for name in names if f"installed {name}" in known]


def npm_packages():
    """The packages that web/src imports and those that these need, as package-lock.json has them: name -> entry."""
    lock = json.loads((web / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    text = "\n".join(path.read_text(encoding="utf-8") for path in sorted((web / "src").rglob("*.ts")))
    imported = re.findall(r"""(?:from|import)\s*\(?\s*["']((?:@[\w.-]+/)?[\w.-]+)[^"':]*["']""", text)
    wanted = [name for name in dict.fromkeys(imported) if f"node_modules/{name}" in lock]
    found = {}
    while wanted:
        name = wanted.pop()
        if name not in found:
            found[name] = lock[f"node_modules/{name}"]
            wanted += found[name].get("dependencies", {})
    return dict(sorted(found.items()))


def copyright(package):
    """Our licence, and that of everything that the package holds code of."""
    parts = ["Leadscrew\n\n" + (source / "LICENSE").read_text(encoding="utf-8")]
    for name in compiled_into(package):
        text = pathlib.Path(f"/usr/share/doc/{name}/copyright").read_text(encoding="utf-8")
        parts.append(f"Code of Debian's package {name} is compiled in. Its own copyright file:\n\n{text}")
    if package == "leadscrew-web":
        for name, entry in npm_packages().items():
            text = "".join(path.read_text(encoding="utf-8") for path in sorted((web / "node_modules" / name).glob("LICEN[CS]E*")))
            assert text, f"{name} comes without its licence"
            parts.append(f"The pages hold code of {name} {entry['version']} ({entry['license']}):\n\n{text}")
    return ("\n" + "-" * 80 + "\n\n").join(part.rstrip() + "\n" for part in parts)


def identifier(*names):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", "-".join(names))


def part(names, name, version, licence, locator=None, checksum=None, purpose=None):
    entry = {"SPDXID": identifier(*names), "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
             "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION"}
    if locator:
        entry["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": locator}]
    if checksum:
        entry["checksums"] = [dict(zip(("algorithm", "checksumValue"), checksum))]
    if purpose:
        entry["primaryPackagePurpose"] = purpose
    return entry


def debian_part(name):
    """A package of Debian's, at the version that is installed here."""
    version, architecture = output("dpkg-query", "--show", "--showformat=${Version} ${Architecture}\n", name).splitlines()[0].split()
    return part(("debian", name), name, version, licences.get(name, "NOASSERTION"),
                f"pkg:deb/debian/{name}@{version.replace(':', '%3A').replace('+', '%2B')}?arch={architecture}&distro=bookworm")


def npm_part(name, entry):
    algorithm, _, digest = entry["integrity"].partition("-")
    locator = f"pkg:npm/{name.replace('@', '%40')}@{entry['version']}"
    return part(("npm", name), name, entry["version"], entry["license"], locator,
                (algorithm.upper(), base64.b64decode(digest).hex()))


def dependencies(package_file):
    """Names of all that a package depends on; of alternatives, the first."""
    fields = output("dpkg-deb", "--field", str(package_file), "Depends")
    return [re.split(r"[ (|:]", each.strip())[0] for each in fields.split(",") if each.strip()]


def sbom(folder):
    version = re.search(r"VERSION (\d+\.\d+\.\d+)", (source / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    root = part(("leadscrew",), "leadscrew", version, "MIT", purpose="SOURCE")
    parts, relations = {root["SPDXID"]: root}, {("SPDXRef-DOCUMENT", "DESCRIBES", root["SPDXID"])}
    def relate(one, kind, other):
        parts[other["SPDXID"]] = other
        relations.add((one["SPDXID"], kind, other["SPDXID"]))
    files = sorted(pathlib.Path(folder).glob("*.deb"))
    ours = {output("dpkg-deb", "--field", str(file), "Package"): file for file in files}
    made = {name: part(("package", name), name, output("dpkg-deb", "--field", str(file), "Version"), "MIT",
                       checksum=("SHA256", hashlib.sha256(file.read_bytes()).hexdigest()), purpose="INSTALL")
            for name, file in ours.items()}
    for name, file in ours.items():
        relate(made[name], "GENERATED_FROM", root)
        parts[made[name]["SPDXID"]] = made[name]
        for needed in dependencies(file):
            relate(made[name], "DEPENDS_ON", made[needed] if needed in made else debian_part(needed))
        for inner in compiled_into(name):
            relate(made[name], "CONTAINS", debian_part(inner))
        if name == "leadscrew-web":
            for inner, entry in npm_packages().items():
                relate(made[name], "CONTAINS", npm_part(inner, entry))
    seconds = int(os.environ.get("SOURCE_DATE_EPOCH") or output("git", "-C", str(source), "log", "-1", "--format=%ct"))
    created = datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    contents = "".join(entry["checksums"][0]["checksumValue"] for entry in made.values())
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"leadscrew-{version}",
            "documentNamespace": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_OID, contents)}",
            "creationInfo": {"created": created, "creators": ["Organization: Leadscrew authors", "Tool: packaging/contents.py"]},
            "packages": [parts[key] for key in sorted(parts)],
            "relationships": [dict(zip(("spdxElementId", "relationshipType", "relatedSpdxElement"), each)) for each in sorted(relations)]}


def problems(bill, folder):
    """What is wrong with a bill of materials: what SPDX 2.3 asks of it, and that it has every package with its checksum."""
    required = {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT"}
    found = [f"{key} is {bill.get(key)}, not {value}" for key, value in required.items() if bill.get(key) != value]
    found += [f"{key} is missing" for key in ("name", "documentNamespace", "creationInfo") if not bill.get(key)]
    if not re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", bill.get("creationInfo", {}).get("created", "")):
        found.append("creationInfo.created is no time")
    known = ["SPDXRef-DOCUMENT"] + [entry.get("SPDXID", "") for entry in bill.get("packages", [])]
    found += [f"{name} stands twice" for name in set(known) if known.count(name) > 1]
    for entry in bill.get("packages", []):
        if not re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", entry.get("SPDXID", "")):
            found.append(f"{entry.get('SPDXID')} is no identifier")
        for key in ("name", "versionInfo", "downloadLocation", "licenseConcluded", "licenseDeclared", "copyrightText"):
            if not entry.get(key):
                found.append(f"{entry.get('SPDXID')} has no {key}")
    kinds = {"DESCRIBES", "GENERATED_FROM", "DEPENDS_ON", "CONTAINS"}
    for each in bill.get("relationships", []):
        if each["relationshipType"] not in kinds or not {each["spdxElementId"], each["relatedSpdxElement"]} <= set(known):
            found.append(f"{each} leads nowhere")
    sums = {check["checksumValue"] for entry in bill.get("packages", []) for check in entry.get("checksums", [])}
    files = sorted(pathlib.Path(folder).glob("*.deb"))
    found += [f"{file.name} is not in it" for file in files if hashlib.sha256(file.read_bytes()).hexdigest() not in sums]
    return found if files else [*found, f"{folder} has no packages"]


def main():
    if len(sys.argv) == 4 and sys.argv[1] == "copyright":
        pathlib.Path(sys.argv[3]).write_text(copyright(sys.argv[2]), encoding="utf-8")
    elif len(sys.argv) == 3 and sys.argv[1] == "sbom":
        print(json.dumps(sbom(sys.argv[2]), indent=1))
    elif len(sys.argv) == 4 and sys.argv[1] == "check":
        found = problems(json.loads(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")), sys.argv[3])
        sys.exit("\n".join(found) or None)
    else:
        sys.exit(__doc__)


main()
