"""Tables as trackers write them, read as they come: layouts_test.py SWIRL

One body turns at S = -0.35 of a swirl of 1 Hz, filmed at 30 frames a second, its centre on a circle: each layout is written
in its tracker's form (headers, separators, decimals, gaps, further columns), and S and its sign must come out."""

import json
import math
import shlex
import unittest
from datetime import datetime, timedelta, timezone

from driving import InFolder, document, run

FPS, COUNT, S = 30, 600, -0.35
RATE = 2 * math.pi


def turn(i):
    return 0.4 + S * RATE * i / FPS


def centre(i):
    return 3 * math.cos(0.02 * i), 3 * math.sin(0.02 * i)


def marks(i):
    """Two marks on the body: its centre, and one 12 away."""
    x, y = centre(i)
    return x, y, x + 12 * math.cos(turn(i)), y + 12 * math.sin(turn(i))


def image(i):
    """Positions in pixels of an image: y down from the upper left corner."""
    return [400 + 20 * v if k % 2 == 0 else 300 - 20 * v for k, v in enumerate(marks(i))]


def table(rows, separator=",", end=""):
    return "".join(separator.join(str(c) for c in row) + end + "\n" for row in rows)


def degrees(i):
    return math.degrees(turn(i))


def time(i):
    return f"{i / FPS:.3f}"


def tracker_pasted():
    """OSP Tracker, copied from its table: the track's name, then the variables."""
    return "disk\n" + table([["t", "x", "y", "θ"]] + [[time(i), *(f"{v:.3f}" for v in marks(i)[:2]), f"{degrees(i):.2f}"]
                                                      for i in range(COUNT)], "\t")


def tracker_exported():
    """Tracker's export of one track: its name over its columns, separators at the ends, numbers as Java writes them."""
    rows = [["", "mass A", "", ""], ["t", "x", "y", "θr"]]
    rows += [[f"{i / FPS:.6E}", *(f"{v:.6E}" for v in marks(i)[:2]), f"{degrees(i):.6E}"] for i in range(COUNT)]
    return table(rows, ",", ",")


def tracker_multi():
    """Tracker's export of two tracks, where the comma is decimal."""
    rows = [["", "disk", "", "", "mark", "", ""], ["t", "x", "y", "θ", "x", "y", "θ"]]
    for i in range(COUNT):
        x, y, u, v = marks(i)
        rows.append([time(i), f"{x:.3f}", f"{y:.3f}", f"{math.degrees(math.atan2(y, x)):.1f}", f"{u:.3f}", f"{v:.3f}",
                     f"{math.degrees(math.atan2(v, u)):.1f}"])
    return "#multi:\n" + table(rows, ";", ";").replace(".", ",")


def trackmate():
    """Four rows of names, a column of ids that differ in each row, a track's id, an angle of the ellipse."""
    names = ["LABEL", "ID", "TRACK_ID", "QUALITY", "POSITION_X", "POSITION_Y", "POSITION_T", "FRAME", "ELLIPSE_THETA"]
    label = ["Label", "Spot ID", "Track ID", "Quality", "X", "Y", "T", "Frame", "Ellipse angle"]
    rows = [names, label, label, ["", "", "", "(quality)", "(pixel)", "(pixel)", "(sec)", "", "(radians)"]]
    rows += [[f"ID{i}", i, 0, 4.2, *(f"{v:.4f}" for v in image(i)[:2]), f"{i / FPS:.4f}", i,
              f"{math.remainder(-turn(i), 2 * math.pi):.4f}"] for i in range(COUNT)]
    return table(rows)


def deeplabcut():
    rows = [["scorer"] + ["netA"] * 6, ["bodyparts"] + ["centre"] * 3 + ["tip"] * 3, ["coords"] + ["x", "y", "likelihood"] * 2]
    for i in range(COUNT):
        x, y, u, v = image(i)
        sure = 0.1 if i == 77 else 0.99
        rows.append([i, x, y, 0.99, u + (300 if i == 77 else 0), v, sure])
    return table(rows)


def deeplabcut_of_several():
    rows = [["scorer"] + ["netA"] * 4, ["individuals"] + ["1"] * 4, ["bodyparts", "centre", "centre", "tip", "tip"],
            ["coords"] + ["x", "y"] * 2]
    return table(rows + [[i, *image(i)] for i in range(COUNT)])


def trex():
    """+inf where the body was lost, whole numbers with decimals, two columns of frames, units in the names."""
    rows = [["frame", "ANGLE", "SPEED#wcentroid (cm/s)", "X#wcentroid (cm)", "Y#wcentroid (cm)", "frame", "missing", "time",
             "timestamp"]]
    for i in range(COUNT):
        x, y = image(i)[:2]
        lost = 100 <= i < 103
        rows.append([f"{i}.000", "inf" if lost else f"{math.remainder(-turn(i), 2 * math.pi):.3f}", "1.0", "inf" if lost else x,
                     "inf" if lost else y, f"{i}.000", int(lost), time(i), f"{i * 1e6 / FPS:.0f}.000"])
    return table(rows)


def octron():
    """A preamble of lines `name: value`, an id, a class's name; scikit-image's orientation, from the rows' axis, grows
    counter-clockwise as the image is seen (findings/sense_of_orientation.sh)."""
    head = "".join(f"{line}\n" for line in ("video_name: dish.mp4", "frame_count: 600", "frame_count_analyzed: 600",
                                            "video_height: 1000", "video_width: 1000", "created_at: 2026-10-04 09:06:31.5"))
    rows = [["frame_counter", "frame_idx", "track_id", "label", "confidence", "pos_x", "pos_y", "bbox_x_min", "bbox_x_max",
             "bbox_y_min", "bbox_y_max", "orientation"]]
    rows += [[i - (3 if i > 300 else 0), i, 1, "disk", 0.9, *image(i)[:2], 0, 800, 0, 600, f"{math.remainder(turn(i) + math.pi / 2, math.pi):.4f}"]
             for i in range(COUNT) if not 300 < i <= 303]  # not analysed, which the counter passes over
    return head + table(rows)


def trc():
    """OpenSim's .trc: numbers in the preamble, markers over X1 Y1 Z1, a blank line, a y axis that points up."""
    head = ["PathFileType\t4\t(X/Y/Z)\tdish.trc", "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\t"
            "OrigDataStartFrame\tOrigNumFrames", f"30.00\t30.00\t{COUNT}\t2\tmm\t30.00\t1\t{COUNT}",
            "Frame#\tTime\tcentre\t\t\ttip\t\t", "\t\tX1\tY1\tZ1\tX2\tY2\tZ2", ""]
    rows = []
    for i in range(COUNT):
        x, y, u, v = marks(i)
        rows.append([i + 1, f"{i / FPS:.5f}", x, y, 0, u, v, 0])
    return "\n".join(head) + "\n" + table(rows, "\t")


def bonsai():
    """Times of the clock with an offset, over midnight; words and counts of no interest."""
    begin = datetime(2026, 10, 7, 23, 59, 50, tzinfo=timezone(timedelta(hours=1)))
    rows = [["Item1.ElementType", "Item1.IsInvalid", "Item3.Value.Centroid.X", "Item3.Value.Centroid.Y",
             "Item3.Value.Orientation", "Item3.Value.Area", "Item3.Timestamp"]]
    for i in range(COUNT):
        stamp = (begin + timedelta(microseconds=round(i * 1e6 / FPS))).isoformat(timespec="microseconds")
        rows.append([0, "False", *image(i)[:2], math.remainder(-turn(i), math.pi), 17032.5, stamp.replace("+", "4+")])
    return table(rows)


def bonsai_plain():
    """No header: a time and two points, separated by blanks."""
    begin = datetime(2026, 10, 7, 10, 44, 40, tzinfo=timezone.utc)
    return table([[(begin + timedelta(microseconds=round(i * 1e6 / FPS))).isoformat(timespec="microseconds"),
                   *(f"{v:.3f}" for v in image(i))] for i in range(COUNT)], " ")


def trackpy():
    """pandas' index without a name, y before x, two particles in turn."""
    rows = [["", "y", "x", "mass", "size", "ecc", "signal", "raw_mass", "ep", "frame", "particle"]]
    for i in range(COUNT):
        _, _, u, v = [a - b for a, b in zip(image(i), (0, 0) + tuple(image(i)[:2]))]
        rows.append([2 * i, 300 + v, 400 + u, 99.1, 2.1, 0.1, 9.9, 101.5, 0.02, i, 0])
        rows.append([2 * i + 1, 50.5, 60.5, 99.1, 2.1, 0.1, 9.9, 101.5, 0.02, i, 3])
    return table(rows)


def sleap():
    """A track without a name, points that were not seen, scores."""
    rows = [["track", "frame_idx", "instance.score", "head.x", "head.y", "head.score", "tail.x", "tail.y", "tail.score"]]
    for i in range(COUNT):
        x, y, u, v = image(i)
        rows.append(["", i, 0.93, x, y, 0.97] + (["", "", ""] if i % 97 == 5 else [u, v, 0.88]))
    return table(rows)


def idtracker():
    rows = [["seconds", "x1", "y1", "x2", "y2"]]
    for i in range(COUNT):
        x, y, u, v = image(i)
        lost = i == 33
        rows.append([time(i), f"{400 + u - x:.3f}" if not lost else "nan", f"{300 + v - y:.3f}" if not lost else "nan",
                     "853.333", "173.355"])
    return table(rows)


def animalta():
    """Semicolons, times in hundredths that do not begin at 0, NA."""
    rows = [["Frame", "Time", "X_Arena0_Ind0", "Y_Arena0_Ind0", "X_Arena1_Ind0", "Y_Arena1_Ind0"]]
    for i in range(COUNT):
        x, y, u, v = image(i)
        rows.append([19098 + i, f"{639 + i / FPS:.2f}", "NA" if i == 50 else f"{400 + u - x:.6f}",
                     "NA" if i == 50 else f"{300 + v - y:.6f}", "903.35", "328.42"])
    return table(rows, ";")


def toxtrac():
    """Tracking_RealSpace_N.txt: tabs, millimetres, rows of lost frames absent, times that do not begin at 0."""
    rows = [["Time (sec)", "Arena", "Track", "Pos. X (mm)", "Pos. Y (mm)", "Label"]]
    for i in range(COUNT):
        x, y, u, v = marks(i)
        if i not in (200, 201):
            rows.append([f"{12.2585 + i / FPS:.4f}", 1, 1, f"{50 + u - x:.4f}", f"{50 - (v - y):.4f}", 1])
    return table(rows, "\t")


def toxtrac_pixels():
    """Tracking_N.txt: no header; frame, arena, track, x, y, label."""
    rows = []
    for i in range(COUNT):
        x, y, u, v = image(i)
        rows.append([i + 1, 0, 1, f"{400 + u - x:.2f}", f"{300 + v - y:.2f}", 1])
    return table(rows, "\t")


def imagej():
    """Results.csv: a first column named with a blank; frames are slices, the ellipse's angle counts from the x axis up."""
    rows = [[" ", "Area", "X", "Y", "Major", "Minor", "Angle", "Slice"]]
    rows += [[i + 1, 1200, *image(i)[:2], 40, 20, f"{degrees(i) % 180:.3f}", i + 1] for i in range(COUNT)]
    return table(rows)


def imagej_manual_tracking():
    """Manual Tracking: tabs, and a degree sign in the names that is no UTF-8."""
    rows = [["Track n\xb0", "Slice n\xb0", "X", "Y", "Distance", "Velocity", "Pixel Value"]]
    for i in range(COUNT):
        x, y, u, v = image(i)
        rows.append([1, i + 1, round(400 + 10 * (u - x)), round(300 + 10 * (v - y)), 1.5, 4.4, 120])
    return table(rows, "\t").encode("latin-1")


def spreadsheet():
    """A spreadsheet's: `sep=;`, decimal commas, CR LF, a preamble of a blank line and a title."""
    return ("sep=;\n" + table([["t (s)", "angle (°)"]] + [[time(i), f"{degrees(i) % 360:.2f}"] for i in range(COUNT)],
                              ";").replace(".", ",")).replace("\n", "\r\n")


def from_r():
    """write.table: names of rows, which the header lacks, and quotes."""
    return '"t" "angle"\n' + "".join(f'"{i + 1}" {time(i)} {math.remainder(turn(i), 2 * math.pi)!r}\n' for i in range(COUNT))


def units_row():
    return "t,angle\n(s),(rad)\n" + table([[time(i), turn(i)] for i in range(COUNT)])


def preamble():
    return ('\ufeffPlease,cite:,"A. Nobody, a table of"\nnumbers,that,"begin below"\n,,\n' +
            table([["Time (ms)", "angle (rad)", "Error"]] +
                  [[round(i * 1000 / FPS), math.remainder(turn(i), 2 * math.pi), 0.03] for i in range(COUNT)]))


#: How S is asked for, the unit of the rate included; the flags say what the file can't: axes, a centre, frames a second.
LAYOUTS = {
    tracker_pasted: "--angle θ --degrees --swirl-rate 1Hz",
    tracker_exported: "--angle θr --degrees --swirl-rate 60rpm",
    tracker_multi: "--marks disk.x disk.y mark.x mark.y --swirl-rate 1Hz",
    trackmate: "--angle ELLIPSE_THETA --y-down --swirl-rate 1Hz",
    deeplabcut: "--marks centre.x centre.y tip.x tip.y --y-down --fps 30 --likelihood 0.6 --swirl-rate 1Hz",
    deeplabcut_of_several: "--marks centre.x centre.y tip.x tip.y --y-down --fps 30 --swirl-rate 1Hz",
    trex: "--angle ANGLE --y-down --swirl-rate 1Hz",
    octron: "--angle orientation --symmetry 2 --fps 30 --swirl-rate 60rpm",
    trc: "--marks centre.X1 centre.Y1 tip.X2 tip.Y2 --swirl-rate 6.283185307rad/s",
    bonsai: "--angle Item3.Value.Orientation --symmetry 2 --y-down --swirl-rate 1Hz",
    bonsai_plain: "--marks 2 3 4 5 --y-down --swirl-rate 1Hz",
    trackpy: "--mark x y --fit-origin --where particle=0 --y-down --fps 30 --swirl-rate 1Hz",
    sleap: "--marks head.x head.y tail.x tail.y --y-down --fps 30 --swirl-rate 1Hz",
    idtracker: "--mark x1 y1 --origin 400 300 --y-down --swirl-rate 1Hz",
    animalta: "--mark X_Arena0_Ind0 Y_Arena0_Ind0 --fit-origin --y-down --swirl-rate 1Hz",
    toxtrac: "--mark 4 5 --fit-origin --y-down --swirl-rate 1Hz",
    toxtrac_pixels: "--mark 4 5 --origin 400 300 --fps 30 --y-down --swirl-rate 1Hz",
    imagej: "--angle Angle --degrees --symmetry 2 --fps 30 --swirl-rate 1Hz",
    imagej_manual_tracking: "--mark X Y --fit-origin --y-down --fps 30 --swirl-rate 1Hz",
    spreadsheet: "--angle angle --degrees --swirl-rate 1Hz",
    from_r: "--angle angle --swirl-rate 1Hz",
    units_row: "--angle angle --swirl-rate 1Hz",
    preamble: "--angle angle --swirl-rate 60rpm",
}
TIMES = {"tracker_multi": "t", "trackmate": "POSITION_T", "deeplabcut": "frame", "trex": "time", "octron": "frame_idx",
         "trc": "Time", "bonsai": "Item3.Timestamp", "bonsai_plain": "1", "trackpy": "frame", "sleap": "frame_idx",
         "idtracker": "seconds", "animalta": "Time", "toxtrac": "Time (sec)", "toxtrac_pixels": "1", "imagej": "Slice",
         "imagej_manual_tracking": "Slice n\ufffd", "from_r": "t", "preamble": "Time (ms)"}


class Layouts(InFolder):
    def written(self, layout):
        content = layout()
        path = self.folder / f"{layout.__name__}.csv"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def test_each_is_read_as_it_comes_with_the_sign_of_S(self):
        for layout, flags in LAYOUTS.items():
            with self.subTest(layout=layout.__name__):
                found = document(f"classify --series {self.written(layout)} {flags}")
                self.assertEqual(found["series"]["quantity"], "S of an angle")
                self.assertIn(found["mode"], ("steady", "undecided"))  # seven digits of Java are no noise, and no even rounding
                # Pixels are whole at worst: half a pixel of 2400 over the 20 turns.
                self.assertAlmostEqual(found["mean_S"], S, delta=2e-3)
                self.assertEqual(found["series"]["y_down"], "--y-down" in flags)

    def test_inspect_finds_the_times_and_gives_a_command_that_runs(self):
        for layout in LAYOUTS:
            with self.subTest(layout=layout.__name__):
                found = document(f"inspect {self.written(layout)}")
                name = layout.__name__
                self.assertEqual(found["time"], TIMES.get(name, found["time"]))
                self.assertIsNotNone(found["time"])
                self.assertEqual(found["rows"], COUNT * (2 if name == "trackpy" else 1) - {"toxtrac": 2, "octron": 3}.get(name, 0))
                self.assertEqual(found["bodies"], ["0", "3"] if name == "trackpy" else [])
                self.assertIsNone(found["problem"])
                if name == "trackpy":
                    self.assertIn("--each particle", found["command"])
                    continue  # of which one body does not move
                again = run(shlex.split(found["command"])[1:] + ["--json"])
                self.assertEqual(again.returncode, 0, (found["command"], again.stderr))
                self.assertEqual(json.loads(again.stdout)["series"]["quantity"], found["quantity"])

    def test_inspect_sees_marks_of_one_body_and_the_axis_of_images(self):
        found = document(f"inspect {self.written(deeplabcut)} --fps 30 --likelihood 0.6 --swirl-rate 1Hz")
        self.assertIn("--marks centre.x centre.y tip.x tip.y", found["command"])
        self.assertIn("--y-down", found["command"])
        self.assertEqual((found["gaps"], found["missing"]), (1, 2))  # of S, a lost angle takes two
        again = run(shlex.split(found["command"])[1:] + ["--json"])
        self.assertAlmostEqual(json.loads(again.stdout)["mean_S"], S, delta=1e-3)
        plain = document(f"inspect {self.written(idtracker)}")
        self.assertIn("--position x1 y1 --fit-origin", plain["command"])  # two animals are no marks of one body
        self.assertEqual([point["x"] for point in plain["points"]], ["x1", "x2"])


if __name__ == "__main__":
    unittest.main()
