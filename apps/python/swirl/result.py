"""What a command gives: its document with attributes, and its record as arrays and figures."""

import json
import keyword
import os
import reprlib

_shown_rows = 10
_short = reprlib.Repr()
_short.maxlist = 4
_short.maxstring = 60


def wrapped(value):
    """Objects of a document with attributes, also those in lists."""
    if isinstance(value, dict):
        return Document(value)
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return [wrapped(one) for one in value]
    return value


class Document:
    """An object of a document: its members are attributes, and items by name. (`from_` is the member `from`.)"""

    __slots__ = ("_data", "__weakref__")

    def __init__(self, data):
        self._data = data

    def _name(self, name):
        if name in self._data:
            return name
        bare = name[:-1] if name.endswith("_") else name
        return bare if bare in self._data else name

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        own = self._name(name)
        if own not in self._data:
            raise AttributeError(f"{type(self).__name__} has no {name!r}; it has {', '.join(self._data)}")
        return wrapped(self._data[own])

    def __getitem__(self, name):
        return wrapped(self._data[name])

    def __contains__(self, name):
        return name in self._data

    def __iter__(self):
        return iter(self._data)

    def __len__(self):
        return len(self._data)

    def keys(self):
        return self._data.keys()

    def to_dict(self):
        """The document as Python has it: dictionaries, lists, numbers, words, None for what is not finite."""
        return self._data

    def __eq__(self, other):
        return self._data == other._data if isinstance(other, Document) else NotImplemented

    __hash__ = None

    def __dir__(self):
        names = (name + "_" if keyword.iskeyword(name) else name for name in self._data)
        return [*super().__dir__(), *(name for name in names if name.isidentifier())]

    def __repr__(self):
        return f"{type(self).__name__}({', '.join(f'{k}={_shown(v)}' for k, v in self._data.items())})"

    def __reduce__(self):
        return Document, (self._data,)


def _shown(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k}: {_short.repr(v)}" for k, v in list(value.items())[:4]) + (", …}" if len(value) > 4 else "}")
    if isinstance(value, list) and len(value) > 4:
        return f"[{len(value)} of them]"
    return _short.repr(value)


class Result(Document):
    """What a command gives.

    The keys of its document are attributes, nested ones too: `found.mode`, `found.scene.alpha`. They are those of
    docs/command-line.md.

    Attributes
    ----------
    command : str
        The command.
    exit_code : int
        0; 3 where an orbit or a search did not end as asked, which the document says by name.
    messages : tuple of str
        What the command says beside its document.
    record : str or None
        Path of its record (HDF5). Without `output=` it is a temporary file, which goes with the result.
    """

    __slots__ = ("command", "exit_code", "messages", "_file", "_text", "_read")

    def __init__(self, command, text, file, exit_code=0, messages=()):
        self.command, self.exit_code, self.messages, self._file = command, exit_code, messages, file
        self._text, self._read = text, None

    @property
    def _data(self):
        """Read when it is first asked for: ten megabytes of it take a fifth of a second."""
        if self._read is None:
            self._read = json.loads(bytes(self._text)) if self._text else {}
            self._text = None
        return self._read

    @property
    def record(self):
        return self._file.path if self._file is not None else None

    def __fspath__(self):
        if self._file is None:
            raise ValueError(f"this result of {self.command} has no record")
        return self._file.path

    def save(self, path, force=False):
        """A copy of the record.

        Parameters
        ----------
        path : str or os.PathLike
            Where to. A file that is there is replaced if it is an HDF5 file, as records are.
        force : bool
            Replace any file.

        Raises
        ------
        FileExistsError
            There is another file of that name.
        """
        import shutil
        path = os.fspath(path)
        if not force and os.path.exists(path):
            with open(path, "rb") as file:
                if file.read(8) != b"\x89HDF\r\n\x1a\n":
                    raise FileExistsError(f"'{path}' exists and is no record: give another name, or force=True")
        shutil.copyfile(os.fspath(self), path)

    @property
    def groups(self):
        """The groups of its record that hold arrays, the first one being that of `to_xarray()`."""
        import h5netcdf
        with h5netcdf.File(os.fspath(self), "r") as file:
            return tuple(_groups_with_arrays(file, ""))

    def to_xarray(self, group=None):
        """The arrays of its record with their names, units and meanings.

        Parameters
        ----------
        group : str, optional
            One of `groups`; by default the first.

        Returns
        -------
        xarray.Dataset
            In memory: it needs the record no more.
        """
        import xarray
        names = self.groups
        if not names:
            raise ValueError(f"this result of {self.command} holds no arrays; to_dict() has its numbers")
        if group is not None and group not in names:
            raise ValueError(f"group = {group!r} is none of: {', '.join(names)}")
        with xarray.open_dataset(os.fspath(self), group=group or names[0], engine="h5netcdf") as opened:
            return opened.load()

    def plot(self, kind=None, **look):
        """A figure of it, as `swirl plot` draws its record.

        Parameters
        ----------
        kind : str, optional
            docs/command-line.md, "plot"; by default the first that fits.
        **look
            `width` (inches), `font_size`, `xlim`, `ylim`, `log`, `of`, `over`, `x`, `y`, `titles`.

        Returns
        -------
        matplotlib.figure.Figure
            It belongs to no window: a notebook shows it, `figure.savefig(path)` writes it.
        """
        from . import figures
        return figures.draw(os.fspath(self), kind, look)

    def __reduce__(self):
        content = None
        if self._file is not None:
            with open(self._file.path, "rb") as file:
                content = file.read()
        return _result_from, (self.command, json.dumps(self._data).encode(), content, self.exit_code, self.messages)

    def __repr__(self):
        singles = [f"{k} {_short.repr(v)}" for k, v in self._data.items()
                   if v is not None and not isinstance(v, (dict, list)) and k != "swirl_version"]
        lists = [f"{len(v)} {k}" for k, v in self._data.items() if isinstance(v, list)]
        objects = [k for k, v in self._data.items() if isinstance(v, dict)]
        parts = [", ".join(part) for part in (singles, lists) if part]
        if objects:
            parts.append("with " + ", ".join(objects))
        return f"<swirl.{self.command}: {'; '.join(parts)}>"

    def _repr_html_(self):
        rows = "".join(f"<tr><th style='text-align:left'>{_escaped(k)}</th><td style='text-align:left'>{_cell(v)}</td></tr>"
                       for k, v in self._data.items() if not _is_table(v))
        tables = "".join(_table(k, v) for k, v in self._data.items() if _is_table(v))
        return f"<b>swirl {_escaped(self.command)}</b><table>{rows}</table>{tables}"


def _groups_with_arrays(group, path):
    found = []
    for name, child in group.groups.items():
        own = f"{path}/{name}"
        if child.variables:
            found.append(own[1:])
        found += _groups_with_arrays(child, own)
    return found


def _is_table(value):
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _escaped(text):
    import html  # its table of entities is for notebooks alone

    return html.escape(text)


def _cell(value):
    if isinstance(value, dict):
        return _escaped(", ".join(f"{k} {_short.repr(v)}" for k, v in value.items()))
    return _escaped(_short.repr(value))


def _table(name, rows):
    keys = list(rows[0])
    head = "".join(f"<th>{_escaped(k)}</th>" for k in keys)
    body = "".join("<tr>" + "".join(f"<td>{_cell(row.get(k))}</td>" for k in keys) + "</tr>" for row in rows[:_shown_rows])
    more = f"<p>and {len(rows) - _shown_rows} more</p>" if len(rows) > _shown_rows else ""
    return f"<details open><summary>{_escaped(name)}, {len(rows)}</summary><table><tr>{head}</tr>{body}</table>{more}</details>"


def _result_from(command, text, content, exit_code, messages):
    file = None
    if content is not None:
        from . import files
        file = files.TemporaryFile(".h5")
        with open(file.path, "wb") as target:
            target.write(content)
    return Result(command, text.encode() if isinstance(text, str) else text, file, exit_code, messages)  # a text in old pickles
