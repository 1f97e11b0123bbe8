#!/usr/bin/python3
"""Which lines and branches the tests reach: coverage.py BUILD [-R PATTERN] [--jobs N] [--no-run] [FOLDER …]

Runs the default tests of BUILD (made by the preset `coverage`; with -R those whose name matches), and prints for each
folder of map/, analysis/ and apps/ (or of FOLDERs) the lines and branches that ran, then what did not: functions that
nothing called, and lines in between. A line of a template counts once, whatever its instances. --no-run: what the last
run left."""

import argparse
import os
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROFDATA, COV, FILT = "llvm-profdata-14", "llvm-cov-14", "llvm-cxxfilt-14"


def run_tests(build, pattern, jobs):
    """Each binary leaves its counts in files of its own, up to four, into which its processes add."""
    counts = build / "coverage"
    counts.mkdir(exist_ok=True)
    for old in counts.glob("*.profraw"):
        old.unlink()
    command = ["ctest", "--test-dir", str(build), "--label-exclude", "nightly", "--parallel", str(jobs), "--no-tests=error"]
    command += ["-R", pattern] if pattern else []
    done = subprocess.run(command, env={**os.environ, "LLVM_PROFILE_FILE": f"{counts}/%4m.profraw"})
    if done.returncode != 0:
        print("coverage.py: some tests failed; what they reached counts all the same", file=sys.stderr)


def binaries(build):
    """The programs and tests that are linked: what did not run counts, too."""
    found = [build / "apps" / "swirl"] + [path for path in (build / "tests").rglob("*")
                                          if path.is_file() and os.access(path, os.X_OK) and path.read_bytes()[:4] == b"\x7fELF"]
    return [path for path in found if path.exists() and path.suffix != ".so"]


def exported(build):
    """llvm-cov's lines in the format of lcov."""
    counts = build / "coverage"
    raw = sorted(counts.glob("*.profraw"))
    if not raw:
        sys.exit(f"coverage.py: no counts in {counts}: no test ran, or {build} is not of the preset coverage")
    subprocess.run([PROFDATA, "merge", "-sparse", *raw, "-o", counts / "all.profdata"], check=True)
    first, *others = binaries(build)
    command = [COV, "export", "-format=lcov", f"-instr-profile={counts / 'all.profdata'}", first]
    command += [f"-object={other}" for other in others]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def keep_larger(counts, key, count):
    counts[key] = max(counts.get(key, 0), count)


def read(lines):
    """{file: {"lines": {number: count}, "branches": {(line, block, branch): count}, "calls": {name: count}, "begins": {name: line}}}

    A file comes under two names where some objects know it by its path and others from their build folder."""
    files = {}
    for line in lines:
        key, _, rest = line.partition(":")
        if key == "SF":
            file = files.setdefault(os.path.relpath(rest, ROOT), defaultdict(dict))
        elif key == "DA":
            number, count = rest.split(",")[:2]
            keep_larger(file["lines"], int(number), int(count))
        elif key == "BRDA":
            *place, count = rest.split(",")
            keep_larger(file["branches"], tuple(place), 0 if count == "-" else int(count))
        elif key == "FN":
            number, name = rest.split(",", 1)
            file["begins"][name] = int(number)
        elif key == "FNDA":
            count, name = rest.split(",", 1)
            keep_larger(file["calls"], name, int(count))
    return {name: file for name, file in files.items() if name.split(os.sep)[0] in ("map", "analysis", "apps")}


def share(counts):
    reached = sum(1 for count in counts if count > 0)
    return f"{reached:6} of {len(counts):6} {100 * reached / len(counts):6.1f} %" if counts else f"{'none':>24}"


def print_table(files, folders):
    rows = defaultdict(lambda: ([], []))
    for name, file in files.items():
        parts = Path(name).parts
        for folder in (parts[0], "/".join(parts[:2]) if len(parts) > 2 else parts[0] + "/*"):
            rows[folder][0].extend(file["lines"].values())
            rows[folder][1].extend(file["branches"].values())
    print(f"{'folder':24} {'lines':>24} {'branches':>24}")
    for folder in sorted(rows):
        if folder.startswith(tuple(folders)):
            print(f"{folder:24} {share(rows[folder][0])} {share(rows[folder][1])}")


def plain_names(mangled):
    """Of internal functions the file stands before the name."""
    names = [name.rsplit(":", 1)[-1] if ":" in name else name for name in mangled]
    text = subprocess.run([FILT], input="\n".join(names), check=True, capture_output=True, text=True).stdout
    return dict(zip(mangled, text.splitlines()))


def never_called(file):
    """{line where it begins: a name} of the functions no instance of which was called."""
    called = {file["begins"][name] for name, count in file["calls"].items() if count > 0}
    return {file["begins"][name]: name for name, count in file["calls"].items()
            if count == 0 and file["begins"][name] not in called}


def ranges(numbers):
    """"3-5, 9" of lines that did not run."""
    runs = []
    for number in sorted(numbers):
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return ", ".join(f"{first}-{last}" if last > first else str(first) for first, last in runs)


def print_missing(files, folders):
    for name in sorted(files):
        file = files[name]
        missing = [number for number, count in file["lines"].items() if count == 0]
        if not missing or not name.startswith(tuple(folders)):
            continue
        print(f"{name}: lines {ranges(missing)}")
        functions = never_called(file)
        names = plain_names(sorted(functions.values()))
        for line in sorted(functions):
            print(f"    {line}: {names[functions[line]][:160]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("folders", nargs="*", default=["map", "analysis", "apps"])
    parser.add_argument("-R", dest="pattern")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--no-run", action="store_true")
    options = parser.parse_args()
    build = options.build.resolve()
    if not options.no_run:
        run_tests(build, options.pattern, options.jobs)
    files = read(exported(build))
    print_table(files, options.folders)
    print("\nnot covered")
    print_missing(files, options.folders)


if __name__ == "__main__":
    main()
