#!/usr/bin/python3
"""Clang's warnings in every source, and every header compiled alone; no code is generated.

usage: clang_check.py BUILD [--headers | --tidy] [--seconds N] [--cache FOLDER] [--jobs N] [FILE...]

BUILD holds a compile_commands.json made for clang. Each source of map/, analysis/, apps/ and tests/ is compiled as far
as clang's warnings need it; each header is compiled as if it were a source, so that it includes what it uses, unless
it is the first thing that a source includes: that has shown the same. Any finding is an error. --headers: those headers
alone, where a build by clang has shown the sources. --tidy: clang-tidy with the checks of .clang-tidy but the static
analyser's looks at the sources instead, at 20 to 40 seconds a file. --seconds: after so many none is begun, and the last
line counts those that were not looked at. With --cache what was found clean is not looked at again until a file that it
read, its flags or the checks change. FILE: only these, in this order; of clang-tidy what it finds in them and in the
headers beside them.
"""

import argparse
import functools
import hashlib
import json
import math
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("map", "analysis", "apps", "tests")
TIDY = "clang-tidy-14"
CHECKS = "-clang-analyzer-*"
KEPT = 30 * 86400  # seconds for which a stamp that nothing asks for is kept
LOOKED_AT, KNOWN, LEFT_OUT = "looked at", "known to be clean", "left out for want of time"


def flags_of(entry):
    """A compile command without its output and its input: what decides what the text means."""
    words = shlex.split(entry["command"])
    words = words[next(i for i, word in enumerate(words) if "clang" in os.path.basename(word)):]
    kept, skip = [], False
    for word in words:
        if skip or word in ("-c", "-o"):
            skip = word == "-o"
            continue
        kept.append(word)
    return kept[:-1]


def commands(build):
    """{file: flags} of the project's own sources."""
    database = build / "compile_commands.json"
    if not database.is_file():
        sys.exit(f"clang_check: there is no {database}; CONTRIBUTING.md has the line that makes it")
    entries = json.loads(database.read_text())
    inside = [e for e in entries if Path(e["file"]).is_relative_to(ROOT)
              and Path(e["file"]).relative_to(ROOT).parts[0] in FOLDERS]
    return {Path(e["file"]): (flags_of(e), e["directory"]) for e in inside}


def is_first_include(header, known):
    """True if the source beside a header includes it before anything else."""
    source = header.with_suffix(".cpp")
    if source not in known:
        return False
    first = re.search(r'^#include\s+["<](.+)[">]', source.read_text(encoding="utf-8"), re.MULTILINE)
    return first is not None and first[1] == str(header.relative_to(ROOT))


def headers(known):
    """{header: flags}, those of a source in the same folder, or of one in the nearest folder above."""
    by_folder = {}
    for file, flags in known.items():
        by_folder.setdefault(file.parent, flags)
        by_folder.setdefault(ROOT / file.relative_to(ROOT).parts[0], flags)
    found = {}
    for folder in FOLDERS:
        for header in sorted((ROOT / folder).rglob("*.hpp")):
            if header.name.endswith("_formulas.hpp"):  # no header: a text that others read inside of their namespaces
                continue
            place = header.parent
            while place not in by_folder and place != ROOT:
                place = place.parent
            if place == ROOT:
                sys.exit(f"clang_check: no source of {folder}/ is in the build, so its headers have no flags")
            flags, directory = by_folder[place]
            found[header] = (flags + ["-Wno-pragma-once-outside-header", "-Wno-unused-const-variable",
                                      "-Wno-unused-function", "-x", "c++"], directory)
    return found


def run(command, directory):
    return subprocess.run(command, cwd=directory, capture_output=True, text=True, errors="replace", check=False)


@functools.cache
def content_of(file):
    """A file's hash; None if there is none."""
    try:
        return hashlib.sha256(Path(file).read_bytes()).hexdigest()
    except OSError:
        return None


class Stamp:
    """What was found clean: the files that were read, with their hashes, under the name of a source and its flags."""

    def __init__(self, folder, file, flags, settings):
        name = "\0".join([settings, str(file.relative_to(ROOT)), *flags]).replace(str(ROOT), "")
        self.path = folder / hashlib.sha256(name.encode()).hexdigest()

    def holds(self):
        try:
            read = json.loads(self.path.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return False
        if any(content_of(name.replace("ROOT", str(ROOT), 1)) != found for name, found in read.items()):
            return False
        self.path.touch()
        return True

    def keep(self, names):
        read = {re.sub(f"^{re.escape(str(ROOT))}/", "ROOT/", name): content_of(name) for name in names}
        self.path.write_text(json.dumps(read), encoding="utf-8")


def names_in(rules, directory):
    """The files that a makefile's rule, as the compiler writes it, depends on."""
    words = shlex.split(rules.replace("\\\n", " ").split(":", 1)[1])
    return [os.path.normpath(os.path.join(directory, word)) for word in words]


def findings(file, flags, directory, arguments):
    """What clang or clang-tidy says of a file, empty if it ended well; and the files that it read."""
    with tempfile.NamedTemporaryFile("r", encoding="utf-8") as rules:
        result = run(flags + ["-fsyntax-only", "-MD", "-MF", rules.name, str(file)], directory)
        if result.returncode == 0 and arguments.tidy and file.suffix != ".hpp":
            # Of files that were asked for: what stands in them and the headers beside them, not in all that they include.
            own = [f"--header-filter=^{re.escape(str(file.with_suffix('.hpp')))}$"] if arguments.files else []
            result = run([TIDY, "-p", str(arguments.build), "--quiet", f"--checks={CHECKS}", "--warnings-as-errors=*",
                          *own, str(file)], directory)
        if result.returncode == 0:
            return "", names_in(rules.read(), directory)
    return (result.stdout + result.stderr).strip() or f"exit code {result.returncode} without a word", []


def look_at(file, command, arguments, settings):
    """The file, what was said of it, and whether it was LOOKED_AT, KNOWN or LEFT_OUT."""
    flags, directory = command
    stamp = Stamp(arguments.cache, file, flags, settings) if arguments.cache else None
    if stamp and stamp.holds():
        return file, "", KNOWN
    if time.monotonic() > arguments.end:
        return file, "", LEFT_OUT
    said, read = findings(file, flags, directory, arguments)
    if stamp and not said:
        stamp.keep(read)
    return file, said, LOOKED_AT


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--headers", action="store_true")
    what.add_argument("--tidy", action="store_true")
    parser.add_argument("--seconds", type=float, default=math.inf)
    parser.add_argument("--cache", type=Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("files", nargs="*", type=Path)
    arguments = parser.parse_intermixed_args()
    arguments.build = arguments.build.resolve()
    arguments.end = time.monotonic() + arguments.seconds
    known = commands(arguments.build)
    alone = headers(known)
    known.update(alone)
    if arguments.files:
        for file in arguments.files:
            if file.resolve() not in known:
                sys.exit(f"clang_check: {file} is no source or header of the build")
        known = {file.resolve(): known[file.resolve()] for file in arguments.files}
    else:
        known = {file: command for file, command in sorted(known.items())
                 if (file not in alone and not arguments.headers) or (file in alone and not is_first_include(file, known))}
    if not known:  # a check of nothing must not pass
        print(f"clang_check: no source of {', '.join(FOLDERS)} in {arguments.build}", file=sys.stderr)
        return 2
    if arguments.cache:
        arguments.cache.mkdir(parents=True, exist_ok=True)
        for stamp in arguments.cache.iterdir():
            if time.time() - stamp.stat().st_mtime > KEPT:
                stamp.unlink()
    settings = "warnings"  # the compiler is named in the flags
    if arguments.tidy:
        settings = ("own" if arguments.files else "all") + run([TIDY, "--version"], ROOT).stdout + CHECKS + (ROOT / ".clang-tidy").read_text()
    results = []
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for result in pool.map(lambda item: look_at(*item, arguments, settings), known.items()):
            results.append(result)
            if result[1]:
                print(f"---- {result[0].relative_to(ROOT)}\n{result[1]}", flush=True)
    wrong = sum(1 for _, said, _ in results if said)
    counts = [f"{sum(1 for result in results if result[2] == kind)} {kind}" for kind in (LOOKED_AT, KNOWN, LEFT_OUT)]
    print(f"{len(results)} files: {', '.join(counts)}; {wrong} with findings")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
