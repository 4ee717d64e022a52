"""Each command that a page of documentation shows works as it stands, one after the other, and prints what the page shows.

    shown_commands.py PAGE SCRATCH LEAST LINK=TARGET…     runs them in SCRATCH, where each LINK leads to its TARGET
    shown_commands.py --write PAGE FOLDER                 only writes the files that the page shows

Commands stand in blocks ```console behind "$ ", their further lines behind "> ", or, as in README.md, indented by four from
build/release/leadscrew on. Behind them stands what is seen on a terminal, errors included. Where the page has … any text of a line may stand, and any lines where it
has … alone. A block of another language whose first line is a comment with the name of a file is that file, there from its
block on; further blocks with that name go on with it. At least LEAST commands are found.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

BLOCK = re.compile(r"^```([a-z+]+)\n(.*?)^```$|^((?:    [^\n]*\n)(?:\n*    [^\n]*\n)*)", re.MULTILINE | re.DOTALL)
FILE = re.compile(r"(?:#|//|;|/\*) ([\w-]+\.\w+)(?:, continued)?(?: \*/)?\n")
BUILT = "build/release/leadscrew "


def pattern_of(shown):
    """What matches the output that these lines stand for."""
    lines = [r"(?:.*\n)*?" if line.strip() == "…" else ".*?".join(map(re.escape, line.rstrip().split("…"))) + r"[ ]*\n"
             for line in shown]
    return re.compile("".join(lines) + r"\Z")


def steps_of(page):
    """(file, text) and (command, lines shown behind it), in the page's order."""
    for language, fenced, indented in BLOCK.findall(page):
        named = FILE.match(fenced)
        if language == "console":
            for part in re.split(r"^\$ ", fenced, flags=re.MULTILINE)[1:]:
                typed, shown = re.fullmatch(r"(.*\n(?:> .*\n)*)((?:.*\n)*)", part).groups()
                yield "command", typed.replace("\n> ", "\n").strip(), shown.splitlines()
        elif named:
            yield "file", named[1], fenced
        elif indented:
            lines = [line[4:] for line in indented.splitlines()]
            for number, line in enumerate(lines):
                if line.startswith(BUILT):
                    behind = lines[number + 1:]
                    end = next((i for i, other in enumerate(behind) if other.startswith(BUILT)), len(behind))
                    yield "command", line, [other for other in behind[:end] if other.strip()]


def write(folder, name, text, seen):
    (folder / name).open("a" if name in seen else "w", encoding="utf-8").write(text)
    seen.add(name)


def broken_links(path, page):
    """What the page links to and is not there."""
    for link in re.findall(r"\]\(([^)# ]+)", re.sub(r"^```.*?^```$", "", page, flags=re.MULTILINE | re.DOTALL)):
        if not re.match(r"https?:", link) and not (path.parent / link).exists():
            yield f"{path.name} links to {link}, which is not there"


def run(command, shown, scratch):
    """What is wrong with it."""
    environment = dict(os.environ, PATH=f"{scratch}:/usr/bin:/bin", LC_ALL="C.UTF-8", NO_COLOR="1")
    done = subprocess.run(["bash", "-c", command], cwd=scratch, env=environment, stdin=subprocess.DEVNULL, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)
    if done.returncode != 0:
        return f"{command}\nended with {done.returncode}:\n{done.stdout}"
    if shown and not pattern_of(shown).match(done.stdout):
        return "\n".join([command, "is shown with", *shown, "but prints", done.stdout])
    return None


def main(path, scratch, least, links):
    page = path.read_text(encoding="utf-8")
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    for link, target in (link.split("=", 1) for link in links):
        (scratch / link).parent.mkdir(parents=True, exist_ok=True)
        (scratch / link).symlink_to(target)
    problems, count, seen = list(broken_links(path, page)), 0, set()
    for kind, what, rest in steps_of(page):
        if kind == "file":
            write(scratch, what, rest, seen)
            continue
        count += 1
        problem = run(what, rest, scratch)
        if problem:
            problems.append(f"{path.name} shows {problem}")
    if count < least:
        problems.append(f"{path.name} shows only {count} commands, not {least}")
    print("\n\n".join(problems) or f"{path.name}: {count} commands")
    return 1 if problems else 0


if sys.argv[1] == "--write":
    shown_files = set()
    for kind, what, rest in steps_of(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")):
        if kind == "file":
            write(pathlib.Path(sys.argv[3]), what, rest, shown_files)
    sys.exit(0)
sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), int(sys.argv[3]), sys.argv[4:]))
