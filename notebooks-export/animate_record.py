#!/usr/bin/python3
"""A film of a record of swirl: animate_record.py RECORD -o FILE [--frame NAME] …. `swirl animate` runs it."""

import math
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))  # also of a Python that is told to look at nothing (-I)

import script

FRAMES = ("container", "laboratory", "co-rotating")
SUFFIXES = (".mp4", ".gif")
UNITS = ("dimensionless", "physical")

#: name: (default, least, most, unit)
NUMBERS = {"fps": (20.0, 1, 60, "pictures a second"), "duration": (8.0, 0.1, 600, "seconds")}


def arguments():
    parser = script.Parser("A film of a record of swirl.", "film, an .mp4 or .gif file,")
    parser.add_argument("--frame", metavar="NAME", default="container", help="container, laboratory or co-rotating")
    parser.add_argument("--fps", metavar="N", help="pictures a second")
    parser.add_argument("--duration", metavar="SECONDS", help="of the film")
    parser.add_argument("--from", dest="begin", metavar="T", help="time of the orbit at which it begins")
    parser.add_argument("--to", dest="end", metavar="T", help="time of the orbit at which it ends")
    parser.add_argument("--orbit", metavar="I", help="which of a record of orbits, from 1")
    parser.add_argument("--units", metavar="NAME", default="dimensionless", help="dimensionless or physical")
    return parser.parse_args()


def number_in_range(name, text):
    default, least, most, unit = NUMBERS[name]
    if text is None:
        return default
    value = number(name, text)
    if not least <= value <= most:
        script.fail(2, f"{name} = {text}: allowed are {least:g} to {most:g} {unit}")
    return value


def number(name, text):
    if text is None:
        return None
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        script.fail(2, f"{name} = {text} is no finite number")
    return value


def whole(name, text):
    if not text.isdigit() or not text.isascii():
        script.fail(2, f"{name} = {text}: allowed is a whole number from 1")
    return int(text)


def check(options):
    """What needs no look at the record, before anything is loaded that takes a second."""
    if options.frame not in FRAMES:
        script.fail(2, f"frame = {options.frame}: allowed are {', '.join(FRAMES)}")
    if options.units not in UNITS:
        script.fail(2, f"units = {options.units}: allowed are {', '.join(UNITS)}")
    suffix = Path(options.output).suffix
    if suffix not in SUFFIXES:
        script.fail(2, f"film '{options.output}': its suffix is none of {', '.join(SUFFIXES)}")
    if suffix == ".mp4" and shutil.which("ffmpeg") is None:
        script.fail(2, "an .mp4 needs ffmpeg, the Debian package of that name; a .gif does not")


def main():
    options = arguments_and_signals()
    check(options)
    fps, duration = number_in_range("fps", options.fps), number_in_range("duration", options.duration)
    begin, end = number("from", options.begin), number("to", options.end)
    orbit = None if options.orbit is None else whole("orbit", options.orbit)
    count = max(2, round(fps * duration))
    figures = script.load_figures()
    from swirl_figures import film, film_file

    def make():
        record = figures.open_record(options.record[0])
        units = figures.physical.units_of(record) if options.units == "physical" else None
        return film.Film(record, options.frame, orbit, begin, end, count, units)

    shown = script.made_from(options.record, make)
    script.saved("film", options.output, lambda: film_file.write_film(shown.pictures(), Path(options.output), fps),
                 hold=False)
    script.report(options, "film", options.frame)


def arguments_and_signals():
    script.say_names_as_they_are()
    options = arguments()
    script.leave_when_interrupted()
    return options


if __name__ == "__main__":
    main()
