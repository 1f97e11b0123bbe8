"""Keywords become the flags of a command line, and what the command prints a result."""

import keyword
import os
import reprlib
import sys
import warnings

from . import _swirl, files, series
from .result import Result
from .scene import Scene, text_of, text_of_argument

#: Flags that are no keywords: a document is what functions give.
LEFT_OUT = ("--json", "--help")
#: Commands of the shell alone: figures, films and notebooks are made of records, pages of the commands.
NOT_FUNCTIONS = ("plot", "animate", "notebook", "manual", "completion")


def python_name(name):
    """`max-period` is max_period, and a word of Python's own has _ behind it: continue_, from_."""
    name = name.replace("-", "_")
    return name + "_" if keyword.iskeyword(name) else name


def keyword_of(option):
    """The keyword of an option; None where it has no flag, or is left out."""
    flag = option["flags"][-1] if option["flags"] else None
    return None if flag in LEFT_OUT or flag is None else python_name(flag.lstrip("-"))


class Command:
    """What is known of a command, by keyword."""

    def __init__(self, definition):
        self.name = definition["name"]
        self.options = {keyword_of(o): o for o in definition["options"] if keyword_of(o)}
        self.place = next((o for o in definition["options"] if o["place"]), None)
        self.has_json = any("--json" in o["flags"] for o in definition["options"])
        self.writes_record = self.options.get("output", {}).get("value") == "FILE.h5"
        self.has_scene = "sides" in self.options


_commands = {}


def command(name):
    if not _commands:
        _commands.update((d["name"], Command(d)) for d in _swirl.commands())
    return _commands[name]


def _range_text(values):
    """(0.1, 0.9, 400) is 0.1:0.9:400; a list or an array is 0.1,0.2,0.4."""
    values = values.tolist() if hasattr(values, "tolist") else values
    if isinstance(values, (str, bytes)) or not hasattr(values, "__iter__"):
        return text_of(values)
    return (":" if isinstance(values, tuple) else ",").join(text_of(value) for value in values)


def _is_several(value):
    return not isinstance(value, (str, bytes, os.PathLike, dict, Result)) and hasattr(value, "__iter__")


class Given:
    """A value that the command knows as a text: how a refusal names that, and how it is to name the value."""

    def __init__(self, shell, key, value):
        self.shell, self.python = shell, f"{key} = {reprlib.repr(value)}"

    def in_own_words(self, text):
        if self.shell not in text:
            return text
        text = text.replace(self.shell, self.python)
        for shell, python in (("NAME=A:B:COUNT:log", "{NAME: (A, B, COUNT, 'log')}"), ("NAME=A:B:COUNT", "{NAME: (A, B, COUNT)}"),
                              ("NAME=V,V,...", "{NAME: [V, V, ...]}"), ("NAME=A:B", "{NAME: (A, B)}")):
            text = text.replace(shell, python)
        return text


def _single(key, option, value, kept):
    """One value as text; files that must live until the command ends, and what its words mean, are added to `kept`."""
    if isinstance(value, Result):
        kept.append(value)
        return os.fspath(value)
    if isinstance(value, dict):
        if len(value) != 1:
            raise ValueError(f"{key} takes one name with its range, {{'alpha': (0.1, 0.9)}}")
        (name, values), = value.items()
        shape = getattr(values, "shape", None)
        if shape is not None and (len(shape) > 1 or shape == (0,)):
            raise ValueError(f"{key}[{name!r}] has the shape {shape}; (n,) is wanted")
        try:
            text = f"{name}={_range_text(values)}"
        except ValueError as error:
            raise ValueError(f"{key}[{name!r}]: {error}") from None
        kept.append(Given(f"{option['flags'][-1].lstrip('-')} {text}", key, value))
        return text
    if option["value"].startswith("FILE") and series.is_table(value):
        table = series.TemporaryTable(value, key)
        kept.append(table)
        return table.path
    if _is_several(value):
        values = value.tolist() if hasattr(value, "tolist") else list(value)
        if not values:
            raise ValueError(f"{key} is empty: a value is wanted, {option['help']}")
        text = ",".join(text_of_argument(key, one) for one in values)
        if option["flags"]:
            kept.append(Given(f"{option['flags'][-1]} = '{text}'", key, value))
        return text
    return text_of_argument(key, value)


def _words(key, option, value, kept):
    """The words of one option."""
    if value is None:
        return []
    flag = option["flags"][-1] if option["flags"] else None
    if option["values"] == 0:
        if value is not True and value is not False:
            raise ValueError(f"{flag} = {value!r}: True or False is wanted")
        return [flag] if value else []
    if value is True or value is False:
        raise ValueError(f"{flag} = {value}: a value is wanted, {option['help']}")
    if option["values"] > 1:
        values = list(value) if _is_several(value) else [value]
        return [flag, *(text_of_argument(key, one) for one in values)]
    if isinstance(value, dict) and option["several"]:
        value = [{name: values} for name, values in value.items()]
    several = option["several"] and _is_several(value) and not series.is_table(value)
    texts = [_single(key, option, one, kept) for one in (value if several else [value])]
    return [f"{flag}={text}" for text in texts] if flag else texts


def words_of(name, what, keywords):
    """The words of the command line, and what must live until it has run."""
    own, kept, words = command(name), [], []
    given = {key: value for key, value in keywords.items() if value is not None}
    for key in given:
        if key not in own.options:
            raise ValueError(f"swirl {name} has no flag --{key.rstrip('_').replace('_', '-')}")
    if isinstance(what, Scene):
        if not own.has_scene:
            raise ValueError(f"{name} takes no scene")
        words += [f"--{flag}={text}" for flag, text in what.flags.items() if python_name(flag) not in given]
    elif what is not None:
        if own.place is None:
            raise ValueError(f"{name} takes a Scene, or its keywords; {reprlib.repr(what)} is none")
        if own.place["value"].endswith(".h5") and series.is_table(what):
            raise ValueError(f"{name} takes a Scene, a path or a Result{'; numbers are given as series=' if 'series' in own.options else ''}")
        words += _words("what", own.place, what, kept)
    for key, value in given.items():
        words += _words(key, own.options[key], value, kept)
    return words, kept


class Progress:
    """tqdm's bar where it is installed and somebody looks; or what the user gave: a function of (task, total, done)."""

    def __init__(self, wanted):
        self.call = wanted if callable(wanted) else None
        self.shown = bool(self.call) or (_is_watched() if wanted is None else bool(wanted))
        self.bar = self.task = None

    def __call__(self, task, total, done):
        if self.call:
            self.call(task, total, done)
            return
        if self.task != (task, total):
            self.close()
            self.task = (task, total)
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")  # of a notebook without ipywidgets, which has the bar as text
                    from tqdm.auto import tqdm
            except ImportError:
                self.shown = False
                return
            self.bar = tqdm(total=total, desc=task, leave=False, delay=1)  # s: what is done before has none
        if self.bar is not None:
            self.bar.update(max(0, done - self.bar.n))

    def close(self):
        if self.bar is not None:
            self.bar.close()
        self.bar = None


def _is_watched():
    return "ipykernel" in sys.modules or (sys.stderr is not None and sys.stderr.isatty())


def _writes_record(own, keywords):
    """Proven cells and chaos are a record; what else is proven is a certificate, in JSON."""
    if own.name == "certify":
        return (keywords.get("plane") is not None or keywords.get("chaos")) and not os.fspath(keywords.get("output") or "").lower().endswith(".json")
    return own.writes_record and keywords.get("camera") is None and keywords.get("each") is None


def run(name, what, keywords, progress=None):
    """Runs the command; see `swirl.Result`."""
    own = command(name)
    words, kept = words_of(name, what, keywords)
    output = keywords.get("output")
    record = None
    writes_record = _writes_record(own, keywords)
    if writes_record and output is None:
        record = files.TemporaryFile(".h5")
        words.append(f"--output={record.path}")
    elif writes_record:
        record = files.GivenFile(os.fspath(output))
    if own.has_json and keywords.get("csv") is None:
        words.append("--json")
    shown = Progress(progress)
    try:
        code, text, messages, failure, raised = _swirl.run([name, *words], shown if shown.shown else None)
    finally:
        shown.close()
    for one in kept:
        if hasattr(one, "in_own_words"):
            failure = one.in_own_words(failure)
            messages = [one.in_own_words(message) for message in messages]
    del kept
    if failure and raised is None:
        raise _error(code, failure)
    result = Result(name, text, record if record and os.path.exists(record.path) else None, code, tuple(messages))
    if raised is not None:
        raised.result = result if text or result.record else None
        raise raised
    return result


def _error(code, line):
    if code == 2:
        return ValueError(line)
    return OSError(line) if code == 4 else RuntimeError(line)
