"""The law with another velocity: that of a flow through a porous plug of one permeability, in the place of V0.

V0 is the flow of the empty channel: fast in the middle, slow at the walls. A pack spreads the flow: where its permeability is the
same everywhere, the velocity is that of a potential, div v = 0, v = -grad phi, the same at all heights, and slips along the walls.
Solved on squares; slopes are stairs, which matters within a square or two of them.
"""

import numpy as np

from .clogs import nearest_velocity
from .resolved import CHANNEL, NECK, SPEED

FINE = 40  # squares a neck width
UPSTREAM = -4.0  # where it is uniform [D]


def potential_flow():
    """x, y of the squares' middles [D], and velocities [nx, ny] over the mean of the wide channel; NaN in the walls."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.linalg import spsolve
    nx, ny = round((CHANNEL.end - UPSTREAM) * FINE), round(CHANNEL.width * FINE)
    x, y = UPSTREAM + (np.arange(nx) + 0.5) / FINE, -CHANNEL.width / 2 + (np.arange(ny) + 0.5) / FINE
    fluid = np.abs(y)[None] < CHANNEL.half_width(x)[:, None]
    number = np.where(fluid, np.cumsum(fluid.ravel()).reshape(nx, ny) - 1, -1)
    pairs = [(number[:-1], number[1:]), (number[:, :-1], number[:, 1:])]
    a, b = (np.concatenate([p[k][(p[0] >= 0) & (p[1] >= 0)] for p in pairs]) for k in (0, 1))
    one, count = np.ones(len(a)), fluid.sum()
    matrix = coo_matrix((np.concatenate([one, one, -one, -one]), (np.concatenate([a, b, a, b]),
                                                                  np.concatenate([a, b, b, a]))), (count, count)).tolil()
    source = np.zeros(count)
    source[number[0]] = 1 / FINE  # speed 1 through each face of the first column
    for k in number[-1][fluid[-1]]:
        matrix[k, k] += 2  # phi = 0 half a square behind the last
    phi = np.full((nx, ny), np.nan)
    phi[fluid] = spsolve(matrix.tocsr(), source)
    return x, y, *(-np.array(slopes(phi, axis)) for axis in (0, 1))


def slopes(phi, axis):
    """Central where both neighbours are fluid, else half of what the one side has: no flow through the wall."""
    ahead = np.diff(phi, axis=axis, append=np.nan * np.take(phi, [-1], axis)) * FINE
    behind = np.roll(ahead, 1, axis=axis)
    both = np.stack([np.nan_to_num(ahead), np.nan_to_num(behind)])
    return np.where(np.isnan(phi), np.nan, both.mean(axis=0))


def plug_velocity(places):
    """[n, 3] at places [m] upstream of the outlet [m/s]"""
    x, y, u, v = potential_flow()
    i = np.clip(np.floor((places[:, 0] / NECK - UPSTREAM) * FINE).astype(int), 0, len(x) - 1)
    j = np.clip(np.floor((places[:, 1] / NECK + CHANNEL.width / 2) * FINE).astype(int), 0, len(y) - 1)
    # The mean over the square and its neighbours, walls left out: a sphere is many squares wide.
    near = [(di, dj) for di in (-1, 0, 1) for dj in (-1, 0, 1)]
    pick = [[f[np.clip(i + di, 0, len(x) - 1), np.clip(j + dj, 0, len(y) - 1)] for di, dj in near] for f in (u, v)]
    mean = [np.nanmean(p, axis=0) for p in pick]
    return SPEED * np.column_stack([*mean, np.zeros(len(places))])


def plug_drag(flow, places, laws):
    """{"plug strips", "plug local"}: those laws [n, 3] with this velocity. Each is linear in V0."""
    velocity, v0 = plug_velocity(places), np.linalg.norm(nearest_velocity(flow, places), axis=1)
    return {f"plug {law}": velocity * (np.linalg.norm(laws[law], axis=1) / v0)[:, None] for law in ("strips", "local")}
