"""The answers of a fixed set of commands (commands.txt), before and after a change.

  compare.py --run SWIRL -o FOLDER [--only NAME ...]   runs the set with one binary and keeps the answers
  compare.py OLD NEW [--expected FILE]                 compares two such folders, command by command

A comparison prints for each command `same` or what differs, with the first place where it does, and then the counts. It
exits 1 if a command differs that FILE (expected_changes.txt here) does not name, or if one does not differ that it
names; 2 if there is nothing to compare.
"""

import argparse
import sys
from pathlib import Path

from run_commands import HERE, BadSet, read_commands, run_commands

WINDOW = 60  # characters shown before and after the first that differs


def first_difference(old, new):
    """Where two texts differ first, in three lines: the place, and both texts around it."""
    before, after = (text.decode("utf-8", "replace").split("\n") for text in (old, new))
    row = next((i for i, (a, b) in enumerate(zip(before, after)) if a != b), min(len(before), len(after)))
    a, b = (lines[row] if row < len(lines) else None for lines in (before, after))
    if a is None or b is None:
        return [f"line {row + 1}", *(f"{word}: {'(ended)' if x is None else x[:2 * WINDOW]}"
                                     for word, x in (("old", a), ("new", b)))]
    column = next((i for i, (x, y) in enumerate(zip(a, b)) if x != y), min(len(a), len(b)))
    begin = max(0, column - WINDOW)
    return [f"line {row + 1}, character {column + 1}",
            *(f"{word}: {'…' if begin else ''}{x[begin:column + WINDOW]}{'…' if len(x) > column + WINDOW else ''}"
              for word, x in (("old", a), ("new", b)))]


def listed_files(folder):
    """{name: (size, SHA-256)} of the files that a command left."""
    rows = (line.rsplit(" ", 2) for line in (folder / "files").read_text(encoding="utf-8").splitlines())
    return {name: tuple(rest) for name, *rest in rows}


def _stored_kinds(folder):
    """{stored file: what it is called} of the answers of a command, but for the list of files."""
    names = sorted(path.name for path in folder.iterdir() if path.name != "files")
    return {name: f"{name[:-5]} content" if name.endswith(".h5.text") else name for name in names}


def differences(old, new):
    """[(what differs, lines that say where)] between two folders of one command."""
    found = []
    kinds = {**_stored_kinds(old), **_stored_kinds(new)}
    for name, kind in kinds.items():
        texts = [(folder / name).read_bytes() if (folder / name).is_file() else None for folder in (old, new)]
        if None in texts:
            continue  # the lists of files say so
        if texts[0] != texts[1]:
            found.append((kind, first_difference(*texts)))
    before, after = listed_files(old), listed_files(new)
    for name in sorted(before.keys() | after.keys()):
        if name not in after or name not in before:
            found.append((name, [f"only the {'old' if name in before else 'new'} one left it"]))
        elif before[name] != after[name]:
            sizes = [f"{word}: {size} bytes, SHA-256 {digest}"
                     for word, (size, digest) in (("old", before[name]), ("new", after[name]))]
            found.append((f"{name} bytes", sizes))
    return found


def read_expected(path):
    """{name: reason} of the commands that are meant to differ."""
    expected = {}
    for number, text in enumerate(Path(path).read_text(encoding="utf-8").splitlines(), 1):
        if not text.strip() or text.startswith("#"):
            continue
        name, colon, reason = text.partition(": ")
        if not colon or not reason.strip():
            raise BadSet(f"{path}, line {number}: NAME: REASON is wanted, not '{text}'")
        expected[name] = reason.strip()
    return expected


def commands_in(folder):
    if not Path(folder).is_dir():
        raise BadSet(f"folder '{folder}' does not exist")
    return {path.name for path in Path(folder).iterdir() if (path / "command").is_file()}


def compare(old, new, expected, report=print):
    """Reports on every command of two folders. True if exactly the expected ones differ."""
    in_old, in_new = commands_in(old), commands_in(new)
    if not in_old or not in_new:
        raise BadSet(f"folder '{new if in_old else old}' holds no answers")
    differing = set()
    for name in sorted(in_old | in_new):
        if name in in_old and name in in_new:
            found = differences(Path(old) / name, Path(new) / name)
        else:
            found = [(f"only in the {'old' if name in in_old else 'new'} folder", [])]
        if not found:
            report(f"{name}: same")
            continue
        differing.add(name)
        reason = f" (expected: {expected[name]})" if name in expected else ""
        report(f"{name}: DIFFERS: {', '.join(what for what, _ in found)}{reason}")
        for what, lines in found:
            for i, line in enumerate(lines):
                report(f"    {what}, {line}" if i == 0 else f"        {line}")
    idle = sorted(expected.keys() - differing)
    for name in idle:
        report(f"{name}: expected to differ, and does not ({expected[name]})")
    count, known = len(in_old | in_new), len(differing & expected.keys())
    report(f"{count} commands: {count - len(differing)} same, {known} differ as expected, "
           f"{len(differing) - known} differ unexpectedly, {len(idle)} expected to differ and do not")
    return known == len(differing) and not idle


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="*", metavar="FOLDER", help="the old answers and the new ones")
    parser.add_argument("--run", metavar="SWIRL", help="the binary whose answers are to be kept")
    parser.add_argument("-o", "--output", metavar="FOLDER", help="where to keep them")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="run only these of the set")
    parser.add_argument("--expected", metavar="FILE", default=HERE / "expected_changes.txt",
                        help="the commands that are meant to differ, as NAME: REASON")
    options = parser.parse_args(arguments)
    if options.run and (options.folders or not options.output):
        parser.error("--run SWIRL goes with -o FOLDER")
    if not options.run and len(options.folders) != 2:
        parser.error("two folders are compared: OLD NEW")
    return options


def run_set(options):
    commands = read_commands(HERE / "commands.txt")
    unknown = set(options.only or ()) - commands.keys()
    if unknown:
        raise BadSet(f"no command of the set is named {', '.join(sorted(unknown))}")
    if options.only:
        commands = {name: commands[name] for name in options.only}
    seconds = run_commands(options.run, options.output, commands)
    print(f"{len(seconds)} commands in {sum(seconds.values()):.0f} s")


def main(arguments):
    options = parsed(arguments)
    try:
        if options.run:
            run_set(options)
            return 0
        return 0 if compare(*options.folders, read_expected(options.expected)) else 1
    except (BadSet, OSError) as error:
        print(f"compare.py: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
