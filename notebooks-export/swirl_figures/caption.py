"""What a figure shows, in words for a paper's caption: the title, what the figure leaves out for want of room, and the
records that it is drawn of."""

from .output import MARK
from .record import open_record

#: What titles write as formulas.
_PLAIN = ((r"\langle ", "⟨"), (r" \rangle", "⟩"), (r"\omega_s", "ω_s"), (r"\omega_p", "ω_p"), (r"\tau", "τ"), (r"\leq", "≤"),
          (r"\lambda", "λ"), ("$", ""))


def _in_words(note):
    for formula, word in _PLAIN:
        note = note.replace(formula, word)
    return note


def text_of(records, kinds, look):
    """Of a figure that has been drawn with this look, whose `notes` it filled; the kind of each record, of which notes tell
    the parts if they differ."""
    kinds = list(dict.fromkeys(kinds))
    lines = [f"Kind{'s' * (len(kinds) > 1)} of figure: {', '.join(kinds)}.", *map(_in_words, look.notes)]
    for record in map(open_record, records):
        lines.append(f"Record {record.path}, made by swirl {record.command}: {record.title}.")
    return "\n".join([*lines, f"This figure was {MARK}."]) + "\n"


def listed(heading, columns, rows):
    """A table in aligned columns: [names, one text a cell]."""
    widths = [max(len(str(cell)) for cell in column) for column in zip(columns, *rows)]
    line = lambda cells: "  " + "  ".join(f"{cell:>{width}}" for cell, width in zip(cells, widths)).rstrip()
    return "\n".join([heading, line(columns), *map(line, rows)])
