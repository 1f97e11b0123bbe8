"""swirl explore's map and page at length: explore_nightly_test.py SWIRL ROOT"""

import ctypes
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from driving import InFolder, run

ROOT = Path(sys.argv.pop(1)).resolve()
PAGE, TESTS = ROOT / "apps/explore/page", ROOT / "tests/apps/explore"
NODE, CHROMIUM, EMSCRIPTEN = shutil.which("node"), shutil.which("chromium"), shutil.which("em++")

#: sides, alpha, beta, mu, e, law, seed, impacts: every map there is, chaos and cycles, slow and fast swirls.
ORBITS = [(6, 0.4, 0.5, 0.5, 0.9, "poisson", 1, 100_000), (6, 0.3, 0.1, 0.5, 0.9, "poisson", 2, 100_000),
          (4, 0.5, 0.3, 0.3, 0.95, "newton", 3, 20_000), (5, 0.6, 0.8, 0.2, 0.9, "stronge", 4, 20_000),
          (6, 0.4, 0.5, 0, 1, "poisson", 5, 20_000), (0, 0.4, 0.5, 0, 1, "poisson", 1, 20_000),
          (0, 0.4, 1.5, 0.5, 1, "poisson", 6, 20_000), (3, 0.4, 0.5, 0.5, 1, "poisson", 7, 20_000),
          (8, 0.2, 0.5, 0.1, 0.95, "poisson", 8, 20_000)]

#: What the map itself works out. The rest is made of it for people, by the C library's sine and arc tangent.
OF_THE_MAP = {"t", "S", "vertex", "vn", "vt", "flightTime", "p", "q"}
#: Their own rounding, and that of a product or two with them: 1 ulp in either library, 4 in all.
MOST_ULPS = 4


def cube_root(x):
    library = ctypes.CDLL("libm.so.6")
    library.cbrt.restype, library.cbrt.argtypes = ctypes.c_double, [ctypes.c_double]
    return library.cbrt(x)


#: By glibc up to 2.42, whose number the page's map has; rounded correctly they end in 5 and 79.
USUAL_CUBE_ROOTS = {2 / 7: 0.65863375600834939, 3 / 7: 0.75394744112915368}


class WithPage(InFolder):
    def page(self):
        made = run("sweep --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --grid sides=3,4,5,6,8,disk --transient 100 "
                   "--collisions 100 --runs 1 --quiet -o sweep.h5", cwd=self.folder)
        self.assertIn(made.returncode, (0, 3), made.stderr)
        made = run("explore sweep.h5 -o page.html --quiet", cwd=self.folder)
        self.assertEqual(made.returncode, 0, made.stderr)
        return self.folder / "page.html"


@unittest.skipUnless(NODE, "node is not there")
class MapNightly(WithPage):
    def followed(self, sides, alpha, beta, mu, e, law, seed, impacts):
        """A line for compare_orbits.js, of the orbit that the program followed."""
        name = f"orbit{len(list(self.folder.glob('*.csv')))}"
        made = run(f"simulate --sides {sides or 'disk'} --alpha {alpha} --beta {beta} --mu {mu} --restitution {e} --law {law} "
                   f"--seed {seed} --collisions {impacts} --quiet -o {name}.h5", cwd=self.folder)
        self.assertIn(made.returncode, (0, 3), made.stderr)
        made = run(f"show {name}.h5 --group collisions --csv {name}.csv --quiet", cwd=self.folder)
        self.assertEqual(made.returncode, 0, made.stderr)
        (self.folder / f"{name}.h5").unlink()
        return {"csv": str(self.folder / f"{name}.csv"), "seed": seed,
                "scene": {"sides": sides, "alpha": alpha, "beta": beta, "mu": mu, "restitution": e, "law": law}}

    def compared(self, orbits):
        lines = [json.dumps(self.followed(*orbit)) for orbit in orbits]
        made = subprocess.run([NODE, TESTS / "compare_orbits.js", self.page()], input="\n".join(lines), capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        results = [json.loads(line) for line in made.stdout.splitlines()]
        self.assertEqual(len(results), len(orbits))
        return list(zip(orbits, results))

    @unittest.skipUnless(all(cube_root(x) == root for x, root in USUAL_CUBE_ROOTS.items()), "this C library has another cbrt")
    def test_orbits_are_the_programs_to_the_last_bit(self):
        for orbit, found in self.compared(ORBITS):
            with self.subTest(orbit):
                self.assertEqual((found["impacts"], found["expected"]), (orbit[-1], orbit[-1]))
                self.assertEqual(OF_THE_MAP & set(found["differ"]), set())
                self.assertLessEqual(max(found["ulps"].values(), default=0), MOST_ULPS)

    def test_a_disk_that_comes_to_roll_ends_as_the_program_says(self):
        [(_, found)] = self.compared([(0, 0.4, 0.5, 0.5, 0.9, "poisson", 1, 1000)])
        self.assertGreater(found["impacts"], 100)
        self.assertEqual((found["impacts"], found["outcome"], found["goesOn"]), (found["expected"], "in-contact", False))

    def test_an_orbit_is_the_programs_until_it_comes_to_lie_on_the_wall(self):
        """Motion in contact asks the C library for sines, of which the last digits differ."""
        [(_, found)] = self.compared([(4, 0.4, 0.2, 0.2, 0.3, "poisson", 2, 2000)])
        made = run("simulate --sides 4 --alpha 0.4 --beta 0.2 --mu 0.2 --restitution 0.3 --seed 2 --collisions 2000 --json", cwd=self.folder)
        first = json.loads(made.stdout)["contacts"][0]["t_start"]
        self.assertGreater(found["first"], first)

    @unittest.skipUnless(EMSCRIPTEN, "em++ is not there (Debian's emscripten)")
    def test_the_artefact_is_what_its_sources_give(self):
        shipped = (PAGE / "swirl_map.sha256").read_text().split()[0]
        made = subprocess.run([sys.executable, "-B", PAGE / "build_map.py", self.folder / "wasm"], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        built = hashlib.sha256((self.folder / "wasm/swirl_map.wasm").read_bytes()).hexdigest()
        version = re.search(r"\d+\.\d+\.\d+", subprocess.run([EMSCRIPTEN, "--version"], capture_output=True, text=True).stdout)[0]
        if version != "3.1.6":
            self.skipTest(f"emscripten {version} writes other bytes than 3.1.6 of Debian 12")
        self.assertEqual(built, shipped)


@unittest.skipUnless(NODE and CHROMIUM, "node or chromium is not there (Debian's nodejs, chromium)")
class BrowserNightly(WithPage):
    def test_the_page_in_chromium(self):
        for name, command in (("map", "sweep --sides 6 --mu 0.5 --restitution 0.9 --grid alpha=0.3:0.7:9 --grid beta=0.1:0.9:9 --runs 4"),
                              ("diagram", "bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.95 --along alpha=0.36:0.4:9 --branches"),
                              ("grid", "sweep --sides 6 --restitution 0.9 --grid alpha=0.4:0.6:3 --grid beta=0.3:0.5:3 --grid mu=0.5,0.1")):
            made = run(f"{command} --quiet -o {name}.h5", cwd=self.folder)
            self.assertIn(made.returncode, (0, 3), made.stderr)
            made = run(f"explore {name}.h5 -o {name}.html --quiet", cwd=self.folder)
            self.assertEqual(made.returncode, 0, made.stderr)
        shots = Path(os.environ.get("SWIRL_SCREENSHOTS", self.folder))
        made = subprocess.run([NODE, TESTS / "drive_page.js", self.folder / "map.html", self.folder / "diagram.html", shots,
                               self.folder / "grid.html"],
                              capture_output=True, text=True, timeout=900)
        print(made.stdout)
        self.assertEqual(made.returncode, 0, made.stdout + made.stderr)


if __name__ == "__main__":
    unittest.main()
