#!/usr/bin/env python3
"""Compiles the map to WebAssembly for the page of `swirl explore`: build_map.py FOLDER

Writes FOLDER/swirl_map.wasm, by Debian's emscripten (3.1.6 in Debian 12). The map's sources are compiled as they stand,
but for four headers, of which altered copies are written to FOLDER: the tables of rotations are worked out in 64 bits,
which WebAssembly's long double has not (rounded_to_64.hpp), the list of maps keeps those in double alone, and what the
C++ library there lacks is gone round.

build_map.py FOLDER --ship also writes the artefact beside this script: swirl_map.wasm.base64, and its checksum.
"""

import base64
import hashlib
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
ARTEFACT = HERE / "swirl_map.wasm.base64"
CHECKSUM = HERE / "swirl_map.sha256"

SOURCES = ("map/maps_in_double.cpp", "map/orbit/return_map_in_double.cpp", "map/orbit/trajectory_segment.cpp",
           "map/contact/chatter_completion.cpp", "map/contact/contact_phase.cpp", "map/contact/contact_run.cpp",
           "map/contact/contact_series.cpp", "map/contact/contact_state.cpp", "map/contact/contact_watch.cpp",
           "map/contact/motion_choice.cpp", "map/contact/reaction.cpp", "map/contact/rim_pendulum.cpp",
           "map/contact/strike.cpp", "apps/explore/page/map_for_page.cpp", "apps/explore/page/cube_root.cpp")
FLAGS = ("-std=c++20", "-O3", "-ffp-contract=off", "-fno-slp-vectorize", "-DNDEBUG", "-ffile-prefix-map=" + str(ROOT) + "=.")
EXPORTS = ("exchange", "scene", "start", "run", "outcome", "way", "moments")
LINK = ("-O3", "--no-entry", "-sSTANDALONE_WASM", "-sTOTAL_STACK=1048576", "-sINITIAL_MEMORY=4194304",
        "-sALLOW_MEMORY_GROWTH",
        "-sEXPORTED_FUNCTIONS=" + ",".join("_swirl_" + name for name in EXPORTS))


def altered(name, *replacements):
    text = (ROOT / name).read_text(encoding="utf-8")
    for pattern, replacement in replacements:
        text, count = re.subn(pattern, replacement, text, flags=re.MULTILINE)
        if not count:
            sys.exit(f"build_map.py: {name} has nothing like {pattern}")
    return text


def write_headers(folder):
    """The altered copies, which the compiler finds before the originals."""
    headers = {
        "map/numbers/turn.hpp": altered(
            "map/numbers/turn.hpp", ("long double", "RoundedTo64"),
            (r'^#include "map/numbers/vec2.hpp"$', r'\g<0>\n#include "apps/explore/page/rounded_to_64.hpp"'),
            # Of the vertices' table, which the page does not work out but is given.
            (r"^/// cis δ − 1 for", "constexpr TabledVector tabled(const Vec2<long double>& v) {\n"
                                    "    return tabled(Vec2<RoundedTo64>{v.x, v.y});\n}\n\n\\g<0>")),
        "map/numbers/turn_table.hpp": altered("map/numbers/turn_table.hpp", ("long double", "RoundedTo64"),
                                              ("std::bit_cast<std::uint64_t>", r"__builtin_bit_cast(std::uint64_t, "),
                                              (r"\(shifted\)", "shifted)")),
        # The messages of numbers that are refused, which nobody sees there: its libc++ writes no doubles.
        "map/numbers/real.hpp": altered("map/numbers/real.hpp", (r"std::to_chars\([^)]*\)\.ptr", "digits")),
        "map/map_list.hpp": altered("map/map_list.hpp", (r"^ *DO\(long double\) *\\\n", ""), (r"\\\n *DO\(Quad\)$", "")),
    }
    for name, text in headers.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")


def build(folder):
    """@return the module's bytes"""
    folder.mkdir(parents=True, exist_ok=True)
    write_headers(folder / "headers")
    libraries = folder / "libraries"  # these alone: /usr/include has the C library of another machine
    libraries.mkdir(exist_ok=True)
    for name, place in (("boost", "boost"), ("ceres", "ceres"), ("Eigen", "eigen3/Eigen")):
        if not (libraries / name).exists():
            (libraries / name).symlink_to(Path("/usr/include") / place)
    environment = dict(os.environ, EMSDK_PYTHON="/usr/bin/python3")

    def compile_one(name):
        target = folder / (name.replace("/", "+") + ".o")
        subprocess.run(["em++", *FLAGS, "-I", str(folder / "headers"), "-I", str(ROOT), "-I", str(libraries), "-c",
                        str(ROOT / name), "-o", str(target)], check=True, env=environment)
        return str(target)

    with ThreadPoolExecutor(int(os.environ.get("SWIRL_JOBS", "2"))) as pool:
        objects = list(pool.map(compile_one, SOURCES))
    module = folder / "swirl_map.wasm"
    subprocess.run(["em++", *LINK, *objects, "-o", str(module)], check=True, env=environment)
    return module.read_bytes()


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[1:] not in ([], ["--ship"]):
        sys.exit("usage: build_map.py FOLDER [--ship]")
    module = build(Path(arguments[0]).resolve())
    checksum = hashlib.sha256(module).hexdigest()
    print(f"{len(module)} bytes, sha256 {checksum}")
    if arguments[1:]:
        text = base64.b64encode(module).decode("ascii")
        ARTEFACT.write_text("\n".join(text[i:i + 120] for i in range(0, len(text), 120)) + "\n", encoding="ascii")
        CHECKSUM.write_text(f"{checksum}  swirl_map.wasm\n", encoding="ascii")


if __name__ == "__main__":
    main(sys.argv[1:])
