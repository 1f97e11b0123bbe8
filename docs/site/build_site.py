"""The project's documents as a static site: build_site.py ROOT PAGES OUT [--doxygen DOXYGEN] [--gallery FOLDER]

ROOT's Markdown documents, the PAGES that `swirl manual --format markdown` wrote, and the headers' pages by Doxygen, whose
warnings are errors, go to OUT, which is made anew; index.html is the first page. Files that documents link to are copied. With a
FOLDER that gallery.py made there is a page of figures, and the first page opens with the one in which the map runs.
Exits 1 if a link of the site leads nowhere or a formula is none that KaTeX understands. Needs what packages.txt beside
this lists; pages load nothing from elsewhere."""

import argparse
import html
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from urllib.parse import quote, unquote

import formulas
import markdown_links

HERE = Path(__file__).resolve().parent
LINKED = re.compile(r'(<(?:a|img)\b[^>]*?\b(?:href|src)=")([^"]*)(")')
#: The pages that a reader wants first, in this order; the others follow by name.
FIRST = [Path(name) for name in ("README.md", "gallery/gallery.md", "docs/install.md", "docs/tutorial.md", "docs/film-to-verdict.md", "docs/examples.md",
                                 "docs/against-the-swirl.md", "docs/hysteresis.md", "docs/from-the-paper-to-a-dish.md", "docs/performance.md", "docs/python.md", "docs/library.md", "docs/command-line.md", "manual/swirl.md")]
#: The page of figures, where --gallery gives one.
GALLERY = Path("gallery/gallery.md")
#: What browsers show by themselves; other files are shown as text.
SHOWN = {".svg", ".png", ".gif", ".html"}


def html_of(text):
    command = ["cmark-gfm", "--unsafe", "-e", "table", "-e", "strikethrough", "-e", "autolink"]
    body = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    seen = {}

    def heading(match):
        words = html.unescape(re.sub(r"<[^>]+>", "", match[2]))
        return f'<h{match[1]} id="{html.escape(markdown_links.slug(words, seen))}">{match[2]}</h{match[1]}>'

    body = re.sub(r"<h([1-6])>(.*?)</h\1>", heading, body, flags=re.S)
    return body.replace("<table>", '<div class="scroll"><table>').replace("</table>", "</table></div>")


class Site:
    def __init__(self, root, pages, out, gallery=None):
        self.root, self.pages, self.out, self.gallery = root, pages, out, gallery
        # Source of each page: the document's path below the root, and of a page of the manual below manual/.
        self.sources = {path.relative_to(root): path for path in markdown_links.documents(root)}
        self.sources.update({Path("manual") / path.name: path for path in sorted(pages.glob("*.md"))})
        if gallery:
            self.sources[GALLERY] = gallery / "gallery.md"
        self.places = {source: self.place_of(source) for source in self.sources}
        self.copied = {}

    def place_of(self, source):
        if source.name == "README.md":
            return source.parent / "index.html"
        return source.with_suffix(".html") if source != Path("manual/swirl.md") else Path("manual/index.html")

    def title_of(self, source):
        heading = re.search(r"^# (.*)$", self.sources[source].read_text(encoding="utf-8"), re.M)
        return re.sub(r"[`\\]", "", heading[1]) if heading else source.stem

    def navigation(self, source):
        groups = {"Swirl": [], "Commands": [], "Mathematics": [], "Project": []}
        for other in self.sources:
            folder = other.parts[0]
            group = ("Commands" if folder == "manual" else "Mathematics" if folder in ("map", "analysis") or other.parts[:2] == ("apps", "studies") else
                     "Swirl" if other in (Path("README.md"), GALLERY) or other.parent == Path("docs") else "Project")
            groups[group].append(other)
        text = ""
        for group, members in groups.items():
            text += f"<h2>{group}</h2><ul>"
            for other in sorted(members, key=lambda path: (FIRST.index(path) if path in FIRST else len(FIRST), str(path.parent), str(path))):
                name = self.title_of(other)
                name = name if group != "Commands" else name.removeprefix("swirl ")
                if other == Path("README.md"):
                    name = "Overview"
                current = ' aria-current="page"' if other == source else ""
                text += f'<li><a href="{self.way(source, self.places[other])}"{current}>{html.escape(name)}</a></li>'
            if group == "Mathematics" and (self.out / "api/index.html").exists():
                text += f'<li><a href="{self.way(source, Path("api/index.html"))}">Headers (API)</a></li>'
            text += "</ul>"
        return text

    def way(self, source, place):
        return quote(os.path.relpath(place, self.places[source].parent).replace(os.sep, "/"))

    def link(self, source, link):
        """Where a link of the document leads on the site."""
        if markdown_links.OTHER_MACHINE.match(link) or link.startswith("#"):
            return link
        name, _, anchor = unquote(html.unescape(link)).partition("#")
        target = Path(os.path.normpath(source.parent / name))
        if (self.root / target).is_dir() and target / "README.md" in self.sources:
            target = target / "README.md"
        place = self.places.get(target) or self.copy(target)
        return self.way(source, place) + (f"#{anchor}" if anchor else "")

    def copy(self, target):
        """A file, or the names in a folder, that is no document; where it stands on the site."""
        path = self.gallery / target.name if self.gallery and target.parent == GALLERY.parent else self.root / target
        if target.suffix in SHOWN and path.is_file():
            place = target
            (self.out / place).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, self.out / place)
            return place
        place = Path("files") / f"{target}.txt"
        if path.exists() and target not in self.copied:
            self.copied[target] = place
            names = "\n".join(sorted(entry.name for entry in path.iterdir())) if path.is_dir() else None
            (self.out / place).parent.mkdir(parents=True, exist_ok=True)
            (self.out / place).write_text(names or path.read_text(encoding="utf-8"), encoding="utf-8")
        return place

    def with_running_map(self, body):
        """The first page with the page in which the map runs, before its first picture."""
        page = self.copy(GALLERY.parent / "page.html").as_posix()
        frame = (f'<iframe class="map" src="{page}" title="A mode map of the hexagon: a click chooses a scene, whose orbit runs beside it"></iframe>\n'
                 f'<p>A click on the map chooses a scene, whose orbit runs beside it: the collision map itself, in your browser '
                 f'(<a href="{page}">alone on a page</a>, <a href="docs/explore.html">how it is made</a>, '
                 f'<a href="{self.places[GALLERY].as_posix()}">more figures</a>).</p>\n')
        before, picture, after = body.partition("<p><img")
        return before + frame + picture + after

    def write(self, source):
        body = formulas.rendered(html_of(self.sources[source].read_text(encoding="utf-8")), source)
        body = LINKED.sub(lambda match: match[1] + html.escape(self.link(source, match[2])) + match[3], body)
        if self.gallery and source == Path("README.md"):
            body = self.with_running_map(body)
        place = self.out / self.places[source]
        place.parent.mkdir(parents=True, exist_ok=True)
        title = self.title_of(source)
        styles = ["style.css"] + (["katex/katex.css"] if 'class="katex"' in body else [])
        styles = "\n".join(f'<link rel="stylesheet" href="{self.way(source, Path(style))}">' for style in styles)
        place.write_text(f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{html.escape(title if title == "Swirl" else f"{title} – Swirl")}</title>
{styles}
</head>
<body>
<div class="page">
<nav aria-label="Pages" id="pages">{self.navigation(source)}</nav>
<main>
<a class="to-pages" href="#pages">All pages</a>
{body}</main>
</div>
</body>
</html>
""", encoding="utf-8")


def dead_links(out):
    """`page: link` of each that leads to no file of the site, or to no place in it. Places within its own pages are Doxygen's:
    it lists nested classes of which it shows none."""
    dead, known = [], {}

    def ids(page):
        if page not in known:
            known[page] = set(re.findall(r'\b(?:id|name)="([^"]+)"', page.read_text(encoding="utf-8")))
        return known[page]

    for page in sorted(out.rglob("*.html")):
        for match in re.finditer(r'<(?:a|img|link|script)\b[^>]*?\b(?:href|src)="([^"]*)"', page.read_text(encoding="utf-8")):
            link = html.unescape(match[1])
            if markdown_links.OTHER_MACHINE.match(link):
                continue
            name, _, anchor = link.partition("#")
            target = page.parent / unquote(name) if name else page
            placed = anchor and target.suffix == ".html" and out / "api" not in page.parents
            if not target.is_file() or (placed and html.escape(unquote(anchor)) not in ids(target)):
                dead.append(f"{page.relative_to(out)}: {link}")
    return dead


def write_api(root, out, doxygen):
    settings = (HERE / "Doxyfile").read_text(encoding="utf-8") + (
        f'\nOUTPUT_DIRECTORY = "{out}"\nLAYOUT_FILE = "{HERE / "DoxygenLayout.xml"}"\n'
        # The first page has the site's links by their words: its documents are no pages of Doxygen's.
        f'FILTER_PATTERNS = */library.md="sed -E -f {HERE / "words_of_links.sed"}"\n')
    return subprocess.run([doxygen, "-"], input=settings, text=True, cwd=root, check=False).returncode == 0


def write_pages(site):
    """What is wrong with the formulas, a line for each."""
    wrong = []
    for source in site.sources:
        try:
            site.write(source)
        except formulas.WrongFormula as error:
            wrong.append(str(error))
    return wrong


def missing():
    """What the site needs and is not installed."""
    programs = [name for name in ("cmark-gfm", "node") if not shutil.which(name)]
    return programs + ([] if (formulas.KATEX / "katex.js").is_file() else ["KaTeX"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("root", "pages", "out"):
        parser.add_argument(name, type=Path)
    parser.add_argument("--gallery", type=Path, metavar="FOLDER", help="what gallery.py made")
    parser.add_argument("--doxygen", help="the program; without it there are no pages of headers")
    arguments = parser.parse_args()
    if missing():
        print(f"the site needs {', '.join(missing())}: ./quickstart --packages docs/site/packages.txt")
        return 1
    out = arguments.out.resolve()
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    shutil.copyfile(HERE / "style.css", out / "style.css")
    formulas.copy_style(out)
    if arguments.doxygen and not write_api(arguments.root.resolve(), out, arguments.doxygen):
        print("doxygen warns of a header, or failed")
        return 1
    site = Site(arguments.root.resolve(), arguments.pages.resolve(), out, arguments.gallery and arguments.gallery.resolve())
    wrong = write_pages(site) or dead_links(out)
    pages = len(list(out.rglob("*.html")))
    print("\n".join(wrong) if wrong else f"{len(site.sources)} pages, {pages} with those of headers: {out / 'index.html'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
