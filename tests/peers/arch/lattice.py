"""The solver against the exact drag of a simple cubic lattice of spheres.

Three unit cells in a row between mirrors, half a cell before and behind; the drag of the middle sphere is that of the
infinite lattice up to exp(-2 pi) = 0.2 %, the decay of what the plug flow at the inlet brings.
"""

import math

import numpy as np

from .case import Problem, write_case
from .solve import solve
from .surfaces import read_case, sphere_loads

# Solid fraction and K = F / (3 pi eta d U), U the superficial velocity, F the whole force on a sphere at Re = 0: Zick & Homsy,
# J. Fluid Mech. 115 (1982) 13, Table 2. In the last the spheres touch.
EXACT = {0.216: 7.442, 0.343: 15.4, 0.45: 28.1, 0.5236: 42.1}
REYNOLDS = 0.01  # of diameter and superficial velocity
ROW = 3


def lattice_problem(solid, cells, shrink):
    """Lengths in diameters of the unshrunk sphere. cells: about so many a diameter"""
    edge = (math.pi / 6 / solid) ** (1 / 3)
    across = 2 * round(cells * edge / 2)
    places = np.array([[(k + 1) * edge, 0, 0] for k in range(ROW)])
    return Problem(low=(0, -edge / 2, -edge / 2), high=((ROW + 1) * edge, edge / 2, edge / 2),
                   cells_per_length=across / edge, places=places, radii=np.full(ROW, (1 - shrink) / 2),
                   viscosity=1 / REYNOLDS, symmetric_sides=True)


def lattice_drag(folder, solid, cells, shrink=0.0):
    """{"K", "exact", "cells"}: of the middle sphere, per Stokes' drag of an unshrunk one."""
    problem = lattice_problem(solid, cells, shrink)
    where = folder / f"lattice_{solid}_{cells}_{shrink}"
    if not (where / "seconds").exists():
        write_case(problem, where)
    told = solve(where)
    loads = sphere_loads(read_case(where)["spheres"], problem.places, problem.radii, 1 / problem.cells_per_length)
    return {"K": loads.force[1, 0] / (3 * math.pi * problem.viscosity), "meshed": loads.meshed[1, 0] / (3 * math.pi * problem.viscosity),
            "exact": EXACT[solid], "covered": loads.covered[1], **told}
