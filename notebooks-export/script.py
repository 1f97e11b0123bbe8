"""What the scripts of this folder share: how they fail, what they say, and that they leave nothing half done.

Exit codes are those of `swirl`: 0 done, 2 bad input, 4 writing failed, 130 interrupted."""

import argparse
import gc
import json
import os
import signal
import sys

PACKAGES = "python3-numpy python3-h5py python3-matplotlib"


def fail(code, message):
    print(f"swirl: {' '.join(str(message).split())}", file=sys.stderr)
    sys.exit(code)


class Parser(argparse.ArgumentParser):
    """With RECORD, -o, --json and --quiet; an error is one line."""

    def __init__(self, description, noun, several=False):
        super().__init__(description=description, allow_abbrev=False)
        self.add_argument("record", metavar="RECORD", nargs="+" if several else 1, help="a record (HDF5)")
        self.add_argument("-o", "--output", metavar="FILE", required=True, help=f"the {noun} to write")
        self.add_argument("--json", action="store_true", help="say as JSON what was made")
        self.add_argument("--quiet", action="store_true", help="say nothing")

    def error(self, message):
        fail(2, message)


def load_figures():
    """The package. What it loads stays until the end: looking for garbage in it, now, later and on the way out, would take a
    third of the time before a figure is begun."""
    gc.disable()
    try:
        import swirl_figures
    except ImportError as error:
        fail(2, f"{error.name} cannot be loaded by {sys.executable}: figures need the Debian packages {PACKAGES}")
    gc.freeze()
    gc.enable()
    return swirl_figures


NUMBERS_OF_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def _on_signals(action):
    """`swirl` holds them back until then, so that none ends Python's own start in a traceback."""
    for number in NUMBERS_OF_SIGNALS:
        signal.signal(number, action)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, NUMBERS_OF_SIGNALS)


def leave_at_once_when_interrupted():
    """While nothing is on disk."""
    _on_signals(lambda *_: os._exit(130))


def leave_when_interrupted():
    """While files are being written: an exception, so that what is unfinished is removed on the way out."""
    def leave(*_):
        for number in NUMBERS_OF_SIGNALS:
            signal.signal(number, signal.SIG_IGN)
        sys.exit(130)
    _on_signals(leave)


def hold_interruptions():
    signal.pthread_sigmask(signal.SIG_BLOCK, NUMBERS_OF_SIGNALS)


def value_of(convert, text):
    """An argument's value; what convert refuses (ValueError) is bad input."""
    if text is None:
        return None
    try:
        return convert(text)
    except ValueError as error:
        fail(2, error)


def made_from(records, make, done="draw"):
    """make(), with what may be wrong with a record in one line."""
    figures = load_figures()
    names = "', '".join(records)
    try:
        return make()
    except figures.RecordError as error:
        fail(2, error)
    except OSError as error:  # a damaged part that opening did not touch
        fail(2, f"cannot read record '{names}': {error}")
    except Exception as error:  # an edited record, or another program's, in which something is not as swirl writes it
        fail(2, f"cannot {done} record '{names}': {type(error).__name__}: {error}")


def report(options, noun, kind):
    """Says what was made, as JSON or a line; exit 4 where it cannot be said."""
    try:
        if options.json:
            made = {noun: options.output, "kind": kind, "record": options.record[0]}
            if len(options.record) > 1:
                made["records"] = options.record
            if getattr(options, "caption", None):
                made["caption"] = options.caption
            print(json.dumps(made))
        elif not options.quiet:
            print(f"{options.output}: {kind}")
        sys.stdout.flush()
    except OSError:
        print("swirl: cannot write to standard output", file=sys.stderr, flush=True)
        os._exit(4)  # an orderly exit would try the same write again


def saved(noun, path, save, hold=True):
    """save(), whose failures are those of the file; it is not interrupted unless it takes long and tidies up itself."""
    if hold:
        hold_interruptions()
    try:
        save()
    except ValueError as error:
        fail(2, error)
    except OSError as error:
        fail(4, f"cannot write {noun} '{path}': {error.strerror or error}")


def say_names_as_they_are():
    """File names that are no UTF-8, too. What HDF5 or the allocator prints as a damaged record ends the process is no
    answer: only sys.stderr speaks."""
    sys.stdout.reconfigure(errors="surrogateescape")
    sys.stderr = os.fdopen(os.dup(2), "w", errors="surrogateescape")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
