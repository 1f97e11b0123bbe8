"""Measured series from NumPy, pandas and xarray: a table that the command reads."""

import math

from . import files


def is_table(value):
    """Numbers in memory, rather than a file's name."""
    return hasattr(value, "__array__") or _is_rows(value)


def _is_rows(value):
    return isinstance(value, (list, tuple)) and bool(value) and all(isinstance(one, (int, float, list, tuple)) for one in value)


def _cell(value):
    if isinstance(value, float):
        return "" if math.isnan(value) else float.__repr__(value)  # an empty cell is a gap
    if value is None:
        return ""
    text = str(value)
    return '"' + text.replace('"', '""') + '"' if any(c in text for c in ',"\n\r') else text


def _frame(frame):
    """Columns of a pandas.DataFrame by name, after its index where that is more than the rows' numbers."""
    if type(frame.index).__name__ != "RangeIndex":
        frame = frame.rename_axis(frame.index.name or "time").reset_index()
    return [str(name) for name in frame.columns], [frame[name].tolist() for name in frame.columns]


def columns_of(value):
    """(names or None, columns): a name for each column, none of an array."""
    if hasattr(value, "to_dataframe"):  # xarray
        if hasattr(value, "to_dataset") and value.name is None:
            value = value.rename("value")
        frame = value.to_dataframe()
        return _frame(frame)
    if hasattr(value, "to_frame"):  # pandas.Series
        return _frame(value.to_frame(name="value" if value.name is None else value.name))
    if hasattr(value, "columns"):  # pandas.DataFrame
        return _frame(value)
    import numpy
    try:
        array = numpy.asarray(value)
    except ValueError:
        raise ValueError("its rows have several lengths") from None
    if array.dtype.kind not in "biufO":
        raise ValueError(f"it holds {array.dtype}, numbers are wanted")
    try:
        array = array.astype(float)
    except (TypeError, ValueError):
        raise ValueError("it holds what is no number") from None
    if array.ndim not in (1, 2) or array.size == 0:
        raise ValueError(f"it has the shape {array.shape}; (n,) or (n, columns) is wanted")
    return None, array.reshape(len(array), -1).T.tolist()


class TemporaryTable(files.TemporaryFile):
    """A table of text that goes with this object; numbers read back to the same bits. `name` is the argument's."""

    def __init__(self, value, name):
        super().__init__(".csv")
        self.name = name
        try:
            names, columns = columns_of(value)
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from None
        self.has_names = bool(names)
        with open(self.path, "w", encoding="utf-8") as file:
            if names:
                file.write(",".join(map(_cell, names)) + "\n")
            for row in zip(*columns):
                file.write(",".join(map(_cell, row)) + "\n")

    def in_own_words(self, text):
        """What the command says of a file, of the argument."""
        text = text.replace(f"{self.name} '{self.path}'", self.name).replace(f"'{self.path}'", f"the array `{self.name}`")
        return text if self.has_names else text.replace("the file has no header", "an array has no names of columns")
