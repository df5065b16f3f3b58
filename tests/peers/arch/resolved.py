"""A clog as an OpenFOAM case, and the forces of the solved flow in SI units.

Lengths in neck widths D, velocities in the mean U of the wide channel, so that a force is rho U^2 D^2 times its number, and a
pressure rho U^2. Kept are the spheres that lie behind the inlet of the mesh; the first of them meet plug flow where in truth
there is a pack, so only those LAYER and more behind the inlet are compared.
"""

import math
from dataclasses import dataclass

import numpy as np

from .case import Problem, write_case
from .channel import Channel
from .clogs import DIAMETER
from .solve import solve
from .surfaces import Loads, balance, read_case, sphere_loads

NECK, SPEED, VISCOSITY, DENSITY = 100e-6, 5e-3, 1.8e-3, 1062.0  # of scenes/campaign.toml
CHANNEL = Channel(width=4, height=1, slope=math.radians(60), start=-2, end=1.5)
CLEAR = 0.05  # between the inlet and the first sphere [D]
LAYER = 0.6  # [D]
REYNOLDS = DENSITY * SPEED * NECK / VISCOSITY
PRESSURE = DENSITY * SPEED**2  # [Pa]
FORCE = PRESSURE * NECK**2  # [N]
RATE = SPEED * CHANNEL.width * CHANNEL.height * NECK**2  # [m3/s]


@dataclass(frozen=True)
class Resolved:
    loads: Loads  # in SI units
    pressure_drop: float  # [Pa] from the mesh's inlet to its outlet
    balance: float  # what spheres and walls take, over what inlet and outlet give
    told: dict  # cells, iterations, seconds


def kept(clog):
    """Rows of the clog's spheres that the mesh holds."""
    x = clog.place[:, 0] / NECK
    return np.flatnonzero((x > CHANNEL.start + CLEAR + DIAMETER / NECK / 2) & (x < CHANNEL.end - CLEAR))


def compared(clog):
    """Of those kept, the ones that are compared."""
    return clog.place[kept(clog), 0] / NECK > CHANNEL.start + LAYER


def clog_problem(places, cells, shrink, slower=1.0):
    """\\param cells  a neck width, even; \\param shrink  share of the diameter; \\param slower  than the scene's flow"""
    return Problem(low=(CHANNEL.start, -CHANNEL.width / 2, 0), high=(CHANNEL.end, CHANNEL.width / 2, CHANNEL.height),
                   cells_per_length=cells, places=places / NECK,
                   radii=np.full(len(places), (1 - shrink) * DIAMETER / NECK / 2),
                   viscosity=slower / REYNOLDS, wedges=CHANNEL.wedges())


def resolve(folder, name, places, cells, shrink=0.0, slower=1.0):
    """Of a case folder/NAME, solved unless it is."""
    problem, where = clog_problem(places, cells, shrink, slower), folder / name
    if not (where / "seconds").exists():
        write_case(problem, where)
    told = solve(where)
    case = read_case(where)
    raw = sphere_loads(case["spheres"], problem.places, problem.radii, 1 / cells) if len(places) else None
    loads = raw and Loads(raw.force * FORCE / slower, raw.torque * FORCE * NECK / slower, raw.covered,
                          raw.meshed * FORCE / slower)
    drop = (case["inlet"].mean_pressure() - case["outlet"].mean_pressure()) * PRESSURE / slower
    return Resolved(loads, drop, balance(case), told)


def sphere_share(places, radius, edges):
    """Solid volume over volume of the slices of the channel between the edges along x [m]."""
    t = np.clip((edges[:, None] - places[None, :, 0]) / radius, -1, 1)
    below = np.pi * radius**3 * (2 / 3 + t - t**3 / 3)
    fine = np.array([np.mean(CHANNEL.area(np.linspace(a, b, 50) / NECK)) for a, b in zip(edges, edges[1:])])
    return np.diff(below.sum(axis=1)) / (fine * NECK**2 * np.diff(edges))


def bed_drop(places, shrink=0.0, inertia=False):
    """Pressure drop of the mesh's channel by Carman and Kozeny, or Ergun, slice by slice (about a diameter) [Pa]:
    180 eta U (1-e)^2/(e^3 d^2), or 150 of that and 1.75 rho U^2 (1-e)/(e^3 d)."""
    d = (1 - shrink) * DIAMETER
    edges = np.linspace(CHANNEL.start, CHANNEL.end, 1 + round((CHANNEL.end - CHANNEL.start) * NECK / d)) * NECK
    solid = sphere_share(places, d / 2, edges)
    speed = RATE / (CHANNEL.area((edges[1:] + edges[:-1]) / 2 / NECK) * NECK**2)
    slope = (150 if inertia else 180) * VISCOSITY * speed * solid**2 / ((1 - solid) ** 3 * d**2)
    if inertia:
        slope += 1.75 * DENSITY * speed**2 * solid / ((1 - solid) ** 3 * d)
    return float(np.sum(slope * np.diff(edges)))
