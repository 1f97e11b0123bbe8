"""The commands that documents show are swirl's: documents_test.py SWIRL ROOT

Others run them (command.contract those of README.md's blocks and of --help, command.tutorial those of the tutorial's,
command.shown_commands the rest); this looks at all that stand anywhere, in blocks and within sentences."""

import json
import re
import sys
import unittest
from pathlib import Path

from driving import run
from shown_commands import shown

ROOT = Path(sys.argv.pop(1)).resolve()
LEFT_OUT = {"build", ".git"}
DOCUMENTS = {path.relative_to(ROOT): path.read_text(encoding="utf-8") for path in sorted(ROOT.rglob("*.md"))
             if not LEFT_OUT & set(path.relative_to(ROOT).parts)}
#: The help lists examples beneath.
COMMANDS = list(dict.fromkeys(re.findall(r"^  ([a-z]+) ", run("--help").stdout.split("Subcommands:")[1], re.M)))
#: What stands for a command's name where all are meant.
ANY = {"COMMAND", "NAME", "…", "..."}


def flags(command):
    return set(re.findall(r"(?<![\w-])(--[a-z][\w-]*|-[a-z])(?![\w-])", re.sub(r"'[^']*'|\"[^\"]*\"", "", command)))


class Documents(unittest.TestCase):
    def test_each_command_and_flag_is_one(self):
        known = {command: set(re.findall(r"\\fB(-[\w-]+)\\fR", run(f"manual {command}").stdout.replace("\\-", "-")))
                 for command in COMMANDS}
        every = set().union(*known.values()) | {"--version"}
        count = 0
        for name, text in DOCUMENTS.items():
            for line in shown(text):
                word = line.split()[1].rstrip(",;")
                if word == "help":  # swirl help COMMAND
                    word = line.split()[2].rstrip(",;")
                if word.startswith("-") or word in ANY:
                    self.assertLessEqual(flags(line), every, (str(name), line))
                    continue
                self.assertIn(word, known, (str(name), line))
                self.assertLessEqual(flags(line), known[word], (str(name), line))
                count += 1
        self.assertGreater(count, 60)

    def test_each_preset_is_one(self):
        presets = json.loads((ROOT / "CMakePresets.json").read_text())
        for name, text in DOCUMENTS.items():
            for tool, preset in re.findall(r"\b(cmake|ctest)(?: --build)? --preset ([\w-]+)", text):
                kind = "testPresets" if tool == "ctest" else "configurePresets"
                self.assertIn(preset, {one["name"] for one in presets[kind]}, str(name))

    def test_every_command_is_in_the_tables(self):
        for name in ("README.md", "docs/command-line.md"):
            listed = re.findall(r"^\| \[`([a-z]+)`\]", DOCUMENTS[Path(name)], re.M)
            self.assertEqual(listed, COMMANDS if name != "README.md" else listed)
            self.assertEqual(set(listed), set(COMMANDS), name)


if __name__ == "__main__":
    unittest.main()
