"""A figure to a file, which appears under its name only when it is whole."""

import io
import os
import stat
from pathlib import Path

from .style import DOTS_PER_INCH, styled_with

#: What a figure says of its origin: `swirl plot` replaces such a file without being told to.
MARK = "drawn by swirl plot"
#: Without the time of day: equal records give equal files.
SUFFIXES = {".png": {"Software": MARK}, ".svg": {"Date": None, "Creator": MARK},
            ".pdf": {"CreationDate": None, "Creator": MARK}}


#: Bytes of a vector file that programs open at once.
LARGEST = 5_000_000
#: Dots an inch where the images in it make it larger: half, then a quarter as many in an area.
FEWER_DOTS = (110, 80)


def _bytes_at(figure, suffix, dots_per_inch):
    """With the letters that it was drawn with: an axis counts again how many numbers it has room for."""
    content = io.BytesIO()
    with styled_with(getattr(figure, "swirl_letters", 9)):
        figure.savefig(content, format=suffix[1:], metadata=SUFFIXES[suffix], dpi=dots_per_inch)
    return content.getvalue()


def _bytes_of(figure, suffix):
    usual = _bytes_at(figure, suffix, DOTS_PER_INCH)
    if suffix == ".png" or len(usual) < LARGEST:
        return usual
    for dots_per_inch in FEWER_DOTS:
        content = _bytes_at(figure, suffix, dots_per_inch)
        if len(content) < LARGEST:
            return content
    return usual  # what makes it large is no image


def _take_permissions(partial, path):
    """The group and permissions of what is replaced, as far as the system lets one give them."""
    if not path.exists():
        return
    old = path.stat()
    mode = stat.S_IMODE(old.st_mode)
    try:
        os.chown(partial, -1, old.st_gid)
    except OSError:
        mode &= ~stat.S_IRWXG  # who was not let in by the old group is not let in by another one
    os.chmod(partial, mode)


def partial_of(path):
    """The name under which a file is written until it is whole; of a link that of its own file, which is replaced."""
    path = Path(os.path.realpath(path))
    return path.with_name(f".{path.name}.partial")


def put_in_place(partial, path):
    path = Path(os.path.realpath(path))
    _take_permissions(partial, path)
    partial.replace(path)


def write_whole(content, path):
    """Bytes to a file, by way of `.NAME.partial` beside it."""
    partial = partial_of(path)
    try:
        partial.write_bytes(content)
        put_in_place(partial, path)
    except OSError:
        partial.unlink(missing_ok=True)
        raise


def save(figure, path):
    """Writes .png, .svg or .pdf."""
    suffix = Path(path).suffix
    if suffix not in SUFFIXES:
        raise ValueError(f"figure '{path}': its suffix is none of {', '.join(SUFFIXES)}")
    write_whole(_bytes_of(figure, suffix), path)
