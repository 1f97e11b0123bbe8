"""The worked notebooks: cells in worked/NAME.py, with the commands that make the records which they read.

Beside code and markdown a cell may be
    [commands]   lines `swirl …`, run in an empty folder, and shown
    [made]       Python that makes a file of those there, run in that folder, and shown
    [files]      names of files of that folder, which go into the notebook here"""

import os
import shlex
import subprocess
from pathlib import Path

from .cells import cells_of, executed, notebook_of
from .files_inside import inside

FOLDER = Path(__file__).parent / "worked"

NAMES = tuple(sorted(file.stem for file in FOLDER.glob("*.py")))


def _commands(lines):
    """The lines, those that end in a backslash joined with the next."""
    return [line for line in lines.replace("\\\n", " ").splitlines() if line.strip()]


def _run_commands(swirl, lines, folder):
    for line in _commands(lines):
        words = shlex.split(line)
        if words[0] != "swirl":
            raise ValueError(f"'{line}' is no command of swirl")
        result = subprocess.run([swirl, *words[1:]], cwd=folder, capture_output=True, text=True)
        if result.returncode != 0:
            raise RuntimeError(f"{line}: exit {result.returncode}: {result.stderr.strip()}")


def worked_notebook(name, swirl, folder):
    """The executed notebook; its records are made by `swirl` in `folder`, which is empty."""
    cells = []
    for kind, source in cells_of((FOLDER / f"{name}.py").read_text(encoding="utf-8")):
        if kind == "commands":
            _run_commands(swirl, source, folder)
            cells.append(("markdown", f"```sh\n{source}\n```"))
        elif kind == "made":
            subprocess.run([os.environ.get("SWIRL_PYTHON", "/usr/bin/python3"), "-B", "-c", source], cwd=folder, check=True)
            cells.append(("markdown", f"```python\n{source}\n```"))
        elif kind == "files":
            cells.append(("data", inside({file: (Path(folder) / file).read_bytes() for file in source.split()})))
        else:
            cells.append((kind, source))
    title = next(source.splitlines()[0].lstrip("# ") for kind, source in cells if kind == "markdown")
    return executed(notebook_of(cells, title), folder)
