"""An installed swirl brings its manual and the completion of shells: installed_pages_test.py PREFIX"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

PREFIX = Path(sys.argv.pop(1)).resolve()
SWIRL = PREFIX / "bin/swirl"


def told(*arguments):
    return subprocess.run([SWIRL, *arguments], capture_output=True, text=True, check=True, timeout=60).stdout


class InstalledPages(unittest.TestCase):
    def test_every_page_is_there_and_that_of_this_program(self):
        commands = re.findall(r"^  ([a-z]+) ", told("--help").split("Subcommands:")[1], re.M)
        folder = PREFIX / "share/man/man1"
        self.assertEqual({page.name for page in folder.iterdir()},
                         {"swirl.1"} | {f"swirl-{command}.1" for command in commands})
        for command in commands:
            self.assertEqual((folder / f"swirl-{command}.1").read_text(), told("manual", command))

    def test_both_shells_find_their_script(self):
        for shell, path in (("bash", "bash-completion/completions/swirl"), ("zsh", "zsh/site-functions/_swirl")):
            self.assertEqual((PREFIX / "share" / path).read_text(), told("completion", shell))


if __name__ == "__main__":
    unittest.main()
