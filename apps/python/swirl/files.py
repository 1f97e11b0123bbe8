"""Files that a call writes and its result keeps: gone with it."""

import itertools
import os
import weakref

_folders = {}  # of this process: one that was forked has its own
_numbers = itertools.count()
#: In memory where there is such a folder: what is written there waits for no disk.
_in_memory = "/dev/shm"


def _folder():
    own = _folders.get(os.getpid())
    if own is None:
        import tempfile  # most calls write none

        place = _in_memory if os.access(_in_memory, os.W_OK) else None
        own = _folders.setdefault(os.getpid(), tempfile.TemporaryDirectory(prefix="swirl-", dir=place))
    return own.name


def _remove(path, process):
    """With what a sweep that was interrupted has beside its record."""
    if os.getpid() != process:
        return
    folder, name = os.path.split(path)
    for left in (path, os.path.join(folder, f".{name}.journal")):
        try:
            os.unlink(left)
        except OSError:
            pass


class TemporaryFile:
    """A name of a file that does not exist yet, which goes with this object."""

    def __init__(self, suffix):
        self.path = os.path.join(_folder(), f"{next(_numbers)}{suffix}")
        weakref.finalize(self, _remove, self.path, os.getpid())


class GivenFile:
    """A file of the user's."""

    def __init__(self, path):
        self.path = path
