"""Puts the pages of the site together, and judges what has been made of them.

    pages.py COMMAND XML PAGES    docs/ as it is, and beside it a page for each command, each public header, machines, schemas
    pages.py --mend SITE          what Debian's Furo lacks to be read from a disk, and in the dark
    pages.py --judge SITE         no link of the site leads nowhere, and no page loads anything from elsewhere
"""
import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

import reference

root = pathlib.Path(__file__).resolve().parents[2]


def escaped(text):
    return re.sub(r"([\\`*_\[\]<>#|~{}$])", r"\\\1", text)


def page_of_help(name, text):
    """A page of a command's --help: options as a list of definitions, examples as they are, the rest as paragraphs."""
    lines, parts = text.splitlines(), [f"# leadscrew {name}".rstrip(), ""]
    parts += [escaped(lines[0]), "", "```none", lines[1].removeprefix("Usage: "), "```", ""]
    section, block = "", []
    for paragraph in re.split(r"\n{2,}", "\n".join(lines[2:]).strip("\n")):
        head, _, rest = paragraph.partition("\n")
        if head in ("Options:", "Positionals:", "Subcommands:"):
            parts += [f"## {head[:-1]}", ""]
            for line in rest.splitlines():
                found = re.match(r"  (\S.*?)(?:\s{2,}(.*))?$", line)
                term = found[1].strip()
                link = f"[`{term}`]({term}.md)" if head == "Subcommands:" else f"`{term}`"
                parts += [link, f": {escaped(found[2] or '')}", ""]
        elif head.endswith(":") and rest.startswith("  "):
            parts += [f"## {head[:-1]}", "", "```none", *(line[2:] for line in rest.splitlines()), "```", ""]
        elif any(line.startswith("  ") or "   " in line for line in paragraph.splitlines()):
            parts += ["```none", paragraph, "```", ""]
        else:
            parts += [escaped(paragraph), ""]
    return "\n".join(parts)


def write_commands(command, folder):
    folder.mkdir()
    overview = subprocess.run([command, "help"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"^  ([a-z]+) {2,}\S", overview.partition("Subcommands:")[2].partition("Examples:")[0], re.MULTILINE)
    for name in names:
        text = subprocess.run([command, "help", name], capture_output=True, text=True, check=True).stdout
        (folder / f"{name}.md").write_text(page_of_help(name, text), encoding="utf-8")
    contents = ["", "```{toctree}", ":hidden:", *names, "```", ""]
    (folder / "index.md").write_text(page_of_help("", overview).replace("# leadscrew\n", "# The command\n", 1) + "\n".join(contents),
                                     encoding="utf-8")


def write_machines(path):
    parts = ["# Machine files that come along", "", "[What each key means](formats.md#machine-files).", ""]
    for file in sorted((root / "machines").glob("*.toml")):
        parts += [f"## {file.stem}", "", "```toml", file.read_text(encoding="utf-8").rstrip(), "```", ""]
    path.write_text("\n".join(parts), encoding="utf-8")


def write_schemas(path):
    parts = ["# Schemas of JSON", "", "JSON Schema of what the command prints; [in words](formats.md#json).", ""]
    parts += [f"- [{file.name}](schemas/{file.name})" for file in sorted((root / "docs/schemas").glob("*.json"))]
    path.write_text("\n".join(parts) + "\n", encoding="utf-8")


def moved(text, folder):
    """Of a page from another folder: its links as seen from docs/."""
    return re.sub(r"\]\((?!https?:|#)", f"](../{folder}/", text)


def of_the_site(text):
    """Links to what is no page of its own, to the page that shows it; one heading of the first level."""
    first, *others = re.split(r"^(?=# |```)", text, flags=re.MULTILINE)
    is_code, seen, parts = False, False, [first]
    for part in others:
        if part.startswith("```"):
            is_code = not is_code
        elif not is_code:
            part = "#" * seen + part
            seen = True
        parts.append(part)
    return re.sub(r"\]\(((?:\.\./)*)(examples/host/README\.md|machines|schemas)\)",
                  lambda found: f"]({found[1].removeprefix('../')}{pages_of[found[2]]})", "".join(parts))


pages_of = {"examples/host/README.md": "examples-host.md", "machines": "machines.md", "schemas": "schemas-all.md"}


def assemble(command, xml, pages):
    """docs/ with the folders beside it that it links to; pages are in PAGES/docs."""
    shutil.rmtree(pages, ignore_errors=True)
    docs = pages / "docs"
    shutil.copytree(root / "docs", docs, ignore=shutil.ignore_patterns("__pycache__"))
    for folder in ("examples", "src", "include", "bench", "hdl", "machines", "embedded", "integrations", "python", "script"):
        (pages / folder).symlink_to(root / folder)
    shutil.copy(root / "LICENSE", pages)
    for path in docs.rglob("*.md"):
        path.write_text(of_the_site(path.read_text(encoding="utf-8")), encoding="utf-8")
    text = (root / "examples/host/README.md").read_text(encoding="utf-8")
    (docs / "examples-host.md").write_text(moved(text, "examples/host"), encoding="utf-8")
    library = docs / "library.md"
    headers = "|".join(path.stem for path in (root / "include/leadscrew").glob("*.hpp"))
    library.write_text(re.sub(rf"^\| (`leadscrew/({headers})\.hpp`)", r"| [\1](api/\2-hpp.md)", library.read_text(encoding="utf-8"),
                              flags=re.MULTILINE), encoding="utf-8")
    write_machines(docs / "machines.md")
    write_schemas(docs / "schemas-all.md")
    write_commands(command, docs / "command")
    reference.write(xml, root / "include/leadscrew", docs / "api")
    # Pages that the table of contents does not name stand at its end.
    index = docs / "index.md"
    text = index.read_text(encoding="utf-8")
    further = [path.stem for path in sorted(docs.glob("*.md"))
               if path != index and not re.search(rf"^(.* <)?{path.stem}>?$", text, re.MULTILINE)]
    index.write_text(text.replace("\narchitecture\n", "\narchitecture\n" + "".join(name + "\n" for name in further)), encoding="utf-8")


def mend(site):
    """Debian 12 gives Furo as it is before it is bundled: a script that imports another, which no browser does from a disk; a
    style sheet at an address of the server; and dark colours only for who has chosen them, not for a dark desktop."""
    scripts, style = site / "_static/scripts", site / "_static/styles/furo.css"
    script = (scripts / "furo.js").read_text(encoding="utf-8")
    bundled = (scripts / "gumshoe-patched.js").read_text(encoding="utf-8") + re.sub(r"^import .*$", "", script, flags=re.MULTILINE)
    (scripts / "furo.js").write_text(bundled, encoding="utf-8")
    text = style.read_text(encoding="utf-8")
    normalised = pathlib.Path("/usr/share/javascript/normalize.css/normalize.min.css").read_text(encoding="utf-8")
    text = re.sub(r"^@import url\(/[^)]*\);", lambda _: normalised, text)
    if "prefers-color-scheme" not in text:
        dark = re.search(r'body\[data-theme="dark"\] (\{[^}]*\})', text)[1]
        text += f'\n@media screen and (prefers-color-scheme: dark) {{ body:not([data-theme="light"]) {dark} }}\n'
    style.write_text(text, encoding="utf-8")


class Links(html.parser.HTMLParser):
    """What a page links to, loads, and can be linked at."""

    def __init__(self):
        super().__init__()
        self.links, self.loads, self.places = [], [], set()

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places.update(values[key] for key in ("id", "name") if values.get(key))
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        elif tag in ("script", "img", "iframe", "source", "object") or tag == "link" and values.get("rel") not in ("canonical", "license"):
            self.loads += [values[key] for key in ("src", "href", "data") if values.get(key)]


def judge(site):
    site = site.resolve()
    pages = {}
    for path in site.rglob("*.html"):
        pages[path] = Links()
        pages[path].feed(path.read_text(encoding="utf-8"))
    problems = []
    for path, page in pages.items():
        where = path.relative_to(site)
        for link in page.links + page.loads:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("http", "https") or link.startswith("//"):
                if link in page.loads:
                    problems.append(f"{where} loads {link}")
                continue
            if parts.scheme:
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file() or site not in target.parents:
                problems.append(f"{where} links to {link}, which is not there")
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].places:
                problems.append(f"{where} links to {link}, which has no such place")
    for path in [*site.rglob("*.css"), *site.rglob("*.js")]:
        text = path.read_text(encoding="utf-8", errors="replace")
        for found in re.findall(r"""(?:url\(|@import\s*|importScripts\(|import\s+|fetch\()\s*["']?((?:https?:)?/[^"')\s]+)""", text):
            problems.append(f"{path.relative_to(site)} loads {found}")
    print("\n".join(problems) or f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links")
    return 1 if problems or len(pages) < 50 else 0


if sys.argv[1] == "--mend":
    mend(pathlib.Path(sys.argv[2]))
elif sys.argv[1] == "--judge":
    sys.exit(judge(pathlib.Path(sys.argv[2])))
else:
    assemble(sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]))
