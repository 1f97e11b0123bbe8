"""sites.py, mutants.py: what is drawn, and that nothing but code is changed."""

import contextlib
import io
import itertools
import json
import re
import tempfile
import unittest
from pathlib import Path

import mutants
from sites import KINDS, STRATA, Mutant, code_of, drawn, mutants_of_text, other_number

ROOT = Path(__file__).resolve().parent.parent.parent

TEXT = """// a comment: x + y < 2
#include "map/2d + 3.hpp"
#define SUM(a, b) \\
    (a) + (b)
template <int n = 2>
using Two = Tuple<2>;
/* long: a + b
   c < d && e */
static_assert(two == 2);
std::vector<Vec2<T>> kept(const std::string& s) { return find(s, "1 + 2 \\" - 3 < 4", '7'); }  // 5 < 6
"""


def one_line(code):
    """(kind, what the line becomes) of all mutants of a line."""
    return {(mutant.kind, mutant.after) for mutant in mutants_of_text("f.hpp", code)}


class Sites(unittest.TestCase):
    def test_comments_texts_includes_and_declarations_are_left_alone(self):
        self.assertEqual(list(mutants_of_text("f.hpp", TEXT)), [])

    def test_code_keeps_its_columns(self):
        self.assertEqual(len(code_of(TEXT)), len(TEXT))
        self.assertEqual(code_of("n = 100'000; // 1\nm = 'x' + \"y\";"), "n = 100'000;     \nm =     +    ;")

    def test_each_kind_of_operator(self):
        self.assertEqual(one_line("c = a + b;"), {("sign", "c = a - b;")})
        self.assertEqual(one_line("c -= a;"), {("sign", "c += a;")})
        self.assertEqual(one_line("if (a < b) f();"),
                         {("comparison", "if (a <= b) f();"), ("comparison", "if (a > b) f();")})
        self.assertEqual(one_line("return a == b || c;"),
                         {("comparison", "return a != b || c;"), ("logic", "return a == b && c;")})
        self.assertEqual(one_line("c = std::min(a, b);"), {("extreme", "c = std::max(a, b);")})
        self.assertEqual(one_line("c = sin(asin(a));"), {("function", "c = cos(asin(a));")})
        self.assertEqual(one_line("c = f(-a, b);"), {("unary minus", "c = f(a, b);")})
        self.assertEqual(one_line("if (!a) f();"), {("negation", "if (a) f();")})
        self.assertEqual(one_line("c = T(2) * x2;"), {("constant", "c = T(3) * x2;")})

    def test_another_number_is_another_number(self):
        for text, other in (("0", "1"), ("2", "3"), ("0.5", "0.25"), ("0.0", "1.0"), ("1e-9", "1e-8"), ("3.", "1.5"),
                            ("0x1p-17", "0x1p-16"), ("0x1.8p52", "0x1.8p53"), ("100'000", "100001")):
            self.assertEqual(other_number(text), other)

    def test_brackets_of_templates_and_pointers_are_no_comparisons(self):
        self.assertEqual(one_line("const std::array<T, n> x = f<T>(a->b);"), set())


class Draw(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.all = list(drawn(ROOT, 1))

    def test_one_seed_draws_the_same(self):
        self.assertEqual(self.all, list(drawn(ROOT, 1)))
        self.assertNotEqual(self.all[:60], list(itertools.islice(drawn(ROOT, 2), 60)))

    def test_every_mutant_changes_one_line_of_code(self):
        lines = {}
        for mutant in self.all:
            if mutant.file not in lines:
                text = (ROOT / mutant.file).read_text(encoding="utf-8")
                lines[mutant.file] = text.split("\n"), code_of(text).split("\n")
            text, code = (part[mutant.line - 1] for part in lines[mutant.file])
            self.assertEqual(mutant.before, text)
            self.assertNotEqual(mutant.after, text)
            self.assertNotIn("\n", mutant.after)
            self.assertFalse(code.lstrip().startswith("#"))
            first = next(i for i, (a, b) in enumerate(zip(text + "\0", mutant.after + "\0")) if a != b)
            self.assertNotEqual(code[first:].strip(), "", f"a comment: {mutant}")

    def test_each_has_a_name_of_its_own(self):
        self.assertEqual(len({mutant.key for mutant in self.all}), len(self.all))

    def test_all_folders_and_all_kinds_are_drawn(self):
        first = self.all[:60]
        self.assertEqual({re.match(r"map/([^/]+)", mutant.file)[1] for mutant in first}, set(STRATA))
        self.assertEqual({mutant.kind for mutant in first}, set(KINDS))

    def test_an_edit_elsewhere_does_not_draw_anew(self):
        text = "c = a + b;\nd = a - b;"
        keys = {mutant.key for mutant in mutants_of_text("f.hpp", text)}
        self.assertEqual(keys, {mutant.key for mutant in mutants_of_text("f.hpp", "\n" + text)})


class MadeUp:
    """Stands in for a scratch copy: the verdict is what the mutated line says."""

    def judge(self, mutant):
        return mutant.after, "its line"


class Judging(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "results.json"
        self.mutants = [Mutant("f.hpp", i, "sign", str(i), verdict)
                        for i, verdict in enumerate(["killed", "invalid", "survived", "killed", "killed"])]

    def judged(self, count):
        results = mutants.Results(self.file)
        with contextlib.redirect_stdout(io.StringIO()) as out:
            valid = mutants.judge_all(self.mutants, [MadeUp(), MadeUp()], results, count)
        return valid, results, out.getvalue()

    def test_what_does_not_compile_does_not_count(self):
        valid, results, _ = self.judged(4)
        self.assertEqual([mutant.line for mutant in valid], [0, 2, 3, 4])
        self.assertIn("3 of 4 mutants killed (75.0 %)\nsurvived: f.hpp:2", mutants.summary(valid, results))

    def test_goes_on_where_it_was_interrupted(self):
        self.judged(2)
        valid, _, said = self.judged(3)
        self.assertEqual(len(valid), 3)
        self.assertEqual(said.count("its line"), 1)


class Recorded(unittest.TestCase):
    def test_every_survivor_has_its_reason(self):
        recorded = json.loads(mutants.RECORDED.read_text(encoding="utf-8"))
        self.assertTrue(recorded)
        for key, one in recorded.items():
            self.assertIn(one["verdict"], ("killed", "survived"))
            self.assertTrue(one["by"], key)
            if one["verdict"] == "survived":
                self.assertTrue(one.get("reason"), key)

    def test_a_reason_stays_while_its_mutant_survives(self):
        with tempfile.TemporaryDirectory() as folder:
            kept, mutants.RECORDED = mutants.RECORDED, Path(folder) / "recorded.json"
            self.addCleanup(setattr, mutants, "RECORDED", kept)
            results = mutants.Results(Path(folder) / "results.json")
            one = Mutant("f.hpp", 1, "sign", "a + b", "a - b")
            results.put(one, "survived", "3 programs", 1)
            mutants.RECORDED.write_text(json.dumps({one.key: {"verdict": "survived", "by": "", "reason": "a slack"}}))
            mutants.record([one], results)
            self.assertEqual(json.loads(mutants.RECORDED.read_text())[one.key]["reason"], "a slack")
            results.put(one, "killed", "A.Test", 1)
            mutants.record([one], results)
            self.assertEqual(json.loads(mutants.RECORDED.read_text())[one.key], {"verdict": "killed", "by": "A.Test"})


if __name__ == "__main__":
    unittest.main()
