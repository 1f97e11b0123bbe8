"""Checks that includes follow the layers of docs/architecture.svg: check_includes.py ROOT

Prints one line per violation, `file:line: what is wrong`, and exits 1 if there is any; 2 if ROOT holds no sources.
What is checked, in every .hpp and .cpp of map/, analysis/ and apps/:
  - a folder includes only the folders that it may know (FOLDERS);
  - apps/studies/ includes of apps/ only itself, and no other file of apps/ includes both map/ and analysis/: what joins
    them is a study;
  - map/ and analysis/ include only the libraries that are granted to them (LIBRARIES) and the C++ standard library;
  - the project's headers are included in quotes, by their path from the root, and exist;
  - a number type's header is included by the header that holds its traits alone (TRAITS): without these a file would
    compute with the traits of plain numbers;
  - what a newer release of a library declares in a header of its own comes with that header (DECLARED);
  - headers do not include each other in a circle.
"""

import re
import sys
from pathlib import Path

# folder -> the folders that it may include
FOLDERS = {
    "map": {"map"},
    "analysis": {"analysis"},
    "apps": {"map", "analysis", "apps"},
}

# within apps/: the library that computes what a question about a scene asks, without flags, files and documents
STUDIES = "apps/studies/"

# folder -> how the library headers that it may include begin; a folder not named here is free
LIBRARIES = {
    "map": ("Eigen/", "ceres/jet.h", "hwy/", "boost/", "Random123/", "gsl/", "flint/", "arb.h", "arb_mat.h", "acb.h", "acb_mat.h",
            "arf.h", "mag.h"),
    "analysis": ("Eigen/", "unsupported/Eigen/", "ceres/", "gsl/", "fftw3.h", "tbb/", "oneapi/tbb", "hwy/", "boost/",
                 "Random123/"),
    STUDIES: ("Eigen/", "gsl/", "tbb/", "boost/", "Random123/", "fmt/format.h"),
}

# library header -> the one file of map/ and apps/ that may include it
TRAITS = {
    "ceres/jet.h": "map/numbers/jets.hpp",
    "boost/multiprecision/float128.hpp": "map/numbers/quad.hpp",
}

# name -> the header that declares it in every release; a release that is older declares it in another, too
DECLARED = {
    "fmt::join(": "fmt/ranges.h",  # fmt 11 took it out of fmt/format.h
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD = re.compile(r"^[a-z_]+$")  # <vector>, <cmath>: no folder and no extension


def includes_of(file):
    """(line number, '<' or '"', name) of every include in a file."""
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1), match.group(2)


def violation(root, folder, file, bracket, name):
    """What is wrong with one include of a file in a folder (or STUDIES), or None."""
    target = name.split("/")[0]
    ours = target in FOLDERS or target == "tests"
    if bracket == "<":
        if ours and "/" in name:  # <map> is the standard library's
            return f"<{name}>: the project's own headers are included in quotes"
        if folder != "analysis" and TRAITS.get(name, file) != file:
            return f"<{name}>: {TRAITS[name]} includes it, with its traits, for all"
        allowed = LIBRARIES.get(folder)
        if allowed is None or STANDARD.match(name) or name.startswith(allowed):
            return None
        return f"<{name}>: {folder.strip('/')}/ may use only the standard library and {', '.join(allowed)}"
    if not ours:
        return f'"{name}": not a path from the root of the project'
    if folder == STUDIES:
        if target == "tests" or (target == "apps" and not name.startswith(STUDIES)):
            return f'"{name}": {STUDIES} may include only map, analysis and itself'
    elif target not in FOLDERS[folder]:
        return f'"{name}": {folder}/ may include only {", ".join(sorted(FOLDERS[folder]))}'
    if not (root / name).is_file():
        return f'"{name}": no such file'
    return None


def undeclared(file, included):
    """(name, header) of DECLARED that a file uses and does not include, of the headers that it includes."""
    text = file.read_text(encoding="utf-8")
    return [(name, header) for name, header in DECLARED.items() if name in text and header not in included]


def join(name, included):
    """What is wrong with all includes of a file together, or None. Lists of (line number, name)."""
    if not name.startswith("apps/") or name.startswith(STUDIES):
        return None
    first = {}
    for number, target in included:
        first.setdefault(target.split("/")[0], (number, target))
    if not {"map", "analysis"} <= set(first):
        return None
    number, target = max(first["map"], first["analysis"])
    return f'{name}:{number}: "{target}": map and analysis are joined in {STUDIES}, not in the command'


def find_circles(graph):
    """One path per circle of the include graph {file: [(line, included file)]}, found depth first."""
    circles, done = [], set()

    def visit(name, path):
        if name in path:
            circle = path[path.index(name):]
            first = circle.index(min(circle))  # the same circle reads the same wherever the search came in
            circles.append(circle[first:] + circle[:first + 1])
        elif name not in done:
            for _, included in graph.get(name, ()):
                visit(included, path + [name])
            done.add(name)

    for name in sorted(graph):
        visit(name, [])
    return circles


def source_files(root):
    """(folder, file) of every C++ file that the rules are for."""
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in (".hpp", ".cpp"):
                yield folder, file


def check(root):
    """All violations below root, as lines of text."""
    found, graph = [], {}
    for folder, file in source_files(root):
        name = file.relative_to(root).as_posix()
        part = STUDIES if name.startswith(STUDIES) else folder
        for number, bracket, included in includes_of(file):
            message = violation(root, part, name, bracket, included)
            if message:
                found.append(f"{name}:{number}: {message}")
            elif bracket == '"':
                graph.setdefault(name, []).append((number, included))
        for used, header in undeclared(file, {included for _, _, included in includes_of(file)}):
            found.append(f"{name}:0: {used}) is declared by <{header}>, which is not included")
        joined = join(name, graph.get(name, []))
        if joined:
            found.append(joined)
    found += [f"{circle[0]}:0: a circle of includes: {' -> '.join(circle)}" for circle in find_circles(graph)]
    return found


def main(arguments):
    root = Path(arguments[0]) if len(arguments) == 1 else None
    count = sum(1 for _ in source_files(root)) if root else 0
    if count == 0:  # a check of nothing must not pass
        print(f"usage: check_includes.py ROOT, with C++ files in {', '.join(FOLDERS)}", file=sys.stderr)
        return 2
    found = check(root)
    print("\n".join(found) if found else f"the includes of {count} files follow the layers of docs/architecture.svg")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
