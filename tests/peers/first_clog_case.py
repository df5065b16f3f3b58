"""The case of first_clog: one neck, one push, many packs; and what counts as its first clog.

A channel 3 D wide and D high narrows at 60 degrees from the axis to a neck D wide, D high and D long, which begins at
x = 0 and ends the domain. Each sphere is pushed by c (u - v) with the same u along x everywhere. Nothing else acts
but contacts: Hertz, Mindlin with history, Coulomb, no dashpot along the surface, no torsion.
"""

import functools
import math
from typing import NamedTuple

import numpy as np

NECK = 100e-6  # D [m]
DIAMETER = 47e-6
RADIUS = DIAMETER / 2
WIDTH, LENGTH, SLOPE = 3 * NECK, 0.7e-3, math.radians(60)
NARROWING = (WIDTH - NECK) / 2 / math.tan(SLOPE)
START = -NARROWING - LENGTH
PLANE, END = NECK / 2, NECK  # where passages count, and where particles leave [m]

# Heavier and softer than a hydrogel bead, for a step that is affordable; inertia still fades within 0.08 d/u.
DENSITY, VISCOSITY, SPEED = 1.062e4, 1.8e-3, 5e-3
E, NU = 2.5e5, 0.35
MASS = DENSITY * math.pi / 6 * DIAMETER**3
DRAG = 3 * math.pi * VISCOSITY * DIAMETER  # [N s/m]
TAU = DIAMETER / SPEED  # [s]
NORMAL = E / (2 * (1 - NU**2))  # E* [Pa]
SHEAR = E / (2 * (1 + NU)) / (2 * (2 - NU))  # G* [Pa]
RESTITUTION = 0.7  # that LIGGGHTS is asked for; the others get what gives the same dashpot

STEP = 8e-6
FRAME = 250  # steps between two looks at the pack: 0.21 tau
WAIT = 25  # frames without a passage: 5.3 tau
LAST = 400  # frames, 85 tau, then the run ends
REST = 0.01  # of SPEED, root mean square of all before the plane

ROWS, SPACING, SWEEPS = 12, 52e-6, 50  # of 10 spheres; packing fraction 0.35
PARTICLES = 10 * ROWS


@functools.cache
def pack(number):
    """Places of hard spheres before the neck: a lattice after random moves, the same for a number on every machine."""
    rng = np.random.Generator(np.random.PCG64(number))
    low = np.array([-NARROWING - ROWS * SPACING, -WIDTH / 2, 0]) + RADIUS
    high = np.array([-NARROWING, WIDTH / 2, NECK]) - RADIUS
    cell = np.array([SPACING, WIDTH / 5, NECK / 2])
    places = low - RADIUS + cell * (np.indices((ROWS, 5, 2)).reshape(3, -1).T + 0.5)
    for _ in range(SWEEPS):
        for i, step in enumerate(rng.uniform(-0.3, 0.3, (PARTICLES, 3)) * DIAMETER):
            # Rounded, so that all programs read the same numbers from their files.
            place = np.round(np.clip(places[i] + step, low, high), 12)
            apart = np.einsum("ij,ij->i", places - place, places - place)
            apart[i] = 1
            if apart.min() > DIAMETER**2:
                places[i] = place
    return places


class FirstClog(NamedTuple):
    passed: int
    clogged: bool  # else censored: all had passed, or the time was over
    ended: bool  # no more frames could change it
    frame: int  # of the last passage


def first_clog(frames):
    """frames: rows of passages until then and root mean square speed of the others [m/s], one a FRAME."""
    since, most = -1, 0  # the start is one FRAME before the first
    for k, (passed, speed) in enumerate(frames):
        if passed > most:
            since, most = k, passed
        if passed == PARTICLES:
            return FirstClog(PARTICLES, False, True, k)
        if k - since >= WAIT and speed <= REST * SPEED:
            return FirstClog(int(passed), True, True, since)
    return FirstClog(int(frames[-1][0]), False, len(frames) >= LAST, since)
