"""The formulas of the site: formulas_test.py ROOT. The headers' pages and the manual have none, and are left out."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve()
BUILD_SITE = ROOT / "docs/site/build_site.py"
#: What begins a formula.
WRITTEN = re.compile(r"^```math$|\$`", re.M)


def build(root, folder, **environment):
    """The site of ROOT's documents, in FOLDER/site."""
    (folder / "pages").mkdir(exist_ok=True)
    return subprocess.run([sys.executable, "-B", BUILD_SITE, root, folder / "pages", folder / "site"], capture_output=True,
                          text=True, timeout=500, env={**os.environ, **environment})


class Folder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name).resolve()
        cls.site = cls.folder / "site"


class OneDocument(Folder):
    def page(self, text):
        root = self.folder / "root"
        (root / "map").mkdir(parents=True, exist_ok=True)
        (root / "map/README.md").write_text(text, encoding="utf-8")
        result = build(root, self.folder)
        page = self.site / "map/index.html"
        return result, page.read_text(encoding="utf-8") if page.exists() else ""

    def test_a_displayed_formula_is_rendered(self):
        result, page = self.page("# A\n\n```math\na < \\frac{\\alpha}{2}\n```\n")
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        for part in ('<span class="katex-display"><span class="katex">', '<math xmlns="http://www.w3.org/1998/Math/MathML"',
                     "<mi>α</mi>", "<mo>&lt;</mo>", 'href="../katex/katex.css"'):
            self.assertIn(part, page)
        self.assertNotIn("language-math", page)

    def test_a_formula_within_a_line_and_in_a_table_is_rendered_there(self):
        result, page = self.page("# A\n\nwith $`x^2`$ and $`y`$.\n\n| a |\n| --- |\n| $`\\lvert z \\rvert`$ |\n")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertEqual(page.count('<span class="katex">'), 3)
        self.assertRegex(page, r"<p>with <span class=\"katex\">.*</span> and <span class=\"katex\">.*</span>\.</p>")
        self.assertNotIn("katex-display", page)

    def test_code_is_no_formula(self):
        _, page = self.page("# A\n\n`` $`x`$ `` and `$y$` and 2 $\n\n```sh\n$`z`$\n```\n")
        self.assertNotIn("katex", page)

    def test_a_formula_that_katex_does_not_understand_ends_it_by_its_name(self):
        result, _ = self.page("# A\n\n```math\na +\n\\frac{1\n```\n\nand $`\\nothing`$, $`x`$\n")
        self.assertEqual(result.returncode, 1)
        lines = result.stdout.splitlines()
        self.assertEqual([line.split(": KaTeX")[0] for line in lines], [r"map/README.md: a + \frac{1", r"map/README.md: \nothing"])

    def test_without_what_renders_it_says_so_in_a_line(self):
        result = build(self.folder, self.folder, PATH="/nonexistent")
        self.assertEqual(result.returncode, 1)
        self.assertEqual((result.stdout.count("\n"), result.stderr), (1, ""))
        self.assertIn("docs/site/packages.txt", result.stdout)


class AllDocuments(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.result = build(ROOT, cls.folder)

    def documents(self):
        """(document, its page) of the folders that hold the mathematics."""
        for top in ("map", "analysis"):
            for document in sorted((ROOT / top).rglob("README.md")):
                yield document, self.site / document.relative_to(ROOT).parent / "index.html"

    def test_every_formula_of_the_folders_is_rendered(self):
        self.assertEqual((self.result.returncode, self.result.stderr), (0, ""), self.result.stdout)
        found = 0
        for document, page in self.documents():
            written = len(WRITTEN.findall(document.read_text(encoding="utf-8")))
            text = page.read_text(encoding="utf-8")
            self.assertEqual(text.count('<span class="katex">'), written, document)
            found += written
        self.assertGreater(found, 0)

    def test_no_block_of_the_folders_is_without_a_language(self):
        # An indented block would be a formula in plain text; code is fenced.
        for document, page in self.documents():
            self.assertNotIn("<pre><code>", page.read_text(encoding="utf-8"), document)

    def test_nothing_is_loaded_from_elsewhere_and_no_page_has_a_script(self):
        for page in self.site.rglob("*.html"):
            text = page.read_text(encoding="utf-8")
            self.assertNotRegex(text, r"<script|<style|<iframe|@import", page)
            for loaded in re.findall(r'<(?:img|link)\b[^>]*?(?:src|href)="([^"]*)"', text):
                self.assertTrue((page.parent / loaded).is_file(), f"{page}: {loaded}")
        for style in self.site.rglob("*.css"):
            text = style.read_text(encoding="utf-8")
            self.assertNotIn("@import", text)
            for loaded in re.findall(r"url\(([^)]*)\)", text):
                self.assertTrue((style.parent / loaded.strip("\"'")).is_file(), f"{style}: {loaded}")
        self.assertGreater(len(list(self.site.glob("katex/fonts/*.woff2"))), 0)


if __name__ == "__main__":
    unittest.main()
