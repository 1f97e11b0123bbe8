"""Siconos: Moreau and Jean's time stepping, theta = 1/2, its own law of impact and friction.

Its event-driven part needs relations with second derivatives, which its Python cannot express; a relation in Python
derived from LagrangianScleronomousR ends in a segmentation fault (4.4.0). Each vertex has a linear relation instead,
y = C q + e, that is laid anew through the wall's tangent at the start of every step: the error is of second order in
the step, that of the method of first.
"""

import math
from itertools import islice

import numpy as np
import siconos.kernel as siconos

from container_frame import Impact, arm_of, container_state, section_state

LONGEST_FLIGHT = 100.0


class SiconosPeer:
    def __init__(self, scene, step):
        self.scene, self.step = scene, step

    def _lay_tangents(self, q):
        """C and e of y = (1 - |x|, slip) for each vertex; of the disk x = X / (1 - alpha), y in lengths."""
        scene, centre = self.scene, complex(q[0], q[1])
        for k, relation in enumerate(self.relations):
            arm = arm_of(scene, centre, q[2], k)
            x = centre + arm
            n = x / abs(x)
            lever = (arm * n.conjugate()).imag  # dx/dangle along n is -r_t, with r_t the arm along t
            rows = [[-n.real, -n.imag, lever], [-n.imag, n.real, (arm * n.conjugate()).real]]
            rows = np.array(rows[:self.rows])
            relation.C()[:, :] = rows
            relation.e()[:] = np.array([1 - abs(x), 0.0][:self.rows]) - rows @ q
        return centre

    def _prepare(self, q, v, duration):
        scene = self.scene
        self.rows = 2 if scene.mu > 0 else 1
        self.body = siconos.LagrangianDS(q, v, np.diag([1.0, 1.0, scene.inertia]))
        self.body.setFExtPtr(np.zeros(3))  # copied: what fExt() returns is the force itself
        self.force = self.body.fExt()
        law = (siconos.NewtonImpactFrictionNSL(scene.restitution, 0.0, scene.mu, 2) if scene.mu > 0
               else siconos.NewtonImpactNSL(scene.restitution))
        self.relations = [siconos.LagrangianLinearTIR(np.zeros((self.rows, 3)), np.zeros(self.rows))
                          for _ in range(scene.points)]
        self.contacts = [siconos.Interaction(law, relation) for relation in self.relations]
        self._lay_tangents(q)
        self.model = siconos.NonSmoothDynamicalSystem(0.0, duration)
        self.model.insertDynamicalSystem(self.body)
        for contact in self.contacts:
            self.model.link(contact, self.body)
        problem = siconos.FrictionContact(2) if scene.mu > 0 else siconos.LCP()
        return siconos.TimeStepping(self.model, siconos.TimeDiscretisation(0.0, self.step),
                                    siconos.MoreauJeanOSI(0.5), problem)

    def next(self, start):
        return next(self._impacts(start, LONGEST_FLIGHT), Impact(False))

    def row(self, start, count):
        """The body goes on as the impact leaves it, in place, too: what is outside is Siconos's to put right."""
        return list(islice(self._impacts(start, count * LONGEST_FLIGHT), count))

    def _impacts(self, start, duration):
        scene, before = self.scene, 0.0
        centre, velocity, angle, spin = container_state(scene, start)
        simulation = self._prepare(np.array([centre.real, centre.imag, angle]),
                                   np.array([velocity.real, velocity.imag, spin]), duration)
        while simulation.hasNextEvent() and simulation.nextTime() - before < LONGEST_FLIGHT:
            t = simulation.nextTime()
            middle = t - 0.5 * self.step
            self.force[:2] = scene.beta * math.cos(middle), scene.beta * math.sin(middle)
            self._lay_tangents(np.array(self.body.q()))
            simulation.computeOneStep()
            struck = [k for k, contact in enumerate(self.contacts) if contact.lambda_(1)[0] > 0]
            if struck:
                q, v = self.body.q(), self.body.velocity()
                centre = complex(q[0], q[1])
                arm = arm_of(scene, centre, q[2], struck[0])
                after = section_state(scene, t, centre, complex(v[0], v[1]), arm, v[2])
                yield Impact(True, t - before, struck[0], after)
                before = t
            simulation.nextStep()
