"""The collision map on arrays: the impacts of `simulate`, to the bit; its derivative, against differences."""

import threading
import unittest

import numpy as np

from imported import CHAOS, DISK, HEXAGON, PERIOD_8, swirl

COORDINATES = {5: ("psi", "chi", "vn", "vt", "spin"), 4: ("psi", "vn", "vt", "spin")}
POINTS = {HEXAGON: (-0.0839, 0.028, -0.5542, 0.8898, -0.9793), DISK: (0, -0.43056, 0.19151, -0.30504)}


def impacts(scene, point, count):
    found = swirl.simulate(scene, point=point, collisions=count)
    return np.array([[row[name] for name in COORDINATES[scene.dimension]] for row in found.to_dict()["collisions"]])


def states(scene, count, seed=1):
    """States of a chaotic or settling orbit: `count` of them."""
    return impacts_from_seed(scene, count, seed)


def impacts_from_seed(scene, count, seed):
    found = swirl.simulate(scene, seed=seed, collisions=count)
    return np.array([[row[name] for name in COORDINATES[scene.dimension]] for row in found.to_dict()["collisions"]])


class Map(unittest.TestCase):
    def test_k_steps_are_the_kth_impact_to_the_bit(self):
        for scene, point in POINTS.items():
            rows = impacts(scene, point, 60)
            for k in (1, 2, 17, 60):
                self.assertEqual(scene.map(point, steps=k).tobytes(), rows[k - 1].tobytes(), (scene, k))
            self.assertTrue(np.allclose(scene.map(rows[:-1]), rows[1:], rtol=0, atol=1e-11))

    def test_many_rows_give_what_each_gives_alone(self):
        for scene in (CHAOS, HEXAGON, PERIOD_8, DISK, swirl.Scene(5, 0.45, 0.6, 0.3, 0.7, "stronge"),
                      swirl.Scene(3, 0.8, 0.9, 0.5, 0)):
            z = states(scene, 400)
            z = np.vstack([z, z, z])  # more than one task's rows
            for steps in (1, 30):
                image, outcomes = scene.map(z, steps, outcomes=True)
                alone = [scene.map(row, steps, outcomes=True) for row in z[:60]]
                self.assertEqual(image[:60].tobytes(), np.array([one[0] for one in alone]).tobytes())
                self.assertEqual([scene.OUTCOMES[code] for code in outcomes[:60]], [one[1] for one in alone])
                self.assertEqual(scene.map(z, steps, threads=3).tobytes(), image.tobytes())

    def test_shapes(self):
        z = states(HEXAGON, 12)
        self.assertEqual(HEXAGON.map(z).shape, (12, 5))
        self.assertEqual(HEXAGON.map(z[0]).shape, (5,))
        self.assertEqual(HEXAGON.map(z[:0]).shape, (0, 5))
        self.assertEqual(HEXAGON.map(z.tolist()).tobytes(), HEXAGON.map(z).tobytes())
        self.assertEqual(HEXAGON.map(np.asfortranarray(z)).tobytes(), HEXAGON.map(z).tobytes())
        self.assertEqual(HEXAGON.derivative(z).shape, (12, 5, 5))
        self.assertEqual(HEXAGON.derivative(z[0]).shape, (5, 5))
        self.assertTrue(np.array_equal(HEXAGON.map(z, steps=0), z) or np.allclose(HEXAGON.map(z, steps=0), z, atol=1e-15))
        for wrong in (z[:, :4], 1.0, np.zeros((2, 2, 5))):
            with self.assertRaisesRegex(ValueError, r"\(5\) or \(n, 5\) is wanted"):
                HEXAGON.map(wrong)
        with self.assertRaises(ValueError):
            HEXAGON.map(z, steps=-1)

    def test_endings_have_names(self):
        z = states(HEXAGON, 8)
        z[3, 2] = 3.0  # into the wall
        z[5] = np.nan
        image, outcomes = HEXAGON.map(z, outcomes=True)
        self.assertEqual([swirl.Scene.OUTCOMES[code] for code in outcomes],
                         ["completed"] * 3 + ["not-leaving", "completed", "not-leaving"] + ["completed"] * 2)
        self.assertEqual(np.isnan(image).all(axis=1).tolist(), [code != 0 for code in outcomes])
        still = swirl.Scene("disk", 0.4, 0.3, 0.4, 0.9)
        end = swirl.simulate(still, collisions=9999).to_dict()
        self.assertEqual(end["outcome"], "in-contact")
        last = [end["collisions"][-1][name] for name in COORDINATES[4]]
        self.assertEqual(still.map(last, outcomes=True)[1], "in-contact")
        self.assertTrue(np.isnan(still.derivative(last)).all())

    def test_the_derivative_is_that_of_differences(self):
        for scene in (HEXAGON, CHAOS, DISK, swirl.Scene(5, 0.45, 0.6, 0.3, 0.7, "newton")):
            z = states(scene, 40)[5:]
            exact, h, d = scene.derivative(z), 1e-6, scene.dimension
            compared = 0
            for row, derivative in zip(z, exact):
                steps = h * np.eye(d)
                ahead, behind = scene.map(row + steps), scene.map(row - steps)
                difference = ahead - behind
                difference[:, : d - 3] = (difference[:, : d - 3] + np.pi) % (2 * np.pi) - np.pi
                numeric = difference.T / (2 * h)
                # Across an edge of the map (another vertex, another contact mode) there is no difference to compare.
                second = scene.map(row + 2 * steps) - 2 * scene.map(row + steps) + scene.map(row)
                if np.isnan(numeric).any() or np.abs(second[:, d - 3:]).max() > 1e-8:
                    continue
                compared += 1
                self.assertLess(np.abs(numeric - derivative).max() / np.abs(derivative).max(), 1e-5)
            self.assertGreater(compared, 12, scene)

    def test_eight_threads_at_once_give_the_same_bits(self):
        z = states(CHAOS, 400)
        alone = CHAOS.map(np.tile(z, (30, 1)), 20).tobytes()
        modes = {seed: swirl.classify(PERIOD_8, seed=seed, transient=500, collisions=500).to_dict() for seed in range(8)}
        found, failures = {}, []

        def work(seed):
            try:
                found[seed] = (CHAOS.map(np.tile(z, (30, 1)), 20).tobytes(),
                               swirl.classify(PERIOD_8, seed=seed, transient=500, collisions=500).to_dict())
            except BaseException as failure:  # told to the thread that counts
                failures.append(failure)
        threads = [threading.Thread(target=work, args=(seed,)) for seed in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failures, [])
        self.assertEqual(found, {seed: (alone, modes[seed]) for seed in range(8)})


if __name__ == "__main__":
    unittest.main()
