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
    array = numpy.asarray(value, dtype=float)
    if array.ndim not in (1, 2):
        raise ValueError(f"a series has the shape {array.shape}; (n,) or (n, columns) is wanted")
    return None, array.reshape(len(array), -1).T.tolist()


class TemporaryTable(files.TemporaryFile):
    """A table of text that goes with this object; numbers read back to the same bits."""

    def __init__(self, value):
        super().__init__(".csv")
        names, columns = columns_of(value)
        with open(self.path, "w", encoding="utf-8") as file:
            if names:
                file.write(",".join(map(_cell, names)) + "\n")
            for row in zip(*columns):
                file.write(",".join(map(_cell, row)) + "\n")
