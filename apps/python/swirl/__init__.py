"""Modes of a rigid polygon or disk in a swirled circular container.

    >>> import swirl
    >>> scene = swirl.Scene(sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95)
    >>> found = swirl.classify(scene)
    >>> found.mode, found.period
    ('quasi-steady', 8)

Each command of `swirl` is a function of its name (`continue_` of `continue`), each of its flags a keyword, and each key of
its document an attribute of what it gives. The collision map itself takes arrays: `scene.map(z)`, `scene.derivative(z)`.
"""

from . import _commands
from ._commands import *  # noqa: F403 - the commands, by name
from ._swirl import version as __version__
from .result import Document, Result
from .scene import Scene

__all__ = ["Document", "Result", "Scene", "analysis", *_commands.__all__]


def __getattr__(name):
    if name == "analysis":  # NumPy is wanted there alone
        import swirl.analysis
        return swirl.analysis
    raise AttributeError(f"module 'swirl' has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *__all__})
