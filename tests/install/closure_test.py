"""packages.txt suffices: closure_test.py ROOT BUILD [CLASS]

Whatever Python imports, tests and commands start, the compiler reads and the linker takes lies in the packages that apt
would install for packages.txt on a system with nothing in it: what this system has besides can't help."""

import re
import shutil
import sys
import unittest
from pathlib import Path

import needs
import package_closure as packages

ROOT, BUILD = (Path(path).resolve() for path in (sys.argv.pop(1), sys.argv.pop(1)))


def outside(uses, present, owned):
    """One line for each use whose file is in no package that is present."""
    lines = []
    for what, path, user in uses:
        package = path and packages.owner(path, owned)
        if package not in present:
            lines.append(f"{what}, of {user}: " + (f"in {package}" if package else f"{path}, of no package" if path else "not found"))
    return lines


def why_not():
    """Why nothing can be said here, or None."""
    missing = [name for name in ("apt-get", "apt-cache", "dpkg-query") if not shutil.which(name)]
    if missing:
        return f"no {missing[0]} here: what packages.txt brings is not known"
    if not packages.with_candidate(["cmake"]):
        return "apt has no lists of packages here (apt-get update): what packages.txt brings is not known"
    return None


WHY_NOT = why_not()


@unittest.skipIf(WHY_NOT, WHY_NOT)
class Closure(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        asked = packages.listed(ROOT / "packages.txt")
        optional = [name for name, may_be_missing in asked if may_be_missing]
        there = set(packages.with_candidate(optional))
        cls.names = [name for name, may_be_missing in asked if not may_be_missing or name in there]
        cls.owned = packages.owners()
        cls.uses = [*needs.modules(ROOT), *needs.kernels(ROOT), *needs.programs(ROOT), *needs.programs_of_quickstart(ROOT),
                    *needs.programs_of_cmake(ROOT, BUILD), *needs.libraries(BUILD), *needs.headers(BUILD)]

    def test_what_is_used_is_in_the_packages_of_the_list(self):
        present = packages.closure(self.names)
        kinds = {kind: sum(what.startswith(kind) for what, _, _ in self.uses)
                 for kind in ("module", "kernel", "program", "library", "CMake's file", "header")}
        print(f"{len(self.names)} packages bring {len(present)}; used are", ", ".join(f"{n} of {kind}" for kind, n in kinds.items()))
        self.assertGreater(min(kinds.values()), 0, kinds)
        found = outside(self.uses, present, self.owned)
        self.assertEqual(found, [], "\n" + "\n".join(found) + "\nare in no package that packages.txt brings")


class TakenOut(Closure):
    """By night: apt takes seconds to choose for a list."""
    test_what_is_used_is_in_the_packages_of_the_list = None

    def test_what_a_package_taken_out_had_brought_is_named(self):
        gone = {"libgmock-dev": "library libgmock.a", "python3-ipykernel": "kernel python3", "python3-nbclient": "module nbclient",
                "python3-nbformat": "module nbformat", "python3-h5netcdf": "module h5netcdf", "ninja-build": "program ninja",
                "libcli11-dev": "header CLI/App.hpp"}
        found = "\n".join(outside(self.uses, packages.closure([name for name in self.names if name not in gone]), self.owned))
        for name, what in gone.items():
            self.assertRegex(found, rf"(?m)^{re.escape(what)}, of .*: in {name}$")


if __name__ == "__main__":
    unittest.main()
