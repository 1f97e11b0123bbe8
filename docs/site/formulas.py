"""Formulas of the documents, rendered by KaTeX while the site is made: its pages need no script, and load nothing
from elsewhere. Displayed ones are fenced as ```math, those within a line written $`…`$, as GitHub reads them."""

import html
import json
import re
import shutil
import subprocess
from pathlib import Path

#: Where Debian's libjs-katex has katex.js, the style sheet and the fonts.
KATEX = Path("/usr/share/javascript/katex")
RENDER = Path(__file__).resolve().parent / "render_formulas.js"
#: In the HTML that cmark-gfm makes of a document. In code, what is between the dollars has no tags of its own.
FORMULA = re.compile(r'<pre><code class="language-math">(?P<display>.*?)</code></pre>'
                     r"|\$<code>(?P<line>.*?)</code>\$", re.S)
#: Every browser takes the first kind of font in KaTeX's style sheet; the others would be 0.8 MB that nobody loads.
OTHER_FONTS = re.compile(r""",url\([^)]*\.(?:woff|ttf)\) format\(["'][a-z]+["']\)""")


class WrongFormula(Exception):
    """A line for each formula of a document that KaTeX does not understand."""


def rendered(body, document):
    """The HTML of a document with its formulas in place. One process renders all of them: its start costs the most."""
    found = [{"tex": html.unescape(match["display"] or match["line"] or "").strip(),
              "display": match["display"] is not None} for match in FORMULA.finditer(body)]
    if not found:
        return body
    command = ["node", RENDER, KATEX / "katex.js"]
    results = json.loads(subprocess.run(command, input=json.dumps(found), stdout=subprocess.PIPE, text=True, check=True).stdout)
    wrong = [" ".join(f"{document}: {formula['tex']}: {result['error']}".split())
             for formula, result in zip(found, results) if "error" in result]
    if wrong:
        raise WrongFormula("\n".join(wrong))
    left = iter(results)
    return FORMULA.sub(lambda match: next(left)["html"], body)


def copy_style(out):
    """KaTeX's style sheet and fonts, to OUT/katex."""
    style = (KATEX / "katex.min.css").read_text(encoding="utf-8")
    (out / "katex").mkdir()
    (out / "katex/katex.css").write_text(OTHER_FONTS.sub("", style), encoding="utf-8")
    shutil.copytree(KATEX / "fonts", out / "katex/fonts", ignore=shutil.ignore_patterns("*.woff", "*.ttf"))
