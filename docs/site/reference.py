"""The reference of the library as pages: one for each public header, of what Doxygen has read from it and the headers that it
includes directly.

    reference.py --check XML    fails where a name outside of classes has no comment; for those inside, Doxygen does
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

KINDS = {"class": "class", "struct": "struct", "concept": "concept", "union": "union"}
RELATIVE = re.compile(r"^#include <leadscrew/([a-z_]+/[a-z_]+\.hpp)>$", re.MULTILINE)
# Plain text in Markdown.
SPECIAL = re.compile(r"([\\`*_\[\]<>#|~{}$])")


def escaped(text):
    return SPECIAL.sub(r"\\\1", text or "")


def flat(node):
    """All text of it, on one line."""
    return re.sub(r"\s+", " ", "".join(node.itertext())).strip() if node is not None else ""


def code(text):
    """In line, whatever quotes it holds."""
    fence = "``" if "`" in text else "`"
    return f"{fence}{text}{fence}"


def inline(node, pages):
    """Of a paragraph: its text, links and code."""
    parts = [escaped(node.text)]
    for child in node:
        if child.tag == "computeroutput":
            parts.append(code(flat(child)))
        elif child.tag == "ref" and child.get("refid") in pages:
            parts.append(f"[{escaped(flat(child))}]({pages[child.get('refid')]})")
        elif child.tag == "ulink":
            parts.append(f"[{escaped(flat(child))}]({child.get('url')})")
        elif child.tag in ("bold", "emphasis"):
            parts.append(f"**{escaped(flat(child))}**")
        elif child.tag in ("itemizedlist", "orderedlist"):
            parts.append("\n\n" + "\n".join(f"- {inline(paragraph, pages)}" for item in child for paragraph in item) + "\n\n")
        elif child.tag == "verbatim":
            parts.append(f"\n\n```none\n{child.text.strip(chr(10))}\n```\n\n")
        else:
            parts.append(inline(child, pages))
        parts.append(escaped(child.tail))
    return "".join(parts)


def description(node, pages):
    paragraphs = [inline(paragraph, pages).strip() for kind in ("briefdescription", "detaileddescription")
                  for paragraph in node.findall(f"{kind}/para")]
    return "\n\n".join(paragraph for paragraph in paragraphs if paragraph)


def indented(text):
    return text.replace("\n", "\n  ")


def templates(node):
    names = [" ".join(filter(None, (flat(each.find("type")), flat(each.find("declname"))))) for each in
             node.findall("templateparamlist/param")]
    return f"template <{', '.join(names)}> " if names else ""


def declaration(member):
    """As it is declared, without the names of the rooms it is in."""
    name, kind = flat(member.find("name")), member.get("kind")
    if kind == "define":
        parameters = [flat(each) for each in member.findall("param")]
        return f"#define {name}" + (f"({', '.join(parameters)})" if parameters else "")
    if kind == "enum":
        return f"{'enum class' if member.get('strong') == 'yes' else 'enum'} {name.partition('@')[0]}".strip()
    kept = re.sub(r"\b(?:[A-Za-z_]\w*(?:<[^<>()]*>)?::)+(?=" + re.escape(name) + r"(?!\w))", "", flat(member.find("definition")))
    text = templates(member) + kept + (flat(member.find("argsstring")) if kind == "function" else "")
    initial = flat(member.find("initializer"))
    if kind == "variable" and initial and len(initial) < 60:
        text += initial if initial.startswith("{") else " " + initial
    return re.sub(r"\s+([,)>])", r"\1", text.replace("< ", "<").replace("leadscrew::", ""))


def entries(members, pages):
    lines = []
    for member in members:
        text = description(member, pages)
        if member.get("kind") == "enum":
            rows = [f"{code(flat(value.find('name')))}: {description(value, pages)}".rstrip(": ")
                    for value in member.findall("enumvalue")]
            text = "\n\n".join(filter(None, [text, "\n".join(f"- {indented(row)}" for row in rows)]))
        lines += [code(declaration(member)), f": {indented(text or '–')}", ""]
    return lines


def public(members):
    return [member for member in members if member.get("prot") in (None, "public") and member.get("kind") != "friend" and
            (flat(member.find("briefdescription")) or flat(member.find("detaileddescription")) or member.get("kind") != "function")
            and not flat(member.find("name")).startswith("~")]


class Header:
    """What one header declares, by line."""

    def __init__(self):
        self.compounds, self.members = [], []


def read(xml):
    """The headers, by their path as it is included."""
    headers, files = {}, {}
    for path in sorted(xml.glob("*.xml")):
        compound = ElementTree.parse(path).getroot().find("compounddef")
        if compound is None:
            continue
        location = compound.find("location")
        if compound.get("kind") in KINDS and compound.get("prot") in (None, "public"):
            headers.setdefault(location.get("file"), Header()).compounds.append(compound)
        elif compound.get("kind") in ("namespace", "file"):
            if compound.get("kind") == "file":
                files[location.get("file")] = compound
            if "detail" in flat(compound.find("compoundname")) or flat(compound.find("compoundname")) == "std":
                continue
            for member in compound.findall("sectiondef/memberdef"):
                headers.setdefault(member.find("location").get("file"), Header()).members.append(member)
    for header in headers.values():
        header.compounds.sort(key=lambda each: int(each.find("location").get("line")))
        header.members.sort(key=lambda each: int(each.find("location").get("line")))
    return headers, files


def short(name):
    return name.removeprefix("leadscrew::")


def page(title, head, parts, headers, pages):
    lines = [f"# {title}", "", head, ""]
    for file in parts:
        header = headers.get(file, Header())
        for compound in header.compounds:
            name = short(flat(compound.find("compoundname")))
            kind = KINDS[compound.get("kind")]
            lines += [f"({compound.get('id')})=", f"## {kind} {escaped(name)}", "", description(compound, pages), ""]
            if templates(compound) and kind != "concept":
                lines += ["```cpp", f"{templates(compound)}{kind} {name.split('::')[-1]};", "```", ""]
            lines += entries(public(compound.findall("sectiondef/memberdef")), pages)
        members = public(header.members)
        if members:
            lines += [f"## In {file.split('/', 1)[1] if file.count('/') > 1 else file}", "", *entries(members, pages)]
    return "\n".join(lines) + "\n"


def write(xml, include, folder):
    """A page for each header of INCLUDE, one for leadscrew.h, and the list of them."""
    folder.mkdir()
    headers, files = read(xml)
    parts = {path.name: [f"leadscrew/{each}" for each in RELATIVE.findall(path.read_text(encoding="utf-8"))] + [f"leadscrew/{path.name}"]
             for path in sorted(include.glob("*.hpp"))}
    calls = include.parents[1] / "src/leadscrew/capi"  # leadscrew.h includes the others
    parts["leadscrew.h"] = [f"leadscrew/capi/{path.name}" for path in sorted(calls.glob("leadscrew_*.h"))] + ["leadscrew/capi/leadscrew.h"]
    pages = {}
    for name, of_page in parts.items():
        for file in of_page:
            for compound in headers.get(file, Header()).compounds:
                pages[compound.get("id")] = compound.get("id")
    names = []
    for name, of_page in parts.items():
        own = files.get(of_page[-1])
        head = description(own, pages) if own is not None else ""
        if name == "leadscrew.h":
            head = "The calls for C: a shared library, `leadscrew::shared`. [How to begin](../guides/controller.md)."
        stem = name.replace(".", "-")
        title = name if name == "leadscrew.h" else f"leadscrew/{name}"
        (folder / f"{stem}.md").write_text(page(title, head, of_page, headers, pages), encoding="utf-8")
        names.append(stem)
    # The one to begin with first.
    names.sort(key=lambda stem: (stem != "motion-hpp", stem == "leadscrew-h", stem))
    lines = ["# The library's headers", "", "Made by Doxygen from their comments. [What each is for](../library.md#the-headers), and",
             "[where to begin](../guides/controller.md).", "", "```{toctree}", *names, "```", ""]
    (folder / "index.md").write_text("\n".join(lines), encoding="utf-8")


def undocumented(xml):
    """Names outside of classes without a comment."""
    headers, _ = read(xml)
    for file, header in sorted(headers.items()):
        for member in header.members:
            if not description(member, {}) and (member.get("kind") != "enum" or flat(member.find("name"))[:1] != "@"):
                yield f"{file}:{member.find('location').get('line')}: error: {declaration(member)} is not documented"


if __name__ == "__main__" and sys.argv[1] == "--check":
    problems = list(undocumented(pathlib.Path(sys.argv[2])))
    print("\n".join(problems), end="\n" if problems else "")
    sys.exit(1 if problems else 0)
