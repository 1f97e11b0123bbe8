"""Which small faults can be put into the sources of the map, and which of them a seed draws.

A mutant changes one line of one file by one of KINDS. Comments, texts, lines of the preprocessor, template brackets and
what only declares (`using`, `template`, `static_assert`) are left alone. Where a mutant stands in the draw depends on the
seed and on its own line, not on the other lines: an edit elsewhere does not draw the others anew.
"""

import collections
import hashlib
import itertools
import re
from dataclasses import dataclass
from pathlib import Path

STRATA = ("numbers", "model", "first_contact", "collision_map.hpp", "derivative", "contact", "orbit")

# Spaces as clang-format leaves them: around a binary operator, never inside template brackets nor after a sign.
_PAIRS = {
    "sign": [(" + ", " - "), (" - ", " + "), (" += ", " -= "), (" -= ", " += ")],
    "comparison": [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "),
                   (" != ", " == "), (" < ", " > "), (" > ", " < ")],
    "logic": [(" && ", " || "), (" || ", " && ")],
    "extreme": [("std::min(", "std::max("), ("std::max(", "std::min("), ("std::min({", "std::max({"),
                ("std::max({", "std::min({")],
    "function": [("sin(", "cos("), ("cos(", "sin(")],
}
_UNARY_MINUS = re.compile(r"(?:(?<=[(\[{])|(?<=[=?:,] )|(?<=return ))-(?=[\w(])")
_NEGATION = re.compile(r"(?<=[( ])!(?=[\w(])")
_NUMBER = re.compile(r"(?<![\w.])(?:0x[\da-f.]+p[+-]?\d+|\d[\d']*(?:\.\d*)?(?:e[+-]?\d+)?)(?![\w.])", re.I)
KINDS = (*_PAIRS, "unary minus", "negation", "constant")

_ONLY_DECLARES = re.compile(r"^\s*(#|using |template|static_assert|extern |namespace |SWIRL_|case .*:$)")


@dataclass(frozen=True)
class Mutant:
    """One changed line: `line` counts from 1, `before` and `after` are the whole line."""

    file: str
    line: int
    kind: str
    before: str
    after: str
    nth: int = 1  # of the equal lines of its file

    @property
    def key(self):
        """Names the mutant as long as its line stays as it is, wherever in the file it stands."""
        name = f"{self.file}: {self.before.strip()} -> {self.after.strip()}"
        return name if self.nth == 1 else f"{name} ({self.nth})"

    def place(self, seed):
        return hashlib.sha256(f"{seed} {self.key}".encode()).hexdigest()


def code_of(text):
    """The text with everything but code blanked out, character for character: comments and what stands in quotes."""
    out, state, i = [], "", 0
    while i < len(text):
        two, one = text[i:i + 2], text[i]
        if not state and two in ("//", "/*"):
            state = two
        elif not state and one in "\"'" and not (one == "'" and i and text[i - 1].isdigit()):  # 100'000 is a number
            state = one
        elif state == "//" and one == "\n":
            state = ""
        elif state == "/*" and two == "*/" or state in ("\"", "'") and (one == state or one == "\\"):
            width = 1 if one == state else 2
            out.append(" " * width)
            i += width
            state = "" if one != "\\" else state
            continue
        out.append(" " if state and one != "\n" else one)
        i += 1
    return "".join(out)


def other_number(text):
    """A literal that differs: whole numbers one more, decimals half, powers of ten or two the next one up."""
    power = re.fullmatch(r"(.*[ep])([+-]?\d+)", text, re.I) if re.search(r"[ep]", text, re.I) else None
    if power:
        return f"{power[1]}{int(power[2]) + 1}"
    if "." in text:
        value = float(text)
        return repr(value / 2 if value else 1.0)
    return str(int(text.replace("'", ""), 8 if re.fullmatch(r"0\d+", text) else 10) + 1)


def changes_of(code):
    """(kind, from column, to column, text instead) of one line of code."""
    for kind, pairs in _PAIRS.items():
        for old, new in pairs:
            for found in re.finditer(re.escape(old), code):
                start = found.start()
                if kind == "function" and start and (code[start - 1].isalnum() or code[start - 1] == "_"):
                    continue  # asin(
                yield kind, start, found.end(), new
    for found in _UNARY_MINUS.finditer(code):
        yield "unary minus", found.start(), found.end(), ""
    for found in _NEGATION.finditer(code):
        yield "negation", found.start(), found.end(), ""
    for found in _NUMBER.finditer(code):
        yield "constant", found.start(), found.end(), other_number(found.group())


def mutants_of_text(file, text):
    """All mutants of one file's text."""
    lines = text.split("\n")
    in_macro = False
    seen = collections.Counter()
    for number, (line, code) in enumerate(zip(lines, code_of(text).split("\n")), 1):
        skipped = in_macro or _ONLY_DECLARES.match(code)
        in_macro = code.endswith("\\")
        if skipped:
            continue
        for kind, start, end, new in changes_of(code):
            after = line[:start] + new + line[end:]
            seen[line.strip(), after.strip()] += 1
            yield Mutant(file, number, kind, line, after, seen[line.strip(), after.strip()])


def mutants_of(root, stratum):
    """All mutants of one folder (or file) of map/."""
    place = Path(root) / "map" / stratum
    files = [place] if place.is_file() else sorted(f for f in place.rglob("*") if f.suffix in (".hpp", ".cpp"))
    for file in files:
        yield from mutants_of_text(file.relative_to(root).as_posix(), file.read_text(encoding="utf-8"))


def _in_turn(sequences):
    """One of each sequence, then the next of each."""
    for row in itertools.zip_longest(*sequences):
        yield from (item for item in row if item is not None)


def drawn(root, seed):
    """All mutants in the order of the draw: the folders in turn, in each folder the kinds in turn."""
    strata = []
    for stratum in STRATA:
        mutants = sorted(mutants_of(root, stratum), key=lambda mutant: (mutant.place(seed), mutant.line))
        kinds = sorted(KINDS, key=lambda kind: hashlib.sha256(f"{seed} {stratum} {kind}".encode()).hexdigest())
        strata.append(list(_in_turn([[m for m in mutants if m.kind == kind] for kind in kinds])))
    return _in_turn(strata)
