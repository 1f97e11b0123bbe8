#!/usr/bin/python3
"""Screenshots of the site's pages, for a person to look at: screenshots.py SITE FOLDER [PAGE…]

Each PAGE of SITE (by default one of each sort) as it looks in Debian's chromium, on a desk and on a telephone, as
FOLDER/NAME-desk.png and FOLDER/NAME-telephone.png."""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

#: One of each sort: overview with figures, prose, tables, formulas, a page of the manual, the headers' list and one of them.
PAGES = ("index.html", "docs/tutorial.html", "docs/command-line.html", "map/index.html", "analysis/cycles/index.html",
         "manual/swirl-sweep.html", "api/files.html")
#: Width and height in pixels: the upper part of a long page.
WINDOWS = {"desk": (1280, 1600), "telephone": (420, 1600)}


def chromium():
    found = shutil.which("chromium") or shutil.which("chromium-browser")
    if not found:
        sys.exit("screenshots: chromium is missing: apt-get install --no-install-recommends chromium")
    return found


def take(page, file, size):
    """One page, in a browser of its own that keeps nothing."""
    with tempfile.TemporaryDirectory() as profile:
        command = [chromium(), "--headless", "--hide-scrollbars", "--disable-gpu", f"--user-data-dir={profile}",
                   f"--window-size={size[0]},{size[1]}", f"--screenshot={file}", page.as_uri()]
        if os.geteuid() == 0:  # the sandbox refuses root; the pages are the project's own
            command.insert(1, "--no-sandbox")
        result = subprocess.run(command, capture_output=True, text=True, timeout=120)
    if result.returncode != 0 or not file.exists():
        sys.exit(f"screenshots: chromium failed on {page}: {result.stderr.strip()[-300:]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("site", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("pages", nargs="*", default=PAGES, metavar="PAGE")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    for page in options.pages:
        path = (options.site / page).resolve()
        if not path.is_file():
            sys.exit(f"screenshots: {options.site} has no page {page}")
        for window, size in WINDOWS.items():
            file = options.folder.resolve() / f"{page.removesuffix('.html').replace('/', '-')}-{window}.png"
            take(path, file, size)
            print(file)


if __name__ == "__main__":
    main()
