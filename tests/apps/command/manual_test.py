"""The manual and the completion of shells hold all that --help does: manual_test.py SWIRL"""

import functools
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from driving import SWIRL, InFolder, examples_of, run

COMMANDS = re.findall(r"^  ([a-z]+) ", run("--help").stdout.split("Subcommands:")[1], re.M)


@functools.cache
def help_of(command):
    return run(f"{command} --help").stdout


def flags_of(command):
    """All that --help of a command lists; of no command the program's own."""
    text = help_of(command)
    return sorted({flag for line in re.findall(r"^  (-\S+)", text, re.M) for flag in line.split(",")})


def plain(page):
    """A page's words, without what troff reads."""
    return re.sub(r"\\f[BIR]", "", page.replace("\\-", "-").replace("\\(aq", "'"))


def offered(line, environment=None):
    """What bash completes of `line`, whose last word the cursor stands behind: words as bash itself splits them, the last
    one in a quote that is open."""
    words = [word for word in re.findall(r"[\"'].*|[=:]|[^\s=:]+", line) if word]
    if line.endswith(" "):
        words.append("")
    script = f"""eval "$("{SWIRL}" completion bash)" || exit 1
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _swirl; printf '%s\\n' "${{COMPREPLY[@]}}" """
    result = subprocess.run(["bash", "--norc", "-c", script, "bash", *words], capture_output=True, text=True, timeout=60,
                            **(environment or {}))
    assert result.returncode == 0 and not result.stderr, result.stderr
    return result.stdout.split("\n")[:-1] if result.stdout.strip() else []


class Manual(InFolder):
    def test_every_command_has_a_page_with_every_flag_in_both_forms(self):
        self.assertGreaterEqual(len(COMMANDS), 20)
        for form, suffix in (("man", ".1"), ("markdown", ".md")):
            self.assertEqual(run(f"manual --format {form} -o {self.folder}/{form}").returncode, 0)
            names = {f"swirl{suffix}"} | {f"swirl-{command}{suffix}" for command in COMMANDS}
            self.assertEqual({path.name for path in (self.folder / form).iterdir()}, names)
            program = plain((self.folder / form / f"swirl{suffix}").read_text())
            for command in COMMANDS:
                self.assertRegex(program, rf"swirl[ -]{command}\b")
                page = (self.folder / form / f"swirl-{command}{suffix}").read_text()
                self.assertEqual(page, run(f"manual {command} --format {form}").stdout)
                flags = flags_of(command)
                self.assertIn("--help", flags)
                for flag in flags:
                    self.assertRegex(plain(page), rf"(?<![\w-]){flag}(?![\w-])", (command, form))
                for example in examples_of(command):
                    self.assertIn(f"swirl {example}", plain(page), command)

    def test_every_word_of_help_is_in_the_page(self):
        for command in COMMANDS:
            text = help_of(command).split("Usage:")[1]
            details = text[text.index("\n\n"):]
            page = plain(run(f"manual {command}").stdout).replace("\\e", "\\")
            page = page.replace("\\(ga", "`").replace("\\(ha", "^").replace("\\(ti", "~").replace("\\&", "")
            words = set(re.findall(r"[a-z]{4,}", page.lower()))
            missing = set(re.findall(r"[a-z]{4,}", details.lower())) - words - {"positionals", "float", "example"}
            self.assertEqual(missing, set(), command)

    def test_ranges_are_said(self):
        self.assertIn("whole number, 1 to 256", run("manual orbits").stdout)
        self.assertIn("0 or more", run("manual classify").stdout)
        self.assertIn("poisson|newton|stronge", run("manual classify").stdout)

    def test_files_that_are_no_pages_are_kept(self):
        mine = self.file("swirl-plot.1", "mine\n")
        result = run(f"manual -o {self.folder}")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("swirl-plot.1", result.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], [mine.name])
        mine.unlink()
        for _ in range(2):  # the second time over its own
            self.assertEqual(run(f"manual -o {self.folder}").returncode, 0)
        for wrong, mention in (("nonsense", "nonsense"), ("--format html", "html"), ("plot -o x", "--output"),
                               (f"-o {self.folder}/swirl.1", "swirl.1")):
            result = run(f"manual {wrong}")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), wrong)
            self.assertIn(mention, result.stderr)

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed: whether it warns of the pages is not tested")
    def test_groff_sets_the_pages_without_a_warning(self):
        run(f"manual -o {self.folder}")
        for page in sorted(self.folder.iterdir()):
            # 150: examples are lines that a reader copies whole.
            result = subprocess.run(["groff", "-man", "-Tutf8", "-Kutf8", "-ww", "-rLL=150n", page], capture_output=True,
                                    text=True, timeout=60)
            self.assertEqual((result.returncode, result.stderr), (0, ""), page.name)
            self.assertIn("EXIT STATUS", re.sub(r"\x1b\[\d*m|.\x08", "", result.stdout))


class Bash(InFolder):
    def test_commands_and_flags(self):
        self.assertEqual(offered("swirl cla"), ["classify"])
        self.assertEqual(set(offered("swirl ")), set(COMMANDS) | set(flags_of("")))
        self.assertEqual(offered("swirl classify --la"), ["--law"])
        self.assertEqual(offered("swirl nonsense --la"), [])
        for command in COMMANDS:
            self.assertEqual(sorted(offered(f"swirl {command} -")), flags_of(command), command)

    def test_the_words_of_a_flag(self):
        laws = ["poisson", "newton", "stronge"]
        self.assertEqual(offered("swirl classify --law "), laws)
        self.assertEqual(offered("swirl classify --sides 6 --law=st"), ["stronge"])
        self.assertEqual(offered("swirl classify --law="), laws)
        self.assertEqual(offered("swirl simulate --accuracy fi"), ["fixed-step"])
        self.assertEqual(offered("swirl sweep --grid al"), ["alpha="])
        self.assertEqual(offered("swirl sweep --grid alpha=0.2:0.6"), [])
        self.assertEqual(offered("swirl recurrence --convention CRP"), ["CRP\\ Toolbox"])
        self.assertEqual(offered("swirl manual sw"), ["sweep"])
        self.assertEqual(offered("swirl classify --alpha "), [])

    def test_a_word_in_an_open_quote(self):
        self.assertEqual(offered("swirl classify --law 'st"), ["stronge"])
        self.assertEqual(offered('swirl classify --law="'), ["poisson", "newton", "stronge"])
        self.assertEqual(offered("swirl recurrence --convention 'CRP T"), ["CRP Toolbox"])
        self.file("two words.h5", "")
        self.assertEqual(offered('swirl plot "two w', {"cwd": self.folder}), ["two words.h5"])

    def test_files_by_their_suffix(self):
        for name in ("a.h5", "two words.h5", "b.csv", "c.toml"):
            self.file(name, "")
        (self.folder / "sub").mkdir()
        here = {"cwd": self.folder}
        records = {"a.h5", "two words.h5", "sub"}
        self.assertEqual(set(offered("swirl plot ", here)), records)
        self.assertEqual(set(offered("swirl simulate -o ", here)), records)
        self.assertEqual(set(offered("swirl classify --series ", here)), {"b.csv", "sub"})
        self.assertEqual(set(offered("swirl classify --scene=", here)), {"c.toml", "sub"})
        self.assertEqual(set(offered("swirl plot a.h5 -o ", here)), records | {"b.csv", "c.toml"})

    def test_an_offered_word_is_one_that_the_program_knows(self):
        """What --help lists beside the flag, or in the details beneath."""
        script = run("completion bash").stdout
        flags = re.findall(r"^ +'(\w+) (--[\w-]+)'[^)]*\) _swirl_words (.*) ;;$", script, re.M)
        self.assertGreater(len(flags), 60)
        for command, flag, words in flags:
            text = " ".join(help_of(command).split())  # two words may stand on two lines
            for word in re.findall(r"'([^']*)'", words):
                self.assertIn(word.rstrip("=:"), text, (command, flag))


@unittest.skipUnless(shutil.which("zsh"), "zsh is not installed: its completion is not tested")
class Zsh(InFolder):
    def offered(self, line):
        """What a zsh lists when Tab is pressed behind a line: it runs on a terminal of its own (zsh/zpty)."""
        (self.folder / "got").unlink(missing_ok=True)
        (self.folder / "_swirl").write_text(run("completion zsh").stdout)
        script = """
zmodload zsh/zpty
zpty shell "$SHELL_TO_TRY -f -i"
zpty -w shell "PS1=; unsetopt beep; fpath=($FOLDER \\$fpath); autoload -Uz compinit; compinit -u -d $FOLDER/dump"
zpty -w shell "zstyle ':completion:*' list-separator '@@'; LISTMAX=1000"
zpty -w shell "_all() { compadd() { if [[ \\${@[1,(i)(-|--)]} == *-(O|A|D)\\ * ]]; then builtin compadd \\"\\$@\\"; return; fi; local -a got; builtin compadd -A got \\"\\$@\\"; print -rC1 -- \\$got >> $FOLDER/got; builtin compadd \\"\\$@\\"; }; _main_complete; exit; }"
zpty -w shell "zle -C all complete-word _all; bindkey '^I' all; print READY"
zpty -r -m shell seen '*READY*READY*'
zpty -w -n shell "$LINE"$'\\t'
zpty -r -m shell seen '*NEVER*' &>/dev/null
"""
        environment = {**os.environ, "FOLDER": str(self.folder), "LINE": line, "SHELL_TO_TRY": shutil.which("zsh"),
                       "PATH": f"{Path(SWIRL).parent}:{os.environ['PATH']}", "TERM": "dumb"}
        subprocess.run(["zsh", "-f", "-c", script], env=environment, capture_output=True, timeout=30, cwd=self.folder)
        got = self.folder / "got"
        return sorted(set(got.read_text().split())) if got.exists() else []

    def test_the_script_is_one(self):
        script = self.file("_swirl", run("completion zsh").stdout)
        self.assertTrue(script.read_text().startswith("#compdef swirl\n"))
        subprocess.run(["zsh", "-f", "-n", script], check=True, timeout=60)
        for command in COMMANDS:
            case = re.search(rf"^    {command}\)$(.*?) ;;$", script.read_text(), re.M | re.S)[1]
            self.assertEqual(sorted(re.findall(r"^ +'(?:\*|\([^)]*\))(--?[\w-]+)", case, re.M)), flags_of(command), command)

    def test_it_completes(self):
        self.assertEqual(self.offered("swirl cla"), ["classify"])
        self.assertEqual(self.offered("swirl classify --la"), ["--law"])
        self.assertEqual(self.offered("swirl classify --law "), ["newton", "poisson", "stronge"])


if __name__ == "__main__":
    unittest.main()
