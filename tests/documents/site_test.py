"""The site, built: site_test.py SWIRL ROOT DOXYGEN"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SWIRL, ROOT, DOXYGEN = sys.argv.pop(1), Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)
BUILD_SITE = ROOT / "docs/site/build_site.py"


def build(root, pages, out, doxygen):
    return subprocess.run([sys.executable, "-B", BUILD_SITE, root, pages, out, "--doxygen", doxygen], capture_output=True,
                          text=True, timeout=500)


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.pages, cls.out = cls.folder / "pages", cls.folder / "site"
        subprocess.run([SWIRL, "manual", "--format", "markdown", "-o", cls.pages], check=True, timeout=60)
        cls.result = build(ROOT, cls.pages, cls.out, DOXYGEN)

    def test_it_is_built_without_a_dead_link_or_a_warning(self):
        self.assertEqual((self.result.returncode, self.result.stderr), (0, ""), self.result.stdout)

    def test_every_document_and_every_command_has_a_page(self):
        for name in ("index.html", "docs/tutorial.html", "map/index.html", "analysis/recurrence/index.html", "manual/index.html",
                     "api/index.html"):
            self.assertTrue((self.out / name).is_file(), name)
        commands = re.findall(r"^  ([a-z]+) ", subprocess.run([SWIRL, "--help"], capture_output=True, text=True, check=True)
                              .stdout.split("Subcommands:")[1], re.M)
        overview = (self.out / "index.html").read_text()
        for command in commands:
            self.assertIn(f'href="manual/swirl-{command}.html"', overview)

    def test_every_page_leads_back_to_the_first(self):
        for page in self.out.rglob("*.html"):
            if self.out / "api" not in page.parents:
                first = os.path.relpath(self.out / "index.html", page.parent)
                self.assertIn(f'href="{first}"', page.read_text(), page)
        self.assertIn('{text:"Swirl",url:"../index.html"}', (self.out / "api/menudata.js").read_text())

    def test_nothing_is_loaded_from_elsewhere(self):
        for page in self.out.rglob("*.html"):
            for loaded in re.findall(r'<(?:img|link|script)\b[^>]*?(?:src|href)="([^"]*)"', page.read_text(errors="replace")):
                self.assertNotRegex(loaded, r"^(https?:)?//", page.name)

    def made_up(self, name):
        root = self.folder / name
        for folder in ("map", "analysis", "apps/studies", "docs"):
            (root / folder).mkdir(parents=True)
        (root / "docs/library.md").write_text("# A library\n")
        return root

    def test_a_link_that_leads_nowhere_ends_it(self):
        root = self.made_up("small")
        (root / "map/a.hpp").write_text("/// One. @return nothing\nint a();\n")
        (root / "README.md").write_text("# Small\n\n[here](map/a.hpp)\n")
        self.assertEqual(build(root, self.pages, self.folder / "s", DOXYGEN).returncode, 0)
        (root / "README.md").write_text("# Small\n\n[nowhere](none.md)\n")
        self.assertEqual(build(root, self.pages, self.folder / "s", DOXYGEN).returncode, 1)

    def test_a_wrong_comment_of_a_header_ends_it(self):
        root = self.made_up("wrong")
        (root / "README.md").write_text("# Wrong\n")
        (root / "map/a.hpp").write_text("/// One. @param none there is no such argument\nint a(int b);\n")
        self.assertEqual(build(root, self.pages, self.folder / "w", DOXYGEN).returncode, 1)


if __name__ == "__main__":
    unittest.main()
