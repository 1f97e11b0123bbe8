"""Where Markdown documents lead, and whether there is something: markdown_links.py ROOT

Prints a line for each link that leads nowhere, `file:line: link`, and exits 1 if there is any; 2 if ROOT has no document.
Links to other machines are not followed. Uses nothing but Python."""

import re
import sys
from pathlib import Path
from urllib.parse import unquote

#: Folders that hold no documents of the project's own.
LEFT_OUT = {"build", ".git", "__pycache__"}
FENCE = re.compile(r"^ {0,3}(```|~~~)")
LINK = re.compile(r"\[(?:[^\[\]]|\[[^\]]*\])*\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")
OTHER_MACHINE = re.compile(r"^[a-z][a-z0-9+.-]*:", re.I)


def documents(root):
    return sorted(path for path in root.rglob("*.md") if not LEFT_OUT & set(path.relative_to(root).parts))


def slug(heading, seen):
    """The anchor that GitHub gives a heading: `seen` counts those of the page before it."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
    name = re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")
    number = seen.get(name, 0)
    seen[name] = number + 1
    return f"{name}-{number}" if number else name


def lines_of_text(text):
    """(number, line) outside of code that is fenced or indented; of code within a line nothing but its place is left."""
    fenced, blank = False, True
    for number, line in enumerate(text.split("\n"), 1):
        if FENCE.match(line):
            fenced = not fenced
            continue
        if fenced or (blank and line.startswith("    ")):
            continue
        blank = not line.strip()
        yield number, re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", lambda code: "`" * len(code[0]), line)


def anchors(text):
    seen, fenced, found = {}, False, set()
    for line in text.split("\n"):
        fenced ^= bool(FENCE.match(line))
        heading = None if fenced else re.match(r"#{1,6}\s+(.*?)\s*#*$", line)
        if heading:
            found.add(slug(heading[1], seen))
    return found


def links(text):
    """(line, link) of each; a link may run over the end of a line."""
    numbered = list(lines_of_text(text))
    whole, starts = "", []
    for number, line in numbered:
        starts.append((len(whole), number))
        whole += line + "\n"
    for link in LINK.finditer(whole):
        yield max(number for start, number in starts if start <= link.start()), link[1]


def dead_links(root):
    dead = []
    known = {}
    for path in documents(root):
        for number, link in links(path.read_text(encoding="utf-8")):
            if OTHER_MACHINE.match(link):
                continue
            name, _, anchor = unquote(link).partition("#")
            target = (path.parent / name).resolve() if name else path.resolve()
            if target.is_dir() and anchor:
                target = target / "README.md"
            if not target.exists() or (target != root and root not in target.parents):
                dead.append(f"{path.relative_to(root)}:{number}: {link}")
            elif anchor and target.suffix == ".md":
                if target not in known:
                    known[target] = anchors(target.read_text(encoding="utf-8"))
                if anchor not in known[target]:
                    dead.append(f"{path.relative_to(root)}:{number}: {link}")
    return dead


def main(arguments):
    root = Path(arguments[0]).resolve()
    pages = documents(root)
    if not pages:
        print(f"{root} has no document")
        return 2
    dead = dead_links(root)
    print("\n".join(dead) if dead else f"the links of {len(pages)} documents lead somewhere")
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
