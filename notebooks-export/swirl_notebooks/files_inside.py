"""Files inside a notebook: a code cell that holds them, and unpacks them where it runs."""

import base64
import hashlib
import textwrap
import zlib

#: A record of more bytes than this travels beside the notebook.
MOST_INSIDE = 100_000

_UNPACK = '''\
import base64, tempfile, zlib
from pathlib import Path

# The {what}, so that this notebook is all that is needed: compressed, as letters.
{packed}
unpacked = tempfile.TemporaryDirectory()
folder = Path(unpacked.name)
for name, letters in FILES.items():
    (folder / name).write_bytes(zlib.decompress(base64.b85decode("".join(letters.split()))))
{last}'''

_BESIDE = '''\
import hashlib
from pathlib import Path

# From this notebook's folder, or in it, where both have moved into one.
places = [path for path in (Path({relative!r}), Path({name!r})) if path.exists()]
path = next((path for path in places if hashlib.sha256(path.read_bytes()).hexdigest() == {checksum!r}), None)
assert path, f"{{places[0] if places else {name!r}}} is {{'another file than' if places else 'not there:'}} the one this notebook was made of"
'''


def _letters(content):
    return textwrap.fill(base64.b85encode(zlib.compress(content, 9)).decode(), 150, break_on_hyphens=False)


def inside(files, last=""):
    """The source of a cell that holds {name: bytes} and unpacks them into `folder`.
      last  its last line"""
    packed = "FILES = {" + ", ".join(f'{name!r}: r"""\n{_letters(content)}\n"""' for name, content in files.items()) + "}"
    return _UNPACK.format(what="files themselves" if len(files) > 1 else "record itself", packed=packed, last=last).rstrip("\n")


def record_cell(path, content, relative):
    """(kind, source) of the cell that sets `path` to the record."""
    if len(content) <= MOST_INSIDE:
        return "data", inside({path.name: content}, f"path = folder / {path.name!r}")
    return "code", _BESIDE.format(relative=relative, name=path.name, checksum=hashlib.sha256(content).hexdigest())
