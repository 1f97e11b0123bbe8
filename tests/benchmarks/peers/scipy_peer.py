"""SciPy: solve_ivp, DOP853, with a terminal event for each vertex, rising zeros only."""

import math

from scipy.integrate import solve_ivp

from container_frame import Impact, after_impact, arm_of, container_state, section_state

LONGEST_FLIGHT = 100.0


class ScipyPeer:
    def __init__(self, scene, tolerance, longest_step=math.inf):
        self.scene, self.tolerance, self.longest_step = scene, tolerance, longest_step
        self.events = [self._event(k) for k in range(scene.points)]

    def _event(self, vertex):
        scene = self.scene

        def gap(_, y):
            if scene.sides == 0:
                return y[0] * y[0] + y[1] * y[1] - (1 - scene.alpha)**2
            angle = y[4] + 2 * math.pi * vertex / scene.sides
            return (y[0] + scene.alpha * math.cos(angle))**2 + (y[1] + scene.alpha * math.sin(angle))**2 - 1

        gap.terminal, gap.direction = True, 1
        return gap

    def next(self, start):
        scene = self.scene
        centre, velocity, angle, spin = container_state(scene, start)

        def rate(t, y):
            return y[2], y[3], scene.beta * math.cos(t), scene.beta * math.sin(t), spin

        found = solve_ivp(rate, (0, LONGEST_FLIGHT), (centre.real, centre.imag, velocity.real, velocity.imag, angle),
                          method="DOP853", events=self.events, rtol=self.tolerance, atol=self.tolerance,
                          max_step=self.longest_step)
        if found.status != 1:
            return Impact(False)
        vertex = next(k for k, times in enumerate(found.t_events) if len(times))
        t, y = found.t_events[vertex][0], found.y_events[vertex][0]
        centre = complex(y[0], y[1])
        before = section_state(scene, t, centre, complex(y[2], y[3]), arm_of(scene, centre, y[4], vertex), spin)
        return Impact(True, t, vertex, after_impact(scene, before))
