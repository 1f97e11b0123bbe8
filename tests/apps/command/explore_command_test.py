"""swirl explore, from outside, and its page's scripts where node is: explore_command_test.py SWIRL ROOT"""

import json
import re
import shutil
import subprocess
import sys
import unittest
from html.parser import HTMLParser
from pathlib import Path

from driving import examples_of, run, with_records

ROOT = Path(sys.argv.pop(1)).resolve()
NODE = shutil.which("node")

SHORT = "--transient 100 --collisions 100"
RECORDS = {
    "sweep": f"sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:3 --grid beta=0.1:0.9:2 --runs 2 {SHORT}",
    "words": f"sweep --alpha 0.4 --beta 0.5 --restitution 0.9 --grid sides=3,6,disk --grid mu=0.1:1:2 {SHORT}",
    "points": f"sweep --sides 6 --mu 0.5 --restitution 0.9 --grid alpha=0.3:0.5 --grid beta=0.3:0.5 --sample sobol:5 {SHORT}",
    "many": f"sweep --sides 2000 --mu 0.5 --beta 0.5 --restitution 0.9 --grid alpha=0.3:0.5:2 {SHORT}",
    "diagram": "bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.95 --along alpha=0.365:0.375:3 --starts 1 --branches",
    "continue": "continue --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 "
                "--along beta=0.49:0.51",
    "curves": "boundaries --sides 6 --mu 0.5 --restitution 0.95 --plane alpha=0.4:0.6 --plane beta=0.25:0.5 --max-period 1 --lines 1",
    "shard": f"sweep --sides 6 --mu 0.5 --restitution 0.9 --grid alpha=0.3:0.5:2 --grid beta=0.3:0.5:2 --shard 1/2 {SHORT}",
    "orbit": "simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 5",
}


class Reader(HTMLParser):
    """The page as a browser sees it: open elements, what they refer to, what is in its scripts."""
    EMPTY = {"meta", "input", "link", "br"}

    def __init__(self, text):
        super().__init__()
        self.open, self.attributes, self.scripts, self.unclosed = [], [], {}, []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.attributes += [(tag, name, value) for name, value in attributes]
        if tag not in self.EMPTY:
            self.open.append((tag, dict(attributes).get("id")))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.unclosed.append((tag, self.getpos()))
        else:
            self.open.pop()

    def handle_data(self, data):
        if self.open and self.open[-1][0] == "script":
            name = self.open[-1][1] or "page"
            self.scripts[name] = self.scripts.get(name, "") + data


class WithRecords(with_records(RECORDS, (0, 3))):
    def page_of(self, *names):
        page = self.folder / f"{'_'.join(names)}.html"
        made = run(["explore", *(str(self.records[name]) for name in names), "-o", str(page), "--force"])
        self.assertEqual((made.returncode, made.stderr), (0, ""))
        return made.stdout.strip(), page.read_text()


class Page(WithRecords):
    def test_is_well_formed_and_asks_for_nothing(self):
        for names in (["sweep"], ["words"], ["points"], ["diagram"], ["continue"], ["curves"]):
            _, text = self.page_of(*names)
            page = Reader(text)
            self.assertEqual((page.open, page.unclosed), ([], []), names)
            refers = [value for _, name, value in page.attributes if name in ("src", "href", "action", "srcset")]
            self.assertEqual(refers, ["#"], names)
            self.assertIn("default-src 'none'", text)
            self.assertIsNone(re.search(r"https?://|@import|url\(|fetch\(|XMLHttpRequest|WebSocket|\bimport\b", text), names)
            self.assertLess(len(text.encode()), 3_000_000)
            self.assertIn("made by swirl explore", text)

    def test_holds_what_the_record_holds(self):
        said, text = self.page_of("sweep")
        self.assertEqual(said, f"{self.folder / 'sweep.html'}: map")
        data = json.loads(Reader(text).scripts["data"])
        shown = json.loads(run(f"show {self.records['sweep']} --json").stdout)["sweep"]
        sweep = data["records"][0]["groups"]["sweep"]
        self.assertEqual(sweep["alpha"]["values"], sorted({row["alpha"] for row in shown["beta"]}))
        self.assertEqual((sweep["share"]["dimensions"], sweep["share"]["shape"]), (["alpha", "beta", "mode"], [3, 2, 4]))
        self.assertEqual([sweep["run_mode"]["names"][mode] for mode in sweep["run_mode"]["values"]],
                         [row["run_mode"] for row in shown["run"]])
        for got, row in zip(sweep["run_mean_S"]["values"], shown["run"]):
            self.assertTrue(got == row["run_mean_S"] or abs(got - row["run_mean_S"]) <= 5e-6 * abs(got))
        self.assertNotIn(str(self.folder), text)  # no path travels with the page

    def test_its_starts_and_bodies_are_the_programs(self):
        data = json.loads(Reader(self.page_of("sweep")[1]).scripts["data"])
        made = json.loads(run("simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --speed 1 --seed 3 --collisions 1 "
                              "--json").stdout)
        self.assertEqual(data["bodies"]["6"]["inertia_factor"], made["scene"]["inertia_factor"])
        _, _, angle = data["starts"][2]
        # S = 0 until the first impact, which a vertex makes: vertex 0 still has the start's direction.
        self.assertAlmostEqual(made["collisions"][0]["angle"], angle, 14)
        self.assertGreaterEqual(len(data["starts"]), 20)
        directions = data["bodies"]["6"]["directions"]
        self.assertEqual(len(directions), 24)
        for k in range(6):
            x, y, rest_x, rest_y = directions[4 * k:4 * k + 4]
            self.assertAlmostEqual(x * x + y * y, 1, 15)
            self.assertLess(max(abs(rest_x), abs(rest_y)), 1.2e-16)

    def test_curves_lie_over_the_sweep_that_is_given_first(self):
        said, text = self.page_of("sweep", "curves")
        self.assertTrue(said.endswith(": map"), said)
        self.assertEqual([record["kind"] for record in json.loads(Reader(text).scripts["data"])["records"]], ["map", "curves"])

    def test_json_says_what_was_made(self):
        made = json.loads(run(["explore", str(self.records["diagram"]), "-o", str(self.folder / "b.html"), "--json"]).stdout)
        self.assertEqual((made["page"], made["kind"], made["record"]),
                         (str(self.folder / "b.html"), "diagram", str(self.records["diagram"])))

    def test_examples(self):
        folder = self.folder / "examples"
        folder.mkdir()
        examples = examples_of("explore")
        self.assertEqual(len(examples), 2)
        for example in examples:
            made = run(example, cwd=folder)
            self.assertEqual(made.returncode, 0, made.stderr)

    @unittest.skipUnless(NODE, "node is not there (Debian's nodejs)")
    def test_its_scripts(self):
        made = subprocess.run([NODE, "--test", ROOT / "tests/apps/explore/page_logic_test.js"], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stdout[-4000:])
        self.assertRegex(made.stdout, r"pass 1[0-9]")


class WrongInput(WithRecords):
    def refused(self, arguments, *mentions):
        made = run([str(word) for word in ["explore", *arguments]])
        self.assertEqual((made.returncode, made.stdout), (2, ""), made.stderr)
        self.assertEqual(len(made.stderr.splitlines()), 1, made.stderr)
        for mention in mentions:
            self.assertIn(mention, made.stderr)

    def test_is_one_line_and_writes_nothing(self):
        page, sweep, curves = self.folder / "none.html", self.records["sweep"], self.records["curves"]
        text = self.folder / "text.h5"
        text.write_text("no record")
        self.refused([sweep], "output")
        self.refused(["-o", page], "record")
        self.refused([self.folder / "missing.h5", "-o", page], "missing.h5")
        self.refused([text, "-o", page], "text.h5", "HDF5")
        self.refused([self.records["orbit"], "-o", page], "orbit.h5", "sweep, join, bifurcate, continue, boundaries")
        self.refused([self.records["shard"], "-o", page], "shard.h5", "join")
        self.refused([sweep, self.records["diagram"], "-o", page], "diagram.h5", "boundaries")
        self.refused([curves, curves, "-o", page], "curves.h5", "sweep")
        self.refused([self.records["words"], curves, "-o", page], "alpha and beta")
        self.refused([self.records["many"], "-o", page], "sides = 2000", "1024")
        self.refused([sweep, "-o", self.folder / "a.png"], "a.png", ".html")
        self.refused([sweep, "-o", self.folder / "missing" / "a.html"], "missing")
        self.assertFalse(page.exists())

    def test_a_page_replaces_a_page_only(self):
        page, sweep = self.folder / "own.html", self.records["sweep"]
        page.write_text("<p>mine</p>")
        self.refused([sweep, "-o", page], "own.html", "--force")
        self.assertEqual(page.read_text(), "<p>mine</p>")
        self.assertEqual(run(["explore", str(sweep), "-o", str(page), "--force", "--quiet"]).returncode, 0)
        again = run(["explore", str(self.records["diagram"]), "-o", str(page), "--quiet"])
        self.assertEqual((again.returncode, again.stdout, again.stderr), (0, "", ""))
        self.assertIn("Attractors", page.read_text())


if __name__ == "__main__":
    unittest.main()
