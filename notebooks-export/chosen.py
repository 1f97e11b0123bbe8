"""What an argument of a figure says: a width, a size, a range. Without matplotlib, which takes a second to load, so that a
wrong one is told at once."""

import math

MILLIMETRES = 25.4

#: Widths of a column in journals' instructions for authors, in millimetres.
COLUMNS = {"aps": 86.0, "aps-2": 178.0, "nature": 89.0, "nature-2": 183.0, "elsevier": 90.0, "elsevier-2": 190.0}

LEAST_WIDTH, MOST_WIDTH = 40.0, 500.0        # millimetres
LEAST_FONT_SIZE, MOST_FONT_SIZE = 4.0, 40.0  # points
MOST_LIMIT = 1e15        # of an abscissa; squares of what is beyond it overflow on the way to the page
LEAST_PART_SHOWN = 1e-9  # of the larger limit: labels of marks that lie nearer together are the same


def length_of(text):
    """Inches of `89`, `89mm`, `3.4in` or a journal's column by its name. ValueError in one line."""
    if text in COLUMNS:
        return COLUMNS[text] / MILLIMETRES
    scale, digits = (MILLIMETRES, text[:-2]) if text.endswith("in") else (1, text.removesuffix("mm"))
    width = _number(digits) * scale
    if not LEAST_WIDTH <= width <= MOST_WIDTH:
        raise ValueError(f"width = {text}: allowed are {LEAST_WIDTH:g} to {MOST_WIDTH:g} mm, as 86, 86mm or 3.4in, "
                         f"and the columns {', '.join(COLUMNS)}")
    return width / MILLIMETRES


def font_size_of(text):
    size = _number(text)
    if not LEAST_FONT_SIZE <= size <= MOST_FONT_SIZE:
        raise ValueError(f"font-size = {text}: allowed are {LEAST_FONT_SIZE:g} to {MOST_FONT_SIZE:g} points")
    return size


def range_of(text, name="xlim"):
    """(A, B) of `A:B`, A < B."""
    ends = [_number(part) for part in text.split(":")]
    if len(ends) != 2 or not -MOST_LIMIT <= ends[0] < ends[1] <= MOST_LIMIT:
        raise ValueError(f"{name} = {text}: allowed is A:B, two numbers from {-MOST_LIMIT:g} to {MOST_LIMIT:g} with A < B")
    least = LEAST_PART_SHOWN * max(map(abs, ends))
    if ends[1] - ends[0] < least:
        raise ValueError(f"{name} = {text}: B - A is {ends[1] - ends[0]:.2g}, allowed is {least:.2g} or more")
    return tuple(ends)


def _number(text):
    try:
        return float(text)
    except ValueError:
        return math.nan
