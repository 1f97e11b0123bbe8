"""Finds types of one qualified name in two places: check_names.py ROOT

Two classes of one name in one namespace, defined in two files of a program, break the one-definition rule (ISO C++
[basic.def.odr]) without a word from compiler or linker: the linker takes one of each pair of equal inline functions for
both. Prints one line per such name and exits 1 if there is any; 2 if ROOT holds no sources.

Looked at are classes, structs, unions and enumerations at namespace scope in the .hpp and .cpp files of map/, analysis/
and apps/, and those of each test program's folder together with them. What stands in an unnamed namespace belongs to
its file alone. The files are as clang-format leaves them: what stands at namespace scope begins its line.
"""

import re
import sys
from pathlib import Path

FOLDERS = ("map", "analysis", "apps", "tests")

OPEN = re.compile(r"^(?:inline )?namespace\s*([\w:]*)\s*\{(?!.*\})")
CLOSE = re.compile(r"^\}  // namespace")
TYPE = re.compile(r"^(?:template\s*<.*>\s*)?(?:struct|class|union|enum(?: class| struct)?)\s+(?:\[\[.*?\]\]\s*)?(\w+)"
                  r"(?:\s+final)?\s*(?::(?!:)|\{|$)")


def types_of(lines):
    """(line number, qualified name) of the types that are defined at namespace scope, unnamed namespaces left out."""
    scopes = []
    for number, line in enumerate(lines, 1):
        opened = OPEN.match(line)
        if opened:
            scopes.append(opened.group(1))
        elif CLOSE.match(line) and scopes:
            scopes.pop()
        elif "" not in scopes:
            found = TYPE.match(line)
            if found:
                yield number, "::".join(scopes + [found.group(1)])


def program_of(name):
    """The test folder whose programs a file may be linked into; None for the product, which is in every program."""
    return Path(name).parent.as_posix() if name.startswith("tests/") else None


def check(root):
    """All names with two definitions that one program may hold, as lines of text."""
    places = {}
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in (".hpp", ".cpp"):
                name = file.relative_to(root).as_posix()
                for line, qualified in types_of(file.read_text(encoding="utf-8").splitlines()):
                    places.setdefault(qualified, []).append((name, line))
    found = []
    for qualified, where in sorted(places.items()):
        for i, (name, line) in enumerate(where):
            for other, other_line in where[i + 1:]:
                programs = {program_of(name), program_of(other)}
                if len(programs) == 1 or None in programs:
                    found.append(f"{qualified}: {name}:{line} and {other}:{other_line}")
    return found, sum(len(where) for where in places.values())


def main(arguments):
    root = Path(arguments[0]) if len(arguments) == 1 else None
    found, count = check(root) if root else ([], 0)
    if count == 0:  # a check of nothing must not pass
        print(f"usage: check_names.py ROOT, with C++ files in {', '.join(FOLDERS)}", file=sys.stderr)
        return 2
    print("\n".join(found) if found else f"{count} types, each name in one place")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
