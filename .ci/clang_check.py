#!/usr/bin/python3
"""Clang's warnings in every source, and every header compiled alone; no code is generated.

usage: clang_check.py BUILD [--tidy] [--cache FOLDER] [--jobs N] [FILE...]

BUILD holds a compile_commands.json made for clang. Each source of map/, analysis/, apps/ and tests/ is compiled as far
as clang's warnings need it; each header is compiled as if it were a source, so that it includes what it uses. Any
finding is an error. --tidy: clang-tidy with the checks of .clang-tidy but the static analyser's looks at the sources
instead, at 20 to 40 seconds a file. With --cache what was found clean is not looked at again until its preprocessed
text, its flags or the checks change. FILE: only these.
"""

import argparse
import hashlib
import json
import os
import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("map", "analysis", "apps", "tests")
TIDY = "clang-tidy-14"
CHECKS = "-clang-analyzer-*"
KEPT = 30 * 86400  # seconds for which a stamp that nothing asks for is kept


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


def headers(known):
    """{header: flags}, those of a source in the same folder, or of one in the nearest folder above."""
    by_folder = {}
    for file, flags in known.items():
        by_folder.setdefault(file.parent, flags)
        by_folder.setdefault(ROOT / file.relative_to(ROOT).parts[0], flags)
    found = {}
    for folder in FOLDERS:
        for header in sorted((ROOT / folder).rglob("*.hpp")):
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


def key_of(file, flags, directory, settings):
    """What the result depends on; None if the text cannot even be preprocessed."""
    text = run(flags + ["-E", str(file)], directory)
    if text.returncode != 0:
        return None
    own = file.read_text(encoding="utf-8")  # with its comments, which may tell clang-tidy something
    content = "\0".join([settings, *flags, own, text.stdout]).replace(str(ROOT), "")
    return hashlib.sha256(content.encode()).hexdigest()


def findings(file, flags, directory, arguments):
    """What clang or clang-tidy says of a file; empty if it ended well."""
    if arguments.tidy and file.suffix != ".hpp":
        result = run([TIDY, "-p", str(arguments.build), "--quiet", f"--checks={CHECKS}", "--warnings-as-errors=*",
                      str(file)], directory)
    else:
        result = run(flags + ["-fsyntax-only", str(file)], directory)
    if result.returncode == 0:
        return ""
    return (result.stdout + result.stderr).strip() or f"exit code {result.returncode} without a word"


def look_at(file, command, arguments, settings):
    flags, directory = command
    stamp = None
    if arguments.cache:
        key = key_of(file, flags, directory, settings)
        stamp = arguments.cache / key if key else None
        if stamp and stamp.exists():
            stamp.touch()
            return file, "", 0.0
    begin = time.monotonic()
    said = findings(file, flags, directory, arguments)
    if stamp and not said:
        stamp.touch()
    return file, said, time.monotonic() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("--tidy", action="store_true")
    parser.add_argument("--cache", type=Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("files", nargs="*", type=Path)
    arguments = parser.parse_intermixed_args()
    arguments.build = arguments.build.resolve()
    known = commands(arguments.build)
    known.update(headers(known))
    if arguments.files:
        for file in arguments.files:
            if file.resolve() not in known:
                sys.exit(f"clang_check: {file} is no source or header of the build")
        known = {file.resolve(): known[file.resolve()] for file in arguments.files}
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
        settings = run([TIDY, "--version"], ROOT).stdout + CHECKS + (ROOT / ".clang-tidy").read_text()
    results = []
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for result in pool.map(lambda item: look_at(*item, arguments, settings), sorted(known.items())):
            results.append(result)
            if result[1]:
                print(f"---- {result[0].relative_to(ROOT)}\n{result[1]}", flush=True)
    wrong = sum(1 for _, said, _ in results if said)
    looked = sum(1 for _, said, seconds in results if seconds > 0)
    print(f"{len(results)} files, {looked} looked at, {len(results) - looked} known to be clean; {wrong} with findings")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
