#!/usr/bin/python3
"""The notebook of a record of swirl: notebook_of_record.py RECORD -o FILE.ipynb. `swirl notebook` runs it."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))  # also of a Python that is told to look at nothing (-I)

import script


def load_notebooks():
    try:
        import ipykernel, nbclient, nbformat  # noqa: F401
        import swirl_notebooks.of_record
    except ImportError as error:
        script.fail(2, f"{error.name} cannot be loaded by {sys.executable}: notebooks need the Debian packages "
                       "python3-nbformat python3-nbclient python3-ipykernel")
    return swirl_notebooks


def main():
    script.say_names_as_they_are()
    options = script.Parser("The notebook of a record of swirl.", "notebook, an .ipynb file,").parse_args()
    script.leave_when_interrupted()
    figures, notebooks = script.load_figures(), load_notebooks()
    book, kind = script.made_from(
        options.record, lambda: notebooks.of_record.notebook_of_record(options.record[0], options.output),
        done="make a notebook of")
    content = notebooks.cells.as_bytes(book)
    script.saved("notebook", options.output, lambda: figures.output.write_whole(content, options.output))
    script.report(options, "notebook", kind)


if __name__ == "__main__":
    main()
