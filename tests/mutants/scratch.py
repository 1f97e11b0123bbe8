"""A copy of the tree in which one line at a time is changed, and what it takes to see whether a test notices.

Every source of the map, and every test program, is compiled once as it stands. Of a mutant only the sources that include
its file are compiled anew, and only those that a test program links; where the compiler makes the same object of both,
the program can't differ and isn't run.
"""

import hashlib
import json
import os
import re
import resource
import shutil
import signal
import subprocess
from pathlib import Path

COMPILER = os.environ.get("CXX", "g++")
# As cmake/SwirlOptions.cmake and map/CMakeLists.txt have it, but quick to compile. Equal bits: no fused products.
FLAGS = ["-std=gnu++20", "-O1", "-DNDEBUG", "-ffp-contract=off", "-w", "-DSWIRL_HAS_QUADMATH", "-DGFLAGS_IS_A_DLL=0",
         "-DGLOG_CUSTOM_PREFIX_SUPPORT", "-I.", "-isystem", "/usr/include/eigen3"]
LIBRARIES = ["-lgtest_main", "-lgtest", "-lquadmath", "-ltbb", "-lgsl", "-lgslcblas", "-lpthread"]
HEADERS = ["algorithm", "array", "cmath", "complex", "functional", "limits", "map", "memory", "optional", "span", "string",
           "vector", "boost/math/constants/constants.hpp", "ceres/jet.h", "boost/multiprecision/float128.hpp",
           "gtest/gtest.h", "nlohmann/json.hpp"]

COPIED = ("map", "tests/map", "tests/references", "tests/sample_count.hpp")
# Other authors of the same physics, to be compared with it, not seen by its own tests; kernels take minutes to compile.
NOT_OF_THE_MAP = re.compile(r"map/(batch|proof|proof_check|intervals)/")
# Of tests: proofs and kernels as above, what is timed, and what needs analysis/ too.
NOT_A_PROGRAM = re.compile(r"tests/map/(batch/|certainty/|intervals_test|proof_test|all_fixed_points_test|"
                           r"elastic_return_test|elastic_limit_test|baselines/missed_contacts_test)")
BY_JETS = ["tests/map/differentiated_disks.cpp", "tests/map/differentiated_polygons.cpp"]
BESIDE = {  # a test program's other sources
    "derivative_test": BY_JETS,
    "steady_random_test": BY_JETS,
    "random_scenes_test": ["tests/map/follow_contact.cpp"],
    "sustained_contact_test": ["tests/map/follow_contact.cpp"],
    "trajectories_test": ["tests/references/reference_file.cpp"],
    "cycles_test": ["tests/references/reference_file.cpp", *BY_JETS],
    "steady_search_test": ["tests/references/reference_file.cpp"],
}


class DoesNotCompile(Exception):
    pass


class Stopwatch:
    """Processor seconds of the processes that were started and have ended since: other work does not change them."""

    def __init__(self):
        self.began = self._now()

    @staticmethod
    def _now():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    def seconds(self):
        return round(self._now() - self.began, 2)


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else ""


class Scratch:
    """One copy of the tree with its objects: `folder`/tree is compiled, `folder`/base has what the tree gives unchanged."""

    def __init__(self, root, folder, tell=print):
        self.tree, self.base, self.work = folder / "tree", folder / "base", folder / "mutant"
        self.tell = tell
        for path in (self.tree, self.base, self.work):
            path.mkdir(parents=True, exist_ok=True)
        self._copy(root)
        self._precompile()
        self.sources = [name for name in self._sources("map") if not NOT_OF_THE_MAP.match(name)]
        names = [name for name in self._sources("tests/map") if name.endswith("_test.cpp")]
        self.programs = {Path(name).stem: [name, *BESIDE.get(Path(name).stem, [])]
                         for name in names if not NOT_A_PROGRAM.match(name)}
        state = self.base / "state.json"
        self.state = json.loads(state.read_text()) if state.exists() else {"objects": {}, "programs": {}}

    def _copy(self, root):
        """Brings the copy up to date; a file that is the same keeps its time."""
        for part in COPIED:
            shutil.rmtree(self.tree / part, ignore_errors=True)
            (self.tree / part).parent.mkdir(parents=True, exist_ok=True)
            if (root / part).is_dir():
                shutil.copytree(root / part, self.tree / part)
            else:
                shutil.copy2(root / part, self.tree / part)

    def _sources(self, part):
        return sorted(path.relative_to(self.tree).as_posix() for path in (self.tree / part).rglob("*.cpp"))

    def _precompile(self):
        header = self.base / "headers.hpp"
        text = "".join(f"#include <{name}>\n" for name in HEADERS)
        if not header.exists() or header.read_text() != text or not header.with_suffix(".hpp.gch").exists():
            header.write_text(text)
            subprocess.run([COMPILER, *FLAGS, "-x", "c++-header", header], check=True)

    # ---- compiling and linking

    def _object(self, folder, source):
        return folder / (source.replace("/", "-") + ".o")

    def _compile(self, folder, source):
        target = self._object(folder, source)
        command = [COMPILER, *FLAGS, "-include", self.base / "headers.hpp", "-MMD", "-c", source, "-o", target,
                   f"-DSWIRL_REFERENCES=\"{self.tree / 'tests/references'}\""]
        done = subprocess.run(command, cwd=self.tree, capture_output=True, text=True)
        if done.returncode:
            raise DoesNotCompile(f"{source}: {done.stderr[:2000]}")
        return target

    def _link(self, name, objects, target, *extra):
        """Objects of the mutant stand before the archive and so in place of its members."""
        command = [COMPILER, *objects, self.base / "libmap.a", *LIBRARIES, *extra, "-o", target]
        done = subprocess.run([str(word) for word in command], cwd=self.tree, capture_output=True, text=True)
        if done.returncode:
            raise DoesNotCompile(f"{name}: {done.stderr[:2000]}")

    def run(self, name, executable, limit):
        """"" if all passes, else what failed. `limit`: in seconds of the processor."""
        environment = {**os.environ, "GTEST_FAIL_FAST": "1", "GTEST_FILTER": "-*Nightly*"}
        try:
            done = subprocess.run(["prlimit", f"--cpu={limit:.0f}", executable], cwd=self.tree, env=environment,
                                  timeout=60 + 60 * limit, capture_output=True, text=True, errors="replace")
        except subprocess.TimeoutExpired:
            return f"{name}: waits without end"
        if done.returncode == 0:
            return ""
        if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
            return f"{name}: no end after {limit:.0f} s"
        failed = re.search(r"\[  FAILED  \] ([\w/.]+)", done.stdout) or re.search(r"\[ RUN      \] ([\w/.]+)(?!.*RUN)",
                                                                                 done.stdout, re.S)
        return failed[1] if failed else f"{name}: exit {done.returncode}"

    # ---- what is unchanged

    def prepare(self):
        """Compiles and runs everything as it stands; raises if a test fails. What is up to date is kept."""
        fresh = [source for source in self._wanted() if self._is_stale(source)]
        for source in fresh:
            watch = Stopwatch()
            self._compile(self.base, source)
            self.state["objects"][source] = {"seconds": watch.seconds(), **self._read_files(source)}
            self.tell(f"compiled {source}: {self.state['objects'][source]['seconds']} s")
        if fresh:
            (self.base / "libmap.a").unlink(missing_ok=True)
            subprocess.run(["ar", "rcs", self.base / "libmap.a", *(self._object(self.base, s) for s in self.sources)],
                           check=True)
        for name in self.programs:
            self._prepare_program(name, set(fresh))
        self._save()

    def _wanted(self):
        return dict.fromkeys(self.sources + [source for sources in self.programs.values() for source in sources])

    def _read_files(self, source):
        """The files of the tree that a source reads, and what they hold."""
        words = self._object(self.base, source).with_suffix(".d").read_text().replace("\\\n", " ").split()[1:]
        files = [word for word in words if not word.startswith("/")]
        return {"files": {name: digest(self.tree / name) for name in files}}

    def _is_stale(self, source):
        known = self.state["objects"].get(source)
        return (known is None or not self._object(self.base, source).exists()
                or any(digest(self.tree / name) != text for name, text in known["files"].items()))

    def _prepare_program(self, name, fresh):
        known = self.state["programs"].get(name)
        own = self.programs[name]
        if known and known["own"] == own and not fresh & {*own, *known["members"]}:
            return
        executable = self.base / name
        map_file = self.base / "link.map"
        self._link(name, [self._object(self.base, source) for source in own], executable, f"-Wl,-Map={map_file}")
        linked = map_file.read_text(errors="replace")
        members = [source for source in self.sources if f"libmap.a({self._object(self.base, source).name})" in linked]
        watch = Stopwatch()
        failed = self.run(name, executable, 600)
        if failed:
            raise RuntimeError(f"the unchanged {name} fails: {failed}")
        self.state["programs"][name] = {"own": own, "members": members, "seconds": watch.seconds()}
        self.tell(f"{name}: {self.state['programs'][name]['seconds']} s with {len(members)} sources of the map")
        executable.unlink()
        self._save()

    def _save(self):
        (self.base / "state.json").write_text(json.dumps(self.state, indent=1))

    # ---- a mutant

    def affected(self, file):
        """The programs that a file is part of: name -> the sources to compile anew."""
        reads = {source for source, known in self.state["objects"].items() if file in known["files"]}
        found = {name: [source for source in self.programs[name] + self.state["programs"][name]["members"]
                        if source in reads] for name in self.programs}
        return {name: sources for name, sources in found.items() if sources}

    def cost(self, file, name, sources, compiled):
        """Seconds until a program has run; less for one that is near to the file."""
        seconds = self.state["programs"][name]["seconds"] + 0.5
        seconds += sum(self.state["objects"][source]["seconds"] for source in sources if source not in compiled)
        words, own = set(Path(file).stem.split("_")), set(name.split("_"))
        text = (self.tree / self.programs[name][0]).read_text(encoding="utf-8")
        return seconds / ((4 if words & own else 1) * (3 if f'"{file}"' in text else 1))

    def judge(self, mutant):
        """(verdict, by what): "killed", "survived", or "invalid" where it does not compile."""
        path = self.tree / mutant.file
        original = path.read_text(encoding="utf-8")
        lines = original.split("\n")
        assert lines[mutant.line - 1] == mutant.before
        lines[mutant.line - 1] = mutant.after
        try:
            path.write_text("\n".join(lines), encoding="utf-8")
            return self._try_programs(mutant.file)
        except DoesNotCompile as reason:
            return "invalid", str(reason).split("error:")[-1].strip().split("\n")[0]
        finally:
            path.write_text(original, encoding="utf-8")
            shutil.rmtree(self.work)
            self.work.mkdir()

    def _try_programs(self, file):
        left, compiled, ran = self.affected(file), {}, 0
        while left:
            name = min(left, key=lambda one: (self.cost(file, one, left[one], compiled), one))
            sources = left.pop(name)
            for source in sources:
                if source not in compiled:
                    target = self._compile(self.work, source)
                    same = target.read_bytes() == self._object(self.base, source).read_bytes()
                    compiled[source] = None if same else target
            changed = [compiled[source] for source in sources if compiled[source]]
            if not changed:
                continue
            own = [source for source in self.programs[name] if not compiled.get(source)]
            self._link(name, [*changed, *(self._object(self.base, source) for source in own)], self.work / name)
            ran += 1
            failed = self.run(name, self.work / name, 10 + 6 * self.state["programs"][name]["seconds"])
            (self.work / name).unlink()
            if failed:
                return "killed", failed
        return "survived", f"{ran} programs" if ran else "the same machine code"
