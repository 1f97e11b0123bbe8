"""A figure to a file, which appears under its name only when it is whole."""

import io
import os
from pathlib import Path

from .style import styled

#: Without the time of day: equal records give equal files.
SUFFIXES = {".png": {"Software": None}, ".svg": {"Date": None}, ".pdf": {"CreationDate": None}}


@styled
def _bytes_of(figure, suffix):
    content = io.BytesIO()
    figure.savefig(content, format=suffix[1:], metadata=SUFFIXES[suffix])
    return content.getvalue()


def save(figure, path):
    """Writes .png, .svg or .pdf by way of `.NAME.partial` beside it."""
    path = Path(os.path.realpath(path))  # a link's own file is replaced, not the link
    if path.suffix not in SUFFIXES:
        raise ValueError(f"figure '{path}': its suffix is none of {', '.join(SUFFIXES)}")
    content = _bytes_of(figure, path.suffix)
    partial = path.with_name(f".{path.name}.partial")
    try:
        partial.write_bytes(content)
        partial.replace(path)
    except OSError:
        partial.unlink(missing_ok=True)
        raise
