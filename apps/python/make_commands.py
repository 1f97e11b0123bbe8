"""make_commands.py FOLDER: writes swirl/_commands.py and swirl/__init__.pyi into FOLDER, whose swirl/ has the module: the
functions of the commands, their keywords and what help() says, of what the commands say of themselves."""

import sys
import textwrap
from pathlib import Path

HEAD = '''"""The commands as functions. Made by make_commands.py of what the commands say of themselves."""

from __future__ import annotations

from .call import run as _run

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Flag, Number, Progress, Table, Value, Values, What, Whole
    from .result import Result

__all__ = {names!r}
'''

STUB = '''from typing import Any

from . import analysis as analysis
from ._commands import ({names},
)
from .result import Document as Document, Result as Result
from .scene import Scene as Scene

__version__: str
__all__: list[str]
'''

RETURNS = '''Returns
-------
Result
    The command's document: its keys are attributes. See `swirl.Result`.

Raises
------
ValueError
    For wrong input, with the line that the command says.
OSError
    Where a file cannot be read or written once work has begun.
KeyboardInterrupt
    After Ctrl-C, within half a second; its `result` holds what was finished, if the command keeps that.
'''

WHAT_OF_SCENE = "A `swirl.Scene`; or give its parameters as keywords, or a TOML file as `scene`."
PROGRESS = "None: tqdm's bar where it is installed and somebody looks. False: none. A function is told (task, total, done)."


def type_of(option):
    if option["values"] == 0:
        return "Flag"
    if option["value"].startswith("FILE"):
        return "Table"
    if option["several"] or option["values"] > 1:
        return "Values"
    return "Whole" if option["range"].startswith("whole number") else "Value"


def words_of(option):
    """What stands behind the keyword's name in help()."""
    if option["values"] == 0:
        return "bool"
    parts = ["{" + ", ".join(map(repr, option["words"])) + "}" if option["words"] else "",
             option["value"], option["range"],
             f"{option['values']} values" if option["values"] > 1 else "",
             "or several" if option["several"] else ""]
    return ", ".join(part for part in parts if part) or "number or word"


def parameter(name, words, help_text):
    return f"{name} : {words}\n" + textwrap.indent(textwrap.fill(help_text, 92), "    ")


def docstring(definition, command):
    what = [WHAT_OF_SCENE] if command.has_scene else []
    if command.place:
        place = command.place["help"] or command.place["place"]
        what.append(f"{'Or' if what else 'A'} file, by its path, or the `Result` that has it: {place}.")
    parts = [definition["does"][0].upper() + definition["does"][1:] + ".", "Parameters\n----------"]
    if what:
        parts[-1] += "\n" + parameter("what", "Scene, path or Result, optional", " ".join(what))
    for name, option in command.options.items():
        parts[-1] += "\n" + parameter(name, words_of(option) + ("" if option["required"] else ", optional"), option["help"])
    parts[-1] += "\n" + parameter("progress", "callable or bool, optional", PROGRESS)
    parts += [RETURNS.rstrip(), "Notes\n-----\n" + "Of the command:\n\n" + definition["details"].strip()]
    return "\n\n".join(parts)


def function(definition, command, python_name):
    doc = textwrap.indent(docstring(definition, command).replace("\\", "\\\\").replace('"""', '\\"\\"\\"'), "    ").lstrip()
    head = f"def {python_name}("
    arguments = ["what: What = None", "/", "*"]
    arguments += [f"{name}: {type_of(option)} = None" for name, option in command.options.items()]
    arguments.append("progress: Progress = None")
    lines = textwrap.fill(", ".join(arguments), 116, initial_indent=head, subsequent_indent=" " * len(head),
                          break_long_words=False, break_on_hyphens=False)
    taken = ", ".join(f"{name}={name}" for name in command.options)
    call = textwrap.fill(f"dict({taken})", 110, initial_indent=" " * 16, subsequent_indent=" " * 21)
    return f'{lines}) -> Result:\n    """{doc}\n    """\n    return _run("{command.name}", what,\n{call}, progress)\n'


def main():
    folder = Path(sys.argv[1])
    package = folder / "swirl"
    # The package imports what is made here.
    (package / "_commands.py").write_text("__all__ = []\n", encoding="utf-8")
    sys.path.insert(0, str(folder))
    sys.dont_write_bytecode = True
    from swirl import _swirl, call
    functions = {}
    for definition in _swirl.commands():
        if definition["name"] not in call.NOT_FUNCTIONS:
            name = call.python_name(definition["name"])
            functions[name] = function(definition, call.Command(definition), name)
    text = HEAD.format(names=list(functions)) + "".join("\n\n" + one for one in functions.values())
    compile(text, "_commands.py", "exec")
    (package / "_commands.py").write_text(text, encoding="utf-8")
    names = ", ".join(f"{name} as {name}" for name in functions)
    names = textwrap.fill(names, 100, initial_indent=" " * 4, subsequent_indent=" " * 4).lstrip()
    (package / "__init__.pyi").write_text(STUB.replace("{names}", names).replace("from typing import Any\n\n", ""),
                                          encoding="utf-8")


if __name__ == "__main__":
    main()
