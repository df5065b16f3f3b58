"""A clog as an OpenFOAM case, and the forces of the solved flow in SI units.

Lengths in neck widths D, velocities in the mean U of the wide channel, so that a force is rho U^2 D^2 times its number, and a
pressure rho U^2. Kept are the spheres that lie behind the inlet of the mesh; the first of them meet plug flow where in truth
there is a pack, so only those LAYER and more behind the inlet are compared.
"""

import math
from dataclasses import dataclass, replace

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


@dataclass(frozen=True)
class Variant:
    cells: int  # a neck width, even
    shrink: float = 0.0  # share of the diameter
    slower: int = 1  # than the scene's flow, so many times
    start: float = CHANNEL.start  # of the mesh [D]

    @property
    def name(self):
        return f"{self.cells}_{self.shrink}_{self.slower}_{self.start}"


def kept(clog, start=CHANNEL.start):
    """Rows of the clog's spheres that the mesh holds."""
    x = clog.place[:, 0] / NECK
    return np.flatnonzero((x > start + CLEAR + DIAMETER / NECK / 2) & (x < CHANNEL.end - CLEAR))


def compared(clog):
    """Rows of those that are compared."""
    return np.flatnonzero((clog.place[:, 0] / NECK > CHANNEL.start + LAYER) & (clog.place[:, 0] / NECK < CHANNEL.end - CLEAR))


def clog_problem(places, variant):
    channel = replace(CHANNEL, start=variant.start)
    return Problem(low=(channel.start, -channel.width / 2, 0), high=(channel.end, channel.width / 2, channel.height),
                   cells_per_length=variant.cells, places=places / NECK,
                   radii=np.full(len(places), (1 - variant.shrink) * DIAMETER / NECK / 2),
                   viscosity=variant.slower / REYNOLDS, wedges=channel.wedges())


def resolve(folder, name, places, variant):
    """Of a case folder/NAME, solved unless it is."""
    problem, where, slower = clog_problem(places, variant), folder / name, variant.slower
    if not (where / "seconds").exists():
        write_case(problem, where)
    told = solve(where)
    case = read_case(where)
    raw = sphere_loads(case["spheres"], problem.places, problem.radii, 1 / variant.cells) if len(places) else None
    loads = raw and Loads(raw.force * FORCE / slower, raw.torque * FORCE * NECK / slower, raw.covered,
                          raw.meshed * FORCE / slower)
    drop = (case["inlet"].mean_pressure() - case["outlet"].mean_pressure()) * PRESSURE / slower
    return Resolved(loads, drop, balance(case), told)

