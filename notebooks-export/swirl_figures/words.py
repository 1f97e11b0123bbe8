"""The words of a figure: how long they are as they are drawn, and where they may be broken."""

import re

#: Stands for a space within a formula while a text is broken.
_KEPT = "\0"


def letters_in(text):
    """About so many letters are drawn: a command of a formula is one, or an accent."""
    text = re.sub(r"\\(bar|dot|hat|,)\s*", "", text)
    return len(re.sub(r"[${}^_]", "", re.sub(r"\\[a-zA-Z]+\s?", "x", text)))


def letters_across(width, size):
    """How many letters of that size, in points, fit into that width, in inches."""
    return max(20, int(72 * width / (0.56 * size)))


def broken(text, longest):
    """In lines of so many letters, where there are spaces for it; formulas stay whole."""
    lines = []
    for part in text.split("\n"):
        words = re.sub(r"\$[^$]*\$", lambda formula: formula.group().replace(" ", _KEPT), part).split(" ")
        line = ""
        for word in words:
            if line and letters_in(f"{line} {word}") > longest:
                lines.append(line)
                line = word
            else:
                line = f"{line} {word}" if line else word
        lines.append(line)
    return "\n".join(lines).replace(_KEPT, " ")


def ordinal(number):
    """2nd, 3rd, 11th."""
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number}{'th' if number % 100 in (11, 12, 13) else ending}"
