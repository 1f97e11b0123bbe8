"""What the project's files use of the system: Python's modules, programs, headers, libraries and CMake's files.

Each function gives [(what, the file here that stands for it or None, who uses it)]."""

import ast
import functools
import importlib.util
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

KERNELS = Path("/usr/share/jupyter/kernels")
STARTS = {"run", "Popen", "call", "check_call", "check_output"}


@functools.cache
def python_sources(root):
    """[(name, its text, the same parsed)]: scripts, modules, the code of notebooks. A folder with a list of packages of its own (the site, other
    solvers) is no matter of the one list."""
    found, apart = [], {path.parent for path in root.rglob("packages.txt") if path.parent != root}
    for path in sorted([*root.rglob("*.py"), *root.rglob("*.ipynb")]):
        relative = path.relative_to(root)
        if relative.parts[0] in ("build", ".git", ".ci") or apart & set(path.parents):
            continue
        text = path.read_text(encoding="utf-8")
        if path.suffix == ".ipynb":
            cells = json.loads(text)["cells"]
            text = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
        found.append((str(relative), text, ast.parse(text)))
    return found


def _words(node):
    return [item.value for item in ast.walk(node) if isinstance(item, ast.Constant) and isinstance(item.value, str)]


def _modules_of(tree):
    """Names that are imported, also those that are given as words: an engine of xarray, find_spec's argument."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module
        elif isinstance(node, ast.Call):
            called = getattr(node.func, "attr", getattr(node.func, "id", ""))
            if called in ("import_module", "find_spec", "__import__"):
                yield from _words(node.args[0])
            yield from (word.value.value for word in node.keywords if word.arg == "engine" and isinstance(word.value, ast.Constant)
                        and isinstance(word.value.value, str))


def modules(root):
    files = python_sources(root)
    ours = {path.stem for path in root.rglob("*.py")} | {part for name, _, _ in files for part in Path(name).parts[:-1]}
    users = {}
    for file, _, tree in files:
        for name in _modules_of(tree):
            users.setdefault(name.split(".")[0], file)
    found = []
    for name in sorted(set(users) - ours - set(sys.stdlib_module_names)):
        spec = importlib.util.find_spec(name)
        origin = spec and (spec.origin or next(iter(spec.submodule_search_locations), None))
        found.append((f"module {name}", origin, users[name]))
    return found


def kernels(root):
    """Kernels of notebooks, which are named only."""
    users = {}
    for file, _, tree in python_sources(root):
        for node in ast.walk(tree):
            if isinstance(node, ast.keyword) and node.arg == "kernel_name" and isinstance(node.value, ast.Constant):
                users.setdefault(node.value.value, file)
    specs = {name: KERNELS / name / "kernel.json" for name in users}
    return [(f"kernel {name}", spec if spec.exists() else None, users[name]) for name, spec in specs.items()]


def _started(tree):
    """The first word of each list or tuple that is passed to a call of subprocess."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call) or not node.args:
            continue
        first, called = node.args[0], node.func
        if isinstance(called, ast.Attribute) and called.attr in STARTS and getattr(called.value, "id", "") == "subprocess":
            while isinstance(first, ast.BinOp):
                first = first.left
            if isinstance(first, (ast.List, ast.Tuple)) and first.elts:
                first = first.elts[0]
            yield first


def programs(root):
    """Programs that Python starts. One that is asked for first, by shutil.which in that file, may be missing."""
    users = {}
    for file, text, tree in python_sources(root):
        for word in _started(tree):
            if isinstance(word, ast.Constant) and isinstance(word.value, str):
                name = word.value.split()[0]
                if f'which("{name}")' not in text and "skipUnless" not in text.split(f'"{name}"')[0][-300:]:
                    users.setdefault(name, file)
    return [(f"program {name}", shutil.which(name), users[name]) for name in sorted(users)]


def programs_of_quickstart(root):
    """Words in the place of a command that are neither the shell's own nor functions there."""
    text = (root / "quickstart").read_text(encoding="utf-8")
    text = re.sub(r"cat <<END\n.*?\nEND\n", "cat\n", text, flags=re.S)
    code = "\n".join(line for line in text.splitlines() if not line.lstrip().startswith("#"))
    place = r"(?:^\s*|[|;&({]\s*|\b(?:then|do|if|have|as_root)\s+|apt=\(env (?:\w+=\w+ )*)"
    words = set(re.findall(rf"{place}(?:\w+=(?:'[^']*'|\S*) )*([a-z][a-z0-9-]+)(?=[ );]|$)", code, re.M))
    builtin = subprocess.run(["bash", "-c", "compgen -bk"], capture_output=True, text=True, check=True).stdout.split()
    functions = re.findall(r"^(\w+)\(\)", text, re.M)
    return [(f"program {name}", path, "quickstart") for name in sorted(words - set(builtin) - set(functions))
            if (path := shutil.which(name)) and name != "sudo"]


def _cache(build):
    return dict(re.findall(r"^(\w+):FILEPATH=(.*)$", (build / "CMakeCache.txt").read_text(encoding="utf-8"), re.M))


def programs_of_cmake(root, build):
    """What CMake found; not what the project's own find_program looks for, which may be missing."""
    own = {name for file in root.rglob("CMakeLists.txt") for name in re.findall(r"find_program\((\w+)", file.read_text())}
    own |= {name for file in (root / "cmake").glob("*.cmake") for name in re.findall(r"find_\w+\((\w+)", file.read_text())}
    return [(f"program {Path(path).name}", path, f"CMake's {name}") for name, path in _cache(build).items()
            if name not in own and not name.startswith("found_") and re.match(r"/usr(/local)?/bin/", path)]


def libraries(build):
    """What is linked, and the files of the libraries' CMake packages, with those that they want to exist."""
    text = (build / "build.ninja").read_text(encoding="utf-8")
    linked = {word for line in re.findall(r"^  LINK_LIBRARIES = (.*)$", text, re.M) for word in line.split()}
    found = [(f"library {Path(path).name}", path, "the linker") for path in sorted(linked) if path.startswith("/usr/")]
    configured = re.search(r"^build build\.ninja[^:\n]*: RERUN_CMAKE (.*)$", text, re.M)[1].split()
    for path in sorted(set(configured)):
        if not path.startswith("/usr/"):
            continue
        found.append((f"CMake's file {Path(path).name}", path, "the configuration"))
        if "Targets-" in path and Path(path).exists():
            wanted = re.findall(r"\$\{_IMPORT_PREFIX\}(/[^\s\";]+)", Path(path).read_text(encoding="utf-8"))
            found += [(f"library {Path(name).name}", f"/usr{name}", path) for name in sorted(set(wanted))]
    return found


def headers(build):
    """Headers that the compiler read, of everything built so far, by Ninja's record."""
    told = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True, timeout=60).stdout
    users = {}
    for block in told.split("\n\n"):
        target = block.split(":")[0]
        for path in re.findall(r"^    (/usr/\S+)$", block, re.M):
            users.setdefault(path, target)
    return [(f"header {path.removeprefix('/usr/include/')}", path, user) for path, user in sorted(users.items())]
