"""What the tests of swirl boundaries share: the planes that they search, and two of them searched."""

import json
import tempfile
from pathlib import Path

from driving import InFolder, run, without_progress


def document(arguments, code=(0,)):
    """As driving.document, where one of several exit codes is as good: a search that finds nothing on one side of a border."""
    result = run(f"{arguments} --json")
    assert result.returncode in code and (result.returncode or not without_progress(result.stderr)), (arguments, result.stderr)
    return json.loads(result.stdout)


HEXAGON = "--sides 6 --mu 0.5 --restitution 0.95"
PLANE = f"{HEXAGON} --plane alpha=0.4:0.6 --plane beta=0.25:0.5"
#: A line each way: seconds.
SMALL = f"{PLANE} --max-period 1 --lines 1"
#: With grazing, two-vertices and stick-slip curves.
BORDERS = f"{HEXAGON} --plane alpha=0.5:0.7 --plane beta=0.1:0.3"


def place(point):
    return point["parameters"]["alpha"], point["parameters"]["beta"]


class Searched(InFolder):
    """Two planes are searched once for all tests."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.record, cls.borders_record = Path(folder.name) / "small.h5", Path(folder.name) / "borders.h5"
        cls.answer = document(f"boundaries {SMALL} -o {cls.record}")
        cls.borders = document(f"boundaries {BORDERS} --max-period 2 --lines 1 -o {cls.borders_record}")
