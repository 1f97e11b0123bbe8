"""What a measured file is taken for, and what is said of it: reading_test.py SWIRL"""

import json
import math
import random
import unittest

import xarray

from driving import InFolder, document, run


class Reading(InFolder):
    def rows(self, name, header, rows):
        return self.file(name, "\n".join([header] + [",".join(str(v) for v in row) for row in rows]) + "\n")

    def refused(self, arguments, *mentions):
        result = run(arguments)
        self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1),
                         (arguments, result.stderr))
        for mention in mentions:
            self.assertIn(mention, result.stderr)
        return result.stderr

    def notes(self, arguments):
        return "\n".join(document(arguments)["series"]["notes"])


class Times(Reading):
    def film(self, header="frame,th", lost=(), spin=0.35):
        """12° a frame is the swirl's turn; S swings about its mean as an angle's does, whole periods of it."""
        return self.rows("film.csv", header, [(i, f"{(12 * spin * i + 40 * math.sin(2 * math.pi * i / 90)) % 360:.3f}")
                                              for i in range(900) if i not in lost])

    def test_lost_frames_count_where_frames_are_a_column(self):
        noise = random.Random(2)
        lost = {i for i in range(1, 899) if noise.random() < 0.034}
        for header, flags in (("frame,th", ""), ("FRAME,th", ""), ("Frame#,th", "")):
            found = document(f"classify --series {self.film(header, lost)} --angle th --degrees "
                             f"--swirl-rate {2 * math.pi / 30!r} {flags}")
            self.assertEqual((found["series"]["time"], found["series"]["rows"]), (header.split(",")[0], 900 - len(lost)))
            self.assertAlmostEqual(found["mean_S"], 0.35, delta=2e-3)
        found = document(f"classify --series {self.film(lost=lost)} --angle th --degrees --fps 30 --swirl-rate 60rpm")
        self.assertAlmostEqual(found["mean_S"], 0.35, delta=2e-3)
        self.assertAlmostEqual(found["series"]["spacing"], 1 / 30, delta=1e-12)

    def test_frames_a_second_go_with_frames_alone(self):
        file = self.film()
        self.refused(f"classify --series {file} --angle th --swirl-rate 1Hz", "needs --fps")
        clock = self.rows("t.csv", "t,th", [(i / 30, i) for i in range(100)])
        self.refused(f"classify --series {clock} --angle th --fps 30", "has times, column t")
        self.refused(f"classify --series {clock} --angle th --fps 30 --time t", "does not count frames")
        self.refused(f"classify --series {file} --angle th --fps 0", "fps = 0")
        self.refused(f"recurrence --series {file} --angle th --fps 3 --spacing 2", "give one")
        bare = self.rows("bare.csv", "th", [(f"{0.1 * i:.3f}",) for i in range(600)])
        self.assertAlmostEqual(document(f"classify --series {bare} --angle th --fps 30 --swirl-rate 3")["mean_S"], 1, delta=1e-3)

    def test_an_age_is_a_time_and_what_else_rises_is_said(self):
        file = self.rows("core.csv", "Depth [m],Value [permil],Age [yr]",
                         [(0.5 * i, f"{math.sin(0.3 * i):.2f}", f"{10 * i + 0.01 * i * i:.2f}") for i in range(90)])
        found = document(f"recurrence --series {file} --threshold 0.1")["series"]
        self.assertEqual((found["time"], found["column"]), ("Age [yr]", "Value [permil]"))
        self.assertIn("Depth [m] rises too", "".join(found["notes"]))
        other = self.rows("other.csv", "count,S", [(3 * i, i % 5) for i in range(90)])
        found = document(f"recurrence --series {other} --threshold 0.1")["series"]
        self.assertEqual((found["time"], found["column"]), ("", "S"))
        self.assertIn("count rises: --time NAME", "".join(found["notes"]))
        text = run(f"recurrence --series {other} --threshold 0.1").stdout
        self.assertIn("note: no column is named as times: rows are counted, though count rises", text)

    def test_a_film_with_a_few_rounded_times_is_a_film(self):
        times, t = [], 0.0
        for i in range(3000):
            times.append(t)
            t = round(t + (0.105 if i % 81 == 40 else 0.1), 3)
        file = self.series("f.csv", [math.sin(0.05 * i) + math.sin(0.05 * 1.618 * i) for i in range(3000)], times)
        self.assertEqual(document(f"classify --series {file}")["settings"]["rows"], "samples")
        self.assertEqual(document(f"classify --series {file} --rows impacts")["settings"]["rows"], "impacts")
        self.refused(f"spectrum --series {file} --rows both", "impacts, samples")

    def test_a_camera_that_is_too_slow_is_told(self):
        file = self.rows("slow.csv", "t,th", [(i / 30, f"{(0.1 * i) % 6:.2f}") for i in range(600)])
        flags = f"classify --series {file} --angle th"
        for rate, symmetry, slow in (("14Hz", 1, False), ("16Hz", 1, True), ("6Hz", 3, True), ("4Hz", 3, False)):
            self.assertEqual("too slow" in self.notes(f"{flags} --swirl-rate {rate} --symmetry {symmetry}"), slow, rate)


class Bodies(Reading):
    def two(self, header="frame,particle,x,y", interleaved=True):
        order = [(i, p) for i in range(600) for p in (1, 3)] if interleaved else [(i, p) for p in (1, 3) for i in range(600)]
        return self.rows("two.csv", header,
                         [(i, p, f"{math.cos(0.01 * p * i):.6f}", f"{math.sin(0.01 * p * i):.6f}") for i, p in order])

    def test_several_bodies_are_refused_with_their_ids(self):
        for interleaved in (True, False):
            file = self.two(interleaved=interleaved)
            said = self.refused(f"recurrence --series {file} --position x y", "2 bodies", "particle = 1, 3")
            self.assertIn("--where particle=1 takes one, --each particle all", said)
            found = document(f"inspect {file}")
            self.assertEqual((found["bodies"], found["body_column"], found["time"]), (["1", "3"], "particle", "frame"))
        self.refused(f"recurrence --series {self.two('frame,kind,x,y')} --position x y", "kind = 1, 3")  # by its values alone

    def test_where_takes_one_and_each_all(self):
        file = self.two()
        rate = "--mark x y --swirl-rate 0.01"
        one = document(f"classify --series {file} {rate} --where particle=3")
        self.assertEqual((one["series"]["body"], one["series"]["rows"], one["mode"]), ("3", 600, "steady"))
        self.assertAlmostEqual(one["mean_S"], 3, delta=1e-3)
        self.assertEqual(document(f"classify --series {file} {rate} --where 2=3.0"),
                         one | {"series": one["series"] | {"body": "3.0"}})
        both = json.loads(run(f"classify --series {file} {rate} --each particle --json").stdout)["bodies"]
        self.assertEqual([b["series"]["body"] for b in both], ["1", "3"])
        self.assertEqual(both[1], one)
        for command in ("spectrum", "recurrence"):
            every = json.loads(run(f"{command} --series {file} {rate} --each particle --json").stdout)["bodies"]
            self.assertEqual([b["series"]["body"] for b in every], ["1", "3"])
        self.assertIn("body 3, column x, y", run(f"classify --series {file} {rate} --each particle").stdout)
        self.refused(f"classify --series {file} {rate} --where particle=2", "its values are: 1, 3")
        self.refused(f"classify --series {file} {rate} --where particle", "COLUMN=VALUE")
        self.refused(f"classify --series {file} {rate} --each particle -o {self.folder}/a.h5", "--where takes one")

    def test_of_bodies_that_are_seen_too_short_the_others_are_judged(self):
        file = self.rows("f.csv", "frame,track,th", [(i, 1, 0.1 * i) for i in range(600)] + [(i, 2, 0.1 * i) for i in range(1)] +
                         [(i, 3, 0.1 * i) for i in range(2)])
        result = run(f"classify --series {file} --angle th --each track --json")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads(result.stdout)["bodies"]
        self.assertEqual(found[0]["mode"], "steady")
        self.assertEqual([("refused" in b, b["series"]["body"]) for b in found], [(False, "1"), (True, "2"), (True, "3")])

    def test_a_record_keeps_which_body_it_is_of(self):
        record = self.folder / "one.h5"
        choice = f"--series {self.two()} --position x y --where particle=3 --origin 0.5 -1 --y-down"
        self.assertEqual(run(f"recurrence {choice} --threshold 0.1 --quiet -o {record}").returncode, 0)
        direct, kept = document(f"classify {choice}"), document(f"classify {record}")
        self.assertEqual(direct, kept)
        self.assertEqual((kept["series"]["body"], kept["series"]["origin"], kept["series"]["y_down"]), ("3", [0.5, -1], True))
        with xarray.open_dataset(record, group="series", engine="h5netcdf") as data:
            self.assertEqual(data.attrs["body"], "3")


class Geometry(Reading):
    def disk(self, name="d.csv", spin=-0.4):
        """Two marks on a body that turns at S of one radian per unit of time."""
        rows = []
        for i in range(600):
            a = 0.1 * spin * i
            x, y = 5 + math.cos(0.013 * i), -2 + math.sin(0.013 * i)
            rows.append((0.1 * i, x, y, x + 3 * math.cos(a), y + 3 * math.sin(a), a))
        return self.rows(name, "t,x1,y1,x2,y2,angle", [[repr(v) for v in row] for row in rows])

    def mean(self, file, flags):
        return document(f"classify --series {file} {flags}")["mean_S"]

    def test_marks_give_the_angle_and_the_sense_is_that_of_the_axes_and_the_swirl(self):
        file = self.disk()
        for what in ("--angle angle", "--marks x1 y1 x2 y2", "--marks x2 y2 x1 y1"):
            for flags, sign in (("", -1), ("--y-down", 1), ("--swirl-rate=-1", 1), ("--y-down --swirl-rate=-1", -1)):
                self.assertAlmostEqual(self.mean(file, f"{what} {flags}"), 0.4 * sign, delta=1e-6, msg=(what, flags))
        found = document(f"classify --series {file} --angle angle --swirl-rate=-2")["series"]
        self.assertEqual((found["swirl_rate"], found["clockwise"], found["y_down"]), (2, True, False))

    def test_rates_are_radians_turns_a_minute_or_turns_a_second(self):
        file = self.disk()
        for rate in (f"{math.pi}", f"{math.pi}rad/s", "30rpm", "0.5Hz"):
            self.assertAlmostEqual(self.mean(file, f"--angle angle --swirl-rate {rate}"), -0.4 / math.pi, delta=1e-6)
        ms = self.file("ms.csv", file.read_text().replace("t,", "time (ms),", 1))
        self.assertAlmostEqual(self.mean(ms, "--angle angle --swirl-rate 500Hz"), -0.4 / math.pi, delta=1e-6)
        for rate in ("30rps", "rpm", "1e999Hz", "0Hz"):
            self.refused(f"classify --series {file} --angle angle --swirl-rate {rate}", "swirl-rate")

    def test_an_angle_whose_column_says_degrees_is_noted(self):
        rows = [(0.1 * i, f"{2 * i % 360}", f"{0.035 * i % 6.28:.3f}") for i in range(600)]
        file = self.rows("d.csv", "t,angle (deg),turn (rad)", rows)
        note = "column angle (deg) is read in radians, though its unit is degrees: --degrees says so"
        self.assertIn(note, self.notes(f"classify --series {file} --angle 2"))
        for flags in ("--angle 2 --degrees", "--angle 3"):
            self.assertNotIn("radians", self.notes(f"classify --series {file} {flags}"))

    def test_an_angle_whose_values_come_round_at_360_is_noted(self):
        rows = [(0.1 * i, 4 * i % 360, (4 * i + 180) % 360 - 180, 4 * i, f"{0.07 * i % (2 * math.pi):.4f}") for i in range(600)]
        file = self.rows("w.csv", "t,around,about,unwound,turn", rows)
        for name in ("around", "about"):
            note = f"column {name} is read in radians, though its values come round at 360 as do degrees: --degrees says so"
            self.assertIn(note, self.notes(f"classify --series {file} --angle {name}"))
            self.assertNotIn("radians", self.notes(f"classify --series {file} --angle {name} --degrees"))
        self.assertNotIn("radians", self.notes(f"classify --series {file} --angle turn"))

    def test_an_unwound_angle_without_a_unit_is_noted(self):
        rows = [(f"{i / 30:.6f}", f"{6.3 * i:.3f}", f"{0.11 * i:.4f}") for i in range(900)]
        file = self.rows("u.csv", "t,angle,turn [rad]", rows)
        note = "column angle is read in radians, over 901 turns, and no unit is named: of degrees --degrees says so"
        self.assertIn(note, self.notes(f"classify --series {file} --angle angle --swirl-rate 1.5Hz"))
        self.assertNotIn("radians", self.notes(f"classify --series {file} --angle angle --swirl-rate 1.5Hz --degrees"))
        self.assertNotIn("radians", self.notes(f"classify --series {file} --angle 3 --swirl-rate 1.5Hz"))

    def test_a_mark_turns_about_an_origin_that_is_given_or_fitted(self):
        rows = [(0.1 * i, repr(7 + 3 * math.cos(0.02 * i)), repr(-1 + 3 * math.sin(0.02 * i))) for i in range(600)]
        file = self.rows("m.csv", "t,x,y", rows)
        for flags in ("--origin 7 -1", "--fit-origin"):
            found = document(f"classify --series {file} --mark x y {flags}")
            self.assertAlmostEqual(found["mean_S"], 0.2, delta=1e-6)
            self.assertEqual([round(v, 9) for v in found["series"]["origin"]], [7, -1])
        self.assertIn("(0, 0), from where positions are taken, lies outside", self.notes(f"classify --series {file} --mark x y"))
        record = self.folder / "p.h5"
        self.assertEqual(run(f"recurrence --series {file} --position x y --fit-origin --scale 2 --threshold 1 --quiet "
                             f"-o {record}").returncode, 0)
        with xarray.open_dataset(record, group="series", engine="h5netcdf") as data:
            self.assertAlmostEqual(float(abs(data["value"].values - 6).max()), 0, delta=1e-9)

    def test_pixels_are_told_and_S_of_an_image_changes_its_sign(self):
        file = self.rows("px.csv", "t,x,y,S", [(i, 300 + 200 * math.cos(i), 250 + 200 * math.sin(i), 0.1 * (i % 5))
                                               for i in range(100)])
        self.assertIn("--y-down changes the sign of turns", self.notes(f"recurrence --series {file} --position x y --threshold 1"))
        self.assertIn("--y-down", self.notes(f"recurrence --series {file} --threshold 1"))
        self.assertNotIn("pixels", self.notes(f"recurrence --series {file} --threshold 1 --y-down"))
        record = self.folder / "s.h5"
        self.assertEqual(run(f"recurrence --series {file} --y-down --threshold 1 --quiet -o {record}").returncode, 0)
        with xarray.open_dataset(record, group="series", engine="h5netcdf") as data:
            self.assertEqual(float(data["value"].values.min()), -0.4)
        self.refused(f"recurrence --series {file} --column x --y-down --threshold 1", "y-down", "column x")

    def test_flags_that_do_not_go_together(self):
        file = self.disk()
        for flags, said in (("--marks x1 y1 x2 y2 --angle angle", "give one"), ("--mark x1 y1 --position x2 y2", "give one"),
                            ("--origin 1 2", "--position or --mark"), ("--position x1 y1 --origin 1 2 --fit-origin", "give one"),
                            ("--angle angle --scale 2", "--scale"), ("--position x1 y1 --origin 1 b", "origin"),
                            ("--position x1 y1 --scale 0", "scale = 0"), ("--column x1 --likelihood 0.5", "no column of likelihoods")):
            for command in ("classify", "recurrence --threshold 1", "spectrum"):
                self.refused(f"{command} --series {file} {flags}", said)
        self.refused("classify --y-down", "--y-down is a series'")
        self.refused("spectrum --fps 30", "--fps 30 is a series'")


class Spins(Reading):
    """Columns that are no S as they stand: rates of turn by their unit, angles by their name."""
    RATE = 3 * math.pi  # of the swirl, 1.5 turns a second

    def film(self, header, of_rate, time=1):
        spins = [0.35 * (1 + 0.01 * math.sin(2 * math.pi * i / 90)) for i in range(900)]
        return self.rows("spin.csv", header, [(f"{time * i / 30:.7f}", repr(of_rate * self.RATE * s)) for i, s in enumerate(spins)])

    def test_a_rate_of_turn_over_the_swirls_is_S(self):
        degree = 180 / math.pi
        for header, of_rate, time in (("t,omega (rad/s)", 1, 1), ("t,w [deg/s]", degree, 1), ("t,spin (rpm)", 30 / math.pi, 1),
                                      ("t,w_rad_s", 1, 1), ("t,rate_deg_per_s", degree, 1), ("t,a \u00b0/s", degree, 1),
                                      ("time (ms),omega (rad/s)", 1, 1000), ("t,S (rad/s)", 1, 1)):
            file = self.film(header, of_rate, time)
            for rate, sign in (("1.5Hz", 1), ("90rpm", 1), ("=-1.5Hz", -1)):
                found = document(f"classify --series {file} --swirl-rate{'' if rate[0] == '=' else ' '}{rate}")
                self.assertAlmostEqual(found["mean_S"], 0.35 * sign, delta=1e-9, msg=(header, rate))
                self.assertEqual((found["series"]["quantity"], found["series"]["clockwise"], found["series"]["notes"]),
                                 ("S of a rate", sign < 0, []), header)
        self.assertAlmostEqual(document(f"classify --series {file} --swirl-rate {self.RATE} --y-down")["mean_S"], -0.35, delta=1e-9)
        self.assertIn("--swirl-rate 1.5Hz", document(f"inspect {file} --swirl-rate 1.5Hz")["command"])

    def test_without_the_swirls_rate_it_is_read_as_it_stands_and_noted(self):
        file = self.film("t,omega (rad/s)", 1)
        found = document(f"classify --series {file}")
        self.assertAlmostEqual(found["mean_S"], 0.35 * self.RATE, delta=1e-9)
        self.assertEqual(found["series"]["notes"], ["column omega (rad/s) is a rate of turn by its unit, and is read as it "
                                                    "stands: over --swirl-rate W it is S"])

    def test_a_swirls_rate_of_what_does_not_turn_is_refused(self):
        file = self.film("t,S", 1)
        self.refused(f"classify --series {file} --swirl-rate 2", "swirl-rate", "column S is neither")
        self.refused(f"classify --series {file} --column t --swirl-rate 2", "column t is neither")
        frames = self.rows("f.csv", "frame,omega (rad/s)", [(i, 1 + 0.1 * (i % 7)) for i in range(100)])
        self.refused(f"classify --series {frames} --swirl-rate 2", "--fps F")

    def test_an_angle_is_no_S(self):
        file = self.rows("a.csv", "t,angle", [(f"{i / 30:.7f}", f"{0.1 * i % 6.28:.4f}") for i in range(600)])
        self.refused(f"classify --series {file}", "column angle is an angle by its name", "--angle angle")
        note = "column angle is an angle by its name, and is read as it stands: --angle angle takes its rate, S"
        for arguments in (f"classify --series {file} --column angle", f"spectrum --series {file}"):
            self.assertIn(note, self.notes(arguments))
        self.assertNotIn("by its name", self.notes(f"classify --series {file} --angle angle"))

class Text(Reading):
    def test_a_likelihood_masks_and_is_told(self):
        file = self.rows("l.csv", "t,tip.x,tip.y,tip.likelihood", [(i, math.cos(i), math.sin(i), 0.3 if i % 50 == 7 else 0.9)
                                                                   for i in range(200)])
        choice = f"recurrence --series {file} --position tip.x tip.y --threshold 1"
        self.assertIn("4 of 200 rows have a tip.likelihood below 0.6: --likelihood 0.6", self.notes(choice))
        found = document(f"{choice} --likelihood 0.6")["series"]
        self.assertEqual((found["missing"], found["gaps"], found["notes"]), (4, 4, []))

    def test_nothing_of_a_file_reaches_the_terminal_raw(self):
        cell = self.file("e.csv", "t,S\n0,1\n1,\x1b[2J\x1b[31mgone\n2,3\n")
        self.assertNotIn("\x1b", self.refused(f"spectrum --series {cell}", "\\x1b[2J"))
        header = self.rows("h.csv", "t,a\x1b]0;x\x07", [(i, i % 7) for i in range(100)])
        for arguments in (f"recurrence --series {header} --threshold 1", f"inspect {header}", f"recurrence --series {header} --threshold 1 --json"):
            result = run(arguments)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertFalse({"\x1b", "\x07"} & set(result.stdout + result.stderr))
        self.assertNotIn("\x1b", run(f"classify --series {self.folder}/\x1b[31m.csv").stderr)

    def test_names_that_are_no_utf8_are_the_same_in_documents_and_records(self):
        path = self.folder / "latin.csv"
        path.write_bytes("t;T [°C]\n".encode("latin-1") + b"".join(b"%d;%d\n" % (i, i % 7) for i in range(100)))
        record = self.folder / "latin.h5"
        found = document(f"recurrence --series {path} --threshold 1 -o {record}")
        self.assertEqual(found["series"]["column"], "T [\ufffdC]")
        with xarray.open_dataset(record, group="series", engine="h5netcdf") as data:
            self.assertEqual(data.attrs["column"], "T [\ufffdC]")

    def test_utf16_is_named(self):
        path = self.folder / "wide.csv"
        path.write_bytes("t,S\n0,1\n1,2\n".encode("utf-16"))
        self.refused(f"spectrum --series {path}", "is UTF-16 text", "iconv")

    def test_the_ambiguity_of_a_comma_is_named(self):
        pairs = self.file("pairs.csv", "t,S\n" + "".join(f"{i},5,0,{i % 7}\n" for i in range(50)))
        self.refused(f"recurrence --series {pairs} --threshold 0.1", "--decimal-comma")
        found = document(f"recurrence --series {pairs} --threshold 0.1 --decimal-comma")["series"]
        self.assertEqual((found["time"], found["spacing"], found["rows"]), ("t", 1, 50))
        whole = self.file("whole.csv", "".join(f"{i},0{i % 7}\n" for i in range(50)))
        self.assertIn("if it is a decimal comma, --decimal-comma", self.notes(f"recurrence --series {whole} --threshold 0.1"))

    def test_a_gap_is_a_word_or_a_blank_line(self):
        words = self.file("w.csv", "t,S\n" + "".join(f"{i},{w}\n" for i, w in enumerate(
            ["1", "inf", "2", "null", "3", "NULL", "4", "-inf", "5", "#N/A", "6", "NaN", "7", "", "8"])))
        found = document(f"recurrence --series {words} --threshold 1")["series"]
        self.assertEqual((found["samples"], found["missing"]), (15, 7))
        blank = self.file("b.csv", "S\n1\n2\n\n\n5\n6\n\n8\n\n\n")
        found = document(f"recurrence --series {blank} --threshold 1")["series"]
        self.assertEqual((found["samples"], found["missing"], found["gaps"]), (8, 3, 2))

    def test_the_value_that_was_chosen_is_told(self):
        file = self.rows("v.csv", "t,a,b,error,quality,frame", [(i, i % 3, i % 5, 0.1, 1, i) for i in range(100)])
        found = document(f"recurrence --series {file} --threshold 1")["series"]
        self.assertEqual(found["column"], "b")
        self.assertIn("column b is analysed, the last of a, b: --column NAME", "".join(found["notes"]))


if __name__ == "__main__":
    unittest.main()
