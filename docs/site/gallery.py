"""The gallery: a figure of each kind, with the command and the line of Python that make it: gallery.py SWIRL FOLDER

FOLDER gets gallery.md, its figures, and page.html, in which a map runs (`swirl explore`); each figure's kind is printed. gallery.py --check MODULES FOLDER runs the lines of
Python of a FOLDER that was made, with the module `swirl` of the folder MODULES, and exits 1 if a figure is another one."""

import argparse
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
HEXAGON = "--sides 6 --mu 0.5 --restitution 0.95"
EIGHT = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"
CHAOS = "--sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1"
LANDING = "simulate --sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9 --time 40 --sample 0.1"
FILM = "simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.2 --restitution 0.7 --time 200 --camera 20 --noise 0.002 --seed 3"
#: Headings, and below each of them figures: its name, the record's command, what `plot` is given, and what it shows.
FIGURES = {
    "An orbit": (
        ("orbit", f"simulate {EIGHT} --collisions 400", "", "A hexagon that comes to turn in a cycle of eight impacts: S(t), and the path of its centre"),
        ("spin", f"simulate {CHAOS} --collisions 400", "--kind spin", "S(t) of a chaotic hexagon with its running mean"),
        ("path", f"simulate {STEADY} --collisions 60", "--kind path", "The path of the centre in the laboratory, in the dish, and co-rotating with the swirl"),
        ("section", f"simulate {CHAOS} --collisions 4000", "--kind section --x psi --y S", "The section of a chaotic orbit, just after each impact"),
        ("balance", f"simulate {STEADY} --collisions 60", "--kind balance", "What restitution and friction take of J at each impact"),
        ("energy", f"simulate {EIGHT} --collisions 200", "--kind energy", "The body's energy over time"),
        ("contacts", LANDING, "--kind contacts", "A disk that comes to roll on the wall: normal force, friction and slip"),
    ),
    "A verdict": (
        ("verdict", f"classify {EIGHT}", "", "A mode and its evidence: the section, S and its spectrum"),
        ("shares", f"classify {EIGHT} --runs 16", "--kind shares", "Modes that coexist, by the share of random starts"),
        ("recurrence", f"recurrence {CHAOS} --collisions 2000 --image 300", "", "The recurrence plot of S"),
        ("spectrum", f"spectrum {EIGHT}", "", "The power spectrum of S(t), with its peaks named"),
        ("lyapunov", f"lyapunov {CHAOS} --collisions 20000", "", "The Lyapunov spectrum, and how it converges"),
    ),
    "Cycles, branches and curves": (
        ("multipliers", f"orbits {STEADY} --period 1", "", "Every fixed point's multipliers"),
        ("steady-modes", f"describe {STEADY}", "", "Steady modes in closed form"),
        ("branch", f"continue {STEADY} --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along alpha=0.3:0.5", "", "The branch of one of them, with its special points"),
        ("diagram", f"bifurcate {HEXAGON} --beta 0.5 --along alpha=0.1:0.9:200 --branches", "", "What random starts settle on over α, and the branches beneath"),
        ("ramp", "ramp --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --along beta=0.374:0.384 --rate 2e-7 --down --branches", "",
         "A hysteresis loop: S while β rises past the fold of a cycle of two, and falls past the flip of the steady mode"),
        ("curves", f"boundaries {HEXAGON} --plane alpha=0.4:0.6 --plane beta=0.25:0.5 --max-period 2", "", "Curves on which cycles appear, end or change their stability"),
        ("cells", f"certify {HEXAGON} --plane alpha=0.55:0.7 --plane beta=0.6:0.8 --max-time 6 --resolution 0.03125", "",
         "Cells on which the number of fixed points is proven"),
        ("sets", "certify --sides disk --alpha 0.3 --beta 0.5 --mu 0 --restitution 1 --near=3.1415927,-0.144,0.048,0 --chaos", "",
         "Sets that the map carries over one another: a proof of chaos"),
    ),
    "Maps": (
        ("modes", f"sweep {HEXAGON} --grid alpha=0.1:0.9:33 --grid beta=0.05:1.05:21 --runs 2", "", "Modes over two parameters"),
        ("means", f"sweep {HEXAGON} --grid alpha=0.2:0.6:17 --grid beta=0.1,0.5,0.9 --runs 4", "--kind means", "⟨S⟩ over α for three swirls"),
        ("exponents", f"sweep {HEXAGON} --grid alpha=0.2:0.6:17 --grid beta=0.1:0.9:13", "--kind map --of exponent", "The largest Lyapunov exponent over two parameters"),
        ("basins", f"sweep {EIGHT} --grid vx=-1:1:61 --grid vy=-1:1:61", "", "Which attractor each start comes to"),
        ("attractors", f"sweep {HEXAGON} --alpha 0.5 --grid beta=0.5:0.54:9 --runs 8 --track", "--kind attractors", "Attractors followed over β: share and mean S"),
    ),
    "Measurements, and what a result costs": (
        ("fit", "fit --series film.csv --marks x y mark_x mark_y --sides 6 --alpha 0.4 --beta 0.5", "--kind fit", "e and μ from a film: their profiles, and what single impacts ask for"),
        ("arcs", "fit --series film.csv --marks x y mark_x mark_y --sides 6 --alpha 0.4 --beta 0.5", "--kind arcs", "Frames and the arcs through them, and S beside that of the scene found"),
        ("tradeoff", f"tradeoff {CHAOS} --budget 3", "", "What accuracy, evidence and model cost on a scene"),
        ("tour", "tour", "", "Modes of a built-in set of scenes"),
    ),
}
#: Of the page in which a map runs: the record's command.
PAGE = f"sweep {HEXAGON} --grid alpha=0.1:0.9:33 --grid beta=0.05:1.05:21"
#: Measured times differ from run to run.
TIMED = {"tradeoff"}


def figures():
    return [figure for group in FIGURES.values() for figure in group]


def value_of(text):
    """A word of the shell as Python has it: a number where it reads back as itself."""
    for kind in (int, float):
        try:
            if repr(kind(text)) == text:
                return text
        except ValueError:
            pass
    return json.dumps(text, ensure_ascii=False)


def range_of(text):
    """`0.1:0.9:9` as a tuple, `0.1,0.5` as a list."""
    ends = ("(", ")", ":") if ":" in text else ("[", "]", ",")
    return ends[0] + ", ".join(value_of(part) for part in text.split(ends[2])) + ends[1]


def python_of(command):
    """`simulate --sides 6 --time 4` as `swirl.simulate(sides=6, time=4)`."""
    name, *words = shlex.split(command)
    what, keywords, ranges = [], [], {}
    while words:
        flag, equals, value = words.pop(0).partition("=")
        if not flag.startswith("--"):
            what.append(json.dumps(flag))
            continue
        key = flag[2:].replace("-", "_")
        values = [value] if equals else []
        while not equals and words and not words[0].startswith("--"):
            values.append(words.pop(0))
        if key in ("grid", "plane", "along"):
            parameter, _, over = values[0].partition("=")
            ranges.setdefault(key, []).append(f'"{parameter}": {range_of(over)}')
        elif key == "from":
            keywords.append(f"from_=({values[0].replace(',', ', ')})")
        elif len(values) > 1:
            keywords.append(f"{key}=[{', '.join(map(value_of, values))}]")
        else:
            keywords.append(f"{key}={value_of(values[0]) if values else True}")
    keywords += [f"{key}={{{', '.join(parts)}}}" for key, parts in ranges.items()]
    return f"swirl.{name + '_' * (name == 'continue')}({', '.join(what + keywords)})"


def plot_of(look):
    """What is given to `Result.plot`."""
    words = shlex.split(look)
    given = {words[i].lstrip("-").replace("-", "_"): words[i + 1] for i in range(0, len(words), 2)}
    kind = given.pop("kind", None)
    return ", ".join(([json.dumps(kind)] if kind else []) + [f"{key}={value_of(value)}" for key, value in given.items()])


def text_of(name, command, look, words):
    record = f"swirl {command} -o {name}.h5\nswirl plot {name}.h5 -o {name}.png" + (f" {look}" if look else "")
    python = f"{python_of(command)}.plot({plot_of(look)})"
    return f"![{words}]({name}.png)\n\n{words}.\n\n```sh\n{record}\n```\n\n```python\n{python}\n```\n"


def page_of():
    text = ("# Gallery\n\nA figure of each kind, with the command that makes it, and the same in Python after `import swirl`. "
            "`swirl plot --help` says what else each can show; [the page in which the map runs](page.html) is `swirl explore`'s.\n\n"
            f"```sh\nswirl {PAGE} -o page.h5\nswirl explore page.h5 -o page.html\n```\n")
    for heading, group in FIGURES.items():
        text += f"\n## {heading}\n\n"
        if any("film.csv" in command for _, command, *_ in group):
            text += f"The film is what a tracker would write of an orbit:\n\n```sh\nswirl {FILM} -o film.csv\n```\n\n"
        text += "\n".join(text_of(*figure) for figure in group)
    return text


def make(swirl, folder):
    folder.mkdir(parents=True, exist_ok=True)

    def run(line):
        result = subprocess.run([swirl, *shlex.split(line), "--quiet"], cwd=folder, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            sys.exit(f"gallery: swirl {line}: exit code {result.returncode}: {result.stderr.strip()}")
        return result.stdout

    run(f"{FILM} -o film.csv --force")
    for name, command, look, _ in figures():
        run(f"{command} -o {name}.h5 --force")
        drawn = run(f"plot {name}.h5 -o {name}.png --force --json {look}")
        print(f"{name}: {json.loads(drawn)['kind']}", flush=True)
    run(f"{PAGE} -o page.h5 --force")
    run("explore page.h5 -o page.html --force")
    (folder / "gallery.md").write_text(page_of(), encoding="utf-8")


def check(modules, folder):
    """The figures that the lines of Python make, beside those of the commands, byte by byte."""
    sys.path.insert(0, str(modules.resolve()))
    import swirl
    lines = re.findall(r"```python\n(.*)\n```", (folder / "gallery.md").read_text(encoding="utf-8"))
    os.chdir(folder)
    wrong = []
    for (name, *_), line in zip(figures(), lines, strict=True):
        figure = eval(line, {"swirl": swirl})  # the text above, of no other origin
        from swirl_figures import save  # which is found since the first figure
        drawn = folder / f"{name}-by-python.png"
        save(figure, drawn)
        same = name in TIMED or drawn.read_bytes() == (folder / f"{name}.png").read_bytes()
        drawn.unlink()
        print(f"{name}: {'the same' if same else 'differs'}", flush=True)
        if not same:
            wrong.append(name)
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--check", type=Path, metavar="MODULES")
    parser.add_argument("swirl", nargs="?")
    parser.add_argument("folder", type=Path)
    arguments = parser.parse_args()
    if arguments.check:
        return check(arguments.check, arguments.folder.resolve())
    make(str(Path(arguments.swirl).resolve()), arguments.folder.resolve())
    return 0


if __name__ == "__main__":
    sys.exit(main())
