"""The commands that documents show: in blocks and within sentences."""

import re

#: Code that begins so and is none: the title by which a file says that it is a record.
_NO_COMMANDS = {"swirl record"}


def blocks_of(text, *languages):
    """The blocks of code, of these languages or of all."""
    return [block for language, block in re.findall(r"^```([a-z]*)\n(.*?)^```", text, re.M | re.S)
            if not languages or language in languages]


def in_blocks(text):
    """Each line `swirl …` of a block, one that ends in a backslash with the next, without its comment."""
    for block in blocks_of(text):
        for line in re.sub(r"\\\n\s*", "", block).splitlines():
            if line.startswith("swirl "):
                yield re.sub(r"\s+#.*", "", line)


def in_sentences(text):
    """Each `swirl …` between backquotes."""
    for code in re.findall(r"`([^`]+)`", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)):
        if re.match(r"swirl\s", code) and code not in _NO_COMMANDS:
            yield " ".join(code.split())


def shown(text):
    yield from in_blocks(text)
    yield from in_sentences(text)
