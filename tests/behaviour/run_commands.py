"""Runs the fixed set of commands with one binary and keeps what they answered.

Of the command NAME the folder NAME holds
  command     its line
  exit        the exit code of the line
  stdout      as it came
  stderr      but for the seconds that it took
  files       the files that it left, one a line: name, size in bytes, SHA-256 of the bytes
  RECORD.text the content of each record that it left (record_text.py)
  FIGURE.svg  each figure that is text
"""

import hashlib
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from record_text import record_text

HERE = Path(__file__).resolve().parent
LIMIT = 300  # seconds for one line; the slowest takes a few
ENTRY = re.compile(r"([a-z0-9-]+): (\S.*)")
SECONDS = re.compile(rb"^swirl: \d+\.\d+ s$", re.M)  # how long a sweep or a diagram took


class BadSet(Exception):
    """What is wrong with a set of commands."""


def read_commands(path):
    """{name: line} of a set of commands, in its order."""
    commands = {}
    for number, text in enumerate(Path(path).read_text(encoding="utf-8").splitlines(), 1):
        if not text.strip() or text.startswith("#"):
            continue
        entry = ENTRY.fullmatch(text)
        if not entry:
            raise BadSet(f"{path}, line {number}: NAME: LINE is wanted, not '{text}'")
        name, line = entry.groups()
        if name in commands:
            raise BadSet(f"{path}, line {number}: the name {name} is given twice")
        commands[name] = line
    return commands


def environment(programs):
    """The caller's, with `swirl` from the folder `programs` and nothing that changes what it says."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("SWIRL_", "LC_", "LANG"))}
    return {**kept, "PATH": f"{programs}{os.pathsep}{kept.get('PATH', os.defpath)}", "LC_ALL": "C.UTF-8"}


def _sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def keep_files(scratch, inputs, kept):
    """Into `kept`: what a command left in `scratch`, where a copy of `inputs` had been; a changed input, too."""
    listed = []
    for path in sorted(p for p in scratch.rglob("*") if p.is_file()):
        name = path.relative_to(scratch).as_posix()
        digest = _sha256(path)
        if (inputs / name).is_file() and digest == _sha256(inputs / name):
            continue
        listed.append(f"{name} {path.stat().st_size} {digest}\n")
        stored = kept / name.replace("/", "_")
        if path.suffix == ".h5":
            stored.with_name(stored.name + ".text").write_text(record_text(path), encoding="utf-8")
        elif path.suffix == ".svg":
            shutil.copyfile(path, stored)
    (kept / "files").write_text("".join(listed), encoding="utf-8")


def _answer(line, scratch, variables):
    """(exit code, standard output, standard error) of a line run in `scratch`."""
    with subprocess.Popen(["/bin/sh", "-c", line], cwd=scratch, env=variables, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True) as shell:
        try:
            output, errors = shell.communicate(timeout=LIMIT)
        except subprocess.TimeoutExpired as error:
            os.killpg(shell.pid, signal.SIGKILL)  # the shell and what it runs: they are a session of their own
            raise BadSet(f"'{line}' has not ended after {LIMIT} s") from error
        return shell.returncode, output, errors


def run_one(line, inputs, kept, variables):
    """Runs one line in a scratch folder and keeps its answers in the folder `kept`, which it makes."""
    kept.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder) / "scratch"
        shutil.copytree(inputs, scratch)
        code, output, errors = _answer(line, scratch, variables)
        keep_files(scratch, inputs, kept)
    (kept / "command").write_text(line + "\n", encoding="utf-8")
    (kept / "exit").write_text(f"{code}\n", encoding="utf-8")
    (kept / "stdout").write_bytes(output)
    (kept / "stderr").write_bytes(SECONDS.sub(b"swirl: # s", errors))


def run_commands(swirl, folder, commands, inputs=HERE / "inputs", report=print):
    """Runs all `commands` with the binary `swirl`; returns {name: seconds}."""
    swirl, folder, seconds = Path(swirl).resolve(), Path(folder), {}
    if not os.access(swirl, os.X_OK) or swirl.is_dir():
        raise BadSet(f"swirl '{swirl}' is no program")
    if folder.exists() and any(folder.iterdir()):
        raise BadSet(f"folder '{folder}' is not empty: answers of two runs must not mix")
    with tempfile.TemporaryDirectory() as programs:
        (Path(programs) / "swirl").symlink_to(swirl)
        variables = environment(programs)
        for name, line in commands.items():
            begin = time.monotonic()
            run_one(line, inputs, folder / name, variables)
            seconds[name] = time.monotonic() - begin
            report(f"{seconds[name]:6.2f} s  {name}")
    return seconds
