"""Standard input, output and error as they may be found: closed, full, without a reader. streams_test.py SWIRL"""

import json
import os
import subprocess
import unittest

import h5py

from driving import SWIRL, InFolder

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
SHORT = f"{HEXAGON} --transient 100 --collisions 100"
SWEEP = "sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.2:0.8:3 --transient 100 --collisions 64"


class Streams(InFolder):
    def shell(self, line):
        return subprocess.run(["bash", "-c", line], capture_output=True, text=True, timeout=60, cwd=self.folder,
                              env={**os.environ, "S": SWIRL})

    def check_record(self, name):
        with h5py.File(self.folder / name) as file:
            self.assertEqual(file.attrs["schema_version"], 2)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), [name])
        (self.folder / name).unlink()

    def test_a_closed_output_gets_no_record(self):
        for flags in ("--json", ""):
            result = self.shell(f"$S classify {SHORT} {flags} -o c.h5 >&-")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (4, 1), result.stderr)
            self.check_record("c.h5")

    def test_a_closed_output_does_not_matter_where_nothing_is_printed(self):
        result = self.shell(f"$S simulate {HEXAGON} --quiet -o c.h5 >&-")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.check_record("c.h5")

    def test_a_closed_error_gets_no_record(self):
        result = self.shell(f"{SWEEP.replace('sweep', '$S sweep')} --json -o c.h5 2>&-")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(len(json.loads(result.stdout)["cells"]), 3)
        self.check_record("c.h5")

    def test_all_of_them_closed(self):
        result = self.shell(f"$S simulate {HEXAGON} --quiet -o c.h5 <&- >&- 2>&-")
        self.assertEqual(result.returncode, 0)
        self.check_record("c.h5")
        self.assertEqual(self.shell("$S simulate --sides 2 <&- >&- 2>&-").returncode, 2)

    def test_a_closed_input_cannot_be_read(self):
        result = self.shell("$S spectrum --series - -o c.h5 <&-")
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_output_and_messages_in_one_file_keep_their_lines(self):
        # A table longer than what the library holds back before it writes.
        result = self.shell(f"$S {SWEEP.replace(':3', ':60')} >both.txt 2>&1")
        self.assertEqual(result.returncode, 0)
        text = (self.folder / "both.txt").read_text()
        self.assertGreater(len(text), 4200)
        self.assertRegex(text.splitlines()[-1], r"^swirl: [0-9.]+ s$")

    def test_a_message_that_cannot_be_written_changes_no_exit_code(self):
        for closed in ("2>/dev/full", "2>&-", "2> >(exec true)"):
            for line, code in ((f"{SWEEP} -o c.h5", 0), (f"{SWEEP} -o c.h5", 0), ("simulate --sides 2", 2),
                               ("nonsense", 2), (f"classify {SHORT} --json >/dev/full", 4)):
                result = self.shell(f"$S {line} {closed}")
                self.assertEqual(result.returncode, code, (line, closed))
            self.check_record("c.h5")

    def test_help_that_cannot_be_written_exits_with_4(self):
        for output in (">/dev/full", ">&-"):
            for flags in ("--help", "classify --help", "--version"):
                result = self.shell(f"$S {flags} {output}")
                self.assertEqual((result.returncode, len(result.stderr.splitlines())), (4, 1), (flags, output))

    def test_output_that_nobody_reads_leaves_no_stray_file_and_no_word(self):
        for line in (f"simulate {HEXAGON} --collisions 20000 --json -o c.h5", f"simulate {HEXAGON} --collisions 20000",
                     f"recurrence {HEXAGON} --transient 10 --collisions 3000 --image 400 --threshold 0.1 --json",
                     f"classify {SHORT} --json -o c.h5"):
            result = self.shell(f"$S {line} | head -c 1; exit ${{PIPESTATUS[0]}}")
            self.assertIn(result.returncode, (0, 4), line)  # what fits into the pipe is written
            self.assertEqual(result.stderr, "", line)  # who reads no further is not told
            self.assertLessEqual({p.name for p in self.folder.iterdir()}, {"c.h5"})


if __name__ == "__main__":
    unittest.main()
