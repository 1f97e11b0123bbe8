"""What a list of Debian packages brings: the packages by apt's own choice for a system with nothing installed, and which of
the files of this system are theirs."""

import os
import re
import subprocess
from pathlib import Path

#: A system with nothing in it; recommended packages are not asked for, as quickstart does not.
NOTHING_INSTALLED = ("-o", "Dir::State::status=/dev/null")


def told(*command):
    result = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}, timeout=120)
    if result.returncode != 0:
        raise RuntimeError(f"{' '.join(command[:6])} …: {result.stderr.strip()}")
    return result.stdout


def listed(path):
    """[(name, whether it is optional)] of a list like packages.txt."""
    found = []
    for line in path.read_text(encoding="utf-8").splitlines():
        name, _, comment = line.partition("#")
        if name.strip():
            found.append((name.strip(), "optional" in comment))
    return found


def with_candidate(names):
    """Those of the names that apt can install."""
    answer = told("apt-cache", *NOTHING_INSTALLED, "policy", *names)
    candidates = dict(re.findall(r"^(\S+):\n  Installed: .*\n  Candidate: (.*)$", answer, re.M))
    return [name for name in names if candidates.get(name, "(none)") != "(none)"]


def of_every_system():
    """Essential packages, and apt: a bare root has these."""
    shown = told("dpkg-query", "--show", "--showformat=${Package} ${Essential}\n")
    return [line.split()[0] for line in shown.splitlines() if line.endswith(" yes")] + ["apt"]


def closure(names):
    """The packages that are there once apt has installed these in a system with nothing but what every one has."""
    uris = told("apt-get", "-qq", "--print-uris", *NOTHING_INSTALLED, "-o", "Dir::Cache::archives=/nonexistent/", "-o",
                "Debug::NoLocking=1", "--no-install-recommends", "install", *of_every_system(), *names)
    return {line.split()[1].split("_")[0] for line in uris.splitlines() if line.startswith("'")}


def _resolved(path):
    return re.sub(r"^/(bin|sbin|lib\w*)/", r"/usr/\1/", path)


def owners():
    """{file: package} of all that dpkg has installed here, with /usr merged."""
    found = {}
    for file in Path("/var/lib/dpkg/info").glob("*.list"):
        package = file.stem.split(":")[0]
        for path in file.read_text(encoding="utf-8", errors="surrogateescape").splitlines():
            found[_resolved(path)] = package
    return found


def owner(path, owned):
    """The package of a file, found by its name, else behind links (alternatives); None where it is no package's."""
    return owned.get(_resolved(str(path))) or owned.get(_resolved(os.path.realpath(path)))
