"""What `swirl` reads and writes: no input is lost, no other file replaced, no permission changed. files_test.py SWIRL"""

import os
import stat
import subprocess
import time
import unittest

import h5py

from driving import SWIRL, InFolder, run, start

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
SHORT = f"{HEXAGON} --transient 100 --collisions 100"
SWEEP = "sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.2:0.8:3 --transient 100 --collisions 64"
SCENE = "[scene]\nsides = 6\nalpha = 0.4\nbeta = 0.5\nmu = 0.5\nrestitution = 0.9\n"


class Files(InFolder):
    def refused(self, arguments, *mentions, code=2, **options):
        result = run(arguments, **options)
        self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (code, "", 1),
                         (arguments, result.stderr))
        for mention in mentions:
            self.assertIn(mention, result.stderr)

    def done(self, arguments):
        result = run(arguments)
        self.assertEqual(result.returncode, 0, (arguments, result.stderr))

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())


class Inputs(Files):
    """An output that leads to an input is refused, --force or not, by every way in which names lead to files."""

    def leading_to(self, path):
        link, hard = self.folder / "link.h5", self.folder / "hard.h5"
        link.symlink_to(path)
        os.link(path, hard)
        return path, self.folder / "." / path.name, link, hard

    def check(self, path, commands):
        kept = path.read_bytes()
        for output in self.leading_to(path):
            for command in commands:
                for force in ("", " --force"):
                    self.refused(f"{command} -o {output}{force}", "input", str(path))
        self.assertEqual(path.read_bytes(), kept)
        self.assertEqual(self.names(), sorted([path.name, "link.h5", "hard.h5"]))

    def test_a_series(self):
        path = self.series("measured.csv", [0.1 * (i % 7) for i in range(200)])
        self.check(path, [f"{command} --series {path} --quiet" for command in ("classify", "recurrence", "spectrum")])

    def test_a_second_series(self):
        path = self.series("measured.csv", [0.1 * (i % 7) for i in range(200)])
        other = self.series("other.csv", [0.1 * (i % 5) for i in range(200)])
        self.refused(f"recurrence --series {path} --cross {other} --threshold 0.1 -o {other} --force", "input")

    def test_a_scene_file(self):
        path = self.file("scene.toml", SCENE)
        grid = "--grid mu=0.2:0.8:3"
        self.check(path, [f"{command} --scene {path}" for command in
                          ("simulate", "classify", "classify --runs 2", "recurrence", "spectrum", "lyapunov", "orbits",
                           "describe", f"sweep {grid}", "bifurcate --along mu=0.4:0.6:2")])

    def test_a_record(self):
        path = self.folder / "orbit.h5"
        self.done(f"simulate {HEXAGON} --collisions 100 -o {path}")
        self.check(path, [f"{command} {path} --transient 0" for command in ("recurrence", "spectrum")] +
                   [f"classify {path}"])

    def test_standard_input(self):
        path = self.series("measured.csv", [0.1 * (i % 7) for i in range(200)])
        kept = path.read_bytes()
        with path.open() as opened:
            self.refused(f"spectrum --series - -o {path} --force", "standard input", stdin=opened)
        self.assertEqual(path.read_bytes(), kept)

    def test_what_is_written_meanwhile(self):
        for name in (".a.h5.partial", ".a.h5.journal"):
            path = self.file(name, SCENE)
            self.refused(f"simulate --scene {path} -o {self.folder}/a.h5", "input", name)
            self.assertEqual(path.read_text(), SCENE)


class Replaced(Files):
    def test_only_a_record_of_the_same_command_is_replaced_without_force(self):
        record = self.folder / "a.h5"
        commands = {"simulate": f"{HEXAGON} --collisions 5", "classify": SHORT, "lyapunov": SHORT, "describe": HEXAGON}
        for first, flags in commands.items():
            self.done(f"{first} {flags} -o {record} --force --quiet")
            self.done(f"{first} {flags} -o {record} --quiet")
            with h5py.File(record) as file:
                self.assertEqual(file.attrs["command"], first)
            kept = record.read_bytes()
            for other, other_flags in commands.items():
                if other != first:
                    self.refused(f"{other} {other_flags} -o {record}", "a.h5", f"a record of {first}", "--force")
            self.assertEqual(record.read_bytes(), kept)

    def test_classify_replaces_its_own_of_each_form(self):
        record = self.folder / "mode.h5"
        self.done(f"classify {SHORT} -o {record} --quiet")
        self.done(f"classify {SHORT} --runs 2 -o {record} --quiet")
        series = self.series("measured.csv", [0.1 * (i % 7) for i in range(200)])
        self.done(f"classify --series {series} -o {record} --quiet")

    def test_what_is_no_record_is_replaced_with_force_only(self):
        for name, text in (("measured.txt", "t,S\n0,1\n1,2\n"), ("empty.h5", "")):
            path = self.file(name, text)
            self.refused(f"simulate {HEXAGON} -o {path}", name, "no record", "--force")
            self.assertEqual(path.read_text(), text)
            self.done(f"simulate {HEXAGON} -o {path} --force --quiet")
            with h5py.File(path) as file:
                self.assertEqual(file.attrs["command"], "simulate")

    def test_a_finished_sweep_stays(self):
        record = self.folder / "sweep.h5"
        self.done(f"{SWEEP} -o {record} --quiet")
        kept = record.read_bytes()
        self.refused(f"simulate {HEXAGON} -o {record}", "a record of sweep", "--force")
        self.refused(f"{SWEEP} --seed 2 -o {record}", "seed", "--force")
        self.assertEqual(record.read_bytes(), kept)
        self.done(f"{SWEEP} --seed 2 -o {record} --force --quiet")
        self.assertNotEqual(record.read_bytes(), kept)
        self.done(f"{SWEEP} -o {record} --force --quiet")
        self.assertEqual(record.read_bytes(), kept)

    def test_permissions_stay(self):
        record = self.folder / "a.h5"
        for mode in (0o600, 0o640, 0o664):
            self.done(f"simulate {HEXAGON} -o {record} --quiet")
            record.chmod(mode)
            self.done(f"simulate {HEXAGON} --seed 2 -o {record} --quiet")
            self.assertEqual(stat.S_IMODE(record.stat().st_mode), mode)

    def test_a_figure_replaces_a_figure_of_plot_only(self):
        record, figure = self.folder / "a.h5", self.folder / "a.svg"
        self.done(f"simulate {HEXAGON} -o {record} --quiet")
        figure.write_text("<svg>drawn by hand</svg>")
        figure.chmod(0o600)
        self.refused(f"plot {record} -o {figure}", "a.svg", "--force")
        self.assertEqual(figure.read_text(), "<svg>drawn by hand</svg>")
        self.done(f"plot {record} -o {figure} --force --quiet")
        self.done(f"plot {record} -o {figure} --quiet")
        self.assertEqual(stat.S_IMODE(figure.stat().st_mode), 0o600)
        hard = self.folder / "hard.svg"
        os.link(record, hard)
        self.refused(f"plot {record} -o {hard} --force", "the record itself")


class UnwritableRecords(Files):
    def test_a_finished_sweep_that_cannot_write_its_record_exits_with_4_and_keeps_its_runs(self):
        inner = self.folder / "results"
        inner.mkdir()
        record = inner / "a.h5"
        process = start(f"{SWEEP} --runs 40 --threads 1 -o {record}", stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                        text=True)
        while process.poll() is None and not (inner / ".a.h5.journal").exists():
            time.sleep(0.001)
        record.mkdir()  # what has the record's name now can't be replaced by a file
        output, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, output), (4, ""), errors)
        self.assertRegex(errors, r"^swirl: [^\n]*a\.h5[^\n]*runs are kept[^\n]*\n$")
        record.rmdir()
        self.assertIn(".a.h5.journal", [path.name for path in inner.iterdir()])
        again = run(f"{SWEEP} --runs 40 --threads 1 -o {record} --quiet")
        self.assertEqual((again.returncode, [path.name for path in inner.iterdir()]), (0, ["a.h5"]), again.stderr)

    def test_a_record_that_can_be_seen_to_be_unwritable_is_refused_before_any_work(self):
        folder = self.folder / "a.h5"
        folder.mkdir()
        self.refused(f"{SWEEP} -o {folder}", "a.h5")
        self.assertEqual(self.names(), ["a.h5"])

    def test_beyond_the_limit_of_a_files_size_it_exits_with_4_and_leaves_nothing(self):
        for limit in (4, 40):
            command = f"ulimit -f {limit}; exec {SWIRL} simulate {HEXAGON} --collisions 50000 -o {self.folder}/a.h5"
            result = subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=60)
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (4, 1), result.stderr)
            self.assertEqual(self.names(), [])


if __name__ == "__main__":
    unittest.main()
