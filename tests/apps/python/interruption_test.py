"""Ctrl-C ends a call within half a second, and keeps what is finished. [COUNT of interruptions]"""

import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from imported import MODULES, swirl

COUNT = int(sys.argv.pop(1)) if sys.argv[1:2] and sys.argv[1].isdigit() else 0
SCENE = "swirl.Scene(sides=6, alpha=0.3, beta=0.1, mu=0.1, restitution=1)"
#: A call that is late is tried so often again: a busy machine can hold up any, a call that does not listen is late each time.
MORE = 4
#: Each takes minutes.
CALLS = {
    "sweep": "swirl.sweep(sides=6, mu=0.5, restitution=0.95, grid={'alpha': (0.2, 0.6, 50), 'beta': (0.1, 0.9, 50)}, runs=20, output='kept.h5')",
    "simulate": f"swirl.simulate({SCENE}, collisions=10**9, every=10**6, output='kept.h5')",
    "bifurcate": "swirl.bifurcate(sides=6, beta=0.1, mu=0.1, restitution=1, along={'alpha': (0.2, 0.6, 400)}, output='kept.h5')",
    "orbits": f"swirl.orbits({SCENE}, max_period=200)",
    "classify": f"swirl.classify({SCENE}, exhaustive=True, collisions=10**8)",
    "lyapunov": f"swirl.lyapunov({SCENE}, collisions=10**9)",
    "recurrence": f"swirl.recurrence({SCENE}, collisions=400_000, dimension=4, threshold=0.3)",
    "map": f"{SCENE}.map([0.3, 0.2, -0.2, 0.1, 0.5], steps=10**11)",
}
SCRIPT = """
import signal, sys, time
sys.path.insert(0, sys.argv[1])
import swirl
try:
    print("begun", flush=True)
    {call}
    print("over")
except KeyboardInterrupt as interrupt:
    told = time.time()
    result = getattr(interrupt, "result", None)
    print("interrupted", told, result is not None and bool(result.to_dict() or result.record), flush=True)
"""


def interrupted(call, folder, after):
    """(seconds from the signal to the exception, to the end of the process, whether something was kept)"""
    process = subprocess.Popen([sys.executable, "-B", "-c", SCRIPT.format(call=call), str(MODULES)], cwd=folder, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout.readline() == "begun\n"
    time.sleep(after)
    sent = time.time()
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=60)
    ended = time.time()
    words = output.split()
    assert words[:1] == ["interrupted"], (call, output, errors)
    assert process.returncode == 0, (call, process.returncode, errors)
    return float(words[1]) - sent, ended - sent, words[2] == "True"


class Interruption(unittest.TestCase):
    def test_every_call_ends_within_half_a_second(self):
        for name, call in CALLS.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                told, ended, kept = interrupted(call, folder, 0.8)
                for _ in range(MORE):
                    if told < 0.5 and ended < 2:
                        break
                    for path in Path(folder).iterdir():
                        path.unlink()
                    told, ended, kept = interrupted(call, folder, 0.8)
                self.assertLess(told, 0.5, name)
                self.assertLess(ended, 2, name)  # the interpreter's end, too
                files = {path.name for path in Path(folder).iterdir()}
                if name == "sweep":  # the same call goes on from what it has noted
                    self.assertIn(".kept.h5.journal", files)
                elif "kept.h5" in call:
                    self.assertTrue(kept, name)
                    self.assertEqual(files, {"kept.h5"})
                    self.assertIsNotNone(swirl.show(str(Path(folder) / "kept.h5")).to_dict())

    @unittest.skipUnless(COUNT, "by night")
    def test_a_hundred_interruptions(self):
        names = list(CALLS)
        for i in range(COUNT):
            name = names[i % len(names)]
            with self.subTest(name, i=i), tempfile.TemporaryDirectory() as folder:
                told, _, _ = interrupted(CALLS[name], folder, 0.02 * (i % 40))
                self.assertLess(told, 0.5, name)

    def test_another_call_follows_an_interrupted_one(self):
        script = ("import signal, sys; sys.path.insert(0, sys.argv[1])\nimport swirl\n"
                  "scene = " + SCENE + "\nsignal.setitimer(signal.ITIMER_REAL, 0.3)\n"
                  "def end(*_): raise TimeoutError\nsignal.signal(signal.SIGALRM, end)\n"
                  "try:\n    swirl.lyapunov(scene, collisions=10**9)\nexcept TimeoutError:\n"
                  "    print(swirl.classify(sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95).period)\n")
        result = subprocess.run([sys.executable, "-B", "-c", script, str(MODULES)], capture_output=True, text=True, timeout=60)
        self.assertEqual(result.stdout.strip(), "8", result.stderr)


if __name__ == "__main__":
    unittest.main()
