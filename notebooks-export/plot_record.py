#!/usr/bin/python3
"""Draws a record of swirl: plot_record.py RECORD -o FIGURE [--kind NAME]. `swirl plot` runs it.

Exit codes are those of `swirl`: 0 done, 2 bad input, 4 writing failed, 130 interrupted."""

import argparse
import json
import os
import signal
import sys

PACKAGES = "python3-numpy python3-h5py python3-h5netcdf python3-xarray python3-matplotlib"


def fail(code, message):
    print(f"swirl: {' '.join(str(message).split())}", file=sys.stderr)
    sys.exit(code)


class Parser(argparse.ArgumentParser):
    def error(self, message):
        fail(2, message)


def arguments():
    parser = Parser(description="Draws a record of swirl.", allow_abbrev=False)
    parser.add_argument("record", metavar="RECORD", help="a record (HDF5)")
    parser.add_argument("-o", "--output", metavar="FIGURE", required=True, help="a .png, .svg or .pdf file")
    parser.add_argument("--kind", metavar="NAME", help="the figure's kind, where a record can be drawn in several ways")
    parser.add_argument("--json", action="store_true", help="say as JSON what was drawn")
    parser.add_argument("--quiet", action="store_true", help="say nothing")
    return parser.parse_args()


def load_figures():
    try:
        import swirl_figures
        import h5netcdf  # the engine with which xarray opens a record
    except ImportError as error:
        fail(2, f"{error.name} cannot be loaded by {sys.executable}: figures need the Debian packages {PACKAGES}")
    return swirl_figures


def report(options, kind):
    if options.json:
        print(json.dumps({"figure": options.output, "kind": kind, "record": options.record}))
    elif not options.quiet:
        print(f"{options.output}: {kind}")
    sys.stdout.flush()


def keep_libraries_silent():
    """What HDF5 or the allocator prints when a damaged record ends it is no answer: only sys.stderr speaks."""
    sys.stderr = os.fdopen(os.dup(2), "w", errors="surrogateescape")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)


def main():
    keep_libraries_silent()
    for number in (signal.SIGINT, signal.SIGTERM):  # until the very end nothing is on disk: leave at once
        signal.signal(number, lambda *_: os._exit(130))
    sys.stdout.reconfigure(errors="surrogateescape")  # file names that are no UTF-8 are said as they are
    options = arguments()
    figures = load_figures()
    try:
        record = figures.open_record(options.record)
        kind = figures.kind_of(record, options.kind)
        figure = figures.draw(record, kind)
    except figures.RecordError as error:
        fail(2, error)
    except OSError as error:  # a damaged part that opening did not touch
        fail(2, f"cannot read record '{options.record}': {error}")
    except Exception as error:  # an edited record, or another program's, in which something is not as swirl writes it
        fail(2, f"cannot draw record '{options.record}': {type(error).__name__}: {error}")
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
    try:
        figures.save(figure, options.output)
    except ValueError as error:
        fail(2, error)
    except OSError as error:
        fail(4, f"cannot write figure '{options.output}': {error.strerror}")
    try:
        report(options, kind)
    except OSError:
        print("swirl: cannot write to standard output", file=sys.stderr, flush=True)
        os._exit(4)  # an orderly exit would try the same write again


if __name__ == "__main__":
    main()
