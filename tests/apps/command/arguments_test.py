"""Arguments that are easily taken for others: each is refused in one line, and nothing is written.
arguments_test.py SWIRL"""

import os
import resource
import unittest

from driving import InFolder, document, run
from impact_tables import impacts, table

SCENE = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
POINT = "-0.0829,0.028,-0.5552,0.8908,-0.9783"

#: A command that runs, and its options with a number: (option, whether it is a whole one).
NUMBERS = {
    f"simulate {SCENE}": ["--collisions", "--time", "--skip", "--every", "--sample", "--threads", "--x", "--y", "--vx",
                          "--vy", "--angle", "--spin", "--speed", "--seed", "--camera", "--noise", "--lose", "--pixels",
                          "--noise-restitution", "--noise-mu", "--noise-wall"],
    f"classify {SCENE}": ["--transient", "--collisions", "--threshold", "--max-period", "--runs", "--risk", "--error"],
    "classify --series m.csv": ["--noise"],
    f"recurrence {SCENE}": ["--threshold", "--threshold-std", "--recurrence-rate", "--dimension", "--delay", "--image",
                            "--theiler", "--min-diagonal", "--min-vertical", "--transient", "--collisions",
                            "--sample-pairs", "--sample-seed"],
    "recurrence --series m.csv --threshold 0.1": ["--period", "--resample", "--spacing", "--fps", "--scale",
                                                      "--likelihood", "--header-line"],
    f"spectrum {SCENE}": ["--bins", "--segments", "--overlap"],
    "spectrum --series m.csv": ["--resample"],
    f"lyapunov {SCENE}": ["--transient", "--collisions"],
    "fit --impacts i.csv": ["--inertia", "--resamples", "--seed"],
    f"orbits {SCENE}": ["--period", "--max-period", "--starts", "--trajectories", "--collisions"],
    f"continue {SCENE} --from={POINT} --along beta=0.4:0.6": ["--period", "--switch", "--longest-step"],
    f"bifurcate {SCENE} --along beta=0.4:0.6:2": ["--starts", "--transient", "--collisions", "--longest-branch", "--risk", "--error"],
    f"ramp {SCENE} --along beta=0.4:0.5 --duration 100": ["--duration", "--cycles", "--windows", "--samples", "--transient",
                                                         "--longest-period", "--tolerance"],
    f"boundaries {SCENE} --plane alpha=0.4:0.5 --plane beta=0.4:0.5": ["--max-period", "--lines", "--longest-step"],
    f"sweep {SCENE} --grid mu=0.1:0.2:2": ["--runs", "--transient", "--collisions", "--threshold", "--risk", "--error"],
    f"tradeoff {SCENE}": ["--budget"],
    f"describe {SCENE}": ["--max-time", "--alpha", "--beta", "--mu", "--restitution", "--inertia-factor"],
}


def seconds_of_commands():
    """Of a processor, which other work beside them does not change."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Arguments(InFolder):
    def setUp(self):
        super().setUp()
        self.series("m.csv", [0.1 * (i % 7) for i in range(100)])
        self.file("i.csv", table(impacts(20, noise=0.01)))
        self.before = sorted(self.folder.iterdir())

    def refused(self, arguments, *mentions):
        result = run(arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1),
                         (arguments, result.stderr))
        self.assertLess(len(result.stderr), 400, arguments)
        for mention in mentions:
            self.assertIn(mention, result.stderr, arguments)
        self.assertEqual(sorted(self.folder.iterdir()), self.before, arguments)

    def test_the_name_of_another_command(self):
        self.refused(f"simulate {SCENE} classify --collisions 64", "classify")
        self.refused(f"simulate {SCENE} classify", "classify")
        self.refused(f"describe tour {SCENE}", "tour")

    def test_a_misspelt_name_is_told_the_nearest(self):
        for wrong, right in (("simulat", "simulate"), ("calssify", "classify"), ("lyapunow", "lyapunov"), ("sim", "simulate"),
                             ("bifurcation", "bifurcate"), ("boundary", "boundaries"), ("recurrences", "recurrence")):
            self.refused(wrong, f"no command {wrong}; did you mean {right}?")
        for wrong, right in (("--sidez 6", "--sides"), ("--restituton=0.9", "--restitution"), ("--colisions 3", "--collisions"),
                             ("--time=3 --acuracy quad", "--accuracy")):
            self.refused(f"simulate {wrong}", f"swirl simulate has no flag {wrong.split()[-2 if ' ' in wrong else 0].split('=')[0]}",
                         f"did you mean {right}?")
        self.refused("--versoin", "swirl has no flag --versoin; did you mean --version?")
        self.assertNotIn("did you mean", run("xyz", cwd=self.folder).stderr)
        self.assertNotIn("did you mean", run("simulate --qqqq", cwd=self.folder).stderr)
        self.assertEqual(run("describe --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9").returncode, 0)
        self.refused(f"simulate {SCENE.replace('--mu 0.5', '--mu -1')}", "mu = -1")  # a negative number is no flag

    def test_what_is_no_whole_number_is_said_to_be_none(self):
        self.refused(f"recurrence {SCENE} --image 10.5 --json", "Value 10.5 is no whole number: 1 to 20000 are allowed")
        self.refused(f"recurrence {SCENE} --image 0 --json", "Value 0 not in range 1 to 20000")
        self.refused(f"recurrence {SCENE} --image 99999999999999999999 --json", "not in range 1 to 20000")

    def test_an_option_without_its_value(self):
        self.refused(f"classify {SCENE} --output= --json", "--output=")
        self.refused(f"classify {SCENE} -o --json", "-o", "--json")
        self.refused(f"classify {SCENE} --output --json", "--output", "--json")
        self.refused(f"simulate --scene --json {SCENE}", "--scene")
        self.refused(f"simulate {SCENE} --json=", "--json=")
        self.refused(f"simulate {SCENE} --collisions --time 3", "--collisions")

    def test_an_empty_value(self):
        for flags in ("--series", f"{SCENE} --scene", f"{SCENE} --point", f"{SCENE} --speed", f"{SCENE} -o",
                      f"{SCENE} --accuracy", "--series m.csv --column", "--series m.csv --rows"):
            words = ["classify", *flags.split(), ""]
            self.refused(words, words[-2])
        self.refused(["classify", ""], "''")

    def test_no_number_is_read_as_octal(self):
        ten = document(f"simulate {SCENE} --collisions 10 --threads 010")
        self.assertEqual(document(f"simulate {SCENE} --collisions 010"), ten)
        self.assertEqual(document(f"simulate {SCENE} --collisions +0000000000010"), ten)
        self.assertEqual(len(ten["collisions"]), 10)
        for text in ("0x10", "1e-1", "10.0", "1.5e0", "1e+-1", "1e", "e1", "1e19", "1'000", "10 ", "+-10", "9223372036854775808", "--10"):
            self.refused(["simulate", *SCENE.split(), f"--collisions={text}"], "collisions", text.strip())

    def test_a_whole_number_may_have_an_exponent(self):
        ten = document(f"simulate {SCENE} --collisions 10")
        for text in ("1e1", "1E+1", "0.1e2", "100e-1"):
            self.assertEqual(document(f"simulate {SCENE} --collisions {text}"), ten)

    def test_what_underflows_is_not_read_as_zero(self):
        """1e-400 has no double but 0, and half of the smallest one, 2^-1074 = 4.9e-324, none but 0 either."""
        without = SCENE.replace("--mu 0.5", "")
        for text in ("1e-400", "-2e-324", "0.00001e-330"):
            self.refused(f"classify {without} --mu={text}", "mu", text, "1e-75")
            self.refused(f"classify {SCENE} --x={text}", "x", text)
            self.refused(f"sweep {without} --grid mu={text}:1:3", text)
        self.refused(f"classify {SCENE} --threshold=1e-400", "threshold", "1e-400")
        zero = document(f"describe {without} --mu 0e-400")  # is 0 as it is written
        self.assertEqual(zero["scene"]["mu"], 0)
        for text in ("1e-400", "1_0.0e-400", "-2e-324"):
            scene = self.file("scene.toml", f"[scene]\nsides = 6\nalpha = 0.4\nbeta = 0.5\nmu = {text} # tiny\nrestitution = 0.9\n")
            self.before = sorted(self.folder.iterdir())
            self.refused(f"classify --scene {scene}", "mu", text.replace("_", ""))

    def test_help_of_a_command(self):
        for words, same in (("help classify", "classify --help"), ("help", "--help")):
            self.assertEqual((run(words).returncode, run(words).stdout), (0, run(same).stdout))
        self.refused("help clasify", "did you mean classify?")
        self.refused("help classify sweep", "one command")

    def test_a_record_is_no_figure(self):
        for suffix, command in (("png", "plot"), ("mp4", "animate"), ("ipynb", "notebook"), ("html", "explore")):
            for line in (f"simulate {SCENE}", f"sweep {SCENE} --grid mu=0.1:0.2:2", f"bifurcate {SCENE} --along beta=0.4:0.6:2"):
                self.refused(f"{line} -o map.{suffix}", f"map.{suffix}", f"swirl {command} FILE.h5")

    def test_a_record_is_no_table_and_a_film_no_record(self):
        self.refused(f"simulate {SCENE} -o x.csv", "output 'x.csv'", "give -o FILE.h5, then swirl show FILE.h5 --csv x.csv")
        self.refused(f"simulate {SCENE} -o x.CSV", "output 'x.CSV'", "give -o FILE.h5, then swirl show FILE.h5 --csv x.CSV")
        self.refused(f"simulate {SCENE} --camera 5 -o x.H5", "output 'x.H5'", "give -o FILE.csv")
        self.refused(f"simulate {SCENE} --camera 5 -o o.h5", "output 'o.h5'", "give -o FILE.csv")

    def test_what_a_flag_is_not_of(self):
        for flags in ("", "--observable S", "--observable spin"):
            self.refused(f"spectrum {SCENE} {flags} --frame container", "frame = 'container' is of positions", "S has none")
        for pin in ("S=1", "tau=2"):
            self.refused(f"orbits {SCENE} --pin {pin}", f"pin = {pin}", "members of families, and this scene has none")

    def test_no_number_is_nan_or_infinite(self):
        for command, options in NUMBERS.items():
            for option in options:
                for value in ("nan", "-inf"):
                    words = command.split()
                    if option in words:  # the scene's own: given once
                        k = words.index(option)
                        del words[k:k + 2]
                    self.refused([*words, f"{option}={value}"], option.strip("-"))

    def test_a_limit_is_short(self):
        for command in ("classify", "sweep --grid mu=0.1:0.2:2"):
            for value in ("-1", "-1e-300"):
                self.refused(f"{command} {SCENE} --threshold={value}", "threshold", value, "0 or more")

    def test_what_never_ends_is_no_input(self):
        os.mkfifo(self.folder / "pipe")
        self.before = sorted(self.folder.iterdir())
        begin = seconds_of_commands()
        for source in ("/dev/zero", "/dev/urandom"):
            self.refused(f"simulate --scene {source}", source)
            self.refused(f"spectrum --series {source}", source)
            self.refused(f"recurrence {source}", source, "regular")
            self.refused(f"classify {source}", source, "regular")
            self.refused(f"plot {source} -o a.png", source, "regular")
        self.refused("recurrence pipe", "pipe", "regular")
        self.refused("plot pipe -o a.png", "pipe", "regular")
        endless = self.folder / "endless"
        endless.write_bytes(b"# not a scene\n" * 80_000)
        self.before = sorted(self.folder.iterdir())
        self.refused("simulate --scene endless", "endless", "1 MiB")
        self.assertLess(seconds_of_commands() - begin, 10)


if __name__ == "__main__":
    unittest.main()
