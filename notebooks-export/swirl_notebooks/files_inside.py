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

path = Path({relative!r})  # from this notebook's folder
if not path.exists():
    path = Path({name!r})  # both have moved into one folder
found = hashlib.sha256(path.read_bytes()).hexdigest()
assert found == {checksum!r}, f"{{path}} is another file than the one this notebook was made of"
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
