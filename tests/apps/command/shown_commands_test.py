"""What documents show runs as it stands: shown_commands_test.py SWIRL ROOT [--all]

command.contract runs the blocks of README.md and docs/examples.md and the examples of --help, command.tutorial the blocks of
the tutorial, command.film those of docs/film-to-verdict.md; this runs the commands within sentences, the blocks of other documents and the Python of
notebooks-export/README.md, each in a folder where what it reads has been made, by the commands that documents show for that.
--all: also films, notebooks and what takes minutes."""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

from driving import SWIRL, InFolder
from shown_commands import blocks_of, in_blocks, in_sentences

ALL = "--all" in sys.argv and not sys.argv.remove("--all")
ROOT = Path(sys.argv.pop(1)).resolve()
DOCUMENTS = {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in sorted(ROOT.rglob("*.md"))
             if not {"build", ".git"} & set(path.relative_to(ROOT).parts)}
#: Run by others (see above).
ELSEWHERE = {"README.md", "docs/examples.md", "docs/tutorial.md", "docs/film-to-verdict.md"}
#: Three times ten seconds and a diagram of 400 columns; the hundredth part of a sweep of a million runs; a map of 81 cells.
LONG = {"docs/figures/README.md", "docs/command-line.md", "docs/explore.md"}
#: What is said of a command and is none by itself: no output, or a word that stands for any.
FRAGMENT = re.compile(r"…|\.\.\.|\[|\||\b(COMMAND|NAME|RECORD|FIGURE|FILE|SHARD)\b(?!\.csv)")
NEEDS_OUTPUT = ("plot", "animate", "notebook", "explore", "join")
#: Half of the time of all; their own tests run others of them.
SLOW = ("animate", "notebook")

SERIES = "t S\n" + "".join(f"{0.1 * i:.1f} {((37 * i) % 100) / 100}\n" for i in range(200))
SMALL = "--sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.3:0.5:2 --grid beta=0.4:0.5:2 --transient 100 --collisions 100"
#: What no document makes: its text, or the commands that make it.
MADE = {"FILE.csv": SERIES, "scene.toml": "[scene]\nsides = 6\nmu = 0.5\nrestitution = 0.95\n",
        "part-*.h5": [f"swirl sweep {SMALL} --shard {i}/2 -o part-{i}.h5" for i in (1, 2)]}


def is_whole(command):
    words = command.split()
    if FRAGMENT.search(command) or len(words) < 3 and words[1] != "--version":
        return False
    return words[1] not in NEEDS_OUTPUT or "-o" in words


def written(command):
    return re.findall(r"-o (\S+)", command)


def read(command):
    return [name for name in re.findall(r"[^\s=\"]+\.(?:h5|toml|csv)\b", command) if name not in written(command) and "$" not in name]


class Shown(InFolder):
    def setUp(self):
        super().setUp()
        (self.folder / "bin").mkdir()
        (self.folder / "bin/swirl").symlink_to(SWIRL)
        (self.folder / "notebooks-export").symlink_to(ROOT / "notebooks-export")

    def shell(self, script, **variables):
        environment = {**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}", "MPLBACKEND": "Agg", **variables}
        result = subprocess.run(["sh", "-ec", script], cwd=self.folder, env=environment, capture_output=True, text=True, timeout=1000)
        self.assertEqual(result.returncode, 0, (script, result.stderr))
        return result

    def make(self, name, document):
        """By a command of the document, or of one that others follow, or as above."""
        if (self.folder / name).exists():
            return
        for text in (DOCUMENTS[document], *(DOCUMENTS[other] for other in sorted(ELSEWHERE))):
            for scene in blocks_of(text, "toml"):
                if scene.startswith(f"# {name}\n"):
                    return (self.folder / name).write_text(scene)
            for command in in_blocks(text):
                if name in written(command) and "$" not in command:
                    return self.run_shown(command, document)
        made = MADE[name]
        if isinstance(made, str):
            return (self.folder / name).write_text(made)
        for command in made:
            self.shell(command)

    def run_shown(self, command, document):
        for name in read(command):
            self.make(name, document)
        self.shell(command)
        for name in written(command):
            self.assertTrue((self.folder / name).exists(), (document, command))

    def test_the_commands_within_sentences(self):
        count = 0
        for document, text in DOCUMENTS.items():
            for command in filter(is_whole, in_sentences(text)):
                word = command.split()[1]
                if word in SLOW and not ALL:
                    continue
                with self.subTest(document=document, command=command):
                    self.run_shown(command, document)
                count += 1
        self.assertGreater(count, 5)

    def test_the_python_of_the_notebooks_document(self):
        text = DOCUMENTS["notebooks-export/README.md"]
        self.make("orbit.h5", "README.md")
        block, = blocks_of(text, "python")
        (self.folder / "shown.py").write_text(block)
        python = os.environ.get("SWIRL_PYTHON", "/usr/bin/python3")
        self.assertEqual(self.shell(f"'{python}' -B shown.py").stderr, "")
        for name in re.findall(r'save\(figure, "(.*?)"\)', block):
            self.assertGreater((self.folder / name).stat().st_size, 1000)

    def test_no_block_of_commands_is_left_to_nobody(self):
        for document, text in DOCUMENTS.items():
            if document not in ELSEWHERE | LONG:
                self.assertEqual(list(in_blocks(text)), [], document)

    @unittest.skipUnless(ALL, "nightly")
    def test_the_blocks_of_other_documents(self):
        for document in sorted(LONG):
            for command in in_blocks(DOCUMENTS[document]):
                for name in read(command):
                    self.make(name, document)
            for block in blocks_of(DOCUMENTS[document], "sh"):
                self.shell(block, SLURM_ARRAY_TASK_ID="1", SLURM_CPUS_PER_TASK="2")


if __name__ == "__main__":
    unittest.main()
