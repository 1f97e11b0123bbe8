#!/usr/bin/python3
"""Draws records of swirl: plot_record.py RECORD… -o FIGURE [--kind NAME] …. `swirl plot` runs it."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))  # also of a Python that is told to look at nothing (-I)

import chosen
import script


def arguments():
    parser = script.Parser("Draws records of swirl.", "figure, a .png, .svg or .pdf file,", several=True)
    parser.add_argument("--kind", metavar="NAME", help="the figure's kind, where a record can be drawn in several ways")
    parser.add_argument("--width", metavar="WIDTH", help="millimetres, 3.4in, or a journal's column by name")
    parser.add_argument("--font-size", metavar="POINTS", help="of the letters")
    parser.add_argument("--no-title", action="store_true", help="no title above")
    parser.add_argument("--xlim", metavar="A:B", help="range of the abscissa")
    parser.add_argument("--ylim", metavar="A:B", help="range of the ordinate")
    parser.add_argument("--log", metavar="AXES", help="x, y or xy: logarithmic axes")
    parser.add_argument("--of", metavar="NAME", help="of kinds means and map: S, exponent, period or RC")
    parser.add_argument("--over", metavar="NAME", help="of kind means: the parameter along the abscissa")
    parser.add_argument("--caption", metavar="FILE", help="what the figure shows, in words, to a file of its own")
    parser.add_argument("--units", choices=("dimensionless", "physical"), default="dimensionless", help="of the axes")
    parser.add_argument("--x", metavar="NAME", help="of a section portrait")
    parser.add_argument("--y", metavar="NAME", help="of a section portrait")
    return parser.parse_args()


def chosen_of(options):
    """The fields of a Look."""
    return {"width": script.value_of(chosen.length_of, options.width),
            "font_size": script.value_of(chosen.font_size_of, options.font_size),
            "xlim": script.value_of(chosen.range_of, options.xlim),
            "ylim": script.value_of(lambda text: chosen.range_of(text, "ylim"), options.ylim),
            "log": options.log, "of": options.of, "over": options.over,
            "titles": not options.no_title, "x": options.x, "y": options.y}


def main():
    script.leave_at_once_when_interrupted()
    script.say_names_as_they_are()
    options = arguments()
    if options.caption and os.path.realpath(options.caption) == os.path.realpath(options.output):
        script.fail(2, f"caption '{options.caption}' is the figure itself")
    fields = chosen_of(options)
    figures = script.load_figures()

    look = figures.Look(**fields)

    def make():
        records = [figures.open_record(path) for path in options.record]
        kinds = [figures.kind_of(record, options.kind) for record in records]
        shown = look
        if options.units == "physical":
            units = figures.physical.shared_units(records)
            if look.xlim or look.ylim:  # in SI, too
                whole = figures.Look(**{**fields, "xlim": None, "ylim": None})
                figures.draw(records, options.kind, whole)
                shown = figures.Look(**{**fields, **figures.physical.limits_drawn(whole.limited, look, units)})
        figure = figures.draw(records, options.kind, shown)
        if options.units == "physical":
            figures.physical.in_si(figure, units)
        return kinds[0], figure, figures.caption.text_of(records, kinds, look)

    kind, figure, caption = script.made_from(options.record, make)
    script.saved("figure", options.output, lambda: figures.save(figure, options.output))
    if options.caption:
        words = caption.encode("utf-8", errors="surrogateescape")
        script.saved("caption", options.caption, lambda: figures.output.write_whole(words, options.caption))
    script.report(options, "figure", kind)


if __name__ == "__main__":
    main()
