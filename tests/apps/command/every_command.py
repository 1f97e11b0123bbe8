"""Every command that takes a scene, for what not all of them are extended to: each follows it, or refuses it by name."""

import json

from driving import run, without_progress

#: How a command is asked, beside its scene.
ASKED = {
    "simulate": "--collisions 20", "classify": "--transient 50 --collisions 100",
    "recurrence": "--transient 50 --collisions 100", "spectrum": "--transient 50 --collisions 100",
    "lyapunov": "--transient 50 --collisions 100",
    "orbits": "--max-period 1 --starts 50 --trajectories 1 --collisions 100",
    "describe": "", "tradeoff": "--budget 1", "certify": "--all",
    "bifurcate": "--along beta=0.4:0.5:2 --transient 50 --collisions 100",
    "ramp": "--along beta=0.4:0.5 --duration 50 --transient 50 --windows 4",
    "sweep": "--grid beta=0.4:0.5:2 --runs 1 --transient 50 --collisions 100",
    "boundaries": "--plane alpha=0.39:0.41 --plane beta=0.49:0.51 --max-period 1",
}


class FollowedOrRefused:
    """For a unittest.TestCase."""

    def check_every_command(self, asked, scene_of, refused, mentions, stated):
        """scene_of(name) is a command's scene; those that refuse it mention all these, the others state {key: value} of it."""
        for name, words in asked.items():
            result = run(f"{name} {scene_of(name)} {words} --quiet --json")
            if name in refused:
                self.assertEqual((result.returncode, result.stdout), (2, ""), name)
                lines = without_progress(result.stderr)
                self.assertEqual(len(lines), 1, (name, result.stderr))
                for mention in mentions:
                    self.assertIn(mention, lines[0], name)
            else:
                self.assertIn(result.returncode, (0, 3), (name, result.stderr))
                answer = json.loads(result.stdout)
                scene = answer.get("scene") or answer["settings"]
                self.assertEqual({key: scene[key] for key in stated}, stated, name)
