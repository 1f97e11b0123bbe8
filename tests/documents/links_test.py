"""What the checks of links find: links_test.py SITE, the folder of their scripts."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, sys.argv.pop(1))

import build_site
import markdown_links


class Links(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def dead(self, text):
        self.write("a.md", text)
        return [line.split(": ")[1] for line in markdown_links.dead_links(self.root)]

    def test_a_link_must_lead_to_a_file_or_a_heading(self):
        self.write("folder/README.md", "# Top\n\n## The `map`, of λ\n\n## Twice\n\n## Twice\n")
        good = ("[a](folder/) [b](folder/README.md#the-map-of-λ) [c](folder/README.md#twice-1) [d](#here) ![e](folder) "
                "[f](https://nowhere.invalid/x) [g](folder#top)\n\n# Here\n")
        self.assertEqual(self.dead(good), [])
        for link in ("none.md", "folder/none.svg", "folder/README.md#none", "#none", "folder/README.md#twice-2", "../outside"):
            self.assertEqual(self.dead(f"# Here\n\nwords [over\nlines]({link})"), [link])

    def test_code_has_no_links(self):
        self.assertEqual(self.dead("`[a](none)`\n\n```\n[b](none)\n```\n\n    [c](none)\n"), [])
        self.assertEqual(self.dead("```\n```\n[b](none)\n"), ["none"])

    def test_a_page_of_the_site_must_lead_to_a_file_of_it_or_a_place(self):
        self.write("index.html", '<a href="b.html#x">b</a> <a href="#y">y</a> <h2 id="y"></h2> <img src="https://a.invalid/">')
        self.write("b.html", '<h1 id="x"></h1>')
        self.assertEqual(build_site.dead_links(self.root), [])
        self.write("c.html", '<a href="none.html">n</a> <a href="b.html#none">n</a> <link href="none.css">')
        self.assertEqual(build_site.dead_links(self.root), ["c.html: none.html", "c.html: b.html#none", "c.html: none.css"])


if __name__ == "__main__":
    unittest.main()
