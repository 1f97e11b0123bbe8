"""The outline of a polygon, with the corners that it has."""

import numpy

_ARC = 12  # points of a rounded corner


def outline(scene, angle):
    """Its points from the body's centre, as complex numbers: the vertices, or rounded corners as arcs."""
    sides, radius = scene["sides"], scene.get("corner", 0)
    towards = angle + 2 * numpy.pi * numpy.arange(sides) / sides
    if not radius:
        return scene["alpha"] * numpy.exp(1j * towards)
    along = numpy.linspace(-numpy.pi / sides, numpy.pi / sides, _ARC)
    arcs = (scene["alpha"] - radius) * numpy.exp(1j * towards[:, None]) + radius * numpy.exp(1j * (towards[:, None] + along))
    return arcs.ravel()
