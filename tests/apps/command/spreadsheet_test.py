"""What spreadsheets and trackers' lists do to a film: spreadsheet_test.py SWIRL

One film, as they may write it: S = -0.4 + 0.3 cos(2 pi t/4), at a swirl of 1 Hz, 30 frames a second, 15 periods."""

import math
import random
import unittest

from driving import InFolder, document, run

MEAN, SWING, TONE, FPS, ROWS = -0.4, 0.3, 0.25, 30, 1801


def angle(t):
    """In turns."""
    return MEAN * t + SWING * math.sin(2 * math.pi * TONE * t) / (2 * math.pi * TONE)


class Film(InFolder):
    def film(self, name, header, row, count=ROWS):
        return self.file(name, "\n".join([header] + [row(i, i / FPS) for i in range(count)]) + "\n")

    def judged(self, file, flags):
        return document(f"classify --series {file} {flags}")

    def check(self, file, flags, note=None, delta=1e-3):  # of 15 periods the mean is off by 4e-4
        """Its mean S, and what is noted."""
        found = self.judged(file, flags)
        self.assertAlmostEqual(found["mean_S"], MEAN, delta=delta, msg=flags)
        notes = " ".join(found["series"]["notes"])
        if note is None:
            self.assertEqual(notes, "")
        else:
            self.assertIn(note, notes)

    def refused(self, arguments, *mentions):
        result = run(arguments)
        self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
        for mention in mentions:
            self.assertIn(mention, result.stderr)


class Order(Film):
    def rows(self, header, order, time):
        """The rows in another order; `time` of each as text."""
        lines = [f"{time(i)},{angle(i / FPS):.7f}" for i in order]
        return self.file("order.csv", "\n".join([header] + lines) + "\n")

    def test_a_trackers_list_is_put_in_order(self):
        shuffled = list(range(ROWS))
        random.Random(4).shuffle(shuffled)
        exchanged = list(range(ROWS))
        exchanged[300], exchanged[301] = exchanged[301], exchanged[300]
        for order in (shuffled, exchanged):
            for header, time, flags in (("frame,angle (turns)", str, f"--fps {FPS}"), ("seconds,angle (turns)", lambda i: f"{i / FPS:.6f}", ""),
                                        ("POSITION_T,angle (turns)", lambda i: f"{i / FPS:.6f}", "")):
                name = header.split(",")[0]
                self.check(self.rows(header, order, time), f"--angle 2 --swirl-rate 1Hz {flags}",
                           f"the rows are not in the order of column {name}: they are sorted by it")

                self.assertEqual(document(f"inspect {self.rows(header, order, time)} {flags}")["time"], name)
            named = self.rows("t,angle (turns)", order, lambda i: f"{i / FPS:.6f}")
            self.refused(f"classify --series {named} --angle 2 --swirl-rate 1Hz", "times must rise")

    def test_a_clock_that_goes_round_is_not(self):
        file = self.rows("t,angle (turns)", range(ROWS), lambda i: f"{i / FPS % 10:.6f}")
        self.refused(f"classify --series {file} --angle 2 --swirl-rate 1Hz", "times must rise")
        file = self.rows("seconds,angle (turns)", range(ROWS), lambda i: f"{i / FPS % 10:.6f}")
        self.assertIn("column seconds is named as times and does not rise", " ".join(self.judged(file, "--angle 2")["series"]["notes"]))

    def test_a_time_of_day_goes_on_after_midnight(self):
        def clock(i):
            seconds = 86390 + i / FPS
            minutes, rest = divmod(seconds % 86400, 60)
            return f"{int(minutes) // 60:02d}:{int(minutes) % 60:02d}:{rest:09.6f}"
        self.check(self.rows("time,angle (turns)", range(ROWS), clock), "--angle 2 --swirl-rate 1Hz", "read in turns, its unit")


class Units(Film):
    def test_an_angle_is_read_in_the_unit_that_it_names(self):
        for unit, turn in (("turns", 1), ("rev", 1), ("gon", 400), ("mrad", 2000 * math.pi)):
            for wrapped in (False, True):
                file = self.film("a.csv", f"t (s),angle ({unit})",
                                 lambda _, t: f"{t:.6f},{(angle(t) % 1 if wrapped else angle(t)) * turn:.9f}")
                self.check(file, "--angle 2 --swirl-rate 1Hz", f"is read in {unit}, its unit")
        radians = self.film("r.csv", "t (s),angle (rad)", lambda _, t: f"{t:.6f},{2 * math.pi * angle(t):.9f}")
        self.check(radians, "--angle 2 --swirl-rate 1Hz")
        self.assertIn("is read in degrees, though its unit is rad: leave --degrees out",
                      " ".join(self.judged(radians, "--angle 2 --degrees --swirl-rate 1Hz")["series"]["notes"]))

    def test_times_in_a_known_unit_make_seconds_and_others_are_named(self):
        for unit, second in (("ns", 1e9), ("microseconds", 1e6), ("millis", 1e3), ("min", 1 / 60)):
            file = self.film("t.csv", f"time ({unit}),angle (rad)", lambda _, t: f"{t * second:.9f},{2 * math.pi * angle(t):.9f}")
            self.check(file, "--angle 2 --swirl-rate 1Hz")
        file = self.film("t.csv", "time (fortnights),angle (rad)", lambda _, t: f"{t:.6f},{2 * math.pi * angle(t):.9f}")
        self.refused(f"classify --series {file} --angle 2 --swirl-rate 1Hz", "the times' unit is none that is known")
        self.check(file, f"--angle 2 --swirl-rate {2 * math.pi}")

    def test_percent_is_noted(self):
        file = self.film("p.csv", "t,S (%)", lambda _, t: f"{t:.6f},{100 * (MEAN + SWING * math.cos(2 * math.pi * TONE * t)):.4f}")
        self.assertIn("is in percent by its unit", " ".join(self.judged(file, "")["series"]["notes"]))
        self.check(file, "--scale 0.01", delta=1e-3)


class Cells(Film):
    def test_points_part_thousands_beside_decimal_commas(self):
        def german(value, digits):
            whole, _, rest = f"{value:,.{digits}f}".partition(".")
            return whole.replace(",", ".") + ("," + rest if rest else "")
        file = self.film("g.csv", "t (ms);angle (deg)", lambda i, t: f"{german(10_000 + 1000 * t, 3)};{german(360 * angle(t), 4)}")
        self.check(file, "--angle 2 --degrees --decimal-comma --swirl-rate 1Hz")
        mixed = self.film("m.csv", "t;S", lambda _, t: f"{t:.2f};0,{int(100 * t) % 90:02d}")
        self.refused(f"classify --series {mixed} --decimal-comma", "'0.00'")

    def test_a_minus_sign_of_a_text_is_one(self):
        file = self.film("u.csv", "t,angle (rad)", lambda _, t: f"{t:.6f},{2 * math.pi * angle(t):.9f}".replace("-", "\u2212"))
        self.check(file, "--angle 2 --swirl-rate 1Hz")


class Points(Film):
    def marks(self, header="time,x,y,mark_x,mark_y", lost=()):
        def row(i, t):
            if i in lost:
                return f"{t:.6f},0,0,0,0"
            turn = 2 * math.pi * angle(t)
            return f"{t:.6f},10,-5,{10 + 9 * math.cos(turn):.6f},{-5 + 9 * math.sin(turn):.6f}"
        return self.film("marks.csv", header, row)

    def test_points_at_one_place_have_no_direction(self):
        file = self.marks(lost=(150, 300, 301))
        self.check(file, "--marks x y mark_x mark_y --swirl-rate 1Hz", "in 3 rows both points are at one place", delta=5e-4)
        power = document(f"spectrum --series {file} --marks x y mark_x mark_y --swirl-rate 1Hz")
        self.assertAlmostEqual(power["variance"], SWING ** 2 / 2, delta=1e-3)

    def test_places_given_as_y_and_x_are_noted(self):
        file = self.marks()
        said = "columns y and x are taken as x and y, in this order"
        self.assertIn(said, " ".join(self.judged(file, "--marks y x mark_y mark_x --swirl-rate 1Hz")["series"]["notes"]))
        self.check(file, "--marks x y mark_x mark_y --swirl-rate 1Hz")

    def test_names_that_end_in_pos_are_places(self):
        found = document(f"inspect {self.marks('time,Xpos_A,Ypos_A,Xpos_B,Ypos_B')}")
        self.assertIn("--marks Xpos_A Ypos_A Xpos_B Ypos_B", found["command"])

    def test_a_folded_angle_is_noted(self):
        for fold in (lambda turn: abs((360 * turn + 90) % 180 - 90), lambda turn: math.degrees(math.acos(math.cos(2 * math.pi * turn)))):
            file = self.film("fold.csv", "t,angle", lambda _, t: f"{t:.6f},{fold(angle(t)):.4f}")
            notes = " ".join(self.judged(file, "--angle 2 --degrees --swirl-rate 1Hz")["series"]["notes"])
            self.assertIn("the sense of turns is lost", notes)


class Tones(InFolder):
    def series(self, name, values):
        return self.file(name, "S\n" + "\n".join(f"{v:.9f}" for v in values) + "\n")

    def test_a_swept_tone_is_no_chaos(self):
        for name, phase, count in (("sweep", lambda i: 0.5 * i + 1.5e-4 * i * i, 1500), ("long", lambda i: 0.5 * i + 5e-5 * i * i, 4000),
                                   ("to-and-fro", lambda i: 0.5 * i + 60 * math.sin(0.004 * i), 1500)):
            found = document(f"classify --series {self.series(f'{name}.csv', [math.cos(phase(i)) for i in range(count)])}")
            self.assertEqual((found["mode"], found["largest_exponent"]), ("undecided", None), name)

    def test_a_tone_that_segments_do_not_resolve_is_noted(self):
        def notes(tone, count, flags=""):
            file = self.file("tone.csv", "t,S\n" + "".join(f"{i / FPS:.6f},{math.cos(2 * math.pi * tone * i / FPS + 0.3):.9f}\n" for i in range(count)))
            return " ".join(document(f"spectrum --series {file} {flags}")["notes"])
        for tone, count in ((0.4, 600), (0.23, 600), (0.05, 2000)):
            self.assertIn("--segments 1", notes(tone, count), tone)
            self.assertNotIn("--segments 1", notes(tone, count, "--segments 1"), tone)
        self.assertNotIn("--segments 1", notes(1, 2000))


if __name__ == "__main__":
    unittest.main()
