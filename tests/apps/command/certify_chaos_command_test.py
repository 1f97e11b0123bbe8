"""swirl certify --chaos, from outside: certify_chaos_command_test.py SWIRL [EDITS]"""

import itertools
import json
import math
import random
import sys
import unittest

import h5py
import numpy

from certificates import with_new_checksum
from driving import InFolder, document, run, sized

EDITS = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 8  # driving has taken SWIRL
DISK = "--sides disk --alpha 0.3 --beta 0.5 --mu 0 --restitution 1"
SADDLE = "--near=3.14159265358979,-0.132666166440,0.009408000537,0"
POLYGON = "--alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --near=3.14159265,0,-0.12732395,0,-1.66666667"  # tau = pi


class Chaos:
    """What holds of every scene: `command`, without --json, and `scene`, its flags."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.text = run(f"{cls.command} --json").stdout
        cls.found = json.loads(cls.text)

    def transitions(self):
        matrix = numpy.zeros((len(self.found["sets"]),) * 2)
        for covering in self.found["coverings"]:
            matrix[covering["from"] - 1, covering["to"] - 1] = 1
        return matrix

    def test_the_entropy_is_that_of_the_transitions(self):
        chaos = self.found["chaos"]
        self.assertTrue(chaos["proven"])
        radius = max(abs(numpy.linalg.eigvals(self.transitions())))
        self.assertLessEqual(chaos["growth"], radius * (1 + 1e-12))
        self.assertAlmostEqual(chaos["entropy"], math.log(radius), 9)
        self.assertGreater(chaos["entropy"], self.entropy)
        low, high = self.exponent
        self.assertTrue(low < chaos["exponent"] < high, chaos["exponent"])

    def test_points_of_sets_go_where_coverings_say(self):
        """The map itself carries the ends of each set beyond the ends of the next, on different sides."""
        for covering in self.found["coverings"][::sized(1, 8)]:
            first, second = (self.found["sets"][covering[name] - 1] for name in ("from", "to"))
            inverse = numpy.linalg.inv(second["matrix"])
            ends = []
            for q in (-1, 1):
                sides = [0.5] * (len(first["centre"]) - 1)
                point = numpy.array(first["centre"]) + numpy.array(first["matrix"]) @ [q, *sides]
                step = document(f"simulate {self.scene} --point={self.in_full(point)} --collisions 1")["collisions"][0]
                away = []
                for name, centre in zip(self.found["coordinates"], second["centre"]):
                    apart = step["spin" if name == "S" else name] - centre
                    away.append(math.remainder(apart, 2 * math.pi) if name in ("psi", "chi") else apart)
                ends.append((inverse @ away)[0])
            self.assertLess(ends[0] * ends[1], -1, covering)
            self.assertGreater(min(map(abs, ends)), 1, covering)

    def are_apart(self, first, second):
        """By one of the axes of one of the two sets, which are counted from 1."""
        sets = [self.found["sets"][k - 1] for k in (first, second)]
        for own, other in (sets, sets[::-1]):
            inverse = numpy.linalg.inv(own["matrix"])
            reach = abs(inverse @ other["matrix"]).sum(axis=1)
            if max(abs(inverse @ (numpy.array(other["centre"]) - own["centre"])) - reach) > 1:
                return True
        return False

    def test_what_one_set_is_carried_over_lies_apart(self):
        for first in range(1, len(self.found["sets"]) + 1):
            over = [covering["to"] for covering in self.found["coverings"] if covering["from"] == first]
            for a, b in itertools.combinations(over, 2):
                self.assertTrue(self.are_apart(a, b), (a, b))

    def test_it_is_proven_again(self):
        again = document(f"certify --check {self.file('chaos.json', self.text)}")
        count = len(self.found["coverings"])
        self.assertEqual((again["stated"], again["proven"], again["reason"]), (count, count, None))
        self.assertEqual(again["entropy"], self.found["chaos"]["entropy"])

    def test_false_claims_are_refused(self):
        draw = random.Random(7)
        claims = (self.too_much_entropy, self.moved_set, self.removed_covering, self.other_target, self.other_scene,
                  self.narrow_target)
        for i in range(self.edits):
            edited = json.loads(self.text)
            claims[i % len(claims)](edited, draw)
            self.refused(edited)

    def test_what_no_proof_looks_at_can_not_be_stated(self):
        """A scene with more in it than is proven, and sets in other coordinates than those that they are checked in."""
        for key, value in (("corner", 0.01), ("drag", 0.1), ("tangential_restitution", 0.5), ("bogus", 1)):
            edited = json.loads(self.text)
            edited["scene"][key] = value
            self.refused(edited, 2)
        edited = json.loads(self.text)
        edited["coordinates"].reverse()
        self.refused(edited, 2)

    def test_edited_certificates_are_refused(self):
        draw = random.Random(8)
        end = self.text.rindex('"checksum"')
        for _ in range(self.edits):
            place = draw.randrange(end)
            other = draw.choice([c for c in "0123456789.-abc" if c != self.text[place]])
            changed = self.text[:place] + other + self.text[place + 1:]
            self.assertEqual(run(f"certify --check {self.file('edited.json', changed)}").returncode, 2, place)

    def too_much_entropy(self, edited, draw):
        edited["chaos"]["entropy"] *= 1 + 10 ** draw.uniform(-6, 0)
        if draw.random() < 0.5:
            edited["chaos"]["growth"] = math.exp(edited["chaos"]["entropy"]) * (1 + 1e-12)

    def moved_set(self, edited, draw):
        """By three widths: what covered it does so no more."""
        chosen = draw.choice(edited["sets"])
        sign = draw.choice((-1, 1)) * draw.uniform(3, 20)
        for a, row in enumerate(chosen["matrix"]):
            chosen["centre"][a] += sign * row[1]

    def removed_covering(self, edited, draw):
        weighed = [k for k, c in enumerate(edited["coverings"]) if edited["sets"][c["to"] - 1]["weight"] > 0]
        edited["coverings"].pop(draw.choice(weighed))

    def other_target(self, edited, draw):
        """Apart from the true one: the last sets before a cycle meet, and what is carried over one may be over another."""
        covering = draw.choice(edited["coverings"])
        others = [k + 1 for k in range(len(edited["sets"])) if self.are_apart(covering["to"], k + 1)]
        taken = {(c["from"], c["to"]) for c in edited["coverings"]}
        covering["to"] = draw.choice([k for k in others if (covering["from"], k) not in taken])

    def other_scene(self, edited, draw):
        edited["scene"][draw.choice(("alpha", "beta"))] *= 1 + draw.choice((-1, 1)) * draw.uniform(0.05, 0.3)

    def narrow_target(self, edited, draw):
        """A set that is squeezed to a tenth of its height no longer holds the images that it held."""
        chosen = draw.choice(edited["sets"])
        for row in chosen["matrix"]:
            row[1] *= draw.uniform(0.001, 0.01)

    def refused(self, edited, code=3):
        edited.pop("checksum")  # it comes last
        text = with_new_checksum(json.dumps(edited, indent=2).rstrip("}\n") + ",\n  \"checksum\"")
        result = run(f"certify --check {self.file('edited.json', text)}")
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)


class ChaosOfADisk(Chaos, InFolder):
    edits = EDITS
    scene = DISK
    command = f"certify {DISK} {SADDLE} --chaos --link-length 4"
    entropy, exponent = 0.25, (0.3, 0.6)  # swirl lyapunov's: 0.46

    def in_full(self, point):
        """On the level of J, leaving the wall."""
        psi, vt = map(float, point)
        x, y = 0.7 + 0.5 * math.cos(psi), 0.5 * math.sin(psi)
        vn = y - math.sqrt(x * x + y * y - (vt - x) ** 2 + 2 * self.found["J"])
        return f"{psi!r},{float(vn)!r},{vt!r},0"

    def test_bytes_do_not_depend_on_threads(self):
        for threads in sized((1, 3), (3,)):
            self.assertEqual(run(f"{self.command} --json --threads {threads}").stdout, self.text)

    def test_the_table_says_the_bound_and_the_record_has_the_sets(self):
        table = run(f"{self.command} -o sets.h5", cwd=self.folder).stdout
        self.assertIn(f"proven: topological entropy of F >= {self.found['chaos']['entropy']:.6f} per impact", table)
        self.assertIn("not proven", table.splitlines()[-1])
        self.assertLessEqual(max(map(len, table.splitlines())), 120)
        with h5py.File(self.folder / "sets.h5") as record:
            self.assertEqual(record["chaos"].attrs["entropy"], self.found["chaos"]["entropy"])
            self.assertEqual(record["chaos"].attrs["J"], self.found["J"])
            for k, name in enumerate(self.found["coordinates"]):
                self.assertEqual(list(record[f"sets/centre_{name}"]), [one["centre"][k] for one in self.found["sets"]])
                for edge in range(len(self.found["coordinates"])):
                    self.assertEqual(list(record[f"sets/edge{edge + 1}_{name}"]), [one["matrix"][k][edge] for one in self.found["sets"]])
            for name in ("from", "to"):
                self.assertEqual(list(record[f"coverings/{name}"]), [one[name] for one in self.found["coverings"]])
            carried = {name: record[f"carried/{name}"][()] for name in record["carried"]}
            for number in range(1, len(self.found["coverings"]) + 1):  # beyond both ends, and out by no other side
                of_it = carried["covering"] == number
                low, high = (carried["carried_q"][of_it & (carried["q"] == q)] for q in (-1, 1))
                self.assertTrue((low * high < -1).all() and (abs(low) > 1).all() and (abs(high) > 1).all(), number)
                self.assertTrue((abs(carried["carried_side"][of_it & (abs(carried["carried_q"]) <= 1)]) < 1).all(), number)

    def test_where_there_is_none_the_inequality_is_named(self):
        result = run(f"certify {DISK} --near=0,-0.8497,0.5456,0 --chaos --link-length 4")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("no chaos proven: 0 of its multipliers lie outside the unit circle", " ".join(result.stdout.split()))

    def test_what_cannot_be_is_refused(self):
        hexagon = "--sides 6 --alpha 0.3 --beta 0.5"
        for flags, words in ((f"{hexagon} --mu 0 --restitution 1 --all --chaos", "J of a polygon without friction"),
                             (f"{hexagon} --mu 0 --restitution 0.9 --all --chaos", "every motion dies out"),
                             (f"{DISK} --all --chaos", "--near psi,vn,vt,S is wanted"),
                             (f"{hexagon} --mu 0.5 --restitution 1 --chaos", "give one of"),
                             (f"{hexagon} --mu 0.5 --restitution 1 --all --link-length 4", "--link-length goes with --chaos"),
                             (f"{DISK} {SADDLE} --chaos --link-length 1", "--link-length: Value 1 not in range 2 to 40"),
                             (f"{hexagon} --mu 0.5 --restitution 1 --all --chaos --along alpha=0.2:0.4", "--chaos goes with")):
            result = run(f"certify {flags}")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), (flags, result.stderr))
            self.assertIn(words, result.stderr)


class ChaosOfAHexagon(Chaos, InFolder):
    """With friction: five coordinates, and contacts that stick."""
    edits = EDITS if EDITS < 100 else EDITS // 10
    scene = f"--sides 6 {POLYGON.split(' --near')[0]}"
    command = f"certify --sides 6 {POLYGON} --chaos"
    entropy, exponent = 0.2, (1.0, 1.25)  # swirl lyapunov's: 1.128

    def in_full(self, point):
        return ",".join(repr(float(x)) for x in point)


@unittest.skipIf(EDITS < 100, "by night")
class ChaosOfATriangle(ChaosOfAHexagon):
    scene = ChaosOfAHexagon.scene.replace("--sides 6", "--sides 3")
    command = ChaosOfAHexagon.command.replace("--sides 6", "--sides 3")
    entropy, exponent = 0.15, (1.2, 1.5)  # swirl lyapunov's: 1.364


if __name__ == "__main__":
    unittest.main()
