#!/usr/bin/python3
"""Makes the worked notebooks, with the records that they read: make_worked.py SWIRL [-o FOLDER] [NAME…]"""

import argparse
import tempfile
from pathlib import Path

from swirl_figures.output import write_whole
from swirl_notebooks.cells import as_bytes
from swirl_notebooks.worked import NAMES, worked_notebook


def main():
    parser = argparse.ArgumentParser(description="Makes the worked notebooks.")
    parser.add_argument("swirl", help="the program")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(NAMES)} (default: all)")
    parser.add_argument("-o", "--output", default=Path(__file__).parent, type=Path, help="the folder (default: this one)")
    options = parser.parse_args()
    for name in options.names or NAMES:
        with tempfile.TemporaryDirectory() as folder:
            book = worked_notebook(name, str(Path(options.swirl).resolve()), folder)
        path = options.output / f"{name}.ipynb"
        write_whole(as_bytes(book), path)
        print(f"{path}: {path.stat().st_size:,} bytes")


if __name__ == "__main__":
    main()
