"""Random command lines, made from good ones by mutation: mutated_arguments_test.py SWIRL [COUNT]

Each of COUNT lines (50 unless given) is answered (0; 3 with a document that says which ending), or refused by exit 2 with one
line, nothing on standard output and no file."""

import random
import subprocess
import sys
import unittest

from driving import SWIRL, InFolder

COUNT = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 50
SCENE = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
SHORT = "--transient 50 --collisions 100"

LINES = [line.split() for line in (
    f"simulate {SCENE} --collisions 20 --skip 3 --every 2 -o a.h5",
    f"simulate {SCENE} --time 3 --sample 0.1 --json",
    "simulate --scene scene.toml --x 0.4 --y 0.1 --vx 0.1 --spin 1 --collisions 9",
    f"simulate {SCENE} --point=-0.0829,0.028,-0.5552,0.8908,-0.9783 --accuracy quad --collisions 5",
    f"classify {SCENE} {SHORT} --threshold 1e-6 --seed 3 --json",
    f"classify {SCENE} {SHORT} --runs 2 --speed 0.2 -o a.h5",
    "classify --series m.csv --column S --time t --rows samples --noise 0.01",
    f"recurrence {SCENE} {SHORT} --threshold 0.1,0.2 --dimension 2 --delay 1 --norm maximum --theiler 1 --strict",
    "recurrence --series m.csv --recurrence-rate 0.1 --image 8 --json",
    f"spectrum {SCENE} {SHORT} --bins 256 --segments 2 --overlap 0.5 --window hann",
    f"lyapunov {SCENE} {SHORT}",
    f"orbits {SCENE} --period 1 --starts 5 --trajectories 1 --collisions 100 --threads 1",
    "ramp --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --along beta=0.4:0.41 --duration 20 --transient 20 --windows 2",
    f"bifurcate --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --along beta=0.4:0.6:2 --starts 1 {SHORT}",
    f"sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.2:0.8:2 {SHORT} -o a.h5",
    f"describe {SCENE} --max-time 5 --json",
    "plot record.h5 -o a.svg --kind spin --quiet",
)]
WORDS = sorted({word for line in LINES for word in line} | set("simulate classify tour plot --help --version -o".split()))
VALUES = ["", "-", "--", "---", "=", "-1", "0", "00", "010", "0x10", "1e-300", "-1e-300", "nan", "inf", "-inf", "1e999", "abc",
          "1,2", ",", ":", "NaN:1:2", "1:2", "\x1b[31m", "é", "a b", "'", '"', "%s", "{}", "../x", "/dev/null", ".", "--json",
          "--json=", "--output=", "-h=", "[1,2]", "disk", "mu=0.2:0.8:1", "record.h5", "m.csv", "scene.toml"]


def mutated(line, generator):
    words = list(line)
    for _ in range(generator.choice((1, 1, 2, 3))):
        place = generator.randrange(len(words)) if words else 0
        kind = generator.randrange(8)
        if kind == 0 or not words:
            words.insert(place, generator.choice(WORDS + VALUES))
        elif kind == 1:
            del words[place]
        elif kind == 2:
            words.insert(place, words[place])
        elif kind == 3:
            other = generator.randrange(len(words))
            words[place], words[other] = words[other], words[place]
        elif kind == 4:
            words[place] = generator.choice(VALUES)
        elif kind == 5:
            words[place] = words[place][:generator.randrange(len(words[place]) + 1)]
        elif kind == 6:
            cut = generator.randrange(len(words[place]) + 1)
            words[place] = words[place][:cut] + generator.choice("=-,.:0 9e\t/x") + words[place][cut:]
        elif place + 1 < len(words):
            words[place:place + 2] = ["=".join(words[place:place + 2])]
    return words


class MutatedArguments(InFolder):
    def test_each_is_answered_or_refused_in_one_line(self):
        generator = random.Random(20261122)
        codes = {0: 0, 2: 0, 3: 0}
        given = {"m.csv", "scene.toml", "record.h5"}
        self.series("m.csv", [0.1 * (i % 7) for i in range(100)], [0.1 * i for i in range(100)])
        self.file("scene.toml", "[scene]\nsides = 6\nalpha = 0.4\nbeta = 0.5\nmu = 0.5\nrestitution = 0.9\n")
        subprocess.run([SWIRL, *f"simulate {SCENE} --quiet -o record.h5".split()], cwd=self.folder, check=True)
        contents = {name: (self.folder / name).read_bytes() for name in given}
        for _ in range(COUNT):
            words = mutated(generator.choice(LINES), generator)
            result = subprocess.run([SWIRL, *words], capture_output=True, cwd=self.folder, timeout=120,
                                    stdin=subprocess.DEVNULL)
            self.assertIn(result.returncode, codes, (words, result.stderr))
            codes[result.returncode] += 1
            left = {path.name for path in self.folder.iterdir()} - given
            if result.returncode == 2:
                self.assertEqual((result.stdout, result.stderr.count(b"\n"), left), (b"", 1, set()), (words, result.stderr))
                self.assertLess(len(result.stderr), 1000, words)
            for name in left:
                (self.folder / name).unlink()
            for name, content in contents.items():
                if "--force" not in words:
                    self.assertEqual((self.folder / name).read_bytes(), content, words)
        print(f"{COUNT} lines: exit codes {codes}")
        self.assertGreater(codes[2], COUNT // 4)


if __name__ == "__main__":
    unittest.main()
