"""The C++ that documents show compiles: snippets_test.py COMPILE_COMMANDS ROOT

Each block is the inside of a function, a type, or a formula of map/, with the flags of this build; what its document takes for granted is
given below."""

import json
import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

COMMANDS, ROOT = Path(sys.argv.pop(1)), Path(sys.argv.pop(1)).resolve()
#: By document: lines before the function, and its arguments.
TAKEN_FOR_GRANTED = {
    "map/README.md": ("", ""),
    "map/batch/README.md": ("", "const swirl::Scene<>& scene, "
                            "const std::vector<swirl::PostImpactState<double>>& starts"),
    "map/proof/README.md": ("#include <iostream>\n", ""),
    "map/steady/README.md": ("#include <iostream>\n", ""),
    "docs/library.md": ("", ""),
    "apps/record/README.md": ('#include "apps/record/record_writer.hpp"\nusing namespace swirl::apps;\n',
                              "const std::string& version, const std::string& instruction_set"),
    "analysis/recurrence/README.md": ("#include <vector>\n", "const std::vector<double>& series"),
}
#: Around a formula, which stands in map/ too.
FORMULA = ('#include "map/model/body.hpp"\n#include "map/model/flight.hpp"\n#include "map/numbers/real.hpp"\n#include <cmath>\nnamespace swirl::shown {{\n'
           '{}}}\ntemplate double swirl::shown::{}(const swirl::Body<double>&, const swirl::Flight<double>&);')


def snippets():
    """(document, block) of each."""
    for path in sorted(ROOT.rglob("*.md")):
        if "build" not in path.relative_to(ROOT).parts:
            for block in re.findall(r"^```(?:cpp|c\+\+)\n(.*?)^```", path.read_text(encoding="utf-8"), re.M | re.S):
                yield str(path.relative_to(ROOT)), block


def flags():
    """Those of a file of apps/, without its output and its precompiled header."""
    entry = next(entry for entry in json.loads(COMMANDS.read_text()) if entry["file"].endswith("apps/main.cpp"))
    words, kept = shlex.split(entry["command"]), []
    skip = False
    for word in words[1:]:
        if not skip and re.match(r"-(I|isystem|D|std=)", word) or skip == "isystem":
            kept.append(word)
        skip = "isystem" if word == "-isystem" else False
    return [words[0], *kept]


class Snippets(unittest.TestCase):
    def test_each_compiles(self):
        self.assertEqual({document for document, _ in snippets()}, set(TAKEN_FOR_GRANTED))
        for document, block in snippets():
            before, arguments = TAKEN_FOR_GRANTED[document]
            included = re.findall(r"^#include .*$", block, re.M)
            inside = re.sub(r"^#include .*$", "", block, flags=re.M)
            is_type = re.search(r"^struct ", inside, re.M)
            function = [inside] if is_type else [f"void shown({arguments});", f"void shown({arguments}) {{", inside, "}"]
            formula = re.search(r"^template <class T>\n.* (\w+)\(const Body<T>& body, const Flight<T>& flight\) {", block, re.M)
            source = FORMULA.format(block, formula[1]) if formula else "\n".join([*included, before, *function])
            with self.subTest(document=document):
                result = subprocess.run([*flags(), "-fsyntax-only", "-x", "c++", "-"], input=source, capture_output=True, text=True,
                                        cwd=ROOT, timeout=300)
                self.assertEqual(result.returncode, 0, result.stderr[:2000])


if __name__ == "__main__":
    unittest.main()
