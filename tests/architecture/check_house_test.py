"""check_layers.py, check_sizes.py, check_names.py and check_standard.py on made-up files: each must find what it is for, and only that."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import check_layers
import check_names
import check_sizes
import check_standard


def with_files(files, use):
    """What `use(root)` says of a tree of these files."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return use(root)


def printed(main, files):
    """Exit code and output of a check's main function."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(io.StringIO()):
        code = with_files(files, lambda root: main([str(root)]))
    return code, output.getvalue()


class Layers(unittest.TestCase):
    FILES = {
        "map/numbers/real.hpp": "#pragma once\n",
        "map/model/scene.hpp": '#include "map/numbers/real.hpp"\n',
        "map/collision_map.hpp": '#include "map/model/scene.hpp"\n',
    }

    def test_rooms_are_printed_from_the_top_down(self):
        code, text = printed(check_layers.main, self.FILES)
        self.assertEqual(code, 0)
        self.assertEqual([line.split() for line in text.splitlines()],
                         [["2", "map/collision_map"], ["1", "map/model"], ["0", "map/numbers"]])

    def test_a_circle_of_folders_is_found_where_the_files_have_none(self):
        back = {**self.FILES, "map/numbers/tables.hpp": '#include "map/model/body.hpp"\n', "map/model/body.hpp": "\n"}
        code, text = printed(check_layers.main, back)
        self.assertEqual(code, 1)
        self.assertIn("a circle of folders: map/model -> map/numbers -> map/model", text)

    def test_a_folder_that_the_picture_lacks_is_named(self):
        drawn = {**self.FILES, "docs/architecture.svg": "<text>numbers/</text>"}
        code, text = printed(check_layers.main, drawn)
        self.assertEqual(code, 1)
        self.assertIn("docs/architecture.svg does not show map/model/", text)
        self.assertNotIn("show map/numbers/", text)

    def test_nothing_to_check_is_an_error(self):
        self.assertEqual(printed(check_layers.main, {"README.md": ""})[0], 2)


def function_of(lines):
    return "int f(int x) {\n" + "    ++x;\n" * (lines - 2) + "}\n"


class Sizes(unittest.TestCase):
    def found(self, text, name="map/a.cpp"):
        return with_files({name: text}, check_sizes.check)

    def test_sixty_lines_pass_and_sixty_one_do_not(self):
        self.assertEqual(self.found(function_of(60)), [])
        self.assertEqual(self.found(function_of(61)), ["map/a.cpp:1: a function of 61 lines; at most 60"])

    def test_arguments_on_lines_of_their_own_hide_no_function(self):
        text = "struct S {\n    int f(int a,\n          int b) const {\n" + "        ++a;\n" * 60 + "    }\n};\n"
        self.assertEqual(self.found(text), ["map/a.cpp:3: a function of 62 lines; at most 60"])

    def test_a_long_class_is_no_function(self):
        self.assertEqual(self.found("class C : public D<int()> {\n" + "    int a;\n" * 80 + "};\n"), [])

    def test_functions_that_follow_one_another_are_told_apart(self):
        self.assertEqual(self.found(function_of(40) + "\n" + function_of(40)), [])

    def test_five_hundred_lines_pass_and_one_more_does_not(self):
        self.assertEqual(self.found("\n" * 500), [])
        self.assertEqual(self.found("\n" * 501), ["map/a.cpp:501: 501 lines; at most 500"])
        self.assertEqual(self.found("\n" * 501, "notebooks-export/a.py"),
                         ["notebooks-export/a.py:501: 501 lines; at most 500"])


class Names(unittest.TestCase):
    def found(self, files):
        return with_files(files, check_names.check)[0]

    def test_one_name_in_two_commands_is_found(self):
        body = "namespace swirl::apps {\n\nstruct Attractor {\n    int a;\n};\n\n}  // namespace swirl::apps\n"
        self.assertEqual(self.found({"apps/a/a.hpp": body, "apps/b/b.hpp": body}),
                         ["swirl::apps::Attractor: apps/a/a.hpp:3 and apps/b/b.hpp:3"])

    def test_namespaces_and_unnamed_ones_tell_names_apart(self):
        one = "namespace a {\nnamespace {\nstruct S {};\n}  // namespace\nclass T {\n};\n}  // namespace a\n"
        other = one.replace("namespace a", "namespace b")
        self.assertEqual(self.found({"apps/a.cpp": one, "apps/b.cpp": one.replace("class T", "class U")}), [])
        self.assertEqual(self.found({"apps/a.cpp": one, "apps/b.cpp": other}), [])

    def test_declarations_and_members_are_no_definitions(self):
        text = "namespace a {\nstruct S;\nstruct T::Inner {\n};\n}  // namespace a\n"
        self.assertEqual(self.found({"apps/a.cpp": text, "apps/b.cpp": text}), [])

    def test_templates_and_enumerations_are_types(self):
        for kind in ("template <class T>\nstruct S {\n", "enum class S { a, b };\n", "class S final : public T {\n"):
            text = f"namespace a {{\n{kind}}};\n}}  // namespace a\n"
            self.assertEqual(len(self.found({"map/a.hpp": text, "apps/b.hpp": text})), 1, kind)

    def test_programs_of_two_test_folders_do_not_meet(self):
        text = "namespace a {\nstruct S {\n};\n}  // namespace a\n"
        self.assertEqual(self.found({"tests/map/a.cpp": text, "tests/apps/b.cpp": text}), [])
        self.assertEqual(len(self.found({"tests/map/a.cpp": text, "tests/map/b.cpp": text})), 1)
        self.assertEqual(len(self.found({"tests/map/a.cpp": text, "map/b.hpp": text})), 1)


class Standard(unittest.TestCase):
    def test_headers_of_own_names_and_of_ones_own_header_suffice(self):
        code, text = printed(check_standard.main, {
            "map/a.hpp": "#pragma once\n\n#include <vector>\n\nstd::vector<int> f();  // no std::map\n",
            "map/a.cpp": '#include "map/a.hpp"\n\n#include <cmath>\n\nstd::vector<int> f() { return {int(std::floor(2.5))}; }\n'})
        self.assertEqual((code, text), (0, "2 files include the standard headers of what they use\n"))

    def test_what_comes_by_another_header_is_missing(self):
        files = {"map/a.hpp": "#include <vector>\n", "map/b.cpp": '#include "map/a.hpp"\n\nstd::vector<std::string> g;\n'}
        code, text = printed(check_standard.main, files)
        self.assertEqual((code, text), (1, "map/b.cpp: std::string (<string>), std::vector (<vector>)\n"))

    def test_what_is_missing_is_added_in_its_block(self):
        def mended(root):
            with contextlib.redirect_stdout(io.StringIO()):
                self.assertEqual(check_standard.main(["--mend", str(root)]), 0)
                self.assertEqual(check_standard.main([str(root)]), 0)
            return (root / "tests/b.cpp").read_text(), (root / "tests/c.cpp").read_text()
        first, second = with_files({
            "tests/b.cpp": "#include <gsl/gsl_math.h>\n\n#include <cmath>\n#include <vector>\n\nstd::vector<std::string> g;\n",
            "tests/c.cpp": '#include "map/a.hpp"\n\nstd::string g;\n'}, mended)
        self.assertIn("\n#include <cmath>\n#include <string>\n#include <vector>\n", first)
        self.assertIn('"map/a.hpp"\n\n#include <string>\n\nstd::string g;\n', second)

    def test_a_header_inside_of_a_namespace_is_refused(self):
        text = "#pragma once\n\nnamespace swirl {\n\nnamespace {\n\n}  // namespace\n{}\n}  // namespace swirl\n{}"
        inside = text.replace("{}", "#include <hwy/highway.h>", 1).replace("{}", "")
        self.assertEqual(printed(check_standard.main, {"map/a.hpp": inside}),
                         (1, "map/a.hpp:8: <hwy/highway.h> inside of a namespace\n"))
        below = text.replace("{}", "", 1).replace("{}", "#include <hwy/highway.h>\n")
        self.assertEqual(printed(check_standard.main, {"map/a.hpp": below})[0], 0)

    def test_nothing_to_look_through_is_no_success(self):
        self.assertEqual(printed(check_standard.main, {"docs/a.md": "std::vector\n"})[0], 2)


if __name__ == "__main__":
    unittest.main()
