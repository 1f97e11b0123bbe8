"""swirl animate, and the motion behind it: animate_test.py SWIRL ROOT"""

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy
from PIL import Image

from driving import examples_of, run, start, with_records

ROOT = str(Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(Path(ROOT) / "notebooks-export"))

from swirl_figures import RecordError, open_record
from swirl_figures.film import FRAME_NAMES, Film
from swirl_figures.motion import motion_of
from swirl_figures.physical import units_of

SCENE = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
RECORDS = {
    "orbit": f"simulate {SCENE} --collisions 60",
    "metres": "simulate --sides 6 --container-radius 2 --polygon-radius 0.8 --swirl-radius 1 --swirl-rate 4 --mu 0.5 --restitution 0.9 "
              "--time 6",
    "some": f"simulate {SCENE} --collisions 60 --every 10",
    "wall": "simulate --sides disk --alpha 0.1 --beta 0.05 --mu 0.4 --restitution 0.3 --time 60 --sample 0.02",
    "orbits": f"orbits {SCENE} --max-period 2 --max-time 3 --starts 100",
    "verdict": f"classify {SCENE} --transient 100 --collisions 100",
}


WithRecords = with_records(RECORDS)


class Motion(WithRecords):
    def outermost(self, record, times):
        """The largest distance of a vertex from the container's centre."""
        scene = record.scene()
        x, y, angle, _ = motion_of(record).at(times)
        corners = angle[:, None] + 2 * numpy.pi * numpy.arange(6) / 6
        place = (x + 1j * y)[:, None] + scene["alpha"] * numpy.exp(1j * corners)
        return abs(place - scene["beta"] * numpy.exp(1j * times)[:, None]).max(axis=1)

    def test_is_that_of_the_record_and_stays_in_the_container(self):
        record = open_record(self.records["orbit"])
        motion = motion_of(record)
        t = record.column("collisions", "t")
        for name, values in zip(("x", "y", "angle"), motion.at(t)):
            self.assertLess(abs(values - record.column("collisions", name)).max(), 1e-12, name)
        self.assertLess(abs(self.outermost(record, t) - 1).max(), 1e-12)  # each impact is one
        self.assertLess(self.outermost(record, numpy.linspace(motion.first, motion.last, 20_000)).max(), 1 + 1e-9)

    def test_goes_on_on_the_wall_where_there_are_samples(self):
        record = open_record(self.records["wall"])
        motion = motion_of(record)
        start_of_it, end = (record.column("contacts", name) for name in ("t_start", "t_end"))
        times = numpy.linspace(start_of_it[0] + 0.03, end[-1] - 0.03, 50)
        x, y, _, spin = motion.at(times)
        away = abs(x + 1j * y - 0.05 * numpy.exp(1j * times))
        self.assertLess(abs(away - 0.9).max(), 1e-4)  # between samples, 0.02 apart, the wall is round: 0.02²/8
        self.assertTrue(numpy.isfinite(spin).all())

    def test_a_cycle_closes_and_strikes_the_wall_when_it_should(self):
        record = open_record(self.records["orbits"])
        periods, return_times = record.column("orbits", "period"), record.column("orbits", "return_time")
        unstable = record.column("orbits", "stability") == "unstable"
        self.assertTrue((unstable & (periods == 2)).any() and (unstable & (periods == 1)).any())
        scene = record.scene()
        for orbit, (period, return_time) in enumerate(zip(periods, return_times), 1):
            motion = motion_of(record, orbit)
            times = numpy.linspace(0, 3 * return_time, 3001)[:-1]
            times = times[times < motion.last - return_time]
            x, y, angle, spin = motion.at(times)
            later = motion.at(times + return_time)
            turned = (x + 1j * y) * numpy.exp(1j * return_time)
            self.assertLess(abs(turned - (later[0] + 1j * later[1])).max(), 1e-9)
            self.assertLess(numpy.nanmax(abs(spin - later[3])[1:-1]), 1e-9)
            vertices = (later[2] - angle - return_time) / (2 * numpy.pi / 6)  # by whole vertices, seen from the swirl
            self.assertLess(abs(vertices - vertices.round()).max(), 1e-9)
            corners = angle[:, None] + 2 * numpy.pi * numpy.arange(6) / 6
            place = (x + 1j * y)[:, None] + scene["alpha"] * numpy.exp(1j * corners)
            reach = abs(place - scene["beta"] * numpy.exp(1j * times)[:, None]).max(axis=1)
            self.assertLess(reach.max(), 1 + 1e-9, (orbit, period))
            self.assertGreater(reach.max(), 0.999)

    def test_a_gap_is_a_gap(self):
        motion = motion_of(open_record(self.records["some"]))
        values = motion.at(numpy.linspace(motion.first, motion.last, 500))[0]
        self.assertTrue(0.05 < numpy.isfinite(values).mean() < 0.5)


class Films(WithRecords):
    def pictures(self, file):
        with Image.open(file) as film:
            return film.n_frames, film.size, film.info

    def test_the_helps_example_makes_a_film_that_is_replaced_by_the_same(self):
        examples = examples_of("animate")
        self.assertEqual(len(examples), 2)
        with tempfile.TemporaryDirectory() as folder:
            contents = set()
            for example in [*examples, examples[-1]]:
                result = run(example, cwd=folder)
                self.assertEqual((result.returncode, result.stderr), (0, ""), example)
                for film in Path(folder).glob("*.gif"):
                    contents.add(film.read_bytes())
            count, size, info = self.pictures(Path(folder) / "orbit.gif")
        self.assertEqual((count, size, info["duration"], info["loop"], len(contents)), (20, (800, 400), 100, 0, 1))

    def test_pictures_change_with_time_and_frame(self):
        record = open_record(self.records["orbits"])
        pictures = {frame: [picture.copy() for picture in Film(record, frame, 1, None, None, 3).pictures()]
                    for frame in FRAME_NAMES}
        for before, after in zip(pictures["co-rotating"], pictures["co-rotating"][1:]):
            self.assertGreater((before != after).any(axis=2).sum(), 500)
        for one, other in (("container", "laboratory"), ("laboratory", "co-rotating"), ("container", "co-rotating")):
            self.assertGreater((pictures[one][1] != pictures[other][1]).any(axis=2).sum(), 500)

    def test_of_a_scene_in_metres_axes_clock_and_range_are_in_si(self):
        record = open_record(self.records["metres"])
        plain, physical = (Film(record, "container", None, begin, end, 3, units)
                           for begin, end, units in ((4, 20, None), (1, 5, units_of(record))))  # omega_s = 4/s
        labels = [axis.get_label_text() for axes in physical._figure.axes for axis in (axes.xaxis, axes.yaxis)]
        self.assertEqual([label.replace("$", "") for label in labels], ["x [m]", "y [m]", "time t [s]", "spin S = \\omega_p/\\omega_s"])
        for one, other in zip(plain._times, physical._times):
            self.assertAlmostEqual(one, other, delta=1e-12)
        physical._set(physical._times[-1])
        self.assertEqual(physical._clock.get_text(), "$t$ = 5 s")
        with self.assertRaisesRegex(RecordError, "from = -5: the record's times run from 0 to"):
            Film(record, "container", None, -5, None, 3, units_of(record))
        result = run(f"animate {self.records['orbit']} -o {self.folder}/a.gif --units physical")
        self.assertEqual((result.returncode, result.stderr.count("\n")), (2, 1), result.stderr)
        self.assertIn("has no units", result.stderr)

    def test_an_mp4(self):
        if shutil.which("ffmpeg") is None:
            self.skipTest("ffmpeg is not installed")
        file = self.folder / "orbit.mp4"
        result = run(f"animate {self.records['orbits']} --orbit 1 -o {file} --duration 0.5 --fps 10 --json")
        self.assertEqual(result.returncode, 0, result.stderr)
        content = file.read_bytes()
        self.assertEqual(content[4:8], b"ftyp")
        self.assertIn(b"made by swirl animate", content)

    def test_without_ffmpeg_one_line_says_what_to_install(self):
        bare = self.folder / "bare"
        bare.mkdir()
        result = run(f"animate {self.records['orbit']} -o {self.folder}/none.mp4", env={**os.environ, "PATH": str(bare)})
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, "swirl: an .mp4 needs ffmpeg, the Debian package of that name; a .gif does not\n")

    def test_ffmpeg_that_fails_leaves_nothing(self):
        bad = self.folder / "bad"
        bad.mkdir()
        (bad / "ffmpeg").write_text("#!/bin/sh\necho no encoder >&2\nexit 1\n")
        (bad / "ffmpeg").chmod(0o755)
        before = sorted(self.folder.rglob("*"))
        result = run(f"animate {self.records['orbit']} -o {self.folder}/none.mp4 --duration 1 --fps 5",
                     env={**os.environ, "PATH": f"{bad}:/usr/bin:/bin"})
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (4, 1), result.stderr)
        self.assertIn("no encoder", result.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before)


class BadInput(WithRecords):
    def test_is_one_line(self):
        before = sorted(self.folder.rglob("*"))
        for name, arguments, mention in (
                ("orbit", "-o a.avi", "its suffix is none of .mp4, .gif"), ("orbit", "-o a.gif --fps 0", "fps = 0: allowed are 1 to 60"),
                ("orbit", "-o a.gif --duration nan", "duration = nan"), ("orbit", "-o a.gif --frame sky", "frame = sky: allowed are container"),
                ("orbits", "-o a.gif --orbit x", "orbit = x"), ("orbit", "-o a.gif --orbit 1", "is of one orbit, that of swirl simulate"),
                ("orbit", "orbit.h5 -o a.gif", "record: at most 1 required but received 2"),
                ("orbit", "-o a.gif --from now", "from = now"),
                ("verdict", "-o a.gif", "no orbit to be shown in motion")):
            result = run(f"animate {self.records[name]} {arguments}", cwd=self.folder)
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
            self.assertIn(mention, result.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_what_the_record_does_not_hold(self):
        for name, orbit, begin, end, mention in (
                ("orbit", None, -5, None, "from = -5: the record's times run from 0 to"), ("orbit", None, 9, 5, "to = 5: must be after from = 9"),
                ("orbit", None, None, 1e9, r"to = 1e\+09"), ("orbits", 99999, None, None, "orbit = 99999: .* holds"),
                ("some", None, 1.5, 1.6, "the record tells nothing between these times")):
            with self.assertRaisesRegex(RecordError, mention):
                Film(open_record(self.records[name]), "container", orbit, begin, end, 3)

    def test_what_leads_through_contact_is_refused(self):
        from swirl_figures.motion import _flights_of_cycle
        points = {"psi": numpy.array([0.0, 0.3]), "vn": numpy.array([-0.5, -0.2]), "vt": numpy.array([0.1, 0.2]),
                  "S": numpy.array([0.0, 1.0])}
        self.assertIsNone(_flights_of_cycle(points, {"alpha": 0.4, "beta": 0.5}, 3.0))
        with self.assertRaises(RecordError):
            motion_of(open_record(self.records["orbits"]), 0)


class Interrupted(WithRecords):
    def test_leaves_nothing(self):
        for suffix in ("mp4",) if shutil.which("ffmpeg") else ("gif",):
            before = sorted(self.folder.rglob("*"))
            process = start(f"animate {self.records['orbit']} -o {self.folder / f'cut.{suffix}'} --duration 300 --fps 30",
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            time.sleep(1.5)
            process.send_signal(signal.SIGINT)
            output, errors = process.communicate(timeout=60)
            self.assertEqual((process.returncode, output, errors), (130, "", ""), suffix)
            self.assertEqual(sorted(self.folder.rglob("*")), before)


if __name__ == "__main__":
    unittest.main()
