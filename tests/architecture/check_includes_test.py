"""check_includes.py on tiny made-up trees: it must pass what is allowed and find each thing that is not."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import check_includes

SOUND = {
    "map/flight.hpp": '#include <cmath>\n#include <Eigen/Core>\n',
    "map/numbers/jets.hpp": '#include <ceres/jet.h>\n',
    "map/map.hpp": '#include "map/flight.hpp"\n',
    "analysis/orbits.hpp": '#include <gsl/gsl_errno.h>\n#include <tbb/parallel_for.h>\n#include <fftw3.h>\n',
    "apps/studies/verdict.hpp": '#include "analysis/orbits.hpp"\n#include "map/map.hpp"\n#include <fmt/format.h>\n',
    "apps/main.cpp": '#include "apps/studies/verdict.hpp"\n#include "map/map.hpp"\n#include <hdf5.h>\n',
}


def check_tree(changes):
    """The violations in the sound tree with some files replaced or added."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in {**SOUND, **changes}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return check_includes.check(root)


class CheckIncludes(unittest.TestCase):
    def assert_found(self, file, line, text, named):
        found = check_tree({file: text})
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(f"{file}:{line}: "), found)
        self.assertIn(named, found[0])

    def test_sound_tree_passes(self):
        self.assertEqual(check_tree({}), [])

    def test_map_includes_analysis(self):
        self.assert_found("map/bad.hpp", 2, '#include <cmath>\n#include "analysis/orbits.hpp"\n', "analysis/orbits.hpp")

    def test_map_includes_apps(self):
        self.assert_found("map/bad.cpp", 1, '#include "apps/record.hpp"\n', "apps/record.hpp")

    def test_analysis_includes_map(self):
        self.assert_found("analysis/deep/bad.hpp", 1, '#  include "map/map.hpp"\n', "map/map.hpp")

    def test_analysis_includes_apps(self):
        self.assert_found("analysis/bad.hpp", 1, '#include "apps/record.hpp"\n', "apps/record.hpp")

    def test_studies_include_the_shell(self):
        self.assert_found("apps/studies/bad.hpp", 1, '#include "apps/record.hpp"\n', "map, analysis and itself")
        self.assert_found("apps/studies/deep/bad.cpp", 1, "#include <CLI/CLI.hpp>\n", "CLI/CLI.hpp")

    def test_a_command_joins_map_and_analysis(self):
        both = '#include "map/map.hpp"\n#include "analysis/orbits.hpp"\n'
        self.assert_found("apps/deep/bad.cpp", 2, both, "joined in apps/studies/")
        self.assertEqual(check_tree({"apps/studies/deep/good.cpp": both}), [])

    def test_nobody_includes_tests(self):
        self.assert_found("apps/bad.cpp", 1, '#include "tests/sample_count.hpp"\n', "tests/sample_count.hpp")

    def test_numerics_include_an_outer_library(self):
        self.assert_found("map/bad.hpp", 1, "#include <hdf5.h>\n", "hdf5.h")
        self.assert_found("map/bad.hpp", 1, "#include <ceres/solver.h>\n", "ceres/solver.h")
        self.assert_found("analysis/bad.hpp", 1, "#include <CLI/CLI.hpp>\n", "CLI/CLI.hpp")

    def test_a_number_type_comes_without_its_traits(self):
        self.assert_found("map/bad.hpp", 1, "#include <ceres/jet.h>\n", "map/numbers/jets.hpp")
        self.assert_found("apps/bad.cpp", 1, "#include <boost/multiprecision/float128.hpp>\n", "map/numbers/quad.hpp")
        self.assertEqual(check_tree({"analysis/fit.cpp": "#include <ceres/jet.h>\n"}), [])  # knows no such traits

    def test_a_name_comes_with_the_header_that_declares_it_in_every_release(self):
        text = "#include <fmt/format.h>\n{}std::string text = fmt::join(names, \", \");\n"
        self.assert_found("apps/bad.cpp", 0, text.format(""), "fmt/ranges.h")
        self.assertEqual(check_tree({"apps/good.cpp": text.format("#include <fmt/ranges.h>\n")}), [])

    def test_own_header_in_angle_brackets(self):
        self.assert_found("analysis/bad.hpp", 1, "#include <map/map.hpp>\n", "in quotes")

    def test_path_not_from_the_root(self):
        self.assert_found("map/bad.hpp", 1, '#include "flight.hpp"\n', "not a path from the root")
        self.assert_found("analysis/bad.hpp", 1, '#include "../map/map.hpp"\n', "not a path from the root")

    def test_missing_header(self):
        self.assert_found("map/bad.hpp", 1, '#include "map/nowhere.hpp"\n', "no such file")

    def test_circle(self):
        self.assert_found("map/flight.hpp", 0, '#include "map/map.hpp"\n', "map/map.hpp -> map/flight.hpp")

    def test_nothing_to_check_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(check_includes.main([folder]), 2)


if __name__ == "__main__":
    unittest.main()
