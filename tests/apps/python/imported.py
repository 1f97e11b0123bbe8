"""What the tests of the Python module share: the arguments MODULES SWIRL ROOT, and the module, imported from MODULES."""

import subprocess
import sys
from pathlib import Path

MODULES, SWIRL, ROOT = (Path(sys.argv.pop(1)).resolve() for _ in range(3))
sys.path.insert(0, str(MODULES))

import swirl

HEXAGON = swirl.Scene(sides=6, alpha=0.4, beta=0.5, mu=0.5, restitution=0.95)
PERIOD_8 = swirl.Scene(sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95)
CHAOS = swirl.Scene(sides=6, alpha=0.3, beta=0.1, mu=0.1, restitution=1)
DISK = swirl.Scene(sides="disk", alpha=0.3, beta=0.1, mu=0.5, restitution=1)


def command(*words, **options):
    return subprocess.run([str(SWIRL), *map(str, words)], capture_output=True, text=True, timeout=300, **options)


def flags_of(scene):
    return [f"--{name}={text}" for name, text in scene.flags.items()]
