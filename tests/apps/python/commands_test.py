"""The functions of the module are the commands: the same flags, the same answers, the same refusals."""

import contextlib
import inspect
import json
import os
import re
import shlex
import shutil
import sys
import tempfile
import unittest

import numpy as np

from imported import CHAOS, HEXAGON, MODULES, PERIOD_8, ROOT, command, flags_of, swirl

ALL = "--all" in sys.argv and bool(sys.argv.remove("--all") or True)
#: Of the shell alone, as apps/python/swirl/call.py has it; each has no document of an analysis.
OF_THE_SHELL = {"plot", "animate", "notebook", "manual", "completion"}
#: Lines of tests/behaviour/commands.txt that take a second or more, which the nightly test runs, too.
LONG = {"classify-runs-risk", "classify-transient", "bifurcate-risk", "sweep-risk", "sweep-track", "sweep-saddles", "sweep-shards",
        "boundaries-json", "boundaries-record", "tour-json", "fit-json", "fit-film-json", "continue-special-points",
        "bifurcate-branches", "orbits-json", "orbits-stronge", "orbits-family", "orbits-pin", "certify-all", "describe-no-swirl"}


def names_of_help(text, heading):
    return re.findall(r"^  ([a-z]+) ", text.split(heading)[1], re.M)


def flags_of_help(text):
    """The flags that --help lists: at the beginning of a line, or after a positional's name."""
    rows = re.findall(r"^  (?:-\w,|[A-Za-z]+ )?(--[a-z-]+)", text.split("\nOptions:")[1], re.M)
    return set(rows) - {"--help", "--json"}


class Names(unittest.TestCase):
    def test_every_command_is_a_function_and_every_function_a_command(self):
        commands = set(names_of_help(command("--help").stdout, "Subcommands:"))
        self.assertGreater(len(commands), 20)
        functions = {name.rstrip("_") for name in dir(swirl) if inspect.isfunction(getattr(swirl, name)) and not name.startswith("_")}
        self.assertEqual(functions, commands - OF_THE_SHELL)

    def test_every_flag_is_a_keyword_and_every_keyword_a_flag(self):
        for name in names_of_help(command("--help").stdout, "Subcommands:"):
            if name in OF_THE_SHELL:
                continue
            function = getattr(swirl, name, None) or getattr(swirl, name + "_")
            keywords = {"--" + key.rstrip("_").replace("_", "-") for key, parameter in
                        inspect.signature(function).parameters.items() if parameter.kind is parameter.KEYWORD_ONLY}
            flags = flags_of_help(command(name, "--help").stdout)
            self.assertGreater(len(flags), 1, name)
            self.assertEqual(keywords - {"--progress"}, flags, name)

    def test_help_says_what_the_command_says(self):
        text = inspect.getdoc(swirl.continue_)
        self.assertIn("longest_step : H", text)
        self.assertIn("1e-6 to 1 (default 0.02)", " ".join(text.split()))
        told = " ".join(inspect.getdoc(swirl.classify).split())
        for example in command("classify", "--help").stdout.split("Examples:")[1].replace("\\\n", "").strip().split("\n"):
            self.assertIn(" ".join(example.split()), told)
        self.assertIn("Parameters\n----------", text)


def plain_lines():
    """(name, command, words) of the set of tests/behaviour that give one document each."""
    for line in (ROOT / "tests/behaviour/commands.txt").read_text().splitlines():
        name, _, rest = line.partition(": ")
        if line.startswith("#") or not rest.startswith("swirl ") or " --json" not in rest or re.search(r"&&|[|<>]", rest):
            continue
        words = shlex.split(rest)[1:]
        if words[0] not in OF_THE_SHELL and words[0] != "tradeoff" and not name.startswith("bad-"):
            yield name, words[0], words[1:]


def python_value(text):
    """A number where Python writes it as the text has it."""
    for kind in (int, float):
        with contextlib.suppress(ValueError):
            if repr(kind(text)) == text:
                return kind(text)
    return text


def python_call(words):
    """(what, keywords) of a command line."""
    what, keywords, i = None, {}, 0
    while i < len(words):
        word = {"-o": "--output"}.get(words[i], words[i])
        i += 1
        if not word.startswith("--"):
            what = word
            continue
        name, equals, value = word.partition("=")
        name = name[2:].replace("-", "_")
        name = name + "_" if name in ("from", "in") else name
        values = [value] if equals else []
        while not equals and i < len(words) and re.match(r"[^-]|-[\d.]", words[i]):
            values.append(words[i])
            i += 1
        if name == "json":
            continue
        values = [python_value(one) for one in values]
        value = True if not values else values[0] if len(values) == 1 else values
        keywords[name] = [*keywords[name], value] if isinstance(keywords.get(name), list) else (
            [keywords[name], value] if name in keywords else value)
    return what, keywords


@contextlib.contextmanager
def in_inputs():
    """A folder with the inputs of tests/behaviour."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(ROOT / "tests/behaviour/inputs", folder, dirs_exist_ok=True)
        os.chdir(folder)
        try:
            yield folder
        finally:
            os.chdir(before)


def untimed(document):
    return {key: value for key, value in document.items() if key not in ("seconds",)}


class Answers(unittest.TestCase):
    def answers(self, name, words):
        """The command's document, and the function's, as text: -0.0 is not 0.0 there."""
        with in_inputs():
            result = command(name, *words)
            self.assertTrue(result.stdout, (name, words, result.stderr))
            by_command = json.loads(result.stdout)
        what, keywords = python_call(words)
        with in_inputs():
            found = (getattr(swirl, name, None) or getattr(swirl, name + "_"))(what, **keywords)
        return json.dumps(untimed(by_command)), json.dumps(untimed(found.to_dict())), result.returncode, found.exit_code

    def test_sixty_commands_answer_alike_to_the_bit(self):
        count = 0
        for title, name, words in plain_lines():
            if title in LONG and not ALL:
                continue
            count += 1
            with self.subTest(title):
                by_command, by_function, code, exit_code = self.answers(name, words)
                self.assertEqual(by_function, by_command)
                self.assertEqual(exit_code, code)
        self.assertGreaterEqual(count, 60)

    def test_values_of_python_say_the_same_as_words(self):
        z = (-0.0839, 0.028, -0.5542, 0.8898, -0.9793)
        ranges = {"alpha": (0.38, 0.4, 3)}
        pairs = [
            (swirl.simulate(HEXAGON, point=z, collisions=5),
             ["simulate", *flags_of(HEXAGON), "--point=-0.0839,0.028,-0.5542,0.8898,-0.9793", "--collisions=5"]),
            (swirl.sweep(sides=6, mu=0.5, restitution=0.95, grid={**ranges, "beta": [0.4, 0.5]}, collisions=100, transient=100),
             ["sweep", "--sides=6", "--mu=0.5", "--restitution=0.95", "--grid=alpha=0.38:0.4:3", "--grid=beta=0.4,0.5",
              "--collisions=100", "--transient=100"]),
            (swirl.continue_(HEXAGON, from_=z, along={"beta": (0.48, 0.52)}, switch=0),
             ["continue", *flags_of(HEXAGON), "--from=-0.0839,0.028,-0.5542,0.8898,-0.9793", "--along=beta=0.48:0.52", "--switch=0"]),
            (swirl.classify(HEXAGON, alpha=0.635), ["classify", *flags_of(PERIOD_8)]),
        ]
        for found, words in pairs:
            told = json.loads(command(*words, "--json").stdout)
            self.assertEqual(json.dumps(untimed(found.to_dict())), json.dumps(untimed(told)), words[0])

    def test_results_lead_to_the_next_command(self):
        cycles = swirl.orbits(HEXAGON, period=1, starts=20, trajectories=1, collisions=200)
        branches = swirl.continue_(cycles, orbit=1, along={"alpha": (0.39, 0.41)})
        self.assertGreater(len(branches.branches[0].points), 3)
        orbit = swirl.simulate(CHAOS, collisions=300)
        self.assertEqual(swirl.recurrence(orbit, threshold=0.2).to_dict()["RR"],
                         swirl.recurrence(CHAOS, transient=0, collisions=300, threshold=0.2).to_dict()["RR"])


class Refusals(unittest.TestCase):
    CASES = [
        ("classify", {"sides": 1, "alpha": 0.4, "beta": 0.5, "mu": 0.5, "restitution": 0.9}),
        ("classify", {"sides": 6, "alpha": 1.4, "beta": 0.5, "mu": 0.5, "restitution": 0.9}),
        ("classify", {"sides": 6, "alpha": 0.4, "beta": 0.5, "mu": 0.5}),
        ("simulate", {"sides": 6, "alpha": "x", "beta": 0.5, "mu": 0.5, "restitution": 0.9}),
        ("simulate", {"scene": "no-such.toml"}),
        ("recurrence", {"series": "no-such.csv"}),
        ("sweep", {"sides": 6, "grid": "alpha=0.2:0.6"}),
        ("orbits", {"period": 0, **{k: getattr(HEXAGON, k) for k in ("sides", "alpha", "beta", "mu", "restitution")}}),
        ("classify", {"record": "no-such.h5"}),
        ("lyapunov", {"collisions": 1.5}),
        ("fit", {"impacts": "no-such.csv"}),
        ("simulate", {"output": "/no/such/folder/orbit.h5", "sides": 6, "alpha": 0.4, "beta": 0.5, "mu": 0.5, "restitution": 0.9}),
    ]

    def test_wrong_input_is_a_value_error_with_the_line_of_the_command(self):
        for name, keywords in self.CASES:
            result = command(name, *(f"--{key.replace('_', '-')}={value}" for key, value in keywords.items()), "--json")
            self.assertEqual(result.returncode, 2, keywords)
            with self.assertRaises(ValueError) as raised:
                getattr(swirl, name)(**keywords)
            self.assertEqual("swirl: " + str(raised.exception), result.stderr.strip())

    def test_what_is_no_flag_no_truth_and_no_number_is_refused(self):
        for wrong in ({"collision": 5}, {"exhaustive": 1}, {"collisions": True}, {"collisions": object()}):
            with self.assertRaises((ValueError, TypeError)):
                swirl.classify(HEXAGON, **wrong)
        with self.assertRaises(ValueError):
            swirl.lyapunov("orbit.h5")

    def test_refusals_of_what_is_no_text_speak_of_the_argument(self):
        grid = lambda values: lambda: swirl.sweep(HEXAGON, grid={"alpha": values})
        for wrong, words in (
                (lambda: swirl.recurrence(series=np.array([])), r"^series: it has the shape \(0,\); \(n,\) or \(n, columns\) is wanted$"),
                (lambda: swirl.recurrence(series=[]), "^series is empty"),
                (lambda: swirl.recurrence(series=[[1, 2], [3]]), "^series: its rows have several lengths$"),
                (lambda: swirl.recurrence(series=np.array(["a"])), "^series: it holds <U1, numbers are wanted$"),
                (lambda: swirl.recurrence(series=np.array([1j, 2])), "^series: it holds complex128"),
                (lambda: swirl.recurrence(series=np.full(5, np.nan)), "^series has no rows of numbers"),
                (lambda: swirl.recurrence(series=np.zeros((30, 2)), column="x"), "'x' is no column of the array `series`"),
                (lambda: swirl.fit(impacts=np.zeros((3, 3))), "^impacts: column vx_before is missing.*; an array has no names of columns$"),
                (lambda: swirl.classify(np.zeros(100)), "^classify takes a Scene, a path or a Result; numbers are given as series=$"),
                (grid(np.zeros((2, 2))), r"^grid\['alpha'\] has the shape \(2, 2\); \(n,\) is wanted$"),
                (grid(np.array([0.3, np.nan])), r"^grid = \{'alpha': array\(\[0.3, *nan\]\)\}: alpha = nan is not finite$"),
                (grid((0.3, 0.5)), r"^grid = \{'alpha': \(0.3, 0.5\)\}: \{NAME: \(A, B, COUNT\)\}, .* or \{NAME: \[V, V, ...\]\} is wanted$"),
                (grid([True, 0.5]), r"^grid\['alpha'\]: True is no number$"),
                (lambda: swirl.continue_(HEXAGON, from_=np.zeros(5), along={"beta": 0.5}), r"^along = \{'beta': 0.5\}: \{NAME: \(A, B\)\} is wanted$"),
                (lambda: swirl.simulate(HEXAGON, point=np.zeros(4)), r"^point = array\(\[0., 0., 0., 0.\]\) has 4 numbers; it takes 5$"),
                (lambda: swirl.simulate(HEXAGON, point=np.zeros((2, 5))), "^point: .* is neither a number nor a word$"),
                (lambda: swirl.Scene(6, np.array([0.1, 0.2]), 0.5, 0.5, 0.5), r"^alpha: array\(\[0.1, 0.2\]\) is neither"),
                (lambda: HEXAGON.map("abc"), "^z = 'abc' is no array of numbers"),
                (lambda: HEXAGON.map([[1, 2], [3]]), "^z = .* is no array of numbers")):
            with self.assertRaisesRegex(ValueError, words):
                wrong()
        with self.assertRaisesRegex(TypeError, "^steps = 1.5 is no whole number$"):
            HEXAGON.map(np.zeros(5), steps=1.5)

    def test_what_cannot_be_written_is_an_os_error(self):
        with tempfile.TemporaryDirectory() as folder:
            script = ("import resource, sys; sys.path.insert(0, sys.argv[1]); import signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
                      "import swirl\nresource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000))\n"
                      "try:\n    swirl.simulate(sides=6, alpha=0.4, beta=0.5, mu=0.5, restitution=0.9, collisions=20_000, output='a.h5')\n"
                      "except OSError as error:\n    print('OSError', error)\n")
            import subprocess
            result = subprocess.run([sys.executable, "-B", "-c", script, str(MODULES)], cwd=folder, capture_output=True, text=True)
            self.assertIn("OSError cannot", result.stdout, result.stderr)
            self.assertEqual(os.listdir(folder), [])

    def test_a_numerical_ending_is_a_value(self):
        ended = swirl.simulate(sides=6, alpha=0.4, beta=0.1, mu=0.5, restitution=0.9, x=0.1)
        self.assertEqual((ended.outcome, ended.exit_code), ("no-contact", 3))


if __name__ == "__main__":
    unittest.main()
