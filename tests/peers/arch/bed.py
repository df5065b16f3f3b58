"""Pressure drop of a pack in the channel by hydraulic radii, slice by slice: what engineers would expect."""

import numpy as np

from .clogs import DIAMETER
from .resolved import CHANNEL, DENSITY, NECK, RATE, VISCOSITY

KOZENY = 5  # 180 = 36 times it; 150 is Ergun's
INERTIA = 1.75  # Ergun's


def sphere_share(places, radius, edges):
    """Solid volume over volume of the slices of the channel between the edges along x [m]."""
    t = np.clip((edges[:, None] - places[None, :, 0]) / radius, -1, 1)
    below = np.pi * radius**3 * (2 / 3 + t - t**3 / 3)
    fine = np.array([np.mean(CHANNEL.area(np.linspace(a, b, 50) / NECK)) for a, b in zip(edges, edges[1:])])
    return np.diff(below.sum(axis=1)) / (fine * NECK**2 * np.diff(edges))


def bed_drop(places, form):
    """Pressure drop [Pa] of the mesh's channel with spheres at places [n, 3], slices about a diameter long:

        carman  5 S^2 eta U / e^3                    S = 6 (1-e) / d, the spheres' surface per volume
        walls   the same, S with the channel's own walls: + perimeter / area
        ergun   150/180 of carman + 1.75 rho U^2 (1-e) / (e^3 d)

    U is the rate over the whole cross-section, e the porosity of the slice.
    """
    edges = np.linspace(CHANNEL.start, CHANNEL.end, 1 + round((CHANNEL.end - CHANNEL.start) * NECK / DIAMETER)) * NECK
    solid = sphere_share(places, DIAMETER / 2, edges)
    wide = 2 * CHANNEL.half_width((edges[1:] + edges[:-1]) / 2 / NECK) * NECK
    high = CHANNEL.height * NECK
    speed, porous = RATE / (wide * high), (1 - solid) ** 3
    surface = 6 * solid / DIAMETER + (2 * (wide + high) / (wide * high) if form == "walls" else 0)
    slope = KOZENY * surface**2 * VISCOSITY * speed / porous
    if form == "ergun":
        slope = slope * 150 / 180 + INERTIA * DENSITY * speed**2 * solid / (porous * DIAMETER)
    return float(np.sum(slope * np.diff(edges)))
