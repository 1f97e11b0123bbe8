"""Checks that files and functions stay small: check_sizes.py ROOT

Prints one line per violation, `file:line: what is too long`, and exits 1 if there is any; 2 if ROOT holds no sources.
No .hpp, .cpp or .py file of map/, analysis/, apps/ and notebooks-export/ has more than 500 lines, no function of the C++
files more than 60, from the line of its opening brace to that of its closing one. The files are as clang-format leaves
them: the brace that opens a function ends its line, and the one that closes it stands alone at the same indentation.
"""

import re
import sys
from pathlib import Path

FOLDERS = ("map", "analysis", "apps", "notebooks-export")
LONGEST_FILE = 500
LONGEST_FUNCTION = 60

NO_FUNCTION = re.compile(r"^\s*(inline |export )?(namespace|extern|struct|class|union|enum|concept)\b")
NO_CODE = re.compile(r"^\s*(//|#|\*)")
STATEMENT = re.compile(r"^\s*(\} )?(if|else|for|while|do|switch|case|default|try|catch)\b")


def opens_function(line, before):
    """True if a line's last brace opens the body of a function: `name(…) … {`, its arguments on the lines before."""
    if not line.endswith("{") or NO_FUNCTION.match(line) or STATEMENT.match(line) or NO_CODE.match(line):
        return False
    if NO_FUNCTION.match(before):  # a class with its bases on a line of their own
        return False
    return ")" in line and not re.search(r"[=,(]\s*\{$", line)


def functions_of(lines):
    """(line number, length) of the functions, those in classes included; lambdas count with the function around them.

    A body closes at the first line that begins with the brace at less indentation than the body's first line: arguments
    and initialisers of members that stand on lines of their own are indented more than the function itself.
    """
    row = 0
    while row < len(lines):
        if opens_function(lines[row], lines[row - 1] if row else ""):
            body = next((line for line in lines[row + 1:] if line.strip()), "")
            inner = len(body) - len(body.lstrip())
            end = next((i for i in range(row + 1, len(lines)) if closes(lines[i], inner)), len(lines) - 1)
            yield row + 1, end - row + 1
            row = end
        row += 1


def closes(line, inner):
    return line.lstrip().startswith("}") and len(line) - len(line.lstrip()) < inner


def check(root):
    """All violations below root, as lines of text."""
    found = []
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".hpp", ".cpp", ".py"):
                continue
            lines = file.read_text(encoding="utf-8").splitlines()
            name = file.relative_to(root).as_posix()
            if len(lines) > LONGEST_FILE:
                found.append(f"{name}:{len(lines)}: {len(lines)} lines; at most {LONGEST_FILE}")
            if file.suffix == ".py":
                continue
            found += [f"{name}:{line}: a function of {length} lines; at most {LONGEST_FUNCTION}"
                      for line, length in functions_of(lines) if length > LONGEST_FUNCTION]
    return found


def main(arguments):
    root = Path(arguments[0]) if len(arguments) == 1 else None
    if not root or not any((root / folder).is_dir() for folder in FOLDERS):  # a check of nothing must not pass
        print(f"usage: check_sizes.py ROOT, with C++ files in {', '.join(FOLDERS)}", file=sys.stderr)
        return 2
    found = check(root)
    print("\n".join(found) if found else "no file and no function is too long")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
